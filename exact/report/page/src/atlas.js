// The classes: 163 of a segment and a triangle, 165 of a ray and a triangle, as drawings.
import {h, link, table} from './dom.js';
import {grouped, percent} from './figures.js';
import {caseList, casesWith} from './lists.js';
import {classRow, inOrder, report, rows, runsOf} from './report.js';
import {to} from './route.js';
import {sketchOf} from './sketch.js';
import {tabs} from './sweep.js';

const kinds = {
  segments: (row) => row.id.startsWith('C'),
  rays: (row) => row.id.startsWith('R')
};
const meets = {
  all: () => true,
  'no contact': (row) => row.intersection === 'empty',
  'a point': (row) => row.intersection === 'point',
  'a segment': (row) => row.intersection === 'segment'
};

export function atlasPage(query) {
  const kind = query.get('of') in kinds ? query.get('of') : 'segments';
  const meet = query.get('meet') in meets ? query.get('meet') : 'all';
  const shown = report.classes.filter((row) => kinds[kind](row) && meets[meet](row));
  return [
    h('h1', {}, 'The classes'),
    h('p', {class: 'lead'},
      'Up to the order of vertices, direction and reflection there are 163 ways for a segment and a triangle to lie, and 165 for a ray. Squares are the triangle’s vertices, discs the probe’s ends; a ring or a thick line is where they meet.'),
    h('div', {class: 'tab-row'}, tabs('probe', Object.keys(kinds), kind, (of) => to('classes', {of, meet})),
      tabs('meet in', Object.keys(meets), meet, (name) => to('classes', {of: kind, meet: name}))),
    h('p', {class: 'note'}, `${shown.length} classes.`),
    h('ul', {class: 'atlas'},
      shown.map(
          (row) => h(
              'li', {}, h('a', {href: to('class', row.id), title: row.words}, sketchOf(row), h('span', {}, row.id))))),
  ];
}

const meetings = {
  empty: 'nothing',
  point: 'a point',
  segment: 'a segment'
};

export function classPage(id) {
  const row = classRow(id);
  if (!row) return h('p', {}, 'There is no such class.');
  const list = report.classes.filter((one) => one.id[0] === id[0]);
  const place = list.indexOf(row);
  const step = (target, text) => target && link(to('class', target.id), text);
  const numbers = casesWith({cases: report.cases.map((_, i) => i)}, {slot: id});
  const names = row.id.startsWith('R') ? ['a', 'b', 'c', 'o', 'd'] : ['a', 'b', 'c', 'p', 'q'];
  return [
    h('p', { class: 'crumbs' }, link(to('classes', { of: row.id.startsWith('R') ? 'rays' : 'segments' }), 'classes'), ' ', h('span', { class: 'steps' }, step(list[place - 1], '←'), ' ', step(list[place + 1], '→'))),
    h('h1', {}, `Class ${row.id}`), h('p', { class: 'lead' }, row.words),
    h('div', { class: 'class-card large' }, h('div', {}, sketchOf(row)),
      h('dl', { class: 'facts' }, [['meet in', meetings[row.intersection] ?? row.intersection], ['touches', row.hit ? row.touches : null], ['contact', row.hit ? row.contact : 'none'], ['signs abcp abcq pqab pqbc pqca', row.signs.map((s) => '−0+'[s + 1]).join(' ')],
        ['a representative', row.points.map((point, i) => `${names[i]} = (${point.join(', ')})`).join(', ')],
        ['the paper’s reading', row.also?.transversal === undefined ? null : row.also.transversal ? 'a hit' : 'no hit']].filter(([, value]) => value !== null && value !== undefined).map(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]))),
    wrongHere(id),
    numbers.length > 0 && [h('h2', {}, 'Cases of this class'), caseList(numbers)],
  ];
}

/** How often each method was wrong in this class, over all families of a hunt. */
function wrongHere(id) {
  return runsOf('fuzz').map((run) => {
    const sums = new Map();
    for (const row of rows(run.counts)) {
      if (row.slot !== id) continue;
      const key = `${row.method}\n${row.fmt}`;
      const sum = sums.get(key) ?? {method: row.method, fmt: row.fmt, n: 0, k: 0};
      sum.n += row.asked - row.unsupported;
      sum.k += row.wrong;
      sums.set(key, sum);
    }
    const order = inOrder([...sums.values()].map(({method}) => method));
    const list =
        [...sums.values()].filter(({n}) => n > 0).sort((a, b) => order.indexOf(a.method) - order.indexOf(b.method));
    if (list.length === 0) return null;
    return h(
        'section', {}, h('h2', {}, `In ${run.title}`),
        table(
            ['method', 'format', 'wrong', 'judged', 'share'],
            list.map(
                (sum) =>
                    [link(to('cell', run.index, {method: sum.method, slot: id, fmt: sum.fmt}), sum.method), sum.fmt,
                     {cell: grouped(sum.k), class: 'n'}, {cell: grouped(sum.n), class: 'n'},
                     {cell: percent(sum.k / sum.n), class: 'n'}]),
            {label: `wrong in class ${id}, run ${run.index + 1}`}));
  });
}
