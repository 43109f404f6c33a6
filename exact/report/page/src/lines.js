// Lines with bands: shares along an axis, by uPlot. A share of 0 has no place on a logarithmic axis: it is drawn
// hollow at the bound that its sample leaves open, as the program's own figures do.
import uPlot from 'uplot';

import {h} from './dom.js';
import {percentTick, shareInWords, significant} from './figures.js';
import {lookOf, markIcon, traceMark} from './marks.js';

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let shown = [];

/** Frees the drawings of the page that is left. */
export function leaveLines() {
  for (const {plot, observer} of shown) {
    observer.disconnect();
    plot.destroy();
  }
  shown = [];
}

const drawn = (point) => (point ? (point.k === 0 ? point.upper : point.share) : null);

/** Marks in their shapes; hollow where nothing failed. */
function marksPath(series, look) {
  return (u, index) => {
    const {ctx} = u;
    const ratio = devicePixelRatio;
    ctx.save();
    ctx.fillStyle = look.colour;
    ctx.strokeStyle = look.colour;
    ctx.lineWidth = 1.5 * ratio;
    series.points.forEach((point, i) => {
      if (!point) return;
      const x = u.valToPos(u.data[0][i], 'x', true), y = u.valToPos(u.data[index][i], 'y', true);
      traceMark(ctx, look.shape, x, y, 3.6 * ratio);
      if (point.k === 0) {
        ctx.fillStyle = css('--paper');
        ctx.fill();
        ctx.stroke();
        ctx.fillStyle = look.colour;
      } else
        ctx.fill();
    });
    ctx.restore();
  };
}

/**
 * series: [{name, points: [{n, k, share, lower, upper} or null, one for each x]}]; `go(series, i)` is where a click
 * leads, and `also(series, i)` says what else there is where something failed.
 */
export function linesWithBands({xs, series, xTitle, logarithmic, label, go, also}) {
  const looks = series.map((_, i) => lookOf(i));
  const told =
      h('p', {class: 'detail', role: 'status'},
        'Point at a line, or use the arrow keys, for figures; Enter goes to the cases.');
  const box = h('div', {
    class: 'lines',
    tabindex: 0,
    role: 'img',
    'aria-label': `${label}. Left and right move along the axis, up and down between methods, Enter goes to the cases.`
  });
  const x = logarithmic ? xs.map(Math.log2) : xs;
  const data = [
    x, ...series.map(({points}) => points.map(drawn)),
    ...series.flatMap(
        ({points}) =>
            [points.map((p) => (p?.k > 0 ? p.upper : null)),
             points.map((p) => (p?.k > 0 ? Math.max(p.lower, floorOf(series)) : null))])
  ];
  const n = series.length;
  const axisStyle = {
    stroke: css('--faint'),
    grid: {stroke: css('--line'), width: 1},
    ticks: {stroke: css('--line')},
    font: '12px system-ui, sans-serif'
  };
  const options = {
    width: 600,
    height: 340,
    legend: {show: false},
    cursor: {y: false, points: {show: false}, drag: {x: false, y: false}},
    scales: {x: {time: false, range: padded}, y: {distr: 3, range: () => [floorOf(series), 1.3]}},
    axes: [
      {...axisStyle, values: (_, ticks) => ticks.map((v) => (logarithmic ? significant(2 ** v) : significant(v)))},
      {
        ...axisStyle,
        size: 62,
        splits: () => powersOfTen(floorOf(series)),
        filter: (_, ticks) => ticks,
        values: (_, ticks) => ticks.map(percentTick)
      },
    ],
    series: [
      {}, ...looks.map((look, i) => ({
                         label: series[i].name,
                         stroke: look.colour,
                         width: 2,
                         dash: look.dash,
                         points: {show: false},
                         spanGaps: true
                       })),
      ...series.flatMap(
          () => [{stroke: 'transparent', points: {show: false}}, {stroke: 'transparent', points: {show: false}}])
    ],
    bands: series.map(
        (_, i) => (
            {series: [n + 1 + 2 * i, n + 2 + 2 * i], fill: `color-mix(in srgb, ${looks[i].colour} 14%, transparent)`})),
    hooks: {
      draw: [(u) => series.forEach((one, i) => marksPath(one, looks[i])(u, i + 1))],
      setCursor: [(u) => pointAt(u)],
    },
  };
  const plot = new uPlot(options, data, box);
  let at = [0, firstOf(series[0])];

  function say(s, i) {
    at = [s, i];
    const point = series[s].points[i];
    told.replaceChildren(
        h('b', {}, `${series[s].name}, at ${significant(xs[i])}: `),
        point ? shareInWords(point.k, point.n) : 'nobody was asked', (point?.k > 0 && also?.(series[s], i)) || '');
  }
  function pointAt(u) {
    const {idx, top} = u.cursor;
    if (idx === null || idx === undefined || top < 0) return;
    const near =
        series.map(({points}, s) => [Math.abs(points[idx] ? u.valToPos(drawn(points[idx]), 'y') - top : Infinity), s])
            .sort((a, b) => a[0] - b[0])[0];
    if (near[0] < Infinity) say(near[1], idx);
  }
  function move(ds, di) {
    const s = (at[0] + ds + series.length) % series.length;
    let i = at[1] + di;
    while (i >= 0 && i < xs.length && !series[s].points[i]) i += di || 1;
    if (i < 0 || i >= xs.length) return;
    say(s, i);
    plot.setCursor({left: plot.valToPos(x[i], 'x'), top: -10});
  }
  const keys = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]};
  box.addEventListener('keydown', (event) => {
    if (event.key === 'Enter')
      go?.(series[at[0]], at[1]);
    else if (keys[event.key])
      move(...keys[event.key]);
    else
      return;
    event.preventDefault();
  });
  box.addEventListener('click', () => go?.(series[at[0]], at[1]));
  const observer = new ResizeObserver(
      () => plot.setSize({width: Math.max(280, box.clientWidth), height: box.clientWidth < 500 ? 280 : 340}));
  observer.observe(box);
  shown.push({plot, observer});
  return h(
      'figure', {class: 'plot'}, told, box, h('p', {class: 'axis-title'}, xTitle),
      h('p', {class: 'legend'}, series.map(({name}, i) => h('span', {}, markIcon(looks[i]), name)),
        h('span', {}, 'hollow: none seen, drawn at the bound that the sample leaves')));
}

const firstOf = ({points}) => Math.max(0, points.findIndex(Boolean));

/** The lowest power of ten that something reaches. */
function floorOf(series) {
  const lowest = Math.min(0.1, ...series.flatMap(({points}) => points.filter(Boolean).map(drawn)).filter((y) => y > 0));
  return 10 ** Math.floor(Math.log10(lowest));
}

const powersOfTen = (floor) => Array.from({length: Math.round(-Math.log10(floor)) + 1}, (_, i) => 10 ** -i).reverse();

const padded = (_, low, high) => {
  const margin = (high - low || 1) * 0.03;
  return [low - margin, high + margin];
};
