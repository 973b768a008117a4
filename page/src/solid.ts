// Print and target in 3D: surfaces colored by deviation, cut at the planes' point, with inserts and vial.
//
// At the report's threshold the surface is the report's. At another one the worker makes it from the page's voxels, whose
// deviations are good to about a tenth of a voxel.

import { choice, later, legendOf, messageOf, problem, toggle } from "./controls.ts";
import type { SurfaceInfo } from "./data.ts";
import { h } from "./dom.ts";
import { bandOf, gelOf, reportOf } from "./gel.ts";
import type { Legend, Picture } from "./layers.ts";
import { deviation, place, type Scale, token, viridis } from "./paint.ts";
import { significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import { Stage } from "./stage.ts";
import type { Key } from "./state.ts";
import type { Mesh } from "./surface.ts";
import { samplesOf, SurfaceClient } from "./surface_client.ts";
import { type Axis, AXES, BODY, type Point, type Slice, type Volume } from "./volume.ts";
import { chosenSpecies, speciesOf, type Volumes, volumesOf } from "./volumes.ts";

export const solid: Section = {
  id: "solid",
  title: "In 3D",
  render: (context) => {
    const has = (kind: string) => context.run.volumes.some((info) => info.kind === kind);
    if (!has("target") && !context.run.surface) return null;
    if (document.createElement("canvas").getContext("webgl2") === null) {
      return problem("This browser has no WebGL 2, so print and target cannot be shown in 3D. The slices above show the same volumes.");
    }
    return whenSeen(context, () => later(context, draw));
  },
};

/** Surfaces are made when the reader comes near them. */
function whenSeen({ gone }: Context, make: () => HTMLElement): HTMLElement {
  const place = h("div.solid-place");
  const watcher = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      watcher.disconnect();
      place.replaceChildren(make());
    },
    { rootMargin: "300px" },
  );
  watcher.observe(place);
  gone.addEventListener("abort", () => watcher.disconnect());
  return place;
}

async function draw(context: Context): Promise<HTMLElement> {
  const { volumes, problems } = await volumesOf(context, chosenSpecies(context));
  const grid = volumes.response ?? volumes.target;
  if (!grid) throw new Error(problems.join(" ") || "The run has no volume to show.");
  return new Solid(context, volumes, grid).element(problems);
}

/** Share of the corners whose deviation has a color of its own; those beyond have the color of the end. */
const WITHIN = 0.95;
/** Steps between the two ends of the colors. */
const COLORS = 40;
/** Of several thresholds in a row only the last one's surface is made, ms. */
const PAUSE = 120;

/** What the 3D view can show in color or clear over the print. */
const MODES: [string, string][] = [["", "Print"], ["both", "Print and target"], ["target", "Target"]];

class Solid {
  private readonly stage: Stage;
  private readonly client: SurfaceClient;
  private readonly legend = h("div.color-legend");
  private readonly note = h("p.quiet", { role: "status" });
  private reported: number | null;
  /** Counts what was asked for: an answer to an earlier question is too late. */
  private newest = 0;
  private isNew = false;
  private isRenewing = false;

  constructor(
    private readonly context: Context,
    private volumes: Volumes,
    private readonly grid: Volume,
  ) {
    this.reported = this.thresholdOf(volumes);
    const [low, high] = boxOfPart(volumes.target ?? grid, grid);
    this.stage = new Stage(low, high, context.gone);
    this.stage.canvas.setAttribute("aria-label", "Surfaces of print and target. Arrow keys turn the view, + and − zoom, 0 looks from the front again.");
    this.client = new SurfaceClient(context.gone);
  }

