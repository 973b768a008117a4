// A chart: uPlot with axes that have units, a tooltip, a legend, keys, and the same values as a table.
//
// Colors are names of CSS variables and are read at every drawing, so that a change between light and dark needs a
// redrawing and nothing else. On a logarithmic axis a value of 0 stands at the bottom, whose label is "0": histories
// often end there, and a curve that vanishes says nothing.

import uPlot from "uplot";
import { h } from "../dom.ts";
import { isNumber, significant, type Measure } from "./number.ts";
import { dataTable } from "./table.ts";

export interface Axis {
  label: string;
  unit?: string;
  /** Logarithmic, unless a value lies below 0. */
  log?: boolean;
  /** Ends of the axis; without them the values decide. */
  from?: number;
  to?: number;
}

export interface Series {
  name: string;
  /** A CSS variable: "--part". */
  color: string;
  x: readonly Measure[];
  y: readonly Measure[];
  style?: "line" | "dashed" | "dotted" | "steps" | "dots";
  /** Fills the area down to the axis. */
  fill?: boolean;
  /** Left out of the legend, as a second line of the same name. */
  quiet?: boolean;
}

/** A place on the x axis, or a range of it. */
export interface Mark {
  name: string;
  color: string;
  from: number;
  to?: number;
}

export interface ChartOptions {
  title: string;
  x: Axis;
  y: Axis;
  series: readonly Series[];
  marks?: readonly Mark[];
  height?: number;
}

/** A chart, or null where no series has a number to draw. */
export function chart(options: ChartOptions): HTMLElement | null {
  const chart = new Chart(options);
  return chart.isEmpty ? null : chart.element;
}

type Point = readonly [x: number, y: number];

/** The pairs of numbers of a series in ascending x; what is missing is passed over, as metrics are not measured at every step. */
function points(series: Series): Point[] {
  const pairs: Point[] = [];
  series.x.forEach((x, i) => {
    const y = series.y[i];
    if (isNumber(x) && isNumber(y)) pairs.push([x, y]);
  });
  return pairs.sort((a, b) => a[0] - b[0]);
}

const FONT = '12px system-ui, "Segoe UI", Roboto, Arial, sans-serif';
const DASHES = { line: [], steps: [], dots: [], dashed: [6, 4], dotted: [2, 3] } satisfies Record<string, number[]>;

class Chart {
  readonly element: HTMLElement;
  readonly isEmpty: boolean;
  private readonly box = h("div.chart-box", { tabindex: "0", role: "img" });
  private readonly tip = h("div.chart-tip", { hidden: true });
  private readonly spoken = h("div.unseen", { "aria-live": "polite" });
  private readonly series: readonly Series[];
  private readonly lines: readonly Point[][];
  private readonly isLog: boolean;
  /** What is drawn instead of 0 on a logarithmic axis; null on one that needs none. */
  private readonly floor: number | null;
  private plot: uPlot | null = null;

  constructor(private readonly options: ChartOptions) {
    this.series = options.series;
    this.lines = options.series.map(points);
    const values = this.lines.flat().map(([, y]) => y);
    const positive = values.filter((y) => y > 0);
    this.isEmpty = values.length === 0;
    this.isLog = options.y.log === true && positive.length > 0 && values.every((y) => y >= 0);
    const hasZero = this.isLog && positive.length < values.length;
    this.floor = hasZero ? 10 ** (Math.floor(Math.log10(Math.min(...positive))) - 1) : null;

    this.box.append(this.tip);
    this.box.setAttribute("aria-label", this.summary());
    this.box.addEventListener("keydown", (event) => this.onKey(event));
    this.box.addEventListener("blur", () => this.plot?.setCursor({ left: -10, top: -10 }));
    this.element = h("div.chart", {}, this.legend(), this.box, this.spoken, this.asTable());
    followSize(this.box, (width) => this.resize(width));
    followTheme(this.box, () => this.plot?.redraw(false, true));
  }

