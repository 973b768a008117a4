// Where the wall time of the run went: stages as bars, and under them what they consist of.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { isNumber, significant } from "./number.ts";
import { report } from "./schema.ts";

export function timings({ run }: Context): HTMLElement | null {
  const all = Object.entries(report(run).run?.timings_s ?? {}).filter((entry): entry is [string, number] => isNumber(entry[1]));
  const longest = Math.max(0, ...all.map(([, seconds]) => seconds));
  if (longest === 0) return null;
  // "whole: part" is a part of another entry
  const wholes = all.filter(([name]) => !name.includes(": "));
  const parts = (whole: string) => all.filter(([name]) => name.startsWith(`${whole}: `));
  const strays = all.filter(([name]) => name.includes(": ") && !wholes.some(([whole]) => name.startsWith(`${whole}: `)));
  const bySize = (a: [string, number], b: [string, number]) => b[1] - a[1];
  const total = wholes.reduce((sum, [, seconds]) => sum + seconds, 0);
  const bar = (name: string, seconds: number, isPart: boolean) =>
    h(
      isPart ? "div.row.sub" : "div.row",
      {},
      h("span", {}, name),
      h("div.share", { "aria-hidden": "true" }, h("i", { style: `width: ${((100 * seconds) / longest).toFixed(1)}%` })),
      h("span.value", {}, `${significant(seconds, 3)} s`),
    );
  const rows = [...wholes, ...strays].sort(bySize).flatMap(([name, seconds]) => [
    bar(name, seconds, false),
    ...parts(name)
      .sort(bySize)
      .map(([own, took]) => bar(own.slice(name.length + 2), took, true)),
  ]);
  return h("div", {}, h("p.quiet", {}, `${significant(total, 3)} s until this page was written.`), h("div.timings", {}, ...rows));
}
