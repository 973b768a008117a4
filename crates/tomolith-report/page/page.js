"use strict";(()=>{function T(n,e={},...t){let[i,...s]=n.split("."),r=document.createElement(i);return s.length>0&&(r.className=s.join(" ")),np(r,e),ip(r,t),r}function At(n,e={},...t){let i=document.createElementNS("http://www.w3.org/2000/svg",n);return np(i,e),ip(i,t),i}function Bs(n){let e=document.createDocumentFragment();return n.split("`").forEach((t,i)=>{t!==""&&e.append(i%2===1?T("code",{},t):t)}),e}function np(n,e){for(let[t,i]of Object.entries(e))i==null||i===!1||(typeof i=="function"?n.addEventListener(t,i):n.setAttribute(t,i===!0?"":String(i)))}function ip(n,e){for(let t of e)t!=null&&t!==!1&&n.append(t)}var j_=[[],[3,0],[0,1],[3,1],[1,2],[3,0,1,2],[0,2],[3,2],[2,3],[2,0],[0,1,2,3],[2,1],[1,3],[1,0],[0,3],[]];function sl(n,e){let{width:t,height:i,codes:s,values:r}=n,o=e-1e6,a=(h,u)=>{if(h<0||u<0||h>=t||u>=i)return o;let d=r[s[u*t+h]];return Number.isNaN(d)?o:d},l=new Float32Array(4096),c=0;for(let h=-1;h<i;h++){let[u,d]=[a(-1,h),a(-1,h+1)];for(let f=-1;f<t;f++){let[g,_]=[a(f+1,h),a(f+1,h+1)],p=(u>=e?1:0)|(g>=e?2:0)|(_>=e?4:0)|(d>=e?8:0);if(p!==0&&p!==15){if(c+8>l.length){let m=new Float32Array(2*l.length);m.set(l),l=m}for(let m of j_[p]){let[v,A]=m===0?[u,g]:m===1?[g,_]:m===2?[d,_]:[u,d],M=(e-v)/(A-v);l[c++]=f+.5+(m===1?1:m===3?0:M),l[c++]=h+.5+(m===0?0:m===2?1:M)}}u=g,d=_}}return l.slice(0,c)}var ji=["x","y","z"],Qn={0:[1,2],1:[0,2],2:[0,1]},ps={outside:0,void:1,part:2},ks={none:0,dark:1,insert:2,obstacle:3},Zo=class{constructor(e,t,i){this.shape=e;this.pitch=t;this.center=i}shape;pitch;center;range(e){let t=this.shape[e]*this.pitch[e]/2;return[this.center[e]-t,this.center[e]+t]}index(e,t){return Math.floor((t-this.range(e)[0])/this.pitch[e]+1e-6)}middle(e,t){return this.range(e)[0]+(t+.5)*this.pitch[e]}},rl=class extends Zo{constructor(t,i){let[s,r,o]=t.shape_zyx;super([o,r,s],[t.pitch_mm,t.pitch_mm,t.height_mm],t.center_xyz_mm);this.info=t;this.codes=i;this.values=jh(t.bits,t.low,t.high,t.nan)}info;codes;values;at(t){let[i,s,r]=[0,1,2].map(h=>this.index(h,t[h])),[o,a,l]=this.shape;if(i<0||s<0||r<0||i>=o||s>=a||r>=l)return null;let c=this.values[this.codes[(r*a+s)*o+i]];return Number.isNaN(c)?null:c}slice(t,i){let s=this.index(t,i);if(s<0||s>=this.shape[t])return null;let[r,o]=Qn[t],[a,l]=[this.shape[r],this.shape[o]],[c,h]=this.shape,u=[1,c,c*h],d=this.info.bits===16?new Uint16Array(a*l):new Uint8Array(a*l);for(let f=0;f<l;f++){let g=s*u[t]+(l-1-f)*u[o];for(let _=f*a;_<(f+1)*a;_++,g+=u[r])d[_]=this.codes[g]}return{axis:t,width:a,height:l,codes:d,values:this.values,pitch:[this.pitch[r],this.pitch[o]],corner:[this.range(r)[0],this.range(o)[1]]}}};function jh(n,e,t,i){let s=2**n,r=s-(i===null?1:2),o=Float32Array.from({length:s},(a,l)=>e+l/r*(t-e));return i!==null&&(o[i]=Number.NaN),o}function Qh(n,e){let i=(n.report?.species??[]).find(s=>s.name===e)??n.report;return{evaluation:i?.evaluation??null,exposure:i?.exposure??null,window:i?.objective_window??null}}function ol(n){let e=n.report?.evaluation,t=e?.band_half_width??null;return t===0?e.rms_error??null:t}function al(n,e,t,i){let{evaluation:s,exposure:r,window:o}=Qh(n,e),a=t&&i?tx(t,i):null,l=s?.gel_threshold??null,c=l??a?.best()??null,h=t?.info.high??s?.histogram?.range?.[1]??null;if(c===null||h===null)return null;let u=Q_(s?.iou_curve??a?.curve()??[],[c,s?.iou??null]),d=r?.threshold?.best??null,f=s?.histogram,g=r?.threshold?[r.threshold.low,r.threshold.high]:null;return{reported:c,isOfReport:l!==null,high:Math.max(h,f?.range?.[1]??0,c),histogram:f?{low:f.range[0],high:f.range[1],part:f.part,void:f.void}:a?.histogram??null,curve:u,nearly:g,objective:o,tolerance:r?.tolerance??null,iou:_=>(_===l?s.iou:null)??ex(u,_)??a?.iou(_)??null,percent:_=>d===null||_<=0?null:100*d/_,tooMuch:_=>(_===l?s.over_mm3:null)??a?.tooMuch(_)??null,missing:_=>(_===l?s.under_mm3:null)??a?.missing(_)??null}}function Q_(n,e){let[t,i]=e;return i==null?n:[...n.filter(([s])=>s!==t),[t,i]].sort((s,r)=>s[0]-r[0])}function ex(n,e){if(n.length<2)return null;if(e<=n[0][0])return n[0][1];let t=n.findIndex(([a])=>a>=e);if(t<0)return n[n.length-1][1];let[[i,s],[r,o]]=[n[t-1],n[t]];return s+(e-i)/(r-i)*(o-s)}var Hr=120;function tx(n,e){if(n.codes.length!==e.codes.length)return null;let{values:t}=n,i=t.length,s=[new Float64Array(i+1),new Float64Array(i+1)];for(let _=0;_<n.codes.length;_++){let p=e.codes[_];p!==ps.outside&&s[p===ps.part?0:1][n.codes[_]+1]++}for(let _ of s)for(let p=1;p<=i;p++)_[p]+=_[p-1];let r=n.pitch[0]*n.pitch[1]*n.pitch[2],o=Number.isNaN(t[i-1])?i-1:i,a=_=>{let[p,m]=[0,o];for(;p<m;){let v=p+m>>1;t[v]>=_?m=v:p=v+1}return p},[l,c]=[s[0][o],s[1][o]],h=_=>{let p=a(_);return{right:l-s[0][p],wrong:c-s[1][p]}},{high:u}=n.info,d=_=>Array.from({length:Hr},(p,m)=>_[a(u*(m+1)/Hr)]-_[a(u*m/Hr)]),f=_=>{let{right:p,wrong:m}=h(_);return l+m>0?p/(l+m):null},g=()=>Array.from({length:Hr+1},(_,p)=>[u*p/Hr,f(u*p/Hr)??0]);return{curve:g,best:()=>l>0?g().reduce((_,p)=>p[1]>_[1]?p:_)[0]:null,histogram:{low:0,high:u,part:d(s[0]),void:d(s[1])},iou:f,tooMuch:_=>h(_).wrong*r,missing:_=>(l-h(_).right)*r}}var nx={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"},ei="–";function Me(n){return typeof n=="number"&&Number.isFinite(n)}function ll(n){return"10"+[...String(n)].map(e=>nx[e]??e).join("")}function he(n,e){if(!Me(n))return ei;if(n===0)return"0";let t=Math.abs(n).toExponential(Math.max(e-1,0)),[i="0",s="0"]=t.split("e"),r=Number(s),o=n<0?"−":"";return r>=-3&&r<6?o+eu(Number(t).toFixed(Math.max(e-1-r,0))):o+(eu(i)==="1"?ll(r):`${eu(i)}·${ll(r)}`)}function Ko(n,e){for(let t=e;t<7;t++){let i=n.map(r=>he(r,t));if(n.every((r,o)=>n.every((a,l)=>l>=o||r===a||i[o]!==i[l])))return i}return n.map(t=>he(t,7))}function Si(n){if(!Me(n))return ei;let e=Math.round(n);return e<60?`${he(n,3)} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e/60)%60} min`}function zs(n){return n==="mm"?{unit:"µm",factor:1e3}:n.startsWith("mm (")?{unit:"mm",factor:1}:{unit:n==="response"?"":n,factor:1}}function an(n,e,t=3){return Me(n)?e===""?he(n,t):`${he(n,t)} ${e}`:ei}function cl(n,e,t){if(e!=="mm"||!Me(n)||!Me(t)||t<=0)return"";let i=he(n/t,2);return i==="1"?"1 voxel":`${i} voxels`}function eu(n){let e=n.includes(".")?n.replace(/\.?0+$/,""):n,[t="",i]=e.split("."),s=t.replace(/\B(?=(\d{3})+$)/g,",");return i===void 0?s:`${s}.${i}`}var ix=[4456788,4727925,4277383,3497869,2783374,2199948,2271364,4505456,8048977,12443430,16639781],sx=[4,1444665,4328040,6952814,9643623,12334932,14504250,15955993,16557322,16176966,16580516],rx=[1922736,7050966,13883614,15177347,13055519];function sp(n,e=255){return(e<<24|(n&255)<<16|n&65280|n>>16)>>>0}function rp(n){return`rgb(${n&255} ${n>>8&255} ${n>>16&255} / ${((n>>>24)/255).toFixed(3)})`}function tu(n,e){let t=Math.min(Math.max(e,0),1)*(n.length-1),i=Math.min(Math.floor(t),n.length-2),s=r=>{let[o,a]=[n[i]>>r&255,n[i+1]>>r&255];return Math.round(o+(t-i)*(a-o))<<r};return sp(s(16)|s(8)|s(0))}var lr=n=>tu(ix,n),nu=n=>tu(sx,n),Gr=n=>tu(rx,n);function hl(n){return[(n&255)/255,(n>>8&255)/255,(n>>16&255)/255]}function On(n){let e=getComputedStyle(document.documentElement).getPropertyValue(n).trim();return sp(Number.parseInt(e.slice(1),16)||0)}function cr(n,e){return(n&16777215|Math.round(255*e)<<24)>>>0}function Jo(n,e){let{low:t,high:i,logarithmic:s}=n;return i>t?s?Math.log(Math.max(e,t)/t)/Math.log(i/t):(e-t)/(i-t):0}function ul(n,e){return Uint32Array.from(n,t=>Number.isNaN(t)?0:e.map(Jo(e,t)))}var ox=4;function op(n,e,t,i){let{response:s,target:r}=n,o=[];s&&o.push(jo("dose","Dose",s,e,t)),r&&o.push(i===null?lx(r,e):jo("target","Target",r,e,null)),s&&t&&o.push(cx(s,n,e,t)),s&&r&&su(s,r)&&(t?o.push(hx(s,n,e,t)):i!==null&&o.push(ru(s,r,e,ox*i,"Error","dose − target")));for(let a of n.others)o.push(jo(a.info.id,ax(a),a,e,null));return o}function su(n,e){return n.shape.every((t,i)=>t===e.shape[i])}function ax(n){let{name:e,species:t}=n.info,i=t===null?e:`${e}, ${t}`;return i.charAt(0).toUpperCase()+i.slice(1)}function jo(n,e,t,i,s,r={low:t.info.low,high:t.info.high}){let{info:o}=t,l={low:o.logarithmic?Math.max(r.low,r.high*1e-6):o.kind==="response"?Math.min(r.low,0):r.low,high:r.high,logarithmic:o.logarithmic&&r.high>0,map:lr},c=o.unit===""?"":` ${o.unit}`,h=new WeakMap,u=d=>{let f=h.get(d);return f||h.set(d,f=ou(d,g=>ul(g,l))),f};return{id:n,title:e,picture:(d,f)=>{let g=i.of(t,d,f);return g&&u(g)},value:d=>`${e.toLowerCase()} ${au(t.at(d))}${c}`,legend:()=>({scale:l,label:o.unit===""?e:`${e}, ${o.unit}`,mark:s?.()??null})}}function lx(n,e){return{id:"target",title:"Target",picture:(t,i)=>{let s=On("--solid"),r=e.of(n,t,i);return r&&ou(r,o=>Uint32Array.from(o,a=>cr(s,Math.min(Math.max(a,0),1))))},value:t=>`target ${au(n.at(t))}`,legend:()=>({keys:[["var(--solid)","part"],["var(--picture)","to stay liquid"]]})}}function cx(n,{bodies:e},t,i){return{id:"print",title:"Print",picture:(s,r)=>{let o=On("--solid"),a=i(),l=t.of(n,s,r);return l&&lp(ou(l,c=>Uint32Array.from(c,h=>h>=a?o:0)),e,t,s,r)},value:s=>{let r=n.at(s);return r===null?"print –":r>=i()?"print solid":"print liquid"},legend:()=>({keys:[["var(--solid)","solid"],["var(--picture)","liquid"],...ap(e)]})}}function hx(n,{target:e,labels:t,bodies:i},s,r){let o=(a,l)=>a===null?(l??0)>=.5:a===ps.part;return{id:"error",title:"Error",picture:(a,l)=>{let[c,h,u]=[n,e,t].map(R=>R&&s.of(R,a,l));if(!c)return null;let d=r(),[f,g,_,p]=[cr(On("--solid"),.55),On("--missing"),On("--excess"),cr(On("--solid"),.2)],m=new Uint32Array(c.codes.length),v=R=>R!==null&&R.width===c.width&&R.height===c.height,[A,M]=[v(h)?h:null,v(u)?u:null];for(let R=0;R<m.length;R++){let C=c.values[c.codes[R]]>=d,x=M?M.codes[R]:null;x===ps.outside?m[R]=C?p:0:o(x,A?A.values[A.codes[R]]:null)?m[R]=C?f:g:m[R]=C?_:0}return lp({...c,pixels:m},i,s,a,l)},value:a=>{let l=n.at(a),c=t?t.at(a):null;if(l===null)return"–";if(c===ps.outside)return"not counted";let h=l>=r();return o(c,e?e.at(a):null)?h?"solid, as it should":"missing":h?"too much":"liquid, as it should"},legend:()=>({keys:[["color-mix(in srgb, var(--solid) 55%, var(--picture))","solid, as it should"],["var(--missing)","missing"],["var(--excess)","too much"],["var(--picture)","liquid, as it should"],...ap(i)]})}}function ru(n,e,t,i,s,r){let o={low:-i,high:i,logarithmic:!1,map:Gr},a=Uint32Array.from({length:256},(l,c)=>Gr(c/255));return{id:s.toLowerCase(),title:s,picture:(l,c)=>{let[h,u]=[t.of(n,l,c),t.of(e,l,c)];if(!h||!u||h.codes.length!==u.codes.length)return null;let d=new Uint32Array(h.codes.length);for(let f=0;f<d.length;f++){let g=Jo(o,h.values[h.codes[f]]-u.values[u.codes[f]]);d[f]=a[Math.round(255*Math.min(Math.max(g,0),1))]}return{...h,pixels:d}},value:l=>{let[c,h]=[n.at(l),e.at(l)];return`${r} ${au(c===null||h===null?null:c-h)}`},legend:()=>({scale:o,label:r,mark:null})}}function ou(n,e){let{codes:t}=n,i=e(n.values),s=new Uint32Array(t.length);for(let r=0;r<s.length;r++)s[r]=i[t[r]];return{...n,pixels:s}}var iu={[ks.dark]:{color:"--void",text:"body that must stay dark"},[ks.insert]:{color:"--ink",text:"insert"},[ks.obstacle]:{color:"--quiet",text:"obstacle"}};function ap(n){if(!n)return[];let e=new Set(n.codes);return Object.entries(iu).filter(([t])=>e.has(Number(t))).map(([,{color:t,text:i}])=>[`var(${t})`,i])}function lp(n,e,t,i,s){let r=e&&t.of(e,i,s);if(!r||r.codes.length!==n.pixels.length)return n;let o=Uint32Array.from({length:256},(a,l)=>iu[l]?cr(On(iu[l].color),.75):0);return r.codes.forEach((a,l)=>{o[a]!==0&&(n.pixels[l]=o[a])}),n}function au(n){return he(n,3)}var ux={2:"Top view, x–y",1:"Front view, x–z",0:"Side view, y–z"},cp=24,dx=.62,Vs=class{constructor(e){this.options=e;let{state:t,signal:i,grid:s}=e;this.center=[...s.center];let r=t.on(["at"],()=>this.redraw(!1));i.addEventListener("abort",r);let o=()=>this.redraw(!0);window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change",o,{signal:i})}options;element=T("div.planes");views=[];zoom=1;center;show(e){this.views.forEach(l=>l.end()),this.views=e.map(l=>new lu(this,l));let{grid:t}=this.options,i=e.map(({axis:l})=>`minmax(0, ${Wr(t,Qn[l][0]).toFixed(4)}fr)`);this.element.style.setProperty("--columns",i.join(" "));let[s,r,o]=[0,1,2].map(l=>Wr(t,l)),a=e.length===3&&new Set(e.map(({axis:l})=>l)).size===3;this.element.classList.toggle("flat",a&&o<dx*Math.min(s,r)),this.element.classList.toggle("wide",!a&&e.length>2),this.element.replaceChildren(...this.views.map(l=>l.element))}redraw(e){for(let t of this.views)t.redraw(e)}at(){return this.options.state.get("at")??this.options.grid.center}moveTo(e){let{state:t,grid:i}=this.options,s=this.at().map((r,o)=>{let[a,l]=i.range(o);return Math.min(Math.max(e[o]??r,a+1e-4),l-1e-4)});t.set({at:s})}zoomBy(e,t){let i=Math.min(Math.max(this.zoom*e,1),cp),s=1-this.zoom/i;this.center=this.center.map((r,o)=>r+(t[o]-r)*s),this.zoom=i,i===1&&(this.center=[...this.options.grid.center]),this.keepWithin(),this.redraw(!1)}panBy(e,t){this.center[e]+=t,this.keepWithin(),this.redraw(!1)}keepWithin(){let{grid:e}=this.options;this.center=this.center.map((t,i)=>{let[s,r]=e.range(i),o=(r-s)/2/this.zoom;return Math.min(Math.max(t,s+o),r-o)})}};function Wr(n,e){return n.range(e)[1]-n.range(e)[0]}var lu=class{constructor(e,t){this.planes=e;this.shown=t;let{grid:i}=e.options,{axis:s}=t,r=t.title??ux[s],o=i.shape[s]-1;this.slider=T("input",{type:"range",min:0,max:o,step:1,"aria-label":`${r}: ${ji[s]} of the slice`}),this.canvas.setAttribute("aria-label",`${r}: slice along ${ji[s]}`),this.canvas.setAttribute("aria-valuemin","0"),this.canvas.setAttribute("aria-valuemax",String(o));let[a,l]=Qn[s];this.canvas.style.aspectRatio=`${Wr(i,a)} / ${Wr(i,l)}`,this.element=T("figure.plane",{},T("figcaption",{},T("span",{},r),this.place),this.canvas,this.slider),this.listen(),this.watcher.observe(this.canvas)}planes;shown;element;canvas=T("canvas",{tabindex:0,role:"slider","aria-orientation":"horizontal"});slider;place=T("output.place");image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.redraw(!1));picture=null;outlines=[];painted=-1;frame=0;turned=0;end(){this.watcher.disconnect(),cancelAnimationFrame(this.frame)}redraw(e){e&&(this.painted=-1),this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0,this.draw()}))}get index(){let{grid:e}=this.planes.options,{axis:t}=this.shown;return Math.min(Math.max(e.index(t,this.planes.at()[t]),0),e.shape[t]-1)}step(e){let{grid:t}=this.planes.options,{axis:i}=this.shown;this.planes.moveTo({[i]:t.middle(i,this.index+e)})}paint(){let{grid:e}=this.planes.options,{axis:t,layer:i,outlines:s}=this.shown,r=this.index;if(this.painted===r)return;this.painted=r;let o=e.middle(t,r),a=this.picture;if(this.picture=i.picture(t,o),this.outlines=s?.(t,o)??[],this.picture&&this.picture!==a){let{width:c,height:h,pixels:u}=this.picture;[this.image.width,this.image.height]=[c,h],this.image.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(u.buffer),c,h),0,0)}let l=`${ji[t]} = ${cu(o)} mm`;this.place.textContent=`${l} · ${r+1} of ${e.shape[t]}`,this.slider.value=String(r),this.slider.setAttribute("aria-valuetext",l),this.canvas.setAttribute("aria-valuenow",String(r)),this.canvas.setAttribute("aria-valuetext",l)}draw(){this.paint();let e={width:this.canvas.clientWidth,height:this.canvas.clientHeight},t=this.canvas.getContext("2d");if(!t||e.width===0)return;let i=window.devicePixelRatio||1,[s,r]=[Math.round(e.width*i),Math.round(e.height*i)];(this.canvas.width!==s||this.canvas.height!==r)&&([this.canvas.width,this.canvas.height]=[s,r]),t.setTransform(1,0,0,1,0,0),t.clearRect(0,0,s,r),t.imageSmoothingEnabled=!1;let{x:o,y:a}=this.scale(s,r);if(this.picture){let{corner:c,pitch:h}=this.picture,[u,d]=[o(c[0]),a(c[1])];t.drawImage(this.image,u,d,o(c[0]+this.picture.width*h[0])-u,a(c[1]-this.picture.height*h[1])-d)}let l=getComputedStyle(this.canvas);for(let c of this.outlines)fx(t,c,o,a,i,l.getPropertyValue(c.color).trim()||c.color);this.cross(t,o,a,s,r,i),this.ruler(t,s,r,i)}scale(e,t){let{grid:i}=this.planes.options,{zoom:s,center:r}=this.planes,[o,a]=Qn[this.shown.axis],l=e/Wr(i,o)*s;return{perMm:l,x:c=>e/2+(c-r[o])*l,y:c=>t/2-(c-r[a])*l,back:(c,h)=>{let u=this.planes.at(),d=[u[0],u[1],u[2]];return d[o]=r[o]+(c-e/2)/l,d[a]=r[a]-(h-t/2)/l,d}}}cross(e,t,i,s,r,o){let a=this.planes.at(),[l,c]=Qn[this.shown.axis],[h,u]=[Math.round(t(a[l])),Math.round(i(a[c]))];for(let[d,f]of[["rgb(0 0 0 / 0.35)",o],["rgb(255 255 255 / 0.65)",0]])e.fillStyle=d,e.fillRect(h+f,0,o,r),e.fillRect(0,u+f,s,o)}ruler(e,t,i,s){let{perMm:r}=this.scale(t,i),o=px(.3*t/r),[a,l]=[12*s,i-12*s],c=o<1?`${Math.round(o*1e3)} µm`:`${o} mm`;e.font=`${11*s}px system-ui, sans-serif`;let h=Math.max(o*r,e.measureText(c).width);e.fillStyle="rgb(0 0 0 / 0.5)",e.beginPath(),e.roundRect(a-6*s,l-20*s,h+12*s,27*s,5*s),e.fill(),e.fillStyle="#fff",e.fillRect(a,l-s,o*r,2*s),e.fillText(c,a,l-6*s)}pointOf(e){let t=this.canvas.getBoundingClientRect();return this.scale(t.width,t.height).back(e.clientX-t.left,e.clientY-t.top)}listen(){let{planes:e,canvas:t}=this,{signal:i,hover:s}=e.options,[r,o]=Qn[this.shown.axis];this.slider.addEventListener("input",()=>this.step(Number(this.slider.value)-this.index),{signal:i}),t.addEventListener("keydown",l=>this.key(l),{signal:i}),t.addEventListener("wheel",l=>{let c=l.ctrlKey||l.metaKey;if(!c&&document.activeElement!==t)return;if(l.preventDefault(),c){e.zoomBy(Math.exp(-l.deltaY/300),this.pointOf(l));return}this.turned+=l.deltaMode===WheelEvent.DOM_DELTA_PIXEL?l.deltaY/40:l.deltaY;let h=Math.trunc(this.turned);this.turned-=h,h!==0&&this.step(-h)},{signal:i,passive:!1});let a=l=>{let c=this.pointOf(l);e.moveTo({[r]:c[r],[o]:c[o]})};t.addEventListener("click",a,{signal:i}),t.addEventListener("dblclick",l=>e.zoomBy(l.shiftKey?.5:2,this.pointOf(l)),{signal:i}),t.addEventListener("pointermove",l=>{if(s?.(this.pointOf(l),this.shown.layer),l.buttons===1&&l.pointerType==="mouse")if(l.shiftKey){let{perMm:c}=this.scale(t.clientWidth,t.clientHeight);e.panBy(r,-l.movementX/c),e.panBy(o,l.movementY/c)}else a(l)},{signal:i}),t.addEventListener("pointerleave",()=>s?.(null,this.shown.layer),{signal:i})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let{planes:t}=this,{grid:i}=t.options,{axis:s}=this.shown,[r,o]=Qn[s],a=Math.max(Math.round(i.shape[s]/10),2),l=Wr(i,r)/t.zoom*.1,c=e.shiftKey?{ArrowLeft:()=>t.panBy(r,-l),ArrowRight:()=>t.panBy(r,l),ArrowDown:()=>t.panBy(o,-l),ArrowUp:()=>t.panBy(o,l)}:{ArrowUp:()=>this.step(1),ArrowRight:()=>this.step(1),ArrowDown:()=>this.step(-1),ArrowLeft:()=>this.step(-1),PageUp:()=>this.step(a),PageDown:()=>this.step(-a),Home:()=>this.step(-this.index),End:()=>this.step(i.shape[s]-1-this.index)},h={"+":()=>t.zoomBy(1.5,t.at()),"=":()=>t.zoomBy(1.5,t.at()),"-":()=>t.zoomBy(1/1.5,t.at()),0:()=>t.zoomBy(1/cp,t.at())},u=c[e.key]??h[e.key];u&&(e.preventDefault(),u())}};function fx(n,{segments:e,slice:t},i,s,r,o){let[a,l]=[i(t.corner[0]),s(t.corner[1])],[c,h]=[i(t.corner[0]+t.pitch[0])-a,s(t.corner[1]-t.pitch[1])-l];n.beginPath();for(let u=0;u<e.length;u+=4)n.moveTo(a+e[u]*c,l+e[u+1]*h),n.lineTo(a+e[u+2]*c,l+e[u+3]*h);n.lineCap="round",n.lineWidth=3*r,n.strokeStyle="rgb(0 0 0 / 0.4)",n.stroke(),n.lineWidth=1.6*r,n.strokeStyle=o,n.stroke()}function px(n){let e=10**Math.floor(Math.log10(n)),t=[5,2,1].find(i=>i*e<=n*(1+1e-9))??1;return Number((t*e).toPrecision(3))}function cu(n){return n.toFixed(3).replace("-","−")}var mx=60,gx=60,Xr=class{constructor(e,t,i,s){this.store=t;this.signal=i;this.better=s;let r=(e.report?.optimization??e.report?.evaluation)?.grid,[o,a,l]=r?.shape_zyx??[0,0,0];this.grid=r?new Zo([l,a,o],[r.pitch_mm,r.pitch_mm,r.pitch_mm],r.center_xyz_mm):null}store;signal;better;full=new Map;last=new Map;asked=new Map;grid;gridOf(e){return this.finer(e)??e}of(e,t,i){let s=this.reduced(e,t,i),r=this.finer(e);if(r===null||s===null)return s;let o=r.index(t,i);if(o<0||o>=r.shape[t])return s;let a=`${e.info.id}/${t}/${o}`,l=this.full.get(a);return l||this.ask(a,e,r,t,o),l??s}reduced(e,t,i){let s=`${e.info.id}/${t}`,r=e.index(t,i),o=this.last.get(s);if(o?.index===r)return o.slice;let a=e.slice(t,i);return this.last.set(s,{index:r,slice:a}),a}finer(e){let{grid:t}=this;return e.info.full&&t!==null&&t.pitch[0]<.99*e.pitch[0]?t:null}ask(e,t,i,s,r){let o=`${t.info.id}/${s}`,a=this.asked.get(o);if(a?.key===e)return;window.clearTimeout(a?.timer);let l=async()=>{let h=await this.store.slice(t.info,2-s,r,this.signal),[u,d]=h.shape,[f,g]=Qn[s],_=h.codes.slice();for(let M=0;M<u;M++)_.set(h.codes.subarray((u-1-M)*d,(u-M)*d),M*d);let p=h.codes instanceof Uint16Array?16:8,m=[i.range(f)[0],i.range(g)[1]],v=jh(p,h.low,h.high,t.info.nan===null?null:2**p-1);this.full.set(e,{axis:s,width:d,height:u,codes:_,values:v,pitch:[i.pitch[f],i.pitch[g]],corner:m});let A=this.full.keys().next();this.full.size>mx&&!A.done&&this.full.delete(A.value),this.better()},c=h=>{this.signal.aborted||console.warn(`The full slice of ${t.info.name} along ${ji[s]} did not come: ${String(h)}`)};this.asked.set(o,{key:e,timer:window.setTimeout(()=>{l().catch(c)},gx)})}};var dl=1e3,pl=230,Qt={left:44,right:44,top:26,bottom:40},Qi=pl-Qt.bottom;function hp(n,e,t){let i=T("input",{type:"range",min:0,max:dl,step:1,"aria-label":"Gel threshold"}),s=T("button",{type:"button",click:()=>e.set({threshold:null})},n.isOfReport?"Back to the report’s threshold":"Back to the best threshold"),r=T("dl.threshold-list"),o=new hu(n,d=>a(d)),a=d=>{let f=Math.min(Math.max(d,0),n.high);e.set({threshold:Math.abs(f-n.reported)<.6*n.high/dl?null:f})};i.addEventListener("input",()=>a(Number(i.value)/dl*n.high),{signal:t});let l=n.isOfReport?"as reported":"best of the voxels shown",c=()=>{let d=e.get("threshold")??n.reported,f=n.iou(d),g=n.percent(d);i.value=String(Math.round(d/n.high*dl)),i.setAttribute("aria-valuetext",`${he(d,3)}, IoU ${he(f,3)}`),s.disabled=e.get("threshold")===null,o.mark(d),r.replaceChildren(...Qo("Gel threshold",he(d,4),"dose at which the resin gels"),...Qo("Exposure",g===null?"–":`${he(g,4)} %`,"of the best exposure"),...Qo("IoU",he(f,4),d!==n.reported?`${he(n.iou(n.reported),4)} ${l}`:l),...Qo("Too much",an(n.tooMuch(d),"mm³"),"gels and should not","--excess"),...Qo("Missing",an(n.missing(d),"mm³"),"does not gel and should","--missing"))},h=e.on(["threshold"],c);t.addEventListener("abort",()=>{h(),o.end()}),c();let u=n.nearly&&n.tolerance!==null?` In the shaded range IoU is at most ${he(n.tolerance,2)} below its best.`:"";return T("div.threshold",{},T("div.threshold-chart",{},T("h3",{},"Where the resin gels"),T("p.quiet",{},`Move the threshold: contours, print, errors and numbers follow.${u}`),_x(),o.element,T("div.threshold-slider",{},i)),T("div.threshold-numbers",{},r,s))}function Qo(n,e,t,i){return[T("dt",{},i!==void 0&&T("i.tile",{style:`background: var(${i})`}),n),T("dd",{},T("b",{},e),T("span.quiet",{},t))]}function fl(n,e){return T("span",{},T("i.tile",{style:`background: var(${n})`}),e)}function _x(){return T("p.color-keys",{},fl("--part","part, voxels"),fl("--void","void, voxels"),fl("--ink","IoU"),fl("--threshold","gel threshold"))}var hu=class{constructor(e,t){this.gel=e;this.watcher.observe(this.element);let i=s=>{s.buttons===1&&(s.preventDefault(),t(this.back(s.clientX-this.element.getBoundingClientRect().left)))};this.element.addEventListener("pointerdown",s=>{this.element.setPointerCapture(s.pointerId),i(s)}),this.element.addEventListener("pointermove",i)}gel;element=T("div.plot");watcher=new ResizeObserver(()=>this.resize());line=At("g");width=0;threshold=0;end(){this.watcher.disconnect()}mark(e){this.threshold=e,this.drawLine()}x(e){return Qt.left+e/this.gel.high*(this.width-Qt.left-Qt.right)}back(e){return(e-Qt.left)/(this.width-Qt.left-Qt.right)*this.gel.high}resize(){let e=this.element.clientWidth;e===0||e===this.width||(this.width=e,this.element.replaceChildren(this.draw()),this.drawLine())}draw(){let{histogram:e,nearly:t,objective:i,curve:s,reported:r,high:o}=this.gel,a=At("svg",{width:this.width,height:pl,viewBox:`0 0 ${this.width} ${pl}`,role:"img","aria-label":"Voxels of part and void per dose, and IoU per gel threshold"});if(t){let[l,c]=[Math.max(t[0]??0,0),Math.min(t[1]??o,o)];a.append(At("rect",{class:"band",x:this.x(l),y:Qt.top,width:Math.max(this.x(c)-this.x(l),1),height:Qi-Qt.top}))}for(let l of yx(0,o,this.width/90))a.append(At("line",{class:"grid",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:Qi}),At("text",{x:this.x(l),y:Qi+16,"text-anchor":"middle"},he(l,3)));a.append(At("text",{x:(this.width+Qt.left-Qt.right)/2,y:pl-6,"text-anchor":"middle"},"dose")),e&&a.append(...this.bars(e));for(let l of i??[])a.append(At("line",{class:"aimed",x1:this.x(l),x2:this.x(l),y1:Qt.top,y2:Qi},At("title",{},"a threshold of the objective: the void should stay below both, the part above")));if(s.length>1){a.append(At("path",{class:"curve",d:`M${s.filter(([l])=>l<=o).map(([l,c])=>`${this.x(l).toFixed(1)},${hr(c).toFixed(1)}`).join("L")}`}));for(let l of[0,.5,1])a.append(At("text",{x:this.width-Qt.right+8,y:hr(l)+4},String(l)));a.append(At("text",{x:this.width-Qt.right+8,y:Qt.top-10},"IoU"))}return a.append(At("line",{class:"base",x1:Qt.left,x2:this.width-Qt.right,y1:Qi,y2:Qi}),At("line",{class:"fixed",x1:this.x(r),x2:this.x(r),y1:Qt.top,y2:Qi},At("title",{},"the report’s threshold")),this.line),a}bars(e){let{low:t,high:i}=e,s=Math.max(...e.part,...e.void,1),r=Math.ceil(Math.log10(s+1)),a=Array.from({length:r+1},(c,h)=>h).filter(c=>c%Math.ceil(r/4)===0).map(c=>At("text",{x:Qt.left-8,y:hr(c/r)+4,"text-anchor":"end"},c===0?"1":ll(c))),l=["void","part"].map(c=>{let h=e[c].map(u=>Math.log10(u+1)/r);return At("path",{class:`bars ${c}`,d:xx(h,u=>this.x(t+u/h.length*(i-t)))})});return[...a,...l]}drawLine(){if(this.width===0)return;let e=this.x(this.threshold),t=this.gel.iou(this.threshold),i=e>this.width-90;this.line.replaceChildren(At("line",{class:"threshold-line",x1:e,x2:e,y1:Qt.top-8,y2:Qi}),At("text",{class:"threshold-label",x:e+(i?-6:6),y:Qt.top-8,"text-anchor":i?"end":"start"},he(this.threshold,3))),t!==null&&this.line.append(At("circle",{class:"threshold-dot",cx:e,cy:hr(t),r:4.5}))}};function hr(n){return Qi-n*(Qi-Qt.top)}function xx(n,e){let t=`M${e(0).toFixed(1)},${hr(0)}`;return n.forEach((i,s)=>{t+=`V${hr(i).toFixed(1)}H${e(s+1).toFixed(1)}`}),`${t}V${hr(0)}Z`}function yx(n,e,t){let i=(e-n)/Math.max(t,2),s=10**Math.floor(Math.log10(i)),r=([1,2,5,10].find(a=>a*s>=i)??10)*s,o=[];for(let a=Math.ceil(n/r);a*r<=e+1e-9;a++)o.push(a*r);return o}var dp={id:"look",title:"Slice by slice",render:n=>n.run.volumes.some(({kind:e})=>e==="response"||e==="target")?Ni(n,vx):null},ea="all";function Ni(n,e){let t=T("div",{"aria-busy":"true"},T("p.quiet",{},"Unpacking the volumes…"));return e(n).then(i=>t.replaceChildren(i)).catch(i=>t.replaceChildren(T("p.problem",{role:"alert"},i instanceof Error?i.message:String(i)))).finally(()=>t.removeAttribute("aria-busy")),t}function es(n,e,t){let i=n.volumes.filter(s=>s.kind===e);return i.find(s=>t!==""&&s.species===t)??i[0]}function uu(n){return n.volumes.filter(({kind:e,species:t})=>e==="response"&&t!==null).map(({species:e})=>e??"")}async function ml(n,e){let{run:t,store:i}=n,s=[],r=async f=>{if(!f)return null;try{return await i.volume(f)}catch(g){return s.push(g instanceof Error?g.message:String(g)),null}},o=f=>r(es(t,f,e)),a=t.volumes.filter(({kind:f})=>f==="cure_time"||f==="property"),[l,c,h,u,...d]=await Promise.all([o("response"),o("target"),o("labels"),o("bodies"),...a.map(r)]);return{volumes:{response:l,target:c,labels:h,bodies:u,others:d.filter(f=>f!==null)},problems:s}}async function vx(n){let{run:e,state:t,gone:i}=n,s=uu(e),r=T("div"),o=new AbortController,a=async()=>{o.abort(),o=new AbortController;let c=o,h=s.includes(t.get("species"))?t.get("species"):"",{volumes:u,problems:d}=await ml(n,h);c.signal.aborted||r.replaceChildren(...d.map(f=>T("p.problem",{role:"alert"},f)),...Mx(n,u,h,c.signal))},l=t.on(["species"],()=>{a()});return i.addEventListener("abort",()=>{l(),o.abort()}),await a(),T("div",{},s.length>1&&bx(n,s),r)}function bx({state:n,gone:e},t){let i=()=>t.includes(n.get("species"))?n.get("species"):t[0];return wi("Species",t.map(s=>[s,s]),i,s=>n.set({species:s,threshold:null}),s=>e.addEventListener("abort",n.on(["species"],s)))}function wi(n,e,t,i,s){let r=e.map(([a,l])=>({value:a,button:T("button",{type:"button",click:()=>i(a)},l)})),o=()=>r.forEach(({value:a,button:l})=>l.setAttribute("aria-pressed",String(a===t())));return s(o),o(),T("div.choice",{role:"group","aria-label":n},...r.map(({button:a})=>a))}function Mx(n,e,t,i){let{run:s,state:r,store:o}=n,a=e.response??e.target;if(!a)return[];let l=ol(s),c=l===null?al(s,t,e.response,e.labels):null,h=()=>r.get("threshold")??c?.reported??Number.POSITIVE_INFINITY,u=null,d=new Xr(s,o,i,()=>u?.redraw(!0)),f=op(e,d,c&&h,l),g=T("p.readout",{"aria-live":"off"}),_=I=>{let V=I.map((H,B)=>`${ji[B]} ${cu(H)}`).join(", ");g.textContent=`${V} mm  ·  ${f.map(H=>H.value(I)).join("  ·  ")}`};u=new Vs({state:r,grid:d.gridOf(a),signal:i,hover:I=>_(I??u.at())});let p={part:!0,print:c!==null},m=I=>(V,H)=>{let B=[],le=(Y,j,te)=>{let ue=Y&&d.of(Y,V,H);ue&&Number.isFinite(j)&&B.push({slice:ue,segments:Sx(ue,j),color:te})};return p.part&&!["target","error"].includes(I.id)&&l===null&&le(e.target,.5,"--outline-part"),p.print&&!["print","error"].includes(I.id)&&c&&le(e.response,h(),"--threshold-line"),B},v=T("div.color-legend"),A=()=>f.find(({id:I})=>I===r.get("layer"))??f[0],M=2,R=()=>{let I=r.get("layer")===ea,V=I?f.slice(0,4).map(H=>({axis:M,layer:H,title:H.title,outlines:m(H)})):[2,1,0].map(H=>({axis:H,layer:A(),outlines:m(A())}));u.show(V),U.hidden=!I,G.part&&(G.part.hidden=!I&&["target","error"].includes(A().id)),G.print&&(G.print.hidden=!I&&["print","error"].includes(A().id)),C()},C=()=>v.replaceChildren(...(r.get("layer")===ea?f.slice(0,4):[A()]).map(I=>Ei(I.legend()))),x=I=>V=>i.addEventListener("abort",r.on(I,V)),S=f.map(({id:I,title:V})=>[I,V]);f.length>1&&S.push([ea,"Side by side"]);let k=new EventTarget,U=wi("Plane",[["2","x–y"],["1","x–z"],["0","y–z"]],()=>String(M),I=>{M=Number(I),R(),k.dispatchEvent(new Event("change"))},I=>k.addEventListener("change",I,{signal:i})),D=(I,V,H)=>T("label",{},T("input",{type:"checkbox",checked:p[I],change:B=>{p[I]=B.target.checked,u.redraw(!0)}}),T("i.stroke",{style:`background: var(${H})`}),V),G={part:e.target&&l===null?D("part","outline of the part","--outline-part"):null,print:c&&e.response?D("print","outline of the print","--threshold-line"):null};x(["threshold"])(()=>{u.redraw(!0),C()}),x(["layer"])(R),x(["threshold","at","layer"])(()=>_(u.at())),R(),_(u.at());let X=a.info.reduced>1&&!a.info.full?` Each voxel shown is the mean of ${a.info.reduced}³ of the evaluation.`:"";return[T("p.quiet",{},`Click to move the cut; drag the sliders, or choose a plane and press the arrow keys or turn the wheel. Double-click, + and − zoom, 0 shows all again.${X}`),T("div.controls",{},S.length>1&&wi("Shown",S,()=>r.get("layer")===ea?ea:A().id,I=>r.set({layer:I===f[0].id?"":I}),x(["layer"])),U,G.part,G.print),u.element,T("div.below-planes",{},g,v),...c?[hp(c,r,i)]:[]]}var up=new WeakMap;function Sx(n,e){let t=up.get(n);return t?.level!==e&&up.set(n,t={level:e,segments:sl(n,e)}),t.segments}function Ei(n){if("keys"in n)return T("p.color-keys",{},...n.keys.map(([o,a])=>T("span",{},T("i.tile",{style:`background: ${o}`}),a)));let{scale:e,label:t,mark:i}=n,s=Array.from({length:17},(o,a)=>rp(e.map(a/16))).join(", "),r=i===null||!Number.isFinite(i)?null:(i-e.low)/(e.high-e.low);return T("div.color-scale",{},T("span",{},he(e.low,3)),T("span.bar",{style:`background: linear-gradient(to right, ${s})`},r!==null&&r>=0&&r<=1&&T("i",{style:`left: ${100*r}%`,title:"gel threshold"})),T("span",{},he(e.high,3)),T("span.quiet",{},e.logarithmic?`${t}, logarithmic`:t))}function pu({run:n,state:e,store:t},i,s,r,o){let a=T("div"),l=T("div"),c=T("p.quiet",{role:"status"}),h=i.lights[s]?.frames??[],u=h.length-1,d=T("input",{type:"range",min:0,max:u,step:1,"aria-label":"Frame",input:()=>e.set({frame:Number(d.value)})}),f=null,g=()=>{let m=r?.()??null,v=Math.min(e.get("frame"),u);d.value=String(v);let A=m===null?h[v]??null:Ex(h,m);a.replaceChildren(Tx(i,A?.rays??[],f)),l.replaceChildren(Ax(i,A?.rays??[]));let M=A!==null&&m!==null&&du(A.angle_deg,m)>.05,R=A===null?"":`Light from ${he(A.angle_deg,4)}°${M?", the nearest frame whose rays the page has":""}.`;c.textContent=`${R}${wx(i)}`.trim()};g();let _=async()=>{f=await Rx(n,t,e.get("at")?.[2]??null),g()};_().catch(()=>{});let p=[e.on(["frame"],g),e.on(["at"],()=>{_().catch(()=>{})})];return o.addEventListener("abort",()=>p.forEach(m=>m())),T("div.paths",{},T("h3",{},"Where the light goes"),c,r===null&&u>0&&T("div.path-frame",{},T("label",{},"Frame",d)),T("div.path-views",{},T("figure",{},T("figcaption",{},"From above"),a),T("figure",{},T("figcaption",{},"From the side, light from the left"),l,T("p.color-keys",{},gl("--void","light in the resin"),gl("--quiet","light outside"),gl("--solid","part"),i.lit_radius_mm!==null&&gl("--accent","radius that every frame lights")))))}function gl(n,e){return T("span",{},T("i.stroke",{style:`background: var(${n})`}),e)}function wx({lit_radius_mm:n,part_radius_mm:e}){if(n===null)return"";let[t,i]=[he(n,3),he(e,3)];return n>=e?` Every frame lights all within ${t} mm of the axis; the part reaches out to ${i} mm.`:` Every frame lights only what lies within ${t} mm of the axis, but the part reaches out to ${i} mm.`}function Ex(n,e){return n.reduce((t,i)=>t!==null&&du(t.angle_deg,e)<=du(i.angle_deg,e)?t:i,null)}function du(n,e){let t=Math.abs(n-e)%360;return Math.min(t,360-t)}function Tx(n,e,t){let i=Math.max(...n.walls.flatMap(({points:r})=>r.map(([o,a])=>Math.hypot(o,a))),n.part_radius_mm)*1.22,s=fp([-i,i],[-i,i],"Light path from above");for(let r of n.walls)s.append(_l(r.points,"wall",r.name));t?s.append(At("image",{href:t.url,x:t.left,y:-t.top,width:t.width,height:t.height,preserveAspectRatio:"none"})):s.append(At("circle",{class:"part",r:n.part_radius_mm}));for(let r of n.obstacles)s.append(_l(r.points,"obstacle",r.name));return n.lit_radius_mm!==null&&s.append(At("circle",{class:"lit",r:n.lit_radius_mm},At("title",{},"radius that every frame lights"))),s.append(...pp(e.map(r=>({points:r.points.map(([o,a])=>[o,a]),from:r.resin_from})),i)),s}function Ax(n,e){let t=e[e.length>>1]?.points??[],[i,s]=[t[0]??[-1,0,0],t[t.length-1]??[1,0,0]],r=Math.hypot(s[0]-i[0],s[1]-i[1])||1,[o,a]=[(s[0]-i[0])/r,(s[1]-i[1])/r],l=([_,p])=>_*o+p*a,c=Math.max(...n.walls.flatMap(({points:_})=>_.map(([p,m])=>Math.hypot(p,m))),n.part_radius_mm)*1.22,[h,u]=n.z_mm,d=.25*(u-h)+.05*c,f=fp([-c,c],[h-d,u+d],"Light path from the side");for(let _ of n.walls){let p=_.points.map(l),[m,v]=[Math.min(...p),Math.max(...p)],[A,M]=_.height_mm??[h-2*d,u+2*d];f.append(_l([[m,A],[v,A],[v,M],[m,M]],"wall",_.name))}let g=n.part_radius_mm;if(f.append(_l([[-g,h],[g,h],[g,u],[-g,u]],"part","part")),n.lit_radius_mm!==null)for(let _ of[-n.lit_radius_mm,n.lit_radius_mm])f.append(At("line",{class:"lit",x1:_,x2:_,y1:-u-d,y2:-h+d}));return f.append(...pp(e.map(_=>({points:_.points.map(p=>[l(p),p[2]]),from:_.resin_from})),c)),f}function fp(n,e,t){return At("svg",{class:"path-view",viewBox:`${n[0]} ${-e[1]} ${n[1]-n[0]} ${e[1]-e[0]}`,role:"img","aria-label":t})}function _l(n,e,t){return At("path",{class:e,d:`${fu(n)}Z`},At("title",{},t))}function fu(n){return`M${n.map(([e,t])=>`${e.toFixed(4)},${(-t).toFixed(4)}`).join("L")}`}function pp(n,e){return n.flatMap(({points:t,from:i})=>{let s=t.slice(0,i+1);return s.length>1&&(s[0]=Cx(s[0],s[1],e)),[At("path",{class:"ray",d:fu(s)}),t.length>i+1&&At("path",{class:"ray resin",d:fu(t.slice(i))})].filter(r=>r!==!1)})}function Cx([n,e],[t,i],s){let r=Math.abs(n)>Math.abs(e)?Math.abs(n):Math.abs(e);if(r<=s)return[n,e];let o=Math.max(Math.abs(t),Math.abs(i)),a=r>o?Math.min((r-s)/(r-o),1):0;return[n+a*(t-n),e+a*(i-e)]}async function Rx(n,e,t){let i=es(n,"target","");if(!i)return null;let s=await e.volume(i),r=s.slice(2,t??(s.range(2)[0]+s.range(2)[1])/2);if(!r)return null;let o=On("--solid"),a=s.info.high,l=Uint32Array.from(r.values,f=>cr(o,Math.min(Math.max(f/a,0),1)*.75)),c=new Uint32Array(r.codes.length);for(let f=0;f<c.length;f++)c[f]=l[r.codes[f]];let h=document.createElement("canvas");[h.width,h.height]=[r.width,r.height],h.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(c.buffer),r.width,r.height),0,0);let[u,d]=Qn[2];return{url:h.toDataURL(),left:s.range(u)[0],top:s.range(d)[1],width:r.width*r.pitch[0],height:r.height*r.pitch[1]}}var xp={id:"film",title:"Patterns and light",render:n=>{let{run:e,state:t,gone:i}=n,s=e.films.length>0?e.films.map(({light:u})=>u):(e.scene?.lights??[]).map(({name:u})=>u);if(s.length===0)return null;let r=()=>Math.min(t.get("light"),s.length-1),o=T("div"),a=new AbortController,l=()=>{a.abort(),a=new AbortController;let{signal:u}=a,d=e.films.length===0&&e.scene?pu(n,e.scene,r(),null,u):null;o.replaceChildren(d??Ni(n,()=>Ix(n,r(),u)))},c=t.on(["light"],()=>{t.set({frame:0,row:null}),l()});i.addEventListener("abort",()=>{c(),a.abort()}),l();let h=s.map((u,d)=>[String(d),u||`light ${d+1}`]);return T("div",{},h.length>1&&wi("Light",h,()=>String(r()),u=>t.set({light:Number(u)}),u=>i.addEventListener("abort",t.on(["light"],u))),o)}},Px=8;async function Ix({run:n,state:e,store:t},i,s){let r=n.films[i],{values:o}=await t.film(r),a=new gu({info:r,values:o}),l=r.frames-1,c=()=>Math.min(e.get("frame"),l),h=()=>Math.min(e.get("row")??r.rows>>1,r.rows-1),u=T("output"),d=T("input",{type:"range",min:0,max:l,step:1,"aria-label":"Frame",input:S=>e.set({frame:Number(S.target.value)})}),f=T("input",{type:"range",min:0,max:r.rows-1,step:1,"aria-label":"Row of the sinogram",input:S=>e.set({row:Number(S.target.value)})}),g=T("output.quiet"),_=T("output.quiet"),p=T("input",{type:"range",min:0,max:5,step:.25,value:0,"aria-label":"Stretch of the brightness"}),m=T("button",{type:"button","aria-label":"Play the film"},"Play"),v=T("div.color-legend"),A=()=>{let[S,k]=[c(),h()];[d.value,f.value]=[String(S),String(k)];let U=`frame ${S*r.every+1} of ${r.of[0]}, ${mu(r.angles_deg[S])}`;u.textContent=U,d.setAttribute("aria-valuetext",U),a.sinogram.setAttribute("aria-valuenow",String(S)),a.sinogram.setAttribute("aria-valuetext",U),g.textContent=`row ${k*r.binned+1} of ${r.of[1]} from the top`,a.draw(S,k)},M=()=>{a.gain=2**Number(p.value),_.textContent=a.gain===1?"as shown":`${he(a.gain,3)} ×`,v.replaceChildren(Ei({scale:{low:0,high:r.full_scale/a.gain,logarithmic:!1,map:nu},label:"pattern value",mark:null})),a.draw(c(),h())};p.addEventListener("input",M,{signal:s}),a.choose=S=>e.set({frame:Math.min(Math.max(S,0),l)}),a.chooseRow=S=>e.set({row:Math.min(Math.max(S,0),r.rows-1)}),Lx(m,r,s,()=>e.set({frame:(c()+1)%r.frames}));let R=e.on(["frame","row"],A);s.addEventListener("abort",()=>{R(),a.end()}),A(),M();let C=[r.every>1&&`every ${Dx(r.every)} frame`,r.binned>1&&`means of ${r.binned} × ${r.binned} pixels`].filter(Boolean).join(", "),x=n.scene&&pu({run:n,state:e,store:t},n.scene,i,()=>r.angles_deg[c()],s);return T("div.film",{},T("p.quiet",{},`${r.of[0]} frames of ${r.of[2]} × ${r.of[1]} pixels.${C?` Shown: ${C}.`:""} Click in the sinogram to choose a frame, in the frame to choose the row of the sinogram.`),T("div.film-views",{},T("figure",{},T("figcaption",{},T("span",{},"Frame"),u),a.frame),T("figure",{},T("figcaption",{},T("span",{},"Sinogram"),g),a.sinogram,T("div.film-axis.quiet",{},T("span",{},mu(r.angles_deg[0])),T("span",{},"angle of the frame"),T("span",{},mu(r.angles_deg[l]))))),T("div.film-controls",{},m,T("label",{},"Frame",d),T("label",{},"Row",f),T("label",{},"Stretch",p,_),v),x)}var gu=class{constructor(e){this.film=e;let{info:t}=e;this.frame.style.aspectRatio=`${t.columns*t.pitch_mm[0]} / ${t.rows*t.pitch_mm[1]}`,this.sinogram.setAttribute("aria-valuemax",String(t.frames-1));for(let s of[this.frame,this.sinogram])this.watcher.observe(s);let i=(s,r)=>{let o=a=>{if(a.buttons!==1)return;let l=s.getBoundingClientRect();r((a.clientX-l.left)/l.width,(a.clientY-l.top)/l.height)};s.addEventListener("pointerdown",o),s.addEventListener("pointermove",o)};i(this.sinogram,s=>this.choose(Math.floor(s*t.frames))),i(this.frame,(s,r)=>this.chooseRow(Math.floor(r*t.rows))),this.sinogram.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:10,PageDown:-10,Home:-t.frames,End:t.frames};s.key in r&&(s.preventDefault(),this.choose(this.shown[0]+r[s.key]))})}film;frame=T("canvas");sinogram=T("canvas",{tabindex:0,role:"slider","aria-label":"Sinogram: arrow keys choose the frame","aria-valuemin":0});gain=1;choose=()=>{};chooseRow=()=>{};image=document.createElement("canvas");watcher=new ResizeObserver(()=>this.draw(...this.shown));shown=[0,0];painted="";end(){this.watcher.disconnect()}draw(e,t){this.shown=[e,t],this.drawFrame(e,t),this.drawSinogram(e,t)}drawFrame(e,t){let{info:i,values:s}=this.film,r=gp(this.frame);if(!r)return;let o=i.rows*i.columns,a=document.createElement("canvas");mp(a,i.columns,i.rows,this.palette(),s.subarray(e*o,(e+1)*o)),r.drawImage(a,0,0,r.canvas.width,r.canvas.height),_p(r,"y",(t+.5)/i.rows)}drawSinogram(e,t){let{info:i,values:s}=this.film,r=gp(this.sinogram);if(!r)return;let o=`${t} ${this.gain}`;if(this.painted!==o){this.painted=o;let a=new Uint8Array(i.frames*i.columns);for(let l=0;l<i.frames;l++){let c=(l*i.rows+t)*i.columns;for(let h=0;h<i.columns;h++)a[h*i.frames+l]=s[c+h]}mp(this.image,i.frames,i.columns,this.palette(),a)}r.drawImage(this.image,0,0,r.canvas.width,r.canvas.height),_p(r,"x",(e+.5)/i.frames)}palette(){return Uint32Array.from({length:256},(e,t)=>nu(t/255*this.gain))}};function mp(n,e,t,i,s){let r=new Uint32Array(e*t);for(let o=0;o<r.length;o++)r[o]=i[s[o]];[n.width,n.height]=[e,t],n.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(r.buffer),e,t),0,0)}function gp(n){let e=window.devicePixelRatio||1,[t,i]=[Math.round(n.clientWidth*e),Math.round(n.clientHeight*e)];if(t===0||i===0)return null;(n.width!==t||n.height!==i)&&([n.width,n.height]=[t,i]);let s=n.getContext("2d");return s&&(s.imageSmoothingEnabled=!1),s}function _p(n,e,t){let{width:i,height:s}=n.canvas,r=Math.max(Math.round(window.devicePixelRatio||1),1);for(let[o,a]of[["rgb(0 0 0 / 0.5)",r],["rgb(255 255 255 / 0.8)",0]])n.fillStyle=o,e==="x"?n.fillRect(Math.round(t*i)+a,0,r,s):n.fillRect(0,Math.round(t*s)+a,i,r)}function Lx(n,e,t,i){let s=0,r=()=>{window.clearInterval(s),s=0,n.textContent="Play",n.setAttribute("aria-label","Play the film")};n.addEventListener("click",()=>{if(s!==0)return r();s=window.setInterval(i,Math.max(1e3*Px/e.frames,40)),n.textContent="Pause",n.setAttribute("aria-label","Pause the film")}),t.addEventListener("abort",r)}function mu(n){return`${he(n,4)}°`}function Dx(n){return n===2?"2nd":n===3?"3rd":`${n}th`}var yp={id:"in-time",title:"How the print grows",render:n=>{let e=n.run.volumes.filter(({kind:l})=>l==="cure_time");if(e.length===0)return null;let t=0,i=new AbortController,s=T("div"),r=new EventTarget,o=l=>{i.abort(),i=new AbortController,t=l,s.replaceChildren(Ni(n,()=>Ux(n,e[l],i.signal))),r.dispatchEvent(new Event("change"))};n.gone.addEventListener("abort",()=>i.abort()),o(0);let a=e.map(({species:l,name:c},h)=>[String(h),l??c]);return T("div",{},a.length>1&&wi("Resin",a,()=>String(t),l=>o(Number(l)),l=>r.addEventListener("change",l)),s)}},Nx=10,_u=500;async function Ux({run:n,state:e,store:t},i,s){let r=await t.volume(i),o=es(n,"target",i.species??""),a=o?await t.volume(o).catch(()=>null):null,l=Ox(n.report,i.species),c=i.high,h=l?.best_s??null,u=()=>Math.min(e.get("time")??h??c,c),d=Fx(r),f={low:Math.min(i.low,c),high:c,logarithmic:!1,map:lr},g={id:"growth",title:"Time of cure",picture:(S,k)=>{let U=r.slice(S,k);if(!U)return null;let D=u(),G=ul(U.values,f).map((I,V)=>U.values[V]<=D?I:0),X=new Uint32Array(U.codes.length);for(let I=0;I<X.length;I++)X[I]=G[U.codes[I]];return{...U,pixels:X}},value:S=>{let k=r.at(S);return k===null?"stays liquid":`solid after ${Si(k)}`},legend:()=>({scale:f,label:"solid after, s",mark:null})},_=T("p.readout"),p=new Vs({state:e,grid:r,signal:s,hover:S=>{_.textContent=g.value(S??p.at())}});p.show([2,1,0].map(S=>({axis:S,layer:g,outlines:(k,U)=>{let D=a?.slice(k,U);return D?[{slice:D,segments:sl(D,.5),color:"--outline-growth"}]:[]}})));let m=T("input",{type:"range",min:0,max:_u,step:1,"aria-label":"Time",input:()=>e.set({time:Number(m.value)/_u*c})}),v=T("output"),A=()=>{let S=u();m.value=String(Math.round(S/c*_u)),m.setAttribute("aria-valuetext",Si(S));let k=Bx(l?.curves?.seconds,l?.curves?.jaccard,S);v.replaceChildren(T("b",{},Si(S)),`  ${he(d(S),3)} mm³ solid${k===null?"":`, Jaccard index ${he(k,3)}`}`),p.redraw(!0),_.textContent=g.value(p.at())},M=e.on(["time","at"],A),R=T("button",{type:"button"},"Play"),C=0,x=()=>{window.clearInterval(C),C=0,R.textContent="Play"};return R.addEventListener("click",()=>{if(C!==0)return x();R.textContent="Pause",u()>=c&&e.set({time:0}),C=window.setInterval(()=>{e.set({time:Math.min(u()+.05/Nx*c,c)}),u()>=c&&x()},50)}),s.addEventListener("abort",()=>{M(),x()}),A(),T("div",{},T("p.quiet",{},"What is solid at a moment, colored by when it became solid. The line is the part’s outline."),T("div.time-controls",{},R,m,v,h!==null&&T("button",{type:"button",click:()=>e.set({time:null})},`Best moment: ${Si(h)}`)),p.element,T("div.below-planes",{},_,Ei(g.legend())))}function Ox(n,e){let t=n?.time??[];return t.find(i=>i.name===e)??t[0]??null}function Fx(n){let e=new Float64Array(n.values.length);for(let i of n.codes)e[i]++;let t=n.pitch[0]*n.pitch[1]*n.pitch[2];return i=>t*e.reduce((s,r,o)=>n.values[o]<=i?s+r:s,0)}function Bx(n,e,t){if(!n||!e)return null;let i=n.findIndex(s=>s>t+1e-9);return i<0&&(i=n.length),i===0?null:e[i-1]??null}function vp(n,e){if(n.served===null)return null;let{served:t}=n,i=T("div.live",{role:"status"}),s=new Map,r=l=>{let c=s.get(l);return c||(c=new xu(n.runs[l].name,()=>fetch(`${t}cancel/${l}`,{method:"POST"})),s.set(l,c),i.append(c.element)),c};n.runs.forEach(({state:l},c)=>{l==="running"&&r(c)});let o=T("p.problem",{hidden:!0},"The viewer does not answer. What is shown is the last that it sent; it is asked again.");i.append(o);let a=new EventSource(`${t}events`);return a.addEventListener("error",()=>o.hidden=!1),a.addEventListener("open",()=>o.hidden=!0),a.addEventListener("message",({data:l})=>{let c=JSON.parse(l);if(c.type==="states"){c.states.forEach((u,d)=>{n.runs[d]&&n.runs[d].state!==u&&e.replaced(d)});return}let h=n.runs[c.run];if(h)switch(c.type){case"stage":r(c.run).stage(c.name);break;case"part":r(c.run).part(c.fraction,c.left_s);break;case"iteration":kx(h.history,c.row),r(c.run).iteration(c.row.iteration??null,c.iterations),e.row(c.run);break;case"failed":h.state="done",r(c.run).end(c.message);break;case"done":r(c.run).end(null),s.delete(c.run),e.replaced(c.run);break;case"snapshot":e.replaced(c.run);break}}),i}async function bp(n){let e=await fetch(`${n.served}runs.json`);if(!e.ok)throw new Error(`The viewer answered ${e.status}.`);return await e.json()}function kx(n,e){let t=Math.max(0,...Object.values(n).map(i=>i.length));for(let i of new Set([...Object.keys(n),...Object.keys(e)]))n[i]??=new Array(t).fill(null),n[i].push(e[i]??null)}var xu=class{progress=T("progress",{max:1});text=T("span.quiet",{},"waiting");cancel;element;name="";constructor(e,t){this.cancel=T("button",{type:"button"},"Cancel"),this.cancel.addEventListener("click",()=>{this.cancel.disabled=!0,this.cancel.textContent="Canceling…",t().catch(()=>{this.cancel.disabled=!1,this.cancel.textContent="Cancel"})}),this.progress.setAttribute("aria-label",`Progress of ${e}`),this.element=T("div.live-run",{},T("b",{},e),this.progress,this.text,this.cancel)}stage(e){this.name=e,this.show(null,null)}part(e,t){this.show(e,`${Math.round(100*e)} %${t===null?"":`, ${Si(t)} left`}`)}iteration(e,t){e!==null&&this.show(t?e/t:null,`iteration ${e}${t?` of at most ${t}`:""}`)}show(e,t){e===null?this.progress.removeAttribute("value"):this.progress.value=e,this.text.textContent=[this.name||"running",t].filter(Boolean).join(": ")}end(e){e===null?this.element.remove():this.element.replaceChildren(this.element.firstElementChild,T("span.problem",{role:"alert"},e))}};var zx="uplot",Vx="u-hz",Hx="u-vt",Gx="u-title",Wx="u-wrap",Xx="u-under",qx="u-over",$x="u-axis",fr="u-off",Yx="u-select",Zx="u-cursor-x",Kx="u-cursor-y",Jx="u-cursor-pt",jx="u-legend",Qx="u-live",ey="u-inline",ty="u-series",ny="u-marker",Mp="u-label",iy="u-value",na="width",ia="height";var Sp="bottom",qr="left",yu="right",Ou="#000",wp=Ou+"0",vu="mousemove",Ep="mousedown",bu="mouseup",Tp="mouseenter",Ap="mouseleave",Cp="dblclick",sy="resize",ry="scroll",Rp="change",Ml="dppxchange",Fu="--",Qr=typeof window<"u",Tu=Qr?document:null,Yr=Qr?window:null,oy=Qr?navigator:null,Ct,xl;function Au(){let n=devicePixelRatio;Ct!=n&&(Ct=n,xl&&Ru(Rp,xl,Au),xl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),pr(Rp,xl,Au),Yr.dispatchEvent(new CustomEvent(Ml)))}function hi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Cu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function Ui(n,e,t,i){let s=Tu.createElement(n);return e!=null&&hi(s,e),t?.insertBefore(s,i),s}function Ti(n,e){return Ui("div",n,e)}var Pp=new WeakMap;function ts(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Pp.get(n);r!=o&&(n.style.transform=r,Pp.set(n,r),e<0||t<0||e>i||t>s?hi(n,fr):Cu(n,fr))}var Ip=new WeakMap;function Lp(n,e,t){let i=e+t,s=Ip.get(n);i!=s&&(Ip.set(n,i),n.style.background=e,n.style.borderColor=t)}var Dp=new WeakMap;function Np(n,e,t,i){let s=e+""+t,r=Dp.get(n);s!=r&&(Dp.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Bu={passive:!0},ay={...Bu,capture:!0};function pr(n,e,t,i){e.addEventListener(n,t,i?ay:Bu)}function Ru(n,e,t,i){e.removeEventListener(n,t,Bu)}Qr&&Au();function Oi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ui((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function lm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var cm=n=>n!=null,hm=n=>n!=null&&n>0,El=lm(cm),ly=lm(hm);function cy(n,e,t,i=0,s=!1){let r=s?ly:El,o=s?hm:cm;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??kt,l??-kt]}function Tl(n,e,t,i){let s=Fp(n),r=Fp(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?ms:um,a=s==1?ui:Ai,l=r==1?Ai:ui,c=a(o(Sn(n))),h=l(o(Sn(e))),u=Zr(t,c),d=Zr(t,h);return t==10&&(c<0&&(u=zt(u,-c)),h<0&&(d=zt(d,-h))),i||t==2?(n=u*s,e=d*r):(n=mm(n,u),e=Al(e,d)),[n,e]}function ku(n,e,t,i){let s=Tl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var zu=.1,Up={mode:3,pad:zu},ra={pad:0,soft:null,mode:0},hy={min:ra,max:ra};function Sl(n,e,t,i){return Cl(t)?Op(n,e,t):(ra.pad=t,ra.soft=i?0:null,ra.mode=i?3:0,Op(n,e,hy))}function Et(n,e){return n??e}function uy(n,e,t){for(e=Et(e,0),t=Et(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Op(n,e,t){let i=t.min,s=t.max,r=Et(i.pad,0),o=Et(s.pad,0),a=Et(i.hard,-kt),l=Et(s.hard,kt),c=Et(i.soft,kt),h=Et(s.soft,-kt),u=Et(i.mode,0),d=Et(s.mode,0),f=e-n,g=ms(f),_=Yn(Sn(n),Sn(e)),p=ms(_),m=Sn(p-g);(f<1e-24||m>10)&&(f=0,(n==0||e==0)&&(f=1e-24,u==2&&c!=kt&&(r=0),d==2&&h!=-kt&&(o=0)));let v=f||_||1e3,A=ms(v),M=Zr(10,ui(A)),R=v*(f==0?n==0?.1:1:r),C=zt(mm(n-R,M/10),24),x=n>=c&&(u==1||u==3&&C<=c||u==2&&C>=c)?c:kt,S=Yn(a,C<x&&n>=x?x:Fi(x,C)),k=v*(f==0?e==0?.1:1:o),U=zt(Al(e+k,M/10),24),D=e<=h&&(d==1||d==3&&U>=h||d==2&&U<=h)?h:-kt,G=Fi(l,U>D&&e<=D?D:Yn(D,U));return S==G&&S==0&&(G=100),[S,G]}var dy=new Intl.NumberFormat(Qr?oy.language:"en-US"),Vu=n=>dy.format(n),di=Math,bl=di.PI,Sn=di.abs,ui=di.floor,Mn=di.round,Ai=di.ceil,Fi=di.min,Yn=di.max,Zr=di.pow,Fp=di.sign,ms=di.log10,um=di.log2,fy=(n,e=1)=>di.sinh(n)*e,Mu=(n,e=1)=>di.asinh(n/e),kt=1/0;function Bp(n){return(ms((n^n>>31)-(n>>31))|0)+1}function Pu(n,e,t){return Fi(Yn(n,e),t)}function dm(n){return typeof n=="function"}function yt(n){return dm(n)?n:()=>n}var py=()=>{},fm=n=>n,pm=(n,e)=>e,my=n=>null,kp=n=>!0,zp=(n,e)=>n==e,gy=/\.\d*?(?=9{6,}|0{6,})/gm,mr=n=>{if(_m(n)||Gs.has(n))return n;let e=`${n}`,t=e.match(gy);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${mr(s)}e${r}`}return zt(n,i)};function ur(n,e){return mr(zt(mr(n/e))*e)}function Al(n,e){return mr(Ai(mr(n/e))*e)}function mm(n,e){return mr(ui(mr(n/e))*e)}function zt(n,e=0){if(_m(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Gs=new Map;function gm(n){return((""+n).split(".")[1]||"").length}function aa(n,e,t,i){let s=[],r=i.map(gm);for(let o=e;o<t;o++){let a=Sn(o),l=zt(Zr(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:zt(h,u);s.push(d),Gs.set(d,u)}}return s}var oa={},Hu=[],Kr=[null,null],Hs=Array.isArray,_m=Number.isInteger,_y=n=>n===void 0;function Vp(n){return typeof n=="string"}function Cl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function xy(n){return n!=null&&typeof n=="object"}var yy=Object.getPrototypeOf(Uint8Array),xm="__proto__";function Jr(n,e=Cl){let t;if(Hs(n)){let i=n.find(s=>s!=null);if(Hs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Jr(n[s],e)}else t=n.slice()}else if(n instanceof yy)t=n.slice();else if(e(n)){t={};for(let i in n)i!=xm&&(t[i]=Jr(n[i],e))}else t=n;return t}function gn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=xm&&(Cl(n[s])?gn(n[s],Jr(i[s])):n[s]=Jr(i[s]))}return n}var vy=0,by=1,My=2;function Sy(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function wy(n,e){if(Ay(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Cy(o[0])||(o=Ty(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:by,f=[];for(let g=0;g<h.length;g++){let _=h[g],p=r.get(l[g]);_===null?d!=vy&&(u[p]=_,d==My&&f.push(p)):u[p]=_}Sy(u,f,s),i.push(u)}}return i}var Ey=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Ty(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Ay(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Cy(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,ui((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ym=["January","February","March","April","May","June","July","August","September","October","November","December"],vm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function bm(n){return n.slice(0,3)}var Ry=vm.map(bm),Py=ym.map(bm),Iy={MMMM:ym,MMM:Py,WWWW:vm,WWW:Ry};function ta(n){return(n<10?"0":"")+n}function Ly(n){return(n<10?"00":n<100?"0":"")+n}var Dy={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ta(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ta(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ta(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ta(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ta(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Ly(n.getMilliseconds())};function Gu(n,e){e=e||Iy;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Dy[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Ny=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Uy(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Ny?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Mm=n=>n%1==0,wl=[1,2,2.5,5],Oy=aa(10,-32,0,wl),Sm=aa(10,0,32,wl),Fy=Sm.filter(Mm),dr=Oy.concat(Sm),Wu=`
`,wm="{YYYY}",Hp=Wu+wm,Em="{M}/{D}",sa=Wu+Em,yl=sa+"/{YY}",Tm="{aa}",By="{h}:{mm}",$r=By+Tm,Gp=Wu+$r,Wp=":{ss}",It=null;function Am(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?aa(10,0,3,wl).filter(Mm):aa(10,-3,0,wl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,wm,It,It,It,It,It,It,1],[s*28,"{MMM}",Hp,It,It,It,It,It,1],[s,Em,Hp,It,It,It,It,It,1],[i,"{h}"+Tm,yl,It,sa,It,It,It,1],[t,$r,yl,It,sa,It,It,It,1],[e,Wp,yl+" "+$r,It,sa+" "+$r,It,Gp,It,1],[n,Wp+".{fff}",yl+" "+$r,It,sa+" "+$r,It,Gp,It,1]];function h(u){return(d,f,g,_,p,m)=>{let v=[],A=p>=o,M=p>=r&&p<o,R=u(g),C=zt(R*n,3),x=Su(R.getFullYear(),A?0:R.getMonth(),M||A?1:R.getDate()),S=zt(x*n,3);if(M||A){let k=M?p/r:0,U=A?p/o:0,D=C==S?C:zt(Su(x.getFullYear()+U,x.getMonth()+k,1)*n,3),G=new Date(Mn(D/n)),X=G.getFullYear(),I=G.getMonth();for(let V=0;D<=_;V++){let H=Su(X+U*V,I+k*V,1),B=H-u(zt(H*n,3));D=zt((+H+B)*n,3),D<=_&&v.push(D)}}else{let k=p>=s?s:p,U=ui(g)-ui(C),D=S+U+Al(C-S,k);v.push(D);let G=u(D),X=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,I=p/i,V=d.axes[f]._space,H=m/V;for(;D=zt(D+p,n==1?0:3),!(D>_);)if(I>1){let B=ui(zt(X+I,6))%24,j=u(D).getHours()-B;j>1&&(j=-1),D-=j*i,X=(X+I)%24;let te=v[v.length-1];zt((D-te)/p,3)*H>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[ky,zy,Vy]=Am(1),[Hy,Gy,Wy]=Am(.001);aa(2,-53,53,[1]);function Xp(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function qp(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return i.map(g=>{let _=n(g),p=_.getFullYear(),m=_.getMonth(),v=_.getDate(),A=_.getHours(),M=_.getMinutes(),R=_.getSeconds(),C=p!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||M!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=v,u=A,d=M,f=R,C(_)})}}function Xy(n,e){let t=Gu(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Su(n,e,t){return new Date(n,e,t)}function $p(n,e){return e(n)}var qy="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Yp(n,e){return(t,i,s,r)=>r==null?Fu:e(n(i))}function $y(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Yy(n,e){return n.series[e].fill(n,e)}var Zy={show:!0,live:!0,isolate:!1,mount:py,markers:{show:!0,width:2,stroke:$y,fill:Yy,dash:"solid"},idx:null,idxs:null,values:[]};function Ky(n,e){let t=n.cursor.points,i=Ti(),s=t.size(n,e);qt(i,na,s),qt(i,ia,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function Jy(n,e){let t=n.series[e].points;return t._fill||t._stroke}function jy(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Qy(n,e){return n.series[e].points.size}var wu=[0,0];function ev(n,e,t){return wu[0]=e,wu[1]=t,wu}function vl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Eu(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var tv={show:!0,x:!0,y:!0,lock:!1,move:ev,points:{one:!1,show:Ky,size:Qy,width:0,stroke:jy,fill:Jy},bind:{mousedown:vl,mouseup:vl,click:vl,dblclick:vl,mousemove:Eu,mouseleave:Eu,mouseenter:Eu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Cm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xu=gn({},Cm,{filter:pm}),Rm=gn({},Xu,{size:10}),Pm=gn({},Cm,{show:!1}),qu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Im="bold "+qu,Lm=1.5,Zp={show:!0,scale:"x",stroke:Ou,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Im,side:2,grid:Xu,ticks:Rm,border:Pm,font:qu,lineGap:Lm,rotate:0},nv="Value",iv="Time",Kp={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function sv(n,e,t,i,s){return e.map(r=>r==null?"":Vu(r))}function rv(n,e,t,i,s,r,o){let a=[],l=Gs.get(s)||0;t=o?t:zt(Al(t,s),l);for(let c=t;c<=i;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Iu(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?ms:um,h=ui(c(t));s=Zr(l,h),l==10&&(s=dr[Oi(s,dr)]);let u=t,d=s*l;l==10&&(d=dr[Oi(d,dr)]);do a.push(u),u=u+s,l==10&&!Gs.has(u)&&(u=zt(u,Gs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=dr[Oi(d,dr)]));while(u<=i);return a}function ov(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Iu(n,e,Yn(l,t),i,s):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?Iu(n,e,Yn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Dm=/./,av=/[12357]/,lv=/[125]/,Jp=/1/,Lu=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function cv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Dm:l(7,o)-h>=c?av:l(5,o)-h>=c?lv:Jp;if(u==Jp){let d=Sn(l(1,o)-h);if(d<c)return Lu(e.slice().reverse(),a.distr,u,Ai(c/d)).reverse()}return Lu(e,a.distr,u,1)}function hv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?Lu(e.slice().reverse(),3,Dm,Ai(a/c)).reverse():e}function uv(n,e,t,i){return i==null?Fu:e==null?"":Vu(e)}var jp={show:!0,scale:"y",stroke:Ou,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Im,side:3,grid:Xu,ticks:Rm,border:Pm,font:qu,lineGap:Lm,rotate:0};function dv(n,e){let t=3+(n||1)*2;return zt(t*e,3)}function fv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var Qp={scale:null,auto:!0,sorted:0,min:kt,max:-kt},Nm=(n,e,t,i,s)=>s,em={show:!0,auto:!0,sorted:0,gaps:Nm,alpha:1,facets:[gn({},Qp,{scale:"x"}),gn({},Qp,{scale:"y"})]},tm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Nm,alpha:1,points:{show:fv,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function pv(n,e,t,i,s){return t/10}var Um={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},mv=gn({},Um,{time:!1,ori:1}),nm={};function Om(n,e){let t=nm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(nm[n]=t)),t}var jr=1,Du=2;function gr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,_=a.height,p=n.valToPosH,m=n.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,_,Pl,eo,Ll,Bm,zm):t(s,l,c,h,u,m,p,f,d,_,g,Il,to,Zu,km,Vm)}function $u(n,e){let t=0,i=0,s=Et(n.bands,Hu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function gv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(n,e,t,i,s,r){return gr(n,e,(o,a,l,c,h,u,d,f,g,_,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?eo:to,M,R;v==1?(M=t,R=i):(M=i,R=t);let C=m(u(a[M],c,_,f)),x=m(d(l[M],h,p,g)),S=m(u(a[R],c,_,f)),k=m(d(r==1?h.max:h.min,h,p,g)),U=new Path2D(s);return A(U,S,k),A(U,C,k),A(U,C,x),U})}function Rl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ll:Zu,l=t;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function _v(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Yu(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[u]),g=d==u?f:r(n[d]),_=u-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function im(n){return n==0?fm:n==1?Mn:e=>ur(e,n)}function Fm(n){let e=n==0?Pl:Il,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Fi(c,a/2,l/2),h=Fi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Pl=(n,e,t)=>{n.moveTo(e,t)},Il=(n,e,t)=>{n.moveTo(t,e)},eo=(n,e,t)=>{n.lineTo(e,t)},to=(n,e,t)=>{n.lineTo(t,e)},Ll=Fm(0),Zu=Fm(1),Bm=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},km=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},zm=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Vm=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Hm(n){return(e,t,i,s,r)=>gr(e,t,(o,a,l,c,h,u,d,f,g,_,p)=>{let{pxRound:m,points:v}=o,A,M;c.ori==0?(A=Pl,M=Bm):(A=Il,M=km);let R=zt(v.width*Ct,3),C=(v.size-v.width)/2*Ct,x=zt(C*2,3),S=new Path2D,k=new Path2D,{left:U,top:D,width:G,height:X}=e.bbox;Ll(k,U-x,D-x,G+x*2,X+x*2);let I=V=>{if(l[V]!=null){let H=m(u(a[V],c,_,f)),B=m(d(l[V],h,p,g));A(S,H+C,B),M(S,H,B,C,0,bl*2)}};if(r)r.forEach(I);else for(let V=i;V<=s;V++)I(V);return{stroke:R>0?S:null,fill:S,clip:k,flags:jr|Du}})}function Gm(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var xv=Gm(eo),yv=Gm(to);function Wm(n){let e=Et(n?.alignGaps,0);return(t,i,s,r)=>gr(t,i,(o,a,l,c,h,u,d,f,g,_,p)=>{[s,r]=El(l,s,r);let m=o.pxRound,v=X=>m(u(X,c,_,f)),A=X=>m(d(X,h,p,g)),M,R;c.ori==0?(M=eo,R=xv):(M=to,R=yv);let C=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jr},S=x.stroke,k=!1;if(r-s>=_*4){let X=fe=>t.posToVal(fe,c.key,!0),I=null,V=null,H,B,le,Y=v(a[C==1?s:r]),j=v(a[s]),te=v(a[r]),ue=X(C==1?j+1:te-1);for(let fe=C==1?s:r;fe>=s&&fe<=r;fe+=C){let ee=a[fe],_e=(C==1?ee<ue:ee>ue)?Y:v(ee),Re=l[fe];_e==Y?Re!=null?(B=Re,I==null?(M(S,_e,A(B)),H=I=V=B):B<I?I=B:B>V&&(V=B)):Re===null&&(k=!0):(I!=null&&R(S,Y,A(I),A(V),A(H),A(B)),Re!=null?(B=Re,M(S,_e,A(B)),I=V=H=B):(I=V=null,Re===null&&(k=!0)),Y=_e,ue=X(Y+C))}I!=null&&I!=V&&le!=Y&&R(S,Y,A(I),A(V),A(H),A(B))}else for(let X=C==1?s:r;X>=s&&X<=r;X+=C){let I=l[X];I===null?k=!0:I!=null&&M(S,v(a[X]),A(I))}let[D,G]=$u(t,i);if(o.fill!=null||D!=0){let X=x.fill=new Path2D(S),I=o.fillTo(t,i,o.min,o.max,D),V=A(I),H=v(a[s]),B=v(a[r]);C==-1&&([B,H]=[H,B]),M(X,B,V),M(X,H,V)}if(!o.spanGaps){let X=[];k&&X.push(...Yu(a,l,s,r,C,v,e)),x.gaps=X=o.gaps(t,i,s,r,X),x.clip=Rl(X,c.ori,f,g,_,p)}return G!=0&&(x.band=G==2?[gs(t,i,s,r,S,-1),gs(t,i,s,r,S,1)]:gs(t,i,s,r,S,G)),x})}function vv(n){let e=Et(n.align,1),t=Et(n.ascDesc,!1),i=Et(n.alignGaps,0),s=Et(n.extend,!1);return(r,o,a,l)=>gr(r,o,(c,h,u,d,f,g,_,p,m,v,A)=>{[a,l]=El(u,a,l);let M=c.pxRound,{left:R,width:C}=r.bbox,x=j=>M(g(j,d,v,p)),S=j=>M(_(j,f,A,m)),k=d.ori==0?eo:to,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jr},D=U.stroke,G=d.dir*(d.ori==0?1:-1),X=S(u[G==1?a:l]),I=x(h[G==1?a:l]),V=I,H=I;s&&e==-1&&(H=R,k(D,H,X)),k(D,I,X);for(let j=G==1?a:l;j>=a&&j<=l;j+=G){let te=u[j];if(te==null)continue;let ue=x(h[j]),fe=S(te);e==1?k(D,ue,X):k(D,V,fe),k(D,ue,fe),X=fe,V=ue}let B=V;s&&e==1&&(B=R+C,k(D,B,X));let[le,Y]=$u(r,o);if(c.fill!=null||le!=0){let j=U.fill=new Path2D(D),te=c.fillTo(r,o,c.min,c.max,le),ue=S(te);k(j,B,ue),k(j,H,ue)}if(!c.spanGaps){let j=[];j.push(...Yu(h,u,a,l,G,x,i));let te=c.width*Ct/2,ue=t||e==1?te:-te,fe=t||e==-1?-te:te;j.forEach(ee=>{ee[0]+=ue,ee[1]+=fe}),U.gaps=j=c.gaps(r,o,a,l,j),U.clip=Rl(j,d.ori,p,m,v,A)}return Y!=0&&(U.band=Y==2?[gs(r,o,a,l,D,-1),gs(r,o,a,l,D,1)]:gs(r,o,a,l,D,Y)),U})}function sm(n,e,t,i,s,r,o=kt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Sn(n[l]-n[a]);h<c&&(c=h,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function bv(n){n=n||oa;let e=Et(n.size,[.6,kt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Et(e[1],kt),l=Et(e[2],1),c=Et(n.disp,oa),h=Et(n.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,_,p)=>gr(f,g,(m,v,A,M,R,C,x,S,k,U,D)=>{let G=m.pxRound,X=t,I=i*Ct,V=a*Ct,H=l*Ct,B,le;M.ori==0?[B,le]=r(f,g):[le,B]=r(f,g);let Y=M.dir*(M.ori==0?1:-1),j=M.ori==0?Ll:Zu,te=M.ori==0?h:(Ie,Ye,ot,Ee,Bt,He,$e)=>{h(Ie,Ye,ot,Bt,Ee,$e,He)},ue=Et(f.bands,Hu).find(Ie=>Ie.series[0]==g),fe=ue!=null?ue.dir:0,ee=m.fillTo(f,g,m.min,m.max,fe),pe=G(x(ee,R,D,k)),_e,Re,we,Xe=U,rt=G(m.width*Ct),Ge=!1,ft=null,ht=null,it=null,Zt=null;u!=null&&(rt==0||d!=null)&&(Ge=!0,ft=u.values(f,g,_,p),ht=new Map,new Set(ft).forEach(Ie=>{Ie!=null&&ht.set(Ie,new Path2D)}),rt>0&&(it=d.values(f,g,_,p),Zt=new Map,new Set(it).forEach(Ie=>{Ie!=null&&Zt.set(Ie,new Path2D)})));let{x0:Vt,size:hn}=c;if(Vt!=null&&hn!=null){X=1,v=Vt.values(f,g,_,p),Vt.unit==2&&(v=v.map(ot=>f.posToVal(S+ot*U,M.key,!0)));let Ie=hn.values(f,g,_,p);hn.unit==2?Re=Ie[0]*U:Re=C(Ie[0],M,U,S)-C(0,M,U,S),Xe=sm(v,A,C,M,U,S,Xe),we=Xe-Re+I}else Xe=sm(v,A,C,M,U,S,Xe),we=Xe*o+I,Re=Xe-we;we<1&&(we=0),rt>=Re/2&&(rt=0),we<5&&(G=fm);let Ot=we>0,An=Xe-we-(Ot?rt:0);Re=G(Pu(An,H,V)),_e=(X==0?Re/2:X==Y?0:Re)-X*Y*((X==0?I/2:0)+(Ot?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vn=Ge?null:new Path2D,tn=null;if(ue!=null)tn=f.data[ue.series[1]];else{let{y0:Ie,y1:Ye}=c;Ie!=null&&Ye!=null&&(A=Ye.values(f,g,_,p),tn=Ie.values(f,g,_,p))}let un=B*Re,F=le*Re;for(let Ie=Y==1?_:p;Ie>=_&&Ie<=p;Ie+=Y){let Ye=A[Ie];if(Ye==null)continue;if(tn!=null){let q=tn[Ie]??0;if(Ye-q==0)continue;pe=x(q,R,D,k)}let ot=M.distr!=2||c!=null?v[Ie]:Ie,Ee=C(ot,M,U,S),Bt=x(Et(Ye,ee),R,D,k),He=G(Ee-_e),$e=G(Yn(Bt,pe)),P=G(Fi(Bt,pe)),b=$e-P;if(Ye!=null){let q=Ye<0?F:un,de=Ye<0?un:F;Ge?(rt>0&&it[Ie]!=null&&j(Zt.get(it[Ie]),He,P+ui(rt/2),Re,Yn(0,b-rt),q,de),ft[Ie]!=null&&j(ht.get(ft[Ie]),He,P+ui(rt/2),Re,Yn(0,b-rt),q,de)):j(vn,He,P+ui(rt/2),Re,Yn(0,b-rt),q,de),te(f,g,Ie,He-rt/2,P,Re+rt,b)}}return rt>0?Mt.stroke=Ge?Zt:vn:Ge||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=Ge?ht:vn,Mt})}function Mv(n,e){let t=Et(e?.alignGaps,0);return(i,s,r,o)=>gr(i,s,(a,l,c,h,u,d,f,g,_,p,m)=>{[r,o]=El(c,r,o);let v=a.pxRound,A=B=>v(d(B,h,p,g)),M=B=>v(f(B,u,m,_)),R,C,x;h.ori==0?(R=Pl,x=eo,C=zm):(R=Il,x=to,C=Vm);let S=h.dir*(h.ori==0?1:-1),k=A(l[S==1?r:o]),U=k,D=[],G=[];for(let B=S==1?r:o;B>=r&&B<=o;B+=S)if(c[B]!=null){let Y=l[B],j=A(Y);D.push(U=j),G.push(M(c[B]))}let X={stroke:n(D,G,R,x,C,v),fill:null,clip:null,band:null,gaps:null,flags:jr},I=X.stroke,[V,H]=$u(i,s);if(a.fill!=null||V!=0){let B=X.fill=new Path2D(I),le=a.fillTo(i,s,a.min,a.max,V),Y=M(le);x(B,U,Y),x(B,k,Y)}if(!a.spanGaps){let B=[];B.push(...Yu(l,c,r,o,S,A,t)),X.gaps=B=a.gaps(i,s,r,o,B),X.clip=Rl(B,h.ori,g,_,p,m)}return H!=0&&(X.band=H==2?[gs(i,s,r,o,I,-1),gs(i,s,r,o,I,1)]:gs(i,s,r,o,I,H)),X})}function Sv(n){return Mv(wv,n)}function wv(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=n[d+1]-n[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,e[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,n[d+1],e[d+1])}return a}var Nu=new Set;function rm(){for(let n of Nu)n.syncRect(!0)}Qr&&(pr(sy,Yr,rm),pr(ry,Yr,rm,!0),pr(Ml,Yr,()=>{_n.pxRatio=Ct}));var Ev=Wm(),Tv=Hm();function om(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Uu(r,o,e,t))}function Av(n,e){return n.map((t,i)=>i==0?{}:gn({},e,t))}function Uu(n,e,t,i){return gn({},e==0?t:i,n)}function Xm(n,e,t){return e==null?Kr:[e,t]}var Cv=Xm;function Rv(n,e,t){return e==null?Kr:Sl(e,t,zu,!0)}function qm(n,e,t,i){return e==null?Kr:Tl(e,t,n.scales[i].log,!1)}var Pv=qm;function $m(n,e,t,i){return e==null?Kr:ku(e,t,n.scales[i].log,!1)}var Iv=$m;function Lv(n,e,t,i,s){let r=Yn(Bp(n),Bp(e)),o=e-n,a=Oi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Gs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function am(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Ct))+"px"),[n,e,t]}function Dv(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=zt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function _n(n,e,t){let i={mode:Et(n.mode,1)},s=i.mode;function r(y,w,L,N){let W=w.valToPct(y);return N+L*(w.dir==-1?1-W:W)}function o(y,w,L,N){let W=w.valToPct(y);return N+L*(w.dir==-1?W:1-W)}function a(y,w,L,N){return w.ori==0?r(y,w,L,N):o(y,w,L,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ti(zx);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let y=Ti(Gx,c);y.textContent=n.title}let h=Ui("canvas"),u=i.ctx=h.getContext("2d"),d=Ti(Wx,c);pr("click",d,y=>{y.target===g&&(Gt!=Fr||Kt!=Br)&&Nn.click(i,y)},!0);let f=i.under=Ti(Xx,d);d.appendChild(h);let g=i.over=Ti(qx,d);n=Jr(n);let _=+Et(n.pxAlign,1),p=im(_);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?om(n.series||[],Kp,tm,!1):Av(n.series||[null],em),A=i.axes=om(n.axes||[],Zp,jp,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(y=>{y.fill=yt(y.fill||null),y.dir=Et(y.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ds,series:mt},S=(n.drawOrder||["axes","series"]).map(y=>x[y]);function k(y){let w=y.distr==3?L=>ms(L>0?L:y.clamp(i,L,y.min,y.max,y.key)):y.distr==4?L=>Mu(L,y.asinh):y.distr==100?L=>y.fwd(L):L=>L;return L=>{let N=w(L),{_min:W,_max:J}=y,ae=J-W;return(N-W)/ae}}function U(y){let w=M[y];if(w==null){let L=(n.scales||oa)[y]||oa;if(L.from!=null){U(L.from);let N=gn({},M[L.from],L,{key:y});N.valToPct=k(N),M[y]=N}else{w=M[y]=gn({},y==C?Um:mv,L),w.key=y;let N=w.time,W=w.range,J=Hs(W);if((y!=C||s==2&&!N)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Up:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Up:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&Cl(W))){let ae=W;W=(me,be,Ue)=>be==null?Kr:Sl(be,Ue,ae)}w.range=yt(W||(N?Cv:y==C?w.distr==3?Pv:w.distr==4?Iv:Xm:w.distr==3?qm:w.distr==4?$m:Rv)),w.auto=yt(J?!1:w.auto),w.clamp=yt(w.clamp||pv),w._min=w._max=null,w.valToPct=k(w)}}}U("x"),U("y"),s==1&&v.forEach(y=>{U(y.scale)}),A.forEach(y=>{U(y.scale)});for(let y in n.scales)U(y);let D=M[C],G=D.distr,X,I;D.ori==0?(hi(c,Vx),X=r,I=o):(hi(c,Hx),X=o,I=r);let V={};for(let y in M){let w=M[y];(w.min!=null||w.max!=null)&&(V[y]={min:w.min,max:w.max},w.min=w.max=null)}let H=n.tzDate||(y=>new Date(Mn(y/m))),B=n.fmtDate||Gu,le=m==1?Vy(H):Wy(H),Y=qp(H,Xp(m==1?zy:Gy,B)),j=Yp(H,$p(qy,B)),te=[],ue=i.legend=gn({},Zy,n.legend),fe=i.cursor=gn({},tv,{drag:{y:s==2}},n.cursor),ee=ue.show,pe=fe.show,_e=ue.markers;ue.idxs=te,_e.width=yt(_e.width),_e.dash=yt(_e.dash),_e.stroke=yt(_e.stroke),_e.fill=yt(_e.fill);let Re,we,Xe,rt=[],Ge=[],ft,ht=!1,it={};if(ue.live){let y=v[1]?v[1].values:null;ht=y!=null,ft=ht?y(i,1,0):{_:0};for(let w in ft)it[w]=Fu}if(ee)if(Re=Ui("table",jx,c),Xe=Ui("tbody",null,Re),ue.mount(i,Re),ht){we=Ui("thead",null,Re,Xe);let y=Ui("tr",null,we);Ui("th",null,y);for(var Zt in ft)Ui("th",Mp,y).textContent=Zt}else hi(Re,ey),ue.live&&hi(Re,Qx);let Vt={show:!0},hn={show:!1};function Ot(y,w){if(w==0&&(ht||!ue.live||s==2))return Kr;let L=[],N=Ui("tr",ty,Xe,Xe.childNodes[w]);hi(N,y.class),y.show||hi(N,fr);let W=Ui("th",null,N);if(_e.show){let me=Ti(ny,W);if(w>0){let be=_e.width(i,w);be&&(me.style.border=be+"px "+_e.dash(i,w)+" "+_e.stroke(i,w)),me.style.background=_e.fill(i,w)}}let J=Ti(Mp,W);y.label instanceof HTMLElement?J.appendChild(y.label):J.textContent=y.label,w>0&&(_e.show||(J.style.color=y.width>0?_e.stroke(i,w):_e.fill(i,w)),Mt("click",W,me=>{if(fe._lock)return;Je(me);let be=v.indexOf(y);if((me.ctrlKey||me.metaKey)!=ue.isolate){let Ue=v.some((Oe,Be)=>Be>0&&Be!=be&&Oe.show);v.forEach((Oe,Be)=>{Be>0&&Yi(Be,Ue?Be==be?Vt:hn:Vt,!0,mn.setSeries)})}else Yi(be,{show:!y.show},!0,mn.setSeries)},!1),je&&Mt(Tp,W,me=>{fe._lock||(Je(me),Yi(v.indexOf(y),zr,!0,mn.setSeries))},!1));for(var ae in ft){let me=Ui("td",iy,N);me.textContent="--",L.push(me)}return[N,L]}let An=new Map;function Mt(y,w,L,N=!0){let W=An.get(w)||{},J=fe.bind[y](i,w,L,N);J&&(pr(y,w,W[y]=J),An.set(w,W))}function vn(y,w,L){let N=An.get(w)||{};for(let W in N)(y==null||W==y)&&(Ru(W,w,N[W]),delete N[W]);y==null&&An.delete(w)}let tn=0,un=0,F=0,Ie=0,Ye=0,ot=0,Ee=Ye,Bt=ot,He=F,$e=Ie,P=0,b=0,q=0,de=0;i.bbox={};let oe=!1,ye=!1,ve=!1,ne=!1,se=!1,ge=!1;function O(y,w,L){(L||y!=i.width||w!=i.height)&&re(y,w),ut(!1),ve=!0,ye=!0,Un()}function re(y,w){i.width=tn=F=y,i.height=un=Ie=w,Ye=ot=0,Se(),We();let L=i.bbox;P=L.left=ur(Ye*Ct,.5),b=L.top=ur(ot*Ct,.5),q=L.width=ur(F*Ct,.5),de=L.height=ur(Ie*Ct,.5)}let ie=3;function Te(){let y=!1,w=0;for(;!y;){w++;let L=Nr(w),N=$i(w);y=w==ie||L&&N,y||(re(i.width,i.height),ye=!0)}}function xe({width:y,height:w}){O(y,w)}i.setSize=xe;function Se(){let y=!1,w=!1,L=!1,N=!1;A.forEach((W,J)=>{if(W.show&&W._show){let{side:ae,_size:me}=W,be=ae%2,Ue=W.label!=null?W.labelSize:0,Oe=me+Ue;Oe>0&&(be?(F-=Oe,ae==3?(Ye+=Oe,N=!0):L=!0):(Ie-=Oe,ae==0?(ot+=Oe,y=!0):w=!0))}}),Xi[0]=y,Xi[1]=L,Xi[2]=w,Xi[3]=N,F-=Ii[1]+Ii[3],Ye+=Ii[3],Ie-=Ii[2]+Ii[0],ot+=Ii[0]}function We(){let y=Ye+F,w=ot+Ie,L=Ye,N=ot;function W(J,ae){switch(J){case 1:return y+=ae,y-ae;case 2:return w+=ae,w-ae;case 3:return L-=ae,L+ae;case 0:return N-=ae,N+ae}}A.forEach((J,ae)=>{if(J.show&&J._show){let me=J.side;J._pos=W(me,J._size),J.label!=null&&(J._lpos=W(me,J.labelSize))}})}if(fe.dataIdx==null){let y=fe.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let L=y.prox=yt(y.prox),N=y.bias??=0;fe.dataIdx=(W,J,ae,me)=>{if(J==0)return ae;let be=ae,Ue=L(W,J,ae,me)??kt,Oe=Ue>=0&&Ue<kt,Be=D.ori==0?F:Ie,st=fe.left,Tt=e[0],wt=e[J];if(w.has(wt[ae])){be=null;let _t=null,Ke=null,qe;if(N==0||N==-1)for(qe=ae;_t==null&&qe-- >0;)w.has(wt[qe])||(_t=qe);if(N==0||N==1)for(qe=ae;Ke==null&&qe++<wt.length;)w.has(wt[qe])||(Ke=qe);if(_t!=null||Ke!=null)if(Oe){let Xt=_t==null?-1/0:X(Tt[_t],D,Be,0),rn=Ke==null?1/0:X(Tt[Ke],D,Be,0),In=st-Xt,Ft=rn-st;In<=Ft?In<=Ue&&(be=_t):Ft<=Ue&&(be=Ke)}else be=Ke==null?_t:_t==null?Ke:ae-_t<=Ke-ae?_t:Ke}else Oe&&Sn(st-X(Tt[ae],D,Be,0))>Ue&&(be=null);return be}}let Je=y=>{fe.event=y};fe.idxs=te,fe._lock=!1;let ce=fe.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ke=i.focus=gn({},n.focus||{alpha:.3},fe.focus),je=ke.prox>=0,Pe=je&&ce.one,lt=[],Ht=[],Gn=[];function Vo(y,w){let L=ce.show(i,w);if(L instanceof HTMLElement)return hi(L,Jx),hi(L,y.class),ts(L,-10,-10,F,Ie),g.insertBefore(L,lt[w]),L}function Ir(y,w){if(s==1||w>0){let L=s==1&&M[y.scale].time,N=y.value;y.value=L?Vp(N)?Yp(H,$p(N,B)):N||j:N||uv,y.label=y.label||(L?iv:nv)}if(Pe||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Ev||my,y.fillTo=yt(y.fillTo||gv),y.pxAlign=+Et(y.pxAlign,_),y.pxRound=im(y.pxAlign),y.stroke=yt(y.stroke||null),y.fill=yt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let L=dv(Yn(1,y.width),1),N=y.points=gn({},{size:L,width:Yn(1,L*.2),stroke:y.stroke,space:L*2,paths:Tv,_stroke:null,_fill:null},y.points);N.show=yt(N.show),N.filter=yt(N.filter),N.fill=yt(N.fill),N.stroke=yt(N.stroke),N.paths=yt(N.paths),N.pxAlign=y.pxAlign}if(ee){let L=Ot(y,w);rt.splice(w,0,L[0]),Ge.splice(w,0,L[1]),ue.values.push(null)}if(pe){te.splice(w,0,null);let L=null;Pe?w==0&&(L=Vo(y,w)):w>0&&(L=Vo(y,w)),lt.splice(w,0,L),Ht.splice(w,0,0),Gn.splice(w,0,0)}Pn("addSeries",w)}function Hh(y,w){w=w??v.length,y=s==1?Uu(y,w,Kp,tm):Uu(y,w,{},em),v.splice(w,0,y),Ir(v[w],w)}i.addSeries=Hh;function el(y){if(v.splice(y,1),ee){ue.values.splice(y,1),Ge.splice(y,1);let w=rt.splice(y,1)[0];vn(null,w.firstChild),w.remove()}pe&&(te.splice(y,1),lt.splice(y,1)[0].remove(),Ht.splice(y,1),Gn.splice(y,1)),Pn("delSeries",y)}i.delSeries=el;let Xi=[!1,!1,!1,!1];function cs(y,w){if(y._show=y.show,y.show){let L=y.side%2,N=M[y.scale];N==null&&(y.scale=L?v[1].scale:C,N=M[y.scale]);let W=N.time;y.size=yt(y.size),y.space=yt(y.space),y.rotate=yt(y.rotate),Hs(y.incrs)&&y.incrs.forEach(ae=>{!Gs.has(ae)&&Gs.set(ae,gm(ae))}),y.incrs=yt(y.incrs||(N.distr==2?Fy:W?m==1?ky:Hy:dr)),y.splits=yt(y.splits||(W&&N.distr==1?le:N.distr==3?Iu:N.distr==4?ov:rv)),y.stroke=yt(y.stroke),y.grid.stroke=yt(y.grid.stroke),y.ticks.stroke=yt(y.ticks.stroke),y.border.stroke=yt(y.border.stroke);let J=y.values;y.values=Hs(J)&&!Hs(J[0])?yt(J):W?Hs(J)?qp(H,Xp(J,B)):Vp(J)?Xy(H,J):J||Y:J||sv,y.filter=yt(y.filter||(N.distr>=3&&N.log==10?cv:N.distr==3&&N.log==2?hv:pm)),y.font=am(y.font),y.labelFont=am(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Xi[w]=!0,y._el=Ti($x,d))}}function hs(y,w,L,N){let[W,J,ae,me]=L,be=w%2,Ue=0;return be==0&&(me||J)&&(Ue=w==0&&!W||w==2&&!ae?Mn(Zp.size/3):0),be==1&&(W||ae)&&(Ue=w==1&&!J||w==3&&!me?Mn(jp.size/2):0),Ue}let Ho=i.padding=(n.padding||[hs,hs,hs,hs]).map(y=>yt(Et(y,hs))),Ii=i._padding=Ho.map((y,w)=>y(i,w,Xi,0)),nn,ln=null,cn=null,qi=s==1?v[0].idxs:null,oi=null,Ls=!1;function Go(y,w){if(e=y??[],i.data=i._data=e,s==2){nn=0;for(let L=1;L<v.length;L++)nn+=e[L][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],nn=oi.length;let L=e;if(G==2){L=e.slice();let N=L[0]=Array(nn);for(let W=0;W<nn;W++)N[W]=W}i._data=e=L}if(ut(!0),Pn("setData"),G==2&&(ve=!0),w!==!1){let L=D;L.auto(i,Ls)?Wo():Us(C,L.min,L.max),ne=ne||fe.left>=0,ge=!0,Un()}}i.setData=Go;function Wo(){Ls=!0;let y,w;s==1&&(nn>0?(ln=qi[0]=0,cn=qi[1]=nn-1,y=e[0][ln],w=e[0][cn],G==2?(y=ln,w=cn):y==w&&(G==3?[y,w]=Tl(y,y,D.log,!1):G==4?[y,w]=ku(y,y,D.log,!1):D.time?w=y+Mn(86400/m):[y,w]=Sl(y,w,zu,!0))):(ln=qi[0]=y=null,cn=qi[1]=w=null)),Us(C,y,w)}let Lr,Ds,Dr,E,z,Q,$,K,Ae,Le;function Ce(y,w,L,N,W,J){y??=wp,L??=Hu,N??="butt",W??=wp,J??="round",y!=Lr&&(u.strokeStyle=Lr=y),W!=Ds&&(u.fillStyle=Ds=W),w!=Dr&&(u.lineWidth=Dr=w),J!=z&&(u.lineJoin=z=J),N!=Q&&(u.lineCap=Q=N),L!=E&&u.setLineDash(E=L)}function De(y,w,L,N){w!=Ds&&(u.fillStyle=Ds=w),y!=$&&(u.font=$=y),L!=K&&(u.textAlign=K=L),N!=Ae&&(u.textBaseline=Ae=N)}function Ve(y,w,L,N,W=0){if(N.length>0&&y.auto(i,Ls)&&(w==null||w.min==null)){let J=Et(ln,0),ae=Et(cn,N.length-1),me=L.min==null?cy(N,J,ae,W,y.distr==3):[L.min,L.max];y.min=Fi(y.min,L.min=me[0]),y.max=Yn(y.max,L.max=me[1])}}let Qe={min:null,max:null};function pt(){for(let N in M){let W=M[N];V[N]==null&&(W.min==null||V[C]!=null&&W.auto(i,Ls))&&(V[N]=Qe)}for(let N in M){let W=M[N];V[N]==null&&W.from!=null&&V[W.from]!=null&&(V[N]=Qe)}V[C]!=null&&ut(!0);let y={};for(let N in V){let W=V[N];if(W!=null){let J=y[N]=Jr(M[N],xy);if(W.min!=null)gn(J,W);else if(N!=C||s==2)if(nn==0&&J.from==null){let ae=J.range(i,null,null,N);J.min=ae[0],J.max=ae[1]}else J.min=kt,J.max=-kt}}if(nn>0){v.forEach((N,W)=>{if(s==1){let J=N.scale,ae=V[J];if(ae==null)return;let me=y[J];if(W==0){let be=me.range(i,me.min,me.max,J);me.min=be[0],me.max=be[1],ln=Oi(me.min,e[0]),cn=Oi(me.max,e[0]),cn-ln>1&&(e[0][ln]<me.min&&ln++,e[0][cn]>me.max&&cn--),N.min=oi[ln],N.max=oi[cn]}else N.show&&N.auto&&Ve(me,ae,N,e[W],N.sorted);N.idxs[0]=ln,N.idxs[1]=cn}else if(W>0&&N.show&&N.auto){let[J,ae]=N.facets,me=J.scale,be=ae.scale,[Ue,Oe]=e[W],Be=y[me],st=y[be];Be!=null&&Ve(Be,V[me],J,Ue,J.sorted),st!=null&&Ve(st,V[be],ae,Oe,ae.sorted),N.min=ae.min,N.max=ae.max}});for(let N in y){let W=y[N],J=V[N];if(W.from==null&&(J==null||J.min==null)){let ae=W.range(i,W.min==kt?null:W.min,W.max==-kt?null:W.max,N);W.min=ae[0],W.max=ae[1]}}}for(let N in y){let W=y[N];if(W.from!=null){let J=y[W.from];if(J.min==null)W.min=W.max=null;else{let ae=W.range(i,J.min,J.max,N);W.min=ae[0],W.max=ae[1]}}}let w={},L=!1;for(let N in y){let W=y[N],J=M[N];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let ae=J.distr;J._min=ae==3?ms(J.min):ae==4?Mu(J.min,J.asinh):ae==100?J.fwd(J.min):J.min,J._max=ae==3?ms(J.max):ae==4?Mu(J.max,J.asinh):ae==100?J.fwd(J.max):J.max,w[N]=L=!0}}if(L){v.forEach((N,W)=>{s==2?W>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)ve=!0,Pn("setScale",N);pe&&fe.left>=0&&(ne=ge=!0)}for(let N in V)V[N]=null}function ze(y){let w=Pu(ln-1,0,nn-1),L=Pu(cn+1,0,nn-1);for(;y[w]==null&&w>0;)w--;for(;y[L]==null&&L<nn-1;)L++;return[w,L]}function mt(){if(nn>0){let y=v.some(w=>w._focus)&&Le!=ke.alpha;y&&(u.globalAlpha=Le=ke.alpha),v.forEach((w,L)=>{if(L>0&&w.show&&(jt(L,!1),jt(L,!0),w._paths==null)){let N=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha);let W=s==2?[0,e[L][0].length-1]:ze(e[L]);w._paths=w.paths(i,L,W[0],W[1]),Le!=N&&(u.globalAlpha=Le=N)}}),v.forEach((w,L)=>{if(L>0&&w.show){let N=Le;Le!=w.alpha&&(u.globalAlpha=Le=w.alpha),w._paths!=null&&Dt(L,!1);{let W=w._paths!=null?w._paths.gaps:null,J=w.points.show(i,L,ln,cn,W),ae=w.points.filter(i,L,J,W);(J||ae)&&(w.points._paths=w.points.paths(i,L,ln,cn,ae),Dt(L,!0))}Le!=N&&(u.globalAlpha=Le=N),Pn("drawSeries",L)}}),y&&(u.globalAlpha=Le=1)}}function jt(y,w){let L=w?v[y].points:v[y];L._stroke=L.stroke(i,y),L._fill=L.fill(i,y)}function Dt(y,w){let L=w?v[y].points:v[y],{stroke:N,fill:W,clip:J,flags:ae,_stroke:me=L._stroke,_fill:be=L._fill,_width:Ue=L.width}=L._paths;Ue=zt(Ue*Ct,3);let Oe=null,Be=Ue%2/2;w&&be==null&&(be=Ue>0?"#fff":me);let st=L.pxAlign==1&&Be>0;if(st&&u.translate(Be,Be),!w){let Tt=P-Ue/2,wt=b-Ue/2,_t=q+Ue,Ke=de+Ue;Oe=new Path2D,Oe.rect(Tt,wt,_t,Ke)}w?Fe(me,Ue,L.dash,L.cap,be,N,W,ae,J):Nt(y,me,Ue,L.dash,L.cap,be,N,W,ae,Oe,J),st&&u.translate(-Be,-Be)}function Nt(y,w,L,N,W,J,ae,me,be,Ue,Oe){let Be=!1;be!=0&&R.forEach((st,Tt)=>{if(st.series[0]==y){let wt=v[st.series[1]],_t=e[st.series[1]],Ke=(wt._paths||oa).band;Hs(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let qe,Xt=null;wt.show&&Ke&&uy(_t,ln,cn)?(Xt=st.fill(i,Tt)||J,qe=wt._paths.clip):Ke=null,Fe(w,L,N,W,Xt,ae,me,be,Ue,Oe,qe,Ke),Be=!0}}),Be||Fe(w,L,N,W,J,ae,me,be,Ue,Oe)}let bn=jr|Du;function Fe(y,w,L,N,W,J,ae,me,be,Ue,Oe,Be){Ce(y,w,L,N,W),(be||Ue||Be)&&(u.save(),be&&u.clip(be),Ue&&u.clip(Ue)),Be?(me&bn)==bn?(u.clip(Be),Oe&&u.clip(Oe),xt(W,ae),dn(y,J,w)):me&Du?(xt(W,ae),u.clip(Be),dn(y,J,w)):me&jr&&(u.save(),u.clip(Be),Oe&&u.clip(Oe),xt(W,ae),u.restore(),dn(y,J,w)):(xt(W,ae),dn(y,J,w)),(be||Ue||Be)&&u.restore()}function dn(y,w,L){L>0&&(w instanceof Map?w.forEach((N,W)=>{u.strokeStyle=Lr=W,u.stroke(N)}):w!=null&&y&&u.stroke(w))}function xt(y,w){w instanceof Map?w.forEach((L,N)=>{u.fillStyle=Ds=N,u.fill(L)}):w!=null&&y&&u.fill(w)}function us(y,w,L,N){let W=A[y],J;if(N<=0)J=[0,0];else{let ae=W._space=W.space(i,y,w,L,N),me=W._incrs=W.incrs(i,y,w,L,N,ae);J=Lv(w,L,me,N,ae)}return W._found=J}function fn(y,w,L,N,W,J,ae,me,be,Ue){let Oe=ae%2/2;_==1&&u.translate(Oe,Oe),Ce(me,ae,be,Ue,me),u.beginPath();let Be,st,Tt,wt,_t=W+(N==0||N==3?-J:J);L==0?(st=W,wt=_t):(Be=W,Tt=_t);for(let Ke=0;Ke<y.length;Ke++)w[Ke]!=null&&(L==0?Be=Tt=y[Ke]:st=wt=y[Ke],u.moveTo(Be,st),u.lineTo(Tt,wt));u.stroke(),_==1&&u.translate(-Oe,-Oe)}function Nr(y){let w=!0;return A.forEach((L,N)=>{if(!L.show)return;let W=M[L.scale];if(W.min==null){L._show&&(w=!1,L._show=!1,ut(!1));return}else L._show||(w=!1,L._show=!0,ut(!1));let J=L.side,ae=J%2,{min:me,max:be}=W,[Ue,Oe]=us(N,me,be,ae==0?F:Ie);if(Oe==0)return;let Be=W.distr==2,st=L._splits=L.splits(i,N,me,be,Ue,Oe,Be),Tt=W.distr==2?st.map(qe=>oi[qe]):st,wt=W.distr==2?oi[st[1]]-oi[st[0]]:Ue,_t=L._values=L.values(i,L.filter(i,Tt,N,Oe,wt),N,Oe,wt);L._rotate=J==2?L.rotate(i,_t,N,Oe):0;let Ke=L._size;L._size=Ai(L.size(i,_t,N,y)),Ke!=null&&L._size!=Ke&&(w=!1)}),w}function $i(y){let w=!0;return Ho.forEach((L,N)=>{let W=L(i,N,Xi,y);W!=Ii[N]&&(w=!1),Ii[N]=W}),w}function ds(){for(let y=0;y<A.length;y++){let w=A[y];if(!w.show||!w._show)continue;let L=w.side,N=L%2,W,J,ae=w.stroke(i,y),me=L==0||L==3?-1:1,[be,Ue]=w._found;if(w.label!=null){let qn=w.labelGap*me,ci=Mn((w._lpos+qn)*Ct);De(w.labelFont[0],ae,"center",L==2?"top":Sp),u.save(),N==1?(W=J=0,u.translate(ci,Mn(b+de/2)),u.rotate((L==3?-bl:bl)/2)):(W=Mn(P+q/2),J=ci);let ar=dm(w.label)?w.label(i,y,be,Ue):w.label;u.fillText(ar,W,J),u.restore()}if(Ue==0)continue;let Oe=M[w.scale],Be=N==0?q:de,st=N==0?P:b,Tt=w._splits,wt=Oe.distr==2?Tt.map(qn=>oi[qn]):Tt,_t=Oe.distr==2?oi[Tt[1]]-oi[Tt[0]]:be,Ke=w.ticks,qe=w.border,Xt=Ke.show?Ke.size:0,rn=Mn(Xt*Ct),In=Mn((w.alignTo==2?w._size-Xt-w.gap:w.gap)*Ct),Ft=w._rotate*-bl/180,on=p(w._pos*Ct),ai=(rn+In)*me,Xn=on+ai;J=N==0?Xn:0,W=N==1?Xn:0;let bi=w.font[0],Li=w.align==1?qr:w.align==2?yu:Ft>0?qr:Ft<0?yu:N==0?"center":L==3?yu:qr,Ki=Ft||N==1?"middle":L==2?"top":Sp;De(bi,ae,Li,Ki);let li=w.font[1]*w.lineGap,Mi=Tt.map(qn=>p(a(qn,Oe,Be,st))),Di=w._values;for(let qn=0;qn<Di.length;qn++){let ci=Di[qn];if(ci!=null){N==0?W=Mi[qn]:J=Mi[qn],ci=""+ci;let ar=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let $n=0;$n<ar.length;$n++){let tp=ar[$n];Ft?(u.save(),u.translate(W,J+$n*li),u.rotate(Ft),u.fillText(tp,0,0),u.restore()):u.fillText(tp,W,J+$n*li)}}}Ke.show&&fn(Mi,Ke.filter(i,wt,y,Ue,_t),N,L,on,rn,zt(Ke.width*Ct,3),Ke.stroke(i,y),Ke.dash,Ke.cap);let Ji=w.grid;Ji.show&&fn(Mi,Ji.filter(i,wt,y,Ue,_t),N,N==0?2:1,N==0?b:P,N==0?de:q,zt(Ji.width*Ct,3),Ji.stroke(i,y),Ji.dash,Ji.cap),qe.show&&fn([on],[1],N==0?1:0,N==0?1:2,N==1?b:P,N==1?de:q,zt(qe.width*Ct,3),qe.stroke(i,y),qe.dash,qe.cap)}Pn("drawAxes")}function ut(y){v.forEach((w,L)=>{L>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let sn=!1,Wn=!1,Ut=[];function pn(){Wn=!1;for(let y=0;y<Ut.length;y++)Pn(...Ut[y]);Ut.length=0}function Un(){sn||(Ey(Ff),sn=!0)}function tl(y,w=!1){sn=!0,Wn=w,y(i),Ff(),w&&Ut.length>0&&queueMicrotask(pn)}i.batch=tl;function Ff(){if(oe&&(pt(),oe=!1),ve&&(Te(),ve=!1),ye){if(qt(f,qr,Ye),qt(f,"top",ot),qt(f,na,F),qt(f,ia,Ie),qt(g,qr,Ye),qt(g,"top",ot),qt(g,na,F),qt(g,ia,Ie),qt(d,na,tn),qt(d,ia,un),h.width=Mn(tn*Ct),h.height=Mn(un*Ct),A.forEach(({_el:y,_show:w,_size:L,_pos:N,side:W})=>{if(y!=null)if(w){let J=W===3||W===0?L:0,ae=W%2==1;qt(y,ae?"left":"top",N-J),qt(y,ae?"width":"height",L),qt(y,ae?"top":"left",ae?ot:Ye),qt(y,ae?"height":"width",ae?Ie:F),Cu(y,fr)}else hi(y,fr)}),Lr=Ds=Dr=z=Q=$=K=Ae=E=null,Le=1,$o(!0),Ye!=Ee||ot!=Bt||F!=He||Ie!=$e){ut(!1);let y=F/He,w=Ie/$e;if(pe&&!ne&&fe.left>=0){fe.left*=y,fe.top*=w,Ur&&ts(Ur,Mn(fe.left),0,F,Ie),Or&&ts(Or,0,Mn(fe.top),F,Ie);for(let L=0;L<lt.length;L++){let N=lt[L];N!=null&&(Ht[L]*=y,Gn[L]*=w,ts(N,Ai(Ht[L]),Ai(Gn[L]),F,Ie))}}if(Wt.show&&!se&&Wt.left>=0&&Wt.width>0){Wt.left*=y,Wt.width*=y,Wt.top*=w,Wt.height*=w;for(let L in Yh)qt(kr,L,Wt[L])}Ee=Ye,Bt=ot,He=F,$e=Ie}Pn("setSize"),ye=!1}tn>0&&un>0&&(u.clearRect(0,0,h.width,h.height),Pn("drawClear"),S.forEach(y=>y()),Pn("draw")),Wt.show&&se&&(nl(Wt),se=!1),pe&&ne&&(or(null,!0,!1),ne=!1),ue.show&&ue.live&&ge&&(qh(),ge=!1),l||(l=!0,i.status=1,Pn("ready")),Ls=!1,sn=!1}i.redraw=(y,w)=>{ve=w||!1,y!==!1?Us(C,D.min,D.max):Un()};function Gh(y,w){let L=M[y];if(L.from==null){if(nn==0){let N=L.range(i,w.min,w.max,y);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(nn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==C&&L.distr==2&&nn>0&&(w.min=Oi(w.min,e[0]),w.max=Oi(w.max,e[0]),w.min==w.max&&w.max++),V[y]=w,oe=!0,Un()}}i.setScale=Gh;let Wh,Xh,Ur,Or,Bf,kf,Fr,Br,zf,Vf,Gt,Kt,Ns=!1,Nn=fe.drag,Cn=Nn.x,Rn=Nn.y;pe&&(fe.x&&(Wh=Ti(Zx,g)),fe.y&&(Xh=Ti(Kx,g)),D.ori==0?(Ur=Wh,Or=Xh):(Ur=Xh,Or=Wh),Gt=fe.left,Kt=fe.top);let Wt=i.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),kr=Wt.show?Ti(Yx,Wt.over?g:f):null;function nl(y,w){if(Wt.show){for(let L in y)Wt[L]=y[L],L in Yh&&qt(kr,L,y[L]);w!==!1&&Pn("setSelect")}}i.setSelect=nl;function z_(y){if(v[y].show)ee&&Cu(rt[y],fr);else if(ee&&hi(rt[y],fr),pe){let L=Pe?lt[0]:lt[y];L!=null&&ts(L,-10,-10,F,Ie)}}function Us(y,w,L){Gh(y,{min:w,max:L})}function Yi(y,w,L,N){w.focus!=null&&X_(y),w.show!=null&&v.forEach((W,J)=>{J>0&&(y==J||y==null)&&(W.show=w.show,z_(J),s==2?(Us(W.facets[0].scale,null,null),Us(W.facets[1].scale,null,null)):Us(W.scale,null,null),Un())}),L!==!1&&Pn("setSeries",y,w),N&&Yo("setSeries",i,y,w)}i.setSeries=Yi;function V_(y,w){gn(R[y],w)}function H_(y,w){y.fill=yt(y.fill||null),y.dir=Et(y.dir,-1),w=w??R.length,R.splice(w,0,y)}function G_(y){y==null?R.length=0:R.splice(y,1)}i.addBand=H_,i.setBand=V_,i.delBand=G_;function W_(y,w){v[y].alpha=w,pe&&lt[y]!=null&&(lt[y].style.opacity=w),ee&&rt[y]&&(rt[y].style.opacity=w)}let fs,Os,rr,zr={focus:!0};function X_(y){if(y!=rr){let w=y==null,L=ke.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let J=w||W==0||W==y;N._focus=w?null:J,L&&W_(W,J?1:ke.alpha)}}),rr=y,L&&Un()}}ee&&je&&Mt(Ap,Re,y=>{fe._lock||(Je(y),rr!=null&&Yi(null,zr,!0,mn.setSeries))});function Zi(y,w,L){let N=M[w];L&&(y=y/Ct-(N.ori==1?ot:Ye));let W=F;N.ori==1&&(W=Ie,y=W-y),N.dir==-1&&(y=W-y);let J=N._min,ae=N._max,me=y/W,be=J+(ae-J)*me,Ue=N.distr;return Ue==3?Zr(10,be):Ue==4?fy(be,N.asinh):Ue==100?N.bwd(be):be}function q_(y,w){let L=Zi(y,C,w);return Oi(L,e[0],ln,cn)}i.valToIdx=y=>Oi(y,e[0]),i.posToIdx=q_,i.posToVal=Zi,i.valToPos=(y,w,L)=>M[w].ori==0?r(y,M[w],L?q:F,L?P:0):o(y,M[w],L?de:Ie,L?b:0),i.setCursor=(y,w,L)=>{Gt=y.left,Kt=y.top,or(null,w,L)};function Hf(y,w){qt(kr,qr,Wt.left=y),qt(kr,na,Wt.width=w)}function Gf(y,w){qt(kr,"top",Wt.top=y),qt(kr,ia,Wt.height=w)}let Xo=D.ori==0?Hf:Gf,qo=D.ori==1?Hf:Gf;function $_(){if(ee&&ue.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&ht)continue;let w=ue.values[y],L=0;for(let N in w)Ge[y][L++].firstChild.nodeValue=w[N]}}function qh(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((L,N)=>{te[N]=L}):_y(y.idx)||te.fill(y.idx),ue.idx=te[0]),ee&&ue.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!ht)&&Y_(L,te[L]);$_()}ge=!1,w!==!1&&Pn("setLegend")}i.setLegend=qh;function Y_(y,w){let L=v[y],N=y==0&&G==2?oi:e[y],W;ht?W=L.values(i,y,w)??it:(W=L.value(i,w==null?null:N[w],y,w),W=W==null?it:{_:W}),ue.values[y]=W}function or(y,w,L){zf=Gt,Vf=Kt,[Gt,Kt]=fe.move(i,Gt,Kt),fe.left=Gt,fe.top=Kt,pe&&(Ur&&ts(Ur,Mn(Gt),0,F,Ie),Or&&ts(Or,0,Mn(Kt),F,Ie));let N,W=ln>cn;fs=kt,Os=null;let J=D.ori==0?F:Ie,ae=D.ori==1?F:Ie;if(Gt<0||nn==0||W){N=fe.idx=null;for(let me=0;me<v.length;me++){let be=lt[me];be!=null&&ts(be,-10,-10,F,Ie)}je&&Yi(null,zr,!0,y==null&&mn.setSeries),ue.live&&(te.fill(N),ge=!0)}else{let me,be,Ue;s==1&&(me=D.ori==0?Gt:Kt,be=Zi(me,C),N=fe.idx=Oi(be,e[0],ln,cn),Ue=X(e[0][N],D,J,0));let Oe=-10,Be=-10,st=0,Tt=0,wt=!0,_t="",Ke="";for(let qe=s==2?1:0;qe<v.length;qe++){let Xt=v[qe],rn=te[qe],In=rn==null?null:s==1?e[qe][rn]:e[qe][1][rn],Ft=fe.dataIdx(i,qe,N,be),on=Ft==null?null:s==1?e[qe][Ft]:e[qe][1][Ft];if(ge=ge||on!=In||Ft!=rn,te[qe]=Ft,qe>0&&Xt.show){let ai=Ft==null?-10:Ft==N?Ue:X(s==1?e[0][Ft]:e[qe][0][Ft],D,J,0),Xn=on==null?-10:I(on,s==1?M[Xt.scale]:M[Xt.facets[1].scale],ae,0);if(je&&on!=null){let bi=D.ori==1?Gt:Kt,Li=Sn(ke.dist(i,qe,Ft,Xn,bi));if(Li<fs){let Ki=ke.bias;if(Ki!=0){let li=Zi(bi,Xt.scale),Mi=on>=0?1:-1,Di=li>=0?1:-1;Di==Mi&&(Di==1?Ki==1?on>=li:on<=li:Ki==1?on<=li:on>=li)&&(fs=Li,Os=qe)}else fs=Li,Os=qe}}if(ge||Pe){let bi,Li;D.ori==0?(bi=ai,Li=Xn):(bi=Xn,Li=ai);let Ki,li,Mi,Di,Ji,qn,ci=!0,ar=ce.bbox;if(ar!=null){ci=!1;let $n=ar(i,qe);Mi=$n.left,Di=$n.top,Ki=$n.width,li=$n.height}else Mi=bi,Di=Li,Ki=li=ce.size(i,qe);if(qn=ce.fill(i,qe),Ji=ce.stroke(i,qe),Pe)qe==Os&&fs<=ke.prox&&(Oe=Mi,Be=Di,st=Ki,Tt=li,wt=ci,_t=qn,Ke=Ji);else{let $n=lt[qe];$n!=null&&(Ht[qe]=Mi,Gn[qe]=Di,Np($n,Ki,li,ci),Lp($n,qn,Ji),ts($n,Ai(Mi),Ai(Di),F,Ie))}}}}if(Pe){let qe=ke.prox,Xt=rr==null?fs<=qe:fs>qe||Os!=rr;if(ge||Xt){let rn=lt[0];rn!=null&&(Ht[0]=Oe,Gn[0]=Be,Np(rn,st,Tt,wt),Lp(rn,_t,Ke),ts(rn,Ai(Oe),Ai(Be),F,Ie))}}}if(Wt.show&&Ns)if(y!=null){let[me,be]=mn.scales,[Ue,Oe]=mn.match,[Be,st]=y.cursor.sync.scales,Tt=y.cursor.drag;if(Cn=Tt._x,Rn=Tt._y,Cn||Rn){let{left:wt,top:_t,width:Ke,height:qe}=y.select,Xt=y.scales[Be].ori,rn=y.posToVal,In,Ft,on,ai,Xn,bi=me!=null&&Ue(me,Be),Li=be!=null&&Oe(be,st);bi&&Cn?(Xt==0?(In=wt,Ft=Ke):(In=_t,Ft=qe),on=M[me],ai=X(rn(In,Be),on,J,0),Xn=X(rn(In+Ft,Be),on,J,0),Xo(Fi(ai,Xn),Sn(Xn-ai))):Xo(0,J),Li&&Rn?(Xt==1?(In=wt,Ft=Ke):(In=_t,Ft=qe),on=M[be],ai=I(rn(In,st),on,ae,0),Xn=I(rn(In+Ft,st),on,ae,0),qo(Fi(ai,Xn),Sn(Xn-ai))):qo(0,ae)}else Zh()}else{let me=Sn(zf-Bf),be=Sn(Vf-kf);if(D.ori==1){let st=me;me=be,be=st}Cn=Nn.x&&me>=Nn.dist,Rn=Nn.y&&be>=Nn.dist;let Ue=Nn.uni;Ue!=null?Cn&&Rn&&(Cn=me>=Ue,Rn=be>=Ue,!Cn&&!Rn&&(be>me?Rn=!0:Cn=!0)):Nn.x&&Nn.y&&(Cn||Rn)&&(Cn=Rn=!0);let Oe,Be;Cn&&(D.ori==0?(Oe=Fr,Be=Gt):(Oe=Br,Be=Kt),Xo(Fi(Oe,Be),Sn(Be-Oe)),Rn||qo(0,ae)),Rn&&(D.ori==1?(Oe=Fr,Be=Gt):(Oe=Br,Be=Kt),qo(Fi(Oe,Be),Sn(Be-Oe)),Cn||Xo(0,J)),!Cn&&!Rn&&(Xo(0,0),qo(0,0))}if(Nn._x=Cn,Nn._y=Rn,y==null){if(L){if(ep!=null){let[me,be]=mn.scales;mn.values[0]=me!=null?Zi(D.ori==0?Gt:Kt,me):null,mn.values[1]=be!=null?Zi(D.ori==1?Gt:Kt,be):null}Yo(vu,i,Gt,Kt,F,Ie,N)}if(je){let me=L&&mn.setSeries,be=ke.prox;rr==null?fs<=be&&Yi(Os,zr,!0,me):fs>be?Yi(null,zr,!0,me):Os!=rr&&Yi(Os,zr,!0,me)}}ge&&(ue.idx=N,qh()),w!==!1&&Pn("setCursor")}let Fs=null;Object.defineProperty(i,"rect",{get(){return Fs==null&&$o(!1),Fs}});function $o(y=!1){y?Fs=null:(Fs=g.getBoundingClientRect(),Pn("syncRect",Fs))}function Wf(y,w,L,N,W,J,ae){fe._lock||Ns&&y!=null&&y.movementX==0&&y.movementY==0||($h(y,w,L,N,W,J,ae,!1,y!=null),y!=null?or(null,!0,!0):or(w,!0,!1))}function $h(y,w,L,N,W,J,ae,me,be){if(Fs==null&&$o(!1),Je(y),y!=null)L=y.clientX-Fs.left,N=y.clientY-Fs.top;else{if(L<0||N<0){Gt=-10,Kt=-10;return}let[Ue,Oe]=mn.scales,Be=w.cursor.sync,[st,Tt]=Be.values,[wt,_t]=Be.scales,[Ke,qe]=mn.match,Xt=w.axes[0].side%2==1,rn=D.ori==0?F:Ie,In=D.ori==1?F:Ie,Ft=Xt?J:W,on=Xt?W:J,ai=Xt?N:L,Xn=Xt?L:N;if(wt!=null?L=Ke(Ue,wt)?a(st,M[Ue],rn,0):-10:L=rn*(ai/Ft),_t!=null?N=qe(Oe,_t)?a(Tt,M[Oe],In,0):-10:N=In*(Xn/on),D.ori==1){let bi=L;L=N,N=bi}}be&&(w==null||w.cursor.event.type==vu)&&((L<=1||L>=F-1)&&(L=ur(L,F)),(N<=1||N>=Ie-1)&&(N=ur(N,Ie))),me?(Bf=L,kf=N,[Fr,Br]=fe.move(i,L,N)):(Gt=L,Kt=N)}let Yh={width:0,height:0,left:0,top:0};function Zh(){nl(Yh,!1)}let Xf,qf,$f,Yf;function Zf(y,w,L,N,W,J,ae){Ns=!0,Cn=Rn=Nn._x=Nn._y=!1,$h(y,w,L,N,W,J,ae,!0,!1),y!=null&&(Mt(bu,Tu,Kf,!1),Yo(Ep,i,Fr,Br,F,Ie,null));let{left:me,top:be,width:Ue,height:Oe}=Wt;Xf=me,qf=be,$f=Ue,Yf=Oe}function Kf(y,w,L,N,W,J,ae){Ns=Nn._x=Nn._y=!1,$h(y,w,L,N,W,J,ae,!1,!0);let{left:me,top:be,width:Ue,height:Oe}=Wt,Be=Ue>0||Oe>0,st=Xf!=me||qf!=be||$f!=Ue||Yf!=Oe;if(Be&&st&&nl(Wt),Nn.setScale&&Be&&st){let Tt=me,wt=Ue,_t=be,Ke=Oe;if(D.ori==1&&(Tt=be,wt=Oe,_t=me,Ke=Ue),Cn&&Us(C,Zi(Tt,C),Zi(Tt+wt,C)),Rn)for(let qe in M){let Xt=M[qe];qe!=C&&Xt.from==null&&Xt.min!=kt&&Us(qe,Zi(_t+Ke,qe),Zi(_t,qe))}Zh()}else fe.lock&&(fe._lock=!fe._lock,or(w,!0,y!=null));y!=null&&(vn(bu,Tu),Yo(bu,i,Gt,Kt,F,Ie,null))}function Z_(y,w,L,N,W,J,ae){if(fe._lock)return;Je(y);let me=Ns;if(Ns){let be=!0,Ue=!0,Oe=10,Be,st;D.ori==0?(Be=Cn,st=Rn):(Be=Rn,st=Cn),Be&&st&&(be=Gt<=Oe||Gt>=F-Oe,Ue=Kt<=Oe||Kt>=Ie-Oe),Be&&be&&(Gt=Gt<Fr?0:F),st&&Ue&&(Kt=Kt<Br?0:Ie),or(null,!0,!0),Ns=!1}Gt=-10,Kt=-10,te.fill(null),or(null,!0,!0),me&&(Ns=me)}function Jf(y,w,L,N,W,J,ae){fe._lock||(Je(y),Wo(),Zh(),y!=null&&Yo(Cp,i,Gt,Kt,F,Ie,null))}function jf(){A.forEach(Dv),O(i.width,i.height,!0)}pr(Ml,Yr,jf);let Vr={};Vr.mousedown=Zf,Vr.mousemove=Wf,Vr.mouseup=Kf,Vr.dblclick=Jf,Vr.setSeries=(y,w,L,N)=>{let W=mn.match[2];L=W(i,w,L),L!=-1&&Yi(L,N,!0,!1)},pe&&(Mt(Ep,g,Zf),Mt(vu,g,Wf),Mt(Tp,g,y=>{Je(y),$o(!1)}),Mt(Ap,g,Z_),Mt(Cp,g,Jf),Nu.add(i),i.syncRect=$o);let il=i.hooks=n.hooks||{};function Pn(y,w,L){Wn?Ut.push([y,w,L]):y in il&&il[y].forEach(N=>{N.call(null,i,w,L)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)il[w]=(il[w]||[]).concat(y.hooks[w])});let Qf=(y,w,L)=>L,mn=gn({key:null,setSeries:!1,filters:{pub:kp,sub:kp},scales:[C,v[1]?v[1].scale:null],match:[zp,zp,Qf],values:[null,null]},fe.sync);mn.match.length==2&&mn.match.push(Qf),fe.sync=mn;let ep=mn.key,Kh=Om(ep);function Yo(y,w,L,N,W,J,ae){mn.filters.pub(y,w,L,N,W,J,ae)&&Kh.pub(y,w,L,N,W,J,ae)}Kh.sub(i);function K_(y,w,L,N,W,J,ae){mn.filters.sub(y,w,L,N,W,J,ae)&&Vr[y](null,w,L,N,W,J,ae)}i.pub=K_;function J_(){Kh.unsub(i),Nu.delete(i),An.clear(),Ru(Ml,Yr,jf),c.remove(),Re?.remove(),Pn("destroy")}i.destroy=J_;function Jh(){Pn("init",n,e),Go(e||n.data,!1),V[C]?Gh(C,V[C]):Wo(),se=Wt.show&&(Wt.width>0||Wt.height>0),ne=ge=!0,O(n.width,n.height)}return v.forEach(Ir),A.forEach(cs),t?t instanceof HTMLElement?(t.appendChild(c),Jh()):t(i,Jh):Jh(),i}_n.assign=gn;_n.fmtNum=Vu;_n.rangeNum=Sl;_n.rangeLog=Tl;_n.rangeAsinh=ku;_n.orient=gr;_n.pxRatio=Ct;_n.join=wy;_n.fmtDate=Gu,_n.tzDate=Uy;_n.sync=Om;{_n.addGap=_v,_n.clipGaps=Rl;let n=_n.paths={points:Hm};n.linear=Wm,n.stepped=vv,n.bars=bv,n.spline=Sv}function St(n){let{heads:e,rows:t,caption:i,strong:s,text:r=[]}=n,o=h=>[h===0||r.includes(h)?"text":"number",h===s?"strong":""].join(" ").trim(),a=e.map((h,u)=>T("th",{scope:"col",class:o(u)},h)),l=t.map(h=>T("tr",{},...h.map((u,d)=>d===0?T("th",{scope:"row"},u):T("td",{class:o(d)},u)))),c=i?T("caption.unseen",{},i):null;return T("div.scroll",{},T("table.data",{},c,T("thead",{},T("tr",{},...a)),T("tbody",{},...l)))}function en(n){let e=new Ju(n);return e.isEmpty?null:e.element}function Ym(n){let e=[];return n.x.forEach((t,i)=>{let s=n.y[i];Me(t)&&Me(s)&&e.push([t,s])}),e.sort((t,i)=>t[0]-i[0])}var Ku='12px system-ui, "Segoe UI", Roboto, Arial, sans-serif',Nv={line:[],steps:[],dots:[],dashed:[6,4],dotted:[2,3]},Ju=class{constructor(e){this.options=e;this.series=e.series,this.lines=e.series.map(Ym);let t=this.lines.flat().map(([,r])=>r),i=t.filter(r=>r>0);this.isEmpty=t.length===0,this.isLog=e.y.log===!0&&i.length>0&&t.every(r=>r>=0);let s=this.isLog&&i.length<t.length;this.floor=s?10**(Math.floor(Math.log10(Math.min(...i)))-1):null,this.box.append(this.tip),this.box.setAttribute("aria-label",this.summary()),this.box.addEventListener("keydown",r=>this.onKey(r)),this.box.addEventListener("blur",()=>this.plot?.setCursor({left:-10,top:-10})),this.element=T("div.chart",{},this.legend(),this.box,this.spoken,this.asTable()),zv(this.box,r=>this.resize(r)),Vv(this.box,()=>this.plot?.redraw(!1,!0))}options;element;isEmpty;box=T("div.chart-box",{tabindex:"0",role:"img"});tip=T("div.chart-tip",{hidden:!0});spoken=T("div.unseen",{"aria-live":"polite"});series;lines;isLog;floor;plot=null;data(){let e=this.lines.map(t=>[t.map(([i])=>i),t.map(([,i])=>this.floor!==null&&i<=0?this.floor:i)]);return _n.join(e)}resize(e){let t=this.options.height??250;this.plot===null?this.begin(e):this.plot.setSize({width:e,height:t})}begin(e){let{x:t,y:i,height:s=250}=this.options,r=o=>(a,l,c)=>this.range(o,l,c);this.plot=new _n({width:e,height:s,legend:{show:!1},padding:[10,14,0,0],cursor:{y:!1,drag:{x:!1,y:!1},points:{size:8,fill:(o,a)=>_s(this.series[a-1]?.color??"--ink")}},scales:{x:{time:!1,range:r(t)},y:{distr:this.isLog?3:1,range:r(i)}},axes:[this.axis(t,!1),this.axis(i,!0)],series:[{},...this.series.map(o=>Ov(o))],hooks:{drawAxes:[o=>this.drawMarks(o)],setCursor:[o=>this.showTip(o)]}},this.data(),this.box)}range(e,t,i){if(t===null||i===null)return[e.from??0,e.to??1];if(e===this.options.y&&this.isLog)return[Zm(t,Math.floor),Zm(i,Math.ceil)];if(e===this.options.x)return Fv(e.from??t,e.to??i);let[s,r]=_n.rangeNum(t,i,.08,!0);return[e.from??s,e.to??r]}axis(e,t){return{label:e.unit?`${e.label}, ${e.unit}`:e.label,labelSize:20,labelGap:t?2:0,labelFont:Ku,font:Ku,stroke:()=>_s("--quiet"),grid:{stroke:()=>_s("--line"),width:1},ticks:{stroke:()=>_s("--line"),width:1,size:5},space:t?32:64,values:(i,s)=>s.map(r=>this.tick(r,t)),size:t?Bv:34}}tick(e,t){return e===null?"":t&&e===this.floor?"0":he(e,6)}drawMarks(e){let{left:t,top:i,width:s,height:r}=e.bbox,o=a=>Math.min(Math.max(e.valToPos(a,"x",!0),t),t+s);e.ctx.save();for(let a of this.options.marks??[]){let[l,c]=[o(a.from),o(a.to??a.from)];e.ctx.fillStyle=e.ctx.strokeStyle=_s(a.color),a.to!==void 0?(e.ctx.globalAlpha=.16,e.ctx.fillRect(l,i,Math.max(c-l,1),r)):(e.ctx.globalAlpha=1,e.ctx.lineWidth=1.5*devicePixelRatio,e.ctx.setLineDash([5,4].map(h=>h*devicePixelRatio)),e.ctx.beginPath(),e.ctx.moveTo(l,i),e.ctx.lineTo(l,i+r),e.ctx.stroke())}e.ctx.restore()}showTip(e){let{idx:t,left:i}=e.cursor;if(t==null||i===void 0||i<0){this.tip.hidden=!0;return}let s=e.data[0][t]??0,r=this.lines.flatMap((f,g)=>{let _=this.series[g],p=_&&e.series[g+1]?.show?Uv(f,s,_.style??"line"):null;return _&&p!==null?[{series:_,y:p}]:[]}),{unit:o,label:a}=this.options.x,l=`${a} ${he(s,5)}${o?` ${o}`:""}`,c=f=>`${he(f,5)}${this.options.y.unit?` ${this.options.y.unit}`:""}`,h=f=>T("div",{},la(f.series.color),T("span",{},f.series.name),T("b",{},c(f.y)));this.tip.replaceChildren(T("div",{class:"chart-tip-head"},l),...r.map(h)),this.tip.hidden=r.length===0;let u=i>e.over.clientWidth/2,d=e.over.offsetLeft;this.tip.style.left=u?"":`${d+i+14}px`,this.tip.style.right=u?`${this.box.clientWidth-d-i+14}px`:"",document.activeElement===this.box&&(this.spoken.textContent=[l,...r.map(f=>`${f.series.name} ${c(f.y)}`)].join(", "))}onKey(e){let t=this.plot;if(t===null)return;let i=t.data[0].length-1,s=t.cursor.idx??-1,o={ArrowLeft:s-1,ArrowRight:s+1,Home:0,End:i}[e.key];if(o===void 0||e.ctrlKey||e.metaKey||e.altKey)return;e.preventDefault();let a=t.data[0][Math.min(Math.max(o,0),i)];a!==void 0&&t.setCursor({left:t.valToPos(a,"x"),top:t.over.clientHeight/2})}legend(){let e=this.series.map((s,r)=>({series:s,i:r})).filter(({series:s})=>!s.quiet&&Ym(s).length>0),t=(this.options.marks??[]).map(s=>T("span",{},la(s.color,s.to===void 0?"dashed":"band"),s.name));if(e.length<2&&t.length===0)return T("div",{class:"chart-legend",hidden:!0});let i=({series:s,i:r})=>{let o=T("button",{type:"button","aria-pressed":"true",title:"Hide or show"},la(s.color,s.style),s.name);return o.addEventListener("click",()=>{let a=o.getAttribute("aria-pressed")!=="true";o.setAttribute("aria-pressed",String(a)),this.series.forEach((l,c)=>{(c===r||l.quiet&&l.name===s.name)&&this.plot?.setSeries(c+1,{show:a})})}),o};return T("div",{class:"chart-legend"},...e.map(i),...t)}asTable(){let e=T("details",{class:"chart-table"},T("summary",{},"Show as table"));return e.addEventListener("toggle",()=>{if(e.querySelector(".scroll")?.remove(),!e.open)return;let{x:t,y:i,title:s}=this.options,[r,...o]=this.columns(),a=i.unit?`, ${i.unit}`:"",l=[t.unit?`${t.label}, ${t.unit}`:t.label,...this.series.map(h=>h.name+a)],c=(r??[]).map((h,u)=>[he(h,6),...o.map(d=>he(d[u],6))]);e.append(St({heads:l,rows:c,caption:s}))}),e}columns(){let e=[...new Set(this.lines.flat().map(([i])=>i))].sort((i,s)=>i-s),t=i=>{let s=new Map(i);return e.map(r=>s.get(r))};return[e,...this.lines.map(t)]}summary(){let{title:e,x:t,y:i}=this.options,s=(l,c)=>{let[h,u]=[he(Math.min(...c),3),he(Math.max(...c),3)];return`from ${h} to ${u}${l.unit?` ${l.unit}`:""}`},r=this.lines.map((l,c)=>({line:l,name:this.series[c]?.name??""})).filter(({line:l})=>l.length>0),o=r.flatMap(({line:l})=>l.map(([c])=>c)),a=r.map(({line:l,name:c})=>`${c===e?"":`${c} `}${s(i,l.map(([,h])=>h))}`);return`${e}: ${a.join("; ")}; over ${t.label} ${s(t,o)}. Arrow keys read values.`}};function Uv(n,e,t){let i=n.findIndex(([l])=>l>=e);if(i<0)return null;let[s,r]=n[i];if(s===e)return r;if(i===0||t==="dots")return null;let[o,a]=n[i-1];return t==="steps"?a:a+(e-o)/(s-o)*(r-a)}function Ov(n){let e=n.style??"line",t=e==="dots",i=_n.paths.stepped?.({align:1});return{label:n.name,stroke:()=>_s(n.color),width:2,dash:Nv[e],points:{fill:()=>_s("--sheet")},...n.fill?{fill:()=>kv(_s(n.color))}:{},...t?{paths:()=>null,points:{show:!0,size:10,width:2,fill:()=>_s(n.color)}}:{},...e==="steps"&&i?{paths:i,points:{show:!1}}:{}}}function Fv(n,e){return n<e?[n,e]:[n-.5,e+.5]}function Zm(n,e){let t=10**Math.floor(Math.log10(n));return e(n/t)*t}function Bv(n,e){n.ctx.save(),n.ctx.font=Ku;let t=(e??[]).map(i=>n.ctx.measureText(i??"").width);return n.ctx.restore(),Math.ceil(Math.max(16,...t))+14}function _s(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()||"#5a6775"}function kv(n){return`color-mix(in srgb, ${n} 22%, transparent)`}function la(n,e="line"){return T("i",{class:`swatch swatch-${e}`,style:`--swatch: var(${n})`,"aria-hidden":"true"})}function zv(n,e){let t=0;new ResizeObserver(()=>{let s=n.clientWidth;s===t||s===0||(t=s,e(s))}).observe(n)}function Vv(n,e){let t=matchMedia("(prefers-color-scheme: dark)"),i=()=>{n.isConnected?e():t.removeEventListener("change",i)};t.addEventListener("change",i)}function Dl(n,e,t,i){let s=t,r=()=>{},o=l=>{s=l,r(),i(l)},a=e.map(l=>[l,l]);return T("div.chosen",{},T("span.quiet",{},n),wi(n,a,()=>s,o,l=>r=l))}var Km=new WeakMap;function at(n){if(!Ci(n.report))return{};let e=Km.get(n.report);return e||(e=ju(n.report),Km.set(n.report,e)),e}function ju(n){return Array.isArray(n)?n.map(ju):Ci(n)?Object.fromEntries(Object.entries(n).flatMap(([e,t])=>t===null?[]:[[e,ju(t)]])):n??void 0}function Ci(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function Rt(n){return Array.isArray(n)?n:[]}function no(n){return typeof n?.band_half_width=="number"}function Fn(n,e=""){return n.filter(Jm).map(t=>T("p",{class:e||null},Bs(jm(t))))}function ca(n){let e=n.filter(Jm);return e.length===0?null:T("ul",{},...e.map(t=>T("li",{},Bs(jm(t)))))}function Jm(n){return typeof n=="string"&&n!==""}function jm(n){let e=/^[a-z]+[ ,]/.test(n)?n.charAt(0).toUpperCase()+n.slice(1):n;return/[.!?:]$/.test(e)?e:`${e}.`}function vt(n,...e){return T("div.part",{},T("h3",{},n),...e)}function io(n,e){let t=T("button.copy",{type:"button"},n);return t.addEventListener("click",()=>{let i=r=>{t.textContent=r,window.setTimeout(()=>t.textContent=n,1600)};(navigator.clipboard?.writeText(e())??Promise.reject(new Error("no clipboard"))).then(()=>i("Copied"),()=>i("The browser refused to copy"))}),t}function so(n){let e=t=>/[",\n]/.test(t)?`"${t.replaceAll('"','""')}"`:t;return n.map(t=>e(t==null?"":String(t))).join(",")}var Hv=["model calls","seconds","iterations"],Qu="model calls";function ed(n){let e=T("div.charts"),t=i=>{Qu=i,e.replaceChildren(...n(i).filter(s=>s!==null))};return t(Qu),T("div",{},Dl("Over",Hv,Qu,t),e)}function td(n,e){let t=s=>n.history?.[s]??[];if(e==="seconds")return t("seconds");if(e==="iterations")return t("iteration");let i=t("adjoint_calls");return t("forward_calls").map((s,r)=>Me(s)?s+(i[r]??0):null)}function nd(n){return n==="seconds"?{label:"time",unit:"s",from:0}:{label:n==="iterations"?"iteration":"model calls (dose and adjoint)",from:0}}function Qm({run:n}){let e=qv(n),t=Fn([Wv(at(n)),n.texts?.gap,Xv(at(n).levels)]),i=Kv(at(n).process_window);if(e.length===0&&t.length===0&&!i)return null;let s=e.length>0&&ed(r=>e.map(o=>$v(n,o,r)));return T("div",{},...t,s,Yv(n),Zv(n),i)}var Gv={loss:"the lowest loss",print:"the best IoU on the job's voxels",last:"the last step"};function Wv({history:n}){let e=n?.kept;if(!e||!Me(e.iteration))return null;let t=Gv[e.by??""];return`The patterns are those after iteration ${e.iteration}${Me(n.iterations)?` of ${n.iterations}`:""}${t?`: ${t}`:""}.`}function Xv(n){if(!n)return null;let e=i=>he(i,4),t=Me(n.diffused_loss)?` (${e(n.diffused_loss)} by error diffusion)`:"";return`On the levels of the machine the patterns have a loss of ${e(n.loss)}, plainly rounded ${e(n.rounded_loss)}${t}: ${e(n.steps)} steps and ${e(n.calls)} model calls, with a full scale of ${e(n.scale)} times the brightest pixel before.`}function qv(n){let e=s=>n.history?.[s]??[],t=Object.keys(n.history??{}).filter(s=>s.startsWith("response."));return[{title:"Loss",y:{label:"loss",log:!0},of:e("loss")},{title:"Voxels that would print wrongly",y:{label:"1 − IoU",log:!0},of:e("iou").map(s=>Me(s)?1-s:null)},{title:"Process window",y:{label:"response"},of:e("process_window")},{title:"Projected gradient",y:{label:"relative to the first",log:!0},of:e("projected_gradient")},...t.map(s=>({title:`Response: ${s.slice(9)}`,y:{label:"found so far"},of:e(s)}))].filter(s=>s.of.filter(Me).length>1)}function $v(n,e,t){let i=e.of.filter(Me);if(i.every(o=>o===0))return vt(e.title,T("p.note",{},`It is 0 at each of the ${i.length} points that were measured.`));let s={name:e.title,color:"--accent",x:td(n,t),y:e.of},r=en({title:e.title,x:nd(t),y:e.y,series:[s]});return r&&vt(e.title,r)}function Yv(n){let e=f=>n.history?.[f]?.findLast(Me),t=at(n).history,i=e("iteration")??t?.iterations;if(!Me(i))return null;let[s,r]=[e("forward_calls")??t?.forward_calls,e("adjoint_calls")??t?.adjoint_calls],o=e("seconds"),a=Me(o)?`, ${he(o,3)} s`:"",c=(n.history?.projected_gradient??[]).findIndex(Me),h=c>0?(n.history?.iteration?.[c]??1)-1:0,u=h>0?` After iteration ${h} the voxels became finer: earlier numbers belong to coarser voxels, and the gradient curve begins there.`:"",d=`${he(i,6)} iterations, ${he(s,6)} dose and ${he(r,6)} adjoint calls${a}.`;return T("p.note",{},`${d} Compare methods by model calls, not by iterations.${u}`)}function Zv(n){let e=at(n).response;if(!Ci(e))return null;let t=Object.entries(e).map(([i,s])=>[i,he(s,4)]);return vt("Response that was found",St({caption:"Response that was found",heads:["parameter","value"],rows:t}))}function Kv(n){if(!n)return null;let e=r=>he(r,4),i=[["Outliers that are left out at either end",Me(n.outliers)?`${he(100*n.outliers,3)} %`:"–"],["Thresholds of the objective, lower and upper",(n.thresholds??[]).map(e).join(", ")],["All else of the part lies above",e(n.part_above)],["All else of the part lies below",e(n.part_below)],["All else of the void lies below",e(n.void_below)],["Process window",e(n.window)],["Range in the part",e(n.range)],["Bound of that range",e(n.ipdr)]],s=T("p.note",{},"On the optimization's voxels, before the patterns are written.");return vt("Process window that the objective found",s,St({caption:"Process window that the objective found",heads:["","response"],rows:i}))}var eg=6;function ha(n){return`--run-${n%eg+1}`}function tg(n){return n<eg?"line":"dashed"}function id(n,e,t,i){return{name:n.name,color:ha(e),style:tg(e),x:t,y:i}}function ro(n,e){return T("span.run-name",{},la(ha(e),tg(e)),n.name)}function ig({runs:n}){if(!n.some(r=>(r.history?.loss??[]).filter(Me).length>1))return null;let e=(r,o,a,l)=>{let c=n.map((u,d)=>id(u,d,td(u,l),a(u))),h=en({title:`${r} over ${l}`,x:nd(l),y:o,series:c});return h&&vt(r,h)},t=r=>(r.history?.iou??[]).map(o=>Me(o)?1-o:null),i=ed(r=>[e("Loss",{label:"loss",log:!0},o=>o.history?.loss??[],r),e("Voxels that would print wrongly",{label:"1 − IoU",log:!0},t,r),e("Process window",{label:"response"},o=>o.history?.process_window??[],r)]);return T("div",{},i,T("p.note",{},"Compare methods by model calls, not by iterations; seconds are those of the machine of each run. IoU is that on the grid of each optimization, where it was measured."))}function sg({runs:n}){let e=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:n.map((i,s)=>{let r=Rt(at(i).evaluation?.iou_curve);return id(i,s,r.map(o=>o?.[0]),r.map(o=>o?.[1]))})}),t=en({title:"Dose of part and void",x:{label:"response to the dose"},y:{label:"share of the voxels per unit",log:!0},series:n.flatMap(Jv)});return!e&&!t?null:T("div.charts",{},e&&vt("IoU over the gel threshold",T("p.note",{},"A broad plateau tolerates errors of exposure."),e),t&&vt("Dose of part and void",T("p.note",{},"Share of the voxels per unit of the response: part in full lines, void in dotted ones."),t))}function Jv(n,e){let t=at(n).evaluation?.histogram;return[{name:n.name,color:ha(e),style:"steps",...ng(t,"part")},{name:n.name,color:ha(e),style:"dotted",quiet:!0,...ng(t,"void")}]}function ng(n,e){let t=n?.[e]??[],[i,s]=n?.range??[],r=t.reduce((a,l)=>a+(l??0),0);if(!Me(i)||!Me(s)||r===0)return{x:[],y:[]};let o=(s-i)/t.length;return{x:t.map((a,l)=>i+(l+.5)*o),y:t.map(a=>(a??0)/(r*o))}}var jv=.2,sd={"x–y":2,"x–z":1,"y–z":0};function rg(n){return n.data.runs.filter(t=>es(t,"response","")).length>1?Ni(n,Qv):null}async function Qv(n){let{state:e,gone:t}=n,i=[],{read:s,problems:r}=await eb(n,()=>i.forEach(m=>m.redraw(!0))),[o,...a]=s;if(!o||a.length===0)throw new Error(r[0]??"Fewer than two runs hold a dose.");let l={low:Math.min(...s.map(({volume:m})=>m.info.low)),high:Math.max(...s.map(({volume:m})=>m.info.high))},c=a.filter(({volume:m})=>tb(m,o.volume)),h=a.filter(m=>!c.includes(m)),u=s.map(({name:m,volume:v,slices:A})=>({title:m,layer:jo(m,"Dose",v,A,null,l)})),d=c.map(m=>({title:m.name,layer:ru(m.volume,o.volume,nb(m,o),jv*l.high,m.name,`dose − that of ${o.name}`)})),f=T("div"),g=new AbortController;t.addEventListener("abort",()=>g.abort());let _=m=>{g.abort(),g=new AbortController;let{signal:v}=g,A=C=>{let x=new Vs({state:e,grid:o.volume,signal:v});return x.show(C.map(S=>({axis:m,...S}))),x};i=[u,d].filter(C=>C.length>0).map(A);let[M,R]=i.map(C=>T("div.runs-planes",{style:`--runs: ${s.length}`},C.element));f.replaceChildren(T("div",{},M,Ei(u[0].layer.legend())),R?vt(`Difference to ${o.name}`,T("p.note",{},"Red: a higher dose. Blue: a lower one."),R,Ei(d[0].layer.legend())):"")};_(sd["x–y"]);let p=Object.keys(sd);return T("div",{},...r.map(m=>T("p.problem",{role:"alert"},m)),...Fn(["Written patterns, vial turning, on one scale. A click, a slider or an arrow key moves all planes."],"quiet"),...h.map(({name:m})=>T("p.note",{},`No difference is drawn for ${m}: its voxels differ from those of ${o.name}.`)),Dl("Plane",p,"x–y",m=>_(sd[m])),f)}async function eb({data:n,stores:e,gone:t},i){let s=[],r=async a=>{let l=n.runs[a],c=es(l,"response","");if(!c)return null;try{return{name:l.name,volume:await e[a].volume(c),slices:new Xr(l,e[a],t,i)}}catch(h){return s.push(`${l.name}: ${h instanceof Error?h.message:String(h)}`),null}};return{read:(await Promise.all(n.runs.map((a,l)=>r(l)))).filter(a=>a!==null),problems:s}}function tb(n,e){let t=(i,s)=>Math.abs(i-s)<1e-6;return su(n,e)&&n.pitch.every((i,s)=>t(i,e.pitch[s]))&&n.info.center_xyz_mm.every((i,s)=>t(i,e.info.center_xyz_mm[s]))}function nb(n,e){return{of:(t,i,s)=>(t===n.volume?n:e).slices.of(t,i,s)}}function og(n,e,t){let i=[...new Set(n.runs.map(r=>at(r).part).filter(r=>r!==void 0))],s=n.runs.map((r,o)=>{let a=T("button",{type:"button","aria-pressed":String(o===e)},ro(r,o));return a.addEventListener("click",()=>t.set({run:o})),a});return T("div.head",{},T("p.brand",{},"Tomolith comparison"),T("h1",{},`${n.runs.length} runs`),T("p.lead",{},`${i.length===1?"Part":"Parts"}: ${i.join(", ")}`),T("div.chosen",{},T("span.quiet",{},"Shown in full below the comparison"),T("div.choice",{role:"group","aria-label":"Run that is shown in full"},...s)))}function ag({differing_keys:n},e){if(n.length===0)return T("p.quiet",{},"Nothing.");let t=n.map(({key:i,values:s})=>[T("code",{},i),...s.map(r=>r??ei)]);return T("div.job-keys",{},St({caption:"Keys of the jobs that differ",heads:["key",...e.map(ro)],rows:t,text:e.map((i,s)=>s+1)}))}function lg({data:n,run:e}){let{part:t,evaluation:i,run:s}=at(e),r=n.runs.length===1,o=s?.created;return T("div.head",{},T("p.brand",{},[ib[e.state],o].filter(Boolean).join(" · ")),T(r?"h1":"h2",{},r?t??e.name:e.name),T("p.lead",{},Bs([e.texts?.lead,e.texts?.print_time].filter(Boolean).join(" "))),rb(e.texts?.facts??[]),i?ob(n,e,i):null,i?hb(i,i.standing_still):null)}var ib={done:"Tomolith print report",running:"Tomolith, a run that goes on",check:"Tomolith, a job before it runs"},sb=60;function rb(n){return n.length===0?null:T("dl.facts",{},...n.map(([e,t])=>T(t.length>sb?"div.long":"div",{},T("dt",{},e),T("dd",{},Bs(t)))))}function rd(n,e){return(no(e)?n.gray_headline:n.headline).flatMap(i=>n.metrics.find(s=>s.name===i)??[])}function ob(n,e,t){let i=at(e).evaluation?.standing_still;return T("div.cards",{},...rd(n,t).map(s=>ab(s,t,i)))}function ab(n,e,t){let i=e[n.name],s=cl(i,n.unit,e.grid?.pitch_mm),r=n.name==="iou"?4:3,{unit:o}=zs(n.unit);return T("div.card",{"data-metric":n.name},T("h3",{},n.title),T("p.big",{},ns(n,i,r),Me(i)&&o!==""&&T("small",{},` ${o}`)),T("p",{},s!==""&&T("b",{},`${s}. `),n.summary,cb(n,e)),t?T("p.still",{},T("span",{},"standing still"),T("b",{},lb(n,t[n.name],r))):null)}function ns(n,e,t){let{factor:i}=zs(n.unit);return he(Me(e)?e*i:null,t)}function lb(n,e,t){let{unit:i}=zs(n.unit);return Me(e)&&i!==""?`${ns(n,e,t)} ${i}`:ns(n,e,t)}function cb(n,{farthest:e}){let t=e?.at_xyz_mm;if(n.name!=="hausdorff_mm"||!t?.every(Me))return"";let[i,s,r]=t.map(o=>he(o,3));return` It is at x = ${i}, y = ${s}, z = ${r} mm: ${(e?.side??"").replaceAll("_"," ")}.`}function hb(n,e){if(!e||n.sub_angles===1)return null;let[t,i]=no(n)?["rms_error","rms error"]:["pw","process window"],[s,r]=[n[t],e[t]],o=Me(s)&&Me(r)?` Here the ${i} is ${he(r,3)} standing still and ${he(s,3)} turning.`:"";return T("p.note",{},`The vial keeps turning while a frame is shown, so the frame's light lands all along its arc. The large numbers include this (${he(n.sub_angles,3)} positions per frame); “standing still” is what the same patterns would do if the vial stood still during each frame.${o} More frames per turn bring the two together.`)}function cg({data:n,run:e}){let{evaluation:t,optimization:i}=at(e),s=[{name:"Turning",evaluation:t},{name:"Standing still",evaluation:t?.standing_still},{name:"Optimization",evaluation:i}].filter(l=>!!l.evaluation),r=fb(n.metrics,s,no(t)?n.gray_headline:[]);if(r.length===0)return null;let o=no(t)?" For a gray target, “part” is where its value is at least ½.":"",a=s.map(({name:l,evaluation:c})=>T("span",{},l,T("small",{},pb(c))));return T("div",{},T("p.quiet",{},`↑ larger is better, ↓ smaller is better. The first columns are on the evaluation's voxels, from the patterns as they were written; the last one is of the patterns before they are written, on the job's own voxels, the vial standing still.${o}`),io("Copy as CSV",()=>gb(r,s)),St({caption:"All numbers",heads:["",...a],rows:r.map(l=>[od(l),...s.map(c=>mb(l,c))]),strong:1}),ub(s))}function ub(n){let e=n.map(({name:i,evaluation:s},r)=>{let o=Rt(s.iou_curve);return{name:i.toLowerCase(),color:db[r],style:r===0?"line":"dashed",x:o.map(a=>a?.[0]),y:o.map(a=>a?.[1])}}),t=en({title:"IoU over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:e});return t&&vt("IoU over the gel threshold",t)}var db=["--run-1","--run-2","--run-3"];function fb(n,e,t){let i=n.filter(r=>e.some(({evaluation:o})=>Me(o[r.name]))),s=r=>t.includes(r.name)?0:1;return i.sort((r,o)=>s(r)-s(o))}function od(n){let{unit:e}=zs(n.unit),t=n.better==="higher"?" ↑":n.better==="lower"?" ↓":"";return T("span",{},n.title,t,e!==""&&T("span.unit",{},` ${e}`),n.summary!==""&&T("small",{},n.summary))}function pb({grid:n}){return Me(n?.pitch_mm)?`${he(1e3*n.pitch_mm,3)} µm voxels`:""}function mb(n,{evaluation:e}){let t=e[n.name],i=cl(t,n.unit,e.grid?.pitch_mm);return T("span",{},ns(n,t,4),i!==""&&T("span.unit",{},` (${i})`))}function gb(n,e){let t=n.map(({name:i,unit:s})=>so([i,s,...e.map(({evaluation:r})=>r[i])]));return[so(["metric","unit",...e.map(({name:i})=>i)]),...t].join(`
`)+`
`}function hg(n,e,t){let i=n.numbers.filter(c=>c.values.some(Me));if(i.length===0)return null;let s=n.marks_best?"the best is bold.":"the best is not marked, because the runs were evaluated by different models: compare only columns with the same one.",r=e.map((c,h)=>T("span",{},ro(c,h),T("small",{},xb(n,h)))),o=c=>t.find(({name:h})=>h===c.key)?.summary??null,a=c=>{let h=_b(c,n),u=(f,g)=>h!==null&&f===h&&n.prints[g];return[T("span",{title:o(c)},od({title:c.name,unit:c.unit,better:c.better,summary:""})),...c.values.map((f,g)=>u(f,g)?T("b.best",{},ns(c,f,4)):ns(c,f,4))]},l=()=>[so(["number","unit",...e.map(c=>c.name)]),...i.map(c=>so([c.key,c.unit,...c.values]))].join(`
`)+`
`;return T("div",{},T("p.quiet",{},`Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; ${s}`),io("Copy as CSV",l),St({caption:"Numbers of all runs",heads:["",...r],rows:i.map(a)}))}function _b(n,{marks_best:e,prints:t}){let i=n.values.filter((s,r)=>Me(s)&&t[r]);return!e||n.better==="none"||i.length===0?null:n.better==="higher"?Math.max(...i):Math.min(...i)}function xb({kinds:n,models:e},t){return[n[t],e[t]&&`evaluated by ${e[t]}`].filter(Boolean).join(", ")}function ug({warnings:n}){let e=ca(n);return e&&T("div.warn",{role:"note"},e)}function ua(n){return e=>e.data.runs.length>1?n(e):null}function ad(n){return ua(e=>e.data.compare?n(e.data.compare,e):null)}var Nl=[{id:"compare",title:"",render:ua(({data:n,index:e,state:t})=>og(n,e,t))},{id:"cautions",title:"Before you compare",render:ad(ug)},{id:"side-by-side",title:"Numbers side by side",render:ad((n,{data:e})=>hg(n,e.runs,e.metrics))},{id:"job-keys",title:"What differs in the jobs",render:ad((n,{data:e})=>ag(n,e.runs))},{id:"doses",title:"Doses",render:ua(rg)},{id:"thresholds",title:"Thresholds",render:ua(({data:n})=>sg(n))},{id:"histories",title:"Histories",render:ua(({data:n})=>ig(n))}];var yb=3,vb=.02;function fg({run:n}){let e=Rt(at(n).ceiling?.trade_off);if(e.length===0&&!n.texts?.ceiling)return null;let t=e.length>0&&e.every(a=>Me(a.time_s)),i=t?{label:"print time",unit:"s",from:0}:{label:"print time M/t",unit:"mm",from:0},s=a=>t?a.time_s:a.time_mm,r=[dg("IoU",e,i,s,a=>a.iou),dg("VER",e,i,s,a=>a.ver)].filter(a=>a!==null);return T("div",{},...Fn([n.texts?.ceiling,e.length>0?"The ceilings of the pixels that the run tried, on pixels of twice the width. `tomolith expose RUN --trade-off` lists them and writes the job of one.":null]),T("div.charts",{},...r),bb(e))}function dg(n,e,t,i,s){let r=e.filter(p=>!p.is_evaluated),o=e.filter(p=>p.is_chosen);if(r.filter(p=>Me(i(p))&&Me(s(p))).length<yb)return null;let a=e.map(s).filter(Me),[l,c]=[Math.min(...a),Math.max(...a)],h=.6*Math.max(c-l,vb),u={label:n,from:Math.max((l+c)/2-h,0),to:Math.min((l+c)/2+h,1)},d=p=>({x:p.map(i),y:p.map(s)}),f=Math.max(...e.map(i).filter(Me)),g=o.some(p=>p.is_evaluated)?"this run, as it was evaluated":"this run",_=en({title:`${n} over the print time`,x:{...t,to:1.05*f},y:u,series:[{name:"tried",color:"--accent",...d(r)},{name:g,color:"--threshold",style:"dots",...d(o)}]});return _&&vt(n,_)}function bb(n){if(n.length===0)return null;let e=n.some(s=>Me(s.time_s)),t=s=>[[he(s.brightest,3),s.is_chosen&&" (taken)"].filter(Boolean).join(""),an(s.time_mm,"",3),...e?[an(s.time_s,"",3)]:[],an(s.iou,"",4),an(s.ver,"",3),an(Me(s.surface_mean_mm)?1e3*s.surface_mean_mm:null,"",3)],i=["Brightest pixel, mJ/mm²","M/t, mm",...e?["time, s"]:[],"IoU","VER","surface off on average, µm"];return St({caption:"Quality against time",heads:i,rows:n.map(t)})}var Ul=32;function pg(n){let[e,t,i]=["response","target","labels"].map(s=>es(n.run,s,""));return!e||!t?null:Ni(n,async({store:s})=>{let r=await Promise.all([e,t,...i?[i]:[]].map(c=>s.volume(c))),[o,a,l]=r;return Sb(Mb(o,a,l??null))})}function Mb(n,e,t){let[i,s,r]=[0,1,2].map(()=>new Float64Array(Ul)),o=Math.min(n.codes.length,e.codes.length);for(let a=0;a<o;a++){if(t&&t.codes[a]===ps.outside)continue;let[l,c]=[n.values[n.codes[a]],e.values[e.codes[a]]];if(Number.isNaN(l)||Number.isNaN(c))continue;let h=Math.min(Math.max(Math.floor(c*Ul),0),Ul-1);i[h]++,s[h]+=l,r[h]+=l*l}return[...i.keys()].filter(a=>i[a]>0).map(a=>{let l=s[a]/i[a];return{gray:(a+.5)/Ul,mean:l,deviation:Math.sqrt(Math.max(r[a]/i[a]-l*l,0))}})}function Sb(n){let e=n.map(({gray:s})=>s),t=(s,r)=>({name:"± one standard deviation",color:"--void",x:e,y:n.map(({mean:o,deviation:a})=>o+s*a),quiet:r});return en({title:"Response against gray value",x:{label:"gray value of the target",from:0,to:1},y:{label:"response",from:0},series:[{name:"mean",color:"--accent",x:e,y:n.map(({mean:s})=>s)},t(1,!1),t(-1,!0),{name:"asked for",color:"--ink",style:"dashed",x:[0,1],y:[0,1]}]})??T("p.note",{},"No voxel counts.")}var wb=80;function gg(n){let e=at(n.run).evaluation,t=e?.errors,[i,s]=t?.range??[];if(!e||!t||!Me(i)||!Me(s))return null;let r=Math.max(...["max_error_part","max_error_void"].map(m=>e[m]).filter(Me),0),[o,a]=t.band??[],l=t.part?.length??0;if(l===0)return null;let c=(s-i)/l,h=Math.min(Math.max(r,2*(a??0),8*c),s),u=mg(t,"part",c,h),d=mg(t,"void",c,h),f=Me(o)&&Me(a)?[{name:"the objective's band",color:"--quiet",from:o,to:a}]:[],g=en({title:"Error of bright and dark voxels",x:{label:"response − gray value",from:-h,to:h},y:{label:"voxels",log:!0},series:[{name:"dark (below ½)",color:"--void",style:"steps",...d},{name:"bright",color:"--part",style:"steps",...u}],marks:f});if(!g)return null;let _=Me(t.band_edge_peak)?` At the edges of the band lie ${he(t.band_edge_peak,3)} times as many voxels as a little inside or outside.`:"",p=pg(n);return T("div.charts",{},vt("Voxels per error",T("p.note",{},`The band is what the objective asks for.${_}`),g),p&&vt("Response against gray value",T("p.note",{},"Of the voxels of each gray value."),p))}function mg(n,e,t,i){let s=n[e]??[],r=n.range?.[0]??0,o=Math.max(1,Math.round(2*i/t/wb)),a=[],l=[];for(let c=0;c<s.length;c+=o){let h=r+c*t;h+o*t<-i||h>i||(a.push(h),l.push(s.slice(c,c+o).reduce((u,d)=>u+(d??0),0)))}return{x:a,y:l}}function _g({run:n}){let e=n.job;return e?T("div",{},T("details.fold",{},T("summary",{},"The job, with every default"),io("Copy the job",()=>e),T("pre.job",{tabindex:"0"},e))):null}function yg({run:n}){let e=at(n),t=Rt(e.lights);if(t.length===0)return null;let i=t.map((o,a)=>o.name||(t.length>1?`light ${a+1}`:"value")),s=Tb.map(([o,a])=>[o,...t.map(a)]).filter(([,...o])=>o.some(a=>a!==ei&&a!=="")),r=t.length>1&&Me(e.time_to_print_s)?`All lights together take ${Si(e.time_to_print_s)}.`:null;return T("div",{},...Fn([r,Eb(t)]),St({caption:"Lights",heads:["",...i],rows:s}))}function Eb(n){return n.some(e=>e.irradiance)?"The job's schedule says how long and how bright the light is.":n.some(e=>Me(e.budget?.time_s))?null:"Times need `resin.critical_dose_mj_per_mm3` and `printer.peak_irradiance_mw_per_cm2`, and frames that follow each other at one rate: frames of a list of angles (`light.angles.list_deg`) have no times."}var oo=n=>n.budget??{},Tb=[["Wavelength",n=>an(n.wavelength_nm,"nm",4)],["Frames",n=>he(n.frames,6)],["Pixels of a frame",n=>xg([n.columns,n.rows])],["Pixel pitch",Ab],["Depth",n=>an(n.bits,"bit")],["White, over the whole exposure",n=>an(n.full_scale,"",4)],["Device",n=>n.canvas?`${xg(n.canvas)} pixels`:"the patterns as they are"],["White, while it shines",Cb],["Time to print, or length of the schedule",n=>Si(oo(n).time_s)],["Turns of the vial",n=>he(oo(n).turns,3)],["White, of a frame over the whole print",n=>an(oo(n).white_mj_per_mm2,"mJ/mm²")],["Energy at the vial per turn",n=>an(oo(n).energy_per_turn_mj,"mJ")],["Energy at the vial in all",n=>an(oo(n).energy_mj,"mJ")],["Share of the device's light that is used",n=>vg(oo(n).light_used)]];function xg(n){return n.map(e=>he(e,6)).join(" × ")}function Ab({pitch_mm:n}){let e=(Array.isArray(n)?n:[n]).filter(Me);return e.length>0?`${e.map(t=>he(1e3*t,3)).join(" × ")} µm`:ei}function Cb({irradiance:n}){let e=n?.white_mw_per_cm2,t=n?.peak_mw_per_cm2,i=Me(e)&&Me(t)&&t>0?`, ${vg(e/t)} of what the printer gives`:"";return an(e,"mW/cm²")+i}function vg(n){return Me(n)?`${he(100*n,3)} %`:ei}function bg(n,e,t){let i=new Map(n.map(({id:r,title:o})=>[r,ld(r,o,e)])),s=r=>{for(let[l,c]of i)l===r?c.setAttribute("aria-current","location"):c.removeAttribute("aria-current");let o=i.get(r),a=o?.parentElement?.parentElement;o&&a&&(a.scrollLeft=o.offsetLeft-a.clientWidth/2+o.offsetWidth/2)};return t.addEventListener("abort",e.on(["section"],()=>Ol(e.get("section")))),Rb([...i.keys()],s,t),T("nav.sections",{"aria-label":"Sections"},T("ol",{},...[...i.values()].map(r=>T("li",{},r))))}function ld(n,e,t){return T("a",{href:`#section=${n}`,click:i=>{i.ctrlKey||i.metaKey||i.shiftKey||(i.preventDefault(),t.get("section")===n?Ol(n):t.set({section:n}))}},e)}function Ol(n){let e=n===""?null:document.getElementById(n);if(!e)return;let t=matchMedia("(prefers-reduced-motion: reduce)").matches;e.scrollIntoView({behavior:t?"auto":"smooth"}),e.tabIndex=-1,e.focus({preventScroll:!0})}function Rb(n,e,t){let i="",s=!1,r=()=>{s=!1;let a=window.innerHeight/4,c=n.filter(h=>(document.getElementById(h)?.getBoundingClientRect().top??1/0)<=a).at(-1)??n[0]??"";c!==i&&(i=c,e(c))},o=()=>{s||(s=!0,requestAnimationFrame(r))};window.addEventListener("scroll",o,{signal:t,passive:!0}),o()}function Sg({run:n,state:e}){let t=at(n);return t.evaluation?T("div.two",{},Pb(t,n.texts,e),Db(t,n.texts?.limits??[])):null}function Pb(n,e,t){let i=n.one_exposure?Lb(n.one_exposure,Rt(n.species)):Ib(n),s=i.length>0?St({caption:"Best exposure",heads:["","shortest","best","longest"],rows:i,strong:2}):null,r=n.one_exposure?[e?.one_exposure,"The table compares exposures with it."]:e?.exposure??[],o=T("p.note",{},"This is about the dose. When to stop in the job's schedule stands under ",ld("time","The print in time",t),".");return vt("Best exposure",...Fn(r),s,Rt(n.time).length>0&&o)}function Ib({exposure:n}){if(!n)return[];let e=[["Exposure",..._r(n.percent,hd)]];n.time_s&&e.push(["Time to print",..._r(n.time_s,wg)]),n.dose&&e.push(["Dose that gels",..._r(cd(n.dose),Mg)]);let t=n.threshold?.best!==n.dose?.best||n.threshold?.low!==n.dose?.low;return n.threshold&&t&&e.push(["Response that gels",..._r(cd(n.threshold),Mg)]),e}function Lb(n,e){let t=[["All together",..._r(n.percent,hd)]];n.time_s&&t.push(["Time to print",..._r(n.time_s,wg)]);for(let{name:i=ei,exposure:s}of e){if(!s?.dose)continue;let r=c=>Me(c)&&Me(n.gel_dose)&&c>0?100*n.gel_dose/c:null,{low:o,best:a,high:l}=cd(s.dose);t.push([`${i} alone`,..._r({low:r(o),best:r(a),high:r(l)},hd)])}return t}function cd({low:n,best:e,high:t}){return{low:t??null,best:e??null,high:n??null}}var Mg=n=>Ko(n,3),hd=n=>Ko(n,3).map(e=>`${e} %`),wg=n=>n.map(Si);function _r(n,e){let t=[n?.low,n?.best,n?.high],i=e(t.filter(Me));return t.map(s=>Me(s)?i.shift()??"":"no limit")}function Db(n,e){let t=Rt(n.species),s=(t.length>1?t.map(r=>({name:r.name??"",causes:Rt(r.limits)})):[{name:"",causes:Rt(n.limits)}]).flatMap(({name:r,causes:o},a)=>{let l=e.find(c=>c.name===r)??e[a];return o.length===0&&!l?.sentence?[]:[T("div",{},r!==""&&T("h4",{},r),...Fn([l?.sentence]),Nb(o))]});return s.length>0?vt("What limits the print",...s):null}function Nb(n){if(n.length===0)return null;let e=Math.max(...n.map(t=>Eg(t).loss??0));return T("ol.causes",{},...n.map(t=>Ub(t,e)))}function Eg(n){return Me(n.loss_in_rms_error)?{loss:n.loss_in_rms_error,measure:"rms error"}:{loss:Me(n.loss_in_iou)?n.loss_in_iou:null,measure:"IoU"}}function Ub(n,e){let{loss:t,measure:i}=Eg(n),s=t!==null&&e>0?Math.max(t,0)/e:0,{key:r,advice:o=""}=n;return T("li",{"data-cause":n.cause},T("div.cause-head",{},T("b",{},Fb[n.cause??""]??n.cause??""),T("span.loss",{},Ob(t,i))),T("div.share",{"aria-hidden":"true"},T("i",{style:`width: ${(100*s).toFixed(1)}%`})),T("p",{},Bs(o),r&&!o.includes(r)?T("span.key",{}," ",T("code",{},r)):null))}function Ob(n,e){if(n===null)return"";if(Math.abs(n)<5e-4)return"costs nothing";let t=`${he(Math.abs(n),2)} ${e}`;return e==="IoU"?n>0?`−${t}`:`+${t}`:n>0?`+${t}`:`−${t}`}var Fb={grid:"Voxels of the optimization",levels:"Gray levels and pixels",turning:"Turning during a frame",optics:"Pixels and frames",iterations:"Iterations",ends:"Flat ends of the part",exposure:"Exposure",time:"The brightest pixel"};function Tg({run:n}){let e=Rt(at(n).movies);if(e.length===0)return null;let t=e.map(i=>[T("code",{},i.file??""),he(i.frames,6),he(i.frame_rate,4),`${he(i.width,6)} × ${he(i.height,6)}`,he(i.largest_error_of_255,3),he(i.rms_error_of_255,2)]);return T("div",{},T("p.quiet",{},"Written, then decoded again and compared with the frames; errors are gray levels of 255. H.264 is lossy: the PNG frames are exact."),St({caption:"Movies",heads:["file","frames","rate, 1/s","pixels","largest error","rms error"],rows:t}))}function Ag({run:n}){let e=at(n),t=ca([...Rt(e.warnings),...Rt(e.evaluation?.notes)]);return t&&T("div.warn",{role:"note"},t)}function Cg({data:n,run:e}){let t=at(e),i=ca(Rt(t.notes)),r=Object.entries(t.run?.models??{}).map(([o,a])=>T("div",{},T("dt",{},`Doses of the ${o}`),T("dd",{},String(a))));return T("div",{},T("p.quiet",{},`${t.run?.program??n.program}. Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.`),i&&vt("Choices",i),r.length>0&&vt("Models",T("dl.models",{},...r)))}function Rg({run:n}){let e=Rt(at(n).optimization?.objectives);if(e.length<2)return null;let t=e.map(i=>[T("code",{},i.key??""),he(i.weight,4),he(i.loss,4),he(i.voxels,6),he(i.rms_error,4),he(i.max_error,4)]);return T("div",{},T("p",{},"What each of them comes to on the job's own voxels, before the patterns are written. The sum takes a loss times its factor."),St({caption:"Objectives",heads:["objective","factor","loss","voxels","rms error","largest error"],rows:t}))}function Pg({run:n}){let e=Rt(at(n).properties);return e.length===0?null:T("div",{},T("p.quiet",{},"Where something is solid. Half of it lies below the median."),St({caption:"Predicted properties",heads:["property","lowest","median","highest","unit"],rows:e.map(Bb),text:[4]}))}function Bb({name:n,unit:e,min:t,median:i,max:s}){let r=[t,i,s],o=Ko(r.filter(Me),3);return[n??"",...r.map(a=>Me(a)?o.shift()??"":"–"),e??""]}function Ig({run:n}){let e=Object.entries(at(n).published??{}),t=e.flatMap(([r,o])=>Ci(o)&&typeof o.source=="string"?[kb(r,o)]:[]),i=e.filter(([r,o])=>r!=="slices"&&!(Ci(o)&&typeof o.source=="string")),s=Vb(at(n).published?.slices);return t.length===0&&i.length===0?null:T("div",{},t.length>0&&zb(t),s,...i.map(([r,o])=>vt(dd(r),ud(o))))}function kb(n,e){let t=i=>typeof e[i]=="string"?e[i]:"";return{name:n,value:e.value,unit:t("unit"),note:t("note"),source:t("source")}}function zb(n){let e=T("div"),t=T("span.quiet",{"aria-live":"polite"}),i=T("input",{type:"search",placeholder:"jaccard, Dr.TVAM, eq. 12, …","aria-label":"Filter the published numbers"}),s=()=>{let r=i.value.toLowerCase().split(/\s+/).filter(Boolean),o=u=>`${u.name} ${u.note} ${u.source} ${u.unit}`.toLowerCase(),a=n.filter(u=>r.every(d=>o(u).includes(d)));t.textContent=a.length===n.length?`${n.length} numbers`:`${a.length} of ${n.length} numbers`;let l=u=>[T("code",{},u.name),he(u.value,4),u.unit,u.note,u.source],c=["name","value","unit","definition","source"],h=T("p.note",{},"No number has all of these words in its name, definition or source.");e.replaceChildren(a.length===0?h:St({caption:"Published numbers",heads:c,rows:a.map(l),text:[2,3,4]}))};return i.addEventListener("input",s),s(),T("details.fold",{},T("summary",{},`${n.length} numbers as other authors and programs define them`),T("label.filter",{},"Filter ",i," ",t),e)}function Vb(n){let e=Array.isArray(n)?n.filter(Ci):[],t=l=>e.map(c=>c[l]),i=t("z_mm"),s=(l,c,h)=>({name:l,color:c,x:i,y:t(h)}),r={label:"z",unit:"mm"},o=en({title:"Dose of each slice over z",x:r,y:{label:"response"},series:[s("process window","--run-1","pw"),s("range in the part","--run-2","ipdr")]}),a=en({title:"Voxel error rate of each slice over z",x:r,y:{label:"voxel error rate",from:0},series:[s("voxel error rate","--run-1","ver")]});return!o&&!a?null:vt("Slice by slice",T("div.charts",{},o&&T("div",{},o),a&&T("div",{},a)))}function ud(n){if(Me(n))return he(n,4);if(n==null)return ei;if(Array.isArray(n)){if(n.every(i=>!Ci(i)))return n.map(i=>Me(i)?he(i,4):String(i??ei)).join(" ");let e=[...new Set(n.filter(Ci).flatMap(i=>Object.keys(i)))],t=i=>e.map(s=>Ci(i)?ud(i[s]):String(i));return St({heads:e.map(dd),rows:n.map(t)})}return Ci(n)?St({heads:["","value"],rows:Object.entries(n).map(([e,t])=>[dd(e),ud(t)])}):String(n)}var Hb={keep_dark:"Bodies that are to stay dark",insert:"Surface of the inserts",insert_mm2:"In all, mm²",target_mm2:"Touched by the target, mm²",print_mm2:"Touched by the print, mm²",share:"Share that the print touches",of_target:"Share of what the target touches that the print touches too",part_mean:"Mean of the part",paths:"Scattering by Monte Carlo paths",orders:"Scattering, order by order",unit_systems:"In the units of others"};function dd(n){let e=Hb[n];if(e!==void 0)return e;let t=/_(mm3|mm2|mm)$/.exec(n),i=(t?n.slice(0,t.index):n).replaceAll("_"," "),s=i.charAt(0).toUpperCase()+i.slice(1);return t?`${s}, ${t[1]?.replace("3","³").replace("2","²")}`:s}function Lg({run:n}){let e=at(n).scenarios;if(!e)return null;let t=Rt(e.rows).map(r=>[r.name??"",he(r.iou_at_threshold,4),he(r.iou,4),he(r.gamma,4),he(r.part_low,4),he(r.void_high,4)]),i=he(e.threshold,4),s=e.of==="worst"?"the worst of them":e.of==="mean"?"their mean":e.of;return T("div",{},...Fn([`What the same patterns print where something is otherwise. Nobody knows which scenario a print is, so all of them gel at the threshold of the job, ${i}.`,n.texts?.scenarios]),St({caption:"Scenarios",heads:["scenario","IoU there","IoU at its own threshold","Γ, %","least of the part","largest of the void"],rows:t,strong:1}),T("p.note",{},`Window over all of them: ${he(e.window,4)}, trimmed.${s?` The optimization minimized ${s}.`:""}`))}function Dg({data:n,run:e}){let{species:t,one_exposure:i}=at(e),s=Rt(t);if(s.length<2)return null;let r=s[0]?.evaluation,o=r?rd(n,r):[];return T("div",{},T("p",{},"The numbers at the head of the page are those of ",T("b",{},s[0]?.name??""),"."),T("ul.drives",{},...s.map(a=>T("li",{},T("b",{},a.name??""),` is ${Gb(a)}.`))),vt("Each alone",St({caption:"Each species alone",heads:["",...s.map(a=>a.name??"")],rows:o.map(a=>Wb(a,s))})),i?Xb(s,i):null,qb(s,i))}function Gb({driven_by:n}){let e=Object.entries(n??{}).filter(([,o])=>Me(o)&&o!==0),t=o=>e.filter(([,a])=>Math.sign(a??0)===o).map(([a,l])=>`${he(Math.abs(l??0),3)} × ${a}`),[i,s]=[t(1),t(-1)];return[i.length>0&&`driven by ${i.join(" and ")}`,s.length>0&&`inhibited by ${s.join(" and ")}`].filter(Boolean).join(", ")||"driven by no light"}function Wb(n,e){let{unit:t}=zs(n.unit);return[T("span",{title:n.summary},n.title,t!==""&&T("span.unit",{},` ${t}`)),...e.map(({evaluation:s})=>ns(n,s?.[n.name],4))]}function Xb(n,e){let t=r=>r.name&&r.name===e.limited_by?`${r.name} (limits it)`:r.name??"",i=n.map((r,o)=>[t(r),he(r.evaluation?.iou,4),he(r.evaluation?.gel_threshold,3),he(e.iou?.[o],4)]),s=`A print has one exposure. Where all networks gel at the same dose, the species print together best at a dose of ${he(e.gel_dose,3)}: the last column. Each reaches the IoU of its own where its network gels at its own dose.`;return vt("Together at one exposure",T("p",{},s),St({caption:"Species at one exposure",heads:["species","IoU alone","at a threshold of","IoU together"],rows:i,strong:3}))}function qb(n,e){let t=n.map(({name:o,evaluation:a},l)=>{let c=Rt(a?.iou_curve);return{name:o??"",color:`--run-${l%6+1}`,x:c.map(h=>h?.[0]),y:c.map(h=>h?.[1])}}),i=n.every(({exposure:o})=>o?.dose?.best===o?.threshold?.best),s=e&&i&&Me(e.gel_dose)?[{name:"one exposure",color:"--threshold",from:e.gel_dose}]:[],r=en({title:"IoU of each species over the gel threshold",x:{label:"gel threshold",from:0},y:{label:"IoU",from:0,to:1},series:t,marks:s});return r&&vt("How much the threshold matters to each",r)}function Ng({run:n}){let e=at(n),t=Rt(e.time);if(t.length===0)return null;let i=s=>{let r=(n.texts?.time??[]).find(a=>a.name===s.name)?.sentence,o=[...Fn([r,$b(s,e.evaluation)]),Yb(s),Zb(s)];return t.length>1?vt(s.name??"",...o):T("div",{},...o)};return T("div",{},...Fn([n.texts?.one_moment],"lead-in"),...t.map(i))}function $b(n,e){let t=o=>{let a=o?.grid?.pitch_mm;return Me(a)?1e3*a:null},[i,s]=[t(n.evaluation),t(e)];if(i===null||s===null)return null;let r=he(i,3);return Math.abs(i-s)<1e-6*i?`Printed on voxels of ${r} µm, as the dose above.`:`Printed on the job's own voxels of ${r} µm. The numbers above are of voxels of ${he(s,3)} µm, so the two cannot be compared.`}function Yb(n){let e=n.curves??{},t=e.seconds??[],i=t.findLast(Me),s={label:"time",unit:"s",from:0,...Me(i)?{to:i}:{}},r=(_,p,m,v={})=>({name:_,color:p,x:t,y:e[m]??[],...v}),o=Me(n.best_s)?[{name:"best",color:"--threshold",from:n.best_s}]:[],[a,l]=n.window_s??[],c=Me(a)&&Me(l)?[{name:"within 0.01 of the best",color:"--threshold",from:a,to:l}]:[],h=en({title:"Jaccard index and contrast over time",x:s,y:{label:"share",from:0,to:1},series:[r("Jaccard index","--ink","jaccard"),r("part that is solid","--part","solid_part"),r("void that is solid","--void","solid_void"),r("contrast of the dose","--quiet","contrast",{style:"dashed"})],marks:[...c,...o]}),u=Me(n.ideal_exposure_s)?[{name:"ideal exposure",color:"--threshold",from:n.ideal_exposure_s}]:[],d=n.requirement_mj,f=en({title:"Absorbed drive over time",x:s,y:{label:"absorbed drive",unit:"mJ",from:0},series:[r("in all voxels","--quiet","imbued_mj"),r("in solid voxels","--accent","contribution_mj"),{name:"needed",color:"--ink",style:"dashed",x:[0,i],y:[d,d]}],marks:u}),g=en({title:"Light sent over time",x:s,y:{label:"sent to the vial",unit:"mJ",from:0},series:[r("sent","--accent","sent_mj")]});return T("div.charts",{},h&&vt("What is solid",h),f&&vt("What is absorbed",f),g&&vt("Light that was sent",g))}function Zb(n){let e=n.evaluation,t=s=>an(s,"s"),i=[["First voxel solid",t(n.induction_end_s)],["Best moment",t(n.best_s)],["Jaccard index then",he(n.best_jaccard,4)],["Sent to the vial by then",an(n.best_mj,"mJ")],["Within 0.01 of the best",(n.window_s??[]).map(t).join(" to ")||"–"],["Ideal exposure",t(n.ideal_exposure_s)],["Dose that the part needs",an(n.requirement_mj,"mJ")],...Me(n.largest_share_of_requirement)?[["Largest share of it that was reached",an(100*n.largest_share_of_requirement,"%")]]:[],...e?[["Voxel error rate of what is solid then",he(e.ver,3)]]:[]];return St({caption:`Moments of the print in time${n.name?`: ${n.name}`:""}`,heads:["","value"],rows:i})}function Ug({run:n}){let e=Object.entries(at(n).run?.timings_s??{}).filter(h=>Me(h[1])),t=Math.max(0,...e.map(([,h])=>h));if(t===0)return null;let i=e.filter(([h])=>!h.includes(": ")),s=h=>e.filter(([u])=>u.startsWith(`${h}: `)),r=e.filter(([h])=>h.includes(": ")&&!i.some(([u])=>h.startsWith(`${u}: `))),o=(h,u)=>u[1]-h[1],a=i.reduce((h,[,u])=>h+u,0),l=(h,u,d)=>T(d?"div.row.sub":"div.row",{},T("span",{},h),T("div.share",{"aria-hidden":"true"},T("i",{style:`width: ${(100*u/t).toFixed(1)}%`})),T("span.value",{},`${he(u,3)} s`)),c=[...i,...r].sort(o).flatMap(([h,u])=>[l(h,u,!1),...s(h).sort(o).map(([d,f])=>l(d.slice(h.length+2),f,!0))]);return T("div",{},T("p.quiet",{},`${he(a,3)} s until this page was written.`),T("div.timings",{},...c))}var Og=[...Nl,{id:"head",title:"",render:lg},{id:"warnings",title:"Please note",render:Ag},{id:"limits",title:"Exposure and limits",render:Sg},{id:"errors",title:"How far the response is off",render:gg},{id:"species",title:"Several species",render:Dg},{id:"time",title:"The print in time",render:Ng},{id:"properties",title:"Predicted properties",render:Pg},{id:"ceiling",title:"Quality against time",render:fg},{id:"scenarios",title:"Scenarios",render:Lg},{id:"objectives",title:"Objectives",render:Rg},{id:"history",title:"History of the optimization",render:Qm},{id:"lights",title:"Light and time",render:yg},{id:"numbers",title:"All numbers",render:cg},{id:"published",title:"Published numbers",render:Ig},{id:"movies",title:"Movies",render:Tg},{id:"timings",title:"Where the time went",render:Ug},{id:"notes",title:"How it was computed",render:Cg},{id:"job",title:"The job",render:_g}];var tr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},nr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},c0=0,Vd=1,h0=2;var za=1,u0=2,No=3,ir=0,jn=1,ii=2,Tr=0,Uo=1,Hd=2,Gd=3,Wd=4,d0=5;var Ar=100,f0=101,p0=102,m0=103,g0=104,_0=200,x0=201,y0=202,v0=203,Xd=204,qd=205,b0=206,M0=207,S0=208,w0=209,E0=210,T0=211,A0=212,C0=213,R0=214,ac=0,lc=1,cc=2,Mo=3,hc=4,uc=5,dc=6,fc=7,kc=0,P0=1,I0=2,os=0,$d=1,Yd=2,Zd=3,Kd=4,Jd=5,jd=6,Qd=7;var ef=300,Cr=301,Oo=302,zc=303,Vc=304,pc=1e3,ss=1001,mc=1002,yn=1003,L0=1004;var Va=1005;var Jn=1006,Hc=1007;var Rs=1008;var si=1009,tf=1010,nf=1011,Fo=1012,Gc=1013,Hi=1014,Gi=1015,Wi=1016,Wc=1017,Xc=1018,Rr=1020,sf=35902,rf=35899,of=1021,af=1022,vi=1023,Es=1026,Ps=1027,lf=1028,qc=1029,sr=1030,$c=1031;var Yc=1033,Ha=33776,Ga=33777,Wa=33778,Xa=33779,Zc=35840,Kc=35841,Jc=35842,jc=35843,Qc=36196,eh=37492,th=37496,nh=37488,ih=37489,qa=37490,sh=37491,rh=37808,oh=37809,ah=37810,lh=37811,ch=37812,hh=37813,uh=37814,dh=37815,fh=37816,ph=37817,mh=37818,gh=37819,_h=37820,xh=37821,yh=36492,vh=36494,bh=36495,Mh=36283,Sh=36284,$a=36285,wh=36286;var va=2300,gc=2301,rc=2302,Nd=2303,Ud=2400,Od=2401,Fd=2402;var D0=3200;var Eh=0,N0=1,Is="",Dn="srgb",ba="srgb-linear",Ma="linear",Lt="srgb";var oc=7680;var U0=519,O0=512,F0=513,B0=514,cf=515,k0=516,z0=517,hf=518,uf=519,V0=35044;var df="300 es",Pi=2e3,So=2001;function Kb(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Jb(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Sa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function H0(){let n=Sa("canvas");return n.style.display="block",n}var Fg={},wo=null;function ff(...n){let e="THREE."+n.shift();wo?wo("log",e,...n):console.log(e,...n)}function G0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ze(...n){n=G0(n);let e="THREE."+n.shift();if(wo)wo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=G0(n);let e="THREE."+n.shift();if(wo)wo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function _a(...n){let e=n.join(" ");e in Fg||(Fg[e]=!0,Ze(...n))}function W0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var X0={[ac]:ac,[cc]:dc,[hc]:hc,[Mo]:uc,[lc]:lc,[dc]:cc,[fc]:fc,[uc]:Mo},Vi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Bg=1234567,xa=Math.PI/180,Eo=180/Math.PI;function Bo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function gt(n,e,t){return Math.max(e,Math.min(t,n))}function pf(n,e){return(n%e+e)%e}function jb(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function Qb(n,e,t){return n!==e?(t-n)/(e-n):0}function ya(n,e,t){return(1-t)*n+t*e}function eM(n,e,t,i){return ya(n,e,1-Math.exp(-t*i))}function tM(n,e=1){return e-Math.abs(pf(n,e*2)-e)}function nM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function iM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function sM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function rM(n,e){return n+Math.random()*(e-n)}function oM(n){return n*(.5-Math.random())}function aM(n){n!==void 0&&(Bg=n);let e=Bg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function lM(n){return n*xa}function cM(n){return n*Eo}function hM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function uM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function mf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function dM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),h=o((e+i)/2),u=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),g=o((i-e)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*f,a*h,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function gf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function q0(n,e){if(e.constructor===Float32Array)return n;let t=gf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function $0(n,e){if(e.constructor===Float32Array)return n;let t=gf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var _f={DEG2RAD:xa,RAD2DEG:Eo,generateUUID:Bo,clamp:gt,euclideanModulo:pf,mapLinear:jb,inverseLerp:Qb,lerp:ya,damp:eM,pingpong:tM,smoothstep:nM,smootherstep:iM,randInt:sM,randFloat:rM,randFloatSpread:oM,seededRandom:aM,degToRad:lM,radToDeg:cM,isPowerOfTwo:hM,ceilPowerOfTwo:uM,floorPowerOfTwo:mf,setQuaternionFromProperEuler:dM,normalize:$0,denormalize:q0},tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},gi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],_=r[o+3];if(u!==_||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*_;p<0&&(d=-d,f=-f,g=-g,_=-_,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),A=Math.sin(v);m=Math.sin(m*v)/A,a=Math.sin(a*v)/A,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+_*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+_*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(kg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(kg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),h=2*(a*t-r*s),u=2*(r*i-o*t);return this.x=t+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return fd.copy(this).projectOnVector(e),this.sub(fd)}reflect(e){return this.sub(fd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},fd=new Z,kg=new gi,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],g=i[8],_=s[0],p=s[3],m=s[6],v=s[1],A=s[4],M=s[7],R=s[2],C=s[5],x=s[8];return r[0]=o*_+a*v+l*R,r[3]=o*p+a*A+l*C,r[6]=o*m+a*M+l*x,r[1]=c*_+h*v+u*R,r[4]=c*p+h*A+u*C,r[7]=c*m+h*M+u*x,r[2]=d*_+f*v+g*R,r[5]=d*p+f*A+g*C,r[8]=d*m+f*M+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return e[0]=u*_,e[1]=(s*c-h*i)*_,e[2]=(a*i-s*o)*_,e[3]=d*_,e[4]=(h*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return _a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(pd.makeScale(e,t)),this}rotate(e){return _a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(pd.makeRotation(-e)),this}translate(e,t){return _a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(pd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},pd=new nt,zg=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Vg=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function fM(){let n={enabled:!0,workingColorSpace:ba,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Lt&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(s.r=bo(s.r),s.g=bo(s.g),s.b=bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Is?Ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ba]:{primaries:e,whitePoint:i,transfer:Ma,toXYZ:zg,fromXYZ:Vg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Dn},outputColorSpaceConfig:{drawingBufferColorSpace:Dn}},[Dn]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:zg,fromXYZ:Vg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Dn}}}),n}var bt=fM();function ws(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function bo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ao,_c=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ao===void 0&&(ao=Sa("canvas")),ao.width=e.width,ao.height=e.height;let s=ao.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=ao}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Sa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ws(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ws(t[i]/255)*255):t[i]=ws(t[i]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},pM=0,To=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:pM++}),this.uuid=Bo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(md(s[o].image)):r.push(md(s[o]))}else r=md(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function md(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?_c.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var mM=0,gd=new Z,ti=class n extends Vi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ss,s=ss,r=Jn,o=Rs,a=vi,l=si,c=n.DEFAULT_ANISOTROPY,h=Is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:mM++}),this.uuid=Bo(),this.name="",this.source=new To(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new tt(0,0),this.repeat=new tt(1,1),this.center=new tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(gd).x}get height(){return this.source.getSize(gd).y}get depth(){return this.source.getSize(gd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ef)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case pc:e.x=e.x-Math.floor(e.x);break;case ss:e.x=e.x<0?0:1;break;case mc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case pc:e.y=e.y-Math.floor(e.y);break;case ss:e.y=e.y<0?0:1;break;case mc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=ef;ti.DEFAULT_ANISOTROPY=1;var Jt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],_=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,M=(f+1)/2,R=(m+1)/2,C=(h+d)/4,x=(u+_)/4,S=(g+p)/4;return A>M&&A>R?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=C/i,r=x/i):M>R?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=C/s,r=S/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=x/r,s=S/r),this.set(i,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(u-_)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},xc=class extends Vi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ti({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new To(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends xc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},wa=class extends ti{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var yc=class extends ti{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=yn,this.minFilter=yn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Yt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,h,u,d,f,g,_,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,h,u,d,f,g,_,p)}set(e,t,i,s,r,o,a,l,c,h,u,d,f,g,_,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=_,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/lo.setFromMatrixColumn(e,0).length(),r=1/lo.setFromMatrixColumn(e,1).length(),o=1/lo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,_=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,_=c*u;t[0]=d+_*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=_+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,_=c*u;t[0]=d-_*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=_-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,_=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+_,t[1]=l*u,t[5]=_*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,_=a*c;t[0]=l*h,t[4]=_-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-_*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,_=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+_,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=_*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(gM,e,_M)}lookAt(e,t,i){let s=this.elements;return fi.subVectors(e,t),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),Ws.crossVectors(i,fi),Ws.lengthSq()===0&&(Math.abs(i.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),Ws.crossVectors(i,fi)),Ws.normalize(),Fl.crossVectors(fi,Ws),s[0]=Ws.x,s[4]=Fl.x,s[8]=fi.x,s[1]=Ws.y,s[5]=Fl.y,s[9]=fi.y,s[2]=Ws.z,s[6]=Fl.z,s[10]=fi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],g=i[2],_=i[6],p=i[10],m=i[14],v=i[3],A=i[7],M=i[11],R=i[15],C=s[0],x=s[4],S=s[8],k=s[12],U=s[1],D=s[5],G=s[9],X=s[13],I=s[2],V=s[6],H=s[10],B=s[14],le=s[3],Y=s[7],j=s[11],te=s[15];return r[0]=o*C+a*U+l*I+c*le,r[4]=o*x+a*D+l*V+c*Y,r[8]=o*S+a*G+l*H+c*j,r[12]=o*k+a*X+l*B+c*te,r[1]=h*C+u*U+d*I+f*le,r[5]=h*x+u*D+d*V+f*Y,r[9]=h*S+u*G+d*H+f*j,r[13]=h*k+u*X+d*B+f*te,r[2]=g*C+_*U+p*I+m*le,r[6]=g*x+_*D+p*V+m*Y,r[10]=g*S+_*G+p*H+m*j,r[14]=g*k+_*X+p*B+m*te,r[3]=v*C+A*U+M*I+R*le,r[7]=v*x+A*D+M*V+R*Y,r[11]=v*S+A*G+M*H+R*j,r[15]=v*k+A*X+M*B+R*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],_=e[7],p=e[11],m=e[15],v=l*f-c*d,A=a*f-c*u,M=a*d-l*u,R=o*f-c*h,C=o*d-l*h,x=o*u-a*h;return t*(_*v-p*A+m*M)-i*(g*v-p*R+m*C)+s*(g*A-_*R+m*x)-r*(g*M-_*C+p*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],_=e[13],p=e[14],m=e[15],v=t*a-i*o,A=t*l-s*o,M=t*c-r*o,R=i*l-s*a,C=i*c-r*a,x=s*c-r*l,S=h*_-u*g,k=h*p-d*g,U=h*m-f*g,D=u*p-d*_,G=u*m-f*_,X=d*m-f*p,I=v*X-A*G+M*D+R*U-C*k+x*S;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return e[0]=(a*X-l*G+c*D)*V,e[1]=(s*G-i*X-r*D)*V,e[2]=(_*x-p*C+m*R)*V,e[3]=(d*C-u*x-f*R)*V,e[4]=(l*U-o*X-c*k)*V,e[5]=(t*X-s*U+r*k)*V,e[6]=(p*M-g*x-m*A)*V,e[7]=(h*x-d*M+f*A)*V,e[8]=(o*G-a*U+c*S)*V,e[9]=(i*U-t*G-r*S)*V,e[10]=(g*C-_*M+m*v)*V,e[11]=(u*M-h*C-f*v)*V,e[12]=(a*k-o*D-l*S)*V,e[13]=(t*D-i*k+s*S)*V,e[14]=(_*A-g*R-p*v)*V,e[15]=(h*R-u*A+d*v)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,_=o*h,p=o*u,m=a*u,v=l*c,A=l*h,M=l*u,R=i.x,C=i.y,x=i.z;return s[0]=(1-(_+m))*R,s[1]=(f+M)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(f-M)*C,s[5]=(1-(d+m))*C,s[6]=(p+v)*C,s[7]=0,s[8]=(g+A)*x,s[9]=(p-v)*x,s[10]=(1-(d+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=lo.set(s[0],s[1],s[2]).length(),a=lo.set(s[4],s[5],s[6]).length(),l=lo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let c=1/o,h=1/a,u=1/l;return Bi.elements[0]*=c,Bi.elements[1]*=c,Bi.elements[2]*=c,Bi.elements[4]*=h,Bi.elements[5]*=h,Bi.elements[6]*=h,Bi.elements[8]*=u,Bi.elements[9]*=u,Bi.elements[10]*=u,t.setFromRotationMatrix(Bi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Pi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===Pi)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===So)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Pi,l=!1){let c=this.elements,h=2/(t-e),u=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===Pi)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===So)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},lo=new Z,Bi=new Yt,gM=new Z(0,0,0),_M=new Z(1,1,1),Ws=new Z,Fl=new Z,fi=new Z,Hg=new Yt,Gg=new gi,Ts=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(gt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Hg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Hg,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Gg.setFromEuler(this),this.setFromQuaternion(Gg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ts.DEFAULT_ORDER="XYZ";var Ea=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},xM=0,Wg=new Z,co=new gi,xs=new Yt,Bl=new Z,da=new Z,yM=new Z,vM=new gi,Xg=new Z(1,0,0),qg=new Z(0,1,0),$g=new Z(0,0,1),Yg={type:"added"},bM={type:"removed"},ho={type:"childadded",child:null},_d={type:"childremoved",child:null},Vn=class n extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xM++}),this.uuid=Bo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Z,t=new Ts,i=new gi,s=new Z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Yt},normalMatrix:{value:new nt}}),this.matrix=new Yt,this.matrixWorld=new Yt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ea,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return co.setFromAxisAngle(e,t),this.quaternion.multiply(co),this}rotateOnWorldAxis(e,t){return co.setFromAxisAngle(e,t),this.quaternion.premultiply(co),this}rotateX(e){return this.rotateOnAxis(Xg,e)}rotateY(e){return this.rotateOnAxis(qg,e)}rotateZ(e){return this.rotateOnAxis($g,e)}translateOnAxis(e,t){return Wg.copy(e).applyQuaternion(this.quaternion),this.position.add(Wg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Xg,e)}translateY(e){return this.translateOnAxis(qg,e)}translateZ(e){return this.translateOnAxis($g,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Bl.copy(e):Bl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),da.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xs.lookAt(da,Bl,this.up):xs.lookAt(Bl,da,this.up),this.quaternion.setFromRotationMatrix(xs),s&&(xs.extractRotation(s.matrixWorld),co.setFromRotationMatrix(xs),this.quaternion.premultiply(co.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Yg),ho.child=e,this.dispatchEvent(ho),ho.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(bM),_d.child=e,this.dispatchEvent(_d),_d.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xs.multiply(e.parent.matrixWorld)),e.applyMatrix4(xs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Yg),ho.child=e,this.dispatchEvent(ho),ho.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(da,e,yM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(da,vM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new Z(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ss=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},MM={type:"move"},Ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ss,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ss,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ss,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let p=t.getJointPose(_,i),m=this._getHandJoint(c,_);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(MM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ss;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Y0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xs={h:0,s:0,l:0},kl={h:0,s:0,l:0};function xd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ct=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Dn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=i,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=bt.workingColorSpace){if(e=pf(e,1),t=gt(t,0,1),i=gt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=xd(o,r,e+1/3),this.g=xd(o,r,e),this.b=xd(o,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=Dn){function i(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Dn){let i=Y0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ws(e.r),this.g=ws(e.g),this.b=ws(e.b),this}copyLinearToSRGB(e){return this.r=bo(e.r),this.g=bo(e.g),this.b=bo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Dn){return bt.workingToColorSpace(kn.copy(this),e),Math.round(gt(kn.r*255,0,255))*65536+Math.round(gt(kn.g*255,0,255))*256+Math.round(gt(kn.b*255,0,255))}getHexString(e=Dn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(kn.copy(this),t);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=Dn){bt.workingToColorSpace(kn.copy(this),e);let t=kn.r,i=kn.g,s=kn.b;return e!==Dn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Xs),this.setHSL(Xs.h+e,Xs.s+t,Xs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Xs),e.getHSL(kl);let i=ya(Xs.h,kl.h,t),s=ya(Xs.s,kl.s,t),r=ya(Xs.l,kl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new ct;ct.NAMES=Y0;var Ta=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ts,this.environmentIntensity=1,this.environmentRotation=new Ts,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ki=new Z,ys=new Z,yd=new Z,vs=new Z,uo=new Z,fo=new Z,Zg=new Z,vd=new Z,bd=new Z,Md=new Z,Sd=new Jt,wd=new Jt,Ed=new Jt,Zs=class n{constructor(e=new Z,t=new Z,i=new Z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ki.subVectors(e,t),s.cross(ki);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ki.subVectors(s,t),ys.subVectors(i,t),yd.subVectors(e,t);let o=ki.dot(ki),a=ki.dot(ys),l=ki.dot(yd),c=ys.dot(ys),h=ys.dot(yd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(o,vs.y),l.addScaledVector(a,vs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Sd.setScalar(0),wd.setScalar(0),Ed.setScalar(0),Sd.fromBufferAttribute(e,t),wd.fromBufferAttribute(e,i),Ed.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Sd,r.x),o.addScaledVector(wd,r.y),o.addScaledVector(Ed,r.z),o}static isFrontFacing(e,t,i,s){return ki.subVectors(i,t),ys.subVectors(e,t),ki.cross(ys).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ki.subVectors(this.c,this.b),ys.subVectors(this.a,this.b),ki.cross(ys).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;uo.subVectors(s,i),fo.subVectors(r,i),vd.subVectors(e,i);let l=uo.dot(vd),c=fo.dot(vd);if(l<=0&&c<=0)return t.copy(i);bd.subVectors(e,s);let h=uo.dot(bd),u=fo.dot(bd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(uo,o);Md.subVectors(e,r);let f=uo.dot(Md),g=fo.dot(Md);if(g>=0&&f<=g)return t.copy(r);let _=f*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(fo,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return Zg.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(Zg,a);let m=1/(p+_+d);return o=_*m,a=d*m,t.copy(i).addScaledVector(uo,o).addScaledVector(fo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ks=class{constructor(e=new Z(1/0,1/0,1/0),t=new Z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,zi):zi.fromBufferAttribute(r,o),zi.applyMatrix4(e.matrixWorld),this.expandByPoint(zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),zl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),zl.copy(i.boundingBox)),zl.applyMatrix4(e.matrixWorld),this.union(zl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,zi),zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(fa),Vl.subVectors(this.max,fa),po.subVectors(e.a,fa),mo.subVectors(e.b,fa),go.subVectors(e.c,fa),qs.subVectors(mo,po),$s.subVectors(go,mo),xr.subVectors(po,go);let t=[0,-qs.z,qs.y,0,-$s.z,$s.y,0,-xr.z,xr.y,qs.z,0,-qs.x,$s.z,0,-$s.x,xr.z,0,-xr.x,-qs.y,qs.x,0,-$s.y,$s.x,0,-xr.y,xr.x,0];return!Td(t,po,mo,go,Vl)||(t=[1,0,0,0,1,0,0,0,1],!Td(t,po,mo,go,Vl))?!1:(Hl.crossVectors(qs,$s),t=[Hl.x,Hl.y,Hl.z],Td(t,po,mo,go,Vl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new Z,new Z,new Z,new Z,new Z,new Z,new Z,new Z],zi=new Z,zl=new Ks,po=new Z,mo=new Z,go=new Z,qs=new Z,$s=new Z,xr=new Z,fa=new Z,Vl=new Z,Hl=new Z,yr=new Z;function Td(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){yr.fromArray(n,r);let a=s.x*Math.abs(yr.x)+s.y*Math.abs(yr.y)+s.z*Math.abs(yr.z),l=e.dot(yr),c=t.dot(yr),h=i.dot(yr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var xn=new Z,Gl=new tt,SM=0,zn=class extends Vi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:SM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=V0,this.updateRanges=[],this.gpuType=Gi,this.version=0,this._normalizationScale=e!==void 0?gf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Gl.fromBufferAttribute(this,t),Gl.applyMatrix3(e),this.setXY(t,Gl.x,Gl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):q0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):$0(e,this.array)}};var Aa=class extends zn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ca=class extends zn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mi=class extends zn{constructor(e,t,i){super(new Float32Array(e),t,i)}},wM=new Ks,pa=new Z,Ad=new Z,Mr=class{constructor(e=new Z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):wM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;pa.subVectors(e,this.center);let t=pa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(pa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ad.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(pa.copy(e.center).add(Ad)),this.expandByPoint(pa.copy(e.center).sub(Ad))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},EM=0,Ri=new Yt,Cd=new Vn,_o=new Z,pi=new Ks,ma=new Ks,Ln=new Z,xi=class n extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:EM++}),this.uuid=Bo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Kb(e)?Ca:Aa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ri.makeRotationFromQuaternion(e),this.applyMatrix4(Ri),this}rotateX(e){return Ri.makeRotationX(e),this.applyMatrix4(Ri),this}rotateY(e){return Ri.makeRotationY(e),this.applyMatrix4(Ri),this}rotateZ(e){return Ri.makeRotationZ(e),this.applyMatrix4(Ri),this}translate(e,t,i){return Ri.makeTranslation(e,t,i),this.applyMatrix4(Ri),this}scale(e,t,i){return Ri.makeScale(e,t,i),this.applyMatrix4(Ri),this}lookAt(e){return Cd.lookAt(e),Cd.updateMatrix(),this.applyMatrix4(Cd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_o).negate(),this.translate(_o.x,_o.y,_o.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mi(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ks);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Z(-1/0,-1/0,-1/0),new Z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Mr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Z,1/0);return}if(e){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ma.setFromBufferAttribute(a),this.morphTargetsRelative?(Ln.addVectors(pi.min,ma.min),pi.expandByPoint(Ln),Ln.addVectors(pi.max,ma.max),pi.expandByPoint(Ln)):(pi.expandByPoint(ma.min),pi.expandByPoint(ma.max))}pi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Ln.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Ln));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Ln.fromBufferAttribute(a,c),l&&(_o.fromBufferAttribute(e,c),Ln.add(_o)),s=Math.max(s,i.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new zn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new Z,l[k]=new Z;let h=new Z,u=new Z,d=new Z,f=new tt,g=new tt,_=new tt,p=new Z,m=new Z;function v(k,U,D){c[k]=c[U]=c[D]=1,h.fromBufferAttribute(i,k),u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,k),g.fromBufferAttribute(r,U),_.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(f),_.sub(f);let G=1/(g.x*_.y-_.x*g.y);isFinite(G)&&(p.copy(u).multiplyScalar(_.y).addScaledVector(d,-g.y).multiplyScalar(G),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-_.x).multiplyScalar(G),a[k].add(p),a[U].add(p),a[D].add(p),l[k].add(m),l[U].add(m),l[D].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let k=0,U=A.length;k<U;++k){let D=A[k],G=D.start,X=D.count;for(let I=G,V=G+X;I<V;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let M=new Z,R=new Z,C=new Z,x=new Z;function S(k){C.fromBufferAttribute(s,k),x.copy(C);let U=a[k];M.copy(U),M.sub(C.multiplyScalar(C.dot(U))).normalize(),R.crossVectors(x,U);let G=R.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,G)}for(let k=0,U=i.count;k<U;++k)c[k]&&S(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new zn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new Z,r=new Z,o=new Z,a=new Z,l=new Z,c=new Z,h=new Z,u=new Z;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),_=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,p),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Ln.fromBufferAttribute(e,t),Ln.normalize(),e.setXYZ(t,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let _=0,p=l.length;_<p;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new zn(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Rd=new Z,TM=new Z,AM=new nt,Zn=class{constructor(e=new Z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Rd.subVectors(i,t).cross(TM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Rd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||AM.getNormalMatrix(e),s=this.coplanarPoint(Rd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},CM=0,As=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:CM++}),this.uuid=Bo(),this.name="",this.type="Material",this.blending=Uo,this.side=ir,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xd,this.blendDst=qd,this.blendEquation=Ar,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=Mo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=U0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=oc,this.stencilZFail=oc,this.stencilZPass=oc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ct().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Zn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new tt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ms=new Z,Pd=new Z,Wl=new Z,Xl=new Z,Sr=class{constructor(e=new Z,t=new Z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ms)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ms.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ms.copy(this.origin).addScaledVector(this.direction,t),Ms.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Pd.copy(e).add(t).multiplyScalar(.5),Wl.copy(t).sub(e).normalize(),Xl.copy(this.origin).sub(Pd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Wl),a=Xl.dot(this.direction),l=-Xl.dot(Wl),c=Xl.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let _=1/h;u*=_,d*=_,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Pd).addScaledVector(Wl,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ms.subVectors(e.center,this.origin);let i=Ms.dot(this.direction),s=Ms.dot(Ms)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Ms)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,_=t.y-o.y,p=t.z-o.z,m=i.x-o.x,v=i.y-o.y,A=i.z-o.z,M=Math.abs(l),R=Math.abs(c),C=Math.abs(h),x,S,k,U,D,G,X,I,V,H,B,le;if(M>=R&&M>=C?(k=l,G=u,V=g,le=m,l>=0?(x=c,S=h,U=d,D=f,X=_,I=p,H=v,B=A):(x=h,S=c,U=f,D=d,X=p,I=_,H=A,B=v)):R>=C?(k=c,G=d,V=_,le=v,c>=0?(x=h,S=l,U=f,D=u,X=p,I=g,H=A,B=m):(x=l,S=h,U=u,D=f,X=g,I=p,H=m,B=A)):(k=h,G=f,V=p,le=A,h>=0?(x=l,S=c,U=u,D=d,X=g,I=_,H=m,B=v):(x=c,S=l,U=d,D=u,X=_,I=g,H=v,B=m)),k===0)return null;let Y=x/k,j=S/k,te=1/k,ue=U-Y*G,fe=D-j*G,ee=X-Y*V,pe=I-j*V,_e=H-Y*le,Re=B-j*le,we=_e*pe-Re*ee,Xe=ue*Re-fe*_e,rt=ee*fe-pe*ue;if(s){if(we<0||Xe<0||rt<0)return null}else if((we<0||Xe<0||rt<0)&&(we>0||Xe>0||rt>0))return null;let Ge=we+Xe+rt;if(Ge===0)return null;let ft=te*(we*G+Xe*V+rt*le);return(Ge>0?ft<0:ft>0)?null:this.at(ft/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},wr=class extends As{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ts,this.combine=kc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Kg=new Yt,vr=new Sr,ql=new Mr,Jg=new Z,$l=new Z,Yl=new Z,Zl=new Z,Id=new Z,Kl=new Z,jg=new Z,Jl=new Z,ni=class extends Vn{constructor(e=new xi,t=new wr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Kl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Id.fromBufferAttribute(u,e),o?Kl.addScaledVector(Id,h):Kl.addScaledVector(Id.sub(t),h))}t.add(Kl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ql.copy(i.boundingSphere),ql.applyMatrix4(r),vr.copy(e.ray).recast(e.near),!(ql.containsPoint(vr.origin)===!1&&(vr.intersectSphere(ql,Jg)===null||vr.origin.distanceToSquared(Jg)>(e.far-e.near)**2))&&(Kg.copy(r).invert(),vr.copy(e.ray).applyMatrix4(Kg),!(i.boundingBox!==null&&vr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,vr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=d.length;g<_;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),A=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let M=v,R=A;M<R;M+=3){let C=a.getX(M),x=a.getX(M+1),S=a.getX(M+2);s=jl(this,m,e,i,c,h,u,C,x,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let p=g,m=_;p<m;p+=3){let v=a.getX(p),A=a.getX(p+1),M=a.getX(p+2);s=jl(this,o,e,i,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=d.length;g<_;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),A=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let M=v,R=A;M<R;M+=3){let C=M,x=M+1,S=M+2;s=jl(this,m,e,i,c,h,u,C,x,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let p=g,m=_;p<m;p+=3){let v=p,A=p+1,M=p+2;s=jl(this,o,e,i,c,h,u,v,A,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function RM(n,e,t,i,s,r,o,a){let l;if(e.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ir,a),l===null)return null;Jl.copy(a),Jl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Jl);return c<t.near||c>t.far?null:{distance:c,point:Jl.clone(),object:n}}function jl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,$l),n.getVertexPosition(l,Yl),n.getVertexPosition(c,Zl);let h=RM(n,e,t,i,$l,Yl,Zl,jg);if(h){let u=new Z;Zs.getBarycoord(jg,$l,Yl,Zl,u),s&&(h.uv=Zs.getInterpolatedAttribute(s,a,l,c,u,new tt)),r&&(h.uv1=Zs.getInterpolatedAttribute(r,a,l,c,u,new tt)),o&&(h.normal=Zs.getInterpolatedAttribute(o,a,l,c,u,new Z),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new Z,materialIndex:0};Zs.getNormal($l,Yl,Zl,d.normal),h.face=d,h.barycoord=u}return h}var Co=class extends ti{constructor(e=null,t=1,i=1,s,r,o,a,l,c=yn,h=yn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var br=new Mr,PM=new tt(.5,.5),Ql=new Z,Js=class{constructor(e=new Zn,t=new Zn,i=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Pi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],_=r[9],p=r[10],m=r[11],v=r[12],A=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-v).normalize(),s[1].setComponents(c+o,f+h,m+g,R+v).normalize(),s[2].setComponents(c+a,f+u,m+_,R+A).normalize(),s[3].setComponents(c-a,f-u,m-_,R-A).normalize(),i)s[4].setComponents(l,d,p,M).normalize(),s[5].setComponents(c-l,f-d,m-p,R-M).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-M).normalize(),t===Pi)s[5].setComponents(c+l,f+d,m+p,R+M).normalize();else if(t===So)s[5].setComponents(l,d,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),br.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),br.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(br)}intersectsSprite(e){br.center.set(0,0,0);let t=PM.distanceTo(e.center);return br.radius=.7071067811865476+t,br.applyMatrix4(e.matrixWorld),this.intersectsSphere(br)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Ql.x=s.normal.x>0?e.max.x:e.min.x,Ql.y=s.normal.y>0?e.max.y:e.min.y,Ql.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ql)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Qg=new Yt,vc=class n{constructor(){this.coordinateSystem=Pi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Qg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Js),i[s].setFromProjectionMatrix(Qg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Js),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Ro=class extends As{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},bc=new Z,Mc=new Z,e0=new Yt,ga=new Sr,ec=new Mr,Ld=new Z,t0=new Z,Sc=class extends Vn{constructor(e=new xi,t=new Ro){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)bc.fromBufferAttribute(t,s-1),Mc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=bc.distanceTo(Mc);e.setAttribute("lineDistance",new mi(i,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ec.copy(i.boundingSphere),ec.applyMatrix4(s),ec.radius+=r,e.ray.intersectsSphere(ec)===!1)return;e0.copy(s).invert(),ga.copy(e.ray).applyMatrix4(e0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let _=f,p=g-1;_<p;_+=c){let m=h.getX(_),v=h.getX(_+1),A=tc(this,e,ga,l,m,v,_);A&&t.push(A)}if(this.isLineLoop){let _=h.getX(g-1),p=h.getX(f),m=tc(this,e,ga,l,_,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let _=f,p=g-1;_<p;_+=c){let m=tc(this,e,ga,l,_,_+1,_);m&&t.push(m)}if(this.isLineLoop){let _=tc(this,e,ga,l,g-1,f,g-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function tc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(bc.fromBufferAttribute(a,s),Mc.fromBufferAttribute(a,r),t.distanceSqToSegment(bc,Mc,Ld,t0)>i)return;Ld.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ld);if(!(c<e.near||c>e.far))return{distance:c,point:t0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ra=class extends Sc{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var Pa=class extends ti{constructor(e=[],t=Cr,i,s,r,o,a,l,c,h){super(e,t,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Cs=class extends ti{constructor(e,t,i=Hi,s,r,o,a=yn,l=yn,c,h=Es,u=1){if(h!==Es&&h!==Ps)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new To(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ia=class extends Cs{constructor(e,t=Hi,i=Cr,s,r,o=yn,a=yn,l,c=Es){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},La=class extends ti{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Po=class n extends xi{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new mi(c,3)),this.setAttribute("normal",new mi(h,3)),this.setAttribute("uv",new mi(u,2));function g(_,p,m,v,A,M,R,C,x,S,k){let U=M/x,D=R/S,G=M/2,X=R/2,I=C/2,V=x+1,H=S+1,B=0,le=0,Y=new Z;for(let j=0;j<H;j++){let te=j*D-X;for(let ue=0;ue<V;ue++){let fe=ue*U-G;Y[_]=fe*v,Y[p]=te*A,Y[m]=I,c.push(Y.x,Y.y,Y.z),Y[_]=0,Y[p]=0,Y[m]=C>0?1:-1,h.push(Y.x,Y.y,Y.z),u.push(ue/x),u.push(1-j/S),B+=1}}for(let j=0;j<S;j++)for(let te=0;te<x;te++){let ue=d+te+V*j,fe=d+te+V*(j+1),ee=d+(te+1)+V*(j+1),pe=d+(te+1)+V*j;l.push(ue,fe,pe),l.push(fe,ee,pe),le+=6}a.addGroup(f,le,k),f+=le,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Er=class n extends xi{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],_=[],p=[];for(let m=0;m<h;m++){let v=m*d-o;for(let A=0;A<c;A++){let M=A*u-r;g.push(M,-v,0),_.push(0,0,1),p.push(A/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let A=v+c*m,M=v+c*(m+1),R=v+1+c*(m+1),C=v+1+c*m;f.push(A,M,C),f.push(M,R,C)}this.setIndex(f),this.setAttribute("position",new mi(g,3)),this.setAttribute("normal",new mi(_,3)),this.setAttribute("uv",new mi(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function Pr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(n0(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(n0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Hn(n){let e={};for(let t=0;t<n.length;t++){let i=Pr(n[t]);for(let s in i)e[s]=i[s]}return e}function n0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function IM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function xf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var Z0={clone:Pr,merge:Hn},LM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,DM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,rs=class extends As{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=LM,this.fragmentShader=DM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Pr(e.uniforms),this.uniformsGroups=IM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ct().setHex(s.value);break;case"v2":this.uniforms[i].value=new tt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Jt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Yt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},wc=class extends rs{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Io=class extends As{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Eh,this.normalScale=new tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ts,this.combine=kc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ec=class extends As{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=D0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Tc=class extends As{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function xo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function nc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var js=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ac=class extends js{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ud,endingEnd:Ud}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Od:r=e,a=2*t-i;break;case Fd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Od:o=e,l=2*i-t;break;case Fd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-t)/(s-t),_=g*g,p=_*g,m=-d*p+2*d*_-d*g,v=(1+d)*p+(-1.5-2*d)*_+(-.5+d)*g+1,A=(-1-f)*p+(1.5+f)*_+.5*g,M=f*p-f*_;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+v*o[c+R]+A*o[l+R]+M*o[u+R];return r}},Cc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Rc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Pc=class extends js{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-t)/(s-t),_=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*_+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let _=o[c+g],p=o[l+g],m=f*d+g*2,v=u[m],A=u[m+1],M=e*d+g*2,R=h[M],C=h[M+1],x=UM(i,t,v,R,s);r[g]=K0(x,_,A,C,p)}return r}};function K0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function NM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function UM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=K0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=NM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var yi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=xo(t,this.TimeBufferType),this.values=xo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:xo(e.times,Array),values:xo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),nc(e.settings)&&(i.settings={inTangents:xo(e.settings.inTangents,Array),outTangents:xo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Rc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Cc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ac(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Pc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case va:t=this.InterpolantFactoryMethodDiscrete;break;case gc:t=this.InterpolantFactoryMethodLinear;break;case rc:t=this.InterpolantFactoryMethodSmooth;break;case Nd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ze("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return va;case this.InterpolantFactoryMethodLinear:return gc;case this.InterpolantFactoryMethodSmooth:return rc;case this.InterpolantFactoryMethodBezier:return Nd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;nc(this.settings)&&(i0(this.settings.inTangents,e),i0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;nc(this.settings)&&(s0(this.settings.inTangents,e),s0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Jb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===rc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let g=0;g!==i;++g){let _=t[u+g];if(_!==t[d+g]||_!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,nc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function i0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function s0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=gc;var Qs=class extends yi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="bool";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=va;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ic=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Ic.prototype.ValueTypeName="color";var Lc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Lc.prototype.ValueTypeName="number";var Dc=class extends js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)gi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Dc(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var er=class extends yi{constructor(e,t,i){super(e,t,i)}};er.prototype.ValueTypeName="string";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=va;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var Nc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Nc.prototype.ValueTypeName="vector";var Uc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},J0=new Uc,Oc=class{constructor(e){this.manager=e!==void 0?e:J0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Oc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Na=class extends Vn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Dd=new Yt,r0=new Z,o0=new Z,Fc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new tt(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Yt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Js,this._frameExtents=new tt(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;r0.setFromMatrixPosition(e.matrixWorld),t.position.copy(r0),o0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(o0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Dd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Dd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===So||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Dd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ic=new Z,sc=new gi,is=new Z,Ua=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Yt,this.projectionMatrix=new Yt,this.projectionMatrixInverse=new Yt,this.coordinateSystem=Pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ic,sc,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ic,sc,is.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(ic,sc,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ic,sc,is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ys=new Z,a0=new tt,l0=new tt,Kn=class extends Ua{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Eo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(xa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Eo*2*Math.atan(Math.tan(xa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ys.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ys.x,Ys.y).multiplyScalar(-e/Ys.z),Ys.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ys.x,Ys.y).multiplyScalar(-e/Ys.z)}getViewSize(e,t){return this.getViewBounds(e,a0,l0),t.subVectors(l0,a0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(xa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Oa=class extends Ua{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Bd=class extends Fc{constructor(){super(new Oa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Na{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Bd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ba=class extends Na{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var yo=-90,vo=1,Lo=class extends Vn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(yo,vo,e,t);s.layers=this.layers,this.add(s);let r=new Kn(yo,vo,e,t);r.layers=this.layers,this.add(r);let o=new Kn(yo,vo,e,t);o.layers=this.layers,this.add(o);let a=new Kn(yo,vo,e,t);a.layers=this.layers,this.add(a);let l=new Kn(yo,vo,e,t);l.layers=this.layers,this.add(l);let c=new Kn(yo,vo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Pi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===So)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Bc=class extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var yf="\\[\\]\\.:\\/",OM=new RegExp("["+yf+"]","g"),vf="[^"+yf+"]",FM="[^"+yf.replace("\\.","")+"]",BM=/((?:WC+[\/:])*)/.source.replace("WC",vf),kM=/(WCOD+)?/.source.replace("WCOD",FM),zM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",vf),VM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",vf),HM=new RegExp("^"+BM+kM+zM+VM+"$"),GM=["material","materials","bones","map"],kd=class{constructor(e,t,i){let s=i||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},$t=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(OM,"")}static parseTrackName(e){let t=HM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);GM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=kd;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var G2=new Float32Array(1);var Do=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=gt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(gt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var zd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ka=class extends Vi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function bf(n,e,t,i){let s=WM(i);switch(t){case of:return n*e;case lf:return n*e/s.components*s.byteLength;case qc:return n*e/s.components*s.byteLength;case sr:return n*e*2/s.components*s.byteLength;case $c:return n*e*2/s.components*s.byteLength;case af:return n*e*3/s.components*s.byteLength;case vi:return n*e*4/s.components*s.byteLength;case Yc:return n*e*4/s.components*s.byteLength;case Ha:case Ga:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Wa:case Xa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Kc:case jc:return Math.max(n,16)*Math.max(e,8)/4;case Zc:case Jc:return Math.max(n,8)*Math.max(e,8)/2;case Qc:case eh:case nh:case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case th:case qa:case sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case oh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ah:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case lh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case mh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case gh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case xh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case yh:case vh:case bh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Mh:case Sh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case $a:case wh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function WM(n){switch(n){case si:case tf:return{byteLength:1,components:1};case Fo:case nf:case Wi:return{byteLength:2,components:1};case Wc:case Xc:return{byteLength:2,components:4};case Hi:case Gc:case Gi:return{byteLength:4,components:1};case sf:case rf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function y_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function qM(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],_=u[f];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++d,u[d]=_)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let _=u[f];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var $M=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,YM=`#ifdef USE_ALPHAHASH
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
#endif`,ZM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,KM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,JM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,jM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,QM=`#ifdef USE_AOMAP
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
#endif`,eS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,tS=`#ifdef USE_BATCHING
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
#endif`,nS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,iS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,sS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,rS=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,oS=`#ifdef USE_IRIDESCENCE
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
#endif`,aS=`#ifdef USE_BUMPMAP
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
#endif`,lS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,cS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,uS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,dS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,fS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,pS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,mS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,gS=`#define PI 3.141592653589793
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
} // validated`,_S=`vec3 transformedNormal = objectNormal;
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
#endif`,xS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,vS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,bS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,MS="gl_FragColor = linearToOutputTexel( gl_FragColor );",SS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,wS=`#ifdef USE_ENVMAP
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
#endif`,ES=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,TS=`#ifdef USE_ENVMAP
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
#endif`,AS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,CS=`#ifdef USE_ENVMAP
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
#endif`,RS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,PS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,IS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,LS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,DS=`#ifdef USE_GRADIENTMAP
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
}`,NS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,US=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,OS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,FS=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,BS=`#ifdef USE_ENVMAP
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
#endif`,kS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,zS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,VS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,HS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,GS=`PhysicalMaterial material;
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
#endif`,WS=`uniform sampler2D dfgLUT;
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
}`,XS=`
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
#endif`,qS=`#if defined( RE_IndirectDiffuse )
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
#endif`,$S=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,YS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ZS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,KS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,JS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,QS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ew=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,nw=`#if defined( USE_POINTS_UV )
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
#endif`,iw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,sw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,rw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,ow=`#if defined( USE_MORPHCOLORS )
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
#endif`,aw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lw=`#ifdef USE_MORPHTARGETS
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
#endif`,cw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,uw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,dw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,mw=`#ifdef USE_NORMALMAP
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
#endif`,gw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,_w=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,xw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,bw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Mw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Sw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ww=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Ew=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Tw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Aw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Cw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Rw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Pw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Iw=`float getShadowMask() {
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
}`,Lw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Dw=`#ifdef USE_SKINNING
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
#endif`,Nw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Uw=`#ifdef USE_SKINNING
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
#endif`,Ow=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Fw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Bw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,kw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,zw=`#ifdef USE_TRANSMISSION
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
#endif`,Vw=`#ifdef USE_TRANSMISSION
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
#endif`,Hw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Gw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ww=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Xw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,qw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,$w=`uniform sampler2D t2D;
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
}`,Yw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zw=`uniform float backgroundBlurriness;
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
}`,Kw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Jw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jw=`#include <common>
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
}`,Qw=`#if DEPTH_PACKING == 3200
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
}`,e1=`#define DISTANCE
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
}`,t1=`#define DISTANCE
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
}`,n1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,i1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,s1=`uniform float scale;
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
}`,r1=`uniform vec3 diffuse;
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
}`,o1=`#include <common>
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
}`,a1=`uniform vec3 diffuse;
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
}`,l1=`#define LAMBERT
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
}`,c1=`#define LAMBERT
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
}`,h1=`#define MATCAP
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
}`,u1=`#define MATCAP
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
}`,d1=`#define NORMAL
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
}`,f1=`#define NORMAL
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
}`,p1=`#define PHONG
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
}`,m1=`#define PHONG
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
}`,g1=`#define STANDARD
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
}`,_1=`#define STANDARD
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
}`,x1=`#define TOON
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
}`,y1=`#define TOON
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
}`,v1=`uniform float size;
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
}`,b1=`uniform vec3 diffuse;
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
}`,M1=`#include <common>
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
}`,S1=`uniform vec3 color;
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
}`,w1=`uniform float rotation;
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
}`,E1=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:$M,alphahash_pars_fragment:YM,alphamap_fragment:ZM,alphamap_pars_fragment:KM,alphatest_fragment:JM,alphatest_pars_fragment:jM,aomap_fragment:QM,aomap_pars_fragment:eS,batching_pars_vertex:tS,batching_vertex:nS,begin_vertex:iS,beginnormal_vertex:sS,bsdfs:rS,iridescence_fragment:oS,bumpmap_pars_fragment:aS,clipping_planes_fragment:lS,clipping_planes_pars_fragment:cS,clipping_planes_pars_vertex:hS,clipping_planes_vertex:uS,color_fragment:dS,color_pars_fragment:fS,color_pars_vertex:pS,color_vertex:mS,common:gS,defaultnormal_vertex:_S,displacementmap_pars_vertex:xS,displacementmap_vertex:yS,emissivemap_fragment:vS,emissivemap_pars_fragment:bS,colorspace_fragment:MS,colorspace_pars_fragment:SS,envmap_fragment:wS,envmap_common_pars_fragment:ES,envmap_pars_fragment:TS,envmap_pars_vertex:AS,envmap_physical_pars_fragment:BS,envmap_vertex:CS,fog_vertex:RS,fog_pars_vertex:PS,fog_fragment:IS,fog_pars_fragment:LS,gradientmap_pars_fragment:DS,lightmap_pars_fragment:NS,lights_lambert_fragment:US,lights_lambert_pars_fragment:OS,lights_pars_begin:FS,lights_toon_fragment:kS,lights_toon_pars_fragment:zS,lights_phong_fragment:VS,lights_phong_pars_fragment:HS,lights_physical_fragment:GS,lights_physical_pars_fragment:WS,lights_fragment_begin:XS,lights_fragment_maps:qS,lights_fragment_end:$S,lightprobes_pars_fragment:YS,logdepthbuf_fragment:ZS,logdepthbuf_pars_fragment:KS,logdepthbuf_pars_vertex:JS,logdepthbuf_vertex:jS,map_fragment:QS,map_pars_fragment:ew,map_particle_fragment:tw,map_particle_pars_fragment:nw,metalnessmap_fragment:iw,metalnessmap_pars_fragment:sw,morphinstance_vertex:rw,morphcolor_vertex:ow,morphnormal_vertex:aw,morphtarget_pars_vertex:lw,morphtarget_vertex:cw,normal_fragment_begin:hw,normal_fragment_maps:uw,normal_pars_fragment:dw,normal_pars_vertex:fw,normal_vertex:pw,normalmap_pars_fragment:mw,clearcoat_normal_fragment_begin:gw,clearcoat_normal_fragment_maps:_w,clearcoat_pars_fragment:xw,iridescence_pars_fragment:yw,opaque_fragment:vw,packing:bw,premultiplied_alpha_fragment:Mw,project_vertex:Sw,dithering_fragment:ww,dithering_pars_fragment:Ew,roughnessmap_fragment:Tw,roughnessmap_pars_fragment:Aw,shadowmap_pars_fragment:Cw,shadowmap_pars_vertex:Rw,shadowmap_vertex:Pw,shadowmask_pars_fragment:Iw,skinbase_vertex:Lw,skinning_pars_vertex:Dw,skinning_vertex:Nw,skinnormal_vertex:Uw,specularmap_fragment:Ow,specularmap_pars_fragment:Fw,tonemapping_fragment:Bw,tonemapping_pars_fragment:kw,transmission_fragment:zw,transmission_pars_fragment:Vw,uv_pars_fragment:Hw,uv_pars_vertex:Gw,uv_vertex:Ww,worldpos_vertex:Xw,background_vert:qw,background_frag:$w,backgroundCube_vert:Yw,backgroundCube_frag:Zw,cube_vert:Kw,cube_frag:Jw,depth_vert:jw,depth_frag:Qw,distance_vert:e1,distance_frag:t1,equirect_vert:n1,equirect_frag:i1,linedashed_vert:s1,linedashed_frag:r1,meshbasic_vert:o1,meshbasic_frag:a1,meshlambert_vert:l1,meshlambert_frag:c1,meshmatcap_vert:h1,meshmatcap_frag:u1,meshnormal_vert:d1,meshnormal_frag:f1,meshphong_vert:p1,meshphong_frag:m1,meshphysical_vert:g1,meshphysical_frag:_1,meshtoon_vert:x1,meshtoon_frag:y1,points_vert:v1,points_frag:b1,shadow_vert:M1,shadow_frag:S1,sprite_vert:w1,sprite_frag:E1},Ne={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},ls={basic:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},envMapIntensity:{value:1}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:Hn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:Hn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new ct(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:Hn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:Hn([Ne.points,Ne.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:Hn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:Hn([Ne.common,Ne.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:Hn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:Hn([Ne.sprite,Ne.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distance:{uniforms:Hn([Ne.common,Ne.displacementmap,{referencePosition:{value:new Z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distance_vert,fragmentShader:dt.distance_frag},shadow:{uniforms:Hn([Ne.lights,Ne.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};ls.physical={uniforms:Hn([ls.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var Th={r:0,b:0,g:0},T1=new Yt,v_=new nt;v_.set(-1,0,0,0,1,0,0,0,1);function A1(n,e,t,i,s,r){let o=new ct(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let M=v.backgroundBlurriness>0;A=e.get(A,M)}return A}function g(v){let A=!1,M=f(v);M===null?p(o,a):M&&M.isColor&&(p(M,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(v,A){let M=f(A);M&&M.isCubeTexture?(c===void 0&&(c=new ni(new Po(1,1,1),new rs({name:"BackgroundCubeMaterial",uniforms:Pr(ls.backgroundCube.uniforms),vertexShader:ls.backgroundCube.vertexShader,fragmentShader:ls.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,C,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(T1.makeRotationFromEuler(A.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(v_),c.material.toneMapped=bt.getTransfer(M.colorSpace)!==Lt,(h!==M||u!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new ni(new Er(2,2),new rs({name:"BackgroundMaterial",uniforms:Pr(ls.background.uniforms),vertexShader:ls.background.vertexShader,fragmentShader:ls.background.fragmentShader,side:ir,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=bt.getTransfer(M.colorSpace)!==Lt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,A){v.getRGB(Th,xf(n)),t.buffers.color.setClear(Th.r,Th.g,Th.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:_,dispose:m}}function C1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,G,X,I,V){let H=!1,B=u(D,I,X,G);r!==B&&(r=B,c(r.object)),H=f(D,I,X,V),H&&g(D,I,X,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,M(D,G,X,I),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function u(D,G,X,I){let V=I.wireframe===!0,H=i[G.id];H===void 0&&(H={},i[G.id]=H);let B=D.isInstancedMesh===!0?D.id:0,le=H[B];le===void 0&&(le={},H[B]=le);let Y=le[X.id];Y===void 0&&(Y={},le[X.id]=Y);let j=Y[V];return j===void 0&&(j=d(l()),Y[V]=j),j}function d(D){let G=[],X=[],I=[];for(let V=0;V<t;V++)G[V]=0,X[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:X,attributeDivisors:I,object:D,attributes:{},index:null}}function f(D,G,X,I){let V=r.attributes,H=G.attributes,B=0,le=X.getAttributes();for(let Y in le)if(le[Y].location>=0){let te=V[Y],ue=H[Y];if(ue===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),te===void 0||te.attribute!==ue||ue&&te.data!==ue.data)return!0;B++}return r.attributesNum!==B||r.index!==I}function g(D,G,X,I){let V={},H=G.attributes,B=0,le=X.getAttributes();for(let Y in le)if(le[Y].location>=0){let te=H[Y];te===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(te=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(te=D.instanceColor));let ue={};ue.attribute=te,te&&te.data&&(ue.data=te.data),V[Y]=ue,B++}r.attributes=V,r.attributesNum=B,r.index=I}function _(){let D=r.newAttributes;for(let G=0,X=D.length;G<X;G++)D[G]=0}function p(D){m(D,0)}function m(D,G){let X=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;X[D]=1,I[D]===0&&(n.enableVertexAttribArray(D),I[D]=1),V[D]!==G&&(n.vertexAttribDivisor(D,G),V[D]=G)}function v(){let D=r.newAttributes,G=r.enabledAttributes;for(let X=0,I=G.length;X<I;X++)G[X]!==D[X]&&(n.disableVertexAttribArray(X),G[X]=0)}function A(D,G,X,I,V,H,B){B===!0?n.vertexAttribIPointer(D,G,X,V,H):n.vertexAttribPointer(D,G,X,I,V,H)}function M(D,G,X,I){_();let V=I.attributes,H=X.getAttributes(),B=G.defaultAttributeValues;for(let le in H){let Y=H[le];if(Y.location>=0){let j=V[le];if(j===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let te=j.normalized,ue=j.itemSize,fe=e.get(j);if(fe===void 0)continue;let ee=fe.buffer,pe=fe.type,_e=fe.bytesPerElement,Re=pe===n.INT||pe===n.UNSIGNED_INT||j.gpuType===Gc;if(j.isInterleavedBufferAttribute){let we=j.data,Xe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,rt=j.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Ge=0;Ge<Y.locationSize;Ge++)m(Y.location+Ge,we.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Ge=0;Ge<Y.locationSize;Ge++)p(Y.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ge=0;Ge<Y.locationSize;Ge++)A(Y.location+Ge,ue/Y.locationSize,pe,te,Xe*_e,(rt+ue/Y.locationSize*Ge)*_e,Re)}else{if(j.isInstancedBufferAttribute){for(let we=0;we<Y.locationSize;we++)m(Y.location+we,j.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let we=0;we<Y.locationSize;we++)p(Y.location+we);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let we=0;we<Y.locationSize;we++)A(Y.location+we,ue/Y.locationSize,pe,te,ue*_e,ue/Y.locationSize*we*_e,Re)}}else if(B!==void 0){let te=B[le];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(Y.location,te);break;case 3:n.vertexAttrib3fv(Y.location,te);break;case 4:n.vertexAttrib4fv(Y.location,te);break;default:n.vertexAttrib1fv(Y.location,te)}}}}v()}function R(){k();for(let D in i){let G=i[D];for(let X in G){let I=G[X];for(let V in I){let H=I[V];for(let B in H)h(H[B].object),delete H[B];delete I[V]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let G=i[D.id];for(let X in G){let I=G[X];for(let V in I){let H=I[V];for(let B in H)h(H[B].object),delete H[B];delete I[V]}}delete i[D.id]}function x(D){for(let G in i){let X=i[G];for(let I in X){let V=X[I];if(V[D.id]===void 0)continue;let H=V[D.id];for(let B in H)h(H[B].object),delete H[B];delete V[D.id]}}}function S(D){for(let G in i){let X=i[G],I=D.isInstancedMesh===!0?D.id:0,V=X[I];if(V!==void 0){for(let H in V){let B=V[H];for(let le in B)h(B[le].object),delete B[le];delete V[H]}delete X[I],Object.keys(X).length===0&&delete i[G]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:C,releaseStatesOfObject:S,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:p,disableUnusedAttributes:v}}function R1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function P1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==vi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let S=x===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==si&&x!==Gi&&!S&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:M,maxSamples:R,samples:C}}function I1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Zn,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,_=u.clipIntersection,p=u.clipShadows,m=n.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let v=r?0:i,A=v*4,M=m.clippingState||null;l.value=M,M=h(g,d,A,f);for(let R=0;R!==A;++R)M[R]=t[R];m.clippingState=M,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(u,d,f,g){let _=u!==null?u.length:0,p=null;if(_!==0){if(p=l.value,g!==!0||p===null){let m=f+_*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let A=0,M=f;A!==_;++A,M+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,p}}var Ka=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Pa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Po(5,5,5),r=new rs({name:"CubemapFromEquirect",uniforms:Pr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:Tr});r.uniforms.tEquirect.value=t;let o=new ni(s,r),a=t.minFilter;return t.minFilter===Rs&&(t.minFilter=Jn),new Lo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},j0=256,L1=3,D1=20,b_=256,M_=16,N1=3,U1=new Z,O1=new ct,Ch=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Lo(1,10,null),this._boxMesh=new ni(new Po(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=U1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(O1));let p=new Lo(i,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=_,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=t_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=e_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(j0,mf(e))}_fromTexture(e,t){e.mapping===Cr||e.mapping===Oo?this._setSize(e.image.length===0?j0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Q0(e,!1,!1),i=Math.log2(e)-L1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Q0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Cr||e.mapping===Oo?(this._cubemapMaterial===null&&(this._cubemapMaterial=t_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=e_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=F1(),this._integrationMaterial=B1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/M_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-N1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(b_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=k1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Q0(n,e,t){return new Ka(n,{minFilter:Rs,generateMipmaps:e,type:Wi,colorSpace:ba,depthBuffer:t})}function Ja(n,e,t){return new rs({name:n,uniforms:e,vertexShader:dt.cube_vert,fragmentShader:t,side:jn,blending:Tr,depthTest:!1,depthWrite:!1})}function F1(){return Ja("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${b_}u

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
	`)}function B1(){return Ja("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:M_}},`

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
	`)}function k1(){return Ja("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${D1}
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
	`)}function e_(){return Ja("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function t_(){return Ja("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function z1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===zc||f===Vc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let _=new Ka(g.height);return _.fromEquirectangularTexture(n,d),e.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===zc||f===Vc,_=f===Cr||f===Oo;if(g||_){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Ch(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return g&&v&&v.height>0||_&&v&&l(v)?(i===null&&(i=new Ch(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===zc?d.mapping=Cr:f===Vc&&(d.mapping=Oo),d}function l(d){let f=0,g=6;for(let _=0;_<g;_++)d[_]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function V1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&_a("WebGLRenderer: "+i+" extension not supported."),s}}}function H1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(e.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function h(g){let _=g.attributes;for(let p in _)e.update(_[p],n.ARRAY_BUFFER)}function u(g){let _=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=_!==null?_.array.length:p.array.length/3-1,A=p.count>=65535?Ca:Aa,M=new A(Math.ceil(v/3)*6,1),R=M.array;if(_!==null){let x=_.array;m=_.version;for(let S=0,k=0;S<v;S+=3){let U=x[S+0],D=x[S+1],G=x[S+2];R[k++]=U,R[k++]=D,R[k++]=D,R[k++]=G,R[k++]=G,R[k++]=U}}else{m=p.version;for(let x=0,S=0;x<v;x+=3){let k=x+0,U=x+1,D=x+2;R[S++]=k,R[S++]=U,R[S++]=U,R[S++]=D,R[S++]=D,R[S++]=k}}M.version=m;let C=r.get(g);C&&e.remove(C),r.set(g,M)}function d(g){let _=r.get(g);if(_){let p=g.index;p!==null&&_.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function G1(n,e,t){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),t.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),t.update(d,i,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let _=0;for(let p=0;p<f;p++)_+=d[p];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function W1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function X1(n,e,t){let i=new WeakMap,s=new Jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let k=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),g===!0&&(A=2),_===!0&&(A=3);let M=a.attributes.position.count*A,R=1;M>e.maxTextureSize&&(R=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let C=new Float32Array(M*R*4*u),x=new wa(C,M,R,u);x.type=Gi,x.needsUpdate=!0;let S=A*4;for(let U=0;U<u;U++){let D=p[U],G=m[U],X=v[U],I=M*R*4*U;for(let V=0;V<D.count;V++){let H=V*S;f===!0&&(s.fromBufferAttribute(D,V),C[I+H+0]=s.x,C[I+H+1]=s.y,C[I+H+2]=s.z,C[I+H+3]=0),g===!0&&(s.fromBufferAttribute(G,V),C[I+H+4]=s.x,C[I+H+5]=s.y,C[I+H+6]=s.z,C[I+H+7]=0),_===!0&&(s.fromBufferAttribute(X,V),C[I+H+8]=s.x,C[I+H+9]=s.y,C[I+H+10]=s.z,C[I+H+11]=X.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new tt(M,R)},i.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function q1(n,e,t,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var $1={[$d]:"LINEAR_TONE_MAPPING",[Yd]:"REINHARD_TONE_MAPPING",[Zd]:"CINEON_TONE_MAPPING",[Kd]:"ACES_FILMIC_TONE_MAPPING",[jd]:"AGX_TONE_MAPPING",[Qd]:"NEUTRAL_TONE_MAPPING",[Jd]:"CUSTOM_TONE_MAPPING"};function Y1(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new xi;h.setAttribute("position",new mi([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new mi([0,2,0,0,2,0],2));let u=new wc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new ni(h,u),f=new Oa(-1,1,1,-1,0,1),g=null,_=null,p=!1,m,v=null,A=[],M=!1;this.setSize=function(R,C){o.setSize(R,C),a!==null&&a.setSize(R,C),l!==null&&l.setSize(R,C);for(let x=0;x<A.length;x++){let S=A[x];S.setSize&&S.setSize(R,C)}},this.setEffects=function(R){A=R,M=A.length>0&&A[0].isRenderPass===!0;let C=o.width,x=o.height;A.length>0&&a===null&&(a=new _i(C,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new _i(C,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&A.some(k=>k.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Cs(C,x),r===!0&&(c.format=Ps,c.type=Rr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let k=0;k<A.length;k++){let U=A[k];U.setSize&&U.setSize(C,x),S&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,C){if(p||R.toneMapping===os&&A.length===0)return!1;if(v=C,C!==null){let x=C.width,S=C.height;(o.width!==x||o.height!==S)&&this.setSize(x,S)}return M===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=os,!0},this.hasRenderPass=function(){return M},this.end=function(R,C){R.toneMapping=m,p=!0;let x=o,S=a;for(let k=0;k<A.length;k++){let U=A[k];U.enabled!==!1&&(U.render(R,S,x,C),U.needsSwap!==!1&&(x=S,S=S===a?l:a))}if(g!==R.outputColorSpace||_!==R.toneMapping){g=R.outputColorSpace,_=R.toneMapping,u.defines={},bt.getTransfer(g)===Lt&&(u.defines.SRGB_TRANSFER="");let k=$1[_];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(v),R.render(d,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var S_=new ti,w_=new Cs(1,1),E_=new Ia(1),T_=new wa,A_=new yc,C_=new Pa,n_=[],i_=[],s_=new Float32Array(16),r_=new Float32Array(9),o_=new Float32Array(4);function zo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=n_[s];if(r===void 0&&(r=new Float32Array(s),n_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function wn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Ph(n,e){let t=i_[e];t===void 0&&(t=new Int32Array(e),i_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function Z1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function K1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function J1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(wn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function j1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function Q1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;o_.set(i),n.uniformMatrix2fv(this.addr,!1,o_),En(t,i)}}function eE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;r_.set(i),n.uniformMatrix3fv(this.addr,!1,r_),En(t,i)}}function tE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(wn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(wn(t,i))return;s_.set(i),n.uniformMatrix4fv(this.addr,!1,s_),En(t,i)}}function nE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function iE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function sE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function rE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function oE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function aE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(wn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function lE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(wn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function cE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(wn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function Ih(n){return n.version===0&&(n.compareFunction=uf,n.needsUpdate=!0),n}function hE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ih(w_):r=S_,t.setTexture2D(e||r,s)}function uE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||A_,s)}function dE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ih(E_):r=C_,t.setTextureCube(e||r,s)}function fE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||T_,s)}function pE(n){switch(n){case 5126:return Z1;case 35664:return K1;case 35665:return J1;case 35666:return j1;case 35674:return Q1;case 35675:return eE;case 35676:return tE;case 5124:case 35670:return nE;case 35667:case 35671:return iE;case 35668:case 35672:return sE;case 35669:case 35673:return rE;case 5125:return oE;case 36294:return aE;case 36295:return lE;case 36296:return cE;case 35678:case 36198:case 36298:case 36306:case 35682:return hE;case 35679:case 36299:case 36307:return uE;case 35680:case 36300:case 36308:case 36293:return dE;case 36289:case 36303:case 36311:case 36292:return fE}}function mE(n,e){n.uniform1fv(this.addr,e)}function gE(n,e){let t=zo(e,this.size,2);n.uniform2fv(this.addr,t)}function _E(n,e){let t=zo(e,this.size,3);n.uniform3fv(this.addr,t)}function xE(n,e){let t=zo(e,this.size,4);n.uniform4fv(this.addr,t)}function yE(n,e){let t=zo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function vE(n,e){let t=zo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function bE(n,e){let t=zo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function ME(n,e){n.uniform1iv(this.addr,e)}function SE(n,e){n.uniform2iv(this.addr,e)}function wE(n,e){n.uniform3iv(this.addr,e)}function EE(n,e){n.uniform4iv(this.addr,e)}function TE(n,e){n.uniform1uiv(this.addr,e)}function AE(n,e){n.uniform2uiv(this.addr,e)}function CE(n,e){n.uniform3uiv(this.addr,e)}function RE(n,e){n.uniform4uiv(this.addr,e)}function PE(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ih(w_):o=S_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function IE(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||A_,r[o])}function LE(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ih(E_):o=C_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function DE(n,e,t){let i=this.cache,s=e.length,r=Ph(t,s);wn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||T_,r[o])}function NE(n){switch(n){case 5126:return mE;case 35664:return gE;case 35665:return _E;case 35666:return xE;case 35674:return yE;case 35675:return vE;case 35676:return bE;case 5124:case 35670:return ME;case 35667:case 35671:return SE;case 35668:case 35672:return wE;case 35669:case 35673:return EE;case 5125:return TE;case 36294:return AE;case 36295:return CE;case 36296:return RE;case 35678:case 36198:case 36298:case 36306:case 35682:return PE;case 35679:case 36299:case 36307:return IE;case 35680:case 36300:case 36308:case 36293:return LE;case 36289:case 36303:case 36311:case 36292:return DE}}var wf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=pE(t.type)}},Ef=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=NE(t.type)}},Tf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Mf=/(\w+)(\])?(\[|\.)?/g;function a_(n,e){n.seq.push(e),n.map[e.id]=e}function UE(n,e,t){let i=n.name,s=i.length;for(Mf.lastIndex=0;;){let r=Mf.exec(i),o=Mf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){a_(t,c===void 0?new wf(a,n,e):new Ef(a,n,e));break}else{let u=t.map[a];u===void 0&&(u=new Tf(a),a_(t,u)),t=u}}}var ko=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);UE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function l_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var OE=37297,FE=0;function BE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var c_=new nt;function kE(n){bt._getMatrix(c_,bt.workingColorSpace,n);let e=`mat3( ${c_.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(n)){case Ma:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function h_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+BE(n.getShaderSource(e),a)}else return r}function zE(n,e){let t=kE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var VE={[$d]:"Linear",[Yd]:"Reinhard",[Zd]:"Cineon",[Kd]:"ACESFilmic",[jd]:"AgX",[Qd]:"Neutral",[Jd]:"Custom"};function HE(n,e){let t=VE[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new Z;function GE(){bt.getLuminanceCoefficients(Ah);let n=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function WE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Za).join(`
`)}function XE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function qE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Za(n){return n!==""}function u_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function d_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var $E=/^[ \t]*#include +<([\w\d./]+)>/gm;function Af(n){return n.replace($E,YE)}function YE(n,e){let t=dt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Af(t)}var ZE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function f_(n){return n.replace(ZE,KE)}function KE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function p_(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var JE={[za]:"SHADOWMAP_TYPE_PCF",[No]:"SHADOWMAP_TYPE_VSM"};function jE(n){return JE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var QE={[Oo]:"ENVMAP_MODE_REFRACTION"};function eT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":QE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var tT={[kc]:"ENVMAP_BLENDING_MULTIPLY",[P0]:"ENVMAP_BLENDING_MIX",[I0]:"ENVMAP_BLENDING_ADD"};function nT(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":tT[n.combine]||"ENVMAP_BLENDING_NONE"}function iT(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=jE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=eT(t),u=nT(t),d=WE(t),f=XE(r),g=s.createProgram(),_,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Za).join(`
`),_.length>0&&(_+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Za).join(`
`),p.length>0&&(p+=`
`)):(_=[p_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Za).join(`
`),p=[p_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==os?"#define TONE_MAPPING":"",t.toneMapping!==os?dt.tonemapping_pars_fragment:"",t.toneMapping!==os?HE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,zE("linearToOutputTexel",t.outputColorSpace),GE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Za).join(`
`)),o=Af(o),o=u_(o,t),o=d_(o,t),a=Af(a),a=u_(a,t),a=d_(a,t),o=f_(o),a=f_(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,p=["#define varying in",t.glslVersion===df?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===df?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+_+o,A=m+p+a,M=l_(s,s.VERTEX_SHADER,v),R=l_(s,s.FRAGMENT_SHADER,A);s.attachShader(g,M),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(U){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(M)||"",X=s.getShaderInfoLog(R)||"",I=D.trim(),V=G.trim(),H=X.trim(),B=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,M,R);else{let Y=h_(s,M,"vertex"),j=h_(s,R,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+I+`
`+Y+`
`+j)}else I!==""?Ze("WebGLProgram: Program Info Log:",I):(V===""||H==="")&&(le=!1);le&&(U.diagnostics={runnable:B,programLog:I,vertexShader:{log:V,prefix:_},fragmentShader:{log:H,prefix:p}})}s.deleteShader(M),s.deleteShader(R),x=new ko(s,g),S=qE(s,g)}let x;this.getUniforms=function(){return x===void 0&&C(this),x};let S;this.getAttributes=function(){return S===void 0&&C(this),S};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,OE)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=FE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=R,this}var sT=0,Cf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Rf(e),t.set(e,i)),i}},Rf=class{constructor(e){this.id=sT++,this.code=e,this.usedTimes=0}};function rT(n){return n===sr||n===qa||n===$a}function oT(n,e,t,i,s,r){let o=new Ea,a=new Cf,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,S,k,U,D,G){let X=U.fog,I=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,B=e.get(x.envMap||V,H),le=d[x.type],Y=i.precision;x.precision!==null&&(Y=i.getMaxPrecision(x.precision),Y!==x.precision&&Ze("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=j!==void 0?j.length:0,ue=0;I.morphAttributes.position!==void 0&&(ue=1),I.morphAttributes.normal!==void 0&&(ue=2),I.morphAttributes.color!==void 0&&(ue=3);let fe,ee,pe,_e;if(le){let Pe=ls[le];fe=Pe.vertexShader,ee=Pe.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Pe=a.getVertexShaderStage(x),lt=a.getFragmentShaderStage(x);a.update(x,Pe,lt),pe=Pe.id,_e=lt.id}let Re=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),Xe=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Ge=!!x.map,ft=!!x.matcap,ht=!!B,it=ht&&B.isPMREMTexture===!0,Zt=!!x.aoMap,Vt=!!x.lightMap,hn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,An=!!x.displacementMap,Mt=!!x.emissiveMap,vn=!!x.metalnessMap,tn=!!x.roughnessMap,un=x.anisotropy>0,F=x.clearcoat>0,Ie=x.diffuseRoughness>0,Ye=x.dispersion>0,ot=x.retroreflectivity>0,Ee=x.iridescence>0,Bt=x.sheen>0,He=x.transmission>0,$e=un&&!!x.anisotropyMap,P=F&&!!x.clearcoatMap,b=F&&!!x.clearcoatNormalMap,q=F&&!!x.clearcoatRoughnessMap,de=Ie&&!!x.diffuseRoughnessMap,oe=Ee&&!!x.iridescenceMap,ye=Ee&&!!x.iridescenceThicknessMap,ve=Bt&&!!x.sheenColorMap,ne=Bt&&!!x.sheenRoughnessMap,se=!!x.specularMap,ge=!!x.specularColorMap,O=!!x.specularIntensityMap,re=He&&!!x.transmissionMap,ie=He&&!!x.thicknessMap,Te=!!x.gradientMap,xe=!!x.alphaMap,Se=x.alphaTest>0,We=!!x.alphaHash,Je=!!x.extensions,ce=os;x.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=it?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,je={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:pe,customFragmentShaderID:_e,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&D.instanceColor!==null,instancingMorph:Xe&&D.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ge,matcap:ft,envMap:ht,envMapMode:ht&&B.mapping,envMapPMREM:it,envMapMaxLod:it?ke.length-1:null,envMapSize:it?ke[0].width:null,aoMap:Zt,lightMap:Vt,bumpMap:hn,normalMap:Ot,displacementMap:An,emissiveMap:Mt,normalMapObjectSpace:Ot&&x.normalMapType===N0,normalMapTangentSpace:Ot&&x.normalMapType===Eh,packedNormalMap:Ot&&x.normalMapType===Eh&&rT(x.normalMap.format),metalnessMap:vn,roughnessMap:tn,anisotropy:un,anisotropyMap:$e,clearcoat:F,clearcoatMap:P,clearcoatNormalMap:b,clearcoatRoughnessMap:q,diffuseRoughness:Ie,diffuseRoughnessMap:de,dispersion:Ye,retroreflection:ot,iridescence:Ee,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:Bt,sheenColorMap:ve,sheenRoughnessMap:ne,specularMap:se,specularColorMap:ge,specularIntensityMap:O,transmission:He,transmissionMap:re,thicknessMap:ie,gradientMap:Te,opaque:x.transparent===!1&&x.blending===Uo&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:We,combine:x.combine,mapUv:Ge&&f(x.map.channel),aoMapUv:Zt&&f(x.aoMap.channel),lightMapUv:Vt&&f(x.lightMap.channel),bumpMapUv:hn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:An&&f(x.displacementMap.channel),emissiveMapUv:Mt&&f(x.emissiveMap.channel),metalnessMapUv:vn&&f(x.metalnessMap.channel),roughnessMapUv:tn&&f(x.roughnessMap.channel),anisotropyMapUv:$e&&f(x.anisotropyMap.channel),clearcoatMapUv:P&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(x.sheenRoughnessMap.channel),specularMapUv:se&&f(x.specularMap.channel),specularColorMapUv:ge&&f(x.specularColorMap.channel),specularIntensityMapUv:O&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ie&&f(x.thicknessMap.channel),alphaMapUv:xe&&f(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ot||un),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Ge||xe),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ue,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:G.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ge&&x.map.isVideoTexture===!0&&bt.getTransfer(x.map.colorSpace)===Lt,decodeVideoTextureEmissive:Mt&&x.emissiveMap.isVideoTexture===!0&&bt.getTransfer(x.emissiveMap.colorSpace)===Lt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ii,flipSided:x.side===jn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&x.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function _(x){let S=[];if(x.shaderID?S.push(x.shaderID):(S.push(x.customVertexShaderID),S.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)S.push(k),S.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(p(S,x),m(S,x),S.push(n.outputColorSpace)),S.push(x.customProgramCacheKey),S.join()}function p(x,S){x.push(S.precision),x.push(S.outputColorSpace),x.push(S.envMapMode),x.push(S.envMapPMREM),x.push(S.envMapMaxLod),x.push(S.envMapSize),x.push(S.mapUv),x.push(S.alphaMapUv),x.push(S.lightMapUv),x.push(S.aoMapUv),x.push(S.bumpMapUv),x.push(S.normalMapUv),x.push(S.displacementMapUv),x.push(S.emissiveMapUv),x.push(S.metalnessMapUv),x.push(S.roughnessMapUv),x.push(S.anisotropyMapUv),x.push(S.clearcoatMapUv),x.push(S.clearcoatNormalMapUv),x.push(S.clearcoatRoughnessMapUv),x.push(S.diffuseRoughnessMapUv),x.push(S.iridescenceMapUv),x.push(S.iridescenceThicknessMapUv),x.push(S.sheenColorMapUv),x.push(S.sheenRoughnessMapUv),x.push(S.specularMapUv),x.push(S.specularColorMapUv),x.push(S.specularIntensityMapUv),x.push(S.transmissionMapUv),x.push(S.thicknessMapUv),x.push(S.combine),x.push(S.fogExp2),x.push(S.sizeAttenuation),x.push(S.morphTargetsCount),x.push(S.numSunLights),x.push(S.numDirLights),x.push(S.numPointLights),x.push(S.numSpotLights),x.push(S.numSpotLightMaps),x.push(S.numHemiLights),x.push(S.numRectAreaLights),x.push(S.numSunLightShadows),x.push(S.numDirLightShadows),x.push(S.numPointLightShadows),x.push(S.numSpotLightShadows),x.push(S.numSpotLightShadowsWithMaps),x.push(S.numLightProbes),x.push(S.numLightProbeGrids),x.push(S.shadowMapType),x.push(S.toneMapping),x.push(S.numClippingPlanes),x.push(S.numClipIntersection),x.push(S.depthPacking)}function m(x,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let S=d[x.type],k;if(S){let U=ls[S];k=Z0.clone(U.uniforms)}else k=x.uniforms;return k}function A(x,S){let k=h.get(S);return k!==void 0?++k.usedTimes:(k=new iT(n,S,x,s),c.push(k),h.set(S,k)),k}function M(x){if(--x.usedTimes===0){let S=c.indexOf(x);c[S]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){a.remove(x)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:v,acquireProgram:A,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:C}}function aT(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function lT(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function m_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function g_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,_,p,m){let v=n[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:p,group:m},n[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=_,v.renderOrder=d.renderOrder,v.z=p,v.group=m),e++,v}function l(d,f,g,_,p,m,v){v.reversedDepth===!0&&(p=-p);let A=a(d,f,g,_,p,m);g.transmission>0?i.push(A):g.transparent===!0?s.push(A):t.push(A)}function c(d,f,g,_,p,m){let v=a(d,f,g,_,p,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(d,f){t.length>1&&t.sort(d||lT),i.length>1&&i.sort(f||m_),s.length>1&&s.sort(f||m_)}function u(){for(let d=e,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function cT(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new g_,n.set(i,[o])):s>=r.length?(o=new g_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function hT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Z,color:new ct};break;case"SpotLight":t={position:new Z,direction:new Z,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Z,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Z,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new Z,halfWidth:new Z,halfHeight:new Z};break}return n[e.id]=t,t}}}function uT(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var dT=0;function fT(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function pT(n){let e=new hT,t=uT(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Z);let s=new Z,r=new Yt,o=new Yt;function a(c){let h=0,u=0,d=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let f=0,g=0,_=0,p=0,m=0,v=0,A=0,M=0,R=0,C=0,x=0,S=0,k=0,U=0;c.sort(fT);for(let G=0,X=c.length;G<X;G++){let I=c[G],V=I.color,H=I.intensity,B=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===sr?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*H,u+=V.g*H,d+=V.b*H;else if(I.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(I.sh.coefficients[Y],H);U++}else if(I.isSunLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[g]=te,i.sunShadowMap[g]=le;let ue=j.getViewportCount();for(let fe=0;fe<ue;fe++)i.sunShadowMatrix[_+fe]=j.getMatrix(fe),i.sunShadowCascade[_+fe]=j._cascadeData[fe];_+=ue,g++}i.sun[f]=Y,f++}else if(I.isDirectionalLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.directionalShadow[p]=te,i.directionalShadowMap[p]=le,i.directionalShadowMatrix[p]=I.shadow.matrix,R++}i.directional[p]=Y,p++}else if(I.isSpotLight){let Y=e.get(I);Y.position.setFromMatrixPosition(I.matrixWorld),Y.color.copy(V).multiplyScalar(H),Y.distance=B,Y.coneCos=Math.cos(I.angle),Y.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Y.decay=I.decay,i.spot[v]=Y;let j=I.shadow;if(I.map&&(i.spotLightMap[S]=I.map,S++,j.updateMatrices(I),I.castShadow&&k++),i.spotLightMatrix[v]=j.matrix,I.castShadow){let te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.spotShadow[v]=te,i.spotShadowMap[v]=le,x++}v++}else if(I.isRectAreaLight){let Y=e.get(I);Y.color.copy(V).multiplyScalar(H),Y.halfWidth.set(I.width*.5,0,0),Y.halfHeight.set(0,I.height*.5,0),i.rectArea[A]=Y,A++}else if(I.isPointLight){let Y=e.get(I);if(Y.color.copy(I.color).multiplyScalar(I.intensity),Y.distance=I.distance,Y.decay=I.decay,I.castShadow){let j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,i.pointShadow[m]=te,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=I.shadow.matrix,C++}i.point[m]=Y,m++}else if(I.isHemisphereLight){let Y=e.get(I);Y.skyColor.copy(I.color).multiplyScalar(H),Y.groundColor.copy(I.groundColor).multiplyScalar(H),i.hemi[M]=Y,M++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==M||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==C||D.numSpotShadows!==x||D.numSpotMaps!==S||D.numLightProbes!==U)&&(i.sun.length=f,i.directional.length=p,i.spot.length=v,i.rectArea.length=A,i.point.length=m,i.hemi.length=M,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+S-k,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=U,D.sunLength=f,D.directionalLength=p,D.pointLength=m,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=M,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=C,D.numSpotShadows=x,D.numSpotMaps=S,D.numLightProbes=U,i.version=dT++)}function l(c,h){let u=0,d=0,f=0,g=0,_=0,p=0,m=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let M=c[v];if(M.isSunLight){let R=i.sun[u];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),u++}else if(M.isDirectionalLight){let R=i.directional[d];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(M.isSpotLight){let R=i.spot[g];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(M.isRectAreaLight){let R=i.rectArea[_];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),_++}else if(M.isPointLight){let R=i.point[f];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),f++}else if(M.isHemisphereLight){let R=i.hemi[p];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function __(n){let e=new pT(n),t=[],i=[],s=[];function r(u){h.camera=u,t.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){i.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function mT(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new __(n),e.set(s,[a])):r>=o.length?(a=new __(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var gT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,_T=`uniform sampler2D shadow_pass;
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
}`,xT=[new Z(1,0,0),new Z(-1,0,0),new Z(0,1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1)],yT=[new Z(0,-1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1),new Z(0,-1,0),new Z(0,-1,0)],x_=new Yt,Ya=new Z,Sf=new Z;function vT(n,e,t){let i=new Js,s=new tt,r=new tt,o=new Jt,a=new Ec,l=new Tc,c={},h=t.maxTextureSize,u={[ir]:jn,[jn]:ir,[ii]:ii},d=new rs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new tt},radius:{value:4}},vertexShader:gT,fragmentShader:_T}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new xi;g.setAttribute("position",new zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new ni(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=za;let m=this.type;this.render=function(C,x,S){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||C.length===0)return;this.type===u0&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=za);let k=n.getRenderTarget(),U=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),G=n.state;G.setBlending(Tr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let X=m!==this.type;X&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=C.length;I<V;I++){let H=C[I],B=H.shadow;if(B===void 0){Ze("WebGLShadowMap:",H,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let le=B.getFrameExtents();s.multiply(le),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||X===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===No){if(H.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new _i(s.x,s.y,{format:sr,type:Wi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),B.map.texture.name=H.name+".shadowMap",B.map.depthTexture=new Cs(s.x,s.y,Gi),B.map.depthTexture.name=H.name+".shadowMapDepth",B.map.depthTexture.format=Es,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=yn,B.map.depthTexture.magFilter=yn}else H.isPointLight?(B.map=new Ka(s.x),B.map.depthTexture=new Ia(s.x,Hi)):(B.map=new _i(s.x,s.y),B.map.depthTexture=new Cs(s.x,s.y,Hi)),B.map.depthTexture.name=H.name+".shadowMap",B.map.depthTexture.format=Es,this.type===za?(B.map.depthTexture.compareFunction=Y?hf:cf,B.map.depthTexture.minFilter=Jn,B.map.depthTexture.magFilter=Jn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=yn,B.map.depthTexture.magFilter=yn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let j=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();H.isPointLight!==!0&&B.updateMatrices(H,S);let te=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:S.layers;for(let ue=0;ue<j;ue++){let fe=B.getCamera(ue);if(H.isPointLight){let ee=B.camera,pe=B.matrix,_e=H.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),Ya.setFromMatrixPosition(H.matrixWorld),ee.position.copy(Ya),Sf.copy(ee.position),Sf.add(xT[ue]),ee.up.copy(yT[ue]),ee.lookAt(Sf),ee.updateMatrixWorld(),pe.makeTranslation(-Ya.x,-Ya.y,-Ya.z),x_.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),B._frustum.setFromProjectionMatrix(x_,ee.coordinateSystem,ee.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(B.map),n.clear());let ee=B.getViewport(ue);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),G.viewport(o)}i=B.getFrustum(ue),M(x,S,fe,H,te,this.type)}B.isPointLightShadow!==!0&&this.type===No&&v(B,S),B.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(k,U,D)};function v(C,x){let S=e.update(_);d.defines.VSM_SAMPLES!==C.blurSamples&&(d.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new _i(s.x,s.y,{format:sr,type:Wi}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),d.uniforms.shadow_pass.value=C.map.depthTexture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(x,null,S,d,_,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(x,null,S,f,_,null)}function A(C,x,S,k){let U=null,D=S.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)U=D;else if(U=S.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=U.uuid,X=x.uuid,I=c[G];I===void 0&&(I={},c[G]=I);let V=I[X];V===void 0&&(V=U.clone(),I[X]=V,x.addEventListener("dispose",R)),U=V}if(U.visible=x.visible,U.wireframe=x.wireframe,k===No?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:u[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,S.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let G=n.properties.get(U);G.light=S}return U}function M(C,x,S,k,U,D){if(C.visible===!1)return;if(C.layers.test(U)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===No)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,C.matrixWorld);let I=e.update(C),V=C.material;if(Array.isArray(V)){let H=I.groups;for(let B=0,le=H.length;B<le;B++){let Y=H[B],j=V[Y.materialIndex];if(j&&j.visible){let te=A(C,j,k,D);C.onBeforeShadow(n,C,x,S,I,te,Y),n.renderBufferDirect(S,null,I,te,C,Y),C.onAfterShadow(n,C,x,S,I,te,Y)}}}else if(V.visible){let H=A(C,V,k,D);C.onBeforeShadow(n,C,x,S,I,H,null),n.renderBufferDirect(S,null,I,H,C,null),C.onAfterShadow(n,C,x,S,I,H,null)}}let X=C.children;for(let I=0,V=X.length;I<V;I++)M(X[I],x,S,k,U,D)}function R(C){C.target.removeEventListener("dispose",R);for(let S in c){let k=c[S],U=C.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function bT(n,e){function t(){let O=!1,re=new Jt,ie=null,Te=new Jt(0,0,0,0);return{setMask:function(xe){ie!==xe&&!O&&(n.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){O=xe},setClear:function(xe,Se,We,Je,ce){ce===!0&&(xe*=Je,Se*=Je,We*=Je),re.set(xe,Se,We,Je),Te.equals(re)===!1&&(n.clearColor(xe,Se,We,Je),Te.copy(re))},reset:function(){O=!1,ie=null,Te.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ie=null,Te=null,xe=null;return{setReversed:function(Se){if(re!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let Je=xe;xe=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(Se){Se?we(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!O&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(re&&(Se=X0[Se]),Te!==Se){switch(Se){case ac:n.depthFunc(n.NEVER);break;case lc:n.depthFunc(n.ALWAYS);break;case cc:n.depthFunc(n.LESS);break;case Mo:n.depthFunc(n.LEQUAL);break;case hc:n.depthFunc(n.EQUAL);break;case uc:n.depthFunc(n.GEQUAL);break;case dc:n.depthFunc(n.GREATER);break;case fc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){xe!==Se&&(xe=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ie=null,Te=null,xe=null,re=!1}}}function s(){let O=!1,re=null,ie=null,Te=null,xe=null,Se=null,We=null,Je=null,ce=null;return{setTest:function(ke){O||(ke?we(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!O&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,je,Pe){(ie!==ke||Te!==je||xe!==Pe)&&(n.stencilFunc(ke,je,Pe),ie=ke,Te=je,xe=Pe)},setOp:function(ke,je,Pe){(Se!==ke||We!==je||Je!==Pe)&&(n.stencilOp(ke,je,Pe),Se=ke,We=je,Je=Pe)},setLocked:function(ke){O=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){O=!1,re=null,ie=null,Te=null,xe=null,Se=null,We=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],_=null,p=!1,m=null,v=null,A=null,M=null,R=null,C=null,x=null,S=new ct(0,0,0),k=0,U=!1,D=null,G=null,X=null,I=null,V=null,H=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,le=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=le>=1):Y.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=le>=2);let j=null,te={},ue=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new Jt().fromArray(ue),pe=new Jt().fromArray(fe);function _e(O,re,ie,Te){let xe=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ie;We++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Se}let Re={};Re[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(Mo),hn(!1),Ot(Vd),we(n.CULL_FACE),Zt(Tr);function we(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function Xe(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function rt(O,re){return d[O]!==re?(n.bindFramebuffer(O,re),d[O]=re,O===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ge(O,re){let ie=g,Te=!1;if(O){ie=f.get(re),ie===void 0&&(ie=[],f.set(re,ie));let xe=O.textures;if(ie.length!==xe.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=xe.length;Se<We;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=xe.length,Te=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ie)}function ft(O){return _!==O?(n.useProgram(O),_=O,!0):!1}let ht={[Ar]:n.FUNC_ADD,[f0]:n.FUNC_SUBTRACT,[p0]:n.FUNC_REVERSE_SUBTRACT};ht[m0]=n.MIN,ht[g0]=n.MAX;let it={[_0]:n.ZERO,[x0]:n.ONE,[y0]:n.SRC_COLOR,[Xd]:n.SRC_ALPHA,[E0]:n.SRC_ALPHA_SATURATE,[S0]:n.DST_COLOR,[b0]:n.DST_ALPHA,[v0]:n.ONE_MINUS_SRC_COLOR,[qd]:n.ONE_MINUS_SRC_ALPHA,[w0]:n.ONE_MINUS_DST_COLOR,[M0]:n.ONE_MINUS_DST_ALPHA,[T0]:n.CONSTANT_COLOR,[A0]:n.ONE_MINUS_CONSTANT_COLOR,[C0]:n.CONSTANT_ALPHA,[R0]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,re,ie,Te,xe,Se,We,Je,ce,ke){if(O===Tr){p===!0&&(Xe(n.BLEND),p=!1);return}if(p===!1&&(we(n.BLEND),p=!0),O!==d0){if(O!==m||ke!==U){if((v!==Ar||R!==Ar)&&(n.blendEquation(n.FUNC_ADD),v=Ar,R=Ar),ke)switch(O){case Uo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hd:n.blendFunc(n.ONE,n.ONE);break;case Gd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",O);break}else switch(O){case Uo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Gd:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wd:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",O);break}A=null,M=null,C=null,x=null,S.set(0,0,0),k=0,m=O,U=ke}return}xe=xe||re,Se=Se||ie,We=We||Te,(re!==v||xe!==R)&&(n.blendEquationSeparate(ht[re],ht[xe]),v=re,R=xe),(ie!==A||Te!==M||Se!==C||We!==x)&&(n.blendFuncSeparate(it[ie],it[Te],it[Se],it[We]),A=ie,M=Te,C=Se,x=We),(Je.equals(S)===!1||ce!==k)&&(n.blendColor(Je.r,Je.g,Je.b,ce),S.copy(Je),k=ce),m=O,U=!1}function Vt(O,re){O.side===ii?Xe(n.CULL_FACE):we(n.CULL_FACE);let ie=O.side===jn;re&&(ie=!ie),hn(ie),O.blending===Uo&&O.transparent===!1?Zt(Tr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Mt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function hn(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function Ot(O){O!==c0?(we(n.CULL_FACE),O!==G&&(O===Vd?n.cullFace(n.BACK):O===h0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),G=O}function An(O){O!==X&&(B&&n.lineWidth(O),X=O)}function Mt(O,re,ie){O?(we(n.POLYGON_OFFSET_FILL),(I!==re||V!==ie)&&(I=re,V=ie,o.getReversed()&&(re=-re,ie=-ie),n.polygonOffset(re,ie))):Xe(n.POLYGON_OFFSET_FILL)}function vn(O){O?we(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function tn(O){O===void 0&&(O=n.TEXTURE0+H-1),j!==O&&(n.activeTexture(O),j=O)}function un(O,re,ie){ie===void 0&&(j===null?ie=n.TEXTURE0+H-1:ie=j);let Te=te[ie];Te===void 0&&(Te={type:void 0,texture:void 0},te[ie]=Te),(Te.type!==O||Te.texture!==re)&&(j!==ie&&(n.activeTexture(ie),j=ie),n.bindTexture(O,re||Re[O]),Te.type=O,Te.texture=re)}function F(){let O=te[j];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function Ye(){try{n.compressedTexImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function ot(){try{n.texSubImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function Bt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function $e(){try{n.texStorage2D(...arguments)}catch(O){et("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){et("WebGLState:",O)}}function b(){try{n.texImage2D(...arguments)}catch(O){et("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){et("WebGLState:",O)}}function de(O){return u[O]!==void 0?u[O]:n.getParameter(O)}function oe(O,re){u[O]!==re&&(n.pixelStorei(O,re),u[O]=re)}function ye(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){pe.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),pe.copy(O))}function ne(O,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Te=ie.get(O);Te===void 0&&(Te=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Te,Te),ie.set(O,Te))}function se(O,re,ie){let xe=c.get(re).get(O);l[xe]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,te={},d={},l={},f=new WeakMap,g=[],_=null,p=!1,m=null,v=null,A=null,M=null,R=null,C=null,x=null,S=new ct(0,0,0),k=0,U=!1,D=null,G=null,X=null,I=null,V=null,ee.set(0,0,n.canvas.width,n.canvas.height),pe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Xe,bindFramebuffer:rt,drawBuffers:Ge,useProgram:ft,setBlending:Zt,setMaterial:Vt,setFlipSided:hn,setCullFace:Ot,setLineWidth:An,setPolygonOffset:Mt,setScissorTest:vn,activeTexture:tn,bindTexture:un,unbindTexture:F,compressedTexImage2D:Ie,compressedTexImage3D:Ye,texImage2D:b,texImage3D:q,pixelStorei:oe,getParameter:de,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:P,texSubImage2D:ot,texSubImage3D:Ee,compressedTexSubImage2D:Bt,compressedTexSubImage3D:He,scissor:ye,viewport:ve,reset:ge}}function MT(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new tt,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,_=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,b){return p?new OffscreenCanvas(P,b):Sa("canvas")}function v(P,b,q){let de=1,oe=$e(P);if((oe.width>q||oe.height>q)&&(de=q/Math.max(oe.width,oe.height)),de<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ye=Math.floor(de*oe.width),ve=Math.floor(de*oe.height);d===void 0&&(d=m(ye,ve));let ne=b?m(ye,ve):d;return ne.width=ye,ne.height=ve,ne.getContext("2d").drawImage(P,0,0,ye,ve),Ze("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+ve+")."),ne}else return"data"in P&&Ze("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function A(P){return P.generateMipmaps}function M(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(P,b,q,de,oe,ye=!1){if(P!==null){if(n[P]!==void 0)return n[P];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ve;de&&(ve=e.get("EXT_texture_norm16"),ve||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=b;if(b===n.RED&&(q===n.FLOAT&&(ne=n.R32F),q===n.HALF_FLOAT&&(ne=n.R16F),q===n.UNSIGNED_BYTE&&(ne=n.R8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.R16_EXT),q===n.SHORT&&ve&&(ne=ve.R16_SNORM_EXT)),b===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.R8UI),q===n.UNSIGNED_SHORT&&(ne=n.R16UI),q===n.UNSIGNED_INT&&(ne=n.R32UI),q===n.BYTE&&(ne=n.R8I),q===n.SHORT&&(ne=n.R16I),q===n.INT&&(ne=n.R32I)),b===n.RG&&(q===n.FLOAT&&(ne=n.RG32F),q===n.HALF_FLOAT&&(ne=n.RG16F),q===n.UNSIGNED_BYTE&&(ne=n.RG8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RG16_EXT),q===n.SHORT&&ve&&(ne=ve.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RG8UI),q===n.UNSIGNED_SHORT&&(ne=n.RG16UI),q===n.UNSIGNED_INT&&(ne=n.RG32UI),q===n.BYTE&&(ne=n.RG8I),q===n.SHORT&&(ne=n.RG16I),q===n.INT&&(ne=n.RG32I)),b===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),q===n.UNSIGNED_INT&&(ne=n.RGB32UI),q===n.BYTE&&(ne=n.RGB8I),q===n.SHORT&&(ne=n.RGB16I),q===n.INT&&(ne=n.RGB32I)),b===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),q===n.UNSIGNED_INT&&(ne=n.RGBA32UI),q===n.BYTE&&(ne=n.RGBA8I),q===n.SHORT&&(ne=n.RGBA16I),q===n.INT&&(ne=n.RGBA32I)),b===n.RGB&&(q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGB16_EXT),q===n.SHORT&&ve&&(ne=ve.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),b===n.RGBA){let se=ye?Ma:bt.getTransfer(oe);q===n.FLOAT&&(ne=n.RGBA32F),q===n.HALF_FLOAT&&(ne=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ne=se===Lt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGBA16_EXT),q===n.SHORT&&ve&&(ne=ve.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function x(P,b){let q;return P?b===null||b===Hi||b===Rr?q=n.DEPTH24_STENCIL8:b===Gi?q=n.DEPTH32F_STENCIL8:b===Fo&&(q=n.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Hi||b===Rr?q=n.DEPTH_COMPONENT24:b===Gi?q=n.DEPTH_COMPONENT32F:b===Fo&&(q=n.DEPTH_COMPONENT16),q}function S(P,b){return A(P)===!0||P.isFramebufferTexture&&P.minFilter!==yn&&P.minFilter!==Jn?Math.log2(Math.max(b.width,b.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?b.mipmaps.length:1}function k(P){let b=new WeakRef(P);i.get(P).__ref=b,g.add(b),_.register(P,b,b)}function U(P){let b=i.get(P).__ref;b!==void 0&&(g.delete(b),_.unregister(b))}function D(P){X(P.target)}function G(P){I(P.target)}function X(P){P.removeEventListener("dispose",D),U(P),H(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function I(P){P.removeEventListener("dispose",G),U(P),le(P)}function V(){for(let P of g){let b=P.deref();b!==void 0&&(b.isRenderTarget===!0?I(b):X(b))}g.clear(),u.clear()}function H(P){let b=i.get(P);if(b.__webglInit===void 0)return;let q=P.source,de=f.get(q);if(de){let oe=de[b.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&B(P),Object.keys(de).length===0&&f.delete(q)}i.remove(P)}function B(P){let b=i.get(P);n.deleteTexture(b.__webglTexture);let q=P.source,de=f.get(q);delete de[b.__cacheKey],o.memory.textures--}function le(P){let b=i.get(P);b.__depthDisposeCallback&&b.__depthDisposeCallback();let q=P.depthTexture;if(q&&q.renderTarget===P&&X(q),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(b.__webglFramebuffer[oe]))for(let ye=0;ye<b.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(b.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(b.__webglFramebuffer[oe]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[oe])}else{if(Array.isArray(b.__webglFramebuffer))for(let oe=0;oe<b.__webglFramebuffer.length;oe++)n.deleteFramebuffer(b.__webglFramebuffer[oe]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let oe=0;oe<b.__webglColorRenderbuffer.length;oe++)b.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[oe]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let de=P.textures;for(let oe=0,ye=de.length;oe<ye;oe++){let ve=i.get(de[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(de[oe])}i.remove(P)}let Y=0;function j(){Y=0}function te(){return Y}function ue(P){Y=P}function fe(){let P=Y;return P>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,P}function ee(P){let b=[];return b.push(P.wrapS),b.push(P.wrapT),b.push(P.wrapR||0),b.push(P.magFilter),b.push(P.minFilter),b.push(P.anisotropy),b.push(P.internalFormat),b.push(P.format),b.push(P.type),b.push(P.generateMipmaps),b.push(P.mipmapsAutoUpdate),b.push(P.premultiplyAlpha),b.push(P.flipY),b.push(P.unpackAlignment),b.push(P.colorSpace),b.join()}function pe(P,b){let q=i.get(P);if(P.isVideoTexture&&Bt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let de=P.image;if(de===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(q,P,b);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+b)}function _e(P,b){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Vt(q,P,b);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+b)}function Re(P,b){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){Vt(q,P,b);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+b)}function we(P,b){let q=i.get(P);if(P.version>0&&q.__version!==P.version){hn(q,P,b);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+b)}let Xe={[pc]:n.REPEAT,[ss]:n.CLAMP_TO_EDGE,[mc]:n.MIRRORED_REPEAT},rt={[yn]:n.NEAREST,[L0]:n.NEAREST_MIPMAP_NEAREST,[Va]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[Hc]:n.LINEAR_MIPMAP_NEAREST,[Rs]:n.LINEAR_MIPMAP_LINEAR},Ge={[O0]:n.NEVER,[uf]:n.ALWAYS,[F0]:n.LESS,[cf]:n.LEQUAL,[B0]:n.EQUAL,[hf]:n.GEQUAL,[k0]:n.GREATER,[z0]:n.NOTEQUAL};function ft(P,b){if(b.type===Gi&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===Jn||b.magFilter===Hc||b.magFilter===Va||b.magFilter===Rs||b.minFilter===Jn||b.minFilter===Hc||b.minFilter===Va||b.minFilter===Rs)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Xe[b.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Xe[b.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Xe[b.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,rt[b.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,rt[b.minFilter]),b.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Ge[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===yn||b.minFilter!==Va&&b.minFilter!==Rs||b.type===Gi&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function ht(P,b){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,b.addEventListener("dispose",D),k(b));let de=b.source,oe=f.get(de);oe===void 0&&(oe={},f.set(de,oe));let ye=ee(b);if(ye!==P.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ye].usedTimes++;let ve=oe[P.__cacheKey];ve!==void 0&&(oe[P.__cacheKey].usedTimes--,ve.usedTimes===0&&B(b)),P.__cacheKey=ye,P.__webglTexture=oe[ye].texture}return q}function it(P,b,q){return Math.floor(Math.floor(P/q)/b)}function Zt(P,b,q,de){let ye=P.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,q,de,b.data);else{ye.sort((O,re)=>O.start-re.start);let ve=0;for(let O=1;O<ye.length;O++){let re=ye[ve],ie=ye[O],Te=re.start+re.count,xe=it(ie.start,b.width,4),Se=it(re.start,b.width,4);ie.start<=Te+1&&xe===Se&&it(ie.start+ie.count-1,b.width,4)===xe?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++ve,ye[ve]=ie)}ye.length=ve+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let O=0,re=ye.length;O<re;O++){let ie=ye[O],Te=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Se=Te%b.width,We=Math.floor(Te/b.width),Je=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,Je,ce,q,de,b.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Vt(P,b,q){let de=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(de=n.TEXTURE_3D);let oe=ht(P,b),ye=b.source;t.bindTexture(de,P.__webglTexture,n.TEXTURE0+q);let ve=i.get(ye);if(ye.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ce=bt.getPrimaries(bt.workingColorSpace),ke=b.colorSpace===Is?null:bt.getPrimaries(b.colorSpace),je=b.colorSpace===Is||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let se=v(b.image,!1,s.maxTextureSize);se=He(b,se);let ge=r.convert(b.format,b.colorSpace),O=r.convert(b.type),re=C(b.internalFormat,ge,O,b.normalized,b.colorSpace,b.isVideoTexture);ft(de,b);let ie,Te=b.mipmaps,xe=b.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,We=ye.dataReady,Je=S(b,se);if(b.isDepthTexture)re=x(b.format===Ps,b.type),Se&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,ge,O,null));else if(b.isDataTexture)if(Te.length>0){xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ie=Te[ce],xe?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,ge,O,ie.data):t.texImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,ge,O,ie.data);b.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,se.width,se.height),We&&Zt(b,se,ge,O)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,ge,O,se.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,Te[0].width,Te[0].height,se.depth);for(let ce=0,ke=Te.length;ce<ke;ce++)if(ie=Te[ce],b.format!==vi)if(ge!==null)if(xe){if(We)if(b.layerUpdates.size>0){let je=bf(ie.width,ie.height,b.format,b.type);for(let Pe of b.layerUpdates){let lt=ie.data.subarray(Pe*je/ie.data.BYTES_PER_ELEMENT,(Pe+1)*je/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Pe,ie.width,ie.height,1,ge,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,ge,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,ge,O,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ie.width,ie.height,se.depth,0,ge,O,ie.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,re,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ie=Te[ce],b.format!==vi?ge!==null?xe?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,ie.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,ge,O,ie.data):t.texImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,ge,O,ie.data)}else if(b.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,se.width,se.height,se.depth),We)if(b.layerUpdates.size>0){let ce=bf(se.width,se.height,b.format,b.type);for(let ke of b.layerUpdates){let je=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,ge,O,je)}b.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ge,O,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,ge,O,se.data);else if(b.isData3DTexture)xe?(Se&&t.texStorage3D(n.TEXTURE_3D,Je,re,se.width,se.height,se.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ge,O,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,ge,O,se.data);else if(b.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(n.TEXTURE_2D,Je,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,ke,0,ge,O,null),ce>>=1,ke>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),u.add(b),ce.onpaint=ke=>{let je=ke.changedElements;for(let Pe of u)je.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let je=n.RGBA,Pe=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Pe,lt,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Se){let ce=$e(Te[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,ke=Te.length;ce<ke;ce++)ie=Te[ce],xe?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ge,O,ie):t.texImage2D(n.TEXTURE_2D,ce,re,ge,O,ie);b.generateMipmaps=!1}else if(xe){if(Se){let ce=$e(se);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,O,se)}else t.texImage2D(n.TEXTURE_2D,0,re,ge,O,se);A(b)&&b.mipmapsAutoUpdate===!0&&M(de),ve.__version=ye.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function hn(P,b,q){if(b.image.length!==6)return;let de=ht(P,b),oe=b.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let ye=i.get(oe);if(oe.version!==ye.__version||de===!0){t.activeTexture(n.TEXTURE0+q);let ve=bt.getPrimaries(bt.workingColorSpace),ne=b.colorSpace===Is?null:bt.getPrimaries(b.colorSpace),se=b.colorSpace===Is||ve===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let ge=b.isCompressedTexture||b.image[0].isCompressedTexture,O=b.image[0]&&b.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!ge&&!O?re[Pe]=v(b.image[Pe],!0,s.maxCubemapSize):re[Pe]=O?b.image[Pe].image:b.image[Pe],re[Pe]=He(b,re[Pe]);let ie=re[0],Te=r.convert(b.format,b.colorSpace),xe=r.convert(b.type),Se=C(b.internalFormat,Te,xe,b.normalized,b.colorSpace),We=b.isVideoTexture!==!0,Je=ye.__version===void 0||de===!0,ce=oe.dataReady,ke=S(b,ie);ft(n.TEXTURE_CUBE_MAP,b);let je;if(b.isDepthTexture){if(Se=x(b.format===Ps,b.type),Je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ie.width,ie.height,0,Te,xe,null)}else if(ge){We&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ie.width,ie.height);for(let Pe=0;Pe<6;Pe++){je=re[Pe].mipmaps;for(let lt=0;lt<je.length;lt++){let Ht=je[lt];b.format!==vi?Te!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,Ht.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Ht.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Ht.width,Ht.height,Te,xe,Ht.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Se,Ht.width,Ht.height,0,Te,xe,Ht.data)}}}else{if(je=b.mipmaps,We&&Je){je.length>0&&ke++;let Pe=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Te,xe,re[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,re[Pe].width,re[Pe].height,0,Te,xe,re[Pe].data);for(let lt=0;lt<je.length;lt++){let Gn=je[lt].image[Pe].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Gn.width,Gn.height,Te,xe,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,Gn.width,Gn.height,0,Te,xe,Gn.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,xe,re[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,xe,re[Pe]);for(let lt=0;lt<je.length;lt++){let Ht=je[lt];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Te,xe,Ht.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Se,Te,xe,Ht.image[Pe])}}}A(b)&&b.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,b.onUpdate&&b.onUpdate(b)}P.__version=b.version}function Ot(P,b,q,de,oe,ye){let ve=r.convert(q.format,q.colorSpace),ne=r.convert(q.type),se=C(q.internalFormat,ve,ne,q.normalized,q.colorSpace),ge=i.get(b),O=i.get(q);if(O.__renderTarget=b,!ge.__hasExternalTextures){let re=Math.max(1,b.width>>ye),ie=Math.max(1,b.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,se,re,ie,b.depth,0,ve,ne,null):t.texImage2D(oe,ye,se,re,ie,0,ve,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),Ee(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,oe,O.__webglTexture,0,ot(b)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,oe,O.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function An(P,b,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),b.depthBuffer){let de=b.depthTexture,oe=de&&de.isDepthTexture?de.type:null,ye=x(b.stencilBuffer,oe),ve=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(b),ye,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(b),ye,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,ye,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,P)}else{let de=b.textures;for(let oe=0;oe<de.length;oe++){let ye=de[oe],ve=r.convert(ye.format,ye.colorSpace),ne=r.convert(ye.type),se=C(ye.internalFormat,ve,ne,ye.normalized,ye.colorSpace);Ee(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(b),se,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(b),se,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,se,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(P,b,q){let de=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(b.depthTexture);oe.__renderTarget=b;let ye=de?b.depthTexture.image[0]:b.depthTexture.image;(!oe.__webglTexture||ye.width!==b.width||ye.height!==b.height)&&(ye.width=b.width,ye.height=b.height,b.depthTexture.needsUpdate=!0),de?we(b.depthTexture,0):pe(b.depthTexture,0);let ve=oe.__webglTexture,ne=ot(b),se=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ge=b.depthTexture.format===Ps?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===Es)Ee(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,se,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,se,ve,0);else if(b.depthTexture.format===Ps)Ee(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,se,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,se,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vn(P){let b=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==P.depthTexture){let de=P.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),de){let oe=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,de.removeEventListener("dispose",oe)};de.addEventListener("dispose",oe),b.__depthDisposeCallback=oe}b.__boundDepthTexture=de}if(P.depthTexture&&!b.__autoAllocateDepthBuffer)if(q)for(let de=0;de<6;de++)Mt(b.__webglFramebuffer[de],P,de);else P.texture.mipmaps.length>0?Mt(b.__webglFramebuffer[0],P,0):Mt(b.__webglFramebuffer,P,0);else if(q){b.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[de]),b.__webglDepthbuffer[de]===void 0)b.__webglDepthbuffer[de]=n.createRenderbuffer(),An(b.__webglDepthbuffer[de],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),An(b.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function tn(P,b,q){let de=i.get(P);b!==void 0&&Ot(de.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&vn(P)}function un(P){let b=P.texture,q=i.get(P),de=i.get(b);P.addEventListener("dispose",G),k(P);let oe=P.textures,ye=P.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=b.version,o.memory.textures++),ye){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(b.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let se=0;se<b.mipmaps.length;se++)q.__webglFramebuffer[ne][se]=n.createFramebuffer()}else q.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(b.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<b.mipmaps.length;ne++)q.__webglFramebuffer[ne]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ne=0,se=oe.length;ne<se;ne++){let ge=i.get(oe[ne]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Ee(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let se=oe[ne];q.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let ge=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=C(se.internalFormat,ge,O,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ie=ot(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),An(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),ft(n.TEXTURE_CUBE_MAP,b);for(let ne=0;ne<6;ne++)if(b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)Ot(q.__webglFramebuffer[ne][se],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Ot(q.__webglFramebuffer[ne],P,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);A(b)?M(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ne=0,se=oe.length;ne<se;ne++){let ge=oe[ne],O=i.get(ge),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ft(re,ge),Ot(q.__webglFramebuffer,P,ge,n.COLOR_ATTACHMENT0+ne,re,0),A(ge)&&M(re)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ne=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,de.__webglTexture),ft(ne,b),b.mipmaps.length>0)for(let se=0;se<b.mipmaps.length;se++)Ot(q.__webglFramebuffer[se],P,b,n.COLOR_ATTACHMENT0,ne,se);else Ot(q.__webglFramebuffer,P,b,n.COLOR_ATTACHMENT0,ne,0);A(b)?M(ne):b.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&vn(P)}function F(P){let b=P.textures;for(let q=0,de=b.length;q<de;q++){let oe=b[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let ye=R(P),ve=i.get(oe).__webglTexture;t.bindTexture(ye,ve),M(ye),t.unbindTexture()}}}let Ie=[];function Ye(P){if(P.samples>0){if(Ee(P)===!1){let b=P.textures,q=P.width,de=P.height,oe=n.COLOR_BUFFER_BIT,ye=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(P),ne=b.length>1;if(ne)for(let ge=0;ge<b.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let ge=0;ge<b.length;ge++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[ge]);let O=i.get(b[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,de,0,0,q,de,oe,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+ge),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Ie.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let ge=0;ge<b.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,ve.__webglColorRenderbuffer[ge]);let O=i.get(b[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let b=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function ot(P){return Math.min(s.maxSamples,P.samples)}function Ee(P){let b=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Bt(P){let b=o.render.frame;h.get(P)!==b&&(h.set(P,b),P.update())}function He(P,b){let q=P.colorSpace,de=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==ba&&q!==Is&&(bt.getTransfer(q)===Lt?(de!==vi||oe!==si)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",q)),b}function $e(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=ue,this.setTexture2D=pe,this.setTexture2DArray=_e,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=tn,this.setupRenderTarget=un,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=vn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Ee,this.dispose=V}function ST(n,e){function t(i,s=Is){let r,o=bt.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===Wc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Xc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===sf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===rf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===tf)return n.BYTE;if(i===nf)return n.SHORT;if(i===Fo)return n.UNSIGNED_SHORT;if(i===Gc)return n.INT;if(i===Hi)return n.UNSIGNED_INT;if(i===Gi)return n.FLOAT;if(i===Wi)return n.HALF_FLOAT;if(i===of)return n.ALPHA;if(i===af)return n.RGB;if(i===vi)return n.RGBA;if(i===Es)return n.DEPTH_COMPONENT;if(i===Ps)return n.DEPTH_STENCIL;if(i===lf)return n.RED;if(i===qc)return n.RED_INTEGER;if(i===sr)return n.RG;if(i===$c)return n.RG_INTEGER;if(i===Yc)return n.RGBA_INTEGER;if(i===Ha||i===Ga||i===Wa||i===Xa)if(o===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ha)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ha)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ga)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Wa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Xa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Zc||i===Kc||i===Jc||i===jc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===jc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qc||i===eh||i===th||i===nh||i===ih||i===qa||i===sh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qc||i===eh)return o===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===th)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===nh)return r.COMPRESSED_R11_EAC;if(i===ih)return r.COMPRESSED_SIGNED_R11_EAC;if(i===qa)return r.COMPRESSED_RG11_EAC;if(i===sh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===rh||i===oh||i===ah||i===lh||i===ch||i===hh||i===uh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===rh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===oh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ah)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===lh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ch)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===hh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===uh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===dh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ph)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===mh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===gh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===_h)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===xh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===yh||i===vh||i===bh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===yh)return o===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Mh||i===Sh||i===$a||i===wh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Mh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Sh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===$a)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===wh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Rr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var wT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ET=`
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

}`,Pf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new La(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new rs({vertexShader:wT,fragmentShader:ET,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ni(new Er(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},If=class extends Vi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,_=typeof XRWebGLBinding<"u",p=new Pf,m={},v=t.getContextAttributes(),A=null,M=null,R=[],C=[],x=new tt,S=null,k=null,U=new Kn;U.viewport=new Jt;let D=new Kn;D.viewport=new Jt;let G=[U,D],X=new Bc,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let pe=R[ee];return pe===void 0&&(pe=new Ao,R[ee]=pe),pe.getTargetRaySpace()},this.getControllerGrip=function(ee){let pe=R[ee];return pe===void 0&&(pe=new Ao,R[ee]=pe),pe.getGripSpace()},this.getHand=function(ee){let pe=R[ee];return pe===void 0&&(pe=new Ao,R[ee]=pe),pe.getHandSpace()};function H(ee){let pe=C.indexOf(ee.inputSource);if(pe===-1)return;let _e=R[pe];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,c||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function B(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<R.length;ee++){let pe=C[ee];pe!==null&&(C[ee]=null,R[ee].disconnect(pe))}I=null,V=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),f=null,d=null,u=null,s=null,M=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(S),e.setSize(x.width,x.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",B),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Re=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?Ps:Es,Re=v.stencil?Rr:Hi);let Xe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new _i(d.textureWidth,d.textureHeight,{format:vi,type:si,depthTexture:new Cs(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new _i(f.framebufferWidth,f.framebufferHeight,{format:vi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(ee){for(let pe=0;pe<ee.removed.length;pe++){let _e=ee.removed[pe],Re=C.indexOf(_e);Re>=0&&(C[Re]=null,R[Re].disconnect(_e))}for(let pe=0;pe<ee.added.length;pe++){let _e=ee.added[pe],Re=C.indexOf(_e);if(Re===-1){for(let Xe=0;Xe<R.length;Xe++)if(Xe>=C.length){C.push(_e),Re=Xe;break}else if(C[Xe]===null){C[Xe]=_e,Re=Xe;break}if(Re===-1)break}let we=R[Re];we&&we.connect(_e)}}function Y(ee,pe){pe===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(pe.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let pe=ee.near,_e=ee.far;p.texture!==null&&(p.depthNear>0&&(pe=p.depthNear),p.depthFar>0&&(_e=p.depthFar)),X.near=D.near=U.near=pe,X.far=D.far=U.far=_e,(I!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),I=X.near,V=X.far),X.layers.mask=ee.layers.mask|6,U.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let Re=ee.parent,we=X.cameras;Y(X,Re);for(let Xe=0;Xe<we.length;Xe++)Y(we[Xe],Re);X.projectionMatrix.copy(U.projectionMatrix),X.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,X,Re)};function j(ee,pe,_e){_e===null?ee.matrix.copy(pe.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(pe.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(pe.projectionMatrix),ee.projectionMatrixInverse.copy(pe.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Eo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(X)},this.getCameraTexture=function(ee){return m[ee]};let te=null;function ue(ee,pe){if(h=pe.getViewerPose(c||o),g=pe,h!==null){let _e=h.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Re=!1;_e.length!==X.cameras.length&&(X.cameras.length=0,Re=!0);for(let Ge=0;Ge<_e.length;Ge++){let ft=_e[Ge],ht=null;if(f!==null)ht=f.getViewport(ft);else{let Zt=u.getViewSubImage(d,ft);ht=Zt.viewport,Ge===0&&(e.setRenderTargetTextures(M,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(M))}let it=G[Ge];it===void 0&&(it=new Kn,it.layers.enable(Ge),it.viewport=new Jt,G[Ge]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ht.x,ht.y,ht.width,ht.height),Ge===0&&(X.matrix.copy(it.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Re===!0&&X.cameras.push(it)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=i.getBinding();let Ge=u.getDepthInformation(_e[0]);Ge&&Ge.isValid&&Ge.texture&&p.init(Ge,s.renderState)}if(we&&we.includes("camera-access")&&_){e.state.unbindTexture(),u=i.getBinding();for(let Ge=0;Ge<_e.length;Ge++){let ft=_e[Ge].camera;if(ft){let ht=m[ft];ht||(ht=new La,m[ft]=ht);let it=u.getCameraImage(ft);ht.sourceTexture=it}}}}for(let _e=0;_e<R.length;_e++){let Re=C[_e],we=R[_e];Re!==null&&we!==void 0&&we.update(Re,pe,c||o)}te&&te(ee,pe),pe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:pe}),g=null}let fe=new y_;fe.setAnimationLoop(ue),this.setAnimationLoop=function(ee){te=ee},this.dispose=function(){}}},TT=new Yt,R_=new nt;R_.set(-1,0,0,0,1,0,0,0,1);function AT(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,xf(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,A,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,M)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),_(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,A):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===jn&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===jn&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),A=v.envMap,M=v.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(TT.makeRotationFromEuler(M)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(R_),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,A){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=A*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===jn&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function _(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function CT(n,e,t,i){let s={},r={};function o(v,A){let M=A.program;i.uniformBlockBinding(v,M,s[v.id])}function a(v,A){let M=s[v.id];M===void 0&&(g(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",p));let R=A.program;i.updateUBOMapping(v,R);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let A=n.createBuffer(),M=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],M=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,x=M.length;C<x;C++){let S=M[C];if(Array.isArray(S))for(let k=0,U=S.length;k<U;k++)h(S[k],C,k,R);else h(S,C,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,A,M,R){if(d(v,A,M,R)===!0){let C=v.__offset,x=v.value;if(Array.isArray(x)){let S=0;for(let k=0;k<x.length;k++){let U=x[k],D=_(U,!0);u(U,v.__data,S),S+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,v.__data)}}function u(v,A,M){typeof v=="number"||typeof v=="boolean"?A[M]=v:v.isMatrix3?(A[M]=v.elements[0],A[M+1]=v.elements[1],A[M+2]=v.elements[2],A[M+3]=0,A[M+4]=v.elements[3],A[M+5]=v.elements[4],A[M+6]=v.elements[5],A[M+7]=0,A[M+8]=v.elements[6],A[M+9]=v.elements[7],A[M+10]=v.elements[8],A[M+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-M),M):v.toArray(A,M)}function d(v,A,M,R){let C=v.value,x=A+"_"+M;if(Array.isArray(C)){R[x]===void 0&&(R[x]=[]);let S=R[x],k=!1;for(let U=0;U<C.length;U++)f(C[U],S,U)===!0&&(k=!0);return k}return f(C,R,x)}function f(v,A,M){if(A[M]===void 0)return typeof v=="number"||typeof v=="boolean"?A[M]=v:ArrayBuffer.isView(v)?A[M]=v.slice():A[M]=v.clone(),!0;{let R=A[M];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return A[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function g(v){let A=v.uniforms,M=0,R=16;for(let x=0,S=A.length;x<S;x++){let k=Array.isArray(A[x])?A[x]:[A[x]];for(let U=0,D=k.length;U<D;U++){let G=k[U],X=Array.isArray(G.value)?G.value:[G.value],I=Array.isArray(A[x])||Array.isArray(G.value),V=M;for(let B=0,le=X.length;B<le;B++){let Y=X[B],j=_(Y,I),te=M%R,ue=te%j.boundary,fe=te+ue;M+=ue,fe!==0&&R-fe<j.storage&&(M+=R-fe),B===0&&(V=M),M+=j.storage}let H=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new H((M-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let C=M%R;return C>0&&(M+=R-C),v.__size=M,v.__cache={},this}function _(v,A){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(v){let A=v.target;A.removeEventListener("dispose",p),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var RT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function PT(){return as===null&&(as=new Co(RT,16,16,sr,Wi),as.name="DFG_LUT",as.minFilter=Jn,as.magFilter=Jn,as.wrapS=ss,as.wrapT=ss,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Rh=class{constructor(e={}){let{canvas:t=H0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=si}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=f,p=new Set([Yc,$c,qc]),m=new Set([si,Hi,Fo,Rr,Wc,Xc]),v=new Uint32Array(4),A=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,C=null,x=[],S=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,G=null,X=null,I=null,V=null;this._outputColorSpace=Dn;let H=0,B=0,le=null,Y=-1,j=null,te=new Jt,ue=new Jt,fe=null,ee=new ct(0),pe=0,_e=t.width,Re=t.height,we=1,Xe=null,rt=null,Ge=new Jt(0,0,_e,Re),ft=new Jt(0,0,_e,Re),ht=!1,it=new Js,Zt=new vc,Vt=!1,hn=!1,Ot=new Yt,An=new Z,Mt=new Jt,vn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function un(){return le===null?we:1}let F=i;function Ie(E,z){return t.getContext(E,z)}let Ye,ot,Ee,Bt,He,$e,P,b,q,de,oe,ye,ve,ne,se,ge,O,re,ie,Te,xe,Se,We;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),F===null){let z="webgl2";if(F=Ie(z,E),F===null)throw Ie(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(E){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),et("WebGLRenderer: "+E.message),E}function Je(){Ye=new V1(F),Ye.init(),xe=new ST(F,Ye),ot=new P1(F,Ye,e,xe),Ee=new bT(F,Ye),ot.reversedDepthBuffer&&d&&Ee.buffers.depth.setReversed(!0),X=F.createFramebuffer(),I=F.createFramebuffer(),V=F.createFramebuffer(),Bt=new W1(F),He=new aT,$e=new MT(F,Ye,Ee,He,ot,xe,Bt),P=new z1(U),b=new qM(F),Se=new C1(F,b),q=new H1(F,b,Bt,Se),de=new q1(F,q,b,Se,Bt),re=new X1(F,ot,$e),se=new I1(He),oe=new oT(U,P,Ye,ot,Se,se),ye=new AT(U,He),ve=new cT,ne=new mT(Ye),O=new A1(U,P,Ee,de,g,l),ge=new vT(U,de,ot),We=new CT(F,Bt,ot,Ee),ie=new R1(F,Ye,Bt),Te=new G1(F,Ye,Bt),Bt.programs=oe.programs,U.capabilities=ot,U.extensions=Ye,U.properties=He,U.renderLists=ve,U.shadowMap=ge,U.state=Ee,U.info=Bt}_!==si&&(k=new Y1(_,t.width,t.height,a,s,r));let ce=new If(U,F);this.xr=ce,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=Ye.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ye.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(_e,Re,!1))},this.getSize=function(E){return E.set(_e,Re)},this.setSize=function(E,z,Q=!0){if(ce.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=E,Re=z,t.width=Math.floor(E*we),t.height=Math.floor(z*we),Q===!0&&(t.style.width=E+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(_e*we,Re*we).floor()},this.setDrawingBufferSize=function(E,z,Q){_e=E,Re=z,we=Q,t.width=Math.floor(E*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(_===si){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(te)},this.getViewport=function(E){return E.copy(Ge)},this.setViewport=function(E,z,Q,$){E.isVector4?Ge.set(E.x,E.y,E.z,E.w):Ge.set(E,z,Q,$),Ee.viewport(te.copy(Ge).multiplyScalar(un()).round())},this.getScissor=function(E){return E.copy(ft)},this.setScissor=function(E,z,Q,$){E.isVector4?ft.set(E.x,E.y,E.z,E.w):ft.set(E,z,Q,$),Ee.scissor(ue.copy(ft).multiplyScalar(un()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(E){Ee.setScissorTest(ht=E)},this.setOpaqueSort=function(E){Xe=E},this.setTransparentSort=function(E){rt=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,Q=!0){let $=0;if(E){let K=!1;if(le!==null){let Ae=le.texture.format;K=p.has(Ae)}if(K){let Ae=le.texture.type,Le=m.has(Ae),Ce=O.getClearColor(),De=O.getClearAlpha(),Ve=Ce.r,Qe=Ce.g,pt=Ce.b;Le?(v[0]=Ve,v[1]=Qe,v[2]=pt,v[3]=De,F.clearBufferuiv(F.COLOR,0,v)):(A[0]=Ve,A[1]=Qe,A[2]=pt,A[3]=De,F.clearBufferiv(F.COLOR,0,A))}else $|=F.COLOR_BUFFER_BIT}z&&($|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&($|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&F.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),G=E},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),ve.dispose(),ne.dispose(),$e.dispose(),He.dispose(),P.dispose(),de.dispose(),q.dispose(),Se.dispose(),We.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",el),ce.removeEventListener("sessionend",Xi),cs.stop()};function ke(E){E.preventDefault(),ff("WebGLRenderer: Context Lost."),D=!0}function je(){ff("WebGLRenderer: Context Restored."),D=!1;let E=Bt.autoReset,z=ge.enabled,Q=ge.autoUpdate,$=ge.needsUpdate,K=ge.type;Je(),Bt.autoReset=E,ge.enabled=z,ge.autoUpdate=Q,ge.needsUpdate=$,ge.type=K}function Pe(E){et("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let z=E.target;z.removeEventListener("dispose",lt),Ht(z)}function Ht(E){Gn(E),He.remove(E)}function Gn(E){let z=He.get(E).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),E.isShaderMaterial&&oe.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,Q,$,K,Ae){z===null&&(z=vn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ce=Wo(E,z,Q,$,K);Ee.setMaterial($,Le);let De=Q.index,Ve=1;if($.wireframe===!0){if(De=q.getWireframeAttribute(Q),De===void 0)return;Ve=2}let Qe=Q.drawRange,pt=Q.attributes.position,ze=Qe.start*Ve,mt=(Qe.start+Qe.count)*Ve;Ae!==null&&(ze=Math.max(ze,Ae.start*Ve),mt=Math.min(mt,(Ae.start+Ae.count)*Ve)),De!==null?(ze=Math.max(ze,0),mt=Math.min(mt,De.count)):pt!=null&&(ze=Math.max(ze,0),mt=Math.min(mt,pt.count));let jt=mt-ze;if(jt<0||jt===1/0)return;Se.setup(K,$,Ce,Q,De);let Dt,Nt=ie;if(De!==null&&(Dt=b.get(De),Nt=Te,Nt.setIndex(Dt)),K.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*un()),Nt.setMode(F.LINES)):Nt.setMode(F.TRIANGLES);else if(K.isLine){let bn=$.linewidth;bn===void 0&&(bn=1),Ee.setLineWidth(bn*un()),K.isLineSegments?Nt.setMode(F.LINES):K.isLineLoop?Nt.setMode(F.LINE_LOOP):Nt.setMode(F.LINE_STRIP)}else K.isPoints?Nt.setMode(F.POINTS):K.isSprite&&Nt.setMode(F.TRIANGLES);if(K.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Nt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let bn=K._multiDrawStarts,Fe=K._multiDrawCounts,dn=K._multiDrawCount,xt=De?b.get(De).bytesPerElement:1,us=He.get($).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)us.setValue(F,"_gl_DrawID",fn),Nt.render(bn[fn]/xt,Fe[fn])}else if(K.isInstancedMesh)Nt.renderInstances(ze,jt,K.count);else if(Q.isInstancedBufferGeometry){let bn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,bn);Nt.renderInstances(ze,jt,Fe)}else Nt.render(ze,jt)};function Vo(E,z,Q,$){G!==null&&E.isNodeMaterial&&G.setObject($,E),Vt===!0&&se.setState(E,Q,!1),E.transparent===!0&&E.side===ii&&E.forceSinglePass===!1?(E.side=jn,E.needsUpdate=!0,qi(E,z,$),E.side=ir,E.needsUpdate=!0,qi(E,z,$),E.side=ii):qi(E,z,$)}this.compile=function(E,z,Q=null){Q===null&&(Q=E),G!==null&&G.renderStart(E,z,Q),C=ne.get(Q),C.init(z),S.push(C),Q.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),E!==Q&&E.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),C.setupLights(),G!==null&&G.updateLights(C.state.lightsArray),hn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,hn),Vt===!0&&se.setGlobalState(this.clippingPlanes,z),G!==null&&ge.render(C.state.shadowsArray,Q,z);let $=new Set;return E.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ae=K.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Ce=Ae[Le];Vo(Ce,Q,z,K),$.add(Ce)}else Vo(Ae,Q,z,K),$.add(Ae)}),C=S.pop(),G!==null&&G.renderEnd(),$},this.compileAsync=function(E,z,Q=null){let $=this.compile(E,z,Q);return new Promise(K=>{function Ae(){if($.forEach(function(Le){let De=He.get(Le).currentProgram;(De===void 0||De.isReady())&&$.delete(Le)}),$.size===0){K(E);return}setTimeout(Ae,10)}Ye.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Ir=null;function Hh(E){Ir&&Ir(E)}function el(){cs.stop()}function Xi(){cs.start()}let cs=new y_;cs.setAnimationLoop(Hh),typeof self<"u"&&cs.setContext(self),this.setAnimationLoop=function(E){Ir=E,ce.setAnimationLoop(E),E===null?cs.stop():cs.start()},ce.addEventListener("sessionstart",el),ce.addEventListener("sessionend",Xi),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(E,z);let Q=ce.enabled===!0&&ce.isPresenting===!0,$=k!==null&&(le===null||Q)&&k.begin(U,le);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),E.isScene===!0&&E.onBeforeRender(U,E,z,le),C=ne.get(E,S.length),C.init(z),C.state.textureUnits=$e.getTextureUnits(),S.push(C),Ot.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Zt.setFromArrayCamera(z):it.setFromProjectionMatrix(Ot,Pi,z.reversedDepth),hn=this.localClippingEnabled,Vt=se.init(this.clippingPlanes,hn),R=ve.get(E,x.length),R.init(),x.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=U.xr.getDepthSensingMesh();Le!==null&&hs(Le,z,-1/0,U.sortObjects)}hs(E,z,0,U.sortObjects),R.finish(),G!==null&&G.updateLights(C.state.lightsArray),U.sortObjects===!0&&R.sort(Xe,rt),tn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,tn&&O.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&se.beginShadows();let K=C.state.shadowsArray;if(ge.render(K,E,z),Vt===!0&&se.endShadows(),($&&k.hasRenderPass())===!1){let Le=R.opaque,Ce=R.transmissive;if(C.setupLights(),z.isArrayCamera){let De=z.cameras;if(Ce.length>0)for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];Ii(Le,Ce,E,pt)}tn&&O.render(E);for(let Ve=0,Qe=De.length;Ve<Qe;Ve++){let pt=De[Ve];Ho(R,E,pt,pt.viewport)}}else Ce.length>0&&Ii(Le,Ce,E,z),tn&&O.render(E),Ho(R,E,z)}le!==null&&B===0&&($e.updateMultisampleRenderTarget(le),$e.updateRenderTargetMipmap(le)),$&&k.end(U),E.isScene===!0&&E.onAfterRender(U,E,z),Se.resetDefaultState(),Y=-1,j=null,S.pop(),S.length>0?(C=S[S.length-1],$e.setTextureUnits(C.state.textureUnits),Vt===!0&&se.setGlobalState(U.clippingPlanes,C.state.camera)):C=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,G!==null&&G.renderEnd()};function hs(E,z,Q,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)Q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)C.pushLight(E),E.castShadow&&C.pushShadow(E);else if(E.isSprite){let Le=z.isArrayCamera?Zt:it;if(!E.frustumCulled||E.intersectsFrustum(Le)){$&&Mt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ot);let Ce=de.update(E),De=E.material;De.visible&&R.push(E,Ce,De,Q,Mt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Le=z.isArrayCamera?Zt:it;if(!E.frustumCulled||E.intersectsFrustum(Le)){let Ce=de.update(E),De=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Mt.copy(E.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Mt.copy(Ce.boundingSphere.center)),Mt.applyMatrix4(E.matrixWorld).applyMatrix4(Ot)),Array.isArray(De)){let Ve=Ce.groups;for(let Qe=0,pt=Ve.length;Qe<pt;Qe++){let ze=Ve[Qe],mt=De[ze.materialIndex];mt&&mt.visible&&R.push(E,Ce,mt,Q,Mt.z,ze,z)}}else De.visible&&R.push(E,Ce,De,Q,Mt.z,null,z)}}}let Ae=E.children;for(let Le=0,Ce=Ae.length;Le<Ce;Le++)hs(Ae[Le],z,Q,$)}function Ho(E,z,Q,$){let{opaque:K,transmissive:Ae,transparent:Le}=E;C.setupLightsView(Q),Vt===!0&&se.setGlobalState(U.clippingPlanes,Q),$&&Ee.viewport(te.copy($)),K.length>0&&nn(K,z,Q),Ae.length>0&&nn(Ae,z,Q),Le.length>0&&nn(Le,z,Q),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ii(E,z,Q,$){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[$.id]===void 0){let ze=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[$.id]=new _i(1,1,{generateMipmaps:!0,type:ze?Wi:si,minFilter:Rs,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Ae=C.state.transmissionRenderTarget[$.id],Le=$.viewport||te;Ae.setSize(Le.z*U.transmissionResolutionScale,Le.w*U.transmissionResolutionScale);let Ce=U.getRenderTarget(),De=U.getActiveCubeFace(),Ve=U.getActiveMipmapLevel();U.setRenderTarget(Ae),U.getClearColor(ee),pe=U.getClearAlpha(),pe<1&&U.setClearColor(16777215,.5),U.clear(),tn&&O.render(Q);let Qe=U.toneMapping;U.toneMapping=os;let pt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),C.setupLightsView($),Vt===!0&&se.setGlobalState(U.clippingPlanes,$),nn(E,Q,$),$e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let mt=0,jt=z.length;mt<jt;mt++){let Dt=z[mt],{object:Nt,geometry:bn,material:Fe,group:dn}=Dt;if(Fe.side===ii&&Nt.layers.test($.layers)){let xt=Fe.side;Fe.side=jn,Fe.needsUpdate=!0,ln(Nt,Q,$,bn,Fe,dn),Fe.side=xt,Fe.needsUpdate=!0,ze=!0}}ze===!0&&($e.updateMultisampleRenderTarget(Ae),$e.updateRenderTargetMipmap(Ae))}U.setRenderTarget(Ce,De,Ve),U.setClearColor(ee,pe),pt!==void 0&&($.viewport=pt),U.toneMapping=Qe}function nn(E,z,Q){let $=z.isScene===!0?z.overrideMaterial:null;for(let K=0,Ae=E.length;K<Ae;K++){let Le=E[K],{object:Ce,geometry:De,group:Ve}=Le,Qe=Le.material;Qe.allowOverride===!0&&$!==null&&(Qe=$),Ce.layers.test(Q.layers)&&ln(Ce,z,Q,De,Qe,Ve)}}function ln(E,z,Q,$,K,Ae){G!==null&&K.isNodeMaterial&&G.setObject(E,K),E.onBeforeRender(U,z,Q,$,K,Ae),E.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),K.onBeforeRender(U,z,Q,$,E,Ae),K.transparent===!0&&K.side===ii&&K.forceSinglePass===!1?(K.side=jn,K.needsUpdate=!0,U.renderBufferDirect(Q,z,$,K,E,Ae),K.side=ir,K.needsUpdate=!0,U.renderBufferDirect(Q,z,$,K,E,Ae),K.side=ii):U.renderBufferDirect(Q,z,$,K,E,Ae),E.onAfterRender(U,z,Q,$,K,Ae)}function cn(E){let z=0;for(let Q of E)Q.texture!==null&&z++;return z}function qi(E,z,Q){z.isScene!==!0&&(z=vn);let $=He.get(E),K=C.state.lights,Ae=C.state.shadowsArray,Le=K.state.version,Ce=oe.getParameters(E,K.state,Ae,z,Q,C.state.lightProbeGridArray),De=oe.getProgramCacheKey(Ce),Ve=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let Qe=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=P.get(E.envMap||$.environment,Qe),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,Ve===void 0&&(E.addEventListener("dispose",lt),Ve=new Map,$.programs=Ve,$.programVariants=new Map);let pt=Ve.get(De);if(pt!==void 0){if($.currentProgram===pt&&$.lightsStateVersion===Le)return Go(E,Ce),pt}else Ce.uniforms=oe.getUniforms(E),G!==null&&E.isNodeMaterial&&G.build(E,Q,Ce),E.onBeforeCompile(Ce,U),pt=oe.acquireProgram(Ce,De),Ve.set(De,pt),$.uniforms=Ce.uniforms;let ze=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ze.clippingPlanes=se.uniform),Go(E,Ce),$.needsLights=Ds(E),$.lightsStateVersion=Le,$.needsLights&&(ze.ambientLightColor.value=K.state.ambient,ze.lightProbe.value=K.state.probe,ze.sunLights.value=K.state.sun,ze.sunLightShadows.value=K.state.sunShadow,ze.directionalLights.value=K.state.directional,ze.directionalLightShadows.value=K.state.directionalShadow,ze.spotLights.value=K.state.spot,ze.spotLightShadows.value=K.state.spotShadow,ze.rectAreaLights.value=K.state.rectArea,ze.ltc_1.value=K.state.rectAreaLTC1,ze.ltc_2.value=K.state.rectAreaLTC2,ze.pointLights.value=K.state.point,ze.pointLightShadows.value=K.state.pointShadow,ze.hemisphereLights.value=K.state.hemi,ze.sunShadowMatrix.value=K.state.sunShadowMatrix,ze.sunShadowCascade.value=K.state.sunShadowCascade,ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,ze.spotLightMatrix.value=K.state.spotLightMatrix,ze.spotLightMap.value=K.state.spotLightMap,ze.pointShadowMatrix.value=K.state.pointShadowMatrix),$.numLightProbeGrids=cn(C.state.lightProbeGridArray),$.currentProgram=pt,$.uniformsList=null,pt}function oi(E,z,Q,$,K){let Ae=He.get(E),Le=Ae.currentProgram.id+","+$+","+K,Ce=Ae.programVariants.get(Le);return Ce===void 0?(Ce=qi(E,z,Q),Ae.programVariants.set(Le,Ce)):(Ae.currentProgram=Ce,Ae.uniformsList=null,Ae.outputColorSpace=$,Ae.toneMapping=K),Ce}function Ls(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=ko.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function Go(E,z){let Q=He.get(E);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Wo(E,z,Q,$,K){z.isScene!==!0&&(z=vn),$e.resetTextureUnits();let Ae=z.fog,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Ce=le===null?U.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:bt.workingColorSpace,De=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ve=P.get($.envMap||Le,De),Qe=$.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,pt=!!Q.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ze=!!Q.morphAttributes.position,mt=!!Q.morphAttributes.normal,jt=!!Q.morphAttributes.color,Dt=os;$.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Dt=U.toneMapping);let Nt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,bn=Nt!==void 0?Nt.length:0,Fe=He.get($),dn=C.state.lights;if(Vt===!0&&(hn===!0||E!==j)){let Ut=E===j&&$.id===Y;se.setState($,E,Ut)}let xt=!1,us=!1;$.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==dn.state.version||K.isBatchedMesh&&Fe.batching===!1||!K.isBatchedMesh&&Fe.batching===!0||K.isBatchedMesh&&Fe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Fe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Fe.instancing===!1||!K.isInstancedMesh&&Fe.instancing===!0||K.isSkinnedMesh&&Fe.skinning===!1||!K.isSkinnedMesh&&Fe.skinning===!0||K.isInstancedMesh&&Fe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Fe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Fe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Fe.instancingMorph===!1&&K.morphTexture!==null||Fe.envMap!==Ve||$.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==pt||Fe.morphTargets!==ze||Fe.morphNormals!==mt||Fe.morphColors!==jt||Fe.morphTargetsCount!==bn||Fe.numLightProbeGrids!==cn(C.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Ce||Fe.toneMapping!==Dt)&&(us=!0):(xt=!0,Fe.__version=$.version);let fn=Fe.currentProgram;(xt===!0||us===!0)&&(fn=us===!0?oi($,z,K,Ce,Dt):qi($,z,K),G&&$.isNodeMaterial&&G.onUpdateProgram($,fn,Fe));let Nr=!1,$i=!1,ds=!1,ut=fn.getUniforms(),sn=Fe.uniforms;if(Ee.useProgram(fn.program)&&(Nr=!0,$i=!0,ds=!0),$.id!==Y&&(Y=$.id,$i=!0),Nr||j!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(F,"projectionMatrix",E.projectionMatrix),ut.setValue(F,"viewMatrix",E.matrixWorldInverse);let pn=ut.map.cameraPosition;pn!==void 0&&pn.setValue(F,An.setFromMatrixPosition(E.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ut.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),j!==E&&(j=E,$i=!0,ds=!0)}if(Fe.needsLights&&(dn.state.sunShadowMap.length>0&&ut.setValue(F,"sunShadowMap",dn.state.sunShadowMap,$e),dn.state.directionalShadowMap.length>0&&ut.setValue(F,"directionalShadowMap",dn.state.directionalShadowMap,$e),dn.state.spotShadowMap.length>0&&ut.setValue(F,"spotShadowMap",dn.state.spotShadowMap,$e),dn.state.pointShadowMap.length>0&&ut.setValue(F,"pointShadowMap",dn.state.pointShadowMap,$e)),K.isSkinnedMesh){ut.setOptional(F,K,"bindMatrix"),ut.setOptional(F,K,"bindMatrixInverse");let Ut=K.skeleton;Ut&&(Ut.boneTexture===null&&Ut.computeBoneTexture(),ut.setValue(F,"boneTexture",Ut.boneTexture,$e))}K.isBatchedMesh&&(ut.setOptional(F,K,"batchingTexture"),ut.setValue(F,"batchingTexture",K._matricesTexture,$e),ut.setOptional(F,K,"batchingIdTexture"),ut.setValue(F,"batchingIdTexture",K._indirectTexture,$e),ut.setOptional(F,K,"batchingColorTexture"),K._colorsTexture!==null&&ut.setValue(F,"batchingColorTexture",K._colorsTexture,$e));let Wn=Q.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&re.update(K,Q,fn),($i||Fe.receiveShadow!==K.receiveShadow)&&(Fe.receiveShadow=K.receiveShadow,ut.setValue(F,"receiveShadow",K.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(sn.envMapIntensity.value=z.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=PT()),$i){if(ut.setValue(F,"toneMappingExposure",U.toneMappingExposure),Fe.needsLights&&Lr(sn,ds),Ae&&$.fog===!0&&ye.refreshFogUniforms(sn,Ae),ye.refreshMaterialUniforms(sn,$,we,Re,C.state.transmissionRenderTarget[E.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ut=M,pn=0;for(let Un of C.state.lightProbeGridArray)Un.texture!==null&&(Ut.textures[pn]=Un.texture,Ut.min[pn]=Un.boundingBox.min,Ut.max[pn]=Un.boundingBox.max,Ut.resolution[pn]=Un.resolution,pn++);for(let Un in Ut)Ut[Un].length=pn;sn.probesSH.value=Ut.textures,sn.probesMin.value=Ut.min,sn.probesMax.value=Ut.max,sn.probesResolution.value=Ut.resolution}ko.upload(F,Ls(Fe),sn,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(ko.upload(F,Ls(Fe),sn,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ut.setValue(F,"center",K.center),ut.setValue(F,"modelViewMatrix",K.modelViewMatrix),ut.setValue(F,"normalMatrix",K.normalMatrix),ut.setValue(F,"modelMatrix",K.matrixWorld),$.uniformsGroups!==void 0){let Ut=$.uniformsGroups;for(let pn=0,Un=Ut.length;pn<Un;pn++){let tl=Ut[pn];We.update(tl,fn),We.bind(tl,fn)}}return fn}function Lr(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Ds(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(E,z,Q){let $=He.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),He.get(E.texture).__webglTexture=z,He.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:Q,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let Q=He.get(E);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,Q=0){le=E,H=z,B=Q;let $=null,K=!1,Ae=!1;if(E){let Ce=He.get(E);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(F.FRAMEBUFFER,Ce.__webglFramebuffer),te.copy(E.viewport),ue.copy(E.scissor),fe=E.scissorTest,Ee.viewport(te),Ee.scissor(ue),Ee.setScissorTest(fe),Y=-1;return}else if(Ce.__webglFramebuffer===void 0)$e.setupRenderTarget(E);else if(Ce.__hasExternalTextures)$e.rebindTextures(E,He.get(E.texture).__webglTexture,He.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Qe=E.depthTexture;if(Ce.__boundDepthTexture!==Qe){if(Qe!==null&&He.has(Qe)&&(E.width!==Qe.image.width||E.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(E)}}let De=E.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let Ve=He.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ve[z])?$=Ve[z][Q]:$=Ve[z],K=!0):E.samples>0&&$e.useMultisampledRTT(E)===!1?$=He.get(E).__webglMultisampledFramebuffer:Array.isArray(Ve)?$=Ve[Q]:$=Ve,te.copy(E.viewport),ue.copy(E.scissor),fe=E.scissorTest}else te.copy(Ge).multiplyScalar(we).floor(),ue.copy(ft).multiplyScalar(we).floor(),fe=ht;if(Q!==0&&($=X),Ee.bindFramebuffer(F.FRAMEBUFFER,$)&&Ee.drawBuffers(E,$),Ee.viewport(te),Ee.scissor(ue),Ee.setScissorTest(fe),K){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ce.__webglTexture,Q)}else if(Ae){let Ce=z;for(let De=0;De<E.textures.length;De++){let Ve=He.get(E.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ve.__webglTexture,Q,Ce)}}else if(E!==null&&Q!==0){let Ce=He.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ce.__webglTexture,Q)}Y=-1};function Dr(E){let z=He.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=ot.textureFormatReadable(E.format),z.__typeReadable=ot.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,Q,$,K,Ae,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ve=E.textures[Ce],Qe=Ve.format,pt=Ve.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=Dr(Ve);if(ze.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&Q>=0&&Q<=E.height-K&&F.readPixels(z,Q,$,K,xe.convert(Qe),xe.convert(pt),Ae)}finally{let Ve=le!==null?He.get(le).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(E,z,Q,$,K,Ae,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(z>=0&&z<=E.width-$&&Q>=0&&Q<=E.height-K){Ee.bindFramebuffer(F.FRAMEBUFFER,De);let Ve=E.textures[Ce],Qe=Ve.format,pt=Ve.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ce);let ze=Dr(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.bufferData(F.PIXEL_PACK_BUFFER,Ae.byteLength,F.STREAM_READ),F.readPixels(z,Q,$,K,xe.convert(Qe),xe.convert(pt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let jt=le!==null?He.get(le).__webglFramebuffer:null;Ee.bindFramebuffer(F.FRAMEBUFFER,jt);let Dt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await W0(F,Dt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,mt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Ae),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(mt),F.deleteSync(Dt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,Q=0){let $=Math.pow(2,-Q),K=Math.floor(E.image.width*$),Ae=Math.floor(E.image.height*$),Le=z!==null?z.x:0,Ce=z!==null?z.y:0;$e.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Le,Ce,K,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(E,z,Q=null,$=null,K=0,Ae=0){let Le,Ce,De,Ve,Qe,pt,ze,mt,jt,Dt=E.isCompressedTexture?E.mipmaps[Ae]:E.image;if(Q!==null)Le=Q.max.x-Q.min.x,Ce=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,Ve=Q.min.x,Qe=Q.min.y,pt=Q.isBox3?Q.min.z:0;else{let ut=Math.pow(2,-K);Le=Math.floor(Dt.width*ut),Ce=Math.floor(Dt.height*ut),E.isDataArrayTexture?De=Dt.depth:E.isData3DTexture?De=Math.floor(Dt.depth*ut):De=1,Ve=0,Qe=0,pt=0}$!==null?(ze=$.x,mt=$.y,jt=$.z):(ze=0,mt=0,jt=0);let Nt=xe.convert(z.format),bn=xe.convert(z.type),Fe;z.isData3DTexture?($e.setTexture3D(z,0),Fe=F.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Fe=F.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Fe=F.TEXTURE_2D),Ee.activeTexture(F.TEXTURE0),Ee.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,z.flipY),Ee.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Ee.pixelStorei(F.UNPACK_ALIGNMENT,z.unpackAlignment);let dn=Ee.getParameter(F.UNPACK_ROW_LENGTH),xt=Ee.getParameter(F.UNPACK_IMAGE_HEIGHT),us=Ee.getParameter(F.UNPACK_SKIP_PIXELS),fn=Ee.getParameter(F.UNPACK_SKIP_ROWS),Nr=Ee.getParameter(F.UNPACK_SKIP_IMAGES);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,Dt.width),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Dt.height),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,Qe),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,pt);let $i=E.isDataArrayTexture||E.isData3DTexture,ds=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ut=He.get(E),sn=He.get(z),Wn=He.get(ut.__renderTarget),Ut=He.get(sn.__renderTarget);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,Wn.__webglFramebuffer),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let pn=0;pn<De;pn++)$i&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(E).__webglTexture,K,pt+pn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,He.get(z).__webglTexture,Ae,jt+pn)),F.blitFramebuffer(Ve,Qe,Ve+Le,Qe+Ce,ze,mt,ze+Le,mt+Ce,F.DEPTH_BUFFER_BIT,F.NEAREST);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(K!==0||E.isRenderTargetTexture||He.has(E)){let ut=He.get(E),sn=He.get(z);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,I),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,V);for(let Wn=0;Wn<De;Wn++)$i?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ut.__webglTexture,K,pt+Wn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ut.__webglTexture,K),ds?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,sn.__webglTexture,Ae,jt+Wn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,sn.__webglTexture,Ae),K!==0?F.blitFramebuffer(Ve,Qe,Ve+Le,Qe+Ce,ze,mt,ze+Le,mt+Ce,F.COLOR_BUFFER_BIT,F.NEAREST):ds?F.copyTexSubImage3D(Fe,Ae,ze,mt,jt+Wn,Ve,Qe,Le,Ce):F.copyTexSubImage2D(Fe,Ae,ze,mt,Ve,Qe,Le,Ce);Ee.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ds?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(Fe,Ae,ze,mt,jt,Le,Ce,De,Nt,bn,Dt.data):z.isCompressedArrayTexture?F.compressedTexSubImage3D(Fe,Ae,ze,mt,jt,Le,Ce,De,Nt,Dt.data):F.texSubImage3D(Fe,Ae,ze,mt,jt,Le,Ce,De,Nt,bn,Dt):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Le,Ce,Nt,bn,Dt.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Dt.width,Dt.height,Nt,Dt.data):F.texSubImage2D(F.TEXTURE_2D,Ae,ze,mt,Le,Ce,Nt,bn,Dt);Ee.pixelStorei(F.UNPACK_ROW_LENGTH,dn),Ee.pixelStorei(F.UNPACK_IMAGE_HEIGHT,xt),Ee.pixelStorei(F.UNPACK_SKIP_PIXELS,us),Ee.pixelStorei(F.UNPACK_SKIP_ROWS,fn),Ee.pixelStorei(F.UNPACK_SKIP_IMAGES,Nr),Ae===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&F.generateMipmap(Fe),Ee.unbindTexture()},this.initRenderTarget=function(E){He.get(E).__webglFramebuffer===void 0&&$e.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?$e.setTextureCube(E,0):E.isData3DTexture?$e.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?$e.setTexture2DArray(E,0):$e.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){H=0,B=0,le=null,Ee.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var P_={type:"change"},Df={type:"start"},L_={type:"end"},Lh=new Sr,I_=new Zn,IT=Math.cos(70*_f.DEG2RAD),Tn=new Z,ri=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Lf=1e-6,Dh=class extends ka{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new Z,this.cursor=new Z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:tr.ROTATE,MIDDLE:tr.DOLLY,RIGHT:tr.PAN},this.touches={ONE:nr.ROTATE,TWO:nr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Z,this._lastQuaternion=new gi,this._lastTargetPosition=new Z,this._quat=new gi().setFromUnitVectors(e.up,new Z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Do,this._sphericalDelta=new Do,this._scale=1,this._panOffset=new Z,this._rotateStart=new tt,this._rotateEnd=new tt,this._rotateDelta=new tt,this._panStart=new tt,this._panEnd=new tt,this._panDelta=new tt,this._dollyStart=new tt,this._dollyEnd=new tt,this._dollyDelta=new tt,this._dollyDirection=new Z,this._mouse=new tt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=DT.bind(this),this._onPointerDown=LT.bind(this),this._onPointerUp=NT.bind(this),this._onContextMenu=VT.bind(this),this._onMouseWheel=FT.bind(this),this._onKeyDown=BT.bind(this),this._onTouchStart=kT.bind(this),this._onTouchMove=zT.bind(this),this._onMouseDown=UT.bind(this),this._onMouseMove=OT.bind(this),this._interceptControlDown=HT.bind(this),this._interceptControlUp=GT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(P_),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Tn.copy(t).sub(this.target),Tn.applyQuaternion(this._quat),this._spherical.setFromVector3(Tn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ri:i>Math.PI&&(i-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Tn.setFromSpherical(this._spherical),Tn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Tn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Tn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Tn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Lh.origin.copy(this.object.position),Lh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Lh.direction))<IT?this.object.lookAt(this.target):(I_.setFromNormalAndCoplanarPoint(this.object.up,this.target),Lh.intersectPlane(I_,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Lf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Lf||this._lastTargetPosition.distanceToSquared(this.target)>Lf?(this.dispatchEvent(P_),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ri/60*this.autoRotateSpeed*e:ri/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Tn.setFromMatrixColumn(t,0),Tn.multiplyScalar(-e),this._panOffset.add(Tn)}_panUp(e,t){this.screenSpacePanning===!0?Tn.setFromMatrixColumn(t,1):(Tn.setFromMatrixColumn(t,0),Tn.crossVectors(this.object.up,Tn)),Tn.multiplyScalar(e),this._panOffset.add(Tn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Tn.copy(s).sub(this.target);let r=Tn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new tt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function LT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function DT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function NT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(L_),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function UT(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case tr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pt.DOLLY;break;case tr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}break;case tr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Df)}function OT(n){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function FT(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(n.preventDefault(),this.dispatchEvent(Df),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(L_))}function BT(n){this.enabled!==!1&&this._handleKeyDown(n)}function kT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case nr.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(n),this.state=Pt.TOUCH_ROTATE;break;case nr.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(n),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case nr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pt.TOUCH_DOLLY_PAN;break;case nr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Df)}function zT(n){switch(this._trackPointer(n),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pt.NONE}}function VT(n){this.enabled!==!1&&n.preventDefault()}function HT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function GT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var WT=.88,Nh=class{constructor(e,t,i){this.low=e;this.high=t;this.renderer=new Rh({antialias:!0,alpha:!0}),this.renderer.localClippingEnabled=!0,this.canvas=this.renderer.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","img"),this.camera.up.set(0,0,1);let s=new Fa(16777215,2.2);s.position.set(-.6,.9,.8),this.camera.add(s),this.scene.add(this.camera,new Ba(16777215,1.3)),this.controls=new Dh(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>this.controls.enableZoom=!0,{signal:i}),this.canvas.addEventListener("blur",()=>this.controls.enableZoom=!1,{signal:i}),this.canvas.addEventListener("keydown",r=>this.key(r),{signal:i}),this.controls.addEventListener("change",()=>this.draw()),this.controls.addEventListener("start",()=>this.view=null),this.watcher=new ResizeObserver(()=>this.draw()),this.watcher.observe(this.canvas),this.look(-60,30),i.addEventListener("abort",()=>this.end())}low;high;canvas;renderer;scene=new Ta;camera=new Kn(32,1,.1,1e3);controls;named=new Map;plane=new Zn(new Z(0,0,-1),0);watcher;isCut=!1;view=null;frame=0;end(){cancelAnimationFrame(this.frame),this.watcher.disconnect(),this.controls.dispose();for(let e of[...this.named.keys()])this.remove(e);this.renderer.dispose(),this.renderer.forceContextLoss()}look(e,t){this.view=[e,t];let i=new Z(...this.low).add(new Z(...this.high)).multiplyScalar(.5),s=.5*Math.hypot(...this.high.map((c,h)=>c-this.low[h])),[r,o]=[e,Math.min(Math.max(t,-89.9),89.9)].map(c=>c*Math.PI/180),a=this.camera.fov*Math.PI/360,l=s/Math.sin(Math.min(a,Math.atan(Math.tan(a)*this.camera.aspect)))*WT;this.camera.near=s/50,this.camera.far=30*s,this.controls.target.copy(i),this.camera.position.set(Math.cos(r)*Math.cos(o),Math.sin(r)*Math.cos(o),Math.sin(o)).multiplyScalar(l).add(i),this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}mesh(e,t,i){if(this.remove(e),t.triangles.length===0)return;let s=new xi;s.setAttribute("position",new zn(t.corners,3)),s.setIndex(new zn(t.triangles,1)),s.computeVertexNormals(),i.colors&&s.setAttribute("color",new zn(qT(i.colors),3));let r=i.opacity!==void 0&&i.opacity<1,o=new Io({vertexColors:i.colors!==void 0,side:ii,transparent:r,opacity:i.opacity??1,depthWrite:!r});i.color!==void 0&&(o.color=new ct().setRGB(...hl(i.color),Dn)),o.clippingPlanes=this.isCut&&i.whole!==!0?[this.plane]:[],o.userData.whole=i.whole===!0,this.add(e,new ni(s,o))}walls(e,t,i){this.remove(e);let s=new Ss,r=new ct().setRGB(...hl(i),Dn);for(let{points:o,low:a,high:l}of t){for(let f of[a,l]){let g=new xi().setFromPoints(o.map(([_,p])=>new Z(_,p,f)));s.add(new Ra(g,new Ro({color:r,transparent:!0,opacity:.55})))}let c=new Float32Array(o.flatMap(([f,g])=>[f,g,a,f,g,l])),h=o.length,u=Uint32Array.from(o.flatMap((f,g)=>[0,2,1,1,2,3].map(_=>(2*g+_)%(2*h)))),d=new xi;d.setAttribute("position",new zn(c,3)),d.setIndex(new zn(u,1)),s.add(new ni(d,new wr({color:r,transparent:!0,opacity:.06,side:ii,depthWrite:!1})))}this.add(e,s)}cut(e,t,i){if(this.remove("cut"),this.isCut=e!==null,e!==null){let s=new Z().setComponent(e,e===1?1:-1);this.plane.set(s,e===1?-t:t),i&&this.add("cut",XT(e,t,i))}this.scene.traverse(s=>{let r=s.material;r instanceof Io&&(r.clippingPlanes=this.isCut&&r.userData.whole!==!0?[this.plane]:[])}),this.draw()}remove(e){let t=this.named.get(e);t&&(this.scene.remove(t),this.named.delete(e),t.traverse(i=>{let s=i;s.geometry?.dispose();let r=s.material;r?.map?.dispose(),r?.dispose()}),this.draw())}add(e,t){this.named.set(e,t),this.scene.add(t),this.draw()}draw(){this.frame===0&&(this.frame=requestAnimationFrame(()=>{this.frame=0;let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];if(e===0||t===0)return;let i=Math.min(window.devicePixelRatio||1,2);(this.canvas.width!==Math.round(e*i)||this.canvas.height!==Math.round(t*i))&&(this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.view&&this.look(...this.view)),this.renderer.render(this.scene,this.camera)}))}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=this.camera.position.clone().sub(this.controls.target),i=t.length(),[s,r]=[Math.atan2(t.y,t.x),Math.asin(t.z/i)].map(l=>l*180/Math.PI),o={ArrowLeft:[-10,0],ArrowRight:[10,0],ArrowUp:[0,10],ArrowDown:[0,-10]},a={"+":.85,"=":.85,"-":1/.85};if(e.key in o){let[l,c]=[s+o[e.key][0],Math.min(Math.max(r+o[e.key][1],-89.9),89.9)].map(h=>h*Math.PI/180);this.camera.position.set(Math.cos(l)*Math.cos(c),Math.sin(l)*Math.cos(c),Math.sin(c)).multiplyScalar(i).add(this.controls.target)}else if(e.key in a)this.camera.position.copy(t.multiplyScalar(a[e.key]).add(this.controls.target));else if(e.key==="0")this.look(-60,30);else return;e.preventDefault(),e.key!=="0"&&(this.view=null),this.controls.update(),this.draw()}};function XT(n,e,{pixels:t,width:i,height:s,pitch:r,corner:o}){let[a,l]=Qn[n],c=new Uint32Array(t.length);for(let f=0;f<s;f++)c.set(t.subarray((s-1-f)*i,(s-f)*i),f*i);let h=new Co(new Uint8Array(c.buffer),i,s,vi);h.colorSpace=Dn,h.magFilter=h.minFilter=yn,h.needsUpdate=!0;let u=new Er(1,1),d=u.getAttribute("position");for(let f=0;f<d.count;f++){let[g,_]=[d.getX(f)+.5,d.getY(f)+.5],p=new Z().setComponent(n,e);p.setComponent(a,o[0]+g*i*r[0]).setComponent(l,o[1]+(_-1)*s*r[1]),d.setXYZ(f,p.x,p.y,p.z)}return new ni(u,new wr({map:h,side:ii,alphaTest:.5}))}function qT(n){let e=new Map,t=new Float32Array(3*n.length),i=new ct;return n.forEach((s,r)=>{let o=e.get(s);o||(i.setRGB(...hl(s),Dn),o=[i.r,i.g,i.b],e.set(s,o)),t.set(o,3*r)}),t}var D_=`"use strict";(()=>{function S(a,e){let{pitch:t,low:r}=a,[s,l,o]=a.shape.map(g=>g+2),u=C(a,e),n=s*l,h=Int32Array.from({length:8},(g,y)=>(y&1)+(y>>1&1)*s+(y>>2)*n),i=[1,s,n],f=2*n,c=new Int32Array(f),d=new k(Float32Array),F=new k(Uint32Array),m=new Float32Array(8),v=new Float64Array(3),b=0;for(let g=0;g+1<o;g++)for(let y=0;y+1<l;y++)for(let w=0;w+1<s;w++){let A=w+s*y+n*g,M=0;for(let p=0;p<8;p++)m[p]=u[A+h[p]],m[p]>=0&&(M|=1<<p);if(M===0||M===255)continue;D(m,M,v),d.push3(r[0]+(w+v[0]-.5)*t[0],r[1]+(y+v[1]-.5)*t[1],r[2]+(g+v[2]-.5)*t[2]),c[A%f]=b;let x=(M&1)!==0;for(let p=0;p<3;p++){if(x===u[A+i[p]]>=0||p!==0&&w===0||p!==1&&y===0||p!==2&&g===0)continue;let O=i[(p+1)%3],T=i[(p+2)%3],B=c[(A-O)%f],z=c[(A-O-T)%f],E=c[(A-T)%f];x?(F.push3(b,B,z),F.push3(b,z,E)):(F.push3(b,z,B),F.push3(b,E,z))}b++}return{corners:d.taken(),triangles:F.taken()}}function C({codes:a,values:e,shape:t},r){let[s,l,o]=t,u=new Float32Array((s+2)*(l+2)*(o+2)).fill(-1e6),n=e.map(i=>Number.isNaN(i)?-1e6:i-r),h=0;for(let i=0;i<o;i++)for(let f=0;f<l;f++){let c=1+(s+2)*(f+1+(l+2)*(i+1));for(let d=0;d<s;d++)u[c++]=n[a[h++]]}return u}var R=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function D(a,e,t){let r=0,s=0,l=0,o=0;for(let u=0;u<24;u+=2){let n=R[u],h=R[u+1];if((e>>n&1)===(e>>h&1))continue;let i=a[n]/(a[n]-a[h]);r+=(n&1)+i*((h&1)-(n&1)),s+=(n>>1&1)+i*((h>>1&1)-(n>>1&1)),l+=(n>>2)+i*((h>>2)-(n>>2)),o++}t[0]=r/o,t[1]=s/o,t[2]=l/o}var _=8,U=class{constructor(e,{shape:t,pitch:r,low:s}){this.mesh=e;this.normals=G(e),this.size=2*Math.max(...r),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(n=>Math.ceil(t[n]*r[n]/this.size)+2);let l=e.corners.length/3,o=Uint32Array.from({length:l},(n,h)=>this.cellOf(e.corners,h));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let n of o)this.starts[n+1]++;for(let n=1;n<this.starts.length;n++)this.starts[n]+=this.starts[n-1];let u=this.starts.slice();this.order=new Uint32Array(l),o.forEach((n,h)=>{this.order[u[n]++]=h})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let r=0;r<t.length;r++)t[r]=this.off(e[3*r],e[3*r+1],e[3*r+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,r){let{corners:s}=this.mesh,[l,o,u]=this.cells,n=this.place(e,0),h=this.place(t,1),i=this.place(r,2),f=Number.POSITIVE_INFINITY,c=-1;for(let m=0;m<=_&&!(c>=0&&f<=((m-1)*this.size)**2);m++)for(let v=Math.max(i-m,0);v<=Math.min(i+m,u-1);v++)for(let b=Math.max(h-m,0);b<=Math.min(h+m,o-1);b++){let g=Math.abs(v-i)===m||Math.abs(b-h)===m;for(let y=n-m;y<=n+m;y+=g||m===0?1:2*m){if(y<0||y>=l)continue;let w=y+l*(b+o*v);for(let A=this.starts[w];A<this.starts[w+1];A++){let M=3*this.order[A],x=(s[M]-e)**2+(s[M+1]-t)**2+(s[M+2]-r)**2;x<f&&(f=x,c=M)}}}if(c<0)return _*this.size;let d=(e-s[c])*this.normals[c]+(t-s[c+1])*this.normals[c+1]+(r-s[c+2])*this.normals[c+2],F=Math.sqrt(f);return F<=this.size?d:Math.sign(d)*F}};function G({corners:a,triangles:e}){let t=new Float32Array(a.length);for(let r=0;r<e.length;r+=3){let[s,l,o]=[3*e[r],3*e[r+1],3*e[r+2]],[u,n,h]=[a[l]-a[s],a[l+1]-a[s+1],a[l+2]-a[s+2]],[i,f,c]=[a[o]-a[s],a[o+1]-a[s+1],a[o+2]-a[s+2]];for(let d of[s,l,o])t[d]+=n*c-h*f,t[d+1]+=h*i-u*c,t[d+2]+=u*f-n*i}for(let r=0;r<t.length;r+=3){let s=Math.hypot(t[r],t[r+1],t[r+2])||1;for(let l=0;l<3;l++)t[r+l]/=s}return t}var k=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,r){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=r}taken(){return this.array.slice(0,this.used)}};var N=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],I();case"print":{if(!this.response)return I();let t=S(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:I()}case"part":{let{samples:t,code:r}=e;return{...S({...t,values:Float32Array.from(t.values,(s,l)=>l===r?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=S(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new U(e,this.target)),this.distance}};function I(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let a=new N;self.addEventListener("message",e=>{let t=a.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}})();
`;function Fh(n,e){let{pitch:t,low:i}=n,[s,r,o]=n.shape.map(v=>v+2),a=YT(n,e),l=s*r,c=Int32Array.from({length:8},(v,A)=>(A&1)+(A>>1&1)*s+(A>>2)*l),h=[1,s,l],u=2*l,d=new Int32Array(u),f=new Oh(Float32Array),g=new Oh(Uint32Array),_=new Float32Array(8),p=new Float64Array(3),m=0;for(let v=0;v+1<o;v++)for(let A=0;A+1<r;A++)for(let M=0;M+1<s;M++){let R=M+s*A+l*v,C=0;for(let S=0;S<8;S++)_[S]=a[R+c[S]],_[S]>=0&&(C|=1<<S);if(C===0||C===255)continue;ZT(_,C,p),f.push3(i[0]+(M+p[0]-.5)*t[0],i[1]+(A+p[1]-.5)*t[1],i[2]+(v+p[2]-.5)*t[2]),d[R%u]=m;let x=(C&1)!==0;for(let S=0;S<3;S++){if(x===a[R+h[S]]>=0||S!==0&&M===0||S!==1&&A===0||S!==2&&v===0)continue;let k=h[(S+1)%3],U=h[(S+2)%3],D=d[(R-k)%u],G=d[(R-k-U)%u],X=d[(R-U)%u];x?(g.push3(m,D,G),g.push3(m,G,X)):(g.push3(m,G,D),g.push3(m,X,G))}m++}return{corners:f.taken(),triangles:g.taken()}}function YT({codes:n,values:e,shape:t},i){let[s,r,o]=t,a=new Float32Array((s+2)*(r+2)*(o+2)).fill(-1e6),l=e.map(h=>Number.isNaN(h)?-1e6:h-i),c=0;for(let h=0;h<o;h++)for(let u=0;u<r;u++){let d=1+(s+2)*(u+1+(r+2)*(h+1));for(let f=0;f<s;f++)a[d++]=l[n[c++]]}return a}var N_=[0,1,2,3,4,5,6,7,0,2,1,3,4,6,5,7,0,4,1,5,2,6,3,7];function ZT(n,e,t){let i=0,s=0,r=0,o=0;for(let a=0;a<24;a+=2){let l=N_[a],c=N_[a+1];if((e>>l&1)===(e>>c&1))continue;let h=n[l]/(n[l]-n[c]);i+=(l&1)+h*((c&1)-(l&1)),s+=(l>>1&1)+h*((c>>1&1)-(l>>1&1)),r+=(l>>2)+h*((c>>2)-(l>>2)),o++}t[0]=i/o,t[1]=s/o,t[2]=r/o}var U_=8,Uh=class{constructor(e,{shape:t,pitch:i,low:s}){this.mesh=e;this.normals=KT(e),this.size=2*Math.max(...i),this.low=[s[0]-this.size,s[1]-this.size,s[2]-this.size],this.cells=[0,1,2].map(l=>Math.ceil(t[l]*i[l]/this.size)+2);let r=e.corners.length/3,o=Uint32Array.from({length:r},(l,c)=>this.cellOf(e.corners,c));this.starts=new Uint32Array(this.cells[0]*this.cells[1]*this.cells[2]+1);for(let l of o)this.starts[l+1]++;for(let l=1;l<this.starts.length;l++)this.starts[l]+=this.starts[l-1];let a=this.starts.slice();this.order=new Uint32Array(r),o.forEach((l,c)=>{this.order[a[l]++]=c})}mesh;normals;size;cells;low;starts;order;of(e){let t=new Float32Array(e.length/3);for(let i=0;i<t.length;i++)t[i]=this.off(e[3*i],e[3*i+1],e[3*i+2]);return t}place(e,t){return Math.min(Math.max(Math.floor((e-this.low[t])/this.size),0),this.cells[t]-1)}cellOf(e,t){return this.place(e[3*t],0)+this.cells[0]*(this.place(e[3*t+1],1)+this.cells[1]*this.place(e[3*t+2],2))}off(e,t,i){let{corners:s}=this.mesh,[r,o,a]=this.cells,l=this.place(e,0),c=this.place(t,1),h=this.place(i,2),u=Number.POSITIVE_INFINITY,d=-1;for(let _=0;_<=U_&&!(d>=0&&u<=((_-1)*this.size)**2);_++)for(let p=Math.max(h-_,0);p<=Math.min(h+_,a-1);p++)for(let m=Math.max(c-_,0);m<=Math.min(c+_,o-1);m++){let v=Math.abs(p-h)===_||Math.abs(m-c)===_;for(let A=l-_;A<=l+_;A+=v||_===0?1:2*_){if(A<0||A>=r)continue;let M=A+r*(m+o*p);for(let R=this.starts[M];R<this.starts[M+1];R++){let C=3*this.order[R],x=(s[C]-e)**2+(s[C+1]-t)**2+(s[C+2]-i)**2;x<u&&(u=x,d=C)}}}if(d<0)return U_*this.size;let f=(e-s[d])*this.normals[d]+(t-s[d+1])*this.normals[d+1]+(i-s[d+2])*this.normals[d+2],g=Math.sqrt(u);return g<=this.size?f:Math.sign(f)*g}};function KT({corners:n,triangles:e}){let t=new Float32Array(n.length);for(let i=0;i<e.length;i+=3){let[s,r,o]=[3*e[i],3*e[i+1],3*e[i+2]],[a,l,c]=[n[r]-n[s],n[r+1]-n[s+1],n[r+2]-n[s+2]],[h,u,d]=[n[o]-n[s],n[o+1]-n[s+1],n[o+2]-n[s+2]];for(let f of[s,r,o])t[f]+=l*d-c*u,t[f+1]+=c*h-a*d,t[f+2]+=a*u-l*h}for(let i=0;i<t.length;i+=3){let s=Math.hypot(t[i],t[i+1],t[i+2])||1;for(let r=0;r<3;r++)t[i+r]/=s}return t}var Oh=class{constructor(e){this.kind=e;this.array=new e(32768)}kind;array;used=0;push3(e,t,i){if(this.used+3>this.array.length){let s=new this.kind(2*this.array.length);s.set(this.array),this.array=s}this.array[this.used++]=e,this.array[this.used++]=t,this.array[this.used++]=i}taken(){return this.array.slice(0,this.used)}};var ja=class{response=null;target=null;targetMesh=null;distance=null;answer(e){switch(e.kind){case"load":return[this.response,this.target,this.targetMesh,this.distance]=[e.response,e.target,null,null],Nf();case"print":{if(!this.response)return Nf();let t=Fh(this.response,e.level);return{...t,off:this.toTarget()?.of(t.corners)??null}}case"target":{let t=this.meshOfTarget();return t?{corners:t.corners.slice(),triangles:t.triangles.slice(),off:null}:Nf()}case"part":{let{samples:t,code:i}=e;return{...Fh({...t,values:Float32Array.from(t.values,(s,r)=>r===i?1:0)},.5),off:null}}}}meshOfTarget(){return this.target&&(this.targetMesh??=Fh(this.target,.5)),this.targetMesh}toTarget(){let e=this.meshOfTarget();return e&&this.target&&e.corners.length>0&&(this.distance??=new Uh(e,this.target)),this.distance}};function Nf(){return{corners:new Float32Array,triangles:new Uint32Array,off:null}}if(typeof document>"u"){let n=new ja;self.addEventListener("message",e=>{let t=n.answer(e.data);self.postMessage(t,{transfer:[t.corners.buffer,t.triangles.buffer,...t.off?[t.off.buffer]:[]]})})}var Bh=class{worker;local=new ja;last=Promise.resolve();constructor(e){this.worker=JT(),e.addEventListener("abort",()=>this.worker?.terminate())}ask(e){let t=this.last.then(()=>this.worker?jT(this.worker,e):QT().then(()=>this.local.answer(e)));return this.last=t.catch(()=>{}),t}};function kh(n){let e=[0,1,2].map(t=>n.range(t)[0]);return{codes:n.codes,values:n.values,shape:n.shape,pitch:n.pitch,low:e}}function JT(){try{return new Worker(URL.createObjectURL(new Blob([D_],{type:"text/javascript"})))}catch{return null}}function jT(n,e){return new Promise((t,i)=>{n.onmessage=s=>t(s.data),n.onerror=s=>i(new Error(`The surface could not be made: ${s.message}`)),n.postMessage(e)})}function QT(){return new Promise(n=>setTimeout(n,20))}var O_={id:"solid",title:"In 3D",render:n=>!(t=>n.run.volumes.some(i=>i.kind===t))("target")&&!n.run.surface?null:document.createElement("canvas").getContext("webgl2")===null?T("p.problem",{role:"alert"},"This browser has no WebGL 2, so print and target cannot be shown in 3D. The slices above show the same volumes."):eA(n,()=>Ni(n,nA))};function eA({gone:n},e){let t=T("div.solid-place"),i=new IntersectionObserver(s=>{s.some(({isIntersecting:r})=>r)&&(i.disconnect(),t.replaceChildren(e()))},{rootMargin:"300px"});return i.observe(t),n.addEventListener("abort",()=>i.disconnect()),t}var tA=.95;async function nA(n){let{run:e,state:t,store:i,gone:s}=n,r=uu(e),o=()=>r.includes(t.get("species"))?t.get("species"):"",{volumes:a,problems:l}=await ml(n,o()),c=a.response??a.target;if(!c)throw new Error(l.join(" ")||"The run has no volume to show.");let h=ol(e),u=()=>h===null?al(e,o(),a.response,a.labels):null,d=()=>o()===""||o()===r[0],[f,g]=lA(a.target??c,c),_=new Nh(f,g,s);_.canvas.setAttribute("aria-label","Surfaces of print and target. Arrow keys turn the view, + and − zoom, 0 looks from the front again.");let p=new Bh(s),m=T("div.color-legend"),v=T("p.quiet",{role:"status"}),A=()=>["target","both"].includes(t.get("solid"))?t.get("solid"):h===null&&a.response?"print":"target",M=0,R=()=>p.ask({kind:"load",response:a.response&&kh(a.response),target:a.target&&kh(a.target)}),C=async()=>{let H=t.get("threshold"),B=H??u()?.reported??null,le=++M;if(A()==="target"||B===null){_.remove("print"),m.replaceChildren(Ei({keys:[["var(--solid)","target"]]})),v.textContent="";return}let Y=H===null&&d()&&e.surface!==null&&e.surface.triangles>0?e.surface:null;v.textContent=Y?"":"Making the surface…";let j,te;if(Y){let pe=await i.surface(Y);[j,te]=[pe,pe.off_um]}else{if(await new Promise(_e=>setTimeout(_e,120)),le!==M)return;let pe=await p.ask({kind:"print",level:B});[j,te]=[pe,pe.off&&pe.off.map(_e=>1e3*_e)]}if(le!==M||s.aborted)return;let ue=te?aA(te):0,fe=te&&Uint32Array.from(te,pe=>Gr(Math.round(40*(.5+pe/(2*ue)))/40));_.mesh("print",j,fe?{colors:fe}:{color:On("--solid")});let ee={scale:{low:-ue,high:ue,logarithmic:!1,map:Gr},label:"deviation from the target, µm: blue is too small, red too large",mark:null};m.replaceChildren(te?Ei(ee):Ei({keys:[["var(--solid)","print"]]})),v.textContent=j.triangles.length===0?"At this threshold nothing is solid.":Y?"The surface at the report’s threshold.":`The surface at a threshold of ${he(B,3)}, from the page’s voxels.`},x=async()=>{if(A()==="print")return _.remove("target");let H=await p.ask({kind:"target"});s.aborted||A()==="print"||_.mesh("target",H,{color:On("--solid"),opacity:A()==="both"?.3:1})},S=H=>{v.textContent=H instanceof Error?H.message:String(H)},k=()=>{let H=ji.indexOf(t.get("cut"));if(H<0)return _.cut(null,0,null);let B=(t.get("at")??c.center)[H];_.cut(H,B,sA(a,H,B,A()==="target"?null:t.get("threshold")??u()?.reported??null))},U=()=>{C().catch(S),x().catch(S),k()},D=(H,B)=>s.addEventListener("abort",t.on(H,B));D(["threshold"],()=>{C().catch(S)}),D(["threshold","at","cut"],k),D(["solid"],U),D(["species"],()=>{ml(n,o()).then(async H=>{a=H.volumes,await R(),U()}).catch(S)});let G=iA(n,_,p,a.bodies);await R(),U();let X=h===null&&a.response?[["print","Print"],["both","Print and target"],["target","Target"]]:[["target","Target"]],I=Qh(e,o()).evaluation?.farthest?.at_xyz_mm,V=(H,B,le)=>T("button",{type:"button",click:()=>_.look(B,le)},H);return T("div.solid",{},...l.map(H=>T("p.problem",{role:"alert"},H)),T("p.quiet",{},"Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. The cut goes through the point that the planes above show."),T("div.controls",{},X.length>1&&wi("Surface",X,A,H=>t.set({solid:H===X[0][0]?"":H}),H=>D(["solid"],H)),wi("Cut",[["","Whole"],["x","Cut along x"],["y","Cut along y"],["z","Cut along z"]],()=>t.get("cut"),H=>t.set({cut:H}),H=>D(["cut"],H)),T("span.views",{},V("From the front",-60,30),V("From behind, below",120,-30),V("From above",-90,89.9)),...G,I&&I.length===3&&T("button",{type:"button",click:()=>t.set({at:I})},"Cut at the largest deviation")),_.canvas,T("div.below-planes",{},v,m))}function iA({run:n},e,t,i){let s=(l,c,h,u)=>{let d=f=>f.target.checked?h():u();return c&&h(),T("label",{},T("input",{type:"checkbox",checked:c,change:d}),l)},r=[],o=[[ks.insert,"insert","--ink"],[ks.dark,"bodies that stay dark","--void"],[ks.obstacle,"obstacles","--quiet"]];for(let[l,c,h]of o){if(!i?.codes.includes(l))continue;let u=()=>{t.ask({kind:"part",samples:kh(i),code:l}).then(d=>e.mesh(c,d,{color:On(h),opacity:.75}))};r.push(s(c,!0,u,()=>e.remove(c)))}let{scene:a}=n;if(a&&a.walls.length>0){let[l,c]=a.z_mm,h=()=>a.walls.map(({points:u,height_mm:d})=>({points:u,low:d?.[0]??l,high:d?.[1]??c}));r.push(s("vial",!1,()=>e.walls("vial",h(),On("--quiet")),()=>e.remove("vial")))}return r}function sA({response:n,target:e},t,i,s){let r=s===null?e:n,o=r?.slice(t,i);if(!r||!o)return null;let a={low:0,high:r.info.high,logarithmic:!1,map:lr},l=On("--solid"),c=Uint32Array.from({length:256},(u,d)=>lr(d/255));return oA(o,s??.5,u=>s===null?l:c[Math.round(255*Math.min(Math.max(Jo(a,u),0),1))])}var rA=640;function oA(n,e,t){let{width:i,height:s,codes:r,values:o}=n,a=Math.max(1,Math.round(rA/Math.max(i,s))),l=new Uint32Array(i*a*s*a),c=(h,u)=>{let d=o[r[Math.min(Math.max(u,0),s-1)*i+Math.min(Math.max(h,0),i-1)]];return Number.isNaN(d)?0:d};for(let h=0,u=0;h<s*a;h++){let d=(h+.5)/a-.5,f=Math.floor(d);for(let g=0;g<i*a;g++,u++){let _=(g+.5)/a-.5,p=Math.floor(_),m=c(p,f)+(_-p)*(c(p+1,f)-c(p,f)),v=c(p,f+1)+(_-p)*(c(p+1,f+1)-c(p,f+1)),A=m+(d-f)*(v-m);A>=e&&(l[u]=t(A))}}return{...n,pixels:l,width:i*a,height:s*a,pitch:[n.pitch[0]/a,n.pitch[1]/a]}}function aA(n){let e=n.map(Math.abs).sort(),t=Math.max(e[Math.min(Math.floor(e.length*tA),e.length-1)]??1,.001),i=10**Math.floor(Math.log10(t));return([1,1.2,1.5,2,2.5,3,4,5,6,8,10].find(s=>s*i>=t*(1-1e-6))??10)*i}function lA(n,e){let{codes:t,values:i,shape:s}=n,r=i.map(u=>+(u>=.5)),[o,a]=[[...s],[-1,-1,-1]],l=0;for(let u=0;u<s[2];u++)for(let d=0;d<s[1];d++)for(let f=0;f<s[0];f++,l++)r[t[l]]!==0&&[f,d,u].forEach((g,_)=>{g<o[_]&&(o[_]=g),g>a[_]&&(a[_]=g)});let c=a[0]<0?e:n;return(a[0]<0?[[0,0,0],e.shape.map(u=>u-1)]:[o,a]).map(u=>u.map((d,f)=>c.middle(f,d)))}var zh={run:0,section:"",species:"",layer:"",at:null,threshold:null,light:0,frame:0,row:null,time:null,solid:"",cut:""},Vh=class{constructor(e=window.location){this.location=e;this.view={...zh,...this.read()},window.addEventListener("hashchange",()=>this.set(this.read()))}location;view;listeners=new Set;writing=0;read(){let e=this.location.hash;return e!==""&&!e.includes("=")?{section:decodeURIComponent(e.slice(1))}:hA(e)}get(e){return this.view[e]}set(e){let t=Object.keys(e).filter(i=>!F_(this.view[i],e[i]));if(t.length!==0){this.view={...this.view,...e};for(let i of[...this.listeners])i.keys.some(s=>t.includes(s))&&i.call();this.write()}}on(e,t){let i={keys:e,call:t};return this.listeners.add(i),()=>this.listeners.delete(i)}write(){window.clearTimeout(this.writing),this.writing=window.setTimeout(()=>{let e=cA(this.view);e!==this.location.hash.replace(/^#/,"")&&history.replaceState(null,"",`#${e}`)},150)}};function cA(n){let e=[];for(let t of Object.keys(zh)){let i=n[t];i===null||F_(i,zh[t])||e.push(`${t}=${Array.isArray(i)?i.map(s=>+s.toFixed(4)).join(","):encodeURIComponent(String(i))}`)}return e.join("&")}function hA(n){let e=new URLSearchParams(n.replace(/^#/,"")),t={...zh},i=o=>{let a=Number(e.get(o)??"0");return Number.isInteger(a)&&a>=0?a:0},s=o=>{let a=e.get(o);return a!==null&&a!==""&&Number.isFinite(Number(a))?Number(a):null};t.run=i("run"),t.light=i("light"),t.frame=i("frame");for(let o of["section","species","layer","solid","cut"])t[o]=e.get(o)??"";t.threshold=s("threshold"),t.row=s("row"),t.time=s("time");let r=e.get("at")?.split(",").map(Number)??[];return r.length===3&&r.every(Number.isFinite)&&(t.at=[r[0],r[1],r[2]]),t}function F_(n,e){return n===e||Array.isArray(n)&&Array.isArray(e)&&n.length===e.length&&n.every((t,i)=>t===e[i])}var Qa=class{constructor(e,t){this.served=e;this.run=t}served;run;cache=new Map;volume(e){return this.once(e.id,async()=>{let[t,i,s]=e.shape_zyx,r=await this.bytes("volume",e.id,t*i*s*e.bits/8);return new rl(e,e.bits===16?new Uint16Array(r.buffer):r)})}film(e){return this.once(e.id,async()=>({info:e,values:await this.bytes("film",e.id,e.frames*e.rows*e.columns)}))}surface(e){return this.once(e.id,async()=>fA(e,await this.bytes("volume",e.id,e.vertices*8+e.triangles*12)))}async slice(e,t,i,s){let r=await fetch(`${this.served}run/${this.run}/slice/${e.id}?axis=${t}&index=${i}`,{signal:s});if(!r.ok)throw new Error(`the viewer answered ${r.status}`);let o=new Uint8Array(await r.arrayBuffer()),a=o.indexOf(10),l=JSON.parse(new TextDecoder().decode(o.subarray(0,a))),c=o.slice(a+1);return{...l,codes:l.bits===16?new Uint16Array(c.buffer):c}}once(e,t){let i=this.cache.get(e);return i||(i=t(),this.cache.set(e,i)),i}async bytes(e,t,i){let s;try{s=await uA(await this.packed(e,t))}catch(r){throw new Error(`The array “${t}” is damaged or missing: ${r instanceof Error?r.message:String(r)}.`)}if(s.length!==i)throw new Error(`The array “${t}” is damaged: ${s.length.toLocaleString("en")} bytes where ${i.toLocaleString("en")} are expected.`);return s}async packed(e,t){if(this.served!==null){let s=await fetch(`${this.served}run/${this.run}/${e}/${t}`);if(!s.ok)throw new Error(`the viewer answered ${s.status}`);return s.arrayBuffer()}let i=document.getElementById(`blob-${this.run}-${t}`);if(!i)throw new Error("the page has no such element");return dA(i.textContent??"")}};async function uA(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate-raw"));try{return new Uint8Array(await new Response(e).arrayBuffer())}catch{throw new Error("it cannot be unpacked")}}function dA(n){let e;try{e=atob(n)}catch{throw new Error("it is no base64")}let t=new Uint8Array(e.length);for(let i=0;i<t.length;i++)t[i]=e.charCodeAt(i);return t}function fA(n,e){let t=new DataView(e.buffer),i=n.vertices,s=new Float32Array(3*i);for(let a=0;a<s.length;a++){let l=a%3;s[a]=n.low_mm[l]+t.getUint16(2*a,!0)/65535*(n.high_mm[l]-n.low_mm[l])}let r=new Float32Array(i);for(let a=0;a<i;a++)r[a]=t.getInt16(6*i+2*a,!0)/32767*n.off_um[1];let o=new Uint32Array(3*n.triangles);for(let a=0;a<o.length;a++)o[a]=t.getUint32(8*i+4*a,!0);if(o.some(a=>a>=i))throw new Error(`The array “${n.id}” is damaged: a triangle names a corner that is not there.`);return{corners:s,off_um:r,triangles:o}}var Uf=[...Nl.map(({id:n})=>n),"head","limits","warnings","look","solid","in-time","time","film"],B_=gA([dp,O_,yp,xp,...Og]),k_=["history","histories"],pA=700,mA=6e3;function gA(n){let e=t=>(Uf.indexOf(t.id)+Uf.length+1)%(Uf.length+1);return[...n].sort((t,i)=>e(t)-e(i))}var Of=class{constructor(e,t){this.data=e;this.app=t;this.stores=e.runs.map((i,s)=>new Qa(e.served,s)),this.state.on(["run"],()=>this.draw()),this.progress=vp(e,{row:i=>this.grow(i),replaced:i=>{this.replace(i).catch(s=>console.warn(String(s)))}}),this.draw(),this.stayAt(this.state.get("section"))}data;app;state=new Vh;progress;stores;ends=new Map;redrawing=0;stayAt(e){if(e==="")return;Ol(e);let t=new ResizeObserver(()=>document.getElementById(e)?.scrollIntoView()),i=()=>t.disconnect();t.observe(this.app),window.setTimeout(i,mA);for(let s of["wheel","pointerdown","keydown","touchstart"])window.addEventListener(s,i,{once:!0,passive:!0})}get index(){return Math.min(this.state.get("run"),this.data.runs.length-1)}draw(){for(let i of this.ends.values())i.abort();if(this.ends.clear(),this.data.runs.length===0){this.app.replaceChildren(T("p.problem",{},"There is no run to show."));return}let e=B_.flatMap(i=>{let s=this.mount(i);return s?[{section:i,element:s}]:[]}),t=e.map(({section:i})=>i).filter(({title:i})=>i!=="");this.app.replaceChildren(...this.progress?[this.progress]:[],bg(t,this.state,this.begin("nav")),...e.map(({element:i})=>i))}begin(e){this.ends.get(e)?.abort();let t=new AbortController;return this.ends.set(e,t),t.signal}mount(e){let{data:t,index:i,state:s,stores:r}=this,o={data:t,run:t.runs[i],index:i,state:s,store:r[i],stores:r,gone:this.begin(e.id)},a;try{a=e.render(o)}catch(l){a=T("p.problem",{role:"alert"},`This section could not be drawn: ${String(l)}`)}return a===null?null:T("section",{id:e.id,"aria-label":e.title||null},e.title!==""&&T("h2",{},e.title),a)}grow(e){this.redrawing!==0||e!==this.index&&this.data.runs.length===1||(this.redrawing=window.setTimeout(()=>{this.redrawing=0,this.redraw(k_)},pA))}async replace(e){let t=await bp(this.data);this.data.runs[e]=t.runs[e],this.stores[e]=new Qa(this.data.served,e),!(e!==this.index&&this.data.runs.length===1)&&(t.runs[e].state==="running"?this.redraw([...k_,"look"]):this.draw())}redraw(e){let t=document.activeElement?.getAttribute("aria-label")??null;for(let i of B_.filter(({id:s})=>e.includes(s))){let s=document.getElementById(i.id),r=this.mount(i);if(s&&r)s.replaceWith(r);else if(r)return this.draw()}t!==null&&window.setTimeout(()=>document.querySelector(`[aria-label="${CSS.escape(t)}"]`)?.focus({preventScroll:!0}),50)}};function _A(){let n=document.getElementById("app"),e=document.getElementById("data")?.textContent;if(n)try{new Of(JSON.parse(e??""),n)}catch(t){n.replaceChildren(T("p.problem",{role:"alert"},`The data of this page could not be read: ${String(t)}`))}}_A();})();
