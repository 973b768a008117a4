// The 3D scene: meshes in mm with z upward, a camera that goes round them, drawn only when something has changed.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DataTexture, DirectionalLight, DoubleSide, Group, LineBasicMaterial, LineLoop, type Material, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, NearestFilter, type Object3D, PerspectiveCamera, Plane, PlaneGeometry, RGBAFormat, Scene, SRGBColorSpace, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Picture } from "./layers.ts";
import { channels } from "./paint.ts";
import type { Mesh as Surface } from "./surface.ts";
import { ACROSS, type Axis, type Point } from "./volume.ts";

export interface MeshLook {
  /** A word of a color, for the whole of it. */
  color?: number;
  /** Or a word of each corner. */
  colors?: Uint32Array;
  opacity?: number;
  /** Whether a cut leaves it whole. */
  whole?: boolean;
}

/** How much of the view the box of the part fills. */
const FILL = 0.97;
/** Signs of the corners of a box around its middle. */
const CORNERS = Array.from({ length: 8 }, (_, i): Point => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);

export class Stage {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(32, 1, 0.1, 1000);
  private readonly controls: OrbitControls;
  private readonly named = new Map<string, Object3D>();
  private readonly plane = new Plane(new Vector3(0, 0, -1), 0);
  private readonly watcher: ResizeObserver;
  private isCut = false;
  /** From where the camera looks, until the reader turns it. */
  private view: [azimuth: number, elevation: number] | null = null;
  private frame = 0;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly low: Point,
    private readonly high: Point,
    signal: AbortSignal,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.localClippingEnabled = true;
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.camera.up.set(0, 0, 1);
    const light = new DirectionalLight(0xffffff, 2.2);
    light.position.set(-0.6, 0.9, 0.8);
    this.camera.add(light);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.3));
    this.controls = new OrbitControls(this.camera, this.canvas);
    // The wheel belongs to the page until the view has the focus
    this.controls.enableZoom = false;
    this.canvas.addEventListener("focus", () => (this.controls.enableZoom = true), { signal });
    this.canvas.addEventListener("blur", () => (this.controls.enableZoom = false), { signal });
    this.canvas.addEventListener("keydown", (event) => this.key(event), { signal });
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => (this.view = null));
    this.watcher = new ResizeObserver(() => this.draw());
    this.watcher.observe(this.canvas);
    this.look(-60, 30);
    signal.addEventListener("abort", () => this.end());
  }

  private end(): void {
    cancelAnimationFrame(this.frame);
    this.watcher.disconnect();
    this.controls.dispose();
    for (const name of [...this.named.keys()]) this.remove(name);
    this.renderer.dispose();
    // Browsers allow few contexts: this one is given back at once
    this.renderer.forceContextLoss();
  }

  /** Looks at the middle from an azimuth and elevation, degrees. */
  look(azimuth: number, elevation: number): void {
    this.view = [azimuth, elevation];
    const middle = new Vector3(...this.low).add(new Vector3(...this.high)).multiplyScalar(0.5);
    const half = new Vector3(...this.high).sub(middle);
    const radius = half.length();
    const [a, e] = [azimuth, Math.min(Math.max(elevation, -89.9), 89.9)].map((degrees) => (degrees * Math.PI) / 180);
    const toward = new Vector3(Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e));
    const right = new Vector3(-Math.sin(a), Math.cos(a), 0);
    const above = toward.clone().cross(right);
    // So far away that every corner of the box is in view
    const tangent = FILL * Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = Math.max(
      ...CORNERS.map((signs) => {
        const corner = new Vector3(...signs).multiply(half);
        return corner.dot(toward) + Math.max(Math.abs(corner.dot(above)), Math.abs(corner.dot(right)) / this.camera.aspect) / tangent;
      }),
    );
    this.camera.near = radius / 50;
    this.camera.far = 30 * radius;
    this.controls.target.copy(middle);
    this.camera.position.copy(toward).multiplyScalar(distance).add(middle);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** Shows a surface under a name, in place of the one before. */
  mesh(name: string, surface: Surface, look: MeshLook): void {
    this.remove(name);
    if (surface.triangles.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(surface.corners, 3));
    geometry.setIndex(new BufferAttribute(surface.triangles, 1));
    geometry.computeVertexNormals();
    if (look.colors) geometry.setAttribute("color", new BufferAttribute(linear(look.colors), 3));
    const isClear = look.opacity !== undefined && look.opacity < 1;
    const material = new MeshLambertMaterial({
      vertexColors: look.colors !== undefined,
      side: DoubleSide,
      transparent: isClear,
      opacity: look.opacity ?? 1,
      depthWrite: !isClear,
    });
    if (look.color !== undefined) material.color = new Color().setRGB(...channels(look.color), SRGBColorSpace);
    material.clippingPlanes = this.isCut && look.whole !== true ? [this.plane] : [];
    material.userData.whole = look.whole === true;
    this.add(name, new Mesh(geometry, material));
  }

  /** Upright walls over closed outlines. */
  walls(name: string, outlines: { points: [number, number][]; low: number; high: number }[], color: number): void {
    this.remove(name);
    const group = new Group();
    const ink = new Color().setRGB(...channels(color), SRGBColorSpace);
    for (const { points, low, high } of outlines) {
      for (const z of [low, high]) {
        const line = new BufferGeometry().setFromPoints(points.map(([x, y]) => new Vector3(x, y, z)));
        group.add(new LineLoop(line, new LineBasicMaterial({ color: ink, transparent: true, opacity: 0.55 })));
      }
      const corners = new Float32Array(points.flatMap(([x, y]) => [x, y, low, x, y, high]));
      const n = points.length;
      const index = Uint32Array.from(points.flatMap((_, i) => [0, 2, 1, 1, 2, 3].map((k) => (2 * i + k) % (2 * n))));
      const side = new BufferGeometry();
      side.setAttribute("position", new BufferAttribute(corners, 3));
      side.setIndex(new BufferAttribute(index, 1));
      group.add(new Mesh(side, new MeshBasicMaterial({ color: ink, transparent: true, opacity: 0.06, side: DoubleSide, depthWrite: false })));
    }
    this.add(name, group);
  }

  /** Cuts away what lies on the far side of a coordinate along an axis, and fills the cut with a picture. Null: no cut. */
  cut(axis: Axis | null, mm: number, picture: Picture | null): void {
    this.remove("cut");
    this.isCut = axis !== null;
    if (axis !== null) {
      // The side toward the first view is taken away: the front (−y), the right (+x), the top (+z)
      const normal = new Vector3().setComponent(axis, axis === 1 ? 1 : -1);
      this.plane.set(normal, axis === 1 ? -mm : mm);
      if (picture) this.add("cut", filling(axis, mm, picture));
    }
    this.scene.traverse((object) => {
      const material = (object as Mesh).material as Material | undefined;
      if (material instanceof MeshLambertMaterial) material.clippingPlanes = this.isCut && material.userData.whole !== true ? [this.plane] : [];
    });
    this.draw();
  }

  remove(name: string): void {
    const object = this.named.get(name);
    if (!object) return;
    this.scene.remove(object);
    this.named.delete(name);
    object.traverse((part) => {
      const mesh = part as Mesh;
      mesh.geometry?.dispose();
      const material = mesh.material as MeshBasicMaterial | undefined;
      material?.map?.dispose();
      material?.dispose();
    });
    this.draw();
  }

  private add(name: string, object: Object3D): void {
    this.named.set(name, object);
    this.scene.add(object);
    this.draw();
  }

  private draw(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
      if (width === 0 || height === 0) return;
      const ratio = Math.min(window.devicePixelRatio || 1, 2);
      if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        if (this.view) this.look(...this.view);
      }
      this.renderer.render(this.scene, this.camera);
    });
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const around = this.camera.position.clone().sub(this.controls.target);
    const distance = around.length();
    const [azimuth, elevation] = [Math.atan2(around.y, around.x), Math.asin(around.z / distance)].map((angle) => (angle * 180) / Math.PI);
    const turns: Record<string, [number, number]> = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] };
    const zooms: Record<string, number> = { "+": 0.85, "=": 0.85, "-": 1 / 0.85 };
    if (event.key in turns) {
      const [a, e] = [azimuth + turns[event.key][0], Math.min(Math.max(elevation + turns[event.key][1], -89.9), 89.9)].map((degrees) => (degrees * Math.PI) / 180);
      this.camera.position.set(Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e)).multiplyScalar(distance).add(this.controls.target);
    } else if (event.key in zooms) {
      this.camera.position.copy(around.multiplyScalar(zooms[event.key]).add(this.controls.target));
    } else if (event.key === "0") {
      this.look(-60, 30);
    } else return;
    event.preventDefault();
    if (event.key !== "0") this.view = null;
    this.controls.update();
    this.draw();
  }
}

