// The arrays of the page: each is unpacked once, when first asked for. In a file they are elements of the page; a viewer fetches them.

import type { FilmInfo, SurfaceInfo, VolumeInfo } from "./data.ts";
import { Volume } from "./volume.ts";

export interface Film {
  info: FilmInfo;
  /** [frame][row][column], row 0 at the top. */
  values: Uint8Array;
}

/** The predicted surface as triangles, mm, and how far each corner is off the target, µm. */
export interface Surface {
  corners: Float32Array<ArrayBuffer>;
  off_um: Float32Array;
  triangles: Uint32Array<ArrayBuffer>;
}

export class Store {
  private readonly cache = new Map<string, Promise<unknown>>();

  constructor(
    private readonly served: string | null,
    private readonly run: number,
  ) {}

  volume(info: VolumeInfo): Promise<Volume> {
    return this.once(info.id, async () => {
      const [nz, ny, nx] = info.shape_zyx;
      const bytes = await this.bytes("volume", info.id, (nz * ny * nx * info.bits) / 8);
      return new Volume(info, info.bits === 16 ? new Uint16Array(bytes.buffer) : bytes);
    });
  }

  film(info: FilmInfo): Promise<Film> {
    return this.once(info.id, async () => ({ info, values: await this.bytes("film", info.id, info.frames * info.rows * info.columns) }));
  }

  surface(info: SurfaceInfo): Promise<Surface> {
    return this.once(info.id, async () => surfaceOf(info, await this.bytes("volume", info.id, info.vertices * 8 + info.triangles * 12)));
  }

  /** One slice with all voxels of the run, from the server. */
  async slice(info: VolumeInfo, axis: number, index: number, signal: AbortSignal): Promise<{ shape: [number, number]; low: number; high: number; codes: Uint8Array | Uint16Array }> {
    const answer = await fetch(`${this.served}run/${this.run}/slice/${info.id}?axis=${axis}&index=${index}`, { signal });
    if (!answer.ok) throw new Error((await answer.text()) || `the viewer answered ${answer.status}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    const end = bytes.indexOf(10);
    const head = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)));
    const rest = bytes.slice(end + 1);
    return { ...head, codes: head.bits === 16 ? new Uint16Array(rest.buffer) : rest };
  }

  private once<T>(id: string, make: () => Promise<T>): Promise<T> {
    let made = this.cache.get(id) as Promise<T> | undefined;
    if (!made) {
      made = make();
      this.cache.set(id, made);
    }
    return made;
  }

  private async bytes(path: "volume" | "film", id: string, length: number): Promise<Uint8Array<ArrayBuffer>> {
    let bytes: Uint8Array<ArrayBuffer>;
    try {
      bytes = await inflate(await this.packed(path, id));
    } catch (error) {
      throw new Error(`The array “${id}” is damaged or missing: ${error instanceof Error ? error.message : String(error)}.`);
    }
    if (bytes.length !== length) {
      throw new Error(`The array “${id}” is damaged: ${bytes.length.toLocaleString("en")} bytes where ${length.toLocaleString("en")} are expected.`);
    }
    return bytes;
  }

  private async packed(path: "volume" | "film", id: string): Promise<BlobPart> {
    if (this.served !== null) {
      const answer = await fetch(`${this.served}run/${this.run}/${path}/${id}`);
      if (!answer.ok) throw new Error(`the viewer answered ${answer.status}`);
      return answer.arrayBuffer();
    }
    const element = document.getElementById(`blob-${this.run}-${id}`);
    if (!element) throw new Error("the page has no such element");
    return fromBase64(element.textContent ?? "");
  }
}

async function inflate(packed: BlobPart): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new Error("it cannot be unpacked");
  }
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  let binary: string;
  try {
    binary = atob(text);
  } catch {
    throw new Error("it is no base64");
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Corners are 16 bits within their box, deviations 16 bits of the largest. */
function surfaceOf(info: SurfaceInfo, bytes: Uint8Array<ArrayBuffer>): Surface {
  const view = new DataView(bytes.buffer);
  const n = info.vertices;
  const corners = new Float32Array(3 * n);
  for (let i = 0; i < corners.length; i++) {
    const axis = i % 3;
    corners[i] = info.low_mm[axis] + (view.getUint16(2 * i, true) / 65535) * (info.high_mm[axis] - info.low_mm[axis]);
  }
  const off_um = new Float32Array(n);
  for (let i = 0; i < n; i++) off_um[i] = (view.getInt16(6 * n + 2 * i, true) / 32767) * info.off_um[1];
  const triangles = new Uint32Array(3 * info.triangles);
  for (let i = 0; i < triangles.length; i++) triangles[i] = view.getUint32(8 * n + 4 * i, true);
  if (triangles.some((corner) => corner >= n)) throw new Error(`The array “${info.id}” is damaged: a triangle names a corner that is not there.`);
  return { corners, off_um, triangles };
}