  async element(problems: string[]): Promise<HTMLElement> {
    this.listen(["threshold"], () => this.attempt(this.showPrint()));
    this.listen(["threshold", "at", "cut"], () => this.showCut());
    this.listen(["solid"], () => this.attempt(this.showAll()));
    this.listen(["species"], () => this.attempt(this.reload()));
    this.context.renewed.addEventListener("renewed", () => this.attempt(this.renew()), { signal: this.context.gone });
    await this.load();
    this.attempt(this.showAll());
    return h(
      "div.solid",
      {},
      ...problems.map(problem),
      h("p.quiet", {}, "Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. The cut goes through the point that the planes above show."),
      this.controls(),
      this.stage.canvas,
      h("div.below-planes", {}, this.note, this.legend),
    );
  }

  /** The threshold of the print; null where nothing says when the resin gels, as for a gray target. */
  private get level(): number | null {
    if (this.reported === null || !this.volumes.response) return null;
    return this.context.state.get("threshold") ?? this.reported;
  }

  private thresholdOf({ response, labels }: Volumes): number | null {
    const { run } = this.context;
    return bandOf(run) === null ? (gelOf(run, chosenSpecies(this.context), response, labels)?.reported ?? null) : null;
  }

  private get mode(): string {
    const chosen = this.context.state.get("solid");
    if (this.level === null) return "target";
    return MODES.some(([mode]) => mode === chosen) ? chosen : "";
  }

  /** The surface that the command has made, where it is the one to show. */
  private get official(): SurfaceInfo | null {
    const { run, state } = this.context;
    const isFirst = chosenSpecies(this.context) === "" || chosenSpecies(this.context) === speciesOf(run)[0];
    return state.get("threshold") === null && isFirst && run.surface !== null && run.surface.triangles > 0 ? run.surface : null;
  }

  private load(): Promise<unknown> {
    const { response, target } = this.volumes;
    return this.client.ask({ kind: "load", response: response && samplesOf(response), target: target && samplesOf(target) });
  }

  /** Shows the newest volumes of a run that goes on; those that come while others are drawn are left out. */
  private async renew(): Promise<void> {
    this.isNew = true;
    if (this.isRenewing) return;
    this.isRenewing = true;
    try {
      while (this.isNew && !this.context.gone.aborted) {
        this.isNew = false;
        await this.reload();
      }
    } finally {
      this.isRenewing = false;
    }
  }

  private async reload(): Promise<void> {
    this.volumes = (await volumesOf(this.context, chosenSpecies(this.context))).volumes;
    this.reported = this.thresholdOf(this.volumes);
    await this.load();
    await this.showAll();
  }

  private async showAll(): Promise<void> {
    this.showCut();
    await Promise.all([this.showPrint(), this.showTarget()]);
  }

  private async showPrint(): Promise<void> {
    const turn = ++this.newest;
    const { level, official, stage, note } = this;
    if (this.mode === "target" || level === null) {
      stage.remove("print");
      this.legend.replaceChildren(legendOf({ keys: [["var(--solid)", "target"]] }));
      note.textContent = "";
      return;
    }
    note.textContent = "Making the surface…";
    if (!official) await new Promise((resolve) => setTimeout(resolve, PAUSE));
    if (turn !== this.newest) return;
    const { mesh, off_um } = official ? await this.ofCommand(official) : await this.atLevel(level);
    if (turn !== this.newest || this.context.gone.aborted) return;
    const reach = off_um ? reachOf(off_um) : 0;
    const colors = off_um && Uint32Array.from(off_um, (off) => deviation(Math.round(COLORS * (0.5 + off / (2 * reach))) / COLORS));
    stage.mesh("print", mesh, colors ? { colors } : { color: token("--solid") });
    const scale: Legend = { scale: { low: -reach, high: reach, logarithmic: false, map: deviation }, label: "deviation from the target, µm: blue is too small, red too large", mark: null };
    const isEmpty = mesh.triangles.length === 0;
    this.legend.replaceChildren(...(isEmpty ? [] : [legendOf(off_um ? scale : { keys: [["var(--solid)", "print"]] })]));
    const made = official ? "The surface at the report’s threshold." : `The surface at a threshold of ${significant(level, 3)}, from the page’s voxels.`;
    note.textContent = isEmpty ? "At this threshold nothing is solid." : made;
  }

