// What people should know before they trust the numbers, which choices were made, and what gave the doses.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { list, report } from "./schema.ts";
import { bullets, part } from "./text.ts";

/** Warnings, with the notes of the evaluation. */
export function warnings({ run }: Context): HTMLElement | null {
  const data = report(run);
  const items = bullets([...list(data.warnings), ...list(data.evaluation?.notes)]);
  return items && h("div.warn", { role: "note" }, items);
}

export function notes({ data: page, run }: Context): HTMLElement {
  const data = report(run);
  const made = bullets(list(data.notes));
  const models = Object.entries(data.run?.models ?? {});
  const rows = models.map(([stage, model]) => h("div", {}, h("dt", {}, `Doses of the ${stage}`), h("dd", {}, String(model))));
  return h(
    "div",
    {},
    h("p.quiet", {}, `${data.run?.program ?? page.program}. Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.`),
    made && part("Choices", made),
    rows.length > 0 && part("Models", h("dl.models", {}, ...rows)),
  );
}
