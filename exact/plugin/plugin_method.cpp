#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "exact/harness/fault.h"
#include "exact/harness/fp_environment.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/io/json.h"
#include "exact/kernels/dyadic.h"
#include "exact/oracles/polygon_oracles.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

constexpr std::size_t longest_name = 32, longest_text = 100;

// --- the description, checked -----------------------------------------------------------------------------------

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool fits_a_name(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-'; }

bool is_name(const std::string& s) {
  return !s.empty() && s.size() <= longest_name && is_letter(s[0]) && std::all_of(s.begin(), s.end(), fits_a_name);
}

/// Reports are made of these lines: no control characters, and UTF-8, which JSON insists on.
bool is_text(const std::string& s) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (s.empty() || s.size() > longest_text || std::any_of(s.begin(), s.end(), is_control)) return false;
  try {
    return !Json(s).dump().empty();
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

/// No more than a little beyond the longest text is read: the string may not end.
std::string string_from(const char* s, const char* what, const std::string& file) {
  if (s == nullptr) throw bad_input(file, 0, std::string(what) + " is NULL, expected a string");
  return std::string(s, strnlen(s, longest_text + 1));
}

std::string name_from(const char* s, const std::string& file) {
  const std::string name = string_from(s, "name", file);
  if (is_name(name)) return name;
  throw bad_input(file, 0,
                  "name is " + Json(name).dump(-1, ' ', true, Json::error_handler_t::replace) +
                      ", expected 1 to 32 of a-z A-Z 0-9 . _ -, a letter first");
}

std::string text_from(const char* s, const char* what, const std::string& file) {
  const std::string text = string_from(s, what, file);
  if (is_text(text)) return text;
  throw bad_input(file, 0,
                  std::string(what) + ": expected one line of UTF-8, 1 to " + std::to_string(longest_text) + " bytes");
}

Format format_from(int format, const std::string& file) {
  if (format == TRIBUNAL_BINARY32) return Format::binary32;
  if (format == TRIBUNAL_BINARY64) return Format::binary64;
  throw bad_input(file, 0, "format is " + std::to_string(format) + ", expected TRIBUNAL_BINARY32 or TRIBUNAL_BINARY64");
}

Convention convention_from(int convention, const std::string& file) {
  if (convention == TRIBUNAL_CLOSED) return Convention::closed;
  if (convention == TRIBUNAL_TRANSVERSAL) return Convention::transversal;
  throw bad_input(file, 0,
                  "convention is " + std::to_string(convention) + ", expected TRIBUNAL_CLOSED or TRIBUNAL_TRANSVERSAL");
}

/// Version 1 says in words which probes a test takes. Words that name none are taken to mean both.
Probes probes_in(const std::string& words) {
  const bool segments = words.find("segment") != std::string::npos, rays = words.find("ray") != std::string::npos;
  return segments || rays ? Probes{.segments = segments, .rays = rays} : Probes{};
}

void require_abi(int abi, const std::string& file) {
  if (abi == TRIBUNAL_PLUGIN_ABI) return;
  throw bad_input(file, 0,
                  "is made for version " + std::to_string(abi) + " of tribunal_plugin.h, expected " +
                      std::to_string(TRIBUNAL_PLUGIN_ABI));
}

void read_restrictions(Contract& contract, int restrictions, const std::string& file) {
  constexpr int all = TRIBUNAL_PLANAR_ONLY | TRIBUNAL_NO_BOUNDARY;
  if ((restrictions & ~all) != 0) {
    throw bad_input(file, 0,
                    "restrictions is " + std::to_string(restrictions) +
                        ", expected 0 or a sum of TRIBUNAL_PLANAR_ONLY and TRIBUNAL_NO_BOUNDARY");
  }
  contract.polygons = (restrictions & TRIBUNAL_PLANAR_ONLY) != 0 ? Polygons::planar : Polygons::any;
  contract.polygon_boundary = (restrictions & TRIBUNAL_NO_BOUNDARY) != 0 ? Boundary::unspecified : Boundary::closed;
}

// --- queries and answers across the interface ---------------------------------------------------------------------

using Coordinates = std::array<double, 15>;

constexpr int kind_of(const Segment&) { return TRIBUNAL_SEGMENT; }
constexpr int kind_of(const Ray&) { return TRIBUNAL_RAY; }
int kind_of(const Query& q) {
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
      : ask_(plugin.ask), ask_batch_(plugin.ask_batch), line_(std::move(line)) {}

  template <class P>
  Answer ask(const P& probe, const Triangle& t) const {
    if (ask_ == nullptr) return refusal(Status::unsupported);
    const Coordinates x = coordinates_of(probe, t, line_.format);
    if (!is_finite(x)) return refusal(Status::unsupported);
    const int said = call(probe, t, x);
    line_.require_same_environment();
    return line_.answer_from(said);
  }

  void ask_all(std::span<const Query> queries, std::span<Answer> answers) const {
    for (const int kind : {TRIBUNAL_SEGMENT, TRIBUNAL_RAY}) ask_kind(kind, queries, answers);
  }

 private:
  /// The plugin's answer. What it throws, against its promise, is a fault that names the case.
  template <class P>
  int call(const P& probe, const Triangle& t, const Coordinates& x) const {
    std::string what = "an exception of its own";
    try {
      return ask_(kind_of(probe), x.data());
    } catch (const std::exception& error) {
      what = error.what();
    } catch (...) {
    }
    const Case thrown{.id = "threw", .query = {probe, t}};
    throw MethodFault({FaultKind::threw, what}, line_.file + ": threw " + what + ", on " + from_case(thrown).dump());
  }

  /// One call for all queries whose probe is of the kind.
  void ask_kind(int kind, std::span<const Query> queries, std::span<Answer> answers) const {
    constexpr int not_answered = -1;
    std::vector<Coordinates> packed;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (kind_of(queries[i]) != kind) continue;
      const auto coordinates_here = [&](const auto& p) { return coordinates_of(p, queries[i].triangle, line_.format); };
      const Coordinates x = std::visit(coordinates_here, queries[i].probe);
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
  tribunal_ask_batch* ask_batch_;
  Line line_;
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
  PolygonAnswer ask(const P& probe) const {
    std::vector<double> x;
    add(x, source(probe));
    add(x, coordinates(target(probe)));
    if (!is_finite(x) || !is_finite(vertices_)) return {.answer = refusal(Status::unsupported)};
    const tribunal_polygon polygon = {ends_.size(), ends_.data(), vertices_.data()};
    const int said = ask_(kind_of(probe), x.data(), &polygon);
    line_.require_same_environment();
    return {line_.answer_from(said), planar_};
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
  require_abi(polygons.abi, line.file);
  if (polygons.ask == nullptr) throw bad_input(line.file, 0, "ask of polygons is NULL, expected a function");
  read_restrictions(method.contract, polygons.restrictions, line.file);
  method.polygon = [ask = polygons.ask, line](const Polygon& polygon) -> PreparedPolygon {
    const auto caller = std::make_shared<const PolygonCaller>(polygon, ask, line);
    return {.segment = [caller](const Segment& s) { return caller->ask(s); },
            .ray = [caller](const Ray& r) { return caller->ask(r); }};
  };
}

static_assert(sizeof(Coordinates) == 15 * sizeof(double), "a batch is a plain array of coordinates");

}  // namespace

Method plugin_method(const tribunal_plugin& plugin, const std::string& file, const tribunal_polygon_plugin* polygons) {
  require_abi(plugin.abi, file);
  const Format format = format_from(plugin.format, file);
  Method method{
      .name = name_from(plugin.name, file),
      .card = {.number = std::string(name_of(format)),
               .summary = text_from(plugin.summary, "summary", file),
               .reference = plugin.reference != nullptr ? text_from(plugin.reference, "reference", file) : "plugin"},
      .contract = {.probes = probes_in(text_from(plugin.contract, "contract", file)),
                   .triangles = plugin.ask != nullptr ? Triangles::any : Triangles::none,
                   .convention = convention_from(plugin.convention, file),
                   .format = format}};
  if (plugin.ask == nullptr && polygons == nullptr) throw bad_input(file, 0, "ask is NULL, expected a function");
  if (polygons != nullptr) add_polygons(method, *polygons, {format, file});
  const Caller caller(plugin, {format, file});
  method.segment = [caller](const Segment& s, const Triangle& t) { return caller.ask(s, t); };
  method.ray = [caller](const Ray& r, const Triangle& t) { return caller.ask(r, t); };
  if (plugin.ask != nullptr && plugin.ask_batch != nullptr) {
    method.batch = [caller](std::span<const Query> queries, std::span<Answer> answers) {
      caller.ask_all(queries, answers);
    };
  }
  return method;
}

}  // namespace tribunal
