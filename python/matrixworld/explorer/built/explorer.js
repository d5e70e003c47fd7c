/* built from web/ by "npm run build"; sources 148b5d616ccd87a97efaf555180ae3c9582d0a3c85029da27a42905bda8ddcba */
"use strict";(()=>{var na=Object.create;var ar=Object.defineProperty;var ra=Object.getOwnPropertyDescriptor;var oa=Object.getOwnPropertyNames;var sa=Object.getPrototypeOf,aa=Object.prototype.hasOwnProperty;var ia=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(n){throw e=0,n}};var la=(t,e,n,r)=>{if(e&&typeof e=="object"||typeof e=="function")for(let o of oa(e))!aa.call(t,o)&&o!==n&&ar(t,o,{get:()=>e[o],enumerable:!(r=ra(e,o))||r.enumerable});
return t};var ca=(t,e,n)=>(n=t!=null?na(sa(t)):{},la(e||!t||!t.__esModule?ar(n,"default",{value:t,enumerable:!0}):n,t));var Ps=ia(er=>{var Ms=Object.defineProperty,dl=t=>Ms(t,"__esModule",{value:!0}),pl=(t,e)=>{for(var n in e)Ms(t,n,{get:e[n],enumerable:!0})};dl(er);pl(er,{GIFEncoder:()=>$s,
applyPalette:()=>xl,default:()=>_l,nearestColor:()=>El,nearestColorIndex:()=>ks,nearestColorIndexWithDistance:()=>Rs,prequantize:()=>wl,quantize:()=>vl,snapColorsToPalette:()=>Al});
var ml={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,
versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,
disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};
function As(t=256){let e=0,n=new Uint8Array(t);return{get buffer(){return n.buffer},reset(){e=0},bytesView(){return n.subarray(0,e)},bytes(){return n.slice(0,e)},
writeByte(o){r(e+1),n[e]=o,e++},writeBytes(o,s=0,a=o.length){r(e+a);for(let i=0;i<a;i++)n[e++]=o[i+s]},writeBytesView(o,s=0,a=o.byteLength){r(e+a),n.set(o.subarray(
s,s+a),e),e+=a}};function r(o){var s=n.length;if(s>=o)return;var a=1024*1024;o=Math.max(o,s*(s<a?2:1.125)>>>0),s!=0&&(o=Math.max(o,256));let i=n;n=new Uint8Array(
o),e>0&&n.set(i.subarray(0,e),0)}}var Jn=12,ws=5003,hl=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function fl(t,e,n,r,o=As(512),s=new Uint8Array(
256),a=new Int32Array(ws),i=new Int32Array(ws)){let l=a.length,u=Math.max(2,r);s.fill(0),i.fill(0),a.fill(-1);let c=0,d=0,m=u+1,h=m,g=!1,f=h,y=(1<<f)-1,b=1<<m-1,
S=b+1,v=b+2,w=0,A=n[0],T=0;for(let x=l;x<65536;x*=2)++T;T=8-T,o.writeByte(u),C(b);let E=n.length;for(let x=1;x<E;x++)e:{let P=n[x],$=(P<<Jn)+A,k=P<<T^A;if(a[k]===
$){A=i[k];break e}let X=k===0?1:l-k;for(;a[k]>=0;)if(k-=X,k<0&&(k+=l),a[k]===$){A=i[k];break e}C(A),A=P,v<1<<Jn?(i[k]=v++,a[k]=$):(a.fill(-1),v=b+2,g=!0,C(b))}return C(
A),C(S),o.writeByte(0),o.bytesView();function C(x){for(c&=hl[d],d>0?c|=x<<d:c=x,d+=f;d>=8;)s[w++]=c&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),c>>=
8,d-=8;if((v>y||g)&&(g?(f=h,y=(1<<f)-1,g=!1):(++f,y=f===Jn?1<<f:(1<<f)-1)),x==S){for(;d>0;)s[w++]=c&255,w>=254&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0),c>>=
8,d-=8;w>0&&(o.writeByte(w),o.writeBytesView(s,0,w),w=0)}}}var gl=fl;function Es(t,e,n){return t<<8&63488|e<<2&992|n>>3}function Cs(t,e,n,r){return t>>4|e&240|(n&
240)<<4|(r&240)<<8}function Ts(t,e,n){return t>>4<<8|e&240|n>>4}function Qt(t,e,n){return t<e?e:t>n?n:t}function vt(t){return t*t}function xs(t,e,n){var r=0,o=1e100;
let s=t[e],a=s.cnt,i=s.ac,l=s.rc,u=s.gc,c=s.bc;for(var d=s.fw;d!=0;d=t[d].fw){let h=t[d],g=h.cnt,f=a*g/(a+g);if(!(f>=o)){var m=0;n&&(m+=f*vt(h.ac-i),m>=o)||(m+=
f*vt(h.rc-l),!(m>=o)&&(m+=f*vt(h.gc-u),!(m>=o)&&(m+=f*vt(h.bc-c),!(m>=o)&&(o=m,r=d))))}}s.err=o,s.nn=r}function Xn(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,
bk:0,tm:0,mtm:0,err:0}}function yl(t,e){let n=e==="rgb444"?4096:65536,r=new Array(n),o=t.length;if(e==="rgba4444")for(let s=0;s<o;++s){let a=t[s],i=a>>24&255,l=a>>
16&255,u=a>>8&255,c=a&255,d=Cs(c,u,l,i),m=d in r?r[d]:r[d]=Xn();m.rc+=c,m.gc+=u,m.bc+=l,m.ac+=i,m.cnt++}else if(e==="rgb444")for(let s=0;s<o;++s){let a=t[s],i=a>>
16&255,l=a>>8&255,u=a&255,c=Ts(u,l,i),d=c in r?r[c]:r[c]=Xn();d.rc+=u,d.gc+=l,d.bc+=i,d.cnt++}else for(let s=0;s<o;++s){let a=t[s],i=a>>16&255,l=a>>8&255,u=a&255,
c=Es(u,l,i),d=c in r?r[c]:r[c]=Xn();d.rc+=u,d.gc+=l,d.bc+=i,d.cnt++}return r}function vl(t,e,n={}){let{format:r="rgb565",clearAlpha:o=!0,clearAlphaColor:s=0,clearAlphaThreshold:a=0,
oneBitAlpha:i=!1}=n;if(!t||!t.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))
throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(t.buffer),u=n.useSqrt!==!1,c=r==="rgba4444",d=yl(l,r),m=d.length,h=m-1,g=new Uint32Array(
m+1);for(var f=0,b=0;b<m;++b){let L=d[b];if(L!=null){var y=1/L.cnt;c&&(L.ac*=y),L.rc*=y,L.gc*=y,L.bc*=y,d[f++]=L}}vt(e)/f<.022&&(u=!1);for(var b=0;b<f-1;++b)d[b].
fw=b+1,d[b+1].bk=b,u&&(d[b].cnt=Math.sqrt(d[b].cnt));u&&(d[b].cnt=Math.sqrt(d[b].cnt));var S,v,w;for(b=0;b<f;++b){xs(d,b,!1);var A=d[b].err;for(v=++g[0];v>1&&(w=
v>>1,!(d[S=g[w]].err<=A));v=w)g[v]=S;g[v]=b}var T=f-e;for(b=0;b<T;){for(var E;;){var C=g[1];if(E=d[C],E.tm>=E.mtm&&d[E.nn].mtm<=E.tm)break;E.mtm==h?C=g[1]=g[g[0]--]:
(xs(d,C,!1),E.tm=b);var A=d[C].err;for(v=1;(w=v+v)<=g[0]&&(w<g[0]&&d[g[w]].err>d[g[w+1]].err&&w++,!(A<=d[S=g[w]].err));v=w)g[v]=S;g[v]=C}var x=d[E.nn],P=E.cnt,$=x.
cnt,y=1/(P+$);c&&(E.ac=y*(P*E.ac+$*x.ac)),E.rc=y*(P*E.rc+$*x.rc),E.gc=y*(P*E.gc+$*x.gc),E.bc=y*(P*E.bc+$*x.bc),E.cnt+=x.cnt,E.mtm=++b,d[x.bk].fw=x.fw,d[x.fw].bk=
x.bk,x.mtm=h}let k=[];var X=0;for(b=0;;++X){let H=Qt(Math.round(d[b].rc),0,255),L=Qt(Math.round(d[b].gc),0,255),U=Qt(Math.round(d[b].bc),0,255),_=255;c&&(_=Qt(Math.
round(d[b].ac),0,255),i&&(_=_<=(typeof i=="number"?i:127)?0:255),o&&_<=a&&(H=L=U=s,_=0));let W=c?[H,L,U,_]:[H,L,U];if(bl(k,W)||k.push(W),(b=d[b].fw)==0)break}return k}
function bl(t,e){for(let n=0;n<t.length;n++){let r=t[n],o=r[0]===e[0]&&r[1]===e[1]&&r[2]===e[2],s=r.length>=4&&e.length>=4?r[3]===e[3]:!0;if(o&&s)return!0}return!1}
function tn(t,e){var n=0,r;for(r=0;r<t.length;r++){let o=t[r]-e[r];n+=o*o}return n}function en(t,e){return e>1?Math.round(t/e)*e:t}function wl(t,{roundRGB:e=5,roundAlpha:n=10,
oneBitAlpha:r=null}={}){let o=new Uint32Array(t.buffer);for(let s=0;s<o.length;s++){let a=o[s],i=a>>24&255,l=a>>16&255,u=a>>8&255,c=a&255;i=en(i,n),r&&(i=i<=(typeof r==
"number"?r:127)?0:255),c=en(c,e),u=en(u,e),l=en(l,e),o[s]=i<<24|l<<16|u<<8|c<<0}}function xl(t,e,n="rgb565"){if(!t||!t.buffer)throw new Error("quantize() expect\
ed RGBA Uint8Array data");if(!(t instanceof Uint8Array)&&!(t instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>
256)throw new Error("applyPalette() only works with 256 colors or less");let r=new Uint32Array(t.buffer),o=r.length,s=n==="rgb444"?4096:65536,a=new Uint8Array(o),
i=new Array(s),l=n==="rgba4444";if(n==="rgba4444")for(let u=0;u<o;u++){let c=r[u],d=c>>24&255,m=c>>16&255,h=c>>8&255,g=c&255,f=Cs(g,h,m,d),y=f in i?i[f]:i[f]=Sl(
g,h,m,d,e);a[u]=y}else{let u=n==="rgb444"?Ts:Es;for(let c=0;c<o;c++){let d=r[c],m=d>>16&255,h=d>>8&255,g=d&255,f=u(g,h,m),y=f in i?i[f]:i[f]=Ml(g,h,m,e);a[c]=y}}
return a}function Sl(t,e,n,r,o){let s=0,a=1e100;for(let i=0;i<o.length;i++){let l=o[i],u=l[3],c=$e(u-r);if(c>a)continue;let d=l[0];if(c+=$e(d-t),c>a)continue;let m=l[1];
if(c+=$e(m-e),c>a)continue;let h=l[2];c+=$e(h-n),!(c>a)&&(a=c,s=i)}return s}function Ml(t,e,n,r){let o=0,s=1e100;for(let a=0;a<r.length;a++){let i=r[a],l=i[0],u=$e(
l-t);if(u>s)continue;let c=i[1];if(u+=$e(c-e),u>s)continue;let d=i[2];u+=$e(d-n),!(u>s)&&(s=u,o=a)}return o}function Al(t,e,n=5){if(!t.length||!e.length)return;
let r=t.map(a=>a.slice(0,3)),o=n*n,s=t[0].length;for(let a=0;a<e.length;a++){let i=e[a];i.length<s?i=[i[0],i[1],i[2],255]:i.length>s?i=i.slice(0,3):i=i.slice();
let l=Rs(r,i.slice(0,3),tn),u=l[0],c=l[1];c>0&&c<=o&&(t[u]=i)}}function $e(t){return t*t}function ks(t,e,n=tn){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],
i=n(e,a);i<r&&(r=i,o=s)}return o}function Rs(t,e,n=tn){let r=1/0,o=-1;for(let s=0;s<t.length;s++){let a=t[s],i=n(e,a);i<r&&(r=i,o=s)}return[o,r]}function El(t,e,n=tn){
return t[ks(t,e,n)]}function $s(t={}){let{initialCapacity:e=4096,auto:n=!0}=t,r=As(e),o=5003,s=new Uint8Array(256),a=new Int32Array(o),i=new Int32Array(o),l=!1;
return{reset(){r.reset(),l=!1},finish(){r.writeByte(ml.trailer)},bytes(){return r.bytes()},bytesView(){return r.bytesView()},get buffer(){return r.buffer},get stream(){
return r},writeHeader:u,writeFrame(c,d,m,h={}){let{transparent:g=!1,transparentIndex:f=0,delay:y=0,palette:b=null,repeat:S=0,colorDepth:v=8,dispose:w=-1}=h,A=!1;
if(n?l||(A=!0,u(),l=!0):A=!!h.first,d=Math.max(0,Math.floor(d)),m=Math.max(0,Math.floor(m)),A){if(!b)throw new Error("First frame must include a { palette } opt\
ion");Tl(r,d,m,b,v),Ss(r,b),S>=0&&kl(r,S)}let T=Math.round(y/10);Cl(r,w,T,g,f);let E=!!b&&!A;Rl(r,d,m,E?b:null),E&&Ss(r,b),$l(r,c,d,m,v,s,a,i)}};function u(){_s(
r,"GIF89a")}}function Cl(t,e,n,r,o){t.writeByte(33),t.writeByte(249),t.writeByte(4),o<0&&(o=0,r=!1);var s,a;r?(s=1,a=2):(s=0,a=0),e>=0&&(a=e&7),a<<=2,t.writeByte(
0|a|0|s),Se(t,n),t.writeByte(o||0),t.writeByte(0)}function Tl(t,e,n,r,o=8){let i=Qn(r.length)-1,l=128|o-1<<4|0|i,u=0,c=0;Se(t,e),Se(t,n),t.writeBytes([l,u,c])}function kl(t,e){
t.writeByte(33),t.writeByte(255),t.writeByte(11),_s(t,"NETSCAPE2.0"),t.writeByte(3),t.writeByte(1),Se(t,e),t.writeByte(0)}function Ss(t,e){let n=1<<Qn(e.length);
for(let r=0;r<n;r++){let o=[0,0,0];r<e.length&&(o=e[r]),t.writeByte(o[0]),t.writeByte(o[1]),t.writeByte(o[2])}}function Rl(t,e,n,r){if(t.writeByte(44),Se(t,0),Se(
t,0),Se(t,e),Se(t,n),r){let a=Qn(r.length)-1;t.writeByte(128|a)}else t.writeByte(0)}function $l(t,e,n,r,o=8,s,a,i){gl(n,r,e,o,t,s,a,i)}function Se(t,e){t.writeByte(
e&255),t.writeByte(e>>8&255)}function _s(t,e){for(var n=0;n<e.length;n++)t.writeByte(e.charCodeAt(n))}function Qn(t){return Math.max(Math.ceil(Math.log2(t)),1)}
var _l=$s});var ir={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Qe={DISAPPEAR:0,REACH:1,BOUNCE:2},lr={OCCUPATION:0,SURROUND:1},cr={FAULT:0,INVOLVED:1};var un=["obstacle","teammate","adversary"],dn=["vertex","edge","chain"],ur=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],pn=["p\
ursuer_{number}","evader_{number}"],dr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},et={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},pr="{event}: {outcome}",mn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},mr={free:".GS",blocked:"#@OTW"};var Ie=1+ur.length;function tt(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function G(t,e){return t<e?tt(pn[0],{number:t}):tt(pn[1],{number:t-e})}function ua(t,e){
let[n,r,o,s,a,i,l,...u]=Array.from(t),c=a<0?[s]:[s,a],[d,m,h]=u.map(b=>c.filter((S,v)=>b>>v&1)),g=c.map(b=>G(b,e)),f=tt(dr[a<0?"obstacle":dn[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=tt(pr,{event:f,outcome:da(c.length,m,h,e)});return{kind:un[r],form:dn[o],agents:c,cell:[i,l],at_fault:d,held:m,doomed:h,turn:n,
text:y}}function da(t,e,n,r){if(t===2&&e.length===2)return et["both held"];if(t===2&&n.length===2)return et["both doomed"];let o=s=>a=>tt(et[s],{agent:G(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||et.none}function xt(t,e){let n=[];for(let r=0;r<t.length;r+=Ie)n.push(ua(t.subarray(r+1,r+Ie),e));
return n}var ye=class extends Error{name="EngineError"};function D(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new ye(
`${t}: expected ${e}, got ${r}`)}var Ne=class{bytes;constructor(e){this.bytes=e}},gr=0,fn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],hr=4,fr=4,pa=new TextEncoder,
ma=new TextDecoder;function ha(t){for(let e=fn.length-1;e>gr;--e)if(t instanceof fn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function hn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function fa(t){return pa.encode(`${t}\0`)}var gn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new ye("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(fa(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Ne,l=i?a.bytes:
a;return[this.text(s),i?gr:ha(l),l.length,this.copy(hn(l))]}),o=this.copy(hn(Int32Array.from(r)));return this.copy(hn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function yr(t,e){let n=t.HEAPU8;return ma.decode(n.subarray(e,n.indexOf(0,e)))}function St(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/hr,r=e[n+1]/hr,o={};for(let s=r;s<r+e[n]*fr;s+=fr){let a=fn[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[yr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function nt(t,e){let n=new gn(t);try{let r=e(n);if(r===0)throw new ye(yr(t,t._last_error()));return r}finally{n.free()}}var ga=2**31-1,ya=2n**64n-1n,va=34028234663852886e22;function me(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ga)throw D(t,"an integer",e);return Int32Array.
of(e)}function Mt(t,e){if(typeof e!="boolean")throw D(t,"true or false",e);return new Ne(Uint8Array.of(Number(e)))}function Me(t,e,n){let r=typeof e=="string"&&
Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw D(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function yn(t,e){if(typeof e!="number"||
!(Math.abs(e)<=va))throw D(t,"a finite number",e);return e}function Be(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(r<0n||r>ya)throw D(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function ba(t){return{"rules.interaction":Me("interaction",t.interaction,
ir),"rules.obstacle":Me("obstacle",t.obstacle,Qe),"rules.teammate":Me("teammate",t.teammate,Qe),"rules.evader":Me("evader",t.evader,Qe),"rules.pursuer":Me("purs\
uer",t.pursuer,Qe),"rules.capture":Me("capture",t.capture,lr),"rules.captured_disappear":Mt("captured_disappear",t.captured_disappear)}}function vr(t,e){let n=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw D(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>yn(t,r))}function wa(t){let e=(n,r)=>Float32Array.
of(yn(n,t[n]),yn(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":vr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":vr("evader_collide",t.evader_collide),
"rewards.blame":Me("blame",t.blame,cr),"rewards.capture_repeats":Mt("capture_repeats",t.capture_repeats)}}function wr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=mr;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw D(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw D(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function xr(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw D("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function At(t){xr(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...ba(t.rules),...wa(t.rewards),rows:me("rows",t.rows),cols:me("cols",t.cols),n_pursuers:me("n_pursuers",t.n_pursuers),n_evaders:me("n_evaders",t.n_evaders),fov:me(
"fov",t.fov),diagonal:Mt("diagonal",t.diagonal),max_steps:me("max_steps",t.max_steps),density:Float64Array.of(e),map:wr(t.obstacles)}}function br(t,e){return Int32Array.
from((e??[]).flat(),n=>me(t,n)[0])}function Sr(t,e){return xr(t.obstacles,e),{seed:Be("seed",t.seed??0n),episode:Be("episode",t.episode??0),pursuers:br("pursuer\
s",t.pursuers),evaders:br("evaders",t.evaders),map:wr(t.obstacles)}}function Et(t){return{actions:Int32Array.from(t,e=>me("actions",e)[0])}}function Ue(t){if(typeof t==
"string"){if(!Object.hasOwn(mn,t))throw D("policy",`one of ${Object.keys(mn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw D("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>me("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:Mt("sampled",t.sampled),genome:t.genome}}var xa=["first_turn","terminated","truncated"];function Mr(t){let e={...t};for(let n of xa)
e[n]=new Ne(t[n]);return e}var Ct=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,n,r,o){this.config=e,this.seed=n,this.episode=r,this.n_agents=e.n_pursuers+e.n_evaders,
this.statistics=Ar(o,0),Object.assign(this,o),this.first_conflict=Sa(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(e){
this.check(e);let[n,r]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(n*Ie,r*Ie);return xt(o,this.config.n_pursuers)}seek(e,n){
this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.episode});for(let o=e.steps;o<
n;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw D("step",`0 to ${this.length}`,
e)}};function Sa(t,e){let n=new Int32Array(e+2);for(let r=0;r<t.length;r+=Ie)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Ar(t,e){let n=t["\
statistics.length"].length,r=s=>{let a=t[`statistics.${s}`],i=a.length/n;return a.slice(e*i,(e+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),overlap:r("over\
lap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function Er(t,e,n,r){let o=[At(n.config),Ue(n.pursuers),Ue(n.evaders),r];return nt(
t,s=>{let[a,i,l,u]=o.map(c=>s.arrays(c));return t[e](a,i,l,u)}),St(t)}function Cr(t,e,n,r){let o={seed:Be("seed",n),episode:Be("episode",r)};return new Ct(e.config,
n,r,Er(t,"_play_match",e,o))}function Tr(t,e,n,r){if(!Number.isInteger(r)||r<1)throw D("n_episodes","at least 1",r);let o={seed:Be("seed",n),n_episodes:Int32Array.
of(r)},s=Er(t,"_play_rollout",e,o);return Array.from({length:r},(a,i)=>Ar(s,i))}var kr=new FinalizationRegistry(([t,e])=>t._world_free(e)),rt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=nt(e,r=>e._world_new(r.arrays(At(n)))),kr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,kr.unregister(this),this.engine._world_free(this.at))}reset(e={}){let n=Sr(e,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(e){let n=Et(e);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(e){let n=Et(e);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw D(
"actions",String(this.n_agents),r.length);let l=[Ue(e),Et(r)],{actions:u}=this.call(c=>this.engine._world_decide(this.at,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.
from(u)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.at,n.
text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return xt(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,n){
let r=Ue(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,
probabilities:Ma(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let n=Mr(e);this.call(r=>this.engine._world_restore(
this.at,r.arrays(n)))}call(e){if(this.freed)throw D("world","one that is in use","one that was freed");return nt(this.engine,e),St(this.engine)}};function Ma(t){
let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var vn=class{compiled;constructor(e){this.compiled=e}world(e){return new rt(this.compiled,e)}match(e,n,r,o,s=0){return Cr(this.compiled,{config:e,pursuers:n,evaders:r},
o,s)}rollout(e,n,r,o,s){return Tr(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Rr;function $r(t=globalThis.matrixworldEngine){return Rr??=Aa(t),Rr}async function Aa(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new vn(
await t({wasmBinary:e}))}var Ea="http://www.w3.org/2000/svg";function p(t,e={},...n){return _r(document.createElement(t),e,n)}function M(t,e={},...n){return _r(document.createElementNS(
Ea,t),e,n)}function _r(t,e,n){for(let[r,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(r.slice(2),o):t.setAttribute(r,o===!0?"":
String(o)));return t.append(...n.filter(Ca).map(r=>typeof r=="number"?String(r):r)),t}function Ca(t){return t!=null&&t!==!1}var ot=()=>["file:","http:","https:"].
includes(location.protocol);async function Pr(t,e){t.select();try{await navigator.clipboard.writeText(t.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}var Ta=matchMedia("(prefers-color-scheme: dark)");function ka(){let t=document.documentElement.dataset.theme;return t?t==="dark":Ta.matches}function bn(){document.
documentElement.dataset.theme=ka()?"light":"dark"}function Lr(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:bn},
"◐")}var Ra=2n**64n-1n;function st(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(u,c,d)=>{let m=r.get(u)??"";return/^\d{1,9}$/.test(m)&&Number(m)<c?Number(
m):d},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ra?l:null,step:o("step",1/0,0)}}function Or(t,e,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:u}=e.selected,c={run:s,pursuers:a,evaders:i,episode:l,...u===null?{}:{seed:u},step:n.player.step};r=`#${Object.entries(c).
map(([d,m])=>`${d}=${m}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};e.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=st(location.hash,
t,e.selected);e.select(a),n.goTo(s)})}var N=Uint8Array,Y=Uint16Array,kn=Int32Array,kt=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Rt=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Mn=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Dr=function(t,e){for(var n=new Y(31),r=0;r<31;++r)n[r]=e+=
1<<t[r-1];for(var o=new kn(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},Fr=Dr(kt,2),Hr=Fr.b,An=Fr.r;Hr[28]=258,An[258]=28;var Wr=Dr(
Rt,0),$a=Wr.b,Ir=Wr.r,En=new Y(32768);for(R=0;R<32768;++R)he=(R&43690)>>1|(R&21845)<<1,he=(he&52428)>>2|(he&13107)<<2,he=(he&61680)>>4|(he&3855)<<4,En[R]=((he&65280)>>
8|(he&255)<<8)>>1;var he,R,le=(function(t,e,n){for(var r=t.length,o=0,s=new Y(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new Y(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new Y(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var u=o<<4|t[o],c=e-t[o],d=a[t[o]-1]++<<c,m=d|(1<<c)-1;d<=m;++d)i[En[d]>>l]=u}else for(i=new Y(
r),o=0;o<r;++o)t[o]&&(i[o]=En[a[t[o]-1]++]>>15-t[o]);return i}),ve=new N(288);for(R=0;R<144;++R)ve[R]=8;var R;for(R=144;R<256;++R)ve[R]=9;var R;for(R=256;R<280;++R)
ve[R]=7;var R;for(R=280;R<288;++R)ve[R]=8;var R,lt=new N(32);for(R=0;R<32;++R)lt[R]=5;var R,_a=le(ve,9,0),Pa=le(ve,9,1),La=le(lt,5,0),Oa=le(lt,5,1),wn=function(t){
for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},oe=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},xn=function(t,e){var n=e/8|0;return(t[n]|
t[n+1]<<8|t[n+2]<<16)>>(e&7)},Rn=function(t){return(t+7)/8|0},$n=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),new N(t.subarray(
e,n))};var Ia=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],V=function(t,e,n){var r=new Error(e||Ia[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,V),!n)throw r;return r},Na=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new N(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new N(o*3));var u=function(Je){var Xe=n.length;if(Je>Xe){var Oe=new N(Math.max(Xe*2,Je));Oe.set(n),n=Oe}},c=e.f||0,d=e.
p||0,m=e.b||0,h=e.l,g=e.d,f=e.m,y=e.n,b=o*8;do{if(!h){c=oe(t,d,1);var S=oe(t,d+1,3);if(d+=3,S)if(S==1)h=Pa,g=Oa,f=9,y=5;else if(S==2){var T=oe(t,d,31)+257,E=oe(
t,d+10,15)+4,C=T+oe(t,d+5,31)+1;d+=14;for(var x=new N(C),P=new N(19),$=0;$<E;++$)P[Mn[$]]=oe(t,d+$*3,7);d+=E*3;for(var k=wn(P),X=(1<<k)-1,H=le(P,k,1),$=0;$<C;){
var L=H[oe(t,d,X)];d+=L&15;var v=L>>4;if(v<16)x[$++]=v;else{var U=0,_=0;for(v==16?(_=3+oe(t,d,3),d+=2,U=x[$-1]):v==17?(_=3+oe(t,d,7),d+=3):v==18&&(_=11+oe(t,d,127),
d+=7);_--;)x[$++]=U}}var W=x.subarray(0,T),z=x.subarray(T);f=wn(W),y=wn(z),h=le(W,f,1),g=le(z,y,1)}else V(1);else{var v=Rn(d)+4,w=t[v-4]|t[v-3]<<8,A=v+w;if(A>o){
l&&V(0);break}i&&u(m+w),n.set(t.subarray(v,A),m),e.b=m+=w,e.p=d=A*8,e.f=c;continue}if(d>b){l&&V(0);break}}i&&u(m+131072);for(var _e=(1<<f)-1,Q=(1<<y)-1,pe=d;;pe=
d){var U=h[xn(t,d)&_e],q=U>>4;if(d+=U&15,d>b){l&&V(0);break}if(U||V(2),q<256)n[m++]=q;else if(q==256){pe=d,h=null;break}else{var K=q-254;if(q>264){var $=q-257,I=kt[$];
K=oe(t,d,(1<<I)-1)+Hr[$],d+=I}var ie=g[xn(t,d)&Q],Pe=ie>>4;ie||V(3),d+=ie&15;var z=$a[Pe];if(Pe>3){var I=Rt[Pe];z+=xn(t,d)&(1<<I)-1,d+=I}if(d>b){l&&V(0);break}i&&
u(m+131072);var Le=m+K;if(m<z){var bt=s-z,wt=Math.min(z,Le);for(bt+m<0&&V(3);m<wt;++m)n[m]=r[bt+m]}for(;m<Le;++m)n[m]=n[m-z]}}e.l=h,e.p=pe,e.b=m,e.f=c,h&&(c=1,e.
m=f,e.d=g,e.n=y)}while(!c);return m!=n.length&&a?$n(n,0,m):n.subarray(0,m)},fe=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},at=function(t,e,n){n<<=
e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},Sn=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:Gr,l:0};if(o==1){var a=new N(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(A,T){return A.f-T.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],u=0,
c=1,d=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};c!=o-1;)i=n[n[u].f<n[d].f?u++:d++],l=n[u!=c&&n[u].f<n[d].f?u++:d++],n[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,r=1;r<
o;++r)s[r].s>m&&(m=s[r].s);var h=new Y(m+1),g=Cn(n[c-1],h,0);if(g>e){var r=0,f=0,y=g-e,b=1<<y;for(s.sort(function(T,E){return h[E.s]-h[T.s]||T.f-E.f});r<o;++r){
var S=s[r].s;if(h[S]>e)f+=b-(1<<g-h[S]),h[S]=e;else break}for(f>>=y;f>0;){var v=s[r].s;h[v]<e?f-=1<<e-h[v]++-1:++r}for(;r>=0&&f;--r){var w=s[r].s;h[w]==e&&(--h[w],
++f)}g=e}return{t:new N(h),l:g}},Cn=function(t,e,n){return t.s==-1?Math.max(Cn(t.l,e,n+1),Cn(t.r,e,n+1)):e[t.s]=n},Nr=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new Y(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},it=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},jr=function(t,e,n){var r=n.length,o=Rn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},Br=function(t,e,n,r,o,s,a,i,l,u,c){fe(e,c++,n),++o[256];for(var d=Sn(o,15),m=d.t,h=d.l,g=Sn(s,15),f=g.t,y=g.l,b=Nr(m),S=b.c,
v=b.n,w=Nr(f),A=w.c,T=w.n,E=new Y(19),C=0;C<S.length;++C)++E[S[C]&31];for(var C=0;C<A.length;++C)++E[A[C]&31];for(var x=Sn(E,7),P=x.t,$=x.l,k=19;k>4&&!P[Mn[k-1]];--k)
;var X=u+5<<3,H=it(o,ve)+it(s,lt)+a,L=it(o,m)+it(s,f)+a+14+3*k+it(E,P)+2*E[16]+3*E[17]+7*E[18];if(l>=0&&X<=H&&X<=L)return jr(e,c,t.subarray(l,l+u));var U,_,W,z;
if(fe(e,c,1+(L<H)),c+=2,L<H){U=le(m,h,0),_=m,W=le(f,y,0),z=f;var _e=le(P,$,0);fe(e,c,v-257),fe(e,c+5,T-1),fe(e,c+10,k-4),c+=14;for(var C=0;C<k;++C)fe(e,c+3*C,P[Mn[C]]);
c+=3*k;for(var Q=[S,A],pe=0;pe<2;++pe)for(var q=Q[pe],C=0;C<q.length;++C){var K=q[C]&31;fe(e,c,_e[K]),c+=P[K],K>15&&(fe(e,c,q[C]>>5&127),c+=q[C]>>12)}}else U=_a,
_=ve,W=La,z=lt;for(var C=0;C<i;++C){var I=r[C];if(I>255){var K=I>>18&31;at(e,c,U[K+257]),c+=_[K+257],K>7&&(fe(e,c,I>>23&31),c+=kt[K]);var ie=I&31;at(e,c,W[ie]),
c+=z[ie],ie>3&&(at(e,c,I>>5&8191),c+=Rt[ie])}else at(e,c,U[I]),c+=_[I]}return at(e,c,U[256]),c+_[256]},Ba=new kn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Gr=new N(0),Ua=function(t,e,n,r,o,s){var a=s.z||t.length,i=new N(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),u=s.l,c=(s.r||0)&7;if(e){
c&&(l[0]=s.r>>3);for(var d=Ba[e-1],m=d>>13,h=d&8191,g=(1<<n)-1,f=s.p||new Y(32768),y=s.h||new Y(g+1),b=Math.ceil(n/3),S=2*b,v=function(cn){return(t[cn]^t[cn+1]<<
b^t[cn+2]<<S)&g},w=new kn(25e3),A=new Y(288),T=new Y(32),E=0,C=0,x=s.i||0,P=0,$=s.w||0,k=0;x+2<a;++x){var X=v(x),H=x&32767,L=y[X];if(f[H]=L,y[X]=H,$<=x){var U=a-
x;if((E>7e3||P>24576)&&(U>423||!u)){c=Br(t,l,0,w,A,T,C,P,k,x-k,c),P=E=C=0,k=x;for(var _=0;_<286;++_)A[_]=0;for(var _=0;_<30;++_)T[_]=0}var W=2,z=0,_e=h,Q=H-L&32767;
if(U>2&&X==v(x-Q))for(var pe=Math.min(m,U)-1,q=Math.min(32767,x),K=Math.min(258,U);Q<=q&&--_e&&H!=L;){if(t[x+W]==t[x+W-Q]){for(var I=0;I<K&&t[x+I]==t[x+I-Q];++I)
;if(I>W){if(W=I,z=Q,I>pe)break;for(var ie=Math.min(Q,I-2),Pe=0,_=0;_<ie;++_){var Le=x-Q+_&32767,bt=f[Le],wt=Le-bt&32767;wt>Pe&&(Pe=wt,L=Le)}}}H=L,L=f[H],Q+=H-L&
32767}if(z){w[P++]=268435456|An[W]<<18|Ir[z];var Je=An[W]&31,Xe=Ir[z]&31;C+=kt[Je]+Rt[Xe],++A[257+Je],++T[Xe],$=x+W,++E}else w[P++]=t[x],++A[t[x]]}}for(x=Math.max(
x,$);x<a;++x)w[P++]=t[x],++A[t[x]];c=Br(t,l,u,w,A,T,C,P,k,x-k,c),u||(s.r=c&7|l[c/8|0]<<3,c-=7,s.h=y,s.p=f,s.i=x,s.w=$)}else{for(var x=s.w||0;x<a+u;x+=65535){var Oe=x+
65535;Oe>=a&&(l[c/8|0]=u,Oe=a),c=jr(l,c+1,t.subarray(x,Oe))}s.i=a}return $n(i,0,r+Rn(c)+o)},za=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var n=e,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),Da=function(){var t=-1;return{p:function(e){for(var n=t,r=0;r<e.length;++r)n=za[n&255^e[r]]^n>>>8;t=n},d:function(){
return~t}}};var Fa=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ua(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},Vr=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var j=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var Ha=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&V(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&V(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Wa(t,e){return Fa(t,e||{},0,0)}function qr(t,e){return Na(t.subarray(Ha(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Kr=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=Vr(r,s[1]),s=s[0]),s instanceof N?n[a]=[s,i]:(n[a+="/"]=[new N(0),i],Kr(s,a,n,
r))}},Ur=typeof TextEncoder<"u"&&new TextEncoder,ja=typeof TextDecoder<"u"&&new TextDecoder,Ga=0;try{ja.decode(Gr,{stream:!0}),Ga=1}catch{}function Tt(t,e){if(e){for(var n=new N(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(Ur)return Ur.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},r=0;r<o;++r){if(a+5>s.length){var l=new N(a+8+(o-r<<1));l.set(s),s=l}var u=t.charCodeAt(r);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|t.charCodeAt(++r)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return $n(s,0,a)}var Tn=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&V(9),e+=r+4}return e},zr=function(t,e,n,r,o,s,a,i){var l=r.length,u=n.extra,c=i&&i.length,
d=Tn(u);j(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var m=new Date(n.mtime==null?Date.now():n.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&V(10),j(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(j(t,e,n.crc),j(t,e+4,s<0?-s-2:s),j(t,e+8,n.size)),j(t,e+12,l),j(t,e+14,d),e+=16,a!=null&&(j(t,e,
c),j(t,e+6,n.attrs),j(t,e+10,a),e+=14),t.set(r,e),e+=l,d)for(var g in u){var f=u[g],y=f.length;j(t,e,+g),j(t,e+2,y),t.set(f,e+4),e+=4+y}return c&&(t.set(i,e),e+=
c),e},Va=function(t,e,n,r,o){j(t,e,101010256),j(t,e+8,n),j(t,e+10,n),j(t,e+12,r),j(t,e+16,o)};function Yr(t,e){e||(e={});var n={},r=[];Kr(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],u=i[1],c=u.level==0?0:8,d=Tt(a),m=d.length,h=u.comment,g=h&&
Tt(h),f=g&&g.length,y=Tn(u.extra);m>65535&&V(11);var b=c?Wa(l,u):l,S=b.length,v=Da();v.p(l),r.push(Vr(u,{size:l.length,crc:v.d(),c:b,f:d,m:g,u:m!=a.length||g&&h.
length!=f,o,compression:c})),o+=30+m+y+S,s+=76+2*(m+y)+(f||0)+S}for(var w=new N(s+22),A=o,T=s-o,E=0;E<r.length;++E){var d=r[E];zr(w,d.o,d,d.f,d.u,d.c.length);var C=30+
d.f.length+Tn(d.extra);w.set(d.c,d.o+C),zr(w,o,d,d.f,d.u,d.c.length,d.o,d.m),o+=16+C+(d.m?d.m.length:0)}return Va(w,o,r.length,T,A),w}var ce=["pursuer","evader"];function Jr(){return JSON.parse($t("data"))}function ze(t,e,n){let[r,o]=[e-t.payoff.first[0],n-t.payoff.first[1]],s=t.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r][o]}}function Ae(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.
teams[e];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${e}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return Xr(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function ee(t,e,n){let{script:r,network:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,u=Xr(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:u}}var _n=4,Zr=new Map;function Xr(t,e){let n=Zr.get(t);if(n)return n;let r=new Float32Array;try{let o=Ka(
Pn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||qa(o)))throw o}return Zr.set(t,r),r}var qa=t=>t instanceof
Error&&"code"in t;function Ka(t,e){let n=qr(t),r=n.length/_n,o=new Uint8Array(n.length);for(let a=0;a<o.length;a++)o[a]=n[a%_n*r+Math.floor(a/_n)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function Pn(t){let e=atob($t(t)),n=new Uint8Array(e.length);for(let r=0;r<n.
length;r++)n[r]=e.charCodeAt(r);return n}function $t(t){return document.getElementById(t)?.textContent??""}var De=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Qr(t,e,n){let[r,o]=[e[0]-t[0],e[1]-t[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),De.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Ee=(t,e)=>e<t.nPursuers,O=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ya=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Ln=({rows:t,cols:e},[n,r])=>n>=0&&r>=0&&n<t&&r<e,On=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),In=(t,e)=>On(t.fault,e),eo=(t,e)=>!In(
t,e)&&On(t.involved,e,2);function _t(t,e,n){let r=!Ya(O(t,n),O(e,n)),o=e.involved===void 0||On(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!r&&o)}function Pt(t,e,n){
let[r,o]=O(t,n),[s,a]=De[e.actions?.[n]??0];return[r+s,o+a]}function ct(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var to=t=>t.moments.flatMap((e,n)=>n&&ct(t,t.moments[n-1],e).length?[n]:[]);function Lt(t,e){return Array.from({length:e.
alive.length},(r,o)=>o).filter(r=>t.alive[r]&&!e.alive[r])}var no=[-.31,0,.31],ro=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:no.flatMap(t=>no.map(e=>[e,t]))}],Za=.3,Ja=.35,Xa=.55;function ut(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=O(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function oo(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=O(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ut(t,e).values()){let o=ro[Math.min(r.length,ro.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=n[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return n}var so=t=>t*t*(3-2*t),Fe=(t,e,n)=>t+(e-t)*n,ao=t=>Math.min(1,Math.max(0,t));function io(t,e,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[t.interaction];if(o===1)return so(r);let s=o===n?e:+!Ee(t,e),a=Math.max(1/o,Ja);return so(ao((r-s/(o-1)*(1-a))/a))}function Ot(t,e){
let n=t.moments.length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=oo(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=oo(t,a);return s.map((l,u)=>{let c=io(
t,u,s.length,e-r);return Qa(o,a,u,l,i[u],c)})}function Nn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
r)]],i=io(t,e,s.alive.length,n-o),[[l,u],[c,d]]=[O(s,e),O(a,e)];return[Fe(u,d,i)+.5,Fe(l,c,i)+.5]}function Qa(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:Fe(r.x,o.x,
s),y:Fe(r.y,o.y,s),size:a?r.size:Fe(r.size,o.size,s),alpha:a?ao((1-s)/(1-Xa)):Fe(r.alpha,o.alpha,s)};if(_t(t,e,n)){let[l,u]=O(t,n),[c,d]=Pt(t,e,n),m=Za*Math.sin(
Math.PI*s);i.x+=(d-u)*m,i.y+=(c-l)*m}return i}var lo=2*Math.PI;function Ce(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,lo)}function It(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,c]=s[(l+1)%3];t.arcTo(a,i,u,c,r*.09)}),t.closePath()}function co(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function uo(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=lo*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function po(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var mo=4,ei=1.6,ti=.95,ni=5,ri=.16,oi=9,si=.09,ai=.2,ho=.75,te=(t,e)=>t.left+e*t.cell,ne=(t,e)=>t.top+e*t.cell;function He(t,e,n){return Ee(e,n)?t.colors.pursuer:
t.colors.evader}function fo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,[l,u]=[i*s,a*s];if(t.fillStyle=n.paper,t.fillRect(r,o,l,u),s<ni)return;
t.fillStyle=n.line;let c=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(r+d*s,o,c,u);for(let d=1;d<a;d++)t.fillRect(r,o+d*s,l,c)}function go({ctx:t,
grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let u=0;u<i*l;u++){if(!r.obstacles[u])continue;let[c,d]=[Math.floor(u/l),
u%l];t.fillRect(o+d*a,s+c*a,a,a)}yo({ctx:t,grid:e,colors:n})}function yo({ctx:t,grid:{left:e,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function vo({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,u=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*r+a/40;for(let d=0;d<l;d+=u)t.fillText(String(d),o+(d+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let d=0;d<i;d+=u)t.fillText(
String(d),o-c,s+(d+.5)*a)}function bo({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(t.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
t.rows,r+o)];return[te(t,s),ne(t,i),(a-s)*t.cell,(l-i)*t.cell]}function wo(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...bo(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),yo(t)}function xo({ctx:t,grid:e,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[te(e,r),ne(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,u-i/2,i,i,i*.2),t.strokeStyle=n.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let d=u-i/2<c*1.2,m=u+(d?1:-1)*(i/2+c*.7);t.strokeStyle=
n.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,m),t.fillStyle=n.ink,t.fillText("You",l,m),t.globalAlpha=1}function So(t,e,n,r,o){let{ctx:s,grid:a}=t,
i=bo(t,e,r,o),l=He(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Mo(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(oi,
Math.max(1,a.cell*ri));for(let u=Math.max(1,Math.floor(n-r)+1);u<=i;u++){let[c,d]=[e.moments[u-1],e.moments[u]],m=Math.max(0,Math.min(1,(n-u)/r));s.globalAlpha=
ho+(ai-ho)*m;for(let h=0;h<d.alive.length;h++){let g=u===i&&n<i;if(!c.alive[h]||!(l.alive[h]||g))continue;let f=(Ee(e,h)?-1:1)*si,[y,b]=O(c,h),[S,v]=O(d,h);if(y===
S&&b===v)continue;let w=g?o[h].x:v+.5,A=g?o[h].y:S+.5;s.strokeStyle=He(t,e,h),s.beginPath(),s.moveTo(te(a,b+.5+f),ne(a,y+.5+f)),s.lineTo(te(a,w+f),ne(a,A+f)),s.
stroke()}}s.globalAlpha=1}function Ao(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-mo+1);o<=r;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/mo,l=ct(e,s,a);for(let u of Lt(s,a))l.includes(u)||li(t,O(a,u),i);for(let u of l)ii(t,O(a,u),i)}t.ctx.globalAlpha=1}function ii({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,uo(t,te(e,o+.5),ne(e,r+.5),Math.max(8,e.cell*ei)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=
Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function li({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,co(t,te(e,o+.5),ne(e,r+.5),Math.max(7,e.cell*ti)),
t.strokeStyle=n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Eo({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);
t.strokeStyle=t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[te(e,i)+s,ne(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=
1}function Co({ctx:t,grid:e,colors:n},r,o,s,a){t.globalAlpha=a,Ce(t,te(e,r),ne(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var ci=.8,ui=.92,di=15,pi=7,Bn=9;function To(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&mi(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ut(e,n).values())a.length>
Bn&&hi(t,r[a[Bn-1]],a.length-Bn+1)}function mi(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:u}=t,c=Ee(e,r),[d,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(c?ui:ci)),g=He(t,e,r),f=!c&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(c?It:Ce)(i,d,m,h),h>pi*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?u.paper:g,i.fill(),f&&(Ce(i,d,m,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<di*a)return;let y=String(c?r:r-e.nPursuers);
i.font=`700 ${Math.round(h*(c?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:u.paper,i.fillText(
y,d,m+h*(c?.17:.03))}function hi({ctx:t,grid:e,colors:n},r,o){let[s,a]=[e.left+r.x*e.cell,e.top+r.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=n.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=n.ink,t.fillText(`+${o}`,
s,a)}var fi=.46,gi=.86,yi=.66,ko=.48,vi=.78,bi=.58;function Ro(t,e,n,r){let[o,s]=[e.moments[n-1],e.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let u=0;u<s.alive.length;u++)_t(o,s,u)&&wi(t,e,O(o,u),Pt(o,s,u));a.globalAlpha=
1}function wi({ctx:t,grid:e},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=d=>te(e,r[1]+.5+s*d),l=d=>ne(e,r[0]+.5+a*d),u=Ln(n,o)?vi:bi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(ko),l(ko)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(u)-a*c,l(u)+
s*c),t.lineTo(i(u)+a*c,l(u)-s*c),t.stroke()}function $o(t,e,n,r,o,s){let a=De[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=t,c=Ln(e,[r[0]+a[0],r[1]+a[1]])?gi:
yi,d=fi*o.size,m=[te(l,o.x+a[1]*d),ne(l,o.y+a[0]*d),te(l,o.x+a[1]*c),ne(l,o.y+a[0]*c)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[
u.paper,h*2.1],[He(t,e,n),h]])i.strokeStyle=g,i.lineWidth=f,po(i,...m,l.cell*.2),i.stroke()}var Nt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Bt(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),u=e.moments[l],c=n===l,d=Ot(e,n),m=c?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),fo(t);for(let f of r.
viewers)d[f]?.alpha&&So(t,e,f,...Nn(e,f,n));go(t,e),r.axes&&vo(t,o),Mo(t,e,n,r.trail,d),Eo(t,u.contested??[],m),Ao(t,e,n),Ro(t,e,l,m),d.forEach(({x:f,y,size:b},S)=>{
let v=eo(u,S)?.4:0,w=In(u,S)?1:v;w&&Co(t,f,y,b,w*m)});let h=c?u:e.moments[Math.max(0,l-1)];if(To(t,e,h,d,r.numbers,o),c&&r.plan)for(let[f,y]of d.entries())y.alpha&&
$o(t,e,f,O(u,f),y,r.plan[f]??0);r.you!==null&&(r.fog&&wo(t,e,...Nn(e,r.you,n)),xo(t,d[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===
null?void 0:d[r.selected];g?.alpha&&_o(t,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),_o(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function _o({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var dt=(t,e)=>(e+.24)/(t+.24);function Ut(t,e,n,r,o,s){let a=n?28*s:0,i=(u,c)=>(u-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Po(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var xi={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function We(t){let e=getComputedStyle(t),n=Object.entries(xi).map(([r,o])=>[r,e.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var se=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,be=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;#o;#c;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Nt,...n},this.#o=new ResizeObserver(()=>this.#u()),this.#o.observe(e),this.#c=new MutationObserver(
()=>this.redraw()),this.#c.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#o.disconnect(),this.#c.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#a)}get look(){
return this.#t}set look(e){this.#t={...this.#t,...e},this.#d(),this.redraw()}show(e,n){this.#e=e,this.#n=Math.min(Math.max(0,n),e.moments.length-1),this.#d(),this.
redraw()}redraw=()=>{this.#a||(this.#a=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#r=Ut(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,
colors:We(this.canvas)};Bt(s,this.#e,this.#n,this.#t,o)}cellAt(e,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Po(this.#r,(e-r.
left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=ut(this.#e,o).get(r[0]*this.#e.
cols+r[1])??[],a=Ot(this.#e,Math.round(this.#n)),i=l=>{let[u,c]=this.pointOf(a[l].x,a[l].y);return Math.hypot(u-e,c-n)};return s.length?s.reduce((l,u)=>i(u)<i(l)?
u:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+e*i)*o,r.top+(a+n*i)*
o]}#d(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(dt(e,n)))}#u(){let e=devicePixelRatio||1,{width:n,height:r}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var Si=12e3;function Lo(t,e,n){let r=()=>t[e.selected.run].findings?.guided_minute??[],o=p("p",{"aria-live":"polite"}),s=p("button",{type:"button",onclick:()=>d(
u-1,!1)},"Back"),a=p("button",{type:"button",onclick:()=>d(u+1,!1)}),i=p("section",{class:"guided card","aria-label":"A guided minute"},o,p("div",{},s,a,p("butt\
on",{type:"button",onclick:()=>m()},"Skip"))),l=p("button",{type:"button",class:"begin-minute",onclick:()=>d(0,!se())},"A guided minute"),[u,c]=[-1,0];function d(y,b){
clearTimeout(c);let S=r()[y];if(g(),!S)return m();u=y,o.replaceChildren(p("span",{class:"muted numbers"},`${y+1} of ${r().length} `),S.text),s.disabled=y===0,a.
textContent=y===r().length-1?"End":"Next",i.hidden=!1,e.select({pursuer:S.pursuer,evader:S.evader}),S.shows==="judgement"?document.querySelector(".diagnosis")?.
scrollIntoView({block:"nearest"}):S.shows==="checkerboard"?h():(n.reveal(),n.playSoon()),b&&(c=setTimeout(()=>d(y+1,!0),Si))}function m(){clearTimeout(c),u=-1,i.
hidden=!0,l.focus()}function h(){document.querySelector(".miniature")?.click();let y=document.querySelector("dialog.four[open]");y?.append(i),y?.addEventListener(
"close",()=>document.body.append(i),{once:!0})}let g=()=>document.querySelector("dialog.four[open]")?.close(),f=()=>{l.hidden=!r().length,i.hidden||m()};return e.
on("run",f),i.addEventListener("keydown",y=>{y.key==="Escape"&&m()}),i.hidden=!0,f(),{button:l,bar:i}}var pt=[.5,1,2,4,8,16,32,64],je=0,zt=12,Mi=2,we=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#o=!1;#c=null;#d=0;#u=[];glide=.28;constructor(e,n={}){super(),this.#e=
e,this.#n=n.speed??4,this.#t=n.still??!1}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){
return this.#o}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#l("state")}get marks(){return this.#u}set marks(e){this.#u=e,this.#l(
"state")}get pace(){return this.#n||Math.max(Mi,this.#e/zt)}get speed(){return this.#n}set speed(e){this.#n=e,this.#l("state")}changeSpeed(e){let n=pt.findIndex(
r=>r>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,n+e))]}play(){this.#o||!this.#e||(this.#r===this.#e&&this.jump(0),this.#o=!0,this.#l("state"),this.#i())}pause(){
this.#o&&(this.#o=!1,this.#l("state"))}toggle(){this.#o?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(n-this.#a)>
1?this.jump(n):this.#p(n),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#p(this.#a),this.#l("frame")}#p(e){e!==this.#r&&(this.#r=e,
this.#l("step"),this.#t&&this.#l("frame"))}#i(){this.#c===null&&(this.#d=performance.now(),this.#c=requestAnimationFrame(()=>this.#s()))}#s(){this.#c=null;let e=performance.
now();this.#m(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&this.#l("frame"),(this.#o||this.#a!==this.#r)&&(this.#c=requestAnimationFrame(()=>this.#s()))}#m(e){
let n=e;for(;n>0;){if(this.#a===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#p(this.#r+1)}let r=this.#o?this.pace:1/this.glide,o=this.#r-
this.#a,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#a=s===Math.abs(o)?this.#r:this.#a+Math.sign(o)*s}this.#o&&this.#a===this.#e&&this.pause()}#l(e){this.dispatchEvent(
new Event(e))}};function xe(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(n),ArrowLeft:()=>t.
move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var mt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ge(t){let e=Math.min(1,Math.max(0,t))*(mt.length-1),n=Math.min(mt.length-2,Math.floor(e)),[r,o]=[mt[n],
mt[n+1]],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Dt(t){let[e,n,r]=Ge(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+
.0722*r>.179?"#000":"#fff"}var Ft=t=>`rgb(${Ge(t).join(" ")})`,Oo=()=>`linear-gradient(to right, ${mt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Ht(t,e,n){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(n))t.style.setProperty(a,`${i}px`);t.width=Math.round(n.width*r),t.height=Math.round(
n.height*r);let o=t.getContext("2d"),s=Ai(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Ai(t){let[e,n]=t.shape,r=document.
createElement("canvas");[r.width,r.height]=[n,e];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,u)=>{let c=4*((e-1-i-t.first[0])*n+u+t.first[1]);s.data.set([...Ge(l),255],c)})),o.putImageData(s,0,0),r}function Wt(t,e){let n=p("span",{class:"grad\
ient"});return n.style.backgroundImage=Oo(),p("p",{class:"scale-of-rates small muted"},t,n,e)}var Ei=84;function Io(t,e){let n=t.map((s,a)=>Ci(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),r.hidden=t.length<2,r}function Ci(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Ei/
Math.max(r,o),i=p("canvas",{"aria-hidden":"true"});Ht(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),u=p("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Un(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Ti(t)}`),p("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:u,update:d=>{u.setAttribute("aria-current",String(d));let m=n.hover.pursuer??n.selected.pursuer,h=n.hover.evader??n.selected.evader;
l.hidden=m>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-m-.5)*a}px`}}}var Ti=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Un(t,e,n){
let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var ki=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function No(){let t=ki.map(([n,r])=>p("div",{class:"key-row"},p("dt",{},...n.map(o=>p("kbd",{},o))),p("dd",{},r))),e=p("dialog",{class:"help","ari\
a-labelledby":"help-title"},p("h2",{id:"help-title"},"Keys"),p("dl",{class:"keys"},...t),p("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),p("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",n=>n.target===e&&e.close()),e}function Bo(t,e,n,r,o,s){let a=(l,u)=>()=>{let c=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(c-1,Math.max(0,e.selected[l]+u))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.
inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:bn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let u=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,c=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||u||c||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let d=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(xe(n.player,l)||d)d?.();else if(t[m])Un(t[m],
m,e);else return;l.preventDefault()})}function Uo(t,e,n,r,o){let s=-8e3;for(let l of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(l,()=>s=performance.now(),{passive:!0});let a=()=>!r()&&
performance.now()-s>8e3,i=async()=>{let l=await fetch("version").then(u=>u.text(),()=>null);l===null?o():l==="end"||l!==t&&a()?(Ri(e,n),location.reload()):setTimeout(
()=>{i()},1e3)};i()}function Ri(t,e){let{run:n,pursuer:r,evader:o}=e.selected,[s,a]=t[n].payoff.shape;r===s-1&&o===a-1&&history.replaceState(null,"",`#run=${n}`)}function zn(t,e,n){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:n}}function Dn(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function jt(t){let e=Array.from({length:t.length+1},(n,r)=>$i(t,r));return zn(t.config,t.map,e)}function $i(t,e){
let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*n),alive:o(t.alive,e,n),captured:o(t.captured,e,r),
everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){return t.
conflicts(e).map(a=>a.cell)}}}var _i=Array.from({length:16},(t,e)=>{let[n,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function zo(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:_i,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var Pi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Do(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:Pi[t]}))}function ht(t,e,n,r){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${n})`,onclick:r},Do(t))}function Ve(t){let e=ht("play","Play","Space",()=>t.toggle()),n=Li(t),
r=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=Oi(t),s=p("output",{class:"player-count"}),a=p("div",{class:"player",role:"group","aria-la\
bel":"Player"},ht("first","First step","Home",()=>t.move(-t.length)),ht("back","Step back","←",()=>t.move(-1)),e,ht("forward","Step forward","→",()=>t.move(
1)),ht("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},r,n),s,o),i=()=>r.replaceChildren(...t.marks.map(u=>{let c=p("i");return c.style.left=
`${100*u/Math.max(1,t.length)}%`,c})),l=()=>{e.replaceChildren(Do(t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space\
)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,s.textContent=`${t.step} / ${t.length}`,s.style.minWidth=`${2*String(
t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),a.addEventListener(
"keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==n)&&xe(t,u)&&u.preventDefault()}),l(),a}function Li(t){let e=p("input",{type:"ran\
ge",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),e}function Oi(t){let e=`S\
teps a second, or the whole in ${zt} s (+ and -)`,n=p("select",{class:"player-speed","aria-label":"Speed",title:e},p("option",{value:je},`in ${zt} s`),...pt.map(
r=>p("option",{value:r},`${r} / s`)));return n.addEventListener("change",()=>{t.speed=Number(n.value)}),n}var B=(t,e=2)=>t==null?"-":t.toFixed(e);function Fo(t,e,n){return e===null||n===null?B(t):`${B(t)} (${B(e)} to ${B(n)})`}var Ho=t=>t.toLocaleString("en-GB");function ft(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(u=>u*s).find(u=>u>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(u,c)=>(i+c)*a)}var Ii=40,Gt=class{element;#e;#n=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,n){let{pursuer:r,evader:o,episode:s,seed:a}=this.#e.
selected,i=ze(e,r,o);this.#n.replaceChildren(...(i?.rates??[]).slice(0,Ii).map((m,h)=>this.#r(m,h)));let l=a===null?i?.rates[s]:void 0,u=n.statistics.capture_rate,
c=l!==void 0&&Math.abs(u-l)<1e-6&&n.length===i?.lengths[s],d=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(c),this.#t.textContent=c?"As in the evaluation":l===void 0?d:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${B(u,3)} in ${n.length} steps.${i?` The cell says ${B(i.rate,3)}.`:""}`}#r(e,n){let{selected:r}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${B(e)}`,"aria-label":`Episode ${n+1}, capture rate ${B(e)}`,"aria\
-pressed":String(n===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:n,seed:null})},o,p("span",{class:"count"},n+1))}};var Te=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Wo=0,jo=1,Ni=2,Bi=176;function Vo(t,e,n,r){let o=devicePixelRatio||1,s=We(t);t.width=t.height=Bi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let c=0;n&&c<i*i;c++){let[d,m]=[(c%i+.5)*l,(Math.floor(c/i)+.5)*l],h=f=>!!n[f*i*i+c];h(Ni)&&(a.fillStyle=
s.obstacle,a.fillRect(d-l/2,m-l/2,l,l));let g=h(Wo)&&h(jo)?l*.18:0;h(Wo)&&Go(a,Ce,d+g,m+g,l*.74,s.evader),h(jo)&&Go(a,It,d-g,m-g,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let u=Math.floor(i/2)*l;a.strokeRect(u,u,l,l)}function Go(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var Vt=class{element;#e;#n=p("canvas",{class:"seen",role:"img"});#t=p("h3");#r=p("p",{class:"small muted"});#a=p("div",{class:"answers"});#o=null;#c=null;#d=null;#u=null;#p=null;#i=0;constructor(e){
this.#e=e,this.element=p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),p("div",{class:"inspected"},this.#n,p("div",{class:"answer"},this.#t,this.#r),this.#a))}get agent(){return this.#p}show(e,n,r,o){(this.#c!==n||
!this.#o)&&(this.#o?.free(),this.#o=e.world(n.world),this.#p!==null&&this.#c!==n&&this.choose(null)),[this.#c,this.#d,this.#u]=[n,r,o]}choose(e){this.#p=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let n=this.#d;if(!n)return;let r=this.#p??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+e+n.n_agents)%n.n_agents,n.alive[this.#i*n.n_agents+r])return this.choose(r)}at(e){this.#i=e;let[n,r,o,s,a]=[this.#d,this.#o,this.#c,this.#u,this.#p];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#t.replaceChildren(p("span",{class:i},G(a,n.config.n_pursuers)));let l=!!n.alive[e*
n.n_agents+a];n.seek(r,e),Vo(this.#n,n.config,l?r.view(a):null,a),this.#n.ariaLabel=`Field of view of ${G(a,n.config.n_pursuers)}: evaders, pursuers and obstacl\
es around it`;let u=e<n.length?n.actions[e*n.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let c=ee(o,i,s[i]);if(typeof c=="string")return this.#s([],
`The script "${c}" plays for it${u===null?"":`; it goes ${Te[u]}`}.`);let{probabilities:d}=r.answer(c,a),m=Array.from(d,(g,f)=>Ui(Te[f],g,f===u)),h=c.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#s(m,u===null?"The episode is over.":h)}#s(e,n){this.#a.replaceChildren(
...e),this.#r.textContent=n}};function Ui(t,e,n){let r=p("span",{class:"filled"});return r.style.width=`${100*e}%`,p("div",{class:n?"action taken":"action"},p("\
span",{},t),p("span",{class:"track"},r),p("span",{class:"numbers"},e.toFixed(2)))}function qe(t,e,{pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,ee(e,"pursuer",n),ee(e,"evader",r),BigInt(s??a),o)}function qo(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Ko="champion",Yo=0,Fn=64,Hn=100;var zi=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Zo(t,e){return Object.keys(e).find(n=>zi(e[n],t))??null}var gt="_",Di="n",dd=2n**64n-1n;var Wn={fov:11,maxSteps:500,rewards:"paper"},Fi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Qo(t,e){let n=i=>i.map(l=>Wi(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Hi(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Xo(
t.rules,e),others:t.others?Xo(t.others,e):"",rewards:o===Wn.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Wn.fov?"":String(t.fov),
limit:t.maxSteps===Wn.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(gt),pursuers:t.pursuers.map(Jo).join(gt),
evaders:t.evaders.map(Jo).join(gt),played:t.played.map(n).join(gt),next:t.next.every(i=>i===Yo)?"":n(t.next)};return Fi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Jo({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Xo(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Zo(t,e.variants)??n.join(".")}function Hi(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(gt)}function Wi(t,e){if(typeof t=="number")return String(t);if(t===Ko)return Di;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var ji="/* the engine */";function es(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>jn(t(),e)},"What if?")}function jn(t,e){let n=t!==null&&t.match.n_agents<=Hn&&Math.max(t.match.config.rows,t.match.config.
cols)<=Fn,r=n?Qo(Gi(t.match,t.step),e):"",o=new TextDecoder().decode(Pn("playground")).replace(ji,()=>$t("script-engine")).replace("</noscript>",s=>n?s+qo(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${r}`)}function Gi(t,e){let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,
u=o*n.n_evaders+i-n.n_pursuers,c=d=>i>=n.n_pursuers&&!!d[u];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:c(t.captured),
everCaptured:c(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,
fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}function qt(t,e,n){if(n===0)return[{kind:"start",text:Vi(t),agents:[]}];let[r,o]=[e.moments[n-1],e.moments[n]],s=c=>G(c,t.config.n_pursuers),a=ct(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(c=>c.doomed)),u=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of Lt(r,o))!a.includes(c)&&!l.has(c)&&u.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return u.push(...i.map(({kind:c,text:d,agents:m})=>({kind:c,text:d,agents:m}))),n===t.length&&u.unshift({kind:"\
end",text:qi(t),agents:[]}),u}function Vi({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function qi(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Ki=60,Kt=class{element;player=new we(0,{speed:je,still:se()});inspector;match=null;recording=null;actions;#e;#n;#t;#r;#a=p("h2",{class:"match-title"});#o=p(
"p",{class:"tally numbers"});#c=p("ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#d=p("p",{class:"problem",role:"alert"});#u=null;#p=null;#i=0;#s=!1;#m=0;constructor(e,n,r){
[this.#n,this.#t]=[e,n];let o=p("canvas",{"aria-label":"The match"});this.#e=new be(o,{numbers:!1}),this.#r=new Gt(n),this.inspector=new Vt(s=>this.#x(s)),o.addEventListener(
"click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"M\
ove the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),es(()=>this.shown,
r)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#o),
this.#d,p("div",{class:"stage"},o),p("div",{class:"aside"},this.#c,zo(),this.actions,this.inspector.element),Ve(this.player),this.#r.element)),this.player.addEventListener(
"frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#f()),n.on("match",()=>this.#h()),n.on("\
rest",()=>this.player.pause()),this.#v(),this.#b(0,0)}get#l(){return this.#n[this.#t.selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){
return this.match&&this.#p&&{match:this.match,step:this.player.step,champions:this.#p}}start(e){this.#u=e,this.#y()}playSoon(){this.#s=!0,this.#i||this.#g()}goTo(e){
this.#m=e,!this.#i&&this.match&&this.#y()}#g(){!this.#s||!this.match||(this.#s=!1,this.player.jump(0),se()||this.player.play())}#h(){this.#v(),clearTimeout(this.#i),
this.#i=setTimeout(()=>this.#y(),Ki)}#y(){clearTimeout(this.#i),this.#i=0,this.player.pause(),this.#v();let{selected:e}=this.#t,n=ce.map(s=>Ae(this.#l,s,e[s])).
find(Boolean)??"";if(this.#d.textContent=n,n||!this.#u)return;this.match=qe(this.#u,this.#l,e);let[r,o]=this.names(e);this.#p={pursuer:{name:r,policy:ee(this.#l,
"pursuer",e.pursuer)},evader:{name:o,policy:ee(this.#l,"evader",e.evader)}},this.recording=jt(this.match),this.#r.show(this.#l,this.match),this.inspector.show(this.#u,
this.#l,this.match,e),this.player.length=this.match.length,this.player.marks=to(this.recording),this.player.jump(this.#m),this.#m=0,this.#f(),this.element.dataset.
played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#g()}names({run:e,pursuer:n,evader:r}){let{teams:o}=this.#n[e];return[o.pursuer.script??
`pursuers ${n}`,o.evader.script??`evaders ${r}`]}#v(){let{episode:e,seed:n}=this.#t.selected,{payoff:r}=this.#l,[o,s]=this.names(this.#t.selected),a=n===null?e<
r.episodes?`episode ${e+1} of ${r.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${n}`;this.#a.replaceChildren(p("span",{class:"pursuer"},o)," against ",
p("span",{class:"evader"},s),p("span",{class:"muted small"},a))}#f(){let e=this.match;if(!e||!this.recording)return;let n=this.player.step,r=this.recording.moments[n];
this.#b(Array.from(r.everCaptured).filter(Boolean).length,n),this.#c.replaceChildren(...qt(e,this.recording,n).map(o=>p("li",{class:o.kind,"data-agents":o.agents.
join(" ")},o.text))),this.inspector.at(n),this.#w()}#b(e,n){this.#o.replaceChildren(p("strong",{},e),` of ${this.#l.world.n_evaders} captured`,p("span",{class:"\
muted"},` · step ${n}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#w()}#w(){let e=this.inspector.agent;for(let n of this.#c.children){let r=n.
dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}};var Yi={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Zi=5;function ke(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Yi[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,u]=n(),c=o.shiftKey?Zi:1,{pursuer:d,evader:m}=e.selected;e.
select({pursuer:ts(d+c*a,l),evader:ts(m+c*i,u)}),o.preventDefault(),o.stopPropagation()})}var ts=(t,e)=>Math.min(e-1,Math.max(0,t));var Ji=24,Yt=7,rs=t=>t<Ji&&matchMedia("(pointer: coarse)").matches;function os(t,e,n,r){let[o,s]=t.payoff.shape,[a,i]=[ns(e,o),ns(n,s)],[l,u]=[Math.min(Yt,o),Math.
min(Yt,s)],c=[];for(let g=a+l-1;g>=a;g--){c.push(p("span",{class:"pursuer"},g));for(let f=i;f<i+u;f++)c.push(Xi(t,g,f,r))}let d=Array.from({length:u},(g,f)=>p("\
span",{class:"evader"},i+f)),m=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),h=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...c,m,...d);return h.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,h.addEventListener("click",g=>g.stopPropagation()),
h}function Xi(t,e,n,r){let o=ze(t,e,n)?.rate,s=p("button",{type:"button","aria-label":`${B(o)}: pursuers ${e} against evaders ${n}`,onclick:()=>r({pursuer:e,evader:n})},
B(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[Ft(o),Dt(o)]),s}var ns=(t,e)=>Math.max(0,Math.min(e-Yt,t-Math.floor(Yt/2)));var re={left:52,bottom:46,top:76,right:84},ue=10,Qi=160,yt=re.right-ue-14,Re=re.top-ue-14,Zt=class{element;#e;#n;#t=p("canvas",{"aria-hidden":"true"});#r=M("svg",
{"aria-hidden":"true"});#a=M("g");#o;#c=p("h2");#d=p("strong",{class:"rate numbers"});#u=p("span",{class:"small muted"});#p=p("p",{class:"of-both-teams small mu\
ted numbers"});#i=null;constructor(e,n){[this.#n,this.#e]=[e,n],this.#o=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#r);let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#c,this.#p),p("div",{class:"of-cell"},this.#d,this.#u));
this.element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#o,Wt("0 all escape","1 all caught")),this.#y(),new ResizeObserver(()=>this.#m()).
observe(this.#o),this.#o.addEventListener("pointermove",o=>this.#b(o)),this.#o.addEventListener("pointerleave",()=>n.point({})),this.#o.addEventListener("click",
o=>this.#x(o)),this.#o.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ke(this.#o,
n,()=>this.#s.payoff.shape),this.#o.addEventListener("keydown",o=>{o.key==="Enter"&&this.#S()}),n.on("run",()=>this.#m()),n.on("match",()=>this.#h()),n.on("hove\
r",()=>this.#h())}get#s(){return this.#n[this.#e.selected.run]}#m(){let[e,n]=this.#s.payoff.shape,{clientWidth:r,clientHeight:o}=this.#o;if(r<50)return;let a=Math.
max(Qi,Math.min(r-re.left-re.right,o-re.top-re.bottom))/Math.max(e,n),i=Math.max(re.left,(r-n*a-re.right+re.left)/2),l=re.top+Math.max(0,(o-re.top-re.bottom-e*a)/
2),u={width:r,height:o,left:i,top:l,cell:a,rows:e,columns:n};this.#i=u,Ht(this.#t,this.#s.payoff,{left:i,top:l,width:n*a,height:e*a}),this.#r.setAttribute("view\
Box",`0 0 ${r} ${o}`),this.#r.replaceChildren(el(u),...tl(u),...this.#g(u),this.#a),this.#h()}#l(e){let n=this.#s.findings?.generalization;if(!n)return[];let{selected:r,
hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??r.evader],[i,l]=ss(e,n.pursuers.mean[s]??0,s),[u,c]=as(e,n.evaders.mean[a]??0,a);return[M("circle",{class:"\
dot of-pursuers",cx:i,cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:u,cy:c,r:5})]}#g(e){let n=this.#s.findings?.generalization;if(!n)return[];let{left:r,top:o,
cell:s,rows:a,columns:i}=e,[l,u]=[r+i*s+ue,o-ue],c={class:"side"};return[M("rect",{...c,x:l,y:o,width:yt,height:a*s}),M("rect",{...c,x:r,y:u-Re,width:i*s,height:Re}),
...is(n.pursuers,(d,m)=>ss(e,d,m),"of-pursuers"),...is(n.evaders,(d,m)=>as(e,d,m),"of-evaders"),M("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),
M("text",{class:"tick",x:l+yt,y:o+a*s+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:r-6,y:u-4,"text-anchor":"end"},"0"),M("text",{class:"tick",x:r-6,y:u-
Re+8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:l+yt,y:o+a*s+34,"text-anchor":"end"},"captures"),M("text",{class:"label of-evaders",x:r+i*s+
ue,y:u-Re+10,"text-anchor":"start"},"escapes")]}#h(){let e=this.#i;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,u=g=>s+
(i-1-g)*a,c=[],d=(g,f)=>M("rect",{class:f,x:o,y:u(g),width:l*a+ue+yt,height:a}),m=(g,f)=>M("rect",{class:f,x:o+g*a,y:s-ue-Re,width:a,height:ue+Re+i*a});c.push(d(
n.pursuer,"strip pursuer"),m(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&c.push(d(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&c.push(m(r.
evader,"strip hover")),c.push(...this.#l(e));let h={x:o+n.evader*a,y:u(n.pursuer),width:a,height:a};c.push(M("rect",{class:"chosen under",...h}),M("rect",{class:"\
chosen",...h})),this.#a.replaceChildren(...c),this.#y()}#y(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=ze(this.#s,r,o);this.#c.
replaceChildren(p("span",{class:"pursuer"},`Pursuers ${r}`)," against ",p("span",{class:"evader"},`evaders ${o}`)),this.#d.textContent=s?B(s.rate,3):"-",this.#u.
textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#p.textContent=this.#v(r,o)}#v(e,n){let r=this.#s.findings?.
generalization;if(!r)return"";let o=(s,a)=>Fo(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(r.pursuers,e)}, escapes ${o(r.evaders,
n)}`}#f(e){let n=this.#i;if(!n)return null;let r=this.#o.getBoundingClientRect(),o=Math.floor((e.clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-
r.top-n.top)/n.cell),[a,i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#b(e){let n=this.#f(e);this.#e.point(n?{pursuer:n.
g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#x(e){let n=this.#f(e);if(n){if(n.inside&&rs(this.#i.cell))return this.#w(n.g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.
g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#S()}}#w(e,n){let r=os(this.#s,e,n,o=>{r.remove(),o&&(this.#e.select(o),this.#S())});this.#o.append(r)}#S(){this.#o.
dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function el({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"axes"}),a=e+r*n,i=l=>ft(0,l-1,Math.
min(l,l*n/44),!0);for(let l of i(o))s.append(M("text",{class:"tick",x:t+(l+.5)*n,y:a+16,"text-anchor":"middle"},l));for(let l of i(r))s.append(M("text",{class:"\
tick",x:t-7,y:a-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(M("text",{class:"label of-evaders",x:t+o*n/2,y:a+36,"text-anchor":"\
middle"},"evader generation"),M("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generat\
ion")),s}function tl({left:t,top:e,cell:n,rows:r,columns:o}){let s=M("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;for(let c of["H","V"]){
let d=`M${t} ${i}`;for(let m=1;m<=a;m++){let[h,g]=[`H${t+m*n}`,`V${i-m*n}`];d+=c==="H"?h+g:g+h}s.append(M("path",{d,class:"under"}),M("path",{d}))}let[l,u]=[t+a/
2*n-.7*n-4,i-a/2*n-.7*n-4];return[s,M("text",{class:"on-cells",transform:`translate(${l} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var ss=({
left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+ue+s*yt,e+(r-a-.5)*n],as=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-ue-r*Re];function is(t,e,n){let r=s=>s.map(
(a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(M("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].join("\
L")}Z`})),o.push(M("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function ae(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}function ls(t,e,n){let{findings:r}=t;if(!r?.table.length)return null;let o=p("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&rl(o,t,i,e,
l)},a=r.checkerboards.map(i=>nl(t,i,s));return{element:ae("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Cl\
ick one: its four matches side by side.",a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?
p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise m\
akes."):null,o)}}var cs=({pursuers:[t,e],evaders:[n,r]})=>[[t,n],[t,r],[e,n],[e,r]];function nl(t,e,n){let[r,o]=e.pursuers,[s,a]=e.evaders,i=cs(e).map(([l,u])=>{
let c=t.payoff.capture_rate[l][u],d=p("span",{class:"cell"},B(c));return d.style.backgroundColor=Ft(c),d.style.color=Dt(c),d});return p("button",{type:"button",
class:"miniature numbers",onclick:()=>n(e)},p("span",{},p("span",{class:"heard"},`Four matches of pursuers ${r} and ${o}, evaders ${s} and ${a}:`)),p("span",{class:"\
evader"},s),p("span",{class:"evader"},a),p("span",{class:"pursuer"},r),i[0],i[1],p("span",{class:"pursuer"},o),i[2],i[3])}function rl(t,e,n,r,o){let s=cs(n).filter(
([m,h])=>!Ae(e,"pursuer",m)&&!Ae(e,"evader",h)),a=s.map(([m,h])=>qe(o,e,{run:r.selected.run,pursuer:m,evader:h,episode:0,seed:null})),i=new we(Math.max(0,...a.map(
m=>m.length)),{speed:je,still:se()}),l=a.map((m,h)=>{let[g,f]=s[h],y=p("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),b=p("span",{class:"numbers"}),
S=()=>{t.close(),r.select({pursuer:g,evader:f})},v=p("figure",{},y,p("figcaption",{class:"small"},b,p("span",{class:"muted"},`cell ${B(e.payoff.capture_rate[g][f])}`),
p("button",{type:"button",title:"Show this match alone",onclick:S},"open")));return v.style.gridArea=`${n.pursuers.indexOf(g)+2} / ${n.evaders.indexOf(f)+2}`,{element:v,
match:m,recording:jt(m),board:new be(y,{numbers:!1}),tally:b}}),u=()=>l.forEach(m=>m.board.show(m.recording,i.time)),c=()=>l.forEach(({recording:m,match:h,tally:g})=>{
let f=m.moments[Math.min(i.step,h.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener(
"frame",u),i.addEventListener("step",c),t.replaceChildren(p("header",{},p("h2",{},"Four matches of a checkerboard"),p("button",{type:"button",onclick:()=>t.close()},
"Close")),p("div",{class:"grid-of-four"},p("span"),...n.evaders.map(m=>p("h3",{class:"evader"},`evaders ${m}`)),...n.pursuers.map((m,h)=>{let g=p("h3",{class:"p\
ursuer"},`pursuers ${m}`);return g.style.gridArea=`${h+2} / 1`,g}),...l.map(m=>m.element)),Ve(i));let d=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof
HTMLButtonElement&&m.key===" ")&&!m.defaultPrevented&&xe(i,m)&&m.preventDefault()};t.addEventListener("keydown",d),t.addEventListener("close",()=>{t.removeEventListener(
"keydown",d),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},{once:!0}),r.dispatchEvent(new Event("rest")),t.showModal(),u(),c(),se()||i.play()}var Jt={pursuer:"evader",evader:"pursuer"};function us(t,e){let n=t.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${B(s)}, stripes ${B(a)}${i===null?"":` every ${i} generations`}`;return ol(t,o,l,e)});return{element:ae("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element)),Wt("0 loses","1 wins")),
update:()=>r.forEach(o=>o.update())}}function ol(t,e,n,r){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(v,w)=>e==="pursuer"?t.payoff.
capture_rate[v][w]:1-t.payoff.capture_rate[w][v],l=p("canvas",{width:a,height:s,"aria-hidden":"true"}),u=l.getContext("2d"),c=u?.createImageData(a,s);for(let v=0;c&&
v<s;v++)for(let w=0;w<=Math.min(v,a-1);w++)c.data.set([...Ge(i(v,w)),255],4*((s-1-v)*a+w));c&&u?.putImageData(c,0,0);let d=M("rect",{class:"chosen",width:1,height:1}),
m=M("rect",{class:"chosen under",width:1,height:1}),h=M("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,d),g=p("div",{class:"t\
riangle","aria-label":`CIAO of the ${e}s: ${n}. Arrow keys choose a match.`},l,h);ke(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=v=>{let w=g.
getBoundingClientRect(),A=Math.floor((v.clientX-w.left)/w.width*a),T=s-1-Math.floor((v.clientY-w.top)/w.height*s);return A>=0&&T<s&&A<=T?[T,A]:null},y=v=>({[e]:v[0],
[Jt[e]]:v[1]});g.addEventListener("pointermove",v=>r.point(f(v)?y(f(v)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",v=>f(
v)&&r.select(y(f(v))));let b=()=>{let v=r.hover[e]??r.selected[e],w=r.hover[Jt[e]]??r.selected[Jt[e]];for(let A of[d,m])A.setAttribute("x",String(w)),A.setAttribute(
"y",String(s-1-v)),A.style.display=w<=v?"":"none"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},`${e}s`)),g,p("p",{class:"smal\
l muted"},`horizontal: ${Jt[e]} generation; vertical: ${e} generation`),p("p",{class:"small numbers"},n)),update:b}}var Xt={left:46,right:12,top:10,bottom:42},ds={x:56,y:34};function Gn(t,e,n,r){let[o,s]=[Xt.left,Xt.top],a=Math.max(o+40,t-Xt.right),i=Math.max(s+40,e-Xt.bottom),
l=(f,y,b)=>S=>y+(S-f.low)/(f.high-f.low||1)*(b-y),[u,c]=[l(n,o,a),l(r,i,s)],d=M("g"),m=M("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=M("g",
{class:"axes"});for(let f of ft(r.low,r.high,(i-s)/ds.y,r.whole))h.append(M("line",{x1:o,x2:a,y1:c(f),y2:c(f),class:"grid"}),M("text",{x:o-8,y:c(f),"text-anchor":"\
end","dominant-baseline":"middle"},ps(f)));for(let f of ft(n.low,n.high,(a-o)/ds.x,n.whole))h.append(M("text",{x:u(f),y:i+16,"text-anchor":"middle"},ps(f)));return h.
append(M("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),M("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},n.label),M("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),m.append(h,d),{root:m,marks:d,left:o,right:a,top:s,bottom:i,x:u,y:c,at:f=>{let y=f-m.getBoundingClientRect().
left;return n.low+(y-o)/(a-o)*(n.high-n.low)}}}var ps=t=>String(Number(t.toPrecision(6))).replace("-","−");function Vn(t,e,n,r){let o="",s="M";n.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(M("path",{d:o,class:`line ${r}`}),t.marks)}function qn(t,e,n,r=null){
let o=t.x(e);t.marks.append(M("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(M("circle",{cx:o,cy:t.y(r),r:5,class:`dot ${n}`}))}
function Kn(...t){return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function Yn(t,e,n,r){let o=p("div",{class:"chart choose\
s",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&n(s)};return o.addEventListener("click",i=>s&&r(s.at(i.clientX),s,i)),new ResizeObserver(
()=>{let{clientWidth:i,clientHeight:l}=o;i<50||l<50||(s=e(i,l),o.replaceChildren(s.root),a())}).observe(o),{element:o,update:a}}var Zn=["of-pursuers","of-evaders","of-both"],sl=2500,ms="Arrow keys choose generations.",al={low:0,high:1,label:"capture rate"};function hs(t,e){let{training:n}=t,
{capture_rate:r,generation:o,learner:s,epochs:a}=n,i=r.map((g,f)=>(f+1)*a),l=il(r,n.window),u=i.at(-1)??1,c=i.length>sl?"dense":"",d=(g,f)=>{let y=o.flatMap((b,S)=>b===
g&&(s[S]===f||s[S]===2)?[S]:[]);return y.length?[i[y[0]],i[y.at(-1)]]:null},m=Yn(`Capture rate in ${u} epochs of training. ${ms}`,(g,f)=>{let y=Gn(g,f,{low:0,high:u,
label:"epoch",whole:!0},al);for(let[b,S]of[["raw",r],[c,l]])for(let[v,w]of Zn.entries()){let A=S.map((T,E)=>s[E]===v||s[E+1]===v?T:null);A.some(T=>T!==null)&&Vn(
y,i,A,`${w} ${b}`)}return y},g=>ce.forEach((f,y)=>{let b=d(e.hover[f]??e.selected[f],y);b&&qn(g,(b[0]+b[1])/2,Zn[y])}),g=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(g/a)-1)),y=o[f];s[f]!==1&&e.select({pursuer:Math.min(y,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(y,t.payoff.shape[1]-1)})});ke(m.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],Zn[g]]);return{element:ae("Training",`${Ho(n.
matches)} training matches. Lines: the generations that are selected.`,Kn(...h),m.element),update:m.update}}function fs(t,e){let n=t.findings?.ratings;if(!n)return null;
let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(c=>c??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...t.payoff.
shape)-1,u=Yn(`Elo ratings by generation. ${ms}`,(c,d)=>{let m=Gn(c,d,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let h of ce)
Vn(m,r[h].map((g,f)=>f),r[h],`of-${h}s`);return m},c=>{for(let d of ce){let m=e.hover[d]??e.selected[d];qn(c,m,`of-${d}s`,r[d][m]??null)}},(c,d,m)=>{let h=Math.
round(c),g=m.clientY-d.root.getBoundingClientRect().top,f=b=>Math.abs(d.y(r[b][h]??1/0)-g),y=f("pursuer")<=f("evader")?"pursuer":"evader";h>=0&&h<r[y].length&&e.
select({[y]:h})});return ke(u.element,e,()=>t.payoff.shape),{element:ae("Ratings",`One number for each generation, which cycles do not fit. The game itself: ${B(
n.offset,0)} points for the pursuers.`,Kn(["pursuers","of-pursuers"],["evaders","of-evaders"]),u.element),update:u.update}}function il(t,e){let n=[0];for(let r of t)
n.push(n.at(-1)+r);return t.map((r,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(n[a]-n[s])/(a-s)})}var ll={present:"●",absent:"○","cannot tell":"?"};function gs(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],u)=>{
let c=cl(e.reasons[u]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},ll[a]??""),p("div",{},p("p",{},p("\
strong",{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),c?p("p",{class:"small"},`${c}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ae("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${ys(s)}.`)),p("ul",{class:"findings"},...r),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function cl(t){let[,e=""]=t.split(/, because (.*)/s);return ys(e.replace(/\.$/,""))}var ys=t=>t.charAt(0).toUpperCase()+t.slice(1);function vs({settings:t,schedule:e,seed:n}){let r=t.map(({name:a,value:i,help:l})=>p("tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"n\
umbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...r),s=ae("Settings",`${e}, \
seed ${n}; all others are the defaults of matrixworld evolve.`,r.length?p("div",{class:"wide-table"},o):null);return s.classList.add("settings"),{element:s}}function bs(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??ul(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(u=>u.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function ul(t,e,n){return[gs(t),hs(t,e),ls(t,e,n),fs(
t,e),us(t,e),vs(t)].filter(o=>o!==null)}var nn=ca(Ps(),1);var tr=125,Pl=80,Ll=10,Ls=480,Ol=[1,.8,.6,.4,.2],Il=5;async function Os(t,e){let n=Math.min(1,dt(t.rows,t.cols)),[r,o]=[Math.round(Ls*n),Math.round(Ls*n/dt(t.rows,
t.cols))],s=document.createElement("canvas");[s.width,s.height]=[r,o];let a=s.getContext("2d",{willReadFrequently:!0}),i=We(document.documentElement),l={ctx:a,colors:i,
grid:Ut(t.rows,t.cols,!1,r,o,1)},[u,c]=[Nl(i,a),(0,nn.GIFEncoder)()];for(let d=0;d<tr;d++){let m=Math.min(1,d/(tr-Ll))*(t.moments.length-1);Bt(l,t,m,{...Nt,numbers:!1},
1),a.globalCompositeOperation="destination-over",a.fillStyle=i.paper,a.fillRect(0,0,r,o),a.globalCompositeOperation="source-over",c.writeFrame((0,nn.applyPalette)(
a.getImageData(0,0,r,o).data,u),r,o,{palette:u,delay:Pl}),d%Il===0&&(e(Math.round(100*d/tr)),await new Promise(h=>setTimeout(h)))}return c.finish(),new Blob([c.
bytes()],{type:"image/gif"})}function Nl(t,e){let n=o=>(e.globalAlpha=1,e.fillStyle=o,e.fillRect(0,0,1,1),[...e.getImageData(0,0,1,1).data.subarray(0,3)]),r=n(t.
paper);return Object.values(t).map(n).flatMap(o=>Ol.map(s=>o.map((a,i)=>Math.round(r[i]+s*(a-r[i])))))}function Is(t,e){let n=p("input",{type:"text",readonly:!0,"aria-label":"Link to this step"}),r=p("p",{class:"muted small",role:"status"}),s=p("button",{type:"bu\
tton",class:"save-gif",onclick:async()=>{if(!t.recording)return;let{pursuer:l,evader:u}=e.selected;s.disabled=!0;let c=await Os(t.recording,m=>r.textContent=`Dr\
awing: ${m} %`),d=URL.createObjectURL(c);p("a",{href:d,download:`pursuers-${l}-evaders-${u}.gif`}).click(),setTimeout(()=>URL.revokeObjectURL(d),6e4),r.textContent=
`Saved, ${(c.size/1e6).toFixed(1)} MB.`,s.disabled=!1}},"Save the match as a GIF of 10 s"),a=p("dialog",{class:"share","aria-labelledby":"share-title"},p("h2",{
id:"share-title"},"Share this match"),s,ot()&&p("p",{},"The link leads to this step in the same file. Nothing is sent anywhere."),ot()&&p("div",{class:"link"},n,
p("button",{type:"button",onclick:()=>Pr(n,r)},"Copy")),r,p("button",{type:"button",onclick:()=>a.close()},"Close"));return a.addEventListener("click",l=>l.target===
a&&a.close()),{button:p("button",{type:"button",class:"to-share",onclick:()=>{e.dispatchEvent(new Event("rest")),n.value=location.href,r.textContent="",a.showModal()}},
"Share"),dialog:a}}var Ns={pursuer:null,evader:null},rn=class extends EventTarget{#e;#n=Ns;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...Ns,...e};n.pursuer===this.#n.pursuer&&n.evader===this.#n.evader||(this.#n=n,this.dispatchEvent(
new Event("hover")))}on(e,n){this.addEventListener(e,n)}};var on=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,n,r){[this.config,this.start]=[n,r],this.#e=e.world(n),this.#e.reset(r),this.#n=[Dn(this.#e)],
this.recording=zn(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}play(e){this.#e.step(e),this.#r(e)}step(e,n,r){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(u,s)],a)),u>s&&(a=o.decide(e.evader,[Math.max(l,s),u],a)),typeof r==
"number"?a[n]=r:l<=n&&n<u&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#n.push(Dn(this.#e,e)),this.#t.push(this.#e.conflicts())}};var ge=(t,e)=>ce[+(e>=t.n_pursuers)];function nr(t,e){let n=new on(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.
seat,r);return n}function Ke(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var sn=(t,e)=>t.over||Ke(t,e).out;function Bs(t,e,n){let r=nr(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!sn(r,e.seat);)r.step(e.policies,e.seat,n);return Ke(r,e.seat)}function Us(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}
function zs(t,{seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Ds(t,e){let[n,r,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function rr(t,e,n,r,o,s){e.play({title:n,played:r,ending:(a,i)=>[Bl(t,a,i,Us(o))],again:()=>rr(t,e,n,{...r,moves:r.moves.slice(0,r.from)},o,s),link:a=>zs(s,a)})}
function Bl(t,e,n,r){let o=ge(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[c,d]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},u),p("td",{class:"track","aria-hidden":"true"},c),d)),({lasted:m,captured:h})=>{c.style.width=`${100*(o?m:h)/s}%`,
d.textContent=String(o?m:h)}};i("You")(Ke(e,n.seat));for(let{name:u,policy:c}of r){let d=i(u);setTimeout(()=>d(Bs(t,n,c())))}let l=n.from?`You took over at step\
 ${n.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Fs=["·","↑","→","↓","←","↗","↘","↙","↖"];var Ul={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},or=[8,1,5,4,0,2,7,3,6],zl=[7,8,9,4,5,6,1,2,3],Dl=24,Fl=Math.
tan(Math.PI/8);function Ws(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=zl.findIndex(o=>t.code===`Numpad${o}`),r=or[n]??Ul[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function js(t){let e=or.map(n=>p("button",{type:"button","aria-label":Te[n],onclick:()=>t(n)},Fs[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",or[o]>4&&!n))}}function Hs(t,e,n){let r=Fl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return Qr([0,0],n?[o(t),o(e)]:[t,e],n)}function Gs(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,e()];if(r=null,!i||!l)return;let[u,c]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(u,c)>=Dl?n(Hs(c,u,l.diagonal)):d&&n(Hs(d[0]-l.cell[0],
d[1]-l.cell[1],l.diagonal))})}function Vs(t,e){let n=r=>{let o=e[r]-t[r],s=De.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${Te[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var Ys="NUMPY\0",qs=Ys.length+2,Ks=64;function Zs(t){return Yr(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,Hl(n)])))}function Hl({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((qs+s.length+1)/Ks)*Ks-qs,i=Ys+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,u=new Uint8Array(i.length+l.byteLength);return u.set(Tt(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}var Wl="matrixworld episode 3";function Js(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},m=v=>{
for(let w of Object.keys(v))(d[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(r);h.reset(e.start);let g=[];m(u);for(let v of o)h.step(v),m({...u,...c}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[v,[w,...A]]of Object.entries({...u,...c})){let T=s+
+(v in u);y[v]={dtype:w,shape:[T,...A],data:f[w].from((d[v]??[]).flat())}}let b=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),S=v=>({dtype:"<U",shape:[],data:v});
return Zs({format:S(Wl),n_pursuers:b(r.n_pursuers),config:S(JSON.stringify(r)),seat:b(n),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var jl=[0,1,2,4,8],an=class{element;player=new we(0,{speed:4,still:se()});#e;#n;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=p("h2");#a=p("p",{
class:"play-told",role:"status"});#o=js(e=>this.act(e));#c=p("select",{},...jl.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#d=p("input",{type:"ch\
eckbox"});#u=p("section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#p=Ve(this.player);#i=null;#s=null;#m=[];#l=null;#g=0;#h=0;constructor(e){
this.#e=e,this.#n=new be(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#c.addEventListener("change",()=>this.#f()),this.#d.addEventListener(
"change",()=>this.#v()),Gs(this.#n,()=>{let n=this.#l!==null&&this.#s&&O(this.#s.recording.moments.at(-1),this.#l);return n?{cell:n,diagonal:this.#s.config.diagonal}:
null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#s&&this.#n.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#M()),
this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#r,this.#a),p("div",{class:"play-stage"},this.#t),p("div",{class:"play-side"},this.#u,this.#o.
element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#c),p("label",{class:"play-choice"},this.#d," Fog: see only what it sees"),p("p",{class:"\
small muted play-keys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or t\
ap where to go.")),this.#p)}get played(){return this.#i&&{...this.#i.played,moves:this.#m}}get live(){return this.#s}play(e){this.#y(nr(this.#e,e.played),e.played.
seat,e.title),[this.#i,this.#m,this.#g]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),sn(this.#s,e.played.seat)&&
this.#x()}watch(e,n,r){this.#i=null,this.#y(e,n,r),this.#w()}stop(){this.#f(),this.player.pause(),this.#i=null}act(e){let[n,r]=[this.#i,this.#s];if(!n||!r||this.
element.dataset.state!=="playing")return;this.#g=e;let o=Number(this.#c.value);this.#h||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#h=setInterval(
()=>this.#b(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&
(r===" "||r==="Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return xe(this.player,e);let s=Ws(e,this.#s.config.diagonal);return s!==void 0&&
this.act(s),s!==void 0}#y(e,n,r){this.#f(),this.player.pause(),[this.#s,this.#l]=[e,n],this.#r.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.
cols} cells`,this.#o.show(e.config.diagonal),this.#u.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#v(),this.#M()}#v(){this.#n.look=
{you:this.#l,fog:this.#d.checked,viewers:this.#l===null?[]:[this.#l]}}#f(){clearInterval(this.#h),this.#h=0,this.#a.ariaLive=Number(this.#c.value)?"off":"polite"}#b(){
let[{policies:e,seat:n},r]=[this.#i.played,this.#s];r.step(e,n,this.#g),this.#m.push(this.#g),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#c.value)||4)),this.player.move(r.length-this.player.step),sn(r,n)&&this.#x()}#x(){this.#f();let[e,n,r]=[this.#i,this.#s,this.played],o=ot()?e.link(r):null;
this.#u.replaceChildren(p("h3",{id:"play-headline"},ql(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.
again()},"Again"),p("button",{type:"button",onclick:()=>this.#w()},"Watch it"),p("button",{type:"button",onclick:()=>this.#S(n,r.seat)},"Save"),o&&p("button",{type:"\
button",onclick:({currentTarget:s})=>Yl(s,o)},"Link"))),this.element.dataset.state="ended",this.#u.focus({preventScroll:!0}),this.#u.scrollIntoView({block:"near\
est"})}#w(){this.element.dataset.state="watched",this.player.length=this.#s.length,this.player.jump(0),se()||this.player.play()}#S(e,n){let r=new Blob([Js(this.#e,
e,n)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(r),download:`${G(n,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#M(){let[e,n,
{step:r}]=[this.#s,this.#l,this.player];if(!e||r>e.length)return;let o=qt(e,e.recording,r).filter(({agents:a})=>n===null||a.includes(n)),s=[`Step ${r} of ${e.config.
max_steps}`,...o.map(({text:a})=>a)];this.#i&&r===0?s.push(Gl(e.config,n)):n!==null&&s.push(Vl(e,r,n)),this.#a.textContent=s.filter(Boolean).map(a=>`${a}.`).join(
" ")}};function Gl(t,e){let n=t.rules.capture==="SURROUND";return ge(t,e)==="evader"?`Stay free: ${n?"pursuers on all sides of you capture":"a pursuer on your c\
ell captures"} you`:`Capture evaders: ${n?"surround them together":"reach their cell"}`}function Vl({config:t,recording:e},n,r){let o=e.moments[n],a=ge(t,r)==="\
pursuer"?"evader":"pursuer";if(!o.alive[r])return"";let i=O(o,r),l=d=>{let[m,h]=O(o,d);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},u=Array.from({length:o.
alive.length},(d,m)=>m).filter(d=>ge(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!u.length)return`No ${a} in view`;let c=u.reduce((d,m)=>l(
m)<l(d)?m:d);return`Nearest ${a}: ${Vs(i,O(o,c))}`}function ql(t,e){let[{lasted:n,out:r,captured:o},{config:s}]=[Ke(t,e),t];return ge(s,e)==="pursuer"?`Your tea\
m captured ${o} of ${Kl(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var Kl=({n_evaders:t})=>`${t} evader${t===1?
"":"s"}`;function Yl(t,e){let n=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(n),n.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}var ln=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#n;#t;#r=null;constructor(e,n,r){[this.#e,this.#n,this.#t]=[e,n,r],
r.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.view?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.view?.stop())}start(e,n){this.#r=e;let r=st(n,this.#e,this.#n.selected),o=Ds(new URLSearchParams(n.replace(/^#/,"")),this.#e[r.run].world);o&&this.#a(
r,o)}open(){let e=this.#t.shown;if(!e)return;let{match:n,step:r}=e;this.#t.player.pause();let o=this.#t.inspector.agent,s=r<n.length?r:0,a=(d,m)=>!!n.alive[m*n.
n_agents+d],i=Array.from({length:n.n_agents},(d,m)=>(m+n.config.n_pursuers)%n.n_agents),l=o??i.find(d=>a(d,s)),u=a(l,s)?s:0,c=Array.from({length:u},(d,m)=>n.actions[m*
n.n_agents+l]);this.#a(this.#n.selected,{seat:l,from:u,moves:c})}#a(e,n){let[r,o]=[this.#r,this.#e[e.run]];if(!r||ce.some(f=>Ae(o,f,e[f])))return;let{run:s,pursuer:a,
evader:i,episode:l,seed:u}=e,c=ge(o.world,n.seat),d=o.teams[c].kept.map(f=>({name:o.teams[c].script??`generation ${f}`,policy:()=>ee(o,c,f)}));this.view||(this.
view=new an(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.
showModal();let m=`You are ${G(n.seat,o.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,h={pursuer:ee(o,"pursuer",a),evader:ee(o,"evader",i)},g={config:o.
world,seed:BigInt(u??o.seeds[a][i]),episode:l,policies:h,...n};rr(r,this.view,m,g,d,{run:s,pursuers:a,evaders:i,episode:l,...u===null?{}:{seed:u}})}};var de=Jr(),{runs:J}=de,[Zl,Jl]=J[0].payoff.shape,Xl=st(location.hash,J,{run:0,pursuer:Zl-1,evader:Jl-1,episode:0,seed:null}),{step:Qs,...Ql}=Xl,Z=new rn(Ql),F=new Kt(
J,Z,de.playground),ea=new Zt(J,Z),Ze=new ln(J,Z,F),sr=No(),ec=location.hash,Xs=Lo(J,Z,F),{button:tc,dialog:nc}=Is(F,Z);F.actions.append(tc);var Ye=null,ta=p("as\
ide",{class:"note small muted"},de.note),rc="Each cell is a match between two generations: the brighter, the more evaders are captured. Click one to watch it.";
document.getElementById("page").replaceWith(p("header",{class:"top"},p("div",{},p("h1",{},de.heading),p("p",{class:"lead"},rc)),p("div",{class:"tools"},Xs.button,
Lr(),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>sr.showModal()},"?"))),...de.note?[ta]:[],Io(J,Z),p("mai\
n",{class:"stages"},ea.element,F.element),bs(J,Z,()=>Ye),p("footer",{class:"muted small"},`${de.title} · matrixworld ${de.version}`),Ze.dialog,sr,nc,Xs.bar);Object.
assign(window,{matrixworldExplorer:{get match(){return F.match},get step(){return F.player.step},get pace(){return F.player.pace},get playing(){return Ze.view},
play:t=>Ye&&qe(Ye,J[Z.selected.run],{...Z.selected,episode:t}),get shape(){return J[Z.selected.run].payoff.shape}}});ea.element.addEventListener("play",()=>{F.playSoon(),
F.reveal()});F.goTo(Qs);Qs||F.playSoon();Or(J,Z,F);Bo(J,Z,F,sr,()=>Ze.open(),()=>jn(F.shown,de.playground));window.addEventListener("hashchange",({newURL:t})=>Ye&&
Ze.start(Ye,new URL(t).hash));de.live!==null&&Uo(de.live,J,Z,()=>F.player.playing||Ze.dialog.open,()=>{ta.textContent="The command has ended. This page shows wh\
at it had played; explorer.html is beside the runs if they have finished."});requestAnimationFrame(()=>setTimeout(()=>{$r().then(t=>{Ye=t,F.start(t),Ze.start(t,
ec),document.body.dataset.ready="true"},t=>{F.element.prepend(p("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.
dataset.ready="true"})}));})();
