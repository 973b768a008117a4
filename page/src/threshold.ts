// The threshold: how much dose part and void get, the IoU at every threshold, and a slider that chooses one for all planes and surfaces.
// Its numbers, the exposure relative to the best one among them, are those of the threshold under the slider.

import { h, svg } from "./dom.ts";
import type { Gel, Histogram } from "./gel.ts";
import { exponent, quantity, significant } from "./report/number.ts";
import type { State } from "./state.ts";

const STEPS = 1000;
const HEIGHT = 230;
const EDGE = { left: 44, right: 44, top: 26, bottom: 40 };
const BOTTOM = HEIGHT - EDGE.bottom;

/** The slider with its chart and numbers. */
export function thresholdPanel(gel: Gel, state: State, signal: AbortSignal): HTMLElement {
  const slider = h("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": "Gel threshold" });
  const reset = h("button", { type: "button", click: () => state.set({ threshold: null }) }, gel.isOfReport ? "Back to the report’s threshold" : "Back to the best threshold");
  const numbers = h("dl.threshold-list");
  const chart = new Chart(gel, (threshold) => choose(threshold));

  /** Near the report's threshold the slider snaps to it, so that its numbers can be had again. */
  const choose = (threshold: number) => {
    const within = Math.min(Math.max(threshold, 0), gel.high);
    state.set({ threshold: Math.abs(within - gel.reported) < (0.6 * gel.high) / STEPS ? null : within });
  };
  slider.addEventListener("input", () => choose((Number(slider.value) / STEPS) * gel.high), { signal });

  const known = gel.isOfReport ? "as reported" : "best of the voxels shown";
  const update = () => {
    const threshold = state.get("threshold") ?? gel.reported;
    const iou = gel.iou(threshold);
    const percent = gel.percent(threshold);
    const counted = gel.isOfReport && gel.reduced > 1 && threshold !== gel.reported ? `, in means of ${gel.reduced}³ voxels` : "";
    slider.value = String(Math.round((threshold / gel.high) * STEPS));
    slider.setAttribute("aria-valuetext", `${significant(threshold, 3)}, IoU ${significant(iou, 3)}`);
    reset.disabled = state.get("threshold") === null;
    chart.mark(threshold);
    numbers.replaceChildren(
      ...row("Gel threshold", significant(threshold, 4), `${gel.quantity} at which the resin gels`),
      ...row("Exposure", percent === null ? "–" : `${significant(percent, 4)} %`, "of the best exposure"),
      ...row("IoU", significant(iou, 4), threshold !== gel.reported ? `${significant(gel.iou(gel.reported), 4)} ${known}` : known),
      ...row("Too much", quantity(gel.tooMuch(threshold), "mm³"), `gels and should not${counted}`, "--excess"),
      ...row("Missing", quantity(gel.missing(threshold), "mm³"), `does not gel and should${counted}`, "--missing"),
    );
  };
  const end = state.on(["threshold"], update);
  signal.addEventListener("abort", () => {
    end();
    chart.end();
  });
  update();
  const range = gel.nearly && gel.tolerance !== null ? ` In the shaded range IoU is at most ${significant(gel.tolerance, 2)} below its best.` : "";
  return h(
    "div.threshold",
    {},
    h("div.threshold-chart", {}, h("h3", {}, "Where the resin gels"), h("p.quiet", {}, `Move the threshold: contours, print, errors and numbers follow.${range}`), legend(), chart.element, h("div.threshold-slider", {}, slider)),
    h("div.threshold-numbers", {}, numbers, reset),
  );
}

function row(name: string, value: string, note: string, color?: string): HTMLElement[] {
  return [h("dt", {}, color !== undefined && h("i.tile", { style: `background: var(${color})` }), name), h("dd", {}, h("b", {}, value), h("span.quiet", {}, note))];
}

function key(color: string, text: string): HTMLElement {
  return h("span", {}, h("i.tile", { style: `background: var(${color})` }), text);
}

function legend(): HTMLElement {
  return h("p.color-keys", {}, key("--part", "part, voxels"), key("--void", "void, voxels"), key("--ink", "IoU"), key("--threshold", "gel threshold"));
}

/** Histograms on a logarithmic scale, the IoU over them, and a line that can be dragged. Drawn again when its width changes. */
class Chart {
  readonly element = h("div.plot");
  private readonly watcher = new ResizeObserver(() => this.resize());
  private readonly line = svg("g");
  private width = 0;
  private threshold = 0;

  constructor(
    private readonly gel: Gel,
    choose: (threshold: number) => void,
  ) {
    this.watcher.observe(this.element);
    const drag = (event: PointerEvent) => {
      if (event.buttons !== 1) return;
      event.preventDefault();
      choose(this.back(event.clientX - this.element.getBoundingClientRect().left));
    };
    this.element.addEventListener("pointerdown", (event) => {
      this.element.setPointerCapture(event.pointerId);
      drag(event);
    });
    this.element.addEventListener("pointermove", drag);
  }

  end(): void {
    this.watcher.disconnect();
  }

  mark(threshold: number): void {
    this.threshold = threshold;
    this.drawLine();
  }

  private x(value: number): number {
    return EDGE.left + (value / this.gel.high) * (this.width - EDGE.left - EDGE.right);
  }

