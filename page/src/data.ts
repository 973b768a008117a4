// What the command writes into the page: types of the data and of what it names.
// Rust (crates/tomolith-report/src/page) makes numbers and sentences; the page draws them.

export interface PageData {
  schema: "tomolith.page/2";
  kind: "report" | "compare" | "check" | "view";
  title: string;
  program: string;
  /** Base path of the server, or null where the page is a file. */
  served: string | null;
  /** All metrics in the order of the report. */
  metrics: Metric[];
  /** Names of the metrics at the head of the page. */
  headline: string[];
  /** The same for a gray target. */
  gray_headline: string[];
  /** What several runs are next to each other; null for one. */
  compare: Comparison | null;
  /** The sweep that is viewed; its runs are added to the list as they are opened. */
  sweep: SweepData | null;
  runs: Run[];
}

export interface SweepData {
  name: string;
  axes: string[];
  /** Key paths of report.json. */
  metrics: string[];
  rows: SweepRow[];
  /** Index of a row; null where none meets what the best one must. */
  best: number | null;
  /** The sweep file. */
  toml: string;
}

/** The value of an axis may be a table of the job. */
export type SweepValue = number | string | boolean | null | object;

export interface SweepRow {
  id: string;
  /** Those of the axes, then of the metrics. */
  values: SweepValue[];
  state: "done" | "failed" | "missing";
  /** Whether it meets what the best run must; null for a run that is not done. */
  feasible: boolean | null;
  /** Why it failed. */
  why: string | null;
}

/** Numbers and keys of several runs; lists have one entry per run. */
export interface Comparison {
  /** What gave the patterns: "optimization" or "simulation". */
  kinds: string[];
  /** Which model gave the dose that a run is evaluated by. */
  models: (string | null)[];
  /** Whether numbers of these runs can be ranked: one model evaluated all of them. */
  marks_best: boolean;
  /** Whether something of the part turns solid. */
  prints: boolean[];
  numbers: { key: string; name: string; unit: string; better: Metric["better"]; values: (number | null)[] }[];
  differing_keys: { key: string; values: (string | null)[] }[];
  warnings: string[];
}

export interface Metric {
  name: string;
  title: string;
  summary: string;
  unit: string;
  better: "higher" | "lower" | "none";
}

export interface Run {
  /** Name of the run folder. */
  name: string;
  state: "done" | "running" | "check" | "failed" | "canceled";
  /** Half width of the band of a gray target, while no report says it. */
  band?: number;
  /** report.json as it is; its keys are documented in crates/tomolith-report/src/json.rs. */
  report: any;
  /** Null for a run of another version. */
  texts: Texts | null;
  /** The job with every default. */
  job: string;
  history: { [column: string]: (number | null)[] };
  volumes: VolumeInfo[];
  films: FilmInfo[];
  scene: Scene | null;
  surface: SurfaceInfo | null;
}

/** Sentences: plain text in which `code` stands between backticks. */
export interface Texts {
  lead: string;
  print_time: string | null;
  facts: [string, string][];
  exposure: string[];
  limits: { name: string; sentence: string }[];
  one_exposure: string | null;
  one_moment: string | null;
  time: { name: string; sentence: string }[];
  scenarios: string | null;
  gap: string | null;
  ceiling: string | null;
}

export type VolumeKind = "target" | "labels" | "bodies" | "response" | "cure_time" | "property";

export interface VolumeInfo {
  /** Its array is the text of the element `blob-<index of the run>-<id>`. */
  id: string;
  kind: VolumeKind;
  /** Null where the run has one species. */
  species: string | null;
  name: string;
  unit: string;
  shape_zyx: [number, number, number];
  pitch_mm: number;
  /** Edge of a voxel along z. */
  height_mm: number;
  center_xyz_mm: [number, number, number];
  bits: 8 | 16;
  low: number;
  high: number;
  /** The code of "no value". */
  nan: number | null;
  logarithmic: boolean;
  /** How many voxels of the evaluation along an edge were averaged to one of these. */
  reduced: number;
  /** Whether the server has all of them. */
  full: boolean;
}

export interface FilmInfo {
  id: string;
  /** "" where there is one light. */
  light: string;
  frames: number;
  rows: number;
  columns: number;
  /** Frames, rows and columns of the patterns, before any reduction. */
  of: [number, number, number];
  every: number;
  binned: number;
  angles_deg: number[];
  full_scale: number;
  pitch_mm: [number, number];
}

export interface Scene {
  /** Whether rays of any frame are those of another one, turned. */
  is_round: boolean;
  /** Radius that every frame lights. */
  lit_radius_mm: number | null;
  part_radius_mm: number;
  z_mm: [number, number];
  walls: Wall[];
  lights: LightPaths[];
  obstacles: { name: string; points: [number, number][] }[];
}

export interface Wall {
  name: string;
  points: [number, number][];
  height_mm?: [number, number];
}

export interface LightPaths {
  name: string;
  frames: { frame: number; /** Where the light comes from. */ angle_deg: number; rays: Ray[] }[];
}

export interface Ray {
  /** In the frame of the part, mm; the first lies before the vial. */
  points: [number, number, number][];
  /** Index of the first point within the resin. */
  resin_from: number;
}

export interface SurfaceInfo {
  id: string;
  vertices: number;
  triangles: number;
  low_mm: [number, number, number];
  high_mm: [number, number, number];
  off_um: [number, number];
}
