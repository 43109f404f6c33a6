// The formulations on integers of fixed width, by which methods that promise to be exact are judged.
#include "exact/trial/formulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "exact/base/failure.h"
#include "exact/cases/family_table.h"
#include "exact/methods/methods.h"
#include "exact/trial/formulations_on.h"
#include "exact/trial/fuzz.h"
#include "exact/trial/quick_truth.h"

namespace tribunal {
namespace {

mpz_class to_mpz(std::uint64_t w) {
  mpz_class z;
  mpz_set_ui(z.get_mpz_t(), w);
  return z;
}

template <int Bits>
mpz_class to_mpz(const BoundedInteger<Bits>& a) {
  constexpr std::size_t n = BoundedInteger<Bits>::words;
  const auto words = a.template in_words<n>();
  mpz_class z = 0;
  for (std::size_t i = n; i-- > 0;) z = (z << 64) + to_mpz(words[i]);
  if (static_cast<std::int64_t>(words[n - 1]) < 0) z -= mpz_class(1) << (64 * n);
  return z;
}

template <int Bits>
void expect_same(const BoundedInteger<Bits>& a, const mpz_class& exact) {
  ASSERT_EQ(to_mpz(a), exact) << Bits;
  ASSERT_EQ(sign_of(a), static_cast<Sign>(sgn(exact))) << Bits;
}

/// Numbers of up to `bits` bits, many at the ends of the range or next to a word's end.
std::vector<double> numbers(int bits) {
  std::vector<double> all = {0};
  for (const int e : {0, 1, 31, 32, 62, 63, 64, 65, bits - 54, bits - 53, bits - 1}) {
    if (e < 0 || e >= bits) continue;
    for (const double m : {1.0, 2 - std::ldexp(1.0, -std::min(e, 52)), 1 + std::ldexp(1.0, -std::min(e, 52))}) {
      all.push_back(std::ldexp(m, e));
      all.push_back(-std::ldexp(m, e));
    }
  }
  return all;
}

/// The operations of a volume: differences, their minors, and the sum of three products.
template <int Bits>
void compute_volumes() {
  using N = BoundedInteger<Bits>;
  const std::vector<double> x = numbers(Bits);
  for (const double a : x) {
    for (const double b : x) {
      const auto d = N(a) - N(b), s = N(a) + N(b);
      const mpz_class ed = mpz_class(a) - mpz_class(b), es = mpz_class(a) + mpz_class(b);
      expect_same(d, ed);
      expect_same(s, es);
      for (const double c : {x[1], x[2], x.back(), x[x.size() / 2]}) {
        const auto e = N(c) - N(a);
        const mpz_class ee = mpz_class(c) - mpz_class(a);
        expect_same(d * e - s * d, ed * ee - es * ed);
        expect_same(e * (d * e - s * d) + d * (s * s - d * d) + s * (e * e - s * d),
                    ee * (ed * ee - es * ed) + ed * (es * es - ed * ed) + es * (ee * ee - es * ed));
      }
    }
  }
}

TEST(BoundedInteger, ComputesVolumesAsGmpDoes) {
  compute_volumes<19>();
  compute_volumes<40>();
  compute_volumes<61>();
  compute_volumes<125>();
  compute_volumes<253>();
}

template <class N>
constexpr int width_on = 1000;
template <int Bits>
constexpr int width_on<BoundedInteger<Bits>> = Bits;

/// The width that a query takes; 1000 for GMP's numbers.
int width_of(const Query& query) {
  const auto width = []<class N>(const auto&, const Triangle&) { return width_on<N>; };
  return std::visit([&](const auto& p) { return with_exact_number(p, query.triangle(), width); }, query.probe);
}

TEST(Formulations, SayWhatTheOraclesSayOnAllFamilies) {
  std::map<std::pair<bool, int>, int> reached;
  for (const Stream& s : streams_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < 400; ++k) {
      const Query query = s.family->make(s.format, 11, k).query;
      ++reached[{is_of_ray(query), width_of(query)}];
      const Truth truth = truth_by_formulations(query), expected = exact_truth(query);
      ASSERT_EQ(truth.class_id, expected.class_id) << name_of(s) << " " << k;
      ASSERT_EQ(truth.contact, expected.contact) << name_of(s) << " " << k;
      ASSERT_EQ(truth.facing, expected.facing) << name_of(s) << " " << k;
    }
  }
  for (const bool ray : {false, true}) {
    for (const int width : {19, 40, 61, 125, 253, 1000}) EXPECT_GT((reached[{ray, width}]), 50) << ray << " " << width;
  }
}

/// Whole axes far from one, directions far from the points, zeros, and the widest numbers that a width holds.
TEST(Formulations, AScaledAxisOrDirectionChangesNoWidthAndNoAnswer) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Ray r{{1, 1, 3}, {{0, 0, -1}}};
  for (const double x : {1.0, 0x1p-1074, 0x1p900}) {
    for (const double z : {1.0, 0x1p-1070, 0x1p1000}) {
      for (const double d : {1.0, 0x1p-1074, 0x1p1023}) {
        const auto scaled = [&](const Point3& p) { return Point3(p.x * x, p.y, p.z * z); };
        const Query q{Ray{scaled(r.o), {r.d.v * d}}, Triangle{scaled(t.a), scaled(t.b), scaled(t.c)}};
        EXPECT_EQ(width_of(q), 19) << x << " " << z << " " << d;
        EXPECT_EQ(truth_by_formulations(q).class_id, exact_truth(q).class_id) << x << " " << z << " " << d;
      }
    }
  }
  const int widths[] = {19, 40, 61, 125, 253, 1000};
  for (int i = 0; i < 5; ++i) {
    for (const int bits : {widths[i], widths[i] + 1}) {
      const double top = std::ldexp(1.0, bits - 1);
      const Query q{Segment{{1, 1, 1}, {-top, 0, 1}}, Triangle{{0, 0, 0}, {top, 1, 0}, {0, top, 1}}};
      EXPECT_EQ(width_of(q), bits == widths[i] ? bits : widths[i + 1]) << bits;
      EXPECT_EQ(truth_by_formulations(q).class_id, exact_truth(q).class_id) << bits;
    }
  }
}

