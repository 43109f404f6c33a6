// Exact arithmetic on the coordinates of cases. Every finite binary number is m·2^e, so all coordinates of one case
// are integers in one common unit 2^unit; sums and products of integers are exact, and nothing here is rounded before
// `ratio` makes a number for the screen.

const buffer = new DataView(new ArrayBuffer(8));

/** A finite double as [m, e] with x = m·2^e, m a BigInt. */
function partsOfDouble(x) {
  buffer.setFloat64(0, x);
  const bits = buffer.getBigUint64(0);
  const biased = Number((bits >> 52n) & 0x7ffn);
  const fraction = bits & 0xfffffffffffffn;
  const magnitude = biased === 0 ? fraction : fraction | (1n << 52n);
  return [bits >> 63n ? -magnitude : magnitude, Math.max(biased, 1) - 1075];
}

const hexFloat = /^([+-]?)0x([0-9a-f]*)(?:\.([0-9a-f]*))?(?:p([+-]?\d+))?$/i;

/** The double that a token of a case file means: a JSON number, a hex float, or a word for what is not finite. */
export function toDouble(token) {
  if (typeof token === 'number') return token;
  const text = String(token).trim().toLowerCase();
  const match = hexFloat.exec(text);
  if (match) {
    const digits = BigInt('0x0' + match[2] + (match[3] ?? ''));
    const exponent = Number(match[4] ?? 0) - 4 * (match[3] ?? '').length;
    const size = ratio(digits, 1n, exponent);
    return match[1] === '-' ? -size : size;
  }
  const word = {nan: NaN, '-nan': NaN, inf: Infinity, '+inf': Infinity, '-inf': -Infinity, infinity: Infinity}[text];
  return word ?? Number(text);
}

/** A double as a C99 hex float, as the program writes it. */
export function toHex(x) {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? 'nan' : x < 0 ? '-inf' : 'inf';
  if (x === 0) return Object.is(x, -0) ? '-0x0p+0' : '0x0p+0';
  const [m, e] = partsOfDouble(Math.abs(x));
  const normal = m >= 1n << 52n;
  const digits = (normal ? m - (1n << 52n) : m).toString(16).padStart(13, '0').replace(/0+$/, '');
  const exponent = e + 52;
  return `${x < 0 ? '-' : ''}0x${normal ? 1 : 0}${digits && '.' + digits}p${exponent < 0 ? '' : '+'}${exponent}`;
}

/** Numbers as integers in one unit: {unit, values} with number i = values[i]·2^unit. */
export function inOneUnit(numbers) {
  const parts = numbers.map(partsOfDouble);
  const used = parts.filter(([m]) => m !== 0n);
  const unit = used.length ? Math.min(...used.map(([, e]) => e)) : 0;
  return {unit, values: parts.map(([m, e]) => (m === 0n ? 0n : m << BigInt(e - unit)))};
}

const absolute = (n) => (n < 0n ? -n : n);
export const bitLength = (n) =>
    (n === 0n ? 0 : absolute(n).toString(16).length * 4 - Math.clz32(parseInt(absolute(n).toString(16)[0], 16)) + 28);
export const signOf = (n) => (n > 0n ? 1 : n < 0n ? -1 : 0);

/** num / den · 2^exponent as a double, off by less than one unit in its last place; ±∞ and 0 beyond the range. */
export function ratio(num, den, exponent = 0) {
  if (num === 0n) return 0;
  const shift = 64 - (bitLength(num) - bitLength(den));
  const quotient = shift >= 0 ? (num << BigInt(shift)) / den : num / (den << BigInt(-shift));
  const power = exponent - shift;
  // Two steps, so that no factor leaves the range of doubles before the product does.
  const half = Math.trunc(power / 2);
  return Number(quotient) * 2 ** half * 2 ** (power - half);
}

/** log2 |num / den · 2^exponent|, for sizes beyond the range of doubles; −∞ of zero. */
export function logOf(num, den = 1n, exponent = 0) {
  if (num === 0n) return -Infinity;
  const shift = bitLength(num) - bitLength(den);
  return Math.log2(Math.abs(ratio(num, den, -shift))) + shift + exponent;
}

// --- vectors of BigInt -----------------------------------------------------------------------------------------------

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const isZero = (v) => v[0] === 0n && v[1] === 0n && v[2] === 0n;

/** det(u, v, w): the one formula of the project, on BigInt. */
export const det3 = (u, v, w) => dot(u, cross(v, w));
