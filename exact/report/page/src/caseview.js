// One case, whole: in 3D, its signs, its class in words and as a sketch, and as text to take away.
import {code, h, link} from './dom.js';
import {asC, asJson, asPython, canEmit, libraryPlaceholder, replayOf} from './emit.js';
import {ratio} from './exact.js';
import {isOfMesh, meshError} from './mesh.js';
import {crossingOf, questionOf} from './question.js';
import {classRow, isPlugin, report, severityInWords} from './report.js';
import {to} from './route.js';
import {answersTable, coordinatesTable, signsTable} from './signs.js';
import {sketchOf} from './sketch.js';
import {stage} from './stage.js';

/** Copies text and says so; where a page may not use the clipboard, the text is shown selected instead. */
function copyButton(name, make) {
  const box = h('textarea', {class: 'copied', readonly: true, rows: 6, hidden: true, 'aria-label': `${name}, to copy`});
  const state = h('span', {class: 'state', role: 'status'});
  const copy = async () => {
    const text = make();
    box.value = text;
    try {
      await navigator.clipboard.writeText(text);
      state.textContent = ' copied';
      box.hidden = true;
    } catch {
      box.hidden = false;
      box.select();
      state.textContent = document.execCommand?.('copy') ? ' copied' : ' select and copy';
    }
  };
  return h('div', {class: 'copy'}, h('button', {type: 'button', 'data-copy': name, onclick: copy}, name), state, box);
}

function verdictLine(entry) {
  if (!entry.outcome) return null;
  return [
    h('p', {class: 'lead'}, h('b', {class: 'wrong'}, `${entry.method}: ${entry.outcome}`),
      entry.in_words && ` – ${entry.in_words}`, '.'),
    isOfMesh(entry) && meshError(entry)
  ];
}

/** Where a case was generated: in a family, along an axis, or on a mesh; of one's own data, from which file. */
function originInWords(origin) {
  const {family, axis, value, stress, mesh, ray, face, aimed_at: aim, fmt, seed, case: number, file} = origin;
  const place = mesh !== undefined ? `${mesh}: ray ${ray}, aimed at ${aim}, and face ${face}` :
      value !== undefined ? `sweep along ${axis}, at ${value}` :
                            family;
  const parts = [
    place, fmt, seed !== undefined && `seed ${seed}`, number !== undefined && `case ${number}`,
    stress !== undefined && axis && axis !== '(none)' && `${axis}: ${stress}`, file
  ];
  return parts.filter(Boolean).join(', ');
}

function facts(entry, question) {
  const crossing = question.finite && !question.isPolygon ? crossingOf(question) : null;
  const t = crossing && tOf(question);
  const origin = entry.origin;
  const list = [
    ['severity', entry.severity && `${entry.severity}: ${severityInWords[entry.severity] ?? ''}`],
    [
      'cause',
      entry.cause === 'rounding'  ? 'rounding: the same source without rounding is right' :
          entry.cause === 'logic' ? 'logic: the same source without rounding is wrong too' :
                                    entry.cause
    ],
    ['fault', entry.fault && `${entry.fault} ${entry.detail ?? ''}`],
    [
      'exact contact',
      entry.truth &&
          (entry.truth.hit ?
               [
                 entry.truth.contact ?? 'hit', entry.truth.at && `, at the ${entry.truth.at} of the probe`,
                 entry.truth.side && `, from the ${entry.truth.side}`
               ] :
               'none: they do not meet')
    ],
    ['line meets plane at', t],
    ['from', origin && originInWords(origin)],
    ['file', entry.file && `${entry.file}, line ${entry.line}`],
  ].filter(([, value]) => value);
  return h('dl', {class: 'facts'}, list.map(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
}

/** The parameter of the crossing: a fraction of pq, or a multiple of d. */
function tOf(question) {
  const {p, direction} = question.exact;
  const {point, weight} = crossingOf(question);
  const axis = [0, 1, 2].find((i) => direction[i] !== 0n);
  if (axis === undefined) return null;
  const t = ratio(point[axis] - p[axis] * weight, direction[axis] * weight);
  return `t ≈ ${t} ${question.isRay ? '· d' : 'of pq'}`;
}

function classPart(row) {
  if (!row) return null;
  return h(
      'section', {class: 'class-card'}, sketchOf(row),
      h('div', {}, h('h2', {class: 'minor'}, 'Class ', link(to('class', row.id), row.id)), h('p', {}, row.words)));
}

/** A record holds the hash of a plugin's library and not its file, so whoever replays must name it. */
const pluginNote = ({method}) =>
    (isPlugin(method) ? h('p', {class: 'note'}, `${method} is not built in: put the file of its library in place of `,
                          code(libraryPlaceholder), '.') :
                        null);

/** `entry` is a row of the schema's cases, or as much of one as is known. */
export function casePage(entry, state, heading) {
  const data = entry.case;
  const question = questionOf(data);
  const hit = entry.truth?.hit ?? entry.expected ?? data.expect ?? null;
  const words = `${entry.class ?? data.class ?? ''} ${hit === null ? '' : hit ? 'hit' : 'no hit'}`.trim();
  const emittable = canEmit(data) && question.finite;
  return h(
      'article', {class: 'case'}, heading,
      h('h1', {class: 'id'}, code(data.id), ' ', h('small', {}, data.fmt ?? 'binary64')), verdictLine(entry),
      h('div', {class: 'pair'}, stage(question, state, entry.truth?.hit),
        h('div', {}, facts(entry, question), classPart(classRow(entry.class ?? data.class)),
          h('section', {}, h('h2', {class: 'minor'}, 'Take it away'),
            h('div', {class: 'copies'}, copyButton('case (JSON line)', () => asJson(data)),
              emittable && hit !== null && copyButton('C', () => asC(data, hit, words)),
              emittable && copyButton('Python', () => asPython(data, question, words)),
              copyButton('command', () => replayOf(entry))),
            h('pre', {class: 'command', tabindex: 0}, replayOf(entry)), pluginNote(entry)))),
      emittable &&
          h('section', {}, h('h2', {}, 'Computed beside exact'),
            h('p', {},
              'The signs of five volumes decide. Exact ones are computed on this page with integers; the others by the same formula, rounded at every step.'),
            signsTable(question)),
      entry.answers && h('section', {}, h('h2', {}, 'What every method says'), answersTable(entry)),
      h('section', {}, h('h2', {}, 'Coordinates'), coordinatesTable(question)));
}

/** Earlier and later cases of the same run. */
function neighbours(number, entry) {
  const list = report.runs[entry.run]?.cases ?? [];
  const place = list.indexOf(number);
  const step = (target, name) => (target === undefined ? null : link(to('case', target), name));
  return h(
      'p', {class: 'crumbs'}, link(to('cases', {run: entry.run}), report.runs[entry.run]?.title ?? 'cases'),
      place >= 0 && ` · case ${place + 1} of ${list.length} `,
      h('span', {class: 'steps'}, step(list[place - 1], '← before'), ' ', step(list[place + 1], 'next →')));
}

export function numberedCase(number, query) {
  const entry = report.cases[number];
  if (!entry) return h('p', {}, `There is no case ${number} in this report.`);
  return casePage(entry, Object.fromEntries(query), neighbours(number, entry));
}
