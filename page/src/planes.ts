// Linked planes: canvases that show slices of layers, meet in one point, and share zoom and pointer.
//
// Each plane moves by its slider, by keys, by the wheel once it has the focus (so that the page can still be scrolled over it),
// and by clicks in the other planes. Nothing is painted again that did not change: a slice's pixels when its slice or the
// threshold changes, lines and image placement at every drawing.

import { h } from "./dom.ts";
import type { Layer, Picture } from "./layers.ts";
import type { State } from "./state.ts";
import { ACROSS, AXES, type Axis, type Grid, type Point, type Slice } from "./volume.ts";

/** Lines over a slice: where a value is reached. */
export interface Outline {
  slice: Pick<Slice, "pitch" | "corner">;
  segments: Float32Array;
  /** A color of the style sheet. */
  color: string;
}

export interface Shown {
  axis: Axis;
  layer: Layer;
  /** Above the plane; without it the name of the plane. */
  title?: string;
  /** Lines over the slice; the layer's own ones. */
  outlines?: (axis: Axis, mm: number) => Outline[];
}

export interface PlanesOptions {
  state: State;
  /** Its voxels are the steps of the sliders. */
  grid: Grid;
  signal: AbortSignal;
  /** The point under the pointer, or null when it leaves. */
  hover?: (point: Point | null, layer: Layer) => void;
}

/** Which side of the part is toward the reader. */
const SEEN_FROM: Record<Axis, string> = { 2: "from +z", 1: "from −y", 0: "from +x" };
const NAMES: Record<Axis, string> = { 2: "Top view, x–y", 1: "Front view, x–z", 0: "Side view, y–z" };
const LARGEST_ZOOM = 24;
/** Parts whose height is below this share of their width have their side views above each other. */
const FLAT = 0.62;
/** Height over width of a plane at most; a part that is taller leaves room at its sides. */
const TALLEST = 3;

export class Planes {
  readonly element = h("div.planes");
  private views: PlaneView[] = [];
  /** Shared by all planes: magnification, and the point in the middle of each. */
  zoom = 1;
  center: Point;

  constructor(readonly options: PlanesOptions) {
    const { state, signal, grid } = options;
    this.center = [...grid.center];
    const end = state.on(["at"], () => this.redraw(false));
    signal.addEventListener("abort", end);
    const redraw = () => this.redraw(true);
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw, { signal });
  }

  /** Shows these planes in place of those before. */
  show(shown: Shown[]): void {
    this.views.forEach((view) => view.end());
    this.views = shown.map((one) => new PlaneView(this, one));
    const { grid } = this.options;
    const extents = shown.map(({ axis }) => extent(grid, ACROSS[axis][0]));
    // Shares below 1 in all would leave room
    const widths = extents.map((mm) => `minmax(0, ${(mm / Math.max(...extents)).toFixed(4)}fr)`);
    this.element.style.setProperty("--columns", widths.join(" "));
    const [x, y, z] = ([0, 1, 2] as const).map((axis) => extent(grid, axis));
    const isTriple = shown.length === 3 && new Set(shown.map(({ axis }) => axis)).size === 3;
    this.element.classList.toggle("flat", isTriple && z < FLAT * Math.min(x, y));
    const [right, up] = ACROSS[shown[0]?.axis ?? 2];
    this.element.classList.toggle("pairs", !isTriple && shown.length === 4 && extent(grid, right) > 1.5 * extent(grid, up));
    this.element.replaceChildren(...this.views.map((view) => view.element));
  }

  /** Draws all planes again; `painted`: what they show has changed too. */
  redraw(painted: boolean): void {
    for (const view of this.views) view.redraw(painted);
  }

  at(): Point {
    const { state, grid } = this.options;
    return grid.nearest(state.get("at") ?? grid.center);
  }

  moveTo(change: Partial<Record<Axis, number>>): void {
    const { state, grid } = this.options;
    state.set({ at: grid.nearest(this.at().map((mm, axis) => change[axis as Axis] ?? mm) as Point) });
  }

  /** Magnifies by a factor, with a point of the plane left where it is. */
  zoomBy(factor: number, around: Point): void {
    const zoom = Math.min(Math.max(this.zoom * factor, 1), LARGEST_ZOOM);
    const moved = 1 - this.zoom / zoom;
    this.center = this.center.map((c, axis) => c + (around[axis] - c) * moved) as Point;
    this.zoom = zoom;
    if (zoom === 1) this.center = [...this.options.grid.center];
    this.keepWithin();
    this.redraw(false);
  }

  panBy(axis: Axis, mm: number): void {
    this.center[axis] += mm;
    this.keepWithin();
    this.redraw(false);
  }

  private keepWithin(): void {
    const { grid } = this.options;
    this.center = this.center.map((c, axis) => {
      const [low, high] = grid.range(axis as Axis);
      const half = (high - low) / 2 / this.zoom;
      return Math.min(Math.max(c, low + half), high - half);
    }) as Point;
  }
}

