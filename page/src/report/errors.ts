// A gray target has no threshold: how far the response is off, in part and void, as a histogram.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Mark } from "./chart.ts";
import { isNumber, significant, type Measure } from "./number.ts";
import { report, type ErrorHistogram } from "./schema.ts";
import { part } from "./text.ts";
import { tones } from "./tones.ts";

/** Bins that are drawn, about. */
const BINS = 80;

export function errors(context: Context): HTMLElement | null {
  const evaluation = report(context.run).evaluation;
  const own = evaluation?.errors;
  const [low, high] = own?.range ?? [];
  if (!evaluation || !own || !isNumber(low) || !isNumber(high)) return null;
  const largest = Math.max(...["max_error_part", "max_error_void"].map((name) => evaluation[name]).filter(isNumber), 0);
  const [from, to] = own.band ?? [];
  const count = own.part?.length ?? 0;
  if (count === 0) return null;
  const width = (high - low) / count;
  // Not narrower than a few bins
  const reach = Math.min(Math.max(largest, 2 * (to ?? 0), 8 * width), high);
  const bright = joined(own, "part", width, reach);
  const dark = joined(own, "void", width, reach);
  const band: Mark[] = isNumber(from) && isNumber(to) ? [{ name: "the objective's band", color: "--quiet", from, to }] : [];
  const drawn = chart({
    title: "Error of bright and dark voxels",
    x: { label: "response − gray value", from: -reach, to: reach },
    y: { label: "voxels", log: true },
    series: [
      { name: "dark (below ½)", color: "--void", style: "steps", ...dark },
      { name: "bright", color: "--part", style: "steps", ...bright },
    ],
    marks: band,
  });
  if (!drawn) return null;
  const peak = isNumber(own.band_edge_peak)
    ? ` Bins at its edges hold ${significant(own.band_edge_peak, 3)} times as many voxels as those next to them.`
    : "";
  const curve = tones(context);
  return h(
    "div.charts",
    {},
    part("Voxels per error", h("p.note", {}, `The band is what the objective asks for.${peak}`), drawn),
    curve && part("Response against gray value", h("p.note", {}, "Of the voxels of each gray value."), curve),
  );
}

/** Bins within ±reach, joined until there are about [`BINS`], as steps. */
function joined(own: ErrorHistogram, of: "part" | "void", width: number, reach: number): { x: Measure[]; y: Measure[] } {
  const counts = own[of] ?? [];
  const low = own.range?.[0] ?? 0;
  const each = Math.max(1, Math.round((2 * reach) / width / BINS));
  const x: Measure[] = [];
  const y: Measure[] = [];
  for (let i = 0; i < counts.length; i += each) {
    const left = low + i * width;
    if (left + each * width < -reach || left > reach) continue;
    x.push(left);
    y.push(counts.slice(i, i + each).reduce<number>((sum, count) => sum + (count ?? 0), 0));
  }
  return { x, y };
}
