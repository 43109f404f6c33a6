#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "exact/harness/fault.h"
#include "exact/harness/fp_environment.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/kernels/dyadic.h"
#include "exact/oracles/polygon_oracles.h"
#include "exact/plugin/description.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

// --- queries and answers across the interface ---------------------------------------------------------------------

using Coordinates = std::array<double, 15>;

constexpr int kind_of(const Segment&) { return TRIBUNAL_SEGMENT; }
constexpr int kind_of(const Ray&) { return TRIBUNAL_RAY; }
int kind_of(const TrianglePair& q) {
  return std::visit([](const auto& probe) { return kind_of(probe); }, q.probe);
}

const Point3& coordinates(const Point3& p) { return p; }
const Point3& coordinates(const Direction& d) { return d.v; }

template <class P>
Coordinates coordinates_of(const P& probe, const Triangle& t, Format format) {
  Coordinates x;
  std::size_t i = 0;
  for (const Point3& point : {source(probe), coordinates(target(probe)), t.a, t.b, t.c}) {
    for (int axis = 0; axis < 3; ++axis) x[i++] = in_format(point[axis], format);
  }
  return x;
}

template <class X>
bool is_finite(const X& x) {
  return std::all_of(x.begin(), x.end(), [](double c) { return std::isfinite(c); });
}

/// What every call of a plugin needs.
struct Line {
  Format format;
  std::string file;

  Answer answer_from(int said) const {
    if (said == TRIBUNAL_MISS) return miss();
    if (said == TRIBUNAL_HIT) return hit_at(Contact::unsaid);
    if (said == TRIBUNAL_UNSUPPORTED) return refusal(Status::unsupported);
    throw bad_input(
        file, 0, "answered " + std::to_string(said) + ", expected TRIBUNAL_MISS, TRIBUNAL_HIT or TRIBUNAL_UNSUPPORTED");
  }

  /// The same of a hit of which more is told.
  Answer answer_from(int said, const tribunal_hit& hit) const {
    constexpr std::array contacts = {Contact::unsaid, Contact::interior, Contact::edge, Contact::vertex,
                                     Contact::coplanar};
    Answer answer = answer_from(said);
    if (!answer.hit) return answer;
    if (hit.contact < 0 || hit.contact >= static_cast<int>(contacts.size())) {
      throw bad_input(file, 0,
                      "told contact " + std::to_string(hit.contact) + ", expected one of TRIBUNAL_CONTACT_...");
    }
    answer.contact = contacts[static_cast<std::size_t>(hit.contact)];
    return answer;
  }

  /// What `ask` returns. What it throws, against the plugin's promise, is a fault that names the case.
  template <class P, class Ask>
  int call(const P& probe, const Triangle& t, const Ask& ask) const {
    std::string what = "an exception of its own";
    try {
      const int said = ask();
      require_same_environment();
      return said;
    } catch (const Failure&) {
      throw;
    } catch (const std::exception& error) {
      what = error.what();
    } catch (...) {
    }
    const Case thrown{.id = "threw", .query = {probe, t}};
    throw MethodFault({FaultKind::threw, what}, file + ": threw " + what + ", on " + from_case(thrown).dump());
  }

  void require_same_environment() const {
    if (has_exact_rounding()) return;
    require_exact_rounding();  // for what remains to be done: CGAL aborts at exit if it finds another mode
    throw Failure(Exit::fp_environment, file + ": changed the rounding mode or flushes to zero");
  }
};

/// One plugin's functions for triangles. Without them nothing is supported.
class Caller {
 public:
  Caller(const tribunal_plugin& plugin, Line line)
      : ask_(plugin.ask),
        tell_(plugin.tell),
        ask_batch_(plugin.ask_batch),
        tells_contact_(plugin.tells_contact != 0),
        line_(std::move(line)) {}

