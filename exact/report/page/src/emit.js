// A case as text to take away: a JSON line, a test in C, exact arithmetic in Python, the command that replays it.
// Hex floats are read by C, C++ and Python's float.fromhex as they are. An id is anything that a file says, and must
// not become code.
import {toDouble, toHex} from './exact.js';
import {exactSigns} from './question.js';
import {isPlugin} from './report.js';

export const asJson = (data) => JSON.stringify(data);

/** Text for a comment: on one line, and with neither end of a comment in it. */
const asComment = (text) => String(text)
                                .replace(/[\p{Cc}\u2028\u2029]/gu, ' ')
                                .replaceAll('*/', '* /')
                                .replaceAll('/*', '/ *')
                                .replaceAll('??/', '? ?/')
                                .replace(/\\/g, '/');

const asName = (text) => String(text).slice(0, 80).replace(/[^A-Za-z0-9_]/g, '_');

const numbersOf = (points) => points.flat().map((x) => toHex(toDouble(x)));

function partsOf(data) {
  const probe = data.ray ? [data.ray.o, data.ray.d] : data.seg;
  return {
    kind: data.ray ? (data.ray.t ? 'ray_within' : 'ray') : 'segment',
    probe: numbersOf(probe),
    bounds: data.ray?.t?.map(toDouble)
  };
}

export const canEmit = (data) => data.tri !== undefined;

/** A test in C that expects the exact answer of a function of the user's. */
export function asC(data, hit, words) {
  const {kind, probe, bounds} = partsOf(data);
  const parameters = bounds ? 'const double probe[6], const double bounds[2], const double triangle[9]' :
                              'const double probe[6], const double triangle[9]';
  const limits = bounds?.map((x) => (x === Infinity ? 'INFINITY' : toHex(x))).join(', ');
  return [
    `/* ${asComment(data.id)}: ${asComment(words)} */`,
    '#undef NDEBUG',
    '#include <assert.h>',
    bounds ? '#include <math.h>' : null,
    '',
    `int my_test_${kind}(${parameters});`,
    '',
    `void case_${asName(data.id)}(void) {`,
    `  const double probe[6] = {${probe.join(', ')}};`,
    bounds ? `  const double bounds[2] = {${limits}};` : null,
    `  const double triangle[9] = {${numbersOf(data.tri).join(', ')}};`,
    `  assert(my_test_${kind}(${bounds ? 'probe, bounds, triangle' : 'probe, triangle'}) == ${hit ? 1 : 0});`,
    '}',
    '',
  ].filter((line) => line !== null)
      .join('\n');
}

const quoted = (numbers) => numbers.map((x) => `'${x}'`).join(', ');

/** The five exact signs in Python, with nothing but fractions. */
export function asPython(data, question, words) {
  const {kind, probe} = partsOf(data);
  const isRay = kind !== 'segment';
  return `# ${asComment(data.id)}: ${asComment(words)}
from fractions import Fraction


def points(*texts):
    flat = [Fraction(float.fromhex(text)) for text in texts]
    return [flat[i:i + 3] for i in range(0, len(flat), 3)]


def sign(o, u, v, x, direction=False):
    """Of the volume of o u v x: x is a point, or a direction."""
    m = [[s - t for s, t in zip(w, o)] for w in (u, v)] + [x if direction else [s - t for s, t in zip(x, o)]]
    d = (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
         + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))
    return (d > 0) - (d < 0)


${isRay ? 'p, d' : 'p, q'} = points(${quoted(probe)})
a, b, c = points(${quoted(numbersOf(data.tri))})
${
      isRay ?
          'signs = [sign(a, b, c, p), sign(a, b, c, d, True)] + [sign(p, *edge, d, True) for edge in ((a, b), (b, c), (c, a))]' :
          'signs = [sign(a, b, c, p), sign(a, b, c, q)] + [sign(p, *edge, q) for edge in ((a, b), (b, c), (c, a))]'}
assert signs == [${exactSigns(question).join(', ')}]
print(signs)
`;
}

/** A word of a shell command. */
const shellQuoted = (text) => (/^[\w./-]+$/.test(text) ? text : `'${text.replaceAll('\'', '\'\\\'\'')}'`);

/** Stands for the file of a plugin, which no record names. */
export const libraryPlaceholder = './LIB.so';
const pluginOption = (name) => (isPlugin(name) ? ` --plugin ${libraryPlaceholder}` : '');

/** The command that replays a case: the program's, or for a case that stands in no file one with its text. */
export function replayOf({replay, method, case: data}) {
  if (!replay) return `tribunal replay -${pluginOption(method)} <<'EOF'\n${asJson(data)}\nEOF`;
  return replay.endsWith('tribunal replay -') ? replay + pluginOption(method) : replay;
}

export const mapPixelCommand = (map, method, x, y) => `tribunal sweep --map ${shellQuoted(map.map)} ${
    map.probe === 'ray' ? '--probe ray ' : ''}--map-size ${Number(map.size)} --method ${shellQuoted(method)} --pixel ${
    shellQuoted(`${method},${x},${y}`)}${pluginOption(method)}`;
