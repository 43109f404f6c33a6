// A case as geometry: doubles for what is rounded, integers in one unit for what is exact.
import {cross, det3, dot, inOneUnit, isZero, logOf, minus, plus, signOf, times, toDouble} from './exact.js';

const pointOf = (tokens) => tokens.map(toDouble);

/** Reads a case of docs/formats.md. `finite` is false where a coordinate is not a finite number. */
export function questionOf(data) {
  const isRay = data.ray !== undefined;
  const p = pointOf(isRay ? data.ray.o : data.seg[0]);
  const q = pointOf(isRay ? data.ray.d : data.seg[1]);
  const isPolygon = data.tri === undefined;
  const rings = (isPolygon ? data.rings : [data.tri]).map((ring) => ring.map(pointOf));
  const bounds = isRay && data.ray.t ? data.ray.t.map(toDouble) : null;
  const format = data.fmt ?? 'binary64';
  const question = {p, q, isRay, isPolygon, rings, bounds, format};
  const numbers = [...p, ...q, ...rings.flat(2)];
  question.finite = numbers.every(Number.isFinite);
  if (question.finite) question.exact = exactOf(question, numbers);
  return question;
}

/** Integers in one unit: p, direction and rings; of a segment the direction is q − p. */
function exactOf({isRay, rings}, numbers) {
  const {unit, values} = inOneUnit(numbers);
  const points = [];
  for (let i = 0; i < values.length; i += 3) points.push(values.slice(i, i + 3));
  const [p, q, ...rest] = points;
  let taken = 0;
  const exactRings = rings.map((ring) => rest.slice(taken, (taken += ring.length)));
  return {unit, p, q, direction: isRay ? q : minus(q, p), rings: exactRings};
}

/** The exact signs abcp, abcq, pqab, pqbc, pqca. */
export function exactSigns({exact, isRay}) {
  const {p, q, rings} = exact;
  const [a, b, c] = rings[0];
  const volume = (o, u, v, x, direction) => signOf(det3(minus(u, o), minus(v, o), direction ? x : minus(x, o)));
  return [
    volume(a, b, c, p, false),
    volume(a, b, c, q, isRay),
    volume(p, a, b, q, isRay),
    volume(p, b, c, q, isRay),
    volume(p, c, a, q, isRay),
  ];
}

/** A normal of the target: Newell's sum over the outer ring, which is cross(b − a, c − a) of a triangle. */
export function normalOf({exact}) {
  const ring = exact.rings[0];
  return ring.reduce(
      (sum, point, i) => plus(sum, cross(minus(point, ring[0]), minus(ring[(i + 1) % ring.length], ring[0]))),
      [0n, 0n, 0n]);
}

/**
 * Where the probe's line meets the target's plane: {point, weight} with place = point / weight, or null if parallel.
 */
export function crossingOf(question) {
  const {p, direction, rings} = question.exact;
  const normal = normalOf(question);
  const speed = dot(normal, direction);
  if (speed === 0n) return null;
  const t = dot(normal, minus(rings[0][0], p));
  return oriented(plus(times(p, speed), times(direction, t)), speed);
}

const oriented = (point, weight) => (weight < 0n ? {point: times(point, -1n), weight: -weight} : {point, weight});

/** The place of an input point, as a fraction like the others. */
export const placeOf = (point) => ({point, weight: 1n});

/** The place on the line o + s·d, s in [0, 1] if `bounded`, that is nearest to `place`. */
export function nearestOnLine(origin, direction, place, bounded = false) {
  const length = dot(direction, direction);
  if (length === 0n) return placeOf(origin);
  const along = dot(direction, minus(place.point, times(origin, place.weight)));
  if (bounded && along <= 0n) return placeOf(origin);
  if (bounded && along >= length * place.weight) return placeOf(plus(origin, direction));
  return {point: plus(times(origin, length * place.weight), times(direction, along)), weight: length * place.weight};
}

/** log2 of the distance of two places, in units of the input. −∞ where they are one. */
export function logDistance(question, one, other) {
  const gap = minus(times(one.point, other.weight), times(other.point, one.weight));
  return logOf(dot(gap, gap), (one.weight * other.weight) ** 2n, 2 * question.exact.unit) / 2;
}

/** All edges of all rings as [from, to]. */
export const edgesOf = ({exact}) =>
    exact.rings.flatMap((ring) => ring.map((point, i) => [point, ring[(i + 1) % ring.length]]));

/** Where two lines in one plane meet, or null if they are parallel. */
function meeting([from, to], {p, direction}, normal) {
  const edge = minus(to, from);
  const side = cross(normal, edge);
  const speed = dot(side, direction);
  if (speed === 0n) return null;
  return oriented(plus(times(p, speed), times(direction, dot(side, minus(from, p)))), speed);
}

/**
 * The place to look at: where the line crosses the plane; where it lies in the plane or beside it, the place of the
 * target's boundary that is nearest to the probe.
 */
export function focusOf(question) {
  const crossing = crossingOf(question);
  if (crossing) return crossing;
  const {p, direction, q} = question.exact;
  const end = question.isRay ? plus(p, direction) : q;
  const normal = normalOf(question);
  const inPlane = !isZero(normal) && dot(normal, minus(p, question.exact.rings[0][0])) === 0n;
  const candidates = edgesOf(question).flatMap(
      (edge) =>
          [placeOf(edge[0]),
           ...(inPlane ? [meeting(edge, {p, direction}, normal)] : []).filter(Boolean),
           ...[p, end].map((point) => nearestOnLine(edge[0], minus(edge[1], edge[0]), placeOf(point), true)),
  ]);
  const gap = (place) => logDistance(question, place, nearestOnProbe(question, place));
  return candidates.reduce((best, place) => (gap(place) < gap(best) ? place : best));
}

/** The place of the segment or ray that is nearest to a place. */
export function nearestOnProbe(question, place) {
  const {p, direction} = question.exact;
  if (!question.isRay) return nearestOnLine(p, direction, place, true);
  const behind = dot(direction, minus(place.point, times(p, place.weight))) <= 0n;
  return behind ? placeOf(p) : nearestOnLine(p, direction, place);
}
