// The table of all runs: sorted by a click on a head, filtered, copied as CSV.

import { h } from "../../dom.ts";
import type { State } from "../../state.ts";
import { isNumber } from "../number.ts";
import { dataTable } from "../table.ts";
import { copyButton, csvLine } from "../text.ts";
import { filtered } from "./filter.ts";
import { type Column, heading, type Model, textOf } from "./model.ts";
import type { Actions } from "./panels.ts";

/** Rows that are drawn at first, and with each press of the button that asks for more. */
const MORE = 200;

export class Runs {
  readonly element: HTMLElement;
  private readonly place = h("div.sweep-runs");
  private readonly count = h("span.quiet", { role: "status" });
  private filter = "";
  private most = MORE;
  /** Null: in the order of the sweep. */
  private sorted: { column: Column; isDown: boolean } | null = null;

  constructor(
    private readonly model: Model,
    private readonly state: State,
    private readonly actions: Actions,
  ) {
    const axis = model.varying[0]?.name ?? "iou";
    const input = h("input", { type: "search", placeholder: `${axis} > 0.5, failed`, "aria-label": "Filter runs" });
    input.addEventListener("input", () => {
      this.filter = input.value;
      this.most = MORE;
      this.draw();
    });
    this.element = h(
      "div",
      {},
      h("div.controls", {}, h("label.filter", {}, "Filter", input), this.count, copyButton("Copy as CSV", () => this.csv())),
      h("p.note", {}, "A filter has conditions on columns and words, separated by commas. Numbers are in the units of report.json. A click on a head sorts."),
      this.place,
    );
    this.place.addEventListener("click", (event) => this.onClick(event));
    state.on(["marked", "opened"], () => this.press());
    this.draw();
  }

  private rows(): number[] {
    const rows = filtered(this.model, this.filter);
    if (!this.sorted) return rows;
    const { column, isDown } = this.sorted;
    const { model } = this;
    return rows.sort((a, b) => {
      const [first, second] = [model.value(a, column), model.value(b, column)];
      // What has no value comes last either way
      if (first === null || second === null) return Number(first === null) - Number(second === null) || a - b;
      const order = isNumber(first) && isNumber(second) ? first - second : textOf(first).localeCompare(textOf(second));
      return (isDown ? -order : order) || a - b;
    });
  }

  private draw(): void {
    const { model } = this;
    const rows = this.rows();
    this.count.textContent = rows.length === model.rows.length ? `${rows.length} runs` : `${rows.length} of ${model.rows.length} runs`;
    const heads = ["run", "", ...model.columns.map((column) => this.head(column)), "state"];
    const cells = (row: number) => [
      h("button", { type: "button", "data-row": row, title: "Open this run" }, String(row + 1)),
      h("input", { type: "checkbox", "data-row": row, "aria-label": `Mark run ${row + 1} for the comparison` }),
      ...model.columns.map((column) => model.text(row, column, column.at < model.axes.length ? 6 : 4)),
      h("span", {}, model.state(row), h("small", {}, model.rows[row].why)),
    ];
    const words = model.columns.flatMap((column, i) => (model.rows.some((_, row) => typeof model.value(row, column) === "string") ? [i + 2] : []));
    const more = () => {
      this.most += MORE;
      this.draw();
    };
    this.place.replaceChildren(
      dataTable({ caption: "Runs of the sweep", heads, rows: rows.slice(0, this.most).map(cells), text: [1, ...words, model.columns.length + 2] }),
      ...(rows.length > this.most ? [h("button", { type: "button", click: more }, `Show ${Math.min(MORE, rows.length - this.most)} more of ${rows.length}`)] : []),
    );
    this.place.querySelectorAll("thead th").forEach((head, i) => {
      const column = model.columns[i - 2];
      if (column && column === this.sorted?.column) head.setAttribute("aria-sort", this.sorted.isDown ? "descending" : "ascending");
    });
    this.press();
  }

  private head(column: Column): HTMLElement {
    const arrow = this.sorted?.column === column ? (this.sorted.isDown ? " ↓" : " ↑") : "";
    const click = () => {
      this.sort(column);
      this.place.querySelector<HTMLElement>(`[data-column="${column.at}"]`)?.focus();
    };
    return h("button.sort", { type: "button", "data-column": column.at, title: column.summary || null, click }, heading(column) + arrow);
  }

  /** The better end first, then the other, then as the sweep has them. */
  private sort(column: Column): void {
    const first = column.better === "higher";
    if (this.sorted?.column !== column) this.sorted = { column, isDown: first };
    else this.sorted = this.sorted.isDown === first ? { column, isDown: !first } : null;
    this.draw();
  }

  private onClick(event: Event): void {
    const target = event.target as Element;
    const own = target.closest<HTMLElement>("[data-row]") ?? target.closest("tbody tr")?.querySelector<HTMLElement>("[data-row]");
    if (!own) return;
    const row = Number(own.dataset.row);
    if (own instanceof HTMLInputElement) this.actions.toggle(row);
    else this.actions.open(row);
  }

  /** Shows which runs are open and marked. */
  private press(): void {
    const marked = new Set(this.state.get("marked"));
    for (const box of this.place.querySelectorAll<HTMLInputElement>("input[data-row]")) {
      const run = Number(box.dataset.row) + 1;
      box.checked = marked.has(run);
      const line = box.closest("tr")!;
      if (run === this.state.get("opened")) line.setAttribute("aria-current", "true");
      else line.removeAttribute("aria-current");
    }
  }

  /** Every digit of the rows that the filter leaves, as they are sorted. */
  private csv(): string {
    const { model } = this;
    const cell = (row: number, column: Column) => {
      const value = model.value(row, column);
      return value === null || isNumber(value) ? value : textOf(value);
    };
    const line = (row: number) => csvLine([row + 1, ...model.columns.map((column) => cell(row, column)), model.rows[row].state, model.rows[row].feasible?.toString(), model.rows[row].why]);
    return [csvLine(["run", ...model.columns.map(({ name }) => name), "state", "feasible", "error"]), ...this.rows().map(line)].join("\n") + "\n";
  }
}
