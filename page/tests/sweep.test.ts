// A sweep in the viewer, as people use it: maps, plots, the table, marked runs, and a run that is opened. A small server stands in for the command.

import assert from "node:assert/strict";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { after, describe, it } from "node:test";
import type { PageData, SweepData, SweepRow } from "../src/data.ts";
import { filtered } from "../src/report/sweep/filter.ts";
import { Model } from "../src/report/sweep/model.ts";
import { steps } from "../src/report/sweep/plot.ts";
import { close, open, settled, type Shown, skip, text } from "./browser.ts";
import { htmlOf } from "./fixture.ts";
import { pageData, run } from "./report_data.ts";

const METRICS = ["evaluation.iou", "evaluation.ver", "history.loss"];

function done(values: SweepRow["values"], feasible = true): SweepRow {
  return { id: "ab", values, state: "done", feasible, why: null };
}

/** Pairs lower < upper; one run has failed, one is missing, one does not meet what the best must. */
function crossed(): SweepData {
  const rows: SweepRow[] = [
    done([0.1, 0.2, 0.9, 0.02, 1]),
    done([0.1, 0.3, 0.8, 0.03, 1000], false),
    { id: "", values: [0.1, 0.4, null, null, null], state: "failed", feasible: null, why: "the dose is <b>not</b> finite" },
    done([0.2, 0.3, 0.95, 0.01, 0.5]),
    done([0.2, 0.4, 0.85, 0.04, 20]),
    { id: "", values: [0.3, 0.4, null, null, null], state: "missing", feasible: null, why: null },
  ];
  return { name: "thresholds", axes: ["lower", "upper"], metrics: METRICS, rows, best: 3, toml: 'job = "gear.toml"\n' };
}

/** One axis of another kind. */
function single(values: SweepRow["values"]): SweepData {
  return { ...crossed(), axes: ["steepness"], rows: values.map((value, i) => done([value, 0.5 + 0.1 * i, 0.1, 10 ** i])), best: values.length - 1 };
}

function scattered(): SweepData {
  return { ...crossed(), rows: Array.from({ length: 12 }, (_, i) => done([0.01 * (i * i + 1), 0.02 * ((7 * i) % 12) + 0.001 * i, 0.5 + 0.01 * i, 0.1, 1])), best: 11 };
}

/** Three axes, of which a map shows two. */
function cube(): SweepData {
  const rows = ["a", "b"].flatMap((kind) => [1, 2].flatMap((x) => [5, 6, 7].map((y) => done([kind, x, y, (kind === "a" ? 0.1 : 0.5) * x + 0.01 * y, 0, 1]))));
  return { ...crossed(), axes: ["kind", "x", "y"], rows, best: 11 };
}

const dataOf = (sweep: SweepData, served = "/token/"): PageData => ({ ...pageData(), kind: "view", title: sweep.name, served, sweep, runs: [] });

/** What `tomolith view` answers for a sweep. */
class Viewer {
  readonly asked: string[] = [];
  readonly data: PageData;
  private readonly server: Server;
  private readonly places = new Map<number, number>();

  constructor(sweep: SweepData) {
    this.data = dataOf(sweep);
    this.server = createServer((request, response) => {
      const path = (request.url ?? "").replace("/token/", "");
      this.asked.push(path);
      const row = path.match(/^open\/(\d+)$/)?.[1];
      // The page is the one of the beginning: runs are read when they are opened
      if (path === "") response.setHeader("content-type", "text/html").end(htmlOf({ data: { ...this.data, runs: [] }, blobs: new Map() }));
      else if (path === "runs.json") response.end(JSON.stringify(this.data));
      else if (path === "events") response.writeHead(200, { "content-type": "text/event-stream" }).write("\n");
      else if (row !== undefined && sweep.rows[Number(row)]?.id !== "gone") response.end(JSON.stringify({ run: this.place(Number(row)) }));
      else response.writeHead(404).end();
    });
  }

  /** A run stays where it is. */
  private place(row: number): number {
    if (!this.places.has(row)) this.places.set(row, this.data.runs.push({ ...run(`run ${row + 1}`), texts: null }) - 1);
    return this.places.get(row)!;
  }

