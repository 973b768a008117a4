// Data for the tests of the report's sections: a run that has everything a report can hold, and what can be made of it.

import type { PageData, Run } from "../src/data.ts";

const METRICS: PageData["metrics"] = [
  { name: "iou", title: "IoU", summary: "Volume in both print and part.", unit: "", better: "higher" },
  { name: "pw", title: "Process window PW", summary: "Least of the part less the most of the void.", unit: "response", better: "higher" },
  { name: "ver", title: "Voxel error rate", summary: "Share of wrong voxels.", unit: "", better: "lower" },
  { name: "hausdorff_mm", title: "Surface deviation, largest", summary: "The largest distance.", unit: "mm", better: "lower" },
  { name: "over_mm3", title: "Overcured volume", summary: "Gels though it should not.", unit: "mm³", better: "lower" },
  { name: "rms_error", title: "Rms error", summary: "Of the response.", unit: "response", better: "lower" },
];

function evaluation(iou: number) {
  return {
    iou,
    pw: -0.0352,
    ver: 0.00251,
    hausdorff_mm: 0.0396,
    over_mm3: 0.054,
    rms_error: null,
    gel_threshold: 0.786,
    band_half_width: null,
    sub_angles: 2,
    farthest: { at_xyz_mm: [2.3459, -0.338, -0.0375], side: "print_without_target" },
    grid: { shape_zyx: [4, 8, 8], pitch_mm: 0.075, center_xyz_mm: [0, 0, 0] },
    part: { voxels: 100, min: 0.76, max: 1.01, mean: 0.93, deviation: 0.03 },
    void: { voxels: 100, min: 0, max: 0.8, mean: 0.11, deviation: 0.2 },
    notes: ["the surface is open"],
    iou_curve: [[0, 0.4], [0.5, 0.7], [0.786, iou], [1, 0.1]],
    histogram: { range: [0, 1], part: [0, 0, 5, 95], void: [80, 15, 5, 0] },
    errors: null,
  };
}

const EXPOSURE = {
  measure: "iou",
  best: 0.9922,
  tolerance: 0.01,
  percent: { low: 97.256, best: 100, high: null },
  time_s: { low: 60, best: 75, high: null },
  dose: { low: 0.7627, best: 0.7857, high: 0.8079 },
  threshold: { low: 0.7627, best: 0.7857, high: 0.8079 },
  reported_percent: 100,
};

const LIMITS = [
  { cause: "grid", loss_in_iou: 0.037, key: "grid.pitch_mm", advice: "It sees no less than a voxel. Lower `grid.pitch_mm`." },
  { cause: "turning", loss_in_iou: 0.0001, key: "light.angles", advice: "It turns by 10°." },
];

