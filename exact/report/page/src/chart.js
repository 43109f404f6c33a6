// Speed against accuracy: a mark for each method in each population, and the frontier of what nobody beats in both.
import {code, h, svg, table} from './dom.js';
import {grouped, percent, percentTick, shareInWords, significant} from './figures.js';
import {linesWithBands} from './lines.js';
import {chooseRun} from './lists.js';
import {lookOf, markAt, markIcon} from './marks.js';
import {inOrder, runsOf} from './report.js';
import {to} from './route.js';
import {tabs} from './sweep.js';

const sizeOf = () =>
    (window.innerWidth < 760 ? {width: 380, height: 330, left: 58, right: 14, top: 22, bottom: 26} :
                               {width: 820, height: 430, left: 66, right: 30, top: 22, bottom: 28});

/** A logarithmic scale from values to pixels, with the powers in between. */
function logScale(values, from, to_) {
  const low = Math.log10(Math.min(...values)) - 0.12, high = Math.log10(Math.max(...values)) + 0.12;
  const place = (v) => from + ((Math.log10(v) - low) / (high - low)) * (to_ - from);
  const steps = high - low > 2.2 ? [1] : high - low > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const ticks = [];
  for (let e = Math.floor(low); e <= Math.ceil(high); ++e) {
    for (const s of steps)
      if (Math.log10(s) + e >= low && Math.log10(s) + e <= high) ticks.push(s * 10 ** e);
  }
  return {place, ticks: apart(ticks, place)};
}

/** Ticks whose labels have room: a power of ten before others. */
function apart(ticks, place) {
  const isPower = (v) => Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9;
  const kept = [];
  for (const v of [...ticks.filter(isPower), ...ticks.filter((t) => !isPower(t))])
    if (kept.every((other) => Math.abs(place(v) - place(other)) >= 36)) kept.push(v);
  return kept.sort((x, y) => x - y);
}

/** A number beside each mark, where no other number, mark or error bar is. */
function placedNumbers(spots, box) {
  const taken = spots.flatMap(({x, y, bars}) => [[x - 9, y - 9, x + 9, y + 9], ...bars]);
  const meets = ([l, t, r, b], [l2, t2, r2, b2]) => r > l2 && l < r2 && b > t2 && t < b2;
  const inside = ([l, t, r, b]) => l > box.left && r < box.width && t > 0 && b < box.height - box.bottom;
  return spots.map(({x, y, number}) => {
    const half = 4.2 * String(number).length;
    const at = [
      [0, -18], [0, 18], [16, 0], [-16, 0], [14, -15], [-14, -15], [14, 15], [-14, 15], [0, -33], [0, 33], [22, -27],
      [-22, -27], [22, 27], [-22, 27]
    ].map(([dx, dy]) => [x + dx, y + dy]);
    const boxOf = ([cx, cy]) => [cx - half, cy - 7, cx + half, cy + 7];
    const cost = (place) => taken.filter((one) => meets(boxOf(place), one)).length + (inside(boxOf(place)) ? 0 : 100);
    const best = at.reduce((a, b) => (cost(b) < cost(a) ? b : a));
    taken.push(boxOf(best));
    return {'text-anchor': 'middle', x: best[0], y: best[1] + 4.5};
  });
}

/** The points that no other beats in time and in share of wrong answers. */
function frontierOf(points) {
  const sorted = [...points].sort((a, b) => a.time - b.time || a.y - b.y);
  let best = Infinity;
  return sorted.filter((point) => point.y < best && ((best = point.y), true));
}

function axes(x, y, {width, height, left, right, top, bottom}) {
  return [
    x.ticks.map(
        (v) =>
            [svg('line', {class: 'rule', x1: x.place(v), x2: x.place(v), y1: top, y2: height - bottom}),
             svg('text', {x: x.place(v), y: height - bottom + 18, 'text-anchor': 'middle'}, significant(v))]),
    y.ticks.map(
        (v) =>
            [svg('line', {class: 'rule', x1: left, x2: width - right, y1: y.place(v), y2: y.place(v)}),
             svg('text', {x: left - 8, y: y.place(v) + 4, 'text-anchor': 'end'}, percentTick(v))]),
    svg('text', {x: 4, y: 12, 'text-anchor': 'start'}, 'wrong'),
  ];
}