function extent(grid: Grid, axis: Axis): number {
  return grid.range(axis)[1] - grid.range(axis)[0];
}

/** In a lower plane the ruler would hide what is shown, px. */
const SMALLEST_WITH_RULER = 90;
/** Room of the arrows of the axes, in a plane that is large enough for them, px. */
const ARROWS = 38;
const SMALLEST_WITH_ARROWS = 56;
/** Ground of what is written over a slice, whatever its colors are. */
const LABEL_GROUND = "rgb(0 0 0 / 0.5)";

class PlaneView {
  readonly element: HTMLElement;
  private readonly canvas = h("canvas", { tabindex: 0, role: "slider", "aria-orientation": "horizontal" });
  private readonly slider: HTMLInputElement;
  private readonly place = h("output.place");
  private readonly image = document.createElement("canvas");
  private readonly watcher = new ResizeObserver(() => this.redraw(false));
  private picture: Picture | null = null;
  private outlines: Outline[] = [];
  private painted = -1;
  private frame = 0;
  private turned = 0;

  constructor(
    private readonly planes: Planes,
    private readonly shown: Shown,
  ) {
    const { grid } = planes.options;
    const { axis } = shown;
    const name = shown.title ?? NAMES[axis];
    const last = grid.shape[axis] - 1;
    this.slider = h("input", { type: "range", min: 0, max: last, step: 1, "aria-label": `${name}: ${AXES[axis]} of the slice` });
    this.canvas.setAttribute("aria-label", `${name}: slice along ${AXES[axis]}`);
    this.canvas.setAttribute("aria-valuemin", "0");
    this.canvas.setAttribute("aria-valuemax", String(last));
    const [right, up] = ACROSS[axis];
    const width = extent(grid, right);
    this.canvas.style.aspectRatio = `${width} / ${Math.min(extent(grid, up), TALLEST * width)}`;
    this.element = h("figure.plane", {}, h("figcaption", {}, h("span", { title: `seen ${SEEN_FROM[axis]}` }, name), this.place), this.canvas, this.slider);
    this.listen();
    this.watcher.observe(this.canvas);
  }

  end(): void {
    this.watcher.disconnect();
    cancelAnimationFrame(this.frame);
  }

