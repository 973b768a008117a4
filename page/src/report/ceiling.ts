// Quality against time: what each ceiling of the pixels that was tried prints, and which one the run took.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Axis } from "./chart.ts";
import { isNumber, quantity, significant, type Measure } from "./number.ts";
import { list, report, type TradeOff } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs, part } from "./text.ts";

/** Points that make a curve. */
const FEWEST = 3;

/** A difference that no one would see in a print does not fill the chart. */
const LEAST_RANGE = 0.02;

export function ceiling({ run }: Context): HTMLElement | null {
  const rows = list(report(run).ceiling?.trade_off);
  if (rows.length === 0 && !run.texts?.ceiling) return null;
  const inSeconds = rows.length > 0 && rows.every((row) => isNumber(row.time_s));
  const x: Axis = inSeconds ? { label: "print time", unit: "s", from: 0 } : { label: "print time N·M/t", unit: "mm", from: 0 };
  const time = (row: TradeOff) => (inSeconds ? row.time_s : row.print_time_mm);
  const plots = [
    plot("IoU", rows, x, time, (row) => row.iou),
    plot("VER", rows, x, time, (row) => row.ver),
  ].filter((plot) => plot !== null);
  const intro =
    "The ceilings of the pixels that the run tried, on pixels of twice the width. `tomolith expose RUN --trade-off` lists them and writes the job of one.";
  return h("div", {}, ...paragraphs([run.texts?.ceiling, rows.length > 0 ? intro : null]), h("div.charts", {}, ...plots), table(rows));
}

function plot(name: string, rows: readonly TradeOff[], x: Axis, time: (row: TradeOff) => Measure, of: (row: TradeOff) => Measure): HTMLElement | null {
  const tried = rows.filter((row) => !row.is_evaluated);
  const chosen = rows.filter((row) => row.is_chosen);
  if (tried.filter((row) => isNumber(time(row)) && isNumber(of(row))).length < FEWEST) return null;
  const values = rows.map(of).filter(isNumber);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const half = 0.6 * Math.max(high - low, LEAST_RANGE);
  const y: Axis = { label: name, from: Math.max((low + high) / 2 - half, 0), to: Math.min((low + high) / 2 + half, 1) };
  const line = (some: readonly TradeOff[]) => ({ x: some.map(time), y: some.map(of) });
  const longest = Math.max(...rows.map(time).filter(isNumber));
  const taken = chosen.some((row) => row.is_evaluated) ? "this run, as it was evaluated" : "this run";
  const drawn = chart({
    title: `${name} over the print time`,
    x: { ...x, to: 1.05 * longest },
    y,
    series: [
      { name: "tried", color: "--accent", ...line(tried) },
      { name: taken, color: "--threshold", style: "dots", ...line(chosen) },
    ],
  });
  return drawn && part(name, drawn);
}

function table(rows: readonly TradeOff[]): HTMLElement | null {
  if (rows.length === 0) return null;
  const hasSeconds = rows.some((row) => isNumber(row.time_s));
  const cells = (row: TradeOff) => [
    [significant(row.brightest, 3), row.is_chosen && " (taken)"].filter(Boolean).join(""),
    quantity(row.print_time_mm, "", 3),
    ...(hasSeconds ? [quantity(row.time_s, "", 3)] : []),
    quantity(row.iou, "", 4),
    quantity(row.ver, "", 3),
    quantity(isNumber(row.surface_mean_mm) ? 1e3 * row.surface_mean_mm : null, "", 3),
  ];
  const heads = ["Brightest pixel", "N·M/t, mm", ...(hasSeconds ? ["time, s"] : []), "IoU", "VER", "surface off on average, µm"];
  return dataTable({ caption: "Quality against time", heads, rows: rows.map(cells) });
}