/** The error bars of a mark, or the arrow of one that was never wrong: [x1, y1, x2, y2] each. */
function barsOf(p, x, y) {
  const [cx, cy] = [x.place(p.time), y.place(p.y)];
  const upright = p.bound ? [cx, cy, cx, cy + 20] : [cx, y.place(p.upper), cx, y.place(Math.max(p.lower, p.y / 30))];
  return [upright, ...(p.from ? [[x.place(p.from), cy, x.place(p.to), cy]] : [])];
}

function barsDrawn(p, x, y) {
  const stroke = {stroke: p.look.colour, 'stroke-width': 1.6};
  return [
    barsOf(p, x, y).map(([x1, y1, x2, y2]) => svg('line', {x1, y1, x2, y2, ...stroke})),
    p.bound && svg('path', {d: `M${x.place(p.time) - 4},${y.place(p.y) + 15}l4,5l4,-5`, fill: 'none', ...stroke})
  ];
}

function markOf(p, x, y, number, say) {
  return svg(
      'a', {href: p.href, 'aria-label': `${p.number} ${p.words}`, onfocus: () => say(p), onpointerenter: () => say(p)},
      markAt(
          p.look.shape, x.place(p.time), y.place(p.y), 6,
          {fill: p.bound ? 'var(--paper)' : p.look.colour, stroke: p.look.colour, 'stroke-width': 2}),
      svg('text', {...number, class: 'number'}, String(p.number)));
}

/** Marks with numbers, and beside them whose they are. */
function scatter(points, label, xTitle, say) {
  const box = sizeOf();
  const x =
      logScale(points.flatMap((p) => [p.time, p.from ?? p.time, p.to ?? p.time]), box.left + 10, box.width - box.right);
  const lowest = points.map((p) => (p.bound ? p.y / 2 : Math.max(p.lower, p.y / 30)));
  const y = logScale([...points.map((p) => (p.bound ? p.y : p.upper)), ...lowest], box.height - box.bottom, box.top);
  const path =
      frontierOf(points)
          .map((p, i) => (i === 0 ? `M${x.place(p.time)},${y.place(p.y)}` : `H${x.place(p.time)}V${y.place(p.y)}`))
          .join('');
  const numbers = placedNumbers(
      points.map((p) => ({
                   x: x.place(p.time),
                   y: y.place(p.y),
                   number: p.number,
                   bars: barsOf(p, x, y).map(([l, t, r, b]) => [l - 2, Math.min(t, b) - 2, r + 2, Math.max(t, b) + 2])
                 })),
      box);
  const drawing =
      svg('svg', {class: 'scatter', viewBox: `0 0 ${box.width} ${box.height}`, role: 'group', 'aria-label': label},
          axes(x, y, box), svg('path', {class: 'frontier', d: path}), points.map((p) => barsDrawn(p, x, y)),
          points.map((p, i) => markOf(p, x, y, numbers[i], say)));
  const whose =
      h('ol', {class: 'who'},
        points.map(
            (p) => h('li', {onpointerenter: () => say(p)}, h('b', {}, p.number), markIcon(p.look), code(p.method))));
  return h('div', {class: 'chart-box'}, h('div', {}, drawing, h('p', {class: 'axis-title'}, xTitle)), whose);
}

/** The matrix of a method, if some hunt has it; else its cases. */
function casesOf(method, fmt) {
  const hunt = runsOf('fuzz').find(({methods}) => methods.includes(method));
  return hunt ? to('matrix', hunt.index, {method, fmt}) : to('cases', {method});
}

