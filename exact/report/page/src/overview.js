// The first page: the worst verdict, runs and methods side by side, and what was not covered before what was.
import {kindsOfCase, whatIsAKind} from './certificate.js';
import {code, h, link, table} from './dom.js';
import {grouped, percent, unbroken} from './figures.js';
import {gravity, inOrder, method, report, rows, runsOf, titleOf} from './report.js';
import {to} from './route.js';

const marks = ['✓', '◐', '▲', '✗'];
const legend = [
  [3, 'wrong in plain general position, or a fault'],
  [2, 'wrong on boundaries or at extreme scale, a leak, or a broken relation'],
  [1, 'incomplete, refused, or pictures that differ though no answer is wrong'],
  [0, 'nothing wrong found'],
];

/** The severity before the figures; the other levels begin with their finding anyhow. */
const severities = {
  plain: 'wrong in plain general position',
  boundary: 'wrong on boundaries',
  extreme: 'wrong at extreme scale'
};

/** A map's verdict names the map; where its probe is a ray, it is another map than the one of segments. */
function textOf({text, run: index}) {
  const run = report.runs[index];
  return run.kind === 'map' ? text.replace(run.title, () => titleOf(run)) : text;
}

/** A verdict as a headline and what stands below it. */
function inWords(verdict) {
  const severity = severities[verdict.level];
  const start = `${verdict.method}: `;
  const text = textOf(verdict);
  if (!severity || !text.startsWith(start)) return [unbroken(text), verdict.detail];
  return [`${start}${severity}`, [text.slice(start.length), verdict.detail].filter(Boolean).join('; ')];
}

/** Which run a verdict is of: "sweep sweep2", "map edge, rays". */
function runInWords(run) {
  const title = titleOf(run);
  return title.startsWith(run.kind) ? title : `${run.kind} ${title}`;
}

/** Why fewer cases were judged than the run has: some are not owed by the method's contract. */
function notOwed({run, method: name, fmt}) {
  if (report.runs[run]?.kind !== 'fuzz') return null;
  const own = rows(report.runs[run].totals).filter((row) => row.method === name && (!fmt || row.fmt === fmt));
  const asked = own.reduce((sum, row) => sum + row.asked, 0);
  const left = asked - own.reduce((sum, row) => sum + row.judged, 0);
  if (left <= 0) return null;
  const {contract} = method(name);
  return `${grouped(left)} of its ${grouped(asked)} cases are not owed by its contract${
      contract ? ` (${contract})` : ''}, and are not judged.`;
}

function verdictItem(verdict) {
  const grave = gravity(verdict.level);
  const [headline, detail] = inWords(verdict);
  const left = notOwed(verdict);
  return h(
      'li', {class: `verdict grave-${grave}`}, h('span', {class: 'mark', 'aria-hidden': 'true'}, marks[grave]),
      h('div', {}, h('a', {href: pageOf(verdict.run)}, headline),
        h('span', {class: 'of'}, ` ${runInWords(report.runs[verdict.run])}`),
        detail && h('small', {}, unbroken(detail)), left && h('small', {}, left), itsCase(verdict)));
}

/** What the marks mean; only those that are used. */
function legendOf(verdicts) {
  const used = new Set(verdicts.map(({level}) => gravity(level)));
  return h(
      'p', {class: 'legend'},
      legend.filter(([grave]) => used.has(grave))
          .map(
              ([grave, words]) =>
                  h('span', {class: `grave-${grave}`}, h('b', {class: 'mark', 'aria-hidden': 'true'}, marks[grave]),
                    words)));
}

/** The plainest case behind a verdict. */
const itsCase = ({case: number}) =>
    (Number.isInteger(number) ? h('small', {class: 'more'}, link(to('case', number), 'the plainest case')) : null);

const pages = {
  fuzz: 'matrix',
  certificate: 'certificate',
  sweep: 'sweep',
  map: 'map',
  chart: 'chart',
  render: 'picture',
  leak: 'leak',
  bench: 'bench',
  relations: 'relations',
  compilers: 'compilers'
};
export const pageOf = (index) => to(pages[report.runs[index].kind] ?? 'cases', index);

/** What is missing, before anything is praised. */
function gaps() {
  const fromCertificates =
      runsOf('certificate')
          .flatMap(
              (run) => (run.record.not_covered ??
                        []).map((gap) => ({
                                  what: `${run.record.method}: ${kindsOfCase(gap.strata ?? gap.what?.length ?? 1)}`,
                                  why: gap.reason,
                                  explained: gap.explained,
                                  href: to('certificate', run.index)
                                })));
  const all = [...fromCertificates.filter((gap) => !gap.explained), ...fromCertificates.filter((gap) => gap.explained)];
  const sentences = [...(report.left_out ?? []), ...report.runs.flatMap((run) => run.left_out ?? [])];
  if (all.length + sentences.length === 0) return null;
  return h(
      'section', {}, h('h2', {}, 'What was not covered'), all.length > 0 && h('p', {class: 'note'}, whatIsAKind),
      h('ul', {class: 'plain'},
        all.map(
            (gap) =>
                h('li', {}, !gap.explained && h('b', {class: 'wrong'}, 'unexplained: '), link(gap.href, gap.what),
                  ` – ${gap.why}`)),
        [...new Set(sentences)].map((sentence) => h('li', {}, sentence))));
}

