#include "exact/trial/ulps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "core/vec3.h"
#include "exact/base/fault.h"
#include "exact/base/fp_environment.h"
#include "exact/trial/exact_hit.h"
#include "exact/trial/quick_truth.h"

namespace tribunal {
namespace {

struct Layout {
  long digits, least_exponent, greatest_exponent;
};

constexpr Layout layout_of(Format format) {
  return format == Format::binary32 ? Layout{24, -126, 127} : Layout{53, -1022, 1023};
}

long bits_of(const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

mpz_class shifted(const mpz_class& x, long by) { return by > 0 ? mpz_class(x << static_cast<mp_bitcnt_t>(by)) : x; }

/// a / b > 0, not in lowest terms.
struct Magnitude {
  mpz_class a, b;

  Magnitude(const Dyadic& num, const Dyadic& den) {
    const mpq_class n = num.fraction(), d = den.fraction();
    a = abs(n.get_num()) * d.get_den();
    b = abs(d.get_num()) * n.get_den();
  }

  /// The sign of a/b − 2^e.
  int compare_with_power(long e) const { return cmp(shifted(a, -e), shifted(b, e)); }

  /// ⌊log₂(a/b)⌋
  long floor_log2() const {
    const long e = bits_of(a) - bits_of(b);
    return compare_with_power(e) < 0 ? e - 1 : e;
  }

  /// ⌈log₂(a/b)⌉
  long ceil_log2() const {
    const long e = floor_log2();
    return compare_with_power(e) == 0 ? e : e + 1;
  }

  /// Divides by 2^e.
  void scale_down(long e) {
    a = shifted(a, -e);
    b = shifted(b, e);
  }

  /// Rounded towards 0, and no more than the largest number.
  double value() const {
    const long e = floor_log2();
    if (e > 1023) return std::numeric_limits<double>::max();
    const long shift = 52 - e;
    const mpz_class quotient = shifted(a, shift) / shifted(b, -shift);
    return std::ldexp(quotient.get_d(), static_cast<int>(-shift));
  }
};

template <std::size_t n>
void add_each(std::array<std::uint64_t, n>& to, const std::array<std::uint64_t, n>& from) {
  for (std::size_t i = 0; i < n; ++i) to[i] += from[i];
}

using Vector = Vec3<Dyadic>;

Dyadic dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

std::optional<HitAt> asked(const Method& method, const Ray& ray, const Triangle& triangle) {
  if (method.hit) return method.hit(ray, triangle);
  const std::optional<double> t = method.parameter(ray, triangle);
  return t ? std::optional<HitAt>(HitAt{.t = *t}) : std::nullopt;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

}  // namespace

void Ulps::add(double computed, const ExactRatio& exact, Format format, std::uint64_t k) {
  if (sign_of(exact.num) == Sign::zero) {
    ++zeros;
    zeros_missed += computed != 0;
    return;
  }
  const Layout layout = layout_of(format);
  const long exponent = Magnitude(exact.num, exact.den).floor_log2();
  if (exponent > layout.greatest_exponent) {
    ++beyond;
    return;
  }
  if (!std::isfinite(computed)) {
    ++not_finite;
    return;
  }
  const Dyadic difference = Dyadic(computed) * exact.den - exact.num;
  if (sign_of(difference) == Sign::zero) {
    ++equal;
    if (most == 0) most_at = std::min(most_at, k);
    return;
  }
  Magnitude error(difference, exact.den);
  error.scale_down(std::max(exponent, layout.least_exponent) - layout.digits + 1);
  ++up_to[static_cast<std::size_t>(std::clamp(error.ceil_log2() + 1, 0L, static_cast<long>(bins) - 1))];
  const double ulps = error.value();
  if (ulps > most || (ulps == most && k < most_at)) {
    most = ulps;
    most_at = k;
  }
}

Ulps& Ulps::operator+=(const Ulps& other) {
  equal += other.equal;
  add_each(up_to, other.up_to);
  zeros += other.zeros;
  zeros_missed += other.zeros_missed;
  not_finite += other.not_finite;
  beyond += other.beyond;
  if (other.most > most) {
    most = other.most;
    most_at = other.most_at;
  } else if (other.most == most) {
    most_at = std::min(most_at, other.most_at);
  }
  return *this;
}

std::uint64_t Ulps::measured() const { return std::accumulate(up_to.begin(), up_to.end(), equal); }

double Ulps::bound_of(int percent) const {
  const std::uint64_t n = measured();
  std::uint64_t within = equal;
  const auto enough = [&] { return within * 100 >= n * static_cast<std::uint64_t>(percent); };
  if (enough()) return 0;
  for (std::size_t i = 0; i + 1 < bins; ++i) {
    within += up_to[i];
    if (enough()) return std::ldexp(0.5, static_cast<int>(i));
  }
  return std::numeric_limits<double>::infinity();
}

HitErrors& HitErrors::operator+=(const HitErrors& other) {
  hits += other.hits;
  withheld += other.withheld;
  t += other.t;
  weights += other.weights;
  return *this;
}

ExactHit exact_hit(const Ray& ray, const Triangle& triangle) {
  const Vector o = lift<Dyadic>(ray.o), d = lift<Dyadic>(ray.d.v);
  const Vector a = lift<Dyadic>(triangle.a) - o, b = lift<Dyadic>(triangle.b) - o, c = lift<Dyadic>(triangle.c) - o;
  const Vector n = cross(b - a, c - a);
  const Dyadic speed = dot(d, n);
  return {{dot(a, n), speed}, {dot(d, cross(c, a)), speed}, {dot(d, cross(a, b)), speed}};
}

bool has_numbers(const Query& query, const Truth& truth) {
  return is_of_ray(query) && query.operands() == Operands::triangles && truth.hit() &&
         truth.contact != Contact::coplanar;
}

std::optional<HitAt> numbers_of(const Method& method, const Query& query) {
  try {
    const std::optional<HitAt> given = asked(method, std::get<Ray>(query.probe), query.triangle());
    require_exact_rounding();
    return given;
  } catch (const MethodFault&) {
    return std::nullopt;
  }
}

void add_numbers(HitErrors& errors, const std::optional<HitAt>& given, const ExactHit& exact, Format format,
                 std::uint64_t k) {
  ++errors.hits;
  if (!given) {
    ++errors.withheld;
    return;
  }
  errors.t.add(given->t, exact.t, format, k);
  if (!given->weights) return;
  errors.weights.add(given->weights->b, exact.b, format, k);
  errors.weights.add(given->weights->c, exact.c, format, k);
}

/// By another hash than the audit's, so that one share does not lie in the other.
bool is_measured(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return hash_of_case(~seed, stream, k) % measured_period == 0;
}

std::string in_words(const Ulps& u) {
  std::string text;
  const std::uint64_t n = u.measured();
  if (n > 0) {
    const auto within = [&](int percent) { return std::min(u.bound_of(percent), u.most); };  // a bin ends above it
    text = "half within " + number(within(50)) + ", 99 % within " + number(within(99)) + ", at most " + number(u.most) +
           " ulps (case " + std::to_string(u.most_at) + "), of " + std::to_string(n);
  }
  const auto list = [&](std::uint64_t count, const std::string& what) {
    if (count > 0) text += (text.empty() ? "" : "; ") + std::to_string(count) + what;
  };
  list(u.zeros_missed, " of " + std::to_string(u.zeros) + " zeros missed");
  list(u.not_finite, " not finite");
  list(u.beyond, " beyond the format");
  return text;
}

}  // namespace tribunal
