// Sections of text, tables and curves as people use them: which of them a run has, what they say, and that nothing breaks them.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import type { Run } from "../src/data.ts";
import { clock, significant, toldApart } from "../src/report/number.ts";
import { tonesOf } from "../src/report/tones.ts";
import { LABEL, Volume } from "../src/volume.ts";
import { close, open, pixels, settled, type Shown, skip } from "./browser.ts";
import { fixture, written } from "./fixture.ts";
import { type AnyReport, comparison, gray, leaves, pageData, run } from "./report_data.ts";

after(close);

const ids = (page: Shown) => page.$$eval("#app > section", (all) => all.map((section) => section.id));

const inBrowser = (name: string, check: () => Promise<void>) => test(name, { skip }, check);

/** What is read in an element, as lines and cells are told apart. */
const text = (page: Shown, selector: string) => page.$eval(selector, (element) => (element as HTMLElement).innerText.replace(/\s+/g, " ").trim());

const count = (page: Shown, selector: string) => page.$$eval(selector, (all) => all.length);

/** A run whose report was changed. */
function changed(change: (report: AnyReport, run: Run) => void, of: Run = run()): Run {
  change(of.report, of);
  return of;
}

test("numbers are written as the command writes them", () => {
  const rows: [number | null, number, string][] = [
    [0, 3, "0"],
    [1, 3, "1"],
    [-0.0635, 2, "−0.064"],
    [0.99996, 4, "1"],
    [0.0009996, 2, "0.001"],
    [999_999, 3, "10⁶"],
    [123_456, 6, "123,456"],
    [12345.6, 3, "12,300"],
    [1e-12, 3, "10⁻¹²"],
    [0.000021, 2, "2.1·10⁻⁵"],
    [2.5e7, 3, "2.5·10⁷"],
    [Number.NaN, 3, "–"],
    [null, 3, "–"],
  ];
  for (const [value, digits, expected] of rows) assert.equal(significant(value, digits), expected);
  assert.deepEqual(toldApart([99.96, 100, 103.2], 3), ["99.96", "100", "103.2"]);
  assert.deepEqual([5.25, 75, 59.7, 7325].map(clock), ["5.25 s", "1 min 15 s", "1 min 0 s", "2 h 2 min"]);
});

/** Sections of a run that has everything, and what each of them needs. */
const NEEDS: Record<string, (report: AnyReport, run: Run) => void> = {
  limits: (report) => (report.evaluation = null),
  warnings: (report) => {
    report.warnings = [];
    report.evaluation.notes = [];
  },
  species: (report) => report.species.pop(),
  time: (report) => (report.time = []),
  properties: (report) => (report.properties = []),
  ceiling: (report, { texts }) => {
    report.ceiling = null;
    if (texts) texts.ceiling = null;
  },
  scenarios: (report) => (report.scenarios = null),
  objectives: (report) => report.optimization.objectives.pop(),
  history: (report, of) => {
    of.history = {};
    of.texts = null;
    for (const key of ["history", "levels", "process_window", "response"]) report[key] = null;
  },
  lights: (report) => (report.lights = []),
  numbers: (report) => {
    report.evaluation = null;
    report.optimization = null;
  },
  published: (report) => (report.published = {}),
  movies: (report) => (report.movies = []),
  timings: (report) => (report.run.timings_s = {}),
  job: (_, of) => (of.job = ""),
};

inBrowser("every section is there for a report that has its data", async () => {
  const page = await open(pageData());
  const found = await ids(page);
  for (const id of ["head", "notes", ...Object.keys(NEEDS)]) assert.ok(found.includes(id), `${id} of ${found.join(" ")}`);
  assert.ok(!found.includes("errors") && !found.includes("side-by-side"));
  const listed = await page.$$eval("nav.sections a", (all) => all.map((link) => link.getAttribute("href")));
  assert.deepEqual(listed, found.filter((id) => id !== "head").map((id) => `#section=${id}`));
  assert.deepEqual(page.problems, []);
  assert.ok((await ids(await open(pageData([gray()])))).includes("errors"));
});

