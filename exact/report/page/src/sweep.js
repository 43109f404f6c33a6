// Outcomes along stress axes, and the thresholds with a witness each.
import {code, h, link, table} from './dom.js';
import {percent, significant} from './figures.js';
import {linesWithBands} from './lines.js';
import {chooseRun} from './lists.js';
import {inOrder, report, rows, runsOf} from './report.js';
import {to} from './route.js';

const outcomes =
    ['wrong', 'leak', 'double hit', 'parity', 'false hit', 'false miss', 'wrong contact', 'fault', 'refused'];

/** A row of choices that are links, the present one marked; of many, a list to choose from. */
export function tabs(label, names, current, hrefOf) {
  if (names.length > 8) {
    const select =
        h('select', {
          id: `tab-${label}`,
          onchange: () => {
            location.hash = hrefOf(select.value);
          }
        },
          names.map((name) => h('option', {selected: name === current}, name)));
    return h('p', {class: 'controls'}, h('label', { for: `tab-${label}`
             }, `${label} `), select);
  }
  return h(
      'nav', {class: 'tabs', 'aria-label': label},
      names.map((name) => h('a', {href: hrefOf(name), 'aria-current': name === current ? 'true' : null}, name)));
}

/** The witnesses of a method on an axis, those of the outcome that is shown and nearest to a value first. */
function witnesses(run, method, {axis, fmt, probe, outcome}, value) {
  const cases = run.cases.filter((number) => {
    const {method: name, case: data, origin} = report.cases[number];
    if ((data.ray ? 'ray' : 'segment') !== probe) return false;
    return name === method && (data.fmt ?? 'binary64') === fmt && origin?.axis === axis && origin.value !== undefined;
  });
  const gap = (number) => Math.abs(report.cases[number].origin.value - value);
  const other = (number) => Number(report.cases[number].outcome !== outcome);
  return cases.sort((a, b) => other(a) - other(b) || gap(a) - gap(b));
}

export function sweepPage(path, query) {
  const runs = runsOf('sweep');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No sweep is in this report.');
  const {record} = run;
  const axis = record.axes.find(({name}) => name === query.get('axis')) ?? record.axes[0];
  const own = rows(record.rows).filter((row) => row.axis === axis.name);
  const formats = [...new Set(own.map((row) => row.fmt))].sort().reverse();
  const fmt = formats.includes(query.get('fmt')) ? query.get('fmt') : formats[0];
  const probes = [...new Set(own.map((row) => row.probe))];
  const probe = probes.includes(query.get('probe')) ? query.get('probe') : probes[0];
  const present = outcomes.filter((name) => own.some((row) => row[`${name}.k`] > 0) || name === 'wrong');
  const outcome = present.includes(query.get('outcome')) ? query.get('outcome') : 'wrong';
  const state = {axis: axis.name, fmt, probe, outcome};
  const change = (changes) => to('sweep', run.index, {...state, ...changes});
  const xs = [...new Set(own.filter((row) => row.fmt === fmt).map((row) => row.value))].sort((a, b) => a - b);
  const series = inOrder(own.map((row) => row.method))
                     .map((name) => ({
                            name,
                            points: xs.map(
                                (value) => shareOf(
                                    own.find(
                                        (row) => row.method === name && row.value === value && row.fmt === fmt &&
                                            row.probe === probe),
                                    outcome)),
                          }))
                     .filter(({points}) => points.some(Boolean));
  const go = ({name}, i) => {
    const [nearest] = witnesses(run, name, state, xs[i]);
    location.hash = nearest === undefined ? to('cases', {run: run.index, method: name}) : to('case', nearest);
  };
  const also = ({name}, i) => {
    const [nearest] = witnesses(run, name, state, xs[i]);
    return nearest === undefined ? '' : `. Nearest witness: ${report.cases[nearest].case.id}`;
  };
  return [
    h('h1', {}, 'Where it begins to fail'),
    h('p', {class: 'lead'}, `${axis.quantity}. Cases: ${axis.population}.`),
    chooseRun(runs, run.index, 'sweep'),
    tabs('axis', record.axes.map(({name}) => name), axis.name, (name) => change({axis: name})),
    h('div', {class: 'tab-row'}, tabs('format', formats, fmt, (name) => change({fmt: name})),
      tabs('probe', probes, probe, (name) => change({probe: name})),
      tabs('outcome', present, outcome, (name) => change({outcome: name}))),
    series.length ? linesWithBands({
      xs,
      series,
      xTitle: axis.quantity,
      logarithmic: axis.spacing === 'logarithmic',
      label: `${outcome} along ${axis.name}, ${fmt}, ${probe}s`,
      go,
      also
    }) :
                    h('p', {class: 'note'}, 'Nobody was asked this.'),
    h('h2', {}, 'Thresholds'),
    thresholds(record, state),
  ];
}

function shareOf(row, outcome) {
  if (!row || !row[`${outcome}.n`]) return null;
  return Object.fromEntries(['n', 'k', 'share', 'lower', 'upper'].map((key) => [key, row[`${outcome}.${key}`]]));
}

const at = (point) => (point ? `${significant(point.value, 6)}` : '–');

/** The thresholds of what is shown: of `wrong`, those of every outcome. */
function thresholds(record, {axis, fmt, probe, outcome}) {
  const along = (record.thresholds ?? []).filter((row) => row.axis === axis);
  if (along.length === 0) return h('p', {}, 'Along this axis nobody was wrong.');
  const own =
      along.filter((row) => row.fmt === fmt && row.probe === probe && (outcome === 'wrong' || row.outcome === outcome));
  const of = `${fmt}, ${probe}s${outcome === 'wrong' ? '' : `, ${outcome}`}`;
  const left = along.length - own.length;
  const others = left > 0 ? ` ${left} further thresholds of this axis are of other formats, probes or outcomes.` : '';
  if (own.length === 0) return h('p', {}, `None of ${of}.${others}`);
  return [
    h('p', {class: 'note'},
      `Of ${
          of}, as chosen above: the last value without, the first with, and the first from which on nothing else was left. A witness is a case at the first.${
          others}`),
    table(
        ['method', 'format', 'side', 'probe', 'outcome', 'none up to', 'first', 'rate there', 'all from', 'witness'],
        own.map(
            (row) =>
                [code(row.method), row.fmt.replace('binary', ''), row.side, row.probe, row.outcome,
                 {cell: at(row.before), class: 'n'}, {cell: at(row.first), class: 'n'},
                 {cell: row.first ? `${percent(row.first.share)}` : '–', class: 'n'}, {cell: at(row.all), class: 'n'},
                 row.case !== null && row.case !== undefined ? link(to('case', row.case), 'case') : '–']),
        {label: 'thresholds'})
  ];
}
