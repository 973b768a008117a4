// Where the light of a frame goes: from above and from the side, through the walls of the vial into the resin. The part stands still, the light goes round it.

import type { Ray, Run, Scene } from "./data.ts";
import { h, svg } from "./dom.ts";
import { BODIES, withBodies } from "./layers.ts";
import { faded, token } from "./paint.ts";
import { significant } from "./report/number.ts";
import type { Context } from "./section.ts";
import { ACROSS, type Volume } from "./volume.ts";
import { infoOf } from "./volumes.ts";

type Flat = [number, number][];

/** Views from above and from the side. `angle` is that of the chosen frame, degrees; null: a slider chooses among the frames that have rays. */
export function lightPath({ run, state, store }: Pick<Context, "run" | "state" | "store">, scene: Scene, light: number, angle: (() => number) | null, signal: AbortSignal): HTMLElement {
  const top = h("div");
  const side = h("div");
  const bodyKeys = h("span.color-keys");
  const caption = h("p.quiet", { role: "status" });
  const frames = scene.lights[light]?.frames ?? [];
  const last = frames.length - 1;
  const slider = h("input", { type: "range", min: 0, max: last, step: 1, "aria-label": "Frame", input: () => state.set({ frame: Number(slider.value) }) });
  let seen: Seen = { picture: null, bodies: [] };

  const update = () => {
    const wanted = angle?.() ?? null;
    const own = Math.min(state.get("frame"), last);
    slider.value = String(own);
    const there = wanted === null ? (frames[own] ?? null) : nearest(frames, wanted);
    const shown = there !== null && wanted !== null && scene.is_round ? turned(there, wanted) : there;
    top.replaceChildren(topView(scene, shown?.rays ?? [], seen.picture));
    side.replaceChildren(sideView(scene, shown?.rays ?? [], seen.bodies));
    const isOther = shown !== null && wanted !== null && apart(shown.angle_deg, wanted) > 0.05;
    const from = shown === null ? "" : `Light from ${significant(shown.angle_deg, 4)}°${isOther ? ", the nearest frame whose rays the page has" : ""}.`;
    caption.textContent = `${from}${lit(scene)}`.trim();
  };
  update();
  const takePicture = async () => {
    seen = await seenIn(run, store, state.get("at")?.[2] ?? null);
    bodyKeys.replaceChildren(...seen.bodies.map(({ color, text }) => key(color, text)));
    update();
  };
  // Without the part's picture the paths still say what they say
  void takePicture().catch(() => {});
  const ends = [state.on(["frame"], update), state.on(["at"], () => void takePicture().catch(() => {}))];
  signal.addEventListener("abort", () => ends.forEach((end) => end()));

  return h(
    "div.paths",
    {},
    h("h3", {}, "Where the light goes"),
    caption,
    angle === null && last > 0 && h("div.path-frame", {}, h("label", {}, "Frame", slider)),
    h(
      "div.path-views",
      {},
      h("figure", {}, h("figcaption", {}, "From above"), top),
      h(
        "figure",
        {},
        h("figcaption", {}, "From the side, light from the left"),
        side,
        h("p.color-keys", {}, key("--void", "light in the resin"), key("--quiet", "light outside"), key("--solid", "part"), scene.lit_radius_mm !== null && key("--accent", "radius that every frame lights"), bodyKeys),
      ),
    ),
  );
}

function key(color: string, text: string): HTMLElement {
  return h("span", {}, h("i.stroke", { style: `background: var(${color})` }), text);
}

function lit({ lit_radius_mm, part_radius_mm }: Scene): string {
  if (lit_radius_mm === null) return "";
  const [lit, part] = [significant(lit_radius_mm, 3), significant(part_radius_mm, 3)];
  return lit_radius_mm >= part_radius_mm ? ` Every frame lights all within ${lit} mm of the axis.` : ` Every frame lights only what lies within ${lit} mm of the axis, but the part's sides reach out to ${part} mm.`;
}

function nearest<T extends { angle_deg: number }>(frames: T[], angle: number): T | null {
  return frames.reduce<T | null>((best, one) => (best !== null && apart(best.angle_deg, angle) <= apart(one.angle_deg, angle) ? best : one), null);
}

