// Print and target in 3D: surfaces colored by deviation, cut at the planes' point, with inserts and vial.
//
// At the report's threshold the surface is the report's. At another one the worker makes it from the page's voxels, whose
// deviations are good to about a tenth of a voxel.

import { h } from "./dom.ts";
import { bandOf, gelOf, reportOf } from "./gel.ts";
import type { Legend, Picture, Volumes } from "./layers.ts";
import { choice, later, legendOf, speciesOf, volumesOf } from "./look.ts";
import { deviation, place, type Scale, token, viridis } from "./paint.ts";
import { significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import { Stage } from "./stage.ts";
import type { Mesh } from "./surface.ts";
import { samplesOf, SurfaceClient } from "./surface_client.ts";
import { type Axis, AXES, BODY, type Point, type Slice, type Volume } from "./volume.ts";

export const solid: Section = {
  id: "solid",
  title: "In 3D",
  render: (context) => {
    const has = (kind: string) => context.run.volumes.some((info) => info.kind === kind);
    if (!has("target") && !context.run.surface) return null;
    if (document.createElement("canvas").getContext("webgl2") === null) {
      return h("p.problem", { role: "alert" }, "This browser has no WebGL 2, so print and target cannot be shown in 3D. The slices above show the same volumes.");
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

/** Share of the corners whose deviation has a color of its own; those beyond have the color of the end. */
const WITHIN = 0.95;

async function draw(context: Context): Promise<HTMLElement> {
  const { run, state, store, gone } = context;
  const names = speciesOf(run);
  const chosen = () => (names.includes(state.get("species")) ? state.get("species") : "");
  let { volumes, problems } = await volumesOf(context, chosen());
  const grid = volumes.response ?? volumes.target;
  if (!grid) throw new Error(problems.join(" ") || "The run has no volume to show.");
  const band = bandOf(run);
  const gel = () => (band === null ? gelOf(run, chosen(), volumes.response, volumes.labels) : null);
  const isFirst = () => chosen() === "" || chosen() === names[0];

  const [low, high] = boxOfPart(volumes.target ?? grid, grid);
  const stage = new Stage(low, high, gone);
  stage.canvas.setAttribute("aria-label", "Surfaces of print and target. Arrow keys turn the view, + and − zoom, 0 looks from the front again.");
  const client = new SurfaceClient(gone);
  const legend = h("div.color-legend");
  const note = h("p.quiet", { role: "status" });

  const mode = () => (["target", "both"].includes(state.get("solid")) ? state.get("solid") : band === null && volumes.response ? "print" : "target");
  let newest = 0;
  const load = () => client.ask({ kind: "load", response: volumes.response && samplesOf(volumes.response), target: volumes.target && samplesOf(volumes.target) });
  const showPrint = async () => {
    const threshold = state.get("threshold");
    const level = threshold ?? gel()?.reported ?? null;
    const turn = ++newest;
    if (mode() === "target" || level === null) {
      stage.remove("print");
      legend.replaceChildren(legendOf({ keys: [["var(--solid)", "target"]] }));
      note.textContent = "";
      return;
    }
    const official = threshold === null && isFirst() && run.surface !== null && run.surface.triangles > 0 ? run.surface : null;
    note.textContent = official ? "" : "Making the surface…";
    let mesh: Mesh;
    let off_um: Float32Array | null;
    if (official) {
      const surface = await store.surface(official);
      [mesh, off_um] = [surface as Mesh, surface.off_um];
    } else {
      // Of several thresholds in a row only the last is made
      await new Promise((resolve) => setTimeout(resolve, 120));
      if (turn !== newest) return;
      const made = await client.ask({ kind: "print", level });
      [mesh, off_um] = [made, made.off && made.off.map((mm) => 1000 * mm)];
    }
    if (turn !== newest || gone.aborted) return;
    const reach = off_um ? reachOf(off_um) : 0;
    const colors = off_um && Uint32Array.from(off_um, (off) => deviation(Math.round(40 * (0.5 + off / (2 * reach))) / 40));
    stage.mesh("print", mesh, colors ? { colors } : { color: token("--solid") });
    const keys: Legend = { scale: { low: -reach, high: reach, logarithmic: false, map: deviation }, label: "deviation from the target, µm: blue is too small, red too large", mark: null };
    legend.replaceChildren(off_um ? legendOf(keys) : legendOf({ keys: [["var(--solid)", "print"]] }));
    note.textContent = mesh.triangles.length === 0 ? "At this threshold nothing is solid." : official ? "The surface at the report’s threshold." : `The surface at a threshold of ${significant(level, 3)}, from the page’s voxels.`;
  };
  const showTarget = async () => {
    if (mode() === "print") return stage.remove("target");
    const mesh = await client.ask({ kind: "target" });
    if (gone.aborted || mode() === "print") return;
    stage.mesh("target", mesh, { color: token("--solid"), opacity: mode() === "both" ? 0.3 : 1 });
  };
  const failed = (error: unknown) => {
    note.textContent = error instanceof Error ? error.message : String(error);
  };
  const showCut = () => {
    const axis = (AXES as readonly string[]).indexOf(state.get("cut"));
    if (axis < 0) return stage.cut(null, 0, null);
    const mm = (state.get("at") ?? grid.center)[axis];
    stage.cut(axis as Axis, mm, cutPicture(volumes, axis as Axis, mm, mode() === "target" ? null : (state.get("threshold") ?? gel()?.reported ?? null)));
  };
  const showAll = () => {
    void showPrint().catch(failed);
    void showTarget().catch(failed);
    showCut();
  };

  const listen = (keys: Parameters<typeof state.on>[0], call: () => void) => gone.addEventListener("abort", state.on(keys, call));
  listen(["threshold"], () => void showPrint().catch(failed));
  listen(["threshold", "at", "cut"], showCut);
  listen(["solid"], showAll);
  listen(["species"], () => {
    void volumesOf(context, chosen()).then(async (loaded) => {
      volumes = loaded.volumes;
      await load();
      showAll();
    }).catch(failed);
  });
  const extras = shown(context, stage, client, volumes.bodies);
  await load();
  showAll();

  const modes: [string, string][] = band === null && volumes.response ? [["print", "Print"], ["both", "Print and target"], ["target", "Target"]] : [["target", "Target"]];
  const farthest = reportOf(run, chosen()).evaluation?.farthest?.at_xyz_mm as Point | undefined;
  const view = (text: string, azimuth: number, elevation: number) => h("button", { type: "button", click: () => stage.look(azimuth, elevation) }, text);
  return h(
    "div.solid",
    {},
    ...problems.map((text) => h("p.problem", { role: "alert" }, text)),
    h("p.quiet", {}, "Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. The cut goes through the point that the planes above show."),
    h(
      "div.controls",
      {},
      modes.length > 1 && choice("Surface", modes, mode, (value) => state.set({ solid: value === modes[0][0] ? "" : value }), (call) => listen(["solid"], call)),
      choice("Cut", [["", "Whole"], ["x", "Cut along x"], ["y", "Cut along y"], ["z", "Cut along z"]], () => state.get("cut"), (cut) => state.set({ cut }), (call) => listen(["cut"], call)),
      h("span.views", {}, view("From the front", -60, 30), view("From behind, below", 120, -30), view("From above", -90, 89.9)),
      ...extras,
      farthest && farthest.length === 3 && h("button", { type: "button", click: () => state.set({ at: farthest }) }, "Cut at the largest deviation"),
    ),
    stage.canvas,
    h("div.below-planes", {}, note, legend),
  );
}

/** Checkboxes for what else there is: bodies and the vial. */
function shown({ run }: Context, stage: Stage, client: SurfaceClient, bodies: Volume | null): HTMLElement[] {
  const toggle = (text: string, checked: boolean, show: () => void, hide: () => void) => {
    const change = (event: Event) => ((event.target as HTMLInputElement).checked ? show() : hide());
    if (checked) show();
    return h("label", {}, h("input", { type: "checkbox", checked, change }), text);
  };
  const out: HTMLElement[] = [];
  const kinds: [number, string, string][] = [[BODY.insert, "insert", "--ink"], [BODY.dark, "bodies that stay dark", "--void"], [BODY.obstacle, "obstacles", "--quiet"]];
  for (const [code, text, color] of kinds) {
    if (!bodies?.codes.includes(code)) continue;
    const show = () => void client.ask({ kind: "part", samples: samplesOf(bodies), code }).then((mesh) => stage.mesh(text, mesh, { color: token(color), opacity: 0.75 }));
    out.push(toggle(text, true, show, () => stage.remove(text)));
  }
  const { scene } = run;
  if (scene && scene.walls.length > 0) {
    const [from, to] = scene.z_mm;
    const outlines = () => scene.walls.map(({ points, height_mm }) => ({ points, low: height_mm?.[0] ?? from, high: height_mm?.[1] ?? to }));
    out.push(toggle("vial", false, () => stage.walls("vial", outlines(), token("--quiet")), () => stage.remove("vial")));
  }
  return out;
}

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
  return ends.map((end) => end.map((index, axis) => volume.middle(axis as Axis, index)) as Point) as [Point, Point];
}