  private data(): uPlot.AlignedData {
    const tables = this.lines.map((line) => [
      line.map(([x]) => x),
      line.map(([, y]) => (this.floor !== null && y <= 0 ? this.floor : y)),
    ]);
    // Empty lines keep their place
    return uPlot.join(tables as uPlot.AlignedData[]);
  }

  private resize(width: number): void {
    const height = this.options.height ?? 250;
    if (this.plot === null) this.begin(width);
    else this.plot.setSize({ width, height });
  }

  /** uPlot needs to know its width: it begins when the box has one. */
  private begin(width: number): void {
    const { x, y, height = 250 } = this.options;
    const ends = (axis: Axis) => (_: uPlot, low: number | null, high: number | null) => this.range(axis, low, high);
    this.plot = new uPlot(
      {
        width,
        height,
        legend: { show: false },
        padding: [10, 14, 0, 0],
        cursor: {
          y: false,
          drag: { x: false, y: false },
          points: { size: 8, fill: (_, i) => ink(this.series[i - 1]?.color ?? "--ink") },
        },
        scales: {
          x: { time: false, range: ends(x) },
          y: { distr: this.isLog ? 3 : 1, range: ends(y) },
        },
        axes: [this.axis(x, false), this.axis(y, true)],
        series: [{}, ...this.series.map((series) => drawn(series))],
        hooks: { drawAxes: [(u) => this.drawMarks(u)], setCursor: [(u) => this.showTip(u)] },
      },
      this.data(),
      this.box,
    );
  }

  private range(axis: Axis, low: number | null, high: number | null): uPlot.Range.MinMax {
    if (low === null || high === null) return [axis.from ?? 0, axis.to ?? 1];
    if (axis === this.options.y && this.isLog) return [rounded(low, Math.floor), rounded(high, Math.ceil)];
    if (axis === this.options.x) return widened(axis.from ?? low, axis.to ?? high);
    const [from, to] = uPlot.rangeNum(low, high, 0.08, true);
    return [axis.from ?? from, axis.to ?? to];
  }

  private axis(axis: Axis, isY: boolean): uPlot.Axis {
    return {
      label: axis.unit ? `${axis.label}, ${axis.unit}` : axis.label,
      labelSize: 20,
      labelGap: isY ? 2 : 0,
      labelFont: FONT,
      font: FONT,
      stroke: () => ink("--quiet"),
      grid: { stroke: () => ink("--line"), width: 1 },
      ticks: { stroke: () => ink("--line"), width: 1, size: 5 },
      space: isY ? 32 : 64,
      values: (_, splits) => splits.map((value) => this.tick(value, isY)),
      size: isY ? widthOfLabels : 34,
    };
  }

  private tick(value: number | null, isY: boolean): string {
    if (value === null) return "";
    return isY && value === this.floor ? "0" : significant(value, 6);
  }

  /** Vertical lines and bands, below the curves. */
  private drawMarks(u: uPlot): void {
    const { left, top, width, height } = u.bbox;
    const at = (value: number) => Math.min(Math.max(u.valToPos(value, "x", true), left), left + width);
    u.ctx.save();
    for (const mark of this.options.marks ?? []) {
      const [from, to] = [at(mark.from), at(mark.to ?? mark.from)];
      u.ctx.fillStyle = u.ctx.strokeStyle = ink(mark.color);
      if (mark.to !== undefined) {
        u.ctx.globalAlpha = 0.16;
        u.ctx.fillRect(from, top, Math.max(to - from, 1), height);
      } else {
        u.ctx.globalAlpha = 1;
        u.ctx.lineWidth = 1.5 * devicePixelRatio;
        u.ctx.setLineDash([5, 4].map((length) => length * devicePixelRatio));
        u.ctx.beginPath();
        u.ctx.moveTo(from, top);
        u.ctx.lineTo(from, top + height);
        u.ctx.stroke();
      }
    }
    u.ctx.restore();
  }

