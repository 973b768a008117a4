// Runs that go on while they are looked at: stage, progress, a button that cancels. The viewer sends what happens as server-sent events.

import type { PageData, Run } from "./data.ts";
import { messageOf } from "./controls.ts";
import { h } from "./dom.ts";
import { clock } from "./report/number.ts";

type Happening =
  | { type: "states"; states: Run["state"][] }
  | { type: "stage"; run: number; name: string }
  | { type: "part"; run: number; fraction: number; left_s: number | null }
  | { type: "iteration"; run: number; row: { [column: string]: number | null }; iterations: number | null }
  | { type: "snapshot" | "done"; run: number }
  | { type: "failed" | "canceled"; run: number; message: string };

export interface Changes {
  /** A row was added to the history of a run. */
  row(run: number): void;
  /** Arrays or numbers of a run are new. */
  replaced(run: number): void;
  /** A run has ended without a result. */
  ended(run: number): void;
}

/** What is left of a run without a result. */
const LAST = "This page shows what there was last; it cannot be loaded again.";

/** Follows the runs of a viewer. Null where the page is a file. */
export function live(data: PageData, changes: Changes): HTMLElement | null {
  if (data.served === null) return null;
  const { served } = data;
  const element = h("div.live", { role: "status" });
  const bars = new Map<number, Bar>();
  const bar = (run: number) => {
    let known = bars.get(run);
    if (!known) {
      known = new Bar(data.runs[run].name, () => fetch(`${served}cancel/${run}`, { method: "POST" }));
      bars.set(run, known);
      element.append(known.element);
    }
    return known;
  };
  data.runs.forEach(({ state }, run) => {
    if (state === "running") bar(run);
  });
  const problem = h("p.problem", { hidden: true }, "The viewer does not answer. What is shown is the last that it sent; it is asked again.");
  element.append(problem);

  const events = new EventSource(`${served}events`);
  events.addEventListener("error", () => (problem.hidden = false));
  events.addEventListener("open", () => (problem.hidden = true));
  events.addEventListener("message", ({ data: text }: MessageEvent<string>) => {
    const event = JSON.parse(text) as Happening;
    if (event.type === "states") {
      // The page may be older than the connection
      event.states.forEach((state, run) => {
        if (data.runs[run] && data.runs[run].state !== state) changes.replaced(run);
      });
      return;
    }
    const run = data.runs[event.run];
    if (!run) return;
    switch (event.type) {
      case "stage":
        bar(event.run).stage(event.name);
        break;
      case "part":
        bar(event.run).part(event.fraction, event.left_s);
        break;
      case "iteration":
        addRow(run.history, event.row);
        bar(event.run).iteration(event.row.iteration ?? null, event.iterations);
        changes.row(event.run);
        break;
      case "failed":
      case "canceled":
        run.state = event.type;
        bar(event.run).end(`${event.message} ${LAST}`);
        changes.ended(event.run);
        // The command ends with its run: nobody is there to be asked
        if (data.runs.every(({ state }) => state !== "running")) events.close();
        break;
      case "done":
        bar(event.run).end(null);
        bars.delete(event.run);
        changes.replaced(event.run);
        break;
      case "snapshot":
        changes.replaced(event.run);
        break;
    }
  });
  return element;
}

/** The data of the viewer as they are now. */
export async function refetched(data: PageData): Promise<PageData> {
  const answer = await fetch(`${data.served}runs.json`);
  if (!answer.ok) throw new Error(`The viewer answered ${answer.status}.`);
  return (await answer.json()) as PageData;
}

/** The place in the list of runs of a row of the sweep, which the viewer then reads. */
export async function openedIn({ served }: PageData, row: number): Promise<number> {
  const answer = await fetch(`${served}open/${row}`);
  if (!answer.ok) throw new Error((await answer.text()) || `The viewer answered ${answer.status}: the folder of this run is not there.`);
  return ((await answer.json()) as { run: number }).run;
}

/** Columns that a row has and the history has not begin with nothing. */
function addRow(history: PageData["runs"][number]["history"], row: { [column: string]: number | null }): void {
  const length = Math.max(0, ...Object.values(history).map((column) => column.length));
  for (const name of new Set([...Object.keys(history), ...Object.keys(row)])) {
    history[name] ??= new Array<null>(length).fill(null);
    history[name].push(row[name] ?? null);
  }
}

/** The progress of a run. */
class Bar {
  private readonly progress = h("progress", { max: 1 });
  private readonly text = h("span.quiet", {}, "waiting");
  private readonly cancel: HTMLButtonElement;
  private readonly refusal = h("span.problem", { role: "alert", hidden: true });
  readonly element: HTMLElement;
  private name = "";

  constructor(run: string, cancel: () => Promise<Response>) {
    this.cancel = h("button", { type: "button" }, "Cancel");
    const press = (text: string, disabled: boolean) => {
      this.cancel.textContent = text;
      this.cancel.disabled = disabled;
    };
    const ask = async () => {
      press("Canceling…", true);
      this.refusal.hidden = true;
      const answer = await cancel();
      if (!answer.ok) throw new Error(`The viewer refused to cancel the run (it answered ${answer.status}).`);
    };
    const failed = (error: unknown) => {
      press("Cancel", false);
      this.refusal.hidden = false;
      this.refusal.textContent = error instanceof TypeError ? "The viewer does not answer, so the run was not canceled." : messageOf(error);
    };
    this.cancel.addEventListener("click", () => void ask().catch(failed));
    this.progress.setAttribute("aria-label", `Progress of ${run}`);
    this.element = h("div.live-run", {}, h("b", {}, run), this.progress, this.text, this.cancel, this.refusal);
  }

  stage(name: string): void {
    this.name = name;
    this.show(null, null);
  }

  part(fraction: number, left_s: number | null): void {
    // What comes after a part that is done has yet to say how long it takes
    if (fraction >= 1) this.show(null, null);
    else this.show(fraction, `${Math.round(100 * fraction)} %${left_s === null ? "" : `, ${clock(left_s)} left`}`);
  }

  iteration(iteration: number | null, iterations: number | null): void {
    if (iteration === null) return;
    this.show(iterations ? iteration / iterations : null, `iteration ${iteration}${iterations ? ` of at most ${iterations}` : ""}`);
  }

  private show(fraction: number | null, detail: string | null): void {
    if (fraction === null) this.progress.removeAttribute("value");
    else this.progress.value = fraction;
    this.text.textContent = [this.name || "running", detail].filter(Boolean).join(": ");
  }

  /** Null: it is done. Else why it has failed. */
  end(message: string | null): void {
    if (message === null) this.element.remove();
    else this.element.replaceChildren(this.element.firstElementChild!, h("span.problem", { role: "alert" }, message));
  }
}
