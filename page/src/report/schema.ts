// report.json, as far as the page shows it (documented in crates/tomolith-report/src/json.rs).
//
// Everything may be missing or null: reports of other versions and of runs that ended early are read too. So nothing
// here is required, and `report(run)` leaves nulls out, so that what is null and what is missing are one case.

import type { Measure } from "./number.ts";

export interface Report {
  part?: string;
  is_toy?: boolean | null;
  evaluation?: Evaluation | null;
  optimization?: (Evaluation & { objectives?: Objective[] | null }) | null;
  exposure?: Exposure | null;
  limits?: Limit[] | null;
  published?: Record<string, unknown> | null;
  lights?: Light[] | null;
  species?: Species[] | null;
  one_exposure?: OneExposure | null;
  time?: TimeReport[] | null;
  one_moment?: OneMoment | null;
  properties?: Property[] | null;
  history?: HistoryEnd | null;
  levels?: Levels | null;
  ceiling?: { trade_off?: TradeOff[] | null } | null;
  scenarios?: Scenarios | null;
  process_window?: ProcessWindow | null;
  response?: Record<string, Measure> | null;
  time_to_print_s?: Measure;
  movies?: Movie[] | null;
  notes?: string[] | null;
  warnings?: string[] | null;
  run?: RunFacts | null;
}

/** Metrics by name, next to what they were measured on. */
export interface Evaluation {
  [metric: string]: unknown;
  gel_threshold?: Measure;
  band_half_width?: Measure;
  sub_angles?: Measure;
  farthest?: { at_xyz_mm?: Measure[]; side?: string } | null;
  grid?: { shape_zyx?: Measure[]; pitch_mm?: Measure } | null;
  part?: Spread | null;
  void?: Spread | null;
  notes?: string[] | null;
  iou_curve?: Measure[][] | null;
  histogram?: Histogram | null;
  errors?: ErrorHistogram | null;
}

export interface Spread { voxels?: Measure; min?: Measure; max?: Measure; mean?: Measure; deviation?: Measure }
export interface Histogram { range?: Measure[]; part?: Measure[]; void?: Measure[] }
export interface ErrorHistogram extends Histogram { band?: Measure[] | null; band_edge_peak?: Measure }
export interface Bracket { low?: Measure; best?: Measure; high?: Measure }

export interface Exposure {
  measure?: string;
  best?: Measure;
  tolerance?: Measure;
  percent?: Bracket | null;
  time_s?: Bracket | null;
  dose?: Bracket | null;
  threshold?: Bracket | null;
  reported_percent?: Measure;
}

export interface Limit {
  cause?: string;
  loss_in_iou?: Measure;
  loss_in_rms_error?: Measure;
  key?: string;
  advice?: string;
}

export interface OneExposure {
  gel_dose?: Measure;
  species?: string[];
  iou?: Measure[];
  limited_by?: string;
  percent?: Bracket | null;
  time_s?: Bracket | null;
}

export interface OneMoment { seconds?: Measure; networks?: string[]; jaccard?: Measure[]; limited_by?: string; window_s?: Measure[] }

export interface Species {
  name?: string;
  driven_by?: Record<string, Measure> | null;
  evaluation?: Evaluation | null;
  exposure?: Exposure | null;
  limits?: Limit[] | null;
}

export interface TimeReport {
  name?: string;
  induction_end_s?: Measure;
  best_s?: Measure;
  best_jaccard?: Measure;
  best_mj?: Measure;
  window_s?: Measure[] | null;
  ideal_exposure_s?: Measure;
  requirement_mj?: Measure;
  largest_share_of_requirement?: Measure;
  evaluation?: Evaluation | null;
  curves?: Record<string, Measure[] | undefined> | null;
}

export interface Property { name?: string; unit?: string; min?: Measure; median?: Measure; max?: Measure }

export interface HistoryEnd {
  iterations?: Measure;
  loss?: Measure;
  forward_calls?: Measure;
  adjoint_calls?: Measure;
  kept?: { by?: string; iteration?: Measure } | null;
  lower_bound?: Measure;
  gap?: Measure;
}

export interface Levels { rounded_loss?: Measure; diffused_loss?: Measure; loss?: Measure; scale?: Measure; steps?: Measure; calls?: Measure }

export interface TradeOff {
  brightest?: Measure;
  print_time_mm?: Measure;
  time_s?: Measure;
  iou?: Measure;
  ver?: Measure;
  surface_mean_mm?: Measure;
  is_chosen?: boolean;
  is_evaluated?: boolean;
}

export interface Scenarios {
  of?: string;
  threshold?: Measure;
  window?: Measure;
  worst_iou?: Measure;
  rows?: ScenarioRow[] | null;
}

export interface ScenarioRow {
  name?: string;
  iou?: Measure;
  iou_at_threshold?: Measure;
  gamma?: Measure;
  part_low?: Measure;
  void_high?: Measure;
}

export interface Objective { key?: string; weight?: Measure; loss?: Measure; voxels?: Measure; rms_error?: Measure; max_error?: Measure }

export interface ProcessWindow {
  outliers?: Measure;
  thresholds?: Measure[] | null;
  part_above?: Measure;
  part_below?: Measure;
  void_below?: Measure;
  window?: Measure;
  range?: Measure;
  ipdr?: Measure;
}

export interface Light {
  name?: string;
  wavelength_nm?: Measure;
  frames?: Measure;
  rows?: Measure;
  columns?: Measure;
  pitch_mm?: Measure | Measure[];
  bits?: Measure;
  full_scale?: Measure;
  canvas?: Measure[] | null;
  budget?: Budget | null;
  irradiance?: { white_mw_per_cm2?: Measure; peak_mw_per_cm2?: Measure } | null;
}

export interface Budget {
  light_used?: Measure;
  white_mj_per_mm2?: Measure;
  time_s?: Measure;
  turns?: Measure;
  energy_per_turn_mj?: Measure;
  energy_mj?: Measure;
}

export interface Movie {
  file?: string;
  frames?: Measure;
  frame_rate?: Measure;
  width?: Measure;
  height?: Measure;
  largest_error_of_255?: Measure;
  rms_error_of_255?: Measure;
}

export interface RunFacts {
  program?: string;
  models?: Record<string, string> | null;
  created?: string;
  timings_s?: Record<string, Measure> | null;
}

const reports = new WeakMap<object, Report>();

/** The report of a run without its nulls; an empty one where it is missing. */
export function report(run: { report: unknown }): Report {
  if (!isObject(run.report)) return {};
  let read = reports.get(run.report);
  if (!read) {
    read = withoutNulls(run.report) as Report;
    reports.set(run.report, read);
  }
  return read;
}

/** Entries of lists keep their place: there null becomes undefined. */
function withoutNulls(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutNulls);
  if (isObject(value)) return Object.fromEntries(Object.entries(value).flatMap(([name, one]) => (one === null ? [] : [[name, withoutNulls(one)]])));
  return value ?? undefined;
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A list, empty where it is missing. */
export function list<T>(value: T[] | null | undefined): T[] {
  return Array.isArray(value) ? value : [];
}

/** Whether the target has gray values: then there are errors instead of a threshold. */
export function isGray(evaluation: Evaluation | null | undefined): boolean {
  return typeof evaluation?.band_half_width === "number";
}
