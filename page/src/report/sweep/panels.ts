// Maps and plots of the chosen metrics, what they are drawn over, and how a reader moves through them.

import { h, type Child } from "../../dom.ts";
import { choice } from "../../controls.ts";
import type { Key, State, View } from "../../state.ts";
import { scrollTo } from "../nav.ts";
import { part } from "../text.ts";
import { Cells } from "./cells.ts";
import { map } from "./map.ts";
import { neighbor } from "./mark.ts";
import { type AxisColumn, type Column, heading, type Model, textOf } from "./model.ts";
import { plot } from "./plot.ts";

/** What the reader does with the run of a mark or a row. */
export interface Actions {
  open(row: number): void;
  /** Marks the run for the comparison, or takes the mark away. */
  toggle(row: number): void;
}

const DRAWN: Key[] = ["metric", "x", "y", "plot", "levels"];

/** Marks that a legend explains, by their class. */
const MEANINGS: [string, string][] = [
  ["best", "best run"],
  ["infeasible", "does not meet best.where"],
  ["failed", "failed"],
  ["missing", "not made yet"],
];

export class Panels {
  readonly element: HTMLElement;
  private readonly controls = h("div.controls");
  private readonly plots = h("div.sweep-panels");
  private readonly tip = h("div.chart-tip", { hidden: true });
  private readonly compare = h("button", { type: "button", hidden: true, click: () => scrollTo("marked") });

  constructor(
    private readonly model: Model,
    private readonly state: State,
    private readonly actions: Actions,
  ) {
    const states = new Set(model.rows.map((_, row) => model.state(row)));
    const keys = MEANINGS.filter(([state]) => states.has(state)).map(([state, text]) => h("span", {}, h("span", { class: `mark ${state}` }, h("i", {})), text));
    this.element = h(
      "div",
      {},
      h("p.quiet", {}, "A click or Enter opens a run below; Shift-click or Space marks it for the comparison; arrow keys move from run to run. Several metrics can be shown at once."),
      this.controls,
      this.plots,
      h("p.color-keys.sweep-keys", {}, ...keys, this.compare),
    );
    this.listen();
    state.on(DRAWN, () => this.draw());
    state.on(["opened", "marked"], () => this.press());
    this.draw();
  }

  /** Gives the focus to the run. */
  focus(row: number): void {
    this.marks(row).find(({ dataset }) => Number(dataset.row) === row)?.focus();
  }

  private get shown(): Column[] {
    const names = this.state.get("metric").split(",");
    const found = this.model.metrics.filter(({ name }) => names.includes(name));
    return found.length > 0 ? found : this.model.metrics.slice(0, 1);
  }

  private get isMap(): boolean {
    const chosen = this.state.get("plot");
    return this.model.varying.length > 1 && (chosen === "" ? this.model.isCrossed : chosen === "map");
  }

  /** Across, then up: two different axes where there are two. */
  private get axes(): [AxisColumn, AxisColumn] {
    const { varying } = this.model;
    const named = (key: "x" | "y") => varying.find(({ name }) => name === this.state.get(key));
    const x = named("x") ?? varying.find((axis) => axis !== named("y")) ?? varying[0];
    const y = named("y");
    return [x, y && y !== x ? y : (varying.find((axis) => axis !== x) ?? x)];
  }

  /** The level at which a map holds an axis that it does not show. */
  private level(axis: AxisColumn): number {
    const best = this.model.sweep.best;
    const chosen = this.state.get("levels").split(",")[axis.at] ?? "";
    const level = chosen === "" ? (best === null ? 0 : axis.levelOf[best]) : Number(chosen);
    return axis.levels[level] === undefined ? 0 : level;
  }

  private draw(): void {
    const { model, isMap } = this;
    const focused = this.marks().indexOf(document.activeElement as HTMLElement) >= 0 ? (document.activeElement as HTMLElement).dataset.row : undefined;
    this.element.classList.toggle("as-dots", !isMap);
    const [x, y] = model.varying.length > 0 ? this.axes : [];
    this.drawControls(x, y);
    if (!x || !y) {
      this.plots.replaceChildren(h("p.quiet", {}, "No axis of this sweep has more than one value: there is nothing to draw over."));
      return;
    }
    const held = model.varying.filter((axis) => axis !== x && axis !== y);
    const all = model.rows.map((_, row) => row);
    const rows = isMap ? all.filter((row) => held.every((axis) => axis.levelOf[row] === this.level(axis))) : all;
    const drawn = (metric: Column) => (isMap ? map(model, metric, x, y, rows) : plot(model, metric, x, rows, model.varying.length === 1));
    this.plots.replaceChildren(...this.shown.map((metric) => named(part(heading(metric), drawn(metric)), `${metric.title} over ${isMap ? `${x.name} and ${y.name}` : x.name}`)), this.tip);
    this.press();
    for (const panel of this.plots.querySelectorAll(".part")) (panel.querySelector<HTMLElement>(".opened, .mark.best") ?? panel.querySelector<HTMLElement>(".mark"))?.setAttribute("tabindex", "0");
    if (focused !== undefined) this.focus(Number(focused));
  }

