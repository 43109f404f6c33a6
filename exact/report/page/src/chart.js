// Speed against accuracy: a mark for each method in each population, and the frontier of what nobody beats in both.
import { code, h, svg, table } from './dom.js';
import { percent, percentTick, shareInWords, significant } from './figures.js';
import { linesWithBands } from './lines.js';
import { lookOf, markAt, markIcon } from './marks.js';
import { chooseRun } from './matrix.js';
import { inOrder, runsOf } from './report.js';
import { tabs } from './sweep.js';
import { to } from './route.js';

const sizeOf = () => (window.innerWidth < 760
  ? { width: 380, height: 330, left: 58, right: 14, top: 22, bottom: 46 }
  : { width: 900, height: 430, left: 66, right: 30, top: 22, bottom: 48 });

/** A logarithmic scale from values to pixels, with the powers in between. */
function logScale(values, from, to_) {
  const low = Math.log10(Math.min(...values)) - 0.12, high = Math.log10(Math.max(...values)) + 0.12;
  const place = (v) => from + ((Math.log10(v) - low) / (high - low)) * (to_ - from);
  const steps = high - low > 2.2 ? [1] : high - low > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const ticks = [];
  for (let e = Math.floor(low); e <= Math.ceil(high); ++e) {
    for (const s of steps) if (Math.log10(s) + e >= low && Math.log10(s) + e <= high) ticks.push(s * 10 ** e);
  }
  return { place, ticks };
}

/** Names beside their marks, where no other name or mark is. */
function placedNames(spots, box) {
  const taken = spots.map(({ x, y }) => [x - 8, y - 8, x + 8, y + 8]);
  const free = ([l, t, r, b]) => l > box.left && r < box.width && taken.every(([l2, t2, r2, b2]) => r < l2 || l > r2 || b < t2 || t > b2);
  return spots.map(({ x, y, name }) => {
    const width = 7 * name.length;
    const options = [['start', x + 11, y + 4], ['end', x - 11, y + 4], ['middle', x, y - 13], ['middle', x, y + 22], ['start', x + 9, y - 12], ['start', x + 9, y + 21], ['end', x - 9, y - 12], ['end', x - 9, y + 21]];
    const boxes = options.map(([anchor, px, py]) => {
      const left = anchor === 'start' ? px : anchor === 'end' ? px - width : px - width / 2;
      return [left, py - 11, left + width, py + 3];
    });
    const found = Math.max(0, boxes.findIndex(free));
    taken.push(boxes[found]);
    const [anchor, px, py] = options[found];
    return { 'text-anchor': anchor, x: px, y: py };
  });
}

const drawnOf = ({ answers }) => answers.drawn ?? (answers.wrong === 0 ? answers.upper : answers.share);

/** The points that no other beats in time and in share of wrong answers. */
function frontierOf(points) {
  const sorted = [...points].sort((a, b) => a.ns - b.ns || a.y - b.y);
  let best = Infinity;
  return sorted.filter((point) => point.y < best && ((best = point.y), true));
}

function axes(x, y, { width, height, left, right, top, bottom }) {
  return [
    x.ticks.map((v) => [svg('line', { class: 'rule', x1: x.place(v), x2: x.place(v), y1: top, y2: height - bottom }),
      svg('text', { x: x.place(v), y: height - bottom + 18, 'text-anchor': 'middle' }, significant(v))]),
    y.ticks.map((v) => [svg('line', { class: 'rule', x1: left, x2: width - right, y1: y.place(v), y2: y.place(v) }),
      svg('text', { x: left - 8, y: y.place(v) + 4, 'text-anchor': 'end' }, percentTick(v))]),
    svg('text', { x: (left + width - right) / 2, y: height - 8, 'text-anchor': 'middle' }, 'nanoseconds a test'),
    svg('text', { x: 4, y: 12, 'text-anchor': 'start' }, 'wrong'),
  ];
}

function markOf(p, x, y, name, say) {
  const [cx, cy] = [x.place(p.ns), y.place(p.y)];
  const bar = p.bound
    ? svg('path', { d: `M${cx},${cy}v20m-4,-5l4,5l4,-5`, fill: 'none', stroke: p.look.colour, 'stroke-width': 1.4 })
    : svg('line', { x1: cx, x2: cx, y1: y.place(p.upper), y2: y.place(Math.max(p.lower, p.y / 30)), stroke: p.look.colour, 'stroke-width': 1.6 });
  return svg('a', { href: p.href, 'aria-label': p.words, onfocus: () => say(p), onpointerenter: () => say(p) }, bar,
    markAt(p.look.shape, cx, cy, 6, { fill: p.bound ? 'var(--paper)' : p.look.colour, stroke: p.look.colour, 'stroke-width': 2 }),
    svg('text', { ...name, class: 'name' }, p.method));
}

