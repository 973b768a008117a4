// What a reader looks for first: how long to expose, and what to change for a better print.

import type { Texts } from "../data.ts";
import { h, sentence } from "../dom.ts";
import type { Context } from "../section.ts";
import type { State } from "../state.ts";
import { link } from "./nav.ts";
import { clock, isNumber, NONE, significant, toldApart, type Measure } from "./number.ts";
import { list, report, type Bracket, type Limit, type OneExposure, type Report, type Species } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs, part } from "./text.ts";

export function exposureAndLimits({ run, state }: Context): HTMLElement | null {
  const data = report(run);
  if (!data.evaluation) return null;
  return h("div.two", {}, exposure(data, run.texts, state), limits(data, run.texts?.limits ?? []));
}

function exposure(data: Report, texts: Texts | null, state: State): HTMLElement {
  const rows = data.one_exposure ? rowsTogether(data.one_exposure, list(data.species)) : rowsAlone(data);
  const table = rows.length > 0 ? dataTable({ caption: "Best exposure", heads: ["", "shortest", "best", "longest"], rows, strong: 2 }) : null;
  const sentences = data.one_exposure ? [texts?.one_exposure, "The table compares exposures with it."] : (texts?.exposure ?? []);
  const hint = h("p.note", {}, "This is about the dose. When to stop in the job's schedule stands under ", link("time", "The print in time", state), ".");
  return part("Best exposure", ...paragraphs(sentences), table, list(data.time).length > 0 && hint);
}

function rowsAlone({ exposure: window }: Report): string[][] {
  if (!window) return [];
  const rows = [["Exposure", ...ends(window.percent, percents)]];
  if (window.time_s) rows.push(["Time to print", ...ends(window.time_s, clocks)]);
  // The shortest exposure belongs to the highest dose
  if (window.dose) rows.push(["Dose that gels", ...ends(turned(window.dose), numbers)]);
  const isOther = window.threshold?.best !== window.dose?.best || window.threshold?.low !== window.dose?.low;
  if (window.threshold && isOther) rows.push(["Response that gels", ...ends(turned(window.threshold), numbers)]);
  return rows;
}

/** All species on the scale of the exposure that they share. */
function rowsTogether(one: OneExposure, species: readonly Species[]): string[][] {
  const rows = [["All together", ...ends(one.percent, percents)]];
  if (one.time_s) rows.push(["Time to print", ...ends(one.time_s, clocks)]);
  for (const { name = NONE, exposure: window } of species) {
    if (!window?.dose) continue;
    const share = (dose: Measure) => (isNumber(dose) && isNumber(one.gel_dose) && dose > 0 ? (100 * one.gel_dose) / dose : null);
    const { low, best, high } = turned(window.dose);
    rows.push([`${name} alone`, ...ends({ low: share(low), best: share(best), high: share(high) }, percents)]);
  }
  return rows;
}

function turned({ low, best, high }: Bracket): Bracket {
  return { low: high ?? null, best: best ?? null, high: low ?? null };
}

type Words = (values: number[]) => string[];
const numbers: Words = (values) => toldApart(values, 3);
const percents: Words = (values) => toldApart(values, 3).map((text) => `${text} %`);
const clocks: Words = (values) => values.map(clock);

/** The three cells of a row: digits enough to tell them apart, and words where there is no limit. */
function ends(bracket: Bracket | null | undefined, words: Words): string[] {
  const values = [bracket?.low, bracket?.best, bracket?.high];
  const texts = words(values.filter(isNumber));
  return values.map((value) => (isNumber(value) ? (texts.shift() ?? "") : "no limit"));
}

function limits(data: Report, sentences: Texts["limits"]): HTMLElement | null {
  const species = list(data.species);
  const groups = species.length > 1 ? species.map((own) => ({ name: own.name ?? "", causes: list(own.limits) })) : [{ name: "", causes: list(data.limits) }];
  const filled = groups.flatMap(({ name, causes }, i) => {
    const words = sentences.find((text) => text.name === name) ?? sentences[i];
    if (causes.length === 0 && !words?.sentence) return [];
    return [h("div", {}, name !== "" && h("h4", {}, name), ...paragraphs([words?.sentence]), causeList(causes))];
  });
  return filled.length > 0 ? part("What limits the print", ...filled) : null;
}

function causeList(causes: readonly Limit[]): HTMLElement | null {
  if (causes.length === 0) return null;
  const most = Math.max(...causes.map((limit) => lossOf(limit).loss ?? 0));
  return h("ol.causes", {}, ...causes.map((limit) => causeItem(limit, most)));
}

function lossOf(limit: Limit): { loss: number | null; measure: string } {
  if (isNumber(limit.loss_in_rms_error)) return { loss: limit.loss_in_rms_error, measure: "rms error" };
  return { loss: isNumber(limit.loss_in_iou) ? limit.loss_in_iou : null, measure: "IoU" };
}

function causeItem(limit: Limit, most: number): HTMLElement {
  const { loss, measure } = lossOf(limit);
  const share = loss !== null && loss >= UNSEEN ? loss / most : 0;
  const { key, advice = "" } = limit;
  return h(
    "li",
    { "data-cause": limit.cause },
    h("div.cause-head", {}, h("b", {}, CAUSES[limit.cause ?? ""] ?? limit.cause ?? ""), h("span.loss", {}, lossInWords(loss, measure))),
    h("div.share", { "aria-hidden": "true" }, h("i", { style: `width: ${(100 * share).toFixed(1)}%` })),
    h("p", {}, sentence(advice), key && !advice.includes(key) ? h("span.key", {}, " ", h("code", {}, key)) : null),
  );
}

/** What a cause costs at least to be seen in four digits. */
const UNSEEN = 0.0005;

/** "0.037 IoU lost"; a cause that costs less than is seen costs nothing. */
function lossInWords(loss: number | null, measure: string): string {
  if (loss === null) return "";
  if (Math.abs(loss) < UNSEEN) return "costs nothing";
  const size = `${significant(Math.abs(loss), 2)} ${measure}`;
  if (measure === "IoU") return loss > 0 ? `−${size}` : `+${size}`;
  return loss > 0 ? `+${size}` : `−${size}`;
}

const CAUSES: Record<string, string> = {
  grid: "Voxels of the optimization",
  levels: "Gray levels and pixels",
  turning: "Turning during a frame",
  optics: "Pixels and frames",
  iterations: "Iterations",
  ends: "Flat faces of the part",
  exposure: "Exposure",
  time: "The brightest pixel",
};
