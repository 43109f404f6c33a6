// Where it fails: methods × families, and of one method classes × families. A cell leads to its cases.
import {h, link, table} from './dom.js';
import {numbersOf} from './errors.js';
import {grouped, interval, percent, shareInWords} from './figures.js';
import {heatGrid} from './grid.js';
import {caseList, casesWith, chooseRun, paged} from './lists.js';
import {classRow, inOrder, report, rows, runsOf} from './report.js';
import {to} from './route.js';

const narrow = () => window.innerWidth < 760;

/** Of fuzz: totals by method, family and format. Of certificates: the sampled rows, added up. */
function countsOf(run) {
  if (run.kind === 'fuzz') {
    return rows(run.counts).map((row) => ({...row, method: row.method, judged: row.asked - row.unsupported}));
  }
  return [...rows(run.record.sampled), ...rows(run.record.own_cases)].map((row) => ({
                                                                            ...row,
                                                                            method: run.record.method,
                                                                            slot: row.class ?? row.case,
                                                                            judged: row.n,
                                                                            wrong: row.k,
                                                                          }));
}

/** Sums of counts by a key: a map from the key to {judged, wrong, severities}. */
function summed(counts, keyOf) {
  const sums = new Map();
  for (const row of counts) {
    const key = keyOf(row);
    const sum = sums.get(key) ?? {judged: 0, wrong: 0, plain: 0, boundary: 0, extreme: 0};
    for (const name of Object.keys(sum)) sum[name] += row[name] ?? row[`severity.${name}`] ?? 0;
    sums.set(key, sum);
  }
  return sums;
}

function worstOf(sum) {
  const found =
      ['plain', 'boundary', 'extreme'].filter((name) => sum[name] > 0).map((name) => `${grouped(sum[name])} ${name}`);
  return found.length ? `. By severity: ${found.join(', ')}` : '';
}

function cellFrom(run, sum, features) {
  if (!sum || sum.judged === 0) return null;
  const cases = casesWith(run, features).length;
  const shown = sum.wrong === 0 ? '' :
      cases                     ? ` → ${grouped(cases)} in this report` :
                                  ' → none of them is in this report';
  return {
    share: sum.wrong / sum.judged,
    n: sum.judged,
    words: shareInWords(sum.wrong, sum.judged) + worstOf(sum) + shown,
    href: to(
        'cell', run.index, {method: features.method, family: features.family, slot: features.slot, fmt: features.fmt}),
  };
}

const label = (method, fmt) => `${method} · ${fmt === 'binary32' ? '32' : '64'}`;

function methodsByFamilies(run, counts) {
  const places =
      [...new Map(counts.filter((row) => row.judged > 0).map((row) => [label(row.method, row.fmt), row])).values()];
  const names = inOrder(places.map((row) => row.method));
  places.sort((a, b) => names.indexOf(a.method) - names.indexOf(b.method) || (a.fmt < b.fmt ? 1 : -1));
  const methods = places.map(
      ({method, fmt}) => ({name: label(method, fmt), href: to('matrix', run.index, {method, fmt}), method, fmt}));
  const order = Object.keys(report.families ?? {});
  const families =
      inOrder(counts.map((row) => row.family), order).map((name) => ({name, title: report.families?.[name]?.about}));
  const sums = summed(counts, (row) => `${label(row.method, row.fmt)}\n${row.family}`);
  const byName = new Map(methods.map((entry) => [entry.name, entry]));
  const cell = (methodName, family) => {
    const {method, fmt} = byName.get(methodName);
    return cellFrom(run, sums.get(`${methodName}\n${family}`), {method, family, fmt});
  };
  return paged(
      methods,
      (shown) => narrow() ?
          heatGrid({
            rows: families,
            columns: shown,
            cellOf: (family, name) => cell(name, family),
            corner: 'family',
            label: 'families by methods',
            compact: shown.length > 5
          }) :
          heatGrid({rows: shown, columns: families, cellOf: cell, corner: 'method', label: 'methods by families'}),
      narrow() ? 8 : 40);
}

function classesByFamilies(run, counts, method, fmt, all) {
  const own = counts.filter((row) => row.method === method && row.fmt === fmt && row.judged > 0);
  const bySlot = summed(own, (row) => row.slot);
  const wrong = [...bySlot]
                    .filter(([, sum]) => sum.wrong > 0 || all)
                    .sort(([, a], [, b]) => b.wrong / b.judged - a.wrong / a.judged)
                    .map(([name]) => name);
  const families = inOrder(own.map((row) => row.family), Object.keys(report.families ?? {}))
                       .map((name) => ({name, title: report.families?.[name]?.about}));
  if (wrong.length === 0) {
    const n = own.reduce((sum, row) => sum + row.judged, 0);
    return h(
        'p', {class: 'lead'}, `Nothing wrong: ${shareInWords(0, n)}. `,
        link(to('matrix', run.index, {method, fmt, all: 1}), 'Show all that were asked'));
  }
  const sums = summed(own, (row) => `${row.slot}\n${row.family}`);
  const slots = wrong.map((name) => ({name, title: classRow(name)?.words, href: classRow(name) && to('class', name)}));
  return [
    h('p', {}, `${grouped(wrong.length)} classes${all ? '' : ' with a wrong answer'}, the highest share first. `,
      !all && link(to('matrix', run.index, {method, fmt, all: 1}), 'Show all that were asked')),
    paged(
        slots,
        (shown) => paged(
            families,
            (some) => heatGrid({
              rows: shown,
              columns: some,
              corner: 'class',
              label: `classes by families of ${method}`,
              compact: true,
              cellOf: (slot, family) => cellFrom(run, sums.get(`${slot}\n${family}`), {method, family, slot, fmt}),
            }),
            narrow() ? 8 : 40, 'families'),
        40, 'classes'),
  ];
}

