// What a plane can show: dose, target, print and error, how a gray print differs from its target, times of cure, properties.
// A layer makes the pixels of a slice, says its value at a point, and has a legend.

import { significant } from "./report/number.ts";
import { deviation, faded, palette, place, type Scale, token, viridis } from "./paint.ts";
import type { Slices } from "./slices.ts";
import type { Volumes } from "./volumes.ts";
import { type Axis, BODY, LABEL, type Point, type Slice, type Volume } from "./volume.ts";

/** A slice as pixels. */
export type Picture = Pick<Slice, "width" | "height" | "pitch" | "corner"> & { pixels: Uint32Array<ArrayBuffer> };

export type Legend = { scale: Scale; label: string; mark: number | null } | { keys: [color: string, text: string][] };

export interface Layer {
  id: string;
  title: string;
  picture(axis: Axis, mm: number): Picture | null;
  /** The value at a point, for people. */
  value(point: Point): string;
  legend(): Legend;
}

/** Half width of the band of a gray target; null where the target is part and void. */
export type Band = number | null;

/** Differences of a gray print are colored up to this many half widths of its band. */
const REACH = 4;

/** All layers that these volumes allow; `threshold` is null where nothing says when the resin gels, as for a gray target. */
export function layersOf(volumes: Volumes, slices: Slices, threshold: (() => number) | null, band: Band): Layer[] {
  const { response, target } = volumes;
  const all: Layer[] = [];
  if (response) all.push(scalar("dose", capital(response.info.name), response, slices, threshold));
  if (target) all.push(band === null ? inside(target, slices) : scalar("target", "Target", target, slices, null));
  if (response && threshold) all.push(solid(response, volumes, slices, threshold));
  if (response && target && sameShape(response, target)) {
    if (threshold) all.push(fate(response, volumes, slices, (dose) => dose >= threshold()));
    else if (band !== null) all.push(difference(response, target, slices, REACH * band, "Error", `${response.info.name} − target`));
  }
  for (const volume of volumes.others) all.push(scalar(volume.info.id, nameOf(volume), volume, slices, null));
  return all;
}

export function sameShape(a: Volume, b: Volume): boolean {
  return a.shape.every((n, axis) => n === b.shape[axis]);
}

