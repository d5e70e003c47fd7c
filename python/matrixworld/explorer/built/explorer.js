/* built from web/ by "npm run build"; sources e1c98c28290429d58a0236efd715fcbd3950c82c86fd802c075bfe44fe7a9988 */
"use strict";(()=>{var Oa=Object.create;var xn=Object.defineProperty;var $a=Object.getOwnPropertyDescriptor;var Pa=Object.getOwnPropertyNames;var La=Object.getPrototypeOf,Ia=Object.prototype.hasOwnProperty;var Na=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(r){throw e=0,r}};var Ua=(t,e,r,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of Pa(e))!Ia.call(t,o)&&o!==r&&xn(t,o,{get:()=>e[o],enumerable:!(n=$a(e,o))||n.enumerable});
return t};var Ba=(t,e,r)=>(r=t!=null?Oa(La(t)):{},Ua(e||!t||!t.__esModule?xn(r,"default",{value:t,enumerable:!0}):r,t));var aa=Na(fn=>{var Js=Object.defineProperty,Kl=t=>Js(t,"__esModule",{value:!0}),Yl=(t,e)=>{for(var r in e)Js(t,r,{get:e[r],enumerable:!0})};Kl(fn);Yl(fn,{GIFEncoder:()=>oa,
applyPalette:()=>oc,default:()=>hc,nearestColor:()=>lc,nearestColorIndex:()=>ra,nearestColorIndexWithDistance:()=>na,prequantize:()=>nc,quantize:()=>tc,snapColorsToPalette:()=>ic});
var Zl={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Xs(t=256){let e=0,r=new Uint8Array(t);return{get buffer(){return r.buffer},reset(){e=0},bytesView(){return r.subarray(0,e)},bytes(){return r.slice(0,e)},
writeByte(o){n(e+1),r[e]=o,e++},writeBytes(o,s=0,a=o.length){n(e+a);for(let i=0;i<a;i++)r[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){n(e+a),r.set(o.subarray(
s,s+a),e),e+=a}};function n(o){var s=r.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=r;r=new Uint8Array(
o),e>0&&r.set(i.subarray(0,e),0)}}var pn=12,Ks=5003,Jl=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Xl(t,e,r,n,o=Xs(512),s=new Uint8Array(
256),a=new Int32Array(Ks),i=new Int32Array(Ks)){let l=a.length,d=Math.max(2,n);s.fill(0),i.fill(0),a.fill(-1);let u=0,c=0,m=d+1,h=m,y=!1,f=h,g=(1<<f)-1,v=1<<m-1,
M=v+1,b=v+2,w=0,A=r[0],C=0;for(let x=l;x<65536;x*=2)++C;C=8-C,o.writeByte(d),T(v);let E=r.length;for(let x=1;x<E;x++)e:{let $=r[x],_=($<<pn)+A,k=$<<C^A;if(a[k]===
_){A=i[k];break e}let Q=k===0?1:l-k;for(;a[k]>=0;)if(k-=Q,k<0&&(k+=l),a[k]===_){A=i[k];break e}T(A),A=$,b<1<<pn?(i[k]=b++,a[k]=_):(a.fill(-1),b=v+2,y=!0,T(v))}return T(
A),T(M),o.writeByte(0),o.bytesView();function T(x){for(u&=Jl[c],c>0?u|=x<<c:u=x,c+=f;c>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,c-=8;if((b>g||y)&&(y?(f=h,g=(1<<f)-1,y=!1):(++f,g=f===pn?1<<f:(1<<f)-1)),x==M){for(;c>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,c-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Ql=Xl;function Qs(t,e,r){return t<<8&63488|e<<2&992|r>>3}function ea(t,e,r,n){return t>>4|e&240|(r&
240)<<4|(n&240)<<8}function ta(t,e,r){return t>>4<<8|e&240|r>>4}function ur(t,e,r){return t<e?e:t>r?r:t}function bt(t){return t*t}function Ys(t,e,r){var n=0,o=1e100;
let s=t[e],a=s.cnt,i=s.ac,l=s.rc,d=s.gc,u=s.bc;for(var c=s.fw;c!=0;c=t[c].fw){let h=t[c],y=h.cnt,f=a*y/(a+y);if(!(f>=o)){var m=0;r&&(m+=f*bt(h.ac-i),m>=o)||(m+=
f*bt(h.rc-l),!(m>=o)&&(m+=f*bt(h.gc-d),!(m>=o)&&(m+=f*bt(h.bc-u),!(m>=o)&&(o=m,n=c))))}}s.err=o,s.nn=n}function mn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,
bk:0,tm:0,mtm:0,err:0}}function ec(t,e){let r=e==="rgb444"?4096:65536,n=new Array(r),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>24&255,l=a>>
16&255,d=a>>8&255,u=a&255,c=ea(u,d,l,i),m=c in n?n[c]:n[c]=mn();m.rc+=u,m.gc+=d,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],i=a>>
16&255,l=a>>8&255,d=a&255,u=ta(d,l,i),c=u in n?n[u]:n[u]=mn();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,d=a&255,
u=Qs(d,l,i),c=u in n?n[u]:n[u]=mn();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}return n}function tc(t,e,r={}){let{format:n="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,clearAlphaThreshold:a=0,
oneBitAlpha:i=!1}=r;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))
throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),d=r.useSqrt!==!1,u=n==="rgba4444",c=ec(l,n),m=c.length,h=m-1,y=new Uint32Array(
m+1);for(var f=0,v=0;v<m;++v){let P=c[v];if(P!=null){var g=1/P.cnt;u&&(P.ac*=g),P.rc*=g,P.gc*=g,P.bc*=g,c[f++]=P}}bt(e)/f<.022&&(d=!1);for(var v=0;v<f-1;++v)c[v].
fw=v+1,c[v+1].bk=v,d&&(c[v].cnt=Math.sqrt(c[v].cnt));d&&(c[v].cnt=Math.sqrt(c[v].cnt));var M,b,w;for(v=0;v<f;++v){Ys(c,v,!1);var A=c[v].err;for(b=++y[0];b>1&&(w=
b>>1,!(c[M=y[w]].err<=A));b=w)y[b]=M;y[b]=v}var C=f-e;for(v=0;v<C;){for(var E;;){var T=y[1];if(E=c[T],E.tm>=E.mtm&&c[E.nn].mtm<=E.tm)break;E.mtm==h?T=y[1]=y[y[0]--]:
(Ys(c,T,!1),E.tm=v);var A=c[T].err;for(b=1;(w=b+b)<=y[0]&&(w<y[0]&&c[y[w]].err>c[y[w+1]].err&&w++,!(A<=c[M=y[w]].err));b=w)y[b]=M;y[b]=T}var x=c[E.nn],$=E.cnt,_=x.
cnt,g=1/($+_);u&&(E.ac=g*($*E.ac+_*x.ac)),E.rc=g*($*E.rc+_*x.rc),E.gc=g*($*E.gc+_*x.gc),E.bc=g*($*E.bc+_*x.bc),E.cnt+=x.cnt,E.mtm=++v,c[x.bk].fw=x.fw,c[x.fw].bk=
x.bk,x.mtm=h}let k=[];var Q=0;for(v=0;;++Q){let z=ur(Math.round(c[v].rc),0,255),P=ur(Math.round(c[v].gc),0,255),B=ur(Math.round(c[v].bc),0,255),O=255;u&&(O=ur(Math.
round(c[v].ac),0,255),i&&(O=O<=(typeof i=="number"?i:127)?0:255),o&&O<=a&&(z=P=B=s,O=0));let W=u?[z,P,B,O]:[z,P,B];if(rc(k,W)||k.push(W),(v=c[v].fw)==0)break}return k}
function rc(t,e){for(let r=0;r<t.length;r++){let n=t[r],o=n[0]===e[0]&&n[1]===e[1]&&n[2]===e[2],s=n.length>=4&&e.length>=4?n[3]===e[3]:!0;if(o&&s)return!0}return!1}
function pr(t,e){var r=0,n;for(n=0;n<t.length;n++){let o=t[n]-e[n];r+=o*o}return r}function dr(t,e){return e>1?Math.round(t/e)*e:t}function nc(t,{roundRGB:e=5,roundAlpha:r=10,
oneBitAlpha:n=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,d=a>>8&255,u=a&255;i=dr(i,r),n&&(i=i<=(typeof n==
"number"?n:127)?0:255),u=dr(u,e),d=dr(d,e),l=dr(l,e),o[s]=i<<24|l<<16|d<<8|u<<0}}function oc(t,e,r="rgb565"){if(!t||!t.buffer)throw new Error("quantize() expect\
ed RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>
256)throw new Error("applyPalette() only works with 256 colors or less");let n=new Uint32Array(t.buffer),o=n.length,s=r==="rgb444"?4096:65536,a=new Uint8Array(o),
i=new Array(s),l=r==="rgba4444";if(r==="rgba4444")for(let d=0;d<o;d++){let u=n[d],c=u>>24&255,m=u>>16&255,h=u>>8&255,y=u&255,f=ea(y,h,m,c),g=f in i?i[f]:i[f]=sc(
y,h,m,c,e);a[d]=g}else{let d=r==="rgb444"?ta:Qs;for(let u=0;u<o;u++){let c=n[u],m=c>>16&255,h=c>>8&255,y=c&255,f=d(y,h,m),g=f in i?i[f]:i[f]=ac(y,h,m,e);a[u]=g}}
return a}function sc(t,e,r,n,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],d=l[3],u=ke(d-n);if(u>a)continue;let c=l[0];if(u+=ke(c-t),u>a)continue;let m=l[1];
if(u+=ke(m-e),u>a)continue;let h=l[2];u+=ke(h-r),!(u>a)&&(a=u,s=i)}return s}function ac(t,e,r,n){let o=0,s=1e100;for(let a=0;a<n.length;a++){let i=n[a],l=i[0],d=ke(
l-t);if(d>s)continue;let u=i[1];if(d+=ke(u-e),d>s)continue;let c=i[2];d+=ke(c-r),!(d>s)&&(s=d,o=a)}return o}function ic(t,e,r=5){if(!t.length||!e.length)return;
let n=t.map(a=>a.slice(0,3)),o=r*r,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>s?i=i.slice(0,3):i=i.slice();
let l=na(n,i.slice(0,3),pr),d=l[0],u=l[1];u>0&&u<=o&&(t[d]=i)}}function ke(t){return t*t}function ra(t,e,r=pr){let n=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],
i=r(e,a);i<n&&(n=i,o=s)}return o}function na(t,e,r=pr){let n=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return[o,n]}function lc(t,e,r=pr){
return t[ra(t,e,r)]}function oa(t={}){let{initialCapacity:e=4096,auto:r=!0}=t,n=Xs(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),i=new Int32Array(o),l=!1;
return{reset(){n.reset(),l=!1},finish(){n.writeByte(Zl.trailer)},bytes(){return n.bytes()},bytesView(){return n.bytesView()},get buffer(){return n.buffer},get stream(){
return n},writeHeader:d,writeFrame(u,c,m,h={}){let{transparent:y=!1,transparentIndex:f=0,delay:g=0,palette:v=null,repeat:M=0,colorDepth:b=8,dispose:w=-1}=h,A=!1;
if(r?l||(A=!0,d(),l=!0):A=!!h.first,c=Math.max(0,Math.floor(c)),m=Math.max(0,Math.floor(m)),A){if(!v)throw new Error("First frame must include a { palette } opt\
ion");uc(n,c,m,v,b),Zs(n,v),M>=0&&dc(n,M)}let C=Math.round(g/10);cc(n,w,C,y,f);let E=!!v&&!A;pc(n,c,m,E?v:null),E&&Zs(n,v),mc(n,u,c,m,b,s,a,i)}};function d(){sa(
n,"GIF89a")}}function cc(t,e,r,n,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,n=!1);var s,a;n?(s=1,a=2):(s=0,a=0),e>=0&&(a=e&7),a<<=2,t.writeByte(
0|a|0|s),xe(t,r),t.writeByte(o||0),t.writeByte(0)}function uc(t,e,r,n,o=8){let i=hn(n.length)-1,l=128|o-1<<4|0|i,d=0,u=0;xe(t,e),xe(t,r),t.writeBytes([l,d,u])}function dc(t,e){
t.writeByte(33),t.writeByte(255),t.writeByte(11),sa(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),xe(t,e),t.writeByte(0)}function Zs(t,e){let r=1<<hn(e.length);
for(let n=0;n<r;n++){let o=[0,0,0];n<e.length&&(o=e[n]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function pc(t,e,r,n){if(t.writeByte(44),xe(t,0),xe(
t,0),xe(t,e),xe(t,r),n){let a=hn(n.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function mc(t,e,r,n,o=8,s,a,i){Ql(r,n,e,o,t,s,a,i)}function xe(t,e){t.writeByte(
e&255),t.writeByte(e>>8&255)}function sa(t,e){for(var r=0;r<e.length;r++)t.writeByte(e.charCodeAt(r))}function hn(t){return Math.max(Math.ceil(Math.log2(t)),1)}
var hc=oa});var Sn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Qe={DISAPPEAR:0,REACH:1,BOUNCE:2},Mn={OCCUPATION:0,SURROUND:1},An={FAULT:0,INVOLVED:1};var wr=["obstacle","teammate","adversary"],xr=["vertex","edge","chain"],En=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Sr=["p\
ursuer_{number}","evader_{number}"],Tn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},et={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Cn="{event}: {outcome}",Mr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},kn={free:".GS",blocked:"#@OTW"};var Pe=1+En.length;function tt(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function j(t,e){return t<e?tt(Sr[0],{number:t}):tt(Sr[1],{number:t-e})}function Fa(t,e){
let[r,n,o,s,a,i,l,...d]=Array.from(t),u=a<0?[s]:[s,a],[c,m,h]=d.map(v=>u.filter((M,b)=>v>>b&1)),y=u.map(v=>j(v,e)),f=tt(Tn[a<0?"obstacle":xr[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=tt(Cn,{event:f,outcome:Da(u.length,m,h,e)});return{kind:wr[n],form:xr[o],agents:u,cell:[i,l],at_fault:c,held:m,doomed:h,turn:r,
text:g}}function Da(t,e,r,n){if(t===2&&e.length===2)return et["both held"];if(t===2&&r.length===2)return et["both doomed"];let o=s=>a=>tt(et[s],{agent:j(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||et.none}function Mt(t,e){let r=[];for(let n=0;n<t.length;n+=Pe)r.push(Fa(t.subarray(n+1,n+Pe),e));
return r}var be=class extends Error{name="EngineError"};function F(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new be(
`${t}: expected ${e}, got ${n}`)}var Le=class{bytes;constructor(e){this.bytes=e}},On=0,Er=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Rn=4,_n=4,za=new TextEncoder,
Wa=new TextDecoder;function Ha(t){for(let e=Er.length-1;e>On;--e)if(t instanceof Er[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ar(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ga(t){return za.encode(`${t}\0`)}var Tr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new be("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Ga(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Le,l=i?a.bytes:
a;return[this.text(s),i?On:Ha(l),l.length,this.copy(Ar(l))]}),o=this.copy(Ar(Int32Array.from(n)));return this.copy(Ar(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function $n(t,e){let r=t.HEAPU8;return Wa.decode(r.subarray(e,r.indexOf(0,e)))}function Ie(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Rn,n=e[r+1]/Rn,o={};for(let s=n;s<n+e[r]*_n;s+=_n){let a=Er[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[$n(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function ve(t,e){let r=new Tr(t);try{let n=e(r);if(n===0)throw new be($n(t,t._last_error()));return n}finally{r.free()}}var ja=2**31-1,Pn=["none","elman","gru"],Va=2n**64n-1n,qa=34028234663852886e22;function me(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ja)throw F(
t,"an integer",e);return Int32Array.of(e)}function At(t,e){if(typeof e!="boolean")throw F(t,"true or false",e);return new Le(Uint8Array.of(Number(e)))}function Se(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw F(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Cr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=qa))throw F(t,"a finite number",e);return e}function Ne(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Va)throw F(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ka(t){return{"rules.interaction":Se("interactio\
n",t.interaction,Sn),"rules.obstacle":Se("obstacle",t.obstacle,Qe),"rules.teammate":Se("teammate",t.teammate,Qe),"rules.evader":Se("evader",t.evader,Qe),"rules.\
pursuer":Se("pursuer",t.pursuer,Qe),"rules.capture":Se("capture",t.capture,Mn),"rules.captured_disappear":At("captured_disappear",t.captured_disappear)}}function Ln(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw F(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Cr(t,n))}function Ya(t){let e=(r,n)=>Float32Array.
of(Cr(r,t[r]),Cr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Ln("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Ln("evader_collide",t.evader_collide),
"rewards.blame":Se("blame",t.blame,An),"rewards.capture_repeats":At("capture_repeats",t.capture_repeats)}}function Nn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=kn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw F(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw F(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Un(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Ue(t){Un(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ka(t.rules),...Ya(t.rewards),rows:me("rows",t.rows),cols:me("cols",t.cols),n_pursuers:me("n_pursuers",t.n_pursuers),n_evaders:me("n_evaders",t.n_evaders),fov:me(
"fov",t.fov),diagonal:At("diagonal",t.diagonal),max_steps:me("max_steps",t.max_steps),density:Float64Array.of(e),map:Nn(t.obstacles)}}function In(t,e){return Int32Array.
from((e??[]).flat(),r=>me(t,r)[0])}function Bn(t,e){return Un(t.obstacles,e),{seed:Ne("seed",t.seed??0n),episode:Ne("episode",t.episode??0),pursuers:In("pursuer\
s",t.pursuers),evaders:In("evaders",t.evaders),map:Nn(t.obstacles)}}function Et(t){return{actions:Int32Array.from(t,e=>me("actions",e)[0])}}function Be(t){if(typeof t==
"string"){if(!Object.hasOwn(Mr,t))throw F("policy",`one of ${Object.keys(Mr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw F("activation","'relu' or 'tanh'",t.activation);if(!Pn.includes(t.memory))throw F("memory",`one of ${Pn.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>me("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:At("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Za=["first_turn","terminated","truncated"];function Fn(t){let e={...t};for(let r of Za)e[r]=new Le(t[r]);return e}var Dn="statistics.",Tt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=zn(Wn(o),0),Object.assign(this,o),this.first_conflict=Ja(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Pe,n*Pe);return Mt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function Ja(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Pe)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function zn(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var Wn=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(Dn)?[[e.slice(Dn.length),r]]:[]));function Hn(t,e,r,n){let o=[Ue(r.config),Be(r.pursuers),Be(r.evaders),
n];return ve(t,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return t[e](a,i,l,d)}),Ie(t)}function Gn(t,e,r,n){let o={seed:Ne("seed",r),episode:Ne("episode",n)};return new Tt(
e.config,r,n,Hn(t,"_play_match",e,o))}function kr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let o=Hn(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return Wn(o)}function jn(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:Ne("seed",r)},s=kr(t,e,o,n);return Array.
from({length:n},(a,i)=>zn(s,i))}var Xa=7e6,Qa=new FinalizationRegistry(([t,e])=>t._states_free(e));function ei({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,d=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",c=t.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(v,M)=>c?f:(f+M)/(M+1)).reduce((v,M)=>v*M,1),h=m(l+Number(d),s)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function Ct(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":ei(t)>Xa?"the world is too large to be solved on the page":""}var Rr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,d]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<d),c=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(c),play:o},{agents:u.filter(m=>!c(m)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((d,u)=>d*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,d,u)=>l+
d*this.matrix[r*s.length+u],0),i=o.reduce((l,d,u)=>l+d*this.matrix[u*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},_r=60,rt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=ve(e,i=>e._states_new(i.arrays(Ue(r)))),Qa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,_r);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new Rr(e,a):null}call(e){
return ve(this.engine,e),Ie(this.engine)}};var Vn=new FinalizationRegistry(([t,e])=>t._world_free(e)),nt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ve(e,n=>e._world_new(n.arrays(Ue(r)))),Vn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Vn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Bn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Et(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Et(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
Be(e),Et(n)],{actions:d}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(d)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Mt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Be(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:ti(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Fn(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return ve(this.engine,e),Ie(this.engine)}};function ti(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Or=class{compiled;constructor(e){this.compiled=e}world(e){return new nt(this.compiled,e)}solution(e,r="capture-rate"){return new rt(this.compiled,e,r)}match(e,r,n,o,s=0){
return Gn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return jn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return kr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},qn;function Kn(t=globalThis.matrixworldEngine){return qn??=ri(t),qn}async function ri(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Or(await t({wasmBinary:e}))}var ni="http://www.w3.org/2000/svg";function p(t,e={},...r){return Yn(document.createElement(t),e,r)}function S(t,e={},...r){return Yn(document.createElementNS(
ni,t),e,r)}function Yn(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(oi).map(n=>typeof n=="number"?String(n):n)),t}function oi(t){return t!=null&&t!==!1}var kt=()=>["file:","http:","https:"].
includes(location.protocol);function si(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function $r(){document.documentElement.
dataset.theme=si()?"light":"dark"}if(typeof document<"u"){let t=document.documentElement.dataset,e=t.theme;addEventListener("beforeprint",()=>{e=t.theme,t.theme=
"light"}),addEventListener("afterprint",()=>{e?t.theme=e:delete t.theme})}function Zn(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:$r},"◐")}var Jn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,Zn()));var ai=2n**64n-1n;function ot(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(d,u,c)=>{let m=n.get(d)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):c},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ai?l:null,step:o("step",1/0,0)}}function Qn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:d,episode:u,seed:c}=e.selected,m={run:i,pursuers:l,evaders:d,episode:u,...c===null?{}:{seed:c},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(m).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=ot(location.
hash,t,e.selected);for(let d of document.querySelectorAll("dialog[open]"))d.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var ii=5e3,Xn=8e3;function eo(t,e,r){
let n=-Xn;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{r()||performance.
now()-n<Xn||(li(t,e),location.reload())},ii)}function li(t,e){let{run:r,pursuer:n,evader:o}=e.selected,[s,a]=t[r].payoff.shape;n===s-1&&o===a-1&&history.replaceState(
null,"",`#run=${r}`)}var N=Uint8Array,J=Uint16Array,zr=Int32Array,_t=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ot=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Nr=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ao=function(t,e){for(var r=new J(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new zr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},io=ao(_t,2),lo=io.b,Ur=io.r;lo[28]=258,Ur[258]=28;var co=ao(
Ot,0),ci=co.b,to=co.r,Br=new J(32768);for(R=0;R<32768;++R)he=(R&43690)>>1|(R&21845)<<1,he=(he&52428)>>2|(he&13107)<<2,he=(he&61680)>>4|(he&3855)<<4,Br[R]=((he&65280)>>
8|(he&255)<<8)>>1;var he,R,le=(function(t,e,r){for(var n=t.length,o=0,s=new J(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new J(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new J(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var d=o<<4|t[o],u=e-t[o],c=a[t[o]-1]++<<u,m=c|(1<<u)-1;c<=m;++c)i[Br[c]>>l]=d}else for(i=new J(
n),o=0;o<n;++o)t[o]&&(i[o]=Br[a[t[o]-1]++]>>15-t[o]);return i}),we=new N(288);for(R=0;R<144;++R)we[R]=8;var R;for(R=144;R<256;++R)we[R]=9;var R;for(R=256;R<280;++R)
we[R]=7;var R;for(R=280;R<288;++R)we[R]=8;var R,it=new N(32);for(R=0;R<32;++R)it[R]=5;var R,ui=le(we,9,0),di=le(we,9,1),pi=le(it,5,0),mi=le(it,5,1),Pr=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},se=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Lr=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Wr=function(t){return(t+7)/8|0},Hr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new N(t.subarray(
e,r))};var hi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],V=function(t,e,r){var n=new Error(e||hi[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,V),!r)throw n;return n},fi=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new N(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new N(o*3));var d=function(Je){var Xe=r.length;if(Je>Xe){var $e=new N(Math.max(Xe*2,Je));$e.set(r),r=$e}},u=e.f||0,c=e.
p||0,m=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,v=o*8;do{if(!h){u=se(t,c,1);var M=se(t,c+1,3);if(c+=3,M)if(M==1)h=di,y=mi,f=9,g=5;else if(M==2){var C=se(t,c,31)+257,E=se(
t,c+10,15)+4,T=C+se(t,c+5,31)+1;c+=14;for(var x=new N(T),$=new N(19),_=0;_<E;++_)$[Nr[_]]=se(t,c+_*3,7);c+=E*3;for(var k=Pr($),Q=(1<<k)-1,z=le($,k,1),_=0;_<T;){
var P=z[se(t,c,Q)];c+=P&15;var b=P>>4;if(b<16)x[_++]=b;else{var B=0,O=0;for(b==16?(O=3+se(t,c,3),c+=2,B=x[_-1]):b==17?(O=3+se(t,c,7),c+=3):b==18&&(O=11+se(t,c,127),
c+=7);O--;)x[_++]=B}}var W=x.subarray(0,C),D=x.subarray(C);f=Pr(W),g=Pr(D),h=le(W,f,1),y=le(D,g,1)}else V(1);else{var b=Wr(c)+4,w=t[b-4]|t[b-3]<<8,A=b+w;if(A>o){
l&&V(0);break}i&&d(m+w),r.set(t.subarray(b,A),m),e.b=m+=w,e.p=c=A*8,e.f=u;continue}if(c>v){l&&V(0);break}}i&&d(m+131072);for(var Re=(1<<f)-1,ee=(1<<g)-1,pe=c;;pe=
c){var B=h[Lr(t,c)&Re],Y=B>>4;if(c+=B&15,c>v){l&&V(0);break}if(B||V(2),Y<256)r[m++]=Y;else if(Y==256){pe=c,h=null;break}else{var Z=Y-254;if(Y>264){var _=Y-257,I=_t[_];
Z=se(t,c,(1<<I)-1)+lo[_],c+=I}var ie=y[Lr(t,c)&ee],_e=ie>>4;ie||V(3),c+=ie&15;var D=ci[_e];if(_e>3){var I=Ot[_e];D+=Lr(t,c)&(1<<I)-1,c+=I}if(c>v){l&&V(0);break}
i&&d(m+131072);var Oe=m+Z;if(m<D){var xt=s-D,St=Math.min(D,Oe);for(xt+m<0&&V(3);m<St;++m)r[m]=n[xt+m]}for(;m<Oe;++m)r[m]=r[m-D]}}e.l=h,e.p=pe,e.b=m,e.f=u,h&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return m!=r.length&&a?Hr(r,0,m):r.subarray(0,m)},fe=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},st=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Ir=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:po,l:0};if(o==1){var a=new N(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,C){return A.f-C.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],d=0,
u=1,c=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[d].f<r[c].f?d++:c++],l=r[d!=u&&r[d].f<r[c].f?d++:c++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,n=1;n<
o;++n)s[n].s>m&&(m=s[n].s);var h=new J(m+1),y=Fr(r[u-1],h,0);if(y>e){var n=0,f=0,g=y-e,v=1<<g;for(s.sort(function(C,E){return h[E.s]-h[C.s]||C.f-E.f});n<o;++n){
var M=s[n].s;if(h[M]>e)f+=v-(1<<y-h[M]),h[M]=e;else break}for(f>>=g;f>0;){var b=s[n].s;h[b]<e?f-=1<<e-h[b]++-1:++n}for(;n>=0&&f;--n){var w=s[n].s;h[w]==e&&(--h[w],
++f)}y=e}return{t:new N(h),l:y}},Fr=function(t,e,r){return t.s==-1?Math.max(Fr(t.l,e,r+1),Fr(t.r,e,r+1)):e[t.s]=r},ro=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new J(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},at=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},uo=function(t,e,r){var n=r.length,o=Wr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},no=function(t,e,r,n,o,s,a,i,l,d,u){fe(e,u++,r),++o[256];for(var c=Ir(o,15),m=c.t,h=c.l,y=Ir(s,15),f=y.t,g=y.l,v=ro(m),M=v.c,
b=v.n,w=ro(f),A=w.c,C=w.n,E=new J(19),T=0;T<M.length;++T)++E[M[T]&31];for(var T=0;T<A.length;++T)++E[A[T]&31];for(var x=Ir(E,7),$=x.t,_=x.l,k=19;k>4&&!$[Nr[k-1]];--k)
;var Q=d+5<<3,z=at(o,we)+at(s,it)+a,P=at(o,m)+at(s,f)+a+14+3*k+at(E,$)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&Q<=z&&Q<=P)return uo(e,u,t.subarray(l,l+d));var B,O,W,D;
if(fe(e,u,1+(P<z)),u+=2,P<z){B=le(m,h,0),O=m,W=le(f,g,0),D=f;var Re=le($,_,0);fe(e,u,b-257),fe(e,u+5,C-1),fe(e,u+10,k-4),u+=14;for(var T=0;T<k;++T)fe(e,u+3*T,$[Nr[T]]);
u+=3*k;for(var ee=[M,A],pe=0;pe<2;++pe)for(var Y=ee[pe],T=0;T<Y.length;++T){var Z=Y[T]&31;fe(e,u,Re[Z]),u+=$[Z],Z>15&&(fe(e,u,Y[T]>>5&127),u+=Y[T]>>12)}}else B=
ui,O=we,W=pi,D=it;for(var T=0;T<i;++T){var I=n[T];if(I>255){var Z=I>>18&31;st(e,u,B[Z+257]),u+=O[Z+257],Z>7&&(fe(e,u,I>>23&31),u+=_t[Z]);var ie=I&31;st(e,u,W[ie]),
u+=D[ie],ie>3&&(st(e,u,I>>5&8191),u+=Ot[ie])}else st(e,u,B[I]),u+=O[I]}return st(e,u,B[256]),u+O[256]},yi=new zr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),po=new N(0),gi=function(t,e,r,n,o,s){var a=s.z||t.length,i=new N(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),d=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var c=yi[e-1],m=c>>13,h=c&8191,y=(1<<r)-1,f=s.p||new J(32768),g=s.h||new J(y+1),v=Math.ceil(r/3),M=2*v,b=function(vr){return(t[vr]^t[vr+1]<<
v^t[vr+2]<<M)&y},w=new zr(25e3),A=new J(288),C=new J(32),E=0,T=0,x=s.i||0,$=0,_=s.w||0,k=0;x+2<a;++x){var Q=b(x),z=x&32767,P=g[Q];if(f[z]=P,g[Q]=z,_<=x){var B=a-
x;if((E>7e3||$>24576)&&(B>423||!d)){u=no(t,l,0,w,A,C,T,$,k,x-k,u),$=E=T=0,k=x;for(var O=0;O<286;++O)A[O]=0;for(var O=0;O<30;++O)C[O]=0}var W=2,D=0,Re=h,ee=z-P&32767;
if(B>2&&Q==b(x-ee))for(var pe=Math.min(m,B)-1,Y=Math.min(32767,x),Z=Math.min(258,B);ee<=Y&&--Re&&z!=P;){if(t[x+W]==t[x+W-ee]){for(var I=0;I<Z&&t[x+I]==t[x+I-ee];++I)
;if(I>W){if(W=I,D=ee,I>pe)break;for(var ie=Math.min(ee,I-2),_e=0,O=0;O<ie;++O){var Oe=x-ee+O&32767,xt=f[Oe],St=Oe-xt&32767;St>_e&&(_e=St,P=Oe)}}}z=P,P=f[z],ee+=
z-P&32767}if(D){w[$++]=268435456|Ur[W]<<18|to[D];var Je=Ur[W]&31,Xe=to[D]&31;T+=_t[Je]+Ot[Xe],++A[257+Je],++C[Xe],_=x+W,++E}else w[$++]=t[x],++A[t[x]]}}for(x=Math.
max(x,_);x<a;++x)w[$++]=t[x],++A[t[x]];u=no(t,l,d,w,A,C,T,$,k,x-k,u),d||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=f,s.i=x,s.w=_)}else{for(var x=s.w||0;x<a+d;x+=65535){
var $e=x+65535;$e>=a&&(l[u/8|0]=d,$e=a),u=uo(l,u+1,t.subarray(x,$e))}s.i=a}return Hr(i,0,n+Wr(u)+o)},bi=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),vi=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=bi[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var wi=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return gi(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},mo=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var H=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var xi=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&V(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&V(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Si(t,e){return wi(t,e||{},0,0)}function ho(t,e){return fi(t.subarray(xi(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var fo=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=mo(n,s[1]),s=s[0]),s instanceof N?r[a]=[s,i]:(r[a+="/"]=[new N(0),i],fo(s,a,r,
n))}},oo=typeof TextEncoder<"u"&&new TextEncoder,Mi=typeof TextDecoder<"u"&&new TextDecoder,Ai=0;try{Mi.decode(po,{stream:!0}),Ai=1}catch{}function Rt(t,e){if(e){for(var r=new N(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(oo)return oo.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new N(a+8+(o-n<<1));l.set(s),s=l}var d=t.charCodeAt(n);d<128||e?i(d):d<2048?(i(192|
d>>6),i(128|d&63)):d>55295&&d<57344?(d=65536+(d&1047552)|t.charCodeAt(++n)&1023,i(240|d>>18),i(128|d>>12&63),i(128|d>>6&63),i(128|d&63)):(i(224|d>>12),i(128|d>>
6&63),i(128|d&63))}return Hr(s,0,a)}var Dr=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&V(9),e+=n+4}return e},so=function(t,e,r,n,o,s,a,i){var l=n.length,d=r.extra,u=i&&i.length,
c=Dr(d);H(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var m=new Date(r.mtime==null?Date.now():r.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&V(10),H(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(H(t,e,r.crc),H(t,e+4,s<0?-s-2:s),H(t,e+8,r.size)),H(t,e+12,l),H(t,e+14,c),e+=16,a!=null&&(H(t,e,
u),H(t,e+6,r.attrs),H(t,e+10,a),e+=14),t.set(n,e),e+=l,c)for(var y in d){var f=d[y],g=f.length;H(t,e,+y),H(t,e+2,g),t.set(f,e+4),e+=4+g}return u&&(t.set(i,e),e+=
u),e},Ei=function(t,e,r,n,o){H(t,e,101010256),H(t,e+8,r),H(t,e+10,r),H(t,e+12,n),H(t,e+16,o)};function yo(t,e){e||(e={});var r={},n=[];fo(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],d=i[1],u=d.level==0?0:8,c=Rt(a),m=c.length,h=d.comment,y=h&&
Rt(h),f=y&&y.length,g=Dr(d.extra);m>65535&&V(11);var v=u?Si(l,d):l,M=v.length,b=vi();b.p(l),n.push(mo(d,{size:l.length,crc:b.d(),c:v,f:c,m:y,u:m!=a.length||y&&h.
length!=f,o,compression:u})),o+=30+m+g+M,s+=76+2*(m+g)+(f||0)+M}for(var w=new N(s+22),A=o,C=s-o,E=0;E<n.length;++E){var c=n[E];so(w,c.o,c,c.f,c.u,c.c.length);var T=30+
c.f.length+Dr(c.extra);w.set(c.c,c.o+T),so(w,o,c,c.f,c.u,c.c.length,c.o,c.m),o+=16+T+(c.m?c.m.length:0)}return Ei(w,o,n.length,C,A),w}var q=(t,e)=>`${t}s of generation ${e}`,ce=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ae=["pursuer","evader"];function bo(){return JSON.parse(Lt("data"))}function Fe(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function $t(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${q(e,r)}: it would be too large. Choose a generation of ${s.join("\
, ")}.`;let i=s.length*o.genome_size;return vo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wri\
te it again from its run.`}function te(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,d=vo(a,l).subarray(i*l,(i+1)*l),{hidden:u,activation:c,
sampled:m,memory:h}=o;return{hidden:u,activation:c,sampled:m,memory:h,genome:d}}function Pt(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.
match(e.world,te(e,"pursuer",r),te(e,"evader",n),BigInt(s??a),o)}var Gr=4,go=new Map;function vo(t,e){let r=go.get(t);if(r)return r;let n=new Float32Array;try{let o=Ci(jr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Ti(o)))throw o}return go.set(t,n),n}var Ti=t=>t instanceof Error&&"code"in t;function Ci(t,e){let r=ho(t),n=r.length/Gr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Gr*n+Math.floor(a/Gr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function jr(t){let e=atob(Lt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Lt(t){return document.getElementById(
t)?.textContent??""}var lt=[.5,1,2,4,8,16,32,64],It=0,Nt=12,ki=2,De=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#l=null;#p=0;#c=[];#m=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#r=r.speed??4,this.#t=r.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(ki,this.#e/Nt)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=lt.findIndex(n=>n>=this.pace);this.speed=lt[Math.min(lt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#d(r),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#a),this.#o("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#l===null&&(this.#p=performance.now(),
this.#l=requestAnimationFrame(()=>this.#h()))}#h(){this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#l=requestAnimationFrame(()=>this.#h()))}#u(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function ze(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function Ut(t,e,...r){let n=p("dialog",{class:e,"aria-label":t},p("div",{class:"dialog-head"},p("h2",{},t),p("button",{type:"button",class:"close","aria-label":"\
Close",onclick:()=>n.close()},"✕")),...r);return n.addEventListener("click",o=>o.target===n&&n.close()),n}var wo=t=>p("dl",{class:"keys"},...t.flatMap(([e,r])=>[
p("dt",{},...e.map(n=>p("kbd",{},n))),p("dd",{},r)]));async function Ri(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{
e.textContent="Selected: copy it with Ctrl+C."}}var xo=(t,e,r)=>p("label",{class:"copy"},p("span",{},t),e,p("button",{type:"button",onclick:()=>Ri(e,r)},"Copy")),
Bt=t=>p("input",{type:"text",readonly:!0,"aria-label":t});function Ft(t,e){let r=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));p("a",{href:r,
download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var ct=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function We(t){let e=Math.min(1,Math.max(0,t))*(ct.length-1),r=Math.min(ct.length-2,Math.floor(e)),[n,o]=[ct[r],
ct[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Dt(t){let[e,r,n]=We(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var zt=t=>`rgb(${We(t).join(" ")})`,So=()=>`linear-gradient(to right, ${ct.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Wt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=_i(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function _i(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,d)=>{let u=4*((e-1-i-t.first[0])*r+d+t.first[1]);s.data.set([...We(l),255],u)})),o.putImageData(s,0,0),n}function Ht(t,e){let r=p("span",{class:"grad\
ient"});return r.style.backgroundImage=So(),p("p",{class:"scale-of-rates small muted"},t,r,e)}var Oi=84;function Mo(t,e){let r=t.map((s,a)=>$i(s,a,e)),n=p("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function $i(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Oi/
Math.max(n,o),i=p("canvas",{"aria-hidden":"true"});Wt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=p("span",{class:"place"}),d=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Vr(t,e,r)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Pi(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:c=>{d.setAttribute("aria-current",String(c));let m=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=m>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-m-.5)*a}px`}}}var Pi=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Vr(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Li=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]],Ao=()=>Ut("Keys","help",wo(Li),p("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that ve\
ry match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."));function Eo(t,e,r,n,o,s){let a=(l,d)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:$r,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let d=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||d||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let c=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(ze(r.player,l)||c)c?.();else if(t[m])Vr(t[m],
m,e);else return;l.preventDefault()})}var He=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function To(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),He.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Me=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ii=(t,e)=>t[0]===e[0]&&
t[1]===e[1],qr=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Kr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Yr=(t,e)=>Kr(t.fault,e),Co=(t,e)=>!Yr(
t,e)&&Kr(t.involved,e,2);function Gt(t,e,r){let n=!Ii(L(t,r),L(e,r)),o=e.involved===void 0||Kr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function jt(t,e,r){
let[n,o]=L(t,r),[s,a]=He[e.actions?.[r]??0];return[n+s,o+a]}function ut(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var ko=t=>t.moments.flatMap((e,r)=>r&&ut(t,t.moments[r-1],e).length?[r]:[]);function Vt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Ro=[-.31,0,.31],_o=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ro.flatMap(t=>Ro.map(e=>[e,t]))}],Ni=.3,Ui=.35,Bi=.55;function dt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=L(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Oo(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of dt(t,e).values()){let o=_o[Math.min(n.length,_o.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var $o=t=>t*t*(3-2*t),Ge=(t,e,r)=>t+(e-t)*r,Po=t=>Math.min(1,Math.max(0,t));function Lo(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return $o(n);let s=o===r?e:+!Me(t,e),a=Math.max(1/o,Ui);return $o(Po((n-s/(o-1)*(1-a))/a))}function qt(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Oo(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Oo(t,a);return s.map((l,d)=>{let u=Lo(
t,d,s.length,e-n);return Fi(o,a,d,l,i[d],u)})}function Zr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Lo(t,e,s.alive.length,r-o),[[l,d],[u,c]]=[L(s,e),L(a,e)];return[Ge(d,c,i)+.5,Ge(l,u,i)+.5]}function Fi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Ge(n.x,o.x,
s),y:Ge(n.y,o.y,s),size:a?n.size:Ge(n.size,o.size,s),alpha:a?Po((1-s)/(1-Bi)):Ge(n.alpha,o.alpha,s)};if(Gt(t,e,r)){let[l,d]=L(t,r),[u,c]=jt(t,e,r),m=Ni*Math.sin(
Math.PI*s);i.x+=(c-d)*m,i.y+=(u-l)*m}return i}var Io=2*Math.PI;function Ae(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Io)}function Kt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];t.arcTo(a,i,d,u,n*.09)}),t.closePath()}function No(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Uo(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Io*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Bo(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Fo=4,Di=1.6,zi=.95,Wi=5,Hi=.16,Gi=9,ji=.09,Vi=.2,Do=.75,re=(t,e)=>t.left+e*t.cell,ne=(t,e)=>t.top+e*t.cell;function je(t,e,r){return Me(e,r)?t.colors.pursuer:
t.colors.evader}function zo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,d),s<Wi)return;
t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let c=1;c<i;c++)t.fillRect(n+c*s,o,u,d);for(let c=1;c<a;c++)t.fillRect(n,o+c*s,l,u)}function Wo({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[u,c]=[Math.floor(d/l),
d%l];t.fillRect(o+c*a,s+u*a,a,a)}Ho({ctx:t,grid:e,colors:r})}function Ho({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Go({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,d=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let u=5*n+a/40;for(let c=0;c<l;c+=d)t.fillText(String(c),o+(c+.5)*a,s-u);t.textAlign="right",t.textBaseline="middle";for(let c=0;c<i;c+=d)t.fillText(
String(c),o-u,s+(c+.5)*a)}function jo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[re(t,s),ne(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Vo(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...jo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Ho(t)}function qo({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[re(e,n),ne(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let c=d-i/2<u*1.2,m=d+(c?1:-1)*(i/2+u*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=r.ink,t.fillText("You",l,m),t.globalAlpha=1}function Ko(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=jo(t,e,n,o),l=je(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Yo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Gi,
Math.max(1,a.cell*Hi));for(let d=Math.max(1,Math.floor(r-n)+1);d<=i;d++){let[u,c]=[e.moments[d-1],e.moments[d]],m=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=
Do+(Vi-Do)*m;for(let h=0;h<c.alive.length;h++){let y=d===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(Me(e,h)?-1:1)*ji,[g,v]=L(u,h),[M,b]=L(c,h);if(g===
M&&v===b)continue;let w=y?o[h].x:b+.5,A=y?o[h].y:M+.5;s.strokeStyle=je(t,e,h),s.beginPath(),s.moveTo(re(a,v+.5+f),ne(a,g+.5+f)),s.lineTo(re(a,w+f),ne(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Zo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Fo+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Fo,l=ut(e,s,a);for(let d of Vt(s,a))l.includes(d)||Ki(t,L(a,d),i);for(let d of l)qi(t,L(a,d),i)}t.ctx.globalAlpha=1}function qi({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Uo(t,re(e,o+.5),ne(e,n+.5),Math.max(8,e.cell*Di)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ki({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,No(t,re(e,o+.5),ne(e,n+.5),Math.max(7,e.cell*zi)),
t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Jo({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[re(e,i)+s,ne(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function Xo({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Ae(t,re(e,n),ne(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Yi=.8,Zi=.92,Ji=15,Xi=7,Jr=9;function Qo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Qi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of dt(e,r).values())a.length>
Jr&&el(t,n[a[Jr-1]],a.length-Jr+1)}function Qi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=t,u=Me(e,n),[c,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?Zi:Yi)),y=je(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Kt:Ae)(i,c,m,h),h>Xi*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?d.paper:y,i.fill(),f&&(Ae(i,c,m,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Ji*a)return;let g=String(u?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:d.paper,i.fillText(
g,c,m+h*(u?.17:.03))}function el({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var tl=.46,rl=.86,nl=.66,es=.48,ol=.78,sl=.58;function ts(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)Gt(o,s,d)&&al(t,e,L(o,d),jt(o,s,d));a.globalAlpha=
1}function al({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=c=>re(e,n[1]+.5+s*c),l=c=>ne(e,n[0]+.5+a*c),d=qr(r,o)?ol:sl;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(es),l(es)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*u,l(d)+
s*u),t.lineTo(i(d)+a*u,l(d)-s*u),t.stroke()}function rs(t,e,r,n,o,s){let a=He[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,u=qr(e,[n[0]+a[0],n[1]+a[1]])?rl:
nl,c=tl*o.size,m=[re(l,o.x+a[1]*c),ne(l,o.y+a[0]*c),re(l,o.x+a[1]*u),ne(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[
d.paper,h*2.1],[je(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Bo(i,...m,l.cell*.2),i.stroke()}var Yt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Zt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),d=e.moments[l],u=r===l,c=qt(e,r),m=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),zo(t);for(let f of n.
viewers)c[f]?.alpha&&Ko(t,e,f,...Zr(e,f,r));Wo(t,e),n.axes&&Go(t,o),Yo(t,e,r,n.trail,c),Jo(t,d.contested??[],m),Zo(t,e,r),ts(t,e,l,m),c.forEach(({x:f,y:g,size:v},M)=>{
let b=Co(d,M)?.4:0,w=Yr(d,M)?1:b;w&&Xo(t,f,g,v,w*m)});let h=u?d:e.moments[Math.max(0,l-1)];if(Qo(t,e,h,c,n.numbers,o),u&&n.plan)for(let[f,g]of c.entries())g.alpha&&
rs(t,e,f,L(d,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Vo(t,e,...Zr(e,n.you,r)),qo(t,c[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:c[n.selected];y?.alpha&&ns(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),ns(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function ns({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var pt=(t,e)=>(e+.24)/(t+.24);function Jt(t,e,r,n,o,s){let a=r?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function os(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var il={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ve(t){let e=getComputedStyle(t),r=Object.entries(il).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var Ke=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,qe=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#s;#l;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Yt,...r},this.#s=new ResizeObserver(()=>this.#m()),this.#s.observe(e),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#p)}close(){this.#s.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#p),cancelAnimationFrame(this.#a)}get look(){return this.#t}set look(e){this.#t={...this.#t,...e},this.#c(),this.redraw()}show(e,r){this.#e=e,
this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#c(),this.redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};#p=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=Jt(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Ve(this.canvas)};Zt(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return os(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=dt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=qt(this.#e,Math.round(this.#r)),i=l=>{let[d,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(d-e,u-r)};return s.length?s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(pt(e,r)))}#m(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Xr(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Qr(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function ss(t){let e=Array.from({length:t.length+1},(r,n)=>ll(t,n));return Xr(t.config,t.map,e)}function ll(t,e){
let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),
everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var cl=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function as(){let t=[["pursu\
er",S("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",S("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",S("polygon",{points:cl,class:"\
filled-capture"})],["captured evader",S("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",S("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>p("li",{},S("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var ul={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function is(t){return S("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},S("path",{d:ul[t]}))}function mt(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},is(t))}function Xt(t){let e=mt("play","Play","Space",()=>t.toggle()),r=dl(t),
n=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=pl(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},mt("first","First step","Home",()=>t.move(-t.length)),mt("back","Step back","←",()=>t.move(-1)),
e,mt("forward","Step forward","→",()=>t.move(1)),mt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,r),a,s),l=(c,m={})=>{let h=p("i",
m);return h.style.left=`${100*c/Math.max(1,t.length)}%`,h},d=()=>{n.replaceChildren(...t.marks.map(c=>l(c))),o.replaceChildren(...t.ticks.map(({step:c,kind:m,size:h,
text:y})=>{let f=l(c,{class:m,title:`Step ${c}: ${y}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(is(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",u),t.addEventListener("s\
tate",u),t.addEventListener("state",d),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==r)&&ze(t,c)&&c.preventDefault()}),
u(),i}function dl(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function pl(t){let e=`Steps a second, or the whole in ${Nt} s (+ and -)`,r=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:It},`in ${Nt} s`),...lt.map(n=>p("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}var U=(t,e=2)=>t==null?"-":t.toFixed(e);function ls(t,e,r){return e===null||r===null?U(t):`${U(t)} (${U(e)} to ${U(r)})`}var cs=t=>t.toLocaleString("en-GB"),Ee=t=>t.
charAt(0).toUpperCase()+t.slice(1);function ht(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(d,u)=>(i+u)*a)}var ml=40,Qt=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Fe(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,ml).map((m,h)=>this.#n(m,h)));let l=a===null?i?.rates[s]:void 0,d=r.statistics.capture_rate,
u=l!==void 0&&Math.abs(d-l)<1e-6&&r.length===i?.lengths[s],c=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?c:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${U(d,3)} in ${r.length} steps.${i?` The cell says ${U(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${U(e)}`,"aria-label":`Episode ${r+1}, capture rate ${U(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,p("span",{class:"count"},r+1))}};var us=0,ds=1,hl=2,fl=176;function ms(t,e,r,n){let o=devicePixelRatio||1,s=Ve(t);t.width=t.height=fl*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[c,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(hl)&&(a.fillStyle=
s.obstacle,a.fillRect(c-l/2,m-l/2,l,l));let y=h(us)&&h(ds)?l*.18:0;h(us)&&ps(a,Ae,c+y,m+y,l*.74,s.evader),h(ds)&&ps(a,Kt,c-y,m-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function ps(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var hs="What it remembers: a number for each unit, from -1 to 1",er=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:hs});#l=null;#p=null;#c=null;#m=null;#d=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#i}show(e,r,n,o){this.#l?.free(),this.#l=e.world(n.config),
this.#c!==r&&(this.#p=null,this.#i!==null&&this.choose(null)),[this.#c,this.#m,this.#d]=[r,n,o]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#m;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,o,s,a]=[this.#m,this.#l,this.#c,this.#d,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},j(a,r.config.n_pursuers)));
let l={pursuers:te(o,"pursuer",s.pursuer),evaders:te(o,"evader",s.evader)};r.seek(n,e,l);let d=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;d.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(d);let u=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);ms(this.#r,r.config,u?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${j(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let c=d[a]??null;if(!u)return this.#u([],"It is gone.");let m=l[`${i}s`],
h=typeof m=="string"?null:n.answer(m,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),bl(h.memory));
let f=this.#p?.game(n)??null,g=typeof m=="string"?`The script "${m}" plays for it${c===null?"":`; it goes ${ce[c]}`}.`:m.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",v=[["network",y],["perfect",f?.marginal(a)??null]],M=b=>p("p",{class:"small muted"},b);this.#u([...f?[M(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...yl(v,c)],c===null?"The episode is over.":g)}#u(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function yl(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=p("div",{class:"action muted"},p("span"),...r.map(([s])=>p("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ce[a]),...r.flatMap(([,i])=>gl(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function gl(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function bl(t){
let e=Array.from(t,r=>{let n=p("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return p("div",{class:"units",role:"img","aria-label":hs},
...e)}function fs(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var ys="champion",gs=0,en=64,tn=100;var vl=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function bs(t,e){return Object.keys(e).find(r=>vl(e[r],t))??null}var ft="_",wl="n",ep=2n**64n-1n;var rn={fov:11,maxSteps:500,rewards:"paper"},xl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function xs(t,e){let r=i=>i.map(l=>Ml(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Sl(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ws(
t.rules,e),others:t.others?ws(t.others,e):"",rewards:o===rn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===rn.fov?"":String(t.fov),
limit:t.maxSteps===rn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(ft),pursuers:t.pursuers.map(vs).join(ft),
evaders:t.evaders.map(vs).join(ft),played:t.played.map(r).join(ft),next:t.next.every(i=>i===gs)?"":r(t.next)};return xl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function vs({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ws(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return bs(t,e.variants)??r.join(".")}function Sl(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(ft)}function Ml(t,e){if(typeof t=="number")return String(t);if(t===ys)return wl;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Al="/* the engine */";function Ss(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>nn(t(),e)},"What if?")}function nn(t,e){let r=t!==null&&t.match.n_agents<=tn&&Math.max(t.match.config.rows,t.match.config.
cols)<=en,n=r?xs(El(t.match,t.step),e):"",o=new TextDecoder().decode(jr("playground")).replace(Al,()=>Lt("script-engine")).replace("</noscript>",s=>r?s+fs(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function El(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
d=o*r.n_evaders+i-r.n_pursuers,u=c=>i>=r.n_pursuers&&!!c[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var on=.005,As=.05,Tl=["pursuer","evader"],Cl=4,Ye=new Map;function tr(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=Ye.get(n)??(Ct(e)?Promise.
resolve(null):kl(t,e,r));return Ye.delete(n),Ye.set(n,o),Ye.size>Cl&&Ye.delete([...Ye.keys()][0]),o}var Es=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
Ms=()=>new Promise(t=>setTimeout(t));async function kl(t,e,r){await Ms();let n=t.solution(e,r);for(;n.goBack();)await Ms();return n}function rr(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((d,u)=>a[u]+=d),e.playTurn(o);let i=n==="capture-rate"?on:As;
return Tl.map((l,d)=>({step:s+1,team:l,lost:a[d],payoff:n})).filter(l=>l.lost>=i)})}var nr=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:yt(e)})),Ts=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,yt=t=>`The ${t.team}s los\
e ${Ts(t)} against a perfect opponent`;function Cs(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${Ts(e)} \
against a perfect opponent.`}function ks({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,_r)];return o>s-As?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Rs(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=on).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-on?ce[o]:`${ce[o]} ${n.toFixed(2)}`).join(", ")}function or(t,e,r){if(r===0)return[{kind:"start",text:Rl(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>j(u,t.config.n_pursuers),a=ut(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),d=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Vt(n,o))!a.includes(u)&&!l.has(u)&&d.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return d.push(...i.map(({kind:u,text:c,agents:m})=>({kind:u,text:c,agents:m}))),r===t.length&&d.unshift({kind:"\
end",text:_l(t),agents:[]}),d}function Rl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function _l(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Ol=60,sr=class{element;player=new De(0,{speed:It,still:Ke()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#l=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#p=p("p",{class:"problem",role:"a\
lert"});#c=null;#m=null;#d=0;#i=!1;#h=0;#u=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=p("canvas",{"aria-label":"The match"});this.#e=new qe(o,{numbers:!1}),
this.#n=new Qt(r),this.inspector=new er(s=>this.#x(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p(
"div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&Ss(()=>this.shown,n)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p(
"div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),this.#p,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#l,as(),this.actions,this.
inspector.element),Xt(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#f()),r.on("rest",()=>this.player.pause()),this.#v(),this.#S(0,0)}get#o(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){
this.#c=e,this.#y()}playSoon(){this.#i=!0,this.#d||this.#g()}goTo(e){this.#h=e,!this.#d&&this.match&&this.#y()}#g(){!this.#i||!this.match||(this.#i=!1,this.player.
jump(0),Ke()||this.player.play())}#f(){this.#v(),clearTimeout(this.#d),this.#d=setTimeout(()=>this.#y(),Ol)}#y(){clearTimeout(this.#d),this.#d=0,this.player.pause(),
this.#v();let{selected:e}=this.#t,r=ae.map(s=>$t(this.#o,s,e[s])).find(Boolean)??"";if(this.#p.textContent=r,r||!this.#c)return;this.match=Pt(this.#c,this.#o,e);
let[n,o]=this.names(e);this.#m={pursuer:{name:n,policy:te(this.#o,"pursuer",e.pursuer)},evader:{name:o,policy:te(this.#o,"evader",e.evader)}},this.recording=ss(
this.match),this.#n.show(this.#o,this.match),this.inspector.show(this.#c,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=ko(this.recording),
this.#u=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#w(),this.#b(this.#c,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.#g()}async#b(e,r){let n=await tr(e,r.config);if(this.match!==r||!n)return;let o=e.world(r.config);r.seek(o,0),this.#u=rr(n,o,$l(
r)),o.free(),this.player.ticks=nr(this.#u),this.inspector.solution=n,this.#w()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#r[e];return[o.pursuer.script??
q("pursuer",r),o.evader.script??q("evader",n)]}#v(){let{episode:e,seed:r}=this.#t.selected,{payoff:n}=this.#o,[o,s]=this.names(this.#t.selected),a=r===null?e<n.
episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#a.replaceChildren(p("span",{class:"pursuer"},Ee(o))," agains\
t ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#w(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.
moments[r];this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#u.filter(o=>o.step===r).map(o=>p("li",{class:`loss-${o.
team}`},yt(o))),...or(e,this.recording,r).map(o=>p("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(e,r){this.#s.
replaceChildren(p("strong",{},e),` of ${this.#o.world.n_evaders} captured`,p("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},$l=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var Pl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Ll=5;function Te(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Pl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,d]=r(),u=o.shiftKey?Ll:1,{pursuer:c,evader:m}=e.selected;e.
select({pursuer:_s(c+u*a,l),evader:_s(m+u*i,d)}),o.preventDefault(),o.stopPropagation()})}var _s=(t,e)=>Math.min(e-1,Math.max(0,t));var Il=24,ar=7,$s=t=>t<Il&&matchMedia("(pointer: coarse)").matches;function Ps(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Os(e,o),Os(r,s)],[l,d]=[Math.min(ar,o),Math.
min(ar,s)],u=[];for(let y=a+l-1;y>=a;y--){u.push(p("span",{class:"pursuer"},y));for(let f=i;f<i+d;f++)u.push(Nl(t,y,f,n))}let c=Array.from({length:d},(y,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...u,m,...c);return h.style.gridTemplateColumns=`2.4rem repeat(${d}, minmax(0, 1fr))`,h.addEventListener("click",y=>y.stopPropagation()),
h}function Nl(t,e,r,n){let o=Fe(t,e,r)?.rate,s=p("button",{type:"button","aria-label":`${U(o)}: ${q("pursuer",e)} against ${q("evader",r)}`,onclick:()=>n({pursuer:e,
evader:r})},U(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[zt(o),Dt(o)]),s}var Os=(t,e)=>Math.max(0,Math.min(e-ar,t-Math.floor(ar/2)));var oe={left:52,bottom:46,top:76,right:84},ue=10,Ul=160,gt=oe.right-ue-14,Ce=oe.top-ue-14,ir=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=S("svg",
{"aria-hidden":"true"});#a=S("g");#s;#l=p("h2");#p=p("strong",{class:"rate numbers"});#c=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#d=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#l,this.#m),p("div",{class:"of-cell"},this.#p,this.#c));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,Ht("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).
observe(this.#s),this.#s.addEventListener("pointermove",o=>this.#v(o)),this.#s.addEventListener("pointerleave",()=>r.point({})),this.#s.addEventListener("click",
o=>this.#w(o)),this.#s.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Te(this.#s,
r,()=>this.#i.payoff.shape),this.#s.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#g()),r.on("hove\
r",()=>this.#g())}get#i(){return this.#r[this.#e.selected.run]}#h(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.
max(Ul,Math.min(n-oe.left-oe.right,o-oe.top-oe.bottom))/Math.max(e,r),i=Math.max(oe.left,(n-r*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(o-oe.top-oe.bottom-e*a)/
2),d={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};this.#d=d,Wt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[u,c,m]of[["left",i,
n],["top",l,o],["width",r*a,n],["height",e*a,o]])this.#t.style.setProperty(u,`${100*c/m}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute(
"viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(Bl(d),...Fl(d),...this.#o(d),this.#a),this.#g()}#u(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ls(e,r.pursuers.mean[s]??0,s),[d,u]=Is(e,r.evaders.mean[a]??0,a);return[S("cir\
cle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),S("circle",{class:"dot of-evaders",cx:d,cy:u,r:5})]}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
left:n,top:o,cell:s,rows:a,columns:i}=e,[l,d]=[n+i*s+ue,o-ue],u={class:"side"};return[S("rect",{...u,x:l,y:o,width:gt,height:a*s}),S("rect",{...u,x:n,y:d-Ce,width:i*
s,height:Ce}),...Ns(r.pursuers,(c,m)=>Ls(e,c,m),"of-pursuers"),...Ns(r.evaders,(c,m)=>Is(e,c,m),"of-evaders"),S("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"\
start"},"0"),S("text",{class:"tick",x:l+gt,y:o+a*s+16,"text-anchor":"end"},"1"),S("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),S("text",{class:"ti\
ck",x:n-6,y:d-Ce+8,"text-anchor":"end"},"1"),S("text",{class:"label of-pursuers",x:l+gt,y:o+a*s+34,"text-anchor":"end"},"captures"),S("text",{class:"label of-ev\
aders",x:n+i*s+ue,y:d-Ce+10,"text-anchor":"start"},"escapes")]}#g(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,
d=y=>s+(i-1-y)*a,u=[],c=(y,f)=>S("rect",{class:f,x:o,y:d(y),width:l*a+ue+gt,height:a}),m=(y,f)=>S("rect",{class:f,x:o+y*a,y:s-ue-Ce,width:a,height:ue+Ce+i*a});u.
push(c(r.pursuer,"strip pursuer"),m(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(c(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(
m(n.evader,"strip hover")),u.push(...this.#u(e));let h={x:o+r.evader*a,y:d(r.pursuer),width:a,height:a};u.push(S("rect",{class:"chosen under",...h}),S("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...u),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Fe(this.#i,n,o);this.#l.
replaceChildren(p("span",{class:"pursuer"},Ee(q("pursuer",n)))," against ",p("span",{class:"evader"},q("evader",o))),this.#p.textContent=s?U(s.rate,3):"-",this.#c.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"no episodes were played",this.#m.textContent=this.#y(n,o)}#y(e,r){let n=this.#i.findings?.generalization;
if(!n)return"";let o=(s,a)=>ls(s.mean[a]??null,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#b(e){
let r=this.#d;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/
r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,
evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#b(e);if(r){if(r.inside&&$s(this.#d.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?
{}:{evader:r.h}}),r.inside&&this.#x()}}#S(e,r){let n=Ps(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(o),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function Bl({left:t,top:e,cell:r,rows:n,columns:o}){let s=S("g",{class:"axes"}),a=e+n*r,i=l=>ht(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(o))s.append(S("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(S("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(S("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),S("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Fl({
left:t,top:e,cell:r,rows:n,columns:o}){let s=S("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;for(let u of["H","V"]){let c=`M${t} ${i}`;for(let m=1;m<=
a;m++){let[h,y]=[`H${t+m*r}`,`V${i-m*r}`];c+=u==="H"?h+y:y+h}s.append(S("path",{d:c,class:"under"}),S("path",{d:c}))}let[l,d]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[
s,S("text",{class:"on-cells",transform:`translate(${l} ${d}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var Ls=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[
t+o*r+ue+s*gt,e+(n-a-.5)*r],Is=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-ue-n*Ce];function Ns(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),o=[];return t.low&&t.high&&o.push(S("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(S("path",{class:`line ${r}`,
d:`M${n(t.mean).join("L")}`})),o}function ye(t,e,...r){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...r)}var Dl={present:"●",
absent:"○","cannot tell":"?"};function Us(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],d)=>{let u=zl(e.reasons[d]??
"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Dl[a]??""),p("div",{},p("p",{},p("strong",{},s),` ${a}`,p(
"span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ye("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("p",{},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${Ee(s)}.`)),p("ul",{class:"findings"},...n),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function zl(t){let[,e=""]=t.split(/, because (.*)/s);return Ee(e.replace(/\.$/,""))}function Bs({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>p(
"tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"numbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"\
heard"},"Settings other than the default"),...n),s=ye("Settings",`${e}, seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?p("div",{class:"\
wide-table"},o):null);return s.classList.add("settings"),{element:s}}function Fs(t,e,r){let{findings:n}=t;if(!n?.table.length)return null;let o=n.checkerboards.map(s=>Wl(t,s,(a,i)=>{e.select({pursuer:a,evader:i}),r()}));return{element:ye(
"Checkerboards","Two generations of each team: each generation of the pursuers is better against another one of the evaders. Click a cell to watch its match.",o.
length?p("div",{class:"boards"},...o):p("p",{},`No four cells differ by more than ${n.margin} in this way.`),o.length?p("p",{class:"small muted"},"The strongest\
 of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null)}}function Wl(t,{pursuers:e,evaders:r},n){
let o=(s,a)=>{let i=t.payoff.capture_rate[s][a],l=`${q("pursuer",s)} against ${q("evader",a)}: ${U(i)}`,d=p("button",{type:"button",class:"cell","aria-label":l,
onclick:()=>n(s,a)},U(i));return[d.style.backgroundColor,d.style.color]=[zt(i),Dt(i)],d};return p("div",{class:"miniature numbers"},p("span"),...r.map(s=>p("spa\
n",{class:"evader"},s)),...e.flatMap(s=>[p("span",{class:"pursuer"},s),...r.map(a=>o(s,a))]))}var lr={pursuer:"evader",evader:"pursuer"};function Ds(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${U(s)}, stripes ${U(a)}${i===null?"":` every ${i} generations`}`;return Hl(t,o,l,e)});return{element:ye("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...n.map(o=>o.element)),Ht("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function Hl(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(b,w)=>e==="pursuer"?t.payoff.
capture_rate[b][w]:1-t.payoff.capture_rate[w][b],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),u=d?.createImageData(a,s);for(let b=0;u&&
b<s;b++)for(let w=0;w<=Math.min(b,a-1);w++)u.data.set([...We(i(b,w)),255],4*((s-1-b)*a+w));u&&d?.putImageData(u,0,0);let c=S("rect",{class:"chosen",width:1,height:1}),
m=S("rect",{class:"chosen under",width:1,height:1}),h=S("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,c),y=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);Te(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${a} / ${s}`;let f=b=>{let w=y.
getBoundingClientRect(),A=Math.floor((b.clientX-w.left)/w.width*a),C=s-1-Math.floor((b.clientY-w.top)/w.height*s);return A>=0&&C<s&&A<=C?[C,A]:null},g=b=>({[e]:b[0],
[lr[e]]:b[1]});y.addEventListener("pointermove",b=>n.point(f(b)?g(f(b)):{})),y.addEventListener("pointerleave",()=>n.point({})),y.addEventListener("click",b=>f(
b)&&n.select(g(f(b))));let v=()=>{let b=n.hover[e]??n.selected[e],w=n.hover[lr[e]]??n.selected[lr[e]];for(let A of[c,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-b)),A.style.display=w<=b?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),y,p("p",{class:"smal\
l muted"},`horizontal: ${lr[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},r)),update:v}}var cr={left:46,right:12,top:10,bottom:42},zs={x:56,y:34};function sn(t,e,r,n){let[o,s]=[cr.left,cr.top],a=Math.max(o+40,t-cr.right),i=Math.max(s+40,e-cr.bottom),
l=(f,g,v)=>M=>g+(M-f.low)/(f.high-f.low||1)*(v-g),[d,u]=[l(r,o,a),l(n,i,s)],c=S("g"),m=S("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=S("g",
{class:"axes"});for(let f of ht(n.low,n.high,(i-s)/zs.y,n.whole))h.append(S("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),S("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ws(f)));for(let f of ht(r.low,r.high,(a-o)/zs.x,r.whole))h.append(S("text",{x:d(f),y:i+16,"text-anchor":"middle"},Ws(r.mirrored?
Math.abs(f):f)));return h.append(S("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),S("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),S("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(h,c),{root:m,marks:c,left:o,right:a,top:s,bottom:i,x:d,
y:u,at:f=>{let g=f-m.getBoundingClientRect().left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Ws=t=>String(Number(t.toPrecision(6))).replace("-","−");function an(t,e,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(S("path",{d:o,class:`line ${n}`}),
t.marks)}function Hs(t,{low:e,high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(S("path",{d:`\
M${[...o(r),...o(e).reverse()].join("L")}Z`,class:`band ${n}`}),t.marks)}function ln(t,e,r,n=null){let o=t.x(e);t.marks.append(S("line",{x1:o,x2:o,y1:t.top,y2:t.
bottom,class:`mark ${r}`})),n!==null&&t.marks.append(S("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function cn(...t){return p("p",{class:"legend small"},...t.
map(([e,r])=>p("span",{class:`key ${r}`},e)))}function un(t,e,r,n){let o=p("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),
s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:d}=o;l<50||d<50||(s=e(l,d),o.replaceChildren(s.root),
a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var dn=["of-pursuers","of-evaders","of-both"],Gl=2500,Gs="Arrow keys choose generations.",jl={low:0,high:1,label:"capture rate"};function js(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=Vl(n,r.window),d=i.at(-1)??1,u=i.length>Gl?"dense":"",c=(y,f)=>{let g=o.flatMap((v,M)=>v===
y&&(s[M]===f||s[M]===2)?[M]:[]);return g.length?[i[g[0]],i[g.at(-1)]]:null},m=un(`Capture rate in ${d} epochs of training. ${Gs}`,(y,f)=>{let g=sn(y,f,{low:0,high:d,
label:"epoch",whole:!0},jl);for(let[v,M]of[["raw",n],[u,l]])for(let[b,w]of dn.entries()){let A=M.map((C,E)=>s[E]===b||s[E+1]===b?C:null);A.some(C=>C!==null)&&an(
g,i,A,`${w} ${v}`)}return g},y=>ae.forEach((f,g)=>{let v=c(e.hover[f]??e.selected[f],g);v&&ln(y,(v[0]+v[1])/2,dn[g])}),y=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(y/a)-1)),g=o[f];s[f]!==1&&e.select({pursuer:Math.min(g,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(g,t.payoff.shape[1]-1)})});Te(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn","both teams learn"][y],dn[y]]);return{element:ye("Training",`${cs(r.
matches)} training matches. Lines: the generations that are selected.`,cn(...h),m.element),update:m.update}}function Vs(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=ae.flatMap(c=>[n[c].mean,n[c].low??[],n[c].high??[]]).flat().map(c=>c??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),d=Math.max(...t.payoff.shape)-1,u=un(`Elo ratings by generation. ${Gs}`,(c,m)=>{let h=sn(c,m,{low:0,high:d,
label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of ae)Hs(h,n[y],`of-${y}s`),an(h,o[y].map((f,g)=>g),o[y],`of-${y}s`);return h},c=>{
for(let m of ae){let h=e.hover[m]??e.selected[m];ln(c,h,`of-${m}s`,o[m][h]??null)}},(c,m,h)=>{let y=Math.round(c),f=h.clientY-m.root.getBoundingClientRect().top,
g=M=>Math.abs(m.y(o[M][y]??1/0)-f),v=g("pursuer")<=g("evader")?"pursuer":"evader";y>=0&&y<o[v].length&&e.select({[v]:y})});return Te(u.element,e,()=>t.payoff.shape),
{element:ye("Ratings",`One number for each generation, which cycles do not fit, with 95 % intervals over episodes. The game itself: ${U(r.offset,0)} points for \
the pursuers.`,cn(["pursuers","of-pursuers"],["evaders","of-evaders"]),u.element),update:u.update}}function Vl(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);
return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function qs(t,e,r){let n=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??ql(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(d=>d.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function ql(t,e,r){return[Us(t),js(t,e),Fs(t,e,r),Vs(
t,e),Ds(t,e),Bs(t)].filter(o=>o!==null)}var mr=Ba(aa(),1);var yn=125,fc=80,yc=10,ia=480,gc=[1,.8,.6,.4,.2],bc=5;async function la(t,e){let r=Math.min(1,pt(t.rows,t.cols)),[n,o]=[Math.round(ia*r),Math.round(ia*r/pt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[n,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=Ve(document.documentElement),l={ctx:a,colors:i,
grid:Jt(t.rows,t.cols,!1,n,o,1)},[d,u]=[vc(i,a),(0,mr.GIFEncoder)()];for(let c=0;c<yn;c++){let m=Math.min(1,c/(yn-yc))*(t.moments.length-1);Zt(l,t,m,{...Yt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,n,o),a.globalCompositeOperation="source-over",u.writeFrame((0,mr.applyPalette)(
a.getImageData(0,0,n,o).data,d),n,o,{palette:d,delay:fc}),c%bc===0&&(e(Math.round(100*c/yn)),await new Promise(h=>setTimeout(h)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function vc(t,e){let r=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),n=r(t.
paper);return Object.values(t).map(r).flatMap(o=>gc.map(s=>o.map((a,i)=>Math.round(n[i]+s*(a-n[i])))))}function ca(t,e){let r=Bt("Link to this step"),n=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"button",class:"save-gif",onclick:async()=>{if(!t.
recording)return;let{pursuer:l,evader:d}=e.selected;s.disabled=!0;let u=await la(t.recording,c=>n.textContent=`Drawing: ${c} %`);Ft(`pursuers-${l}-evaders-${d}.\
gif`,u),n.textContent=`Saved, ${(u.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=Ut("Share this match","share",s,kt()&&xo("The\
 link leads to this step in the same file. Nothing is sent anywhere.",r,n),n);return{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(
new Event("rest")),r.value=location.href,n.textContent="",a.showModal()}},"Share"),dialog:a}}var ua={pursuer:null,evader:null},hr=class extends EventTarget{#e;#r=ua;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...ua,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var fr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Qr(this.#e)],
this.recording=Xr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,
[Math.max(l,s),d],a)),typeof n=="number"?a[r]=n:l<=r&&r<d&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(Qr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var de=(t,e)=>ae[+(e>=t.n_pursuers)];function gn(t,e){let r=new fr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function Ze(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var yr=(t,e)=>t.over||Ze(t,e).out;function da(t,e,r){let n=gn(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!yr(n,e.seat);)n.step(e.policies,e.seat,r);return Ze(n,e.seat)}function pa(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function ma(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function ha(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function bn(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[wc(t,a,i,pa(o))],again:()=>bn(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&ma(s,a)})}
function wc(t,e,r,n){let o=de(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=d=>{let[u,c]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},d),p("td",{class:"track","aria-hidden":"true"},u),c)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,
c.textContent=String(o?m:h)}};i("You")(Ze(e,r.seat));for(let{name:d,policy:u}of n){let c=i(d);setTimeout(()=>c(da(t,r,u())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var fa=["·","↑","→","↓","←","↗","↘","↙","↖"];var xc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},vn=[8,1,5,4,0,2,7,3,6],Sc=[7,8,9,4,5,6,1,2,3],Mc=24,Ac=Math.tan(
Math.PI/8);function ga(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Sc.findIndex(o=>t.code===`Numpad${o}`),n=vn[r]??xc[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function ba(t){let e=vn.map(r=>p("button",{type:"button","aria-label":ce[r],onclick:()=>t(r)},fa[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",vn[o]>4&&!r))}}function ya(t,e,r){let n=Ac*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return To([0,0],r?[o(t),o(e)]:[t,e],r)}function va(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[d,u]=[s-i[0],a-i[1]],c=t.cellAt(s,a);Math.hypot(d,u)>=Mc?r(ya(u,d,l.diagonal)):c&&r(ya(c[0]-l.cell[0],
c[1]-l.cell[1],l.diagonal))})}function wa(t,e){let r=n=>{let o=e[n]-t[n],s=He.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${ce[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Ma="NUMPY\0",xa=Ma.length+2,Sa=64;function Aa(t){return yo(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Ec(r)])))}function Ec({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((xa+s.length+1)/Sa)*Sa-xa,i=Ma+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,d=new Uint8Array(i.length+l.byteLength);return d.set(Rt(i,!0)),d.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),d}var Tc="matrixworld episode 3";function Ea(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],d={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},c={},m=b=>{
for(let w of Object.keys(b))(c[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(n);h.reset(e.start);let y=[];m(d);for(let b of o)h.step(b),m({...d,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[w,...A]]of Object.entries({...d,...u})){let C=s+
+(b in d);g[b]={dtype:w,shape:[C,...A],data:f[w].from((c[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),M=b=>({dtype:"<U",shape:[],data:b});
return Aa({format:M(Tc),n_pursuers:v(n.n_pursuers),config:M(JSON.stringify(n)),seat:v(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Cc=[0,1,2,4,8],gr=class{element;player=new De(0,{speed:4,still:Ke()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=ba(e=>this.act(e));#l=p("select",{},...Cc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#p=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#m=p("label",{class:"play-choice"},this.#c,"Best move");#d=p("p",{class:"small muted play-keys",id:"play-keys"});#i=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Xt(this.player);#u=null;#o=null;#g=[];#f=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#r=new qe(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#A()),this.#p.addEventListener(
"change",()=>this.#x()),this.#c.addEventListener("change",()=>this.#E()),va(this.#r,()=>{let r=this.#f!==null&&this.#o&&L(this.#o.recording.moments.at(-1),this.#f);
return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#E()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),p("div",{class:"pl\
ay-stage"},this.#t),p("div",{class:"play-side"},this.#i,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),p("label",{class:"\
play-choice"},this.#p,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#h)}get played(){return this.#u&&{...this.#u.
played,moves:this.#g}}get live(){return this.#o}play(e){this.#S(gn(this.#e,e.played),e.played.seat,e.title),[this.#u,this.#g,this.#v]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),yr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#u=null,this.#S(e,r,n),this.#_()}stop(){
this.#A(),this.player.pause(),this.#u=null}act(e){let[r,n]=[this.#u,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#l.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return ze(this.player,e);let s=ga(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#A(),this.player.pause(),[this.#o,
this.#f]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#x(){this.#r.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#O()}}#M(e){this.#y=null,this.#b=this.player.ticks=[],this.#m.hidden=this.#c.disabled=!!Ct(e.config),
tr(this.#e,e.config,Es(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#T(),this.#E())})}#T(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=rr(r,n,e.actions),n.free(),this.player.ticks=nr(this.#b)}get#C(){return this.#c.checked&&this.#u&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#O(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#A(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#u.played,this.#o];n.step(e,r,this.#v),this.#g.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(n.length-this.player.step),yr(n,r)&&this.#R()}#R(){this.#A();let[e,r,n]=[this.#u,this.#o,this.played],o=kt()?e.link(
n):null;this.#i.replaceChildren(p("h3",{id:"play-headline"},_c(r,n.seat)),...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},"Watch it"),p("button",{type:"button",onclick:()=>this.#$(r,n.seat)},"Save"),
o&&p("button",{type:"button",onclick:({currentTarget:a})=>$c(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#b.filter(({team:a})=>a===de(
r.config,n.seat));s.length&&this.#i.children[0].after(p("p",{class:"small muted"},Cs(s))),this.#i.focus({preventScroll:!0}),this.#i.scrollIntoView({block:"neare\
st"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),Ke()||this.player.play()}#$(e,r){Ft(`${j(r,e.config.n_pursuers)}\
-${e.length}-steps.npz`,Ea(this.#e,e,r))}#E(){let[e,r,{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let o=or(e,e.recording,n).filter(({agents:l})=>r===
null||l.includes(r)),s=this.#u&&n===0,a=s?[kc(e.config,r),this.#u.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(
Rc(e,n,r)),a.push(...this.#b.filter(l=>l.step===n).map(yt));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${Rs(i,r)||"decided in its turn"}\
; ${ks(this.#y,i,n)}`),this.#x(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function kc(t,e){let r=t.rules.capture==="SURROUND";return de(
t,e)==="evader"?`Run away: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"sur\
round them with your team":"move onto their cells"}`}function Rc({config:t,recording:e},r,n){let o=e.moments[r],a=de(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])
return"";let i=L(o,n),l=c=>{let[m,h]=L(o,c);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},d=Array.from({length:o.alive.length},(c,m)=>m).filter(c=>de(t,c)===
a&&o.alive[c]&&!o.captured[c-t.n_pursuers]&&2*l(c)<t.fov);if(!d.length)return`No ${a} in view`;let u=d.reduce((c,m)=>l(m)<l(c)?m:c);return`Nearest ${a}: ${wa(i,
L(o,u))}`}function _c(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[Ze(t,e),t];return de(s,e)==="pursuer"?`Your team captured ${o} of ${Oc(s)} in ${r} steps\
.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var Oc=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function $c(t,e){let r=Bt("Link \
to this match");r.value=e,t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var br=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",s=>this.view?.key(s)&&s.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,r=""){this.#a=e;let n=ot(r,this.#e,this.#r.selected),o=ha(new URLSearchParams(r.replace(/^#/,"")),
this.#e[n.run].world);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=n<r.
length?n:0,a=(c,m)=>!!r.alive[m*r.n_agents+c],i=Array.from({length:r.n_agents},(c,m)=>(m+r.config.n_pursuers)%r.n_agents),l=o??i.find(c=>a(c,s)),d=a(l,s)?s:0,u=Array.
from({length:d},(c,m)=>r.actions[m*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:d,moves:u})}play(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||ae.some(
g=>$t(o,g,e[g])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:d}=e,u=de(o.world,r.seat),c=o.teams[u].kept.map(g=>({name:o.teams[u].script??`generation ${g}`,
text:"",policy:()=>te(o,u,g)}));this.view||(this.view=new gr(n),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Clo\
se"),this.view.element)),this.dialog.open||this.dialog.showModal();let m=`You are ${j(r.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,h={pursuer:te(
o,"pursuer",a),evader:te(o,"evader",i)},y={config:o.world,seed:BigInt(d??o.seeds[a][i]),episode:l,policies:h,...r},f={run:s,pursuers:a,evaders:i,episode:l,...d===
null?{}:{seed:d}};bn(n,this.view,m,y,c,this.#n?f:null)}};var ge=bo(),{runs:X}=ge,[Pc,Lc]=X[0].payoff.shape,Ic=ot(location.hash,X,{run:0,pursuer:Pc-1,evader:Lc-1,episode:0,seed:null}),{step:Ta,...Nc}=Ic,K=new hr(Nc),G=new sr(
X,K,ge.playground),Ca=new ir(X,K),wt=new br(X,K,G),wn=Ao(),Uc=location.hash,{button:Bc,dialog:Fc}=ca(G,K);G.actions.append(Bc);var vt=null,ka=p("span",{class:"t\
old","aria-live":"polite"}),Ra=()=>{ka.textContent=X[K.selected.run].findings?.sentence??""};K.on("run",Ra);Ra();var _a=()=>{G.playSoon(),G.reveal()},Dc="Each c\
ell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";document.getElementById("page").replaceWith(Jn(ge.heading,
p("span",{},ka,p("span",{class:"small muted"},Dc)),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>wn.showModal()},
"?")),...ge.note?[p("aside",{class:"note small muted"},ge.note)]:[],Mo(X,K),p("main",{class:"stages"},Ca.element,G.element),qs(X,K,_a),p("footer",{class:"muted \
small"},`${ge.title} · matrixworld ${ge.version}`),wt.dialog,wn,Fc);Object.assign(window,{matrixworldExplorer:{get match(){return G.match},get step(){return G.
player.step},get pace(){return G.player.pace},get playing(){return wt.view},play:t=>vt&&Pt(vt,X[K.selected.run],{...K.selected,episode:t}),get shape(){return X[K.
selected.run].payoff.shape}}});Ca.element.addEventListener("play",_a);G.goTo(Ta);Ta||G.playSoon();Qn(X,K,G);Eo(X,K,G,wn,()=>wt.open(),()=>nn(G.shown,ge.playground));
window.addEventListener("hashchange",({newURL:t})=>vt&&wt.start(vt,new URL(t).hash));ge.growing&&eo(X,K,()=>G.player.playing||document.querySelector("dialog[ope\
n]")!==null);requestAnimationFrame(()=>setTimeout(()=>{Kn().then(t=>{vt=t,G.start(t),wt.start(t,Uc),document.body.dataset.ready="true"},t=>{G.element.prepend(p(
"p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
