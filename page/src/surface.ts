// Surfaces of volumes: naive surface nets, and how far one surface is from another. Runs in a worker (surface_worker.ts).
//
// Every cell of eight voxels that the level passes gets one corner, in the middle of the points at which it passes the cell's edges;
// every edge that it passes gets a quad of the four cells around. What lies outside of the volume is below the level, so that surfaces are closed.

export interface Samples {
  codes: Uint8Array | Uint16Array;
  /** What a code stands for; NaN: below every level. */
  values: Float32Array;
  /** Voxels along x, y, z. */
  shape: [number, number, number];
  /** Edges of a voxel along x, y, z, mm. */
  pitch: [number, number, number];
  /** Low corner of the volume, mm. */
  low: [number, number, number];
}

export interface Mesh {
  /** x, y, z of each corner, mm. */
  corners: Float32Array<ArrayBuffer>;
  triangles: Uint32Array<ArrayBuffer>;
}

/** The surface on which a volume has the value `level`; triangles turn counter-clockwise seen from where it is lower. */
export function surfaceNets(samples: Samples, level: number): Mesh {
  const { pitch, low } = samples;
  const [nx, ny, nz] = samples.shape.map((n) => n + 2);
  const field = padded(samples, level);
  const layer = nx * ny;
  // From a cell's first corner to its others, and along the axes
  const offsets = Int32Array.from({ length: 8 }, (_, corner) => (corner & 1) + ((corner >> 1) & 1) * nx + (corner >> 2) * layer);
  const strides = [1, nx, layer];
  // Corners of the surface in the cells of this layer and the one below it: cells two layers apart share a place
  const both = 2 * layer;
  const known = new Int32Array(both);
  const corners = new Growing(Float32Array);
  const triangles = new Growing(Uint32Array);
  const value = new Float32Array(8);
  const middle = new Float64Array(3);
  let count = 0;
  for (let z = 0; z + 1 < nz; z++) {
    for (let y = 0; y + 1 < ny; y++) {
      for (let x = 0; x + 1 < nx; x++) {
        const base = x + nx * y + layer * z;
        let mask = 0;
        for (let corner = 0; corner < 8; corner++) {
          value[corner] = field[base + offsets[corner]];
          if (value[corner] >= 0) mask |= 1 << corner;
        }
        if (mask === 0 || mask === 255) continue;
        middleOfCrossings(value, mask, middle);
        // The padding lies one voxel before the volume, and a voxel's value in its middle
        corners.push3(low[0] + (x + middle[0] - 0.5) * pitch[0], low[1] + (y + middle[1] - 0.5) * pitch[1], low[2] + (z + middle[2] - 0.5) * pitch[2]);
        known[base % both] = count;
        const isIn = (mask & 1) !== 0;
        for (let axis = 0; axis < 3; axis++) {
          if (isIn === field[base + strides[axis]] >= 0) continue;
          // The cells around the edge, a step back along the two other axes; the padding holds no edge at the low ends
          if ((axis !== 0 && x === 0) || (axis !== 1 && y === 0) || (axis !== 2 && z === 0)) continue;
          const u = strides[(axis + 1) % 3];
          const v = strides[(axis + 2) % 3];
          const b = known[(base - u) % both];
          const c = known[(base - u - v) % both];
          const d = known[(base - v) % both];
          if (isIn) {
            triangles.push3(count, b, c);
            triangles.push3(count, c, d);
          } else {
            triangles.push3(count, c, b);
            triangles.push3(count, d, c);
          }
        }
        count++;
      }
    }
  }
  return { corners: corners.taken() as Float32Array<ArrayBuffer>, triangles: triangles.taken() as Uint32Array<ArrayBuffer> };
}

/** Values less the level, with one voxel of "below" around. */
function padded({ codes, values, shape }: Samples, level: number): Float32Array {
  const [nx, ny, nz] = shape;
  const field = new Float32Array((nx + 2) * (ny + 2) * (nz + 2)).fill(-1e6);
  const less = values.map((value) => (Number.isNaN(value) ? -1e6 : value - level));
  let from = 0;
  for (let z = 0; z < nz; z++) {
    for (let y = 0; y < ny; y++) {
      let to = 1 + (nx + 2) * (y + 1 + (ny + 2) * (z + 1));
      for (let x = 0; x < nx; x++) field[to++] = less[codes[from++]];
    }
  }
  return field;
}

/** Corners of the cell at the ends of its edges. */
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

/** The middle of the points at which the level passes the edges of a cell. */
function middleOfCrossings(value: Float32Array, mask: number, middle: Float64Array): void {
  let x = 0;
  let y = 0;
  let z = 0;
  let n = 0;
  for (let i = 0; i < 24; i += 2) {
    const a = EDGES[i];
    const b = EDGES[i + 1];
    if (((mask >> a) & 1) === ((mask >> b) & 1)) continue;
    const share = value[a] / (value[a] - value[b]);
    x += (a & 1) + share * ((b & 1) - (a & 1));
    y += ((a >> 1) & 1) + share * (((b >> 1) & 1) - ((a >> 1) & 1));
    z += (a >> 2) + share * ((b >> 2) - (a >> 2));
    n++;
  }
  middle[0] = x / n;
  middle[1] = y / n;
  middle[2] = z / n;
}

/** Rings of cells in which the nearest corner is looked for. */
const RINGS = 8;

