// The doses of all runs in planes that move together, on one scale, and how each differs from that of the first run.

import { h } from "../../dom.ts";
import { difference, scalar, sameShape } from "../../layers.ts";
import { later, legendOf, trouble } from "../../controls.ts";
import { infoOf } from "../../volumes.ts";
import { Planes, type Shown } from "../../planes.ts";
import type { Context } from "../../section.ts";
import { Slices } from "../../slices.ts";
import type { Axis, Volume } from "../../volume.ts";
import { choice } from "../choice.ts";
import { paragraphs, part } from "../text.ts";

/** Differences have full color from this share of the largest dose. */
const FULL_COLOR = 0.2;

const PLANES = { "x–y": 2, "x–z": 1, "y–z": 0 } as const satisfies Record<string, Axis>;

interface Dose {
  name: string;
  volume: Volume;
  slices: Slices;
}

export function doses(context: Context): HTMLElement | null {
  const withDose = context.data.runs.filter((run) => infoOf(run, "response", ""));
  return withDose.length > 1 ? later(context, draw) : null;
}

async function draw(context: Context): Promise<HTMLElement> {
  const { state, gone } = context;
  let all: Planes[] = [];
  const unread = trouble();
  const came = (reason: string | null) => {
    if (reason === null) all.forEach((planes) => planes.redraw(true));
    else unread.say(reason);
  };
  const { read, problems } = await load(context, came);
  const [first, ...others] = read;
  if (!first || others.length === 0) throw new Error(problems[0] ?? "Fewer than two runs hold a dose.");
  const ends = { low: Math.min(...read.map(({ volume }) => volume.info.low)), high: Math.max(...read.map(({ volume }) => volume.info.high)) };
  const alike = others.filter(({ volume }) => isAlike(volume, first.volume));
  const unlike = others.filter((dose) => !alike.includes(dose));

  const alone = read.map(({ name, volume, slices }) => ({ title: name, layer: scalar(name, "Dose", volume, slices, null, ends) }));
  const compared = alike.map((dose) => ({
    title: dose.name,
    layer: difference(dose.volume, first.volume, eachOf(dose, first), FULL_COLOR * ends.high, dose.name, `dose − that of ${first.name}`),
  }));
  const place = h("div");
  let end = new AbortController();
  gone.addEventListener("abort", () => end.abort());
  const show = (axis: Axis) => {
    end.abort();
    end = new AbortController();
    const { signal } = end;
    const planesOf = (row: Omit<Shown, "axis">[]) => {
      const planes = new Planes({ state, grid: first.volume, signal });
      planes.show(row.map((one): Shown => ({ axis, ...one })));
      return planes;
    };
    all = [alone, compared].filter((row) => row.length > 0).map(planesOf);
    const [doses, differences] = all.map((planes) => h("div.runs-planes", { style: `--runs: ${read.length}` }, planes.element));
    place.replaceChildren(
      h("div", {}, doses, legendOf(alone[0].layer.legend())),
      differences ? part(`Difference to ${first.name}`, h("p.note", {}, "Red: a higher dose. Blue: a lower one."), differences, legendOf(compared[0].layer.legend())) : "",
    );
  };
  show(PLANES["x–y"]);
  const names = Object.keys(PLANES) as (keyof typeof PLANES)[];
  return h(
    "div",
    {},
    ...problems.map((text) => h("p.problem", { role: "alert" }, text)),
    ...paragraphs(["Written patterns, vial turning, on one scale. A click, a slider or an arrow key moves all planes."], "quiet"),
    ...unlike.map(({ name }) => h("p.note", {}, `No difference is drawn for ${name}: its voxels differ from those of ${first.name}.`)),
    choice("Plane", names, "x–y", (name) => show(PLANES[name])),
    unread.element,
    place,
  );
}

/** The doses that can be read, and why others cannot. */
async function load({ data, stores, gone }: Context, came: (reason: string | null) => void): Promise<{ read: Dose[]; problems: string[] }> {
  const problems: string[] = [];
  const one = async (i: number): Promise<Dose | null> => {
    const run = data.runs[i];
    const info = infoOf(run, "response", "");
    if (!info) return null;
    try {
      return { name: run.name, volume: await stores[i].volume(info), slices: new Slices(run, stores[i], gone, (reason) => came(reason && `${run.name}: ${reason}`)) };
    } catch (error) {
      problems.push(`${run.name}: ${error instanceof Error ? error.message : String(error)}`);
      return null;
    }
  };
  const read = await Promise.all(data.runs.map((_, i) => one(i)));
  return { read: read.filter((dose) => dose !== null), problems };
}

/** Whether two volumes have the same voxels at the same place. */
function isAlike(a: Volume, b: Volume): boolean {
  const isNear = (x: number, y: number) => Math.abs(x - y) < 1e-6;
  return sameShape(a, b) && a.pitch.every((edge, axis) => isNear(edge, b.pitch[axis])) && a.info.center_xyz_mm.every((mm, axis) => isNear(mm, b.info.center_xyz_mm[axis]));
}

/** Slices of two volumes of different runs. */
function eachOf(a: Dose, b: Dose): Pick<Slices, "of"> {
  return { of: (volume, axis, mm) => (volume === a.volume ? a : b).slices.of(volume, axis, mm) };
}
