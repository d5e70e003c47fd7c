/* built from web/ by "npm run build"; sources f4db7ea85c1762380bd8122c63a24aec1b50666b027b1555c7d507be797a8007 */
"use strict";(()=>{var _a=Object.create;var wn=Object.defineProperty;var Pa=Object.getOwnPropertyDescriptor;var $a=Object.getOwnPropertyNames;var Oa=Object.getPrototypeOf,La=Object.prototype.hasOwnProperty;var Ia=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(r){throw e=0,r}};var Na=(t,e,r,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of $a(e))!La.call(t,o)&&o!==r&&wn(t,o,{get:()=>e[o],enumerable:!(n=Pa(e,o))||n.enumerable});
return t};var Ba=(t,e,r)=>(r=t!=null?_a(Oa(t)):{},Na(e||!t||!t.__esModule?wn(r,"default",{value:t,enumerable:!0}):r,t));var sa=Ia(mn=>{var Zs=Object.defineProperty,Kl=t=>Zs(t,"__esModule",{value:!0}),Yl=(t,e)=>{for(var r in e)Zs(t,r,{get:e[r],enumerable:!0})};Kl(mn);Yl(mn,{GIFEncoder:()=>na,
applyPalette:()=>oc,default:()=>hc,nearestColor:()=>lc,nearestColorIndex:()=>ta,nearestColorIndexWithDistance:()=>ra,prequantize:()=>nc,quantize:()=>tc,snapColorsToPalette:()=>ic});
var Zl={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Js(t=256){let e=0,r=new Uint8Array(t);return{get buffer(){return r.buffer},reset(){e=0},bytesView(){return r.subarray(0,e)},bytes(){return r.slice(0,e)},
writeByte(o){n(e+1),r[e]=o,e++},writeBytes(o,s=0,a=o.length){n(e+a);for(let i=0;i<a;i++)r[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){n(e+a),r.set(o.subarray(
s,s+a),e),e+=a}};function n(o){var s=r.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=r;r=new Uint8Array(
o),e>0&&r.set(i.subarray(0,e),0)}}var un=12,qs=5003,Jl=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Xl(t,e,r,n,o=Js(512),s=new Uint8Array(
256),a=new Int32Array(qs),i=new Int32Array(qs)){let l=a.length,d=Math.max(2,n);s.fill(0),i.fill(0),a.fill(-1);let c=0,u=0,m=d+1,h=m,y=!1,f=h,g=(1<<f)-1,b=1<<m-1,
x=b+1,v=b+2,w=0,A=r[0],C=0;for(let S=l;S<65536;S*=2)++C;C=8-C,o.writeByte(d),T(b);let E=r.length;for(let S=1;S<E;S++)e:{let $=r[S],_=($<<un)+A,k=$<<C^A;if(a[k]===
_){A=i[k];break e}let re=k===0?1:l-k;for(;a[k]>=0;)if(k-=re,k<0&&(k+=l),a[k]===_){A=i[k];break e}T(A),A=$,v<1<<un?(i[k]=v++,a[k]=_):(a.fill(-1),v=b+2,y=!0,T(b))}
return T(A),T(x),o.writeByte(0),o.bytesView();function T(S){for(c&=Jl[u],u>0?c|=S<<u:c=S,u+=f;u>=8;)s[w++]=c&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),c>>=8,u-=8;if((v>g||y)&&(y?(f=h,g=(1<<f)-1,y=!1):(++f,g=f===un?1<<f:(1<<f)-1)),S==x){for(;u>0;)s[w++]=c&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),c>>=8,u-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Ql=Xl;function Xs(t,e,r){return t<<8&63488|e<<2&992|r>>3}function Qs(t,e,r,n){return t>>
4|e&240|(r&240)<<4|(n&240)<<8}function ea(t,e,r){return t>>4<<8|e&240|r>>4}function dr(t,e,r){return t<e?e:t>r?r:t}function kt(t){return t*t}function Ks(t,e,r){
var n=0,o=1e100;let s=t[e],a=s.cnt,i=s.ac,l=s.rc,d=s.gc,c=s.bc;for(var u=s.fw;u!=0;u=t[u].fw){let h=t[u],y=h.cnt,f=a*y/(a+y);if(!(f>=o)){var m=0;r&&(m+=f*kt(h.ac-
i),m>=o)||(m+=f*kt(h.rc-l),!(m>=o)&&(m+=f*kt(h.gc-d),!(m>=o)&&(m+=f*kt(h.bc-c),!(m>=o)&&(o=m,n=u))))}}s.err=o,s.nn=n}function dn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,
nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function ec(t,e){let r=e==="rgb444"?4096:65536,n=new Array(r),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>
24&255,l=a>>16&255,d=a>>8&255,c=a&255,u=Qs(c,d,l,i),m=u in n?n[u]:n[u]=dn();m.rc+=c,m.gc+=d,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],
i=a>>16&255,l=a>>8&255,d=a&255,c=ea(d,l,i),u=c in n?n[c]:n[c]=dn();u.rc+=d,u.gc+=l,u.bc+=i,u.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,d=a&
255,c=Xs(d,l,i),u=c in n?n[c]:n[c]=dn();u.rc+=d,u.gc+=l,u.bc+=i,u.cnt++}return n}function tc(t,e,r={}){let{format:n="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,
clearAlphaThreshold:a=0,oneBitAlpha:i=!1}=r;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof
Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),d=r.useSqrt!==!1,c=n==="rgba4444",u=ec(l,n),m=u.length,
h=m-1,y=new Uint32Array(m+1);for(var f=0,b=0;b<m;++b){let O=u[b];if(O!=null){var g=1/O.cnt;c&&(O.ac*=g),O.rc*=g,O.gc*=g,O.bc*=g,u[f++]=O}}kt(e)/f<.022&&(d=!1);for(var b=0;b<
f-1;++b)u[b].fw=b+1,u[b+1].bk=b,d&&(u[b].cnt=Math.sqrt(u[b].cnt));d&&(u[b].cnt=Math.sqrt(u[b].cnt));var x,v,w;for(b=0;b<f;++b){Ks(u,b,!1);var A=u[b].err;for(v=++y[0];v>
1&&(w=v>>1,!(u[x=y[w]].err<=A));v=w)y[v]=x;y[v]=b}var C=f-e;for(b=0;b<C;){for(var E;;){var T=y[1];if(E=u[T],E.tm>=E.mtm&&u[E.nn].mtm<=E.tm)break;E.mtm==h?T=y[1]=
y[y[0]--]:(Ks(u,T,!1),E.tm=b);var A=u[T].err;for(v=1;(w=v+v)<=y[0]&&(w<y[0]&&u[y[w]].err>u[y[w+1]].err&&w++,!(A<=u[x=y[w]].err));v=w)y[v]=x;y[v]=T}var S=u[E.nn],
$=E.cnt,_=S.cnt,g=1/($+_);c&&(E.ac=g*($*E.ac+_*S.ac)),E.rc=g*($*E.rc+_*S.rc),E.gc=g*($*E.gc+_*S.gc),E.bc=g*($*E.bc+_*S.bc),E.cnt+=S.cnt,E.mtm=++b,u[S.bk].fw=S.fw,
u[S.fw].bk=S.bk,S.mtm=h}let k=[];var re=0;for(b=0;;++re){let W=dr(Math.round(u[b].rc),0,255),O=dr(Math.round(u[b].gc),0,255),U=dr(Math.round(u[b].bc),0,255),P=255;
c&&(P=dr(Math.round(u[b].ac),0,255),i&&(P=P<=(typeof i=="number"?i:127)?0:255),o&&P<=a&&(W=O=U=s,P=0));let H=c?[W,O,U,P]:[W,O,U];if(rc(k,H)||k.push(H),(b=u[b].fw)==
0)break}return k}function rc(t,e){for(let r=0;r<t.length;r++){let n=t[r],o=n[0]===e[0]&&n[1]===e[1]&&n[2]===e[2],s=n.length>=4&&e.length>=4?n[3]===e[3]:!0;if(o&&
s)return!0}return!1}function mr(t,e){var r=0,n;for(n=0;n<t.length;n++){let o=t[n]-e[n];r+=o*o}return r}function pr(t,e){return e>1?Math.round(t/e)*e:t}function nc(t,{
roundRGB:e=5,roundAlpha:r=10,oneBitAlpha:n=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,d=a>>8&255,c=a&
255;i=pr(i,r),n&&(i=i<=(typeof n=="number"?n:127)?0:255),c=pr(c,e),d=pr(d,e),l=pr(l,e),o[s]=i<<24|l<<16|d<<8|c<<0}}function oc(t,e,r="rgb565"){if(!t||!t.buffer)
throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expecte\
d RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let n=new Uint32Array(t.buffer),o=n.length,s=r==="\
rgb444"?4096:65536,a=new Uint8Array(o),i=new Array(s),l=r==="rgba4444";if(r==="rgba4444")for(let d=0;d<o;d++){let c=n[d],u=c>>24&255,m=c>>16&255,h=c>>8&255,y=c&
255,f=Qs(y,h,m,u),g=f in i?i[f]:i[f]=sc(y,h,m,u,e);a[d]=g}else{let d=r==="rgb444"?ea:Xs;for(let c=0;c<o;c++){let u=n[c],m=u>>16&255,h=u>>8&255,y=u&255,f=d(y,h,m),
g=f in i?i[f]:i[f]=ac(y,h,m,e);a[c]=g}}return a}function sc(t,e,r,n,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],d=l[3],c=Oe(d-n);if(c>a)continue;let u=l[0];
if(c+=Oe(u-t),c>a)continue;let m=l[1];if(c+=Oe(m-e),c>a)continue;let h=l[2];c+=Oe(h-r),!(c>a)&&(a=c,s=i)}return s}function ac(t,e,r,n){let o=0,s=1e100;for(let a=0;a<
n.length;a++){let i=n[a],l=i[0],d=Oe(l-t);if(d>s)continue;let c=i[1];if(d+=Oe(c-e),d>s)continue;let u=i[2];d+=Oe(u-r),!(d>s)&&(s=d,o=a)}return o}function ic(t,e,r=5){
if(!t.length||!e.length)return;let n=t.map(a=>a.slice(0,3)),o=r*r,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>
s?i=i.slice(0,3):i=i.slice();let l=ra(n,i.slice(0,3),mr),d=l[0],c=l[1];c>0&&c<=o&&(t[d]=i)}}function Oe(t){return t*t}function ta(t,e,r=mr){let n=1/0,o=-1;for(let s=0;s<
t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return o}function ra(t,e,r=mr){let n=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return[
o,n]}function lc(t,e,r=mr){return t[ta(t,e,r)]}function na(t={}){let{initialCapacity:e=4096,auto:r=!0}=t,n=Js(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),
i=new Int32Array(o),l=!1;return{reset(){n.reset(),l=!1},finish(){n.writeByte(Zl.trailer)},bytes(){return n.bytes()},bytesView(){return n.bytesView()},get buffer(){
return n.buffer},get stream(){return n},writeHeader:d,writeFrame(c,u,m,h={}){let{transparent:y=!1,transparentIndex:f=0,delay:g=0,palette:b=null,repeat:x=0,colorDepth:v=8,
dispose:w=-1}=h,A=!1;if(r?l||(A=!0,d(),l=!0):A=!!h.first,u=Math.max(0,Math.floor(u)),m=Math.max(0,Math.floor(m)),A){if(!b)throw new Error("First frame must incl\
ude a { palette } option");uc(n,u,m,b,v),Ys(n,b),x>=0&&dc(n,x)}let C=Math.round(g/10);cc(n,w,C,y,f);let E=!!b&&!A;pc(n,u,m,E?b:null),E&&Ys(n,b),mc(n,c,u,m,v,s,a,
i)}};function d(){oa(n,"GIF89a")}}function cc(t,e,r,n,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,n=!1);var s,a;n?(s=1,a=2):(s=0,a=0),e>=0&&(a=
e&7),a<<=2,t.writeByte(0|a|0|s),Te(t,r),t.writeByte(o||0),t.writeByte(0)}function uc(t,e,r,n,o=8){let i=pn(n.length)-1,l=128|o-1<<4|0|i,d=0,c=0;Te(t,e),Te(t,r),
t.writeBytes([l,d,c])}function dc(t,e){t.writeByte(33),t.writeByte(255),t.writeByte(11),oa(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Te(t,e),t.writeByte(0)}
function Ys(t,e){let r=1<<pn(e.length);for(let n=0;n<r;n++){let o=[0,0,0];n<e.length&&(o=e[n]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function pc(t,e,r,n){
if(t.writeByte(44),Te(t,0),Te(t,0),Te(t,e),Te(t,r),n){let a=pn(n.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function mc(t,e,r,n,o=8,s,a,i){Ql(r,n,e,o,t,s,
a,i)}function Te(t,e){t.writeByte(e&255),t.writeByte(e>>8&255)}function oa(t,e){for(var r=0;r<e.length;r++)t.writeByte(e.charCodeAt(r))}function pn(t){return Math.
max(Math.ceil(Math.log2(t)),1)}var hc=na});var xn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},st={DISAPPEAR:0,REACH:1,BOUNCE:2},Sn={OCCUPATION:0,SURROUND:1},Mn={FAULT:0,INVOLVED:1};var xr=["obstacle","teammate","adversary"],Sr=["vertex","edge","chain"],An=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Mr=["p\
ursuer_{number}","evader_{number}"],En={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},at={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Tn="{event}: {outcome}",Ar={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Cn={free:".GS",blocked:"#@OTW"};var Ue=1+An.length;function it(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function q(t,e){return t<e?it(Mr[0],{number:t}):it(Mr[1],{number:t-e})}function Ua(t,e){
let[r,n,o,s,a,i,l,...d]=Array.from(t),c=a<0?[s]:[s,a],[u,m,h]=d.map(b=>c.filter((x,v)=>b>>v&1)),y=c.map(b=>q(b,e)),f=it(En[a<0?"obstacle":Sr[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=it(Tn,{event:f,outcome:Fa(c.length,m,h,e)});return{kind:xr[n],form:Sr[o],agents:c,cell:[i,l],at_fault:u,held:m,doomed:h,turn:r,
text:g}}function Fa(t,e,r,n){if(t===2&&e.length===2)return at["both held"];if(t===2&&r.length===2)return at["both doomed"];let o=s=>a=>it(at[s],{agent:q(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||at.none}function Pt(t,e){let r=[];for(let n=0;n<t.length;n+=Ue)r.push(Ua(t.subarray(n+1,n+Ue),e));
return r}var we=class extends Error{name="EngineError"};function F(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var Fe=class{bytes;constructor(e){this.bytes=e}},_n=0,Tr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],kn=4,Rn=4,za=new TextEncoder,
Da=new TextDecoder;function Wa(t){for(let e=Tr.length-1;e>_n;--e)if(t instanceof Tr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Er(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ha(t){return za.encode(`${t}\0`)}var Cr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Ha(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Fe,l=i?a.bytes:
a;return[this.text(s),i?_n:Wa(l),l.length,this.copy(Er(l))]}),o=this.copy(Er(Int32Array.from(n)));return this.copy(Er(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Pn(t,e){let r=t.HEAPU8;return Da.decode(r.subarray(e,r.indexOf(0,e)))}function ze(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/kn,n=e[r+1]/kn,o={};for(let s=n;s<n+e[r]*Rn;s+=Rn){let a=Tr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Pn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new Cr(t);try{let n=e(r);if(n===0)throw new we(Pn(t,t._last_error()));return n}finally{r.free()}}var ja=2**31-1,$n=["none","elman","gru"],Ga=2n**64n-1n,Va=34028234663852886e22;function ye(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ja)throw F(
t,"an integer",e);return Int32Array.of(e)}function $t(t,e){if(typeof e!="boolean")throw F(t,"true or false",e);return new Fe(Uint8Array.of(Number(e)))}function Ce(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw F(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function kr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Va))throw F(t,"a finite number",e);return e}function De(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Ga)throw F(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function qa(t){return{"rules.interaction":Ce("interactio\
n",t.interaction,xn),"rules.obstacle":Ce("obstacle",t.obstacle,st),"rules.teammate":Ce("teammate",t.teammate,st),"rules.evader":Ce("evader",t.evader,st),"rules.\
pursuer":Ce("pursuer",t.pursuer,st),"rules.capture":Ce("capture",t.capture,Sn),"rules.captured_disappear":$t("captured_disappear",t.captured_disappear)}}function On(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw F(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>kr(t,n))}function Ka(t){let e=(r,n)=>Float32Array.
of(kr(r,t[r]),kr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":On("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":On("evader_collide",t.evader_collide),
"rewards.blame":Ce("blame",t.blame,Mn),"rewards.capture_repeats":$t("capture_repeats",t.capture_repeats)}}function In(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Cn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw F(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw F(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Nn(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function We(t){Nn(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...qa(t.rules),...Ka(t.rewards),rows:ye("rows",t.rows),cols:ye("cols",t.cols),n_pursuers:ye("n_pursuers",t.n_pursuers),n_evaders:ye("n_evaders",t.n_evaders),fov:ye(
"fov",t.fov),diagonal:$t("diagonal",t.diagonal),max_steps:ye("max_steps",t.max_steps),density:Float64Array.of(e),map:In(t.obstacles)}}function Ln(t,e){return Int32Array.
from((e??[]).flat(),r=>ye(t,r)[0])}function Bn(t,e){return Nn(t.obstacles,e),{seed:De("seed",t.seed??0n),episode:De("episode",t.episode??0),pursuers:Ln("pursuer\
s",t.pursuers),evaders:Ln("evaders",t.evaders),map:In(t.obstacles)}}function Ot(t){return{actions:Int32Array.from(t,e=>ye("actions",e)[0])}}function He(t){if(typeof t==
"string"){if(!Object.hasOwn(Ar,t))throw F("policy",`one of ${Object.keys(Ar).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw F("activation","'relu' or 'tanh'",t.activation);if(!$n.includes(t.memory))throw F("memory",`one of ${$n.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>ye("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:$t("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Ya=["first_turn","terminated","truncated"];function Un(t){let e={...t};for(let r of Ya)e[r]=new Fe(t[r]);return e}var Fn="statistics.",Lt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=zn(Dn(o),0),Object.assign(this,o),this.first_conflict=Za(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Ue,n*Ue);return Pt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function Za(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Ue)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function zn(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var Dn=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(Fn)?[[e.slice(Fn.length),r]]:[]));function Wn(t,e,r,n){let o=[We(r.config),He(r.pursuers),He(r.evaders),
n];return xe(t,s=>{let[a,i,l,d]=o.map(c=>s.arrays(c));return t[e](a,i,l,d)}),ze(t)}function Hn(t,e,r,n){let o={seed:De("seed",r),episode:De("episode",n)};return new Lt(
e.config,r,n,Wn(t,"_play_match",e,o))}function Rr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let o=Wn(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return Dn(o)}function jn(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:De("seed",r)},s=Rr(t,e,o,n);return Array.
from({length:n},(a,i)=>zn(s,i))}var Ja=7e6,Xa=new FinalizationRegistry(([t,e])=>t._states_free(e));function Qa({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,d=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),c=t.capture==="SURROUND"||t.evader===
"REACH",u=t.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(b,x)=>u?f:(f+x)/(x+1)).reduce((b,x)=>b*x,1),h=m(l+Number(d),s)*m(l*(1+Number(c))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function It(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Qa(t)>Ja?"the world is too large to be solved on the page":""}var _r=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,d]=e.actors,c=Array.from(i).filter(m=>l<=m&&m<d),u=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(u),play:o},{agents:c.filter(m=>!u(m)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((d,c)=>d*this.n_actions+e[c],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,d,c)=>l+
d*this.matrix[r*s.length+c],0),i=o.reduce((l,d,c)=>l+d*this.matrix[c*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Pr=60,lt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,a=>e._states_new(a.arrays(We(r)))),Xa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let s=this.call(()=>e._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?s:s.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.call(a=>this.engine._states_backup(this.
states,o,a.arrays({next:s}))).values}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,Pr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}game(e){let[r,{turn:n}]=[this.config.
max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new _r(e,a):null}call(e){return xe(this.engine,e),ze(this.engine)}};var Gn=new FinalizationRegistry(([t,e])=>t._world_free(e)),ct=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(We(r)))),Gn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Gn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Bn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Ot(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Ot(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
He(e),Ot(n)],{actions:d}=this.call(c=>this.engine._world_decide(this.address,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.from(d)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Pt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=He(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:ei(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Un(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return xe(this.engine,e),ze(this.engine)}};function ei(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var $r=class{compiled;constructor(e){this.compiled=e}world(e){return new ct(this.compiled,e)}solution(e,r="capture-rate"){return new lt(this.compiled,e,r)}match(e,r,n,o,s=0){
return Hn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return jn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return Rr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Vn;function qn(t=globalThis.matrixworldEngine){return Vn??=ti(t),Vn}async function ti(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new $r(await t({wasmBinary:e}))}var ri="http://www.w3.org/2000/svg";function p(t,e={},...r){return Kn(document.createElement(t),e,r)}function M(t,e={},...r){return Kn(document.createElementNS(
ri,t),e,r)}function Kn(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(ni).map(n=>typeof n=="number"?String(n):n)),t}function ni(t){return t!=null&&t!==!1}var ut=()=>["file:","http:","https:"].
includes(location.protocol);async function Yn(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}function oi(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function Or(){document.documentElement.
dataset.theme=oi()?"light":"dark"}if(typeof document<"u"){let t=document.documentElement.dataset,e=t.theme;addEventListener("beforeprint",()=>{e=t.theme,t.theme=
"light"}),addEventListener("afterprint",()=>{e?t.theme=e:delete t.theme})}function Zn(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:Or},"◐")}var Jn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,Zn()));var si=2n**64n-1n;function dt(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(d,c,u)=>{let m=n.get(d)??"";return/^\d{1,9}$/.test(m)&&Number(m)<c?Number(
m):u},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=si?l:null,step:o("step",1/0,0)}}function Xn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:d,episode:c,seed:u}=e.selected,m={run:i,pursuers:l,evaders:d,episode:c,...u===null?{}:{seed:u},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(m).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=dt(location.
hash,t,e.selected);for(let d of document.querySelectorAll("dialog[open]"))d.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var N=Uint8Array,X=Uint16Array,Wr=Int32Array,Bt=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ut=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Br=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),oo=function(t,e){for(var r=new X(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Wr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},so=oo(Bt,2),ao=so.b,Ur=so.r;ao[28]=258,Ur[258]=28;var io=oo(
Ut,0),ai=io.b,Qn=io.r,Fr=new X(32768);for(R=0;R<32768;++R)ge=(R&43690)>>1|(R&21845)<<1,ge=(ge&52428)>>2|(ge&13107)<<2,ge=(ge&61680)>>4|(ge&3855)<<4,Fr[R]=((ge&65280)>>
8|(ge&255)<<8)>>1;var ge,R,ue=(function(t,e,r){for(var n=t.length,o=0,s=new X(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new X(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new X(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var d=o<<4|t[o],c=e-t[o],u=a[t[o]-1]++<<c,m=u|(1<<c)-1;u<=m;++u)i[Fr[u]>>l]=d}else for(i=new X(
n),o=0;o<n;++o)t[o]&&(i[o]=Fr[a[t[o]-1]++]>>15-t[o]);return i}),Se=new N(288);for(R=0;R<144;++R)Se[R]=8;var R;for(R=144;R<256;++R)Se[R]=9;var R;for(R=256;R<280;++R)
Se[R]=7;var R;for(R=280;R<288;++R)Se[R]=8;var R,ht=new N(32);for(R=0;R<32;++R)ht[R]=5;var R,ii=ue(Se,9,0),li=ue(Se,9,1),ci=ue(ht,5,0),ui=ue(ht,5,1),Lr=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},ie=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Ir=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Hr=function(t){return(t+7)/8|0},jr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new N(t.subarray(
e,r))};var di=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],K=function(t,e,r){var n=new Error(e||di[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,K),!r)throw n;return n},pi=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new N(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new N(o*3));var d=function(nt){var ot=r.length;if(nt>ot){var Be=new N(Math.max(ot*2,nt));Be.set(r),r=Be}},c=e.f||0,u=e.
p||0,m=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,b=o*8;do{if(!h){c=ie(t,u,1);var x=ie(t,u+1,3);if(u+=3,x)if(x==1)h=li,y=ui,f=9,g=5;else if(x==2){var C=ie(t,u,31)+257,E=ie(
t,u+10,15)+4,T=C+ie(t,u+5,31)+1;u+=14;for(var S=new N(T),$=new N(19),_=0;_<E;++_)$[Br[_]]=ie(t,u+_*3,7);u+=E*3;for(var k=Lr($),re=(1<<k)-1,W=ue($,k,1),_=0;_<T;){
var O=W[ie(t,u,re)];u+=O&15;var v=O>>4;if(v<16)S[_++]=v;else{var U=0,P=0;for(v==16?(P=3+ie(t,u,3),u+=2,U=S[_-1]):v==17?(P=3+ie(t,u,7),u+=3):v==18&&(P=11+ie(t,u,
127),u+=7);P--;)S[_++]=U}}var H=S.subarray(0,C),z=S.subarray(C);f=Lr(H),g=Lr(z),h=ue(H,f,1),y=ue(z,g,1)}else K(1);else{var v=Hr(u)+4,w=t[v-4]|t[v-3]<<8,A=v+w;if(A>
o){l&&K(0);break}i&&d(m+w),r.set(t.subarray(v,A),m),e.b=m+=w,e.p=u=A*8,e.f=c;continue}if(u>b){l&&K(0);break}}i&&d(m+131072);for(var Le=(1<<f)-1,ne=(1<<g)-1,fe=u;;fe=
u){var U=h[Ir(t,u)&Le],Z=U>>4;if(u+=U&15,u>b){l&&K(0);break}if(U||K(2),Z<256)r[m++]=Z;else if(Z==256){fe=u,h=null;break}else{var J=Z-254;if(Z>264){var _=Z-257,I=Bt[_];
J=ie(t,u,(1<<I)-1)+ao[_],u+=I}var ce=y[Ir(t,u)&ne],Ie=ce>>4;ce||K(3),u+=ce&15;var z=ai[Ie];if(Ie>3){var I=Ut[Ie];z+=Ir(t,u)&(1<<I)-1,u+=I}if(u>b){l&&K(0);break}
i&&d(m+131072);var Ne=m+J;if(m<z){var Rt=s-z,_t=Math.min(z,Ne);for(Rt+m<0&&K(3);m<_t;++m)r[m]=n[Rt+m]}for(;m<Ne;++m)r[m]=r[m-z]}}e.l=h,e.p=fe,e.b=m,e.f=c,h&&(c=
1,e.m=f,e.d=y,e.n=g)}while(!c);return m!=r.length&&a?jr(r,0,m):r.subarray(0,m)},be=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},pt=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Nr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:co,l:0};if(o==1){var a=new N(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,C){return A.f-C.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],d=0,
c=1,u=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};c!=o-1;)i=r[r[d].f<r[u].f?d++:u++],l=r[d!=c&&r[d].f<r[u].f?d++:u++],r[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,n=1;n<
o;++n)s[n].s>m&&(m=s[n].s);var h=new X(m+1),y=zr(r[c-1],h,0);if(y>e){var n=0,f=0,g=y-e,b=1<<g;for(s.sort(function(C,E){return h[E.s]-h[C.s]||C.f-E.f});n<o;++n){
var x=s[n].s;if(h[x]>e)f+=b-(1<<y-h[x]),h[x]=e;else break}for(f>>=g;f>0;){var v=s[n].s;h[v]<e?f-=1<<e-h[v]++-1:++n}for(;n>=0&&f;--n){var w=s[n].s;h[w]==e&&(--h[w],
++f)}y=e}return{t:new N(h),l:y}},zr=function(t,e,r){return t.s==-1?Math.max(zr(t.l,e,r+1),zr(t.r,e,r+1)):e[t.s]=r},eo=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new X(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},mt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},lo=function(t,e,r){var n=r.length,o=Hr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},to=function(t,e,r,n,o,s,a,i,l,d,c){be(e,c++,r),++o[256];for(var u=Nr(o,15),m=u.t,h=u.l,y=Nr(s,15),f=y.t,g=y.l,b=eo(m),x=b.c,
v=b.n,w=eo(f),A=w.c,C=w.n,E=new X(19),T=0;T<x.length;++T)++E[x[T]&31];for(var T=0;T<A.length;++T)++E[A[T]&31];for(var S=Nr(E,7),$=S.t,_=S.l,k=19;k>4&&!$[Br[k-1]];--k)
;var re=d+5<<3,W=mt(o,Se)+mt(s,ht)+a,O=mt(o,m)+mt(s,f)+a+14+3*k+mt(E,$)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&re<=W&&re<=O)return lo(e,c,t.subarray(l,l+d));var U,P,H,
z;if(be(e,c,1+(O<W)),c+=2,O<W){U=ue(m,h,0),P=m,H=ue(f,g,0),z=f;var Le=ue($,_,0);be(e,c,v-257),be(e,c+5,C-1),be(e,c+10,k-4),c+=14;for(var T=0;T<k;++T)be(e,c+3*T,
$[Br[T]]);c+=3*k;for(var ne=[x,A],fe=0;fe<2;++fe)for(var Z=ne[fe],T=0;T<Z.length;++T){var J=Z[T]&31;be(e,c,Le[J]),c+=$[J],J>15&&(be(e,c,Z[T]>>5&127),c+=Z[T]>>12)}}else
U=ii,P=Se,H=ci,z=ht;for(var T=0;T<i;++T){var I=n[T];if(I>255){var J=I>>18&31;pt(e,c,U[J+257]),c+=P[J+257],J>7&&(be(e,c,I>>23&31),c+=Bt[J]);var ce=I&31;pt(e,c,H[ce]),
c+=z[ce],ce>3&&(pt(e,c,I>>5&8191),c+=Ut[ce])}else pt(e,c,U[I]),c+=P[I]}return pt(e,c,U[256]),c+P[256]},mi=new Wr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),co=new N(0),hi=function(t,e,r,n,o,s){var a=s.z||t.length,i=new N(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),d=s.l,c=(s.r||0)&7;if(e){
c&&(l[0]=s.r>>3);for(var u=mi[e-1],m=u>>13,h=u&8191,y=(1<<r)-1,f=s.p||new X(32768),g=s.h||new X(y+1),b=Math.ceil(r/3),x=2*b,v=function(wr){return(t[wr]^t[wr+1]<<
b^t[wr+2]<<x)&y},w=new Wr(25e3),A=new X(288),C=new X(32),E=0,T=0,S=s.i||0,$=0,_=s.w||0,k=0;S+2<a;++S){var re=v(S),W=S&32767,O=g[re];if(f[W]=O,g[re]=W,_<=S){var U=a-
S;if((E>7e3||$>24576)&&(U>423||!d)){c=to(t,l,0,w,A,C,T,$,k,S-k,c),$=E=T=0,k=S;for(var P=0;P<286;++P)A[P]=0;for(var P=0;P<30;++P)C[P]=0}var H=2,z=0,Le=h,ne=W-O&32767;
if(U>2&&re==v(S-ne))for(var fe=Math.min(m,U)-1,Z=Math.min(32767,S),J=Math.min(258,U);ne<=Z&&--Le&&W!=O;){if(t[S+H]==t[S+H-ne]){for(var I=0;I<J&&t[S+I]==t[S+I-ne];++I)
;if(I>H){if(H=I,z=ne,I>fe)break;for(var ce=Math.min(ne,I-2),Ie=0,P=0;P<ce;++P){var Ne=S-ne+P&32767,Rt=f[Ne],_t=Ne-Rt&32767;_t>Ie&&(Ie=_t,O=Ne)}}}W=O,O=f[W],ne+=
W-O&32767}if(z){w[$++]=268435456|Ur[H]<<18|Qn[z];var nt=Ur[H]&31,ot=Qn[z]&31;T+=Bt[nt]+Ut[ot],++A[257+nt],++C[ot],_=S+H,++E}else w[$++]=t[S],++A[t[S]]}}for(S=Math.
max(S,_);S<a;++S)w[$++]=t[S],++A[t[S]];c=to(t,l,d,w,A,C,T,$,k,S-k,c),d||(s.r=c&7|l[c/8|0]<<3,c-=7,s.h=g,s.p=f,s.i=S,s.w=_)}else{for(var S=s.w||0;S<a+d;S+=65535){
var Be=S+65535;Be>=a&&(l[c/8|0]=d,Be=a),c=lo(l,c+1,t.subarray(S,Be))}s.i=a}return jr(i,0,n+Hr(c)+o)},fi=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),yi=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=fi[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var gi=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return hi(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},uo=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var j=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var bi=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&K(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&K(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function vi(t,e){return gi(t,e||{},0,0)}function po(t,e){return pi(t.subarray(bi(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var mo=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=uo(n,s[1]),s=s[0]),s instanceof N?r[a]=[s,i]:(r[a+="/"]=[new N(0),i],mo(s,a,r,
n))}},ro=typeof TextEncoder<"u"&&new TextEncoder,wi=typeof TextDecoder<"u"&&new TextDecoder,xi=0;try{wi.decode(co,{stream:!0}),xi=1}catch{}function Nt(t,e){if(e){for(var r=new N(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(ro)return ro.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var l=new N(a+8+(o-n<<1));l.set(s),s=l}var d=t.charCodeAt(n);d<128||e?i(d):d<2048?(i(192|
d>>6),i(128|d&63)):d>55295&&d<57344?(d=65536+(d&1047552)|t.charCodeAt(++n)&1023,i(240|d>>18),i(128|d>>12&63),i(128|d>>6&63),i(128|d&63)):(i(224|d>>12),i(128|d>>
6&63),i(128|d&63))}return jr(s,0,a)}var Dr=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&K(9),e+=n+4}return e},no=function(t,e,r,n,o,s,a,i){var l=n.length,d=r.extra,c=i&&i.length,
u=Dr(d);j(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var m=new Date(r.mtime==null?Date.now():r.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&K(10),j(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(j(t,e,r.crc),j(t,e+4,s<0?-s-2:s),j(t,e+8,r.size)),j(t,e+12,l),j(t,e+14,u),e+=16,a!=null&&(j(t,e,
c),j(t,e+6,r.attrs),j(t,e+10,a),e+=14),t.set(n,e),e+=l,u)for(var y in d){var f=d[y],g=f.length;j(t,e,+y),j(t,e+2,g),t.set(f,e+4),e+=4+g}return c&&(t.set(i,e),e+=
c),e},Si=function(t,e,r,n,o){j(t,e,101010256),j(t,e+8,r),j(t,e+10,r),j(t,e+12,n),j(t,e+16,o)};function ho(t,e){e||(e={});var r={},n=[];mo(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],d=i[1],c=d.level==0?0:8,u=Nt(a),m=u.length,h=d.comment,y=h&&
Nt(h),f=y&&y.length,g=Dr(d.extra);m>65535&&K(11);var b=c?vi(l,d):l,x=b.length,v=yi();v.p(l),n.push(uo(d,{size:l.length,crc:v.d(),c:b,f:u,m:y,u:m!=a.length||y&&h.
length!=f,o,compression:c})),o+=30+m+g+x,s+=76+2*(m+g)+(f||0)+x}for(var w=new N(s+22),A=o,C=s-o,E=0;E<n.length;++E){var u=n[E];no(w,u.o,u,u.f,u.u,u.c.length);var T=30+
u.f.length+Dr(u.extra);w.set(u.c,u.o+T),no(w,o,u,u.f,u.u,u.c.length,u.o,u.m),o+=16+T+(u.m?u.m.length:0)}return Si(w,o,n.length,C,A),w}var G=(t,e)=>`${t}s of generation ${e}`,de=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Q=["pursuer","evader"];function yo(){return JSON.parse(Ft("data"))}function je(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function ke(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${G(e,r)}: it would be too large. Choose a generation of ${s.join("\
, ")}.`;let i=s.length*o.genome_size;return go(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wri\
te it again from its run.`}function ee(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,d=go(a,l).subarray(i*l,(i+1)*l),{hidden:c,activation:u,
sampled:m,memory:h}=o;return{hidden:c,activation:u,sampled:m,memory:h,genome:d}}var Gr=4,fo=new Map;function go(t,e){let r=fo.get(t);if(r)return r;let n=new Float32Array;try{let o=Ai(Vr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Mi(o)))throw o}return fo.set(t,n),n}var Mi=t=>t instanceof Error&&"code"in t;function Ai(t,e){let r=po(t),n=r.length/Gr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Gr*n+Math.floor(a/Gr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Vr(t){let e=atob(Ft(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Ft(t){return document.getElementById(
t)?.textContent??""}var Ge=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function bo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Ge.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Re=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ei=(t,e)=>t[0]===e[0]&&
t[1]===e[1],qr=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Kr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Yr=(t,e)=>Kr(t.fault,e),vo=(t,e)=>!Yr(
t,e)&&Kr(t.involved,e,2);function zt(t,e,r){let n=!Ei(L(t,r),L(e,r)),o=e.involved===void 0||Kr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function Dt(t,e,r){
let[n,o]=L(t,r),[s,a]=Ge[e.actions?.[r]??0];return[n+s,o+a]}function ft(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var wo=t=>t.moments.flatMap((e,r)=>r&&ft(t,t.moments[r-1],e).length?[r]:[]);function Wt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var xo=[-.31,0,.31],So=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:xo.flatMap(t=>xo.map(e=>[e,t]))}],Ti=.3,Ci=.35,ki=.55;function yt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=L(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Mo(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of yt(t,e).values()){let o=So[Math.min(n.length,So.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var Ao=t=>t*t*(3-2*t),Ve=(t,e,r)=>t+(e-t)*r,Eo=t=>Math.min(1,Math.max(0,t));function To(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Ao(n);let s=o===r?e:+!Re(t,e),a=Math.max(1/o,Ci);return Ao(Eo((n-s/(o-1)*(1-a))/a))}function Ht(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Mo(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Mo(t,a);return s.map((l,d)=>{let c=To(
t,d,s.length,e-n);return Ri(o,a,d,l,i[d],c)})}function Zr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=To(t,e,s.alive.length,r-o),[[l,d],[c,u]]=[L(s,e),L(a,e)];return[Ve(d,u,i)+.5,Ve(l,c,i)+.5]}function Ri(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Ve(n.x,o.x,
s),y:Ve(n.y,o.y,s),size:a?n.size:Ve(n.size,o.size,s),alpha:a?Eo((1-s)/(1-ki)):Ve(n.alpha,o.alpha,s)};if(zt(t,e,r)){let[l,d]=L(t,r),[c,u]=Dt(t,e,r),m=Ti*Math.sin(
Math.PI*s);i.x+=(u-d)*m,i.y+=(c-l)*m}return i}var Co=2*Math.PI;function _e(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Co)}function jt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,c]=s[(l+1)%3];t.arcTo(a,i,d,c,n*.09)}),t.closePath()}function ko(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Ro(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Co*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function _o(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Po=4,_i=1.6,Pi=.95,$i=5,Oi=.16,Li=9,Ii=.09,Ni=.2,$o=.75,oe=(t,e)=>t.left+e*t.cell,se=(t,e)=>t.top+e*t.cell;function qe(t,e,r){return Re(e,r)?t.colors.pursuer:
t.colors.evader}function Oo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,d),s<$i)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let u=1;u<i;u++)t.fillRect(n+u*s,o,c,d);for(let u=1;u<a;u++)t.fillRect(n,o+u*s,l,c)}function Lo({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[c,u]=[Math.floor(d/l),
d%l];t.fillRect(o+u*a,s+c*a,a,a)}Io({ctx:t,grid:e,colors:r})}function Io({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function No({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,d=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*n+a/40;for(let u=0;u<l;u+=d)t.fillText(String(u),o+(u+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let u=0;u<i;u+=d)t.fillText(
String(u),o-c,s+(u+.5)*a)}function Bo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[oe(t,s),se(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Uo(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Bo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Io(t)}function Fo({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[oe(e,n),se(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let u=d-i/2<c*1.2,m=d+(u?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,m),t.fillStyle=r.ink,t.fillText("You",l,m),t.globalAlpha=1}function zo(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Bo(t,e,n,o),l=qe(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Do(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Li,
Math.max(1,a.cell*Oi));for(let d=Math.max(1,Math.floor(r-n)+1);d<=i;d++){let[c,u]=[e.moments[d-1],e.moments[d]],m=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=
$o+(Ni-$o)*m;for(let h=0;h<u.alive.length;h++){let y=d===i&&r<i;if(!c.alive[h]||!(l.alive[h]||y))continue;let f=(Re(e,h)?-1:1)*Ii,[g,b]=L(c,h),[x,v]=L(u,h);if(g===
x&&b===v)continue;let w=y?o[h].x:v+.5,A=y?o[h].y:x+.5;s.strokeStyle=qe(t,e,h),s.beginPath(),s.moveTo(oe(a,b+.5+f),se(a,g+.5+f)),s.lineTo(oe(a,w+f),se(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Wo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Po+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Po,l=ft(e,s,a);for(let d of Wt(s,a))l.includes(d)||Ui(t,L(a,d),i);for(let d of l)Bi(t,L(a,d),i)}t.ctx.globalAlpha=1}function Bi({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Ro(t,oe(e,o+.5),se(e,n+.5),Math.max(8,e.cell*_i)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ui({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,ko(t,oe(e,o+.5),se(e,n+.5),Math.max(7,e.cell*Pi)),
t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Ho({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[oe(e,i)+s,se(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function jo({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,_e(t,oe(e,n),se(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Fi=.8,zi=.92,Di=15,Wi=7,Jr=9;function Go(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Hi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of yt(e,r).values())a.length>
Jr&&ji(t,n[a[Jr-1]],a.length-Jr+1)}function Hi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=t,c=Re(e,n),[u,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(c?zi:Fi)),y=qe(t,e,n),f=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?jt:_e)(i,u,m,h),h>Wi*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?d.paper:y,i.fill(),f&&(_e(i,u,m,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Di*a)return;let g=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(c?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:d.paper,i.fillText(
g,u,m+h*(c?.17:.03))}function ji({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Gi=.46,Vi=.86,qi=.66,Vo=.48,Ki=.78,Yi=.58;function qo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)zt(o,s,d)&&Zi(t,e,L(o,d),Dt(o,s,d));a.globalAlpha=
1}function Zi({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=u=>oe(e,n[1]+.5+s*u),l=u=>se(e,n[0]+.5+a*u),d=qr(r,o)?Ki:Yi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Vo),l(Vo)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*c,l(d)+
s*c),t.lineTo(i(d)+a*c,l(d)-s*c),t.stroke()}function Ko(t,e,r,n,o,s){let a=Ge[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,c=qr(e,[n[0]+a[0],n[1]+a[1]])?Vi:
qi,u=Gi*o.size,m=[oe(l,o.x+a[1]*u),se(l,o.y+a[0]*u),oe(l,o.x+a[1]*c),se(l,o.y+a[0]*c)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[
d.paper,h*2.1],[qe(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,_o(i,...m,l.cell*.2),i.stroke()}var Gt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Vt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),d=e.moments[l],c=r===l,u=Ht(e,r),m=c?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Oo(t);for(let f of n.
viewers)u[f]?.alpha&&zo(t,e,f,...Zr(e,f,r));Lo(t,e),n.axes&&No(t,o),Do(t,e,r,n.trail,u),Ho(t,d.contested??[],m),Wo(t,e,r),qo(t,e,l,m),u.forEach(({x:f,y:g,size:b},x)=>{
let v=vo(d,x)?.4:0,w=Yr(d,x)?1:v;w&&jo(t,f,g,b,w*m)});let h=c?d:e.moments[Math.max(0,l-1)];if(Go(t,e,h,u,n.numbers,o),c&&n.plan)for(let[f,g]of u.entries())g.alpha&&
Ko(t,e,f,L(d,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Uo(t,e,...Zr(e,n.you,r)),Fo(t,u[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:u[n.selected];y?.alpha&&Yo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Yo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Yo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var gt=(t,e)=>(e+.24)/(t+.24);function qt(t,e,r,n,o,s){let a=r?28*s:0,i=(d,c)=>(d-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Zo(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Ji={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ke(t){let e=getComputedStyle(t),r=Object.entries(Ji).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var le=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#s;#l;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Gt,...r},this.#s=new ResizeObserver(()=>this.#m()),this.#s.observe(e),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#p)}close(){this.#s.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#p),cancelAnimationFrame(this.#a)}get look(){return this.#t}set look(e){this.#t={...this.#t,...e},this.#c(),this.redraw()}show(e,r){this.#e=e,
this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#c(),this.redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};#p=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=qt(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Ke(this.canvas)};Vt(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Zo(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=yt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ht(this.#e,Math.round(this.#r)),i=l=>{let[d,c]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(d-e,c-r)};return s.length?s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(gt(e,r)))}#m(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Xi=12e3;function Jo(t,e,r){let n=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>u(
d-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>u(d+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>u(0,!le())},"A guided minute"),[d,c]=[-1,0];function u(g,b){
clearTimeout(c);let x=n()[g];if(y(),!x)return m();d=g,o.replaceChildren(p("span",{class:"muted numbers"},`${g+1} of ${n().length} `),x.text),s.disabled=g===0,a.
textContent=g===n().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:x.pursuer,evader:x.evader}),x.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):x.shows==="checkerboard"?h():(r.reveal(),r.playSoon()),b&&(c=setTimeout(()=>u(g+1,!0),Xi))}function m(){clearTimeout(c),d=-1,i.
hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let g=document.querySelector("dialog.four[open]");g?.append(i),g?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let y=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!n().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",g=>{g.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var bt=[.5,1,2,4,8,16,32,64],Ye=0,Kt=12,Qi=2,Ae=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#l=null;#p=0;#c=[];#m=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#r=r.speed??4,this.#t=r.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(Qi,this.#e/Kt)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=bt.findIndex(n=>n>=this.pace);this.speed=bt[Math.min(bt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#d(r),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#a),this.#o("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#l===null&&(this.#p=performance.now(),
this.#l=requestAnimationFrame(()=>this.#h()))}#h(){this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#l=requestAnimationFrame(()=>this.#h()))}#u(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Ee(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var vt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ze(t){let e=Math.min(1,Math.max(0,t))*(vt.length-1),r=Math.min(vt.length-2,Math.floor(e)),[n,o]=[vt[r],
vt[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Yt(t){let[e,r,n]=Ze(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var Zt=t=>`rgb(${Ze(t).join(" ")})`,Xo=()=>`linear-gradient(to right, ${vt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Jt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=el(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function el(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,d)=>{let c=4*((e-1-i-t.first[0])*r+d+t.first[1]);s.data.set([...Ze(l),255],c)})),o.putImageData(s,0,0),n}function Xt(t,e){let r=p("span",{class:"grad\
ient"});return r.style.backgroundImage=Xo(),p("p",{class:"scale-of-rates small muted"},t,r,e)}var tl=84;function Qo(t,e){let r=t.map((s,a)=>rl(s,a,e)),n=p("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function rl(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=tl/
Math.max(n,o),i=p("canvas",{"aria-hidden":"true"});Jt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=p("span",{class:"place"}),d=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Xr(t,e,r)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${nl(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:u=>{d.setAttribute("aria-current",String(u));let m=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=m>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-m-.5)*a}px`}}}var nl=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Xr(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var ol=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function es(){let t=ol.map(([r,n])=>p("div",{class:"key-row"},p("dt",{},...r.map(o=>p("kbd",{},o))),p("dd",{},n))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function ts(t,e,r,n,o,s){let a=(l,d)=>()=>{let c=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(c-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:Or,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let d=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,c=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||d||c||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let u=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(Ee(r.player,l)||u)u?.();else if(t[m])Xr(t[m],
m,e);else return;l.preventDefault()})}function rs(t,e,r,n,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!n()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("progress").then(d=>d.json()).catch(()=>null);o(l),l!==null&&(l.version==="end"||l.version!==t&&a()?(sl(e,
r),location.reload()):setTimeout(()=>{i()},1e3))};i()}function sl(t,e){let{run:r,pursuer:n,evader:o}=e.selected,[s,a]=t[r].payoff.shape;n===s-1&&o===a-1&&history.
replaceState(null,"",`#run=${r}`)}function Qr(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function en(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Qt(t){let e=Array.from({length:t.length+1},(r,n)=>al(t,n));return Qr(t.config,t.map,e)}function al(t,e){
let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),
everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var il=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function ns(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:il,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var ll={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function os(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:ll[t]}))}function wt(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},os(t))}function Je(t){let e=wt("play","Play","Space",()=>t.toggle()),r=cl(t),
n=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=ul(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},wt("first","First step","Home",()=>t.move(-t.length)),wt("back","Step back","←",()=>t.move(-1)),
e,wt("forward","Step forward","→",()=>t.move(1)),wt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,r),a,s),l=(u,m={})=>{let h=p("i",
m);return h.style.left=`${100*u/Math.max(1,t.length)}%`,h},d=()=>{n.replaceChildren(...t.marks.map(u=>l(u))),o.replaceChildren(...t.ticks.map(({step:u,kind:m,size:h,
text:y})=>{let f=l(u,{class:m,title:`Step ${u}: ${y}`});return f.style.height=`${100*h}%`,f}))},c=()=>{e.replaceChildren(os(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",c),t.addEventListener("s\
tate",c),t.addEventListener("state",d),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==r)&&Ee(t,u)&&u.preventDefault()}),
c(),i}function cl(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function ul(t){let e=`Steps a second, or the whole in ${Kt} s (+ and -)`,r=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:Ye},`in ${Kt} s`),...bt.map(n=>p("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}var B=(t,e=2)=>t==null?"-":t.toFixed(e);function ss(t,e,r){return e===null||r===null?B(t):`${B(t)} (${B(e)} to ${B(r)})`}var as=t=>t.toLocaleString("en-GB"),Pe=t=>t.
charAt(0).toUpperCase()+t.slice(1);function xt(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(d,c)=>(i+c)*a)}var dl=40,er=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=je(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,dl).map((m,h)=>this.#n(m,h)));let l=a===null?i?.rates[s]:void 0,d=r.statistics.capture_rate,
c=l!==void 0&&Math.abs(d-l)<1e-6&&r.length===i?.lengths[s],u=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(c),this.#t.textContent=c?"As in the evaluation":l===void 0?u:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${B(d,3)} in ${r.length} steps.${i?` The cell says ${B(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${B(e)}`,"aria-label":`Episode ${r+1}, capture rate ${B(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,p("span",{class:"count"},r+1))}};var is=0,ls=1,pl=2,ml=176;function us(t,e,r,n){let o=devicePixelRatio||1,s=Ke(t);t.width=t.height=ml*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let c=0;r&&c<i*i;c++){let[u,m]=[(c%i+.5)*l,(Math.floor(c/i)+.5)*l],h=f=>!!r[f*i*i+c];h(pl)&&(a.fillStyle=
s.obstacle,a.fillRect(u-l/2,m-l/2,l,l));let y=h(is)&&h(ls)?l*.18:0;h(is)&&cs(a,_e,u+y,m+y,l*.74,s.evader),h(ls)&&cs(a,jt,u-y,m-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function cs(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var ds="What it remembers: a number for each unit, from -1 to 1",tr=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:ds});#l=null;#p=null;#c=null;#m=null;#d=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#i}show(e,r,n,o){this.#l?.free(),this.#l=e.world(r.world),
this.#c!==r&&(this.#p=null,this.#i!==null&&this.choose(null)),[this.#c,this.#m,this.#d]=[r,n,o]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#m;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,o,s,a]=[this.#m,this.#l,this.#c,this.#d,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},q(a,r.config.n_pursuers)));
let l={pursuers:ee(o,"pursuer",s.pursuer),evaders:ee(o,"evader",s.evader)};r.seek(n,e,l);let d=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;d.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(d);let c=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);us(this.#r,r.config,c?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${q(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let u=d[a]??null;if(!c)return this.#u([],"It is gone.");let m=l[`${i}s`],
h=typeof m=="string"?null:n.answer(m,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),yl(h.memory));
let f=this.#p?.game(n)??null,g=typeof m=="string"?`The script "${m}" plays for it${u===null?"":`; it goes ${de[u]}`}.`:m.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",b=[["network",y],["perfect",f?.marginal(a)??null]],x=v=>p("p",{class:"small muted"},v);this.#u([...f?[x(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...hl(b,u)],u===null?"The episode is over.":g)}#u(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function hl(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=p("div",{class:"action muted"},p("span"),...r.map(([s])=>p("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},de[a]),...r.flatMap(([,i])=>fl(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function fl(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function yl(t){
let e=Array.from(t,r=>{let n=p("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return p("div",{class:"units",role:"img","aria-label":ds},
...e)}function Xe(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,ee(e,"pursuer",r),ee(e,"evader",n),BigInt(s??a),o)}function ps(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var ms="champion",hs=0,tn=64,rn=100;var gl=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function fs(t,e){return Object.keys(e).find(r=>gl(e[r],t))??null}var St="_",bl="n",np=2n**64n-1n;var nn={fov:11,maxSteps:500,rewards:"paper"},vl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function bs(t,e){let r=i=>i.map(l=>xl(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=wl(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:gs(
t.rules,e),others:t.others?gs(t.others,e):"",rewards:o===nn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===nn.fov?"":String(t.fov),
limit:t.maxSteps===nn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(St),pursuers:t.pursuers.map(ys).join(St),
evaders:t.evaders.map(ys).join(St),played:t.played.map(r).join(St),next:t.next.every(i=>i===hs)?"":r(t.next)};return vl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function ys({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function gs(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return fs(t,e.variants)??r.join(".")}function wl(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(St)}function xl(t,e){if(typeof t=="number")return String(t);if(t===ms)return bl;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Sl="/* the engine */";function vs(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>on(t(),e)},"What if?")}function on(t,e){let r=t!==null&&t.match.n_agents<=rn&&Math.max(t.match.config.rows,t.match.config.
cols)<=tn,n=r?bs(Ml(t.match,t.step),e):"",o=new TextDecoder().decode(Vr("playground")).replace(Sl,()=>Ft("script-engine")).replace("</noscript>",s=>r?s+ps(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Ml(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
d=o*r.n_evaders+i-r.n_pursuers,c=u=>i>=r.n_pursuers&&!!u[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:c(t.captured),
everCaptured:c(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var sn=.005,xs=.05,Al=["pursuer","evader"],El=4,Qe=new Map;function rr(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null,fov:null},r]),o=Qe.get(n)??
(It(e)?Promise.resolve(null):Tl(t,e,r));return Qe.delete(n),Qe.set(n,o),Qe.size>El&&Qe.delete([...Qe.keys()][0]),o}var Ss=({n_evaders:t})=>t===1?"capture-time":
"capture-rate",ws=()=>new Promise(t=>setTimeout(t));async function Tl(t,e,r){await ws();let n=t.solution(e,r);for(;n.goBack();)await ws();return n}function nr(t,e,r){
let{payoff:n}=t;return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((d,c)=>a[c]+=d),e.playTurn(o);let i=n==="ca\
pture-rate"?sn:xs;return Al.map((l,d)=>({step:s+1,team:l,lost:a[d],payoff:n})).filter(l=>l.lost>=i)})}var or=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.
max(1,...t.map(({lost:r})=>r)),text:Mt(e)})),Ms=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,Mt=t=>`The\
 ${t.team}s lose ${Ms(t)} against a perfect opponent`;function As(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step},\
 lost ${Ms(e)} against a perfect opponent.`}function Es({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.
min(t.max_steps-n,Pr)];return o>s-xs?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Ts(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,
action:o})).filter(({share:n})=>n>=sn).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-sn?de[o]:`${de[o]} ${n.toFixed(2)}`).join(", ")}function sr(t,e,r){if(r===0)return[{kind:"start",text:Cl(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>q(c,t.config.n_pursuers),a=ft(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(c=>c.doomed)),d=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of Wt(n,o))!a.includes(c)&&!l.has(c)&&d.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return d.push(...i.map(({kind:c,text:u,agents:m})=>({kind:c,text:u,agents:m}))),r===t.length&&d.unshift({kind:"\
end",text:kl(t),agents:[]}),d}function Cl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function kl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Rl=60,ar=class{element;player=new Ae(0,{speed:Ye,still:le()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#l=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#p=p("p",{class:"problem",role:"a\
lert"});#c=null;#m=null;#d=0;#i=!1;#h=0;#u=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=p("canvas",{"aria-label":"The match"});this.#e=new Me(o,{numbers:!1}),
this.#n=new er(r),this.inspector=new tr(s=>this.#x(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p(
"div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&vs(()=>this.shown,n)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p(
"div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),this.#p,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#l,ns(),this.actions,this.
inspector.element),Je(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#f()),r.on("rest",()=>this.player.pause()),this.#v(),this.#S(0,0)}get#o(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){
this.#c=e,this.#y()}playSoon(){this.#i=!0,this.#d||this.#g()}goTo(e){this.#h=e,!this.#d&&this.match&&this.#y()}#g(){!this.#i||!this.match||(this.#i=!1,this.player.
jump(0),le()||this.player.play())}#f(){this.#v(),clearTimeout(this.#d),this.#d=setTimeout(()=>this.#y(),Rl)}#y(){clearTimeout(this.#d),this.#d=0,this.player.pause(),
this.#v();let{selected:e}=this.#t,r=Q.map(s=>ke(this.#o,s,e[s])).find(Boolean)??"";if(this.#p.textContent=r,r||!this.#c)return;this.match=Xe(this.#c,this.#o,e);
let[n,o]=this.names(e);this.#m={pursuer:{name:n,policy:ee(this.#o,"pursuer",e.pursuer)},evader:{name:o,policy:ee(this.#o,"evader",e.evader)}},this.recording=Qt(
this.match),this.#n.show(this.#o,this.match),this.inspector.show(this.#c,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=wo(this.recording),
this.#u=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#w(),this.#b(this.#c,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.#g()}async#b(e,r){let n=await rr(e,r.config);if(this.match!==r||!n)return;let o=e.world(r.config);r.seek(o,0),this.#u=nr(n,o,_l(
r)),o.free(),this.player.ticks=or(this.#u),this.inspector.solution=n,this.#w()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#r[e];return[o.pursuer.script??
G("pursuer",r),o.evader.script??G("evader",n)]}#v(){let{episode:e,seed:r}=this.#t.selected,{payoff:n}=this.#o,[o,s]=this.names(this.#t.selected),a=r===null?e<n.
episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#a.replaceChildren(p("span",{class:"pursuer"},Pe(o))," agains\
t ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#w(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.
moments[r];this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#u.filter(o=>o.step===r).map(o=>p("li",{class:`loss-${o.
team}`},Mt(o))),...sr(e,this.recording,r).map(o=>p("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(e,r){this.#s.
replaceChildren(p("strong",{},e),` of ${this.#o.world.n_evaders} captured`,p("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},_l=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var Pl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},$l=5;function ve(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Pl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,d]=r(),c=o.shiftKey?$l:1,{pursuer:u,evader:m}=e.selected;e.
select({pursuer:Cs(u+c*a,l),evader:Cs(m+c*i,d)}),o.preventDefault(),o.stopPropagation()})}var Cs=(t,e)=>Math.min(e-1,Math.max(0,t));var Ol=24,ir=7,Rs=t=>t<Ol&&matchMedia("(pointer: coarse)").matches;function _s(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[ks(e,o),ks(r,s)],[l,d]=[Math.min(ir,o),Math.
min(ir,s)],c=[];for(let y=a+l-1;y>=a;y--){c.push(p("span",{class:"pursuer"},y));for(let f=i;f<i+d;f++)c.push(Ll(t,y,f,n))}let u=Array.from({length:d},(y,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...c,m,...u);return h.style.gridTemplateColumns=`2.4rem repeat(${d}, minmax(0, 1fr))`,h.addEventListener("click",y=>y.stopPropagation()),
h}function Ll(t,e,r,n){let o=je(t,e,r)?.rate,s=p("button",{type:"button","aria-label":`${B(o)}: ${G("pursuer",e)} against ${G("evader",r)}`,onclick:()=>n({pursuer:e,
evader:r})},B(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Zt(o),Yt(o)]),s}var ks=(t,e)=>Math.max(0,Math.min(e-ir,t-Math.floor(ir/2)));var ae={left:52,bottom:46,top:76,right:84},pe=10,Il=160,At=ae.right-pe-14,$e=ae.top-pe-14,lr=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=M("svg",
{"aria-hidden":"true"});#a=M("g");#s;#l=p("h2");#p=p("strong",{class:"rate numbers"});#c=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#d=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#l,this.#m),p("div",{class:"of-cell"},this.#p,this.#c));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,Xt("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).
observe(this.#s),this.#s.addEventListener("pointermove",o=>this.#v(o)),this.#s.addEventListener("pointerleave",()=>r.point({})),this.#s.addEventListener("click",
o=>this.#w(o)),this.#s.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ve(this.#s,
r,()=>this.#i.payoff.shape),this.#s.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#g()),r.on("hove\
r",()=>this.#g())}get#i(){return this.#r[this.#e.selected.run]}#h(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.
max(Il,Math.min(n-ae.left-ae.right,o-ae.top-ae.bottom))/Math.max(e,r),i=Math.max(ae.left,(n-r*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(o-ae.top-ae.bottom-e*a)/
2),d={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};this.#d=d,Jt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[c,u,m]of[["left",i,
n],["top",l,o],["width",r*a,n],["height",e*a,o]])this.#t.style.setProperty(c,`${100*u/m}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute(
"viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(Nl(d),...Bl(d),...this.#o(d),this.#a),this.#g()}#u(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ps(e,r.pursuers.mean[s]??0,s),[d,c]=$s(e,r.evaders.mean[a]??0,a);return[M("cir\
cle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:d,cy:c,r:5})]}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
left:n,top:o,cell:s,rows:a,columns:i}=e,[l,d]=[n+i*s+pe,o-pe],c={class:"side"};return[M("rect",{...c,x:l,y:o,width:At,height:a*s}),M("rect",{...c,x:n,y:d-$e,width:i*
s,height:$e}),...Os(r.pursuers,(u,m)=>Ps(e,u,m),"of-pursuers"),...Os(r.evaders,(u,m)=>$s(e,u,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"\
start"},"0"),M("text",{class:"tick",x:l+At,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),M("text",{class:"ti\
ck",x:n-6,y:d-$e+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+At,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-ev\
aders",x:n+i*s+pe,y:d-$e+10,"text-anchor":"start"},"escapes")]}#g(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,
d=y=>s+(i-1-y)*a,c=[],u=(y,f)=>M("rect",{class:f,x:o,y:d(y),width:l*a+pe+At,height:a}),m=(y,f)=>M("rect",{class:f,x:o+y*a,y:s-pe-$e,width:a,height:pe+$e+i*a});c.
push(u(r.pursuer,"strip pursuer"),m(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&c.push(u(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&c.push(
m(n.evader,"strip hover")),c.push(...this.#u(e));let h={x:o+r.evader*a,y:d(r.pursuer),width:a,height:a};c.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...c),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=je(this.#i,n,o);this.#l.
replaceChildren(p("span",{class:"pursuer"},Pe(G("pursuer",n)))," against ",p("span",{class:"evader"},G("evader",o))),this.#p.textContent=s?B(s.rate,3):"-",this.#c.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"no episodes were played",this.#m.textContent=this.#y(n,o)}#y(e,r){let n=this.#i.findings?.generalization;
if(!n)return"";let o=(s,a)=>ss(s.mean[a]??null,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#b(e){
let r=this.#d;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/
r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,
evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#b(e);if(r){if(r.inside&&Rs(this.#d.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?
{}:{evader:r.h}}),r.inside&&this.#x()}}#S(e,r){let n=_s(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(o),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function Nl({left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"axes"}),a=e+n*r,i=l=>xt(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(M("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Bl({
left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;for(let c of["H","V"]){let u=`M${t} ${i}`;for(let m=1;m<=
a;m++){let[h,y]=[`H${t+m*r}`,`V${i-m*r}`];u+=c==="H"?h+y:y+h}s.append(M("path",{d:u,class:"under"}),M("path",{d:u}))}let[l,d]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[
s,M("text",{class:"on-cells",transform:`translate(${l} ${d}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var Ps=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[
t+o*r+pe+s*At,e+(n-a-.5)*r],$s=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-pe-n*$e];function Os(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(M("path",{class:`line ${r}`,
d:`M${n(t.mean).join("L")}`})),o}function te(t,e,...r){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...r)}function Ls(t,e,r){let{findings:n}=t;if(!n?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Fl(o,t,i,e,
l)},a=n.checkerboards.map(i=>Ul(t,i,s));return{element:te("Checkerboards","Two generations of each team: each generation of the pursuers is better against anoth\
er one of the evaders. Click one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${n.margin}\
 in this way.`),a.length?p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether th\
ere are more than noise makes."):null,o)}}var Is=({pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function Ul(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,
i=Is(e).map(([l,d])=>{let c=t.payoff.capture_rate[l][d],u=p("span",{class:"cell"},B(c));return u.style.backgroundColor=Zt(c),u.style.color=Yt(c),u});return p("b\
utton",{type:"button",class:"miniature numbers",onclick:()=>r(e)},p("span",{},p("span",{class:"heard"},`Four matches of generations ${n} and ${o} of the pursuer\
s, ${s} and ${a} of the evaders:`)),p("span",{class:"evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},n),i[0],i[1],p("span",{class:"pursuer"},
o),i[2],i[3])}function Fl(t,e,r,n,o){let s=Is(r).filter(([m,h])=>!ke(e,"pursuer",m)&&!ke(e,"evader",h)),a=s.map(([m,h])=>Xe(o,e,{run:n.selected.run,pursuer:m,evader:h,
episode:0,seed:null})),i=new Ae(Math.max(0,...a.map(m=>m.length)),{speed:Ye,still:le()}),l=a.map((m,h)=>{let[y,f]=s[h],g=p("canvas",{"aria-label":`${G("pursuer",
y)} against ${G("evader",f)}`}),b=p("span",{class:"numbers"}),x=()=>{t.close(),n.select({pursuer:y,evader:f})},v=p("figure",{},g,p("figcaption",{class:"small"},
b,p("span",{class:"muted"},`cell ${B(e.payoff.capture_rate[y][f])}`),p("button",{type:"button",title:"Show this match alone",onclick:x},"open")));return v.style.
gridArea=`${r.pursuers.indexOf(y)+2} / ${r.evaders.indexOf(f)+2}`,{element:v,match:m,recording:Qt(m),board:new Me(g,{numbers:!1}),tally:b}}),d=()=>l.forEach(m=>m.
board.show(m.recording,i.time)),c=()=>l.forEach(({recording:m,match:h,tally:y})=>{let f=m.moments[Math.min(i.step,h.length)];y.textContent=`${Array.from(f.everCaptured).
filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener("frame",d),i.addEventListener("step",c),t.replaceChildren(p("header",{},p("h2",{},
"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},"Close")),p("div",{class:"grid-of-four"},p("span"),...r.evaders.map(m=>p("h3",
{class:"evader"},G("evader",m))),...r.pursuers.map((m,h)=>{let y=p("h3",{class:"pursuer"},G("pursuer",m));return y.style.gridArea=`${h+2} / 1`,y}),...l.map(m=>m.
element)),Je(i));let u=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&Ee(i,m)&&m.preventDefault()};
t.addEventListener("keydown",u),t.addEventListener("close",()=>{t.removeEventListener("keydown",u),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},
{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),d(),c(),le()||i.play()}var cr={pursuer:"evader",evader:"pursuer"};function Ns(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${B(s)}, stripes ${B(a)}${i===null?"":` every ${i} generations`}`;return zl(t,o,l,e)});return{element:te("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...n.map(o=>o.element)),Xt("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function zl(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(v,w)=>e==="pursuer"?t.payoff.
capture_rate[v][w]:1-t.payoff.capture_rate[w][v],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),c=d?.createImageData(a,s);for(let v=0;c&&
v<s;v++)for(let w=0;w<=Math.min(v,a-1);w++)c.data.set([...Ze(i(v,w)),255],4*((s-1-v)*a+w));c&&d?.putImageData(c,0,0);let u=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,u),y=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);ve(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${a} / ${s}`;let f=v=>{let w=y.
getBoundingClientRect(),A=Math.floor((v.clientX-w.left)/w.width*a),C=s-1-Math.floor((v.clientY-w.top)/w.height*s);return A>=0&&C<s&&A<=C?[C,A]:null},g=v=>({[e]:v[0],
[cr[e]]:v[1]});y.addEventListener("pointermove",v=>n.point(f(v)?g(f(v)):{})),y.addEventListener("pointerleave",()=>n.point({})),y.addEventListener("click",v=>f(
v)&&n.select(g(f(v))));let b=()=>{let v=n.hover[e]??n.selected[e],w=n.hover[cr[e]]??n.selected[cr[e]];for(let A of[u,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-v)),A.style.display=w<=v?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),y,p("p",{class:"smal\
l muted"},`horizontal: ${cr[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},r)),update:b}}var ur={left:46,right:12,top:10,bottom:42},Bs={x:56,y:34};function Et(t,e,r,n){let[o,s]=[ur.left,ur.top],a=Math.max(o+40,t-ur.right),i=Math.max(s+40,e-ur.bottom),
l=(f,g,b)=>x=>g+(x-f.low)/(f.high-f.low||1)*(b-g),[d,c]=[l(r,o,a),l(n,i,s)],u=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of xt(n.low,n.high,(i-s)/Bs.y,n.whole))h.append(M("line",{x1:o,x2:a,y1:c(f),y2:c(f),class:"grid"}),M("text",{x:o-8,y:c(f),"text-anchor":"\
end","dominant-baseline":"middle"},Us(f)));for(let f of xt(r.low,r.high,(a-o)/Bs.x,r.whole))h.append(M("text",{x:d(f),y:i+16,"text-anchor":"middle"},Us(r.mirrored?
Math.abs(f):f)));return h.append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),M("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(h,u),{root:m,marks:u,left:o,right:a,top:s,bottom:i,x:d,
y:c,at:f=>{let g=f-m.getBoundingClientRect().left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Us=t=>String(Number(t.toPrecision(6))).replace("-","−");function an(t,e,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(M("path",{d:o,class:`line ${n}`}),
t.marks)}function Fs(t,{low:e,high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(M("path",{d:`\
M${[...o(r),...o(e).reverse()].join("L")}Z`,class:`band ${n}`}),t.marks)}function ln(t,e,r,n=null){let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.
bottom,class:`mark ${r}`})),n!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function Tt(...t){return p("p",{class:"legend small"},...t.
map(([e,r])=>p("span",{class:`key ${r}`},e)))}function Ct(t,e,r,n){let o=p("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),
s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:d}=o;l<50||d<50||(s=e(l,d),o.replaceChildren(s.root),
a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var cn=["of-pursuers","of-evaders","of-both"],Dl=2500,zs="Arrow keys choose generations.",Wl={low:0,high:1,label:"capture rate"};function Ds(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=Hl(n,r.window),d=i.at(-1)??1,c=i.length>Dl?"dense":"",u=(y,f)=>{let g=o.flatMap((b,x)=>b===
y&&(s[x]===f||s[x]===2)?[x]:[]);return g.length?[i[g[0]],i[g.at(-1)]]:null},m=Ct(`Capture rate in ${d} epochs of training. ${zs}`,(y,f)=>{let g=Et(y,f,{low:0,high:d,
label:"epoch",whole:!0},Wl);for(let[b,x]of[["raw",n],[c,l]])for(let[v,w]of cn.entries()){let A=x.map((C,E)=>s[E]===v||s[E+1]===v?C:null);A.some(C=>C!==null)&&an(
g,i,A,`${w} ${b}`)}return g},y=>Q.forEach((f,g)=>{let b=u(e.hover[f]??e.selected[f],g);b&&ln(y,(b[0]+b[1])/2,cn[g])}),y=>{let f=Math.min(i.length-1,Math.max(0,Math.
round(y/a)-1)),g=o[f];s[f]!==1&&e.select({pursuer:Math.min(g,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(g,t.payoff.shape[1]-1)})});ve(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn","both teams learn"][y],cn[y]]);return{element:te("Training",`${as(r.
matches)} training matches. Lines: the generations that are selected.`,Tt(...h),m.element),update:m.update}}function Ws(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=Q.flatMap(u=>[n[u].mean,n[u].low??[],n[u].high??[]]).flat().map(u=>u??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),d=Math.max(...t.payoff.shape)-1,c=Ct(`Elo ratings by generation. ${zs}`,(u,m)=>{let h=Et(u,m,{low:0,high:d,
label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of Q)Fs(h,n[y],`of-${y}s`),an(h,o[y].map((f,g)=>g),o[y],`of-${y}s`);return h},u=>{
for(let m of Q){let h=e.hover[m]??e.selected[m];ln(u,h,`of-${m}s`,o[m][h]??null)}},(u,m,h)=>{let y=Math.round(u),f=h.clientY-m.root.getBoundingClientRect().top,
g=x=>Math.abs(m.y(o[x][y]??1/0)-f),b=g("pursuer")<=g("evader")?"pursuer":"evader";y>=0&&y<o[b].length&&e.select({[b]:y})});return ve(c.element,e,()=>t.payoff.shape),
{element:te("Ratings",`One number for each generation, which cycles do not fit, with 95 % intervals over episodes. The game itself: ${B(r.offset,0)} points for \
the pursuers.`,Tt(["pursuers","of-pursuers"],["evaders","of-evaders"]),c.element),update:c.update}}function Hl(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);
return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var jl={present:"●",absent:"○","cannot tell":"?"};function Hs(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],d)=>{
let c=Gl(e.reasons[d]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},jl[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),c?p("p",{class:"small"},`${c}.`):null,p("p",{class:"small muted numbers"},i)))}),o=te("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("p",{},e.headline),
...e.numbers.map(s=>p("p",{class:"numbers"},`${Pe(s)}.`)),p("ul",{class:"findings"},...n),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add(
"diagnosis"),{element:o}}function Gl(t){let[,e=""]=t.split(/, because (.*)/s);return Pe(e.replace(/\.$/,""))}function js({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>p("tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"n\
umbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...n),s=te("Settings",`${e}, \
seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?p("div",{class:"wide-table"},o):null);return s.classList.add("settings"),{element:s}}var Vl={pursuer:-1,evader:1};function Gs(t,e){let r=t.findings?.spinning_top;if(!r)return null;let n=1.05*Math.max(.05,...r.pursuers.high,...r.evaders.high),o=Q.
flatMap(l=>{let{generations:d,strength:c,intransitivity:u,low:m,high:h}=r[`${l}s`],y=Vl[l];return d.map((f,g)=>({team:l,generation:f,y:c[g],x:y*u[g],low:y*m[g],
high:y*h[g]}))}),s=(l,{team:d,x:c,y:u},m,h)=>M("circle",{cx:l.x(c),cy:l.y(u),r:m,class:`${h} of-${d}s`}),a=Ct("Intransitivity of each generation at its strength\
. Arrow keys choose generations.",(l,d)=>{let c=Et(l,d,{low:-n,high:n,label:"intransitivity",mirrored:!0},{low:0,high:1,label:"strength"});c.root.insertBefore(M(
"line",{x1:c.x(0),x2:c.x(0),y1:c.top,y2:c.bottom,class:"axis"}),c.marks);for(let u of o){let m={x1:c.x(u.low),x2:c.x(u.high),y1:c.y(u.y),y2:c.y(u.y)};c.root.insertBefore(
M("line",{...m,class:`line raw of-${u.team}s`}),c.marks),c.root.insertBefore(s(c,u,4.5,"dot"),c.marks)}return c},l=>{let d=o.filter(({team:c,generation:u})=>u===
(e.hover[c]??e.selected[c]));l.marks.append(...d.map(c=>s(l,c,7,"dot")))},(l,d,c)=>{let u=d.root.getBoundingClientRect(),m=({x:f,y:g})=>Math.hypot(d.x(f)-(c.clientX-
u.left),d.y(g)-(c.clientY-u.top)),{team:h,generation:y}=o.reduce((f,g)=>m(g)<m(f)?g:f);e.select({[h]:y})});ve(a.element,e,()=>t.payoff.shape);let i=te("Strength\
 and cycles","A dot is a generation: the higher, the stronger; the farther out, the more its results deviate from every order of strength. Lines: 95 % intervals\
, without episode noise.",Tt(["pursuers, left","of-pursuers"],["evaders, right","of-evaders"]),a.element,p("p",{class:"small numbers"},(t.findings?.game??[]).join(
" · ")));return i.classList.add("spinning-top"),{element:i,update:a.update}}function Vs(t,e,r){let n=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??ql(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(d=>d.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function ql(t,e,r){return[Hs(t),Ds(t,e),Ls(t,e,r),Ws(
t,e),Ns(t,e),Gs(t,e),js(t)].filter(o=>o!==null)}var hr=Ba(sa(),1);var hn=125,fc=80,yc=10,aa=480,gc=[1,.8,.6,.4,.2],bc=5;async function ia(t,e){let r=Math.min(1,gt(t.rows,t.cols)),[n,o]=[Math.round(aa*r),Math.round(aa*r/gt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[n,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=Ke(document.documentElement),l={ctx:a,colors:i,
grid:qt(t.rows,t.cols,!1,n,o,1)},[d,c]=[vc(i,a),(0,hr.GIFEncoder)()];for(let u=0;u<hn;u++){let m=Math.min(1,u/(hn-yc))*(t.moments.length-1);Vt(l,t,m,{...Gt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,n,o),a.globalCompositeOperation="source-over",c.writeFrame((0,hr.applyPalette)(
a.getImageData(0,0,n,o).data,d),n,o,{palette:d,delay:fc}),u%bc===0&&(e(Math.round(100*u/hn)),await new Promise(h=>setTimeout(h)))}return c.finish(),new Blob([c.
bytes()],{type:"image/gif"})}function vc(t,e){let r=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),n=r(t.
paper);return Object.values(t).map(r).flatMap(o=>gc.map(s=>o.map((a,i)=>Math.round(n[i]+s*(a-n[i])))))}function la(t,e){let r=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),n=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"bu\
tton",class:"save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:l,evader:d}=e.selected;s.disabled=!0;let c=await ia(t.recording,m=>n.textContent=`Dr\
awing: ${m} %`),u=URL.createObjectURL(c);p("a",{href:u,download:`pursuers-${l}-evaders-${d}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(u),6e4),n.textContent=
`Saved, ${(c.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{
id:"share-title"},"Share this match"),s,ut()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),ut()&&p("div",{class:"link"},r,
p("button",{type:"button",onclick:()=>Yn(r,n)},"Copy")),n,p("button",{type:"button",onclick:()=>a.close()},"Close"));return a.addEventListener("click",l=>l.target===
a&&a.close()),{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),r.value=location.href,n.textContent="",a.showModal()}},
"Share"),dialog:a}}var ca={pursuer:null,evader:null},fr=class extends EventTarget{#e;#r=ca;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...ca,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var yr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[en(this.#e)],
this.recording=Qr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,
[Math.max(l,s),d],a)),typeof n=="number"?a[r]=n:l<=r&&r<d&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(en(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var me=(t,e)=>Q[+(e>=t.n_pursuers)];function fn(t,e){let r=new yr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function et(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var gr=(t,e)=>t.over||et(t,e).out;function ua(t,e,r){let n=fn(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!gr(n,e.seat);)n.step(e.policies,e.seat,r);return et(n,e.seat)}function da(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function pa(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function ma(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function yn(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[wc(t,a,i,da(o))],again:()=>yn(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&pa(s,a)})}
function wc(t,e,r,n){let o=me(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=d=>{let[c,u]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},d),p("td",{class:"track","aria-hidden":"true"},c),u)),({lasted:m,captured:h})=>{c.style.width=`${100*(o?m:h)/s}%`,
u.textContent=String(o?m:h)}};i("You")(et(e,r.seat));for(let{name:d,policy:c}of n){let u=i(d);setTimeout(()=>u(ua(t,r,c())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ha=["·","↑","→","↓","←","↗","↘","↙","↖"];var xc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},gn=[8,1,5,4,0,2,7,3,6],Sc=[7,8,9,4,5,6,1,2,3],Mc=24,Ac=Math.tan(
Math.PI/8);function ya(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Sc.findIndex(o=>t.code===`Numpad${o}`),n=gn[r]??xc[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function ga(t){let e=gn.map(r=>p("button",{type:"button","aria-label":de[r],onclick:()=>t(r)},ha[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",gn[o]>4&&!r))}}function fa(t,e,r){let n=Ac*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return bo([0,0],r?[o(t),o(e)]:[t,e],r)}function ba(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[d,c]=[s-i[0],a-i[1]],u=t.cellAt(s,a);Math.hypot(d,c)>=Mc?r(fa(c,d,l.diagonal)):u&&r(fa(u[0]-l.cell[0],
u[1]-l.cell[1],l.diagonal))})}function va(t,e){let r=n=>{let o=e[n]-t[n],s=Ge.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${de[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Sa="NUMPY\0",wa=Sa.length+2,xa=64;function Ma(t){return ho(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Ec(r)])))}function Ec({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((wa+s.length+1)/xa)*xa-wa,i=Sa+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,d=new Uint8Array(i.length+l.byteLength);return d.set(Nt(i,!0)),d.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),d}var Tc="matrixworld episode 3";function Aa(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],d={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},m=v=>{
for(let w of Object.keys(v))(u[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(n);h.reset(e.start);let y=[];m(d);for(let v of o)h.step(v),m({...d,...c}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[w,...A]]of Object.entries({...d,...c})){let C=s+
+(v in d);g[v]={dtype:w,shape:[C,...A],data:f[w].from((u[v]??[]).flat())}}let b=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),x=v=>({dtype:"<U",shape:[],data:v});
return Ma({format:x(Tc),n_pursuers:b(n.n_pursuers),config:x(JSON.stringify(n)),seat:b(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Cc=[0,1,2,4,8],br=class{element;player=new Ae(0,{speed:4,still:le()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=ga(e=>this.act(e));#l=p("select",{},...Cc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#p=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#m=p("label",{class:"play-choice"},this.#c,"Best move");#d=p("p",{class:"small muted play-keys",id:"play-keys"});#i=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Je(this.player);#u=null;#o=null;#g=[];#f=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#r=new Me(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#A()),this.#p.addEventListener(
"change",()=>this.#x()),this.#c.addEventListener("change",()=>this.#E()),ba(this.#r,()=>{let r=this.#f!==null&&this.#o&&L(this.#o.recording.moments.at(-1),this.#f);
return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#E()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),p("div",{class:"pl\
ay-stage"},this.#t),p("div",{class:"play-side"},this.#i,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),p("label",{class:"\
play-choice"},this.#p,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#h)}get played(){return this.#u&&{...this.#u.
played,moves:this.#g}}get live(){return this.#o}play(e){this.#S(fn(this.#e,e.played),e.played.seat,e.title),[this.#u,this.#g,this.#v]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),gr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#u=null,this.#S(e,r,n),this.#_()}stop(){
this.#A(),this.player.pause(),this.#u=null}act(e){let[r,n]=[this.#u,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#l.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Ee(this.player,e);let s=ya(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#A(),this.player.pause(),[this.#o,
this.#f]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#x(){this.#r.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#P()}}#M(e){this.#y=null,this.#b=this.player.ticks=[],this.#m.hidden=this.#c.disabled=!!It(e.config),
rr(this.#e,e.config,Ss(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#T(),this.#E())})}#T(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=nr(r,n,e.actions),n.free(),this.player.ticks=or(this.#b)}get#C(){return this.#c.checked&&this.#u&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#P(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#A(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#u.played,this.#o];n.step(e,r,this.#v),this.#g.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(n.length-this.player.step),gr(n,r)&&this.#R()}#R(){this.#A();let[e,r,n]=[this.#u,this.#o,this.played],o=ut()?e.link(
n):null;this.#i.replaceChildren(p("h3",{id:"play-headline"},_c(r,n.seat)),...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},"Watch it"),p("button",{type:"button",onclick:()=>this.#$(r,n.seat)},"Save"),
o&&p("button",{type:"button",onclick:({currentTarget:a})=>$c(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#b.filter(({team:a})=>a===me(
r.config,n.seat));s.length&&this.#i.children[0].after(p("p",{class:"small muted"},As(s))),this.#i.focus({preventScroll:!0}),this.#i.scrollIntoView({block:"neare\
st"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),le()||this.player.play()}#$(e,r){let n=new Blob([Aa(this.#e,
e,r)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(n),download:`${q(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#E(){let[e,r,
{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let o=sr(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(r)),s=this.#u&&n===0,a=s?[kc(
e.config,r),this.#u.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Rc(e,n,r)),a.push(...this.#b.filter(l=>l.step===
n).map(Mt));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${Ts(i,r)||"decided in its turn"}; ${Es(this.#y,i,n)}`),this.#x(),this.#a.textContent=
a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function kc(t,e){let r=t.rules.capture==="SURROUND";return me(t,e)==="evader"?`Run away: you win if ${r?"the pursu\
ers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your team":"move onto their cells"}`}
function Rc({config:t,recording:e},r,n){let o=e.moments[r],a=me(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=L(o,n),l=u=>{let[m,h]=L(o,u);return Math.
max(Math.abs(m-i[0]),Math.abs(h-i[1]))},d=Array.from({length:o.alive.length},(u,m)=>m).filter(u=>me(t,u)===a&&o.alive[u]&&!o.captured[u-t.n_pursuers]&&2*l(u)<t.
fov);if(!d.length)return`No ${a} in view`;let c=d.reduce((u,m)=>l(m)<l(u)?m:u);return`Nearest ${a}: ${va(i,L(o,c))}`}function _c(t,e){let[{lasted:r,out:n,captured:o},
{config:s}]=[et(t,e),t];return me(s,e)==="pursuer"?`Your team captured ${o} of ${Pc(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escape\
d: ${r} steps.`}var Pc=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function $c(t,e){let r=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to thi\
s match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var vr=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",s=>this.view?.key(s)&&s.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,r=""){this.#a=e;let n=dt(r,this.#e,this.#r.selected),o=ma(new URLSearchParams(r.replace(/^#/,"")),
this.#e[n.run].world);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=n<r.
length?n:0,a=(u,m)=>!!r.alive[m*r.n_agents+u],i=Array.from({length:r.n_agents},(u,m)=>(m+r.config.n_pursuers)%r.n_agents),l=o??i.find(u=>a(u,s)),d=a(l,s)?s:0,c=Array.
from({length:d},(u,m)=>r.actions[m*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:d,moves:c})}play(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||Q.some(
g=>ke(o,g,e[g])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:d}=e,c=me(o.world,r.seat),u=o.teams[c].kept.map(g=>({name:o.teams[c].script??`generation ${g}`,
text:"",policy:()=>ee(o,c,g)}));this.view||(this.view=new br(n),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Clo\
se"),this.view.element)),this.dialog.open||this.dialog.showModal();let m=`You are ${q(r.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,h={pursuer:ee(
o,"pursuer",a),evader:ee(o,"evader",i)},y={config:o.world,seed:BigInt(d??o.seeds[a][i]),episode:l,policies:h,...r},f={run:s,pursuers:a,evaders:i,episode:l,...d===
null?{}:{seed:d}};yn(n,this.view,m,y,u,this.#n?f:null)}};var he=yo(),{runs:Y}=he,[Oc,Lc]=Y[0].payoff.shape,Ic=dt(location.hash,Y,{run:0,pursuer:Oc-1,evader:Lc-1,episode:0,seed:null}),{step:Ta,...Nc}=Ic,V=new fr(Nc),D=new ar(
Y,V,he.playground),Ca=new lr(Y,V),rt=new vr(Y,V,D),bn=es(),Bc=location.hash,Ea=Jo(Y,V,D),{button:Uc,dialog:Fc}=la(D,V);D.actions.append(Uc);var tt=null,vn=p("as\
ide",{class:"note small muted"},he.note),ka=p("span",{class:"told","aria-live":"polite"}),Ra=()=>{ka.textContent=Y[V.selected.run].findings?.sentence??""};V.on(
"run",Ra);Ra();var zc="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";document.getElementById(
"page").replaceWith(Jn(he.heading,p("span",{},ka,p("span",{class:"small muted"},zc)),Ea.button,p("button",{type:"button",class:"keys-button",title:"Keys (?)","a\
ria-label":"Keys (?)",onclick:()=>bn.showModal()},"?")),...he.note?[vn]:[],Qo(Y,V),p("main",{class:"stages"},Ca.element,D.element),Vs(Y,V,()=>tt),p("footer",{class:"\
muted small"},`${he.title} · matrixworld ${he.version}`),rt.dialog,bn,Fc,Ea.bar);Object.assign(window,{matrixworldExplorer:{get match(){return D.match},get step(){
return D.player.step},get pace(){return D.player.pace},get playing(){return rt.view},play:t=>tt&&Xe(tt,Y[V.selected.run],{...V.selected,episode:t}),get shape(){
return Y[V.selected.run].payoff.shape}}});Ca.element.addEventListener("play",()=>{D.playSoon(),D.reveal()});D.goTo(Ta);Ta||D.playSoon();Xn(Y,V,D);ts(Y,V,D,bn,()=>rt.
open(),()=>on(D.shown,he.playground));window.addEventListener("hashchange",({newURL:t})=>tt&&rt.start(tt,new URL(t).hash));if(he.live!==null){let[t,e]=[p("progr\
ess",{"aria-label":"Progress of the runs"}),p("p",{class:"numbers"})];vn.prepend(p("div",{class:"progress"},t,e)),rs(he.live,Y,V,()=>D.player.playing||rt.dialog.
open,r=>{r?[t.value,e.textContent]=[r.share,r.text]:vn.textContent="The command has ended. This page shows what it had played; explorer.html is beside the runs \
if they have finished."})}requestAnimationFrame(()=>setTimeout(()=>{qn().then(t=>{tt=t,D.start(t),rt.start(t,Bc),document.body.dataset.ready="true"},t=>{D.element.
prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
