#include <optional>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/kernels/dyadic.h"
#include "exact/oracles/polygon_oracles.h"
#include "exact/plugin/description.h"
#include "exact/plugin/line.h"
#include "exact/plugin/load.h"
#include "exact/plugin/native_loops.h"

namespace tribunal {

void PluginLine::require_same_environment() const {
  if (has_exact_rounding()) return;
  require_exact_rounding();  // for what remains to be done: CGAL aborts at exit if it finds another mode
  throw Failure(Exit::fp_environment,
                file + ": changed the rounding mode, precision or exceptions, or flushes to zero");
}

namespace {

/// Pairs with one kind of probe, in the form that a plugin takes, and where their answers go.
struct Pack {
  int kind;
  std::vector<Coordinates> pairs{};
  std::vector<std::size_t> places{};
};

/// One plugin's functions for triangles. Without them nothing is supported.
class Caller {
 public:
  Caller(const tribunal_plugin& plugin, PluginLine line)
      : asks_(plugin.ask != nullptr),
        tells_(plugin.tells_contact != 0 || plugin.tells_side != 0),
        line_(std::move(line)) {}

  template <class P>
  Answer ask(const P& probe, const Triangle& t) const {
    if (!asks_) return refusal(Status::unsupported);
    const Coordinates x = coordinates_of(probe, t, line_.format);
    if (!all_finite(x)) return refusal(Status::unsupported);
    if (tells_) return tell(probe, t, x).answer;
    const auto query = [&] { return Query{probe, t}; };
    return line_.ask([&] { return line_.answer_from(said(line_.calls->ask(kind_of(probe), x.data())), query); }, query);
  }

  Answer ask_within(const Ray& ray, const Bounds& given, const Triangle& t) const {
    const Coordinates x = coordinates_of(ray, t, line_.format);
    const double bounds[] = {in_format(given.tmin, line_.format), in_format(given.tmax, line_.format)};
    if (!all_finite(x) || std::isinf(bounds[0])) return refusal(Status::unsupported);
    const auto query = [&] { return Query{ray, t, given}; };
    return line_.ask([&] { return line_.answer_from(said(line_.calls->ask_within(x.data(), bounds)), query); }, query);
  }

  /// The parameter of the hit, if the plugin says it.
  std::optional<double> parameter(const Ray& ray, const Triangle& t) const {
    const Coordinates x = coordinates_of(ray, t, line_.format);
    if (!all_finite(x)) return std::nullopt;
    const auto [answer, hit] = tell(ray, t, x);
    return answer.hit && hit.has_t != 0 ? std::optional<double>(hit.t) : std::nullopt;
  }

  /// The same with the weights of b and c, if the plugin says them.
  std::optional<HitAt> hit(const Ray& ray, const Triangle& t) const {
    const Coordinates x = coordinates_of(ray, t, line_.format);
    if (!all_finite(x)) return std::nullopt;
    const auto [answer, hit] = tell(ray, t, x);
    if (!answer.hit || hit.has_t == 0) return std::nullopt;
    HitAt at{.t = hit.t};
    if (hit.has_weights != 0) at.weights = BarycentricWeights{hit.weight_b, hit.weight_c};
    return at;
  }

  using Call = void (PluginCalls::*)(int, std::size_t, const double*, int*) const;

  void ask_all(Call call, std::span<const TrianglePair> pairs, std::span<Answer> answers) const {
    for (const int kind : {TRIBUNAL_SEGMENT, TRIBUNAL_RAY}) {
      const Pack pack = packed(kind, pairs, answers);
      const std::size_t n = pack.pairs.size(), most = line_.calls->largest_batch();
      for (std::size_t first = 0; first < n;) {
        const std::size_t count = std::min(most, n - first);
        ask_some(call, pack, first, count, pairs, answers);
        first += count;
      }
    }
  }

 private:
  struct Reported {
    Answer answer;
    tribunal_hit hit;
  };

  int said(int number) const {
    line_.require_same_environment();
    return number;
  }

  template <class P>
  Reported tell(const P& probe, const Triangle& t, const Coordinates& x) const {
    tribunal_hit hit{};
    const auto query = [&] { return Query{probe, t}; };
    const auto ask = [&] {
      const int number = said(line_.calls->tell(kind_of(probe), x.data(), hit));
      return line_.answer_from(number, hit, query);
    };
    const Answer answer = line_.ask(ask, query);
    return {answer, hit};
  }

  Answer ask_alone(const TrianglePair& pair) const {
    return std::visit([&](const auto& probe) { return ask(probe, pair.triangle); }, pair.probe);
  }

