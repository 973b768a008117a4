// Slices for drawing: at once from what the page holds; where a viewer has finer voxels than the page, the full slice follows.

import { messageOf } from "./controls.ts";
import type { Run } from "./data.ts";
import type { Store } from "./store.ts";
import { ACROSS, type Axis, Grid, type Slice, valuesOf, type Volume } from "./volume.ts";

/** Full slices that are kept. */
const KEPT = 60;
/** How long the reader must pause before a full slice is asked for, ms. */
const PAUSE = 60;

export class Slices {
  private readonly full = new Map<string, Slice>();
  /** The last slice of each plane of a volume: a new threshold needs no new slices. */
  private readonly last = new Map<string, { index: number; slice: Slice | null }>();
  /** What was asked for last in each plane of a volume. */
  private readonly asked = new Map<string, { key: string; timer: number }>();
  /** The voxels of the job, of which the viewer has all. */
  private readonly grid: Grid | null;

  constructor(
    run: Run,
    private readonly store: Store,
    private readonly signal: AbortSignal,
    /** Called when a better slice has come, and with the reason when it has not. */
    private readonly came: (reason: string | null) => void,
  ) {
    const given = (run.report?.optimization ?? run.report?.evaluation)?.grid;
    const [nz, ny, nx] = given?.shape_zyx ?? [0, 0, 0];
    this.grid = given ? new Grid([nx, ny, nz], [given.pitch_mm, given.pitch_mm, given.pitch_mm], given.center_xyz_mm) : null;
  }

  /** The finest voxels that slices of a volume have. */
  gridOf(volume: Volume): Grid {
    return this.finer(volume) ?? volume;
  }

  of(volume: Volume, axis: Axis, mm: number): Slice | null {
    const reduced = this.reduced(volume, axis, mm);
    const grid = this.finer(volume);
    if (grid === null || reduced === null) return reduced;
    const index = grid.index(axis, mm);
    if (index < 0 || index >= grid.shape[axis]) return reduced;
    const key = `${volume.info.id}/${axis}/${index}`;
    const known = this.full.get(key);
    if (!known) this.ask(key, volume, grid, axis, index);
    return known ?? reduced;
  }

  private reduced(volume: Volume, axis: Axis, mm: number): Slice | null {
    const plane = `${volume.info.id}/${axis}`;
    const index = volume.index(axis, mm);
    const last = this.last.get(plane);
    if (last?.index === index) return last.slice;
    const slice = volume.slice(axis, mm);
    this.last.set(plane, { index, slice });
    return slice;
  }

  private finer(volume: Volume): Grid | null {
    const { grid } = this;
    return volume.info.full && grid !== null && grid.pitch[0] < 0.99 * volume.pitch[0] ? grid : null;
  }

  /** One request a plane of a volume at a time: the last place asked for wins. */
  private ask(key: string, volume: Volume, grid: Grid, axis: Axis, index: number): void {
    const plane = `${volume.info.id}/${axis}`;
    const before = this.asked.get(plane);
    if (before?.key === key) return;
    window.clearTimeout(before?.timer);
    const load = async () => {
      // The server counts axes as the arrays do: z, y, x
      const slice = await this.store.slice(volume.info, 2 - axis, index, this.signal);
      const [height, width] = slice.shape;
      const [right, up] = ACROSS[axis];
      const codes = slice.codes.slice();
      for (let row = 0; row < height; row++) codes.set(slice.codes.subarray((height - 1 - row) * width, (height - row) * width), row * width);
      const bits = slice.codes instanceof Uint16Array ? 16 : 8;
      const corner: [number, number] = [grid.range(right)[0], grid.range(up)[1]];
      const values = valuesOf(bits, slice.low, slice.high, volume.info.nan === null ? null : 2 ** bits - 1);
      this.full.set(key, { axis, width, height, codes, values, pitch: [grid.pitch[right], grid.pitch[up]], corner });
      const oldest = this.full.keys().next();
      if (this.full.size > KEPT && !oldest.done) this.full.delete(oldest.value);
      this.came(null);
    };
    const failed = (error: unknown) => {
      if (!this.signal.aborted) this.came(`The slices with all voxels did not come, so fewer are shown: ${messageOf(error)}`);
    };
    this.asked.set(plane, { key, timer: window.setTimeout(() => void load().catch(failed), PAUSE) });
  }
}
