// What the same patterns print where something is otherwise than in the job.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { significant } from "./number.ts";
import { list, report } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs } from "./text.ts";

export function scenarios({ run }: Context): HTMLElement | null {
  const own = report(run).scenarios;
  if (!own) return null;
  const rows = list(own.rows).map((row) => [
    row.name ?? "",
    significant(row.iou_at_threshold, 4),
    significant(row.iou, 4),
    significant(row.gamma, 4),
    significant(row.part_low, 4),
    significant(row.void_high, 4),
  ]);
  const threshold = significant(own.threshold, 4);
  const of = own.of === "worst" ? "the worst of them" : own.of === "mean" ? "their mean" : own.of;
  return h(
    "div",
    {},
    ...paragraphs([
      `What the same patterns print where something is otherwise. Nobody knows which scenario a print is, so all of them gel at the threshold of the job, ${threshold}.`,
      run.texts?.scenarios,
    ]),
    dataTable({
      caption: "Scenarios",
      heads: ["scenario", "IoU there", "IoU at its own threshold", "Γ, %", "least of the part", "largest of the void"],
      rows,
      strong: 1,
    }),
    h("p.note", {}, `Window over all of them: ${significant(own.window, 4)}, trimmed.${of ? ` The optimization minimized ${of}.` : ""}`),
  );
}
