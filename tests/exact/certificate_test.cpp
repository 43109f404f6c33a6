// Certificates: what they say, that they follow from their log, and that a changed log is noticed.
#include <algorithm>
#include <cmath>

#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/verify.h"
#include "exact/plugin/load.h"
#include "exact/relations/relation.h"
#include "tests/exact/certificate_support.h"

namespace tribunal {
namespace {

using namespace testing_certificates;

TEST_F(CertificateTest, RefutesDoubleAndSaysWhy) {
  const Certificate c = write({.method = method("sf-double"), .budget = tiny, .threads = 2});
  EXPECT_EQ(c.verdict, Verdict::refuted);
  ASSERT_EQ(c.proved.size(), 4U);
  EXPECT_EQ(c.proved[2].size, 142'560U);
  EXPECT_TRUE(c.proved[2].of_rays);
  EXPECT_EQ(c.proved[3].size, 14'348'907U);
  EXPECT_EQ(c.proved[3].count.wrong, 0U);
  EXPECT_EQ(c.proved[0].size, 93'888U);
  EXPECT_EQ(c.proved[0].count.wrong, 0U);
  EXPECT_EQ(c.proved[1].size, 14'348'907U);
  EXPECT_EQ(c.proved[1].count.asked, 14'348'907U);
  EXPECT_EQ(c.proved[1].classes, 114U);
  EXPECT_EQ(c.coverage.classes(Format::binary32), 163);
  EXPECT_EQ(c.coverage.classes(Format::binary64), 163);
  EXPECT_GT(c.counterexamples, 50U);
  const Json json = to_json(c);
  for (const Json& row : json["sampled"]) {
    ASSERT_LE(row["k"].get<double>() / row["n"].get<double>(), row["upper_95"].get<double>());
    ASSERT_LE(row["upper_95"].get<double>(), row["upper_95_simultaneous"].get<double>());
  }
  for (const Gap& gap : c.gaps) EXPECT_TRUE(gap.explained) << gap.what;
  EXPECT_TRUE(verify(directory_).faults.empty());
  EXPECT_EQ(verify(directory_).confirmed, c.counterexamples);

  const std::string& set = c.proved[0].name;
  EXPECT_NE(to_summary(c).find("  proved   " + set + ": 0 wrong of 93888"), std::string::npos);
  Certificate wrong_in_set = c;
  wrong_in_set.proved[0].count.wrong = 896;
  EXPECT_NE(to_summary(wrong_in_set).find("  refuted  " + set + ": 896 wrong of 93888"), std::string::npos);
}

/// A failing case of the user's own refutes the method, and leaves the samples and their bounds unchanged.
TEST_F(CertificateTest, ACaseOfTheUsersOwnRefutesToo) {
  Case own;
  own.id = "mine";
  own.query = {Segment{{0.5, 0.25, 0}, {0.5, 0.25, 1}}, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  Method lazy = method("sf-rational");
  lazy.name = "lazy";
  lazy.segment = [](const Segment& s, const Triangle& t) {
    return s.q == Point3(0.5, 0.25, 1) ? miss() : find_method("sf-epick")->segment(s, t);
  };
  CertifyPlan plan{.method = lazy, .budget = tiny, .threads = 2};
  const Certificate without = write(plan);
  write_file(file("cases.jsonl"), from_case(own).dump() + "\n");
  const Rereadable cases(file("cases.jsonl"));
  plan.own = &cases;
  const Certificate c = write(plan);
  EXPECT_EQ(without.verdict, Verdict::not_refuted);
  EXPECT_EQ(c.verdict, Verdict::refuted);
  EXPECT_EQ(c.own().asked, 1U);
  EXPECT_EQ(c.own().wrong, 1U);
  EXPECT_EQ(c.sampled(), without.sampled());
  const Json with_own = to_json(c);
  EXPECT_EQ(with_own["sampled"], to_json(without)["sampled"]);
  EXPECT_FALSE(to_json(without).contains("own_cases"));
  ASSERT_EQ(with_own["own_cases"].size(), 1U);
  EXPECT_EQ(with_own["own_cases"][0]["n"], 1);
  EXPECT_EQ(with_own["own_cases"][0]["k"], 1);
  EXPECT_FALSE(with_own["own_cases"][0].contains("upper_95")) << "no bound follows from chosen cases";
  EXPECT_NE(to_markdown(c).find("- binary64: 1 wrong of 1 (100 %)"), std::string::npos);
  EXPECT_FALSE(verify(directory_).asked_again);
  EXPECT_EQ(verify(directory_).not_asked, "the method is not known here");
}

/// Changing any single digit of the counts of any record breaks the hash chain.
TEST_F(CertificateTest, ANumberEditedInTheLogIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  expect_edits_noticed(997);
}

/// A user's own cases are no sample: a certificate that rests on these alone is incomplete, unless it never had sets.
TEST_F(CertificateTest, ADroppedSampleMakesAHole) {
  Case own;
  own.id = "mine";
  own.query = {Segment{{0.5, 0.25, 0}, {0.5, 0.25, 1}}, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  write_file(file("cases.jsonl"), from_case(own).dump() + "\n");
  const Rereadable cases(file("cases.jsonl"));
  write({.method = method("sf-rational"), .budget = {"tiny", 1, false}, .threads = 2, .own = &cases});
  forge([](std::vector<Json>& records) {
    std::erase_if(records, [](const Json& r) { return r.contains("family") && r["family"] != own_cases; });
  });
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::incomplete);
}

/// Read again record by record, a log is what it is when it is held; one that changes meanwhile is refused.
TEST_F(CertificateTest, ALogIsReadAgainAsItStands) {
  const Certificate c = write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  ASSERT_GT(c.counterexamples, 10U);
  const LogRecords held = read_log(file("log.jsonl"));
  const Log log(file("log.jsonl"));
  EXPECT_EQ(log.head(), held.head);
  ASSERT_EQ(log.size(), held.size());
  EXPECT_EQ(log.others().size() + c.counterexamples, held.size());
  std::size_t i = 0;
  log.for_each([&](const Record& r) {
    EXPECT_EQ(r.json(), held.records[i]);
    EXPECT_EQ(r.where().line, held.lines[i++]);
  });
  EXPECT_EQ(i, held.size());
  forge([](std::vector<Json>& records) { records.pop_back(); });
  EXPECT_THROW(log.for_each([](const Record&) {}), Failure);
}

TEST_F(CertificateTest, ALogCutShortIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  const std::string log = read_file(file("log.jsonl"));
  write_file(file("log.jsonl"), log.substr(0, log.rfind('\n', log.size() - 2) + 1));
  EXPECT_THROW(read_log(file("log.jsonl")), Failure);
}

TEST_F(CertificateTest, ANumberEditedInTheCertificateIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  for (const char* name : {"certificate.json", "certificate.md", "counterexamples.jsonl"}) {
    const std::string text = read_file(file(name));
    std::string changed = text;
    changed[changed.find_first_of("12345678")] = '9';
    write_file(file(name), changed);
    EXPECT_EQ(verify(directory_).faults.size(), 1U) << name;
    write_file(file(name), text);
  }
  EXPECT_TRUE(verify(directory_).faults.empty());
}

/// Planted: a failing stratum is dropped and the hash chain computed anew. The counts of cases no longer add up.
TEST_F(CertificateTest, ADroppedStratumMakesAHole) {
  write({.method = method("sf-rational"), .budget = {"tiny", 1, false}, .threads = 2});
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] == "sample" && r["method"] == "sf-rational" && r["counts"].contains("C017")) {
        r["counts"].erase("C017");
        return;
      }
    }
  });
  const Certificate c = verify(directory_).certificate;
  EXPECT_EQ(c.verdict, Verdict::incomplete);
}

