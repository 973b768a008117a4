// The sections that are text, tables and curves, in the order of the page.

import type { Section } from "../section.ts";
import { ceiling } from "./ceiling.ts";
import { comparison } from "./compare/index.ts";
import { errors } from "./errors.ts";
import { head } from "./head.ts";
import { history } from "./history.ts";
import { job } from "./job.ts";
import { lights } from "./lights.ts";
import { exposureAndLimits } from "./limits.ts";
import { movies } from "./movies.ts";
import { notes, warnings } from "./notes.ts";
import { numbers } from "./numbers.ts";
import { objectives } from "./objectives.ts";
import { properties } from "./properties.ts";
import { published } from "./published.ts";
import { scenarios } from "./scenarios.ts";
import { species } from "./species.ts";
import { time } from "./time.ts";
import { timings } from "./timings.ts";

export const sections: Section[] = [
  ...comparison,
  { id: "head", title: "", render: head },
  { id: "warnings", title: "Please note", render: warnings },
  { id: "limits", title: "Exposure and limits", render: exposureAndLimits },
  { id: "errors", title: "How far the response is off", render: errors },
  { id: "species", title: "Several species", render: species },
  { id: "time", title: "The print in time", render: time },
  { id: "properties", title: "Predicted properties", render: properties },
  { id: "ceiling", title: "Quality against time", render: ceiling },
  { id: "scenarios", title: "Scenarios", render: scenarios },
  { id: "objectives", title: "Objectives", render: objectives },
  { id: "history", title: "History of the optimization", render: history },
  { id: "lights", title: "Light and time", render: lights },
  { id: "numbers", title: "All numbers", render: numbers },
  { id: "published", title: "Published numbers", render: published },
  { id: "movies", title: "Movies", render: movies },
  { id: "timings", title: "Where the time went", render: timings },
  { id: "notes", title: "How it was computed", render: notes },
  { id: "job", title: "The job", render: job },
];