/** A report with everything but a gray target. */
function report() {
  return {
    schema: "tomolith.report/1",
    part: "wheel",
    evaluation: evaluation(0.9922),
    optimization: {
      ...evaluation(0.9962),
      objectives: [
        { key: "objectives[0].bclp", weight: 1, loss: 12.345, voxels: 1234, rms_error: 0.25, max_error: 0.5 },
        { key: "objectives[1].threshold", weight: 0.2, loss: null, voxels: 96, rms_error: null, max_error: null },
      ],
    },
    exposure: EXPOSURE,
    limits: LIMITS,
    published: {
      ver_box: { value: 0.0024546, unit: "", note: "of the whole array", source: "Li et al. 2024" },
      jaccard_grid: { value: 0.99169, unit: "", note: "over 100 thresholds", source: "Dr.TVAM 0.9" },
      insert: { share: 0.0696, insert_mm2: 62.47 },
      unit_systems: [{ dose: [0.8, "J/cm³"], system: "volumetric" }],
      slices: [{ z_mm: -0.1, pw: 0.1, ipdr: 0.2, ver: 0.01 }, { z_mm: 0, pw: null, ipdr: null, ver: null }, { z_mm: 0.1, pw: 0.11, ipdr: 0.21, ver: 0.02 }],
    },
    lights: [
      {
        name: "violet",
        wavelength_nm: 455,
        frames: 36,
        rows: 6,
        columns: 43,
        pitch_mm: [0.15, 0.2],
        bits: 8,
        full_scale: 0.477,
        canvas: [642, 362],
        budget: { light_used: 0.3086, white_mj_per_mm2: 2.39, time_s: 75, turns: 12.5, energy_per_turn_mj: 38.15, energy_mj: 228.9 },
        irradiance: { white_mw_per_cm2: 95.6, peak_mw_per_cm2: 191.2 },
      },
    ],
    species: [
      { name: "acrylate", driven_by: { uv: 0.4, violet: -1 }, evaluation: evaluation(0.9922), exposure: EXPOSURE, limits: LIMITS },
      { name: "epoxy", driven_by: { uv: 1, violet: 0 }, evaluation: evaluation(0.9646), exposure: EXPOSURE, limits: LIMITS },
    ],
    one_exposure: { gel_dose: 0.796, species: ["acrylate", "epoxy"], iou: [0.9911, 0.9637], limited_by: "epoxy", percent: { low: 98.7, best: 100, high: 101.5 }, time_s: null },
    time: [
      {
        name: "resin",
        induction_end_s: 33.3,
        best_s: 42.5,
        best_jaccard: 0.9242,
        best_mj: 108.1,
        window_s: [41.7, 42.5],
        ideal_exposure_s: 41.06,
        requirement_mj: 13.59,
        largest_share_of_requirement: null,
        evaluation: evaluation(0.92),
        curves: { seconds: [0, 30, 42.5, 60], imbued_mj: [0, 5, 9, 14], contribution_mj: [0, 0, 6, 13], contrast: [null, 0.7, 0.7, 0.7], jaccard: [0, 0, 0.9242, 0.5], sent_mj: [0, 70, 108, 150] },
      },
    ],
    one_moment: null,
    properties: [{ name: "modulus", unit: "MPa", min: 5.07, median: 8.47, max: 7977 }],
    history: { iterations: 2, loss: 8.1, projected_gradient: 0.1, forward_calls: 4, adjoint_calls: 2, kept: { by: "loss", iteration: 2 }, lower_bound: 5.5, gap: 0.3 },
    levels: { rounded_loss: 12, diffused_loss: null, loss: 10, scale: 0.9, steps: 5, calls: 20 },
    ceiling: {
      trade_off: [
        { brightest: 1.21, print_time_mm: 1.54, time_s: null, iou: 0.863, ver: 0.0124, surface_mean_mm: 0.052, is_chosen: false, is_evaluated: false },
        { brightest: 0.858, print_time_mm: 1.09, time_s: null, iou: 0.8714, ver: 0.0093, surface_mean_mm: 0.054, is_chosen: false, is_evaluated: false },
        { brightest: 0.607, print_time_mm: 0.772, time_s: null, iou: 0.8696, ver: 0.0109, surface_mean_mm: null, is_chosen: true, is_evaluated: false },
      ],
    },
    scenarios: {
      of: "worst",
      threshold: 0.8028,
      window: -0.147,
      worst_iou: 0.9168,
      rows: [{ name: "the job", iou: 0.94, iou_at_threshold: 0.94, gamma: 4.6, part_low: 0.75, void_high: 0.84 }, { name: "image to the left", iou: 0.93, iou_at_threshold: 0.9168, gamma: null, part_low: 0.72, void_high: 0.87 }],
    },
    process_window: { outliers: 0.01, thresholds: [0.7, 0.9], part_above: 0.8, part_below: 1.1, void_below: 0.7, window: 0.1, range: 0.3, ipdr: null },
    response: { steepness: 14.18 },
    time_to_print_s: 75,
    movies: [{ file: "wheel.mp4", frames: 36, frame_rate: 6, width: 44, height: 16, largest_error_of_255: 4, rms_error_of_255: 0.8 }],
    notes: ["z is moved"],
    warnings: ["the part ends within `grid.pitch_mm` of the wall"],
    run: {
      program: "Tomolith 0.1.0",
      models: { evaluation: "parallel (kernel): one slice serves all" },
      created: "2026-11-27 04:31 UTC",
      timings_s: { optimizing: 2, "optimizing: metrics": 1.5, "reading the job": 0.005 },
    },
  };
}