/// Planted: a merge of threads that loses counts.
TEST_F(CertificateTest, LostCountsMakeAHole) {
  write({.method = method("sf-rational"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::not_refuted);
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] != "sample" || r["method"] != "sf-rational") continue;
      for (auto& item : r["counts"].items()) {
        if (item.value()[0] > 1) {
          item.value()[0] = item.value()[0].get<std::uint64_t>() - 1;
          return;
        }
      }
    }
  });
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::incomplete);
}

/// Logs of older versions call the stage of integers "expansion". They are read, and their certificates keep the word.
TEST_F(CertificateTest, OlderLogsCallTheStageOfIntegersExpansion) {
  const Certificate c = write({.method = method("sf-filtered"), .budget = {"tiny", 1, false}, .threads = 2});
  const auto call_it = [&](const char* word) {
    forge([&](auto& all) { all.front()["stages"] = {"filter", word, "exact"}; });
  };
  ASSERT_EQ(c.plan, read_log(file("log.jsonl")).records.front());
  ASSERT_EQ(c.plan["stages"], Json({"filter", "integers", "exact"}));
  call_it("expansion");
  const Verification v = verify(directory_);
  EXPECT_TRUE(v.faults.empty());
  EXPECT_EQ(v.certificate.stages, c.stages);
  EXPECT_EQ(v.certificate.strata.front().count.at(Stage::integers), c.strata.front().count.at(Stage::integers));
  EXPECT_EQ(read_file(file("certificate.json")).find("from_integers"), std::string::npos);
  EXPECT_NE(read_file(file("certificate.json")).find("from_expansion"), std::string::npos);
  EXPECT_NE(read_file(file("certificate.md")).find(" expansion "), std::string::npos);
  EXPECT_THROW(call_it("guess"), Failure);
}

