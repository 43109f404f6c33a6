// What lies over the 3D view, in the plane of the picture: the head of a ray, a mark where its line crosses the plane,
// and names that lie neither on each other nor, if there is room, on a line. Points are [x, y] in CSS pixels.

const isSeen = (point) => point.every((x) => Math.abs(x) < 1e5);

/** The part of a stretch within a box [left, top, right, bottom], by Liang and Barsky; null if there is none. */
export function clipped([x, y], [u, v], [left, top, right, bottom]) {
  let from = 0, to = 1;
  for (const [step, gap] of [[x - u, x - left], [u - x, right - x], [y - v, y - top], [v - y, bottom - y]]) {
    if (step === 0 && gap < 0) return null;
    if (step < 0) from = Math.max(from, gap / step);
    if (step > 0) to = Math.min(to, gap / step);
  }
  return from > to ? null : [[x + from * (u - x), y + from * (v - y)], [x + to * (u - x), y + to * (v - y)]];
}

/** The head of an arrow where a ray leaves the picture. */
export function arrowHead(context, from, to, {width, height}, colour) {
  const part = clipped(from, to, [4, 4, width - 4, height - 4]);
  if (!part) return;
  const [[x, y], [u, v]] = part;
  const length = Math.hypot(u - x, v - y);
  if (length < 20) return;
  const [dx, dy] = [(u - x) / length, (v - y) / length];
  context.fillStyle = colour;
  context.beginPath();
  context.moveTo(u, v);
  for (const side of [1, -1]) context.lineTo(u - 17 * dx - side * 7 * dy, v - 17 * dy + side * 7 * dx);
  context.fill();
}

/** A ring, whole where probe and target meet and broken where only the probe's line crosses the target's plane. */
export function ring(context, point, isContact, {ink, card}) {
  if (!isSeen(point)) return;
  for (const [colour, width] of [[card, 4.5], [ink, 2]]) {
    context.setLineDash(isContact ? [] : [4, 3]);
    Object.assign(context, {strokeStyle: colour, lineWidth: width});
    context.beginPath();
    context.arc(...point, 10, 0, 2 * Math.PI);
    context.stroke();
  }
  context.setLineDash([]);
}

/** The way from the probe to where its line crosses the plane, if the probe itself does not reach there. */
export function dashed(context, from, to, colour) {
  if (!isSeen(from) || !isSeen(to)) return;
  context.setLineDash([3, 5]);
  Object.assign(context, {strokeStyle: colour, lineWidth: 1.6});
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
  context.setLineDash([]);
}

const meet = (a, b) => a[0] < b[2] && a[2] > b[0] && a[1] < b[3] && a[3] > b[1];

const sides =
    [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1.5], [0, 1.5], [1.5, 0], [-1.5, 0], [2, -2], [2, 2], [-2, -2], [-2, 2]];

/**
 * Places for names beside their points, relative to these: each where it meets fewest of the other points, of the names
 * that are placed, of the lines, and of the picture's edge. `names`: [{point, width}].
 */
export function placesForNames(names, lines, {width, height}) {
  const points = names.map(({point: [x, y]}) => [x - 6, y - 6, x + 6, y + 6]);
  const placed = [];
  return names.map(({point: [x, y], width: long}) => {
    const boxAt = ([dx, dy]) => {
      const [cx, cy] = [x + dx * (8 + long / 2), y + dy * 15];
      return [cx - long / 2, cy - 9, cx + long / 2, cy + 9];
    };
    const cost = (box) => 10 * placed.filter((other) => meet(box, other)).length +
        4 * points.filter((other) => meet(box, other)).length + lines.filter(([a, b]) => clipped(a, b, box)).length +
        (box[0] < 0 || box[1] < 0 || box[2] > width || box[3] > height ? 20 : 0);
    const best = sides.map(boxAt).reduce((a, b) => (cost(b) < cost(a) ? b : a));
    placed.push(best);
    return [best[0] - x, best[1] - y];
  });
}
