// What can go wrong when a test is asked about a ray and a mesh, in words. A case of it is one ray and one of the
// faces; the error is one of the whole mesh, or of a few faces together.
import {code, h} from './dom.js';
import {grouped} from './figures.js';
import {report} from './report.js';

/** Each outcome of a ray, as a sentence about the ray. */
export const meshOutcomes = {
  leak: 'it passes through the surface, and no face is reported there',
  lost: 'a leak, and no face of the mesh is reported at all',
  'false hit': 'a face is reported that it misses, as it misses all faces around it',
  'double hit':
      'beside a face that it meets, one is reported that it misses; or an even number of faces where just one is due',
  parity: 'the number of reported faces puts its source on the wrong side: inside for outside, or the reverse',
  closest: 'the face that is reported as the closest is not',
  order: 'a closest face is reported that it meets later than another; or a list that should be sorted is not',
  t: 't of the closest hit is further off than promised',
  normal: 'the normal or the side of the closest hit is wrong',
  fault: 'the test did something else than answer',
  neighbour: 'no error: in place of a face that it meets, one beside it is reported',
  'reported twice': 'no error: where it passes an edge or a vertex, several faces that it meets are reported',
  outline: 'no error: it passes, by no more than rounding, what it sees as outline, and is not reported there',
};

/** Errors that the answer to one triangle cannot show. */
const ofMany = ['lost', 'leak', 'double hit', 'parity', 'closest', 'order'];

export const isOfMesh = (entry) => entry.origin?.mesh !== undefined && entry.outcome in meshOutcomes;

/** What a mesh's error is about: the ray, the faces, what is due of the face shown, and what `replay` can show. */
export function meshError(entry) {
  const {mesh, ray, face, aimed_at: aim} = entry.origin;
  const run = report.runs[entry.run];
  const trial = run?.record?.trials?.find(({fmt}) => fmt === (entry.case.fmt ?? 'binary64'));
  const faces = trial?.faces ? `all ${grouped(trial.faces)} faces of ${mesh}` : `all faces of ${mesh}`;
  const due = entry.truth ?
      ` Due at this face is ${entry.truth.hit ? `a hit (${entry.truth.contact ?? 'a contact'})` : 'a miss'}.` :
                                                '';
  return [
    h('p', {},
      `Ray ${ray}${aim ? `, aimed at ${aim},` : ''} was asked about ${faces}: ${meshOutcomes[entry.outcome]}. `,
      `Shown is face ${face}, one of those that it is about.${due}`),
    ofMany.includes(entry.outcome) &&
        h('p', {class: 'note'}, 'The error is in what was told of several faces together. ', code('replay'),
          ' asks this one triangle only, ',
          /\/(closest|any|all|inside)$/.test(entry.method) ? 'and cannot ask a tree of faces. ' :
                                                             'and there the method may well be right. ',
          run?.command && ['The whole trial is made again by ', code(run.command), '.']),
  ];
}
