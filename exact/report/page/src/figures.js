// Numbers for people, and intervals of shares.

const grouping = new Intl.NumberFormat('en-US');
export const grouped = (n) => grouping.format(n);

export function percent(share) {
  if (share === 0) return '0\u00a0%';
  if (share === 1) return '100\u00a0%';
  const value = 100 * share;
  return value >= 99.995 && value < 100 ? '>99.99\u00a0%' :
                                          `${
                                              value >= 10         ? value.toFixed(1) :
                                                  value >= 0.0995 ? value.toFixed(2) :
                                                                    significant(value, 2)}\u00a0%`;
}

/** Text of the program, with no break between a number and its percent sign. */
export const unbroken = (text) => text.replaceAll(' %', '\u00a0%');

/** A share at a power of ten, for an axis. */
export const percentTick = (share) => `${significant(100 * share, 2)}\u00a0%`;

/** Few digits, and powers of ten where a number is very large or small. */
export function significant(x, digits = 3) {
  if (x === 0 || !Number.isFinite(x)) return String(x).replace('-', '−');
  const [mantissa, exponent] = x.toExponential(digits - 1).split('e').map(Number);
  const text =
      exponent >= -3 && exponent < 6 ? String(Number(x.toPrecision(digits))) : `${mantissa}·10${superscript(exponent)}`;
  return text.replace('-', '−');
}

export const superscript = (n) => String(n).replace(/[-\d]/g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]));

/** ln Γ(x) by Lanczos' series (g = 7), good to 1e-13. */
function logGamma(x) {
  const series = [
    0.99999999999980993, 676.5203681218851, -1259.1392167224028, 771.32342877765313, -176.61502916214059,
    12.507343278686905, -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7
  ];
  const y = x - 1;
  const sum = series.reduce((total, term, i) => (i === 0 ? term : total + term / (y + i)), 0);
  const t = y + 7.5;
  return 0.5 * Math.log(2 * Math.PI) + (y + 0.5) * Math.log(t) - t + Math.log(sum);
}

/** The incomplete beta function's ratio I_x(a, b), by Lentz's continued fraction. */
function betaRatio(x, a, b) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  if (x > (a + 1) / (a + b + 2)) return 1 - betaRatio(1 - x, b, a);
  const front = Math.exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * Math.log(x) + b * Math.log1p(-x)) / a;
  let f = 1, c = 1, d = 0;
  for (let i = 0; i <= 400; ++i) {
    const m = Math.floor(i / 2);
    const numerator = i === 0 ? 1 :
        i % 2 === 0           ? (m * (b - m) * x) / ((a + 2 * m - 1) * (a + 2 * m)) :
                                -((a + m) * (a + b + m) * x) / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / (1 + numerator * d || 1e-300);
    c = 1 + numerator / c || 1e-300;
    f *= c * d;
    if (Math.abs(1 - c * d) < 1e-12) break;
  }
  return front * (f - 1);
}

/** x with I_x(a, b) = level. */
function betaQuantile(level, a, b) {
  let low = 0, high = 1;
  for (let i = 0; i < 100; ++i) {
    const middle = (low + high) / 2;
    if (betaRatio(middle, a, b) < level)
      low = middle;
    else
      high = middle;
  }
  return (low + high) / 2;
}

/** Clopper and Pearson's interval at 95 %: two-sided, or one-sided where nothing or everything failed. */
export function interval(k, n) {
  if (n === 0) return [0, 1];
  if (k === 0) return [0, 1 - 0.05 ** (1 / n)];
  if (k === n) return [0.05 ** (1 / n), 1];
  return [betaQuantile(0.025, k, n - k + 1), betaQuantile(0.975, k + 1, n - k)];
}

/** "12 of 1,000 (1.20 %, between 0.62 % and 2.09 %)" */
export function shareInWords(k, n) {
  if (n === 0) return 'none judged';
  const [lower, upper] = interval(k, n);
  const bound = k === 0 ? `at most ${percent(upper)}` :
      k === n ? `at least ${percent(lower)}` :
                `between ${percent(lower)} and ${percent(upper)}`;
  return `${grouped(k)} of ${grouped(n)} (${percent(k / n)}; with 95 % confidence ${bound})`;
}