  redraw(painted: boolean): void {
    if (painted) this.painted = -1;
    if (this.frame === 0) {
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        this.draw();
      });
    }
  }

  private get index(): number {
    const { grid } = this.planes.options;
    const { axis } = this.shown;
    return Math.min(Math.max(grid.index(axis, this.planes.at()[axis]), 0), grid.shape[axis] - 1);
  }

  private step(by: number): void {
    const { grid } = this.planes.options;
    const { axis } = this.shown;
    this.planes.moveTo({ [axis]: grid.middle(axis, this.index + by) });
  }

  /** Takes the pixels and lines of the slice, if they are not those of this slice already. */
  private paint(): void {
    const { grid } = this.planes.options;
    const { axis, layer, outlines } = this.shown;
    const index = this.index;
    if (this.painted === index) return;
    this.painted = index;
    const mm = grid.middle(axis, index);
    const before = this.picture;
    this.picture = layer.picture(axis, mm);
    this.outlines = outlines?.(axis, mm) ?? [];
    if (this.picture && this.picture !== before) {
      const { width, height, pixels } = this.picture;
      [this.image.width, this.image.height] = [width, height];
      this.image.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height), 0, 0);
    }
    const text = `${AXES[axis]} = ${millimeters(mm, grid.pitch[axis])} mm`;
    this.place.textContent = `${text} · ${index + 1} of ${grid.shape[axis]}`;
    this.slider.value = String(index);
    this.slider.setAttribute("aria-valuetext", text);
    this.canvas.setAttribute("aria-valuenow", String(index));
    this.canvas.setAttribute("aria-valuetext", text);
  }

  private draw(): void {
    this.paint();
    const box = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    const context = this.canvas.getContext("2d");
    if (!context || box.width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
    if (this.canvas.width !== width || this.canvas.height !== height) [this.canvas.width, this.canvas.height] = [width, height];
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    context.imageSmoothingEnabled = false;
    const { x, y } = this.scale(width, height);
    if (this.picture) {
      const { corner, pitch } = this.picture;
      const [left, top] = [x(corner[0]), y(corner[1])];
      context.drawImage(this.image, left, top, x(corner[0] + this.picture.width * pitch[0]) - left, y(corner[1] - this.picture.height * pitch[1]) - top);
    }
    const style = getComputedStyle(this.canvas);
    for (const outline of this.outlines) stroke(context, outline, x, y, ratio, style.getPropertyValue(outline.color).trim() || outline.color);
    this.cross(context, x, y, width, height, ratio);
    this.ruler(context, width, height, ratio);
    this.arrows(context, width, height, ratio);
  }

  /** From mm to pixels of the canvas. */
  private scale(width: number, height: number) {
    const { grid } = this.planes.options;
    const { zoom, center } = this.planes;
    const [right, up] = ACROSS[this.shown.axis];
    const perMm = Math.min(width / extent(grid, right), height / extent(grid, up)) * zoom;
    return {
      perMm,
      x: (mm: number) => width / 2 + (mm - center[right]) * perMm,
      y: (mm: number) => height / 2 - (mm - center[up]) * perMm,
      back: (px: number, py: number): Point => {
        const point = this.planes.at();
        const at: Point = [point[0], point[1], point[2]];
        at[right] = center[right] + (px - width / 2) / perMm;
        at[up] = center[up] - (py - height / 2) / perMm;
        return at;
      },
    };
  }

  /** Where the other planes cut this one. */
  private cross(context: CanvasRenderingContext2D, x: (mm: number) => number, y: (mm: number) => number, width: number, height: number, ratio: number): void {
    const at = this.planes.at();
    const [right, up] = ACROSS[this.shown.axis];
    const [px, py] = [Math.round(x(at[right])), Math.round(y(at[up]))];
    for (const [color, off] of [["rgb(0 0 0 / 0.35)", ratio], ["rgb(255 255 255 / 0.65)", 0]] as const) {
      context.fillStyle = color;
      context.fillRect(px + off, 0, ratio, height);
      context.fillRect(0, py + off, width, ratio);
    }
  }

  private ruler(context: CanvasRenderingContext2D, width: number, height: number, ratio: number): void {
    if (height < SMALLEST_WITH_RULER * ratio) return;
    const { perMm } = this.scale(width, height);
    const length = niceLength((0.3 * width) / perMm);
    const [left, bottom] = [12 * ratio, height - 12 * ratio];
    const text = length < 1 ? `${Math.round(length * 1000)} µm` : `${length} mm`;
    context.font = `${11 * ratio}px system-ui, sans-serif`;
    const across = Math.max(length * perMm, context.measureText(text).width);
    context.fillStyle = LABEL_GROUND;
    context.beginPath();
    context.roundRect(left - 6 * ratio, bottom - 20 * ratio, across + 12 * ratio, 27 * ratio, 5 * ratio);
    context.fill();
    context.fillStyle = "#fff";
    context.fillRect(left, bottom - ratio, length * perMm, 2 * ratio);
    context.fillText(text, left, bottom - 6 * ratio);
  }

  /** Where the axes point: to the right and upward. */
  private arrows(context: CanvasRenderingContext2D, width: number, height: number, ratio: number): void {
    if (Math.min(width, height) < SMALLEST_WITH_ARROWS * ratio) return;
    const [right, up] = ACROSS[this.shown.axis];
    context.save();
    context.translate(width - (ARROWS + 5) * ratio, height - 5 * ratio);
    context.scale(ratio, ratio);
    context.fillStyle = LABEL_GROUND;
    context.beginPath();
    context.roundRect(0, -ARROWS, ARROWS, ARROWS, 5);
    context.fill();
    [context.strokeStyle, context.fillStyle, context.lineWidth] = ["#fff", "#fff", 1.25];
    const [corner, tip, head] = [8, 26, 3];
    context.beginPath();
    context.moveTo(tip - head, -corner - head);
    context.lineTo(tip, -corner);
    context.lineTo(tip - head, -corner + head);
    context.moveTo(tip, -corner);
    context.lineTo(corner, -corner);
    context.lineTo(corner, -tip);
    context.moveTo(corner - head, -tip + head);
    context.lineTo(corner, -tip);
    context.lineTo(corner + head, -tip + head);
    context.stroke();
    context.font = "11px system-ui, sans-serif";
    context.textAlign = "center";
    context.fillText(AXES[right], tip + 6, -corner + 3);
    context.fillText(AXES[up], corner, -tip - 4);
    context.restore();
  }

  private pointOf(event: MouseEvent): Point {
    const box = this.canvas.getBoundingClientRect();
    return this.scale(box.width, box.height).back(event.clientX - box.left, event.clientY - box.top);
  }

  private listen(): void {
    const { planes, canvas } = this;
    const { signal, hover } = planes.options;
    const [right, up] = ACROSS[this.shown.axis];
    this.slider.addEventListener("input", () => this.step(Number(this.slider.value) - this.index), { signal });
    canvas.addEventListener("keydown", (event) => this.key(event), { signal });
    canvas.addEventListener(
      "wheel",
      (event) => {
        const wantsZoom = event.ctrlKey || event.metaKey;
        if (!wantsZoom && document.activeElement !== canvas) return;
        event.preventDefault();
        if (wantsZoom) {
          planes.zoomBy(Math.exp(-event.deltaY / 300), this.pointOf(event));
          return;
        }
        this.turned += event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / 40 : event.deltaY;
        const steps = Math.trunc(this.turned);
        this.turned -= steps;
        if (steps !== 0) this.step(-steps);
      },
      { signal, passive: false },
    );
    const go = (event: MouseEvent) => {
      const point = this.pointOf(event);
      planes.moveTo({ [right]: point[right], [up]: point[up] });
    };
    canvas.addEventListener("click", go, { signal });
    canvas.addEventListener("dblclick", (event) => planes.zoomBy(event.shiftKey ? 0.5 : 2, this.pointOf(event)), { signal });
    canvas.addEventListener(
      "pointermove",
      (event) => {
        hover?.(this.pointOf(event), this.shown.layer);
        if (event.buttons === 1 && event.pointerType === "mouse") {
          if (event.shiftKey) {
            const { perMm } = this.scale(canvas.clientWidth, canvas.clientHeight);
            planes.panBy(right, -event.movementX / perMm);
            planes.panBy(up, event.movementY / perMm);
          } else go(event);
        }
      },
      { signal },
    );
    canvas.addEventListener("pointerleave", () => hover?.(null, this.shown.layer), { signal });
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { planes } = this;
    const { grid } = planes.options;
    const { axis } = this.shown;
    const [right, up] = ACROSS[axis];
    const page = Math.max(Math.round(grid.shape[axis] / 10), 2);
    const pan = (extent(grid, right) / planes.zoom) * 0.1;
    const moves: Record<string, () => void> = event.shiftKey
      ? {
          ArrowLeft: () => planes.panBy(right, -pan),
          ArrowRight: () => planes.panBy(right, pan),
          ArrowDown: () => planes.panBy(up, -pan),
          ArrowUp: () => planes.panBy(up, pan),
        }
      : {
          ArrowUp: () => this.step(1),
          ArrowRight: () => this.step(1),
          ArrowDown: () => this.step(-1),
          ArrowLeft: () => this.step(-1),
          PageUp: () => this.step(page),
          PageDown: () => this.step(-page),
          Home: () => this.step(-this.index),
          End: () => this.step(grid.shape[axis] - 1 - this.index),
        };
    const zooms: Record<string, () => void> = {
      "+": () => planes.zoomBy(1.5, planes.at()),
      "=": () => planes.zoomBy(1.5, planes.at()),
      "-": () => planes.zoomBy(1 / 1.5, planes.at()),
      "0": () => planes.zoomBy(1 / LARGEST_ZOOM, planes.at()),
    };
    const move = moves[event.key] ?? zooms[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  }
}

/** A line over a dark and a bright ground alike: a dark rim below the color. */
function stroke(context: CanvasRenderingContext2D, { segments, slice }: Outline, x: (mm: number) => number, y: (mm: number) => number, ratio: number, color: string): void {
  const [left, top] = [x(slice.corner[0]), y(slice.corner[1])];
  const [perX, perY] = [x(slice.corner[0] + slice.pitch[0]) - left, y(slice.corner[1] - slice.pitch[1]) - top];
  context.beginPath();
  for (let i = 0; i < segments.length; i += 4) {
    context.moveTo(left + segments[i] * perX, top + segments[i + 1] * perY);
    context.lineTo(left + segments[i + 2] * perX, top + segments[i + 3] * perY);
  }
  context.lineCap = "round";
  context.lineWidth = 3 * ratio;
  context.strokeStyle = "rgb(0 0 0 / 0.4)";
  context.stroke();
  context.lineWidth = 1.6 * ratio;
  context.strokeStyle = color;
  context.stroke();
}

/** The largest of 1, 2, 5 times a power of ten that is not longer. */
function niceLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  const times = [5, 2, 1].find((n) => n * power <= most * (1 + 1e-9)) ?? 1;
  return Number((times * power).toPrecision(3));
}

/** "−0.042", with digits that tell one voxel from the next. */
export function millimeters(mm: number, pitch: number): string {
  return mm.toFixed(Math.max(3, Math.ceil(1 - Math.log10(pitch)))).replace("-", "−");
}