/** One line for each method and format: what each run says of it. */
function methodsTable() {
  const lines = new Map();
  const line = (method, fmt) => {
    const key = `${method}\n${fmt}`;
    if (!lines.has(key))
      lines.set(key, {method, fmt, hunts: {judged: 0, wrong: 0, plain: 0, boundary: 0, extreme: 0}, cells: {}});
    return lines.get(key);
  };
  for (const run of runsOf('fuzz')) {
    for (const row of rows(run.totals)) {
      const {hunts} = line(row.method, row.fmt);
      for (const name of Object.keys(hunts)) hunts[name] += row[name];
    }
  }
  for (const run of runsOf('certificate')) {
    for (const sum of run.sums ?? [])
      line(run.record.method, sum.fmt).cells.certificate = link(to('certificate', run.index), run.record.verdict);
  }
  for (const run of runsOf('leak')) {
    for (const trial of run.record.trials ?? []) {
      for (const subject of trial.subjects ?? []) {
        const {rays, leak} = subject.all ?? {};
        if (rays)
          line(subject.name ?? subject.method, trial.fmt).cells.leak =
              link(to('leak', run.index), `${grouped(Math.round(((leak ?? 0) / rays) * 1e6))}`);
      }
    }
  }
  const names = inOrder([...lines.values()].map(({method}) => method));
  const sorted = [...lines.values()]
                     .filter(({hunts, cells}) => hunts.judged > 0 || Object.keys(cells).length > 0)
                     .sort((a, b) => names.indexOf(a.method) - names.indexOf(b.method) || (a.fmt < b.fmt ? 1 : -1));
  if (sorted.length === 0) return null;
  const has = (name) => sorted.some(({cells}) => cells[name]);
  return h(
      'section', {}, h('h2', {}, 'Methods side by side'),
      h('p', {class: 'note'},
        'What is wrong, by how hard its input is: plain (general position, everyday scale), on boundaries, at extreme scale.'),
      table(
          [
            'method', 'coordinates', 'judged', 'wrong', 'share', 'plain', 'boundary', 'extreme',
            has('certificate') && 'certificate', has('leak') && 'leaks per million'
          ].filter(Boolean),
          sorted.map(
              ({method, fmt, hunts, cells}) =>
                  [code(method),
                   fmt,
                   ...[hunts.judged, hunts.wrong].map((n) => ({cell: hunts.judged ? grouped(n) : '–', class: 'n'})),
                   {cell: hunts.judged ? percent(hunts.wrong / hunts.judged) : '–', class: 'n'},
                   ...['plain', 'boundary', 'extreme'].map(
                       (name) =>
                           ({cell: hunts.judged ? grouped(hunts[name]) : '–', class: hunts[name] ? 'n some' : 'n'})),
                   ...['certificate', 'leak'].filter(has).map(
                       (name) => ({cell: cells[name] ?? '–', class: name === 'leak' ? 'n' : null})),
  ]),
          {label: 'methods side by side'}));
}

function runsTable() {
  return h(
      'section', {}, h('h2', {}, 'Runs'),
      table(
          ['run', 'what', 'methods', 'counterexamples', 'made by'],
          report.runs.map(
              (run, i) =>
                  [link(pageOf(i), titleOf(run)), run.kind,
                   run.methods.length > 8 ? `${run.methods.length} methods` : run.methods.join(', '),
                   {cell: run.cases_in_all ? link(to('cases', {run: i}), grouped(run.cases_in_all)) : '–', class: 'n'},
                   run.command ? code(run.command) : run.directory]),
          {label: 'runs', class: 'runs'}));
}

function worstVerdict(verdict) {
  const [headline, detail] = inWords(verdict);
  const left = notOwed(verdict);
  return h(
      'div', {class: `worst grave-${gravity(verdict.level)}`},
      h('p', {class: 'eyebrow'}, `The worst verdict ${marks[gravity(verdict.level)]}`),
      h('h1', {}, link(pageOf(verdict.run), headline)), detail && h('p', {}, unbroken(detail)),
      left && h('p', {}, left),
      Number.isInteger(verdict.case) && h('p', {}, link(to('case', verdict.case), 'See the plainest case of it')));
}

export function overviewPage() {
  const verdicts = [...(report.verdicts ?? [])];
  const [worst, ...others] = verdicts;
  const shown = others.slice(0, 8);
  return [
    worst ? worstVerdict(worst) : h('h1', {}, 'No verdict: these runs judge nobody'),
    gaps(),
    shown.length > 0 && [h('h2', {}, 'Further verdicts'), legendOf(verdicts)],
    shown.length > 0 &&
        h('ul', {class: 'verdicts', 'aria-label': 'further verdicts, worst first'}, shown.map(verdictItem)),
    others.length > shown.length &&
        h('details', {}, h('summary', {}, `${others.length - shown.length} more`),
          h('ul', {class: 'verdicts'}, others.slice(shown.length).map(verdictItem))),
    methodsTable(),
    runsTable(),
  ];
}