/** What a mark needs of its share of wrong answers. */
function shareOf({wrong, judged, share, lower, upper}) {
  return {y: wrong === 0 ? upper : share, k: wrong, n: judged, share, lower, upper, bound: wrong === 0};
}

/** All pixels of some scenes are no sample, so there is no interval; none wrong is drawn at half a pixel. */
function shareOfPixels({wrong, pixels}) {
  const y = (wrong || 0.5) / pixels;
  return {y, k: wrong, n: pixels, share: wrong / pixels, lower: y, upper: y, bound: wrong === 0, counted: true};
}

/** Times of tests, as multiples of the yardstick's where the record has them: these hold on other machines too. */
function panelsOfTests(record) {
  const timed = record.rows.filter((row) => row.nanoseconds?.median > 0 && row.answers?.judged > 0);
  const names = record.panels.map((panel) => `${panel.title}, ${panel.fmt}`);
  return record.panels.map((panel, i) => {
    const own = timed.filter((row) => row.population === panel.population && row.fmt === panel.fmt);
    const relative = record.yardstick !== undefined && own.every((row) => row.nanoseconds.ratio);
    const unit = relative ? `times ${record.yardstick}` : 'ns a test';
    return {
      name: names.indexOf(names[i]) === names.lastIndexOf(names[i]) ? names[i] : `${names[i]}, ${panel.population}`,
      about: panel.about,
      unit,
      xTitle: relative ? `time, in multiples of ${record.yardstick}` : 'nanoseconds a test',
      points: own.map((row) => {
        const {median, lower_quartile, upper_quartile, ratio} = row.nanoseconds;
        return {
          method: row.method,
          fmt: row.fmt,
          time: relative ? ratio.median : median,
          from: relative ? ratio.lower : null,
          to: relative ? ratio.upper : null,
          ...shareOf(row.answers),
          timeInWords: `${relative ? `${significant(ratio.median)} times ${record.yardstick}, ` : ''}${
              significant(
                  median)} ns a test (quartiles ${significant(lower_quartile)} to ${significant(upper_quartile)})`,
        };
      }),
    };
  });
}

/** Whole pictures: time a ray against pixels that show a wrong answer. */
function panelOfPictures({pictures}) {
  const drawn = (pictures?.rows ?? []).filter((row) => row.pixels > 0 && row.rays_per_second?.median > 0);
  return [...new Set(drawn.map((row) => row.fmt))].map(
      (fmt) => ({
        name: `Pictures, ${fmt}`,
        about: `Pixels that show a wrong answer, of ${
            pictures.scenes?.length ??
            'some'} scenes; what differs only because a secondary ray starts elsewhere is not wrong. Shares have no interval, since all pixels are counted; a hollow mark stands at half a pixel`,
        unit: 'ns a ray',
        xTitle: 'nanoseconds a ray, one thread',
        points: drawn.filter((row) => row.fmt === fmt)
                    .map((row) => ({
                           method: row.method,
                           fmt,
                           time: 1e9 / row.rays_per_second.median,
                           ...shareOfPixels(row),
                           timeInWords: `${significant(row.rays_per_second.median / 1e6)} million rays a second`,
                         })),
      }));
}

function leaksOf({leaks}) {
  if (!leaks?.rows?.length) return null;
  return h(
      'section', {}, h('h2', {}, `Leaks of ${leaks.mesh}`),
      table(
          ['method', 'format', 'rays', 'leaks', 'share', 'at most'],
          leaks.rows.map(
              (row) =>
                  [code(row.method), row.fmt.replace('binary', ''), {cell: grouped(row.rays), class: 'n'},
                   {cell: row.leaks > 0 ? h('b', {class: 'wrong'}, grouped(row.leaks)) : '0', class: 'n'},
                   {cell: percent(row.share), class: 'n'}, {cell: percent(row.upper), class: 'n'}]),
          {label: 'leaks'}));
}

/** The population with the most wrong answers; the first of those that have as many. */
function mostWrong(panels) {
  const wrong = ({points}) => points.reduce((sum, {k}) => sum + k, 0);
  return panels.reduce((worst, panel) => (worst && wrong(worst) >= wrong(panel) ? worst : panel), null);
}