  private async ofCommand(info: SurfaceInfo): Promise<{ mesh: Mesh; off_um: Float32Array | null }> {
    const surface = await this.context.store.surface(info);
    return { mesh: surface, off_um: surface.off_um };
  }

  private async atLevel(level: number): Promise<{ mesh: Mesh; off_um: Float32Array | null }> {
    const made = await this.client.ask({ kind: "print", level });
    return { mesh: made, off_um: made.off && made.off.map((mm) => 1000 * mm) };
  }

  private async showTarget(): Promise<void> {
    if (this.mode === "") return this.stage.remove("target");
    const mesh = await this.client.ask({ kind: "target" });
    if (this.context.gone.aborted || this.mode === "") return;
    this.stage.mesh("target", mesh, { color: token("--solid"), opacity: this.mode === "both" ? 0.3 : 1 });
  }

  private showCut(): void {
    const { state } = this.context;
    const axis = AXES.indexOf(state.get("cut") as (typeof AXES)[number]);
    if (axis < 0) return this.stage.cut(null, 0, null);
    const mm = this.grid.nearest(state.get("at") ?? this.grid.center)[axis];
    this.stage.cut(axis as Axis, mm, cutPicture(this.volumes, axis as Axis, mm, this.mode === "target" ? null : this.level));
  }

  private controls(): HTMLElement {
    const { stage } = this;
    const { run, state } = this.context;
    const view = (text: string, azimuth: number, elevation: number) => h("button", { type: "button", click: () => stage.look(azimuth, elevation) }, text);
    const cuts: [string, string][] = [["", "Whole"], ["x", "Cut along x"], ["y", "Cut along y"], ["z", "Cut along z"]];
    const farthest = reportOf(run, chosenSpecies(this.context)).evaluation?.farthest?.at_xyz_mm as Point | undefined;
    return h(
      "div.controls",
      {},
      this.level !== null && choice("Surface", MODES, () => this.mode, (solid) => state.set({ solid }), (call) => this.listen(["solid"], call)),
      choice("Cut", cuts, () => state.get("cut"), (cut) => state.set({ cut }), (call) => this.listen(["cut"], call)),
      h("span.views", {}, view("From the front", -60, 30), view("From behind, below", 120, -30), view("From above", -90, 89.9)),
      ...this.extras(),
      farthest?.length === 3 && h("button", { type: "button", click: () => state.set({ at: farthest, cut: state.get("cut") || "y" }) }, "Cut at the largest deviation"),
    );
  }

  /** Boxes to tick for what else there is: bodies and the vial. */
  private extras(): HTMLElement[] {
    const { stage, client } = this;
    const { bodies } = this.volumes;
    const { scene } = this.context.run;
    const present = bodies ? BODIES.filter(({ code }) => bodies.codes.includes(code)) : [];
    const boxes = present.map(({ code, text, color }) => {
      const show = async () => stage.mesh(text, await client.ask({ kind: "part", samples: samplesOf(bodies!), code }), { color: token(color), opacity: 0.75 });
      this.attempt(show());
      return toggle(text, true, (checked) => (checked ? this.attempt(show()) : stage.remove(text)));
    });
    if (scene && scene.walls.length > 0) {
      const [from, to] = scene.z_mm;
      const walls = scene.walls.map(({ points, height_mm }) => ({ points, low: height_mm?.[0] ?? from, high: height_mm?.[1] ?? to }));
      boxes.push(toggle("vial", false, (checked) => (checked ? stage.walls("vial", walls, token("--quiet")) : stage.remove("vial"))));
    }
    return boxes;
  }

  /** Says in the note below the view what went wrong. */
  private attempt(work: Promise<void>): void {
    work.catch((error: unknown) => (this.note.textContent = messageOf(error)));
  }

  private listen(keys: readonly Key[], call: () => void): void {
    this.context.gone.addEventListener("abort", this.context.state.on(keys, call));
  }
}

