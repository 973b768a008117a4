// The rows of a sweep as columns: axes with their levels, metrics with what the report says of them.

import type { Metric, PageData, SweepData, SweepRow, SweepValue } from "../../data.ts";
import { place, type Scale, viridis } from "../../paint.ts";
import { isNumber, NONE, significant, unitOf } from "../number.ts";
import { isObject } from "../schema.ts";

/** A range of positive values is logarithmic when its ends differ by this factor. */
const LOGARITHMIC = 100;

/** Crossed axes fill at least this share of all combinations; conditions leave some out. */
const CROSSED = 0.2;

export interface Column {
  name: string;
  /** For people. */
  title: string;
  /** As in report.json: conditions, filters and CSV use the same numbers. */
  unit: string;
  summary: string;
  better: Metric["better"];
  /** Place in the values of a row. */
  at: number;
}

export interface AxisColumn extends Column {
  /** Different values: numbers ascending, others as they come. */
  levels: SweepValue[];
  isNumeric: boolean;
  /** Level of each row. */
  levelOf: number[];
}

export class Model {
  readonly axes: AxisColumn[];
  readonly metrics: Column[];
  readonly rows: SweepRow[];
  /** Whether axes are crossed, so that a map has neighbors. */
  readonly isCrossed: boolean;

  constructor(
    readonly sweep: SweepData,
    metrics: PageData["metrics"],
  ) {
    this.rows = sweep.rows;
    this.axes = sweep.axes.map((name, at) => axisOf(name, at, sweep.rows));
    this.metrics = sweep.metrics.map((name, i) => metricOf(name, sweep.axes.length + i, metrics));
    const combinations = this.varying.reduce((product, { levels }) => product * levels.length, 1);
    this.isCrossed = this.varying.length > 1 && sweep.rows.length >= CROSSED * combinations;
  }

  get columns(): Column[] {
    return [...this.axes, ...this.metrics];
  }

  /** Axes with more than one value. */
  get varying(): AxisColumn[] {
    return this.axes.filter(({ levels }) => levels.length > 1);
  }

  value(row: number, column: Column): SweepValue {
    return this.rows[row].values[column.at] ?? null;
  }

  number(row: number, column: Column): number | null {
    const value = this.value(row, column);
    return isNumber(value) ? value : null;
  }

  text(row: number, column: Column, digits = 6): string {
    return textOf(this.value(row, column), digits);
  }

  /** "lower 0.4, upper 0.6" */
  point(row: number): string {
    return this.axes.map((axis) => `${axis.name} ${this.text(row, axis)}`).join(", ");
  }

  /** What became of a run, in words. */
  state(row: number): string {
    const { state, feasible } = this.rows[row];
    if (state !== "done") return state;
    if (row === this.sweep.best) return "best";
    return feasible === false ? "infeasible" : "done";
  }

  /** Colors of a metric, the same in every map of it. Null where no run has a number. */
  scale(metric: Column): Scale | null {
    const range = this.range(metric);
    return range && { ...range, map: viridis };
  }

  range(column: Column): Omit<Scale, "map"> | null {
    let [low, high] = [Infinity, -Infinity];
    this.rows.forEach((_, row) => {
      const value = this.number(row, column);
      if (value === null) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    });
    return low > high ? null : { low, high, logarithmic: low > 0 && high >= LOGARITHMIC * low };
  }
}

/** The title with its unit. */
export function heading({ title, unit }: Column): string {
  return unit === "" ? title : `${title}, ${unit}`;
}

/** A value as text: a table by its kind and what it sets ("ospw lower=0.4"). */
export function textOf(value: unknown, digits = 6): string {
  if (value === null || value === undefined) return NONE;
  if (typeof value === "number") return significant(value, digits);
  if (Array.isArray(value)) return value.map((one) => textOf(one, digits)).join(" ");
  if (!isObject(value)) return String(value);
  return Object.entries(value).map(([name, one]) => (isObject(one) ? `${name} ${textOf(one, digits)}`.trim() : `${name}=${textOf(one, digits)}`)).join(" ");
}

/** The share of a scale as a color's place, also where all values are equal. */
export function shareOf(scale: Omit<Scale, "map">, value: number): number {
  return scale.high > scale.low ? place({ ...scale, map: viridis }, value) : 0.5;
}

function axisOf(name: string, at: number, rows: SweepRow[]): AxisColumn {
  const keys = rows.map(({ values }) => JSON.stringify(values[at] ?? null));
  const known = new Map(keys.map((key, row) => [key, rows[row].values[at] ?? null]));
  const isNumeric = known.size > 0 && [...known.values()].every(isNumber);
  const entries = [...known];
  if (isNumeric) entries.sort(([, a], [, b]) => Number(a) - Number(b));
  const place = new Map(entries.map(([key], level) => [key, level]));
  return {
    name, at, title: name, unit: "", summary: "", better: "none", isNumeric,
    levels: entries.map(([, value]) => value),
    levelOf: keys.map((key) => place.get(key) ?? 0),
  };
}

/** `evaluation.pw` is described as the report's metric `pw`; a name from another table says which. */
function metricOf(name: string, at: number, metrics: PageData["metrics"]): Column {
  const [table, own, ...rest] = name.split(".");
  const known = rest.length === 0 && (table === "evaluation" || table === "optimization") ? metrics.find((metric) => metric.name === own) : undefined;
  if (!known) return { name, at, title: name, unit: "", summary: "", better: "none" };
  const title = table === "evaluation" ? known.title : `${known.title} (${table})`;
  return { name, at, title, unit: unitOf(known.unit).factor === 1 ? unitOf(known.unit).unit : known.unit, summary: known.summary, better: known.better };
}
