// Numbers as people read them: significant digits, a true minus sign, units.
//
//   significant(0.99876, 4)  "0.9988"      significant(12345.6, 3)  "12,300"
//   significant(0.000021, 2) "2.1·10⁻⁵"    significant(null, 3)     "–"
//
// The same rules as crates/tomolith-report/src/number.rs, so that sentences from Rust and tables from here agree.

export type Measure = number | null | undefined;

const RAISED: Record<string, string> = {
  "-": "⁻", "0": "⁰", "1": "¹", "2": "²", "3": "³", "4": "⁴", "5": "⁵", "6": "⁶", "7": "⁷", "8": "⁸", "9": "⁹",
};

/** What stands for a number that is not defined. */
export const NONE = "–";

export function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

/** A power of ten: "10⁻³". */
export function exponent(power: number): string {
  return "10" + [...String(power)].map((c) => RAISED[c] ?? c).join("");
}

/** A number with so many significant digits: plain from 10⁻³ to 10⁶, as a power of ten beyond. */
export function significant(value: Measure, digits: number): string {
  if (!isNumber(value)) return NONE;
  if (value === 0) return "0";
  const rounded = Math.abs(value).toExponential(Math.max(digits - 1, 0));
  const [mantissa = "0", powerText = "0"] = rounded.split("e");
  const power = Number(powerText);
  const sign = value < 0 ? "−" : "";
  if (power >= -3 && power < 6) {
    return sign + trimmed(Number(rounded).toFixed(Math.max(digits - 1 - power, 0)));
  }
  return sign + (trimmed(mantissa) === "1" ? exponent(power) : `${trimmed(mantissa)}·${exponent(power)}`);
}

/** Numbers next to each other: as many digits, up to 7, as keep apart those that differ. */
export function toldApart(values: readonly number[], digits: number): string[] {
  for (let more = digits; more < 7; more++) {
    const texts = values.map((value) => significant(value, more));
    const isClear = values.every((a, i) => values.every((b, j) => j >= i || a === b || texts[i] !== texts[j]));
    if (isClear) return texts;
  }
  return values.map((value) => significant(value, 7));
}

/** Seconds as a duration: "1 min 15 s". */
export function clock(seconds: Measure): string {
  if (!isNumber(seconds)) return NONE;
  const whole = Math.round(seconds);
  if (whole < 60) return `${significant(seconds, 3)} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  return `${Math.floor(whole / 3600)} h ${Math.floor(whole / 60) % 60} min`;
}

/** How the page writes a unit of report.json: lengths in µm, "response" has no unit. */
export function unitOf(unit: string): { unit: string; factor: number } {
  if (unit === "mm") return { unit: "µm", factor: 1e3 };
  // N·M/t, which its name says
  if (unit.startsWith("mm (")) return { unit: "mm", factor: 1 };
  return { unit: unit === "response" ? "" : unit, factor: 1 };
}

/** A number and its unit: "0.23 mm³". */
export function quantity(value: Measure, unit: string, digits = 3): string {
  if (!isNumber(value)) return NONE;
  return unit === "" ? significant(value, digits) : `${significant(value, digits)} ${unit}`;
}

/** A length in voxels: "0.24 voxels"; empty for what is not a length. */
export function inVoxels(value: Measure, unit: string, pitchMm: Measure): string {
  if (unit !== "mm" || !isNumber(value) || !isNumber(pitchMm) || pitchMm <= 0) return "";
  const count = significant(value / pitchMm, 2);
  return count === "1" ? "1 voxel" : `${count} voxels`;
}

/** Without zeros at the end, and with commas between thousands. */
function trimmed(text: string): string {
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  const [whole = "", rest] = short.split(".");
  const grouped = whole.replace(/\B(?=(\d{3})+$)/g, ",");
  return rest === undefined ? grouped : `${grouped}.${rest}`;
}