  /** The values at the cursor. */
  private showTip(u: uPlot): void {
    const { idx, left } = u.cursor;
    if (idx === null || idx === undefined || left === undefined || left < 0) {
      this.tip.hidden = true;
      return;
    }
    const x = u.data[0][idx] ?? 0;
    const rows = this.lines.flatMap((line, i) => {
      const series = this.series[i];
      const y = series && u.series[i + 1]?.show ? valueAt(line, x, series.style ?? "line") : null;
      return series && y !== null ? [{ series, y }] : [];
    });
    const { unit: xUnit, label } = this.options.x;
    const head = `${label} ${significant(x, 5)}${xUnit ? ` ${xUnit}` : ""}`;
    const value = (y: number) => `${significant(y, 5)}${this.options.y.unit ? ` ${this.options.y.unit}` : ""}`;
    const line = (row: (typeof rows)[number]) =>
      h("div", {}, swatch(row.series.color), h("span", {}, row.series.name), h("b", {}, value(row.y)));
    this.tip.replaceChildren(h("div", { class: "chart-tip-head" }, head), ...rows.map(line));
    this.tip.hidden = rows.length === 0;
    const isRight = left > u.over.clientWidth / 2;
    const edge = u.over.offsetLeft;
    this.tip.style.left = isRight ? "" : `${edge + left + 14}px`;
    this.tip.style.right = isRight ? `${this.box.clientWidth - edge - left + 14}px` : "";
    if (document.activeElement === this.box) {
      this.spoken.textContent = [head, ...rows.map((row) => `${row.series.name} ${value(row.y)}`)].join(", ");
    }
  }

