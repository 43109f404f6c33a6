#include "exact/plugin/native_loops.h"

#include <memory>
#include <vector>

namespace tribunal {
namespace {

/// Pairs as a plugin takes them, of segments or of rays, and its answers as it gives them.
struct Rows {
  std::vector<Coordinates> queries{};
  std::vector<int> answers{};

  Rows(std::span<const SegmentPair> pairs, Format format) : answers(pairs.size()) {
    for (const SegmentPair& p : pairs) queries.push_back(coordinates_of(p.segment, p.triangle, format));
  }

  void write(std::span<std::uint8_t> hits) const {
    for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = answers[i] == 1;
  }
};

NativeLoop one_by_one(tribunal_ask* ask, Format format, int kind) {
  return [ask, format, kind](std::span<const SegmentPair> pairs) -> NativeRun {
    return [ask, kind, rows = Rows(pairs, format)](std::span<std::uint8_t> hits, std::size_t step) {
      visit_by_steps(hits.size(), step, [&](std::size_t i) { hits[i] = ask(kind, rows.queries[i].data()) == 1; });
    };
  };
}

NativeLoop at_once(tribunal_ask_batch* ask, Format format, int kind) {
  return [ask, format, kind](std::span<const SegmentPair> pairs) -> NativeRun {
    const auto rows = std::make_shared<Rows>(pairs, format);
    return [ask, rows, kind](std::span<std::uint8_t> hits, std::size_t) {
      ask(kind, hits.size(), rows->queries[0].data(), rows->answers.data());
      rows->write(hits);
    };
  };
}

/// Triangles that the plugin prepares one by one; it alone knows how many bytes it keeps.
PreparedRun prepared_by(const PluginLine& line, std::span<const SegmentPair> pairs, int kind) {
  const auto rows = std::make_shared<Rows>(pairs, line.format);
  const auto prepared = std::make_shared<std::vector<std::shared_ptr<const PreparedCalls>>>(pairs.size());
  const auto set_up = [line, rows, prepared] {
    for (std::size_t i = 0; i < prepared->size(); ++i)
      (*prepared)[i] = line.calls->prepare(rows->queries[i].data() + 6);
  };
  set_up();
  return {.set_up = set_up, .ask = [rows, prepared, kind](std::span<std::uint8_t> hits, std::size_t step) {
            visit_by_steps(hits.size(), step,
                           [&](std::size_t i) { hits[i] = (*prepared)[i]->ask(kind, rows->queries[i].data()) == 1; });
          }};
}

}  // namespace

NativeLoops native_loops_of(const tribunal_plugin& plugin, const PluginLine& line, int kind) {
  NativeLoops native{.single = one_by_one(plugin.ask, line.format, kind)};
  if (plugin.ask_batch != nullptr) native.batch = at_once(plugin.ask_batch, line.format, kind);
  if (plugin.prepare == nullptr) return native;
  native.prepared = [line, kind](std::span<const SegmentPair> pairs) { return prepared_by(line, pairs, kind); };
  return native;
}

}  // namespace tribunal
