// A few values of which one is chosen, as buttons in a row.

import { h } from "../dom.ts";

export function choice<T extends string>(label: string, values: readonly T[], chosen: T, changed: (value: T) => void): HTMLElement {
  const buttons = values.map((value) => {
    const button = h("button", { type: "button", "aria-pressed": String(value === chosen) }, value);
    button.addEventListener("click", () => {
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
      changed(value);
    });
    return button;
  });
  return h("div.chosen", {}, h("span.quiet", {}, label), h("div.choice", { role: "group", "aria-label": label }, ...buttons));
}