/** A picture that stands in the plane of the cut. */
function filling(axis: Axis, mm: number, { pixels, width, height, pitch, corner }: Picture): Mesh {
  const [right, up] = ACROSS[axis];
  // Rows of textures begin at the bottom
  const flipped = new Uint32Array(pixels.length);
  for (let row = 0; row < height; row++) flipped.set(pixels.subarray((height - 1 - row) * width, (height - row) * width), row * width);
  const texture = new DataTexture(new Uint8Array(flipped.buffer), width, height, RGBAFormat);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = texture.minFilter = NearestFilter;
  texture.needsUpdate = true;
  const geometry = new PlaneGeometry(1, 1);
  const places = geometry.getAttribute("position");
  for (let i = 0; i < places.count; i++) {
    const [u, v] = [places.getX(i) + 0.5, places.getY(i) + 0.5];
    const point = new Vector3().setComponent(axis, mm);
    point.setComponent(right, corner[0] + u * width * pitch[0]).setComponent(up, corner[1] + (v - 1) * height * pitch[1]);
    places.setXYZ(i, point.x, point.y, point.z);
  }
  return new Mesh(geometry, new MeshBasicMaterial({ map: texture, side: DoubleSide, alphaTest: 0.5 }));
}

/** Colors of corners, as WebGL computes with them. */
function linear(words: Uint32Array): Float32Array {
  const known = new Map<number, [number, number, number]>();
  const out = new Float32Array(3 * words.length);
  const color = new Color();
  words.forEach((pixel, i) => {
    let rgb = known.get(pixel);
    if (!rgb) {
      color.setRGB(...channels(pixel), SRGBColorSpace);
      rgb = [color.r, color.g, color.b];
      known.set(pixel, rgb);
    }
    out.set(rgb, 3 * i);
  });
  return out;
}

