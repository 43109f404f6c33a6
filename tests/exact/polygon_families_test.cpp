// Polygon families: constructed cases are what they claim, all kinds are reached, exact methods are right on them.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "exact/cases/family_table.h"
#include "exact/cases/polygons/construction.h"
#include "exact/methods/methods.h"
#include "exact/trial/judge.h"
#include "exact/trial/slot.h"

namespace tribunal {
namespace {

constexpr Format formats[] = {Format::binary64, Format::binary32};

const Ray* ray_of(const Trial& trial) { return std::get_if<Ray>(&trial.query.probe); }

bool is_exact_in(const Trial& trial) {
  for (const Point3& v : trial.query.polygon().vertices) {
    if (!is_exact_in(v, trial.format)) return false;
  }
  if (const auto* s = std::get_if<Segment>(&trial.query.probe)) {
    return is_exact_in(s->p, trial.format) && is_exact_in(s->q, trial.format);
  }
  const Ray& r = std::get<Ray>(trial.query.probe);
  return is_exact_in(r.o, trial.format) && is_exact_in(r.d.v, trial.format);
}

/// Every case by every oracle and every exact method; the rivals are judged but may be wrong.
TEST(PolygonFamilies, ExactMethodsAreRight) {
  std::vector<const Method*> exact;
  for (const Method& m : all_methods()) {
    if (m.contract.exact && m.polygon) exact.push_back(&m);
  }
  ASSERT_GE(exact.size(), 3U);
  for (const Family& family : families_of(Operands::polygons)) {
    std::map<Contact, int> contacts;
    std::map<bool, int> planar;
    for (const Format format : formats) {
      for (std::uint64_t k = 0; k < 1'200; ++k) {
        const Trial trial = family.make(format, 7, k);
        ASSERT_TRUE(is_exact_in(trial)) << family.name << " " << k;
        ASSERT_LT(trial.level, family.levels(format).size());
        const Truth truth = truth_of(trial, k);
        ++contacts[truth.contact];
        ++planar[truth.planar];
        for (const Method* m : exact) {
          EXPECT_EQ(judge(*m, truth, m->ask(trial.query)), Outcome::right) << m->name << " " << family.name << " " << k;
        }
      }
    }
    std::string shares;
    for (const auto& [contact, n] : contacts) shares += std::string(name_of(contact)) + " " + std::to_string(n) + ", ";
    std::printf("  %-17s %splanar %d of 2400\n", std::string(family.name).c_str(), shares.c_str(), planar[true]);
    EXPECT_GT(contacts[Contact::none], 0) << family.name;
    EXPECT_GT(2'400 - contacts[Contact::none], 100) << family.name;
  }
}

/// One round over shapes × places × approaches leaves none out, whatever the level.
TEST(PolygonFamilies, AllKindsAreReached) {
  std::set<std::size_t> shapes;
  std::set<std::pair<PolygonPlace, Approach>> places;
  std::set<std::pair<std::size_t, PolygonPlace>> pairs;
  const Family& family = *find_family("polygon-affine");
  for (std::uint64_t k = 0; k < shape_count * place_count * 6U; ++k) {
    const Trial trial = family.make(Format::binary64, 1, k);
    ASSERT_TRUE(trial.construction);
    shapes.insert(trial.construction->shape);
    places.insert({trial.construction->place, trial.construction->approach});
    pairs.insert({trial.construction->shape, trial.construction->place});
  }
  EXPECT_EQ(shapes.size(), 22U);
  EXPECT_EQ(places.size(), 26U * 3U);
  EXPECT_EQ(pairs.size(), 258U) << "every place that a shape has";
}

/// Within six rounds of levels every construction comes up at every level by segments and by rays: none is tried at
/// easy levels only.
TEST(PolygonFamilies, EveryConstructionMeetsEveryLevelByBothProbes) {
  for (const Family& family : families_of(Operands::polygons)) {
    if (!family.constructs) continue;
    for (const Format format : formats) {
      const std::size_t levels = family.levels(format).size();
      std::set<std::pair<Slot, std::size_t>> met;
      for (std::uint64_t k = 0; k < 2 * approach_count * levels * shape_count * place_count; ++k) {
        const Trial trial = family.make(format, 1, k);
        met.insert({slot_of(*trial.construction, ray_of(trial) != nullptr), trial.level});
      }
      EXPECT_EQ(met.size(), 2 * all_constructions().size() * levels) << family.name << " " << name_of(format);
    }
  }
}

TEST(PolygonFamilies, TheirShapesHaveAllPlaces) {
  for (int i = 0; i < place_count; ++i) {
    std::size_t points = 0;
    for (const Shape& shape : all_shapes()) points += places_of(shape)[static_cast<std::size_t>(i)].size();
    EXPECT_GT(points, 0U) << name_of(static_cast<PolygonPlace>(i));
  }
}

/// Calibration: naive arithmetic must be wrong somewhere, or the families have no teeth.
TEST(PolygonFamilies, NaiveMethodsAreWrongSomewhere) {
  for (const char* name : {"sf-double", "haines-double", "feito-double", "sf-float", "haines-float", "feito-float"}) {
    const Method& m = *find_method(name);
    Count count;
    for (const Family& family : families_of(Operands::polygons)) {
      for (std::uint64_t k = 0; k < 1'000; ++k) {
        const Trial trial = family.make(m.contract.format, 3, k);
        count.add(judge(m, truth_of(trial, k), m.ask(trial.query)), Stage::none);
      }
    }
    std::printf("  %-14s wrong %llu of %llu judged\n", name, static_cast<unsigned long long>(count.wrong),
                static_cast<unsigned long long>(count.judged()));
    EXPECT_GT(count.wrong, 10U) << name;
    EXPECT_LT(count.wrong, count.judged() / 2) << name;
  }
}

}  // namespace
}  // namespace tribunal
