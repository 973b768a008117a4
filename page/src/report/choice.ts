// A few values of which one is chosen, named by a label, for what is no part of the address.

import { h } from "../dom.ts";
import { choice as bar } from "../controls.ts";

export function choice<T extends string>(label: string, values: readonly T[], chosen: T, changed: (value: T) => void): HTMLElement {
  let current: string = chosen;
  let press = () => {};
  const choose = (value: string) => {
    current = value;
    press();
    changed(value as T);
  };
  const options = values.map((value): [string, string] => [value, value]);
  return h("div.chosen", {}, h("span.quiet", {}, label), bar(label, options, () => current, choose, (call) => (press = call)));
}
