// Small pieces that sections share: a bar of choices, a legend of colors, a place that waits for arrays.

import { h } from "./dom.ts";
import type { Legend } from "./layers.ts";
import { css } from "./paint.ts";
import { significant } from "./report/number.ts";
import type { Context } from "./section.ts";

/** Draws when the arrays are there, and says what is wrong where they are not. */
export function later(context: Context, make: (context: Context) => Promise<HTMLElement>): HTMLElement {
  const place = h("div", { "aria-busy": "true" }, h("p.quiet", {}, "Unpacking the volumes…"));
  make(context)
    .then((element) => place.replaceChildren(element))
    .catch((error: unknown) => place.replaceChildren(problem(messageOf(error))))
    .finally(() => place.removeAttribute("aria-busy"));
  return place;
}

/** What went wrong, in its place. */
export function problem(text: string): HTMLElement {
  return h("p.problem", { role: "alert" }, text);
}

/** A place for what goes wrong later; hidden while nothing does. */
export function trouble(): { element: HTMLElement; say: (text: string | null) => void } {
  const element = problem("");
  const say = (text: string | null) => {
    element.textContent = text;
    element.hidden = text === null;
  };
  say(null);
  return { element, say };
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** A box to tick. */
export function toggle(text: string, checked: boolean, changed: (checked: boolean) => void, mark: HTMLElement | null = null): HTMLElement {
  const change = (event: Event) => changed((event.target as HTMLInputElement).checked);
  return h("label", {}, h("input", { type: "checkbox", checked, change }), mark, text);
}

/** More buttons than this would hide what they choose. */
const MOST_BUTTONS = 7;

/** A bar of buttons of which one is pressed; a list where there are many. */
export function choice(label: string, options: [value: string, text: string][], current: () => string, choose: (value: string) => void, listen: (call: () => void) => void): HTMLElement {
  if (options.length > MOST_BUTTONS) {
    const list = h("select", { change: () => choose(list.value) }, ...options.map(([value, text]) => h("option", { value }, text)));
    const press = () => (list.value = current());
    listen(press);
    press();
    return h("label", {}, label, list);
  }
  const buttons = options.map(([value, text]) => ({ value, button: h("button", { type: "button", click: () => choose(value) }, text) }));
  const press = () => buttons.forEach(({ value, button }) => button.setAttribute("aria-pressed", String(value === current())));
  listen(press);
  press();
  return h("div.choice", { role: "group", "aria-label": label }, ...buttons.map(({ button }) => button));
}

/** Colors and what they mean. */
export function legendOf(legend: Legend): HTMLElement {
  if ("keys" in legend) return h("p.color-keys", {}, ...legend.keys.map(([color, text]) => h("span", {}, h("i.tile", { style: `background: ${color}` }), text)));
  const { scale, label, mark } = legend;
  const stops = Array.from({ length: 17 }, (_, i) => css(scale.map(i / 16))).join(", ");
  const share = mark === null || !Number.isFinite(mark) ? null : (mark - scale.low) / (scale.high - scale.low);
  return h(
    "div.color-scale",
    {},
    h("span", {}, significant(scale.low, 3)),
    h("span.bar", { style: `background: linear-gradient(to right, ${stops})` }, share !== null && share >= 0 && share <= 1 && h("i", { style: `left: ${100 * share}%`, title: "gel threshold" })),
    h("span", {}, significant(scale.high, 3)),
    h("span.quiet", {}, scale.logarithmic ? `${label}, logarithmic` : label),
  );
}
