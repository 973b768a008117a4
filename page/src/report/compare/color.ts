// One color per run, the same everywhere on the page; the seventh run has the first color again, with a dashed line.

import type { Run } from "../../data.ts";
import { h } from "../../dom.ts";
import { swatch, type Series } from "../chart.ts";

const COLORS = 6;

export function colorOf(run: number): string {
  return `--run-${(run % COLORS) + 1}`;
}

export function styleOf(run: number): "line" | "dashed" {
  return run < COLORS ? "line" : "dashed";
}

/** The line of a run. */
export function lineOf(run: Run, i: number, x: Series["x"], y: Series["y"]): Series {
  return { name: run.name, color: colorOf(i), style: styleOf(i), x, y };
}

/** The name of a run behind a sample of its line. */
export function named(run: Run, i: number): HTMLElement {
  return h("span.run-name", {}, swatch(colorOf(i), styleOf(i)), run.name);
}
