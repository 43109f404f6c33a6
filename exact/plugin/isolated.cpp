#include "exact/plugin/isolated.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "exact/plugin/calls.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

/// Asks a plugin in child processes.
class IsolatedCalls : public PluginCalls {
 public:
  explicit IsolatedCalls(std::shared_ptr<const PluginChildren> children) : children_(std::move(children)) {}

  int ask(int probe, const double* query) const override {
    return reply_to(question(Kind::each, probe, 1, query), 1).answers[0];
  }

  int ask_within(const double* query, const double* bounds) const override {
    return reply_to(question_within(query, bounds), 1).answers[0];
  }

  int tell(int probe, const double* query, tribunal_hit& hit) const override {
    const Reply reply = reply_to(question(Kind::tell, probe, 1, query), 1);
    hit = reply.hit;
    return reply.answers[0];
  }

  /// Each query prepares the triangle anew, since it may go to another child.
  std::shared_ptr<const PreparedCalls> prepare(const double* triangle) const override;

  void ask_batch(int probe, std::size_t n, const double* queries, int* answers) const override {
    std::ranges::copy(reply_to(question(Kind::batch, probe, n, queries), n).answers, answers);
  }

  void ask_each(int probe, std::size_t n, const double* queries, int* answers) const override {
    std::ranges::copy(reply_to(question(Kind::each, probe, n, queries), n).answers, answers);
  }

  int ask_polygon(int probe, const double* coordinates, const tribunal_polygon& polygon) const override {
    return reply_to(question(probe, coordinates, polygon), 1).answers[0];
  }

  int ask_prepared(const double* triangle, int probe, const double* coordinates) const {
    return reply_to(question(probe, triangle, coordinates), 1).answers[0];
  }

  bool isolated() const override { return true; }

  /// So many that the cost of a message is small beside that of the answers, so few that they can be asked one by one
  /// after a fault.
  std::size_t largest_batch() const override { return 256; }

 private:
  Reply reply_to(const Message& asked, std::size_t n) const {
    const Child child = children_->take();
    const Reply reply =
        children_->ask(child, asked, children_->time_limit(), [n](const Reply& r) { return r.answers.size() == n; });
    children_->give_back(child);
    return reply;
  }

  std::shared_ptr<const PluginChildren> children_;
};

class PreparedElsewhere : public PreparedCalls {
 public:
  PreparedElsewhere(const IsolatedCalls& calls, const double* triangle)
      : calls_(calls), triangle_(triangle, triangle + 9) {}

  int ask(int probe, const double* coordinates) const override {
    return calls_.ask_prepared(triangle_.data(), probe, coordinates);
  }

 private:
  const IsolatedCalls& calls_;  ///< kept alive by the method
  std::vector<double> triangle_;
};

std::shared_ptr<const PreparedCalls> IsolatedCalls::prepare(const double* triangle) const {
  return std::make_shared<const PreparedElsewhere>(*this, triangle);
}

}  // namespace

Method isolated_method(const tribunal_plugin& plugin, const std::shared_ptr<const PluginChildren>& children) {
  const Introduction& received = children->introduction();
  const tribunal_polygon_plugin* const polygons = received.takes_polygons ? &received.polygons : nullptr;
  return plugin_method(plugin, children->file(), polygons, std::make_shared<IsolatedCalls>(children));
}

}  // namespace tribunal
