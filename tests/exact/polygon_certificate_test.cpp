// Certificates about polygons: what they say, and that they follow from their log.
#include "exact/cases/family_table.h"
#include "exact/certificate/verify.h"
#include "tests/exact/certificate_support.h"

namespace tribunal {
namespace {

using namespace testing_certificates;

const std::uint64_t cases_of_tiny = 6 * shape_count * place_count;

TEST_F(CertificateTest, OfPolygonsSpeaksOfConstructionsAndOutcomes) {
  const Certificate c = write_polygons("sf-filtered", 6);
  EXPECT_EQ(c.verdict, Verdict::not_refuted);
  EXPECT_EQ(c.operands(), Operands::polygons);
  ASSERT_EQ(c.proved.size(), 5U);
  EXPECT_TRUE(c.proved[2].of_rays);
  EXPECT_EQ(c.proved[3].count.asked, 2'250'360U);
  EXPECT_EQ(c.proved[4].count.asked, 663'264U);
  EXPECT_EQ(c.proved[0].count.asked, 217'140U);
  EXPECT_EQ(c.proved[1].count.asked, 1'658'442U);
  EXPECT_EQ(c.proved[1].count.wrong, 0U);
  for (const Format format : {Format::binary64, Format::binary32}) {
    for (const SlotGroup& group : slot_groups(Operands::polygons)) {
      EXPECT_EQ(c.coverage.judged(format, group), static_cast<int>(group.size)) << group.name;
    }
    EXPECT_EQ(c.coverage.total(format, Operands::polygons).asked,
              families_of(Operands::polygons).size() * cases_of_tiny);
  }
  for (const Gap& gap : c.gaps) EXPECT_TRUE(gap.explained) << gap.what << ": " << gap.reason;
  const Verification v = verify(directory_);
  EXPECT_TRUE(v.faults.empty());
  EXPECT_EQ(v.asked_again, 217'140U);
}

TEST_F(CertificateTest, OfPolygonsRefutesTheClassicalWayWithinItsContract) {
  const Certificate c = write_polygons("haines-double", 6);
  EXPECT_EQ(c.verdict, Verdict::refuted);
  EXPECT_EQ(c.proved[1].count.wrong, 0U) << "small integers";
  EXPECT_GT(c.proved[1].count.unsupported, 0U) << "the boundary";
  for (const Stratum& s : c.strata) {
    if (s.slot != slot_of(Truth{.contact = Contact::edge})) continue;
    EXPECT_EQ(s.count.judged(), 0U) << "the boundary is outside its contract";
  }
  ASSERT_GT(c.counterexamples, 0U);
  for (const Json& line : counterexamples()) EXPECT_TRUE(line.contains("rings"));
  EXPECT_EQ(verify(directory_).confirmed, c.counterexamples);
  EXPECT_TRUE(verify(directory_).faults.empty());
}

/// Planted: a polygon test that takes every hole edge for a miss, in the small scope and among the constructions.
TEST_F(CertificateTest, OfPolygonsFindsAPlantedBug) {
  CertifyPlan plan{
      .method = method("sf-rational"), .operands = Operands::polygons, .budget = {"tiny", 0, false, 3}, .threads = 2};
  plan.method.name = "planted";
  plan.method.polygon = [](const Polygon& polygon) -> PreparedPolygon {
    const PreparedPolygon right = method("sf-rational").polygon(polygon);
    const auto segment = [right, many = polygon.rings() > 1](const Segment& s) {
      Answer answer = right.segment(s);
      if (many && answer.contact == Contact::edge) answer.hit = false;
      return answer;
    };
    return {.segment = segment, .ray = right.ray};
  };
  const Certificate c = write(plan);
  EXPECT_EQ(c.verdict, Verdict::refuted);
  for (const Stratum& s : c.strata) {
    if (s.count.wrong == 0) continue;
    EXPECT_NE(slot_name(s.slot).find("edge"), std::string::npos) << slot_name(s.slot);
  }
  EXPECT_EQ(verify(directory_).not_asked, "the method is not known here");
}

/// Every changed digit is noticed, in the log and in the certificate, and so is a dropped stratum with the hash chain
/// computed anew.
TEST_F(CertificateTest, OfPolygonsIsHeldAgainstItsLog) {
  write_polygons("sf-epick", 6);
  expect_edits_noticed(14'983);
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] == "sample" && r["method"] == "sf-epick" && r["counts"].contains("dart / outer edge / to")) {
        r["counts"].erase("dart / outer edge / to");
        return;
      }
    }
    ADD_FAILURE() << "no such stratum";
  });
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::incomplete);
}

}  // namespace
}  // namespace tribunal
