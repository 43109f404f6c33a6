// Tables of a case: coordinates, computed signs beside exact ones, every method's answer.
import {h, table} from './dom.js';
import {cross, dot, logOf, minus, ratio, toHex} from './exact.js';
import {significant, superscript} from './figures.js';
import {exactSigns} from './question.js';
import {answersOf, inOrder, method} from './report.js';
import {roundedVolumes, ulp} from './rounded.js';

const glyphs = {
  '-1': '−',
  0: '0',
  1: '+'
};
const sign = (x) => (Number.isNaN(x) ? 'NaN' : glyphs[Math.sign(x)]);

/** The exact volumes as doubles, or as powers of two beyond their range. */
function exactVolumes({exact, isRay}) {
  const {p, q, rings, unit} = exact;
  const [a, b, c] = rings[0];
  const volume = (o, u, v, x, direction) => dot(minus(u, o), cross(minus(v, o), direction ? x : minus(x, o)));
  const all = [
    volume(a, b, c, p), volume(a, b, c, q, isRay), volume(p, a, b, q, isRay), volume(p, b, c, q, isRay),
    volume(p, c, a, q, isRay)
  ];
  return all.map((n) => {
    if (n === 0n) return '0';
    const x = ratio(n, 1n, 3 * unit);
    const size = logOf(n, 1n, 3 * unit);
    return Math.abs(size) < 1000 ? significant(x) : `${n < 0n ? '−' : ''}2${superscript(Math.round(size))}`;
  });
}

const meanings = (isRay) =>
    (isRay ?
         [
           'origin against plane abc', 'direction against plane abc', 'line against edge ab', 'line against edge bc',
           'line against edge ca'
         ] :
         [
           'p against plane abc', 'q against plane abc', 'line pq against edge ab', 'line pq against edge bc',
           'line pq against edge ca'
         ]);

/** The five volumes: exact, and as the formula gives them in each format that holds the coordinates. */
export function signsTable(question) {
  const exact = exactSigns(question);
  const volumes = exactVolumes(question);
  const formats = question.format === 'binary32' ? ['binary32', 'binary64'] : ['binary64'];
  const computed = formats.map((format) => roundedVolumes(question, format));
  const names = ['abcp', question.isRay ? 'abcd' : 'abcq', 'pqab', 'pqbc', 'pqca'];
  const rows = names.map(
      (name, i) =>
          [h('code', {}, name),
           meanings(question.isRay)[i],
           {cell: h('b', {class: 'sign'}, sign(exact[i])), class: 'n'},
           {cell: volumes[i], class: 'n'},
           ...computed.flatMap((values) => {
             // Naive tests read NaN as zero.
             const wrong = (Math.sign(values[i]) || 0) !== exact[i];
             return [
               {
                 cell: [
                   h('b', {class: wrong ? 'sign wrong' : 'sign'}, sign(values[i])),
                   wrong && h('span', {class: 'mark'}, ' ✗ wrong')
                 ],
                 class: 'n'
               },
               {cell: significant(values[i]), class: 'n'},
             ];
           }),
  ]);
  return table(
      ['volume', 'asks', 'exact', '', ...formats.flatMap((format) => [`in ${format}`, ''])], rows,
      {label: 'signs of the five volumes'});
}

/** Coordinates in decimal, with the hex float and the spacing of numbers there. */
export function coordinatesTable(question) {
  const rows = [];
  const add = (name, point) => point.forEach((x, axis) => rows.push([
    axis === 0 ? h('code', {}, name) : '', 'xyz'[axis], {cell: String(x), class: 'n'},
    {cell: h('code', {}, toHex(x)), class: 'n'},
    {cell: Number.isFinite(x) ? significant(ulp(x, question.format)) : '', class: 'n'}
  ]));
  add(question.isRay ? 'o' : 'p', question.p);
  add(question.isRay ? 'd' : 'q', question.q);
  question.rings.forEach(
      (ring, r) => ring.forEach((point, i) => add(question.isPolygon ? `${r}.${i}` : 'abc'[i], point)));
  return table(['point', '', 'decimal', 'exact, as hex float', 'one ulp there'], rows, {label: 'coordinates'});
}

const said = {
  1: 'hit',
  0: 'no hit',
  '-': 'does not take it'
};

/** Who answers what; those that part from what is due come first. */
export function answersTable(entry) {
  const due = entry.expected ?? entry.truth?.hit;
  const all = answersOf(entry);
  const names = inOrder(all.map(({name}) => name));
  const wrongFirst = (one, other) =>
      isWrong(other) - isWrong(one) || names.indexOf(one.name) - names.indexOf(other.name);
  // What is due is a matter of each method's contract; only what the record says of its own method is called wrong.
  const isWrong = ({name, letter}) =>
      (name === entry.method                                     ? 2 :
           letter !== '-' && Number(letter) !== entry.truth?.hit ? 1 :
                                                                   0);
  const asked = all.filter(({letter}) => letter !== '-').sort(wrongFirst);
  const rows = asked.filter(isWrong).map(
      (answer) =>
          [h('code', {}, answer.name),
           h('span', {class: 'parts'}, said[answer.letter] ?? answer.letter),
           isWrong(answer) === 2 ? h('b', {class: 'wrong'}, `✗ ${entry.outcome ?? 'wrong'}`) :
                                   '✗ parts from the closed point sets',
           method(answer.name).convention ?? '',
  ]);
  const right = asked.filter((answer) => !isWrong(answer));
  const silent = all.filter(({letter}) => letter === '-').length;
  return [
    due !== null && due !== undefined &&
        h('p', {}, `Due of ${entry.method ?? 'the method'}: ${due ? 'a hit' : 'no hit'}.`),
    rows.length > 0 && table(['method', 'answers', 'which', 'convention'], rows, {
      label: 'methods that part from the closed point sets'
    }),
    right.length > 0 &&
        h('p', {}, h('b', {}, `✓ ${entry.truth?.hit ? 'hit' : 'no hit'}: `),
          right.map(({name}, i) => [i > 0 && ', ', h('code', {}, name)]), '.'),
    silent > 0 && h('p', {class: 'note'}, `${silent} further methods do not take this case or its format.`),
  ];
}
