// Marching squares: the lines on which a slice has a value.
//
// Corners are the middles of voxels. Coordinates are those of the slice's pixels: the middle of the first is (0.5, 0.5).
// The border counts as below the level, so that a line is closed where the shape reaches the end of the slice.

import type { Slice } from "./volume.ts";

/** Pairs of edges that a line joins, by which corners lie at or above the level (1: top left, 2: top right, 4: bottom right, 8: bottom left). Edges: 0 top, 1 right, 2 bottom, 3 left. */
const EDGES: readonly (readonly number[])[] = [[], [3, 0], [0, 1], [3, 1], [1, 2], [3, 0, 1, 2], [0, 2], [3, 2], [2, 3], [2, 0], [0, 1, 2, 3], [2, 1], [1, 3], [1, 0], [0, 3], []];

/** Segments x0, y0, x1, y1 of the lines on which a slice has the value `level`. */
export function contour(slice: Pick<Slice, "width" | "height" | "codes" | "values">, level: number): Float32Array<ArrayBuffer> {
  const { width, height, codes, values } = slice;
  const below = level - 1e6;
  const value = (x: number, y: number) => {
    if (x < 0 || y < 0 || x >= width || y >= height) return below;
    const v = values[codes[y * width + x]];
    return Number.isNaN(v) ? below : v;
  };
  let out = new Float32Array(4096);
  let n = 0;
  for (let y = -1; y < height; y++) {
    let [topLeft, bottomLeft] = [value(-1, y), value(-1, y + 1)];
    for (let x = -1; x < width; x++) {
      const [topRight, bottomRight] = [value(x + 1, y), value(x + 1, y + 1)];
      const which = (topLeft >= level ? 1 : 0) | (topRight >= level ? 2 : 0) | (bottomRight >= level ? 4 : 0) | (bottomLeft >= level ? 8 : 0);
      if (which !== 0 && which !== 15) {
        if (n + 8 > out.length) {
          const larger = new Float32Array(2 * out.length);
          larger.set(out);
          out = larger;
        }
        for (const edge of EDGES[which]) {
          const [a, b] = edge === 0 ? [topLeft, topRight] : edge === 1 ? [topRight, bottomRight] : edge === 2 ? [bottomLeft, bottomRight] : [topLeft, bottomLeft];
          const share = (level - a) / (b - a);
          out[n++] = x + 0.5 + (edge === 1 ? 1 : edge === 3 ? 0 : share);
          out[n++] = y + 0.5 + (edge === 0 ? 0 : edge === 2 ? 1 : share);
        }
      }
      topLeft = topRight;
      bottomLeft = bottomRight;
    }
  }
  return out.slice(0, n);
}