/// A log from which something that the budget owes was dropped or changed, with the chain made again, does not verify.
TEST_F(CertificateTest, WhatTheBudgetOwesCannotBeDropped) {
  write({.method = method("sf-epick"), .budget = {"tiny", 1, false}, .threads = 2});
  ASSERT_TRUE(verify(directory_).faults.empty());
  const std::string log = read_file(file("log.jsonl"));
  const auto is = [](const Json& r, const char* kind) { return r["record"] == kind; };
  const std::function<void(std::vector<Json>&)> changes[] = {
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return r.value("family", "") == "sliver"; }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return is(r, "set"); }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return is(r, "set") && r["probes"] == "ray"; }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return r.value("method", "") == "sf-float"; }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return is(r, "budget"); }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return is(r, "relation"); }); },
      [&](auto& all) { std::erase_if(all, [&](const Json& r) { return r.value("relation", "") == "scale"; }); },
      [&](auto& all) {
        for (Json& r : all) {
          if (is(r, "budget")) r["relation_cases"] = 1;
        }
      },
      [&](auto& all) {
        for (Json& r : all) {
          if (is(r, "plan")) r["seed"] = 2;
        }
      },
      [&](auto& all) {
        for (Json& r : all) {
          if (is(r, "plan") || is(r, "budget")) r["budget"] = "soak";
        }
      },
      [&](auto& all) {
        for (Json& r : all) {
          if (is(r, "stream") && r["family"] == "affine") r["population"] = "everything there is";
        }
      },
      [&](auto& all) {
        for (Json& r : all) {
          if (is(r, "budget")) r["cases_per_class"] = 1000;
        }
      }};
  for (const auto& change : changes) {
    write_file(file("log.jsonl"), log);
    forge(change);
    EXPECT_FALSE(verify(directory_).faults.empty()) << "change " << &change - changes;
  }
}