function scatter(points, label, say) {
  const box = sizeOf();
  const x = logScale(points.map((p) => p.ns), box.left + 10, box.width - box.right);
  const lowest = points.map((p) => (p.bound ? p.y / 2 : Math.max(p.lower, p.y / 30)));
  const y = logScale([...points.map((p) => (p.bound ? p.y : p.upper)), ...lowest], box.height - box.bottom, box.top);
  const front = frontierOf(points);
  const path = front.map((p, i) => (i === 0 ? `M${x.place(p.ns)},${y.place(p.y)}` : `H${x.place(p.ns)}V${y.place(p.y)}`)).join('');
  const names = placedNames(points.map((p) => ({ x: x.place(p.ns), y: y.place(p.y), name: p.method })), box);
  return svg('svg', { class: 'scatter', viewBox: `0 0 ${box.width} ${box.height}`, role: 'group', 'aria-label': label },
    axes(x, y, box), svg('path', { class: 'frontier', d: path }), points.map((p, i) => markOf(p, x, y, names[i], say)));
}

function pointOf(run, row, look) {
  const { answers, nanoseconds } = row;
  return {
    method: row.method, ns: nanoseconds.median, y: drawnOf(row), lower: answers.lower, upper: answers.upper, bound: answers.wrong === 0, look,
    href: casesOf(row.method, row.fmt),
    words: `${row.method}: ${significant(nanoseconds.median)} ns a test (quartiles ${significant(nanoseconds.lower_quartile)} to ${significant(nanoseconds.upper_quartile)}); wrong: ${shareInWords(answers.wrong, answers.judged)}`,
  };
}

/** The matrix of a method, if some hunt has it; else its cases. */
function casesOf(method, fmt) {
  const hunt = runsOf('fuzz').find(({ methods }) => methods.includes(method));
  return hunt ? to('matrix', hunt.index, { method, fmt }) : to('cases', { method });
}

export function chartPage(path, query) {
  const runs = runsOf('chart');
  const run = runs.find(({ index }) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No chart is in this report.');
  const { record } = run;
  const timed = record.rows.filter((row) => row.nanoseconds?.median > 0 && row.answers?.judged > 0);
  const panels = record.panels.filter((panel) => timed.some((row) => row.population === panel.population && row.fmt === panel.fmt));
  const nameOf = (panel) => `${panel.title}, ${panel.fmt}`;
  const panel = panels.find((one) => nameOf(one) === query.get('panel')) ?? panels[0];
  const order = inOrder(record.rows.map((row) => row.method));
  const own = timed.filter((row) => row.population === panel?.population && row.fmt === panel?.fmt);
  const points = own.map((row) => pointOf(run, row, lookOf(order.indexOf(row.method))));
  const told = h('p', { class: 'detail', role: 'status' }, 'Point at a mark, or go there by the Tab key, for its figures; a click goes to its cases.');
  const front = new Set(frontierOf(points).map(({ method }) => method));
  return [
    h('h1', {}, 'What being right costs'),
    h('p', { class: 'lead' }, 'To the left is faster, down is right more often; both axes are logarithmic, and all marks were given the same cases. A hollow mark was never wrong: it stands at the most that its share may be, with 95 % confidence. The line is the frontier: nobody is both faster and more often right.'),
    chooseRun(runs, run.index, 'chart'),
    tabs('population', panels.map(nameOf), panel && nameOf(panel), (name) => to('chart', run.index, { panel: name })),
    panel && h('p', {}, `${panel.about}.`),
    points.length > 0 && [told, scatter(points, `time against wrong answers: ${nameOf(panel)}`, (p) => told.replaceChildren(p.words)),
      table(['', 'method', 'ns a test', 'wrong', 'judged', 'share', 'at most', 'frontier'], own.sort((a, b) => a.nanoseconds.median - b.nanoseconds.median).map((row) => [
        markIcon(lookOf(order.indexOf(row.method))), code(row.method), { cell: significant(row.nanoseconds.median), class: 'n' }, { cell: row.answers.wrong, class: 'n' }, { cell: row.answers.judged, class: 'n' },
        { cell: percent(row.answers.share), class: 'n' }, { cell: percent(row.answers.upper), class: 'n' }, front.has(row.method) ? '●' : '']), { label: 'speed and accuracy' })],
    onset(record, order),
  ];
}

/** Shares of wrong answers against how long the numbers are. */
function onset(record, order) {
  const own = (record.onset ?? []).filter((row) => row.answers?.judged > 0);
  if (own.length === 0) return null;
  const fmt = own.some((row) => row.fmt === 'binary64') ? 'binary64' : own[0].fmt;
  const of = own.filter((row) => row.fmt === fmt);
  const xs = [...new Set(of.map((row) => row.bits))].sort((a, b) => a - b);
  const series = order.map((name) => ({ name, points: xs.map((bits) => {
    const answers = of.find((row) => row.method === name && row.bits === bits)?.answers;
    return answers ? { n: answers.judged, k: answers.wrong, share: answers.share, lower: answers.lower, upper: answers.upper } : null;
  }) })).filter(({ points }) => points.some(Boolean));
  return h('section', {}, h('h2', {}, 'How long the numbers must be'),
    h('p', {}, `Exactly degenerate ${fmt} cases with so many bits in their coordinates. While every product is exact, everybody is right.`),
    linesWithBands({ xs, series, xTitle: 'bits of the coordinates', label: 'share of wrong answers against bits', go: ({ name }) => { location.hash = casesOf(name, fmt); } }));
}