// --- planted faults -------------------------------------------------------------------------------------------------

/// Of products of so many words the highest is lost; of those of one word, the upper half.
std::size_t lossy_words = 0;

template <int Bits>
class Lossy {
 public:
  using Sound = BoundedInteger<Bits>;

  Lossy() = default;
  explicit Lossy(double x) : v_(x) {}
  explicit Lossy(const Sound& v) : v_(v) {}

  const Sound& sound() const { return v_; }
  friend Sign sign_of(const Lossy& a) { return sign_of(a.v_); }

  Lossy damaged() const {
    if (Sound::words != lossy_words) return *this;
    if constexpr (Sound::words == 1) {
      return Lossy(Sound(std::int64_t{static_cast<std::int32_t>(v_.value())}));
    } else if constexpr (Sound::words == 2) {
      return Lossy(Sound(typename Sound::Value{static_cast<std::int64_t>(v_.value())}));
    } else {
      typename Sound::Words w = v_.value();
      w[Sound::words - 1] = static_cast<std::int64_t>(w[Sound::words - 2]) < 0 ? ~std::uint64_t{0} : 0;
      return Lossy(Sound(w));
    }
  }

 private:
  Sound v_;
};

template <int A, int B>
auto operator+(const Lossy<A>& a, const Lossy<B>& b) {
  return Lossy(a.sound() + b.sound());
}

template <int A, int B>
auto operator-(const Lossy<A>& a, const Lossy<B>& b) {
  return Lossy(a.sound() - b.sound());
}

template <int A, int B>
auto operator*(const Lossy<A>& a, const Lossy<B>& b) {
  return Lossy(a.sound() * b.sound()).damaged();
}

Truth by_lossy_integers(const Query& query) { return truth_by_formulations_on<Lossy>(query); }

std::string contradiction_of(TruthBy formulations) {
  FuzzPlan plan{.methods = {flagship_method()}, .streams = streams_of(Operands::triangles), .cases = 40'000};
  plan.formulations = formulations;
  try {
    fuzz(plan);
  } catch (const Failure& f) {
    EXPECT_EQ(f.exit(), Exit::oracles_contradict);
    return f.what();
  }
  return "";
}

TEST(Formulations, AFaultInAnyWidthStopsTheRun) {
  EXPECT_EQ(contradiction_of(by_lossy_integers), "") << "nothing is lost yet";
  for (const std::size_t words : {1, 2, 3, 4, 6, 8, 12}) {
    lossy_words = words;
    EXPECT_NE(contradiction_of(by_lossy_integers), "") << words;
  }
  lossy_words = 0;
}

/// A fault before the three formulations part, which then agree: the scaling loses a bit of one coordinate. Where the
/// class is not known by construction, only the drawn share shows it.
Truth one_bit_lost(const Query& query) {
  Query changed = query;
  if (auto* s = std::get_if<Segment>(&changed.probe)) s->p.x = std::nextafter(s->p.x, INFINITY);
  return truth_by_formulations(changed);
}

TEST(Formulations, TheDrawnShareFindsAFaultThatTheyShare) {
  const Family& near = *std::ranges::find(families_of(Operands::triangles), "near", &Family::name);
  FuzzPlan plan{.methods = {flagship_method()}, .streams = {{&near, Format::binary64}}, .cases = 200'000};
  plan.formulations = one_bit_lost;
  try {
    fuzz(plan);
    ADD_FAILURE() << "a faulty truth has gone unnoticed";
  } catch (const Failure& f) {
    EXPECT_NE(std::string(f.what()).find("on integers the class is"), std::string::npos) << f.what();
  }
}

TEST(Formulations, CasesFromElsewhereGetTheAnswerOfAllOracles) {
  std::uint64_t number = 0, audited = 0;
  for (const Stream& stream : streams_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < 40; ++k, ++number) {
      const Query query = stream.family->make(stream.format, 5, k).query;
      const Truth all = exact_truth(query), own = truth_of_own(query, number);
      const auto parts = [](const Truth& t) {
        return std::tuple(t.class_id, t.contact, t.of_ray, t.facing, t.at, t.bounded, t.at_origin);
      };
      EXPECT_EQ(parts(own), parts(all)) << name_of(stream) << ' ' << k;
      audited += is_audited(0, 0, number);
    }
  }
  EXPECT_GT(audited, 0U);
  const Query polygon = streams_of(Operands::polygons).front().family->make(Format::binary64, 5, 1).query;
  EXPECT_EQ(truth_of_own(polygon, 1).contact, exact_truth(polygon).contact);
}

}  // namespace
}  // namespace tribunal