  private drawControls(x: AxisColumn | undefined, y: AxisColumn | undefined): void {
    const { model, state, isMap } = this;
    const had = document.activeElement?.closest(".controls") === this.controls ? document.activeElement.getAttribute("data-control") : null;
    const toggles = model.metrics.map((metric) => {
      const isShown = this.shown.includes(metric);
      const click = () => {
        const names = model.metrics.filter((one) => this.shown.includes(one) !== (one === metric)).map(({ name }) => name);
        if (names.length > 0) state.set({ metric: names.join(",") });
      };
      return h("button", { type: "button", "aria-pressed": String(isShown), title: metric.summary || null, "data-control": metric.name, click }, metric.title);
    });
    const select = (label: string, options: string[], chosen: number, change: (i: number) => void): Child =>
      h("label", {}, label, h("select", { "data-control": label, change: (event: Event) => change((event.target as HTMLSelectElement).selectedIndex) }, ...options.map((text, i) => h("option", { selected: i === chosen }, text))));
    const axis = (label: string, key: "x" | "y", chosen: AxisColumn): Child => {
      const names = model.varying.map(({ name }) => name);
      const change = (i: number) => {
        const view: Partial<View> = { [key]: names[i] };
        // The other axis takes the place of this one
        if (isMap && names[i] === (key === "x" ? y : x)?.name) view[key === "x" ? "y" : "x"] = chosen.name;
        state.set(view);
      };
      return select(label, names, names.indexOf(chosen.name), change);
    };
    const several = x && y && model.varying.length > 1;
    const forms: [string, string][] = [["map", "Map"], ["axis", "Over one axis"]];
    const held = several && isMap ? model.varying.filter((one) => one !== x && one !== y) : [];
    this.controls.replaceChildren(
      ...[
        model.metrics.length > 1 && h("div.choice", { role: "group", "aria-label": "Metrics that are drawn" }, ...toggles),
        several && choice("Drawn as", forms, () => (isMap ? "map" : "axis"), (plot) => state.set({ plot }), () => {}),
        several && axis(isMap ? "across" : "over", "x", x),
        several && isMap && axis("up", "y", y),
        ...held.map((one) => select(heading(one), one.levels.map((value) => textOf(value)), this.level(one), (level) => this.hold(one, level))),
      ].filter((control): control is HTMLElement => Boolean(control)),
    );
    if (had !== null) this.controls.querySelector<HTMLElement>(`[data-control="${CSS.escape(had)}"]`)?.focus();
  }

  private hold(axis: AxisColumn, level: number): void {
    const levels = this.model.axes.map((one) => (one === axis ? level : this.level(one)));
    this.state.set({ levels: levels.join(",") });
  }

  /** The marks that are there; those of some rows are there in any case. */
  private marks(...rows: number[]): HTMLElement[] {
    for (const panel of this.plots.querySelectorAll(".part")) for (const row of rows) Cells.around(panel)?.mark(row);
    return [...this.plots.querySelectorAll<HTMLElement>(".mark")];
  }

  /** Shows which runs are open and marked. */
  private press(): void {
    const opened = this.state.get("opened");
    const marked = new Set(this.state.get("marked"));
    this.compare.hidden = marked.size < 2;
    this.compare.textContent = `Compare ${marked.size} marked runs`;
    const rows = [...marked, ...(opened === null ? [] : [opened])].map((run) => run - 1);
    for (const one of this.marks(...rows)) {
      const run = Number(one.dataset.row) + 1;
      one.classList.toggle("opened", run === opened);
      one.classList.toggle("marked", marked.has(run));
      one.setAttribute("aria-pressed", String(marked.has(run)));
    }
  }

  private listen(): void {
    const markOf = ({ target }: Event) => (target as Element).closest<HTMLElement>(".mark[data-row]");
    const point = (event: Event) => this.showTip(markOf(event));
    this.plots.addEventListener("pointerover", point);
    this.plots.addEventListener("focusin", (event) => {
      const one = markOf(event);
      this.showTip(one);
      if (one) for (const other of one.closest(".part")!.querySelectorAll(".mark")) other.setAttribute("tabindex", other === one ? "0" : "-1");
    });
    for (const kind of ["pointerleave", "focusout"]) this.plots.addEventListener(kind, () => this.showTip(null));
    this.plots.addEventListener("click", (event) => {
      const one = markOf(event);
      if (one) this.actions[event.shiftKey ? "toggle" : "open"](Number(one.dataset.row));
    });
    this.plots.addEventListener("keydown", (event) => this.onKey(event, markOf(event)));
    this.plots.addEventListener("keyup", (event) => event.key === " " && markOf(event) && event.preventDefault());
  }

  private onKey(event: KeyboardEvent, one: HTMLElement | null): void {
    if (!one || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") this.showTip(null);
    else if (event.key === " ") {
      event.preventDefault();
      this.actions.toggle(Number(one.dataset.row));
    } else if (event.key.startsWith("Arrow")) {
      event.preventDefault();
      const cells = Cells.around(one);
      const next = cells ? cells.neighbor(Number(one.dataset.row), event.key) : neighbor([...one.closest(".part")!.querySelectorAll<HTMLElement>(".mark")], one, event.key);
      next?.focus();
    }
  }

  /** The values of a run, next to its mark. */
  private showTip(one: HTMLElement | null): void {
    this.tip.hidden = one === null;
    if (!one) return;
    const { model } = this;
    const row = Number(one.dataset.row);
    const line = (column: Column) => h("div", {}, h("span", {}, heading(column)), h("b", {}, model.text(row, column, 5)));
    const { why } = model.rows[row];
    this.tip.replaceChildren(h("div.chart-tip-head", {}, `Run ${row + 1}, ${model.state(row)}`), ...model.columns.map(line), ...(why ? [h("p", {}, why)] : []));
    const [around, at] = [this.plots.getBoundingClientRect(), one.getBoundingClientRect()];
    const isRight = at.left - around.left > around.width / 2;
    this.tip.style.top = `${at.bottom - around.top + 8}px`;
    this.tip.style.left = isRight ? "" : `${at.left - around.left}px`;
    this.tip.style.right = isRight ? `${around.right - at.right}px` : "";
  }
}

function named(element: HTMLElement, label: string): HTMLElement {
  element.setAttribute("role", "group");
  element.setAttribute("aria-label", label);
  return element;
}
