// Planes and threshold, as a reader uses them.

import assert from "node:assert/strict";
import { after, describe, it } from "node:test";
import { close, open, pixels, settled, skip, slide, text } from "./browser.ts";
import { LABEL } from "../src/volume.ts";
import { fixture, THRESHOLD, written } from "./fixture.ts";

const TOP = "#look .plane:nth-of-type(1) canvas";
const FRONT = "#look .plane:nth-of-type(2) canvas";
const THRESHOLD_SLIDER = "#look .threshold-slider input";
const IOU = "#look .threshold-list dd:nth-of-type(3) b";

after(close);

describe("planes and threshold", { skip }, () => {
  const address = skip ? "" : written("look", fixture());
  const reported = fixture().data.runs[0].report.evaluation;

  it("shows the report's IoU at the report's threshold, and another one elsewhere", async () => {
    const page = await open(address);
    assert.equal(Number(await text(page, IOU)).toFixed(3), reported.iou.toFixed(3));
    await slide(page, THRESHOLD_SLIDER, 800);
    const moved = Number(await text(page, IOU));
    assert.ok(moved > 0 && moved < reported.iou - 0.05, `IoU ${moved}`);
    assert.match(await text(page, "#look .threshold-list dd:nth-of-type(2) b"), /^62\.5 %/);
    await slide(page, THRESHOLD_SLIDER, 1000 * THRESHOLD);
    assert.equal(Number(await text(page, IOU)).toFixed(3), reported.iou.toFixed(3));
    await page.waitForFunction(() => !location.hash.includes("threshold"));
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("counts the IoU near the report's threshold to three digits from the page's voxels", async () => {
    const page = await open(address, { hash: `threshold=${THRESHOLD + 1e-6}` });
    assert.ok(Math.abs(Number(await text(page, IOU)) - reported.iou) < 5e-4);
    await page.close();
  });

  it("shows nothing solid where there is no dose, and nothing of the part where only the void gets one", async () => {
    const shown = () => {
      const dark = fixture();
      Object.assign(dark.data.runs[0].report.evaluation, { gel_threshold: null, iou: 0 });
      dark.data.runs[0].report.exposure = null;
      dark.data.runs[0].volumes.length = 3;
      return dark;
    };
    const dark = shown();
    dark.data.runs[0].volumes[2].high = 0;
    dark.blobs.set("blob-0-response2", dark.blobs.get("blob-0-response2")!.fill(0));
    const page = await open(written("dark", dark));
    assert.deepEqual(await page.$$eval("#look [aria-label=Shown] button", (all) => all.map(({ textContent }) => textContent)), ["Dose", "Target", "Side by side"]);
    assert.equal(await page.$("#look .threshold"), null);
    assert.deepEqual(page.problems, []);
    await page.close();

    const aside = shown();
    const labels = aside.blobs.get("blob-0-labels1")!;
    aside.blobs.set("blob-0-response2", Uint8Array.from(labels, (label, i) => (label === LABEL.void ? i % 256 : 0)));
    const other = await open(written("aside", aside));
    assert.equal(await text(other, IOU), "0");
    assert.equal(await other.$eval(THRESHOLD_SLIDER, (slider) => (slider as HTMLInputElement).value), "1000");
    assert.deepEqual(other.problems, []);
    await other.close();
  });

  it("moves the contour and the print with the threshold", async () => {
    const page = await open(address);
    const before = await pixels(page, TOP);
    await slide(page, THRESHOLD_SLIDER, 300);
    const dose = await pixels(page, TOP);
    assert.notEqual(dose, before);
    await page.click("#look .choice button:nth-of-type(3)");
    await settled(page);
    const print = await pixels(page, TOP);
    await slide(page, THRESHOLD_SLIDER, 900);
    assert.notEqual(await pixels(page, TOP), print);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("links the planes: a click in one moves the others", async () => {
    const page = await open(address);
    const before = await pixels(page, FRONT);
    const canvas = (await page.$(TOP))!;
    await canvas.scrollIntoView();
    const box = (await canvas.boundingBox())!;
    await page.mouse.click(box.x + 0.2 * box.width, box.y + 0.3 * box.height);
    await settled(page);
    assert.notEqual(await pixels(page, FRONT), before);
    assert.match(await text(page, "#look .plane:nth-of-type(2) .place"), /^y = 0\.\d+ mm/);
    assert.match(await text(page, "#look .readout"), /^x −1\.000, y 0\.680, z 0\.040 mm .* dose 0\.\d+ · target/);
    await page.close();
  });

  it("names the voxel under the pointer by its middle, as the planes name theirs", async () => {
    const page = await open(address);
    const places = async () => (await page.$$eval("#look .plane .place", (all) => all.map(({ textContent }) => textContent ?? ""))).map((place) => /^(.) = (\S+) mm/.exec(place)!.slice(1).join(" "));
    const read = async () => (await text(page, "#look .readout")).split(" mm")[0].split(", ");
    const agree = async () => assert.deepEqual(await read(), (await places()).reverse());
    await agree();
    const canvas = (await page.$(TOP))!;
    await canvas.scrollIntoView();
    const box = (await canvas.boundingBox())!;
    const [x, y] = [box.x + 0.31 * box.width, box.y + 0.67 * box.height];
    await page.mouse.move(x, y);
    const under = await read();
    await page.mouse.click(x, y);
    await settled(page);
    assert.deepEqual(await read(), under);
    await agree();
    await page.close();
  });

  it("draws arrows of the axes, to the right and upward", async () => {
    const page = await open(address);
    // White on the ground of labels: the tips are drawn, and nothing beyond the corner of the arrows
    const white = (selector: string) =>
      page.$eval(selector, (element) => {
        const canvas = element as HTMLCanvasElement;
        const ratio = window.devicePixelRatio;
        const [left, top] = [canvas.width - 43 * ratio, canvas.height - 43 * ratio];
        const { data } = canvas.getContext("2d")!.getImageData(left, top, 38 * ratio, 38 * ratio);
        const is = (x: number, y: number) => Math.min(...data.slice(4 * (Math.round(y * ratio) * 38 * ratio + Math.round(x * ratio)), 4 * (Math.round(y * ratio) * 38 * ratio + Math.round(x * ratio)) + 3)) > 150;
        return [is(8, 20), is(18, 30), is(20, 18)];
      });
    for (const plane of [1, 2, 3]) assert.deepEqual(await white(`#look .plane:nth-of-type(${plane}) canvas`), [true, true, false]);
    await page.close();
  });

  it("works with the keyboard alone", async () => {
    const page = await open(address);
    const focused = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent ?? "");
    const seen = new Set<string>();
    for (let i = 0; i < 200 && !seen.has("Gel threshold"); i++) {
      await page.keyboard.press("Tab");
      const name = await focused();
      seen.add(name);
      if (name === "Top view, x–y: slice along z") {
        const place = await text(page, "#look .plane:nth-of-type(1) .place");
        await page.keyboard.press("ArrowUp");
        await settled(page);
        assert.notEqual(await text(page, "#look .plane:nth-of-type(1) .place"), place);
        await page.keyboard.press("Home");
        await settled(page);
        assert.match(await text(page, "#look .plane:nth-of-type(1) .place"), /1 of 16$/);
        const outline = await page.evaluate(() => getComputedStyle(document.activeElement!).outlineStyle);
        assert.equal(outline, "solid");
      }
      if (name === "Error") await page.keyboard.press("Enter");
      if (name === "Gel threshold") await page.keyboard.press("ArrowRight");
    }
    await settled(page);
    for (const name of ["Error", "Top view, x–y: slice along z", "Gel threshold"]) assert.ok(seen.has(name), `Tab reaches ${name}`);
    assert.equal(await page.$eval("#look .choice button:nth-of-type(4)", (button) => button.getAttribute("aria-pressed")), "true");
    assert.match(await text(page, "#look .threshold-list dd:nth-of-type(1) b"), /^0\.501/);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("restores a view from its address, and writes the address", async () => {
    const page = await open(address, { hash: "layer=error&at=0.4,-0.2,0.12&threshold=0.7" });
    assert.equal(await page.$eval("#look .choice button:nth-of-type(4)", (button) => button.getAttribute("aria-pressed")), "true");
    assert.match(await text(page, "#look .plane:nth-of-type(3) .place"), /^x = 0\.440 mm/);
    assert.equal(await text(page, "#look .threshold-list dd:nth-of-type(1) b"), "0.7");
    await slide(page, THRESHOLD_SLIDER, 250);
    await page.waitForFunction(() => location.hash.includes("threshold=0.25"));
    const again = await open(page.url().split("#")[0], { hash: page.url().split("#")[1] });
    assert.equal(await text(again, "#look .threshold-list dd:nth-of-type(1) b"), "0.25");
    assert.match(again.url(), /layer=error/);
    await again.close();
    await page.close();
  });

  it("shows properties and times of cure as layers, on their scales", async () => {
    const page = await open(address, { hash: "layer=property4" });
    assert.match(await text(page, "#look .color-legend"), /1900Modulus, MPa, logarithmic/);
    assert.match(await text(page, "#look .readout"), /modulus \d.* MPa/);
    await page.close();
  });

  it("is quick: the slider redraws in less than 30 ms at 192³", async () => {
    const large = fixture();
    const n = 192;
    for (const info of large.data.runs[0].volumes.filter(({ kind }) => ["target", "labels", "response"].includes(kind))) {
      const small = large.blobs.get(`blob-0-${info.id}`)!;
      const [nz, ny, nx] = info.shape_zyx;
      const at = (i: number, count: number) => Math.floor((i * count) / n);
      const codes = new Uint8Array(n ** 3);
      for (let z = 0, i = 0; z < n; z++) for (let y = 0; y < n; y++) for (let x = 0; x < n; x++, i++) codes[i] = small[(at(z, nz) * ny + at(y, ny)) * nx + at(x, nx)];
      info.shape_zyx = [n, n, n];
      large.blobs.set(`blob-0-${info.id}`, codes);
    }
    large.data.runs[0].volumes = large.data.runs[0].volumes.slice(0, 3);
    const page = await open(written("large", large));
    const moves = 20;
    await page.tracing.start({ categories: ["devtools.timeline"] });
    await page.$eval(
      THRESHOLD_SLIDER,
      async (element, count) => {
        for (let i = 0; i < count; i++) {
          (element as HTMLInputElement).value = String(400 + 10 * i);
          element.dispatchEvent(new Event("input", { bubbles: true }));
          await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 5)));
        }
      },
      moves,
    );
    const traced = Buffer.from((await page.tracing.stop())!).toString();
    // Time of the processor, so that other work of the machine does not count
    const events = (JSON.parse(traced) as { traceEvents: { name: string; tdur?: number }[] }).traceEvents;
    const work = events.filter(({ name }) => name === "FireAnimationFrame" || name === "EventDispatch");
    const perMove = work.reduce((sum, { tdur }) => sum + (tdur ?? 0), 0) / 1000 / moves;
    assert.ok(perMove > 0.1 && perMove < 30, `${perMove} ms`);
    await page.close();
  });
});
