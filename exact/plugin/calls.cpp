#include "exact/plugin/calls.h"

#include <cstdint>
#include <exception>
#include <string>

namespace tribunal {
namespace {

/// What the call returns. What it throws, against its promise, is a fault.
template <class Call>
auto without_exceptions(const Call& call) {
  std::string what = "an exception of its own";
  try {
    return call();
  } catch (const std::exception& error) {
    what = error.what();
  } catch (...) {
  }
  throw CallFailed{{Status::threw, what}};
}

class CallsHere : public PluginCalls {
 public:
  CallsHere(const tribunal_plugin& plugin, tribunal_ask_polygon* polygon)
      : ask_(plugin.ask), ask_batch_(plugin.ask_batch), ask_polygon_(polygon) {}

  int ask(int probe, const double* query) const override {
    return without_exceptions([&] { return ask_(probe, query); });
  }

  void ask_batch(int probe, std::size_t n, const double* queries, int* answers) const override {
    without_exceptions([&] { ask_batch_(probe, n, queries, answers); });
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
  tribunal_ask* ask_;
  tribunal_ask_batch* ask_batch_;
  tribunal_ask_polygon* ask_polygon_;
};

}  // namespace

std::shared_ptr<const PluginCalls> calls_here(const tribunal_plugin& plugin, const tribunal_polygon_plugin* polygons) {
  const bool takes_polygons = polygons != nullptr && polygons->abi == TRIBUNAL_PLUGIN_ABI;  // else only that is read
  return std::make_shared<CallsHere>(plugin, takes_polygons ? polygons->ask : nullptr);
}

}  // namespace tribunal
