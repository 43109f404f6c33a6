// The wrapping of a plugin: what crosses the interface, and that its batch form answers as its single calls do.
// tests/cli/plugin.sh loads real libraries and breaks every rule of the description.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <limits>

#include "exact/base/failure.h"
#include "exact/cases/family_table.h"
#include "exact/plugin/load.h"
#include "exact/trial/prepared.h"

namespace tribunal {
namespace {

std::atomic<int> batch_calls{0};

/// Its answer depends on every argument, so that no argument can be dropped or swapped unnoticed.
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
  tribunal_plugin plugin{};
  plugin.abi = TRIBUNAL_PLUGIN_ABI;
  plugin.name = "in-process";
  plugin.summary = "a checksum";
  plugin.format = TRIBUNAL_BINARY64;
  plugin.convention = TRIBUNAL_CLOSED;
  plugin.ask = ask;
  plugin.ask_batch = ask_batch;
  return plugin;
}

/// Segments of every family, every third as a ray.
std::vector<Query> some_queries(std::uint64_t each) {
  std::vector<Query> queries;
  for (const Family& family : families_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < each; ++k) {
      Query query = family.make(Format::binary64, 5, k).query;
      query.bounds.reset();
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

TEST(Plugin, VersionTwoSaysItsContractInTypes) {
  tribunal_plugin plugin = sound_plugin();
  EXPECT_EQ(plugin_method(plugin, "x.so").contract, Contract{}) << "zero is what version 1 meant";
  plugin.operands = TRIBUNAL_NO_SEGMENTS | TRIBUNAL_NO_DEGENERATE;
  plugin.format = TRIBUNAL_BINARY32;
  plugin.convention = TRIBUNAL_COPLANAR_UNSPECIFIED;
  plugin.boundary = TRIBUNAL_BOUNDARY_HALF_OPEN;
  plugin.ends = TRIBUNAL_ENDS_OPEN;
  plugin.culling = TRIBUNAL_CULLS_BACK_FACES;
  const Contract said{.probes = {.segments = false},
                      .triangles = Triangles::proper,
                      .convention = Convention::unspecified,
                      .boundary = Boundary::half_open,
                      .ends = Ends::open,
                      .culling = Culling::back_faces,
                      .format = Format::binary32};
  EXPECT_EQ(plugin_method(plugin, "x.so").contract, said);
  plugin.boundary = TRIBUNAL_BOUNDARY_OPEN;
  plugin.ends = TRIBUNAL_ENDS_UNSPECIFIED;
  EXPECT_EQ(plugin_method(plugin, "x.so").contract.boundary, Boundary::open);
  EXPECT_EQ(plugin_method(plugin, "x.so").contract.ends, Ends::unspecified);
  plugin.boundary = TRIBUNAL_BOUNDARY_UNSPECIFIED;
  plugin.operands = TRIBUNAL_NO_RAYS;
  EXPECT_EQ(plugin_method(plugin, "x.so").contract.boundary, Boundary::unspecified);
  EXPECT_FALSE(plugin_method(plugin, "x.so").contract.probes.rays);
}

/// Fields that version 1 did not have are not read: here they hold nonsense.
TEST(Plugin, VersionOneIsReadAsItWas) {
  tribunal_plugin plugin = sound_plugin();
  plugin.abi = 1;
  plugin.contract = "segment; any triangle";
  plugin.operands = plugin.boundary = plugin.ends = plugin.culling = 99;
  plugin.tells_t = 1;
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_EQ(method.contract, (Contract{.probes = {.rays = false}}));
  EXPECT_FALSE(method.parameter || method.prepare_triangle || method.tells_contact);
  plugin.contract = "anything";
  EXPECT_EQ(plugin_method(plugin, "x.so").contract, Contract{}) << "words that name no probe mean both";
}

/// So are those that version 2 did not have; and a ray with bounds goes to the function for it.
TEST(Plugin, VersionThreeTakesBounds) {
  tribunal_plugin plugin = sound_plugin();
  plugin.ask_within = [](const double x[15], const double bounds[2]) -> int {
    return x[0] == 1 && bounds[0] == 0.5 && bounds[1] == 2 ? TRIBUNAL_HIT : TRIBUNAL_MISS;
  };
  plugin.bounds = TRIBUNAL_ENDS_OPEN;
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_TRUE(method.contract.probes.bounds);
  EXPECT_EQ(method.contract.bounds, Ends::open);
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_TRUE(method.ask({Ray{{1, 1, 1}, {{0, 0, -1}}}, t, Bounds{0.5, 2}}).hit);
  EXPECT_FALSE(method.ask({Ray{{1, 1, 1}, {{0, 0, -1}}}, t, Bounds{0.5, 3}}).hit);
  plugin.abi = 2;
  EXPECT_EQ(plugin_method(plugin, "x.so").contract, Contract{});
  EXPECT_EQ(plugin_method(plugin, "x.so").ask({Ray{{1, 1, 1}, {{0, 0, -1}}}, t, Bounds{0.5, 2}}).status,
            Status::unsupported);
  plugin.abi = TRIBUNAL_PLUGIN_ABI;
  plugin.bounds = 7;
  EXPECT_THROW(plugin_method(plugin, "x.so"), Failure);
}

int tell_the_side(int, const double[15], tribunal_hit* hit) {
  hit->side = TRIBUNAL_SIDE_BACK;
  return TRIBUNAL_HIT;
}

TEST(Plugin, TellsTheSide) {
  tribunal_plugin plugin = sound_plugin();
  plugin.tells_side = 1;
  EXPECT_THROW(plugin_method(plugin, "x.so"), Failure) << "by no function";
  plugin.tell = tell_the_side;
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_TRUE(method.tells_side);
  EXPECT_EQ(method.ask(through).facing, Facing::back);
}

int tell(int probe, const double x[15], tribunal_hit* hit) {
  EXPECT_EQ(hit->contact, 0);
  EXPECT_EQ(hit->has_t, 0);
  hit->contact = TRIBUNAL_CONTACT_EDGE;
  hit->has_t = x[0] > 0;
  hit->t = x[0];
  return ask(probe, x);
}

TEST(Plugin, TellsContactAndParameter) {
  tribunal_plugin plugin = sound_plugin();
  plugin.tell = tell;
  EXPECT_FALSE(plugin_method(plugin, "x.so").parameter) << "it does not say that it tells t";
  plugin.tells_contact = plugin.tells_t = 1;
  const Method method = plugin_method(plugin, "x.so");
  EXPECT_TRUE(method.tells_contact);
  int hits = 0;
  for (const Query& query : some_queries(60)) {
    const Answer answer = method.ask(query), plain = plugin_method(sound_plugin(), "x.so").ask(query);
    ASSERT_EQ(answer.hit, plain.hit);
    ASSERT_EQ(answer.contact, answer.hit ? Contact::edge : Contact::none);
    const Ray* ray = std::get_if<Ray>(&query.probe);
    if (ray == nullptr) continue;
    const std::optional<double> t = answer.hit && ray->o.x > 0 ? std::optional<double>(ray->o.x) : std::nullopt;
    ASSERT_EQ(method.parameter(*ray, query.triangle()), t);
    hits += t.has_value();
  }
  EXPECT_GT(hits, 50);
  EXPECT_FALSE(method.hit) << "it does not say that it tells weights";
  plugin.tells_t = TRIBUNAL_TELLS_T + TRIBUNAL_TELLS_WEIGHTS;
  plugin.tell = [](int, const double*, tribunal_hit* hit) -> int {
    *hit = {.contact = TRIBUNAL_CONTACT_EDGE,
            .has_t = 1,
            .t = 3,
            .side = 0,
            .has_weights = 1,
            .weight_b = 0.25,
            .weight_c = 0.5};
    return TRIBUNAL_HIT;
  };
  const std::optional<HitAt> at = plugin_method(plugin, "x.so").hit({{0, 0, 1}, {{0, 0, -1}}}, through.triangle());
  ASSERT_TRUE(at && at->weights);
  EXPECT_EQ(at->t, 3);
  EXPECT_EQ(at->weights->b, 0.25);
  EXPECT_EQ(at->weights->c, 0.5);
  plugin.tell = [](int, const double*, tribunal_hit* hit) -> int { return hit->contact = 5, TRIBUNAL_HIT; };
  EXPECT_THROW(plugin_method(plugin, "x.so").ask(through), Failure);
}

std::atomic<int> prepared_now{0};

TEST(Plugin, PreparesTrianglesAndReleasesThem) {
  struct Nine {
    double x[9];
  };
  tribunal_plugin plugin = sound_plugin();
  plugin.prepare = [](const double* x) -> void* {
    ++prepared_now;
    auto* nine = new Nine;
    std::copy_n(x, 9, nine->x);
    return nine;
  };
  plugin.ask_prepared = [](const void* prepared, int probe, const double* x) {
    double all[15];
    std::copy_n(x, 6, all);
    std::copy_n(static_cast<const Nine*>(prepared)->x, 9, all + 6);
    return ask(probe, all);
  };
  plugin.release = [](void* prepared) {
    --prepared_now;
    delete static_cast<Nine*>(prepared);
  };
  const Method method = plugin_method(plugin, "x.so");
  for (const Query& query : some_queries(30)) EXPECT_NO_THROW(require_same_when_prepared(method, query));
  {
    const PreparedTriangle one = method.prepare_triangle(through.triangle());
    const auto segment = one.segment;
    EXPECT_EQ(prepared_now, 1);
  }
  EXPECT_EQ(prepared_now, 0);
  plugin.prepare = [](const double*) -> void* { return nullptr; };
  const PreparedTriangle failed = plugin_method(plugin, "x.so").prepare_triangle(through.triangle());
  EXPECT_THROW(failed.segment(std::get<Segment>(through.probe)), MethodFault);
}

}  // namespace
}  // namespace tribunal