/** Rays of another frame of a machine that is the same from all sides. */
function turned({ angle_deg, rays }: { angle_deg: number; rays: Ray[] }, to: number): { angle_deg: number; rays: Ray[] } {
  const by = ((to - angle_deg) * Math.PI) / 180;
  const [c, s] = [Math.cos(by), Math.sin(by)];
  return { angle_deg: to, rays: rays.map((ray) => ({ ...ray, points: ray.points.map(([x, y, z]) => [c * x - s * y, s * x + c * y, z]) })) };
}

/** The smaller of the angles between two directions, degrees. */
function apart(a: number, b: number): number {
  const turn = Math.abs(a - b) % 360;
  return Math.min(turn, 360 - turn);
}

function topView(scene: Scene, rays: Ray[], picture: Seen["picture"]): SVGElement {
  const around = Math.max(...scene.walls.flatMap(({ points }) => points.map(([x, y]) => Math.hypot(x, y))), scene.part_radius_mm) * 1.22;
  const root = view([-around, around], [-around, around], "Light path from above");
  for (const wall of scene.walls) root.append(outline(wall.points, "wall", wall.name));
  if (picture) root.append(svg("image", { href: picture.url, x: picture.left, y: -picture.top, width: picture.width, height: picture.height, preserveAspectRatio: "none" }));
  else root.append(svg("circle", { class: "part", r: scene.part_radius_mm }));
  for (const body of scene.obstacles) root.append(outline(body.points, "obstacle", body.name));
  if (scene.lit_radius_mm !== null) root.append(svg("circle", { class: "lit", r: scene.lit_radius_mm }, svg("title", {}, "radius that every frame lights")));
  root.append(...paths(rays.map((ray) => ({ points: ray.points.map(([x, y]): [number, number] => [x, y]), from: ray.resin_from })), around));
  return root;
}

function sideView(scene: Scene, rays: Ray[], bodies: Seen["bodies"]): SVGElement {
  // Along the light: horizontally from the first point of a ray to its last
  const middle = rays[rays.length >> 1]?.points ?? [];
  const [first, last] = [middle[0] ?? [-1, 0, 0], middle[middle.length - 1] ?? [1, 0, 0]];
  const length = Math.hypot(last[0] - first[0], last[1] - first[1]) || 1;
  const [dx, dy] = [(last[0] - first[0]) / length, (last[1] - first[1]) / length];
  const along = ([x, y]: readonly number[]) => x * dx + y * dy;
  const around = Math.max(...scene.walls.flatMap(({ points }) => points.map(([x, y]) => Math.hypot(x, y))), scene.part_radius_mm) * 1.22;
  const [low, high] = scene.z_mm;
  const margin = 0.25 * (high - low) + 0.05 * around;
  const root = view([-around, around], [low - margin, high + margin], "Light path from the side");
  for (const wall of scene.walls) {
    const reach = wall.points.map(along);
    const [left, right] = [Math.min(...reach), Math.max(...reach)];
    const [bottom, top] = wall.height_mm ?? [low - 2 * margin, high + 2 * margin];
    root.append(outline([[left, bottom], [right, bottom], [right, top], [left, top]], "wall", wall.name));
  }
  const r = scene.part_radius_mm;
  root.append(outline([[-r, low], [r, low], [r, high], [-r, high]], "part", "part"));
  for (const { columns, z, color, text } of bodies) {
    const reach = columns.map(along);
    const [left, right] = [Math.min(...reach), Math.max(...reach)];
    const box = outline([[left, z[0]], [right, z[0]], [right, z[1]], [left, z[1]]], "body", text);
    box.setAttribute("style", `color: var(${color})`);
    root.append(box);
  }
  if (scene.lit_radius_mm !== null) {
    for (const x of [-scene.lit_radius_mm, scene.lit_radius_mm]) root.append(svg("line", { class: "lit", x1: x, x2: x, y1: -high - margin, y2: -low + margin }));
  }
  root.append(...paths(rays.map((ray) => ({ points: ray.points.map((point): [number, number] => [along(point), point[2]]), from: ray.resin_from })), around));
  return root;
}

/** A drawing in mm, up is up. */
function view(x: [number, number], y: [number, number], label: string): SVGElement {
  return svg("svg", { class: "path-view", viewBox: `${x[0]} ${-y[1]} ${x[1] - x[0]} ${y[1] - y[0]}`, role: "img", "aria-label": label });
}