const BODIES = [
  { code: BODY.insert, text: "insert", color: "--ink" },
  { code: BODY.dark, text: "bodies that stay dark", color: "--void" },
  { code: BODY.obstacle, text: "obstacles", color: "--quiet" },
];

/** What fills the cut: the dose where the print is solid, or the target. */
function cutPicture({ response, target }: Volumes, axis: Axis, mm: number, level: number | null): Picture | null {
  const volume = level === null ? target : response;
  const slice = volume?.slice(axis, mm);
  if (!volume || !slice) return null;
  const scale: Scale = { low: 0, high: volume.info.high, logarithmic: false, map: viridis };
  const gray = token("--solid");
  const colors = Uint32Array.from({ length: 256 }, (_, i) => viridis(i / 255));
  const color = (value: number) => (level === null ? gray : colors[Math.round(255 * Math.min(Math.max(place(scale, value), 0), 1))]);
  return finer(slice, level ?? 0.5, color);
}

/** Pixels along an edge of a cut, about. */
const CUT_PIXELS = 640;

/** A slice with values between its voxels, so that its edge at a level lies where the surface is; clear below the level. */
function finer(slice: Slice, level: number, color: (value: number) => number): Picture {
  const { width, height, codes, values } = slice;
  const factor = Math.max(1, Math.round(CUT_PIXELS / Math.max(width, height)));
  const pixels = new Uint32Array(width * factor * height * factor);
  const at = (x: number, y: number) => {
    const value = values[codes[Math.min(Math.max(y, 0), height - 1) * width + Math.min(Math.max(x, 0), width - 1)]];
    return Number.isNaN(value) ? 0 : value;
  };
  for (let row = 0, i = 0; row < height * factor; row++) {
    const v = (row + 0.5) / factor - 0.5;
    const y = Math.floor(v);
    for (let column = 0; column < width * factor; column++, i++) {
      const u = (column + 0.5) / factor - 0.5;
      const x = Math.floor(u);
      const top = at(x, y) + (u - x) * (at(x + 1, y) - at(x, y));
      const bottom = at(x, y + 1) + (u - x) * (at(x + 1, y + 1) - at(x, y + 1));
      const value = top + (v - y) * (bottom - top);
      if (value >= level) pixels[i] = color(value);
    }
  }
  return { ...slice, pixels, width: width * factor, height: height * factor, pitch: [slice.pitch[0] / factor, slice.pitch[1] / factor] };
}

/** Deviation up to which colors differ, µm: a round number, not smaller than most of them. */
function reachOf(off_um: Float32Array): number {
  const sizes = off_um.map(Math.abs).sort();
  const size = Math.max(sizes[Math.min(Math.floor(sizes.length * WITHIN), sizes.length - 1)] ?? 1, 1e-3);
  const power = 10 ** Math.floor(Math.log10(size));
  return ([1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((n) => n * power >= size * (1 - 1e-6)) ?? 10) * power;
}

/** The box of the voxels that are part; the whole volume where there are none. */
function boxOfPart(target: Volume, grid: Volume): [Point, Point] {
  const { codes, values, shape } = target;
  const isPart = values.map((value) => Number(value >= 0.5));
  const [low, high] = [[...shape], [-1, -1, -1]];
  let i = 0;
  for (let z = 0; z < shape[2]; z++) {
    for (let y = 0; y < shape[1]; y++) {
      for (let x = 0; x < shape[0]; x++, i++) {
        if (isPart[codes[i]] === 0) continue;
        [x, y, z].forEach((at, axis) => {
          if (at < low[axis]) low[axis] = at;
          if (at > high[axis]) high[axis] = at;
        });
      }
    }
  }
  const volume = high[0] < 0 ? grid : target;
  const ends = high[0] < 0 ? [[0, 0, 0], grid.shape.map((n) => n - 1)] : [low, high];
  return ends.map((end, side) => end.map((index, axis) => volume.middle(axis as Axis, index) + (side - 0.5) * volume.pitch[axis]) as Point) as [Point, Point];
}

