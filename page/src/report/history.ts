// The history of the optimization: loss, gradient, quality and the parameters that were found, over what they cost.

import type { Run } from "../data.ts";
import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Axis, type Series } from "./chart.ts";
import { choice } from "./choice.ts";
import { isNumber, significant, type Measure } from "./number.ts";
import { isObject, report, type Levels, type ProcessWindow, type Report } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs, part } from "./text.ts";

/** What a history can be drawn over. */
export const COSTS = ["model calls", "seconds", "iterations"] as const;
export type Cost = (typeof COSTS)[number];

/** What the reader chose last; it outlives the sections, which are drawn again while a run goes on. */
let chosen: Cost = "model calls";

/** The choice of the cost, and a place whose charts follow it. */
export function overCost(runs: readonly Run[], draw: (cost: Cost) => (HTMLElement | null)[]): HTMLElement {
  // A run that goes on does not count its model calls
  const costs = COSTS.filter((cost) => runs.some((run) => costOf(run, cost).some(isNumber)));
  const first = costs.includes(chosen) ? chosen : (costs.at(-1) ?? chosen);
  const grid = h("div.charts");
  const show = (cost: Cost) => grid.replaceChildren(...draw(cost).filter((plot) => plot !== null));
  const choose = (cost: Cost) => {
    chosen = cost;
    show(cost);
  };
  show(first);
  return h("div", {}, choice("Over", costs, first, choose), grid);
}

/** A column of a history over a cost. */
export function costOf(run: Run, cost: Cost): Measure[] {
  const column = (name: string) => run.history?.[name] ?? [];
  if (cost === "seconds") return column("seconds");
  if (cost === "iterations") return column("iteration");
  const adjoint = column("adjoint_calls");
  return column("forward_calls").map((calls, i) => (isNumber(calls) ? calls + (adjoint[i] ?? 0) : null));
}

export function costAxis(cost: Cost): Axis {
  if (cost === "seconds") return { label: "time", unit: "s", from: 0 };
  return { label: cost === "iterations" ? "iteration" : "model calls (dose and adjoint)", from: 0 };
}

/** A chart of the history: a column, or what is made of it. */
interface Curve {
  title: string;
  y: Axis;
  of: Measure[];
}

export function history({ run }: Context): HTMLElement | null {
  const curves = curvesOf(run);
  const words = paragraphs([kept(report(run)), run.texts?.gap, levels(report(run).levels)]);
  const found = foundWindow(report(run).process_window);
  if (curves.length === 0 && words.length === 0 && !found) return null;
  const plots = curves.length > 0 && overCost([run], (cost) => curves.map((curve) => plotOf(run, curve, cost)));
  return h("div", {}, ...words, plots, summary(run), response(run), found);
}

const REASONS: Record<string, string> = { loss: "the lowest loss", print: "the best IoU on the job's voxels", last: "the last step" };

/** Which iterate the patterns are. */
function kept({ history: end }: Report): string | null {
  const own = end?.kept;
  if (!own || !isNumber(own.iteration)) return null;
  const reason = REASONS[own.by ?? ""];
  return `The patterns are those after iteration ${own.iteration}${isNumber(end.iterations) ? ` of ${end.iterations}` : ""}${reason ? `: ${reason}` : ""}.`;
}

/** What was gained on few levels of the machine, or on its pixels. */
function levels(own: Levels | null | undefined): string | null {
  if (!own) return null;
  const n = (value: Measure) => significant(value, 4);
  const diffused = isNumber(own.diffused_loss) ? ` (${n(own.diffused_loss)} by error diffusion)` : "";
  return (
    `As the machine shows them the patterns have a loss of ${n(own.loss)}, plainly rounded ${n(own.rounded_loss)}${diffused}: ${n(own.steps)} steps and ${n(own.calls)} model calls, ` +
    `with a full scale of ${n(own.scale)} times the brightest pixel before.`
  );
}

