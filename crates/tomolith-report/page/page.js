"use strict";(()=>{function b(i,e={},...t){let[n,...s]=i.split("."),r=document.createElement(n);return s.length>0&&(r.className=s.join(" ")),Pp(r,e),Lp(r,t),r}function wt(i,e={},...t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);return Pp(n,e),Lp(n,t),n}function Ys(i){let e=document.createDocumentFragment();return i.split("`").forEach((t,n)=>{t!==""&&e.append(n%2===1?b("code",{},t):t)}),e}function Pp(i,e){for(let[t,n]of Object.entries(e))n==null||n===!1||(typeof n=="function"?i.addEventListener(t,n):i.setAttribute(t,n===!0?"":String(n)))}function Lp(i,e){for(let t of e)t!=null&&t!==!1&&i.append(t)}var F_={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"},Dn="–";function pe(i){return typeof i=="number"&&Number.isFinite(i)}function Ml(i){return"10"+[...String(i)].map(e=>F_[e]??e).join("")}function ce(i,e){if(!pe(i))return Dn;if(i===0)return"0";let t=Math.abs(i).toExponential(Math.max(e-1,0)),[n="0",s="0"]=t.split("e"),r=Number(s),o=i<0?"−":"";return r>=-3&&r<6?o+wu(Number(t).toFixed(Math.max(e-1-r,0))):o+(wu(n)==="1"?Ml(r):`${wu(n)}·${Ml(r)}`)}function aa(i,e){for(let t=e;t<7;t++){let n=i.map(r=>ce(r,t));if(i.every((r,o)=>i.every((a,l)=>l>=o||r===a||n[o]!==n[l])))return n}return i.map(t=>ce(t,7))}function Ai(i){if(!pe(i))return Dn;let e=Math.round(i);return e<60?`${ce(i,3)} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e/60)%60} min`}function ss(i){return i==="mm"?{unit:"µm",factor:1e3}:i.startsWith("mm (")?{unit:"mm",factor:1}:{unit:i==="response"?"":i,factor:1}}function an(i,e,t=3){return pe(i)?e===""?ce(i,t):`${ce(i,t)} ${e}`:Dn}function Sl(i,e,t){if(e!=="mm"||!pe(i)||!pe(t)||t<=0)return"";let n=ce(i/t,2);return n==="1"?"1 voxel":`${n} voxels`}function wu(i){let e=i.includes(".")?i.replace(/\.?0+$/,""):i,[t="",n]=e.split("."),s=t.replace(/\B(?=(\d{3})+$)/g,",");return n===void 0?s:`${s}.${n}`}var k_=[4456788,4727925,4277383,3497869,2783374,2199948,2271364,4505456,8048977,12443430,16639781],B_=[4,1444665,4328040,6952814,9643623,12334932,14504250,15955993,16557322,16176966,16580516],z_=[1922736,7050966,13883614,15177347,13055519];function Ip(i,e=255){return(e<<24|(i&255)<<16|i&65280|i>>16)>>>0}function wl(i){return`rgb(${i&255} ${i>>8&255} ${i>>16&255} / ${((i>>>24)/255).toFixed(3)})`}function Eu(i,e){let t=Math.min(Math.max(e,0),1)*(i.length-1),n=Math.min(Math.floor(t),i.length-2),s=r=>{let[o,a]=[i[n]>>r&255,i[n+1]>>r&255];return Math.round(o+(t-n)*(a-o))<<r};return Ip(s(16)|s(8)|s(0))}var rs=i=>Eu(k_,i),Tu=i=>Eu(B_,i),eo=i=>Eu(z_,i);function to(i){return[(i&255)/255,(i>>8&255)/255,(i>>16&255)/255]}function Mn(i){let e=getComputedStyle(document.documentElement).getPropertyValue(i).trim();return Ip(Number.parseInt(e.slice(1),16)||0)}function _r(i,e){return(i&16777215|Math.round(255*e)<<24)>>>0}function yr(i,e){let{low:t,high:n,logarithmic:s}=i;return n>t?s?Math.log(Math.max(e,t)/t)/Math.log(n/t):(e-t)/(n-t):0}function El(i,e){return Uint32Array.from(i,t=>Number.isNaN(t)?0:e.map(yr(e,t)))}var os=["x","y","z"],Bn={0:[1,2],1:[0,2],2:[0,1]},bs={outside:0,void:1,part:2},Ms={none:0,dark:1,insert:2,obstacle:3},la=class{constructor(e,t,n){this.shape=e;this.pitch=t;this.center=n}shape;pitch;center;range(e){let t=this.shape[e]*this.pitch[e]/2;return[this.center[e]-t,this.center[e]+t]}nearest(e){return e.map((t,n)=>{let[s,r]=this.range(n);return Math.min(Math.max(t,s+1e-4),r-1e-4)})}index(e,t){return Math.floor((t-this.range(e)[0])/this.pitch[e]+1e-6)}middleAt(e){return this.nearest(e).map((t,n)=>{let s=Math.max(this.index(n,t),0);return this.middle(n,Math.min(s,this.shape[n]-1))})}middle(e,t){return this.range(e)[0]+(t+.5)*this.pitch[e]}},Tl=class extends la{constructor(t,n){let[s,r,o]=t.shape_zyx;super([o,r,s],[t.pitch_mm,t.pitch_mm,t.height_mm],t.center_xyz_mm);this.info=t;this.codes=n;this.values=Au(t.bits,t.low,t.high,t.nan)}info;codes;values;at(t){let[n,s,r]=[0,1,2].map(h=>this.index(h,t[h])),[o,a,l]=this.shape;if(n<0||s<0||r<0||n>=o||s>=a||r>=l)return null;let c=this.values[this.codes[(r*a+s)*o+n]];return Number.isNaN(c)?null:c}slice(t,n){let s=this.index(t,n);if(s<0||s>=this.shape[t])return null;let[r,o]=Bn[t],[a,l]=[this.shape[r],this.shape[o]],[c,h]=this.shape,u=[1,c,c*h],d=this.info.bits===16?new Uint16Array(a*l):new Uint8Array(a*l);for(let f=0;f<l;f++){let g=s*u[t]+(l-1-f)*u[o];for(let y=f*a;y<(f+1)*a;y++,g+=u[r])d[y]=this.codes[g]}return{axis:t,width:a,height:l,codes:d,values:this.values,pitch:[this.pitch[r],this.pitch[o]],corner:[this.range(r)[0],this.range(o)[1]]}}};function Au(i,e,t,n){let s=2**i,r=s-(n===null?1:2),o=Float32Array.from({length:s},(a,l)=>e+l/r*(t-e));return n!==null&&(o[n]=Number.NaN),o}var V_=4;function Dp(i,e,t,n){let{response:s,target:r}=i,o=[];s&&o.push(ca("dose",Np(s.info.name),s,e,t)),r&&o.push(n===null?G_(r,e):ca("target","Target",r,e,null)),s&&t&&o.push(W_(s,i,e,t)),s&&r&&ha(s,r)&&(t?o.push(Cu(s,i,e,a=>a>=t())):n!==null&&o.push(Ru(s,r,e,V_*n,"Error",`${s.info.name} − target`)));for(let a of i.others)o.push(ca(a.info.id,H_(a),a,e,null));return o}function ha(i,e){return i.shape.every((t,n)=>t===e.shape[n])}function H_(i){let{name:e,species:t}=i.info,n=t===null?e:`${e}, ${t}`;return Np(n)}function Np(i){return i.charAt(0).toUpperCase()+i.slice(1)}function ca(i,e,t,n,s,r={low:t.info.low,high:t.info.high}){let{info:o}=t,l={low:o.logarithmic?Math.max(r.low,r.high*1e-6):o.kind==="response"?Math.min(r.low,0):r.low,high:r.high,logarithmic:o.logarithmic&&r.high>0,map:rs},c=o.unit===""?"":` ${o.unit}`,h=new WeakMap,u=d=>{let f=h.get(d);return f||h.set(d,f=Pu(d,g=>El(g,l))),f};return{id:i,title:e,picture:(d,f)=>{let g=n.of(t,d,f);return g&&u(g)},value:d=>`${e.toLowerCase()} ${Lu(t.at(d))}${c}`,legend:()=>({scale:l,label:o.unit===""?e:`${e}, ${o.unit}`,mark:s?.()??null})}}function G_(i,e){return{id:"target",title:"Target",picture:(t,n)=>{let s=Mn("--solid"),r=e.of(i,t,n);return r&&Pu(r,o=>Uint32Array.from(o,a=>_r(s,Math.min(Math.max(a,0),1))))},value:t=>`target ${Lu(i.at(t))}`,legend:()=>({keys:[["var(--solid)","part"],["var(--picture)","to stay liquid"]]})}}function W_(i,{bodies:e},t,n){return{id:"print",title:"Print",picture:(s,r)=>{let o=Mn("--solid"),a=n(),l=t.of(i,s,r);return l&&Al(Pu(l,c=>Uint32Array.from(c,h=>h>=a?o:0)),e,t,s,r)},value:s=>{let r=i.at(s);return r===null?"print –":r>=n()?"print solid":"print liquid"},legend:()=>({keys:[["var(--solid)","solid"],["var(--picture)","liquid"],...Up(e)]})}}function Cu(i,{target:e,labels:t,bodies:n},s,r){let o=(a,l)=>a===null?(l??0)>=.5:a===bs.part;return{id:"error",title:"Error",picture:(a,l)=>{let[c,h,u]=[i,e,t].map(R=>R&&s.of(R,a,l));if(!c)return null;let d=c.values.map(R=>Number(r(R))),[f,g,y,p]=[_r(Mn("--solid"),.55),Mn("--missing"),Mn("--excess"),_r(Mn("--solid"),.2)],m=new Uint32Array(c.codes.length),v=R=>R!==null&&R.width===c.width&&R.height===c.height,[T,S]=[v(h)?h:null,v(u)?u:null];for(let R=0;R<m.length;R++){let C=d[c.codes[R]]===1,_=S?S.codes[R]:null;_===bs.outside?m[R]=C?p:0:o(_,T?T.values[T.codes[R]]:null)?m[R]=C?f:g:m[R]=C?y:0}return Al({...c,pixels:m},n,s,a,l)},value:a=>{let l=i.at(a),c=t?t.at(a):null;if(c===bs.outside)return"not counted";let h=l!==null&&r(l);return o(c,e?e.at(a):null)?h?"solid, as it should":"missing":h?"too much":"liquid, as it should"},legend:()=>({keys:[["color-mix(in srgb, var(--solid) 55%, var(--picture))","solid, as it should"],["var(--missing)","missing"],["var(--excess)","too much"],["var(--picture)","liquid, as it should"],...Up(n)]})}}function Ru(i,e,t,n,s,r){let o={low:-n,high:n,logarithmic:!1,map:eo},a=Uint32Array.from({length:256},(l,c)=>eo(c/255));return{id:s.toLowerCase(),title:s,picture:(l,c)=>{let[h,u]=[t.of(i,l,c),t.of(e,l,c)];if(!h||!u||h.codes.length!==u.codes.length)return null;let d=new Uint32Array(h.codes.length);for(let f=0;f<d.length;f++){let g=yr(o,h.values[h.codes[f]]-u.values[u.codes[f]]);d[f]=a[Math.round(255*Math.min(Math.max(g,0),1))]}return{...h,pixels:d}},value:l=>{let[c,h]=[i.at(l),e.at(l)];return`${r} ${Lu(c===null||h===null?null:c-h)}`},legend:()=>({scale:o,label:r,mark:null})}}function Pu(i,e){let{codes:t}=i,n=e(i.values),s=new Uint32Array(t.length);for(let r=0;r<s.length;r++)s[r]=n[t[r]];return{...i,pixels:s}}var no={[Ms.dark]:{color:"--void",text:"body that must stay dark"},[Ms.insert]:{color:"--ink",text:"insert"},[Ms.obstacle]:{color:"--quiet",text:"obstacle"}};function Op(i,e){return no[i?.at(e)??Ms.none]?.text??null}function Up(i){if(!i)return[];let e=new Set(i.codes);return Object.entries(no).filter(([t])=>e.has(Number(t))).map(([,{color:t,text:n}])=>[`var(${t})`,n])}function Al(i,e,t,n,s){let r=e&&t.of(e,n,s);if(!r||r.codes.length!==i.pixels.length)return i;let o=Uint32Array.from({length:256},(a,l)=>no[l]?_r(Mn(no[l].color),.75):0);return r.codes.forEach((a,l)=>{o[a]!==0&&(i.pixels[l]=o[a])}),i}function Lu(i){return ce(i,3)}function Ci(i,e){let t=b("div",{"aria-busy":"true"},b("p.quiet",{},"Unpacking the volumes…"));return e(i).then(n=>t.replaceChildren(n)).catch(n=>t.replaceChildren(vr(Ss(n)))).finally(()=>t.removeAttribute("aria-busy")),t}function vr(i){return b("p.problem",{role:"alert"},i)}function Cl(){let i=vr(""),e=t=>{i.textContent=t,i.hidden=t===null};return e(null),{element:i,say:e}}function Ss(i){return i instanceof Error?i.message:String(i)}function ua(i,e,t,n=null){return b("label",{},b("input",{type:"checkbox",checked:e,change:r=>t(r.target.checked)}),n,i)}var $_=7;function zn(i,e,t,n,s){if(e.length>$_){let a=b("select",{change:()=>n(a.value)},...e.map(([c,h])=>b("option",{value:c},h))),l=()=>a.value=t();return s(l),l(),b("label",{},i,a)}let r=e.map(([a,l])=>({value:a,button:b("button",{type:"button",click:()=>n(a)},l)})),o=()=>r.forEach(({value:a,button:l})=>l.setAttribute("aria-pressed",String(a===t())));return s(o),o(),b("div.choice",{role:"group","aria-label":i},...r.map(({button:a})=>a))}function si(i){if("keys"in i)return b("p.color-keys",{},...i.keys.map(([o,a])=>b("span",{},b("i.tile",{style:`background: ${o}`}),a)));let{scale:e,label:t,mark:n}=i,s=Array.from({length:17},(o,a)=>wl(e.map(a/16))).join(", "),r=n===null||!Number.isFinite(n)?null:(n-e.low)/(e.high-e.low);return b("div.color-scale",{},b("span",{},ce(e.low,3)),b("span.bar",{style:`background: linear-gradient(to right, ${s})`},r!==null&&r>=0&&r<=1&&b("i",{style:`left: ${100*r}%`,title:"gel threshold"})),b("span",{},ce(e.high,3)),b("span.quiet",{},e.logarithmic?`${t}, logarithmic`:t))}function as(i,e,t){let n=i.volumes.filter(s=>s.kind===e);return n.find(s=>t!==""&&s.species===t)??n[0]}function da(i){return i.volumes.filter(({kind:e,species:t})=>e==="response"&&t!==null).map(({species:e})=>e??"")}function Bi({run:i,state:e}){let t=e.get("species");return da(i).includes(t)?t:""}async function fa(i,e){let{run:t,store:n}=i,s=[],r=async f=>{if(!f)return null;try{return await n.volume(f)}catch(g){return s.push(Ss(g)),null}},o=f=>r(as(t,f,e)),a=t.volumes.filter(({kind:f})=>f==="cure_time"||f==="property"),[l,c,h,u,...d]=await Promise.all([o("response"),o("target"),o("labels"),o("bodies"),...a.map(r)]);return{volumes:{response:l,target:c,labels:h,bodies:u,others:d.filter(f=>f!==null)},problems:s}}function Nu({run:i,state:e,store:t},n,s,r,o){let a=b("div"),l=b("div"),c=b("span.color-keys"),h=b("p.quiet",{role:"status"}),u=n.lights[s]?.frames??[],d=u.length-1,f=b("input",{type:"range",min:0,max:d,step:1,"aria-label":"Frame",input:()=>e.set({frame:Number(f.value)})}),g={picture:null,bodies:[]},y=()=>{let v=r?.()??null,T=Math.min(e.get("frame"),d);f.value=String(T);let S=v===null?u[T]??null:q_(u,v),R=S!==null&&v!==null&&n.is_round?Y_(S,v):S;a.replaceChildren(Z_(n,R?.rays??[],g.picture)),l.replaceChildren(K_(n,R?.rays??[],g.bodies));let C=R!==null&&v!==null&&Iu(R.angle_deg,v)>.05,_=R===null?"":`Light from ${ce(R.angle_deg,4)}°${C?", the nearest frame whose rays the page has":""}.`;h.textContent=`${_}${X_(n)}`.trim()};y();let p=async()=>{g=await J_(i,t,e.get("at")?.[2]??null),c.replaceChildren(...g.bodies.map(({color:v,text:T})=>pa(v,T))),y()};p().catch(()=>{});let m=[e.on(["frame"],y),e.on(["at"],()=>{p().catch(()=>{})})];return o.addEventListener("abort",()=>m.forEach(v=>v())),b("div.paths",{},b("h3",{},"Where the light goes"),h,r===null&&d>0&&b("div.path-frame",{},b("label",{},"Frame",f)),b("div.path-views",{},b("figure",{},b("figcaption",{},"From above"),a),b("figure",{},b("figcaption",{},"From the side, light from the left"),l,b("p.color-keys",{},pa("--void","light in the resin"),pa("--quiet","light outside"),pa("--solid","part"),n.lit_radius_mm!==null&&pa("--accent","radius that every frame lights"),c))))}function pa(i,e){return b("span",{},b("i.stroke",{style:`background: var(${i})`}),e)}function X_({lit_radius_mm:i,part_radius_mm:e}){if(i===null)return"";let[t,n]=[ce(i,3),ce(e,3)];return i>=e?` Every frame lights all within ${t} mm of the axis.`:` Every frame lights only what lies within ${t} mm of the axis, but the part's sides reach out to ${n} mm.`}function q_(i,e){return i.reduce((t,n)=>t!==null&&Iu(t.angle_deg,e)<=Iu(n.angle_deg,e)?t:n,null)}function Y_({angle_deg:i,rays:e},t){let n=(t-i)*Math.PI/180,[s,r]=[Math.cos(n),Math.sin(n)];return{angle_deg:t,rays:e.map(o=>({...o,points:o.points.map(([a,l,c])=>[s*a-r*l,r*a+s*l,c])}))}}function Iu(i,e){let t=Math.abs(i-e)%360;return Math.min(t,360-t)}function Z_(i,e,t){let n=Math.max(...i.walls.flatMap(({points:r})=>r.map(([o,a])=>Math.hypot(o,a))),i.part_radius_mm)*1.22,s=Fp([-n,n],[-n,n],"Light path from above");for(let r of i.walls)s.append(ma(r.points,"wall",r.name));t?s.append(wt("image",{href:t.url,x:t.left,y:-t.top,width:t.width,height:t.height,preserveAspectRatio:"none"})):s.append(wt("circle",{class:"part",r:i.part_radius_mm}));for(let r of i.obstacles)s.append(ma(r.points,"obstacle",r.name));return i.lit_radius_mm!==null&&s.append(wt("circle",{class:"lit",r:i.lit_radius_mm},wt("title",{},"radius that every frame lights"))),s.append(...kp(e.map(r=>({points:r.points.map(([o,a])=>[o,a]),from:r.resin_from})),n)),s}function K_(i,e,t){let n=e[e.length>>1]?.points??[],[s,r]=[n[0]??[-1,0,0],n[n.length-1]??[1,0,0]],o=Math.hypot(r[0]-s[0],r[1]-s[1])||1,[a,l]=[(r[0]-s[0])/o,(r[1]-s[1])/o],c=([p,m])=>p*a+m*l,h=Math.max(...i.walls.flatMap(({points:p})=>p.map(([m,v])=>Math.hypot(m,v))),i.part_radius_mm)*1.22,[u,d]=i.z_mm,f=.25*(d-u)+.05*h,g=Fp([-h,h],[u-f,d+f],"Light path from the side");for(let p of i.walls){let m=p.points.map(c),[v,T]=[Math.min(...m),Math.max(...m)],[S,R]=p.height_mm??[u-2*f,d+2*f];g.append(ma([[v,S],[T,S],[T,R],[v,R]],"wall",p.name))}let y=i.part_radius_mm;g.append(ma([[-y,u],[y,u],[y,d],[-y,d]],"part","part"));for(let{columns:p,z:m,color:v,text:T}of t){let S=p.map(c),[R,C]=[Math.min(...S),Math.max(...S)],_=ma([[R,m[0]],[C,m[0]],[C,m[1]],[R,m[1]]],"body",T);_.setAttribute("style",`color: var(${v})`),g.append(_)}if(i.lit_radius_mm!==null)for(let p of[-i.lit_radius_mm,i.lit_radius_mm])g.append(wt("line",{class:"lit",x1:p,x2:p,y1:-d-f,y2:-u+f}));return g.append(...kp(e.map(p=>({points:p.points.map(m=>[c(m),m[2]]),from:p.resin_from})),h)),g}function Fp(i,e,t){return wt("svg",{class:"path-view",viewBox:`${i[0]} ${-e[1]} ${i[1]-i[0]} ${e[1]-e[0]}`,role:"img","aria-label":t})}function ma(i,e,t){return wt("path",{class:e,d:`${Du(i)}Z`},wt("title",{},t))}function Du(i){return`M${i.map(([e,t])=>`${e.toFixed(4)},${(-t).toFixed(4)}`).join("L")}`}function kp(i,e){return i.flatMap(({points:t,from:n})=>{let s=t.slice(0,n+1);return s.length>1&&(s[0]=j_(s[0],s[1],e)),[wt("path",{class:"ray",d:Du(s)}),t.length>n+1&&wt("path",{class:"ray resin",d:Du(t.slice(n))})].filter(r=>r!==!1)})}function j_([i,e],[t,n],s){let r=Math.abs(i)>Math.abs(e)?Math.abs(i):Math.abs(e);if(r<=s)return[i,e];let o=Math.max(Math.abs(t),Math.abs(n)),a=r>o?Math.min((r-s)/(r-o),1):0;return[i+a*(t-i),e+a*(n-e)]}async function J_(i,e,t){let[n,s]=await Promise.all(["target","bodies"].map(async r=>{let o=as(i,r,"");return o?e.volume(o):null}));return{picture:n&&Q_(n,s,t),bodies:s?ey(s):[]}}function Q_(i,e,t){let[n,s]=i.range(2),r=i.nearest([0,0,t??(n+s)/2])[2],o=i.slice(2,r);if(!o)return null;let a=Mn("--solid"),l=i.info.high,c=Uint32Array.from(o.values,g=>_r(a,Math.min(Math.max(g/l,0),1)*.75)),h=new Uint32Array(o.codes.length);for(let g=0;g<h.length;g++)h[g]=c[o.codes[g]];Al({...o,pixels:h},e,{of:(g,y,p)=>g.slice(y,p)},2,r);let u=document.createElement("canvas");[u.width,u.height]=[o.width,o.height],u.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(h.buffer),o.width,o.height),0,0);let[d,f]=Bn[2];return{url:u.toDataURL(),left:i.range(d)[0],top:i.range(f)[1],width:o.width*o.pitch[0],height:o.height*o.pitch[1]}}function ey(i){let[e,t,n]=i.shape;return Object.entries(no).flatMap(([s,{color:r,text:o}])=>{let a=[],l=new Set;for(let u=0;u<e*t;u++){let d=!1;for(let f=0;f<n;f++)i.codes[f*e*t+u]===Number(s)&&(d=!0,l.add(f));d&&a.push([i.middle(0,u%e),i.middle(1,Math.floor(u/e))])}if(a.length===0)return[];let c=i.pitch[2]/2,h=[i.middle(2,Math.min(...l))-c,i.middle(2,Math.max(...l))+c];return[{columns:a,z:h,color:r,text:o}]})}var Hp={id:"film",title:"Patterns and light",render:i=>{let{run:e,state:t,gone:n}=i,s=e.films.length>0?e.films.map(({light:u})=>u):(e.scene?.lights??[]).map(({name:u})=>u);if(s.length===0)return null;let r=()=>Math.min(t.get("light"),s.length-1),o=b("div"),a=new AbortController,l=()=>{a.abort(),a=new AbortController;let{signal:u}=a,d=e.films.length===0&&e.scene?Nu(i,e.scene,r(),null,u):null;o.replaceChildren(d??Ci(i,()=>ny(i,r(),u)))},c=t.on(["light"],()=>{t.set({frame:0,row:null}),l()});n.addEventListener("abort",()=>{c(),a.abort()}),l();let h=s.map((u,d)=>[String(d),u||`light ${d+1}`]);return b("div",{},h.length>1&&zn("Light",h,()=>String(r()),u=>t.set({light:Number(u)}),u=>n.addEventListener("abort",t.on(["light"],u))),o)}},ty=8;async function ny({run:i,state:e,store:t},n,s){let r=i.films[n],{values:o}=await t.film(r),a=new Uu({info:r,values:o}),l=r.frames-1,c=()=>Math.min(e.get("frame"),l),h=()=>Math.min(e.get("row")??r.rows>>1,r.rows-1),u=b("output"),d=b("input",{type:"range",min:0,max:l,step:1,"aria-label":"Frame",input:A=>e.set({frame:Number(A.target.value)})}),f=b("input",{type:"range",min:0,max:r.rows-1,step:1,"aria-label":"Row of the sinogram",input:A=>e.set({row:Number(A.target.value)})}),g=b("output.quiet"),y=b("output.quiet"),p=b("input",{type:"range",min:0,max:5,step:.25,value:0,"aria-label":"Stretch of the brightness"}),m=b("button",{type:"button","aria-label":"Play the film"},"Play"),v=b("div.color-legend"),T=()=>{let[A,z]=[c(),h()];[d.value,f.value]=[String(A),String(z)];let O=`frame ${A*r.every+1} of ${r.of[0]}, ${Ou(r.angles_deg[A])}`;u.textContent=O,d.setAttribute("aria-valuetext",O),a.sinogram.setAttribute("aria-valuenow",String(A)),a.sinogram.setAttribute("aria-valuetext",O),g.textContent=`row ${z*r.binned+1} of ${r.of[1]} from the top`,a.draw(A,z)},S=()=>{a.gain=2**Number(p.value),y.textContent=a.gain===1?"as shown":`${ce(a.gain,3)} ×`,v.replaceChildren(si({scale:{low:0,high:r.full_scale/a.gain,logarithmic:!1,map:Tu},label:"pattern value",mark:null})),a.draw(c(),h())};p.addEventListener("input",S,{signal:s}),a.choose=A=>e.set({frame:Math.min(Math.max(A,0),l)}),a.chooseRow=A=>e.set({row:Math.min(Math.max(A,0),r.rows-1)}),iy(m,r,s,()=>e.set({frame:(c()+1)%r.frames}));let R=e.on(["frame","row"],T);s.addEventListener("abort",()=>{R(),a.end()}),T(),S();let C=[r.every>1&&`every ${sy(r.every)} frame`,r.binned>1&&`means of ${r.binned} × ${r.binned} pixels`].filter(Boolean).join(", "),_=i.scene&&Nu({run:i,state:e,store:t},i.scene,n,()=>r.angles_deg[c()],s);return b("div.film",{},b("p.quiet",{},`${r.of[0]} frames of ${r.of[2]} × ${r.of[1]} pixels.${C?` Shown: ${C}.`:""} Click in the sinogram to choose a frame, in the frame to choose the row of the sinogram.`),b("div.film-views",{},b("figure",{},b("figcaption",{},b("span",{},"Frame"),u),a.frame),b("figure",{},b("figcaption",{},b("span",{},"Sinogram"),g),a.sinogram,b("div.film-axis.quiet",{},b("span",{},Ou(r.angles_deg[0])),b("span",{},"angle of the frame"),b("span",{},Ou(r.angles_deg[l]))))),b("div.film-controls",{},m,b("label",{},"Frame",d),b("label",{},"Row",f),b("label",{},"Stretch",p,y),v),_)}var Uu=class{constructor(e){this.film=e;let{info:t}=e;this.frame.style.aspectRatio=`${t.columns*t.pitch_mm[0]} / ${t.rows*t.pitch_mm[1]}`,this.sinogram.setAttribute("aria-valuemax",String(t.frames-1));for(let s of[this.frame,this.sinogram])this.watcher.observe(s);let n=(s,r)=>{let o=a=>{if(a.buttons!==1)return;let l=s.getBoundingClientRect();r((a.clientX-l.left)/l.width,(a.clientY-l.top)/l.height)};s.addEventListener("pointerdown",o),s.addEventListener("pointermove",o)};n(this.sinogram,s=>this.choose(Math.floor(s*t.frames))),n(this.frame,(s,r)=>this.chooseRow(Math.floor(r*t.rows))),this.sinogram.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10,Home:-t.frames,End:t.frames};s.key in r&&(s.preventDefault(),this.choose(this.shown[0]+r[s.key]))})}film;frame=b("canvas");sinogram=b("canvas",{tabindex:0,role:"slider","aria-label":"Sinogram: arrow keys choose the frame","aria-valuemin":0});gain=1;choose=()=>{};chooseRow=()=>{};image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.draw(...this.shown));shown=[0,0];painted="";end(){this.watcher.disconnect()}draw(e,t){this.shown=[e,t],this.drawFrame(e,t),this.drawSinogram(e,t)}drawFrame(e,t){let{info:n,values:s}=this.film,r=zp(this.frame);if(!r)return;let o=n.rows*n.columns,a=document.createElement("canvas");Bp(a,n.columns,n.rows,this.palette(),s.subarray(e*o,(e+1)*o)),r.drawImage(a,0,0,r.canvas.width,r.canvas.height),Vp(r,"y",(t+.5)/n.rows)}drawSinogram(e,t){let{info:n,values:s}=this.film,r=zp(this.sinogram);if(!r)return;let o=`${t} ${this.gain}`;if(this.painted!==o){this.painted=o;let a=new Uint8Array(n.frames*n.columns);for(let l=0;l<n.frames;l++){let c=(l*n.rows+t)*n.columns;for(let h=0;h<n.columns;h++)a[h*n.frames+l]=s[c+h]}Bp(this.image,n.frames,n.columns,this.palette(),a)}r.drawImage(this.image,0,0,r.canvas.width,r.canvas.height),Vp(r,"x",(e+.5)/n.frames)}palette(){return Uint32Array.from({length:256},(e,t)=>Tu(t/255*this.gain))}};function Bp(i,e,t,n,s){let r=new Uint32Array(e*t);for(let o=0;o<r.length;o++)r[o]=n[s[o]];[i.width,i.height]=[e,t],i.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(r.buffer),e,t),0,0)}function zp(i){let e=window.devicePixelRatio||1,[t,n]=[Math.round(i.clientWidth*e),Math.round(i.clientHeight*e)];if(t===0||n===0)return null;(i.width!==t||i.height!==n)&&([i.width,i.height]=[t,n]);let s=i.getContext("2d");return s&&(s.imageSmoothingEnabled=!1),s}function Vp(i,e,t){let{width:n,height:s}=i.canvas,r=Math.max(Math.round(window.devicePixelRatio||1),1);for(let[o,a]of[["rgb(0 0 0 / 0.5)",r],["rgb(255 255 255 / 0.8)",0]])i.fillStyle=o,e==="x"?i.fillRect(Math.round(t*n)+a,0,r,s):i.fillRect(0,Math.round(t*s)+a,n,r)}function iy(i,e,t,n){let s=0,r=()=>{window.clearInterval(s),s=0,i.textContent="Play",i.setAttribute("aria-label","Play the film")};i.addEventListener("click",()=>{if(s!==0)return r();s=window.setInterval(n,Math.max(1e3*ty/e.frames,40)),i.textContent="Pause",i.setAttribute("aria-label","Pause the film")}),t.addEventListener("abort",r)}function Ou(i){return`${ce(i,4)}°`}function sy(i){return i===2?"2nd":i===3?"3rd":`${i}th`}var ry=[[],[3,0],[0,1],[3,1],[1,2],[3,0,1,2],[0,2],[3,2],[2,3],[2,0],[0,1,2,3],[2,1],[1,3],[1,0],[0,3],[]];function Rl(i,e){let{width:t,height:n,codes:s,values:r}=i,o=e-1e6,a=(h,u)=>{if(h<0||u<0||h>=t||u>=n)return o;let d=r[s[u*t+h]];return Number.isNaN(d)?o:d},l=new Float32Array(4096),c=0;for(let h=-1;h<n;h++){let[u,d]=[a(-1,h),a(-1,h+1)];for(let f=-1;f<t;f++){let[g,y]=[a(f+1,h),a(f+1,h+1)],p=(u>=e?1:0)|(g>=e?2:0)|(y>=e?4:0)|(d>=e?8:0);if(p!==0&&p!==15){if(c+8>l.length){let m=new Float32Array(2*l.length);m.set(l),l=m}for(let m of ry[p]){let[v,T]=m===0?[u,g]:m===1?[g,y]:m===2?[d,y]:[u,d],S=(e-v)/(T-v);l[c++]=f+.5+(m===1?1:m===3?0:S),l[c++]=h+.5+(m===0?0:m===2?1:S)}}u=g,d=y}}return l.slice(0,c)}function Fu(i,e){let n=(i.report?.species??[]).find(s=>s.name===e)??i.report;return{evaluation:n?.evaluation??null,exposure:n?.exposure??null,window:n?.objective_window??null}}function so(i){let e=i.report?.evaluation,t=e?.band_half_width??i.band??null;return t===0?e?.rms_error??null:t}function Pl(i,e,t,n){let{evaluation:s,exposure:r,window:o}=Fu(i,e),a=t&&n?ly(t,n):null,l=s?.gel_threshold??null,c=l??a?.best()??null,h=t?.info.high??s?.histogram?.range?.[1]??null;if(c===null||h===null||h<=0)return null;let u=oy(s?.iou_curve??a?.curve()??[],[c,s?.iou??null]),d=r?.threshold?.best??null,f=s?.histogram,g=r?.threshold?[r.threshold.low,r.threshold.high]:null,y=t?.info.name??"dose",p=y==="dose";return{quantity:y,reported:c,isOfReport:l!==null,reduced:t?.info.reduced??1,high:Math.max(h,f?.range?.[1]??0,c),histogram:f?{low:f.range[0],high:f.range[1],part:f.part,void:f.void}:a?.histogram??null,curve:u,nearly:g,objective:o,tolerance:r?.tolerance??null,iou:m=>(m===l?s.iou:null)??ay(u,m)??a?.iou(m)??null,percent:m=>d===null||m<=0||!(p||m===d)?null:100*d/m,tooMuch:m=>(m===l?s.over_mm3:null)??a?.tooMuch(m)??null,missing:m=>(m===l?s.under_mm3:null)??a?.missing(m)??null}}function oy(i,e){let[t,n]=e;return n==null?i:[...i.filter(([s])=>s!==t),[t,n]].sort((s,r)=>s[0]-r[0])}function ay(i,e){if(i.length<2)return null;if(e<=i[0][0])return i[0][1];let t=i.findIndex(([a])=>a>=e);if(t<0)return i[i.length-1][1];let[[n,s],[r,o]]=[i[t-1],i[t]];return s+(e-n)/(r-n)*(o-s)}var io=120;function ly(i,e){if(i.codes.length!==e.codes.length)return null;let{values:t}=i,n=t.length,s=[new Float64Array(n+1),new Float64Array(n+1)];for(let p=0;p<i.codes.length;p++){let m=e.codes[p];m!==bs.outside&&s[m===bs.part?0:1][i.codes[p]+1]++}for(let p of s)for(let m=1;m<=n;m++)p[m]+=p[m-1];let r=i.pitch[0]*i.pitch[1]*i.pitch[2],o=Number.isNaN(t[n-1])?n-1:n,a=p=>{let[m,v]=[0,o];for(;m<v;){let T=m+v>>1;t[T]>=p?v=T:m=T+1}return m},[l,c]=[s[0][o],s[1][o]],h=p=>{let m=a(p);return{right:l-s[0][m],wrong:c-s[1][m]}},{high:u}=i.info,d=p=>Array.from({length:io},(m,v)=>p[a(u*(v+1)/io)]-p[a(u*v/io)]),f=p=>{let{right:m,wrong:v}=h(p);return l+v>0?m/(l+v):null},g=()=>Array.from({length:io+1},(p,m)=>[u*m/io,f(u*m/io)??0]),y=()=>g().slice(1).reduce((p,m)=>m[1]>p[1]?m:p);return{curve:g,best:()=>l===0?null:y()[1]>0?y()[0]:u,histogram:{low:0,high:u,part:d(s[0]),void:d(s[1])},iou:f,tooMuch:p=>h(p).wrong*r,missing:p=>(l-h(p).right)*r}}var cy={2:"from +z",1:"from −y",0:"from +x"},hy={2:"Top view, x–y",1:"Front view, x–z",0:"Side view, y–z"},Wp=24,uy=.62,dy=3,Zs=class{constructor(e){this.options=e;let{state:t,signal:n,grid:s}=e;this.center=[...s.center];let r=t.on(["at"],()=>this.redraw(!1));n.addEventListener("abort",r);let o=()=>this.redraw(!0);window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",o,{signal:n})}options;element=b("div.planes");views=[];zoom=1;center;show(e){this.views.forEach(u=>u.end()),this.views=e.map(u=>new ku(this,u));let{grid:t}=this.options,n=e.map(({axis:u})=>ws(t,Bn[u][0])),s=n.map(u=>`minmax(0, ${(u/Math.max(...n)).toFixed(4)}fr)`);this.element.style.setProperty("--columns",s.join(" "));let[r,o,a]=[0,1,2].map(u=>ws(t,u)),l=e.length===3&&new Set(e.map(({axis:u})=>u)).size===3;this.element.classList.toggle("flat",l&&a<uy*Math.min(r,o));let[c,h]=Bn[e[0]?.axis??2];this.element.classList.toggle("pairs",!l&&e.length===4&&ws(t,c)>1.5*ws(t,h)),this.element.replaceChildren(...this.views.map(u=>u.element))}redraw(e){for(let t of this.views)t.redraw(e)}at(){let{state:e,grid:t}=this.options;return t.nearest(e.get("at")??t.center)}moveTo(e){let{state:t,grid:n}=this.options;t.set({at:n.nearest(this.at().map((s,r)=>e[r]??s))})}zoomBy(e,t){let n=Math.min(Math.max(this.zoom*e,1),Wp),s=1-this.zoom/n;this.center=this.center.map((r,o)=>r+(t[o]-r)*s),this.zoom=n,n===1&&(this.center=[...this.options.grid.center]),this.keepWithin(),this.redraw(!1)}panBy(e,t){this.center[e]+=t,this.keepWithin(),this.redraw(!1)}keepWithin(){let{grid:e}=this.options;this.center=this.center.map((t,n)=>{let[s,r]=e.range(n),o=(r-s)/2/this.zoom;return Math.min(Math.max(t,s+o),r-o)})}};function ws(i,e){return i.range(e)[1]-i.range(e)[0]}var fy=90,Ll=38,py=56,Gp="rgb(0 0 0 / 0.5)",ku=class{constructor(e,t){this.planes=e;this.shown=t;let{grid:n}=e.options,{axis:s}=t,r=t.title??hy[s],o=n.shape[s]-1;this.slider=b("input",{type:"range",min:0,max:o,step:1,"aria-label":`${r}: ${os[s]} of the slice`}),this.canvas.setAttribute("aria-label",`${r}: slice along ${os[s]}`),this.canvas.setAttribute("aria-valuemin","0"),this.canvas.setAttribute("aria-valuemax",String(o));let[a,l]=Bn[s],c=ws(n,a);this.canvas.style.aspectRatio=`${c} / ${Math.min(ws(n,l),dy*c)}`,this.element=b("figure.plane",{},b("figcaption",{},b("span",{title:`seen ${cy[s]}`},r),this.place),this.canvas,this.slider),this.listen(),this.watcher.observe(this.canvas)}planes;shown;element;canvas=b("canvas",{tabindex:0,role:"slider","aria-orientation":"horizontal"});slider;place=b("output.place");image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.redraw(!1));picture=null;outlines=[];painted=-1;frame=0;turned=0;end(){this.watcher.disconnect(),cancelAnimationFrame(this.frame)}redraw(e){e&&(this.painted=-1),this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0,this.draw()}))}get index(){let{grid:e}=this.planes.options,{axis:t}=this.shown;return Math.min(Math.max(e.index(t,this.planes.at()[t]),0),e.shape[t]-1)}step(e){let{grid:t}=this.planes.options,{axis:n}=this.shown;this.planes.moveTo({[n]:t.middle(n,this.index+e)})}paint(){let{grid:e}=this.planes.options,{axis:t,layer:n,outlines:s}=this.shown,r=this.index;if(this.painted===r)return;this.painted=r;let o=e.middle(t,r),a=this.picture;if(this.picture=n.picture(t,o),this.outlines=s?.(t,o)??[],this.picture&&this.picture!==a){let{width:c,height:h,pixels:u}=this.picture;[this.image.width,this.image.height]=[c,h],this.image.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(u.buffer),c,h),0,0)}let l=`${os[t]} = ${Bu(o,e.pitch[t])} mm`;this.place.textContent=`${l} · ${r+1} of ${e.shape[t]}`,this.slider.value=String(r),this.slider.setAttribute("aria-valuetext",l),this.canvas.setAttribute("aria-valuenow",String(r)),this.canvas.setAttribute("aria-valuetext",l)}draw(){this.paint();let e={width:this.canvas.clientWidth,height:this.canvas.clientHeight},t=this.canvas.getContext("2d");if(!t||e.width===0)return;let n=window.devicePixelRatio||1,[s,r]=[Math.round(e.width*n),Math.round(e.height*n)];(this.canvas.width!==s||this.canvas.height!==r)&&([this.canvas.width,this.canvas.height]=[s,r]),t.setTransform(1,0,0,1,0,0),t.clearRect(0,0,s,r),t.imageSmoothingEnabled=!1;let{x:o,y:a}=this.scale(s,r);if(this.picture){let{corner:c,pitch:h}=this.picture,[u,d]=[o(c[0]),a(c[1])];t.drawImage(this.image,u,d,o(c[0]+this.picture.width*h[0])-u,a(c[1]-this.picture.height*h[1])-d)}let l=getComputedStyle(this.canvas);for(let c of this.outlines)my(t,c,o,a,n,l.getPropertyValue(c.color).trim()||c.color);this.cross(t,o,a,s,r,n),this.ruler(t,s,r,n),this.arrows(t,s,r,n)}scale(e,t){let{grid:n}=this.planes.options,{zoom:s,center:r}=this.planes,[o,a]=Bn[this.shown.axis],l=Math.min(e/ws(n,o),t/ws(n,a))*s;return{perMm:l,x:c=>e/2+(c-r[o])*l,y:c=>t/2-(c-r[a])*l,back:(c,h)=>{let u=this.planes.at(),d=[u[0],u[1],u[2]];return d[o]=r[o]+(c-e/2)/l,d[a]=r[a]-(h-t/2)/l,d}}}cross(e,t,n,s,r,o){let a=this.planes.at(),[l,c]=Bn[this.shown.axis],[h,u]=[Math.round(t(a[l])),Math.round(n(a[c]))];for(let[d,f]of[["rgb(0 0 0 / 0.35)",o],["rgb(255 255 255 / 0.65)",0]])e.fillStyle=d,e.fillRect(h+f,0,o,r),e.fillRect(0,u+f,s,o)}ruler(e,t,n,s){if(n<fy*s)return;let{perMm:r}=this.scale(t,n),o=gy(.3*t/r),[a,l]=[12*s,n-12*s],c=o<1?`${Math.round(o*1e3)} µm`:`${o} mm`;e.font=`${11*s}px system-ui, sans-serif`;let h=Math.max(o*r,e.measureText(c).width);e.fillStyle=Gp,e.beginPath(),e.roundRect(a-6*s,l-20*s,h+12*s,27*s,5*s),e.fill(),e.fillStyle="#fff",e.fillRect(a,l-s,o*r,2*s),e.fillText(c,a,l-6*s)}arrows(e,t,n,s){if(Math.min(t,n)<py*s)return;let[r,o]=Bn[this.shown.axis];e.save(),e.translate(t-(Ll+5)*s,n-5*s),e.scale(s,s),e.fillStyle=Gp,e.beginPath(),e.roundRect(0,-Ll,Ll,Ll,5),e.fill(),[e.strokeStyle,e.fillStyle,e.lineWidth]=["#fff","#fff",1.25];let[a,l,c]=[8,26,3];e.beginPath(),e.moveTo(l-c,-a-c),e.lineTo(l,-a),e.lineTo(l-c,-a+c),e.moveTo(l,-a),e.lineTo(a,-a),e.lineTo(a,-l),e.moveTo(a-c,-l+c),e.lineTo(a,-l),e.lineTo(a+c,-l+c),e.stroke(),e.font="11px system-ui, sans-serif",e.textAlign="center",e.fillText(os[r],l+6,-a+3),e.fillText(os[o],a,-l-4),e.restore()}pointOf(e){let t=this.canvas.getBoundingClientRect();return this.scale(t.width,t.height).back(e.clientX-t.left,e.clientY-t.top)}listen(){let{planes:e,canvas:t}=this,{signal:n,hover:s}=e.options,[r,o]=Bn[this.shown.axis];this.slider.addEventListener("input",()=>this.step(Number(this.slider.value)-this.index),{signal:n}),t.addEventListener("keydown",l=>this.key(l),{signal:n}),t.addEventListener("wheel",l=>{let c=l.ctrlKey||l.metaKey;if(!c&&document.activeElement!==t)return;if(l.preventDefault(),c){e.zoomBy(Math.exp(-l.deltaY/300),this.pointOf(l));return}this.turned+=l.deltaMode===WheelEvent.DOM_DELTA_PIXEL?l.deltaY/40:l.deltaY;let h=Math.trunc(this.turned);this.turned-=h,h!==0&&this.step(-h)},{signal:n,passive:!1});let a=l=>{let c=this.pointOf(l);e.moveTo({[r]:c[r],[o]:c[o]})};t.addEventListener("click",a,{signal:n}),t.addEventListener("dblclick",l=>e.zoomBy(l.shiftKey?.5:2,this.pointOf(l)),{signal:n}),t.addEventListener("pointermove",l=>{if(s?.(this.pointOf(l),this.shown.layer),l.buttons===1&&l.pointerType==="mouse")if(l.shiftKey){let{perMm:c}=this.scale(t.clientWidth,t.clientHeight);e.panBy(r,-l.movementX/c),e.panBy(o,l.movementY/c)}else a(l)},{signal:n}),t.addEventListener("pointerleave",()=>s?.(null,this.shown.layer),{signal:n})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{planes:t}=this,{grid:n}=t.options,{axis:s}=this.shown,[r,o]=Bn[s],a=Math.max(Math.round(n.shape[s]/10),2),l=ws(n,r)/t.zoom*.1,c=e.shiftKey?{ArrowLeft:()=>t.panBy(r,-l),ArrowRight:()=>t.panBy(r,l),ArrowDown:()=>t.panBy(o,-l),ArrowUp:()=>t.panBy(o,l)}:{ArrowUp:()=>this.step(1),ArrowRight:()=>this.step(1),ArrowDown:()=>this.step(-1),ArrowLeft:()=>this.step(-1),PageUp:()=>this.step(a),PageDown:()=>this.step(-a),Home:()=>this.step(-this.index),End:()=>this.step(n.shape[s]-1-this.index)},h={"+":()=>t.zoomBy(1.5,t.at()),"=":()=>t.zoomBy(1.5,t.at()),"-":()=>t.zoomBy(1/1.5,t.at()),0:()=>t.zoomBy(1/Wp,t.at())},u=c[e.key]??h[e.key];u&&(e.preventDefault(),u())}};function my(i,{segments:e,slice:t},n,s,r,o){let[a,l]=[n(t.corner[0]),s(t.corner[1])],[c,h]=[n(t.corner[0]+t.pitch[0])-a,s(t.corner[1]-t.pitch[1])-l];i.beginPath();for(let u=0;u<e.length;u+=4)i.moveTo(a+e[u]*c,l+e[u+1]*h),i.lineTo(a+e[u+2]*c,l+e[u+3]*h);i.lineCap="round",i.lineWidth=3*r,i.strokeStyle="rgb(0 0 0 / 0.4)",i.stroke(),i.lineWidth=1.6*r,i.strokeStyle=o,i.stroke()}function gy(i){let e=10**Math.floor(Math.log10(i)),t=[5,2,1].find(n=>n*e<=i*(1+1e-9))??1;return Number((t*e).toPrecision(3))}function Bu(i,e){return i.toFixed(Math.max(3,Math.ceil(1-Math.log10(e)))).replace("-","−")}var $p={id:"in-time",title:"How the print grows",render:i=>{let e=i.run.volumes.filter(({kind:l})=>l==="cure_time");if(e.length===0)return null;let t=0,n=new AbortController,s=b("div"),r=new EventTarget,o=l=>{n.abort(),n=new AbortController,t=l,s.replaceChildren(Ci(i,()=>_y(i,e[l],n.signal))),r.dispatchEvent(new Event("change"))};i.gone.addEventListener("abort",()=>n.abort()),o(0);let a=e.map(({species:l,name:c},h)=>[String(h),l??c]);return b("div",{},a.length>1&&zn("Resin",a,()=>String(t),l=>o(Number(l)),l=>r.addEventListener("change",l)),s)}},xy=10,zu=500;async function _y({run:i,state:e,store:t},n,s){let r=await t.volume(n),o=async $=>{let B=as(i,$,n.species??"");return B?t.volume(B):null},[a,l,c]=await Promise.all(["target","labels","bodies"].map($=>o($).catch(()=>null))),h=yy(i.report,n.species),u=n.high,d=h?.best_s??null,f=()=>Math.min(e.get("time")??d??u,u),g=vy(r),y={low:Math.min(n.low,u),high:u,logarithmic:!1,map:rs},p={id:"growth",title:"Time of cure",picture:($,B)=>{let oe=r.slice($,B);if(!oe)return null;let K=f(),Q=El(oe.values,y).map((de,fe)=>oe.values[fe]<=K?de:0),ie=new Uint32Array(oe.codes.length);for(let de=0;de<ie.length;de++)ie[de]=Q[oe.codes[de]];return{...oe,pixels:ie}},value:$=>{let B=r.at($);return B===null?"stays liquid":`solid after ${Ai(B)}`},legend:()=>({scale:y,label:"solid after, s",mark:null})},m=l??a,v=m&&ha(m,r)&&so(i)===null?Cu(r,{target:a,labels:l,bodies:c},{of:($,B,oe)=>$.slice(B,oe)},$=>$<=f()):null,T=()=>v&&e.get("growth")===v.id?v:p,S=b("p.readout"),R=b("div.color-legend"),C=new Zs({state:e,grid:r,signal:s,hover:$=>{S.textContent=T().value($??C.at())}}),_=($,B)=>{let oe=T()===p?a?.slice($,B):null;return oe?[{slice:oe,segments:Rl(oe,.5),color:"--outline-growth"}]:[]},A=()=>{C.show([2,1,0].map($=>({axis:$,layer:T(),outlines:_}))),R.replaceChildren(si(T().legend()))};A();let z=b("input",{type:"range",min:0,max:zu,step:1,"aria-label":"Time",input:()=>e.set({time:Number(z.value)/zu*u})}),O=b("output"),D=()=>{let $=f();z.value=String(Math.round($/u*zu)),z.setAttribute("aria-valuetext",Ai($));let B=by(h?.curves?.seconds,h?.curves?.jaccard,$);O.replaceChildren(b("b",{},Ai($)),`  ${ce(g($),3)} mm³ solid${B===null?"":`, IoU ${ce(B,3)}`}`),C.redraw(!0),S.textContent=T().value(C.at())},G=[e.on(["time","at"],D),e.on(["growth"],()=>[A(),D()])],H=b("button",{type:"button"},"Play"),N=0,W=()=>{window.clearInterval(N),N=0,H.textContent="Play"};return H.addEventListener("click",()=>{if(N!==0)return W();H.textContent="Pause",f()>=u&&e.set({time:0}),N=window.setInterval(()=>{e.set({time:Math.min(f()+.05/xy*u,u)}),f()>=u&&W()},50)}),s.addEventListener("abort",()=>{G.forEach($=>$()),W()}),D(),b("div",{},b("p.quiet",{},`What is solid at a moment, colored by when it became solid. The line is the part’s outline.${v?" The error shows what is missing and what is too much at that moment.":""}`),v&&zn("Shown",[["",p.title],[v.id,v.title]],()=>e.get("growth"),$=>e.set({growth:$}),$=>s.addEventListener("abort",e.on(["growth"],$))),b("div.time-controls",{},H,z,O,d!==null&&b("button",{type:"button",click:()=>e.set({time:null})},`Best moment: ${Ai(d)}`)),C.element,b("div.below-planes",{},S,R))}function yy(i,e){let t=i?.time??[];return t.find(n=>n.name===e)??t[0]??null}function vy(i){let e=new Float64Array(i.values.length);for(let n of i.codes)e[n]++;let t=i.pitch[0]*i.pitch[1]*i.pitch[2];return n=>t*e.reduce((s,r,o)=>i.values[o]<=n?s+r:s,0)}function by(i,e,t){if(!i||!e)return null;let n=i.findIndex(s=>s>t+1e-9);return n<0&&(n=i.length),n===0?null:e[n-1]??null}var My="This page shows what there was last; it cannot be loaded again.";function Xp(i,e){if(i.served===null)return null;let{served:t}=i,n=b("div.live",{role:"status"}),s=new Map,r=l=>{let c=s.get(l);return c||(c=new Vu(i.runs[l].name,()=>fetch(`${t}cancel/${l}`,{method:"POST"})),s.set(l,c),n.append(c.element)),c};i.runs.forEach(({state:l},c)=>{l==="running"&&r(c)});let o=b("p.problem",{hidden:!0},"The viewer does not answer. What is shown is the last that it sent; it is asked again.");n.append(o);let a=new EventSource(`${t}events`);return a.addEventListener("error",()=>o.hidden=!1),a.addEventListener("open",()=>o.hidden=!0),a.addEventListener("message",({data:l})=>{let c=JSON.parse(l);if(c.type==="states"){c.states.forEach((u,d)=>{i.runs[d]&&i.runs[d].state!==u&&e.replaced(d)});return}let h=i.runs[c.run];if(h)switch(c.type){case"stage":r(c.run).stage(c.name);break;case"part":r(c.run).part(c.fraction,c.left_s);break;case"iteration":Sy(h.history,c.row),r(c.run).iteration(c.row.iteration??null,c.iterations),e.row(c.run);break;case"failed":case"canceled":h.state=c.type,r(c.run).end(`${c.message} ${My}`),e.ended(c.run),i.runs.every(({state:u})=>u!=="running")&&a.close();break;case"done":r(c.run).end(null),s.delete(c.run),e.replaced(c.run);break;case"snapshot":e.replaced(c.run);break}}),n}async function Hu(i){let e=await fetch(`${i.served}runs.json`);if(!e.ok)throw new Error(`The viewer answered ${e.status}.`);return await e.json()}async function qp({served:i},e){let t=await fetch(`${i}open/${e}`);if(!t.ok)throw new Error(await t.text()||`The viewer answered ${t.status}: the folder of this run is not there.`);return(await t.json()).run}function Sy(i,e){let t=Math.max(0,...Object.values(i).map(n=>n.length));for(let n of new Set([...Object.keys(i),...Object.keys(e)]))i[n]??=new Array(t).fill(null),i[n].push(e[n]??null)}var Vu=class{progress=b("progress",{max:1});text=b("span.quiet",{},"waiting");cancel;refusal=b("span.problem",{role:"alert",hidden:!0});element;name="";constructor(e,t){this.cancel=b("button",{type:"button"},"Cancel");let n=(o,a)=>{this.cancel.textContent=o,this.cancel.disabled=a},s=async()=>{n("Canceling…",!0),this.refusal.hidden=!0;let o=await t();if(!o.ok)throw new Error(`The viewer refused to cancel the run (it answered ${o.status}).`)},r=o=>{n("Cancel",!1),this.refusal.hidden=!1,this.refusal.textContent=o instanceof TypeError?"The viewer does not answer, so the run was not canceled.":Ss(o)};this.cancel.addEventListener("click",()=>{s().catch(r)}),this.progress.setAttribute("aria-label",`Progress of ${e}`),this.element=b("div.live-run",{},b("b",{},e),this.progress,this.text,this.cancel,this.refusal)}stage(e){this.name=e,this.show(null,null)}part(e,t){e>=1?this.show(null,null):this.show(e,`${Math.round(100*e)} %${t===null?"":`, ${Ai(t)} left`}`)}iteration(e,t){e!==null&&this.show(t?e/t:null,`iteration ${e}${t?` of at most ${t}`:""}`)}show(e,t){e===null?this.progress.removeAttribute("value"):this.progress.value=e,this.text.textContent=[this.name||"running",t].filter(Boolean).join(": ")}end(e){e===null?this.element.remove():this.element.replaceChildren(this.element.firstElementChild,b("span.problem",{role:"alert"},e))}};var wy=60,Ey=60,ro=class{constructor(e,t,n,s){this.store=t;this.signal=n;this.came=s;let r=(e.report?.optimization??e.report?.evaluation)?.grid,[o,a,l]=r?.shape_zyx??[0,0,0];this.grid=r?new la([l,a,o],[r.pitch_mm,r.pitch_mm,r.pitch_mm],r.center_xyz_mm):null}store;signal;came;full=new Map;last=new Map;asked=new Map;grid;gridOf(e){return this.finer(e)??e}of(e,t,n){let s=this.reduced(e,t,n),r=this.finer(e);if(r===null||s===null)return s;let o=r.index(t,n);if(o<0||o>=r.shape[t])return s;let a=`${e.info.id}/${t}/${o}`,l=this.full.get(a);return l||this.ask(a,e,r,t,o),l??s}reduced(e,t,n){let s=`${e.info.id}/${t}`,r=e.index(t,n),o=this.last.get(s);if(o?.index===r)return o.slice;let a=e.slice(t,n);return this.last.set(s,{index:r,slice:a}),a}finer(e){let{grid:t}=this;return e.info.full&&t!==null&&t.pitch[0]<.99*e.pitch[0]?t:null}ask(e,t,n,s,r){let o=`${t.info.id}/${s}`,a=this.asked.get(o);if(a?.key===e)return;window.clearTimeout(a?.timer);let l=async()=>{let h=await this.store.slice(t.info,2-s,r,this.signal),[u,d]=h.shape,[f,g]=Bn[s],y=h.codes.slice();for(let S=0;S<u;S++)y.set(h.codes.subarray((u-1-S)*d,(u-S)*d),S*d);let p=h.codes instanceof Uint16Array?16:8,m=[n.range(f)[0],n.range(g)[1]],v=Au(p,h.low,h.high,t.info.nan===null?null:2**p-1);this.full.set(e,{axis:s,width:d,height:u,codes:y,values:v,pitch:[n.pitch[f],n.pitch[g]],corner:m});let T=this.full.keys().next();this.full.size>wy&&!T.done&&this.full.delete(T.value),this.came(null)},c=h=>{this.signal.aborted||this.came(`The slices with all voxels did not come, so fewer are shown: ${Ss(h)}`)};this.asked.set(o,{key:e,timer:window.setTimeout(()=>{l().catch(c)},Ey)})}};var Il=1e3,Nl=230,Qt={left:44,right:44,top:26,bottom:40},ls=Nl-Qt.bottom;function Yp(i,e,t){let n=b("input",{type:"range",min:0,max:Il,step:1,"aria-label":"Gel threshold"}),s=b("button",{type:"button",click:()=>e.set({threshold:null})},i.isOfReport?"Back to the report’s threshold":"Back to the best threshold"),r=b("dl.threshold-list"),o=new Gu(i,d=>a(d)),a=d=>{let f=Math.min(Math.max(d,0),i.high);e.set({threshold:Math.abs(f-i.reported)<.6*i.high/Il?null:f})};n.addEventListener("input",()=>a(Number(n.value)/Il*i.high),{signal:t});let l=i.isOfReport?"as reported":"best of the voxels shown",c=()=>{let d=e.get("threshold")??i.reported,f=i.iou(d),g=i.percent(d),y=i.isOfReport&&i.reduced>1&&d!==i.reported?`, in means of ${i.reduced}³ voxels`:"";n.value=String(Math.round(d/i.high*Il)),n.setAttribute("aria-valuetext",`${ce(d,3)}, IoU ${ce(f,3)}`),s.disabled=e.get("threshold")===null,o.mark(d),r.replaceChildren(...ga("Gel threshold",ce(d,4),`${i.quantity} at which the resin gels`),...ga("Exposure",g===null?"–":`${ce(g,4)} %`,"of the best exposure"),...ga("IoU",ce(f,4),d!==i.reported?`${ce(i.iou(i.reported),4)} ${l}`:l),...ga("Too much",an(i.tooMuch(d),"mm³"),`gels and should not${y}`,"--excess"),...ga("Missing",an(i.missing(d),"mm³"),`does not gel and should${y}`,"--missing"))},h=e.on(["threshold"],c);t.addEventListener("abort",()=>{h(),o.end()}),c();let u=i.nearly&&i.tolerance!==null?` In the shaded range IoU is at most ${ce(i.tolerance,2)} below its best.`:"";return b("div.threshold",{},b("div.threshold-chart",{},b("h3",{},"Where the resin gels"),b("p.quiet",{},`Move the threshold: contours, print, errors and numbers follow.${u}`),Ty(),o.element,b("div.threshold-slider",{},n)),b("div.threshold-numbers",{},r,s))}function ga(i,e,t,n){return[b("dt",{},n!==void 0&&b("i.tile",{style:`background: var(${n})`}),i),b("dd",{},b("b",{},e),b("span.quiet",{},t))]}function Dl(i,e){return b("span",{},b("i.tile",{style:`background: var(${i})`}),e)}function Ty(){return b("p.color-keys",{},Dl("--part","part, voxels"),Dl("--void","void, voxels"),Dl("--ink","IoU"),Dl("--threshold","gel threshold"))}var Gu=class{constructor(e,t){this.gel=e;this.watcher.observe(this.element);let n=s=>{s.buttons===1&&(s.preventDefault(),t(this.back(s.clientX-this.element.getBoundingClientRect().left)))};this.element.addEventListener("pointerdown",s=>{this.element.setPointerCapture(s.pointerId),n(s)}),this.element.addEventListener("pointermove",n)}gel;element=b("div.plot");watcher=new ResizeObserver(()=>this.resize());line=wt("g");width=0;threshold=0;end(){this.watcher.disconnect()}mark(e){this.threshold=e,this.drawLine()}x(e){return Qt.left+e/this.gel.high*(this.width-Qt.left-Qt.right)}back(e){return(e-Qt.left)/(this.width-Qt.left-Qt.right)*this.gel.high}resize(){let e=this.element.clientWidth;e===0||e===this.width||(this.width=e,this.element.replaceChildren(this.draw()),this.drawLine())}draw(){let{histogram:e,nearly:t,objective:n,curve:s,reported:r,high:o}=this.gel,a=wt("svg",{width:this.width,height:Nl,viewBox:`0 0 ${this.width} ${Nl}`,role:"img","aria-label":`Voxels of part and void per ${this.gel.quantity}, and IoU per gel threshold`});if(t){let[l,c]=[Math.max(t[0]??0,0),Math.min(t[1]??o,o)];a.append(wt("rect",{class:"band",x:this.x(l),y:Qt.top,width:Math.max(this.x(c)-this.x(l),1),height:ls-Qt.top}))}for(let l of Cy(0,o,this.width/90))a.append(wt("line",{class:"grid",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:ls}),wt("text",{x:this.x(l),y:ls+16,"text-anchor":"middle"},ce(l,3)));a.append(wt("text",{x:(this.width+Qt.left-Qt.right)/2,y:Nl-6,"text-anchor":"middle"},this.gel.quantity)),e&&a.append(...this.bars(e));for(let l of n??[])a.append(wt("line",{class:"aimed",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:ls},wt("title",{},"a threshold of the objective: the void should stay below both, the part above")));if(s.length>1){a.append(wt("path",{class:"curve",d:`M${s.filter(([l])=>l<=o).map(([l,c])=>`${this.x(l).toFixed(1)},${br(c).toFixed(1)}`).join("L")}`}));for(let l of[0,.5,1])a.append(wt("text",{x:this.width-Qt.right+8,y:br(l)+4},String(l)));a.append(wt("text",{x:this.width-Qt.right+8,y:Qt.top-10},"IoU"))}return a.append(wt("line",{class:"base",x1:Qt.left,x2:this.width-Qt.right,y1:ls,y2:ls}),wt("line",{class:"fixed",x1:this.x(r),x2:this.x(r),y1:Qt.top,y2:ls},wt("title",{},"the report’s threshold")),this.line),a}bars(e){let{low:t,high:n}=e,s=Math.max(...e.part,...e.void,1),r=Math.ceil(Math.log10(s+1)),a=Array.from({length:r+1},(c,h)=>h).filter(c=>c%Math.ceil(r/4)===0).map(c=>wt("text",{x:Qt.left-8,y:br(c/r)+4,"text-anchor":"end"},c===0?"1":Ml(c))),l=["void","part"].map(c=>{let h=e[c].map(u=>Math.log10(u+1)/r);return wt("path",{class:`bars ${c}`,d:Ay(h,u=>this.x(t+u/h.length*(n-t)))})});return[...a,...l]}drawLine(){if(this.width===0)return;let e=this.x(this.threshold),t=this.gel.iou(this.threshold),n=e>this.width-90;this.line.replaceChildren(wt("line",{class:"threshold-line",x1:e,x2:e,y1:Qt.top-8,y2:ls}),wt("text",{class:"threshold-label",x:e+(n?-6:6),y:Qt.top-8,"text-anchor":n?"end":"start"},ce(this.threshold,3))),t!==null&&this.line.append(wt("circle",{class:"threshold-dot",cx:e,cy:br(t),r:4.5}))}};function br(i){return ls-i*(ls-Qt.top)}function Ay(i,e){let t=`M${e(0).toFixed(1)},${br(0)}`;return i.forEach((n,s)=>{t+=`V${br(n).toFixed(1)}H${e(s+1).toFixed(1)}`}),`${t}V${br(0)}Z`}function Cy(i,e,t){let n=(e-i)/Math.max(t,2),s=10**Math.floor(Math.log10(n)),r=([1,2,5,10].find(a=>a*s>=n)??10)*s,o=[];for(let a=Math.ceil(i/r);a*r<=e+1e-9;a++)o.push(a*r);return o}var Kp={id:"look",title:"Slice by slice",render:i=>i.run.volumes.some(({kind:e})=>e==="response"||e==="target")?Ci(i,Ry):null};async function Ry(i){let{run:e,state:t,gone:n}=i,s=b("div.look-place"),r=new AbortController,o=null,a=async()=>{let h=new AbortController,u=r;r=h;let{volumes:d,problems:f}=await fa(i,Bi(i));if(u.abort(),h.signal.aborted)return;let g=d.response??d.target,y=s.contains(document.activeElement)?document.activeElement?.getAttribute("aria-label")??null:null;o=g&&new $u(i,d,g,o,h.signal),s.replaceChildren(...f.map(vr),...o?o.elements():[]),y!==null&&s.querySelector(`[aria-label="${CSS.escape(y)}"]`)?.focus({preventScroll:!0})},l=t.on(["species"],()=>{a()});i.renewed.addEventListener("renewed",()=>{a()},{signal:n}),n.addEventListener("abort",()=>{l(),r.abort()}),await a();let c=da(e);return b("div",{},c.length>1&&Py(i,c),s)}function Py(i,e){let{state:t,gone:n}=i,s=e.map(r=>[r,r]);return zn("Species",s,()=>Bi(i)||e[0],r=>t.set({species:r,threshold:null}),r=>n.addEventListener("abort",t.on(["species"],r)))}var Ol="all",Wu={part:["target","error"],print:["print","error"]},$u=class{constructor(e,t,n,s,r){this.context=e;this.volumes=t;this.grid=n;this.signal=r;let{run:o,state:a,store:l}=e,c=so(o);this.gel=c===null?Pl(o,Bi(e),t.response,t.labels):null,this.hidden=s?.hidden??new Set,this.outlined={part:t.target!==null&&c===null,print:this.gel!==null&&t.response!==null},this.slices=new ro(o,l,r,h=>{this.trouble.say(h),h===null&&this.planes.redraw(!0)}),this.layers=Dp(t,this.slices,this.gel&&(()=>this.threshold),c),this.planes=new Zs({state:a,grid:this.slices.gridOf(n),signal:r,hover:h=>this.read(h??this.planes.at())}),s&&([this.planes.zoom,this.planes.center]=[s.planes.zoom,s.planes.center])}context;volumes;grid;signal;gel;slices;layers;planes;readout=b("p.readout");legend=b("div.color-legend");trouble=Cl();outlined;hidden;elements(){let{context:e,gel:t,grid:n,planes:s,signal:r}=this,o=this.controls();this.listen(["threshold"],()=>{s.redraw(!0),this.showLegend()}),this.listen(["layer","plane"],()=>this.arrange()),this.listen(["threshold","at","layer"],()=>this.read(s.at())),this.arrange(),this.read(s.at());let a=n.info.reduced>1&&!n.info.full?` Each voxel shown is the mean of ${n.info.reduced}³ of the ${e.run.report?"evaluation":"optimization"}.`:"";return[b("p.quiet",{},`Click to move the cut; drag the sliders, or choose a plane and press the arrow keys or turn the wheel. Double-click, + and − zoom, 0 shows all again.${a}`),o,s.element,this.trouble.element,b("div.below-planes",{},this.readout,this.legend),...t?[Yp(t,e.state,r)]:[]]}get threshold(){return this.context.state.get("threshold")??this.gel?.reported??Number.POSITIVE_INFINITY}get shown(){let e=this.context.state.get("layer");return e===Ol?this.layers.slice(0,4):[this.layers.find(t=>t.id===e)??this.layers[0]]}get isAll(){return this.context.state.get("layer")===Ol}arrange(){let{shown:e}=this,t=this.context.state.get("plane"),n=t==="x"?0:t==="y"?1:2,s=this.isAll?e.map(r=>({axis:n,layer:r,title:r.title,outlines:this.outlines(r)})):[2,1,0].map(r=>({axis:r,layer:e[0],outlines:this.outlines(e[0])}));this.planes.show(s),this.showLegend()}showLegend(){this.legend.replaceChildren(...this.shown.map(e=>si(e.legend())))}read(e){let{grid:t}=this.planes.options,n=t.middleAt(e),s=n.map((o,a)=>`${os[a]} ${Bu(o,t.pitch[a])}`).join(", "),r=Op(this.volumes.bodies,n);this.readout.textContent=[`${s} mm`,...this.layers.map(o=>o.value(n)),...r===null?[]:[r]].join("  ·  ")}outlines(e){let{target:t,response:n}=this.volumes,s=o=>this.outlined[o]&&!this.hidden.has(o)&&!Wu[o].includes(e.id),r=(o,a,l,c,h)=>{let u=o&&this.slices.of(o,c,h);return u?[{slice:u,segments:Ly(u,a),color:l}]:[]};return(o,a)=>[...s("part")?r(t,.5,"--outline-part",o,a):[],...s("print")?r(n,this.threshold,"--threshold-line",o,a):[]]}controls(){let{layers:e}=this,{state:t}=this.context,n=e.map(({id:u,title:d})=>[u,d]);e.length>1&&n.push([Ol,"Side by side"]);let s=()=>this.isAll?Ol:this.shown[0].id,r=u=>t.set({layer:u===e[0].id?"":u}),o=zn("Plane",[["","x–y"],["y","x–z"],["x","y–z"]],()=>t.get("plane"),u=>t.set({plane:u}),u=>this.listen(["plane"],u)),a=(u,d)=>{if(!this.outlined[u])return null;let f=g=>{g?this.hidden.delete(u):this.hidden.add(u),this.planes.redraw(!0)};return ua(`outline of the ${u}`,!this.hidden.has(u),f,b("i.stroke",{style:`background: var(${d})`}))},[l,c]=[a("part","--outline-part"),a("print","--threshold-line")],h=()=>{o.hidden=!this.isAll,l&&(l.hidden=!this.isAll&&Wu.part.includes(this.shown[0].id)),c&&(c.hidden=!this.isAll&&Wu.print.includes(this.shown[0].id))};return this.listen(["layer"],h),h(),b("div.controls",{},n.length>1&&zn("Shown",n,s,r,u=>this.listen(["layer"],u)),o,l,c)}listen(e,t){this.signal.addEventListener("abort",this.context.state.on(e,t))}},Zp=new WeakMap;function Ly(i,e){let t=Zp.get(i);return t?.level!==e&&Zp.set(i,t={level:e,segments:Rl(i,e)}),t.segments}var Iy="uplot",Dy="u-hz",Ny="u-vt",Oy="u-title",Uy="u-wrap",Fy="u-under",ky="u-over",By="u-axis",wr="u-off",zy="u-select",Vy="u-cursor-x",Hy="u-cursor-y",Gy="u-cursor-pt",Wy="u-legend",$y="u-live",Xy="u-inline",qy="u-series",Yy="u-marker",jp="u-label",Zy="u-value",_a="width",ya="height";var Jp="bottom",oo="left",Xu="right",cd="#000",Qp=cd+"0",qu="mousemove",em="mousedown",Yu="mouseup",tm="mouseenter",nm="mouseleave",im="dblclick",Ky="resize",jy="scroll",sm="change",zl="dppxchange",hd="--",po=typeof window<"u",Qu=po?document:null,lo=po?window:null,Jy=po?navigator:null,Ct,Ul;function ed(){let i=devicePixelRatio;Ct!=i&&(Ct=i,Ul&&nd(sm,Ul,ed),Ul=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Er(sm,Ul,ed),lo.dispatchEvent(new CustomEvent(zl)))}function pi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function td(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Xt(i,e,t){i.style[e]=t+"px"}function zi(i,e,t,n){let s=Qu.createElement(i);return e!=null&&pi(s,e),t?.insertBefore(s,n),s}function Ri(i,e){return zi("div",i,e)}var rm=new WeakMap;function cs(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=rm.get(i);r!=o&&(i.style.transform=r,rm.set(i,r),e<0||t<0||e>n||t>s?pi(i,wr):td(i,wr))}var om=new WeakMap;function am(i,e,t){let n=e+t,s=om.get(i);n!=s&&(om.set(i,n),i.style.background=e,i.style.borderColor=t)}var lm=new WeakMap;function cm(i,e,t,n){let s=e+""+t,r=lm.get(i);s!=r&&(lm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var ud={passive:!0},Qy={...ud,capture:!0};function Er(i,e,t,n){e.addEventListener(i,t,n?Qy:ud)}function nd(i,e,t,n){e.removeEventListener(i,t,ud)}po&&ed();function Vi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:mi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Fm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var km=i=>i!=null,Bm=i=>i!=null&&i>0,Gl=Fm(km),ev=Fm(Bm);function tv(i,e,t,n=0,s=!1){let r=s?ev:Gl,o=s?Bm:km;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Bt,l??-Bt]}function Wl(i,e,t,n){let s=dm(i),r=dm(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Es:zm,a=s==1?mi:Pi,l=r==1?Pi:mi,c=a(o(wn(i))),h=l(o(wn(e))),u=co(t,c),d=co(t,h);return t==10&&(c<0&&(u=zt(u,-c)),h<0&&(d=zt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=Wm(i,u),e=$l(e,d)),[i,e]}function dd(i,e,t,n){let s=Wl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var fd=.1,hm={mode:3,pad:fd},ba={pad:0,soft:null,mode:0},nv={min:ba,max:ba};function Vl(i,e,t,n){return Xl(t)?um(i,e,t):(ba.pad=t,ba.soft=n?0:null,ba.mode=n?3:0,um(i,e,nv))}function Tt(i,e){return i??e}function iv(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function um(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-Bt),l=Tt(s.hard,Bt),c=Tt(n.soft,Bt),h=Tt(s.soft,-Bt),u=Tt(n.mode,0),d=Tt(s.mode,0),f=e-i,g=Es(f),y=Jn(wn(i),wn(e)),p=Es(y),m=wn(p-g);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Bt&&(r=0),d==2&&h!=-Bt&&(o=0)));let v=f||y||1e3,T=Es(v),S=co(10,mi(T)),R=v*(f==0?i==0?.1:1:r),C=zt(Wm(i-R,S/10),24),_=i>=c&&(u==1||u==3&&C<=c||u==2&&C>=c)?c:Bt,A=Jn(a,C<_&&i>=_?_:Hi(_,C)),z=v*(f==0?e==0?.1:1:o),O=zt($l(e+z,S/10),24),D=e<=h&&(d==1||d==3&&O>=h||d==2&&O<=h)?h:-Bt,G=Hi(l,O>D&&e<=D?D:Jn(D,O));return A==G&&A==0&&(G=100),[A,G]}var sv=new Intl.NumberFormat(po?Jy.language:"en-US"),pd=i=>sv.format(i),gi=Math,Bl=gi.PI,wn=gi.abs,mi=gi.floor,Sn=gi.round,Pi=gi.ceil,Hi=gi.min,Jn=gi.max,co=gi.pow,dm=gi.sign,Es=gi.log10,zm=gi.log2,rv=(i,e=1)=>gi.sinh(i)*e,Zu=(i,e=1)=>gi.asinh(i/e),Bt=1/0;function fm(i){return(Es((i^i>>31)-(i>>31))|0)+1}function id(i,e,t){return Hi(Jn(i,e),t)}function Vm(i){return typeof i=="function"}function bt(i){return Vm(i)?i:()=>i}var ov=()=>{},Hm=i=>i,Gm=(i,e)=>e,av=i=>null,pm=i=>!0,mm=(i,e)=>i==e,lv=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=i=>{if(Xm(i)||js.has(i))return i;let e=`${i}`,t=e.match(lv);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Tr(s)}e${r}`}return zt(i,n)};function Mr(i,e){return Tr(zt(Tr(i/e))*e)}function $l(i,e){return Tr(Pi(Tr(i/e))*e)}function Wm(i,e){return Tr(mi(Tr(i/e))*e)}function zt(i,e=0){if(Xm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Sn(n)/t}var js=new Map;function $m(i){return((""+i).split(".")[1]||"").length}function Sa(i,e,t,n){let s=[],r=n.map($m);for(let o=e;o<t;o++){let a=wn(o),l=zt(co(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:zt(h,u);s.push(d),js.set(d,u)}}return s}var Ma={},md=[],ho=[null,null],Ks=Array.isArray,Xm=Number.isInteger,cv=i=>i===void 0;function gm(i){return typeof i=="string"}function Xl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function hv(i){return i!=null&&typeof i=="object"}var uv=Object.getPrototypeOf(Uint8Array),qm="__proto__";function uo(i,e=Xl){let t;if(Ks(i)){let n=i.find(s=>s!=null);if(Ks(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=uo(i[s],e)}else t=i.slice()}else if(i instanceof uv)t=i.slice();else if(e(i)){t={};for(let n in i)n!=qm&&(t[n]=uo(i[n],e))}else t=i;return t}function gn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=qm&&(Xl(i[s])?gn(i[s],uo(n[s])):i[s]=uo(n[s]))}return i}var dv=0,fv=1,pv=2;function mv(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function gv(i,e){if(yv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return vv(o[0])||(o=_v(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:fv,f=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(l[g]);y===null?d!=dv&&(u[p]=y,d==pv&&f.push(p)):u[p]=y}mv(u,f,s),n.push(u)}}return n}var xv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function _v(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function yv(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function vv(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Jn(1,mi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ym=["January","February","March","April","May","June","July","August","September","October","November","December"],Zm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Km(i){return i.slice(0,3)}var bv=Zm.map(Km),Mv=Ym.map(Km),Sv={MMMM:Ym,MMM:Mv,WWWW:Zm,WWW:bv};function xa(i){return(i<10?"0":"")+i}function wv(i){return(i<10?"00":i<100?"0":"")+i}var Ev={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>xa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>xa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>xa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>xa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>xa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>wv(i.getMilliseconds())};function gd(i,e){e=e||Sv;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Ev[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Tv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Av(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Tv?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var jm=i=>i%1==0,Hl=[1,2,2.5,5],Cv=Sa(10,-32,0,Hl),Jm=Sa(10,0,32,Hl),Rv=Jm.filter(jm),Sr=Cv.concat(Jm),xd=`
`,Qm="{YYYY}",xm=xd+Qm,eg="{M}/{D}",va=xd+eg,Fl=va+"/{YY}",tg="{aa}",Pv="{h}:{mm}",ao=Pv+tg,_m=xd+ao,ym=":{ss}",Lt=null;function ng(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Sa(10,0,3,Hl).filter(jm):Sa(10,-3,0,Hl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Qm,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",xm,Lt,Lt,Lt,Lt,Lt,1],[s,eg,xm,Lt,Lt,Lt,Lt,Lt,1],[n,"{h}"+tg,Fl,Lt,va,Lt,Lt,Lt,1],[t,ao,Fl,Lt,va,Lt,Lt,Lt,1],[e,ym,Fl+" "+ao,Lt,va+" "+ao,Lt,_m,Lt,1],[i,ym+".{fff}",Fl+" "+ao,Lt,va+" "+ao,Lt,_m,Lt,1]];function h(u){return(d,f,g,y,p,m)=>{let v=[],T=p>=o,S=p>=r&&p<o,R=u(g),C=zt(R*i,3),_=Ku(R.getFullYear(),T?0:R.getMonth(),S||T?1:R.getDate()),A=zt(_*i,3);if(S||T){let z=S?p/r:0,O=T?p/o:0,D=C==A?C:zt(Ku(_.getFullYear()+O,_.getMonth()+z,1)*i,3),G=new Date(Sn(D/i)),H=G.getFullYear(),N=G.getMonth();for(let W=0;D<=y;W++){let $=Ku(H+O*W,N+z*W,1),B=$-u(zt($*i,3));D=zt((+$+B)*i,3),D<=y&&v.push(D)}}else{let z=p>=s?s:p,O=mi(g)-mi(C),D=A+O+$l(C-A,z);v.push(D);let G=u(D),H=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,N=p/n,W=d.axes[f]._space,$=m/W;for(;D=zt(D+p,i==1?0:3),!(D>y);)if(N>1){let B=mi(zt(H+N,6))%24,Q=u(D).getHours()-B;Q>1&&(Q=-1),D-=Q*n,H=(H+N)%24;let ie=v[v.length-1];zt((D-ie)/p,3)*$>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[Lv,Iv,Dv]=ng(1),[Nv,Ov,Uv]=ng(.001);Sa(2,-53,53,[1]);function vm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function bm(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let y=i(g),p=y.getFullYear(),m=y.getMonth(),v=y.getDate(),T=y.getHours(),S=y.getMinutes(),R=y.getSeconds(),C=p!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||T!=u&&a[5]||S!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=v,u=T,d=S,f=R,C(y)})}}function Fv(i,e){let t=gd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Ku(i,e,t){return new Date(i,e,t)}function Mm(i,e){return e(i)}var kv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Sm(i,e){return(t,n,s,r)=>r==null?hd:e(i(n))}function Bv(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function zv(i,e){return i.series[e].fill(i,e)}var Vv={show:!0,live:!0,isolate:!1,mount:ov,markers:{show:!0,width:2,stroke:Bv,fill:zv,dash:"solid"},idx:null,idxs:null,values:[]};function Hv(i,e){let t=i.cursor.points,n=Ri(),s=t.size(i,e);Xt(n,_a,s),Xt(n,ya,s);let r=s/-2;Xt(n,"marginLeft",r),Xt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Xt(n,"borderWidth",o),n}function Gv(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Wv(i,e){let t=i.series[e].points;return t._stroke||t._fill}function $v(i,e){return i.series[e].points.size}var ju=[0,0];function Xv(i,e,t){return ju[0]=e,ju[1]=t,ju}function kl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ju(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var qv={show:!0,x:!0,y:!0,lock:!1,move:Xv,points:{one:!1,show:Hv,size:$v,width:0,stroke:Wv,fill:Gv},bind:{mousedown:kl,mouseup:kl,click:kl,dblclick:kl,mousemove:Ju,mouseleave:Ju,mouseenter:Ju},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ig={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},_d=gn({},ig,{filter:Gm}),sg=gn({},_d,{size:10}),rg=gn({},ig,{show:!1}),yd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',og="bold "+yd,ag=1.5,wm={show:!0,scale:"x",stroke:cd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:og,side:2,grid:_d,ticks:sg,border:rg,font:yd,lineGap:ag,rotate:0},Yv="Value",Zv="Time",Em={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function Kv(i,e,t,n,s){return e.map(r=>r==null?"":pd(r))}function jv(i,e,t,n,s,r,o){let a=[],l=js.get(s)||0;t=o?t:zt($l(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function sd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Es:zm,h=mi(c(t));s=co(l,h),l==10&&(s=Sr[Vi(s,Sr)]);let u=t,d=s*l;l==10&&(d=Sr[Vi(d,Sr)]);do a.push(u),u=u+s,l==10&&!js.has(u)&&(u=zt(u,js.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Sr[Vi(d,Sr)]));while(u<=n);return a}function Jv(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?sd(i,e,Jn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?sd(i,e,Jn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var lg=/./,Qv=/[12357]/,eb=/[125]/,Tm=/1/,rd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function tb(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?lg:l(7,o)-h>=c?Qv:l(5,o)-h>=c?eb:Tm;if(u==Tm){let d=wn(l(1,o)-h);if(d<c)return rd(e.slice().reverse(),a.distr,u,Pi(c/d)).reverse()}return rd(e,a.distr,u,1)}function nb(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=wn(l(1,o)-l(2,o));return c<a?rd(e.slice().reverse(),3,lg,Pi(a/c)).reverse():e}function ib(i,e,t,n){return n==null?hd:e==null?"":pd(e)}var Am={show:!0,scale:"y",stroke:cd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:og,side:3,grid:_d,ticks:sg,border:rg,font:yd,lineGap:ag,rotate:0};function sb(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function rb(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=wn(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var Cm={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},cg=(i,e,t,n,s)=>s,Rm={show:!0,auto:!0,sorted:0,gaps:cg,alpha:1,facets:[gn({},Cm,{scale:"x"}),gn({},Cm,{scale:"y"})]},Pm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:cg,alpha:1,points:{show:rb,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function ob(i,e,t,n,s){return t/10}var hg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},ab=gn({},hg,{time:!1,ori:1}),Lm={};function ug(i,e){let t=Lm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Lm[i]=t)),t}var fo=1,od=2;function Ar(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,y,Yl,mo,Kl,fg,mg):t(s,l,c,h,u,m,p,f,d,y,g,Zl,go,Md,pg,gg)}function vd(i,e){let t=0,n=0,s=Tt(i.bands,md);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function lb(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ts(i,e,t,n,s,r){return Ar(i,e,(o,a,l,c,h,u,d,f,g,y,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?mo:go,S,R;v==1?(S=t,R=n):(S=n,R=t);let C=m(u(a[S],c,y,f)),_=m(d(l[S],h,p,g)),A=m(u(a[R],c,y,f)),z=m(d(r==1?h.max:h.min,h,p,g)),O=new Path2D(s);return T(O,A,z),T(O,C,z),T(O,C,_),O})}function ql(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Kl:Md,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function cb(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function bd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=f&&a.push([f,g])}return a}function Im(i){return i==0?Hm:i==1?Sn:e=>Mr(e,i)}function dg(i){let e=i==0?Yl:Zl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Hi(c,a/2,l/2),h=Hi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Yl=(i,e,t)=>{i.moveTo(e,t)},Zl=(i,e,t)=>{i.moveTo(t,e)},mo=(i,e,t)=>{i.lineTo(e,t)},go=(i,e,t)=>{i.lineTo(t,e)},Kl=dg(0),Md=dg(1),fg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},pg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},mg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},gg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function xg(i){return(e,t,n,s,r)=>Ar(e,t,(o,a,l,c,h,u,d,f,g,y,p)=>{let{pxRound:m,points:v}=o,T,S;c.ori==0?(T=Yl,S=fg):(T=Zl,S=pg);let R=zt(v.width*Ct,3),C=(v.size-v.width)/2*Ct,_=zt(C*2,3),A=new Path2D,z=new Path2D,{left:O,top:D,width:G,height:H}=e.bbox;Kl(z,O-_,D-_,G+_*2,H+_*2);let N=W=>{if(l[W]!=null){let $=m(u(a[W],c,y,f)),B=m(d(l[W],h,p,g));T(A,$+C,B),S(A,$,B,C,0,Bl*2)}};if(r)r.forEach(N);else for(let W=n;W<=s;W++)N(W);return{stroke:R>0?A:null,fill:A,clip:z,flags:fo|od}})}function _g(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var hb=_g(mo),ub=_g(go);function yg(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>Ar(t,n,(o,a,l,c,h,u,d,f,g,y,p)=>{[s,r]=Gl(l,s,r);let m=o.pxRound,v=H=>m(u(H,c,y,f)),T=H=>m(d(H,h,p,g)),S,R;c.ori==0?(S=mo,R=hb):(S=go,R=ub);let C=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},A=_.stroke,z=!1;if(r-s>=y*4){let H=fe=>t.posToVal(fe,c.key,!0),N=null,W=null,$,B,oe,K=v(a[C==1?s:r]),Q=v(a[s]),ie=v(a[r]),de=H(C==1?Q+1:ie-1);for(let fe=C==1?s:r;fe>=s&&fe<=r;fe+=C){let ee=a[fe],ve=(C==1?ee<de:ee>de)?K:v(ee),Re=l[fe];ve==K?Re!=null?(B=Re,N==null?(S(A,ve,T(B)),$=N=W=B):B<N?N=B:B>W&&(W=B)):Re===null&&(z=!0):(N!=null&&R(A,K,T(N),T(W),T($),T(B)),Re!=null?(B=Re,S(A,ve,T(B)),N=W=$=B):(N=W=null,Re===null&&(z=!0)),K=ve,de=H(K+C))}N!=null&&N!=W&&oe!=K&&R(A,K,T(N),T(W),T($),T(B))}else for(let H=C==1?s:r;H>=s&&H<=r;H+=C){let N=l[H];N===null?z=!0:N!=null&&S(A,v(a[H]),T(N))}let[D,G]=vd(t,n);if(o.fill!=null||D!=0){let H=_.fill=new Path2D(A),N=o.fillTo(t,n,o.min,o.max,D),W=T(N),$=v(a[s]),B=v(a[r]);C==-1&&([B,$]=[$,B]),S(H,B,W),S(H,$,W)}if(!o.spanGaps){let H=[];z&&H.push(...bd(a,l,s,r,C,v,e)),_.gaps=H=o.gaps(t,n,s,r,H),_.clip=ql(H,c.ori,f,g,y,p)}return G!=0&&(_.band=G==2?[Ts(t,n,s,r,A,-1),Ts(t,n,s,r,A,1)]:Ts(t,n,s,r,A,G)),_})}function db(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,l)=>Ar(r,o,(c,h,u,d,f,g,y,p,m,v,T)=>{[a,l]=Gl(u,a,l);let S=c.pxRound,{left:R,width:C}=r.bbox,_=Q=>S(g(Q,d,v,p)),A=Q=>S(y(Q,f,T,m)),z=d.ori==0?mo:go,O={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},D=O.stroke,G=d.dir*(d.ori==0?1:-1),H=A(u[G==1?a:l]),N=_(h[G==1?a:l]),W=N,$=N;s&&e==-1&&($=R,z(D,$,H)),z(D,N,H);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let ie=u[Q];if(ie==null)continue;let de=_(h[Q]),fe=A(ie);e==1?z(D,de,H):z(D,W,fe),z(D,de,fe),H=fe,W=de}let B=W;s&&e==1&&(B=R+C,z(D,B,H));let[oe,K]=vd(r,o);if(c.fill!=null||oe!=0){let Q=O.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,oe),de=A(ie);z(Q,B,de),z(Q,$,de)}if(!c.spanGaps){let Q=[];Q.push(...bd(h,u,a,l,G,_,n));let ie=c.width*Ct/2,de=t||e==1?ie:-ie,fe=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),O.gaps=Q=c.gaps(r,o,a,l,Q),O.clip=ql(Q,d.ori,p,m,v,T)}return K!=0&&(O.band=K==2?[Ts(r,o,a,l,D,-1),Ts(r,o,a,l,D,1)]:Ts(r,o,a,l,D,K)),O})}function Dm(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=wn(i[l]-i[a]);h<c&&(c=h,o=wn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function fb(i){i=i||Ma;let e=Tt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Tt(e[1],Bt),l=Tt(e[2],1),c=Tt(i.disp,Ma),h=Tt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,y,p)=>Ar(f,g,(m,v,T,S,R,C,_,A,z,O,D)=>{let G=m.pxRound,H=t,N=n*Ct,W=a*Ct,$=l*Ct,B,oe;S.ori==0?[B,oe]=r(f,g):[oe,B]=r(f,g);let K=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Kl:Md,ie=S.ori==0?h:(Le,Ye,at,Ee,kt,He,qe)=>{h(Le,Ye,at,kt,Ee,qe,He)},de=Tt(f.bands,md).find(Le=>Le.series[0]==g),fe=de!=null?de.dir:0,ee=m.fillTo(f,g,m.min,m.max,fe),xe=G(_(ee,R,D,z)),ve,Re,we,$e=O,ot=G(m.width*Ct),Ge=!1,ft=null,ht=null,st=null,Zt=null;u!=null&&(ot==0||d!=null)&&(Ge=!0,ft=u.values(f,g,y,p),ht=new Map,new Set(ft).forEach(Le=>{Le!=null&&ht.set(Le,new Path2D)}),ot>0&&(st=d.values(f,g,y,p),Zt=new Map,new Set(st).forEach(Le=>{Le!=null&&Zt.set(Le,new Path2D)})));let{x0:Vt,size:hn}=c;if(Vt!=null&&hn!=null){H=1,v=Vt.values(f,g,y,p),Vt.unit==2&&(v=v.map(at=>f.posToVal(A+at*O,S.key,!0)));let Le=hn.values(f,g,y,p);hn.unit==2?Re=Le[0]*O:Re=C(Le[0],S,O,A)-C(0,S,O,A),$e=Dm(v,T,C,S,O,A,$e),we=$e-Re+N}else $e=Dm(v,T,C,S,O,A,$e),we=$e*o+N,Re=$e-we;we<1&&(we=0),ot>=Re/2&&(ot=0),we<5&&(G=Hm);let Ut=we>0,Cn=$e-we-(Ut?ot:0);Re=G(id(Cn,$,W)),ve=(H==0?Re/2:H==K?0:Re)-H*K*((H==0?N/2:0)+(Ut?ot/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vn=Ge?null:new Path2D,tn=null;if(de!=null)tn=f.data[de.series[1]];else{let{y0:Le,y1:Ye}=c;Le!=null&&Ye!=null&&(T=Ye.values(f,g,y,p),tn=Le.values(f,g,y,p))}let un=B*Re,F=oe*Re;for(let Le=K==1?y:p;Le>=y&&Le<=p;Le+=K){let Ye=T[Le];if(Ye==null)continue;if(tn!=null){let X=tn[Le]??0;if(Ye-X==0)continue;xe=_(X,R,D,z)}let at=S.distr!=2||c!=null?v[Le]:Le,Ee=C(at,S,O,A),kt=_(Tt(Ye,ee),R,D,z),He=G(Ee-ve),qe=G(Jn(kt,xe)),P=G(Hi(kt,xe)),M=qe-P;if(Ye!=null){let X=Ye<0?F:un,ue=Ye<0?un:F;Ge?(ot>0&&st[Le]!=null&&Q(Zt.get(st[Le]),He,P+mi(ot/2),Re,Jn(0,M-ot),X,ue),ft[Le]!=null&&Q(ht.get(ft[Le]),He,P+mi(ot/2),Re,Jn(0,M-ot),X,ue)):Q(vn,He,P+mi(ot/2),Re,Jn(0,M-ot),X,ue),ie(f,g,Le,He-ot/2,P,Re+ot,M)}}return ot>0?St.stroke=Ge?Zt:vn:Ge||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Ge?ht:vn,St})}function pb(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>Ar(n,s,(a,l,c,h,u,d,f,g,y,p,m)=>{[r,o]=Gl(c,r,o);let v=a.pxRound,T=B=>v(d(B,h,p,g)),S=B=>v(f(B,u,m,y)),R,C,_;h.ori==0?(R=Yl,_=mo,C=mg):(R=Zl,_=go,C=gg);let A=h.dir*(h.ori==0?1:-1),z=T(l[A==1?r:o]),O=z,D=[],G=[];for(let B=A==1?r:o;B>=r&&B<=o;B+=A)if(c[B]!=null){let K=l[B],Q=T(K);D.push(O=Q),G.push(S(c[B]))}let H={stroke:i(D,G,R,_,C,v),fill:null,clip:null,band:null,gaps:null,flags:fo},N=H.stroke,[W,$]=vd(n,s);if(a.fill!=null||W!=0){let B=H.fill=new Path2D(N),oe=a.fillTo(n,s,a.min,a.max,W),K=S(oe);_(B,O,K),_(B,z,K)}if(!a.spanGaps){let B=[];B.push(...bd(l,c,r,o,A,T,t)),H.gaps=B=a.gaps(n,s,r,o,B),H.clip=ql(B,h.ori,g,y,p,m)}return $!=0&&(H.band=$==2?[Ts(n,s,r,o,N,-1),Ts(n,s,r,o,N,1)]:Ts(n,s,r,o,N,$)),H})}function mb(i){return pb(gb,i)}function gb(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var ad=new Set;function Nm(){for(let i of ad)i.syncRect(!0)}po&&(Er(Ky,lo,Nm),Er(jy,lo,Nm,!0),Er(zl,lo,()=>{xn.pxRatio=Ct}));var xb=yg(),_b=xg();function Om(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>ld(r,o,e,t))}function yb(i,e){return i.map((t,n)=>n==0?{}:gn({},e,t))}function ld(i,e,t,n){return gn({},e==0?t:n,i)}function vg(i,e,t){return e==null?ho:[e,t]}var vb=vg;function bb(i,e,t){return e==null?ho:Vl(e,t,fd,!0)}function bg(i,e,t,n){return e==null?ho:Wl(e,t,i.scales[n].log,!1)}var Mb=bg;function Mg(i,e,t,n){return e==null?ho:dd(e,t,i.scales[n].log,!1)}var Sb=Mg;function wb(i,e,t,n,s){let r=Jn(fm(i),fm(e)),o=e-i,a=Vi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Um(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Sn((t=+s)*Ct))+"px"),[i,e,t]}function Eb(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function xn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(x,w,L,I){let V=w.valToPct(x);return I+L*(w.dir==-1?1-V:V)}function o(x,w,L,I){let V=w.valToPct(x);return I+L*(w.dir==-1?V:1-V)}function a(x,w,L,I){return w.ori==0?r(x,w,L,I):o(x,w,L,I)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Ri(Iy);if(i.id!=null&&(c.id=i.id),pi(c,i.class),i.title){let x=Ri(Oy,c);x.textContent=i.title}let h=zi("canvas"),u=n.ctx=h.getContext("2d"),d=Ri(Uy,c);Er("click",d,x=>{x.target===g&&(Gt!=Zr||Kt!=Kr)&&Un.click(n,x)},!0);let f=n.under=Ri(Fy,d);d.appendChild(h);let g=n.over=Ri(ky,d);i=uo(i);let y=+Tt(i.pxAlign,1),p=Im(y);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?Om(i.series||[],Em,Pm,!1):yb(i.series||[null],Rm),T=n.axes=Om(i.axes||[],wm,Am,!0),S=n.scales={},R=n.bands=i.bands||[];R.forEach(x=>{x.fill=bt(x.fill||null),x.dir=Tt(x.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ys,series:mt},A=(i.drawOrder||["axes","series"]).map(x=>_[x]);function z(x){let w=x.distr==3?L=>Es(L>0?L:x.clamp(n,L,x.min,x.max,x.key)):x.distr==4?L=>Zu(L,x.asinh):x.distr==100?L=>x.fwd(L):L=>L;return L=>{let I=w(L),{_min:V,_max:j}=x,le=j-V;return(I-V)/le}}function O(x){let w=S[x];if(w==null){let L=(i.scales||Ma)[x]||Ma;if(L.from!=null){O(L.from);let I=gn({},S[L.from],L,{key:x});I.valToPct=z(I),S[x]=I}else{w=S[x]=gn({},x==C?hg:ab,L),w.key=x;let I=w.time,V=w.range,j=Ks(V);if((x!=C||s==2&&!I)&&(j&&(V[0]==null||V[1]==null)&&(V={min:V[0]==null?hm:{mode:1,hard:V[0],soft:V[0]},max:V[1]==null?hm:{mode:1,hard:V[1],soft:V[1]}},j=!1),!j&&Xl(V))){let le=V;V=(me,Me,Oe)=>Me==null?ho:Vl(Me,Oe,le)}w.range=bt(V||(I?vb:x==C?w.distr==3?Mb:w.distr==4?Sb:vg:w.distr==3?bg:w.distr==4?Mg:bb)),w.auto=bt(j?!1:w.auto),w.clamp=bt(w.clamp||ob),w._min=w._max=null,w.valToPct=z(w)}}}O("x"),O("y"),s==1&&v.forEach(x=>{O(x.scale)}),T.forEach(x=>{O(x.scale)});for(let x in i.scales)O(x);let D=S[C],G=D.distr,H,N;D.ori==0?(pi(c,Dy),H=r,N=o):(pi(c,Ny),H=o,N=r);let W={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(W[x]={min:w.min,max:w.max},w.min=w.max=null)}let $=i.tzDate||(x=>new Date(Sn(x/m))),B=i.fmtDate||gd,oe=m==1?Dv($):Uv($),K=bm($,vm(m==1?Iv:Ov,B)),Q=Sm($,Mm(kv,B)),ie=[],de=n.legend=gn({},Vv,i.legend),fe=n.cursor=gn({},qv,{drag:{y:s==2}},i.cursor),ee=de.show,xe=fe.show,ve=de.markers;de.idxs=ie,ve.width=bt(ve.width),ve.dash=bt(ve.dash),ve.stroke=bt(ve.stroke),ve.fill=bt(ve.fill);let Re,we,$e,ot=[],Ge=[],ft,ht=!1,st={};if(de.live){let x=v[1]?v[1].values:null;ht=x!=null,ft=ht?x(n,1,0):{_:0};for(let w in ft)st[w]=hd}if(ee)if(Re=zi("table",Wy,c),$e=zi("tbody",null,Re),de.mount(n,Re),ht){we=zi("thead",null,Re,$e);let x=zi("tr",null,we);zi("th",null,x);for(var Zt in ft)zi("th",jp,x).textContent=Zt}else pi(Re,Xy),de.live&&pi(Re,$y);let Vt={show:!0},hn={show:!1};function Ut(x,w){if(w==0&&(ht||!de.live||s==2))return ho;let L=[],I=zi("tr",qy,$e,$e.childNodes[w]);pi(I,x.class),x.show||pi(I,wr);let V=zi("th",null,I);if(ve.show){let me=Ri(Yy,V);if(w>0){let Me=ve.width(n,w);Me&&(me.style.border=Me+"px "+ve.dash(n,w)+" "+ve.stroke(n,w)),me.style.background=ve.fill(n,w)}}let j=Ri(jp,V);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,w>0&&(ve.show||(j.style.color=x.width>0?ve.stroke(n,w):ve.fill(n,w)),St("click",V,me=>{if(fe._lock)return;je(me);let Me=v.indexOf(x);if((me.ctrlKey||me.metaKey)!=de.isolate){let Oe=v.some((Ue,ke)=>ke>0&&ke!=Me&&Ue.show);v.forEach((Ue,ke)=>{ke>0&&es(ke,Oe?ke==Me?Vt:hn:Vt,!0,mn.setSeries)})}else es(Me,{show:!x.show},!0,mn.setSeries)},!1),Je&&St(tm,V,me=>{fe._lock||(je(me),es(v.indexOf(x),Jr,!0,mn.setSeries))},!1));for(var le in ft){let me=zi("td",Zy,I);me.textContent="--",L.push(me)}return[I,L]}let Cn=new Map;function St(x,w,L,I=!0){let V=Cn.get(w)||{},j=fe.bind[x](n,w,L,I);j&&(Er(x,w,V[x]=j),Cn.set(w,V))}function vn(x,w,L){let I=Cn.get(w)||{};for(let V in I)(x==null||V==x)&&(nd(V,w,I[V]),delete I[V]);x==null&&Cn.delete(w)}let tn=0,un=0,F=0,Le=0,Ye=0,at=0,Ee=Ye,kt=at,He=F,qe=Le,P=0,M=0,X=0,ue=0;n.bbox={};let ae=!1,ye=!1,be=!1,te=!1,se=!1,ge=!1;function U(x,w,L){(L||x!=n.width||w!=n.height)&&re(x,w),ut(!1),be=!0,ye=!0,kn()}function re(x,w){n.width=tn=F=x,n.height=un=Le=w,Ye=at=0,Se(),We();let L=n.bbox;P=L.left=Mr(Ye*Ct,.5),M=L.top=Mr(at*Ct,.5),X=L.width=Mr(F*Ct,.5),ue=L.height=Mr(Le*Ct,.5)}let ne=3;function Te(){let x=!1,w=0;for(;!x;){w++;let L=Xr(w),I=Qi(w);x=w==ne||L&&I,x||(re(n.width,n.height),ye=!0)}}function _e({width:x,height:w}){U(x,w)}n.setSize=_e;function Se(){let x=!1,w=!1,L=!1,I=!1;T.forEach((V,j)=>{if(V.show&&V._show){let{side:le,_size:me}=V,Me=le%2,Oe=V.label!=null?V.labelSize:0,Ue=me+Oe;Ue>0&&(Me?(F-=Ue,le==3?(Ye+=Ue,I=!0):L=!0):(Le-=Ue,le==0?(at+=Ue,x=!0):w=!0))}}),ji[0]=x,ji[1]=L,ji[2]=w,ji[3]=I,F-=Ui[1]+Ui[3],Ye+=Ui[3],Le-=Ui[2]+Ui[0],at+=Ui[0]}function We(){let x=Ye+F,w=at+Le,L=Ye,I=at;function V(j,le){switch(j){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return L-=le,L+le;case 0:return I-=le,I+le}}T.forEach((j,le)=>{if(j.show&&j._show){let me=j.side;j._pos=V(me,j._size),j.label!=null&&(j._lpos=V(me,j.labelSize))}})}if(fe.dataIdx==null){let x=fe.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let L=x.prox=bt(x.prox),I=x.bias??=0;fe.dataIdx=(V,j,le,me)=>{if(j==0)return le;let Me=le,Oe=L(V,j,le,me)??Bt,Ue=Oe>=0&&Oe<Bt,ke=D.ori==0?F:Le,rt=fe.left,At=e[0],Et=e[j];if(w.has(Et[le])){Me=null;let yt=null,Ke=null,Xe;if(I==0||I==-1)for(Xe=le;yt==null&&Xe-- >0;)w.has(Et[Xe])||(yt=Xe);if(I==0||I==1)for(Xe=le;Ke==null&&Xe++<Et.length;)w.has(Et[Xe])||(Ke=Xe);if(yt!=null||Ke!=null)if(Ue){let $t=yt==null?-1/0:H(At[yt],D,ke,0),rn=Ke==null?1/0:H(At[Ke],D,ke,0),In=rt-$t,Ft=rn-rt;In<=Ft?In<=Oe&&(Me=yt):Ft<=Oe&&(Me=Ke)}else Me=Ke==null?yt:yt==null?Ke:le-yt<=Ke-le?yt:Ke}else Ue&&wn(rt-H(At[le],D,ke,0))>Oe&&(Me=null);return Me}}let je=x=>{fe.event=x};fe.idxs=ie,fe._lock=!1;let he=fe.points;he.show=bt(he.show),he.size=bt(he.size),he.stroke=bt(he.stroke),he.width=bt(he.width),he.fill=bt(he.fill);let Be=n.focus=gn({},i.focus||{alpha:.3},fe.focus),Je=Be.prox>=0,Pe=Je&&he.one,lt=[],Ht=[],qn=[];function Qo(x,w){let L=he.show(n,w);if(L instanceof HTMLElement)return pi(L,Gy),pi(L,x.class),cs(L,-10,-10,F,Le),g.insertBefore(L,lt[w]),L}function Gr(x,w){if(s==1||w>0){let L=s==1&&S[x.scale].time,I=x.value;x.value=L?gm(I)?Sm($,Mm(I,B)):I||Q:I||ib,x.label=x.label||(L?Zv:Yv)}if(Pe||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||xb||av,x.fillTo=bt(x.fillTo||lb),x.pxAlign=+Tt(x.pxAlign,y),x.pxRound=Im(x.pxAlign),x.stroke=bt(x.stroke||null),x.fill=bt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let L=sb(Jn(1,x.width),1),I=x.points=gn({},{size:L,width:Jn(1,L*.2),stroke:x.stroke,space:L*2,paths:_b,_stroke:null,_fill:null},x.points);I.show=bt(I.show),I.filter=bt(I.filter),I.fill=bt(I.fill),I.stroke=bt(I.stroke),I.paths=bt(I.paths),I.pxAlign=x.pxAlign}if(ee){let L=Ut(x,w);ot.splice(w,0,L[0]),Ge.splice(w,0,L[1]),de.values.push(null)}if(xe){ie.splice(w,0,null);let L=null;Pe?w==0&&(L=Qo(x,w)):w>0&&(L=Qo(x,w)),lt.splice(w,0,L),Ht.splice(w,0,0),qn.splice(w,0,0)}Ln("addSeries",w)}function pu(x,w){w=w??v.length,x=s==1?ld(x,w,Em,Pm):ld(x,w,{},Rm),v.splice(w,0,x),Gr(v[w],w)}n.addSeries=pu;function _l(x){if(v.splice(x,1),ee){de.values.splice(x,1),Ge.splice(x,1);let w=ot.splice(x,1)[0];vn(null,w.firstChild),w.remove()}xe&&(ie.splice(x,1),lt.splice(x,1)[0].remove(),Ht.splice(x,1),qn.splice(x,1)),Ln("delSeries",x)}n.delSeries=_l;let ji=[!1,!1,!1,!1];function gs(x,w){if(x._show=x.show,x.show){let L=x.side%2,I=S[x.scale];I==null&&(x.scale=L?v[1].scale:C,I=S[x.scale]);let V=I.time;x.size=bt(x.size),x.space=bt(x.space),x.rotate=bt(x.rotate),Ks(x.incrs)&&x.incrs.forEach(le=>{!js.has(le)&&js.set(le,$m(le))}),x.incrs=bt(x.incrs||(I.distr==2?Rv:V?m==1?Lv:Nv:Sr)),x.splits=bt(x.splits||(V&&I.distr==1?oe:I.distr==3?sd:I.distr==4?Jv:jv)),x.stroke=bt(x.stroke),x.grid.stroke=bt(x.grid.stroke),x.ticks.stroke=bt(x.ticks.stroke),x.border.stroke=bt(x.border.stroke);let j=x.values;x.values=Ks(j)&&!Ks(j[0])?bt(j):V?Ks(j)?bm($,vm(j,B)):gm(j)?Fv($,j):j||K:j||Kv,x.filter=bt(x.filter||(I.distr>=3&&I.log==10?tb:I.distr==3&&I.log==2?nb:Gm)),x.font=Um(x.font),x.labelFont=Um(x.labelFont),x._size=x.size(n,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ji[w]=!0,x._el=Ri(By,d))}}function xs(x,w,L,I){let[V,j,le,me]=L,Me=w%2,Oe=0;return Me==0&&(me||j)&&(Oe=w==0&&!V||w==2&&!le?Sn(wm.size/3):0),Me==1&&(V||le)&&(Oe=w==1&&!j||w==3&&!me?Sn(Am.size/2):0),Oe}let ea=n.padding=(i.padding||[xs,xs,xs,xs]).map(x=>bt(Tt(x,xs))),Ui=n._padding=ea.map((x,w)=>x(n,w,ji,0)),nn,ln=null,cn=null,Ji=s==1?v[0].idxs:null,hi=null,Hs=!1;function ta(x,w){if(e=x??[],n.data=n._data=e,s==2){nn=0;for(let L=1;L<v.length;L++)nn+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),hi=e[0],nn=hi.length;let L=e;if(G==2){L=e.slice();let I=L[0]=Array(nn);for(let V=0;V<nn;V++)I[V]=V}n._data=e=L}if(ut(!0),Ln("setData"),G==2&&(be=!0),w!==!1){let L=D;L.auto(n,Hs)?na():$s(C,L.min,L.max),te=te||fe.left>=0,ge=!0,kn()}}n.setData=ta;function na(){Hs=!0;let x,w;s==1&&(nn>0?(ln=Ji[0]=0,cn=Ji[1]=nn-1,x=e[0][ln],w=e[0][cn],G==2?(x=ln,w=cn):x==w&&(G==3?[x,w]=Wl(x,x,D.log,!1):G==4?[x,w]=dd(x,x,D.log,!1):D.time?w=x+Sn(86400/m):[x,w]=Vl(x,w,fd,!0))):(ln=Ji[0]=x=null,cn=Ji[1]=w=null)),$s(C,x,w)}let Wr,Gs,$r,E,k,J,Y,Z,Ae,Ie;function Ce(x,w,L,I,V,j){x??=Qp,L??=md,I??="butt",V??=Qp,j??="round",x!=Wr&&(u.strokeStyle=Wr=x),V!=Gs&&(u.fillStyle=Gs=V),w!=$r&&(u.lineWidth=$r=w),j!=k&&(u.lineJoin=k=j),I!=J&&(u.lineCap=J=I),L!=E&&u.setLineDash(E=L)}function De(x,w,L,I){w!=Gs&&(u.fillStyle=Gs=w),x!=Y&&(u.font=Y=x),L!=Z&&(u.textAlign=Z=L),I!=Ae&&(u.textBaseline=Ae=I)}function Ve(x,w,L,I,V=0){if(I.length>0&&x.auto(n,Hs)&&(w==null||w.min==null)){let j=Tt(ln,0),le=Tt(cn,I.length-1),me=L.min==null?tv(I,j,le,V,x.distr==3):[L.min,L.max];x.min=Hi(x.min,L.min=me[0]),x.max=Jn(x.max,L.max=me[1])}}let Qe={min:null,max:null};function pt(){for(let I in S){let V=S[I];W[I]==null&&(V.min==null||W[C]!=null&&V.auto(n,Hs))&&(W[I]=Qe)}for(let I in S){let V=S[I];W[I]==null&&V.from!=null&&W[V.from]!=null&&(W[I]=Qe)}W[C]!=null&&ut(!0);let x={};for(let I in W){let V=W[I];if(V!=null){let j=x[I]=uo(S[I],hv);if(V.min!=null)gn(j,V);else if(I!=C||s==2)if(nn==0&&j.from==null){let le=j.range(n,null,null,I);j.min=le[0],j.max=le[1]}else j.min=Bt,j.max=-Bt}}if(nn>0){v.forEach((I,V)=>{if(s==1){let j=I.scale,le=W[j];if(le==null)return;let me=x[j];if(V==0){let Me=me.range(n,me.min,me.max,j);me.min=Me[0],me.max=Me[1],ln=Vi(me.min,e[0]),cn=Vi(me.max,e[0]),cn-ln>1&&(e[0][ln]<me.min&&ln++,e[0][cn]>me.max&&cn--),I.min=hi[ln],I.max=hi[cn]}else I.show&&I.auto&&Ve(me,le,I,e[V],I.sorted);I.idxs[0]=ln,I.idxs[1]=cn}else if(V>0&&I.show&&I.auto){let[j,le]=I.facets,me=j.scale,Me=le.scale,[Oe,Ue]=e[V],ke=x[me],rt=x[Me];ke!=null&&Ve(ke,W[me],j,Oe,j.sorted),rt!=null&&Ve(rt,W[Me],le,Ue,le.sorted),I.min=le.min,I.max=le.max}});for(let I in x){let V=x[I],j=W[I];if(V.from==null&&(j==null||j.min==null)){let le=V.range(n,V.min==Bt?null:V.min,V.max==-Bt?null:V.max,I);V.min=le[0],V.max=le[1]}}}for(let I in x){let V=x[I];if(V.from!=null){let j=x[V.from];if(j.min==null)V.min=V.max=null;else{let le=V.range(n,j.min,j.max,I);V.min=le[0],V.max=le[1]}}}let w={},L=!1;for(let I in x){let V=x[I],j=S[I];if(j.min!=V.min||j.max!=V.max){j.min=V.min,j.max=V.max;let le=j.distr;j._min=le==3?Es(j.min):le==4?Zu(j.min,j.asinh):le==100?j.fwd(j.min):j.min,j._max=le==3?Es(j.max):le==4?Zu(j.max,j.asinh):le==100?j.fwd(j.max):j.max,w[I]=L=!0}}if(L){v.forEach((I,V)=>{s==2?V>0&&w.y&&(I._paths=null):w[I.scale]&&(I._paths=null)});for(let I in w)be=!0,Ln("setScale",I);xe&&fe.left>=0&&(te=ge=!0)}for(let I in W)W[I]=null}function ze(x){let w=id(ln-1,0,nn-1),L=id(cn+1,0,nn-1);for(;x[w]==null&&w>0;)w--;for(;x[L]==null&&L<nn-1;)L++;return[w,L]}function mt(){if(nn>0){let x=v.some(w=>w._focus)&&Ie!=Be.alpha;x&&(u.globalAlpha=Ie=Be.alpha),v.forEach((w,L)=>{if(L>0&&w.show&&(Jt(L,!1),Jt(L,!0),w._paths==null)){let I=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha);let V=s==2?[0,e[L][0].length-1]:ze(e[L]);w._paths=w.paths(n,L,V[0],V[1]),Ie!=I&&(u.globalAlpha=Ie=I)}}),v.forEach((w,L)=>{if(L>0&&w.show){let I=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha),w._paths!=null&&Dt(L,!1);{let V=w._paths!=null?w._paths.gaps:null,j=w.points.show(n,L,ln,cn,V),le=w.points.filter(n,L,j,V);(j||le)&&(w.points._paths=w.points.paths(n,L,ln,cn,le),Dt(L,!0))}Ie!=I&&(u.globalAlpha=Ie=I),Ln("drawSeries",L)}}),x&&(u.globalAlpha=Ie=1)}}function Jt(x,w){let L=w?v[x].points:v[x];L._stroke=L.stroke(n,x),L._fill=L.fill(n,x)}function Dt(x,w){let L=w?v[x].points:v[x],{stroke:I,fill:V,clip:j,flags:le,_stroke:me=L._stroke,_fill:Me=L._fill,_width:Oe=L.width}=L._paths;Oe=zt(Oe*Ct,3);let Ue=null,ke=Oe%2/2;w&&Me==null&&(Me=Oe>0?"#fff":me);let rt=L.pxAlign==1&&ke>0;if(rt&&u.translate(ke,ke),!w){let At=P-Oe/2,Et=M-Oe/2,yt=X+Oe,Ke=ue+Oe;Ue=new Path2D,Ue.rect(At,Et,yt,Ke)}w?Fe(me,Oe,L.dash,L.cap,Me,I,V,le,j):Nt(x,me,Oe,L.dash,L.cap,Me,I,V,le,Ue,j),rt&&u.translate(-ke,-ke)}function Nt(x,w,L,I,V,j,le,me,Me,Oe,Ue){let ke=!1;Me!=0&&R.forEach((rt,At)=>{if(rt.series[0]==x){let Et=v[rt.series[1]],yt=e[rt.series[1]],Ke=(Et._paths||Ma).band;Ks(Ke)&&(Ke=rt.dir==1?Ke[0]:Ke[1]);let Xe,$t=null;Et.show&&Ke&&iv(yt,ln,cn)?($t=rt.fill(n,At)||j,Xe=Et._paths.clip):Ke=null,Fe(w,L,I,V,$t,le,me,Me,Oe,Ue,Xe,Ke),ke=!0}}),ke||Fe(w,L,I,V,j,le,me,Me,Oe,Ue)}let bn=fo|od;function Fe(x,w,L,I,V,j,le,me,Me,Oe,Ue,ke){Ce(x,w,L,I,V),(Me||Oe||ke)&&(u.save(),Me&&u.clip(Me),Oe&&u.clip(Oe)),ke?(me&bn)==bn?(u.clip(ke),Ue&&u.clip(Ue),vt(V,le),dn(x,j,w)):me&od?(vt(V,le),u.clip(ke),dn(x,j,w)):me&fo&&(u.save(),u.clip(ke),Ue&&u.clip(Ue),vt(V,le),u.restore(),dn(x,j,w)):(vt(V,le),dn(x,j,w)),(Me||Oe||ke)&&u.restore()}function dn(x,w,L){L>0&&(w instanceof Map?w.forEach((I,V)=>{u.strokeStyle=Wr=V,u.stroke(I)}):w!=null&&x&&u.stroke(w))}function vt(x,w){w instanceof Map?w.forEach((L,I)=>{u.fillStyle=Gs=I,u.fill(L)}):w!=null&&x&&u.fill(w)}function _s(x,w,L,I){let V=T[x],j;if(I<=0)j=[0,0];else{let le=V._space=V.space(n,x,w,L,I),me=V._incrs=V.incrs(n,x,w,L,I,le);j=wb(w,L,me,I,le)}return V._found=j}function fn(x,w,L,I,V,j,le,me,Me,Oe){let Ue=le%2/2;y==1&&u.translate(Ue,Ue),Ce(me,le,Me,Oe,me),u.beginPath();let ke,rt,At,Et,yt=V+(I==0||I==3?-j:j);L==0?(rt=V,Et=yt):(ke=V,At=yt);for(let Ke=0;Ke<x.length;Ke++)w[Ke]!=null&&(L==0?ke=At=x[Ke]:rt=Et=x[Ke],u.moveTo(ke,rt),u.lineTo(At,Et));u.stroke(),y==1&&u.translate(-Ue,-Ue)}function Xr(x){let w=!0;return T.forEach((L,I)=>{if(!L.show)return;let V=S[L.scale];if(V.min==null){L._show&&(w=!1,L._show=!1,ut(!1));return}else L._show||(w=!1,L._show=!0,ut(!1));let j=L.side,le=j%2,{min:me,max:Me}=V,[Oe,Ue]=_s(I,me,Me,le==0?F:Le);if(Ue==0)return;let ke=V.distr==2,rt=L._splits=L.splits(n,I,me,Me,Oe,Ue,ke),At=V.distr==2?rt.map(Xe=>hi[Xe]):rt,Et=V.distr==2?hi[rt[1]]-hi[rt[0]]:Oe,yt=L._values=L.values(n,L.filter(n,At,I,Ue,Et),I,Ue,Et);L._rotate=j==2?L.rotate(n,yt,I,Ue):0;let Ke=L._size;L._size=Pi(L.size(n,yt,I,x)),Ke!=null&&L._size!=Ke&&(w=!1)}),w}function Qi(x){let w=!0;return ea.forEach((L,I)=>{let V=L(n,I,ji,x);V!=Ui[I]&&(w=!1),Ui[I]=V}),w}function ys(){for(let x=0;x<T.length;x++){let w=T[x];if(!w.show||!w._show)continue;let L=w.side,I=L%2,V,j,le=w.stroke(n,x),me=L==0||L==3?-1:1,[Me,Oe]=w._found;if(w.label!=null){let Kn=w.labelGap*me,fi=Sn((w._lpos+Kn)*Ct);De(w.labelFont[0],le,"center",L==2?"top":Jp),u.save(),I==1?(V=j=0,u.translate(fi,Sn(M+ue/2)),u.rotate((L==3?-Bl:Bl)/2)):(V=Sn(P+X/2),j=fi);let xr=Vm(w.label)?w.label(n,x,Me,Oe):w.label;u.fillText(xr,V,j),u.restore()}if(Oe==0)continue;let Ue=S[w.scale],ke=I==0?X:ue,rt=I==0?P:M,At=w._splits,Et=Ue.distr==2?At.map(Kn=>hi[Kn]):At,yt=Ue.distr==2?hi[At[1]]-hi[At[0]]:Me,Ke=w.ticks,Xe=w.border,$t=Ke.show?Ke.size:0,rn=Sn($t*Ct),In=Sn((w.alignTo==2?w._size-$t-w.gap:w.gap)*Ct),Ft=w._rotate*-Bl/180,on=p(w._pos*Ct),ui=(rn+In)*me,Zn=on+ui;j=I==0?Zn:0,V=I==1?Zn:0;let Ei=w.font[0],Fi=w.align==1?oo:w.align==2?Xu:Ft>0?oo:Ft<0?Xu:I==0?"center":L==3?Xu:oo,ns=Ft||I==1?"middle":L==2?"top":Jp;De(Ei,le,Fi,ns);let di=w.font[1]*w.lineGap,Ti=At.map(Kn=>p(a(Kn,Ue,ke,rt))),ki=w._values;for(let Kn=0;Kn<ki.length;Kn++){let fi=ki[Kn];if(fi!=null){I==0?V=Ti[Kn]:j=Ti[Kn],fi=""+fi;let xr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let jn=0;jn<xr.length;jn++){let Rp=xr[jn];Ft?(u.save(),u.translate(V,j+jn*di),u.rotate(Ft),u.fillText(Rp,0,0),u.restore()):u.fillText(Rp,V,j+jn*di)}}}Ke.show&&fn(Ti,Ke.filter(n,Et,x,Oe,yt),I,L,on,rn,zt(Ke.width*Ct,3),Ke.stroke(n,x),Ke.dash,Ke.cap);let is=w.grid;is.show&&fn(Ti,is.filter(n,Et,x,Oe,yt),I,I==0?2:1,I==0?M:P,I==0?ue:X,zt(is.width*Ct,3),is.stroke(n,x),is.dash,is.cap),Xe.show&&fn([on],[1],I==0?1:0,I==0?1:2,I==1?M:P,I==1?ue:X,zt(Xe.width*Ct,3),Xe.stroke(n,x),Xe.dash,Xe.cap)}Ln("drawAxes")}function ut(x){v.forEach((w,L)=>{L>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(I=>{I.min=null,I.max=null})))})}let sn=!1,Yn=!1,Ot=[];function pn(){Yn=!1;for(let x=0;x<Ot.length;x++)Ln(...Ot[x]);Ot.length=0}function kn(){sn||(xv(up),sn=!0)}function yl(x,w=!1){sn=!0,Yn=w,x(n),up(),w&&Ot.length>0&&queueMicrotask(pn)}n.batch=yl;function up(){if(ae&&(pt(),ae=!1),be&&(Te(),be=!1),ye){if(Xt(f,oo,Ye),Xt(f,"top",at),Xt(f,_a,F),Xt(f,ya,Le),Xt(g,oo,Ye),Xt(g,"top",at),Xt(g,_a,F),Xt(g,ya,Le),Xt(d,_a,tn),Xt(d,ya,un),h.width=Sn(tn*Ct),h.height=Sn(un*Ct),T.forEach(({_el:x,_show:w,_size:L,_pos:I,side:V})=>{if(x!=null)if(w){let j=V===3||V===0?L:0,le=V%2==1;Xt(x,le?"left":"top",I-j),Xt(x,le?"width":"height",L),Xt(x,le?"top":"left",le?at:Ye),Xt(x,le?"height":"width",le?Le:F),td(x,wr)}else pi(x,wr)}),Wr=Gs=$r=k=J=Y=Z=Ae=E=null,Ie=1,ra(!0),Ye!=Ee||at!=kt||F!=He||Le!=qe){ut(!1);let x=F/He,w=Le/qe;if(xe&&!te&&fe.left>=0){fe.left*=x,fe.top*=w,qr&&cs(qr,Sn(fe.left),0,F,Le),Yr&&cs(Yr,0,Sn(fe.top),F,Le);for(let L=0;L<lt.length;L++){let I=lt[L];I!=null&&(Ht[L]*=x,qn[L]*=w,cs(I,Pi(Ht[L]),Pi(qn[L]),F,Le))}}if(Wt.show&&!se&&Wt.left>=0&&Wt.width>0){Wt.left*=x,Wt.width*=x,Wt.top*=w,Wt.height*=w;for(let L in vu)Xt(jr,L,Wt[L])}Ee=Ye,kt=at,He=F,qe=Le}Ln("setSize"),ye=!1}tn>0&&un>0&&(u.clearRect(0,0,h.width,h.height),Ln("drawClear"),A.forEach(x=>x()),Ln("draw")),Wt.show&&se&&(vl(Wt),se=!1),xe&&te&&(gr(null,!0,!1),te=!1),de.show&&de.live&&ge&&(_u(),ge=!1),l||(l=!0,n.status=1,Ln("ready")),Hs=!1,sn=!1}n.redraw=(x,w)=>{be=w||!1,x!==!1?$s(C,D.min,D.max):kn()};function mu(x,w){let L=S[x];if(L.from==null){if(nn==0){let I=L.range(n,w.min,w.max,x);w.min=I[0],w.max=I[1]}if(w.min>w.max){let I=w.min;w.min=w.max,w.max=I}if(nn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&L.distr==2&&nn>0&&(w.min=Vi(w.min,e[0]),w.max=Vi(w.max,e[0]),w.min==w.max&&w.max++),W[x]=w,ae=!0,kn()}}n.setScale=mu;let gu,xu,qr,Yr,dp,fp,Zr,Kr,pp,mp,Gt,Kt,Ws=!1,Un=fe.drag,Rn=Un.x,Pn=Un.y;xe&&(fe.x&&(gu=Ri(Vy,g)),fe.y&&(xu=Ri(Hy,g)),D.ori==0?(qr=gu,Yr=xu):(qr=xu,Yr=gu),Gt=fe.left,Kt=fe.top);let Wt=n.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),jr=Wt.show?Ri(zy,Wt.over?g:f):null;function vl(x,w){if(Wt.show){for(let L in x)Wt[L]=x[L],L in vu&&Xt(jr,L,x[L]);w!==!1&&Ln("setSelect")}}n.setSelect=vl;function E_(x){if(v[x].show)ee&&td(ot[x],wr);else if(ee&&pi(ot[x],wr),xe){let L=Pe?lt[0]:lt[x];L!=null&&cs(L,-10,-10,F,Le)}}function $s(x,w,L){mu(x,{min:w,max:L})}function es(x,w,L,I){w.focus!=null&&P_(x),w.show!=null&&v.forEach((V,j)=>{j>0&&(x==j||x==null)&&(V.show=w.show,E_(j),s==2?($s(V.facets[0].scale,null,null),$s(V.facets[1].scale,null,null)):$s(V.scale,null,null),kn())}),L!==!1&&Ln("setSeries",x,w),I&&oa("setSeries",n,x,w)}n.setSeries=es;function T_(x,w){gn(R[x],w)}function A_(x,w){x.fill=bt(x.fill||null),x.dir=Tt(x.dir,-1),w=w??R.length,R.splice(w,0,x)}function C_(x){x==null?R.length=0:R.splice(x,1)}n.addBand=A_,n.setBand=T_,n.delBand=C_;function R_(x,w){v[x].alpha=w,xe&&lt[x]!=null&&(lt[x].style.opacity=w),ee&&ot[x]&&(ot[x].style.opacity=w)}let vs,Xs,mr,Jr={focus:!0};function P_(x){if(x!=mr){let w=x==null,L=Be.alpha!=1;v.forEach((I,V)=>{if(s==1||V>0){let j=w||V==0||V==x;I._focus=w?null:j,L&&R_(V,j?1:Be.alpha)}}),mr=x,L&&kn()}}ee&&Je&&St(nm,Re,x=>{fe._lock||(je(x),mr!=null&&es(null,Jr,!0,mn.setSeries))});function ts(x,w,L){let I=S[w];L&&(x=x/Ct-(I.ori==1?at:Ye));let V=F;I.ori==1&&(V=Le,x=V-x),I.dir==-1&&(x=V-x);let j=I._min,le=I._max,me=x/V,Me=j+(le-j)*me,Oe=I.distr;return Oe==3?co(10,Me):Oe==4?rv(Me,I.asinh):Oe==100?I.bwd(Me):Me}function L_(x,w){let L=ts(x,C,w);return Vi(L,e[0],ln,cn)}n.valToIdx=x=>Vi(x,e[0]),n.posToIdx=L_,n.posToVal=ts,n.valToPos=(x,w,L)=>S[w].ori==0?r(x,S[w],L?X:F,L?P:0):o(x,S[w],L?ue:Le,L?M:0),n.setCursor=(x,w,L)=>{Gt=x.left,Kt=x.top,gr(null,w,L)};function gp(x,w){Xt(jr,oo,Wt.left=x),Xt(jr,_a,Wt.width=w)}function xp(x,w){Xt(jr,"top",Wt.top=x),Xt(jr,ya,Wt.height=w)}let ia=D.ori==0?gp:xp,sa=D.ori==1?gp:xp;function I_(){if(ee&&de.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&ht)continue;let w=de.values[x],L=0;for(let I in w)Ge[x][L++].firstChild.nodeValue=w[I]}}function _u(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((L,I)=>{ie[I]=L}):cv(x.idx)||ie.fill(x.idx),de.idx=ie[0]),ee&&de.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!ht)&&D_(L,ie[L]);I_()}ge=!1,w!==!1&&Ln("setLegend")}n.setLegend=_u;function D_(x,w){let L=v[x],I=x==0&&G==2?hi:e[x],V;ht?V=L.values(n,x,w)??st:(V=L.value(n,w==null?null:I[w],x,w),V=V==null?st:{_:V}),de.values[x]=V}function gr(x,w,L){pp=Gt,mp=Kt,[Gt,Kt]=fe.move(n,Gt,Kt),fe.left=Gt,fe.top=Kt,xe&&(qr&&cs(qr,Sn(Gt),0,F,Le),Yr&&cs(Yr,0,Sn(Kt),F,Le));let I,V=ln>cn;vs=Bt,Xs=null;let j=D.ori==0?F:Le,le=D.ori==1?F:Le;if(Gt<0||nn==0||V){I=fe.idx=null;for(let me=0;me<v.length;me++){let Me=lt[me];Me!=null&&cs(Me,-10,-10,F,Le)}Je&&es(null,Jr,!0,x==null&&mn.setSeries),de.live&&(ie.fill(I),ge=!0)}else{let me,Me,Oe;s==1&&(me=D.ori==0?Gt:Kt,Me=ts(me,C),I=fe.idx=Vi(Me,e[0],ln,cn),Oe=H(e[0][I],D,j,0));let Ue=-10,ke=-10,rt=0,At=0,Et=!0,yt="",Ke="";for(let Xe=s==2?1:0;Xe<v.length;Xe++){let $t=v[Xe],rn=ie[Xe],In=rn==null?null:s==1?e[Xe][rn]:e[Xe][1][rn],Ft=fe.dataIdx(n,Xe,I,Me),on=Ft==null?null:s==1?e[Xe][Ft]:e[Xe][1][Ft];if(ge=ge||on!=In||Ft!=rn,ie[Xe]=Ft,Xe>0&&$t.show){let ui=Ft==null?-10:Ft==I?Oe:H(s==1?e[0][Ft]:e[Xe][0][Ft],D,j,0),Zn=on==null?-10:N(on,s==1?S[$t.scale]:S[$t.facets[1].scale],le,0);if(Je&&on!=null){let Ei=D.ori==1?Gt:Kt,Fi=wn(Be.dist(n,Xe,Ft,Zn,Ei));if(Fi<vs){let ns=Be.bias;if(ns!=0){let di=ts(Ei,$t.scale),Ti=on>=0?1:-1,ki=di>=0?1:-1;ki==Ti&&(ki==1?ns==1?on>=di:on<=di:ns==1?on<=di:on>=di)&&(vs=Fi,Xs=Xe)}else vs=Fi,Xs=Xe}}if(ge||Pe){let Ei,Fi;D.ori==0?(Ei=ui,Fi=Zn):(Ei=Zn,Fi=ui);let ns,di,Ti,ki,is,Kn,fi=!0,xr=he.bbox;if(xr!=null){fi=!1;let jn=xr(n,Xe);Ti=jn.left,ki=jn.top,ns=jn.width,di=jn.height}else Ti=Ei,ki=Fi,ns=di=he.size(n,Xe);if(Kn=he.fill(n,Xe),is=he.stroke(n,Xe),Pe)Xe==Xs&&vs<=Be.prox&&(Ue=Ti,ke=ki,rt=ns,At=di,Et=fi,yt=Kn,Ke=is);else{let jn=lt[Xe];jn!=null&&(Ht[Xe]=Ti,qn[Xe]=ki,cm(jn,ns,di,fi),am(jn,Kn,is),cs(jn,Pi(Ti),Pi(ki),F,Le))}}}}if(Pe){let Xe=Be.prox,$t=mr==null?vs<=Xe:vs>Xe||Xs!=mr;if(ge||$t){let rn=lt[0];rn!=null&&(Ht[0]=Ue,qn[0]=ke,cm(rn,rt,At,Et),am(rn,yt,Ke),cs(rn,Pi(Ue),Pi(ke),F,Le))}}}if(Wt.show&&Ws)if(x!=null){let[me,Me]=mn.scales,[Oe,Ue]=mn.match,[ke,rt]=x.cursor.sync.scales,At=x.cursor.drag;if(Rn=At._x,Pn=At._y,Rn||Pn){let{left:Et,top:yt,width:Ke,height:Xe}=x.select,$t=x.scales[ke].ori,rn=x.posToVal,In,Ft,on,ui,Zn,Ei=me!=null&&Oe(me,ke),Fi=Me!=null&&Ue(Me,rt);Ei&&Rn?($t==0?(In=Et,Ft=Ke):(In=yt,Ft=Xe),on=S[me],ui=H(rn(In,ke),on,j,0),Zn=H(rn(In+Ft,ke),on,j,0),ia(Hi(ui,Zn),wn(Zn-ui))):ia(0,j),Fi&&Pn?($t==1?(In=Et,Ft=Ke):(In=yt,Ft=Xe),on=S[Me],ui=N(rn(In,rt),on,le,0),Zn=N(rn(In+Ft,rt),on,le,0),sa(Hi(ui,Zn),wn(Zn-ui))):sa(0,le)}else bu()}else{let me=wn(pp-dp),Me=wn(mp-fp);if(D.ori==1){let rt=me;me=Me,Me=rt}Rn=Un.x&&me>=Un.dist,Pn=Un.y&&Me>=Un.dist;let Oe=Un.uni;Oe!=null?Rn&&Pn&&(Rn=me>=Oe,Pn=Me>=Oe,!Rn&&!Pn&&(Me>me?Pn=!0:Rn=!0)):Un.x&&Un.y&&(Rn||Pn)&&(Rn=Pn=!0);let Ue,ke;Rn&&(D.ori==0?(Ue=Zr,ke=Gt):(Ue=Kr,ke=Kt),ia(Hi(Ue,ke),wn(ke-Ue)),Pn||sa(0,le)),Pn&&(D.ori==1?(Ue=Zr,ke=Gt):(Ue=Kr,ke=Kt),sa(Hi(Ue,ke),wn(ke-Ue)),Rn||ia(0,j)),!Rn&&!Pn&&(ia(0,0),sa(0,0))}if(Un._x=Rn,Un._y=Pn,x==null){if(L){if(Cp!=null){let[me,Me]=mn.scales;mn.values[0]=me!=null?ts(D.ori==0?Gt:Kt,me):null,mn.values[1]=Me!=null?ts(D.ori==1?Gt:Kt,Me):null}oa(qu,n,Gt,Kt,F,Le,I)}if(Je){let me=L&&mn.setSeries,Me=Be.prox;mr==null?vs<=Me&&es(Xs,Jr,!0,me):vs>Me?es(null,Jr,!0,me):Xs!=mr&&es(Xs,Jr,!0,me)}}ge&&(de.idx=I,_u()),w!==!1&&Ln("setCursor")}let qs=null;Object.defineProperty(n,"rect",{get(){return qs==null&&ra(!1),qs}});function ra(x=!1){x?qs=null:(qs=g.getBoundingClientRect(),Ln("syncRect",qs))}function _p(x,w,L,I,V,j,le){fe._lock||Ws&&x!=null&&x.movementX==0&&x.movementY==0||(yu(x,w,L,I,V,j,le,!1,x!=null),x!=null?gr(null,!0,!0):gr(w,!0,!1))}function yu(x,w,L,I,V,j,le,me,Me){if(qs==null&&ra(!1),je(x),x!=null)L=x.clientX-qs.left,I=x.clientY-qs.top;else{if(L<0||I<0){Gt=-10,Kt=-10;return}let[Oe,Ue]=mn.scales,ke=w.cursor.sync,[rt,At]=ke.values,[Et,yt]=ke.scales,[Ke,Xe]=mn.match,$t=w.axes[0].side%2==1,rn=D.ori==0?F:Le,In=D.ori==1?F:Le,Ft=$t?j:V,on=$t?V:j,ui=$t?I:L,Zn=$t?L:I;if(Et!=null?L=Ke(Oe,Et)?a(rt,S[Oe],rn,0):-10:L=rn*(ui/Ft),yt!=null?I=Xe(Ue,yt)?a(At,S[Ue],In,0):-10:I=In*(Zn/on),D.ori==1){let Ei=L;L=I,I=Ei}}Me&&(w==null||w.cursor.event.type==qu)&&((L<=1||L>=F-1)&&(L=Mr(L,F)),(I<=1||I>=Le-1)&&(I=Mr(I,Le))),me?(dp=L,fp=I,[Zr,Kr]=fe.move(n,L,I)):(Gt=L,Kt=I)}let vu={width:0,height:0,left:0,top:0};function bu(){vl(vu,!1)}let yp,vp,bp,Mp;function Sp(x,w,L,I,V,j,le){Ws=!0,Rn=Pn=Un._x=Un._y=!1,yu(x,w,L,I,V,j,le,!0,!1),x!=null&&(St(Yu,Qu,wp,!1),oa(em,n,Zr,Kr,F,Le,null));let{left:me,top:Me,width:Oe,height:Ue}=Wt;yp=me,vp=Me,bp=Oe,Mp=Ue}function wp(x,w,L,I,V,j,le){Ws=Un._x=Un._y=!1,yu(x,w,L,I,V,j,le,!1,!0);let{left:me,top:Me,width:Oe,height:Ue}=Wt,ke=Oe>0||Ue>0,rt=yp!=me||vp!=Me||bp!=Oe||Mp!=Ue;if(ke&&rt&&vl(Wt),Un.setScale&&ke&&rt){let At=me,Et=Oe,yt=Me,Ke=Ue;if(D.ori==1&&(At=Me,Et=Ue,yt=me,Ke=Oe),Rn&&$s(C,ts(At,C),ts(At+Et,C)),Pn)for(let Xe in S){let $t=S[Xe];Xe!=C&&$t.from==null&&$t.min!=Bt&&$s(Xe,ts(yt+Ke,Xe),ts(yt,Xe))}bu()}else fe.lock&&(fe._lock=!fe._lock,gr(w,!0,x!=null));x!=null&&(vn(Yu,Qu),oa(Yu,n,Gt,Kt,F,Le,null))}function N_(x,w,L,I,V,j,le){if(fe._lock)return;je(x);let me=Ws;if(Ws){let Me=!0,Oe=!0,Ue=10,ke,rt;D.ori==0?(ke=Rn,rt=Pn):(ke=Pn,rt=Rn),ke&&rt&&(Me=Gt<=Ue||Gt>=F-Ue,Oe=Kt<=Ue||Kt>=Le-Ue),ke&&Me&&(Gt=Gt<Zr?0:F),rt&&Oe&&(Kt=Kt<Kr?0:Le),gr(null,!0,!0),Ws=!1}Gt=-10,Kt=-10,ie.fill(null),gr(null,!0,!0),me&&(Ws=me)}function Ep(x,w,L,I,V,j,le){fe._lock||(je(x),na(),bu(),x!=null&&oa(im,n,Gt,Kt,F,Le,null))}function Tp(){T.forEach(Eb),U(n.width,n.height,!0)}Er(zl,lo,Tp);let Qr={};Qr.mousedown=Sp,Qr.mousemove=_p,Qr.mouseup=wp,Qr.dblclick=Ep,Qr.setSeries=(x,w,L,I)=>{let V=mn.match[2];L=V(n,w,L),L!=-1&&es(L,I,!0,!1)},xe&&(St(em,g,Sp),St(qu,g,_p),St(tm,g,x=>{je(x),ra(!1)}),St(nm,g,N_),St(im,g,Ep),ad.add(n),n.syncRect=ra);let bl=n.hooks=i.hooks||{};function Ln(x,w,L){Yn?Ot.push([x,w,L]):x in bl&&bl[x].forEach(I=>{I.call(null,n,w,L)})}(i.plugins||[]).forEach(x=>{for(let w in x.hooks)bl[w]=(bl[w]||[]).concat(x.hooks[w])});let Ap=(x,w,L)=>L,mn=gn({key:null,setSeries:!1,filters:{pub:pm,sub:pm},scales:[C,v[1]?v[1].scale:null],match:[mm,mm,Ap],values:[null,null]},fe.sync);mn.match.length==2&&mn.match.push(Ap),fe.sync=mn;let Cp=mn.key,Mu=ug(Cp);function oa(x,w,L,I,V,j,le){mn.filters.pub(x,w,L,I,V,j,le)&&Mu.pub(x,w,L,I,V,j,le)}Mu.sub(n);function O_(x,w,L,I,V,j,le){mn.filters.sub(x,w,L,I,V,j,le)&&Qr[x](null,w,L,I,V,j,le)}n.pub=O_;function U_(){Mu.unsub(n),ad.delete(n),Cn.clear(),nd(zl,lo,Tp),c.remove(),Re?.remove(),Ln("destroy")}n.destroy=U_;function Su(){Ln("init",i,e),ta(e||i.data,!1),W[C]?mu(C,W[C]):na(),se=Wt.show&&(Wt.width>0||Wt.height>0),te=ge=!0,U(i.width,i.height)}return v.forEach(Gr),T.forEach(gs),t?t instanceof HTMLElement?(t.appendChild(c),Su()):t(n,Su):Su(),n}xn.assign=gn;xn.fmtNum=pd;xn.rangeNum=Vl;xn.rangeLog=Wl;xn.rangeAsinh=dd;xn.orient=Ar;xn.pxRatio=Ct;xn.join=gv;xn.fmtDate=gd,xn.tzDate=Av;xn.sync=ug;{xn.addGap=cb,xn.clipGaps=ql;let i=xn.paths={points:xg};i.linear=yg,i.stepped=db,i.bars=fb,i.spline=mb}function gt(i){let{heads:e,rows:t,caption:n,strong:s,text:r=[]}=i,o=h=>[h===0||r.includes(h)?"text":"number",h===s?"strong":""].join(" ").trim(),a=e.map((h,u)=>b("th",{scope:"col",class:o(u)},h)),l=t.map(h=>b("tr",{},...h.map((u,d)=>d===0?b("th",{scope:"row"},u):b("td",{class:o(d)},u)))),c=n?b("caption.unseen",{},n):null;return b("div.scroll",{},b("table.data",{},c,b("thead",{},b("tr",{},...a)),b("tbody",{},...l)))}function en(i){let e=new wd(i);return e.isEmpty?null:e.element}function Sg(i){let e=[];return i.x.forEach((t,n)=>{let s=i.y[n];pe(t)&&pe(s)&&e.push([t,s])}),e.sort((t,n)=>t[0]-n[0])}var Sd='12px system-ui, "Segoe UI", Roboto, Arial, sans-serif',Tb={line:[],steps:[],dots:[],dashed:[6,4],dotted:[2,3]},wd=class{constructor(e){this.options=e;this.series=e.series,this.lines=e.series.map(Sg);let t=this.lines.flat().map(([,r])=>r),n=t.filter(r=>r>0);this.isEmpty=t.length===0,this.isLog=e.y.log===!0&&n.length>0&&t.every(r=>r>=0);let s=this.isLog&&n.length<t.length;this.floor=s?10**(Math.floor(Math.log10(Math.min(...n)))-1):null,this.box.append(this.tip),this.box.setAttribute("aria-label",this.summary()),this.box.addEventListener("keydown",r=>this.onKey(r)),this.box.addEventListener("blur",()=>this.plot?.setCursor({left:-10,top:-10})),this.element=b("div.chart",{},this.legend(),this.box,this.spoken,this.asTable()),Ib(this.box,r=>this.resize(r)),Db(this.box,()=>this.plot?.redraw(!1,!0))}options;element;isEmpty;box=b("div.chart-box",{tabindex:"0",role:"img"});tip=b("div.chart-tip",{hidden:!0});spoken=b("div.unseen",{"aria-live":"polite"});series;lines;isLog;floor;plot=null;data(){let e=this.lines.map(t=>[t.map(([n])=>n),t.map(([,n])=>this.floor!==null&&n<=0?this.floor:n)]);return xn.join(e)}resize(e){let t=this.options.height??250;this.plot===null?this.begin(e):this.plot.setSize({width:e,height:t})}begin(e){let{x:t,y:n,height:s=250}=this.options,r=o=>(a,l,c)=>this.range(o,l,c);this.plot=new xn({width:e,height:s,legend:{show:!1},padding:[10,14,0,0],cursor:{y:!1,drag:{x:!1,y:!1},points:{size:8,fill:(o,a)=>As(this.series[a-1]?.color??"--ink")}},scales:{x:{time:!1,range:r(t)},y:{distr:this.isLog?3:1,range:r(n)}},axes:[this.axis(t,!1),this.axis(n,!0)],series:[{},...this.series.map(o=>Cb(o))],hooks:{drawAxes:[o=>this.drawMarks(o)],setCursor:[o=>this.showTip(o)]}},this.data(),this.box)}range(e,t,n){if(t===null||n===null)return[e.from??0,e.to??1];if(e===this.options.y&&this.isLog)return[wg(t,Math.floor),wg(n,Math.ceil)];if(e===this.options.x)return Rb(e.from??t,e.to??n);let[s,r]=xn.rangeNum(t,n,.08,!0);return[e.from??s,e.to??r]}axis(e,t){return{label:e.unit?`${e.label}, ${e.unit}`:e.label,labelSize:20,labelGap:t?2:0,labelFont:Sd,font:Sd,stroke:()=>As("--quiet"),grid:{stroke:()=>As("--line"),width:1},ticks:{stroke:()=>As("--line"),width:1,size:5},space:t?32:64,values:(n,s)=>s.map(r=>this.tick(r,t)),size:t?Pb:34}}tick(e,t){return e===null?"":t&&e===this.floor?"0":ce(e,6)}drawMarks(e){let{left:t,top:n,width:s,height:r}=e.bbox,o=a=>Math.min(Math.max(e.valToPos(a,"x",!0),t),t+s);e.ctx.save();for(let a of this.options.marks??[]){let[l,c]=[o(a.from),o(a.to??a.from)];e.ctx.fillStyle=e.ctx.strokeStyle=As(a.color),a.to!==void 0?(e.ctx.globalAlpha=.16,e.ctx.fillRect(l,n,Math.max(c-l,1),r)):(e.ctx.globalAlpha=1,e.ctx.lineWidth=1.5*devicePixelRatio,e.ctx.setLineDash([5,4].map(h=>h*devicePixelRatio)),e.ctx.beginPath(),e.ctx.moveTo(l,n),e.ctx.lineTo(l,n+r),e.ctx.stroke())}e.ctx.restore()}showTip(e){let{idx:t,left:n}=e.cursor;if(t==null||n===void 0||n<0){this.tip.hidden=!0;return}let s=e.data[0][t]??0,r=this.lines.flatMap((f,g)=>{let y=this.series[g],p=y&&e.series[g+1]?.show?Ab(f,s,y.style??"line"):null;return y&&p!==null?[{series:y,y:p}]:[]}),{unit:o,label:a}=this.options.x,l=`${a} ${ce(s,5)}${o?` ${o}`:""}`,c=f=>`${ce(f,5)}${this.options.y.unit?` ${this.options.y.unit}`:""}`,h=f=>b("div",{},wa(f.series.color),b("span",{},f.series.name),b("b",{},c(f.y)));this.tip.replaceChildren(b("div",{class:"chart-tip-head"},l),...r.map(h)),this.tip.hidden=r.length===0;let u=n>e.over.clientWidth/2,d=e.over.offsetLeft;this.tip.style.left=u?"":`${d+n+14}px`,this.tip.style.right=u?`${this.box.clientWidth-d-n+14}px`:"",document.activeElement===this.box&&(this.spoken.textContent=[l,...r.map(f=>`${f.series.name} ${c(f.y)}`)].join(", "))}onKey(e){let t=this.plot;if(t===null)return;let n=t.data[0].length-1,s=t.cursor.idx??-1,o={ArrowLeft:s-1,ArrowRight:s+1,Home:0,End:n}[e.key];if(o===void 0||e.ctrlKey||e.metaKey||e.altKey)return;e.preventDefault();let a=t.data[0][Math.min(Math.max(o,0),n)];a!==void 0&&t.setCursor({left:t.valToPos(a,"x"),top:t.over.clientHeight/2})}legend(){let e=this.series.map((s,r)=>({series:s,i:r})).filter(({series:s})=>!s.quiet&&Sg(s).length>0),t=(this.options.marks??[]).map(s=>b("span",{},wa(s.color,s.to===void 0?"dashed":"band"),s.name));if(e.length<2&&t.length===0)return b("div",{class:"chart-legend",hidden:!0});let n=({series:s,i:r})=>{let o=b("button",{type:"button","aria-pressed":"true",title:"Hide or show"},wa(s.color,s.style),s.name);return o.addEventListener("click",()=>{let a=o.getAttribute("aria-pressed")!=="true";o.setAttribute("aria-pressed",String(a)),this.series.forEach((l,c)=>{(c===r||l.quiet&&l.name===s.name)&&this.plot?.setSeries(c+1,{show:a})})}),o};return b("div",{class:"chart-legend"},...e.map(n),...t)}asTable(){let e=b("details",{class:"chart-table"},b("summary",{},"Show as table"));return e.addEventListener("toggle",()=>{if(e.querySelector(".scroll")?.remove(),!e.open)return;let{x:t,y:n,title:s}=this.options,[r,...o]=this.columns(),a=n.unit?`, ${n.unit}`:"",l=[t.unit?`${t.label}, ${t.unit}`:t.label,...this.series.map(h=>h.name+a)],c=(r??[]).map((h,u)=>[ce(h,6),...o.map(d=>ce(d[u],6))]);e.append(gt({heads:l,rows:c,caption:s}))}),e}columns(){let e=[...new Set(this.lines.flat().map(([n])=>n))].sort((n,s)=>n-s),t=n=>{let s=new Map(n);return e.map(r=>s.get(r))};return[e,...this.lines.map(t)]}summary(){let{title:e,x:t,y:n}=this.options,s=(l,c)=>{let[h,u]=[ce(Math.min(...c),3),ce(Math.max(...c),3)];return`from ${h} to ${u}${l.unit?` ${l.unit}`:""}`},r=this.lines.map((l,c)=>({line:l,name:this.series[c]?.name??""})).filter(({line:l})=>l.length>0),o=r.flatMap(({line:l})=>l.map(([c])=>c)),a=r.map(({line:l,name:c})=>`${c===e?"":`${c} `}${s(n,l.map(([,h])=>h))}`);return`${e}: ${a.join("; ")}; over ${t.label} ${s(t,o)}. Arrow keys read values.`}};function Ab(i,e,t){let n=i.findIndex(([l])=>l>=e);if(n<0)return null;let[s,r]=i[n];if(s===e)return r;if(n===0||t==="dots")return null;let[o,a]=i[n-1];return t==="steps"?a:a+(e-o)/(s-o)*(r-a)}function Cb(i){let e=i.style??"line",t=e==="dots",n=xn.paths.stepped?.({align:1});return{label:i.name,stroke:()=>As(i.color),width:2,dash:Tb[e],points:{fill:()=>As("--sheet")},...i.fill?{fill:()=>Lb(As(i.color))}:{},...t?{paths:()=>null,points:{show:!0,size:10,width:2,fill:()=>As(i.color)}}:{},...e==="steps"&&n?{paths:n,points:{show:!1}}:{}}}function Rb(i,e){return i<e?[i,e]:[i-.5,e+.5]}function wg(i,e){let t=10**Math.floor(Math.log10(i));return e(i/t)*t}function Pb(i,e){i.ctx.save(),i.ctx.font=Sd;let t=(e??[]).map(n=>i.ctx.measureText(n??"").width);return i.ctx.restore(),Math.ceil(Math.max(16,...t))+14}function As(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()||"#5a6775"}function Lb(i){return`color-mix(in srgb, ${i} 22%, transparent)`}function wa(i,e="line"){return b("i",{class:`swatch swatch-${e}`,style:`--swatch: var(${i})`,"aria-hidden":"true"})}function Ib(i,e){let t=0;new ResizeObserver(()=>{let s=i.clientWidth;s===t||s===0||(t=s,e(s))}).observe(i)}function Db(i,e){let t=matchMedia("(prefers-color-scheme: dark)"),n=()=>{i.isConnected?e():t.removeEventListener("change",n)};t.addEventListener("change",n)}function jl(i,e,t,n){let s=t,r=()=>{},o=l=>{s=l,r(),n(l)},a=e.map(l=>[l,l]);return b("div.chosen",{},b("span.quiet",{},i),zn(i,a,()=>s,o,l=>r=l))}var Eg=new WeakMap;function nt(i){if(!Qn(i.report))return{};let e=Eg.get(i.report);return e||(e=Ed(i.report),Eg.set(i.report,e)),e}function Ed(i){return Array.isArray(i)?i.map(Ed):Qn(i)?Object.fromEntries(Object.entries(i).flatMap(([e,t])=>t===null?[]:[[e,Ed(t)]])):i??void 0}function Qn(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)}function Rt(i){return Array.isArray(i)?i:[]}function Ea(i){return typeof i?.band_half_width=="number"}function Vn(i,e=""){return i.filter(Tg).map(t=>b("p",{class:e||null},Ys(Ag(t))))}function Ta(i){let e=i.filter(Tg);return e.length===0?null:b("ul",{},...e.map(t=>b("li",{},Ys(Ag(t)))))}function Tg(i){return typeof i=="string"&&i!==""}function Ag(i){let e=/^[a-z]+[ ,]/.test(i)?i.charAt(0).toUpperCase()+i.slice(1):i;return/[.!?:]$/.test(e)?e:`${e}.`}function xt(i,...e){return b("div.part",{},b("h3",{},i),...e)}function Li(i,e){let t=b("button.copy",{type:"button"},i);return t.addEventListener("click",()=>{let n=r=>{t.textContent=r,window.setTimeout(()=>t.textContent=i,1600)};(navigator.clipboard?.writeText(e())??Promise.reject(new Error("no clipboard"))).then(()=>n("Copied"),()=>n("The browser refused to copy"))}),t}function Ii(i){let e=t=>/[",\n]/.test(t)?`"${t.replaceAll('"','""')}"`:t;return i.map(t=>e(t==null?"":String(t))).join(",")}var Nb=["model calls","seconds","iterations"],Jl="model calls";function Td(i,e){let t=Nb.filter(a=>i.some(l=>Ql(l,a).some(pe))),n=t.includes(Jl)?Jl:t.at(-1)??Jl,s=b("div.charts"),r=a=>s.replaceChildren(...e(a).filter(l=>l!==null)),o=a=>{Jl=a,r(a)};return r(n),b("div",{},jl("Over",t,n,o),s)}function Ql(i,e){let t=s=>i.history?.[s]??[];if(e==="seconds")return t("seconds");if(e==="iterations")return t("iteration");let n=t("adjoint_calls");return t("forward_calls").map((s,r)=>pe(s)?s+(n[r]??0):null)}function Ad(i){return i==="seconds"?{label:"time",unit:"s",from:0}:{label:i==="iterations"?"iteration":"model calls (dose and adjoint)",from:0}}function Cg({run:i}){let e=kb(i),t=Vn([Ub(nt(i)),i.texts?.gap,Fb(nt(i).levels)]),n=Hb(nt(i).process_window);if(e.length===0&&t.length===0&&!n)return null;let s=e.length>0&&Td([i],r=>e.map(o=>Bb(i,o,r)));return b("div",{},...t,s,zb(i),Vb(i),n)}var Ob={loss:"the lowest loss",print:"the best IoU on the job's voxels",last:"the last step"};function Ub({history:i}){let e=i?.kept;if(!e||!pe(e.iteration))return null;let t=Ob[e.by??""];return`The patterns are those after iteration ${e.iteration}${pe(i.iterations)?` of ${i.iterations}`:""}${t?`: ${t}`:""}.`}function Fb(i){if(!i)return null;let e=n=>ce(n,4),t=pe(i.diffused_loss)?` (${e(i.diffused_loss)} by error diffusion)`:"";return`As the machine shows them the patterns have a loss of ${e(i.loss)}, plainly rounded ${e(i.rounded_loss)}${t}: ${e(i.steps)} steps and ${e(i.calls)} model calls, with a full scale of ${e(i.scale)} times the brightest pixel before.`}function kb(i){let e=s=>i.history?.[s]??[],t=Object.keys(i.history??{}).filter(s=>s.startsWith("response."));return[{title:"Loss",y:{label:"loss",log:!0},of:e("loss")},{title:"Voxels that would print wrongly",y:{label:"1 − IoU",log:!0},of:e("iou").map(s=>pe(s)?1-s:null)},{title:"Process window",y:{label:"response"},of:e("process_window")},{title:"Projected gradient",y:{label:"relative to the first",log:!0},of:e("projected_gradient")},...t.map(s=>({title:`Response: ${s.slice(9)}`,y:{label:"found so far"},of:e(s)}))].filter(s=>s.of.filter(pe).length>1)}function Bb(i,e,t){let n=e.of.filter(pe);if(n.every(o=>o===0))return xt(e.title,b("p.note",{},`It is 0 at each of the ${n.length} points that were measured.`));let s={name:e.title,color:"--accent",x:Ql(i,t),y:e.of},r=en({title:e.title,x:Ad(t),y:e.y,series:[s]});return r&&xt(e.title,r)}function zb(i){let e=g=>i.history?.[g]?.findLast(pe),t=nt(i).history,n=e("iteration")??t?.iterations;if(!pe(n))return null;let[s,r]=[e("forward_calls")??t?.forward_calls,e("adjoint_calls")??t?.adjoint_calls],o=e("seconds"),a=pe(o)?`, ${ce(o,3)} s`:"",c=(i.history?.projected_gradient??[]).findIndex(pe),h=c>0?(i.history?.iteration?.[c]??1)-1:0,u=h>0?` After iteration ${h} the voxels became finer: earlier numbers belong to coarser voxels, and the gradient curve begins there.`:"",d=pe(s)?`, ${ce(s,6)} dose and ${ce(r,6)} adjoint calls`:"",f=pe(s)?" Compare methods by model calls, not by iterations.":"";return b("p.note",{},`${ce(n,6)} iterations${d}${a}.${f}${u}`)}function Vb(i){let e=nt(i).response;if(!Qn(e))return null;let t=Object.entries(e).map(([n,s])=>[n,ce(s,4)]);return xt("Response that was found",gt({caption:"Response that was found",heads:["parameter","value"],rows:t}))}function Hb(i){if(!i)return null;let e=r=>ce(r,4),n=[["Outliers that are left out at either end",pe(i.outliers)?`${ce(100*i.outliers,3)} %`:"–"],["Thresholds of the objective, lower and upper",(i.thresholds??[]).map(e).join(", ")],["All else of the part lies above",e(i.part_above)],["All else of the part lies below",e(i.part_below)],["All else of the void lies below",e(i.void_below)],["Process window",e(i.window)],["Range in the part",e(i.range)],["Bound of that range",e(i.ipdr)]],s=b("p.note",{},"On the optimization's voxels, before the patterns are written.");return xt("Process window that the objective found",s,gt({caption:"Process window that the objective found",heads:["","response"],rows:n}))}var Rg=6;function Aa(i){return`--run-${i%Rg+1}`}function Pg(i){return i<Rg?"line":"dashed"}function Cd(i,e,t,n){return{name:i.name,color:Aa(e),style:Pg(e),x:t,y:n}}function xo(i,e){return b("span.run-name",{},wa(Aa(e),Pg(e)),i.name)}function Ig({runs:i}){if(!i.some(r=>(r.history?.loss??[]).filter(pe).length>1))return null;let e=(r,o,a,l)=>{let c=i.map((u,d)=>Cd(u,d,Ql(u,l),a(u))),h=en({title:`${r} over ${l}`,x:Ad(l),y:o,series:c});return h&&xt(r,h)},t=r=>(r.history?.iou??[]).map(o=>pe(o)?1-o:null),n=Td(i,r=>[e("Loss",{label:"loss",log:!0},o=>o.history?.loss??[],r),e("Voxels that would print wrongly",{label:"1 − IoU",log:!0},t,r),e("Process window",{label:"response"},o=>o.history?.process_window??[],r)]);return b("div",{},n,b("p.note",{},"Compare methods by model calls, not by iterations; seconds are those of the machine of each run. IoU is that on the grid of each optimization, where it was measured."))}function Dg({runs:i}){let e=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:i.map((n,s)=>{let r=Rt(nt(n).evaluation?.iou_curve);return Cd(n,s,r.map(o=>o?.[0]),r.map(o=>o?.[1]))})}),t=en({title:"Dose of part and void",x:{label:"response to the dose"},y:{label:"share of the voxels per unit",log:!0},series:i.flatMap(Gb)});return!e&&!t?null:b("div.charts",{},e&&xt("IoU over the gel threshold",b("p.note",{},"A broad plateau tolerates errors of exposure."),e),t&&xt("Dose of part and void",b("p.note",{},"Share of the voxels per unit of the response: part in full lines, void in dotted ones."),t))}function Gb(i,e){let t=nt(i).evaluation?.histogram;return[{name:i.name,color:Aa(e),style:"steps",...Lg(t,"part")},{name:i.name,color:Aa(e),style:"dotted",quiet:!0,...Lg(t,"void")}]}function Lg(i,e){let t=i?.[e]??[],[n,s]=i?.range??[],r=t.reduce((a,l)=>a+(l??0),0);if(!pe(n)||!pe(s)||r===0)return{x:[],y:[]};let o=(s-n)/t.length;return{x:t.map((a,l)=>n+(l+.5)*o),y:t.map(a=>(a??0)/(r*o))}}var Wb=.2,Rd={"x–y":2,"x–z":1,"y–z":0};function Ng(i){return i.data.runs.filter(t=>as(t,"response","")).length>1?Ci(i,$b):null}async function $b(i){let{state:e,gone:t}=i,n=[],s=Cl(),r=T=>{T===null?n.forEach(S=>S.redraw(!0)):s.say(T)},{read:o,problems:a}=await Xb(i,r),[l,...c]=o;if(!l||c.length===0)throw new Error(a[0]??"Fewer than two runs hold a dose.");let h={low:Math.min(...o.map(({volume:T})=>T.info.low)),high:Math.max(...o.map(({volume:T})=>T.info.high))},u=c.filter(({volume:T})=>qb(T,l.volume)),d=c.filter(T=>!u.includes(T)),f=o.map(({name:T,volume:S,slices:R})=>({title:T,layer:ca(T,"Dose",S,R,null,h)})),g=u.map(T=>({title:T.name,layer:Ru(T.volume,l.volume,Yb(T,l),Wb*h.high,T.name,`dose − that of ${l.name}`)})),y=b("div"),p=new AbortController;t.addEventListener("abort",()=>p.abort());let m=T=>{p.abort(),p=new AbortController;let{signal:S}=p,R=A=>{let z=new Zs({state:e,grid:l.volume,signal:S});return z.show(A.map(O=>({axis:T,...O}))),z};n=[f,g].filter(A=>A.length>0).map(R);let[C,_]=n.map(A=>b("div.runs-planes",{style:`--runs: ${o.length}`},A.element));y.replaceChildren(b("div",{},C,si(f[0].layer.legend())),_?xt(`Difference to ${l.name}`,b("p.note",{},"Red: a higher dose. Blue: a lower one."),_,si(g[0].layer.legend())):"")};m(Rd["x–y"]);let v=Object.keys(Rd);return b("div",{},...a.map(T=>b("p.problem",{role:"alert"},T)),...Vn(["Written patterns, vial turning, on one scale. A click, a slider or an arrow key moves all planes."],"quiet"),...d.map(({name:T})=>b("p.note",{},`No difference is drawn for ${T}: its voxels differ from those of ${l.name}.`)),jl("Plane",v,"x–y",T=>m(Rd[T])),s.element,y)}async function Xb({data:i,stores:e,gone:t},n){let s=[],r=async a=>{let l=i.runs[a],c=as(l,"response","");if(!c)return null;try{return{name:l.name,volume:await e[a].volume(c),slices:new ro(l,e[a],t,h=>n(h&&`${l.name}: ${h}`))}}catch(h){return s.push(`${l.name}: ${h instanceof Error?h.message:String(h)}`),null}};return{read:(await Promise.all(i.runs.map((a,l)=>r(l)))).filter(a=>a!==null),problems:s}}function qb(i,e){let t=(n,s)=>Math.abs(n-s)<1e-6;return ha(i,e)&&i.pitch.every((n,s)=>t(n,e.pitch[s]))&&i.info.center_xyz_mm.every((n,s)=>t(n,e.info.center_xyz_mm[s]))}function Yb(i,e){return{of:(t,n,s)=>(t===i.volume?i:e).slices.of(t,n,s)}}function Og(i,e,t){let n=[...new Set(i.runs.map(a=>nt(a).part).filter(a=>a!==void 0))],s=i.runs.filter(a=>nt(a).is_toy===!0).map(a=>a.name),r=i.runs.filter(a=>(nt(a).species??[]).length>1).map(a=>`${a.name} (${nt(a).species?.[0]?.name??""})`),o=i.runs.map((a,l)=>{let c=b("button",{type:"button","aria-pressed":String(l===e)},xo(a,l));return c.addEventListener("click",()=>t.set({run:l})),c});return b("div.head",{},b("p.brand",{},"Tomolith comparison"),b("h1",{},`${i.runs.length} runs`),b("p.lead",{},`${n.length===1?"Part":"Parts"}: ${n.join(", ")}`),s.length>0&&b("p.quiet",{},`${s.join(", ")}: ${s.length===1?"a toy of its job, whose":"toys of their jobs, whose"} pixels are three times as large.`),r.length>0&&b("p.quiet",{},`Of several species the numbers are those of the first: ${r.join(", ")}.`),b("div.chosen",{},b("span.quiet",{},"Shown in full below the comparison"),b("div.choice",{role:"group","aria-label":"Run that is shown in full"},...o)))}function Ug({differing_keys:i},e){if(i.length===0)return b("p.quiet",{},"Nothing.");let t=i.map(({key:n,values:s})=>[b("code",{},n),...s.map(r=>r??Dn)]);return b("div.job-keys",{},gt({caption:"Keys of the jobs that differ",heads:["key",...e.map(xo)],rows:t,text:e.map((n,s)=>s+1)}))}function Fg({data:i,run:e}){let{part:t,evaluation:n,run:s}=nt(e),r=i.runs.length===1&&!i.sweep,o=s?.created;return b("div.head",{},b("p.brand",{},[Zb[e.state],o].filter(Boolean).join(" · ")),b(r?"h1":"h2",{},r?t??e.name:e.name),b("p.lead",{},Ys([e.texts?.lead,e.texts?.print_time].filter(Boolean).join(" "))),jb(e.texts?.facts??[]),n?Jb(i,n):null)}var Zb={done:"Tomolith print report",running:"Tomolith, a run that goes on",check:"Tomolith, a job before it runs",failed:"Tomolith, a run that failed",canceled:"Tomolith, a run that was canceled"},Kb=60;function jb(i){return i.length===0?null:b("dl.facts",{},...i.map(([e,t])=>b(t.length>Kb?"div.long":"div",{},b("dt",{},e),b("dd",{},Ys(t)))))}function Pd(i,e){return(Ea(e)?i.gray_headline:i.headline).flatMap(n=>i.metrics.find(s=>s.name===n)??[])}function Jb(i,e){return b("div.cards",{},...Pd(i,e).map(t=>Qb(t,e)))}function Qb(i,e){let t=e[i.name],n=Sl(t,i.unit,e.grid?.pitch_mm),s=i.name==="iou"?4:3,{unit:r}=ss(i.unit);return b("div.card",{"data-metric":i.name},b("h3",{},i.title),b("p.big",{},Js(i,t,s),pe(t)&&r!==""&&b("small",{},` ${r}`)),b("p",{},n!==""&&b("b",{},`${n}. `),i.summary,eM(i,e)))}function Js(i,e,t){let{factor:n}=ss(i.unit);return ce(pe(e)?e*n:null,t)}function eM(i,{farthest:e}){let t=e?.at_xyz_mm;if(i.name!=="hausdorff_mm"||!t?.every(pe))return"";let[n,s,r]=t.map(o=>ce(o,3));return` It is at x = ${n}, y = ${s}, z = ${r} mm: ${(e?.side??"").replaceAll("_"," ")}.`}function kg({data:i,run:e}){let{evaluation:t,optimization:n}=nt(e),s=[{name:"Turning",evaluation:t},{name:"Optimization",evaluation:n}].filter(l=>!!l.evaluation),r=iM(i.metrics,s,Ea(t)?i.gray_headline:[]);if(r.length===0)return null;let o=Ea(t)?" For a gray target, “part” is where its value is at least ½.":"",a=s.map(({name:l,evaluation:c})=>b("span",{},l,b("small",{},sM(c))));return b("div",{},b("p.quiet",{},`↑ larger is better, ↓ smaller is better. The first column is on the evaluation's voxels, from the patterns as they were written, while the vial turns; the other one is of the patterns before they are written, on the job's own voxels.${o}`),Li("Copy as CSV",()=>oM(r,s)),gt({caption:"All numbers",heads:["",...a],rows:r.map(l=>[Ca(l),...s.map(c=>rM(l,c))]),strong:1}),tM(s))}function tM(i){let e=i.map(({name:n,evaluation:s},r)=>{let o=Rt(s.iou_curve);return{name:n.toLowerCase(),color:nM[r],style:r===0?"line":"dashed",x:o.map(a=>a?.[0]),y:o.map(a=>a?.[1])}}),t=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:e});return t&&xt("IoU over the gel threshold",t)}var nM=["--run-1","--run-2"];function iM(i,e,t){let n=i.filter(r=>e.some(({evaluation:o})=>pe(o[r.name]))),s=r=>t.includes(r.name)?0:1;return n.sort((r,o)=>s(r)-s(o))}function Ca(i){let{unit:e}=ss(i.unit),t=i.better==="higher"?" ↑":i.better==="lower"?" ↓":"";return b("span",{},i.title,t,e!==""&&b("span.unit",{},` ${e}`),i.summary!==""&&b("small",{},i.summary))}function sM({grid:i}){return pe(i?.pitch_mm)?`${ce(1e3*i.pitch_mm,3)} µm voxels`:""}function rM(i,{evaluation:e}){let t=e[i.name],n=Sl(t,i.unit,e.grid?.pitch_mm);return b("span",{},Js(i,t,4),n!==""&&b("span.unit",{},` (${n})`))}function oM(i,e){let t=i.map(({name:n,unit:s})=>Ii([n,s,...e.map(({evaluation:r})=>r[n])]));return[Ii(["metric","unit",...e.map(({name:n})=>n)]),...t].join(`
`)+`
`}function Bg(i,e,t){let n=i.numbers.filter(c=>c.values.some(pe));if(n.length===0)return null;let s=i.marks_best?"the best is bold.":"the best is not marked, because the runs were evaluated by different models: compare only columns with the same one.",r=e.map((c,h)=>b("span",{},xo(c,h),b("small",{},lM(i,h)))),o=c=>t.find(({name:h})=>h===c.key)?.summary??null,a=c=>{let h=aM(c,i),u=(f,g)=>h!==null&&f===h&&i.prints[g];return[b("span",{title:o(c)},Ca({title:c.name,unit:c.unit,better:c.better,summary:""})),...c.values.map((f,g)=>u(f,g)?b("b.best",{},Js(c,f,4)):Js(c,f,4))]},l=()=>[Ii(["number","unit",...e.map(c=>c.name)]),...n.map(c=>Ii([c.key,c.unit,...c.values]))].join(`
`)+`
`;return b("div",{},b("p.quiet",{},`Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; ${s}`),Li("Copy as CSV",l),gt({caption:"Numbers of all runs",heads:["",...r],rows:n.map(a)}))}function aM(i,{marks_best:e,prints:t}){let n=i.values.filter((s,r)=>pe(s)&&t[r]);return!e||i.better==="none"||n.length===0?null:i.better==="higher"?Math.max(...n):Math.min(...n)}function lM({kinds:i,models:e},t){return[i[t],e[t]&&`evaluated by ${e[t]}`].filter(Boolean).join(", ")}function zg({warnings:i}){let e=Ta(i);return e&&b("div.warn",{role:"note"},e)}function Ra(i){return e=>e.data.runs.length>1?i(e):null}function Ld(i){return Ra(e=>e.data.compare?i(e.data.compare,e):null)}var ec=[{id:"compare",title:"",render:Ra(({data:i,index:e,state:t})=>Og(i,e,t))},{id:"cautions",title:"Before you compare",render:Ld(zg)},{id:"side-by-side",title:"Numbers side by side",render:Ld((i,{data:e})=>Bg(i,e.runs,e.metrics))},{id:"job-keys",title:"What differs in the jobs",render:Ld((i,{data:e})=>Ug(i,e.runs))},{id:"doses",title:"Doses",render:Ra(Ng)},{id:"thresholds",title:"Thresholds",render:Ra(({data:i})=>Dg(i))},{id:"histories",title:"Histories",render:Ra(({data:i})=>Ig(i))}];var cM=3,hM=.02;function Hg({run:i}){let e=Rt(nt(i).ceiling?.trade_off);if(e.length===0&&!i.texts?.ceiling)return null;let t=e.length>0&&e.every(a=>pe(a.time_s)),n=t?{label:"print time",unit:"s",from:0}:{label:"print time N·M/t",unit:"mm",from:0},s=a=>t?a.time_s:a.print_time_mm,r=[Vg("IoU",e,n,s,a=>a.iou),Vg("VER",e,n,s,a=>a.ver)].filter(a=>a!==null);return b("div",{},...Vn([i.texts?.ceiling,e.length>0?"The ceilings of the pixels that the run tried, on pixels of twice the width. `tomolith expose RUN --trade-off` lists them and writes the job of one.":null]),b("div.charts",{},...r),uM(e))}function Vg(i,e,t,n,s){let r=e.filter(p=>!p.is_evaluated),o=e.filter(p=>p.is_chosen);if(r.filter(p=>pe(n(p))&&pe(s(p))).length<cM)return null;let a=e.map(s).filter(pe),[l,c]=[Math.min(...a),Math.max(...a)],h=.6*Math.max(c-l,hM),u={label:i,from:Math.max((l+c)/2-h,0),to:Math.min((l+c)/2+h,1)},d=p=>({x:p.map(n),y:p.map(s)}),f=Math.max(...e.map(n).filter(pe)),g=o.some(p=>p.is_evaluated)?"this run, as it was evaluated":"this run",y=en({title:`${i} over the print time`,x:{...t,to:1.05*f},y:u,series:[{name:"tried",color:"--accent",...d(r)},{name:g,color:"--threshold",style:"dots",...d(o)}]});return y&&xt(i,y)}function uM(i){if(i.length===0)return null;let e=i.some(s=>pe(s.time_s)),t=s=>[[ce(s.brightest,3),s.is_chosen&&" (taken)"].filter(Boolean).join(""),an(s.print_time_mm,"",3),...e?[an(s.time_s,"",3)]:[],an(s.iou,"",4),an(s.ver,"",3),an(pe(s.surface_mean_mm)?1e3*s.surface_mean_mm:null,"",3)],n=["Brightest pixel","N·M/t, mm",...e?["time, s"]:[],"IoU","VER","surface off on average, µm"];return gt({caption:"Quality against time",heads:n,rows:i.map(t)})}var tc=32;function Gg(i){let[e,t,n]=["response","target","labels"].map(s=>as(i.run,s,""));return!e||!t?null:Ci(i,async({store:s})=>{let r=await Promise.all([e,t,...n?[n]:[]].map(c=>s.volume(c))),[o,a,l]=r;return fM(dM(o,a,l??null))})}function dM(i,e,t){let[n,s,r]=[0,1,2].map(()=>new Float64Array(tc)),o=Math.min(i.codes.length,e.codes.length);for(let a=0;a<o;a++){if(t&&t.codes[a]===bs.outside)continue;let[l,c]=[i.values[i.codes[a]],e.values[e.codes[a]]];if(Number.isNaN(l)||Number.isNaN(c))continue;let h=Math.min(Math.max(Math.floor(c*tc),0),tc-1);n[h]++,s[h]+=l,r[h]+=l*l}return[...n.keys()].filter(a=>n[a]>0).map(a=>{let l=s[a]/n[a];return{gray:(a+.5)/tc,mean:l,deviation:Math.sqrt(Math.max(r[a]/n[a]-l*l,0))}})}function fM(i){let e=i.map(({gray:s})=>s),t=(s,r)=>({name:"± one standard deviation",color:"--void",x:e,y:i.map(({mean:o,deviation:a})=>o+s*a),quiet:r});return en({title:"Response against gray value",x:{label:"gray value of the target",from:0,to:1},y:{label:"response",from:0},series:[{name:"mean",color:"--accent",x:e,y:i.map(({mean:s})=>s)},t(1,!1),t(-1,!0),{name:"asked for",color:"--ink",style:"dashed",x:[0,1],y:[0,1]}]})??b("p.note",{},"No voxel counts.")}var pM=80;function $g(i){let e=nt(i.run).evaluation,t=e?.errors,[n,s]=t?.range??[];if(!e||!t||!pe(n)||!pe(s))return null;let r=Math.max(...["max_error_part","max_error_void"].map(m=>e[m]).filter(pe),0),[o,a]=t.band??[],l=t.part?.length??0;if(l===0)return null;let c=(s-n)/l,h=Math.min(Math.max(r,2*(a??0),8*c),s),u=Wg(t,"part",c,h),d=Wg(t,"void",c,h),f=pe(o)&&pe(a)?[{name:"the objective's band",color:"--quiet",from:o,to:a}]:[],g=en({title:"Error of bright and dark voxels",x:{label:"response − gray value",from:-h,to:h},y:{label:"voxels",log:!0},series:[{name:"dark (below ½)",color:"--void",style:"steps",...d},{name:"bright",color:"--part",style:"steps",...u}],marks:f});if(!g)return null;let y=pe(t.band_edge_peak)?` Bins at its edges hold ${ce(t.band_edge_peak,3)} times as many voxels as those next to them.`:"",p=Gg(i);return b("div.charts",{},xt("Voxels per error",b("p.note",{},`The band is what the objective asks for.${y}`),g),p&&xt("Response against gray value",b("p.note",{},"Of the voxels of each gray value."),p))}function Wg(i,e,t,n){let s=i[e]??[],r=i.range?.[0]??0,o=Math.max(1,Math.round(2*n/t/pM)),a=[],l=[];for(let c=0;c<s.length;c+=o){let h=r+c*t;h+o*t<-n||h>n||(a.push(h),l.push(s.slice(c,c+o).reduce((u,d)=>u+(d??0),0)))}return{x:a,y:l}}function Xg({run:i}){let e=i.job;return e?b("div",{},b("details.fold",{},b("summary",{},"The job, with every default"),Li("Copy the job",()=>e),b("pre.job",{tabindex:"0"},e))):null}function Yg({run:i}){let e=nt(i),t=Rt(e.lights);if(t.length===0)return null;let n=t.map((o,a)=>o.name||(t.length>1?`light ${a+1}`:"value")),s=gM.map(([o,a])=>[o,...t.map(a)]).filter(([,...o])=>o.some(a=>a!==Dn&&a!=="")),r=t.length>1&&pe(e.time_to_print_s)?`All lights together take ${Ai(e.time_to_print_s)}.`:null;return b("div",{},...Vn([r,mM(t)]),gt({caption:"Lights",heads:["",...n],rows:s}))}function mM(i){return i.some(e=>e.irradiance)?"The job's schedule says how long and how bright the light is.":i.some(e=>pe(e.budget?.time_s))?null:"Times need `resin.critical_dose_mj_per_mm3` and `printer.peak_irradiance_mw_per_cm2`, and frames that follow each other at one rate: frames of a list of angles (`light.angles.list_deg`) have no times."}var _o=i=>i.budget??{},gM=[["Wavelength",i=>an(i.wavelength_nm,"nm",4)],["Frames",i=>ce(i.frames,6)],["Pixels of a frame",i=>qg([i.columns,i.rows])],["Pixel pitch",xM],["Depth",i=>an(i.bits,"bit")],["White, over the whole exposure",i=>an(i.full_scale,"",4)],["Device",i=>i.canvas?`${qg(i.canvas)} pixels`:"the patterns as they are"],["White, while it shines",_M],["Time to print, or length of the schedule",i=>Ai(_o(i).time_s)],["Turns of the vial",i=>ce(_o(i).turns,3)],["White, of a frame over the whole print",i=>an(_o(i).white_mj_per_mm2,"mJ/mm²")],["Energy at the vial per turn",i=>an(_o(i).energy_per_turn_mj,"mJ")],["Energy at the vial in all",i=>an(_o(i).energy_mj,"mJ")],["Share of the device's light that is used",i=>Zg(_o(i).light_used)]];function qg(i){return i.map(e=>ce(e,6)).join(" × ")}function xM({pitch_mm:i}){let e=(Array.isArray(i)?i:[i]).filter(pe);return e.length>0?`${e.map(t=>ce(1e3*t,3)).join(" × ")} µm`:Dn}function _M({irradiance:i}){let e=i?.white_mw_per_cm2,t=i?.peak_mw_per_cm2,n=pe(e)&&pe(t)&&t>0?`, ${Zg(e/t)} of what the printer gives`:"";return an(e,"mW/cm²")+n}function Zg(i){return pe(i)?`${ce(100*i,3)} %`:Dn}function Kg(i,e,t){let n=new Map(i.map(({id:r,title:o})=>[r,Id(r,o,e)])),s=r=>{for(let[l,c]of n)l===r?c.setAttribute("aria-current","location"):c.removeAttribute("aria-current");let o=n.get(r),a=o?.parentElement?.parentElement;o&&a&&(a.scrollLeft=o.offsetLeft-a.clientWidth/2+o.offsetWidth/2)};return t.addEventListener("abort",e.on(["section"],()=>Qs(e.get("section")))),yM([...n.keys()],s,t),b("nav.sections",{"aria-label":"Sections"},b("ol",{},...[...n.values()].map(r=>b("li",{},r))))}function Id(i,e,t){return b("a",{href:`#section=${i}`,click:n=>{n.ctrlKey||n.metaKey||n.shiftKey||(n.preventDefault(),t.get("section")===i?Qs(i):t.set({section:i}))}},e)}function Qs(i){let e=i===""?null:document.getElementById(i);if(!e)return;let t=matchMedia("(prefers-reduced-motion: reduce)").matches;e.scrollIntoView({behavior:t?"auto":"smooth"}),e.tabIndex=-1,e.focus({preventScroll:!0})}function yM(i,e,t){let n="",s=!1,r=()=>{s=!1;let a=window.innerHeight/4,c=i.filter(h=>(document.getElementById(h)?.getBoundingClientRect().top??1/0)<=a).at(-1)??i[0]??"";c!==n&&(n=c,e(c))},o=()=>{s||(s=!0,requestAnimationFrame(r))};window.addEventListener("scroll",o,{signal:t,passive:!0}),o()}function Jg({run:i,state:e}){let t=nt(i);return t.evaluation?b("div.two",{},vM(t,i.texts,e),SM(t,i.texts?.limits??[])):null}function vM(i,e,t){let n=i.one_exposure?MM(i.one_exposure,Rt(i.species)):bM(i),s=n.length>0?gt({caption:"Best exposure",heads:["","shortest","best","longest"],rows:n,strong:2}):null,r=i.one_exposure?[e?.one_exposure,"The table compares exposures with it."]:e?.exposure??[],o=b("p.note",{},"This is about the dose. When to stop in the job's schedule stands under ",Id("time","The print in time",t),".");return xt("Best exposure",...Vn(r),s,Rt(i.time).length>0&&o)}function bM({exposure:i}){if(!i)return[];let e=[["Exposure",...Cr(i.percent,Nd)]];i.time_s&&e.push(["Time to print",...Cr(i.time_s,Qg)]),i.dose&&e.push(["Dose that gels",...Cr(Dd(i.dose),jg)]);let t=i.threshold?.best!==i.dose?.best||i.threshold?.low!==i.dose?.low;return i.threshold&&t&&e.push(["Response that gels",...Cr(Dd(i.threshold),jg)]),e}function MM(i,e){let t=[["All together",...Cr(i.percent,Nd)]];i.time_s&&t.push(["Time to print",...Cr(i.time_s,Qg)]);for(let{name:n=Dn,exposure:s}of e){if(!s?.dose)continue;let r=c=>pe(c)&&pe(i.gel_dose)&&c>0?100*i.gel_dose/c:null,{low:o,best:a,high:l}=Dd(s.dose);t.push([`${n} alone`,...Cr({low:r(o),best:r(a),high:r(l)},Nd)])}return t}function Dd({low:i,best:e,high:t}){return{low:t??null,best:e??null,high:i??null}}var jg=i=>aa(i,3),Nd=i=>aa(i,3).map(e=>`${e} %`),Qg=i=>i.map(Ai);function Cr(i,e){let t=[i?.low,i?.best,i?.high],n=e(t.filter(pe));return t.map(s=>pe(s)?n.shift()??"":"no limit")}function SM(i,e){let t=Rt(i.species),s=(t.length>1?t.map(r=>({name:r.name??"",causes:Rt(r.limits)})):[{name:"",causes:Rt(i.limits)}]).flatMap(({name:r,causes:o},a)=>{let l=e.find(c=>c.name===r)??e[a];return o.length===0&&!l?.sentence?[]:[b("div",{},r!==""&&b("h4",{},r),...Vn([l?.sentence]),wM(o))]});return s.length>0?xt("What limits the print",...s):null}function wM(i){if(i.length===0)return null;let e=Math.max(...i.map(t=>e0(t).loss??0));return b("ol.causes",{},...i.map(t=>EM(t,e)))}function e0(i){return pe(i.loss_in_rms_error)?{loss:i.loss_in_rms_error,measure:"rms error"}:{loss:pe(i.loss_in_iou)?i.loss_in_iou:null,measure:"IoU"}}function EM(i,e){let{loss:t,measure:n}=e0(i),s=t!==null&&t>=t0?t/e:0,{key:r,advice:o=""}=i;return b("li",{"data-cause":i.cause},b("div.cause-head",{},b("b",{},AM[i.cause??""]??i.cause??""),b("span.loss",{},TM(t,n))),b("div.share",{"aria-hidden":"true"},b("i",{style:`width: ${(100*s).toFixed(1)}%`})),b("p",{},Ys(o),r&&!o.includes(r)?b("span.key",{}," ",b("code",{},r)):null))}var t0=5e-4;function TM(i,e){if(i===null)return"";if(Math.abs(i)<t0)return"costs nothing";let t=`${ce(Math.abs(i),2)} ${e}`;return e==="IoU"?i>0?`−${t}`:`+${t}`:i>0?`+${t}`:`−${t}`}var AM={grid:"Voxels of the optimization",levels:"Gray levels and pixels",turning:"Turning during a frame",optics:"Pixels and frames",iterations:"Iterations",ends:"Flat faces of the part",exposure:"Exposure",time:"The brightest pixel"};function n0({run:i}){let e=Rt(nt(i).movies);if(e.length===0)return null;let t=e.map(n=>[b("code",{},n.file??""),ce(n.frames,6),ce(n.frame_rate,4),`${ce(n.width,6)} × ${ce(n.height,6)}`,ce(n.largest_error_of_255,3),ce(n.rms_error_of_255,2)]);return b("div",{},b("p.quiet",{},"Written, then decoded again and compared with the frames; errors are gray levels of 255. H.264 is lossy: the PNG frames are exact."),gt({caption:"Movies",heads:["file","frames","rate, 1/s","pixels","largest error","rms error"],rows:t}))}function i0({run:i}){let e=nt(i),t=Ta([...Rt(e.warnings),...Rt(e.evaluation?.notes)]);return t&&b("div.warn",{role:"note"},t)}function s0({data:i,run:e}){let t=nt(e),n=Ta(Rt(t.notes)),r=Object.entries(t.run?.models??{}).map(([o,a])=>b("div",{},b("dt",{},`Doses of the ${o}`),b("dd",{},String(a))));return b("div",{},b("p.quiet",{},`${t.run?.program??i.program}. Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.`),n&&xt("Choices",n),r.length>0&&xt("Models",b("dl.models",{},...r)))}function r0({run:i}){let e=Rt(nt(i).optimization?.objectives);if(e.length<2)return null;let t=e.map(n=>[b("code",{},n.key??""),ce(n.weight,4),ce(n.loss,4),ce(n.voxels,6),ce(n.rms_error,4),ce(n.max_error,4)]);return b("div",{},b("p",{},"What each of them comes to on the job's own voxels, before the patterns are written. The sum takes a loss times its factor."),gt({caption:"Objectives",heads:["objective","factor","loss","voxels","rms error","largest error"],rows:t}))}function o0({run:i}){let e=Rt(nt(i).properties);return e.length===0?null:b("div",{},b("p.quiet",{},"Where something is solid. Half of it lies below the median."),gt({caption:"Predicted properties",heads:["property","lowest","median","highest","unit"],rows:e.map(CM),text:[4]}))}function CM({name:i,unit:e,min:t,median:n,max:s}){let r=[t,n,s],o=aa(r.filter(pe),3);return[i??"",...r.map(a=>pe(a)?o.shift()??"":"–"),e??""]}function a0({run:i}){let e=Object.entries(nt(i).published??{}),t=e.flatMap(([r,o])=>Qn(o)&&typeof o.source=="string"?[RM(r,o)]:[]),n=e.filter(([r,o])=>r!=="slices"&&!(Qn(o)&&typeof o.source=="string")),s=LM(nt(i).published?.slices);return t.length===0&&n.length===0?null:b("div",{},t.length>0&&PM(t),s,...n.map(([r,o])=>xt(Ud(r),Od(o))))}function RM(i,e){let t=n=>typeof e[n]=="string"?e[n]:"";return{name:i,value:e.value,unit:t("unit"),note:t("note"),source:t("source")}}function PM(i){let e=b("div"),t=b("span.quiet",{"aria-live":"polite"}),n=b("input",{type:"search",placeholder:"jaccard, Dr.TVAM, eq. 12, …","aria-label":"Filter the published numbers"}),s=()=>{let r=n.value.toLowerCase().split(/\s+/).filter(Boolean),o=u=>`${u.name} ${u.note} ${u.source} ${u.unit}`.toLowerCase(),a=i.filter(u=>r.every(d=>o(u).includes(d)));t.textContent=a.length===i.length?`${i.length} numbers`:`${a.length} of ${i.length} numbers`;let l=u=>[b("code",{},u.name),ce(u.value,4),u.unit,u.note,u.source],c=["name","value","unit","definition","source"],h=b("p.note",{},"No number has all of these words in its name, definition or source.");e.replaceChildren(a.length===0?h:gt({caption:"Published numbers",heads:c,rows:a.map(l),text:[2,3,4]}))};return n.addEventListener("input",s),s(),b("details.fold",{},b("summary",{},`${i.length} numbers as other authors and programs define them`),b("label.filter",{},"Filter ",n," ",t),e)}function LM(i){let e=Array.isArray(i)?i.filter(Qn):[],t=l=>e.map(c=>c[l]),n=t("z_mm"),s=(l,c,h)=>({name:l,color:c,x:n,y:t(h)}),r={label:"z",unit:"mm"},o=en({title:"Dose of each slice over z",x:r,y:{label:"response"},series:[s("process window","--run-1","pw"),s("range in the part","--run-2","ipdr")]}),a=en({title:"Voxel error rate of each slice over z",x:r,y:{label:"voxel error rate",from:0},series:[s("voxel error rate","--run-1","ver")]});return!o&&!a?null:xt("Slice by slice",b("div.charts",{},o&&b("div",{},o),a&&b("div",{},a)))}function Od(i){if(pe(i))return ce(i,4);if(i==null)return Dn;if(Array.isArray(i)){if(i.every(n=>!Qn(n)))return i.map(n=>pe(n)?ce(n,4):String(n??Dn)).join(" ");let e=[...new Set(i.filter(Qn).flatMap(n=>Object.keys(n)))],t=n=>e.map(s=>Qn(n)?Od(n[s]):String(n));return gt({heads:e.map(Ud),rows:i.map(t)})}return Qn(i)?gt({heads:["","value"],rows:Object.entries(i).map(([e,t])=>[Ud(e),Od(t)])}):String(i)}var IM={keep_dark:"Bodies that are to stay dark",insert:"Surface of the inserts",insert_mm2:"In all, mm²",target_mm2:"Touched by the target, mm²",print_mm2:"Touched by the print, mm²",share:"Share that the print touches",of_target:"Share of what the target touches that the print touches too",part_mean:"Mean of the part",paths:"Scattering by Monte Carlo paths",orders:"Scattering, order by order",unit_systems:"In the units of others"};function Ud(i){let e=IM[i];if(e!==void 0)return e;let t=/_(mm3|mm2|mm)$/.exec(i),n=(t?i.slice(0,t.index):i).replaceAll("_"," "),s=n.charAt(0).toUpperCase()+n.slice(1);return t?`${s}, ${t[1]?.replace("3","³").replace("2","²")}`:s}function l0({run:i}){let e=nt(i).scenarios;if(!e)return null;let t=Rt(e.rows).map(r=>[r.name??"",ce(r.iou_at_threshold,4),ce(r.iou,4),ce(r.gamma,4),ce(r.part_low,4),ce(r.void_high,4)]),n=ce(e.threshold,4),s=e.of==="worst"?"the worst of them":e.of==="mean"?"their mean":e.of;return b("div",{},...Vn([`What the same patterns print where something is otherwise. Nobody knows which scenario a print is, so all of them gel at the threshold of the job, ${n}.`,i.texts?.scenarios]),gt({caption:"Scenarios",heads:["scenario","IoU there","IoU at its own threshold","Γ, %","least of the part","largest of the void"],rows:t,strong:1}),b("p.note",{},`Window over all of them: ${ce(e.window,4)}, trimmed.${s?` The optimization minimized ${s}.`:""}`))}function c0({data:i,run:e}){let{species:t,one_exposure:n}=nt(e),s=Rt(t);if(s.length<2)return null;let r=s[0]?.evaluation,o=r?Pd(i,r):[];return b("div",{},b("p",{},"The numbers at the head of the page are those of ",b("b",{},s[0]?.name??""),"."),b("ul.drives",{},...s.map(a=>b("li",{},b("b",{},a.name??""),` is ${DM(a)}.`))),xt("Each alone",gt({caption:"Each species alone",heads:["",...s.map(a=>a.name??"")],rows:o.map(a=>NM(a,s))})),n?OM(s,n):null,UM(s,n))}function DM({driven_by:i}){let e=Object.entries(i??{}).filter(([,o])=>pe(o)&&o!==0),t=o=>e.filter(([,a])=>Math.sign(a??0)===o).map(([a,l])=>`${ce(Math.abs(l??0),3)} × ${a}`),[n,s]=[t(1),t(-1)];return[n.length>0&&`driven by ${n.join(" and ")}`,s.length>0&&`inhibited by ${s.join(" and ")}`].filter(Boolean).join(", ")||"driven by no light"}function NM(i,e){let{unit:t}=ss(i.unit);return[b("span",{title:i.summary},i.title,t!==""&&b("span.unit",{},` ${t}`)),...e.map(({evaluation:s})=>Js(i,s?.[i.name],4))]}function OM(i,e){let t=r=>r.name&&r.name===e.limited_by?`${r.name} (limits it)`:r.name??"",n=i.map((r,o)=>[t(r),ce(r.evaluation?.iou,4),ce(r.evaluation?.gel_threshold,3),ce(e.iou?.[o],4)]),s=`A print has one exposure. Where all networks gel at the same dose, the species print together best at a dose of ${ce(e.gel_dose,3)}: the last column. Each reaches the IoU of its own where its network gels at its own dose.`;return xt("Together at one exposure",b("p",{},s),gt({caption:"Species at one exposure",heads:["species","IoU alone","at a threshold of","IoU together"],rows:n,strong:3}))}function UM(i,e){let t=i.map(({name:o,evaluation:a},l)=>{let c=Rt(a?.iou_curve);return{name:o??"",color:`--run-${l%6+1}`,x:c.map(h=>h?.[0]),y:c.map(h=>h?.[1])}}),n=i.every(({exposure:o})=>o?.dose?.best===o?.threshold?.best),s=e&&n&&pe(e.gel_dose)?[{name:"one exposure",color:"--threshold",from:e.gel_dose}]:[],r=en({title:"IoU of each species over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:t,marks:s});return r&&xt("How much the threshold matters to each",r)}function h0({run:i}){let e=nt(i),t=Rt(e.time);if(t.length===0)return null;let n=s=>{let r=(i.texts?.time??[]).find(a=>a.name===s.name)?.sentence,o=[...Vn([r,FM(s,e.evaluation)]),kM(s),BM(s)];return t.length>1?xt(s.name??"",...o):b("div",{},...o)};return b("div",{},...Vn([i.texts?.one_moment],"lead-in"),...t.map(n))}function FM(i,e){let t=o=>{let a=o?.grid?.pitch_mm;return pe(a)?1e3*a:null},[n,s]=[t(i.evaluation),t(e)];if(n===null||s===null)return null;let r=ce(n,3);return Math.abs(n-s)<1e-6*n?`Printed on voxels of ${r} µm, as the dose above.`:`Printed on the job's own voxels of ${r} µm. The numbers above are of voxels of ${ce(s,3)} µm, so the two cannot be compared.`}function kM(i){let e=i.curves??{},t=e.seconds??[],n=t.findLast(pe),s={label:"time",unit:"s",from:0,...pe(n)?{to:n}:{}},r=(y,p,m,v={})=>({name:y,color:p,x:t,y:e[m]??[],...v}),o=pe(i.best_s)?[{name:"best",color:"--threshold",from:i.best_s}]:[],[a,l]=i.window_s??[],c=pe(a)&&pe(l)?[{name:"within 0.01 of the best",color:"--threshold",from:a,to:l}]:[],h=en({title:"IoU and contrast over time",x:s,y:{label:"share",from:0,to:1},series:[r("IoU","--ink","jaccard"),r("part that is solid","--part","solid_part"),r("void that is solid","--void","solid_void"),r("contrast of the dose","--quiet","contrast",{style:"dashed"})],marks:[...c,...o]}),u=pe(i.ideal_exposure_s)?[{name:"ideal exposure",color:"--threshold",from:i.ideal_exposure_s}]:[],d=i.requirement_mj,f=en({title:"Absorbed drive over time",x:s,y:{label:"absorbed drive",unit:"mJ",from:0},series:[r("in all voxels","--quiet","imbued_mj"),r("in solid voxels","--accent","contribution_mj"),{name:"needed",color:"--ink",style:"dashed",x:[0,n],y:[d,d]}],marks:u}),g=en({title:"Light sent over time",x:s,y:{label:"sent to the vial",unit:"mJ",from:0},series:[r("sent","--accent","sent_mj")]});return b("div.charts",{},h&&xt("What is solid",h),f&&xt("What is absorbed",f),g&&xt("Light that was sent",g))}function BM(i){let e=i.evaluation,t=s=>an(s,"s"),n=[["First voxel solid",t(i.induction_end_s)],["Best moment",t(i.best_s)],["IoU then",ce(i.best_jaccard,4)],["Sent to the vial by then",an(i.best_mj,"mJ")],["Within 0.01 of the best",(i.window_s??[]).map(t).join(" to ")||"–"],["Ideal exposure",t(i.ideal_exposure_s)],["Dose that the part needs",an(i.requirement_mj,"mJ")],...pe(i.largest_share_of_requirement)?[["Largest share of it that was reached",an(100*i.largest_share_of_requirement,"%")]]:[],...e?[["Voxel error rate of what is solid then",ce(e.ver,3)]]:[]];return gt({caption:`Moments of the print in time${i.name?`: ${i.name}`:""}`,heads:["","value"],rows:n})}function u0({run:i}){let e=Object.entries(nt(i).run?.timings_s??{}).filter(h=>pe(h[1])),t=Math.max(0,...e.map(([,h])=>h));if(t===0)return null;let n=e.filter(([h])=>!h.includes(": ")),s=h=>e.filter(([u])=>u.startsWith(`${h}: `)),r=e.filter(([h])=>h.includes(": ")&&!n.some(([u])=>h.startsWith(`${u}: `))),o=(h,u)=>u[1]-h[1],a=n.reduce((h,[,u])=>h+u,0),l=(h,u,d)=>b(d?"div.row.sub":"div.row",{},b("span",{},h),b("div.share",{"aria-hidden":"true"},b("i",{style:`width: ${(100*u/t).toFixed(1)}%`})),b("span.value",{},`${ce(u,3)} s`)),c=[...n,...r].sort(o).flatMap(([h,u])=>[l(h,u,!1),...s(h).sort(o).map(([d,f])=>l(d.slice(h.length+2),f,!0))]);return b("div",{},b("p.quiet",{},`${ce(a,3)} s until this page was written.`),b("div.timings",{},...c))}var d0=[...ec,{id:"head",title:"",render:Fg},{id:"warnings",title:"Please note",render:i0},{id:"limits",title:"Exposure and limits",render:Jg},{id:"errors",title:"How far the response is off",render:$g},{id:"species",title:"Several species",render:c0},{id:"time",title:"The print in time",render:h0},{id:"properties",title:"Predicted properties",render:o0},{id:"ceiling",title:"Quality against time",render:Hg},{id:"scenarios",title:"Scenarios",render:l0},{id:"objectives",title:"Objectives",render:r0},{id:"history",title:"History of the optimization",render:Cg},{id:"lights",title:"Light and time",render:Yg},{id:"numbers",title:"All numbers",render:kg},{id:"published",title:"Published numbers",render:a0},{id:"movies",title:"Movies",render:n0},{id:"timings",title:"Where the time went",render:u0},{id:"notes",title:"How it was computed",render:s0},{id:"job",title:"The job",render:Xg}];var zM=100,VM=.2,nc=class{constructor(e,t){this.sweep=e;this.rows=e.rows,this.axes=e.axes.map((s,r)=>HM(s,r,e.rows)),this.metrics=e.metrics.map((s,r)=>GM(s,e.axes.length+r,t));let n=this.varying.reduce((s,{levels:r})=>s*r.length,1);this.isCrossed=this.varying.length>1&&e.rows.length>=VM*n}sweep;axes;metrics;rows;isCrossed;get columns(){return[...this.axes,...this.metrics]}get varying(){return this.axes.filter(({levels:e})=>e.length>1)}value(e,t){return this.rows[e].values[t.at]??null}number(e,t){let n=this.value(e,t);return pe(n)?n:null}text(e,t,n=6){return Fn(this.value(e,t),n)}point(e){return this.axes.map(t=>`${t.name} ${this.text(e,t)}`).join(", ")}state(e){let{state:t,feasible:n}=this.rows[e];return t!=="done"?t:e===this.sweep.best?"best":n===!1?"infeasible":"done"}scale(e){let t=this.range(e);return t&&{...t,map:rs}}range(e){let[t,n]=[1/0,-1/0];return this.rows.forEach((s,r)=>{let o=this.number(r,e);o!==null&&(t=Math.min(t,o),n=Math.max(n,o))}),t>n?null:{low:t,high:n,logarithmic:t>0&&n>=zM*t}}};function Di({title:i,unit:e}){return e===""?i:`${i}, ${e}`}function Fn(i,e=6){return i==null?Dn:typeof i=="number"?ce(i,e):Array.isArray(i)?i.map(t=>Fn(t,e)).join(" "):Qn(i)?Object.entries(i).map(([t,n])=>Qn(n)?`${t} ${Fn(n,e)}`.trim():`${t}=${Fn(n,e)}`).join(" "):String(i)}function ic(i,e){return i.high>i.low?yr({...i,map:rs},e):.5}function HM(i,e,t){let n=t.map(({values:l})=>JSON.stringify(l[e]??null)),s=new Map(n.map((l,c)=>[l,t[c].values[e]??null])),r=s.size>0&&[...s.values()].every(pe),o=[...s];r&&o.sort(([,l],[,c])=>Number(l)-Number(c));let a=new Map(o.map(([l],c)=>[l,c]));return{name:i,at:e,title:i,unit:"",summary:"",better:"none",isNumeric:r,levels:o.map(([,l])=>l),levelOf:n.map(l=>a.get(l)??0)}}function GM(i,e,t){let[n,s,...r]=i.split("."),o=r.length===0&&(n==="evaluation"||n==="optimization")?t.find(l=>l.name===s):void 0;if(!o)return{name:i,at:e,title:i,unit:"",summary:"",better:"none"};let a=n==="evaluation"?o.title:`${o.title} (${n})`;return{name:i,at:e,title:a,unit:ss(o.unit).factor===1?ss(o.unit).unit:o.unit,summary:o.summary,better:o.better}}function f0(i,e,t){let n=e.map(o=>b("span.marked-run",{},b("button",{type:"button",click:()=>t.open(o)},`Run ${o+1}`),b("button",{type:"button","aria-label":`Leave run ${o+1} out`,title:"Leave it out",click:()=>t.toggle(o)},"×"),b("small",{},i.state(o)))),s=o=>{let a=$M(e.map(c=>i.number(c,o)),o.better),l=c=>a!==null&&i.value(c,o)===a?b("b.best",{},i.text(c,o)):i.text(c,o);return[Ca(o),...e.map(l)]},r=()=>[Ii(["",...e.map(o=>`run ${o+1}`)]),...i.columns.map(o=>Ii([o.name,...e.map(a=>WM(i.value(a,o)))]))].join(`
`)+`
`;return b("div",{},b("p.quiet",{},"↑ larger is better, ↓ smaller is better; the best of these runs is bold."),Li("Copy as CSV",r),gt({caption:"Marked runs side by side",heads:["",...n],rows:i.columns.map(s)}))}function WM(i){return pe(i)?i:i===null?"":Fn(i)}function $M(i,e){let t=i.filter(pe),[n,s]=[Math.min(...t),Math.max(...t)];return e==="none"||!(s>n)?null:e==="higher"?s:n}var Gi=6,p0=new WeakMap,Rr=class{constructor(e,t,n,s,r){this.grid=e;this.cells=t;this.nx=n;this.ny=s;this.make=r;this.byRow=new Map(t.map(o=>[o.row,o])),this.byPlace=new Int32Array(n*s).fill(-1);for(let{row:o,column:a,level:l}of t)this.byPlace[l*n+a]=o;this.canvas=b("canvas.sweep-cells",{width:n*Gi,height:s*Gi,style:`grid-area: 1 / 2 / ${s+1} / ${n+2}`,"aria-hidden":"true"}),this.draw(),this.canvas.addEventListener("pointermove",o=>this.point(o)),e.addEventListener("pointerleave",()=>this.tidy(-1)),p0.set(e,this)}grid;cells;nx;ny;make;canvas;byPlace;byRow;static around(e){let t=e.closest(".part")?.querySelector(".sweep-map");return(t&&p0.get(t))??null}mark(e){let t=this.grid.querySelector(`.mark[data-row="${e}"]`),n=this.byRow.get(e);if(t||!n)return t;let s=this.make(n);return this.grid.append(s),s}neighbor(e,t){let n=this.byRow.get(e),s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t];if(!n||!s)return null;for(let[r,o]=[n.column+s[0],n.level+s[1]];r>=0&&o>=0&&r<this.nx&&o<this.ny;r+=s[0],o+=s[1]){let a=this.byPlace[o*this.nx+r];if(a>=0)return this.mark(a)}return null}point(e){let t=this.canvas.getBoundingClientRect(),n=(a,l)=>Math.min(Math.max(Math.floor(a*l),0),l-1),s=n((e.clientX-t.left)/t.width,this.nx),r=this.ny-1-n((e.clientY-t.top)/t.height,this.ny),o=this.byPlace[r*this.nx+s];this.tidy(o),o>=0&&this.mark(o)}tidy(e){for(let t of this.grid.querySelectorAll(".mark:not(.best, .opened, .marked, :focus)"))t.dataset.row!==String(e)&&t.remove()}draw(){let e=this.canvas.getContext("2d");if(!e)return;let{width:t,height:n}=this.canvas,s=new Uint32Array(t*n),[r,o]=[Mn("--excess"),Mn("--solid")],a=4278190080;for(let{column:l,level:c,color:h,state:u}of this.cells){let d=(this.ny-1-c)*Gi*t+l*Gi;for(let f=0;f<Gi;f++)for(let g=0;g<Gi;g++){let y=g===0||f===0||g===Gi-1||f===Gi-1,p=h??0;u==="failed"?p=g===f||g+f===Gi-1?r:0:u==="missing"?p=y&&(g+f)%2===0?o:0:u==="infeasible"&&(g+f)%Gi===Gi-1&&(p=a),s[d+f*t+g]=p}}e.putImageData(new ImageData(new Uint8ClampedArray(s.buffer),t,n),0,0)}};function Pa(i,e,t,n,s,...r){let o=`Run ${e+1}: ${i.point(e)}; ${t.title} ${i.text(e,t)}; ${i.state(e)}`;return b("button",{type:"button",class:`mark ${i.state(e)}`,tabindex:-1,"aria-label":o,"data-row":e,"data-x":n.x,"data-y":n.y,style:s},...r)}function m0(i,e,t){let n={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t];if(!n)return null;let s=({dataset:c})=>[Number(c.x),Number(c.y)],[r,o]=s(e),a=null,l=1/0;for(let c of i){let[h,u]=[s(c)[0]-r,s(c)[1]-o],d=h*n[0]+u*n[1];if(d<=0)continue;let f=Math.abs(h*n[1])+Math.abs(u*n[0]),g=d+1e3*f;g<l&&([a,l]=[c,g])}return a}var XM=7,qM=14,g0=76,Fd={least:6,most:34,all:720},YM=2e3,ZM=40;function x0(i,e,t,n,s){let[r,o]=[t.levels.length,n.levels.length],a=i.scale(e),l=r<=ZM,c=s.map(p=>{let m=i.number(p,e);return{row:p,column:t.levelOf[p],level:n.levelOf[p],color:m===null||!a?null:a.map(ic(a,m)),state:i.state(p)}}),h=({row:p,column:m,level:v,color:T})=>{let S=`grid-area: ${o-v} / ${m+2}`,R=i.rows[p].state==="done";return T===null?Pa(i,p,e,{x:m,y:v},S,R&&l&&b("span",{},Dn)):Pa(i,p,e,{x:m,y:v},`${S}; background-color: ${wl(T)}; color: ${KM(T)?"#000":"#fff"}`,l&&b("span",{},ce(i.number(p,e),3)))},u=t.levels.map((p,m)=>b("span.x",{style:`grid-area: ${o+1} / ${m+2}`},b("span",{},Fn(p,4)))),d=n.levels.map((p,m)=>b("span.y",{style:`grid-area: ${o-m} / 1`},Fn(p,4))),f=Math.min(Math.max(Fd.all/o,Fd.least),Fd.most),g=b("div.sweep-map",{style:`--columns: ${r}; --cell: ${f}px; gap: ${f>16?2:1}px; max-width: ${r*g0+90}px`},...d,...u);if(c.length>YM){g.style.gridTemplateRows=`repeat(${o}, ${f}px)`,g.append(new Rr(g,c,r,o,h).canvas);let p=c.find(({state:m})=>m==="best")??c[0];g.append(h(p))}else g.append(...c.map(h));jM(g,u);let y=Math.ceil(qM/f);return d.forEach((p,m)=>p.style.visibility=m%y===0?"":"hidden"),b("div",{},b("p.axis-name",{},`↑ ${Di(n)}`),g,b("p.axis-name.right",{style:`max-width: ${r*g0+90}px`},`${Di(t)} →`),a&&si({scale:a,label:Di(e),mark:null}))}function KM(i){let[e,t,n]=to(i);return .3*e+.59*t+.11*n>.5}function jM(i,e){let t=Math.max(...e.map(({textContent:n})=>n?.length??0));new ResizeObserver(()=>{let n=Math.ceil((t*XM+6)/Math.max(e[0]?.clientWidth??0,1));e.forEach((s,r)=>s.style.visibility=r%n===0?"":"hidden")}).observe(i)}function y0(i,e,t,n,s){let r=t.isNumeric?_0(i,t):JM(t),o=_0(i,e),a=f=>r?r.at(t.isNumeric?i.number(f,t)??0:t.levelOf[f]):0,c=[...n].sort((f,g)=>a(f)-a(g)).map(f=>({row:f,x:a(f),value:i.number(f,e)})),h=c.map(({row:f,x:g,value:y},p)=>Pa(i,f,e,{x:p,y:0},`left: ${sc(g)}; bottom: ${sc(y===null?0:o.at(y))}`,b("i",{}))),u=c.flatMap(({x:f,value:g})=>g===null?[]:[`${(100*f).toFixed(3)},${(100-100*o.at(g)).toFixed(3)}`]),d=s&&wt("svg",{viewBox:"0 0 100 100",preserveAspectRatio:"none","aria-hidden":"true"},wt("polyline",{points:u.join(" ")}));return b("div",{},b("div.sweep-plot",{},...(o?.ticks??[]).map(({at:f,text:g})=>b("span.y",{style:`bottom: ${sc(f)}`},g)),...(r?.ticks??[]).map(({at:f,text:g})=>b("span.x",{style:`left: ${sc(f)}`},g)),d,...h),b("p.axis-name.right",{},`${Di(t)} →`))}function sc(i){return`${(100*i).toFixed(3)}%`}function _0(i,e){let t=i.range(e);if(!t)return null;let n=r=>.04+.92*ic(t,r),s=t.logarithmic?eS(t.low,t.high):QM(t.low,t.high);return{at:n,ticks:s.map(r=>({at:n(r),text:ce(r,6)}))}}function JM({levels:i}){let e=s=>(s+.5)/i.length,t=Math.ceil(i.length/8),n=i.flatMap((s,r)=>r%t===0?[{at:e(r),text:Fn(s)}]:[]);return{at:e,ticks:n}}function QM(i,e){if(!(e>i))return[i];let t=(e-i)/5,n=10**Math.floor(Math.log10(t)),s=n*([1,2,5].find(a=>a*n>=t)??10),r=Math.ceil(i/s-1e-9),o=Math.floor(e/s+1e-9)-r+1;return Array.from({length:o},(a,l)=>Number(((r+l)*s).toPrecision(12)))}function eS(i,e){let[t,n]=[Math.ceil(Math.log10(i)),Math.floor(Math.log10(e))],s=Math.ceil((n-t+1)/6);return Array.from({length:Math.floor((n-t)/s)+1},(r,o)=>10**(t+o*s))}var tS=["metric","x","y","plot","levels"],nS=[["best","best run"],["infeasible","does not meet best.where"],["failed","failed"],["missing","not made yet"]],rc=class{constructor(e,t,n){this.model=e;this.state=t;this.actions=n;let s=new Set(e.rows.map((o,a)=>e.state(a))),r=nS.filter(([o])=>s.has(o)).map(([o,a])=>b("span",{},b("span",{class:`mark ${o}`},b("i",{})),a));this.element=b("div",{},b("p.quiet",{},"A click or Enter opens a run below; Shift-click or Space marks it for the comparison; arrow keys move from run to run. Several metrics can be shown at once."),this.controls,this.plots,b("p.color-keys.sweep-keys",{},...r,this.compare)),this.listen(),t.on(tS,()=>this.draw()),t.on(["opened","marked"],()=>this.press()),this.draw()}model;state;actions;element;controls=b("div.controls");plots=b("div.sweep-panels");tip=b("div.chart-tip",{hidden:!0});compare=b("button",{type:"button",hidden:!0,click:()=>Qs("marked")});focus(e){this.marks(e).find(({dataset:t})=>Number(t.row)===e)?.focus()}get shown(){let e=this.state.get("metric").split(","),t=this.model.metrics.filter(({name:n})=>e.includes(n));return t.length>0?t:this.model.metrics.slice(0,1)}get isMap(){let e=this.state.get("plot");return this.model.varying.length>1&&(e===""?this.model.isCrossed:e==="map")}get axes(){let{varying:e}=this.model,t=r=>e.find(({name:o})=>o===this.state.get(r)),n=t("x")??e.find(r=>r!==t("y"))??e[0],s=t("y");return[n,s&&s!==n?s:e.find(r=>r!==n)??n]}level(e){let t=this.model.sweep.best,n=this.state.get("levels").split(",")[e.at]??"",s=n===""?t===null?0:e.levelOf[t]:Number(n);return e.levels[s]===void 0?0:s}draw(){let{model:e,isMap:t}=this,n=this.marks().indexOf(document.activeElement)>=0?document.activeElement.dataset.row:void 0;this.element.classList.toggle("as-dots",!t);let[s,r]=e.varying.length>0?this.axes:[];if(this.drawControls(s,r),!s||!r){this.plots.replaceChildren(b("p.quiet",{},"No axis of this sweep has more than one value: there is nothing to draw over."));return}let o=e.varying.filter(h=>h!==s&&h!==r),a=e.rows.map((h,u)=>u),l=t?a.filter(h=>o.every(u=>u.levelOf[h]===this.level(u))):a,c=h=>t?x0(e,h,s,r,l):y0(e,h,s,l,e.varying.length===1);this.plots.replaceChildren(...this.shown.map(h=>iS(xt(Di(h),c(h)),`${h.title} over ${t?`${s.name} and ${r.name}`:s.name}`)),this.tip),this.press();for(let h of this.plots.querySelectorAll(".part"))(h.querySelector(".opened, .mark.best")??h.querySelector(".mark"))?.setAttribute("tabindex","0");n!==void 0&&this.focus(Number(n))}drawControls(e,t){let{model:n,state:s,isMap:r}=this,o=document.activeElement?.closest(".controls")===this.controls?document.activeElement.getAttribute("data-control"):null,a=n.metrics.map(f=>{let g=this.shown.includes(f),y=()=>{let p=n.metrics.filter(m=>this.shown.includes(m)!==(m===f)).map(({name:m})=>m);p.length>0&&s.set({metric:p.join(",")})};return b("button",{type:"button","aria-pressed":String(g),title:f.summary||null,"data-control":f.name,click:y},f.title)}),l=(f,g,y,p)=>b("label",{},f,b("select",{"data-control":f,change:m=>p(m.target.selectedIndex)},...g.map((m,v)=>b("option",{selected:v===y},m)))),c=(f,g,y)=>{let p=n.varying.map(({name:v})=>v),m=v=>{let T={[g]:p[v]};r&&p[v]===(g==="x"?t:e)?.name&&(T[g==="x"?"y":"x"]=y.name),s.set(T)};return l(f,p,p.indexOf(y.name),m)},h=e&&t&&n.varying.length>1,u=[["map","Map"],["axis","Over one axis"]],d=h&&r?n.varying.filter(f=>f!==e&&f!==t):[];this.controls.replaceChildren(...[n.metrics.length>1&&b("div.choice",{role:"group","aria-label":"Metrics that are drawn"},...a),h&&zn("Drawn as",u,()=>r?"map":"axis",f=>s.set({plot:f}),()=>{}),h&&c(r?"across":"over","x",e),h&&r&&c("up","y",t),...d.map(f=>l(Di(f),f.levels.map(g=>Fn(g)),this.level(f),g=>this.hold(f,g)))].filter(f=>!!f)),o!==null&&this.controls.querySelector(`[data-control="${CSS.escape(o)}"]`)?.focus()}hold(e,t){let n=this.model.axes.map(s=>s===e?t:this.level(s));this.state.set({levels:n.join(",")})}marks(...e){for(let t of this.plots.querySelectorAll(".part"))for(let n of e)Rr.around(t)?.mark(n);return[...this.plots.querySelectorAll(".mark")]}press(){let e=this.state.get("opened"),t=new Set(this.state.get("marked"));this.compare.hidden=t.size<2,this.compare.textContent=`Compare ${t.size} marked runs`;let n=[...t,...e===null?[]:[e]].map(s=>s-1);for(let s of this.marks(...n)){let r=Number(s.dataset.row)+1;s.classList.toggle("opened",r===e),s.classList.toggle("marked",t.has(r)),s.setAttribute("aria-pressed",String(t.has(r)))}}listen(){let e=({target:n})=>n.closest(".mark[data-row]"),t=n=>this.showTip(e(n));this.plots.addEventListener("pointerover",t),this.plots.addEventListener("focusin",n=>{let s=e(n);if(this.showTip(s),s)for(let r of s.closest(".part").querySelectorAll(".mark"))r.setAttribute("tabindex",r===s?"0":"-1")});for(let n of["pointerleave","focusout"])this.plots.addEventListener(n,()=>this.showTip(null));this.plots.addEventListener("click",n=>{let s=e(n);s&&this.actions[n.shiftKey?"toggle":"open"](Number(s.dataset.row))}),this.plots.addEventListener("keydown",n=>this.onKey(n,e(n))),this.plots.addEventListener("keyup",n=>n.key===" "&&e(n)&&n.preventDefault())}onKey(e,t){if(!(!t||e.ctrlKey||e.metaKey||e.altKey)){if(e.key==="Escape")this.showTip(null);else if(e.key===" ")e.preventDefault(),this.actions.toggle(Number(t.dataset.row));else if(e.key.startsWith("Arrow")){e.preventDefault();let n=Rr.around(t);(n?n.neighbor(Number(t.dataset.row),e.key):m0([...t.closest(".part").querySelectorAll(".mark")],t,e.key))?.focus()}}}showTip(e){if(this.tip.hidden=e===null,!e)return;let{model:t}=this,n=Number(e.dataset.row),s=c=>b("div",{},b("span",{},Di(c)),b("b",{},t.text(n,c,5))),{why:r}=t.rows[n];this.tip.replaceChildren(b("div.chart-tip-head",{},`Run ${n+1}, ${t.state(n)}`),...t.columns.map(s),...r?[b("p",{},r)]:[]);let[o,a]=[this.plots.getBoundingClientRect(),e.getBoundingClientRect()],l=a.left-o.left>o.width/2;this.tip.style.top=`${a.bottom-o.top+8}px`,this.tip.style.left=l?"":`${a.left-o.left}px`,this.tip.style.right=l?`${o.right-a.right}px`:""}};function iS(i,e){return i.setAttribute("role","group"),i.setAttribute("aria-label",e),i}var sS={"<=":(i,e)=>i<=e,">=":(i,e)=>i>=e,"!=":(i,e)=>i!==e,"==":(i,e)=>i===e,"=":(i,e)=>i===e,"<":(i,e)=>i<e,">":(i,e)=>i>e};function v0(i,e){let t=e.split(",").map(n=>n.trim()).filter(n=>n!=="").map(n=>rS(i,n));return i.rows.map((n,s)=>s).filter(n=>t.every(s=>s(n)))}function rS(i,e){let[,t,n,s]=e.match(/^(.*?)\s*(<=|>=|!=|==|=|<|>)\s*(.*)$/)??[],r=t===void 0?void 0:oS(i,t),o=Number(s);if(r&&s!==""&&pe(o)){let l=sS[n];return c=>{let h=i.number(c,r);return h!==null&&l(h,o)}}if(r&&(n==="="||n==="=="))return l=>i.text(l,r).toLowerCase()===s.toLowerCase();let a=e.toLowerCase();return l=>[...i.columns.map(c=>i.text(l,c)),i.state(l),i.rows[l].why??""].some(c=>c.toLowerCase().includes(a))}function oS({columns:i},e){let t=i.filter(n=>n.name.split(".").at(-1)===e);return i.find(n=>n.name===e)??(t.length===1?t[0]:void 0)}var oc=200,ac=class{constructor(e,t,n){this.model=e;this.state=t;this.actions=n;let s=e.varying[0]?.name??"iou",r=b("input",{type:"search",placeholder:`${s} > 0.5, failed`,"aria-label":"Filter runs"});r.addEventListener("input",()=>{this.filter=r.value,this.most=oc,this.draw()}),this.element=b("div",{},b("div.controls",{},b("label.filter",{},"Filter",r),this.count,Li("Copy as CSV",()=>this.csv())),b("p.note",{},"A filter has conditions on columns and words, separated by commas. Numbers are in the units of report.json. A click on a head sorts."),this.place),this.place.addEventListener("click",o=>this.onClick(o)),t.on(["marked","opened"],()=>this.press()),this.draw()}model;state;actions;element;place=b("div.sweep-runs");count=b("span.quiet",{role:"status"});filter="";most=oc;sorted=null;rows(){let e=v0(this.model,this.filter);if(!this.sorted)return e;let{column:t,isDown:n}=this.sorted,{model:s}=this;return e.sort((r,o)=>{let[a,l]=[s.value(r,t),s.value(o,t)];if(a===null||l===null)return+(a===null)-+(l===null)||r-o;let c=pe(a)&&pe(l)?a-l:Fn(a).localeCompare(Fn(l));return(n?-c:c)||r-o})}draw(){let{model:e}=this,t=this.rows();this.count.textContent=t.length===e.rows.length?`${t.length} runs`:`${t.length} of ${e.rows.length} runs`;let n=["run","",...e.columns.map(a=>this.head(a)),"state"],s=a=>[b("button",{type:"button","data-row":a,title:"Open this run"},String(a+1)),b("input",{type:"checkbox","data-row":a,"aria-label":`Mark run ${a+1} for the comparison`}),...e.columns.map(l=>e.text(a,l,l.at<e.axes.length?6:4)),b("span",{},e.state(a),b("small",{},e.rows[a].why))],r=e.columns.flatMap((a,l)=>e.rows.some((c,h)=>typeof e.value(h,a)=="string")?[l+2]:[]),o=()=>{this.most+=oc,this.draw()};this.place.replaceChildren(gt({caption:"Runs of the sweep",heads:n,rows:t.slice(0,this.most).map(s),text:[1,...r,e.columns.length+2]}),...t.length>this.most?[b("button",{type:"button",click:o},`Show ${Math.min(oc,t.length-this.most)} more of ${t.length}`)]:[]),this.place.querySelectorAll("thead th").forEach((a,l)=>{let c=e.columns[l-2];c&&c===this.sorted?.column&&a.setAttribute("aria-sort",this.sorted.isDown?"descending":"ascending")}),this.press()}head(e){let t=this.sorted?.column===e?this.sorted.isDown?" ↓":" ↑":"",n=()=>{this.sort(e),this.place.querySelector(`[data-column="${e.at}"]`)?.focus()};return b("button.sort",{type:"button","data-column":e.at,title:e.summary||null,click:n},Di(e)+t)}sort(e){let t=e.better==="higher";this.sorted?.column!==e?this.sorted={column:e,isDown:t}:this.sorted=this.sorted.isDown===t?{column:e,isDown:!t}:null,this.draw()}onClick(e){let t=e.target,n=t.closest("[data-row]")??t.closest("tbody tr")?.querySelector("[data-row]");if(!n)return;let s=Number(n.dataset.row);n instanceof HTMLInputElement?this.actions.toggle(s):this.actions.open(s)}press(){let e=new Set(this.state.get("marked"));for(let t of this.place.querySelectorAll("input[data-row]")){let n=Number(t.dataset.row)+1;t.checked=e.has(n);let s=t.closest("tr");n===this.state.get("opened")?s.setAttribute("aria-current","true"):s.removeAttribute("aria-current")}}csv(){let{model:e}=this,t=(s,r)=>{let o=e.value(s,r);return o===null||pe(o)?o:Fn(o)},n=s=>Ii([s+1,...e.columns.map(r=>t(s,r)),e.rows[s].state,e.rows[s].feasible?.toString(),e.rows[s].why]);return[Ii(["run",...e.columns.map(({name:s})=>s),"state","feasible","error"]),...this.rows().map(n)].join(`
`)+`
`}};var lc=class{constructor(e,t,n,s){this.state=n;this.load=s;this.model=new nc(t,e.metrics);let r={open:c=>this.choose(c),toggle:c=>this.toggle(c)};this.panels=new rc(this.model,n,r);let o=new ac(this.model,n,r);this.side=b("section",{id:"marked","aria-label":"Marked runs side by side"});let a=()=>{let c=n.get("marked").map(h=>h-1).filter(h=>h<this.model.rows.length);this.side.hidden=c.length<2,this.side.replaceChildren(b("h2",{},"Marked runs side by side"),f0(this.model,c,r))},l=t.toml!==""&&b("details.fold",{},b("summary",{},"The sweep file"),Li("Copy the sweep file",()=>t.toml),b("pre.job",{tabindex:"0"},t.toml));this.sections=[kd("sweep-head","",this.head()),kd("sweep","Over the axes",this.panels.element),kd("runs","Runs",o.element,l),this.side,this.bar],a(),n.on(["marked"],a),n.on(["opened"],()=>{this.show(!0)}),this.show(!1)}state;load;sections;model;panels;side;bar=b("section",{id:"opened","aria-label":"Open run",hidden:!0});get entries(){let e=[{id:"sweep",title:"Over the axes"},{id:"runs",title:"Runs"}];return this.bar.hidden?e:[...e,{id:"opened",title:"Open run"}]}head(){let{model:e}=this,{name:t,best:n}=e.sweep,s=l=>e.rows.filter(c=>c.state===l).length,r=[[s("failed"),"failed"],[s("missing"),"not made yet"]].filter(([l])=>l!==0).map(([l,c])=>`, ${l} ${c}`).join(""),o=e.varying.map(l=>`${l.name} (${l.levels.length})`).join(", "),a=n===null?"No run meets best.where.":`The best is run ${n+1}: ${e.point(n)}.`;return b("div.head",{},b("p.brand",{},"Tomolith sweep"),b("h1",{},t),b("p.lead",{},`${e.rows.length} runs${o===""?"":` over ${o}`}: ${s("done")} done${r}. ${a}`),n!==null&&b("p",{},b("button",{type:"button",click:()=>this.choose(n)},"Open the best run")))}choose(e){this.state.get("opened")===e+1?this.show(!0):this.state.set({opened:e+1})}toggle(e){let t=this.state.get("marked"),n=e+1;this.state.set({marked:t.includes(n)?t.filter(s=>s!==n):[...t,n].sort((s,r)=>s-r)})}async show(e){let t=this.state.get("opened"),n=t===null?null:t-1,s=n===null?null:this.refusal(n);this.bar.hidden=n===null,this.bar.setAttribute("aria-busy",String(n!==null)),this.bar.replaceChildren(...n===null?[]:[this.barHead(n),b("p.quiet",{role:"status"},"Opening…")]);let r=await this.load(s===null?n:null).then(()=>s,o=>o instanceof Error?o.message:String(o));this.state.get("opened")===t&&(this.bar.lastElementChild?.replaceWith(r===null?"":b("p.problem",{role:"alert"},r)),this.bar.removeAttribute("aria-busy"),e&&n!==null&&Qs("opened"))}refusal(e){let t=this.model.rows[e];return t?t.state==="done"?null:t.state==="missing"?"This run has not been made yet. The command that made the sweep continues it.":`This run failed: ${t.why??"the sweep does not say why"}`:`The sweep has ${this.model.rows.length} runs.`}barHead(e){let t=()=>{this.state.set({opened:null}),document.getElementById("sweep")?.scrollIntoView(),this.panels.focus(e)},n=this.model.rows[e]?this.model.point(e):"";return b("div.opened-head",{},b("h2",{},`Run ${e+1}`),b("p",{},n),b("button",{type:"button",click:t},"Back to the sweep"))}};function kd(i,e,...t){return b("section",{id:i,"aria-label":e||"Sweep"},e!==""&&b("h2",{},e),...t)}var ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},dr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},q0=0,pf=1,Y0=2;var rl=1,Z0=2,$o=3,fr=0,ii=1,ai=2,kr=0,Xo=1,mf=2,gf=3,xf=4,K0=5;var Br=100,j0=101,J0=102,Q0=103,ex=104,tx=200,nx=201,ix=202,sx=203,_f=204,yf=205,rx=206,ox=207,ax=208,lx=209,cx=210,hx=211,ux=212,dx=213,fx=214,Dc=0,Nc=1,Oc=2,Do=3,Uc=4,Fc=5,kc=6,Bc=7,uh=0,px=1,mx=2,fs=0,vf=1,bf=2,Mf=3,Sf=4,wf=5,Ef=6,Tf=7;var Af=300,zr=301,qo=302,dh=303,fh=304,zc=1e3,us=1001,Vc=1002,yn=1003,gx=1004;var ol=1005;var ni=1006,ph=1007;var Bs=1008;var li=1009,Cf=1010,Rf=1011,Yo=1012,mh=1013,Yi=1014,Zi=1015,Ki=1016,gh=1017,xh=1018,Vr=1020,Pf=35902,Lf=35899,If=1021,Df=1022,wi=1023,Os=1026,zs=1027,Nf=1028,_h=1029,pr=1030,yh=1031;var vh=1033,al=33776,ll=33777,cl=33778,hl=33779,bh=35840,Mh=35841,Sh=35842,wh=35843,Eh=36196,Th=37492,Ah=37496,Ch=37488,Rh=37489,ul=37490,Ph=37491,Lh=37808,Ih=37809,Dh=37810,Nh=37811,Oh=37812,Uh=37813,Fh=37814,kh=37815,Bh=37816,zh=37817,Vh=37818,Hh=37819,Gh=37820,Wh=37821,$h=36492,Xh=36494,qh=36495,Yh=36283,Zh=36284,dl=36285,Kh=36286;var Ba=2300,Hc=2301,Lc=2302,af=2303,lf=2400,cf=2401,hf=2402;var xx=3200;var jh=0,_x=1,Vs="",On="srgb",za="srgb-linear",Va="linear",It="srgb";var Ic=7680;var yx=519,vx=512,bx=513,Mx=514,Of=515,Sx=516,wx=517,Uf=518,Ff=519,Ex=35044;var kf="300 es",Oi=2e3,No=2001;function aS(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function lS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ha(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Tx(){let i=Ha("canvas");return i.style.display="block",i}var b0={},Oo=null;function Bf(...i){let e="THREE."+i.shift();Oo?Oo("log",e,...i):console.log(e,...i)}function Ax(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=Ax(i);let e="THREE."+i.shift();if(Oo)Oo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function et(...i){i=Ax(i);let e="THREE."+i.shift();if(Oo)Oo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ua(...i){let e=i.join(" ");e in b0||(b0[e]=!0,Ze(...i))}function Cx(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Rx={[Dc]:Dc,[Oc]:kc,[Uc]:Uc,[Do]:Fc,[Nc]:Nc,[kc]:Oc,[Bc]:Bc,[Fc]:Do},qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],M0=1234567,Fa=Math.PI/180,Uo=180/Math.PI;function Zo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]).toLowerCase()}function _t(i,e,t){return Math.max(e,Math.min(t,i))}function zf(i,e){return(i%e+e)%e}function cS(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function hS(i,e,t){return i!==e?(t-i)/(e-i):0}function ka(i,e,t){return(1-t)*i+t*e}function uS(i,e,t,n){return ka(i,e,1-Math.exp(-t*n))}function dS(i,e=1){return e-Math.abs(zf(i,e*2)-e)}function fS(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function pS(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function mS(i,e){return i+Math.floor(Math.random()*(e-i+1))}function gS(i,e){return i+Math.random()*(e-i)}function xS(i){return i*(.5-Math.random())}function _S(i){i!==void 0&&(M0=i);let e=M0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function yS(i){return i*Fa}function vS(i){return i*Uo}function bS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function MS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Vf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function SS(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Hf(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Px(i,e){if(e.constructor===Float32Array)return i;let t=Hf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Lx(i,e){if(e.constructor===Float32Array)return i;let t=Hf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Gf={DEG2RAD:Fa,RAD2DEG:Uo,generateUUID:Zo,clamp:_t,euclideanModulo:zf,mapLinear:cS,inverseLerp:hS,lerp:ka,damp:uS,pingpong:dS,smoothstep:fS,smootherstep:pS,randInt:mS,randFloat:gS,randFloatSpread:xS,seededRandom:_S,degToRad:yS,radToDeg:vS,isPowerOfTwo:bS,ceilPowerOfTwo:MS,floorPowerOfTwo:Vf,setQuaternionFromProperEuler:SS,normalize:Lx,denormalize:Px},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},vi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),T=Math.sin(v);m=Math.sin(m*v)/T,a=Math.sin(a*v)/T,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(S0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(S0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Bd.copy(this).projectOnVector(e),this.sub(Bd)}reflect(e){return this.sub(Bd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Bd=new q,S0=new vi,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],y=s[0],p=s[3],m=s[6],v=s[1],T=s[4],S=s[7],R=s[2],C=s[5],_=s[8];return r[0]=o*y+a*v+l*R,r[3]=o*p+a*T+l*C,r[6]=o*m+a*S+l*_,r[1]=c*y+h*v+u*R,r[4]=c*p+h*T+u*C,r[7]=c*m+h*S+u*_,r[2]=d*y+f*v+g*R,r[5]=d*p+f*T+g*C,r[8]=d*m+f*S+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ua("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(zd.makeScale(e,t)),this}rotate(e){return Ua("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(zd.makeRotation(-e)),this}translate(e,t){return Ua("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(zd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},zd=new it,w0=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),E0=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function wS(){let i={enabled:!0,workingColorSpace:za,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=Ns(s.r),s.g=Ns(s.g),s.b=Ns(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=Io(s.r),s.g=Io(s.g),s.b=Io(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Vs?Va:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[za]:{primaries:e,whitePoint:n,transfer:Va,toXYZ:w0,fromXYZ:E0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:On},outputColorSpaceConfig:{drawingBufferColorSpace:On}},[On]:{primaries:e,whitePoint:n,transfer:It,toXYZ:w0,fromXYZ:E0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:On}}}),i}var Mt=wS();function Ns(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Io(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var yo,Gc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{yo===void 0&&(yo=Ha("canvas")),yo.width=e.width,yo.height=e.height;let s=yo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=yo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ha("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ns(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ns(t[n]/255)*255):t[n]=Ns(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ES=0,Fo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ES++}),this.uuid=Zo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Vd(s[o].image)):r.push(Vd(s[o]))}else r=Vd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Vd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Gc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var TS=0,Hd=new q,ri=class i extends qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=us,s=us,r=ni,o=Bs,a=wi,l=li,c=i.DEFAULT_ANISOTROPY,h=Vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:TS++}),this.uuid=Zo(),this.name="",this.source=new Fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Hd).x}get height(){return this.source.getSize(Hd).y}get depth(){return this.source.getSize(Hd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Af)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case zc:e.x=e.x-Math.floor(e.x);break;case us:e.x=e.x<0?0:1;break;case Vc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case zc:e.y=e.y-Math.floor(e.y);break;case us:e.y=e.y<0?0:1;break;case Vc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=Af;ri.DEFAULT_ANISOTROPY=1;var jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(f+1)/2,R=(m+1)/2,C=(h+d)/4,_=(u+y)/4,A=(g+p)/4;return T>S&&T>R?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=C/n,r=_/n):S>R?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=C/s,r=A/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=_/r,s=A/r),this.set(n,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(u-y)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Wc=class extends qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ni,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new jt(0,0,e,t),this.scissorTest=!1,this.viewport=new jt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ni,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Fo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends Wc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ga=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var $c=class extends ri{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Yt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/vo.setFromMatrixColumn(e,0).length(),r=1/vo.setFromMatrixColumn(e,1).length(),o=1/vo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(AS,e,CS)}lookAt(e,t,n){let s=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),er.crossVectors(n,xi),er.lengthSq()===0&&(Math.abs(n.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),er.crossVectors(n,xi)),er.normalize(),cc.crossVectors(xi,er),s[0]=er.x,s[4]=cc.x,s[8]=xi.x,s[1]=er.y,s[5]=cc.y,s[9]=xi.y,s[2]=er.z,s[6]=cc.z,s[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],y=n[6],p=n[10],m=n[14],v=n[3],T=n[7],S=n[11],R=n[15],C=s[0],_=s[4],A=s[8],z=s[12],O=s[1],D=s[5],G=s[9],H=s[13],N=s[2],W=s[6],$=s[10],B=s[14],oe=s[3],K=s[7],Q=s[11],ie=s[15];return r[0]=o*C+a*O+l*N+c*oe,r[4]=o*_+a*D+l*W+c*K,r[8]=o*A+a*G+l*$+c*Q,r[12]=o*z+a*H+l*B+c*ie,r[1]=h*C+u*O+d*N+f*oe,r[5]=h*_+u*D+d*W+f*K,r[9]=h*A+u*G+d*$+f*Q,r[13]=h*z+u*H+d*B+f*ie,r[2]=g*C+y*O+p*N+m*oe,r[6]=g*_+y*D+p*W+m*K,r[10]=g*A+y*G+p*$+m*Q,r[14]=g*z+y*H+p*B+m*ie,r[3]=v*C+T*O+S*N+R*oe,r[7]=v*_+T*D+S*W+R*K,r[11]=v*A+T*G+S*$+R*Q,r[15]=v*z+T*H+S*B+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],v=l*f-c*d,T=a*f-c*u,S=a*d-l*u,R=o*f-c*h,C=o*d-l*h,_=o*u-a*h;return t*(y*v-p*T+m*S)-n*(g*v-p*R+m*C)+s*(g*T-y*R+m*_)-r*(g*S-y*C+p*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],v=t*a-n*o,T=t*l-s*o,S=t*c-r*o,R=n*l-s*a,C=n*c-r*a,_=s*c-r*l,A=h*y-u*g,z=h*p-d*g,O=h*m-f*g,D=u*p-d*y,G=u*m-f*y,H=d*m-f*p,N=v*H-T*G+S*D+R*O-C*z+_*A;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*H-l*G+c*D)*W,e[1]=(s*G-n*H-r*D)*W,e[2]=(y*_-p*C+m*R)*W,e[3]=(d*C-u*_-f*R)*W,e[4]=(l*O-o*H-c*z)*W,e[5]=(t*H-s*O+r*z)*W,e[6]=(p*S-g*_-m*T)*W,e[7]=(h*_-d*S+f*T)*W,e[8]=(o*G-a*O+c*A)*W,e[9]=(n*O-t*G-r*A)*W,e[10]=(g*C-y*S+m*v)*W,e[11]=(u*S-h*C-f*v)*W,e[12]=(a*z-o*D-l*A)*W,e[13]=(t*D-n*z+s*A)*W,e[14]=(y*T-g*R-p*v)*W,e[15]=(h*R-u*T+d*v)*W,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,y=o*h,p=o*u,m=a*u,v=l*c,T=l*h,S=l*u,R=n.x,C=n.y,_=n.z;return s[0]=(1-(y+m))*R,s[1]=(f+S)*R,s[2]=(g-T)*R,s[3]=0,s[4]=(f-S)*C,s[5]=(1-(d+m))*C,s[6]=(p+v)*C,s[7]=0,s[8]=(g+T)*_,s[9]=(p-v)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=vo.set(s[0],s[1],s[2]).length(),a=vo.set(s[4],s[5],s[6]).length(),l=vo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Wi.copy(this);let c=1/o,h=1/a,u=1/l;return Wi.elements[0]*=c,Wi.elements[1]*=c,Wi.elements[2]*=c,Wi.elements[4]*=h,Wi.elements[5]*=h,Wi.elements[6]*=h,Wi.elements[8]*=u,Wi.elements[9]*=u,Wi.elements[10]*=u,t.setFromRotationMatrix(Wi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Oi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Oi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===No)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Oi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Oi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===No)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},vo=new q,Wi=new Yt,AS=new q(0,0,0),CS=new q(1,1,1),er=new q,cc=new q,xi=new q,T0=new Yt,A0=new vi,Us=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return T0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(T0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return A0.setFromEuler(this),this.setFromQuaternion(A0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Us.DEFAULT_ORDER="XYZ";var Wa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},RS=0,C0=new q,bo=new vi,Cs=new Yt,hc=new q,La=new q,PS=new q,LS=new vi,R0=new q(1,0,0),P0=new q(0,1,0),L0=new q(0,0,1),I0={type:"added"},IS={type:"removed"},Mo={type:"childadded",child:null},Gd={type:"childremoved",child:null},$n=class i extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:RS++}),this.uuid=Zo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new q,t=new Us,n=new vi,s=new q(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Yt},normalMatrix:{value:new it}}),this.matrix=new Yt,this.matrixWorld=new Yt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.multiply(bo),this}rotateOnWorldAxis(e,t){return bo.setFromAxisAngle(e,t),this.quaternion.premultiply(bo),this}rotateX(e){return this.rotateOnAxis(R0,e)}rotateY(e){return this.rotateOnAxis(P0,e)}rotateZ(e){return this.rotateOnAxis(L0,e)}translateOnAxis(e,t){return C0.copy(e).applyQuaternion(this.quaternion),this.position.add(C0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(R0,e)}translateY(e){return this.translateOnAxis(P0,e)}translateZ(e){return this.translateOnAxis(L0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Cs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?hc.copy(e):hc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),La.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Cs.lookAt(La,hc,this.up):Cs.lookAt(hc,La,this.up),this.quaternion.setFromRotationMatrix(Cs),s&&(Cs.extractRotation(s.matrixWorld),bo.setFromRotationMatrix(Cs),this.quaternion.premultiply(bo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(I0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(IS),Gd.child=e,this.dispatchEvent(Gd),Gd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Cs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Cs.multiply(e.parent.matrixWorld)),e.applyMatrix4(Cs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(I0),Mo.child=e,this.dispatchEvent(Mo),Mo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,e,PS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,LS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$n.DEFAULT_UP=new q(0,1,0);$n.DEFAULT_MATRIX_AUTO_UPDATE=!0;$n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ds=class extends $n{constructor(){super(),this.isGroup=!0,this.type="Group"}},DS={type:"move"},ko=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ds,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ds,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ds,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(DS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Ds;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Ix={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},tr={h:0,s:0,l:0},uc={h:0,s:0,l:0};function Wd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ct=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=On){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Mt.workingColorSpace){if(e=zf(e,1),t=_t(t,0,1),n=_t(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Wd(o,r,e+1/3),this.g=Wd(o,r,e),this.b=Wd(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=On){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=On){let n=Ix[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ns(e.r),this.g=Ns(e.g),this.b=Ns(e.b),this}copyLinearToSRGB(e){return this.r=Io(e.r),this.g=Io(e.g),this.b=Io(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=On){return Mt.workingToColorSpace(Gn.copy(this),e),Math.round(_t(Gn.r*255,0,255))*65536+Math.round(_t(Gn.g*255,0,255))*256+Math.round(_t(Gn.b*255,0,255))}getHexString(e=On){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(Gn.copy(this),t);let n=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(Gn.copy(this),t),e.r=Gn.r,e.g=Gn.g,e.b=Gn.b,e}getStyle(e=On){Mt.workingToColorSpace(Gn.copy(this),e);let t=Gn.r,n=Gn.g,s=Gn.b;return e!==On?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(tr),this.setHSL(tr.h+e,tr.s+t,tr.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(tr),e.getHSL(uc);let n=ka(tr.h,uc.h,t),s=ka(tr.s,uc.s,t),r=ka(tr.l,uc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new ct;ct.NAMES=Ix;var $a=class extends $n{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Us,this.environmentIntensity=1,this.environmentRotation=new Us,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new q,Rs=new q,$d=new q,Ps=new q,So=new q,wo=new q,D0=new q,Xd=new q,qd=new q,Yd=new q,Zd=new jt,Kd=new jt,jd=new jt,rr=class i{constructor(e=new q,t=new q,n=new q){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){$i.subVectors(s,t),Rs.subVectors(n,t),$d.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Rs),l=$i.dot($d),c=Rs.dot(Rs),h=Rs.dot($d),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Ps)===null?!1:Ps.x>=0&&Ps.y>=0&&Ps.x+Ps.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Ps)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ps.x),l.addScaledVector(o,Ps.y),l.addScaledVector(a,Ps.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Zd.setScalar(0),Kd.setScalar(0),jd.setScalar(0),Zd.fromBufferAttribute(e,t),Kd.fromBufferAttribute(e,n),jd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Zd,r.x),o.addScaledVector(Kd,r.y),o.addScaledVector(jd,r.z),o}static isFrontFacing(e,t,n,s){return $i.subVectors(n,t),Rs.subVectors(e,t),$i.cross(Rs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Rs.subVectors(this.a,this.b),$i.cross(Rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;So.subVectors(s,n),wo.subVectors(r,n),Xd.subVectors(e,n);let l=So.dot(Xd),c=wo.dot(Xd);if(l<=0&&c<=0)return t.copy(n);qd.subVectors(e,s);let h=So.dot(qd),u=wo.dot(qd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(So,o);Yd.subVectors(e,r);let f=So.dot(Yd),g=wo.dot(Yd);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(wo,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return D0.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(D0,a);let m=1/(p+y+d);return o=y*m,a=d*m,t.copy(n).addScaledVector(So,o).addScaledVector(wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},or=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Xi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Xi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Xi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Xi):Xi.fromBufferAttribute(r,o),Xi.applyMatrix4(e.matrixWorld),this.expandByPoint(Xi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),dc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),dc.copy(n.boundingBox)),dc.applyMatrix4(e.matrixWorld),this.union(dc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Xi),Xi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ia),fc.subVectors(this.max,Ia),Eo.subVectors(e.a,Ia),To.subVectors(e.b,Ia),Ao.subVectors(e.c,Ia),nr.subVectors(To,Eo),ir.subVectors(Ao,To),Pr.subVectors(Eo,Ao);let t=[0,-nr.z,nr.y,0,-ir.z,ir.y,0,-Pr.z,Pr.y,nr.z,0,-nr.x,ir.z,0,-ir.x,Pr.z,0,-Pr.x,-nr.y,nr.x,0,-ir.y,ir.x,0,-Pr.y,Pr.x,0];return!Jd(t,Eo,To,Ao,fc)||(t=[1,0,0,0,1,0,0,0,1],!Jd(t,Eo,To,Ao,fc))?!1:(pc.crossVectors(nr,ir),t=[pc.x,pc.y,pc.z],Jd(t,Eo,To,Ao,fc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Xi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Xi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ls),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ls=[new q,new q,new q,new q,new q,new q,new q,new q],Xi=new q,dc=new or,Eo=new q,To=new q,Ao=new q,nr=new q,ir=new q,Pr=new q,Ia=new q,fc=new q,pc=new q,Lr=new q;function Jd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Lr.fromArray(i,r);let a=s.x*Math.abs(Lr.x)+s.y*Math.abs(Lr.y)+s.z*Math.abs(Lr.z),l=e.dot(Lr),c=t.dot(Lr),h=n.dot(Lr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new q,mc=new tt,NS=0,Wn=class extends qi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:NS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ex,this.updateRanges=[],this.gpuType=Zi,this.version=0,this._normalizationScale=e!==void 0?Hf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)mc.fromBufferAttribute(this,t),mc.applyMatrix3(e),this.setXY(t,mc.x,mc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix3(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix4(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.applyNormalMatrix(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)_n.fromBufferAttribute(this,t),_n.transformDirection(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Px(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Lx(e,this.array)}};var Xa=class extends Wn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var qa=class extends Wn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var yi=class extends Wn{constructor(e,t,n){super(new Float32Array(e),t,n)}},OS=new or,Da=new q,Qd=new q,Nr=class{constructor(e=new q,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):OS.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Da.subVectors(e,this.center);let t=Da.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Da,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Qd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Da.copy(e.center).add(Qd)),this.expandByPoint(Da.copy(e.center).sub(Qd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},US=0,Ni=new Yt,ef=new $n,Co=new q,_i=new or,Na=new or,Nn=new q,Mi=class i extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:US++}),this.uuid=Zo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(aS(e)?qa:Xa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new it().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,n){return Ni.makeTranslation(e,t,n),this.applyMatrix4(Ni),this}scale(e,t,n){return Ni.makeScale(e,t,n),this.applyMatrix4(Ni),this}lookAt(e){return ef.lookAt(e),ef.updateMatrix(),this.applyMatrix4(ef.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new yi(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new or);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let n=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Na.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(_i.min,Na.min),_i.expandByPoint(Nn),Nn.addVectors(_i.max,Na.max),_i.expandByPoint(Nn)):(_i.expandByPoint(Na.min),_i.expandByPoint(Na.max))}_i.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Nn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),Nn.add(Co)),s=Math.max(s,n.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Wn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)a[z]=new q,l[z]=new q;let h=new q,u=new q,d=new q,f=new tt,g=new tt,y=new tt,p=new q,m=new q;function v(z,O,D){c[z]=c[O]=c[D]=1,h.fromBufferAttribute(n,z),u.fromBufferAttribute(n,O),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,z),g.fromBufferAttribute(r,O),y.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(f),y.sub(f);let G=1/(g.x*y.y-y.x*g.y);isFinite(G)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(G),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(G),a[z].add(p),a[O].add(p),a[D].add(p),l[z].add(m),l[O].add(m),l[D].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let z=0,O=T.length;z<O;++z){let D=T[z],G=D.start,H=D.count;for(let N=G,W=G+H;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new q,R=new q,C=new q,_=new q;function A(z){C.fromBufferAttribute(s,z),_.copy(C);let O=a[z];S.copy(O),S.sub(C.multiplyScalar(C.dot(O))).normalize(),R.crossVectors(_,O);let G=R.dot(l[z])<0?-1:1;o.setXYZW(z,S.x,S.y,S.z,G)}for(let z=0,O=n.count;z<O;++z)c[z]&&A(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Wn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,h=new q,u=new q;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new Wn(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var tf=new q,FS=new q,kS=new it,ei=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=tf.subVectors(n,t).cross(FS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||kS.getNormalMatrix(e),s=this.coplanarPoint(tf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},BS=0,Fs=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:BS++}),this.uuid=Zo(),this.name="",this.type="Material",this.blending=Xo,this.side=fr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=_f,this.blendDst=yf,this.blendEquation=Br,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=Do,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=yx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ic,this.stencilZFail=Ic,this.stencilZPass=Ic,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ei().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new tt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Is=new q,nf=new q,gc=new q,xc=new q,Or=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Is)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Is.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Is.copy(this.origin).addScaledVector(this.direction,t),Is.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){nf.copy(e).add(t).multiplyScalar(.5),gc.copy(t).sub(e).normalize(),xc.copy(this.origin).sub(nf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(gc),a=xc.dot(this.direction),l=-xc.dot(gc),c=xc.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(nf).addScaledVector(gc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Is.subVectors(e.center,this.origin);let n=Is.dot(this.direction),s=Is.dot(Is)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Is)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,m=n.x-o.x,v=n.y-o.y,T=n.z-o.z,S=Math.abs(l),R=Math.abs(c),C=Math.abs(h),_,A,z,O,D,G,H,N,W,$,B,oe;if(S>=R&&S>=C?(z=l,G=u,W=g,oe=m,l>=0?(_=c,A=h,O=d,D=f,H=y,N=p,$=v,B=T):(_=h,A=c,O=f,D=d,H=p,N=y,$=T,B=v)):R>=C?(z=c,G=d,W=y,oe=v,c>=0?(_=h,A=l,O=f,D=u,H=p,N=g,$=T,B=m):(_=l,A=h,O=u,D=f,H=g,N=p,$=m,B=T)):(z=h,G=f,W=p,oe=T,h>=0?(_=l,A=c,O=u,D=d,H=g,N=y,$=m,B=v):(_=c,A=l,O=d,D=u,H=y,N=g,$=v,B=m)),z===0)return null;let K=_/z,Q=A/z,ie=1/z,de=O-K*G,fe=D-Q*G,ee=H-K*W,xe=N-Q*W,ve=$-K*oe,Re=B-Q*oe,we=ve*xe-Re*ee,$e=de*Re-fe*ve,ot=ee*fe-xe*de;if(s){if(we<0||$e<0||ot<0)return null}else if((we<0||$e<0||ot<0)&&(we>0||$e>0||ot>0))return null;let Ge=we+$e+ot;if(Ge===0)return null;let ft=ie*(we*G+$e*W+ot*oe);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ur=class extends Fs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Us,this.combine=uh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},N0=new Yt,Ir=new Or,_c=new Nr,O0=new q,yc=new q,vc=new q,bc=new q,sf=new q,Mc=new q,U0=new q,Sc=new q,oi=class extends $n{constructor(e=new Mi,t=new Ur){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Mc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(sf.fromBufferAttribute(u,e),o?Mc.addScaledVector(sf,h):Mc.addScaledVector(sf.sub(t),h))}t.add(Mc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),_c.copy(n.boundingSphere),_c.applyMatrix4(r),Ir.copy(e.ray).recast(e.near),!(_c.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(_c,O0)===null||Ir.origin.distanceToSquared(O0)>(e.far-e.near)**2))&&(N0.copy(r).invert(),Ir.copy(e.ray).applyMatrix4(N0),!(n.boundingBox!==null&&Ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),T=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let S=v,R=T;S<R;S+=3){let C=a.getX(S),_=a.getX(S+1),A=a.getX(S+2);s=wc(this,m,e,n,c,h,u,C,_,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let v=a.getX(p),T=a.getX(p+1),S=a.getX(p+2);s=wc(this,o,e,n,c,h,u,v,T,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),T=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let S=v,R=T;S<R;S+=3){let C=S,_=S+1,A=S+2;s=wc(this,m,e,n,c,h,u,C,_,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){let v=p,T=p+1,S=p+2;s=wc(this,o,e,n,c,h,u,v,T,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function zS(i,e,t,n,s,r,o,a){let l;if(e.side===ii?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===fr,a),l===null)return null;Sc.copy(a),Sc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Sc);return c<t.near||c>t.far?null:{distance:c,point:Sc.clone(),object:i}}function wc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,yc),i.getVertexPosition(l,vc),i.getVertexPosition(c,bc);let h=zS(i,e,t,n,yc,vc,bc,U0);if(h){let u=new q;rr.getBarycoord(U0,yc,vc,bc,u),s&&(h.uv=rr.getInterpolatedAttribute(s,a,l,c,u,new tt)),r&&(h.uv1=rr.getInterpolatedAttribute(r,a,l,c,u,new tt)),o&&(h.normal=rr.getInterpolatedAttribute(o,a,l,c,u,new q),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new q,materialIndex:0};rr.getNormal(yc,vc,bc,d.normal),h.face=d,h.barycoord=u}return h}var Bo=class extends ri{constructor(e=null,t=1,n=1,s,r,o,a,l,c=yn,h=yn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Dr=new Nr,VS=new tt(.5,.5),Ec=new q,ar=class{constructor(e=new ei,t=new ei,n=new ei,s=new ei,r=new ei,o=new ei){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Oi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],p=r[10],m=r[11],v=r[12],T=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-v).normalize(),s[1].setComponents(c+o,f+h,m+g,R+v).normalize(),s[2].setComponents(c+a,f+u,m+y,R+T).normalize(),s[3].setComponents(c-a,f-u,m-y,R-T).normalize(),n)s[4].setComponents(l,d,p,S).normalize(),s[5].setComponents(c-l,f-d,m-p,R-S).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-S).normalize(),t===Oi)s[5].setComponents(c+l,f+d,m+p,R+S).normalize();else if(t===No)s[5].setComponents(l,d,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Dr)}intersectsSprite(e){Dr.center.set(0,0,0);let t=VS.distanceTo(e.center);return Dr.radius=.7071067811865476+t,Dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Dr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ec.x=s.normal.x>0?e.max.x:e.min.x,Ec.y=s.normal.y>0?e.max.y:e.min.y,Ec.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ec)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},F0=new Yt,Xc=class i{constructor(){this.coordinateSystem=Oi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];F0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ar),n[s].setFromProjectionMatrix(F0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ar),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var zo=class extends Fs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},qc=new q,Yc=new q,k0=new Yt,Oa=new Or,Tc=new Nr,rf=new q,B0=new q,Zc=class extends $n{constructor(e=new Mi,t=new zo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)qc.fromBufferAttribute(t,s-1),Yc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=qc.distanceTo(Yc);e.setAttribute("lineDistance",new yi(n,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Tc.copy(n.boundingSphere),Tc.applyMatrix4(s),Tc.radius+=r,e.ray.intersectsSphere(Tc)===!1)return;k0.copy(s).invert(),Oa.copy(e.ray).applyMatrix4(k0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=h.getX(y),v=h.getX(y+1),T=Ac(this,e,Oa,l,m,v,y);T&&t.push(T)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(f),m=Ac(this,e,Oa,l,y,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,p=g-1;y<p;y+=c){let m=Ac(this,e,Oa,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Ac(this,e,Oa,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ac(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(qc.fromBufferAttribute(a,s),Yc.fromBufferAttribute(a,r),t.distanceSqToSegment(qc,Yc,rf,B0)>n)return;rf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(rf);if(!(c<e.near||c>e.far))return{distance:c,point:B0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Ya=class extends Zc{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Za=class extends ri{constructor(e=[],t=zr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ks=class extends ri{constructor(e,t,n=Yi,s,r,o,a=yn,l=yn,c,h=Os,u=1){if(h!==Os&&h!==zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ka=class extends ks{constructor(e,t=Yi,n=zr,s,r,o=yn,a=yn,l,c=Os){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ja=class extends ri{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Vo=class i extends Mi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new yi(c,3)),this.setAttribute("normal",new yi(h,3)),this.setAttribute("uv",new yi(u,2));function g(y,p,m,v,T,S,R,C,_,A,z){let O=S/_,D=R/A,G=S/2,H=R/2,N=C/2,W=_+1,$=A+1,B=0,oe=0,K=new q;for(let Q=0;Q<$;Q++){let ie=Q*D-H;for(let de=0;de<W;de++){let fe=de*O-G;K[y]=fe*v,K[p]=ie*T,K[m]=N,c.push(K.x,K.y,K.z),K[y]=0,K[p]=0,K[m]=C>0?1:-1,h.push(K.x,K.y,K.z),u.push(de/_),u.push(1-Q/A),B+=1}}for(let Q=0;Q<A;Q++)for(let ie=0;ie<_;ie++){let de=d+ie+W*Q,fe=d+ie+W*(Q+1),ee=d+(ie+1)+W*(Q+1),xe=d+(ie+1)+W*Q;l.push(de,fe,xe),l.push(fe,ee,xe),oe+=6}a.addGroup(f,oe,z),f+=oe,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Fr=class i extends Mi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],y=[],p=[];for(let m=0;m<h;m++){let v=m*d-o;for(let T=0;T<c;T++){let S=T*u-r;g.push(S,-v,0),y.push(0,0,1),p.push(T/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let T=v+c*m,S=v+c*(m+1),R=v+1+c*(m+1),C=v+1+c*m;f.push(T,S,C),f.push(S,R,C)}this.setIndex(f),this.setAttribute("position",new yi(g,3)),this.setAttribute("normal",new yi(y,3)),this.setAttribute("uv",new yi(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Hr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(z0(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(z0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Xn(i){let e={};for(let t=0;t<i.length;t++){let n=Hr(i[t]);for(let s in n)e[s]=n[s]}return e}function z0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function HS(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Wf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var Dx={clone:Hr,merge:Xn},GS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,WS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ds=class extends Fs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=GS,this.fragmentShader=WS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hr(e.uniforms),this.uniformsGroups=HS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new ct().setHex(s.value);break;case"v2":this.uniforms[n].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().fromArray(s.value);break;case"v4":this.uniforms[n].value=new jt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new it().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Yt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Kc=class extends ds{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ho=class extends Fs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=jh,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Us,this.combine=uh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},jc=class extends Fs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Jc=class extends Fs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ro(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Cc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var lr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Qc=class extends lr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:lf,endingEnd:lf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case cf:r=e,a=2*t-n;break;case hf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case cf:o=e,l=2*n-t;break;case hf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,p=y*g,m=-d*p+2*d*y-d*g,v=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,T=(-1-f)*p+(1.5+f)*y+.5*g,S=f*p-f*y;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+v*o[c+R]+T*o[l+R]+S*o[u+R];return r}},eh=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},th=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},nh=class extends lr{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=f*d+g*2,v=u[m],T=u[m+1],S=e*d+g*2,R=h[S],C=h[S+1],_=XS(n,t,v,R,s);r[g]=Nx(_,y,T,C,p)}return r}};function Nx(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function $S(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function XS(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Nx(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=$S(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ro(t,this.TimeBufferType),this.values=Ro(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ro(e.times,Array),values:Ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Cc(e.settings)&&(n.settings={inTangents:Ro(e.settings.inTangents,Array),outTangents:Ro(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new th(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new eh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new nh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ba:t=this.InterpolantFactoryMethodDiscrete;break;case Hc:t=this.InterpolantFactoryMethodLinear;break;case Lc:t=this.InterpolantFactoryMethodSmooth;break;case af:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ba;case this.InterpolantFactoryMethodLinear:return Hc;case this.InterpolantFactoryMethodSmooth:return Lc;case this.InterpolantFactoryMethodBezier:return af}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Cc(this.settings)&&(V0(this.settings.inTangents,e),V0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Cc(this.settings)&&(H0(this.settings.inTangents,e),H0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&lS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Lc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Cc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function V0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function H0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Hc;var cr=class extends Si{constructor(e,t,n){super(e,t,n)}};cr.prototype.ValueTypeName="bool";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Ba;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var ih=class extends Si{constructor(e,t,n,s){super(e,t,n,s)}};ih.prototype.ValueTypeName="color";var sh=class extends Si{constructor(e,t,n,s){super(e,t,n,s)}};sh.prototype.ValueTypeName="number";var rh=class extends lr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)vi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends Si{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new rh(this.times,this.values,this.getValueSize(),e)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var hr=class extends Si{constructor(e,t,n){super(e,t,n)}};hr.prototype.ValueTypeName="string";hr.prototype.ValueBufferType=Array;hr.prototype.DefaultInterpolation=Ba;hr.prototype.InterpolantFactoryMethodLinear=void 0;hr.prototype.InterpolantFactoryMethodSmooth=void 0;var oh=class extends Si{constructor(e,t,n,s){super(e,t,n,s)}};oh.prototype.ValueTypeName="vector";var ah=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ox=new ah,lh=class{constructor(e){this.manager=e!==void 0?e:Ox,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};lh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Qa=class extends $n{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var of=new Yt,G0=new q,W0=new q,ch=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=li,this.map=null,this.mapPass=null,this.matrix=new Yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ar,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;G0.setFromMatrixPosition(e.matrixWorld),t.position.copy(G0),W0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(W0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){of.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(of,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===No||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(of)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Rc=new q,Pc=new vi,hs=new q,el=class extends $n{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Yt,this.projectionMatrix=new Yt,this.projectionMatrixInverse=new Yt,this.coordinateSystem=Oi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Rc,Pc,hs),hs.x===1&&hs.y===1&&hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rc,Pc,hs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Rc,Pc,hs),hs.x===1&&hs.y===1&&hs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Rc,Pc,hs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},sr=new q,$0=new tt,X0=new tt,ti=class extends el{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Uo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Fa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Uo*2*Math.atan(Math.tan(Fa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){sr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(sr.x,sr.y).multiplyScalar(-e/sr.z),sr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(sr.x,sr.y).multiplyScalar(-e/sr.z)}getViewSize(e,t){return this.getViewBounds(e,$0,X0),t.subVectors(X0,$0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Fa*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var tl=class extends el{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},uf=class extends ch{constructor(){super(new tl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},nl=class extends Qa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($n.DEFAULT_UP),this.updateMatrix(),this.target=new $n,this.shadow=new uf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},il=class extends Qa{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var Po=-90,Lo=1,Go=class extends $n{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ti(Po,Lo,e,t);s.layers=this.layers,this.add(s);let r=new ti(Po,Lo,e,t);r.layers=this.layers,this.add(r);let o=new ti(Po,Lo,e,t);o.layers=this.layers,this.add(o);let a=new ti(Po,Lo,e,t);a.layers=this.layers,this.add(a);let l=new ti(Po,Lo,e,t);l.layers=this.layers,this.add(l);let c=new ti(Po,Lo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Oi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===No)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},hh=class extends ti{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var $f="\\[\\]\\.:\\/",qS=new RegExp("["+$f+"]","g"),Xf="[^"+$f+"]",YS="[^"+$f.replace("\\.","")+"]",ZS=/((?:WC+[\/:])*)/.source.replace("WC",Xf),KS=/(WCOD+)?/.source.replace("WCOD",YS),jS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Xf),JS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Xf),QS=new RegExp("^"+ZS+KS+jS+JS+"$"),ew=["material","materials","bones","map"],df=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(qS,"")}static parseTrackName(e){let t=QS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ew.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=df;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var M3=new Float32Array(1);var Wo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=_t(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(_t(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ff=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var sl=class extends qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function qf(i,e,t,n){let s=tw(n);switch(t){case If:return i*e;case Nf:return i*e/s.components*s.byteLength;case _h:return i*e/s.components*s.byteLength;case pr:return i*e*2/s.components*s.byteLength;case yh:return i*e*2/s.components*s.byteLength;case Df:return i*e*3/s.components*s.byteLength;case wi:return i*e*4/s.components*s.byteLength;case vh:return i*e*4/s.components*s.byteLength;case al:case ll:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case cl:case hl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Mh:case wh:return Math.max(i,16)*Math.max(e,8)/4;case bh:case Sh:return Math.max(i,8)*Math.max(e,8)/2;case Eh:case Th:case Ch:case Rh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ah:case ul:case Ph:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ih:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Dh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Nh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Oh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Uh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Fh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case kh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Bh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case zh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Vh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Hh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Gh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Wh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case $h:case Xh:case qh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Yh:case Zh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case dl:case Kh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function tw(i){switch(i){case li:case Cf:return{byteLength:1,components:1};case Yo:case Rf:case Ki:return{byteLength:2,components:1};case gh:case xh:return{byteLength:2,components:4};case Yi:case mh:case Zi:return{byteLength:4,components:1};case Pf:case Lf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function i_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function iw(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,ow=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,aw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,uw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,fw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,xw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,_w=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,yw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,vw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,bw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Mw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Sw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ww=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ew=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Tw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Aw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Cw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Rw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Pw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Lw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Iw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Dw="gl_FragColor = linearToOutputTexel( gl_FragColor );",Nw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ow=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Uw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Fw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,kw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Bw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,zw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Vw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Hw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Gw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ww=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,$w=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Xw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Yw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Zw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Kw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,jw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Jw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Qw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,e1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,t1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,n1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,i1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,s1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,r1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,o1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,a1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,l1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,c1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,h1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,u1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,d1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,f1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,p1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,m1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,g1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,x1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,_1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,y1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,v1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,b1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,M1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,S1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,w1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,E1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,T1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,A1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,C1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,R1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,P1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,L1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,I1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,D1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,N1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,O1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,U1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,F1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,k1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,B1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,z1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,V1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,H1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,G1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,W1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,$1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,X1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,q1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Y1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Z1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,K1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,j1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,J1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Q1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,eE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,tE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,nE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,iE=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sE=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oE=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,hE=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,uE=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,dE=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,fE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mE=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,gE=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,xE=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,_E=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yE=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vE=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bE=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,ME=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SE=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,wE=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,EE=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TE=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,AE=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,CE=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,RE=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,PE=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,LE=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,IE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DE=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,NE=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,OE=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,UE=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,dt={alphahash_fragment:sw,alphahash_pars_fragment:rw,alphamap_fragment:ow,alphamap_pars_fragment:aw,alphatest_fragment:lw,alphatest_pars_fragment:cw,aomap_fragment:hw,aomap_pars_fragment:uw,batching_pars_vertex:dw,batching_vertex:fw,begin_vertex:pw,beginnormal_vertex:mw,bsdfs:gw,iridescence_fragment:xw,bumpmap_pars_fragment:_w,clipping_planes_fragment:yw,clipping_planes_pars_fragment:vw,clipping_planes_pars_vertex:bw,clipping_planes_vertex:Mw,color_fragment:Sw,color_pars_fragment:ww,color_pars_vertex:Ew,color_vertex:Tw,common:Aw,defaultnormal_vertex:Cw,displacementmap_pars_vertex:Rw,displacementmap_vertex:Pw,emissivemap_fragment:Lw,emissivemap_pars_fragment:Iw,colorspace_fragment:Dw,colorspace_pars_fragment:Nw,envmap_fragment:Ow,envmap_common_pars_fragment:Uw,envmap_pars_fragment:Fw,envmap_pars_vertex:kw,envmap_physical_pars_fragment:Zw,envmap_vertex:Bw,fog_vertex:zw,fog_pars_vertex:Vw,fog_fragment:Hw,fog_pars_fragment:Gw,gradientmap_pars_fragment:Ww,lightmap_pars_fragment:$w,lights_lambert_fragment:Xw,lights_lambert_pars_fragment:qw,lights_pars_begin:Yw,lights_toon_fragment:Kw,lights_toon_pars_fragment:jw,lights_phong_fragment:Jw,lights_phong_pars_fragment:Qw,lights_physical_fragment:e1,lights_physical_pars_fragment:t1,lights_fragment_begin:n1,lights_fragment_maps:i1,lights_fragment_end:s1,lightprobes_pars_fragment:r1,logdepthbuf_fragment:o1,logdepthbuf_pars_fragment:a1,logdepthbuf_pars_vertex:l1,logdepthbuf_vertex:c1,map_fragment:h1,map_pars_fragment:u1,map_particle_fragment:d1,map_particle_pars_fragment:f1,metalnessmap_fragment:p1,metalnessmap_pars_fragment:m1,morphinstance_vertex:g1,morphcolor_vertex:x1,morphnormal_vertex:_1,morphtarget_pars_vertex:y1,morphtarget_vertex:v1,normal_fragment_begin:b1,normal_fragment_maps:M1,normal_pars_fragment:S1,normal_pars_vertex:w1,normal_vertex:E1,normalmap_pars_fragment:T1,clearcoat_normal_fragment_begin:A1,clearcoat_normal_fragment_maps:C1,clearcoat_pars_fragment:R1,iridescence_pars_fragment:P1,opaque_fragment:L1,packing:I1,premultiplied_alpha_fragment:D1,project_vertex:N1,dithering_fragment:O1,dithering_pars_fragment:U1,roughnessmap_fragment:F1,roughnessmap_pars_fragment:k1,shadowmap_pars_fragment:B1,shadowmap_pars_vertex:z1,shadowmap_vertex:V1,shadowmask_pars_fragment:H1,skinbase_vertex:G1,skinning_pars_vertex:W1,skinning_vertex:$1,skinnormal_vertex:X1,specularmap_fragment:q1,specularmap_pars_fragment:Y1,tonemapping_fragment:Z1,tonemapping_pars_fragment:K1,transmission_fragment:j1,transmission_pars_fragment:J1,uv_pars_fragment:Q1,uv_pars_vertex:eE,uv_vertex:tE,worldpos_vertex:nE,background_vert:iE,background_frag:sE,backgroundCube_vert:rE,backgroundCube_frag:oE,cube_vert:aE,cube_frag:lE,depth_vert:cE,depth_frag:hE,distance_vert:uE,distance_frag:dE,equirect_vert:fE,equirect_frag:pE,linedashed_vert:mE,linedashed_frag:gE,meshbasic_vert:xE,meshbasic_frag:_E,meshlambert_vert:yE,meshlambert_frag:vE,meshmatcap_vert:bE,meshmatcap_frag:ME,meshnormal_vert:SE,meshnormal_frag:wE,meshphong_vert:EE,meshphong_frag:TE,meshphysical_vert:AE,meshphysical_frag:CE,meshtoon_vert:RE,meshtoon_frag:PE,points_vert:LE,points_frag:IE,shadow_vert:DE,shadow_frag:NE,sprite_vert:OE,sprite_frag:UE},Ne={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},ms={basic:{uniforms:Xn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:Xn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:Xn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:Xn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:Xn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:Xn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:Xn([Ne.points,Ne.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:Xn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:Xn([Ne.common,Ne.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:Xn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:Xn([Ne.sprite,Ne.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:Xn([Ne.common,Ne.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:Xn([Ne.lights,Ne.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};ms.physical={uniforms:Xn([ms.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var Jh={r:0,b:0,g:0},FE=new Yt,s_=new it;s_.set(-1,0,0,0,1,0,0,0,1);function kE(i,e,t,n,s,r){let o=new ct(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function g(v){let T=!1,S=f(v);S===null?p(o,a):S&&S.isColor&&(p(S,1),T=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,T){let S=f(T);S&&S.isCubeTexture?(c===void 0&&(c=new oi(new Vo(1,1,1),new ds({name:"BackgroundCubeMaterial",uniforms:Hr(ms.backgroundCube.uniforms),vertexShader:ms.backgroundCube.vertexShader,fragmentShader:ms.backgroundCube.fragmentShader,side:ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,C,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(FE.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(s_),c.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,(h!==S||u!==S.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new oi(new Fr(2,2),new ds({name:"BackgroundMaterial",uniforms:Hr(ms.background.uniforms),vertexShader:ms.background.vertexShader,fragmentShader:ms.background.fragmentShader,side:fr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,T){v.getRGB(Jh,Wf(i)),t.buffers.color.setClear(Jh.r,Jh.g,Jh.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:y,dispose:m}}function BE(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,G,H,N,W){let $=!1,B=u(D,N,H,G);r!==B&&(r=B,c(r.object)),$=f(D,N,H,W),$&&g(D,N,H,W),W!==null&&e.update(W,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(D,G,H,N),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,G,H,N){let W=N.wireframe===!0,$=n[G.id];$===void 0&&($={},n[G.id]=$);let B=D.isInstancedMesh===!0?D.id:0,oe=$[B];oe===void 0&&(oe={},$[B]=oe);let K=oe[H.id];K===void 0&&(K={},oe[H.id]=K);let Q=K[W];return Q===void 0&&(Q=d(l()),K[W]=Q),Q}function d(D){let G=[],H=[],N=[];for(let W=0;W<t;W++)G[W]=0,H[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,G,H,N){let W=r.attributes,$=G.attributes,B=0,oe=H.getAttributes();for(let K in oe)if(oe[K].location>=0){let ie=W[K],de=$[K];if(de===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;B++}return r.attributesNum!==B||r.index!==N}function g(D,G,H,N){let W={},$=G.attributes,B=0,oe=H.getAttributes();for(let K in oe)if(oe[K].location>=0){let ie=$[K];ie===void 0&&(K==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),K==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[K]=de,B++}r.attributes=W,r.attributesNum=B,r.index=N}function y(){let D=r.newAttributes;for(let G=0,H=D.length;G<H;G++)D[G]=0}function p(D){m(D,0)}function m(D,G){let H=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;H[D]=1,N[D]===0&&(i.enableVertexAttribArray(D),N[D]=1),W[D]!==G&&(i.vertexAttribDivisor(D,G),W[D]=G)}function v(){let D=r.newAttributes,G=r.enabledAttributes;for(let H=0,N=G.length;H<N;H++)G[H]!==D[H]&&(i.disableVertexAttribArray(H),G[H]=0)}function T(D,G,H,N,W,$,B){B===!0?i.vertexAttribIPointer(D,G,H,W,$):i.vertexAttribPointer(D,G,H,N,W,$)}function S(D,G,H,N){y();let W=N.attributes,$=H.getAttributes(),B=G.defaultAttributeValues;for(let oe in $){let K=$[oe];if(K.location>=0){let Q=W[oe];if(Q===void 0&&(oe==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),oe==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,xe=fe.type,ve=fe.bytesPerElement,Re=xe===i.INT||xe===i.UNSIGNED_INT||Q.gpuType===mh;if(Q.isInterleavedBufferAttribute){let we=Q.data,$e=we.isInterleavedBuffer===!0?we.stride:we.itemSize,ot=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Ge=0;Ge<K.locationSize;Ge++)m(K.location+Ge,we.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Ge=0;Ge<K.locationSize;Ge++)p(K.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ge=0;Ge<K.locationSize;Ge++)T(K.location+Ge,de/K.locationSize,xe,ie,$e*ve,(ot+de/K.locationSize*Ge)*ve,Re)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<K.locationSize;we++)m(K.location+we,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<K.locationSize;we++)p(K.location+we);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let we=0;we<K.locationSize;we++)T(K.location+we,de/K.locationSize,xe,ie,de*ve,de/K.locationSize*we*ve,Re)}}else if(B!==void 0){let ie=B[oe];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(K.location,ie);break;case 3:i.vertexAttrib3fv(K.location,ie);break;case 4:i.vertexAttrib4fv(K.location,ie);break;default:i.vertexAttrib1fv(K.location,ie)}}}}v()}function R(){z();for(let D in n){let G=n[D];for(let H in G){let N=G[H];for(let W in N){let $=N[W];for(let B in $)h($[B].object),delete $[B];delete N[W]}}delete n[D]}}function C(D){if(n[D.id]===void 0)return;let G=n[D.id];for(let H in G){let N=G[H];for(let W in N){let $=N[W];for(let B in $)h($[B].object),delete $[B];delete N[W]}}delete n[D.id]}function _(D){for(let G in n){let H=n[G];for(let N in H){let W=H[N];if(W[D.id]===void 0)continue;let $=W[D.id];for(let B in $)h($[B].object),delete $[B];delete W[D.id]}}}function A(D){for(let G in n){let H=n[G],N=D.isInstancedMesh===!0?D.id:0,W=H[N];if(W!==void 0){for(let $ in W){let B=W[$];for(let oe in B)h(B[oe].object),delete B[oe];delete W[$]}delete H[N],Object.keys(H).length===0&&delete n[G]}}}function z(){O(),o=!0,r!==s&&(r=s,c(r.object))}function O(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:z,resetDefaultState:O,dispose:R,releaseStatesOfGeometry:C,releaseStatesOfObject:A,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function zE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function VE(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==wi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let A=_===Ki&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==li&&_!==Zi&&!A&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),C=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:R,samples:C}}function HE(i){let e=this,t=null,n=0,s=!1,r=!1,o=new ei,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,T=v*4,S=m.clippingState||null;l.value=S,S=h(g,d,T,f);for(let R=0;R!==T;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let T=0,S=f;T!==y;++T,S+=4)o.copy(u[T]).applyMatrix4(v,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var ml=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Za(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Vo(5,5,5),r=new ds({name:"CubemapFromEquirect",uniforms:Hr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ii,blending:kr});r.uniforms.tEquirect.value=t;let o=new oi(s,r),a=t.minFilter;return t.minFilter===Bs&&(t.minFilter=ni),new Go(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Ux=256,GE=3,WE=20,r_=256,o_=16,$E=3,XE=new q,qE=new ct,eu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Go(1,10,null),this._boxMesh=new oi(new Vo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=XE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(qE));let p=new Go(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Bx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=kx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ux,Vf(e))}_fromTexture(e,t){e.mapping===zr||e.mapping===qo?this._setSize(e.image.length===0?Ux:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Fx(e,!1,!1),n=Math.log2(e)-GE;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Fx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===zr||e.mapping===qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Bx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=kx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=YE(),this._integrationMaterial=ZE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/o_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-$E)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(r_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=KE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Fx(i,e,t){return new ml(i,{minFilter:Bs,generateMipmaps:e,type:Ki,colorSpace:za,depthBuffer:t})}function gl(i,e,t){return new ds({name:i,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:ii,blending:kr,depthTest:!1,depthWrite:!1})}function YE(){return gl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${r_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ZE(){return gl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:o_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function KE(){return gl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${WE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function kx(){return gl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Bx(){return gl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function jE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===dh||f===fh)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new ml(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===dh||f===fh,y=f===zr||f===qo;if(g||y){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new eu(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new eu(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===dh?d.mapping=zr:f===fh&&(d.mapping=qo),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function JE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ua("WebGLRenderer: "+n+" extension not supported."),s}}}function QE(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,T=p.count>=65535?qa:Xa,S=new T(Math.ceil(v/3)*6,1),R=S.array;if(y!==null){let _=y.array;m=y.version;for(let A=0,z=0;A<v;A+=3){let O=_[A+0],D=_[A+1],G=_[A+2];R[z++]=O,R[z++]=D,R[z++]=D,R[z++]=G,R[z++]=G,R[z++]=O}}else{m=p.version;for(let _=0,A=0;_<v;_+=3){let z=_+0,O=_+1,D=_+2;R[A++]=z,R[A++]=O,R[A++]=O,R[A++]=D,R[A++]=D,R[A++]=z}}S.version=m;let C=r.get(g);C&&e.remove(C),r.set(g,S)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function eT(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function tT(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function nT(i,e,t){let n=new WeakMap,s=new jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let z=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",z)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;f===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let S=a.attributes.position.count*T,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*R*4*u),_=new Ga(C,S,R,u);_.type=Zi,_.needsUpdate=!0;let A=T*4;for(let O=0;O<u;O++){let D=p[O],G=m[O],H=v[O],N=S*R*4*O;for(let W=0;W<D.count;W++){let $=W*A;f===!0&&(s.fromBufferAttribute(D,W),C[N+$+0]=s.x,C[N+$+1]=s.y,C[N+$+2]=s.z,C[N+$+3]=0),g===!0&&(s.fromBufferAttribute(G,W),C[N+$+4]=s.x,C[N+$+5]=s.y,C[N+$+6]=s.z,C[N+$+7]=0),y===!0&&(s.fromBufferAttribute(H,W),C[N+$+8]=s.x,C[N+$+9]=s.y,C[N+$+10]=s.z,C[N+$+11]=H.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new tt(S,R)},n.set(a,d),a.addEventListener("dispose",z)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function iT(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var sT={[vf]:"LINEAR_TONE_MAPPING",[bf]:"REINHARD_TONE_MAPPING",[Mf]:"CINEON_TONE_MAPPING",[Sf]:"ACES_FILMIC_TONE_MAPPING",[Ef]:"AGX_TONE_MAPPING",[Tf]:"NEUTRAL_TONE_MAPPING",[wf]:"CUSTOM_TONE_MAPPING"};function rT(i,e,t,n,s,r){let o=new bi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Mi;h.setAttribute("position",new yi([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new yi([0,2,0,0,2,0],2));let u=new Kc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new oi(h,u),f=new tl(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,v=null,T=[],S=!1;this.setSize=function(R,C){o.setSize(R,C),a!==null&&a.setSize(R,C),l!==null&&l.setSize(R,C);for(let _=0;_<T.length;_++){let A=T[_];A.setSize&&A.setSize(R,C)}},this.setEffects=function(R){T=R,S=T.length>0&&T[0].isRenderPass===!0;let C=o.width,_=o.height;T.length>0&&a===null&&(a=new bi(C,_,{type:Ki,depthBuffer:!1,stencilBuffer:!1}),l=new bi(C,_,{type:Ki,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&T.some(z=>z.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new ks(C,_),r===!0&&(c.format=zs,c.type=Vr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let z=0;z<T.length;z++){let O=T[z];O.setSize&&O.setSize(C,_),A&&O.needsDepthTexture===!0&&O.setDepthTexture&&O.setDepthTexture(c)}},this.begin=function(R,C){if(p||R.toneMapping===fs&&T.length===0)return!1;if(v=C,C!==null){let _=C.width,A=C.height;(o.width!==_||o.height!==A)&&this.setSize(_,A)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=fs,!0},this.hasRenderPass=function(){return S},this.end=function(R,C){R.toneMapping=m,p=!0;let _=o,A=a;for(let z=0;z<T.length;z++){let O=T[z];O.enabled!==!1&&(O.render(R,A,_,C),O.needsSwap!==!1&&(_=A,A=A===a?l:a))}if(g!==R.outputColorSpace||y!==R.toneMapping){g=R.outputColorSpace,y=R.toneMapping,u.defines={},Mt.getTransfer(g)===It&&(u.defines.SRGB_TRANSFER="");let z=sT[y];z&&(u.defines[z]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(v),R.render(d,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var a_=new ri,l_=new ks(1,1),c_=new Ka(1),h_=new Ga,u_=new $c,d_=new Za,zx=[],Vx=[],Hx=new Float32Array(16),Gx=new Float32Array(9),Wx=new Float32Array(4);function jo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=zx[s];if(r===void 0&&(r=new Float32Array(s),zx[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function En(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function nu(i,e){let t=Vx[e];t===void 0&&(t=new Int32Array(e),Vx[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function oT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function aT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2fv(this.addr,e),Tn(t,e)}}function lT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(En(t,e))return;i.uniform3fv(this.addr,e),Tn(t,e)}}function cT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4fv(this.addr,e),Tn(t,e)}}function hT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;Wx.set(n),i.uniformMatrix2fv(this.addr,!1,Wx),Tn(t,n)}}function uT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;Gx.set(n),i.uniformMatrix3fv(this.addr,!1,Gx),Tn(t,n)}}function dT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Tn(t,e)}else{if(En(t,n))return;Hx.set(n),i.uniformMatrix4fv(this.addr,!1,Hx),Tn(t,n)}}function fT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function pT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2iv(this.addr,e),Tn(t,e)}}function mT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3iv(this.addr,e),Tn(t,e)}}function gT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4iv(this.addr,e),Tn(t,e)}}function xT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function _T(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2uiv(this.addr,e),Tn(t,e)}}function yT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3uiv(this.addr,e),Tn(t,e)}}function vT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4uiv(this.addr,e),Tn(t,e)}}function iu(i){return i.version===0&&(i.compareFunction=Ff,i.needsUpdate=!0),i}function bT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=iu(l_):r=a_,t.setTexture2D(e||r,s)}function MT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||u_,s)}function ST(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=iu(c_):r=d_,t.setTextureCube(e||r,s)}function wT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||h_,s)}function ET(i){switch(i){case 5126:return oT;case 35664:return aT;case 35665:return lT;case 35666:return cT;case 35674:return hT;case 35675:return uT;case 35676:return dT;case 5124:case 35670:return fT;case 35667:case 35671:return pT;case 35668:case 35672:return mT;case 35669:case 35673:return gT;case 5125:return xT;case 36294:return _T;case 36295:return yT;case 36296:return vT;case 35678:case 36198:case 36298:case 36306:case 35682:return bT;case 35679:case 36299:case 36307:return MT;case 35680:case 36300:case 36308:case 36293:return ST;case 36289:case 36303:case 36311:case 36292:return wT}}function TT(i,e){i.uniform1fv(this.addr,e)}function AT(i,e){let t=jo(e,this.size,2);i.uniform2fv(this.addr,t)}function CT(i,e){let t=jo(e,this.size,3);i.uniform3fv(this.addr,t)}function RT(i,e){let t=jo(e,this.size,4);i.uniform4fv(this.addr,t)}function PT(i,e){let t=jo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function LT(i,e){let t=jo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function IT(i,e){let t=jo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function DT(i,e){i.uniform1iv(this.addr,e)}function NT(i,e){i.uniform2iv(this.addr,e)}function OT(i,e){i.uniform3iv(this.addr,e)}function UT(i,e){i.uniform4iv(this.addr,e)}function FT(i,e){i.uniform1uiv(this.addr,e)}function kT(i,e){i.uniform2uiv(this.addr,e)}function BT(i,e){i.uniform3uiv(this.addr,e)}function zT(i,e){i.uniform4uiv(this.addr,e)}function VT(i,e,t){let n=this.cache,s=e.length,r=nu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=iu(l_):o=a_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function HT(i,e,t){let n=this.cache,s=e.length,r=nu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||u_,r[o])}function GT(i,e,t){let n=this.cache,s=e.length,r=nu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=iu(c_):o=d_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function WT(i,e,t){let n=this.cache,s=e.length,r=nu(t,s);En(n,r)||(i.uniform1iv(this.addr,r),Tn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||h_,r[o])}function $T(i){switch(i){case 5126:return TT;case 35664:return AT;case 35665:return CT;case 35666:return RT;case 35674:return PT;case 35675:return LT;case 35676:return IT;case 5124:case 35670:return DT;case 35667:case 35671:return NT;case 35668:case 35672:return OT;case 35669:case 35673:return UT;case 5125:return FT;case 36294:return kT;case 36295:return BT;case 36296:return zT;case 35678:case 36198:case 36298:case 36306:case 35682:return VT;case 35679:case 36299:case 36307:return HT;case 35680:case 36300:case 36308:case 36293:return GT;case 36289:case 36303:case 36311:case 36292:return WT}}var Kf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=ET(t.type)}},jf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=$T(t.type)}},Jf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Yf=/(\w+)(\])?(\[|\.)?/g;function $x(i,e){i.seq.push(e),i.map[e.id]=e}function XT(i,e,t){let n=i.name,s=n.length;for(Yf.lastIndex=0;;){let r=Yf.exec(n),o=Yf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){$x(t,c===void 0?new Kf(a,i,e):new jf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Jf(a),$x(t,u)),t=u}}}var Ko=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);XT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Xx(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var qT=37297,YT=0;function ZT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var qx=new it;function KT(i){Mt._getMatrix(qx,Mt.workingColorSpace,i);let e=`mat3( ${qx.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(i)){case Va:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Yx(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+ZT(i.getShaderSource(e),a)}else return r}function jT(i,e){let t=KT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var JT={[vf]:"Linear",[bf]:"Reinhard",[Mf]:"Cineon",[Sf]:"ACESFilmic",[Ef]:"AgX",[Tf]:"Neutral",[wf]:"Custom"};function QT(i,e){let t=JT[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Qh=new q;function eA(){Mt.getLuminanceCoefficients(Qh);let i=Qh.x.toFixed(4),e=Qh.y.toFixed(4),t=Qh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function tA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(pl).join(`
`)}function nA(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function iA(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function pl(i){return i!==""}function Zx(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Kx(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var sA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Qf(i){return i.replace(sA,rA)}function rA(i,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Qf(t)}var oA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function jx(i){return i.replace(oA,aA)}function aA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Jx(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var lA={[rl]:"SHADOWMAP_TYPE_PCF",[$o]:"SHADOWMAP_TYPE_VSM"};function cA(i){return lA[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var hA={[qo]:"ENVMAP_MODE_REFRACTION"};function uA(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":hA[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var dA={[uh]:"ENVMAP_BLENDING_MULTIPLY",[px]:"ENVMAP_BLENDING_MIX",[mx]:"ENVMAP_BLENDING_ADD"};function fA(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":dA[i.combine]||"ENVMAP_BLENDING_NONE"}function pA(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=cA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=uA(t),u=fA(t),d=tA(t),f=nA(r),g=s.createProgram(),y,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(pl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(pl).join(`
`),p.length>0&&(p+=`
`)):(y=[Jx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(pl).join(`
`),p=[Jx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fs?"#define TONE_MAPPING":"",t.toneMapping!==fs?dt.tonemapping_pars_fragment:"",t.toneMapping!==fs?QT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,jT("linearToOutputTexel",t.outputColorSpace),eA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(pl).join(`
`)),o=Qf(o),o=Zx(o,t),o=Kx(o,t),a=Qf(a),a=Zx(a,t),a=Kx(a,t),o=jx(o),a=jx(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===kf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===kf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+y+o,T=m+p+a,S=Xx(s,s.VERTEX_SHADER,v),R=Xx(s,s.FRAGMENT_SHADER,T);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(O){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(S)||"",H=s.getShaderInfoLog(R)||"",N=D.trim(),W=G.trim(),$=H.trim(),B=!0,oe=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,S,R);else{let K=Yx(s,S,"vertex"),Q=Yx(s,R,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+O.name+`
Material Type: `+O.type+`

Program Info Log: `+N+`
`+K+`
`+Q)}else N!==""?Ze("WebGLProgram: Program Info Log:",N):(W===""||$==="")&&(oe=!1);oe&&(O.diagnostics={runnable:B,programLog:N,vertexShader:{log:W,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(S),s.deleteShader(R),_=new Ko(s,g),A=iA(s,g)}let _;this.getUniforms=function(){return _===void 0&&C(this),_};let A;this.getAttributes=function(){return A===void 0&&C(this),A};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,qT)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=YT++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var mA=0,ep=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new tp(e),t.set(e,n)),n}},tp=class{constructor(e){this.id=mA++,this.code=e,this.usedTimes=0}};function gA(i){return i===pr||i===ul||i===dl}function xA(i,e,t,n,s,r){let o=new Wa,a=new ep,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,A,z,O,D,G){let H=O.fog,N=D.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?O.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,B=e.get(_.envMap||W,$),oe=d[_.type],K=n.precision;_.precision!==null&&(K=n.getMaxPrecision(_.precision),K!==_.precision&&Ze("WebGLProgram.getParameters:",_.precision,"not supported, using",K,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,xe,ve;if(oe){let Pe=ms[oe];fe=Pe.vertexShader,ee=Pe.fragmentShader}else{fe=_.vertexShader,ee=_.fragmentShader;let Pe=a.getVertexShaderStage(_),lt=a.getFragmentShaderStage(_);a.update(_,Pe,lt),xe=Pe.id,ve=lt.id}let Re=i.getRenderTarget(),we=i.state.buffers.depth.getReversed(),$e=D.isInstancedMesh===!0,ot=D.isBatchedMesh===!0,Ge=!!_.map,ft=!!_.matcap,ht=!!B,st=ht&&B.isPMREMTexture===!0,Zt=!!_.aoMap,Vt=!!_.lightMap,hn=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,Cn=!!_.displacementMap,St=!!_.emissiveMap,vn=!!_.metalnessMap,tn=!!_.roughnessMap,un=_.anisotropy>0,F=_.clearcoat>0,Le=_.diffuseRoughness>0,Ye=_.dispersion>0,at=_.retroreflectivity>0,Ee=_.iridescence>0,kt=_.sheen>0,He=_.transmission>0,qe=un&&!!_.anisotropyMap,P=F&&!!_.clearcoatMap,M=F&&!!_.clearcoatNormalMap,X=F&&!!_.clearcoatRoughnessMap,ue=Le&&!!_.diffuseRoughnessMap,ae=Ee&&!!_.iridescenceMap,ye=Ee&&!!_.iridescenceThicknessMap,be=kt&&!!_.sheenColorMap,te=kt&&!!_.sheenRoughnessMap,se=!!_.specularMap,ge=!!_.specularColorMap,U=!!_.specularIntensityMap,re=He&&!!_.transmissionMap,ne=He&&!!_.thicknessMap,Te=!!_.gradientMap,_e=!!_.alphaMap,Se=_.alphaTest>0,We=!!_.alphaHash,je=!!_.extensions,he=fs;_.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(he=i.toneMapping);let Be=st?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,Je={shaderID:oe,shaderType:_.type,shaderName:_.name,vertexShader:fe,fragmentShader:ee,defines:_.defines,customVertexShaderID:xe,customFragmentShaderID:ve,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:K,batching:ot,batchingColor:ot&&D._colorsTexture!==null,instancing:$e,instancingColor:$e&&D.instanceColor!==null,instancingMorph:$e&&D.morphTexture!==null,outputColorSpace:Re===null?i.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ge,matcap:ft,envMap:ht,envMapMode:ht&&B.mapping,envMapPMREM:st,envMapMaxLod:st?Be.length-1:null,envMapSize:st?Be[0].width:null,aoMap:Zt,lightMap:Vt,bumpMap:hn,normalMap:Ut,displacementMap:Cn,emissiveMap:St,normalMapObjectSpace:Ut&&_.normalMapType===_x,normalMapTangentSpace:Ut&&_.normalMapType===jh,packedNormalMap:Ut&&_.normalMapType===jh&&gA(_.normalMap.format),metalnessMap:vn,roughnessMap:tn,anisotropy:un,anisotropyMap:qe,clearcoat:F,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Le,diffuseRoughnessMap:ue,dispersion:Ye,retroreflection:at,iridescence:Ee,iridescenceMap:ae,iridescenceThicknessMap:ye,sheen:kt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:se,specularColorMap:ge,specularIntensityMap:U,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:_.transparent===!1&&_.blending===Xo&&_.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:We,combine:_.combine,mapUv:Ge&&f(_.map.channel),aoMapUv:Zt&&f(_.aoMap.channel),lightMapUv:Vt&&f(_.lightMap.channel),bumpMapUv:hn&&f(_.bumpMap.channel),normalMapUv:Ut&&f(_.normalMap.channel),displacementMapUv:Cn&&f(_.displacementMap.channel),emissiveMapUv:St&&f(_.emissiveMap.channel),metalnessMapUv:vn&&f(_.metalnessMap.channel),roughnessMapUv:tn&&f(_.roughnessMap.channel),anisotropyMapUv:qe&&f(_.anisotropyMap.channel),clearcoatMapUv:P&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(_.sheenRoughnessMap.channel),specularMapUv:se&&f(_.specularMap.channel),specularColorMapUv:ge&&f(_.specularColorMap.channel),specularIntensityMapUv:U&&f(_.specularIntensityMap.channel),transmissionMapUv:re&&f(_.transmissionMap.channel),thicknessMapUv:ne&&f(_.thicknessMap.channel),alphaMapUv:_e&&f(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ut||un),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Ge||_e),fog:!!H,useFog:_.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:G.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Ge&&_.map.isVideoTexture===!0&&Mt.getTransfer(_.map.colorSpace)===It,decodeVideoTextureEmissive:St&&_.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(_.emissiveMap.colorSpace)===It,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ai,flipSided:_.side===ii,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:je&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&_.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function y(_){let A=[];if(_.shaderID?A.push(_.shaderID):(A.push(_.customVertexShaderID),A.push(_.customFragmentShaderID)),_.defines!==void 0)for(let z in _.defines)A.push(z),A.push(_.defines[z]);return _.isRawShaderMaterial===!1&&(p(A,_),m(A,_),A.push(i.outputColorSpace)),A.push(_.customProgramCacheKey),A.join()}function p(_,A){_.push(A.precision),_.push(A.outputColorSpace),_.push(A.envMapMode),_.push(A.envMapPMREM),_.push(A.envMapMaxLod),_.push(A.envMapSize),_.push(A.mapUv),_.push(A.alphaMapUv),_.push(A.lightMapUv),_.push(A.aoMapUv),_.push(A.bumpMapUv),_.push(A.normalMapUv),_.push(A.displacementMapUv),_.push(A.emissiveMapUv),_.push(A.metalnessMapUv),_.push(A.roughnessMapUv),_.push(A.anisotropyMapUv),_.push(A.clearcoatMapUv),_.push(A.clearcoatNormalMapUv),_.push(A.clearcoatRoughnessMapUv),_.push(A.diffuseRoughnessMapUv),_.push(A.iridescenceMapUv),_.push(A.iridescenceThicknessMapUv),_.push(A.sheenColorMapUv),_.push(A.sheenRoughnessMapUv),_.push(A.specularMapUv),_.push(A.specularColorMapUv),_.push(A.specularIntensityMapUv),_.push(A.transmissionMapUv),_.push(A.thicknessMapUv),_.push(A.combine),_.push(A.fogExp2),_.push(A.sizeAttenuation),_.push(A.morphTargetsCount),_.push(A.numSunLights),_.push(A.numDirLights),_.push(A.numPointLights),_.push(A.numSpotLights),_.push(A.numSpotLightMaps),_.push(A.numHemiLights),_.push(A.numRectAreaLights),_.push(A.numSunLightShadows),_.push(A.numDirLightShadows),_.push(A.numPointLightShadows),_.push(A.numSpotLightShadows),_.push(A.numSpotLightShadowsWithMaps),_.push(A.numLightProbes),_.push(A.numLightProbeGrids),_.push(A.shadowMapType),_.push(A.toneMapping),_.push(A.numClippingPlanes),_.push(A.numClipIntersection),_.push(A.depthPacking)}function m(_,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let A=d[_.type],z;if(A){let O=ms[A];z=Dx.clone(O.uniforms)}else z=_.uniforms;return z}function T(_,A){let z=h.get(A);return z!==void 0?++z.usedTimes:(z=new pA(i,A,_,s),c.push(z),h.set(A,z)),z}function S(_){if(--_.usedTimes===0){let A=c.indexOf(_);c[A]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:C}}function _A(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function yA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Qx(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function e_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,p,m){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=p,v.group=m),e++,v}function l(d,f,g,y,p,m,v){v.reversedDepth===!0&&(p=-p);let T=a(d,f,g,y,p,m);g.transmission>0?n.push(T):g.transparent===!0?s.push(T):t.push(T)}function c(d,f,g,y,p,m){let v=a(d,f,g,y,p,m);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(d,f){t.length>1&&t.sort(d||yA),n.length>1&&n.sort(f||Qx),s.length>1&&s.sort(f||Qx)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function vA(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new e_,i.set(n,[o])):s>=r.length?(o=new e_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function bA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new ct};break;case"SpotLight":t={position:new q,direction:new q,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new q,halfWidth:new q,halfHeight:new q};break}return i[e.id]=t,t}}}function MA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var SA=0;function wA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function EA(i){let e=new bA,t=MA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new q);let s=new q,r=new Yt,o=new Yt;function a(c){let h=0,u=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,v=0,T=0,S=0,R=0,C=0,_=0,A=0,z=0,O=0;c.sort(wA);for(let G=0,H=c.length;G<H;G++){let N=c[G],W=N.color,$=N.intensity,B=N.distance,oe=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===pr?oe=N.shadow.map.texture:oe=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=W.r*$,u+=W.g*$,d+=W.b*$;else if(N.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(N.sh.coefficients[K],$);O++}else if(N.isSunLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=oe;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)n.sunShadowMatrix[y+fe]=Q.getMatrix(fe),n.sunShadowCascade[y+fe]=Q._cascadeData[fe];y+=de,g++}n.sun[f]=K,f++}else if(N.isDirectionalLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[p]=ie,n.directionalShadowMap[p]=oe,n.directionalShadowMatrix[p]=N.shadow.matrix,R++}n.directional[p]=K,p++}else if(N.isSpotLight){let K=e.get(N);K.position.setFromMatrixPosition(N.matrixWorld),K.color.copy(W).multiplyScalar($),K.distance=B,K.coneCos=Math.cos(N.angle),K.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),K.decay=N.decay,n.spot[v]=K;let Q=N.shadow;if(N.map&&(n.spotLightMap[A]=N.map,A++,Q.updateMatrices(N),N.castShadow&&z++),n.spotLightMatrix[v]=Q.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[v]=ie,n.spotShadowMap[v]=oe,_++}v++}else if(N.isRectAreaLight){let K=e.get(N);K.color.copy(W).multiplyScalar($),K.halfWidth.set(N.width*.5,0,0),K.halfHeight.set(0,N.height*.5,0),n.rectArea[T]=K,T++}else if(N.isPointLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),K.distance=N.distance,K.decay=N.decay,N.castShadow){let Q=N.shadow,ie=t.get(N);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=oe,n.pointShadowMatrix[m]=N.shadow.matrix,C++}n.point[m]=K,m++}else if(N.isHemisphereLight){let K=e.get(N);K.skyColor.copy(N.color).multiplyScalar($),K.groundColor.copy(N.groundColor).multiplyScalar($),n.hemi[S]=K,S++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ne.LTC_FLOAT_1,n.rectAreaLTC2=Ne.LTC_FLOAT_2):(n.rectAreaLTC1=Ne.LTC_HALF_1,n.rectAreaLTC2=Ne.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==T||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==C||D.numSpotShadows!==_||D.numSpotMaps!==A||D.numLightProbes!==O)&&(n.sun.length=f,n.directional.length=p,n.spot.length=v,n.rectArea.length=T,n.point.length=m,n.hemi.length=S,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=C,n.pointShadowMap.length=C,n.pointShadowMatrix.length=C,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+A-z,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=O,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=v,D.rectAreaLength=T,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=C,D.numSpotShadows=_,D.numSpotMaps=A,D.numLightProbes=O,n.version=SA++)}function l(c,h){let u=0,d=0,f=0,g=0,y=0,p=0,m=h.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),u++}else if(S.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(S.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let R=n.rectArea[y];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:n}}function t_(i){let e=new EA(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function TA(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new t_(i),e.set(s,[a])):r>=o.length?(a=new t_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var AA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,CA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,RA=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],PA=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],n_=new Yt,fl=new q,Zf=new q;function LA(i,e,t){let n=new ar,s=new tt,r=new tt,o=new jt,a=new jc,l=new Jc,c={},h=t.maxTextureSize,u={[fr]:ii,[ii]:fr,[ai]:ai},d=new ds({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:AA,fragmentShader:CA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Mi;g.setAttribute("position",new Wn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new oi(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=rl;let m=this.type;this.render=function(C,_,A){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||C.length===0)return;this.type===Z0&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=rl);let z=i.getRenderTarget(),O=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),G=i.state;G.setBlending(kr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=m!==this.type;H&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=C.length;N<W;N++){let $=C[N],B=$.shadow;if(B===void 0){Ze("WebGLShadowMap:",$,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let oe=B.getFrameExtents();s.multiply(oe),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/oe.x),s.x=r.x*oe.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/oe.y),s.y=r.y*oe.y,B.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=K,B.map===null||H===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===$o){if($.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new bi(s.x,s.y,{format:pr,type:Ki,minFilter:ni,magFilter:ni,generateMipmaps:!1}),B.map.texture.name=$.name+".shadowMap",B.map.depthTexture=new ks(s.x,s.y,Zi),B.map.depthTexture.name=$.name+".shadowMapDepth",B.map.depthTexture.format=Os,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=yn,B.map.depthTexture.magFilter=yn}else $.isPointLight?(B.map=new ml(s.x),B.map.depthTexture=new Ka(s.x,Yi)):(B.map=new bi(s.x,s.y),B.map.depthTexture=new ks(s.x,s.y,Yi)),B.map.depthTexture.name=$.name+".shadowMap",B.map.depthTexture.format=Os,this.type===rl?(B.map.depthTexture.compareFunction=K?Uf:Of,B.map.depthTexture.minFilter=ni,B.map.depthTexture.magFilter=ni):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=yn,B.map.depthTexture.magFilter=yn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let Q=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();$.isPointLight!==!0&&B.updateMatrices($,A);let ie=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:A.layers;for(let de=0;de<Q;de++){let fe=B.getCamera(de);if($.isPointLight){let ee=B.camera,xe=B.matrix,ve=$.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),fl.setFromMatrixPosition($.matrixWorld),ee.position.copy(fl),Zf.copy(ee.position),Zf.add(RA[de]),ee.up.copy(PA[de]),ee.lookAt(Zf),ee.updateMatrixWorld(),xe.makeTranslation(-fl.x,-fl.y,-fl.z),n_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),B._frustum.setFromProjectionMatrix(n_,ee.coordinateSystem,ee.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,de),i.clear();else{de===0&&(i.setRenderTarget(B.map),i.clear());let ee=B.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),G.viewport(o)}n=B.getFrustum(de),S(_,A,fe,$,ie,this.type)}B.isPointLightShadow!==!0&&this.type===$o&&v(B,A),B.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(z,O,D)};function v(C,_){let A=e.update(y);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new bi(s.x,s.y,{format:pr,type:Ki}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(_,null,A,d,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(_,null,A,f,y,null)}function T(C,_,A,z){let O=null,D=A.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)O=D;else if(O=A.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let G=O.uuid,H=_.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[H];W===void 0&&(W=O.clone(),N[H]=W,_.addEventListener("dispose",R)),O=W}if(O.visible=_.visible,O.wireframe=_.wireframe,z===$o?O.side=_.shadowSide!==null?_.shadowSide:_.side:O.side=_.shadowSide!==null?_.shadowSide:u[_.side],O.alphaMap=_.alphaMap,O.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,O.map=_.map,O.clipShadows=_.clipShadows,O.clippingPlanes=_.clippingPlanes,O.clipIntersection=_.clipIntersection,O.displacementMap=_.displacementMap,O.displacementScale=_.displacementScale,O.displacementBias=_.displacementBias,O.wireframeLinewidth=_.wireframeLinewidth,O.linewidth=_.linewidth,A.isPointLight===!0&&O.isMeshDistanceMaterial===!0){let G=i.properties.get(O);G.light=A}return O}function S(C,_,A,z,O,D){if(C.visible===!1)return;if(C.layers.test(O)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===$o)&&(!C.frustumCulled||C.intersectsFrustum(n))){C.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,C.matrixWorld);let N=e.update(C),W=C.material;if(Array.isArray(W)){let $=N.groups;for(let B=0,oe=$.length;B<oe;B++){let K=$[B],Q=W[K.materialIndex];if(Q&&Q.visible){let ie=T(C,Q,z,D);C.onBeforeShadow(i,C,_,A,N,ie,K),i.renderBufferDirect(A,null,N,ie,C,K),C.onAfterShadow(i,C,_,A,N,ie,K)}}}else if(W.visible){let $=T(C,W,z,D);C.onBeforeShadow(i,C,_,A,N,$,null),i.renderBufferDirect(A,null,N,$,C,null),C.onAfterShadow(i,C,_,A,N,$,null)}}let H=C.children;for(let N=0,W=H.length;N<W;N++)S(H[N],_,A,z,O,D)}function R(C){C.target.removeEventListener("dispose",R);for(let A in c){let z=c[A],O=C.target.uuid;O in z&&(z[O].dispose(),delete z[O])}}}function IA(i,e){function t(){let U=!1,re=new jt,ne=null,Te=new jt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!U&&(i.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){U=_e},setClear:function(_e,Se,We,je,he){he===!0&&(_e*=je,Se*=je,We*=je),re.set(_e,Se,We,je),Te.equals(re)===!1&&(i.clearColor(_e,Se,We,je),Te.copy(re))},reset:function(){U=!1,ne=null,Te.set(-1,0,0,0)}}}function n(){let U=!1,re=!1,ne=null,Te=null,_e=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let je=_e;_e=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(Se){Se?we(i.DEPTH_TEST):$e(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!U&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=Rx[Se]),Te!==Se){switch(Se){case Dc:i.depthFunc(i.NEVER);break;case Nc:i.depthFunc(i.ALWAYS);break;case Oc:i.depthFunc(i.LESS);break;case Do:i.depthFunc(i.LEQUAL);break;case Uc:i.depthFunc(i.EQUAL);break;case Fc:i.depthFunc(i.GEQUAL);break;case kc:i.depthFunc(i.GREATER);break;case Bc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Te=Se}},setLocked:function(Se){U=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),i.clearDepth(Se))},reset:function(){U=!1,ne=null,Te=null,_e=null,re=!1}}}function s(){let U=!1,re=null,ne=null,Te=null,_e=null,Se=null,We=null,je=null,he=null;return{setTest:function(Be){U||(Be?we(i.STENCIL_TEST):$e(i.STENCIL_TEST))},setMask:function(Be){re!==Be&&!U&&(i.stencilMask(Be),re=Be)},setFunc:function(Be,Je,Pe){(ne!==Be||Te!==Je||_e!==Pe)&&(i.stencilFunc(Be,Je,Pe),ne=Be,Te=Je,_e=Pe)},setOp:function(Be,Je,Pe){(Se!==Be||We!==Je||je!==Pe)&&(i.stencilOp(Be,Je,Pe),Se=Be,We=Je,je=Pe)},setLocked:function(Be){U=Be},setClear:function(Be){he!==Be&&(i.clearStencil(Be),he=Be)},reset:function(){U=!1,re=null,ne=null,Te=null,_e=null,Se=null,We=null,je=null,he=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,v=null,T=null,S=null,R=null,C=null,_=null,A=new ct(0,0,0),z=0,O=!1,D=null,G=null,H=null,N=null,W=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,oe=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(oe=parseFloat(/^WebGL (\d)/.exec(K)[1]),B=oe>=1):K.indexOf("OpenGL ES")!==-1&&(oe=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),B=oe>=2);let Q=null,ie={},de=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),ee=new jt().fromArray(de),xe=new jt().fromArray(fe);function ve(U,re,ne,Te){let _e=new Uint8Array(4),Se=i.createTexture();i.bindTexture(U,Se),i.texParameteri(U,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(U,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let We=0;We<ne;We++)U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Te,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(re+We,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Se}let Re={};Re[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Re[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Re[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(i.DEPTH_TEST),o.setFunc(Do),hn(!1),Ut(pf),we(i.CULL_FACE),Zt(kr);function we(U){h[U]!==!0&&(i.enable(U),h[U]=!0)}function $e(U){h[U]!==!1&&(i.disable(U),h[U]=!1)}function ot(U,re){return d[U]!==re?(i.bindFramebuffer(U,re),d[U]=re,U===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=re),U===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Ge(U,re){let ne=g,Te=!1;if(U){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let _e=U.textures;if(ne.length!==_e.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,We=_e.length;Se<We;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Te=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Te=!0);Te&&i.drawBuffers(ne)}function ft(U){return y!==U?(i.useProgram(U),y=U,!0):!1}let ht={[Br]:i.FUNC_ADD,[j0]:i.FUNC_SUBTRACT,[J0]:i.FUNC_REVERSE_SUBTRACT};ht[Q0]=i.MIN,ht[ex]=i.MAX;let st={[tx]:i.ZERO,[nx]:i.ONE,[ix]:i.SRC_COLOR,[_f]:i.SRC_ALPHA,[cx]:i.SRC_ALPHA_SATURATE,[ax]:i.DST_COLOR,[rx]:i.DST_ALPHA,[sx]:i.ONE_MINUS_SRC_COLOR,[yf]:i.ONE_MINUS_SRC_ALPHA,[lx]:i.ONE_MINUS_DST_COLOR,[ox]:i.ONE_MINUS_DST_ALPHA,[hx]:i.CONSTANT_COLOR,[ux]:i.ONE_MINUS_CONSTANT_COLOR,[dx]:i.CONSTANT_ALPHA,[fx]:i.ONE_MINUS_CONSTANT_ALPHA};function Zt(U,re,ne,Te,_e,Se,We,je,he,Be){if(U===kr){p===!0&&($e(i.BLEND),p=!1);return}if(p===!1&&(we(i.BLEND),p=!0),U!==K0){if(U!==m||Be!==O){if((v!==Br||R!==Br)&&(i.blendEquation(i.FUNC_ADD),v=Br,R=Br),Be)switch(U){case Xo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case mf:i.blendFunc(i.ONE,i.ONE);break;case gf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case xf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:et("WebGLState: Invalid blending: ",U);break}else switch(U){case Xo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case mf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case gf:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case xf:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",U);break}T=null,S=null,C=null,_=null,A.set(0,0,0),z=0,m=U,O=Be}return}_e=_e||re,Se=Se||ne,We=We||Te,(re!==v||_e!==R)&&(i.blendEquationSeparate(ht[re],ht[_e]),v=re,R=_e),(ne!==T||Te!==S||Se!==C||We!==_)&&(i.blendFuncSeparate(st[ne],st[Te],st[Se],st[We]),T=ne,S=Te,C=Se,_=We),(je.equals(A)===!1||he!==z)&&(i.blendColor(je.r,je.g,je.b,he),A.copy(je),z=he),m=U,O=!1}function Vt(U,re){U.side===ai?$e(i.CULL_FACE):we(i.CULL_FACE);let ne=U.side===ii;re&&(ne=!ne),hn(ne),U.blending===Xo&&U.transparent===!1?Zt(kr):Zt(U.blending,U.blendEquation,U.blendSrc,U.blendDst,U.blendEquationAlpha,U.blendSrcAlpha,U.blendDstAlpha,U.blendColor,U.blendAlpha,U.premultipliedAlpha),o.setFunc(U.depthFunc),o.setTest(U.depthTest),o.setMask(U.depthWrite),r.setMask(U.colorWrite);let Te=U.stencilWrite;a.setTest(Te),Te&&(a.setMask(U.stencilWriteMask),a.setFunc(U.stencilFunc,U.stencilRef,U.stencilFuncMask),a.setOp(U.stencilFail,U.stencilZFail,U.stencilZPass)),St(U.polygonOffset,U.polygonOffsetFactor,U.polygonOffsetUnits),U.alphaToCoverage===!0?we(i.SAMPLE_ALPHA_TO_COVERAGE):$e(i.SAMPLE_ALPHA_TO_COVERAGE)}function hn(U){D!==U&&(U?i.frontFace(i.CW):i.frontFace(i.CCW),D=U)}function Ut(U){U!==q0?(we(i.CULL_FACE),U!==G&&(U===pf?i.cullFace(i.BACK):U===Y0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$e(i.CULL_FACE),G=U}function Cn(U){U!==H&&(B&&i.lineWidth(U),H=U)}function St(U,re,ne){U?(we(i.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):$e(i.POLYGON_OFFSET_FILL)}function vn(U){U?we(i.SCISSOR_TEST):$e(i.SCISSOR_TEST)}function tn(U){U===void 0&&(U=i.TEXTURE0+$-1),Q!==U&&(i.activeTexture(U),Q=U)}function un(U,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+$-1:ne=Q);let Te=ie[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ie[ne]=Te),(Te.type!==U||Te.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(U,re||Re[U]),Te.type=U,Te.texture=re)}function F(){let U=ie[Q];U!==void 0&&U.type!==void 0&&(i.bindTexture(U.type,null),U.type=void 0,U.texture=void 0)}function Le(){try{i.compressedTexImage2D(...arguments)}catch(U){et("WebGLState:",U)}}function Ye(){try{i.compressedTexImage3D(...arguments)}catch(U){et("WebGLState:",U)}}function at(){try{i.texSubImage2D(...arguments)}catch(U){et("WebGLState:",U)}}function Ee(){try{i.texSubImage3D(...arguments)}catch(U){et("WebGLState:",U)}}function kt(){try{i.compressedTexSubImage2D(...arguments)}catch(U){et("WebGLState:",U)}}function He(){try{i.compressedTexSubImage3D(...arguments)}catch(U){et("WebGLState:",U)}}function qe(){try{i.texStorage2D(...arguments)}catch(U){et("WebGLState:",U)}}function P(){try{i.texStorage3D(...arguments)}catch(U){et("WebGLState:",U)}}function M(){try{i.texImage2D(...arguments)}catch(U){et("WebGLState:",U)}}function X(){try{i.texImage3D(...arguments)}catch(U){et("WebGLState:",U)}}function ue(U){return u[U]!==void 0?u[U]:i.getParameter(U)}function ae(U,re){u[U]!==re&&(i.pixelStorei(U,re),u[U]=re)}function ye(U){ee.equals(U)===!1&&(i.scissor(U.x,U.y,U.z,U.w),ee.copy(U))}function be(U){xe.equals(U)===!1&&(i.viewport(U.x,U.y,U.z,U.w),xe.copy(U))}function te(U,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(U);Te===void 0&&(Te=i.getUniformBlockIndex(re,U.name),i.uniformBlockBinding(re,Te,Te),ne.set(U,Te))}function se(U,re,ne){let _e=c.get(re).get(U);l[_e]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function ge(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,ie={},d={},l={},f=new WeakMap,g=[],y=null,p=!1,m=null,v=null,T=null,S=null,R=null,C=null,_=null,A=new ct(0,0,0),z=0,O=!1,D=null,G=null,H=null,N=null,W=null,ee.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:$e,bindFramebuffer:ot,drawBuffers:Ge,useProgram:ft,setBlending:Zt,setMaterial:Vt,setFlipSided:hn,setCullFace:Ut,setLineWidth:Cn,setPolygonOffset:St,setScissorTest:vn,activeTexture:tn,bindTexture:un,unbindTexture:F,compressedTexImage2D:Le,compressedTexImage3D:Ye,texImage2D:M,texImage3D:X,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:qe,texStorage3D:P,texSubImage2D:at,texSubImage3D:Ee,compressedTexSubImage2D:kt,compressedTexSubImage3D:He,scissor:ye,viewport:be,reset:ge}}function DA(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,M){return p?new OffscreenCanvas(P,M):Ha("canvas")}function v(P,M,X){let ue=1,ae=qe(P);if((ae.width>X||ae.height>X)&&(ue=X/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ye=Math.floor(ue*ae.width),be=Math.floor(ue*ae.height);d===void 0&&(d=m(ye,be));let te=M?m(ye,be):d;return te.width=ye,te.height=be,te.getContext("2d").drawImage(P,0,0,ye,be),Ze("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ye+"x"+be+")."),te}else return"data"in P&&Ze("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),P;return P}function T(P){return P.generateMipmaps}function S(P){i.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function C(P,M,X,ue,ae,ye=!1){if(P!==null){if(i[P]!==void 0)return i[P];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let be;ue&&(be=e.get("EXT_texture_norm16"),be||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===i.RED&&(X===i.FLOAT&&(te=i.R32F),X===i.HALF_FLOAT&&(te=i.R16F),X===i.UNSIGNED_BYTE&&(te=i.R8),X===i.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===i.SHORT&&be&&(te=be.R16_SNORM_EXT)),M===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.R8UI),X===i.UNSIGNED_SHORT&&(te=i.R16UI),X===i.UNSIGNED_INT&&(te=i.R32UI),X===i.BYTE&&(te=i.R8I),X===i.SHORT&&(te=i.R16I),X===i.INT&&(te=i.R32I)),M===i.RG&&(X===i.FLOAT&&(te=i.RG32F),X===i.HALF_FLOAT&&(te=i.RG16F),X===i.UNSIGNED_BYTE&&(te=i.RG8),X===i.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===i.SHORT&&be&&(te=be.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RG8UI),X===i.UNSIGNED_SHORT&&(te=i.RG16UI),X===i.UNSIGNED_INT&&(te=i.RG32UI),X===i.BYTE&&(te=i.RG8I),X===i.SHORT&&(te=i.RG16I),X===i.INT&&(te=i.RG32I)),M===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGB8UI),X===i.UNSIGNED_SHORT&&(te=i.RGB16UI),X===i.UNSIGNED_INT&&(te=i.RGB32UI),X===i.BYTE&&(te=i.RGB8I),X===i.SHORT&&(te=i.RGB16I),X===i.INT&&(te=i.RGB32I)),M===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),X===i.UNSIGNED_INT&&(te=i.RGBA32UI),X===i.BYTE&&(te=i.RGBA8I),X===i.SHORT&&(te=i.RGBA16I),X===i.INT&&(te=i.RGBA32I)),M===i.RGB&&(X===i.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===i.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),M===i.RGBA){let se=ye?Va:Mt.getTransfer(ae);X===i.FLOAT&&(te=i.RGBA32F),X===i.HALF_FLOAT&&(te=i.RGBA16F),X===i.UNSIGNED_BYTE&&(te=se===It?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===i.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(P,M){let X;return P?M===null||M===Yi||M===Vr?X=i.DEPTH24_STENCIL8:M===Zi?X=i.DEPTH32F_STENCIL8:M===Yo&&(X=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Yi||M===Vr?X=i.DEPTH_COMPONENT24:M===Zi?X=i.DEPTH_COMPONENT32F:M===Yo&&(X=i.DEPTH_COMPONENT16),X}function A(P,M){return T(P)===!0||P.isFramebufferTexture&&P.minFilter!==yn&&P.minFilter!==ni?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function z(P){let M=new WeakRef(P);n.get(P).__ref=M,g.add(M),y.register(P,M,M)}function O(P){let M=n.get(P).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function D(P){H(P.target)}function G(P){N(P.target)}function H(P){P.removeEventListener("dispose",D),O(P),$(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function N(P){P.removeEventListener("dispose",G),O(P),oe(P)}function W(){for(let P of g){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):H(M))}g.clear(),u.clear()}function $(P){let M=n.get(P);if(M.__webglInit===void 0)return;let X=P.source,ue=f.get(X);if(ue){let ae=ue[M.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&B(P),Object.keys(ue).length===0&&f.delete(X)}n.remove(P)}function B(P){let M=n.get(P);i.deleteTexture(M.__webglTexture);let X=P.source,ue=f.get(X);delete ue[M.__cacheKey],o.memory.textures--}function oe(P){let M=n.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&H(X),P.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(M.__webglFramebuffer[ae]))for(let ye=0;ye<M.__webglFramebuffer[ae].length;ye++)i.deleteFramebuffer(M.__webglFramebuffer[ae][ye]);else i.deleteFramebuffer(M.__webglFramebuffer[ae]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[ae])}else{if(Array.isArray(M.__webglFramebuffer))for(let ae=0;ae<M.__webglFramebuffer.length;ae++)i.deleteFramebuffer(M.__webglFramebuffer[ae]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ae=0;ae<M.__webglColorRenderbuffer.length;ae++)M.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[ae]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let ae=0,ye=ue.length;ae<ye;ae++){let be=n.get(ue[ae]);be.__webglTexture&&(i.deleteTexture(be.__webglTexture),o.memory.textures--),n.remove(ue[ae])}n.remove(P)}let K=0;function Q(){K=0}function ie(){return K}function de(P){K=P}function fe(){let P=K;return P>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function xe(P,M){let X=n.get(P);if(P.isVideoTexture&&kt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let ue=P.image;if(ue===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(X,P,M);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+M)}function ve(P,M){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Vt(X,P,M);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+M)}function Re(P,M){let X=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Vt(X,P,M);return}t.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+M)}function we(P,M){let X=n.get(P);if(P.version>0&&X.__version!==P.version){hn(X,P,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+M)}let $e={[zc]:i.REPEAT,[us]:i.CLAMP_TO_EDGE,[Vc]:i.MIRRORED_REPEAT},ot={[yn]:i.NEAREST,[gx]:i.NEAREST_MIPMAP_NEAREST,[ol]:i.NEAREST_MIPMAP_LINEAR,[ni]:i.LINEAR,[ph]:i.LINEAR_MIPMAP_NEAREST,[Bs]:i.LINEAR_MIPMAP_LINEAR},Ge={[vx]:i.NEVER,[Ff]:i.ALWAYS,[bx]:i.LESS,[Of]:i.LEQUAL,[Mx]:i.EQUAL,[Uf]:i.GEQUAL,[Sx]:i.GREATER,[wx]:i.NOTEQUAL};function ft(P,M){if(M.type===Zi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===ni||M.magFilter===ph||M.magFilter===ol||M.magFilter===Bs||M.minFilter===ni||M.minFilter===ph||M.minFilter===ol||M.minFilter===Bs)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,$e[M.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,$e[M.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,$e[M.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ot[M.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,Ge[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===yn||M.minFilter!==ol&&M.minFilter!==Bs||M.type===Zi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function ht(P,M){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",D),z(M));let ue=M.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let ye=ee(M);if(ye!==P.__cacheKey){ae[ye]===void 0&&(ae[ye]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ae[ye].usedTimes++;let be=ae[P.__cacheKey];be!==void 0&&(ae[P.__cacheKey].usedTimes--,be.usedTimes===0&&B(M)),P.__cacheKey=ye,P.__webglTexture=ae[ye].texture}return X}function st(P,M,X){return Math.floor(Math.floor(P/X)/M)}function Zt(P,M,X,ue){let ye=P.updateRanges;if(ye.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,X,ue,M.data);else{ye.sort((U,re)=>U.start-re.start);let be=0;for(let U=1;U<ye.length;U++){let re=ye[be],ne=ye[U],Te=re.start+re.count,_e=st(ne.start,M.width,4),Se=st(re.start,M.width,4);ne.start<=Te+1&&_e===Se&&st(ne.start+ne.count-1,M.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,ye[be]=ne)}ye.length=be+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),ge=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let U=0,re=ye.length;U<re;U++){let ne=ye[U],Te=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Te%M.width,We=Math.floor(Te/M.width),je=_e,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,We),t.texSubImage2D(i.TEXTURE_2D,0,Se,We,je,he,X,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,ge)}}function Vt(P,M,X){let ue=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=i.TEXTURE_3D);let ae=ht(P,M),ye=M.source;t.bindTexture(ue,P.__webglTexture,i.TEXTURE0+X);let be=n.get(ye);if(ye.version!==be.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let he=Mt.getPrimaries(Mt.workingColorSpace),Be=M.colorSpace===Vs?null:Mt.getPrimaries(M.colorSpace),Je=M.colorSpace===Vs||he===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let se=v(M.image,!1,s.maxTextureSize);se=He(M,se);let ge=r.convert(M.format,M.colorSpace),U=r.convert(M.type),re=C(M.internalFormat,ge,U,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,Te=M.mipmaps,_e=M.isVideoTexture!==!0,Se=be.__version===void 0||ae===!0,We=ye.dataReady,je=A(M,se);if(M.isDepthTexture)re=_(M.format===zs,M.type),Se&&(_e?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,ge,U,null));else if(M.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(i.TEXTURE_2D,je,re,Te[0].width,Te[0].height);for(let he=0,Be=Te.length;he<Be;he++)ne=Te[he],_e?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,U,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ge,U,ne.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height),We&&Zt(M,se,ge,U)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,ge,U,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,Te[0].width,Te[0].height,se.depth);for(let he=0,Be=Te.length;he<Be;he++)if(ne=Te[he],M.format!==wi)if(ge!==null)if(_e){if(We)if(M.layerUpdates.size>0){let Je=qf(ne.width,ne.height,M.format,M.type);for(let Pe of M.layerUpdates){let lt=ne.data.subarray(Pe*Je/ne.data.BYTES_PER_ELEMENT,(Pe+1)*Je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Pe,ne.width,ne.height,1,ge,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,ge,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?We&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,se.depth,ge,U,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,se.depth,0,ge,U,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(i.TEXTURE_2D,je,re,Te[0].width,Te[0].height);for(let he=0,Be=Te.length;he<Be;he++)ne=Te[he],M.format!==wi?ge!==null?_e?We&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ne.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,U,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ge,U,ne.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,se.width,se.height,se.depth),We)if(M.layerUpdates.size>0){let he=qf(se.width,se.height,M.format,M.type);for(let Be of M.layerUpdates){let Je=se.data.subarray(Be*he/se.data.BYTES_PER_ELEMENT,(Be+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,ge,U,Je)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ge,U,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,ge,U,se.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(i.TEXTURE_3D,je,re,se.width,se.height,se.depth),We&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ge,U,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,ge,U,se.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height);else{let he=se.width,Be=se.height;for(let Je=0;Je<je;Je++)t.texImage2D(i.TEXTURE_2D,Je,re,he,Be,0,ge,U,null),he>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),u.add(M),he.onpaint=Be=>{let Je=Be.changedElements;for(let Pe of u)Je.includes(Pe.image)&&(Pe.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Je=i.RGBA,Pe=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Pe,lt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let he=qe(Te[0]);t.texStorage2D(i.TEXTURE_2D,je,re,he.width,he.height)}for(let he=0,Be=Te.length;he<Be;he++)ne=Te[he],_e?We&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ge,U,ne):t.texImage2D(i.TEXTURE_2D,he,re,ge,U,ne);M.generateMipmaps=!1}else if(_e){if(Se){let he=qe(se);t.texStorage2D(i.TEXTURE_2D,je,re,he.width,he.height)}We&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ge,U,se)}else t.texImage2D(i.TEXTURE_2D,0,re,ge,U,se);T(M)&&M.mipmapsAutoUpdate===!0&&S(ue),be.__version=ye.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function hn(P,M,X){if(M.image.length!==6)return;let ue=ht(P,M),ae=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+X);let ye=n.get(ae);if(ae.version!==ye.__version||ue===!0){t.activeTexture(i.TEXTURE0+X);let be=Mt.getPrimaries(Mt.workingColorSpace),te=M.colorSpace===Vs?null:Mt.getPrimaries(M.colorSpace),se=M.colorSpace===Vs||be===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let ge=M.isCompressedTexture||M.image[0].isCompressedTexture,U=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!ge&&!U?re[Pe]=v(M.image[Pe],!0,s.maxCubemapSize):re[Pe]=U?M.image[Pe].image:M.image[Pe],re[Pe]=He(M,re[Pe]);let ne=re[0],Te=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Se=C(M.internalFormat,Te,_e,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,je=ye.__version===void 0||ue===!0,he=ae.dataReady,Be=A(M,ne);ft(i.TEXTURE_CUBE_MAP,M);let Je;if(M.isDepthTexture){if(Se=_(M.format===zs,M.type),je)if(We)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ne.width,ne.height,0,Te,_e,null)}else if(ge){We&&je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){Je=re[Pe].mipmaps;for(let lt=0;lt<Je.length;lt++){let Ht=Je[lt];M.format!==wi?Te!==null?We?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,Ht.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Ht.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,_e,Ht.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Te,_e,Ht.data)}}}else{if(Je=M.mipmaps,We&&je){Je.length>0&&Be++;let Pe=qe(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(U){We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Te,_e,re[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,re[Pe].width,re[Pe].height,0,Te,_e,re[Pe].data);for(let lt=0;lt<Je.length;lt++){let qn=Je[lt].image[Pe].image;We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,qn.width,qn.height,Te,_e,qn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,qn.width,qn.height,0,Te,_e,qn.data)}}else{We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,_e,re[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,_e,re[Pe]);for(let lt=0;lt<Je.length;lt++){let Ht=Je[lt];We?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Te,_e,Ht.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,Te,_e,Ht.image[Pe])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),ye.__version=ae.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Ut(P,M,X,ue,ae,ye){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),se=C(X.internalFormat,be,te,X.normalized,X.colorSpace),ge=n.get(M),U=n.get(X);if(U.__renderTarget=M,!ge.__hasExternalTextures){let re=Math.max(1,M.width>>ye),ne=Math.max(1,M.height>>ye);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,ye,se,re,ne,M.depth,0,be,te,null):t.texImage2D(ae,ye,se,re,ne,0,be,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),Ee(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,ae,U.__webglTexture,0,at(M)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,ae,U.__webglTexture,ye),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(P,M,X){if(i.bindRenderbuffer(i.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,ye=_(M.stencilBuffer,ae),be=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ee(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(M),ye,M.width,M.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(M),ye,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,ye,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,be,i.RENDERBUFFER,P)}else{let ue=M.textures;for(let ae=0;ae<ue.length;ae++){let ye=ue[ae],be=r.convert(ye.format,ye.colorSpace),te=r.convert(ye.type),se=C(ye.internalFormat,be,te,ye.normalized,ye.colorSpace);Ee(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(M),se,M.width,M.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(M),se,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,se,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function St(P,M,X){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(M.depthTexture);ae.__renderTarget=M;let ye=ue?M.depthTexture.image[0]:M.depthTexture.image;(!ae.__webglTexture||ye.width!==M.width||ye.height!==M.height)&&(ye.width=M.width,ye.height=M.height,M.depthTexture.needsUpdate=!0),ue?we(M.depthTexture,0):xe(M.depthTexture,0);let be=ae.__webglTexture,te=at(M),se=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,ge=M.depthTexture.format===zs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===Os)Ee(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,ge,se,be,0);else if(M.depthTexture.format===zs)Ee(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ge,se,be,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,ge,se,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(P){let M=n.get(P),X=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let ae=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),M.__depthDisposeCallback=ae}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)St(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?St(M.__webglFramebuffer[0],P,0):St(M.__webglFramebuffer,P,0);else if(X){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=i.createRenderbuffer(),Cn(M.__webglDepthbuffer[ue],P,!1);else{let ae=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=M.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ye)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),Cn(M.__webglDepthbuffer,P,!1);else{let ae=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ye),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,ye)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function tn(P,M,X){let ue=n.get(P);M!==void 0&&Ut(ue.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&vn(P)}function un(P){let M=P.texture,X=n.get(P),ue=n.get(M);P.addEventListener("dispose",G),z(P);let ae=P.textures,ye=P.isWebGLCubeRenderTarget===!0,be=ae.length>1;if(be||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=M.version,o.memory.textures++),ye){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let se=0;se<M.mipmaps.length;se++)X.__webglFramebuffer[te][se]=i.createFramebuffer()}else X.__webglFramebuffer[te]=i.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)X.__webglFramebuffer[te]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(be)for(let te=0,se=ae.length;te<se;te++){let ge=n.get(ae[te]);ge.__webglTexture===void 0&&(ge.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Ee(P)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let se=ae[te];X.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let ge=r.convert(se.format,se.colorSpace),U=r.convert(se.type),re=C(se.internalFormat,ge,U,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ne=at(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,X.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(X.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ye){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(i.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Ut(X.__webglFramebuffer[te][se],P,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ut(X.__webglFramebuffer[te],P,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,se=ae.length;te<se;te++){let ge=ae[te],U=n.get(ge),re=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,U.__webglTexture),ft(re,ge),Ut(X.__webglFramebuffer,P,ge,i.COLOR_ATTACHMENT0+te,re,0),T(ge)&&S(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Ut(X.__webglFramebuffer[se],P,M,i.COLOR_ATTACHMENT0,te,se);else Ut(X.__webglFramebuffer,P,M,i.COLOR_ATTACHMENT0,te,0);T(M)?S(te):M.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&vn(P)}function F(P){let M=P.textures;for(let X=0,ue=M.length;X<ue;X++){let ae=M[X];if(T(ae)&&ae.mipmapsAutoUpdate===!0){let ye=R(P),be=n.get(ae).__webglTexture;t.bindTexture(ye,be),S(ye),t.unbindTexture()}}}let Le=[];function Ye(P){if(P.samples>0){if(Ee(P)===!1){let M=P.textures,X=P.width,ue=P.height,ae=i.COLOR_BUFFER_BIT,ye=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=n.get(P),te=M.length>1;if(te)for(let ge=0;ge<M.length;ge++)t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ge=0;ge<M.length;ge++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let U=n.get(M[ge]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,U,0)}i.blitFramebuffer(0,0,X,ue,0,0,X,ue,ae,i.NEAREST),l===!0&&(Le.length=0,Le.push(i.COLOR_ATTACHMENT0+ge),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Le.push(ye),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let ge=0;ge<M.length;ge++){t.bindFramebuffer(i.FRAMEBUFFER,be.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let U=n.get(M[ge]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,be.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.TEXTURE_2D,U,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function at(P){return Math.min(s.maxSamples,P.samples)}function Ee(P){let M=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function kt(P){let M=o.render.frame;h.get(P)!==M&&(h.set(P,M),P.update())}function He(P,M){let X=P.colorSpace,ue=P.format,ae=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==za&&X!==Vs&&(Mt.getTransfer(X)===It?(ue!==wi||ae!==li)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",X)),M}function qe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=xe,this.setTexture2DArray=ve,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=tn,this.setupRenderTarget=un,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Ee,this.dispose=W}function NA(i,e){function t(n,s=Vs){let r,o=Mt.getTransfer(s);if(n===li)return i.UNSIGNED_BYTE;if(n===gh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===xh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Pf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Lf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Cf)return i.BYTE;if(n===Rf)return i.SHORT;if(n===Yo)return i.UNSIGNED_SHORT;if(n===mh)return i.INT;if(n===Yi)return i.UNSIGNED_INT;if(n===Zi)return i.FLOAT;if(n===Ki)return i.HALF_FLOAT;if(n===If)return i.ALPHA;if(n===Df)return i.RGB;if(n===wi)return i.RGBA;if(n===Os)return i.DEPTH_COMPONENT;if(n===zs)return i.DEPTH_STENCIL;if(n===Nf)return i.RED;if(n===_h)return i.RED_INTEGER;if(n===pr)return i.RG;if(n===yh)return i.RG_INTEGER;if(n===vh)return i.RGBA_INTEGER;if(n===al||n===ll||n===cl||n===hl)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===al)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===al)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ll)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===cl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===hl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===bh||n===Mh||n===Sh||n===wh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===bh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Mh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Sh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===wh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Eh||n===Th||n===Ah||n===Ch||n===Rh||n===ul||n===Ph)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Eh||n===Th)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ch)return r.COMPRESSED_R11_EAC;if(n===Rh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===ul)return r.COMPRESSED_RG11_EAC;if(n===Ph)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Lh||n===Ih||n===Dh||n===Nh||n===Oh||n===Uh||n===Fh||n===kh||n===Bh||n===zh||n===Vh||n===Hh||n===Gh||n===Wh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ih)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Nh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Oh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Uh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===kh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Bh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===zh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Vh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Hh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Gh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Wh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===$h||n===Xh||n===qh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===$h)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Xh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===qh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Yh||n===Zh||n===dl||n===Kh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Yh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Zh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===dl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var OA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,UA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,np=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ds({vertexShader:OA,fragmentShader:UA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new oi(new Fr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ip=class extends qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",p=new np,m={},v=t.getContextAttributes(),T=null,S=null,R=[],C=[],_=new tt,A=null,z=null,O=new ti;O.viewport=new jt;let D=new ti;D.viewport=new jt;let G=[O,D],H=new hh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let xe=R[ee];return xe===void 0&&(xe=new ko,R[ee]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(ee){let xe=R[ee];return xe===void 0&&(xe=new ko,R[ee]=xe),xe.getGripSpace()},this.getHand=function(ee){let xe=R[ee];return xe===void 0&&(xe=new ko,R[ee]=xe),xe.getHandSpace()};function $(ee){let xe=C.indexOf(ee.inputSource);if(xe===-1)return;let ve=R[xe];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function B(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",oe);for(let ee=0;ee<R.length;ee++){let xe=C[ee];xe!==null&&(C[ee]=null,R[ee].disconnect(xe))}N=null,W=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(T),f=null,d=null,u=null,s=null,S=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(_.width,_.height,!1),z!==null){let ee=z.camera;ee.fov=z.fov,ee.zoom=z.zoom,ee.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",B),s.addEventListener("inputsourceschange",oe),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Re=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?zs:Os,Re=v.stencil?Vr:Yi);let $e={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer($e),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new bi(d.textureWidth,d.textureHeight,{format:wi,type:li,depthTexture:new ks(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new bi(f.framebufferWidth,f.framebufferHeight,{format:wi,type:li,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function oe(ee){for(let xe=0;xe<ee.removed.length;xe++){let ve=ee.removed[xe],Re=C.indexOf(ve);Re>=0&&(C[Re]=null,R[Re].disconnect(ve))}for(let xe=0;xe<ee.added.length;xe++){let ve=ee.added[xe],Re=C.indexOf(ve);if(Re===-1){for(let $e=0;$e<R.length;$e++)if($e>=C.length){C.push(ve),Re=$e;break}else if(C[$e]===null){C[$e]=ve,Re=$e;break}if(Re===-1)break}let we=R[Re];we&&we.connect(ve)}}function K(ee,xe){xe===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(xe.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let xe=ee.near,ve=ee.far;p.texture!==null&&(p.depthNear>0&&(xe=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),H.near=D.near=O.near=xe,H.far=D.far=O.far=ve,(N!==H.near||W!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),N=H.near,W=H.far),H.layers.mask=ee.layers.mask|6,O.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let Re=ee.parent,we=H.cameras;K(H,Re);for(let $e=0;$e<we.length;$e++)K(we[$e],Re);H.projectionMatrix.copy(O.projectionMatrix),H.projectionMatrixInverse.copy(O.projectionMatrixInverse),z===null&&ee.isPerspectiveCamera&&(z={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,H,Re)};function Q(ee,xe,ve){ve===null?ee.matrix.copy(xe.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(xe.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(xe.projectionMatrix),ee.projectionMatrixInverse.copy(xe.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Uo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,xe){if(h=xe.getViewerPose(c||o),g=xe,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Re=!1;ve.length!==H.cameras.length&&(H.cameras.length=0,Re=!0);for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge],ht=null;if(f!==null)ht=f.getViewport(ft);else{let Zt=u.getViewSubImage(d,ft);ht=Zt.viewport,Ge===0&&(e.setRenderTargetTextures(S,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(S))}let st=G[Ge];st===void 0&&(st=new ti,st.layers.enable(Ge),st.viewport=new jt,G[Ge]=st),st.matrix.fromArray(ft.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(ft.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(ht.x,ht.y,ht.width,ht.height),Ge===0&&(H.matrix.copy(st.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Re===!0&&H.cameras.push(st)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Ge=u.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&p.init(Ge,s.renderState)}if(we&&we.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge].camera;if(ft){let ht=m[ft];ht||(ht=new ja,m[ft]=ht);let st=u.getCameraImage(ft);ht.sourceTexture=st}}}}for(let ve=0;ve<R.length;ve++){let Re=C[ve],we=R[ve];Re!==null&&we!==void 0&&we.update(Re,xe,c||o)}ie&&ie(ee,xe),xe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xe}),g=null}let fe=new i_;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},FA=new Yt,f_=new it;f_.set(-1,0,0,0,1,0,0,0,1);function kA(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,Wf(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,T,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,S)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,T):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ii&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ii&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),T=v.envMap,S=v.envMapRotation;T&&(p.envMap.value=T,p.envMapRotation.value.setFromMatrix4(FA.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(f_),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,T){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=T*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ii&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function BA(i,e,t,n){let s={},r={};function o(v,T){let S=T.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",p));let R=T.program;n.updateUBOMapping(v,R);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let T=i.createBuffer(),S=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,S,R),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let C=0,_=S.length;C<_;C++){let A=S[C];if(Array.isArray(A))for(let z=0,O=A.length;z<O;z++)h(A[z],C,z,R);else h(A,C,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,T,S,R){if(d(v,T,S,R)===!0){let C=v.__offset,_=v.value;if(Array.isArray(_)){let A=0;for(let z=0;z<_.length;z++){let O=_[z],D=y(O,!0);u(O,v.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,C,v.__data)}}function u(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function d(v,T,S,R){let C=v.value,_=T+"_"+S;if(Array.isArray(C)){R[_]===void 0&&(R[_]=[]);let A=R[_],z=!1;for(let O=0;O<C.length;O++)f(C[O],A,O)===!0&&(z=!0);return z}return f(C,R,_)}function f(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let R=T[S];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function g(v){let T=v.uniforms,S=0,R=16;for(let _=0,A=T.length;_<A;_++){let z=Array.isArray(T[_])?T[_]:[T[_]];for(let O=0,D=z.length;O<D;O++){let G=z[O],H=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(T[_])||Array.isArray(G.value),W=S;for(let B=0,oe=H.length;B<oe;B++){let K=H[B],Q=y(K,N),ie=S%R,de=ie%Q.boundary,fe=ie+de;S+=de,fe!==0&&R-fe<Q.storage&&(S+=R-fe),B===0&&(W=S),S+=Q.storage}let $=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new $((S-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let C=S%R;return C>0&&(S+=R-C),v.__size=S,v.__cache={},this}function y(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(v){let T=v.target;T.removeEventListener("dispose",p),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var zA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ps=null;function VA(){return ps===null&&(ps=new Bo(zA,16,16,pr,Ki),ps.name="DFG_LUT",ps.minFilter=ni,ps.magFilter=ni,ps.wrapS=us,ps.wrapT=us,ps.generateMipmaps=!1,ps.needsUpdate=!0),ps}var tu=class{constructor(e={}){let{canvas:t=Tx(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=li}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,p=new Set([vh,yh,_h]),m=new Set([li,Yi,Yo,Vr,gh,xh]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,C=null,_=[],A=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let O=this,D=!1,G=null,H=null,N=null,W=null;this._outputColorSpace=On;let $=0,B=0,oe=null,K=-1,Q=null,ie=new jt,de=new jt,fe=null,ee=new ct(0),xe=0,ve=t.width,Re=t.height,we=1,$e=null,ot=null,Ge=new jt(0,0,ve,Re),ft=new jt(0,0,ve,Re),ht=!1,st=new ar,Zt=new Xc,Vt=!1,hn=!1,Ut=new Yt,Cn=new q,St=new jt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function un(){return oe===null?we:1}let F=n;function Le(E,k){return t.getContext(E,k)}let Ye,at,Ee,kt,He,qe,P,M,X,ue,ae,ye,be,te,se,ge,U,re,ne,Te,_e,Se,We;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),F===null){let k="webgl2";if(F=Le(k,E),F===null)throw Le(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(E){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),et("WebGLRenderer: "+E.message),E}function je(){Ye=new JE(F),Ye.init(),_e=new NA(F,Ye),at=new VE(F,Ye,e,_e),Ee=new IA(F,Ye),at.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),H=F.createFramebuffer(),N=F.createFramebuffer(),W=F.createFramebuffer(),kt=new tT(F),He=new _A,qe=new DA(F,Ye,Ee,He,at,_e,kt),P=new jE(O),M=new iw(F),Se=new BE(F,M),X=new QE(F,M,kt,Se),ue=new iT(F,X,M,Se,kt),re=new nT(F,at,qe),se=new HE(He),ae=new xA(O,P,Ye,at,Se,se),ye=new kA(O,He),be=new vA,te=new TA(Ye),U=new kE(O,P,Ee,ue,g,l),ge=new LA(O,ue,at),We=new BA(F,kt,at,Ee),ne=new zE(F,Ye,kt),Te=new eT(F,Ye,kt),kt.programs=ae.programs,O.capabilities=at,O.extensions=Ye,O.properties=He,O.renderLists=be,O.shadowMap=ge,O.state=Ee,O.info=kt}y!==li&&(z=new rT(y,t.width,t.height,a,s,r));let he=new ip(O,F);this.xr=he,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=Ye.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ye.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(ve,Re,!1))},this.getSize=function(E){return E.set(ve,Re)},this.setSize=function(E,k,J=!0){if(he.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=E,Re=k,t.width=Math.floor(E*we),t.height=Math.floor(k*we),J===!0&&(t.style.width=E+"px",t.style.height=k+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,E,k)},this.getDrawingBufferSize=function(E){return E.set(ve*we,Re*we).floor()},this.setDrawingBufferSize=function(E,k,J){ve=E,Re=k,we=J,t.width=Math.floor(E*J),t.height=Math.floor(k*J),this.setViewport(0,0,E,k)},this.setEffects=function(E){if(y===li){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let k=0;k<E.length;k++)if(E[k].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ie)},this.getViewport=function(E){return E.copy(Ge)},this.setViewport=function(E,k,J,Y){E.isVector4?Ge.set(E.x,E.y,E.z,E.w):Ge.set(E,k,J,Y),Ee.viewport(ie.copy(Ge).multiplyScalar(un()).round())},this.getScissor=function(E){return E.copy(ft)},this.setScissor=function(E,k,J,Y){E.isVector4?ft.set(E.x,E.y,E.z,E.w):ft.set(E,k,J,Y),Ee.scissor(de.copy(ft).multiplyScalar(un()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(E){Ee.setScissorTest(ht=E)},this.setOpaqueSort=function(E){$e=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(U.getClearColor())},this.setClearColor=function(){U.setClearColor(...arguments)},this.getClearAlpha=function(){return U.getClearAlpha()},this.setClearAlpha=function(){U.setClearAlpha(...arguments)},this.clear=function(E=!0,k=!0,J=!0){let Y=0;if(E){let Z=!1;if(oe!==null){let Ae=oe.texture.format;Z=p.has(Ae)}if(Z){let Ae=oe.texture.type,Ie=m.has(Ae),Ce=U.getClearColor(),De=U.getClearAlpha(),Ve=Ce.r,Qe=Ce.g,pt=Ce.b;Ie?(v[0]=Ve,v[1]=Qe,v[2]=pt,v[3]=De,F.clearBufferuiv(F.COLOR,0,v)):(T[0]=Ve,T[1]=Qe,T[2]=pt,T[3]=De,F.clearBufferiv(F.COLOR,0,T))}else Y|=F.COLOR_BUFFER_BIT}k&&(Y|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(Y|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&F.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),G=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),U.dispose(),be.dispose(),te.dispose(),qe.dispose(),He.dispose(),P.dispose(),ue.dispose(),X.dispose(),Se.dispose(),We.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",_l),he.removeEventListener("sessionend",ji),gs.stop()};function Be(E){E.preventDefault(),Bf("WebGLRenderer: Context Lost."),D=!0}function Je(){Bf("WebGLRenderer: Context Restored."),D=!1;let E=kt.autoReset,k=ge.enabled,J=ge.autoUpdate,Y=ge.needsUpdate,Z=ge.type;je(),kt.autoReset=E,ge.enabled=k,ge.autoUpdate=J,ge.needsUpdate=Y,ge.type=Z}function Pe(E){et("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let k=E.target;k.removeEventListener("dispose",lt),Ht(k)}function Ht(E){qn(E),He.remove(E)}function qn(E){let k=He.get(E).programs;k!==void 0&&(k.forEach(function(J){ae.releaseProgram(J)}),E.isShaderMaterial&&ae.releaseShaderCache(E))}this.renderBufferDirect=function(E,k,J,Y,Z,Ae){k===null&&(k=vn);let Ie=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ce=na(E,k,J,Y,Z);Ee.setMaterial(Y,Ie);let De=J.index,Ve=1;if(Y.wireframe===!0){if(De=X.getWireframeAttribute(J),De===void 0)return;Ve=2}let Qe=J.drawRange,pt=J.attributes.position,ze=Qe.start*Ve,mt=(Qe.start+Qe.count)*Ve;Ae!==null&&(ze=Math.max(ze,Ae.start*Ve),mt=Math.min(mt,(Ae.start+Ae.count)*Ve)),De!==null?(ze=Math.max(ze,0),mt=Math.min(mt,De.count)):pt!=null&&(ze=Math.max(ze,0),mt=Math.min(mt,pt.count));let Jt=mt-ze;if(Jt<0||Jt===1/0)return;Se.setup(Z,Y,Ce,J,De);let Dt,Nt=ne;if(De!==null&&(Dt=M.get(De),Nt=Te,Nt.setIndex(Dt)),Z.isMesh)Y.wireframe===!0?(Ee.setLineWidth(Y.wireframeLinewidth*un()),Nt.setMode(F.LINES)):Nt.setMode(F.TRIANGLES);else if(Z.isLine){let bn=Y.linewidth;bn===void 0&&(bn=1),Ee.setLineWidth(bn*un()),Z.isLineSegments?Nt.setMode(F.LINES):Z.isLineLoop?Nt.setMode(F.LINE_LOOP):Nt.setMode(F.LINE_STRIP)}else Z.isPoints?Nt.setMode(F.POINTS):Z.isSprite&&Nt.setMode(F.TRIANGLES);if(Z.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Nt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let bn=Z._multiDrawStarts,Fe=Z._multiDrawCounts,dn=Z._multiDrawCount,vt=De?M.get(De).bytesPerElement:1,_s=He.get(Y).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)_s.setValue(F,"_gl_DrawID",fn),Nt.render(bn[fn]/vt,Fe[fn])}else if(Z.isInstancedMesh)Nt.renderInstances(ze,Jt,Z.count);else if(J.isInstancedBufferGeometry){let bn=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Fe=Math.min(J.instanceCount,bn);Nt.renderInstances(ze,Jt,Fe)}else Nt.render(ze,Jt)};function Qo(E,k,J,Y){G!==null&&E.isNodeMaterial&&G.setObject(Y,E),Vt===!0&&se.setState(E,J,!1),E.transparent===!0&&E.side===ai&&E.forceSinglePass===!1?(E.side=ii,E.needsUpdate=!0,Ji(E,k,Y),E.side=fr,E.needsUpdate=!0,Ji(E,k,Y),E.side=ai):Ji(E,k,Y)}this.compile=function(E,k,J=null){J===null&&(J=E),G!==null&&G.renderStart(E,k,J),C=te.get(J),C.init(k),A.push(C),J.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),E!==J&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),C.setupLights(),G!==null&&G.updateLights(C.state.lightsArray),hn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,hn),Vt===!0&&se.setGlobalState(this.clippingPlanes,k),G!==null&&ge.render(C.state.shadowsArray,J,k);let Y=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ae=Z.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Ce=Ae[Ie];Qo(Ce,J,k,Z),Y.add(Ce)}else Qo(Ae,J,k,Z),Y.add(Ae)}),C=A.pop(),G!==null&&G.renderEnd(),Y},this.compileAsync=function(E,k,J=null){let Y=this.compile(E,k,J);return new Promise(Z=>{function Ae(){if(Y.forEach(function(Ie){let De=He.get(Ie).currentProgram;(De===void 0||De.isReady())&&Y.delete(Ie)}),Y.size===0){Z(E);return}setTimeout(Ae,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Gr=null;function pu(E){Gr&&Gr(E)}function _l(){gs.stop()}function ji(){gs.start()}let gs=new i_;gs.setAnimationLoop(pu),typeof self<"u"&&gs.setContext(self),this.setAnimationLoop=function(E){Gr=E,he.setAnimationLoop(E),E===null?gs.stop():gs.start()},he.addEventListener("sessionstart",_l),he.addEventListener("sessionend",ji),this.render=function(E,k){if(k!==void 0&&k.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(E,k);let J=he.enabled===!0&&he.isPresenting===!0,Y=z!==null&&(oe===null||J)&&z.begin(O,oe);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(k),k=he.getCamera()),E.isScene===!0&&E.onBeforeRender(O,E,k,oe),C=te.get(E,A.length),C.init(k),C.state.textureUnits=qe.getTextureUnits(),A.push(C),Ut.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Zt.setFromArrayCamera(k):st.setFromProjectionMatrix(Ut,Oi,k.reversedDepth),hn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,hn),R=be.get(E,_.length),R.init(),_.push(R),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=O.xr.getDepthSensingMesh();Ie!==null&&xs(Ie,k,-1/0,O.sortObjects)}xs(E,k,0,O.sortObjects),R.finish(),G!==null&&G.updateLights(C.state.lightsArray),O.sortObjects===!0&&R.sort($e,ot),tn=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,tn&&U.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&se.beginShadows();let Z=C.state.shadowsArray;if(ge.render(Z,E,k),Vt===!0&&se.endShadows(),(Y&&z.hasRenderPass())===!1){let Ie=R.opaque,Ce=R.transmissive;if(C.setupLights(),k.isArrayCamera){let De=k.cameras;if(Ce.length>0)for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];Ui(Ie,Ce,E,pt)}tn&&U.render(E);for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];ea(R,E,pt,pt.viewport)}}else Ce.length>0&&Ui(Ie,Ce,E,k),tn&&U.render(E),ea(R,E,k)}oe!==null&&B===0&&(qe.updateMultisampleRenderTarget(oe),qe.updateRenderTargetMipmap(oe)),Y&&z.end(O),E.isScene===!0&&E.onAfterRender(O,E,k),Se.resetDefaultState(),K=-1,Q=null,A.pop(),A.length>0?(C=A[A.length-1],qe.setTextureUnits(C.state.textureUnits),Vt===!0&&se.setGlobalState(O.clippingPlanes,C.state.camera)):C=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,G!==null&&G.renderEnd()};function xs(E,k,J,Y){if(E.visible===!1)return;if(E.layers.test(k.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(k);else if(E.isLight)C.pushLight(E),E.castShadow&&C.pushShadow(E);else if(E.isSprite){let Ie=k.isArrayCamera?Zt:st;if(!E.frustumCulled||E.intersectsFrustum(Ie)){Y&&St.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ut);let Ce=ue.update(E),De=E.material;De.visible&&R.push(E,Ce,De,J,St.z,null,k)}}else if(E.isMesh||E.isLine||E.isPoints){let Ie=k.isArrayCamera?Zt:st;if(!E.frustumCulled||E.intersectsFrustum(Ie)){let Ce=ue.update(E),De=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),St.copy(E.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),St.copy(Ce.boundingSphere.center)),St.applyMatrix4(E.matrixWorld).applyMatrix4(Ut)),Array.isArray(De)){let Ve=Ce.groups;for(let Qe=0,pt=Ve.length;Qe<pt;Qe++){let ze=Ve[Qe],mt=De[ze.materialIndex];mt&&mt.visible&&R.push(E,Ce,mt,J,St.z,ze,k)}}else De.visible&&R.push(E,Ce,De,J,St.z,null,k)}}}let Ae=E.children;for(let Ie=0,Ce=Ae.length;Ie<Ce;Ie++)xs(Ae[Ie],k,J,Y)}function ea(E,k,J,Y){let{opaque:Z,transmissive:Ae,transparent:Ie}=E;C.setupLightsView(J),Vt===!0&&se.setGlobalState(O.clippingPlanes,J),Y&&Ee.viewport(ie.copy(Y)),Z.length>0&&nn(Z,k,J),Ae.length>0&&nn(Ae,k,J),Ie.length>0&&nn(Ie,k,J),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ui(E,k,J,Y){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Y.id]===void 0){let ze=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Y.id]=new bi(1,1,{generateMipmaps:!0,type:ze?Ki:li,minFilter:Bs,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Ae=C.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||ie;Ae.setSize(Ie.z*O.transmissionResolutionScale,Ie.w*O.transmissionResolutionScale);let Ce=O.getRenderTarget(),De=O.getActiveCubeFace(),Ve=O.getActiveMipmapLevel();O.setRenderTarget(Ae),O.getClearColor(ee),xe=O.getClearAlpha(),xe<1&&O.setClearColor(16777215,.5),O.clear(),tn&&U.render(J);let Qe=O.toneMapping;O.toneMapping=fs;let pt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),C.setupLightsView(Y),Vt===!0&&se.setGlobalState(O.clippingPlanes,Y),nn(E,J,Y),qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let mt=0,Jt=k.length;mt<Jt;mt++){let Dt=k[mt],{object:Nt,geometry:bn,material:Fe,group:dn}=Dt;if(Fe.side===ai&&Nt.layers.test(Y.layers)){let vt=Fe.side;Fe.side=ii,Fe.needsUpdate=!0,ln(Nt,J,Y,bn,Fe,dn),Fe.side=vt,Fe.needsUpdate=!0,ze=!0}}ze===!0&&(qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae))}O.setRenderTarget(Ce,De,Ve),O.setClearColor(ee,xe),pt!==void 0&&(Y.viewport=pt),O.toneMapping=Qe}function nn(E,k,J){let Y=k.isScene===!0?k.overrideMaterial:null;for(let Z=0,Ae=E.length;Z<Ae;Z++){let Ie=E[Z],{object:Ce,geometry:De,group:Ve}=Ie,Qe=Ie.material;Qe.allowOverride===!0&&Y!==null&&(Qe=Y),Ce.layers.test(J.layers)&&ln(Ce,k,J,De,Qe,Ve)}}function ln(E,k,J,Y,Z,Ae){G!==null&&Z.isNodeMaterial&&G.setObject(E,Z),E.onBeforeRender(O,k,J,Y,Z,Ae),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(O,k,J,Y,E,Ae),Z.transparent===!0&&Z.side===ai&&Z.forceSinglePass===!1?(Z.side=ii,Z.needsUpdate=!0,O.renderBufferDirect(J,k,Y,Z,E,Ae),Z.side=fr,Z.needsUpdate=!0,O.renderBufferDirect(J,k,Y,Z,E,Ae),Z.side=ai):O.renderBufferDirect(J,k,Y,Z,E,Ae),E.onAfterRender(O,k,J,Y,Z,Ae)}function cn(E){let k=0;for(let J of E)J.texture!==null&&k++;return k}function Ji(E,k,J){k.isScene!==!0&&(k=vn);let Y=He.get(E),Z=C.state.lights,Ae=C.state.shadowsArray,Ie=Z.state.version,Ce=ae.getParameters(E,Z.state,Ae,k,J,C.state.lightProbeGridArray),De=ae.getProgramCacheKey(Ce),Ve=Y.programs;Y.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let Qe=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Y.envMap=P.get(E.envMap||Y.environment,Qe),Y.envMapRotation=Y.environment!==null&&E.envMap===null?k.environmentRotation:E.envMapRotation,Ve===void 0&&(E.addEventListener("dispose",lt),Ve=new Map,Y.programs=Ve,Y.programVariants=new Map);let pt=Ve.get(De);if(pt!==void 0){if(Y.currentProgram===pt&&Y.lightsStateVersion===Ie)return ta(E,Ce),pt}else Ce.uniforms=ae.getUniforms(E),G!==null&&E.isNodeMaterial&&G.build(E,J,Ce),E.onBeforeCompile(Ce,O),pt=ae.acquireProgram(Ce,De),Ve.set(De,pt),Y.uniforms=Ce.uniforms;let ze=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ze.clippingPlanes=se.uniform),ta(E,Ce),Y.needsLights=Gs(E),Y.lightsStateVersion=Ie,Y.needsLights&&(ze.ambientLightColor.value=Z.state.ambient,ze.lightProbe.value=Z.state.probe,ze.sunLights.value=Z.state.sun,ze.sunLightShadows.value=Z.state.sunShadow,ze.directionalLights.value=Z.state.directional,ze.directionalLightShadows.value=Z.state.directionalShadow,ze.spotLights.value=Z.state.spot,ze.spotLightShadows.value=Z.state.spotShadow,ze.rectAreaLights.value=Z.state.rectArea,ze.ltc_1.value=Z.state.rectAreaLTC1,ze.ltc_2.value=Z.state.rectAreaLTC2,ze.pointLights.value=Z.state.point,ze.pointLightShadows.value=Z.state.pointShadow,ze.hemisphereLights.value=Z.state.hemi,ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,ze.sunShadowCascade.value=Z.state.sunShadowCascade,ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ze.spotLightMatrix.value=Z.state.spotLightMatrix,ze.spotLightMap.value=Z.state.spotLightMap,ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=cn(C.state.lightProbeGridArray),Y.currentProgram=pt,Y.uniformsList=null,pt}function hi(E,k,J,Y,Z){let Ae=He.get(E),Ie=Ae.currentProgram.id+","+Y+","+Z,Ce=Ae.programVariants.get(Ie);return Ce===void 0?(Ce=Ji(E,k,J),Ae.programVariants.set(Ie,Ce)):(Ae.currentProgram=Ce,Ae.uniformsList=null,Ae.outputColorSpace=Y,Ae.toneMapping=Z),Ce}function Hs(E){if(E.uniformsList===null){let k=E.currentProgram.getUniforms();E.uniformsList=Ko.seqWithValue(k.seq,E.uniforms)}return E.uniformsList}function ta(E,k){let J=He.get(E);J.outputColorSpace=k.outputColorSpace,J.batching=k.batching,J.batchingColor=k.batchingColor,J.instancing=k.instancing,J.instancingColor=k.instancingColor,J.instancingMorph=k.instancingMorph,J.skinning=k.skinning,J.morphTargets=k.morphTargets,J.morphNormals=k.morphNormals,J.morphColors=k.morphColors,J.morphTargetsCount=k.morphTargetsCount,J.numClippingPlanes=k.numClippingPlanes,J.numIntersection=k.numClipIntersection,J.vertexAlphas=k.vertexAlphas,J.vertexTangents=k.vertexTangents,J.toneMapping=k.toneMapping}function na(E,k,J,Y,Z){k.isScene!==!0&&(k=vn),qe.resetTextureUnits();let Ae=k.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Ce=oe===null?O.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:Mt.workingColorSpace,De=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ve=P.get(Y.envMap||Ie,De),Qe=Y.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pt=!!J.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!J.morphAttributes.position,mt=!!J.morphAttributes.normal,Jt=!!J.morphAttributes.color,Dt=fs;Y.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(Dt=O.toneMapping);let Nt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,bn=Nt!==void 0?Nt.length:0,Fe=He.get(Y),dn=C.state.lights;if(Vt===!0&&(hn===!0||E!==Q)){let Ot=E===Q&&Y.id===K;se.setState(Y,E,Ot)}let vt=!1,_s=!1;Y.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==dn.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==Ve||Y.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==pt||Fe.morphTargets!==ze||Fe.morphNormals!==mt||Fe.morphColors!==Jt||Fe.morphTargetsCount!==bn||Fe.numLightProbeGrids!==cn(C.state.lightProbeGridArray)?vt=!0:(Fe.outputColorSpace!==Ce||Fe.toneMapping!==Dt)&&(_s=!0):(vt=!0,Fe.__version=Y.version);let fn=Fe.currentProgram;(vt===!0||_s===!0)&&(fn=_s===!0?hi(Y,k,Z,Ce,Dt):Ji(Y,k,Z),G&&Y.isNodeMaterial&&G.onUpdateProgram(Y,fn,Fe));let Xr=!1,Qi=!1,ys=!1,ut=fn.getUniforms(),sn=Fe.uniforms;if(Ee.useProgram(fn.program)&&(Xr=!0,Qi=!0,ys=!0),Y.id!==K&&(K=Y.id,Qi=!0),Xr||Q!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(F,"projectionMatrix",E.projectionMatrix),ut.setValue(F,"viewMatrix",E.matrixWorldInverse);let pn=ut.map.cameraPosition;pn!==void 0&&pn.setValue(F,Cn.setFromMatrixPosition(E.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ut.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Qi=!0,ys=!0)}if(Fe.needsLights&&(dn.state.sunShadowMap.length>0&&ut.setValue(F,"sunShadowMap",dn.state.sunShadowMap,qe),dn.state.directionalShadowMap.length>0&&ut.setValue(F,"directionalShadowMap",dn.state.directionalShadowMap,qe),dn.state.spotShadowMap.length>0&&ut.setValue(F,"spotShadowMap",dn.state.spotShadowMap,qe),dn.state.pointShadowMap.length>0&&ut.setValue(F,"pointShadowMap",dn.state.pointShadowMap,qe)),Z.isSkinnedMesh){ut.setOptional(F,Z,"bindMatrix"),ut.setOptional(F,Z,"bindMatrixInverse");let Ot=Z.skeleton;Ot&&(Ot.boneTexture===null&&Ot.computeBoneTexture(),ut.setValue(F,"boneTexture",Ot.boneTexture,qe))}Z.isBatchedMesh&&(ut.setOptional(F,Z,"batchingTexture"),ut.setValue(F,"batchingTexture",Z._matricesTexture,qe),ut.setOptional(F,Z,"batchingIdTexture"),ut.setValue(F,"batchingIdTexture",Z._indirectTexture,qe),ut.setOptional(F,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ut.setValue(F,"batchingColorTexture",Z._colorsTexture,qe));let Yn=J.morphAttributes;if((Yn.position!==void 0||Yn.normal!==void 0||Yn.color!==void 0)&&re.update(Z,J,fn),(Qi||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,ut.setValue(F,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(sn.envMapIntensity.value=k.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=VA()),Qi){if(ut.setValue(F,"toneMappingExposure",O.toneMappingExposure),Fe.needsLights&&Wr(sn,ys),Ae&&Y.fog===!0&&ye.refreshFogUniforms(sn,Ae),ye.refreshMaterialUniforms(sn,Y,we,Re,C.state.transmissionRenderTarget[E.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ot=S,pn=0;for(let kn of C.state.lightProbeGridArray)kn.texture!==null&&(Ot.textures[pn]=kn.texture,Ot.min[pn]=kn.boundingBox.min,Ot.max[pn]=kn.boundingBox.max,Ot.resolution[pn]=kn.resolution,pn++);for(let kn in Ot)Ot[kn].length=pn;sn.probesSH.value=Ot.textures,sn.probesMin.value=Ot.min,sn.probesMax.value=Ot.max,sn.probesResolution.value=Ot.resolution}Ko.upload(F,Hs(Fe),sn,qe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Ko.upload(F,Hs(Fe),sn,qe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ut.setValue(F,"center",Z.center),ut.setValue(F,"modelViewMatrix",Z.modelViewMatrix),ut.setValue(F,"normalMatrix",Z.normalMatrix),ut.setValue(F,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Ot=Y.uniformsGroups;for(let pn=0,kn=Ot.length;pn<kn;pn++){let yl=Ot[pn];We.update(yl,fn),We.bind(yl,fn)}}return fn}function Wr(E,k){E.ambientLightColor.needsUpdate=k,E.lightProbe.needsUpdate=k,E.sunLights.needsUpdate=k,E.sunLightShadows.needsUpdate=k,E.directionalLights.needsUpdate=k,E.directionalLightShadows.needsUpdate=k,E.pointLights.needsUpdate=k,E.pointLightShadows.needsUpdate=k,E.spotLights.needsUpdate=k,E.spotLightShadows.needsUpdate=k,E.rectAreaLights.needsUpdate=k,E.hemisphereLights.needsUpdate=k}function Gs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return oe},this.setRenderTargetTextures=function(E,k,J){let Y=He.get(E);Y.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(E.texture).__webglTexture=k,He.get(E.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:J,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,k){let J=He.get(E);J.__webglFramebuffer=k,J.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(E,k=0,J=0){oe=E,$=k,B=J;let Y=null,Z=!1,Ae=!1;if(E){let Ce=He.get(E);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(F.FRAMEBUFFER,Ce.__webglFramebuffer),ie.copy(E.viewport),de.copy(E.scissor),fe=E.scissorTest,Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),K=-1;return}else if(Ce.__webglFramebuffer===void 0)qe.setupRenderTarget(E);else if(Ce.__hasExternalTextures)qe.rebindTextures(E,He.get(E.texture).__webglTexture,He.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Qe=E.depthTexture;if(Ce.__boundDepthTexture!==Qe){if(Qe!==null&&He.has(Qe)&&(E.width!==Qe.image.width||E.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(E)}}let De=E.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let Ve=He.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ve[k])?Y=Ve[k][J]:Y=Ve[k],Z=!0):E.samples>0&&qe.useMultisampledRTT(E)===!1?Y=He.get(E).__webglMultisampledFramebuffer:Array.isArray(Ve)?Y=Ve[J]:Y=Ve,ie.copy(E.viewport),de.copy(E.scissor),fe=E.scissorTest}else ie.copy(Ge).multiplyScalar(we).floor(),de.copy(ft).multiplyScalar(we).floor(),fe=ht;if(J!==0&&(Y=H),Ee.bindFramebuffer(F.FRAMEBUFFER,Y)&&Ee.drawBuffers(E,Y),Ee.viewport(ie),Ee.scissor(de),Ee.setScissorTest(fe),Z){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ce.__webglTexture,J)}else if(Ae){let Ce=k;for(let De=0;De<E.textures.length;De++){let Ve=He.get(E.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ve.__webglTexture,J,Ce)}}else if(E!==null&&J!==0){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ce.__webglTexture,J)}K=-1};function $r(E){let k=He.get(E);return(k.__readFormat!==E.format||k.__readType!==E.type)&&(k.__readFormat=E.format,k.__readType=E.type,k.__formatReadable=at.textureFormatReadable(E.format),k.__typeReadable=at.textureTypeReadable(E.type)),k}this.readRenderTargetPixels=function(E,k,J,Y,Z,Ae,Ie,Ce=0){if(!(E&&E.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ve=E.textures[Ce],Qe=Ve.format,pt=Ve.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=$r(Ve);if(ze.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=E.width-Y&&J>=0&&J<=E.height-Z&&F.readPixels(k,J,Y,Z,_e.convert(Qe),_e.convert(pt),Ae)}finally{let Ve=oe!==null?He.get(oe).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(E,k,J,Y,Z,Ae,Ie,Ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De)if(k>=0&&k<=E.width-Y&&J>=0&&J<=E.height-Z){Ee.bindFramebuffer(F.FRAMEBUFFER,De);let Ve=E.textures[Ce],Qe=Ve.format,pt=Ve.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=$r(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.bufferData(F.PIXEL_PACK_BUFFER,Ae.byteLength,F.STREAM_READ),F.readPixels(k,J,Y,Z,_e.convert(Qe),_e.convert(pt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Jt=oe!==null?He.get(oe).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Jt);let Dt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Cx(F,Dt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ae),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(mt),F.deleteSync(Dt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,k=null,J=0){let Y=Math.pow(2,-J),Z=Math.floor(E.image.width*Y),Ae=Math.floor(E.image.height*Y),Ie=k!==null?k.x:0,Ce=k!==null?k.y:0;qe.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,J,0,0,Ie,Ce,Z,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(E,k,J=null,Y=null,Z=0,Ae=0){let Ie,Ce,De,Ve,Qe,pt,ze,mt,Jt,Dt=E.isCompressedTexture?E.mipmaps[Ae]:E.image;if(J!==null)Ie=J.max.x-J.min.x,Ce=J.max.y-J.min.y,De=J.isBox3?J.max.z-J.min.z:1,Ve=J.min.x,Qe=J.min.y,pt=J.isBox3?J.min.z:0;else{let ut=Math.pow(2,-Z);Ie=Math.floor(Dt.width*ut),Ce=Math.floor(Dt.height*ut),E.isDataArrayTexture?De=Dt.depth:E.isData3DTexture?De=Math.floor(Dt.depth*ut):De=1,Ve=0,Qe=0,pt=0}Y!==null?(ze=Y.x,mt=Y.y,Jt=Y.z):(ze=0,mt=0,Jt=0);let Nt=_e.convert(k.format),bn=_e.convert(k.type),Fe;k.isData3DTexture?(qe.setTexture3D(k,0),Fe=F.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(qe.setTexture2DArray(k,0),Fe=F.TEXTURE_2D_ARRAY):(qe.setTexture2D(k,0),Fe=F.TEXTURE_2D),Ee.activeTexture(F.TEXTURE0),Ee.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,k.flipY),Ee.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Ee.pixelStorei(F.UNPACK_ALIGNMENT,k.unpackAlignment);let dn=Ee.getParameter(F.UNPACK_ROW_LENGTH),vt=Ee.getParameter(F.UNPACK_IMAGE_HEIGHT),_s=Ee.getParameter(F.UNPACK_SKIP_PIXELS),fn=Ee.getParameter(F.UNPACK_SKIP_ROWS),Xr=Ee.getParameter(F.UNPACK_SKIP_IMAGES);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,Dt.width),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Dt.height),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,pt);let Qi=E.isDataArrayTexture||E.isData3DTexture,ys=k.isDataArrayTexture||k.isData3DTexture;if(E.isDepthTexture){let ut=He.get(E),sn=He.get(k),Yn=He.get(ut.__renderTarget),Ot=He.get(sn.__renderTarget);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,Yn.__webglFramebuffer),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ot.__webglFramebuffer);for(let pn=0;pn<De;pn++)Qi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(E).__webglTexture,Z,pt+pn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(k).__webglTexture,Ae,Jt+pn)),F.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ce,ze,mt,ze+Ie,mt+Ce,F.DEPTH_BUFFER_BIT,F.NEAREST);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||He.has(E)){let ut=He.get(E),sn=He.get(k);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,N),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,W);for(let Yn=0;Yn<De;Yn++)Qi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ut.__webglTexture,Z,pt+Yn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ut.__webglTexture,Z),ys?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,sn.__webglTexture,Ae,Jt+Yn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,sn.__webglTexture,Ae),Z!==0?F.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ce,ze,mt,ze+Ie,mt+Ce,F.COLOR_BUFFER_BIT,F.NEAREST):ys?F.copyTexSubImage3D(Fe,Ae,ze,mt,Jt+Yn,Ve,Qe,Ie,Ce):F.copyTexSubImage2D(Fe,Ae,ze,mt,Ve,Qe,Ie,Ce);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ys?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(Fe,Ae,ze,mt,Jt,Ie,Ce,De,Nt,bn,Dt.data):k.isCompressedArrayTexture?F.compressedTexSubImage3D(Fe,Ae,ze,mt,Jt,Ie,Ce,De,Nt,Dt.data):F.texSubImage3D(Fe,Ae,ze,mt,Jt,Ie,Ce,De,Nt,bn,Dt):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Ie,Ce,Nt,bn,Dt.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Dt.width,Dt.height,Nt,Dt.data):F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Ie,Ce,Nt,bn,Dt);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,dn),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,vt),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,_s),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,fn),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,Xr),Ae===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&F.generateMipmap(Fe),Ee.unbindTexture()},this.initRenderTarget=function(E){He.get(E).__webglFramebuffer===void 0&&qe.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?qe.setTextureCube(E,0):E.isData3DTexture?qe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?qe.setTexture2DArray(E,0):qe.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){$=0,B=0,oe=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Oi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};var p_={type:"change"},rp={type:"start"},g_={type:"end"},su=new Or,m_=new ei,HA=Math.cos(70*Gf.DEG2RAD),An=new q,ci=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sp=1e-6,ru=class extends sl{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:dr.ROTATE,TWO:dr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new vi,this._lastTargetPosition=new q,this._quat=new vi().setFromUnitVectors(e.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new q,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new q,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=WA.bind(this),this._onPointerDown=GA.bind(this),this._onPointerUp=$A.bind(this),this._onContextMenu=JA.bind(this),this._onMouseWheel=YA.bind(this),this._onKeyDown=ZA.bind(this),this._onTouchStart=KA.bind(this),this._onTouchMove=jA.bind(this),this._onMouseDown=XA.bind(this),this._onMouseMove=qA.bind(this),this._interceptControlDown=QA.bind(this),this._interceptControlUp=eC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(p_),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;An.copy(t).sub(this.target),An.applyQuaternion(this._quat),this._spherical.setFromVector3(An),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ci:n>Math.PI&&(n-=ci),s<-Math.PI?s+=ci:s>Math.PI&&(s-=ci),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(An.setFromSpherical(this._spherical),An.applyQuaternion(this._quatInverse),t.copy(this.target).add(An),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=An.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=An.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(su.origin.copy(this.object.position),su.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(su.direction))<HA?this.object.lookAt(this.target):(m_.setFromNormalAndCoplanarPoint(this.object.up,this.target),su.intersectPlane(m_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>sp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sp||this._lastTargetPosition.distanceToSquared(this.target)>sp?(this.dispatchEvent(p_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ci/60*this.autoRotateSpeed*e:ci/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){An.setFromMatrixColumn(t,0),An.multiplyScalar(-e),this._panOffset.add(An)}_panUp(e,t){this.screenSpacePanning===!0?An.setFromMatrixColumn(t,1):(An.setFromMatrixColumn(t,0),An.crossVectors(this.object.up,An)),An.multiplyScalar(e),this._panOffset.add(An)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;An.copy(s).sub(this.target);let r=An.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function GA(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function WA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function $A(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(g_),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function XA(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pt.DOLLY;break;case ur.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}break;case ur.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(rp)}function qA(i){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function YA(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(i.preventDefault(),this.dispatchEvent(rp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(g_))}function ZA(i){this.enabled!==!1&&this._handleKeyDown(i)}function KA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case dr.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(i),this.state=Pt.TOUCH_ROTATE;break;case dr.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(i),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case dr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pt.TOUCH_DOLLY_PAN;break;case dr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(rp)}function jA(i){switch(this._trackPointer(i),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pt.NONE}}function JA(i){this.enabled!==!1&&i.preventDefault()}function QA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function eC(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var tC=.97,nC=Array.from({length:8},(i,e)=>[e&1?1:-1,e&2?1:-1,e&4?1:-1]),ou=class{constructor(e,t,n){this.low=e;this.high=t;this.renderer=new tu({antialias:!0,alpha:!0}),this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","img"),this.camera.up.set(0,0,1);let s=new nl(16777215,2.2);s.position.set(-.6,.9,.8),this.camera.add(s),this.scene.add(this.camera,new il(16777215,1.3)),this.controls=new ru(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>this.controls.enableZoom=!0,{signal:n}),this.canvas.addEventListener("blur",()=>this.controls.enableZoom=!1,{signal:n}),this.canvas.addEventListener("keydown",r=>this.key(r),{signal:n}),this.controls.addEventListener("change",()=>this.draw()),this.controls.addEventListener("start",()=>this.view=null),this.watcher=new ResizeObserver(()=>this.draw()),this.watcher.observe(this.canvas),this.look(-60,30),n.addEventListener("abort",()=>this.end())}low;high;canvas;renderer;scene=new $a;camera=new ti(32,1,.1,1e3);controls;named=new Map;plane=new ei(new q(0,0,-1),0);watcher;isCut=!1;view=null;frame=0;end(){cancelAnimationFrame(this.frame),this.watcher.disconnect(),this.controls.dispose();for(let e of[...this.named.keys()])this.remove(e);this.renderer.dispose(),this.renderer.forceContextLoss()}look(e,t){this.view=[e,t];let n=new q(...this.low).add(new q(...this.high)).multiplyScalar(.5),s=new q(...this.high).sub(n),r=s.length(),[o,a]=[e,Math.min(Math.max(t,-89.9),89.9)].map(f=>f*Math.PI/180),l=new q(Math.cos(o)*Math.cos(a),Math.sin(o)*Math.cos(a),Math.sin(a)),c=new q(-Math.sin(o),Math.cos(o),0),h=l.clone().cross(c),u=tC*Math.tan(this.camera.fov*Math.PI/360),d=Math.max(...nC.map(f=>{let g=new q(...f).multiply(s);return g.dot(l)+Math.max(Math.abs(g.dot(h)),Math.abs(g.dot(c))/this.camera.aspect)/u}));this.camera.near=r/50,this.camera.far=30*r,this.controls.target.copy(n),this.camera.position.copy(l).multiplyScalar(d).add(n),this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}mesh(e,t,n){if(this.remove(e),t.triangles.length===0)return;let s=new Mi;s.setAttribute("position",new Wn(t.corners,3)),s.setIndex(new Wn(t.triangles,1)),s.computeVertexNormals(),n.colors&&s.setAttribute("color",new Wn(sC(n.colors),3));let r=n.opacity!==void 0&&n.opacity<1,o=new Ho({vertexColors:n.colors!==void 0,side:ai,transparent:r,opacity:n.opacity??1,depthWrite:!r});n.color!==void 0&&(o.color=new ct().setRGB(...to(n.color),On)),o.clippingPlanes=this.isCut&&n.whole!==!0?[this.plane]:[],o.userData.whole=n.whole===!0,this.add(e,new oi(s,o))}walls(e,t,n){this.remove(e);let s=new Ds,r=new ct().setRGB(...to(n),On);for(let{points:o,low:a,high:l}of t){for(let f of[a,l]){let g=new Mi().setFromPoints(o.map(([y,p])=>new q(y,p,f)));s.add(new Ya(g,new zo({color:r,transparent:!0,opacity:.55})))}let c=new Float32Array(o.flatMap(([f,g])=>[f,g,a,f,g,l])),h=o.length,u=Uint32Array.from(o.flatMap((f,g)=>[0,2,1,1,2,3].map(y=>(2*g+y)%(2*h)))),d=new Mi;d.setAttribute("position",new Wn(c,3)),d.setIndex(new Wn(u,1)),s.add(new oi(d,new Ur({color:r,transparent:!0,opacity:.06,side:ai,depthWrite:!1})))}this.add(e,s)}cut(e,t,n){if(this.remove("cut"),this.isCut=e!==null,e!==null){let s=new q().setComponent(e,e===1?1:-1);this.plane.set(s,e===1?-t:t),n&&this.add("cut",iC(e,t,n))}this.scene.traverse(s=>{let r=s.material;r instanceof Ho&&(r.clippingPlanes=this.isCut&&r.userData.whole!==!0?[this.plane]:[])}),this.draw()}remove(e){let t=this.named.get(e);t&&(this.scene.remove(t),this.named.delete(e),t.traverse(n=>{let s=n;s.geometry?.dispose();let r=s.material;r?.map?.dispose(),r?.dispose()}),this.draw())}add(e,t){this.named.set(e,t),this.scene.add(t),this.draw()}draw(){this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0;let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];if(e===0||t===0)return;let n=Math.min(window.devicePixelRatio||1,2);(this.canvas.width!==Math.round(e*n)||this.canvas.height!==Math.round(t*n))&&(this.renderer.setPixelRatio(n),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.view&&this.look(...this.view)),this.renderer.render(this.scene,this.camera)}))}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=this.camera.position.clone().sub(this.controls.target),n=t.length(),[s,r]=[Math.atan2(t.y,t.x),Math.asin(t.z/n)].map(l=>l*180/Math.PI),o={ArrowLeft:[-10,0],ArrowRight:[10,0],ArrowUp:[0,10],ArrowDown:[0,-10]},a={"+":.85,"=":.85,"-":1/.85};if(e.key in o){let[l,c]=[s+o[e.key][0],Math.min(Math.max(r+o[e.key][1],-89.9),89.9)].map(h=>h*Math.PI/180);this.camera.position.set(Math.cos(l)*Math.cos(c),Math.sin(l)*Math.cos(c),Math.sin(c)).multiplyScalar(n).add(this.controls.target)}else if(e.key in a)this.camera.position.copy(t.multiplyScalar(a[e.key]).add(this.controls.target));else if(e.key==="0")this.look(-60,30);else return;e.preventDefault(),e.key!=="0"&&(this.view=null),this.controls.update(),this.draw()}};function iC(i,e,{pixels:t,width:n,height:s,pitch:r,corner:o}){let[a,l]=Bn[i],c=new Uint32Array(t.length);for(let f=0;f<s;f++)c.set(t.subarray((s-1-f)*n,(s-f)*n),f*n);let h=new Bo(new Uint8Array(c.buffer),n,s,wi);h.colorSpace=On,h.magFilter=h.minFilter=yn,h.needsUpdate=!0;let u=new Fr(1,1),d=u.getAttribute("position");for(let f=0;f<d.count;f++){let[g,y]=[d.getX(f)+.5,d.getY(f)+.5],p=new q().setComponent(i,e);p.setComponent(a,o[0]+g*n*r[0]).setComponent(l,o[1]+(y-1)*s*r[1]),d.setXYZ(f,p.x,p.y,p.z)}return new oi(u,new Ur({map:h,side:ai,alphaTest:.5}))}function sC(i){let e=new Map,t=new Float32Array(3*i.length),n=new ct;return i.forEach((s,r)=>{let o=e.get(s);o||(n.setRGB(...to(s),On),o=[n.r,n.g,n.b],e.set(s,o)),t.set(o,3*r)}),t}var x_=`"use strict";(()=>{function S(a,e){let{pitch:t,low:r}=a,[s,l,o]=a.shape.map(g=>g+2),u=C(a,e),n=s*l,h=Int32Array.from({length:8},(g,y)=>(y&1)+(y>>1&1)*s+(y>>2)*n),i=[1,s,n],f=2*n,c=new Int32Array(f),d=new k(Float32Array),F=new k(Uint32Array),m=new Float32Array(8),v=new Float64Array(3),b=0;for(let g=0;g+1<o;g++)for(let y=0;y+1<l;y++)for(let w=0;w+1<s;w++){let A=w+s*y+n*g,M=0;for(let p=0;p<8;p++)m[p]=u[A+h[p]],m[p]>=0&&(M|=1<<p);if(M===0||M===255)continue;D(m,M,v),d.push3(r[0]+(w+v[0]-.5)*t[0],r[1]+(y+v[1]-.5)*t[1],r[2]+(g+v[2]-.5)*t[2]),c[A%f]=b;let x=(M&1)!==0;for(let p=0;p<3;p++){if(x===u[A+i[p]]>=0||p!==0&&w===0||p!==1&&y===0||p!==2&&g===0)continue;let O=i[(p+1)%3],T=i[(p+2)%3],B=c[(A-O)%f],z=c[(A-O-T)%f],E=c[(A-T)%f];x?(F.push3(b,B,z),F.push3(b,z,E)):(F.push3(b,z,B),F.push3(b,E,z))}b++}return{corners:d.taken(),triangles:F.taken()}}function C({codes:a,values:e,shape:t},r){let[s,l,o]=t,u=new Float32Array((s+2)*(l+2)*(o+2)).fill(-1e6),n=e.map(i=>Number.isNaN(i)?-1e6:i-r),h=0;for(let i=0;i<o;i++)for(let f=0;f<l;f++){let c=1+(s+2)*(f+1+(l+2)*(i+1));for(let d=0;d<s;d++)u[c++]=n[a[h++]]}return u}var R=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function D(a,e,t){let r=0,s=0,l=0,o=0;for(let u=0;u<24;u+=2){let n=R[u],h=R[u+1];if((e>>n&1)===(e>>h&1))continue;let i=a[n]/(a[n]-a[h]);r+=(n&1)+i*((h&1)-(n&1)),s+=(n>>1&1)+i*((h>>1&1)-(n>>1&1)),l+=(n>>2)+i*((h>>2)-(n>>2)),o++}t[0]=r/o,t[1]=s/o,t[2]=l/o}var _=8,U=class{constructor(e,{shape:t,pitch:r,low:s}){this.mesh=e;this.normals=G(e),this.size=2*Math.max(...r),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(n=>Math.ceil(t[n]*r[n]/this.size)+2);let l=e.corners.length/3,o=Uint32Array.from({length:l},(n,h)=>this.cellOf(e.corners,h));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let n of o)this.starts[n+1]++;for(let n=1;n<this.starts.length;n++)this.starts[n]+=this.starts[n-1];let u=this.starts.slice();this.order=new Uint32Array(l),o.forEach((n,h)=>{this.order[u[n]++]=h})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let r=0;r<t.length;r++)t[r]=this.off(e[3*r],e[3*r+1],e[3*r+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,r){let{corners:s}=this.mesh,[l,o,u]=this.cells,n=this.place(e,0),h=this.place(t,1),i=this.place(r,2),f=Number.POSITIVE_INFINITY,c=-1;for(let m=0;m<=_&&!(c>=0&&f<=((m-1)*this.size)**2);m++)for(let v=Math.max(i-m,0);v<=Math.min(i+m,u-1);v++)for(let b=Math.max(h-m,0);b<=Math.min(h+m,o-1);b++){let g=Math.abs(v-i)===m||Math.abs(b-h)===m;for(let y=n-m;y<=n+m;y+=g||m===0?1:2*m){if(y<0||y>=l)continue;let w=y+l*(b+o*v);for(let A=this.starts[w];A<this.starts[w+1];A++){let M=3*this.order[A],x=(s[M]-e)**2+(s[M+1]-t)**2+(s[M+2]-r)**2;x<f&&(f=x,c=M)}}}if(c<0)return _*this.size;let d=(e-s[c])*this.normals[c]+(t-s[c+1])*this.normals[c+1]+(r-s[c+2])*this.normals[c+2],F=Math.sqrt(f);return F<=this.size?d:Math.sign(d)*F}};function G({corners:a,triangles:e}){let t=new Float32Array(a.length);for(let r=0;r<e.length;r+=3){let[s,l,o]=[3*e[r],3*e[r+1],3*e[r+2]],[u,n,h]=[a[l]-a[s],a[l+1]-a[s+1],a[l+2]-a[s+2]],[i,f,c]=[a[o]-a[s],a[o+1]-a[s+1],a[o+2]-a[s+2]];for(let d of[s,l,o])t[d]+=n*c-h*f,t[d+1]+=h*i-u*c,t[d+2]+=u*f-n*i}for(let r=0;r<t.length;r+=3){let s=Math.hypot(t[r],t[r+1],t[r+2])||1;for(let l=0;l<3;l++)t[r+l]/=s}return t}var k=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,r){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=r}taken(){return this.array.slice(0,this.used)}};var N=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],I();case"print":{if(!this.response)return I();let t=S(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:I()}case"part":{let{samples:t,code:r}=e;return{...S({...t,values:Float32Array.from(t.values,(s,l)=>l===r?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=S(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new U(e,this.target)),this.distance}};function I(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let a=new N;self.addEventListener("message",e=>{let t=a.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}})();
`;function cu(i,e){let{pitch:t,low:n}=i,[s,r,o]=i.shape.map(v=>v+2),a=oC(i,e),l=s*r,c=Int32Array.from({length:8},(v,T)=>(T&1)+(T>>1&1)*s+(T>>2)*l),h=[1,s,l],u=2*l,d=new Int32Array(u),f=new lu(Float32Array),g=new lu(Uint32Array),y=new Float32Array(8),p=new Float64Array(3),m=0;for(let v=0;v+1<o;v++)for(let T=0;T+1<r;T++)for(let S=0;S+1<s;S++){let R=S+s*T+l*v,C=0;for(let A=0;A<8;A++)y[A]=a[R+c[A]],y[A]>=0&&(C|=1<<A);if(C===0||C===255)continue;aC(y,C,p),f.push3(n[0]+(S+p[0]-.5)*t[0],n[1]+(T+p[1]-.5)*t[1],n[2]+(v+p[2]-.5)*t[2]),d[R%u]=m;let _=(C&1)!==0;for(let A=0;A<3;A++){if(_===a[R+h[A]]>=0||A!==0&&S===0||A!==1&&T===0||A!==2&&v===0)continue;let z=h[(A+1)%3],O=h[(A+2)%3],D=d[(R-z)%u],G=d[(R-z-O)%u],H=d[(R-O)%u];_?(g.push3(m,D,G),g.push3(m,G,H)):(g.push3(m,G,D),g.push3(m,H,G))}m++}return{corners:f.taken(),triangles:g.taken()}}function oC({codes:i,values:e,shape:t},n){let[s,r,o]=t,a=new Float32Array((s+2)*(r+2)*(o+2)).fill(-1e6),l=e.map(h=>Number.isNaN(h)?-1e6:h-n),c=0;for(let h=0;h<o;h++)for(let u=0;u<r;u++){let d=1+(s+2)*(u+1+(r+2)*(h+1));for(let f=0;f<s;f++)a[d++]=l[i[c++]]}return a}var __=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function aC(i,e,t){let n=0,s=0,r=0,o=0;for(let a=0;a<24;a+=2){let l=__[a],c=__[a+1];if((e>>l&1)===(e>>c&1))continue;let h=i[l]/(i[l]-i[c]);n+=(l&1)+h*((c&1)-(l&1)),s+=(l>>1&1)+h*((c>>1&1)-(l>>1&1)),r+=(l>>2)+h*((c>>2)-(l>>2)),o++}t[0]=n/o,t[1]=s/o,t[2]=r/o}var y_=8,au=class{constructor(e,{shape:t,pitch:n,low:s}){this.mesh=e;this.normals=lC(e),this.size=2*Math.max(...n),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(l=>Math.ceil(t[l]*n[l]/this.size)+2);let r=e.corners.length/3,o=Uint32Array.from({length:r},(l,c)=>this.cellOf(e.corners,c));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let l of o)this.starts[l+1]++;for(let l=1;l<this.starts.length;l++)this.starts[l]+=this.starts[l-1];let a=this.starts.slice();this.order=new Uint32Array(r),o.forEach((l,c)=>{this.order[a[l]++]=c})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let n=0;n<t.length;n++)t[n]=this.off(e[3*n],e[3*n+1],e[3*n+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,n){let{corners:s}=this.mesh,[r,o,a]=this.cells,l=this.place(e,0),c=this.place(t,1),h=this.place(n,2),u=Number.POSITIVE_INFINITY,d=-1;for(let y=0;y<=y_&&!(d>=0&&u<=((y-1)*this.size)**2);y++)for(let p=Math.max(h-y,0);p<=Math.min(h+y,a-1);p++)for(let m=Math.max(c-y,0);m<=Math.min(c+y,o-1);m++){let v=Math.abs(p-h)===y||Math.abs(m-c)===y;for(let T=l-y;T<=l+y;T+=v||y===0?1:2*y){if(T<0||T>=r)continue;let S=T+r*(m+o*p);for(let R=this.starts[S];R<this.starts[S+1];R++){let C=3*this.order[R],_=(s[C]-e)**2+(s[C+1]-t)**2+(s[C+2]-n)**2;_<u&&(u=_,d=C)}}}if(d<0)return y_*this.size;let f=(e-s[d])*this.normals[d]+(t-s[d+1])*this.normals[d+1]+(n-s[d+2])*this.normals[d+2],g=Math.sqrt(u);return g<=this.size?f:Math.sign(f)*g}};function lC({corners:i,triangles:e}){let t=new Float32Array(i.length);for(let n=0;n<e.length;n+=3){let[s,r,o]=[3*e[n],3*e[n+1],3*e[n+2]],[a,l,c]=[i[r]-i[s],i[r+1]-i[s+1],i[r+2]-i[s+2]],[h,u,d]=[i[o]-i[s],i[o+1]-i[s+1],i[o+2]-i[s+2]];for(let f of[s,r,o])t[f]+=l*d-c*u,t[f+1]+=c*h-a*d,t[f+2]+=a*u-l*h}for(let n=0;n<t.length;n+=3){let s=Math.hypot(t[n],t[n+1],t[n+2])||1;for(let r=0;r<3;r++)t[n+r]/=s}return t}var lu=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,n){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=n}taken(){return this.array.slice(0,this.used)}};var xl=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],op();case"print":{if(!this.response)return op();let t=cu(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:op()}case"part":{let{samples:t,code:n}=e;return{...cu({...t,values:Float32Array.from(t.values,(s,r)=>r===n?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=cu(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new au(e,this.target)),this.distance}};function op(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let i=new xl;self.addEventListener("message",e=>{let t=i.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}var hu=class{worker;local=new xl;last=Promise.resolve();constructor(e){this.worker=cC(),e.addEventListener("abort",()=>this.worker?.terminate())}ask(e){let t=this.last.then(()=>this.worker?hC(this.worker,e):uC().then(()=>this.local.answer(e)));return this.last=t.catch(()=>{}),t}};function uu(i){let e=[0,1,2].map(t=>i.range(t)[0]);return{codes:i.codes,values:i.values,shape:i.shape,pitch:i.pitch,low:e}}function cC(){try{return new Worker(URL.createObjectURL(new Blob([x_],{type:"text/javascript"})))}catch{return null}}function hC(i,e){return new Promise((t,n)=>{i.onmessage=s=>t(s.data),i.onerror=s=>n(new Error(`The surface could not be made: ${s.message}`)),i.postMessage(e)})}function uC(){return new Promise(i=>setTimeout(i,20))}var M_={id:"solid",title:"In 3D",render:i=>!(t=>i.run.volumes.some(n=>n.kind===t))("target")&&!i.run.surface?null:document.createElement("canvas").getContext("webgl2")===null?vr("This browser has no WebGL 2, so print and target cannot be shown in 3D. The slices above show the same volumes."):dC(i,()=>Ci(i,fC))};function dC({gone:i},e){let t=b("div.solid-place"),n=new IntersectionObserver(s=>{s.some(({isIntersecting:r})=>r)&&(n.disconnect(),t.replaceChildren(e()))},{rootMargin:"300px"});return n.observe(t),i.addEventListener("abort",()=>n.disconnect()),t}async function fC(i){let{volumes:e,problems:t}=await fa(i,Bi(i)),n=e.response??e.target;if(!n)throw new Error(t.join(" ")||"The run has no volume to show.");return new ap(i,e,n).element(t)}var pC=.95,v_=40,mC=120,b_=[["","Print"],["both","Print and target"],["target","Target"]],ap=class{constructor(e,t,n){this.context=e;this.volumes=t;this.grid=n;this.reported=this.thresholdOf(t);let[s,r]=bC(t.target??n,n);this.stage=new ou(s,r,e.gone),this.stage.canvas.setAttribute("aria-label","Surfaces of print and target. Arrow keys turn the view, + and − zoom, 0 looks from the front again."),this.client=new hu(e.gone)}context;volumes;grid;stage;client;legend=b("div.color-legend");note=b("p.quiet",{role:"status"});reported;newest=0;isNew=!1;isRenewing=!1;async element(e){return this.listen(["threshold"],()=>this.attempt(this.showPrint())),this.listen(["threshold","at","cut"],()=>this.showCut()),this.listen(["solid"],()=>this.attempt(this.showAll())),this.listen(["species"],()=>this.attempt(this.reload())),this.context.renewed.addEventListener("renewed",()=>this.attempt(this.renew()),{signal:this.context.gone}),await this.load(),this.attempt(this.showAll()),b("div.solid",{},...e.map(vr),b("p.quiet",{},"Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. The cut goes through the point that the planes above show."),this.controls(),this.stage.canvas,b("div.below-planes",{},this.note,this.legend))}get level(){return this.reported===null||!this.volumes.response?null:this.context.state.get("threshold")??this.reported}thresholdOf({response:e,labels:t}){let{run:n}=this.context;return so(n)===null?Pl(n,Bi(this.context),e,t)?.reported??null:null}get mode(){let e=this.context.state.get("solid");return this.level===null?"target":b_.some(([t])=>t===e)?e:""}get official(){let{run:e,state:t}=this.context,n=Bi(this.context)===""||Bi(this.context)===da(e)[0];return t.get("threshold")===null&&n&&e.surface!==null&&e.surface.triangles>0?e.surface:null}load(){let{response:e,target:t}=this.volumes;return this.client.ask({kind:"load",response:e&&uu(e),target:t&&uu(t)})}async renew(){if(this.isNew=!0,!this.isRenewing){this.isRenewing=!0;try{for(;this.isNew&&!this.context.gone.aborted;)this.isNew=!1,await this.reload()}finally{this.isRenewing=!1}}}async reload(){this.volumes=(await fa(this.context,Bi(this.context))).volumes,this.reported=this.thresholdOf(this.volumes),await this.load(),await this.showAll()}async showAll(){this.showCut(),await Promise.all([this.showPrint(),this.showTarget()])}async showPrint(){let e=++this.newest,{level:t,official:n,stage:s,note:r}=this;if(this.mode==="target"||t===null){s.remove("print"),this.legend.replaceChildren(si({keys:[["var(--solid)","target"]]})),r.textContent="";return}if(r.textContent="Making the surface…",n||await new Promise(f=>setTimeout(f,mC)),e!==this.newest)return;let{mesh:o,off_um:a}=n?await this.ofCommand(n):await this.atLevel(t);if(e!==this.newest||this.context.gone.aborted)return;let l=a?vC(a):0,c=a&&Uint32Array.from(a,f=>eo(Math.round(v_*(.5+f/(2*l)))/v_));s.mesh("print",o,c?{colors:c}:{color:Mn("--solid")});let h={scale:{low:-l,high:l,logarithmic:!1,map:eo},label:"deviation from the target, µm: blue is too small, red too large",mark:null},u=o.triangles.length===0;this.legend.replaceChildren(...u?[]:[si(a?h:{keys:[["var(--solid)","print"]]})]);let d=n?"The surface at the report’s threshold.":`The surface at a threshold of ${ce(t,3)}, from the page’s voxels.`;r.textContent=u?"At this threshold nothing is solid.":d}async ofCommand(e){let t=await this.context.store.surface(e);return{mesh:t,off_um:t.off_um}}async atLevel(e){let t=await this.client.ask({kind:"print",level:e});return{mesh:t,off_um:t.off&&t.off.map(n=>1e3*n)}}async showTarget(){if(this.mode==="")return this.stage.remove("target");let e=await this.client.ask({kind:"target"});this.context.gone.aborted||this.mode===""||this.stage.mesh("target",e,{color:Mn("--solid"),opacity:this.mode==="both"?.3:1})}showCut(){let{state:e}=this.context,t=os.indexOf(e.get("cut"));if(t<0)return this.stage.cut(null,0,null);let n=this.grid.nearest(e.get("at")??this.grid.center)[t];this.stage.cut(t,n,xC(this.volumes,t,n,this.mode==="target"?null:this.level))}controls(){let{stage:e}=this,{run:t,state:n}=this.context,s=(a,l,c)=>b("button",{type:"button",click:()=>e.look(l,c)},a),r=[["","Whole"],["x","Cut along x"],["y","Cut along y"],["z","Cut along z"]],o=Fu(t,Bi(this.context)).evaluation?.farthest?.at_xyz_mm;return b("div.controls",{},this.level!==null&&zn("Surface",b_,()=>this.mode,a=>n.set({solid:a}),a=>this.listen(["solid"],a)),zn("Cut",r,()=>n.get("cut"),a=>n.set({cut:a}),a=>this.listen(["cut"],a)),b("span.views",{},s("From the front",-60,30),s("From behind, below",120,-30),s("From above",-90,89.9)),...this.extras(),o?.length===3&&b("button",{type:"button",click:()=>n.set({at:o,cut:n.get("cut")||"y"})},"Cut at the largest deviation"))}extras(){let{stage:e,client:t}=this,{bodies:n}=this.volumes,{scene:s}=this.context.run,o=(n?gC.filter(({code:a})=>n.codes.includes(a)):[]).map(({code:a,text:l,color:c})=>{let h=async()=>e.mesh(l,await t.ask({kind:"part",samples:uu(n),code:a}),{color:Mn(c),opacity:.75});return this.attempt(h()),ua(l,!0,u=>u?this.attempt(h()):e.remove(l))});if(s&&s.walls.length>0){let[a,l]=s.z_mm,c=s.walls.map(({points:h,height_mm:u})=>({points:h,low:u?.[0]??a,high:u?.[1]??l}));o.push(ua("vial",!1,h=>h?e.walls("vial",c,Mn("--quiet")):e.remove("vial")))}return o}attempt(e){e.catch(t=>this.note.textContent=Ss(t))}listen(e,t){this.context.gone.addEventListener("abort",this.context.state.on(e,t))}},gC=[{code:Ms.insert,text:"insert",color:"--ink"},{code:Ms.dark,text:"bodies that stay dark",color:"--void"},{code:Ms.obstacle,text:"obstacles",color:"--quiet"}];function xC({response:i,target:e},t,n,s){let r=s===null?e:i,o=r?.slice(t,n);if(!r||!o)return null;let a={low:0,high:r.info.high,logarithmic:!1,map:rs},l=Mn("--solid"),c=Uint32Array.from({length:256},(u,d)=>rs(d/255));return yC(o,s??.5,u=>s===null?l:c[Math.round(255*Math.min(Math.max(yr(a,u),0),1))])}var _C=640;function yC(i,e,t){let{width:n,height:s,codes:r,values:o}=i,a=Math.max(1,Math.round(_C/Math.max(n,s))),l=new Uint32Array(n*a*s*a),c=(h,u)=>{let d=o[r[Math.min(Math.max(u,0),s-1)*n+Math.min(Math.max(h,0),n-1)]];return Number.isNaN(d)?0:d};for(let h=0,u=0;h<s*a;h++){let d=(h+.5)/a-.5,f=Math.floor(d);for(let g=0;g<n*a;g++,u++){let y=(g+.5)/a-.5,p=Math.floor(y),m=c(p,f)+(y-p)*(c(p+1,f)-c(p,f)),v=c(p,f+1)+(y-p)*(c(p+1,f+1)-c(p,f+1)),T=m+(d-f)*(v-m);T>=e&&(l[u]=t(T))}}return{...i,pixels:l,width:n*a,height:s*a,pitch:[i.pitch[0]/a,i.pitch[1]/a]}}function vC(i){let e=i.map(Math.abs).sort(),t=Math.max(e[Math.min(Math.floor(e.length*pC),e.length-1)]??1,.001),n=10**Math.floor(Math.log10(t));return([1,1.2,1.5,2,2.5,3,4,5,6,8,10].find(s=>s*n>=t*(1-1e-6))??10)*n}function bC(i,e){let{codes:t,values:n,shape:s}=i,r=n.map(u=>+(u>=.5)),[o,a]=[[...s],[-1,-1,-1]],l=0;for(let u=0;u<s[2];u++)for(let d=0;d<s[1];d++)for(let f=0;f<s[0];f++,l++)r[t[l]]!==0&&[f,d,u].forEach((g,y)=>{g<o[y]&&(o[y]=g),g>a[y]&&(a[y]=g)});let c=a[0]<0?e:i;return(a[0]<0?[[0,0,0],e.shape.map(u=>u-1)]:[o,a]).map((u,d)=>u.map((f,g)=>c.middle(g,f)+(d-.5)*c.pitch[g]))}var du={run:0,section:"",species:"",layer:"",plane:"",at:null,threshold:null,light:0,frame:0,row:null,time:null,growth:"",solid:"",cut:"",opened:null,marked:[],metric:"",x:"",y:"",plot:"",levels:""},fu=class{constructor(e=window.location){this.location=e;this.view={...du,...this.read()},window.addEventListener("hashchange",()=>this.set(this.read()))}location;view;listeners=new Set;writing=0;read(){let e=this.location.hash;return e!==""&&!e.includes("=")?{section:decodeURIComponent(e.slice(1))}:SC(e)}get(e){return this.view[e]}set(e){let t=Object.keys(e).filter(n=>!S_(this.view[n],e[n]));if(t.length!==0){this.view={...this.view,...e};for(let n of[...this.listeners])n.keys.some(s=>t.includes(s))&&n.call();this.write()}}on(e,t){let n={keys:e,call:t};return this.listeners.add(n),()=>this.listeners.delete(n)}write(){window.clearTimeout(this.writing),this.writing=window.setTimeout(()=>{let e=MC(this.view);e!==this.location.hash.replace(/^#/,"")&&history.replaceState(null,"",`#${e}`)},150)}};function MC(i){let e=[];for(let t of Object.keys(du)){let n=i[t];n===null||S_(n,du[t])||e.push(`${t}=${Array.isArray(n)?n.map(s=>+s.toFixed(4)).join(","):encodeURIComponent(String(n))}`)}return e.join("&")}function SC(i){let e=new URLSearchParams(i.replace(/^#/,"")),t={...du},n=o=>{let a=Number(e.get(o)??"0");return Number.isInteger(a)&&a>=0?a:0},s=o=>{let a=e.get(o);return a!==null&&a!==""&&Number.isFinite(Number(a))?Number(a):null};t.run=n("run"),t.light=n("light"),t.frame=n("frame");for(let o of["section","species","layer","plane","growth","solid","cut","metric","x","y","plot","levels"])t[o]=e.get(o)??"";t.threshold=s("threshold"),t.row=s("row"),t.time=s("time"),t.opened=n("opened")||null,t.marked=(e.get("marked")??"").split(",").map(Number).filter(o=>Number.isInteger(o)&&o>0);let r=e.get("at")?.split(",").map(Number)??[];return r.length===3&&r.every(Number.isFinite)&&(t.at=[r[0],r[1],r[2]]),t}function S_(i,e){return i===e||Array.isArray(i)&&Array.isArray(e)&&i.length===e.length&&i.every((t,n)=>t===e[n])}var Jo=class{constructor(e,t){this.served=e;this.run=t}served;run;cache=new Map;volume(e){return this.once(e.id,async()=>{let[t,n,s]=e.shape_zyx,r=await this.bytes("volume",e.id,t*n*s*e.bits/8);return new Tl(e,e.bits===16?new Uint16Array(r.buffer):r)})}film(e){return this.once(e.id,async()=>({info:e,values:await this.bytes("film",e.id,e.frames*e.rows*e.columns)}))}surface(e){return this.once(e.id,async()=>TC(e,await this.bytes("volume",e.id,e.vertices*8+e.triangles*12)))}async slice(e,t,n,s){let r=await fetch(`${this.served}run/${this.run}/slice/${e.id}?axis=${t}&index=${n}`,{signal:s});if(!r.ok)throw new Error(await r.text()||`the viewer answered ${r.status}`);let o=new Uint8Array(await r.arrayBuffer()),a=o.indexOf(10),l=JSON.parse(new TextDecoder().decode(o.subarray(0,a))),c=o.slice(a+1);return{...l,codes:l.bits===16?new Uint16Array(c.buffer):c}}once(e,t){let n=this.cache.get(e);return n||(n=t(),this.cache.set(e,n)),n}async bytes(e,t,n){let s;try{s=await wC(await this.packed(e,t))}catch(r){throw new Error(`The array “${t}” is damaged or missing: ${r instanceof Error?r.message:String(r)}.`)}if(s.length!==n)throw new Error(`The array “${t}” is damaged: ${s.length.toLocaleString("en")} bytes where ${n.toLocaleString("en")} are expected.`);return s}async packed(e,t){if(this.served!==null){let s=await fetch(`${this.served}run/${this.run}/${e}/${t}`);if(!s.ok)throw new Error(`the viewer answered ${s.status}`);return s.arrayBuffer()}let n=document.getElementById(`blob-${this.run}-${t}`);if(!n)throw new Error("the page has no such element");return EC(n.textContent??"")}};async function wC(i){let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));try{return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new Error("it cannot be unpacked")}}function EC(i){let e;try{e=atob(i)}catch{throw new Error("it is no base64")}let t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)t[n]=e.charCodeAt(n);return t}function TC(i,e){let t=new DataView(e.buffer),n=i.vertices,s=new Float32Array(3*n);for(let a=0;a<s.length;a++){let l=a%3;s[a]=i.low_mm[l]+t.getUint16(2*a,!0)/65535*(i.high_mm[l]-i.low_mm[l])}let r=new Float32Array(n);for(let a=0;a<n;a++)r[a]=t.getInt16(6*n+2*a,!0)/32767*i.off_um[1];let o=new Uint32Array(3*i.triangles);for(let a=0;a<o.length;a++)o[a]=t.getUint32(8*n+4*a,!0);if(o.some(a=>a>=n))throw new Error(`The array “${i.id}” is damaged: a triangle names a corner that is not there.`);return{corners:s,off_um:r,triangles:o}}var lp=[...ec.map(({id:i})=>i),"head","limits","warnings","look","solid","in-time","time","film"],cp=PC([Kp,M_,$p,Hp,...d0]),AC=["look","solid"],w_=["history","histories"],CC=700,RC=6e3;function PC(i){let e=t=>(lp.indexOf(t.id)+lp.length+1)%(lp.length+1);return[...i].sort((t,n)=>e(t)-e(n))}var hp=class{constructor(e,t){this.data=e;this.app=t;this.stores=e.runs.map((n,s)=>new Jo(e.served,s)),this.state.on(["run"],()=>this.draw()),this.progress=Xp(e,{row:n=>this.grow(n),replaced:n=>{this.replace(n).catch(s=>console.warn(String(s)))},ended:()=>this.redraw(["head"])}),this.sweep=e.sweep&&new lc(e,e.sweep,this.state,n=>this.open(n)),this.draw(),this.stayAt(this.state.get("section")||(this.state.get("opened")===null?"":"opened"))}data;app;state=new fu;progress;stores;ends=new Map;contexts=new Map;redrawing=0;sweep;opened=null;stayAt(e){if(e==="")return;Qs(e);let t=new ResizeObserver(()=>document.getElementById(e)?.scrollIntoView()),n=()=>t.disconnect();t.observe(this.app),window.setTimeout(n,RC);for(let s of["wheel","pointerdown","keydown","touchstart"])window.addEventListener(s,n,{once:!0,passive:!0})}get index(){return this.sweep?this.opened:this.data.runs.length===0?null:Math.min(this.state.get("run"),this.data.runs.length-1)}async open(e){let t=this.begin("opening");if(this.opened!==null&&(this.opened=null,this.draw()),e===null)return;let n=await qp(this.data,e),{runs:s}=await Hu(this.data);t.aborted||(this.data.runs.push(...s.slice(this.data.runs.length)),this.stores=this.data.runs.map((r,o)=>this.stores[o]??new Jo(this.data.served,o)),this.opened=n,this.draw())}draw(){for(let r of cp)this.ends.get(r.id)?.abort();let e=cp.flatMap(r=>{let o=this.mount(r);return o?[{section:r,element:o}]:[]}),t=e.map(({section:r})=>r).filter(({title:r})=>r!==""),n=Kg([...this.sweep?.entries??[],...t],this.state,this.begin("nav")),s=[this.progress,...this.sweep?.sections??[]].filter(r=>r!==null);for(let r of[...this.app.children])s.includes(r)||r.remove();this.app.append(...s.filter(r=>!r.isConnected),...e.map(({element:r})=>r)),this.progress?this.progress.after(n):this.app.prepend(n),this.index===null&&!this.sweep&&this.app.append(b("p.problem",{},"There is no run to show."))}begin(e){this.ends.get(e)?.abort();let t=new AbortController;return this.ends.set(e,t),t.signal}mount(e){let{index:t,state:n,sweep:s}=this;if(t===null)return null;let r=this.data.runs[t],[o,a]=s?[{...this.data,runs:[r]},[this.stores[t]]]:[this.data,this.stores],l={data:o,run:r,index:s?0:t,state:n,store:this.stores[t],stores:a,gone:this.begin(e.id),renewed:new EventTarget};this.contexts.set(e.id,l);let c;try{c=e.render(l)}catch(h){c=b("p.problem",{role:"alert"},`This section could not be drawn: ${String(h)}`)}return c===null?null:b("section",{id:e.id,"aria-label":e.title||null},e.title!==""&&b("h2",{},e.title),c)}grow(e){this.redrawing!==0||e!==this.index&&this.data.runs.length===1||(this.redrawing=window.setTimeout(()=>{this.redrawing=0,this.redraw(w_)},CC))}async replace(e){let t=await Hu(this.data);if(this.data.runs[e]=t.runs[e],this.stores[e]=new Jo(this.data.served,e),e!==this.index&&this.data.runs.length===1)return;if(t.runs[e].state!=="running")return this.draw();let[n,s]=[0,1].map(r=>AC.filter(o=>document.getElementById(o)===null==(r===1)));this.redraw([...w_,...s]);for(let r of n)this.renew(r,e)}renew(e,t){let n=this.contexts.get(e);!n||t!==this.index||(Object.assign(n,{run:this.data.runs[t],store:this.stores[t],stores:this.stores}),n.renewed.dispatchEvent(new Event("renewed")))}redraw(e){let t=document.activeElement?.getAttribute("aria-label")??null;for(let n of cp.filter(({id:s})=>e.includes(s))){let s=document.getElementById(n.id),r=this.mount(n);if(s&&r)s.replaceWith(r);else if(r)return this.draw()}t!==null&&window.setTimeout(()=>document.querySelector(`[aria-label="${CSS.escape(t)}"]`)?.focus({preventScroll:!0}),50)}};function LC(i){let e="tomolith.page/2";if(i?.schema!==e)throw new Error(`their schema is “${i?.schema??"missing"}”; this page shows “${e}”.`);if(!Array.isArray(i.runs))throw new Error("the list of runs is missing.");return i}function IC(){let i=document.getElementById("app"),e=document.getElementById("data")?.textContent;if(i)try{new hp(LC(JSON.parse(e??"")),i)}catch(t){i.replaceChildren(b("p.problem",{role:"alert"},`The data of this page could not be read: ${t instanceof Error?t.message:String(t)}`))}}IC();})();
