// A metric over one axis: dots, joined by a line where a sweep has one axis.

import { h, svg } from "../../dom.ts";
import { significant } from "../number.ts";
import { mark } from "./mark.ts";
import { type AxisColumn, type Column, heading, type Model, shareOf, textOf } from "./model.ts";

/** Where a value lies, 0…1, and the labels of an axis. */
interface Ruler {
  at(value: number): number;
  ticks: { at: number; text: string }[];
}

export function plot(model: Model, metric: Column, x: AxisColumn, rows: readonly number[], isJoined: boolean): HTMLElement {
  const across = x.isNumeric ? rulerOf(model, x) : namesOf(x);
  const up = rulerOf(model, metric);
  const placeOf = (row: number) => (across ? across.at(x.isNumeric ? (model.number(row, x) ?? 0) : x.levelOf[row]) : 0);
  const ordered = [...rows].sort((a, b) => placeOf(a) - placeOf(b));
  const drawn = ordered.map((row) => ({ row, x: placeOf(row), value: model.number(row, metric) }));
  // What has no number stands at the foot
  const marks = drawn.map(({ row, x, value }, i) =>
    mark(model, row, metric, { x: i, y: 0 }, `left: ${percent(x)}; bottom: ${percent(value === null ? 0 : up!.at(value))}`, h("i", {})),
  );
  const points = drawn.flatMap(({ x, value }) => (value === null ? [] : [`${(100 * x).toFixed(3)},${(100 - 100 * up!.at(value)).toFixed(3)}`]));
  const line = isJoined && svg("svg", { viewBox: "0 0 100 100", preserveAspectRatio: "none", "aria-hidden": "true" }, svg("polyline", { points: points.join(" ") }));
  return h(
    "div",
    {},
    h(
      "div.sweep-plot",
      {},
      ...(up?.ticks ?? []).map(({ at, text }) => h("span.y", { style: `bottom: ${percent(at)}` }, text)),
      ...(across?.ticks ?? []).map(({ at, text }) => h("span.x", { style: `left: ${percent(at)}` }, text)),
      line,
      ...marks,
    ),
    h("p.axis-name.right", {}, `${heading(x)} →`),
  );
}

function percent(share: number): string {
  return `${(100 * share).toFixed(3)}%`;
}

/** Null where no run has a number. */
function rulerOf(model: Model, column: Column): Ruler | null {
  const range = model.range(column);
  if (!range) return null;
  // Room at both ends, so that no mark lies on the frame
  const at = (value: number) => 0.04 + 0.92 * shareOf(range, value);
  const values = range.logarithmic ? powers(range.low, range.high) : steps(range.low, range.high);
  return { at, ticks: values.map((value) => ({ at: at(value), text: significant(value, 6) })) };
}

/** Names at equal distances; some are left out where there are many. */
function namesOf({ levels }: AxisColumn): Ruler {
  const at = (level: number) => (level + 0.5) / levels.length;
  const every = Math.ceil(levels.length / 8);
  const ticks = levels.flatMap((value, level) => (level % every === 0 ? [{ at: at(level), text: textOf(value) }] : []));
  return { at, ticks };
}

/** Round numbers within a range, about five. */
export function steps(low: number, high: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / 5;
  const size = 10 ** Math.floor(Math.log10(rough));
  const step = size * ([1, 2, 5].find((factor) => factor * size >= rough) ?? 10);
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Powers of ten within a range, at most six. */
function powers(low: number, high: number): number[] {
  const [first, last] = [Math.ceil(Math.log10(low)), Math.floor(Math.log10(high))];
  const every = Math.ceil((last - first + 1) / 6);
  return Array.from({ length: Math.floor((last - first) / every) + 1 }, (_, i) => 10 ** (first + i * every));
}
