// Turning a view: by dragging, by touch, by the arrow keys; plus and minus zoom, 0 goes back to the beginning.
import { MathUtils, type PerspectiveCamera, Spherical, Vector3 } from "three";
import type { View } from "./stage.ts";

export interface Orbit {
  turn(angle: number, height: number): void;
  zoom(factor: number): void;
  reset(): void;
}

/** Keeps the camera on a sphere around `middle`, at first in the direction `from`. The z axis is up. */
export function orbit(view: View, middle: Vector3, from: Vector3, distance: number): Orbit {
  const height = Math.acos(MathUtils.clamp(from.clone().normalize().z, -1, 1));
  const home = new Spherical(distance, MathUtils.clamp(height, 0.45, 1.35), Math.atan2(from.y, from.x));
  const place = home.clone();
  const camera: PerspectiveCamera = view.camera;
  camera.up.set(0, 0, 1);
  const apply = () => {
    const { radius, phi, theta } = place;
    camera.position.set(Math.sin(phi) * Math.cos(theta), Math.sin(phi) * Math.sin(theta), Math.cos(phi)).multiplyScalar(radius).add(middle);
    camera.near = radius / 100;
    camera.far = radius * 100;
    camera.lookAt(middle);
    view.redraw();
  };
  const control: Orbit = {
    turn(angle, height) {
      place.theta += angle;
      place.phi = MathUtils.clamp(place.phi + height, 0.02, Math.PI - 0.02);
      apply();
    },
    zoom(factor) {
      place.radius = MathUtils.clamp(place.radius * factor, distance / 20, distance * 5);
      apply();
    },
    reset() {
      place.copy(home);
      apply();
    },
  };
  listen(view.canvas, control);
  apply();
  return control;
}

const step = MathUtils.degToRad(8);

const keys: Record<string, (control: Orbit) => void> = {
  ArrowLeft: (control) => control.turn(-step, 0),
  ArrowRight: (control) => control.turn(step, 0),
  ArrowUp: (control) => control.turn(0, -step),
  ArrowDown: (control) => control.turn(0, step),
  "+": (control) => control.zoom(0.85),
  "=": (control) => control.zoom(0.85),
  "-": (control) => control.zoom(1 / 0.85),
  "0": (control) => control.reset(),
};

function listen(canvas: HTMLCanvasElement, control: Orbit): void {
  canvas.addEventListener("keydown", (event) => {
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (act === undefined) return;
    event.preventDefault();
    act(control);
  });
  const fingers = new Map<number, { x: number; y: number }>();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return a !== undefined && b !== undefined ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  canvas.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (before === undefined) return;
    const apart = spread();
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (apart > 0) control.zoom(apart / Math.max(spread(), 1));
    else control.turn((before.x - event.clientX) * 0.008, (before.y - event.clientY) * 0.008);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => fingers.delete((event as PointerEvent).pointerId));
  }
  // The wheel scrolls the page unless the view has the focus.
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (document.activeElement !== canvas) return;
      event.preventDefault();
      control.zoom(Math.exp(event.deltaY * 0.001));
    },
    { passive: false },
  );
}
