/* built from web/ by "npm run build"; sources 5f46f7e84d6a93405a6e960492c66d3899b283756fa6dead71b4e105f600275f */
"use strict";(()=>{var ha=Object.create;var fr=Object.defineProperty;var fa=Object.getOwnPropertyDescriptor;var ga=Object.getOwnPropertyNames;var ya=Object.getPrototypeOf,va=Object.prototype.hasOwnProperty;var ba=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(n){throw e=0,n}};var wa=(t,e,n,r)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of ga(e))!va.call(t,o)&&o!==n&&fr(t,o,{get:()=>e[o],enumerable:!(r=fa(e,o))||r.enumerable});
return t};var xa=(t,e,n)=>(n=t!=null?ha(ya(t)):{},wa(e||!t||!t.__esModule?fr(n,"default",{value:t,enumerable:!0}):n,t));var js=ba(cr=>{var Is=Object.defineProperty,Ol=t=>Is(t,"__esModule",{value:!0}),Ll=(t,e)=>{for(var n in e)Is(t,n,{get:e[n],enumerable:!0})};Ol(cr);Ll(cr,{GIFEncoder:()=>Ws,
applyPalette:()=>Wl,default:()=>Xl,nearestColor:()=>Vl,nearestColorIndex:()=>zs,nearestColorIndexWithDistance:()=>Ds,prequantize:()=>Dl,quantize:()=>Fl,snapColorsToPalette:()=>Gl});
var Pl={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function Ns(t=256){let e=0,n=new Uint8Array(t);return{get buffer(){return n.buffer},reset(){e=0},bytesView(){return n.subarray(0,e)},bytes(){return n.slice(0,e)},
writeByte(o){r(e+1),n[e]=o,e++},writeBytes(o,s=0,a=o.length){r(e+a);for(let i=0;i<a;i++)n[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){r(e+a),n.set(o.subarray(
s,s+a),e),e+=a}};function r(o){var s=n.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=n;n=new Uint8Array(
o),e>0&&n.set(i.subarray(0,e),0)}}var ar=12,Os=5003,Il=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function Nl(t,e,n,r,o=Ns(512),s=new Uint8Array(
256),a=new Int32Array(Os),i=new Int32Array(Os)){let l=a.length,d=Math.max(2,r);s.fill(0),i.fill(0),a.fill(-1);let u=0,c=0,m=d+1,h=m,g=!1,f=h,y=(1<<f)-1,v=1<<m-1,
x=v+1,b=v+2,w=0,A=n[0],C=0;for(let S=l;S<65536;S*=2)++C;C=8-C,o.writeByte(d),T(v);let E=n.length;for(let S=1;S<E;S++)e:{let O=n[S],_=(O<<ar)+A,k=O<<C^A;if(a[k]===
_){A=i[k];break e}let Q=k===0?1:l-k;for(;a[k]>=0;)if(k-=Q,k<0&&(k+=l),a[k]===_){A=i[k];break e}T(A),A=O,b<1<<ar?(i[k]=b++,a[k]=_):(a.fill(-1),b=v+2,g=!0,T(v))}return T(
A),T(x),o.writeByte(0),o.bytesView();function T(S){for(u&=Il[c],c>0?u|=S<<c:u=S,c+=f;c>=8;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,c-=8;if((b>y||g)&&(g?(f=h,y=(1<<f)-1,g=!1):(++f,y=f===ar?1<<f:(1<<f)-1)),S==x){for(;c>0;)s[w++]=u&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),u>>=
8,c-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var Bl=Nl;function Bs(t,e,n){return t<<8&63488|e<<2&992|n>>3}function Us(t,e,n,r){return t>>4|e&240|(n&
240)<<4|(r&240)<<8}function Fs(t,e,n){return t>>4<<8|e&240|n>>4}function sn(t,e,n){return t<e?e:t>n?n:t}function Mt(t){return t*t}function Ls(t,e,n){var r=0,o=1e100;
let s=t[e],a=s.cnt,i=s.ac,l=s.rc,d=s.gc,u=s.bc;for(var c=s.fw;c!=0;c=t[c].fw){let h=t[c],g=h.cnt,f=a*g/(a+g);if(!(f>=o)){var m=0;n&&(m+=f*Mt(h.ac-i),m>=o)||(m+=
f*Mt(h.rc-l),!(m>=o)&&(m+=f*Mt(h.gc-d),!(m>=o)&&(m+=f*Mt(h.bc-u),!(m>=o)&&(o=m,r=c))))}}s.err=o,s.nn=r}function ir(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,
bk:0,tm:0,mtm:0,err:0}}function Ul(t,e){let n=e==="rgb444"?4096:65536,r=new Array(n),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>24&255,l=a>>
16&255,d=a>>8&255,u=a&255,c=Us(u,d,l,i),m=c in r?r[c]:r[c]=ir();m.rc+=u,m.gc+=d,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],i=a>>
16&255,l=a>>8&255,d=a&255,u=Fs(d,l,i),c=u in r?r[u]:r[u]=ir();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,d=a&255,
u=Bs(d,l,i),c=u in r?r[u]:r[u]=ir();c.rc+=d,c.gc+=l,c.bc+=i,c.cnt++}return r}function Fl(t,e,n={}){let{format:r="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,clearAlphaThreshold:a=0,
oneBitAlpha:i=!1}=n;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))
throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),d=n.useSqrt!==!1,u=r==="rgba4444",c=Ul(l,r),m=c.length,h=m-1,g=new Uint32Array(
m+1);for(var f=0,v=0;v<m;++v){let L=c[v];if(L!=null){var y=1/L.cnt;u&&(L.ac*=y),L.rc*=y,L.gc*=y,L.bc*=y,c[f++]=L}}Mt(e)/f<.022&&(d=!1);for(var v=0;v<f-1;++v)c[v].
fw=v+1,c[v+1].bk=v,d&&(c[v].cnt=Math.sqrt(c[v].cnt));d&&(c[v].cnt=Math.sqrt(c[v].cnt));var x,b,w;for(v=0;v<f;++v){Ls(c,v,!1);var A=c[v].err;for(b=++g[0];b>1&&(w=
b>>1,!(c[x=g[w]].err<=A));b=w)g[b]=x;g[b]=v}var C=f-e;for(v=0;v<C;){for(var E;;){var T=g[1];if(E=c[T],E.tm>=E.mtm&&c[E.nn].mtm<=E.tm)break;E.mtm==h?T=g[1]=g[g[0]--]:
(Ls(c,T,!1),E.tm=v);var A=c[T].err;for(b=1;(w=b+b)<=g[0]&&(w<g[0]&&c[g[w]].err>c[g[w+1]].err&&w++,!(A<=c[x=g[w]].err));b=w)g[b]=x;g[b]=T}var S=c[E.nn],O=E.cnt,_=S.
cnt,y=1/(O+_);u&&(E.ac=y*(O*E.ac+_*S.ac)),E.rc=y*(O*E.rc+_*S.rc),E.gc=y*(O*E.gc+_*S.gc),E.bc=y*(O*E.bc+_*S.bc),E.cnt+=S.cnt,E.mtm=++v,c[S.bk].fw=S.fw,c[S.fw].bk=
S.bk,S.mtm=h}let k=[];var Q=0;for(v=0;;++Q){let W=sn(Math.round(c[v].rc),0,255),L=sn(Math.round(c[v].gc),0,255),U=sn(Math.round(c[v].bc),0,255),$=255;u&&($=sn(Math.
round(c[v].ac),0,255),i&&($=$<=(typeof i=="number"?i:127)?0:255),o&&$<=a&&(W=L=U=s,$=0));let H=u?[W,L,U,$]:[W,L,U];if(zl(k,H)||k.push(H),(v=c[v].fw)==0)break}return k}
function zl(t,e){for(let n=0;n<t.length;n++){let r=t[n],o=r[0]===e[0]&&r[1]===e[1]&&r[2]===e[2],s=r.length>=4&&e.length>=4?r[3]===e[3]:!0;if(o&&s)return!0}return!1}
function ln(t,e){var n=0,r;for(r=0;r<t.length;r++){let o=t[r]-e[r];n+=o*o}return n}function an(t,e){return e>1?Math.round(t/e)*e:t}function Dl(t,{roundRGB:e=5,roundAlpha:n=10,
oneBitAlpha:r=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,d=a>>8&255,u=a&255;i=an(i,n),r&&(i=i<=(typeof r==
"number"?r:127)?0:255),u=an(u,e),d=an(d,e),l=an(l,e),o[s]=i<<24|l<<16|d<<8|u<<0}}function Wl(t,e,n="rgb565"){if(!t||!t.buffer)throw new Error("quantize() expect\
ed RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>
256)throw new Error("applyPalette() only works with 256 colors or less");let r=new Uint32Array(t.buffer),o=r.length,s=n==="rgb444"?4096:65536,a=new Uint8Array(o),
i=new Array(s),l=n==="rgba4444";if(n==="rgba4444")for(let d=0;d<o;d++){let u=r[d],c=u>>24&255,m=u>>16&255,h=u>>8&255,g=u&255,f=Us(g,h,m,c),y=f in i?i[f]:i[f]=Hl(
g,h,m,c,e);a[d]=y}else{let d=n==="rgb444"?Fs:Bs;for(let u=0;u<o;u++){let c=r[u],m=c>>16&255,h=c>>8&255,g=c&255,f=d(g,h,m),y=f in i?i[f]:i[f]=jl(g,h,m,e);a[u]=y}}
return a}function Hl(t,e,n,r,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],d=l[3],u=$e(d-r);if(u>a)continue;let c=l[0];if(u+=$e(c-t),u>a)continue;let m=l[1];
if(u+=$e(m-e),u>a)continue;let h=l[2];u+=$e(h-n),!(u>a)&&(a=u,s=i)}return s}function jl(t,e,n,r){let o=0,s=1e100;for(let a=0;a<r.length;a++){let i=r[a],l=i[0],d=$e(
l-t);if(d>s)continue;let u=i[1];if(d+=$e(u-e),d>s)continue;let c=i[2];d+=$e(c-n),!(d>s)&&(s=d,o=a)}return o}function Gl(t,e,n=5){if(!t.length||!e.length)return;
let r=t.map(a=>a.slice(0,3)),o=n*n,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>s?i=i.slice(0,3):i=i.slice();
let l=Ds(r,i.slice(0,3),ln),d=l[0],u=l[1];u>0&&u<=o&&(t[d]=i)}}function $e(t){return t*t}function zs(t,e,n=ln){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],
i=n(e,a);i<r&&(r=i,o=s)}return o}function Ds(t,e,n=ln){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return[o,r]}function Vl(t,e,n=ln){
return t[zs(t,e,n)]}function Ws(t={}){let{initialCapacity:e=4096,auto:n=!0}=t,r=Ns(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),i=new Int32Array(o),l=!1;
return{reset(){r.reset(),l=!1},finish(){r.writeByte(Pl.trailer)},bytes(){return r.bytes()},bytesView(){return r.bytesView()},get buffer(){return r.buffer},get stream(){
return r},writeHeader:d,writeFrame(u,c,m,h={}){let{transparent:g=!1,transparentIndex:f=0,delay:y=0,palette:v=null,repeat:x=0,colorDepth:b=8,dispose:w=-1}=h,A=!1;
if(n?l||(A=!0,d(),l=!0):A=!!h.first,c=Math.max(0,Math.floor(c)),m=Math.max(0,Math.floor(m)),A){if(!v)throw new Error("First frame must include a { palette } opt\
ion");Kl(r,c,m,v,b),Ps(r,v),x>=0&&Yl(r,x)}let C=Math.round(y/10);ql(r,w,C,g,f);let E=!!v&&!A;Zl(r,c,m,E?v:null),E&&Ps(r,v),Jl(r,u,c,m,b,s,a,i)}};function d(){Hs(
r,"GIF89a")}}function ql(t,e,n,r,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,r=!1);var s,a;r?(s=1,a=2):(s=0,a=0),e>=0&&(a=e&7),a<<=2,t.writeByte(
0|a|0|s),Ae(t,n),t.writeByte(o||0),t.writeByte(0)}function Kl(t,e,n,r,o=8){let i=lr(r.length)-1,l=128|o-1<<4|0|i,d=0,u=0;Ae(t,e),Ae(t,n),t.writeBytes([l,d,u])}function Yl(t,e){
t.writeByte(33),t.writeByte(255),t.writeByte(11),Hs(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Ae(t,e),t.writeByte(0)}function Ps(t,e){let n=1<<lr(e.length);
for(let r=0;r<n;r++){let o=[0,0,0];r<e.length&&(o=e[r]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function Zl(t,e,n,r){if(t.writeByte(44),Ae(t,0),Ae(
t,0),Ae(t,e),Ae(t,n),r){let a=lr(r.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function Jl(t,e,n,r,o=8,s,a,i){Bl(n,r,e,o,t,s,a,i)}function Ae(t,e){t.writeByte(
e&255),t.writeByte(e>>8&255)}function Hs(t,e){for(var n=0;n<e.length;n++)t.writeByte(e.charCodeAt(n))}function lr(t){return Math.max(Math.ceil(Math.log2(t)),1)}
var Xl=Ws});var gr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},rt={DISAPPEAR:0,REACH:1,BOUNCE:2},yr={OCCUPATION:0,SURROUND:1},vr={FAULT:0,INVOLVED:1};var gn=["obstacle","teammate","adversary"],yn=["vertex","edge","chain"],br=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],vn=["p\
ursuer_{number}","evader_{number}"],wr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ot={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},xr="{event}: {outcome}",bn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Sr={free:".GS",blocked:"#@OTW"};var Ne=1+br.length;function st(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function G(t,e){return t<e?st(vn[0],{number:t}):st(vn[1],{number:t-e})}function Sa(t,e){
let[n,r,o,s,a,i,l,...d]=Array.from(t),u=a<0?[s]:[s,a],[c,m,h]=d.map(v=>u.filter((x,b)=>v>>b&1)),g=u.map(v=>G(v,e)),f=st(wr[a<0?"obstacle":yn[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=st(xr,{event:f,outcome:Ma(u.length,m,h,e)});return{kind:gn[r],form:yn[o],agents:u,cell:[i,l],at_fault:c,held:m,doomed:h,turn:n,
text:y}}function Ma(t,e,n,r){if(t===2&&e.length===2)return ot["both held"];if(t===2&&n.length===2)return ot["both doomed"];let o=s=>a=>st(ot[s],{agent:G(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||ot.none}function Tt(t,e){let n=[];for(let r=0;r<t.length;r+=Ne)n.push(Sa(t.subarray(r+1,r+Ne),e));
return n}var ve=class extends Error{name="EngineError"};function F(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new ve(
`${t}: expected ${e}, got ${r}`)}var Be=class{bytes;constructor(e){this.bytes=e}},Er=0,xn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Mr=4,Ar=4,Aa=new TextEncoder,
Ea=new TextDecoder;function Ta(t){for(let e=xn.length-1;e>Er;--e)if(t instanceof xn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function wn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ca(t){return Aa.encode(`${t}\0`)}var Sn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(Ca(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Be,l=i?a.bytes:
a;return[this.text(s),i?Er:Ta(l),l.length,this.copy(wn(l))]}),o=this.copy(wn(Int32Array.from(r)));return this.copy(wn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Tr(t,e){let n=t.HEAPU8;return Ea.decode(n.subarray(e,n.indexOf(0,e)))}function Ue(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/Mr,r=e[n+1]/Mr,o={};for(let s=r;s<r+e[n]*Ar;s+=Ar){let a=xn[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Tr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function be(t,e){let n=new Sn(t);try{let r=e(n);if(r===0)throw new ve(Tr(t,t._last_error()));return r}finally{n.free()}}var ka=2**31-1,Cr=["none","elman","gru"],Ra=2n**64n-1n,_a=34028234663852886e22;function fe(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ka)throw F(
t,"an integer",e);return Int32Array.of(e)}function Ct(t,e){if(typeof e!="boolean")throw F(t,"true or false",e);return new Be(Uint8Array.of(Number(e)))}function Ee(t,e,n){
let r=typeof e=="string"&&Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw F(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function Mn(t,e){
if(typeof e!="number"||!(Math.abs(e)<=_a))throw F(t,"a finite number",e);return e}function Fe(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>Ra)throw F(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function $a(t){return{"rules.interaction":Ee("interactio\
n",t.interaction,gr),"rules.obstacle":Ee("obstacle",t.obstacle,rt),"rules.teammate":Ee("teammate",t.teammate,rt),"rules.evader":Ee("evader",t.evader,rt),"rules.\
pursuer":Ee("pursuer",t.pursuer,rt),"rules.capture":Ee("capture",t.capture,yr),"rules.captured_disappear":Ct("captured_disappear",t.captured_disappear)}}function kr(t,e){
let n=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw F(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>Mn(t,r))}function Oa(t){let e=(n,r)=>Float32Array.
of(Mn(n,t[n]),Mn(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":kr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":kr("evader_collide",t.evader_collide),
"rewards.blame":Ee("blame",t.blame,vr),"rewards.capture_repeats":Ct("capture_repeats",t.capture_repeats)}}function _r(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=Sr;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw F(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw F(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function $r(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function ze(t){$r(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...$a(t.rules),...Oa(t.rewards),rows:fe("rows",t.rows),cols:fe("cols",t.cols),n_pursuers:fe("n_pursuers",t.n_pursuers),n_evaders:fe("n_evaders",t.n_evaders),fov:fe(
"fov",t.fov),diagonal:Ct("diagonal",t.diagonal),max_steps:fe("max_steps",t.max_steps),density:Float64Array.of(e),map:_r(t.obstacles)}}function Rr(t,e){return Int32Array.
from((e??[]).flat(),n=>fe(t,n)[0])}function Or(t,e){return $r(t.obstacles,e),{seed:Fe("seed",t.seed??0n),episode:Fe("episode",t.episode??0),pursuers:Rr("pursuer\
s",t.pursuers),evaders:Rr("evaders",t.evaders),map:_r(t.obstacles)}}function kt(t){return{actions:Int32Array.from(t,e=>fe("actions",e)[0])}}function De(t){if(typeof t==
"string"){if(!Object.hasOwn(bn,t))throw F("policy",`one of ${Object.keys(bn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw F("activation","'relu' or 'tanh'",t.activation);if(!Cr.includes(t.memory))throw F("memory",`one of ${Cr.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>fe("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Ct("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var La=["first_turn","terminated","truncated"];function Lr(t){let e={...t};for(let n of La)e[n]=new Be(t[n]);return e}var Rt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,n,r,o){this.config=e,this.seed=n,this.episode=r,this.n_agents=e.n_pursuers+e.n_evaders,
this.statistics=Pr(o,0),Object.assign(this,o),this.first_conflict=Pa(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(e){
this.check(e);let[n,r]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(n*Ne,r*Ne);return Tt(o,this.config.n_pursuers)}seek(e,n,r){
this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.episode});for(let s=e.steps;s<
n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(a)}}check(e){if(!(Number.isInteger(
e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function Pa(t,e){let n=new Int32Array(e+2);for(let r=0;r<t.length;r+=Ne)++n[t[r]+1];for(let r=1;r<
n.length;++r)n[r]+=n[r-1];return n}function Pr(t,e){let n=t["statistics.length"].length,r=s=>{let a=t[`statistics.${s}`],i=a.length/n;return a.slice(e*i,(e+1)*i)},
o=s=>Number(r(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),
return:r("return"),survivors:r("survivors"),overlap:r("overlap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function Ir(t,e,n,r){
let o=[ze(n.config),De(n.pursuers),De(n.evaders),r];return be(t,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return t[e](a,i,l,d)}),Ue(t)}function Nr(t,e,n,r){let o={
seed:Fe("seed",n),episode:Fe("episode",r)};return new Rt(e.config,n,r,Ir(t,"_play_match",e,o))}function Br(t,e,n,r){if(!Number.isInteger(r)||r<1)throw F("n_epis\
odes","at least 1",r);let o={seed:Fe("seed",n),n_episodes:Int32Array.of(r)},s=Ir(t,"_play_rollout",e,o);return Array.from({length:r},(a,i)=>Pr(s,i))}var Ia=7e6,Na=new FinalizationRegistry(([t,e])=>t._states_free(e));function Ba({rules:t,rows:e,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||t.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*n-i,d=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",c=t.interaction==="AGENT_TURNS",m=(f,y)=>Array.from({length:y},(v,x)=>c?f:(f+x)/(x+1)).reduce((v,x)=>v*x,1),h=m(l+Number(d),s)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,y)=>f+h*(o?9:5)**y,0)}function We(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Ba(t)>Ia?"the world is too large to be solved on the page":""}var An=class{value;teams;matrix;n_actions;constructor(e,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,d]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<d),c=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],r,e.n_actions],this.teams=[{agents:u.filter(c),play:o},{agents:u.filter(m=>!c(m)),play:s}]}marginal(e){let n=this.teams.find(({agents:s})=>s.includes(e));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(e){let[n,r]=this.teams.map(({agents:l})=>l.reduce((d,u)=>d*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,d,u)=>l+
d*this.matrix[n*s.length+u],0),i=o.reduce((l,d,u)=>l+d*this.matrix[u*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},at=class{config;engine;states;n_turns;values;constructor(e,n){
[this.engine,this.config]=[e,n],this.states=be(e,o=>e._states_new(o.arrays(ze(n)))),Na.register(this,[e,this.states]);let r={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n.
n_pursuers+n.n_evaders};this.n_turns=r[n.rules.interaction],this.values=[[this.call(()=>e._states_payoffs(this.states)).payoffs]]}goBack(){let e=this.values.at(
-1)[0],n=[];for(let r=this.n_turns-1;r>=0;r--){let o=n[r+1]??e;n[r]=this.call(s=>this.engine._states_backup(this.states,r,s.arrays({next:o}))).values}return this.
values.push(n),this.values.length<=this.config.max_steps&&n[0].some((r,o)=>r!==e[o])}game(e){let[n,{turn:r}]=[this.config.max_steps-e.steps,e],o=r+1===this.n_turns,
s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,
i.arrays({next:s})));return a.agents.length?new An(e,a):null}call(e){return be(this.engine,e),Ue(this.engine)}};var Ur=new FinalizationRegistry(([t,e])=>t._world_free(e)),it=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=be(e,r=>e._world_new(r.arrays(ze(n)))),Ur.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Ur.unregister(this),this.engine._world_free(this.at))}get address(){return this.at}reset(e={}){let n=Or(e,this.config);this.call(r=>this.engine._world_reset(
this.at,r.arrays(n)))}step(e){let n=kt(e);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(e){let n=kt(e);this.call(r=>this.engine._world_play_turn(
this.at,r.arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.
n_agents)throw F("actions",String(this.n_agents),r.length);let l=[De(e),kt(r)],{actions:d}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(
l[1])));return Uint8Array.from(d)}replay(e,n){let r=s=>typeof s!="string"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(e);let{n_pursuers:o}=this.
config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(n.evader,[Math.max(a,o),i],e),this.
playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.at,n.
text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Tt(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,n){
let r=De(e),{logits:o,memory:s}=this.call(l=>this.engine._world_logits(this.at,l.arrays(r),n)),a=o,i=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{
logits:a,probabilities:Ua(a),action:i,memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let n=Lr(e);this.call(r=>this.engine.
_world_restore(this.at,r.arrays(n)))}call(e){if(this.freed)throw F("world","one that is in use","one that was freed");return be(this.engine,e),Ue(this.engine)}};
function Ua(t){let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var En=class{compiled;constructor(e){this.compiled=e}world(e){return new it(this.compiled,e)}solution(e){return new at(this.compiled,e)}match(e,n,r,o,s=0){return Nr(
this.compiled,{config:e,pursuers:n,evaders:r},o,s)}rollout(e,n,r,o,s){return Br(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Fr;function zr(t=globalThis.
matrixworldEngine){return Fr??=Fa(t),Fr}async function Fa(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new En(await t({wasmBinary:e}))}var za="http://www.w3.org/2000/svg";function p(t,e={},...n){return Dr(document.createElement(t),e,n)}function M(t,e={},...n){return Dr(document.createElementNS(
za,t),e,n)}function Dr(t,e,n){for(let[r,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(r.slice(2),o):t.setAttribute(r,o===!0?"":
String(o)));return t.append(...n.filter(Da).map(r=>typeof r=="number"?String(r):r)),t}function Da(t){return t!=null&&t!==!1}var lt=()=>["file:","http:","https:"].
includes(location.protocol);async function Wr(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}var Wa=matchMedia("(prefers-color-scheme: dark)");function Ha(){let t=document.documentElement.dataset.theme;return t?t==="dark":Wa.matches}function Tn(){document.
documentElement.dataset.theme=Ha()?"light":"dark"}function Hr(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Tn},
"◐")}var ja=2n**64n-1n;function ct(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(d,u,c)=>{let m=r.get(d)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):c},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ja?l:null,step:o("step",1/0,0)}}function jr(t,e,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:d}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...d===null?{}:{seed:d},step:n.player.step};r=`#${Object.entries(u).
map(([c,m])=>`${c}=${m}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};e.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=ct(location.hash,
t,e.selected);e.select(a),n.goTo(s)})}var N=Uint8Array,Y=Uint16Array,In=Int32Array,$t=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ot=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),_n=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Zr=function(t,e){for(var n=new Y(31),r=0;r<31;++r)n[r]=e+=
1<<t[r-1];for(var o=new In(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},Jr=Zr($t,2),Xr=Jr.b,$n=Jr.r;Xr[28]=258,$n[258]=28;var Qr=Zr(
Ot,0),Ga=Qr.b,Gr=Qr.r,On=new Y(32768);for(R=0;R<32768;++R)ge=(R&43690)>>1|(R&21845)<<1,ge=(ge&52428)>>2|(ge&13107)<<2,ge=(ge&61680)>>4|(ge&3855)<<4,On[R]=((ge&65280)>>
8|(ge&255)<<8)>>1;var ge,R,le=(function(t,e,n){for(var r=t.length,o=0,s=new Y(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new Y(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new Y(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var d=o<<4|t[o],u=e-t[o],c=a[t[o]-1]++<<u,m=c|(1<<u)-1;c<=m;++c)i[On[c]>>l]=d}else for(i=new Y(
r),o=0;o<r;++o)t[o]&&(i[o]=On[a[t[o]-1]++]>>15-t[o]);return i}),we=new N(288);for(R=0;R<144;++R)we[R]=8;var R;for(R=144;R<256;++R)we[R]=9;var R;for(R=256;R<280;++R)
we[R]=7;var R;for(R=280;R<288;++R)we[R]=8;var R,pt=new N(32);for(R=0;R<32;++R)pt[R]=5;var R,Va=le(we,9,0),qa=le(we,9,1),Ka=le(pt,5,0),Ya=le(pt,5,1),Cn=function(t){
for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},oe=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},kn=function(t,e){var n=e/8|0;return(t[n]|
t[n+1]<<8|t[n+2]<<16)>>(e&7)},Nn=function(t){return(t+7)/8|0},Bn=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),new N(t.subarray(
e,n))};var Za=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],V=function(t,e,n){var r=new Error(e||Za[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,V),!n)throw r;return r},Ja=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new N(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new N(o*3));var d=function(tt){var nt=n.length;if(tt>nt){var Ie=new N(Math.max(nt*2,tt));Ie.set(n),n=Ie}},u=e.f||0,c=e.
p||0,m=e.b||0,h=e.l,g=e.d,f=e.m,y=e.n,v=o*8;do{if(!h){u=oe(t,c,1);var x=oe(t,c+1,3);if(c+=3,x)if(x==1)h=qa,g=Ya,f=9,y=5;else if(x==2){var C=oe(t,c,31)+257,E=oe(
t,c+10,15)+4,T=C+oe(t,c+5,31)+1;c+=14;for(var S=new N(T),O=new N(19),_=0;_<E;++_)O[_n[_]]=oe(t,c+_*3,7);c+=E*3;for(var k=Cn(O),Q=(1<<k)-1,W=le(O,k,1),_=0;_<T;){
var L=W[oe(t,c,Q)];c+=L&15;var b=L>>4;if(b<16)S[_++]=b;else{var U=0,$=0;for(b==16?($=3+oe(t,c,3),c+=2,U=S[_-1]):b==17?($=3+oe(t,c,7),c+=3):b==18&&($=11+oe(t,c,127),
c+=7);$--;)S[_++]=U}}var H=S.subarray(0,C),z=S.subarray(C);f=Cn(H),y=Cn(z),h=le(H,f,1),g=le(z,y,1)}else V(1);else{var b=Nn(c)+4,w=t[b-4]|t[b-3]<<8,A=b+w;if(A>o){
l&&V(0);break}i&&d(m+w),n.set(t.subarray(b,A),m),e.b=m+=w,e.p=c=A*8,e.f=u;continue}if(c>v){l&&V(0);break}}i&&d(m+131072);for(var Oe=(1<<f)-1,ee=(1<<y)-1,he=c;;he=
c){var U=h[kn(t,c)&Oe],q=U>>4;if(c+=U&15,c>v){l&&V(0);break}if(U||V(2),q<256)n[m++]=q;else if(q==256){he=c,h=null;break}else{var K=q-254;if(q>264){var _=q-257,I=$t[_];
K=oe(t,c,(1<<I)-1)+Xr[_],c+=I}var ie=g[kn(t,c)&ee],Le=ie>>4;ie||V(3),c+=ie&15;var z=Ga[Le];if(Le>3){var I=Ot[Le];z+=kn(t,c)&(1<<I)-1,c+=I}if(c>v){l&&V(0);break}
i&&d(m+131072);var Pe=m+K;if(m<z){var At=s-z,Et=Math.min(z,Pe);for(At+m<0&&V(3);m<Et;++m)n[m]=r[At+m]}for(;m<Pe;++m)n[m]=n[m-z]}}e.l=h,e.p=he,e.b=m,e.f=u,h&&(u=
1,e.m=f,e.d=g,e.n=y)}while(!u);return m!=n.length&&a?Bn(n,0,m):n.subarray(0,m)},ye=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},ut=function(t,e,n){
n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},Rn=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:to,l:0};if(o==1){var a=new N(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(A,C){return A.f-C.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],d=0,
u=1,c=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[d].f<n[c].f?d++:c++],l=n[d!=u&&n[d].f<n[c].f?d++:c++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,r=1;r<
o;++r)s[r].s>m&&(m=s[r].s);var h=new Y(m+1),g=Ln(n[u-1],h,0);if(g>e){var r=0,f=0,y=g-e,v=1<<y;for(s.sort(function(C,E){return h[E.s]-h[C.s]||C.f-E.f});r<o;++r){
var x=s[r].s;if(h[x]>e)f+=v-(1<<g-h[x]),h[x]=e;else break}for(f>>=y;f>0;){var b=s[r].s;h[b]<e?f-=1<<e-h[b]++-1:++r}for(;r>=0&&f;--r){var w=s[r].s;h[w]==e&&(--h[w],
++f)}g=e}return{t:new N(h),l:g}},Ln=function(t,e,n){return t.s==-1?Math.max(Ln(t.l,e,n+1),Ln(t.r,e,n+1)):e[t.s]=n},Vr=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new Y(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},dt=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},eo=function(t,e,n){var r=n.length,o=Nn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},qr=function(t,e,n,r,o,s,a,i,l,d,u){ye(e,u++,n),++o[256];for(var c=Rn(o,15),m=c.t,h=c.l,g=Rn(s,15),f=g.t,y=g.l,v=Vr(m),x=v.c,
b=v.n,w=Vr(f),A=w.c,C=w.n,E=new Y(19),T=0;T<x.length;++T)++E[x[T]&31];for(var T=0;T<A.length;++T)++E[A[T]&31];for(var S=Rn(E,7),O=S.t,_=S.l,k=19;k>4&&!O[_n[k-1]];--k)
;var Q=d+5<<3,W=dt(o,we)+dt(s,pt)+a,L=dt(o,m)+dt(s,f)+a+14+3*k+dt(E,O)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&Q<=W&&Q<=L)return eo(e,u,t.subarray(l,l+d));var U,$,H,z;
if(ye(e,u,1+(L<W)),u+=2,L<W){U=le(m,h,0),$=m,H=le(f,y,0),z=f;var Oe=le(O,_,0);ye(e,u,b-257),ye(e,u+5,C-1),ye(e,u+10,k-4),u+=14;for(var T=0;T<k;++T)ye(e,u+3*T,O[_n[T]]);
u+=3*k;for(var ee=[x,A],he=0;he<2;++he)for(var q=ee[he],T=0;T<q.length;++T){var K=q[T]&31;ye(e,u,Oe[K]),u+=O[K],K>15&&(ye(e,u,q[T]>>5&127),u+=q[T]>>12)}}else U=
Va,$=we,H=Ka,z=pt;for(var T=0;T<i;++T){var I=r[T];if(I>255){var K=I>>18&31;ut(e,u,U[K+257]),u+=$[K+257],K>7&&(ye(e,u,I>>23&31),u+=$t[K]);var ie=I&31;ut(e,u,H[ie]),
u+=z[ie],ie>3&&(ut(e,u,I>>5&8191),u+=Ot[ie])}else ut(e,u,U[I]),u+=$[I]}return ut(e,u,U[256]),u+$[256]},Xa=new In([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),to=new N(0),Qa=function(t,e,n,r,o,s){var a=s.z||t.length,i=new N(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),d=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var c=Xa[e-1],m=c>>13,h=c&8191,g=(1<<n)-1,f=s.p||new Y(32768),y=s.h||new Y(g+1),v=Math.ceil(n/3),x=2*v,b=function(fn){return(t[fn]^t[fn+1]<<
v^t[fn+2]<<x)&g},w=new In(25e3),A=new Y(288),C=new Y(32),E=0,T=0,S=s.i||0,O=0,_=s.w||0,k=0;S+2<a;++S){var Q=b(S),W=S&32767,L=y[Q];if(f[W]=L,y[Q]=W,_<=S){var U=a-
S;if((E>7e3||O>24576)&&(U>423||!d)){u=qr(t,l,0,w,A,C,T,O,k,S-k,u),O=E=T=0,k=S;for(var $=0;$<286;++$)A[$]=0;for(var $=0;$<30;++$)C[$]=0}var H=2,z=0,Oe=h,ee=W-L&32767;
if(U>2&&Q==b(S-ee))for(var he=Math.min(m,U)-1,q=Math.min(32767,S),K=Math.min(258,U);ee<=q&&--Oe&&W!=L;){if(t[S+H]==t[S+H-ee]){for(var I=0;I<K&&t[S+I]==t[S+I-ee];++I)
;if(I>H){if(H=I,z=ee,I>he)break;for(var ie=Math.min(ee,I-2),Le=0,$=0;$<ie;++$){var Pe=S-ee+$&32767,At=f[Pe],Et=Pe-At&32767;Et>Le&&(Le=Et,L=Pe)}}}W=L,L=f[W],ee+=
W-L&32767}if(z){w[O++]=268435456|$n[H]<<18|Gr[z];var tt=$n[H]&31,nt=Gr[z]&31;T+=$t[tt]+Ot[nt],++A[257+tt],++C[nt],_=S+H,++E}else w[O++]=t[S],++A[t[S]]}}for(S=Math.
max(S,_);S<a;++S)w[O++]=t[S],++A[t[S]];u=qr(t,l,d,w,A,C,T,O,k,S-k,u),d||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=y,s.p=f,s.i=S,s.w=_)}else{for(var S=s.w||0;S<a+d;S+=65535){
var Ie=S+65535;Ie>=a&&(l[u/8|0]=d,Ie=a),u=eo(l,u+1,t.subarray(S,Ie))}s.i=a}return Bn(i,0,r+Nn(u)+o)},ei=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var n=e,r=9;--r;)n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),ti=function(){var t=-1;return{p:function(e){for(var n=t,r=0;r<e.length;++r)n=ei[n&255^e[r]]^n>>>
8;t=n},d:function(){return~t}}};var ni=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Qa(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},no=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var j=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var ri=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&V(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&V(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function oi(t,e){return ni(t,e||{},0,0)}function ro(t,e){return Ja(t.subarray(ri(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var oo=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=no(r,s[1]),s=s[0]),s instanceof N?n[a]=[s,i]:(n[a+="/"]=[new N(0),i],oo(s,a,n,
r))}},Kr=typeof TextEncoder<"u"&&new TextEncoder,si=typeof TextDecoder<"u"&&new TextDecoder,ai=0;try{si.decode(to,{stream:!0}),ai=1}catch{}function _t(t,e){if(e){for(var n=new N(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(Kr)return Kr.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new N(a+8+(o-r<<1));l.set(s),s=l}var d=t.charCodeAt(r);d<128||e?i(d):d<2048?(i(192|
d>>6),i(128|d&63)):d>55295&&d<57344?(d=65536+(d&1047552)|t.charCodeAt(++r)&1023,i(240|d>>18),i(128|d>>12&63),i(128|d>>6&63),i(128|d&63)):(i(224|d>>12),i(128|d>>
6&63),i(128|d&63))}return Bn(s,0,a)}var Pn=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&V(9),e+=r+4}return e},Yr=function(t,e,n,r,o,s,a,i){var l=r.length,d=n.extra,u=i&&i.length,
c=Pn(d);j(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var m=new Date(n.mtime==null?Date.now():n.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&V(10),j(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(j(t,e,n.crc),j(t,e+4,s<0?-s-2:s),j(t,e+8,n.size)),j(t,e+12,l),j(t,e+14,c),e+=16,a!=null&&(j(t,e,
u),j(t,e+6,n.attrs),j(t,e+10,a),e+=14),t.set(r,e),e+=l,c)for(var g in d){var f=d[g],y=f.length;j(t,e,+g),j(t,e+2,y),t.set(f,e+4),e+=4+y}return u&&(t.set(i,e),e+=
u),e},ii=function(t,e,n,r,o){j(t,e,101010256),j(t,e+8,n),j(t,e+10,n),j(t,e+12,r),j(t,e+16,o)};function so(t,e){e||(e={});var n={},r=[];oo(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],d=i[1],u=d.level==0?0:8,c=_t(a),m=c.length,h=d.comment,g=h&&
_t(h),f=g&&g.length,y=Pn(d.extra);m>65535&&V(11);var v=u?oi(l,d):l,x=v.length,b=ti();b.p(l),r.push(no(d,{size:l.length,crc:b.d(),c:v,f:c,m:g,u:m!=a.length||g&&h.
length!=f,o,compression:u})),o+=30+m+y+x,s+=76+2*(m+y)+(f||0)+x}for(var w=new N(s+22),A=o,C=s-o,E=0;E<r.length;++E){var c=r[E];Yr(w,c.o,c,c.f,c.u,c.c.length);var T=30+
c.f.length+Pn(c.extra);w.set(c.c,c.o+T),Yr(w,o,c,c.f,c.u,c.c.length,c.o,c.m),o+=16+T+(c.m?c.m.length:0)}return ii(w,o,r.length,C,A),w}var ce=["pursuer","evader"];function io(){return JSON.parse(Lt("data"))}function He(t,e,n){let[r,o]=[e-t.payoff.first[0],n-t.payoff.first[1]],s=t.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r][o]}}function Te(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.
teams[e];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${e}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return lo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function Z(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,d=lo(a,l).subarray(i*l,(i+1)*l),{hidden:u,activation:c,
sampled:m,memory:h}=o;return{hidden:u,activation:c,sampled:m,memory:h,genome:d}}var Un=4,ao=new Map;function lo(t,e){let n=ao.get(t);if(n)return n;let r=new Float32Array;
try{let o=ci(Fn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||li(o)))throw o}return ao.set(t,r),r}var li=t=>t instanceof
Error&&"code"in t;function ci(t,e){let n=ro(t),r=n.length/Un,o=new Uint8Array(n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Un*r+Math.floor(a/Un)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function Fn(t){let e=atob(Lt(t)),n=new Uint8Array(e.length);for(let r=0;r<n.
length;r++)n[r]=e.charCodeAt(r);return n}function Lt(t){return document.getElementById(t)?.textContent??""}var je=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function co(t,e,n){let[r,o]=[e[0]-t[0],e[1]-t[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),je.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,P=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ui=(t,e)=>t[0]===e[0]&&
t[1]===e[1],zn=({rows:t,cols:e},[n,r])=>n>=0&&r>=0&&n<t&&r<e,Dn=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),Wn=(t,e)=>Dn(t.fault,e),uo=(t,e)=>!Wn(
t,e)&&Dn(t.involved,e,2);function Pt(t,e,n){let r=!ui(P(t,n),P(e,n)),o=e.involved===void 0||Dn(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!r&&o)}function It(t,e,n){
let[r,o]=P(t,n),[s,a]=je[e.actions?.[n]??0];return[r+s,o+a]}function mt(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var po=t=>t.moments.flatMap((e,n)=>n&&mt(t,t.moments[n-1],e).length?[n]:[]);function Nt(t,e){return Array.from({length:e.
alive.length},(r,o)=>o).filter(r=>t.alive[r]&&!e.alive[r])}var mo=[-.31,0,.31],ho=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:mo.flatMap(t=>mo.map(e=>[e,t]))}],di=.3,pi=.35,mi=.55;function ht(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=P(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function fo(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=P(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ht(t,e).values()){let o=ho[Math.min(r.length,ho.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=n[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return n}var go=t=>t*t*(3-2*t),Ge=(t,e,n)=>t+(e-t)*n,yo=t=>Math.min(1,Math.max(0,t));function vo(t,e,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[t.interaction];if(o===1)return go(r);let s=o===n?e:+!Ce(t,e),a=Math.max(1/o,pi);return go(yo((r-s/(o-1)*(1-a))/a))}function Bt(t,e){
let n=t.moments.length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=fo(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=fo(t,a);return s.map((l,d)=>{let u=vo(
t,d,s.length,e-r);return hi(o,a,d,l,i[d],u)})}function Hn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
r)]],i=vo(t,e,s.alive.length,n-o),[[l,d],[u,c]]=[P(s,e),P(a,e)];return[Ge(d,c,i)+.5,Ge(l,u,i)+.5]}function hi(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:Ge(r.x,o.x,
s),y:Ge(r.y,o.y,s),size:a?r.size:Ge(r.size,o.size,s),alpha:a?yo((1-s)/(1-mi)):Ge(r.alpha,o.alpha,s)};if(Pt(t,e,n)){let[l,d]=P(t,n),[u,c]=It(t,e,n),m=di*Math.sin(
Math.PI*s);i.x+=(c-d)*m,i.y+=(u-l)*m}return i}var bo=2*Math.PI;function ke(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,bo)}function Ut(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];t.arcTo(a,i,d,u,r*.09)}),t.closePath()}function wo(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function xo(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=bo*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function So(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Mo=4,fi=1.6,gi=.95,yi=5,vi=.16,bi=9,wi=.09,xi=.2,Ao=.75,te=(t,e)=>t.left+e*t.cell,ne=(t,e)=>t.top+e*t.cell;function Ve(t,e,n){return Ce(e,n)?t.colors.pursuer:
t.colors.evader}function Eo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=n.paper,t.fillRect(r,o,l,d),s<yi)return;
t.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let c=1;c<i;c++)t.fillRect(r+c*s,o,u,d);for(let c=1;c<a;c++)t.fillRect(r,o+c*s,l,u)}function To({ctx:t,
grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let d=0;d<i*l;d++){if(!r.obstacles[d])continue;let[u,c]=[Math.floor(d/l),
d%l];t.fillRect(o+c*a,s+u*a,a,a)}Co({ctx:t,grid:e,colors:n})}function Co({ctx:t,grid:{left:e,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function ko({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,d=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.
textAlign="center";let u=5*r+a/40;for(let c=0;c<l;c+=d)t.fillText(String(c),o+(c+.5)*a,s-u);t.textAlign="right",t.textBaseline="middle";for(let c=0;c<i;c+=d)t.fillText(
String(c),o-u,s+(c+.5)*a)}function Ro({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(t.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
t.rows,r+o)];return[te(t,s),ne(t,i),(a-s)*t.cell,(l-i)*t.cell]}function _o(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Ro(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Co(t)}function $o({ctx:t,grid:e,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[te(e,r),ne(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=n.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let c=d-i/2<u*1.2,m=d+(c?1:-1)*(i/2+u*.7);t.strokeStyle=
n.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=n.ink,t.fillText("You",l,m),t.globalAlpha=1}function Oo(t,e,n,r,o){let{ctx:s,grid:a}=t,
i=Ro(t,e,r,o),l=Ve(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Lo(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(bi,
Math.max(1,a.cell*vi));for(let d=Math.max(1,Math.floor(n-r)+1);d<=i;d++){let[u,c]=[e.moments[d-1],e.moments[d]],m=Math.max(0,Math.min(1,(n-d)/r));s.globalAlpha=
Ao+(xi-Ao)*m;for(let h=0;h<c.alive.length;h++){let g=d===i&&n<i;if(!u.alive[h]||!(l.alive[h]||g))continue;let f=(Ce(e,h)?-1:1)*wi,[y,v]=P(u,h),[x,b]=P(c,h);if(y===
x&&v===b)continue;let w=g?o[h].x:b+.5,A=g?o[h].y:x+.5;s.strokeStyle=Ve(t,e,h),s.beginPath(),s.moveTo(te(a,v+.5+f),ne(a,y+.5+f)),s.lineTo(te(a,w+f),ne(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Po(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-Mo+1);o<=r;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/Mo,l=mt(e,s,a);for(let d of Nt(s,a))l.includes(d)||Mi(t,P(a,d),i);for(let d of l)Si(t,P(a,d),i)}t.ctx.globalAlpha=1}function Si({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,xo(t,te(e,o+.5),ne(e,r+.5),Math.max(8,e.cell*fi)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Mi({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,wo(t,te(e,o+.5),ne(e,r+.5),Math.max(7,e.cell*gi)),
t.strokeStyle=n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Io({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[te(e,i)+s,ne(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function No({ctx:t,grid:e,colors:n},r,o,s,a){t.globalAlpha=a,ke(t,te(e,r),ne(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Ai=.8,Ei=.92,Ti=15,Ci=7,jn=9;function Bo(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&ki(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ht(e,n).values())a.length>
jn&&Ri(t,r[a[jn-1]],a.length-jn+1)}function ki(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:d}=t,u=Ce(e,r),[c,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?Ei:Ai)),g=Ve(t,e,r),f=!u&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Ut:ke)(i,c,m,h),h>Ci*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?d.paper:g,i.fill(),f&&(ke(i,c,m,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<Ti*a)return;let y=String(u?r:r-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:d.paper,i.fillText(
y,c,m+h*(u?.17:.03))}function Ri({ctx:t,grid:e,colors:n},r,o){let[s,a]=[e.left+r.x*e.cell,e.top+r.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=n.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=n.ink,t.fillText(`+${o}`,
s,a)}var _i=.46,$i=.86,Oi=.66,Uo=.48,Li=.78,Pi=.58;function Fo(t,e,n,r){let[o,s]=[e.moments[n-1],e.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let d=0;d<s.alive.length;d++)Pt(o,s,d)&&Ii(t,e,P(o,d),It(o,s,d));a.globalAlpha=
1}function Ii({ctx:t,grid:e},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=c=>te(e,r[1]+.5+s*c),l=c=>ne(e,r[0]+.5+a*c),d=zn(n,o)?Li:Pi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Uo),l(Uo)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*u,l(d)+
s*u),t.lineTo(i(d)+a*u,l(d)-s*u),t.stroke()}function zo(t,e,n,r,o,s){let a=je[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,u=zn(e,[r[0]+a[0],r[1]+a[1]])?$i:
Oi,c=_i*o.size,m=[te(l,o.x+a[1]*c),ne(l,o.y+a[0]*c),te(l,o.x+a[1]*u),ne(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[
d.paper,h*2.1],[Ve(t,e,n),h]])i.strokeStyle=g,i.lineWidth=f,So(i,...m,l.cell*.2),i.stroke()}var Ft={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function zt(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),d=e.moments[l],u=n===l,c=Bt(e,n),m=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),Eo(t);for(let f of r.
viewers)c[f]?.alpha&&Oo(t,e,f,...Hn(e,f,n));To(t,e),r.axes&&ko(t,o),Lo(t,e,n,r.trail,c),Io(t,d.contested??[],m),Po(t,e,n),Fo(t,e,l,m),c.forEach(({x:f,y,size:v},x)=>{
let b=uo(d,x)?.4:0,w=Wn(d,x)?1:b;w&&No(t,f,y,v,w*m)});let h=u?d:e.moments[Math.max(0,l-1)];if(Bo(t,e,h,c,r.numbers,o),u&&r.plan)for(let[f,y]of c.entries())y.alpha&&
zo(t,e,f,P(d,f),y,r.plan[f]??0);r.you!==null&&(r.fog&&_o(t,e,...Hn(e,r.you,n)),$o(t,c[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===
null?void 0:c[r.selected];g?.alpha&&Do(t,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Do(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function Do({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var ft=(t,e)=>(e+.24)/(t+.24);function Dt(t,e,n,r,o,s){let a=n?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Wo(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var Ni={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function qe(t){let e=getComputedStyle(t),n=Object.entries(Ni).map(([r,o])=>[r,e.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var se=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,xe=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#s;#l;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Ft,...n},this.#s=new ResizeObserver(()=>this.#c()),this.#s.observe(e),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#s.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#a)}get look(){
return this.#t}set look(e){this.#t={...this.#t,...e},this.#p(),this.redraw()}show(e,n){this.#e=e,this.#n=Math.min(Math.max(0,n),e.moments.length-1),this.#p(),this.
redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#r=Dt(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,
colors:qe(this.canvas)};zt(s,this.#e,this.#n,this.#t,o)}cellAt(e,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Wo(this.#r,(e-r.
left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=ht(this.#e,o).get(r[0]*this.#e.
cols+r[1])??[],a=Bt(this.#e,Math.round(this.#n)),i=l=>{let[d,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(d-e,u-n)};return s.length?s.reduce((l,d)=>i(d)<i(l)?
d:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+e*i)*o,r.top+(a+n*i)*
o]}#p(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(ft(e,n)))}#c(){let e=devicePixelRatio||1,{width:n,height:r}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var Bi=12e3;function Ho(t,e,n){let r=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>c(
d-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>c(d+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>c(0,!se())},"A guided minute"),[d,u]=[-1,0];function c(y,v){
clearTimeout(u);let x=r()[y];if(g(),!x)return m();d=y,o.replaceChildren(p("span",{class:"muted numbers"},`${y+1} of ${r().length} `),x.text),s.disabled=y===0,a.
textContent=y===r().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:x.pursuer,evader:x.evader}),x.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):x.shows==="checkerboard"?h():(n.reveal(),n.playSoon()),v&&(u=setTimeout(()=>c(y+1,!0),Bi))}function m(){clearTimeout(u),d=-1,i.
hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let y=document.querySelector("dialog.four[open]");y?.append(i),y?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let g=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!r().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",y=>{y.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var gt=[.5,1,2,4,8,16,32,64],Ke=0,Wt=12,Ui=2,Se=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#s=!1;#l=null;#p=0;#c=[];#m=[];glide=.28;constructor(e,n={}){super(),
this.#e=e,this.#n=n.speed??4,this.#t=n.still??!1}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#o("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#n||Math.max(Ui,this.#e/Wt)}get speed(){return this.#n}set speed(e){
this.#n=e,this.#o("state")}changeSpeed(e){let n=gt.findIndex(r=>r>=this.pace);this.speed=gt[Math.min(gt.length-1,Math.max(0,n+e))]}play(){this.#s||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let n=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(n-this.#a)>1?this.jump(n):this.#d(n),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#a),this.#o("frame")}#d(e){e!==this.#r&&(this.#r=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#l===null&&(this.#p=performance.now(),
this.#l=requestAnimationFrame(()=>this.#h()))}#h(){this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#r)&&(this.#l=requestAnimationFrame(()=>this.#h()))}#u(e){let n=e;for(;n>0;){if(this.#a===this.#r){if(!this.#s)return;
if(this.#r===this.#e)return this.pause();this.#d(this.#r+1)}let r=this.#s?this.pace:1/this.glide,o=this.#r-this.#a,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#a=s===
Math.abs(o)?this.#r:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Me(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var yt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ye(t){let e=Math.min(1,Math.max(0,t))*(yt.length-1),n=Math.min(yt.length-2,Math.floor(e)),[r,o]=[yt[n],
yt[n+1]],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Ht(t){let[e,n,r]=Ye(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+
.0722*r>.179?"#000":"#fff"}var jt=t=>`rgb(${Ye(t).join(" ")})`,jo=()=>`linear-gradient(to right, ${yt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Gt(t,e,n){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(n))t.style.setProperty(a,`${i}px`);t.width=Math.round(n.width*r),t.height=Math.round(
n.height*r);let o=t.getContext("2d"),s=Fi(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Fi(t){let[e,n]=t.shape,r=document.
createElement("canvas");[r.width,r.height]=[n,e];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,d)=>{let u=4*((e-1-i-t.first[0])*n+d+t.first[1]);s.data.set([...Ye(l),255],u)})),o.putImageData(s,0,0),r}function Vt(t,e){let n=p("span",{class:"grad\
ient"});return n.style.backgroundImage=jo(),p("p",{class:"scale-of-rates small muted"},t,n,e)}var zi=84;function Go(t,e){let n=t.map((s,a)=>Di(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),r.hidden=t.length<2,r}function Di(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=zi/
Math.max(r,o),i=p("canvas",{"aria-hidden":"true"});Gt(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),d=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Gn(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Wi(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:c=>{d.setAttribute("aria-current",String(c));let m=n.hover.pursuer??n.selected.pursuer,h=n.hover.evader??n.selected.evader;
l.hidden=m>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-m-.5)*a}px`}}}var Wi=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Gn(t,e,n){
let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var Hi=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function Vo(){let t=Hi.map(([n,r])=>p("div",{class:"key-row"},p("dt",{},...n.map(o=>p("kbd",{},o))),p("dd",{},r))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",n=>n.target===e&&e.close()),e}function qo(t,e,n,r,o,s){let a=(l,d)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.
inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:Tn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let d=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||d||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let c=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(Me(n.player,l)||c)c?.();else if(t[m])Gn(t[m],
m,e);else return;l.preventDefault()})}function Ko(t,e,n,r,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!r()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("version").then(d=>d.text(),()=>null);l===null?o():l==="end"||l!==t&&a()?(ji(e,n),location.reload()):setTimeout(
()=>{i()},1e3)};i()}function ji(t,e){let{run:n,pursuer:r,evader:o}=e.selected,[s,a]=t[n].payoff.shape;r===s-1&&o===a-1&&history.replaceState(null,"",`#run=${n}`)}function Vn(t,e,n){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:n}}function qn(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function qt(t){let e=Array.from({length:t.length+1},(n,r)=>Gi(t,r));return Vn(t.config,t.map,e)}function Gi(t,e){
let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*n),alive:o(t.alive,e,n),captured:o(t.captured,e,r),
everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var Vi=Array.from({length:16},(t,e)=>{let[n,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function Yo(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:Vi,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var qi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Zo(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:qi[t]}))}function vt(t,e,n,r){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${n})`,onclick:r},Zo(t))}function Ze(t){let e=vt("play","Play","Space",()=>t.toggle()),n=Ki(t),
r=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=Yi(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},vt("first","First step","Home",()=>t.move(-t.length)),vt("back","Step back","←",()=>t.move(-1)),
e,vt("forward","Step forward","→",()=>t.move(1)),vt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},r,o,n),a,s),l=(c,m={})=>{let h=p("i",
m);return h.style.left=`${100*c/Math.max(1,t.length)}%`,h},d=()=>{r.replaceChildren(...t.marks.map(c=>l(c))),o.replaceChildren(...t.ticks.map(({step:c,kind:m,size:h,
text:g})=>{let f=l(c,{class:m,title:`Step ${c}: ${g}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(Zo(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",u),t.addEventListener("s\
tate",u),t.addEventListener("state",d),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==n)&&Me(t,c)&&c.preventDefault()}),
u(),i}function Ki(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function Yi(t){let e=`Steps a second, or the whole in ${Wt} s (+ and -)`,n=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:Ke},`in ${Wt} s`),...gt.map(r=>p("option",{value:r},`${r} / s`)));return n.addEventListener("change",()=>{t.speed=Number(n.value)}),n}var B=(t,e=2)=>t==null?"-":t.toFixed(e);function Jo(t,e,n){return e===null||n===null?B(t):`${B(t)} (${B(e)} to ${B(n)})`}var Xo=t=>t.toLocaleString("en-GB");function bt(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(d,u)=>(i+u)*a)}var Zi=40,Kt=class{element;#e;#n=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,n){let{pursuer:r,evader:o,episode:s,seed:a}=this.#e.
selected,i=He(e,r,o);this.#n.replaceChildren(...(i?.rates??[]).slice(0,Zi).map((m,h)=>this.#r(m,h)));let l=a===null?i?.rates[s]:void 0,d=n.statistics.capture_rate,
u=l!==void 0&&Math.abs(d-l)<1e-6&&n.length===i?.lengths[s],c=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?c:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${B(d,3)} in ${n.length} steps.${i?` The cell says ${B(i.rate,3)}.`:""}`}#r(e,n){let{selected:r}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${B(e)}`,"aria-label":`Episode ${n+1}, capture rate ${B(e)}`,"aria\
-pressed":String(n===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:n,seed:null})},o,p("span",{class:"count"},n+1))}};var ue=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Qo=0,es=1,Ji=2,Xi=176;function ns(t,e,n,r){let o=devicePixelRatio||1,s=qe(t);t.width=t.height=Xi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;n&&u<i*i;u++){let[c,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!n[f*i*i+u];h(Ji)&&(a.fillStyle=
s.obstacle,a.fillRect(c-l/2,m-l/2,l,l));let g=h(Qo)&&h(es)?l*.18:0;h(Qo)&&ts(a,ke,c+g,m+g,l*.74,s.evader),h(es)&&ts(a,Ut,c-g,m-g,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function ts(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var Qi="What it remembers: a number for each unit, from -1 to 1.",Yt=class{element;#e;#n=p("canvas",{class:"seen",role:"img"});#t=p("h3");#r=p("p",{class:"small\
 muted"});#a=p("div",{class:"answers"});#s=p("div",{class:"memory"});#l=null;#p=null;#c=null;#m=null;#d=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=
p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("d\
iv",{class:"inspected"},this.#n,p("div",{class:"answer"},this.#t,this.#r),this.#a,this.#s))}get agent(){return this.#i}show(e,n,r,o){this.#l?.free(),this.#l=e.world(
n.world),this.#c!==n&&(this.#p=null,this.#i!==null&&this.choose(null)),[this.#c,this.#m,this.#d]=[n,r,o]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#i=
e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let n=this.#m;if(!n)return;let r=this.#i??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)
if(r=(r+e+n.n_agents)%n.n_agents,n.alive[this.#h*n.n_agents+r])return this.choose(r)}at(e){this.#h=e;let[n,r,o,s,a]=[this.#m,this.#l,this.#c,this.#d,this.#i];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},G(a,n.config.n_pursuers)));
let l={pursuers:Z(o,"pursuer",s.pursuer),evaders:Z(o,"evader",s.evader)};n.seek(r,e,l);let d=n.actions.subarray(e*n.n_agents,(e+1)*n.n_agents);for(;d.length&&!r.
over&&(a<r.actors[0]||a>=r.actors[1]);)r.playTurn(d);let u=!!(n.alive[e*n.n_agents+a]&&r.read("alive")[a]);ns(this.#n,n.config,u?r.view(a):null,a),this.#n.ariaLabel=
`Field of view of ${G(a,n.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let c=d[a]??null;if(!u)return this.#u([],"It is gone.");let m=l[`${i}s`],
h=typeof m=="string"?null:r.answer(m,a),g=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},Qi),nl(h.memory));let f=this.#p?.
game(r)??null,y=typeof m=="string"?`The script "${m}" plays for it${c===null?"":`; it goes ${ue[c]}`}.`:m.sampled?"Its action is drawn from these probabilities.":
"It takes the most probable action.",v=[["its network",g],["perfect play",f?.marginal(a)??null]],x=We(n.config),b=f?`Value ${f.value.toFixed(2)}: the capture ra\
te under perfect play.`:x&&`Perfect play is not known: ${x}.`;this.#u(el(v,c),c===null?"The episode is over.":y,b)}#u(e,...n){this.#a.replaceChildren(...e),this.#r.
textContent=n.filter(Boolean).join(" ")}};function el(t,e){let n=t.filter(([,s])=>s);if(!n.length)return[];let r=p("div",{class:"action muted"},p("span"),...n.map(
([s])=>p("span",{class:"head"},s))),o=Array.from(n[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ue[a]),...n.flatMap(([,i])=>tl(i[a]))));
return n.length>1||n[0][0]!==t[0][0]?[r,...o]:o}function tl(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p(
"span",{class:"numbers"},t.toFixed(2))]}function nl(t){let e=Array.from(t,n=>{let r=p("span",{title:n.toFixed(2)});return r.style.transform=`scaleY(${n})`,r});return p(
"div",{class:"units"},...e)}function Je(t,e,{pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,Z(e,"pursuer",n),Z(e,"evader",r),BigInt(s??a),o)}function rs(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var os="champion",ss=0,Kn=64,Yn=100;var rl=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function as(t,e){return Object.keys(e).find(n=>rl(e[n],t))??null}var wt="_",ol="n",Fd=2n**64n-1n;var Zn={fov:11,maxSteps:500,rewards:"paper"},sl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function cs(t,e){let n=i=>i.map(l=>il(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=al(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ls(
t.rules,e),others:t.others?ls(t.others,e):"",rewards:o===Zn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Zn.fov?"":String(t.fov),
limit:t.maxSteps===Zn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(wt),pursuers:t.pursuers.map(is).join(wt),
evaders:t.evaders.map(is).join(wt),played:t.played.map(n).join(wt),next:t.next.every(i=>i===ss)?"":n(t.next)};return sl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function is({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ls(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return as(t,e.variants)??n.join(".")}function al(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(wt)}function il(t,e){if(typeof t=="number")return String(t);if(t===os)return ol;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var ll="/* the engine */";function us(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Jn(t(),e)},"What if?")}function Jn(t,e){let n=t!==null&&t.match.n_agents<=Yn&&Math.max(t.match.config.rows,t.match.config.
cols)<=Kn,r=n?cs(cl(t.match,t.step),e):"",o=new TextDecoder().decode(Fn("playground")).replace(ll,()=>Lt("script-engine")).replace("</noscript>",s=>n?s+rs(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${r}`)}function cl(t,e){let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,
d=o*n.n_evaders+i-n.n_pursuers,u=c=>i>=n.n_pursuers&&!!c[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,
fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}var Qn=.005,ul=["pursuer","evader"],Xn=new Map;function Zt(t,e){let n=JSON.stringify({...e,rewards:null,fov:null});return Xn.has(n)||Xn.set(n,We(e)?Promise.resolve(
null):dl(t,e)),Xn.get(n)}var ds=()=>new Promise(t=>setTimeout(t));async function dl(t,e){await ds();let n=t.solution(e);for(;n.goBack();)await ds();return n}function Jt(t,e,n){
return n.flatMap((r,o)=>{let s=[0,0];for(let a=e.n_turns;a>0&&!e.over;a--)t.game(e)?.lost(r).forEach((i,l)=>s[l]+=i),e.playTurn(r);return ul.map((a,i)=>({step:o+
1,team:a,lost:s[i]})).filter(a=>a.lost>=Qn)})}var Xt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost,text:xt(e)})),xt=({team:t,lost:e})=>`The ${t}s lose ${e.toFixed(
2)} against a perfect opponent`;function ps(t,e){return(t.marginal(e)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=Qn).sort((r,o)=>o.share-r.share).
map(({share:r,action:o})=>r>1-Qn?ue[o]:`${ue[o]} ${r.toFixed(2)}`).join(", ")}function Qt(t,e,n){if(n===0)return[{kind:"start",text:pl(t),agents:[]}];let[r,o]=[e.moments[n-1],e.moments[n]],s=u=>G(u,t.config.n_pursuers),a=mt(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),d=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Nt(r,o))!a.includes(u)&&!l.has(u)&&d.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return d.push(...i.map(({kind:u,text:c,agents:m})=>({kind:u,text:c,agents:m}))),n===t.length&&d.unshift({kind:"\
end",text:ml(t),agents:[]}),d}function pl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ml(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var hl=60,en=class{element;player=new Se(0,{speed:Ke,still:se()});inspector;match=null;recording=null;actions;#e;#n;#t;#r;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#l=p("ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#p=p("p",{class:"problem",role:"alert"});#c=null;#m=null;#d=0;#i=!1;#h=0;#u=[];constructor(e,n,r){
[this.#n,this.#t]=[e,n];let o=p("canvas",{"aria-label":"The match"});this.#e=new xe(o,{numbers:!1}),this.#r=new Kt(n),this.inspector=new Yt(s=>this.#x(s)),o.addEventListener(
"click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"M\
ove the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),us(()=>this.shown,
r)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),
this.#p,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#l,Yo(),this.actions,this.inspector.element),Ze(this.player),this.#r.element)),this.player.addEventListener(
"frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#w()),n.on("match",()=>this.#f()),n.on("\
rest",()=>this.player.pause()),this.#b(),this.#S(0,0)}get#o(){return this.#n[this.#t.selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){
return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){this.#c=e,this.#g()}playSoon(){this.#i=!0,this.#d||this.#y()}goTo(e){
this.#h=e,!this.#d&&this.match&&this.#g()}#y(){!this.#i||!this.match||(this.#i=!1,this.player.jump(0),se()||this.player.play())}#f(){this.#b(),clearTimeout(this.#d),
this.#d=setTimeout(()=>this.#g(),hl)}#g(){clearTimeout(this.#d),this.#d=0,this.player.pause(),this.#b();let{selected:e}=this.#t,n=ce.map(s=>Te(this.#o,s,e[s])).
find(Boolean)??"";if(this.#p.textContent=n,n||!this.#c)return;this.match=Je(this.#c,this.#o,e);let[r,o]=this.names(e);this.#m={pursuer:{name:r,policy:Z(this.#o,
"pursuer",e.pursuer)},evader:{name:o,policy:Z(this.#o,"evader",e.evader)}},this.recording=qt(this.match),this.#r.show(this.#o,this.match),this.inspector.show(this.#c,
this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=po(this.recording),this.#u=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,
this.#w(),this.#v(this.#c,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#y()}async#v(e,n){let r=await Zt(
e,n.config);if(this.match!==n||!r)return;let o=e.world(n.config);n.seek(o,0),this.#u=Jt(r,o,fl(n)),o.free(),this.player.ticks=Xt(this.#u),this.inspector.solution=
r,this.#w()}names({run:e,pursuer:n,evader:r}){let{teams:o}=this.#n[e];return[o.pursuer.script??`pursuers ${n}`,o.evader.script??`evaders ${r}`]}#b(){let{episode:e,
seed:n}=this.#t.selected,{payoff:r}=this.#o,[o,s]=this.names(this.#t.selected),a=n===null?e<r.episodes?`episode ${e+1} of ${r.episodes}`:`episode ${e+1}, not pa\
rt of the cell`:`seed ${n}`;this.#a.replaceChildren(p("span",{class:"pursuer"},o)," against ",p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#w(){
let e=this.match;if(!e||!this.recording)return;let n=this.player.step,r=this.recording.moments[n];this.#S(Array.from(r.everCaptured).filter(Boolean).length,n),this.#l.
replaceChildren(...this.#u.filter(o=>o.step===n).map(o=>p("li",{class:`loss-${o.team}`},xt(o))),...Qt(e,this.recording,n).map(o=>p("li",{class:o.kind,"data-agen\
ts":o.agents.join(" ")},o.text))),this.inspector.at(n),this.#M()}#S(e,n){this.#s.replaceChildren(p("strong",{},e),` of ${this.#o.world.n_evaders} captured`,p("s\
pan",{class:"muted"},` · step ${n}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let n of this.#l.children){
let r=n.dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}},fl=({actions:t,length:e,n_agents:n})=>Array.from({length:e},
(r,o)=>t.subarray(o*n,(o+1)*n));var gl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},yl=5;function Re(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=gl[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,d]=n(),u=o.shiftKey?yl:1,{pursuer:c,evader:m}=e.selected;e.
select({pursuer:ms(c+u*a,l),evader:ms(m+u*i,d)}),o.preventDefault(),o.stopPropagation()})}var ms=(t,e)=>Math.min(e-1,Math.max(0,t));var vl=24,tn=7,fs=t=>t<vl&&matchMedia("(pointer: coarse)").matches;function gs(t,e,n,r){let[o,s]=t.payoff.shape,[a,i]=[hs(e,o),hs(n,s)],[l,d]=[Math.min(tn,o),Math.
min(tn,s)],u=[];for(let g=a+l-1;g>=a;g--){u.push(p("span",{class:"pursuer"},g));for(let f=i;f<i+d;f++)u.push(bl(t,g,f,r))}let c=Array.from({length:d},(g,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...u,m,...c);return h.style.gridTemplateColumns=`2.4rem repeat(${d}, minmax(0, 1fr))`,h.addEventListener("click",g=>g.stopPropagation()),
h}function bl(t,e,n,r){let o=He(t,e,n)?.rate,s=p("button",{type:"button","aria-label":`${B(o)}: pursuers ${e} against evaders ${n}`,onclick:()=>r({pursuer:e,evader:n})},
B(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[jt(o),Ht(o)]),s}var hs=(t,e)=>Math.max(0,Math.min(e-tn,t-Math.floor(tn/2)));var re={left:52,bottom:46,top:76,right:84},de=10,wl=160,St=re.right-de-14,_e=re.top-de-14,nn=class{element;#e;#n;#t=p("canvas",{"aria-hidden":"true"});#r=M("svg",
{"aria-hidden":"true"});#a=M("g");#s;#l=p("h2");#p=p("strong",{class:"rate numbers"});#c=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#d=null;constructor(e,n){[this.#n,this.#e]=[e,n],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#r);let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#l,this.#m),p("div",{class:"of-cell"},this.#p,this.#c));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#s,Vt("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).
observe(this.#s),this.#s.addEventListener("pointermove",o=>this.#b(o)),this.#s.addEventListener("pointerleave",()=>n.point({})),this.#s.addEventListener("click",
o=>this.#w(o)),this.#s.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Re(this.#s,
n,()=>this.#i.payoff.shape),this.#s.addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),n.on("run",()=>this.#h()),n.on("match",()=>this.#y()),n.on("hove\
r",()=>this.#y())}get#i(){return this.#n[this.#e.selected.run]}#h(){let[e,n]=this.#i.payoff.shape,{clientWidth:r,clientHeight:o}=this.#s;if(r<50)return;let a=Math.
max(wl,Math.min(r-re.left-re.right,o-re.top-re.bottom))/Math.max(e,n),i=Math.max(re.left,(r-n*a-re.right+re.left)/2),l=re.top+Math.max(0,(o-re.top-re.bottom-e*a)/
2),d={width:r,height:o,left:i,top:l,cell:a,rows:e,columns:n};this.#d=d,Gt(this.#t,this.#i.payoff,{left:i,top:l,width:n*a,height:e*a}),this.#r.setAttribute("view\
Box",`0 0 ${r} ${o}`),this.#r.replaceChildren(xl(d),...Sl(d),...this.#o(d),this.#a),this.#y()}#u(e){let n=this.#i.findings?.generalization;if(!n)return[];let{selected:r,
hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??r.evader],[i,l]=ys(e,n.pursuers.mean[s]??0,s),[d,u]=vs(e,n.evaders.mean[a]??0,a);return[M("circle",{class:"\
dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:d,cy:u,r:5})]}#o(e){let n=this.#i.findings?.generalization;if(!n)return[];let{left:r,top:o,
cell:s,rows:a,columns:i}=e,[l,d]=[r+i*s+de,o-de],u={class:"side"};return[M("rect",{...u,x:l,y:o,width:St,height:a*s}),M("rect",{...u,x:r,y:d-_e,width:i*s,height:_e}),
...bs(n.pursuers,(c,m)=>ys(e,c,m),"of-pursuers"),...bs(n.evaders,(c,m)=>vs(e,c,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),
M("text",{class:"tick",x:l+St,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:r-6,y:d-4,"text-anchor":"end"},"0"),M("text",{class:"tick",x:r-6,y:d-
_e+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+St,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-evaders",x:r+i*s+
de,y:d-_e+10,"text-anchor":"start"},"escapes")]}#y(){let e=this.#d;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,d=g=>s+
(i-1-g)*a,u=[],c=(g,f)=>M("rect",{class:f,x:o,y:d(g),width:l*a+de+St,height:a}),m=(g,f)=>M("rect",{class:f,x:o+g*a,y:s-de-_e,width:a,height:de+_e+i*a});u.push(c(
n.pursuer,"strip pursuer"),m(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(c(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(m(r.
evader,"strip hover")),u.push(...this.#u(e));let h={x:o+n.evader*a,y:d(n.pursuer),width:a,height:a};u.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...u),this.#f()}#f(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=He(this.#i,r,o);this.#l.
replaceChildren(p("span",{class:"pursuer"},`Pursuers ${r}`)," against ",p("span",{class:"evader"},`evaders ${o}`)),this.#p.textContent=s?B(s.rate,3):"-",this.#c.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#m.textContent=this.#g(r,o)}#g(e,n){let r=this.#i.findings?.
generalization;if(!r)return"";let o=(s,a)=>Jo(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(r.pursuers,e)}, escapes ${o(r.evaders,
n)}`}#v(e){let n=this.#d;if(!n)return null;let r=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-
r.top-n.top)/n.cell),[a,i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#b(e){let n=this.#v(e);this.#e.point(n?{pursuer:n.
g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#w(e){let n=this.#v(e);if(n){if(n.inside&&fs(this.#d.cell))return this.#S(n.g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.
g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#x()}}#S(e,n){let r=gs(this.#i,e,n,o=>{r.remove(),o&&(this.#e.select(o),this.#x())});this.#s.append(r)}#x(){this.#s.
dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function xl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"axes"}),a=e+r*n,i=l=>bt(0,l-1,Math.
min(l,l*n/44),!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*n,y:a+16,"text-anchor":"middle"},l));for(let l of i(r))s.append(M("text",{class:"\
tick",x:t-7,y:a-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*n/2,y:a+36,"text-anchor":"\
middle"},"evader generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generat\
ion")),s}function Sl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;for(let u of["H","V"]){
let c=`M${t} ${i}`;for(let m=1;m<=a;m++){let[h,g]=[`H${t+m*n}`,`V${i-m*n}`];c+=u==="H"?h+g:g+h}s.append(M("path",{d:c,class:"under"}),M("path",{d:c}))}let[l,d]=[
t+a/2*n-.7*n-4,i-a/2*n-.7*n-4];return[s,M("text",{class:"on-cells",transform:`translate(${l} ${d}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var ys=({
left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+de+s*St,e+(r-a-.5)*n],vs=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-de-r*_e];function bs(t,e,n){let r=s=>s.map(
(a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].join("\
L")}Z`})),o.push(M("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function ae(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}function ws(t,e,n){let{findings:r}=t;if(!r?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&Al(o,t,i,e,
l)},a=r.checkerboards.map(i=>Ml(t,i,s));return{element:ae("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Cl\
ick one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?
p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise m\
akes."):null,o)}}var xs=({pursuers:[t,e],evaders:[n,r]})=>[[t,n],[t,r],[e,n],[e,r]];function Ml(t,e,n){let[r,o]=e.pursuers,[s,a]=e.evaders,i=xs(e).map(([l,d])=>{
let u=t.payoff.capture_rate[l][d],c=p("span",{class:"cell"},B(u));return c.style.backgroundColor=jt(u),c.style.color=Ht(u),c});return p("button",{type:"button",
class:"miniature numbers",onclick:()=>n(e)},p("span",{},p("span",{class:"heard"},`Four matches of pursuers ${r} and ${o}, evaders ${s} and ${a}:`)),p("span",{class:"\
evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},r),i[0],i[1],p("span",{class:"pursuer"},o),i[2],i[3])}function Al(t,e,n,r,o){let s=xs(n).filter(
([m,h])=>!Te(e,"pursuer",m)&&!Te(e,"evader",h)),a=s.map(([m,h])=>Je(o,e,{run:r.selected.run,pursuer:m,evader:h,episode:0,seed:null})),i=new Se(Math.max(0,...a.map(
m=>m.length)),{speed:Ke,still:se()}),l=a.map((m,h)=>{let[g,f]=s[h],y=p("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),v=p("span",{class:"numbers"}),
x=()=>{t.close(),r.select({pursuer:g,evader:f})},b=p("figure",{},y,p("figcaption",{class:"small"},v,p("span",{class:"muted"},`cell ${B(e.payoff.capture_rate[g][f])}`),
p("button",{type:"button",title:"Show this match alone",onclick:x},"open")));return b.style.gridArea=`${n.pursuers.indexOf(g)+2} / ${n.evaders.indexOf(f)+2}`,{element:b,
match:m,recording:qt(m),board:new xe(y,{numbers:!1}),tally:v}}),d=()=>l.forEach(m=>m.board.show(m.recording,i.time)),u=()=>l.forEach(({recording:m,match:h,tally:g})=>{
let f=m.moments[Math.min(i.step,h.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener(
"frame",d),i.addEventListener("step",u),t.replaceChildren(p("header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},
"Close")),p("div",{class:"grid-of-four"},p("span"),...n.evaders.map(m=>p("h3",{class:"evader"},`evaders ${m}`)),...n.pursuers.map((m,h)=>{let g=p("h3",{class:"p\
ursuer"},`pursuers ${m}`);return g.style.gridArea=`${h+2} / 1`,g}),...l.map(m=>m.element)),Ze(i));let c=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof
HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&Me(i,m)&&m.preventDefault()};t.addEventListener("keydown",c),t.addEventListener("close",()=>{t.removeEventListener(
"keydown",c),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},{once:!0}),r.dispatchEvent(new Event("rest")),t.showModal(),d(),u(),se()||i.play()}var rn={pursuer:"evader",evader:"pursuer"};function Ss(t,e){let n=t.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${B(s)}, stripes ${B(a)}${i===null?"":` every ${i} generations`}`;return El(t,o,l,e)});return{element:ae("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element)),Vt("0 loses","1 wins")),
update:()=>r.forEach(o=>o.update())}}function El(t,e,n,r){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(b,w)=>e==="pursuer"?t.payoff.
capture_rate[b][w]:1-t.payoff.capture_rate[w][b],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),u=d?.createImageData(a,s);for(let b=0;u&&
b<s;b++)for(let w=0;w<=Math.min(b,a-1);w++)u.data.set([...Ye(i(b,w)),255],4*((s-1-b)*a+w));u&&d?.putImageData(u,0,0);let c=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,c),g=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${n}. Arrow keys choose a match.`},l,h);Re(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=b=>{let w=g.
getBoundingClientRect(),A=Math.floor((b.clientX-w.left)/w.width*a),C=s-1-Math.floor((b.clientY-w.top)/w.height*s);return A>=0&&C<s&&A<=C?[C,A]:null},y=b=>({[e]:b[0],
[rn[e]]:b[1]});g.addEventListener("pointermove",b=>r.point(f(b)?y(f(b)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",b=>f(
b)&&r.select(y(f(b))));let v=()=>{let b=r.hover[e]??r.selected[e],w=r.hover[rn[e]]??r.selected[rn[e]];for(let A of[c,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-b)),A.style.display=w<=b?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),g,p("p",{class:"smal\
l muted"},`horizontal: ${rn[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},n)),update:v}}var on={left:46,right:12,top:10,bottom:42},Ms={x:56,y:34};function er(t,e,n,r){let[o,s]=[on.left,on.top],a=Math.max(o+40,t-on.right),i=Math.max(s+40,e-on.bottom),
l=(f,y,v)=>x=>y+(x-f.low)/(f.high-f.low||1)*(v-y),[d,u]=[l(n,o,a),l(r,i,s)],c=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of bt(r.low,r.high,(i-s)/Ms.y,r.whole))h.append(M("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),M("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},As(f)));for(let f of bt(n.low,n.high,(a-o)/Ms.x,n.whole))h.append(M("text",{x:d(f),y:i+16,"text-anchor":"middle"},As(f)));return h.
append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},n.label),M("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),m.append(h,c),{root:m,marks:c,left:o,right:a,top:s,bottom:i,x:d,y:u,at:f=>{let y=f-m.getBoundingClientRect().
left;return n.low+(y-o)/(a-o)*(n.high-n.low)}}}var As=t=>String(Number(t.toPrecision(6))).replace("-","−");function tr(t,e,n,r){let o="",s="M";n.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(M("path",{d:o,class:`line ${r}`}),t.marks)}function nr(t,e,n,r=null){
let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(r),r:5,class:`dot ${n}`}))}
function rr(...t){return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function or(t,e,n,r){let o=p("div",{class:"chart choose\
s",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&n(s)};return o.addEventListener("click",i=>s&&r(s.at(i.clientX),s,i)),new ResizeObserver(
()=>{let{clientWidth:i,clientHeight:l}=o;i<50||l<50||(s=e(i,l),o.replaceChildren(s.root),a())}).observe(o),{element:o,update:a}}var sr=["of-pursuers","of-evaders","of-both"],Tl=2500,Es="Arrow keys choose generations.",Cl={low:0,high:1,label:"capture rate"};function Ts(t,e){let{training:n}=t,
{capture_rate:r,generation:o,learner:s,epochs:a}=n,i=r.map((g,f)=>(f+1)*a),l=kl(r,n.window),d=i.at(-1)??1,u=i.length>Tl?"dense":"",c=(g,f)=>{let y=o.flatMap((v,x)=>v===
g&&(s[x]===f||s[x]===2)?[x]:[]);return y.length?[i[y[0]],i[y.at(-1)]]:null},m=or(`Capture rate in ${d} epochs of training. ${Es}`,(g,f)=>{let y=er(g,f,{low:0,high:d,
label:"epoch",whole:!0},Cl);for(let[v,x]of[["raw",r],[u,l]])for(let[b,w]of sr.entries()){let A=x.map((C,E)=>s[E]===b||s[E+1]===b?C:null);A.some(C=>C!==null)&&tr(
y,i,A,`${w} ${v}`)}return y},g=>ce.forEach((f,y)=>{let v=c(e.hover[f]??e.selected[f],y);v&&nr(g,(v[0]+v[1])/2,sr[y])}),g=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(g/a)-1)),y=o[f];s[f]!==1&&e.select({pursuer:Math.min(y,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(y,t.payoff.shape[1]-1)})});Re(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],sr[g]]);return{element:ae("Training",`${Xo(n.
matches)} training matches. Lines: the generations that are selected.`,rr(...h),m.element),update:m.update}}function Cs(t,e){let n=t.findings?.ratings;if(!n)return null;
let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...t.payoff.
shape)-1,d=or(`Elo ratings by generation. ${Es}`,(u,c)=>{let m=er(u,c,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let h of ce)
tr(m,r[h].map((g,f)=>f),r[h],`of-${h}s`);return m},u=>{for(let c of ce){let m=e.hover[c]??e.selected[c];nr(u,m,`of-${c}s`,r[c][m]??null)}},(u,c,m)=>{let h=Math.
round(u),g=m.clientY-c.root.getBoundingClientRect().top,f=v=>Math.abs(c.y(r[v][h]??1/0)-g),y=f("pursuer")<=f("evader")?"pursuer":"evader";h>=0&&h<r[y].length&&e.
select({[y]:h})});return Re(d.element,e,()=>t.payoff.shape),{element:ae("Ratings",`One number for each generation, which cycles do not fit. The game itself: ${B(
n.offset,0)} points for the pursuers.`,rr(["pursuers","of-pursuers"],["evaders","of-evaders"]),d.element),update:d.update}}function kl(t,e){let n=[0];for(let r of t)
n.push(n.at(-1)+r);return t.map((r,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(n[a]-n[s])/(a-s)})}var Rl={present:"●",absent:"○","cannot tell":"?"};function ks(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],d)=>{
let u=_l(e.reasons[d]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Rl[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ae("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${Rs(s)}.`)),p("ul",{class:"findings"},...r),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function _l(t){let[,e=""]=t.split(/, because (.*)/s);return Rs(e.replace(/\.$/,""))}var Rs=t=>t.charAt(0).toUpperCase()+t.slice(1);function _s({settings:t,schedule:e,seed:n}){let r=t.map(({name:a,value:i,help:l})=>p("tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"n\
umbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...r),s=ae("Settings",`${e}, \
seed ${n}; all others are the defaults of matrixworld evolve.`,r.length?p("div",{class:"wide-table"},o):null);return s.classList.add("settings"),{element:s}}function $s(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??$l(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(d=>d.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function $l(t,e,n){return[ks(t),Ts(t,e),ws(t,e,n),Cs(
t,e),Ss(t,e),_s(t)].filter(o=>o!==null)}var cn=xa(js(),1);var ur=125,Ql=80,ec=10,Gs=480,tc=[1,.8,.6,.4,.2],nc=5;async function Vs(t,e){let n=Math.min(1,ft(t.rows,t.cols)),[r,o]=[Math.round(Gs*n),Math.round(Gs*n/ft(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[r,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=qe(document.documentElement),l={ctx:a,colors:i,
grid:Dt(t.rows,t.cols,!1,r,o,1)},[d,u]=[rc(i,a),(0,cn.GIFEncoder)()];for(let c=0;c<ur;c++){let m=Math.min(1,c/(ur-ec))*(t.moments.length-1);zt(l,t,m,{...Ft,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,r,o),a.globalCompositeOperation="source-over",u.writeFrame((0,cn.applyPalette)(
a.getImageData(0,0,r,o).data,d),r,o,{palette:d,delay:Ql}),c%nc===0&&(e(Math.round(100*c/ur)),await new Promise(h=>setTimeout(h)))}return u.finish(),new Blob([u.
bytes()],{type:"image/gif"})}function rc(t,e){let n=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),r=n(t.
paper);return Object.values(t).map(n).flatMap(o=>tc.map(s=>o.map((a,i)=>Math.round(r[i]+s*(a-r[i])))))}function qs(t,e){let n=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),r=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"bu\
tton",class:"save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:l,evader:d}=e.selected;s.disabled=!0;let u=await Vs(t.recording,m=>r.textContent=`Dr\
awing: ${m} %`),c=URL.createObjectURL(u);p("a",{href:c,download:`pursuers-${l}-evaders-${d}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(c),6e4),r.textContent=
`Saved, ${(u.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{
id:"share-title"},"Share this match"),s,lt()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),lt()&&p("div",{class:"link"},n,
p("button",{type:"button",onclick:()=>Wr(n,r)},"Copy")),r,p("button",{type:"button",onclick:()=>a.close()},"Close"));return a.addEventListener("click",l=>l.target===
a&&a.close()),{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),n.value=location.href,r.textContent="",a.showModal()}},
"Share"),dialog:a}}var Ks={pursuer:null,evader:null},un=class extends EventTarget{#e;#n=Ks;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...Ks,...e};n.pursuer===this.#n.pursuer&&n.evader===this.#n.evader||(this.#n=n,this.dispatchEvent(
new Event("hover")))}on(e,n){this.addEventListener(e,n)}};var dn=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,n,r){[this.config,this.start]=[n,r],this.#e=e.world(n),this.#e.reset(r),this.#n=[qn(this.#e)],
this.recording=Vn(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,n,r){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,
[Math.max(l,s),d],a)),typeof r=="number"?a[n]=r:l<=n&&n<d&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#n.push(qn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var pe=(t,e)=>ce[+(e>=t.n_pursuers)];function dr(t,e){let n=new dn(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.
seat,r);return n}function Xe(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var pn=(t,e)=>t.over||Xe(t,e).out;function Ys(t,e,n){let r=dr(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!pn(r,e.seat);)r.step(e.policies,e.seat,n);return Xe(r,e.seat)}function Zs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}
function Js(t,{seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Xs(t,e){let[n,r,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function pr(t,e,n,r,o,s){e.play({title:n,played:r,ending:(a,i)=>[oc(t,a,i,Zs(o))],again:()=>pr(t,e,n,{...r,moves:r.moves.slice(0,r.from)},o,s),link:a=>Js(s,a)})}
function oc(t,e,n,r){let o=pe(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=d=>{let[u,c]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},d),p("td",{class:"track","aria-hidden":"true"},u),c)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,
c.textContent=String(o?m:h)}};i("You")(Xe(e,n.seat));for(let{name:d,policy:u}of r){let c=i(d);setTimeout(()=>c(Ys(t,n,u())))}let l=n.from?`You took over at step\
 ${n.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Qs=["·","↑","→","↓","←","↗","↘","↙","↖"];var sc={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},mr=[8,1,5,4,0,2,7,3,6],ac=[7,8,9,4,5,6,1,2,3],ic=24,lc=Math.
tan(Math.PI/8);function ta(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=ac.findIndex(o=>t.code===`Numpad${o}`),r=mr[n]??sc[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function na(t){let e=mr.map(n=>p("button",{type:"button","aria-label":ue[n],onclick:()=>t(n)},Qs[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",mr[o]>4&&!n))}}function ea(t,e,n){let r=lc*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return co([0,0],n?[o(t),o(e)]:[t,e],n)}function ra(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,e()];if(r=null,!i||!l)return;let[d,u]=[s-i[0],a-i[1]],c=t.cellAt(s,a);Math.hypot(d,u)>=ic?n(ea(u,d,l.diagonal)):c&&n(ea(c[0]-l.cell[0],
c[1]-l.cell[1],l.diagonal))})}function oa(t,e){let n=r=>{let o=e[r]-t[r],s=je.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${ue[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var ia="NUMPY\0",sa=ia.length+2,aa=64;function la(t){return so(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,cc(n)])))}function cc({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((sa+s.length+1)/aa)*aa-sa,i=ia+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,d=new Uint8Array(i.length+l.byteLength);return d.set(_t(i,!0)),d.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),d}var uc="matrixworld episode 3";function ca(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],d={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},c={},m=b=>{
for(let w of Object.keys(b))(c[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(r);h.reset(e.start);let g=[];m(d);for(let b of o)h.step(b),m({...d,...u}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[b,[w,...A]]of Object.entries({...d,...u})){let C=s+
+(b in d);y[b]={dtype:w,shape:[C,...A],data:f[w].from((c[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return la({format:x(uc),n_pursuers:v(r.n_pursuers),config:x(JSON.stringify(r)),seat:v(n),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var dc=[0,1,2,4,8],mn=class{element;player=new Se(0,{speed:4,still:se()});#e;#n;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=na(e=>this.act(e));#l=p("select",{},...dc.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#p=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#m=p("span");#d=p("p",{class:"small muted play-keys",id:"play-keys"});#i=p("section",{class:"play-ending",tabindex:-1,
"aria-labelledby":"play-headline"});#h=Ze(this.player);#u=null;#o=null;#y=[];#f=null;#g=null;#v=[];#b=0;#w=0;constructor(e){this.#e=e,this.#n=new xe(this.#t,{numbers:!1}),
this.#t.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#A()),this.#p.addEventListener("change",()=>this.#x()),this.#c.addEventListener(
"change",()=>this.#E()),ra(this.#n,()=>{let n=this.#f!==null&&this.#o&&P(this.#o.recording.moments.at(-1),this.#f);return n?{cell:n,diagonal:this.#o.config.diagonal}:
null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#o&&this.#n.show(this.#o.recording,this.player.time)),this.player.addEventListener("step",()=>this.#E()),
this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#r,this.#a),p("div",{class:"play-stage"},this.#t),p("div",{class:"play-side"},this.#i,this.#s.
element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),p("label",{class:"play-choice"},this.#p,p("span",{},"Fog",p("span",{class:"at-le\
ngth"},": see only what it sees"))),p("label",{class:"play-choice"},this.#c,this.#m),this.#d),this.#h)}get played(){return this.#u&&{...this.#u.played,moves:this.#y}}get live(){
return this.#o}play(e){this.#S(dr(this.#e,e.played),e.played.seat,e.title),[this.#u,this.#y,this.#b]=[e,[...e.played.moves],0],this.element.dataset.state="playi\
ng",this.#t.focus({preventScroll:!0}),pn(this.#o,e.played.seat)&&this.#R()}watch(e,n,r){this.#u=null,this.#S(e,n,r),this.#_()}stop(){this.#A(),this.player.pause(),
this.#u=null}act(e){let[n,r]=[this.#u,this.#o];if(!n||!r||this.element.dataset.state!=="playing")return;this.#b=e;let o=Number(this.#l.value);this.#w||(this.#k(),
o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||n instanceof
HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#o)return!1;if(this.element.dataset.state!=="playing")
return Me(this.player,e);let s=ta(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,n,r){this.#A(),this.player.pause(),[this.#o,this.#f]=
[e,n],this.#r.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(p("spa\
n",{class:"at-length"},`Arrow keys or W A X D move, Space or S stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the board\
: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#x(){this.#n.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#$()}}#M(e){this.#g=null,this.#v=this.player.ticks=[];let n=We(e.config);this.#c.disabled=!!n,
this.#m.textContent=n?`No best move: ${n}`:"Best move",Zt(this.#e,e.config).then(r=>{this.#o===e&&(this.#g=r,this.#T(),this.#E())})}#T(){let[e,n]=[this.#o,this.#g];
if(!n||this.element.dataset.state==="playing")return;let r=this.#e.world(e.config);r.reset(e.start),this.#v=Jt(n,r,e.actions),r.free(),this.player.ticks=Xt(this.#v)}get#C(){
return this.#c.checked&&this.#u&&this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#$(){let[e,n]=[this.#f,this.#f!==null&&this.#C?.marginal(
this.#f)];return e!==null&&n?Object.assign(Array(e).fill(0),{[e]:n.indexOf(Math.max(...n))}):null}#A(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(
this.#l.value)?"off":"polite"}#k(){let[{policies:e,seat:n},r]=[this.#u.played,this.#o];r.step(e,n,this.#b),this.#y.push(this.#b),this.player.length=r.length,this.
player.glide=Math.min(.22,.9/(Number(this.#l.value)||4)),this.player.move(r.length-this.player.step),pn(r,n)&&this.#R()}#R(){this.#A();let[e,n,r]=[this.#u,this.#o,
this.played],o=lt()?e.link(r):null;this.#i.replaceChildren(p("h3",{id:"play-headline"},hc(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",
{type:"button",class:"primary",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},"Watch it"),p("button",{type:"button",onclick:()=>this.#O(
n,r.seat)},"Save"),o&&p("button",{type:"button",onclick:({currentTarget:a})=>yc(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#v.filter(
({team:a})=>a===pe(n.config,r.seat));s.length&&this.#i.children[0].after(p("p",{class:"small muted"},fc(s))),this.#i.focus({preventScroll:!0}),this.#i.scrollIntoView(
{block:"nearest"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),se()||this.player.play()}#O(e,n){let r=new Blob(
[ca(this.#e,e,n)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(r),download:`${G(n,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#E(){
let[e,n,{step:r}]=[this.#o,this.#f,this.player];if(!e||r>e.length)return;let o=Qt(e,e.recording,r).filter(({agents:i})=>n===null||i.includes(n)),s=[`Step ${r} o\
f ${e.config.max_steps}`,...o.map(({text:i})=>i)];this.#u&&r===0?s.push(pc(e.config,n)):n!==null&&s.push(mc(e,r,n)),s.push(...this.#v.filter(i=>i.step===r).map(
xt));let a=r===e.length&&n!==null?this.#C:null;a&&s.push(`Perfect play: ${ps(a,n)||"decided in its turn"}; value ${a.value.toFixed(2)}`),this.#x(),this.#a.textContent=
s.filter(Boolean).map(i=>`${i}.`).join(" ")}};function pc(t,e){let n=t.rules.capture==="SURROUND";return pe(t,e)==="evader"?`Stay free: ${n?"pursuers on all sid\
es of you capture":"a pursuer on your cell captures"} you`:`Capture evaders: ${n?"surround them together":"reach their cell"}`}function mc({config:t,recording:e},n,r){
let o=e.moments[n],a=pe(t,r)==="pursuer"?"evader":"pursuer";if(!o.alive[r])return"";let i=P(o,r),l=c=>{let[m,h]=P(o,c);return Math.max(Math.abs(m-i[0]),Math.abs(
h-i[1]))},d=Array.from({length:o.alive.length},(c,m)=>m).filter(c=>pe(t,c)===a&&o.alive[c]&&!o.captured[c-t.n_pursuers]&&2*l(c)<t.fov);if(!d.length)return`No ${a}\
 in view`;let u=d.reduce((c,m)=>l(m)<l(c)?m:c);return`Nearest ${a}: ${oa(i,P(o,u))}`}function hc(t,e){let[{lasted:n,out:r,captured:o},{config:s}]=[Xe(t,e),t];return pe(
s,e)==="pursuer"?`Your team captured ${o} of ${gc(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}function fc(t){let e=t.
reduce((r,o)=>o.lost>r.lost?o:r);return`Your team's moves lost ${t.reduce((r,{lost:o})=>r+o,0).toFixed(2)} of the capture rate against a perfect opponent, most \
in step ${e.step}: ${e.lost.toFixed(2)}.`}var gc=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function yc(t,e){let n=p("input",{type:"text",readonly:!0,value:e,
"aria-label":"Link to this match"});t.replaceWith(n),n.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var hn=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#n;#t;#r=null;constructor(e,n,r){[this.#e,this.#n,this.#t]=[e,n,r],
r.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.view?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.view?.stop())}start(e,n){this.#r=e;let r=ct(n,this.#e,this.#n.selected),o=Xs(new URLSearchParams(n.replace(/^#/,"")),this.#e[r.run].world);o&&this.#a(
r,o)}open(){let e=this.#t.shown;if(!e)return;let{match:n,step:r}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=r<n.length?r:0,a=(c,m)=>!!n.alive[m*n.
n_agents+c],i=Array.from({length:n.n_agents},(c,m)=>(m+n.config.n_pursuers)%n.n_agents),l=o??i.find(c=>a(c,s)),d=a(l,s)?s:0,u=Array.from({length:d},(c,m)=>n.actions[m*
n.n_agents+l]);this.#a(this.#n.selected,{seat:l,from:d,moves:u})}#a(e,n){let[r,o]=[this.#r,this.#e[e.run]];if(!r||ce.some(f=>Te(o,f,e[f])))return;let{run:s,pursuer:a,
evader:i,episode:l,seed:d}=e,u=pe(o.world,n.seat),c=o.teams[u].kept.map(f=>({name:o.teams[u].script??`generation ${f}`,policy:()=>Z(o,u,f)}));this.view||(this.view=
new mn(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.
showModal();let m=`You are ${G(n.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,h={pursuer:Z(o,"pursuer",a),evader:Z(o,"evader",i)},g={config:o.
world,seed:BigInt(d??o.seeds[a][i]),episode:l,policies:h,...n};pr(r,this.view,m,g,c,{run:s,pursuers:a,evaders:i,episode:l,...d===null?{}:{seed:d}})}};var me=io(),{runs:X}=me,[vc,bc]=X[0].payoff.shape,wc=ct(location.hash,X,{run:0,pursuer:vc-1,evader:bc-1,episode:0,seed:null}),{step:da,...xc}=wc,J=new un(xc),D=new en(
X,J,me.playground),pa=new nn(X,J),et=new hn(X,J,D),hr=Vo(),Sc=location.hash,ua=Ho(X,J,D),{button:Mc,dialog:Ac}=qs(D,J);D.actions.append(Mc);var Qe=null,ma=p("as\
ide",{class:"note small muted"},me.note),Ec="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";
document.getElementById("page").replaceWith(p("header",{class:"top"},p("div",{},p("h1",{},me.heading),p("p",{class:"lead"},Ec)),p("div",{class:"tools"},ua.button,
Hr(),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>hr.showModal()},"?"))),...me.note?[ma]:[],Go(X,J),p("mai\
n",{class:"stages"},pa.element,D.element),$s(X,J,()=>Qe),p("footer",{class:"muted small"},`${me.title} · matrixworld ${me.version}`),et.dialog,hr,Ac,ua.bar);Object.
assign(window,{matrixworldExplorer:{get match(){return D.match},get step(){return D.player.step},get pace(){return D.player.pace},get playing(){return et.view},
play:t=>Qe&&Je(Qe,X[J.selected.run],{...J.selected,episode:t}),get shape(){return X[J.selected.run].payoff.shape}}});pa.element.addEventListener("play",()=>{D.playSoon(),
D.reveal()});D.goTo(da);da||D.playSoon();jr(X,J,D);qo(X,J,D,hr,()=>et.open(),()=>Jn(D.shown,me.playground));window.addEventListener("hashchange",({newURL:t})=>Qe&&
et.start(Qe,new URL(t).hash));me.live!==null&&Ko(me.live,X,J,()=>D.player.playing||et.dialog.open,()=>{ma.textContent="The command has ended. This page shows wh\
at it had played; explorer.html is beside the runs if they have finished."});requestAnimationFrame(()=>setTimeout(()=>{zr().then(t=>{Qe=t,D.start(t),et.start(t,
Sc),document.body.dataset.ready="true"},t=>{D.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.
dataset.ready="true"})}));})();
