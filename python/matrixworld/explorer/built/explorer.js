/* built from web/ by "npm run build"; sources c99b4cbc7e8f386e30086535a47dfe8b0750db1db9febff8e06f1c5f2b5c9625 */
"use strict";(()=>{var Oa=Object.create;var xn=Object.defineProperty;var La=Object.getOwnPropertyDescriptor;var Ia=Object.getOwnPropertyNames;var Na=Object.getPrototypeOf,Ba=Object.prototype.hasOwnProperty;var Fa=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(r){throw e=0,r}};var Ua=(t,e,r,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of Ia(e))!Ba.call(t,o)&&o!==r&&xn(t,o,{get:()=>e[o],enumerable:!(n=La(e,o))||n.enumerable});
return t};var za=(t,e,r)=>(r=t!=null?Oa(Na(t)):{},Ua(e||!t||!t.__esModule?xn(r,"default",{value:t,enumerable:!0}):r,t));var ia=Fa(hn=>{var Xs=Object.defineProperty,Ql=t=>Xs(t,"__esModule",{value:!0}),ec=(t,e)=>{for(var r in e)Xs(t,r,{get:e[r],enumerable:!0})};Ql(hn);ec(hn,{GIFEncoder:()=>sa,
applyPalette:()=>cc,default:()=>vc,nearestColor:()=>mc,nearestColorIndex:()=>na,nearestColorIndexWithDistance:()=>oa,prequantize:()=>lc,quantize:()=>ac,snapColorsToPalette:()=>pc});
var tc={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Qs(t=256){let e=0,r=new Uint8Array(t);return{get buffer(){return r.buffer},reset(){e=0},bytesView(){return r.subarray(0,e)},bytes(){return r.slice(0,e)},
writeByte(o){n(e+1),r[e]=o,e++},writeBytes(o,s=0,a=o.length){n(e+a);for(let i=0;i<a;i++)r[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){n(e+a),r.set(o.subarray(
s,s+a),e),e+=a}};function n(o){var s=r.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=r;r=new Uint8Array(
o),e>0&&r.set(i.subarray(0,e),0)}}var dn=12,Ys=5003,rc=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function nc(t,e,r,n,o=Qs(512),s=new Uint8Array(
256),a=new Int32Array(Ys),i=new Int32Array(Ys)){let l=a.length,d=Math.max(2,n);s.fill(0),i.fill(0),a.fill(-1);let c=0,u=0,m=d+1,h=m,y=!1,f=h,g=(1<<f)-1,b=1<<m-1,
S=b+1,w=b+2,x=0,A=r[0],k=0;for(let v=l;v<65536;v*=2)++k;k=8-k,o.writeByte(d),T(b);let E=r.length;for(let v=1;v<E;v++)e:{let C=r[v],R=(C<<dn)+A,_=C<<k^A;if(a[_]===
R){A=i[_];break e}let re=_===0?1:l-_;for(;a[_]>=0;)if(_-=re,_<0&&(_+=l),a[_]===R){A=i[_];break e}T(A),A=C,w<1<<dn?(i[_]=w++,a[_]=R):(a.fill(-1),w=b+2,y=!0,T(b))}
return T(A),T(S),o.writeByte(0),o.bytesView();function T(v){for(c&=rc[u],u>0?c|=v<<u:c=v,u+=f;u>=8;)s[x++]=c&255,x>=254&&(o.writeByte(x),o.writeBytesView(s,0,x),
x=0),c>>=8,u-=8;if((w>g||y)&&(y?(f=h,g=(1<<f)-1,y=!1):(++f,g=f===dn?1<<f:(1<<f)-1)),v==S){for(;u>0;)s[x++]=c&255,x>=254&&(o.writeByte(x),o.writeBytesView(s,0,x),
x=0),c>>=8,u-=8;x>0&&(o.writeByte(x),o.writeBytesView(s,0,x),x=0)}}}var oc=nc;function ea(t,e,r){return t<<8&63488|e<<2&992|r>>3}function ta(t,e,r,n){return t>>
4|e&240|(r&240)<<4|(n&240)<<8}function ra(t,e,r){return t>>4<<8|e&240|r>>4}function hr(t,e,r){return t<e?e:t>r?r:t}function _t(t){return t*t}function Zs(t,e,r){
var n=0,o=1e100;let s=t[e],a=s.cnt,i=s.ac,l=s.rc,d=s.gc,c=s.bc;for(var u=s.fw;u!=0;u=t[u].fw){let h=t[u],y=h.cnt,f=a*y/(a+y);if(!(f>=o)){var m=0;r&&(m+=f*_t(h.ac-
i),m>=o)||(m+=f*_t(h.rc-l),!(m>=o)&&(m+=f*_t(h.gc-d),!(m>=o)&&(m+=f*_t(h.bc-c),!(m>=o)&&(o=m,n=u))))}}s.err=o,s.nn=n}function pn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,
nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function sc(t,e){let r=e==="rgb444"?4096:65536,n=new Array(r),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>
24&255,l=a>>16&255,d=a>>8&255,c=a&255,u=ta(c,d,l,i),m=u in n?n[u]:n[u]=pn();m.rc+=c,m.gc+=d,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],
i=a>>16&255,l=a>>8&255,d=a&255,c=ra(d,l,i),u=c in n?n[c]:n[c]=pn();u.rc+=d,u.gc+=l,u.bc+=i,u.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,d=a&
255,c=ea(d,l,i),u=c in n?n[c]:n[c]=pn();u.rc+=d,u.gc+=l,u.bc+=i,u.cnt++}return n}function ac(t,e,r={}){let{format:n="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,
clearAlphaThreshold:a=0,oneBitAlpha:i=!1}=r;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof
Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),d=r.useSqrt!==!1,c=n==="rgba4444",u=sc(l,n),m=u.length,
h=m-1,y=new Uint32Array(m+1);for(var f=0,b=0;b<m;++b){let O=u[b];if(O!=null){var g=1/O.cnt;c&&(O.ac*=g),O.rc*=g,O.gc*=g,O.bc*=g,u[f++]=O}}_t(e)/f<.022&&(d=!1);for(var b=0;b<
f-1;++b)u[b].fw=b+1,u[b+1].bk=b,d&&(u[b].cnt=Math.sqrt(u[b].cnt));d&&(u[b].cnt=Math.sqrt(u[b].cnt));var S,w,x;for(b=0;b<f;++b){Zs(u,b,!1);var A=u[b].err;for(w=++y[0];w>
1&&(x=w>>1,!(u[S=y[x]].err<=A));w=x)y[w]=S;y[w]=b}var k=f-e;for(b=0;b<k;){for(var E;;){var T=y[1];if(E=u[T],E.tm>=E.mtm&&u[E.nn].mtm<=E.tm)break;E.mtm==h?T=y[1]=
y[y[0]--]:(Zs(u,T,!1),E.tm=b);var A=u[T].err;for(w=1;(x=w+w)<=y[0]&&(x<y[0]&&u[y[x]].err>u[y[x+1]].err&&x++,!(A<=u[S=y[x]].err));w=x)y[w]=S;y[w]=T}var v=u[E.nn],
C=E.cnt,R=v.cnt,g=1/(C+R);c&&(E.ac=g*(C*E.ac+R*v.ac)),E.rc=g*(C*E.rc+R*v.rc),E.gc=g*(C*E.gc+R*v.gc),E.bc=g*(C*E.bc+R*v.bc),E.cnt+=v.cnt,E.mtm=++b,u[v.bk].fw=v.fw,
u[v.fw].bk=v.bk,v.mtm=h}let _=[];var re=0;for(b=0;;++re){let W=hr(Math.round(u[b].rc),0,255),O=hr(Math.round(u[b].gc),0,255),F=hr(Math.round(u[b].bc),0,255),P=255;
c&&(P=hr(Math.round(u[b].ac),0,255),i&&(P=P<=(typeof i=="number"?i:127)?0:255),o&&P<=a&&(W=O=F=s,P=0));let H=c?[W,O,F,P]:[W,O,F];if(ic(_,H)||_.push(H),(b=u[b].fw)==
0)break}return _}function ic(t,e){for(let r=0;r<t.length;r++){let n=t[r],o=n[0]===e[0]&&n[1]===e[1]&&n[2]===e[2],s=n.length>=4&&e.length>=4?n[3]===e[3]:!0;if(o&&
s)return!0}return!1}function yr(t,e){var r=0,n;for(n=0;n<t.length;n++){let o=t[n]-e[n];r+=o*o}return r}function fr(t,e){return e>1?Math.round(t/e)*e:t}function lc(t,{
roundRGB:e=5,roundAlpha:r=10,oneBitAlpha:n=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,d=a>>8&255,c=a&
255;i=fr(i,r),n&&(i=i<=(typeof n=="number"?n:127)?0:255),c=fr(c,e),d=fr(d,e),l=fr(l,e),o[s]=i<<24|l<<16|d<<8|c<<0}}function cc(t,e,r="rgb565"){if(!t||!t.buffer)
throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expecte\
d RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let n=new Uint32Array(t.buffer),o=n.length,s=r==="\
rgb444"?4096:65536,a=new Uint8Array(o),i=new Array(s),l=r==="rgba4444";if(r==="rgba4444")for(let d=0;d<o;d++){let c=n[d],u=c>>24&255,m=c>>16&255,h=c>>8&255,y=c&
255,f=ta(y,h,m,u),g=f in i?i[f]:i[f]=uc(y,h,m,u,e);a[d]=g}else{let d=r==="rgb444"?ra:ea;for(let c=0;c<o;c++){let u=n[c],m=u>>16&255,h=u>>8&255,y=u&255,f=d(y,h,m),
g=f in i?i[f]:i[f]=dc(y,h,m,e);a[c]=g}}return a}function uc(t,e,r,n,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],d=l[3],c=Be(d-n);if(c>a)continue;let u=l[0];
if(c+=Be(u-t),c>a)continue;let m=l[1];if(c+=Be(m-e),c>a)continue;let h=l[2];c+=Be(h-r),!(c>a)&&(a=c,s=i)}return s}function dc(t,e,r,n){let o=0,s=1e100;for(let a=0;a<
n.length;a++){let i=n[a],l=i[0],d=Be(l-t);if(d>s)continue;let c=i[1];if(d+=Be(c-e),d>s)continue;let u=i[2];d+=Be(u-r),!(d>s)&&(s=d,o=a)}return o}function pc(t,e,r=5){
if(!t.length||!e.length)return;let n=t.map(a=>a.slice(0,3)),o=r*r,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>
s?i=i.slice(0,3):i=i.slice();let l=oa(n,i.slice(0,3),yr),d=l[0],c=l[1];c>0&&c<=o&&(t[d]=i)}}function Be(t){return t*t}function na(t,e,r=yr){let n=1/0,o=-1;for(let s=0;s<
t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return o}function oa(t,e,r=yr){let n=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=r(e,a);i<n&&(n=i,o=s)}return[
o,n]}function mc(t,e,r=yr){return t[na(t,e,r)]}function sa(t={}){let{initialCapacity:e=4096,auto:r=!0}=t,n=Qs(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),
i=new Int32Array(o),l=!1;return{reset(){n.reset(),l=!1},finish(){n.writeByte(tc.trailer)},bytes(){return n.bytes()},bytesView(){return n.bytesView()},get buffer(){
return n.buffer},get stream(){return n},writeHeader:d,writeFrame(c,u,m,h={}){let{transparent:y=!1,transparentIndex:f=0,delay:g=0,palette:b=null,repeat:S=0,colorDepth:w=8,
dispose:x=-1}=h,A=!1;if(r?l||(A=!0,d(),l=!0):A=!!h.first,u=Math.max(0,Math.floor(u)),m=Math.max(0,Math.floor(m)),A){if(!b)throw new Error("First frame must incl\
ude a { palette } option");fc(n,u,m,b,w),Js(n,b),S>=0&&yc(n,S)}let k=Math.round(g/10);hc(n,x,k,y,f);let E=!!b&&!A;gc(n,u,m,E?b:null),E&&Js(n,b),bc(n,c,u,m,w,s,a,
i)}};function d(){aa(n,"GIF89a")}}function hc(t,e,r,n,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,n=!1);var s,a;n?(s=1,a=2):(s=0,a=0),e>=0&&(a=
e&7),a<<=2,t.writeByte(0|a|0|s),Ce(t,r),t.writeByte(o||0),t.writeByte(0)}function fc(t,e,r,n,o=8){let i=mn(n.length)-1,l=128|o-1<<4|0|i,d=0,c=0;Ce(t,e),Ce(t,r),
t.writeBytes([l,d,c])}function yc(t,e){t.writeByte(33),t.writeByte(255),t.writeByte(11),aa(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Ce(t,e),t.writeByte(0)}
function Js(t,e){let r=1<<mn(e.length);for(let n=0;n<r;n++){let o=[0,0,0];n<e.length&&(o=e[n]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function gc(t,e,r,n){
if(t.writeByte(44),Ce(t,0),Ce(t,0),Ce(t,e),Ce(t,r),n){let a=mn(n.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function bc(t,e,r,n,o=8,s,a,i){oc(r,n,e,o,t,s,
a,i)}function Ce(t,e){t.writeByte(e&255),t.writeByte(e>>8&255)}function aa(t,e){for(var r=0;r<e.length;r++)t.writeByte(e.charCodeAt(r))}function mn(t){return Math.
max(Math.ceil(Math.log2(t)),1)}var vc=sa});var Sn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ct={DISAPPEAR:0,REACH:1,BOUNCE:2},Mn={OCCUPATION:0,SURROUND:1},An={FAULT:0,INVOLVED:1};var Ar=["obstacle","teammate","adversary"],Er=["vertex","edge","chain"],En=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Tr=["p\
ursuer_{number}","evader_{number}"],Tn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ut={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Cn="{event}: {outcome}",Cr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},kn={free:".GS",blocked:"#@OTW"};var We=1+En.length;function dt(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function K(t,e){return t<e?dt(Tr[0],{number:t}):dt(Tr[1],{number:t-e})}function Da(t,e){
let[r,n,o,s,a,i,l,...d]=Array.from(t),c=a<0?[s]:[s,a],[u,m,h]=d.map(b=>c.filter((S,w)=>b>>w&1)),y=c.map(b=>K(b,e)),f=dt(Tn[a<0?"obstacle":Er[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=dt(Cn,{event:f,outcome:Wa(c.length,m,h,e)});return{kind:Ar[n],form:Er[o],agents:c,cell:[i,l],at_fault:u,held:m,doomed:h,turn:r,
text:g}}function Wa(t,e,r,n){if(t===2&&e.length===2)return ut["both held"];if(t===2&&r.length===2)return ut["both doomed"];let o=s=>a=>dt(ut[s],{agent:K(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||ut.none}function Ot(t,e){let r=[];for(let n=0;n<t.length;n+=We)r.push(Da(t.subarray(n+1,n+We),e));
return r}var we=class extends Error{name="EngineError"};function U(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var He=class{bytes;constructor(e){this.bytes=e}},$n=0,Rr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Rn=4,_n=4,Ha=new TextEncoder,
ja=new TextDecoder;function Ga(t){for(let e=Rr.length-1;e>$n;--e)if(t instanceof Rr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function kr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Va(t){return Ha.encode(`${t}\0`)}var _r=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Va(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof He,l=i?a.bytes:
a;return[this.text(s),i?$n:Ga(l),l.length,this.copy(kr(l))]}),o=this.copy(kr(Int32Array.from(n)));return this.copy(kr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Pn(t,e){let r=t.HEAPU8;return ja.decode(r.subarray(e,r.indexOf(0,e)))}function je(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Rn,n=e[r+1]/Rn,o={};for(let s=n;s<n+e[r]*_n;s+=_n){let a=Rr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Pn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new _r(t);try{let n=e(r);if(n===0)throw new we(Pn(t,t._last_error()));return n}finally{r.free()}}var qa=2**31-1,On=["none","gru"],Ka=2n**64n-1n,Ya=34028234663852886e22;function ge(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>qa)throw U(t,"a\
n integer",e);return Int32Array.of(e)}function Lt(t,e){if(typeof e!="boolean")throw U(t,"true or false",e);return new He(Uint8Array.of(Number(e)))}function ke(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw U(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function $r(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ya))throw U(t,"a finite number",e);return e}function Ge(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Ka)throw U(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Za(t){return{"rules.interaction":ke("interactio\
n",t.interaction,Sn),"rules.obstacle":ke("obstacle",t.obstacle,ct),"rules.teammate":ke("teammate",t.teammate,ct),"rules.evader":ke("evader",t.evader,ct),"rules.\
pursuer":ke("pursuer",t.pursuer,ct),"rules.capture":ke("capture",t.capture,Mn),"rules.captured_disappear":Lt("captured_disappear",t.captured_disappear)}}function Ln(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw U(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>$r(t,n))}function Ja(t){let e=(r,n)=>Float32Array.
of($r(r,t[r]),$r(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Ln("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Ln("evader_collide",t.evader_collide),
"rewards.blame":ke("blame",t.blame,An),"rewards.capture_repeats":Lt("capture_repeats",t.capture_repeats)}}function Nn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=kn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw U(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw U(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Bn(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw U("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Ve(t){Bn(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Za(t.rules),...Ja(t.rewards),rows:ge("rows",t.rows),cols:ge("cols",t.cols),n_pursuers:ge("n_pursuers",t.n_pursuers),n_evaders:ge("n_evaders",t.n_evaders),fov:ge(
"fov",t.fov),diagonal:Lt("diagonal",t.diagonal),max_steps:ge("max_steps",t.max_steps),density:Float64Array.of(e),map:Nn(t.obstacles)}}function In(t,e){return Int32Array.
from((e??[]).flat(),r=>ge(t,r)[0])}function Fn(t,e){return Bn(t.obstacles,e),{seed:Ge("seed",t.seed??0n),episode:Ge("episode",t.episode??0),pursuers:In("pursuer\
s",t.pursuers),evaders:In("evaders",t.evaders),map:Nn(t.obstacles)}}function It(t){return{actions:Int32Array.from(t,e=>ge("actions",e)[0])}}function Se(t){if(typeof t==
"string"){if(!Object.hasOwn(Cr,t))throw U("policy",`one of ${Object.keys(Cr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw U("activation","'relu' or 'tanh'",t.activation);if(!On.includes(t.memory))throw U("memory",`one of ${On.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>ge("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Lt("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Xa=["first_turn","terminated","truncated"];function Un(t){let e={...t};for(let r of Xa)e[r]=new He(t[r]);return e}var zn="statistics.",Nt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Dn(Wn(o),0),Object.assign(this,o),this.first_conflict=Qa(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*We,n*We);return Ot(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw U("step",`0 to ${this.length}`,e)}};function Qa(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=We)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Dn(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var Wn=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(zn)?[[e.slice(zn.length),r]]:[]));function Hn(t,e,r,n){let o=[Ve(r.config),Se(r.pursuers),Se(r.evaders),
n];return xe(t,s=>{let[a,i,l,d]=o.map(c=>s.arrays(c));return t[e](a,i,l,d)}),je(t)}function jn(t,e,r,n){let o={seed:Ge("seed",r),episode:Ge("episode",n)};return new Nt(
e.config,r,n,Hn(t,"_play_match",e,o))}function Pr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw U("n_episodes","at least 1",n);let o=Hn(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return Wn(o)}function Gn(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:Ge("seed",r)},s=Pr(t,e,o,n);return Array.
from({length:n},(a,i)=>Dn(s,i))}var ei=7e6,ti=new FinalizationRegistry(([t,e])=>t._states_free(e));function ri({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,d=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),c=t.capture==="SURROUND"||t.evader===
"REACH",u=t.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(b,S)=>u?f:(f+S)/(S+1)).reduce((b,S)=>b*S,1),h=m(l+Number(d),s)*m(l*(1+Number(c))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function Bt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":ri(t)>ei?"the world is too large to be solved on the page":""}var Or=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,d]=e.actors,c=Array.from(i).filter(m=>l<=m&&m<d),u=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(u),play:o},{agents:c.filter(m=>!u(m)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((d,c)=>d*this.n_actions+e[c],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,d,c)=>l+
d*this.matrix[r*s.length+c],0),i=o.reduce((l,d,c)=>l+d*this.matrix[c*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Lr=60,pt=class{config;payoff;engine;states;n_turns;values;starts;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,l=>e._states_new(l.arrays(Ve(r)))),ti.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s,starts:a}=this.call(()=>e._states_payoffs(this.states)),i=s;this.starts=
a,this.values=[[n==="capture-rate"?i:i.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,
{next:s})}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.
max_steps:Math.min(this.config.max_steps,Lr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}get value(){return this.mean(this.values.at(-1)[0])}guaranteed(e,r){
let n=Se(r),o=Array.from({length:this.n_turns},(a,i)=>this.call(l=>this.engine._states_weigh(this.states,i,+(e==="evader"),l.arrays(n))).play),s=this.values[0][0];
for(let a=0;a<this.config.max_steps;a++){let i=s;for(let l=this.n_turns-1;l>=0;l--)s=this.backup(l,{next:s,[`${e}s`]:o[l]});if(s.every((l,d)=>l===i[d]))break}return this.
mean(s)}mean(e){return this.starts.reduce((r,n)=>r+e[n],0)/this.starts.length}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new Or(e,a):null}call(e){
return xe(this.engine,e),je(this.engine)}};var Vn=new FinalizationRegistry(([t,e])=>t._world_free(e)),mt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(Ve(r)))),Vn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Vn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw U("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Fn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=It(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=It(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw U("actions",String(this.n_agents),n.length);let l=[
Se(e),It(n)],{actions:d}=this.call(c=>this.engine._world_decide(this.address,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.from(d)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Ot(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Se(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:ni(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Un(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return xe(this.engine,e),je(this.engine)}};function ni(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Ir=class{compiled;constructor(e){this.compiled=e}world(e){return new mt(this.compiled,e)}solution(e,r="capture-rate"){return new pt(this.compiled,e,r)}match(e,r,n,o,s=0){
return jn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return Gn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return Pr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},qn;function Kn(t=globalThis.matrixworldEngine){return qn??=oi(t),qn}async function oi(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Ir(await t({wasmBinary:e}))}var si="http://www.w3.org/2000/svg";function p(t,e={},...r){return Yn(document.createElement(t),e,r)}function M(t,e={},...r){return Yn(document.createElementNS(
si,t),e,r)}function Yn(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(ai).map(n=>typeof n=="number"?String(n):n)),t}function ai(t){return t!=null&&t!==!1}var ht=()=>["file:","http:","https:"].
includes(location.protocol);async function Zn(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}function ii(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function Nr(){document.documentElement.
dataset.theme=ii()?"light":"dark"}if(typeof document<"u"){let t=document.documentElement.dataset,e=t.theme;addEventListener("beforeprint",()=>{e=t.theme,t.theme=
"light"}),addEventListener("afterprint",()=>{e?t.theme=e:delete t.theme})}function Jn(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:Nr},"◐")}var Xn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,Jn()));var li=2n**64n-1n;function ft(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(d,c,u)=>{let m=n.get(d)??"";return/^\d{1,9}$/.test(m)&&Number(m)<c?Number(
m):u},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=li?l:null,map:ci(o("map",e[s].maps?.walls.length??0,-1)),step:o("ste\
p",1/0,0)}}var ci=t=>t<0?null:t;function Qn(t,e,r){let[n,o,s]=["",JSON.stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:d,episode:c,seed:u,map:m}=e.
selected,h={run:i,pursuers:l,evaders:d,episode:c,...u===null?{}:{seed:u},...m===null?{}:{map:m},step:r.player.step},y=JSON.stringify(e.selected),f=y!==o&&performance.
now()-s>800;y!==o&&([o,s]=[y,performance.now()]),n=`#${Object.entries(h).map(([g,b])=>`${g}=${b}`).join("&")}`;try{f?history.pushState(null,"",n):history.replaceState(
null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||a()),r.player.addEventListener("step",()=>r.player.playing||a()),
window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=ft(location.hash,t,e.selected);for(let d of document.querySelectorAll("di\
alog[open]"))d.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var B=Uint8Array,Q=Uint16Array,Gr=Int32Array,Ut=new B([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),zt=new B([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),zr=new B([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),so=function(t,e){for(var r=new Q(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Gr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},ao=so(Ut,2),io=ao.b,Dr=ao.r;io[28]=258,Dr[258]=28;var lo=so(
zt,0),ui=lo.b,eo=lo.r,Wr=new Q(32768);for($=0;$<32768;++$)be=($&43690)>>1|($&21845)<<1,be=(be&52428)>>2|(be&13107)<<2,be=(be&61680)>>4|(be&3855)<<4,Wr[$]=((be&65280)>>
8|(be&255)<<8)>>1;var be,$,de=(function(t,e,r){for(var n=t.length,o=0,s=new Q(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new Q(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new Q(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var d=o<<4|t[o],c=e-t[o],u=a[t[o]-1]++<<c,m=u|(1<<c)-1;u<=m;++u)i[Wr[u]>>l]=d}else for(i=new Q(
n),o=0;o<n;++o)t[o]&&(i[o]=Wr[a[t[o]-1]++]>>15-t[o]);return i}),Me=new B(288);for($=0;$<144;++$)Me[$]=8;var $;for($=144;$<256;++$)Me[$]=9;var $;for($=256;$<280;++$)
Me[$]=7;var $;for($=280;$<288;++$)Me[$]=8;var $,bt=new B(32);for($=0;$<32;++$)bt[$]=5;var $,di=de(Me,9,0),pi=de(Me,9,1),mi=de(bt,5,0),hi=de(bt,5,1),Br=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},ie=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Fr=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Vr=function(t){return(t+7)/8|0},qr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new B(t.subarray(
e,r))};var fi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Y=function(t,e,r){var n=new Error(e||fi[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,Y),!r)throw n;return n},yi=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new B(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new B(o*3));var d=function(it){var lt=r.length;if(it>lt){var De=new B(Math.max(lt*2,it));De.set(r),r=De}},c=e.f||0,u=e.
p||0,m=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,b=o*8;do{if(!h){c=ie(t,u,1);var S=ie(t,u+1,3);if(u+=3,S)if(S==1)h=pi,y=hi,f=9,g=5;else if(S==2){var k=ie(t,u,31)+257,E=ie(
t,u+10,15)+4,T=k+ie(t,u+5,31)+1;u+=14;for(var v=new B(T),C=new B(19),R=0;R<E;++R)C[zr[R]]=ie(t,u+R*3,7);u+=E*3;for(var _=Br(C),re=(1<<_)-1,W=de(C,_,1),R=0;R<T;){
var O=W[ie(t,u,re)];u+=O&15;var w=O>>4;if(w<16)v[R++]=w;else{var F=0,P=0;for(w==16?(P=3+ie(t,u,3),u+=2,F=v[R-1]):w==17?(P=3+ie(t,u,7),u+=3):w==18&&(P=11+ie(t,u,
127),u+=7);P--;)v[R++]=F}}var H=v.subarray(0,k),z=v.subarray(k);f=Br(H),g=Br(z),h=de(H,f,1),y=de(z,g,1)}else Y(1);else{var w=Vr(u)+4,x=t[w-4]|t[w-3]<<8,A=w+x;if(A>
o){l&&Y(0);break}i&&d(m+x),r.set(t.subarray(w,A),m),e.b=m+=x,e.p=u=A*8,e.f=c;continue}if(u>b){l&&Y(0);break}}i&&d(m+131072);for(var Fe=(1<<f)-1,ne=(1<<g)-1,ye=u;;ye=
u){var F=h[Fr(t,u)&Fe],J=F>>4;if(u+=F&15,u>b){l&&Y(0);break}if(F||Y(2),J<256)r[m++]=J;else if(J==256){ye=u,h=null;break}else{var X=J-254;if(J>264){var R=J-257,N=Ut[R];
X=ie(t,u,(1<<N)-1)+io[R],u+=N}var ue=y[Fr(t,u)&ne],Ue=ue>>4;ue||Y(3),u+=ue&15;var z=ui[Ue];if(Ue>3){var N=zt[Ue];z+=Fr(t,u)&(1<<N)-1,u+=N}if(u>b){l&&Y(0);break}
i&&d(m+131072);var ze=m+X;if(m<z){var $t=s-z,Pt=Math.min(z,ze);for($t+m<0&&Y(3);m<Pt;++m)r[m]=n[$t+m]}for(;m<ze;++m)r[m]=r[m-z]}}e.l=h,e.p=ye,e.b=m,e.f=c,h&&(c=
1,e.m=f,e.d=y,e.n=g)}while(!c);return m!=r.length&&a?qr(r,0,m):r.subarray(0,m)},ve=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},yt=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Ur=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:uo,l:0};if(o==1){var a=new B(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,k){return A.f-k.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],d=0,
c=1,u=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};c!=o-1;)i=r[r[d].f<r[u].f?d++:u++],l=r[d!=c&&r[d].f<r[u].f?d++:u++],r[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,n=1;n<
o;++n)s[n].s>m&&(m=s[n].s);var h=new Q(m+1),y=Hr(r[c-1],h,0);if(y>e){var n=0,f=0,g=y-e,b=1<<g;for(s.sort(function(k,E){return h[E.s]-h[k.s]||k.f-E.f});n<o;++n){
var S=s[n].s;if(h[S]>e)f+=b-(1<<y-h[S]),h[S]=e;else break}for(f>>=g;f>0;){var w=s[n].s;h[w]<e?f-=1<<e-h[w]++-1:++n}for(;n>=0&&f;--n){var x=s[n].s;h[x]==e&&(--h[x],
++f)}y=e}return{t:new B(h),l:y}},Hr=function(t,e,r){return t.s==-1?Math.max(Hr(t.l,e,r+1),Hr(t.r,e,r+1)):e[t.s]=r},to=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new Q(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},gt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},co=function(t,e,r){var n=r.length,o=Vr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},ro=function(t,e,r,n,o,s,a,i,l,d,c){ve(e,c++,r),++o[256];for(var u=Ur(o,15),m=u.t,h=u.l,y=Ur(s,15),f=y.t,g=y.l,b=to(m),S=b.c,
w=b.n,x=to(f),A=x.c,k=x.n,E=new Q(19),T=0;T<S.length;++T)++E[S[T]&31];for(var T=0;T<A.length;++T)++E[A[T]&31];for(var v=Ur(E,7),C=v.t,R=v.l,_=19;_>4&&!C[zr[_-1]];--_)
;var re=d+5<<3,W=gt(o,Me)+gt(s,bt)+a,O=gt(o,m)+gt(s,f)+a+14+3*_+gt(E,C)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&re<=W&&re<=O)return co(e,c,t.subarray(l,l+d));var F,P,H,
z;if(ve(e,c,1+(O<W)),c+=2,O<W){F=de(m,h,0),P=m,H=de(f,g,0),z=f;var Fe=de(C,R,0);ve(e,c,w-257),ve(e,c+5,k-1),ve(e,c+10,_-4),c+=14;for(var T=0;T<_;++T)ve(e,c+3*T,
C[zr[T]]);c+=3*_;for(var ne=[S,A],ye=0;ye<2;++ye)for(var J=ne[ye],T=0;T<J.length;++T){var X=J[T]&31;ve(e,c,Fe[X]),c+=C[X],X>15&&(ve(e,c,J[T]>>5&127),c+=J[T]>>12)}}else
F=di,P=Me,H=mi,z=bt;for(var T=0;T<i;++T){var N=n[T];if(N>255){var X=N>>18&31;yt(e,c,F[X+257]),c+=P[X+257],X>7&&(ve(e,c,N>>23&31),c+=Ut[X]);var ue=N&31;yt(e,c,H[ue]),
c+=z[ue],ue>3&&(yt(e,c,N>>5&8191),c+=zt[ue])}else yt(e,c,F[N]),c+=P[N]}return yt(e,c,F[256]),c+P[256]},gi=new Gr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),uo=new B(0),bi=function(t,e,r,n,o,s){var a=s.z||t.length,i=new B(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),d=s.l,c=(s.r||0)&7;if(e){
c&&(l[0]=s.r>>3);for(var u=gi[e-1],m=u>>13,h=u&8191,y=(1<<r)-1,f=s.p||new Q(32768),g=s.h||new Q(y+1),b=Math.ceil(r/3),S=2*b,w=function(Mr){return(t[Mr]^t[Mr+1]<<
b^t[Mr+2]<<S)&y},x=new Gr(25e3),A=new Q(288),k=new Q(32),E=0,T=0,v=s.i||0,C=0,R=s.w||0,_=0;v+2<a;++v){var re=w(v),W=v&32767,O=g[re];if(f[W]=O,g[re]=W,R<=v){var F=a-
v;if((E>7e3||C>24576)&&(F>423||!d)){c=ro(t,l,0,x,A,k,T,C,_,v-_,c),C=E=T=0,_=v;for(var P=0;P<286;++P)A[P]=0;for(var P=0;P<30;++P)k[P]=0}var H=2,z=0,Fe=h,ne=W-O&32767;
if(F>2&&re==w(v-ne))for(var ye=Math.min(m,F)-1,J=Math.min(32767,v),X=Math.min(258,F);ne<=J&&--Fe&&W!=O;){if(t[v+H]==t[v+H-ne]){for(var N=0;N<X&&t[v+N]==t[v+N-ne];++N)
;if(N>H){if(H=N,z=ne,N>ye)break;for(var ue=Math.min(ne,N-2),Ue=0,P=0;P<ue;++P){var ze=v-ne+P&32767,$t=f[ze],Pt=ze-$t&32767;Pt>Ue&&(Ue=Pt,O=ze)}}}W=O,O=f[W],ne+=
W-O&32767}if(z){x[C++]=268435456|Dr[H]<<18|eo[z];var it=Dr[H]&31,lt=eo[z]&31;T+=Ut[it]+zt[lt],++A[257+it],++k[lt],R=v+H,++E}else x[C++]=t[v],++A[t[v]]}}for(v=Math.
max(v,R);v<a;++v)x[C++]=t[v],++A[t[v]];c=ro(t,l,d,x,A,k,T,C,_,v-_,c),d||(s.r=c&7|l[c/8|0]<<3,c-=7,s.h=g,s.p=f,s.i=v,s.w=R)}else{for(var v=s.w||0;v<a+d;v+=65535){
var De=v+65535;De>=a&&(l[c/8|0]=d,De=a),c=co(l,c+1,t.subarray(v,De))}s.i=a}return qr(i,0,n+Vr(c)+o)},vi=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),wi=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=vi[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var xi=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new B(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return bi(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},po=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var j=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Si=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&Y(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&Y(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Mi(t,e){return xi(t,e||{},0,0)}function mo(t,e){return yi(t.subarray(Si(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var ho=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=po(n,s[1]),s=s[0]),s instanceof B?r[a]=[s,i]:(r[a+="/"]=[new B(0),i],ho(s,a,r,
n))}},no=typeof TextEncoder<"u"&&new TextEncoder,Ai=typeof TextDecoder<"u"&&new TextDecoder,Ei=0;try{Ai.decode(uo,{stream:!0}),Ei=1}catch{}function Ft(t,e){if(e){for(var r=new B(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(no)return no.encode(t);for(var o=t.length,s=new B(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var l=new B(a+8+(o-n<<1));l.set(s),s=l}var d=t.charCodeAt(n);d<128||e?i(d):d<2048?(i(192|
d>>6),i(128|d&63)):d>55295&&d<57344?(d=65536+(d&1047552)|t.charCodeAt(++n)&1023,i(240|d>>18),i(128|d>>12&63),i(128|d>>6&63),i(128|d&63)):(i(224|d>>12),i(128|d>>
6&63),i(128|d&63))}return qr(s,0,a)}var jr=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&Y(9),e+=n+4}return e},oo=function(t,e,r,n,o,s,a,i){var l=n.length,d=r.extra,c=i&&i.length,
u=jr(d);j(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var m=new Date(r.mtime==null?Date.now():r.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&Y(10),j(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(j(t,e,r.crc),j(t,e+4,s<0?-s-2:s),j(t,e+8,r.size)),j(t,e+12,l),j(t,e+14,u),e+=16,a!=null&&(j(t,e,
c),j(t,e+6,r.attrs),j(t,e+10,a),e+=14),t.set(n,e),e+=l,u)for(var y in d){var f=d[y],g=f.length;j(t,e,+y),j(t,e+2,g),t.set(f,e+4),e+=4+g}return c&&(t.set(i,e),e+=
c),e},Ti=function(t,e,r,n,o){j(t,e,101010256),j(t,e+8,r),j(t,e+10,r),j(t,e+12,n),j(t,e+16,o)};function fo(t,e){e||(e={});var r={},n=[];ho(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],d=i[1],c=d.level==0?0:8,u=Ft(a),m=u.length,h=d.comment,y=h&&
Ft(h),f=y&&y.length,g=jr(d.extra);m>65535&&Y(11);var b=c?Mi(l,d):l,S=b.length,w=wi();w.p(l),n.push(po(d,{size:l.length,crc:w.d(),c:b,f:u,m:y,u:m!=a.length||y&&h.
length!=f,o,compression:c})),o+=30+m+g+S,s+=76+2*(m+g)+(f||0)+S}for(var x=new B(s+22),A=o,k=s-o,E=0;E<n.length;++E){var u=n[E];oo(x,u.o,u,u.f,u.u,u.c.length);var T=30+
u.f.length+jr(u.extra);x.set(u.c,u.o+T),oo(x,o,u,u.f,u.u,u.c.length,u.o,u.m),o+=16+T+(u.m?u.m.length:0)}return Ti(x,o,n.length,k,A),x}var G=(t,e)=>`${t}s of generation ${e}`,pe=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ee=["pursuer","evader"];function go(){return JSON.parse(Wt("data"))}function qe(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}var Dt=({world:t,maps:e},r)=>e&&r!==null?{...t,obstacles:e.walls[r]}:
t;function Re(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${G(
e,r)}: it would be too large. Choose a generation of ${s.join(", ")}.`;let i=s.length*o.genome_size;return bo(a,o.genome_size).length===i?"":`The page is damage\
d: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function te(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];
if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.
genome_size,d=bo(a,l).subarray(i*l,(i+1)*l),{hidden:c,activation:u,sampled:m,memory:h}=o;return{hidden:c,activation:u,sampled:m,memory:h,genome:d}}var Kr=4,yo=new Map;function bo(t,e){let r=yo.get(t);if(r)return r;let n=new Float32Array;try{let o=ki(Yr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Ci(o)))throw o}return yo.set(t,n),n}var Ci=t=>t instanceof Error&&"code"in t;function ki(t,e){let r=mo(t),n=r.length/Kr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Kr*n+Math.floor(a/Kr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Yr(t){let e=atob(Wt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Wt(t){return document.getElementById(
t)?.textContent??""}var Ke=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function vo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Ke.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var _e=(t,e)=>e<t.nPursuers,I=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ri=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Zr=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Jr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Xr=(t,e)=>Jr(t.fault,e),wo=(t,e)=>!Xr(
t,e)&&Jr(t.involved,e,2);function Ht(t,e,r){let n=!Ri(I(t,r),I(e,r)),o=e.involved===void 0||Jr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function jt(t,e,r){
let[n,o]=I(t,r),[s,a]=Ke[e.actions?.[r]??0];return[n+s,o+a]}function vt(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var xo=t=>t.moments.flatMap((e,r)=>r&&vt(t,t.moments[r-1],e).length?[r]:[]);function Gt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var So=[-.31,0,.31],Mo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:So.flatMap(t=>So.map(e=>[e,t]))}],_i=.3,$i=.35,Pi=.55;function wt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=I(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Ao(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=I(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of wt(t,e).values()){let o=Mo[Math.min(n.length,Mo.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var Eo=t=>t*t*(3-2*t),Ye=(t,e,r)=>t+(e-t)*r,To=t=>Math.min(1,Math.max(0,t));function Co(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Eo(n);let s=o===r?e:+!_e(t,e),a=Math.max(1/o,$i);return Eo(To((n-s/(o-1)*(1-a))/a))}function Vt(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Ao(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Ao(t,a);return s.map((l,d)=>{let c=Co(
t,d,s.length,e-n);return Oi(o,a,d,l,i[d],c)})}function Qr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Co(t,e,s.alive.length,r-o),[[l,d],[c,u]]=[I(s,e),I(a,e)];return[Ye(d,u,i)+.5,Ye(l,c,i)+.5]}function Oi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Ye(n.x,o.x,
s),y:Ye(n.y,o.y,s),size:a?n.size:Ye(n.size,o.size,s),alpha:a?To((1-s)/(1-Pi)):Ye(n.alpha,o.alpha,s)};if(Ht(t,e,r)){let[l,d]=I(t,r),[c,u]=jt(t,e,r),m=_i*Math.sin(
Math.PI*s);i.x+=(u-d)*m,i.y+=(c-l)*m}return i}var ko=2*Math.PI;function $e(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,ko)}function qt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,c]=s[(l+1)%3];t.arcTo(a,i,d,c,n*.09)}),t.closePath()}function Ro(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function _o(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=ko*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function $o(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Po=4,Li=1.6,Ii=.95,Ni=5,Bi=.16,Fi=9,Ui=.09,zi=.2,Oo=.75,oe=(t,e)=>t.left+e*t.cell,se=(t,e)=>t.top+e*t.cell;function Ze(t,e,r){return _e(e,r)?t.colors.pursuer:
t.colors.evader}function Lo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,d),s<Ni)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let u=1;u<i;u++)t.fillRect(n+u*s,o,c,d);for(let u=1;u<a;u++)t.fillRect(n,o+u*s,l,c)}function Io({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[c,u]=[Math.floor(d/l),
d%l];t.fillRect(o+u*a,s+c*a,a,a)}No({ctx:t,grid:e,colors:r})}function No({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Bo({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,d=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*n+a/40;for(let u=0;u<l;u+=d)t.fillText(String(u),o+(u+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let u=0;u<i;u+=d)t.fillText(
String(u),o-c,s+(u+.5)*a)}function Fo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[oe(t,s),se(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Uo(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Fo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),No(t)}function zo({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[oe(e,n),se(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let u=d-i/2<c*1.2,m=d+(u?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,m),t.fillStyle=r.ink,t.fillText("You",l,m),t.globalAlpha=1}function Do(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Fo(t,e,n,o),l=Ze(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Wo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Fi,
Math.max(1,a.cell*Bi));for(let d=Math.max(1,Math.floor(r-n)+1);d<=i;d++){let[c,u]=[e.moments[d-1],e.moments[d]],m=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=
Oo+(zi-Oo)*m;for(let h=0;h<u.alive.length;h++){let y=d===i&&r<i;if(!c.alive[h]||!(l.alive[h]||y))continue;let f=(_e(e,h)?-1:1)*Ui,[g,b]=I(c,h),[S,w]=I(u,h);if(g===
S&&b===w)continue;let x=y?o[h].x:w+.5,A=y?o[h].y:S+.5;s.strokeStyle=Ze(t,e,h),s.beginPath(),s.moveTo(oe(a,b+.5+f),se(a,g+.5+f)),s.lineTo(oe(a,x+f),se(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Ho(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Po+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Po,l=vt(e,s,a);for(let d of Gt(s,a))l.includes(d)||Wi(t,I(a,d),i);for(let d of l)Di(t,I(a,d),i)}t.ctx.globalAlpha=1}function Di({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,_o(t,oe(e,o+.5),se(e,n+.5),Math.max(8,e.cell*Li)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Wi({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Ro(t,oe(e,o+.5),se(e,n+.5),Math.max(7,e.cell*Ii)),
t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function jo({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[oe(e,i)+s,se(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function Go({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,$e(t,oe(e,n),se(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Hi=.8,ji=.92,Gi=15,Vi=7,en=9;function Vo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&qi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of wt(e,r).values())a.length>
en&&Ki(t,n[a[en-1]],a.length-en+1)}function qi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=t,c=_e(e,n),[u,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(c?ji:Hi)),y=Ze(t,e,n),f=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?qt:$e)(i,u,m,h),h>Vi*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?d.paper:y,i.fill(),f&&($e(i,u,m,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Gi*a)return;let g=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(c?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:d.paper,i.fillText(
g,u,m+h*(c?.17:.03))}function Ki({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Yi=.46,Zi=.86,Ji=.66,qo=.48,Xi=.78,Qi=.58;function Ko(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)Ht(o,s,d)&&el(t,e,I(o,d),jt(o,s,d));a.globalAlpha=
1}function el({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=u=>oe(e,n[1]+.5+s*u),l=u=>se(e,n[0]+.5+a*u),d=Zr(r,o)?Xi:Qi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(qo),l(qo)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*c,l(d)+
s*c),t.lineTo(i(d)+a*c,l(d)-s*c),t.stroke()}function Yo(t,e,r,n,o,s){let a=Ke[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,c=Zr(e,[n[0]+a[0],n[1]+a[1]])?Zi:
Ji,u=Yi*o.size,m=[oe(l,o.x+a[1]*u),se(l,o.y+a[0]*u),oe(l,o.x+a[1]*c),se(l,o.y+a[0]*c)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[
d.paper,h*2.1],[Ze(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,$o(i,...m,l.cell*.2),i.stroke()}var Kt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Yt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),d=e.moments[l],c=r===l,u=Vt(e,r),m=c?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Lo(t);for(let f of n.
viewers)u[f]?.alpha&&Do(t,e,f,...Qr(e,f,r));Io(t,e),n.axes&&Bo(t,o),Wo(t,e,r,n.trail,u),jo(t,d.contested??[],m),Ho(t,e,r),Ko(t,e,l,m),u.forEach(({x:f,y:g,size:b},S)=>{
let w=wo(d,S)?.4:0,x=Xr(d,S)?1:w;x&&Go(t,f,g,b,x*m)});let h=c?d:e.moments[Math.max(0,l-1)];if(Vo(t,e,h,u,n.numbers,o),c&&n.plan)for(let[f,g]of u.entries())g.alpha&&
Yo(t,e,f,I(d,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Uo(t,e,...Qr(e,n.you,r)),zo(t,u[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:u[n.selected];y?.alpha&&Zo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Zo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Zo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var xt=(t,e)=>(e+.24)/(t+.24);function Zt(t,e,r,n,o,s){let a=r?28*s:0,i=(d,c)=>(d-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Jo(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var tl={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Je(t){let e=getComputedStyle(t),r=Object.entries(tl).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var le=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ae=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#s;#l;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Kt,...r},this.#s=new ResizeObserver(()=>this.#m()),this.#s.observe(e),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#p)}close(){this.#s.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#p),cancelAnimationFrame(this.#a)}get look(){return this.#t}set look(e){this.#t={...this.#t,...e},this.#c(),this.redraw()}show(e,r){this.#e=e,
this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#c(),this.redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};#p=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=Zt(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Je(this.canvas)};Yt(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Jo(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=wt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Vt(this.#e,Math.round(this.#r)),i=l=>{let[d,c]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(d-e,c-r)};return s.length?s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(xt(e,r)))}#m(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var rl=12e3;function Xo(t,e,r){let n=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>u(
d-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>u(d+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>u(0,!le())},"A guided minute"),[d,c]=[-1,0];function u(g,b){
clearTimeout(c);let S=n()[g];if(y(),!S)return m();d=g,o.replaceChildren(p("span",{class:"muted numbers"},`${g+1} of ${n().length} `),S.text),s.disabled=g===0,a.
textContent=g===n().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:S.pursuer,evader:S.evader,map:null}),S.shows==="judgement"?document.querySelector(".diag\
nosis")?.scrollIntoView({block:"nearest"}):S.shows==="checkerboard"?h():(r.reveal(),r.playSoon()),b&&(c=setTimeout(()=>u(g+1,!0),rl))}function m(){clearTimeout(
c),d=-1,i.hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let g=document.querySelector("dialog.four[open]");g?.append(i),g?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let y=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!n().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",g=>{g.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var St=[.5,1,2,4,8,16,32,64],Xe=0,Jt=12,nl=2,Ee=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#l=null;#p=0;#c=[];#m=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#r=r.speed??4,this.#t=r.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(nl,this.#e/Jt)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=St.findIndex(n=>n>=this.pace);this.speed=St[Math.min(St.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#d(r),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#a),this.#o("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#l===null&&(this.#p=performance.now(),
this.#l=requestAnimationFrame(()=>this.#h()))}#h(){this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#l=requestAnimationFrame(()=>this.#h()))}#u(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Te(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var Mt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Qe(t){let e=Math.min(1,Math.max(0,t))*(Mt.length-1),r=Math.min(Mt.length-2,Math.floor(e)),[n,o]=[Mt[r],
Mt[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Xt(t){let[e,r,n]=Qe(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var Qt=t=>`rgb(${Qe(t).join(" ")})`,Qo=()=>`linear-gradient(to right, ${Mt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function er(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=ol(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function ol(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,d)=>{let c=4*((e-1-i-t.first[0])*r+d+t.first[1]);s.data.set([...Qe(l),255],c)})),o.putImageData(s,0,0),n}function tr(t,e){let r=p("span",{class:"grad\
ient"});return r.style.backgroundImage=Qo(),p("p",{class:"scale-of-rates small muted"},t,r,e)}var sl=84;function es(t,e){let r=t.map((s,a)=>al(s,a,e)),n=p("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function al(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=sl/
Math.max(n,o),i=p("canvas",{"aria-hidden":"true"});er(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=p("span",{class:"place"}),d=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>tn(t,e,r)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${il(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:u=>{d.setAttribute("aria-current",String(u));let m=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=m>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-m-.5)*a}px`}}}var il=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function tn(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var ll=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again, \
in the world of the evaluation"],[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],
"to the matrix: arrow keys choose a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over\
 the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],
[["D"],"light or dark"],[["?"],"this list"]];function ts(){let t=ll.map(([r,n])=>p("div",{class:"key-row"},p("dt",{},...r.map(o=>p("kbd",{},o))),p("dd",{},n))),
e=p("dialog",{class:"help","aria-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page ho\
lds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the fil\
e as it is."),p("button",{type:"button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function rs(t,e,r,n,o,s){
let a=(l,d)=>()=>{let c=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(c-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.
selected.episode+1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),
o:()=>e.select({seed:null,episode:0,map:null}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),
a:()=>r.inspector.next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:Nr,"?":()=>n.showModal()};document.addEventListener("keydown",
l=>{let d=l.target instanceof HTMLSelectElement||l.target instanceof HTMLInputElement,c=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.
querySelector("dialog[open]")||d||c||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let u=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(Te(r.
player,l)||u)u?.();else if(t[m])tn(t[m],m,e);else return;l.preventDefault()})}function ns(t,e,r,n,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!n()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("progress").then(d=>d.json()).catch(()=>null);o(l),l!==null&&(l.version==="end"||l.version!==t&&a()?(cl(e,
r),location.reload()):setTimeout(()=>{i()},1e3))};i()}function cl(t,e){let{run:r,pursuer:n,evader:o}=e.selected,[s,a]=t[r].payoff.shape;n===s-1&&o===a-1&&history.
replaceState(null,"",`#run=${r}`)}function rn(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function nn(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function rr(t){let e=Array.from({length:t.length+1},(r,n)=>ul(t,n));return rn(t.config,t.map,e)}function ul(t,e){
let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),
everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var dl=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function os(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:dl,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var pl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function ss(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:pl[t]}))}function At(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},ss(t))}function et(t){let e=At("play","Play","Space",()=>t.toggle()),r=ml(t),
n=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=hl(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},At("first","First step","Home",()=>t.move(-t.length)),At("back","Step back","←",()=>t.move(-1)),
e,At("forward","Step forward","→",()=>t.move(1)),At("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,r),a,s),l=(u,m={})=>{let h=p("i",
m);return h.style.left=`${100*u/Math.max(1,t.length)}%`,h},d=()=>{n.replaceChildren(...t.marks.map(u=>l(u))),o.replaceChildren(...t.ticks.map(({step:u,kind:m,size:h,
text:y})=>{let f=l(u,{class:m,title:`Step ${u}: ${y}`});return f.style.height=`${100*h}%`,f}))},c=()=>{e.replaceChildren(ss(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",c),t.addEventListener("s\
tate",c),t.addEventListener("state",d),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==r)&&Te(t,u)&&u.preventDefault()}),
c(),i}function ml(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function hl(t){let e=`Steps a second, or the whole in ${Jt} s (+ and -)`,r=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:Xe},`in ${Jt} s`),...St.map(n=>p("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}var L=(t,e=2)=>t==null?"-":t.toFixed(e);function as(t,e,r){return e===null||r===null?L(t):`${L(t)} (${L(e)} to ${L(r)})`}var is=t=>t.toLocaleString("en-GB"),Pe=t=>t.
charAt(0).toUpperCase()+t.slice(1);function Et(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(d,c)=>(i+c)*a)}var fl=40,nr=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a,map:i}=this.#e.
selected,l=qe(e,n,o);this.#r.replaceChildren(...(l?.rates??[]).slice(0,fl).map((h,y)=>this.#n(h,y)));let d=a===null&&i===null?l?.rates[s]:void 0,c=r.statistics.
capture_rate,u=d!==void 0&&Math.abs(c-d)<1e-6&&r.length===l?.lengths[s],m=l?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";
this.#t.dataset.equal=String(u),this.#t.textContent=u?"As in the evaluation":d===void 0?m:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played he\
re: capture rate ${L(c,3)} in ${r.length} steps.${l?` The cell says ${L(l.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=p("span",{class:"bar"});return o.style.
height=`${Math.round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${L(e)}`,"aria-label":`Episode ${r+1}, capture rate\
 ${L(e)}`,"aria-pressed":String(r===n.episode&&n.seed===null&&n.map===null),onclick:()=>this.#e.select({episode:r,seed:null,map:null})},o,p("span",{class:"count"},
r+1))}};var ls=0,cs=1,yl=2,gl=176;function ds(t,e,r,n){let o=devicePixelRatio||1,s=Je(t);t.width=t.height=gl*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let c=0;r&&c<i*i;c++){let[u,m]=[(c%i+.5)*l,(Math.floor(c/i)+.5)*l],h=f=>!!r[f*i*i+c];h(yl)&&(a.fillStyle=
s.obstacle,a.fillRect(u-l/2,m-l/2,l,l));let y=h(ls)&&h(cs)?l*.18:0;h(ls)&&us(a,$e,u+y,m+y,l*.74,s.evader),h(cs)&&us(a,qt,u-y,m-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function us(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var ps="What it remembers: a number for each unit, from -1 to 1",or=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:ps});#l=null;#p=null;#c=null;#m=null;#d=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#i}show(e,r,n,o){this.#l?.free(),this.#l=e.world(n.config),
this.#c!==r&&(this.#p=null,this.#i!==null&&this.choose(null)),[this.#c,this.#m,this.#d]=[r,n,o]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#m;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,o,s,a]=[this.#m,this.#l,this.#c,this.#d,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},K(a,r.config.n_pursuers)));
let l={pursuers:te(o,"pursuer",s.pursuer),evaders:te(o,"evader",s.evader)};r.seek(n,e,l);let d=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;d.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(d);let c=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);ds(this.#r,r.config,c?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${K(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let u=d[a]??null;if(!c)return this.#u([],"It is gone.");let m=l[`${i}s`],
h=typeof m=="string"?null:n.answer(m,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),wl(h.memory));
let f=this.#p?.game(n)??null,g=typeof m=="string"?`The script "${m}" plays for it${u===null?"":`; it goes ${pe[u]}`}.`:m.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",b=[["network",y],["perfect",f?.marginal(a)??null]],S=w=>p("p",{class:"small muted"},w);this.#u([...f?[S(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...bl(b,u)],u===null?"The episode is over.":g)}#u(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function bl(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=p("div",{class:"action muted"},p("span"),...r.map(([s])=>p("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},pe[a]),...r.flatMap(([,i])=>vl(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function vl(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function wl(t){
let e=Array.from(t,r=>{let n=p("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return p("div",{class:"units",role:"img","aria-label":ps},
...e)}function tt(t,e,{pursuer:r,evader:n,episode:o,seed:s,map:a}){let i=e.seeds[r][n];return t.match(Dt(e,a),te(e,"pursuer",r),te(e,"evader",n),BigInt(s??i),o)}function ms(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var hs="champion",fs=0,on=64,sn=100;var xl=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function ys(t,e){return Object.keys(e).find(r=>xl(e[r],t))??null}var Tt="_",Sl="n",lp=2n**64n-1n;var an={fov:11,maxSteps:500,rewards:"paper"},Ml=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function vs(t,e){let r=i=>i.map(l=>El(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Al(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:bs(
t.rules,e),others:t.others?bs(t.others,e):"",rewards:o===an.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===an.fov?"":String(t.fov),
limit:t.maxSteps===an.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(Tt),pursuers:t.pursuers.map(gs).join(Tt),
evaders:t.evaders.map(gs).join(Tt),played:t.played.map(r).join(Tt),next:t.next.every(i=>i===fs)?"":r(t.next)};return Ml.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function gs({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function bs(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return ys(t,e.variants)??r.join(".")}function Al(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(Tt)}function El(t,e){if(typeof t=="number")return String(t);if(t===hs)return Sl;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Tl="/* the engine */";function ws(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>ln(t(),e)},"What if?")}function ln(t,e){let r=t!==null&&t.match.n_agents<=sn&&Math.max(t.match.config.rows,t.match.config.
cols)<=on,n=r?vs(Cl(t.match,t.step),e):"",o=new TextDecoder().decode(Yr("playground")).replace(Tl,()=>Wt("script-engine")).replace("</noscript>",s=>r?s+ms(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Cl(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
d=o*r.n_evaders+i-r.n_pursuers,c=u=>i>=r.n_pursuers&&!!u[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:c(t.captured),
everCaptured:c(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var cn=.005,Ss=.05,kl=["pursuer","evader"],Rl=4,rt=new Map;function sr(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=rt.get(n)??(Bt(e)?Promise.
resolve(null):_l(t,e,r));return rt.delete(n),rt.set(n,o),rt.size>Rl&&rt.delete([...rt.keys()][0]),o}var Ms=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
xs=()=>new Promise(t=>setTimeout(t));async function _l(t,e,r){await xs();let n=t.solution(e,r);for(;n.goBack();)await xs();return n}function ar(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((d,c)=>a[c]+=d),e.playTurn(o);let i=n==="capture-rate"?cn:Ss;
return kl.map((l,d)=>({step:s+1,team:l,lost:a[d],payoff:n})).filter(l=>l.lost>=i)})}var ir=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:Ct(e)})),As=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,Ct=t=>`The ${t.team}s los\
e ${As(t)} against a perfect opponent`;function Es(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${As(e)} \
against a perfect opponent.`}function Ts({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,Lr)];return o>s-Ss?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Cs(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=cn).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-cn?pe[o]:`${pe[o]} ${n.toFixed(2)}`).join(", ")}function lr(t,e,r){if(r===0)return[{kind:"start",text:$l(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>K(c,t.config.n_pursuers),a=vt(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(c=>c.doomed)),d=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of Gt(n,o))!a.includes(c)&&!l.has(c)&&d.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return d.push(...i.map(({kind:c,text:u,agents:m})=>({kind:c,text:u,agents:m}))),r===t.length&&d.unshift({kind:"\
end",text:Pl(t),agents:[]}),d}function $l({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Pl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Ol=60,cr=class{element;player=new Ee(0,{speed:Xe,still:le()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#l=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#p=p("p",{class:"problem",role:"a\
lert"});#c=null;#m=null;#d=0;#i=!1;#h=0;#u=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=p("canvas",{"aria-label":"The match"});this.#e=new Ae(o,{numbers:!1}),
this.#n=new nr(r),this.inspector=new or(s=>this.#x(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p(
"div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&ws(()=>this.shown,n)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p(
"div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),this.#p,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#l,os(),this.actions,this.
inspector.element),et(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#f()),r.on("rest",()=>this.player.pause()),this.#v(),this.#S(0,0)}get#o(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){
this.#c=e,this.#y()}playSoon(){this.#i=!0,this.#d||this.#g()}goTo(e){this.#h=e,!this.#d&&this.match&&this.#y()}#g(){!this.#i||!this.match||(this.#i=!1,this.player.
jump(0),le()||this.player.play())}#f(){this.#v(),clearTimeout(this.#d),this.#d=setTimeout(()=>this.#y(),Ol)}#y(){clearTimeout(this.#d),this.#d=0,this.player.pause(),
this.#v();let{selected:e}=this.#t,r=ee.map(s=>Re(this.#o,s,e[s])).find(Boolean)??"";if(this.#p.textContent=r,r||!this.#c)return;this.match=tt(this.#c,this.#o,e);
let[n,o]=this.names(e);this.#m={pursuer:{name:n,policy:te(this.#o,"pursuer",e.pursuer)},evader:{name:o,policy:te(this.#o,"evader",e.evader)}},this.recording=rr(
this.match),this.#n.show(this.#o,this.match),this.inspector.show(this.#c,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=xo(this.recording),
this.#u=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#w(),this.#b(this.#c,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.element.dataset.map=String(e.map??""),this.#g()}async#b(e,r){let n=await sr(e,r.config);if(this.match!==r||!n)return;let o=e.world(
r.config);r.seek(o,0),this.#u=ar(n,o,Ll(r)),o.free(),this.player.ticks=ir(this.#u),this.inspector.solution=n,this.#w()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#r[e];
return[o.pursuer.script??G("pursuer",r),o.evader.script??G("evader",n)]}#v(){let{episode:e,seed:r,map:n}=this.#t.selected,{payoff:o,maps:s}=this.#o,[a,i]=this.names(
this.#t.selected),l=r===null?e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`,d=s&&n!==null?`, on map ${n%s.count+
1} of generation ${Math.floor(n/s.count)}`:"";this.#a.replaceChildren(p("span",{class:"pursuer"},Pe(a))," against ",p("span",{class:"evader"},i),p("span",{class:"\
muted small"},l+d))}#w(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];this.#S(Array.from(n.everCaptured).filter(
Boolean).length,r),this.#l.replaceChildren(...this.#u.filter(o=>o.step===r).map(o=>p("li",{class:`loss-${o.team}`},Ct(o))),...lr(e,this.recording,r).map(o=>p("l\
i",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(e,r){this.#s.replaceChildren(p("strong",{},e),` of ${this.#o.world.
n_evaders} captured`,p("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;
for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}},Ll=({actions:t,length:e,n_agents:r})=>Array.
from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var Il={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Nl=5;function ce(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Il[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,d]=r(),c=o.shiftKey?Nl:1,{pursuer:u,evader:m}=e.selected;e.
select({pursuer:ks(u+c*a,l),evader:ks(m+c*i,d)}),o.preventDefault(),o.stopPropagation()})}var ks=(t,e)=>Math.min(e-1,Math.max(0,t));var Bl=24,ur=7,_s=t=>t<Bl&&matchMedia("(pointer: coarse)").matches;function $s(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Rs(e,o),Rs(r,s)],[l,d]=[Math.min(ur,o),Math.
min(ur,s)],c=[];for(let y=a+l-1;y>=a;y--){c.push(p("span",{class:"pursuer"},y));for(let f=i;f<i+d;f++)c.push(Fl(t,y,f,n))}let u=Array.from({length:d},(y,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...c,m,...u);return h.style.gridTemplateColumns=`2.4rem repeat(${d}, minmax(0, 1fr))`,h.addEventListener("click",y=>y.stopPropagation()),
h}function Fl(t,e,r,n){let o=qe(t,e,r)?.rate,s=p("button",{type:"button","aria-label":`${L(o)}: ${G("pursuer",e)} against ${G("evader",r)}`,onclick:()=>n({pursuer:e,
evader:r})},L(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Qt(o),Xt(o)]),s}var Rs=(t,e)=>Math.max(0,Math.min(e-ur,t-Math.floor(ur/2)));var ae={left:52,bottom:46,top:76,right:84},me=10,Ul=160,kt=ae.right-me-14,Oe=ae.top-me-14,dr=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=M("svg",
{"aria-hidden":"true"});#a=M("g");#s;#l=p("h2");#p=p("strong",{class:"rate numbers"});#c=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#d=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#l,this.#m),p("div",{class:"of-cell"},this.#p,this.#c));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,tr("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).
observe(this.#s),this.#s.addEventListener("pointermove",o=>this.#v(o)),this.#s.addEventListener("pointerleave",()=>r.point({})),this.#s.addEventListener("click",
o=>this.#w(o)),this.#s.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ce(this.#s,
r,()=>this.#i.payoff.shape),this.#s.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#g()),r.on("hove\
r",()=>this.#g())}get#i(){return this.#r[this.#e.selected.run]}#h(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.
max(Ul,Math.min(n-ae.left-ae.right,o-ae.top-ae.bottom))/Math.max(e,r),i=Math.max(ae.left,(n-r*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(o-ae.top-ae.bottom-e*a)/
2),d={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};this.#d=d,er(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[c,u,m]of[["left",i,
n],["top",l,o],["width",r*a,n],["height",e*a,o]])this.#t.style.setProperty(c,`${100*u/m}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute(
"viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(zl(d),...Dl(d),...this.#o(d),this.#a),this.#g()}#u(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ps(e,r.pursuers.mean[s]??0,s),[d,c]=Os(e,r.evaders.mean[a]??0,a);return[M("cir\
cle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:d,cy:c,r:5})]}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{
left:n,top:o,cell:s,rows:a,columns:i}=e,[l,d]=[n+i*s+me,o-me],c={class:"side"};return[M("rect",{...c,x:l,y:o,width:kt,height:a*s}),M("rect",{...c,x:n,y:d-Oe,width:i*
s,height:Oe}),...Ls(r.pursuers,(u,m)=>Ps(e,u,m),"of-pursuers"),...Ls(r.evaders,(u,m)=>Os(e,u,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"\
start"},"0"),M("text",{class:"tick",x:l+kt,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),M("text",{class:"ti\
ck",x:n-6,y:d-Oe+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+kt,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-ev\
aders",x:n+i*s+me,y:d-Oe+10,"text-anchor":"start"},"escapes")]}#g(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,
d=y=>s+(i-1-y)*a,c=[],u=(y,f)=>M("rect",{class:f,x:o,y:d(y),width:l*a+me+kt,height:a}),m=(y,f)=>M("rect",{class:f,x:o+y*a,y:s-me-Oe,width:a,height:me+Oe+i*a});c.
push(u(r.pursuer,"strip pursuer"),m(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&c.push(u(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&c.push(
m(n.evader,"strip hover")),c.push(...this.#u(e));let h={x:o+r.evader*a,y:d(r.pursuer),width:a,height:a};c.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...c),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=qe(this.#i,n,o);this.#l.
replaceChildren(p("span",{class:"pursuer"},Pe(G("pursuer",n)))," against ",p("span",{class:"evader"},G("evader",o))),this.#p.textContent=s?L(s.rate,3):"-",this.#c.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"no episodes were played",this.#m.textContent=this.#y(n,o)}#y(e,r){let n=this.#i.findings?.generalization;
if(!n)return"";let o=(s,a)=>as(s.mean[a]??null,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#b(e){
let r=this.#d;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/
r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,
evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#b(e);if(r){if(r.inside&&_s(this.#d.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?
{}:{evader:r.h}}),r.inside&&this.#x()}}#S(e,r){let n=$s(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(o),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function zl({left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"axes"}),a=e+n*r,i=l=>Et(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(M("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Dl({
left:t,top:e,cell:r,rows:n,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;for(let c of["H","V"]){let u=`M${t} ${i}`;for(let m=1;m<=
a;m++){let[h,y]=[`H${t+m*r}`,`V${i-m*r}`];u+=c==="H"?h+y:y+h}s.append(M("path",{d:u,class:"under"}),M("path",{d:u}))}let[l,d]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[
s,M("text",{class:"on-cells",transform:`translate(${l} ${d}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var Ps=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[
t+o*r+me+s*kt,e+(n-a-.5)*r],Os=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-me-n*Oe];function Ls(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(M("path",{class:`line ${r}`,
d:`M${n(t.mean).join("L")}`})),o}function V(t,e,...r){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...r)}function Is(t,e,r){let{findings:n}=t;if(!n?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Hl(o,t,i,e,
l)},a=n.checkerboards.map(i=>Wl(t,i,s));return{element:V("Checkerboards","Two generations of each team: each generation of the pursuers is better against anothe\
r one of the evaders. Click one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${n.margin}\
 in this way.`),a.length?p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether th\
ere are more than noise makes."):null,o)}}var Ns=({pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function Wl(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,
i=Ns(e).map(([l,d])=>{let c=t.payoff.capture_rate[l][d],u=p("span",{class:"cell"},L(c));return u.style.backgroundColor=Qt(c),u.style.color=Xt(c),u});return p("b\
utton",{type:"button",class:"miniature numbers",onclick:()=>r(e)},p("span",{},p("span",{class:"heard"},`Four matches of generations ${n} and ${o} of the pursuer\
s, ${s} and ${a} of the evaders:`)),p("span",{class:"evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},n),i[0],i[1],p("span",{class:"pursuer"},
o),i[2],i[3])}function Hl(t,e,r,n,o){let s=Ns(r).filter(([m,h])=>!Re(e,"pursuer",m)&&!Re(e,"evader",h)),a=s.map(([m,h])=>tt(o,e,{run:n.selected.run,pursuer:m,evader:h,
episode:0,seed:null,map:null})),i=new Ee(Math.max(0,...a.map(m=>m.length)),{speed:Xe,still:le()}),l=a.map((m,h)=>{let[y,f]=s[h],g=p("canvas",{"aria-label":`${G(
"pursuer",y)} against ${G("evader",f)}`}),b=p("span",{class:"numbers"}),S=()=>{t.close(),n.select({pursuer:y,evader:f,map:null})},w=p("figure",{},g,p("figcaptio\
n",{class:"small"},b,p("span",{class:"muted"},`cell ${L(e.payoff.capture_rate[y][f])}`),p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));
return w.style.gridArea=`${r.pursuers.indexOf(y)+2} / ${r.evaders.indexOf(f)+2}`,{element:w,match:m,recording:rr(m),board:new Ae(g,{numbers:!1}),tally:b}}),d=()=>l.
forEach(m=>m.board.show(m.recording,i.time)),c=()=>l.forEach(({recording:m,match:h,tally:y})=>{let f=m.moments[Math.min(i.step,h.length)];y.textContent=`${Array.
from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener("frame",d),i.addEventListener("step",c),t.replaceChildren(p(
"header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},"Close")),p("div",{class:"grid-of-four"},p("span"),...r.
evaders.map(m=>p("h3",{class:"evader"},G("evader",m))),...r.pursuers.map((m,h)=>{let y=p("h3",{class:"pursuer"},G("pursuer",m));return y.style.gridArea=`${h+2} \
/ 1`,y}),...l.map(m=>m.element)),et(i));let u=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&
Te(i,m)&&m.preventDefault()};t.addEventListener("keydown",u),t.addEventListener("close",()=>{t.removeEventListener("keydown",u),i.pause(),l.forEach(m=>m.board.close()),
t.replaceChildren()},{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),d(),c(),le()||i.play()}var pr={pursuer:"evader",evader:"pursuer"};function Bs(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${L(s)}, stripes ${L(a)}${i===null?"":` every ${i} generations`}`;return jl(t,o,l,e)});return{element:V("CIAO: current individuals against ancestr\
al opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier stra\
tegies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...n.map(o=>o.element)),tr("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function jl(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(w,x)=>e==="pursuer"?t.payoff.
capture_rate[w][x]:1-t.payoff.capture_rate[x][w],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),c=d?.createImageData(a,s);for(let w=0;c&&
w<s;w++)for(let x=0;x<=Math.min(w,a-1);x++)c.data.set([...Qe(i(w,x)),255],4*((s-1-w)*a+x));c&&d?.putImageData(c,0,0);let u=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,u),y=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);ce(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${a} / ${s}`;let f=w=>{let x=y.
getBoundingClientRect(),A=Math.floor((w.clientX-x.left)/x.width*a),k=s-1-Math.floor((w.clientY-x.top)/x.height*s);return A>=0&&k<s&&A<=k?[k,A]:null},g=w=>({[e]:w[0],
[pr[e]]:w[1]});y.addEventListener("pointermove",w=>n.point(f(w)?g(f(w)):{})),y.addEventListener("pointerleave",()=>n.point({})),y.addEventListener("click",w=>f(
w)&&n.select(g(f(w))));let b=()=>{let w=n.hover[e]??n.selected[e],x=n.hover[pr[e]]??n.selected[pr[e]];for(let A of[u,m])A.setAttribute("x",String(x)),A.setAttribute(
"y",String(s-1-w)),A.style.display=x<=w?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),y,p("p",{class:"smal\
l muted"},`horizontal: ${pr[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},r)),update:b}}var mr={left:46,right:12,top:10,bottom:42},Fs={x:56,y:34};function Le(t,e,r,n){let[o,s]=[mr.left,mr.top],a=Math.max(o+40,t-mr.right),i=Math.max(s+40,e-mr.bottom),
l=(f,g,b)=>S=>g+(S-f.low)/(f.high-f.low||1)*(b-g),[d,c]=[l(r,o,a),l(n,i,s)],u=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of Et(n.low,n.high,(i-s)/Fs.y,n.whole))h.append(M("line",{x1:o,x2:a,y1:c(f),y2:c(f),class:"grid"}),M("text",{x:o-8,y:c(f),"text-anchor":"\
end","dominant-baseline":"middle"},Us(f)));for(let f of Et(r.low,r.high,(a-o)/Fs.x,r.whole))h.append(M("text",{x:d(f),y:i+16,"text-anchor":"middle"},Us(r.mirrored?
Math.abs(f):f)));return h.append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),M("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(h,u),{root:m,marks:u,left:o,right:a,top:s,bottom:i,x:d,
y:c,at:f=>{let g=f-m.getBoundingClientRect().left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Us=t=>String(Number(t.toPrecision(6))).replace("-","−");function nt(t,e,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(M("path",{d:o,class:`line ${n}`}),
t.marks)}function zs(t,{low:e,high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(M("path",{d:`\
M${[...o(r),...o(e).reverse()].join("L")}Z`,class:`band ${n}`}),t.marks)}function Rt(t,e,r,n=null){let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.
bottom,class:`mark ${r}`})),n!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function Ie(...t){return p("p",{class:"legend small"},...t.
map(([e,r])=>p("span",{class:`key ${r}`},e)))}function Ne(t,e,r,n){let o=p("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),
s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:d}=o;l<50||d<50||(s=e(l,d),o.replaceChildren(s.root),
a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var un=["of-pursuers","of-evaders","of-both"],Gl=2500,Ds="Arrow keys choose generations.",Vl={low:0,high:1,label:"capture rate"};function Ws(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=ql(n,r.window),d=i.at(-1)??1,c=i.length>Gl?"dense":"",u=(y,f)=>{let g=o.flatMap((b,S)=>b===
y&&(s[S]===f||s[S]===2)?[S]:[]);return g.length?[i[g[0]],i[g.at(-1)]]:null},m=Ne(`Capture rate in ${d} epochs of training. ${Ds}`,(y,f)=>{let g=Le(y,f,{low:0,high:d,
label:"epoch",whole:!0},Vl);for(let[b,S]of[["raw",n],[c,l]])for(let[w,x]of un.entries()){let A=S.map((k,E)=>s[E]===w||s[E+1]===w?k:null);A.some(k=>k!==null)&&nt(
g,i,A,`${x} ${b}`)}return g},y=>ee.forEach((f,g)=>{let b=u(e.hover[f]??e.selected[f],g);b&&Rt(y,(b[0]+b[1])/2,un[g])}),y=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(y/a)-1)),g=o[f];s[f]!==1&&e.select({pursuer:Math.min(g,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(g,t.payoff.shape[1]-1)})});ce(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn","both teams learn"][y],un[y]]);return{element:V("Training",`${is(r.
matches)} training matches. Lines: the generations that are selected.`,Ie(...h),m.element),update:m.update}}function Hs(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=ee.flatMap(u=>[n[u].mean,n[u].low??[],n[u].high??[]]).flat().map(u=>u??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),d=Math.max(...t.payoff.shape)-1,c=Ne(`Elo ratings by generation. ${Ds}`,(u,m)=>{let h=Le(u,m,{low:0,high:d,
label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of ee)zs(h,n[y],`of-${y}s`),nt(h,o[y].map((f,g)=>g),o[y],`of-${y}s`);return h},u=>{
for(let m of ee){let h=e.hover[m]??e.selected[m];Rt(u,h,`of-${m}s`,o[m][h]??null)}},(u,m,h)=>{let y=Math.round(u),f=h.clientY-m.root.getBoundingClientRect().top,
g=S=>Math.abs(m.y(o[S][y]??1/0)-f),b=g("pursuer")<=g("evader")?"pursuer":"evader";y>=0&&y<o[b].length&&e.select({[b]:y})});return ce(c.element,e,()=>t.payoff.shape),
{element:V("Ratings",`One number for each generation, which cycles do not fit, with 95 % intervals over episodes. The game itself: ${L(r.offset,0)} points for t\
he pursuers.`,Ie(["pursuers","of-pursuers"],["evaders","of-evaders"]),c.element),update:c.update}}function ql(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.
map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var Kl={present:"●",absent:"○","cannot tell":"?"};function js(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],d)=>{
let c=Yl(e.reasons[d]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Kl[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),c?p("p",{class:"small"},`${c}.`):null,p("p",{class:"small muted numbers"},i)))}),o=V("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("p",{},e.headline),
...e.numbers.map(s=>p("p",{class:"numbers"},`${Pe(s)}.`)),p("ul",{class:"findings"},...n),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add(
"diagnosis"),{element:o}}function Yl(t){let[,e=""]=t.split(/, because (.*)/s);return Pe(e.replace(/\.$/,""))}function Zl(t){let e=t.flatMap((o,s)=>Array.from(o,(a,i)=>a==="#"?`M${i} ${s}h1v1h-1z`:"")),[r,n]=[t.length,t[0].length];return M("svg",{viewBox:`0 0 ${n} ${r}`,
"aria-hidden":"true"},M("rect",{width:n,height:r,class:"free"}),M("path",{d:e.join(""),class:"walls"}))}function Gs(t,e,r){if(!t.maps)return null;let{fitness:n,
count:o,walls:s,scores:a}=t.maps,i=s.length/o,l=v=>n!=="none"&&v>0,d=p("h3"),c=p("div",{class:"maps",role:"group","aria-label":"Maps"}),u=v=>{e.select({map:e.selected.
map===v?null:v}),r()},m=v=>{let[C,R]=[v%o+1,l(Math.floor(v/o))?L(a[v],3):"-"];return p("button",{type:"button","data-map":v,title:"Play the match here; once mor\
e: as in the evaluation","aria-label":`Map ${C}, ${n} ${R}`,onclick:()=>u(v)},Zl(s[v]),p("span",{class:"small numbers"},R))},h=()=>Math.min(i-1,Math.max(e.hover.
pursuer??e.selected.pursuer,e.hover.evader??e.selected.evader)),y=v=>a.slice(v*o,(v+1)*o),f=Array.from({length:i},(v,C)=>C),g=v=>f.map(C=>l(C)?v(y(C)):null),[b,
S]=[g(v=>v[0]),g(v=>v.reduce((C,R)=>C+R)/o)],[w,x]=[Math.min(...S.filter(v=>v!==null)),Math.max(...a)],A=.06*(x-w||1),k=Ne(`Worth of the maps by generation: ${n}\
. Arrow keys choose generations.`,(v,C)=>{let R=Le(v,C,{low:0,high:i-1,label:"generation",whole:!0},{low:w-A,high:x+A,label:n});return nt(R,f,b,"of-both"),nt(R,
f,S,"of-both dashed"),R},v=>Rt(v,h(),"of-both"),v=>{let C=Math.min(i-1,Math.max(0,Math.round(v)));e.select({pursuer:C,evader:C})});ce(k.element,e,()=>t.payoff.shape);
let E=-1,T=V("Maps","Both teams learned on these maps, which evolve with them. Click one: the match is played there.",d,c,...n==="none"?[]:[Ie([`${n}: the best \
map`,"of-both"],["mean of all","of-both dashed"]),k.element]);return T.classList.add("maps-panel"),{element:T,update:()=>{k.update();let v=h();E!==v&&(d.textContent=
`After generation ${v}${v?"":", drawn at random"}`,c.replaceChildren(...y(v).map((C,R)=>m(v*o+R))),E=v);for(let C of c.children)C.ariaPressed=String(Number(C.dataset.
map)===e.selected.map)}}}function Vs({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>p("tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"n\
umbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...n),s=V("Settings",`${e}, s\
eed ${r}; all others are the defaults of matrixworld evolve.`,n.length?p("div",{class:"wide-table"},o):null);return s.classList.add("settings"),{element:s}}var Jl={pursuer:-1,evader:1};function qs(t,e){let r=t.findings?.spinning_top;if(!r)return null;let n=1.05*Math.max(.05,...r.pursuers.high,...r.evaders.high),o=ee.
flatMap(l=>{let{generations:d,strength:c,intransitivity:u,low:m,high:h}=r[`${l}s`],y=Jl[l];return d.map((f,g)=>({team:l,generation:f,y:c[g],x:y*u[g],low:y*m[g],
high:y*h[g]}))}),s=(l,{team:d,x:c,y:u},m,h)=>M("circle",{cx:l.x(c),cy:l.y(u),r:m,class:`${h} of-${d}s`}),a=Ne("Intransitivity of each generation at its strength\
. Arrow keys choose generations.",(l,d)=>{let c=Le(l,d,{low:-n,high:n,label:"intransitivity",mirrored:!0},{low:0,high:1,label:"strength"});c.root.insertBefore(M(
"line",{x1:c.x(0),x2:c.x(0),y1:c.top,y2:c.bottom,class:"axis"}),c.marks);for(let u of o){let m={x1:c.x(u.low),x2:c.x(u.high),y1:c.y(u.y),y2:c.y(u.y)};c.root.insertBefore(
M("line",{...m,class:`line raw of-${u.team}s`}),c.marks),c.root.insertBefore(s(c,u,4.5,"dot"),c.marks)}return c},l=>{let d=o.filter(({team:c,generation:u})=>u===
(e.hover[c]??e.selected[c]));l.marks.append(...d.map(c=>s(l,c,7,"dot")))},(l,d,c)=>{let u=d.root.getBoundingClientRect(),m=({x:f,y:g})=>Math.hypot(d.x(f)-(c.clientX-
u.left),d.y(g)-(c.clientY-u.top)),{team:h,generation:y}=o.reduce((f,g)=>m(g)<m(f)?g:f);e.select({[h]:y})});ce(a.element,e,()=>t.payoff.shape);let i=V("Strength \
and cycles","A dot is a generation: the higher, the stronger; the farther out, the more its results deviate from every order of strength. Lines: 95 % intervals,\
 without episode noise.",Ie(["pursuers, left","of-pursuers"],["evaders, right","of-evaders"]),a.element,p("p",{class:"small numbers"},(t.findings?.game??[]).join(
" · ")));return i.classList.add("spinning-top"),{element:i,update:a.update}}function Ks(t,e,r,n){let o=new Map,s=p("div",{class:"panels"}),a=[],i=()=>a.forEach(d=>d.update?.()),l=()=>{let d=t[e.selected.run];a=o.get(d)??Xl(d,e,r,n),o.set(
d,a),s.replaceChildren(...a.map(c=>c.element)),i()};return e.on("run",l),e.on("match",i),e.on("hover",i),l(),s}function Xl(t,e,r,n){return[js(t),Gs(t,e,n),Ws(t,
e),Is(t,e,r),Hs(t,e),Bs(t,e),qs(t,e),Vs(t)].filter(s=>s!==null)}var gr=za(ia(),1);var fn=125,wc=80,xc=10,la=480,Sc=[1,.8,.6,.4,.2],Mc=5;async function ca(t,e){let r=Math.min(1,xt(t.rows,t.cols)),[n,o]=[Math.round(la*r),Math.round(la*r/xt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[n,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=Je(document.documentElement),l={ctx:a,colors:i,
grid:Zt(t.rows,t.cols,!1,n,o,1)},[d,c]=[Ac(i,a),(0,gr.GIFEncoder)()];for(let u=0;u<fn;u++){let m=Math.min(1,u/(fn-xc))*(t.moments.length-1);Yt(l,t,m,{...Kt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,n,o),a.globalCompositeOperation="source-over",c.writeFrame((0,gr.applyPalette)(
a.getImageData(0,0,n,o).data,d),n,o,{palette:d,delay:wc}),u%Mc===0&&(e(Math.round(100*u/fn)),await new Promise(h=>setTimeout(h)))}return c.finish(),new Blob([c.
bytes()],{type:"image/gif"})}function Ac(t,e){let r=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),n=r(t.
paper);return Object.values(t).map(r).flatMap(o=>Sc.map(s=>o.map((a,i)=>Math.round(n[i]+s*(a-n[i])))))}function ua(t,e){let r=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),n=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"bu\
tton",class:"save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:l,evader:d}=e.selected;s.disabled=!0;let c=await ca(t.recording,m=>n.textContent=`Dr\
awing: ${m} %`),u=URL.createObjectURL(c);p("a",{href:u,download:`pursuers-${l}-evaders-${d}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(u),6e4),n.textContent=
`Saved, ${(c.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{
id:"share-title"},"Share this match"),s,ht()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),ht()&&p("div",{class:"link"},r,
p("button",{type:"button",onclick:()=>Zn(r,n)},"Copy")),n,p("button",{type:"button",onclick:()=>a.close()},"Close"));return a.addEventListener("click",l=>l.target===
a&&a.close()),{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),r.value=location.href,n.textContent="",a.showModal()}},
"Share"),dialog:a}}var da={pursuer:null,evader:null},br=class extends EventTarget{#e;#r=da;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==r[s]),o=e.run!==void 0&&e.run!==r.run;this.#e={...r,...n?{episode:0,seed:null}:{},...o?{map:null}:
{},...e},this.#e.run!==r.run&&this.dispatchEvent(new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...da,...e};r.pursuer===this.#r.pursuer&&
r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var vr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[nn(this.#e)],
this.recording=rn(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,
[Math.max(l,s),d],a)),typeof n=="number"?a[r]=n:l<=r&&r<d&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(nn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var he=(t,e)=>ee[+(e>=t.n_pursuers)];function yn(t,e){let r=new vr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function ot(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var wr=(t,e)=>t.over||ot(t,e).out;function pa(t,e,r){let n=yn(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!wr(n,e.seat);)n.step(e.policies,e.seat,r);return ot(n,e.seat)}function ma(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function ha(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function fa(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function gn(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[Ec(t,a,i,ma(o))],again:()=>gn(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&ha(s,a)})}
function Ec(t,e,r,n){let o=he(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=d=>{let[c,u]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},d),p("td",{class:"track","aria-hidden":"true"},c),u)),({lasted:m,captured:h})=>{c.style.width=`${100*(o?m:h)/s}%`,
u.textContent=String(o?m:h)}};i("You")(ot(e,r.seat));for(let{name:d,policy:c}of n){let u=i(d);setTimeout(()=>u(pa(t,r,c())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ya=["·","↑","→","↓","←","↗","↘","↙","↖"];var Tc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},bn=[8,1,5,4,0,2,7,3,6],Cc=[7,8,9,4,5,6,1,2,3],kc=24,Rc=Math.tan(
Math.PI/8);function ba(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Cc.findIndex(o=>t.code===`Numpad${o}`),n=bn[r]??Tc[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function va(t){let e=bn.map(r=>p("button",{type:"button","aria-label":pe[r],onclick:()=>t(r)},ya[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",bn[o]>4&&!r))}}function ga(t,e,r){let n=Rc*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return vo([0,0],r?[o(t),o(e)]:[t,e],r)}function wa(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[d,c]=[s-i[0],a-i[1]],u=t.cellAt(s,a);Math.hypot(d,c)>=kc?r(ga(c,d,l.diagonal)):u&&r(ga(u[0]-l.cell[0],
u[1]-l.cell[1],l.diagonal))})}function xa(t,e){let r=n=>{let o=e[n]-t[n],s=Ke.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${pe[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Aa="NUMPY\0",Sa=Aa.length+2,Ma=64;function Ea(t){return fo(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,_c(r)])))}function _c({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Sa+s.length+1)/Ma)*Ma-Sa,i=Aa+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,d=new Uint8Array(i.length+l.byteLength);return d.set(Ft(i,!0)),d.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),d}var $c="matrixworld episode 3";function Ta(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],d={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},m=w=>{
for(let x of Object.keys(w))(u[x]??=[]).push(Array.from(h.read(x),Number))},h=t.world(n);h.reset(e.start);let y=[];m(d);for(let w of o)h.step(w),m({...d,...c}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[w,[x,...A]]of Object.entries({...d,...c})){let k=s+
+(w in d);g[w]={dtype:x,shape:[k,...A],data:f[x].from((u[w]??[]).flat())}}let b=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),S=w=>({dtype:"<U",shape:[],data:w});
return Ea({format:S($c),n_pursuers:b(n.n_pursuers),config:S(JSON.stringify(n)),seat:b(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Pc=[0,1,2,4,8],xr=class{element;player=new Ee(0,{speed:4,still:le()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=va(e=>this.act(e));#l=p("select",{},...Pc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#p=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#m=p("label",{class:"play-choice"},this.#c,"Best move");#d=p("p",{class:"small muted play-keys",id:"play-keys"});#i=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=et(this.player);#u=null;#o=null;#g=[];#f=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#r=new Ae(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#A()),this.#p.addEventListener(
"change",()=>this.#x()),this.#c.addEventListener("change",()=>this.#E()),wa(this.#r,()=>{let r=this.#f!==null&&this.#o&&I(this.#o.recording.moments.at(-1),this.#f);
return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#E()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),p("div",{class:"pl\
ay-stage"},this.#t),p("div",{class:"play-side"},this.#i,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),p("label",{class:"\
play-choice"},this.#p,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#h)}get played(){return this.#u&&{...this.#u.
played,moves:this.#g}}get live(){return this.#o}play(e){this.#S(yn(this.#e,e.played),e.played.seat,e.title),[this.#u,this.#g,this.#v]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),wr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#u=null,this.#S(e,r,n),this.#_()}stop(){
this.#A(),this.player.pause(),this.#u=null}act(e){let[r,n]=[this.#u,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#l.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Te(this.player,e);let s=ba(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#A(),this.player.pause(),[this.#o,
this.#f]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#x(){this.#r.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#$()}}#M(e){this.#y=null,this.#b=this.player.ticks=[],this.#m.hidden=this.#c.disabled=!!Bt(e.config),
sr(this.#e,e.config,Ms(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#T(),this.#E())})}#T(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=ar(r,n,e.actions),n.free(),this.player.ticks=ir(this.#b)}get#C(){return this.#c.checked&&this.#u&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#$(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#A(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#u.played,this.#o];n.step(e,r,this.#v),this.#g.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(n.length-this.player.step),wr(n,r)&&this.#R()}#R(){this.#A();let[e,r,n]=[this.#u,this.#o,this.played],o=ht()?e.link(
n):null;this.#i.replaceChildren(p("h3",{id:"play-headline"},Ic(r,n.seat)),...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},"Watch it"),p("button",{type:"button",onclick:()=>this.#P(r,n.seat)},"Save"),
o&&p("button",{type:"button",onclick:({currentTarget:a})=>Bc(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#b.filter(({team:a})=>a===he(
r.config,n.seat));s.length&&this.#i.children[0].after(p("p",{class:"small muted"},Es(s))),this.#i.focus({preventScroll:!0}),this.#i.scrollIntoView({block:"neare\
st"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),le()||this.player.play()}#P(e,r){let n=new Blob([Ta(this.#e,
e,r)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(n),download:`${K(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#E(){let[e,r,
{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let o=lr(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(r)),s=this.#u&&n===0,a=s?[Oc(
e.config,r),this.#u.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Lc(e,n,r)),a.push(...this.#b.filter(l=>l.step===
n).map(Ct));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${Cs(i,r)||"decided in its turn"}; ${Ts(this.#y,i,n)}`),this.#x(),this.#a.textContent=
a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Oc(t,e){let r=t.rules.capture==="SURROUND";return he(t,e)==="evader"?`Run away: you win if ${r?"the pursu\
ers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your team":"move onto their cells"}`}
function Lc({config:t,recording:e},r,n){let o=e.moments[r],a=he(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=I(o,n),l=u=>{let[m,h]=I(o,u);return Math.
max(Math.abs(m-i[0]),Math.abs(h-i[1]))},d=Array.from({length:o.alive.length},(u,m)=>m).filter(u=>he(t,u)===a&&o.alive[u]&&!o.captured[u-t.n_pursuers]&&2*l(u)<t.
fov);if(!d.length)return`No ${a} in view`;let c=d.reduce((u,m)=>l(m)<l(u)?m:u);return`Nearest ${a}: ${xa(i,I(o,c))}`}function Ic(t,e){let[{lasted:r,out:n,captured:o},
{config:s}]=[ot(t,e),t];return he(s,e)==="pursuer"?`Your team captured ${o} of ${Nc(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escape\
d: ${r} steps.`}var Nc=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Bc(t,e){let r=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to thi\
s match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Sr=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",s=>this.view?.key(s)&&s.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,r=""){this.#a=e;let n=ft(r,this.#e,this.#r.selected),o=fa(new URLSearchParams(r.replace(/^#/,"")),
this.#e[n.run].world);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=n<r.
length?n:0,a=(u,m)=>!!r.alive[m*r.n_agents+u],i=Array.from({length:r.n_agents},(u,m)=>(m+r.config.n_pursuers)%r.n_agents),l=o??i.find(u=>a(u,s)),d=a(l,s)?s:0,c=Array.
from({length:d},(u,m)=>r.actions[m*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:d,moves:c})}play(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||ee.some(
b=>Re(o,b,e[b])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:d,map:c}=e,u=he(o.world,r.seat),m=o.teams[u].kept.map(b=>({name:o.teams[u].script??`generati\
on ${b}`,text:"",policy:()=>te(o,u,b)}));this.view||(this.view=new xr(n),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},
"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${K(r.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,y={
pursuer:te(o,"pursuer",a),evader:te(o,"evader",i)},f={config:Dt(o,c),seed:BigInt(d??o.seeds[a][i]),episode:l,policies:y,...r},g={run:s,pursuers:a,evaders:i,episode:l,
...d===null?{}:{seed:d},...c===null?{}:{map:c}};gn(n,this.view,h,f,m,this.#n?g:null)}};var fe=go(),{runs:Z}=fe,[Fc,Uc]=Z[0].payoff.shape,zc=ft(location.hash,Z,{run:0,pursuer:Fc-1,evader:Uc-1,episode:0,seed:null,map:null}),{step:ka,...Dc}=zc,q=new br(
Dc),D=new cr(Z,q,fe.playground),Ra=new dr(Z,q),at=new Sr(Z,q,D),vn=ts(),Wc=location.hash,Ca=Xo(Z,q,D),{button:Hc,dialog:jc}=ua(D,q);D.actions.append(Hc);var st=null,
wn=p("aside",{class:"note small muted"},fe.note),_a=p("span",{class:"told","aria-live":"polite"}),$a=()=>{_a.textContent=Z[q.selected.run].findings?.sentence??""};
q.on("run",$a);$a();var Pa=()=>{D.playSoon(),D.reveal()},Gc="Each cell is a match between two generations: the brighter, the more evaders are captured. Click on\
e to watch it.";document.getElementById("page").replaceWith(Xn(fe.heading,p("span",{},_a,p("span",{class:"small muted"},Gc)),Ca.button,p("button",{type:"button",
class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>vn.showModal()},"?")),...fe.note?[wn]:[],es(Z,q),p("main",{class:"stages"},Ra.element,D.
element),Ks(Z,q,()=>st,Pa),p("footer",{class:"muted small"},`${fe.title} · matrixworld ${fe.version}`),at.dialog,vn,jc,Ca.bar);Object.assign(window,{matrixworldExplorer:{
get match(){return D.match},get step(){return D.player.step},get pace(){return D.player.pace},get playing(){return at.view},play:t=>st&&tt(st,Z[q.selected.run],
{...q.selected,episode:t}),get shape(){return Z[q.selected.run].payoff.shape}}});Ra.element.addEventListener("play",Pa);D.goTo(ka);ka||D.playSoon();Qn(Z,q,D);rs(
Z,q,D,vn,()=>at.open(),()=>ln(D.shown,fe.playground));window.addEventListener("hashchange",({newURL:t})=>st&&at.start(st,new URL(t).hash));if(fe.live!==null){let[
t,e]=[p("progress",{"aria-label":"Progress of the runs"}),p("p",{class:"numbers"})];wn.prepend(p("div",{class:"progress"},t,e)),ns(fe.live,Z,q,()=>D.player.playing||
at.dialog.open,r=>{r?[t.value,e.textContent]=[r.share,r.text]:wn.textContent="The command has ended. This page shows what it had played; explorer.html is beside\
 the runs if they have finished."})}requestAnimationFrame(()=>setTimeout(()=>{Kn().then(t=>{st=t,D.start(t),at.start(t,Wc),document.body.dataset.ready="true"},t=>{
D.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
