// Reads the data of the page and lays out its sections. Every section is a function of a context (section.ts).

import "./base.css";
import "./look.css";
import "./report/report.css";
import "./report/sweep/sweep.css";
import type { PageData } from "./data.ts";
import { h } from "./dom.ts";
import { film } from "./film.ts";
import { inTime } from "./in_time.ts";
import { live, openedIn, refetched } from "./live.ts";
import { look } from "./look.ts";
import { comparison } from "./report/compare/index.ts";
import { sections as reportSections } from "./report/index.ts";
import { navigation, scrollTo } from "./report/nav.ts";
import { Sweep } from "./report/sweep/index.ts";
import type { Context, Section } from "./section.ts";
import { solid } from "./solid.ts";
import { State } from "./state.ts";
import { Store } from "./store.ts";

/** Order on the page, by id: what was made, what it looks like, why, how. Sections that are not named follow. */
const ORDER = [...comparison.map(({ id }) => id), "head", "limits", "warnings", "look", "solid", "in-time", "time", "film"];

const SECTIONS = ordered([look, solid, inTime, film, ...reportSections]);

/** Sections that take new volumes of a run that goes on without being drawn anew. */
const RENEWING = ["look", "solid"];

/** Sections that show rows of the history, and how often they are drawn again while a run goes on, ms. */
const GROWING = ["history", "histories"];
const REDRAW_MS = 700;

/** How long a page takes to unpack its arrays, at most, ms. */
const SETTLE_MS = 6000;

function ordered(sections: Section[]): Section[] {
  const place = (section: Section) => (ORDER.indexOf(section.id) + ORDER.length + 1) % (ORDER.length + 1);
  return [...sections].sort((a, b) => place(a) - place(b));
}

class Page {
  private readonly state = new State();
  private readonly progress: HTMLElement | null;
  private stores: Store[];
  private ends = new Map<string, AbortController>();
  private readonly contexts = new Map<string, Context>();
  private redrawing = 0;
  private readonly sweep: Sweep | null;
  /** Place in the list of runs of the run of a sweep that is open. */
  private opened: number | null = null;

  constructor(
    private data: PageData,
    private readonly app: HTMLElement,
  ) {
    this.stores = data.runs.map((_, run) => new Store(data.served, run));
    this.state.on(["run"], () => this.draw());
    this.progress = live(data, {
      row: (run) => this.grow(run),
      replaced: (run) => void this.replace(run).catch((error: unknown) => console.warn(String(error))),
      ended: () => this.redraw(["head"]),
    });
    this.sweep = data.sweep && new Sweep(data, data.sweep, this.state, (row) => this.open(row));
    this.draw();
    this.stayAt(this.state.get("section") || (this.state.get("opened") === null ? "" : "opened"));
  }

  /** Sections grow as their arrays are unpacked: the one that the address names stays in sight until the reader does something. */
  private stayAt(id: string): void {
    if (id === "") return;
    scrollTo(id);
    const keep = new ResizeObserver(() => document.getElementById(id)?.scrollIntoView());
    const stop = () => keep.disconnect();
    keep.observe(this.app);
    window.setTimeout(stop, SETTLE_MS);
    for (const kind of ["wheel", "pointerdown", "keydown", "touchstart"]) window.addEventListener(kind, stop, { once: true, passive: true });
  }

  /** The run that is shown; null where there is none. */
  private get index(): number | null {
    if (this.sweep) return this.opened;
    return this.data.runs.length === 0 ? null : Math.min(this.state.get("run"), this.data.runs.length - 1);
  }

  /** Shows the run of a row of the sweep, or none. */
  private async open(row: number | null): Promise<void> {
    const opening = this.begin("opening");
    if (this.opened !== null) {
      this.opened = null;
      this.draw();
    }
    if (row === null) return;
    const run = await openedIn(this.data, row);
    const { runs } = await refetched(this.data);
    if (opening.aborted) return;
    this.data.runs.push(...runs.slice(this.data.runs.length));
    this.stores = this.data.runs.map((_, i) => this.stores[i] ?? new Store(this.data.served, i));
    this.opened = run;
    this.draw();
  }

