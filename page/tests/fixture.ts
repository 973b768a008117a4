// A small run made here: a disc of 1 mm, a dose that fades over its edge, and a few patterns. No Rust is needed.

import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";
import type { FilmInfo, PageData, Run, VolumeInfo } from "../src/data.ts";
import { LABEL } from "../src/volume.ts";

/** The folder of the built page and tests: this file is part of a test that lies there. */
export const OUT = dirname(fileURLToPath(import.meta.url));

const [NX, NY, NZ] = [40, 40, 16];
const PITCH = 0.08;
export const THRESHOLD = 0.5;
const RADIUS_MM = 1;
const HALF_HEIGHT_MM = 0.45;

export interface Fixture {
  data: PageData;
  /** Bytes of each array, by the id of its element. */
  blobs: Map<string, Uint8Array>;
}

/** Distance to the disc's surface, mm, below 0 inside; by voxel. */
function outside(i: number): number {
  const at = (index: number, n: number) => (index - (n - 1) / 2) * PITCH;
  const [x, y, z] = [at(i % NX, NX), at(Math.floor(i / NX) % NY, NY), at(Math.floor(i / NX / NY), NZ)];
  return Math.max(Math.hypot(x, y) - RADIUS_MM, Math.abs(z) - HALF_HEIGHT_MM);
}

/** The dose is a little too large on one side, so that the print is not perfect. */
function dose(i: number): number {
  const right = i % NX > NX / 2 ? 0.06 : 0;
  return 1 / (1 + Math.exp((outside(i) - right) / 0.1));
}

function volume(id: string, kind: VolumeInfo["kind"], codes: Uint8Array, change: Partial<VolumeInfo> = {}): { info: VolumeInfo; codes: Uint8Array } {
  const info: VolumeInfo = {
    id, kind, species: null, name: kind, unit: "", shape_zyx: [NZ, NY, NX], pitch_mm: PITCH, height_mm: PITCH, center_xyz_mm: [0, 0, 0],
    bits: 8, low: 0, high: 1, nan: null, logarithmic: false, reduced: 1, full: false, ...change,
  };
  return { info, codes };
}

