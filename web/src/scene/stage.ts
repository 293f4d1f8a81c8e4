// One WebGL renderer for all views: it draws a view when that is visible and has changed, and copies the picture to the view's own canvas.
//   View       what a canvas shows      show       makes a canvas a view
// A canvas has the attribute data-drawn while it shows what it should.
import * as three from "three";
import { onTheme } from "../theme.ts";

export interface View {
  canvas: HTMLCanvasElement;
  scene: three.Scene;
  camera: three.PerspectiveCamera;
  /** Asks for a new picture. */
  redraw(): void;
}

interface Shown {
  view: View;
  visible: boolean;
  stale: boolean;
}

const all = new Map<Element, Shown>();
let renderer: three.WebGLRenderer | null = null;
let failed = false;
let scheduled = false;

function theRenderer(): three.WebGLRenderer | null {
  if (renderer !== null || failed) return renderer;
  try {
    renderer = new three.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  } catch {
    failed = true;
  }
  return renderer;
}

/** Degrees from bottom to top: 32, and more where the picture is higher than broad, so that nothing is cut off at the sides. */
function fieldOfView(aspect: number): number {
  const half = Math.tan(three.MathUtils.degToRad(16)) * Math.max(1, 1 / aspect);
  return three.MathUtils.radToDeg(2 * Math.atan(half));
}

function draw({ view }: Shown): void {
  const gl = theRenderer();
  const context = view.canvas.getContext("2d");
  if (context === null) return;
  const scale = Math.min(devicePixelRatio, 2);
  const width = Math.max(1, Math.round(view.canvas.clientWidth * scale));
  const height = Math.max(1, Math.round(view.canvas.clientHeight * scale));
  if (view.canvas.width !== width || view.canvas.height !== height) Object.assign(view.canvas, { width, height });
  if (gl === null) {
    context.fillStyle = getComputedStyle(view.canvas).color;
    context.font = `${14 * scale}px sans-serif`;
    context.fillText("This browser has no WebGL to draw in 3D.", 12 * scale, 24 * scale);
    return;
  }
  const size = gl.getSize(new three.Vector2());
  if (size.x !== width || size.y !== height) gl.setSize(width, height, false);
  view.camera.aspect = width / height;
  view.camera.fov = fieldOfView(view.camera.aspect);
  view.camera.updateProjectionMatrix();
  gl.render(view.scene, view.camera);
  context.clearRect(0, 0, width, height);
  context.drawImage(gl.domElement, 0, 0);
}

function drawStale(): void {
  scheduled = false;
  for (const shown of all.values()) {
    if (!shown.visible || !shown.stale) continue;
    shown.stale = false;
    draw(shown);
    shown.view.canvas.dataset["drawn"] = "true";
  }
}

function schedule(): void {
  if (scheduled) return;
  scheduled = true;
  requestAnimationFrame(drawStale);
}

const seen = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) {
      const shown = all.get(entry.target);
      if (shown !== undefined) shown.visible = entry.isIntersecting;
    }
    schedule();
  },
  { rootMargin: "100px" },
);

function touch(target: Element): void {
  const shown = all.get(target);
  if (shown !== undefined) {
    shown.stale = true;
    delete shown.view.canvas.dataset["drawn"];
  }
  schedule();
}

const sized = new ResizeObserver((entries) => entries.forEach((entry) => touch(entry.target)));

onTheme(() => [...all.keys()].forEach(touch));
addEventListener("beforeprint", () => {
  for (const shown of all.values()) draw(shown);
});

/** A view of a scene on a canvas. */
export function show(canvas: HTMLCanvasElement, scene: three.Scene, camera: three.PerspectiveCamera): View {
  const view: View = { canvas, scene, camera, redraw: () => touch(canvas) };
  all.set(canvas, { view, visible: false, stale: true });
  seen.observe(canvas);
  sized.observe(canvas);
  return view;
}