  private draw(): void {
    for (const section of SECTIONS) this.ends.get(section.id)?.abort();
    const mounted = SECTIONS.flatMap((section) => {
      const element = this.mount(section);
      return element ? [{ section, element }] : [];
    });
    const listed = mounted.map(({ section }) => section).filter(({ title }) => title !== "");
    const nav = navigation([...(this.sweep?.entries ?? []), ...listed], this.state, this.begin("nav"));
    const above = [this.progress, ...(this.sweep?.sections ?? [])].filter((element) => element !== null);
    // What stays is not moved: it keeps the focus
    for (const child of [...this.app.children]) if (!above.includes(child as HTMLElement)) child.remove();
    this.app.append(...above.filter((element) => !element.isConnected), ...mounted.map(({ element }) => element));
    if (this.progress) this.progress.after(nav);
    else this.app.prepend(nav);
    if (this.index === null && !this.sweep) this.app.append(h("p.problem", {}, "There is no run to show."));
  }

  /** What a part of the page listens to ends when it is drawn again. */
  private begin(id: string): AbortSignal {
    this.ends.get(id)?.abort();
    const end = new AbortController();
    this.ends.set(id, end);
    return end.signal;
  }

  /** A section that fails says so in its place and leaves the others alone. */
  private mount(section: Section): HTMLElement | null {
    const { index, state, sweep } = this;
    if (index === null) return null;
    const run = this.data.runs[index];
    // Runs of a sweep that were opened before are no part of the page
    const [data, stores] = sweep ? [{ ...this.data, runs: [run] }, [this.stores[index]]] : [this.data, this.stores];
    const context: Context = { data, run, index: sweep ? 0 : index, state, store: this.stores[index], stores, gone: this.begin(section.id), renewed: new EventTarget() };
    this.contexts.set(section.id, context);
    let body: HTMLElement | null;
    try {
      body = section.render(context);
    } catch (error) {
      body = h("p.problem", { role: "alert" }, `This section could not be drawn: ${String(error)}`);
    }
    if (body === null) return null;
    return h("section", { id: section.id, "aria-label": section.title || null }, section.title !== "" && h("h2", {}, section.title), body);
  }

  /** The history of a run has grown. */
  private grow(run: number): void {
    if (this.redrawing !== 0 || (run !== this.index && this.data.runs.length === 1)) return;
    this.redrawing = window.setTimeout(() => {
      this.redrawing = 0;
      this.redraw(GROWING);
    }, REDRAW_MS);
  }

  /** A run has new numbers and arrays. While it goes on only its volumes are new. */
  private async replace(run: number): Promise<void> {
    const fresh = await refetched(this.data);
    this.data.runs[run] = fresh.runs[run];
    this.stores[run] = new Store(this.data.served, run);
    if (run !== this.index && this.data.runs.length === 1) return;
    if (fresh.runs[run].state !== "running") return this.draw();
    const [old, first] = [0, 1].map((isFirst) => RENEWING.filter((id) => (document.getElementById(id) === null) === (isFirst === 1)));
    this.redraw([...GROWING, ...first]);
    for (const id of old) this.renew(id, run);
  }

  /** Gives a section the new volumes of the run that it shows. */
  private renew(id: string, run: number): void {
    const context = this.contexts.get(id);
    if (!context || run !== this.index) return;
    Object.assign(context, { run: this.data.runs[run], store: this.stores[run], stores: this.stores });
    context.renewed.dispatchEvent(new Event("renewed"));
  }

  /** Draws some sections again. What has the focus keeps it. */
  private redraw(ids: string[]): void {
    const name = document.activeElement?.getAttribute("aria-label") ?? null;
    for (const section of SECTIONS.filter(({ id }) => ids.includes(id))) {
      const old = document.getElementById(section.id);
      const element = this.mount(section);
      if (old && element) old.replaceWith(element);
      // A section that has just got its first data comes into the list too
      else if (element) return this.draw();
    }
    if (name !== null) window.setTimeout(() => document.querySelector<HTMLElement>(`[aria-label="${CSS.escape(name)}"]`)?.focus({ preventScroll: true }), 50);
  }
}

/** The data, if they are those of a page that this program knows. */
function checked(data: PageData | null): PageData {
  const schema: PageData["schema"] = "tomolith.page/2";
  if (data?.schema !== schema) throw new Error(`their schema is “${data?.schema ?? "missing"}”; this page shows “${schema}”.`);
  if (!Array.isArray(data.runs)) throw new Error("the list of runs is missing.");
  return data;
}

function start(): void {
  const app = document.getElementById("app");
  const text = document.getElementById("data")?.textContent;
  if (!app) return;
  try {
    new Page(checked(JSON.parse(text ?? "")), app);
  } catch (error) {
    app.replaceChildren(h("p.problem", { role: "alert" }, `The data of this page could not be read: ${error instanceof Error ? error.message : String(error)}`));
  }
}

start();
