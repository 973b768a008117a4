// The lights: their patterns, how long and how bright they shine, and how much of the device's light is used.

import { h } from "../dom.ts";
import type { Context } from "../section.ts";
import { clock, isNumber, NONE, quantity, significant, type Measure } from "./number.ts";
import { list, report, type Light } from "./schema.ts";
import { dataTable } from "./table.ts";
import { paragraphs } from "./text.ts";

/** A property of each light. */
type Row = [name: string, of: (light: Light) => string];

export function lights({ run }: Context): HTMLElement | null {
  const data = report(run);
  const own = list(data.lights);
  if (own.length === 0) return null;
  const heads = own.map((light, i) => light.name || (own.length > 1 ? `light ${i + 1}` : "value"));
  // What no light has is left out
  const rows = ROWS.map(([name, of]) => [name, ...own.map(of)]).filter(([, ...cells]) => cells.some((cell) => cell !== NONE && cell !== ""));
  const whole = own.length > 1 && isNumber(data.time_to_print_s) ? `All lights together take ${clock(data.time_to_print_s)}.` : null;
  return h("div", {}, ...paragraphs([whole, why(own)]), dataTable({ caption: "Lights", heads: ["", ...heads], rows }));
}

/** Where times come from, or what they need. */
function why(own: readonly Light[]): string | null {
  if (own.some((light) => light.irradiance)) return "The job's schedule says how long and how bright the light is.";
  if (own.some((light) => isNumber(light.budget?.time_s))) return null;
  return (
    "Times need `resin.critical_dose_mj_per_mm3` and `printer.peak_irradiance_mw_per_cm2`, and frames that follow each other at one rate: frames of a list of angles " +
    "(`light.angles.list_deg`) have no times."
  );
}

const budget = (light: Light) => light.budget ?? {};

const ROWS: Row[] = [
  ["Wavelength", (light) => quantity(light.wavelength_nm, "nm", 4)],
  ["Frames", (light) => significant(light.frames, 6)],
  ["Pixels of a frame", (light) => times([light.columns, light.rows])],
  ["Pixel pitch", pitch],
  ["Depth", (light) => quantity(light.bits, "bit")],
  ["White, over the whole exposure", (light) => quantity(light.full_scale, "", 4)],
  ["Device", (light) => (light.canvas ? `${times(light.canvas)} pixels` : "the patterns as they are")],
  ["White, while it shines", white],
  ["Time to print, or length of the schedule", (light) => clock(budget(light).time_s)],
  ["Turns of the vial", (light) => significant(budget(light).turns, 3)],
  ["White, of a frame over the whole print", (light) => quantity(budget(light).white_mj_per_mm2, "mJ/mm²")],
  ["Energy at the vial per turn", (light) => quantity(budget(light).energy_per_turn_mj, "mJ")],
  ["Energy at the vial in all", (light) => quantity(budget(light).energy_mj, "mJ")],
  ["Share of the device's light that is used", (light) => percent(budget(light).light_used)],
];

function times(sides: readonly Measure[]): string {
  return sides.map((side) => significant(side, 6)).join(" × ");
}

function pitch({ pitch_mm }: Light): string {
  const sides = (Array.isArray(pitch_mm) ? pitch_mm : [pitch_mm]).filter(isNumber);
  return sides.length > 0 ? `${sides.map((mm) => significant(1e3 * mm, 3)).join(" × ")} µm` : NONE;
}

function white({ irradiance }: Light): string {
  const own = irradiance?.white_mw_per_cm2;
  const peak = irradiance?.peak_mw_per_cm2;
  const share = isNumber(own) && isNumber(peak) && peak > 0 ? `, ${percent(own / peak)} of what the printer gives` : "";
  return quantity(own, "mW/cm²") + share;
}

function percent(share: Measure): string {
  return isNumber(share) ? `${significant(100 * share, 3)} %` : NONE;
}
