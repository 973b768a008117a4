// The head of a comparison: which runs, of which parts, and which of them the rest of the page shows.

import type { PageData } from "../../data.ts";
import { h } from "../../dom.ts";
import type { State } from "../../state.ts";
import { report } from "../schema.ts";
import { named } from "./color.ts";

export function head(data: PageData, shown: number, state: State): HTMLElement {
  const parts = [...new Set(data.runs.map((run) => report(run).part).filter((part) => part !== undefined))];
  const toys = data.runs.filter((run) => report(run).is_toy === true).map((run) => run.name);
  const several = data.runs.filter((run) => (report(run).species ?? []).length > 1).map((run) => `${run.name} (${report(run).species?.[0]?.name ?? ""})`);
  const buttons = data.runs.map((run, i) => {
    const button = h("button", { type: "button", "aria-pressed": String(i === shown) }, named(run, i));
    button.addEventListener("click", () => state.set({ run: i }));
    return button;
  });
  return h(
    "div.head",
    {},
    h("p.brand", {}, "Tomolith comparison"),
    h("h1", {}, `${data.runs.length} runs`),
    h("p.lead", {}, `${parts.length === 1 ? "Part" : "Parts"}: ${parts.join(", ")}`),
    toys.length > 0 && h("p.quiet", {}, `${toys.join(", ")}: ${toys.length === 1 ? "a toy of its job, whose" : "toys of their jobs, whose"} pixels are three times as large.`),
    several.length > 0 && h("p.quiet", {}, `Of several species the numbers are those of the first: ${several.join(", ")}.`),
    h("div.chosen", {}, h("span.quiet", {}, "Shown in full below the comparison"), h("div.choice", { role: "group", "aria-label": "Run that is shown in full" }, ...buttons)),
  );
}
