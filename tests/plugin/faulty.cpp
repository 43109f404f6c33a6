// Plugins that do something other than answer on about one case in forty, for triangles and for polygons: compile with
// -DFAULT=name. To all other cases they answer BASE, by default unsupported, so that everything wrong is a fault.
#include <unistd.h>

#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "exact/plugin/tribunal_plugin.h"

namespace {

/// A number made of the bits of the first coordinates: the same for the same query.
unsigned mark_of(const double* x, int n) {
  std::uint64_t mixed = 0;
  for (int i = 0; i < n; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x[i], sizeof bits);
    mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15ULL;
    mixed ^= mixed >> 29;
  }
  return static_cast<unsigned>(mixed >> 33);
}

/// Commits the fault that FAULT names, in place of returning `answer`.
namespace fault {
[[maybe_unused]] int none(int answer) { return answer; }
[[maybe_unused]] int crash(int) {
  *static_cast<volatile int*>(nullptr) = 1;
  return 0;
}
[[maybe_unused]] int aborts(int) { std::abort(); }
[[maybe_unused]] int loops(int) {
  for (volatile unsigned i = 0;; i = i + 1) {
  }
}
[[maybe_unused]] int throws(int) { throw std::runtime_error("no memory left"); }
[[maybe_unused]] int throws_markup(int) {
  throw std::runtime_error("\x1b[31m\nFORGED\r\x9b\xff \u202e<script>alert(1)</script>|`[x](y)" +
                           std::string(10'000, 'w'));
}
[[maybe_unused]] int throws_number(int) { throw 7; }
[[maybe_unused]] int exits(int) { std::exit(0); }
[[maybe_unused]] int answers_seven(int) { return 7; }
[[maybe_unused]] int prints(int answer) {
  std::puts("garbage on standard output");
  std::fflush(stdout);
  return answer;
}
[[maybe_unused]] int is_unsteady(int answer) {
  static unsigned calls = 0;
  return ++calls % 3 == 0 ? 1 - answer : answer;
}
[[maybe_unused]] int rounds_up(int answer) {
  std::fesetround(FE_UPWARD);
  return answer;
}
[[maybe_unused]] int writes_everywhere(int answer) {
  const char garbage[64] = {};
  for (int i = 3; i < 64; ++i) {
    if (write(i, garbage, sizeof garbage) < 0) continue;
  }
  return answer;
}
}  // namespace fault

#ifndef BASE
#define BASE TRIBUNAL_UNSUPPORTED
#endif
#ifndef EVERY
#define EVERY 40
#endif

int after_fault(unsigned mark, int answer) { return mark % EVERY == 0 ? fault::FAULT(answer) : answer; }

extern "C" int ask(int probe, const double query[15]) {
  return after_fault(mark_of(query, 15) + static_cast<unsigned>(probe), BASE);
}

[[maybe_unused]] void ask_batch(int probe, std::size_t n, const double* queries, int* answers) {
  for (std::size_t i = 0; i < n; ++i) answers[i] = ask(probe, queries + 15 * i);
}

/// Crashes in batches of more than three queries, but on no single query.
[[maybe_unused]] void crashes_in_company(int probe, std::size_t n, const double* queries, int* answers) {
  if (n > 3) std::abort();
  ask_batch(probe, n, queries, answers);
}

int ask_polygon(int, const double coordinates[6], const tribunal_polygon* polygon) {
  return after_fault(mark_of(coordinates, 6) + static_cast<unsigned>(polygon->rings), BASE);
}

#ifndef BATCH
#define BATCH nullptr
#endif

const tribunal_plugin plugin = {TRIBUNAL_PLUGIN_ABI,  "faulty", "segment, ray; any triangle",
                                "fails now and then", nullptr,  TRIBUNAL_BINARY64,
                                TRIBUNAL_CLOSED,      ask,      BATCH};
#ifdef CHANGES
/// What a process that loads the library later finds changed: a file in the working directory says that one was before.
const tribunal_plugin* describe_anew() {
  static tribunal_plugin changed = plugin;
  if (std::FILE* const before = std::fopen("described", "r")) {
    std::fclose(before);
    changed.CHANGES = 1;
  } else if (std::FILE* const first = std::fopen("described", "w")) {
    std::fclose(first);
  }
  return &changed;
}
#endif

const tribunal_polygon_plugin polygons = {TRIBUNAL_PLUGIN_ABI, 0, ask_polygon};

#ifdef CRASHES_ON_LOAD
__attribute__((constructor)) void crash_on_load() { std::abort(); }
#endif

}  // namespace

#ifdef CHANGES
extern "C" const tribunal_plugin* tribunal_plugin_describe() { return describe_anew(); }
#else
extern "C" const tribunal_plugin* tribunal_plugin_describe() { return &plugin; }
#endif
extern "C" const tribunal_polygon_plugin* tribunal_plugin_describe_polygons() { return &polygons; }
