// Numbers side by side with the best marked, and why some may not be comparable.

import type { PageData, Run } from "../../data.ts";
import { h } from "../../dom.ts";
import { shown } from "../head.ts";
import { isNumber, type Measure } from "../number.ts";
import { title } from "../numbers.ts";
import { report } from "../schema.ts";
import { dataTable } from "../table.ts";
import { bullets, copyButton, csvLine } from "../text.ts";
import { named } from "./color.ts";
import { flatJob } from "./jobs.ts";
import { rows, type Row } from "./rows.ts";

export function numbers(data: PageData): HTMLElement | null {
  const { runs } = data;
  const known = rows(data).filter((row) => runs.some((run) => isNumber(row.of(run))));
  if (known.length === 0) return null;
  // What one model says of a print is no better than what another says
  const isFair = new Set(runs.map(model)).size === 1;
  const best = isFair
    ? "the best is bold."
    : "the best is not marked, because the runs were evaluated by different models: compare only columns with the same one.";
  const body = known.map((row) => {
    const values = runs.map((run) => row.of(run));
    const winner = isFair ? bestOf(row, runs, values) : null;
    return [title({ ...row, summary: "" }), ...values.map((value, i) => cell(row, value, winner !== null && value === winner && prints(runs[i])))];
  });
  const heads = runs.map((run, i) => h("span", {}, named(run, i), h("small", {}, origin(run))));
  const csv = () => [csvLine(["number", "unit", ...runs.map((run) => run.name)]), ...known.map((row) => csvLine([row.title, row.unit, ...runs.map((run) => row.of(run))]))].join("\n") + "\n";
  return h(
    "div",
    {},
    h("p.quiet", {}, `Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; ${best}`),
    copyButton("Copy as CSV", csv),
    dataTable({ caption: "Numbers of all runs", heads: ["", ...heads], rows: body }),
  );
}

/** The best value of the runs that print anything; null where none is better than another. */
function bestOf(row: Row, runs: readonly Run[], values: readonly Measure[]): number | null {
  const known = values.filter((value, i): value is number => isNumber(value) && prints(runs[i]));
  if (row.better === "none" || runs.length < 2 || known.length === 0) return null;
  return row.better === "higher" ? Math.max(...known) : Math.min(...known);
}

function cell(row: Row, value: Measure, isBest: boolean): Node | string {
  const text = shown(row, value, 4);
  return isBest ? h("b.best", {}, text) : text;
}

/** Whether something of the part turns solid; of gray targets, which have no IoU, and of earlier reports it is taken for granted. */
function prints(run: Run | undefined): boolean {
  const evaluation = run && report(run).evaluation;
  return evaluation?.iou !== 0 && evaluation?.part?.max !== 0;
}

/** Name of the model that gave the dose that a run is evaluated by: "parallel" of "2 species by 2 lights, each alone: parallel (…". */
function model(run: Run): string {
  const text = report(run).run?.models?.["evaluation"] ?? "";
  return text.split("each alone: ").at(-1)?.split(/[ ,:]/)[0] ?? "";
}

function origin(run: Run): string {
  const kind = report(run).history ? "optimization" : "simulation";
  return model(run) === "" ? kind : `${kind}, evaluated by ${model(run)}`;
}

/** Why numbers of these runs may not be comparable, or null. */
export function cautions({ runs }: PageData): HTMLElement | null {
  const differ = (of: (run: Run) => unknown) => new Set(runs.map((run) => JSON.stringify(of(run) ?? null))).size > 1;
  const objective = (run: Run) => [...flatJob(run.job)].filter(([key]) => key.startsWith("objective"));
  const words: string[] = [];
  if (differ((run) => report(run).part)) words.push("The runs print parts of different names.");
  if (differ((run) => report(run).evaluation?.grid)) words.push("The runs were evaluated on different voxels: distances and error rates depend on them.");
  for (const run of runs) {
    if (!prints(run)) words.push(`Nothing of the part turns solid in ${run.name}: none of its numbers is marked as the best.`);
  }
  if (differ(objective)) words.push("The runs minimize different losses, whose numbers cannot be compared.");
  if (runs.some((run) => !report(run).evaluation?.iou_curve)) {
    words.push("Reports of earlier versions hold no curves: run `tomolith simulate` on their patterns to get them.");
  }
  const items = bullets(words);
  return items && h("div.warn", { role: "note" }, items);
}
