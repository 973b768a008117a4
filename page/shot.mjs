import puppeteer from 'puppeteer-core';
const [,, file, out, h] = process.argv;
const b = await puppeteer.launch({executablePath:'/usr/bin/chromium', args:['--no-sandbox','--use-angle=swiftshader','--enable-unsafe-swiftshader']});
const p = await b.newPage(); await p.setViewport({width:1200,height:+(h||1000)});
await p.goto('file://'+file); await new Promise(r=>setTimeout(r,2500));
await p.screenshot({path:out}); await b.close();
