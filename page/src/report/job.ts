// The job with every default, to be read and copied.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { copyButton } from "./text.ts";

export function job({ run }: Context): HTMLElement | null {
  const text = run.job;
  if (!text) return null;
  return h(
    "div",
    {},
    h("details.fold", {}, h("summary", {}, "The job, with every default"), copyButton("Copy the job", () => text), h("pre.job", { tabindex: "0" }, text)),
  );
}
