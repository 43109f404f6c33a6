// The wrapping of a plugin: what crosses the interface, and that its batch form answers as its single calls do.
// tests/cli/plugin.sh loads real libraries and breaks every rule of the description.
#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>

#include "exact/families/family.h"
#include "exact/io/failure.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

std::atomic<int> batch_calls{0};

/// Depends on all that it is given, so that nothing can be dropped or swapped unseen.
int ask(int probe, const double x[15]) {
  double sum = probe == TRIBUNAL_RAY ? 1 : 2;
  for (int i = 0; i < 15; ++i) {
    EXPECT_TRUE(std::isfinite(x[i]));
    sum += (i + 1) * std::remainder(x[i], 64);
  }
  return sum > 40 ? TRIBUNAL_UNSUPPORTED : sum > 0 ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

void ask_batch(int probe, size_t n, const double* queries, int* answers) {
  ++batch_calls;
  for (size_t i = 0; i < n; ++i) answers[i] = ask(probe, queries + 15 * i);
}

tribunal_plugin sound_plugin() {
  return {.abi = TRIBUNAL_PLUGIN_ABI,
          .name = "in-process",
          .contract = "anything",
          .summary = "a checksum",
          .reference = nullptr,
          .format = TRIBUNAL_BINARY64,
          .convention = TRIBUNAL_CLOSED,
          .ask = ask,
          .ask_batch = ask_batch};
}

/// Segments of every family, every third as a ray.
std::vector<Query> some_queries(std::uint64_t each) {
  std::vector<Query> queries;
  for (const Family& family : families_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < each; ++k) {
      Query query = family.make(Format::binary64, 5, k).query;
      const Segment* s = std::get_if<Segment>(&query.probe);
      if (s != nullptr && k % 3 == 0) query.probe = Ray{s->p, {s->q}};
      queries.push_back(query);
    }
  }
  return queries;
}

std::vector<Answer> batch_answers(const Method& method, const std::vector<Query>& queries) {
  std::vector<Answer> answers(queries.size(), Answer{.contact = Contact::edge, .class_id = 99});
  std::vector<TrianglePair> pairs;
  for (const Query& query : queries) pairs.push_back(pair_of(query));
  method.batch(pairs, answers);
  return answers;
}

Exit exit_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Failure& failure) {
    EXPECT_TRUE(std::string(failure.what()).starts_with("x.so: answered")) << failure.what();
    return failure.exit();
  }
  return Exit::ok;
}

const Query through{Segment{{0.25, 0.25, 1}, {0.25, 0.25, -1}}, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

TEST(Plugin, BatchAnswersAsSingleCallsDo) {
  for (const int format : {TRIBUNAL_BINARY64, TRIBUNAL_BINARY32}) {
    tribunal_plugin plugin = sound_plugin();
    plugin.format = format;
    const Method method = plugin_method(plugin, "x.so");
    const std::vector<Query> queries = some_queries(60);
    batch_calls = 0;
    const std::vector<Answer> answers = batch_answers(method, queries);
    EXPECT_EQ(batch_calls, 2) << "one call for the segments, one for the rays";
    int hits = 0, unsupported = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(answers[i], method.ask(queries[i])) << i;
      hits += answers[i].hit;
      unsupported += answers[i].status == Status::unsupported;
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(unsupported, 100);
  }
}

TEST(Plugin, WithoutBatchFormHasNone) {
  tribunal_plugin plugin = sound_plugin();
  plugin.ask_batch = nullptr;
  EXPECT_FALSE(plugin_method(plugin, "x.so").batch);
}

int sees_binary32(int, const double x[15]) {
  for (int i = 0; i < 15; ++i) EXPECT_TRUE(is_exact_in(x[i], Format::binary32));
  return TRIBUNAL_HIT;
}

TEST(Plugin, Binary32SeesItsOwnFormatAndNoInfinity) {
  tribunal_plugin plugin = sound_plugin();
  plugin.format = TRIBUNAL_BINARY32;
  plugin.ask = sees_binary32;
  const Method method = plugin_method(plugin, "x.so");
  Query query = through;
  std::get<Segment>(query.probe).p.x = 0.1;
  EXPECT_TRUE(method.ask(query).hit);
  query.triangle().c.y = 0x1p+1000;
  EXPECT_EQ(method.ask(query).status, Status::unsupported);
}

TEST(Plugin, NonFiniteOperandsNeverReachIt) {
  const Method method = plugin_method(sound_plugin(), "x.so");
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Query query = through;
    query.triangle().b.z = x;
    EXPECT_EQ(method.ask(query).status, Status::nonfinite);
    query = through;
    std::get<Segment>(query.probe).q.x = x;
    EXPECT_EQ(method.ask(query).status, Status::nonfinite);
  }
}

TEST(Plugin, AnswersThatAreNoneAreRefused) {
  tribunal_plugin plugin = sound_plugin();
  plugin.ask = [](int, const double*) { return 3; };
  plugin.ask_batch = [](int, size_t, const double*, int*) {};  // leaves the answers as they were
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_EQ(exit_of([&] { method.ask(through); }), Exit::bad_input);
  EXPECT_EQ(exit_of([&] { batch_answers(method, {through}); }), Exit::bad_input);
}

TEST(Plugin, AnExceptionIsOneLineWithTheCase) {
  tribunal_plugin plugin = sound_plugin();
  plugin.ask = [](int, const double*) -> int { throw std::runtime_error("no memory"); };
  try {
    plugin_method(plugin, "x.so").ask(through);
    FAIL() << "nothing was thrown";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::disagreement);
    const std::string line = failure.what();
    EXPECT_TRUE(line.starts_with("x.so: threw no memory, on {")) << line;
    EXPECT_NE(line.find("\"tri\""), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(Plugin, ChangedRoundingIsNoticed) {
  tribunal_plugin plugin = sound_plugin();
  plugin.ask = [](int, const double*) { return std::fesetround(FE_DOWNWARD) + TRIBUNAL_HIT; };
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_THROW(method.ask(through), Failure);
  std::fesetround(FE_TONEAREST);
}

}  // namespace
}  // namespace tribunal
