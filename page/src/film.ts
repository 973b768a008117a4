// The patterns: as a film, as the sinogram of a row, and where the light of the chosen frame goes through vial and part.

import type { FilmInfo } from "./data.ts";
import { h } from "./dom.ts";
import { lightPath } from "./light_path.ts";
import { choice, later, legendOf } from "./controls.ts";
import { inferno } from "./paint.ts";
import { significant } from "./report/number.ts";
import type { Context, Section } from "./section.ts";
import type { Film } from "./store.ts";

export const film: Section = {
  id: "film",
  title: "Patterns and light",
  render: (context) => {
    const { run, state, gone } = context;
    const names = run.films.length > 0 ? run.films.map(({ light }) => light) : (run.scene?.lights ?? []).map(({ name }) => name);
    if (names.length === 0) return null;
    const current = () => Math.min(state.get("light"), names.length - 1);
    const place = h("div");
    let end = new AbortController();
    const show = () => {
      end.abort();
      end = new AbortController();
      const { signal } = end;
      // A job that has not run has rays and no patterns
      const pathsAlone = run.films.length === 0 && run.scene ? lightPath(context, run.scene, current(), null, signal) : null;
      place.replaceChildren(pathsAlone ?? later(context, () => draw(context, current(), signal)));
    };
    const unlisten = state.on(["light"], () => {
      state.set({ frame: 0, row: null });
      show();
    });
    gone.addEventListener("abort", () => {
      unlisten();
      end.abort();
    });
    show();
    const options = names.map((name, i): [string, string] => [String(i), name || `light ${i + 1}`]);
    return h("div", {}, options.length > 1 && choice("Light", options, () => String(current()), (light) => state.set({ light: Number(light) }), (call) => gone.addEventListener("abort", state.on(["light"], call))), place);
  },
};

/** A turn takes about so long when it is played, s. */
const TURN_S = 8;

async function draw({ run, state, store }: Context, light: number, signal: AbortSignal): Promise<HTMLElement> {
  const info = run.films[light];
  const { values } = await store.film(info);
  const view = new FilmView({ info, values });
  const last = info.frames - 1;
  const frame = () => Math.min(state.get("frame"), last);
  const row = () => Math.min(state.get("row") ?? info.rows >> 1, info.rows - 1);

  const place = h("output");
  const frames = h("input", { type: "range", min: 0, max: last, step: 1, "aria-label": "Frame", input: (event: Event) => state.set({ frame: Number((event.target as HTMLInputElement).value) }) });
  const rows = h("input", { type: "range", min: 0, max: info.rows - 1, step: 1, "aria-label": "Row of the sinogram", input: (event: Event) => state.set({ row: Number((event.target as HTMLInputElement).value) }) });
  const rowText = h("output.quiet");
  const stretchText = h("output.quiet");
  const stretch = h("input", { type: "range", min: 0, max: 5, step: 0.25, value: 0, "aria-label": "Stretch of the brightness" });
  const play = h("button", { type: "button", "aria-label": "Play the film" }, "Play");
  const legend = h("div.color-legend");

  const update = () => {
    const [k, r] = [frame(), row()];
    [frames.value, rows.value] = [String(k), String(r)];
    const text = `frame ${k * info.every + 1} of ${info.of[0]}, ${degrees(info.angles_deg[k])}`;
    place.textContent = text;
    frames.setAttribute("aria-valuetext", text);
    view.sinogram.setAttribute("aria-valuenow", String(k));
    view.sinogram.setAttribute("aria-valuetext", text);
    rowText.textContent = `row ${r * info.binned + 1} of ${info.of[1]} from the top`;
    view.draw(k, r);
  };
  const restretch = () => {
    view.gain = 2 ** Number(stretch.value);
    stretchText.textContent = view.gain === 1 ? "as shown" : `${significant(view.gain, 3)} ×`;
    legend.replaceChildren(legendOf({ scale: { low: 0, high: info.full_scale / view.gain, logarithmic: false, map: inferno }, label: "pattern value", mark: null }));
    view.draw(frame(), row());
  };
  stretch.addEventListener("input", restretch, { signal });
  view.choose = (k) => state.set({ frame: Math.min(Math.max(k, 0), last) });
  view.chooseRow = (r) => state.set({ row: Math.min(Math.max(r, 0), info.rows - 1) });
  player(play, info, signal, () => state.set({ frame: (frame() + 1) % info.frames }));

  const end = state.on(["frame", "row"], update);
  signal.addEventListener("abort", () => {
    end();
    view.end();
  });
  update();
  restretch();

  const less = [info.every > 1 && `every ${ordinal(info.every)} frame`, info.binned > 1 && `means of ${info.binned} × ${info.binned} pixels`].filter(Boolean).join(", ");
  const path = run.scene && lightPath({ run, state, store }, run.scene, light, () => info.angles_deg[frame()], signal);
  return h(
    "div.film",
    {},
    h("p.quiet", {}, `${info.of[0]} frames of ${info.of[2]} × ${info.of[1]} pixels.${less ? ` Shown: ${less}.` : ""} Click in the sinogram to choose a frame, in the frame to choose the row of the sinogram.`),
    h(
      "div.film-views",
      {},
      h("figure", {}, h("figcaption", {}, h("span", {}, "Frame"), place), view.frame),
      h("figure", {}, h("figcaption", {}, h("span", {}, "Sinogram"), rowText), view.sinogram, h("div.film-axis.quiet", {}, h("span", {}, degrees(info.angles_deg[0])), h("span", {}, "angle of the frame"), h("span", {}, degrees(info.angles_deg[last])))),
    ),
    h(
      "div.film-controls",
      {},
      play,
      h("label", {}, "Frame", frames),
      h("label", {}, "Row", rows),
      h("label", {}, "Stretch", stretch, stretchText),
      legend,
    ),
    path,
  );
}

