// Pages of runs that are tables: benchmarks, relations, compilers, and what all was made with.
import {code, h, link, table} from './dom.js';
import {grouped, percent, significant} from './figures.js';
import {caseList, chooseRun} from './lists.js';
import {report, runsOf, titleOf} from './report.js';
import {to} from './route.js';

const pick = (kind, path) => {
  const runs = runsOf(kind);
  return [runs, runs.find(({index}) => index === Number(path[1])) ?? runs[0]];
};

export function benchPage(path) {
  const [runs, run] = pick('bench', path);
  if (!run) return h('p', {}, 'No benchmark is in this report.');
  const timings =
      (run.record.benchmarks ?? []).filter((one) => one.run_type !== 'aggregate' || one.aggregate_name === 'median');
  const most = Math.max(...timings.map((one) => one.real_time));
  return [
    h('h1', {}, run.title),
    chooseRun(runs, run.index, 'bench'),
    h('p', {class: 'lead'}, 'Times of one machine under that run’s load; compare ratios.'),
    table(
        ['benchmark', 'time', '', ''],
        timings.map(
            (one) =>
                [one.name, {cell: significant(one.real_time), class: 'n'}, one.time_unit ?? 'ns',
                 h('span', {class: 'bar', style: `width:${(10 * one.real_time) / most}em`})]),
        {label: 'times'}),
  ];
}

export function relationsPage(path) {
  const [runs, run] = pick('relations', path);
  if (!run) return h('p', {}, 'No relations are in this report.');
  const asked = (run.relations?.relations ?? run.relations ?? []).filter((row) => row.asked > 0);
  const sorted = asked.sort((a, b) => (b.broken > 0) - (a.broken > 0));
  const broken = new Set(asked.filter((row) => row.broken > 0).map((row) => `${row.method} ${row.relation}`)).size;
  return [
    h('h1', {}, 'Relations between answers'),
    chooseRun(runs, run.index, 'relations'),
    h('p', {class: 'lead'},
      `What must hold between answers whatever the truth is. ${
          broken ? `${grouped(broken)} pairs of method and relation are broken` : 'None was broken'}.`),
    table(
        ['method', 'relation', 'format', 'probe', 'asked', 'broken'],
        sorted.map(
            (row) =>
                [code(row.method ?? ''), h('span', {title: row.statement}, row.relation),
                 (row.fmt ?? '').replace('binary', ''), row.probe ?? row.probes ?? '',
                 {cell: grouped(row.asked ?? 0), class: 'n'},
                 {cell: row.broken > 0 ? h('b', {class: 'wrong'}, grouped(row.broken)) : '0', class: 'n'}]),
        {label: 'relations'}),
    run.cases.length > 0 && [h('h2', {}, 'Witnesses'), caseList(run.cases)],
  ];
}

export function compilersPage(path) {
  const [runs, run] = pick('compilers', path);
  if (!run) return h('p', {}, 'No other builds are in this report.');
  const list = run.record.rows.filter((row) => row.changed > 0);
  return [
    h('h1', {}, 'The compiler as an axis'),
    chooseRun(runs, run.index, 'compilers'),
    h('p', {class: 'lead'},
      `The same source, built ${run.record.builds.length} times. ${grouped(list.length)} of ${
          grouped(run.record.rows.length)} pairs of method and build changed some answer.`),
    table(
        ['method', 'build', 'format', 'changed', 'spoiled', 'mended', 'wrong', 'first case'],
        list.map(
            (row) =>
                [code(row.method), row.build, row.fmt.replace('binary', ''),
                 ...[row.changed, row.spoiled, row.mended].map((n) => ({cell: grouped(n), class: 'n'})),
                 {cell: percent(row.answers?.share ?? 0), class: 'n'},
                 row.case !== null && row.case !== undefined ? link(to('case', row.case), 'case') : '–']),
        {label: 'changed answers'}),
    h('h2', {}, 'Builds'),
    table(
        ['build', 'compiler', 'flags'],
        run.record.builds.map((build) => [build.name, build.compiler, code(build.flags)]), {label: 'builds'}),
  ];
}

export function aboutPage() {
  const template = document.getElementById('licences');
  return [
    h('h1', {}, 'About this page'),
    h('p', {class: 'lead'},
      'One file, which loads nothing. The address of every view is in its fragment, so any state can be linked to.'),
    h('h2', {}, 'Made with'),
    h('dl', {class: 'facts'},
      Object.entries(report.made_with ?? {}).map(([name, value]) => [h('dt', {}, name), h('dd', {}, String(value))])),
    h('h2', {}, 'Runs'),
    report.runs.map(
        (run) =>
            h('details', {}, h('summary', {}, `${run.kind}: ${titleOf(run)}`),
              h('p', {}, `Files: ${run.files.join(', ')}`), run.command && h('pre', {tabindex: 0}, run.command),
              h('dl', {class: 'facts'},
                Object.entries(run.environment ?? {})
                    .map(([name, value]) => [h('dt', {}, name), h('dd', {}, String(value))])))),
    h('h2', {}, 'Licences of what is built in'),
    h('pre', {class: 'licences', tabindex: 0}, template.content.textContent),
  ];
}