/** The page of a finished run. */
export function fixture(): Fixture {
  const voxels = Array.from({ length: NX * NY * NZ }, (_, i) => i);
  const code = (share: number) => Math.round(255 * Math.min(Math.max(share, 0), 1));
  const isPart = voxels.map((i) => outside(i) <= 0);
  const isSolid = voxels.map((i) => Math.fround(dose(i)) >= THRESHOLD);
  const both = voxels.filter((i) => isPart[i] && isSolid[i]).length;
  const either = voxels.filter((i) => isPart[i] || isSolid[i]).length;
  const volumes = [
    volume("target0", "target", Uint8Array.from(voxels, (i) => code(0.5 - outside(i) / PITCH)), { name: "target" }),
    volume("labels1", "labels", Uint8Array.from(voxels, (i) => (isPart[i] ? LABEL.part : LABEL.void)), { high: 255 }),
    volume("response2", "response", Uint8Array.from(voxels, (i) => code(dose(i))), { name: "dose" }),
    volume("cure_time3", "cure_time", Uint8Array.from(voxels, (i) => (dose(i) > 0.2 ? Math.round(254 * (1 - dose(i))) : 255)), { name: "time of cure", unit: "s", low: 10, high: 60, nan: 255 }),
    volume("property4", "property", Uint8Array.from(voxels, (i) => (isSolid[i] ? code(dose(i)) : 255)), { name: "modulus", unit: "MPa", low: 1, high: 900, nan: 255, logarithmic: true }),
  ];
  const film: FilmInfo = {
    id: "film0", light: "", frames: 12, rows: 10, columns: 16, of: [12, 10, 16], every: 1, binned: 1, angles_deg: Array.from({ length: 12 }, (_, k) => 30 * k), full_scale: 2, pitch_mm: [0.2, 0.2],
  };
  const values = Uint8Array.from({ length: film.frames * film.rows * film.columns }, (_, i) => (Math.floor(i / film.columns / film.rows) * 20 + (i % film.columns) * 3) & 255);
  const voxel = PITCH ** 3;
  const evaluation = {
    gel_threshold: THRESHOLD, best_threshold: THRESHOLD, iou: both / either, band_half_width: null, pw: -0.1, ver: 0.02, errors: null, iou_curve: null, histogram: null, notes: [],
    over_mm3: voxels.filter((i) => !isPart[i] && isSolid[i]).length * voxel, under_mm3: voxels.filter((i) => isPart[i] && !isSolid[i]).length * voxel,
    grid: { shape_zyx: [NZ, NY, NX], pitch_mm: PITCH, center_xyz_mm: [0, 0, 0] },
  };
  const edge = { low: 0.45, best: THRESHOLD, high: 0.55 };
  const run: Run = {
    name: "disc",
    state: "done",
    report: { schema: "tomolith.report/1", part: "disc", evaluation, exposure: { measure: "iou", tolerance: 0.01, best: evaluation.iou, percent: { low: 91, best: 100, high: 111 }, threshold: edge, dose: edge, reported_percent: 100 }, time: [{ name: "resin", best_s: 30, best_jaccard: 0.9, curves: { seconds: [0, 30, 60], jaccard: [0, 0.9, 0.7] } }] },
    texts: { lead: "The disc prints.", print_time: null, facts: [], exposure: [], limits: [], one_exposure: null, one_moment: null, time: [], scenarios: null, gap: null, ceiling: null },
    job: "[target]\nphantom = \"disc\"\n",
    history: { iteration: [0, 1, 2], loss: [3, 2, 1], forward_calls: [1, 2, 3], adjoint_calls: [0, 1, 2], seconds: [0, 1, 2] },
    volumes: volumes.map(({ info }) => info),
    films: [film],
    scene: {
      is_round: true, lit_radius_mm: 1.4, part_radius_mm: 1, z_mm: [-HALF_HEIGHT_MM, HALF_HEIGHT_MM],
      walls: [{ name: "outer wall", points: circle(2.4) }, { name: "inner wall", points: circle(2) }],
      lights: [{ name: "", frames: film.angles_deg.map((angle_deg, frame) => ({ frame, angle_deg, rays: rays(angle_deg) })) }],
      obstacles: [],
    },
    surface: null,
  };
  const data: PageData = {
    schema: "tomolith.page/2", kind: "report", title: "disc", program: "Tomolith 0.1.0", served: null, compare: null, sweep: null,
    metrics: [{ name: "iou", title: "IoU", summary: "Volume in both print and part, divided by the volume in either.", unit: "", better: "higher" }],
    headline: ["iou"], gray_headline: [], runs: [run],
  };
  const blobs = new Map(volumes.map(({ info, codes }) => [`blob-0-${info.id}`, codes]));
  blobs.set(`blob-0-${film.id}`, values);
  return { data, blobs };
}

function circle(radius: number): [number, number][] {
  return Array.from({ length: 48 }, (_, i) => [radius * Math.cos((i * Math.PI) / 24), radius * Math.sin((i * Math.PI) / 24)]);
}

function rays(angle_deg: number) {
  const [c, s] = [Math.cos((angle_deg * Math.PI) / 180), Math.sin((angle_deg * Math.PI) / 180)];
  return [-0.8, 0, 0.8].map((across) => ({
    points: [3, 1.8, -1.8].map((along): [number, number, number] => [along * c - across * s, along * s + across * c, 0]),
    resin_from: 1,
  }));
}

/** The page as the command makes it. `texts` replace those of elements. */
export function htmlOf({ data, blobs }: Fixture, texts: { [id: string]: string } = {}): string {
  const elements = [...blobs].map(([id, bytes]) => `<script type="text/plain" id="${id}">${texts[id] ?? deflateSync(bytes).toString("base64")}</script>`);
  const json = texts.data ?? JSON.stringify(data).replaceAll("<", "\\u003c");
  const built = (file: string) => readFileSync(join(OUT, file), "utf8");
  const head = `<meta charset="utf-8"><title>Tomolith</title><meta name="viewport" content="width=device-width, initial-scale=1"><style>${built("page.css")}</style>`;
  return `<!doctype html>\n<html lang="en"><head>${head}</head><body><div id="app"></div><script type="application/json" id="data">${json}</script>${elements.join("\n")}<script>${built("page.js")}</script></body></html>`;
}

/** Writes a page, and returns its address. */
export function written(name: string, fixture: Fixture, texts: { [id: string]: string } = {}): string {
  const path = join(OUT, `${name}.html`);
  writeFileSync(path, htmlOf(fixture, texts));
  return `file://${path}`;
}
