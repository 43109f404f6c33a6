#include "exact/plugin/calls.h"

#include <cstdint>

#include "exact/plugin/without_exceptions.h"

namespace tribunal {
namespace {

/// A triangle that the plugin has prepared, which is released when this object ends.
class PreparedHere : public PreparedCalls {
 public:
  PreparedHere(const tribunal_plugin& plugin, const double* triangle) : ask_(plugin.ask_prepared) {
    void* const made = without_exceptions([&] { return plugin.prepare(triangle); });
    if (made == nullptr) throw CallFailed{{Status::gave_no_answer, "prepare returned NULL"}};
    prepared_ = std::shared_ptr<void>(made, [release = plugin.release](void* p) {
      if (release != nullptr) release(p);
    });
  }

  int ask(int probe, const double* coordinates) const override {
    return without_exceptions([&] { return ask_(prepared_.get(), probe, coordinates); });
  }

 private:
  tribunal_ask_prepared* ask_;
  std::shared_ptr<void> prepared_{};
};

class CallsHere final : public PluginCalls {
 public:
  CallsHere(const tribunal_plugin& plugin, tribunal_ask_polygon* polygon) : plugin_(plugin), ask_polygon_(polygon) {}

  int ask(int probe, const double* query) const override {
    return without_exceptions([&] { return plugin_.ask(probe, query); });
  }

  int ask_within(const double* query, const double* bounds) const override {
    return without_exceptions([&] { return plugin_.ask_within(query, bounds); });
  }

  int tell(int probe, const double* query, tribunal_hit& hit) const override {
    return without_exceptions([&] { return plugin_.tell(probe, query, &hit); });
  }

  std::shared_ptr<const PreparedCalls> prepare(const double* triangle) const override {
    return std::make_shared<const PreparedHere>(plugin_, triangle);
  }

  void ask_batch(int probe, std::size_t n, const double* queries, int* answers) const override {
    without_exceptions([&] { plugin_.ask_batch(probe, n, queries, answers); });
  }

  void ask_each(int probe, std::size_t n, const double* queries, int* answers) const override {
    for (std::size_t i = 0; i < n; ++i) answers[i] = ask(probe, queries + 15 * i);
  }

  int ask_polygon(int probe, const double* coordinates, const tribunal_polygon& polygon) const override {
    return without_exceptions([&] { return ask_polygon_(probe, coordinates, &polygon); });
  }

  bool isolated() const override { return false; }
  std::size_t largest_batch() const override { return SIZE_MAX; }

 private:
  tribunal_plugin plugin_;
  tribunal_ask_polygon* ask_polygon_;
};

}  // namespace

std::shared_ptr<const PluginCalls> calls_here(const tribunal_plugin& plugin, const tribunal_polygon_plugin* polygons) {
  const bool known = polygons != nullptr && polygons->abi >= 1 && polygons->abi <= TRIBUNAL_PLUGIN_ABI;
  return std::make_shared<CallsHere>(plugin, known ? polygons->ask : nullptr);
}

}  // namespace tribunal
