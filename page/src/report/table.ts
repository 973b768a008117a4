// Tables of numbers: the first column names, the others hold numbers, which stand right in figures of one width.

import { h, type Child } from "../dom.ts";

export interface TableOptions {
  heads: readonly Child[];
  /** Cells are text or elements. */
  rows: readonly (readonly Child[])[];
  caption?: string;
  /** The column to stress, as the one of the headline. */
  strong?: number;
  /** Columns of text, besides the first. */
  text?: readonly number[];
}

/** A table that scrolls within its own box where it is too wide. */
export function dataTable(options: TableOptions): HTMLElement {
  const { heads, rows, caption, strong, text = [] } = options;
  const classOf = (column: number) =>
    [column === 0 || text.includes(column) ? "text" : "number", column === strong ? "strong" : ""].join(" ").trim();
  const head = heads.map((cell, column) => h("th", { scope: "col", class: classOf(column) }, cell));
  const body = rows.map((row) =>
    h("tr", {}, ...row.map((cell, column) => (column === 0 ? h("th", { scope: "row" }, cell) : h("td", { class: classOf(column) }, cell)))),
  );
  const name = caption ? h("caption.unseen", {}, caption) : null;
  return h("div.scroll", {}, h("table.data", {}, name, h("thead", {}, h("tr", {}, ...head)), h("tbody", {}, ...body)));
}
