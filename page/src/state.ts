// What the reader looks at: one small store, mirrored in the address (#…), so that a link restores the same view.

export interface View {
  /** Index of the run. */
  run: number;
  /** Id of the section that was chosen in the list of sections. */
  section: string;
  /** Name of the species, "" for the first. */
  species: string;
  /** What the planes show: id of a layer, "" for the dose. */
  layer: string;
  /** The plane in which all layers are side by side, by its normal: x or y; "" for z. */
  plane: string;
  /** The point in which the three planes meet, mm; null: the middle of the part. */
  at: [number, number, number] | null;
  /** Gel threshold of print, contours and error; null: the report's. */
  threshold: number | null;
  light: number;
  /** Frame of the film, by its place in the blob. */
  frame: number;
  /** Row of the film whose sinogram is shown; null: the middle. */
  row: number | null;
  /** Moment of the print in time, s; null: the best one. */
  time: number | null;
  /** What the print in time shows: error; "" for the times of cure. */
  growth: string;
  /** What the 3D view shows: the print, the target or both. */
  solid: string;
  /** Axis along which the 3D view is cut at the planes' point: x, y or z; "" for no cut. */
  cut: string;
  /** Number of the run of a sweep that is open, from 1 as in its table; null for none. */
  opened: number | null;
  /** Numbers of the runs of a sweep that are compared. */
  marked: number[];
  /** Metrics of a sweep that are drawn, separated by commas; "" for the first. */
  metric: string;
  /** Axes of a sweep that are drawn across and up; "" for the first ones. */
  x: string;
  y: string;
  /** How a sweep is drawn: map or axis; "" for what suits its rows. */
  plot: string;
  /** At which level a map holds each axis, separated by commas; "" for those of the best run. */
  levels: string;
}

export type Key = keyof View;

const START: View = { run: 0, section: "", species: "", layer: "", plane: "", at: null, threshold: null, light: 0, frame: 0, row: null, time: null, growth: "", solid: "", cut: "", opened: null, marked: [], metric: "", x: "", y: "", plot: "", levels: "" };

export class State {
  private view: View;
  private readonly listeners = new Set<{ keys: readonly Key[]; call: () => void }>();
  private writing = 0;

  constructor(private readonly location: Location = window.location) {
    this.view = { ...START, ...this.read() };
    window.addEventListener("hashchange", () => this.set(this.read()));
  }

  /** The view of the address; a bare name (`#history`) is that of a section and leaves the rest as it is. */
  private read(): Partial<View> {
    const hash = this.location.hash;
    return hash !== "" && !hash.includes("=") ? { section: decodeURIComponent(hash.slice(1)) } : parse(hash);
  }

  get<K extends Key>(key: K): View[K] {
    return this.view[key];
  }

  /** Changes the view and calls those who listen to what changed. */
  set(change: Partial<View>): void {
    const keys = (Object.keys(change) as Key[]).filter((key) => !same(this.view[key], change[key]));
    if (keys.length === 0) return;
    this.view = { ...this.view, ...change };
    for (const listener of [...this.listeners]) {
      if (listener.keys.some((key) => keys.includes(key))) listener.call();
    }
    this.write();
  }

  /** Calls back when one of the keys changes. Returns what ends that. */
  on(keys: readonly Key[], call: () => void): () => void {
    const listener = { keys, call };
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** The address is written when the reader pauses: browsers refuse it many times a second. */
  private write(): void {
    window.clearTimeout(this.writing);
    this.writing = window.setTimeout(() => {
      const hash = format(this.view);
      if (hash !== this.location.hash.replace(/^#/, "")) history.replaceState(null, "", `#${hash}`);
    }, 150);
  }
}

/** The address of a view: only what differs from the start. */
export function format(view: View): string {
  const parts: string[] = [];
  for (const key of Object.keys(START) as Key[]) {
    const value = view[key];
    if (value === null || same(value, START[key])) continue;
    parts.push(`${key}=${Array.isArray(value) ? value.map((v) => +v.toFixed(4)).join(",") : encodeURIComponent(String(value))}`);
  }
  return parts.join("&");
}

/** The view of an address. What it does not understand stays as at the start. */
export function parse(hash: string): View {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const view: View = { ...START };
  const whole = (key: Key) => {
    const value = Number(given.get(key) ?? "0");
    return Number.isInteger(value) && value >= 0 ? value : 0;
  };
  const number = (key: Key) => {
    const text = given.get(key);
    return text !== null && text !== "" && Number.isFinite(Number(text)) ? Number(text) : null;
  };
  view.run = whole("run");
  view.light = whole("light");
  view.frame = whole("frame");
  for (const key of ["section", "species", "layer", "plane", "growth", "solid", "cut", "metric", "x", "y", "plot", "levels"] as const) view[key] = given.get(key) ?? "";
  view.threshold = number("threshold");
  view.row = number("row");
  view.time = number("time");
  view.opened = whole("opened") || null;
  view.marked = (given.get("marked") ?? "").split(",").map(Number).filter((run) => Number.isInteger(run) && run > 0);
  const at = given.get("at")?.split(",").map(Number) ?? [];
  if (at.length === 3 && at.every(Number.isFinite)) view.at = [at[0], at[1], at[2]];
  return view;
}

function same(a: unknown, b: unknown): boolean {
  return a === b || (Array.isArray(a) && Array.isArray(b) && a.length === b.length && a.every((v, i) => v === b[i]));
}
