// What tests of the filters' constants share: running Gappa, a number type that tracks errors, small float formats.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <string>

#include "core/sign.h"
#include "exact/filtered/filter_bounds.h"

namespace tribunal {

using namespace detail;

/// Runs Gappa and returns what it proves: for each quantity of the script, the upper end of its interval.
inline std::map<std::string, double> proved_by(const std::string& script) {
  const std::string command = "gappa exact/filtered/proofs/" + script + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  char buffer[4096];
  for (std::size_t n; pipe && (n = fread(buffer, 1, sizeof buffer, pipe.get())) > 0;) output.append(buffer, n);
  std::map<std::string, double> proved;
  const std::regex line(R"(\n  (.+) in \[.*, (-?\d+)b(-?\d+) \{)");
  for (std::sregex_iterator i(output.begin(), output.end(), line), end; i != end; ++i) {
    proved[(*i)[1]] = std::ldexp(std::stod((*i)[2]), std::stoi((*i)[3]));
  }
  EXPECT_FALSE(proved.empty()) << command << " said: " << output;
  return proved;
}

/// A number that knows how large it may be and how far it may be off, where every coordinate difference is at most 1 in
/// magnitude once rounded, and every operation is exact up to a factor 1 + δ, |δ| ≤ 2⁻⁵². Run through the shipped
/// formulas it derives their constants.
struct Tracked {
  double magnitude = 0, error = 0;
  bool is_coordinate = false;

  Tracked() = default;
  Tracked(double m, double e) : magnitude(m), error(e) {}
  explicit Tracked(double) : is_coordinate(true) {}

  static Tracked rounded(double m, double e) { return {m, e + m * rounding}; }

  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    return a.is_coordinate && b.is_coordinate ? Tracked(1, rounding) : a + b;
  }
  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return rounded(a.magnitude + b.magnitude, a.error + b.error);
  }
  friend Tracked operator-(const Tracked& a) { return a; }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    return rounded(a.magnitude * b.magnitude, a.magnitude * b.error + b.magnitude * a.error + a.error * b.error);
  }
};

/// A floating-point format with few bits of significand: results are rounded to nearest. Its least normal number is
/// 2^least; what is smaller is flushed to zero, as a result and as an operand.
template <int bits, int least = -1000>
struct Toy {
  double x = 0;

  Toy() = default;
  explicit Toy(double exact) : x(flushed(round(exact))) {}

  /// Veltkamp's splitting: the leading bits of the sum x·(2^k + 1) − x·2^k.
  static double round(double exact) {
    constexpr double factor = static_cast<double>((std::int64_t{1} << (53 - bits)) + 1);
    const double scaled = exact * factor;
    return scaled - (scaled - exact);
  }

  static double flushed(double x) { return std::fabs(x) < std::ldexp(1.0, least) ? 0 : x; }

  friend bool operator>=(const Toy& a, const Toy& b) { return a.x >= b.x; }
  friend Toy operator-(const Toy& a, const Toy& b) { return Toy(a.x - b.x); }
  friend Toy operator+(const Toy& a, const Toy& b) { return Toy(a.x + b.x); }
  friend Toy operator*(const Toy& a, const Toy& b) { return Toy(a.x * b.x); }
  friend Toy operator-(const Toy& a) { return Toy(-a.x); }
  friend bool operator<(const Toy& a, const Toy& b) { return a.x < b.x; }
  friend bool operator>(const Toy& a, const Toy& b) { return a.x > b.x; }
  friend bool operator<(const Toy& a, double b) { return a.x < b; }
};

struct Outcome {
  std::uint64_t certain = 0, undecided = 0, wrong = 0;

  void add(const std::optional<Sign>& sign, Sign exact) {
    sign ? ++certain : ++undecided;
    wrong += sign && *sign != exact;
  }
  template <class N>
  void add(const std::optional<Sign>& sign, const N& exact) {
    add(sign, sign_of(exact));
  }
};

}  // namespace tribunal
