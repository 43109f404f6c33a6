// A certificate as a page. What was not covered comes first; what was run whole, what was sampled and how the answers
// relate to each other are never mixed.
import {h, link, table} from './dom.js';
import {numbersOf} from './errors.js';
import {grouped, percent, shareInWords} from './figures.js';
import {caseList, chooseRun} from './lists.js';
import {rows, runsOf} from './report.js';
import {to} from './route.js';

const verdictClass = {
  refuted: 'grave-3',
  incomplete: 'grave-1',
  'not refuted': 'grave-0'
};

export function certificatePage(path) {
  const runs = runsOf('certificate');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No certificate is in this report.');
  const {record} = run;
  return [
    h('div', {class: `worst ${verdictClass[record.verdict] ?? ''}`},
      h('p', {class: 'eyebrow'}, `Certificate of ${record.method}${run.judged ? ', of answers from elsewhere' : ''}`),
      h('h1', {}, record.verdict), record.worst && h('p', {}, record.worst)),
    chooseRun(runs, run.index, 'certificate'),
    h('p', {},
      [
        record.contract && `Contract: ${record.contract}. `, record.convention && `Convention: ${record.convention}. `,
        record.budget && `Budget ${record.budget}, seed ${record.seed}.`
      ]),
    notCovered(record),
    h('h2', {}, '1 · Run whole'),
    whole(record),
    h('h2', {}, '2 · Sampled'),
    sampled(run, record),
    h('h2', {}, '3 · Relations between answers'),
    relations(record),
    numbersOf(run),
    own(record),
    calibration(record),
    run.cases.length > 0 && [h('h2', {}, 'Counterexamples'), caseList(run.cases)],
    record.log_sha256 &&
        h('p', {class: 'note'}, `The log’s last hash is ${record.log_sha256}; `,
          h('code', {}, `tribunal verify ${run.directory}`), ' makes every figure again.'),
  ];
}

/** A count of strata, in words for whoever has not read what a stratum is. */
export const kindsOfCase = (n) => `${grouped(n)} ${n === 1 ? 'kind' : 'kinds'} of case`;
export const whatIsAKind = 'A kind of case is one class of one family in one format; a relation counts as one too.';

function notCovered(record) {
  const gaps = record.not_covered ?? [];
  return h(
      'section', {class: 'gap'}, h('h2', {}, 'What was not covered'),
      gaps.length > 0 && h('p', {class: 'note'}, whatIsAKind),
      gaps.length === 0 ? h('p', {}, 'Nothing that the contract and the budget name was left out.') :
                          h('ul', {class: 'plain'},
                            gaps.map(
                                (gap) =>
                                    h('li', {}, !gap.explained && h('b', {class: 'wrong'}, 'unexplained: '),
                                      h('b', {}, kindsOfCase(gap.strata ?? gap.what.length)), `: ${gap.reason}`,
                                      gap.what?.length > 0 &&
                                          h('details', {}, h('summary', {}, 'which'),
                                            h('p', {class: 'small'}, gap.what.join(' · '),
                                              (gap.strata ?? 0) > gap.what.length &&
                                                  ` and ${grouped(gap.strata - gap.what.length)} more`))))));
}

const count = (n) => ({cell: grouped(n ?? 0), class: 'n'});
const wrongCount = (n) => ({cell: n > 0 ? h('b', {class: 'wrong'}, grouped(n)) : '0', class: 'n'});

function whole(record) {
  const sets = record.proved ?? [];
  if (sets.length === 0) return h('p', {}, 'No set was run whole.');
  return [
    h('p', {class: 'note'}, 'Every question of these sets was asked, so these figures are no estimate.'),
    table(
        ['set', 'probes', 'size', 'wrong', 'not owed', 'classes', 'judged by'],
        sets.map(
            (set) =>
                [set.set, set.probes, count(set.size), wrongCount(set.count?.wrong), count(set.count?.unsupported),
                 count(set.classes), [set.judged_by, !set.complete && h('b', {class: 'wrong'}, ' incomplete')]]),
        {label: 'sets run whole'})
  ];
}

function sampled(run, record) {
  const streams = new Map((record.streams ?? []).map((stream) => [`${stream.family}\n${stream.fmt}`, stream]));
  const sums = new Map();
  for (const row of rows(record.sampled)) {
    const key = `${row.family}\n${row.fmt}`;
    const sum = sums.get(key) ?? {family: row.family, fmt: row.fmt, n: 0, k: 0};
    sum.n += row.n;
    sum.k += row.k;
    sums.set(key, sum);
  }
  const judged = [...sums.values()].filter(({n}) => n > 0);
  return [
    (run.sums ?? [])
        .map(
            (sum) =>
                h('p', {}, h('b', {}, `${sum.fmt}: `), sum.judged ? shareInWords(sum.wrong, sum.judged) : 'none judged',
                  '.')),
    h('p', {class: 'note'}, 'Samples of what these generators make; nothing follows for other input. ',
      link(to('matrix', run.index, {method: record.method, fmt: judged[0]?.fmt}), 'Classes × families'), '.'),
    table(
        ['family', 'format', 'what it is', 'judged', 'wrong', 'share'],
        judged.map(
            (sum) =>
                [link(to('cell', run.index, {method: record.method, family: sum.family, fmt: sum.fmt}), sum.family),
                 sum.fmt.replace('binary', ''), streams.get(`${sum.family}\n${sum.fmt}`)?.population ?? '',
                 count(sum.n), wrongCount(sum.k), {cell: percent(sum.k / sum.n), class: 'n'}]),
        {label: 'samples'}),
  ];
}

function relations(record) {
  const asked = (record.relations ?? []).filter(({n}) => n > 0);
  if (asked.length === 0) return h('p', {}, 'None was asked.');
  asked.sort((a, b) => (b.broken > 0) - (a.broken > 0));
  return [
    h('p', {class: 'note'}, 'What must hold between answers whatever the truth is; one broken relation refutes.'),
    table(
        ['relation', 'says', 'format', 'probe', 'asked', 'broken', 'at most'],
        asked.map(
            (row) =>
                [row.relation, row.statement, row.fmt.replace('binary', ''), row.probe, count(row.n),
                 wrongCount(row.broken), {cell: percent(row.upper_95 ?? 1), class: 'n'}]),
        {label: 'relations'})
  ];
}

function own(record) {
  const cases = record.own_cases ?? [];
  const list = Array.isArray(cases) ? cases : rows(cases);
  if (list.length === 0) return null;
  const n = list.reduce((sum, row) => sum + row.n, 0), k = list.reduce((sum, row) => sum + row.k, 0);
  return h(
      'section', {}, h('h2', {}, 'Your own cases'),
      h('p', {}, `${grouped(k)} wrong of ${grouped(n)}. They are no sample, so there is no bound.`));
}

function calibration(record) {
  const entries =
      Object.entries(record.calibration ?? {})
          .flatMap(([method, formats]) => Object.entries(formats).map(([fmt, counts]) => [method, fmt, counts]))
          .filter(([, , counts]) => counts.asked > 0);
  if (entries.length === 0) return null;
  return h(
      'section', {}, h('h2', {}, 'How hard the sample is'),
      h('p', {class: 'note'}, 'What naive tests got wrong on the same cases.'),
      table(
          ['method', 'format', 'asked', 'wrong', 'share'],
          entries.map(
              ([method, fmt, counts]) =>
                  [h('code', {}, method), fmt.replace('binary', ''), count(counts.asked), count(counts.wrong),
                   {cell: percent(counts.wrong / counts.asked), class: 'n'}]),
          {label: 'calibration'}));
}