/** What the tests change of a report, whose type in Rust is richer than the page needs. */
// eslint-disable-next-line @typescript-eslint/no-explicit-any
export type AnyReport = any;

export function run(name = "wheel"): Run {
  return {
    name,
    state: "done",
    report: report(),
    texts: {
      lead: "The print and the part overlap with an IoU of 0.9922.",
      print_time: "Print time N·M/t 0.772 mm.",
      facts: [["Vial", "cylinder"], ["Frames", "36"]],
      exposure: ["At the best exposure resin gels at a dose of 0.786."],
      limits: [{ name: "acrylate", sentence: "Finer grid −0.037." }, { name: "epoxy", sentence: "Iterations −0.02." }],
      one_exposure: "A print has one exposure.",
      one_moment: null,
      time: [{ name: "resin", sentence: "The print is best after 42.5 s." }],
      scenarios: "over the job and 1 scenario: IoU at least 0.9168",
      gap: "no patterns have a loss below 5.5",
      ceiling: "no pixel is brighter than 0.607",
    },
    job: '[grid]\npitch_mm = 0.15\n',
    history: {
      iteration: [0, 1, 2],
      loss: [106.7, 46.4, 8.1],
      projected_gradient: [null, 1, 0.1],
      forward_calls: [1, 3, 4],
      adjoint_calls: [0, 1, 2],
      seconds: [0.001, 0.006, 0.01],
      iou: [0.83, null, 1],
      process_window: [-0.3, null, 0.02],
      "response.steepness": [12, 13, 14.18],
    },
    volumes: [],
    films: [],
    scene: null,
    surface: null,
  };
}

export function pageData(runs: Run[] = [run()]): PageData {
  return {
    schema: "tomolith.page/2",
    kind: runs.length > 1 ? "compare" : "report",
    title: runs[0].name,
    program: "Tomolith 0.1.0",
    served: null,
    metrics: METRICS,
    headline: ["iou", "pw", "hausdorff_mm", "over_mm3"],
    gray_headline: ["rms_error"],
    compare: null,
    sweep: null,
    runs,
  };
}

/** A gray target: errors in place of a threshold. */
export function gray(): Run {
  const own = run();
  const of: AnyReport = own.report;
  of.evaluation.band_half_width = 0.05;
  of.evaluation.rms_error = 0.1023;
  of.evaluation.gel_threshold = null;
  of.evaluation.errors = { range: [-1, 1], band: [-0.05, 0.05], part: [0, 10, 20, 0], void: [0, 50, 5, 0], band_edge_peak: 1.5 };
  of.species = [];
  of.one_exposure = null;
  return own;
}

/** Two runs as `tomolith compare` puts them next to each other. */
export function comparison(): PageData {
  const runs = [run("first"), run("second")];
  const worse: AnyReport = runs[1].report;
  worse.evaluation.iou = 0.9;
  return {
    ...pageData(runs),
    compare: {
      kinds: ["optimization", "simulation"],
      models: ["parallel", "parallel"],
      marks_best: true,
      prints: [true, true],
      numbers: [
        { key: "iou", name: "IoU", unit: "", better: "higher", values: [0.9922, 0.9] },
        { key: "hausdorff_mm", name: "Surface deviation, largest", unit: "mm", better: "lower", values: [0.0396, 0.02] },
        { key: "loss", name: "Loss, at the end", unit: "", better: "none", values: [8.1, 7] },
        { key: "gone", name: "What no run has", unit: "", better: "none", values: [null, null] },
      ],
      differing_keys: [{ key: "stop.iterations", values: ["3", null] }],
      warnings: ["The runs minimize different losses, whose numbers cannot be compared."],
    },
  };
}

type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** The same with every leaf replaced: a report in which nothing is known, or whose names are markup. */
export function leaves<T>(value: T, replace: (leaf: null | boolean | number | string, key: string) => unknown): T {
  const walk = (one: Json, key: string): unknown => {
    if (Array.isArray(one)) return one.map((inside) => walk(inside, key));
    if (typeof one === "object" && one !== null) return Object.fromEntries(Object.entries(one).map(([name, inside]) => [name, walk(inside, name)]));
    return replace(one, key);
  };
  return walk(value as Json, "") as T;
}
