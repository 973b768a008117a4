// A volume of the page and its slices. Codes stay codes: a table says what each stands for, so that a slice is painted without arithmetic.

import type { VolumeInfo } from "./data.ts";

/** 0: x, 1: y, 2: z. A plane is named by the axis that it is normal to. */
export type Axis = 0 | 1 | 2;

export const AXES = ["x", "y", "z"] as const;

/** The axes to the right and upward of the plane normal to an axis. */
export const ACROSS: Record<Axis, [right: Axis, up: Axis]> = { 0: [1, 2], 1: [0, 2], 2: [0, 1] };

export type Point = [number, number, number];

/** Codes of `labels`. Voxels outside count in no metric. */
export const LABEL = { outside: 0, void: 1, part: 2 } as const;

/** Codes of `bodies`. */
export const BODY = { none: 0, dark: 1, insert: 2, obstacle: 3 } as const;

export interface Slice {
  axis: Axis;
  width: number;
  height: number;
  /** Row 0 is at the top: the largest coordinate. */
  codes: Uint8Array | Uint16Array;
  /** What a code stands for; NaN: no value. */
  values: Float32Array;
  /** Edges of a voxel to the right and upward, mm. */
  pitch: [number, number];
  /** Left and top edge of the slice, mm. */
  corner: [number, number];
}

/** A box of voxels. */
export class Grid {
  constructor(
    /** Number of voxels along x, y and z. */
    readonly shape: Point,
    /** Edges of a voxel along x, y and z, mm. */
    readonly pitch: Point,
    readonly center: Point,
  ) {}

  /** Where the box begins and ends along an axis, mm. */
  range(axis: Axis): [number, number] {
    const half = (this.shape[axis] * this.pitch[axis]) / 2;
    return [this.center[axis] - half, this.center[axis] + half];
  }

  /** The nearest point within the box. */
  nearest(point: Point): Point {
    return point.map((mm, axis) => {
      const [low, high] = this.range(axis as Axis);
      return Math.min(Math.max(mm, low + 1e-4), high - 1e-4);
    }) as Point;
  }

  /** The voxel at a coordinate; may lie outside of the box. */
  index(axis: Axis, mm: number): number {
    return Math.floor((mm - this.range(axis)[0]) / this.pitch[axis] + 1e-6);
  }

  /** The middle of the voxel that holds a point, or of the nearest one. */
  middleAt(point: Point): Point {
    return this.nearest(point).map((mm, axis) => {
      const index = Math.max(this.index(axis as Axis, mm), 0);
      return this.middle(axis as Axis, Math.min(index, this.shape[axis] - 1));
    }) as Point;
  }

  /** The coordinate of the middle of a voxel, mm. */
  middle(axis: Axis, index: number): number {
    return this.range(axis)[0] + (index + 0.5) * this.pitch[axis];
  }
}

export class Volume extends Grid {
  /** What a code stands for; NaN: no value. */
  readonly values: Float32Array;

  constructor(
    readonly info: VolumeInfo,
    readonly codes: Uint8Array | Uint16Array,
  ) {
    const [nz, ny, nx] = info.shape_zyx;
    super([nx, ny, nz], [info.pitch_mm, info.pitch_mm, info.height_mm], info.center_xyz_mm);
    this.values = valuesOf(info.bits, info.low, info.high, info.nan);
  }

  /** The value at a point; null outside of the volume and where there is none. */
  at(point: Point): number | null {
    const [x, y, z] = ([0, 1, 2] as const).map((axis) => this.index(axis, point[axis]));
    const [nx, ny, nz] = this.shape;
    if (x < 0 || y < 0 || z < 0 || x >= nx || y >= ny || z >= nz) return null;
    const value = this.values[this.codes[(z * ny + y) * nx + x]];
    return Number.isNaN(value) ? null : value;
  }

  /** The slice that holds a coordinate, or null where the volume does not reach it. */
  slice(axis: Axis, mm: number): Slice | null {
    const index = this.index(axis, mm);
    if (index < 0 || index >= this.shape[axis]) return null;
    const [right, up] = ACROSS[axis];
    const [width, height] = [this.shape[right], this.shape[up]];
    const [nx, ny] = this.shape;
    const stride = [1, nx, nx * ny];
    const codes = this.info.bits === 16 ? new Uint16Array(width * height) : new Uint8Array(width * height);
    for (let row = 0; row < height; row++) {
      let from = index * stride[axis] + (height - 1 - row) * stride[up];
      for (let i = row * width; i < (row + 1) * width; i++, from += stride[right]) codes[i] = this.codes[from];
    }
    return { axis, width, height, codes, values: this.values, pitch: [this.pitch[right], this.pitch[up]], corner: [this.range(right)[0], this.range(up)[1]] };
  }
}

/** What the codes of an array stand for. */
export function valuesOf(bits: 8 | 16, low: number, high: number, nan: number | null): Float32Array {
  const codes = 2 ** bits;
  const top = codes - (nan === null ? 1 : 2);
  const values = Float32Array.from({ length: codes }, (_, code) => low + (code / top) * (high - low));
  if (nan !== null) values[nan] = Number.NaN;
  return values;
}
