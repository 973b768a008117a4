// Cells of a large map on one canvas. Only those that a reader looks at are marks of their own: the one under the pointer, which is found by
// arithmetic, the one with the focus, the best, the open and the marked ones.

import { h } from "../../dom.ts";
import { token } from "../../paint.ts";

/** Pixels along an edge of a cell: enough for the lines of those that failed. */
const EDGE = 6;

export interface Cell {
  row: number;
  column: number;
  level: number;
  /** A word of a color; null where there is no number. */
  color: number | null;
  state: string;
}

/** The cells of each map that has them, by the element that holds its marks. */
const known = new WeakMap<Element, Cells>();

export class Cells {
  readonly canvas: HTMLCanvasElement;
  private readonly byPlace: Int32Array;
  private readonly byRow: Map<number, Cell>;

  /** `make` makes the mark of a cell; its element goes into `grid`. */
  constructor(
    private readonly grid: HTMLElement,
    private readonly cells: readonly Cell[],
    private readonly nx: number,
    private readonly ny: number,
    private readonly make: (cell: Cell) => HTMLElement,
  ) {
    this.byRow = new Map(cells.map((cell) => [cell.row, cell]));
    this.byPlace = new Int32Array(nx * ny).fill(-1);
    for (const { row, column, level } of cells) this.byPlace[level * nx + column] = row;
    this.canvas = h("canvas.sweep-cells", { width: nx * EDGE, height: ny * EDGE, style: `grid-area: 1 / 2 / ${ny + 1} / ${nx + 2}`, "aria-hidden": "true" });
    this.draw();
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    grid.addEventListener("pointerleave", () => this.tidy(-1));
    known.set(grid, this);
  }

  /** The cells of the map around an element; null where its marks are all there. */
  static around(element: Element): Cells | null {
    const grid = element.closest(".part")?.querySelector(".sweep-map");
    return (grid && known.get(grid)) ?? null;
  }

  /** The mark of a row; null where the map has no cell of it. */
  mark(row: number): HTMLElement | null {
    const there = this.grid.querySelector<HTMLElement>(`.mark[data-row="${row}"]`);
    const cell = this.byRow.get(row);
    if (there || !cell) return there;
    const made = this.make(cell);
    this.grid.append(made);
    return made;
  }

  /** The mark of the next cell in the direction of an arrow key. */
  neighbor(row: number, key: string): HTMLElement | null {
    const from = this.byRow.get(row);
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
    if (!from || !step) return null;
    for (let [x, y] = [from.column + step[0], from.level + step[1]]; x >= 0 && y >= 0 && x < this.nx && y < this.ny; x += step[0], y += step[1]) {
      const next = this.byPlace[y * this.nx + x];
      if (next >= 0) return this.mark(next);
    }
    return null;
  }

  private point(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const place = (share: number, n: number) => Math.min(Math.max(Math.floor(share * n), 0), n - 1);
    const column = place((event.clientX - box.left) / box.width, this.nx);
    const level = this.ny - 1 - place((event.clientY - box.top) / box.height, this.ny);
    const row = this.byPlace[level * this.nx + column];
    this.tidy(row);
    if (row >= 0) this.mark(row);
  }

  /** Removes marks that the reader has left. */
  private tidy(but: number): void {
    for (const one of this.grid.querySelectorAll<HTMLElement>(".mark:not(.best, .opened, .marked, :focus)")) {
      if (one.dataset.row !== String(but)) one.remove();
    }
  }

  private draw(): void {
    const context = this.canvas.getContext("2d");
    if (!context) return;
    const { width, height } = this.canvas;
    const pixels = new Uint32Array(width * height);
    const [failed, missing] = [token("--excess"), token("--solid")];
    const dark = 0xff000000;
    for (const { column, level, color, state } of this.cells) {
      const from = (this.ny - 1 - level) * EDGE * width + column * EDGE;
      for (let y = 0; y < EDGE; y++) {
        for (let x = 0; x < EDGE; x++) {
          const isRim = x === 0 || y === 0 || x === EDGE - 1 || y === EDGE - 1;
          let pixel = color ?? 0;
          if (state === "failed") pixel = x === y || x + y === EDGE - 1 ? failed : 0;
          else if (state === "missing") pixel = isRim && (x + y) % 2 === 0 ? missing : 0;
          else if (state === "infeasible" && (x + y) % EDGE === EDGE - 1) pixel = dark;
          pixels[from + y * width + x] = pixel;
        }
      }
    }
    context.putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height), 0, 0);
  }
}