export function chartPage(path, query) {
  const runs = runsOf('chart');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No chart is in this report.');
  const {record} = run;
  const panels = [...panelsOfTests(record), ...panelOfPictures(record)].filter(({points}) => points.length > 0);
  const panel = panels.find(({name}) => name === query.get('panel')) ?? mostWrong(panels);
  const order = inOrder(record.methods.map(({name}) => name));
  const told =
      h('p', {class: 'detail', role: 'status'},
        'Point at a mark, or go there by the Tab key, for its figures; a click goes to its cases.');
  const points = (panel?.points ?? [])
                     .map((p) => ({
                            ...p,
                            look: lookOf(order.indexOf(p.method)),
                            href: casesOf(p.method, p.fmt),
                            words: `${p.method}: ${p.timeInWords}; wrong: ${shareInWords(p.k, p.n)}`,
                          }))
                     .sort((a, b) => a.time - b.time)
                     .map((p, i) => ({...p, number: i + 1}));
  const front = new Set(frontierOf(points).map(({method}) => method));
  return [
    h('h1', {}, 'What being right costs'),
    h('p', {class: 'lead'},
      'To the left is faster, down is right more often; both axes are logarithmic, and all marks were given the same cases. A hollow mark was never wrong: it stands at the most that its share may be, with 95\u00a0% confidence, where the cases are a sample. The line is the frontier: nobody is both faster and more often right.'),
    chooseRun(runs, run.index, 'chart'),
    tabs('population', panels.map(({name}) => name), panel?.name, (name) => to('chart', run.index, {panel: name})),
    panel && h('p', {}, `${panel.about}.`),
    points.length > 0 &&
        [
          told,
          scatter(
              points, `time against wrong answers: ${panel.name}`, panel.xTitle, (p) => told.replaceChildren(p.words)),
          table(
              ['method', panel.unit, 'wrong', 'judged', 'share', 'at most', 'frontier'],
              points.map(
                  (p) => [
                      [h('b', {}, `${p.number} `), markIcon(p.look), ' ', code(p.method)],
                      {cell: significant(p.time), class: 'n'}, {cell: grouped(p.k), class: 'n'},
                      {cell: grouped(p.n), class: 'n'}, {cell: percent(p.share), class: 'n'},
                      {cell: p.counted ? '' : percent(p.upper), class: 'n'}, front.has(p.method) ? '●' : '']),
              {label: 'speed and accuracy'})
        ],
    onset(record, order),
    leaksOf(record),
  ];
}

/** Shares of wrong answers against how long the numbers are. */
function onset(record, order) {
  const own = (record.onset ?? []).filter((row) => row.answers?.judged > 0);
  if (own.length === 0) return null;
  const fmt = own.some((row) => row.fmt === 'binary64') ? 'binary64' : own[0].fmt;
  const of = own.filter((row) => row.fmt === fmt);
  const xs = [...new Set(of.map((row) => row.bits))].sort((a, b) => a - b);
  const series = order
                     .map((name) => ({
                            name,
                            points: xs.map((bits) => {
                              const answers = of.find((row) => row.method === name && row.bits === bits)?.answers;
                              return answers ? {
                                n: answers.judged,
                                k: answers.wrong,
                                share: answers.share,
                                lower: answers.lower,
                                upper: answers.upper
                              } :
                                               null;
                            })
                          }))
                     .filter(({points}) => points.some(Boolean));
  return h(
      'section', {}, h('h2', {}, 'How long the numbers must be'),
      h('p', {},
        `Exactly degenerate ${
            fmt} cases with so many bits in their coordinates. While every product is exact, everybody is right.`),
      linesWithBands({
        xs,
        series,
        xTitle: 'bits of the coordinates',
        label: 'share of wrong answers against bits',
        go: ({name}) => {
          location.hash = casesOf(name, fmt);
        }
      }));
}
