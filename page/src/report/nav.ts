// The list of sections: it stays in sight, follows the reader, and each entry is a link that can be shared.

import { h } from "../dom.ts";
import type { State } from "../state.ts";

export interface Entry {
  id: string;
  title: string;
}

/** The list; `gone` ends what it listens to. */
export function navigation(entries: readonly Entry[], state: State, gone: AbortSignal): HTMLElement {
  const links = new Map(entries.map(({ id, title }) => [id, link(id, title, state)]));
  const mark = (id: string) => {
    for (const [of, anchor] of links) {
      if (of === id) anchor.setAttribute("aria-current", "location");
      else anchor.removeAttribute("aria-current");
    }
    // In a narrow window the list is a row that scrolls
    const current = links.get(id);
    const row = current?.parentElement?.parentElement;
    if (current && row) row.scrollLeft = current.offsetLeft - row.clientWidth / 2 + current.offsetWidth / 2;
  };
  gone.addEventListener("abort", state.on(["section"], () => scrollTo(state.get("section"))));
  follow([...links.keys()], mark, gone);
  return h("nav.sections", { "aria-label": "Sections" }, h("ol", {}, ...[...links.values()].map((anchor) => h("li", {}, anchor))));
}

/** A link to a section that keeps the rest of the address. */
export function link(id: string, title: string, state: State): HTMLAnchorElement {
  return h(
    "a",
    {
      href: `#section=${id}`,
      click: (event: MouseEvent) => {
        if (event.ctrlKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        if (state.get("section") === id) scrollTo(id);
        else state.set({ section: id });
      },
    },
    title,
  );
}

/** Shows a section and gives it the focus, so that Tab goes on from there. */
export function scrollTo(id: string): void {
  const section = id === "" ? null : document.getElementById(id);
  if (!section) return;
  const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  section.scrollIntoView({ behavior: isCalm ? "auto" : "smooth" });
  section.tabIndex = -1;
  section.focus({ preventScroll: true });
}

/** Calls back with the section that the reader has come to. */
function follow(ids: readonly string[], changed: (id: string) => void, gone: AbortSignal): void {
  let last = "";
  let isWaiting = false;
  const look = () => {
    isWaiting = false;
    const line = window.innerHeight / 4;
    const passed = ids.filter((id) => (document.getElementById(id)?.getBoundingClientRect().top ?? Infinity) <= line);
    const now = passed.at(-1) ?? ids[0] ?? "";
    if (now === last) return;
    last = now;
    changed(now);
  };
  const soon = () => {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(look);
  };
  window.addEventListener("scroll", soon, { signal: gone, passive: true });
  soon();
}
