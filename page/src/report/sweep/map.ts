// A heat map of a metric over two axes: a cell a run.

import { h } from "../../dom.ts";
import { legendOf } from "../../controls.ts";
import { channels, css } from "../../paint.ts";
import { NONE, significant } from "../number.ts";
import { type Cell, Cells } from "./cells.ts";
import { mark } from "./mark.ts";
import { type AxisColumn, type Column, heading, type Model, shareOf, textOf } from "./model.ts";

/** Width of a character of the labels, px. */
const CHARACTER = 7;

/** Height of a label, px. */
const LINE = 14;

/** Cells wider than this say no more, px. */
const WIDEST = 76;

/** Height of a cell, and of the whole map where cells can be lower, px. */
const CELL = { least: 6, most: 34, all: 720 };

/** More marks than these make a page slow. */
const MOST_MARKS = 2000;

/** In more columns no value fits. */
const COLUMNS_WITH_VALUES = 40;

/** The map of the rows that are at the chosen levels of the other axes. */
export function map(model: Model, metric: Column, x: AxisColumn, y: AxisColumn, rows: readonly number[]): HTMLElement {
  const [nx, ny] = [x.levels.length, y.levels.length];
  const scale = model.scale(metric);
  const hasText = nx <= COLUMNS_WITH_VALUES;
  const cells = rows.map((row): Cell => {
    const value = model.number(row, metric);
    return { row, column: x.levelOf[row], level: y.levelOf[row], color: value === null || !scale ? null : scale.map(shareOf(scale, value)), state: model.state(row) };
  });
  const markOf = ({ row, column, level, color }: Cell) => {
    const style = `grid-area: ${ny - level} / ${column + 2}`;
    const isDone = model.rows[row].state === "done";
    if (color === null) return mark(model, row, metric, { x: column, y: level }, style, isDone && hasText && h("span", {}, NONE));
    return mark(model, row, metric, { x: column, y: level }, `${style}; background-color: ${css(color)}; color: ${isBright(color) ? "#000" : "#fff"}`, hasText && h("span", {}, significant(model.number(row, metric), 3)));
  };
  const labelsX = x.levels.map((value, i) => h("span.x", { style: `grid-area: ${ny + 1} / ${i + 2}` }, h("span", {}, textOf(value, 4))));
  const labelsY = y.levels.map((value, i) => h("span.y", { style: `grid-area: ${ny - i} / 1` }, textOf(value, 4)));
  const height = Math.min(Math.max(CELL.all / ny, CELL.least), CELL.most);
  const grid = h("div.sweep-map", { style: `--columns: ${nx}; --cell: ${height}px; gap: ${height > 16 ? 2 : 1}px; max-width: ${nx * WIDEST + 90}px` }, ...labelsY, ...labelsX);
  if (cells.length > MOST_MARKS) {
    grid.style.gridTemplateRows = `repeat(${ny}, ${height}px)`;
    grid.append(new Cells(grid, cells, nx, ny, markOf).canvas);
    // The one with which the keyboard begins
    const first = cells.find(({ state }) => state === "best") ?? cells[0];
    grid.append(markOf(first));
  } else grid.append(...cells.map(markOf));
  thin(grid, labelsX);
  const every = Math.ceil(LINE / height);
  labelsY.forEach((label, i) => (label.style.visibility = i % every === 0 ? "" : "hidden"));
  return h(
    "div",
    {},
    h("p.axis-name", {}, `↑ ${heading(y)}`),
    grid,
    h("p.axis-name.right", { style: `max-width: ${nx * WIDEST + 90}px` }, `${heading(x)} →`),
    scale && legendOf({ scale, label: heading(metric), mark: null }),
  );
}

function isBright(color: number): boolean {
  const [red, green, blue] = channels(color);
  return 0.3 * red + 0.59 * green + 0.11 * blue > 0.5;
}

/** Leaves labels out where they would overlap. */
function thin(grid: HTMLElement, labels: readonly HTMLElement[]): void {
  const widest = Math.max(...labels.map(({ textContent }) => textContent?.length ?? 0));
  new ResizeObserver(() => {
    const step = Math.ceil((widest * CHARACTER + 6) / Math.max(labels[0]?.clientWidth ?? 0, 1));
    labels.forEach((label, i) => (label.style.visibility = i % step === 0 ? "" : "hidden"));
  }).observe(grid);
}