  /// The pairs with this kind of probe that may be asked; the answers to its other pairs become unsupported.
  Pack packed(int kind, std::span<const TrianglePair> pairs, std::span<Answer> answers) const {
    Pack pack{kind};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (kind_of(pairs[i].probe) != kind) continue;
      const auto coordinates_here = [&](const auto& p) { return coordinates_of(p, pairs[i].triangle, line_.format); };
      const Coordinates x = std::visit(coordinates_here, pairs[i].probe);
      answers[i] = refusal(Status::unsupported);
      if (!all_finite(x)) continue;
      pack.pairs.push_back(x);
      pack.places.push_back(i);
    }
    return pack;
  }

  /// One call for pairs first ≤ i < first + count of the pack. If it fails, they are asked one by one.
  void ask_some(Call call, const Pack& pack, std::size_t first, std::size_t count, std::span<const TrianglePair> pairs,
                std::span<Answer> answers) const {
    constexpr int not_answered = -1;
    std::vector<int> numbers(count, not_answered);
    const auto place = [&](std::size_t i) { return pack.places[first + i]; };
    const auto query = [&](std::size_t i) { return as_query(pairs[place(i)]); };
    try {
      (*line_.calls.*call)(pack.kind, count, pack.pairs[first].data(), numbers.data());
    } catch (const CallFailed& failed) {
      line_.require_same_environment();
      bool any = false;
      for (std::size_t i = 0; i < count; ++i) {
        answers[place(i)] = ask_alone(pairs[place(i)]);
        any |= is_fault(answers[place(i)].status);
      }
      if (!any) answers[place(0)] = line_.answer_for(of_batch(failed.fault, count), [&] { return query(0); });
      return;
    }
    line_.require_same_environment();
    for (std::size_t i = 0; i < count; ++i) {
      answers[place(i)] = line_.answer_from(numbers[i], [&] { return query(i); });
    }
  }

  /// A fault of a batch of which each query alone has none; it is counted for the first query.
  static Fault of_batch(const Fault& fault, std::size_t count) {
    const std::string detail = fault.detail.empty() ? "" : fault.detail + ", ";
    return {fault.kind, detail + "in a batch of " + std::to_string(count) + ", on none of them alone"};
  }

  bool asks_, tells_;
  PluginLine line_;
};

/// A triangle that a plugin has prepared; it is released with the last copy of this object.
class PreparedCaller {
 public:
  PreparedCaller(const Triangle& t, PluginLine line) : t_(t), line_(std::move(line)) {
    std::vector<double> x;
    for (const Point3& v : {t.a, t.b, t.c}) add_coordinates(x, v, line_.format);
    if (!all_finite(x)) return;
    try {
      prepared_ = line_.calls->prepare(x.data());
    } catch (const CallFailed& failed) {
      failed_ = failed.fault;
    }
    line_.require_same_environment();
  }

  template <class P>
  Answer ask(const P& probe) const {
    const auto query = [&] { return Query{probe, t_}; };
    if (failed_) return line_.answer_for(failed_, query);
    std::vector<double> x;
    add_coordinates(x, source(probe), line_.format);
    add_coordinates(x, coordinates(target(probe)), line_.format);
    if (prepared_ == nullptr || !all_finite(x)) return refusal(Status::unsupported);
    const auto ask = [&] {
      const int number = prepared_->ask(kind_of(probe), x.data());
      line_.require_same_environment();
      return line_.answer_from(number, query);
    };
    return line_.ask(ask, query);
  }

 private:
  Triangle t_;
  PluginLine line_;
  Fault failed_{};
  std::shared_ptr<const PreparedCalls> prepared_{};  ///< null where the triangle is beyond the format
};

/// A polygon in the form that a plugin takes.
class PolygonCaller {
 public:
  PolygonCaller(const Polygon& polygon, PluginLine line)
      : polygon_(polygon),
        ends_(polygon.ends.begin(), polygon.ends.end()),
        planar_(is_planar_by_normal<Dyadic>(polygon)),
        line_(std::move(line)) {
    for (const Point3& v : polygon.vertices) add_coordinates(vertices_, v, line_.format);
  }

  template <class P>
  Answer ask(const P& probe) const {
    std::vector<double> x;
    add_coordinates(x, source(probe), line_.format);
    add_coordinates(x, coordinates(target(probe)), line_.format);
    if (!all_finite(x) || !all_finite(vertices_)) return refusal(Status::unsupported);
    const tribunal_polygon polygon = {ends_.size(), ends_.data(), vertices_.data()};
    const auto query = [&] { return Query{probe, owned(polygon_)}; };
    const auto ask = [&] {
      const int number = line_.calls->ask_polygon(kind_of(probe), x.data(), polygon);
      line_.require_same_environment();
      return line_.answer_from(number, query);
    };
    Answer answer = line_.ask(ask, query);
    answer.planar = planar_;
    return answer;
  }

