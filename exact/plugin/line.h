// What every call of a plugin shares: coordinates are passed to it, and answers and faults are made of what it returns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "core/method.h"
#include "exact/base/fault.h"
#include "exact/cases/case_line.h"
#include "exact/plugin/calls.h"

namespace tribunal {

/// p, q, a, b, c of a segment and a triangle, or o, d, a, b, c of a ray.
using Coordinates = std::array<double, 15>;
static_assert(sizeof(Coordinates) == 15 * sizeof(double), "a batch is a plain array of coordinates");

constexpr int kind_of(const Segment&) { return TRIBUNAL_SEGMENT; }
constexpr int kind_of(const Ray&) { return TRIBUNAL_RAY; }
inline int kind_of(const Probe& p) {
  return std::visit([](const auto& probe) { return kind_of(probe); }, p);
}

inline const Point3& coordinates(const Point3& p) { return p; }
inline const Point3& coordinates(const Direction& d) { return d.v; }

template <class P>
Coordinates coordinates_of(const P& probe, const Triangle& t, Format format) {
  Coordinates x;
  std::size_t i = 0;
  for (const Point3& point : {source(probe), coordinates(target(probe)), t.a, t.b, t.c}) {
    for (int axis = 0; axis < 3; ++axis) x[i++] = in_format(point[axis], format);
  }
  return x;
}

inline void add_coordinates(std::vector<double>& x, const Point3& point, Format format) {
  for (int axis = 0; axis < 3; ++axis) x.push_back(in_format(point[axis], format));
}

template <class X>
bool all_finite(const X& x) {
  return std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); });
}

/// The last fault of each thread, for `Method::last_fault`.
class LastFaults {
 public:
  void note(const Fault& fault) {
    const std::scoped_lock lock(guard_);
    of_thread_[std::this_thread::get_id()] = fault.detail;
  }
  std::string of_this_thread() {
    const std::scoped_lock lock(guard_);
    return of_thread_[std::this_thread::get_id()];
  }

 private:
  std::mutex guard_;
  std::map<std::thread::id, std::string> of_thread_;
};

/// Makes answers of the plugin's calls. Whatever a call does instead of answering is a fault: an answer with that
/// status where the plugin is isolated; else it ends the command with one line that contains the case.
struct PluginLine {
  Format format;
  std::string file;
  std::shared_ptr<const PluginCalls> calls;
  std::shared_ptr<LastFaults> faults = std::make_shared<LastFaults>();

  /// The answer that a number returned by the plugin stands for. `make_query` makes the query that was asked.
  template <class MakeQuery>
  Answer answer_from(int said, const MakeQuery& make_query) const {
    if (said == TRIBUNAL_MISS) return miss();
    if (said == TRIBUNAL_HIT) return hit_at(Contact::unsaid);
    if (said == TRIBUNAL_UNSUPPORTED) return refusal(Status::unsupported);
    return no_answer(
        std::to_string(said),
        "answered " + std::to_string(said) + ", expected TRIBUNAL_MISS, TRIBUNAL_HIT or TRIBUNAL_UNSUPPORTED",
        make_query);
  }

  /// The same for a plugin that also describes the hit.
  template <class MakeQuery>
  Answer answer_from(int said, const tribunal_hit& hit, const MakeQuery& make_query) const {
    constexpr std::array contacts = {Contact::unsaid, Contact::interior, Contact::edge, Contact::vertex,
                                     Contact::coplanar};
    Answer answer = answer_from(said, make_query);
    if (!answer.hit) return answer;
    if (hit.contact < 0 || hit.contact >= static_cast<int>(contacts.size())) {
      const std::string told = "told contact " + std::to_string(hit.contact);
      return no_answer(told, told + ", expected one of TRIBUNAL_CONTACT_...", make_query);
    }
    if (hit.side < TRIBUNAL_SIDE_UNSAID || hit.side > TRIBUNAL_SIDE_BACK) {
      const std::string told = "told side " + std::to_string(hit.side);
      return no_answer(told, told + ", expected one of TRIBUNAL_SIDE_...", make_query);
    }
    answer.contact = contacts[static_cast<std::size_t>(hit.contact)];
    answer.facing = static_cast<Facing>(hit.side);
    return answer;
  }

  template <class MakeQuery>
  Answer answer_for(const Fault& fault, const MakeQuery& make_query) const {
    if (calls->isolated()) {
      faults->note(fault);
      return refusal(fault.kind);
    }
    throw MethodFault(
        fault, file + ": " + describe(fault) + ", on " + case_line(std::string(fault_name(fault.kind)), make_query()));
  }

  /// The answer that `ask` makes of a call, or the fault that the call fails with.
  template <class Ask, class MakeQuery>
  Answer ask(const Ask& ask, const MakeQuery& make_query) const {
    try {
      return ask();
    } catch (const CallFailed& failed) {
      require_same_environment();
      return answer_for(failed.fault, make_query);
    }
  }

  void require_same_environment() const;

 private:
  template <class MakeQuery>
  Answer no_answer(const std::string& detail, const std::string& message, const MakeQuery& make_query) const {
    if (calls->isolated()) return answer_for({Status::gave_no_answer, detail}, make_query);
    throw bad_input(file, 0, message);
  }
};

}  // namespace tribunal
