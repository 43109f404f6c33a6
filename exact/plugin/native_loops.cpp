#include "exact/plugin/native_loops.h"

#include <memory>
#include <vector>

namespace tribunal {
namespace {

/// Pairs as a plugin takes them, and its answers as it gives them.
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

using Call = void (PluginCalls::*)(int, std::size_t, const double*, int*) const;

/// The plugin's own function, asked in a loop or once for all.
NativeLoop loop_of(const Line& line, Call call) {
  return [line, call](std::span<const SegmentPair> pairs) -> NativeRun {
    const auto rows = std::make_shared<Rows>(pairs, line.format);
    return [line, call, rows](std::span<std::uint8_t> hits) {
      (*line.calls.*call)(TRIBUNAL_SEGMENT, hits.size(), rows->queries[0].data(), rows->answers.data());
      rows->write(hits);
    };
  };
}

/// Triangles that the plugin prepares one by one; it alone knows how many bytes it keeps.
PreparedRun prepared_by(const Line& line, std::span<const SegmentPair> pairs) {
  const auto rows = std::make_shared<Rows>(pairs, line.format);
  const auto prepared = std::make_shared<std::vector<std::shared_ptr<const PreparedCalls>>>(pairs.size());
  const auto set_up = [line, rows, prepared] {
    for (std::size_t i = 0; i < prepared->size(); ++i)
      (*prepared)[i] = line.calls->prepare(rows->queries[i].data() + 6);
  };
  set_up();
  return {.set_up = set_up, .ask = [rows, prepared](std::span<std::uint8_t> hits) {
            for (std::size_t i = 0; i < hits.size(); ++i) {
              hits[i] = (*prepared)[i]->ask(TRIBUNAL_SEGMENT, rows->queries[i].data()) == 1;
            }
          }};
}

}  // namespace

NativeLoops native_loops_of(const tribunal_plugin& plugin, const Line& line) {
  NativeLoops native{.single = loop_of(line, &PluginCalls::ask_each)};
  if (plugin.ask_batch != nullptr) native.batch = loop_of(line, &PluginCalls::ask_batch);
  if (plugin.prepare == nullptr) return native;
  native.prepared = [line](std::span<const SegmentPair> pairs) { return prepared_by(line, pairs); };
  return native;
}

}  // namespace tribunal
