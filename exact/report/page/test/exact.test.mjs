// node --test test/: the exact arithmetic of the page, without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bitLength, logOf, ratio, toDouble, toHex} from '../src/exact.js';
import {interval} from '../src/figures.js';
import {Lens} from '../src/lens.js';
import {crossingOf, exactSigns, focusOf, logDistance, nearestOnProbe, placeOf, questionOf} from '../src/question.js';
import {roundedVolumes, ulp} from '../src/rounded.js';

test('hex floats and doubles are one another', () => {
  for (const x of [0, -0, 1, 0.1, -3.7e300, 5e-324, 2 ** -1022, Number.MAX_VALUE, 123456.789])
    assert.ok(Object.is(toDouble(toHex(x)), x), toHex(x));
  assert.equal(toDouble('-0x1.8p+1'), -3);
  assert.equal(toDouble('0x.8'), 0.5);
});

test('ratios are rounded at the end alone', () => {
  assert.equal(ratio(1n, 3n), 1 / 3);
  assert.equal(ratio(3n, -4n), -0.75);
  assert.equal(ratio(1n << 3000n, 1n << 2999n), 2);
  assert.equal(ratio(1n, 1n, -1074), 5e-324);
  assert.equal(logOf(1n, 1n << 5000n), -5000);
  for (let n = 1n; n < 1n << 70n; n = n * 3n + 1n) assert.equal(bitLength(n), n.toString(2).length);
});

const touching = {
  seg: [[0.25, 0.25, 1], [0.25, 0.25, 0]],
  tri: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
};

test('signs are exact where rounding loses them', () => {
  assert.deepEqual(exactSigns(questionOf(touching)), [1, 0, 1, 1, 1].map((s, i) => (i < 2 ? s : -s)));
  const tiny = questionOf(
      {seg: [[0.25, 0.25, 5e-324], [0.25, 0.25, -5e-324]], tri: [[0, 0, 0], [1e-200, 0, 0], [0, 1e-200, 0]]});
  assert.deepEqual(exactSigns(tiny).slice(0, 2), [1, -1]);
  assert.equal(roundedVolumes(tiny, 'binary64')[0], 0);
});

test('one ulp fills the window', () => {
  const beside = questionOf(
      {seg: [[0.75, 0.25, 1], [0.75, 0.25, -1]], tri: [[0, 0, 0], [0.75 + 2 ** -53, 0, 0], [0.75 + 2 ** -53, 1, 0]]});
  const focus = focusOf(beside);
  const lens = new Lens(beside, focus, -53);
  const [from, to] = beside.exact.rings[0].slice(1);
  const edge = lens.line(from, to.map((x, i) => x - from[i]));
  assert.ok(edge.every(([x]) => x === 1), 'the edge stands one ulp of 0.75 beside the probe');
  const [probe] = [lens.line(beside.exact.p, beside.exact.direction)];
  assert.ok(probe.every(([x, y]) => x === 0 && y === 0));
  assert.ok(lens.surfaces()[0][0].every(([x]) => x <= 1));
});

test('the place to look at is on the probe or nearest to it', () => {
  const parallel = questionOf({ray: {o: [0, 0, 1], d: [1, 0, 0]}, tri: touching.tri});
  assert.equal(crossingOf(parallel), null);
  assert.equal(logDistance(parallel, focusOf(parallel), nearestOnProbe(parallel, focusOf(parallel))), 0);
  const place = placeOf(parallel.exact.p);
  assert.equal(logDistance(parallel, place, place), -Infinity);
});

test('ulps of both formats', () => {
  assert.equal(ulp(1, 'binary64'), 2 ** -52);
  assert.equal(ulp(0.75, 'binary32'), 2 ** -24);
  assert.equal(ulp(0, 'binary64'), 5e-324);
});

test('intervals of Clopper and Pearson', () => {
  const near = (x, y) => assert.ok(Math.abs(x - y) < 5e-7, `${x} is not ${y}`);
  const [lower, upper] = interval(12, 1000);
  near(lower, 0.0062155);
  near(upper, 0.0208677);
  near(interval(0, 100)[1], 0.0295130);
  near(interval(1, 5)[1], 0.7164179);
});
