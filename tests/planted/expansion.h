// Sign of a 3×3 determinant by floating-point expansions. All of it has internal linkage: two translation units compile
// it with different floating-point flags, and the linker must not take one's code for the other's. The small functions
// are always inlined, since a product and a sum are contracted only where the compiler sees both. Source: Shewchuk,
// "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational
// Geometry 18, 1997 (Two-Sum, Split, Two-Product, Grow-Expansion: theorems 7, 17, 18, 10).
#pragma once

namespace {

/// x + y exactly, as rounded sum and error.
struct Pair {
  double high, low;
};

[[gnu::always_inline]] inline Pair two_sum(double x, double y) {
  const double sum = x + y;
  const double y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}

[[gnu::always_inline]] inline Pair split(double x) {
  const double c = 134217729.0 * x;  // 2²⁷ + 1
  const double high = c - (c - x);
  return {high, x - high};
}

/// Dekker's product: right only if every operation rounds by itself. No overflow or underflow.
[[gnu::always_inline]] inline Pair two_product(double x, double y) {
  const double product = x * y;
  const Pair a = split(x), b = split(y);
  const double error = ((product - a.high * b.high) - a.low * b.high) - a.high * b.low;
  return {product, a.low * b.low - error};
}

/// A sum of non-overlapping terms, least first.
struct Expansion {
  double term[24] = {};
  int size = 0;

  void add(double x) {
    for (int i = 0; i < size; ++i) {
      const Pair s = two_sum(x, term[i]);
      term[i] = s.low;
      x = s.high;
    }
    term[size++] = x;
  }

  void add_product(double x, double y) {
    const Pair p = two_product(x, y);
    add(p.low);
    add(p.high);
  }

  int sign() const {
    for (int i = size - 1; i >= 0; --i) {
      if (term[i] != 0) return term[i] > 0 ? 1 : -1;
    }
    return 0;
  }
};

/// Adds (a·d − b·c)·e. Products meet a sum at once: this is where contraction does its harm.
void add_minor(Expansion& sum, double a, double b, double c, double d, double e) {
  const Pair ad = two_product(a, d), bc = two_product(b, c);
  const Pair high = two_sum(ad.high, -bc.high);
  for (const double part : {ad.low, -bc.low, high.low, high.high}) sum.add_product(part, e);
}

/// det of the rows u, v, w, expanded along the first.
int sign_of_determinant(const double (&u)[3], const double (&v)[3], const double (&w)[3]) {
  Expansion e;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    add_minor(e, v[j], v[k], w[j], w[k], u[i]);
  }
  return e.sign();
}

}  // namespace
