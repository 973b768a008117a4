// What a section of the page is, and what it gets.

import type { PageData, Run } from "./data.ts";
import type { State } from "./state.ts";
import type { Store } from "./store.ts";

export interface Context {
  data: PageData;
  /** The run that is shown. While it goes on it is replaced, and the arrays with it; `renewed` then dispatches "renewed". */
  run: Run;
  index: number;
  state: State;
  /** The arrays of this run. */
  store: Store;
  /** The arrays of each run. */
  stores: Store[];
  /** Ends when another run is shown or new data arrive: give it to `addEventListener`, or listen to it to tidy up. */
  gone: AbortSignal;
  renewed: EventTarget;
}

export interface Section {
  /** Part of the address: lower case, short. */
  id: string;
  /** Heading and entry in the list of sections; "": neither (the head of the page). */
  title: string;
  /** Null where the run has nothing to show here. */
  render: (context: Context) => HTMLElement | null;
}
