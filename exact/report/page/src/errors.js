// How far off the numbers are that methods give with their hits: counts of fuzz and of certificates, added up.
import {h, table} from './dom.js';
import {grouped, percent, significant} from './figures.js';

/** How far off the numbers are that methods give with right hits of rays, over all families. */
export function numbersOf(run) {
  const errors = run.kind === 'fuzz' ? run.errors : run.record.errors;
  const sums = new Map();
  for (const row of errors?.counts ?? errors ?? []) {
    for (const what of ['t', 'weights']) {
      if (!row[what]) continue;
      const key = `${row.method ?? run.record.method}\n${row.fmt}\n${what}`;
      const sum = sums.get(key) ?? {key, n: 0, half: 0, one: 0, most: 0, lost: 0};
      const {equal = 0, up_to: upTo = [], zeros = 0, zeros_missed: missed = 0, most = 0} = row[what];
      sum.half += equal + (upTo[0] ?? 0) + zeros - missed;
      sum.one += equal + (upTo[0] ?? 0) + (upTo[1] ?? 0) + zeros - missed;
      sum.n += equal + upTo.reduce((a, b) => a + b, 0) + zeros;
      sum.most = Math.max(sum.most, most);
      sum.lost += row[what].not_finite ?? 0;
      sums.set(key, sum);
    }
  }
  if (sums.size === 0) return null;
  const number = (n) => ({cell: grouped(n), class: 'n'});
  const share = (k, n) => ({cell: n ? percent(k / n) : '–', class: 'n'});
  return h(
      'section', {}, h('h2', {}, 'How far off its numbers are'),
      h('p', {class: 'note'}, 'Of right hits of rays, in units in the last place of the exact value.'),
      table(
          ['method', 'format', 'number', 'measured', 'within ½', 'within 1', 'worst', 'not finite'],
          [...sums.values()].map(({key, n, half, one, most, lost}) => {
            const [method, fmt, what] = key.split('\n');
            const name = what === 't' ? 't' : 'weights';
            return [
              h('code', {}, method), fmt.replace('binary', ''), name, number(n), share(half, n), share(one, n),
              {cell: significant(most), class: 'n'}, number(lost)
            ];
          }),
          {label: 'errors of numbers'}));
}
