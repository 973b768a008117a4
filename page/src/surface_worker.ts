// The worker that makes surfaces. It keeps the volumes of the last `load`, so that a new threshold is a number.

import { Distance, type Mesh, type Samples, surfaceNets } from "./surface.ts";

export type Request = { kind: "load"; response: Samples | null; target: Samples | null } | { kind: "print"; level: number } | { kind: "target" } | { kind: "part"; samples: Samples; code: number };

/** A surface, and how far its corners are from the target's, mm, where there is a target. */
export interface Made extends Mesh {
  off: Float32Array<ArrayBuffer> | null;
}

export class Surfaces {
  private response: Samples | null = null;
  private target: Samples | null = null;
  private targetMesh: Mesh | null = null;
  private distance: Distance | null = null;

  answer(request: Request): Made {
    switch (request.kind) {
      case "load":
        [this.response, this.target, this.targetMesh, this.distance] = [request.response, request.target, null, null];
        return empty();
      case "print": {
        if (!this.response) return empty();
        const mesh = surfaceNets(this.response, request.level);
        return { ...mesh, off: this.toTarget()?.of(mesh.corners) ?? null };
      }
      case "target": {
        // A copy: what the worker hands out is no longer its
        const mesh = this.meshOfTarget();
        return mesh ? { corners: mesh.corners.slice(), triangles: mesh.triangles.slice(), off: null } : empty();
      }
      case "part": {
        const { samples, code } = request;
        return { ...surfaceNets({ ...samples, values: Float32Array.from(samples.values, (_, c) => (c === code ? 1 : 0)) }, 0.5), off: null };
      }
    }
  }

  private meshOfTarget(): Mesh | null {
    if (this.target) this.targetMesh ??= surfaceNets(this.target, 0.5);
    return this.targetMesh;
  }

  private toTarget(): Distance | null {
    const mesh = this.meshOfTarget();
    if (mesh && this.target && mesh.corners.length > 0) this.distance ??= new Distance(mesh, this.target);
    return this.distance;
  }
}

function empty(): Made {
  return { corners: new Float32Array(), triangles: new Uint32Array(), off: null };
}

// In a worker there is no document; the page imports `Surfaces` alone.
if (typeof document === "undefined") {
  const surfaces = new Surfaces();
  self.addEventListener("message", (event: MessageEvent<Request>) => {
    const made = surfaces.answer(event.data);
    self.postMessage(made, { transfer: [made.corners.buffer, made.triangles.buffer, ...(made.off ? [made.off.buffer] : [])] });
  });
}
