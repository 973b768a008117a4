// Reads the data of the page and lays out its sections. Every section is a function of a context (section.ts).

import "./base.css";
import "./look.css";
import "./report/report.css";
import type { PageData } from "./data.ts";
import { h } from "./dom.ts";
import { film } from "./film.ts";
import { inTime } from "./in_time.ts";
import { look } from "./look.ts";
import { comparison } from "./report/compare/index.ts";
import { sections as reportSections } from "./report/index.ts";
import { navigation, scrollTo } from "./report/nav.ts";
import type { Context, Section } from "./section.ts";
import { solid } from "./solid.ts";
import { State } from "./state.ts";
import { Store } from "./store.ts";

/** Order on the page, by id: what was made, what it looks like, why, how. Sections that are not named follow. */
const ORDER = [...comparison.map(({ id }) => id), "head", "limits", "warnings", "look", "solid", "in-time", "time", "film"];

const all: Section[] = [look, solid, inTime, film, ...reportSections];

function ordered(sections: Section[]): Section[] {
  const place = (section: Section) => (ORDER.indexOf(section.id) + ORDER.length + 1) % (ORDER.length + 1);
  return [...sections].sort((a, b) => place(a) - place(b));
}

function show(data: PageData, state: State, app: HTMLElement): void {
  let end = new AbortController();
  const stores = data.runs.map((_, i) => new Store(data.served, i));
  const draw = () => {
    end.abort();
    end = new AbortController();
    const index = Math.min(state.get("run"), data.runs.length - 1);
    const context: Context = { data, run: data.runs[index], index, state, store: stores[index], stores, gone: end.signal };
    const mounted = ordered(all).flatMap((section) => {
      const element = mount(section, context);
      return element ? [{ section, element }] : [];
    });
    const listed = mounted.map(({ section }) => section).filter(({ title }) => title !== "");
    app.replaceChildren(navigation(listed, state, end.signal), ...mounted.map(({ element }) => element));
  };
  state.on(["run"], draw);
  draw();
  scrollTo(state.get("section"));
}

/** A section that fails says so in its place and leaves the others alone. */
function mount(section: Section, context: Context): HTMLElement | null {
  let body: HTMLElement | null;
  try {
    body = section.render(context);
  } catch (error) {
    body = h("p.problem", { role: "alert" }, `This section could not be drawn: ${String(error)}`);
  }
  if (body === null) return null;
  return h("section", { id: section.id, "aria-label": section.title || null }, section.title !== "" && h("h2", {}, section.title), body);
}

function start(): void {
  const app = document.getElementById("app");
  const text = document.getElementById("data")?.textContent;
  if (!app) return;
  try {
    show(JSON.parse(text ?? "") as PageData, new State(), app);
  } catch (error) {
    app.replaceChildren(h("p.problem", { role: "alert" }, `The data of this page could not be read: ${String(error)}`));
  }
}

start();
