// Every number of a run that can be compared, as rows of a table.

import type { Metric, PageData, Run } from "../../data.ts";
import { costOf } from "../history.ts";
import { isNumber, type Measure } from "../number.ts";
import { list, report, type Report } from "../schema.ts";

/** A number of a run. */
export interface Row {
  title: string;
  unit: string;
  better: Metric["better"];
  summary: string;
  of: (run: Run) => Measure;
}

export function rows(data: PageData): Row[] {
  const metrics = data.metrics.map(({ name, title, unit, better, summary }): Row => ({ title, unit, better, summary, of: (run) => report(run).evaluation?.[name] as Measure }));
  return [...metrics, ...OTHERS, ...scenarioNames(data.runs).map(inScenario)];
}

function row(title: string, unit: string, better: Row["better"], of: (report: Report) => Measure): Row {
  return { title, unit, better, summary: "", of: (run) => of(report(run)) };
}

const first = (own: Report) => list(own.time)[0];
const budget = (own: Report) => list(own.lights)[0]?.budget;

const OTHERS: Row[] = [
  row("Edge of the evaluation's voxels", "mm", "none", (own) => own.evaluation?.grid?.pitch_mm),
  row("Loss, at the end", "", "none", (own) => own.history?.loss),
  row("Iterations", "", "none", (own) => own.history?.iterations),
  { title: "Model calls", unit: "", better: "lower", summary: "", of: (run) => costOf(run, "model calls").findLast(isNumber) },
  { title: "Time of the optimization", unit: "s", better: "lower", summary: "", of: (run) => costOf(run, "seconds").findLast(isNumber) },
  row("Time to print", "s", "lower", (own) => own.time_to_print_s),
  row("Energy per turn, first light", "mJ", "none", (own) => budget(own)?.energy_per_turn_mj),
  row("Share of the light that is used, first light", "", "higher", (own) => budget(own)?.light_used),
  row("IoU of the print in time, at its best", "", "higher", (own) => first(own)?.best_jaccard),
  row("The best moment of the print in time", "s", "none", (own) => first(own)?.best_s),
  row("How long the print in time stays within 0.01 of its best IoU", "s", "higher", (own) => length(first(own)?.window_s)),
  row("The least IoU over scenarios, at the job's threshold", "", "higher", (own) => own.scenarios?.worst_iou),
  row("Window over scenarios, trimmed", "", "higher", (own) => own.scenarios?.window),
];

function length(window: Measure[] | null | undefined): Measure {
  const [from, to] = window ?? [];
  return isNumber(from) && isNumber(to) ? to - from : null;
}

/** The scenarios of all runs, each name once. */
function scenarioNames(runs: readonly Run[]): string[] {
  const names = runs.flatMap((run) => list(report(run).scenarios?.rows).map((row) => row.name ?? ""));
  return [...new Set(names)];
}

function inScenario(name: string): Row {
  const of = (own: Report) => list(own.scenarios?.rows).find((row) => row.name === name)?.iou_at_threshold;
  return row(`IoU in ${name}, at the job's threshold`, "", "higher", of);
}
