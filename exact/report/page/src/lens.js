// What of a case lies in a small window around a place, in numbers of the size of the window. The lens takes all
// differences exactly, scales them by a power of two and rounds last, so that a window one ulp wide, or far smaller, is
// drawn as sharply as the whole. What reaches out of the window is cut at its edge: a graphics card computes in
// binary32 and could not hold ends that are 2^60 windows away.
import {cross, dot, isZero, minus, plus, ratio, times} from './exact.js';
import {nearestOnLine, normalOf, placeOf} from './question.js';

/** Half the width of the cube that is drawn, in windows. */
export const reach = 24;

export class Lens {
  /** The window's centre is `focus`, a place; its half width is 2^size in units of the input. */
  constructor(question, focus, size) {
    this.question = question;
    this.focus = focus;
    this.exponent = question.exact.unit - Math.floor(size);
    this.rest = 2 ** (Math.floor(size) - size);
  }

  /** A place relative to the focus, in windows. */
  see({point, weight}) {
    const gap = minus(times(point, this.focus.weight), times(this.focus.point, weight));
    const scale = weight * this.focus.weight;
    return gap.map((x) => ratio(x, scale, this.exponent) * this.rest);
  }

  /** The part of the line o + s·d, s from 0 to 1 (`endless`: to infinity), in the window: two points, or null. */
  line(origin, direction, endless = false) {
    const start = this.see(placeOf(origin));
    if (isZero(direction)) return within(start) ? [start, start] : null;
    const near = this.see(nearestOnLine(origin, direction, this.focus));
    if (!within(near)) return null;
    const along = unitOf(direction);
    const end = this.see(placeOf(plus(origin, direction)));
    // Ends inside the window are taken as they are; others stand where the line leaves it.
    const limit = 3 * reach;
    const from = project(start, near, along);
    const to = endless ? Infinity : project(end, near, along);
    if (from > limit || to < -limit) return null;
    const at = (s) => near.map((x, i) => x + s * along[i]);
    return [from > -limit ? start : at(-limit), to < limit ? end : at(limit)];
  }

  /** The part of the target's plane in the window that the rings enclose, as convex or not polygons of points. */
  surfaces() {
    const {rings} = this.question.exact;
    const normal = normalOf(this.question);
    if (isZero(normal)) return [];
    const planar = rings.flat().every((point) => dot(normal, minus(point, rings[0][0])) === 0n);
    if (planar) return [this.cutRings(rings, normal)].filter((cut) => cut.length > 0);
    // Not planar: the covering, a triangle for each edge, is the surface.
    const [o] = rings[0];
    return rings.flatMap((ring) => ring.map((point, i) => [o, point, ring[(i + 1) % ring.length]]))
        .map((triangle) => [triangle, cross(minus(triangle[1], o), minus(triangle[2], o))])
        .filter(([, n]) => !isZero(n))
        .map(([triangle, n]) => this.cutRings([triangle], n))
        .filter((cut) => cut.length > 0);
  }

  /** Planar rings cut to the cube, seen along the axis that the normal is longest on. */
  cutRings(rings, normal) {
    const size = normal.map((x) => (x < 0n ? -x : x));
    const drop = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const kept = [0, 1, 2].filter((axis) => axis !== drop);
    const foot = this.footOnPlane(rings[0][0], normal);
    if (!within(foot)) return [];
    const slope = kept.map((axis) => -ratio(normal[axis], normal[drop]));
    const lift = (uv) => {
      const spot = [0, 0, 0];
      kept.forEach((axis, i) => (spot[axis] = uv[i]));
      spot[drop] = foot[drop] + slope[0] * (uv[0] - foot[kept[0]]) + slope[1] * (uv[1] - foot[kept[1]]);
      return spot;
    };
    const flat = rings.map((ring) => ring.map((point) => this.flattened(point, kept)));
    return flat.map((ring) => cutToSquare(ring))
        .filter((ring) => ring.length > 2)
        .map((ring) => ring.map((uv) => lift(uv.map((x) => x * this.rest))));
  }

  /** The point of a plane nearest to the focus, in windows. */
  footOnPlane(point, normal) {
    const {focus} = this;
    const height = dot(normal, minus(times(point, focus.weight), focus.point));
    const length = dot(normal, normal);
    return normal.map((x) => ratio(x * height, length * focus.weight, this.exponent) * this.rest);
  }

  /**
   * Two coordinates relative to the focus as integers, in a unit of 2^-60 windows of whole size; exact but for one
   * floor.
   */
  flattened(point, kept) {
    const {focus} = this;
    const shift = BigInt(this.exponent + 60);
    return kept.map((axis) => {
      const gap = point[axis] * focus.weight - focus.point[axis];
      return shift >= 0n ? (gap << shift) / focus.weight : gap / (focus.weight << -shift);
    });
  }
}

const within = (point) => point.every((x) => Math.abs(x) <= 2 * reach);

const project = (point, near, along) => {
  const gap = point.map((x, i) => x - near[i]);
  const s = gap.reduce((sum, x, i) => sum + x * along[i], 0);
  return Number.isNaN(s) ? Math.sign(point.find((x) => !Number.isFinite(x)) ?? 1) * Infinity : s;
};

/** A direction of length 1, rounded. */
export function unitOf(vector) {
  const largest = vector.map((x) => (x < 0n ? -x : x)).reduce((m, x) => (x > m ? x : m));
  const scaled = vector.map((x) => ratio(x, largest));
  const length = Math.hypot(...scaled);
  return scaled.map((x) => x / length);
}

const grain = 2 ** -60;
const edge = BigInt(reach) << 60n;

/** Sutherland and Hodgman's clipping of a ring to the square of the window, on integers. */
function cutToSquare(ring) {
  const sides = [[0, 1n], [0, -1n], [1, 1n], [1, -1n]];
  const cut = sides.reduce((points, [axis, sign]) => cutAt(points, axis, sign), ring);
  return cut.map((uv) => uv.map((x) => Number(x) * grain));
}

function cutAt(ring, axis, sign) {
  const outside = (point) => sign * point[axis] > edge;
  return ring.flatMap((point, i) => {
    const next = ring[(i + 1) % ring.length];
    const kept = outside(point) ? [] : [point];
    if (outside(point) === outside(next)) return kept;
    const run = next[axis] - point[axis];
    const there = sign * edge - point[axis];
    return [...kept, point.map((x, k) => (k === axis ? sign * edge : x + ((next[k] - x) * there) / run))];
  });
}
