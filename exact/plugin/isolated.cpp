#include "exact/plugin/isolated.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <utility>
#include <vector>

#include "exact/base/failure.h"
#include "exact/plugin/fork_server.h"
#include "exact/plugin/host.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

constexpr double seconds_to_load = 10;  ///< or the time limit, if that is longer

std::string signal_name(int signal) {
  constexpr std::pair<int, const char*> names[] = {
      {SIGSEGV, "SIGSEGV"}, {SIGABRT, "SIGABRT"}, {SIGFPE, "SIGFPE"},   {SIGILL, "SIGILL"},   {SIGBUS, "SIGBUS"},
      {SIGKILL, "SIGKILL"}, {SIGTRAP, "SIGTRAP"}, {SIGTERM, "SIGTERM"}, {SIGPIPE, "SIGPIPE"}, {SIGALRM, "SIGALRM"},
      {SIGSYS, "SIGSYS"},   {SIGXCPU, "SIGXCPU"}, {SIGHUP, "SIGHUP"},   {SIGINT, "SIGINT"}};
  for (const auto& [number, name] : names) {
    if (number == signal) return name;
  }
  return "signal " + std::to_string(signal);
}

std::string seconds_text(double seconds) {
  char text[40];
  std::snprintf(text, sizeof text, "after %g s", seconds);
  return text;
}

/// Asks a plugin in child processes.
class IsolatedCalls : public PluginCalls {
 public:
  IsolatedCalls(std::string file, double time_limit)
      : file_(std::move(file)), time_limit_(time_limit), server_([f = file_](int socket) { host_plugin(f, socket); }) {
    give_back(start());
  }

  const Introduction& introduction() const { return introduction_; }

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
    const Child child = take();
    std::vector<char> bytes;
    const Deadline deadline = after_seconds(time_limit_);
    Transfer state = send_message(child.socket, asked, deadline);
    if (state == Transfer::done) state = receive_message(child.socket, bytes, deadline);
    if (state != Transfer::done) throw CallFailed{fault_of_end(child, state)};
    const std::optional<Reply> reply = reply_in(std::move(bytes));
    const bool good = reply && (reply->fault || reply->answers.size() == n);
    if (good && !reply->fault) {
      give_back(child);
      return *reply;
    }
    server_.end(child, true);
    throw CallFailed{good ? reply->fault : garbled()};
  }

  static Fault garbled() { return {Status::gave_no_answer, "wrote to our socket"}; }

  /// The fault of a child that did not answer, by how it ended.
  Fault fault_of_end(const Child& child, Transfer state) const {
    const int status = server_.end(child, state != Transfer::closed);
    if (state == Transfer::garbled) return garbled();
    if (WIFEXITED(status)) return {Status::exited, "status " + std::to_string(WEXITSTATUS(status))};
    const int signal = WTERMSIG(status);
    if (state == Transfer::late && signal == SIGKILL) return {Status::timed_out, seconds_text(time_limit_)};
    return {Status::crashed, signal_name(signal)};
  }

  /// A child that has loaded the library.
  Child start() const {
    const Child child = server_.start();
    std::vector<char> bytes;
    const Transfer state = receive_message(child.socket, bytes, after_seconds(std::max(time_limit_, seconds_to_load)));
    if (state != Transfer::done) {
      throw bad_input(file_, 0, describe(fault_of_end(child, state)) + " as it was loaded");
    }
    const auto received = introduction_in(std::move(bytes));
    if (received && received->failed_with == 0) {
      const std::scoped_lock lock(guard_);
      introduction_ = *received;
      return child;
    }
    server_.end(child, true);
    if (!received) throw bad_input(file_, 0, describe(garbled()) + " as it was loaded");
    throw Failure(static_cast<Exit>(received->failed_with), received->failure);
  }

  Child take() const {
    {
      const std::scoped_lock lock(guard_);
      if (!idle_.empty()) {
        const Child child = idle_.back();
        idle_.pop_back();
        return child;
      }
    }
    return start();
  }

  void give_back(const Child& child) const {
    const std::scoped_lock lock(guard_);
    idle_.push_back(child);
  }

  std::string file_;
  double time_limit_;
  mutable ForkServer server_;
  mutable std::mutex guard_;
  mutable std::vector<Child> idle_;
  mutable Introduction introduction_{};
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

const char* text(const std::optional<std::string>& s) { return s ? s->c_str() : nullptr; }

/// The plugin's description with the strings that the child sent. The functions are the child's and are never called.
tribunal_plugin description_in(const Introduction& received) {
  tribunal_plugin plugin = received.plugin;
  plugin.name = text(received.name);
  plugin.contract = text(received.contract);
  plugin.summary = text(received.summary);
  plugin.reference = text(received.reference);
  return plugin;
}

}  // namespace

Method isolated_method(const std::string& file, double time_limit) {
  const auto calls = std::make_shared<IsolatedCalls>(file, time_limit);
  const Introduction received = calls->introduction();
  const tribunal_plugin plugin = description_in(received);
  return plugin_method(plugin, file, received.takes_polygons ? &received.polygons : nullptr, calls);
}

}  // namespace tribunal
