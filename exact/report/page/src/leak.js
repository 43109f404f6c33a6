// The page of a mesh trial: what each subject got wrong, per million of the rays that it was judged on.
import {code, h, link, table} from './dom.js';
import {grouped, shareInWords, significant} from './figures.js';
import {caseList, chooseRun} from './lists.js';
import {meshOutcomes} from './mesh.js';
import {runsOf} from './report.js';
import {to} from './route.js';

const errors = ['leak', 'lost', 'false hit', 'double hit', 'parity', 'closest', 'order', 't', 'normal', 'fault'];
const shown = ['neighbour', 'reported twice', 'outline'];

/** What a subject tells, by its record: "asked face by face; closest by t; parity of …", or what its name ends with. */
function tells({name = '', judged = ''}, outcome) {
  const kind = /\/(closest|any|all|inside)$/.exec(name)?.[1];
  if (outcome === 'fault') return true;
  if (outcome === 'parity') return kind ? kind === 'inside' : judged.includes('; parity of');
  if (kind === 'inside') return false;
  if (['closest', 'order', 't', 'normal'].includes(outcome))
    return kind ? kind === 'closest' : judged.includes('; closest by') && !['t', 'normal'].includes(outcome);
  return true;
}

/** How many of how many rays had an outcome; null where the subject is not judged on it. */
function rateOf(subject, counts, outcome) {
  const n = outcome === 'parity' ? counts.parity_judged ?? 0 : counts.rays ?? 0;
  const k = counts[outcome] ?? 0;
  return n > 0 && (k > 0 || tells(subject, outcome)) ? {k, n} : null;
}

/** Per million: whole numbers, but no number that is not 0 becomes 0. */
const perMillion = ({k, n}) => {
  const rate = (1e6 * k) / n;
  return rate < 99.95 ? significant(rate) : grouped(Math.round(rate));
};

export function leakPage(path) {
  const runs = runsOf('leak');
  const run = runs.find(({index}) => index === Number(path[1])) ?? runs[0];
  if (!run) return h('p', {}, 'No mesh trial is in this report.');
  return [
    h('h1', {}, 'Is it watertight?'),
    h('p', {class: 'lead'},
      `Rays aimed at the vertices, edges and faces of ${
          run.record.mesh}. Figures are per million rays; leaks come first.`),
    chooseRun(runs, run.index, 'leak'),
    (run.record.trials ?? []).map((trial) => leakTable(run, trial)),
    run.cases.length > 0 && [h('h2', {}, 'Cases'), caseList(run.cases)],
  ];
}

function cellOf(subject, counts, outcome, indent) {
  const rate = rateOf(subject, counts, outcome);
  if (!rate) return {cell: '–', class: 'n', title: 'not judged on this'};
  const text = perMillion(rate);
  return {
    cell: rate.k > 0 && errors.includes(outcome) ? h('b', {class: indent ? null : 'wrong'}, text) : text,
    class: 'n',
    title: shareInWords(rate.k, rate.n)
  };
}

function leakTable(run, trial) {
  const present =
      [...errors, ...shown].filter((name) => trial.subjects.some(({all}) => all?.[name] > 0) || name === 'leak');
  const rowOf = (subject, name, counts, indent) =>
      [indent ? h('span', {class: 'indent'}, name) : code(name),
       ...present.map((outcome) => cellOf(subject, counts, outcome, indent))];
  const aims = {vertex: 'at a vertex', edge: 'at an edge', face: 'at a face', unsaid: 'at what is not said'};
  return h(
      'section', {}, h('h2', {}, trial.fmt),
      h('p', {},
        `${grouped(trial.rays)} rays, ${
            grouped(trial.exactly_through_edges_or_vertices ?? 0)} of them exactly through an edge or a vertex; ${
            grouped(trial.faces)} faces, ${trial.topology ?? ''}.`),
      table(
          ['method', ...present],
          trial.subjects.flatMap(
              (subject) =>
                  [rowOf(subject, subject.name ?? subject.method, subject.all ?? {}, false),
                   ...Object.entries(subject.by_aim ?? {})
                       .map(([aim, counts]) => rowOf(subject, aims[aim] ?? `at: ${aim}`, counts, true))]),
          {label: `outcomes, ${trial.fmt}`}),
      notes(run, trial, present));
}

/** How each subject was judged, what the columns mean, and where it leaks most. */
function notes(run, trial, present) {
  const parity = trial.subjects.filter(({all}) => all?.parity_judged > 0 && all.parity_judged < all.rays);
  return [
    h('p', {class: 'note'}, '– : not judged on this. Per million of the rays judged.',
      parity.map(({name, all}) => ` ${name} was judged for parity on ${grouped(all.parity_judged)} rays.`)),
    h('p', {class: 'note'}, 'Of a ray they say:'),
    h('dl', {class: 'facts'}, present.map((name) => [h('dt', {}, name), h('dd', {}, meshOutcomes[name])])),
    trial.subjects.filter(({judged}) => judged).map(({name,
                                                      judged}) => h('p', {class: 'note'}, code(name), ` ${judged}.`)),
    trial.subjects.filter((subject) => subject.worst_faces?.length > 0)
        .map(
            (subject) =>
                h('p', {class: 'note'}, code(subject.name),
                  ` leaks most at faces ${
                      subject.worst_faces.slice(0, 8).map(({face, leaks}) => `${face} (${leaks})`).join(', ')}. `,
                  link(to('cases', {run: run.index, method: subject.name}), 'cases'))),
  ];
}