  template <class P>
  Answer ask(const P& probe, const Triangle& t) const {
    if (ask_ == nullptr) return refusal(Status::unsupported);
    const Coordinates x = coordinates_of(probe, t, line_.format);
    if (!is_finite(x)) return refusal(Status::unsupported);
    if (tells_contact_) return tell(probe, t, x).answer;
    return line_.answer_from(line_.call(probe, t, [&] { return ask_(kind_of(probe), x.data()); }));
  }

  /// The parameter of the hit, if it is told.
  std::optional<double> parameter(const Ray& ray, const Triangle& t) const {
    const Coordinates x = coordinates_of(ray, t, line_.format);
    if (!is_finite(x)) return std::nullopt;
    const auto [answer, hit] = tell(ray, t, x);
    return answer.hit && hit.has_t != 0 ? std::optional<double>(hit.t) : std::nullopt;
  }

  void ask_all(std::span<const TrianglePair> pairs, std::span<Answer> answers) const {
    for (const int kind : {TRIBUNAL_SEGMENT, TRIBUNAL_RAY}) ask_kind(kind, pairs, answers);
  }

 private:
  struct Told {
    Answer answer;
    tribunal_hit hit;
  };

  template <class P>
  Told tell(const P& probe, const Triangle& t, const Coordinates& x) const {
    tribunal_hit hit{};
    const int said = line_.call(probe, t, [&] { return tell_(kind_of(probe), x.data(), &hit); });
    return {line_.answer_from(said, hit), hit};
  }

  /// One call for all pairs whose probe is of the kind.
  void ask_kind(int kind, std::span<const TrianglePair> pairs, std::span<Answer> answers) const {
    constexpr int not_answered = -1;
    std::vector<Coordinates> packed;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (kind_of(pairs[i]) != kind) continue;
      const auto coordinates_here = [&](const auto& p) { return coordinates_of(p, pairs[i].triangle, line_.format); };
      const Coordinates x = std::visit(coordinates_here, pairs[i].probe);
      answers[i] = refusal(Status::unsupported);
      if (!is_finite(x)) continue;
      packed.push_back(x);
      places.push_back(i);
    }
    if (packed.empty()) return;
    std::vector<int> said(packed.size(), not_answered);
    ask_batch_(kind, packed.size(), packed.front().data(), said.data());
    line_.require_same_environment();
    for (std::size_t i = 0; i < said.size(); ++i) answers[places[i]] = line_.answer_from(said[i]);
  }

  tribunal_ask* ask_;
  tribunal_tell* tell_;
  tribunal_ask_batch* ask_batch_;
  bool tells_contact_;
  Line line_;
};

/// A triangle that its plugin has prepared; released when the last who asks is gone.
class PreparedCaller {
 public:
  PreparedCaller(const tribunal_plugin& plugin, const Triangle& t, Line line)
      : t_(t), ask_(plugin.ask_prepared), line_(std::move(line)) {
    std::vector<double> x;
    for (const Point3& v : {t.a, t.b, t.c}) add(x, v);
    if (!is_finite(x)) return;
    void* const made = plugin.prepare(x.data());
    line_.require_same_environment();
    if (made == nullptr) throw Failure(Exit::resources, line_.file + ": prepare returned NULL");
    const auto release = plugin.release;
    prepared_ = std::shared_ptr<void>(made, [release](void* p) {
      if (release != nullptr) release(p);
    });
  }

  template <class P>
  Answer ask(const P& probe) const {
    std::vector<double> x;
    add(x, source(probe));
    add(x, coordinates(target(probe)));
    if (prepared_ == nullptr || !is_finite(x)) return refusal(Status::unsupported);
    return line_.answer_from(line_.call(probe, t_, [&] { return ask_(prepared_.get(), kind_of(probe), x.data()); }));
  }

 private:
  void add(std::vector<double>& x, const Point3& point) const {
    for (int axis = 0; axis < 3; ++axis) x.push_back(in_format(point[axis], line_.format));
  }