inBrowser("a section is absent without its data", async () => {
  const page = await open(pageData());
  for (const [id, remove] of Object.entries(NEEDS)) {
    const without = await open(pageData([changed(remove)]));
    const found = await ids(without);
    assert.ok(!found.includes(id) && found.length > 5, `${id} of ${found.join(" ")}`);
    assert.deepEqual([await count(without, ".problem"), without.problems], [0, []], id);
    await without.close();
  }
  await page.close();
});

inBrowser("what is missing or null breaks nothing and is never shown as such", async () => {
  const whole = run();
  const reports: [string, AnyReport][] = [
    ["no report", null],
    ["an empty report", {}],
    ["a report of another form", "?"],
    ["nulls everywhere", leaves(whole.report, () => null)],
    ["numbers that are null", leaves(whole.report, (leaf) => (typeof leaf === "number" ? null : leaf))],
    ["strings that are missing", leaves(whole.report, (leaf) => (typeof leaf === "string" ? undefined : leaf))],
    ["gray, numbers that are null", leaves(gray().report, (leaf, key) => (typeof leaf === "number" && key !== "range" && key !== "band_half_width" ? null : leaf))],
    ...Object.keys(whole.report).map((key): [string, AnyReport] => [`${key} null`, { ...whole.report, [key]: null }]),
  ];
  for (const [name, report] of reports) {
    const page = await open(pageData([{ ...whole, report, texts: name.length % 2 ? null : whole.texts }]));
    assert.deepEqual([await page.$$eval(".problem", (all) => all.map((one) => one.textContent)), page.problems], [[], []], name);
    const words = await text(page, "#app");
    assert.doesNotMatch(words, /\b(NaN|undefined|null|Infinity)\b|\[object/, name);
    await page.close();
  }
});

inBrowser("markup in names is shown as text", async () => {
  const markup = `<img src=x onerror="window.struck = 1">&"'`;
  const of = (value: Run) => leaves(value, (leaf, key) => (typeof leaf === "string" && key !== "state" ? `${leaf} ${markup}` : leaf));
  const renamed = (value: Run) => ({ ...of(value), history: Object.fromEntries(Object.entries(value.history).map(([name, column]) => [name.startsWith("response") ? name + markup : name, column])) });
  const data = comparison();
  const page = await open({ ...data, compare: leaves(data.compare, (leaf, key) => (typeof leaf === "string" && key !== "better" ? leaf + markup : leaf)), runs: data.runs.map(renamed) });
  assert.equal(await count(page, "#app img"), 0);
  assert.equal(await page.evaluate(() => (window as unknown as { struck?: number }).struck), undefined);
  const words = await text(page, "#app");
  assert.ok(words.split("<img src=x onerror=").length > 60);
  assert.deepEqual(page.problems, []);
});

inBrowser("the head has the result, cards with unit and meaning, and where the largest deviation is", async () => {
  const page = await open(pageData());
  assert.equal(await text(page, "h1"), "wheel");
  assert.match(await text(page, "#head .lead"), /IoU of 0\.9922\. Print time N·M\/t 0\.772 mm\./);
  assert.deepEqual(await page.$$eval(".card", (all) => all.map((card) => card.getAttribute("data-metric"))), ["iou", "pw", "hausdorff_mm", "over_mm3"]);
  assert.match(await text(page, '[data-metric="iou"]'), /^IoU 0\.9922 Volume in both print and part\.$/);
  assert.match(await text(page, '[data-metric="hausdorff_mm"]'), /39\.6 µm 0\.53 voxels\. .* x = 2\.35, y = −0\.338, z = −0\.0375 mm: print without target\./);
  const other = await open(pageData([gray()]));
  assert.deepEqual(await page.$$eval(".card", (all) => all.length), 4);
  assert.match(await text(other, ".cards"), /^Rms error 0\.102/);
});

inBrowser("exposures have their ends, and limits their cost, advice and key", async () => {
  const page = await open(pageData([changed((report) => ([report.species, report.one_exposure] = [[], null]))]));
  const rows = await page.$$eval("#limits tbody tr", (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows, [
    ["Exposure", "97.3 %", "100 %", "no limit"],
    ["Time to print", "1 min 0 s", "1 min 15 s", "no limit"],
    ["Dose that gels", "0.808", "0.786", "0.763"],
  ]);
  assert.match(await text(page, '[data-cause="grid"]'), /^Voxels of the optimization −0\.037 IoU .* Lower grid\.pitch_mm\.$/);
  assert.deepEqual(await page.$$eval('[data-cause="grid"] code', (all) => all.map((code) => code.textContent)), ["grid.pitch_mm"]);
  assert.match(await text(page, '[data-cause="turning"]'), /costs nothing It turns by 10°\. light\.angles$/);
  // A link that keeps the address
  await page.click("#limits .note a");
  await page.waitForFunction(() => location.hash === "#section=time");
  const several = await open(pageData());
  assert.match(await text(several, "#limits"), /All together 98\.7 % 100 % 102 % acrylate alone/);
});

inBrowser("several species: how they are driven, alone and at one exposure", async () => {
  const page = await open(pageData());
  const words = await text(page, "#species");
  assert.match(words, /acrylate is driven by 0\.4 × uv, inhibited by 1 × violet\. epoxy is driven by 1 × uv\./);
  assert.match(words, /epoxy \(limits it\) 0\.9646 0\.786 0\.9637/);
});

inBrowser("a chart is read by keys, as a table, and says its range", async () => {
  const page = await open(pageData());
  const chart = await page.waitForSelector("#history .chart");
  const label = () => page.$eval("#history .chart-box", (box) => box.getAttribute("aria-label"));
  assert.match((await label()) ?? "", /^Loss: from 8\.1 to 107; over model calls \(dose and adjoint\) from 1 to 6\./);
  await page.waitForSelector("#history .chart-box canvas");
  await page.focus("#history .chart-box");
  await page.keyboard.press("End");
  await page.waitForFunction(() => document.querySelector("#history .unseen")?.textContent?.includes("Loss 8.1"));
  assert.match(await text(page, "#history .chart-tip"), /6 Loss 8\.1$/);
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => document.querySelector("#history .unseen")?.textContent?.includes("Loss 46.4"));
  await chart?.$eval("summary", (summary) => summary.click());
  await page.waitForSelector("#history .chart table");
  assert.deepEqual(
    await page.$$eval("#history .chart table tr", (rows) => rows.slice(0, 4).map((row) => [...row.children].map((cell) => cell.textContent))),
    [["model calls (dose and adjoint)", "Loss"], ["1", "106.7"], ["4", "46.4"], ["6", "8.1"]],
  );
  await page.evaluate(() => [...document.querySelectorAll<HTMLButtonElement>("#history .choice button")].find((button) => button.textContent === "seconds")?.click());
  assert.match((await label()) ?? "", /over time from 0\.001 to 0\.01 s/);
});

inBrowser("a hidden series comes back, and a chart follows light and dark", async () => {
  const page = await open(pageData());
  await page.waitForSelector("#species .chart-box canvas");
  const drawn = () => pixels(page, "#species .chart-box canvas");
  await settled(page);
  const first = await drawn();
  const press = () => page.$eval("#species .chart-legend button", (button) => (button as HTMLButtonElement).click());
  await press();
  await settled(page);
  assert.notEqual(await drawn(), first);
  await press();
  await settled(page);
  assert.equal(await drawn(), first);
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await settled(page);
  assert.notEqual(await drawn(), first);
});

inBrowser("lists can be followed, filtered and copied", async () => {
  const page = await open(pageData());
  await page.click('nav.sections a[href="#section=published"]');
  await page.waitForFunction(() => location.hash === "#section=published" && document.activeElement?.id === "published");
  await page.waitForSelector('nav.sections a[href="#section=published"][aria-current]');
  await page.click("#published summary");
  await page.type("#published input", "jaccard dr.tvam");
  assert.equal(await text(page, "#published .filter .quiet"), "1 of 2 numbers");
  assert.match(await text(page, "#published .fold"), /jaccard_grid 0\.9917 over 100 thresholds Dr\.TVAM 0\.9/);
  assert.match(await text(page, "#published"), /Surface of the inserts value Share that the print touches 0\.0696 In all, mm² 62\.47/);
  await page.evaluate(() => {
    const kept = window as unknown as { copied: string };
    Object.defineProperty(navigator, "clipboard", { value: { writeText: async (words: string) => void (kept.copied = words) } });
  });
  await page.$eval("#numbers .copy", (button) => (button as HTMLButtonElement).click());
  const copied = await page.evaluate(() => (window as unknown as { copied: string }).copied);
  assert.equal(copied.split("\n")[0], "metric,unit,Turning,Optimization");
  assert.ok(copied.includes("hausdorff_mm,mm,0.0396,0.0396"));
});

inBrowser("a link leads to its section", async () => {
  const page = await open(pageData(), { hash: "section=job" });
  await page.waitForFunction(() => document.activeElement?.id === "job");
});

inBrowser("several runs: the best is marked, keys that differ are listed, any run is shown in full", async () => {
  const data = comparison();
  const page = await open(data);
  assert.deepEqual((await ids(page)).slice(0, 6), ["compare", "cautions", "side-by-side", "job-keys", "thresholds", "histories"]);
  const rows = () => page.$$eval("#side-by-side tbody tr", (all) => all.map((row) => [...row.querySelectorAll("td")].map((cell) => (cell.querySelector(".best") ? "*" : "") + cell.textContent)));
  assert.deepEqual(await rows(), [["*0.9922", "0.9"], ["39.6", "*20"], ["8.1", "7"]]);
  assert.match(await text(page, "#job-keys"), /stop\.iterations 3 –$/);
  assert.match(await text(page, "#side-by-side thead"), /first optimization, evaluated by parallel second simulation/);
  assert.equal(await text(page, "#head h2"), "first");
  assert.match(await text(page, '[data-metric="iou"] .big'), /^0\.9922$/);
  await page.$$eval("#compare .choice button", (buttons) => (buttons[1] as HTMLButtonElement).click());
  assert.equal(await text(page, "#head h2"), "second");
  assert.match(await text(page, '[data-metric="iou"] .big'), /^0\.9$/);
  assert.deepEqual(page.problems, []);
  // Nothing is good of a print that is not there, nor better of what another model says
  const compare = data.compare;
  assert.ok(compare);
  const absent = await open({ ...data, compare: { ...compare, prints: [true, false] } });
  assert.equal(await count(absent, "#side-by-side .best"), 2);
  assert.equal(await absent.$eval("#side-by-side tbody tr:nth-child(2) .best", (best) => best.textContent), "39.6");
  const unfair = await open({ ...data, compare: { ...compare, marks_best: false } });
  assert.equal(await count(unfair, "#side-by-side .best"), 0);
});

inBrowser("doses of several runs share a scale, move together, and differ from the first", async () => {
  const own = fixture();
  const data = comparison();
  const blobs = new Map(own.blobs);
  // The second dose is half of the first; a third run has other voxels
  const codes = own.blobs.get("blob-0-response2");
  assert.ok(codes);
  blobs.set("blob-1-response2", codes.map((code) => code / 2));
  blobs.set("blob-2-response2", codes);
  const info = own.data.runs[0].volumes.find(({ kind }) => kind === "response");
  assert.ok(info);
  const runs = [...data.runs, run("third")].map((one, i) => ({ ...one, volumes: [i === 2 ? { ...info, pitch_mm: 2 * info.pitch_mm } : info] }));
  const page = await open(written("doses", { data: { ...data, runs }, blobs }));
  assert.deepEqual(await page.$$eval("#doses figcaption span", (all) => all.map((one) => one.textContent)), ["first", "second", "third", "second"]);
  assert.match(await text(page, "#doses"), /No difference is drawn for third: its voxels differ from those of first\./);
  const canvas = (n: number) => page.$$eval("#doses canvas", (all, k) => (all[k] as HTMLCanvasElement).toDataURL(), n);
  const before = await Promise.all([0, 1, 3].map(canvas));
  assert.notEqual(before[0], before[1]);
  await page.focus("#doses canvas");
  await page.keyboard.press("Home");
  await settled(page);
  const places = await page.$$eval("#doses .place", (all) => all.map((one) => one.textContent?.split(" · ")[0]));
  assert.equal(new Set(places).size, 1);
  const now = await Promise.all([0, 1, 3].map(canvas));
  assert.ok(now.every((picture, i) => picture !== before[i]));
  await page.$$eval("#doses .choice button", (all) => (all[1] as HTMLButtonElement).click());
  await settled(page);
  assert.match(await text(page, "#doses .place"), /^y = /);
  assert.deepEqual(page.problems, []);
});

test("the response of each gray value by hand", () => {
  const shape: [number, number, number] = [1, 1, 5];
  const info = { ...fixture().data.runs[0].volumes[0], shape_zyx: shape, low: 0, high: 1 };
  const volume = (codes: number[]) => new Volume(info, Uint8Array.from(codes));
  // Voxels of gray 0 with 0.2 and 0.4, of gray 1 with 0.8; the fourth does not count, the fifth has no value
  const response = new Volume({ ...info, high: 254 / 255, nan: 255 }, Uint8Array.from([51, 102, 204, 0, 255]));
  const tones = tonesOf(response, volume([0, 0, 255, 255, 255]), volume([LABEL.void, LABEL.void, LABEL.part, LABEL.outside, LABEL.part]));
  const rounded = tones.map(({ gray: at, mean, deviation }) => [at, mean, deviation].map((value) => Math.round(value * 1e4) / 1e4));
  assert.deepEqual(rounded, [[0.0156, 0.3, 0.1], [0.9844, 0.8, 0]]);
});

inBrowser("a gray target: errors with the band, and the response of each gray value", async () => {
  const own = fixture();
  const page = await open(written("tones", { data: pageData([{ ...gray(), volumes: own.data.runs[0].volumes }]), blobs: own.blobs }));
  const labels = await page.$$eval("#errors .chart-box", (all) => all.map((box) => box.getAttribute("aria-label")));
  assert.match(labels[0] ?? "", /^Error of bright and dark voxels: dark \(below ½\) from 0 to 50; bright from 0 to 20;/);
  assert.match(labels[1] ?? "", /^Response against gray value: mean from 0\.\d+ to 0\.\d+;.* asked for from 0 to 1; over gray value of the target from 0 to 1\./);
  assert.match(await text(page, "#errors .chart-legend"), /the objective's band/);
  assert.deepEqual(page.problems, []);
});

inBrowser("500 pixels are enough", async () => {
  for (const data of [pageData(), pageData([gray()]), comparison()]) {
    const page = await open(data, { width: 500 });
    await page.$$eval("details", (all) => all.forEach((one) => (one.open = true)));
    const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
    assert.ok(scroll <= client, `${scroll} in ${client}`);
  }
});

inBrowser("a long key is broken where 400 pixels do not hold it", async () => {
  const data = pageData();
  data.runs[0].texts!.limits[0].sentence = "Finer pixels may bring more: lower `light[0].projector.collimated.pixel_pitch_mm`, or the height of its rows.";
  const page = await open(data, { width: 400 });
  assert.match(await text(page, "#limits code"), /pixel_pitch_mm$/);
  const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(scroll <= client, `${scroll} in ${client}`);
  await page.close();
});
