/* built from web/ by "npm run build"; sources ef4c31066ca0c5bb4398d3238ec57026485d85724e82eaefe7bc58659e26e08d */
"use strict";(()=>{var ma=Object.create;var ur=Object.defineProperty;var ha=Object.getOwnPropertyDescriptor;var fa=Object.getOwnPropertyNames;var ga=Object.getPrototypeOf,ya=Object.prototype.hasOwnProperty;var va=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(n){throw e=0,n}};var ba=(t,e,n,r)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of fa(e))!ya.call(t,o)&&o!==n&&ur(t,o,{get:()=>e[o],enumerable:!(r=ha(e,o))||r.enumerable});
return t};var wa=(t,e,n)=>(n=t!=null?ma(ga(t)):{},ba(e||!t||!t.__esModule?ur(n,"default",{value:t,enumerable:!0}):n,t));var zs=va(sr=>{var Os=Object.defineProperty,kl=t=>Os(t,"__esModule",{value:!0}),Rl=(t,e)=>{for(var n in e)Os(t,n,{get:e[n],enumerable:!0})};kl(sr);Rl(sr,{GIFEncoder:()=>Ds,
applyPalette:()=>Bl,default:()=>Kl,nearestColor:()=>Hl,nearestColorIndex:()=>Us,nearestColorIndexWithDistance:()=>Bs,prequantize:()=>Ul,quantize:()=>Pl,snapColorsToPalette:()=>zl});
var $l={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Is(t=256){let e=0,n=new Uint8Array(t);return{get buffer(){return n.buffer},reset(){e=0},bytesView(){return n.subarray(0,e)},bytes(){return n.slice(0,e)},
writeByte(o){r(e+1),n[e]=o,e++},writeBytes(o,s=0,a=o.length){r(e+a);for(let i=0;i<a;i++)n[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){r(e+a),n.set(o.subarray(
s,s+a),e),e+=a}};function r(o){var s=n.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=n;n=new Uint8Array(
o),e>0&&n.set(i.subarray(0,e),0)}}var nr=12,Rs=5003,_l=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Ol(t,e,n,r,o=Is(512),s=new Uint8Array(
256),a=new Int32Array(Rs),i=new Int32Array(Rs)){let l=a.length,c=Math.max(2,r);s.fill(0),i.fill(0),a.fill(-1);let u=0,d=0,m=c+1,h=m,g=!1,f=h,v=(1<<f)-1,b=1<<m-1,
S=b+1,y=b+2,w=0,A=n[0],T=0;for(let x=l;x<65536;x*=2)++T;T=8-T,o.writeByte(c),C(b);let E=n.length;for(let x=1;x<E;x++)e:{let O=n[x],$=(O<<nr)+A,k=O<<T^A;if(a[k]===
$){A=i[k];break e}let J=k===0?1:l-k;for(;a[k]>=0;)if(k-=J,k<0&&(k+=l),a[k]===$){A=i[k];break e}C(A),A=O,y<1<<nr?(i[k]=y++,a[k]=$):(a.fill(-1),y=b+2,g=!0,C(b))}return C(
A),C(S),o.writeByte(0),o.bytesView();function C(x){for(u&=_l[d],d>0?u|=x<<d:u=x,d+=f;d>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,d-=8;if((y>v||g)&&(g?(f=h,v=(1<<f)-1,g=!1):(++f,v=f===nr?1<<f:(1<<f)-1)),x==S){for(;d>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,d-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Il=Ol;function Ls(t,e,n){return t<<8&63488|e<<2&992|n>>3}function Ps(t,e,n,r){return t>>4|e&240|(n&
240)<<4|(r&240)<<8}function Ns(t,e,n){return t>>4<<8|e&240|n>>4}function ln(t,e,n){return t<e?e:t>n?n:t}function xt(t){return t*t}function $s(t,e,n){var r=0,o=1e100;
let s=t[e],a=s.cnt,i=s.ac,l=s.rc,c=s.gc,u=s.bc;for(var d=s.fw;d!=0;d=t[d].fw){let h=t[d],g=h.cnt,f=a*g/(a+g);if(!(f>=o)){var m=0;n&&(m+=f*xt(h.ac-i),m>=o)||(m+=
f*xt(h.rc-l),!(m>=o)&&(m+=f*xt(h.gc-c),!(m>=o)&&(m+=f*xt(h.bc-u),!(m>=o)&&(o=m,r=d))))}}s.err=o,s.nn=r}function rr(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,
bk:0,tm:0,mtm:0,err:0}}function Ll(t,e){let n=e==="rgb444"?4096:65536,r=new Array(n),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>24&255,l=a>>
16&255,c=a>>8&255,u=a&255,d=Ps(u,c,l,i),m=d in r?r[d]:r[d]=rr();m.rc+=u,m.gc+=c,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],i=a>>
16&255,l=a>>8&255,c=a&255,u=Ns(c,l,i),d=u in r?r[u]:r[u]=rr();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,c=a&255,
u=Ls(c,l,i),d=u in r?r[u]:r[u]=rr();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}return r}function Pl(t,e,n={}){let{format:r="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,clearAlphaThreshold:a=0,
oneBitAlpha:i=!1}=n;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))
throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),c=n.useSqrt!==!1,u=r==="rgba4444",d=Ll(l,r),m=d.length,h=m-1,g=new Uint32Array(
m+1);for(var f=0,b=0;b<m;++b){let I=d[b];if(I!=null){var v=1/I.cnt;u&&(I.ac*=v),I.rc*=v,I.gc*=v,I.bc*=v,d[f++]=I}}xt(e)/f<.022&&(c=!1);for(var b=0;b<f-1;++b)d[b].
fw=b+1,d[b+1].bk=b,c&&(d[b].cnt=Math.sqrt(d[b].cnt));c&&(d[b].cnt=Math.sqrt(d[b].cnt));var S,y,w;for(b=0;b<f;++b){$s(d,b,!1);var A=d[b].err;for(y=++g[0];y>1&&(w=
y>>1,!(d[S=g[w]].err<=A));y=w)g[y]=S;g[y]=b}var T=f-e;for(b=0;b<T;){for(var E;;){var C=g[1];if(E=d[C],E.tm>=E.mtm&&d[E.nn].mtm<=E.tm)break;E.mtm==h?C=g[1]=g[g[0]--]:
($s(d,C,!1),E.tm=b);var A=d[C].err;for(y=1;(w=y+y)<=g[0]&&(w<g[0]&&d[g[w]].err>d[g[w+1]].err&&w++,!(A<=d[S=g[w]].err));y=w)g[y]=S;g[y]=C}var x=d[E.nn],O=E.cnt,$=x.
cnt,v=1/(O+$);u&&(E.ac=v*(O*E.ac+$*x.ac)),E.rc=v*(O*E.rc+$*x.rc),E.gc=v*(O*E.gc+$*x.gc),E.bc=v*(O*E.bc+$*x.bc),E.cnt+=x.cnt,E.mtm=++b,d[x.bk].fw=x.fw,d[x.fw].bk=
x.bk,x.mtm=h}let k=[];var J=0;for(b=0;;++J){let H=ln(Math.round(d[b].rc),0,255),I=ln(Math.round(d[b].gc),0,255),U=ln(Math.round(d[b].bc),0,255),_=255;u&&(_=ln(Math.
round(d[b].ac),0,255),i&&(_=_<=(typeof i=="number"?i:127)?0:255),o&&_<=a&&(H=I=U=s,_=0));let W=u?[H,I,U,_]:[H,I,U];if(Nl(k,W)||k.push(W),(b=d[b].fw)==0)break}return k}
function Nl(t,e){for(let n=0;n<t.length;n++){let r=t[n],o=r[0]===e[0]&&r[1]===e[1]&&r[2]===e[2],s=r.length>=4&&e.length>=4?r[3]===e[3]:!0;if(o&&s)return!0}return!1}
function un(t,e){var n=0,r;for(r=0;r<t.length;r++){let o=t[r]-e[r];n+=o*o}return n}function cn(t,e){return e>1?Math.round(t/e)*e:t}function Ul(t,{roundRGB:e=5,roundAlpha:n=10,
oneBitAlpha:r=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,c=a>>8&255,u=a&255;i=cn(i,n),r&&(i=i<=(typeof r==
"number"?r:127)?0:255),u=cn(u,e),c=cn(c,e),l=cn(l,e),o[s]=i<<24|l<<16|c<<8|u<<0}}function Bl(t,e,n="rgb565"){if(!t||!t.buffer)throw new Error("quantize() expect\
ed RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>
256)throw new Error("applyPalette() only works with 256 colors or less");let r=new Uint32Array(t.buffer),o=r.length,s=n==="rgb444"?4096:65536,a=new Uint8Array(o),
i=new Array(s),l=n==="rgba4444";if(n==="rgba4444")for(let c=0;c<o;c++){let u=r[c],d=u>>24&255,m=u>>16&255,h=u>>8&255,g=u&255,f=Ps(g,h,m,d),v=f in i?i[f]:i[f]=Dl(
g,h,m,d,e);a[c]=v}else{let c=n==="rgb444"?Ns:Ls;for(let u=0;u<o;u++){let d=r[u],m=d>>16&255,h=d>>8&255,g=d&255,f=c(g,h,m),v=f in i?i[f]:i[f]=Fl(g,h,m,e);a[u]=v}}
return a}function Dl(t,e,n,r,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],c=l[3],u=$e(c-r);if(u>a)continue;let d=l[0];if(u+=$e(d-t),u>a)continue;let m=l[1];
if(u+=$e(m-e),u>a)continue;let h=l[2];u+=$e(h-n),!(u>a)&&(a=u,s=i)}return s}function Fl(t,e,n,r){let o=0,s=1e100;for(let a=0;a<r.length;a++){let i=r[a],l=i[0],c=$e(
l-t);if(c>s)continue;let u=i[1];if(c+=$e(u-e),c>s)continue;let d=i[2];c+=$e(d-n),!(c>s)&&(s=c,o=a)}return o}function zl(t,e,n=5){if(!t.length||!e.length)return;
let r=t.map(a=>a.slice(0,3)),o=n*n,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>s?i=i.slice(0,3):i=i.slice();
let l=Bs(r,i.slice(0,3),un),c=l[0],u=l[1];u>0&&u<=o&&(t[c]=i)}}function $e(t){return t*t}function Us(t,e,n=un){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],
i=n(e,a);i<r&&(r=i,o=s)}return o}function Bs(t,e,n=un){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return[o,r]}function Hl(t,e,n=un){
return t[Us(t,e,n)]}function Ds(t={}){let{initialCapacity:e=4096,auto:n=!0}=t,r=Is(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),i=new Int32Array(o),l=!1;
return{reset(){r.reset(),l=!1},finish(){r.writeByte($l.trailer)},bytes(){return r.bytes()},bytesView(){return r.bytesView()},get buffer(){return r.buffer},get stream(){
return r},writeHeader:c,writeFrame(u,d,m,h={}){let{transparent:g=!1,transparentIndex:f=0,delay:v=0,palette:b=null,repeat:S=0,colorDepth:y=8,dispose:w=-1}=h,A=!1;
if(n?l||(A=!0,c(),l=!0):A=!!h.first,d=Math.max(0,Math.floor(d)),m=Math.max(0,Math.floor(m)),A){if(!b)throw new Error("First frame must include a { palette } opt\
ion");Gl(r,d,m,b,y),_s(r,b),S>=0&&jl(r,S)}let T=Math.round(v/10);Wl(r,w,T,g,f);let E=!!b&&!A;Vl(r,d,m,E?b:null),E&&_s(r,b),ql(r,u,d,m,y,s,a,i)}};function c(){Fs(
r,"GIF89a")}}function Wl(t,e,n,r,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,r=!1);var s,a;r?(s=1,a=2):(s=0,a=0),e>=0&&(a=e&7),a<<=2,t.writeByte(
0|a|0|s),Se(t,n),t.writeByte(o||0),t.writeByte(0)}function Gl(t,e,n,r,o=8){let i=or(r.length)-1,l=128|o-1<<4|0|i,c=0,u=0;Se(t,e),Se(t,n),t.writeBytes([l,c,u])}function jl(t,e){
t.writeByte(33),t.writeByte(255),t.writeByte(11),Fs(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Se(t,e),t.writeByte(0)}function _s(t,e){let n=1<<or(e.length);
for(let r=0;r<n;r++){let o=[0,0,0];r<e.length&&(o=e[r]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function Vl(t,e,n,r){if(t.writeByte(44),Se(t,0),Se(
t,0),Se(t,e),Se(t,n),r){let a=or(r.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function ql(t,e,n,r,o=8,s,a,i){Il(n,r,e,o,t,s,a,i)}function Se(t,e){t.writeByte(
e&255),t.writeByte(e>>8&255)}function Fs(t,e){for(var n=0;n<e.length;n++)t.writeByte(e.charCodeAt(n))}function or(t){return Math.max(Math.ceil(Math.log2(t)),1)}
var Kl=Ds});var dr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Qe={DISAPPEAR:0,REACH:1,BOUNCE:2},pr={OCCUPATION:0,SURROUND:1},mr={FAULT:0,INVOLVED:1};var vn=["obstacle","teammate","adversary"],bn=["vertex","edge","chain"],hr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],wn=["p\
ursuer_{number}","evader_{number}"],fr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},et={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},gr="{event}: {outcome}",xn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},yr={free:".GS",blocked:"#@OTW"};var Pe=1+hr.length;function tt(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function Sn(t,e){return t<e?tt(wn[0],{number:t}):tt(wn[1],{number:t-e})}function xa(t,e){
let[n,r,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[d,m,h]=c.map(b=>u.filter((S,y)=>b>>y&1)),g=u.map(b=>Sn(b,e)),f=tt(fr[a<0?"obstacle":bn[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),v=tt(gr,{event:f,outcome:Sa(u.length,m,h,e)});return{kind:vn[r],form:bn[o],agents:u,cell:[i,l],at_fault:d,held:m,doomed:h,turn:n,
text:v}}function Sa(t,e,n,r){if(t===2&&e.length===2)return et["both held"];if(t===2&&n.length===2)return et["both doomed"];let o=s=>a=>tt(et[s],{agent:Sn(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||et.none}function At(t,e){let n=[];for(let r=0;r<t.length;r+=Pe)n.push(xa(t.subarray(r+1,r+Pe),e));
return n}var ie=class extends Error{name="EngineError"};function D(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new ie(
`${t}: expected ${e}, got ${r}`)}var Ne=class{bytes;constructor(e){this.bytes=e}},wr=0,An=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],vr=4,br=4,Ma=new TextEncoder,
Aa=new TextDecoder;function Ea(t){for(let e=An.length-1;e>wr;--e)if(t instanceof An[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Mn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ca(t){return Ma.encode(`${t}\0`)}var En=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new ie("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(Ca(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Ne,l=i?a.bytes:
a;return[this.text(s),i?wr:Ea(l),l.length,this.copy(Mn(l))]}),o=this.copy(Mn(Int32Array.from(r)));return this.copy(Mn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function xr(t,e){let n=t.HEAPU8;return Aa.decode(n.subarray(e,n.indexOf(0,e)))}function Et(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/vr,r=e[n+1]/vr,o={};for(let s=r;s<r+e[n]*br;s+=br){let a=An[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[xr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function nt(t,e){let n=new En(t);try{let r=e(n);if(r===0)throw new ie(xr(t,t._last_error()));return r}finally{n.free()}}var Ta=2**31-1,ka=2n**64n-1n,Ra=34028234663852886e22;function pe(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Ta)throw D(t,"an integer",e);return Int32Array.
of(e)}function Ct(t,e){if(typeof e!="boolean")throw D(t,"true or false",e);return new Ne(Uint8Array.of(Number(e)))}function Me(t,e,n){let r=typeof e=="string"&&
Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw D(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function Cn(t,e){if(typeof e!="number"||
!(Math.abs(e)<=Ra))throw D(t,"a finite number",e);return e}function Ue(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(r<0n||r>ka)throw D(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function $a(t){return{"rules.interaction":Me("interaction",t.interaction,
dr),"rules.obstacle":Me("obstacle",t.obstacle,Qe),"rules.teammate":Me("teammate",t.teammate,Qe),"rules.evader":Me("evader",t.evader,Qe),"rules.pursuer":Me("purs\
uer",t.pursuer,Qe),"rules.capture":Me("capture",t.capture,pr),"rules.captured_disappear":Ct("captured_disappear",t.captured_disappear)}}function Sr(t,e){let n=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw D(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>Cn(t,r))}function _a(t){let e=(n,r)=>Float32Array.
of(Cn(n,t[n]),Cn(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Sr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Sr("evader_collide",t.evader_collide),
"rewards.blame":Me("blame",t.blame,mr),"rewards.capture_repeats":Ct("capture_repeats",t.capture_repeats)}}function Ar(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=yr;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw D(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw D(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function Er(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw D("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function Tt(t){Er(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...$a(t.rules),..._a(t.rewards),rows:pe("rows",t.rows),cols:pe("cols",t.cols),n_pursuers:pe("n_pursuers",t.n_pursuers),n_evaders:pe("n_evaders",t.n_evaders),fov:pe(
"fov",t.fov),diagonal:Ct("diagonal",t.diagonal),max_steps:pe("max_steps",t.max_steps),density:Float64Array.of(e),map:Ar(t.obstacles)}}function Mr(t,e){return Int32Array.
from((e??[]).flat(),n=>pe(t,n)[0])}function Cr(t,e){return Er(t.obstacles,e),{seed:Ue("seed",t.seed??0n),episode:Ue("episode",t.episode??0),pursuers:Mr("pursuer\
s",t.pursuers),evaders:Mr("evaders",t.evaders),map:Ar(t.obstacles)}}function kt(t){return{actions:Int32Array.from(t,e=>pe("actions",e)[0])}}function Be(t){if(typeof t==
"string"){if(!Object.hasOwn(xn,t))throw D("policy",`one of ${Object.keys(xn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw D("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>pe("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:Ct("sampled",t.sampled),genome:t.genome}}var Oa=["first_turn","terminated","truncated"];function Tr(t){let e={...t};for(let n of Oa)
e[n]=new Ne(t[n]);return e}var Rt=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,n,r,o){
this.config=e,this.seed=n,this.episode=r,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=kr(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Ia(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[n,r]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(n*Pe,r*Pe);return At(o,this.config.
n_pursuers)}seek(e,n){this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.episode});
for(let o=e.steps;o<n;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw D("s\
tep",`0 to ${this.length}`,e)}};function Ia(t,e){let n=new Int32Array(e+2);for(let r=0;r<t.length;r+=Pe)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}
function kr(t,e){let n=t["statistics.length"].length,r=s=>{let a=t[`statistics.${s}`],i=a.length/n;return a.slice(e*i,(e+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),
overlap:r("overlap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function Rr(t,e,n,r){let o=[Tt(n.config),Be(n.pursuers),Be(n.evaders),
r];return nt(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](a,i,l,c)}),Et(t)}function $r(t,e,n,r){let o={seed:Ue("seed",n),episode:Ue("episode",r)};return new Rt(
e.config,n,r,Rr(t,"_play_match",e,o))}function _r(t,e,n,r){if(!Number.isInteger(r)||r<1)throw D("n_episodes","at least 1",r);let o={seed:Ue("seed",n),n_episodes:Int32Array.
of(r)},s=Rr(t,"_play_rollout",e,o);return Array.from({length:r},(a,i)=>kr(s,i))}var Or=new FinalizationRegistry(([t,e])=>t._world_free(e)),rt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=nt(e,r=>e._world_new(r.arrays(Tt(n)))),Or.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Or.unregister(this),this.engine._world_free(this.at))}reset(e={}){let n=Cr(e,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(e){let n=kt(e);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(e){let n=kt(e);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw D(
"actions",String(this.n_agents),r.length);let l=[Be(e),kt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(c)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.at,n.
text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return At(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,n){
let r=Be(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,
probabilities:La(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let n=Tr(e);this.call(r=>this.engine._world_restore(
this.at,r.arrays(n)))}call(e){if(this.freed)throw D("world","one that is in use","one that was freed");return nt(this.engine,e),Et(this.engine)}};function La(t){
let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var Tn=class{compiled;constructor(e){this.compiled=e}world(e){return new rt(this.compiled,e)}match(e,n,r,o,s=0){return $r(this.compiled,{config:e,pursuers:n,evaders:r},
o,s)}rollout(e,n,r,o,s){return _r(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Ir;function Lr(t=globalThis.matrixworldEngine){return Ir??=Pa(t),Ir}async function Pa(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new Tn(
await t({wasmBinary:e}))}var Na="http://www.w3.org/2000/svg";function p(t,e={},...n){return Pr(document.createElement(t),e,n)}function M(t,e={},...n){return Pr(document.createElementNS(
Na,t),e,n)}function Pr(t,e,n){for(let[r,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(r.slice(2),o):t.setAttribute(r,o===!0?"":
String(o)));return t.append(...n.filter(Ua).map(r=>typeof r=="number"?String(r):r)),t}function Ua(t){return t!=null&&t!==!1}var Ba=matchMedia("(prefers-color-scheme: dark)");function Da(){let t=document.documentElement.dataset.theme;return t?t==="dark":Ba.matches}function kn(){document.
documentElement.dataset.theme=Da()?"light":"dark"}function Nr(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:kn},"◐")}var Fa=2n**64n-1n;function ot(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,d)=>{let m=r.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):d},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Fa?l:null,step:o("step",1/0,0)}}function Ur(t,e,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:n.player.step};r=`#${Object.entries(u).
map(([d,m])=>`${d}=${m}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};e.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=ot(location.hash,
t,e.selected);e.select(a),n.goTo(s)})}var N=Uint8Array,Y=Uint16Array,Un=Int32Array,_t=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ot=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),On=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Wr=function(t,e){for(var n=new Y(31),r=0;r<31;++r)n[r]=e+=
1<<t[r-1];for(var o=new Un(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},Gr=Wr(_t,2),jr=Gr.b,In=Gr.r;jr[28]=258,In[258]=28;var Vr=Wr(
Ot,0),za=Vr.b,Br=Vr.r,Ln=new Y(32768);for(R=0;R<32768;++R)me=(R&43690)>>1|(R&21845)<<1,me=(me&52428)>>2|(me&13107)<<2,me=(me&61680)>>4|(me&3855)<<4,Ln[R]=((me&65280)>>
8|(me&255)<<8)>>1;var me,R,le=(function(t,e,n){for(var r=t.length,o=0,s=new Y(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new Y(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new Y(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],d=a[t[o]-1]++<<u,m=d|(1<<u)-1;d<=m;++d)i[Ln[d]>>l]=c}else for(i=new Y(
r),o=0;o<r;++o)t[o]&&(i[o]=Ln[a[t[o]-1]++]>>15-t[o]);return i}),ve=new N(288);for(R=0;R<144;++R)ve[R]=8;var R;for(R=144;R<256;++R)ve[R]=9;var R;for(R=256;R<280;++R)
ve[R]=7;var R;for(R=280;R<288;++R)ve[R]=8;var R,it=new N(32);for(R=0;R<32;++R)it[R]=5;var R,Ha=le(ve,9,0),Wa=le(ve,9,1),Ga=le(it,5,0),ja=le(it,5,1),Rn=function(t){
for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},se=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},$n=function(t,e){var n=e/8|0;return(t[n]|
t[n+1]<<8|t[n+2]<<16)>>(e&7)},Bn=function(t){return(t+7)/8|0},Dn=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),new N(t.subarray(
e,n))};var Va=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],j=function(t,e,n){var r=new Error(e||Va[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,j),!n)throw r;return r},qa=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new N(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new N(o*3));var c=function(Xe){var Je=n.length;if(Xe>Je){var Le=new N(Math.max(Je*2,Xe));Le.set(n),n=Le}},u=e.f||0,d=e.
p||0,m=e.b||0,h=e.l,g=e.d,f=e.m,v=e.n,b=o*8;do{if(!h){u=se(t,d,1);var S=se(t,d+1,3);if(d+=3,S)if(S==1)h=Wa,g=ja,f=9,v=5;else if(S==2){var T=se(t,d,31)+257,E=se(
t,d+10,15)+4,C=T+se(t,d+5,31)+1;d+=14;for(var x=new N(C),O=new N(19),$=0;$<E;++$)O[On[$]]=se(t,d+$*3,7);d+=E*3;for(var k=Rn(O),J=(1<<k)-1,H=le(O,k,1),$=0;$<C;){
var I=H[se(t,d,J)];d+=I&15;var y=I>>4;if(y<16)x[$++]=y;else{var U=0,_=0;for(y==16?(_=3+se(t,d,3),d+=2,U=x[$-1]):y==17?(_=3+se(t,d,7),d+=3):y==18&&(_=11+se(t,d,127),
d+=7);_--;)x[$++]=U}}var W=x.subarray(0,T),B=x.subarray(T);f=Rn(W),v=Rn(B),h=le(W,f,1),g=le(B,v,1)}else j(1);else{var y=Bn(d)+4,w=t[y-4]|t[y-3]<<8,A=y+w;if(A>o){
l&&j(0);break}i&&c(m+w),n.set(t.subarray(y,A),m),e.b=m+=w,e.p=d=A*8,e.f=u;continue}if(d>b){l&&j(0);break}}i&&c(m+131072);for(var _e=(1<<f)-1,Q=(1<<v)-1,de=d;;de=
d){var U=h[$n(t,d)&_e],q=U>>4;if(d+=U&15,d>b){l&&j(0);break}if(U||j(2),q<256)n[m++]=q;else if(q==256){de=d,h=null;break}else{var K=q-254;if(q>264){var $=q-257,P=_t[$];
K=se(t,d,(1<<P)-1)+jr[$],d+=P}var ae=g[$n(t,d)&Q],Oe=ae>>4;ae||j(3),d+=ae&15;var B=za[Oe];if(Oe>3){var P=Ot[Oe];B+=$n(t,d)&(1<<P)-1,d+=P}if(d>b){l&&j(0);break}i&&
c(m+131072);var Ie=m+K;if(m<B){var St=s-B,Mt=Math.min(B,Ie);for(St+m<0&&j(3);m<Mt;++m)n[m]=r[St+m]}for(;m<Ie;++m)n[m]=n[m-B]}}e.l=h,e.p=de,e.b=m,e.f=u,h&&(u=1,e.
m=f,e.d=g,e.n=v)}while(!u);return m!=n.length&&a?Dn(n,0,m):n.subarray(0,m)},he=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},st=function(t,e,n){n<<=
e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},_n=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:Kr,l:0};if(o==1){var a=new N(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(A,T){return A.f-T.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
u=1,d=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[c].f<n[d].f?c++:d++],l=n[c!=u&&n[c].f<n[d].f?c++:d++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,r=1;r<
o;++r)s[r].s>m&&(m=s[r].s);var h=new Y(m+1),g=Pn(n[u-1],h,0);if(g>e){var r=0,f=0,v=g-e,b=1<<v;for(s.sort(function(T,E){return h[E.s]-h[T.s]||T.f-E.f});r<o;++r){
var S=s[r].s;if(h[S]>e)f+=b-(1<<g-h[S]),h[S]=e;else break}for(f>>=v;f>0;){var y=s[r].s;h[y]<e?f-=1<<e-h[y]++-1:++r}for(;r>=0&&f;--r){var w=s[r].s;h[w]==e&&(--h[w],
++f)}g=e}return{t:new N(h),l:g}},Pn=function(t,e,n){return t.s==-1?Math.max(Pn(t.l,e,n+1),Pn(t.r,e,n+1)):e[t.s]=n},Dr=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new Y(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},at=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},qr=function(t,e,n){var r=n.length,o=Bn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},Fr=function(t,e,n,r,o,s,a,i,l,c,u){he(e,u++,n),++o[256];for(var d=_n(o,15),m=d.t,h=d.l,g=_n(s,15),f=g.t,v=g.l,b=Dr(m),S=b.c,
y=b.n,w=Dr(f),A=w.c,T=w.n,E=new Y(19),C=0;C<S.length;++C)++E[S[C]&31];for(var C=0;C<A.length;++C)++E[A[C]&31];for(var x=_n(E,7),O=x.t,$=x.l,k=19;k>4&&!O[On[k-1]];--k)
;var J=c+5<<3,H=at(o,ve)+at(s,it)+a,I=at(o,m)+at(s,f)+a+14+3*k+at(E,O)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&J<=H&&J<=I)return qr(e,u,t.subarray(l,l+c));var U,_,W,B;
if(he(e,u,1+(I<H)),u+=2,I<H){U=le(m,h,0),_=m,W=le(f,v,0),B=f;var _e=le(O,$,0);he(e,u,y-257),he(e,u+5,T-1),he(e,u+10,k-4),u+=14;for(var C=0;C<k;++C)he(e,u+3*C,O[On[C]]);
u+=3*k;for(var Q=[S,A],de=0;de<2;++de)for(var q=Q[de],C=0;C<q.length;++C){var K=q[C]&31;he(e,u,_e[K]),u+=O[K],K>15&&(he(e,u,q[C]>>5&127),u+=q[C]>>12)}}else U=Ha,
_=ve,W=Ga,B=it;for(var C=0;C<i;++C){var P=r[C];if(P>255){var K=P>>18&31;st(e,u,U[K+257]),u+=_[K+257],K>7&&(he(e,u,P>>23&31),u+=_t[K]);var ae=P&31;st(e,u,W[ae]),
u+=B[ae],ae>3&&(st(e,u,P>>5&8191),u+=Ot[ae])}else st(e,u,U[P]),u+=_[P]}return st(e,u,U[256]),u+_[256]},Ka=new Un([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Kr=new N(0),Ya=function(t,e,n,r,o,s){var a=s.z||t.length,i=new N(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var d=Ka[e-1],m=d>>13,h=d&8191,g=(1<<n)-1,f=s.p||new Y(32768),v=s.h||new Y(g+1),b=Math.ceil(n/3),S=2*b,y=function(yn){return(t[yn]^t[yn+1]<<
b^t[yn+2]<<S)&g},w=new Un(25e3),A=new Y(288),T=new Y(32),E=0,C=0,x=s.i||0,O=0,$=s.w||0,k=0;x+2<a;++x){var J=y(x),H=x&32767,I=v[J];if(f[H]=I,v[J]=H,$<=x){var U=a-
x;if((E>7e3||O>24576)&&(U>423||!c)){u=Fr(t,l,0,w,A,T,C,O,k,x-k,u),O=E=C=0,k=x;for(var _=0;_<286;++_)A[_]=0;for(var _=0;_<30;++_)T[_]=0}var W=2,B=0,_e=h,Q=H-I&32767;
if(U>2&&J==y(x-Q))for(var de=Math.min(m,U)-1,q=Math.min(32767,x),K=Math.min(258,U);Q<=q&&--_e&&H!=I;){if(t[x+W]==t[x+W-Q]){for(var P=0;P<K&&t[x+P]==t[x+P-Q];++P)
;if(P>W){if(W=P,B=Q,P>de)break;for(var ae=Math.min(Q,P-2),Oe=0,_=0;_<ae;++_){var Ie=x-Q+_&32767,St=f[Ie],Mt=Ie-St&32767;Mt>Oe&&(Oe=Mt,I=Ie)}}}H=I,I=f[H],Q+=H-I&
32767}if(B){w[O++]=268435456|In[W]<<18|Br[B];var Xe=In[W]&31,Je=Br[B]&31;C+=_t[Xe]+Ot[Je],++A[257+Xe],++T[Je],$=x+W,++E}else w[O++]=t[x],++A[t[x]]}}for(x=Math.max(
x,$);x<a;++x)w[O++]=t[x],++A[t[x]];u=Fr(t,l,c,w,A,T,C,O,k,x-k,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=v,s.p=f,s.i=x,s.w=$)}else{for(var x=s.w||0;x<a+c;x+=65535){var Le=x+
65535;Le>=a&&(l[u/8|0]=c,Le=a),u=qr(l,u+1,t.subarray(x,Le))}s.i=a}return Dn(i,0,r+Bn(u)+o)},Za=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var n=e,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),Xa=function(){var t=-1;return{p:function(e){for(var n=t,r=0;r<e.length;++r)n=Za[n&255^e[r]]^n>>>8;t=n},d:function(){
return~t}}};var Ja=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ya(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},Yr=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var G=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var Qa=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&j(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&j(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function ei(t,e){return Ja(t,e||{},0,0)}function Zr(t,e){return qa(t.subarray(Qa(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Xr=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=Yr(r,s[1]),s=s[0]),s instanceof N?n[a]=[s,i]:(n[a+="/"]=[new N(0),i],Xr(s,a,n,
r))}},zr=typeof TextEncoder<"u"&&new TextEncoder,ti=typeof TextDecoder<"u"&&new TextDecoder,ni=0;try{ti.decode(Kr,{stream:!0}),ni=1}catch{}function $t(t,e){if(e){for(var n=new N(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(zr)return zr.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new N(a+8+(o-r<<1));l.set(s),s=l}var c=t.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Dn(s,0,a)}var Nn=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&j(9),e+=r+4}return e},Hr=function(t,e,n,r,o,s,a,i){var l=r.length,c=n.extra,u=i&&i.length,
d=Nn(c);G(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var m=new Date(n.mtime==null?Date.now():n.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&j(10),G(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(G(t,e,n.crc),G(t,e+4,s<0?-s-2:s),G(t,e+8,n.size)),G(t,e+12,l),G(t,e+14,d),e+=16,a!=null&&(G(t,e,
u),G(t,e+6,n.attrs),G(t,e+10,a),e+=14),t.set(r,e),e+=l,d)for(var g in c){var f=c[g],v=f.length;G(t,e,+g),G(t,e+2,v),t.set(f,e+4),e+=4+v}return u&&(t.set(i,e),e+=
u),e},ri=function(t,e,n,r,o){G(t,e,101010256),G(t,e+8,n),G(t,e+10,n),G(t,e+12,r),G(t,e+16,o)};function Jr(t,e){e||(e={});var n={},r=[];Xr(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],u=c.level==0?0:8,d=$t(a),m=d.length,h=c.comment,g=h&&
$t(h),f=g&&g.length,v=Nn(c.extra);m>65535&&j(11);var b=u?ei(l,c):l,S=b.length,y=Xa();y.p(l),r.push(Yr(c,{size:l.length,crc:y.d(),c:b,f:d,m:g,u:m!=a.length||g&&h.
length!=f,o,compression:u})),o+=30+m+v+S,s+=76+2*(m+v)+(f||0)+S}for(var w=new N(s+22),A=o,T=s-o,E=0;E<r.length;++E){var d=r[E];Hr(w,d.o,d,d.f,d.u,d.c.length);var C=30+
d.f.length+Nn(d.extra);w.set(d.c,d.o+C),Hr(w,o,d,d.f,d.u,d.c.length,d.o,d.m),o+=16+C+(d.m?d.m.length:0)}return ri(w,o,r.length,T,A),w}var De=["pursuer","evader"];function eo(){return JSON.parse(It("data"))}function Ae(t,e,n){let[r,o]=[e-t.payoff.first[0],n-t.payoff.first[1]],s=t.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r][o]}}function Ee(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.
teams[e];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${e}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return to(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function ee(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=to(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:c}}var Fn=4,Qr=new Map;function to(t,e){let n=Qr.get(t);if(n)return n;let r=new Float32Array;try{let o=si(
zn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||oi(o)))throw o}return Qr.set(t,r),r}var oi=t=>t instanceof
Error&&"code"in t;function si(t,e){let n=Zr(t),r=n.length/Fn,o=new Uint8Array(n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Fn*r+Math.floor(a/Fn)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function zn(t){let e=atob(It(t)),n=new Uint8Array(e.length);for(let r=0;r<n.
length;r++)n[r]=e.charCodeAt(r);return n}function It(t){return document.getElementById(t)?.textContent??""}var Fe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function no(t,e,n){let[r,o]=[e[0]-t[0],e[1]-t[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),Fe.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ai=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Hn=({rows:t,cols:e},[n,r])=>n>=0&&r>=0&&n<t&&r<e,Wn=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),Gn=(t,e)=>Wn(t.fault,e),ro=(t,e)=>!Gn(
t,e)&&Wn(t.involved,e,2);function Lt(t,e,n){let r=!ai(L(t,n),L(e,n)),o=e.involved===void 0||Wn(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!r&&o)}function Pt(t,e,n){
let[r,o]=L(t,n),[s,a]=Fe[e.actions?.[n]??0];return[r+s,o+a]}function lt(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var oo=t=>t.moments.flatMap((e,n)=>n&&lt(t,t.moments[n-1],e).length?[n]:[]);function Nt(t,e){return Array.from({length:e.
alive.length},(r,o)=>o).filter(r=>t.alive[r]&&!e.alive[r])}var so=[-.31,0,.31],ao=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:so.flatMap(t=>so.map(e=>[e,t]))}],ii=.3,li=.35,ci=.55;function ct(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=L(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function io(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ct(t,e).values()){let o=ao[Math.min(r.length,ao.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var lo=t=>t*t*(3-2*t),ze=(t,e,n)=>t+(e-t)*n,co=t=>Math.min(1,Math.max(0,t));function uo(t,e,n,r){let o={
1:2,2:n}[t.interaction]??1;if(o===1)return lo(r);let s=o===n?e:+!Ce(t,e),a=Math.max(1/o,li);return lo(co((r-s/(o-1)*(1-a))/a))}function Ut(t,e){let n=t.moments.
length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=io(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=io(t,a);return s.map((l,c)=>{let u=uo(t,c,s.length,
e-r);return ui(o,a,c,l,i[c],u)})}function qn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[t.moments[o],t.moments[Math.min(o+1,r)]],i=uo(t,
e,s.alive.length,n-o),[[l,c],[u,d]]=[L(s,e),L(a,e)];return[ze(c,d,i)+.5,ze(l,u,i)+.5]}function ui(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:ze(r.x,o.x,s),y:ze(r.y,
o.y,s),size:a?r.size:ze(r.size,o.size,s),alpha:a?co((1-s)/(1-ci)):ze(r.alpha,o.alpha,s)};if(Lt(t,e,n)){let[l,c]=L(t,n),[u,d]=Pt(t,e,n),m=ii*Math.sin(Math.PI*s);
i.x+=(d-c)*m,i.y+=(u-l)*m}return i}var po=2*Math.PI;function Te(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,po)}function Bt(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,r*.09)}),t.closePath()}function mo(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function ho(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=po*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function fo(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var go=4,di=1.6,pi=.95,mi=5,hi=.16,fi=9,gi=.09,yi=.2,yo=.75,te=(t,e)=>t.left+e*t.cell,ne=(t,e)=>t.top+e*t.cell;function He(t,e,n){return Ce(e,n)?t.colors.pursuer:
t.colors.evader}function vo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=n.paper,t.fillRect(r,o,l,c),s<mi)return;
t.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(r+d*s,o,u,c);for(let d=1;d<a;d++)t.fillRect(r,o+d*s,l,u)}function bo({ctx:t,
grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let c=0;c<i*l;c++){if(!r.obstacles[c])continue;let[u,d]=[Math.floor(c/l),
c%l];t.fillRect(o+d*a,s+u*a,a,a)}wo({ctx:t,grid:e,colors:n})}function wo({ctx:t,grid:{left:e,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function xo({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,c=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.
textAlign="center";let u=5*r+a/40;for(let d=0;d<l;d+=c)t.fillText(String(d),o+(d+.5)*a,s-u);t.textAlign="right",t.textBaseline="middle";for(let d=0;d<i;d+=c)t.fillText(
String(d),o-u,s+(d+.5)*a)}function So({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(t.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
t.rows,r+o)];return[te(t,s),ne(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Mo(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...So(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),wo(t)}function Ao({ctx:t,grid:e,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[te(e,r),ne(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=n.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let d=c-i/2<u*1.2,m=c+(d?1:-1)*(i/2+u*.7);t.strokeStyle=
n.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=n.ink,t.fillText("You",l,m),t.globalAlpha=1}function Eo(t,e,n,r,o){let{ctx:s,grid:a}=t,
i=So(t,e,r,o),l=He(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Co(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(fi,
Math.max(1,a.cell*hi));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let[u,d]=[e.moments[c-1],e.moments[c]],m=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
yo+(yi-yo)*m;for(let h=0;h<d.alive.length;h++){let g=c===i&&n<i;if(!u.alive[h]||!(l.alive[h]||g))continue;let f=(Ce(e,h)?-1:1)*gi,[v,b]=L(u,h),[S,y]=L(d,h);if(v===
S&&b===y)continue;let w=g?o[h].x:y+.5,A=g?o[h].y:S+.5;s.strokeStyle=He(t,e,h),s.beginPath(),s.moveTo(te(a,b+.5+f),ne(a,v+.5+f)),s.lineTo(te(a,w+f),ne(a,A+f)),s.
stroke()}}s.globalAlpha=1}function To(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-go+1);o<=r;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/go,l=lt(e,s,a);for(let c of Nt(s,a))l.includes(c)||bi(t,L(a,c),i);for(let c of l)vi(t,L(a,c),i)}t.ctx.globalAlpha=1}function vi({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,ho(t,te(e,o+.5),ne(e,r+.5),Math.max(8,e.cell*di)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function bi({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,mo(t,te(e,o+.5),ne(e,r+.5),Math.max(7,e.cell*pi)),
t.strokeStyle=n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function ko({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[te(e,i)+s,ne(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function Ro({ctx:t,grid:e,colors:n},r,o,s,a){t.globalAlpha=a,Te(t,te(e,r),ne(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var wi=.8,xi=.92,Si=15,Mi=7,Kn=9;function $o(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&Ai(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ct(e,n).values())a.length>
Kn&&Ei(t,r[a[Kn-1]],a.length-Kn+1)}function Ai(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Ce(e,r),[d,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?xi:wi)),g=He(t,e,r),f=!u&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Bt:Te)(i,d,m,h),h>Mi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(Te(i,d,m,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<Si*a)return;let v=String(u?r:r-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
v,d,m+h*(u?.17:.03))}function Ei({ctx:t,grid:e,colors:n},r,o){let[s,a]=[e.left+r.x*e.cell,e.top+r.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=n.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=n.ink,t.fillText(`+${o}`,
s,a)}var Ci=.46,Ti=.86,ki=.66,_o=.48,Ri=.78,$i=.58;function Oo(t,e,n,r){let[o,s]=[e.moments[n-1],e.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Lt(o,s,c)&&_i(t,e,L(o,c),Pt(o,s,c));a.globalAlpha=
1}function _i({ctx:t,grid:e},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=d=>te(e,r[1]+.5+s*d),l=d=>ne(e,r[0]+.5+a*d),c=Hn(n,o)?Ri:$i;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(_o),l(_o)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function Io(t,e,n,r,o,s){let a=Fe[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Hn(e,[r[0]+a[0],r[1]+a[1]])?Ti:
ki,d=Ci*o.size,m=[te(l,o.x+a[1]*d),ne(l,o.y+a[0]*d),te(l,o.x+a[1]*u),ne(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[
c.paper,h*2.1],[He(t,e,n),h]])i.strokeStyle=g,i.lineWidth=f,fo(i,...m,l.cell*.2),i.stroke()}var Dt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Ft(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),c=e.moments[l],u=n===l,d=Ut(e,n),m=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),vo(t);for(let f of r.
viewers)d[f]?.alpha&&Eo(t,e,f,...qn(e,f,n));bo(t,e),r.axes&&xo(t,o),Co(t,e,n,r.trail,d),ko(t,c.contested??[],m),To(t,e,n),Oo(t,e,l,m),d.forEach(({x:f,y:v,size:b},S)=>{
let y=ro(c,S)?.4:0,w=Gn(c,S)?1:y;w&&Ro(t,f,v,b,w*m)});let h=u?c:e.moments[Math.max(0,l-1)];if($o(t,e,h,d,r.numbers,o),u&&r.plan)for(let[f,v]of d.entries())v.alpha&&
Io(t,e,f,L(c,f),v,r.plan[f]??0);r.you!==null&&(r.fog&&Mo(t,e,...qn(e,r.you,n)),Ao(t,d[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===
null?void 0:d[r.selected];g?.alpha&&Lo(t,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Lo(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function Lo({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var ut=(t,e)=>(e+.24)/(t+.24);function zt(t,e,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Po(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var Oi={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function We(t){let e=getComputedStyle(t),n=Object.entries(Oi).map(([r,o])=>[r,e.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var re=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,be=class{canvas;#e=null;#r=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#t;#i;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Dt,...n},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}get time(){return this.#r}show(e,n){this.#e=e,this.#r=Math.min(Math.max(0,n),e.moments.
length-1),this.#u(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#a=zt(n,r,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:We(this.canvas)};Ft(s,this.#e,this.#r,this.#o,o)}cellAt(e,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.
width;return Po(this.#a,(e-r.left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#r)],s=ct(
this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Ut(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,u-n)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[r.left+
(s+e*i)*o,r.top+(a+n*i)*o]}#u(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(ut(e,n)))}#d(){let e=devicePixelRatio||
1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var Ii=12e3;function No(t,e,n){let r=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>d(
c-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>d(c+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>d(0,!re())},"A guided minute"),[c,u]=[-1,0];function d(v,b){
clearTimeout(u);let S=r()[v];if(g(),!S)return m();c=v,o.replaceChildren(p("span",{class:"muted numbers"},`${v+1} of ${r().length} `),S.text),s.disabled=v===0,a.
textContent=v===r().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:S.pursuer,evader:S.evader}),S.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):S.shows==="checkerboard"?h():(n.reveal(),n.playSoon()),b&&(u=setTimeout(()=>d(v+1,!0),Ii))}function m(){clearTimeout(u),c=-1,i.
hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let v=document.querySelector("dialog.four[open]");v?.append(i),v?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let g=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!r().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",v=>{v.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var Li={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},dt=[.5,1,2,4,8,16,32,64],Ge=0,Ht=12,Pi=2,fe=class extends EventTarget{#e;#r;#o;#a;#n=0;#t=0;#i=!1;#u=null;#d=0;#c=[];glide=.28;constructor(e,n={}){
super(),this.#e=e,this.#r=n.speed??4,this.#a=n.still??!1,this.#o=n.clock??Li}get step(){return this.#n}get time(){return this.#a?this.#n:this.#t}get arrived(){return this.#t===
this.#n}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#p("state")}get marks(){return this.#c}set marks(e){
this.#c=e,this.#p("state")}get pace(){return this.#r||Math.max(Pi,this.#e/Ht)}get speed(){return this.#r}set speed(e){this.#r=e,this.#p("state")}changeSpeed(e){
let n=dt.findIndex(r=>r>=this.pace);this.speed=dt[Math.min(dt.length-1,Math.max(0,n+e))]}play(){this.#i||!this.#e||(this.#n===this.#e&&this.jump(0),this.#i=!0,this.#p(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#p("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#n+e));Math.abs(n-this.#t)>1?this.jump(n):this.#l(n),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#l(this.#t),this.#p("fram\
e")}#l(e){e!==this.#n&&(this.#n=e,this.#p("step"),this.#a&&this.#p("frame"))}#s(){this.#u===null&&(this.#d=this.#o.now(),this.#u=this.#o.request(()=>this.#h()))}#h(){
this.#u=null;let e=this.#o.now();this.#f(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#a||this.arrived)&&this.#p("frame"),(this.#i||this.#t!==this.#n)&&(this.#u=
this.#o.request(()=>this.#h()))}#f(e){let n=e;for(;n>0;){if(this.#t===this.#n){if(!this.#i)return;if(this.#n===this.#e)return this.pause();this.#l(this.#n+1)}let r=this.#i?
this.pace:1/this.glide,o=this.#n-this.#t,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#t=s===Math.abs(o)?this.#n:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#p(e){this.dispatchEvent(new Event(e))}};function we(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var pt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function je(t){let e=Math.min(1,Math.max(0,t))*(pt.length-1),n=Math.min(pt.length-2,Math.floor(e)),[r,o]=[pt[n],
pt[n+1]],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Wt(t){let[e,n,r]=je(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+
.0722*r>.179?"#000":"#fff"}var Gt=t=>`rgb(${je(t).join(" ")})`,Uo=()=>`linear-gradient(to right, ${pt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function jt(t,e,n){let r=devicePixelRatio||1;t.style.left=`${n.left}px`,t.style.top=`${n.top}px`,t.style.width=`${n.width}px`,t.style.height=`${n.height}px`,t.width=
Math.round(n.width*r),t.height=Math.round(n.height*r);let o=t.getContext("2d"),s=Ni(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function Ni(t){let[e,n]=t.shape,r=document.createElement("canvas");[r.width,r.height]=[n,e];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*n+c+t.first[1]);s.data.set([...je(l),255],u)})),o.putImageData(s,0,0),r}function Vt(t,e){
let n=p("span",{class:"gradient"});return n.style.backgroundImage=Uo(),p("p",{class:"scale-of-rates small muted"},t,n,e)}var Ui=84;function Bo(t,e){let n=t.map((s,a)=>Bi(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),r.hidden=t.length<2,r}function Bi(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Ui/
Math.max(r,o),i=p("canvas",{"aria-hidden":"true"});jt(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),c=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Yn(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Di(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:d=>{c.setAttribute("aria-current",String(d));let m=n.hover.pursuer??n.selected.pursuer,h=n.hover.evader??n.selected.evader;
l.hidden=m>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-m-.5)*a}px`}}}var Di=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Yn(t,e,n){
let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var Fi=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function Do(){let t=Fi.map(([n,r])=>p("div",{class:"key-row"},p("dt",{},...n.map(o=>p("kbd",{},o))),p("dd",{},r))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",n=>n.target===e&&e.close()),e}function Fo(t,e,n,r,o,s){let a=(l,c)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.
inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:kn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let d=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(we(n.player,l)||d)d?.();else if(t[m])Yn(t[m],
m,e);else return;l.preventDefault()})}function zo(t,e,n,r,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!r()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("version").then(c=>c.text(),()=>null);l===null?o():l==="end"||l!==t&&a()?(zi(e,n),location.reload()):setTimeout(
()=>{i()},1e3)};i()}function zi(t,e){let{run:n,pursuer:r,evader:o}=e.selected,[s,a]=t[n].payoff.shape;r===s-1&&o===a-1&&history.replaceState(null,"",`#run=${n}`)}var Wi={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function qt(t,e,n){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:Wi[t.rules.interaction],
obstacles:e,moments:n}}function Kt(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function Yt(t){let e=Array.from({length:t.length+1},
(n,r)=>Gi(t,r));return qt(t.config,t.map,e)}function Gi(t,e){let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*n),alive:o(t.alive,e,n),captured:o(t.captured,e,r),everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,
e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var ji=Array.from({length:16},(t,e)=>{let[n,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function Ho(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:ji,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var Vi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Wo(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let n=document.createElementNS("http://www.w3.org/2000/svg","path");return n.setAttribute("d",Vi[t]),e.append(n),e}function mt(t,e,n,r){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Wo(t)),o.ariaLabel=e,o.title=`${e} (${n})`,o.addEventListener(
"click",r),o}function Ve(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let n=mt("play","Play","Space",()=>t.toggle()),
r=qi(t),o=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=Ki(t),a=document.createElement("output");a.className="player-count",e.append(mt("f\
irst","First step","Home",()=>t.move(-t.length)),mt("back","Step back","←",()=>t.move(-1)),n,mt("forward","Step forward","→",()=>t.move(1)),mt("last","Last \
step","End",()=>t.move(t.length)),p("div",{class:"scrub"},o,r),a,s);let i=()=>o.replaceChildren(...t.marks.map(c=>{let u=p("i");return u.style.left=`${100*c/Math.
max(1,t.length)}%`,u})),l=()=>{n.replaceChildren(Wo(t.playing?"pause":"play")),n.ariaLabel=t.playing?"Pause":"Play",n.title=`${n.ariaLabel} (Space)`,r.max=String(
t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==r)&&we(t,c)&&c.preventDefault()}),l(),e}function qi(t){let e=document.createElement("inp\
ut");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function Ki(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title=`Steps a second, or the whole in ${Ht} s (\
+ and -)`,e.append(new Option(`in ${Ht} s`,String(Ge)),...dt.map(n=>new Option(`${n} / s`,String(n)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),
e}var F=(t,e=2)=>t==null?"-":t.toFixed(e);function Zt(t,e,n,r=2){return e===null||n===null?t.toFixed(r):`${t.toFixed(r)} (${e.toFixed(r)} to ${n.toFixed(r)})`}var Go=t=>t.toLocaleString("en-GB");function ht(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}function xe(t,e,{pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,ee(e,"pursuer",n),ee(e,"evader",r),BigInt(s??a),o)}var jo=40,ft=new Map,gt=({run:t,pursuer:e,evader:n},r)=>`${t} ${e} ${n} ${r}`,Xt=class{element;#e;#r;#o=p("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=p("p",{class:"check small numbers","aria-live":"polite"});#n=0;constructor(e,n){[this.#e,this.#r]=[e,n],this.element=p("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(e,n,r){let{selected:o}=this.#e;o.seed===null&&ft.set(gt(o,o.episode),Vo(r)),this.#i(n),Zi(this.#n),this.#t(e,n)}#t(e,n){
let{selected:r}=this.#e,s=Ae(n,r.pursuer,r.evader)?.rates.findIndex((a,i)=>!ft.has(gt(r,i)))??-1;s<0||s>=jo||(this.#n=Yi(()=>{this.#e.selected===r&&(this.#r.playing||
(ft.set(gt(r,s),Vo(xe(e,n,{...r,episode:s,seed:null}))),this.#i(n)),this.#t(e,n))}))}#i(e){let{selected:n}=this.#e,r=Ae(e,n.pursuer,n.evader);if(!r){this.#o.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(jo,r.rates.length);this.#o.replaceChildren(...r.rates.slice(0,o).map(
(c,u)=>this.#u(c,u)));let s=r.rates.slice(0,o).map((c,u)=>ft.get(gt(n,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-r.rates[u])>1e-6||c.
length!==r.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===r.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<r.rates.length?`Played here: ${a.length} of ${r.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${F(l,3)}. The cell says ${F(r.rate,3)}.`}#u(e,n){let{selected:r}=this.#e,o=p("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${F(e)}`,"aria-label":`\
Episode ${n+1}, capture rate ${F(e)}`,"aria-pressed":String(n===r.episode&&r.seed===null),"data-played":ft.has(gt(r,n)),onclick:()=>this.#e.select({episode:n,seed:null})},
o,p("span",{class:"count"},n+1))}},Vo=t=>({rate:t.statistics.capture_rate,length:t.length}),Yi=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),Zi=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var ge=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,qe=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var qo=0,Ko=1,Xi=2,Ji=176;function Zo(t,e,n,r){let o=devicePixelRatio||1,s=We(t);t.width=t.height=Ji*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;n&&u<i*i;u++){let[d,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!n[f*i*i+u];h(Xi)&&(a.fillStyle=
s.obstacle,a.fillRect(d-l/2,m-l/2,l,l));let g=h(qo)&&h(Ko)?l*.18:0;h(qo)&&Yo(a,Te,d+g,m+g,l*.74,s.evader),h(Ko)&&Yo(a,Bt,d-g,m-g,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Yo(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var Jt=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#o=p("h3");#a=p("p",{class:"small muted"});#n=p("div",{class:"answers"});#t=null;#i=null;#u=null;#d=null;#c=null;#l=0;constructor(e){
this.#e=e,this.element=p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),p("div",{class:"inspected"},this.#r,p("div",{class:"answer"},this.#o,this.#a),this.#n))}get agent(){return this.#c}show(e,n,r,o){(this.#i!==n||
!this.#t)&&(this.#t?.free(),this.#t=e.world(n.world),this.#c!==null&&this.#i!==n&&this.choose(null)),[this.#i,this.#u,this.#d]=[n,r,o]}choose(e){this.#c=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let n=this.#u;if(!n)return;let r=this.#c??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+e+n.n_agents)%n.n_agents,n.alive[this.#l*n.n_agents+r])return this.choose(r)}at(e){this.#l=e;let[n,r,o,s,a]=[this.#u,this.#t,this.#i,this.#d,this.#c];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(p("span",{class:i},ge(a,n.config.n_pursuers)));let l=!!n.alive[e*
n.n_agents+a];n.seek(r,e),Zo(this.#r,n.config,l?r.view(a):null,a),this.#r.ariaLabel=`Field of view of ${ge(a,n.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<n.length?n.actions[e*n.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let u=ee(o,i,s[i]);if(typeof u=="string")return this.#s([],
`The script "${u}" plays for it${c===null?"":`; it goes ${qe[c]}`}.`);let{probabilities:d}=r.answer(u,a),m=Array.from(d,(g,f)=>Qi(qe[f],g,f===c)),h=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#s(m,c===null?"The episode is over.":h)}#s(e,n){this.#n.replaceChildren(
...e),this.#a.textContent=n}};function Qi(t,e,n){let r=p("span",{class:"filled"});return r.style.width=`${100*e}%`,p("div",{class:n?"action taken":"action"},p("\
span",{},t),p("span",{class:"track"},r),p("span",{class:"numbers"},e.toFixed(2)))}function Xo(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Zn="champion";var el=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Jo(t,e){return Object.keys(e).find(n=>el(e[n],t))??null}var yt="_",nl="n",Cd=2n**64n-1n;var Xn={fov:11,maxSteps:500,rewards:"paper"},rl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Jn(t,e){let n=i=>i.map(l=>sl(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=ol(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:es(
t.rules,e),others:t.others?es(t.others,e):"",rewards:o===Xn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Xn.fov?"":String(t.fov),
limit:t.maxSteps===Xn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(yt),pursuers:t.pursuers.map(Qo).join(yt),
evaders:t.evaders.map(Qo).join(yt),played:t.played.map(n).join(yt),next:t.next.every(i=>i===0)?"":n(t.next)};return rl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Qo({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function es(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Jo(t,e.variants)??n.join(".")}function ol(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(yt)}function sl(t,e){if(typeof t=="number")return String(t);if(t===Zn)return nl;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var al="/* the engine */";function ss(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Qn(t(),e)},"What if?")}function Qn(t,e){let n=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.match.config.
cols)<=64,r=n?Jn(il(t.match,t.step),e):"",o=new TextDecoder().decode(zn("playground")).replace(al,()=>It("script-engine")).replace("</noscript>",s=>n?s+Xo(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${r}`)}function il(t,e){let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,
c=o*n.n_evaders+i-n.n_pursuers,u=d=>i>=n.n_pursuers&&!!d[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,
fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}function Qt(t,e,n){if(n===0)return[{kind:"start",text:ll(t),agents:[]}];let[r,o]=[e.moments[n-1],e.moments[n]],s=u=>ge(u,t.config.n_pursuers),a=lt(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Nt(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:d,agents:m})=>({kind:u,text:d,agents:m}))),n===t.length&&c.unshift({kind:"\
end",text:cl(t),agents:[]}),c}function ll({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function cl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var ul=60,en=class{element;player=new fe(0,{speed:Ge,still:re()});inspector;actions;#e;#r;#o;#a;#n=p("h2",{class:"match-title"});#t=p("p",{class:"tally numbers"});#i=p(
"ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#u=p("p",{class:"problem",role:"alert"});#d=null;#c=null;#l=null;#s=null;#h=0;#f=!1;#p=0;constructor(e,n,r){
[this.#r,this.#o]=[e,n];let o=p("canvas",{"aria-label":"The match"});this.#e=new be(o,{numbers:!1}),this.#a=new Xt(n,this.player),this.inspector=new Jt(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"\
to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),
ss(()=>this.shown,r)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},
this.#n,this.#t),this.#u,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#i,Ho(),this.actions,this.inspector.element),Ve(this.player),this.#a.element)),
this.player.addEventListener("frame",()=>this.#s&&this.#e.show(this.#s,this.player.time)),this.player.addEventListener("step",()=>this.#b()),n.on("match",()=>this.#S()),
n.on("rest",()=>this.player.pause()),this.#v(),this.#w(0,0)}get#m(){return this.#r[this.#o.selected.run]}get match(){return this.#c}get recording(){return this.#s}reveal(){
this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.#c&&this.#l&&{match:this.#c,step:this.player.step,champions:this.#l}}start(e){this.#d=e,
this.#g()}playSoon(){this.#f=!0,this.#h||this.#y()}goTo(e){this.#p=e,!this.#h&&this.#c&&this.#g()}#y(){!this.#f||!this.#c||(this.#f=!1,this.player.jump(0),re()||
this.player.play())}#S(){this.#v(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#g(),ul)}#g(){clearTimeout(this.#h),this.#h=0,this.player.pause(),this.#v();
let{selected:e}=this.#o,n=De.map(s=>Ee(this.#m,s,e[s])).find(Boolean)??"";if(this.#u.textContent=n,n||!this.#d)return;this.#c=xe(this.#d,this.#m,e);let[r,o]=this.
names(e);this.#l={pursuer:{name:r,policy:ee(this.#m,"pursuer",e.pursuer)},evader:{name:o,policy:ee(this.#m,"evader",e.evader)}},this.#s=Yt(this.#c),this.#a.show(
this.#d,this.#m,this.#c),this.inspector.show(this.#d,this.#m,this.#c,e),this.player.length=this.#c.length,this.player.marks=oo(this.#s),this.player.jump(this.#p),
this.#p=0,this.#b(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#y()}names({run:e,pursuer:n,evader:r}){let{teams:o}=this.#r[e];
return[o.pursuer.script??`pursuers ${n}`,o.evader.script??`evaders ${r}`]}#v(){let{episode:e,seed:n}=this.#o.selected,{payoff:r}=this.#m,[o,s]=this.names(this.#o.
selected),a=n===null?e<r.episodes?`episode ${e+1} of ${r.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${n}`;this.#n.replaceChildren(p("span",{class:"\
pursuer"},o)," against ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#b(){let e=this.#c;if(!e||!this.#s)return;let n=this.player.step,r=this.#s.
moments[n];this.#w(Array.from(r.everCaptured).filter(Boolean).length,n),this.#i.replaceChildren(...Qt(e,this.#s,n).map(o=>p("li",{class:o.kind,"data-agents":o.agents.
join(" ")},o.text))),this.inspector.at(n),this.#M()}#w(e,n){this.#t.replaceChildren(p("strong",{},e),` of ${this.#m.world.n_evaders} captured`,p("span",{class:"\
muted"},` · step ${n}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let n of this.#i.children){let r=n.
dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}};var dl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},pl=5;function ke(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=dl[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,c]=n(),u=o.shiftKey?pl:1,{pursuer:d,evader:m}=e.selected;e.
select({pursuer:as(d+u*a,l),evader:as(m+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var as=(t,e)=>Math.min(e-1,Math.max(0,t));var ml=24,tn=7,ls=t=>t<ml&&matchMedia("(pointer: coarse)").matches;function cs(t,e,n,r){let[o,s]=t.payoff.shape,[a,i]=[is(e,o),is(n,s)],[l,c]=[Math.min(tn,o),Math.
min(tn,s)],u=[];for(let g=a+l-1;g>=a;g--){u.push(p("span",{class:"pursuer"},g));for(let f=i;f<i+c;f++)u.push(hl(t,g,f,r))}let d=Array.from({length:c},(g,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...u,m,...d);return h.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,h.addEventListener("click",g=>g.stopPropagation()),
h}function hl(t,e,n,r){let o=Ae(t,e,n)?.rate,s=p("button",{type:"button","aria-label":`${F(o)}: pursuers ${e} against evaders ${n}`,onclick:()=>r({pursuer:e,evader:n})},
F(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Gt(o),Wt(o)]),s}var is=(t,e)=>Math.max(0,Math.min(e-tn,t-Math.floor(tn/2)));var oe={left:52,bottom:46,top:76,right:84},ce=10,fl=160,vt=oe.right-ce-14,Re=oe.top-ce-14,nn=class{element;#e;#r;#o=p("canvas",{"aria-hidden":"true"});#a=M("svg",
{"aria-hidden":"true"});#n=M("g");#t;#i=p("h2");#u=p("strong",{class:"rate numbers"});#d=p("span",{class:"small muted"});#c=p("p",{class:"of-both-teams small mu\
ted numbers"});#l=null;constructor(e,n){[this.#r,this.#e]=[e,n],this.#t=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#o,this.#a);let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#i,this.#c),p("div",{class:"of-cell"},this.#u,this.#d));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#t,Vt("0 all escape","1 all caught")),this.#y(),new ResizeObserver(()=>this.#h()).
observe(this.#t),this.#t.addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>n.point({})),this.#t.addEventListener("click",
o=>this.#b(o)),this.#t.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ke(this.#t,
n,()=>this.#s.payoff.shape),this.#t.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),n.on("run",()=>this.#h()),n.on("match",()=>this.#m()),n.on("hove\
r",()=>this.#m())}get#s(){return this.#r[this.#e.selected.run]}#h(){let[e,n]=this.#s.payoff.shape,{clientWidth:r,clientHeight:o}=this.#t;if(r<50)return;let a=Math.
max(fl,Math.min(r-oe.left-oe.right,o-oe.top-oe.bottom))/Math.max(e,n),i=Math.max(oe.left,(r-n*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(o-oe.top-oe.bottom-e*a)/
2),c={width:r,height:o,left:i,top:l,cell:a,rows:e,columns:n};this.#l=c,jt(this.#o,this.#s.payoff,{left:i,top:l,width:n*a,height:e*a}),this.#a.setAttribute("view\
Box",`0 0 ${r} ${o}`),this.#a.replaceChildren(gl(c),...yl(c),...this.#p(c),this.#n),this.#m()}#f(e){let n=this.#s.findings?.generalization;if(!n)return[];let{selected:r,
hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??r.evader],[i,l]=us(e,n.pursuers.mean[s]??0,s),[c,u]=ds(e,n.evaders.mean[a]??0,a);return[M("circle",{class:"\
dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#p(e){let n=this.#s.findings?.generalization;if(!n)return[];let{left:r,top:o,
cell:s,rows:a,columns:i}=e,[l,c]=[r+i*s+ce,o-ce],u={class:"side"};return[M("rect",{...u,x:l,y:o,width:vt,height:a*s}),M("rect",{...u,x:r,y:c-Re,width:i*s,height:Re}),
...ps(n.pursuers,(d,m)=>us(e,d,m),"of-pursuers"),...ps(n.evaders,(d,m)=>ds(e,d,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),
M("text",{class:"tick",x:l+vt,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:r-6,y:c-4,"text-anchor":"end"},"0"),M("text",{class:"tick",x:r-6,y:c-
Re+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+vt,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-evaders",x:r+i*s+
ce,y:c-Re+10,"text-anchor":"start"},"escapes")]}#m(){let e=this.#l;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+
(i-1-g)*a,u=[],d=(g,f)=>M("rect",{class:f,x:o,y:c(g),width:l*a+ce+vt,height:a}),m=(g,f)=>M("rect",{class:f,x:o+g*a,y:s-ce-Re,width:a,height:ce+Re+i*a});if(u.push(
d(n.pursuer,"strip pursuer"),m(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(d(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(m(
r.evader,"strip hover")),r.lag!==null)for(let g=0;g<l;g++){let f=g+r.lag;f>=0&&f<i&&u.push(M("rect",{class:"lagged",x:o+g*a,y:c(f),width:a,height:a}))}u.push(...this.#f(
e));let h={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};u.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"chosen",...h})),this.#n.replaceChildren(
...u),this.#y()}#y(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=Ae(this.#s,r,o);this.#i.replaceChildren(p("span",{class:"purs\
uer"},`Pursuers ${r}`)," against ",p("span",{class:"evader"},`evaders ${o}`)),this.#u.textContent=s?F(s.rate,3):"-",this.#d.textContent=s?`capture rate, mean of\
 ${s.rates.length} episodes`:"the evaluation played no episodes",this.#c.textContent=this.#S(r,o)}#S(e,n){let r=this.#s.findings?.generalization;if(!r)return"";
let o=(s,a)=>Zt(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(r.pursuers,e)}, escapes ${o(r.evaders,n)}`}#g(e){let n=this.#l;
if(!n)return null;let r=this.#t.getBoundingClientRect(),o=Math.floor((e.clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-r.top-n.top)/n.cell),[a,
i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let n=this.#g(e);this.#e.point(n?{pursuer:n.g<0?null:n.g,evader:n.h<
0?null:n.h}:{})}#b(e){let n=this.#g(e);if(n){if(n.inside&&ls(this.#l.cell))return this.#w(n.g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.g},...n.h<0?{}:{evader:n.
h}}),n.inside&&this.#x()}}#w(e,n){let r=cs(this.#s,e,n,o=>{r.remove(),o&&(this.#e.select(o),this.#x())});this.#t.append(r)}#x(){this.#t.dispatchEvent(new CustomEvent(
"play",{bubbles:!0}))}};function gl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"axes"}),a=e+r*n,i=l=>ht(0,l-1,Math.min(l,l*n/44),!0);for(let l of i(
o))s.append(M("text",{class:"tick",x:t+(l+.5)*n,y:a+16,"text-anchor":"middle"},l));for(let l of i(r))s.append(M("text",{class:"tick",x:t-7,y:a-(l+.5)*n,"text-an\
chor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*n/2,y:a+36,"text-anchor":"middle"},"evader generation"),M(
"text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function yl({left:t,top:e,
cell:n,rows:r,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;for(let u of["H","V"]){let d=`M${t} ${i}`;for(let m=1;m<=a;m++){
let[h,g]=[`H${t+m*n}`,`V${i-m*n}`];d+=u==="H"?h+g:g+h}s.append(M("path",{d,class:"under"}),M("path",{d}))}let[l,c]=[t+a/2*n-.7*n-4,i-a/2*n-.7*n-4];return[s,M("t\
ext",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var us=({left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[
t+o*n+ce+s*vt,e+(r-a-.5)*n],ds=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-ce-r*Re];function ps(t,e,n){let r=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].join("L")}Z`})),o.push(M("path",{class:`line ${n}`,
d:`M${r(t.mean).join("L")}`})),o}function V(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}function ms(t,e,n){let{findings:r}=t;if(!r?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&bl(o,t,i,e,
l)},a=r.checkerboards.map(i=>vl(t,i,s));return{element:V("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Cli\
ck one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?
p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise m\
akes."):null,o)}}var hs=({pursuers:[t,e],evaders:[n,r]})=>[[t,n],[t,r],[e,n],[e,r]];function vl(t,e,n){let[r,o]=e.pursuers,[s,a]=e.evaders,i=hs(e).map(([l,c])=>{
let u=t.payoff.capture_rate[l][c],d=p("span",{class:"cell"},F(u));return d.style.backgroundColor=Gt(u),d.style.color=Wt(u),d});return p("button",{type:"button",
class:"miniature numbers",onclick:()=>n(e)},p("span",{},p("span",{class:"heard"},`Four matches of pursuers ${r} and ${o}, evaders ${s} and ${a}:`)),p("span",{class:"\
evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},r),i[0],i[1],p("span",{class:"pursuer"},o),i[2],i[3])}function bl(t,e,n,r,o){let s=hs(n).filter(
([m,h])=>!Ee(e,"pursuer",m)&&!Ee(e,"evader",h)),a=s.map(([m,h])=>xe(o,e,{run:r.selected.run,pursuer:m,evader:h,episode:0,seed:null})),i=new fe(Math.max(0,...a.map(
m=>m.length)),{speed:Ge,still:re()}),l=a.map((m,h)=>{let[g,f]=s[h],v=p("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),b=p("span",{class:"numbers"}),
S=()=>{t.close(),r.select({pursuer:g,evader:f})},y=p("figure",{},v,p("figcaption",{class:"small"},b,p("span",{class:"muted"},`cell ${F(e.payoff.capture_rate[g][f])}`),
p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));return y.style.gridArea=`${n.pursuers.indexOf(g)+2} / ${n.evaders.indexOf(f)+2}`,{element:y,
match:m,recording:Yt(m),board:new be(v,{numbers:!1}),tally:b}}),c=()=>l.forEach(m=>m.board.show(m.recording,i.time)),u=()=>l.forEach(({recording:m,match:h,tally:g})=>{
let f=m.moments[Math.min(i.step,h.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener(
"frame",c),i.addEventListener("step",u),t.replaceChildren(p("header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},
"Close")),p("div",{class:"grid-of-four"},p("span"),...n.evaders.map(m=>p("h3",{class:"evader"},`evaders ${m}`)),...n.pursuers.map((m,h)=>{let g=p("h3",{class:"p\
ursuer"},`pursuers ${m}`);return g.style.gridArea=`${h+2} / 1`,g}),...l.map(m=>m.element)),Ve(i));let d=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof
HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&we(i,m)&&m.preventDefault()};t.addEventListener("keydown",d),t.addEventListener("close",()=>{t.removeEventListener(
"keydown",d),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},{once:!0}),r.dispatchEvent(new Event("rest")),t.showModal(),c(),u(),re()||i.play()}var rn={pursuer:"evader",evader:"pursuer"};function fs(t,e){let n=t.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${F(s)}, stripes ${F(a)}${i===null?"":` every ${i} generations`}`;return wl(t,o,l,e)});return{element:V("CIAO: current individuals against ancestr\
al opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier stra\
tegies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element)),Vt("0 loses","1 wins")),
update:()=>r.forEach(o=>o.update())}}function wl(t,e,n,r){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(y,w)=>e==="pursuer"?t.payoff.
capture_rate[y][w]:1-t.payoff.capture_rate[w][y],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let y=0;u&&
y<s;y++)for(let w=0;w<=Math.min(y,a-1);w++)u.data.set([...je(i(y,w)),255],4*((s-1-y)*a+w));u&&c?.putImageData(u,0,0);let d=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,d),g=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${n}. Arrow keys choose a match.`},l,h);ke(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=y=>{let w=g.
getBoundingClientRect(),A=Math.floor((y.clientX-w.left)/w.width*a),T=s-1-Math.floor((y.clientY-w.top)/w.height*s);return A>=0&&T<s&&A<=T?[T,A]:null},v=y=>({[e]:y[0],
[rn[e]]:y[1]});g.addEventListener("pointermove",y=>r.point(f(y)?v(f(y)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",y=>f(
y)&&r.select(v(f(y))));let b=()=>{let y=r.hover[e]??r.selected[e],w=r.hover[rn[e]]??r.selected[rn[e]];for(let A of[d,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-y)),A.style.display=w<=y?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),g,p("p",{class:"smal\
l muted"},`horizontal: ${rn[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},n)),update:b}}var on={left:46,right:12,top:10,bottom:42},gs={x:56,y:34};function sn(t,e,n,r){let[o,s]=[on.left,on.top],a=Math.max(o+40,t-on.right),i=Math.max(s+40,e-on.bottom),
l=(f,v,b)=>S=>v+(S-f.low)/(f.high-f.low||1)*(b-v),[c,u]=[l(n,o,a),l(r,i,s)],d=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of ht(r.low,r.high,(i-s)/gs.y,r.whole))h.append(M("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),M("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},ys(f)));for(let f of ht(n.low,n.high,(a-o)/gs.x,n.whole))h.append(M("text",{x:c(f),y:i+16,"text-anchor":"middle"},ys(f)));return h.
append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},n.label),M("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),m.append(h,d),{root:m,marks:d,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let v=f-m.getBoundingClientRect().
left;return n.low+(v-o)/(a-o)*(n.high-n.low)}}}var ys=t=>String(Number(t.toPrecision(6))).replace("-","−");function bt(t,e,n,r){let o="",s="M";n.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=M("path",{d:o,class:`line ${r}`});return t.root.insertBefore(a,t.marks),a}function wt(t,e,n,r=null){let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(M("circle",{cx:o,cy:t.
y(r),r:5,class:`dot ${n}`}))}function er(...t){return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function an(t,e,n={}){let r=p(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&n.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=r;i<50||l<50||
(o=e(i,l),r.replaceChildren(o.root),s())};return r.addEventListener("pointermove",i=>n.point?.(o?.at(i.clientX)??null)),r.addEventListener("pointerleave",()=>n.
point?.(null)),n.choose&&(r.classList.add("chooses"),r.addEventListener("click",i=>o&&n.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(r),{element:r,
redraw:a,remark:s}}var tr=["of-pursuers","of-evaders","of-both"],xl=2500,vs="Arrow keys choose generations.",bs={low:0,high:1,label:"capture rate"};function ws(t,e){let{training:n}=t,
{capture_rate:r,generation:o,learner:s,epochs:a}=n,i=r.map((g,f)=>(f+1)*a),l=Sl(r,n.window),c=i.at(-1)??1,u=i.length>xl?"dense":"",d=(g,f)=>{let v=o.flatMap((b,S)=>b===
g&&(s[S]===f||s[S]===2)?[S]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},m=an(`Capture rate in ${c} epochs of training. ${vs}`,(g,f)=>{let v=sn(g,f,{low:0,high:c,
label:"epoch",whole:!0},bs);for(let[b,S]of[["raw",r],[u,l]])for(let[y,w]of tr.entries()){let A=S.map((T,E)=>s[E]===y||s[E+1]===y?T:null);A.some(T=>T!==null)&&bt(
v,i,A,`${w} ${b}`)}return v},{marks:g=>{let{pursuer:f,evader:v}=e.selected;for(let[b,S]of[[0,f],[1,v]]){let y=d(e.hover[b?"evader":"pursuer"]??S,b);y&&wt(g,(y[0]+
y[1])/2,tr[b])}},choose:g=>{let f=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),v=o[f];s[f]!==1&&e.select({pursuer:Math.min(v,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(v,t.payoff.shape[1]-1)})}});ke(m.element,e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders lear\
n","both teams learn"][g],tr[g]]);return{element:V("Training",`${Go(n.matches)} training matches. Lines: the generations that are selected.`,er(...h),m.element),
update:m.remark}}function xs(t,e){let n=t.findings?.lags;if(!n)return null;let[r,o]=[n.lags[0],n.lags.at(-1)],s=Math.min(5,(Math.max(...n.cells)+1)/2),a=n.means.
map((l,c)=>n.cells[c]>=s?l:null),i=an("Lag profile",(l,c)=>{let u=sn(l,c,{low:r,high:o,label:"lag: pursuer minus evader generation",whole:!0},bs);return bt(u,n.
lags,n.means,"raw ink"),bt(u,n.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=e.selected;wt(l,0,"zero");let d=e.hover.lag??c-u;wt(l,d,"ink",n.means[d-r])},
point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=r&&c<=o?c:null})}});return{element:V("Lag profile","Left: evaders are later. Right: pursue\
rs are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function Ss(t,e){let n=t.findings?.ratings;if(!n)
return null;let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.
max(...t.payoff.shape)-1,c=an(`Elo ratings by generation. ${vs}`,(u,d)=>{let m=sn(u,d,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo po\
ints"});for(let h of["pursuer","evader"])bt(m,r[h].map((g,f)=>f),r[h],`of-${h}s`);return m},{marks:u=>{for(let d of["pursuer","evader"]){let m=e.hover[d]??e.selected[d];
wt(u,m,`of-${d}s`,r[d][m]??null)}},choose:(u,d,m)=>{let h=Math.round(u),g=m.clientY-d.root.getBoundingClientRect().top,f=b=>Math.abs(d.y(r[b][h]??1/0)-g),v=f("p\
ursuer")<=f("evader")?"pursuer":"evader";h>=0&&h<r[v].length&&e.select({[v]:h})}});return ke(c.element,e,()=>t.payoff.shape),{element:V("Ratings",`One number fo\
r each generation, which cycles do not fit. The game itself: ${F(n.offset,0)} points for the pursuers.`,er(["pursuers","of-pursuers"],["evaders","of-evaders"]),
c.element),update:c.remark}}function Sl(t,e){let n=[0];for(let r of t)n.push(n.at(-1)+r);return t.map((r,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(
t.length,o+Math.floor(e/2)+1)];return(n[a]-n[s])/(a-s)})}var Ml={present:"●",absent:"○","cannot tell":"?"};function Ms(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],c)=>{
let u=Al(e.reasons[c]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Ml[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=V("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${As(s)}.`)),p("ul",{class:"findings"},...r),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function Al(t){let[,e=""]=t.split(/, because (.*)/s);return As(e.replace(/\.$/,""))}var As=t=>t.charAt(0).toUpperCase()+t.slice(1);function Es(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(n=>n!=null);return e.length?{element:V("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(El))}:null}function El(t){let e=r=>r.at(-1),n=[["mean",e(t.mean)],...Object.
entries(t.against).map(([r,o])=>[r,e(o)])];return p("table",{class:"scores numbers"},p("caption",{},p("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...n.map(([r,o],s)=>p("tr",{class:s?"":"mean"},p("th",{scope:"row"},r),p("td",{class:"range"},Cl(o,t.team)),p("td",{},Zt(o.value,o.low,o.high)))))}
function Cl({value:t,low:e,high:n},r){let o=p("span",{class:`between ${r}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((n??t)-(e??t))}%`;let s=p("span",
{class:`value ${r}`});return s.style.left=`${100*t}%`,p("span",{class:"scale","aria-hidden":"true"},o,s)}function Ts(t){let e=t.settings.filter(o=>o.changed),n=t.settings.filter(o=>!o.changed),r=V("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?Cs(e,"other than the default"):p("p",{class:"small"},"All settings are the defaults."),p("details",{class:"small"},p("summary",
{},`${n.length} settings with their defaults`),Cs(n,"defaults")));return r.classList.add("settings"),{element:r}}function Cs(t,e){return p("div",{class:"wide-ta\
ble"},p("table",{class:"small"},p("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:n,value:r,help:o})=>p("tr",{},p("th",{scope:"row"},`--${n.replaceAll(
"_","-")}`),p("td",{class:"numbers"},r),p("td",{class:"muted"},o)))))}function ks(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??Tl(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function Tl(t,e,n){return[Ms(t),ws(t,e),ms(t,e,n),xs(
t,e),Ss(t,e),fs(t,e),Es(t),Ts(t)].filter(o=>o!==null)}var dn=wa(zs(),1);var ar=125,Yl=80,Zl=10,Hs=480,Xl=[1,.8,.6,.4,.2],Jl=5;async function Ws(t,e){let n=Math.min(1,ut(t.rows,t.cols)),[r,o]=[Math.round(Hs*n),Math.round(Hs*n/ut(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[r,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=We(document.documentElement),l={ctx:a,colors:i,
grid:zt(t.rows,t.cols,!1,r,o,1)},[c,u]=[Ql(i,a),(0,dn.GIFEncoder)()];for(let d=0;d<ar;d++){let m=Math.min(1,d/(ar-Zl))*(t.moments.length-1);Ft(l,t,m,{...Dt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,r,o),a.globalCompositeOperation="source-over",u.writeFrame((0,dn.applyPalette)(
a.getImageData(0,0,r,o).data,c),r,o,{palette:c,delay:Yl}),d%Jl===0&&(e(Math.round(100*d/ar)),await new Promise(h=>setTimeout(h)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function Ql(t,e){let n=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),r=n(t.
paper);return Object.values(t).map(n).flatMap(o=>Xl.map(s=>o.map((a,i)=>Math.round(r[i]+s*(a-r[i])))))}function Gs(t,e){let n=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),r=p("p",{class:"muted small",role:"status"}),o=async()=>{n.select();
try{await navigator.clipboard.writeText(n.value),r.textContent="Copied."}catch{r.textContent="Selected: copy it with Ctrl+C."}},a=p("button",{type:"button",class:"\
save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:c,evader:u}=e.selected;a.disabled=!0;let d=await Ws(t.recording,h=>r.textContent=`Drawing: ${h} %`),
m=URL.createObjectURL(d);p("a",{href:m,download:`pursuers-${c}-evaders-${u}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(m),6e4),r.textContent=`Saved, ${(d.
size/1e6).toFixed(1)} MB.`,a.disabled=!1}},"Save the match as a GIF of 10 s"),i=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{id:"share-tit\
le"},"Share this match"),a,p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),p("div",{class:"link"},n,p("button",{type:"button",
onclick:o},"Copy")),r,p("button",{type:"button",onclick:()=>i.close()},"Close"));return i.addEventListener("click",c=>c.target===i&&i.close()),{button:p("button",
{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),n.value=location.href,r.textContent="",i.showModal()}},"Share"),dialog:i}}var js={pursuer:null,evader:null,lag:null},pn=class extends EventTarget{#e;#r=js;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...js,...e};n.pursuer===this.#r.pursuer&&n.evader===this.#r.evader&&n.lag===this.#r.lag||
(this.#r=n,this.dispatchEvent(new Event("hover")))}on(e,n){this.addEventListener(e,n)}};var mn=class{config;start;recording;actions=[];#e;#r;#o=[[]];constructor(e,n,r){[this.config,this.start]=[n,r],this.#e=e.world(n),this.#e.reset(r),this.#r=[Kt(this.#e)],
this.recording=qt(n,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}play(e){this.#e.step(e),this.#a(e)}step(e,n,r){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,[Math.max(l,s),c],a)),typeof r==
"number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#r.push(Kt(this.#e,e)),this.#o.push(this.#e.conflicts())}};var ye=(t,e)=>De[+(e>=t.n_pursuers)];function ir(t,e){let n=new mn(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.
seat,r);return n}function Ke(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var hn=(t,e)=>t.over||Ke(t,e).out;function Vs(t,e,n){let r=ir(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!hn(r,e.seat);)r.step(e.policies,e.seat,n);return Ke(r,e.seat)}function qs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}
function Ks(t,{seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Ys(t,e){let[n,r,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function Zs(t,e,n,r){let o=ye(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,d]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},c),p("td",{class:"track","aria-hidden":"true"},u),d)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,
d.textContent=String(o?m:h)}};i("You")(Ke(e,n.seat));for(let{name:c,policy:u}of r){let d=i(c);setTimeout(()=>d(Vs(t,n,u())))}let l=n.from?`You took over at step\
 ${n.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Xs=()=>["file:","http:","https:"].includes(location.protocol);var Js=["·","↑","→","↓","←","↗","↘","↙","↖"];var tc={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},lr=[8,1,5,4,0,2,7,3,6],nc=[7,8,9,4,5,6,1,2,3],rc=24,oc=Math.
tan(Math.PI/8);function ea(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=nc.findIndex(o=>t.code===`Numpad${o}`),r=lr[n]??tc[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function ta(t){let e=lr.map(n=>p("button",{type:"button","aria-label":qe[n],onclick:()=>t(n)},Js[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",lr[o]>4&&!n))}}function Qs(t,e,n){let r=oc*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return no([0,0],n?[o(t),o(e)]:[t,e],n)}function na(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,e()];if(r=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(c,u)>=rc?n(Qs(u,c,l.diagonal)):d&&n(Qs(d[0]-l.cell[0],
d[1]-l.cell[1],l.diagonal))})}function ra(t,e){let n=r=>{let o=e[r]-t[r],s=Fe.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${qe[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var aa="NUMPY\0",oa=aa.length+2,sa=64;function ia(t){return Jr(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,sc(n)])))}function sc({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((oa+s.length+1)/sa)*sa-oa,i=aa+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set($t(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var ac="matrixworld episode 3";function la(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},m=y=>{
for(let w of Object.keys(y))(d[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(r);h.reset(e.start);let g=[];m(c);for(let y of o)h.step(y),m({...c,...u}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[y,[w,...A]]of Object.entries({...c,...u})){let T=s+
+(y in c);v[y]={dtype:w,shape:[T,...A],data:f[w].from((d[y]??[]).flat())}}let b=y=>({dtype:"<i8",shape:[],data:Int32Array.of(y,0)}),S=y=>({dtype:"<U",shape:[],data:y});
return ia({format:S(ac),n_pursuers:b(r.n_pursuers),config:S(JSON.stringify(r)),seat:b(n),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(y=>[
...y]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var ic=[0,1,2,4,8],fn=class{element;player=new fe(0,{speed:4,still:re()});#e;#r;#o=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=p("h2");#n=p("p",{
class:"play-told",role:"status"});#t=ta(e=>this.act(e));#i=p("select",{},...ic.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#u=p("input",{type:"ch\
eckbox"});#d=p("section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#c=Ve(this.player);#l=null;#s=null;#h=[];#f=null;#p=0;#m=0;constructor(e){
this.#e=e,this.#r=new be(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#g()),this.#u.addEventListener(
"change",()=>this.#S()),na(this.#r,()=>{let n=this.#f!==null&&this.#s&&L(this.#s.recording.moments.at(-1),this.#f);return n?{cell:n,diagonal:this.#s.config.diagonal}:
null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#s&&this.#r.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#M()),
this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#a,this.#n),p("div",{class:"play-stage"},this.#o),p("div",{class:"play-side"},this.#d,this.#t.
element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),p("label",{class:"play-choice"},this.#u," Fog: see only what it sees"),p("p",{class:"\
small muted play-keys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or t\
ap where to go.")),this.#c)}get played(){return this.#l&&{...this.#l.played,moves:this.#h}}get live(){return this.#s}play(e){this.#y(ir(this.#e,e.played),e.played.
seat,e.title),[this.#l,this.#h,this.#p]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),hn(this.#s,e.played.seat)&&
this.#b()}watch(e,n,r){this.#l=null,this.#y(e,n,r),this.#w()}stop(){this.#g(),this.player.pause(),this.#l=null}act(e){let[n,r]=[this.#l,this.#s];if(!n||!r||this.
element.dataset.state!=="playing")return;this.#p=e;let o=Number(this.#i.value);this.#m||(this.#v(),o&&this.element.dataset.state==="playing"&&(this.#m=setInterval(
()=>this.#v(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&
(r===" "||r==="Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return we(this.player,e);let s=ea(e,this.#s.config.diagonal);return s!==void 0&&
this.act(s),s!==void 0}#y(e,n,r){this.#g(),this.player.pause(),[this.#s,this.#f]=[e,n],this.#a.textContent=r,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.
cols} cells`,this.#t.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#S(),this.#M()}#S(){this.#r.look=
{you:this.#f,fog:this.#u.checked,viewers:this.#f===null?[]:[this.#f]}}#g(){clearInterval(this.#m),this.#m=0,this.#n.ariaLive=Number(this.#i.value)?"off":"polite"}#v(){
let[{policies:e,seat:n},r]=[this.#l.played,this.#s];r.step(e,n,this.#p),this.#h.push(this.#p),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#i.value)||4)),this.player.move(r.length-this.player.step),hn(r,n)&&this.#b()}#b(){this.#g();let[e,n,r]=[this.#l,this.#s,this.played],o=Xs()?e.link(r):null;
this.#d.replaceChildren(p("h3",{id:"play-headline"},uc(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.
again()},"Again"),p("button",{type:"button",onclick:()=>this.#w()},"Watch it"),p("button",{type:"button",onclick:()=>this.#x(n,r.seat)},"Save"),o&&p("button",{type:"\
button",onclick:({currentTarget:s})=>pc(s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"near\
est"})}#w(){this.element.dataset.state="watched",this.player.length=this.#s.length,this.player.jump(0),re()||this.player.play()}#x(e,n){let r=new Blob([la(this.#e,
e,n)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(r),download:`${ge(n,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#M(){let[e,n,
{step:r}]=[this.#s,this.#f,this.player];if(!e||r>e.length)return;let o=Qt(e,e.recording,r).filter(({agents:a})=>n===null||a.includes(n)),s=[`Step ${r} of ${e.config.
max_steps}`,...o.map(({text:a})=>a)];this.#l&&r===0?s.push(lc(e.config,n)):n!==null&&s.push(cc(e,r,n)),this.#n.textContent=s.filter(Boolean).map(a=>`${a}.`).join(
" ")}};function lc(t,e){let n=t.rules.capture==="SURROUND";return ye(t,e)==="evader"?`Stay free: ${n?"pursuers on all sides of you capture":"a pursuer on your c\
ell captures"} you`:`Capture evaders: ${n?"surround them together":"reach their cell"}`}function cc({config:t,recording:e},n,r){let o=e.moments[n],a=ye(t,r)==="\
pursuer"?"evader":"pursuer";if(!o.alive[r])return"";let i=L(o,r),l=d=>{let[m,h]=L(o,d);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.
alive.length},(d,m)=>m).filter(d=>ye(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((d,m)=>l(
m)<l(d)?m:d);return`Nearest ${a}: ${ra(i,L(o,u))}`}function uc(t,e){let[{lasted:n,out:r,captured:o},{config:s}]=[Ke(t,e),t];return ye(s,e)==="pursuer"?`Your tea\
m captured ${o} of ${dc(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var dc=({n_evaders:t})=>`${t} evader${t===1?
"":"s"}`;function pc(t,e){let n=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(n),n.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}var gn=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#r;#o;#a=null;#n=null;constructor(e,n,r){[this.#e,this.#r,this.#o]=[e,n,r],r.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#n?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#n?.stop())}get view(){return this.#n}start(e,n){this.#a=e;let r=ot(n,this.#e,this.#r.selected),o=Ys(new URLSearchParams(n.replace(/^#/,"")),this.#e[r.
run].world);o&&this.#t(r,o)}open(){let e=this.#o.shown;if(!e)return;let{match:n,step:r}=e;this.#o.player.pause();let o=this.#o.inspector.agent,s=r<n.length?r:0,
a=(d,m)=>!!n.alive[m*n.n_agents+d],i=Array.from({length:n.n_agents},(d,m)=>(m+n.config.n_pursuers)%n.n_agents),l=o??i.find(d=>a(d,s)),c=a(l,s)?s:0,u=Array.from(
{length:c},(d,m)=>n.actions[m*n.n_agents+l]);this.#t(this.#r.selected,{seat:l,from:c,moves:u})}#t(e,n){let[r,o]=[this.#a,this.#e[e.run]];if(!r||De.some(m=>Ee(o,
m,e[m])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,u=ye(o.world,n.seat),d=o.teams[u].kept.map(m=>({name:o.teams[u].script??`generation ${m}`,policy:()=>ee(
o,u,m)}));this.#n||(this.#n=new fn(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#n.element)),this.
dialog.open||this.dialog.showModal(),this.#n.play({title:`You are ${ge(n.seat,o.world.n_pursuers)}: ${this.#o.names(e).join(" against ")}`,played:{config:o.world,
seed:BigInt(c??o.seeds[a][i]),episode:l,...n,policies:{pursuer:ee(o,"pursuer",a),evader:ee(o,"evader",i)}},ending:(m,h)=>[Zs(r,m,h,qs(d))],again:()=>this.#t(e,{
...n,moves:n.moves.slice(0,n.from)}),link:m=>Ks({run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}},m)})}};var ue=eo(),{runs:X}=ue,[mc,hc]=X[0].payoff.shape,fc=ot(location.hash,X,{run:0,pursuer:mc-1,evader:hc-1,episode:0,seed:null}),{step:ua,...gc}=fc,Z=new pn(gc),z=new en(
X,Z,ue.playground),da=new nn(X,Z),Ze=new gn(X,Z,z),cr=Do(),yc=location.hash,ca=No(X,Z,z),{button:vc,dialog:bc}=Gs(z,Z);z.actions.append(vc);var Ye=null,pa=p("as\
ide",{class:"note small muted"},ue.note),wc="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";
document.getElementById("page").replaceWith(p("header",{class:"top"},p("div",{},p("h1",{},ue.heading),p("p",{class:"lead"},wc)),p("div",{class:"tools"},ca.button,
Nr(),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>cr.showModal()},"?"))),...ue.note?[pa]:[],Bo(X,Z),p("mai\
n",{class:"stages"},da.element,z.element),ks(X,Z,()=>Ye),p("footer",{class:"muted small"},`${ue.title} · matrixworld ${ue.version}`),Ze.dialog,cr,bc,ca.bar);Object.
assign(window,{matrixworldExplorer:{get match(){return z.match},get step(){return z.player.step},get pace(){return z.player.pace},get playing(){return Ze.view},
play:t=>Ye&&xe(Ye,X[Z.selected.run],{...Z.selected,episode:t}),get shape(){return X[Z.selected.run].payoff.shape}}});da.element.addEventListener("play",()=>{z.playSoon(),
z.reveal()});z.goTo(ua);ua||z.playSoon();Ur(X,Z,z);Fo(X,Z,z,cr,()=>Ze.open(),()=>Qn(z.shown,ue.playground));window.addEventListener("hashchange",({newURL:t})=>Ye&&
Ze.start(Ye,new URL(t).hash));ue.live!==null&&zo(ue.live,X,Z,()=>z.player.playing||Ze.dialog.open,()=>{pa.textContent="The command has ended. This page shows wh\
at it had played; explorer.html is beside the runs if they have finished."});requestAnimationFrame(()=>setTimeout(()=>{Lr().then(t=>{Ye=t,z.start(t),Ze.start(t,
yc),document.body.dataset.ready="true"},t=>{z.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.
dataset.ready="true"})}));})();
