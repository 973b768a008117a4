// What a page of several runs shows before the run that was chosen.

import type { Comparison } from "../../data.ts";
import type { Context, Section } from "../../section.ts";
import { histories, thresholds } from "./curves.ts";
import { doses } from "./doses.ts";
import { head } from "./head.ts";
import { jobs } from "./jobs.ts";
import { cautions, numbers } from "./numbers.ts";

/** Drawn for several runs only. */
function ofSeveral(render: (context: Context) => HTMLElement | null): Section["render"] {
  return (context) => (context.data.runs.length > 1 ? render(context) : null);
}

/** Drawn where the command has compared the runs. */
function compared(render: (compare: Comparison, context: Context) => HTMLElement | null): Section["render"] {
  return ofSeveral((context) => (context.data.compare ? render(context.data.compare, context) : null));
}

export const comparison: Section[] = [
  { id: "compare", title: "", render: ofSeveral(({ data, index, state }) => head(data, index, state)) },
  { id: "cautions", title: "Before you compare", render: compared(cautions) },
  { id: "side-by-side", title: "Numbers side by side", render: compared((compare, { data }) => numbers(compare, data.runs, data.metrics)) },
  { id: "job-keys", title: "What differs in the jobs", render: compared((compare, { data }) => jobs(compare, data.runs)) },
  { id: "doses", title: "Doses", render: ofSeveral(doses) },
  { id: "thresholds", title: "Thresholds", render: ofSeveral(({ data }) => thresholds(data)) },
  { id: "histories", title: "Histories", render: ofSeveral(({ data }) => histories(data)) },
];