 private:
  static PolygonData owned(const Polygon& polygon) {
    return {{polygon.vertices.begin(), polygon.vertices.end()}, {polygon.ends.begin(), polygon.ends.end()}};
  }

  Polygon polygon_;  ///< a view, which outlives what it was prepared for
  std::vector<std::size_t> ends_;
  bool planar_;  ///< decided here: a plugin is asked for hits only
  std::vector<double> vertices_{};
  PluginLine line_;
};

void add_polygons(Method& method, const tribunal_polygon_plugin& polygons, const PluginLine& line) {
  require_version(polygons.abi, line.file);
  if (polygons.ask == nullptr) throw bad_input(line.file, 0, "ask of polygons is NULL, expected a function");
  read_restrictions(method.contract, polygons, line.file);
  method.polygon = [line](const Polygon& polygon) -> PreparedPolygon {
    const auto caller = std::make_shared<const PolygonCaller>(polygon, line);
    return {.segment = [caller](const Segment& s) { return caller->ask(s); },
            .ray = [caller](const Ray& r) { return caller->ask(r); }};
  };
}

void add_batches(Method& method, const Caller& caller, const tribunal_plugin& plugin, bool isolated) {
  const auto asking = [&caller](Caller::Call call) {
    return [caller, call](std::span<const TrianglePair> pairs, std::span<Answer> answers) {
      caller.ask_all(call, pairs, answers);
    };
  };
  if (plugin.ask_batch != nullptr) method.batch = asking(&PluginCalls::ask_batch);
  // `ask_each`, like a batch, gets hit or miss and no contact.
  if (isolated && plugin.tells_contact == 0 && plugin.tells_side == 0) method.ask_each = asking(&PluginCalls::ask_each);
}

void add_triangles(Method& method, const tribunal_plugin& plugin, const PluginLine& line) {
  const Caller caller(plugin, line);
  method.segment = [caller](const Segment& s, const Triangle& t) { return caller.ask(s, t); };
  method.ray = [caller](const Ray& r, const Triangle& t) { return caller.ask(r, t); };
  if (plugin.ask == nullptr) return;
  if (plugin.ask_within != nullptr) {
    method.within = [caller](const Ray& r, const Bounds& b, const Triangle& t) { return caller.ask_within(r, b, t); };
  }
  add_batches(method, caller, plugin, line.calls->isolated());
  method.native = native_loops_of(plugin, line, TRIBUNAL_SEGMENT);
  method.native_rays = native_loops_of(plugin, line, TRIBUNAL_RAY);
  if (plugin.tells_t != 0) {
    method.parameter = [caller](const Ray& r, const Triangle& t) { return caller.parameter(r, t); };
  }
  if ((plugin.tells_t & TRIBUNAL_TELLS_WEIGHTS) != 0) {
    method.hit = [caller](const Ray& r, const Triangle& t) { return caller.hit(r, t); };
  }
  if (plugin.prepare == nullptr) return;
  method.prepare_triangle = [line](const Triangle& t) -> PreparedTriangle {
    const auto prepared = std::make_shared<const PreparedCaller>(t, line);
    return {.segment = [prepared](const Segment& s) { return prepared->ask(s); },
            .ray = [prepared](const Ray& r) { return prepared->ask(r); }};
  };
}

}  // namespace

Method plugin_method(const tribunal_plugin& given, const std::string& file, const tribunal_polygon_plugin* polygons) {
  const tribunal_plugin plugin = in_this_version(given, file);
  return plugin_method(plugin, file, polygons, calls_here(plugin, polygons));
}

Method plugin_method(const tribunal_plugin& plugin, const std::string& file, const tribunal_polygon_plugin* polygons,
                     const std::shared_ptr<const PluginCalls>& calls) {
  require_version(plugin.abi, file);
  Method method = described(plugin, file);
  if (plugin.ask == nullptr && polygons == nullptr) throw bad_input(file, 0, "ask is NULL, expected a function");
  const PluginLine line{method.contract.format, file, calls};
  if (polygons != nullptr) add_polygons(method, *polygons, line);
  add_triangles(method, plugin, line);
  if (calls->isolated()) method.last_fault = [faults = line.faults] { return faults->of_this_thread(); };
  return method;
}

}  // namespace tribunal
