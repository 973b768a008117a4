// Numbers of a print against its gel threshold: IoU, exposure, wrong volumes.
//
// At the report's threshold they are the report's. Elsewhere IoU is that of the report's curve, and volumes are counted from
// the page's voxels by codes, once for all thresholds.

import type { Run } from "./data.ts";
import { LABEL, type Volume } from "./volume.ts";

export interface Histogram {
  low: number;
  high: number;
  part: number[];
  void: number[];
}

export interface Gel {
  /** The threshold of all numbers of the report; without a report the best one for the page's voxels. */
  reported: number;
  isOfReport: boolean;
  /** Along how many voxels of the report each of the page's is a mean: volumes at other thresholds are counted in such means. */
  reduced: number;
  /** What the response is called. */
  quantity: string;
  /** The largest response. */
  high: number;
  histogram: Histogram | null;
  /** Threshold and IoU there, ascending. */
  curve: [number, number][];
  /** Thresholds at which the print is nearly as good as at the best one. */
  nearly: [number | null, number | null] | null;
  /** Thresholds of the objective: void below the first, part above the second. */
  objective: [number, number] | null;
  tolerance: number | null;
  iou(threshold: number): number | null;
  /** Exposure that gels at this threshold, % of the best one: more light, lower threshold. Null for other thresholds of a response. */
  percent(threshold: number): number | null;
  /** Volume that gels and should not, mm³. */
  tooMuch(threshold: number): number | null;
  /** Volume that does not gel and should, mm³. */
  missing(threshold: number): number | null;
}

/** The part of the report that speaks of a species ("" for the first). */
export function reportOf(run: Run, species: string): { evaluation: any; exposure: any; window: [number, number] | null } {
  const named = (run.report?.species ?? []).find((one: { name: string }) => one.name === species);
  const own = named ?? run.report;
  return { evaluation: own?.evaluation ?? null, exposure: own?.exposure ?? null, window: own?.objective_window ?? null };
}

/** The half width of a gray target's band; null where the target is part and void. */
export function bandOf(run: Run): number | null {
  const evaluation = run.report?.evaluation;
  const half = evaluation?.band_half_width ?? run.band ?? null;
  // A band without width: differences are compared with their root mean square
  return half === 0 ? (evaluation?.rms_error ?? null) : half;
}

/** Null where nothing says at what dose the resin gels. */
export function gelOf(run: Run, species: string, response: Volume | null, labels: Volume | null): Gel | null {
  const { evaluation, exposure, window } = reportOf(run, species);
  const counts = response && labels ? countsOf(response, labels) : null;
  const official = evaluation?.gel_threshold ?? null;
  // A run that goes on has no report yet
  const reported = official ?? counts?.best() ?? null;
  const high = response?.info.high ?? evaluation?.histogram?.range?.[1] ?? null;
  // Where there is no dose at all nothing gels at any threshold
  if (reported === null || high === null || high <= 0) return null;
  const curve = withPoint(evaluation?.iou_curve ?? counts?.curve() ?? [], [reported, evaluation?.iou ?? null]);
  const best = exposure?.threshold?.best ?? null;
  const given = evaluation?.histogram;
  const nearly = exposure?.threshold ? ([exposure.threshold.low, exposure.threshold.high] as [number | null, number | null]) : null;
  const quantity = response?.info.name ?? "dose";
  // A response is no multiple of the exposure
  const isDose = quantity === "dose";
  return {
    quantity,
    reported,
    isOfReport: official !== null,
    reduced: response?.info.reduced ?? 1,
    high: Math.max(high, given?.range?.[1] ?? 0, reported),
    histogram: given ? { low: given.range[0], high: given.range[1], part: given.part, void: given.void } : (counts?.histogram ?? null),
    curve,
    nearly,
    objective: window,
    tolerance: exposure?.tolerance ?? null,
    iou: (threshold) => (threshold === official ? evaluation.iou : null) ?? interpolated(curve, threshold) ?? counts?.iou(threshold) ?? null,
    percent: (threshold) => (best === null || threshold <= 0 || !(isDose || threshold === best) ? null : (100 * best) / threshold),
    tooMuch: (threshold) => (threshold === official ? evaluation.over_mm3 : null) ?? counts?.tooMuch(threshold) ?? null,
    missing: (threshold) => (threshold === official ? evaluation.under_mm3 : null) ?? counts?.missing(threshold) ?? null,
  };
}

