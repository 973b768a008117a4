// The section in which a print is looked at: three linked planes and the threshold.

import type { Run, VolumeInfo, VolumeKind } from "./data.ts";
import { contour } from "./contour.ts";
import { h } from "./dom.ts";
import { bandOf, gelOf } from "./gel.ts";
import { type Layer, layersOf, type Legend, type Volumes } from "./layers.ts";
import { css } from "./paint.ts";
import { millimeters, type Outline, Planes, type Shown } from "./planes.ts";
import { significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import { Slices } from "./slices.ts";
import { thresholdPanel } from "./threshold.ts";
import { type Axis, AXES, type Point, type Slice, type Volume } from "./volume.ts";

export const look: Section = {
  id: "look",
  title: "Slice by slice",
  render: (context) => (context.run.volumes.some(({ kind }) => kind === "response" || kind === "target") ? later(context, draw) : null),
};

/** The layer that stands for all layers side by side. */
const ALL = "all";

/** Draws when the arrays are there, and says what is wrong where they are not. */
export function later(context: Context, make: (context: Context) => Promise<HTMLElement>): HTMLElement {
  const place = h("div", { "aria-busy": "true" }, h("p.quiet", {}, "Unpacking the volumes…"));
  make(context)
    .then((element) => place.replaceChildren(element))
    .catch((error: unknown) => place.replaceChildren(h("p.problem", { role: "alert" }, error instanceof Error ? error.message : String(error))))
    .finally(() => place.removeAttribute("aria-busy"));
  return place;
}

/** The volume of a kind, of a species ("" for the first). */
export function infoOf(run: Run, kind: VolumeKind, species: string): VolumeInfo | undefined {
  const ofKind = run.volumes.filter((info) => info.kind === kind);
  return ofKind.find((info) => species !== "" && info.species === species) ?? ofKind[0];
}

/** Species that have a dose of their own. */
export function speciesOf(run: Run): string[] {
  return run.volumes.filter(({ kind, species }) => kind === "response" && species !== null).map(({ species }) => species ?? "");
}

/** The volumes of a species, and what could not be read. */
export async function volumesOf(context: Context, species: string): Promise<{ volumes: Volumes; problems: string[] }> {
  const { run, store } = context;
  const problems: string[] = [];
  const load = async (info: VolumeInfo | undefined): Promise<Volume | null> => {
    if (!info) return null;
    try {
      return await store.volume(info);
    } catch (error) {
      problems.push(error instanceof Error ? error.message : String(error));
      return null;
    }
  };
  const one = (kind: VolumeKind) => load(infoOf(run, kind, species));
  const others = run.volumes.filter(({ kind }) => kind === "cure_time" || kind === "property");
  const [response, target, labels, bodies, ...rest] = await Promise.all([one("response"), one("target"), one("labels"), one("bodies"), ...others.map(load)]);
  return { volumes: { response, target, labels, bodies, others: rest.filter((volume) => volume !== null) }, problems };
}

async function draw(context: Context): Promise<HTMLElement> {
  const { run, state, gone } = context;
  const names = speciesOf(run);
  const place = h("div");
  let end = new AbortController();
  const show = async () => {
    end.abort();
    end = new AbortController();
    const ofSpecies = end;
    const species = names.includes(state.get("species")) ? state.get("species") : "";
    const { volumes, problems } = await volumesOf(context, species);
    if (ofSpecies.signal.aborted) return;
    place.replaceChildren(...problems.map((text) => h("p.problem", { role: "alert" }, text)), ...body(context, volumes, species, ofSpecies.signal));
  };
  const unlisten = state.on(["species"], () => void show());
  gone.addEventListener("abort", () => {
    unlisten();
    end.abort();
  });
  await show();
  return h("div", {}, names.length > 1 && speciesChoice(context, names), place);
}

/** Which of several species is shown. */
export function speciesChoice({ state, gone }: Context, names: string[]): HTMLElement {
  const current = () => (names.includes(state.get("species")) ? state.get("species") : names[0]);
  return choice("Species", names.map((name) => [name, name]), current, (species) => state.set({ species, threshold: null }), (call) => gone.addEventListener("abort", state.on(["species"], call)));
}

/** A bar of buttons of which one is pressed. */
export function choice(label: string, options: [value: string, text: string][], current: () => string, choose: (value: string) => void, listen: (call: () => void) => void): HTMLElement {
  const buttons = options.map(([value, text]) => ({ value, button: h("button", { type: "button", click: () => choose(value) }, text) }));
  const press = () => buttons.forEach(({ value, button }) => button.setAttribute("aria-pressed", String(value === current())));
  listen(press);
  press();
  return h("div.choice", { role: "group", "aria-label": label }, ...buttons.map(({ button }) => button));
}

function body(context: Context, volumes: Volumes, species: string, signal: AbortSignal): HTMLElement[] {
  const { run, state, store } = context;
  const grid = volumes.response ?? volumes.target;
  if (!grid) return [];
  const band = bandOf(run);
  const gel = band === null ? gelOf(run, species, volumes.response, volumes.labels) : null;
  const threshold = () => state.get("threshold") ?? gel?.reported ?? Number.POSITIVE_INFINITY;

  let planes: Planes | null = null;
  const slices = new Slices(run, store, signal, () => planes?.redraw(true));
  const layers = layersOf(volumes, slices, gel && threshold, band);
  const readout = h("p.readout", { "aria-live": "off" });
  const readAt = (point: Point) => {
    const place = point.map((mm, axis) => `${AXES[axis]} ${millimeters(mm)}`).join(", ");
    readout.textContent = `${place} mm  ·  ${layers.map((layer) => layer.value(point)).join("  ·  ")}`;
  };
  planes = new Planes({ state, grid: slices.gridOf(grid), signal, hover: (point) => readAt(point ?? planes!.at()) });

  const overlays = { part: true, print: gel !== null };
  const outlines = (layer: Layer) => (axis: Axis, mm: number): Outline[] => {
    const out: Outline[] = [];
    const add = (volume: Volume | null, level: number, color: string) => {
      const slice = volume && slices.of(volume, axis, mm);
      if (slice && Number.isFinite(level)) out.push({ slice, segments: lines(slice, level), color });
    };
    if (overlays.part && !["target", "error"].includes(layer.id) && band === null) add(volumes.target, 0.5, "--outline-part");
    if (overlays.print && !["print", "error"].includes(layer.id) && gel) add(volumes.response, threshold(), "--threshold-line");
    return out;
  };
  const legend = h("div.color-legend");
  const find = () => layers.find(({ id }) => id === state.get("layer")) ?? layers[0];
  let axisOfAll: Axis = 2;
  const rearrange = () => {
    const isAll = state.get("layer") === ALL;
    const shown: Shown[] = isAll
      ? layers.slice(0, 4).map((layer) => ({ axis: axisOfAll, layer, title: layer.title, outlines: outlines(layer) }))
      : ([2, 1, 0] as const).map((axis) => ({ axis, layer: find(), outlines: outlines(find()) }));
    planes!.show(shown);
    axes.hidden = !isAll;
    // Lines would hide thin errors, and a shape needs no line around itself
    if (toggles.part) toggles.part.hidden = !isAll && ["target", "error"].includes(find().id);
    if (toggles.print) toggles.print.hidden = !isAll && ["print", "error"].includes(find().id);
    drawLegend();
  };
  const drawLegend = () => legend.replaceChildren(...(state.get("layer") === ALL ? layers.slice(0, 4) : [find()]).map((layer) => legendOf(layer.legend())));

  const listen = (keys: Parameters<typeof state.on>[0]) => (call: () => void) => signal.addEventListener("abort", state.on(keys, call));
  const options = layers.map(({ id, title }): [string, string] => [id, title]);
  if (layers.length > 1) options.push([ALL, "Side by side"]);
  const pressAxis = new EventTarget();
  const axes = choice("Plane", [["2", "x–y"], ["1", "x–z"], ["0", "y–z"]], () => String(axisOfAll), (value) => {
    axisOfAll = Number(value) as Axis;
    rearrange();
    pressAxis.dispatchEvent(new Event("change"));
  }, (call) => pressAxis.addEventListener("change", call, { signal }));
  const toggle = (name: keyof typeof overlays, text: string, color: string) =>
    h("label", {}, h("input", { type: "checkbox", checked: overlays[name], change: (event: Event) => {
      overlays[name] = (event.target as HTMLInputElement).checked;
      planes!.redraw(true);
    } }), h("i.stroke", { style: `background: var(${color})` }), text);

  const toggles = {
    part: volumes.target && band === null ? toggle("part", "outline of the part", "--outline-part") : null,
    print: gel && volumes.response ? toggle("print", "outline of the print", "--threshold-line") : null,
  };

  listen(["threshold"])(() => {
    planes!.redraw(true);
    drawLegend();
  });
  listen(["layer"])(rearrange);
  listen(["threshold", "at", "layer"])(() => readAt(planes!.at()));
  rearrange();
  readAt(planes.at());

  const reduced = grid.info.reduced > 1 && !grid.info.full ? ` Each voxel shown is the mean of ${grid.info.reduced}³ of the evaluation.` : "";
  return [
    h("p.quiet", {}, `Click to move the cut; drag the sliders, or choose a plane and press the arrow keys or turn the wheel. Double-click, + and − zoom, 0 shows all again.${reduced}`),
    h(
      "div.controls",
      {},
      options.length > 1 && choice("Shown", options, () => (state.get("layer") === ALL ? ALL : find().id), (layer) => state.set({ layer: layer === layers[0].id ? "" : layer }), listen(["layer"])),
      axes,
      toggles.part,
      toggles.print,
    ),
    planes.element,
    h("div.below-planes", {}, readout, legend),
    ...(gel ? [thresholdPanel(gel, state, signal)] : []),
  ];
}

/** Contours of a slice at the last level: moving the threshold leaves the part's outline as it is. */
const drawn = new WeakMap<Slice, { level: number; segments: Float32Array }>();

function lines(slice: Slice, level: number): Float32Array {
  let known = drawn.get(slice);
  if (known?.level !== level) drawn.set(slice, (known = { level, segments: contour(slice, level) }));
  return known.segments;
}

/** Colors and what they mean. */
export function legendOf(legend: Legend): HTMLElement {
  if ("keys" in legend) return h("p.color-keys", {}, ...legend.keys.map(([color, text]) => h("span", {}, h("i.tile", { style: `background: ${color}` }), text)));
  const { scale, label, mark } = legend;
  const stops = Array.from({ length: 17 }, (_, i) => css(scale.map(i / 16))).join(", ");
  const share = mark === null || !Number.isFinite(mark) ? null : (mark - scale.low) / (scale.high - scale.low);
  return h(
    "div.color-scale",
    {},
    h("span", {}, significant(scale.low, 3)),
    h("span.bar", { style: `background: linear-gradient(to right, ${stops})` }, share !== null && share >= 0 && share <= 1 && h("i", { style: `left: ${100 * share}%`, title: "gel threshold" })),
    h("span", {}, significant(scale.high, 3)),
    h("span.quiet", {}, scale.logarithmic ? `${label}, logarithmic` : label),
  );
}
