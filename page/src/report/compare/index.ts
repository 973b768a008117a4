// What a page of several runs shows before the run that was chosen.

import type { Context, Section } from "../../section.ts";
import { histories, thresholds } from "./curves.ts";
import { doses } from "./doses.ts";
import { head } from "./head.ts";
import { jobs } from "./jobs.ts";
import { cautions, numbers } from "./numbers.ts";

/** Shown for several runs only. */
function ofSeveral(render: (context: Context) => HTMLElement | null): Section["render"] {
  return (context) => (context.data.runs.length > 1 ? render(context) : null);
}

export const comparison: Section[] = [
  { id: "compare", title: "", render: ofSeveral(({ data, index, state }) => head(data, index, state)) },
  { id: "cautions", title: "Before you compare", render: ofSeveral(({ data }) => cautions(data)) },
  { id: "side-by-side", title: "Numbers side by side", render: ofSeveral(({ data }) => numbers(data)) },
  { id: "job-keys", title: "What differs in the jobs", render: ofSeveral(({ data }) => jobs(data)) },
  { id: "doses", title: "Doses", render: ofSeveral(doses) },
  { id: "thresholds", title: "Thresholds", render: ofSeveral(({ data }) => thresholds(data)) },
  { id: "histories", title: "Histories", render: ofSeveral(({ data }) => histories(data)) },
];
