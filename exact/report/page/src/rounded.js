// The same volumes as a program computes them in binary64 or binary32: the operations of core/signed_volume.h in their
// order, each rounded once. JavaScript's numbers are binary64; Math.fround rounds to binary32, and as binary64 has more
// than twice its digits, a sum or product rounded twice is the one rounded once.

const kinds = {
  binary64: (x) => x,
  binary32: Math.fround
};

function det3(u, v, w, round) {
  const r = round;
  const x = r(r(v[1] * w[2]) - r(v[2] * w[1]));
  const y = r(r(v[2] * w[0]) - r(v[0] * w[2]));
  const z = r(r(v[0] * w[1]) - r(v[1] * w[0]));
  return r(r(r(u[0] * x) + r(u[1] * y)) + r(u[2] * z));
}

/** The volumes abcp, abcq, pqab, pqbc, pqca (of a ray q is its direction) as rounded numbers. */
export function roundedVolumes(question, format) {
  const round = kinds[format];
  const arm = (o, x) => x.map((value, i) => round(value - o[i]));
  const {p, q, isRay, rings} = question;
  const [a, b, c] = rings[0];
  const end = (o) => (isRay ? q : arm(o, q));
  return [
    det3(arm(a, b), arm(a, c), arm(a, p), round),
    det3(arm(a, b), arm(a, c), end(a), round),
    det3(arm(p, a), arm(p, b), end(p), round),
    det3(arm(p, b), arm(p, c), end(p), round),
    det3(arm(p, c), arm(p, a), end(p), round),
  ];
}

/** The spacing of the numbers of a format at x: one unit in the last place. */
export function ulp(x, format) {
  const [digits, least] = format === 'binary32' ? [24, -149] : [53, -1074];
  if (x === 0) return 2 ** least;
  let exponent = Math.floor(Math.log2(Math.abs(x)));
  if (2 ** exponent > Math.abs(x)) exponent -= 1;
  return 2 ** Math.max(least, exponent - digits + 1);
}
