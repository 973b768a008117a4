// The page as a whole: narrow and dark windows, damaged arrays, no WebGL, the light's path, the film, 3D, time.

import assert from "node:assert/strict";
import { after, describe, it } from "node:test";
import { deflateSync } from "node:zlib";
import type { Page } from "puppeteer-core";
import { close, open, pixels, settled, skip, slide, text } from "./browser.ts";
import { fixture, written } from "./fixture.ts";

async function toSolid(page: Page): Promise<void> {
  await page.$eval("#solid", (element) => element.scrollIntoView());
  await page.waitForSelector("#solid canvas, #solid .problem", { timeout: 60_000 });
}

/** How many different colors a picture of an element has, from a row of pixels on, as a sign that something is drawn. */
async function colors(page: Page, selector: string, { from = 0, rows = 0 } = {}): Promise<number> {
  const png = await (await page.$(selector))!.screenshot({ encoding: "base64" });
  return page.evaluate(async (source, from, rows) => {
    const image = new Image();
    image.src = `data:image/png;base64,${source}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d")!;
    context.drawImage(image, 0, 0);
    // Corners are rounded
    const [x, width] = rows > 0 ? [40, canvas.width - 80] : [0, canvas.width];
    return new Set(new Uint32Array(context.getImageData(x, from < 0 ? canvas.height + from : from, width, rows || canvas.height).data.buffer)).size;
  }, png, from, rows);
}

after(close);

describe("the page", { skip }, () => {
  const address = skip ? "" : written("page", fixture());

  it("needs no horizontal scrolling at 500 px, in light and dark", async () => {
    for (const dark of [false, true]) {
      const page = await open(address, { width: 500, dark });
      await toSolid(page);
      const [content, window] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      assert.ok(content <= window, `${content} of ${window} px`);
      assert.deepEqual(page.problems, []);
      await page.close();
    }
  });

  it("has a dark ground where the reader wants one", async () => {
    const ground = async (dark: boolean) => {
      const page = await open(address, { dark });
      const color = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g)!.map(Number));
      await page.close();
      return color[0] + color[1] + color[2];
    };
    const [light, dark] = [await ground(false), await ground(true)];
    assert.ok(light > 600 && dark < 150, `${light} ${dark}`);
  });

  it("says which array is damaged, and shows the others", async () => {
    const damaged: [string, RegExp][] = [["no base64!", /“response2” is damaged.*no base64/], ["AAAA", /“response2” is damaged/]];
    for (const [content, message] of damaged) {
      const page = await open(written("damaged", fixture(), { "blob-0-response2": content }));
      assert.match(await text(page, "#look .problem"), message);
      assert.equal((await page.$$("#look .plane canvas")).length, 3, "the target is shown");
      assert.ok((await page.$("#head")) !== null);
      await page.close();
    }
    const short = fixture();
    short.blobs.set("blob-0-film0", new Uint8Array(7));
    const page = await open(written("short", short));
    assert.match(await text(page, "#film .problem"), /“film0” is damaged: 7 bytes where 1,920 are expected/);
    await page.close();
    const missing = fixture();
    missing.blobs.delete("blob-0-labels1");
    const other = await open(written("missing", missing));
    assert.match(await text(other, "#look .problem"), /“labels1” is damaged or missing/);
    await other.close();
  });

  it("says so where its data are damaged", async () => {
    const page = await open(written("no-data", fixture(), { data: "{" }));
    assert.match(await text(page, "#app .problem"), /could not be read/);
    await page.close();
    for (const [data, message] of [["null", /their schema is “missing”/], ['{"schema": "tomolith.page/9"}', /their schema is “tomolith.page\/9”/], ['{"schema": "tomolith.page/2"}', /the list of runs is missing/]] as const) {
      const other = await open(written("other-data", fixture(), { data }));
      assert.match(await text(other, "#app .problem"), message);
      await other.close();
    }
  });

  it("shows a run without volumes, patterns or report", async () => {
    const bare = fixture();
    Object.assign(bare.data.runs[0], { volumes: [], films: [], scene: null, report: { part: "disc" }, history: {} });
    const page = await open(written("bare", bare));
    for (const id of ["look", "solid", "film", "in-time"]) assert.equal(await page.$(`#${id}`), null, id);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("says that WebGL is missing, and shows the slices", async () => {
    const page = await open(address, { noWebGl: true });
    assert.match(await text(page, "#solid .problem"), /no WebGL 2/);
    assert.equal((await page.$$("#look .plane canvas")).length, 3);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("makes the surface at the threshold and cuts it", async () => {
    const page = await open(address);
    await toSolid(page);
    await page.waitForFunction(() => /surface at a threshold of 0\.5/.test(document.querySelector("#solid .below-planes")?.textContent ?? ""));
    assert.ok((await colors(page, "#solid canvas")) > 50);
    await slide(page, "#look .threshold-slider input", 800);
    await page.waitForFunction(() => /surface at a threshold of 0\.8/.test(document.querySelector("#solid .below-planes")?.textContent ?? ""));
    for (const button of await page.$$("#solid .choice button")) {
      if ((await button.evaluate((element) => element.textContent)) === "Cut along y") await button.click();
    }
    await page.waitForFunction(() => location.hash.includes("cut=y"));
    assert.ok((await colors(page, "#solid canvas")) > 50);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("holds a target of a few voxels in view", async () => {
    const tiny = fixture();
    const [nz, ny, nx] = tiny.data.runs[0].volumes[0].shape_zyx;
    tiny.blobs.set("blob-0-target0", Uint8Array.from({ length: nx * ny * nz }, (_, i) => ([[i % nx, nx], [Math.floor(i / nx) % ny, ny], [Math.floor(i / nx / ny), nz]].every(([at, n]) => at === n / 2 || at === n / 2 - 1) ? 255 : 0)));
    const page = await open(written("tiny", tiny), { hash: "solid=target" });
    await toSolid(page);
    await page.waitForFunction(() => document.querySelector("#solid .color-legend")?.textContent === "target");
    await page.waitForNetworkIdle();
    assert.ok((await colors(page, "#solid canvas")) > 50);
    for (const from of [4, -8]) assert.equal(await colors(page, "#solid canvas", { from, rows: 4 }), 1, `rows from ${from}`);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("plays the film, chooses frames in the sinogram, and follows them with the light's path", async () => {
    const page = await open(address);
    const frame = () => text(page, "#film figcaption output");
    assert.equal(await frame(), "frame 1 of 12, 0°");
    const ray = () => page.$eval("#film .ray.resin", (path) => path.getAttribute("d"));
    const before = await ray();
    await page.$eval("#film", (element) => element.scrollIntoView());
    const sinogram = (await page.$("#film canvas[role=slider]"))!;
    const box = (await sinogram.boundingBox())!;
    await page.mouse.click(box.x + 0.55 * box.width, box.y + 0.5 * box.height);
    await settled(page);
    assert.equal(await frame(), "frame 7 of 12, 180°");
    assert.notEqual(await ray(), before);
    assert.match(await text(page, "#film .paths"), /Light from 180°\. Every frame lights all within 1\.4 mm/);
    await sinogram.focus();
    await page.keyboard.press("ArrowRight");
    await settled(page);
    assert.equal(await frame(), "frame 8 of 12, 210°");
    await page.click("#film .film-controls button");
    await page.waitForFunction(() => !document.querySelector("#film figcaption output")?.textContent?.startsWith("frame 8"));
    await page.click("#film .film-controls button");
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("turns the rays of a round vial to the chosen frame, and says elsewhere which frame's they are", async () => {
    for (const [is_round, said] of [[true, /^Light from 180°\. Every/], [false, /^Light from 0°, the nearest frame whose rays the page has\./]] as const) {
      const few = fixture();
      const scene = few.data.runs[0].scene!;
      scene.is_round = is_round;
      const opposite = scene.lights[0].frames[6].rays;
      scene.lights[0].frames = scene.lights[0].frames.slice(0, 1);
      const page = await open(written(`few-rays-${is_round}`, few), { hash: "frame=6" });
      assert.match(await text(page, "#film .paths .quiet"), said);
      const [x] = opposite[0].points[1];
      const d = (await page.$eval("#film .ray.resin", (path) => path.getAttribute("d")))!;
      assert.equal(d.startsWith(`M${x.toFixed(4)},`), is_round, d);
      await page.close();
    }
  });

  it("shows what is solid at a moment", async () => {
    const page = await open(address);
    const shown = () => text(page, "#in-time output");
    assert.match(await shown(), /^30 s .*IoU 0\.9$/);
    const before = await pixels(page, "#in-time .plane canvas");
    await slide(page, "#in-time .time-controls input", 500);
    assert.match(await shown(), /^1 min 0 s .*IoU 0\.7$/);
    assert.notEqual(await pixels(page, "#in-time .plane canvas"), before);
    const grown = await pixels(page, "#in-time .plane canvas");
    await page.click("#in-time .choice button:nth-of-type(2)");
    await settled(page);
    assert.notEqual(await pixels(page, "#in-time .plane canvas"), grown);
    assert.match(await text(page, "#in-time .below-planes"), /missing.*too much/);
    await page.close();
  });

  it("clamps a point of the address to the volume, and refuses an array of which a byte was changed", async () => {
    const page = await open(address, { hash: "at=99,-99,0" });
    assert.match(await text(page, "#look .readout"), /^x 1\.560, y −1\.560, z 0\.040 mm/);
    await page.close();
    const whole = fixture();
    const packed = deflateSync(whole.blobs.get("blob-0-response2")!);
    packed[packed.length - 1] ^= 1;
    const damaged = await open(written("checksum", whole, { "blob-0-response2": packed.toString("base64") }));
    assert.match(await text(damaged, "#look"), /The array “response2” is damaged or missing: it cannot be unpacked/);
    await damaged.close();
  });

  it("lists many layers, and names a body under the pointer", async () => {
    const many = fixture();
    const [run] = many.data.runs;
    const property = run.volumes.find(({ kind }) => kind === "property")!;
    for (let i = 0; i < 4; i++) {
      run.volumes.push({ ...property, id: `more${i}`, name: `degree of cure after ${i} s` });
      many.blobs.set(`blob-0-more${i}`, many.blobs.get(`blob-0-${property.id}`)!);
    }
    const dose = run.volumes.find(({ kind }) => kind === "response")!;
    run.volumes.push({ ...dose, id: "bodies", kind: "bodies", low: 0, high: 255 });
    many.blobs.set("blob-0-bodies", many.blobs.get(`blob-0-${dose.id}`)!.map((code) => (code > 250 ? 2 : 0)));
    const page = await open(written("many", many));
    assert.match(await text(page, "#look .readout"), /insert$/);
    await page.select("#look .controls select", "more3");
    await page.waitForFunction(() => location.hash.includes("layer=more3"));
    assert.equal(await page.$eval("#film .path-view .body title", ({ textContent }) => textContent), "insert");
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("shows markup in names as text", async () => {
    const odd = fixture();
    odd.data.runs[0].volumes[4].name = "<img src=x onerror=window.broken=1>";
    odd.data.runs[0].scene!.walls[0].name = "</script><b>";
    const page = await open(written("markup", odd));
    assert.match(await text(page, "#look .choice"), /<img src=x/);
    assert.equal(await page.evaluate(() => (window as { broken?: number }).broken), undefined);
    await page.close();
  });
});