/// Invented counts that add up are found only by running the certificate again.
TEST_F(CertificateTest, ARerunTellsMadeUpCounts) {
  write({.method = method("sf-double"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_TRUE(verify(directory_, 2).faults.empty());
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] != "sample" || r["method"] != "sf-double") continue;
      for (auto& item : r["counts"].items()) {
        while (item.value().size() > 6) item.value().erase(item.value().size() - 1);
        if (item.value().size() > 1) item.value()[1] = 0;
      }
    }
    std::erase_if(records, [](const Json& r) { return r["record"] == "counterexample"; });
  });
  EXPECT_TRUE(verify(directory_).faults.empty());
  EXPECT_FALSE(verify(directory_, 2).faults.empty());
}

/// A test that takes rays for lines is refuted, also by the sets that are run whole; of a test without rays the
/// certificate says that it takes none.
TEST_F(CertificateTest, RaysAreOnTrial) {
  Method line = method("sf-rational");
  line.name = "ray as line";
  line.ray = [](const Ray& r, const Triangle& t) {
    const Answer forward = method("sf-rational").ray(r, t);
    return forward.hit ? forward : method("sf-rational").ray({r.o, {-r.d.v}}, t);
  };
  const Certificate c = write({.method = line, .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(c.verdict, Verdict::refuted);
  EXPECT_EQ(c.sampled(false).wrong, 0U);
  EXPECT_GT(c.sampled(true).wrong, 0U);
  EXPECT_EQ(c.proved[1].count.wrong, 0U);
  EXPECT_GT(c.proved[2].count.wrong, 0U);

  Method segments = method("sf-rational");
  segments.name = "segments only";
  segments.contract.probes.rays = false;
  segments.ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); };
  const Certificate without = write({.method = segments, .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(without.verdict, Verdict::not_refuted);
  EXPECT_NE(to_markdown(without).find("rays"), std::string::npos);
  segments.contract.probes.rays = true;
  const Certificate hole = write({.method = segments, .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(hole.verdict, Verdict::incomplete);
}

/// Planted: a method that refuses some cases. The certificate names what was refused.
TEST_F(CertificateTest, WhatIsRefusedIsNamed) {
  Method shy = method("sf-rational");
  shy.name = "shy";
  shy.segment = [](const Segment& s, const Triangle& t) {
    return s.p.x > s.q.x ? refusal(Status::unsupported) : method("sf-rational").segment(s, t);
  };
  const Certificate c = write({.method = shy, .budget = {"tiny", 4, false}, .threads = 2});
  EXPECT_TRUE(std::ranges::any_of(c.gaps, [](const Gap& g) {
    return g.what.find("affine binary64 C") != std::string::npos && g.what.find(" of 4") != std::string::npos;
  }));
}

/// Planted: an absolute epsilon on points, in a plugin. On the small integers of the sets that are run whole it is
/// right; the relation `scale` shows it, with a witness that follows from budget and seed, and a shrunk counterexample.
int with_absolute_epsilon(int probe, const double x[15]) {
  double v[15];
  for (int i = 0; i < 15; ++i) {
    const bool of_direction = probe == TRIBUNAL_RAY && i >= 3 && i < 6;
    v[i] = !of_direction && std::fabs(x[i]) < 1e-9 ? 0 : x[i];
  }
  const Triangle t{{v[6], v[7], v[8]}, {v[9], v[10], v[11]}, {v[12], v[13], v[14]}};
  const Point3 p(v[0], v[1], v[2]), q(v[3], v[4], v[5]);
  static const Method exact = method("sf-filtered");
  return (probe == TRIBUNAL_RAY ? exact.ray({p, {q}}, t) : exact.segment({p, q}, t)).hit ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

TEST_F(CertificateTest, RelationsShowAnAbsoluteEpsilon) {
  tribunal_plugin plugin{};
  plugin.abi = TRIBUNAL_PLUGIN_ABI;
  plugin.name = "epsilon";
  plugin.summary = "calls what is small zero";
  plugin.format = TRIBUNAL_BINARY64;
  plugin.ask = with_absolute_epsilon;
  const Certificate c =
      write({.method = plugin_method(plugin, "x.so"), .budget = {"tiny", 1, false, 1, 200}, .threads = 2});
  EXPECT_EQ(c.verdict, Verdict::refuted);
  for (const ProvedSet& s : c.proved) EXPECT_EQ(s.count.wrong, 0U) << s.name;
  const auto scale =
      std::ranges::find_if(c.relations, [](const RelationRow& r) { return r.name == "scale" && r.broken > 0; });
  ASSERT_NE(scale, c.relations.end());
  EXPECT_GT(scale->broken * 100, scale->asked) << "more than one in a hundred";
  EXPECT_EQ(scale->witness.size(), 2U);
  EXPECT_NE(c.worst().find("scale"), std::string::npos);
  EXPECT_NE(to_summary(c).find("  BROKEN   scale, "), std::string::npos);
  EXPECT_NE(to_markdown(c).find("## Relations"), std::string::npos);
  const std::vector<Json> found = counterexamples();
  EXPECT_TRUE(std::ranges::any_of(found, [](const Json& x) { return x.value("source", "") == "relation scale"; }));
  EXPECT_TRUE(verify(directory_).faults.empty());
  // The verdict rests on relations alone where nothing else is wrong.
  forge([](std::vector<Json>& all) {
    for (Json& r : all) {
      if (!r.contains("counts")) continue;
      for (auto& item : r["counts"].items()) {
        Json& n = item.value();
        n = {n[0], 0, n.size() > 2 ? n[2] : Json(0)};
      }
    }
    std::erase_if(all, [](const Json& r) { return r["record"] == "counterexample"; });
  });
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::refuted);
  // A witness of one's own making is noticed.
  forge([](std::vector<Json>& all) {
    for (Json& r : all) {
      if (r["record"] == "relation" && r["broken"] > 0) r["first"] = r["first"].get<std::uint64_t>() + 38;
    }
  });
  EXPECT_FALSE(verify(directory_).faults.empty());
}

TEST_F(CertificateTest, RelationsHoldForExactMethodsAndAreListed) {
  const Certificate c = write({.method = method("sf-epick"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(c.relations.size(), 4 * relations_of(Operands::triangles).size()) << "by format and kind of probe";
  EXPECT_TRUE(c.broken_relations().empty());
  std::uint64_t asked = 0;
  for (const RelationRow& r : c.relations) asked += r.asked;
  EXPECT_GT(asked, 10'000U);
  EXPECT_TRUE(verify(directory_, 2).faults.empty());
  forge([](std::vector<Json>& all) {
    for (Json& r : all) {
      if (r["record"] == "relation" && r["asked"] > 0) r["asked"] = r["asked"].get<std::uint64_t>() - 1;
    }
  });
  EXPECT_FALSE(verify(directory_, 2).faults.empty()) << "made-up counts are told by a rerun";
}

/// A log of version 2 has no relations and owes none.
TEST_F(CertificateTest, LogsWithoutRelationsStillVerify) {
  write({.method = method("sf-epick"), .budget = {"tiny", 1, false}, .threads = 2});
  forge([](std::vector<Json>& all) {
    for (Json& r : all) {
      if (r["record"] == "plan") r["version"] = 2;
      if (r["record"] == "budget") r.erase("relation_cases");
    }
    std::erase_if(all, [](const Json& r) { return r["record"] == "relation" || r["record"] == "errors"; });
  });
  const Verification v = verify(directory_);
  EXPECT_TRUE(v.faults.empty());
  EXPECT_EQ(v.certificate.verdict, Verdict::not_refuted);
  EXPECT_FALSE(to_json(v.certificate).contains("relations"));
}

/// A method that answers nothing has no certificate.
TEST_F(CertificateTest, NoAnswersAreAHole) {
  const Certificate c = write({.method = method("haines-double"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(c.sampled().judged(), 0U);
  EXPECT_EQ(c.verdict, Verdict::incomplete);
}

}  // namespace
}  // namespace tribunal
