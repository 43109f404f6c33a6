// The calls of a plugin's functions, in this process or in another.
#pragma once

#include <memory>

#include "exact/base/fault.h"
#include "exact/plugin/tribunal_plugin.h"

namespace tribunal {

/// Thrown by a call that gave no answer.
struct CallFailed {
  Fault fault;
};

/// A triangle that a plugin has prepared. Fails as PluginCalls does.
class PreparedCalls {
 public:
  virtual ~PreparedCalls() = default;
  virtual int ask(int probe, const double* coordinates) const = 0;
};

/// The functions of one plugin, as tribunal_plugin.h has them. May be called from several threads at once. Every call
/// fails with CallFailed where the plugin does something else than return.
class PluginCalls {
 public:
  virtual ~PluginCalls() = default;

  virtual int ask(int probe, const double* query) const = 0;
  /// Answers one query after the other, as `ask` would.
  virtual void ask_each(int probe, std::size_t n, const double* queries, int* answers) const = 0;
  virtual void ask_batch(int probe, std::size_t n, const double* queries, int* answers) const = 0;
  virtual int ask_within(const double* query, const double* bounds) const = 0;
  virtual int tell(int probe, const double* query, tribunal_hit& hit) const = 0;
  virtual std::shared_ptr<const PreparedCalls> prepare(const double* triangle) const = 0;
  virtual int ask_polygon(int probe, const double* coordinates, const tribunal_polygon& polygon) const = 0;

  /// Whether the plugin runs in a process of its own, so that a fault does not end this one.
  virtual bool isolated() const = 0;
  /// The most queries that one call should have.
  virtual std::size_t largest_batch() const = 0;
};

/// Calls the loaded functions directly, in the caller's thread. The description must be in this version.
std::shared_ptr<const PluginCalls> calls_here(const tribunal_plugin& plugin, const tribunal_polygon_plugin* polygons);

}  // namespace tribunal