  Triangle t_;
  tribunal_ask_prepared* ask_;
  Line line_;
  std::shared_ptr<void> prepared_{};  ///< null where the triangle is beyond the format
};

/// A polygon as its plugin sees it.
class PolygonCaller {
 public:
  PolygonCaller(const Polygon& polygon, tribunal_ask_polygon* function, Line line)
      : ends_(polygon.ends.begin(), polygon.ends.end()),
        planar_(is_planar_by_normal<Dyadic>(polygon)),
        ask_(function),
        line_(std::move(line)) {
    for (const Point3& v : polygon.vertices) add(vertices_, v);
  }

  template <class P>
  Answer ask(const P& probe) const {
    std::vector<double> x;
    add(x, source(probe));
    add(x, coordinates(target(probe)));
    if (!is_finite(x) || !is_finite(vertices_)) return refusal(Status::unsupported);
    const tribunal_polygon polygon = {ends_.size(), ends_.data(), vertices_.data()};
    const int said = ask_(kind_of(probe), x.data(), &polygon);
    line_.require_same_environment();
    Answer answer = line_.answer_from(said);
    answer.planar = planar_;
    return answer;
  }

 private:
  void add(std::vector<double>& x, const Point3& point) const {
    for (int axis = 0; axis < 3; ++axis) x.push_back(in_format(point[axis], line_.format));
  }

  std::vector<std::size_t> ends_;
  bool planar_;  ///< decided here: a plugin is asked for hits only
  std::vector<double> vertices_{};
  tribunal_ask_polygon* ask_;
  Line line_;
};

void add_polygons(Method& method, const tribunal_polygon_plugin& polygons, const Line& line) {
  require_version(polygons.abi, line.file);
  if (polygons.ask == nullptr) throw bad_input(line.file, 0, "ask of polygons is NULL, expected a function");
  read_restrictions(method.contract, polygons, line.file);
  method.polygon = [ask = polygons.ask, line](const Polygon& polygon) -> PreparedPolygon {
    const auto caller = std::make_shared<const PolygonCaller>(polygon, ask, line);
    return {.segment = [caller](const Segment& s) { return caller->ask(s); },
            .ray = [caller](const Ray& r) { return caller->ask(r); }};
  };
}

void add_triangles(Method& method, const tribunal_plugin& plugin, const Line& line) {
  const Caller caller(plugin, line);
  method.segment = [caller](const Segment& s, const Triangle& t) { return caller.ask(s, t); };
  method.ray = [caller](const Ray& r, const Triangle& t) { return caller.ask(r, t); };
  if (plugin.ask == nullptr) return;
  if (plugin.ask_batch != nullptr) {
    method.batch = [caller](std::span<const TrianglePair> pairs, std::span<Answer> answers) {
      caller.ask_all(pairs, answers);
    };
  }
  if (plugin.tells_t != 0)
    method.parameter = [caller](const Ray& r, const Triangle& t) { return caller.parameter(r, t); };
  if (plugin.prepare != nullptr) {
    method.prepare_triangle = [plugin, line](const Triangle& t) -> PreparedTriangle {
      const auto prepared = std::make_shared<const PreparedCaller>(plugin, t, line);
      return {.segment = [prepared](const Segment& s) { return prepared->ask(s); },
              .ray = [prepared](const Ray& r) { return prepared->ask(r); }};
    };
  }
}

static_assert(sizeof(Coordinates) == 15 * sizeof(double), "a batch is a plain array of coordinates");

}  // namespace

Method plugin_method(const tribunal_plugin& given, const std::string& file, const tribunal_polygon_plugin* polygons) {
  const tribunal_plugin plugin = in_this_version(given, file);
  Method method = described(plugin, file);
  const Line line{method.contract.format, file};
  if (plugin.ask == nullptr && polygons == nullptr) throw bad_input(file, 0, "ask is NULL, expected a function");
  if (polygons != nullptr) add_polygons(method, *polygons, line);
  add_triangles(method, plugin, line);
  return method;
}

}  // namespace tribunal
