// The head of the page: what was printed, how well, in what, and the headline numbers with what they mean.

import type { Metric, PageData, Run } from "../data.ts";
import { h, sentence } from "../dom.ts";
import type { Context } from "../section.ts";
import { inVoxels, isNumber, significant, unitOf, type Measure } from "./number.ts";
import { isGray, report, type Evaluation } from "./schema.ts";

export function head({ data, run }: Context): HTMLElement {
  const { part, evaluation, run: facts } = report(run);
  const isOnly = data.runs.length === 1 && !data.sweep;
  const created = facts?.created;
  return h(
    "div.head",
    {},
    h("p.brand", {}, [BRANDS[run.state], created].filter(Boolean).join(" · ")),
    h(isOnly ? "h1" : "h2", {}, isOnly ? (part ?? run.name) : run.name),
    h("p.lead", {}, sentence([run.texts?.lead, run.texts?.print_time].filter(Boolean).join(" "))),
    factList(run.texts?.facts ?? []),
    evaluation ? cards(data, evaluation) : null,
  );
}

const BRANDS: Record<Run["state"], string> = {
  done: "Tomolith print report",
  running: "Tomolith, a run that goes on",
  check: "Tomolith, a job before it runs",
  failed: "Tomolith, a run that failed",
  canceled: "Tomolith, a run that was canceled",
};

/** Characters of a fact that needs the room of two. */
const LONG = 60;

function factList(facts: readonly [string, string][]): HTMLElement | null {
  if (facts.length === 0) return null;
  return h("dl.facts", {}, ...facts.map(([name, value]) => h(value.length > LONG ? "div.long" : "div", {}, h("dt", {}, name), h("dd", {}, sentence(value)))));
}

/** The metrics that stand at the head, in their order. */
export function headline(data: PageData, evaluation: Evaluation): Metric[] {
  const names = isGray(evaluation) ? data.gray_headline : data.headline;
  return names.flatMap((name) => data.metrics.find((metric) => metric.name === name) ?? []);
}

function cards(data: PageData, evaluation: Evaluation): HTMLElement {
  return h("div.cards", {}, ...headline(data, evaluation).map((metric) => card(metric, evaluation)));
}

function card(metric: Metric, evaluation: Evaluation): HTMLElement {
  const value = evaluation[metric.name] as Measure;
  const voxels = inVoxels(value, metric.unit, evaluation.grid?.pitch_mm);
  const digits = metric.name === "iou" ? 4 : 3;
  const { unit } = unitOf(metric.unit);
  return h(
    "div.card",
    { "data-metric": metric.name },
    h("h3", {}, metric.title),
    h("p.big", {}, shown(metric, value, digits), isNumber(value) && unit !== "" && h("small", {}, ` ${unit}`)),
    h("p", {}, voxels !== "" && h("b", {}, `${voxels}. `), metric.summary, place(metric, evaluation)),
  );
}

/** A value of a metric in the unit that people read. */
export function shown(metric: Pick<Metric, "unit">, value: Measure, digits: number): string {
  const { factor } = unitOf(metric.unit);
  return significant(isNumber(value) ? value * factor : null, digits);
}

/** Where the largest deviation is. */
function place(metric: Metric, { farthest }: Evaluation): string {
  const at = farthest?.at_xyz_mm;
  if (metric.name !== "hausdorff_mm" || !at?.every(isNumber)) return "";
  const [x, y, z] = at.map((mm) => significant(mm, 3));
  return ` It is at x = ${x}, y = ${y}, z = ${z} mm: ${(farthest?.side ?? "").replaceAll("_", " ")}.`;
}
