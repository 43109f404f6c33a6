// Drawings of classes, from the numbers of the schema: a box of 120 × 90, y downward.
import {svg} from './dom.js';

const pointsOf = (spots) => spots.map((spot) => spot.join(',')).join(' ');

function line(name, [[x1, y1], [x2, y2]]) {
  return svg('line', {class: name, x1, y1, x2, y2});
}

/** The head of an arrow at the second point. */
function head([[x1, y1], [x2, y2]]) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  if (length === 0) return null;
  const [u, v] = [(x2 - x1) / length, (y2 - y1) / length];
  const wing = (side) => [x2 - 7 * u + side * 3.5 * v, y2 - 7 * v - side * 3.5 * u];
  return svg('polygon', {class: 'arrow', points: pointsOf([[x2, y2], wing(1), wing(-1)])});
}

/** Squares for vertices of the triangle, discs for the probe, both where they coincide. */
function dot({x, y, of}) {
  const onTriangle = /[abc]/.test(of), onProbe = /[pqod]/.test(of);
  const right = x > 92;
  return [
    onTriangle && svg('rect', {class: 'vertex', x: x - 2.6, y: y - 2.6, width: 5.2, height: 5.2}),
    onProbe && svg('circle', {class: 'end', cx: x, cy: y, r: onTriangle ? 1.7 : 2.6}),
    svg('text', {x: right ? x - 5 : x + 5, y: y < 14 ? y + 9 : y - 4, 'text-anchor': right ? 'end' : 'start'}, of),
  ];
}

function meeting(spots) {
  if (!spots) return null;
  if (spots.length === 1) return svg('circle', {class: 'meet', cx: spots[0][0], cy: spots[0][1], r: 5.5});
  return line('meet', spots);
}

/** The drawing of a row of `classes`. */
export function sketchOf(row) {
  const {tri, probe, arrow, dots, meet, hidden} = row.sketch;
  return svg(
      'svg', {class: 'sketch', viewBox: '0 0 120 90', role: 'img', 'aria-label': `Sketch of class ${row.id}`},
      svg('polygon', {class: 'face', points: pointsOf(tri)}), line('probe', probe), hidden && line('behind', hidden),
      meeting(meet), arrow && head(probe), (dots ?? []).map(dot));
}
