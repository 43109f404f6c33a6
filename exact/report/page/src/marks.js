// How methods are told apart: a colour for each family of methods (Okabe and Ito's, which stay apart for colour-blind
// eyes), a shape for the kind of number, a dash for the order in the drawing; never by colour alone.
import {svg} from './dom.js';

const shapes = ['disc', 'square', 'triangle', 'diamond', 'cross', 'star', 'bar', 'wedge'];
const dashes = [[], [7, 4], [2, 3], [10, 3, 2, 3], [4, 2], [1, 4]];

const colour = (i) => getComputedStyle(document.documentElement).getPropertyValue(`--series-${i % 8}`).trim();

/** The look of item i of a drawing. Where colours begin again shapes are shifted, so 64 items have 64 looks. */
export const lookOf = (i) => ({
  colour: colour(i),
  shape: shapes[(i + Math.floor(i / shapes.length)) % shapes.length],
  dash: dashes[i % dashes.length]
});

const outlines = {
  square: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
  triangle: [[0, -1.25], [1.15, 0.9], [-1.15, 0.9]],
  wedge: [[0, 1.25], [1.15, -0.9], [-1.15, -0.9]],
  diamond: [[0, -1.35], [1.35, 0], [0, 1.35], [-1.35, 0]],
  star: Array.from(
      {length: 10},
      (_, i) => {
        const r = i % 2 ? 0.62 : 1.5;
        return [r * Math.sin(i * Math.PI / 5), -r * Math.cos(i * Math.PI / 5)];
      }),
  bar: [[-1.4, -0.5], [1.4, -0.5], [1.4, 0.5], [-1.4, 0.5]],
  cross: [
    [-0.4, -1.3], [0.4, -1.3], [0.4, -0.4], [1.3, -0.4], [1.3, 0.4], [0.4, 0.4], [0.4, 1.3], [-0.4, 1.3], [-0.4, 0.4],
    [-1.3, 0.4], [-1.3, -0.4], [-0.4, -0.4]
  ],
};

/** A mark at a place of an SVG drawing; hollow ones stand for a bound. */
export function markAt(shape, x, y, r, attributes) {
  const points = outlines[shape];
  if (!points) return svg('circle', {cx: x, cy: y, r, ...attributes});
  return svg('polygon', {points: points.map(([u, v]) => `${x + u * r},${y + v * r}`).join(' '), ...attributes});
}

/** The same on a canvas, as a path. */
export function traceMark(context, shape, x, y, r) {
  const points = outlines[shape];
  context.beginPath();
  if (!points)
    context.arc(x, y, r, 0, 2 * Math.PI);
  else
    points.forEach(
        ([u, v], i) => (i === 0 ? context.moveTo(x + u * r, y + v * r) : context.lineTo(x + u * r, y + v * r)));
  context.closePath();
}

/** The mark as a little picture for a legend. */
export const markIcon = ({colour: ink, shape}) =>
    svg('svg', {class: 'icon', viewBox: '-8 -8 16 16', 'aria-hidden': 'true'}, markAt(shape, 0, 0, 5, {fill: ink}));
