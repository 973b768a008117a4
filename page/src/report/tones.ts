// Gray targets: the response of the voxels of each gray value, against what was asked for.

import { h } from "../dom.ts";
import { later } from "../controls.ts";
import { infoOf } from "../volumes.ts";
import type { Context } from "../section.ts";
import { LABEL, type Volume } from "../volume.ts";
import { chart, type Series } from "./chart.ts";

/** Bins of the gray value from 0 to 1. */
const TONES = 32;

interface Tone {
  gray: number;
  mean: number;
  deviation: number;
}

/** The curve, once the volumes are unpacked; null where the page does not hold them. */
export function tones(context: Context): HTMLElement | null {
  const [response, target, labels] = (["response", "target", "labels"] as const).map((kind) => infoOf(context.run, kind, ""));
  if (!response || !target) return null;
  return later(context, async ({ store }) => {
    const read = await Promise.all([response, target, ...(labels ? [labels] : [])].map((info) => store.volume(info)));
    const [dose, gray, label] = read;
    return drawn(tonesOf(dose, gray, label ?? null));
  });
}

/** Mean and standard deviation of the response per gray value, over voxels that count. */
export function tonesOf(response: Volume, target: Volume, labels: Volume | null): Tone[] {
  const [count, sum, squares] = [0, 1, 2].map(() => new Float64Array(TONES));
  const voxels = Math.min(response.codes.length, target.codes.length);
  for (let i = 0; i < voxels; i++) {
    if (labels && labels.codes[i] === LABEL.outside) continue;
    const [value, gray] = [response.values[response.codes[i]], target.values[target.codes[i]]];
    if (Number.isNaN(value) || Number.isNaN(gray)) continue;
    const tone = Math.min(Math.max(Math.floor(gray * TONES), 0), TONES - 1);
    count[tone]++;
    sum[tone] += value;
    squares[tone] += value * value;
  }
  return [...count.keys()]
    .filter((tone) => count[tone] > 0)
    .map((tone) => {
      const mean = sum[tone] / count[tone];
      return { gray: (tone + 0.5) / TONES, mean, deviation: Math.sqrt(Math.max(squares[tone] / count[tone] - mean * mean, 0)) };
    });
}

function drawn(all: Tone[]): HTMLElement {
  const x = all.map(({ gray }) => gray);
  const edge = (sign: number, quiet: boolean): Series => ({
    name: "± one standard deviation",
    color: "--void",
    x,
    y: all.map(({ mean, deviation }) => mean + sign * deviation),
    quiet,
  });
  const plot = chart({
    title: "Response against gray value",
    x: { label: "gray value of the target", from: 0, to: 1 },
    y: { label: "response", from: 0 },
    series: [
      { name: "mean", color: "--accent", x, y: all.map(({ mean }) => mean) },
      edge(1, false),
      edge(-1, true),
      { name: "asked for", color: "--ink", style: "dashed", x: [0, 1], y: [0, 1] },
    ],
  });
  return plot ?? h("p.note", {}, "No voxel counts.");
}
