// Numbers with other authors' signs and normalizations, to be compared with papers and other programs.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { chart, type Series } from "./chart.ts";
import { isNumber, NONE, significant, type Measure } from "./number.ts";
import { isObject, report } from "./schema.ts";
import { dataTable } from "./table.ts";
import { part } from "./text.ts";

interface Published {
  name: string;
  value: Measure;
  unit: string;
  note: string;
  source: string;
}

export function published({ run }: Context): HTMLElement | null {
  const all = Object.entries(report(run).published ?? {});
  const rows = all.flatMap(([name, about]) => (isObject(about) && typeof about["source"] === "string" ? [read(name, about)] : []));
  const others = all.filter(([name, about]) => name !== "slices" && !(isObject(about) && typeof about["source"] === "string"));
  const slices = slicesOf(report(run).published?.["slices"]);
  if (rows.length === 0 && others.length === 0) return null;
  return h("div", {}, rows.length > 0 && filtered(rows), slices, ...others.map(([name, about]) => part(words(name), anything(about))));
}

function read(name: string, about: Record<string, unknown>): Published {
  const text = (key: string) => (typeof about[key] === "string" ? (about[key] as string) : "");
  return { name, value: about["value"] as Measure, unit: text("unit"), note: text("note"), source: text("source") };
}

/** The list, and a field that narrows it. */
function filtered(rows: readonly Published[]): HTMLElement {
  const place = h("div");
  const count = h("span.quiet", { "aria-live": "polite" });
  const field = h("input", { type: "search", placeholder: "jaccard, Dr.TVAM, eq. 12, …", "aria-label": "Filter the published numbers" });
  const draw = () => {
    const wanted = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const text = (row: Published) => `${row.name} ${row.note} ${row.source} ${row.unit}`.toLowerCase();
    const found = rows.filter((row) => wanted.every((word) => text(row).includes(word)));
    count.textContent = found.length === rows.length ? `${rows.length} numbers` : `${found.length} of ${rows.length} numbers`;
    const cells = (row: Published) => [h("code", {}, row.name), significant(row.value, 4), row.unit, row.note, row.source];
    const heads = ["name", "value", "unit", "definition", "source"];
    const none = h("p.note", {}, "No number has all of these words in its name, definition or source.");
    place.replaceChildren(found.length === 0 ? none : dataTable({ caption: "Published numbers", heads, rows: found.map(cells), text: [2, 3, 4] }));
  };
  field.addEventListener("input", draw);
  draw();
  return h("details.fold", {}, h("summary", {}, `${rows.length} numbers as other authors and programs define them`), h("label.filter", {}, "Filter ", field, " ", count), place);
}

/** Process window, dose range and error rate of each slice. */
function slicesOf(slices: unknown): HTMLElement | null {
  const rows = Array.isArray(slices) ? slices.filter(isObject) : [];
  const column = (name: string) => rows.map((row) => row[name] as Measure);
  const z = column("z_mm");
  const line = (name: string, color: string, key: string): Series => ({ name, color, x: z, y: column(key) });
  const x = { label: "z", unit: "mm" };
  const doses = chart({
    title: "Dose of each slice over z",
    x,
    y: { label: "response" },
    series: [line("process window", "--run-1", "pw"), line("range in the part", "--run-2", "ipdr")],
  });
  const errors = chart({ title: "Voxel error rate of each slice over z", x, y: { label: "voxel error rate", from: 0 }, series: [line("voxel error rate", "--run-1", "ver")] });
  if (!doses && !errors) return null;
  return part("Slice by slice", h("div.charts", {}, doses && h("div", {}, doses), errors && h("div", {}, errors)));
}

/** What has no form of its own: nested lists and tables of names and values. */
function anything(value: unknown): Node | string {
  if (isNumber(value)) return significant(value, 4);
  if (value === null || value === undefined) return NONE;
  if (Array.isArray(value)) {
    if (value.every((one) => !isObject(one))) return value.map((one) => (isNumber(one) ? significant(one, 4) : String(one ?? NONE))).join(" ");
    const heads = [...new Set(value.filter(isObject).flatMap((one) => Object.keys(one)))];
    const cells = (one: unknown) => heads.map((name) => (isObject(one) ? anything(one[name]) : String(one)));
    return dataTable({ heads: heads.map(words), rows: value.map(cells) });
  }
  if (!isObject(value)) return String(value);
  return dataTable({ heads: ["", "value"], rows: Object.entries(value).map(([name, one]) => [words(name), anything(one)]) });
}

const NAMES: Record<string, string> = {
  keep_dark: "Bodies that are to stay dark",
  insert: "Surface of the inserts",
  insert_mm2: "In all, mm²",
  target_mm2: "Touched by the target, mm²",
  print_mm2: "Touched by the print, mm²",
  share: "Share that the print touches",
  of_target: "Share of what the target touches that the print touches too",
  part_mean: "Mean of the part",
  paths: "Scattering by Monte Carlo paths",
  orders: "Scattering, order by order",
  unit_systems: "In the units of others",
};

/** A key for people: "volume_mm3" as "Volume, mm³". */
function words(key: string): string {
  const given = NAMES[key];
  if (given !== undefined) return given;
  const unit = /_(mm3|mm2|mm)$/.exec(key);
  const name = (unit ? key.slice(0, unit.index) : key).replaceAll("_", " ");
  const text = name.charAt(0).toUpperCase() + name.slice(1);
  return unit ? `${text}, ${unit[1]?.replace("3", "³").replace("2", "²")}` : text;
}
