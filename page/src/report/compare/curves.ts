// Histories, doses and IoU of all runs, laid over each other.

import type { PageData, Run } from "../../data.ts";
import { h } from "../../dom.ts";
import { chart, type Axis, type Series } from "../chart.ts";
import { costAxis, costOf, overCost, type Cost } from "../history.ts";
import { isNumber, type Measure } from "../number.ts";
import { list, report, type Histogram } from "../schema.ts";
import { part } from "../text.ts";
import { colorOf, lineOf } from "./color.ts";

export function histories({ runs }: PageData): HTMLElement | null {
  if (!runs.some((run) => (run.history?.loss ?? []).filter(isNumber).length > 1)) return null;
  const plot = (title: string, y: Axis, of: (run: Run) => Measure[], cost: Cost) => {
    const series = runs.map((run, i) => lineOf(run, i, costOf(run, cost), of(run)));
    const drawn = chart({ title: `${title} over ${cost}`, x: costAxis(cost), y, series });
    return drawn && part(title, drawn);
  };
  const short = (run: Run) => (run.history?.iou ?? []).map((iou) => (isNumber(iou) ? 1 - iou : null));
  const plots = overCost(runs, (cost) => [
    plot("Loss", { label: "loss", log: true }, (run) => run.history?.loss ?? [], cost),
    plot("Voxels that would print wrongly", { label: "1 − IoU", log: true }, short, cost),
    plot("Process window", { label: "response" }, (run) => run.history?.process_window ?? [], cost),
  ]);
  const note = "Compare methods by model calls, not by iterations; seconds are those of the machine of each run. IoU is that on the grid of each optimization, where it was measured.";
  return h("div", {}, plots, h("p.note", {}, note));
}

export function thresholds({ runs }: PageData): HTMLElement | null {
  const iou = chart({
    title: "IoU over the gel threshold",
    x: { label: "gel threshold", from: 0 },
    y: { label: "IoU", from: 0, to: 1 },
    series: runs.map((run, i) => {
      const curve = list(report(run).evaluation?.iou_curve);
      return lineOf(run, i, curve.map((point) => point?.[0]), curve.map((point) => point?.[1]));
    }),
  });
  const histogram = chart({
    title: "Dose of part and void",
    x: { label: "response to the dose" },
    y: { label: "share of the voxels per unit", log: true },
    series: runs.flatMap(outlines),
  });
  if (!iou && !histogram) return null;
  return h(
    "div.charts",
    {},
    iou && part("IoU over the gel threshold", h("p.note", {}, "A broad plateau tolerates errors of exposure."), iou),
    histogram && part("Dose of part and void", h("p.note", {}, "Share of the voxels per unit of the response: part in full lines, void in dotted ones."), histogram),
  );
}

/** Part and void of a run. */
function outlines(run: Run, i: number): Series[] {
  const own = report(run).evaluation?.histogram;
  return [
    { name: run.name, color: colorOf(i), style: "steps", ...density(own, "part") },
    { name: run.name, color: colorOf(i), style: "dotted", quiet: true, ...density(own, "void") },
  ];
}

/** A histogram as shares of its voxels per unit of the response. */
function density(histogram: Histogram | null | undefined, of: "part" | "void"): { x: Measure[]; y: Measure[] } {
  const counts = histogram?.[of] ?? [];
  const [low, high] = histogram?.range ?? [];
  const total = counts.reduce<number>((sum, count) => sum + (count ?? 0), 0);
  if (!isNumber(low) || !isNumber(high) || total === 0) return { x: [], y: [] };
  const width = (high - low) / counts.length;
  return { x: counts.map((_, bin) => low + (bin + 0.5) * width), y: counts.map((count) => (count ?? 0) / (total * width)) };
}