/** Frame and sinogram as canvases. */
class FilmView {
  readonly frame = h("canvas");
  readonly sinogram = h("canvas", { tabindex: 0, role: "slider", "aria-label": "Sinogram: arrow keys choose the frame", "aria-valuemin": 0 });
  gain = 1;
  choose: (frame: number) => void = () => {};
  chooseRow: (row: number) => void = () => {};
  private readonly image = document.createElement("canvas");
  private readonly watcher = new ResizeObserver(() => this.draw(...this.shown));
  private shown: [number, number] = [0, 0];
  private painted = "";

  constructor(private readonly film: Film) {
    const { info } = film;
    // Pitches are those of columns and rows
    this.frame.style.aspectRatio = `${info.columns * info.pitch_mm[0]} / ${info.rows * info.pitch_mm[1]}`;
    this.sinogram.setAttribute("aria-valuemax", String(info.frames - 1));
    for (const canvas of [this.frame, this.sinogram]) this.watcher.observe(canvas);
    const drag = (canvas: HTMLCanvasElement, choose: (x: number, y: number) => void) => {
      const act = (event: PointerEvent) => {
        if (event.buttons !== 1) return;
        const box = canvas.getBoundingClientRect();
        choose((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
      };
      canvas.addEventListener("pointerdown", act);
      canvas.addEventListener("pointermove", act);
    };
    drag(this.sinogram, (x) => this.choose(Math.floor(x * info.frames)));
    drag(this.frame, (_, y) => this.chooseRow(Math.floor(y * info.rows)));
    this.sinogram.addEventListener("keydown", (event) => {
      const steps: Record<string, number> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10, Home: -info.frames, End: info.frames };
      if (!(event.key in steps)) return;
      event.preventDefault();
      this.choose(this.shown[0] + steps[event.key]);
    });
  }

  end(): void {
    this.watcher.disconnect();
  }

  draw(frame: number, row: number): void {
    this.shown = [frame, row];
    this.drawFrame(frame, row);
    this.drawSinogram(frame, row);
  }

  private drawFrame(frame: number, row: number): void {
    const { info, values } = this.film;
    const context = fitted(this.frame);
    if (!context) return;
    const size = info.rows * info.columns;
    const image = document.createElement("canvas");
    paint(image, info.columns, info.rows, this.palette(), values.subarray(frame * size, (frame + 1) * size));
    context.drawImage(image, 0, 0, context.canvas.width, context.canvas.height);
    line(context, "y", (row + 0.5) / info.rows);
  }

  private drawSinogram(frame: number, row: number): void {
    const { info, values } = this.film;
    const context = fitted(this.sinogram);
    if (!context) return;
    const key = `${row} ${this.gain}`;
    if (this.painted !== key) {
      this.painted = key;
      const codes = new Uint8Array(info.frames * info.columns);
      for (let k = 0; k < info.frames; k++) {
        const from = (k * info.rows + row) * info.columns;
        for (let column = 0; column < info.columns; column++) codes[column * info.frames + k] = values[from + column];
      }
      paint(this.image, info.frames, info.columns, this.palette(), codes);
    }
    context.drawImage(this.image, 0, 0, context.canvas.width, context.canvas.height);
    line(context, "x", (frame + 0.5) / info.frames);
  }

  private palette(): Uint32Array {
    return Uint32Array.from({ length: 256 }, (_, code) => inferno((code / 255) * this.gain));
  }
}

function paint(canvas: HTMLCanvasElement, width: number, height: number, colors: Uint32Array, codes: Uint8Array): void {
  const pixels = new Uint32Array(width * height);
  for (let i = 0; i < pixels.length; i++) pixels[i] = colors[codes[i]];
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height), 0, 0);
}

/** The context of a canvas that has as many pixels as it takes on the screen; null where it is not shown. */
function fitted(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
  if (width === 0 || height === 0) return null;
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d");
  if (context) context.imageSmoothingEnabled = false;
  return context;
}

/** A line across a canvas at a share of its width ("x") or height ("y"). */
function line(context: CanvasRenderingContext2D, along: "x" | "y", share: number): void {
  const { width, height } = context.canvas;
  const thick = Math.max(Math.round(window.devicePixelRatio || 1), 1);
  for (const [color, off] of [["rgb(0 0 0 / 0.5)", thick], ["rgb(255 255 255 / 0.8)", 0]] as const) {
    context.fillStyle = color;
    if (along === "x") context.fillRect(Math.round(share * width) + off, 0, thick, height);
    else context.fillRect(0, Math.round(share * height) + off, width, thick);
  }
}

/** Plays frame after frame while its button is pressed. */
function player(button: HTMLButtonElement, info: FilmInfo, signal: AbortSignal, next: () => void): void {
  let timer = 0;
  const stop = () => {
    window.clearInterval(timer);
    timer = 0;
    button.textContent = "Play";
    button.setAttribute("aria-label", "Play the film");
  };
  button.addEventListener("click", () => {
    if (timer !== 0) return stop();
    timer = window.setInterval(next, Math.max((1000 * TURN_S) / info.frames, 40));
    button.textContent = "Pause";
    button.setAttribute("aria-label", "Pause the film");
  });
  signal.addEventListener("abort", stop);
}

function degrees(angle: number): string {
  return `${significant(angle, 4)}°`;
}

function ordinal(n: number): string {
  return n === 2 ? "2nd" : n === 3 ? "3rd" : `${n}th`;
}
