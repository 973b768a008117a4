// Several species: how the lights drive each, what each prints alone, and what they print at one exposure.

import type { Metric } from "../data.ts";
import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Mark, type Series } from "./chart.ts";
import { headline, shown } from "./head.ts";
import { isNumber, significant, unitOf, type Measure } from "./number.ts";
import { list, report, type OneExposure, type Species } from "./schema.ts";
import { dataTable } from "./table.ts";
import { part } from "./text.ts";

export function species({ data, run }: Context): HTMLElement | null {
  const { species: all, one_exposure: one } = report(run);
  const own = list(all);
  if (own.length < 2) return null;
  const first = own[0]?.evaluation;
  const metrics = first ? headline(data, first) : [];
  return h(
    "div",
    {},
    h("p", {}, "The numbers at the head of the page are those of ", h("b", {}, own[0]?.name ?? ""), "."),
    h("ul.drives", {}, ...own.map((one) => h("li", {}, h("b", {}, one.name ?? ""), ` is ${drive(one)}.`))),
    part("Each alone", dataTable({ caption: "Each species alone", heads: ["", ...own.map((one) => one.name ?? "")], rows: metrics.map((metric) => row(metric, own)) })),
    one ? together(own, one) : null,
    curves(own, one),
  );
}

/** How the lights drive a species, in words. */
function drive({ driven_by }: Species): string {
  const acting = Object.entries(driven_by ?? {}).filter(([, factor]) => isNumber(factor) && factor !== 0);
  const words = (sign: number) => acting.filter(([, factor]) => Math.sign(factor ?? 0) === sign).map(([light, factor]) => `${significant(Math.abs(factor ?? 0), 3)} × ${light}`);
  const [driving, inhibiting] = [words(1), words(-1)];
  const verbs = [driving.length > 0 && `driven by ${driving.join(" and ")}`, inhibiting.length > 0 && `inhibited by ${inhibiting.join(" and ")}`];
  return verbs.filter(Boolean).join(", ") || "driven by no light";
}

function row(metric: Metric, own: readonly Species[]): (string | Node)[] {
  const { unit } = unitOf(metric.unit);
  const name = h("span", { title: metric.summary }, metric.title, unit !== "" && h("span.unit", {}, ` ${unit}`));
  return [name, ...own.map(({ evaluation }) => shown(metric, evaluation?.[metric.name] as Measure, 4))];
}

function together(own: readonly Species[], one: OneExposure): HTMLElement {
  const name = (of: Species) => (of.name && of.name === one.limited_by ? `${of.name} (limits it)` : (of.name ?? ""));
  const rows = own.map((of, i) => [name(of), significant(of.evaluation?.iou as Measure, 4), significant(of.evaluation?.gel_threshold, 3), significant(one.iou?.[i], 4)]);
  const intro =
    `A print has one exposure. Where all networks gel at the same dose, the species print together best at a dose of ${significant(one.gel_dose, 3)}: the last column. ` +
    "Each reaches the IoU of its own where its network gels at its own dose.";
  return part(
    "Together at one exposure",
    h("p", {}, intro),
    dataTable({ caption: "Species at one exposure", heads: ["species", "IoU alone", "at a threshold of", "IoU together"], rows, strong: 3 }),
  );
}

/** IoU of all species over the threshold. */
function curves(own: readonly Species[], one: OneExposure | null | undefined): HTMLElement | null {
  const series = own.map(({ name, evaluation }, i): Series => {
    const curve = list(evaluation?.iou_curve);
    return { name: name ?? "", color: `--run-${(i % 6) + 1}`, x: curve.map((point) => point?.[0]), y: curve.map((point) => point?.[1]) };
  });
  // A gel dose stands on an axis of responses only where the response is the dose
  const isDose = own.every(({ exposure }) => exposure?.dose?.best === exposure?.threshold?.best);
  const marks: Mark[] = one && isDose && isNumber(one.gel_dose) ? [{ name: "one exposure", color: "--threshold", from: one.gel_dose }] : [];
  const drawn = chart({ title: "IoU of each species over the gel threshold", x: { label: "gel threshold", from: 0 }, y: { label: "IoU", from: 0, to: 1 }, series, marks });
  return drawn && part("How much the threshold matters to each", drawn);
}
