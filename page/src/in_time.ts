// How the print grows: what is solid at a moment, chosen with a slider, in three planes.

import type { VolumeInfo } from "./data.ts";
import { contour } from "./contour.ts";
import { h } from "./dom.ts";
import { choice, later, legendOf } from "./controls.ts";
import { infoOf } from "./volumes.ts";
import type { Layer } from "./layers.ts";
import { palette, type Scale, viridis } from "./paint.ts";
import { Planes } from "./planes.ts";
import { clock, significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import type { Volume } from "./volume.ts";

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
  const targetInfo = infoOf(run, "target", info.species ?? "");
  // Without the target its outline is missing, and nothing else
  const target = targetInfo ? await store.volume(targetInfo).catch(() => null) : null;
  const network = networkOf(run.report, info.species);
  const last = info.high;
  const best: number | null = network?.best_s ?? null;
  const time = () => Math.min(state.get("time") ?? best ?? last, last);
  const solid = solidVolume(volume);

  const scale: Scale = { low: Math.min(info.low, last), high: last, logarithmic: false, map: viridis };
  const layer: Layer = {
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
  const readout = h("p.readout");
  const planes = new Planes({
    state,
    grid: volume,
    signal,
    hover: (point) => {
      readout.textContent = layer.value(point ?? planes.at());
    },
  });
  planes.show(
    ([2, 1, 0] as const).map((axis) => ({
      axis,
      layer,
      outlines: (along, mm) => {
        const slice = target?.slice(along, mm);
        return slice ? [{ slice, segments: contour(slice, 0.5), color: "--outline-growth" }] : [];
      },
    })),
  );

  const slider = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": "Time", input: () => state.set({ time: (Number(slider.value) / STEPS) * last }) });
  const text = h("output");
  const update = () => {
    const now = time();
    slider.value = String(Math.round((now / last) * STEPS));
    slider.setAttribute("aria-valuetext", clock(now));
    const jaccard = at(network?.curves?.seconds, network?.curves?.jaccard, now);
    text.replaceChildren(h("b", {}, clock(now)), `  ${significant(solid(now), 3)} mm³ solid${jaccard === null ? "" : `, Jaccard index ${significant(jaccard, 3)}`}`);
    planes.redraw(true);
    readout.textContent = layer.value(planes.at());
  };
  const end = state.on(["time", "at"], update);
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
    end();
    stop();
  });
  update();
  return h(
    "div",
    {},
    h("p.quiet", {}, "What is solid at a moment, colored by when it became solid. The line is the part’s outline."),
    h("div.time-controls", {}, play, slider, text, best !== null && h("button", { type: "button", click: () => state.set({ time: null }) }, `Best moment: ${clock(best)}`)),
    planes.element,
    h("div.below-planes", {}, readout, legendOf(layer.legend())),
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