function outline(points: Flat, name: string, title: string): SVGElement {
  return svg("path", { class: name, d: `${pathOf(points)}Z` }, svg("title", {}, title));
}

function pathOf(points: Flat): string {
  return `M${points.map(([x, y]) => `${x.toFixed(4)},${(-y).toFixed(4)}`).join("L")}`;
}

/** Rays from the edge of the drawing on; those in the resin stand out. */
function paths(rays: { points: Flat; from: number }[], around: number): SVGElement[] {
  return rays.flatMap(({ points, from }) => {
    const outside = points.slice(0, from + 1);
    if (outside.length > 1) outside[0] = clipped(outside[0], outside[1], around);
    return [svg("path", { class: "ray", d: pathOf(outside) }), points.length > from + 1 && svg("path", { class: "ray resin", d: pathOf(points.slice(from)) })].filter((path) => path !== false);
  });
}

/** A ray's first point, but not farther out than the drawing. */
function clipped([x, y]: [number, number], [toX, toY]: [number, number], around: number): [number, number] {
  const far = Math.abs(x) > Math.abs(y) ? Math.abs(x) : Math.abs(y);
  if (far <= around) return [x, y];
  const near = Math.max(Math.abs(toX), Math.abs(toY));
  const share = far > near ? Math.min((far - around) / (far - near), 1) : 0;
  return [x + share * (toX - x), y + share * (toY - y)];
}

/** What the volumes show of the part and of what else is in the resin. */
interface Seen {
  /** A slice of the target and the bodies, to lie below the rays. */
  picture: { url: string; left: number; top: number; width: number; height: number } | null;
  /** Where each kind of body is: its columns from above, and its height. */
  bodies: { columns: [number, number][]; z: [number, number]; color: string; text: string }[];
}

async function seenIn(run: Run, store: Context["store"], z: number | null): Promise<Seen> {
  const [target, bodies] = await Promise.all((["target", "bodies"] as const).map(async (kind) => {
    const info = infoOf(run, kind, "");
    return info ? store.volume(info) : null;
  }));
  return { picture: target && pictureOf(target, bodies, z), bodies: bodies ? boxesOf(bodies) : [] };
}

function pictureOf(target: Volume, bodies: Volume | null, z: number | null): Seen["picture"] {
  const [low, high] = target.range(2);
  const at = target.nearest([0, 0, z ?? (low + high) / 2])[2];
  const slice = target.slice(2, at);
  if (!slice) return null;
  const color = token("--solid");
  const top = target.info.high;
  const colors = Uint32Array.from(slice.values, (value) => faded(color, Math.min(Math.max(value / top, 0), 1) * 0.75));
  const pixels = new Uint32Array(slice.codes.length);
  for (let i = 0; i < pixels.length; i++) pixels[i] = colors[slice.codes[i]];
  withBodies({ ...slice, pixels }, bodies, { of: (volume, axis, mm) => volume.slice(axis, mm) }, 2, at);
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [slice.width, slice.height];
  canvas.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(pixels.buffer), slice.width, slice.height), 0, 0);
  const [right, up] = ACROSS[2];
  return { url: canvas.toDataURL(), left: target.range(right)[0], top: target.range(up)[1], width: slice.width * slice.pitch[0], height: slice.height * slice.pitch[1] };
}

function boxesOf(bodies: Volume): Seen["bodies"] {
  const [nx, ny, nz] = bodies.shape;
  return Object.entries(BODIES).flatMap(([code, { color, text }]) => {
    const columns: [number, number][] = [];
    const heights = new Set<number>();
    for (let i = 0; i < nx * ny; i++) {
      let isIn = false;
      for (let k = 0; k < nz; k++) {
        if (bodies.codes[k * nx * ny + i] !== Number(code)) continue;
        isIn = true;
        heights.add(k);
      }
      if (isIn) columns.push([bodies.middle(0, i % nx), bodies.middle(1, Math.floor(i / nx))]);
    }
    if (columns.length === 0) return [];
    const half = bodies.pitch[2] / 2;
    const z: [number, number] = [bodies.middle(2, Math.min(...heights)) - half, bodies.middle(2, Math.max(...heights)) + half];
    return [{ columns, z, color, text }];
  });
}