  /** Arrow keys read the chart from value to value. */
  private onKey(event: KeyboardEvent): void {
    const u = this.plot;
    if (u === null) return;
    const last = u.data[0].length - 1;
    const now = u.cursor.idx ?? -1;
    const steps: Record<string, number> = { ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: last };
    const next = steps[event.key];
    if (next === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const x = u.data[0][Math.min(Math.max(next, 0), last)];
    if (x !== undefined) u.setCursor({ left: u.valToPos(x, "x"), top: u.over.clientHeight / 2 });
  }

  private legend(): HTMLElement {
    const entries = this.series
      .map((series, i) => ({ series, i }))
      .filter(({ series }) => !series.quiet && points(series).length > 0);
    const marks = (this.options.marks ?? []).map((mark) => h("span", {}, swatch(mark.color, mark.to === undefined ? "dashed" : "band"), mark.name));
    if (entries.length < 2 && marks.length === 0) return h("div", { class: "chart-legend", hidden: true });
    const button = ({ series, i }: (typeof entries)[number]) => {
      const entry = h("button", { type: "button", "aria-pressed": "true", title: "Hide or show" }, swatch(series.color, series.style), series.name);
      entry.addEventListener("click", () => {
        const show = entry.getAttribute("aria-pressed") !== "true";
        entry.setAttribute("aria-pressed", String(show));
        // Quiet lines of the same name follow
        this.series.forEach((other, k) => {
          if (k === i || (other.quiet && other.name === series.name)) this.plot?.setSeries(k + 1, { show });
        });
      });
      return entry;
    };
    return h("div", { class: "chart-legend" }, ...entries.map(button), ...marks);
  }

  /** The same values as a table, made when it is opened. */
  private asTable(): HTMLElement {
    const details = h("details", { class: "chart-table" }, h("summary", {}, "Show as table"));
    details.addEventListener("toggle", () => {
      details.querySelector(".scroll")?.remove();
      if (!(details as HTMLDetailsElement).open) return;
      const { x, y, title } = this.options;
      const [places, ...columns] = this.columns();
      const unit = y.unit ? `, ${y.unit}` : "";
      const heads = [x.unit ? `${x.label}, ${x.unit}` : x.label, ...this.series.map((series) => series.name + unit)];
      const rows = (places ?? []).map((place, row) => [significant(place, 6), ...columns.map((column) => significant(column[row], 6))]);
      details.append(dataTable({ heads, rows, caption: title }));
    });
    return details;
  }

  /** Places, then the values of every series there. */
  private columns(): Measure[][] {
    const places = [...new Set(this.lines.flat().map(([x]) => x))].sort((a, b) => a - b);
    const column = (line: readonly Point[]) => {
      const values = new Map(line);
      return places.map((place) => values.get(place));
    };
    return [places, ...this.lines.map(column)];
  }

  /** What a chart shows, for those who do not see it. */
  private summary(): string {
    const { title, x, y } = this.options;
    const text = (axis: Axis, values: number[]) => {
      const [low, high] = [significant(Math.min(...values), 3), significant(Math.max(...values), 3)];
      return `from ${low} to ${high}${axis.unit ? ` ${axis.unit}` : ""}`;
    };
    const drawnLines = this.lines.map((line, i) => ({ line, name: this.series[i]?.name ?? "" })).filter(({ line }) => line.length > 0);
    const places = drawnLines.flatMap(({ line }) => line.map(([at]) => at));
    const values = drawnLines.map(({ line, name }) => `${name === title ? "" : `${name} `}${text(y, line.map(([, value]) => value))}`);
    return `${title}: ${values.join("; ")}; over ${x.label} ${text(x, places)}. Arrow keys read values.`;
  }
}

/** What a line shows at a place: between its points too, as lines are drawn; null beyond its ends. */
function valueAt(line: readonly Point[], x: number, style: NonNullable<Series["style"]>): number | null {
  const next = line.findIndex(([at]) => at >= x);
  if (next < 0) return null;
  const [at, y] = line[next];
  if (at === x) return y;
  if (next === 0 || style === "dots") return null;
  const [before, from] = line[next - 1];
  return style === "steps" ? from : from + ((x - before) / (at - before)) * (y - from);
}

/** How uPlot draws a series. */
function drawn(series: Series): uPlot.Series {
  const style = series.style ?? "line";
  const isDots = style === "dots";
  const stepped = uPlot.paths.stepped?.({ align: 1 });
  return {
    label: series.name,
    stroke: () => ink(series.color),
    width: 2,
    dash: DASHES[style],
    points: { fill: () => ink("--sheet") },
    ...(series.fill ? { fill: () => faint(ink(series.color)) } : {}),
    ...(isDots ? { paths: () => null, points: { show: true, size: 10, width: 2, fill: () => ink(series.color) } } : {}),
    ...(style === "steps" && stepped ? { paths: stepped, points: { show: false } } : {}),
  };
}

/** A range that is not empty. */
function widened(low: number, high: number): uPlot.Range.MinMax {
  return low < high ? [low, high] : [low - 0.5, high + 0.5];
}

/** A number to one digit, as the ticks of a logarithmic axis are. */
function rounded(value: number, towards: (value: number) => number): number {
  const size = 10 ** Math.floor(Math.log10(value));
  return towards(value / size) * size;
}

/** Room for the widest label of the y axis. */
function widthOfLabels(u: uPlot, labels: string[] | null): number {
  u.ctx.save();
  u.ctx.font = FONT;
  const widths = (labels ?? []).map((label) => u.ctx.measureText(label ?? "").width);
  u.ctx.restore();
  return Math.ceil(Math.max(16, ...widths)) + 14;
}

/** The value of a CSS variable now. */
function ink(variable: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(variable).trim() || "#5a6775";
}

function faint(color: string): string {
  return `color-mix(in srgb, ${color} 22%, transparent)`;
}

/** A sample of a line, a band or a dot for legends. */
export function swatch(color: string, style: Series["style"] | "band" = "line"): HTMLElement {
  return h("i", { class: `swatch swatch-${style}`, style: `--swatch: var(${color})`, "aria-hidden": "true" });
}

/** Calls back with the width of an element, first when it is laid out. */
function followSize(element: HTMLElement, changed: (width: number) => void): void {
  let width = 0;
  const observer = new ResizeObserver(() => {
    const now = element.clientWidth;
    if (now === width || now === 0) return;
    width = now;
    changed(now);
  });
  observer.observe(element);
}

/** Calls back when the page changes between light and dark, while the element is part of it. */
function followTheme(element: HTMLElement, changed: () => void): void {
  const query = matchMedia("(prefers-color-scheme: dark)");
  const listener = () => {
    if (element.isConnected) changed();
    else query.removeEventListener("change", listener);
  };
  query.addEventListener("change", listener);
}
