// A picture of a ruled surface in 3D, with switches for what is drawn and a legend of the warp angles.
import * as three from "three";
import { h } from "../dom.ts";
import { whenIdle } from "../idle.ts";
import type { Picture } from "../report.ts";
import { colour, onTheme } from "../theme.ts";
import { warpStyle } from "./colour.ts";
import { orbit } from "./orbit.ts";
import { box, edgeRuns, largestWarp, lines, netLines, noWarp, type Point, sideView, singularLines, strip } from "./shape.ts";
import { show } from "./stage.ts";

/** How many there are: each has its own group of radio buttons. */
let pictures = 0;

type Themed = { material: three.LineBasicMaterial | three.PointsMaterial; name: string };

function geometry(positions: number[]): three.BufferGeometry {
  return new three.BufferGeometry().setAttribute("position", new three.Float32BufferAttribute(positions, 3));
}

/** The parts that can be switched on and off. */
class Parts {
  readonly groups = new Map<string, three.Object3D>();
  private readonly themed: Themed[] = [];

  constructor(private readonly scene: three.Scene) {
    onTheme(() => this.paint());
  }

  add(name: string, ...objects: three.Object3D[]): void {
    const group = this.groups.get(name) ?? new three.Group();
    group.add(...objects);
    this.groups.set(name, group);
    this.scene.add(group);
  }

  line(points: Point[], name: string): three.Object3D {
    return new three.Line(geometry(points.flat()), this.material(new three.LineBasicMaterial(), name));
  }

  segments(positions: number[], name: string, opacity = 1): three.Object3D {
    const material = new three.LineBasicMaterial({ transparent: opacity < 1, opacity });
    return new three.LineSegments(geometry(positions), this.material(material, name));
  }

  dots(points: Point[], name: string, size: number): three.Object3D {
    return new three.Points(geometry(points.flat()), this.material(new three.PointsMaterial({ size, sizeAttenuation: false }), name));
  }

  paint(): void {
    for (const { material, name } of this.themed) material.color.set(colour(name));
  }

  private material<M extends Themed["material"]>(material: M, name: string): M {
    this.themed.push({ material, name });
    material.color.set(colour(name));
    return material;
  }
}

/** Colours of the style sheet as the renderer computes with them. */
function linear(colours: number[]): number[] {
  const mixed = new three.Color();
  const list: number[] = [];
  for (let i = 0; i + 2 < colours.length; i += 3) {
    mixed.setRGB(colours[i] as number, colours[i + 1] as number, colours[i + 2] as number, three.SRGBColorSpace);
    list.push(mixed.r, mixed.g, mixed.b);
  }
  return list;
}

