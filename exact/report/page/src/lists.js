// Lists of cases, by what a page wants of them, and choices between runs.
import {h, link, table} from './dom.js';
import {grouped} from './figures.js';
import {classRow, report, titleOf} from './report.js';
import {note, to} from './route.js';

/** Numbers of the cases of a run with these features. */
export function casesWith(run, features) {
  return run.cases.filter((number) => {
    const entry = report.cases[number];
    return Object.entries(features).every(([name, value]) => {
      if (value === null || value === undefined) return true;
      if (name === 'fmt') return (entry.case.fmt ?? 'binary64') === value;
      // Constructions of polygons are no part of a case; then all cases of the family are shown.
      if (name === 'slot') return entry.class ? entry.class === value : !classRow(value);
      return entry[name] === value;
    });
  });
}

/** A choice between runs, if there are several. */
export function chooseRun(runs, index, where) {
  if (runs.length < 2) return null;
  const select =
      h('select', {
        id: 'run',
        onchange: () => {
          location.hash = to(where, select.value);
        }
      },
        runs.map(
            (run) =>
                h('option', {value: run.index, selected: run.index === index},
                  run.title === run.directory ? run.title : `${titleOf(run)} (${run.directory})`)));
  return h('p', {class: 'controls'}, h('label', { for: 'run'
           }, 'of '), select);
}

/** Shows a long list by so many at a time; `what` they are is said beside the numbers. */
export function paged(items, draw, size, what = '') {
  if (items.length <= size) return draw(items);
  const box = h('div', {});
  const show = (from) => {
    const step = (target, name) => h(
        'button', {type: 'button', disabled: target < 0 || target >= items.length, onclick: () => show(target)}, name);
    box.replaceChildren(
        h('p', {class: 'steps'}, step(from - size, '←'),
          ` ${from + 1}–${Math.min(items.length, from + size)} of ${items.length} ${what} `, step(from + size, '→')),
        draw(items.slice(from, from + size)));
  };
  show(0);
  return box;
}

export function caseList(numbers) {
  return paged(
      numbers,
      (shown) => table(
          ['case', 'method', 'outcome', 'severity', 'class', 'family', 'format'], shown.map((number) => {
            const entry = report.cases[number];
            return [
              link(to('case', number), entry.case.id), entry.method ?? '', entry.outcome ?? '', entry.severity ?? '',
              entry.class ?? '', entry.family ?? '', (entry.case.fmt ?? 'binary64').replace('binary', '')
            ];
          }),
          {label: 'cases', class: 'cases'}),
      100);
}

/** All cases, by what the fragment's parameters say. */
export function casesPage(query) {
  const all = report.cases.map((_, number) => number);
  const features = {
    run: query.get('run') === null ? null : Number(query.get('run')),
    method: query.get('method'),
    outcome: query.get('outcome'),
    severity: query.get('severity'),
    slot: query.get('class')
  };
  const pick = (key, values) => {
    const select = h(
        'select', {
          id: `pick-${key}`,
          onchange: () => {
            note({[key]: select.value || null});
            dispatchEvent(new HashChangeEvent('hashchange'));
          }
        },
        h('option', {value: ''}, 'any'),
        values.map(([value, name]) => h('option', {value, selected: String(value) === query.get(key)}, name ?? value)));
    return h('label', { for: `pick-${key}`
    }, `${key} `, select);
  };
  const seen = (of) => [...new Set(report.cases.map(of).filter((value) => value !== null && value !== undefined))].map(
      (value) => [value]);
  const numbers = casesWith({cases: all}, features);
  return [
    h('h1', {}, 'Cases'),
    h('p', {class: 'lead'},
      `${grouped(numbers.length)} of ${
          grouped(
              all.length)} in this report, the worst first: plain input (general position, everyday scale) before boundaries before extreme scales.`),
    h('p', {class: 'controls'}, pick('run', report.runs.map((run, i) => [i, `${run.kind}: ${titleOf(run)}`])),
      pick('method', seen((entry) => entry.method)), pick('outcome', seen((entry) => entry.outcome)),
      pick('severity', seen((entry) => entry.severity))),
    numbers.length ? caseList(numbers) : h('p', {}, 'None.'),
  ];
}
