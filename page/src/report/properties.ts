// Predicted properties of the printed material: their spread where something is solid.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { isNumber, toldApart } from "./number.ts";
import { list, report, type Property } from "./schema.ts";
import { dataTable } from "./table.ts";

export function properties({ run }: Context): HTMLElement | null {
  const own = list(report(run).properties);
  if (own.length === 0) return null;
  return h(
    "div",
    {},
    h("p.quiet", {}, "Where something is solid. Half of it lies below the median."),
    dataTable({ caption: "Predicted properties", heads: ["property", "lowest", "median", "highest", "unit"], rows: own.map(row), text: [4] }),
  );
}

function row({ name, unit, min, median, max }: Property): string[] {
  const values = [min, median, max];
  const texts = toldApart(values.filter(isNumber), 3);
  return [name ?? "", ...values.map((value) => (isNumber(value) ? (texts.shift() ?? "") : "–")), unit ?? ""];
}