  private back(px: number): number {
    return ((px - EDGE.left) / (this.width - EDGE.left - EDGE.right)) * this.gel.high;
  }

  private resize(): void {
    const width = this.element.clientWidth;
    if (width === 0 || width === this.width) return;
    this.width = width;
    this.element.replaceChildren(this.draw());
    this.drawLine();
  }

  private draw(): SVGElement {
    const { histogram, nearly, objective, curve, reported, high } = this.gel;
    const root = svg("svg", { width: this.width, height: HEIGHT, viewBox: `0 0 ${this.width} ${HEIGHT}`, role: "img", "aria-label": `Voxels of part and void per ${this.gel.quantity}, and IoU per gel threshold` });
    if (nearly) {
      const [from, to] = [Math.max(nearly[0] ?? 0, 0), Math.min(nearly[1] ?? high, high)];
      root.append(svg("rect", { class: "band", x: this.x(from), y: EDGE.top, width: Math.max(this.x(to) - this.x(from), 1), height: BOTTOM - EDGE.top }));
    }
    for (const tick of ticksOf(0, high, this.width / 90)) {
      root.append(svg("line", { class: "grid", x1: this.x(tick), x2: this.x(tick), y1: EDGE.top, y2: BOTTOM }), svg("text", { x: this.x(tick), y: BOTTOM + 16, "text-anchor": "middle" }, significant(tick, 3)));
    }
    root.append(svg("text", { x: (this.width + EDGE.left - EDGE.right) / 2, y: HEIGHT - 6, "text-anchor": "middle" }, this.gel.quantity));
    if (histogram) root.append(...this.bars(histogram));
    for (const at of objective ?? []) {
      root.append(svg("line", { class: "aimed", x1: this.x(at), x2: this.x(at), y1: EDGE.top, y2: BOTTOM }, svg("title", {}, "a threshold of the objective: the void should stay below both, the part above")));
    }
    if (curve.length > 1) {
      root.append(svg("path", { class: "curve", d: `M${curve.filter(([at]) => at <= high).map(([at, value]) => `${this.x(at).toFixed(1)},${y(value).toFixed(1)}`).join("L")}` }));
      for (const share of [0, 0.5, 1]) root.append(svg("text", { x: this.width - EDGE.right + 8, y: y(share) + 4 }, String(share)));
      root.append(svg("text", { x: this.width - EDGE.right + 8, y: EDGE.top - 10 }, "IoU"));
    }
    root.append(
      svg("line", { class: "base", x1: EDGE.left, x2: this.width - EDGE.right, y1: BOTTOM, y2: BOTTOM }),
      svg("line", { class: "fixed", x1: this.x(reported), x2: this.x(reported), y1: EDGE.top, y2: BOTTOM }, svg("title", {}, "the report’s threshold")),
      this.line,
    );
    return root;
  }

  private bars(histogram: Histogram): SVGElement[] {
    const { low, high } = histogram;
    const most = Math.max(...histogram.part, ...histogram.void, 1);
    const top = Math.ceil(Math.log10(most + 1));
    const powers = Array.from({ length: top + 1 }, (_, power) => power).filter((power) => power % Math.ceil(top / 4) === 0);
    const labels = powers.map((power) => svg("text", { x: EDGE.left - 8, y: y(power / top) + 4, "text-anchor": "end" }, power === 0 ? "1" : exponent(power)));
    const sides = (["void", "part"] as const).map((side) => {
      const shares = histogram[side].map((count) => Math.log10(count + 1) / top);
      return svg("path", { class: `bars ${side}`, d: steps(shares, (i) => this.x(low + (i / shares.length) * (high - low))) });
    });
    return [...labels, ...sides];
  }

  private drawLine(): void {
    if (this.width === 0) return;
    const x = this.x(this.threshold);
    const iou = this.gel.iou(this.threshold);
    const isRight = x > this.width - 90;
    this.line.replaceChildren(
      svg("line", { class: "threshold-line", x1: x, x2: x, y1: EDGE.top - 8, y2: BOTTOM }),
      svg("text", { class: "threshold-label", x: x + (isRight ? -6 : 6), y: EDGE.top - 8, "text-anchor": isRight ? "end" : "start" }, significant(this.threshold, 3)),
    );
    if (iou !== null) this.line.append(svg("circle", { class: "threshold-dot", cx: x, cy: y(iou), r: 4.5 }));
  }
}

/** The height of a share of the axis. */
function y(share: number): number {
  return BOTTOM - share * (BOTTOM - EDGE.top);
}

/** An area of steps down to the axis. */
function steps(shares: number[], x: (i: number) => number): string {
  let path = `M${x(0).toFixed(1)},${y(0)}`;
  shares.forEach((share, i) => {
    path += `V${y(share).toFixed(1)}H${x(i + 1).toFixed(1)}`;
  });
  return `${path}V${y(0)}Z`;
}

/** About so many round numbers within a range. */
function ticksOf(low: number, high: number, count: number): number[] {
  const rough = (high - low) / Math.max(count, 2);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((n) => n * power >= rough) ?? 10) * power;
  const ticks: number[] = [];
  for (let tick = Math.ceil(low / step); tick * step <= high + 1e-9; tick++) ticks.push(tick * step);
  return ticks;
}
