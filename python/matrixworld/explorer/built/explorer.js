/* built from web/ by "npm run build"; sources 7135964938b05a4197fe44ab37a32bccaaae4ea4ade19f51f76b6886a8e8e14e */
"use strict";(()=>{var Ta=Object.create;var vn=Object.defineProperty;var Ca=Object.getOwnPropertyDescriptor;var ka=Object.getOwnPropertyNames;var Ra=Object.getPrototypeOf,_a=Object.prototype.hasOwnProperty;var $a=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(r){throw e=0,r}};var Oa=(t,e,r,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of ka(e))!_a.call(t,o)&&o!==r&&vn(t,o,{get:()=>e[o],enumerable:!(n=Ca(e,o))||n.enumerable});
return t};var Pa=(t,e,r)=>(r=t!=null?Ta(Ra(t)):{},Oa(e||!t||!t.__esModule?vn(r,"default",{value:t,enumerable:!0}):r,t));var ra=$a(mn=>{var qs=Object.defineProperty,Wl=t=>qs(t,"__esModule",{value:!0}),Hl=(t,e)=>{for(var r in e)qs(t,r,{get:e[r],enumerable:!0})};Wl(mn);Hl(mn,{GIFEncoder:()=>ea,
applyPalette:()=>Xl,default:()=>lc,nearestColor:()=>rc,nearestColorIndex:()=>Xs,nearestColorIndexWithDistance:()=>Qs,prequantize:()=>Jl,quantize:()=>Yl,snapColorsToPalette:()=>tc});
var Gl={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Ks(t=256){let e=0,r=new Uint8Array(t);return{get buffer(){return r.buffer},reset(){e=0},bytesView(){return r.subarray(0,e)},bytes(){return r.slice(0,e)},
writeByte(o){n(e+1),r[e]=o,e++},writeBytes(o,s=0,a=o.length){n(e+a);for(let i=0;i<a;i++)r[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){n(e+a),r.set(o.subarray(
s,s+a),e),e+=a}};function n(o){var s=r.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=r;r=new Uint8Array(
o),e>0&&r.set(i.subarray(0,e),0)}}var un=12,Gs=5003,jl=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Vl(t,e,r,n,o=Ks(512),s=new Uint8Array(
256),a=new Int32Array(Gs),i=new Int32Array(Gs)){let l=a.length,d=Math.max(2,n);s.fill(0),i.fill(0),a.fill(-1);let u=0,c=0,m=d+1,h=m,y=!1,f=h,g=(1<<f)-1,v=1<<m-1,
S=v+1,b=v+2,w=0,A=r[0],C=0;for(let x=l;x<65536;x*=2)++C;C=8-C,o.writeByte(d),T(v);let E=r.length;for(let x=1;x<E;x++)e:{let O=r[x],_=(O<<un)+A,k=O<<C^A;if(a[k]===
_){A=i[k];break e}let ee=k===0?1:l-k;for(;a[k]>=0;)if(k-=ee,k<0&&(k+=l),a[k]===_){A=i[k];break e}T(A),A=O,b<1<<un?(i[k]=b++,a[k]=_):(a.fill(-1),b=v+2,y=!0,T(v))}
return T(A),T(S),o.writeByte(0),o.bytesView();function T(x){for(u&=jl[c],c>0?u|=x<<c:u=x,c+=f;c>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),u>>=8,c-=8;if((b>g||y)&&(y?(f=h,g=(1<<f)-1,y=!1):(++f,g=f===un?1<<f:(1<<f)-1)),x==S){for(;c>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),u>>=8,c-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var ql=Vl;function Ys(t,e,r){return t<<8&63488|e<<2&992|r>>3}function Zs(t,e,r,n){return t>>
4|e&240|(r&240)<<4|(n&240)<<8}function Js(t,e,r){return t>>4<<8|e&240|r>>4}function lr(t,e,r){return t<e?e:t>r?r:t}function At(t){return t*t}function js(t,e,r){
var n=0,o=1e100;let s=t[e],a=s.cnt,i=s.ac,l=s.rc,d=s.gc,u=s.bc;for(var c=s.fw;c!=0;c=t[c].fw){let h=t[c],y=h.cnt,f=a*y/(a+y);if(!(f>=o)){var m=0;r&&(m+=f*At(h.ac-
i),m>=o)||(m+=f*At(h.rc-l),!(m>=o)&&(m+=f*At(h.gc-d),!(m>=o)&&(m+=f*At(h.bc-u),!(m>=o)&&(o=m,n=c))))}}s.err=o,s.nn=n}function dn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,
nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function Kl(t,e){let r=e==="rgb444"?4096:65536,n=new Array(r),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>
24&255,l=a>>16&255,d=a>>8&255,u=a&255,c=Zs(u,d,l,i),m=c in n?n[c]:n[c]=dn();m.rc+=u,m.gc+=d,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],
i=a>>16&255,l=a>>8&255,d=a&255,u=Js(d,l,i),c=u in n?n[u]:n[u]=dn();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,d=a&
255,u=Ys(d,l,i),c=u in n?n[u]:n[u]=dn();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}return n}function Yl(t,e,r={}){let{format:n="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,
clearAlphaThreshold:a=0,oneBitAlpha:i=!1}=r;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof
Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),d=r.useSqrt!==!1,u=n==="rgba4444",c=Kl(l,n),m=c.length,
h=m-1,y=new Uint32Array(m+1);for(var f=0,v=0;v<m;++v){let P=c[v];if(P!=null){var g=1/P.cnt;u&&(P.ac*=g),P.rc*=g,P.gc*=g,P.bc*=g,c[f++]=P}}At(e)/f<.022&&(d=!1);for(var v=0;v<
f-1;++v)c[v].fw=v+1,c[v+1].bk=v,d&&(c[v].cnt=Math.sqrt(c[v].cnt));d&&(c[v].cnt=Math.sqrt(c[v].cnt));var S,b,w;for(v=0;v<f;++v){js(c,v,!1);var A=c[v].err;for(b=++y[0];b>
1&&(w=b>>1,!(c[S=y[w]].err<=A));b=w)y[b]=S;y[b]=v}var C=f-e;for(v=0;v<C;){for(var E;;){var T=y[1];if(E=c[T],E.tm>=E.mtm&&c[E.nn].mtm<=E.tm)break;E.mtm==h?T=y[1]=
y[y[0]--]:(js(c,T,!1),E.tm=v);var A=c[T].err;for(b=1;(w=b+b)<=y[0]&&(w<y[0]&&c[y[w]].err>c[y[w+1]].err&&w++,!(A<=c[S=y[w]].err));b=w)y[b]=S;y[b]=T}var x=c[E.nn],
O=E.cnt,_=x.cnt,g=1/(O+_);u&&(E.ac=g*(O*E.ac+_*x.ac)),E.rc=g*(O*E.rc+_*x.rc),E.gc=g*(O*E.gc+_*x.gc),E.bc=g*(O*E.bc+_*x.bc),E.cnt+=x.cnt,E.mtm=++v,c[x.bk].fw=x.fw,
c[x.fw].bk=x.bk,x.mtm=h}let k=[];var ee=0;for(v=0;;++ee){let z=lr(Math.round(c[v].rc),0,255),P=lr(Math.round(c[v].gc),0,255),B=lr(Math.round(c[v].bc),0,255),$=255;
u&&($=lr(Math.round(c[v].ac),0,255),i&&($=$<=(typeof i=="number"?i:127)?0:255),o&&$<=a&&(z=P=B=s,$=0));let W=u?[z,P,B,$]:[z,P,B];if(Zl(k,W)||k.push(W),(v=c[v].fw)==
0)break}return k}function Zl(t,e){for(let r=0;r<t.length;r++){let n=t[r],o=n[0]===e[0]&&n[1]===e[1]&&n[2]===e[2],s=n.length>=4&&e.length>=4?n[3]===e[3]:!0;if(o&&
s)return!0}return!1}function ur(t,e){var r=0,n;for(n=0;n<t.length;n++){let o=t[n]-e[n];r+=o*o}return r}function cr(t,e){return e>1?Math.round(t/e)*e:t}function Jl(t,{
roundRGB:e=5,roundAlpha:r=10,oneBitAlpha:n=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,d=a>>8&255,u=a&
255;i=cr(i,r),n&&(i=i<=(typeof n=="number"?n:127)?0:255),u=cr(u,e),d=cr(d,e),l=cr(l,e),o[s]=i<<24|l<<16|d<<8|u<<0}}function Xl(t,e,r="rgb565"){if(!t||!t.buffer)
throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expecte\
d RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let n=new Uint32Array(t.buffer),o=n.length,s=r==="\
rgb444"?4096:65536,a=new Uint8Array(o),i=new Array(s),l=r==="rgba4444";if(r==="rgba4444")for(let d=0;d<o;d++){let u=n[d],c=u>>24&255,m=u>>16&255,h=u>>8&255,y=u&
255,f=Zs(y,h,m,c),g=f in i?i[f]:i[f]=Ql(y,h,m,c,e);a[d]=g}else{let d=r==="rgb444"?Js:Ys;for(let u=0;u<o;u++){let c=n[u],m=c>>16&255,h=c>>8&255,y=c&255,f=d(y,h,m),
g=f in i?i[f]:i[f]=ec(y,h,m,e);a[u]=g}}return a}function Ql(t,e,r,n,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],d=l[3],u=Pe(d-n);if(u>a)continue;let c=l[0];
if(u+=Pe(c-t),u>a)continue;let m=l[1];if(u+=Pe(m-e),u>a)continue;let h=l[2];u+=Pe(h-r),!(u>a)&&(a=u,s=i)}return s}function ec(t,e,r,n){let o=0,s=1e100;for(let a=0;a<
n.length;a++){let i=n[a],l=i[0],d=Pe(l-t);if(d>s)continue;let u=i[1];if(d+=Pe(u-e),d>s)continue;let c=i[2];d+=Pe(c-r),!(d>s)&&(s=d,o=a)}return o}function tc(t,e,r=5){
if(!t.length||!e.length)return;let n=t.map(a=>a.slice(0,3)),o=r*r,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>
s?i=i.slice(0,3):i=i.slice();let l=Qs(n,i.slice(0,3),ur),d=l[0],u=l[1];u>0&&u<=o&&(t[d]=i)}}function Pe(t){return t*t}function Xs(t,e,r=ur){let n=1/0,o=-1;for(let s=0;s<
t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return o}function Qs(t,e,r=ur){let n=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return[
o,n]}function rc(t,e,r=ur){return t[Xs(t,e,r)]}function ea(t={}){let{initialCapacity:e=4096,auto:r=!0}=t,n=Ks(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),
i=new Int32Array(o),l=!1;return{reset(){n.reset(),l=!1},finish(){n.writeByte(Gl.trailer)},bytes(){return n.bytes()},bytesView(){return n.bytesView()},get buffer(){
return n.buffer},get stream(){return n},writeHeader:d,writeFrame(u,c,m,h={}){let{transparent:y=!1,transparentIndex:f=0,delay:g=0,palette:v=null,repeat:S=0,colorDepth:b=8,
dispose:w=-1}=h,A=!1;if(r?l||(A=!0,d(),l=!0):A=!!h.first,c=Math.max(0,Math.floor(c)),m=Math.max(0,Math.floor(m)),A){if(!v)throw new Error("First frame must incl\
ude a { palette } option");oc(n,c,m,v,b),Vs(n,v),S>=0&&sc(n,S)}let C=Math.round(g/10);nc(n,w,C,y,f);let E=!!v&&!A;ac(n,c,m,E?v:null),E&&Vs(n,v),ic(n,u,c,m,b,s,a,
i)}};function d(){ta(n,"GIF89a")}}function nc(t,e,r,n,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,n=!1);var s,a;n?(s=1,a=2):(s=0,a=0),e>=0&&(a=
e&7),a<<=2,t.writeByte(0|a|0|s),Ee(t,r),t.writeByte(o||0),t.writeByte(0)}function oc(t,e,r,n,o=8){let i=pn(n.length)-1,l=128|o-1<<4|0|i,d=0,u=0;Ee(t,e),Ee(t,r),
t.writeBytes([l,d,u])}function sc(t,e){t.writeByte(33),t.writeByte(255),t.writeByte(11),ta(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Ee(t,e),t.writeByte(0)}
function Vs(t,e){let r=1<<pn(e.length);for(let n=0;n<r;n++){let o=[0,0,0];n<e.length&&(o=e[n]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function ac(t,e,r,n){
if(t.writeByte(44),Ee(t,0),Ee(t,0),Ee(t,e),Ee(t,r),n){let a=pn(n.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function ic(t,e,r,n,o=8,s,a,i){ql(r,n,e,o,t,s,
a,i)}function Ee(t,e){t.writeByte(e&255),t.writeByte(e>>8&255)}function ta(t,e){for(var r=0;r<e.length;r++)t.writeByte(e.charCodeAt(r))}function pn(t){return Math.
max(Math.ceil(Math.log2(t)),1)}var lc=ea});var wn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ot={DISAPPEAR:0,REACH:1,BOUNCE:2},xn={OCCUPATION:0,SURROUND:1},Sn={FAULT:0,INVOLVED:1};var br=["obstacle","teammate","adversary"],vr=["vertex","edge","chain"],Mn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],wr=["p\
ursuer_{number}","evader_{number}"],An={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},st={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},En="{event}: {outcome}",xr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Tn={free:".GS",blocked:"#@OTW"};var Be=1+Mn.length;function at(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function V(t,e){return t<e?at(wr[0],{number:t}):at(wr[1],{number:t-e})}function La(t,e){
let[r,n,o,s,a,i,l,...d]=Array.from(t),u=a<0?[s]:[s,a],[c,m,h]=d.map(v=>u.filter((S,b)=>v>>b&1)),y=u.map(v=>V(v,e)),f=at(An[a<0?"obstacle":vr[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=at(En,{event:f,outcome:Ia(u.length,m,h,e)});return{kind:br[n],form:vr[o],agents:u,cell:[i,l],at_fault:c,held:m,doomed:h,turn:r,
text:g}}function Ia(t,e,r,n){if(t===2&&e.length===2)return st["both held"];if(t===2&&r.length===2)return st["both doomed"];let o=s=>a=>at(st[s],{agent:V(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||st.none}function kt(t,e){let r=[];for(let n=0;n<t.length;n+=Be)r.push(La(t.subarray(n+1,n+Be),e));
return r}var ve=class extends Error{name="EngineError"};function F(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new ve(
`${t}: expected ${e}, got ${n}`)}var Fe=class{bytes;constructor(e){this.bytes=e}},Rn=0,Mr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Cn=4,kn=4,Na=new TextEncoder,
Ua=new TextDecoder;function Ba(t){for(let e=Mr.length-1;e>Rn;--e)if(t instanceof Mr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Sr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Fa(t){return Na.encode(`${t}\0`)}var Ar=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Fa(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Fe,l=i?a.bytes:
a;return[this.text(s),i?Rn:Ba(l),l.length,this.copy(Sr(l))]}),o=this.copy(Sr(Int32Array.from(n)));return this.copy(Sr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function _n(t,e){let r=t.HEAPU8;return Ua.decode(r.subarray(e,r.indexOf(0,e)))}function De(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Cn,n=e[r+1]/Cn,o={};for(let s=n;s<n+e[r]*kn;s+=kn){let a=Mr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[_n(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function we(t,e){let r=new Ar(t);try{let n=e(r);if(n===0)throw new ve(_n(t,t._last_error()));return n}finally{r.free()}}var Da=2**31-1,$n=["none","elman","gru"],za=2n**64n-1n,Wa=34028234663852886e22;function he(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Da)throw F(
t,"an integer",e);return Int32Array.of(e)}function Rt(t,e){if(typeof e!="boolean")throw F(t,"true or false",e);return new Fe(Uint8Array.of(Number(e)))}function Te(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw F(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Er(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Wa))throw F(t,"a finite number",e);return e}function ze(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>za)throw F(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ha(t){return{"rules.interaction":Te("interactio\
n",t.interaction,wn),"rules.obstacle":Te("obstacle",t.obstacle,ot),"rules.teammate":Te("teammate",t.teammate,ot),"rules.evader":Te("evader",t.evader,ot),"rules.\
pursuer":Te("pursuer",t.pursuer,ot),"rules.capture":Te("capture",t.capture,xn),"rules.captured_disappear":Rt("captured_disappear",t.captured_disappear)}}function On(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw F(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Er(t,n))}function Ga(t){let e=(r,n)=>Float32Array.
of(Er(r,t[r]),Er(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":On("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":On("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,Sn),"rewards.capture_repeats":Rt("capture_repeats",t.capture_repeats)}}function Ln(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Tn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw F(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw F(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function In(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function We(t){In(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ha(t.rules),...Ga(t.rewards),rows:he("rows",t.rows),cols:he("cols",t.cols),n_pursuers:he("n_pursuers",t.n_pursuers),n_evaders:he("n_evaders",t.n_evaders),fov:he(
"fov",t.fov),diagonal:Rt("diagonal",t.diagonal),max_steps:he("max_steps",t.max_steps),density:Float64Array.of(e),map:Ln(t.obstacles)}}function Pn(t,e){return Int32Array.
from((e??[]).flat(),r=>he(t,r)[0])}function Nn(t,e){return In(t.obstacles,e),{seed:ze("seed",t.seed??0n),episode:ze("episode",t.episode??0),pursuers:Pn("pursuer\
s",t.pursuers),evaders:Pn("evaders",t.evaders),map:Ln(t.obstacles)}}function _t(t){return{actions:Int32Array.from(t,e=>he("actions",e)[0])}}function He(t){if(typeof t==
"string"){if(!Object.hasOwn(xr,t))throw F("policy",`one of ${Object.keys(xr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw F("activation","'relu' or 'tanh'",t.activation);if(!$n.includes(t.memory))throw F("memory",`one of ${$n.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>he("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Rt("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var ja=["first_turn","terminated","truncated"];function Un(t){let e={...t};for(let r of ja)e[r]=new Fe(t[r]);return e}var Bn="statistics.",$t=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Fn(Dn(o),0),Object.assign(this,o),this.first_conflict=Va(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Be,n*Be);return kt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function Va(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Be)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Fn(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var Dn=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(Bn)?[[e.slice(Bn.length),r]]:[]));function zn(t,e,r,n){let o=[We(r.config),He(r.pursuers),He(r.evaders),
n];return we(t,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return t[e](a,i,l,d)}),De(t)}function Wn(t,e,r,n){let o={seed:ze("seed",r),episode:ze("episode",n)};return new $t(
e.config,r,n,zn(t,"_play_match",e,o))}function Tr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let o=zn(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return Dn(o)}function Hn(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:ze("seed",r)},s=Tr(t,e,o,n);return Array.
from({length:n},(a,i)=>Fn(s,i))}var qa=7e6,Ka=new FinalizationRegistry(([t,e])=>t._states_free(e));function Ya({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,d=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",c=t.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(v,S)=>c?f:(f+S)/(S+1)).reduce((v,S)=>v*S,1),h=m(l+Number(d),s)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function Ot(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Ya(t)>qa?"the world is too large to be solved on the page":""}var Cr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,d]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<d),c=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(c),play:o},{agents:u.filter(m=>!c(m)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((d,u)=>d*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,d,u)=>l+
d*this.matrix[r*s.length+u],0),i=o.reduce((l,d,u)=>l+d*this.matrix[u*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},kr=60,it=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=we(e,i=>e._states_new(i.arrays(We(r)))),Ka.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,kr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new Cr(e,a):null}call(e){
return we(this.engine,e),De(this.engine)}};var Gn=new FinalizationRegistry(([t,e])=>t._world_free(e)),lt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=we(e,n=>e._world_new(n.arrays(We(r)))),Gn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Gn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Nn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=_t(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=_t(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
He(e),_t(n)],{actions:d}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(d)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return kt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=He(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Za(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Un(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return we(this.engine,e),De(this.engine)}};function Za(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Rr=class{compiled;constructor(e){this.compiled=e}world(e){return new lt(this.compiled,e)}solution(e,r="capture-rate"){return new it(this.compiled,e,r)}match(e,r,n,o,s=0){
return Wn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return Hn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return Tr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},jn;function Vn(t=globalThis.matrixworldEngine){return jn??=Ja(t),jn}async function Ja(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Rr(await t({wasmBinary:e}))}var Xa="http://www.w3.org/2000/svg";function p(t,e={},...r){return qn(document.createElement(t),e,r)}function M(t,e={},...r){return qn(document.createElementNS(
Xa,t),e,r)}function qn(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(Qa).map(n=>typeof n=="number"?String(n):n)),t}function Qa(t){return t!=null&&t!==!1}var ct=()=>["file:","http:","https:"].
includes(location.protocol);async function Kn(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}function ei(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function _r(){document.documentElement.
dataset.theme=ei()?"light":"dark"}if(typeof document<"u"){let t=document.documentElement.dataset,e=t.theme;addEventListener("beforeprint",()=>{e=t.theme,t.theme=
"light"}),addEventListener("afterprint",()=>{e?t.theme=e:delete t.theme})}function Yn(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:_r},"◐")}var Zn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,Yn()));var ti=2n**64n-1n;function ut(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(d,u,c)=>{let m=n.get(d)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):c},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ti?l:null,step:o("step",1/0,0)}}function Jn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:d,episode:u,seed:c}=e.selected,m={run:i,pursuers:l,evaders:d,episode:u,...c===null?{}:{seed:c},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(m).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=ut(location.
hash,t,e.selected);for(let d of document.querySelectorAll("dialog[open]"))d.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var N=Uint8Array,J=Uint16Array,Fr=Int32Array,Lt=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),It=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Lr=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),no=function(t,e){for(var r=new J(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Fr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},oo=no(Lt,2),so=oo.b,Ir=oo.r;so[28]=258,Ir[258]=28;var ao=no(
It,0),ri=ao.b,Xn=ao.r,Nr=new J(32768);for(R=0;R<32768;++R)fe=(R&43690)>>1|(R&21845)<<1,fe=(fe&52428)>>2|(fe&13107)<<2,fe=(fe&61680)>>4|(fe&3855)<<4,Nr[R]=((fe&65280)>>
8|(fe&255)<<8)>>1;var fe,R,ce=(function(t,e,r){for(var n=t.length,o=0,s=new J(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new J(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new J(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var d=o<<4|t[o],u=e-t[o],c=a[t[o]-1]++<<u,m=c|(1<<u)-1;c<=m;++c)i[Nr[c]>>l]=d}else for(i=new J(
n),o=0;o<n;++o)t[o]&&(i[o]=Nr[a[t[o]-1]++]>>15-t[o]);return i}),xe=new N(288);for(R=0;R<144;++R)xe[R]=8;var R;for(R=144;R<256;++R)xe[R]=9;var R;for(R=256;R<280;++R)
xe[R]=7;var R;for(R=280;R<288;++R)xe[R]=8;var R,mt=new N(32);for(R=0;R<32;++R)mt[R]=5;var R,ni=ce(xe,9,0),oi=ce(xe,9,1),si=ce(mt,5,0),ai=ce(mt,5,1),$r=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},se=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Or=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Dr=function(t){return(t+7)/8|0},zr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new N(t.subarray(
e,r))};var ii=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(t,e,r){var n=new Error(e||ii[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,q),!r)throw n;return n},li=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new N(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new N(o*3));var d=function(rt){var nt=r.length;if(rt>nt){var Ue=new N(Math.max(nt*2,rt));Ue.set(r),r=Ue}},u=e.f||0,c=e.
p||0,m=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,v=o*8;do{if(!h){u=se(t,c,1);var S=se(t,c+1,3);if(c+=3,S)if(S==1)h=oi,y=ai,f=9,g=5;else if(S==2){var C=se(t,c,31)+257,E=se(
t,c+10,15)+4,T=C+se(t,c+5,31)+1;c+=14;for(var x=new N(T),O=new N(19),_=0;_<E;++_)O[Lr[_]]=se(t,c+_*3,7);c+=E*3;for(var k=$r(O),ee=(1<<k)-1,z=ce(O,k,1),_=0;_<T;){
var P=z[se(t,c,ee)];c+=P&15;var b=P>>4;if(b<16)x[_++]=b;else{var B=0,$=0;for(b==16?($=3+se(t,c,3),c+=2,B=x[_-1]):b==17?($=3+se(t,c,7),c+=3):b==18&&($=11+se(t,c,
127),c+=7);$--;)x[_++]=B}}var W=x.subarray(0,C),D=x.subarray(C);f=$r(W),g=$r(D),h=ce(W,f,1),y=ce(D,g,1)}else q(1);else{var b=Dr(c)+4,w=t[b-4]|t[b-3]<<8,A=b+w;if(A>
o){l&&q(0);break}i&&d(m+w),r.set(t.subarray(b,A),m),e.b=m+=w,e.p=c=A*8,e.f=u;continue}if(c>v){l&&q(0);break}}i&&d(m+131072);for(var Le=(1<<f)-1,te=(1<<g)-1,me=c;;me=
c){var B=h[Or(t,c)&Le],Y=B>>4;if(c+=B&15,c>v){l&&q(0);break}if(B||q(2),Y<256)r[m++]=Y;else if(Y==256){me=c,h=null;break}else{var Z=Y-254;if(Y>264){var _=Y-257,I=Lt[_];
Z=se(t,c,(1<<I)-1)+so[_],c+=I}var le=y[Or(t,c)&te],Ie=le>>4;le||q(3),c+=le&15;var D=ri[Ie];if(Ie>3){var I=It[Ie];D+=Or(t,c)&(1<<I)-1,c+=I}if(c>v){l&&q(0);break}
i&&d(m+131072);var Ne=m+Z;if(m<D){var Tt=s-D,Ct=Math.min(D,Ne);for(Tt+m<0&&q(3);m<Ct;++m)r[m]=n[Tt+m]}for(;m<Ne;++m)r[m]=r[m-D]}}e.l=h,e.p=me,e.b=m,e.f=u,h&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return m!=r.length&&a?zr(r,0,m):r.subarray(0,m)},ye=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},dt=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Pr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:lo,l:0};if(o==1){var a=new N(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,C){return A.f-C.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],d=0,
u=1,c=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[d].f<r[c].f?d++:c++],l=r[d!=u&&r[d].f<r[c].f?d++:c++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,n=1;n<
o;++n)s[n].s>m&&(m=s[n].s);var h=new J(m+1),y=Ur(r[u-1],h,0);if(y>e){var n=0,f=0,g=y-e,v=1<<g;for(s.sort(function(C,E){return h[E.s]-h[C.s]||C.f-E.f});n<o;++n){
var S=s[n].s;if(h[S]>e)f+=v-(1<<y-h[S]),h[S]=e;else break}for(f>>=g;f>0;){var b=s[n].s;h[b]<e?f-=1<<e-h[b]++-1:++n}for(;n>=0&&f;--n){var w=s[n].s;h[w]==e&&(--h[w],
++f)}y=e}return{t:new N(h),l:y}},Ur=function(t,e,r){return t.s==-1?Math.max(Ur(t.l,e,r+1),Ur(t.r,e,r+1)):e[t.s]=r},Qn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new J(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},pt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},io=function(t,e,r){var n=r.length,o=Dr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},eo=function(t,e,r,n,o,s,a,i,l,d,u){ye(e,u++,r),++o[256];for(var c=Pr(o,15),m=c.t,h=c.l,y=Pr(s,15),f=y.t,g=y.l,v=Qn(m),S=v.c,
b=v.n,w=Qn(f),A=w.c,C=w.n,E=new J(19),T=0;T<S.length;++T)++E[S[T]&31];for(var T=0;T<A.length;++T)++E[A[T]&31];for(var x=Pr(E,7),O=x.t,_=x.l,k=19;k>4&&!O[Lr[k-1]];--k)
;var ee=d+5<<3,z=pt(o,xe)+pt(s,mt)+a,P=pt(o,m)+pt(s,f)+a+14+3*k+pt(E,O)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&ee<=z&&ee<=P)return io(e,u,t.subarray(l,l+d));var B,$,W,
D;if(ye(e,u,1+(P<z)),u+=2,P<z){B=ce(m,h,0),$=m,W=ce(f,g,0),D=f;var Le=ce(O,_,0);ye(e,u,b-257),ye(e,u+5,C-1),ye(e,u+10,k-4),u+=14;for(var T=0;T<k;++T)ye(e,u+3*T,
O[Lr[T]]);u+=3*k;for(var te=[S,A],me=0;me<2;++me)for(var Y=te[me],T=0;T<Y.length;++T){var Z=Y[T]&31;ye(e,u,Le[Z]),u+=O[Z],Z>15&&(ye(e,u,Y[T]>>5&127),u+=Y[T]>>12)}}else
B=ni,$=xe,W=si,D=mt;for(var T=0;T<i;++T){var I=n[T];if(I>255){var Z=I>>18&31;dt(e,u,B[Z+257]),u+=$[Z+257],Z>7&&(ye(e,u,I>>23&31),u+=Lt[Z]);var le=I&31;dt(e,u,W[le]),
u+=D[le],le>3&&(dt(e,u,I>>5&8191),u+=It[le])}else dt(e,u,B[I]),u+=$[I]}return dt(e,u,B[256]),u+$[256]},ci=new Fr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),lo=new N(0),ui=function(t,e,r,n,o,s){var a=s.z||t.length,i=new N(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),d=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var c=ci[e-1],m=c>>13,h=c&8191,y=(1<<r)-1,f=s.p||new J(32768),g=s.h||new J(y+1),v=Math.ceil(r/3),S=2*v,b=function(gr){return(t[gr]^t[gr+1]<<
v^t[gr+2]<<S)&y},w=new Fr(25e3),A=new J(288),C=new J(32),E=0,T=0,x=s.i||0,O=0,_=s.w||0,k=0;x+2<a;++x){var ee=b(x),z=x&32767,P=g[ee];if(f[z]=P,g[ee]=z,_<=x){var B=a-
x;if((E>7e3||O>24576)&&(B>423||!d)){u=eo(t,l,0,w,A,C,T,O,k,x-k,u),O=E=T=0,k=x;for(var $=0;$<286;++$)A[$]=0;for(var $=0;$<30;++$)C[$]=0}var W=2,D=0,Le=h,te=z-P&32767;
if(B>2&&ee==b(x-te))for(var me=Math.min(m,B)-1,Y=Math.min(32767,x),Z=Math.min(258,B);te<=Y&&--Le&&z!=P;){if(t[x+W]==t[x+W-te]){for(var I=0;I<Z&&t[x+I]==t[x+I-te];++I)
;if(I>W){if(W=I,D=te,I>me)break;for(var le=Math.min(te,I-2),Ie=0,$=0;$<le;++$){var Ne=x-te+$&32767,Tt=f[Ne],Ct=Ne-Tt&32767;Ct>Ie&&(Ie=Ct,P=Ne)}}}z=P,P=f[z],te+=
z-P&32767}if(D){w[O++]=268435456|Ir[W]<<18|Xn[D];var rt=Ir[W]&31,nt=Xn[D]&31;T+=Lt[rt]+It[nt],++A[257+rt],++C[nt],_=x+W,++E}else w[O++]=t[x],++A[t[x]]}}for(x=Math.
max(x,_);x<a;++x)w[O++]=t[x],++A[t[x]];u=eo(t,l,d,w,A,C,T,O,k,x-k,u),d||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=f,s.i=x,s.w=_)}else{for(var x=s.w||0;x<a+d;x+=65535){
var Ue=x+65535;Ue>=a&&(l[u/8|0]=d,Ue=a),u=io(l,u+1,t.subarray(x,Ue))}s.i=a}return zr(i,0,n+Dr(u)+o)},di=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),pi=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=di[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var mi=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return ui(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},co=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var H=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var hi=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&q(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function fi(t,e){return mi(t,e||{},0,0)}function uo(t,e){return li(t.subarray(hi(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var po=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=co(n,s[1]),s=s[0]),s instanceof N?r[a]=[s,i]:(r[a+="/"]=[new N(0),i],po(s,a,r,
n))}},to=typeof TextEncoder<"u"&&new TextEncoder,yi=typeof TextDecoder<"u"&&new TextDecoder,gi=0;try{yi.decode(lo,{stream:!0}),gi=1}catch{}function Pt(t,e){if(e){for(var r=new N(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(to)return to.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new N(a+8+(o-n<<1));l.set(s),s=l}var d=t.charCodeAt(n);d<128||e?i(d):d<2048?(i(192|
d>>6),i(128|d&63)):d>55295&&d<57344?(d=65536+(d&1047552)|t.charCodeAt(++n)&1023,i(240|d>>18),i(128|d>>12&63),i(128|d>>6&63),i(128|d&63)):(i(224|d>>12),i(128|d>>
6&63),i(128|d&63))}return zr(s,0,a)}var Br=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&q(9),e+=n+4}return e},ro=function(t,e,r,n,o,s,a,i){var l=n.length,d=r.extra,u=i&&i.length,
c=Br(d);H(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var m=new Date(r.mtime==null?Date.now():r.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&q(10),H(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(H(t,e,r.crc),H(t,e+4,s<0?-s-2:s),H(t,e+8,r.size)),H(t,e+12,l),H(t,e+14,c),e+=16,a!=null&&(H(t,e,
u),H(t,e+6,r.attrs),H(t,e+10,a),e+=14),t.set(n,e),e+=l,c)for(var y in d){var f=d[y],g=f.length;H(t,e,+y),H(t,e+2,g),t.set(f,e+4),e+=4+g}return u&&(t.set(i,e),e+=
u),e},bi=function(t,e,r,n,o){H(t,e,101010256),H(t,e+8,r),H(t,e+10,r),H(t,e+12,n),H(t,e+16,o)};function mo(t,e){e||(e={});var r={},n=[];po(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],d=i[1],u=d.level==0?0:8,c=Pt(a),m=c.length,h=d.comment,y=h&&
Pt(h),f=y&&y.length,g=Br(d.extra);m>65535&&q(11);var v=u?fi(l,d):l,S=v.length,b=pi();b.p(l),n.push(co(d,{size:l.length,crc:b.d(),c:v,f:c,m:y,u:m!=a.length||y&&h.
length!=f,o,compression:u})),o+=30+m+g+S,s+=76+2*(m+g)+(f||0)+S}for(var w=new N(s+22),A=o,C=s-o,E=0;E<n.length;++E){var c=n[E];ro(w,c.o,c,c.f,c.u,c.c.length);var T=30+
c.f.length+Br(c.extra);w.set(c.c,c.o+T),ro(w,o,c,c.f,c.u,c.c.length,c.o,c.m),o+=16+T+(c.m?c.m.length:0)}return bi(w,o,n.length,C,A),w}var j=(t,e)=>`${t}s of generation ${e}`,ue=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ae=["pursuer","evader"];function fo(){return JSON.parse(Nt("data"))}function Ge(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function Ce(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${j(e,r)}: it would be too large. Choose a generation of ${s.join("\
, ")}.`;let i=s.length*o.genome_size;return yo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wri\
te it again from its run.`}function X(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,d=yo(a,l).subarray(i*l,(i+1)*l),{hidden:u,activation:c,
sampled:m,memory:h}=o;return{hidden:u,activation:c,sampled:m,memory:h,genome:d}}var Wr=4,ho=new Map;function yo(t,e){let r=ho.get(t);if(r)return r;let n=new Float32Array;try{let o=wi(Hr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||vi(o)))throw o}return ho.set(t,n),n}var vi=t=>t instanceof Error&&"code"in t;function wi(t,e){let r=uo(t),n=r.length/Wr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Wr*n+Math.floor(a/Wr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Hr(t){let e=atob(Nt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Nt(t){return document.getElementById(
t)?.textContent??""}function go(t,e,r){let n=-8e3;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(
()=>{r()||performance.now()-n<8e3||(xi(t,e),location.reload())},5e3)}function xi(t,e){let{run:r,pursuer:n,evader:o}=e.selected,[s,a]=t[r].payoff.shape;n===s-1&&
o===a-1&&history.replaceState(null,"",`#run=${r}`)}var ht=[.5,1,2,4,8,16,32,64],je=0,Ut=12,Si=2,Se=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#l=null;#p=0;#c=[];#m=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#r=r.speed??4,this.#t=r.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(Si,this.#e/Ut)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=ht.findIndex(n=>n>=this.pace);this.speed=ht[Math.min(ht.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#d(r),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#a),this.#o("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#l===null&&(this.#p=performance.now(),
this.#l=requestAnimationFrame(()=>this.#h()))}#h(){this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#l=requestAnimationFrame(()=>this.#h()))}#u(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Me(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var ft=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ve(t){let e=Math.min(1,Math.max(0,t))*(ft.length-1),r=Math.min(ft.length-2,Math.floor(e)),[n,o]=[ft[r],
ft[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Bt(t){let[e,r,n]=Ve(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var Ft=t=>`rgb(${Ve(t).join(" ")})`,bo=()=>`linear-gradient(to right, ${ft.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Dt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=Mi(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Mi(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,d)=>{let u=4*((e-1-i-t.first[0])*r+d+t.first[1]);s.data.set([...Ve(l),255],u)})),o.putImageData(s,0,0),n}function zt(t,e){let r=p("span",{class:"grad\
ient"});return r.style.backgroundImage=bo(),p("p",{class:"scale-of-rates small muted"},t,r,e)}var Ai=84;function vo(t,e){let r=t.map((s,a)=>Ei(s,a,e)),n=p("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function Ei(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Ai/
Math.max(n,o),i=p("canvas",{"aria-hidden":"true"});Dt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=p("span",{class:"place"}),d=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Gr(t,e,r)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Ti(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:c=>{d.setAttribute("aria-current",String(c));let m=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=m>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-m-.5)*a}px`}}}var Ti=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Gr(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Ci=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function wo(){let t=Ci.map(([r,n])=>p("div",{class:"key-row"},p("dt",{},...r.map(o=>p("kbd",{},o))),p("dd",{},n))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function xo(t,e,r,n,o,s){let a=(l,d)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:_r,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let d=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||d||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let c=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(Me(r.player,l)||c)c?.();else if(t[m])Gr(t[m],
m,e);else return;l.preventDefault()})}var qe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function So(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),qe.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var ke=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ki=(t,e)=>t[0]===e[0]&&
t[1]===e[1],jr=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Vr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),qr=(t,e)=>Vr(t.fault,e),Mo=(t,e)=>!qr(
t,e)&&Vr(t.involved,e,2);function Wt(t,e,r){let n=!ki(L(t,r),L(e,r)),o=e.involved===void 0||Vr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function Ht(t,e,r){
let[n,o]=L(t,r),[s,a]=qe[e.actions?.[r]??0];return[n+s,o+a]}function yt(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var Ao=t=>t.moments.flatMap((e,r)=>r&&yt(t,t.moments[r-1],e).length?[r]:[]);function Gt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Eo=[-.31,0,.31],To=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Eo.flatMap(t=>Eo.map(e=>[e,t]))}],Ri=.3,_i=.35,$i=.55;function gt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=L(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Co(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of gt(t,e).values()){let o=To[Math.min(n.length,To.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var ko=t=>t*t*(3-2*t),Ke=(t,e,r)=>t+(e-t)*r,Ro=t=>Math.min(1,Math.max(0,t));function _o(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return ko(n);let s=o===r?e:+!ke(t,e),a=Math.max(1/o,_i);return ko(Ro((n-s/(o-1)*(1-a))/a))}function jt(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Co(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Co(t,a);return s.map((l,d)=>{let u=_o(
t,d,s.length,e-n);return Oi(o,a,d,l,i[d],u)})}function Kr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=_o(t,e,s.alive.length,r-o),[[l,d],[u,c]]=[L(s,e),L(a,e)];return[Ke(d,c,i)+.5,Ke(l,u,i)+.5]}function Oi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Ke(n.x,o.x,
s),y:Ke(n.y,o.y,s),size:a?n.size:Ke(n.size,o.size,s),alpha:a?Ro((1-s)/(1-$i)):Ke(n.alpha,o.alpha,s)};if(Wt(t,e,r)){let[l,d]=L(t,r),[u,c]=Ht(t,e,r),m=Ri*Math.sin(
Math.PI*s);i.x+=(c-d)*m,i.y+=(u-l)*m}return i}var $o=2*Math.PI;function Re(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,$o)}function Vt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];t.arcTo(a,i,d,u,n*.09)}),t.closePath()}function Oo(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Po(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=$o*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Lo(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Io=4,Pi=1.6,Li=.95,Ii=5,Ni=.16,Ui=9,Bi=.09,Fi=.2,No=.75,re=(t,e)=>t.left+e*t.cell,ne=(t,e)=>t.top+e*t.cell;function Ye(t,e,r){return ke(e,r)?t.colors.pursuer:
t.colors.evader}function Uo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,d),s<Ii)return;
t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let c=1;c<i;c++)t.fillRect(n+c*s,o,u,d);for(let c=1;c<a;c++)t.fillRect(n,o+c*s,l,u)}function Bo({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[u,c]=[Math.floor(d/l),
d%l];t.fillRect(o+c*a,s+u*a,a,a)}Fo({ctx:t,grid:e,colors:r})}function Fo({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Do({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,d=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let u=5*n+a/40;for(let c=0;c<l;c+=d)t.fillText(String(c),o+(c+.5)*a,s-u);t.textAlign="right",t.textBaseline="middle";for(let c=0;c<i;c+=d)t.fillText(
String(c),o-u,s+(c+.5)*a)}function zo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[re(t,s),ne(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Wo(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...zo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Fo(t)}function Ho({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[re(e,n),ne(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let c=d-i/2<u*1.2,m=d+(c?1:-1)*(i/2+u*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=r.ink,t.fillText("You",l,m),t.globalAlpha=1}function Go(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=zo(t,e,n,o),l=Ye(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function jo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Ui,
Math.max(1,a.cell*Ni));for(let d=Math.max(1,Math.floor(r-n)+1);d<=i;d++){let[u,c]=[e.moments[d-1],e.moments[d]],m=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=
No+(Fi-No)*m;for(let h=0;h<c.alive.length;h++){let y=d===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(ke(e,h)?-1:1)*Bi,[g,v]=L(u,h),[S,b]=L(c,h);if(g===
S&&v===b)continue;let w=y?o[h].x:b+.5,A=y?o[h].y:S+.5;s.strokeStyle=Ye(t,e,h),s.beginPath(),s.moveTo(re(a,v+.5+f),ne(a,g+.5+f)),s.lineTo(re(a,w+f),ne(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Vo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Io+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Io,l=yt(e,s,a);for(let d of Gt(s,a))l.includes(d)||zi(t,L(a,d),i);for(let d of l)Di(t,L(a,d),i)}t.ctx.globalAlpha=1}function Di({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Po(t,re(e,o+.5),ne(e,n+.5),Math.max(8,e.cell*Pi)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function zi({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Oo(t,re(e,o+.5),ne(e,n+.5),Math.max(7,e.cell*Li)),
t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function qo({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[re(e,i)+s,ne(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function Ko({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Re(t,re(e,n),ne(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Wi=.8,Hi=.92,Gi=15,ji=7,Yr=9;function Yo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Vi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of gt(e,r).values())a.length>
Yr&&qi(t,n[a[Yr-1]],a.length-Yr+1)}function Vi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=t,u=ke(e,n),[c,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?Hi:Wi)),y=Ye(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Vt:Re)(i,c,m,h),h>ji*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?d.paper:y,i.fill(),f&&(Re(i,c,m,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Gi*a)return;let g=String(u?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:d.paper,i.fillText(
g,c,m+h*(u?.17:.03))}function qi({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Ki=.46,Yi=.86,Zi=.66,Zo=.48,Ji=.78,Xi=.58;function Jo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)Wt(o,s,d)&&Qi(t,e,L(o,d),Ht(o,s,d));a.globalAlpha=
1}function Qi({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=c=>re(e,n[1]+.5+s*c),l=c=>ne(e,n[0]+.5+a*c),d=jr(r,o)?Ji:Xi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Zo),l(Zo)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*u,l(d)+
s*u),t.lineTo(i(d)+a*u,l(d)-s*u),t.stroke()}function Xo(t,e,r,n,o,s){let a=qe[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,u=jr(e,[n[0]+a[0],n[1]+a[1]])?Yi:
Zi,c=Ki*o.size,m=[re(l,o.x+a[1]*c),ne(l,o.y+a[0]*c),re(l,o.x+a[1]*u),ne(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[
d.paper,h*2.1],[Ye(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Lo(i,...m,l.cell*.2),i.stroke()}var qt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Kt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),d=e.moments[l],u=r===l,c=jt(e,r),m=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Uo(t);for(let f of n.
viewers)c[f]?.alpha&&Go(t,e,f,...Kr(e,f,r));Bo(t,e),n.axes&&Do(t,o),jo(t,e,r,n.trail,c),qo(t,d.contested??[],m),Vo(t,e,r),Jo(t,e,l,m),c.forEach(({x:f,y:g,size:v},S)=>{
let b=Mo(d,S)?.4:0,w=qr(d,S)?1:b;w&&Ko(t,f,g,v,w*m)});let h=u?d:e.moments[Math.max(0,l-1)];if(Yo(t,e,h,c,n.numbers,o),u&&n.plan)for(let[f,g]of c.entries())g.alpha&&
Xo(t,e,f,L(d,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Wo(t,e,...Kr(e,n.you,r)),Ho(t,c[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:c[n.selected];y?.alpha&&Qo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Qo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Qo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var bt=(t,e)=>(e+.24)/(t+.24);function Yt(t,e,r,n,o,s){let a=r?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function es(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var el={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ze(t){let e=getComputedStyle(t),r=Object.entries(el).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var ge=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ae=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#s;#l;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...qt,...r},this.#s=new ResizeObserver(()=>this.#m()),this.#s.observe(e),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#p)}close(){this.#s.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#p),cancelAnimationFrame(this.#a)}get look(){return this.#t}set look(e){this.#t={...this.#t,...e},this.#c(),this.redraw()}show(e,r){this.#e=e,
this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#c(),this.redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};#p=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=Yt(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Ze(this.canvas)};Kt(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return es(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=gt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=jt(this.#e,Math.round(this.#r)),i=l=>{let[d,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(d-e,u-r)};return s.length?s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(bt(e,r)))}#m(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Zr(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Jr(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Zt(t){let e=Array.from({length:t.length+1},(r,n)=>tl(t,n));return Zr(t.config,t.map,e)}function tl(t,e){
let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),
everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var rl=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function ts(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:rl,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var nl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function rs(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:nl[t]}))}function vt(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},rs(t))}function Je(t){let e=vt("play","Play","Space",()=>t.toggle()),r=ol(t),
n=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=sl(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},vt("first","First step","Home",()=>t.move(-t.length)),vt("back","Step back","←",()=>t.move(-1)),
e,vt("forward","Step forward","→",()=>t.move(1)),vt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,r),a,s),l=(c,m={})=>{let h=p("i",
m);return h.style.left=`${100*c/Math.max(1,t.length)}%`,h},d=()=>{n.replaceChildren(...t.marks.map(c=>l(c))),o.replaceChildren(...t.ticks.map(({step:c,kind:m,size:h,
text:y})=>{let f=l(c,{class:m,title:`Step ${c}: ${y}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(rs(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",u),t.addEventListener("s\
tate",u),t.addEventListener("state",d),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==r)&&Me(t,c)&&c.preventDefault()}),
u(),i}function ol(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function sl(t){let e=`Steps a second, or the whole in ${Ut} s (+ and -)`,r=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:je},`in ${Ut} s`),...ht.map(n=>p("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}var U=(t,e=2)=>t==null?"-":t.toFixed(e);function ns(t,e,r){return e===null||r===null?U(t):`${U(t)} (${U(e)} to ${U(r)})`}var os=t=>t.toLocaleString("en-GB"),_e=t=>t.
charAt(0).toUpperCase()+t.slice(1);function wt(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(d,u)=>(i+u)*a)}var al=40,Jt=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Ge(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,al).map((m,h)=>this.#n(m,h)));let l=a===null?i?.rates[s]:void 0,d=r.statistics.capture_rate,
u=l!==void 0&&Math.abs(d-l)<1e-6&&r.length===i?.lengths[s],c=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?c:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${U(d,3)} in ${r.length} steps.${i?` The cell says ${U(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${U(e)}`,"aria-label":`Episode ${r+1}, capture rate ${U(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,p("span",{class:"count"},r+1))}};var ss=0,as=1,il=2,ll=176;function ls(t,e,r,n){let o=devicePixelRatio||1,s=Ze(t);t.width=t.height=ll*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[c,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(il)&&(a.fillStyle=
s.obstacle,a.fillRect(c-l/2,m-l/2,l,l));let y=h(ss)&&h(as)?l*.18:0;h(ss)&&is(a,Re,c+y,m+y,l*.74,s.evader),h(as)&&is(a,Vt,c-y,m-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function is(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var cs="What it remembers: a number for each unit, from -1 to 1",Xt=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:cs});#l=null;#p=null;#c=null;#m=null;#d=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#i}show(e,r,n,o){this.#l?.free(),this.#l=e.world(n.config),
this.#c!==r&&(this.#p=null,this.#i!==null&&this.choose(null)),[this.#c,this.#m,this.#d]=[r,n,o]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#m;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,o,s,a]=[this.#m,this.#l,this.#c,this.#d,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},V(a,r.config.n_pursuers)));
let l={pursuers:X(o,"pursuer",s.pursuer),evaders:X(o,"evader",s.evader)};r.seek(n,e,l);let d=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;d.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(d);let u=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);ls(this.#r,r.config,u?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${V(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let c=d[a]??null;if(!u)return this.#u([],"It is gone.");let m=l[`${i}s`],
h=typeof m=="string"?null:n.answer(m,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),dl(h.memory));
let f=this.#p?.game(n)??null,g=typeof m=="string"?`The script "${m}" plays for it${c===null?"":`; it goes ${ue[c]}`}.`:m.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",v=[["network",y],["perfect",f?.marginal(a)??null]],S=b=>p("p",{class:"small muted"},b);this.#u([...f?[S(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...cl(v,c)],c===null?"The episode is over.":g)}#u(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function cl(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=p("div",{class:"action muted"},p("span"),...r.map(([s])=>p("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ue[a]),...r.flatMap(([,i])=>ul(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function ul(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function dl(t){
let e=Array.from(t,r=>{let n=p("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return p("div",{class:"units",role:"img","aria-label":cs},
...e)}function Xe(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,X(e,"pursuer",r),X(e,"evader",n),BigInt(s??a),o)}function us(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var ds="champion",ps=0,Xr=64,Qr=100;var pl=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function ms(t,e){return Object.keys(e).find(r=>pl(e[r],t))??null}var xt="_",ml="n",Yd=2n**64n-1n;var en={fov:11,maxSteps:500,rewards:"paper"},hl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ys(t,e){let r=i=>i.map(l=>yl(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=fl(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:fs(
t.rules,e),others:t.others?fs(t.others,e):"",rewards:o===en.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===en.fov?"":String(t.fov),
limit:t.maxSteps===en.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(xt),pursuers:t.pursuers.map(hs).join(xt),
evaders:t.evaders.map(hs).join(xt),played:t.played.map(r).join(xt),next:t.next.every(i=>i===ps)?"":r(t.next)};return hl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function hs({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function fs(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return ms(t,e.variants)??r.join(".")}function fl(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(xt)}function yl(t,e){if(typeof t=="number")return String(t);if(t===ds)return ml;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var gl="/* the engine */";function gs(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>tn(t(),e)},"What if?")}function tn(t,e){let r=t!==null&&t.match.n_agents<=Qr&&Math.max(t.match.config.rows,t.match.config.
cols)<=Xr,n=r?ys(bl(t.match,t.step),e):"",o=new TextDecoder().decode(Hr("playground")).replace(gl,()=>Nt("script-engine")).replace("</noscript>",s=>r?s+us(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function bl(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
d=o*r.n_evaders+i-r.n_pursuers,u=c=>i>=r.n_pursuers&&!!c[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var rn=.005,vs=.05,vl=["pursuer","evader"],wl=4,Qe=new Map;function Qt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=Qe.get(n)??(Ot(e)?Promise.
resolve(null):xl(t,e,r));return Qe.delete(n),Qe.set(n,o),Qe.size>wl&&Qe.delete([...Qe.keys()][0]),o}var ws=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
bs=()=>new Promise(t=>setTimeout(t));async function xl(t,e,r){await bs();let n=t.solution(e,r);for(;n.goBack();)await bs();return n}function er(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((d,u)=>a[u]+=d),e.playTurn(o);let i=n==="capture-rate"?rn:vs;
return vl.map((l,d)=>({step:s+1,team:l,lost:a[d],payoff:n})).filter(l=>l.lost>=i)})}var tr=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:St(e)})),xs=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,St=t=>`The ${t.team}s los\
e ${xs(t)} against a perfect opponent`;function Ss(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${xs(e)} \
against a perfect opponent.`}function Ms({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,kr)];return o>s-vs?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function As(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=rn).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-rn?ue[o]:`${ue[o]} ${n.toFixed(2)}`).join(", ")}function rr(t,e,r){if(r===0)return[{kind:"start",text:Sl(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>V(u,t.config.n_pursuers),a=yt(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),d=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Gt(n,o))!a.includes(u)&&!l.has(u)&&d.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return d.push(...i.map(({kind:u,text:c,agents:m})=>({kind:u,text:c,agents:m}))),r===t.length&&d.unshift({kind:"\
end",text:Ml(t),agents:[]}),d}function Sl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Ml(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Al=60,nr=class{element;player=new Se(0,{speed:je,still:ge()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#l=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#p=p("p",{class:"problem",role:"a\
lert"});#c=null;#m=null;#d=0;#i=!1;#h=0;#u=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=p("canvas",{"aria-label":"The match"});this.#e=new Ae(o,{numbers:!1}),
this.#n=new Jt(r),this.inspector=new Xt(s=>this.#x(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p(
"div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&gs(()=>this.shown,n)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p(
"div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),this.#p,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#l,ts(),this.actions,this.
inspector.element),Je(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#f()),r.on("rest",()=>this.player.pause()),this.#v(),this.#S(0,0)}get#o(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){
this.#c=e,this.#y()}playSoon(){this.#i=!0,this.#d||this.#g()}goTo(e){this.#h=e,!this.#d&&this.match&&this.#y()}#g(){!this.#i||!this.match||(this.#i=!1,this.player.
jump(0),ge()||this.player.play())}#f(){this.#v(),clearTimeout(this.#d),this.#d=setTimeout(()=>this.#y(),Al)}#y(){clearTimeout(this.#d),this.#d=0,this.player.pause(),
this.#v();let{selected:e}=this.#t,r=ae.map(s=>Ce(this.#o,s,e[s])).find(Boolean)??"";if(this.#p.textContent=r,r||!this.#c)return;this.match=Xe(this.#c,this.#o,e);
let[n,o]=this.names(e);this.#m={pursuer:{name:n,policy:X(this.#o,"pursuer",e.pursuer)},evader:{name:o,policy:X(this.#o,"evader",e.evader)}},this.recording=Zt(this.
match),this.#n.show(this.#o,this.match),this.inspector.show(this.#c,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=Ao(this.recording),
this.#u=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#w(),this.#b(this.#c,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.#g()}async#b(e,r){let n=await Qt(e,r.config);if(this.match!==r||!n)return;let o=e.world(r.config);r.seek(o,0),this.#u=er(n,o,El(
r)),o.free(),this.player.ticks=tr(this.#u),this.inspector.solution=n,this.#w()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#r[e];return[o.pursuer.script??
j("pursuer",r),o.evader.script??j("evader",n)]}#v(){let{episode:e,seed:r}=this.#t.selected,{payoff:n}=this.#o,[o,s]=this.names(this.#t.selected),a=r===null?e<n.
episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#a.replaceChildren(p("span",{class:"pursuer"},_e(o))," agains\
t ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#w(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.
moments[r];this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#u.filter(o=>o.step===r).map(o=>p("li",{class:`loss-${o.
team}`},St(o))),...rr(e,this.recording,r).map(o=>p("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(e,r){this.#s.
replaceChildren(p("strong",{},e),` of ${this.#o.world.n_evaders} captured`,p("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},El=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var Tl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Cl=5;function $e(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Tl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,d]=r(),u=o.shiftKey?Cl:1,{pursuer:c,evader:m}=e.selected;e.
select({pursuer:Es(c+u*a,l),evader:Es(m+u*i,d)}),o.preventDefault(),o.stopPropagation()})}var Es=(t,e)=>Math.min(e-1,Math.max(0,t));var kl=24,or=7,Cs=t=>t<kl&&matchMedia("(pointer: coarse)").matches;function ks(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Ts(e,o),Ts(r,s)],[l,d]=[Math.min(or,o),Math.
min(or,s)],u=[];for(let y=a+l-1;y>=a;y--){u.push(p("span",{class:"pursuer"},y));for(let f=i;f<i+d;f++)u.push(Rl(t,y,f,n))}let c=Array.from({length:d},(y,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...u,m,...c);return h.style.gridTemplateColumns=`2.4rem repeat(${d}, minmax(0, 1fr))`,h.addEventListener("click",y=>y.stopPropagation()),
h}function Rl(t,e,r,n){let o=Ge(t,e,r)?.rate,s=p("button",{type:"button","aria-label":`${U(o)}: ${j("pursuer",e)} against ${j("evader",r)}`,onclick:()=>n({pursuer:e,
evader:r})},U(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Ft(o),Bt(o)]),s}var Ts=(t,e)=>Math.max(0,Math.min(e-or,t-Math.floor(or/2)));var oe={left:52,bottom:46,top:76,right:84},de=10,_l=160,Mt=oe.right-de-14,Oe=oe.top-de-14,sr=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=M("svg",
{"aria-hidden":"true"});#a=M("g");#s;#l=p("h2");#p=p("strong",{class:"rate numbers"});#c=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#d=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#l,this.#m),p("div",{class:"of-cell"},this.#p,this.#c));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,zt("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).
observe(this.#s),this.#s.addEventListener("pointermove",o=>this.#v(o)),this.#s.addEventListener("pointerleave",()=>r.point({})),this.#s.addEventListener("click",
o=>this.#w(o)),this.#s.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),$e(this.#s,
r,()=>this.#i.payoff.shape),this.#s.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#g()),r.on("hove\
r",()=>this.#g())}get#i(){return this.#r[this.#e.selected.run]}#h(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.
max(_l,Math.min(n-oe.left-oe.right,o-oe.top-oe.bottom))/Math.max(e,r),i=Math.max(oe.left,(n-r*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(o-oe.top-oe.bottom-e*a)/
2),d={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};this.#d=d,Dt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[u,c,m]of[["left",i,
n],["top",l,o],["width",r*a,n],["height",e*a,o]])this.#t.style.setProperty(u,`${100*c/m}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute(
"viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren($l(d),...Ol(d),...this.#o(d),this.#a),this.#g()}#u(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Rs(e,r.pursuers.mean[s]??0,s),[d,u]=_s(e,r.evaders.mean[a]??0,a);return[M("cir\
cle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:d,cy:u,r:5})]}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
left:n,top:o,cell:s,rows:a,columns:i}=e,[l,d]=[n+i*s+de,o-de],u={class:"side"};return[M("rect",{...u,x:l,y:o,width:Mt,height:a*s}),M("rect",{...u,x:n,y:d-Oe,width:i*
s,height:Oe}),...$s(r.pursuers,(c,m)=>Rs(e,c,m),"of-pursuers"),...$s(r.evaders,(c,m)=>_s(e,c,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"\
start"},"0"),M("text",{class:"tick",x:l+Mt,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),M("text",{class:"ti\
ck",x:n-6,y:d-Oe+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+Mt,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-ev\
aders",x:n+i*s+de,y:d-Oe+10,"text-anchor":"start"},"escapes")]}#g(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,
d=y=>s+(i-1-y)*a,u=[],c=(y,f)=>M("rect",{class:f,x:o,y:d(y),width:l*a+de+Mt,height:a}),m=(y,f)=>M("rect",{class:f,x:o+y*a,y:s-de-Oe,width:a,height:de+Oe+i*a});u.
push(c(r.pursuer,"strip pursuer"),m(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(c(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(
m(n.evader,"strip hover")),u.push(...this.#u(e));let h={x:o+r.evader*a,y:d(r.pursuer),width:a,height:a};u.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...u),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Ge(this.#i,n,o);this.#l.
replaceChildren(p("span",{class:"pursuer"},_e(j("pursuer",n)))," against ",p("span",{class:"evader"},j("evader",o))),this.#p.textContent=s?U(s.rate,3):"-",this.#c.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"no episodes were played",this.#m.textContent=this.#y(n,o)}#y(e,r){let n=this.#i.findings?.generalization;
if(!n)return"";let o=(s,a)=>ns(s.mean[a]??null,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#b(e){
let r=this.#d;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/
r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,
evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#b(e);if(r){if(r.inside&&Cs(this.#d.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?
{}:{evader:r.h}}),r.inside&&this.#x()}}#S(e,r){let n=ks(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(o),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function $l({left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"axes"}),a=e+n*r,i=l=>wt(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(M("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Ol({
left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;for(let u of["H","V"]){let c=`M${t} ${i}`;for(let m=1;m<=
a;m++){let[h,y]=[`H${t+m*r}`,`V${i-m*r}`];c+=u==="H"?h+y:y+h}s.append(M("path",{d:c,class:"under"}),M("path",{d:c}))}let[l,d]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[
s,M("text",{class:"on-cells",transform:`translate(${l} ${d}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var Rs=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[
t+o*r+de+s*Mt,e+(n-a-.5)*r],_s=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-de-n*Oe];function $s(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(M("path",{class:`line ${r}`,
d:`M${n(t.mean).join("L")}`})),o}function ie(t,e,...r){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...r)}function Os(t,e,r){let{findings:n}=t;if(!n?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Ll(o,t,i,e,
l)},a=n.checkerboards.map(i=>Pl(t,i,s));return{element:ie("Checkerboards","Two generations of each team: each generation of the pursuers is better against anoth\
er one of the evaders. Click one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${n.margin}\
 in this way.`),a.length?p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether th\
ere are more than noise makes."):null,o)}}var Ps=({pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function Pl(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,
i=Ps(e).map(([l,d])=>{let u=t.payoff.capture_rate[l][d],c=p("span",{class:"cell"},U(u));return c.style.backgroundColor=Ft(u),c.style.color=Bt(u),c});return p("b\
utton",{type:"button",class:"miniature numbers",onclick:()=>r(e)},p("span",{},p("span",{class:"heard"},`Four matches of generations ${n} and ${o} of the pursuer\
s, ${s} and ${a} of the evaders:`)),p("span",{class:"evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},n),i[0],i[1],p("span",{class:"pursuer"},
o),i[2],i[3])}function Ll(t,e,r,n,o){let s=Ps(r).filter(([m,h])=>!Ce(e,"pursuer",m)&&!Ce(e,"evader",h)),a=s.map(([m,h])=>Xe(o,e,{run:n.selected.run,pursuer:m,evader:h,
episode:0,seed:null})),i=new Se(Math.max(0,...a.map(m=>m.length)),{speed:je,still:ge()}),l=a.map((m,h)=>{let[y,f]=s[h],g=p("canvas",{"aria-label":`${j("pursuer",
y)} against ${j("evader",f)}`}),v=p("span",{class:"numbers"}),S=()=>{t.close(),n.select({pursuer:y,evader:f})},b=p("figure",{},g,p("figcaption",{class:"small"},
v,p("span",{class:"muted"},`cell ${U(e.payoff.capture_rate[y][f])}`),p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));return b.style.
gridArea=`${r.pursuers.indexOf(y)+2} / ${r.evaders.indexOf(f)+2}`,{element:b,match:m,recording:Zt(m),board:new Ae(g,{numbers:!1}),tally:v}}),d=()=>l.forEach(m=>m.
board.show(m.recording,i.time)),u=()=>l.forEach(({recording:m,match:h,tally:y})=>{let f=m.moments[Math.min(i.step,h.length)];y.textContent=`${Array.from(f.everCaptured).
filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener("frame",d),i.addEventListener("step",u),t.replaceChildren(p("header",{},p("h2",{},
"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},"Close")),p("div",{class:"grid-of-four"},p("span"),...r.evaders.map(m=>p("h3",
{class:"evader"},j("evader",m))),...r.pursuers.map((m,h)=>{let y=p("h3",{class:"pursuer"},j("pursuer",m));return y.style.gridArea=`${h+2} / 1`,y}),...l.map(m=>m.
element)),Je(i));let c=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&Me(i,m)&&m.preventDefault()};
t.addEventListener("keydown",c),t.addEventListener("close",()=>{t.removeEventListener("keydown",c),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},
{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),d(),u(),ge()||i.play()}var ar={pursuer:"evader",evader:"pursuer"};function Ls(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${U(s)}, stripes ${U(a)}${i===null?"":` every ${i} generations`}`;return Il(t,o,l,e)});return{element:ie("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...n.map(o=>o.element)),zt("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function Il(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(b,w)=>e==="pursuer"?t.payoff.
capture_rate[b][w]:1-t.payoff.capture_rate[w][b],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),u=d?.createImageData(a,s);for(let b=0;u&&
b<s;b++)for(let w=0;w<=Math.min(b,a-1);w++)u.data.set([...Ve(i(b,w)),255],4*((s-1-b)*a+w));u&&d?.putImageData(u,0,0);let c=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,c),y=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);$e(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${a} / ${s}`;let f=b=>{let w=y.
getBoundingClientRect(),A=Math.floor((b.clientX-w.left)/w.width*a),C=s-1-Math.floor((b.clientY-w.top)/w.height*s);return A>=0&&C<s&&A<=C?[C,A]:null},g=b=>({[e]:b[0],
[ar[e]]:b[1]});y.addEventListener("pointermove",b=>n.point(f(b)?g(f(b)):{})),y.addEventListener("pointerleave",()=>n.point({})),y.addEventListener("click",b=>f(
b)&&n.select(g(f(b))));let v=()=>{let b=n.hover[e]??n.selected[e],w=n.hover[ar[e]]??n.selected[ar[e]];for(let A of[c,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-b)),A.style.display=w<=b?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),y,p("p",{class:"smal\
l muted"},`horizontal: ${ar[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},r)),update:v}}var ir={left:46,right:12,top:10,bottom:42},Is={x:56,y:34};function nn(t,e,r,n){let[o,s]=[ir.left,ir.top],a=Math.max(o+40,t-ir.right),i=Math.max(s+40,e-ir.bottom),
l=(f,g,v)=>S=>g+(S-f.low)/(f.high-f.low||1)*(v-g),[d,u]=[l(r,o,a),l(n,i,s)],c=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of wt(n.low,n.high,(i-s)/Is.y,n.whole))h.append(M("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),M("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ns(f)));for(let f of wt(r.low,r.high,(a-o)/Is.x,r.whole))h.append(M("text",{x:d(f),y:i+16,"text-anchor":"middle"},Ns(r.mirrored?
Math.abs(f):f)));return h.append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),M("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(h,c),{root:m,marks:c,left:o,right:a,top:s,bottom:i,x:d,
y:u,at:f=>{let g=f-m.getBoundingClientRect().left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Ns=t=>String(Number(t.toPrecision(6))).replace("-","−");function on(t,e,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(M("path",{d:o,class:`line ${n}`}),
t.marks)}function Us(t,{low:e,high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(M("path",{d:`\
M${[...o(r),...o(e).reverse()].join("L")}Z`,class:`band ${n}`}),t.marks)}function sn(t,e,r,n=null){let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.
bottom,class:`mark ${r}`})),n!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function an(...t){return p("p",{class:"legend small"},...t.
map(([e,r])=>p("span",{class:`key ${r}`},e)))}function ln(t,e,r,n){let o=p("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),
s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:d}=o;l<50||d<50||(s=e(l,d),o.replaceChildren(s.root),
a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var cn=["of-pursuers","of-evaders","of-both"],Nl=2500,Bs="Arrow keys choose generations.",Ul={low:0,high:1,label:"capture rate"};function Fs(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=Bl(n,r.window),d=i.at(-1)??1,u=i.length>Nl?"dense":"",c=(y,f)=>{let g=o.flatMap((v,S)=>v===
y&&(s[S]===f||s[S]===2)?[S]:[]);return g.length?[i[g[0]],i[g.at(-1)]]:null},m=ln(`Capture rate in ${d} epochs of training. ${Bs}`,(y,f)=>{let g=nn(y,f,{low:0,high:d,
label:"epoch",whole:!0},Ul);for(let[v,S]of[["raw",n],[u,l]])for(let[b,w]of cn.entries()){let A=S.map((C,E)=>s[E]===b||s[E+1]===b?C:null);A.some(C=>C!==null)&&on(
g,i,A,`${w} ${v}`)}return g},y=>ae.forEach((f,g)=>{let v=c(e.hover[f]??e.selected[f],g);v&&sn(y,(v[0]+v[1])/2,cn[g])}),y=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(y/a)-1)),g=o[f];s[f]!==1&&e.select({pursuer:Math.min(g,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(g,t.payoff.shape[1]-1)})});$e(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn","both teams learn"][y],cn[y]]);return{element:ie("Training",`${os(r.
matches)} training matches. Lines: the generations that are selected.`,an(...h),m.element),update:m.update}}function Ds(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=ae.flatMap(c=>[n[c].mean,n[c].low??[],n[c].high??[]]).flat().map(c=>c??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),d=Math.max(...t.payoff.shape)-1,u=ln(`Elo ratings by generation. ${Bs}`,(c,m)=>{let h=nn(c,m,{low:0,high:d,
label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of ae)Us(h,n[y],`of-${y}s`),on(h,o[y].map((f,g)=>g),o[y],`of-${y}s`);return h},c=>{
for(let m of ae){let h=e.hover[m]??e.selected[m];sn(c,h,`of-${m}s`,o[m][h]??null)}},(c,m,h)=>{let y=Math.round(c),f=h.clientY-m.root.getBoundingClientRect().top,
g=S=>Math.abs(m.y(o[S][y]??1/0)-f),v=g("pursuer")<=g("evader")?"pursuer":"evader";y>=0&&y<o[v].length&&e.select({[v]:y})});return $e(u.element,e,()=>t.payoff.shape),
{element:ie("Ratings",`One number for each generation, which cycles do not fit, with 95 % intervals over episodes. The game itself: ${U(r.offset,0)} points for \
the pursuers.`,an(["pursuers","of-pursuers"],["evaders","of-evaders"]),u.element),update:u.update}}function Bl(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);
return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var Fl={present:"●",absent:"○","cannot tell":"?"};function zs(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],d)=>{
let u=Dl(e.reasons[d]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Fl[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ie("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("p",{},e.headline),
...e.numbers.map(s=>p("p",{class:"numbers"},`${_e(s)}.`)),p("ul",{class:"findings"},...n),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add(
"diagnosis"),{element:o}}function Dl(t){let[,e=""]=t.split(/, because (.*)/s);return _e(e.replace(/\.$/,""))}function Ws({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>p("tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"n\
umbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...n),s=ie("Settings",`${e}, \
seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?p("div",{class:"wide-table"},o):null);return s.classList.add("settings"),{element:s}}function Hs(t,e,r){let n=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??zl(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(d=>d.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function zl(t,e,r){return[zs(t),Fs(t,e),Os(t,e,r),Ds(
t,e),Ls(t,e),Ws(t)].filter(o=>o!==null)}var dr=Pa(ra(),1);var hn=125,cc=80,uc=10,na=480,dc=[1,.8,.6,.4,.2],pc=5;async function oa(t,e){let r=Math.min(1,bt(t.rows,t.cols)),[n,o]=[Math.round(na*r),Math.round(na*r/bt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[n,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=Ze(document.documentElement),l={ctx:a,colors:i,
grid:Yt(t.rows,t.cols,!1,n,o,1)},[d,u]=[mc(i,a),(0,dr.GIFEncoder)()];for(let c=0;c<hn;c++){let m=Math.min(1,c/(hn-uc))*(t.moments.length-1);Kt(l,t,m,{...qt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,n,o),a.globalCompositeOperation="source-over",u.writeFrame((0,dr.applyPalette)(
a.getImageData(0,0,n,o).data,d),n,o,{palette:d,delay:cc}),c%pc===0&&(e(Math.round(100*c/hn)),await new Promise(h=>setTimeout(h)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function mc(t,e){let r=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),n=r(t.
paper);return Object.values(t).map(r).flatMap(o=>dc.map(s=>o.map((a,i)=>Math.round(n[i]+s*(a-n[i])))))}function sa(t,e){let r=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),n=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"bu\
tton",class:"save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:l,evader:d}=e.selected;s.disabled=!0;let u=await oa(t.recording,m=>n.textContent=`Dr\
awing: ${m} %`),c=URL.createObjectURL(u);p("a",{href:c,download:`pursuers-${l}-evaders-${d}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(c),6e4),n.textContent=
`Saved, ${(u.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{
id:"share-title"},"Share this match"),s,ct()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),ct()&&p("div",{class:"link"},r,
p("button",{type:"button",onclick:()=>Kn(r,n)},"Copy")),n,p("button",{type:"button",onclick:()=>a.close()},"Close"));return a.addEventListener("click",l=>l.target===
a&&a.close()),{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),r.value=location.href,n.textContent="",a.showModal()}},
"Share"),dialog:a}}var aa={pursuer:null,evader:null},pr=class extends EventTarget{#e;#r=aa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...aa,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var mr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Jr(this.#e)],
this.recording=Zr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,
[Math.max(l,s),d],a)),typeof n=="number"?a[r]=n:l<=r&&r<d&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(Jr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var pe=(t,e)=>ae[+(e>=t.n_pursuers)];function fn(t,e){let r=new mr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function et(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var hr=(t,e)=>t.over||et(t,e).out;function ia(t,e,r){let n=fn(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!hr(n,e.seat);)n.step(e.policies,e.seat,r);return et(n,e.seat)}function la(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function ca(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function ua(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function yn(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[hc(t,a,i,la(o))],again:()=>yn(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&ca(s,a)})}
function hc(t,e,r,n){let o=pe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=d=>{let[u,c]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},d),p("td",{class:"track","aria-hidden":"true"},u),c)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,
c.textContent=String(o?m:h)}};i("You")(et(e,r.seat));for(let{name:d,policy:u}of n){let c=i(d);setTimeout(()=>c(ia(t,r,u())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var da=["·","↑","→","↓","←","↗","↘","↙","↖"];var fc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},gn=[8,1,5,4,0,2,7,3,6],yc=[7,8,9,4,5,6,1,2,3],gc=24,bc=Math.tan(
Math.PI/8);function ma(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=yc.findIndex(o=>t.code===`Numpad${o}`),n=gn[r]??fc[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function ha(t){let e=gn.map(r=>p("button",{type:"button","aria-label":ue[r],onclick:()=>t(r)},da[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",gn[o]>4&&!r))}}function pa(t,e,r){let n=bc*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return So([0,0],r?[o(t),o(e)]:[t,e],r)}function fa(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[d,u]=[s-i[0],a-i[1]],c=t.cellAt(s,a);Math.hypot(d,u)>=gc?r(pa(u,d,l.diagonal)):c&&r(pa(c[0]-l.cell[0],
c[1]-l.cell[1],l.diagonal))})}function ya(t,e){let r=n=>{let o=e[n]-t[n],s=qe.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${ue[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var va="NUMPY\0",ga=va.length+2,ba=64;function wa(t){return mo(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,vc(r)])))}function vc({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((ga+s.length+1)/ba)*ba-ga,i=va+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,d=new Uint8Array(i.length+l.byteLength);return d.set(Pt(i,!0)),d.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),d}var wc="matrixworld episode 3";function xa(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],d={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},c={},m=b=>{
for(let w of Object.keys(b))(c[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(n);h.reset(e.start);let y=[];m(d);for(let b of o)h.step(b),m({...d,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[w,...A]]of Object.entries({...d,...u})){let C=s+
+(b in d);g[b]={dtype:w,shape:[C,...A],data:f[w].from((c[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),S=b=>({dtype:"<U",shape:[],data:b});
return wa({format:S(wc),n_pursuers:v(n.n_pursuers),config:S(JSON.stringify(n)),seat:v(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var xc=[0,1,2,4,8],fr=class{element;player=new Se(0,{speed:4,still:ge()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=ha(e=>this.act(e));#l=p("select",{},...xc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#p=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#m=p("label",{class:"play-choice"},this.#c,"Best move");#d=p("p",{class:"small muted play-keys",id:"play-keys"});#i=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Je(this.player);#u=null;#o=null;#g=[];#f=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#r=new Ae(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#A()),this.#p.addEventListener(
"change",()=>this.#x()),this.#c.addEventListener("change",()=>this.#E()),fa(this.#r,()=>{let r=this.#f!==null&&this.#o&&L(this.#o.recording.moments.at(-1),this.#f);
return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#E()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),p("div",{class:"pl\
ay-stage"},this.#t),p("div",{class:"play-side"},this.#i,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),p("label",{class:"\
play-choice"},this.#p,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#h)}get played(){return this.#u&&{...this.#u.
played,moves:this.#g}}get live(){return this.#o}play(e){this.#S(fn(this.#e,e.played),e.played.seat,e.title),[this.#u,this.#g,this.#v]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),hr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#u=null,this.#S(e,r,n),this.#_()}stop(){
this.#A(),this.player.pause(),this.#u=null}act(e){let[r,n]=[this.#u,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#l.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Me(this.player,e);let s=ma(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#A(),this.player.pause(),[this.#o,
this.#f]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#x(){this.#r.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#$()}}#M(e){this.#y=null,this.#b=this.player.ticks=[],this.#m.hidden=this.#c.disabled=!!Ot(e.config),
Qt(this.#e,e.config,ws(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#T(),this.#E())})}#T(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=er(r,n,e.actions),n.free(),this.player.ticks=tr(this.#b)}get#C(){return this.#c.checked&&this.#u&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#$(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#A(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#u.played,this.#o];n.step(e,r,this.#v),this.#g.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(n.length-this.player.step),hr(n,r)&&this.#R()}#R(){this.#A();let[e,r,n]=[this.#u,this.#o,this.played],o=ct()?e.link(
n):null;this.#i.replaceChildren(p("h3",{id:"play-headline"},Ac(r,n.seat)),...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},"Watch it"),p("button",{type:"button",onclick:()=>this.#O(r,n.seat)},"Save"),
o&&p("button",{type:"button",onclick:({currentTarget:a})=>Tc(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#b.filter(({team:a})=>a===pe(
r.config,n.seat));s.length&&this.#i.children[0].after(p("p",{class:"small muted"},Ss(s))),this.#i.focus({preventScroll:!0}),this.#i.scrollIntoView({block:"neare\
st"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),ge()||this.player.play()}#O(e,r){let n=new Blob([xa(this.#e,
e,r)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(n),download:`${V(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#E(){let[e,r,
{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let o=rr(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(r)),s=this.#u&&n===0,a=s?[Sc(
e.config,r),this.#u.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Mc(e,n,r)),a.push(...this.#b.filter(l=>l.step===
n).map(St));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${As(i,r)||"decided in its turn"}; ${Ms(this.#y,i,n)}`),this.#x(),this.#a.textContent=
a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Sc(t,e){let r=t.rules.capture==="SURROUND";return pe(t,e)==="evader"?`Run away: you win if ${r?"the pursu\
ers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your team":"move onto their cells"}`}
function Mc({config:t,recording:e},r,n){let o=e.moments[r],a=pe(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=L(o,n),l=c=>{let[m,h]=L(o,c);return Math.
max(Math.abs(m-i[0]),Math.abs(h-i[1]))},d=Array.from({length:o.alive.length},(c,m)=>m).filter(c=>pe(t,c)===a&&o.alive[c]&&!o.captured[c-t.n_pursuers]&&2*l(c)<t.
fov);if(!d.length)return`No ${a} in view`;let u=d.reduce((c,m)=>l(m)<l(c)?m:c);return`Nearest ${a}: ${ya(i,L(o,u))}`}function Ac(t,e){let[{lasted:r,out:n,captured:o},
{config:s}]=[et(t,e),t];return pe(s,e)==="pursuer"?`Your team captured ${o} of ${Ec(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escape\
d: ${r} steps.`}var Ec=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Tc(t,e){let r=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to thi\
s match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var yr=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",s=>this.view?.key(s)&&s.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,r=""){this.#a=e;let n=ut(r,this.#e,this.#r.selected),o=ua(new URLSearchParams(r.replace(/^#/,"")),
this.#e[n.run].world);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=n<r.
length?n:0,a=(c,m)=>!!r.alive[m*r.n_agents+c],i=Array.from({length:r.n_agents},(c,m)=>(m+r.config.n_pursuers)%r.n_agents),l=o??i.find(c=>a(c,s)),d=a(l,s)?s:0,u=Array.
from({length:d},(c,m)=>r.actions[m*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:d,moves:u})}play(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||ae.some(
g=>Ce(o,g,e[g])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:d}=e,u=pe(o.world,r.seat),c=o.teams[u].kept.map(g=>({name:o.teams[u].script??`generation ${g}`,
text:"",policy:()=>X(o,u,g)}));this.view||(this.view=new fr(n),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Clos\
e"),this.view.element)),this.dialog.open||this.dialog.showModal();let m=`You are ${V(r.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,h={pursuer:X(
o,"pursuer",a),evader:X(o,"evader",i)},y={config:o.world,seed:BigInt(d??o.seeds[a][i]),episode:l,policies:h,...r},f={run:s,pursuers:a,evaders:i,episode:l,...d===
null?{}:{seed:d}};yn(n,this.view,m,y,c,this.#n?f:null)}};var be=fo(),{runs:Q}=be,[Cc,kc]=Q[0].payoff.shape,Rc=ut(location.hash,Q,{run:0,pursuer:Cc-1,evader:kc-1,episode:0,seed:null}),{step:Sa,..._c}=Rc,K=new pr(_c),G=new nr(
Q,K,be.playground),Ma=new sr(Q,K),Et=new yr(Q,K,G),bn=wo(),$c=location.hash,{button:Oc,dialog:Pc}=sa(G,K);G.actions.append(Oc);var tt=null,Aa=p("span",{class:"t\
old","aria-live":"polite"}),Ea=()=>{Aa.textContent=Q[K.selected.run].findings?.sentence??""};K.on("run",Ea);Ea();var Lc=()=>{G.playSoon(),G.reveal()},Ic="Each c\
ell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";document.getElementById("page").replaceWith(Zn(be.heading,
p("span",{},Aa,p("span",{class:"small muted"},Ic)),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>bn.showModal()},
"?")),...be.note?[p("aside",{class:"note small muted"},be.note)]:[],vo(Q,K),p("main",{class:"stages"},Ma.element,G.element),Hs(Q,K,()=>tt),p("footer",{class:"mu\
ted small"},`${be.title} · matrixworld ${be.version}`),Et.dialog,bn,Pc);Object.assign(window,{matrixworldExplorer:{get match(){return G.match},get step(){return G.
player.step},get pace(){return G.player.pace},get playing(){return Et.view},play:t=>tt&&Xe(tt,Q[K.selected.run],{...K.selected,episode:t}),get shape(){return Q[K.
selected.run].payoff.shape}}});Ma.element.addEventListener("play",Lc);G.goTo(Sa);Sa||G.playSoon();Jn(Q,K,G);xo(Q,K,G,bn,()=>Et.open(),()=>tn(G.shown,be.playground));
window.addEventListener("hashchange",({newURL:t})=>tt&&Et.start(tt,new URL(t).hash));be.growing&&go(Q,K,()=>G.player.playing||document.querySelector("dialog[ope\
n]")!==null);requestAnimationFrame(()=>setTimeout(()=>{Vn().then(t=>{tt=t,G.start(t),Et.start(t,$c),document.body.dataset.ready="true"},t=>{G.element.prepend(p(
"p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
