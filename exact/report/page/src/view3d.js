// The case in 3D: three.js draws what the lens shows, in a parallel projection. Zooming makes the window of the lens
// smaller, and all geometry is made again, exactly, for each size.
import {BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, OrthographicCamera, Scene, ShapeUtils, Vector2, Vector3, WebGLRenderer,} from 'three';
import {LineMaterial} from 'three/addons/lines/LineMaterial.js';
import {LineSegments2} from 'three/addons/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/addons/lines/LineSegmentsGeometry.js';

import {minus} from './exact.js';
import {Lens} from './lens.js';
import {edgesOf, placeOf} from './question.js';

/** Half the height of what is seen, in windows. */
const half = 1.15;

/** One for all cases, as browsers keep few graphics contexts; each view copies the picture to a canvas of its own. */
let renderer = null;

export class View3D {
  /** Draws on `canvas`, and names in `labels`, an element that lies over it. `palette()` gives colours as CSS text. */
  constructor(canvas, labels, palette) {
    Object.assign(this, {canvas, labels, palette, yaw: 0.6, pitch: 0.45});
    renderer ??= new WebGLRenderer({antialias: true, alpha: true});
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.camera = new OrthographicCamera(-1, 1, 1, -1, -200, 200);
    this.scene = new Scene();
    this.world = new Group();
    this.scene.add(this.world);
  }

  /** Shows a question around a place, in a window of half width 2^size; `marks` are further named places. */
  show(question, focus, size, marks = []) {
    this.clear();
    const lens = new Lens(question, focus, size);
    const colours = this.palette();
    this.names = [];
    this.addSurfaces(lens, colours.target);
    const target = edgesOf(question).map(([from, to]) => lens.line(from, minus(to, from))).filter(Boolean);
    this.addLines(target, colours.target, 2.5);
    const {p, direction} = question.exact;
    this.addLines([lens.line(p, direction, question.isRay)].filter(Boolean), colours.probe, 4);
    this.addNames(lens, question, marks);
    this.render();
  }

  addSurfaces(lens, colour) {
    const material =
        new MeshBasicMaterial({color: colour, transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false});
    for (const rings of lens.surfaces()) {
      const points = rings.flat();
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(new Float32Array(points.flat()), 3));
      geometry.setIndex(triangulate(rings).flat());
      this.world.add(new Mesh(geometry, material));
    }
  }

  addLines(lines, colour, width) {
    if (lines.length === 0) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(lines.flat(2));
    const material = new LineMaterial({color: colour, linewidth: width});
    this.world.add(new LineSegments2(geometry, material));
  }

  /** Names stand beside their points as text over the canvas; squares for the target, discs for the probe. */
  addNames(lens, question, marks) {
    const {p, q, rings} = question.exact;
    const inputs = [
      ...rings.flatMap((ring, r) => ring.map((point, i) => [nameOfVertex(question, r, i), placeOf(point), 'target'])),
      [question.isRay ? 'o' : 'p', placeOf(p), 'probe'],
      ...(question.isRay ? [] : [['q', placeOf(q), 'probe']]),
      ...marks,
    ];
    for (const [name, place, kind] of inputs) {
      const spot = lens.see(place);
      if (!spot.every((x) => Math.abs(x) < 3)) continue;
      const label = document.createElement('span');
      label.className = `spot ${kind}`;
      const text = document.createElement('b');
      text.textContent = name;
      label.append(text);
      this.labels.append(label);
      this.names.push([label, new Vector3(...spot)]);
    }
  }

  clear() {
    for (const child of [...this.world.children]) {
      child.geometry.dispose();
      child.material.dispose();
      this.world.remove(child);
    }
    this.labels.replaceChildren();
  }

  /** Turns to where both the face and the probe are seen broad: |n·v| and |d×v| for unit vectors are large. */
  face(normal, along) {
    let best = -1;
    for (let pitch = 0.2; pitch < 0.9; pitch += 0.12) {
      for (let yaw = 0; yaw < 6.28; yaw += 0.13) {
        const v = eyeAt(yaw, pitch);
        const across = normal ? Math.abs(dotOf(normal, v)) : 1;
        const score = Math.min(across, 0.75) * Math.sqrt(1 - dotOf(along, v) ** 2);
        if (score > best + 1e-9) [best, this.yaw, this.pitch] = [score, yaw, pitch];
      }
    }
  }

  turn(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + pitch));
    this.render();
  }

  /** Draws, and places the names. Cases have z up. */
  render() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height, false);
    const aspect = width / height;
    Object.assign(this.camera, {left: -half * aspect, right: half * aspect, top: half, bottom: -half});
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(...eyeAt(this.yaw, this.pitch));
    this.camera.lookAt(0, 0, 0);
    this.camera.updateProjectionMatrix();
    renderer.render(this.scene, this.camera);
    [this.canvas.width, this.canvas.height] = [renderer.domElement.width, renderer.domElement.height];
    this.canvas.getContext('2d').drawImage(renderer.domElement, 0, 0);
    for (const [label, spot] of this.names ?? []) {
      const seen = spot.clone().project(this.camera);
      label.hidden = Math.abs(seen.x) > 0.98 || Math.abs(seen.y) > 0.96;
      label.style.left = `${((seen.x + 1) / 2) * width}px`;
      label.style.top = `${((1 - seen.y) / 2) * height}px`;
    }
  }
}

/** The direction to the eye: z is up. */
const eyeAt = (yaw, pitch) => [Math.cos(pitch) * Math.sin(yaw), -Math.cos(pitch) * Math.cos(yaw), Math.sin(pitch)];
const dotOf = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const nameOfVertex = (question, ring, i) => {
  if (!question.isPolygon) return 'abc'[i];
  return ring === 0 ? `${i}` : `${'ghijkl'[ring - 1] ?? 'h'}${i}`;
};

/** Triangles, as indices, of planar rings that share one plane: seen along its longest axis. */
function triangulate(rings) {
  const points = rings.flat();
  const span =
      [0, 1, 2].map((axis) => Math.max(...points.map((x) => x[axis])) - Math.min(...points.map((x) => x[axis])));
  const drop = span.indexOf(Math.min(...span));
  const flat = rings.map((ring) => ring.map((x) => new Vector2(...x.filter((_, axis) => axis !== drop))));
  return ShapeUtils.triangulateShape(flat[0], flat.slice(1));
}