function curvesOf(run: Run): Curve[] {
  const column = (name: string): Measure[] => run.history?.[name] ?? [];
  const parameters = Object.keys(run.history ?? {}).filter((name) => name.startsWith("response."));
  const curves: Curve[] = [
    { title: "Loss", y: { label: "loss", log: true }, of: column("loss") },
    { title: "Voxels that would print wrongly", y: { label: "1 − IoU", log: true }, of: column("iou").map((iou) => (isNumber(iou) ? 1 - iou : null)) },
    { title: "Process window", y: { label: "response" }, of: column("process_window") },
    { title: "Projected gradient", y: { label: "relative to the first", log: true }, of: column("projected_gradient") },
    ...parameters.map((name) => ({ title: `Response: ${name.slice("response.".length)}`, y: { label: "found so far" }, of: column(name) })),
  ];
  return curves.filter((curve) => curve.of.filter(isNumber).length > 1);
}

function plotOf(run: Run, curve: Curve, cost: Cost): HTMLElement | null {
  const values = curve.of.filter(isNumber);
  if (values.every((value) => value === 0)) {
    return part(curve.title, h("p.note", {}, `It is 0 at each of the ${values.length} points that were measured.`));
  }
  const series: Series = { name: curve.title, color: "--accent", x: costOf(run, cost), y: curve.of };
  const plot = chart({ title: curve.title, x: costAxis(cost), y: curve.y, series: [series] });
  return plot && part(curve.title, plot);
}

/** What it all took. */
function summary(run: Run): HTMLElement | null {
  const last = (name: string) => run.history?.[name]?.findLast(isNumber);
  const end = report(run).history;
  const iterations = last("iteration") ?? end?.iterations;
  if (!isNumber(iterations)) return null;
  const [dose, adjoint] = [last("forward_calls") ?? end?.forward_calls, last("adjoint_calls") ?? end?.adjoint_calls];
  const seconds = last("seconds");
  const took = isNumber(seconds) ? `, ${significant(seconds, 3)} s` : "";
  // Gradients of coarser voxels are not kept
  const gradients = run.history?.projected_gradient ?? [];
  const first = gradients.findIndex(isNumber);
  const coarse = first > 0 ? (run.history?.iteration?.[first] ?? 1) - 1 : 0;
  const finer =
    coarse > 0 ? ` After iteration ${coarse} the voxels became finer: earlier numbers belong to coarser voxels, and the gradient curve begins there.` : "";
  const calls = isNumber(dose) ? `, ${significant(dose, 6)} dose and ${significant(adjoint, 6)} adjoint calls` : "";
  const compare = isNumber(dose) ? " Compare methods by model calls, not by iterations." : "";
  return h("p.note", {}, `${significant(iterations, 6)} iterations${calls}${took}.${compare}${finer}`);
}

/** Parameters of the response that were found with the patterns. */
function response(run: Run): HTMLElement | null {
  const found = report(run).response;
  if (!isObject(found)) return null;
  const rows = Object.entries(found).map(([name, value]) => [name, significant(value as Measure, 4)]);
  return part("Response that was found", dataTable({ caption: "Response that was found", heads: ["parameter", "value"], rows }));
}

/** The window that an objective looked for. */
function foundWindow(window: ProcessWindow | null | undefined): HTMLElement | null {
  if (!window) return null;
  const n = (value: Measure) => significant(value, 4);
  const percent = isNumber(window.outliers) ? `${significant(100 * window.outliers, 3)} %` : "–";
  const rows = [
    ["Outliers that are left out at either end", percent],
    ["Thresholds of the objective, lower and upper", (window.thresholds ?? []).map(n).join(", ")],
    ["All else of the part lies above", n(window.part_above)],
    ["All else of the part lies below", n(window.part_below)],
    ["All else of the void lies below", n(window.void_below)],
    ["Process window", n(window.window)],
    ["Range in the part", n(window.range)],
    ["Bound of that range", n(window.ipdr)],
  ];
  const note = h("p.note", {}, "On the optimization's voxels, before the patterns are written.");
  return part("Process window that the objective found", note, dataTable({ caption: "Process window that the objective found", heads: ["", "response"], rows }));
}
