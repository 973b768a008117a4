// Asks the worker for surfaces, one after the other. The worker's program stands within the page, so that it works from a file;
// where a browser refuses such a worker, surfaces are made in the page itself.

import source from "worker:./surface_worker.ts";
import type { Samples } from "./surface.ts";
import { type Made, type Request, Surfaces } from "./surface_worker.ts";
import type { Volume } from "./volume.ts";

export class SurfaceClient {
  private worker: Worker | null;
  private readonly local = new Surfaces();
  private last: Promise<unknown> = Promise.resolve();

  constructor(signal: AbortSignal) {
    this.worker = start();
    signal.addEventListener("abort", () => this.worker?.terminate());
  }

  /** Answers come in the order of the questions. */
  ask(request: Request): Promise<Made> {
    const answer = this.last.then(() => (this.worker ? post(this.worker, request) : paused().then(() => this.local.answer(request))));
    this.last = answer.catch(() => undefined);
    return answer;
  }
}

export function samplesOf(volume: Volume): Samples {
  const low = ([0, 1, 2] as const).map((axis) => volume.range(axis)[0]) as Samples["low"];
  return { codes: volume.codes, values: volume.values, shape: volume.shape, pitch: volume.pitch, low };
}

function start(): Worker | null {
  try {
    return new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
  } catch {
    return null;
  }
}

function post(worker: Worker, request: Request): Promise<Made> {
  return new Promise((resolve, reject) => {
    worker.onmessage = (event: MessageEvent<Made>) => resolve(event.data);
    worker.onerror = (event) => reject(new Error(`The surface could not be made: ${event.message}`));
    worker.postMessage(request);
  });
}

/** Lets the page draw before the work. */
function paused(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 20));
}
