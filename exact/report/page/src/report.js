// The data of the page, and the words that belong to it. The schema is docs/report.md.

const read = () => JSON.parse(document.getElementById('tribunal-data').textContent);

export const report = read();

/** Rows of a table of the schema as objects; numbers that were cut from a row's end are 0. */
export function rowsOf(table) {
  if (!table) return [];
  const {columns, words = {}, rows} = table;
  return rows.map((row) => Object.fromEntries(columns.map((name, i) => {
    const value = i < row.length ? row[i] : 0;
    return [name, words[name] && value !== null ? words[name][value] : value];
  })));
}

const remembered = new WeakMap();

/** The same, made once for each table. */
export function rows(table) {
  if (!table) return [];
  if (!remembered.has(table)) remembered.set(table, rowsOf(table));
  return remembered.get(table);
}

export const runsOf = (kind) => report.runs.map((run, index) => ({...run, index})).filter((run) => run.kind === kind);

/** The title of a run; a map of rays says so. */
export const titleOf = ({kind, title, record}) =>
    (kind === 'map' && record?.probe === 'ray' && !title.includes('ray') ? `${title}, rays` : title);

export const classRow = (id) => report.classes?.find((row) => row.id === id);
export const method = (name) => report.methods?.[name] ?? {};

/**
 * Whether a method that the program asked came from a shared library of the user's: a record may have the library's
 * hash, and of its own methods the program says what they are about. Answers that were only judged came from elsewhere.
 */
export function isPlugin(name) {
  const {about, reference} = method(name);
  if (/\blibrary sha256\b/.test(reference ?? '')) return true;
  const asked = ({kind, judged, methods}) =>
      methods?.includes(name) && !judged && (kind !== 'leak' || !name.includes('/'));
  return about === undefined && report.runs.some(asked);
}

/** Names in the order of the program's table; those that it does not know stand last. */
export function inOrder(names, order = report.method_order ?? []) {
  const place = (name) => (order.includes(name) ? order.indexOf(name) : order.length);
  return [...new Set(names)].sort((a, b) => place(a) - place(b));
}

/** Every method's answer to a case: [{name, letter}]. */
export const answersOf =
    (entry) => [...(entry.answers ?? '')].map((letter, i) => ({name: report.answer_methods[i], letter}));

/** How bad a verdict is: 0 nothing, 1 a gap, 2 wrong where it is hard, 3 wrong on plain input. */
export const gravity = (level) => ({
                                    plain: 3,
                                    fault: 3,
                                    boundary: 2,
                                    extreme: 2,
                                    relations: 2,
                                    leaks: 2,
                                    incomplete: 1,
                                    refused: 1,
                                    pictures: 1
                                  })[level] ??
    0;

export const severityInWords = {
  plain: 'general position, everyday scale',
  boundary: 'on boundaries, at everyday scale',
  extreme: 'at extreme scales',
};