/** The curve with a point that is known exactly. */
function withPoint(curve: [number, number][], point: [number, number | null]): [number, number][] {
  const [at, iou] = point;
  if (iou === null || iou === undefined) return curve;
  return [...curve.filter(([threshold]) => threshold !== at), [at, iou] as [number, number]].sort((a, b) => a[0] - b[0]);
}

function interpolated(curve: [number, number][], at: number): number | null {
  if (curve.length < 2) return null;
  if (at <= curve[0][0]) return curve[0][1];
  const next = curve.findIndex(([threshold]) => threshold >= at);
  if (next < 0) return curve[curve.length - 1][1];
  const [[x0, y0], [x1, y1]] = [curve[next - 1], curve[next]];
  return y0 + ((at - x0) / (x1 - x0)) * (y1 - y0);
}

const BINS = 120;

/** How many voxels of part and void lie below each code. */
function countsOf(response: Volume, labels: Volume) {
  if (response.codes.length !== labels.codes.length) return null;
  const { values } = response;
  const codes = values.length;
  // [0] part, [1] void; entry i: voxels with a code below i
  const below = [new Float64Array(codes + 1), new Float64Array(codes + 1)];
  for (let i = 0; i < response.codes.length; i++) {
    const label = labels.codes[i];
    if (label !== LABEL.outside) below[label === LABEL.part ? 0 : 1][response.codes[i] + 1]++;
  }
  for (const side of below) for (let i = 1; i <= codes; i++) side[i] += side[i - 1];
  const voxel = response.pitch[0] * response.pitch[1] * response.pitch[2];
  // The first code that is solid. Values ascend with the codes; where the last stands for "none" it is never solid
  const last = Number.isNaN(values[codes - 1]) ? codes - 1 : codes;
  const first = (threshold: number) => {
    let [from, to] = [0, last];
    while (from < to) {
      const middle = (from + to) >> 1;
      if (values[middle] >= threshold) to = middle;
      else from = middle + 1;
    }
    return from;
  };
  const [part, empty] = [below[0][last], below[1][last]];
  const solid = (threshold: number) => {
    const code = first(threshold);
    return { right: part - below[0][code], wrong: empty - below[1][code] };
  };
  const { high } = response.info;
  const binned = (side: Float64Array) =>
    Array.from({ length: BINS }, (_, bin) => side[first((high * (bin + 1)) / BINS)] - side[first((high * bin) / BINS)]);
  const iou = (threshold: number) => {
    const { right, wrong } = solid(threshold);
    return part + wrong > 0 ? right / (part + wrong) : null;
  };
  const curve = () => Array.from({ length: BINS + 1 }, (_, i): [number, number] => [(high * i) / BINS, iou((high * i) / BINS) ?? 0]);
  // At a threshold of 0 all would be solid, also what gets no light
  const best = (): [number, number] => curve().slice(1).reduce((best, point) => (point[1] > best[1] ? point : best));
  return {
    curve,
    /** The threshold with the largest IoU, or the highest one where no threshold prints any of the part; null where there is no part. */
    best: () => (part === 0 ? null : best()[1] > 0 ? best()[0] : high),
    histogram: { low: 0, high, part: binned(below[0]), void: binned(below[1]) } satisfies Histogram,
    iou,
    tooMuch: (threshold: number) => solid(threshold).wrong * voxel,
    missing: (threshold: number) => (part - solid(threshold).right) * voxel,
  };
}