function surfaceMesh(picture: Picture, index: number, largest: number): three.Mesh {
  const shape = strip(picture.states[index] as Picture["states"][0], largest);
  const mesh = geometry(shape.positions);
  mesh.setAttribute("color", new three.Float32BufferAttribute(linear(shape.colours), 3));
  mesh.setIndex(shape.triangles);
  mesh.computeVertexNormals();
  const material = new three.MeshStandardMaterial({ vertexColors: true, side: three.DoubleSide, roughness: 0.85, metalness: 0, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  return new three.Mesh(mesh, material);
}

function fill(parts: Parts, picture: Picture, largest: number): void {
  picture.states.forEach((state, i) => {
    const rails = [0, 3].map((begin) => state.rulings.flatMap((ruling) => (ruling === null ? [] : [ruling.slice(begin, begin + 3) as Point])));
    parts.add(`state ${i}`, surfaceMesh(picture, i, largest), parts.line(rails[0] ?? [], "--c"), parts.line(rails[1] ?? [], "--d"));
    parts.add(`rulings ${i}`, parts.segments(lines(state, 40), "--ruling", 0.55));
    const runs = edgeRuns(state);
    if (runs.length > 0) {
      parts.add("edge", ...runs.map((run) => parts.line(run, "--edge")), parts.dots(runs.flatMap((run) => [run[0] as Point, run[run.length - 1] as Point]), "--edge", 4));
    }
  });
  if (picture.net !== null) {
    const net = netLines(picture.net);
    parts.add("net", parts.line(net.c, "--c"), parts.line(net.d, "--d"), parts.dots(net.c, "--c", 6), parts.dots(net.d, "--d", 6), parts.segments(net.between, "--soft", 0.6));
  }
  const singular = singularLines(picture);
  if (singular.length > 0) parts.add("singular", parts.segments(singular, "--bad"));
}

function legend(largest: number): HTMLElement {
  const bar = Array.from({ length: 7 }, (_, i) => warpStyle(i / 6)).join(", ");
  return h(
    "div",
    { class: "legend", role: "img", "aria-label": `Colours of the warp angle: from 0 to ${largest.toPrecision(4)} degrees` },
    h("span", {}, "0°"),
    h("span", { class: "bar", style: `background: linear-gradient(to right, ${bar})` }),
    h("span", {}, `${largest.toPrecision(3)}° warp`),
  );
}

function switchButton(label: string, pressed: boolean, toggle: (on: boolean) => void): HTMLElement {
  const button = h("button", { type: "button", "aria-pressed": String(pressed) }, label);
  button.addEventListener("click", () => {
    const on = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(on));
    toggle(on);
  });
  return button;
}

/** What is to be seen, in words. */
export function description(picture: Picture): string {
  const parts = picture.states.map((state) => {
    const values = state.warp.filter((warp): warp is number => warp !== null);
    const most = values.length === 0 ? "unknown" : `${Math.max(...values).toPrecision(3)} degrees`;
    return `${state.label}: ${state.rulings.length} rulings, warp angle at most ${most} among them`;
  });
  const singular = picture.singular.length === 0 ? "" : ` ${picture.singular.length} singular places.`;
  return `3D view of ${picture.name}, about ${picture.size} units large. ${parts.join("; ")}.${singular} Arrow keys turn, plus and minus zoom, 0 resets.`;
}

/** A canvas with switches below it. Both come to life when the page is idle, since many pictures take a moment. */
export function surfaceView(picture: Picture): HTMLElement {
  const canvas = h("canvas", { class: "scene", tabindex: 0, role: "img", "aria-label": description(picture) });
  const switches = h("figcaption", { class: "switches" });
  whenIdle(() => switches.append(...assembled(picture, canvas)));
  return h("figure", { class: "picture" }, canvas, switches);
}

/** Draws the picture on the canvas; returns its switches. */
function assembled(picture: Picture, canvas: HTMLCanvasElement): HTMLElement[] {
  const largest = largestWarp(picture);
  const scene = new three.Scene();
  scene.add(new three.HemisphereLight(0xffffff, 0x777788, 2.2));
  const camera = new three.PerspectiveCamera(32, 1.6);
  const lamp = new three.DirectionalLight(0xffffff, 1.2);
  lamp.position.set(0.3, 0.8, 0.6);
  camera.add(lamp);
  scene.add(camera);
  const parts = new Parts(scene);
  fill(parts, picture, largest);
  const view = show(canvas, scene, camera);
  const { middle, radius } = box(picture);
  const control = orbit(view, new three.Vector3(...middle), new three.Vector3(...sideView(picture)), radius * 3.3);

  const group = `state-${++pictures}`;
  let state = picture.states.length - 1;
  let rulings = true;
  const apply = () => {
    picture.states.forEach((_, i) => {
      const [surface, own] = [parts.groups.get(`state ${i}`), parts.groups.get(`rulings ${i}`)];
      if (surface !== undefined) surface.visible = i === state;
      if (own !== undefined) own.visible = i === state && rulings;
    });
    view.redraw();
  };
  const part = (name: string, label: string, pressed: boolean) => {
    const group = parts.groups.get(name);
    if (group === undefined) return null;
    group.visible = pressed;
    return switchButton(label, pressed, (on) => {
      group.visible = on;
      view.redraw();
    });
  };
  const states =
    picture.states.length < 2
      ? null
      : h(
          "fieldset",
          { class: "states" },
          h("legend", {}, "Surface"),
          ...picture.states.map(({ label }, i) => {
            const button = h("input", { type: "radio", name: group, checked: i === state });
            button.addEventListener("change", () => {
              state = i;
              apply();
            });
            return h("label", {}, button, ` ${label}`);
          }),
        );
  const few = (picture.net?.c.points.length ?? 0) <= 60;
  apply();
  const all = [
    states,
    switchButton("Rulings", true, (on) => {
      rulings = on;
      apply();
    }),
    part("net", "Control net", few),
    part("edge", "Edge of regression", true),
    part("singular", "Singular rulings", true),
    h("button", { type: "button", click: () => control.reset() }, "Reset view"),
    largest > noWarp ? legend(largest) : h("span", { class: "note" }, "no warp"),
  ];
  return all.filter((element) => element !== null);
}
