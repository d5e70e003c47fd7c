/* built from web/ by "npm run build"; sources 7876d13004eef433b7a92b21458c12ee2230bc6aa2041f2f132bbdde016f9ce1 */
"use strict";(()=>{var ke=class extends Error{};function Fe(){return Promise.reject(new ke("the engine has no body yet"))}var nn="http://www.w3.org/2000/svg";function c(e,t={},...n){return We(document.createElement(e),t,n)}function b(e,t={},...n){return We(document.createElementNS(
nn,e),t,n)}function We(e,t,n){for(let[r,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(r.slice(2),o):e.setAttribute(r,o===!0?"":
String(o)));return e.append(...n.filter(rn).map(r=>typeof r=="number"?String(r):r)),e}function rn(e){return e!=null&&e!==!1}var on=matchMedia("(prefers-color-scheme: dark)");function sn(){let e=document.documentElement.dataset.theme;return e?e==="dark":on.matches}function Re(){document.
documentElement.dataset.theme=sn()?"light":"dark"}function Ge(){return c("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Re},"◐")}function Ue(){return JSON.parse(Ve("data"))}function W(e,t,n){let[r,o]=[t-e.payoff.first[0],n-e.payoff.first[1]],a=e.payoff.capture_rate[r]?.[o];return a===void 0?
null:{rate:a,rates:e.payoff.capture_rates[r][o],lengths:e.payoff.lengths[r][o]}}function G(e,t,n){let r=e.teams[t];return r.script!==null||r.kept.includes(n)}function z(e,t,n){
let{script:r,network:o,kept:a,genomes:s}=e.teams[t];if(r!==null||o===null)return r??"random";let i=a.indexOf(n);if(i<0)throw new RangeError(`${t}: expected a ge\
neration whose genome the page holds, got ${n}`);let l=o.genome_size,d=an(s).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,sampled:o.sampled,
genome:d}}var ze=new Map;function an(e){let t=ze.get(e);if(t)return t;let n=atob(Ve(e)),r=new Uint8Array(n.length);for(let a=0;a<r.length;a++)r[a]=n.charCodeAt(
a);let o=new Float32Array(r.buffer);return ze.set(e,o),o}function Ve(e){return document.getElementById(e)?.textContent??""}var ln={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},U=[.5,1,2,4,8,16,32,64],cn=.28,_=class extends EventTarget{#e;#n;#s;#a;#r=0;#t=0;#o=!1;#c=null;#i=0;constructor(t,n={}){
super(),this.#e=t,this.#n=n.speed??4,this.#a=n.still??!1,this.#s=n.clock??ln}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get playing(){return this.#o}get length(){
return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#m("state")}get speed(){return this.#n}set speed(t){this.#n=t,this.#m("state")}changeSpeed(t){
let n=U.findIndex(r=>r>=this.#n);this.speed=U[Math.min(U.length-1,Math.max(0,n+t))]}play(){this.#o||!this.#e||(this.#r===this.#e&&this.jump(0),this.#o=!0,this.#m(
"state"),this.#u())}pause(){this.#o&&(this.#o=!1,this.#m("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#r+t));Math.abs(n-this.#t)>1?this.jump(n):this.#l(n),this.#u()}jump(t){this.#t=Math.min(this.#e,Math.max(0,Math.round(t))),this.#l(this.#t),this.#m("fram\
e")}#l(t){t!==this.#r&&(this.#r=t,this.#m("step"))}#u(){this.#c===null&&(this.#i=this.#s.now(),this.#c=this.#s.request(()=>this.#d()))}#d(){this.#c=null;let t=this.#s.
now();this.#p(Math.min(.25,(t-this.#i)/1e3)),this.#i=t,this.#m("frame"),(this.#o||this.#t!==this.#r)&&(this.#c=this.#s.request(()=>this.#d()))}#p(t){let n=t;for(;n>
0;){if(this.#t===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#l(this.#r+1)}let r=this.#o?this.#n:Math.max(this.#n,1/cn),o=this.#r-
this.#t,a=Math.min(Math.abs(o),n*r);n-=a/r,this.#t=a===Math.abs(o)?this.#r:this.#t+Math.sign(o)*a}this.#o&&this.#t===this.#e&&this.pause()}#m(t){this.dispatchEvent(
new Event(t))}};function re(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let n=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(n),ArrowLeft:()=>e.
move(-n),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var oe=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function V(e){let t=Math.min(1,Math.max(0,e))*(oe.length-1),n=Math.min(oe.length-2,Math.floor(t)),[r,o]=[oe[n],oe[n+
1]],a=s=>Math.round(r[s]+(t-n)*(o[s]-r[s]));return[a(0),a(1),a(2)]}var je=e=>`rgb(${V(e).join(" ")})`;function se(e,t,n){let r=devicePixelRatio||1;e.style.left=`${n.left}px`,e.style.top=`${n.top}px`,e.style.width=`${n.width}px`,e.style.height=`${n.height}px`,e.width=
Math.round(n.width*r),e.height=Math.round(n.height*r);let o=e.getContext("2d"),a=dn(t);!o||!a||(o.imageSmoothingEnabled=!1,o.drawImage(a,0,0,e.width,e.height))}
function dn(e){let[t,n]=e.shape,r=document.createElement("canvas");[r.width,r.height]=[n,t];let o=r.getContext("2d");if(!o)return null;let a=o.createImageData(n,
t);return e.capture_rate.forEach((s,i)=>s.forEach((l,d)=>{let m=4*((t-1-i-e.first[0])*n+d+e.first[1]);a.data.set([...V(l),255],m)})),o.putImageData(a,0,0),r}var mn=84;function Ke(e,t){let n=e.map((a,s)=>un(a,s,t)),r=c("nav",{class:"races",role:"tablist","aria-label":"Runs"},...n.map(a=>a.button)),o=()=>n.forEach((a,s)=>a.
update(s===t.selected.run));return t.on("match",o),t.on("hover",o),o(),r.hidden=e.length<2,r}function un(e,t,n){let[r,o]=e.payoff.shape,a=mn/Math.max(r,o),s=c("\
canvas",{"aria-hidden":"true"});se(s,e.payoff,{left:0,top:0,width:o*a,height:r*a});let i=c("span",{class:"place"}),l=c("button",{type:"button",role:"tab",class:"\
race",title:`Key ${t+1}`,onclick:()=>Te(e,t,n)},c("span",{class:"small-matrix"},s,i),c("span",{class:"race-text"},c("strong",{},e.name),c("span",{class:"small"},
e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${pn(e)}`),e.schedule===e.name?null:c("span",{class:"small muted"},`${e.schedule}, seed ${e.
seed}`)));return{button:l,update:m=>{l.ariaSelected=String(m);let u=n.hover.pursuer??n.selected.pursuer,f=n.hover.evader??n.selected.evader;i.hidden=u>=r||f>=o,
i.style.left=`${(f+.5)*a}px`,i.style.top=`${(r-u-.5)*a}px`}}}var pn=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function Te(e,t,n){let[r,o]=e.
payoff.shape,{pursuer:a,evader:s}=n.selected;n.select({run:t,pursuer:Math.min(a,r-1),evader:Math.min(s,o-1)})}var hn=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["1","9"],"first to ninth run"],[["D"],"light or\
 dark"],[["?"],"this list"]];function Xe(){let e=hn.map(([n,r])=>c("div",{class:"key-row"},c("dt",{},...n.map(o=>c("kbd",{},o))),c("dd",{},r))),t=c("dialog",{class:"\
help","aria-labelledby":"help-title"},c("h2",{id:"help-title"},"Keys"),c("dl",{class:"keys"},...e),c("p",{class:"muted small"},"The page holds the genomes and t\
he engine of this run. A click on a cell plays that very match: same seed, same moves. Triangles pursue, discs evade; a ring is a captured evader, a star a capt\
ure, dashed cells are conflicts. The page loads nothing from elsewhere; share the file as it is."),c("button",{type:"button",onclick:()=>t.close()},"Close"));return t.
addEventListener("click",n=>n.target===t&&t.close()),t}function qe(e,t,n,r){let o=(s,i)=>()=>{let l=e[t.selected.run].payoff.shape[s==="pursuer"?0:1];t.select({
[s]:Math.min(l-1,Math.max(0,t.selected[s]+i))})},a={n:()=>t.select({episode:t.selected.episode+1}),N:()=>t.select({episode:Math.max(0,t.selected.episode-1)}),r:()=>t.
select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>t.select({seed:null,episode:0}),p:o("pursuer",1),P:o("pursuer",-1),e:o("\
evader",1),E:o("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.inspector.next(-1),Escape:()=>n.inspector.choose(
null),d:Re,"?":()=>r.showModal()};document.addEventListener("keydown",s=>{let i=s.target instanceof HTMLSelectElement||s.target instanceof HTMLInputElement,l=s.
target instanceof HTMLButtonElement&&(s.key===" "||s.key==="Enter");if(r.open||i||l||s.defaultPrevented||s.ctrlKey||s.metaKey||s.altKey)return;let d=a[s.key]??a[s.
key.toLowerCase()],m=Number(s.key)-1;if(re(n.player,s)||d)d?.();else if(e[m])Te(e[m],m,t);else return;s.preventDefault()})}var Ce=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],A=(e,t)=>t<e.nPursuers,M=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],fn=(e,t)=>e[0]===t[0]&&
e[1]===t[1],$e=({rows:e,cols:t},[n,r])=>n>=0&&r>=0&&n<e&&r<t,Ae=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),Pe=(e,t)=>Ae(e.fault,t),Ye=(e,t)=>!Pe(
e,t)&&Ae(e.involved,t,2);function ae(e,t,n){let r=!fn(M(e,n),M(t,n)),o=t.involved===void 0||Ae(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!r&&o)}function ie(e,t,n){
let[r,o]=M(e,n),[a,s]=Ce[t.actions?.[n]??0];return[r+a,o+s]}function le(e,t,n){return Array.from({length:n.everCaptured.length},(o,a)=>a).filter(o=>n.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function ce(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var Je=[-.31,0,.31],Ze=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Je.flatMap(e=>Je.map(t=>[t,e]))}],gn=.3,bn=.35,yn=.55;function j(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,a]=M(t,r),s=o*e.cols+a,i=n.get(s);i?i.push(r):n.set(s,[r])}return n}function Qe(e,t){let n=Array.from(t.alive,(r,o)=>{let[a,s]=M(t,o);return{
x:s+.5,y:a+.5,size:1,alpha:0}});for(let r of j(e,t).values()){let o=Ze[Math.min(r.length,Ze.length)-1];r.forEach((a,s)=>{let[i,l]=o.at[Math.min(s,o.at.length-1)],
d=n[a];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return n}var et=e=>e*e*(3-2*e),N=(e,t,n)=>e+(t-e)*n,tt=e=>Math.min(1,Math.max(0,e));function nt(e,t,n,r){let o={1:2,
2:n}[e.interaction]??1;if(o===1)return et(r);let a=o===n?t:+!A(e,t),s=Math.max(1/o,bn);return et(tt((r-a/(o-1)*(1-s))/s))}function de(e,t){let n=e.moments.length-
1,r=Math.min(Math.floor(t),n),o=e.moments[r],a=Qe(e,o);if(r===n||t===r)return a;let s=e.moments[r+1],i=Qe(e,s);return a.map((l,d)=>{let m=nt(e,d,a.length,t-r);return vn(
o,s,d,l,i[d],m)})}function rt(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),[a,s]=[e.moments[o],e.moments[Math.min(o+1,r)]],i=nt(e,t,a.alive.length,
n-o),[[l,d],[m,u]]=[M(a,t),M(s,t)];return[N(d,u,i)+.5,N(l,m,i)+.5]}function vn(e,t,n,r,o,a){let s=r.alpha>o.alpha,i={x:N(r.x,o.x,a),y:N(r.y,o.y,a),size:s?r.size:
N(r.size,o.size,a),alpha:s?tt((1-a)/(1-yn)):N(r.alpha,o.alpha,a)};if(ae(e,t,n)){let[l,d]=M(e,n),[m,u]=ie(e,t,n),f=gn*Math.sin(Math.PI*a);i.x+=(u-d)*f,i.y+=(m-l)*
f}return i}var ot=2*Math.PI;function P(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,ot)}function me(e,t,n,r){let o=r/2,a=[[0,-.97],[.97,.83],[-.97,.83]].map(([s,i])=>[t+s*o,n+i*
o]);e.beginPath(),e.moveTo((a[2][0]+a[0][0])/2,(a[2][1]+a[0][1])/2),a.forEach(([s,i],l)=>{let[d,m]=a[(l+1)%3];e.arcTo(s,i,d,m,r*.09)}),e.closePath()}function st(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function at(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let a=r/
2*(o%2?.6:.95),s=ot*o/16;e.lineTo(t+a*Math.sin(s),n-a*Math.cos(s))}e.closePath()}function it(e,t,n,r,o,a){let s=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-a*Math.cos(s+i*.6),o-a*Math.sin(s+i*.6))}var lt=4,xn=1.6,wn=.95,Mn=5,Sn=.16,En=.09,kn=.2,ct=.75,C=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function O(e,t,n){return A(t,n)?e.colors.pursuer:e.colors.
evader}function dt({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:a,rows:s,cols:i}=t,[l,d]=[i*a,s*a];if(e.fillStyle=n.paper,e.fillRect(r,o,l,d),a<Mn)return;e.fillStyle=
n.line;let m=Math.max(1,Math.round(a/60));for(let u=1;u<i;u++)e.fillRect(r+u*a,o,m,d);for(let u=1;u<s;u++)e.fillRect(r,o+u*a,l,m)}function mt({ctx:e,grid:t,colors:n},r){
let{left:o,top:a,cell:s,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let m=0;m<i*l;m++){if(!r.obstacles[m])continue;let[u,f]=[Math.floor(m/l),m%l];e.fillRect(o+f*
s,a+u*s,s,s)}let d=Math.max(2,Math.round(s/18));e.strokeStyle=n.frame,e.lineWidth=d,e.strokeRect(o-d/2,a-d/2,l*s+d,i*s+d)}function ut({ctx:e,grid:t,colors:n},r){
let{left:o,top:a,cell:s,rows:i,cols:l}=t,d=s<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,s*.32)))}px system-ui, sans-serif`,e.fillStyle=n.muted,
e.textBaseline="alphabetic",e.textAlign="center";let m=5*r+s/40;for(let u=0;u<l;u+=d)e.fillText(String(u),o+(u+.5)*s,a-m);e.textAlign="right",e.textBaseline="mi\
ddle";for(let u=0;u<i;u+=d)e.fillText(String(u),o-m,a+(u+.5)*s)}function pt(e,t,n,r,o){let{ctx:a,grid:s}=e,i=Math.floor(t.fov/2)+.5,[l,d]=[Math.max(0,r-i),Math.
min(s.cols,r+i)],[m,u]=[Math.max(0,o-i),Math.min(s.rows,o+i)],f=[C(s,l),$(s,m),(d-l)*s.cell,(u-m)*s.cell],p=O(e,t,n);a.globalAlpha=.11,a.fillStyle=p,a.fillRect(
...f),a.globalAlpha=.8,a.strokeStyle=p,a.lineWidth=Math.max(1,s.cell/24),a.strokeRect(...f),a.globalAlpha=1}function ht(e,t,n,r,o){let{ctx:a,grid:s}=e,i=Math.min(
Math.ceil(n),t.moments.length-1),l=t.moments[i];a.lineCap="round",a.lineWidth=Math.max(1,s.cell*Sn);for(let d=Math.max(1,Math.ceil(n-r));d<=i;d++){let[m,u]=[t.moments[d-
1],t.moments[d]],f=Math.max(0,Math.min(1,(n-d)/r));a.globalAlpha=ct+(kn-ct)*f;for(let p=0;p<u.alive.length;p++){let g=d===i&&n<i;if(!m.alive[p]||!(l.alive[p]||g))
continue;let h=(A(t,p)?-1:1)*En,[y,x]=M(m,p),[E,v]=M(u,p);if(y===E&&x===v)continue;let w=g?o[p].x:v+.5,R=g?o[p].y:E+.5;a.strokeStyle=O(e,t,p),a.beginPath(),a.moveTo(
C(s,x+.5+h),$(s,y+.5+h)),a.lineTo(C(s,w+h),$(s,R+h)),a.stroke()}}a.globalAlpha=1}function ft(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.
max(1,r-lt+1);o<=r;o++){let[a,s]=[t.moments[o-1],t.moments[o]],i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/lt,l=le(t,a,s);for(let d of ce(a,s))l.includes(d)||Tn(e,M(s,d),
i);for(let d of l)Rn(e,M(s,d),i)}e.ctx.globalAlpha=1}function Rn({ctx:e,grid:t,colors:n},[r,o],a){e.globalAlpha=a,at(e,C(t,o+.5),$(t,r+.5),Math.max(8,t.cell*xn)),
e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}function Tn({ctx:e,grid:t,colors:n},[r,o],a){
e.globalAlpha=a,st(e,C(t,o+.5),$(t,r+.5),Math.max(7,t.cell*wn)),e.strokeStyle=n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function gt({
ctx:e,grid:t,colors:n},r,o){let a=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*
.1]);for(let[s,i]of r){if(s<0||i<0||s>=t.rows||i>=t.cols)continue;let l=[C(t,i)+a,$(t,s)+a,t.cell-2*a,t.cell-2*a];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=
o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function bt({ctx:e,grid:t,colors:n},r,o,a,s){e.globalAlpha=s,P(e,C(t,r),$(t,o),Math.max(8,t.cell*a*1.02)),
e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(a)),e.stroke(),e.globalAlpha=1}var Cn=.8,$n=.92,An=15,Pn=7,Ne=9;function yt(e,t,n,r,o,a){r.forEach((s,i)=>{s.alpha>0&&Ln(e,t,n,i,s,o,a)}),e.ctx.globalAlpha=1;for(let s of j(t,n).values())s.length>
Ne&&_n(e,r[s[Ne-1]],s.length-Ne+1)}function Ln(e,t,n,r,o,a,s){let{ctx:i,grid:l,colors:d}=e,m=A(t,r),[u,f]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(m?$n:Cn)),g=O(e,t,r),h=!m&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(m?me:P)(i,u,f,p),p>Pn*s&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(2,
p*.1),i.stroke()),i.fillStyle=h?d.paper:g,i.fill(),h&&(P(i,u,f,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!a||p<An*s)return;let y=String(m?r:r-t.nPursuers);
i.font=`700 ${Math.round(p*(m?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:d.paper,i.fillText(
y,u,f+p*(m?.17:.03))}function _n({ctx:e,grid:t,colors:n},r,o){let[a,s]=[t.left+r.x*t.cell,t.top+r.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=n.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,a,s),e.fillStyle=n.ink,e.fillText(`+${o}`,
a,s)}var Nn=.46,On=.86,In=.6,vt=.4,Hn=.74,Bn=.58;function xt(e,t,n,r){let[o,a]=[t.moments[n-1],t.moments[n]];if(!o)return;let{ctx:s,grid:i,colors:l}=e;s.strokeStyle=
l.collision,s.lineWidth=Math.max(1.5,i.cell*.07),s.lineCap="butt",s.globalAlpha=r;for(let d=0;d<a.alive.length;d++)ae(o,a,d)&&Dn(e,t,M(o,d),ie(o,a,d));s.globalAlpha=
1}function Dn({ctx:e,grid:t},n,r,o){let[a,s]=[o[1]-r[1],o[0]-r[0]],i=u=>C(t,r[1]+.5+a*u),l=u=>$(t,r[0]+.5+s*u),d=$e(n,o)?Hn:Bn;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(vt),l(vt)),e.lineTo(i(d),l(d)),e.stroke(),e.setLineDash([]);let m=.17*t.cell/Math.hypot(a,s);e.beginPath(),e.moveTo(i(d)-s*m,l(d)+
a*m),e.lineTo(i(d)+s*m,l(d)-a*m),e.stroke()}function wt(e,t,n,r,o,a){let s=Ce[a];if(!a||!s)return;let{ctx:i,grid:l,colors:d}=e,m=$e(t,[r[0]+s[0],r[1]+s[1]])?On:
In,u=Nn*o.size,f=[C(l,o.x+s[1]*u),$(l,o.y+s[0]*u),C(l,o.x+s[1]*m),$(l,o.y+s[0]*m)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[d.paper,
p*2.1],[O(e,t,n),p]])i.strokeStyle=g,i.lineWidth=h,it(i,...f,l.cell*.2),i.stroke()}var St={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Et(e,t,n,r,o){let{ctx:a,grid:s,colors:i}=e,l=Math.min(Math.ceil(n),t.
moments.length-1),d=t.moments[l],m=n===l,u=de(t,n),f=m?1:Math.max(0,1-2*(l-n));a.clearRect(0,0,a.canvas.width,a.canvas.height),dt(e);for(let h of r.viewers)u[h]?.
alpha&&pt(e,t,h,...rt(t,h,n));mt(e,t),r.axes&&ut(e,o),ht(e,t,n,r.trail,u),gt(e,d.contested??[],f),ft(e,t,n),xt(e,t,l,f);let p=m?d:t.moments[Math.max(0,l-1)];if(yt(
e,t,p,u,r.numbers,o),u.forEach(({x:h,y,size:x},E)=>{let v=Ye(d,E)?.4:0,w=Pe(d,E)?1:v;w&&bt(e,h,y,x,w*f)}),m&&r.plan)for(let[h,y]of u.entries())y.alpha&&wt(e,t,h,
M(d,h),y,r.plan[h]??0);a.lineWidth=Math.max(2,2.5*o),a.strokeStyle=i.focus;let g=r.selected===null?void 0:u[r.selected];g?.alpha&&Mt(e,Math.floor(g.y),Math.floor(
g.x),.02),r.cursor&&(a.setLineDash([s.cell*.12,s.cell*.08]),Mt(e,r.cursor[0],r.cursor[1],.1),a.setLineDash([]))}function Mt({ctx:e,grid:t},n,r,o){let[a,s]=[t.left+
(r+o)*t.cell,t.top+(n+o)*t.cell],i=t.cell*(1-2*o);e.beginPath(),e.roundRect(a,s,i,i,t.cell*.1),e.stroke()}function kt(e,t,n){let r=.24+(n?.62:0);return(t+r)/(e+r)}function Rt(e,t,n,r,o,a){let s=n?30*a:0,i=(m,u)=>Math.max((m-s)/(u+2*.12),m/(u+2*.12+(n?.62:0))),l=Math.
max(1,Math.floor(Math.min(i(r,t),i(o,e)))),d=n?Math.min(.62*l,s):0;return{rows:e,cols:t,cell:l,left:Math.round((r-t*l+d)/2),top:Math.round((o-e*l+d)/2)}}function Tt(e,t,n){
let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var Fn={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function ue(e){let t=getComputedStyle(e),n=Object.entries(Fn).map(([r,o])=>[r,t.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var H=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,I=class{canvas;#e=null;#n=0;#s;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#o;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#s={...St,...n},this.#t=new ResizeObserver(()=>this.#i()),this.#t.observe(t),this.#o=new MutationObserver(
()=>this.redraw()),this.#o.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#o.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#s}set look(t){this.#s={...this.#s,...t},this.#c(),this.redraw()}get time(){return this.#n}show(t,n){this.#e=t,this.#n=Math.min(Math.max(0,n),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#a=Rt(n,r,this.#s.axes,this.canvas.width,this.canvas.height,
o);let a={ctx:t,grid:this.#a,colors:ue(this.canvas)};Et(a,this.#e,this.#n,this.#s,o)}cellAt(t,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.
width;return Tt(this.#a,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],a=j(
this.#e,o).get(r[0]*this.#e.cols+r[1])??[],s=de(this.#e,Math.round(this.#n)),i=l=>{let[d,m]=this.pointOf(s[l].x,s[l].y);return Math.hypot(d-t,m-n)};return a.length?
a.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:a,top:s,cell:i}=this.#a;return[r.left+
(a+t*i)*o,r.top+(s+n*i)*o]}#c(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(kt(t,n,this.#s.axes)))}#i(){
let t=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*t)),this.canvas.height=Math.max(1,Math.
round(r*t)),this.drawNow()}};var Gn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function zn(e,t,n){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:Gn[e.rules.interaction],
obstacles:t,moments:n}}function pe(e){let t=Array.from({length:e.length+1},(n,r)=>Un(e,r));return zn(e.config,e.map,t)}function Un(e,t){let n=e.n_agents,r=e.config.n_evaders,o=(s,i,l)=>s.
subarray(i*l,(i+1)*l),a={positions:o(e.last_positions,t,2*n),alive:o(e.alive,t,n),captured:o(e.captured,t,r),everCaptured:o(e.ever_captured,t,r)};return t===0?a:
{...a,actions:o(e.actions,t-1,n),involved:o(e.involved,t-1,3*n),fault:o(e.fault,t-1,3*n),get contested(){return e.conflicts(t).map(s=>s.cell)}}}var Vn={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Ct(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let n=document.createElementNS("http://www.w3.org/2000/svg","path");return n.setAttribute("d",Vn[e]),t.append(n),t}function K(e,t,n,r){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Ct(e)),o.ariaLabel=t,o.title=`${t} (${n})`,o.addEventListener(
"click",r),o}function he(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let n=K("play","Play","Space",()=>e.toggle()),
r=jn(e),o=Kn(e),a=document.createElement("output");a.className="player-count",t.append(K("first","First step","Home",()=>e.move(-e.length)),K("back","Step back",
"←",()=>e.move(-1)),n,K("forward","Step forward","→",()=>e.move(1)),K("last","Last step","End",()=>e.move(e.length)),r,a,o);let s=()=>{n.replaceChildren(Ct(
e.playing?"pause":"play")),n.ariaLabel=e.playing?"Pause":"Play",n.title=`${n.ariaLabel} (Space)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=`\
step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,o.value=String(e.speed)};return e.addEventListener(
"step",s),e.addEventListener("state",s),t.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==r)&&re(e,i)&&i.preventDefault()}),
s(),t}function jn(e){let t=document.createElement("input");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener(
"input",()=>{e.pause(),e.jump(Number(t.value))}),t}function Kn(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.
title="Steps a second (+ and -)",t.append(...U.map(n=>new Option(`${n} / s`,String(n)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),t}var S=(e,t=2)=>e==null?"-":e.toFixed(t),Oe=(e,t=1)=>e==null?"-":`${(100*e).toFixed(t)} %`;function fe(e,t,n,r=2){return t===null||n===null?e.toFixed(r):`${e.toFixed(
r)} (${t.toFixed(r)} to ${n.toFixed(r)})`}var $t=e=>e.toLocaleString("en-GB");function X(e,t,n,r=!1){let o=(t-e)/Math.max(1,n),a=10**Math.floor(Math.log10(o||1)),
s=[1,2,5,10].map(d=>d*a).find(d=>d>=o)??10*a;r&&(s=Math.max(1,Math.round(s)));let i=Math.ceil(e/s-1e-9),l=Math.floor(t/s+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(d,m)=>(i+m)*s)}function B(e,t,{pursuer:n,evader:r,episode:o,seed:a}){let s=t.seeds[n][r];return e.match(t.world,z(t,"pursuer",n),z(t,"evader",r),BigInt(a??s),o)}var At=40,q=new Map,Y=({run:e,pursuer:t,evader:n},r)=>`${e} ${t} ${n} ${r}`,ge=class{element;#e;#n;#s=c("div",{class:"episodes",role:"group","aria-label":"Episo\
des of this cell"});#a=c("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(t,n){[this.#e,this.#n]=[t,n],this.element=c("div",{class:"stri\
p-of-episodes"},this.#s,this.#a)}show(t,n,r){let{selected:o}=this.#e;o.seed===null&&q.set(Y(o,o.episode),Pt(r)),this.#o(n),qn(this.#r),this.#t(t,n)}#t(t,n){let{
selected:r}=this.#e,a=W(n,r.pursuer,r.evader)?.rates.findIndex((s,i)=>!q.has(Y(r,i)))??-1;a<0||a>=At||(this.#r=Xn(()=>{this.#n.playing||(q.set(Y(r,a),Pt(B(t,n,{
...r,episode:a,seed:null}))),this.#o(n)),this.#t(t,n)}))}#o(t){let{selected:n}=this.#e,r=W(t,n.pursuer,n.evader);if(!r){this.#s.replaceChildren(),this.#a.textContent=
"The evaluation played no episodes of this pair.";return}let o=Math.min(At,r.rates.length);this.#s.replaceChildren(...r.rates.slice(0,o).map((d,m)=>this.#c(d,m)));
let a=r.rates.slice(0,o).map((d,m)=>q.get(Y(n,m))),s=a.filter(d=>d!==void 0),i=a.flatMap((d,m)=>d&&(Math.abs(d.rate-r.rates[m])>1e-6||d.length!==r.lengths[m])?[
m+1]:[]),l=s.reduce((d,m)=>d+m.rate,0)/s.length;this.#a.dataset.equal=String(!i.length&&s.length===r.rates.length),this.#a.textContent=i.length?`Episode ${i.join(
", ")} differs from the evaluation.`:s.length<r.rates.length?`Played here: ${s.length} of ${r.rates.length} episodes, all as in the evaluation.`:`Played here: a\
ll ${s.length} episodes, mean capture rate ${S(l,3)}. The cell says ${S(r.rate,3)}.`}#c(t,n){let{selected:r}=this.#e,o=c("span",{class:"bar"});return o.style.height=
`${Math.round(100*t)}%`,c("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${S(t)}`,"aria-label":`Episode ${n+1}, capture rate ${S(t)}`,
"aria-pressed":String(n===r.episode&&r.seed===null),"data-played":q.has(Y(r,n)),onclick:()=>this.#e.select({episode:n,seed:null})},o,c("span",{class:"count"},n+
1))}},Pt=e=>({rate:e.statistics.capture_rate,length:e.length}),Xn=e=>"requestIdleCallback"in window?requestIdleCallback(e,{timeout:1e3}):setTimeout(e,100),qn=e=>"\
cancelIdleCallback"in window?cancelIdleCallback(e):clearTimeout(e);var J=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,Ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Lt=0,_t=1,Yn=2,Jn=176;function Ot(e,t,n,r){let o=devicePixelRatio||1,a=ue(e);e.width=e.height=Jn*o;let s=e.getContext("2d");if(!s)return;let{fov:i}=t,l=e.width/
i;s.fillStyle=a.paper,s.fillRect(0,0,e.width,e.height);for(let m=0;n&&m<i*i;m++){let[u,f]=[(m%i+.5)*l,(Math.floor(m/i)+.5)*l],p=h=>!!n[h*i*i+m];p(Yn)&&(s.fillStyle=
a.obstacle,s.fillRect(u-l/2,f-l/2,l,l));let g=p(Lt)&&p(_t)?l*.18:0;p(Lt)&&Nt(s,P,u+g,f+g,l*.74,a.evader),p(_t)&&Nt(s,me,u-g,f-g,l*.86,a.pursuer)}s.strokeStyle=r<
t.n_pursuers?a.pursuer:a.evader,s.lineWidth=2*o;let d=Math.floor(i/2)*l;s.strokeRect(d,d,l,l)}function Nt(e,t,n,r,o,a){t(e,n,r,o),e.fillStyle=a,e.fill()}var be=class{element;#e;#n=c("canvas",{class:"seen",role:"img"});#s=c("h3");#a=c("p",{class:"small muted"});#r=c("div",{class:"answers"});#t=null;#o=null;#c=null;#i=null;#l=null;#u=0;constructor(t){
this.#e=t,this.element=c("div",{class:"inspector","data-open":"false"},c("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),c("div",{class:"inspected"},this.#n,c("div",{class:"answer"},this.#s,this.#r,this.#a)))}get agent(){return this.#l}show(t,n,r,o){(this.#o!==n||
!this.#t)&&(this.#t?.free(),this.#t=t.world(n.world),this.#l!==null&&this.#o!==n&&this.choose(null)),[this.#o,this.#c,this.#i]=[n,r,o]}choose(t){this.#l=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#u)}next(t){let n=this.#c;if(!n)return;let r=this.#l??(t>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+t+n.n_agents)%n.n_agents,n.alive[this.#u*n.n_agents+r])return this.choose(r)}at(t){this.#u=t;let[n,r,o,a,s]=[this.#c,this.#t,this.#o,this.#i,this.#l];if(!n||
!r||!o||!a||s===null)return;let i=s<n.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(c("span",{class:i},J(s,n.config.n_pursuers)));let l=!!n.alive[t*
n.n_agents+s];n.seek(r,t),Ot(this.#n,n.config,l?r.view(s):null,s),this.#n.ariaLabel=`Field of view of ${J(s,n.config.n_pursuers)}: evaders, pursuers and obstacl\
es around it`;let d=t<n.length?n.actions[t*n.n_agents+s]:null;if(!l)return this.#d([],"It is gone.");let m=z(o,i,a[i]);if(typeof m=="string")return this.#d([],`\
The script "${m}" plays for it${d===null?"":`; it goes ${Ie[d]}`}.`);let{probabilities:u}=r.answer(m,s),f=Array.from(u,(g,h)=>Zn(Ie[h],g,h===d)),p=m.sampled?"Th\
e action is drawn from these probabilities.":"The most probable action is taken.";this.#d(f,d===null?"The episode is over.":p)}#d(t,n){this.#r.replaceChildren(...t),
this.#a.textContent=n}};function Zn(e,t,n){let r=c("span",{class:"filled"});return r.style.width=`${100*t}%`,c("div",{class:n?"action taken":"action"},c("span",
{},e),c("span",{class:"track"},r),c("span",{class:"numbers"},t.toFixed(2)))}function It(e,t,n){if(n===0)return[{kind:"start",text:Qn(e),agents:[]}];let[r,o]=[t.moments[n-1],t.moments[n]],a=m=>J(m,e.config.n_pursuers),s=le(t,r,o),i=e.conflicts(
n),l=new Set(i.flatMap(m=>m.doomed)),d=s.map(m=>({kind:"capture",text:`${a(m)} is captured`,agents:[m]}));for(let m of ce(r,o))!s.includes(m)&&!l.has(m)&&d.push(
{kind:"end",text:`${a(m)} disappears`,agents:[m]});return d.push(...i.map(({kind:m,text:u,agents:f})=>({kind:m,text:u,agents:f}))),n===e.length&&d.unshift({kind:"\
end",text:er(e),agents:[]}),d}function Qn({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function er(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var tr=60,ye=class{element;player=new _(0,{speed:8,still:H()});inspector;#e;#n;#s;#a;#r=c("h2",{class:"match-title"});#t=c("p",{class:"tally numbers"});#o=c("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=c("p",{class:"problem",role:"alert"});#i=null;#l=null;#u=null;#d=0;#p=!1;constructor(t,n){
[this.#n,this.#s]=[t,n];let r=c("canvas",{"aria-label":"The match"});this.#e=new I(r,{numbers:!1}),this.#a=new ge(n,this.player),this.inspector=new be(o=>this.#x(
o)),r.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.element=c("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},c("div",{class:"match"},c("header",{class:"match-head"},this.#r,this.#t),c("div",{class:"stage"},r),he(this.player),this.#a.element,this.#c,c(
"div",{class:"aside"},this.#o,this.inspector.element))),this.player.addEventListener("frame",()=>this.#u&&this.#e.show(this.#u,this.player.time)),this.player.addEventListener(
"step",()=>this.#y()),n.on("match",()=>this.#b())}get#m(){return this.#n[this.#s.selected.run]}get match(){return this.#l}start(t){this.#i=t,this.#f()}playSoon(){
this.#p=!0,this.#d||this.#h()}#h(){!this.#p||!this.#l||(this.#p=!1,this.player.jump(0),H()||this.player.play())}#b(){this.#g(),clearTimeout(this.#d),this.#d=setTimeout(
()=>this.#f(),tr)}#f(){clearTimeout(this.#d),this.#d=0,this.player.pause(),this.#g();let{selected:t}=this.#s,n=["pursuer","evader"].find(r=>!G(this.#m,r,t[r]));
this.#c.textContent=n?`The page holds no genome of ${n}s ${t[n]}: it would be too large. Choose a generation of ${this.#m.teams[n].kept.join(", ")}.`:"",!(n||!this.#i)&&
(this.#l=B(this.#i,this.#m,t),this.#u=pe(this.#l),this.#a.show(this.#i,this.#m,this.#l),this.inspector.show(this.#i,this.#m,this.#l,t),this.player.length=this.#l.
length,this.player.jump(0),this.#y(),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader} ${t.episode} ${t.seed??""}`,this.#h())}#g(){let{pursuer:t,evader:n,
episode:r,seed:o}=this.#s.selected,{teams:a,payoff:s}=this.#m,i=(d,m)=>a[d].script??`${d}s ${m}`,l=o===null?r<s.episodes?`episode ${r+1} of ${s.episodes}`:`epis\
ode ${r+1}, not part of the cell`:`seed ${o}`;this.#r.replaceChildren(c("span",{class:"pursuer"},i("pursuer",t))," against ",c("span",{class:"evader"},i("evader",
n)),c("span",{class:"muted small"},l))}#y(){let t=this.#l;if(!t||!this.#u)return;let n=this.player.step,r=this.#u.moments[n],o=t.config.n_evaders,a=Array.from(r.
everCaptured).filter(Boolean).length;this.#t.replaceChildren(c("strong",{},a),` of ${o} captured`,c("span",{class:"muted"},` · step ${n}`)),this.#o.replaceChildren(
...It(t,this.#u,n).map(s=>c("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(n),this.#v()}#x(t){this.#e.look={selected:t,viewers:t===
null?[]:[t]},this.#v()}#v(){let t=this.inspector.agent;for(let n of this.#o.children){let r=n.dataset.agents?.split(" ")??[];n.classList.toggle("about",t!==null&&
r.includes(String(t)))}}};var T={left:52,bottom:46,top:76,right:84},D=10,nr=160,ve=class{element;#e;#n;#s=c("canvas",{"aria-hidden":"true"});#a=b("svg",{"aria-hidden":"true"});#r=b("g");#t;#o=c(
"p",{class:"readout numbers","aria-live":"polite"});#c=null;constructor(t,n){[this.#n,this.#e]=[t,n],this.#t=c("div",{class:"matrix",id:"matrix",tabindex:0,role:"\
application","aria-label":"Payoff matrix. Arrow keys choose a match, Enter plays it."},this.#s,this.#a),this.element=c("section",{class:"card matrix-card","aria\
-label":"Payoff matrix"},this.#o,this.#t),new ResizeObserver(()=>this.#l()).observe(this.#t),this.#t.addEventListener("pointermove",r=>this.#b(r)),this.#t.addEventListener(
"pointerleave",()=>n.point({})),this.#t.addEventListener("click",r=>this.#f(r)),this.#t.addEventListener("keydown",r=>this.#g(r)),n.on("run",()=>this.#l()),n.on(
"match",()=>this.#d()),n.on("hover",()=>this.#d())}get#i(){return this.#n[this.#e.selected.run]}#l(){let[t,n]=this.#i.payoff.shape,{clientWidth:r,clientHeight:o}=this.#t;
if(r<50)return;let s=Math.max(nr,Math.min(r-T.left-T.right,o-T.top-T.bottom))/Math.max(t,n),i=Math.max(T.left,(r-n*s-T.right+T.left)/2),l={width:r,height:o,left:i,
top:T.top,cell:s,rows:t,columns:n};this.#c=l,se(this.#s,this.#i.payoff,{left:i,top:T.top,width:n*s,height:t*s}),this.#a.setAttribute("viewBox",`0 0 ${r} ${o}`),
this.#a.replaceChildren(rr(l),or(l),...this.#u(l),this.#r),this.#d()}#u(t){let n=this.#i.findings?.generalization;if(!n)return[];let{left:r,top:o,cell:a,rows:s,
columns:i}=t,[l,d]=[r+i*a+D,o-D],[m,u]=[T.right-D-14,T.top-D-14],f=y=>(y+.5)*a,p=(y,x)=>`${(l+y*m).toFixed(1)} ${(o+s*a-f(x)).toFixed(1)}`,g=(y,x)=>`${(r+f(x)).
toFixed(1)} ${(d-y*u).toFixed(1)}`,h={class:"side"};return[b("rect",{...h,x:l,y:o,width:m,height:s*a}),b("rect",{...h,x:r,y:d-u,width:i*a,height:u}),...Bt(n.pursuers,
p,"of-pursuers"),...Bt(n.evaders,g,"of-evaders"),b("text",{class:"tick",x:l,y:o+s*a+16,"text-anchor":"start"},"0"),b("text",{class:"tick",x:l+m,y:o+s*a+16,"text\
-anchor":"end"},"1"),b("text",{class:"tick",x:r-6,y:d-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:r-6,y:d-u+8,"text-anchor":"end"},"1"),b("text",{class:"\
label of-pursuers",x:l+m,y:o+s*a+34,"text-anchor":"end"},"captures"),b("text",{class:"label of-evaders",x:r+i*a+D,y:d-u+10,"text-anchor":"start"},"escapes")]}#d(){
let t=this.#c;if(!t)return;let{selected:n,hover:r}=this.#e,{left:o,top:a,cell:s,rows:i,columns:l}=t,d=g=>a+(i-1-g)*s,m=[],u=(g,h)=>b("rect",{class:h,x:o,y:d(g),
width:l*s+D+T.right-24,height:s}),f=(g,h)=>b("rect",{class:h,x:o+g*s,y:14,width:s,height:a-14+i*s});if(m.push(u(n.pursuer,"strip pursuer"),f(n.evader,"strip eva\
der")),r.pursuer!==null&&r.pursuer<i&&m.push(u(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&m.push(f(r.evader,"strip hover")),r.lag!==null)for(let g=0;g<
l;g++){let h=g+r.lag;h>=0&&h<i&&m.push(b("rect",{class:"lagged",x:o+g*s,y:d(h),width:s,height:s}))}let p={x:o+n.evader*s,y:d(n.pursuer),width:s,height:s};m.push(
b("rect",{class:"chosen under",...p}),b("rect",{class:"chosen",...p})),this.#r.replaceChildren(...m),this.#p()}#p(){let{selected:t,hover:n}=this.#e,r=n.pursuer??
t.pursuer,o=n.evader??t.evader,a=W(this.#i,r,o);this.#o.replaceChildren(c("span",{class:"pursuer"},`Pursuers ${r}`)," against ",c("span",{class:"evader"},`evade\
rs ${o}`),": ",...a?[c("strong",{},`capture rate ${S(a.rate,3)}`),c("span",{class:"muted"},`, mean of ${a.rates.length} episodes`)]:[c("span",{class:"muted"},"n\
o episodes were played in the evaluation")],c("span",{class:"muted wide"},this.#m(r,o)))}#m(t,n){let r=this.#i.findings?.generalization;if(!r)return"";let o=(a,s)=>fe(
a.mean[s]??0,a.low?.[s]??null,a.high?.[s]??null);return`Against all opponents: captures ${o(r.pursuers,t)}, escapes ${o(r.evaders,n)}`}#h(t){let n=this.#c;if(!n)
return null;let r=this.#t.getBoundingClientRect(),o=Math.floor((t.clientX-r.left-n.left)/n.cell),a=n.rows-1-Math.floor((t.clientY-r.top-n.top)/n.cell),[s,i]=[a>=
0&&a<n.rows,o>=0&&o<n.columns];return s||i?{g:s?a:-1,h:i?o:-1,inside:s&&i}:null}#b(t){let n=this.#h(t);this.#e.point(n?{pursuer:n.g<0?null:n.g,evader:n.h<0?null:
n.h}:{})}#f(t){let n=this.#h(t);n&&(this.#e.select({...n.g<0?{}:{pursuer:n.g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#t.dispatchEvent(new CustomEvent("play",
{bubbles:!0})))}#g(t){let r={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]}[t.key];if(t.key==="Enter")this.#t.dispatchEvent(new CustomEvent("\
play",{bubbles:!0}));else if(r){let o=t.shiftKey?5:1,[a,s]=this.#i.payoff.shape,{pursuer:i,evader:l}=this.#e.selected;this.#e.select({pursuer:Ht(i+o*r[0],a),evader:Ht(
l+o*r[1],s)})}else return;t.preventDefault(),t.stopPropagation()}},Ht=(e,t)=>Math.min(t-1,Math.max(0,e));function rr({left:e,top:t,cell:n,rows:r,columns:o}){let a=b(
"g",{class:"axes"}),s=t+r*n,i=l=>X(0,l-1,Math.min(l,l*n/44),!0);for(let l of i(o))a.append(b("text",{class:"tick",x:e+(l+.5)*n,y:s+16,"text-anchor":"middle"},l));
for(let l of i(r))a.append(b("text",{class:"tick",x:e-7,y:s-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));return a.append(b("text",{class:"labe\
l of-evaders",x:e+o*n/2,y:s+36,"text-anchor":"middle"},"evader generation"),b("text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+r*n/2}) rotate(\
-90)`,"text-anchor":"middle"},"pursuer generation")),a}function or({left:e,top:t,cell:n,rows:r,columns:o}){let a=b("g",{class:"diagonal"}),s=Math.min(r,o);if(s<
3)return a;let i=t+r*n;for(let l of["H","V"]){let d=`M${e} ${i}`;for(let m=1;m<=s;m++){let[u,f]=[`H${e+m*n}`,`V${i-m*n}`];d+=l==="H"?u+f:f+u}a.append(b("path",{
d,class:"under"}),b("path",{d}))}return a}function Bt(e,t,n){let r=a=>a.map((s,i)=>t(s??0,i)),o=[];return e.low&&e.high&&o.push(b("path",{class:`band ${n}`,d:`M${[
...r(e.high),...r(e.low).reverse()].join("L")}Z`})),o.push(b("path",{class:`line ${n}`,d:`M${r(e.mean).join("L")}`})),o}function Dt(e,t,n){let{findings:r}=e;if(!r)return null;let o=c("dialog",{class:"four","aria-label":"Four matches"}),a=i=>{let l=n();l&&ar(o,e,i,t,l)},s=r.checkerboards.
map(i=>sr(e,i,a));return{element:k("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",s.length?c("div",{class:"boards"},...s):c("p",{},`No four cells differ by more than ${r.margin} in this way.`),s.length?c("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var Ft=({
pursuers:[e,t],evaders:[n,r]})=>[[e,n],[e,r],[t,n],[t,r]];function sr(e,t,n){let[r,o]=t.pursuers,[a,s]=t.evaders,i=Ft(t).map(([l,d])=>{let m=e.payoff.capture_rate[l][d],
u=c("span",{class:m>.55?"cell light":"cell"},S(m));return u.style.backgroundColor=je(m),u});return c("button",{type:"button",class:"miniature numbers",onclick:()=>n(
t),"aria-label":`Pursuers ${r} and ${o}, evaders ${a} and ${s}: four matches`},c("span",{}),c("span",{class:"evader"},a),c("span",{class:"evader"},s),c("span",{
class:"pursuer"},r),i[0],i[1],c("span",{class:"pursuer"},o),i[2],i[3])}function ar(e,t,n,r,o){let a=Ft(n).filter(([u,f])=>G(t,"pursuer",u)&&G(t,"evader",f)),s=a.
map(([u,f])=>B(o,t,{run:r.selected.run,pursuer:u,evader:f,episode:0,seed:null})),i=new _(Math.max(0,...s.map(u=>u.length)),{speed:16,still:H()}),l=s.map((u,f)=>{
let[p,g]=a[f],h=c("canvas",{"aria-label":`Pursuers ${p} against evaders ${g}`}),y=c("span",{class:"numbers"}),x=()=>{e.close(),r.select({pursuer:p,evader:g})};return{
element:c("figure",{},c("figcaption",{},c("span",{},c("span",{class:"pursuer"},p)," against ",c("span",{class:"evader"},g),c("span",{class:"muted small"},` cell\
 ${S(t.payoff.capture_rate[p][g])}`)),y,c("button",{type:"button",class:"small",title:"Show this match alone",onclick:x},"open")),h),match:u,recording:pe(u),board:new I(
h,{numbers:!1}),tally:y}}),d=()=>l.forEach(u=>u.board.show(u.recording,i.time)),m=()=>l.forEach(({recording:u,match:f,tally:p})=>{let g=u.moments[Math.min(i.step,
f.length)];p.textContent=`${Array.from(g.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",d),i.addEventListener("ste\
p",m),e.replaceChildren(c("header",{},c("h2",{},"Four matches of a checkerboard"),c("button",{type:"button",onclick:()=>e.close()},"Close")),c("div",{class:"gri\
d-of-four"},...l.map(u=>u.element)),he(i)),e.addEventListener("close",()=>{i.pause(),l.forEach(u=>u.board.close()),e.replaceChildren()},{once:!0}),e.showModal(),
d(),m(),H()||i.play()}var xe={pursuer:"evader",evader:"pursuer"};function Wt(e,t){let n=e.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:a,stripes:s,period:i}=n[`${o}\
s`],l=`fading ${S(a)}, stripes ${S(s)}${i===null?"":` every ${i} generations`}`;return ir(e,o,l,t)});return{element:k("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes that come back: cycling. Darker away from the diagonal: forgetting.",c("div",{class:"triangles"},...r.map(o=>o.element))),
update:()=>r.forEach(o=>o.update())}}function ir(e,t,n,r){let o=t==="pursuer"?0:1,[a,s]=[e.payoff.shape[o],e.payoff.shape[1-o]],i=(v,w)=>t==="pursuer"?e.payoff.
capture_rate[v][w]:1-e.payoff.capture_rate[w][v],l=c("canvas",{width:s,height:a,role:"img","aria-label":`CIAO of the ${t}s: ${n}`}),d=l.getContext("2d"),m=d?.createImageData(
s,a);for(let v=0;m&&v<a;v++)for(let w=0;w<=Math.min(v,s-1);w++)m.data.set([...V(i(v,w)),255],4*((a-1-v)*s+w));m&&d?.putImageData(m,0,0);let u=b("rect",{class:"c\
hosen",width:1,height:1}),f=b("rect",{class:"chosen under",width:1,height:1}),p=b("svg",{viewBox:`0 0 ${s} ${a}`,preserveAspectRatio:"none","aria-hidden":"true"},
f,u),g=c("div",{class:"triangle"},l,p);g.style.aspectRatio=`${s} / ${a}`;let h=v=>{let w=g.getBoundingClientRect(),R=Math.floor((v.clientX-w.left)/w.width*s),L=a-
1-Math.floor((v.clientY-w.top)/w.height*a);return R>=0&&L<a&&R<=L?[L,R]:null},y=v=>({[t]:v[0],[xe[t]]:v[1]});g.addEventListener("pointermove",v=>r.point(h(v)?y(
h(v)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",v=>h(v)&&r.select(y(h(v))));let x=()=>{let v=r.hover[t]??r.selected[t],
w=r.hover[xe[t]]??r.selected[xe[t]];for(let R of[u,f])R.setAttribute("x",String(w)),R.setAttribute("y",String(a-1-v)),R.style.display=w<=v?"":"none"};return{element:c(
"figure",{},c("figcaption",{class:"small"},c("span",{class:t},`${t}s`)),g,c("p",{class:"small muted"},`horizontal: ${xe[t]} generation; vertical: ${t} generatio\
n`),c("p",{class:"small numbers"},n)),update:x}}var we={left:46,right:12,top:10,bottom:42},Gt={x:56,y:34};function Me(e,t,n,r){let[o,a]=[we.left,we.top],s=Math.max(o+40,e-we.right),i=Math.max(a+40,t-we.bottom),
l=(h,y,x)=>E=>y+(E-h.low)/(h.high-h.low||1)*(x-y),[d,m]=[l(n,o,s),l(r,i,a)],u=b("g"),f=b("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),p=b("g",
{class:"axes"});for(let h of X(r.low,r.high,(i-a)/Gt.y,r.whole))p.append(b("line",{x1:o,x2:s,y1:m(h),y2:m(h),class:"grid"}),b("text",{x:o-8,y:m(h),"text-anchor":"\
end","dominant-baseline":"middle"},zt(h)));for(let h of X(n.low,n.high,(s-o)/Gt.x,n.whole))p.append(b("text",{x:d(h),y:i+16,"text-anchor":"middle"},zt(h)));return p.
append(b("line",{x1:o,x2:s,y1:i,y2:i,class:"axis"}),b("text",{x:(o+s)/2,y:t-6,"text-anchor":"middle",class:"label"},n.label),b("text",{transform:`translate(12 ${(a+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),f.append(p,u),{root:f,marks:u,left:o,right:s,top:a,bottom:i,x:d,y:m,at:h=>{let y=h-f.getBoundingClientRect().
left;return n.low+(y-o)/(s-o)*(n.high-n.low)}}}var zt=e=>String(Number(e.toPrecision(6))).replace("-","−");function Z(e,t,n,r){let o="",a="M";n.forEach((i,l)=>{
i===null?a="M":(o+=`${a}${e.x(t[l]).toFixed(1)} ${e.y(i).toFixed(1)}`,a="L")});let s=b("path",{d:o,class:`line ${r}`});return e.root.insertBefore(s,e.marks),s}function Q(e,t,n,r=null){let o=e.x(t);e.marks.append(b("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${n}`})),r!==null&&e.marks.append(b("circle",{cx:o,cy:e.
y(r),r:5,class:`dot ${n}`}))}function He(...e){return c("p",{class:"legend small"},...e.map(([t,n])=>c("span",{class:`key ${n}`},t)))}function Se(e,t,n={}){let r=c(
"div",{class:"chart",role:"img","aria-label":e}),o=null,a=()=>{o?.marks.replaceChildren(),o&&n.marks?.(o)},s=()=>{let{clientWidth:i,clientHeight:l}=r;i<50||l<50||
(o=t(i,l),r.replaceChildren(o.root),a())};return r.addEventListener("pointermove",i=>n.point?.(o?.at(i.clientX)??null)),r.addEventListener("pointerleave",()=>n.
point?.(null)),n.choose&&(r.classList.add("chooses"),r.addEventListener("click",i=>o&&n.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(s).observe(r),{element:r,
redraw:s,remark:a}}var Be=["of-pursuers","of-evaders","of-both"],Ut={low:0,high:1,label:"capture rate"};function Vt(e,t){let{training:n}=e,{capture_rate:r,generation:o,learner:a,epochs:s}=n,
i=r.map((p,g)=>(g+1)*s),l=lr(r,n.window),d=i.at(-1)??1,m=(p,g)=>{let h=o.flatMap((y,x)=>y===p&&(a[x]===g||a[x]===2)?[x]:[]);return h.length?[i[h[0]],i[h.at(-1)]]:
null},u=Se(`Capture rate in ${d} epochs of training`,(p,g)=>{let h=Me(p,g,{low:0,high:d,label:"epoch",whole:!0},Ut);for(let[y,x]of[["raw",r],["",l]])for(let[E,v]of Be.
entries()){let w=x.map((R,L)=>a[L]===E||a[L+1]===E?R:null);w.some(R=>R!==null)&&Z(h,i,w,`${v} ${y}`)}return h},{marks:p=>{let{pursuer:g,evader:h}=t.selected;for(let[
y,x]of[[0,g],[1,h]]){let E=m(t.hover[y?"evader":"pursuer"]??x,y);E&&Q(p,(E[0]+E[1])/2,Be[y])}},choose:p=>{let g=Math.min(i.length-1,Math.max(0,Math.round(p/s)-1)),
h=o[g];a[g]!==1&&t.select({pursuer:Math.min(h,e.payoff.shape[0]-1)}),a[g]!==0&&t.select({evader:Math.min(h,e.payoff.shape[1]-1)})}}),f=[...new Set(a)].sort().map(
p=>[["pursuers learn","evaders learn","both teams learn"][p],Be[p]]);return{element:k("Training",`${$t(n.matches)} training matches. Lines: the generations that\
 are selected.`,He(...f),u.element),update:u.remark}}function jt(e,t){let n=e.findings?.lags;if(!n)return null;let[r,o]=[n.lags[0],n.lags.at(-1)],a=Math.min(5,(Math.
max(...n.cells)+1)/2),s=n.means.map((l,d)=>n.cells[d]>=a?l:null),i=Se("Lag profile",(l,d)=>{let m=Me(l,d,{low:r,high:o,label:"lag: pursuer minus evader generati\
on",whole:!0},Ut);return Z(m,n.lags,n.means,"raw ink"),Z(m,n.lags,s,"ink"),m},{marks:l=>{let{pursuer:d,evader:m}=t.selected;Q(l,0,"zero");let u=t.hover.lag??d-m;
Q(l,u,"ink",n.means[u-r])},point:l=>{let d=l===null?null:Math.round(l);t.point({lag:d!==null&&d>=r&&d<=o?d:null})}});return{element:k("Lag profile","Left: evade\
rs are later. Right: pursuers are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function Kt(e,t){let n=e.
findings?.ratings;if(!n)return null;let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(m=>m??0),[a,s]=[Math.min(...o),Math.max(...o)],
i=.06*(s-a||1),l=Math.max(...e.payoff.shape)-1,d=Se("Elo ratings by generation",(m,u)=>{let f=Me(m,u,{low:0,high:l,label:"generation",whole:!0},{low:a-i,high:s+
i,label:"Elo points"});for(let p of["pursuer","evader"])Z(f,r[p].map((g,h)=>h),r[p],`of-${p}s`);return f},{marks:m=>{for(let u of["pursuer","evader"]){let f=t.hover[u]??
t.selected[u];Q(m,f,`of-${u}s`,r[u][f]??null)}},choose:(m,u,f)=>{let p=Math.round(m),g=f.clientY-u.root.getBoundingClientRect().top,h=x=>Math.abs(u.y(r[x][p]??1/0)-
g),y=h("pursuer")<=h("evader")?"pursuer":"evader";p>=0&&p<r[y].length&&t.select({[y]:p})}});return{element:k("Ratings",`One number for each generation, which cy\
cles do not fit. The game itself: ${S(n.offset,0)} points for the pursuers.`,He(["pursuers","of-pursuers"],["evaders","of-evaders"]),d.element),update:d.remark}}
function lr(e,t){let n=[0];for(let r of e)n.push(n.at(-1)+r);return e.map((r,o)=>{let[a,s]=[Math.max(0,o-Math.floor((t-1)/2)),Math.min(e.length,o+Math.floor(t/2)+
1)];return(n[s]-n[a])/(s-a)})}var cr={present:"●",absent:"○","cannot tell":"?"};function Xt(e){let{findings:t}=e;if(!t)return null;let[,...n]=t.table,r=new Map(t.reasons.map(s=>{let[i,,l]=dr(
s);return[i,l]})),o=n.map(([s,i,l,d])=>{let m=d===t.window?r.get(s):void 0;return c("li",{class:`finding ${i.replace(" ","-")}`},c("span",{class:"sign","aria-hi\
dden":"true"},cr[i]??""),c("div",{},c("p",{},c("strong",{},s),` ${i}`,c("span",{class:"muted"},` · ${d}`)),m?c("p",{class:"small"},`${m}.`):null,c("p",{class:"\
small muted numbers"},l)))}),a=k("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",c("p",
{class:"headline"},t.headline),c("ul",{class:"findings"},...o),e.limits?c("p",{class:"small"},e.limits):null,c("details",{class:"small"},c("summary",{},"Headlin\
e numbers in words"),...t.description.map(s=>c("p",{},s)),ur(t)));return a.classList.add("diagnosis"),{element:a}}function dr(e){let[t="",n=""]=e.split(/: (.*)/s),
[r="",o=""]=n.split(/, because (.*)/s);return[t.toLowerCase(),r,mr(o.replace(/\.$/,""))]}var mr=e=>e.charAt(0).toUpperCase()+e.slice(1);function ur({noise:e}){return e.
transitive_share_noise===null?null:c("p",{},`Last half: transitive share ${S(e.transitive_share)} (an order of strength with the same noise rarely falls below ${S(
e.transitive_share_noise)}), checkerboards ${Oe(e.checkerboard_share)} (it rarely exceeds ${Oe(e.checkerboard_share_noise)}).`)}function qt(e){let t=[e.held_out?.pursuers,e.held_out?.evaders].filter(n=>n!=null);return t.length?{element:k("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${t[0].episodes} episodes.`,...t.map(pr))}:null}function pr(e){let t=r=>r.at(-1),n=[["mean",t(e.mean)],...Object.
entries(e.against).map(([r,o])=>[r,t(o)])];return c("table",{class:"scores numbers"},c("caption",{},c("span",{class:e.team},`${e.team}s`),` of generation ${e.generations.
at(-1)}, ${e.score}`),...n.map(([r,o],a)=>c("tr",{class:a?"":"mean"},c("th",{scope:"row"},r),c("td",{class:"range"},hr(o,e.team)),c("td",{},fe(o.value,o.low,o.high)))))}
function hr({value:e,low:t,high:n},r){let o=c("span",{class:`between ${r}`});o.style.left=`${100*(t??e)}%`,o.style.width=`${100*((n??e)-(t??e))}%`;let a=c("span",
{class:`value ${r}`});return a.style.left=`${100*e}%`,c("span",{class:"scale","aria-hidden":"true"},o,a)}function Jt(e){let t=e.settings.filter(o=>o.changed),n=e.settings.filter(o=>!o.changed),r=k("Settings",`${e.schedule}, seed ${e.seed}. Every setting is an optio\
n of matrixworld evolve.`,t.length?Yt(t,"other than the default"):c("p",{class:"small"},"All settings are the defaults."),c("details",{class:"small"},c("summary",
{},`${n.length} settings with their defaults`),Yt(n,"defaults")));return r.classList.add("settings"),{element:r}}function Yt(e,t){return c("div",{class:"wide-ta\
ble"},c("table",{class:"small"},c("caption",{class:"heard"},`Settings: ${t}`),...e.map(({name:n,value:r,help:o})=>c("tr",{},c("th",{scope:"row"},`--${n.replaceAll(
"_","-")}`),c("td",{class:"numbers"},r),c("td",{class:"muted"},o)))))}function k(e,t,...n){return c("section",{class:"card panel","aria-label":e},c("header",{},c("h2",{},e),c("p",{class:"small muted"},t)),...n)}function Zt(e,t,n){
let r=new Map,o=c("div",{class:"panels"}),a=[],s=()=>a.forEach(l=>l.update?.()),i=()=>{let l=e[t.selected.run];a=r.get(l)??fr(l,t,n),r.set(l,a),o.replaceChildren(
...a.map(d=>d.element)),s()};return t.on("run",i),t.on("match",s),t.on("hover",s),i(),o}function fr(e,t,n){return[Xt(e),Vt(e,t),Dt(e,t,n),jt(e,t),Kt(e,t),Wt(e,t),
qt(e),Jt(e)].filter(o=>o!==null)}var Qt={pursuer:null,evader:null,lag:null},Ee=class extends EventTarget{#e;#n=Qt;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in t&&t[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...t},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let n={...Qt,...t};n.pursuer===this.#n.pursuer&&n.evader===this.#n.evader&&n.lag===this.#n.lag||
(this.#n=n,this.dispatchEvent(new Event("hover")))}on(t,n){this.addEventListener(t,n)}};var ee=Ue(),{runs:F}=ee,[gr,br]=F[0].payoff.shape,te=new Ee({run:0,pursuer:gr-1,evader:br-1,episode:0,seed:null}),ne=new ye(F,te),en=new ve(F,te),De=Xe(),tn=null;
document.getElementById("page").replaceWith(c("header",{class:"top"},c("h1",{},ee.title),c("p",{class:"muted small about"},`matrixworld ${ee.version}`),c("div",
{class:"tools"},Ge(),c("button",{type:"button",title:"Keys (?)","aria-label":"Keys",onclick:()=>De.showModal()},"?"))),...ee.note?[c("p",{class:"note small mute\
d"},ee.note)]:[],Ke(F,te),c("main",{class:"stages"},en.element,ne.element),Zt(F,te,()=>tn),De);en.element.addEventListener("play",()=>ne.playSoon());qe(F,te,ne,
De);requestAnimationFrame(()=>setTimeout(()=>{Fe().then(e=>{tn=e,ne.start(e),document.body.dataset.ready="true"},e=>{ne.element.prepend(c("p",{class:"problem",role:"\
alert"},`The engine does not start here: ${String(e)}`)),document.body.dataset.ready="true"})}));})();
