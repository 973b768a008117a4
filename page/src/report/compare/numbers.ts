// Numbers side by side with the best marked, and why some may not be comparable.

import type { Comparison, Metric, Run } from "../../data.ts";
import { h } from "../../dom.ts";
import { shown } from "../head.ts";
import { isNumber } from "../number.ts";
import { title } from "../numbers.ts";
import { dataTable } from "../table.ts";
import { bullets, copyButton, csvLine } from "../text.ts";
import { named } from "./color.ts";

type Row = Comparison["numbers"][number];

export function numbers(compare: Comparison, runs: readonly Run[], metrics: readonly Metric[]): HTMLElement | null {
  const known = compare.numbers.filter((row) => row.values.some(isNumber));
  if (known.length === 0) return null;
  const best = compare.marks_best
    ? "the best is bold."
    : "the best is not marked, because the runs were evaluated by different models: compare only columns with the same one.";
  const heads = runs.map((run, i) => h("span", {}, named(run, i), h("small", {}, origin(compare, i))));
  const meaning = (row: Row) => metrics.find(({ name }) => name === row.key)?.summary ?? null;
  const cells = (row: Row) => {
    const winner = bestOf(row, compare);
    const isBest = (value: number | null, i: number) => winner !== null && value === winner && compare.prints[i];
    const name = h("span", { title: meaning(row) }, title({ title: row.name, unit: row.unit, better: row.better, summary: "" }));
    return [name, ...row.values.map((value, i) => (isBest(value, i) ? h("b.best", {}, shown(row, value, 4)) : shown(row, value, 4)))];
  };
  const csv = () => [csvLine(["number", "unit", ...runs.map((run) => run.name)]), ...known.map((row) => csvLine([row.key, row.unit, ...row.values]))].join("\n") + "\n";
  return h(
    "div",
    {},
    h("p.quiet", {}, `Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; ${best}`),
    copyButton("Copy as CSV", csv),
    dataTable({ caption: "Numbers of all runs", heads: ["", ...heads], rows: known.map(cells) }),
  );
}

/** The best value of the runs that print anything; null where none is better than another. */
function bestOf(row: Row, { marks_best, prints }: Comparison): number | null {
  const known = row.values.filter((value, i): value is number => isNumber(value) && prints[i]);
  if (!marks_best || row.better === "none" || known.length === 0) return null;
  return row.better === "higher" ? Math.max(...known) : Math.min(...known);
}

function origin({ kinds, models }: Comparison, i: number): string {
  return [kinds[i], models[i] && `evaluated by ${models[i]}`].filter(Boolean).join(", ");
}

/** Why numbers of these runs may not be comparable, or null. */
export function cautions({ warnings }: Comparison): HTMLElement | null {
  const items = bullets(warnings);
  return items && h("div.warn", { role: "note" }, items);
}
