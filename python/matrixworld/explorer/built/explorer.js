/* built from web/ by "npm run build"; sources b926ca2dc609714ae0b30d80592b8beb1da0c9fbcac73f6829fe1787957a22af */
"use strict";(()=>{var Us=Object.create;var Gn=Object.defineProperty;var Bs=Object.getOwnPropertyDescriptor;var Ds=Object.getOwnPropertyNames;var Fs=Object.getPrototypeOf,zs=Object.prototype.hasOwnProperty;var Hs=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(n){throw e=0,n}};var Ws=(t,e,n,r)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of Ds(e))!zs.call(t,o)&&o!==n&&Gn(t,o,{get:()=>e[o],enumerable:!(r=Bs(e,o))||r.enumerable});
return t};var Gs=(t,e,n)=>(n=t!=null?Us(Fs(t)):{},Ws(e||!t||!t.__esModule?Gn(n,"default",{value:t,enumerable:!0}):n,t));var ds=Hs($n=>{var ns=Object.defineProperty,Ki=t=>ns(t,"__esModule",{value:!0}),Yi=(t,e)=>{for(var n in e)ns(t,n,{get:e[n],enumerable:!0})};Ki($n);Yi($n,{GIFEncoder:()=>cs,
applyPalette:()=>ol,default:()=>ml,nearestColor:()=>ll,nearestColorIndex:()=>is,nearestColorIndexWithDistance:()=>ls,prequantize:()=>rl,quantize:()=>tl,snapColorsToPalette:()=>il});
var Zi={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function rs(t=256){let e=0,n=new Uint8Array(t);return{get buffer(){return n.buffer},reset(){e=0},bytesView(){return n.subarray(0,e)},bytes(){return n.slice(0,e)},
writeByte(o){r(e+1),n[e]=o,e++},writeBytes(o,s=0,a=o.length){r(e+a);for(let i=0;i<a;i++)n[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){r(e+a),n.set(o.subarray(
s,s+a),e),e+=a}};function r(o){var s=n.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=n;n=new Uint8Array(
o),e>0&&n.set(i.subarray(0,e),0)}}var kn=12,Qo=5003,Xi=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Ji(t,e,n,r,o=rs(512),s=new Uint8Array(
256),a=new Int32Array(Qo),i=new Int32Array(Qo)){let l=a.length,c=Math.max(2,r);s.fill(0),i.fill(0),a.fill(-1);let u=0,d=0,h=c+1,m=h,g=!1,f=m,v=(1<<f)-1,b=1<<h-1,
S=b+1,y=b+2,w=0,A=n[0],k=0;for(let T=l;T<65536;T*=2)++k;k=8-k,o.writeByte(c),L(b);let E=n.length;for(let T=1;T<E;T++)e:{let U=n[T],R=(U<<kn)+A,_=U<<k^A;if(a[_]===
R){A=i[_];break e}let Ne=_===0?1:l-_;for(;a[_]>=0;)if(_-=Ne,_<0&&(_+=l),a[_]===R){A=i[_];break e}L(A),A=U,y<1<<kn?(i[_]=y++,a[_]=R):(a.fill(-1),y=b+2,g=!0,L(b))}
return L(A),L(S),o.writeByte(0),o.bytesView();function L(T){for(u&=Xi[d],d>0?u|=T<<d:u=T,d+=f;d>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),u>>=8,d-=8;if((y>v||g)&&(g?(f=m,v=(1<<f)-1,g=!1):(++f,v=f===kn?1<<f:(1<<f)-1)),T==S){for(;d>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),
w=0),u>>=8,d-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Qi=Ji;function os(t,e,n){return t<<8&63488|e<<2&992|n>>3}function ss(t,e,n,r){return t>>
4|e&240|(n&240)<<4|(r&240)<<8}function as(t,e,n){return t>>4<<8|e&240|n>>4}function Bt(t,e,n){return t<e?e:t>n?n:t}function lt(t){return t*t}function es(t,e,n){
var r=0,o=1e100;let s=t[e],a=s.cnt,i=s.ac,l=s.rc,c=s.gc,u=s.bc;for(var d=s.fw;d!=0;d=t[d].fw){let m=t[d],g=m.cnt,f=a*g/(a+g);if(!(f>=o)){var h=0;n&&(h+=f*lt(m.ac-
i),h>=o)||(h+=f*lt(m.rc-l),!(h>=o)&&(h+=f*lt(m.gc-c),!(h>=o)&&(h+=f*lt(m.bc-u),!(h>=o)&&(o=h,r=d))))}}s.err=o,s.nn=r}function Rn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,
nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function el(t,e){let n=e==="rgb444"?4096:65536,r=new Array(n),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>
24&255,l=a>>16&255,c=a>>8&255,u=a&255,d=ss(u,c,l,i),h=d in r?r[d]:r[d]=Rn();h.rc+=u,h.gc+=c,h.bc+=l,h.ac+=i,h.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],
i=a>>16&255,l=a>>8&255,c=a&255,u=as(c,l,i),d=u in r?r[u]:r[u]=Rn();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,c=a&
255,u=os(c,l,i),d=u in r?r[u]:r[u]=Rn();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}return r}function tl(t,e,n={}){let{format:r="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,
clearAlphaThreshold:a=0,oneBitAlpha:i=!1}=n;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof
Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),c=n.useSqrt!==!1,u=r==="rgba4444",d=el(l,r),h=d.length,
m=h-1,g=new Uint32Array(h+1);for(var f=0,b=0;b<h;++b){let O=d[b];if(O!=null){var v=1/O.cnt;u&&(O.ac*=v),O.rc*=v,O.gc*=v,O.bc*=v,d[f++]=O}}lt(e)/f<.022&&(c=!1);for(var b=0;b<
f-1;++b)d[b].fw=b+1,d[b+1].bk=b,c&&(d[b].cnt=Math.sqrt(d[b].cnt));c&&(d[b].cnt=Math.sqrt(d[b].cnt));var S,y,w;for(b=0;b<f;++b){es(d,b,!1);var A=d[b].err;for(y=++g[0];y>
1&&(w=y>>1,!(d[S=g[w]].err<=A));y=w)g[y]=S;g[y]=b}var k=f-e;for(b=0;b<k;){for(var E;;){var L=g[1];if(E=d[L],E.tm>=E.mtm&&d[E.nn].mtm<=E.tm)break;E.mtm==m?L=g[1]=
g[g[0]--]:(es(d,L,!1),E.tm=b);var A=d[L].err;for(y=1;(w=y+y)<=g[0]&&(w<g[0]&&d[g[w]].err>d[g[w+1]].err&&w++,!(A<=d[S=g[w]].err));y=w)g[y]=S;g[y]=L}var T=d[E.nn],
U=E.cnt,R=T.cnt,v=1/(U+R);u&&(E.ac=v*(U*E.ac+R*T.ac)),E.rc=v*(U*E.rc+R*T.rc),E.gc=v*(U*E.gc+R*T.gc),E.bc=v*(U*E.bc+R*T.bc),E.cnt+=T.cnt,E.mtm=++b,d[T.bk].fw=T.fw,
d[T.fw].bk=T.bk,T.mtm=m}let _=[];var Ne=0;for(b=0;;++Ne){let Ue=Bt(Math.round(d[b].rc),0,255),O=Bt(Math.round(d[b].gc),0,255),K=Bt(Math.round(d[b].bc),0,255),j=255;
u&&(j=Bt(Math.round(d[b].ac),0,255),i&&(j=j<=(typeof i=="number"?i:127)?0:255),o&&j<=a&&(Ue=O=K=s,j=0));let Be=u?[Ue,O,K,j]:[Ue,O,K];if(nl(_,Be)||_.push(Be),(b=
d[b].fw)==0)break}return _}function nl(t,e){for(let n=0;n<t.length;n++){let r=t[n],o=r[0]===e[0]&&r[1]===e[1]&&r[2]===e[2],s=r.length>=4&&e.length>=4?r[3]===e[3]:
!0;if(o&&s)return!0}return!1}function Ft(t,e){var n=0,r;for(r=0;r<t.length;r++){let o=t[r]-e[r];n+=o*o}return n}function Dt(t,e){return e>1?Math.round(t/e)*e:t}
function rl(t,{roundRGB:e=5,roundAlpha:n=10,oneBitAlpha:r=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,
c=a>>8&255,u=a&255;i=Dt(i,n),r&&(i=i<=(typeof r=="number"?r:127)?0:255),u=Dt(u,e),c=Dt(c,e),l=Dt(l,e),o[s]=i<<24|l<<16|c<<8|u<<0}}function ol(t,e,n="rgb565"){if(!t||
!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize\
() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let r=new Uint32Array(t.buffer),o=r.length,
s=n==="rgb444"?4096:65536,a=new Uint8Array(o),i=new Array(s),l=n==="rgba4444";if(n==="rgba4444")for(let c=0;c<o;c++){let u=r[c],d=u>>24&255,h=u>>16&255,m=u>>8&255,
g=u&255,f=ss(g,m,h,d),v=f in i?i[f]:i[f]=sl(g,m,h,d,e);a[c]=v}else{let c=n==="rgb444"?as:os;for(let u=0;u<o;u++){let d=r[u],h=d>>16&255,m=d>>8&255,g=d&255,f=c(g,
m,h),v=f in i?i[f]:i[f]=al(g,m,h,e);a[u]=v}}return a}function sl(t,e,n,r,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],c=l[3],u=fe(c-r);if(u>a)continue;
let d=l[0];if(u+=fe(d-t),u>a)continue;let h=l[1];if(u+=fe(h-e),u>a)continue;let m=l[2];u+=fe(m-n),!(u>a)&&(a=u,s=i)}return s}function al(t,e,n,r){let o=0,s=1e100;
for(let a=0;a<r.length;a++){let i=r[a],l=i[0],c=fe(l-t);if(c>s)continue;let u=i[1];if(c+=fe(u-e),c>s)continue;let d=i[2];c+=fe(d-n),!(c>s)&&(s=c,o=a)}return o}function il(t,e,n=5){
if(!t.length||!e.length)return;let r=t.map(a=>a.slice(0,3)),o=n*n,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>
s?i=i.slice(0,3):i=i.slice();let l=ls(r,i.slice(0,3),Ft),c=l[0],u=l[1];u>0&&u<=o&&(t[c]=i)}}function fe(t){return t*t}function is(t,e,n=Ft){let r=1/0,o=-1;for(let s=0;s<
t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return o}function ls(t,e,n=Ft){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return[
o,r]}function ll(t,e,n=Ft){return t[is(t,e,n)]}function cs(t={}){let{initialCapacity:e=4096,auto:n=!0}=t,r=rs(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),
i=new Int32Array(o),l=!1;return{reset(){r.reset(),l=!1},finish(){r.writeByte(Zi.trailer)},bytes(){return r.bytes()},bytesView(){return r.bytesView()},get buffer(){
return r.buffer},get stream(){return r},writeHeader:c,writeFrame(u,d,h,m={}){let{transparent:g=!1,transparentIndex:f=0,delay:v=0,palette:b=null,repeat:S=0,colorDepth:y=8,
dispose:w=-1}=m,A=!1;if(n?l||(A=!0,c(),l=!0):A=!!m.first,d=Math.max(0,Math.floor(d)),h=Math.max(0,Math.floor(h)),A){if(!b)throw new Error("First frame must incl\
ude a { palette } option");ul(r,d,h,b,y),ts(r,b),S>=0&&dl(r,S)}let k=Math.round(v/10);cl(r,w,k,g,f);let E=!!b&&!A;pl(r,d,h,E?b:null),E&&ts(r,b),hl(r,u,d,h,y,s,a,
i)}};function c(){us(r,"GIF89a")}}function cl(t,e,n,r,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,r=!1);var s,a;r?(s=1,a=2):(s=0,a=0),e>=0&&(a=
e&7),a<<=2,t.writeByte(0|a|0|s),le(t,n),t.writeByte(o||0),t.writeByte(0)}function ul(t,e,n,r,o=8){let i=_n(r.length)-1,l=128|o-1<<4|0|i,c=0,u=0;le(t,e),le(t,n),
t.writeBytes([l,c,u])}function dl(t,e){t.writeByte(33),t.writeByte(255),t.writeByte(11),us(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),le(t,e),t.writeByte(0)}
function ts(t,e){let n=1<<_n(e.length);for(let r=0;r<n;r++){let o=[0,0,0];r<e.length&&(o=e[r]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function pl(t,e,n,r){
if(t.writeByte(44),le(t,0),le(t,0),le(t,e),le(t,n),r){let a=_n(r.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function hl(t,e,n,r,o=8,s,a,i){Qi(n,r,e,o,t,s,
a,i)}function le(t,e){t.writeByte(e&255),t.writeByte(e>>8&255)}function us(t,e){for(var n=0;n<e.length;n++)t.writeByte(e.charCodeAt(n))}function _n(t){return Math.
max(Math.ceil(Math.log2(t)),1)}var ml=cs});var jn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Fe={DISAPPEAR:0,REACH:1,BOUNCE:2},Vn={OCCUPATION:0,SURROUND:1},qn={FAULT:0,INVOLVED:1};var Zt=["obstacle","teammate","adversary"],Xt=["vertex","edge","chain"],Kn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Jt=["p\
ursuer_{number}","evader_{number}"],Yn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ze={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Zn="{event}: {outcome}",Qt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Xn={free:".GS",blocked:"#@OTW"};var ye=1+Kn.length;function He(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function en(t,e){return t<e?He(Jt[0],{number:t}):He(Jt[1],{number:t-e})}function js(t,e){
let[n,r,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[d,h,m]=c.map(b=>u.filter((S,y)=>b>>y&1)),g=u.map(b=>en(b,e)),f=He(Yn[a<0?"obstacle":Xt[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),v=He(Zn,{event:f,outcome:Vs(u.length,h,m,e)});return{kind:Zt[r],form:Xt[o],agents:u,cell:[i,l],at_fault:d,held:h,doomed:m,turn:n,
text:v}}function Vs(t,e,n,r){if(t===2&&e.length===2)return ze["both held"];if(t===2&&n.length===2)return ze["both doomed"];let o=s=>a=>He(ze[s],{agent:en(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||ze.none}function ct(t,e){let n=[];for(let r=0;r<t.length;r+=ye)n.push(js(t.subarray(r+1,r+ye),e));
return n}var Y=class extends Error{name="EngineError"};function $(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new Y(`${t}\
: expected ${e}, got ${r}`)}var ve=class{bytes;constructor(e){this.bytes=e}},er=0,nn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Jn=4,Qn=4,qs=new TextEncoder,
Ks=new TextDecoder;function Ys(t){for(let e=nn.length-1;e>er;--e)if(t instanceof nn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function tn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Zs(t){return qs.encode(`${t}\0`)}var rn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new Y("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(Zs(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof ve,l=i?a.bytes:
a;return[this.text(s),i?er:Ys(l),l.length,this.copy(tn(l))]}),o=this.copy(tn(Int32Array.from(r)));return this.copy(tn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function tr(t,e){let n=t.HEAPU8;return Ks.decode(n.subarray(e,n.indexOf(0,e)))}function ut(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/Jn,r=e[n+1]/Jn,o={};for(let s=r;s<r+e[n]*Qn;s+=Qn){let a=nn[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[tr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function We(t,e){let n=new rn(t);try{let r=e(n);if(r===0)throw new Y(tr(t,t._last_error()));return r}finally{n.free()}}var Xs=2**31-1,Js=2n**64n-1n,Qs=34028234663852886e22;function Q(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Xs)throw $(t,"an integer",e);return Int32Array.
of(e)}function dt(t,e){if(typeof e!="boolean")throw $(t,"true or false",e);return new ve(Uint8Array.of(Number(e)))}function ce(t,e,n){let r=typeof e=="string"&&
Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw $(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function on(t,e){if(typeof e!="number"||
!(Math.abs(e)<=Qs))throw $(t,"a finite number",e);return e}function be(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(r<0n||r>Js)throw $(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function ea(t){return{"rules.interaction":ce("interaction",t.interaction,
jn),"rules.obstacle":ce("obstacle",t.obstacle,Fe),"rules.teammate":ce("teammate",t.teammate,Fe),"rules.evader":ce("evader",t.evader,Fe),"rules.pursuer":ce("purs\
uer",t.pursuer,Fe),"rules.capture":ce("capture",t.capture,Vn),"rules.captured_disappear":dt("captured_disappear",t.captured_disappear)}}function nr(t,e){let n=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw $(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>on(t,r))}function ta(t){let e=(n,r)=>Float32Array.
of(on(n,t[n]),on(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":nr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":nr("evader_collide",t.evader_collide),
"rewards.blame":ce("blame",t.blame,qn),"rewards.capture_repeats":dt("capture_repeats",t.capture_repeats)}}function or(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=Xn;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw $(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw $(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function sr(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw $("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function pt(t){sr(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...ea(t.rules),...ta(t.rewards),rows:Q("rows",t.rows),cols:Q("cols",t.cols),n_pursuers:Q("n_pursuers",t.n_pursuers),n_evaders:Q("n_evaders",t.n_evaders),fov:Q("\
fov",t.fov),diagonal:dt("diagonal",t.diagonal),max_steps:Q("max_steps",t.max_steps),density:Float64Array.of(e),map:or(t.obstacles)}}function rr(t,e){return Int32Array.
from((e??[]).flat(),n=>Q(t,n)[0])}function ar(t,e){return sr(t.obstacles,e),{seed:be("seed",t.seed??0n),episode:be("episode",t.episode??0),pursuers:rr("pursuers",
t.pursuers),evaders:rr("evaders",t.evaders),map:or(t.obstacles)}}function ht(t){return{actions:Int32Array.from(t,e=>Q("actions",e)[0])}}function we(t){if(typeof t==
"string"){if(!Object.hasOwn(Qt,t))throw $("policy",`one of ${Object.keys(Qt).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw $("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>Q("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:dt("sampled",t.sampled),genome:t.genome}}var na=["first_turn","terminated","truncated"];function ir(t){let e={...t};for(let n of na)
e[n]=new ve(t[n]);return e}var mt=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,n,r,o){
this.config=e,this.seed=n,this.episode=r,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=lr(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=ra(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[n,r]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(n*ye,r*ye);return ct(o,this.config.
n_pursuers)}seek(e,n){this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.episode});
for(let o=e.steps;o<n;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw $("s\
tep",`0 to ${this.length}`,e)}};function ra(t,e){let n=new Int32Array(e+2);for(let r=0;r<t.length;r+=ye)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}
function lr(t,e){let n=t["statistics.length"].length,r=s=>{let a=t[`statistics.${s}`],i=a.length/n;return a.slice(e*i,(e+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),
overlap:r("overlap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function cr(t,e,n,r){let o=[pt(n.config),we(n.pursuers),we(n.evaders),
r];return We(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](a,i,l,c)}),ut(t)}function ur(t,e,n,r){let o={seed:be("seed",n),episode:be("episode",r)};return new mt(
e.config,n,r,cr(t,"_play_match",e,o))}function dr(t,e,n,r){if(!Number.isInteger(r)||r<1)throw $("n_episodes","at least 1",r);let o={seed:be("seed",n),n_episodes:Int32Array.
of(r)},s=cr(t,"_play_rollout",e,o);return Array.from({length:r},(a,i)=>lr(s,i))}var pr=new FinalizationRegistry(([t,e])=>t._world_free(e)),Ge=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=We(e,r=>e._world_new(r.arrays(pt(n)))),pr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,pr.unregister(this),this.engine._world_free(this.at))}reset(e={}){let n=ar(e,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(e){let n=ht(e);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(e){let n=ht(e);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw $(
"actions",String(this.n_agents),r.length);let l=[we(e),ht(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(c)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.at,n.
text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return ct(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,n){
let r=we(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,
probabilities:oa(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let n=ir(e);this.call(r=>this.engine._world_restore(
this.at,r.arrays(n)))}call(e){if(this.freed)throw $("world","one that is in use","one that was freed");return We(this.engine,e),ut(this.engine)}};function oa(t){
let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var sn=class{compiled;constructor(e){this.compiled=e}world(e){return new Ge(this.compiled,e)}match(e,n,r,o,s=0){return ur(this.compiled,{config:e,pursuers:n,evaders:r},
o,s)}rollout(e,n,r,o,s){return dr(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},hr;function mr(t=globalThis.matrixworldEngine){return hr??=sa(t),hr}async function sa(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new sn(
await t({wasmBinary:e}))}var aa="http://www.w3.org/2000/svg";function p(t,e={},...n){return fr(document.createElement(t),e,n)}function x(t,e={},...n){return fr(document.createElementNS(
aa,t),e,n)}function fr(t,e,n){for(let[r,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(r.slice(2),o):t.setAttribute(r,o===!0?"":
String(o)));return t.append(...n.filter(ia).map(r=>typeof r=="number"?String(r):r)),t}function ia(t){return t!=null&&t!==!1}var la=matchMedia("(prefers-color-scheme: dark)");function ca(){let t=document.documentElement.dataset.theme;return t?t==="dark":la.matches}function an(){document.
documentElement.dataset.theme=ca()?"light":"dark"}function gr(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:an},"◐")}var ua=2n**64n-1n;function je(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,d)=>{let h=r.get(c)??"";return/^\d{1,9}$/.test(h)&&Number(h)<u?Number(
h):d},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ua?l:null,step:o("step",1/0,0)}}function yr(t,e,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:n.player.step};r=`#${Object.entries(u).
map(([d,h])=>`${d}=${h}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};e.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=je(location.hash,
t,e.selected);e.select(a),n.goTo(s)})}var F=Uint8Array,xe=Uint16Array,da=Int32Array,vr=new F([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),br=new F([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),pa=new F([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),wr=function(t,e){for(var n=new xe(31),r=0;r<31;++r)n[r]=
e+=1<<t[r-1];for(var o=new da(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},xr=wr(vr,2),Sr=xr.b,ha=xr.r;Sr[28]=258,ha[258]=28;
var Ar=wr(br,0),ma=Ar.b,Rc=Ar.r,un=new xe(32768);for(M=0;M<32768;++M)ee=(M&43690)>>1|(M&21845)<<1,ee=(ee&52428)>>2|(ee&13107)<<2,ee=(ee&61680)>>4|(ee&3855)<<4,un[M]=
((ee&65280)>>8|(ee&255)<<8)>>1;var ee,M,Ve=(function(t,e,n){for(var r=t.length,o=0,s=new xe(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new xe(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(n){i=new xe(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],d=a[t[o]-1]++<<u,h=d|(1<<u)-1;d<=h;++d)i[un[d]>>l]=c}else
for(i=new xe(r),o=0;o<r;++o)t[o]&&(i[o]=un[a[t[o]-1]++]>>15-t[o]);return i}),qe=new F(288);for(M=0;M<144;++M)qe[M]=8;var M;for(M=144;M<256;++M)qe[M]=9;var M;for(M=
256;M<280;++M)qe[M]=7;var M;for(M=280;M<288;++M)qe[M]=8;var M,Mr=new F(32);for(M=0;M<32;++M)Mr[M]=5;var M;var fa=Ve(qe,9,1);var ga=Ve(Mr,5,1),ln=function(t){for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},V=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},cn=function(t,e){
var n=e/8|0;return(t[n]|t[n+1]<<8|t[n+2]<<16)>>(e&7)},ya=function(t){return(t+7)/8|0},va=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.
length),new F(t.subarray(e,n))};var ba=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(t,e,n){var r=new Error(e||ba[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,q),!n)throw r;return r},wa=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new F(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new F(o*3));var c=function(zn){var Hn=n.length;if(zn>Hn){var Wn=new F(Math.max(Hn*2,zn));Wn.set(n),n=Wn}},u=e.f||0,d=e.
p||0,h=e.b||0,m=e.l,g=e.d,f=e.m,v=e.n,b=o*8;do{if(!m){u=V(t,d,1);var S=V(t,d+1,3);if(d+=3,S)if(S==1)m=fa,g=ga,f=9,v=5;else if(S==2){var k=V(t,d,31)+257,E=V(t,d+
10,15)+4,L=k+V(t,d+5,31)+1;d+=14;for(var T=new F(L),U=new F(19),R=0;R<E;++R)U[pa[R]]=V(t,d+R*3,7);d+=E*3;for(var _=ln(U),Ne=(1<<_)-1,Ue=Ve(U,_,1),R=0;R<L;){var O=Ue[V(
t,d,Ne)];d+=O&15;var y=O>>4;if(y<16)T[R++]=y;else{var K=0,j=0;for(y==16?(j=3+V(t,d,3),d+=2,K=T[R-1]):y==17?(j=3+V(t,d,7),d+=3):y==18&&(j=11+V(t,d,127),d+=7);j--;)
T[R++]=K}}var Be=T.subarray(0,k),J=T.subarray(k);f=ln(Be),v=ln(J),m=Ve(Be,f,1),g=Ve(J,v,1)}else q(1);else{var y=ya(d)+4,w=t[y-4]|t[y-3]<<8,A=y+w;if(A>o){l&&q(0);
break}i&&c(h+w),n.set(t.subarray(y,A),h),e.b=h+=w,e.p=d=A*8,e.f=u;continue}if(d>b){l&&q(0);break}}i&&c(h+131072);for(var Un=(1<<f)-1,Os=(1<<v)-1,qt=d;;qt=d){var K=m[cn(
t,d)&Un],ge=K>>4;if(d+=K&15,d>b){l&&q(0);break}if(K||q(2),ge<256)n[h++]=ge;else if(ge==256){qt=d,m=null;break}else{var Bn=ge-254;if(ge>264){var R=ge-257,De=vr[R];
Bn=V(t,d,(1<<De)-1)+Sr[R],d+=De}var Kt=g[cn(t,d)&Os],Yt=Kt>>4;Kt||q(3),d+=Kt&15;var J=ma[Yt];if(Yt>3){var De=br[Yt];J+=cn(t,d)&(1<<De)-1,d+=De}if(d>b){l&&q(0);break}
i&&c(h+131072);var Dn=h+Bn;if(h<J){var Fn=s-J,Ns=Math.min(J,Dn);for(Fn+h<0&&q(3);h<Ns;++h)n[h]=r[Fn+h]}for(;h<Dn;++h)n[h]=n[h-J]}}e.l=m,e.p=qt,e.b=h,e.f=u,m&&(u=
1,e.m=f,e.d=g,e.n=v)}while(!u);return h!=n.length&&a?va(n,0,h):n.subarray(0,h)};var xa=new F(0);var Sa=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&q(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Er(t,e){return wa(t.subarray(Sa(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Aa=typeof TextDecoder<"u"&&new TextDecoder,Ma=0;try{Aa.decode(xa,{stream:!0}),Ma=1}catch{}var Se=["pursuer","evader"];function Cr(){return JSON.parse(ft("data"))}function Ke(t,e,n){let[r,o]=[e-t.payoff.first[0],n-t.payoff.first[1]],s=t.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r][o]}}function ue(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.
teams[e];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${e}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return kr(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function te(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=kr(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:c}}var dn=4,Tr=new Map;function kr(t,e){let n=Tr.get(t);if(n)return n;let r=new Float32Array;try{let o=Ta(
pn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||Ea(o)))throw o}return Tr.set(t,r),r}var Ea=t=>t instanceof
Error&&"code"in t;function Ta(t,e){let n=Er(t),r=n.length/dn,o=new Uint8Array(n.length);for(let a=0;a<o.length;a++)o[a]=n[a%dn*r+Math.floor(a/dn)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function pn(t){let e=atob(ft(t)),n=new Uint8Array(e.length);for(let r=0;r<n.
length;r++)n[r]=e.charCodeAt(r);return n}function ft(t){return document.getElementById(t)?.textContent??""}var Ae=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Rr(t,e,n){let[r,o]=[e[0]-t[0],e[1]-t[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),Ae.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var de=(t,e)=>e<t.nPursuers,C=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ca=(t,e)=>t[0]===e[0]&&
t[1]===e[1],hn=({rows:t,cols:e},[n,r])=>n>=0&&r>=0&&n<t&&r<e,mn=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),fn=(t,e)=>mn(t.fault,e),_r=(t,e)=>!fn(
t,e)&&mn(t.involved,e,2);function gt(t,e,n){let r=!Ca(C(t,n),C(e,n)),o=e.involved===void 0||mn(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!r&&o)}function yt(t,e,n){
let[r,o]=C(t,n),[s,a]=Ae[e.actions?.[n]??0];return[r+s,o+a]}function Ye(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var $r=t=>t.moments.flatMap((e,n)=>n&&Ye(t,t.moments[n-1],e).length?[n]:[]);function vt(t,e){return Array.from({length:e.
alive.length},(r,o)=>o).filter(r=>t.alive[r]&&!e.alive[r])}var Pr=[-.31,0,.31],Ir=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Pr.flatMap(t=>Pr.map(e=>[e,t]))}],ka=.3,Ra=.35,_a=.55;function Ze(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=C(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function Lr(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=C(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of Ze(t,e).values()){let o=Ir[Math.min(r.length,Ir.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var Or=t=>t*t*(3-2*t),Me=(t,e,n)=>t+(e-t)*n,Nr=t=>Math.min(1,Math.max(0,t));function Ur(t,e,n,r){let o={
1:2,2:n}[t.interaction]??1;if(o===1)return Or(r);let s=o===n?e:+!de(t,e),a=Math.max(1/o,Ra);return Or(Nr((r-s/(o-1)*(1-a))/a))}function bt(t,e){let n=t.moments.
length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=Lr(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=Lr(t,a);return s.map((l,c)=>{let u=Ur(t,c,s.length,
e-r);return $a(o,a,c,l,i[c],u)})}function vn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[t.moments[o],t.moments[Math.min(o+1,r)]],i=Ur(t,
e,s.alive.length,n-o),[[l,c],[u,d]]=[C(s,e),C(a,e)];return[Me(c,d,i)+.5,Me(l,u,i)+.5]}function $a(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:Me(r.x,o.x,s),y:Me(r.y,
o.y,s),size:a?r.size:Me(r.size,o.size,s),alpha:a?Nr((1-s)/(1-_a)):Me(r.alpha,o.alpha,s)};if(gt(t,e,n)){let[l,c]=C(t,n),[u,d]=yt(t,e,n),h=ka*Math.sin(Math.PI*s);
i.x+=(d-c)*h,i.y+=(u-l)*h}return i}var Br=2*Math.PI;function pe(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,Br)}function wt(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,r*.09)}),t.closePath()}function Dr(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function Fr(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=Br*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function zr(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Hr=4,Pa=1.6,Ia=.95,La=5,Oa=.16,Na=9,Ua=.09,Ba=.2,Wr=.75,z=(t,e)=>t.left+e*t.cell,H=(t,e)=>t.top+e*t.cell;function Ee(t,e,n){return de(e,n)?t.colors.pursuer:
t.colors.evader}function Gr({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=n.paper,t.fillRect(r,o,l,c),s<La)return;
t.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(r+d*s,o,u,c);for(let d=1;d<a;d++)t.fillRect(r,o+d*s,l,u)}function jr({ctx:t,
grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let u=0;u<i*l;u++){if(!r.obstacles[u])continue;let[d,h]=[Math.floor(u/l),
u%l];t.fillRect(o+h*a,s+d*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=n.frame,t.lineWidth=c,t.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function Vr({
ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*r+a/40;for(let d=0;d<l;d+=c)t.fillText(String(d),o+(d+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let d=0;d<i;d+=c)t.fillText(String(d),o-u,s+(d+.5)*a)}function qr({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,n-o),Math.min(t.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(t.rows,r+o)];return[z(t,s),H(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Kr(t,e,n,r){let{ctx:o,grid:s,
colors:a}=t;o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...qr(t,e,n,r)),o.save(),o.clip("evenodd"),o.fillStyle=a.line,o.fillRect(s.left,s.top,
s.cols*s.cell,s.rows*s.cell),o.restore()}function Yr({ctx:t,grid:e,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[z(e,r),H(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=n.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let d=c-i/2<u*1.2,h=c+(d?1:-1)*(i/2+u*.7);t.strokeStyle=
n.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,h),t.fillStyle=n.ink,t.fillText("You",l,h),t.globalAlpha=1}function Zr(t,e,n,r,o){let{ctx:s,grid:a}=t,
i=qr(t,e,r,o),l=Ee(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Xr(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Na,
Math.max(1,a.cell*Oa));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let[u,d]=[e.moments[c-1],e.moments[c]],h=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
Wr+(Ba-Wr)*h;for(let m=0;m<d.alive.length;m++){let g=c===i&&n<i;if(!u.alive[m]||!(l.alive[m]||g))continue;let f=(de(e,m)?-1:1)*Ua,[v,b]=C(u,m),[S,y]=C(d,m);if(v===
S&&b===y)continue;let w=g?o[m].x:y+.5,A=g?o[m].y:S+.5;s.strokeStyle=Ee(t,e,m),s.beginPath(),s.moveTo(z(a,b+.5+f),H(a,v+.5+f)),s.lineTo(z(a,w+f),H(a,A+f)),s.stroke()}}
s.globalAlpha=1}function Jr(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-Hr+1);o<=r;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/Hr,l=Ye(e,s,a);for(let c of vt(s,a))l.includes(c)||Fa(t,C(a,c),i);for(let c of l)Da(t,C(a,c),i)}t.ctx.globalAlpha=1}function Da({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,Fr(t,z(e,o+.5),H(e,r+.5),Math.max(8,e.cell*Pa)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Fa({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,Dr(t,z(e,o+.5),H(e,r+.5),Math.max(7,e.cell*Ia)),t.strokeStyle=
n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Qr({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
z(e,i)+s,H(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function eo({ctx:t,
grid:e,colors:n},r,o,s,a){t.globalAlpha=a,pe(t,z(e,r),H(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var za=.8,Ha=.92,Wa=15,Ga=7,bn=9;function to(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&ja(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of Ze(e,n).values())a.length>
bn&&Va(t,r[a[bn-1]],a.length-bn+1)}function ja(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=de(e,r),[d,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],m=Math.max(4,l.cell*
o.size*(u?Ha:za)),g=Ee(t,e,r),f=!u&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(u?wt:pe)(i,d,h,m),m>Ga*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,m*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(pe(i,d,h,m*.82),i.strokeStyle=g,i.lineWidth=m*.18,i.stroke()),!s||m<Wa*a)return;let v=String(u?r:r-e.nPursuers);
i.font=`700 ${Math.round(m*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
v,d,h+m*(u?.17:.03))}function Va({ctx:t,grid:e,colors:n},r,o){let[s,a]=[e.left+r.x*e.cell,e.top+r.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=n.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=n.ink,t.fillText(`+${o}`,
s,a)}var qa=.46,Ka=.86,Ya=.66,no=.48,Za=.78,Xa=.58;function ro(t,e,n,r){let[o,s]=[e.moments[n-1],e.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)gt(o,s,c)&&Ja(t,e,C(o,c),yt(o,s,c));a.globalAlpha=
1}function Ja({ctx:t,grid:e},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=d=>z(e,r[1]+.5+s*d),l=d=>H(e,r[0]+.5+a*d),c=hn(n,o)?Za:Xa;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(no),l(no)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function oo(t,e,n,r,o,s){let a=Ae[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=hn(e,[r[0]+a[0],r[1]+a[1]])?Ka:
Ya,d=qa*o.size,h=[z(l,o.x+a[1]*d),H(l,o.y+a[0]*d),z(l,o.x+a[1]*u),H(l,o.y+a[0]*u)],m=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
m*2.1],[Ee(t,e,n),m]])i.strokeStyle=g,i.lineWidth=f,zr(i,...h,l.cell*.2),i.stroke()}var xt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function St(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),c=e.moments[l],u=n===l,d=bt(e,n),h=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),Gr(t);for(let f of r.
viewers)d[f]?.alpha&&Zr(t,e,f,...vn(e,f,n));jr(t,e),r.axes&&Vr(t,o),Xr(t,e,n,r.trail,d),Qr(t,c.contested??[],h),Jr(t,e,n),ro(t,e,l,h),d.forEach(({x:f,y:v,size:b},S)=>{
let y=_r(c,S)?.4:0,w=fn(c,S)?1:y;w&&eo(t,f,v,b,w*h)});let m=u?c:e.moments[Math.max(0,l-1)];if(to(t,e,m,d,r.numbers,o),u&&r.plan)for(let[f,v]of d.entries())v.alpha&&
oo(t,e,f,C(c,f),v,r.plan[f]??0);r.you!==null&&(r.fog&&Kr(t,e,...vn(e,r.you,n)),Yr(t,d[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===
null?void 0:d[r.selected];g?.alpha&&so(t,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),so(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function so({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var Xe=(t,e)=>(e+.24)/(t+.24);function At(t,e,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ao(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var Qa={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Te(t){let e=getComputedStyle(t),n=Object.entries(Qa).map(([r,o])=>[r,e.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var W=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,se=class{canvas;#e=null;#r=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#t;#i;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...xt,...n},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}get time(){return this.#r}show(e,n){this.#e=e,this.#r=Math.min(Math.max(0,n),e.moments.
length-1),this.#u(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#a=At(n,r,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:Te(this.canvas)};St(s,this.#e,this.#r,this.#o,o)}cellAt(e,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.
width;return ao(this.#a,(e-r.left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#r)],s=Ze(
this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=bt(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,u-n)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[r.left+
(s+e*i)*o,r.top+(a+n*i)*o]}#u(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Xe(e,n)))}#d(){let e=devicePixelRatio||
1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var ei=12e3;function io(t,e,n){let r=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>d(
c-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>d(c+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>h()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>d(0,!W())},"A guided minute"),[c,u]=[-1,0];function d(v,b){
clearTimeout(u);let S=r()[v];if(g(),!S)return h();c=v,o.replaceChildren(p("span",{class:"muted numbers"},`${v+1} of ${r().length} `),S.text),s.disabled=v===0,a.
textContent=v===r().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:S.pursuer,evader:S.evader}),S.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):S.shows==="checkerboard"?m():(n.reveal(),n.playSoon()),b&&(u=setTimeout(()=>d(v+1,!0),ei))}function h(){clearTimeout(u),c=-1,i.
hidden=!0,l.focus()}function m(){document.querySelector(".miniature")?.click();let v=document.querySelector("dialog.four[open]");v?.append(i),v?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let g=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!r().length,i.hidden||h()};return e.
on("run",f),i.addEventListener("keydown",v=>{v.key==="Escape"&&h()}),i.hidden=!0,f(),{button:l,bar:i}}var ti={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},Je=[.5,1,2,4,8,16,32,64],Ce=0,wn=12,ni=2,ne=class extends EventTarget{#e;#r;#o;#a;#n=0;#t=0;#i=!1;#u=null;#d=0;#c=[];glide=.28;constructor(e,n={}){
super(),this.#e=e,this.#r=n.speed??4,this.#a=n.still??!1,this.#o=n.clock??ti}get step(){return this.#n}get time(){return this.#a?this.#n:this.#t}get arrived(){return this.#t===
this.#n}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#p("state")}get marks(){return this.#c}set marks(e){
this.#c=e,this.#p("state")}get pace(){return this.#r||Math.max(ni,this.#e/wn)}get speed(){return this.#r}set speed(e){this.#r=e,this.#p("state")}changeSpeed(e){
let n=Je.findIndex(r=>r>=this.pace);this.speed=Je[Math.min(Je.length-1,Math.max(0,n+e))]}play(){this.#i||!this.#e||(this.#n===this.#e&&this.jump(0),this.#i=!0,this.#p(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#p("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#n+e));Math.abs(n-this.#t)>1?this.jump(n):this.#l(n),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#l(this.#t),this.#p("fram\
e")}#l(e){e!==this.#n&&(this.#n=e,this.#p("step"),this.#a&&this.#p("frame"))}#s(){this.#u===null&&(this.#d=this.#o.now(),this.#u=this.#o.request(()=>this.#m()))}#m(){
this.#u=null;let e=this.#o.now();this.#h(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#a||this.arrived)&&this.#p("frame"),(this.#i||this.#t!==this.#n)&&(this.#u=
this.#o.request(()=>this.#m()))}#h(e){let n=e;for(;n>0;){if(this.#t===this.#n){if(!this.#i)return;if(this.#n===this.#e)return this.pause();this.#l(this.#n+1)}let r=this.#i?
this.pace:1/this.glide,o=this.#n-this.#t,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#t=s===Math.abs(o)?this.#n:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#p(e){this.dispatchEvent(new Event(e))}};function ae(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var Qe=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ke(t){let e=Math.min(1,Math.max(0,t))*(Qe.length-1),n=Math.min(Qe.length-2,Math.floor(e)),[r,o]=[Qe[n],
Qe[n+1]],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function lo(t){let[e,n,r]=ke(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+
.0722*r>.179?"#000":"#fff"}var co=t=>`rgb(${ke(t).join(" ")})`,uo=()=>`linear-gradient(to right, ${Qe.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Mt(t,e,n){let r=devicePixelRatio||1;t.style.left=`${n.left}px`,t.style.top=`${n.top}px`,t.style.width=`${n.width}px`,t.style.height=`${n.height}px`,t.width=
Math.round(n.width*r),t.height=Math.round(n.height*r);let o=t.getContext("2d"),s=ri(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function ri(t){let[e,n]=t.shape,r=document.createElement("canvas");[r.width,r.height]=[n,e];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*n+c+t.first[1]);s.data.set([...ke(l),255],u)})),o.putImageData(s,0,0),r}var oi=84;function po(t,e){let n=t.map((s,a)=>si(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),r.hidden=t.length<2,r}function si(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=oi/
Math.max(r,o),i=p("canvas",{"aria-hidden":"true"});Mt(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),c=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>xn(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${ai(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:d=>{c.setAttribute("aria-current",String(d));let h=n.hover.pursuer??n.selected.pursuer,m=n.hover.evader??n.selected.evader;
l.hidden=h>=r||m>=o,l.style.left=`${(m+.5)*a}px`,l.style.top=`${(r-h-.5)*a}px`}}}var ai=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function xn(t,e,n){
let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var ii=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function ho(){let t=ii.map(([n,r])=>p("div",{class:"key-row"},p("dt",{},...n.map(o=>p("kbd",{},o))),p("dd",{},r))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",n=>n.target===e&&e.close()),e}function mo(t,e,n,r,o,s){let a=(l,c)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.
inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:an,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let d=i[l.key]??i[l.key.toLowerCase()],h=Number(l.key)-1;if(ae(n.player,l)||d)d?.();else if(t[h])xn(t[h],
h,e);else return;l.preventDefault()})}function fo(t,e,n,r,o){let s=async()=>{let a=await fetch("version").then(i=>i.text(),()=>null);a===null?o():a==="end"||a!==t&&!r()?(li(e,n),location.reload()):setTimeout(
()=>{s()},1e3)};s()}function li(t,e){let{run:n,pursuer:r,evader:o}=e.selected,[s,a]=t[n].payoff.shape;r===s-1&&o===a-1&&history.replaceState(null,"",`#run=${n}`)}var ui={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Et(t,e,n){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:ui[t.rules.interaction],
obstacles:e,moments:n}}function Tt(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function Ct(t){let e=Array.from({length:t.length+1},
(n,r)=>di(t,r));return Et(t.config,t.map,e)}function di(t,e){let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*n),alive:o(t.alive,e,n),captured:o(t.captured,e,r),everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,
e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var pi=Array.from({length:16},(t,e)=>{let[n,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function go(){let t=[["pursu\
er",x("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",x("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",x("polygon",{points:pi,class:"\
filled-capture"})],["captured evader",x("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",x("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},x("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var hi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function yo(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let n=document.createElementNS("http://www.w3.org/2000/svg","path");return n.setAttribute("d",hi[t]),e.append(n),e}function et(t,e,n,r){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(yo(t)),o.ariaLabel=e,o.title=`${e} (${n})`,o.addEventListener(
"click",r),o}function Re(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let n=et("play","Play","Space",()=>t.toggle()),
r=mi(t),o=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=fi(t),a=document.createElement("output");a.className="player-count",e.append(et("f\
irst","First step","Home",()=>t.move(-t.length)),et("back","Step back","←",()=>t.move(-1)),n,et("forward","Step forward","→",()=>t.move(1)),et("last","Last \
step","End",()=>t.move(t.length)),p("div",{class:"scrub"},o,r),a,s);let i=()=>o.replaceChildren(...t.marks.map(c=>{let u=p("i");return u.style.left=`${100*c/Math.
max(1,t.length)}%`,u})),l=()=>{n.replaceChildren(yo(t.playing?"pause":"play")),n.ariaLabel=t.playing?"Pause":"Play",n.title=`${n.ariaLabel} (Space)`,r.max=String(
t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==r)&&ae(t,c)&&c.preventDefault()}),l(),e}function mi(t){let e=document.createElement("inp\
ut");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function fi(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title="Steps a second (+ and -)",e.append(new Option(
`all in ${wn} s`,String(Ce)),...Je.map(n=>new Option(`${n} / s`,String(n)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var P=(t,e=2)=>t==null?"-":t.toFixed(e),Sn=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function kt(t,e,n,r=2){return e===null||n===null?t.toFixed(r):`${t.toFixed(
r)} (${e.toFixed(r)} to ${n.toFixed(r)})`}var vo=t=>t.toLocaleString("en-GB");function tt(t,e,n,r=!1){let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,u)=>(i+u)*a)}function ie(t,e,{pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,te(e,"pursuer",n),te(e,"evader",r),BigInt(s??a),o)}var bo=40,nt=new Map,rt=({run:t,pursuer:e,evader:n},r)=>`${t} ${e} ${n} ${r}`,Rt=class{element;#e;#r;#o=p("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=p("p",{class:"check small numbers","aria-live":"polite"});#n=0;constructor(e,n){[this.#e,this.#r]=[e,n],this.element=p("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(e,n,r){let{selected:o}=this.#e;o.seed===null&&nt.set(rt(o,o.episode),wo(r)),this.#i(n),yi(this.#n),this.#t(e,n)}#t(e,n){
let{selected:r}=this.#e,s=Ke(n,r.pursuer,r.evader)?.rates.findIndex((a,i)=>!nt.has(rt(r,i)))??-1;s<0||s>=bo||(this.#n=gi(()=>{this.#e.selected===r&&(this.#r.playing||
(nt.set(rt(r,s),wo(ie(e,n,{...r,episode:s,seed:null}))),this.#i(n)),this.#t(e,n))}))}#i(e){let{selected:n}=this.#e,r=Ke(e,n.pursuer,n.evader);if(!r){this.#o.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(bo,r.rates.length);this.#o.replaceChildren(...r.rates.slice(0,o).map(
(c,u)=>this.#u(c,u)));let s=r.rates.slice(0,o).map((c,u)=>nt.get(rt(n,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-r.rates[u])>1e-6||c.
length!==r.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===r.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<r.rates.length?`Played here: ${a.length} of ${r.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${P(l,3)}. The cell says ${P(r.rate,3)}.`}#u(e,n){let{selected:r}=this.#e,o=p("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${P(e)}`,"aria-label":`\
Episode ${n+1}, capture rate ${P(e)}`,"aria-pressed":String(n===r.episode&&r.seed===null),"data-played":nt.has(rt(r,n)),onclick:()=>this.#e.select({episode:n,seed:null})},
o,p("span",{class:"count"},n+1))}},wo=t=>({rate:t.statistics.capture_rate,length:t.length}),gi=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),yi=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var re=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,_e=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var xo=0,So=1,vi=2,bi=176;function Mo(t,e,n,r){let o=devicePixelRatio||1,s=Te(t);t.width=t.height=bi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;n&&u<i*i;u++){let[d,h]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],m=f=>!!n[f*i*i+u];m(vi)&&(a.fillStyle=
s.obstacle,a.fillRect(d-l/2,h-l/2,l,l));let g=m(xo)&&m(So)?l*.18:0;m(xo)&&Ao(a,pe,d+g,h+g,l*.74,s.evader),m(So)&&Ao(a,wt,d-g,h-g,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Ao(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var _t=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#o=p("h3");#a=p("p",{class:"small muted"});#n=p("div",{class:"answers"});#t=null;#i=null;#u=null;#d=null;#c=null;#l=0;constructor(e){
this.#e=e,this.element=p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),p("div",{class:"inspected"},this.#r,p("div",{class:"answer"},this.#o,this.#a),this.#n))}get agent(){return this.#c}show(e,n,r,o){(this.#i!==n||
!this.#t)&&(this.#t?.free(),this.#t=e.world(n.world),this.#c!==null&&this.#i!==n&&this.choose(null)),[this.#i,this.#u,this.#d]=[n,r,o]}choose(e){this.#c=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let n=this.#u;if(!n)return;let r=this.#c??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+e+n.n_agents)%n.n_agents,n.alive[this.#l*n.n_agents+r])return this.choose(r)}at(e){this.#l=e;let[n,r,o,s,a]=[this.#u,this.#t,this.#i,this.#d,this.#c];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(p("span",{class:i},re(a,n.config.n_pursuers)));let l=!!n.alive[e*
n.n_agents+a];n.seek(r,e),Mo(this.#r,n.config,l?r.view(a):null,a),this.#r.ariaLabel=`Field of view of ${re(a,n.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<n.length?n.actions[e*n.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let u=te(o,i,s[i]);if(typeof u=="string")return this.#s([],
`The script "${u}" plays for it${c===null?"":`; it goes ${_e[c]}`}.`);let{probabilities:d}=r.answer(u,a),h=Array.from(d,(g,f)=>wi(_e[f],g,f===c)),m=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#s(h,c===null?"The episode is over.":m)}#s(e,n){this.#n.replaceChildren(
...e),this.#a.textContent=n}};function wi(t,e,n){let r=p("span",{class:"filled"});return r.style.width=`${100*e}%`,p("div",{class:n?"action taken":"action"},p("\
span",{},t),p("span",{class:"track"},r),p("span",{class:"numbers"},e.toFixed(2)))}var xi=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Eo(t,e){return Object.keys(e).find(n=>xi(e[n],t))??null}var ot="_",Xu=2n**64n-1n;var An={fov:11,maxSteps:500,rewards:"paper"},Ai=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Mn(t,e){let n=i=>i.map(l=>Ei(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Mi(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Co(
t.rules,e),others:t.others?Co(t.others,e):"",rewards:o===An.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===An.fov?"":String(t.fov),
limit:t.maxSteps===An.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(ot),pursuers:t.pursuers.map(To).join(ot),
evaders:t.evaders.map(To).join(ot),played:t.played.map(n).join(ot),next:t.next.every(i=>i===0)?"":n(t.next)};return Ai.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function To({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Co(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Eo(t,e.variants)??n.join(".")}function Mi(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(ot)}function Ei(t,e){if(typeof t=="number")return String(t);let n=e.scripts.findIndex(({name:r})=>r===t);return String.
fromCharCode(97+n)}var Ti="/* the engine */";function Po(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>En(t(),e)},"What if? Playground")}function En(t,e){let r=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.
match.config.cols)<=64?Mn(Ci(t.match,t.step),e):"",o=new TextDecoder().decode(pn("playground")).replace(Ti,()=>ft("script-engine"));window.open(`${URL.createObjectURL(
new Blob([o],{type:"text/html"}))}#${r}`)}function Ci(t,e){let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,c=o*n.n_evaders+i-n.n_pursuers,u=d=>i>=
n.n_pursuers&&!!d[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),everCaptured:u(t.ever_captured)}},a=Array.
from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,fov:n.fov,maxSteps:n.max_steps,seed:t.
seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,n.n_pursuers),evaders:a.slice(n.
n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}function $t(t,e,n){if(n===0)return[{kind:"start",text:ki(t),agents:[]}];let[r,o]=[e.moments[n-1],e.moments[n]],s=u=>re(u,t.config.n_pursuers),a=Ye(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of vt(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:d,agents:h})=>({kind:u,text:d,agents:h}))),n===t.length&&c.unshift({kind:"\
end",text:Ri(t),agents:[]}),c}function ki({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Ri(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var _i=60,Pt=class{element;player=new ne(0,{speed:Ce,still:W()});inspector;actions;#e;#r;#o;#a;#n=p("h2",{class:"match-title"});#t=p("p",{class:"tally numbers"});#i=p(
"ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#u=p("p",{class:"problem",role:"alert"});#d=null;#c=null;#l=null;#s=0;#m=!1;#h=0;constructor(e,n,r){
[this.#r,this.#o]=[e,n];let o=p("canvas",{"aria-label":"The match"});this.#e=new se(o,{numbers:!1}),this.#a=new Rt(n,this.player),this.inspector=new _t(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"\
to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over a\
n agent"),Po(()=>this.shown,r)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"ma\
tch-head"},this.#n,this.#t),this.#u,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#i,go(),this.actions,this.inspector.element),Re(this.player),this.#a.
element)),this.player.addEventListener("frame",()=>this.#l&&this.#e.show(this.#l,this.player.time)),this.player.addEventListener("step",()=>this.#b()),n.on("mat\
ch",()=>this.#v()),n.on("rest",()=>this.player.pause()),this.#g(),this.#w(0,0)}get#p(){return this.#r[this.#o.selected.run]}get match(){return this.#c}get recording(){
return this.#l}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.#c&&{match:this.#c,step:this.player.step}}start(e){this.#d=e,this.#y()}playSoon(){
this.#m=!0,this.#s||this.#f()}goTo(e){this.#h=e,!this.#s&&this.#c&&this.#y()}#f(){!this.#m||!this.#c||(this.#m=!1,this.player.jump(0),W()||this.player.play())}#v(){
this.#g(),clearTimeout(this.#s),this.#s=setTimeout(()=>this.#y(),_i)}#y(){clearTimeout(this.#s),this.#s=0,this.player.pause(),this.#g();let{selected:e}=this.#o,
n=Se.map(r=>ue(this.#p,r,e[r])).find(Boolean)??"";this.#u.textContent=n,!(n||!this.#d)&&(this.#c=ie(this.#d,this.#p,e),this.#l=Ct(this.#c),this.#a.show(this.#d,
this.#p,this.#c),this.inspector.show(this.#d,this.#p,this.#c,e),this.player.length=this.#c.length,this.player.marks=$r(this.#l),this.player.jump(this.#h),this.#h=
0,this.#b(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#f())}names({run:e,pursuer:n,evader:r}){let{teams:o}=this.#r[e];
return[o.pursuer.script??`pursuers ${n}`,o.evader.script??`evaders ${r}`]}#g(){let{episode:e,seed:n}=this.#o.selected,{payoff:r}=this.#p,[o,s]=this.names(this.#o.
selected),a=n===null?e<r.episodes?`episode ${e+1} of ${r.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${n}`;this.#n.replaceChildren(p("span",{class:"\
pursuer"},o)," against ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#b(){let e=this.#c;if(!e||!this.#l)return;let n=this.player.step,r=this.#l.
moments[n];this.#w(Array.from(r.everCaptured).filter(Boolean).length,n),this.#i.replaceChildren(...$t(e,this.#l,n).map(o=>p("li",{class:o.kind,"data-agents":o.agents.
join(" ")},o.text))),this.inspector.at(n),this.#S()}#w(e,n){this.#t.replaceChildren(p("strong",{},e),` of ${this.#p.world.n_evaders} captured`,p("span",{class:"\
muted"},` · step ${n}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#S()}#S(){let e=this.inspector.agent;for(let n of this.#i.children){let r=n.
dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}};var $i={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Pi=5;function he(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=$i[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,c]=n(),u=o.shiftKey?Pi:1,{pursuer:d,evader:h}=e.selected;e.
select({pursuer:Io(d+u*a,l),evader:Io(h+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var Io=(t,e)=>Math.min(e-1,Math.max(0,t));var G={left:52,bottom:46,top:76,right:84},Z=10,Ii=160,st=G.right-Z-14,me=G.top-Z-14,It=class{element;#e;#r;#o=p("canvas",{"aria-hidden":"true"});#a=x("svg",{"ar\
ia-hidden":"true"});#n=x("g");#t;#i=p("h2");#u=p("strong",{class:"rate numbers"});#d=p("span",{class:"small muted"});#c=p("p",{class:"of-both-teams small muted \
numbers"});#l=null;constructor(e,n){[this.#r,this.#e]=[e,n],this.#t=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, \
Enter plays it."},this.#o,this.#a);let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#i,this.#c),p("div",{class:"of-cell"},this.#u,this.#d));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#t,Li()),this.#v(),new ResizeObserver(()=>this.#m()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#b(o)),this.#t.addEventListener("pointerleave",()=>n.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),he(this.#t,n,()=>this.#s.payoff.shape),this.#t.
addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),n.on("run",()=>this.#m()),n.on("match",()=>this.#f()),n.on("hover",()=>this.#f())}get#s(){return this.#r[this.#e.
selected.run]}#m(){let[e,n]=this.#s.payoff.shape,{clientWidth:r,clientHeight:o}=this.#t;if(r<50)return;let a=Math.max(Ii,Math.min(r-G.left-G.right,o-G.top-G.bottom))/
Math.max(e,n),i=Math.max(G.left,(r-n*a-G.right+G.left)/2),l=G.top+Math.max(0,(o-G.top-G.bottom-e*a)/2),c={width:r,height:o,left:i,top:l,cell:a,rows:e,columns:n};
this.#l=c,Mt(this.#o,this.#s.payoff,{left:i,top:l,width:n*a,height:e*a}),this.#a.setAttribute("viewBox",`0 0 ${r} ${o}`),this.#a.replaceChildren(Oi(c),...Ni(c),
...this.#p(c),this.#n),this.#f()}#h(e){let n=this.#s.findings?.generalization;if(!n)return[];let{selected:r,hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??
r.evader],[i,l]=Lo(e,n.pursuers.mean[s]??0,s),[c,u]=Oo(e,n.evaders.mean[a]??0,a);return[x("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),x("circle",{class:"d\
ot of-evaders",cx:c,cy:u,r:5})]}#p(e){let n=this.#s.findings?.generalization;if(!n)return[];let{left:r,top:o,cell:s,rows:a,columns:i}=e,[l,c]=[r+i*s+Z,o-Z],u={class:"\
side"};return[x("rect",{...u,x:l,y:o,width:st,height:a*s}),x("rect",{...u,x:r,y:c-me,width:i*s,height:me}),...No(n.pursuers,(d,h)=>Lo(e,d,h),"of-pursuers"),...No(
n.evaders,(d,h)=>Oo(e,d,h),"of-evaders"),x("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),x("text",{class:"tick",x:l+st,y:o+a*s+16,"text-anchor":"\
end"},"1"),x("text",{class:"tick",x:r-6,y:c-4,"text-anchor":"end"},"0"),x("text",{class:"tick",x:r-6,y:c-me+8,"text-anchor":"end"},"1"),x("text",{class:"label o\
f-pursuers",x:l+st,y:o+a*s+34,"text-anchor":"end"},"captures"),x("text",{class:"label of-evaders",x:r+i*s+Z,y:c-me+10,"text-anchor":"start"},"escapes")]}#f(){let e=this.#l;
if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+(i-1-g)*a,u=[],d=(g,f)=>x("rect",{class:f,x:o,y:c(g),width:l*a+Z+st,
height:a}),h=(g,f)=>x("rect",{class:f,x:o+g*a,y:s-Z-me,width:a,height:Z+me+i*a});if(u.push(d(n.pursuer,"strip pursuer"),h(n.evader,"strip evader")),r.pursuer!==
null&&r.pursuer<i&&u.push(d(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(h(r.evader,"strip hover")),r.lag!==null)for(let g=0;g<l;g++){let f=g+r.
lag;f>=0&&f<i&&u.push(x("rect",{class:"lagged",x:o+g*a,y:c(f),width:a,height:a}))}u.push(...this.#h(e));let m={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};u.
push(x("rect",{class:"chosen under",...m}),x("rect",{class:"chosen",...m})),this.#n.replaceChildren(...u),this.#v()}#v(){let{selected:e,hover:n}=this.#e,r=n.pursuer??
e.pursuer,o=n.evader??e.evader,s=Ke(this.#s,r,o);this.#i.replaceChildren(p("span",{class:"pursuer"},`Pursuers ${r}`)," against ",p("span",{class:"evader"},`evad\
ers ${o}`)),this.#u.textContent=s?P(s.rate,3):"-",this.#d.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#c.
textContent=this.#y(r,o)}#y(e,n){let r=this.#s.findings?.generalization;if(!r)return"";let o=(s,a)=>kt(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`A\
gainst all: captures ${o(r.pursuers,e)}, escapes ${o(r.evaders,n)}`}#g(e){let n=this.#l;if(!n)return null;let r=this.#t.getBoundingClientRect(),o=Math.floor((e.
clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-r.top-n.top)/n.cell),[a,i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&
i}:null}#b(e){let n=this.#g(e);this.#e.point(n?{pursuer:n.g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#w(e){let n=this.#g(e);n&&(this.#e.select({...n.g<0?{}:{pursuer:n.
g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#x())}#x(){this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Li(){let t=p("span",{class:"gradi\
ent"});return t.style.backgroundImage=uo(),p("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}function Oi({left:t,top:e,cell:n,rows:r,columns:o}){
let s=x("g",{class:"axes"}),a=e+r*n,i=l=>tt(0,l-1,Math.min(l,l*n/44),!0);for(let l of i(o))s.append(x("text",{class:"tick",x:t+(l+.5)*n,y:a+16,"text-anchor":"mi\
ddle"},l));for(let l of i(r))s.append(x("text",{class:"tick",x:t-7,y:a-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(x("text",{
class:"label of-evaders",x:t+o*n/2,y:a+36,"text-anchor":"middle"},"evader generation"),x("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/
2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Ni({left:t,top:e,cell:n,rows:r,columns:o}){let s=x("g",{class:"diagonal"}),a=Math.min(
r,o);if(a<3)return[];let i=e+r*n;for(let u of["H","V"]){let d=`M${t} ${i}`;for(let h=1;h<=a;h++){let[m,g]=[`H${t+h*n}`,`V${i-h*n}`];d+=u==="H"?m+g:g+m}s.append(
x("path",{d,class:"under"}),x("path",{d}))}let[l,c]=[t+a/2*n-.7*n-4,i-a/2*n-.7*n-4];return[s,x("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-\
45)`,"text-anchor":"middle"},"same generation")]}var Lo=({left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+Z+s*st,e+(r-a-.5)*n],Oo=({left:t,top:e,cell:n},r,o)=>[
t+(o+.5)*n,e-Z-r*me];function No(t,e,n){let r=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(x("path",{class:`band ${n}`,
d:`M${[...r(t.high),...r(t.low).reverse()].join("L")}Z`})),o.push(x("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function N(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}function Uo(t,e,n){let{findings:r}=t;if(!r?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&Bi(o,t,i,e,
l)},a=r.checkerboards.map(i=>Ui(t,i,s));return{element:N("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Cli\
ck one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?
p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise m\
akes."):null,o)}}var Bo=({pursuers:[t,e],evaders:[n,r]})=>[[t,n],[t,r],[e,n],[e,r]];function Ui(t,e,n){let[r,o]=e.pursuers,[s,a]=e.evaders,i=Bo(e).map(([l,c])=>{
let u=t.payoff.capture_rate[l][c],d=p("span",{class:"cell"},P(u));return d.style.backgroundColor=co(u),d.style.color=lo(u),d});return p("button",{type:"button",
class:"miniature numbers",onclick:()=>n(e)},p("span",{},p("span",{class:"heard"},`Four matches of pursuers ${r} and ${o}, evaders ${s} and ${a}:`)),p("span",{class:"\
evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},r),i[0],i[1],p("span",{class:"pursuer"},o),i[2],i[3])}function Bi(t,e,n,r,o){let s=Bo(n).filter(
([h,m])=>!ue(e,"pursuer",h)&&!ue(e,"evader",m)),a=s.map(([h,m])=>ie(o,e,{run:r.selected.run,pursuer:h,evader:m,episode:0,seed:null})),i=new ne(Math.max(0,...a.map(
h=>h.length)),{speed:Ce,still:W()}),l=a.map((h,m)=>{let[g,f]=s[m],v=p("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),b=p("span",{class:"numbers"}),
S=()=>{t.close(),r.select({pursuer:g,evader:f})},y=p("figure",{},v,p("figcaption",{class:"small"},b,p("span",{class:"muted"},`cell ${P(e.payoff.capture_rate[g][f])}`),
p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));return y.style.gridArea=`${n.pursuers.indexOf(g)+2} / ${n.evaders.indexOf(f)+2}`,{element:y,
match:h,recording:Ct(h),board:new se(v,{numbers:!1}),tally:b}}),c=()=>l.forEach(h=>h.board.show(h.recording,i.time)),u=()=>l.forEach(({recording:h,match:m,tally:g})=>{
let f=h.moments[Math.min(i.step,m.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${m.config.n_evaders} captured`});i.addEventListener(
"frame",c),i.addEventListener("step",u),t.replaceChildren(p("header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},
"Close")),p("div",{class:"grid-of-four"},p("span"),...n.evaders.map(h=>p("h3",{class:"evader"},`evaders ${h}`)),...n.pursuers.map((h,m)=>{let g=p("h3",{class:"p\
ursuer"},`pursuers ${h}`);return g.style.gridArea=`${m+2} / 1`,g}),...l.map(h=>h.element)),Re(i));let d=h=>{!(h.target instanceof HTMLSelectElement||h.target instanceof
HTMLButtonElement&&h.key===" ")&&!h.defaultPrevented&&ae(i,h)&&h.preventDefault()};t.addEventListener("keydown",d),t.addEventListener("close",()=>{t.removeEventListener(
"keydown",d),i.pause(),l.forEach(h=>h.board.close()),t.replaceChildren()},{once:!0}),r.dispatchEvent(new Event("rest")),t.showModal(),c(),u(),W()||i.play()}var Lt={pursuer:"evader",evader:"pursuer"};function Do(t,e){let n=t.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${P(s)}, stripes ${P(a)}${i===null?"":` every ${i} generations`}`;return Di(t,o,l,e)});return{element:N("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element))),update:()=>r.forEach(
o=>o.update())}}function Di(t,e,n,r){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(y,w)=>e==="pursuer"?t.payoff.capture_rate[y][w]:1-
t.payoff.capture_rate[w][y],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let y=0;u&&y<s;y++)for(let w=0;w<=
Math.min(y,a-1);w++)u.data.set([...ke(i(y,w)),255],4*((s-1-y)*a+w));u&&c?.putImageData(u,0,0);let d=x("rect",{class:"chosen",width:1,height:1}),h=x("rect",{class:"\
chosen under",width:1,height:1}),m=x("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},h,d),g=p("div",{class:"triangle","aria-labe\
l":`CIAO of the ${e}s: ${n}. Arrow keys choose a match.`},l,m);he(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=y=>{let w=g.getBoundingClientRect(),
A=Math.floor((y.clientX-w.left)/w.width*a),k=s-1-Math.floor((y.clientY-w.top)/w.height*s);return A>=0&&k<s&&A<=k?[k,A]:null},v=y=>({[e]:y[0],[Lt[e]]:y[1]});g.addEventListener(
"pointermove",y=>r.point(f(y)?v(f(y)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",y=>f(y)&&r.select(v(f(y))));let b=()=>{
let y=r.hover[e]??r.selected[e],w=r.hover[Lt[e]]??r.selected[Lt[e]];for(let A of[d,h])A.setAttribute("x",String(w)),A.setAttribute("y",String(s-1-y)),A.style.display=
w<=y?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),g,p("p",{class:"small muted"},`horizontal: ${Lt[e]} gen\
eration; vertical: ${e} generation`),p("p",{class:"small numbers"},n)),update:b}}var Ot={left:46,right:12,top:10,bottom:42},Fo={x:56,y:34};function Nt(t,e,n,r){let[o,s]=[Ot.left,Ot.top],a=Math.max(o+40,t-Ot.right),i=Math.max(s+40,e-Ot.bottom),
l=(f,v,b)=>S=>v+(S-f.low)/(f.high-f.low||1)*(b-v),[c,u]=[l(n,o,a),l(r,i,s)],d=x("g"),h=x("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),m=x("g",
{class:"axes"});for(let f of tt(r.low,r.high,(i-s)/Fo.y,r.whole))m.append(x("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),x("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},zo(f)));for(let f of tt(n.low,n.high,(a-o)/Fo.x,n.whole))m.append(x("text",{x:c(f),y:i+16,"text-anchor":"middle"},zo(f)));return m.
append(x("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),x("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},n.label),x("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),h.append(m,d),{root:h,marks:d,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let v=f-h.getBoundingClientRect().
left;return n.low+(v-o)/(a-o)*(n.high-n.low)}}}var zo=t=>String(Number(t.toPrecision(6))).replace("-","−");function at(t,e,n,r){let o="",s="M";n.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=x("path",{d:o,class:`line ${r}`});return t.root.insertBefore(a,t.marks),a}function it(t,e,n,r=null){let o=t.x(e);t.marks.append(x("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(x("circle",{cx:o,cy:t.
y(r),r:5,class:`dot ${n}`}))}function Tn(...t){return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function Ut(t,e,n={}){let r=p(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&n.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=r;i<50||l<50||
(o=e(i,l),r.replaceChildren(o.root),s())};return r.addEventListener("pointermove",i=>n.point?.(o?.at(i.clientX)??null)),r.addEventListener("pointerleave",()=>n.
point?.(null)),n.choose&&(r.classList.add("chooses"),r.addEventListener("click",i=>o&&n.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(r),{element:r,
redraw:a,remark:s}}var Cn=["of-pursuers","of-evaders","of-both"],Fi=2500,Ho="Arrow keys choose generations.",Wo={low:0,high:1,label:"capture rate"};function Go(t,e){let{training:n}=t,
{capture_rate:r,generation:o,learner:s,epochs:a}=n,i=r.map((g,f)=>(f+1)*a),l=zi(r,n.window),c=i.at(-1)??1,u=i.length>Fi?"dense":"",d=(g,f)=>{let v=o.flatMap((b,S)=>b===
g&&(s[S]===f||s[S]===2)?[S]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},h=Ut(`Capture rate in ${c} epochs of training. ${Ho}`,(g,f)=>{let v=Nt(g,f,{low:0,high:c,
label:"epoch",whole:!0},Wo);for(let[b,S]of[["raw",r],[u,l]])for(let[y,w]of Cn.entries()){let A=S.map((k,E)=>s[E]===y||s[E+1]===y?k:null);A.some(k=>k!==null)&&at(
v,i,A,`${w} ${b}`)}return v},{marks:g=>{let{pursuer:f,evader:v}=e.selected;for(let[b,S]of[[0,f],[1,v]]){let y=d(e.hover[b?"evader":"pursuer"]??S,b);y&&it(g,(y[0]+
y[1])/2,Cn[b])}},choose:g=>{let f=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),v=o[f];s[f]!==1&&e.select({pursuer:Math.min(v,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(v,t.payoff.shape[1]-1)})}});he(h.element,e,()=>t.payoff.shape);let m=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders lear\
n","both teams learn"][g],Cn[g]]);return{element:N("Training",`${vo(n.matches)} training matches. Lines: the generations that are selected.`,Tn(...m),h.element),
update:h.remark}}function jo(t,e){let n=t.findings?.lags;if(!n)return null;let[r,o]=[n.lags[0],n.lags.at(-1)],s=Math.min(5,(Math.max(...n.cells)+1)/2),a=n.means.
map((l,c)=>n.cells[c]>=s?l:null),i=Ut("Lag profile",(l,c)=>{let u=Nt(l,c,{low:r,high:o,label:"lag: pursuer minus evader generation",whole:!0},Wo);return at(u,n.
lags,n.means,"raw ink"),at(u,n.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=e.selected;it(l,0,"zero");let d=e.hover.lag??c-u;it(l,d,"ink",n.means[d-r])},
point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=r&&c<=o?c:null})}});return{element:N("Lag profile","Left: evaders are later. Right: pursue\
rs are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function Vo(t,e){let n=t.findings?.ratings;if(!n)
return null;let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.
max(...t.payoff.shape)-1,c=Ut(`Elo ratings by generation. ${Ho}`,(u,d)=>{let h=Nt(u,d,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo po\
ints"});for(let m of["pursuer","evader"])at(h,r[m].map((g,f)=>f),r[m],`of-${m}s`);return h},{marks:u=>{for(let d of["pursuer","evader"]){let h=e.hover[d]??e.selected[d];
it(u,h,`of-${d}s`,r[d][h]??null)}},choose:(u,d,h)=>{let m=Math.round(u),g=h.clientY-d.root.getBoundingClientRect().top,f=b=>Math.abs(d.y(r[b][m]??1/0)-g),v=f("p\
ursuer")<=f("evader")?"pursuer":"evader";m>=0&&m<r[v].length&&e.select({[v]:m})}});return he(c.element,e,()=>t.payoff.shape),{element:N("Ratings",`One number fo\
r each generation, which cycles do not fit. The game itself: ${P(n.offset,0)} points for the pursuers.`,Tn(["pursuers","of-pursuers"],["evaders","of-evaders"]),
c.element),update:c.remark}}function zi(t,e){let n=[0];for(let r of t)n.push(n.at(-1)+r);return t.map((r,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(
t.length,o+Math.floor(e/2)+1)];return(n[a]-n[s])/(a-s)})}var Hi={present:"●",absent:"○","cannot tell":"?"};function qo(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=new Map(e.reasons.map(
a=>{let[i,,l]=Wi(a);return[i,l]})),o=n.map(([a,i,l,c])=>{let u=c===e.window?r.get(a):void 0;return p("li",{class:`finding ${i.replace(" ","-")}`},p("span",{class:"\
sign","aria-hidden":"true"},Hi[i]??""),p("div",{},p("p",{},p("strong",{},a),` ${i}`,p("span",{class:"muted"},` · ${c}`)),u?p("p",{class:"small"},`${u}.`):null,
p("p",{class:"small muted numbers"},l)))}),s=N("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about thi\
s run.",p("p",{class:"headline"},e.headline),...e.numbers.map(a=>p("p",{class:"numbers"},`${Ko(a)}.`)),p("ul",{class:"findings"},...o),t.limits?p("p",{class:"sm\
all"},t.limits):null,p("details",{class:"small"},p("summary",{},"Headline numbers in words"),...e.description.map(a=>p("p",{},a)),Gi(e)));return s.classList.add(
"diagnosis"),{element:s}}function Wi(t){let[e="",n=""]=t.split(/: (.*)/s),[r="",o=""]=n.split(/, because (.*)/s);return[e.toLowerCase(),r,Ko(o.replace(/\.$/,""))]}
var Ko=t=>t.charAt(0).toUpperCase()+t.slice(1);function Gi({noise:t}){return t.transitive_share_noise===null?null:p("p",{},`Last half: transitive share ${P(t.transitive_share)}\
 (an order of strength with the same noise rarely falls below ${P(t.transitive_share_noise)}), checkerboards ${Sn(t.checkerboard_share)} (it rarely exceeds ${Sn(
t.checkerboard_share_noise)}).`)}function Yo(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(n=>n!=null);return e.length?{element:N("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(ji))}:null}function ji(t){let e=r=>r.at(-1),n=[["mean",e(t.mean)],...Object.
entries(t.against).map(([r,o])=>[r,e(o)])];return p("table",{class:"scores numbers"},p("caption",{},p("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...n.map(([r,o],s)=>p("tr",{class:s?"":"mean"},p("th",{scope:"row"},r),p("td",{class:"range"},Vi(o,t.team)),p("td",{},kt(o.value,o.low,o.high)))))}
function Vi({value:t,low:e,high:n},r){let o=p("span",{class:`between ${r}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((n??t)-(e??t))}%`;let s=p("span",
{class:`value ${r}`});return s.style.left=`${100*t}%`,p("span",{class:"scale","aria-hidden":"true"},o,s)}function Xo(t){let e=t.settings.filter(o=>o.changed),n=t.settings.filter(o=>!o.changed),r=N("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?Zo(e,"other than the default"):p("p",{class:"small"},"All settings are the defaults."),p("details",{class:"small"},p("summary",
{},`${n.length} settings with their defaults`),Zo(n,"defaults")));return r.classList.add("settings"),{element:r}}function Zo(t,e){return p("div",{class:"wide-ta\
ble"},p("table",{class:"small"},p("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:n,value:r,help:o})=>p("tr",{},p("th",{scope:"row"},`--${n.replaceAll(
"_","-")}`),p("td",{class:"numbers"},r),p("td",{class:"muted"},o)))))}function Jo(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??qi(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function qi(t,e,n){return[qo(t),Go(t,e),Uo(t,e,n),jo(
t,e),Vo(t,e),Do(t,e),Yo(t),Xo(t)].filter(o=>o!==null)}var zt=Gs(ds(),1);var Pn=125,fl=80,gl=10,ps=480,yl=[1,.8,.6,.4,.2],vl=5;async function hs(t,e){let n=Math.min(1,Xe(t.rows,t.cols)),[r,o]=[Math.round(ps*n),Math.round(ps*n/Xe(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[r,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=Te(document.documentElement),l={ctx:a,colors:i,
grid:At(t.rows,t.cols,!1,r,o,1)},[c,u]=[bl(i,a),(0,zt.GIFEncoder)()];for(let d=0;d<Pn;d++){let h=Math.min(1,d/(Pn-gl))*(t.moments.length-1);St(l,t,h,{...xt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,r,o),a.globalCompositeOperation="source-over",u.writeFrame((0,zt.applyPalette)(
a.getImageData(0,0,r,o).data,c),r,o,{palette:c,delay:fl}),d%vl===0&&(e(Math.round(100*d/Pn)),await new Promise(m=>setTimeout(m)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function bl(t,e){let n=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),r=n(t.
paper);return Object.values(t).map(n).flatMap(o=>yl.map(s=>o.map((a,i)=>Math.round(r[i]+s*(a-r[i])))))}function ms(t,e){let n=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),r=p("p",{class:"muted small",role:"status"}),o=async()=>{n.select();
try{await navigator.clipboard.writeText(n.value),r.textContent="Copied."}catch{r.textContent="Selected: copy it with Ctrl+C."}},a=p("button",{type:"button",class:"\
save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:c,evader:u}=e.selected;a.disabled=!0;let d=await hs(t.recording,m=>r.textContent=`Drawing: ${m} %`),
h=URL.createObjectURL(d);p("a",{href:h,download:`pursuers-${c}-evaders-${u}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(h),6e4),r.textContent=`Saved, ${(d.
size/1e6).toFixed(1)} MB.`,a.disabled=!1}},"Save the match as a GIF of 10 s"),i=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{id:"share-tit\
le"},"Share this match"),a,p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),p("div",{class:"link"},n,p("button",{type:"button",
onclick:o},"Copy")),r,p("button",{type:"button",onclick:()=>i.close()},"Close"));return i.addEventListener("click",c=>c.target===i&&i.close()),{button:p("button",
{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),n.value=location.href,r.textContent="",i.showModal()}},"Share"),dialog:i}}var fs={pursuer:null,evader:null,lag:null},Ht=class extends EventTarget{#e;#r=fs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...fs,...e};n.pursuer===this.#r.pursuer&&n.evader===this.#r.evader&&n.lag===this.#r.lag||
(this.#r=n,this.dispatchEvent(new Event("hover")))}on(e,n){this.addEventListener(e,n)}};var Wt=class{config;start;recording;actions=[];#e;#r;#o=[[]];constructor(e,n,r){[this.config,this.start]=[n,r],this.#e=e.world(n),this.#e.reset(r),this.#r=[Tt(this.#e)],
this.recording=Et(n,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}play(e){this.#e.step(e),this.#a(e)}step(e,n,r){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,[Math.max(l,s),c],a)),typeof r==
"number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#r.push(Tt(this.#e,e)),this.#o.push(this.#e.conflicts())}};var oe=(t,e)=>Se[+(e>=t.n_pursuers)];function In(t,e){let n=new Wt(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.
seat,r);return n}function $e(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var Gt=(t,e)=>t.over||$e(t,e).out;function gs(t,e,n){let r=In(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!Gt(r,e.seat);)r.step(e.policies,e.seat,n);return $e(r,e.seat)}function ys(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}
function vs(t,{seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function bs(t,e){let[n,r,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function ws(t,e,n,r){let o=oe(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,u]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},l),p("td",{class:"track","aria-hidden":"true"},c),u)),({lasted:d,captured:h})=>{c.style.width=`${100*(o?d:h)/s}%`,
u.textContent=String(o?d:h)}};i("You")($e(e,n.seat));for(let{name:l,policy:c}of r){let u=i(l);setTimeout(()=>u(gs(t,n,c())))}return p("div",{},a,p("p",{class:"s\
mall muted"},"One match: luck has its part in it."))}var xs=()=>["file:","http:","https:"].includes(location.protocol);var Ss=["·","↑","→","↓","←","↗","↘","↙","↖"];var xl={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Ln=[8,1,5,4,0,2,7,3,6],Sl=[7,8,9,4,5,6,1,2,3],Al=24,Ml=Math.
tan(Math.PI/8);function Ms(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=Sl.findIndex(o=>t.code===`Numpad${o}`),r=Ln[n]??xl[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function Es(t){let e=Ln.map(n=>p("button",{type:"button","aria-label":_e[n],onclick:()=>t(n)},Ss[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",Ln[o]>4&&!n))}}function As(t,e,n){let r=Ml*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return Rr([0,0],n?[o(t),o(e)]:[t,e],n)}function Ts(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,e()];if(r=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(c,u)>=Al?n(As(u,c,l.diagonal)):d&&n(As(d[0]-l.cell[0],
d[1]-l.cell[1],l.diagonal))})}function Cs(t,e){let n=r=>{let o=e[r]-t[r],s=Ae.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${_e[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var On=[147,...new TextEncoder().encode("NUMPY"),1,0],El=67324752,Tl=33639248,Cl=101010256,kl=8,ks=2**28,Ie=async t=>new Uint8Array(await new Blob([...t]).arrayBuffer());
async function Rl(t,e){let n=new Blob([t]).stream().pipeThrough(e).getReader(),r=[],o=0;for(let{done:s,value:a}=await n.read();!s;{done:s,value:a}=await n.read()){
if((o+=a.length)>ks)throw new RangeError(`expected at most ${ks} bytes`);r.push(a)}return Ie(r)}function Pe(...t){return Uint8Array.from(t.flatMap(([e,n])=>Array.
from({length:n},(r,o)=>e>>>8*o&255)))}function _l({dtype:t,shape:e,data:n}){let r=typeof n=="string"?Array.from(n,l=>l.codePointAt(0)):null,o=r?`<U${r.length}`:
t,s=e.map(l=>`${l}, `).join(""),a=`{'descr': '${o}', 'fortran_order': False, 'shape': (${s}), }`,i=a.padEnd(Math.ceil((On.length+2+a.length+1)/64)*64-On.length-
3)+`
`;return Ie([Uint8Array.from(On),Pe([i.length,2]),i,r?Int32Array.from(r):n])}var $l=Int32Array.from({length:256},(t,e)=>{let n=e;for(let r=0;r<8;++r)n=n>>>1^(n&
1?3988292384:0);return n});function Pl(t){return~t.reduce((e,n)=>e>>>8^$l[(e^n)&255],-1)}async function Rs(t){let[e,n]=[[],[]],r=0;for(let[i,l]of Object.entries(
t)){let[c,u]=[new TextEncoder().encode(`${i}.npy`),await _l(l)],d=await Rl(u,new CompressionStream("deflate-raw")),h=Pe([20,2],[0,2],[kl,2],[0,2],[33,2],[Pl(u),
4],[d.length,4],[u.length,4],[c.length,2],[0,2]),m=await Ie([Pe([El,4]),h,c,d]);e.push(m),n.push(await Ie([Pe([Tl,4],[20,2]),h,Pe([0,2],[0,2],[0,2],[0,4],[r,4]),
c])),r+=m.length}let o=await Ie(n),s=e.length,a=Pe([Cl,4],[0,2],[0,2],[s,2],[s,2],[o.length,4],[r,4],[0,2]);return Ie([...e,o,a])}var Il="matrixworld episode 3";async function _s(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],c={positions:[
"<i4",i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},
h=y=>{for(let w of Object.keys(y))(d[w]??=[]).push(Array.from(m.read(w),Number))},m=t.world(r);m.reset(e.start);let g=[];h(c);for(let y of o)m.step(y),h({...c,...u}),
g.push(...m.conflictTable());m.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[y,[w,...A]]of Object.entries({...c,...u})){let k=s+
+(y in c);v[y]={dtype:w,shape:[k,...A],data:f[w].from((d[y]??[]).flat())}}let b=y=>({dtype:"<i4",shape:[],data:Int32Array.of(y)}),S=y=>({dtype:"<U",shape:[],data:y});
return Rs({format:S(Il),n_pursuers:b(r.n_pursuers),config:S(JSON.stringify(r)),seat:b(n),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(y=>[
...y]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var Ll=[0,1,2,4,8],jt=class{element;player=new ne(0,{speed:4,still:W()});#e;#r;#o=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=p("h2");#n=p("p",{class:"\
play-told",role:"status"});#t=Es(e=>this.act(e));#i=p("select",{},...Ll.map(e=>p("option",{value:e},e?`${e} steps a second`:"step by step")));#u=p("input",{type:"\
checkbox"});#d=p("section",{class:"play-ending",tabindex:-1,"aria-label":"Result"});#c=Re(this.player);#l=null;#s=null;#m=[];#h=null;#p=0;#f=0;constructor(e){this.#e=
e,this.#r=new se(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#g()),this.#u.addEventListener("cha\
nge",()=>this.#y()),Ts(this.#r,()=>{let n=this.#h!==null&&this.#s&&C(this.#s.recording.moments.at(-1),this.#h);return n?{cell:n,diagonal:this.#s.config.diagonal}:
null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#s&&this.#r.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),
this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#a,this.#n),p("div",{class:"play-stage"},this.#o),p("div",{class:"play-side"},this.#d,this.#t.
element,p("label",{class:"play-choice"},"Pace ",this.#i),p("label",{class:"play-choice"},this.#u," Fog: see only what it sees"),p("p",{class:"small muted play-k\
eys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or tap where to go.")),
this.#c)}get played(){return this.#l&&{...this.#l.played,moves:this.#m}}get live(){return this.#s}play(e){this.#v(In(this.#e,e.played),e.played.seat,e.title),[this.#l,
this.#m,this.#p]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),Gt(this.#s,e.played.seat)&&this.#w()}watch(e,n,r){
this.#l=null,this.#v(e,n,r),this.#x()}stop(){this.#g(),this.player.pause(),this.#l=null}act(e){let[n,r]=[this.#l,this.#s];if(!n||!r||this.element.dataset.state!==
"playing")return;this.#p=e;let o=Number(this.#i.value);this.#f||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#f=setInterval(()=>this.#b(),1e3/o)))}key(e){
let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r===
"Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return ae(this.player,e);let s=Ms(e,this.#s.config.diagonal);return s!==void 0&&this.act(s),
s!==void 0}#v(e,n,r){this.#g(),this.player.pause(),[this.#s,this.#h]=[e,n],this.#a.textContent=r,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} \
cells`,this.#t.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#y(),this.#A()}#y(){this.#r.look={you:this.#h,
fog:this.#u.checked,viewers:this.#h===null?[]:[this.#h]}}#g(){clearInterval(this.#f),this.#f=0,this.#n.ariaLive=Number(this.#i.value)?"off":"polite"}#b(){let[{policies:e,
seat:n},r]=[this.#l.played,this.#s];r.step(e,n,this.#p),this.#m.push(this.#p),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(this.#i.value)||
4)),this.player.move(r.length-this.player.step),Gt(r,n)&&this.#w()}#w(){this.#g();let[e,n,r]=[this.#l,this.#s,this.played],o=xs()?e.link(r):null;this.#d.replaceChildren(
p("h3",{},Ul(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),p("button",{type:"\
button",onclick:()=>this.#x()},"Watch it"),p("button",{type:"button",onclick:()=>{this.#S(n,r.seat)}},"Save"),o&&p("button",{type:"button",onclick:({currentTarget:s})=>Dl(
s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"nearest"})}#x(){this.element.dataset.state="\
watched",this.player.length=this.#s.length,this.player.jump(0),W()||this.player.play()}async#S(e,n){let r=new Blob([await _s(this.#e,e,n)],{type:"application/oc\
tet-stream"});p("a",{href:URL.createObjectURL(r),download:`${re(n,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#A(){let[e,n,{step:r}]=[this.#s,this.#h,
this.player];if(!e||r>e.length)return;let o=$t(e,e.recording,r).filter(({agents:a})=>n===null||a.includes(n)),s=[`Step ${r} of ${e.config.max_steps}`,...o.map(({
text:a})=>a)];this.#l&&r===0?s.push(Ol(e.config,n)):n!==null&&s.push(Nl(e,r,n)),this.#n.textContent=s.filter(Boolean).map(a=>`${a}.`).join(" ")}};function Ol(t,e){
let n=t.rules.capture==="SURROUND";return oe(t,e)==="evader"?`Stay free: ${n?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Cap\
ture evaders: ${n?"surround them together":"reach their cell"}`}function Nl({config:t,recording:e},n,r){let o=e.moments[n],a=oe(t,r)==="pursuer"?"evader":"pursu\
er";if(!o.alive[r])return"";let i=C(o,r),l=d=>{let[h,m]=C(o,d);return Math.max(Math.abs(h-i[0]),Math.abs(m-i[1]))},c=Array.from({length:o.alive.length},(d,h)=>h).
filter(d=>oe(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((d,h)=>l(h)<l(d)?h:d);return`N\
earest ${a}: ${Cs(i,C(o,u))}`}function Ul(t,e){let[{lasted:n,out:r,captured:o},{config:s}]=[$e(t,e),t];return oe(s,e)==="pursuer"?`Your team captured ${o} of ${Bl(
s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var Bl=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Dl(t,e){
let n=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(n),n.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Vt=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#r;#o;#a=null;#n=null;constructor(e,n,r){[this.#e,this.#r,this.#o]=[e,n,r],r.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#n?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#n?.stop())}get view(){return this.#n}start(e,n){this.#a=e;let r=je(n,this.#e,this.#r.selected),o=bs(new URLSearchParams(n.replace(/^#/,"")),this.#e[r.
run].world);o&&this.#t(r,o)}open(){let e=this.#o.shown;if(!e)return;let{match:n,step:r}=e;this.#o.player.pause();let o=this.#o.inspector.agent,s=r<n.length?r:0,
a=(d,h)=>!!n.alive[h*n.n_agents+d],i=Array.from({length:n.n_agents},(d,h)=>(h+n.config.n_pursuers)%n.n_agents),l=o??i.find(d=>a(d,s)),c=a(l,s)?s:0,u=Array.from(
{length:c},(d,h)=>n.actions[h*n.n_agents+l]);this.#t(this.#r.selected,{seat:l,from:c,moves:u})}#t(e,n){let[r,o]=[this.#a,this.#e[e.run]];if(!r||Se.some(h=>ue(o,
h,e[h])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,u=oe(o.world,n.seat),d=o.teams[u].kept.map(h=>({name:o.teams[u].script??`generation ${h}`,policy:()=>te(
o,u,h)}));this.#n||(this.#n=new jt(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#n.element)),this.
dialog.open||this.dialog.showModal(),this.#n.play({title:`You are ${re(n.seat,o.world.n_pursuers)}: ${this.#o.names(e).join(" against ")}`,played:{config:o.world,
seed:BigInt(c??o.seeds[a][i]),episode:l,...n,policies:{pursuer:te(o,"pursuer",a),evader:te(o,"evader",i)}},ending:(h,m)=>[ws(r,h,m,ys(d))],again:()=>this.#t(e,{
...n,moves:n.moves.slice(0,n.from)}),link:h=>vs({run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}},h)})}};var X=Cr(),{runs:D}=X,[Fl,zl]=D[0].payoff.shape,Hl=je(location.hash,D,{run:0,pursuer:Fl-1,evader:zl-1,episode:0,seed:null}),{step:Ps,...Wl}=Hl,B=new Ht(Wl),I=new Pt(
D,B,X.playground),Is=new It(D,B),Oe=new Vt(D,B,I),Nn=ho(),Gl=location.hash,$s=io(D,B,I),{button:jl,dialog:Vl}=ms(I,B);I.actions.append(jl);var Le=null,Ls=p("asi\
de",{class:"note small muted"},X.note),ql="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";document.
getElementById("page").replaceWith(p("header",{class:"top"},p("div",{},p("h1",{},X.heading),p("p",{class:"lead"},ql)),p("div",{class:"tools"},$s.button,gr(),p("\
button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>Nn.showModal()},"?"))),...X.note?[Ls]:[],po(D,B),p("main",{class:"\
stages"},Is.element,I.element),Jo(D,B,()=>Le),p("footer",{class:"muted small"},`${X.title} · matrixworld ${X.version}`),Oe.dialog,Nn,Vl,$s.bar);Object.assign(window,
{matrixworldExplorer:{get match(){return I.match},get step(){return I.player.step},get pace(){return I.player.pace},get playing(){return Oe.view},play:t=>Le&&ie(
Le,D[B.selected.run],{...B.selected,episode:t}),get shape(){return D[B.selected.run].payoff.shape}}});Is.element.addEventListener("play",()=>{I.playSoon(),I.reveal()});
I.goTo(Ps);Ps||I.playSoon();yr(D,B,I);mo(D,B,I,Nn,()=>Oe.open(),()=>En(I.shown,X.playground));window.addEventListener("hashchange",({newURL:t})=>Le&&Oe.start(Le,
new URL(t).hash));X.live!==null&&fo(X.live,D,B,()=>I.player.playing||Oe.dialog.open,()=>{Ls.textContent="The command has ended. This page shows what it had play\
ed; explorer.html is beside the runs if they have finished."});requestAnimationFrame(()=>setTimeout(()=>{mr().then(t=>{Le=t,I.start(t),Oe.start(t,Gl),document.body.
dataset.ready="true"},t=>{I.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="t\
rue"})}));})();
