"use strict";(()=>{function v(n,e={},...t){let[i,...s]=n.split("."),r=document.createElement(i);return s.length>0&&(r.className=s.join(" ")),wp(r,e),Ep(r,t),r}function wt(n,e={},...t){let i=document.createElementNS("http://www.w3.org/2000/svg",n);return wp(i,e),Ep(i,t),i}function Ws(n){let e=document.createDocumentFragment();return n.split("`").forEach((t,i)=>{t!==""&&e.append(i%2===1?v("code",{},t):t)}),e}function wp(n,e){for(let[t,i]of Object.entries(e))i==null||i===!1||(typeof i=="function"?n.addEventListener(t,i):n.setAttribute(t,i===!0?"":String(i)))}function Ep(n,e){for(let t of e)t!=null&&t!==!1&&n.append(t)}var A_=[4456788,4727925,4277383,3497869,2783374,2199948,2271364,4505456,8048977,12443430,16639781],C_=[4,1444665,4328040,6952814,9643623,12334932,14504250,15955993,16557322,16176966,16580516],R_=[1922736,7050966,13883614,15177347,13055519];function Tp(n,e=255){return(e<<24|(n&255)<<16|n&65280|n>>16)>>>0}function ml(n){return`rgb(${n&255} ${n>>8&255} ${n>>16&255} / ${((n>>>24)/255).toFixed(3)})`}function _u(n,e){let t=Math.min(Math.max(e,0),1)*(n.length-1),i=Math.min(Math.floor(t),n.length-2),s=r=>{let[o,a]=[n[i]>>r&255,n[i+1]>>r&255];return Math.round(o+(t-i)*(a-o))<<r};return Tp(s(16)|s(8)|s(0))}var is=n=>_u(A_,n),yu=n=>_u(C_,n),Kr=n=>_u(R_,n);function Jr(n){return[(n&255)/255,(n>>8&255)/255,(n>>16&255)/255]}function kn(n){let e=getComputedStyle(document.documentElement).getPropertyValue(n).trim();return Tp(Number.parseInt(e.slice(1),16)||0)}function gr(n,e){return(n&16777215|Math.round(255*e)<<24)>>>0}function xr(n,e){let{low:t,high:i,logarithmic:s}=n;return i>t?s?Math.log(Math.max(e,t)/t)/Math.log(i/t):(e-t)/(i-t):0}function gl(n,e){return Uint32Array.from(n,t=>Number.isNaN(t)?0:e.map(xr(e,t)))}var P_={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"},In="–";function de(n){return typeof n=="number"&&Number.isFinite(n)}function xl(n){return"10"+[...String(n)].map(e=>P_[e]??e).join("")}function le(n,e){if(!de(n))return In;if(n===0)return"0";let t=Math.abs(n).toExponential(Math.max(e-1,0)),[i="0",s="0"]=t.split("e"),r=Number(s),o=n<0?"−":"";return r>=-3&&r<6?o+vu(Number(t).toFixed(Math.max(e-1-r,0))):o+(vu(i)==="1"?xl(r):`${vu(i)}·${xl(r)}`)}function ia(n,e){for(let t=e;t<7;t++){let i=n.map(r=>le(r,t));if(n.every((r,o)=>n.every((a,l)=>l>=o||r===a||i[o]!==i[l])))return i}return n.map(t=>le(t,7))}function Ai(n){if(!de(n))return In;let e=Math.round(n);return e<60?`${le(n,3)} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e/60)%60} min`}function Xs(n){return n==="mm"?{unit:"µm",factor:1e3}:n.startsWith("mm (")?{unit:"mm",factor:1}:{unit:n==="response"?"":n,factor:1}}function an(n,e,t=3){return de(n)?e===""?le(n,t):`${le(n,t)} ${e}`:In}function _l(n,e,t){if(e!=="mm"||!de(n)||!de(t)||t<=0)return"";let i=le(n/t,2);return i==="1"?"1 voxel":`${i} voxels`}function vu(n){let e=n.includes(".")?n.replace(/\.?0+$/,""):n,[t="",i]=e.split("."),s=t.replace(/\B(?=(\d{3})+$)/g,",");return i===void 0?s:`${s}.${i}`}function Ci(n,e){let t=v("div",{"aria-busy":"true"},v("p.quiet",{},"Unpacking the volumes…"));return e(n).then(i=>t.replaceChildren(i)).catch(i=>t.replaceChildren(jr(sa(i)))).finally(()=>t.removeAttribute("aria-busy")),t}function jr(n){return v("p.problem",{role:"alert"},n)}function sa(n){return n instanceof Error?n.message:String(n)}function ra(n,e,t,i=null){return v("label",{},v("input",{type:"checkbox",checked:e,change:r=>t(r.target.checked)}),i,n)}function Kn(n,e,t,i,s){let r=e.map(([a,l])=>({value:a,button:v("button",{type:"button",click:()=>i(a)},l)})),o=()=>r.forEach(({value:a,button:l})=>l.setAttribute("aria-pressed",String(a===t())));return s(o),o(),v("div.choice",{role:"group","aria-label":n},...r.map(({button:a})=>a))}function si(n){if("keys"in n)return v("p.color-keys",{},...n.keys.map(([o,a])=>v("span",{},v("i.tile",{style:`background: ${o}`}),a)));let{scale:e,label:t,mark:i}=n,s=Array.from({length:17},(o,a)=>ml(e.map(a/16))).join(", "),r=i===null||!Number.isFinite(i)?null:(i-e.low)/(e.high-e.low);return v("div.color-scale",{},v("span",{},le(e.low,3)),v("span.bar",{style:`background: linear-gradient(to right, ${s})`},r!==null&&r>=0&&r<=1&&v("i",{style:`left: ${100*r}%`,title:"gel threshold"})),v("span",{},le(e.high,3)),v("span.quiet",{},e.logarithmic?`${t}, logarithmic`:t))}function ss(n,e,t){let i=n.volumes.filter(s=>s.kind===e);return i.find(s=>t!==""&&s.species===t)??i[0]}function oa(n){return n.volumes.filter(({kind:e,species:t})=>e==="response"&&t!==null).map(({species:e})=>e??"")}function Bi({run:n,state:e}){let t=e.get("species");return oa(n).includes(t)?t:""}async function aa(n,e){let{run:t,store:i}=n,s=[],r=async f=>{if(!f)return null;try{return await i.volume(f)}catch(g){return s.push(sa(g)),null}},o=f=>r(ss(t,f,e)),a=t.volumes.filter(({kind:f})=>f==="cure_time"||f==="property"),[l,c,h,u,...d]=await Promise.all([o("response"),o("target"),o("labels"),o("bodies"),...a.map(r)]);return{volumes:{response:l,target:c,labels:h,bodies:u,others:d.filter(f=>f!==null)},problems:s}}var rs=["x","y","z"],Jn={0:[1,2],1:[0,2],2:[0,1]},vs={outside:0,void:1,part:2},$s={none:0,dark:1,insert:2,obstacle:3},la=class{constructor(e,t,i){this.shape=e;this.pitch=t;this.center=i}shape;pitch;center;range(e){let t=this.shape[e]*this.pitch[e]/2;return[this.center[e]-t,this.center[e]+t]}index(e,t){return Math.floor((t-this.range(e)[0])/this.pitch[e]+1e-6)}middle(e,t){return this.range(e)[0]+(t+.5)*this.pitch[e]}},yl=class extends la{constructor(t,i){let[s,r,o]=t.shape_zyx;super([o,r,s],[t.pitch_mm,t.pitch_mm,t.height_mm],t.center_xyz_mm);this.info=t;this.codes=i;this.values=bu(t.bits,t.low,t.high,t.nan)}info;codes;values;at(t){let[i,s,r]=[0,1,2].map(h=>this.index(h,t[h])),[o,a,l]=this.shape;if(i<0||s<0||r<0||i>=o||s>=a||r>=l)return null;let c=this.values[this.codes[(r*a+s)*o+i]];return Number.isNaN(c)?null:c}slice(t,i){let s=this.index(t,i);if(s<0||s>=this.shape[t])return null;let[r,o]=Jn[t],[a,l]=[this.shape[r],this.shape[o]],[c,h]=this.shape,u=[1,c,c*h],d=this.info.bits===16?new Uint16Array(a*l):new Uint8Array(a*l);for(let f=0;f<l;f++){let g=s*u[t]+(l-1-f)*u[o];for(let x=f*a;x<(f+1)*a;x++,g+=u[r])d[x]=this.codes[g]}return{axis:t,width:a,height:l,codes:d,values:this.values,pitch:[this.pitch[r],this.pitch[o]],corner:[this.range(r)[0],this.range(o)[1]]}}};function bu(n,e,t,i){let s=2**n,r=s-(i===null?1:2),o=Float32Array.from({length:s},(a,l)=>e+l/r*(t-e));return i!==null&&(o[i]=Number.NaN),o}function wu({run:n,state:e,store:t},i,s,r,o){let a=v("div"),l=v("div"),c=v("p.quiet",{role:"status"}),h=i.lights[s]?.frames??[],u=h.length-1,d=v("input",{type:"range",min:0,max:u,step:1,"aria-label":"Frame",input:()=>e.set({frame:Number(d.value)})}),f=null,g=()=>{let m=r?.()??null,b=Math.min(e.get("frame"),u);d.value=String(b);let C=m===null?h[b]??null:I_(h,m);a.replaceChildren(D_(i,C?.rays??[],f)),l.replaceChildren(N_(i,C?.rays??[]));let S=C!==null&&m!==null&&Mu(C.angle_deg,m)>.05,R=C===null?"":`Light from ${le(C.angle_deg,4)}°${S?", the nearest frame whose rays the page has":""}.`;c.textContent=`${R}${L_(i)}`.trim()};g();let x=async()=>{f=await O_(n,t,e.get("at")?.[2]??null),g()};x().catch(()=>{});let p=[e.on(["frame"],g),e.on(["at"],()=>{x().catch(()=>{})})];return o.addEventListener("abort",()=>p.forEach(m=>m())),v("div.paths",{},v("h3",{},"Where the light goes"),c,r===null&&u>0&&v("div.path-frame",{},v("label",{},"Frame",d)),v("div.path-views",{},v("figure",{},v("figcaption",{},"From above"),a),v("figure",{},v("figcaption",{},"From the side, light from the left"),l,v("p.color-keys",{},vl("--void","light in the resin"),vl("--quiet","light outside"),vl("--solid","part"),i.lit_radius_mm!==null&&vl("--accent","radius that every frame lights")))))}function vl(n,e){return v("span",{},v("i.stroke",{style:`background: var(${n})`}),e)}function L_({lit_radius_mm:n,part_radius_mm:e}){if(n===null)return"";let[t,i]=[le(n,3),le(e,3)];return n>=e?` Every frame lights all within ${t} mm of the axis; the part's sides reach out to ${i} mm.`:` Every frame lights only what lies within ${t} mm of the axis, but the part's sides reach out to ${i} mm.`}function I_(n,e){return n.reduce((t,i)=>t!==null&&Mu(t.angle_deg,e)<=Mu(i.angle_deg,e)?t:i,null)}function Mu(n,e){let t=Math.abs(n-e)%360;return Math.min(t,360-t)}function D_(n,e,t){let i=Math.max(...n.walls.flatMap(({points:r})=>r.map(([o,a])=>Math.hypot(o,a))),n.part_radius_mm)*1.22,s=Ap([-i,i],[-i,i],"Light path from above");for(let r of n.walls)s.append(bl(r.points,"wall",r.name));t?s.append(wt("image",{href:t.url,x:t.left,y:-t.top,width:t.width,height:t.height,preserveAspectRatio:"none"})):s.append(wt("circle",{class:"part",r:n.part_radius_mm}));for(let r of n.obstacles)s.append(bl(r.points,"obstacle",r.name));return n.lit_radius_mm!==null&&s.append(wt("circle",{class:"lit",r:n.lit_radius_mm},wt("title",{},"radius that every frame lights"))),s.append(...Cp(e.map(r=>({points:r.points.map(([o,a])=>[o,a]),from:r.resin_from})),i)),s}function N_(n,e){let t=e[e.length>>1]?.points??[],[i,s]=[t[0]??[-1,0,0],t[t.length-1]??[1,0,0]],r=Math.hypot(s[0]-i[0],s[1]-i[1])||1,[o,a]=[(s[0]-i[0])/r,(s[1]-i[1])/r],l=([x,p])=>x*o+p*a,c=Math.max(...n.walls.flatMap(({points:x})=>x.map(([p,m])=>Math.hypot(p,m))),n.part_radius_mm)*1.22,[h,u]=n.z_mm,d=.25*(u-h)+.05*c,f=Ap([-c,c],[h-d,u+d],"Light path from the side");for(let x of n.walls){let p=x.points.map(l),[m,b]=[Math.min(...p),Math.max(...p)],[C,S]=x.height_mm??[h-2*d,u+2*d];f.append(bl([[m,C],[b,C],[b,S],[m,S]],"wall",x.name))}let g=n.part_radius_mm;if(f.append(bl([[-g,h],[g,h],[g,u],[-g,u]],"part","part")),n.lit_radius_mm!==null)for(let x of[-n.lit_radius_mm,n.lit_radius_mm])f.append(wt("line",{class:"lit",x1:x,x2:x,y1:-u-d,y2:-h+d}));return f.append(...Cp(e.map(x=>({points:x.points.map(p=>[l(p),p[2]]),from:x.resin_from})),c)),f}function Ap(n,e,t){return wt("svg",{class:"path-view",viewBox:`${n[0]} ${-e[1]} ${n[1]-n[0]} ${e[1]-e[0]}`,role:"img","aria-label":t})}function bl(n,e,t){return wt("path",{class:e,d:`${Su(n)}Z`},wt("title",{},t))}function Su(n){return`M${n.map(([e,t])=>`${e.toFixed(4)},${(-t).toFixed(4)}`).join("L")}`}function Cp(n,e){return n.flatMap(({points:t,from:i})=>{let s=t.slice(0,i+1);return s.length>1&&(s[0]=U_(s[0],s[1],e)),[wt("path",{class:"ray",d:Su(s)}),t.length>i+1&&wt("path",{class:"ray resin",d:Su(t.slice(i))})].filter(r=>r!==!1)})}function U_([n,e],[t,i],s){let r=Math.abs(n)>Math.abs(e)?Math.abs(n):Math.abs(e);if(r<=s)return[n,e];let o=Math.max(Math.abs(t),Math.abs(i)),a=r>o?Math.min((r-s)/(r-o),1):0;return[n+a*(t-n),e+a*(i-e)]}async function O_(n,e,t){let i=ss(n,"target","");if(!i)return null;let s=await e.volume(i),r=s.slice(2,t??(s.range(2)[0]+s.range(2)[1])/2);if(!r)return null;let o=kn("--solid"),a=s.info.high,l=Uint32Array.from(r.values,f=>gr(o,Math.min(Math.max(f/a,0),1)*.75)),c=new Uint32Array(r.codes.length);for(let f=0;f<c.length;f++)c[f]=l[r.codes[f]];let h=document.createElement("canvas");[h.width,h.height]=[r.width,r.height],h.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(c.buffer),r.width,r.height),0,0);let[u,d]=Jn[2];return{url:h.toDataURL(),left:s.range(u)[0],top:s.range(d)[1],width:r.width*r.pitch[0],height:r.height*r.pitch[1]}}var Ip={id:"film",title:"Patterns and light",render:n=>{let{run:e,state:t,gone:i}=n,s=e.films.length>0?e.films.map(({light:u})=>u):(e.scene?.lights??[]).map(({name:u})=>u);if(s.length===0)return null;let r=()=>Math.min(t.get("light"),s.length-1),o=v("div"),a=new AbortController,l=()=>{a.abort(),a=new AbortController;let{signal:u}=a,d=e.films.length===0&&e.scene?wu(n,e.scene,r(),null,u):null;o.replaceChildren(d??Ci(n,()=>k_(n,r(),u)))},c=t.on(["light"],()=>{t.set({frame:0,row:null}),l()});i.addEventListener("abort",()=>{c(),a.abort()}),l();let h=s.map((u,d)=>[String(d),u||`light ${d+1}`]);return v("div",{},h.length>1&&Kn("Light",h,()=>String(r()),u=>t.set({light:Number(u)}),u=>i.addEventListener("abort",t.on(["light"],u))),o)}},F_=8;async function k_({run:n,state:e,store:t},i,s){let r=n.films[i],{values:o}=await t.film(r),a=new Tu({info:r,values:o}),l=r.frames-1,c=()=>Math.min(e.get("frame"),l),h=()=>Math.min(e.get("row")??r.rows>>1,r.rows-1),u=v("output"),d=v("input",{type:"range",min:0,max:l,step:1,"aria-label":"Frame",input:E=>e.set({frame:Number(E.target.value)})}),f=v("input",{type:"range",min:0,max:r.rows-1,step:1,"aria-label":"Row of the sinogram",input:E=>e.set({row:Number(E.target.value)})}),g=v("output.quiet"),x=v("output.quiet"),p=v("input",{type:"range",min:0,max:5,step:.25,value:0,"aria-label":"Stretch of the brightness"}),m=v("button",{type:"button","aria-label":"Play the film"},"Play"),b=v("div.color-legend"),C=()=>{let[E,B]=[c(),h()];[d.value,f.value]=[String(E),String(B)];let U=`frame ${E*r.every+1} of ${r.of[0]}, ${Eu(r.angles_deg[E])}`;u.textContent=U,d.setAttribute("aria-valuetext",U),a.sinogram.setAttribute("aria-valuenow",String(E)),a.sinogram.setAttribute("aria-valuetext",U),g.textContent=`row ${B*r.binned+1} of ${r.of[1]} from the top`,a.draw(E,B)},S=()=>{a.gain=2**Number(p.value),x.textContent=a.gain===1?"as shown":`${le(a.gain,3)} ×`,b.replaceChildren(si({scale:{low:0,high:r.full_scale/a.gain,logarithmic:!1,map:yu},label:"pattern value",mark:null})),a.draw(c(),h())};p.addEventListener("input",S,{signal:s}),a.choose=E=>e.set({frame:Math.min(Math.max(E,0),l)}),a.chooseRow=E=>e.set({row:Math.min(Math.max(E,0),r.rows-1)}),B_(m,r,s,()=>e.set({frame:(c()+1)%r.frames}));let R=e.on(["frame","row"],C);s.addEventListener("abort",()=>{R(),a.end()}),C(),S();let A=[r.every>1&&`every ${z_(r.every)} frame`,r.binned>1&&`means of ${r.binned} × ${r.binned} pixels`].filter(Boolean).join(", "),y=n.scene&&wu({run:n,state:e,store:t},n.scene,i,()=>r.angles_deg[c()],s);return v("div.film",{},v("p.quiet",{},`${r.of[0]} frames of ${r.of[2]} × ${r.of[1]} pixels.${A?` Shown: ${A}.`:""} Click in the sinogram to choose a frame, in the frame to choose the row of the sinogram.`),v("div.film-views",{},v("figure",{},v("figcaption",{},v("span",{},"Frame"),u),a.frame),v("figure",{},v("figcaption",{},v("span",{},"Sinogram"),g),a.sinogram,v("div.film-axis.quiet",{},v("span",{},Eu(r.angles_deg[0])),v("span",{},"angle of the frame"),v("span",{},Eu(r.angles_deg[l]))))),v("div.film-controls",{},m,v("label",{},"Frame",d),v("label",{},"Row",f),v("label",{},"Stretch",p,x),b),y)}var Tu=class{constructor(e){this.film=e;let{info:t}=e;this.frame.style.aspectRatio=`${t.columns*t.pitch_mm[0]} / ${t.rows*t.pitch_mm[1]}`,this.sinogram.setAttribute("aria-valuemax",String(t.frames-1));for(let s of[this.frame,this.sinogram])this.watcher.observe(s);let i=(s,r)=>{let o=a=>{if(a.buttons!==1)return;let l=s.getBoundingClientRect();r((a.clientX-l.left)/l.width,(a.clientY-l.top)/l.height)};s.addEventListener("pointerdown",o),s.addEventListener("pointermove",o)};i(this.sinogram,s=>this.choose(Math.floor(s*t.frames))),i(this.frame,(s,r)=>this.chooseRow(Math.floor(r*t.rows))),this.sinogram.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10,Home:-t.frames,End:t.frames};s.key in r&&(s.preventDefault(),this.choose(this.shown[0]+r[s.key]))})}film;frame=v("canvas");sinogram=v("canvas",{tabindex:0,role:"slider","aria-label":"Sinogram: arrow keys choose the frame","aria-valuemin":0});gain=1;choose=()=>{};chooseRow=()=>{};image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.draw(...this.shown));shown=[0,0];painted="";end(){this.watcher.disconnect()}draw(e,t){this.shown=[e,t],this.drawFrame(e,t),this.drawSinogram(e,t)}drawFrame(e,t){let{info:i,values:s}=this.film,r=Pp(this.frame);if(!r)return;let o=i.rows*i.columns,a=document.createElement("canvas");Rp(a,i.columns,i.rows,this.palette(),s.subarray(e*o,(e+1)*o)),r.drawImage(a,0,0,r.canvas.width,r.canvas.height),Lp(r,"y",(t+.5)/i.rows)}drawSinogram(e,t){let{info:i,values:s}=this.film,r=Pp(this.sinogram);if(!r)return;let o=`${t} ${this.gain}`;if(this.painted!==o){this.painted=o;let a=new Uint8Array(i.frames*i.columns);for(let l=0;l<i.frames;l++){let c=(l*i.rows+t)*i.columns;for(let h=0;h<i.columns;h++)a[h*i.frames+l]=s[c+h]}Rp(this.image,i.frames,i.columns,this.palette(),a)}r.drawImage(this.image,0,0,r.canvas.width,r.canvas.height),Lp(r,"x",(e+.5)/i.frames)}palette(){return Uint32Array.from({length:256},(e,t)=>yu(t/255*this.gain))}};function Rp(n,e,t,i,s){let r=new Uint32Array(e*t);for(let o=0;o<r.length;o++)r[o]=i[s[o]];[n.width,n.height]=[e,t],n.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(r.buffer),e,t),0,0)}function Pp(n){let e=window.devicePixelRatio||1,[t,i]=[Math.round(n.clientWidth*e),Math.round(n.clientHeight*e)];if(t===0||i===0)return null;(n.width!==t||n.height!==i)&&([n.width,n.height]=[t,i]);let s=n.getContext("2d");return s&&(s.imageSmoothingEnabled=!1),s}function Lp(n,e,t){let{width:i,height:s}=n.canvas,r=Math.max(Math.round(window.devicePixelRatio||1),1);for(let[o,a]of[["rgb(0 0 0 / 0.5)",r],["rgb(255 255 255 / 0.8)",0]])n.fillStyle=o,e==="x"?n.fillRect(Math.round(t*i)+a,0,r,s):n.fillRect(0,Math.round(t*s)+a,i,r)}function B_(n,e,t,i){let s=0,r=()=>{window.clearInterval(s),s=0,n.textContent="Play",n.setAttribute("aria-label","Play the film")};n.addEventListener("click",()=>{if(s!==0)return r();s=window.setInterval(i,Math.max(1e3*F_/e.frames,40)),n.textContent="Pause",n.setAttribute("aria-label","Pause the film")}),t.addEventListener("abort",r)}function Eu(n){return`${le(n,4)}°`}function z_(n){return n===2?"2nd":n===3?"3rd":`${n}th`}var V_=[[],[3,0],[0,1],[3,1],[1,2],[3,0,1,2],[0,2],[3,2],[2,3],[2,0],[0,1,2,3],[2,1],[1,3],[1,0],[0,3],[]];function Ml(n,e){let{width:t,height:i,codes:s,values:r}=n,o=e-1e6,a=(h,u)=>{if(h<0||u<0||h>=t||u>=i)return o;let d=r[s[u*t+h]];return Number.isNaN(d)?o:d},l=new Float32Array(4096),c=0;for(let h=-1;h<i;h++){let[u,d]=[a(-1,h),a(-1,h+1)];for(let f=-1;f<t;f++){let[g,x]=[a(f+1,h),a(f+1,h+1)],p=(u>=e?1:0)|(g>=e?2:0)|(x>=e?4:0)|(d>=e?8:0);if(p!==0&&p!==15){if(c+8>l.length){let m=new Float32Array(2*l.length);m.set(l),l=m}for(let m of V_[p]){let[b,C]=m===0?[u,g]:m===1?[g,x]:m===2?[d,x]:[u,d],S=(e-b)/(C-b);l[c++]=f+.5+(m===1?1:m===3?0:S),l[c++]=h+.5+(m===0?0:m===2?1:S)}}u=g,d=x}}return l.slice(0,c)}var H_={2:"Top view, x–y",1:"Front view, x–z",0:"Side view, y–z"},Dp=24,G_=.62,Ys=class{constructor(e){this.options=e;let{state:t,signal:i,grid:s}=e;this.center=[...s.center];let r=t.on(["at"],()=>this.redraw(!1));i.addEventListener("abort",r);let o=()=>this.redraw(!0);window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",o,{signal:i})}options;element=v("div.planes");views=[];zoom=1;center;show(e){this.views.forEach(h=>h.end()),this.views=e.map(h=>new Au(this,h));let{grid:t}=this.options,i=e.map(({axis:h})=>`minmax(0, ${qs(t,Jn[h][0]).toFixed(4)}fr)`);this.element.style.setProperty("--columns",i.join(" "));let[s,r,o]=[0,1,2].map(h=>qs(t,h)),a=e.length===3&&new Set(e.map(({axis:h})=>h)).size===3;this.element.classList.toggle("flat",a&&o<G_*Math.min(s,r));let[l,c]=Jn[e[0]?.axis??2];this.element.classList.toggle("pairs",!a&&e.length===4&&qs(t,l)>1.5*qs(t,c)),this.element.replaceChildren(...this.views.map(h=>h.element))}redraw(e){for(let t of this.views)t.redraw(e)}at(){return this.options.state.get("at")??this.options.grid.center}moveTo(e){let{state:t,grid:i}=this.options,s=this.at().map((r,o)=>{let[a,l]=i.range(o);return Math.min(Math.max(e[o]??r,a+1e-4),l-1e-4)});t.set({at:s})}zoomBy(e,t){let i=Math.min(Math.max(this.zoom*e,1),Dp),s=1-this.zoom/i;this.center=this.center.map((r,o)=>r+(t[o]-r)*s),this.zoom=i,i===1&&(this.center=[...this.options.grid.center]),this.keepWithin(),this.redraw(!1)}panBy(e,t){this.center[e]+=t,this.keepWithin(),this.redraw(!1)}keepWithin(){let{grid:e}=this.options;this.center=this.center.map((t,i)=>{let[s,r]=e.range(i),o=(r-s)/2/this.zoom;return Math.min(Math.max(t,s+o),r-o)})}};function qs(n,e){return n.range(e)[1]-n.range(e)[0]}var W_=90,Au=class{constructor(e,t){this.planes=e;this.shown=t;let{grid:i}=e.options,{axis:s}=t,r=t.title??H_[s],o=i.shape[s]-1;this.slider=v("input",{type:"range",min:0,max:o,step:1,"aria-label":`${r}: ${rs[s]} of the slice`}),this.canvas.setAttribute("aria-label",`${r}: slice along ${rs[s]}`),this.canvas.setAttribute("aria-valuemin","0"),this.canvas.setAttribute("aria-valuemax",String(o));let[a,l]=Jn[s];this.canvas.style.aspectRatio=`${qs(i,a)} / ${qs(i,l)}`,this.element=v("figure.plane",{},v("figcaption",{},v("span",{},r),this.place),this.canvas,this.slider),this.listen(),this.watcher.observe(this.canvas)}planes;shown;element;canvas=v("canvas",{tabindex:0,role:"slider","aria-orientation":"horizontal"});slider;place=v("output.place");image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.redraw(!1));picture=null;outlines=[];painted=-1;frame=0;turned=0;end(){this.watcher.disconnect(),cancelAnimationFrame(this.frame)}redraw(e){e&&(this.painted=-1),this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0,this.draw()}))}get index(){let{grid:e}=this.planes.options,{axis:t}=this.shown;return Math.min(Math.max(e.index(t,this.planes.at()[t]),0),e.shape[t]-1)}step(e){let{grid:t}=this.planes.options,{axis:i}=this.shown;this.planes.moveTo({[i]:t.middle(i,this.index+e)})}paint(){let{grid:e}=this.planes.options,{axis:t,layer:i,outlines:s}=this.shown,r=this.index;if(this.painted===r)return;this.painted=r;let o=e.middle(t,r),a=this.picture;if(this.picture=i.picture(t,o),this.outlines=s?.(t,o)??[],this.picture&&this.picture!==a){let{width:c,height:h,pixels:u}=this.picture;[this.image.width,this.image.height]=[c,h],this.image.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(u.buffer),c,h),0,0)}let l=`${rs[t]} = ${Cu(o)} mm`;this.place.textContent=`${l} · ${r+1} of ${e.shape[t]}`,this.slider.value=String(r),this.slider.setAttribute("aria-valuetext",l),this.canvas.setAttribute("aria-valuenow",String(r)),this.canvas.setAttribute("aria-valuetext",l)}draw(){this.paint();let e={width:this.canvas.clientWidth,height:this.canvas.clientHeight},t=this.canvas.getContext("2d");if(!t||e.width===0)return;let i=window.devicePixelRatio||1,[s,r]=[Math.round(e.width*i),Math.round(e.height*i)];(this.canvas.width!==s||this.canvas.height!==r)&&([this.canvas.width,this.canvas.height]=[s,r]),t.setTransform(1,0,0,1,0,0),t.clearRect(0,0,s,r),t.imageSmoothingEnabled=!1;let{x:o,y:a}=this.scale(s,r);if(this.picture){let{corner:c,pitch:h}=this.picture,[u,d]=[o(c[0]),a(c[1])];t.drawImage(this.image,u,d,o(c[0]+this.picture.width*h[0])-u,a(c[1]-this.picture.height*h[1])-d)}let l=getComputedStyle(this.canvas);for(let c of this.outlines)X_(t,c,o,a,i,l.getPropertyValue(c.color).trim()||c.color);this.cross(t,o,a,s,r,i),this.ruler(t,s,r,i)}scale(e,t){let{grid:i}=this.planes.options,{zoom:s,center:r}=this.planes,[o,a]=Jn[this.shown.axis],l=e/qs(i,o)*s;return{perMm:l,x:c=>e/2+(c-r[o])*l,y:c=>t/2-(c-r[a])*l,back:(c,h)=>{let u=this.planes.at(),d=[u[0],u[1],u[2]];return d[o]=r[o]+(c-e/2)/l,d[a]=r[a]-(h-t/2)/l,d}}}cross(e,t,i,s,r,o){let a=this.planes.at(),[l,c]=Jn[this.shown.axis],[h,u]=[Math.round(t(a[l])),Math.round(i(a[c]))];for(let[d,f]of[["rgb(0 0 0 / 0.35)",o],["rgb(255 255 255 / 0.65)",0]])e.fillStyle=d,e.fillRect(h+f,0,o,r),e.fillRect(0,u+f,s,o)}ruler(e,t,i,s){if(i<W_*s)return;let{perMm:r}=this.scale(t,i),o=$_(.3*t/r),[a,l]=[12*s,i-12*s],c=o<1?`${Math.round(o*1e3)} µm`:`${o} mm`;e.font=`${11*s}px system-ui, sans-serif`;let h=Math.max(o*r,e.measureText(c).width);e.fillStyle="rgb(0 0 0 / 0.5)",e.beginPath(),e.roundRect(a-6*s,l-20*s,h+12*s,27*s,5*s),e.fill(),e.fillStyle="#fff",e.fillRect(a,l-s,o*r,2*s),e.fillText(c,a,l-6*s)}pointOf(e){let t=this.canvas.getBoundingClientRect();return this.scale(t.width,t.height).back(e.clientX-t.left,e.clientY-t.top)}listen(){let{planes:e,canvas:t}=this,{signal:i,hover:s}=e.options,[r,o]=Jn[this.shown.axis];this.slider.addEventListener("input",()=>this.step(Number(this.slider.value)-this.index),{signal:i}),t.addEventListener("keydown",l=>this.key(l),{signal:i}),t.addEventListener("wheel",l=>{let c=l.ctrlKey||l.metaKey;if(!c&&document.activeElement!==t)return;if(l.preventDefault(),c){e.zoomBy(Math.exp(-l.deltaY/300),this.pointOf(l));return}this.turned+=l.deltaMode===WheelEvent.DOM_DELTA_PIXEL?l.deltaY/40:l.deltaY;let h=Math.trunc(this.turned);this.turned-=h,h!==0&&this.step(-h)},{signal:i,passive:!1});let a=l=>{let c=this.pointOf(l);e.moveTo({[r]:c[r],[o]:c[o]})};t.addEventListener("click",a,{signal:i}),t.addEventListener("dblclick",l=>e.zoomBy(l.shiftKey?.5:2,this.pointOf(l)),{signal:i}),t.addEventListener("pointermove",l=>{if(s?.(this.pointOf(l),this.shown.layer),l.buttons===1&&l.pointerType==="mouse")if(l.shiftKey){let{perMm:c}=this.scale(t.clientWidth,t.clientHeight);e.panBy(r,-l.movementX/c),e.panBy(o,l.movementY/c)}else a(l)},{signal:i}),t.addEventListener("pointerleave",()=>s?.(null,this.shown.layer),{signal:i})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{planes:t}=this,{grid:i}=t.options,{axis:s}=this.shown,[r,o]=Jn[s],a=Math.max(Math.round(i.shape[s]/10),2),l=qs(i,r)/t.zoom*.1,c=e.shiftKey?{ArrowLeft:()=>t.panBy(r,-l),ArrowRight:()=>t.panBy(r,l),ArrowDown:()=>t.panBy(o,-l),ArrowUp:()=>t.panBy(o,l)}:{ArrowUp:()=>this.step(1),ArrowRight:()=>this.step(1),ArrowDown:()=>this.step(-1),ArrowLeft:()=>this.step(-1),PageUp:()=>this.step(a),PageDown:()=>this.step(-a),Home:()=>this.step(-this.index),End:()=>this.step(i.shape[s]-1-this.index)},h={"+":()=>t.zoomBy(1.5,t.at()),"=":()=>t.zoomBy(1.5,t.at()),"-":()=>t.zoomBy(1/1.5,t.at()),0:()=>t.zoomBy(1/Dp,t.at())},u=c[e.key]??h[e.key];u&&(e.preventDefault(),u())}};function X_(n,{segments:e,slice:t},i,s,r,o){let[a,l]=[i(t.corner[0]),s(t.corner[1])],[c,h]=[i(t.corner[0]+t.pitch[0])-a,s(t.corner[1]-t.pitch[1])-l];n.beginPath();for(let u=0;u<e.length;u+=4)n.moveTo(a+e[u]*c,l+e[u+1]*h),n.lineTo(a+e[u+2]*c,l+e[u+3]*h);n.lineCap="round",n.lineWidth=3*r,n.strokeStyle="rgb(0 0 0 / 0.4)",n.stroke(),n.lineWidth=1.6*r,n.strokeStyle=o,n.stroke()}function $_(n){let e=10**Math.floor(Math.log10(n)),t=[5,2,1].find(i=>i*e<=n*(1+1e-9))??1;return Number((t*e).toPrecision(3))}function Cu(n){return n.toFixed(3).replace("-","−")}var Np={id:"in-time",title:"How the print grows",render:n=>{let e=n.run.volumes.filter(({kind:l})=>l==="cure_time");if(e.length===0)return null;let t=0,i=new AbortController,s=v("div"),r=new EventTarget,o=l=>{i.abort(),i=new AbortController,t=l,s.replaceChildren(Ci(n,()=>Y_(n,e[l],i.signal))),r.dispatchEvent(new Event("change"))};n.gone.addEventListener("abort",()=>i.abort()),o(0);let a=e.map(({species:l,name:c},h)=>[String(h),l??c]);return v("div",{},a.length>1&&Kn("Resin",a,()=>String(t),l=>o(Number(l)),l=>r.addEventListener("change",l)),s)}},q_=10,Ru=500;async function Y_({run:n,state:e,store:t},i,s){let r=await t.volume(i),o=ss(n,"target",i.species??""),a=o?await t.volume(o).catch(()=>null):null,l=Z_(n.report,i.species),c=i.high,h=l?.best_s??null,u=()=>Math.min(e.get("time")??h??c,c),d=K_(r),f={low:Math.min(i.low,c),high:c,logarithmic:!1,map:is},g={id:"growth",title:"Time of cure",picture:(E,B)=>{let U=r.slice(E,B);if(!U)return null;let D=u(),H=gl(U.values,f).map((N,W)=>U.values[W]<=D?N:0),G=new Uint32Array(U.codes.length);for(let N=0;N<G.length;N++)G[N]=H[U.codes[N]];return{...U,pixels:G}},value:E=>{let B=r.at(E);return B===null?"stays liquid":`solid after ${Ai(B)}`},legend:()=>({scale:f,label:"solid after, s",mark:null})},x=v("p.readout"),p=new Ys({state:e,grid:r,signal:s,hover:E=>{x.textContent=g.value(E??p.at())}});p.show([2,1,0].map(E=>({axis:E,layer:g,outlines:(B,U)=>{let D=a?.slice(B,U);return D?[{slice:D,segments:Ml(D,.5),color:"--outline-growth"}]:[]}})));let m=v("input",{type:"range",min:0,max:Ru,step:1,"aria-label":"Time",input:()=>e.set({time:Number(m.value)/Ru*c})}),b=v("output"),C=()=>{let E=u();m.value=String(Math.round(E/c*Ru)),m.setAttribute("aria-valuetext",Ai(E));let B=J_(l?.curves?.seconds,l?.curves?.jaccard,E);b.replaceChildren(v("b",{},Ai(E)),`  ${le(d(E),3)} mm³ solid${B===null?"":`, Jaccard index ${le(B,3)}`}`),p.redraw(!0),x.textContent=g.value(p.at())},S=e.on(["time","at"],C),R=v("button",{type:"button"},"Play"),A=0,y=()=>{window.clearInterval(A),A=0,R.textContent="Play"};return R.addEventListener("click",()=>{if(A!==0)return y();R.textContent="Pause",u()>=c&&e.set({time:0}),A=window.setInterval(()=>{e.set({time:Math.min(u()+.05/q_*c,c)}),u()>=c&&y()},50)}),s.addEventListener("abort",()=>{S(),y()}),C(),v("div",{},v("p.quiet",{},"What is solid at a moment, colored by when it became solid. The line is the part’s outline."),v("div.time-controls",{},R,m,b,h!==null&&v("button",{type:"button",click:()=>e.set({time:null})},`Best moment: ${Ai(h)}`)),p.element,v("div.below-planes",{},x,si(g.legend())))}function Z_(n,e){let t=n?.time??[];return t.find(i=>i.name===e)??t[0]??null}function K_(n){let e=new Float64Array(n.values.length);for(let i of n.codes)e[i]++;let t=n.pitch[0]*n.pitch[1]*n.pitch[2];return i=>t*e.reduce((s,r,o)=>n.values[o]<=i?s+r:s,0)}function J_(n,e,t){if(!n||!e)return null;let i=n.findIndex(s=>s>t+1e-9);return i<0&&(i=n.length),i===0?null:e[i-1]??null}function Up(n,e){if(n.served===null)return null;let{served:t}=n,i=v("div.live",{role:"status"}),s=new Map,r=l=>{let c=s.get(l);return c||(c=new Pu(n.runs[l].name,()=>fetch(`${t}cancel/${l}`,{method:"POST"})),s.set(l,c),i.append(c.element)),c};n.runs.forEach(({state:l},c)=>{l==="running"&&r(c)});let o=v("p.problem",{hidden:!0},"The viewer does not answer. What is shown is the last that it sent; it is asked again.");i.append(o);let a=new EventSource(`${t}events`);return a.addEventListener("error",()=>o.hidden=!1),a.addEventListener("open",()=>o.hidden=!0),a.addEventListener("message",({data:l})=>{let c=JSON.parse(l);if(c.type==="states"){c.states.forEach((u,d)=>{n.runs[d]&&n.runs[d].state!==u&&e.replaced(d)});return}let h=n.runs[c.run];if(h)switch(c.type){case"stage":r(c.run).stage(c.name);break;case"part":r(c.run).part(c.fraction,c.left_s);break;case"iteration":j_(h.history,c.row),r(c.run).iteration(c.row.iteration??null,c.iterations),e.row(c.run);break;case"failed":h.state="done",r(c.run).end(c.message),n.runs.every(({state:u})=>u!=="running")&&a.close();break;case"done":r(c.run).end(null),s.delete(c.run),e.replaced(c.run);break;case"snapshot":e.replaced(c.run);break}}),i}async function Lu(n){let e=await fetch(`${n.served}runs.json`);if(!e.ok)throw new Error(`The viewer answered ${e.status}.`);return await e.json()}async function Op({served:n},e){let t=await fetch(`${n}open/${e}`);if(!t.ok)throw new Error(await t.text()||`The viewer answered ${t.status}: the folder of this run is not there.`);return(await t.json()).run}function j_(n,e){let t=Math.max(0,...Object.values(n).map(i=>i.length));for(let i of new Set([...Object.keys(n),...Object.keys(e)]))n[i]??=new Array(t).fill(null),n[i].push(e[i]??null)}var Pu=class{progress=v("progress",{max:1});text=v("span.quiet",{},"waiting");cancel;element;name="";constructor(e,t){this.cancel=v("button",{type:"button"},"Cancel"),this.cancel.addEventListener("click",()=>{this.cancel.disabled=!0,this.cancel.textContent="Canceling…",t().catch(()=>{this.cancel.disabled=!1,this.cancel.textContent="Cancel"})}),this.progress.setAttribute("aria-label",`Progress of ${e}`),this.element=v("div.live-run",{},v("b",{},e),this.progress,this.text,this.cancel)}stage(e){this.name=e,this.show(null,null)}part(e,t){this.show(e,`${Math.round(100*e)} %${t===null?"":`, ${Ai(t)} left`}`)}iteration(e,t){e!==null&&this.show(t?e/t:null,`iteration ${e}${t?` of at most ${t}`:""}`)}show(e,t){e===null?this.progress.removeAttribute("value"):this.progress.value=e,this.text.textContent=[this.name||"running",t].filter(Boolean).join(": ")}end(e){e===null?this.element.remove():this.element.replaceChildren(this.element.firstElementChild,v("span.problem",{role:"alert"},e))}};function Iu(n,e){let i=(n.report?.species??[]).find(s=>s.name===e)??n.report;return{evaluation:i?.evaluation??null,exposure:i?.exposure??null,window:i?.objective_window??null}}function Sl(n){let e=n.report?.evaluation,t=e?.band_half_width??null;return t===0?e.rms_error??null:t}function wl(n,e,t,i){let{evaluation:s,exposure:r,window:o}=Iu(n,e),a=t&&i?ty(t,i):null,l=s?.gel_threshold??null,c=l??a?.best()??null,h=t?.info.high??s?.histogram?.range?.[1]??null;if(c===null||h===null)return null;let u=Q_(s?.iou_curve??a?.curve()??[],[c,s?.iou??null]),d=r?.threshold?.best??null,f=s?.histogram,g=r?.threshold?[r.threshold.low,r.threshold.high]:null;return{reported:c,isOfReport:l!==null,high:Math.max(h,f?.range?.[1]??0,c),histogram:f?{low:f.range[0],high:f.range[1],part:f.part,void:f.void}:a?.histogram??null,curve:u,nearly:g,objective:o,tolerance:r?.tolerance??null,iou:x=>(x===l?s.iou:null)??ey(u,x)??a?.iou(x)??null,percent:x=>d===null||x<=0?null:100*d/x,tooMuch:x=>(x===l?s.over_mm3:null)??a?.tooMuch(x)??null,missing:x=>(x===l?s.under_mm3:null)??a?.missing(x)??null}}function Q_(n,e){let[t,i]=e;return i==null?n:[...n.filter(([s])=>s!==t),[t,i]].sort((s,r)=>s[0]-r[0])}function ey(n,e){if(n.length<2)return null;if(e<=n[0][0])return n[0][1];let t=n.findIndex(([a])=>a>=e);if(t<0)return n[n.length-1][1];let[[i,s],[r,o]]=[n[t-1],n[t]];return s+(e-i)/(r-i)*(o-s)}var Qr=120;function ty(n,e){if(n.codes.length!==e.codes.length)return null;let{values:t}=n,i=t.length,s=[new Float64Array(i+1),new Float64Array(i+1)];for(let x=0;x<n.codes.length;x++){let p=e.codes[x];p!==vs.outside&&s[p===vs.part?0:1][n.codes[x]+1]++}for(let x of s)for(let p=1;p<=i;p++)x[p]+=x[p-1];let r=n.pitch[0]*n.pitch[1]*n.pitch[2],o=Number.isNaN(t[i-1])?i-1:i,a=x=>{let[p,m]=[0,o];for(;p<m;){let b=p+m>>1;t[b]>=x?m=b:p=b+1}return p},[l,c]=[s[0][o],s[1][o]],h=x=>{let p=a(x);return{right:l-s[0][p],wrong:c-s[1][p]}},{high:u}=n.info,d=x=>Array.from({length:Qr},(p,m)=>x[a(u*(m+1)/Qr)]-x[a(u*m/Qr)]),f=x=>{let{right:p,wrong:m}=h(x);return l+m>0?p/(l+m):null},g=()=>Array.from({length:Qr+1},(x,p)=>[u*p/Qr,f(u*p/Qr)??0]);return{curve:g,best:()=>l>0?g().reduce((x,p)=>p[1]>x[1]?p:x)[0]:null,histogram:{low:0,high:u,part:d(s[0]),void:d(s[1])},iou:f,tooMuch:x=>h(x).wrong*r,missing:x=>(l-h(x).right)*r}}var ny=4;function Fp(n,e,t,i){let{response:s,target:r}=n,o=[];s&&o.push(ca("dose","Dose",s,e,t)),r&&o.push(i===null?sy(r,e):ca("target","Target",r,e,null)),s&&t&&o.push(ry(s,n,e,t)),s&&r&&Nu(s,r)&&(t?o.push(oy(s,n,e,t)):i!==null&&o.push(Uu(s,r,e,ny*i,"Error","dose − target")));for(let a of n.others)o.push(ca(a.info.id,iy(a),a,e,null));return o}function Nu(n,e){return n.shape.every((t,i)=>t===e.shape[i])}function iy(n){let{name:e,species:t}=n.info,i=t===null?e:`${e}, ${t}`;return i.charAt(0).toUpperCase()+i.slice(1)}function ca(n,e,t,i,s,r={low:t.info.low,high:t.info.high}){let{info:o}=t,l={low:o.logarithmic?Math.max(r.low,r.high*1e-6):o.kind==="response"?Math.min(r.low,0):r.low,high:r.high,logarithmic:o.logarithmic&&r.high>0,map:is},c=o.unit===""?"":` ${o.unit}`,h=new WeakMap,u=d=>{let f=h.get(d);return f||h.set(d,f=Ou(d,g=>gl(g,l))),f};return{id:n,title:e,picture:(d,f)=>{let g=i.of(t,d,f);return g&&u(g)},value:d=>`${e.toLowerCase()} ${Fu(t.at(d))}${c}`,legend:()=>({scale:l,label:o.unit===""?e:`${e}, ${o.unit}`,mark:s?.()??null})}}function sy(n,e){return{id:"target",title:"Target",picture:(t,i)=>{let s=kn("--solid"),r=e.of(n,t,i);return r&&Ou(r,o=>Uint32Array.from(o,a=>gr(s,Math.min(Math.max(a,0),1))))},value:t=>`target ${Fu(n.at(t))}`,legend:()=>({keys:[["var(--solid)","part"],["var(--picture)","to stay liquid"]]})}}function ry(n,{bodies:e},t,i){return{id:"print",title:"Print",picture:(s,r)=>{let o=kn("--solid"),a=i(),l=t.of(n,s,r);return l&&Bp(Ou(l,c=>Uint32Array.from(c,h=>h>=a?o:0)),e,t,s,r)},value:s=>{let r=n.at(s);return r===null?"print –":r>=i()?"print solid":"print liquid"},legend:()=>({keys:[["var(--solid)","solid"],["var(--picture)","liquid"],...kp(e)]})}}function oy(n,{target:e,labels:t,bodies:i},s,r){let o=(a,l)=>a===null?(l??0)>=.5:a===vs.part;return{id:"error",title:"Error",picture:(a,l)=>{let[c,h,u]=[n,e,t].map(R=>R&&s.of(R,a,l));if(!c)return null;let d=r(),[f,g,x,p]=[gr(kn("--solid"),.55),kn("--missing"),kn("--excess"),gr(kn("--solid"),.2)],m=new Uint32Array(c.codes.length),b=R=>R!==null&&R.width===c.width&&R.height===c.height,[C,S]=[b(h)?h:null,b(u)?u:null];for(let R=0;R<m.length;R++){let A=c.values[c.codes[R]]>=d,y=S?S.codes[R]:null;y===vs.outside?m[R]=A?p:0:o(y,C?C.values[C.codes[R]]:null)?m[R]=A?f:g:m[R]=A?x:0}return Bp({...c,pixels:m},i,s,a,l)},value:a=>{let l=n.at(a),c=t?t.at(a):null;if(l===null)return"–";if(c===vs.outside)return"not counted";let h=l>=r();return o(c,e?e.at(a):null)?h?"solid, as it should":"missing":h?"too much":"liquid, as it should"},legend:()=>({keys:[["color-mix(in srgb, var(--solid) 55%, var(--picture))","solid, as it should"],["var(--missing)","missing"],["var(--excess)","too much"],["var(--picture)","liquid, as it should"],...kp(i)]})}}function Uu(n,e,t,i,s,r){let o={low:-i,high:i,logarithmic:!1,map:Kr},a=Uint32Array.from({length:256},(l,c)=>Kr(c/255));return{id:s.toLowerCase(),title:s,picture:(l,c)=>{let[h,u]=[t.of(n,l,c),t.of(e,l,c)];if(!h||!u||h.codes.length!==u.codes.length)return null;let d=new Uint32Array(h.codes.length);for(let f=0;f<d.length;f++){let g=xr(o,h.values[h.codes[f]]-u.values[u.codes[f]]);d[f]=a[Math.round(255*Math.min(Math.max(g,0),1))]}return{...h,pixels:d}},value:l=>{let[c,h]=[n.at(l),e.at(l)];return`${r} ${Fu(c===null||h===null?null:c-h)}`},legend:()=>({scale:o,label:r,mark:null})}}function Ou(n,e){let{codes:t}=n,i=e(n.values),s=new Uint32Array(t.length);for(let r=0;r<s.length;r++)s[r]=i[t[r]];return{...n,pixels:s}}var Du={[$s.dark]:{color:"--void",text:"body that must stay dark"},[$s.insert]:{color:"--ink",text:"insert"},[$s.obstacle]:{color:"--quiet",text:"obstacle"}};function kp(n){if(!n)return[];let e=new Set(n.codes);return Object.entries(Du).filter(([t])=>e.has(Number(t))).map(([,{color:t,text:i}])=>[`var(${t})`,i])}function Bp(n,e,t,i,s){let r=e&&t.of(e,i,s);if(!r||r.codes.length!==n.pixels.length)return n;let o=Uint32Array.from({length:256},(a,l)=>Du[l]?gr(kn(Du[l].color),.75):0);return r.codes.forEach((a,l)=>{o[a]!==0&&(n.pixels[l]=o[a])}),n}function Fu(n){return le(n,3)}var ay=60,ly=60,eo=class{constructor(e,t,i,s){this.store=t;this.signal=i;this.better=s;let r=(e.report?.optimization??e.report?.evaluation)?.grid,[o,a,l]=r?.shape_zyx??[0,0,0];this.grid=r?new la([l,a,o],[r.pitch_mm,r.pitch_mm,r.pitch_mm],r.center_xyz_mm):null}store;signal;better;full=new Map;last=new Map;asked=new Map;grid;gridOf(e){return this.finer(e)??e}of(e,t,i){let s=this.reduced(e,t,i),r=this.finer(e);if(r===null||s===null)return s;let o=r.index(t,i);if(o<0||o>=r.shape[t])return s;let a=`${e.info.id}/${t}/${o}`,l=this.full.get(a);return l||this.ask(a,e,r,t,o),l??s}reduced(e,t,i){let s=`${e.info.id}/${t}`,r=e.index(t,i),o=this.last.get(s);if(o?.index===r)return o.slice;let a=e.slice(t,i);return this.last.set(s,{index:r,slice:a}),a}finer(e){let{grid:t}=this;return e.info.full&&t!==null&&t.pitch[0]<.99*e.pitch[0]?t:null}ask(e,t,i,s,r){let o=`${t.info.id}/${s}`,a=this.asked.get(o);if(a?.key===e)return;window.clearTimeout(a?.timer);let l=async()=>{let h=await this.store.slice(t.info,2-s,r,this.signal),[u,d]=h.shape,[f,g]=Jn[s],x=h.codes.slice();for(let S=0;S<u;S++)x.set(h.codes.subarray((u-1-S)*d,(u-S)*d),S*d);let p=h.codes instanceof Uint16Array?16:8,m=[i.range(f)[0],i.range(g)[1]],b=bu(p,h.low,h.high,t.info.nan===null?null:2**p-1);this.full.set(e,{axis:s,width:d,height:u,codes:x,values:b,pitch:[i.pitch[f],i.pitch[g]],corner:m});let C=this.full.keys().next();this.full.size>ay&&!C.done&&this.full.delete(C.value),this.better()},c=h=>{this.signal.aborted||console.warn(`The full slice of ${t.info.name} along ${rs[s]} did not come: ${String(h)}`)};this.asked.set(o,{key:e,timer:window.setTimeout(()=>{l().catch(c)},ly)})}};var El=1e3,Al=230,Qt={left:44,right:44,top:26,bottom:40},os=Al-Qt.bottom;function zp(n,e,t){let i=v("input",{type:"range",min:0,max:El,step:1,"aria-label":"Gel threshold"}),s=v("button",{type:"button",click:()=>e.set({threshold:null})},n.isOfReport?"Back to the report’s threshold":"Back to the best threshold"),r=v("dl.threshold-list"),o=new ku(n,d=>a(d)),a=d=>{let f=Math.min(Math.max(d,0),n.high);e.set({threshold:Math.abs(f-n.reported)<.6*n.high/El?null:f})};i.addEventListener("input",()=>a(Number(i.value)/El*n.high),{signal:t});let l=n.isOfReport?"as reported":"best of the voxels shown",c=()=>{let d=e.get("threshold")??n.reported,f=n.iou(d),g=n.percent(d);i.value=String(Math.round(d/n.high*El)),i.setAttribute("aria-valuetext",`${le(d,3)}, IoU ${le(f,3)}`),s.disabled=e.get("threshold")===null,o.mark(d),r.replaceChildren(...ha("Gel threshold",le(d,4),"dose at which the resin gels"),...ha("Exposure",g===null?"–":`${le(g,4)} %`,"of the best exposure"),...ha("IoU",le(f,4),d!==n.reported?`${le(n.iou(n.reported),4)} ${l}`:l),...ha("Too much",an(n.tooMuch(d),"mm³"),"gels and should not","--excess"),...ha("Missing",an(n.missing(d),"mm³"),"does not gel and should","--missing"))},h=e.on(["threshold"],c);t.addEventListener("abort",()=>{h(),o.end()}),c();let u=n.nearly&&n.tolerance!==null?` In the shaded range IoU is at most ${le(n.tolerance,2)} below its best.`:"";return v("div.threshold",{},v("div.threshold-chart",{},v("h3",{},"Where the resin gels"),v("p.quiet",{},`Move the threshold: contours, print, errors and numbers follow.${u}`),cy(),o.element,v("div.threshold-slider",{},i)),v("div.threshold-numbers",{},r,s))}function ha(n,e,t,i){return[v("dt",{},i!==void 0&&v("i.tile",{style:`background: var(${i})`}),n),v("dd",{},v("b",{},e),v("span.quiet",{},t))]}function Tl(n,e){return v("span",{},v("i.tile",{style:`background: var(${n})`}),e)}function cy(){return v("p.color-keys",{},Tl("--part","part, voxels"),Tl("--void","void, voxels"),Tl("--ink","IoU"),Tl("--threshold","gel threshold"))}var ku=class{constructor(e,t){this.gel=e;this.watcher.observe(this.element);let i=s=>{s.buttons===1&&(s.preventDefault(),t(this.back(s.clientX-this.element.getBoundingClientRect().left)))};this.element.addEventListener("pointerdown",s=>{this.element.setPointerCapture(s.pointerId),i(s)}),this.element.addEventListener("pointermove",i)}gel;element=v("div.plot");watcher=new ResizeObserver(()=>this.resize());line=wt("g");width=0;threshold=0;end(){this.watcher.disconnect()}mark(e){this.threshold=e,this.drawLine()}x(e){return Qt.left+e/this.gel.high*(this.width-Qt.left-Qt.right)}back(e){return(e-Qt.left)/(this.width-Qt.left-Qt.right)*this.gel.high}resize(){let e=this.element.clientWidth;e===0||e===this.width||(this.width=e,this.element.replaceChildren(this.draw()),this.drawLine())}draw(){let{histogram:e,nearly:t,objective:i,curve:s,reported:r,high:o}=this.gel,a=wt("svg",{width:this.width,height:Al,viewBox:`0 0 ${this.width} ${Al}`,role:"img","aria-label":"Voxels of part and void per dose, and IoU per gel threshold"});if(t){let[l,c]=[Math.max(t[0]??0,0),Math.min(t[1]??o,o)];a.append(wt("rect",{class:"band",x:this.x(l),y:Qt.top,width:Math.max(this.x(c)-this.x(l),1),height:os-Qt.top}))}for(let l of uy(0,o,this.width/90))a.append(wt("line",{class:"grid",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:os}),wt("text",{x:this.x(l),y:os+16,"text-anchor":"middle"},le(l,3)));a.append(wt("text",{x:(this.width+Qt.left-Qt.right)/2,y:Al-6,"text-anchor":"middle"},"dose")),e&&a.append(...this.bars(e));for(let l of i??[])a.append(wt("line",{class:"aimed",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:os},wt("title",{},"a threshold of the objective: the void should stay below both, the part above")));if(s.length>1){a.append(wt("path",{class:"curve",d:`M${s.filter(([l])=>l<=o).map(([l,c])=>`${this.x(l).toFixed(1)},${_r(c).toFixed(1)}`).join("L")}`}));for(let l of[0,.5,1])a.append(wt("text",{x:this.width-Qt.right+8,y:_r(l)+4},String(l)));a.append(wt("text",{x:this.width-Qt.right+8,y:Qt.top-10},"IoU"))}return a.append(wt("line",{class:"base",x1:Qt.left,x2:this.width-Qt.right,y1:os,y2:os}),wt("line",{class:"fixed",x1:this.x(r),x2:this.x(r),y1:Qt.top,y2:os},wt("title",{},"the report’s threshold")),this.line),a}bars(e){let{low:t,high:i}=e,s=Math.max(...e.part,...e.void,1),r=Math.ceil(Math.log10(s+1)),a=Array.from({length:r+1},(c,h)=>h).filter(c=>c%Math.ceil(r/4)===0).map(c=>wt("text",{x:Qt.left-8,y:_r(c/r)+4,"text-anchor":"end"},c===0?"1":xl(c))),l=["void","part"].map(c=>{let h=e[c].map(u=>Math.log10(u+1)/r);return wt("path",{class:`bars ${c}`,d:hy(h,u=>this.x(t+u/h.length*(i-t)))})});return[...a,...l]}drawLine(){if(this.width===0)return;let e=this.x(this.threshold),t=this.gel.iou(this.threshold),i=e>this.width-90;this.line.replaceChildren(wt("line",{class:"threshold-line",x1:e,x2:e,y1:Qt.top-8,y2:os}),wt("text",{class:"threshold-label",x:e+(i?-6:6),y:Qt.top-8,"text-anchor":i?"end":"start"},le(this.threshold,3))),t!==null&&this.line.append(wt("circle",{class:"threshold-dot",cx:e,cy:_r(t),r:4.5}))}};function _r(n){return os-n*(os-Qt.top)}function hy(n,e){let t=`M${e(0).toFixed(1)},${_r(0)}`;return n.forEach((i,s)=>{t+=`V${_r(i).toFixed(1)}H${e(s+1).toFixed(1)}`}),`${t}V${_r(0)}Z`}function uy(n,e,t){let i=(e-n)/Math.max(t,2),s=10**Math.floor(Math.log10(i)),r=([1,2,5,10].find(a=>a*s>=i)??10)*s,o=[];for(let a=Math.ceil(n/r);a*r<=e+1e-9;a++)o.push(a*r);return o}var Hp={id:"look",title:"Slice by slice",render:n=>n.run.volumes.some(({kind:e})=>e==="response"||e==="target")?Ci(n,dy):null};async function dy(n){let{run:e,state:t,gone:i}=n,s=v("div"),r=new AbortController,o=async()=>{r.abort();let c=new AbortController;r=c;let{volumes:h,problems:u}=await aa(n,Bi(n));if(c.signal.aborted)return;let d=h.response??h.target;s.replaceChildren(...u.map(jr),...d?new Bu(n,h,d,c.signal).elements():[])},a=t.on(["species"],()=>{o()});i.addEventListener("abort",()=>{a(),r.abort()}),await o();let l=oa(e);return v("div",{},l.length>1&&fy(n,l),s)}function fy(n,e){let{state:t,gone:i}=n,s=e.map(r=>[r,r]);return Kn("Species",s,()=>Bi(n)||e[0],r=>t.set({species:r,threshold:null}),r=>i.addEventListener("abort",t.on(["species"],r)))}var Cl="all",Rl={part:["target","error"],print:["print","error"]},Bu=class{constructor(e,t,i,s){this.context=e;this.volumes=t;this.grid=i;this.signal=s;let{run:r,state:o,store:a}=e,l=Sl(r);this.gel=l===null?wl(r,Bi(e),t.response,t.labels):null,this.outlined={part:t.target!==null&&l===null,print:this.gel!==null&&t.response!==null},this.slices=new eo(r,a,s,()=>this.planes.redraw(!0)),this.layers=Fp(t,this.slices,this.gel&&(()=>this.threshold),l),this.planes=new Ys({state:o,grid:this.slices.gridOf(i),signal:s,hover:c=>this.read(c??this.planes.at())})}context;volumes;grid;signal;gel;slices;layers;planes;readout=v("p.readout");legend=v("div.color-legend");outlined;elements(){let{context:e,gel:t,grid:i,planes:s,signal:r}=this,o=this.controls();this.listen(["threshold"],()=>{s.redraw(!0),this.showLegend()}),this.listen(["layer","plane"],()=>this.arrange()),this.listen(["threshold","at","layer"],()=>this.read(s.at())),this.arrange(),this.read(s.at());let a=i.info.reduced>1&&!i.info.full?` Each voxel shown is the mean of ${i.info.reduced}³ of the evaluation.`:"";return[v("p.quiet",{},`Click to move the cut; drag the sliders, or choose a plane and press the arrow keys or turn the wheel. Double-click, + and − zoom, 0 shows all again.${a}`),o,s.element,v("div.below-planes",{},this.readout,this.legend),...t?[zp(t,e.state,r)]:[]]}get threshold(){return this.context.state.get("threshold")??this.gel?.reported??Number.POSITIVE_INFINITY}get shown(){let e=this.context.state.get("layer");return e===Cl?this.layers.slice(0,4):[this.layers.find(t=>t.id===e)??this.layers[0]]}get isAll(){return this.context.state.get("layer")===Cl}arrange(){let{shown:e}=this,t=this.context.state.get("plane"),i=t==="x"?0:t==="y"?1:2,s=this.isAll?e.map(r=>({axis:i,layer:r,title:r.title,outlines:this.outlines(r)})):[2,1,0].map(r=>({axis:r,layer:e[0],outlines:this.outlines(e[0])}));this.planes.show(s),this.showLegend()}showLegend(){this.legend.replaceChildren(...this.shown.map(e=>si(e.legend())))}read(e){let t=e.map((i,s)=>`${rs[s]} ${Cu(i)}`).join(", ");this.readout.textContent=`${t} mm  ·  ${this.layers.map(i=>i.value(e)).join("  ·  ")}`}outlines(e){let{target:t,response:i}=this.volumes,s=(r,o,a,l,c)=>{let h=r&&this.slices.of(r,l,c);return h?[{slice:h,segments:py(h,o),color:a}]:[]};return(r,o)=>[...this.outlined.part&&!Rl.part.includes(e.id)?s(t,.5,"--outline-part",r,o):[],...this.outlined.print&&!Rl.print.includes(e.id)?s(i,this.threshold,"--threshold-line",r,o):[]]}controls(){let{layers:e}=this,{state:t}=this.context,i=e.map(({id:u,title:d})=>[u,d]);e.length>1&&i.push([Cl,"Side by side"]);let s=()=>this.isAll?Cl:this.shown[0].id,r=u=>t.set({layer:u===e[0].id?"":u}),o=Kn("Plane",[["","x–y"],["y","x–z"],["x","y–z"]],()=>t.get("plane"),u=>t.set({plane:u}),u=>this.listen(["plane"],u)),a=(u,d)=>{if(!this.outlined[u])return null;let f=g=>{this.outlined[u]=g,this.planes.redraw(!0)};return ra(`outline of the ${u}`,!0,f,v("i.stroke",{style:`background: var(${d})`}))},[l,c]=[a("part","--outline-part"),a("print","--threshold-line")],h=()=>{o.hidden=!this.isAll,l&&(l.hidden=!this.isAll&&Rl.part.includes(this.shown[0].id)),c&&(c.hidden=!this.isAll&&Rl.print.includes(this.shown[0].id))};return this.listen(["layer"],h),h(),v("div.controls",{},i.length>1&&Kn("Shown",i,s,r,u=>this.listen(["layer"],u)),o,l,c)}listen(e,t){this.signal.addEventListener("abort",this.context.state.on(e,t))}},Vp=new WeakMap;function py(n,e){let t=Vp.get(n);return t?.level!==e&&Vp.set(n,t={level:e,segments:Ml(n,e)}),t.segments}var my="uplot",gy="u-hz",xy="u-vt",_y="u-title",yy="u-wrap",vy="u-under",by="u-over",My="u-axis",br="u-off",Sy="u-select",wy="u-cursor-x",Ey="u-cursor-y",Ty="u-cursor-pt",Ay="u-legend",Cy="u-live",Ry="u-inline",Py="u-series",Ly="u-marker",Gp="u-label",Iy="u-value",da="width",fa="height";var Wp="bottom",to="left",zu="right",id="#000",Xp=id+"0",Vu="mousemove",$p="mousedown",Hu="mouseup",qp="mouseenter",Yp="mouseleave",Zp="dblclick",Dy="resize",Ny="scroll",Kp="change",Nl="dppxchange",sd="--",lo=typeof window<"u",qu=lo?document:null,io=lo?window:null,Uy=lo?navigator:null,Ct,Pl;function Yu(){let n=devicePixelRatio;Ct!=n&&(Ct=n,Pl&&Ku(Kp,Pl,Yu),Pl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Mr(Kp,Pl,Yu),io.dispatchEvent(new CustomEvent(Nl)))}function pi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Zu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function zi(n,e,t,i){let s=qu.createElement(n);return e!=null&&pi(s,e),t?.insertBefore(s,i),s}function Ri(n,e){return zi("div",n,e)}var Jp=new WeakMap;function as(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Jp.get(n);r!=o&&(n.style.transform=r,Jp.set(n,r),e<0||t<0||e>i||t>s?pi(n,br):Zu(n,br))}var jp=new WeakMap;function Qp(n,e,t){let i=e+t,s=jp.get(n);i!=s&&(jp.set(n,i),n.style.background=e,n.style.borderColor=t)}var em=new WeakMap;function tm(n,e,t,i){let s=e+""+t,r=em.get(n);s!=r&&(em.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var rd={passive:!0},Oy={...rd,capture:!0};function Mr(n,e,t,i){e.addEventListener(n,t,i?Oy:rd)}function Ku(n,e,t,i){e.removeEventListener(n,t,rd)}lo&&Yu();function Vi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Rm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Pm=n=>n!=null,Lm=n=>n!=null&&n>0,Fl=Rm(Pm),Fy=Rm(Lm);function ky(n,e,t,i=0,s=!1){let r=s?Fy:Fl,o=s?Lm:Pm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Bt,l??-Bt]}function kl(n,e,t,i){let s=sm(n),r=sm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?bs:Im,a=s==1?mi:Pi,l=r==1?Pi:mi,c=a(o(Sn(n))),h=l(o(Sn(e))),u=so(t,c),d=so(t,h);return t==10&&(c<0&&(u=zt(u,-c)),h<0&&(d=zt(d,-h))),i||t==2?(n=u*s,e=d*r):(n=Om(n,u),e=Bl(e,d)),[n,e]}function od(n,e,t,i){let s=kl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var ad=.1,nm={mode:3,pad:ad},ma={pad:0,soft:null,mode:0},By={min:ma,max:ma};function Ul(n,e,t,i){return zl(t)?im(n,e,t):(ma.pad=t,ma.soft=i?0:null,ma.mode=i?3:0,im(n,e,By))}function Tt(n,e){return n??e}function zy(n,e,t){for(e=Tt(e,0),t=Tt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function im(n,e,t){let i=t.min,s=t.max,r=Tt(i.pad,0),o=Tt(s.pad,0),a=Tt(i.hard,-Bt),l=Tt(s.hard,Bt),c=Tt(i.soft,Bt),h=Tt(s.soft,-Bt),u=Tt(i.mode,0),d=Tt(s.mode,0),f=e-n,g=bs(f),x=jn(Sn(n),Sn(e)),p=bs(x),m=Sn(p-g);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,u==2&&c!=Bt&&(r=0),d==2&&h!=-Bt&&(o=0)));let b=f||x||1e3,C=bs(b),S=so(10,mi(C)),R=b*(f==0?n==0?.1:1:r),A=zt(Om(n-R,S/10),24),y=n>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:Bt,E=jn(a,A<y&&n>=y?y:Hi(y,A)),B=b*(f==0?e==0?.1:1:o),U=zt(Bl(e+B,S/10),24),D=e<=h&&(d==1||d==3&&U>=h||d==2&&U<=h)?h:-Bt,H=Hi(l,U>D&&e<=D?D:jn(D,U));return E==H&&E==0&&(H=100),[E,H]}var Vy=new Intl.NumberFormat(lo?Uy.language:"en-US"),ld=n=>Vy.format(n),gi=Math,Dl=gi.PI,Sn=gi.abs,mi=gi.floor,Mn=gi.round,Pi=gi.ceil,Hi=gi.min,jn=gi.max,so=gi.pow,sm=gi.sign,bs=gi.log10,Im=gi.log2,Hy=(n,e=1)=>gi.sinh(n)*e,Gu=(n,e=1)=>gi.asinh(n/e),Bt=1/0;function rm(n){return(bs((n^n>>31)-(n>>31))|0)+1}function Ju(n,e,t){return Hi(jn(n,e),t)}function Dm(n){return typeof n=="function"}function bt(n){return Dm(n)?n:()=>n}var Gy=()=>{},Nm=n=>n,Um=(n,e)=>e,Wy=n=>null,om=n=>!0,am=(n,e)=>n==e,Xy=/\.\d*?(?=9{6,}|0{6,})/gm,Sr=n=>{if(km(n)||Ks.has(n))return n;let e=`${n}`,t=e.match(Xy);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Sr(s)}e${r}`}return zt(n,i)};function yr(n,e){return Sr(zt(Sr(n/e))*e)}function Bl(n,e){return Sr(Pi(Sr(n/e))*e)}function Om(n,e){return Sr(mi(Sr(n/e))*e)}function zt(n,e=0){if(km(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Ks=new Map;function Fm(n){return((""+n).split(".")[1]||"").length}function xa(n,e,t,i){let s=[],r=i.map(Fm);for(let o=e;o<t;o++){let a=Sn(o),l=zt(so(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:zt(h,u);s.push(d),Ks.set(d,u)}}return s}var ga={},cd=[],ro=[null,null],Zs=Array.isArray,km=Number.isInteger,$y=n=>n===void 0;function lm(n){return typeof n=="string"}function zl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function qy(n){return n!=null&&typeof n=="object"}var Yy=Object.getPrototypeOf(Uint8Array),Bm="__proto__";function oo(n,e=zl){let t;if(Zs(n)){let i=n.find(s=>s!=null);if(Zs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=oo(n[s],e)}else t=n.slice()}else if(n instanceof Yy)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Bm&&(t[i]=oo(n[i],e))}else t=n;return t}function gn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Bm&&(zl(n[s])?gn(n[s],oo(i[s])):n[s]=oo(i[s]))}return n}var Zy=0,Ky=1,Jy=2;function jy(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Qy(n,e){if(nv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return iv(o[0])||(o=tv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:Ky,f=[];for(let g=0;g<h.length;g++){let x=h[g],p=r.get(l[g]);x===null?d!=Zy&&(u[p]=x,d==Jy&&f.push(p)):u[p]=x}jy(u,f,s),i.push(u)}}return i}var ev=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function tv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function nv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function iv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var zm=["January","February","March","April","May","June","July","August","September","October","November","December"],Vm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Hm(n){return n.slice(0,3)}var sv=Vm.map(Hm),rv=zm.map(Hm),ov={MMMM:zm,MMM:rv,WWWW:Vm,WWW:sv};function ua(n){return(n<10?"0":"")+n}function av(n){return(n<10?"00":n<100?"0":"")+n}var lv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ua(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ua(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ua(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ua(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ua(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>av(n.getMilliseconds())};function hd(n,e){e=e||ov;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?lv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var cv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function hv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==cv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Gm=n=>n%1==0,Ol=[1,2,2.5,5],uv=xa(10,-32,0,Ol),Wm=xa(10,0,32,Ol),dv=Wm.filter(Gm),vr=uv.concat(Wm),ud=`
`,Xm="{YYYY}",cm=ud+Xm,$m="{M}/{D}",pa=ud+$m,Ll=pa+"/{YY}",qm="{aa}",fv="{h}:{mm}",no=fv+qm,hm=ud+no,um=":{ss}",Lt=null;function Ym(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?xa(10,0,3,Ol).filter(Gm):xa(10,-3,0,Ol)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Xm,Lt,Lt,Lt,Lt,Lt,Lt,1],[s*28,"{MMM}",cm,Lt,Lt,Lt,Lt,Lt,1],[s,$m,cm,Lt,Lt,Lt,Lt,Lt,1],[i,"{h}"+qm,Ll,Lt,pa,Lt,Lt,Lt,1],[t,no,Ll,Lt,pa,Lt,Lt,Lt,1],[e,um,Ll+" "+no,Lt,pa+" "+no,Lt,hm,Lt,1],[n,um+".{fff}",Ll+" "+no,Lt,pa+" "+no,Lt,hm,Lt,1]];function h(u){return(d,f,g,x,p,m)=>{let b=[],C=p>=o,S=p>=r&&p<o,R=u(g),A=zt(R*n,3),y=Wu(R.getFullYear(),C?0:R.getMonth(),S||C?1:R.getDate()),E=zt(y*n,3);if(S||C){let B=S?p/r:0,U=C?p/o:0,D=A==E?A:zt(Wu(y.getFullYear()+U,y.getMonth()+B,1)*n,3),H=new Date(Mn(D/n)),G=H.getFullYear(),N=H.getMonth();for(let W=0;D<=x;W++){let K=Wu(G+U*W,N+B*W,1),V=K-u(zt(K*n,3));D=zt((+K+V)*n,3),D<=x&&b.push(D)}}else{let B=p>=s?s:p,U=mi(g)-mi(A),D=E+U+Bl(A-E,B);b.push(D);let H=u(D),G=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,N=p/i,W=d.axes[f]._space,K=m/W;for(;D=zt(D+p,n==1?0:3),!(D>x);)if(N>1){let V=mi(zt(G+N,6))%24,Q=u(D).getHours()-V;Q>1&&(Q=-1),D-=Q*i,G=(G+N)%24;let se=b[b.length-1];zt((D-se)/p,3)*K>=.7&&b.push(D)}else b.push(D)}return b}}return[l,c,h]}var[pv,mv,gv]=Ym(1),[xv,_v,yv]=Ym(.001);xa(2,-53,53,[1]);function dm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function fm(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return i.map(g=>{let x=n(g),p=x.getFullYear(),m=x.getMonth(),b=x.getDate(),C=x.getHours(),S=x.getMinutes(),R=x.getSeconds(),A=p!=l&&a[2]||m!=c&&a[3]||b!=h&&a[4]||C!=u&&a[5]||S!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=b,u=C,d=S,f=R,A(x)})}}function vv(n,e){let t=hd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Wu(n,e,t){return new Date(n,e,t)}function pm(n,e){return e(n)}var bv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function mm(n,e){return(t,i,s,r)=>r==null?sd:e(n(i))}function Mv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Sv(n,e){return n.series[e].fill(n,e)}var wv={show:!0,live:!0,isolate:!1,mount:Gy,markers:{show:!0,width:2,stroke:Mv,fill:Sv,dash:"solid"},idx:null,idxs:null,values:[]};function Ev(n,e){let t=n.cursor.points,i=Ri(),s=t.size(n,e);$t(i,da,s),$t(i,fa,s);let r=s/-2;$t(i,"marginLeft",r),$t(i,"marginTop",r);let o=t.width(n,e,s);return o&&$t(i,"borderWidth",o),i}function Tv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Av(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Cv(n,e){return n.series[e].points.size}var Xu=[0,0];function Rv(n,e,t){return Xu[0]=e,Xu[1]=t,Xu}function Il(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function $u(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Pv={show:!0,x:!0,y:!0,lock:!1,move:Rv,points:{one:!1,show:Ev,size:Cv,width:0,stroke:Av,fill:Tv},bind:{mousedown:Il,mouseup:Il,click:Il,dblclick:Il,mousemove:$u,mouseleave:$u,mouseenter:$u},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Zm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},dd=gn({},Zm,{filter:Um}),Km=gn({},dd,{size:10}),Jm=gn({},Zm,{show:!1}),fd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jm="bold "+fd,Qm=1.5,gm={show:!0,scale:"x",stroke:id,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jm,side:2,grid:dd,ticks:Km,border:Jm,font:fd,lineGap:Qm,rotate:0},Lv="Value",Iv="Time",xm={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function Dv(n,e,t,i,s){return e.map(r=>r==null?"":ld(r))}function Nv(n,e,t,i,s,r,o){let a=[],l=Ks.get(s)||0;t=o?t:zt(Bl(t,s),l);for(let c=t;c<=i;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ju(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?bs:Im,h=mi(c(t));s=so(l,h),l==10&&(s=vr[Vi(s,vr)]);let u=t,d=s*l;l==10&&(d=vr[Vi(d,vr)]);do a.push(u),u=u+s,l==10&&!Ks.has(u)&&(u=zt(u,Ks.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=vr[Vi(d,vr)]));while(u<=i);return a}function Uv(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?ju(n,e,jn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?ju(n,e,jn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var eg=/./,Ov=/[12357]/,Fv=/[125]/,_m=/1/,Qu=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function kv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?eg:l(7,o)-h>=c?Ov:l(5,o)-h>=c?Fv:_m;if(u==_m){let d=Sn(l(1,o)-h);if(d<c)return Qu(e.slice().reverse(),a.distr,u,Pi(c/d)).reverse()}return Qu(e,a.distr,u,1)}function Bv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?Qu(e.slice().reverse(),3,eg,Pi(a/c)).reverse():e}function zv(n,e,t,i){return i==null?sd:e==null?"":ld(e)}var ym={show:!0,scale:"y",stroke:id,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jm,side:3,grid:dd,ticks:Km,border:Jm,font:fd,lineGap:Qm,rotate:0};function Vv(n,e){let t=3+(n||1)*2;return zt(t*e,3)}function Hv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var vm={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},tg=(n,e,t,i,s)=>s,bm={show:!0,auto:!0,sorted:0,gaps:tg,alpha:1,facets:[gn({},vm,{scale:"x"}),gn({},vm,{scale:"y"})]},Mm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:tg,alpha:1,points:{show:Hv,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function Gv(n,e,t,i,s){return t/10}var ng={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Wv=gn({},ng,{time:!1,ori:1}),Sm={};function ig(n,e){let t=Sm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Sm[n]=t)),t}var ao=1,ed=2;function wr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,x=a.height,p=n.valToPosH,m=n.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,x,Hl,co,Wl,rg,ag):t(s,l,c,h,u,m,p,f,d,x,g,Gl,ho,gd,og,lg)}function pd(n,e){let t=0,i=0,s=Tt(n.bands,cd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Xv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(n,e,t,i,s,r){return wr(n,e,(o,a,l,c,h,u,d,f,g,x,p)=>{let m=o.pxRound,b=c.dir*(c.ori==0?1:-1),C=c.ori==0?co:ho,S,R;b==1?(S=t,R=i):(S=i,R=t);let A=m(u(a[S],c,x,f)),y=m(d(l[S],h,p,g)),E=m(u(a[R],c,x,f)),B=m(d(r==1?h.max:h.min,h,p,g)),U=new Path2D(s);return C(U,E,B),C(U,A,B),C(U,A,y),U})}function Vl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Wl:gd,l=t;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function $v(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function md(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[u]),g=d==u?f:r(n[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function wm(n){return n==0?Nm:n==1?Mn:e=>yr(e,n)}function sg(n){let e=n==0?Hl:Gl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Hi(c,a/2,l/2),h=Hi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Hl=(n,e,t)=>{n.moveTo(e,t)},Gl=(n,e,t)=>{n.moveTo(t,e)},co=(n,e,t)=>{n.lineTo(e,t)},ho=(n,e,t)=>{n.lineTo(t,e)},Wl=sg(0),gd=sg(1),rg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},og=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},ag=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},lg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function cg(n){return(e,t,i,s,r)=>wr(e,t,(o,a,l,c,h,u,d,f,g,x,p)=>{let{pxRound:m,points:b}=o,C,S;c.ori==0?(C=Hl,S=rg):(C=Gl,S=og);let R=zt(b.width*Ct,3),A=(b.size-b.width)/2*Ct,y=zt(A*2,3),E=new Path2D,B=new Path2D,{left:U,top:D,width:H,height:G}=e.bbox;Wl(B,U-y,D-y,H+y*2,G+y*2);let N=W=>{if(l[W]!=null){let K=m(u(a[W],c,x,f)),V=m(d(l[W],h,p,g));C(E,K+A,V),S(E,K,V,A,0,Dl*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:R>0?E:null,fill:E,clip:B,flags:ao|ed}})}function hg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var qv=hg(co),Yv=hg(ho);function ug(n){let e=Tt(n?.alignGaps,0);return(t,i,s,r)=>wr(t,i,(o,a,l,c,h,u,d,f,g,x,p)=>{[s,r]=Fl(l,s,r);let m=o.pxRound,b=G=>m(u(G,c,x,f)),C=G=>m(d(G,h,p,g)),S,R;c.ori==0?(S=co,R=qv):(S=ho,R=Yv);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},E=y.stroke,B=!1;if(r-s>=x*4){let G=fe=>t.posToVal(fe,c.key,!0),N=null,W=null,K,V,he,J=b(a[A==1?s:r]),Q=b(a[s]),se=b(a[r]),pe=G(A==1?Q+1:se-1);for(let fe=A==1?s:r;fe>=s&&fe<=r;fe+=A){let ee=a[fe],ve=(A==1?ee<pe:ee>pe)?J:b(ee),Re=l[fe];ve==J?Re!=null?(V=Re,N==null?(S(E,ve,C(V)),K=N=W=V):V<N?N=V:V>W&&(W=V)):Re===null&&(B=!0):(N!=null&&R(E,J,C(N),C(W),C(K),C(V)),Re!=null?(V=Re,S(E,ve,C(V)),N=W=K=V):(N=W=null,Re===null&&(B=!0)),J=ve,pe=G(J+A))}N!=null&&N!=W&&he!=J&&R(E,J,C(N),C(W),C(K),C(V))}else for(let G=A==1?s:r;G>=s&&G<=r;G+=A){let N=l[G];N===null?B=!0:N!=null&&S(E,b(a[G]),C(N))}let[D,H]=pd(t,i);if(o.fill!=null||D!=0){let G=y.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,D),W=C(N),K=b(a[s]),V=b(a[r]);A==-1&&([V,K]=[K,V]),S(G,V,W),S(G,K,W)}if(!o.spanGaps){let G=[];B&&G.push(...md(a,l,s,r,A,b,e)),y.gaps=G=o.gaps(t,i,s,r,G),y.clip=Vl(G,c.ori,f,g,x,p)}return H!=0&&(y.band=H==2?[Ms(t,i,s,r,E,-1),Ms(t,i,s,r,E,1)]:Ms(t,i,s,r,E,H)),y})}function Zv(n){let e=Tt(n.align,1),t=Tt(n.ascDesc,!1),i=Tt(n.alignGaps,0),s=Tt(n.extend,!1);return(r,o,a,l)=>wr(r,o,(c,h,u,d,f,g,x,p,m,b,C)=>{[a,l]=Fl(u,a,l);let S=c.pxRound,{left:R,width:A}=r.bbox,y=Q=>S(g(Q,d,b,p)),E=Q=>S(x(Q,f,C,m)),B=d.ori==0?co:ho,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},D=U.stroke,H=d.dir*(d.ori==0?1:-1),G=E(u[H==1?a:l]),N=y(h[H==1?a:l]),W=N,K=N;s&&e==-1&&(K=R,B(D,K,G)),B(D,N,G);for(let Q=H==1?a:l;Q>=a&&Q<=l;Q+=H){let se=u[Q];if(se==null)continue;let pe=y(h[Q]),fe=E(se);e==1?B(D,pe,G):B(D,W,fe),B(D,pe,fe),G=fe,W=pe}let V=W;s&&e==1&&(V=R+A,B(D,V,G));let[he,J]=pd(r,o);if(c.fill!=null||he!=0){let Q=U.fill=new Path2D(D),se=c.fillTo(r,o,c.min,c.max,he),pe=E(se);B(Q,V,pe),B(Q,K,pe)}if(!c.spanGaps){let Q=[];Q.push(...md(h,u,a,l,H,y,i));let se=c.width*Ct/2,pe=t||e==1?se:-se,fe=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=pe,ee[1]+=fe}),U.gaps=Q=c.gaps(r,o,a,l,Q),U.clip=Vl(Q,d.ori,p,m,b,C)}return J!=0&&(U.band=J==2?[Ms(r,o,a,l,D,-1),Ms(r,o,a,l,D,1)]:Ms(r,o,a,l,D,J)),U})}function Em(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Sn(n[l]-n[a]);h<c&&(c=h,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Kv(n){n=n||ga;let e=Tt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=bt(s),o=1-e[0],a=Tt(e[1],Bt),l=Tt(e[2],1),c=Tt(n.disp,ga),h=Tt(n.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,x,p)=>wr(f,g,(m,b,C,S,R,A,y,E,B,U,D)=>{let H=m.pxRound,G=t,N=i*Ct,W=a*Ct,K=l*Ct,V,he;S.ori==0?[V,he]=r(f,g):[he,V]=r(f,g);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Wl:gd,se=S.ori==0?h:(Le,Ye,ot,Ee,kt,He,qe)=>{h(Le,Ye,ot,kt,Ee,qe,He)},pe=Tt(f.bands,cd).find(Le=>Le.series[0]==g),fe=pe!=null?pe.dir:0,ee=m.fillTo(f,g,m.min,m.max,fe),xe=H(y(ee,R,D,B)),ve,Re,we,Xe=U,rt=H(m.width*Ct),Ge=!1,ft=null,ht=null,it=null,Zt=null;u!=null&&(rt==0||d!=null)&&(Ge=!0,ft=u.values(f,g,x,p),ht=new Map,new Set(ft).forEach(Le=>{Le!=null&&ht.set(Le,new Path2D)}),rt>0&&(it=d.values(f,g,x,p),Zt=new Map,new Set(it).forEach(Le=>{Le!=null&&Zt.set(Le,new Path2D)})));let{x0:Vt,size:hn}=c;if(Vt!=null&&hn!=null){G=1,b=Vt.values(f,g,x,p),Vt.unit==2&&(b=b.map(ot=>f.posToVal(E+ot*U,S.key,!0)));let Le=hn.values(f,g,x,p);hn.unit==2?Re=Le[0]*U:Re=A(Le[0],S,U,E)-A(0,S,U,E),Xe=Em(b,C,A,S,U,E,Xe),we=Xe-Re+N}else Xe=Em(b,C,A,S,U,E,Xe),we=Xe*o+N,Re=Xe-we;we<1&&(we=0),rt>=Re/2&&(rt=0),we<5&&(H=Nm);let Ot=we>0,An=Xe-we-(Ot?rt:0);Re=H(Ju(An,K,W)),ve=(G==0?Re/2:G==J?0:Re)-G*J*((G==0?N/2:0)+(Ot?rt/2:0));let St={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vn=Ge?null:new Path2D,tn=null;if(pe!=null)tn=f.data[pe.series[1]];else{let{y0:Le,y1:Ye}=c;Le!=null&&Ye!=null&&(C=Ye.values(f,g,x,p),tn=Le.values(f,g,x,p))}let un=V*Re,F=he*Re;for(let Le=J==1?x:p;Le>=x&&Le<=p;Le+=J){let Ye=C[Le];if(Ye==null)continue;if(tn!=null){let X=tn[Le]??0;if(Ye-X==0)continue;xe=y(X,R,D,B)}let ot=S.distr!=2||c!=null?b[Le]:Le,Ee=A(ot,S,U,E),kt=y(Tt(Ye,ee),R,D,B),He=H(Ee-ve),qe=H(jn(kt,xe)),P=H(Hi(kt,xe)),M=qe-P;if(Ye!=null){let X=Ye<0?F:un,ue=Ye<0?un:F;Ge?(rt>0&&it[Le]!=null&&Q(Zt.get(it[Le]),He,P+mi(rt/2),Re,jn(0,M-rt),X,ue),ft[Le]!=null&&Q(ht.get(ft[Le]),He,P+mi(rt/2),Re,jn(0,M-rt),X,ue)):Q(vn,He,P+mi(rt/2),Re,jn(0,M-rt),X,ue),se(f,g,Le,He-rt/2,P,Re+rt,M)}}return rt>0?St.stroke=Ge?Zt:vn:Ge||(St._fill=m.width==0?m._fill:m._stroke??m._fill,St.width=0),St.fill=Ge?ht:vn,St})}function Jv(n,e){let t=Tt(e?.alignGaps,0);return(i,s,r,o)=>wr(i,s,(a,l,c,h,u,d,f,g,x,p,m)=>{[r,o]=Fl(c,r,o);let b=a.pxRound,C=V=>b(d(V,h,p,g)),S=V=>b(f(V,u,m,x)),R,A,y;h.ori==0?(R=Hl,y=co,A=ag):(R=Gl,y=ho,A=lg);let E=h.dir*(h.ori==0?1:-1),B=C(l[E==1?r:o]),U=B,D=[],H=[];for(let V=E==1?r:o;V>=r&&V<=o;V+=E)if(c[V]!=null){let J=l[V],Q=C(J);D.push(U=Q),H.push(S(c[V]))}let G={stroke:n(D,H,R,y,A,b),fill:null,clip:null,band:null,gaps:null,flags:ao},N=G.stroke,[W,K]=pd(i,s);if(a.fill!=null||W!=0){let V=G.fill=new Path2D(N),he=a.fillTo(i,s,a.min,a.max,W),J=S(he);y(V,U,J),y(V,B,J)}if(!a.spanGaps){let V=[];V.push(...md(l,c,r,o,E,C,t)),G.gaps=V=a.gaps(i,s,r,o,V),G.clip=Vl(V,h.ori,g,x,p,m)}return K!=0&&(G.band=K==2?[Ms(i,s,r,o,N,-1),Ms(i,s,r,o,N,1)]:Ms(i,s,r,o,N,K)),G})}function jv(n){return Jv(Qv,n)}function Qv(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=n[d+1]-n[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,e[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,n[d+1],e[d+1])}return a}var td=new Set;function Tm(){for(let n of td)n.syncRect(!0)}lo&&(Mr(Dy,io,Tm),Mr(Ny,io,Tm,!0),Mr(Nl,io,()=>{xn.pxRatio=Ct}));var eb=ug(),tb=cg();function Am(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>nd(r,o,e,t))}function nb(n,e){return n.map((t,i)=>i==0?{}:gn({},e,t))}function nd(n,e,t,i){return gn({},e==0?t:i,n)}function dg(n,e,t){return e==null?ro:[e,t]}var ib=dg;function sb(n,e,t){return e==null?ro:Ul(e,t,ad,!0)}function fg(n,e,t,i){return e==null?ro:kl(e,t,n.scales[i].log,!1)}var rb=fg;function pg(n,e,t,i){return e==null?ro:od(e,t,n.scales[i].log,!1)}var ob=pg;function ab(n,e,t,i,s){let r=jn(rm(n),rm(e)),o=e-n,a=Vi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Cm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Ct))+"px"),[n,e,t]}function lb(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=zt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function xn(n,e,t){let i={mode:Tt(n.mode,1)},s=i.mode;function r(_,w,L,I){let z=w.valToPct(_);return I+L*(w.dir==-1?1-z:z)}function o(_,w,L,I){let z=w.valToPct(_);return I+L*(w.dir==-1?z:1-z)}function a(_,w,L,I){return w.ori==0?r(_,w,L,I):o(_,w,L,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ri(my);if(n.id!=null&&(c.id=n.id),pi(c,n.class),n.title){let _=Ri(_y,c);_.textContent=n.title}let h=zi("canvas"),u=i.ctx=h.getContext("2d"),d=Ri(yy,c);Mr("click",d,_=>{_.target===g&&(Gt!=Xr||Kt!=$r)&&Un.click(i,_)},!0);let f=i.under=Ri(vy,d);d.appendChild(h);let g=i.over=Ri(by,d);n=oo(n);let x=+Tt(n.pxAlign,1),p=wm(x);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let m=n.ms||.001,b=i.series=s==1?Am(n.series||[],xm,Mm,!1):nb(n.series||[null],bm),C=i.axes=Am(n.axes||[],gm,ym,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(_=>{_.fill=bt(_.fill||null),_.dir=Tt(_.dir,-1)});let A=s==2?b[1].facets[0].scale:b[0].scale,y={axes:_s,series:mt},E=(n.drawOrder||["axes","series"]).map(_=>y[_]);function B(_){let w=_.distr==3?L=>bs(L>0?L:_.clamp(i,L,_.min,_.max,_.key)):_.distr==4?L=>Gu(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let I=w(L),{_min:z,_max:Z}=_,ae=Z-z;return(I-z)/ae}}function U(_){let w=S[_];if(w==null){let L=(n.scales||ga)[_]||ga;if(L.from!=null){U(L.from);let I=gn({},S[L.from],L,{key:_});I.valToPct=B(I),S[_]=I}else{w=S[_]=gn({},_==A?ng:Wv,L),w.key=_;let I=w.time,z=w.range,Z=Zs(z);if((_!=A||s==2&&!I)&&(Z&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?nm:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?nm:{mode:1,hard:z[1],soft:z[1]}},Z=!1),!Z&&zl(z))){let ae=z;z=(me,Me,Ue)=>Me==null?ro:Ul(Me,Ue,ae)}w.range=bt(z||(I?ib:_==A?w.distr==3?rb:w.distr==4?ob:dg:w.distr==3?fg:w.distr==4?pg:sb)),w.auto=bt(Z?!1:w.auto),w.clamp=bt(w.clamp||Gv),w._min=w._max=null,w.valToPct=B(w)}}}U("x"),U("y"),s==1&&b.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in n.scales)U(_);let D=S[A],H=D.distr,G,N;D.ori==0?(pi(c,gy),G=r,N=o):(pi(c,xy),G=o,N=r);let W={};for(let _ in S){let w=S[_];(w.min!=null||w.max!=null)&&(W[_]={min:w.min,max:w.max},w.min=w.max=null)}let K=n.tzDate||(_=>new Date(Mn(_/m))),V=n.fmtDate||hd,he=m==1?gv(K):yv(K),J=fm(K,dm(m==1?mv:_v,V)),Q=mm(K,pm(bv,V)),se=[],pe=i.legend=gn({},wv,n.legend),fe=i.cursor=gn({},Pv,{drag:{y:s==2}},n.cursor),ee=pe.show,xe=fe.show,ve=pe.markers;pe.idxs=se,ve.width=bt(ve.width),ve.dash=bt(ve.dash),ve.stroke=bt(ve.stroke),ve.fill=bt(ve.fill);let Re,we,Xe,rt=[],Ge=[],ft,ht=!1,it={};if(pe.live){let _=b[1]?b[1].values:null;ht=_!=null,ft=ht?_(i,1,0):{_:0};for(let w in ft)it[w]=sd}if(ee)if(Re=zi("table",Ay,c),Xe=zi("tbody",null,Re),pe.mount(i,Re),ht){we=zi("thead",null,Re,Xe);let _=zi("tr",null,we);zi("th",null,_);for(var Zt in ft)zi("th",Gp,_).textContent=Zt}else pi(Re,Ry),pe.live&&pi(Re,Cy);let Vt={show:!0},hn={show:!1};function Ot(_,w){if(w==0&&(ht||!pe.live||s==2))return ro;let L=[],I=zi("tr",Py,Xe,Xe.childNodes[w]);pi(I,_.class),_.show||pi(I,br);let z=zi("th",null,I);if(ve.show){let me=Ri(Ly,z);if(w>0){let Me=ve.width(i,w);Me&&(me.style.border=Me+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),me.style.background=ve.fill(i,w)}}let Z=Ri(Gp,z);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,w>0&&(ve.show||(Z.style.color=_.width>0?ve.stroke(i,w):ve.fill(i,w)),St("click",z,me=>{if(fe._lock)return;Je(me);let Me=b.indexOf(_);if((me.ctrlKey||me.metaKey)!=pe.isolate){let Ue=b.some((Oe,ke)=>ke>0&&ke!=Me&&Oe.show);b.forEach((Oe,ke)=>{ke>0&&Qi(ke,Ue?ke==Me?Vt:hn:Vt,!0,mn.setSeries)})}else Qi(Me,{show:!_.show},!0,mn.setSeries)},!1),je&&St(qp,z,me=>{fe._lock||(Je(me),Qi(b.indexOf(_),Yr,!0,mn.setSeries))},!1));for(var ae in ft){let me=zi("td",Iy,I);me.textContent="--",L.push(me)}return[I,L]}let An=new Map;function St(_,w,L,I=!0){let z=An.get(w)||{},Z=fe.bind[_](i,w,L,I);Z&&(Mr(_,w,z[_]=Z),An.set(w,z))}function vn(_,w,L){let I=An.get(w)||{};for(let z in I)(_==null||z==_)&&(Ku(z,w,I[z]),delete I[z]);_==null&&An.delete(w)}let tn=0,un=0,F=0,Le=0,Ye=0,ot=0,Ee=Ye,kt=ot,He=F,qe=Le,P=0,M=0,X=0,ue=0;i.bbox={};let oe=!1,ye=!1,be=!1,te=!1,ie=!1,ge=!1;function O(_,w,L){(L||_!=i.width||w!=i.height)&&re(_,w),ut(!1),be=!0,ye=!0,Fn()}function re(_,w){i.width=tn=F=_,i.height=un=Le=w,Ye=ot=0,Se(),We();let L=i.bbox;P=L.left=yr(Ye*Ct,.5),M=L.top=yr(ot*Ct,.5),X=L.width=yr(F*Ct,.5),ue=L.height=yr(Le*Ct,.5)}let ne=3;function Te(){let _=!1,w=0;for(;!_;){w++;let L=Hr(w),I=ji(w);_=w==ne||L&&I,_||(re(i.width,i.height),ye=!0)}}function _e({width:_,height:w}){O(_,w)}i.setSize=_e;function Se(){let _=!1,w=!1,L=!1,I=!1;C.forEach((z,Z)=>{if(z.show&&z._show){let{side:ae,_size:me}=z,Me=ae%2,Ue=z.label!=null?z.labelSize:0,Oe=me+Ue;Oe>0&&(Me?(F-=Oe,ae==3?(Ye+=Oe,I=!0):L=!0):(Le-=Oe,ae==0?(ot+=Oe,_=!0):w=!0))}}),Ki[0]=_,Ki[1]=L,Ki[2]=w,Ki[3]=I,F-=Oi[1]+Oi[3],Ye+=Oi[3],Le-=Oi[2]+Oi[0],ot+=Oi[0]}function We(){let _=Ye+F,w=ot+Le,L=Ye,I=ot;function z(Z,ae){switch(Z){case 1:return _+=ae,_-ae;case 2:return w+=ae,w-ae;case 3:return L-=ae,L+ae;case 0:return I-=ae,I+ae}}C.forEach((Z,ae)=>{if(Z.show&&Z._show){let me=Z.side;Z._pos=z(me,Z._size),Z.label!=null&&(Z._lpos=z(me,Z.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let L=_.prox=bt(_.prox),I=_.bias??=0;fe.dataIdx=(z,Z,ae,me)=>{if(Z==0)return ae;let Me=ae,Ue=L(z,Z,ae,me)??Bt,Oe=Ue>=0&&Ue<Bt,ke=D.ori==0?F:Le,st=fe.left,At=e[0],Et=e[Z];if(w.has(Et[ae])){Me=null;let yt=null,Ke=null,$e;if(I==0||I==-1)for($e=ae;yt==null&&$e-- >0;)w.has(Et[$e])||(yt=$e);if(I==0||I==1)for($e=ae;Ke==null&&$e++<Et.length;)w.has(Et[$e])||(Ke=$e);if(yt!=null||Ke!=null)if(Oe){let Xt=yt==null?-1/0:G(At[yt],D,ke,0),rn=Ke==null?1/0:G(At[Ke],D,ke,0),Ln=st-Xt,Ft=rn-st;Ln<=Ft?Ln<=Ue&&(Me=yt):Ft<=Ue&&(Me=Ke)}else Me=Ke==null?yt:yt==null?Ke:ae-yt<=Ke-ae?yt:Ke}else Oe&&Sn(st-G(At[ae],D,ke,0))>Ue&&(Me=null);return Me}}let Je=_=>{fe.event=_};fe.idxs=se,fe._lock=!1;let ce=fe.points;ce.show=bt(ce.show),ce.size=bt(ce.size),ce.stroke=bt(ce.stroke),ce.width=bt(ce.width),ce.fill=bt(ce.fill);let Be=i.focus=gn({},n.focus||{alpha:.3},fe.focus),je=Be.prox>=0,Pe=je&&ce.one,lt=[],Ht=[],Xn=[];function Zo(_,w){let L=ce.show(i,w);if(L instanceof HTMLElement)return pi(L,Ty),pi(L,_.class),as(L,-10,-10,F,Le),g.insertBefore(L,lt[w]),L}function Br(_,w){if(s==1||w>0){let L=s==1&&S[_.scale].time,I=_.value;_.value=L?lm(I)?mm(K,pm(I,V)):I||Q:I||zv,_.label=_.label||(L?Iv:Lv)}if(Pe||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||eb||Wy,_.fillTo=bt(_.fillTo||Xv),_.pxAlign=+Tt(_.pxAlign,x),_.pxRound=wm(_.pxAlign),_.stroke=bt(_.stroke||null),_.fill=bt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=Vv(jn(1,_.width),1),I=_.points=gn({},{size:L,width:jn(1,L*.2),stroke:_.stroke,space:L*2,paths:tb,_stroke:null,_fill:null},_.points);I.show=bt(I.show),I.filter=bt(I.filter),I.fill=bt(I.fill),I.stroke=bt(I.stroke),I.paths=bt(I.paths),I.pxAlign=_.pxAlign}if(ee){let L=Ot(_,w);rt.splice(w,0,L[0]),Ge.splice(w,0,L[1]),pe.values.push(null)}if(xe){se.splice(w,0,null);let L=null;Pe?w==0&&(L=Zo(_,w)):w>0&&(L=Zo(_,w)),lt.splice(w,0,L),Ht.splice(w,0,0),Xn.splice(w,0,0)}Pn("addSeries",w)}function lu(_,w){w=w??b.length,_=s==1?nd(_,w,xm,Mm):nd(_,w,{},bm),b.splice(w,0,_),Br(b[w],w)}i.addSeries=lu;function ul(_){if(b.splice(_,1),ee){pe.values.splice(_,1),Ge.splice(_,1);let w=rt.splice(_,1)[0];vn(null,w.firstChild),w.remove()}xe&&(se.splice(_,1),lt.splice(_,1)[0].remove(),Ht.splice(_,1),Xn.splice(_,1)),Pn("delSeries",_)}i.delSeries=ul;let Ki=[!1,!1,!1,!1];function ms(_,w){if(_._show=_.show,_.show){let L=_.side%2,I=S[_.scale];I==null&&(_.scale=L?b[1].scale:A,I=S[_.scale]);let z=I.time;_.size=bt(_.size),_.space=bt(_.space),_.rotate=bt(_.rotate),Zs(_.incrs)&&_.incrs.forEach(ae=>{!Ks.has(ae)&&Ks.set(ae,Fm(ae))}),_.incrs=bt(_.incrs||(I.distr==2?dv:z?m==1?pv:xv:vr)),_.splits=bt(_.splits||(z&&I.distr==1?he:I.distr==3?ju:I.distr==4?Uv:Nv)),_.stroke=bt(_.stroke),_.grid.stroke=bt(_.grid.stroke),_.ticks.stroke=bt(_.ticks.stroke),_.border.stroke=bt(_.border.stroke);let Z=_.values;_.values=Zs(Z)&&!Zs(Z[0])?bt(Z):z?Zs(Z)?fm(K,dm(Z,V)):lm(Z)?vv(K,Z):Z||J:Z||Dv,_.filter=bt(_.filter||(I.distr>=3&&I.log==10?kv:I.distr==3&&I.log==2?Bv:Um)),_.font=Cm(_.font),_.labelFont=Cm(_.labelFont),_._size=_.size(i,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Ki[w]=!0,_._el=Ri(My,d))}}function gs(_,w,L,I){let[z,Z,ae,me]=L,Me=w%2,Ue=0;return Me==0&&(me||Z)&&(Ue=w==0&&!z||w==2&&!ae?Mn(gm.size/3):0),Me==1&&(z||ae)&&(Ue=w==1&&!Z||w==3&&!me?Mn(ym.size/2):0),Ue}let Ko=i.padding=(n.padding||[gs,gs,gs,gs]).map(_=>bt(Tt(_,gs))),Oi=i._padding=Ko.map((_,w)=>_(i,w,Ki,0)),nn,ln=null,cn=null,Ji=s==1?b[0].idxs:null,hi=null,ks=!1;function Jo(_,w){if(e=_??[],i.data=i._data=e,s==2){nn=0;for(let L=1;L<b.length;L++)nn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),hi=e[0],nn=hi.length;let L=e;if(H==2){L=e.slice();let I=L[0]=Array(nn);for(let z=0;z<nn;z++)I[z]=z}i._data=e=L}if(ut(!0),Pn("setData"),H==2&&(be=!0),w!==!1){let L=D;L.auto(i,ks)?jo():Vs(A,L.min,L.max),te=te||fe.left>=0,ge=!0,Fn()}}i.setData=Jo;function jo(){ks=!0;let _,w;s==1&&(nn>0?(ln=Ji[0]=0,cn=Ji[1]=nn-1,_=e[0][ln],w=e[0][cn],H==2?(_=ln,w=cn):_==w&&(H==3?[_,w]=kl(_,_,D.log,!1):H==4?[_,w]=od(_,_,D.log,!1):D.time?w=_+Mn(86400/m):[_,w]=Ul(_,w,ad,!0))):(ln=Ji[0]=_=null,cn=Ji[1]=w=null)),Vs(A,_,w)}let zr,Bs,Vr,T,k,j,$,Y,Ae,Ie;function Ce(_,w,L,I,z,Z){_??=Xp,L??=cd,I??="butt",z??=Xp,Z??="round",_!=zr&&(u.strokeStyle=zr=_),z!=Bs&&(u.fillStyle=Bs=z),w!=Vr&&(u.lineWidth=Vr=w),Z!=k&&(u.lineJoin=k=Z),I!=j&&(u.lineCap=j=I),L!=T&&u.setLineDash(T=L)}function De(_,w,L,I){w!=Bs&&(u.fillStyle=Bs=w),_!=$&&(u.font=$=_),L!=Y&&(u.textAlign=Y=L),I!=Ae&&(u.textBaseline=Ae=I)}function Ve(_,w,L,I,z=0){if(I.length>0&&_.auto(i,ks)&&(w==null||w.min==null)){let Z=Tt(ln,0),ae=Tt(cn,I.length-1),me=L.min==null?ky(I,Z,ae,z,_.distr==3):[L.min,L.max];_.min=Hi(_.min,L.min=me[0]),_.max=jn(_.max,L.max=me[1])}}let Qe={min:null,max:null};function pt(){for(let I in S){let z=S[I];W[I]==null&&(z.min==null||W[A]!=null&&z.auto(i,ks))&&(W[I]=Qe)}for(let I in S){let z=S[I];W[I]==null&&z.from!=null&&W[z.from]!=null&&(W[I]=Qe)}W[A]!=null&&ut(!0);let _={};for(let I in W){let z=W[I];if(z!=null){let Z=_[I]=oo(S[I],qy);if(z.min!=null)gn(Z,z);else if(I!=A||s==2)if(nn==0&&Z.from==null){let ae=Z.range(i,null,null,I);Z.min=ae[0],Z.max=ae[1]}else Z.min=Bt,Z.max=-Bt}}if(nn>0){b.forEach((I,z)=>{if(s==1){let Z=I.scale,ae=W[Z];if(ae==null)return;let me=_[Z];if(z==0){let Me=me.range(i,me.min,me.max,Z);me.min=Me[0],me.max=Me[1],ln=Vi(me.min,e[0]),cn=Vi(me.max,e[0]),cn-ln>1&&(e[0][ln]<me.min&&ln++,e[0][cn]>me.max&&cn--),I.min=hi[ln],I.max=hi[cn]}else I.show&&I.auto&&Ve(me,ae,I,e[z],I.sorted);I.idxs[0]=ln,I.idxs[1]=cn}else if(z>0&&I.show&&I.auto){let[Z,ae]=I.facets,me=Z.scale,Me=ae.scale,[Ue,Oe]=e[z],ke=_[me],st=_[Me];ke!=null&&Ve(ke,W[me],Z,Ue,Z.sorted),st!=null&&Ve(st,W[Me],ae,Oe,ae.sorted),I.min=ae.min,I.max=ae.max}});for(let I in _){let z=_[I],Z=W[I];if(z.from==null&&(Z==null||Z.min==null)){let ae=z.range(i,z.min==Bt?null:z.min,z.max==-Bt?null:z.max,I);z.min=ae[0],z.max=ae[1]}}}for(let I in _){let z=_[I];if(z.from!=null){let Z=_[z.from];if(Z.min==null)z.min=z.max=null;else{let ae=z.range(i,Z.min,Z.max,I);z.min=ae[0],z.max=ae[1]}}}let w={},L=!1;for(let I in _){let z=_[I],Z=S[I];if(Z.min!=z.min||Z.max!=z.max){Z.min=z.min,Z.max=z.max;let ae=Z.distr;Z._min=ae==3?bs(Z.min):ae==4?Gu(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?bs(Z.max):ae==4?Gu(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,w[I]=L=!0}}if(L){b.forEach((I,z)=>{s==2?z>0&&w.y&&(I._paths=null):w[I.scale]&&(I._paths=null)});for(let I in w)be=!0,Pn("setScale",I);xe&&fe.left>=0&&(te=ge=!0)}for(let I in W)W[I]=null}function ze(_){let w=Ju(ln-1,0,nn-1),L=Ju(cn+1,0,nn-1);for(;_[w]==null&&w>0;)w--;for(;_[L]==null&&L<nn-1;)L++;return[w,L]}function mt(){if(nn>0){let _=b.some(w=>w._focus)&&Ie!=Be.alpha;_&&(u.globalAlpha=Ie=Be.alpha),b.forEach((w,L)=>{if(L>0&&w.show&&(jt(L,!1),jt(L,!0),w._paths==null)){let I=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha);let z=s==2?[0,e[L][0].length-1]:ze(e[L]);w._paths=w.paths(i,L,z[0],z[1]),Ie!=I&&(u.globalAlpha=Ie=I)}}),b.forEach((w,L)=>{if(L>0&&w.show){let I=Ie;Ie!=w.alpha&&(u.globalAlpha=Ie=w.alpha),w._paths!=null&&Dt(L,!1);{let z=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,L,ln,cn,z),ae=w.points.filter(i,L,Z,z);(Z||ae)&&(w.points._paths=w.points.paths(i,L,ln,cn,ae),Dt(L,!0))}Ie!=I&&(u.globalAlpha=Ie=I),Pn("drawSeries",L)}}),_&&(u.globalAlpha=Ie=1)}}function jt(_,w){let L=w?b[_].points:b[_];L._stroke=L.stroke(i,_),L._fill=L.fill(i,_)}function Dt(_,w){let L=w?b[_].points:b[_],{stroke:I,fill:z,clip:Z,flags:ae,_stroke:me=L._stroke,_fill:Me=L._fill,_width:Ue=L.width}=L._paths;Ue=zt(Ue*Ct,3);let Oe=null,ke=Ue%2/2;w&&Me==null&&(Me=Ue>0?"#fff":me);let st=L.pxAlign==1&&ke>0;if(st&&u.translate(ke,ke),!w){let At=P-Ue/2,Et=M-Ue/2,yt=X+Ue,Ke=ue+Ue;Oe=new Path2D,Oe.rect(At,Et,yt,Ke)}w?Fe(me,Ue,L.dash,L.cap,Me,I,z,ae,Z):Nt(_,me,Ue,L.dash,L.cap,Me,I,z,ae,Oe,Z),st&&u.translate(-ke,-ke)}function Nt(_,w,L,I,z,Z,ae,me,Me,Ue,Oe){let ke=!1;Me!=0&&R.forEach((st,At)=>{if(st.series[0]==_){let Et=b[st.series[1]],yt=e[st.series[1]],Ke=(Et._paths||ga).band;Zs(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let $e,Xt=null;Et.show&&Ke&&zy(yt,ln,cn)?(Xt=st.fill(i,At)||Z,$e=Et._paths.clip):Ke=null,Fe(w,L,I,z,Xt,ae,me,Me,Ue,Oe,$e,Ke),ke=!0}}),ke||Fe(w,L,I,z,Z,ae,me,Me,Ue,Oe)}let bn=ao|ed;function Fe(_,w,L,I,z,Z,ae,me,Me,Ue,Oe,ke){Ce(_,w,L,I,z),(Me||Ue||ke)&&(u.save(),Me&&u.clip(Me),Ue&&u.clip(Ue)),ke?(me&bn)==bn?(u.clip(ke),Oe&&u.clip(Oe),vt(z,ae),dn(_,Z,w)):me&ed?(vt(z,ae),u.clip(ke),dn(_,Z,w)):me&ao&&(u.save(),u.clip(ke),Oe&&u.clip(Oe),vt(z,ae),u.restore(),dn(_,Z,w)):(vt(z,ae),dn(_,Z,w)),(Me||Ue||ke)&&u.restore()}function dn(_,w,L){L>0&&(w instanceof Map?w.forEach((I,z)=>{u.strokeStyle=zr=z,u.stroke(I)}):w!=null&&_&&u.stroke(w))}function vt(_,w){w instanceof Map?w.forEach((L,I)=>{u.fillStyle=Bs=I,u.fill(L)}):w!=null&&_&&u.fill(w)}function xs(_,w,L,I){let z=C[_],Z;if(I<=0)Z=[0,0];else{let ae=z._space=z.space(i,_,w,L,I),me=z._incrs=z.incrs(i,_,w,L,I,ae);Z=ab(w,L,me,I,ae)}return z._found=Z}function fn(_,w,L,I,z,Z,ae,me,Me,Ue){let Oe=ae%2/2;x==1&&u.translate(Oe,Oe),Ce(me,ae,Me,Ue,me),u.beginPath();let ke,st,At,Et,yt=z+(I==0||I==3?-Z:Z);L==0?(st=z,Et=yt):(ke=z,At=yt);for(let Ke=0;Ke<_.length;Ke++)w[Ke]!=null&&(L==0?ke=At=_[Ke]:st=Et=_[Ke],u.moveTo(ke,st),u.lineTo(At,Et));u.stroke(),x==1&&u.translate(-Oe,-Oe)}function Hr(_){let w=!0;return C.forEach((L,I)=>{if(!L.show)return;let z=S[L.scale];if(z.min==null){L._show&&(w=!1,L._show=!1,ut(!1));return}else L._show||(w=!1,L._show=!0,ut(!1));let Z=L.side,ae=Z%2,{min:me,max:Me}=z,[Ue,Oe]=xs(I,me,Me,ae==0?F:Le);if(Oe==0)return;let ke=z.distr==2,st=L._splits=L.splits(i,I,me,Me,Ue,Oe,ke),At=z.distr==2?st.map($e=>hi[$e]):st,Et=z.distr==2?hi[st[1]]-hi[st[0]]:Ue,yt=L._values=L.values(i,L.filter(i,At,I,Oe,Et),I,Oe,Et);L._rotate=Z==2?L.rotate(i,yt,I,Oe):0;let Ke=L._size;L._size=Pi(L.size(i,yt,I,_)),Ke!=null&&L._size!=Ke&&(w=!1)}),w}function ji(_){let w=!0;return Ko.forEach((L,I)=>{let z=L(i,I,Ki,_);z!=Oi[I]&&(w=!1),Oi[I]=z}),w}function _s(){for(let _=0;_<C.length;_++){let w=C[_];if(!w.show||!w._show)continue;let L=w.side,I=L%2,z,Z,ae=w.stroke(i,_),me=L==0||L==3?-1:1,[Me,Ue]=w._found;if(w.label!=null){let Yn=w.labelGap*me,fi=Mn((w._lpos+Yn)*Ct);De(w.labelFont[0],ae,"center",L==2?"top":Wp),u.save(),I==1?(z=Z=0,u.translate(fi,Mn(M+ue/2)),u.rotate((L==3?-Dl:Dl)/2)):(z=Mn(P+X/2),Z=fi);let mr=Dm(w.label)?w.label(i,_,Me,Ue):w.label;u.fillText(mr,z,Z),u.restore()}if(Ue==0)continue;let Oe=S[w.scale],ke=I==0?X:ue,st=I==0?P:M,At=w._splits,Et=Oe.distr==2?At.map(Yn=>hi[Yn]):At,yt=Oe.distr==2?hi[At[1]]-hi[At[0]]:Me,Ke=w.ticks,$e=w.border,Xt=Ke.show?Ke.size:0,rn=Mn(Xt*Ct),Ln=Mn((w.alignTo==2?w._size-Xt-w.gap:w.gap)*Ct),Ft=w._rotate*-Dl/180,on=p(w._pos*Ct),ui=(rn+Ln)*me,qn=on+ui;Z=I==0?qn:0,z=I==1?qn:0;let Ei=w.font[0],Fi=w.align==1?to:w.align==2?zu:Ft>0?to:Ft<0?zu:I==0?"center":L==3?zu:to,ts=Ft||I==1?"middle":L==2?"top":Wp;De(Ei,ae,Fi,ts);let di=w.font[1]*w.lineGap,Ti=At.map(Yn=>p(a(Yn,Oe,ke,st))),ki=w._values;for(let Yn=0;Yn<ki.length;Yn++){let fi=ki[Yn];if(fi!=null){I==0?z=Ti[Yn]:Z=Ti[Yn],fi=""+fi;let mr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Zn=0;Zn<mr.length;Zn++){let Sp=mr[Zn];Ft?(u.save(),u.translate(z,Z+Zn*di),u.rotate(Ft),u.fillText(Sp,0,0),u.restore()):u.fillText(Sp,z,Z+Zn*di)}}}Ke.show&&fn(Ti,Ke.filter(i,Et,_,Ue,yt),I,L,on,rn,zt(Ke.width*Ct,3),Ke.stroke(i,_),Ke.dash,Ke.cap);let ns=w.grid;ns.show&&fn(Ti,ns.filter(i,Et,_,Ue,yt),I,I==0?2:1,I==0?M:P,I==0?ue:X,zt(ns.width*Ct,3),ns.stroke(i,_),ns.dash,ns.cap),$e.show&&fn([on],[1],I==0?1:0,I==0?1:2,I==1?M:P,I==1?ue:X,zt($e.width*Ct,3),$e.stroke(i,_),$e.dash,$e.cap)}Pn("drawAxes")}function ut(_){b.forEach((w,L)=>{L>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(I=>{I.min=null,I.max=null})))})}let sn=!1,$n=!1,Ut=[];function pn(){$n=!1;for(let _=0;_<Ut.length;_++)Pn(...Ut[_]);Ut.length=0}function Fn(){sn||(ev(rp),sn=!0)}function dl(_,w=!1){sn=!0,$n=w,_(i),rp(),w&&Ut.length>0&&queueMicrotask(pn)}i.batch=dl;function rp(){if(oe&&(pt(),oe=!1),be&&(Te(),be=!1),ye){if($t(f,to,Ye),$t(f,"top",ot),$t(f,da,F),$t(f,fa,Le),$t(g,to,Ye),$t(g,"top",ot),$t(g,da,F),$t(g,fa,Le),$t(d,da,tn),$t(d,fa,un),h.width=Mn(tn*Ct),h.height=Mn(un*Ct),C.forEach(({_el:_,_show:w,_size:L,_pos:I,side:z})=>{if(_!=null)if(w){let Z=z===3||z===0?L:0,ae=z%2==1;$t(_,ae?"left":"top",I-Z),$t(_,ae?"width":"height",L),$t(_,ae?"top":"left",ae?ot:Ye),$t(_,ae?"height":"width",ae?Le:F),Zu(_,br)}else pi(_,br)}),zr=Bs=Vr=k=j=$=Y=Ae=T=null,Ie=1,ta(!0),Ye!=Ee||ot!=kt||F!=He||Le!=qe){ut(!1);let _=F/He,w=Le/qe;if(xe&&!te&&fe.left>=0){fe.left*=_,fe.top*=w,Gr&&as(Gr,Mn(fe.left),0,F,Le),Wr&&as(Wr,0,Mn(fe.top),F,Le);for(let L=0;L<lt.length;L++){let I=lt[L];I!=null&&(Ht[L]*=_,Xn[L]*=w,as(I,Pi(Ht[L]),Pi(Xn[L]),F,Le))}}if(Wt.show&&!ie&&Wt.left>=0&&Wt.width>0){Wt.left*=_,Wt.width*=_,Wt.top*=w,Wt.height*=w;for(let L in pu)$t(qr,L,Wt[L])}Ee=Ye,kt=ot,He=F,qe=Le}Pn("setSize"),ye=!1}tn>0&&un>0&&(u.clearRect(0,0,h.width,h.height),Pn("drawClear"),E.forEach(_=>_()),Pn("draw")),Wt.show&&ie&&(fl(Wt),ie=!1),xe&&te&&(pr(null,!0,!1),te=!1),pe.show&&pe.live&&ge&&(du(),ge=!1),l||(l=!0,i.status=1,Pn("ready")),ks=!1,sn=!1}i.redraw=(_,w)=>{be=w||!1,_!==!1?Vs(A,D.min,D.max):Fn()};function cu(_,w){let L=S[_];if(L.from==null){if(nn==0){let I=L.range(i,w.min,w.max,_);w.min=I[0],w.max=I[1]}if(w.min>w.max){let I=w.min;w.min=w.max,w.max=I}if(nn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==A&&L.distr==2&&nn>0&&(w.min=Vi(w.min,e[0]),w.max=Vi(w.max,e[0]),w.min==w.max&&w.max++),W[_]=w,oe=!0,Fn()}}i.setScale=cu;let hu,uu,Gr,Wr,op,ap,Xr,$r,lp,cp,Gt,Kt,zs=!1,Un=fe.drag,Cn=Un.x,Rn=Un.y;xe&&(fe.x&&(hu=Ri(wy,g)),fe.y&&(uu=Ri(Ey,g)),D.ori==0?(Gr=hu,Wr=uu):(Gr=uu,Wr=hu),Gt=fe.left,Kt=fe.top);let Wt=i.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),qr=Wt.show?Ri(Sy,Wt.over?g:f):null;function fl(_,w){if(Wt.show){for(let L in _)Wt[L]=_[L],L in pu&&$t(qr,L,_[L]);w!==!1&&Pn("setSelect")}}i.setSelect=fl;function m_(_){if(b[_].show)ee&&Zu(rt[_],br);else if(ee&&pi(rt[_],br),xe){let L=Pe?lt[0]:lt[_];L!=null&&as(L,-10,-10,F,Le)}}function Vs(_,w,L){cu(_,{min:w,max:L})}function Qi(_,w,L,I){w.focus!=null&&v_(_),w.show!=null&&b.forEach((z,Z)=>{Z>0&&(_==Z||_==null)&&(z.show=w.show,m_(Z),s==2?(Vs(z.facets[0].scale,null,null),Vs(z.facets[1].scale,null,null)):Vs(z.scale,null,null),Fn())}),L!==!1&&Pn("setSeries",_,w),I&&na("setSeries",i,_,w)}i.setSeries=Qi;function g_(_,w){gn(R[_],w)}function x_(_,w){_.fill=bt(_.fill||null),_.dir=Tt(_.dir,-1),w=w??R.length,R.splice(w,0,_)}function __(_){_==null?R.length=0:R.splice(_,1)}i.addBand=x_,i.setBand=g_,i.delBand=__;function y_(_,w){b[_].alpha=w,xe&&lt[_]!=null&&(lt[_].style.opacity=w),ee&&rt[_]&&(rt[_].style.opacity=w)}let ys,Hs,fr,Yr={focus:!0};function v_(_){if(_!=fr){let w=_==null,L=Be.alpha!=1;b.forEach((I,z)=>{if(s==1||z>0){let Z=w||z==0||z==_;I._focus=w?null:Z,L&&y_(z,Z?1:Be.alpha)}}),fr=_,L&&Fn()}}ee&&je&&St(Yp,Re,_=>{fe._lock||(Je(_),fr!=null&&Qi(null,Yr,!0,mn.setSeries))});function es(_,w,L){let I=S[w];L&&(_=_/Ct-(I.ori==1?ot:Ye));let z=F;I.ori==1&&(z=Le,_=z-_),I.dir==-1&&(_=z-_);let Z=I._min,ae=I._max,me=_/z,Me=Z+(ae-Z)*me,Ue=I.distr;return Ue==3?so(10,Me):Ue==4?Hy(Me,I.asinh):Ue==100?I.bwd(Me):Me}function b_(_,w){let L=es(_,A,w);return Vi(L,e[0],ln,cn)}i.valToIdx=_=>Vi(_,e[0]),i.posToIdx=b_,i.posToVal=es,i.valToPos=(_,w,L)=>S[w].ori==0?r(_,S[w],L?X:F,L?P:0):o(_,S[w],L?ue:Le,L?M:0),i.setCursor=(_,w,L)=>{Gt=_.left,Kt=_.top,pr(null,w,L)};function hp(_,w){$t(qr,to,Wt.left=_),$t(qr,da,Wt.width=w)}function up(_,w){$t(qr,"top",Wt.top=_),$t(qr,fa,Wt.height=w)}let Qo=D.ori==0?hp:up,ea=D.ori==1?hp:up;function M_(){if(ee&&pe.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&ht)continue;let w=pe.values[_],L=0;for(let I in w)Ge[_][L++].firstChild.nodeValue=w[I]}}function du(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((L,I)=>{se[I]=L}):$y(_.idx)||se.fill(_.idx),pe.idx=se[0]),ee&&pe.live){for(let L=0;L<b.length;L++)(L>0||s==1&&!ht)&&S_(L,se[L]);M_()}ge=!1,w!==!1&&Pn("setLegend")}i.setLegend=du;function S_(_,w){let L=b[_],I=_==0&&H==2?hi:e[_],z;ht?z=L.values(i,_,w)??it:(z=L.value(i,w==null?null:I[w],_,w),z=z==null?it:{_:z}),pe.values[_]=z}function pr(_,w,L){lp=Gt,cp=Kt,[Gt,Kt]=fe.move(i,Gt,Kt),fe.left=Gt,fe.top=Kt,xe&&(Gr&&as(Gr,Mn(Gt),0,F,Le),Wr&&as(Wr,0,Mn(Kt),F,Le));let I,z=ln>cn;ys=Bt,Hs=null;let Z=D.ori==0?F:Le,ae=D.ori==1?F:Le;if(Gt<0||nn==0||z){I=fe.idx=null;for(let me=0;me<b.length;me++){let Me=lt[me];Me!=null&&as(Me,-10,-10,F,Le)}je&&Qi(null,Yr,!0,_==null&&mn.setSeries),pe.live&&(se.fill(I),ge=!0)}else{let me,Me,Ue;s==1&&(me=D.ori==0?Gt:Kt,Me=es(me,A),I=fe.idx=Vi(Me,e[0],ln,cn),Ue=G(e[0][I],D,Z,0));let Oe=-10,ke=-10,st=0,At=0,Et=!0,yt="",Ke="";for(let $e=s==2?1:0;$e<b.length;$e++){let Xt=b[$e],rn=se[$e],Ln=rn==null?null:s==1?e[$e][rn]:e[$e][1][rn],Ft=fe.dataIdx(i,$e,I,Me),on=Ft==null?null:s==1?e[$e][Ft]:e[$e][1][Ft];if(ge=ge||on!=Ln||Ft!=rn,se[$e]=Ft,$e>0&&Xt.show){let ui=Ft==null?-10:Ft==I?Ue:G(s==1?e[0][Ft]:e[$e][0][Ft],D,Z,0),qn=on==null?-10:N(on,s==1?S[Xt.scale]:S[Xt.facets[1].scale],ae,0);if(je&&on!=null){let Ei=D.ori==1?Gt:Kt,Fi=Sn(Be.dist(i,$e,Ft,qn,Ei));if(Fi<ys){let ts=Be.bias;if(ts!=0){let di=es(Ei,Xt.scale),Ti=on>=0?1:-1,ki=di>=0?1:-1;ki==Ti&&(ki==1?ts==1?on>=di:on<=di:ts==1?on<=di:on>=di)&&(ys=Fi,Hs=$e)}else ys=Fi,Hs=$e}}if(ge||Pe){let Ei,Fi;D.ori==0?(Ei=ui,Fi=qn):(Ei=qn,Fi=ui);let ts,di,Ti,ki,ns,Yn,fi=!0,mr=ce.bbox;if(mr!=null){fi=!1;let Zn=mr(i,$e);Ti=Zn.left,ki=Zn.top,ts=Zn.width,di=Zn.height}else Ti=Ei,ki=Fi,ts=di=ce.size(i,$e);if(Yn=ce.fill(i,$e),ns=ce.stroke(i,$e),Pe)$e==Hs&&ys<=Be.prox&&(Oe=Ti,ke=ki,st=ts,At=di,Et=fi,yt=Yn,Ke=ns);else{let Zn=lt[$e];Zn!=null&&(Ht[$e]=Ti,Xn[$e]=ki,tm(Zn,ts,di,fi),Qp(Zn,Yn,ns),as(Zn,Pi(Ti),Pi(ki),F,Le))}}}}if(Pe){let $e=Be.prox,Xt=fr==null?ys<=$e:ys>$e||Hs!=fr;if(ge||Xt){let rn=lt[0];rn!=null&&(Ht[0]=Oe,Xn[0]=ke,tm(rn,st,At,Et),Qp(rn,yt,Ke),as(rn,Pi(Oe),Pi(ke),F,Le))}}}if(Wt.show&&zs)if(_!=null){let[me,Me]=mn.scales,[Ue,Oe]=mn.match,[ke,st]=_.cursor.sync.scales,At=_.cursor.drag;if(Cn=At._x,Rn=At._y,Cn||Rn){let{left:Et,top:yt,width:Ke,height:$e}=_.select,Xt=_.scales[ke].ori,rn=_.posToVal,Ln,Ft,on,ui,qn,Ei=me!=null&&Ue(me,ke),Fi=Me!=null&&Oe(Me,st);Ei&&Cn?(Xt==0?(Ln=Et,Ft=Ke):(Ln=yt,Ft=$e),on=S[me],ui=G(rn(Ln,ke),on,Z,0),qn=G(rn(Ln+Ft,ke),on,Z,0),Qo(Hi(ui,qn),Sn(qn-ui))):Qo(0,Z),Fi&&Rn?(Xt==1?(Ln=Et,Ft=Ke):(Ln=yt,Ft=$e),on=S[Me],ui=N(rn(Ln,st),on,ae,0),qn=N(rn(Ln+Ft,st),on,ae,0),ea(Hi(ui,qn),Sn(qn-ui))):ea(0,ae)}else mu()}else{let me=Sn(lp-op),Me=Sn(cp-ap);if(D.ori==1){let st=me;me=Me,Me=st}Cn=Un.x&&me>=Un.dist,Rn=Un.y&&Me>=Un.dist;let Ue=Un.uni;Ue!=null?Cn&&Rn&&(Cn=me>=Ue,Rn=Me>=Ue,!Cn&&!Rn&&(Me>me?Rn=!0:Cn=!0)):Un.x&&Un.y&&(Cn||Rn)&&(Cn=Rn=!0);let Oe,ke;Cn&&(D.ori==0?(Oe=Xr,ke=Gt):(Oe=$r,ke=Kt),Qo(Hi(Oe,ke),Sn(ke-Oe)),Rn||ea(0,ae)),Rn&&(D.ori==1?(Oe=Xr,ke=Gt):(Oe=$r,ke=Kt),ea(Hi(Oe,ke),Sn(ke-Oe)),Cn||Qo(0,Z)),!Cn&&!Rn&&(Qo(0,0),ea(0,0))}if(Un._x=Cn,Un._y=Rn,_==null){if(L){if(Mp!=null){let[me,Me]=mn.scales;mn.values[0]=me!=null?es(D.ori==0?Gt:Kt,me):null,mn.values[1]=Me!=null?es(D.ori==1?Gt:Kt,Me):null}na(Vu,i,Gt,Kt,F,Le,I)}if(je){let me=L&&mn.setSeries,Me=Be.prox;fr==null?ys<=Me&&Qi(Hs,Yr,!0,me):ys>Me?Qi(null,Yr,!0,me):Hs!=fr&&Qi(Hs,Yr,!0,me)}}ge&&(pe.idx=I,du()),w!==!1&&Pn("setCursor")}let Gs=null;Object.defineProperty(i,"rect",{get(){return Gs==null&&ta(!1),Gs}});function ta(_=!1){_?Gs=null:(Gs=g.getBoundingClientRect(),Pn("syncRect",Gs))}function dp(_,w,L,I,z,Z,ae){fe._lock||zs&&_!=null&&_.movementX==0&&_.movementY==0||(fu(_,w,L,I,z,Z,ae,!1,_!=null),_!=null?pr(null,!0,!0):pr(w,!0,!1))}function fu(_,w,L,I,z,Z,ae,me,Me){if(Gs==null&&ta(!1),Je(_),_!=null)L=_.clientX-Gs.left,I=_.clientY-Gs.top;else{if(L<0||I<0){Gt=-10,Kt=-10;return}let[Ue,Oe]=mn.scales,ke=w.cursor.sync,[st,At]=ke.values,[Et,yt]=ke.scales,[Ke,$e]=mn.match,Xt=w.axes[0].side%2==1,rn=D.ori==0?F:Le,Ln=D.ori==1?F:Le,Ft=Xt?Z:z,on=Xt?z:Z,ui=Xt?I:L,qn=Xt?L:I;if(Et!=null?L=Ke(Ue,Et)?a(st,S[Ue],rn,0):-10:L=rn*(ui/Ft),yt!=null?I=$e(Oe,yt)?a(At,S[Oe],Ln,0):-10:I=Ln*(qn/on),D.ori==1){let Ei=L;L=I,I=Ei}}Me&&(w==null||w.cursor.event.type==Vu)&&((L<=1||L>=F-1)&&(L=yr(L,F)),(I<=1||I>=Le-1)&&(I=yr(I,Le))),me?(op=L,ap=I,[Xr,$r]=fe.move(i,L,I)):(Gt=L,Kt=I)}let pu={width:0,height:0,left:0,top:0};function mu(){fl(pu,!1)}let fp,pp,mp,gp;function xp(_,w,L,I,z,Z,ae){zs=!0,Cn=Rn=Un._x=Un._y=!1,fu(_,w,L,I,z,Z,ae,!0,!1),_!=null&&(St(Hu,qu,_p,!1),na($p,i,Xr,$r,F,Le,null));let{left:me,top:Me,width:Ue,height:Oe}=Wt;fp=me,pp=Me,mp=Ue,gp=Oe}function _p(_,w,L,I,z,Z,ae){zs=Un._x=Un._y=!1,fu(_,w,L,I,z,Z,ae,!1,!0);let{left:me,top:Me,width:Ue,height:Oe}=Wt,ke=Ue>0||Oe>0,st=fp!=me||pp!=Me||mp!=Ue||gp!=Oe;if(ke&&st&&fl(Wt),Un.setScale&&ke&&st){let At=me,Et=Ue,yt=Me,Ke=Oe;if(D.ori==1&&(At=Me,Et=Oe,yt=me,Ke=Ue),Cn&&Vs(A,es(At,A),es(At+Et,A)),Rn)for(let $e in S){let Xt=S[$e];$e!=A&&Xt.from==null&&Xt.min!=Bt&&Vs($e,es(yt+Ke,$e),es(yt,$e))}mu()}else fe.lock&&(fe._lock=!fe._lock,pr(w,!0,_!=null));_!=null&&(vn(Hu,qu),na(Hu,i,Gt,Kt,F,Le,null))}function w_(_,w,L,I,z,Z,ae){if(fe._lock)return;Je(_);let me=zs;if(zs){let Me=!0,Ue=!0,Oe=10,ke,st;D.ori==0?(ke=Cn,st=Rn):(ke=Rn,st=Cn),ke&&st&&(Me=Gt<=Oe||Gt>=F-Oe,Ue=Kt<=Oe||Kt>=Le-Oe),ke&&Me&&(Gt=Gt<Xr?0:F),st&&Ue&&(Kt=Kt<$r?0:Le),pr(null,!0,!0),zs=!1}Gt=-10,Kt=-10,se.fill(null),pr(null,!0,!0),me&&(zs=me)}function yp(_,w,L,I,z,Z,ae){fe._lock||(Je(_),jo(),mu(),_!=null&&na(Zp,i,Gt,Kt,F,Le,null))}function vp(){C.forEach(lb),O(i.width,i.height,!0)}Mr(Nl,io,vp);let Zr={};Zr.mousedown=xp,Zr.mousemove=dp,Zr.mouseup=_p,Zr.dblclick=yp,Zr.setSeries=(_,w,L,I)=>{let z=mn.match[2];L=z(i,w,L),L!=-1&&Qi(L,I,!0,!1)},xe&&(St($p,g,xp),St(Vu,g,dp),St(qp,g,_=>{Je(_),ta(!1)}),St(Yp,g,w_),St(Zp,g,yp),td.add(i),i.syncRect=ta);let pl=i.hooks=n.hooks||{};function Pn(_,w,L){$n?Ut.push([_,w,L]):_ in pl&&pl[_].forEach(I=>{I.call(null,i,w,L)})}(n.plugins||[]).forEach(_=>{for(let w in _.hooks)pl[w]=(pl[w]||[]).concat(_.hooks[w])});let bp=(_,w,L)=>L,mn=gn({key:null,setSeries:!1,filters:{pub:om,sub:om},scales:[A,b[1]?b[1].scale:null],match:[am,am,bp],values:[null,null]},fe.sync);mn.match.length==2&&mn.match.push(bp),fe.sync=mn;let Mp=mn.key,gu=ig(Mp);function na(_,w,L,I,z,Z,ae){mn.filters.pub(_,w,L,I,z,Z,ae)&&gu.pub(_,w,L,I,z,Z,ae)}gu.sub(i);function E_(_,w,L,I,z,Z,ae){mn.filters.sub(_,w,L,I,z,Z,ae)&&Zr[_](null,w,L,I,z,Z,ae)}i.pub=E_;function T_(){gu.unsub(i),td.delete(i),An.clear(),Ku(Nl,io,vp),c.remove(),Re?.remove(),Pn("destroy")}i.destroy=T_;function xu(){Pn("init",n,e),Jo(e||n.data,!1),W[A]?cu(A,W[A]):jo(),ie=Wt.show&&(Wt.width>0||Wt.height>0),te=ge=!0,O(n.width,n.height)}return b.forEach(Br),C.forEach(ms),t?t instanceof HTMLElement?(t.appendChild(c),xu()):t(i,xu):xu(),i}xn.assign=gn;xn.fmtNum=ld;xn.rangeNum=Ul;xn.rangeLog=kl;xn.rangeAsinh=od;xn.orient=wr;xn.pxRatio=Ct;xn.join=Qy;xn.fmtDate=hd,xn.tzDate=hv;xn.sync=ig;{xn.addGap=$v,xn.clipGaps=Vl;let n=xn.paths={points:cg};n.linear=ug,n.stepped=Zv,n.bars=Kv,n.spline=jv}function gt(n){let{heads:e,rows:t,caption:i,strong:s,text:r=[]}=n,o=h=>[h===0||r.includes(h)?"text":"number",h===s?"strong":""].join(" ").trim(),a=e.map((h,u)=>v("th",{scope:"col",class:o(u)},h)),l=t.map(h=>v("tr",{},...h.map((u,d)=>d===0?v("th",{scope:"row"},u):v("td",{class:o(d)},u)))),c=i?v("caption.unseen",{},i):null;return v("div.scroll",{},v("table.data",{},c,v("thead",{},v("tr",{},...a)),v("tbody",{},...l)))}function en(n){let e=new _d(n);return e.isEmpty?null:e.element}function mg(n){let e=[];return n.x.forEach((t,i)=>{let s=n.y[i];de(t)&&de(s)&&e.push([t,s])}),e.sort((t,i)=>t[0]-i[0])}var xd='12px system-ui, "Segoe UI", Roboto, Arial, sans-serif',cb={line:[],steps:[],dots:[],dashed:[6,4],dotted:[2,3]},_d=class{constructor(e){this.options=e;this.series=e.series,this.lines=e.series.map(mg);let t=this.lines.flat().map(([,r])=>r),i=t.filter(r=>r>0);this.isEmpty=t.length===0,this.isLog=e.y.log===!0&&i.length>0&&t.every(r=>r>=0);let s=this.isLog&&i.length<t.length;this.floor=s?10**(Math.floor(Math.log10(Math.min(...i)))-1):null,this.box.append(this.tip),this.box.setAttribute("aria-label",this.summary()),this.box.addEventListener("keydown",r=>this.onKey(r)),this.box.addEventListener("blur",()=>this.plot?.setCursor({left:-10,top:-10})),this.element=v("div.chart",{},this.legend(),this.box,this.spoken,this.asTable()),mb(this.box,r=>this.resize(r)),gb(this.box,()=>this.plot?.redraw(!1,!0))}options;element;isEmpty;box=v("div.chart-box",{tabindex:"0",role:"img"});tip=v("div.chart-tip",{hidden:!0});spoken=v("div.unseen",{"aria-live":"polite"});series;lines;isLog;floor;plot=null;data(){let e=this.lines.map(t=>[t.map(([i])=>i),t.map(([,i])=>this.floor!==null&&i<=0?this.floor:i)]);return xn.join(e)}resize(e){let t=this.options.height??250;this.plot===null?this.begin(e):this.plot.setSize({width:e,height:t})}begin(e){let{x:t,y:i,height:s=250}=this.options,r=o=>(a,l,c)=>this.range(o,l,c);this.plot=new xn({width:e,height:s,legend:{show:!1},padding:[10,14,0,0],cursor:{y:!1,drag:{x:!1,y:!1},points:{size:8,fill:(o,a)=>Ss(this.series[a-1]?.color??"--ink")}},scales:{x:{time:!1,range:r(t)},y:{distr:this.isLog?3:1,range:r(i)}},axes:[this.axis(t,!1),this.axis(i,!0)],series:[{},...this.series.map(o=>ub(o))],hooks:{drawAxes:[o=>this.drawMarks(o)],setCursor:[o=>this.showTip(o)]}},this.data(),this.box)}range(e,t,i){if(t===null||i===null)return[e.from??0,e.to??1];if(e===this.options.y&&this.isLog)return[gg(t,Math.floor),gg(i,Math.ceil)];if(e===this.options.x)return db(e.from??t,e.to??i);let[s,r]=xn.rangeNum(t,i,.08,!0);return[e.from??s,e.to??r]}axis(e,t){return{label:e.unit?`${e.label}, ${e.unit}`:e.label,labelSize:20,labelGap:t?2:0,labelFont:xd,font:xd,stroke:()=>Ss("--quiet"),grid:{stroke:()=>Ss("--line"),width:1},ticks:{stroke:()=>Ss("--line"),width:1,size:5},space:t?32:64,values:(i,s)=>s.map(r=>this.tick(r,t)),size:t?fb:34}}tick(e,t){return e===null?"":t&&e===this.floor?"0":le(e,6)}drawMarks(e){let{left:t,top:i,width:s,height:r}=e.bbox,o=a=>Math.min(Math.max(e.valToPos(a,"x",!0),t),t+s);e.ctx.save();for(let a of this.options.marks??[]){let[l,c]=[o(a.from),o(a.to??a.from)];e.ctx.fillStyle=e.ctx.strokeStyle=Ss(a.color),a.to!==void 0?(e.ctx.globalAlpha=.16,e.ctx.fillRect(l,i,Math.max(c-l,1),r)):(e.ctx.globalAlpha=1,e.ctx.lineWidth=1.5*devicePixelRatio,e.ctx.setLineDash([5,4].map(h=>h*devicePixelRatio)),e.ctx.beginPath(),e.ctx.moveTo(l,i),e.ctx.lineTo(l,i+r),e.ctx.stroke())}e.ctx.restore()}showTip(e){let{idx:t,left:i}=e.cursor;if(t==null||i===void 0||i<0){this.tip.hidden=!0;return}let s=e.data[0][t]??0,r=this.lines.flatMap((f,g)=>{let x=this.series[g],p=x&&e.series[g+1]?.show?hb(f,s,x.style??"line"):null;return x&&p!==null?[{series:x,y:p}]:[]}),{unit:o,label:a}=this.options.x,l=`${a} ${le(s,5)}${o?` ${o}`:""}`,c=f=>`${le(f,5)}${this.options.y.unit?` ${this.options.y.unit}`:""}`,h=f=>v("div",{},_a(f.series.color),v("span",{},f.series.name),v("b",{},c(f.y)));this.tip.replaceChildren(v("div",{class:"chart-tip-head"},l),...r.map(h)),this.tip.hidden=r.length===0;let u=i>e.over.clientWidth/2,d=e.over.offsetLeft;this.tip.style.left=u?"":`${d+i+14}px`,this.tip.style.right=u?`${this.box.clientWidth-d-i+14}px`:"",document.activeElement===this.box&&(this.spoken.textContent=[l,...r.map(f=>`${f.series.name} ${c(f.y)}`)].join(", "))}onKey(e){let t=this.plot;if(t===null)return;let i=t.data[0].length-1,s=t.cursor.idx??-1,o={ArrowLeft:s-1,ArrowRight:s+1,Home:0,End:i}[e.key];if(o===void 0||e.ctrlKey||e.metaKey||e.altKey)return;e.preventDefault();let a=t.data[0][Math.min(Math.max(o,0),i)];a!==void 0&&t.setCursor({left:t.valToPos(a,"x"),top:t.over.clientHeight/2})}legend(){let e=this.series.map((s,r)=>({series:s,i:r})).filter(({series:s})=>!s.quiet&&mg(s).length>0),t=(this.options.marks??[]).map(s=>v("span",{},_a(s.color,s.to===void 0?"dashed":"band"),s.name));if(e.length<2&&t.length===0)return v("div",{class:"chart-legend",hidden:!0});let i=({series:s,i:r})=>{let o=v("button",{type:"button","aria-pressed":"true",title:"Hide or show"},_a(s.color,s.style),s.name);return o.addEventListener("click",()=>{let a=o.getAttribute("aria-pressed")!=="true";o.setAttribute("aria-pressed",String(a)),this.series.forEach((l,c)=>{(c===r||l.quiet&&l.name===s.name)&&this.plot?.setSeries(c+1,{show:a})})}),o};return v("div",{class:"chart-legend"},...e.map(i),...t)}asTable(){let e=v("details",{class:"chart-table"},v("summary",{},"Show as table"));return e.addEventListener("toggle",()=>{if(e.querySelector(".scroll")?.remove(),!e.open)return;let{x:t,y:i,title:s}=this.options,[r,...o]=this.columns(),a=i.unit?`, ${i.unit}`:"",l=[t.unit?`${t.label}, ${t.unit}`:t.label,...this.series.map(h=>h.name+a)],c=(r??[]).map((h,u)=>[le(h,6),...o.map(d=>le(d[u],6))]);e.append(gt({heads:l,rows:c,caption:s}))}),e}columns(){let e=[...new Set(this.lines.flat().map(([i])=>i))].sort((i,s)=>i-s),t=i=>{let s=new Map(i);return e.map(r=>s.get(r))};return[e,...this.lines.map(t)]}summary(){let{title:e,x:t,y:i}=this.options,s=(l,c)=>{let[h,u]=[le(Math.min(...c),3),le(Math.max(...c),3)];return`from ${h} to ${u}${l.unit?` ${l.unit}`:""}`},r=this.lines.map((l,c)=>({line:l,name:this.series[c]?.name??""})).filter(({line:l})=>l.length>0),o=r.flatMap(({line:l})=>l.map(([c])=>c)),a=r.map(({line:l,name:c})=>`${c===e?"":`${c} `}${s(i,l.map(([,h])=>h))}`);return`${e}: ${a.join("; ")}; over ${t.label} ${s(t,o)}. Arrow keys read values.`}};function hb(n,e,t){let i=n.findIndex(([l])=>l>=e);if(i<0)return null;let[s,r]=n[i];if(s===e)return r;if(i===0||t==="dots")return null;let[o,a]=n[i-1];return t==="steps"?a:a+(e-o)/(s-o)*(r-a)}function ub(n){let e=n.style??"line",t=e==="dots",i=xn.paths.stepped?.({align:1});return{label:n.name,stroke:()=>Ss(n.color),width:2,dash:cb[e],points:{fill:()=>Ss("--sheet")},...n.fill?{fill:()=>pb(Ss(n.color))}:{},...t?{paths:()=>null,points:{show:!0,size:10,width:2,fill:()=>Ss(n.color)}}:{},...e==="steps"&&i?{paths:i,points:{show:!1}}:{}}}function db(n,e){return n<e?[n,e]:[n-.5,e+.5]}function gg(n,e){let t=10**Math.floor(Math.log10(n));return e(n/t)*t}function fb(n,e){n.ctx.save(),n.ctx.font=xd;let t=(e??[]).map(i=>n.ctx.measureText(i??"").width);return n.ctx.restore(),Math.ceil(Math.max(16,...t))+14}function Ss(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()||"#5a6775"}function pb(n){return`color-mix(in srgb, ${n} 22%, transparent)`}function _a(n,e="line"){return v("i",{class:`swatch swatch-${e}`,style:`--swatch: var(${n})`,"aria-hidden":"true"})}function mb(n,e){let t=0;new ResizeObserver(()=>{let s=n.clientWidth;s===t||s===0||(t=s,e(s))}).observe(n)}function gb(n,e){let t=matchMedia("(prefers-color-scheme: dark)"),i=()=>{n.isConnected?e():t.removeEventListener("change",i)};t.addEventListener("change",i)}function Xl(n,e,t,i){let s=t,r=()=>{},o=l=>{s=l,r(),i(l)},a=e.map(l=>[l,l]);return v("div.chosen",{},v("span.quiet",{},n),Kn(n,a,()=>s,o,l=>r=l))}var xg=new WeakMap;function at(n){if(!Qn(n.report))return{};let e=xg.get(n.report);return e||(e=yd(n.report),xg.set(n.report,e)),e}function yd(n){return Array.isArray(n)?n.map(yd):Qn(n)?Object.fromEntries(Object.entries(n).flatMap(([e,t])=>t===null?[]:[[e,yd(t)]])):n??void 0}function Qn(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Rt(n){return Array.isArray(n)?n:[]}function uo(n){return typeof n?.band_half_width=="number"}function Bn(n,e=""){return n.filter(_g).map(t=>v("p",{class:e||null},Ws(yg(t))))}function ya(n){let e=n.filter(_g);return e.length===0?null:v("ul",{},...e.map(t=>v("li",{},Ws(yg(t)))))}function _g(n){return typeof n=="string"&&n!==""}function yg(n){let e=/^[a-z]+[ ,]/.test(n)?n.charAt(0).toUpperCase()+n.slice(1):n;return/[.!?:]$/.test(e)?e:`${e}.`}function xt(n,...e){return v("div.part",{},v("h3",{},n),...e)}function Li(n,e){let t=v("button.copy",{type:"button"},n);return t.addEventListener("click",()=>{let i=r=>{t.textContent=r,window.setTimeout(()=>t.textContent=n,1600)};(navigator.clipboard?.writeText(e())??Promise.reject(new Error("no clipboard"))).then(()=>i("Copied"),()=>i("The browser refused to copy"))}),t}function Ii(n){let e=t=>/[",\n]/.test(t)?`"${t.replaceAll('"','""')}"`:t;return n.map(t=>e(t==null?"":String(t))).join(",")}var xb=["model calls","seconds","iterations"],$l="model calls";function vd(n,e){let t=xb.filter(a=>n.some(l=>ql(l,a).some(de))),i=t.includes($l)?$l:t.at(-1)??$l,s=v("div.charts"),r=a=>s.replaceChildren(...e(a).filter(l=>l!==null)),o=a=>{$l=a,r(a)};return r(i),v("div",{},Xl("Over",t,i,o),s)}function ql(n,e){let t=s=>n.history?.[s]??[];if(e==="seconds")return t("seconds");if(e==="iterations")return t("iteration");let i=t("adjoint_calls");return t("forward_calls").map((s,r)=>de(s)?s+(i[r]??0):null)}function bd(n){return n==="seconds"?{label:"time",unit:"s",from:0}:{label:n==="iterations"?"iteration":"model calls (dose and adjoint)",from:0}}function vg({run:n}){let e=bb(n),t=Bn([yb(at(n)),n.texts?.gap,vb(at(n).levels)]),i=Eb(at(n).process_window);if(e.length===0&&t.length===0&&!i)return null;let s=e.length>0&&vd([n],r=>e.map(o=>Mb(n,o,r)));return v("div",{},...t,s,Sb(n),wb(n),i)}var _b={loss:"the lowest loss",print:"the best IoU on the job's voxels",last:"the last step"};function yb({history:n}){let e=n?.kept;if(!e||!de(e.iteration))return null;let t=_b[e.by??""];return`The patterns are those after iteration ${e.iteration}${de(n.iterations)?` of ${n.iterations}`:""}${t?`: ${t}`:""}.`}function vb(n){if(!n)return null;let e=i=>le(i,4),t=de(n.diffused_loss)?` (${e(n.diffused_loss)} by error diffusion)`:"";return`On the levels of the machine the patterns have a loss of ${e(n.loss)}, plainly rounded ${e(n.rounded_loss)}${t}: ${e(n.steps)} steps and ${e(n.calls)} model calls, with a full scale of ${e(n.scale)} times the brightest pixel before.`}function bb(n){let e=s=>n.history?.[s]??[],t=Object.keys(n.history??{}).filter(s=>s.startsWith("response."));return[{title:"Loss",y:{label:"loss",log:!0},of:e("loss")},{title:"Voxels that would print wrongly",y:{label:"1 − IoU",log:!0},of:e("iou").map(s=>de(s)?1-s:null)},{title:"Process window",y:{label:"response"},of:e("process_window")},{title:"Projected gradient",y:{label:"relative to the first",log:!0},of:e("projected_gradient")},...t.map(s=>({title:`Response: ${s.slice(9)}`,y:{label:"found so far"},of:e(s)}))].filter(s=>s.of.filter(de).length>1)}function Mb(n,e,t){let i=e.of.filter(de);if(i.every(o=>o===0))return xt(e.title,v("p.note",{},`It is 0 at each of the ${i.length} points that were measured.`));let s={name:e.title,color:"--accent",x:ql(n,t),y:e.of},r=en({title:e.title,x:bd(t),y:e.y,series:[s]});return r&&xt(e.title,r)}function Sb(n){let e=g=>n.history?.[g]?.findLast(de),t=at(n).history,i=e("iteration")??t?.iterations;if(!de(i))return null;let[s,r]=[e("forward_calls")??t?.forward_calls,e("adjoint_calls")??t?.adjoint_calls],o=e("seconds"),a=de(o)?`, ${le(o,3)} s`:"",c=(n.history?.projected_gradient??[]).findIndex(de),h=c>0?(n.history?.iteration?.[c]??1)-1:0,u=h>0?` After iteration ${h} the voxels became finer: earlier numbers belong to coarser voxels, and the gradient curve begins there.`:"",d=de(s)?`, ${le(s,6)} dose and ${le(r,6)} adjoint calls`:"",f=de(s)?" Compare methods by model calls, not by iterations.":"";return v("p.note",{},`${le(i,6)} iterations${d}${a}.${f}${u}`)}function wb(n){let e=at(n).response;if(!Qn(e))return null;let t=Object.entries(e).map(([i,s])=>[i,le(s,4)]);return xt("Response that was found",gt({caption:"Response that was found",heads:["parameter","value"],rows:t}))}function Eb(n){if(!n)return null;let e=r=>le(r,4),i=[["Outliers that are left out at either end",de(n.outliers)?`${le(100*n.outliers,3)} %`:"–"],["Thresholds of the objective, lower and upper",(n.thresholds??[]).map(e).join(", ")],["All else of the part lies above",e(n.part_above)],["All else of the part lies below",e(n.part_below)],["All else of the void lies below",e(n.void_below)],["Process window",e(n.window)],["Range in the part",e(n.range)],["Bound of that range",e(n.ipdr)]],s=v("p.note",{},"On the optimization's voxels, before the patterns are written.");return xt("Process window that the objective found",s,gt({caption:"Process window that the objective found",heads:["","response"],rows:i}))}var bg=6;function va(n){return`--run-${n%bg+1}`}function Mg(n){return n<bg?"line":"dashed"}function Md(n,e,t,i){return{name:n.name,color:va(e),style:Mg(e),x:t,y:i}}function fo(n,e){return v("span.run-name",{},_a(va(e),Mg(e)),n.name)}function wg({runs:n}){if(!n.some(r=>(r.history?.loss??[]).filter(de).length>1))return null;let e=(r,o,a,l)=>{let c=n.map((u,d)=>Md(u,d,ql(u,l),a(u))),h=en({title:`${r} over ${l}`,x:bd(l),y:o,series:c});return h&&xt(r,h)},t=r=>(r.history?.iou??[]).map(o=>de(o)?1-o:null),i=vd(n,r=>[e("Loss",{label:"loss",log:!0},o=>o.history?.loss??[],r),e("Voxels that would print wrongly",{label:"1 − IoU",log:!0},t,r),e("Process window",{label:"response"},o=>o.history?.process_window??[],r)]);return v("div",{},i,v("p.note",{},"Compare methods by model calls, not by iterations; seconds are those of the machine of each run. IoU is that on the grid of each optimization, where it was measured."))}function Eg({runs:n}){let e=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:n.map((i,s)=>{let r=Rt(at(i).evaluation?.iou_curve);return Md(i,s,r.map(o=>o?.[0]),r.map(o=>o?.[1]))})}),t=en({title:"Dose of part and void",x:{label:"response to the dose"},y:{label:"share of the voxels per unit",log:!0},series:n.flatMap(Tb)});return!e&&!t?null:v("div.charts",{},e&&xt("IoU over the gel threshold",v("p.note",{},"A broad plateau tolerates errors of exposure."),e),t&&xt("Dose of part and void",v("p.note",{},"Share of the voxels per unit of the response: part in full lines, void in dotted ones."),t))}function Tb(n,e){let t=at(n).evaluation?.histogram;return[{name:n.name,color:va(e),style:"steps",...Sg(t,"part")},{name:n.name,color:va(e),style:"dotted",quiet:!0,...Sg(t,"void")}]}function Sg(n,e){let t=n?.[e]??[],[i,s]=n?.range??[],r=t.reduce((a,l)=>a+(l??0),0);if(!de(i)||!de(s)||r===0)return{x:[],y:[]};let o=(s-i)/t.length;return{x:t.map((a,l)=>i+(l+.5)*o),y:t.map(a=>(a??0)/(r*o))}}var Ab=.2,Sd={"x–y":2,"x–z":1,"y–z":0};function Tg(n){return n.data.runs.filter(t=>ss(t,"response","")).length>1?Ci(n,Cb):null}async function Cb(n){let{state:e,gone:t}=n,i=[],{read:s,problems:r}=await Rb(n,()=>i.forEach(m=>m.redraw(!0))),[o,...a]=s;if(!o||a.length===0)throw new Error(r[0]??"Fewer than two runs hold a dose.");let l={low:Math.min(...s.map(({volume:m})=>m.info.low)),high:Math.max(...s.map(({volume:m})=>m.info.high))},c=a.filter(({volume:m})=>Pb(m,o.volume)),h=a.filter(m=>!c.includes(m)),u=s.map(({name:m,volume:b,slices:C})=>({title:m,layer:ca(m,"Dose",b,C,null,l)})),d=c.map(m=>({title:m.name,layer:Uu(m.volume,o.volume,Lb(m,o),Ab*l.high,m.name,`dose − that of ${o.name}`)})),f=v("div"),g=new AbortController;t.addEventListener("abort",()=>g.abort());let x=m=>{g.abort(),g=new AbortController;let{signal:b}=g,C=A=>{let y=new Ys({state:e,grid:o.volume,signal:b});return y.show(A.map(E=>({axis:m,...E}))),y};i=[u,d].filter(A=>A.length>0).map(C);let[S,R]=i.map(A=>v("div.runs-planes",{style:`--runs: ${s.length}`},A.element));f.replaceChildren(v("div",{},S,si(u[0].layer.legend())),R?xt(`Difference to ${o.name}`,v("p.note",{},"Red: a higher dose. Blue: a lower one."),R,si(d[0].layer.legend())):"")};x(Sd["x–y"]);let p=Object.keys(Sd);return v("div",{},...r.map(m=>v("p.problem",{role:"alert"},m)),...Bn(["Written patterns, vial turning, on one scale. A click, a slider or an arrow key moves all planes."],"quiet"),...h.map(({name:m})=>v("p.note",{},`No difference is drawn for ${m}: its voxels differ from those of ${o.name}.`)),Xl("Plane",p,"x–y",m=>x(Sd[m])),f)}async function Rb({data:n,stores:e,gone:t},i){let s=[],r=async a=>{let l=n.runs[a],c=ss(l,"response","");if(!c)return null;try{return{name:l.name,volume:await e[a].volume(c),slices:new eo(l,e[a],t,i)}}catch(h){return s.push(`${l.name}: ${h instanceof Error?h.message:String(h)}`),null}};return{read:(await Promise.all(n.runs.map((a,l)=>r(l)))).filter(a=>a!==null),problems:s}}function Pb(n,e){let t=(i,s)=>Math.abs(i-s)<1e-6;return Nu(n,e)&&n.pitch.every((i,s)=>t(i,e.pitch[s]))&&n.info.center_xyz_mm.every((i,s)=>t(i,e.info.center_xyz_mm[s]))}function Lb(n,e){return{of:(t,i,s)=>(t===n.volume?n:e).slices.of(t,i,s)}}function Ag(n,e,t){let i=[...new Set(n.runs.map(r=>at(r).part).filter(r=>r!==void 0))],s=n.runs.map((r,o)=>{let a=v("button",{type:"button","aria-pressed":String(o===e)},fo(r,o));return a.addEventListener("click",()=>t.set({run:o})),a});return v("div.head",{},v("p.brand",{},"Tomolith comparison"),v("h1",{},`${n.runs.length} runs`),v("p.lead",{},`${i.length===1?"Part":"Parts"}: ${i.join(", ")}`),v("div.chosen",{},v("span.quiet",{},"Shown in full below the comparison"),v("div.choice",{role:"group","aria-label":"Run that is shown in full"},...s)))}function Cg({differing_keys:n},e){if(n.length===0)return v("p.quiet",{},"Nothing.");let t=n.map(({key:i,values:s})=>[v("code",{},i),...s.map(r=>r??In)]);return v("div.job-keys",{},gt({caption:"Keys of the jobs that differ",heads:["key",...e.map(fo)],rows:t,text:e.map((i,s)=>s+1)}))}function Rg({data:n,run:e}){let{part:t,evaluation:i,run:s}=at(e),r=n.runs.length===1&&!n.sweep,o=s?.created;return v("div.head",{},v("p.brand",{},[Ib[e.state],o].filter(Boolean).join(" · ")),v(r?"h1":"h2",{},r?t??e.name:e.name),v("p.lead",{},Ws([e.texts?.lead,e.texts?.print_time].filter(Boolean).join(" "))),Nb(e.texts?.facts??[]),i?Ub(n,e,i):null,i?Bb(i,i.standing_still):null)}var Ib={done:"Tomolith print report",running:"Tomolith, a run that goes on",check:"Tomolith, a job before it runs"},Db=60;function Nb(n){return n.length===0?null:v("dl.facts",{},...n.map(([e,t])=>v(t.length>Db?"div.long":"div",{},v("dt",{},e),v("dd",{},Ws(t)))))}function wd(n,e){return(uo(e)?n.gray_headline:n.headline).flatMap(i=>n.metrics.find(s=>s.name===i)??[])}function Ub(n,e,t){let i=at(e).evaluation?.standing_still;return v("div.cards",{},...wd(n,t).map(s=>Ob(s,t,i)))}function Ob(n,e,t){let i=e[n.name],s=_l(i,n.unit,e.grid?.pitch_mm),r=n.name==="iou"?4:3,{unit:o}=Xs(n.unit);return v("div.card",{"data-metric":n.name},v("h3",{},n.title),v("p.big",{},ls(n,i,r),de(i)&&o!==""&&v("small",{},` ${o}`)),v("p",{},s!==""&&v("b",{},`${s}. `),n.summary,kb(n,e)),t?v("p.still",{},v("span",{},"standing still"),v("b",{},Fb(n,t[n.name],r))):null)}function ls(n,e,t){let{factor:i}=Xs(n.unit);return le(de(e)?e*i:null,t)}function Fb(n,e,t){let{unit:i}=Xs(n.unit);return de(e)&&i!==""?`${ls(n,e,t)} ${i}`:ls(n,e,t)}function kb(n,{farthest:e}){let t=e?.at_xyz_mm;if(n.name!=="hausdorff_mm"||!t?.every(de))return"";let[i,s,r]=t.map(o=>le(o,3));return` It is at x = ${i}, y = ${s}, z = ${r} mm: ${(e?.side??"").replaceAll("_"," ")}.`}function Bb(n,e){if(!e||n.sub_angles===1)return null;let[t,i]=uo(n)?["rms_error","rms error"]:["pw","process window"],[s,r]=[n[t],e[t]],o=de(s)&&de(r)?` Here the ${i} is ${le(r,3)} standing still and ${le(s,3)} turning.`:"";return v("p.note",{},`The vial keeps turning while a frame is shown, so the frame's light lands all along its arc. The large numbers include this (${le(n.sub_angles,3)} positions per frame); “standing still” is what the same patterns would do if the vial stood still during each frame.${o} More frames per turn bring the two together.`)}function Pg({data:n,run:e}){let{evaluation:t,optimization:i}=at(e),s=[{name:"Turning",evaluation:t},{name:"Standing still",evaluation:t?.standing_still},{name:"Optimization",evaluation:i}].filter(l=>!!l.evaluation),r=Hb(n.metrics,s,uo(t)?n.gray_headline:[]);if(r.length===0)return null;let o=uo(t)?" For a gray target, “part” is where its value is at least ½.":"",a=s.map(({name:l,evaluation:c})=>v("span",{},l,v("small",{},Gb(c))));return v("div",{},v("p.quiet",{},`↑ larger is better, ↓ smaller is better. The first columns are on the evaluation's voxels, from the patterns as they were written; the last one is of the patterns before they are written, on the job's own voxels, the vial standing still.${o}`),Li("Copy as CSV",()=>Xb(r,s)),gt({caption:"All numbers",heads:["",...a],rows:r.map(l=>[ba(l),...s.map(c=>Wb(l,c))]),strong:1}),zb(s))}function zb(n){let e=n.map(({name:i,evaluation:s},r)=>{let o=Rt(s.iou_curve);return{name:i.toLowerCase(),color:Vb[r],style:r===0?"line":"dashed",x:o.map(a=>a?.[0]),y:o.map(a=>a?.[1])}}),t=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:e});return t&&xt("IoU over the gel threshold",t)}var Vb=["--run-1","--run-2","--run-3"];function Hb(n,e,t){let i=n.filter(r=>e.some(({evaluation:o})=>de(o[r.name]))),s=r=>t.includes(r.name)?0:1;return i.sort((r,o)=>s(r)-s(o))}function ba(n){let{unit:e}=Xs(n.unit),t=n.better==="higher"?" ↑":n.better==="lower"?" ↓":"";return v("span",{},n.title,t,e!==""&&v("span.unit",{},` ${e}`),n.summary!==""&&v("small",{},n.summary))}function Gb({grid:n}){return de(n?.pitch_mm)?`${le(1e3*n.pitch_mm,3)} µm voxels`:""}function Wb(n,{evaluation:e}){let t=e[n.name],i=_l(t,n.unit,e.grid?.pitch_mm);return v("span",{},ls(n,t,4),i!==""&&v("span.unit",{},` (${i})`))}function Xb(n,e){let t=n.map(({name:i,unit:s})=>Ii([i,s,...e.map(({evaluation:r})=>r[i])]));return[Ii(["metric","unit",...e.map(({name:i})=>i)]),...t].join(`
`)+`
`}function Lg(n,e,t){let i=n.numbers.filter(c=>c.values.some(de));if(i.length===0)return null;let s=n.marks_best?"the best is bold.":"the best is not marked, because the runs were evaluated by different models: compare only columns with the same one.",r=e.map((c,h)=>v("span",{},fo(c,h),v("small",{},qb(n,h)))),o=c=>t.find(({name:h})=>h===c.key)?.summary??null,a=c=>{let h=$b(c,n),u=(f,g)=>h!==null&&f===h&&n.prints[g];return[v("span",{title:o(c)},ba({title:c.name,unit:c.unit,better:c.better,summary:""})),...c.values.map((f,g)=>u(f,g)?v("b.best",{},ls(c,f,4)):ls(c,f,4))]},l=()=>[Ii(["number","unit",...e.map(c=>c.name)]),...i.map(c=>Ii([c.key,c.unit,...c.values]))].join(`
`)+`
`;return v("div",{},v("p.quiet",{},`Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; ${s}`),Li("Copy as CSV",l),gt({caption:"Numbers of all runs",heads:["",...r],rows:i.map(a)}))}function $b(n,{marks_best:e,prints:t}){let i=n.values.filter((s,r)=>de(s)&&t[r]);return!e||n.better==="none"||i.length===0?null:n.better==="higher"?Math.max(...i):Math.min(...i)}function qb({kinds:n,models:e},t){return[n[t],e[t]&&`evaluated by ${e[t]}`].filter(Boolean).join(", ")}function Ig({warnings:n}){let e=ya(n);return e&&v("div.warn",{role:"note"},e)}function Ma(n){return e=>e.data.runs.length>1?n(e):null}function Ed(n){return Ma(e=>e.data.compare?n(e.data.compare,e):null)}var Yl=[{id:"compare",title:"",render:Ma(({data:n,index:e,state:t})=>Ag(n,e,t))},{id:"cautions",title:"Before you compare",render:Ed(Ig)},{id:"side-by-side",title:"Numbers side by side",render:Ed((n,{data:e})=>Lg(n,e.runs,e.metrics))},{id:"job-keys",title:"What differs in the jobs",render:Ed((n,{data:e})=>Cg(n,e.runs))},{id:"doses",title:"Doses",render:Ma(Tg)},{id:"thresholds",title:"Thresholds",render:Ma(({data:n})=>Eg(n))},{id:"histories",title:"Histories",render:Ma(({data:n})=>wg(n))}];var Yb=3,Zb=.02;function Ng({run:n}){let e=Rt(at(n).ceiling?.trade_off);if(e.length===0&&!n.texts?.ceiling)return null;let t=e.length>0&&e.every(a=>de(a.time_s)),i=t?{label:"print time",unit:"s",from:0}:{label:"print time M/t",unit:"mm",from:0},s=a=>t?a.time_s:a.time_mm,r=[Dg("IoU",e,i,s,a=>a.iou),Dg("VER",e,i,s,a=>a.ver)].filter(a=>a!==null);return v("div",{},...Bn([n.texts?.ceiling,e.length>0?"The ceilings of the pixels that the run tried, on pixels of twice the width. `tomolith expose RUN --trade-off` lists them and writes the job of one.":null]),v("div.charts",{},...r),Kb(e))}function Dg(n,e,t,i,s){let r=e.filter(p=>!p.is_evaluated),o=e.filter(p=>p.is_chosen);if(r.filter(p=>de(i(p))&&de(s(p))).length<Yb)return null;let a=e.map(s).filter(de),[l,c]=[Math.min(...a),Math.max(...a)],h=.6*Math.max(c-l,Zb),u={label:n,from:Math.max((l+c)/2-h,0),to:Math.min((l+c)/2+h,1)},d=p=>({x:p.map(i),y:p.map(s)}),f=Math.max(...e.map(i).filter(de)),g=o.some(p=>p.is_evaluated)?"this run, as it was evaluated":"this run",x=en({title:`${n} over the print time`,x:{...t,to:1.05*f},y:u,series:[{name:"tried",color:"--accent",...d(r)},{name:g,color:"--threshold",style:"dots",...d(o)}]});return x&&xt(n,x)}function Kb(n){if(n.length===0)return null;let e=n.some(s=>de(s.time_s)),t=s=>[[le(s.brightest,3),s.is_chosen&&" (taken)"].filter(Boolean).join(""),an(s.time_mm,"",3),...e?[an(s.time_s,"",3)]:[],an(s.iou,"",4),an(s.ver,"",3),an(de(s.surface_mean_mm)?1e3*s.surface_mean_mm:null,"",3)],i=["Brightest pixel, mJ/mm²","M/t, mm",...e?["time, s"]:[],"IoU","VER","surface off on average, µm"];return gt({caption:"Quality against time",heads:i,rows:n.map(t)})}var Zl=32;function Ug(n){let[e,t,i]=["response","target","labels"].map(s=>ss(n.run,s,""));return!e||!t?null:Ci(n,async({store:s})=>{let r=await Promise.all([e,t,...i?[i]:[]].map(c=>s.volume(c))),[o,a,l]=r;return jb(Jb(o,a,l??null))})}function Jb(n,e,t){let[i,s,r]=[0,1,2].map(()=>new Float64Array(Zl)),o=Math.min(n.codes.length,e.codes.length);for(let a=0;a<o;a++){if(t&&t.codes[a]===vs.outside)continue;let[l,c]=[n.values[n.codes[a]],e.values[e.codes[a]]];if(Number.isNaN(l)||Number.isNaN(c))continue;let h=Math.min(Math.max(Math.floor(c*Zl),0),Zl-1);i[h]++,s[h]+=l,r[h]+=l*l}return[...i.keys()].filter(a=>i[a]>0).map(a=>{let l=s[a]/i[a];return{gray:(a+.5)/Zl,mean:l,deviation:Math.sqrt(Math.max(r[a]/i[a]-l*l,0))}})}function jb(n){let e=n.map(({gray:s})=>s),t=(s,r)=>({name:"± one standard deviation",color:"--void",x:e,y:n.map(({mean:o,deviation:a})=>o+s*a),quiet:r});return en({title:"Response against gray value",x:{label:"gray value of the target",from:0,to:1},y:{label:"response",from:0},series:[{name:"mean",color:"--accent",x:e,y:n.map(({mean:s})=>s)},t(1,!1),t(-1,!0),{name:"asked for",color:"--ink",style:"dashed",x:[0,1],y:[0,1]}]})??v("p.note",{},"No voxel counts.")}var Qb=80;function Fg(n){let e=at(n.run).evaluation,t=e?.errors,[i,s]=t?.range??[];if(!e||!t||!de(i)||!de(s))return null;let r=Math.max(...["max_error_part","max_error_void"].map(m=>e[m]).filter(de),0),[o,a]=t.band??[],l=t.part?.length??0;if(l===0)return null;let c=(s-i)/l,h=Math.min(Math.max(r,2*(a??0),8*c),s),u=Og(t,"part",c,h),d=Og(t,"void",c,h),f=de(o)&&de(a)?[{name:"the objective's band",color:"--quiet",from:o,to:a}]:[],g=en({title:"Error of bright and dark voxels",x:{label:"response − gray value",from:-h,to:h},y:{label:"voxels",log:!0},series:[{name:"dark (below ½)",color:"--void",style:"steps",...d},{name:"bright",color:"--part",style:"steps",...u}],marks:f});if(!g)return null;let x=de(t.band_edge_peak)?` At the edges of the band lie ${le(t.band_edge_peak,3)} times as many voxels as a little inside or outside.`:"",p=Ug(n);return v("div.charts",{},xt("Voxels per error",v("p.note",{},`The band is what the objective asks for.${x}`),g),p&&xt("Response against gray value",v("p.note",{},"Of the voxels of each gray value."),p))}function Og(n,e,t,i){let s=n[e]??[],r=n.range?.[0]??0,o=Math.max(1,Math.round(2*i/t/Qb)),a=[],l=[];for(let c=0;c<s.length;c+=o){let h=r+c*t;h+o*t<-i||h>i||(a.push(h),l.push(s.slice(c,c+o).reduce((u,d)=>u+(d??0),0)))}return{x:a,y:l}}function kg({run:n}){let e=n.job;return e?v("div",{},v("details.fold",{},v("summary",{},"The job, with every default"),Li("Copy the job",()=>e),v("pre.job",{tabindex:"0"},e))):null}function zg({run:n}){let e=at(n),t=Rt(e.lights);if(t.length===0)return null;let i=t.map((o,a)=>o.name||(t.length>1?`light ${a+1}`:"value")),s=tM.map(([o,a])=>[o,...t.map(a)]).filter(([,...o])=>o.some(a=>a!==In&&a!=="")),r=t.length>1&&de(e.time_to_print_s)?`All lights together take ${Ai(e.time_to_print_s)}.`:null;return v("div",{},...Bn([r,eM(t)]),gt({caption:"Lights",heads:["",...i],rows:s}))}function eM(n){return n.some(e=>e.irradiance)?"The job's schedule says how long and how bright the light is.":n.some(e=>de(e.budget?.time_s))?null:"Times need `resin.critical_dose_mj_per_mm3` and `printer.peak_irradiance_mw_per_cm2`, and frames that follow each other at one rate: frames of a list of angles (`light.angles.list_deg`) have no times."}var po=n=>n.budget??{},tM=[["Wavelength",n=>an(n.wavelength_nm,"nm",4)],["Frames",n=>le(n.frames,6)],["Pixels of a frame",n=>Bg([n.columns,n.rows])],["Pixel pitch",nM],["Depth",n=>an(n.bits,"bit")],["White, over the whole exposure",n=>an(n.full_scale,"",4)],["Device",n=>n.canvas?`${Bg(n.canvas)} pixels`:"the patterns as they are"],["White, while it shines",iM],["Time to print, or length of the schedule",n=>Ai(po(n).time_s)],["Turns of the vial",n=>le(po(n).turns,3)],["White, of a frame over the whole print",n=>an(po(n).white_mj_per_mm2,"mJ/mm²")],["Energy at the vial per turn",n=>an(po(n).energy_per_turn_mj,"mJ")],["Energy at the vial in all",n=>an(po(n).energy_mj,"mJ")],["Share of the device's light that is used",n=>Vg(po(n).light_used)]];function Bg(n){return n.map(e=>le(e,6)).join(" × ")}function nM({pitch_mm:n}){let e=(Array.isArray(n)?n:[n]).filter(de);return e.length>0?`${e.map(t=>le(1e3*t,3)).join(" × ")} µm`:In}function iM({irradiance:n}){let e=n?.white_mw_per_cm2,t=n?.peak_mw_per_cm2,i=de(e)&&de(t)&&t>0?`, ${Vg(e/t)} of what the printer gives`:"";return an(e,"mW/cm²")+i}function Vg(n){return de(n)?`${le(100*n,3)} %`:In}function Hg(n,e,t){let i=new Map(n.map(({id:r,title:o})=>[r,Td(r,o,e)])),s=r=>{for(let[l,c]of i)l===r?c.setAttribute("aria-current","location"):c.removeAttribute("aria-current");let o=i.get(r),a=o?.parentElement?.parentElement;o&&a&&(a.scrollLeft=o.offsetLeft-a.clientWidth/2+o.offsetWidth/2)};return t.addEventListener("abort",e.on(["section"],()=>Js(e.get("section")))),sM([...i.keys()],s,t),v("nav.sections",{"aria-label":"Sections"},v("ol",{},...[...i.values()].map(r=>v("li",{},r))))}function Td(n,e,t){return v("a",{href:`#section=${n}`,click:i=>{i.ctrlKey||i.metaKey||i.shiftKey||(i.preventDefault(),t.get("section")===n?Js(n):t.set({section:n}))}},e)}function Js(n){let e=n===""?null:document.getElementById(n);if(!e)return;let t=matchMedia("(prefers-reduced-motion: reduce)").matches;e.scrollIntoView({behavior:t?"auto":"smooth"}),e.tabIndex=-1,e.focus({preventScroll:!0})}function sM(n,e,t){let i="",s=!1,r=()=>{s=!1;let a=window.innerHeight/4,c=n.filter(h=>(document.getElementById(h)?.getBoundingClientRect().top??1/0)<=a).at(-1)??n[0]??"";c!==i&&(i=c,e(c))},o=()=>{s||(s=!0,requestAnimationFrame(r))};window.addEventListener("scroll",o,{signal:t,passive:!0}),o()}function Wg({run:n,state:e}){let t=at(n);return t.evaluation?v("div.two",{},rM(t,n.texts,e),lM(t,n.texts?.limits??[])):null}function rM(n,e,t){let i=n.one_exposure?aM(n.one_exposure,Rt(n.species)):oM(n),s=i.length>0?gt({caption:"Best exposure",heads:["","shortest","best","longest"],rows:i,strong:2}):null,r=n.one_exposure?[e?.one_exposure,"The table compares exposures with it."]:e?.exposure??[],o=v("p.note",{},"This is about the dose. When to stop in the job's schedule stands under ",Td("time","The print in time",t),".");return xt("Best exposure",...Bn(r),s,Rt(n.time).length>0&&o)}function oM({exposure:n}){if(!n)return[];let e=[["Exposure",...Er(n.percent,Cd)]];n.time_s&&e.push(["Time to print",...Er(n.time_s,Xg)]),n.dose&&e.push(["Dose that gels",...Er(Ad(n.dose),Gg)]);let t=n.threshold?.best!==n.dose?.best||n.threshold?.low!==n.dose?.low;return n.threshold&&t&&e.push(["Response that gels",...Er(Ad(n.threshold),Gg)]),e}function aM(n,e){let t=[["All together",...Er(n.percent,Cd)]];n.time_s&&t.push(["Time to print",...Er(n.time_s,Xg)]);for(let{name:i=In,exposure:s}of e){if(!s?.dose)continue;let r=c=>de(c)&&de(n.gel_dose)&&c>0?100*n.gel_dose/c:null,{low:o,best:a,high:l}=Ad(s.dose);t.push([`${i} alone`,...Er({low:r(o),best:r(a),high:r(l)},Cd)])}return t}function Ad({low:n,best:e,high:t}){return{low:t??null,best:e??null,high:n??null}}var Gg=n=>ia(n,3),Cd=n=>ia(n,3).map(e=>`${e} %`),Xg=n=>n.map(Ai);function Er(n,e){let t=[n?.low,n?.best,n?.high],i=e(t.filter(de));return t.map(s=>de(s)?i.shift()??"":"no limit")}function lM(n,e){let t=Rt(n.species),s=(t.length>1?t.map(r=>({name:r.name??"",causes:Rt(r.limits)})):[{name:"",causes:Rt(n.limits)}]).flatMap(({name:r,causes:o},a)=>{let l=e.find(c=>c.name===r)??e[a];return o.length===0&&!l?.sentence?[]:[v("div",{},r!==""&&v("h4",{},r),...Bn([l?.sentence]),cM(o))]});return s.length>0?xt("What limits the print",...s):null}function cM(n){if(n.length===0)return null;let e=Math.max(...n.map(t=>$g(t).loss??0));return v("ol.causes",{},...n.map(t=>hM(t,e)))}function $g(n){return de(n.loss_in_rms_error)?{loss:n.loss_in_rms_error,measure:"rms error"}:{loss:de(n.loss_in_iou)?n.loss_in_iou:null,measure:"IoU"}}function hM(n,e){let{loss:t,measure:i}=$g(n),s=t!==null&&e>0?Math.max(t,0)/e:0,{key:r,advice:o=""}=n;return v("li",{"data-cause":n.cause},v("div.cause-head",{},v("b",{},dM[n.cause??""]??n.cause??""),v("span.loss",{},uM(t,i))),v("div.share",{"aria-hidden":"true"},v("i",{style:`width: ${(100*s).toFixed(1)}%`})),v("p",{},Ws(o),r&&!o.includes(r)?v("span.key",{}," ",v("code",{},r)):null))}function uM(n,e){if(n===null)return"";if(Math.abs(n)<5e-4)return"costs nothing";let t=`${le(Math.abs(n),2)} ${e}`;return e==="IoU"?n>0?`−${t}`:`+${t}`:n>0?`+${t}`:`−${t}`}var dM={grid:"Voxels of the optimization",levels:"Gray levels and pixels",turning:"Turning during a frame",optics:"Pixels and frames",iterations:"Iterations",ends:"Flat ends of the part",exposure:"Exposure",time:"The brightest pixel"};function qg({run:n}){let e=Rt(at(n).movies);if(e.length===0)return null;let t=e.map(i=>[v("code",{},i.file??""),le(i.frames,6),le(i.frame_rate,4),`${le(i.width,6)} × ${le(i.height,6)}`,le(i.largest_error_of_255,3),le(i.rms_error_of_255,2)]);return v("div",{},v("p.quiet",{},"Written, then decoded again and compared with the frames; errors are gray levels of 255. H.264 is lossy: the PNG frames are exact."),gt({caption:"Movies",heads:["file","frames","rate, 1/s","pixels","largest error","rms error"],rows:t}))}function Yg({run:n}){let e=at(n),t=ya([...Rt(e.warnings),...Rt(e.evaluation?.notes)]);return t&&v("div.warn",{role:"note"},t)}function Zg({data:n,run:e}){let t=at(e),i=ya(Rt(t.notes)),r=Object.entries(t.run?.models??{}).map(([o,a])=>v("div",{},v("dt",{},`Doses of the ${o}`),v("dd",{},String(a))));return v("div",{},v("p.quiet",{},`${t.run?.program??n.program}. Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.`),i&&xt("Choices",i),r.length>0&&xt("Models",v("dl.models",{},...r)))}function Kg({run:n}){let e=Rt(at(n).optimization?.objectives);if(e.length<2)return null;let t=e.map(i=>[v("code",{},i.key??""),le(i.weight,4),le(i.loss,4),le(i.voxels,6),le(i.rms_error,4),le(i.max_error,4)]);return v("div",{},v("p",{},"What each of them comes to on the job's own voxels, before the patterns are written. The sum takes a loss times its factor."),gt({caption:"Objectives",heads:["objective","factor","loss","voxels","rms error","largest error"],rows:t}))}function Jg({run:n}){let e=Rt(at(n).properties);return e.length===0?null:v("div",{},v("p.quiet",{},"Where something is solid. Half of it lies below the median."),gt({caption:"Predicted properties",heads:["property","lowest","median","highest","unit"],rows:e.map(fM),text:[4]}))}function fM({name:n,unit:e,min:t,median:i,max:s}){let r=[t,i,s],o=ia(r.filter(de),3);return[n??"",...r.map(a=>de(a)?o.shift()??"":"–"),e??""]}function jg({run:n}){let e=Object.entries(at(n).published??{}),t=e.flatMap(([r,o])=>Qn(o)&&typeof o.source=="string"?[pM(r,o)]:[]),i=e.filter(([r,o])=>r!=="slices"&&!(Qn(o)&&typeof o.source=="string")),s=gM(at(n).published?.slices);return t.length===0&&i.length===0?null:v("div",{},t.length>0&&mM(t),s,...i.map(([r,o])=>xt(Pd(r),Rd(o))))}function pM(n,e){let t=i=>typeof e[i]=="string"?e[i]:"";return{name:n,value:e.value,unit:t("unit"),note:t("note"),source:t("source")}}function mM(n){let e=v("div"),t=v("span.quiet",{"aria-live":"polite"}),i=v("input",{type:"search",placeholder:"jaccard, Dr.TVAM, eq. 12, …","aria-label":"Filter the published numbers"}),s=()=>{let r=i.value.toLowerCase().split(/\s+/).filter(Boolean),o=u=>`${u.name} ${u.note} ${u.source} ${u.unit}`.toLowerCase(),a=n.filter(u=>r.every(d=>o(u).includes(d)));t.textContent=a.length===n.length?`${n.length} numbers`:`${a.length} of ${n.length} numbers`;let l=u=>[v("code",{},u.name),le(u.value,4),u.unit,u.note,u.source],c=["name","value","unit","definition","source"],h=v("p.note",{},"No number has all of these words in its name, definition or source.");e.replaceChildren(a.length===0?h:gt({caption:"Published numbers",heads:c,rows:a.map(l),text:[2,3,4]}))};return i.addEventListener("input",s),s(),v("details.fold",{},v("summary",{},`${n.length} numbers as other authors and programs define them`),v("label.filter",{},"Filter ",i," ",t),e)}function gM(n){let e=Array.isArray(n)?n.filter(Qn):[],t=l=>e.map(c=>c[l]),i=t("z_mm"),s=(l,c,h)=>({name:l,color:c,x:i,y:t(h)}),r={label:"z",unit:"mm"},o=en({title:"Dose of each slice over z",x:r,y:{label:"response"},series:[s("process window","--run-1","pw"),s("range in the part","--run-2","ipdr")]}),a=en({title:"Voxel error rate of each slice over z",x:r,y:{label:"voxel error rate",from:0},series:[s("voxel error rate","--run-1","ver")]});return!o&&!a?null:xt("Slice by slice",v("div.charts",{},o&&v("div",{},o),a&&v("div",{},a)))}function Rd(n){if(de(n))return le(n,4);if(n==null)return In;if(Array.isArray(n)){if(n.every(i=>!Qn(i)))return n.map(i=>de(i)?le(i,4):String(i??In)).join(" ");let e=[...new Set(n.filter(Qn).flatMap(i=>Object.keys(i)))],t=i=>e.map(s=>Qn(i)?Rd(i[s]):String(i));return gt({heads:e.map(Pd),rows:n.map(t)})}return Qn(n)?gt({heads:["","value"],rows:Object.entries(n).map(([e,t])=>[Pd(e),Rd(t)])}):String(n)}var xM={keep_dark:"Bodies that are to stay dark",insert:"Surface of the inserts",insert_mm2:"In all, mm²",target_mm2:"Touched by the target, mm²",print_mm2:"Touched by the print, mm²",share:"Share that the print touches",of_target:"Share of what the target touches that the print touches too",part_mean:"Mean of the part",paths:"Scattering by Monte Carlo paths",orders:"Scattering, order by order",unit_systems:"In the units of others"};function Pd(n){let e=xM[n];if(e!==void 0)return e;let t=/_(mm3|mm2|mm)$/.exec(n),i=(t?n.slice(0,t.index):n).replaceAll("_"," "),s=i.charAt(0).toUpperCase()+i.slice(1);return t?`${s}, ${t[1]?.replace("3","³").replace("2","²")}`:s}function Qg({run:n}){let e=at(n).scenarios;if(!e)return null;let t=Rt(e.rows).map(r=>[r.name??"",le(r.iou_at_threshold,4),le(r.iou,4),le(r.gamma,4),le(r.part_low,4),le(r.void_high,4)]),i=le(e.threshold,4),s=e.of==="worst"?"the worst of them":e.of==="mean"?"their mean":e.of;return v("div",{},...Bn([`What the same patterns print where something is otherwise. Nobody knows which scenario a print is, so all of them gel at the threshold of the job, ${i}.`,n.texts?.scenarios]),gt({caption:"Scenarios",heads:["scenario","IoU there","IoU at its own threshold","Γ, %","least of the part","largest of the void"],rows:t,strong:1}),v("p.note",{},`Window over all of them: ${le(e.window,4)}, trimmed.${s?` The optimization minimized ${s}.`:""}`))}function e0({data:n,run:e}){let{species:t,one_exposure:i}=at(e),s=Rt(t);if(s.length<2)return null;let r=s[0]?.evaluation,o=r?wd(n,r):[];return v("div",{},v("p",{},"The numbers at the head of the page are those of ",v("b",{},s[0]?.name??""),"."),v("ul.drives",{},...s.map(a=>v("li",{},v("b",{},a.name??""),` is ${_M(a)}.`))),xt("Each alone",gt({caption:"Each species alone",heads:["",...s.map(a=>a.name??"")],rows:o.map(a=>yM(a,s))})),i?vM(s,i):null,bM(s,i))}function _M({driven_by:n}){let e=Object.entries(n??{}).filter(([,o])=>de(o)&&o!==0),t=o=>e.filter(([,a])=>Math.sign(a??0)===o).map(([a,l])=>`${le(Math.abs(l??0),3)} × ${a}`),[i,s]=[t(1),t(-1)];return[i.length>0&&`driven by ${i.join(" and ")}`,s.length>0&&`inhibited by ${s.join(" and ")}`].filter(Boolean).join(", ")||"driven by no light"}function yM(n,e){let{unit:t}=Xs(n.unit);return[v("span",{title:n.summary},n.title,t!==""&&v("span.unit",{},` ${t}`)),...e.map(({evaluation:s})=>ls(n,s?.[n.name],4))]}function vM(n,e){let t=r=>r.name&&r.name===e.limited_by?`${r.name} (limits it)`:r.name??"",i=n.map((r,o)=>[t(r),le(r.evaluation?.iou,4),le(r.evaluation?.gel_threshold,3),le(e.iou?.[o],4)]),s=`A print has one exposure. Where all networks gel at the same dose, the species print together best at a dose of ${le(e.gel_dose,3)}: the last column. Each reaches the IoU of its own where its network gels at its own dose.`;return xt("Together at one exposure",v("p",{},s),gt({caption:"Species at one exposure",heads:["species","IoU alone","at a threshold of","IoU together"],rows:i,strong:3}))}function bM(n,e){let t=n.map(({name:o,evaluation:a},l)=>{let c=Rt(a?.iou_curve);return{name:o??"",color:`--run-${l%6+1}`,x:c.map(h=>h?.[0]),y:c.map(h=>h?.[1])}}),i=n.every(({exposure:o})=>o?.dose?.best===o?.threshold?.best),s=e&&i&&de(e.gel_dose)?[{name:"one exposure",color:"--threshold",from:e.gel_dose}]:[],r=en({title:"IoU of each species over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:t,marks:s});return r&&xt("How much the threshold matters to each",r)}function t0({run:n}){let e=at(n),t=Rt(e.time);if(t.length===0)return null;let i=s=>{let r=(n.texts?.time??[]).find(a=>a.name===s.name)?.sentence,o=[...Bn([r,MM(s,e.evaluation)]),SM(s),wM(s)];return t.length>1?xt(s.name??"",...o):v("div",{},...o)};return v("div",{},...Bn([n.texts?.one_moment],"lead-in"),...t.map(i))}function MM(n,e){let t=o=>{let a=o?.grid?.pitch_mm;return de(a)?1e3*a:null},[i,s]=[t(n.evaluation),t(e)];if(i===null||s===null)return null;let r=le(i,3);return Math.abs(i-s)<1e-6*i?`Printed on voxels of ${r} µm, as the dose above.`:`Printed on the job's own voxels of ${r} µm. The numbers above are of voxels of ${le(s,3)} µm, so the two cannot be compared.`}function SM(n){let e=n.curves??{},t=e.seconds??[],i=t.findLast(de),s={label:"time",unit:"s",from:0,...de(i)?{to:i}:{}},r=(x,p,m,b={})=>({name:x,color:p,x:t,y:e[m]??[],...b}),o=de(n.best_s)?[{name:"best",color:"--threshold",from:n.best_s}]:[],[a,l]=n.window_s??[],c=de(a)&&de(l)?[{name:"within 0.01 of the best",color:"--threshold",from:a,to:l}]:[],h=en({title:"Jaccard index and contrast over time",x:s,y:{label:"share",from:0,to:1},series:[r("Jaccard index","--ink","jaccard"),r("part that is solid","--part","solid_part"),r("void that is solid","--void","solid_void"),r("contrast of the dose","--quiet","contrast",{style:"dashed"})],marks:[...c,...o]}),u=de(n.ideal_exposure_s)?[{name:"ideal exposure",color:"--threshold",from:n.ideal_exposure_s}]:[],d=n.requirement_mj,f=en({title:"Absorbed drive over time",x:s,y:{label:"absorbed drive",unit:"mJ",from:0},series:[r("in all voxels","--quiet","imbued_mj"),r("in solid voxels","--accent","contribution_mj"),{name:"needed",color:"--ink",style:"dashed",x:[0,i],y:[d,d]}],marks:u}),g=en({title:"Light sent over time",x:s,y:{label:"sent to the vial",unit:"mJ",from:0},series:[r("sent","--accent","sent_mj")]});return v("div.charts",{},h&&xt("What is solid",h),f&&xt("What is absorbed",f),g&&xt("Light that was sent",g))}function wM(n){let e=n.evaluation,t=s=>an(s,"s"),i=[["First voxel solid",t(n.induction_end_s)],["Best moment",t(n.best_s)],["Jaccard index then",le(n.best_jaccard,4)],["Sent to the vial by then",an(n.best_mj,"mJ")],["Within 0.01 of the best",(n.window_s??[]).map(t).join(" to ")||"–"],["Ideal exposure",t(n.ideal_exposure_s)],["Dose that the part needs",an(n.requirement_mj,"mJ")],...de(n.largest_share_of_requirement)?[["Largest share of it that was reached",an(100*n.largest_share_of_requirement,"%")]]:[],...e?[["Voxel error rate of what is solid then",le(e.ver,3)]]:[]];return gt({caption:`Moments of the print in time${n.name?`: ${n.name}`:""}`,heads:["","value"],rows:i})}function n0({run:n}){let e=Object.entries(at(n).run?.timings_s??{}).filter(h=>de(h[1])),t=Math.max(0,...e.map(([,h])=>h));if(t===0)return null;let i=e.filter(([h])=>!h.includes(": ")),s=h=>e.filter(([u])=>u.startsWith(`${h}: `)),r=e.filter(([h])=>h.includes(": ")&&!i.some(([u])=>h.startsWith(`${u}: `))),o=(h,u)=>u[1]-h[1],a=i.reduce((h,[,u])=>h+u,0),l=(h,u,d)=>v(d?"div.row.sub":"div.row",{},v("span",{},h),v("div.share",{"aria-hidden":"true"},v("i",{style:`width: ${(100*u/t).toFixed(1)}%`})),v("span.value",{},`${le(u,3)} s`)),c=[...i,...r].sort(o).flatMap(([h,u])=>[l(h,u,!1),...s(h).sort(o).map(([d,f])=>l(d.slice(h.length+2),f,!0))]);return v("div",{},v("p.quiet",{},`${le(a,3)} s until this page was written.`),v("div.timings",{},...c))}var i0=[...Yl,{id:"head",title:"",render:Rg},{id:"warnings",title:"Please note",render:Yg},{id:"limits",title:"Exposure and limits",render:Wg},{id:"errors",title:"How far the response is off",render:Fg},{id:"species",title:"Several species",render:e0},{id:"time",title:"The print in time",render:t0},{id:"properties",title:"Predicted properties",render:Jg},{id:"ceiling",title:"Quality against time",render:Ng},{id:"scenarios",title:"Scenarios",render:Qg},{id:"objectives",title:"Objectives",render:Kg},{id:"history",title:"History of the optimization",render:vg},{id:"lights",title:"Light and time",render:zg},{id:"numbers",title:"All numbers",render:Pg},{id:"published",title:"Published numbers",render:jg},{id:"movies",title:"Movies",render:qg},{id:"timings",title:"Where the time went",render:n0},{id:"notes",title:"How it was computed",render:Zg},{id:"job",title:"The job",render:kg}];var EM=100,TM=.2,Kl=class{constructor(e,t){this.sweep=e;this.rows=e.rows,this.axes=e.axes.map((s,r)=>AM(s,r,e.rows)),this.metrics=e.metrics.map((s,r)=>CM(s,e.axes.length+r,t));let i=this.varying.reduce((s,{levels:r})=>s*r.length,1);this.isCrossed=this.varying.length>1&&e.rows.length>=TM*i}sweep;axes;metrics;rows;isCrossed;get columns(){return[...this.axes,...this.metrics]}get varying(){return this.axes.filter(({levels:e})=>e.length>1)}value(e,t){return this.rows[e].values[t.at]??null}number(e,t){let i=this.value(e,t);return de(i)?i:null}text(e,t,i=6){return On(this.value(e,t),i)}point(e){return this.axes.map(t=>`${t.name} ${this.text(e,t)}`).join(", ")}state(e){let{state:t,feasible:i}=this.rows[e];return t!=="done"?t:e===this.sweep.best?"best":i===!1?"infeasible":"done"}scale(e){let t=this.range(e);return t&&{...t,map:is}}range(e){let[t,i]=[1/0,-1/0];return this.rows.forEach((s,r)=>{let o=this.number(r,e);o!==null&&(t=Math.min(t,o),i=Math.max(i,o))}),t>i?null:{low:t,high:i,logarithmic:t>0&&i>=EM*t}}};function Di({title:n,unit:e}){return e===""?n:`${n}, ${e}`}function On(n,e=6){return n==null?In:typeof n=="number"?le(n,e):Array.isArray(n)?n.map(t=>On(t,e)).join(" "):Qn(n)?Object.entries(n).map(([t,i])=>Qn(i)?`${t} ${On(i,e)}`.trim():`${t}=${On(i,e)}`).join(" "):String(n)}function Jl(n,e){return n.high>n.low?xr({...n,map:is},e):.5}function AM(n,e,t){let i=t.map(({values:l})=>JSON.stringify(l[e]??null)),s=new Map(i.map((l,c)=>[l,t[c].values[e]??null])),r=s.size>0&&[...s.values()].every(de),o=[...s];r&&o.sort(([,l],[,c])=>Number(l)-Number(c));let a=new Map(o.map(([l],c)=>[l,c]));return{name:n,at:e,title:n,unit:"",summary:"",better:"none",isNumeric:r,levels:o.map(([,l])=>l),levelOf:i.map(l=>a.get(l)??0)}}function CM(n,e,t){let[i,s,...r]=n.split("."),o=r.length===0&&(i==="evaluation"||i==="optimization")?t.find(l=>l.name===s):void 0;if(!o)return{name:n,at:e,title:n,unit:"",summary:"",better:"none"};let a=i==="evaluation"?o.title:`${o.title} (${i})`;return{name:n,at:e,title:a,unit:o.unit==="response"?"":o.unit,summary:o.summary,better:o.better}}function s0(n,e,t){let i=e.map(o=>v("span.marked-run",{},v("button",{type:"button",click:()=>t.open(o)},`Run ${o+1}`),v("button",{type:"button","aria-label":`Leave run ${o+1} out`,title:"Leave it out",click:()=>t.toggle(o)},"×"),v("small",{},n.state(o)))),s=o=>{let a=PM(e.map(c=>n.number(c,o)),o.better),l=c=>a!==null&&n.value(c,o)===a?v("b.best",{},n.text(c,o)):n.text(c,o);return[ba(o),...e.map(l)]},r=()=>[Ii(["",...e.map(o=>`run ${o+1}`)]),...n.columns.map(o=>Ii([o.name,...e.map(a=>RM(n.value(a,o)))]))].join(`
`)+`
`;return v("div",{},v("p.quiet",{},"↑ larger is better, ↓ smaller is better; the best of these runs is bold."),Li("Copy as CSV",r),gt({caption:"Marked runs side by side",heads:["",...i],rows:n.columns.map(s)}))}function RM(n){return de(n)?n:n===null?"":On(n)}function PM(n,e){let t=n.filter(de),[i,s]=[Math.min(...t),Math.max(...t)];return e==="none"||!(s>i)?null:e==="higher"?s:i}function Sa(n,e,t,i,s,...r){let o=`Run ${e+1}: ${n.point(e)}; ${t.title} ${n.text(e,t)}; ${n.state(e)}`;return v("button",{type:"button",class:`mark ${n.state(e)}`,tabindex:-1,"aria-label":o,"data-row":e,"data-x":i.x,"data-y":i.y,style:s},...r)}function r0(n,e,t){let i={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t];if(!i)return null;let s=({dataset:c})=>[Number(c.x),Number(c.y)],[r,o]=s(e),a=null,l=1/0;for(let c of n){let[h,u]=[s(c)[0]-r,s(c)[1]-o],d=h*i[0]+u*i[1];if(d<=0)continue;let f=Math.abs(h*i[1])+Math.abs(u*i[0]),g=d+1e3*f;g<l&&([a,l]=[c,g])}return a}var LM=7,IM=14,o0=76,Ld={least:6,most:34,all:720},DM=40;function a0(n,e,t,i,s){let[r,o]=[t.levels.length,i.levels.length],a=n.scale(e),l=r<=DM,c=s.map(x=>{let[p,m]=[t.levelOf[x],i.levelOf[x]],b=n.number(x,e),C=`grid-area: ${o-m} / ${p+2}`,S=n.rows[x].state==="done";if(b===null||!a)return Sa(n,x,e,{x:p,y:m},C,S&&l&&v("span",{},In));let R=a.map(Jl(a,b));return Sa(n,x,e,{x:p,y:m},`${C}; background-color: ${ml(R)}; color: ${NM(R)?"#000":"#fff"}`,l&&v("span",{},le(b,3)))}),h=t.levels.map((x,p)=>v("span.x",{style:`grid-area: ${o+1} / ${p+2}`},v("span",{},On(x,4)))),u=i.levels.map((x,p)=>v("span.y",{style:`grid-area: ${o-p} / 1`},On(x,4))),d=Math.min(Math.max(Ld.all/o,Ld.least),Ld.most),f=v("div.sweep-map",{style:`--columns: ${r}; --cell: ${d}px; gap: ${d>16?2:1}px; max-width: ${r*o0+90}px`},...u,...c,...h);UM(f,h);let g=Math.ceil(IM/d);return u.forEach((x,p)=>x.style.visibility=p%g===0?"":"hidden"),v("div",{},v("p.axis-name",{},`↑ ${Di(i)}`),f,v("p.axis-name.right",{style:`max-width: ${r*o0+90}px`},`${Di(t)} →`),a&&si({scale:a,label:Di(e),mark:null}))}function NM(n){let[e,t,i]=Jr(n);return .3*e+.59*t+.11*i>.5}function UM(n,e){let t=Math.max(...e.map(({textContent:i})=>i?.length??0));new ResizeObserver(()=>{let i=Math.ceil((t*LM+6)/Math.max(e[0]?.clientWidth??0,1));e.forEach((s,r)=>s.style.visibility=r%i===0?"":"hidden")}).observe(n)}function c0(n,e,t,i,s){let r=t.isNumeric?l0(n,t):OM(t),o=l0(n,e),a=f=>r?r.at(t.isNumeric?n.number(f,t)??0:t.levelOf[f]):0,c=[...i].sort((f,g)=>a(f)-a(g)).map(f=>({row:f,x:a(f),value:n.number(f,e)})),h=c.map(({row:f,x:g,value:x},p)=>Sa(n,f,e,{x:p,y:0},`left: ${jl(g)}; bottom: ${jl(x===null?0:o.at(x))}`,v("i",{}))),u=c.flatMap(({x:f,value:g})=>g===null?[]:[`${(100*f).toFixed(3)},${(100-100*o.at(g)).toFixed(3)}`]),d=s&&wt("svg",{viewBox:"0 0 100 100",preserveAspectRatio:"none","aria-hidden":"true"},wt("polyline",{points:u.join(" ")}));return v("div",{},v("div.sweep-plot",{},...(o?.ticks??[]).map(({at:f,text:g})=>v("span.y",{style:`bottom: ${jl(f)}`},g)),...(r?.ticks??[]).map(({at:f,text:g})=>v("span.x",{style:`left: ${jl(f)}`},g)),d,...h),v("p.axis-name.right",{},`${Di(t)} →`))}function jl(n){return`${(100*n).toFixed(3)}%`}function l0(n,e){let t=n.range(e);if(!t)return null;let i=r=>.04+.92*Jl(t,r),s=t.logarithmic?kM(t.low,t.high):FM(t.low,t.high);return{at:i,ticks:s.map(r=>({at:i(r),text:le(r,6)}))}}function OM({levels:n}){let e=s=>(s+.5)/n.length,t=Math.ceil(n.length/8),i=n.flatMap((s,r)=>r%t===0?[{at:e(r),text:On(s)}]:[]);return{at:e,ticks:i}}function FM(n,e){if(!(e>n))return[n];let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5].find(a=>a*i>=t)??10),r=Math.ceil(n/s-1e-9),o=Math.floor(e/s+1e-9)-r+1;return Array.from({length:o},(a,l)=>Number(((r+l)*s).toPrecision(12)))}function kM(n,e){let[t,i]=[Math.ceil(Math.log10(n)),Math.floor(Math.log10(e))],s=Math.ceil((i-t+1)/6);return Array.from({length:Math.floor((i-t)/s)+1},(r,o)=>10**(t+o*s))}var BM=["metric","x","y","plot","levels"],zM=[["best","best run"],["infeasible","does not meet best.where"],["failed","failed"],["missing","not made yet"]],Ql=class{constructor(e,t,i){this.model=e;this.state=t;this.actions=i;let s=new Set(e.rows.map((o,a)=>e.state(a))),r=zM.filter(([o])=>s.has(o)).map(([o,a])=>v("span",{},v("span",{class:`mark ${o}`},v("i",{})),a));this.element=v("div",{},v("p.quiet",{},"A click or Enter opens a run below; Shift-click or Space marks it for the comparison; arrow keys move from run to run. Several metrics can be shown at once."),this.controls,this.plots,v("p.color-keys.sweep-keys",{},...r,this.compare)),this.listen(),t.on(BM,()=>this.draw()),t.on(["opened","marked"],()=>this.press()),this.draw()}model;state;actions;element;controls=v("div.controls");plots=v("div.sweep-panels");tip=v("div.chart-tip",{hidden:!0});compare=v("button",{type:"button",hidden:!0,click:()=>Js("marked")});focus(e){this.marks().find(({dataset:t})=>Number(t.row)===e)?.focus()}get shown(){let e=this.state.get("metric").split(","),t=this.model.metrics.filter(({name:i})=>e.includes(i));return t.length>0?t:this.model.metrics.slice(0,1)}get isMap(){let e=this.state.get("plot");return this.model.varying.length>1&&(e===""?this.model.isCrossed:e==="map")}get axes(){let{varying:e}=this.model,t=r=>e.find(({name:o})=>o===this.state.get(r)),i=t("x")??e.find(r=>r!==t("y"))??e[0],s=t("y");return[i,s&&s!==i?s:e.find(r=>r!==i)??i]}level(e){let t=this.model.sweep.best,i=this.state.get("levels").split(",")[e.at]??"",s=i===""?t===null?0:e.levelOf[t]:Number(i);return e.levels[s]===void 0?0:s}draw(){let{model:e,isMap:t}=this,i=this.marks().indexOf(document.activeElement)>=0?document.activeElement.dataset.row:void 0;this.element.classList.toggle("as-dots",!t);let[s,r]=e.varying.length>0?this.axes:[];if(this.drawControls(s,r),!s||!r){this.plots.replaceChildren(v("p.quiet",{},"No axis of this sweep has more than one value: there is nothing to draw over."));return}let o=e.varying.filter(h=>h!==s&&h!==r),a=e.rows.map((h,u)=>u),l=t?a.filter(h=>o.every(u=>u.levelOf[h]===this.level(u))):a,c=h=>t?a0(e,h,s,r,l):c0(e,h,s,l,e.varying.length===1);this.plots.replaceChildren(...this.shown.map(h=>VM(xt(Di(h),c(h)),`${h.title} over ${t?`${s.name} and ${r.name}`:s.name}`)),this.tip),this.press();for(let h of this.plots.querySelectorAll(".part"))(h.querySelector(".opened, .mark.best")??h.querySelector(".mark"))?.setAttribute("tabindex","0");i!==void 0&&this.focus(Number(i))}drawControls(e,t){let{model:i,state:s,isMap:r}=this,o=document.activeElement?.closest(".controls")===this.controls?document.activeElement.getAttribute("data-control"):null,a=i.metrics.map(f=>{let g=this.shown.includes(f),x=()=>{let p=i.metrics.filter(m=>this.shown.includes(m)!==(m===f)).map(({name:m})=>m);p.length>0&&s.set({metric:p.join(",")})};return v("button",{type:"button","aria-pressed":String(g),title:f.summary||null,"data-control":f.name,click:x},f.title)}),l=(f,g,x,p)=>v("label",{},f,v("select",{"data-control":f,change:m=>p(m.target.selectedIndex)},...g.map((m,b)=>v("option",{selected:b===x},m)))),c=(f,g,x)=>{let p=i.varying.map(({name:b})=>b),m=b=>{let C={[g]:p[b]};r&&p[b]===(g==="x"?t:e)?.name&&(C[g==="x"?"y":"x"]=x.name),s.set(C)};return l(f,p,p.indexOf(x.name),m)},h=e&&t&&i.varying.length>1,u=[["map","Map"],["axis","Over one axis"]],d=h&&r?i.varying.filter(f=>f!==e&&f!==t):[];this.controls.replaceChildren(...[i.metrics.length>1&&v("div.choice",{role:"group","aria-label":"Metrics that are drawn"},...a),h&&Kn("Drawn as",u,()=>r?"map":"axis",f=>s.set({plot:f}),()=>{}),h&&c(r?"across":"over","x",e),h&&r&&c("up","y",t),...d.map(f=>l(Di(f),f.levels.map(g=>On(g)),this.level(f),g=>this.hold(f,g)))].filter(f=>!!f)),o!==null&&this.controls.querySelector(`[data-control="${CSS.escape(o)}"]`)?.focus()}hold(e,t){let i=this.model.axes.map(s=>s===e?t:this.level(s));this.state.set({levels:i.join(",")})}marks(){return[...this.plots.querySelectorAll(".mark")]}press(){let e=this.state.get("opened"),t=new Set(this.state.get("marked"));this.compare.hidden=t.size<2,this.compare.textContent=`Compare ${t.size} marked runs`;for(let i of this.marks()){let s=Number(i.dataset.row)+1;i.classList.toggle("opened",s===e),i.classList.toggle("marked",t.has(s)),i.setAttribute("aria-pressed",String(t.has(s)))}}listen(){let e=({target:i})=>i.closest(".mark[data-row]"),t=i=>this.showTip(e(i));this.plots.addEventListener("pointerover",t),this.plots.addEventListener("focusin",i=>{let s=e(i);if(this.showTip(s),s)for(let r of s.closest(".part").querySelectorAll(".mark"))r.setAttribute("tabindex",r===s?"0":"-1")});for(let i of["pointerleave","focusout"])this.plots.addEventListener(i,()=>this.showTip(null));this.plots.addEventListener("click",i=>{let s=e(i);s&&this.actions[i.shiftKey?"toggle":"open"](Number(s.dataset.row))}),this.plots.addEventListener("keydown",i=>this.onKey(i,e(i))),this.plots.addEventListener("keyup",i=>i.key===" "&&e(i)&&i.preventDefault())}onKey(e,t){!t||e.ctrlKey||e.metaKey||e.altKey||(e.key==="Escape"?this.showTip(null):e.key===" "?(e.preventDefault(),this.actions.toggle(Number(t.dataset.row))):e.key.startsWith("Arrow")&&(e.preventDefault(),r0([...t.closest(".part").querySelectorAll(".mark")],t,e.key)?.focus()))}showTip(e){if(this.tip.hidden=e===null,!e)return;let{model:t}=this,i=Number(e.dataset.row),s=c=>v("div",{},v("span",{},Di(c)),v("b",{},t.text(i,c,5))),{why:r}=t.rows[i];this.tip.replaceChildren(v("div.chart-tip-head",{},`Run ${i+1}, ${t.state(i)}`),...t.columns.map(s),...r?[v("p",{},r)]:[]);let[o,a]=[this.plots.getBoundingClientRect(),e.getBoundingClientRect()],l=a.left-o.left>o.width/2;this.tip.style.top=`${a.bottom-o.top+8}px`,this.tip.style.left=l?"":`${a.left-o.left}px`,this.tip.style.right=l?`${o.right-a.right}px`:""}};function VM(n,e){return n.setAttribute("role","group"),n.setAttribute("aria-label",e),n}var HM={"<=":(n,e)=>n<=e,">=":(n,e)=>n>=e,"!=":(n,e)=>n!==e,"==":(n,e)=>n===e,"=":(n,e)=>n===e,"<":(n,e)=>n<e,">":(n,e)=>n>e};function h0(n,e){let t=e.split(",").map(i=>i.trim()).filter(i=>i!=="").map(i=>GM(n,i));return n.rows.map((i,s)=>s).filter(i=>t.every(s=>s(i)))}function GM(n,e){let[,t,i,s]=e.match(/^(.*?)\s*(<=|>=|!=|==|=|<|>)\s*(.*)$/)??[],r=t===void 0?void 0:WM(n,t),o=Number(s);if(r&&s!==""&&de(o)){let l=HM[i];return c=>{let h=n.number(c,r);return h!==null&&l(h,o)}}if(r&&(i==="="||i==="=="))return l=>n.text(l,r).toLowerCase()===s.toLowerCase();let a=e.toLowerCase();return l=>[...n.columns.map(c=>n.text(l,c)),n.state(l),n.rows[l].why??""].some(c=>c.toLowerCase().includes(a))}function WM({columns:n},e){let t=n.filter(i=>i.name.split(".").at(-1)===e);return n.find(i=>i.name===e)??(t.length===1?t[0]:void 0)}var ec=200,tc=class{constructor(e,t,i){this.model=e;this.state=t;this.actions=i;let s=e.varying[0]?.name??"iou",r=v("input",{type:"search",placeholder:`${s} > 0.5, failed`,"aria-label":"Filter runs"});r.addEventListener("input",()=>{this.filter=r.value,this.most=ec,this.draw()}),this.element=v("div",{},v("div.controls",{},v("label.filter",{},"Filter",r),this.count,Li("Copy as CSV",()=>this.csv())),v("p.note",{},"A filter has conditions on columns and words, separated by commas. Numbers are in the units of report.json. A click on a head sorts."),this.place),this.place.addEventListener("click",o=>this.onClick(o)),t.on(["marked","opened"],()=>this.press()),this.draw()}model;state;actions;element;place=v("div.sweep-runs");count=v("span.quiet",{role:"status"});filter="";most=ec;sorted=null;rows(){let e=h0(this.model,this.filter);if(!this.sorted)return e;let{column:t,isDown:i}=this.sorted,{model:s}=this;return e.sort((r,o)=>{let[a,l]=[s.value(r,t),s.value(o,t)];if(a===null||l===null)return+(a===null)-+(l===null)||r-o;let c=de(a)&&de(l)?a-l:On(a).localeCompare(On(l));return(i?-c:c)||r-o})}draw(){let{model:e}=this,t=this.rows();this.count.textContent=t.length===e.rows.length?`${t.length} runs`:`${t.length} of ${e.rows.length} runs`;let i=["run","",...e.columns.map(a=>this.head(a)),"state"],s=a=>[v("button",{type:"button","data-row":a,title:"Open this run"},String(a+1)),v("input",{type:"checkbox","data-row":a,"aria-label":`Mark run ${a+1} for the comparison`}),...e.columns.map(l=>e.text(a,l,l.at<e.axes.length?6:4)),v("span",{},e.state(a),v("small",{},e.rows[a].why))],r=e.columns.flatMap((a,l)=>e.rows.some((c,h)=>typeof e.value(h,a)=="string")?[l+2]:[]),o=()=>{this.most+=ec,this.draw()};this.place.replaceChildren(gt({caption:"Runs of the sweep",heads:i,rows:t.slice(0,this.most).map(s),text:[1,...r,e.columns.length+2]}),...t.length>this.most?[v("button",{type:"button",click:o},`Show ${Math.min(ec,t.length-this.most)} more of ${t.length}`)]:[]),this.place.querySelectorAll("thead th").forEach((a,l)=>{let c=e.columns[l-2];c&&c===this.sorted?.column&&a.setAttribute("aria-sort",this.sorted.isDown?"descending":"ascending")}),this.press()}head(e){let t=this.sorted?.column===e?this.sorted.isDown?" ↓":" ↑":"",i=()=>{this.sort(e),this.place.querySelector(`[data-column="${e.at}"]`)?.focus()};return v("button.sort",{type:"button","data-column":e.at,title:e.summary||null,click:i},Di(e)+t)}sort(e){let t=e.better==="higher";this.sorted?.column!==e?this.sorted={column:e,isDown:t}:this.sorted=this.sorted.isDown===t?{column:e,isDown:!t}:null,this.draw()}onClick(e){let t=e.target,i=t.closest("[data-row]")??t.closest("tbody tr")?.querySelector("[data-row]");if(!i)return;let s=Number(i.dataset.row);i instanceof HTMLInputElement?this.actions.toggle(s):this.actions.open(s)}press(){let e=new Set(this.state.get("marked"));for(let t of this.place.querySelectorAll("input[data-row]")){let i=Number(t.dataset.row)+1;t.checked=e.has(i);let s=t.closest("tr");i===this.state.get("opened")?s.setAttribute("aria-current","true"):s.removeAttribute("aria-current")}}csv(){let{model:e}=this,t=(s,r)=>{let o=e.value(s,r);return o===null||de(o)?o:On(o)},i=s=>Ii([s+1,...e.columns.map(r=>t(s,r)),e.rows[s].state,e.rows[s].feasible?.toString(),e.rows[s].why]);return[Ii(["run",...e.columns.map(({name:s})=>s),"state","feasible","error"]),...this.rows().map(i)].join(`
`)+`
`}};var nc=class{constructor(e,t,i,s){this.state=i;this.load=s;this.model=new Kl(t,e.metrics);let r={open:c=>this.choose(c),toggle:c=>this.toggle(c)};this.panels=new Ql(this.model,i,r);let o=new tc(this.model,i,r);this.side=v("section",{id:"marked","aria-label":"Marked runs side by side"});let a=()=>{let c=i.get("marked").map(h=>h-1).filter(h=>h<this.model.rows.length);this.side.hidden=c.length<2,this.side.replaceChildren(v("h2",{},"Marked runs side by side"),s0(this.model,c,r))},l=t.toml!==""&&v("details.fold",{},v("summary",{},"The sweep file"),Li("Copy the sweep file",()=>t.toml),v("pre.job",{tabindex:"0"},t.toml));this.sections=[Id("sweep-head","",this.head()),Id("sweep","Over the axes",this.panels.element),Id("runs","Runs",o.element,l),this.side,this.bar],a(),i.on(["marked"],a),i.on(["opened"],()=>{this.show(!0)}),this.show(!1)}state;load;sections;model;panels;side;bar=v("section",{id:"opened","aria-label":"Open run",hidden:!0});get entries(){let e=[{id:"sweep",title:"Over the axes"},{id:"runs",title:"Runs"}];return this.bar.hidden?e:[...e,{id:"opened",title:"Open run"}]}head(){let{model:e}=this,{name:t,best:i}=e.sweep,s=l=>e.rows.filter(c=>c.state===l).length,r=[[s("failed"),"failed"],[s("missing"),"not made yet"]].filter(([l])=>l!==0).map(([l,c])=>`, ${l} ${c}`).join(""),o=e.varying.map(l=>`${l.name} (${l.levels.length})`).join(", "),a=i===null?"No run meets best.where.":`The best is run ${i+1}: ${e.point(i)}.`;return v("div.head",{},v("p.brand",{},"Tomolith sweep"),v("h1",{},t),v("p.lead",{},`${e.rows.length} runs${o===""?"":` over ${o}`}: ${s("done")} done${r}. ${a}`),i!==null&&v("p",{},v("button",{type:"button",click:()=>this.choose(i)},"Open the best run")))}choose(e){this.state.get("opened")===e+1?this.show(!0):this.state.set({opened:e+1})}toggle(e){let t=this.state.get("marked"),i=e+1;this.state.set({marked:t.includes(i)?t.filter(s=>s!==i):[...t,i].sort((s,r)=>s-r)})}async show(e){let t=this.state.get("opened"),i=t===null?null:t-1,s=i===null?null:this.refusal(i);this.bar.hidden=i===null,this.bar.setAttribute("aria-busy",String(i!==null)),this.bar.replaceChildren(...i===null?[]:[this.barHead(i),v("p.quiet",{role:"status"},"Opening…")]);let r=await this.load(s===null?i:null).then(()=>s,o=>o instanceof Error?o.message:String(o));this.state.get("opened")===t&&(this.bar.lastElementChild?.replaceWith(r===null?"":v("p.problem",{role:"alert"},r)),this.bar.removeAttribute("aria-busy"),e&&i!==null&&Js("opened"))}refusal(e){let t=this.model.rows[e];return t?t.state==="done"?null:t.state==="missing"?"This run has not been made yet. The command that made the sweep continues it.":`This run failed: ${t.why??"the sweep does not say why"}`:`The sweep has ${this.model.rows.length} runs.`}barHead(e){let t=()=>{this.state.set({opened:null}),document.getElementById("sweep")?.scrollIntoView(),this.panels.focus(e)},i=this.model.rows[e]?this.model.point(e):"";return v("div.opened-head",{},v("h2",{},`Run ${e+1}`),v("p",{},i),v("button",{type:"button",click:t},"Back to the sweep"))}};function Id(n,e,...t){return v("section",{id:n,"aria-label":e||"Sweep"},e!==""&&v("h2",{},e),...t)}var cr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},F0=0,lf=1,k0=2;var ja=1,B0=2,Vo=3,ur=0,ii=1,ai=2,Nr=0,Ho=1,cf=2,hf=3,uf=4,z0=5;var Ur=100,V0=101,H0=102,G0=103,W0=104,X0=200,$0=201,q0=202,Y0=203,df=204,ff=205,Z0=206,K0=207,J0=208,j0=209,Q0=210,ex=211,tx=212,nx=213,ix=214,Ac=0,Cc=1,Rc=2,Ro=3,Pc=4,Lc=5,Ic=6,Dc=7,rh=0,sx=1,rx=2,ds=0,pf=1,mf=2,gf=3,xf=4,_f=5,yf=6,vf=7;var bf=300,Or=301,Go=302,oh=303,ah=304,Nc=1e3,hs=1001,Uc=1002,yn=1003,ox=1004;var Qa=1005;var ni=1006,lh=1007;var Us=1008;var li=1009,Mf=1010,Sf=1011,Wo=1012,ch=1013,qi=1014,Yi=1015,Zi=1016,hh=1017,uh=1018,Fr=1020,wf=35902,Ef=35899,Tf=1021,Af=1022,wi=1023,Ls=1026,Os=1027,Cf=1028,dh=1029,dr=1030,fh=1031;var ph=1033,el=33776,tl=33777,nl=33778,il=33779,mh=35840,gh=35841,xh=35842,_h=35843,yh=36196,vh=37492,bh=37496,Mh=37488,Sh=37489,sl=37490,wh=37491,Eh=37808,Th=37809,Ah=37810,Ch=37811,Rh=37812,Ph=37813,Lh=37814,Ih=37815,Dh=37816,Nh=37817,Uh=37818,Oh=37819,Fh=37820,kh=37821,Bh=36492,zh=36494,Vh=36495,Hh=36283,Gh=36284,rl=36285,Wh=36286;var Ia=2300,Oc=2301,Ec=2302,ef=2303,tf=2400,nf=2401,sf=2402;var ax=3200;var Xh=0,lx=1,Fs="",Nn="srgb",Da="srgb-linear",Na="linear",It="srgb";var Tc=7680;var cx=519,hx=512,ux=513,dx=514,Rf=515,fx=516,px=517,Pf=518,Lf=519,mx=35044;var If="300 es",Ui=2e3,Po=2001;function XM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function $M(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ua(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function gx(){let n=Ua("canvas");return n.style.display="block",n}var u0={},Lo=null;function Df(...n){let e="THREE."+n.shift();Lo?Lo("log",e,...n):console.log(e,...n)}function xx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ze(...n){n=xx(n);let e="THREE."+n.shift();if(Lo)Lo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=xx(n);let e="THREE."+n.shift();if(Lo)Lo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ra(...n){let e=n.join(" ");e in u0||(u0[e]=!0,Ze(...n))}function _x(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var yx={[Ac]:Ac,[Rc]:Ic,[Pc]:Pc,[Ro]:Lc,[Cc]:Cc,[Ic]:Rc,[Dc]:Dc,[Lc]:Ro},$i=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],d0=1234567,Pa=Math.PI/180,Io=180/Math.PI;function Xo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]+"-"+zn[e&255]+zn[e>>8&255]+"-"+zn[e>>16&15|64]+zn[e>>24&255]+"-"+zn[t&63|128]+zn[t>>8&255]+"-"+zn[t>>16&255]+zn[t>>24&255]+zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]).toLowerCase()}function _t(n,e,t){return Math.max(e,Math.min(t,n))}function Nf(n,e){return(n%e+e)%e}function qM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function YM(n,e,t){return n!==e?(t-n)/(e-n):0}function La(n,e,t){return(1-t)*n+t*e}function ZM(n,e,t,i){return La(n,e,1-Math.exp(-t*i))}function KM(n,e=1){return e-Math.abs(Nf(n,e*2)-e)}function JM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function jM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function QM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function eS(n,e){return n+Math.random()*(e-n)}function tS(n){return n*(.5-Math.random())}function nS(n){n!==void 0&&(d0=n);let e=d0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function iS(n){return n*Pa}function sS(n){return n*Io}function rS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function oS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Uf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function aS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),h=o((e+i)/2),u=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),g=o((i-e)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*f,a*h,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Of(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vx(n,e){if(e.constructor===Float32Array)return n;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function bx(n,e){if(e.constructor===Float32Array)return n;let t=Of(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ff={DEG2RAD:Pa,RAD2DEG:Io,generateUUID:Xo,clamp:_t,euclideanModulo:Nf,mapLinear:qM,inverseLerp:YM,lerp:La,damp:ZM,pingpong:KM,smoothstep:JM,smootherstep:jM,randInt:QM,randFloat:eS,randFloatSpread:tS,seededRandom:nS,degToRad:iS,radToDeg:sS,isPowerOfTwo:rS,ceilPowerOfTwo:oS,floorPowerOfTwo:Uf,setQuaternionFromProperEuler:aS,normalize:bx,denormalize:vx},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},vi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*x;p<0&&(d=-d,f=-f,g=-g,x=-x,p=-p);let m=1-a;if(p<.9995){let b=Math.acos(p),C=Math.sin(b);m=Math.sin(m*b)/C,a=Math.sin(a*b)/C,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+x*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+x*a;let b=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=b,c*=b,h*=b,u*=b}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(f0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(f0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),u=2*(r*i-o*t);return this.x=t+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Dd.copy(this).projectOnVector(e),this.sub(Dd)}reflect(e){return this.sub(Dd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dd=new q,f0=new vi,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],g=i[8],x=s[0],p=s[3],m=s[6],b=s[1],C=s[4],S=s[7],R=s[2],A=s[5],y=s[8];return r[0]=o*x+a*b+l*R,r[3]=o*p+a*C+l*A,r[6]=o*m+a*S+l*y,r[1]=c*x+h*b+u*R,r[4]=c*p+h*C+u*A,r[7]=c*m+h*S+u*y,r[2]=d*x+f*b+g*R,r[5]=d*p+f*C+g*A,r[8]=d*m+f*S+g*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=u*x,e[1]=(s*c-h*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(h*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ra("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nd.makeScale(e,t)),this}rotate(e){return Ra("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nd.makeRotation(-e)),this}translate(e,t){return Ra("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nd=new nt,p0=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),m0=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function lS(){let n={enabled:!0,workingColorSpace:Da,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=Ps(s.r),s.g=Ps(s.g),s.b=Ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=Co(s.r),s.g=Co(s.g),s.b=Co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fs?Na:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Da]:{primaries:e,whitePoint:i,transfer:Na,toXYZ:p0,fromXYZ:m0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Nn},outputColorSpaceConfig:{drawingBufferColorSpace:Nn}},[Nn]:{primaries:e,whitePoint:i,transfer:It,toXYZ:p0,fromXYZ:m0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Nn}}}),n}var Mt=lS();function Ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Co(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var mo,Fc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{mo===void 0&&(mo=Ua("canvas")),mo.width=e.width,mo.height=e.height;let s=mo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=mo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ua("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ps(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ps(t[i]/255)*255):t[i]=Ps(t[i]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},cS=0,Do=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:cS++}),this.uuid=Xo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ud(s[o].image)):r.push(Ud(s[o]))}else r=Ud(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Ud(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Fc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var hS=0,Od=new q,ri=class n extends $i{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=hs,s=hs,r=ni,o=Us,a=wi,l=li,c=n.DEFAULT_ANISOTROPY,h=Fs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:hS++}),this.uuid=Xo(),this.name="",this.source=new Do(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Od).x}get height(){return this.source.getSize(Od).y}get depth(){return this.source.getSize(Od).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==bf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Nc:e.x=e.x-Math.floor(e.x);break;case hs:e.x=e.x<0?0:1;break;case Uc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Nc:e.y=e.y-Math.floor(e.y);break;case hs:e.y=e.y<0?0:1;break;case Uc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=bf;ri.DEFAULT_ANISOTROPY=1;var Jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],x=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,S=(f+1)/2,R=(m+1)/2,A=(h+d)/4,y=(u+x)/4,E=(g+p)/4;return C>S&&C>R?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=A/i,r=y/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=E/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=y/r,s=E/r),this.set(i,s,r,t),this}let b=Math.sqrt((p-g)*(p-g)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(b)<.001&&(b=1),this.x=(p-g)/b,this.y=(u-x)/b,this.z=(d-h)/b,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},kc=class extends $i{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ni,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ni,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Do(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends kc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Oa=class extends ri{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Bc=class extends ri{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Yt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,h,u,d,f,g,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,u,d,f,g,x,p)}set(e,t,i,s,r,o,a,l,c,h,u,d,f,g,x,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=x,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/go.setFromMatrixColumn(e,0).length(),r=1/go.setFromMatrixColumn(e,1).length(),o=1/go.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,x=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,x=c*u;t[0]=d+x*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,x=c*u;t[0]=d-x*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,x=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+x,t[1]=l*u,t[5]=x*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=x-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-x*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,x=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+x,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=x*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(uS,e,dS)}lookAt(e,t,i){let s=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),js.crossVectors(i,xi),js.lengthSq()===0&&(Math.abs(i.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),js.crossVectors(i,xi)),js.normalize(),ic.crossVectors(xi,js),s[0]=js.x,s[4]=ic.x,s[8]=xi.x,s[1]=js.y,s[5]=ic.y,s[9]=xi.y,s[2]=js.z,s[6]=ic.z,s[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],g=i[2],x=i[6],p=i[10],m=i[14],b=i[3],C=i[7],S=i[11],R=i[15],A=s[0],y=s[4],E=s[8],B=s[12],U=s[1],D=s[5],H=s[9],G=s[13],N=s[2],W=s[6],K=s[10],V=s[14],he=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=o*A+a*U+l*N+c*he,r[4]=o*y+a*D+l*W+c*J,r[8]=o*E+a*H+l*K+c*Q,r[12]=o*B+a*G+l*V+c*se,r[1]=h*A+u*U+d*N+f*he,r[5]=h*y+u*D+d*W+f*J,r[9]=h*E+u*H+d*K+f*Q,r[13]=h*B+u*G+d*V+f*se,r[2]=g*A+x*U+p*N+m*he,r[6]=g*y+x*D+p*W+m*J,r[10]=g*E+x*H+p*K+m*Q,r[14]=g*B+x*G+p*V+m*se,r[3]=b*A+C*U+S*N+R*he,r[7]=b*y+C*D+S*W+R*J,r[11]=b*E+C*H+S*K+R*Q,r[15]=b*B+C*G+S*V+R*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],x=e[7],p=e[11],m=e[15],b=l*f-c*d,C=a*f-c*u,S=a*d-l*u,R=o*f-c*h,A=o*d-l*h,y=o*u-a*h;return t*(x*b-p*C+m*S)-i*(g*b-p*R+m*A)+s*(g*C-x*R+m*y)-r*(g*S-x*A+p*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],x=e[13],p=e[14],m=e[15],b=t*a-i*o,C=t*l-s*o,S=t*c-r*o,R=i*l-s*a,A=i*c-r*a,y=s*c-r*l,E=h*x-u*g,B=h*p-d*g,U=h*m-f*g,D=u*p-d*x,H=u*m-f*x,G=d*m-f*p,N=b*G-C*H+S*D+R*U-A*B+y*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*G-l*H+c*D)*W,e[1]=(s*H-i*G-r*D)*W,e[2]=(x*y-p*A+m*R)*W,e[3]=(d*A-u*y-f*R)*W,e[4]=(l*U-o*G-c*B)*W,e[5]=(t*G-s*U+r*B)*W,e[6]=(p*S-g*y-m*C)*W,e[7]=(h*y-d*S+f*C)*W,e[8]=(o*H-a*U+c*E)*W,e[9]=(i*U-t*H-r*E)*W,e[10]=(g*A-x*S+m*b)*W,e[11]=(u*S-h*A-f*b)*W,e[12]=(a*B-o*D-l*E)*W,e[13]=(t*D-i*B+s*E)*W,e[14]=(x*C-g*R-p*b)*W,e[15]=(h*R-u*C+d*b)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,x=o*h,p=o*u,m=a*u,b=l*c,C=l*h,S=l*u,R=i.x,A=i.y,y=i.z;return s[0]=(1-(x+m))*R,s[1]=(f+S)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(f-S)*A,s[5]=(1-(d+m))*A,s[6]=(p+b)*A,s[7]=0,s[8]=(g+C)*y,s[9]=(p-b)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=go.set(s[0],s[1],s[2]).length(),a=go.set(s[4],s[5],s[6]).length(),l=go.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Gi.copy(this);let c=1/o,h=1/a,u=1/l;return Gi.elements[0]*=c,Gi.elements[1]*=c,Gi.elements[2]*=c,Gi.elements[4]*=h,Gi.elements[5]*=h,Gi.elements[6]*=h,Gi.elements[8]*=u,Gi.elements[9]*=u,Gi.elements[10]*=u,t.setFromRotationMatrix(Gi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Ui)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Po)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,h=2/(t-e),u=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Ui)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===Po)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},go=new q,Gi=new Yt,uS=new q(0,0,0),dS=new q(1,1,1),js=new q,ic=new q,xi=new q,g0=new Yt,x0=new vi,Is=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return g0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(g0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return x0.setFromEuler(this),this.setFromQuaternion(x0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Is.DEFAULT_ORDER="XYZ";var Fa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},fS=0,_0=new q,xo=new vi,ws=new Yt,sc=new q,wa=new q,pS=new q,mS=new vi,y0=new q(1,0,0),v0=new q(0,1,0),b0=new q(0,0,1),M0={type:"added"},gS={type:"removed"},_o={type:"childadded",child:null},Fd={type:"childremoved",child:null},Gn=class n extends $i{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:fS++}),this.uuid=Xo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new q,t=new Is,i=new vi,s=new q(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Yt},normalMatrix:{value:new nt}}),this.matrix=new Yt,this.matrixWorld=new Yt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return xo.setFromAxisAngle(e,t),this.quaternion.multiply(xo),this}rotateOnWorldAxis(e,t){return xo.setFromAxisAngle(e,t),this.quaternion.premultiply(xo),this}rotateX(e){return this.rotateOnAxis(y0,e)}rotateY(e){return this.rotateOnAxis(v0,e)}rotateZ(e){return this.rotateOnAxis(b0,e)}translateOnAxis(e,t){return _0.copy(e).applyQuaternion(this.quaternion),this.position.add(_0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(y0,e)}translateY(e){return this.translateOnAxis(v0,e)}translateZ(e){return this.translateOnAxis(b0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?sc.copy(e):sc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(wa,sc,this.up):ws.lookAt(sc,wa,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),xo.setFromRotationMatrix(ws),this.quaternion.premultiply(xo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(M0),_o.child=e,this.dispatchEvent(_o),_o.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(gS),Fd.child=e,this.dispatchEvent(Fd),Fd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ws.multiply(e.parent.matrixWorld)),e.applyMatrix4(ws),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(M0),_o.child=e,this.dispatchEvent(_o),_o.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,e,pS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,mS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Gn.DEFAULT_UP=new q(0,1,0);Gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Rs=class extends Gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},xS={type:"move"},No=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Rs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Rs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Rs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let p=t.getJointPose(x,i),m=this._getHandJoint(c,x);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(xS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Rs;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Mx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},rc={h:0,s:0,l:0};function kd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ct=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Nn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Mt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Mt.workingColorSpace){return this.r=e,this.g=t,this.b=i,Mt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Mt.workingColorSpace){if(e=Nf(e,1),t=_t(t,0,1),i=_t(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=kd(o,r,e+1/3),this.g=kd(o,r,e),this.b=kd(o,r,e-1/3)}return Mt.colorSpaceToWorking(this,s),this}setStyle(e,t=Nn){function i(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Nn){let i=Mx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ps(e.r),this.g=Ps(e.g),this.b=Ps(e.b),this}copyLinearToSRGB(e){return this.r=Co(e.r),this.g=Co(e.g),this.b=Co(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Nn){return Mt.workingToColorSpace(Vn.copy(this),e),Math.round(_t(Vn.r*255,0,255))*65536+Math.round(_t(Vn.g*255,0,255))*256+Math.round(_t(Vn.b*255,0,255))}getHexString(e=Nn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Mt.workingColorSpace){Mt.workingToColorSpace(Vn.copy(this),t);let i=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Mt.workingColorSpace){return Mt.workingToColorSpace(Vn.copy(this),t),e.r=Vn.r,e.g=Vn.g,e.b=Vn.b,e}getStyle(e=Nn){Mt.workingToColorSpace(Vn.copy(this),e);let t=Vn.r,i=Vn.g,s=Vn.b;return e!==Nn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Qs),this.setHSL(Qs.h+e,Qs.s+t,Qs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Qs),e.getHSL(rc);let i=La(Qs.h,rc.h,t),s=La(Qs.s,rc.s,t),r=La(Qs.l,rc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new ct;ct.NAMES=Mx;var ka=class extends Gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Is,this.environmentIntensity=1,this.environmentRotation=new Is,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Wi=new q,Es=new q,Bd=new q,Ts=new q,yo=new q,vo=new q,S0=new q,zd=new q,Vd=new q,Hd=new q,Gd=new Jt,Wd=new Jt,Xd=new Jt,ir=class n{constructor(e=new q,t=new q,i=new q){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Wi.subVectors(e,t),s.cross(Wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Wi.subVectors(s,t),Es.subVectors(i,t),Bd.subVectors(e,t);let o=Wi.dot(Wi),a=Wi.dot(Es),l=Wi.dot(Bd),c=Es.dot(Es),h=Es.dot(Bd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Gd.setScalar(0),Wd.setScalar(0),Xd.setScalar(0),Gd.fromBufferAttribute(e,t),Wd.fromBufferAttribute(e,i),Xd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gd,r.x),o.addScaledVector(Wd,r.y),o.addScaledVector(Xd,r.z),o}static isFrontFacing(e,t,i,s){return Wi.subVectors(i,t),Es.subVectors(e,t),Wi.cross(Es).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Wi.subVectors(this.c,this.b),Es.subVectors(this.a,this.b),Wi.cross(Es).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;yo.subVectors(s,i),vo.subVectors(r,i),zd.subVectors(e,i);let l=yo.dot(zd),c=vo.dot(zd);if(l<=0&&c<=0)return t.copy(i);Vd.subVectors(e,s);let h=yo.dot(Vd),u=vo.dot(Vd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(yo,o);Hd.subVectors(e,r);let f=yo.dot(Hd),g=vo.dot(Hd);if(g>=0&&f<=g)return t.copy(r);let x=f*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(vo,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return S0.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(S0,a);let m=1/(p+x+d);return o=x*m,a=d*m,t.copy(i).addScaledVector(yo,o).addScaledVector(vo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},sr=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Xi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Xi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Xi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Xi):Xi.fromBufferAttribute(r,o),Xi.applyMatrix4(e.matrixWorld),this.expandByPoint(Xi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),oc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),oc.copy(i.boundingBox)),oc.applyMatrix4(e.matrixWorld),this.union(oc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Xi),Xi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ea),ac.subVectors(this.max,Ea),bo.subVectors(e.a,Ea),Mo.subVectors(e.b,Ea),So.subVectors(e.c,Ea),er.subVectors(Mo,bo),tr.subVectors(So,Mo),Tr.subVectors(bo,So);let t=[0,-er.z,er.y,0,-tr.z,tr.y,0,-Tr.z,Tr.y,er.z,0,-er.x,tr.z,0,-tr.x,Tr.z,0,-Tr.x,-er.y,er.x,0,-tr.y,tr.x,0,-Tr.y,Tr.x,0];return!$d(t,bo,Mo,So,ac)||(t=[1,0,0,0,1,0,0,0,1],!$d(t,bo,Mo,So,ac))?!1:(lc.crossVectors(er,tr),t=[lc.x,lc.y,lc.z],$d(t,bo,Mo,So,ac))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Xi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Xi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(As),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},As=[new q,new q,new q,new q,new q,new q,new q,new q],Xi=new q,oc=new sr,bo=new q,Mo=new q,So=new q,er=new q,tr=new q,Tr=new q,Ea=new q,ac=new q,lc=new q,Ar=new q;function $d(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ar.fromArray(n,r);let a=s.x*Math.abs(Ar.x)+s.y*Math.abs(Ar.y)+s.z*Math.abs(Ar.z),l=e.dot(Ar),c=t.dot(Ar),h=i.dot(Ar);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _n=new q,cc=new tt,_S=0,Hn=class extends $i{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:_S++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=mx,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=e!==void 0?Of(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)cc.fromBufferAttribute(this,t),cc.applyMatrix3(e),this.setXY(t,cc.x,cc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix3(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)_n.fromBufferAttribute(this,t),_n.applyMatrix4(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)_n.fromBufferAttribute(this,t),_n.applyNormalMatrix(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)_n.fromBufferAttribute(this,t),_n.transformDirection(e),this.setXYZ(t,_n.x,_n.y,_n.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):vx(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bx(e,this.array)}};var Ba=class extends Hn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var za=class extends Hn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var yi=class extends Hn{constructor(e,t,i){super(new Float32Array(e),t,i)}},yS=new sr,Ta=new q,qd=new q,Pr=class{constructor(e=new q,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):yS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ta.subVectors(e,this.center);let t=Ta.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ta,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(qd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ta.copy(e.center).add(qd)),this.expandByPoint(Ta.copy(e.center).sub(qd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},vS=0,Ni=new Yt,Yd=new Gn,wo=new q,_i=new sr,Aa=new sr,Dn=new q,Mi=class n extends $i{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:vS++}),this.uuid=Xo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(XM(e)?za:Ba)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,i){return Ni.makeTranslation(e,t,i),this.applyMatrix4(Ni),this}scale(e,t,i){return Ni.makeScale(e,t,i),this.applyMatrix4(Ni),this}lookAt(e){return Yd.lookAt(e),Yd.updateMatrix(),this.applyMatrix4(Yd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(wo).negate(),this.translate(wo.x,wo.y,wo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new yi(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new sr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Pr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Aa.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(_i.min,Aa.min),_i.expandByPoint(Dn),Dn.addVectors(_i.max,Aa.max),_i.expandByPoint(Dn)):(_i.expandByPoint(Aa.min),_i.expandByPoint(Aa.max))}_i.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Dn.fromBufferAttribute(a,c),l&&(wo.fromBufferAttribute(e,c),Dn.add(wo)),s=Math.max(s,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Hn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new q,l[B]=new q;let h=new q,u=new q,d=new q,f=new tt,g=new tt,x=new tt,p=new q,m=new q;function b(B,U,D){c[B]=c[U]=c[D]=1,h.fromBufferAttribute(i,B),u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,B),g.fromBufferAttribute(r,U),x.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(f),x.sub(f);let H=1/(g.x*x.y-x.x*g.y);isFinite(H)&&(p.copy(u).multiplyScalar(x.y).addScaledVector(d,-g.y).multiplyScalar(H),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-x.x).multiplyScalar(H),a[B].add(p),a[U].add(p),a[D].add(p),l[B].add(m),l[U].add(m),l[D].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let B=0,U=C.length;B<U;++B){let D=C[B],H=D.start,G=D.count;for(let N=H,W=H+G;N<W;N+=3)b(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new q,R=new q,A=new q,y=new q;function E(B){A.fromBufferAttribute(s,B),y.copy(A);let U=a[B];S.copy(U),S.sub(A.multiplyScalar(A.dot(U))).normalize(),R.crossVectors(y,U);let H=R.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,H)}for(let B=0,U=i.count;B<U;++B)c[B]&&E(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Hn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,h=new q,u=new q;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),x=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,p),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let x=0,p=l.length;x<p;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new Hn(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Zd=new q,bS=new q,MS=new nt,ei=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Zd.subVectors(i,t).cross(bS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Zd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||MS.getNormalMatrix(e),s=this.coplanarPoint(Zd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},SS=0,Ds=class extends $i{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:SS++}),this.uuid=Xo(),this.name="",this.type="Material",this.blending=Ho,this.side=ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=df,this.blendDst=ff,this.blendEquation=Ur,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=Ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Tc,this.stencilZFail=Tc,this.stencilZPass=Tc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ei().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new tt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Cs=new q,Kd=new q,hc=new q,uc=new q,Lr=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cs.copy(this.origin).addScaledVector(this.direction,t),Cs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Kd.copy(e).add(t).multiplyScalar(.5),hc.copy(t).sub(e).normalize(),uc.copy(this.origin).sub(Kd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(hc),a=uc.dot(this.direction),l=-uc.dot(hc),c=uc.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Kd).addScaledVector(hc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Cs.subVectors(e.center,this.origin);let i=Cs.dot(this.direction),s=Cs.dot(Cs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,x=t.y-o.y,p=t.z-o.z,m=i.x-o.x,b=i.y-o.y,C=i.z-o.z,S=Math.abs(l),R=Math.abs(c),A=Math.abs(h),y,E,B,U,D,H,G,N,W,K,V,he;if(S>=R&&S>=A?(B=l,H=u,W=g,he=m,l>=0?(y=c,E=h,U=d,D=f,G=x,N=p,K=b,V=C):(y=h,E=c,U=f,D=d,G=p,N=x,K=C,V=b)):R>=A?(B=c,H=d,W=x,he=b,c>=0?(y=h,E=l,U=f,D=u,G=p,N=g,K=C,V=m):(y=l,E=h,U=u,D=f,G=g,N=p,K=m,V=C)):(B=h,H=f,W=p,he=C,h>=0?(y=l,E=c,U=u,D=d,G=g,N=x,K=m,V=b):(y=c,E=l,U=d,D=u,G=x,N=g,K=b,V=m)),B===0)return null;let J=y/B,Q=E/B,se=1/B,pe=U-J*H,fe=D-Q*H,ee=G-J*W,xe=N-Q*W,ve=K-J*he,Re=V-Q*he,we=ve*xe-Re*ee,Xe=pe*Re-fe*ve,rt=ee*fe-xe*pe;if(s){if(we<0||Xe<0||rt<0)return null}else if((we<0||Xe<0||rt<0)&&(we>0||Xe>0||rt>0))return null;let Ge=we+Xe+rt;if(Ge===0)return null;let ft=se*(we*H+Xe*W+rt*he);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ir=class extends Ds{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=rh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},w0=new Yt,Cr=new Lr,dc=new Pr,E0=new q,fc=new q,pc=new q,mc=new q,Jd=new q,gc=new q,T0=new q,xc=new q,oi=class extends Gn{constructor(e=new Mi,t=new Ir){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){gc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Jd.fromBufferAttribute(u,e),o?gc.addScaledVector(Jd,h):gc.addScaledVector(Jd.sub(t),h))}t.add(gc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),dc.copy(i.boundingSphere),dc.applyMatrix4(r),Cr.copy(e.ray).recast(e.near),!(dc.containsPoint(Cr.origin)===!1&&(Cr.intersectSphere(dc,E0)===null||Cr.origin.distanceToSquared(E0)>(e.far-e.near)**2))&&(w0.copy(r).invert(),Cr.copy(e.ray).applyMatrix4(w0),!(i.boundingBox!==null&&Cr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Cr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let p=d[g],m=o[p.materialIndex],b=Math.max(p.start,f.start),C=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let S=b,R=C;S<R;S+=3){let A=a.getX(S),y=a.getX(S+1),E=a.getX(S+2);s=_c(this,m,e,i,c,h,u,A,y,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let b=a.getX(p),C=a.getX(p+1),S=a.getX(p+2);s=_c(this,o,e,i,c,h,u,b,C,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let p=d[g],m=o[p.materialIndex],b=Math.max(p.start,f.start),C=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let S=b,R=C;S<R;S+=3){let A=S,y=S+1,E=S+2;s=_c(this,m,e,i,c,h,u,A,y,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let b=p,C=p+1,S=p+2;s=_c(this,o,e,i,c,h,u,b,C,S),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function wS(n,e,t,i,s,r,o,a){let l;if(e.side===ii?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ur,a),l===null)return null;xc.copy(a),xc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(xc);return c<t.near||c>t.far?null:{distance:c,point:xc.clone(),object:n}}function _c(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,fc),n.getVertexPosition(l,pc),n.getVertexPosition(c,mc);let h=wS(n,e,t,i,fc,pc,mc,T0);if(h){let u=new q;ir.getBarycoord(T0,fc,pc,mc,u),s&&(h.uv=ir.getInterpolatedAttribute(s,a,l,c,u,new tt)),r&&(h.uv1=ir.getInterpolatedAttribute(r,a,l,c,u,new tt)),o&&(h.normal=ir.getInterpolatedAttribute(o,a,l,c,u,new q),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new q,materialIndex:0};ir.getNormal(fc,pc,mc,d.normal),h.face=d,h.barycoord=u}return h}var Uo=class extends ri{constructor(e=null,t=1,i=1,s,r,o,a,l,c=yn,h=yn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Rr=new Pr,ES=new tt(.5,.5),yc=new q,rr=class{constructor(e=new ei,t=new ei,i=new ei,s=new ei,r=new ei,o=new ei){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ui,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],x=r[9],p=r[10],m=r[11],b=r[12],C=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-b).normalize(),s[1].setComponents(c+o,f+h,m+g,R+b).normalize(),s[2].setComponents(c+a,f+u,m+x,R+C).normalize(),s[3].setComponents(c-a,f-u,m-x,R-C).normalize(),i)s[4].setComponents(l,d,p,S).normalize(),s[5].setComponents(c-l,f-d,m-p,R-S).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-S).normalize(),t===Ui)s[5].setComponents(c+l,f+d,m+p,R+S).normalize();else if(t===Po)s[5].setComponents(l,d,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Rr)}intersectsSprite(e){Rr.center.set(0,0,0);let t=ES.distanceTo(e.center);return Rr.radius=.7071067811865476+t,Rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Rr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(yc.x=s.normal.x>0?e.max.x:e.min.x,yc.y=s.normal.y>0?e.max.y:e.min.y,yc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(yc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},A0=new Yt,zc=class n{constructor(){this.coordinateSystem=Ui,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];A0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new rr),i[s].setFromProjectionMatrix(A0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new rr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Oo=class extends Ds{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Vc=new q,Hc=new q,C0=new Yt,Ca=new Lr,vc=new Pr,jd=new q,R0=new q,Gc=class extends Gn{constructor(e=new Mi,t=new Oo){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Vc.fromBufferAttribute(t,s-1),Hc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Vc.distanceTo(Hc);e.setAttribute("lineDistance",new yi(i,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),vc.copy(i.boundingSphere),vc.applyMatrix4(s),vc.radius+=r,e.ray.intersectsSphere(vc)===!1)return;C0.copy(s).invert(),Ca.copy(e.ray).applyMatrix4(C0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=c){let m=h.getX(x),b=h.getX(x+1),C=bc(this,e,Ca,l,m,b,x);C&&t.push(C)}if(this.isLineLoop){let x=h.getX(g-1),p=h.getX(f),m=bc(this,e,Ca,l,x,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=c){let m=bc(this,e,Ca,l,x,x+1,x);m&&t.push(m)}if(this.isLineLoop){let x=bc(this,e,Ca,l,g-1,f,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function bc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Vc.fromBufferAttribute(a,s),Hc.fromBufferAttribute(a,r),t.distanceSqToSegment(Vc,Hc,jd,R0)>i)return;jd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(jd);if(!(c<e.near||c>e.far))return{distance:c,point:R0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Va=class extends Gc{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Ha=class extends ri{constructor(e=[],t=Or,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ns=class extends ri{constructor(e,t,i=qi,s,r,o,a=yn,l=yn,c,h=Ls,u=1){if(h!==Ls&&h!==Os)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Do(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ga=class extends Ns{constructor(e,t=qi,i=Or,s,r,o=yn,a=yn,l,c=Ls){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Wa=class extends ri{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Fo=class n extends Mi{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new yi(c,3)),this.setAttribute("normal",new yi(h,3)),this.setAttribute("uv",new yi(u,2));function g(x,p,m,b,C,S,R,A,y,E,B){let U=S/y,D=R/E,H=S/2,G=R/2,N=A/2,W=y+1,K=E+1,V=0,he=0,J=new q;for(let Q=0;Q<K;Q++){let se=Q*D-G;for(let pe=0;pe<W;pe++){let fe=pe*U-H;J[x]=fe*b,J[p]=se*C,J[m]=N,c.push(J.x,J.y,J.z),J[x]=0,J[p]=0,J[m]=A>0?1:-1,h.push(J.x,J.y,J.z),u.push(pe/y),u.push(1-Q/E),V+=1}}for(let Q=0;Q<E;Q++)for(let se=0;se<y;se++){let pe=d+se+W*Q,fe=d+se+W*(Q+1),ee=d+(se+1)+W*(Q+1),xe=d+(se+1)+W*Q;l.push(pe,fe,xe),l.push(fe,ee,xe),he+=6}a.addGroup(f,he,B),f+=he,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Dr=class n extends Mi{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],x=[],p=[];for(let m=0;m<h;m++){let b=m*d-o;for(let C=0;C<c;C++){let S=C*u-r;g.push(S,-b,0),x.push(0,0,1),p.push(C/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let b=0;b<a;b++){let C=b+c*m,S=b+c*(m+1),R=b+1+c*(m+1),A=b+1+c*m;f.push(C,S,A),f.push(S,R,A)}this.setIndex(f),this.setAttribute("position",new yi(g,3)),this.setAttribute("normal",new yi(x,3)),this.setAttribute("uv",new yi(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function kr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(P0(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(P0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Wn(n){let e={};for(let t=0;t<n.length;t++){let i=kr(n[t]);for(let s in i)e[s]=i[s]}return e}function P0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function TS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function kf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Mt.workingColorSpace}var Sx={clone:kr,merge:Wn},AS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,CS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,us=class extends Ds{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=AS,this.fragmentShader=CS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=kr(e.uniforms),this.uniformsGroups=TS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ct().setHex(s.value);break;case"v2":this.uniforms[i].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Jt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Yt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Wc=class extends us{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ko=class extends Ds{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Xh,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=rh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Xc=class extends Ds{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ax,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},$c=class extends Ds{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Eo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Mc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var or=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},qc=class extends or{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:tf,endingEnd:tf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nf:r=e,a=2*t-i;break;case sf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case nf:o=e,l=2*i-t;break;case sf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-t)/(s-t),x=g*g,p=x*g,m=-d*p+2*d*x-d*g,b=(1+d)*p+(-1.5-2*d)*x+(-.5+d)*g+1,C=(-1-f)*p+(1.5+f)*x+.5*g,S=f*p-f*x;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+b*o[c+R]+C*o[l+R]+S*o[u+R];return r}},Yc=class extends or{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Zc=class extends or{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Kc=class extends or{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-t)/(s-t),x=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*x+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let x=o[c+g],p=o[l+g],m=f*d+g*2,b=u[m],C=u[m+1],S=e*d+g*2,R=h[S],A=h[S+1],y=PS(i,t,b,R,s);r[g]=wx(y,x,C,A,p)}return r}};function wx(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function RS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function PS(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=wx(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=RS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Eo(t,this.TimeBufferType),this.values=Eo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Eo(e.times,Array),values:Eo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Mc(e.settings)&&(i.settings={inTangents:Eo(e.settings.inTangents,Array),outTangents:Eo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Zc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Yc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new qc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Kc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ia:t=this.InterpolantFactoryMethodDiscrete;break;case Oc:t=this.InterpolantFactoryMethodLinear;break;case Ec:t=this.InterpolantFactoryMethodSmooth;break;case ef:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ze("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ia;case this.InterpolantFactoryMethodLinear:return Oc;case this.InterpolantFactoryMethodSmooth:return Ec;case this.InterpolantFactoryMethodBezier:return ef}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Mc(this.settings)&&(L0(this.settings.inTangents,e),L0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Mc(this.settings)&&(I0(this.settings.inTangents,e),I0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&$M(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Ec,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let g=0;g!==i;++g){let x=t[u+g];if(x!==t[d+g]||x!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Mc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function L0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function I0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Oc;var ar=class extends Si{constructor(e,t,i){super(e,t,i)}};ar.prototype.ValueTypeName="bool";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Ia;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var Jc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};Jc.prototype.ValueTypeName="color";var jc=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};jc.prototype.ValueTypeName="number";var Qc=class extends or{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)vi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Xa=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Qc(this.times,this.values,this.getValueSize(),e)}};Xa.prototype.ValueTypeName="quaternion";Xa.prototype.InterpolantFactoryMethodSmooth=void 0;var lr=class extends Si{constructor(e,t,i){super(e,t,i)}};lr.prototype.ValueTypeName="string";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Ia;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var eh=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};eh.prototype.ValueTypeName="vector";var th=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ex=new th,nh=class{constructor(e){this.manager=e!==void 0?e:Ex,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};nh.DEFAULT_MATERIAL_NAME="__DEFAULT";var $a=class extends Gn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Qd=new Yt,D0=new q,N0=new q,ih=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=li,this.map=null,this.mapPass=null,this.matrix=new Yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new rr,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;D0.setFromMatrixPosition(e.matrixWorld),t.position.copy(D0),N0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(N0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Qd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Qd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Po||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Qd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Sc=new q,wc=new vi,cs=new q,qa=class extends Gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Yt,this.projectionMatrix=new Yt,this.projectionMatrixInverse=new Yt,this.coordinateSystem=Ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Sc,wc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Sc,wc,cs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Sc,wc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Sc,wc,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new q,U0=new tt,O0=new tt,ti=class extends qa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Io*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Pa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Io*2*Math.atan(Math.tan(Pa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(nr.x,nr.y).multiplyScalar(-e/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(nr.x,nr.y).multiplyScalar(-e/nr.z)}getViewSize(e,t){return this.getViewBounds(e,U0,O0),t.subVectors(O0,U0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Pa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ya=class extends qa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},rf=class extends ih{constructor(){super(new Ya(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Za=class extends $a{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Gn.DEFAULT_UP),this.updateMatrix(),this.target=new Gn,this.shadow=new rf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ka=class extends $a{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var To=-90,Ao=1,Bo=class extends Gn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ti(To,Ao,e,t);s.layers=this.layers,this.add(s);let r=new ti(To,Ao,e,t);r.layers=this.layers,this.add(r);let o=new ti(To,Ao,e,t);o.layers=this.layers,this.add(o);let a=new ti(To,Ao,e,t);a.layers=this.layers,this.add(a);let l=new ti(To,Ao,e,t);l.layers=this.layers,this.add(l);let c=new ti(To,Ao,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ui)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Po)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},sh=class extends ti{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Bf="\\[\\]\\.:\\/",LS=new RegExp("["+Bf+"]","g"),zf="[^"+Bf+"]",IS="[^"+Bf.replace("\\.","")+"]",DS=/((?:WC+[\/:])*)/.source.replace("WC",zf),NS=/(WCOD+)?/.source.replace("WCOD",IS),US=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",zf),OS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",zf),FS=new RegExp("^"+DS+NS+US+OS+"$"),kS=["material","materials","bones","map"],of=class{constructor(e,t,i){let s=i||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(LS,"")}static parseTrackName(e){let t=FS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);kS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=of;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var YI=new Float32Array(1);var zo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=_t(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(_t(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var af=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Ja=class extends $i{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Vf(n,e,t,i){let s=BS(i);switch(t){case Tf:return n*e;case Cf:return n*e/s.components*s.byteLength;case dh:return n*e/s.components*s.byteLength;case dr:return n*e*2/s.components*s.byteLength;case fh:return n*e*2/s.components*s.byteLength;case Af:return n*e*3/s.components*s.byteLength;case wi:return n*e*4/s.components*s.byteLength;case ph:return n*e*4/s.components*s.byteLength;case el:case tl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case nl:case il:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case gh:case _h:return Math.max(n,16)*Math.max(e,8)/4;case mh:case xh:return Math.max(n,8)*Math.max(e,8)/2;case yh:case vh:case Mh:case Sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case bh:case sl:case wh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Eh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Th:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ah:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ch:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Rh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Ph:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ih:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Dh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Nh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Fh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case kh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Bh:case zh:case Vh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Hh:case Gh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case rl:case Wh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function BS(n){switch(n){case li:case Mf:return{byteLength:1,components:1};case Wo:case Sf:case Zi:return{byteLength:2,components:1};case hh:case uh:return{byteLength:2,components:4};case qi:case ch:case Yi:return{byteLength:4,components:1};case wf:case Ef:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function qx(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function VS(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],x=u[f];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let x=u[f];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var HS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,GS=`#ifdef USE_ALPHAHASH
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
#endif`,WS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,XS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$S=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,qS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,YS=`#ifdef USE_AOMAP
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
#endif`,ZS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,KS=`#ifdef USE_BATCHING
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
#endif`,JS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,jS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,QS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ew=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,tw=`#ifdef USE_IRIDESCENCE
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
#endif`,nw=`#ifdef USE_BUMPMAP
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
#endif`,iw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,sw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,rw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ow=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,aw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,lw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,cw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,hw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,uw=`#define PI 3.141592653589793
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
} // validated`,dw=`vec3 transformedNormal = objectNormal;
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
#endif`,fw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,pw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,mw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,gw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,xw="gl_FragColor = linearToOutputTexel( gl_FragColor );",_w=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,yw=`#ifdef USE_ENVMAP
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
#endif`,vw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,bw=`#ifdef USE_ENVMAP
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
#endif`,Mw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Sw=`#ifdef USE_ENVMAP
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
#endif`,ww=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ew=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Tw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Aw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Cw=`#ifdef USE_GRADIENTMAP
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
}`,Rw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Pw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Iw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Dw=`#ifdef USE_ENVMAP
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
#endif`,Nw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Uw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ow=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Fw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,kw=`PhysicalMaterial material;
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
#endif`,Bw=`uniform sampler2D dfgLUT;
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
}`,zw=`
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
#endif`,Vw=`#if defined( RE_IndirectDiffuse )
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
#endif`,Hw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Gw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Ww=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Xw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$w=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Yw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Zw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Kw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Jw=`#if defined( USE_POINTS_UV )
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
#endif`,jw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Qw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,e1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,t1=`#if defined( USE_MORPHCOLORS )
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
#endif`,n1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,i1=`#ifdef USE_MORPHTARGETS
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
#endif`,s1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,r1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,o1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,a1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,l1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,c1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,h1=`#ifdef USE_NORMALMAP
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
#endif`,u1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,d1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,f1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,p1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,m1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,g1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,x1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,_1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,y1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,v1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,b1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,M1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,S1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,w1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,E1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,T1=`float getShadowMask() {
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
}`,A1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,C1=`#ifdef USE_SKINNING
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
#endif`,R1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,P1=`#ifdef USE_SKINNING
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
#endif`,L1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,I1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,D1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,N1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,U1=`#ifdef USE_TRANSMISSION
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
#endif`,O1=`#ifdef USE_TRANSMISSION
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
#endif`,F1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,k1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,B1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,z1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,V1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,H1=`uniform sampler2D t2D;
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
}`,G1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,W1=`uniform float backgroundBlurriness;
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
}`,X1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,q1=`#include <common>
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
}`,Y1=`#if DEPTH_PACKING == 3200
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
}`,Z1=`#define DISTANCE
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
}`,K1=`#define DISTANCE
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
}`,J1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,j1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Q1=`uniform float scale;
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
}`,eE=`uniform vec3 diffuse;
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
}`,tE=`#include <common>
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
}`,nE=`uniform vec3 diffuse;
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
}`,iE=`#define LAMBERT
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
}`,sE=`#define LAMBERT
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
}`,rE=`#define MATCAP
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
}`,oE=`#define MATCAP
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
}`,aE=`#define NORMAL
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
}`,lE=`#define NORMAL
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
}`,cE=`#define PHONG
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
}`,hE=`#define PHONG
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
}`,uE=`#define STANDARD
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
}`,dE=`#define STANDARD
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
}`,fE=`#define TOON
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
}`,pE=`#define TOON
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
}`,mE=`uniform float size;
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
}`,gE=`uniform vec3 diffuse;
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
}`,xE=`#include <common>
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
}`,_E=`uniform vec3 color;
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
}`,yE=`uniform float rotation;
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
}`,vE=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:HS,alphahash_pars_fragment:GS,alphamap_fragment:WS,alphamap_pars_fragment:XS,alphatest_fragment:$S,alphatest_pars_fragment:qS,aomap_fragment:YS,aomap_pars_fragment:ZS,batching_pars_vertex:KS,batching_vertex:JS,begin_vertex:jS,beginnormal_vertex:QS,bsdfs:ew,iridescence_fragment:tw,bumpmap_pars_fragment:nw,clipping_planes_fragment:iw,clipping_planes_pars_fragment:sw,clipping_planes_pars_vertex:rw,clipping_planes_vertex:ow,color_fragment:aw,color_pars_fragment:lw,color_pars_vertex:cw,color_vertex:hw,common:uw,defaultnormal_vertex:dw,displacementmap_pars_vertex:fw,displacementmap_vertex:pw,emissivemap_fragment:mw,emissivemap_pars_fragment:gw,colorspace_fragment:xw,colorspace_pars_fragment:_w,envmap_fragment:yw,envmap_common_pars_fragment:vw,envmap_pars_fragment:bw,envmap_pars_vertex:Mw,envmap_physical_pars_fragment:Dw,envmap_vertex:Sw,fog_vertex:ww,fog_pars_vertex:Ew,fog_fragment:Tw,fog_pars_fragment:Aw,gradientmap_pars_fragment:Cw,lightmap_pars_fragment:Rw,lights_lambert_fragment:Pw,lights_lambert_pars_fragment:Lw,lights_pars_begin:Iw,lights_toon_fragment:Nw,lights_toon_pars_fragment:Uw,lights_phong_fragment:Ow,lights_phong_pars_fragment:Fw,lights_physical_fragment:kw,lights_physical_pars_fragment:Bw,lights_fragment_begin:zw,lights_fragment_maps:Vw,lights_fragment_end:Hw,lightprobes_pars_fragment:Gw,logdepthbuf_fragment:Ww,logdepthbuf_pars_fragment:Xw,logdepthbuf_pars_vertex:$w,logdepthbuf_vertex:qw,map_fragment:Yw,map_pars_fragment:Zw,map_particle_fragment:Kw,map_particle_pars_fragment:Jw,metalnessmap_fragment:jw,metalnessmap_pars_fragment:Qw,morphinstance_vertex:e1,morphcolor_vertex:t1,morphnormal_vertex:n1,morphtarget_pars_vertex:i1,morphtarget_vertex:s1,normal_fragment_begin:r1,normal_fragment_maps:o1,normal_pars_fragment:a1,normal_pars_vertex:l1,normal_vertex:c1,normalmap_pars_fragment:h1,clearcoat_normal_fragment_begin:u1,clearcoat_normal_fragment_maps:d1,clearcoat_pars_fragment:f1,iridescence_pars_fragment:p1,opaque_fragment:m1,packing:g1,premultiplied_alpha_fragment:x1,project_vertex:_1,dithering_fragment:y1,dithering_pars_fragment:v1,roughnessmap_fragment:b1,roughnessmap_pars_fragment:M1,shadowmap_pars_fragment:S1,shadowmap_pars_vertex:w1,shadowmap_vertex:E1,shadowmask_pars_fragment:T1,skinbase_vertex:A1,skinning_pars_vertex:C1,skinning_vertex:R1,skinnormal_vertex:P1,specularmap_fragment:L1,specularmap_pars_fragment:I1,tonemapping_fragment:D1,tonemapping_pars_fragment:N1,transmission_fragment:U1,transmission_pars_fragment:O1,uv_pars_fragment:F1,uv_pars_vertex:k1,uv_vertex:B1,worldpos_vertex:z1,background_vert:V1,background_frag:H1,backgroundCube_vert:G1,backgroundCube_frag:W1,cube_vert:X1,cube_frag:$1,depth_vert:q1,depth_frag:Y1,distance_vert:Z1,distance_frag:K1,equirect_vert:J1,equirect_frag:j1,linedashed_vert:Q1,linedashed_frag:eE,meshbasic_vert:tE,meshbasic_frag:nE,meshlambert_vert:iE,meshlambert_frag:sE,meshmatcap_vert:rE,meshmatcap_frag:oE,meshnormal_vert:aE,meshnormal_frag:lE,meshphong_vert:cE,meshphong_frag:hE,meshphysical_vert:uE,meshphysical_frag:dE,meshtoon_vert:fE,meshtoon_frag:pE,points_vert:mE,points_frag:gE,shadow_vert:xE,shadow_frag:_E,sprite_vert:yE,sprite_frag:vE},Ne={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},ps={basic:{uniforms:Wn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:Wn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:Wn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:Wn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:Wn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:Wn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:Wn([Ne.points,Ne.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:Wn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:Wn([Ne.common,Ne.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:Wn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:Wn([Ne.sprite,Ne.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:Wn([Ne.common,Ne.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:Wn([Ne.lights,Ne.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};ps.physical={uniforms:Wn([ps.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var $h={r:0,b:0,g:0},bE=new Yt,Yx=new nt;Yx.set(-1,0,0,0,1,0,0,0,1);function ME(n,e,t,i,s,r){let o=new ct(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(b){let C=b.isScene===!0?b.background:null;if(C&&C.isTexture){let S=b.backgroundBlurriness>0;C=e.get(C,S)}return C}function g(b){let C=!1,S=f(b);S===null?p(o,a):S&&S.isColor&&(p(S,1),C=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(b,C){let S=f(C);S&&S.isCubeTexture?(c===void 0&&(c=new oi(new Fo(1,1,1),new us({name:"BackgroundCubeMaterial",uniforms:kr(ps.backgroundCube.uniforms),vertexShader:ps.backgroundCube.vertexShader,fragmentShader:ps.backgroundCube.fragmentShader,side:ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(bE.makeRotationFromEuler(C.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yx),c.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,(h!==S||u!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new oi(new Dr(2,2),new us({name:"BackgroundMaterial",uniforms:kr(ps.background.uniforms),vertexShader:ps.background.vertexShader,fragmentShader:ps.background.fragmentShader,side:ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=Mt.getTransfer(S.colorSpace)!==It,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function p(b,C){b.getRGB($h,kf(n)),t.buffers.color.setClear($h.r,$h.g,$h.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,C=1){o.set(b),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,p(o,a)},render:g,addToRenderList:x,dispose:m}}function SE(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,H,G,N,W){let K=!1,V=u(D,N,G,H);r!==V&&(r=V,c(r.object)),K=f(D,N,G,W),K&&g(D,N,G,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,S(D,H,G,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function u(D,H,G,N){let W=N.wireframe===!0,K=i[H.id];K===void 0&&(K={},i[H.id]=K);let V=D.isInstancedMesh===!0?D.id:0,he=K[V];he===void 0&&(he={},K[V]=he);let J=he[G.id];J===void 0&&(J={},he[G.id]=J);let Q=J[W];return Q===void 0&&(Q=d(l()),J[W]=Q),Q}function d(D){let H=[],G=[],N=[];for(let W=0;W<t;W++)H[W]=0,G[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:G,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,H,G,N){let W=r.attributes,K=H.attributes,V=0,he=G.getAttributes();for(let J in he)if(he[J].location>=0){let se=W[J],pe=K[J];if(pe===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(pe=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(pe=D.instanceColor)),se===void 0||se.attribute!==pe||pe&&se.data!==pe.data)return!0;V++}return r.attributesNum!==V||r.index!==N}function g(D,H,G,N){let W={},K=H.attributes,V=0,he=G.getAttributes();for(let J in he)if(he[J].location>=0){let se=K[J];se===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(se=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(se=D.instanceColor));let pe={};pe.attribute=se,se&&se.data&&(pe.data=se.data),W[J]=pe,V++}r.attributes=W,r.attributesNum=V,r.index=N}function x(){let D=r.newAttributes;for(let H=0,G=D.length;H<G;H++)D[H]=0}function p(D){m(D,0)}function m(D,H){let G=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;G[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==H&&(n.vertexAttribDivisor(D,H),W[D]=H)}function b(){let D=r.newAttributes,H=r.enabledAttributes;for(let G=0,N=H.length;G<N;G++)H[G]!==D[G]&&(n.disableVertexAttribArray(G),H[G]=0)}function C(D,H,G,N,W,K,V){V===!0?n.vertexAttribIPointer(D,H,G,W,K):n.vertexAttribPointer(D,H,G,N,W,K)}function S(D,H,G,N){x();let W=N.attributes,K=G.getAttributes(),V=H.defaultAttributeValues;for(let he in K){let J=K[he];if(J.location>=0){let Q=W[he];if(Q===void 0&&(he==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),he==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let se=Q.normalized,pe=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,xe=fe.type,ve=fe.bytesPerElement,Re=xe===n.INT||xe===n.UNSIGNED_INT||Q.gpuType===ch;if(Q.isInterleavedBufferAttribute){let we=Q.data,Xe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,rt=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Ge=0;Ge<J.locationSize;Ge++)m(J.location+Ge,we.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Ge=0;Ge<J.locationSize;Ge++)p(J.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ge=0;Ge<J.locationSize;Ge++)C(J.location+Ge,pe/J.locationSize,xe,se,Xe*ve,(rt+pe/J.locationSize*Ge)*ve,Re)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<J.locationSize;we++)m(J.location+we,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<J.locationSize;we++)p(J.location+we);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let we=0;we<J.locationSize;we++)C(J.location+we,pe/J.locationSize,xe,se,pe*ve,pe/J.locationSize*we*ve,Re)}}else if(V!==void 0){let se=V[he];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(J.location,se);break;case 3:n.vertexAttrib3fv(J.location,se);break;case 4:n.vertexAttrib4fv(J.location,se);break;default:n.vertexAttrib1fv(J.location,se)}}}}b()}function R(){B();for(let D in i){let H=i[D];for(let G in H){let N=H[G];for(let W in N){let K=N[W];for(let V in K)h(K[V].object),delete K[V];delete N[W]}}delete i[D]}}function A(D){if(i[D.id]===void 0)return;let H=i[D.id];for(let G in H){let N=H[G];for(let W in N){let K=N[W];for(let V in K)h(K[V].object),delete K[V];delete N[W]}}delete i[D.id]}function y(D){for(let H in i){let G=i[H];for(let N in G){let W=G[N];if(W[D.id]===void 0)continue;let K=W[D.id];for(let V in K)h(K[V].object),delete K[V];delete W[D.id]}}}function E(D){for(let H in i){let G=i[H],N=D.isInstancedMesh===!0?D.id:0,W=G[N];if(W!==void 0){for(let K in W){let V=W[K];for(let he in V)h(V[he].object),delete V[he];delete W[K]}delete G[N],Object.keys(G).length===0&&delete i[H]}}}function B(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:p,disableUnusedAttributes:b}}function wE(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function EE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==wi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===Zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==li&&y!==Yi&&!E&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:b,maxVaryings:C,maxFragmentUniforms:S,maxSamples:R,samples:A}}function TE(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ei,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,x=u.clipIntersection,p=u.clipShadows,m=n.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let b=r?0:i,C=b*4,S=m.clippingState||null;l.value=S,S=h(g,d,C,f);for(let R=0;R!==C;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,d,f,g){let x=u!==null?u.length:0,p=null;if(x!==0){if(p=l.value,g!==!0||p===null){let m=f+x*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,S=f;C!==x;++C,S+=4)o.copy(u[C]).applyMatrix4(b,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,p}}var ll=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ha(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Fo(5,5,5),r=new us({name:"CubemapFromEquirect",uniforms:kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ii,blending:Nr});r.uniforms.tEquirect.value=t;let o=new oi(s,r),a=t.minFilter;return t.minFilter===Us&&(t.minFilter=ni),new Bo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Tx=256,AE=3,CE=20,Zx=256,Kx=16,RE=3,PE=new q,LE=new ct,Yh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Bo(1,10,null),this._boxMesh=new oi(new Fo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=PE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(LE));let p=new Bo(i,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=x,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Rx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Tx,Uf(e))}_fromTexture(e,t){e.mapping===Or||e.mapping===Go?this._setSize(e.image.length===0?Tx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Ax(e,!1,!1),i=Math.log2(e)-AE;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ax(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Or||e.mapping===Go?(this._cubemapMaterial===null&&(this._cubemapMaterial=Rx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=IE(),this._integrationMaterial=DE());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Kx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-RE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Zx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=NE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Ax(n,e,t){return new ll(n,{minFilter:Us,generateMipmaps:e,type:Zi,colorSpace:Da,depthBuffer:t})}function cl(n,e,t){return new us({name:n,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:ii,blending:Nr,depthTest:!1,depthWrite:!1})}function IE(){return cl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zx}u

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
	`)}function DE(){return cl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Kx}},`

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
	`)}function NE(){return cl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${CE}
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
	`)}function Cx(){return cl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Rx(){return cl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function UE(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===oh||f===ah)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let x=new ll(g.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===oh||f===ah,x=f===Or||f===Go;if(g||x){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Yh(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let b=d.image;return g&&b&&b.height>0||x&&b&&l(b)?(i===null&&(i=new Yh(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===oh?d.mapping=Or:f===ah&&(d.mapping=Go),d}function l(d){let f=0,g=6;for(let x=0;x<g;x++)d[x]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function OE(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Ra("WebGLRenderer: "+i+" extension not supported."),s}}}function FE(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(e.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function h(g){let x=g.attributes;for(let p in x)e.update(x[p],n.ARRAY_BUFFER)}function u(g){let x=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let b=x!==null?x.array.length:p.array.length/3-1,C=p.count>=65535?za:Ba,S=new C(Math.ceil(b/3)*6,1),R=S.array;if(x!==null){let y=x.array;m=x.version;for(let E=0,B=0;E<b;E+=3){let U=y[E+0],D=y[E+1],H=y[E+2];R[B++]=U,R[B++]=D,R[B++]=D,R[B++]=H,R[B++]=H,R[B++]=U}}else{m=p.version;for(let y=0,E=0;y<b;y+=3){let B=y+0,U=y+1,D=y+2;R[E++]=B,R[E++]=U,R[E++]=U,R[E++]=D,R[E++]=D,R[E++]=B}}S.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,S)}function d(g){let x=r.get(g);if(x){let p=g.index;p!==null&&x.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function kE(n,e,t){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),t.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),t.update(d,i,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let x=0;for(let p=0;p<f;p++)x+=d[p];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function BE(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function zE(n,e,t){let i=new WeakMap,s=new Jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let B=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),x===!0&&(C=3);let S=a.attributes.position.count*C,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*u),y=new Oa(A,S,R,u);y.type=Yi,y.needsUpdate=!0;let E=C*4;for(let U=0;U<u;U++){let D=p[U],H=m[U],G=b[U],N=S*R*4*U;for(let W=0;W<D.count;W++){let K=W*E;f===!0&&(s.fromBufferAttribute(D,W),A[N+K+0]=s.x,A[N+K+1]=s.y,A[N+K+2]=s.z,A[N+K+3]=0),g===!0&&(s.fromBufferAttribute(H,W),A[N+K+4]=s.x,A[N+K+5]=s.y,A[N+K+6]=s.z,A[N+K+7]=0),x===!0&&(s.fromBufferAttribute(G,W),A[N+K+8]=s.x,A[N+K+9]=s.y,A[N+K+10]=s.z,A[N+K+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new tt(S,R)},i.set(a,d),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function VE(n,e,t,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var HE={[pf]:"LINEAR_TONE_MAPPING",[mf]:"REINHARD_TONE_MAPPING",[gf]:"CINEON_TONE_MAPPING",[xf]:"ACES_FILMIC_TONE_MAPPING",[yf]:"AGX_TONE_MAPPING",[vf]:"NEUTRAL_TONE_MAPPING",[_f]:"CUSTOM_TONE_MAPPING"};function GE(n,e,t,i,s,r){let o=new bi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Mi;h.setAttribute("position",new yi([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new yi([0,2,0,0,2,0],2));let u=new Wc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new oi(h,u),f=new Ya(-1,1,1,-1,0,1),g=null,x=null,p=!1,m,b=null,C=[],S=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let y=0;y<C.length;y++){let E=C[y];E.setSize&&E.setSize(R,A)}},this.setEffects=function(R){C=R,S=C.length>0&&C[0].isRenderPass===!0;let A=o.width,y=o.height;C.length>0&&a===null&&(a=new bi(A,y,{type:Zi,depthBuffer:!1,stencilBuffer:!1}),l=new bi(A,y,{type:Zi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(B=>B.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ns(A,y),r===!0&&(c.format=Os,c.type=Fr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let B=0;B<C.length;B++){let U=C[B];U.setSize&&U.setSize(A,y),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,A){if(p||R.toneMapping===ds&&C.length===0)return!1;if(b=A,A!==null){let y=A.width,E=A.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=ds,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=m,p=!0;let y=o,E=a;for(let B=0;B<C.length;B++){let U=C[B];U.enabled!==!1&&(U.render(R,E,y,A),U.needsSwap!==!1&&(y=E,E=E===a?l:a))}if(g!==R.outputColorSpace||x!==R.toneMapping){g=R.outputColorSpace,x=R.toneMapping,u.defines={},Mt.getTransfer(g)===It&&(u.defines.SRGB_TRANSFER="");let B=HE[x];B&&(u.defines[B]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(b),R.render(d,f),b=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Jx=new ri,jx=new Ns(1,1),Qx=new Ga(1),e_=new Oa,t_=new Bc,n_=new Ha,Px=[],Lx=[],Ix=new Float32Array(16),Dx=new Float32Array(9),Nx=new Float32Array(4);function qo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Px[s];if(r===void 0&&(r=new Float32Array(s),Px[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function wn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Kh(n,e){let t=Lx[e];t===void 0&&(t=new Int32Array(e),Lx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function WE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function XE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function $E(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function qE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function YE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Nx.set(i),n.uniformMatrix2fv(this.addr,!1,Nx),En(t,i)}}function ZE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Dx.set(i),n.uniformMatrix3fv(this.addr,!1,Dx),En(t,i)}}function KE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;Ix.set(i),n.uniformMatrix4fv(this.addr,!1,Ix),En(t,i)}}function JE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function jE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function QE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function eT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function tT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function nT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function iT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function sT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function Jh(n){return n.version===0&&(n.compareFunction=Lf,n.needsUpdate=!0),n}function rT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Jh(jx):r=Jx,t.setTexture2D(e||r,s)}function oT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||t_,s)}function aT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Jh(Qx):r=n_,t.setTextureCube(e||r,s)}function lT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||e_,s)}function cT(n){switch(n){case 5126:return WE;case 35664:return XE;case 35665:return $E;case 35666:return qE;case 35674:return YE;case 35675:return ZE;case 35676:return KE;case 5124:case 35670:return JE;case 35667:case 35671:return jE;case 35668:case 35672:return QE;case 35669:case 35673:return eT;case 5125:return tT;case 36294:return nT;case 36295:return iT;case 36296:return sT;case 35678:case 36198:case 36298:case 36306:case 35682:return rT;case 35679:case 36299:case 36307:return oT;case 35680:case 36300:case 36308:case 36293:return aT;case 36289:case 36303:case 36311:case 36292:return lT}}function hT(n,e){n.uniform1fv(this.addr,e)}function uT(n,e){let t=qo(e,this.size,2);n.uniform2fv(this.addr,t)}function dT(n,e){let t=qo(e,this.size,3);n.uniform3fv(this.addr,t)}function fT(n,e){let t=qo(e,this.size,4);n.uniform4fv(this.addr,t)}function pT(n,e){let t=qo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function mT(n,e){let t=qo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function gT(n,e){let t=qo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function xT(n,e){n.uniform1iv(this.addr,e)}function _T(n,e){n.uniform2iv(this.addr,e)}function yT(n,e){n.uniform3iv(this.addr,e)}function vT(n,e){n.uniform4iv(this.addr,e)}function bT(n,e){n.uniform1uiv(this.addr,e)}function MT(n,e){n.uniform2uiv(this.addr,e)}function ST(n,e){n.uniform3uiv(this.addr,e)}function wT(n,e){n.uniform4uiv(this.addr,e)}function ET(n,e,t){let i=this.cache,s=e.length,r=Kh(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Jh(jx):o=Jx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function TT(n,e,t){let i=this.cache,s=e.length,r=Kh(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||t_,r[o])}function AT(n,e,t){let i=this.cache,s=e.length,r=Kh(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Jh(Qx):o=n_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function CT(n,e,t){let i=this.cache,s=e.length,r=Kh(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||e_,r[o])}function RT(n){switch(n){case 5126:return hT;case 35664:return uT;case 35665:return dT;case 35666:return fT;case 35674:return pT;case 35675:return mT;case 35676:return gT;case 5124:case 35670:return xT;case 35667:case 35671:return _T;case 35668:case 35672:return yT;case 35669:case 35673:return vT;case 5125:return bT;case 36294:return MT;case 36295:return ST;case 36296:return wT;case 35678:case 36198:case 36298:case 36306:case 35682:return ET;case 35679:case 36299:case 36307:return TT;case 35680:case 36300:case 36308:case 36293:return AT;case 36289:case 36303:case 36311:case 36292:return CT}}var Wf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=cT(t.type)}},Xf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=RT(t.type)}},$f=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Hf=/(\w+)(\])?(\[|\.)?/g;function Ux(n,e){n.seq.push(e),n.map[e.id]=e}function PT(n,e,t){let i=n.name,s=i.length;for(Hf.lastIndex=0;;){let r=Hf.exec(i),o=Hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ux(t,c===void 0?new Wf(a,n,e):new Xf(a,n,e));break}else{let u=t.map[a];u===void 0&&(u=new $f(a),Ux(t,u)),t=u}}}var $o=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);PT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Ox(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var LT=37297,IT=0;function DT(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Fx=new nt;function NT(n){Mt._getMatrix(Fx,Mt.workingColorSpace,n);let e=`mat3( ${Fx.elements.map(t=>t.toFixed(4))} )`;switch(Mt.getTransfer(n)){case Na:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function kx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+DT(n.getShaderSource(e),a)}else return r}function UT(n,e){let t=NT(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var OT={[pf]:"Linear",[mf]:"Reinhard",[gf]:"Cineon",[xf]:"ACESFilmic",[yf]:"AgX",[vf]:"Neutral",[_f]:"Custom"};function FT(n,e){let t=OT[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var qh=new q;function kT(){Mt.getLuminanceCoefficients(qh);let n=qh.x.toFixed(4),e=qh.y.toFixed(4),t=qh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function BT(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(al).join(`
`)}function zT(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function VT(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function al(n){return n!==""}function Bx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function zx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var HT=/^[ \t]*#include +<([\w\d./]+)>/gm;function qf(n){return n.replace(HT,GT)}function GT(n,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return qf(t)}var WT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vx(n){return n.replace(WT,XT)}function XT(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Hx(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var $T={[ja]:"SHADOWMAP_TYPE_PCF",[Vo]:"SHADOWMAP_TYPE_VSM"};function qT(n){return $T[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var YT={[Go]:"ENVMAP_MODE_REFRACTION"};function ZT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":YT[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var KT={[rh]:"ENVMAP_BLENDING_MULTIPLY",[sx]:"ENVMAP_BLENDING_MIX",[rx]:"ENVMAP_BLENDING_ADD"};function JT(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":KT[n.combine]||"ENVMAP_BLENDING_NONE"}function jT(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=qT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=ZT(t),u=JT(t),d=BT(t),f=zT(r),g=s.createProgram(),x,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(al).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(al).join(`
`),p.length>0&&(p+=`
`)):(x=[Hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(al).join(`
`),p=[Hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ds?"#define TONE_MAPPING":"",t.toneMapping!==ds?dt.tonemapping_pars_fragment:"",t.toneMapping!==ds?FT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,UT("linearToOutputTexel",t.outputColorSpace),kT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(al).join(`
`)),o=qf(o),o=Bx(o,t),o=zx(o,t),a=qf(a),a=Bx(a,t),a=zx(a,t),o=Vx(o),a=Vx(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",t.glslVersion===If?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===If?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let b=m+x+o,C=m+p+a,S=Ox(s,s.VERTEX_SHADER,b),R=Ox(s,s.FRAGMENT_SHADER,C);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(U){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",H=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(R)||"",N=D.trim(),W=H.trim(),K=G.trim(),V=!0,he=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,R);else{let J=kx(s,S,"vertex"),Q=kx(s,R,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+N+`
`+J+`
`+Q)}else N!==""?Ze("WebGLProgram: Program Info Log:",N):(W===""||K==="")&&(he=!1);he&&(U.diagnostics={runnable:V,programLog:N,vertexShader:{log:W,prefix:x},fragmentShader:{log:K,prefix:p}})}s.deleteShader(S),s.deleteShader(R),y=new $o(s,g),E=VT(s,g)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,LT)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=IT++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var QT=0,Yf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Zf(e),t.set(e,i)),i}},Zf=class{constructor(e){this.id=QT++,this.code=e,this.usedTimes=0}};function eA(n){return n===dr||n===sl||n===rl}function tA(n,e,t,i,s,r){let o=new Fa,a=new Yf,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,E,B,U,D,H){let G=U.fog,N=D.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,K=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,V=e.get(y.envMap||W,K),he=d[y.type],J=i.precision;y.precision!==null&&(J=i.getMaxPrecision(y.precision),J!==y.precision&&Ze("WebGLProgram.getParameters:",y.precision,"not supported, using",J,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,se=Q!==void 0?Q.length:0,pe=0;N.morphAttributes.position!==void 0&&(pe=1),N.morphAttributes.normal!==void 0&&(pe=2),N.morphAttributes.color!==void 0&&(pe=3);let fe,ee,xe,ve;if(he){let Pe=ps[he];fe=Pe.vertexShader,ee=Pe.fragmentShader}else{fe=y.vertexShader,ee=y.fragmentShader;let Pe=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Pe,lt),xe=Pe.id,ve=lt.id}let Re=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),Xe=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Ge=!!y.map,ft=!!y.matcap,ht=!!V,it=ht&&V.isPMREMTexture===!0,Zt=!!y.aoMap,Vt=!!y.lightMap,hn=!!y.bumpMap&&y.wireframe===!1,Ot=!!y.normalMap,An=!!y.displacementMap,St=!!y.emissiveMap,vn=!!y.metalnessMap,tn=!!y.roughnessMap,un=y.anisotropy>0,F=y.clearcoat>0,Le=y.diffuseRoughness>0,Ye=y.dispersion>0,ot=y.retroreflectivity>0,Ee=y.iridescence>0,kt=y.sheen>0,He=y.transmission>0,qe=un&&!!y.anisotropyMap,P=F&&!!y.clearcoatMap,M=F&&!!y.clearcoatNormalMap,X=F&&!!y.clearcoatRoughnessMap,ue=Le&&!!y.diffuseRoughnessMap,oe=Ee&&!!y.iridescenceMap,ye=Ee&&!!y.iridescenceThicknessMap,be=kt&&!!y.sheenColorMap,te=kt&&!!y.sheenRoughnessMap,ie=!!y.specularMap,ge=!!y.specularColorMap,O=!!y.specularIntensityMap,re=He&&!!y.transmissionMap,ne=He&&!!y.thicknessMap,Te=!!y.gradientMap,_e=!!y.alphaMap,Se=y.alphaTest>0,We=!!y.alphaHash,Je=!!y.extensions,ce=ds;y.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,je={shaderID:he,shaderType:y.type,shaderName:y.name,vertexShader:fe,fragmentShader:ee,defines:y.defines,customVertexShaderID:xe,customFragmentShaderID:ve,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:J,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&D.instanceColor!==null,instancingMorph:Xe&&D.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:Mt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ge,matcap:ft,envMap:ht,envMapMode:ht&&V.mapping,envMapPMREM:it,envMapMaxLod:it?Be.length-1:null,envMapSize:it?Be[0].width:null,aoMap:Zt,lightMap:Vt,bumpMap:hn,normalMap:Ot,displacementMap:An,emissiveMap:St,normalMapObjectSpace:Ot&&y.normalMapType===lx,normalMapTangentSpace:Ot&&y.normalMapType===Xh,packedNormalMap:Ot&&y.normalMapType===Xh&&eA(y.normalMap.format),metalnessMap:vn,roughnessMap:tn,anisotropy:un,anisotropyMap:qe,clearcoat:F,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Le,diffuseRoughnessMap:ue,dispersion:Ye,retroreflection:ot,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:kt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:ie,specularColorMap:ge,specularIntensityMap:O,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:y.transparent===!1&&y.blending===Ho&&y.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:We,combine:y.combine,mapUv:Ge&&f(y.map.channel),aoMapUv:Zt&&f(y.aoMap.channel),lightMapUv:Vt&&f(y.lightMap.channel),bumpMapUv:hn&&f(y.bumpMap.channel),normalMapUv:Ot&&f(y.normalMap.channel),displacementMapUv:An&&f(y.displacementMap.channel),emissiveMapUv:St&&f(y.emissiveMap.channel),metalnessMapUv:vn&&f(y.metalnessMap.channel),roughnessMapUv:tn&&f(y.roughnessMap.channel),anisotropyMapUv:qe&&f(y.anisotropyMap.channel),clearcoatMapUv:P&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:be&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(y.sheenRoughnessMap.channel),specularMapUv:ie&&f(y.specularMap.channel),specularColorMapUv:ge&&f(y.specularColorMap.channel),specularIntensityMapUv:O&&f(y.specularIntensityMap.channel),transmissionMapUv:re&&f(y.transmissionMap.channel),thicknessMapUv:ne&&f(y.thicknessMap.channel),alphaMapUv:_e&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ot||un),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Ge||_e),fog:!!G,useFog:y.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Ot===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:pe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:H.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ge&&y.map.isVideoTexture===!0&&Mt.getTransfer(y.map.colorSpace)===It,decodeVideoTextureEmissive:St&&y.emissiveMap.isVideoTexture===!0&&Mt.getTransfer(y.emissiveMap.colorSpace)===It,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ai,flipSided:y.side===ii,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Je&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&y.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let B in y.defines)E.push(B),E.push(y.defines[B]);return y.isRawShaderMaterial===!1&&(p(E,y),m(E,y),E.push(n.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function p(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function m(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function b(y){let E=d[y.type],B;if(E){let U=ps[E];B=Sx.clone(U.uniforms)}else B=y.uniforms;return B}function C(y,E){let B=h.get(E);return B!==void 0?++B.usedTimes:(B=new jT(n,E,y,s),c.push(B),h.set(E,B)),B}function S(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:b,acquireProgram:C,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:A}}function nA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function iA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Gx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Wx(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,x,p,m){let b=n[e];return b===void 0?(b={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:p,group:m},n[e]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=g,b.materialVariant=o(d),b.groupOrder=x,b.renderOrder=d.renderOrder,b.z=p,b.group=m),e++,b}function l(d,f,g,x,p,m,b){b.reversedDepth===!0&&(p=-p);let C=a(d,f,g,x,p,m);g.transmission>0?i.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(d,f,g,x,p,m){let b=a(d,f,g,x,p,m);g.transmission>0?i.unshift(b):g.transparent===!0?s.unshift(b):t.unshift(b)}function h(d,f){t.length>1&&t.sort(d||iA),i.length>1&&i.sort(f||Gx),s.length>1&&s.sort(f||Gx)}function u(){for(let d=e,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function sA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Wx,n.set(i,[o])):s>=r.length?(o=new Wx,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function rA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new ct};break;case"SpotLight":t={position:new q,direction:new q,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new q,halfWidth:new q,halfHeight:new q};break}return n[e.id]=t,t}}}function oA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var aA=0;function lA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function cA(n){let e=new rA,t=oA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new q);let s=new q,r=new Yt,o=new Yt;function a(c){let h=0,u=0,d=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,g=0,x=0,p=0,m=0,b=0,C=0,S=0,R=0,A=0,y=0,E=0,B=0,U=0;c.sort(lA);for(let H=0,G=c.length;H<G;H++){let N=c[H],W=N.color,K=N.intensity,V=N.distance,he=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===dr?he=N.shadow.map.texture:he=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=W.r*K,u+=W.g*K,d+=W.b*K;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],K);U++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=se,i.sunShadowMap[g]=he;let pe=Q.getViewportCount();for(let fe=0;fe<pe;fe++)i.sunShadowMatrix[x+fe]=Q.getMatrix(fe),i.sunShadowCascade[x+fe]=Q._cascadeData[fe];x+=pe,g++}i.sun[f]=J,f++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[p]=se,i.directionalShadowMap[p]=he,i.directionalShadowMatrix[p]=N.shadow.matrix,R++}i.directional[p]=J,p++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(W).multiplyScalar(K),J.distance=V,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[b]=J;let Q=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&B++),i.spotLightMatrix[b]=Q.matrix,N.castShadow){let se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[b]=se,i.spotShadowMap[b]=he,y++}b++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(W).multiplyScalar(K),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[C]=J,C++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[m]=se,i.pointShadowMap[m]=he,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=J,m++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar(K),J.groundColor.copy(N.groundColor).multiplyScalar(K),i.hemi[S]=J,S++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==b||D.rectAreaLength!==C||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==A||D.numSpotShadows!==y||D.numSpotMaps!==E||D.numLightProbes!==U)&&(i.sun.length=f,i.directional.length=p,i.spot.length=b,i.rectArea.length=C,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+E-B,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=U,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=b,D.rectAreaLength=C,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=A,D.numSpotShadows=y,D.numSpotMaps=E,D.numLightProbes=U,i.version=aA++)}function l(c,h){let u=0,d=0,f=0,g=0,x=0,p=0,m=h.matrixWorldInverse;for(let b=0,C=c.length;b<C;b++){let S=c[b];if(S.isSunLight){let R=i.sun[u];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),u++}else if(S.isDirectionalLight){let R=i.directional[d];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(S.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let R=i.rectArea[x];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Xx(n){let e=new cA(n),t=[],i=[],s=[];function r(u){h.camera=u,t.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){i.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function hA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Xx(n),e.set(s,[a])):r>=o.length?(a=new Xx(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var uA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,dA=`uniform sampler2D shadow_pass;
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
}`,fA=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],pA=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],$x=new Yt,ol=new q,Gf=new q;function mA(n,e,t){let i=new rr,s=new tt,r=new tt,o=new Jt,a=new Xc,l=new $c,c={},h=t.maxTextureSize,u={[ur]:ii,[ii]:ur,[ai]:ai},d=new us({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:uA,fragmentShader:dA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Mi;g.setAttribute("position",new Hn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new oi(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ja;let m=this.type;this.render=function(A,y,E){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||A.length===0)return;this.type===B0&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ja);let B=n.getRenderTarget(),U=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),H=n.state;H.setBlending(Nr),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let G=m!==this.type;G&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=A.length;N<W;N++){let K=A[N],V=K.shadow;if(V===void 0){Ze("WebGLShadowMap:",K,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let he=V.getFrameExtents();s.multiply(he),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,V.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Vo){if(K.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new bi(s.x,s.y,{format:dr,type:Zi,minFilter:ni,magFilter:ni,generateMipmaps:!1}),V.map.texture.name=K.name+".shadowMap",V.map.depthTexture=new Ns(s.x,s.y,Yi),V.map.depthTexture.name=K.name+".shadowMapDepth",V.map.depthTexture.format=Ls,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=yn,V.map.depthTexture.magFilter=yn}else K.isPointLight?(V.map=new ll(s.x),V.map.depthTexture=new Ga(s.x,qi)):(V.map=new bi(s.x,s.y),V.map.depthTexture=new Ns(s.x,s.y,qi)),V.map.depthTexture.name=K.name+".shadowMap",V.map.depthTexture.format=Ls,this.type===ja?(V.map.depthTexture.compareFunction=J?Pf:Rf,V.map.depthTexture.minFilter=ni,V.map.depthTexture.magFilter=ni):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=yn,V.map.depthTexture.magFilter=yn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();K.isPointLight!==!0&&V.updateMatrices(K,E);let se=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let pe=0;pe<Q;pe++){let fe=V.getCamera(pe);if(K.isPointLight){let ee=V.camera,xe=V.matrix,ve=K.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),ol.setFromMatrixPosition(K.matrixWorld),ee.position.copy(ol),Gf.copy(ee.position),Gf.add(fA[pe]),ee.up.copy(pA[pe]),ee.lookAt(Gf),ee.updateMatrixWorld(),xe.makeTranslation(-ol.x,-ol.y,-ol.z),$x.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix($x,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(pe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),H.viewport(o)}i=V.getFrustum(pe),S(y,E,fe,K,se,this.type)}V.isPointLightShadow!==!0&&this.type===Vo&&b(V,E),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(B,U,D)};function b(A,y){let E=e.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new bi(s.x,s.y,{format:dr,type:Zi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,E,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,E,f,x,null)}function C(A,y,E,B){let U=null,D=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(D!==void 0)U=D;else if(U=E.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let H=U.uuid,G=y.uuid,N=c[H];N===void 0&&(N={},c[H]=N);let W=N[G];W===void 0&&(W=U.clone(),N[G]=W,y.addEventListener("dispose",R)),U=W}if(U.visible=y.visible,U.wireframe=y.wireframe,B===Vo?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:u[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let H=n.properties.get(U);H.light=E}return U}function S(A,y,E,B,U,D){if(A.visible===!1)return;if(A.layers.test(U)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&D===Vo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let N=e.update(A),W=A.material;if(Array.isArray(W)){let K=N.groups;for(let V=0,he=K.length;V<he;V++){let J=K[V],Q=W[J.materialIndex];if(Q&&Q.visible){let se=C(A,Q,B,D);A.onBeforeShadow(n,A,y,E,N,se,J),n.renderBufferDirect(E,null,N,se,A,J),A.onAfterShadow(n,A,y,E,N,se,J)}}}else if(W.visible){let K=C(A,W,B,D);A.onBeforeShadow(n,A,y,E,N,K,null),n.renderBufferDirect(E,null,N,K,A,null),A.onAfterShadow(n,A,y,E,N,K,null)}}let G=A.children;for(let N=0,W=G.length;N<W;N++)S(G[N],y,E,B,U,D)}function R(A){A.target.removeEventListener("dispose",R);for(let E in c){let B=c[E],U=A.target.uuid;U in B&&(B[U].dispose(),delete B[U])}}}function gA(n,e){function t(){let O=!1,re=new Jt,ne=null,Te=new Jt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!O&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){O=_e},setClear:function(_e,Se,We,Je,ce){ce===!0&&(_e*=Je,Se*=Je,We*=Je),re.set(_e,Se,We,Je),Te.equals(re)===!1&&(n.clearColor(_e,Se,We,Je),Te.copy(re))},reset:function(){O=!1,ne=null,Te.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ne=null,Te=null,_e=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Je=_e;_e=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(Se){Se?we(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=yx[Se]),Te!==Se){switch(Se){case Ac:n.depthFunc(n.NEVER);break;case Cc:n.depthFunc(n.ALWAYS);break;case Rc:n.depthFunc(n.LESS);break;case Ro:n.depthFunc(n.LEQUAL);break;case Pc:n.depthFunc(n.EQUAL);break;case Lc:n.depthFunc(n.GEQUAL);break;case Ic:n.depthFunc(n.GREATER);break;case Dc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ne=null,Te=null,_e=null,re=!1}}}function s(){let O=!1,re=null,ne=null,Te=null,_e=null,Se=null,We=null,Je=null,ce=null;return{setTest:function(Be){O||(Be?we(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!O&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,je,Pe){(ne!==Be||Te!==je||_e!==Pe)&&(n.stencilFunc(Be,je,Pe),ne=Be,Te=je,_e=Pe)},setOp:function(Be,je,Pe){(Se!==Be||We!==je||Je!==Pe)&&(n.stencilOp(Be,je,Pe),Se=Be,We=je,Je=Pe)},setLocked:function(Be){O=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){O=!1,re=null,ne=null,Te=null,_e=null,Se=null,We=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],x=null,p=!1,m=null,b=null,C=null,S=null,R=null,A=null,y=null,E=new ct(0,0,0),B=0,U=!1,D=null,H=null,G=null,N=null,W=null,K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,he=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=he>=1):J.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=he>=2);let Q=null,se={},pe=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new Jt().fromArray(pe),xe=new Jt().fromArray(fe);function ve(O,re,ne,Te){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ne;We++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(re+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Re={};Re[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(Ro),hn(!1),Ot(lf),we(n.CULL_FACE),Zt(Nr);function we(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function Xe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function rt(O,re){return d[O]!==re?(n.bindFramebuffer(O,re),d[O]=re,O===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ge(O,re){let ne=g,Te=!1;if(O){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let _e=O.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=_e.length;Se<We;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Te=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ne)}function ft(O){return x!==O?(n.useProgram(O),x=O,!0):!1}let ht={[Ur]:n.FUNC_ADD,[V0]:n.FUNC_SUBTRACT,[H0]:n.FUNC_REVERSE_SUBTRACT};ht[G0]=n.MIN,ht[W0]=n.MAX;let it={[X0]:n.ZERO,[$0]:n.ONE,[q0]:n.SRC_COLOR,[df]:n.SRC_ALPHA,[Q0]:n.SRC_ALPHA_SATURATE,[J0]:n.DST_COLOR,[Z0]:n.DST_ALPHA,[Y0]:n.ONE_MINUS_SRC_COLOR,[ff]:n.ONE_MINUS_SRC_ALPHA,[j0]:n.ONE_MINUS_DST_COLOR,[K0]:n.ONE_MINUS_DST_ALPHA,[ex]:n.CONSTANT_COLOR,[tx]:n.ONE_MINUS_CONSTANT_COLOR,[nx]:n.CONSTANT_ALPHA,[ix]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,re,ne,Te,_e,Se,We,Je,ce,Be){if(O===Nr){p===!0&&(Xe(n.BLEND),p=!1);return}if(p===!1&&(we(n.BLEND),p=!0),O!==z0){if(O!==m||Be!==U){if((b!==Ur||R!==Ur)&&(n.blendEquation(n.FUNC_ADD),b=Ur,R=Ur),Be)switch(O){case Ho:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cf:n.blendFunc(n.ONE,n.ONE);break;case hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case uf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",O);break}else switch(O){case Ho:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hf:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case uf:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",O);break}C=null,S=null,A=null,y=null,E.set(0,0,0),B=0,m=O,U=Be}return}_e=_e||re,Se=Se||ne,We=We||Te,(re!==b||_e!==R)&&(n.blendEquationSeparate(ht[re],ht[_e]),b=re,R=_e),(ne!==C||Te!==S||Se!==A||We!==y)&&(n.blendFuncSeparate(it[ne],it[Te],it[Se],it[We]),C=ne,S=Te,A=Se,y=We),(Je.equals(E)===!1||ce!==B)&&(n.blendColor(Je.r,Je.g,Je.b,ce),E.copy(Je),B=ce),m=O,U=!1}function Vt(O,re){O.side===ai?Xe(n.CULL_FACE):we(n.CULL_FACE);let ne=O.side===ii;re&&(ne=!ne),hn(ne),O.blending===Ho&&O.transparent===!1?Zt(Nr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),St(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function hn(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function Ot(O){O!==F0?(we(n.CULL_FACE),O!==H&&(O===lf?n.cullFace(n.BACK):O===k0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),H=O}function An(O){O!==G&&(V&&n.lineWidth(O),G=O)}function St(O,re,ne){O?(we(n.POLYGON_OFFSET_FILL),(N!==re||W!==ne)&&(N=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):Xe(n.POLYGON_OFFSET_FILL)}function vn(O){O?we(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function tn(O){O===void 0&&(O=n.TEXTURE0+K-1),Q!==O&&(n.activeTexture(O),Q=O)}function un(O,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+K-1:ne=Q);let Te=se[ne];Te===void 0&&(Te={type:void 0,texture:void 0},se[ne]=Te),(Te.type!==O||Te.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,re||Re[O]),Te.type=O,Te.texture=re)}function F(){let O=se[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function Ye(){try{n.compressedTexImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function ot(){try{n.texSubImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function kt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function qe(){try{n.texStorage2D(...arguments)}catch(O){et("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){et("WebGLState:",O)}}function M(){try{n.texImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function X(){try{n.texImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function ue(O){return u[O]!==void 0?u[O]:n.getParameter(O)}function oe(O,re){u[O]!==re&&(n.pixelStorei(O,re),u[O]=re)}function ye(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function be(O){xe.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),xe.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(O);Te===void 0&&(Te=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Te,Te),ne.set(O,Te))}function ie(O,re,ne){let _e=c.get(re).get(O);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,se={},d={},l={},f=new WeakMap,g=[],x=null,p=!1,m=null,b=null,C=null,S=null,R=null,A=null,y=null,E=new ct(0,0,0),B=0,U=!1,D=null,H=null,G=null,N=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),xe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Xe,bindFramebuffer:rt,drawBuffers:Ge,useProgram:ft,setBlending:Zt,setMaterial:Vt,setFlipSided:hn,setCullFace:Ot,setLineWidth:An,setPolygonOffset:St,setScissorTest:vn,activeTexture:tn,bindTexture:un,unbindTexture:F,compressedTexImage2D:Le,compressedTexImage3D:Ye,texImage2D:M,texImage3D:X,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:qe,texStorage3D:P,texSubImage2D:ot,texSubImage3D:Ee,compressedTexSubImage2D:kt,compressedTexSubImage3D:He,scissor:ye,viewport:be,reset:ge}}function xA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,x=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,M){return p?new OffscreenCanvas(P,M):Ua("canvas")}function b(P,M,X){let ue=1,oe=qe(P);if((oe.width>X||oe.height>X)&&(ue=X/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ye=Math.floor(ue*oe.width),be=Math.floor(ue*oe.height);d===void 0&&(d=m(ye,be));let te=M?m(ye,be):d;return te.width=ye,te.height=be,te.getContext("2d").drawImage(P,0,0,ye,be),Ze("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+be+")."),te}else return"data"in P&&Ze("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function C(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(P,M,X,ue,oe,ye=!1){if(P!==null){if(n[P]!==void 0)return n[P];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let be;ue&&(be=e.get("EXT_texture_norm16"),be||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(X===n.FLOAT&&(te=n.R32F),X===n.HALF_FLOAT&&(te=n.R16F),X===n.UNSIGNED_BYTE&&(te=n.R8),X===n.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),X===n.SHORT&&be&&(te=be.R16_SNORM_EXT)),M===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.R8UI),X===n.UNSIGNED_SHORT&&(te=n.R16UI),X===n.UNSIGNED_INT&&(te=n.R32UI),X===n.BYTE&&(te=n.R8I),X===n.SHORT&&(te=n.R16I),X===n.INT&&(te=n.R32I)),M===n.RG&&(X===n.FLOAT&&(te=n.RG32F),X===n.HALF_FLOAT&&(te=n.RG16F),X===n.UNSIGNED_BYTE&&(te=n.RG8),X===n.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),X===n.SHORT&&be&&(te=be.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RG8UI),X===n.UNSIGNED_SHORT&&(te=n.RG16UI),X===n.UNSIGNED_INT&&(te=n.RG32UI),X===n.BYTE&&(te=n.RG8I),X===n.SHORT&&(te=n.RG16I),X===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGB8UI),X===n.UNSIGNED_SHORT&&(te=n.RGB16UI),X===n.UNSIGNED_INT&&(te=n.RGB32UI),X===n.BYTE&&(te=n.RGB8I),X===n.SHORT&&(te=n.RGB16I),X===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),X===n.UNSIGNED_INT&&(te=n.RGBA32UI),X===n.BYTE&&(te=n.RGBA8I),X===n.SHORT&&(te=n.RGBA16I),X===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(X===n.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),X===n.SHORT&&be&&(te=be.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=ye?Na:Mt.getTransfer(oe);X===n.FLOAT&&(te=n.RGBA32F),X===n.HALF_FLOAT&&(te=n.RGBA16F),X===n.UNSIGNED_BYTE&&(te=ie===It?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),X===n.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(P,M){let X;return P?M===null||M===qi||M===Fr?X=n.DEPTH24_STENCIL8:M===Yi?X=n.DEPTH32F_STENCIL8:M===Wo&&(X=n.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===qi||M===Fr?X=n.DEPTH_COMPONENT24:M===Yi?X=n.DEPTH_COMPONENT32F:M===Wo&&(X=n.DEPTH_COMPONENT16),X}function E(P,M){return C(P)===!0||P.isFramebufferTexture&&P.minFilter!==yn&&P.minFilter!==ni?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function B(P){let M=new WeakRef(P);i.get(P).__ref=M,g.add(M),x.register(P,M,M)}function U(P){let M=i.get(P).__ref;M!==void 0&&(g.delete(M),x.unregister(M))}function D(P){G(P.target)}function H(P){N(P.target)}function G(P){P.removeEventListener("dispose",D),U(P),K(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function N(P){P.removeEventListener("dispose",H),U(P),he(P)}function W(){for(let P of g){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):G(M))}g.clear(),u.clear()}function K(P){let M=i.get(P);if(M.__webglInit===void 0)return;let X=P.source,ue=f.get(X);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(P),Object.keys(ue).length===0&&f.delete(X)}i.remove(P)}function V(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let X=P.source,ue=f.get(X);delete ue[M.__cacheKey],o.memory.textures--}function he(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=P.depthTexture;if(X&&X.renderTarget===P&&G(X),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let ye=0;ye<M.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(M.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,ye=ue.length;oe<ye;oe++){let be=i.get(ue[oe]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let J=0;function Q(){J=0}function se(){return J}function pe(P){J=P}function fe(){let P=J;return P>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function xe(P,M){let X=i.get(P);if(P.isVideoTexture&&kt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&X.__version!==P.version){let ue=P.image;if(ue===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(X,P,M);return}}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+M)}function ve(P,M){let X=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Vt(X,P,M);return}else P.isExternalTexture&&(X.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+M)}function Re(P,M){let X=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&X.__version!==P.version){Vt(X,P,M);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+M)}function we(P,M){let X=i.get(P);if(P.version>0&&X.__version!==P.version){hn(X,P,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+M)}let Xe={[Nc]:n.REPEAT,[hs]:n.CLAMP_TO_EDGE,[Uc]:n.MIRRORED_REPEAT},rt={[yn]:n.NEAREST,[ox]:n.NEAREST_MIPMAP_NEAREST,[Qa]:n.NEAREST_MIPMAP_LINEAR,[ni]:n.LINEAR,[lh]:n.LINEAR_MIPMAP_NEAREST,[Us]:n.LINEAR_MIPMAP_LINEAR},Ge={[hx]:n.NEVER,[Lf]:n.ALWAYS,[ux]:n.LESS,[Rf]:n.LEQUAL,[dx]:n.EQUAL,[Pf]:n.GEQUAL,[fx]:n.GREATER,[px]:n.NOTEQUAL};function ft(P,M){if(M.type===Yi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===ni||M.magFilter===lh||M.magFilter===Qa||M.magFilter===Us||M.minFilter===ni||M.minFilter===lh||M.minFilter===Qa||M.minFilter===Us)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Xe[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Xe[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Xe[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Ge[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===yn||M.minFilter!==Qa&&M.minFilter!==Us||M.type===Yi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ht(P,M){let X=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",D),B(M));let ue=M.source,oe=f.get(ue);oe===void 0&&(oe={},f.set(ue,oe));let ye=ee(M);if(ye!==P.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),oe[ye].usedTimes++;let be=oe[P.__cacheKey];be!==void 0&&(oe[P.__cacheKey].usedTimes--,be.usedTimes===0&&V(M)),P.__cacheKey=ye,P.__webglTexture=oe[ye].texture}return X}function it(P,M,X){return Math.floor(Math.floor(P/X)/M)}function Zt(P,M,X,ue){let ye=P.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,X,ue,M.data);else{ye.sort((O,re)=>O.start-re.start);let be=0;for(let O=1;O<ye.length;O++){let re=ye[be],ne=ye[O],Te=re.start+re.count,_e=it(ne.start,M.width,4),Se=it(re.start,M.width,4);ne.start<=Te+1&&_e===Se&&it(ne.start+ne.count-1,M.width,4)===_e?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++be,ye[be]=ne)}ye.length=be+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let O=0,re=ye.length;O<re;O++){let ne=ye[O],Te=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Te%M.width,We=Math.floor(Te/M.width),Je=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,Je,ce,X,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Vt(P,M,X){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ht(P,M),ye=M.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+X);let be=i.get(ye);if(ye.version!==be.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=Mt.getPrimaries(Mt.workingColorSpace),Be=M.colorSpace===Fs?null:Mt.getPrimaries(M.colorSpace),je=M.colorSpace===Fs||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,s.maxTextureSize);ie=He(M,ie);let ge=r.convert(M.format,M.colorSpace),O=r.convert(M.type),re=A(M.internalFormat,ge,O,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,Te=M.mipmaps,_e=M.isVideoTexture!==!0,Se=be.__version===void 0||oe===!0,We=ye.dataReady,Je=E(M,ie);if(M.isDepthTexture)re=y(M.format===Os,M.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,ge,O,null));else if(M.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,ge,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ge,O,ne.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height),We&&Zt(M,ie,ge,O)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,ge,O,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,Te[0].width,Te[0].height,ie.depth);for(let ce=0,Be=Te.length;ce<Be;ce++)if(ne=Te[ce],M.format!==wi)if(ge!==null)if(_e){if(We)if(M.layerUpdates.size>0){let je=Vf(ne.width,ne.height,M.format,M.type);for(let Pe of M.layerUpdates){let lt=ne.data.subarray(Pe*je/ne.data.BYTES_PER_ELEMENT,(Pe+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Pe,ne.width,ne.height,1,ge,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,ge,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,ge,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ge,O,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,Te[0].width,Te[0].height);for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],M.format!==wi?ge!==null?_e?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,ge,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,ge,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ge,O,ne.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,ie.width,ie.height,ie.depth),We)if(M.layerUpdates.size>0){let ce=Vf(ie.width,ie.height,M.format,M.type);for(let Be of M.layerUpdates){let je=ie.data.subarray(Be*ce/ie.data.BYTES_PER_ELEMENT,(Be+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,ie.width,ie.height,1,ge,O,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,ge,O,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,ge,O,ie.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,Je,re,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,ge,O,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,ge,O,ie.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height);else{let ce=ie.width,Be=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,Be,0,ge,O,null),ce>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),u.add(M),ce.onpaint=Be=>{let je=Be.changedElements;for(let Pe of u)je.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Pe=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Pe,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let ce=qe(Te[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,Be=Te.length;ce<Be;ce++)ne=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ge,O,ne):t.texImage2D(n.TEXTURE_2D,ce,re,ge,O,ne);M.generateMipmaps=!1}else if(_e){if(Se){let ce=qe(ie);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,O,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,ge,O,ie);C(M)&&M.mipmapsAutoUpdate===!0&&S(ue),be.__version=ye.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function hn(P,M,X){if(M.image.length!==6)return;let ue=ht(P,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+X);let ye=i.get(oe);if(oe.version!==ye.__version||ue===!0){t.activeTexture(n.TEXTURE0+X);let be=Mt.getPrimaries(Mt.workingColorSpace),te=M.colorSpace===Fs?null:Mt.getPrimaries(M.colorSpace),ie=M.colorSpace===Fs||be===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let ge=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!ge&&!O?re[Pe]=b(M.image[Pe],!0,s.maxCubemapSize):re[Pe]=O?M.image[Pe].image:M.image[Pe],re[Pe]=He(M,re[Pe]);let ne=re[0],Te=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Se=A(M.internalFormat,Te,_e,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,Je=ye.__version===void 0||ue===!0,ce=oe.dataReady,Be=E(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(Se=y(M.format===Os,M.type),Je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ne.width,ne.height,0,Te,_e,null)}else if(ge){We&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){je=re[Pe].mipmaps;for(let lt=0;lt<je.length;lt++){let Ht=je[lt];M.format!==wi?Te!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,Ht.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Ht.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,_e,Ht.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Te,_e,Ht.data)}}}else{if(je=M.mipmaps,We&&Je){je.length>0&&Be++;let Pe=qe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Te,_e,re[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,re[Pe].width,re[Pe].height,0,Te,_e,re[Pe].data);for(let lt=0;lt<je.length;lt++){let Xn=je[lt].image[Pe].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Xn.width,Xn.height,Te,_e,Xn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,Xn.width,Xn.height,0,Te,_e,Xn.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,_e,re[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,_e,re[Pe]);for(let lt=0;lt<je.length;lt++){let Ht=je[lt];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Te,_e,Ht.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,Te,_e,Ht.image[Pe])}}}C(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Ot(P,M,X,ue,oe,ye){let be=r.convert(X.format,X.colorSpace),te=r.convert(X.type),ie=A(X.internalFormat,be,te,X.normalized,X.colorSpace),ge=i.get(M),O=i.get(X);if(O.__renderTarget=M,!ge.__hasExternalTextures){let re=Math.max(1,M.width>>ye),ne=Math.max(1,M.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,ie,re,ne,M.depth,0,be,te,null):t.texImage2D(oe,ye,ie,re,ne,0,be,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,ot(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function An(P,M,X){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ye=y(M.stencilBuffer,oe),be=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ye,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ye,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ye,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,P)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let ye=ue[oe],be=r.convert(ye.format,ye.colorSpace),te=r.convert(ye.type),ie=A(ye.internalFormat,be,te,ye.normalized,ye.colorSpace);Ee(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ie,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function St(P,M,X){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let ye=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||ye.width!==M.width||ye.height!==M.height)&&(ye.width=M.width,ye.height=M.height,M.depthTexture.needsUpdate=!0),ue?we(M.depthTexture,0):xe(M.depthTexture,0);let be=oe.__webglTexture,te=ot(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,ge=M.depthTexture.format===Os?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Ls)Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ie,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ie,be,0);else if(M.depthTexture.format===Os)Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,ie,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,ie,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(P){let M=i.get(P),X=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)St(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?St(M.__webglFramebuffer[0],P,0):St(M.__webglFramebuffer,P,0);else if(X){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),An(M.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),An(M.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function tn(P,M,X){let ue=i.get(P);M!==void 0&&Ot(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&vn(P)}function un(P){let M=P.texture,X=i.get(P),ue=i.get(M);P.addEventListener("dispose",H),B(P);let oe=P.textures,ye=P.isWebGLCubeRenderTarget===!0,be=oe.length>1;if(be||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),ye){X.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){X.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)X.__webglFramebuffer[te][ie]=n.createFramebuffer()}else X.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)X.__webglFramebuffer[te]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(be)for(let te=0,ie=oe.length;te<ie;te++){let ge=i.get(oe[te]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Ee(P)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];X.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[te]);let ge=r.convert(ie.format,ie.colorSpace),O=r.convert(ie.type),re=A(ie.internalFormat,ge,O,ie.normalized,ie.colorSpace,P.isXRRenderTarget===!0),ne=ot(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,X.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),An(X.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ot(X.__webglFramebuffer[te][ie],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ot(X.__webglFramebuffer[te],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,ie=oe.length;te<ie;te++){let ge=oe[te],O=i.get(ge),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ft(re,ge),Ot(X.__webglFramebuffer,P,ge,n.COLOR_ATTACHMENT0+te,re,0),C(ge)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ot(X.__webglFramebuffer[ie],P,M,n.COLOR_ATTACHMENT0,te,ie);else Ot(X.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,te,0);C(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&vn(P)}function F(P){let M=P.textures;for(let X=0,ue=M.length;X<ue;X++){let oe=M[X];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let ye=R(P),be=i.get(oe).__webglTexture;t.bindTexture(ye,be),S(ye),t.unbindTexture()}}}let Le=[];function Ye(P){if(P.samples>0){if(Ee(P)===!1){let M=P.textures,X=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,ye=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(P),te=M.length>1;if(te)for(let ge=0;ge<M.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ge=0;ge<M.length;ge++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let O=i.get(M[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,X,ue,0,0,X,ue,oe,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+ge),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Le.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let ge=0;ge<M.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let O=i.get(M[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ot(P){return Math.min(s.maxSamples,P.samples)}function Ee(P){let M=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function kt(P){let M=o.render.frame;h.get(P)!==M&&(h.set(P,M),P.update())}function He(P,M){let X=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||X!==Da&&X!==Fs&&(Mt.getTransfer(X)===It?(ue!==wi||oe!==li)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",X)),M}function qe(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=pe,this.setTexture2D=xe,this.setTexture2DArray=ve,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=tn,this.setupRenderTarget=un,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Ee,this.dispose=W}function _A(n,e){function t(i,s=Fs){let r,o=Mt.getTransfer(s);if(i===li)return n.UNSIGNED_BYTE;if(i===hh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===uh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===wf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ef)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Mf)return n.BYTE;if(i===Sf)return n.SHORT;if(i===Wo)return n.UNSIGNED_SHORT;if(i===ch)return n.INT;if(i===qi)return n.UNSIGNED_INT;if(i===Yi)return n.FLOAT;if(i===Zi)return n.HALF_FLOAT;if(i===Tf)return n.ALPHA;if(i===Af)return n.RGB;if(i===wi)return n.RGBA;if(i===Ls)return n.DEPTH_COMPONENT;if(i===Os)return n.DEPTH_STENCIL;if(i===Cf)return n.RED;if(i===dh)return n.RED_INTEGER;if(i===dr)return n.RG;if(i===fh)return n.RG_INTEGER;if(i===ph)return n.RGBA_INTEGER;if(i===el||i===tl||i===nl||i===il)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===el)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===il)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===el)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===tl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===nl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===il)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===mh||i===gh||i===xh||i===_h)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===mh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===gh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===xh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===_h)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===yh||i===vh||i===bh||i===Mh||i===Sh||i===sl||i===wh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===yh||i===vh)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===bh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Mh)return r.COMPRESSED_R11_EAC;if(i===Sh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===sl)return r.COMPRESSED_RG11_EAC;if(i===wh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Eh||i===Th||i===Ah||i===Ch||i===Rh||i===Ph||i===Lh||i===Ih||i===Dh||i===Nh||i===Uh||i===Oh||i===Fh||i===kh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Eh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Th)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ch)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Rh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ih)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Nh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Uh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Oh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===kh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Bh||i===zh||i===Vh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Bh)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===zh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Vh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Hh||i===Gh||i===rl||i===Wh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Hh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Gh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===rl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Wh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var yA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,vA=`
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

}`,Kf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Wa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new us({vertexShader:yA,fragmentShader:vA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new oi(new Dr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Jf=class extends $i{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,x=typeof XRWebGLBinding<"u",p=new Kf,m={},b=t.getContextAttributes(),C=null,S=null,R=[],A=[],y=new tt,E=null,B=null,U=new ti;U.viewport=new Jt;let D=new ti;D.viewport=new Jt;let H=[U,D],G=new sh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let xe=R[ee];return xe===void 0&&(xe=new No,R[ee]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(ee){let xe=R[ee];return xe===void 0&&(xe=new No,R[ee]=xe),xe.getGripSpace()},this.getHand=function(ee){let xe=R[ee];return xe===void 0&&(xe=new No,R[ee]=xe),xe.getHandSpace()};function K(ee){let xe=A.indexOf(ee.inputSource);if(xe===-1)return;let ve=R[xe];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",he);for(let ee=0;ee<R.length;ee++){let xe=A[ee];xe!==null&&(A[ee]=null,R[ee].disconnect(xe))}N=null,W=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(y.width,y.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",V),s.addEventListener("inputsourceschange",he),b.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Re=null,we=null;b.depth&&(we=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=b.stencil?Os:Ls,Re=b.stencil?Fr:qi);let Xe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new bi(d.textureWidth,d.textureHeight,{format:wi,type:li,depthTexture:new Ns(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new bi(f.framebufferWidth,f.framebufferHeight,{format:wi,type:li,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function he(ee){for(let xe=0;xe<ee.removed.length;xe++){let ve=ee.removed[xe],Re=A.indexOf(ve);Re>=0&&(A[Re]=null,R[Re].disconnect(ve))}for(let xe=0;xe<ee.added.length;xe++){let ve=ee.added[xe],Re=A.indexOf(ve);if(Re===-1){for(let Xe=0;Xe<R.length;Xe++)if(Xe>=A.length){A.push(ve),Re=Xe;break}else if(A[Xe]===null){A[Xe]=ve,Re=Xe;break}if(Re===-1)break}let we=R[Re];we&&we.connect(ve)}}function J(ee,xe){xe===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(xe.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let xe=ee.near,ve=ee.far;p.texture!==null&&(p.depthNear>0&&(xe=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),G.near=D.near=U.near=xe,G.far=D.far=U.far=ve,(N!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),N=G.near,W=G.far),G.layers.mask=ee.layers.mask|6,U.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Re=ee.parent,we=G.cameras;J(G,Re);for(let Xe=0;Xe<we.length;Xe++)J(we[Xe],Re);G.projectionMatrix.copy(U.projectionMatrix),G.projectionMatrixInverse.copy(U.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,G,Re)};function Q(ee,xe,ve){ve===null?ee.matrix.copy(xe.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(xe.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(xe.projectionMatrix),ee.projectionMatrixInverse.copy(xe.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Io*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function pe(ee,xe){if(h=xe.getViewerPose(c||o),g=xe,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Re=!1;ve.length!==G.cameras.length&&(G.cameras.length=0,Re=!0);for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge],ht=null;if(f!==null)ht=f.getViewport(ft);else{let Zt=u.getViewSubImage(d,ft);ht=Zt.viewport,Ge===0&&(e.setRenderTargetTextures(S,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(S))}let it=H[Ge];it===void 0&&(it=new ti,it.layers.enable(Ge),it.viewport=new Jt,H[Ge]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ht.x,ht.y,ht.width,ht.height),Ge===0&&(G.matrix.copy(it.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Re===!0&&G.cameras.push(it)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Ge=u.getDepthInformation(ve[0]);Ge&&Ge.isValid&&Ge.texture&&p.init(Ge,s.renderState)}if(we&&we.includes("camera-access")&&x){e.state.unbindTexture(),u=i.getBinding();for(let Ge=0;Ge<ve.length;Ge++){let ft=ve[Ge].camera;if(ft){let ht=m[ft];ht||(ht=new Wa,m[ft]=ht);let it=u.getCameraImage(ft);ht.sourceTexture=it}}}}for(let ve=0;ve<R.length;ve++){let Re=A[ve],we=R[ve];Re!==null&&we!==void 0&&we.update(Re,xe,c||o)}se&&se(ee,xe),xe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:xe}),g=null}let fe=new qx;fe.setAnimationLoop(pe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},bA=new Yt,i_=new nt;i_.set(-1,0,0,0,1,0,0,0,1);function MA(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,kf(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,b,C,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,S)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),x(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,b,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ii&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ii&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let b=e.get(m),C=b.envMap,S=b.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(bA.makeRotationFromEuler(S)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(i_),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,b,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*b,p.scale.value=C*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,b){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ii&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=b.texture,p.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function x(p,m){let b=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(b.matrixWorld),p.nearDistance.value=b.shadow.camera.near,p.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function SA(n,e,t,i){let s={},r={};function o(b,C){let S=C.program;i.uniformBlockBinding(b,S,s[b.id])}function a(b,C){let S=s[b.id];S===void 0&&(g(b),S=l(b),s[b.id]=S,b.addEventListener("dispose",p));let R=C.program;i.updateUBOMapping(b,R);let A=e.render.frame;r[b.id]!==A&&(c(b),r[b.id]=A)}function l(b){let C=n.createBuffer(),S=b.__size,R=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(b){let C=s[b.id],S=b.uniforms,R=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let A=0,y=S.length;A<y;A++){let E=S[A];if(Array.isArray(E))for(let B=0,U=E.length;B<U;B++)h(E[B],A,B,R);else h(E,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(b,C,S,R){if(d(b,C,S,R)===!0){let A=b.__offset,y=b.value;if(Array.isArray(y)){let E=0;for(let B=0;B<y.length;B++){let U=y[B],D=x(U,!0);u(U,b.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,b.__data)}}function u(b,C,S){typeof b=="number"||typeof b=="boolean"?C[S]=b:b.isMatrix3?(C[S]=b.elements[0],C[S+1]=b.elements[1],C[S+2]=b.elements[2],C[S+3]=0,C[S+4]=b.elements[3],C[S+5]=b.elements[4],C[S+6]=b.elements[5],C[S+7]=0,C[S+8]=b.elements[6],C[S+9]=b.elements[7],C[S+10]=b.elements[8],C[S+11]=0):ArrayBuffer.isView(b)?C.set(b.subarray(0,C.length-S),S):b.toArray(C,S)}function d(b,C,S,R){let A=b.value,y=C+"_"+S;if(Array.isArray(A)){R[y]===void 0&&(R[y]=[]);let E=R[y],B=!1;for(let U=0;U<A.length;U++)f(A[U],E,U)===!0&&(B=!0);return B}return f(A,R,y)}function f(b,C,S){if(C[S]===void 0)return typeof b=="number"||typeof b=="boolean"?C[S]=b:ArrayBuffer.isView(b)?C[S]=b.slice():C[S]=b.clone(),!0;{let R=C[S];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return C[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function g(b){let C=b.uniforms,S=0,R=16;for(let y=0,E=C.length;y<E;y++){let B=Array.isArray(C[y])?C[y]:[C[y]];for(let U=0,D=B.length;U<D;U++){let H=B[U],G=Array.isArray(H.value)?H.value:[H.value],N=Array.isArray(C[y])||Array.isArray(H.value),W=S;for(let V=0,he=G.length;V<he;V++){let J=G[V],Q=x(J,N),se=S%R,pe=se%Q.boundary,fe=se+pe;S+=pe,fe!==0&&R-fe<Q.storage&&(S+=R-fe),V===0&&(W=S),S+=Q.storage}let K=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new K((S-W)/Float32Array.BYTES_PER_ELEMENT),H.__offset=W}}let A=S%R;return A>0&&(S+=R-A),b.__size=S,b.__cache={},this}function x(b,C){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",b),C===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(b){let C=b.target;C.removeEventListener("dispose",p),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:m}}var wA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function EA(){return fs===null&&(fs=new Uo(wA,16,16,dr,Zi),fs.name="DFG_LUT",fs.minFilter=ni,fs.magFilter=ni,fs.wrapS=hs,fs.wrapT=hs,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var Zh=class{constructor(e={}){let{canvas:t=gx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=li}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=f,p=new Set([ph,fh,dh]),m=new Set([li,qi,Wo,Fr,hh,uh]),b=new Uint32Array(4),C=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,y=[],E=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ds,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,H=null,G=null,N=null,W=null;this._outputColorSpace=Nn;let K=0,V=0,he=null,J=-1,Q=null,se=new Jt,pe=new Jt,fe=null,ee=new ct(0),xe=0,ve=t.width,Re=t.height,we=1,Xe=null,rt=null,Ge=new Jt(0,0,ve,Re),ft=new Jt(0,0,ve,Re),ht=!1,it=new rr,Zt=new zc,Vt=!1,hn=!1,Ot=new Yt,An=new q,St=new Jt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function un(){return he===null?we:1}let F=i;function Le(T,k){return t.getContext(T,k)}let Ye,ot,Ee,kt,He,qe,P,M,X,ue,oe,ye,be,te,ie,ge,O,re,ne,Te,_e,Se,We;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),F===null){let k="webgl2";if(F=Le(k,T),F===null)throw Le(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),et("WebGLRenderer: "+T.message),T}function Je(){Ye=new OE(F),Ye.init(),_e=new _A(F,Ye),ot=new EE(F,Ye,e,_e),Ee=new gA(F,Ye),ot.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),G=F.createFramebuffer(),N=F.createFramebuffer(),W=F.createFramebuffer(),kt=new BE(F),He=new nA,qe=new xA(F,Ye,Ee,He,ot,_e,kt),P=new UE(U),M=new VS(F),Se=new SE(F,M),X=new FE(F,M,kt,Se),ue=new VE(F,X,M,Se,kt),re=new zE(F,ot,qe),ie=new TE(He),oe=new tA(U,P,Ye,ot,Se,ie),ye=new MA(U,He),be=new sA,te=new hA(Ye),O=new ME(U,P,Ee,ue,g,l),ge=new mA(U,ue,ot),We=new SA(F,kt,ot,Ee),ne=new wE(F,Ye,kt),Te=new kE(F,Ye,kt),kt.programs=oe.programs,U.capabilities=ot,U.extensions=Ye,U.properties=He,U.renderLists=be,U.shadowMap=ge,U.state=Ee,U.info=kt}x!==li&&(B=new GE(x,t.width,t.height,a,s,r));let ce=new Jf(U,F);this.xr=ce,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let T=Ye.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ye.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(T){T!==void 0&&(we=T,this.setSize(ve,Re,!1))},this.getSize=function(T){return T.set(ve,Re)},this.setSize=function(T,k,j=!0){if(ce.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Re=k,t.width=Math.floor(T*we),t.height=Math.floor(k*we),j===!0&&(t.style.width=T+"px",t.style.height=k+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,T,k)},this.getDrawingBufferSize=function(T){return T.set(ve*we,Re*we).floor()},this.setDrawingBufferSize=function(T,k,j){ve=T,Re=k,we=j,t.width=Math.floor(T*j),t.height=Math.floor(k*j),this.setViewport(0,0,T,k)},this.setEffects=function(T){if(x===li){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let k=0;k<T.length;k++)if(T[k].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(Ge)},this.setViewport=function(T,k,j,$){T.isVector4?Ge.set(T.x,T.y,T.z,T.w):Ge.set(T,k,j,$),Ee.viewport(se.copy(Ge).multiplyScalar(un()).round())},this.getScissor=function(T){return T.copy(ft)},this.setScissor=function(T,k,j,$){T.isVector4?ft.set(T.x,T.y,T.z,T.w):ft.set(T,k,j,$),Ee.scissor(pe.copy(ft).multiplyScalar(un()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(T){Ee.setScissorTest(ht=T)},this.setOpaqueSort=function(T){Xe=T},this.setTransparentSort=function(T){rt=T},this.getClearColor=function(T){return T.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(T=!0,k=!0,j=!0){let $=0;if(T){let Y=!1;if(he!==null){let Ae=he.texture.format;Y=p.has(Ae)}if(Y){let Ae=he.texture.type,Ie=m.has(Ae),Ce=O.getClearColor(),De=O.getClearAlpha(),Ve=Ce.r,Qe=Ce.g,pt=Ce.b;Ie?(b[0]=Ve,b[1]=Qe,b[2]=pt,b[3]=De,F.clearBufferuiv(F.COLOR,0,b)):(C[0]=Ve,C[1]=Qe,C[2]=pt,C[3]=De,F.clearBufferiv(F.COLOR,0,C))}else $|=F.COLOR_BUFFER_BIT}k&&($|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&F.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),H=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),be.dispose(),te.dispose(),qe.dispose(),He.dispose(),P.dispose(),ue.dispose(),X.dispose(),Se.dispose(),We.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",ul),ce.removeEventListener("sessionend",Ki),ms.stop()};function Be(T){T.preventDefault(),Df("WebGLRenderer: Context Lost."),D=!0}function je(){Df("WebGLRenderer: Context Restored."),D=!1;let T=kt.autoReset,k=ge.enabled,j=ge.autoUpdate,$=ge.needsUpdate,Y=ge.type;Je(),kt.autoReset=T,ge.enabled=k,ge.autoUpdate=j,ge.needsUpdate=$,ge.type=Y}function Pe(T){et("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let k=T.target;k.removeEventListener("dispose",lt),Ht(k)}function Ht(T){Xn(T),He.remove(T)}function Xn(T){let k=He.get(T).programs;k!==void 0&&(k.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,k,j,$,Y,Ae){k===null&&(k=vn);let Ie=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ce=jo(T,k,j,$,Y);Ee.setMaterial($,Ie);let De=j.index,Ve=1;if($.wireframe===!0){if(De=X.getWireframeAttribute(j),De===void 0)return;Ve=2}let Qe=j.drawRange,pt=j.attributes.position,ze=Qe.start*Ve,mt=(Qe.start+Qe.count)*Ve;Ae!==null&&(ze=Math.max(ze,Ae.start*Ve),mt=Math.min(mt,(Ae.start+Ae.count)*Ve)),De!==null?(ze=Math.max(ze,0),mt=Math.min(mt,De.count)):pt!=null&&(ze=Math.max(ze,0),mt=Math.min(mt,pt.count));let jt=mt-ze;if(jt<0||jt===1/0)return;Se.setup(Y,$,Ce,j,De);let Dt,Nt=ne;if(De!==null&&(Dt=M.get(De),Nt=Te,Nt.setIndex(Dt)),Y.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*un()),Nt.setMode(F.LINES)):Nt.setMode(F.TRIANGLES);else if(Y.isLine){let bn=$.linewidth;bn===void 0&&(bn=1),Ee.setLineWidth(bn*un()),Y.isLineSegments?Nt.setMode(F.LINES):Y.isLineLoop?Nt.setMode(F.LINE_LOOP):Nt.setMode(F.LINE_STRIP)}else Y.isPoints?Nt.setMode(F.POINTS):Y.isSprite&&Nt.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Nt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let bn=Y._multiDrawStarts,Fe=Y._multiDrawCounts,dn=Y._multiDrawCount,vt=De?M.get(De).bytesPerElement:1,xs=He.get($).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)xs.setValue(F,"_gl_DrawID",fn),Nt.render(bn[fn]/vt,Fe[fn])}else if(Y.isInstancedMesh)Nt.renderInstances(ze,jt,Y.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,bn);Nt.renderInstances(ze,jt,Fe)}else Nt.render(ze,jt)};function Zo(T,k,j,$){H!==null&&T.isNodeMaterial&&H.setObject($,T),Vt===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===ai&&T.forceSinglePass===!1?(T.side=ii,T.needsUpdate=!0,Ji(T,k,$),T.side=ur,T.needsUpdate=!0,Ji(T,k,$),T.side=ai):Ji(T,k,$)}this.compile=function(T,k,j=null){j===null&&(j=T),H!==null&&H.renderStart(T,k,j),A=te.get(j),A.init(k),E.push(A),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(k.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),T!==j&&T.traverseVisible(function(Y){Y.isLight&&Y.layers.test(k.layers)&&(A.pushLight(Y),Y.castShadow&&A.pushShadow(Y))}),A.setupLights(),H!==null&&H.updateLights(A.state.lightsArray),hn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,hn),Vt===!0&&ie.setGlobalState(this.clippingPlanes,k),H!==null&&ge.render(A.state.shadowsArray,j,k);let $=new Set;return T.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Ae=Y.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Ce=Ae[Ie];Zo(Ce,j,k,Y),$.add(Ce)}else Zo(Ae,j,k,Y),$.add(Ae)}),A=E.pop(),H!==null&&H.renderEnd(),$},this.compileAsync=function(T,k,j=null){let $=this.compile(T,k,j);return new Promise(Y=>{function Ae(){if($.forEach(function(Ie){let De=He.get(Ie).currentProgram;(De===void 0||De.isReady())&&$.delete(Ie)}),$.size===0){Y(T);return}setTimeout(Ae,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Br=null;function lu(T){Br&&Br(T)}function ul(){ms.stop()}function Ki(){ms.start()}let ms=new qx;ms.setAnimationLoop(lu),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(T){Br=T,ce.setAnimationLoop(T),T===null?ms.stop():ms.start()},ce.addEventListener("sessionstart",ul),ce.addEventListener("sessionend",Ki),this.render=function(T,k){if(k!==void 0&&k.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(T,k);let j=ce.enabled===!0&&ce.isPresenting===!0,$=B!==null&&(he===null||j)&&B.begin(U,he);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(k),k=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(U,T,k,he),A=te.get(T,E.length),A.init(k),A.state.textureUnits=qe.getTextureUnits(),E.push(A),Ot.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Zt.setFromArrayCamera(k):it.setFromProjectionMatrix(Ot,Ui,k.reversedDepth),hn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,hn),R=be.get(T,y.length),R.init(),y.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=U.xr.getDepthSensingMesh();Ie!==null&&gs(Ie,k,-1/0,U.sortObjects)}gs(T,k,0,U.sortObjects),R.finish(),H!==null&&H.updateLights(A.state.lightsArray),U.sortObjects===!0&&R.sort(Xe,rt),tn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,tn&&O.addToRenderList(R,T),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&ie.beginShadows();let Y=A.state.shadowsArray;if(ge.render(Y,T,k),Vt===!0&&ie.endShadows(),($&&B.hasRenderPass())===!1){let Ie=R.opaque,Ce=R.transmissive;if(A.setupLights(),k.isArrayCamera){let De=k.cameras;if(Ce.length>0)for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];Oi(Ie,Ce,T,pt)}tn&&O.render(T);for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];Ko(R,T,pt,pt.viewport)}}else Ce.length>0&&Oi(Ie,Ce,T,k),tn&&O.render(T),Ko(R,T,k)}he!==null&&V===0&&(qe.updateMultisampleRenderTarget(he),qe.updateRenderTargetMipmap(he)),$&&B.end(U),T.isScene===!0&&T.onAfterRender(U,T,k),Se.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(A=E[E.length-1],qe.setTextureUnits(A.state.textureUnits),Vt===!0&&ie.setGlobalState(U.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,H!==null&&H.renderEnd()};function gs(T,k,j,$){if(T.visible===!1)return;if(T.layers.test(k.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(k);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Ie=k.isArrayCamera?Zt:it;if(!T.frustumCulled||T.intersectsFrustum(Ie)){$&&St.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ot);let Ce=ue.update(T),De=T.material;De.visible&&R.push(T,Ce,De,j,St.z,null,k)}}else if(T.isMesh||T.isLine||T.isPoints){let Ie=k.isArrayCamera?Zt:it;if(!T.frustumCulled||T.intersectsFrustum(Ie)){let Ce=ue.update(T),De=T.material;if($&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),St.copy(T.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),St.copy(Ce.boundingSphere.center)),St.applyMatrix4(T.matrixWorld).applyMatrix4(Ot)),Array.isArray(De)){let Ve=Ce.groups;for(let Qe=0,pt=Ve.length;Qe<pt;Qe++){let ze=Ve[Qe],mt=De[ze.materialIndex];mt&&mt.visible&&R.push(T,Ce,mt,j,St.z,ze,k)}}else De.visible&&R.push(T,Ce,De,j,St.z,null,k)}}}let Ae=T.children;for(let Ie=0,Ce=Ae.length;Ie<Ce;Ie++)gs(Ae[Ie],k,j,$)}function Ko(T,k,j,$){let{opaque:Y,transmissive:Ae,transparent:Ie}=T;A.setupLightsView(j),Vt===!0&&ie.setGlobalState(U.clippingPlanes,j),$&&Ee.viewport(se.copy($)),Y.length>0&&nn(Y,k,j),Ae.length>0&&nn(Ae,k,j),Ie.length>0&&nn(Ie,k,j),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Oi(T,k,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let ze=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new bi(1,1,{generateMipmaps:!0,type:ze?Zi:li,minFilter:Us,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Mt.workingColorSpace})}let Ae=A.state.transmissionRenderTarget[$.id],Ie=$.viewport||se;Ae.setSize(Ie.z*U.transmissionResolutionScale,Ie.w*U.transmissionResolutionScale);let Ce=U.getRenderTarget(),De=U.getActiveCubeFace(),Ve=U.getActiveMipmapLevel();U.setRenderTarget(Ae),U.getClearColor(ee),xe=U.getClearAlpha(),xe<1&&U.setClearColor(16777215,.5),U.clear(),tn&&O.render(j);let Qe=U.toneMapping;U.toneMapping=ds;let pt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Vt===!0&&ie.setGlobalState(U.clippingPlanes,$),nn(T,j,$),qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let mt=0,jt=k.length;mt<jt;mt++){let Dt=k[mt],{object:Nt,geometry:bn,material:Fe,group:dn}=Dt;if(Fe.side===ai&&Nt.layers.test($.layers)){let vt=Fe.side;Fe.side=ii,Fe.needsUpdate=!0,ln(Nt,j,$,bn,Fe,dn),Fe.side=vt,Fe.needsUpdate=!0,ze=!0}}ze===!0&&(qe.updateMultisampleRenderTarget(Ae),qe.updateRenderTargetMipmap(Ae))}U.setRenderTarget(Ce,De,Ve),U.setClearColor(ee,xe),pt!==void 0&&($.viewport=pt),U.toneMapping=Qe}function nn(T,k,j){let $=k.isScene===!0?k.overrideMaterial:null;for(let Y=0,Ae=T.length;Y<Ae;Y++){let Ie=T[Y],{object:Ce,geometry:De,group:Ve}=Ie,Qe=Ie.material;Qe.allowOverride===!0&&$!==null&&(Qe=$),Ce.layers.test(j.layers)&&ln(Ce,k,j,De,Qe,Ve)}}function ln(T,k,j,$,Y,Ae){H!==null&&Y.isNodeMaterial&&H.setObject(T,Y),T.onBeforeRender(U,k,j,$,Y,Ae),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Y.onBeforeRender(U,k,j,$,T,Ae),Y.transparent===!0&&Y.side===ai&&Y.forceSinglePass===!1?(Y.side=ii,Y.needsUpdate=!0,U.renderBufferDirect(j,k,$,Y,T,Ae),Y.side=ur,Y.needsUpdate=!0,U.renderBufferDirect(j,k,$,Y,T,Ae),Y.side=ai):U.renderBufferDirect(j,k,$,Y,T,Ae),T.onAfterRender(U,k,j,$,Y,Ae)}function cn(T){let k=0;for(let j of T)j.texture!==null&&k++;return k}function Ji(T,k,j){k.isScene!==!0&&(k=vn);let $=He.get(T),Y=A.state.lights,Ae=A.state.shadowsArray,Ie=Y.state.version,Ce=oe.getParameters(T,Y.state,Ae,k,j,A.state.lightProbeGridArray),De=oe.getProgramCacheKey(Ce),Ve=$.programs;$.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?k.environment:null,$.fog=k.fog;let Qe=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;$.envMap=P.get(T.envMap||$.environment,Qe),$.envMapRotation=$.environment!==null&&T.envMap===null?k.environmentRotation:T.envMapRotation,Ve===void 0&&(T.addEventListener("dispose",lt),Ve=new Map,$.programs=Ve,$.programVariants=new Map);let pt=Ve.get(De);if(pt!==void 0){if($.currentProgram===pt&&$.lightsStateVersion===Ie)return Jo(T,Ce),pt}else Ce.uniforms=oe.getUniforms(T),H!==null&&T.isNodeMaterial&&H.build(T,j,Ce),T.onBeforeCompile(Ce,U),pt=oe.acquireProgram(Ce,De),Ve.set(De,pt),$.uniforms=Ce.uniforms;let ze=$.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(ze.clippingPlanes=ie.uniform),Jo(T,Ce),$.needsLights=Bs(T),$.lightsStateVersion=Ie,$.needsLights&&(ze.ambientLightColor.value=Y.state.ambient,ze.lightProbe.value=Y.state.probe,ze.sunLights.value=Y.state.sun,ze.sunLightShadows.value=Y.state.sunShadow,ze.directionalLights.value=Y.state.directional,ze.directionalLightShadows.value=Y.state.directionalShadow,ze.spotLights.value=Y.state.spot,ze.spotLightShadows.value=Y.state.spotShadow,ze.rectAreaLights.value=Y.state.rectArea,ze.ltc_1.value=Y.state.rectAreaLTC1,ze.ltc_2.value=Y.state.rectAreaLTC2,ze.pointLights.value=Y.state.point,ze.pointLightShadows.value=Y.state.pointShadow,ze.hemisphereLights.value=Y.state.hemi,ze.sunShadowMatrix.value=Y.state.sunShadowMatrix,ze.sunShadowCascade.value=Y.state.sunShadowCascade,ze.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,ze.spotLightMatrix.value=Y.state.spotLightMatrix,ze.spotLightMap.value=Y.state.spotLightMap,ze.pointShadowMatrix.value=Y.state.pointShadowMatrix),$.numLightProbeGrids=cn(A.state.lightProbeGridArray),$.currentProgram=pt,$.uniformsList=null,pt}function hi(T,k,j,$,Y){let Ae=He.get(T),Ie=Ae.currentProgram.id+","+$+","+Y,Ce=Ae.programVariants.get(Ie);return Ce===void 0?(Ce=Ji(T,k,j),Ae.programVariants.set(Ie,Ce)):(Ae.currentProgram=Ce,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=Y),Ce}function ks(T){if(T.uniformsList===null){let k=T.currentProgram.getUniforms();T.uniformsList=$o.seqWithValue(k.seq,T.uniforms)}return T.uniformsList}function Jo(T,k){let j=He.get(T);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function jo(T,k,j,$,Y){k.isScene!==!0&&(k=vn),qe.resetTextureUnits();let Ae=k.fog,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?k.environment:null,Ce=he===null?U.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:Mt.workingColorSpace,De=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ve=P.get($.envMap||Ie,De),Qe=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ze=!!j.morphAttributes.position,mt=!!j.morphAttributes.normal,jt=!!j.morphAttributes.color,Dt=ds;$.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Dt=U.toneMapping);let Nt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Nt!==void 0?Nt.length:0,Fe=He.get($),dn=A.state.lights;if(Vt===!0&&(hn===!0||T!==Q)){let Ut=T===Q&&$.id===J;ie.setState($,T,Ut)}let vt=!1,xs=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==dn.state.version||Y.isBatchedMesh&&Fe.batching===!1||!Y.isBatchedMesh&&Fe.batching===!0||Y.isBatchedMesh&&Fe.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Fe.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Fe.instancing===!1||!Y.isInstancedMesh&&Fe.instancing===!0||Y.isSkinnedMesh&&Fe.skinning===!1||!Y.isSkinnedMesh&&Fe.skinning===!0||Y.isInstancedMesh&&Fe.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Fe.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Fe.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Fe.instancingMorph===!1&&Y.morphTexture!==null||Fe.envMap!==Ve||$.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==pt||Fe.morphTargets!==ze||Fe.morphNormals!==mt||Fe.morphColors!==jt||Fe.morphTargetsCount!==bn||Fe.numLightProbeGrids!==cn(A.state.lightProbeGridArray)?vt=!0:(Fe.outputColorSpace!==Ce||Fe.toneMapping!==Dt)&&(xs=!0):(vt=!0,Fe.__version=$.version);let fn=Fe.currentProgram;(vt===!0||xs===!0)&&(fn=xs===!0?hi($,k,Y,Ce,Dt):Ji($,k,Y),H&&$.isNodeMaterial&&H.onUpdateProgram($,fn,Fe));let Hr=!1,ji=!1,_s=!1,ut=fn.getUniforms(),sn=Fe.uniforms;if(Ee.useProgram(fn.program)&&(Hr=!0,ji=!0,_s=!0),$.id!==J&&(J=$.id,ji=!0),Hr||Q!==T){Ee.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ut.setValue(F,"projectionMatrix",T.projectionMatrix),ut.setValue(F,"viewMatrix",T.matrixWorldInverse);let pn=ut.map.cameraPosition;pn!==void 0&&pn.setValue(F,An.setFromMatrixPosition(T.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(F,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ut.setValue(F,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,ji=!0,_s=!0)}if(Fe.needsLights&&(dn.state.sunShadowMap.length>0&&ut.setValue(F,"sunShadowMap",dn.state.sunShadowMap,qe),dn.state.directionalShadowMap.length>0&&ut.setValue(F,"directionalShadowMap",dn.state.directionalShadowMap,qe),dn.state.spotShadowMap.length>0&&ut.setValue(F,"spotShadowMap",dn.state.spotShadowMap,qe),dn.state.pointShadowMap.length>0&&ut.setValue(F,"pointShadowMap",dn.state.pointShadowMap,qe)),Y.isSkinnedMesh){ut.setOptional(F,Y,"bindMatrix"),ut.setOptional(F,Y,"bindMatrixInverse");let Ut=Y.skeleton;Ut&&(Ut.boneTexture===null&&Ut.computeBoneTexture(),ut.setValue(F,"boneTexture",Ut.boneTexture,qe))}Y.isBatchedMesh&&(ut.setOptional(F,Y,"batchingTexture"),ut.setValue(F,"batchingTexture",Y._matricesTexture,qe),ut.setOptional(F,Y,"batchingIdTexture"),ut.setValue(F,"batchingIdTexture",Y._indirectTexture,qe),ut.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&ut.setValue(F,"batchingColorTexture",Y._colorsTexture,qe));let $n=j.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&re.update(Y,j,fn),(ji||Fe.receiveShadow!==Y.receiveShadow)&&(Fe.receiveShadow=Y.receiveShadow,ut.setValue(F,"receiveShadow",Y.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&k.environment!==null&&(sn.envMapIntensity.value=k.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=EA()),ji){if(ut.setValue(F,"toneMappingExposure",U.toneMappingExposure),Fe.needsLights&&zr(sn,_s),Ae&&$.fog===!0&&ye.refreshFogUniforms(sn,Ae),ye.refreshMaterialUniforms(sn,$,we,Re,A.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ut=S,pn=0;for(let Fn of A.state.lightProbeGridArray)Fn.texture!==null&&(Ut.textures[pn]=Fn.texture,Ut.min[pn]=Fn.boundingBox.min,Ut.max[pn]=Fn.boundingBox.max,Ut.resolution[pn]=Fn.resolution,pn++);for(let Fn in Ut)Ut[Fn].length=pn;sn.probesSH.value=Ut.textures,sn.probesMin.value=Ut.min,sn.probesMax.value=Ut.max,sn.probesResolution.value=Ut.resolution}$o.upload(F,ks(Fe),sn,qe)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&($o.upload(F,ks(Fe),sn,qe),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ut.setValue(F,"center",Y.center),ut.setValue(F,"modelViewMatrix",Y.modelViewMatrix),ut.setValue(F,"normalMatrix",Y.normalMatrix),ut.setValue(F,"modelMatrix",Y.matrixWorld),$.uniformsGroups!==void 0){let Ut=$.uniformsGroups;for(let pn=0,Fn=Ut.length;pn<Fn;pn++){let dl=Ut[pn];We.update(dl,fn),We.bind(dl,fn)}}return fn}function zr(T,k){T.ambientLightColor.needsUpdate=k,T.lightProbe.needsUpdate=k,T.sunLights.needsUpdate=k,T.sunLightShadows.needsUpdate=k,T.directionalLights.needsUpdate=k,T.directionalLightShadows.needsUpdate=k,T.pointLights.needsUpdate=k,T.pointLightShadows.needsUpdate=k,T.spotLights.needsUpdate=k,T.spotLightShadows.needsUpdate=k,T.rectAreaLights.needsUpdate=k,T.hemisphereLights.needsUpdate=k}function Bs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(T,k,j){let $=He.get(T);$.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),He.get(T.texture).__webglTexture=k,He.get(T.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,k){let j=He.get(T);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(T,k=0,j=0){he=T,K=k,V=j;let $=null,Y=!1,Ae=!1;if(T){let Ce=He.get(T);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(F.FRAMEBUFFER,Ce.__webglFramebuffer),se.copy(T.viewport),pe.copy(T.scissor),fe=T.scissorTest,Ee.viewport(se),Ee.scissor(pe),Ee.setScissorTest(fe),J=-1;return}else if(Ce.__webglFramebuffer===void 0)qe.setupRenderTarget(T);else if(Ce.__hasExternalTextures)qe.rebindTextures(T,He.get(T.texture).__webglTexture,He.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Qe=T.depthTexture;if(Ce.__boundDepthTexture!==Qe){if(Qe!==null&&He.has(Qe)&&(T.width!==Qe.image.width||T.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(T)}}let De=T.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let Ve=He.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ve[k])?$=Ve[k][j]:$=Ve[k],Y=!0):T.samples>0&&qe.useMultisampledRTT(T)===!1?$=He.get(T).__webglMultisampledFramebuffer:Array.isArray(Ve)?$=Ve[j]:$=Ve,se.copy(T.viewport),pe.copy(T.scissor),fe=T.scissorTest}else se.copy(Ge).multiplyScalar(we).floor(),pe.copy(ft).multiplyScalar(we).floor(),fe=ht;if(j!==0&&($=G),Ee.bindFramebuffer(F.FRAMEBUFFER,$)&&Ee.drawBuffers(T,$),Ee.viewport(se),Ee.scissor(pe),Ee.setScissorTest(fe),Y){let Ce=He.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ce.__webglTexture,j)}else if(Ae){let Ce=k;for(let De=0;De<T.textures.length;De++){let Ve=He.get(T.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ve.__webglTexture,j,Ce)}}else if(T!==null&&j!==0){let Ce=He.get(T.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ce.__webglTexture,j)}J=-1};function Vr(T){let k=He.get(T);return(k.__readFormat!==T.format||k.__readType!==T.type)&&(k.__readFormat=T.format,k.__readType=T.type,k.__formatReadable=ot.textureFormatReadable(T.format),k.__typeReadable=ot.textureTypeReadable(T.type)),k}this.readRenderTargetPixels=function(T,k,j,$,Y,Ae,Ie,Ce=0){if(!(T&&T.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ve=T.textures[Ce],Qe=Ve.format,pt=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=Vr(Ve);if(ze.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=T.width-$&&j>=0&&j<=T.height-Y&&F.readPixels(k,j,$,Y,_e.convert(Qe),_e.convert(pt),Ae)}finally{let Ve=he!==null?He.get(he).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(T,k,j,$,Y,Ae,Ie,Ce=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=He.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De)if(k>=0&&k<=T.width-$&&j>=0&&j<=T.height-Y){Ee.bindFramebuffer(F.FRAMEBUFFER,De);let Ve=T.textures[Ce],Qe=Ve.format,pt=Ve.type;T.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=Vr(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.bufferData(F.PIXEL_PACK_BUFFER,Ae.byteLength,F.STREAM_READ),F.readPixels(k,j,$,Y,_e.convert(Qe),_e.convert(pt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let jt=he!==null?He.get(he).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,jt);let Dt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await _x(F,Dt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ae),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(mt),F.deleteSync(Dt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,k=null,j=0){let $=Math.pow(2,-j),Y=Math.floor(T.image.width*$),Ae=Math.floor(T.image.height*$),Ie=k!==null?k.x:0,Ce=k!==null?k.y:0;qe.setTexture2D(T,0),F.copyTexSubImage2D(F.TEXTURE_2D,j,0,0,Ie,Ce,Y,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(T,k,j=null,$=null,Y=0,Ae=0){let Ie,Ce,De,Ve,Qe,pt,ze,mt,jt,Dt=T.isCompressedTexture?T.mipmaps[Ae]:T.image;if(j!==null)Ie=j.max.x-j.min.x,Ce=j.max.y-j.min.y,De=j.isBox3?j.max.z-j.min.z:1,Ve=j.min.x,Qe=j.min.y,pt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-Y);Ie=Math.floor(Dt.width*ut),Ce=Math.floor(Dt.height*ut),T.isDataArrayTexture?De=Dt.depth:T.isData3DTexture?De=Math.floor(Dt.depth*ut):De=1,Ve=0,Qe=0,pt=0}$!==null?(ze=$.x,mt=$.y,jt=$.z):(ze=0,mt=0,jt=0);let Nt=_e.convert(k.format),bn=_e.convert(k.type),Fe;k.isData3DTexture?(qe.setTexture3D(k,0),Fe=F.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(qe.setTexture2DArray(k,0),Fe=F.TEXTURE_2D_ARRAY):(qe.setTexture2D(k,0),Fe=F.TEXTURE_2D),Ee.activeTexture(F.TEXTURE0),Ee.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,k.flipY),Ee.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Ee.pixelStorei(F.UNPACK_ALIGNMENT,k.unpackAlignment);let dn=Ee.getParameter(F.UNPACK_ROW_LENGTH),vt=Ee.getParameter(F.UNPACK_IMAGE_HEIGHT),xs=Ee.getParameter(F.UNPACK_SKIP_PIXELS),fn=Ee.getParameter(F.UNPACK_SKIP_ROWS),Hr=Ee.getParameter(F.UNPACK_SKIP_IMAGES);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,Dt.width),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Dt.height),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,pt);let ji=T.isDataArrayTexture||T.isData3DTexture,_s=k.isDataArrayTexture||k.isData3DTexture;if(T.isDepthTexture){let ut=He.get(T),sn=He.get(k),$n=He.get(ut.__renderTarget),Ut=He.get(sn.__renderTarget);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,$n.__webglFramebuffer),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let pn=0;pn<De;pn++)ji&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(T).__webglTexture,Y,pt+pn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(k).__webglTexture,Ae,jt+pn)),F.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ce,ze,mt,ze+Ie,mt+Ce,F.DEPTH_BUFFER_BIT,F.NEAREST);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||T.isRenderTargetTexture||He.has(T)){let ut=He.get(T),sn=He.get(k);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,N),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,W);for(let $n=0;$n<De;$n++)ji?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ut.__webglTexture,Y,pt+$n):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ut.__webglTexture,Y),_s?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,sn.__webglTexture,Ae,jt+$n):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,sn.__webglTexture,Ae),Y!==0?F.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ce,ze,mt,ze+Ie,mt+Ce,F.COLOR_BUFFER_BIT,F.NEAREST):_s?F.copyTexSubImage3D(Fe,Ae,ze,mt,jt+$n,Ve,Qe,Ie,Ce):F.copyTexSubImage2D(Fe,Ae,ze,mt,Ve,Qe,Ie,Ce);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else _s?T.isDataTexture||T.isData3DTexture?F.texSubImage3D(Fe,Ae,ze,mt,jt,Ie,Ce,De,Nt,bn,Dt.data):k.isCompressedArrayTexture?F.compressedTexSubImage3D(Fe,Ae,ze,mt,jt,Ie,Ce,De,Nt,Dt.data):F.texSubImage3D(Fe,Ae,ze,mt,jt,Ie,Ce,De,Nt,bn,Dt):T.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Ie,Ce,Nt,bn,Dt.data):T.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Dt.width,Dt.height,Nt,Dt.data):F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Ie,Ce,Nt,bn,Dt);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,dn),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,vt),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,xs),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,fn),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,Hr),Ae===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&F.generateMipmap(Fe),Ee.unbindTexture()},this.initRenderTarget=function(T){He.get(T).__webglFramebuffer===void 0&&qe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?qe.setTextureCube(T,0):T.isData3DTexture?qe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?qe.setTexture2DArray(T,0):qe.setTexture2D(T,0),Ee.unbindTexture()},this.resetState=function(){K=0,V=0,he=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Mt._getUnpackColorSpace()}};var s_={type:"change"},Qf={type:"start"},o_={type:"end"},jh=new Lr,r_=new ei,TA=Math.cos(70*Ff.DEG2RAD),Tn=new q,ci=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},jf=1e-6,Qh=class extends Ja{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cr.ROTATE,MIDDLE:cr.DOLLY,RIGHT:cr.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new vi,this._lastTargetPosition=new q,this._quat=new vi().setFromUnitVectors(e.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new zo,this._sphericalDelta=new zo,this._scale=1,this._panOffset=new q,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new q,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=CA.bind(this),this._onPointerDown=AA.bind(this),this._onPointerUp=RA.bind(this),this._onContextMenu=OA.bind(this),this._onMouseWheel=IA.bind(this),this._onKeyDown=DA.bind(this),this._onTouchStart=NA.bind(this),this._onTouchMove=UA.bind(this),this._onMouseDown=PA.bind(this),this._onMouseMove=LA.bind(this),this._interceptControlDown=FA.bind(this),this._interceptControlUp=kA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(s_),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Tn.copy(t).sub(this.target),Tn.applyQuaternion(this._quat),this._spherical.setFromVector3(Tn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ci:i>Math.PI&&(i-=ci),s<-Math.PI?s+=ci:s>Math.PI&&(s-=ci),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Tn.setFromSpherical(this._spherical),Tn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Tn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Tn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Tn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jh.origin.copy(this.object.position),jh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jh.direction))<TA?this.object.lookAt(this.target):(r_.setFromNormalAndCoplanarPoint(this.object.up,this.target),jh.intersectPlane(r_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>jf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>jf||this._lastTargetPosition.distanceToSquared(this.target)>jf?(this.dispatchEvent(s_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ci/60*this.autoRotateSpeed*e:ci/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Tn.setFromMatrixColumn(t,0),Tn.multiplyScalar(-e),this._panOffset.add(Tn)}_panUp(e,t){this.screenSpacePanning===!0?Tn.setFromMatrixColumn(t,1):(Tn.setFromMatrixColumn(t,0),Tn.crossVectors(this.object.up,Tn)),Tn.multiplyScalar(e),this._panOffset.add(Tn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Tn.copy(s).sub(this.target);let r=Tn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ci*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ci*this._rotateDelta.x/t.clientHeight),this._rotateUp(ci*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function AA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function CA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function RA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(o_),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function PA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case cr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pt.DOLLY;break;case cr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}break;case cr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Qf)}function LA(n){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function IA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(n.preventDefault(),this.dispatchEvent(Qf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(o_))}function DA(n){this.enabled!==!1&&this._handleKeyDown(n)}function NA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(n),this.state=Pt.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(n),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pt.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Qf)}function UA(n){switch(this._trackPointer(n),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pt.NONE}}function OA(n){this.enabled!==!1&&n.preventDefault()}function FA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function kA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var BA=.88,eu=class{constructor(e,t,i){this.low=e;this.high=t;this.renderer=new Zh({antialias:!0,alpha:!0}),this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","img"),this.camera.up.set(0,0,1);let s=new Za(16777215,2.2);s.position.set(-.6,.9,.8),this.camera.add(s),this.scene.add(this.camera,new Ka(16777215,1.3)),this.controls=new Qh(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>this.controls.enableZoom=!0,{signal:i}),this.canvas.addEventListener("blur",()=>this.controls.enableZoom=!1,{signal:i}),this.canvas.addEventListener("keydown",r=>this.key(r),{signal:i}),this.controls.addEventListener("change",()=>this.draw()),this.controls.addEventListener("start",()=>this.view=null),this.watcher=new ResizeObserver(()=>this.draw()),this.watcher.observe(this.canvas),this.look(-60,30),i.addEventListener("abort",()=>this.end())}low;high;canvas;renderer;scene=new ka;camera=new ti(32,1,.1,1e3);controls;named=new Map;plane=new ei(new q(0,0,-1),0);watcher;isCut=!1;view=null;frame=0;end(){cancelAnimationFrame(this.frame),this.watcher.disconnect(),this.controls.dispose();for(let e of[...this.named.keys()])this.remove(e);this.renderer.dispose(),this.renderer.forceContextLoss()}look(e,t){this.view=[e,t];let i=new q(...this.low).add(new q(...this.high)).multiplyScalar(.5),s=.5*Math.hypot(...this.high.map((c,h)=>c-this.low[h])),[r,o]=[e,Math.min(Math.max(t,-89.9),89.9)].map(c=>c*Math.PI/180),a=this.camera.fov*Math.PI/360,l=s/Math.sin(Math.min(a,Math.atan(Math.tan(a)*this.camera.aspect)))*BA;this.camera.near=s/50,this.camera.far=30*s,this.controls.target.copy(i),this.camera.position.set(Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)).multiplyScalar(l).add(i),this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}mesh(e,t,i){if(this.remove(e),t.triangles.length===0)return;let s=new Mi;s.setAttribute("position",new Hn(t.corners,3)),s.setIndex(new Hn(t.triangles,1)),s.computeVertexNormals(),i.colors&&s.setAttribute("color",new Hn(VA(i.colors),3));let r=i.opacity!==void 0&&i.opacity<1,o=new ko({vertexColors:i.colors!==void 0,side:ai,transparent:r,opacity:i.opacity??1,depthWrite:!r});i.color!==void 0&&(o.color=new ct().setRGB(...Jr(i.color),Nn)),o.clippingPlanes=this.isCut&&i.whole!==!0?[this.plane]:[],o.userData.whole=i.whole===!0,this.add(e,new oi(s,o))}walls(e,t,i){this.remove(e);let s=new Rs,r=new ct().setRGB(...Jr(i),Nn);for(let{points:o,low:a,high:l}of t){for(let f of[a,l]){let g=new Mi().setFromPoints(o.map(([x,p])=>new q(x,p,f)));s.add(new Va(g,new Oo({color:r,transparent:!0,opacity:.55})))}let c=new Float32Array(o.flatMap(([f,g])=>[f,g,a,f,g,l])),h=o.length,u=Uint32Array.from(o.flatMap((f,g)=>[0,2,1,1,2,3].map(x=>(2*g+x)%(2*h)))),d=new Mi;d.setAttribute("position",new Hn(c,3)),d.setIndex(new Hn(u,1)),s.add(new oi(d,new Ir({color:r,transparent:!0,opacity:.06,side:ai,depthWrite:!1})))}this.add(e,s)}cut(e,t,i){if(this.remove("cut"),this.isCut=e!==null,e!==null){let s=new q().setComponent(e,e===1?1:-1);this.plane.set(s,e===1?-t:t),i&&this.add("cut",zA(e,t,i))}this.scene.traverse(s=>{let r=s.material;r instanceof ko&&(r.clippingPlanes=this.isCut&&r.userData.whole!==!0?[this.plane]:[])}),this.draw()}remove(e){let t=this.named.get(e);t&&(this.scene.remove(t),this.named.delete(e),t.traverse(i=>{let s=i;s.geometry?.dispose();let r=s.material;r?.map?.dispose(),r?.dispose()}),this.draw())}add(e,t){this.named.set(e,t),this.scene.add(t),this.draw()}draw(){this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0;let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];if(e===0||t===0)return;let i=Math.min(window.devicePixelRatio||1,2);(this.canvas.width!==Math.round(e*i)||this.canvas.height!==Math.round(t*i))&&(this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.view&&this.look(...this.view)),this.renderer.render(this.scene,this.camera)}))}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=this.camera.position.clone().sub(this.controls.target),i=t.length(),[s,r]=[Math.atan2(t.y,t.x),Math.asin(t.z/i)].map(l=>l*180/Math.PI),o={ArrowLeft:[-10,0],ArrowRight:[10,0],ArrowUp:[0,10],ArrowDown:[0,-10]},a={"+":.85,"=":.85,"-":1/.85};if(e.key in o){let[l,c]=[s+o[e.key][0],Math.min(Math.max(r+o[e.key][1],-89.9),89.9)].map(h=>h*Math.PI/180);this.camera.position.set(Math.cos(l)*Math.cos(c),Math.sin(l)*Math.cos(c),Math.sin(c)).multiplyScalar(i).add(this.controls.target)}else if(e.key in a)this.camera.position.copy(t.multiplyScalar(a[e.key]).add(this.controls.target));else if(e.key==="0")this.look(-60,30);else return;e.preventDefault(),e.key!=="0"&&(this.view=null),this.controls.update(),this.draw()}};function zA(n,e,{pixels:t,width:i,height:s,pitch:r,corner:o}){let[a,l]=Jn[n],c=new Uint32Array(t.length);for(let f=0;f<s;f++)c.set(t.subarray((s-1-f)*i,(s-f)*i),f*i);let h=new Uo(new Uint8Array(c.buffer),i,s,wi);h.colorSpace=Nn,h.magFilter=h.minFilter=yn,h.needsUpdate=!0;let u=new Dr(1,1),d=u.getAttribute("position");for(let f=0;f<d.count;f++){let[g,x]=[d.getX(f)+.5,d.getY(f)+.5],p=new q().setComponent(n,e);p.setComponent(a,o[0]+g*i*r[0]).setComponent(l,o[1]+(x-1)*s*r[1]),d.setXYZ(f,p.x,p.y,p.z)}return new oi(u,new Ir({map:h,side:ai,alphaTest:.5}))}function VA(n){let e=new Map,t=new Float32Array(3*n.length),i=new ct;return n.forEach((s,r)=>{let o=e.get(s);o||(i.setRGB(...Jr(s),Nn),o=[i.r,i.g,i.b],e.set(s,o)),t.set(o,3*r)}),t}var a_=`"use strict";(()=>{function S(a,e){let{pitch:t,low:r}=a,[s,l,o]=a.shape.map(g=>g+2),u=C(a,e),n=s*l,h=Int32Array.from({length:8},(g,y)=>(y&1)+(y>>1&1)*s+(y>>2)*n),i=[1,s,n],f=2*n,c=new Int32Array(f),d=new k(Float32Array),F=new k(Uint32Array),m=new Float32Array(8),v=new Float64Array(3),b=0;for(let g=0;g+1<o;g++)for(let y=0;y+1<l;y++)for(let w=0;w+1<s;w++){let A=w+s*y+n*g,M=0;for(let p=0;p<8;p++)m[p]=u[A+h[p]],m[p]>=0&&(M|=1<<p);if(M===0||M===255)continue;D(m,M,v),d.push3(r[0]+(w+v[0]-.5)*t[0],r[1]+(y+v[1]-.5)*t[1],r[2]+(g+v[2]-.5)*t[2]),c[A%f]=b;let x=(M&1)!==0;for(let p=0;p<3;p++){if(x===u[A+i[p]]>=0||p!==0&&w===0||p!==1&&y===0||p!==2&&g===0)continue;let O=i[(p+1)%3],T=i[(p+2)%3],B=c[(A-O)%f],z=c[(A-O-T)%f],E=c[(A-T)%f];x?(F.push3(b,B,z),F.push3(b,z,E)):(F.push3(b,z,B),F.push3(b,E,z))}b++}return{corners:d.taken(),triangles:F.taken()}}function C({codes:a,values:e,shape:t},r){let[s,l,o]=t,u=new Float32Array((s+2)*(l+2)*(o+2)).fill(-1e6),n=e.map(i=>Number.isNaN(i)?-1e6:i-r),h=0;for(let i=0;i<o;i++)for(let f=0;f<l;f++){let c=1+(s+2)*(f+1+(l+2)*(i+1));for(let d=0;d<s;d++)u[c++]=n[a[h++]]}return u}var R=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function D(a,e,t){let r=0,s=0,l=0,o=0;for(let u=0;u<24;u+=2){let n=R[u],h=R[u+1];if((e>>n&1)===(e>>h&1))continue;let i=a[n]/(a[n]-a[h]);r+=(n&1)+i*((h&1)-(n&1)),s+=(n>>1&1)+i*((h>>1&1)-(n>>1&1)),l+=(n>>2)+i*((h>>2)-(n>>2)),o++}t[0]=r/o,t[1]=s/o,t[2]=l/o}var _=8,U=class{constructor(e,{shape:t,pitch:r,low:s}){this.mesh=e;this.normals=G(e),this.size=2*Math.max(...r),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(n=>Math.ceil(t[n]*r[n]/this.size)+2);let l=e.corners.length/3,o=Uint32Array.from({length:l},(n,h)=>this.cellOf(e.corners,h));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let n of o)this.starts[n+1]++;for(let n=1;n<this.starts.length;n++)this.starts[n]+=this.starts[n-1];let u=this.starts.slice();this.order=new Uint32Array(l),o.forEach((n,h)=>{this.order[u[n]++]=h})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let r=0;r<t.length;r++)t[r]=this.off(e[3*r],e[3*r+1],e[3*r+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,r){let{corners:s}=this.mesh,[l,o,u]=this.cells,n=this.place(e,0),h=this.place(t,1),i=this.place(r,2),f=Number.POSITIVE_INFINITY,c=-1;for(let m=0;m<=_&&!(c>=0&&f<=((m-1)*this.size)**2);m++)for(let v=Math.max(i-m,0);v<=Math.min(i+m,u-1);v++)for(let b=Math.max(h-m,0);b<=Math.min(h+m,o-1);b++){let g=Math.abs(v-i)===m||Math.abs(b-h)===m;for(let y=n-m;y<=n+m;y+=g||m===0?1:2*m){if(y<0||y>=l)continue;let w=y+l*(b+o*v);for(let A=this.starts[w];A<this.starts[w+1];A++){let M=3*this.order[A],x=(s[M]-e)**2+(s[M+1]-t)**2+(s[M+2]-r)**2;x<f&&(f=x,c=M)}}}if(c<0)return _*this.size;let d=(e-s[c])*this.normals[c]+(t-s[c+1])*this.normals[c+1]+(r-s[c+2])*this.normals[c+2],F=Math.sqrt(f);return F<=this.size?d:Math.sign(d)*F}};function G({corners:a,triangles:e}){let t=new Float32Array(a.length);for(let r=0;r<e.length;r+=3){let[s,l,o]=[3*e[r],3*e[r+1],3*e[r+2]],[u,n,h]=[a[l]-a[s],a[l+1]-a[s+1],a[l+2]-a[s+2]],[i,f,c]=[a[o]-a[s],a[o+1]-a[s+1],a[o+2]-a[s+2]];for(let d of[s,l,o])t[d]+=n*c-h*f,t[d+1]+=h*i-u*c,t[d+2]+=u*f-n*i}for(let r=0;r<t.length;r+=3){let s=Math.hypot(t[r],t[r+1],t[r+2])||1;for(let l=0;l<3;l++)t[r+l]/=s}return t}var k=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,r){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=r}taken(){return this.array.slice(0,this.used)}};var N=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],I();case"print":{if(!this.response)return I();let t=S(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:I()}case"part":{let{samples:t,code:r}=e;return{...S({...t,values:Float32Array.from(t.values,(s,l)=>l===r?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=S(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new U(e,this.target)),this.distance}};function I(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let a=new N;self.addEventListener("message",e=>{let t=a.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}})();
`;function iu(n,e){let{pitch:t,low:i}=n,[s,r,o]=n.shape.map(b=>b+2),a=GA(n,e),l=s*r,c=Int32Array.from({length:8},(b,C)=>(C&1)+(C>>1&1)*s+(C>>2)*l),h=[1,s,l],u=2*l,d=new Int32Array(u),f=new nu(Float32Array),g=new nu(Uint32Array),x=new Float32Array(8),p=new Float64Array(3),m=0;for(let b=0;b+1<o;b++)for(let C=0;C+1<r;C++)for(let S=0;S+1<s;S++){let R=S+s*C+l*b,A=0;for(let E=0;E<8;E++)x[E]=a[R+c[E]],x[E]>=0&&(A|=1<<E);if(A===0||A===255)continue;WA(x,A,p),f.push3(i[0]+(S+p[0]-.5)*t[0],i[1]+(C+p[1]-.5)*t[1],i[2]+(b+p[2]-.5)*t[2]),d[R%u]=m;let y=(A&1)!==0;for(let E=0;E<3;E++){if(y===a[R+h[E]]>=0||E!==0&&S===0||E!==1&&C===0||E!==2&&b===0)continue;let B=h[(E+1)%3],U=h[(E+2)%3],D=d[(R-B)%u],H=d[(R-B-U)%u],G=d[(R-U)%u];y?(g.push3(m,D,H),g.push3(m,H,G)):(g.push3(m,H,D),g.push3(m,G,H))}m++}return{corners:f.taken(),triangles:g.taken()}}function GA({codes:n,values:e,shape:t},i){let[s,r,o]=t,a=new Float32Array((s+2)*(r+2)*(o+2)).fill(-1e6),l=e.map(h=>Number.isNaN(h)?-1e6:h-i),c=0;for(let h=0;h<o;h++)for(let u=0;u<r;u++){let d=1+(s+2)*(u+1+(r+2)*(h+1));for(let f=0;f<s;f++)a[d++]=l[n[c++]]}return a}var l_=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function WA(n,e,t){let i=0,s=0,r=0,o=0;for(let a=0;a<24;a+=2){let l=l_[a],c=l_[a+1];if((e>>l&1)===(e>>c&1))continue;let h=n[l]/(n[l]-n[c]);i+=(l&1)+h*((c&1)-(l&1)),s+=(l>>1&1)+h*((c>>1&1)-(l>>1&1)),r+=(l>>2)+h*((c>>2)-(l>>2)),o++}t[0]=i/o,t[1]=s/o,t[2]=r/o}var c_=8,tu=class{constructor(e,{shape:t,pitch:i,low:s}){this.mesh=e;this.normals=XA(e),this.size=2*Math.max(...i),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(l=>Math.ceil(t[l]*i[l]/this.size)+2);let r=e.corners.length/3,o=Uint32Array.from({length:r},(l,c)=>this.cellOf(e.corners,c));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let l of o)this.starts[l+1]++;for(let l=1;l<this.starts.length;l++)this.starts[l]+=this.starts[l-1];let a=this.starts.slice();this.order=new Uint32Array(r),o.forEach((l,c)=>{this.order[a[l]++]=c})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let i=0;i<t.length;i++)t[i]=this.off(e[3*i],e[3*i+1],e[3*i+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,i){let{corners:s}=this.mesh,[r,o,a]=this.cells,l=this.place(e,0),c=this.place(t,1),h=this.place(i,2),u=Number.POSITIVE_INFINITY,d=-1;for(let x=0;x<=c_&&!(d>=0&&u<=((x-1)*this.size)**2);x++)for(let p=Math.max(h-x,0);p<=Math.min(h+x,a-1);p++)for(let m=Math.max(c-x,0);m<=Math.min(c+x,o-1);m++){let b=Math.abs(p-h)===x||Math.abs(m-c)===x;for(let C=l-x;C<=l+x;C+=b||x===0?1:2*x){if(C<0||C>=r)continue;let S=C+r*(m+o*p);for(let R=this.starts[S];R<this.starts[S+1];R++){let A=3*this.order[R],y=(s[A]-e)**2+(s[A+1]-t)**2+(s[A+2]-i)**2;y<u&&(u=y,d=A)}}}if(d<0)return c_*this.size;let f=(e-s[d])*this.normals[d]+(t-s[d+1])*this.normals[d+1]+(i-s[d+2])*this.normals[d+2],g=Math.sqrt(u);return g<=this.size?f:Math.sign(f)*g}};function XA({corners:n,triangles:e}){let t=new Float32Array(n.length);for(let i=0;i<e.length;i+=3){let[s,r,o]=[3*e[i],3*e[i+1],3*e[i+2]],[a,l,c]=[n[r]-n[s],n[r+1]-n[s+1],n[r+2]-n[s+2]],[h,u,d]=[n[o]-n[s],n[o+1]-n[s+1],n[o+2]-n[s+2]];for(let f of[s,r,o])t[f]+=l*d-c*u,t[f+1]+=c*h-a*d,t[f+2]+=a*u-l*h}for(let i=0;i<t.length;i+=3){let s=Math.hypot(t[i],t[i+1],t[i+2])||1;for(let r=0;r<3;r++)t[i+r]/=s}return t}var nu=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,i){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=i}taken(){return this.array.slice(0,this.used)}};var hl=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],ep();case"print":{if(!this.response)return ep();let t=iu(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:ep()}case"part":{let{samples:t,code:i}=e;return{...iu({...t,values:Float32Array.from(t.values,(s,r)=>r===i?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=iu(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new tu(e,this.target)),this.distance}};function ep(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let n=new hl;self.addEventListener("message",e=>{let t=n.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}var su=class{worker;local=new hl;last=Promise.resolve();constructor(e){this.worker=$A(),e.addEventListener("abort",()=>this.worker?.terminate())}ask(e){let t=this.last.then(()=>this.worker?qA(this.worker,e):YA().then(()=>this.local.answer(e)));return this.last=t.catch(()=>{}),t}};function ru(n){let e=[0,1,2].map(t=>n.range(t)[0]);return{codes:n.codes,values:n.values,shape:n.shape,pitch:n.pitch,low:e}}function $A(){try{return new Worker(URL.createObjectURL(new Blob([a_],{type:"text/javascript"})))}catch{return null}}function qA(n,e){return new Promise((t,i)=>{n.onmessage=s=>t(s.data),n.onerror=s=>i(new Error(`The surface could not be made: ${s.message}`)),n.postMessage(e)})}function YA(){return new Promise(n=>setTimeout(n,20))}var d_={id:"solid",title:"In 3D",render:n=>!(t=>n.run.volumes.some(i=>i.kind===t))("target")&&!n.run.surface?null:document.createElement("canvas").getContext("webgl2")===null?jr("This browser has no WebGL 2, so print and target cannot be shown in 3D. The slices above show the same volumes."):ZA(n,()=>Ci(n,KA))};function ZA({gone:n},e){let t=v("div.solid-place"),i=new IntersectionObserver(s=>{s.some(({isIntersecting:r})=>r)&&(i.disconnect(),t.replaceChildren(e()))},{rootMargin:"300px"});return i.observe(t),n.addEventListener("abort",()=>i.disconnect()),t}async function KA(n){let{volumes:e,problems:t}=await aa(n,Bi(n)),i=e.response??e.target;if(!i)throw new Error(t.join(" ")||"The run has no volume to show.");return new tp(n,e,i).element(t)}var JA=.95,h_=40,jA=120,u_=[["","Print"],["both","Print and target"],["target","Target"]],tp=class{constructor(e,t,i){this.context=e;this.volumes=t;this.grid=i;this.reported=this.thresholdOf(t);let[s,r]=sC(t.target??i,i);this.stage=new eu(s,r,e.gone),this.stage.canvas.setAttribute("aria-label","Surfaces of print and target. Arrow keys turn the view, + and − zoom, 0 looks from the front again."),this.client=new su(e.gone)}context;volumes;grid;stage;client;legend=v("div.color-legend");note=v("p.quiet",{role:"status"});reported;newest=0;async element(e){return this.listen(["threshold"],()=>this.attempt(this.showPrint())),this.listen(["threshold","at","cut"],()=>this.showCut()),this.listen(["solid"],()=>this.showAll()),this.listen(["species"],()=>this.attempt(this.changeSpecies())),await this.load(),this.showAll(),v("div.solid",{},...e.map(jr),v("p.quiet",{},"Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. The cut goes through the point that the planes above show."),this.controls(),this.stage.canvas,v("div.below-planes",{},this.note,this.legend))}get level(){return this.reported===null||!this.volumes.response?null:this.context.state.get("threshold")??this.reported}thresholdOf({response:e,labels:t}){let{run:i}=this.context;return Sl(i)===null?wl(i,Bi(this.context),e,t)?.reported??null:null}get mode(){let e=this.context.state.get("solid");return this.level===null?"target":u_.some(([t])=>t===e)?e:""}get official(){let{run:e,state:t}=this.context,i=Bi(this.context)===""||Bi(this.context)===oa(e)[0];return t.get("threshold")===null&&i&&e.surface!==null&&e.surface.triangles>0?e.surface:null}load(){let{response:e,target:t}=this.volumes;return this.client.ask({kind:"load",response:e&&ru(e),target:t&&ru(t)})}async changeSpecies(){this.volumes=(await aa(this.context,Bi(this.context))).volumes,this.reported=this.thresholdOf(this.volumes),await this.load(),this.showAll()}showAll(){this.attempt(this.showPrint()),this.attempt(this.showTarget()),this.showCut()}async showPrint(){let e=++this.newest,{level:t,official:i,stage:s,note:r}=this;if(this.mode==="target"||t===null){s.remove("print"),this.legend.replaceChildren(si({keys:[["var(--solid)","target"]]})),r.textContent="";return}if(r.textContent="Making the surface…",i||await new Promise(d=>setTimeout(d,jA)),e!==this.newest)return;let{mesh:o,off_um:a}=i?await this.ofCommand(i):await this.atLevel(t);if(e!==this.newest||this.context.gone.aborted)return;let l=a?iC(a):0,c=a&&Uint32Array.from(a,d=>Kr(Math.round(h_*(.5+d/(2*l)))/h_));s.mesh("print",o,c?{colors:c}:{color:kn("--solid")});let h={scale:{low:-l,high:l,logarithmic:!1,map:Kr},label:"deviation from the target, µm: blue is too small, red too large",mark:null};this.legend.replaceChildren(si(a?h:{keys:[["var(--solid)","print"]]}));let u=i?"The surface at the report’s threshold.":`The surface at a threshold of ${le(t,3)}, from the page’s voxels.`;r.textContent=o.triangles.length===0?"At this threshold nothing is solid.":u}async ofCommand(e){let t=await this.context.store.surface(e);return{mesh:t,off_um:t.off_um}}async atLevel(e){let t=await this.client.ask({kind:"print",level:e});return{mesh:t,off_um:t.off&&t.off.map(i=>1e3*i)}}async showTarget(){if(this.mode==="")return this.stage.remove("target");let e=await this.client.ask({kind:"target"});this.context.gone.aborted||this.mode===""||this.stage.mesh("target",e,{color:kn("--solid"),opacity:this.mode==="both"?.3:1})}showCut(){let{state:e}=this.context,t=rs.indexOf(e.get("cut"));if(t<0)return this.stage.cut(null,0,null);let i=(e.get("at")??this.grid.center)[t];this.stage.cut(t,i,eC(this.volumes,t,i,this.mode==="target"?null:this.level))}controls(){let{stage:e}=this,{run:t,state:i}=this.context,s=(a,l,c)=>v("button",{type:"button",click:()=>e.look(l,c)},a),r=[["","Whole"],["x","Cut along x"],["y","Cut along y"],["z","Cut along z"]],o=Iu(t,Bi(this.context)).evaluation?.farthest?.at_xyz_mm;return v("div.controls",{},this.level!==null&&Kn("Surface",u_,()=>this.mode,a=>i.set({solid:a}),a=>this.listen(["solid"],a)),Kn("Cut",r,()=>i.get("cut"),a=>i.set({cut:a}),a=>this.listen(["cut"],a)),v("span.views",{},s("From the front",-60,30),s("From behind, below",120,-30),s("From above",-90,89.9)),...this.extras(),o?.length===3&&v("button",{type:"button",click:()=>i.set({at:o,cut:i.get("cut")||"y"})},"Cut at the largest deviation"))}extras(){let{stage:e,client:t}=this,{bodies:i}=this.volumes,{scene:s}=this.context.run,o=(i?QA.filter(({code:a})=>i.codes.includes(a)):[]).map(({code:a,text:l,color:c})=>{let h=async()=>e.mesh(l,await t.ask({kind:"part",samples:ru(i),code:a}),{color:kn(c),opacity:.75});return this.attempt(h()),ra(l,!0,u=>u?this.attempt(h()):e.remove(l))});if(s&&s.walls.length>0){let[a,l]=s.z_mm,c=s.walls.map(({points:h,height_mm:u})=>({points:h,low:u?.[0]??a,high:u?.[1]??l}));o.push(ra("vial",!1,h=>h?e.walls("vial",c,kn("--quiet")):e.remove("vial")))}return o}attempt(e){e.catch(t=>this.note.textContent=sa(t))}listen(e,t){this.context.gone.addEventListener("abort",this.context.state.on(e,t))}},QA=[{code:$s.insert,text:"insert",color:"--ink"},{code:$s.dark,text:"bodies that stay dark",color:"--void"},{code:$s.obstacle,text:"obstacles",color:"--quiet"}];function eC({response:n,target:e},t,i,s){let r=s===null?e:n,o=r?.slice(t,i);if(!r||!o)return null;let a={low:0,high:r.info.high,logarithmic:!1,map:is},l=kn("--solid"),c=Uint32Array.from({length:256},(u,d)=>is(d/255));return nC(o,s??.5,u=>s===null?l:c[Math.round(255*Math.min(Math.max(xr(a,u),0),1))])}var tC=640;function nC(n,e,t){let{width:i,height:s,codes:r,values:o}=n,a=Math.max(1,Math.round(tC/Math.max(i,s))),l=new Uint32Array(i*a*s*a),c=(h,u)=>{let d=o[r[Math.min(Math.max(u,0),s-1)*i+Math.min(Math.max(h,0),i-1)]];return Number.isNaN(d)?0:d};for(let h=0,u=0;h<s*a;h++){let d=(h+.5)/a-.5,f=Math.floor(d);for(let g=0;g<i*a;g++,u++){let x=(g+.5)/a-.5,p=Math.floor(x),m=c(p,f)+(x-p)*(c(p+1,f)-c(p,f)),b=c(p,f+1)+(x-p)*(c(p+1,f+1)-c(p,f+1)),C=m+(d-f)*(b-m);C>=e&&(l[u]=t(C))}}return{...n,pixels:l,width:i*a,height:s*a,pitch:[n.pitch[0]/a,n.pitch[1]/a]}}function iC(n){let e=n.map(Math.abs).sort(),t=Math.max(e[Math.min(Math.floor(e.length*JA),e.length-1)]??1,.001),i=10**Math.floor(Math.log10(t));return([1,1.2,1.5,2,2.5,3,4,5,6,8,10].find(s=>s*i>=t*(1-1e-6))??10)*i}function sC(n,e){let{codes:t,values:i,shape:s}=n,r=i.map(u=>+(u>=.5)),[o,a]=[[...s],[-1,-1,-1]],l=0;for(let u=0;u<s[2];u++)for(let d=0;d<s[1];d++)for(let f=0;f<s[0];f++,l++)r[t[l]]!==0&&[f,d,u].forEach((g,x)=>{g<o[x]&&(o[x]=g),g>a[x]&&(a[x]=g)});let c=a[0]<0?e:n;return(a[0]<0?[[0,0,0],e.shape.map(u=>u-1)]:[o,a]).map(u=>u.map((d,f)=>c.middle(f,d)))}var ou={run:0,section:"",species:"",layer:"",plane:"",at:null,threshold:null,light:0,frame:0,row:null,time:null,solid:"",cut:"",opened:null,marked:[],metric:"",x:"",y:"",plot:"",levels:""},au=class{constructor(e=window.location){this.location=e;this.view={...ou,...this.read()},window.addEventListener("hashchange",()=>this.set(this.read()))}location;view;listeners=new Set;writing=0;read(){let e=this.location.hash;return e!==""&&!e.includes("=")?{section:decodeURIComponent(e.slice(1))}:oC(e)}get(e){return this.view[e]}set(e){let t=Object.keys(e).filter(i=>!f_(this.view[i],e[i]));if(t.length!==0){this.view={...this.view,...e};for(let i of[...this.listeners])i.keys.some(s=>t.includes(s))&&i.call();this.write()}}on(e,t){let i={keys:e,call:t};return this.listeners.add(i),()=>this.listeners.delete(i)}write(){window.clearTimeout(this.writing),this.writing=window.setTimeout(()=>{let e=rC(this.view);e!==this.location.hash.replace(/^#/,"")&&history.replaceState(null,"",`#${e}`)},150)}};function rC(n){let e=[];for(let t of Object.keys(ou)){let i=n[t];i===null||f_(i,ou[t])||e.push(`${t}=${Array.isArray(i)?i.map(s=>+s.toFixed(4)).join(","):encodeURIComponent(String(i))}`)}return e.join("&")}function oC(n){let e=new URLSearchParams(n.replace(/^#/,"")),t={...ou},i=o=>{let a=Number(e.get(o)??"0");return Number.isInteger(a)&&a>=0?a:0},s=o=>{let a=e.get(o);return a!==null&&a!==""&&Number.isFinite(Number(a))?Number(a):null};t.run=i("run"),t.light=i("light"),t.frame=i("frame");for(let o of["section","species","layer","plane","solid","cut","metric","x","y","plot","levels"])t[o]=e.get(o)??"";t.threshold=s("threshold"),t.row=s("row"),t.time=s("time"),t.opened=i("opened")||null,t.marked=(e.get("marked")??"").split(",").map(Number).filter(o=>Number.isInteger(o)&&o>0);let r=e.get("at")?.split(",").map(Number)??[];return r.length===3&&r.every(Number.isFinite)&&(t.at=[r[0],r[1],r[2]]),t}function f_(n,e){return n===e||Array.isArray(n)&&Array.isArray(e)&&n.length===e.length&&n.every((t,i)=>t===e[i])}var Yo=class{constructor(e,t){this.served=e;this.run=t}served;run;cache=new Map;volume(e){return this.once(e.id,async()=>{let[t,i,s]=e.shape_zyx,r=await this.bytes("volume",e.id,t*i*s*e.bits/8);return new yl(e,e.bits===16?new Uint16Array(r.buffer):r)})}film(e){return this.once(e.id,async()=>({info:e,values:await this.bytes("film",e.id,e.frames*e.rows*e.columns)}))}surface(e){return this.once(e.id,async()=>cC(e,await this.bytes("volume",e.id,e.vertices*8+e.triangles*12)))}async slice(e,t,i,s){let r=await fetch(`${this.served}run/${this.run}/slice/${e.id}?axis=${t}&index=${i}`,{signal:s});if(!r.ok)throw new Error(`the viewer answered ${r.status}`);let o=new Uint8Array(await r.arrayBuffer()),a=o.indexOf(10),l=JSON.parse(new TextDecoder().decode(o.subarray(0,a))),c=o.slice(a+1);return{...l,codes:l.bits===16?new Uint16Array(c.buffer):c}}once(e,t){let i=this.cache.get(e);return i||(i=t(),this.cache.set(e,i)),i}async bytes(e,t,i){let s;try{s=await aC(await this.packed(e,t))}catch(r){throw new Error(`The array “${t}” is damaged or missing: ${r instanceof Error?r.message:String(r)}.`)}if(s.length!==i)throw new Error(`The array “${t}” is damaged: ${s.length.toLocaleString("en")} bytes where ${i.toLocaleString("en")} are expected.`);return s}async packed(e,t){if(this.served!==null){let s=await fetch(`${this.served}run/${this.run}/${e}/${t}`);if(!s.ok)throw new Error(`the viewer answered ${s.status}`);return s.arrayBuffer()}let i=document.getElementById(`blob-${this.run}-${t}`);if(!i)throw new Error("the page has no such element");return lC(i.textContent??"")}};async function aC(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate-raw"));try{return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new Error("it cannot be unpacked")}}function lC(n){let e;try{e=atob(n)}catch{throw new Error("it is no base64")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}function cC(n,e){let t=new DataView(e.buffer),i=n.vertices,s=new Float32Array(3*i);for(let a=0;a<s.length;a++){let l=a%3;s[a]=n.low_mm[l]+t.getUint16(2*a,!0)/65535*(n.high_mm[l]-n.low_mm[l])}let r=new Float32Array(i);for(let a=0;a<i;a++)r[a]=t.getInt16(6*i+2*a,!0)/32767*n.off_um[1];let o=new Uint32Array(3*n.triangles);for(let a=0;a<o.length;a++)o[a]=t.getUint32(8*i+4*a,!0);if(o.some(a=>a>=i))throw new Error(`The array “${n.id}” is damaged: a triangle names a corner that is not there.`);return{corners:s,off_um:r,triangles:o}}var np=[...Yl.map(({id:n})=>n),"head","limits","warnings","look","solid","in-time","time","film"],ip=dC([Hp,d_,Np,Ip,...i0]),p_=["history","histories"],hC=700,uC=6e3;function dC(n){let e=t=>(np.indexOf(t.id)+np.length+1)%(np.length+1);return[...n].sort((t,i)=>e(t)-e(i))}var sp=class{constructor(e,t){this.data=e;this.app=t;this.stores=e.runs.map((i,s)=>new Yo(e.served,s)),this.state.on(["run"],()=>this.draw()),this.progress=Up(e,{row:i=>this.grow(i),replaced:i=>{this.replace(i).catch(s=>console.warn(String(s)))}}),this.sweep=e.sweep&&new nc(e,e.sweep,this.state,i=>this.open(i)),this.draw(),this.stayAt(this.state.get("section")||(this.state.get("opened")===null?"":"opened"))}data;app;state=new au;progress;stores;ends=new Map;redrawing=0;sweep;opened=null;stayAt(e){if(e==="")return;Js(e);let t=new ResizeObserver(()=>document.getElementById(e)?.scrollIntoView()),i=()=>t.disconnect();t.observe(this.app),window.setTimeout(i,uC);for(let s of["wheel","pointerdown","keydown","touchstart"])window.addEventListener(s,i,{once:!0,passive:!0})}get index(){return this.sweep?this.opened:this.data.runs.length===0?null:Math.min(this.state.get("run"),this.data.runs.length-1)}async open(e){let t=this.begin("opening");if(this.opened!==null&&(this.opened=null,this.draw()),e===null)return;let i=await Op(this.data,e),{runs:s}=await Lu(this.data);t.aborted||(this.data.runs.push(...s.slice(this.data.runs.length)),this.stores=this.data.runs.map((r,o)=>this.stores[o]??new Yo(this.data.served,o)),this.opened=i,this.draw())}draw(){for(let r of ip)this.ends.get(r.id)?.abort();let e=ip.flatMap(r=>{let o=this.mount(r);return o?[{section:r,element:o}]:[]}),t=e.map(({section:r})=>r).filter(({title:r})=>r!==""),i=Hg([...this.sweep?.entries??[],...t],this.state,this.begin("nav")),s=[this.progress,...this.sweep?.sections??[]].filter(r=>r!==null);for(let r of[...this.app.children])s.includes(r)||r.remove();this.app.append(...s.filter(r=>!r.isConnected),...e.map(({element:r})=>r)),this.progress?this.progress.after(i):this.app.prepend(i),this.index===null&&!this.sweep&&this.app.append(v("p.problem",{},"There is no run to show."))}begin(e){this.ends.get(e)?.abort();let t=new AbortController;return this.ends.set(e,t),t.signal}mount(e){let{index:t,state:i,sweep:s}=this;if(t===null)return null;let r=this.data.runs[t],[o,a]=s?[{...this.data,runs:[r]},[this.stores[t]]]:[this.data,this.stores],l={data:o,run:r,index:s?0:t,state:i,store:this.stores[t],stores:a,gone:this.begin(e.id)},c;try{c=e.render(l)}catch(h){c=v("p.problem",{role:"alert"},`This section could not be drawn: ${String(h)}`)}return c===null?null:v("section",{id:e.id,"aria-label":e.title||null},e.title!==""&&v("h2",{},e.title),c)}grow(e){this.redrawing!==0||e!==this.index&&this.data.runs.length===1||(this.redrawing=window.setTimeout(()=>{this.redrawing=0,this.redraw(p_)},hC))}async replace(e){let t=await Lu(this.data);this.data.runs[e]=t.runs[e],this.stores[e]=new Yo(this.data.served,e),!(e!==this.index&&this.data.runs.length===1)&&(t.runs[e].state==="running"?this.redraw([...p_,"look"]):this.draw())}redraw(e){let t=document.activeElement?.getAttribute("aria-label")??null;for(let i of ip.filter(({id:s})=>e.includes(s))){let s=document.getElementById(i.id),r=this.mount(i);if(s&&r)s.replaceWith(r);else if(r)return this.draw()}t!==null&&window.setTimeout(()=>document.querySelector(`[aria-label="${CSS.escape(t)}"]`)?.focus({preventScroll:!0}),50)}};function fC(n){let e="tomolith.page/1";if(n?.schema!==e)throw new Error(`their schema is “${n?.schema??"missing"}”; this page shows “${e}”.`);if(!Array.isArray(n.runs))throw new Error("the list of runs is missing.");return n}function pC(){let n=document.getElementById("app"),e=document.getElementById("data")?.textContent;if(n)try{new sp(fC(JSON.parse(e??"")),n)}catch(t){n.replaceChildren(v("p.problem",{role:"alert"},`The data of this page could not be read: ${t instanceof Error?t.message:String(t)}`))}}pC();})();
