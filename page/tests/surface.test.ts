// Surfaces, contours and addresses, without a browser.

import assert from "node:assert/strict";
import { describe, it } from "node:test";
import { contour } from "../src/contour.ts";
import { format, parse } from "../src/state.ts";
import { Distance, type Samples, surfaceNets } from "../src/surface.ts";
import { valuesOf, Volume } from "../src/volume.ts";

/** A ball whose values fall by 1 over each voxel across its surface. */
function ball(radius: number, n = 32, pitch: [number, number, number] = [0.1, 0.1, 0.1]): Samples {
  const codes = new Uint8Array(n ** 3);
  const at = (i: number, axis: number) => (i - (n - 1) / 2) * pitch[axis];
  for (let z = 0, i = 0; z < n; z++) for (let y = 0; y < n; y++) for (let x = 0; x < n; x++, i++) {
    const share = 0.5 + (radius - Math.hypot(at(x, 0), at(y, 1), at(z, 2))) / 0.4;
    codes[i] = Math.round(255 * Math.min(Math.max(share, 0), 1));
  }
  return { codes, values: valuesOf(8, 0, 1, null), shape: [n, n, n], pitch, low: pitch.map((edge) => (-n / 2) * edge) as [number, number, number] };
}

/** The volume within a closed surface whose triangles turn counter-clockwise seen from outside. */
function within({ corners, triangles }: { corners: Float32Array; triangles: Uint32Array }): number {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => corners.subarray(3 * triangles[t + k], 3 * triangles[t + k] + 3));
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

describe("surfaces", () => {
  it("of a ball are closed and hold its volume", () => {
    const mesh = surfaceNets(ball(1), 0.5);
    const volume = within(mesh);
    assert.ok(Math.abs(volume / ((4 / 3) * Math.PI) - 1) < 0.02, `${volume}`);
    const edges = new Map<string, number>();
    for (let t = 0; t < mesh.triangles.length; t += 3) {
      for (let k = 0; k < 3; k++) {
        const [a, b] = [mesh.triangles[t + k], mesh.triangles[t + ((k + 1) % 3)]];
        edges.set(`${a} ${b}`, (edges.get(`${a} ${b}`) ?? 0) + 1);
      }
    }
    for (const [edge, count] of edges) assert.equal(edges.get(edge.split(" ").reverse().join(" ")), count, `edge ${edge}`);
  });

  it("know voxels that are no cubes", () => {
    const mesh = surfaceNets(ball(1, 40, [0.08, 0.08, 0.12]), 0.5);
    assert.ok(Math.abs(within(mesh) / ((4 / 3) * Math.PI) - 1) < 0.02);
  });

  it("are closed where the shape reaches the end of the volume", () => {
    const full: Samples = { codes: new Uint8Array(8).fill(255), values: valuesOf(8, 0, 1, null), shape: [2, 2, 2], pitch: [1, 1, 1], low: [-1, -1, -1] };
    const volume = within(surfaceNets(full, 0.5));
    assert.ok(volume > 0.9 && volume <= 8, `${volume}`);
  });

  it("are this far apart", () => {
    const target = ball(0.8);
    const distance = new Distance(surfaceNets(target, 0.5), target);
    for (const [radius, expected] of [[1, 0.2], [0.7, -0.1], [0.8, 0]] as const) {
      const off = distance.of(surfaceNets(ball(radius), 0.5).corners);
      const mean = off.reduce((sum, v) => sum + v, 0) / off.length;
      assert.ok(Math.abs(mean - expected) < 0.01, `${radius}: ${mean}`);
      assert.ok(off.every((v) => Math.abs(v - expected) < 0.03));
    }
  });
});

describe("contours", () => {
  it("of a ball's middle are a circle", () => {
    const { codes, values, shape } = ball(1);
    const [n] = shape;
    const slice = { width: n, height: n, codes: codes.slice((n / 2) * n * n, (n / 2 + 1) * n * n), values };
    const segments = contour(slice, 0.5);
    let length = 0;
    for (let i = 0; i < segments.length; i += 4) {
      length += 0.1 * Math.hypot(segments[i + 2] - segments[i], segments[i + 3] - segments[i + 1]);
      const r = 0.1 * Math.hypot(segments[i] - n / 2, segments[i + 1] - n / 2);
      assert.ok(Math.abs(r - 1) < 0.01, `${r}`);
    }
    assert.ok(Math.abs(length - 2 * Math.PI) < 0.05, `${length}`);
  });

  it("of a slice without the level are empty", () => {
    assert.equal(contour({ width: 4, height: 4, codes: new Uint8Array(16), values: valuesOf(8, 0, 1, null) }, 0.5).length, 0);
  });
});

describe("volumes", () => {
  const info = { id: "v", kind: "response", species: null, name: "", unit: "", shape_zyx: [2, 3, 4], pitch_mm: 0.5, height_mm: 1, center_xyz_mm: [1, 0, 0], bits: 8, low: 0, high: 254, nan: 255, logarithmic: false, reduced: 1, full: false } as const;
  const volume = new Volume({ ...info, shape_zyx: [2, 3, 4], center_xyz_mm: [1, 0, 0] }, Uint8Array.from({ length: 24 }, (_, i) => (i === 23 ? 255 : i)));

  it("answer with the value of the voxel around a point", () => {
    assert.equal(volume.at([0.1, -0.7, -0.9]), 0);
    assert.equal(volume.at([1.9, 0.7, -0.1]), 11);
    assert.equal(volume.at([1.9, 0.7, 0.9]), null, "no value");
    assert.equal(volume.at([2.1, 0, 0]), null, "outside");
  });

  it("have slices with the largest coordinate on top", () => {
    const top = volume.slice(2, -0.5)!;
    assert.deepEqual([...top.codes], [8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3]);
    const side = volume.slice(0, 0.1)!;
    assert.deepEqual([...side.codes], [12, 16, 20, 0, 4, 8]);
    assert.deepEqual([side.corner, side.pitch], [[-0.75, 1], [0.5, 1]]);
  });
});

describe("addresses", () => {
  it("come back as they were", () => {
    const view = { ...parse(""), run: 2, species: "a & b=c", at: [0.25, -1, 0] as [number, number, number], threshold: 0.5, frame: 7, cut: "y" };
    assert.deepEqual(parse(`#${format(view)}`), view);
    assert.equal(format(parse("")), "");
  });

  it("that say nothing sensible are those of the start", () => {
    assert.deepEqual(parse("#run=-1&frame=x&at=1,2&threshold=&time=NaN&light=1.5"), parse(""));
  });
});