  async start(): Promise<string> {
    await new Promise<void>((resolve) => this.server.listen(0, "127.0.0.1", resolve));
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}/token/`;
  }

  stop(): void {
    this.server.closeAllConnections();
    this.server.close();
  }
}

const modelOf = (sweep: SweepData) => new Model(sweep, dataOf(sweep).metrics);

describe("rows of a sweep", () => {
  it("are crossed or scattered, with axes in their order", () => {
    assert.deepEqual([crossed(), scattered(), cube(), single([3, 1, 2])].map((sweep) => modelOf(sweep).isCrossed), [true, false, true, false]);
    assert.deepEqual(modelOf(single([3, 1, 2])).axes[0].levels, [1, 2, 3]);
    assert.deepEqual(modelOf(single(["z", "a"])).axes[0].levels, ["z", "a"]);
    assert.equal(modelOf(single([{ ospw: { lower: 0.4 } }, "b"])).text(0, modelOf(single(["b"])).axes[0]), "ospw lower=0.4");
  });

  it("are filtered by conditions and words", () => {
    const model = modelOf(crossed());
    const runs = (filter: string) => filtered(model, filter).map((row) => row + 1);
    assert.deepEqual(runs(""), [1, 2, 3, 4, 5, 6]);
    assert.deepEqual(runs("upper >= 0.3, lower<0.2"), [2, 3]);
    assert.deepEqual(runs("iou>0.85"), [1, 4]);
    assert.deepEqual(runs("evaluation.iou != 0.9, done"), [5]);
    assert.deepEqual(runs("failed"), [3]);
    assert.deepEqual(runs("lower > 0.1, missing,"), [6]);
    assert.deepEqual(runs("nothing > 1"), []);
    assert.deepEqual(filtered(modelOf(cube()), "kind = A").length, 6);
  });

  it("have round ticks", () => {
    assert.deepEqual(steps(0.1, 0.9), [0.2, 0.4, 0.6, 0.8]);
    assert.deepEqual(steps(-3, 12), [0, 5, 10]);
    assert.deepEqual(steps(2, 2), [2]);
  });
});

describe("a sweep in the viewer", { skip }, () => {
  const viewers: Viewer[] = [];
  after(async () => {
    await close();
    viewers.forEach((viewer) => viewer.stop());
  });

  async function show(sweep: SweepData, options: Parameters<typeof open>[1] = {}): Promise<{ page: Shown; viewer: Viewer }> {
    const viewer = new Viewer(sweep);
    viewers.push(viewer);
    return { viewer, page: await open(await viewer.start(), options) };
  }

  const cell = (run: number, panel = 1) => `.sweep-panels .part:nth-child(${panel}) .mark[data-row="${run - 1}"]`;
  const press = async (page: Shown, selector: string, label: string) => {
    for (const button of await page.$$(selector)) if ((await button.evaluate((element) => element.textContent)) === label) await button.click();
    await settled(page);
  };
  const classOf = (page: Shown, selector: string) => page.$eval(selector, (element) => element.className);
  const focused = (page: Shown) => page.evaluate(() => Number((document.activeElement as HTMLElement).dataset.row) + 1);
  const isOpen = (page: Shown, name: string) => page.waitForFunction((of) => document.querySelector("#head h2")?.textContent === of, {}, name);

  it("is a map with the best, infeasible, failed and missing runs told apart", async () => {
    const { page } = await show(crossed());
    assert.match(await text(page, "#sweep-head"), /thresholds6 runs over lower \(3\), upper \(3\): 4 done, 1 failed, 1 not made yet\. The best is run 4: lower 0\.2, upper 0\.3\./);
    assert.deepEqual(await page.$$eval(".sweep-map .mark", (all) => all.map((one) => one.textContent)), ["0.9", "0.8", "", "0.95", "0.85", ""]);
    assert.deepEqual(await page.$$eval(".sweep-map .mark", (all) => all.map((one) => one.classList[1])), ["done", "infeasible", "failed", "best", "done", "missing"]);
    assert.equal(await page.$eval(cell(4), (one) => one.getAttribute("aria-label")), "Run 4: lower 0.2, upper 0.3; IoU 0.95; best");
    // Larger values of the second axis stand higher, those of the first to the right
    const at = async (run: number) => (await (await page.$(cell(run)))!.boundingBox())!;
    const [first, above, right] = [await at(1), await at(2), await at(4)];
    assert.ok(above.y < first.y && Math.abs(above.x - first.x) < 1 && right.x > above.x && Math.abs(right.y - above.y) < 1);
    assert.match(await text(page, ".sweep-keys"), /best run.*does not meet best\.where.*failed.*not made yet/);
    const colors = await page.$$eval(".sweep-map .mark", (all) => all.map((one) => getComputedStyle(one).backgroundColor));
    assert.notEqual(colors[0], colors[1]);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("says the values under the pointer, as text", async () => {
    const { page } = await show(crossed());
    assert.equal(await page.$eval(".chart-tip", (tip) => (tip as HTMLElement).hidden), true);
    await page.hover(cell(3));
    assert.match(await text(page, ".chart-tip"), /^Run 3, failed.*lower0\.1upper0\.4IoU–.*the dose is <b>not<\/b> finite$/);
    await page.hover("h1");
    assert.equal(await page.$eval(".chart-tip", (tip) => (tip as HTMLElement).hidden), true);
    await page.close();
  });

  it("opens a run by a click, says which, and goes back", async () => {
    const { page, viewer } = await show(crossed());
    await page.click(cell(5));
    await isOpen(page, "run 5");
    assert.match(await text(page, ".opened-head"), /^Run 5lower 0\.2, upper 0\.4Back/);
    assert.match(await classOf(page, cell(5)), /opened/);
    assert.equal(await page.$eval(".sweep-runs tr[aria-current] button", (one) => one.textContent), "5");
    await page.click(cell(1));
    await isOpen(page, "run 1");
    await page.click(cell(5));
    await isOpen(page, "run 5");
    assert.equal(await page.$("#compare"), null, "runs that were opened before are no comparison");
    await page.waitForFunction(() => location.hash === "#opened=5");
    await page.click(".opened-head button");
    await settled(page);
    assert.equal(await page.$("#head"), null);
    assert.equal(await focused(page), 5);
    assert.deepEqual(viewer.asked.filter((path) => path.startsWith("open/")), ["open/4", "open/0", "open/4"]);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("says why a run cannot be opened", async () => {
    const sweep = crossed();
    sweep.rows[0].id = "gone";
    const { page, viewer } = await show(sweep);
    await page.click(cell(3));
    await page.waitForFunction(() => document.querySelector("#opened .problem")?.textContent === "This run failed: the dose is <b>not</b> finite");
    await page.click(cell(6));
    await page.waitForFunction(() => document.querySelector("#opened .problem")?.textContent?.startsWith("This run has not been made yet"));
    assert.deepEqual(viewer.asked.filter((path) => path.startsWith("open/")), []);
    await page.click(cell(1));
    await page.waitForFunction(() => /answered 404/.test(document.querySelector("#opened .problem")?.textContent ?? ""));
    assert.equal(await page.$("#head"), null);
    await page.close();
  });

  it("is used from the keyboard alone", async () => {
    const { page } = await show(crossed());
    const steps = async (key: "Tab" | "ArrowLeft" | "ArrowRight" | "ArrowUp" | "ArrowDown" | "Space" | "Enter") => {
      await page.keyboard.press(key);
      await settled(page);
      return focused(page);
    };
    for (let i = 0; i < 30 && !(await page.evaluate(() => document.activeElement?.matches(".sweep-map .mark"))); i++) await page.keyboard.press("Tab");
    assert.equal(await focused(page), 4, "one stop in the map, at the best");
    assert.deepEqual([await steps("ArrowLeft"), await steps("ArrowDown"), await steps("ArrowUp"), await steps("ArrowUp"), await steps("ArrowRight")], [2, 1, 2, 3, 5]);
    assert.equal(await page.$eval(".chart-tip", (tip) => (tip as HTMLElement).hidden), false);
    await steps("Space");
    await steps("ArrowLeft");
    await steps("ArrowDown");
    await steps("Space");
    await page.waitForFunction(() => location.hash === "#marked=2,5");
    await steps("Enter");
    await isOpen(page, "run 2");
    assert.equal(await page.evaluate(() => document.activeElement?.id), "opened");
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await settled(page);
    assert.equal(await focused(page), 2);
    await page.focus('.sweep-runs button[data-row="4"]');
    await page.keyboard.press("Enter");
    await isOpen(page, "run 5");
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("draws several metrics, and exchanges the axes", async () => {
    const { page } = await show(crossed());
    await press(page, "#sweep .choice button", "history.loss");
    assert.deepEqual(await page.$$eval(".sweep-panels h3", (all) => all.map((head) => head.textContent)), ["IoU", "history.loss"]);
    assert.match(await text(page, ".sweep-panels .part:nth-child(2)"), /logarithmic/);
    await press(page, "#sweep .choice button", "IoU");
    await press(page, "#sweep .choice button", "history.loss");
    assert.deepEqual(await page.$$eval(".sweep-panels h3", (all) => all.map((head) => head.textContent)), ["history.loss"], "one stays");
    await page.select('#sweep select[data-control="across"]', "upper");
    await settled(page);
    assert.deepEqual(await page.$$eval(".axis-name", (all) => all.map((name) => name.textContent)), ["↑ lower", "upper →"]);
    await page.waitForFunction(() => location.hash === "#metric=history.loss&x=upper&y=lower");
    await page.close();
  });

  it("holds axes that a map does not show", async () => {
    const { page } = await show(cube());
    const values = () => page.$$eval(".sweep-map .mark", (all) => all.map((one) => Number((one as HTMLElement).dataset.row) + 1));
    assert.deepEqual(await values(), [10, 11, 12, 7, 8, 9].sort((a, b) => a - b).filter((run) => run % 3 === 0).concat([3, 6]).sort((a, b) => a - b), "at the level of the best: y = 7");
    await page.select('#sweep select[data-control="y"]', "5");
    await settled(page);
    assert.deepEqual(await values(), [1, 4, 7, 10]);
    await page.select('#sweep select[data-control="up"]', "y");
    await settled(page);
    assert.deepEqual(await values(), [4, 5, 6, 10, 11, 12], "x is held where the best is");
    await page.close();
  });

  it("draws a large map on one canvas, and finds the cell under the pointer", async () => {
    const n = 150;
    const rows = Array.from({ length: n * n }, (_, i) => done([i % n, Math.floor(i / n), 0.5 + (i % n) / 400, 0.1, 1]));
    rows[75 * n + 7] = { id: "", values: [7, 75, null, null, null], state: "failed", feasible: null, why: "no dose" };
    const { page } = await show({ ...crossed(), axes: ["across", "up"], rows, best: 149 });
    assert.ok((await page.$$(".mark")).length < 20, "cells are no elements");
    const canvas = (await page.$(".sweep-cells"))!;
    await canvas.evaluate((element) => element.scrollIntoView({ block: "center" }));
    const box = (await canvas.boundingBox())!;
    const at = (column: number, level: number) => [box.x + ((column + 0.5) / n) * box.width, box.y + ((n - 1 - level + 0.5) / n) * box.height] as const;
    const began = Date.now();
    await page.mouse.move(...at(7, 75));
    await page.mouse.move(at(7, 75)[0] + 0.3, at(7, 75)[1]);
    await page.waitForSelector(".chart-tip:not([hidden])");
    assert.ok(Date.now() - began < 2000);
    assert.match(await text(page, ".sweep-panels .chart-tip"), /^Run 11258, failed.*no dose$/);
    await page.mouse.move(...at(20, 100));
    await page.mouse.move(at(20, 100)[0] + 0.3, at(20, 100)[1]);
    await page.mouse.down();
    await page.mouse.up();
    await page.waitForFunction(() => location.hash.includes("opened=15021"));
    await page.$eval('.mark[data-row="15020"]', (one) => (one as HTMLElement).focus());
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowUp");
    assert.equal(await page.evaluate(() => (document.activeElement as HTMLElement).dataset.row), String(101 * n + 21));
    assert.ok((await page.$$(".mark")).length < 20);
    assert.deepEqual(page.problems, []);
    await page.close();
  });

  it("is a curve over one axis, of numbers or names", async () => {
    for (const values of [[30, 10, 20], ["osmo", "as it is", { ospw: { lower: 0.4 } }]]) {
      const { page } = await show(single(values), { hash: "metric=evaluation.iou,history.loss" });
      assert.equal((await page.$$(".sweep-plot polyline")).length, 2);
      const lefts = await page.$$eval(".sweep-panels .part:first-child .mark", (all) => all.map((one) => Number((one as HTMLElement).dataset.row)));
      assert.deepEqual(lefts, typeof values[0] === "number" ? [1, 2, 0] : [0, 1, 2]);
      await page.focus(cell(3));
      await page.keyboard.press("ArrowLeft");
      assert.equal(await focused(page), 2);
      assert.deepEqual(page.problems, []);
      await page.close();
    }
  });

  it("is dots where points are scattered, over a chosen axis", async () => {
    const { page } = await show(scattered());
    assert.deepEqual([(await page.$$(".sweep-plot .mark")).length, await page.$(".sweep-plot polyline")], [12, null]);
    const left = () => page.$eval(cell(2), (one) => (one as HTMLElement).style.left);
    const before = await left();
    await page.select('#sweep select[data-control="over"]', "upper");
    await settled(page);
    assert.notEqual(await left(), before);
    await page.click(cell(2));
    await isOpen(page, "run 2");
    await page.close();
  });

  it("sorts, filters and copies the table", async () => {
    const { page } = await show(crossed());
    await page.browserContext().overridePermissions(new URL(page.url()).origin, ["clipboard-read", "clipboard-write", "clipboard-sanitized-write"]);
    const runs = () => page.$$eval(".sweep-runs tbody th", (all) => all.map((one) => Number(one.textContent)));
    const sort = () => page.click('.sweep-runs [data-column="2"]');
    await sort();
    assert.deepEqual(await runs(), [4, 1, 5, 2, 3, 6], "larger IoU first, none last");
    assert.equal(await page.$eval(".sweep-runs th[aria-sort]", (head) => head.getAttribute("aria-sort")), "descending");
    await sort();
    assert.deepEqual(await runs(), [2, 5, 1, 4, 3, 6]);
    await page.type("#runs input[type=search]", "lower < 0.2, upper > 0.2");
    assert.deepEqual(await runs(), [2, 3]);
    assert.equal(await text(page, "#runs [role=status]"), "2 of 6 runs");
    await press(page, "#runs .copy", "Copy as CSV");
    await page.waitForFunction(() => document.querySelector("#runs .copy")?.textContent === "Copied");
    assert.deepEqual((await page.evaluate(() => navigator.clipboard.readText())).split("\n"), [
      "run,lower,upper,evaluation.iou,evaluation.ver,history.loss,state,feasible,error",
      "2,0.1,0.3,0.8,0.03,1000,done,false,",
      "3,0.1,0.4,,,,failed,,the dose is <b>not</b> finite",
      "",
    ]);
    await page.close();
  });

  it("puts marked runs side by side", async () => {
    const { page } = await show(crossed());
    const isHidden = () => page.$eval("#marked", (element) => (element as HTMLElement).hidden);
    await page.click('.sweep-runs input[data-row="3"]');
    assert.equal(await isHidden(), true, "one alone is no comparison");
    await page.keyboard.down("Shift");
    await page.click(cell(1));
    await page.keyboard.up("Shift");
    assert.equal(await isHidden(), false);
    assert.match(await text(page, "#marked table"), /Run 1×doneRun 4×best.*lower0\.10\.2upper0\.20\.3IoU ↑.*0\.90\.95/);
    assert.deepEqual(await page.$$eval("#marked .best", (all) => all.map((one) => one.textContent)), ["0.95", "0.01"]);
    assert.match(await classOf(page, cell(1)), /marked/);
    assert.equal(await text(page, ".sweep-keys button"), "Compare 2 marked runs");
    await page.click('#marked [aria-label="Leave run 4 out"]');
    assert.equal(await isHidden(), true);
    await page.close();
  });

  it("is restored by a link", async () => {
    const { page } = await show(crossed(), { hash: "opened=4&marked=1,2&metric=evaluation.ver&x=upper&y=lower" });
    await isOpen(page, "run 4");
    assert.equal(await text(page, ".sweep-panels h3"), "Voxel error rate");
    assert.equal(await text(page, ".axis-name.right"), "upper →");
    assert.equal((await page.$$("#marked .marked-run")).length, 2);
    assert.deepEqual(await page.$$eval(".sweep-runs input:checked", (all) => all.length), 2);
    await page.close();
    const odd = await show(crossed(), { hash: "opened=99&marked=0,x,77&metric=gone&x=gone&levels=9,9&plot=odd" });
    assert.equal(await text(odd.page, "#opened .problem"), "The sweep has 6 runs.");
    assert.deepEqual(odd.page.problems, []);
    await odd.page.close();
  });

  it("fits 500 px, dark", async () => {
    const { page } = await show(crossed(), { width: 500, dark: true, hash: "opened=4&marked=1,4" });
    await isOpen(page, "run 4");
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 500);
    await page.close();
  });

  it("has sweeps of one run, and of none that is done", async () => {
    const one = await show({ ...crossed(), rows: crossed().rows.slice(0, 1), best: 0 });
    assert.match(await text(one.page, ".sweep-panels"), /No axis of this sweep has more than one value/);
    const none = crossed();
    none.rows = none.rows.map((row) => ({ ...row, values: [...row.values.slice(0, 2), null, null, null], state: "missing", feasible: null }));
    const { page } = await show({ ...none, best: null });
    assert.match(await text(page, "#sweep-head"), /0 done, 6 not made yet\. No run meets best\.where/);
    assert.equal((await page.$$(".sweep-map .mark.missing")).length, 6);
    assert.deepEqual([...page.problems, ...one.page.problems], []);
    await page.close();
    await one.page.close();
  });
});
