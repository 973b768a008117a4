// Which keys of the jobs differ.

import type { Comparison, Run } from "../../data.ts";
import { h } from "../../dom.ts";
import { NONE } from "../number.ts";
import { dataTable } from "../table.ts";
import { named } from "./color.ts";

export function jobs({ differing_keys: keys }: Comparison, runs: readonly Run[]): HTMLElement {
  if (keys.length === 0) return h("p.quiet", {}, "Nothing.");
  const rows = keys.map(({ key, values }) => [h("code", {}, key), ...values.map((value) => value ?? NONE)]);
  return h("div.job-keys", {}, dataTable({ caption: "Keys of the jobs that differ", heads: ["key", ...runs.map(named)], rows, text: runs.map((_, i) => i + 1) }));
}
