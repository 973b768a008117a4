// Runs that the reader has marked, next to each other.

import { h } from "../../dom.ts";
import { isNumber } from "../number.ts";
import { title } from "../numbers.ts";
import { dataTable } from "../table.ts";
import { copyButton, csvLine } from "../text.ts";
import { type Column, type Model, textOf } from "./model.ts";
import type { Actions } from "./panels.ts";

export function marked(model: Model, rows: readonly number[], actions: Actions): HTMLElement {
  const heads = rows.map((row) =>
    h(
      "span.marked-run",
      {},
      h("button", { type: "button", click: () => actions.open(row) }, `Run ${row + 1}`),
      h("button", { type: "button", "aria-label": `Leave run ${row + 1} out`, title: "Leave it out", click: () => actions.toggle(row) }, "×"),
      h("small", {}, model.state(row)),
    ),
  );
  const cells = (column: Column) => {
    const best = bestOf(rows.map((row) => model.number(row, column)), column.better);
    const value = (row: number) => (best !== null && model.value(row, column) === best ? h("b.best", {}, model.text(row, column)) : model.text(row, column));
    return [title(column), ...rows.map(value)];
  };
  const csv = () => [csvLine(["", ...rows.map((row) => `run ${row + 1}`)]), ...model.columns.map((column) => csvLine([column.name, ...rows.map((row) => exact(model.value(row, column)))]))].join("\n") + "\n";
  return h(
    "div",
    {},
    h("p.quiet", {}, "↑ larger is better, ↓ smaller is better; the best of these runs is bold."),
    copyButton("Copy as CSV", csv),
    dataTable({ caption: "Marked runs side by side", heads: ["", ...heads], rows: model.columns.map(cells) }),
  );
}

function exact(value: unknown): number | string {
  return isNumber(value) ? value : value === null ? "" : textOf(value);
}

/** Null where the values are the same, or none is better than another. */
function bestOf(values: readonly (number | null)[], better: Column["better"]): number | null {
  const known = values.filter(isNumber);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  if (better === "none" || !(high > low)) return null;
  return better === "higher" ? high : low;
}
