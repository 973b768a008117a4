// Which keys of the jobs differ. Jobs are TOML; a key is the path to it, as in messages of the command: `light[0].angles.count`.

import { parse } from "smol-toml";
import type { PageData } from "../../data.ts";
import { h } from "../../dom.ts";
import { isObject } from "../schema.ts";
import { dataTable } from "../table.ts";
import { named } from "./color.ts";

/** Where a run lies on the disk is no difference. */
const LEFT_OUT = "output.folder";

export type FlatJob = Map<string, string>;

/** All keys of a job with their values as text; none for a job that cannot be read. */
export function flatJob(job: string): FlatJob {
  const flat: FlatJob = new Map();
  try {
    flatten("", parse(job), flat);
  } catch {
    return new Map();
  }
  flat.delete(LEFT_OUT);
  return flat;
}

function flatten(path: string, value: unknown, flat: FlatJob): void {
  if (Array.isArray(value) && value.some(isObject)) {
    value.forEach((one, i) => flatten(`${path}[${i}]`, one, flat));
  } else if (isObject(value) && !(value instanceof Date)) {
    const inside = Object.entries(value);
    if (inside.length === 0 && path !== "") flat.set(path, "(defaults)");
    for (const [key, one] of inside) flatten(path === "" ? key : `${path}.${key}`, one, flat);
  } else {
    flat.set(path, typeof value === "string" ? value : value instanceof Date ? value.toISOString() : (JSON.stringify(value) ?? ""));
  }
}

/** Keys that are not the same in all jobs, with their values. */
export function differing(jobs: readonly FlatJob[]): [key: string, values: (string | undefined)[]][] {
  const keys = [...new Set(jobs.flatMap((job) => [...job.keys()]))].sort();
  const rows = keys.map((key): [string, (string | undefined)[]] => [key, jobs.map((job) => job.get(key))]);
  return rows.filter(([, values]) => values.some((value) => value !== values[0]));
}

export function jobs({ runs }: PageData): HTMLElement {
  const rows = differing(runs.map((run) => flatJob(run.job)));
  if (rows.length === 0) return h("p.quiet", {}, "Nothing: the jobs are the same, but for the folder they write to.");
  const heads = ["key", ...runs.map(named)];
  const body = rows.map(([key, values]) => [h("code", {}, key), ...values.map((value) => value ?? "–")]);
  return h("div.job-keys", {}, dataTable({ caption: "Keys of the jobs that differ", heads, rows: body, text: runs.map((_, i) => i + 1) }));
}