const hunts = () => [...runsOf('fuzz'), ...runsOf('certificate')];

export function matrixPage(path, query) {
  const runs = hunts();
  const run = runs.find(({index}) => index === Number(path[1] ?? runs[0]?.index)) ?? runs[0];
  if (!run) return h('p', {}, 'No hunt is in this report.');
  const counts = countsOf(run);
  const method = query.get('method'), fmt = query.get('fmt');
  return [
    h('h1', {}, 'Where it fails'),
    h('p', {class: 'lead'},
      'Share of wrong answers in percent, by the family that made the cases. Each family stresses one thing; none is a sample of anybody’s scene.'),
    chooseRun(runs, run.index, 'matrix'),
    method ?
        [
          h('p', {class: 'crumbs'}, link(to('matrix', run.index), 'all methods'), ` › ${method}, ${fmt}`),
          classesByFamilies(run, counts, method, fmt, query.get('all'))
        ] :
        [
          methodsByFamilies(run, counts),
          h('p', {class: 'note'},
            'A method’s name leads to its classes. 64 and 32: cases of binary64 and of binary32 coordinates, which are never added up.')
        ],
    numbersOf(run),
    run.left_out?.length > 0 && h('p', {class: 'note'}, run.left_out.join(' ')),
  ];
}

/** One cell: its figures and its counterexamples. */
export function cellPage(path, query) {
  const run = {...report.runs[Number(path[1])], index: Number(path[1])};
  if (!run.kind) return h('p', {}, 'There is no such run.');
  const features = Object.fromEntries(['method', 'family', 'slot', 'fmt'].map((name) => [name, query.get(name)]));
  const matches =
      countsOf(run).filter((row) => Object.entries(features).every(([name, value]) => !value || row[name] === value));
  const sum = matches.reduce(
      (all, row) => ({judged: all.judged + row.judged, wrong: all.wrong + row.wrong}), {judged: 0, wrong: 0});
  const numbers = casesWith(run, features);
  const [lower, upper] = interval(sum.wrong, sum.judged);
  return [
    h('p', {class: 'crumbs'}, link(to('matrix', run.index), 'matrix'), ' › ',
      link(to('matrix', run.index, {method: features.method, fmt: features.fmt}), features.method),
      ` › ${[features.family, features.slot, features.fmt].filter(Boolean).join(' · ')}`),
    h('h1', {}, [features.method, features.family, features.slot].filter(Boolean).join(' · ')),
    h('p', {class: 'lead'}, sum.judged ? shareInWords(sum.wrong, sum.judged) : 'nobody was asked', '.'),
    sum.judged > 0 && intervalBar(sum.wrong / sum.judged, lower, upper),
    features.slot && classRow(features.slot) && h('p', {}, classRow(features.slot).words),
    features.family && report.families?.[features.family] &&
        h('p', {}, `${features.family}: ${report.families[features.family].about}`),
    h('h2', {}, numbers.length ? 'Counterexamples' : 'No counterexample of this cell is in the report'),
    numbers.length > 0 && caseList(numbers),
    features.slot === null && sum.wrong > 0 && byClass(matches),
  ];
}

/** An interval on a line from 0 to its upper end. */
function intervalBar(share, lower, upper) {
  const scale = Math.min(1, Math.max(upper * 1.15, 1e-9));
  const at = (x) => `${(100 * x) / scale}%`;
  return h(
      'div', {class: 'interval', 'aria-hidden': 'true'},
      h('i', {style: `left:${at(lower)};width:calc(${at(upper)} - ${at(lower)})`}),
      h('b', {style: `left:${at(share)}`}), h('small', {}, '0'), h('small', {}, percent(scale)));
}

function byClass(matches) {
  const sums = [...summed(matches, (row) => row.slot)].filter(([, sum]) => sum.wrong > 0).sort(([, a], [
                                                                                                 , b
                                                                                               ]) => b.wrong - a.wrong);
  return [
    h('h2', {}, 'By class'),
    table(
        ['class', 'in words', 'wrong', 'judged', 'share'],
        sums.slice(0, 40).map(
            ([slot, sum]) =>
                [classRow(slot) ? link(to('class', slot), slot) : slot, classRow(slot)?.words ?? '',
                 {cell: grouped(sum.wrong), class: 'n'}, {cell: grouped(sum.judged), class: 'n'},
                 {cell: percent(sum.wrong / sum.judged), class: 'n'}]))
  ];
}