/** Answers how far points are outside of a surface, mm; below 0 within it. */
export class Distance {
  private readonly normals: Float32Array;
  private readonly size: number;
  private readonly cells: [number, number, number];
  private readonly low: [number, number, number];
  private readonly starts: Uint32Array;
  private readonly order: Uint32Array;

  constructor(
    private readonly mesh: Mesh,
    { shape, pitch, low }: Samples,
  ) {
    this.normals = normalsOf(mesh);
    this.size = 2 * Math.max(...pitch);
    this.low = [low[0] - this.size, low[1] - this.size, low[2] - this.size];
    this.cells = [0, 1, 2].map((axis) => Math.ceil((shape[axis] * pitch[axis]) / this.size) + 2) as [number, number, number];
    // Corners in the order of their cells
    const count = mesh.corners.length / 3;
    const cell = Uint32Array.from({ length: count }, (_, i) => this.cellOf(mesh.corners, i));
    this.starts = new Uint32Array(this.cells[0] * this.cells[1] * this.cells[2] + 1);
    for (const c of cell) this.starts[c + 1]++;
    for (let c = 1; c < this.starts.length; c++) this.starts[c] += this.starts[c - 1];
    const next = this.starts.slice();
    this.order = new Uint32Array(count);
    cell.forEach((c, i) => {
      this.order[next[c]++] = i;
    });
  }

  /** How far each corner of another surface is off. */
  of(corners: Float32Array): Float32Array<ArrayBuffer> {
    const out = new Float32Array(corners.length / 3);
    for (let i = 0; i < out.length; i++) out[i] = this.off(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
    return out;
  }

  private place(mm: number, axis: number): number {
    return Math.min(Math.max(Math.floor((mm - this.low[axis]) / this.size), 0), this.cells[axis] - 1);
  }

  private cellOf(corners: Float32Array, i: number): number {
    return this.place(corners[3 * i], 0) + this.cells[0] * (this.place(corners[3 * i + 1], 1) + this.cells[1] * this.place(corners[3 * i + 2], 2));
  }

  private off(x: number, y: number, z: number): number {
    const { corners } = this.mesh;
    const [nx, ny, nz] = this.cells;
    const cx = this.place(x, 0);
    const cy = this.place(y, 1);
    const cz = this.place(z, 2);
    let best = Number.POSITIVE_INFINITY;
    let nearest = -1;
    for (let ring = 0; ring <= RINGS; ring++) {
      // Nothing in a farther ring is nearer than this
      if (nearest >= 0 && best <= ((ring - 1) * this.size) ** 2) break;
      for (let gz = Math.max(cz - ring, 0); gz <= Math.min(cz + ring, nz - 1); gz++) {
        for (let gy = Math.max(cy - ring, 0); gy <= Math.min(cy + ring, ny - 1); gy++) {
          const isFace = Math.abs(gz - cz) === ring || Math.abs(gy - cy) === ring;
          for (let gx = cx - ring; gx <= cx + ring; gx += isFace || ring === 0 ? 1 : 2 * ring) {
            if (gx < 0 || gx >= nx) continue;
            const cell = gx + nx * (gy + ny * gz);
            for (let k = this.starts[cell]; k < this.starts[cell + 1]; k++) {
              const i = 3 * this.order[k];
              const d = (corners[i] - x) ** 2 + (corners[i + 1] - y) ** 2 + (corners[i + 2] - z) ** 2;
              if (d < best) {
                best = d;
                nearest = i;
              }
            }
          }
        }
      }
    }
    if (nearest < 0) return RINGS * this.size;
    const along = (x - corners[nearest]) * this.normals[nearest] + (y - corners[nearest + 1]) * this.normals[nearest + 1] + (z - corners[nearest + 2]) * this.normals[nearest + 2];
    // Near the surface it is flat; farther off its nearest corner is as good as its nearest point
    const distance = Math.sqrt(best);
    return distance <= this.size ? along : Math.sign(along) * distance;
  }
}

/** Outward normals of the corners: means over their triangles, by area. */
function normalsOf({ corners, triangles }: Mesh): Float32Array {
  const normals = new Float32Array(corners.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ux, uy, uz] = [corners[b] - corners[a], corners[b + 1] - corners[a + 1], corners[b + 2] - corners[a + 2]];
    const [vx, vy, vz] = [corners[c] - corners[a], corners[c + 1] - corners[a + 1], corners[c + 2] - corners[a + 2]];
    for (const i of [a, b, c]) {
      normals[i] += uy * vz - uz * vy;
      normals[i + 1] += uz * vx - ux * vz;
      normals[i + 2] += ux * vy - uy * vx;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let axis = 0; axis < 3; axis++) normals[i + axis] /= length;
  }
  return normals;
}

/** An array of numbers that grows. */
class Growing {
  private array: Float32Array | Uint32Array;
  private used = 0;

  constructor(private readonly kind: Float32ArrayConstructor | Uint32ArrayConstructor) {
    this.array = new kind(1 << 15);
  }

  push3(a: number, b: number, c: number): void {
    if (this.used + 3 > this.array.length) {
      const larger = new this.kind(2 * this.array.length);
      larger.set(this.array);
      this.array = larger;
    }
    this.array[this.used++] = a;
    this.array[this.used++] = b;
    this.array[this.used++] = c;
  }

  taken(): Float32Array | Uint32Array {
    return this.array.slice(0, this.used);
  }
}
