// Every metric: of the written patterns while the vial turns, and before they are written.

import type { Metric } from "../data.ts";
import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Series } from "./chart.ts";
import { shown } from "./head.ts";
import { inVoxels, isNumber, significant, unitOf, type Measure } from "./number.ts";
import { isGray, list, report, type Evaluation } from "./schema.ts";
import { dataTable } from "./table.ts";
import { copyButton, csvLine, part } from "./text.ts";

interface Column {
  name: string;
  evaluation: Evaluation;
}

export function numbers({ data, run }: Context): HTMLElement | null {
  const { evaluation, optimization } = report(run);
  const columns = [
    { name: "Turning", evaluation },
    { name: "Optimization", evaluation: optimization },
  ].filter((column): column is Column => Boolean(column.evaluation));
  const metrics = known(data.metrics, columns, isGray(evaluation) ? data.gray_headline : []);
  if (metrics.length === 0) return null;
  const gray = isGray(evaluation) ? " For a gray target, “part” is where its value is at least ½." : "";
  const heads = columns.map(({ name, evaluation: of }) => h("span", {}, name, h("small", {}, voxels(of))));
  return h(
    "div",
    {},
    h(
      "p.quiet",
      {},
      "↑ larger is better, ↓ smaller is better. The first column is on the evaluation's voxels, from the patterns as they were written, while the vial turns; the other one is of the " +
        `patterns before they are written, on the job's own voxels.${gray}`,
    ),
    copyButton("Copy as CSV", () => csv(metrics, columns)),
    dataTable({ caption: "All numbers", heads: ["", ...heads], rows: metrics.map((metric) => [title(metric), ...columns.map((column) => cell(metric, column))]), strong: 1 }),
    curves(columns),
  );
}

/** IoU over the threshold. */
function curves(columns: readonly Column[]): HTMLElement | null {
  const series = columns.map(({ name, evaluation }, i): Series => {
    const curve = list(evaluation.iou_curve);
    return { name: name.toLowerCase(), color: COLORS[i], style: i === 0 ? "line" : "dashed", x: curve.map((point) => point?.[0]), y: curve.map((point) => point?.[1]) };
  });
  const plot = chart({ title: "IoU over the gel threshold", x: { label: "gel threshold", from: 0 }, y: { label: "IoU", from: 0, to: 1 }, series });
  return plot && part("IoU over the gel threshold", plot);
}

const COLORS = ["--run-1", "--run-2"];

/** Metrics that some column has; those of a gray target first where there is one. */
function known(metrics: readonly Metric[], columns: readonly Column[], first: readonly string[]): Metric[] {
  const has = metrics.filter((metric) => columns.some(({ evaluation }) => isNumber(evaluation[metric.name])));
  const rank = (metric: Metric) => (first.includes(metric.name) ? 0 : 1);
  return has.sort((a, b) => rank(a) - rank(b));
}

/** The name of a metric with its unit, which way it is better, and what it means. */
export function title(metric: Pick<Metric, "title" | "unit" | "better" | "summary">): HTMLElement {
  const { unit } = unitOf(metric.unit);
  const arrow = metric.better === "higher" ? " ↑" : metric.better === "lower" ? " ↓" : "";
  return h("span", {}, metric.title, arrow, unit !== "" && h("span.unit", {}, ` ${unit}`), metric.summary !== "" && h("small", {}, metric.summary));
}

function voxels({ grid }: Evaluation): string {
  return isNumber(grid?.pitch_mm) ? `${significant(1e3 * grid.pitch_mm, 3)} µm voxels` : "";
}

function cell(metric: Metric, { evaluation }: Column): HTMLElement {
  const value = evaluation[metric.name] as Measure;
  const count = inVoxels(value, metric.unit, evaluation.grid?.pitch_mm);
  return h("span", {}, shown(metric, value, 4), count !== "" && h("span.unit", {}, ` (${count})`));
}

/** With every digit, and in the units of report.json. */
function csv(metrics: readonly Metric[], columns: readonly Column[]): string {
  const rows = metrics.map(({ name, unit }) => csvLine([name, unit, ...columns.map(({ evaluation }) => evaluation[name] as Measure)]));
  return [csvLine(["metric", "unit", ...columns.map(({ name }) => name)]), ...rows].join("\n") + "\n";
}
