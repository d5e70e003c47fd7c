/* built from web/ by "npm run build"; sources 5925afb4c26599a5fc1719b3c920a737b371341c25782e5e9500e9b854ee73ef */
"use strict";(()=>{var la=Object.create;var cr=Object.defineProperty;var ca=Object.getOwnPropertyDescriptor;var ua=Object.getOwnPropertyNames;var da=Object.getPrototypeOf,pa=Object.prototype.hasOwnProperty;var ma=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(n){throw e=0,n}};var ha=(t,e,n,r)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of ua(e))!pa.call(t,o)&&o!==n&&cr(t,o,{get:()=>e[o],enumerable:!(r=ca(e,o))||r.enumerable});
return t};var fa=(t,e,n)=>(n=t!=null?la(da(t)):{},ha(e||!t||!t.__esModule?cr(n,"default",{value:t,enumerable:!0}):n,t));var Bs=ma(rr=>{var Rs=Object.defineProperty,Sl=t=>Rs(t,"__esModule",{value:!0}),Ml=(t,e)=>{for(var n in e)Rs(t,n,{get:e[n],enumerable:!0})};Sl(rr);Ml(rr,{GIFEncoder:()=>Ns,
applyPalette:()=>Pl,default:()=>Hl,nearestColor:()=>Nl,nearestColorIndex:()=>Ls,nearestColorIndexWithDistance:()=>Os,prequantize:()=>_l,quantize:()=>Rl,snapColorsToPalette:()=>Ol});
var Al={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function $s(t=256){let e=0,n=new Uint8Array(t);return{get buffer(){return n.buffer},reset(){e=0},bytesView(){return n.subarray(0,e)},bytes(){return n.slice(0,e)},
writeByte(o){r(e+1),n[e]=o,e++},writeBytes(o,s=0,a=o.length){r(e+a);for(let i=0;i<a;i++)n[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){r(e+a),n.set(o.subarray(
s,s+a),e),e+=a}};function r(o){var s=n.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=n;n=new Uint8Array(
o),e>0&&n.set(i.subarray(0,e),0)}}var er=12,Cs=5003,El=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Cl(t,e,n,r,o=$s(512),s=new Uint8Array(
256),a=new Int32Array(Cs),i=new Int32Array(Cs)){let l=a.length,c=Math.max(2,r);s.fill(0),i.fill(0),a.fill(-1);let u=0,d=0,m=c+1,h=m,g=!1,f=h,v=(1<<f)-1,b=1<<m-1,
S=b+1,y=b+2,w=0,A=n[0],T=0;for(let x=l;x<65536;x*=2)++T;T=8-T,o.writeByte(c),C(b);let E=n.length;for(let x=1;x<E;x++)e:{let P=n[x],$=(P<<er)+A,k=P<<T^A;if(a[k]===
$){A=i[k];break e}let J=k===0?1:l-k;for(;a[k]>=0;)if(k-=J,k<0&&(k+=l),a[k]===$){A=i[k];break e}C(A),A=P,y<1<<er?(i[k]=y++,a[k]=$):(a.fill(-1),y=b+2,g=!0,C(b))}return C(
A),C(S),o.writeByte(0),o.bytesView();function C(x){for(u&=El[d],d>0?u|=x<<d:u=x,d+=f;d>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,d-=8;if((y>v||g)&&(g?(f=h,v=(1<<f)-1,g=!1):(++f,v=f===er?1<<f:(1<<f)-1)),x==S){for(;d>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,d-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Tl=Cl;function _s(t,e,n){return t<<8&63488|e<<2&992|n>>3}function Ps(t,e,n,r){return t>>4|e&240|(n&
240)<<4|(r&240)<<8}function Is(t,e,n){return t>>4<<8|e&240|n>>4}function tn(t,e,n){return t<e?e:t>n?n:t}function wt(t){return t*t}function Ts(t,e,n){var r=0,o=1e100;
let s=t[e],a=s.cnt,i=s.ac,l=s.rc,c=s.gc,u=s.bc;for(var d=s.fw;d!=0;d=t[d].fw){let h=t[d],g=h.cnt,f=a*g/(a+g);if(!(f>=o)){var m=0;n&&(m+=f*wt(h.ac-i),m>=o)||(m+=
f*wt(h.rc-l),!(m>=o)&&(m+=f*wt(h.gc-c),!(m>=o)&&(m+=f*wt(h.bc-u),!(m>=o)&&(o=m,r=d))))}}s.err=o,s.nn=r}function tr(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,
bk:0,tm:0,mtm:0,err:0}}function kl(t,e){let n=e==="rgb444"?4096:65536,r=new Array(n),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>24&255,l=a>>
16&255,c=a>>8&255,u=a&255,d=Ps(u,c,l,i),m=d in r?r[d]:r[d]=tr();m.rc+=u,m.gc+=c,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],i=a>>
16&255,l=a>>8&255,c=a&255,u=Is(c,l,i),d=u in r?r[u]:r[u]=tr();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,c=a&255,
u=_s(c,l,i),d=u in r?r[u]:r[u]=tr();d.rc+=c,d.gc+=l,d.bc+=i,d.cnt++}return r}function Rl(t,e,n={}){let{format:r="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,clearAlphaThreshold:a=0,
oneBitAlpha:i=!1}=n;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))
throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),c=n.useSqrt!==!1,u=r==="rgba4444",d=kl(l,r),m=d.length,h=m-1,g=new Uint32Array(
m+1);for(var f=0,b=0;b<m;++b){let I=d[b];if(I!=null){var v=1/I.cnt;u&&(I.ac*=v),I.rc*=v,I.gc*=v,I.bc*=v,d[f++]=I}}wt(e)/f<.022&&(c=!1);for(var b=0;b<f-1;++b)d[b].
fw=b+1,d[b+1].bk=b,c&&(d[b].cnt=Math.sqrt(d[b].cnt));c&&(d[b].cnt=Math.sqrt(d[b].cnt));var S,y,w;for(b=0;b<f;++b){Ts(d,b,!1);var A=d[b].err;for(y=++g[0];y>1&&(w=
y>>1,!(d[S=g[w]].err<=A));y=w)g[y]=S;g[y]=b}var T=f-e;for(b=0;b<T;){for(var E;;){var C=g[1];if(E=d[C],E.tm>=E.mtm&&d[E.nn].mtm<=E.tm)break;E.mtm==h?C=g[1]=g[g[0]--]:
(Ts(d,C,!1),E.tm=b);var A=d[C].err;for(y=1;(w=y+y)<=g[0]&&(w<g[0]&&d[g[w]].err>d[g[w+1]].err&&w++,!(A<=d[S=g[w]].err));y=w)g[y]=S;g[y]=C}var x=d[E.nn],P=E.cnt,$=x.
cnt,v=1/(P+$);u&&(E.ac=v*(P*E.ac+$*x.ac)),E.rc=v*(P*E.rc+$*x.rc),E.gc=v*(P*E.gc+$*x.gc),E.bc=v*(P*E.bc+$*x.bc),E.cnt+=x.cnt,E.mtm=++b,d[x.bk].fw=x.fw,d[x.fw].bk=
x.bk,x.mtm=h}let k=[];var J=0;for(b=0;;++J){let H=tn(Math.round(d[b].rc),0,255),I=tn(Math.round(d[b].gc),0,255),U=tn(Math.round(d[b].bc),0,255),_=255;u&&(_=tn(Math.
round(d[b].ac),0,255),i&&(_=_<=(typeof i=="number"?i:127)?0:255),o&&_<=a&&(H=I=U=s,_=0));let W=u?[H,I,U,_]:[H,I,U];if($l(k,W)||k.push(W),(b=d[b].fw)==0)break}return k}
function $l(t,e){for(let n=0;n<t.length;n++){let r=t[n],o=r[0]===e[0]&&r[1]===e[1]&&r[2]===e[2],s=r.length>=4&&e.length>=4?r[3]===e[3]:!0;if(o&&s)return!0}return!1}
function rn(t,e){var n=0,r;for(r=0;r<t.length;r++){let o=t[r]-e[r];n+=o*o}return n}function nn(t,e){return e>1?Math.round(t/e)*e:t}function _l(t,{roundRGB:e=5,roundAlpha:n=10,
oneBitAlpha:r=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,c=a>>8&255,u=a&255;i=nn(i,n),r&&(i=i<=(typeof r==
"number"?r:127)?0:255),u=nn(u,e),c=nn(c,e),l=nn(l,e),o[s]=i<<24|l<<16|c<<8|u<<0}}function Pl(t,e,n="rgb565"){if(!t||!t.buffer)throw new Error("quantize() expect\
ed RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>
256)throw new Error("applyPalette() only works with 256 colors or less");let r=new Uint32Array(t.buffer),o=r.length,s=n==="rgb444"?4096:65536,a=new Uint8Array(o),
i=new Array(s),l=n==="rgba4444";if(n==="rgba4444")for(let c=0;c<o;c++){let u=r[c],d=u>>24&255,m=u>>16&255,h=u>>8&255,g=u&255,f=Ps(g,h,m,d),v=f in i?i[f]:i[f]=Il(
g,h,m,d,e);a[c]=v}else{let c=n==="rgb444"?Is:_s;for(let u=0;u<o;u++){let d=r[u],m=d>>16&255,h=d>>8&255,g=d&255,f=c(g,h,m),v=f in i?i[f]:i[f]=Ll(g,h,m,e);a[u]=v}}
return a}function Il(t,e,n,r,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],c=l[3],u=$e(c-r);if(u>a)continue;let d=l[0];if(u+=$e(d-t),u>a)continue;let m=l[1];
if(u+=$e(m-e),u>a)continue;let h=l[2];u+=$e(h-n),!(u>a)&&(a=u,s=i)}return s}function Ll(t,e,n,r){let o=0,s=1e100;for(let a=0;a<r.length;a++){let i=r[a],l=i[0],c=$e(
l-t);if(c>s)continue;let u=i[1];if(c+=$e(u-e),c>s)continue;let d=i[2];c+=$e(d-n),!(c>s)&&(s=c,o=a)}return o}function Ol(t,e,n=5){if(!t.length||!e.length)return;
let r=t.map(a=>a.slice(0,3)),o=n*n,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>s?i=i.slice(0,3):i=i.slice();
let l=Os(r,i.slice(0,3),rn),c=l[0],u=l[1];u>0&&u<=o&&(t[c]=i)}}function $e(t){return t*t}function Ls(t,e,n=rn){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],
i=n(e,a);i<r&&(r=i,o=s)}return o}function Os(t,e,n=rn){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return[o,r]}function Nl(t,e,n=rn){
return t[Ls(t,e,n)]}function Ns(t={}){let{initialCapacity:e=4096,auto:n=!0}=t,r=$s(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),i=new Int32Array(o),l=!1;
return{reset(){r.reset(),l=!1},finish(){r.writeByte(Al.trailer)},bytes(){return r.bytes()},bytesView(){return r.bytesView()},get buffer(){return r.buffer},get stream(){
return r},writeHeader:c,writeFrame(u,d,m,h={}){let{transparent:g=!1,transparentIndex:f=0,delay:v=0,palette:b=null,repeat:S=0,colorDepth:y=8,dispose:w=-1}=h,A=!1;
if(n?l||(A=!0,c(),l=!0):A=!!h.first,d=Math.max(0,Math.floor(d)),m=Math.max(0,Math.floor(m)),A){if(!b)throw new Error("First frame must include a { palette } opt\
ion");Bl(r,d,m,b,y),ks(r,b),S>=0&&zl(r,S)}let T=Math.round(v/10);Ul(r,w,T,g,f);let E=!!b&&!A;Dl(r,d,m,E?b:null),E&&ks(r,b),Fl(r,u,d,m,y,s,a,i)}};function c(){Us(
r,"GIF89a")}}function Ul(t,e,n,r,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,r=!1);var s,a;r?(s=1,a=2):(s=0,a=0),e>=0&&(a=e&7),a<<=2,t.writeByte(
0|a|0|s),Se(t,n),t.writeByte(o||0),t.writeByte(0)}function Bl(t,e,n,r,o=8){let i=nr(r.length)-1,l=128|o-1<<4|0|i,c=0,u=0;Se(t,e),Se(t,n),t.writeBytes([l,c,u])}function zl(t,e){
t.writeByte(33),t.writeByte(255),t.writeByte(11),Us(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Se(t,e),t.writeByte(0)}function ks(t,e){let n=1<<nr(e.length);
for(let r=0;r<n;r++){let o=[0,0,0];r<e.length&&(o=e[r]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function Dl(t,e,n,r){if(t.writeByte(44),Se(t,0),Se(
t,0),Se(t,e),Se(t,n),r){let a=nr(r.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function Fl(t,e,n,r,o=8,s,a,i){Tl(n,r,e,o,t,s,a,i)}function Se(t,e){t.writeByte(
e&255),t.writeByte(e>>8&255)}function Us(t,e){for(var n=0;n<e.length;n++)t.writeByte(e.charCodeAt(n))}function nr(t){return Math.max(Math.ceil(Math.log2(t)),1)}
var Hl=Ns});var ur={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Qe={DISAPPEAR:0,REACH:1,BOUNCE:2},dr={OCCUPATION:0,SURROUND:1},pr={FAULT:0,INVOLVED:1};var pn=["obstacle","teammate","adversary"],mn=["vertex","edge","chain"],mr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],hn=["p\
ursuer_{number}","evader_{number}"],hr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},et={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},fr="{event}: {outcome}",fn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},gr={free:".GS",blocked:"#@OTW"};var Oe=1+mr.length;function tt(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function gn(t,e){return t<e?tt(hn[0],{number:t}):tt(hn[1],{number:t-e})}function ga(t,e){
let[n,r,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[d,m,h]=c.map(b=>u.filter((S,y)=>b>>y&1)),g=u.map(b=>gn(b,e)),f=tt(hr[a<0?"obstacle":mn[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),v=tt(fr,{event:f,outcome:ya(u.length,m,h,e)});return{kind:pn[r],form:mn[o],agents:u,cell:[i,l],at_fault:d,held:m,doomed:h,turn:n,
text:v}}function ya(t,e,n,r){if(t===2&&e.length===2)return et["both held"];if(t===2&&n.length===2)return et["both doomed"];let o=s=>a=>tt(et[s],{agent:gn(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||et.none}function Mt(t,e){let n=[];for(let r=0;r<t.length;r+=Oe)n.push(ga(t.subarray(r+1,r+Oe),e));
return n}var ge=class extends Error{name="EngineError"};function z(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new ge(
`${t}: expected ${e}, got ${r}`)}var Ne=class{bytes;constructor(e){this.bytes=e}},br=0,vn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],yr=4,vr=4,va=new TextEncoder,
ba=new TextDecoder;function wa(t){for(let e=vn.length-1;e>br;--e)if(t instanceof vn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function yn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function xa(t){return va.encode(`${t}\0`)}var bn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new ge("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(xa(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Ne,l=i?a.bytes:
a;return[this.text(s),i?br:wa(l),l.length,this.copy(yn(l))]}),o=this.copy(yn(Int32Array.from(r)));return this.copy(yn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function wr(t,e){let n=t.HEAPU8;return ba.decode(n.subarray(e,n.indexOf(0,e)))}function At(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/yr,r=e[n+1]/yr,o={};for(let s=r;s<r+e[n]*vr;s+=vr){let a=vn[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[wr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function nt(t,e){let n=new bn(t);try{let r=e(n);if(r===0)throw new ge(wr(t,t._last_error()));return r}finally{n.free()}}var Sa=2**31-1,Ma=2n**64n-1n,Aa=34028234663852886e22;function de(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Sa)throw z(t,"an integer",e);return Int32Array.
of(e)}function Et(t,e){if(typeof e!="boolean")throw z(t,"true or false",e);return new Ne(Uint8Array.of(Number(e)))}function Me(t,e,n){let r=typeof e=="string"&&
Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw z(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function wn(t,e){if(typeof e!="number"||
!(Math.abs(e)<=Aa))throw z(t,"a finite number",e);return e}function Ue(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(r<0n||r>Ma)throw z(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function Ea(t){return{"rules.interaction":Me("interaction",t.interaction,
ur),"rules.obstacle":Me("obstacle",t.obstacle,Qe),"rules.teammate":Me("teammate",t.teammate,Qe),"rules.evader":Me("evader",t.evader,Qe),"rules.pursuer":Me("purs\
uer",t.pursuer,Qe),"rules.capture":Me("capture",t.capture,dr),"rules.captured_disappear":Et("captured_disappear",t.captured_disappear)}}function xr(t,e){let n=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw z(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>wn(t,r))}function Ca(t){let e=(n,r)=>Float32Array.
of(wn(n,t[n]),wn(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":xr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":xr("evader_collide",t.evader_collide),
"rewards.blame":Me("blame",t.blame,pr),"rewards.capture_repeats":Et("capture_repeats",t.capture_repeats)}}function Mr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=gr;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw z(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw z(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function Ar(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw z("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function Ct(t){Ar(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ea(t.rules),...Ca(t.rewards),rows:de("rows",t.rows),cols:de("cols",t.cols),n_pursuers:de("n_pursuers",t.n_pursuers),n_evaders:de("n_evaders",t.n_evaders),fov:de(
"fov",t.fov),diagonal:Et("diagonal",t.diagonal),max_steps:de("max_steps",t.max_steps),density:Float64Array.of(e),map:Mr(t.obstacles)}}function Sr(t,e){return Int32Array.
from((e??[]).flat(),n=>de(t,n)[0])}function Er(t,e){return Ar(t.obstacles,e),{seed:Ue("seed",t.seed??0n),episode:Ue("episode",t.episode??0),pursuers:Sr("pursuer\
s",t.pursuers),evaders:Sr("evaders",t.evaders),map:Mr(t.obstacles)}}function Tt(t){return{actions:Int32Array.from(t,e=>de("actions",e)[0])}}function Be(t){if(typeof t==
"string"){if(!Object.hasOwn(fn,t))throw z("policy",`one of ${Object.keys(fn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw z("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>de("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:Et("sampled",t.sampled),genome:t.genome}}var Ta=["first_turn","terminated","truncated"];function Cr(t){let e={...t};for(let n of Ta)
e[n]=new Ne(t[n]);return e}var kt=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,n,r,o){
this.config=e,this.seed=n,this.episode=r,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=Tr(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=ka(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[n,r]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(n*Oe,r*Oe);return Mt(o,this.config.
n_pursuers)}seek(e,n){this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.episode});
for(let o=e.steps;o<n;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw z("s\
tep",`0 to ${this.length}`,e)}};function ka(t,e){let n=new Int32Array(e+2);for(let r=0;r<t.length;r+=Oe)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}
function Tr(t,e){let n=t["statistics.length"].length,r=s=>{let a=t[`statistics.${s}`],i=a.length/n;return a.slice(e*i,(e+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),
overlap:r("overlap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function kr(t,e,n,r){let o=[Ct(n.config),Be(n.pursuers),Be(n.evaders),
r];return nt(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](a,i,l,c)}),At(t)}function Rr(t,e,n,r){let o={seed:Ue("seed",n),episode:Ue("episode",r)};return new kt(
e.config,n,r,kr(t,"_play_match",e,o))}function $r(t,e,n,r){if(!Number.isInteger(r)||r<1)throw z("n_episodes","at least 1",r);let o={seed:Ue("seed",n),n_episodes:Int32Array.
of(r)},s=kr(t,"_play_rollout",e,o);return Array.from({length:r},(a,i)=>Tr(s,i))}var _r=new FinalizationRegistry(([t,e])=>t._world_free(e)),rt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=nt(e,r=>e._world_new(r.arrays(Ct(n)))),_r.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,_r.unregister(this),this.engine._world_free(this.at))}reset(e={}){let n=Er(e,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(e){let n=Tt(e);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(e){let n=Tt(e);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw z(
"actions",String(this.n_agents),r.length);let l=[Be(e),Tt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(c)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.at,n.
text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Mt(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,n){
let r=Be(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,
probabilities:Ra(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let n=Cr(e);this.call(r=>this.engine._world_restore(
this.at,r.arrays(n)))}call(e){if(this.freed)throw z("world","one that is in use","one that was freed");return nt(this.engine,e),At(this.engine)}};function Ra(t){
let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var xn=class{compiled;constructor(e){this.compiled=e}world(e){return new rt(this.compiled,e)}match(e,n,r,o,s=0){return Rr(this.compiled,{config:e,pursuers:n,evaders:r},
o,s)}rollout(e,n,r,o,s){return $r(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Pr;function Ir(t=globalThis.matrixworldEngine){return Pr??=$a(t),Pr}async function $a(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new xn(
await t({wasmBinary:e}))}var _a="http://www.w3.org/2000/svg";function p(t,e={},...n){return Lr(document.createElement(t),e,n)}function M(t,e={},...n){return Lr(document.createElementNS(
_a,t),e,n)}function Lr(t,e,n){for(let[r,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(r.slice(2),o):t.setAttribute(r,o===!0?"":
String(o)));return t.append(...n.filter(Pa).map(r=>typeof r=="number"?String(r):r)),t}function Pa(t){return t!=null&&t!==!1}var ot=()=>["file:","http:","https:"].
includes(location.protocol);var Ia=matchMedia("(prefers-color-scheme: dark)");function La(){let t=document.documentElement.dataset.theme;return t?t==="dark":Ia.matches}function Sn(){document.
documentElement.dataset.theme=La()?"light":"dark"}function Or(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Sn},
"◐")}var Oa=2n**64n-1n;function st(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,d)=>{let m=r.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):d},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Oa?l:null,step:o("step",1/0,0)}}function Nr(t,e,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:n.player.step};r=`#${Object.entries(u).
map(([d,m])=>`${d}=${m}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};e.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=st(location.hash,
t,e.selected);e.select(a),n.goTo(s)})}var N=Uint8Array,K=Uint16Array,_n=Int32Array,$t=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),_t=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Cn=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Hr=function(t,e){for(var n=new K(31),r=0;r<31;++r)n[r]=e+=
1<<t[r-1];for(var o=new _n(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},Wr=Hr($t,2),jr=Wr.b,Tn=Wr.r;jr[28]=258,Tn[258]=28;var Gr=Hr(
_t,0),Na=Gr.b,Ur=Gr.r,kn=new K(32768);for(R=0;R<32768;++R)pe=(R&43690)>>1|(R&21845)<<1,pe=(pe&52428)>>2|(pe&13107)<<2,pe=(pe&61680)>>4|(pe&3855)<<4,kn[R]=((pe&65280)>>
8|(pe&255)<<8)>>1;var pe,R,ie=(function(t,e,n){for(var r=t.length,o=0,s=new K(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new K(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new K(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],d=a[t[o]-1]++<<u,m=d|(1<<u)-1;d<=m;++d)i[kn[d]>>l]=c}else for(i=new K(
r),o=0;o<r;++o)t[o]&&(i[o]=kn[a[t[o]-1]++]>>15-t[o]);return i}),ye=new N(288);for(R=0;R<144;++R)ye[R]=8;var R;for(R=144;R<256;++R)ye[R]=9;var R;for(R=256;R<280;++R)
ye[R]=7;var R;for(R=280;R<288;++R)ye[R]=8;var R,lt=new N(32);for(R=0;R<32;++R)lt[R]=5;var R,Ua=ie(ye,9,0),Ba=ie(ye,9,1),za=ie(lt,5,0),Da=ie(lt,5,1),Mn=function(t){
for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},re=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},An=function(t,e){var n=e/8|0;return(t[n]|
t[n+1]<<8|t[n+2]<<16)>>(e&7)},Pn=function(t){return(t+7)/8|0},In=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),new N(t.subarray(
e,n))};var Fa=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],G=function(t,e,n){var r=new Error(e||Fa[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,G),!n)throw r;return r},Ha=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new N(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new N(o*3));var c=function(Je){var Xe=n.length;if(Je>Xe){var Le=new N(Math.max(Xe*2,Je));Le.set(n),n=Le}},u=e.f||0,d=e.
p||0,m=e.b||0,h=e.l,g=e.d,f=e.m,v=e.n,b=o*8;do{if(!h){u=re(t,d,1);var S=re(t,d+1,3);if(d+=3,S)if(S==1)h=Ba,g=Da,f=9,v=5;else if(S==2){var T=re(t,d,31)+257,E=re(
t,d+10,15)+4,C=T+re(t,d+5,31)+1;d+=14;for(var x=new N(C),P=new N(19),$=0;$<E;++$)P[Cn[$]]=re(t,d+$*3,7);d+=E*3;for(var k=Mn(P),J=(1<<k)-1,H=ie(P,k,1),$=0;$<C;){
var I=H[re(t,d,J)];d+=I&15;var y=I>>4;if(y<16)x[$++]=y;else{var U=0,_=0;for(y==16?(_=3+re(t,d,3),d+=2,U=x[$-1]):y==17?(_=3+re(t,d,7),d+=3):y==18&&(_=11+re(t,d,127),
d+=7);_--;)x[$++]=U}}var W=x.subarray(0,T),B=x.subarray(T);f=Mn(W),v=Mn(B),h=ie(W,f,1),g=ie(B,v,1)}else G(1);else{var y=Pn(d)+4,w=t[y-4]|t[y-3]<<8,A=y+w;if(A>o){
l&&G(0);break}i&&c(m+w),n.set(t.subarray(y,A),m),e.b=m+=w,e.p=d=A*8,e.f=u;continue}if(d>b){l&&G(0);break}}i&&c(m+131072);for(var _e=(1<<f)-1,X=(1<<v)-1,ue=d;;ue=
d){var U=h[An(t,d)&_e],V=U>>4;if(d+=U&15,d>b){l&&G(0);break}if(U||G(2),V<256)n[m++]=V;else if(V==256){ue=d,h=null;break}else{var q=V-254;if(V>264){var $=V-257,O=$t[$];
q=re(t,d,(1<<O)-1)+jr[$],d+=O}var ae=g[An(t,d)&X],Pe=ae>>4;ae||G(3),d+=ae&15;var B=Na[Pe];if(Pe>3){var O=_t[Pe];B+=An(t,d)&(1<<O)-1,d+=O}if(d>b){l&&G(0);break}i&&
c(m+131072);var Ie=m+q;if(m<B){var xt=s-B,St=Math.min(B,Ie);for(xt+m<0&&G(3);m<St;++m)n[m]=r[xt+m]}for(;m<Ie;++m)n[m]=n[m-B]}}e.l=h,e.p=ue,e.b=m,e.f=u,h&&(u=1,e.
m=f,e.d=g,e.n=v)}while(!u);return m!=n.length&&a?In(n,0,m):n.subarray(0,m)},me=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},at=function(t,e,n){n<<=
e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},En=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:qr,l:0};if(o==1){var a=new N(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(A,T){return A.f-T.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
u=1,d=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[c].f<n[d].f?c++:d++],l=n[c!=u&&n[c].f<n[d].f?c++:d++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,r=1;r<
o;++r)s[r].s>m&&(m=s[r].s);var h=new K(m+1),g=Rn(n[u-1],h,0);if(g>e){var r=0,f=0,v=g-e,b=1<<v;for(s.sort(function(T,E){return h[E.s]-h[T.s]||T.f-E.f});r<o;++r){
var S=s[r].s;if(h[S]>e)f+=b-(1<<g-h[S]),h[S]=e;else break}for(f>>=v;f>0;){var y=s[r].s;h[y]<e?f-=1<<e-h[y]++-1:++r}for(;r>=0&&f;--r){var w=s[r].s;h[w]==e&&(--h[w],
++f)}g=e}return{t:new N(h),l:g}},Rn=function(t,e,n){return t.s==-1?Math.max(Rn(t.l,e,n+1),Rn(t.r,e,n+1)):e[t.s]=n},Br=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new K(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},it=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},Vr=function(t,e,n){var r=n.length,o=Pn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},zr=function(t,e,n,r,o,s,a,i,l,c,u){me(e,u++,n),++o[256];for(var d=En(o,15),m=d.t,h=d.l,g=En(s,15),f=g.t,v=g.l,b=Br(m),S=b.c,
y=b.n,w=Br(f),A=w.c,T=w.n,E=new K(19),C=0;C<S.length;++C)++E[S[C]&31];for(var C=0;C<A.length;++C)++E[A[C]&31];for(var x=En(E,7),P=x.t,$=x.l,k=19;k>4&&!P[Cn[k-1]];--k)
;var J=c+5<<3,H=it(o,ye)+it(s,lt)+a,I=it(o,m)+it(s,f)+a+14+3*k+it(E,P)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&J<=H&&J<=I)return Vr(e,u,t.subarray(l,l+c));var U,_,W,B;
if(me(e,u,1+(I<H)),u+=2,I<H){U=ie(m,h,0),_=m,W=ie(f,v,0),B=f;var _e=ie(P,$,0);me(e,u,y-257),me(e,u+5,T-1),me(e,u+10,k-4),u+=14;for(var C=0;C<k;++C)me(e,u+3*C,P[Cn[C]]);
u+=3*k;for(var X=[S,A],ue=0;ue<2;++ue)for(var V=X[ue],C=0;C<V.length;++C){var q=V[C]&31;me(e,u,_e[q]),u+=P[q],q>15&&(me(e,u,V[C]>>5&127),u+=V[C]>>12)}}else U=Ua,
_=ye,W=za,B=lt;for(var C=0;C<i;++C){var O=r[C];if(O>255){var q=O>>18&31;at(e,u,U[q+257]),u+=_[q+257],q>7&&(me(e,u,O>>23&31),u+=$t[q]);var ae=O&31;at(e,u,W[ae]),
u+=B[ae],ae>3&&(at(e,u,O>>5&8191),u+=_t[ae])}else at(e,u,U[O]),u+=_[O]}return at(e,u,U[256]),u+_[256]},Wa=new _n([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),qr=new N(0),ja=function(t,e,n,r,o,s){var a=s.z||t.length,i=new N(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var d=Wa[e-1],m=d>>13,h=d&8191,g=(1<<n)-1,f=s.p||new K(32768),v=s.h||new K(g+1),b=Math.ceil(n/3),S=2*b,y=function(dn){return(t[dn]^t[dn+1]<<
b^t[dn+2]<<S)&g},w=new _n(25e3),A=new K(288),T=new K(32),E=0,C=0,x=s.i||0,P=0,$=s.w||0,k=0;x+2<a;++x){var J=y(x),H=x&32767,I=v[J];if(f[H]=I,v[J]=H,$<=x){var U=a-
x;if((E>7e3||P>24576)&&(U>423||!c)){u=zr(t,l,0,w,A,T,C,P,k,x-k,u),P=E=C=0,k=x;for(var _=0;_<286;++_)A[_]=0;for(var _=0;_<30;++_)T[_]=0}var W=2,B=0,_e=h,X=H-I&32767;
if(U>2&&J==y(x-X))for(var ue=Math.min(m,U)-1,V=Math.min(32767,x),q=Math.min(258,U);X<=V&&--_e&&H!=I;){if(t[x+W]==t[x+W-X]){for(var O=0;O<q&&t[x+O]==t[x+O-X];++O)
;if(O>W){if(W=O,B=X,O>ue)break;for(var ae=Math.min(X,O-2),Pe=0,_=0;_<ae;++_){var Ie=x-X+_&32767,xt=f[Ie],St=Ie-xt&32767;St>Pe&&(Pe=St,I=Ie)}}}H=I,I=f[H],X+=H-I&
32767}if(B){w[P++]=268435456|Tn[W]<<18|Ur[B];var Je=Tn[W]&31,Xe=Ur[B]&31;C+=$t[Je]+_t[Xe],++A[257+Je],++T[Xe],$=x+W,++E}else w[P++]=t[x],++A[t[x]]}}for(x=Math.max(
x,$);x<a;++x)w[P++]=t[x],++A[t[x]];u=zr(t,l,c,w,A,T,C,P,k,x-k,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=v,s.p=f,s.i=x,s.w=$)}else{for(var x=s.w||0;x<a+c;x+=65535){var Le=x+
65535;Le>=a&&(l[u/8|0]=c,Le=a),u=Vr(l,u+1,t.subarray(x,Le))}s.i=a}return In(i,0,r+Pn(u)+o)},Ga=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var n=e,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),Va=function(){var t=-1;return{p:function(e){for(var n=t,r=0;r<e.length;++r)n=Ga[n&255^e[r]]^n>>>8;t=n},d:function(){
return~t}}};var qa=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return ja(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},Kr=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var j=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var Ka=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&G(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&G(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Ya(t,e){return qa(t,e||{},0,0)}function Yr(t,e){return Ha(t.subarray(Ka(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Zr=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=Kr(r,s[1]),s=s[0]),s instanceof N?n[a]=[s,i]:(n[a+="/"]=[new N(0),i],Zr(s,a,n,
r))}},Dr=typeof TextEncoder<"u"&&new TextEncoder,Za=typeof TextDecoder<"u"&&new TextDecoder,Ja=0;try{Za.decode(qr,{stream:!0}),Ja=1}catch{}function Rt(t,e){if(e){for(var n=new N(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(Dr)return Dr.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new N(a+8+(o-r<<1));l.set(s),s=l}var c=t.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return In(s,0,a)}var $n=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&G(9),e+=r+4}return e},Fr=function(t,e,n,r,o,s,a,i){var l=r.length,c=n.extra,u=i&&i.length,
d=$n(c);j(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var m=new Date(n.mtime==null?Date.now():n.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&G(10),j(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(j(t,e,n.crc),j(t,e+4,s<0?-s-2:s),j(t,e+8,n.size)),j(t,e+12,l),j(t,e+14,d),e+=16,a!=null&&(j(t,e,
u),j(t,e+6,n.attrs),j(t,e+10,a),e+=14),t.set(r,e),e+=l,d)for(var g in c){var f=c[g],v=f.length;j(t,e,+g),j(t,e+2,v),t.set(f,e+4),e+=4+v}return u&&(t.set(i,e),e+=
u),e},Xa=function(t,e,n,r,o){j(t,e,101010256),j(t,e+8,n),j(t,e+10,n),j(t,e+12,r),j(t,e+16,o)};function Jr(t,e){e||(e={});var n={},r=[];Zr(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],u=c.level==0?0:8,d=Rt(a),m=d.length,h=c.comment,g=h&&
Rt(h),f=g&&g.length,v=$n(c.extra);m>65535&&G(11);var b=u?Ya(l,c):l,S=b.length,y=Va();y.p(l),r.push(Kr(c,{size:l.length,crc:y.d(),c:b,f:d,m:g,u:m!=a.length||g&&h.
length!=f,o,compression:u})),o+=30+m+v+S,s+=76+2*(m+v)+(f||0)+S}for(var w=new N(s+22),A=o,T=s-o,E=0;E<r.length;++E){var d=r[E];Fr(w,d.o,d,d.f,d.u,d.c.length);var C=30+
d.f.length+$n(d.extra);w.set(d.c,d.o+C),Fr(w,o,d,d.f,d.u,d.c.length,d.o,d.m),o+=16+C+(d.m?d.m.length:0)}return Xa(w,o,r.length,T,A),w}var ze=["pursuer","evader"];function Qr(){return JSON.parse(Pt("data"))}function Ae(t,e,n){let[r,o]=[e-t.payoff.first[0],n-t.payoff.first[1]],s=t.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r][o]}}function Ee(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.
teams[e];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${e}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return eo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function Q(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=eo(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:c}}var Ln=4,Xr=new Map;function eo(t,e){let n=Xr.get(t);if(n)return n;let r=new Float32Array;try{let o=ei(
On(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||Qa(o)))throw o}return Xr.set(t,r),r}var Qa=t=>t instanceof
Error&&"code"in t;function ei(t,e){let n=Yr(t),r=n.length/Ln,o=new Uint8Array(n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Ln*r+Math.floor(a/Ln)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function On(t){let e=atob(Pt(t)),n=new Uint8Array(e.length);for(let r=0;r<n.
length;r++)n[r]=e.charCodeAt(r);return n}function Pt(t){return document.getElementById(t)?.textContent??""}var De=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function to(t,e,n){let[r,o]=[e[0]-t[0],e[1]-t[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),De.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ti=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Nn=({rows:t,cols:e},[n,r])=>n>=0&&r>=0&&n<t&&r<e,Un=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),Bn=(t,e)=>Un(t.fault,e),no=(t,e)=>!Bn(
t,e)&&Un(t.involved,e,2);function It(t,e,n){let r=!ti(L(t,n),L(e,n)),o=e.involved===void 0||Un(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!r&&o)}function Lt(t,e,n){
let[r,o]=L(t,n),[s,a]=De[e.actions?.[n]??0];return[r+s,o+a]}function ct(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var ro=t=>t.moments.flatMap((e,n)=>n&&ct(t,t.moments[n-1],e).length?[n]:[]);function Ot(t,e){return Array.from({length:e.
alive.length},(r,o)=>o).filter(r=>t.alive[r]&&!e.alive[r])}var oo=[-.31,0,.31],so=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:oo.flatMap(t=>oo.map(e=>[e,t]))}],ni=.3,ri=.35,oi=.55;function ut(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=L(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function ao(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ut(t,e).values()){let o=so[Math.min(r.length,so.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var io=t=>t*t*(3-2*t),Fe=(t,e,n)=>t+(e-t)*n,lo=t=>Math.min(1,Math.max(0,t));function co(t,e,n,r){let o={
1:2,2:n}[t.interaction]??1;if(o===1)return io(r);let s=o===n?e:+!Ce(t,e),a=Math.max(1/o,ri);return io(lo((r-s/(o-1)*(1-a))/a))}function Nt(t,e){let n=t.moments.
length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=ao(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=ao(t,a);return s.map((l,c)=>{let u=co(t,c,s.length,
e-r);return si(o,a,c,l,i[c],u)})}function Fn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[t.moments[o],t.moments[Math.min(o+1,r)]],i=co(t,
e,s.alive.length,n-o),[[l,c],[u,d]]=[L(s,e),L(a,e)];return[Fe(c,d,i)+.5,Fe(l,u,i)+.5]}function si(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:Fe(r.x,o.x,s),y:Fe(r.y,
o.y,s),size:a?r.size:Fe(r.size,o.size,s),alpha:a?lo((1-s)/(1-oi)):Fe(r.alpha,o.alpha,s)};if(It(t,e,n)){let[l,c]=L(t,n),[u,d]=Lt(t,e,n),m=ni*Math.sin(Math.PI*s);
i.x+=(d-c)*m,i.y+=(u-l)*m}return i}var uo=2*Math.PI;function Te(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,uo)}function Ut(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,r*.09)}),t.closePath()}function po(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function mo(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=uo*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function ho(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var fo=4,ai=1.6,ii=.95,li=5,ci=.16,ui=9,di=.09,pi=.2,go=.75,ee=(t,e)=>t.left+e*t.cell,te=(t,e)=>t.top+e*t.cell;function He(t,e,n){return Ce(e,n)?t.colors.pursuer:
t.colors.evader}function yo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=n.paper,t.fillRect(r,o,l,c),s<li)return;
t.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(r+d*s,o,u,c);for(let d=1;d<a;d++)t.fillRect(r,o+d*s,l,u)}function vo({ctx:t,
grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let c=0;c<i*l;c++){if(!r.obstacles[c])continue;let[u,d]=[Math.floor(c/l),
c%l];t.fillRect(o+d*a,s+u*a,a,a)}bo({ctx:t,grid:e,colors:n})}function bo({ctx:t,grid:{left:e,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function wo({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,c=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.
textAlign="center";let u=5*r+a/40;for(let d=0;d<l;d+=c)t.fillText(String(d),o+(d+.5)*a,s-u);t.textAlign="right",t.textBaseline="middle";for(let d=0;d<i;d+=c)t.fillText(
String(d),o-u,s+(d+.5)*a)}function xo({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(t.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
t.rows,r+o)];return[ee(t,s),te(t,i),(a-s)*t.cell,(l-i)*t.cell]}function So(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...xo(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),bo(t)}function Mo({ctx:t,grid:e,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[ee(e,r),te(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=n.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let d=c-i/2<u*1.2,m=c+(d?1:-1)*(i/2+u*.7);t.strokeStyle=
n.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=n.ink,t.fillText("You",l,m),t.globalAlpha=1}function Ao(t,e,n,r,o){let{ctx:s,grid:a}=t,
i=xo(t,e,r,o),l=He(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Eo(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(ui,
Math.max(1,a.cell*ci));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let[u,d]=[e.moments[c-1],e.moments[c]],m=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
go+(pi-go)*m;for(let h=0;h<d.alive.length;h++){let g=c===i&&n<i;if(!u.alive[h]||!(l.alive[h]||g))continue;let f=(Ce(e,h)?-1:1)*di,[v,b]=L(u,h),[S,y]=L(d,h);if(v===
S&&b===y)continue;let w=g?o[h].x:y+.5,A=g?o[h].y:S+.5;s.strokeStyle=He(t,e,h),s.beginPath(),s.moveTo(ee(a,b+.5+f),te(a,v+.5+f)),s.lineTo(ee(a,w+f),te(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Co(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-fo+1);o<=r;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/fo,l=ct(e,s,a);for(let c of Ot(s,a))l.includes(c)||hi(t,L(a,c),i);for(let c of l)mi(t,L(a,c),i)}t.ctx.globalAlpha=1}function mi({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,mo(t,ee(e,o+.5),te(e,r+.5),Math.max(8,e.cell*ai)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function hi({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,po(t,ee(e,o+.5),te(e,r+.5),Math.max(7,e.cell*ii)),
t.strokeStyle=n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function To({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[ee(e,i)+s,te(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function ko({ctx:t,grid:e,colors:n},r,o,s,a){t.globalAlpha=a,Te(t,ee(e,r),te(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var fi=.8,gi=.92,yi=15,vi=7,Hn=9;function Ro(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&bi(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ut(e,n).values())a.length>
Hn&&wi(t,r[a[Hn-1]],a.length-Hn+1)}function bi(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Ce(e,r),[d,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?gi:fi)),g=He(t,e,r),f=!u&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Ut:Te)(i,d,m,h),h>vi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(Te(i,d,m,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<yi*a)return;let v=String(u?r:r-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
v,d,m+h*(u?.17:.03))}function wi({ctx:t,grid:e,colors:n},r,o){let[s,a]=[e.left+r.x*e.cell,e.top+r.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=n.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=n.ink,t.fillText(`+${o}`,
s,a)}var xi=.46,Si=.86,Mi=.66,$o=.48,Ai=.78,Ei=.58;function _o(t,e,n,r){let[o,s]=[e.moments[n-1],e.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)It(o,s,c)&&Ci(t,e,L(o,c),Lt(o,s,c));a.globalAlpha=
1}function Ci({ctx:t,grid:e},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=d=>ee(e,r[1]+.5+s*d),l=d=>te(e,r[0]+.5+a*d),c=Nn(n,o)?Ai:Ei;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i($o),l($o)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function Po(t,e,n,r,o,s){let a=De[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Nn(e,[r[0]+a[0],r[1]+a[1]])?Si:
Mi,d=xi*o.size,m=[ee(l,o.x+a[1]*d),te(l,o.y+a[0]*d),ee(l,o.x+a[1]*u),te(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[
c.paper,h*2.1],[He(t,e,n),h]])i.strokeStyle=g,i.lineWidth=f,ho(i,...m,l.cell*.2),i.stroke()}var Bt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function zt(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),c=e.moments[l],u=n===l,d=Nt(e,n),m=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),yo(t);for(let f of r.
viewers)d[f]?.alpha&&Ao(t,e,f,...Fn(e,f,n));vo(t,e),r.axes&&wo(t,o),Eo(t,e,n,r.trail,d),To(t,c.contested??[],m),Co(t,e,n),_o(t,e,l,m),d.forEach(({x:f,y:v,size:b},S)=>{
let y=no(c,S)?.4:0,w=Bn(c,S)?1:y;w&&ko(t,f,v,b,w*m)});let h=u?c:e.moments[Math.max(0,l-1)];if(Ro(t,e,h,d,r.numbers,o),u&&r.plan)for(let[f,v]of d.entries())v.alpha&&
Po(t,e,f,L(c,f),v,r.plan[f]??0);r.you!==null&&(r.fog&&So(t,e,...Fn(e,r.you,n)),Mo(t,d[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===
null?void 0:d[r.selected];g?.alpha&&Io(t,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Io(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function Io({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var dt=(t,e)=>(e+.24)/(t+.24);function Dt(t,e,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Lo(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var Ti={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function We(t){let e=getComputedStyle(t),n=Object.entries(Ti).map(([r,o])=>[r,e.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var oe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ve=class{canvas;#e=null;#o=0;#r;#a={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#t;#i;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#r={...Bt,...n},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#r}set look(e){this.#r={...this.#r,...e},this.#u(),this.redraw()}get time(){return this.#o}show(e,n){this.#e=e,this.#o=Math.min(Math.max(0,n),e.moments.
length-1),this.#u(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#a=Dt(n,r,this.#r.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:We(this.canvas)};zt(s,this.#e,this.#o,this.#r,o)}cellAt(e,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.
width;return Lo(this.#a,(e-r.left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#o)],s=ut(
this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Nt(this.#e,Math.round(this.#o)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,u-n)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[r.left+
(s+e*i)*o,r.top+(a+n*i)*o]}#u(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(dt(e,n)))}#d(){let e=devicePixelRatio||
1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var ki=12e3;function Oo(t,e,n){let r=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>d(
c-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>d(c+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>d(0,!oe())},"A guided minute"),[c,u]=[-1,0];function d(v,b){
clearTimeout(u);let S=r()[v];if(g(),!S)return m();c=v,o.replaceChildren(p("span",{class:"muted numbers"},`${v+1} of ${r().length} `),S.text),s.disabled=v===0,a.
textContent=v===r().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:S.pursuer,evader:S.evader}),S.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):S.shows==="checkerboard"?h():(n.reveal(),n.playSoon()),b&&(u=setTimeout(()=>d(v+1,!0),ki))}function m(){clearTimeout(u),c=-1,i.
hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let v=document.querySelector("dialog.four[open]");v?.append(i),v?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let g=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!r().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",v=>{v.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var Ri={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},pt=[.5,1,2,4,8,16,32,64],je=0,Ft=12,$i=2,be=class extends EventTarget{#e;#o;#r;#a;#n=0;#t=0;#i=!1;#u=null;#d=0;#c=[];glide=.28;constructor(e,n={}){
super(),this.#e=e,this.#o=n.speed??4,this.#a=n.still??!1,this.#r=n.clock??Ri}get step(){return this.#n}get time(){return this.#a?this.#n:this.#t}get arrived(){return this.#t===
this.#n}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#p("state")}get marks(){return this.#c}set marks(e){
this.#c=e,this.#p("state")}get pace(){return this.#o||Math.max($i,this.#e/Ft)}get speed(){return this.#o}set speed(e){this.#o=e,this.#p("state")}changeSpeed(e){
let n=pt.findIndex(r=>r>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,n+e))]}play(){this.#i||!this.#e||(this.#n===this.#e&&this.jump(0),this.#i=!0,this.#p(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#p("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#n+e));Math.abs(n-this.#t)>1?this.jump(n):this.#l(n),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#l(this.#t),this.#p("fram\
e")}#l(e){e!==this.#n&&(this.#n=e,this.#p("step"),this.#a&&this.#p("frame"))}#s(){this.#u===null&&(this.#d=this.#r.now(),this.#u=this.#r.request(()=>this.#h()))}#h(){
this.#u=null;let e=this.#r.now();this.#f(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#a||this.arrived)&&this.#p("frame"),(this.#i||this.#t!==this.#n)&&(this.#u=
this.#r.request(()=>this.#h()))}#f(e){let n=e;for(;n>0;){if(this.#t===this.#n){if(!this.#i)return;if(this.#n===this.#e)return this.pause();this.#l(this.#n+1)}let r=this.#i?
this.pace:1/this.glide,o=this.#n-this.#t,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#t=s===Math.abs(o)?this.#n:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#p(e){this.dispatchEvent(new Event(e))}};function we(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var mt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ge(t){let e=Math.min(1,Math.max(0,t))*(mt.length-1),n=Math.min(mt.length-2,Math.floor(e)),[r,o]=[mt[n],
mt[n+1]],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Ht(t){let[e,n,r]=Ge(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+
.0722*r>.179?"#000":"#fff"}var Wt=t=>`rgb(${Ge(t).join(" ")})`,No=()=>`linear-gradient(to right, ${mt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function jt(t,e,n){let r=devicePixelRatio||1;t.style.left=`${n.left}px`,t.style.top=`${n.top}px`,t.style.width=`${n.width}px`,t.style.height=`${n.height}px`,t.width=
Math.round(n.width*r),t.height=Math.round(n.height*r);let o=t.getContext("2d"),s=_i(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function _i(t){let[e,n]=t.shape,r=document.createElement("canvas");[r.width,r.height]=[n,e];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*n+c+t.first[1]);s.data.set([...Ge(l),255],u)})),o.putImageData(s,0,0),r}function Gt(t,e){
let n=p("span",{class:"gradient"});return n.style.backgroundImage=No(),p("p",{class:"scale-of-rates small muted"},t,n,e)}var Pi=84;function Uo(t,e){let n=t.map((s,a)=>Ii(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),r.hidden=t.length<2,r}function Ii(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Pi/
Math.max(r,o),i=p("canvas",{"aria-hidden":"true"});jt(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),c=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Wn(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Li(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:d=>{c.setAttribute("aria-current",String(d));let m=n.hover.pursuer??n.selected.pursuer,h=n.hover.evader??n.selected.evader;
l.hidden=m>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-m-.5)*a}px`}}}var Li=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Wn(t,e,n){
let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var Oi=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function Bo(){let t=Oi.map(([n,r])=>p("div",{class:"key-row"},p("dt",{},...n.map(o=>p("kbd",{},o))),p("dd",{},r))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",n=>n.target===e&&e.close()),e}function zo(t,e,n,r,o,s){let a=(l,c)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.
inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:Sn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let d=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(we(n.player,l)||d)d?.();else if(t[m])Wn(t[m],
m,e);else return;l.preventDefault()})}function Do(t,e,n,r,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!r()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("version").then(c=>c.text(),()=>null);l===null?o():l==="end"||l!==t&&a()?(Ni(e,n),location.reload()):setTimeout(
()=>{i()},1e3)};i()}function Ni(t,e){let{run:n,pursuer:r,evader:o}=e.selected,[s,a]=t[n].payoff.shape;r===s-1&&o===a-1&&history.replaceState(null,"",`#run=${n}`)}var Bi={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function jn(t,e,n){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:Bi[t.rules.interaction],
obstacles:e,moments:n}}function Gn(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function Vt(t){let e=Array.from({length:t.length+1},
(n,r)=>zi(t,r));return jn(t.config,t.map,e)}function zi(t,e){let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*n),alive:o(t.alive,e,n),captured:o(t.captured,e,r),everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,
e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var Di=Array.from({length:16},(t,e)=>{let[n,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function Fo(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:Di,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var Fi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Ho(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:Fi[t]}))}function ht(t,e,n,r){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${n})`,onclick:r},Ho(t))}function Ve(t){let e=ht("play","Play","Space",()=>t.toggle()),n=Hi(t),
r=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=Wi(t),s=p("output",{class:"player-count"}),a=p("div",{class:"player",role:"group","aria-la\
bel":"Player"},ht("first","First step","Home",()=>t.move(-t.length)),ht("back","Step back","←",()=>t.move(-1)),e,ht("forward","Step forward","→",()=>t.move(
1)),ht("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},r,n),s,o),i=()=>r.replaceChildren(...t.marks.map(c=>{let u=p("i");return u.style.left=
`${100*c/Math.max(1,t.length)}%`,u})),l=()=>{e.replaceChildren(Ho(t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space\
)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,s.textContent=`${t.step} / ${t.length}`,s.style.minWidth=`${2*String(
t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),a.addEventListener(
"keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==n)&&we(t,c)&&c.preventDefault()}),l(),a}function Hi(t){let e=p("input",{type:"ran\
ge",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),e}function Wi(t){let e=`S\
teps a second, or the whole in ${Ft} s (+ and -)`,n=p("select",{class:"player-speed","aria-label":"Speed",title:e},p("option",{value:je},`in ${Ft} s`),...pt.map(
r=>p("option",{value:r},`${r} / s`)));return n.addEventListener("change",()=>{t.speed=Number(n.value)}),n}var D=(t,e=2)=>t==null?"-":t.toFixed(e);function Wo(t,e,n,r=2){return e===null||n===null?t.toFixed(r):`${t.toFixed(r)} (${e.toFixed(r)} to ${n.toFixed(r)})`}var jo=t=>t.toLocaleString("en-GB");function ft(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}function xe(t,e,{pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,Q(e,"pursuer",n),Q(e,"evader",r),BigInt(s??a),o)}var Go=40,gt=new Map,yt=({run:t,pursuer:e,evader:n},r)=>`${t} ${e} ${n} ${r}`,qt=class{element;#e;#o;#r=p("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=p("p",{class:"check small numbers","aria-live":"polite"});#n=0;constructor(e,n){[this.#e,this.#o]=[e,n],this.element=p("div",{class:"st\
rip-of-episodes"},this.#r,this.#a)}show(e,n,r){let{selected:o}=this.#e;o.seed===null&&gt.set(yt(o,o.episode),Vo(r)),this.#i(n),Gi(this.#n),this.#t(e,n)}#t(e,n){
let{selected:r}=this.#e,s=Ae(n,r.pursuer,r.evader)?.rates.findIndex((a,i)=>!gt.has(yt(r,i)))??-1;s<0||s>=Go||(this.#n=ji(()=>{this.#e.selected===r&&(this.#o.playing||
(gt.set(yt(r,s),Vo(xe(e,n,{...r,episode:s,seed:null}))),this.#i(n)),this.#t(e,n))}))}#i(e){let{selected:n}=this.#e,r=Ae(e,n.pursuer,n.evader);if(!r){this.#r.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(Go,r.rates.length);this.#r.replaceChildren(...r.rates.slice(0,o).map(
(c,u)=>this.#u(c,u)));let s=r.rates.slice(0,o).map((c,u)=>gt.get(yt(n,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-r.rates[u])>1e-6||c.
length!==r.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===r.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<r.rates.length?`Played here: ${a.length} of ${r.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${D(l,3)}. The cell says ${D(r.rate,3)}.`}#u(e,n){let{selected:r}=this.#e,o=p("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${D(e)}`,"aria-label":`\
Episode ${n+1}, capture rate ${D(e)}`,"aria-pressed":String(n===r.episode&&r.seed===null),"data-played":gt.has(yt(r,n)),onclick:()=>this.#e.select({episode:n,seed:null})},
o,p("span",{class:"count"},n+1))}},Vo=t=>({rate:t.statistics.capture_rate,length:t.length}),ji=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),Gi=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var he=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,qe=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var qo=0,Ko=1,Vi=2,qi=176;function Zo(t,e,n,r){let o=devicePixelRatio||1,s=We(t);t.width=t.height=qi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;n&&u<i*i;u++){let[d,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!n[f*i*i+u];h(Vi)&&(a.fillStyle=
s.obstacle,a.fillRect(d-l/2,m-l/2,l,l));let g=h(qo)&&h(Ko)?l*.18:0;h(qo)&&Yo(a,Te,d+g,m+g,l*.74,s.evader),h(Ko)&&Yo(a,Ut,d-g,m-g,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Yo(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var Kt=class{element;#e;#o=p("canvas",{class:"seen",role:"img"});#r=p("h3");#a=p("p",{class:"small muted"});#n=p("div",{class:"answers"});#t=null;#i=null;#u=null;#d=null;#c=null;#l=0;constructor(e){
this.#e=e,this.element=p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),p("div",{class:"inspected"},this.#o,p("div",{class:"answer"},this.#r,this.#a),this.#n))}get agent(){return this.#c}show(e,n,r,o){(this.#i!==n||
!this.#t)&&(this.#t?.free(),this.#t=e.world(n.world),this.#c!==null&&this.#i!==n&&this.choose(null)),[this.#i,this.#u,this.#d]=[n,r,o]}choose(e){this.#c=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let n=this.#u;if(!n)return;let r=this.#c??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+e+n.n_agents)%n.n_agents,n.alive[this.#l*n.n_agents+r])return this.choose(r)}at(e){this.#l=e;let[n,r,o,s,a]=[this.#u,this.#t,this.#i,this.#d,this.#c];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#r.replaceChildren(p("span",{class:i},he(a,n.config.n_pursuers)));let l=!!n.alive[e*
n.n_agents+a];n.seek(r,e),Zo(this.#o,n.config,l?r.view(a):null,a),this.#o.ariaLabel=`Field of view of ${he(a,n.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<n.length?n.actions[e*n.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let u=Q(o,i,s[i]);if(typeof u=="string")return this.#s([],
`The script "${u}" plays for it${c===null?"":`; it goes ${qe[c]}`}.`);let{probabilities:d}=r.answer(u,a),m=Array.from(d,(g,f)=>Ki(qe[f],g,f===c)),h=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#s(m,c===null?"The episode is over.":h)}#s(e,n){this.#n.replaceChildren(
...e),this.#a.textContent=n}};function Ki(t,e,n){let r=p("span",{class:"filled"});return r.style.width=`${100*e}%`,p("div",{class:n?"action taken":"action"},p("\
span",{},t),p("span",{class:"track"},r),p("span",{class:"numbers"},e.toFixed(2)))}function Jo(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Xo="champion";var Yi=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Qo(t,e){return Object.keys(e).find(n=>Yi(e[n],t))??null}var vt="_",Ji="n",Sd=2n**64n-1n;var Vn={fov:11,maxSteps:500,rewards:"paper"},Xi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function os(t,e){let n=i=>i.map(l=>el(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Qi(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ts(
t.rules,e),others:t.others?ts(t.others,e):"",rewards:o===Vn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Vn.fov?"":String(t.fov),
limit:t.maxSteps===Vn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(vt),pursuers:t.pursuers.map(es).join(vt),
evaders:t.evaders.map(es).join(vt),played:t.played.map(n).join(vt),next:t.next.every(i=>i===0)?"":n(t.next)};return Xi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function es({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ts(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Qo(t,e.variants)??n.join(".")}function Qi(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(vt)}function el(t,e){if(typeof t=="number")return String(t);if(t===Xo)return Ji;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var tl="/* the engine */";function ss(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>qn(t(),e)},"What if?")}function qn(t,e){let n=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.match.config.
cols)<=64,r=n?os(nl(t.match,t.step),e):"",o=new TextDecoder().decode(On("playground")).replace(tl,()=>Pt("script-engine")).replace("</noscript>",s=>n?s+Jo(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${r}`)}function nl(t,e){let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,
c=o*n.n_evaders+i-n.n_pursuers,u=d=>i>=n.n_pursuers&&!!d[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,
fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}function Yt(t,e,n){if(n===0)return[{kind:"start",text:rl(t),agents:[]}];let[r,o]=[e.moments[n-1],e.moments[n]],s=u=>he(u,t.config.n_pursuers),a=ct(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Ot(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:d,agents:m})=>({kind:u,text:d,agents:m}))),n===t.length&&c.unshift({kind:"\
end",text:ol(t),agents:[]}),c}function rl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ol(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var sl=60,Zt=class{element;player=new be(0,{speed:je,still:oe()});inspector;actions;#e;#o;#r;#a;#n=p("h2",{class:"match-title"});#t=p("p",{class:"tally numbers"});#i=p(
"ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#u=p("p",{class:"problem",role:"alert"});#d=null;#c=null;#l=null;#s=null;#h=0;#f=!1;#p=0;constructor(e,n,r){
[this.#o,this.#r]=[e,n];let o=p("canvas",{"aria-label":"The match"});this.#e=new ve(o,{numbers:!1}),this.#a=new qt(n,this.player),this.inspector=new Kt(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"\
to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),
ss(()=>this.shown,r)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},
this.#n,this.#t),this.#u,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#i,Fo(),this.actions,this.inspector.element),Ve(this.player),this.#a.element)),
this.player.addEventListener("frame",()=>this.#s&&this.#e.show(this.#s,this.player.time)),this.player.addEventListener("step",()=>this.#b()),n.on("match",()=>this.#S()),
n.on("rest",()=>this.player.pause()),this.#v(),this.#w(0,0)}get#m(){return this.#o[this.#r.selected.run]}get match(){return this.#c}get recording(){return this.#s}reveal(){
this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.#c&&this.#l&&{match:this.#c,step:this.player.step,champions:this.#l}}start(e){this.#d=e,
this.#g()}playSoon(){this.#f=!0,this.#h||this.#y()}goTo(e){this.#p=e,!this.#h&&this.#c&&this.#g()}#y(){!this.#f||!this.#c||(this.#f=!1,this.player.jump(0),oe()||
this.player.play())}#S(){this.#v(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#g(),sl)}#g(){clearTimeout(this.#h),this.#h=0,this.player.pause(),this.#v();
let{selected:e}=this.#r,n=ze.map(s=>Ee(this.#m,s,e[s])).find(Boolean)??"";if(this.#u.textContent=n,n||!this.#d)return;this.#c=xe(this.#d,this.#m,e);let[r,o]=this.
names(e);this.#l={pursuer:{name:r,policy:Q(this.#m,"pursuer",e.pursuer)},evader:{name:o,policy:Q(this.#m,"evader",e.evader)}},this.#s=Vt(this.#c),this.#a.show(this.#d,
this.#m,this.#c),this.inspector.show(this.#d,this.#m,this.#c,e),this.player.length=this.#c.length,this.player.marks=ro(this.#s),this.player.jump(this.#p),this.#p=
0,this.#b(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#y()}names({run:e,pursuer:n,evader:r}){let{teams:o}=this.#o[e];
return[o.pursuer.script??`pursuers ${n}`,o.evader.script??`evaders ${r}`]}#v(){let{episode:e,seed:n}=this.#r.selected,{payoff:r}=this.#m,[o,s]=this.names(this.#r.
selected),a=n===null?e<r.episodes?`episode ${e+1} of ${r.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${n}`;this.#n.replaceChildren(p("span",{class:"\
pursuer"},o)," against ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#b(){let e=this.#c;if(!e||!this.#s)return;let n=this.player.step,r=this.#s.
moments[n];this.#w(Array.from(r.everCaptured).filter(Boolean).length,n),this.#i.replaceChildren(...Yt(e,this.#s,n).map(o=>p("li",{class:o.kind,"data-agents":o.agents.
join(" ")},o.text))),this.inspector.at(n),this.#M()}#w(e,n){this.#t.replaceChildren(p("strong",{},e),` of ${this.#m.world.n_evaders} captured`,p("span",{class:"\
muted"},` · step ${n}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let n of this.#i.children){let r=n.
dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}};var al={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},il=5;function ke(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=al[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,c]=n(),u=o.shiftKey?il:1,{pursuer:d,evader:m}=e.selected;e.
select({pursuer:as(d+u*a,l),evader:as(m+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var as=(t,e)=>Math.min(e-1,Math.max(0,t));var ll=24,Jt=7,ls=t=>t<ll&&matchMedia("(pointer: coarse)").matches;function cs(t,e,n,r){let[o,s]=t.payoff.shape,[a,i]=[is(e,o),is(n,s)],[l,c]=[Math.min(Jt,o),Math.
min(Jt,s)],u=[];for(let g=a+l-1;g>=a;g--){u.push(p("span",{class:"pursuer"},g));for(let f=i;f<i+c;f++)u.push(cl(t,g,f,r))}let d=Array.from({length:c},(g,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...u,m,...d);return h.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,h.addEventListener("click",g=>g.stopPropagation()),
h}function cl(t,e,n,r){let o=Ae(t,e,n)?.rate,s=p("button",{type:"button","aria-label":`${D(o)}: pursuers ${e} against evaders ${n}`,onclick:()=>r({pursuer:e,evader:n})},
D(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Wt(o),Ht(o)]),s}var is=(t,e)=>Math.max(0,Math.min(e-Jt,t-Math.floor(Jt/2)));var ne={left:52,bottom:46,top:76,right:84},le=10,ul=160,bt=ne.right-le-14,Re=ne.top-le-14,Xt=class{element;#e;#o;#r=p("canvas",{"aria-hidden":"true"});#a=M("svg",
{"aria-hidden":"true"});#n=M("g");#t;#i=p("h2");#u=p("strong",{class:"rate numbers"});#d=p("span",{class:"small muted"});#c=p("p",{class:"of-both-teams small mu\
ted numbers"});#l=null;constructor(e,n){[this.#o,this.#e]=[e,n],this.#t=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#r,this.#a);let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#i,this.#c),p("div",{class:"of-cell"},this.#u,this.#d));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#t,Gt("0 all escape","1 all caught")),this.#y(),new ResizeObserver(()=>this.#h()).
observe(this.#t),this.#t.addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>n.point({})),this.#t.addEventListener("click",
o=>this.#b(o)),this.#t.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ke(this.#t,
n,()=>this.#s.payoff.shape),this.#t.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),n.on("run",()=>this.#h()),n.on("match",()=>this.#m()),n.on("hove\
r",()=>this.#m())}get#s(){return this.#o[this.#e.selected.run]}#h(){let[e,n]=this.#s.payoff.shape,{clientWidth:r,clientHeight:o}=this.#t;if(r<50)return;let a=Math.
max(ul,Math.min(r-ne.left-ne.right,o-ne.top-ne.bottom))/Math.max(e,n),i=Math.max(ne.left,(r-n*a-ne.right+ne.left)/2),l=ne.top+Math.max(0,(o-ne.top-ne.bottom-e*a)/
2),c={width:r,height:o,left:i,top:l,cell:a,rows:e,columns:n};this.#l=c,jt(this.#r,this.#s.payoff,{left:i,top:l,width:n*a,height:e*a}),this.#a.setAttribute("view\
Box",`0 0 ${r} ${o}`),this.#a.replaceChildren(dl(c),...pl(c),...this.#p(c),this.#n),this.#m()}#f(e){let n=this.#s.findings?.generalization;if(!n)return[];let{selected:r,
hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??r.evader],[i,l]=us(e,n.pursuers.mean[s]??0,s),[c,u]=ds(e,n.evaders.mean[a]??0,a);return[M("circle",{class:"\
dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#p(e){let n=this.#s.findings?.generalization;if(!n)return[];let{left:r,top:o,
cell:s,rows:a,columns:i}=e,[l,c]=[r+i*s+le,o-le],u={class:"side"};return[M("rect",{...u,x:l,y:o,width:bt,height:a*s}),M("rect",{...u,x:r,y:c-Re,width:i*s,height:Re}),
...ps(n.pursuers,(d,m)=>us(e,d,m),"of-pursuers"),...ps(n.evaders,(d,m)=>ds(e,d,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),
M("text",{class:"tick",x:l+bt,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:r-6,y:c-4,"text-anchor":"end"},"0"),M("text",{class:"tick",x:r-6,y:c-
Re+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+bt,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-evaders",x:r+i*s+
le,y:c-Re+10,"text-anchor":"start"},"escapes")]}#m(){let e=this.#l;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+
(i-1-g)*a,u=[],d=(g,f)=>M("rect",{class:f,x:o,y:c(g),width:l*a+le+bt,height:a}),m=(g,f)=>M("rect",{class:f,x:o+g*a,y:s-le-Re,width:a,height:le+Re+i*a});u.push(d(
n.pursuer,"strip pursuer"),m(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(d(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(m(r.
evader,"strip hover")),u.push(...this.#f(e));let h={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};u.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#n.replaceChildren(...u),this.#y()}#y(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=Ae(this.#s,r,o);this.#i.
replaceChildren(p("span",{class:"pursuer"},`Pursuers ${r}`)," against ",p("span",{class:"evader"},`evaders ${o}`)),this.#u.textContent=s?D(s.rate,3):"-",this.#d.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#c.textContent=this.#S(r,o)}#S(e,n){let r=this.#s.findings?.
generalization;if(!r)return"";let o=(s,a)=>Wo(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(r.pursuers,e)}, escapes ${o(r.evaders,
n)}`}#g(e){let n=this.#l;if(!n)return null;let r=this.#t.getBoundingClientRect(),o=Math.floor((e.clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-
r.top-n.top)/n.cell),[a,i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){let n=this.#g(e);this.#e.point(n?{pursuer:n.
g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#b(e){let n=this.#g(e);if(n){if(n.inside&&ls(this.#l.cell))return this.#w(n.g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.
g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#x()}}#w(e,n){let r=cs(this.#s,e,n,o=>{r.remove(),o&&(this.#e.select(o),this.#x())});this.#t.append(r)}#x(){this.#t.
dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function dl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"axes"}),a=e+r*n,i=l=>ft(0,l-1,Math.
min(l,l*n/44),!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*n,y:a+16,"text-anchor":"middle"},l));for(let l of i(r))s.append(M("text",{class:"\
tick",x:t-7,y:a-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*n/2,y:a+36,"text-anchor":"\
middle"},"evader generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generat\
ion")),s}function pl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;for(let u of["H","V"]){
let d=`M${t} ${i}`;for(let m=1;m<=a;m++){let[h,g]=[`H${t+m*n}`,`V${i-m*n}`];d+=u==="H"?h+g:g+h}s.append(M("path",{d,class:"under"}),M("path",{d}))}let[l,c]=[t+a/
2*n-.7*n-4,i-a/2*n-.7*n-4];return[s,M("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var us=({
left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+le+s*bt,e+(r-a-.5)*n],ds=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-le-r*Re];function ps(t,e,n){let r=s=>s.map(
(a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].join("\
L")}Z`})),o.push(M("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function se(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}function ms(t,e,n){let{findings:r}=t;if(!r?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&hl(o,t,i,e,
l)},a=r.checkerboards.map(i=>ml(t,i,s));return{element:se("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Cl\
ick one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?
p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise m\
akes."):null,o)}}var hs=({pursuers:[t,e],evaders:[n,r]})=>[[t,n],[t,r],[e,n],[e,r]];function ml(t,e,n){let[r,o]=e.pursuers,[s,a]=e.evaders,i=hs(e).map(([l,c])=>{
let u=t.payoff.capture_rate[l][c],d=p("span",{class:"cell"},D(u));return d.style.backgroundColor=Wt(u),d.style.color=Ht(u),d});return p("button",{type:"button",
class:"miniature numbers",onclick:()=>n(e)},p("span",{},p("span",{class:"heard"},`Four matches of pursuers ${r} and ${o}, evaders ${s} and ${a}:`)),p("span",{class:"\
evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},r),i[0],i[1],p("span",{class:"pursuer"},o),i[2],i[3])}function hl(t,e,n,r,o){let s=hs(n).filter(
([m,h])=>!Ee(e,"pursuer",m)&&!Ee(e,"evader",h)),a=s.map(([m,h])=>xe(o,e,{run:r.selected.run,pursuer:m,evader:h,episode:0,seed:null})),i=new be(Math.max(0,...a.map(
m=>m.length)),{speed:je,still:oe()}),l=a.map((m,h)=>{let[g,f]=s[h],v=p("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),b=p("span",{class:"numbers"}),
S=()=>{t.close(),r.select({pursuer:g,evader:f})},y=p("figure",{},v,p("figcaption",{class:"small"},b,p("span",{class:"muted"},`cell ${D(e.payoff.capture_rate[g][f])}`),
p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));return y.style.gridArea=`${n.pursuers.indexOf(g)+2} / ${n.evaders.indexOf(f)+2}`,{element:y,
match:m,recording:Vt(m),board:new ve(v,{numbers:!1}),tally:b}}),c=()=>l.forEach(m=>m.board.show(m.recording,i.time)),u=()=>l.forEach(({recording:m,match:h,tally:g})=>{
let f=m.moments[Math.min(i.step,h.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener(
"frame",c),i.addEventListener("step",u),t.replaceChildren(p("header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},
"Close")),p("div",{class:"grid-of-four"},p("span"),...n.evaders.map(m=>p("h3",{class:"evader"},`evaders ${m}`)),...n.pursuers.map((m,h)=>{let g=p("h3",{class:"p\
ursuer"},`pursuers ${m}`);return g.style.gridArea=`${h+2} / 1`,g}),...l.map(m=>m.element)),Ve(i));let d=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof
HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&we(i,m)&&m.preventDefault()};t.addEventListener("keydown",d),t.addEventListener("close",()=>{t.removeEventListener(
"keydown",d),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},{once:!0}),r.dispatchEvent(new Event("rest")),t.showModal(),c(),u(),oe()||i.play()}var Qt={pursuer:"evader",evader:"pursuer"};function fs(t,e){let n=t.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${D(s)}, stripes ${D(a)}${i===null?"":` every ${i} generations`}`;return fl(t,o,l,e)});return{element:se("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element)),Gt("0 loses","1 wins")),
update:()=>r.forEach(o=>o.update())}}function fl(t,e,n,r){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(y,w)=>e==="pursuer"?t.payoff.
capture_rate[y][w]:1-t.payoff.capture_rate[w][y],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let y=0;u&&
y<s;y++)for(let w=0;w<=Math.min(y,a-1);w++)u.data.set([...Ge(i(y,w)),255],4*((s-1-y)*a+w));u&&c?.putImageData(u,0,0);let d=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,d),g=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${n}. Arrow keys choose a match.`},l,h);ke(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=y=>{let w=g.
getBoundingClientRect(),A=Math.floor((y.clientX-w.left)/w.width*a),T=s-1-Math.floor((y.clientY-w.top)/w.height*s);return A>=0&&T<s&&A<=T?[T,A]:null},v=y=>({[e]:y[0],
[Qt[e]]:y[1]});g.addEventListener("pointermove",y=>r.point(f(y)?v(f(y)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",y=>f(
y)&&r.select(v(f(y))));let b=()=>{let y=r.hover[e]??r.selected[e],w=r.hover[Qt[e]]??r.selected[Qt[e]];for(let A of[d,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-y)),A.style.display=w<=y?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),g,p("p",{class:"smal\
l muted"},`horizontal: ${Qt[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},n)),update:b}}var en={left:46,right:12,top:10,bottom:42},gs={x:56,y:34};function Kn(t,e,n,r){let[o,s]=[en.left,en.top],a=Math.max(o+40,t-en.right),i=Math.max(s+40,e-en.bottom),
l=(f,v,b)=>S=>v+(S-f.low)/(f.high-f.low||1)*(b-v),[c,u]=[l(n,o,a),l(r,i,s)],d=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of ft(r.low,r.high,(i-s)/gs.y,r.whole))h.append(M("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),M("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},ys(f)));for(let f of ft(n.low,n.high,(a-o)/gs.x,n.whole))h.append(M("text",{x:c(f),y:i+16,"text-anchor":"middle"},ys(f)));return h.
append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},n.label),M("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),m.append(h,d),{root:m,marks:d,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let v=f-m.getBoundingClientRect().
left;return n.low+(v-o)/(a-o)*(n.high-n.low)}}}var ys=t=>String(Number(t.toPrecision(6))).replace("-","−");function Yn(t,e,n,r){let o="",s="M";n.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=M("path",{d:o,class:`line ${r}`});return t.root.insertBefore(a,t.marks),a}function Zn(t,e,n,r=null){
let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(r),r:5,class:`dot ${n}`}))}
function Jn(...t){return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function Xn(t,e,n={}){let r=p("div",{class:"chart",role:"\
img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&n.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=r;i<50||l<50||(o=e(i,l),r.replaceChildren(
o.root),s())};return n.choose&&(r.classList.add("chooses"),r.addEventListener("click",i=>o&&n.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(r),{
element:r,redraw:a,remark:s}}var Qn=["of-pursuers","of-evaders","of-both"],gl=2500,vs="Arrow keys choose generations.",yl={low:0,high:1,label:"capture rate"};function bs(t,e){let{training:n}=t,
{capture_rate:r,generation:o,learner:s,epochs:a}=n,i=r.map((g,f)=>(f+1)*a),l=vl(r,n.window),c=i.at(-1)??1,u=i.length>gl?"dense":"",d=(g,f)=>{let v=o.flatMap((b,S)=>b===
g&&(s[S]===f||s[S]===2)?[S]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},m=Xn(`Capture rate in ${c} epochs of training. ${vs}`,(g,f)=>{let v=Kn(g,f,{low:0,high:c,
label:"epoch",whole:!0},yl);for(let[b,S]of[["raw",r],[u,l]])for(let[y,w]of Qn.entries()){let A=S.map((T,E)=>s[E]===y||s[E+1]===y?T:null);A.some(T=>T!==null)&&Yn(
v,i,A,`${w} ${b}`)}return v},{marks:g=>{let{pursuer:f,evader:v}=e.selected;for(let[b,S]of[[0,f],[1,v]]){let y=d(e.hover[b?"evader":"pursuer"]??S,b);y&&Zn(g,(y[0]+
y[1])/2,Qn[b])}},choose:g=>{let f=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),v=o[f];s[f]!==1&&e.select({pursuer:Math.min(v,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(v,t.payoff.shape[1]-1)})}});ke(m.element,e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders lear\
n","both teams learn"][g],Qn[g]]);return{element:se("Training",`${jo(n.matches)} training matches. Lines: the generations that are selected.`,Jn(...h),m.element),
update:m.remark}}function ws(t,e){let n=t.findings?.ratings;if(!n)return null;let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(u=>u??
0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...t.payoff.shape)-1,c=Xn(`Elo ratings by generation. ${vs}`,(u,d)=>{let m=Kn(u,d,{low:0,high:l,
label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let h of["pursuer","evader"])Yn(m,r[h].map((g,f)=>f),r[h],`of-${h}s`);return m},{marks:u=>{
for(let d of["pursuer","evader"]){let m=e.hover[d]??e.selected[d];Zn(u,m,`of-${d}s`,r[d][m]??null)}},choose:(u,d,m)=>{let h=Math.round(u),g=m.clientY-d.root.getBoundingClientRect().
top,f=b=>Math.abs(d.y(r[b][h]??1/0)-g),v=f("pursuer")<=f("evader")?"pursuer":"evader";h>=0&&h<r[v].length&&e.select({[v]:h})}});return ke(c.element,e,()=>t.payoff.
shape),{element:se("Ratings",`One number for each generation, which cycles do not fit. The game itself: ${D(n.offset,0)} points for the pursuers.`,Jn(["pursuers",
"of-pursuers"],["evaders","of-evaders"]),c.element),update:c.remark}}function vl(t,e){let n=[0];for(let r of t)n.push(n.at(-1)+r);return t.map((r,o)=>{let[s,a]=[
Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(n[a]-n[s])/(a-s)})}var bl={present:"●",absent:"○","cannot tell":"?"};function xs(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],c)=>{
let u=wl(e.reasons[c]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},bl[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=se("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${Ss(s)}.`)),p("ul",{class:"findings"},...r),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function wl(t){let[,e=""]=t.split(/, because (.*)/s);return Ss(e.replace(/\.$/,""))}var Ss=t=>t.charAt(0).toUpperCase()+t.slice(1);function As(t){let e=t.settings.filter(o=>o.changed),n=t.settings.filter(o=>!o.changed),r=se("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an opti\
on of matrixworld evolve.`,e.length?Ms(e,"other than the default"):p("p",{class:"small"},"All settings are the defaults."),p("details",{class:"small"},p("summar\
y",{},`${n.length} settings with their defaults`),Ms(n,"defaults")));return r.classList.add("settings"),{element:r}}function Ms(t,e){return p("div",{class:"wide\
-table"},p("table",{class:"small"},p("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:n,value:r,help:o})=>p("tr",{},p("th",{scope:"row"},`--${n.replaceAll(
"_","-")}`),p("td",{class:"numbers"},r),p("td",{class:"muted"},o)))))}function Es(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??xl(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function xl(t,e,n){return[xs(t),bs(t,e),ms(t,e,n),ws(
t,e),fs(t,e),As(t)].filter(o=>o!==null)}var on=fa(Bs(),1);var or=125,Wl=80,jl=10,zs=480,Gl=[1,.8,.6,.4,.2],Vl=5;async function Ds(t,e){let n=Math.min(1,dt(t.rows,t.cols)),[r,o]=[Math.round(zs*n),Math.round(zs*n/dt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[r,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=We(document.documentElement),l={ctx:a,colors:i,
grid:Dt(t.rows,t.cols,!1,r,o,1)},[c,u]=[ql(i,a),(0,on.GIFEncoder)()];for(let d=0;d<or;d++){let m=Math.min(1,d/(or-jl))*(t.moments.length-1);zt(l,t,m,{...Bt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,r,o),a.globalCompositeOperation="source-over",u.writeFrame((0,on.applyPalette)(
a.getImageData(0,0,r,o).data,c),r,o,{palette:c,delay:Wl}),d%Vl===0&&(e(Math.round(100*d/or)),await new Promise(h=>setTimeout(h)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function ql(t,e){let n=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),r=n(t.
paper);return Object.values(t).map(n).flatMap(o=>Gl.map(s=>o.map((a,i)=>Math.round(r[i]+s*(a-r[i])))))}function Fs(t,e){let n=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),r=p("p",{class:"muted small",role:"status"}),o=async()=>{n.select();
try{await navigator.clipboard.writeText(n.value),r.textContent="Copied."}catch{r.textContent="Selected: copy it with Ctrl+C."}},a=p("button",{type:"button",class:"\
save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:c,evader:u}=e.selected;a.disabled=!0;let d=await Ds(t.recording,h=>r.textContent=`Drawing: ${h} %`),
m=URL.createObjectURL(d);p("a",{href:m,download:`pursuers-${c}-evaders-${u}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(m),6e4),r.textContent=`Saved, ${(d.
size/1e6).toFixed(1)} MB.`,a.disabled=!1}},"Save the match as a GIF of 10 s"),i=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{id:"share-tit\
le"},"Share this match"),a,ot()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),ot()&&p("div",{class:"link"},n,p("button",{
type:"button",onclick:o},"Copy")),r,p("button",{type:"button",onclick:()=>i.close()},"Close"));return i.addEventListener("click",c=>c.target===i&&i.close()),{button:p(
"button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),n.value=location.href,r.textContent="",i.showModal()}},"Share"),dialog:i}}var Hs={pursuer:null,evader:null},sn=class extends EventTarget{#e;#o=Hs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#o}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...Hs,...e};n.pursuer===this.#o.pursuer&&n.evader===this.#o.evader||(this.#o=n,this.dispatchEvent(
new Event("hover")))}on(e,n){this.addEventListener(e,n)}};var an=class{config;start;recording;actions=[];#e;#o;#r=[[]];constructor(e,n,r){[this.config,this.start]=[n,r],this.#e=e.world(n),this.#e.reset(r),this.#o=[Gn(this.#e)],
this.recording=jn(n,this.#e.map(),this.#o)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#r[e]}play(e){this.#e.step(e),this.#a(e)}step(e,n,r){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,[Math.max(l,s),c],a)),typeof r==
"number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#o.push(Gn(this.#e,e)),this.#r.push(this.#e.conflicts())}};var fe=(t,e)=>ze[+(e>=t.n_pursuers)];function sr(t,e){let n=new an(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.
seat,r);return n}function Ke(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var ln=(t,e)=>t.over||Ke(t,e).out;function Ws(t,e,n){let r=sr(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!ln(r,e.seat);)r.step(e.policies,e.seat,n);return Ke(r,e.seat)}function js(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}
function Gs(t,{seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Vs(t,e){let[n,r,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function ar(t,e,n,r,o,s){e.play({title:n,played:r,ending:(a,i)=>[Kl(t,a,i,js(o))],again:()=>ar(t,e,n,{...r,moves:r.moves.slice(0,r.from)},o,s),link:a=>Gs(s,a)})}
function Kl(t,e,n,r){let o=fe(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,d]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},c),p("td",{class:"track","aria-hidden":"true"},u),d)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,
d.textContent=String(o?m:h)}};i("You")(Ke(e,n.seat));for(let{name:c,policy:u}of r){let d=i(c);setTimeout(()=>d(Ws(t,n,u())))}let l=n.from?`You took over at step\
 ${n.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var qs=["·","↑","→","↓","←","↗","↘","↙","↖"];var Yl={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ir=[8,1,5,4,0,2,7,3,6],Zl=[7,8,9,4,5,6,1,2,3],Jl=24,Xl=Math.
tan(Math.PI/8);function Ys(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=Zl.findIndex(o=>t.code===`Numpad${o}`),r=ir[n]??Yl[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function Zs(t){let e=ir.map(n=>p("button",{type:"button","aria-label":qe[n],onclick:()=>t(n)},qs[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",ir[o]>4&&!n))}}function Ks(t,e,n){let r=Xl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return to([0,0],n?[o(t),o(e)]:[t,e],n)}function Js(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,e()];if(r=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(c,u)>=Jl?n(Ks(u,c,l.diagonal)):d&&n(Ks(d[0]-l.cell[0],
d[1]-l.cell[1],l.diagonal))})}function Xs(t,e){let n=r=>{let o=e[r]-t[r],s=De.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${qe[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var ta="NUMPY\0",Qs=ta.length+2,ea=64;function na(t){return Jr(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,Ql(n)])))}function Ql({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Qs+s.length+1)/ea)*ea-Qs,i=ta+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(Rt(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var ec="matrixworld episode 3";function ra(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},m=y=>{
for(let w of Object.keys(y))(d[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(r);h.reset(e.start);let g=[];m(c);for(let y of o)h.step(y),m({...c,...u}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[y,[w,...A]]of Object.entries({...c,...u})){let T=s+
+(y in c);v[y]={dtype:w,shape:[T,...A],data:f[w].from((d[y]??[]).flat())}}let b=y=>({dtype:"<i8",shape:[],data:Int32Array.of(y,0)}),S=y=>({dtype:"<U",shape:[],data:y});
return na({format:S(ec),n_pursuers:b(r.n_pursuers),config:S(JSON.stringify(r)),seat:b(n),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(y=>[
...y]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var tc=[0,1,2,4,8],cn=class{element;player=new be(0,{speed:4,still:oe()});#e;#o;#r=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=p("h2");#n=p("p",{
class:"play-told",role:"status"});#t=Zs(e=>this.act(e));#i=p("select",{},...tc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#u=p("input",{type:"ch\
eckbox"});#d=p("section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#c=Ve(this.player);#l=null;#s=null;#h=[];#f=null;#p=0;#m=0;constructor(e){
this.#e=e,this.#o=new ve(this.#r,{numbers:!1}),this.#r.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#g()),this.#u.addEventListener(
"change",()=>this.#S()),Js(this.#o,()=>{let n=this.#f!==null&&this.#s&&L(this.#s.recording.moments.at(-1),this.#f);return n?{cell:n,diagonal:this.#s.config.diagonal}:
null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#s&&this.#o.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#M()),
this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#a,this.#n),p("div",{class:"play-stage"},this.#r),p("div",{class:"play-side"},this.#d,this.#t.
element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),p("label",{class:"play-choice"},this.#u," Fog: see only what it sees"),p("p",{class:"\
small muted play-keys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or t\
ap where to go.")),this.#c)}get played(){return this.#l&&{...this.#l.played,moves:this.#h}}get live(){return this.#s}play(e){this.#y(sr(this.#e,e.played),e.played.
seat,e.title),[this.#l,this.#h,this.#p]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#r.focus({preventScroll:!0}),ln(this.#s,e.played.seat)&&
this.#b()}watch(e,n,r){this.#l=null,this.#y(e,n,r),this.#w()}stop(){this.#g(),this.player.pause(),this.#l=null}act(e){let[n,r]=[this.#l,this.#s];if(!n||!r||this.
element.dataset.state!=="playing")return;this.#p=e;let o=Number(this.#i.value);this.#m||(this.#v(),o&&this.element.dataset.state==="playing"&&(this.#m=setInterval(
()=>this.#v(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&
(r===" "||r==="Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return we(this.player,e);let s=Ys(e,this.#s.config.diagonal);return s!==void 0&&
this.act(s),s!==void 0}#y(e,n,r){this.#g(),this.player.pause(),[this.#s,this.#f]=[e,n],this.#a.textContent=r,this.#r.ariaLabel=`Board, ${e.config.rows} by ${e.config.
cols} cells`,this.#t.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#S(),this.#M()}#S(){this.#o.look=
{you:this.#f,fog:this.#u.checked,viewers:this.#f===null?[]:[this.#f]}}#g(){clearInterval(this.#m),this.#m=0,this.#n.ariaLive=Number(this.#i.value)?"off":"polite"}#v(){
let[{policies:e,seat:n},r]=[this.#l.played,this.#s];r.step(e,n,this.#p),this.#h.push(this.#p),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#i.value)||4)),this.player.move(r.length-this.player.step),ln(r,n)&&this.#b()}#b(){this.#g();let[e,n,r]=[this.#l,this.#s,this.played],o=ot()?e.link(r):null;
this.#d.replaceChildren(p("h3",{id:"play-headline"},oc(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.
again()},"Again"),p("button",{type:"button",onclick:()=>this.#w()},"Watch it"),p("button",{type:"button",onclick:()=>this.#x(n,r.seat)},"Save"),o&&p("button",{type:"\
button",onclick:({currentTarget:s})=>ac(s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"near\
est"})}#w(){this.element.dataset.state="watched",this.player.length=this.#s.length,this.player.jump(0),oe()||this.player.play()}#x(e,n){let r=new Blob([ra(this.#e,
e,n)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(r),download:`${he(n,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#M(){let[e,n,
{step:r}]=[this.#s,this.#f,this.player];if(!e||r>e.length)return;let o=Yt(e,e.recording,r).filter(({agents:a})=>n===null||a.includes(n)),s=[`Step ${r} of ${e.config.
max_steps}`,...o.map(({text:a})=>a)];this.#l&&r===0?s.push(nc(e.config,n)):n!==null&&s.push(rc(e,r,n)),this.#n.textContent=s.filter(Boolean).map(a=>`${a}.`).join(
" ")}};function nc(t,e){let n=t.rules.capture==="SURROUND";return fe(t,e)==="evader"?`Stay free: ${n?"pursuers on all sides of you capture":"a pursuer on your c\
ell captures"} you`:`Capture evaders: ${n?"surround them together":"reach their cell"}`}function rc({config:t,recording:e},n,r){let o=e.moments[n],a=fe(t,r)==="\
pursuer"?"evader":"pursuer";if(!o.alive[r])return"";let i=L(o,r),l=d=>{let[m,h]=L(o,d);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.
alive.length},(d,m)=>m).filter(d=>fe(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((d,m)=>l(
m)<l(d)?m:d);return`Nearest ${a}: ${Xs(i,L(o,u))}`}function oc(t,e){let[{lasted:n,out:r,captured:o},{config:s}]=[Ke(t,e),t];return fe(s,e)==="pursuer"?`Your tea\
m captured ${o} of ${sc(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var sc=({n_evaders:t})=>`${t} evader${t===1?
"":"s"}`;function ac(t,e){let n=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(n),n.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}var un=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#o;#r;#a=null;#n=null;constructor(e,n,r){[this.#e,this.#o,this.#r]=[e,n,r],r.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#n?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#n?.stop())}get view(){return this.#n}start(e,n){this.#a=e;let r=st(n,this.#e,this.#o.selected),o=Vs(new URLSearchParams(n.replace(/^#/,"")),this.#e[r.
run].world);o&&this.#t(r,o)}open(){let e=this.#r.shown;if(!e)return;let{match:n,step:r}=e;this.#r.player.pause();let o=this.#r.inspector.agent,s=r<n.length?r:0,
a=(d,m)=>!!n.alive[m*n.n_agents+d],i=Array.from({length:n.n_agents},(d,m)=>(m+n.config.n_pursuers)%n.n_agents),l=o??i.find(d=>a(d,s)),c=a(l,s)?s:0,u=Array.from(
{length:c},(d,m)=>n.actions[m*n.n_agents+l]);this.#t(this.#o.selected,{seat:l,from:c,moves:u})}#t(e,n){let[r,o]=[this.#a,this.#e[e.run]];if(!r||ze.some(f=>Ee(o,
f,e[f])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,u=fe(o.world,n.seat),d=o.teams[u].kept.map(f=>({name:o.teams[u].script??`generation ${f}`,policy:()=>Q(
o,u,f)}));this.#n||(this.#n=new cn(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#n.element)),this.
dialog.open||this.dialog.showModal();let m=`You are ${he(n.seat,o.world.n_pursuers)}: ${this.#r.names(e).join(" against ")}`,h={pursuer:Q(o,"pursuer",a),evader:Q(
o,"evader",i)},g={config:o.world,seed:BigInt(c??o.seeds[a][i]),episode:l,policies:h,...n};ar(r,this.#n,m,g,d,{run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:
{seed:c}})}};var ce=Qr(),{runs:Z}=ce,[ic,lc]=Z[0].payoff.shape,cc=st(location.hash,Z,{run:0,pursuer:ic-1,evader:lc-1,episode:0,seed:null}),{step:sa,...uc}=cc,Y=new sn(uc),F=new Zt(
Z,Y,ce.playground),aa=new Xt(Z,Y),Ze=new un(Z,Y,F),lr=Bo(),dc=location.hash,oa=Oo(Z,Y,F),{button:pc,dialog:mc}=Fs(F,Y);F.actions.append(pc);var Ye=null,ia=p("as\
ide",{class:"note small muted"},ce.note),hc="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";
document.getElementById("page").replaceWith(p("header",{class:"top"},p("div",{},p("h1",{},ce.heading),p("p",{class:"lead"},hc)),p("div",{class:"tools"},oa.button,
Or(),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>lr.showModal()},"?"))),...ce.note?[ia]:[],Uo(Z,Y),p("mai\
n",{class:"stages"},aa.element,F.element),Es(Z,Y,()=>Ye),p("footer",{class:"muted small"},`${ce.title} · matrixworld ${ce.version}`),Ze.dialog,lr,mc,oa.bar);Object.
assign(window,{matrixworldExplorer:{get match(){return F.match},get step(){return F.player.step},get pace(){return F.player.pace},get playing(){return Ze.view},
play:t=>Ye&&xe(Ye,Z[Y.selected.run],{...Y.selected,episode:t}),get shape(){return Z[Y.selected.run].payoff.shape}}});aa.element.addEventListener("play",()=>{F.playSoon(),
F.reveal()});F.goTo(sa);sa||F.playSoon();Nr(Z,Y,F);zo(Z,Y,F,lr,()=>Ze.open(),()=>qn(F.shown,ce.playground));window.addEventListener("hashchange",({newURL:t})=>Ye&&
Ze.start(Ye,new URL(t).hash));ce.live!==null&&Do(ce.live,Z,Y,()=>F.player.playing||Ze.dialog.open,()=>{ia.textContent="The command has ended. This page shows wh\
at it had played; explorer.html is beside the runs if they have finished."});requestAnimationFrame(()=>setTimeout(()=>{Ir().then(t=>{Ye=t,F.start(t),Ze.start(t,
dc),document.body.dataset.ready="true"},t=>{F.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.
dataset.ready="true"})}));})();
