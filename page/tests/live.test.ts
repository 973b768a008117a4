// The page of a viewer: a run that goes on, its cancel button, its end, and slices with all voxels. A small server stands in for the command.

import assert from "node:assert/strict";
import { createServer, type Server, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { after, describe, it } from "node:test";
import { deflateSync } from "node:zlib";
import { close, open, pixels, settled, skip, slide, text } from "./browser.ts";
import { type Fixture, fixture, htmlOf, written } from "./fixture.ts";

/** What `tomolith view` answers. */
class Viewer {
  readonly asked: string[] = [];
  /** What a request to cancel is answered with. */
  cancels = 202;
  /** Why it has no slices any more. */
  lost: string | null = null;
  private readonly server: Server;
  private readonly listeners = new Set<ServerResponse>();

  constructor(public shown: Fixture) {
    shown.data.served = "/token/";
    this.server = createServer((request, response) => {
      const path = (request.url ?? "").replace("/token/", "");
      this.asked.push(`${request.method} ${path}`);
      const array = path.match(/^run\/(\d+)\/(?:volume|film)\/(\w+)$/);
      if (path === "") response.setHeader("content-type", "text/html").end(htmlOf({ data: this.shown.data, blobs: new Map() }));
      else if (path === "runs.json") response.end(JSON.stringify(this.shown.data));
      else if (path === "events") {
        response.writeHead(200, { "content-type": "text/event-stream" });
        response.write(`data: ${JSON.stringify({ type: "states", states: this.shown.data.runs.map(({ state }) => state) })}\n\n`);
        this.listeners.add(response);
      } else if (array) response.end(deflateSync(this.shown.blobs.get(`blob-${array[1]}-${array[2]}`)!));
      else if (path.startsWith("run/0/slice/")) this.lost === null ? response.end(sliceOf(path)) : response.writeHead(410).end(this.lost);
      else response.writeHead(path.startsWith("cancel/") ? this.cancels : 404).end();
    });
  }

  async start(): Promise<string> {
    await new Promise<void>((resolve) => this.server.listen(0, "127.0.0.1", resolve));
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}/token/`;
  }

  tell(event: object): void {
    for (const listener of this.listeners) listener.write(`data: ${JSON.stringify(event)}\n\n`);
  }

  stop(): void {
    for (const listener of this.listeners) listener.end();
    this.server.close();
  }
}

/** A slice of 80 × 80 or 80 × 32 voxels in 16 bits, brighter to the right. */
function sliceOf(path: string): Buffer {
  const [height, width] = path.includes("axis=0") ? [80, 80] : [32, 80];
  const codes = Uint16Array.from({ length: width * height }, (_, i) => Math.round((65535 * (i % width)) / (width - 1)));
  return Buffer.concat([Buffer.from(`${JSON.stringify({ shape: [height, width], low: 0, high: 1, bits: 16 })}\n`), Buffer.from(codes.buffer)]);
}

function running(): Fixture {
  const going = fixture();
  const [run] = going.data.runs;
  going.data.kind = "view";
  Object.assign(run, { state: "running", report: null, texts: null, films: [], scene: null, history: {}, volumes: run.volumes.filter(({ kind }) => ["response", "target", "labels"].includes(kind)) });
  return going;
}

describe("a viewer", { skip }, () => {
  let viewer: Viewer;
  after(async () => {
    await close();
    viewer.stop();
  });

  it("follows a run, cancels it, and shows its result", async () => {
    viewer = new Viewer(running());
    const page = await open(await viewer.start());
    assert.match(await text(page, ".live-run"), /^disc.*Cancel$/);
    viewer.tell({ type: "stage", run: 0, name: "optimizing" });
    viewer.tell({ type: "iteration", run: 0, row: { iteration: 3, loss: 5, seconds: 1, forward_calls: 7, adjoint_calls: 3 }, iterations: 12 });
    await page.waitForFunction(() => document.querySelector(".live-run")?.textContent?.includes("optimizing: iteration 3 of at most 12"));
    assert.equal(await page.$eval(".live progress", (bar) => (bar as HTMLProgressElement).value), 0.25);
    viewer.tell({ type: "iteration", run: 0, row: { iteration: 4, loss: 4, seconds: 2, forward_calls: 9, adjoint_calls: 4 }, iterations: 12 });
    await page.waitForSelector("#history .chart-box canvas");
    assert.match(await text(page, "#history .note"), /^4 iterations, 9 dose and 4 adjoint calls, 2 s\./);
    assert.match(await text(page, "#history .chosen [aria-pressed=true]"), /^model calls$/);
    await page.click(".live-run button");
    await page.waitForFunction(() => document.querySelector(".live-run button")?.textContent === "Canceling…");
    assert.ok(viewer.asked.includes("POST cancel/0"));

    viewer.shown = fixture();
    viewer.shown.data.served = "/token/";
    viewer.tell({ type: "done", run: 0 });
    await page.waitForSelector("#look .threshold");
    assert.equal(await page.$(".live-run"), null);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("says why a run has ended without a result, and keeps the last picture", async () => {
    for (const [type, message, head] of [["failed", "the dose is not finite", /a run that failed/], ["canceled", "The run was canceled.", /a run that was canceled/]] as const) {
      viewer.stop();
      viewer = new Viewer(running());
      const page = await open(await viewer.start());
      assert.match(await text(page, "#head .brand"), /a run that goes on/);
      const before = await pixels(page, "#look .plane canvas");
      viewer.tell({ type, run: 0, message });
      await page.waitForSelector(".live-run .problem:not([hidden])");
      assert.ok((await text(page, ".live-run .problem")).startsWith(`${message} This page shows what there was last`));
      assert.match(await text(page, "#head .brand"), head);
      viewer.stop();
      await new Promise((resolve) => setTimeout(resolve, 500));
      assert.equal(await page.$(".live > .problem:not([hidden])"), null, "nobody asks a viewer that has ended");
      assert.equal(await pixels(page, "#look .plane canvas"), before);
      assert.deepEqual(page.problems, []);
      await page.close();
    }
  });

  it("says that a run could not be canceled", async () => {
    viewer.stop();
    viewer = new Viewer(running());
    viewer.cancels = 403;
    const page = await open(await viewer.start());
    await page.click(".live-run button");
    await page.waitForSelector(".live-run .problem:not([hidden])");
    assert.match(await text(page, ".live-run .problem"), /refused to cancel the run \(it answered 403\)/);
    assert.equal(await page.$eval(".live-run button", (button) => (button as HTMLButtonElement).disabled), false);
    await page.close();
  });

  it("shows new doses of a run that goes on against its target", async () => {
    viewer.stop();
    viewer = new Viewer(running());
    const page = await open(await viewer.start());
    const iou = () => text(page, "#look .threshold-list dd:nth-of-type(3) b");
    assert.ok(Number(await iou()) > 0.8, await iou());
    assert.deepEqual(await page.$$eval("#look [aria-label=Shown] button", (all) => all.map(({ textContent }) => textContent)), ["Dose", "Target", "Print", "Error", "Side by side"]);
    await page.click("#look [aria-label=Shown] button:nth-of-type(4)");
    await page.$eval("#solid", (element) => element.scrollIntoView());
    await page.waitForFunction(() => /surface at a threshold/.test(document.querySelector("#solid .below-planes")?.textContent ?? ""));
    await page.$eval("#look", (element) => element.scrollIntoView());
    const [first, canvas] = [await pixels(page, "#look .plane canvas"), await page.$("#solid canvas")];
    const best = await iou();
    viewer.shown.blobs.set("blob-0-response2", viewer.shown.blobs.get("blob-0-response2")!.map((code, i) => (i % 40 > 20 ? code >> 2 : code)));
    viewer.tell({ type: "snapshot", run: 0 });
    await page.waitForFunction((before) => document.querySelector("#look .threshold-list dd:nth-of-type(3) b")?.textContent !== before, {}, best);
    await settled(page);
    assert.notEqual(await pixels(page, "#look .plane canvas"), first);
    assert.ok(Number(await iou()) < Number(best) - 0.1, await iou());
    assert.equal(await page.$eval("#look [aria-label=Shown] [aria-pressed=true]", ({ textContent }) => textContent), "Error");
    assert.ok(await canvas!.evaluate((element) => element.isConnected), "the 3D view stays");
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("takes finer slices from the server when they are there", async () => {
    viewer.stop();
    const fine = fixture();
    const [run] = fine.data.runs;
    const dose = run.volumes.find(({ kind }) => kind === "response")!;
    dose.full = true;
    run.report.optimization = { grid: { shape_zyx: [32, 80, 80], pitch_mm: 0.04, center_xyz_mm: [0, 0, 0] } };
    const coarse = await open(written("coarse", fixture()));
    const before = await pixels(coarse, "#look .plane canvas");
    await coarse.close();
    viewer = new Viewer(fine);
    const page = await open(await viewer.start());
    await page.waitForFunction(() => performance.getEntriesByType("resource").filter(({ name }) => name.includes("/slice/")).length >= 3);
    await new Promise((resolve) => setTimeout(resolve, 300));
    assert.notEqual(await pixels(page, "#look .plane canvas"), before);
    assert.ok(viewer.asked.some((path) => /^GET run\/0\/slice\/response2\?axis=0&index=16$/.test(path)), viewer.asked.join(" "));
    assert.equal(viewer.asked.filter((path) => path.includes("/slice/")).length, 3, "each slice is asked for once");
    assert.equal(await page.$("#look .problem:not([hidden])"), null);
    viewer.lost = "out/disc/dose.npy: the file is missing";
    await slide(page, "#look .plane input[type=range]", 5);
    await page.waitForSelector("#look .problem:not([hidden])");
    assert.match(await text(page, "#look .problem:not([hidden])"), /^The slices with all voxels did not come, so fewer are shown: out\/disc\/dose.npy: the file is missing$/);
    viewer.lost = null;
    await slide(page, "#look .plane input[type=range]", 9);
    await page.waitForFunction(() => document.querySelector("#look .problem:not([hidden])") === null);
    assert.deepEqual(page.problems, []);
    await page.close();
  });
});
