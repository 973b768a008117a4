// The section in which a print is looked at: three linked planes and the threshold.

import { contour } from "./contour.ts";
import { choice, later, legendOf, problem, toggle, trouble } from "./controls.ts";
import { h } from "./dom.ts";
import { bandOf, type Gel, gelOf } from "./gel.ts";
import { bodyAt, type Layer, layersOf } from "./layers.ts";
import { millimeters, type Outline, Planes, type Shown } from "./planes.ts";
import type { Context, Section } from "./section.ts";
import { Slices } from "./slices.ts";
import type { Key } from "./state.ts";
import { thresholdPanel } from "./threshold.ts";
import { type Axis, AXES, type Point, type Slice, type Volume } from "./volume.ts";
import { chosenSpecies, speciesOf, type Volumes, volumesOf } from "./volumes.ts";

export const look: Section = {
  id: "look",
  title: "Slice by slice",
  render: (context) => (context.run.volumes.some(({ kind }) => kind === "response" || kind === "target") ? later(context, draw) : null),
};

async function draw(context: Context): Promise<HTMLElement> {
  const { run, state, gone } = context;
  const place = h("div.look-place");
  let end = new AbortController();
  let last: Look | null = null;
  const show = async () => {
    const own = new AbortController();
    const before = end;
    end = own;
    const { volumes, problems } = await volumesOf(context, chosenSpecies(context));
    before.abort();
    if (own.signal.aborted) return;
    const grid = volumes.response ?? volumes.target;
    const focused = place.contains(document.activeElement) ? (document.activeElement?.getAttribute("aria-label") ?? null) : null;
    last = grid && new Look(context, volumes, grid, last, own.signal);
    place.replaceChildren(...problems.map(problem), ...(last ? last.elements() : []));
    if (focused !== null) place.querySelector<HTMLElement>(`[aria-label="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
  };
  const unlisten = state.on(["species"], () => void show());
  context.renewed.addEventListener("renewed", () => void show(), { signal: gone });
  gone.addEventListener("abort", () => {
    unlisten();
    end.abort();
  });
  await show();
  const names = speciesOf(run);
  return h("div", {}, names.length > 1 && speciesChoice(context, names), place);
}

/** Which of several species is shown. Each has a threshold of its own. */
function speciesChoice(context: Context, names: string[]): HTMLElement {
  const { state, gone } = context;
  const options = names.map((name): [string, string] => [name, name]);
  return choice("Species", options, () => chosenSpecies(context) || names[0], (species) => state.set({ species, threshold: null }), (call) => gone.addEventListener("abort", state.on(["species"], call)));
}

/** The layer that stands for the first four side by side. */
const ALL = "all";

/** Lines would hide thin errors, and a shape needs no line around itself. */
const WITHOUT = { part: ["target", "error"], print: ["print", "error"] };

/** Planes of the volumes of a species, with layers, outlines, legend and threshold. */
class Look {
  private readonly gel: Gel | null;
  private readonly slices: Slices;
  private readonly layers: Layer[];
  private readonly planes: Planes;
  private readonly readout = h("p.readout");
  private readonly legend = h("div.color-legend");
  private readonly trouble = trouble();
  /** What can be outlined, and whose outline the reader has hidden. */
  private readonly outlined: { part: boolean; print: boolean };
  private readonly hidden: Set<"part" | "print">;

  constructor(
    private readonly context: Context,
    private readonly volumes: Volumes,
    private readonly grid: Volume,
    /** What was shown before: its lines and its zoom are kept. */
    before: Look | null,
    private readonly signal: AbortSignal,
  ) {
    const { run, state, store } = context;
    const band = bandOf(run);
    this.gel = band === null ? gelOf(run, chosenSpecies(context), volumes.response, volumes.labels) : null;
    this.hidden = before?.hidden ?? new Set();
    this.outlined = { part: volumes.target !== null && band === null, print: this.gel !== null && volumes.response !== null };
    this.slices = new Slices(run, store, signal, (reason) => {
      this.trouble.say(reason);
      if (reason === null) this.planes.redraw(true);
    });
    this.layers = layersOf(volumes, this.slices, this.gel && (() => this.threshold), band);
    this.planes = new Planes({ state, grid: this.slices.gridOf(grid), signal, hover: (point) => this.read(point ?? this.planes.at()) });
    if (before) [this.planes.zoom, this.planes.center] = [before.planes.zoom, before.planes.center];
  }

  elements(): HTMLElement[] {
    const { context, gel, grid, planes, signal } = this;
    const controls = this.controls();
    this.listen(["threshold"], () => {
      planes.redraw(true);
      this.showLegend();
    });
    this.listen(["layer", "plane"], () => this.arrange());
    this.listen(["threshold", "at", "layer"], () => this.read(planes.at()));
    this.arrange();
    this.read(planes.at());
    const reduced = grid.info.reduced > 1 && !grid.info.full ? ` Each voxel shown is the mean of ${grid.info.reduced}³ of the ${context.run.report ? "evaluation" : "optimization"}.` : "";
    return [
      h("p.quiet", {}, `Click to move the cut; drag the sliders, or choose a plane and press the arrow keys or turn the wheel. Double-click, + and − zoom, 0 shows all again.${reduced}`),
      controls,
      planes.element,
      this.trouble.element,
      h("div.below-planes", {}, this.readout, this.legend),
      ...(gel ? [thresholdPanel(gel, context.state, signal)] : []),
    ];
  }

  private get threshold(): number {
    return this.context.state.get("threshold") ?? this.gel?.reported ?? Number.POSITIVE_INFINITY;
  }

  /** The layers that are shown: all of them in one plane, or one in three planes. */
  private get shown(): Layer[] {
    const id = this.context.state.get("layer");
    return id === ALL ? this.layers.slice(0, 4) : [this.layers.find((layer) => layer.id === id) ?? this.layers[0]];
  }

  private get isAll(): boolean {
    return this.context.state.get("layer") === ALL;
  }

  private arrange(): void {
    const { shown } = this;
    const plane = this.context.state.get("plane");
    const along: Axis = plane === "x" ? 0 : plane === "y" ? 1 : 2;
    const planes = this.isAll
      ? shown.map((layer): Shown => ({ axis: along, layer, title: layer.title, outlines: this.outlines(layer) }))
      : ([2, 1, 0] as const).map((each): Shown => ({ axis: each, layer: shown[0], outlines: this.outlines(shown[0]) }));
    this.planes.show(planes);
    this.showLegend();
  }

  private showLegend(): void {
    this.legend.replaceChildren(...this.shown.map((layer) => legendOf(layer.legend())));
  }

  /** Says what the voxel under a point is, by its middle, as the planes name theirs. */
  private read(under: Point): void {
    const { grid } = this.planes.options;
    const point = grid.middleAt(under);
    const place = point.map((mm, axis) => `${AXES[axis]} ${millimeters(mm, grid.pitch[axis])}`).join(", ");
    const body = bodyAt(this.volumes.bodies, point);
    this.readout.textContent = [`${place} mm`, ...this.layers.map((layer) => layer.value(point)), ...(body === null ? [] : [body])].join("  ·  ");
  }

  private outlines(layer: Layer): (axis: Axis, mm: number) => Outline[] {
    const { target, response } = this.volumes;
    const has = (name: "part" | "print") => this.outlined[name] && !this.hidden.has(name) && !WITHOUT[name].includes(layer.id);
    const of = (volume: Volume | null, level: number, color: string, axis: Axis, mm: number): Outline[] => {
      const slice = volume && this.slices.of(volume, axis, mm);
      return slice ? [{ slice, segments: lines(slice, level), color }] : [];
    };
    return (axis, mm) => [
      ...(has("part") ? of(target, 0.5, "--outline-part", axis, mm) : []),
      ...(has("print") ? of(response, this.threshold, "--threshold-line", axis, mm) : []),
    ];
  }

  private controls(): HTMLElement {
    const { layers } = this;
    const { state } = this.context;
    const options = layers.map(({ id, title }): [string, string] => [id, title]);
    if (layers.length > 1) options.push([ALL, "Side by side"]);
    const current = () => (this.isAll ? ALL : this.shown[0].id);
    const choose = (layer: string) => state.set({ layer: layer === layers[0].id ? "" : layer });
    const planes = choice("Plane", [["", "x–y"], ["y", "x–z"], ["x", "y–z"]], () => state.get("plane"), (plane) => state.set({ plane }), (call) => this.listen(["plane"], call));
    const outline = (name: "part" | "print", color: string) => {
      if (!this.outlined[name]) return null;
      const changed = (checked: boolean) => {
        if (checked) this.hidden.delete(name);
        else this.hidden.add(name);
        this.planes.redraw(true);
      };
      return toggle(`outline of the ${name}`, !this.hidden.has(name), changed, h("i.stroke", { style: `background: var(${color})` }));
    };
    const [part, print] = [outline("part", "--outline-part"), outline("print", "--threshold-line")];
    const fit = () => {
      planes.hidden = !this.isAll;
      if (part) part.hidden = !this.isAll && WITHOUT.part.includes(this.shown[0].id);
      if (print) print.hidden = !this.isAll && WITHOUT.print.includes(this.shown[0].id);
    };
    this.listen(["layer"], fit);
    fit();
    return h("div.controls", {}, options.length > 1 && choice("Shown", options, current, choose, (call) => this.listen(["layer"], call)), planes, part, print);
  }

  private listen(keys: readonly Key[], call: () => void): void {
    this.signal.addEventListener("abort", this.context.state.on(keys, call));
  }
}

/** Contours of a slice at the last level: moving the threshold leaves the part's outline as it is. */
const drawn = new WeakMap<Slice, { level: number; segments: Float32Array }>();

function lines(slice: Slice, level: number): Float32Array {
  let known = drawn.get(slice);
  if (known?.level !== level) drawn.set(slice, (known = { level, segments: contour(slice, level) }));
  return known.segments;
}

