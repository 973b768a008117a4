// A run in a map or a plot: a button that says its values and how it ended.

import { h, type Child } from "../../dom.ts";
import type { Column, Model } from "./model.ts";

/** Where a mark stands among its neighbors: the arrow keys follow it. */
export interface Place {
  x: number;
  y: number;
}

export function mark(model: Model, row: number, metric: Column, place: Place, style: string, ...children: Child[]): HTMLButtonElement {
  const label = `Run ${row + 1}: ${model.point(row)}; ${metric.title} ${model.text(row, metric)}; ${model.state(row)}`;
  return h(
    "button",
    { type: "button", class: `mark ${model.state(row)}`, tabindex: -1, "aria-label": label, "data-row": row, "data-x": place.x, "data-y": place.y, style },
    ...children,
  );
}

/** The nearest mark in the direction of an arrow key; one in the same line, else one in the nearest line. */
export function neighbor(marks: readonly HTMLElement[], from: HTMLElement, key: string): HTMLElement | null {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
  if (!step) return null;
  const at = ({ dataset }: HTMLElement) => [Number(dataset.x), Number(dataset.y)];
  const [x0, y0] = at(from);
  let best: HTMLElement | null = null;
  let least = Infinity;
  for (const one of marks) {
    const [dx, dy] = [at(one)[0] - x0, at(one)[1] - y0];
    const along = dx * step[0] + dy * step[1];
    if (along <= 0) continue;
    const across = Math.abs(dx * step[1]) + Math.abs(dy * step[0]);
    const distance = along + 1e3 * across;
    if (distance < least) [best, least] = [one, distance];
  }
  return best;
}
