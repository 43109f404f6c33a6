// The case in 3D: three.js draws what the lens shows, in a parallel projection. Zooming makes the window of the lens
// smaller, and all geometry is made again, exactly, for each size.
import {BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, OrthographicCamera, Scene, ShapeUtils, Vector2, Vector3, WebGLRenderer,} from 'three';
import {LineMaterial} from 'three/addons/lines/LineMaterial.js';
import {LineSegments2} from 'three/addons/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/addons/lines/LineSegmentsGeometry.js';

import {minus} from './exact.js';
import {Lens} from './lens.js';
import {arrowHead, dashed, placesForNames, ring} from './overlay.js';
import {edgesOf, nearestOnProbe, placeOf} from './question.js';

/** Half the height of what is seen, in windows, where the focus is in the middle. */
export const half = 1.15;

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

  /**
   * Shows a question around a place, in a window of half width 2^size. `crossing`: where the probe's line crosses the
   * plane, or null, and `hit`: whether the probe meets the target. `fit`: {places, weight}, places that are to fill the
   * picture, with the crossing if it is near, as far as the weight says: 1 wholly, 0 not at all, and then the focus is
   * in the middle.
   */
  show(question, focus, size, {crossing, hit, fit}) {
    this.clear();
    const lens = new Lens(question, focus, size);
    this.colours = this.palette();
    const spotOf = (place) => new Vector3(...lens.see(place));
    this.fit = {weight: fit.weight, spots: fit.weight > 0 ? fit.places.map(spotOf) : []};
    if (crossing && isNear(spotOf(crossing), this.fit.spots)) this.fit.spots.push(spotOf(crossing));
    this.names = [];
    this.addSurfaces(lens, this.colours.target);
    const target = edgesOf(question).map(([from, to]) => lens.line(from, minus(to, from))).filter(Boolean);
    this.addLines(target, this.colours.target, 2.5);
    const {p, direction} = question.exact;
    const probe = [lens.line(p, direction, question.isRay)].filter(Boolean);
    this.addLines(probe, this.colours.probe, 4);
    const vectors = (lines) => lines.map((ends) => ends.map((x) => new Vector3(...x)));
    this.lines = {target: vectors(target), probe: vectors(probe)};
    this.isRay = question.isRay;
    this.crossing =
        crossing && {spot: spotOf(crossing), from: spotOf(nearestOnProbe(question, crossing)), isContact: hit};
    this.addNames(lens, question);
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
  addNames(lens, question) {
    const {p, q, rings} = question.exact;
    const inputs = [
      ...rings.flatMap((ring, r) => ring.map((point, i) => [nameOfVertex(question, r, i), placeOf(point), 'target'])),
      [question.isRay ? 'o' : 'p', placeOf(p), 'probe'],
      ...(question.isRay ? [] : [['q', placeOf(q), 'probe']]),
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
      this.names.push({label, text, spot: new Vector3(...spot)});
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
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(...eyeAt(this.yaw, this.pitch));
    this.camera.lookAt(0, 0, 0);
    this.camera.updateMatrixWorld();
    const aspect = width / height;
    const [x, y, reach] = this.frame(aspect);
    Object.assign(
        this.camera, {left: x - reach * aspect, right: x + reach * aspect, top: y + reach, bottom: y - reach});
    this.halfHeight = reach;
    this.camera.updateProjectionMatrix();
    renderer.render(this.scene, this.camera);
    [this.canvas.width, this.canvas.height] = [renderer.domElement.width, renderer.domElement.height];
    const context = this.canvas.getContext('2d');
    context.drawImage(renderer.domElement, 0, 0);
    context.scale(this.canvas.width / width, this.canvas.height / height);
    this.drawOver(context, {width, height});
  }

  /** The middle of the picture and half its height, in the camera's plane. */
  frame(aspect) {
    const {spots, weight} = this.fit;
    const seen = spots.map((spot) => spot.clone().applyMatrix4(this.camera.matrixWorldInverse));
    if (seen.length === 0 || !seen.every(({x, y}) => Number.isFinite(x) && Number.isFinite(y))) return [0, 0, half];
    const range = (axis) => [Math.min(...seen.map((s) => s[axis])), Math.max(...seen.map((s) => s[axis]))];
    const [left, right] = range('x'), [low, high] = range('y');
    const size = Math.max(0.01, 0.66 * (high - low), 0.6 * (right - left) / aspect);
    const mixed = (fitted, plain) => weight * fitted + (1 - weight) * plain;
    return [mixed((left + right) / 2, 0), mixed((low + high) / 2, 0), mixed(size, half)];
  }

  drawOver(context, box) {
    const at = (spot) => {
      const seen = spot.clone().project(this.camera);
      return [((seen.x + 1) / 2) * box.width, ((1 - seen.y) / 2) * box.height];
    };
    const onScreen = (lines) => lines.map((ends) => ends.map(at));
    const target = onScreen(this.lines?.target ?? []), probe = onScreen(this.lines?.probe ?? []);
    if (this.isRay) probe.forEach(([from, to]) => arrowHead(context, from, to, box, this.colours.probe));
    if (this.crossing) {
      const {spot, from, isContact} = this.crossing;
      dashed(context, at(from), at(spot), this.colours.probe);
      ring(context, at(spot), isContact, this.colours);
    }
    const shown = (this.names ?? [])
                      .map((name) => ({...name, point: at(name.spot), width: 10 * name.text.textContent.length}))
                      .filter(({label, point: [x, y]}) => {
                        label.hidden = x < 4 || y < 4 || x > box.width - 4 || y > box.height - 4;
                        return !label.hidden;
                      });
    const places = placesForNames(shown, [...target, ...probe], box);
    shown.forEach(({label, text, point: [x, y]}, i) => {
      Object.assign(label.style, {left: `${x}px`, top: `${y}px`});
      Object.assign(text.style, {left: `${places[i][0] + 4}px`, top: `${places[i][1] + 2}px`});
    });
  }
}

/** Whether a spot is so near to others that a picture of all is not much smaller than one of these. */
function isNear(spot, others) {
  if (others.length === 0) return false;
  const middle = others.reduce((sum, one) => sum.add(one), new Vector3()).divideScalar(others.length);
  return spot.distanceTo(middle) <= 2 * Math.max(...others.map((one) => one.distanceTo(middle)));
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