function nameOf(volume: Volume): string {
  const { name, species } = volume.info;
  const text = species === null ? name : `${name}, ${species}`;
  return capital(text);
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** Any volume in the colors of its values; `ends` are those of a scale that several volumes share. */
export function scalar(id: string, title: string, volume: Volume, slices: Pick<Slices, "of">, threshold: (() => number) | null, ends = { low: volume.info.low, high: volume.info.high }): Layer {
  const { info } = volume;
  // A logarithm needs a positive end
  const low = info.logarithmic ? Math.max(ends.low, ends.high * 1e-6) : info.kind === "response" ? Math.min(ends.low, 0) : ends.low;
  const scale: Scale = { low, high: ends.high, logarithmic: info.logarithmic && ends.high > 0, map: viridis };
  const unit = info.unit === "" ? "" : ` ${info.unit}`;
  // Its colors never change: the picture of a slice is made once
  const made = new WeakMap<Slice, Picture>();
  const picture = (slice: Slice) => {
    let known = made.get(slice);
    if (!known) made.set(slice, (known = mapped(slice, (values) => palette(values, scale))));
    return known;
  };
  return {
    id,
    title,
    picture: (axis, mm) => {
      const slice = slices.of(volume, axis, mm);
      return slice && picture(slice);
    },
    value: (point) => `${title.toLowerCase()} ${text(volume.at(point))}${unit}`,
    legend: () => ({ scale, label: info.unit === "" ? title : `${title}, ${info.unit}`, mark: threshold?.() ?? null }),
  };
}

/** The share of a voxel that is inside the part. */
function inside(target: Volume, slices: Slices): Layer {
  return {
    id: "target",
    title: "Target",
    picture: (axis, mm) => {
      const color = token("--solid");
      const slice = slices.of(target, axis, mm);
      return slice && mapped(slice, (values) => Uint32Array.from(values, (value) => faded(color, Math.min(Math.max(value, 0), 1))));
    },
    value: (point) => `target ${text(target.at(point))}`,
    legend: () => ({ keys: [["var(--solid)", "part"], ["var(--picture)", "to stay liquid"]] }),
  };
}

/** What is solid at the threshold. */
function solid(response: Volume, { bodies }: Volumes, slices: Slices, threshold: () => number): Layer {
  return {
    id: "print",
    title: "Print",
    picture: (axis, mm) => {
      const color = token("--solid");
      const level = threshold();
      const slice = slices.of(response, axis, mm);
      return slice && withBodies(mapped(slice, (values) => Uint32Array.from(values, (value) => (value >= level ? color : 0))), bodies, slices, axis, mm);
    },
    value: (point) => {
      const value = response.at(point);
      return value === null ? "print –" : value >= threshold() ? "print solid" : "print liquid";
    },
    legend: () => ({ keys: [["var(--solid)", "solid"], ["var(--picture)", "liquid"], ...bodyKeys(bodies)] }),
  };
}

/** Where print and target differ; a value of the volume says whether a voxel is solid. */
export function fate(volume: Volume, { target, labels, bodies }: Omit<Volumes, "response" | "others">, slices: Pick<Slices, "of">, isSolidAt: (value: number) => boolean): Layer {
  const isPart = (label: number | null, share: number | null) => (label === null ? (share ?? 0) >= 0.5 : label === LABEL.part);
  return {
    id: "error",
    title: "Error",
    picture: (axis, mm) => {
      const [own, share, label] = [volume, target, labels].map((volume) => volume && slices.of(volume, axis, mm));
      if (!own) return null;
      const solid = own.values.map((value) => Number(isSolidAt(value)));
      const [right, missing, excess, outside] = [faded(token("--solid"), 0.55), token("--missing"), token("--excess"), faded(token("--solid"), 0.2)];
      const pixels = new Uint32Array(own.codes.length);
      // A full slice of one volume may come before that of another
      const fits = (slice: Slice | null): slice is Slice => slice !== null && slice.width === own.width && slice.height === own.height;
      const [withShare, withLabel] = [fits(share) ? share : null, fits(label) ? label : null];
      for (let i = 0; i < pixels.length; i++) {
        const isSolid = solid[own.codes[i]] === 1;
        const code = withLabel ? withLabel.codes[i] : null;
        if (code === LABEL.outside) pixels[i] = isSolid ? outside : 0;
        else if (isPart(code, withShare ? withShare.values[withShare.codes[i]] : null)) pixels[i] = isSolid ? right : missing;
        else pixels[i] = isSolid ? excess : 0;
      }
      return withBodies({ ...own, pixels }, bodies, slices, axis, mm);
    },
    value: (point) => {
      const value = volume.at(point);
      const label = labels ? labels.at(point) : null;
      if (label === LABEL.outside) return "not counted";
      const isSolid = value !== null && isSolidAt(value);
      if (isPart(label, target ? target.at(point) : null)) return isSolid ? "solid, as it should" : "missing";
      return isSolid ? "too much" : "liquid, as it should";
    },
    legend: () => ({
      keys: [["color-mix(in srgb, var(--solid) 55%, var(--picture))", "solid, as it should"], ["var(--missing)", "missing"], ["var(--excess)", "too much"], ["var(--picture)", "liquid, as it should"], ...bodyKeys(bodies)],
    }),
  };
}

/** One volume less another of the same shape; colors reach from −`reach` to `reach`. */
export function difference(a: Volume, b: Volume, slices: Pick<Slices, "of">, reach: number, title: string, label: string): Layer {
  const scale: Scale = { low: -reach, high: reach, logarithmic: false, map: deviation };
  const steps = Uint32Array.from({ length: 256 }, (_, i) => deviation(i / 255));
  return {
    id: title.toLowerCase(),
    title,
    picture: (axis, mm) => {
      const [from, less] = [slices.of(a, axis, mm), slices.of(b, axis, mm)];
      if (!from || !less || from.codes.length !== less.codes.length) return null;
      const pixels = new Uint32Array(from.codes.length);
      for (let i = 0; i < pixels.length; i++) {
        const share = place(scale, from.values[from.codes[i]] - less.values[less.codes[i]]);
        pixels[i] = steps[Math.round(255 * Math.min(Math.max(share, 0), 1))];
      }
      return { ...from, pixels };
    },
    value: (point) => {
      const [from, less] = [a.at(point), b.at(point)];
      return `${label} ${text(from === null || less === null ? null : from - less)}`;
    },
    legend: () => ({ scale, label, mark: null }),
  };
}

function mapped(slice: Slice, paletteOf: (values: Float32Array) => Uint32Array): Picture {
  const { codes } = slice;
  const colors = paletteOf(slice.values);
  const pixels = new Uint32Array(codes.length);
  for (let i = 0; i < pixels.length; i++) pixels[i] = colors[codes[i]];
  return { ...slice, pixels };
}

export const BODIES: Record<number, { color: string; text: string }> = {
  [BODY.dark]: { color: "--void", text: "body that must stay dark" },
  [BODY.insert]: { color: "--ink", text: "insert" },
  [BODY.obstacle]: { color: "--quiet", text: "obstacle" },
};

/** What else than resin is at a point; null where there is none. */
export function bodyAt(bodies: Volume | null, point: Point): string | null {
  return BODIES[bodies?.at(point) ?? BODY.none]?.text ?? null;
}

function bodyKeys(bodies: Volume | null): [string, string][] {
  if (!bodies) return [];
  const present = new Set(bodies.codes);
  return Object.entries(BODIES).filter(([code]) => present.has(Number(code))).map(([, { color, text }]) => [`var(${color})`, text]);
}

export function withBodies(picture: Picture, bodies: Volume | null, slices: Pick<Slices, "of">, axis: Axis, mm: number): Picture {
  const slice = bodies && slices.of(bodies, axis, mm);
  if (!slice || slice.codes.length !== picture.pixels.length) return picture;
  const colors = Uint32Array.from({ length: 256 }, (_, code) => (BODIES[code] ? faded(token(BODIES[code].color), 0.75) : 0));
  slice.codes.forEach((code, i) => {
    if (colors[code] !== 0) picture.pixels[i] = colors[code];
  });
  return picture;
}

function text(value: number | null): string {
  return significant(value, 3);
}

