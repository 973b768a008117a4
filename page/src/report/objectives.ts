// What each of several objectives comes to.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { significant } from "./number.ts";
import { list, report } from "./schema.ts";
import { dataTable } from "./table.ts";

export function objectives({ run }: Context): HTMLElement | null {
  const own = list(report(run).optimization?.objectives);
  if (own.length < 2) return null;
  const rows = own.map((one) => [
    h("code", {}, one.key ?? ""),
    significant(one.weight, 4),
    significant(one.loss, 4),
    significant(one.voxels, 6),
    significant(one.rms_error, 4),
    significant(one.max_error, 4),
  ]);
  return h(
    "div",
    {},
    h("p", {}, "What each of them comes to on the job's own voxels, before the patterns are written. The sum takes a loss times its factor."),
    dataTable({ caption: "Objectives", heads: ["objective", "factor", "loss", "voxels", "rms error", "largest error"], rows }),
  );
}
