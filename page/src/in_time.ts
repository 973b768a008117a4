// How the print grows: what is solid at a moment, chosen with a slider, in three planes.

import type { VolumeInfo } from "./data.ts";
import { contour } from "./contour.ts";
import { h } from "./dom.ts";
import { choice, later, legendOf } from "./controls.ts";
import { infoOf } from "./volumes.ts";
import { bandOf } from "./gel.ts";
import { fate, type Layer, sameShape } from "./layers.ts";
import { palette, type Scale, viridis } from "./paint.ts";
import { type Outline, Planes } from "./planes.ts";
import { clock, significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import type { Axis, Volume } from "./volume.ts";

export const inTime: Section = {
  id: "in-time",
  title: "How the print grows",
  render: (context) => {
    const infos = context.run.volumes.filter(({ kind }) => kind === "cure_time");
    if (infos.length === 0) return null;
    let shown = 0;
    let end = new AbortController();
    const place = h("div");
    const pressed = new EventTarget();
    const show = (index: number) => {
      end.abort();
      end = new AbortController();
      shown = index;
      place.replaceChildren(later(context, () => draw(context, infos[index], end.signal)));
      pressed.dispatchEvent(new Event("change"));
    };
    context.gone.addEventListener("abort", () => end.abort());
    show(0);
    const names = infos.map(({ species, name }, i): [string, string] => [String(i), species ?? name]);
    return h("div", {}, names.length > 1 && choice("Resin", names, () => String(shown), (value) => show(Number(value)), (call) => pressed.addEventListener("change", call)), place);
  },
};

/** The whole growth is played in about so long, s. */
const PLAY_S = 10;
const STEPS = 500;

async function draw({ run, state, store }: Context, info: VolumeInfo, signal: AbortSignal): Promise<HTMLElement> {
  const volume = await store.volume(info);
  const volumeOf = async (kind: VolumeInfo["kind"]) => {
    const found = infoOf(run, kind, info.species ?? "");
    return found ? store.volume(found) : null;
  };
  // Without the target its outline and the error are missing, and nothing else
  const [target, labels, bodies] = await Promise.all((["target", "labels", "bodies"] as const).map((kind) => volumeOf(kind).catch(() => null)));
  const network = networkOf(run.report, info.species);
  const last = info.high;
  const best: number | null = network?.best_s ?? null;
  const time = () => Math.min(state.get("time") ?? best ?? last, last);
  const solid = solidVolume(volume);

  const scale: Scale = { low: Math.min(info.low, last), high: last, logarithmic: false, map: viridis };
  const growth: Layer = {
    id: "growth",
    title: "Time of cure",
    picture: (axis, mm) => {
      const slice = volume.slice(axis, mm);
      if (!slice) return null;
      const now = time();
      const colors = palette(slice.values, scale).map((color, code) => (slice.values[code] <= now ? color : 0));
      const pixels = new Uint32Array(slice.codes.length);
      for (let i = 0; i < pixels.length; i++) pixels[i] = colors[slice.codes[i]];
      return { ...slice, pixels };
    },
    value: (point) => {
      const at = volume.at(point);
      return at === null ? "stays liquid" : `solid after ${clock(at)}`;
    },
    legend: () => ({ scale, label: "solid after, s", mark: null }),
  };
  const asked = labels ?? target;
  const error = asked && sameShape(asked, volume) && bandOf(run) === null ? fate(volume, { target, labels, bodies }, { of: (one, axis, mm) => one.slice(axis, mm) }, (at) => at <= time()) : null;
  const layer = () => (error && state.get("growth") === error.id ? error : growth);
  const readout = h("p.readout");
  const legend = h("div.color-legend");
  const planes = new Planes({
    state,
    grid: volume,
    signal,
    hover: (point) => {
      readout.textContent = layer().value(point ?? planes.at());
    },
  });
  const outlines = (along: Axis, mm: number): Outline[] => {
    const slice = layer() === growth ? target?.slice(along, mm) : null;
    return slice ? [{ slice, segments: contour(slice, 0.5), color: "--outline-growth" }] : [];
  };
  const show = () => {
    planes.show(([2, 1, 0] as const).map((axis) => ({ axis, layer: layer(), outlines })));
    legend.replaceChildren(legendOf(layer().legend()));
  };
  show();

  const slider = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": "Time", input: () => state.set({ time: (Number(slider.value) / STEPS) * last }) });
  const text = h("output");
  const update = () => {
    const now = time();
    slider.value = String(Math.round((now / last) * STEPS));
    slider.setAttribute("aria-valuetext", clock(now));
    const iou = at(network?.curves?.seconds, network?.curves?.jaccard, now);
    text.replaceChildren(h("b", {}, clock(now)), `  ${significant(solid(now), 3)} mm³ solid${iou === null ? "" : `, IoU ${significant(iou, 3)}`}`);
    planes.redraw(true);
    readout.textContent = layer().value(planes.at());
  };
  const ends = [state.on(["time", "at"], update), state.on(["growth"], () => [show(), update()])];
  const play = h("button", { type: "button" }, "Play");
  let timer = 0;
  const stop = () => {
    window.clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  };
  play.addEventListener("click", () => {
    if (timer !== 0) return stop();
    play.textContent = "Pause";
    if (time() >= last) state.set({ time: 0 });
    timer = window.setInterval(() => {
      state.set({ time: Math.min(time() + (0.05 / PLAY_S) * last, last) });
      if (time() >= last) stop();
    }, 50);
  });
  signal.addEventListener("abort", () => {
    ends.forEach((end) => end());
    stop();
  });
  update();
  return h(
    "div",
    {},
    h("p.quiet", {}, `What is solid at a moment, colored by when it became solid. The line is the part’s outline.${error ? " The error shows what is missing and what is too much at that moment." : ""}`),
    error && choice("Shown", [["", growth.title], [error.id, error.title]], () => state.get("growth"), (id) => state.set({ growth: id }), (call) => signal.addEventListener("abort", state.on(["growth"], call))),
    h("div.time-controls", {}, play, slider, text, best !== null && h("button", { type: "button", click: () => state.set({ time: null }) }, `Best moment: ${clock(best)}`)),
    planes.element,
    h("div.below-planes", {}, readout, legend),
  );
}

/** What the report says of a network; of the first where the run has one. */
function networkOf(report: Context["run"]["report"], name: string | null) {
  const networks = (report?.time ?? []) as { name: string; best_s: number | null; curves?: { seconds?: number[]; jaccard?: (number | null)[] } }[];
  return networks.find((network) => network.name === name) ?? networks[0] ?? null;
}

/** The volume that is solid by a time, mm³; counted once by code. */
function solidVolume(volume: Volume): (seconds: number) => number {
  const counts = new Float64Array(volume.values.length);
  for (const code of volume.codes) counts[code]++;
  const voxel = volume.pitch[0] * volume.pitch[1] * volume.pitch[2];
  return (seconds) => voxel * counts.reduce((sum, count, code) => (volume.values[code] <= seconds ? sum + count : sum), 0);
}

/** The value of a curve at its last point not after x. */
function at(xs: number[] | undefined, ys: (number | null)[] | undefined, x: number): number | null {
  if (!xs || !ys) return null;
  let i = xs.findIndex((value) => value > x + 1e-9);
  if (i < 0) i = xs.length;
  return i === 0 ? null : (ys[i - 1] ?? null);
}
