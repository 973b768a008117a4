// A sweep: maps and plots of its metrics, the table of its runs, marked runs side by side, and the run that is open.

import type { PageData, SweepData } from "../../data.ts";
import { h, type Child } from "../../dom.ts";
import type { State } from "../../state.ts";
import { type Entry, scrollTo } from "../nav.ts";
import { copyButton } from "../text.ts";
import { marked } from "./marked.ts";
import { Model } from "./model.ts";
import { type Actions, Panels } from "./panels.ts";
import { Runs } from "./runs.ts";

export class Sweep {
  /** They stay as they are when another run is opened. */
  readonly sections: HTMLElement[];
  private readonly model: Model;
  private readonly panels: Panels;
  private readonly side: HTMLElement;
  private readonly bar = h("section", { id: "opened", "aria-label": "Open run", hidden: true });

  /** `load` shows the run of a row below, or none; it throws why it cannot. */
  constructor(
    data: PageData,
    sweep: SweepData,
    private readonly state: State,
    private readonly load: (row: number | null) => Promise<void>,
  ) {
    this.model = new Model(sweep, data.metrics);
    const actions: Actions = { open: (row) => this.choose(row), toggle: (row) => this.toggle(row) };
    this.panels = new Panels(this.model, state, actions);
    const runs = new Runs(this.model, state, actions);
    this.side = h("section", { id: "marked", "aria-label": "Marked runs side by side" });
    const compare = () => {
      const rows = state.get("marked").map((run) => run - 1).filter((row) => row < this.model.rows.length);
      this.side.hidden = rows.length < 2;
      this.side.replaceChildren(h("h2", {}, "Marked runs side by side"), marked(this.model, rows, actions));
    };
    const file = sweep.toml !== "" && h("details.fold", {}, h("summary", {}, "The sweep file"), copyButton("Copy the sweep file", () => sweep.toml), h("pre.job", { tabindex: "0" }, sweep.toml));
    this.sections = [
      section("sweep-head", "", this.head()),
      section("sweep", "Over the axes", this.panels.element),
      section("runs", "Runs", runs.element, file),
      this.side,
      this.bar,
    ];
    compare();
    state.on(["marked"], compare);
    state.on(["opened"], () => void this.show(true));
    void this.show(false);
  }

  /** What the list of sections names. */
  get entries(): Entry[] {
    const all = [{ id: "sweep", title: "Over the axes" }, { id: "runs", title: "Runs" }];
    return this.bar.hidden ? all : [...all, { id: "opened", title: "Open run" }];
  }

  private head(): HTMLElement {
    const { model } = this;
    const { name, best } = model.sweep;
    const count = (state: string) => model.rows.filter((row) => row.state === state).length;
    const ended = [[count("failed"), "failed"], [count("missing"), "not made yet"]].filter(([n]) => n !== 0).map(([n, what]) => `, ${n} ${what}`).join("");
    const over = model.varying.map((axis) => `${axis.name} (${axis.levels.length})`).join(", ");
    const words = best === null ? "No run meets best.where." : `The best is run ${best + 1}: ${model.point(best)}.`;
    return h(
      "div.head",
      {},
      h("p.brand", {}, "Tomolith sweep"),
      h("h1", {}, name),
      h("p.lead", {}, `${model.rows.length} runs${over === "" ? "" : ` over ${over}`}: ${count("done")} done${ended}. ${words}`),
      best !== null && h("p", {}, h("button", { type: "button", click: () => this.choose(best) }, "Open the best run")),
    );
  }

  private choose(row: number): void {
    if (this.state.get("opened") === row + 1) void this.show(true);
    else this.state.set({ opened: row + 1 });
  }

  private toggle(row: number): void {
    const runs = this.state.get("marked");
    const run = row + 1;
    this.state.set({ marked: runs.includes(run) ? runs.filter((one) => one !== run) : [...runs, run].sort((a, b) => a - b) });
  }

  /** Opens the run that the address names. */
  private async show(isChosen: boolean): Promise<void> {
    const opened = this.state.get("opened");
    const row = opened === null ? null : opened - 1;
    const refusal = row === null ? null : this.refusal(row);
    this.bar.hidden = row === null;
    this.bar.setAttribute("aria-busy", String(row !== null));
    this.bar.replaceChildren(...(row === null ? [] : [this.barHead(row), h("p.quiet", { role: "status" }, "Opening…")]));
    const end = await this.load(refusal === null ? row : null).then(
      () => refusal,
      (error: unknown) => (error instanceof Error ? error.message : String(error)),
    );
    if (this.state.get("opened") !== opened) return;
    this.bar.lastElementChild?.replaceWith(end === null ? "" : h("p.problem", { role: "alert" }, end));
    this.bar.removeAttribute("aria-busy");
    if (isChosen && row !== null) scrollTo("opened");
  }

  /** Why a run cannot be opened. */
  private refusal(row: number): string | null {
    const known = this.model.rows[row];
    if (!known) return `The sweep has ${this.model.rows.length} runs.`;
    if (known.state === "done") return null;
    if (known.state === "missing") return "This run has not been made yet. The command that made the sweep continues it.";
    return `This run failed: ${known.why ?? "the sweep does not say why"}`;
  }

  private barHead(row: number): HTMLElement {
    const back = () => {
      this.state.set({ opened: null });
      document.getElementById("sweep")?.scrollIntoView();
      this.panels.focus(row);
    };
    const point = this.model.rows[row] ? this.model.point(row) : "";
    return h("div.opened-head", {}, h("h2", {}, `Run ${row + 1}`), h("p", {}, point), h("button", { type: "button", click: back }, "Back to the sweep"));
  }
}

function section(id: string, title: string, ...children: Child[]): HTMLElement {
  return h("section", { id, "aria-label": title || "Sweep" }, title !== "" && h("h2", {}, title), ...children);
}
