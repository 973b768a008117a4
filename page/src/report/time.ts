// The print in time, per network: when it is best, what becomes solid, and what it has absorbed by then.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Mark, type Series } from "./chart.ts";
import { isNumber, quantity, significant, type Measure } from "./number.ts";
import { list, report, type Evaluation, type TimeReport } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs, part } from "./text.ts";

export function time({ run }: Context): HTMLElement | null {
  const data = report(run);
  const networks = list(data.time);
  if (networks.length === 0) return null;
  const network = (own: TimeReport) => {
    const words = (run.texts?.time ?? []).find((text) => text.name === own.name)?.sentence;
    const inside = [...paragraphs([words, voxels(own, data.evaluation)]), charts(own), moments(own)];
    return networks.length > 1 ? part(own.name ?? "", ...inside) : h("div", {}, ...inside);
  };
  return h("div", {}, ...paragraphs([run.texts?.one_moment], "lead-in"), ...networks.map(network));
}

/** On which voxels it prints, where they are not those of the numbers at the head. */
function voxels(own: TimeReport, above: Evaluation | null | undefined): string | null {
  const um = (evaluation: Evaluation | null | undefined) => {
    const pitch = evaluation?.grid?.pitch_mm;
    return isNumber(pitch) ? 1e3 * pitch : null;
  };
  const [here, there] = [um(own.evaluation), um(above)];
  if (here === null || there === null) return null;
  const size = significant(here, 3);
  if (Math.abs(here - there) < 1e-6 * here) return `Printed on voxels of ${size} µm, as the dose above.`;
  return `Printed on the job's own voxels of ${size} µm. The numbers above are of voxels of ${significant(there, 3)} µm, so the two cannot be compared.`;
}

function charts(own: TimeReport): HTMLElement {
  const curves = own.curves ?? {};
  const seconds = curves["seconds"] ?? [];
  const end = seconds.findLast(isNumber);
  const x = { label: "time", unit: "s", from: 0, ...(isNumber(end) ? { to: end } : {}) };
  const line = (name: string, color: string, key: string, more: Partial<Series> = {}): Series => ({ name, color, x: seconds, y: curves[key] ?? [], ...more });
  const best: Mark[] = isNumber(own.best_s) ? [{ name: "best", color: "--threshold", from: own.best_s }] : [];
  const [from, to] = own.window_s ?? [];
  const window: Mark[] = isNumber(from) && isNumber(to) ? [{ name: "within 0.01 of the best", color: "--threshold", from, to }] : [];
  const quality = chart({
    title: "IoU and contrast over time",
    x,
    y: { label: "share", from: 0, to: 1 },
    series: [
      line("IoU", "--ink", "jaccard"),
      line("part that is solid", "--part", "solid_part"),
      line("void that is solid", "--void", "solid_void"),
      line("contrast of the dose", "--quiet", "contrast", { style: "dashed" }),
    ],
    marks: [...window, ...best],
  });
  const ideal: Mark[] = isNumber(own.ideal_exposure_s) ? [{ name: "ideal exposure", color: "--threshold", from: own.ideal_exposure_s }] : [];
  const needed = own.requirement_mj;
  const energy = chart({
    title: "Absorbed drive over time",
    x,
    y: { label: "absorbed drive", unit: "mJ", from: 0 },
    series: [
      line("in all voxels", "--quiet", "imbued_mj"),
      line("in solid voxels", "--accent", "contribution_mj"),
      { name: "needed", color: "--ink", style: "dashed", x: [0, end], y: [needed, needed] },
    ],
    marks: ideal,
  });
  const sent = chart({ title: "Light sent over time", x, y: { label: "sent to the vial", unit: "mJ", from: 0 }, series: [line("sent", "--accent", "sent_mj")] });
  return h(
    "div.charts",
    {},
    quality && part("What is solid", quality),
    energy && part("What is absorbed", energy),
    sent && part("Light that was sent", sent),
  );
}

/** The moments and amounts as numbers. */
function moments(own: TimeReport): HTMLElement {
  const evaluation = own.evaluation;
  const s = (value: Measure) => quantity(value, "s");
  const rows = [
    ["First voxel solid", s(own.induction_end_s)],
    ["Best moment", s(own.best_s)],
    ["IoU then", significant(own.best_jaccard, 4)],
    ["Sent to the vial by then", quantity(own.best_mj, "mJ")],
    ["Within 0.01 of the best", (own.window_s ?? []).map(s).join(" to ") || "–"],
    ["Ideal exposure", s(own.ideal_exposure_s)],
    ["Dose that the part needs", quantity(own.requirement_mj, "mJ")],
    ...(isNumber(own.largest_share_of_requirement) ? [["Largest share of it that was reached", quantity(100 * own.largest_share_of_requirement, "%")]] : []),
    ...(evaluation ? [["Voxel error rate of what is solid then", significant(evaluation.ver as Measure, 3)]] : []),
  ];
  return dataTable({ caption: `Moments of the print in time${own.name ? `: ${own.name}` : ""}`, heads: ["", "value"], rows });
}
