#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "exact/harness/fault.h"
#include "exact/harness/fp_environment.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/io/json.h"
#include "exact/io/polygon_case_io.h"
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

void require_abi(int abi, const std::string& file) {
  if (abi == TRIBUNAL_PLUGIN_ABI) return;
  throw bad_input(file, 0,
                  "is made for version " + std::to_string(abi) + " of tribunal_plugin.h, expected " +
                      std::to_string(TRIBUNAL_PLUGIN_ABI));
}

PolygonPromise promise_from(int restrictions, const std::string& file) {
  constexpr int all = TRIBUNAL_PLANAR_ONLY | TRIBUNAL_NO_BOUNDARY;
  if ((restrictions & ~all) != 0) {
    throw bad_input(file, 0,
                    "restrictions is " + std::to_string(restrictions) +
                        ", expected 0 or a sum of TRIBUNAL_PLANAR_ONLY and TRIBUNAL_NO_BOUNDARY");
  }
  return {.boundary = (restrictions & TRIBUNAL_NO_BOUNDARY) == 0,
          .surface = (restrictions & TRIBUNAL_PLANAR_ONLY) == 0};
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

/// What every call of a plugin needs.
struct Line {
  Format format;
  std::string file;
  std::shared_ptr<const PluginCalls> calls;
  std::shared_ptr<LastFaults> faults = std::make_shared<LastFaults>();

  /// `make_case` makes the case that was answered so, for messages.
  template <class MakeCase>
  Answer answer_from(int said, const MakeCase& make_case) const {
    if (said == TRIBUNAL_MISS) return miss();
    if (said == TRIBUNAL_HIT) return hit_at(Contact::unsaid);
    if (said == TRIBUNAL_UNSUPPORTED) return refusal(Status::unsupported);
    if (calls->isolated()) return answer_for({Status::gave_no_answer, std::to_string(said)}, make_case);
    throw bad_input(
        file, 0, "answered " + std::to_string(said) + ", expected TRIBUNAL_MISS, TRIBUNAL_HIT or TRIBUNAL_UNSUPPORTED");
  }

  /// A fault is an answer where the plugin is isolated; else it ends the command.
  template <class MakeCase>
  Answer answer_for(const Fault& fault, const MakeCase& make_case) const {
    if (!calls->isolated()) {
      auto c = make_case();
      c.id = fault_name(fault.kind);
      throw MethodFault(fault, file + ": " + describe(fault) + ", on " + from_case(c).dump());
    }
    faults->note(fault);
    return refusal(fault.kind);
  }

  /// The answer to one question: what `call` returns, or the fault that it fails with.
  template <class Call, class MakeCase>
  Answer ask(const Call& call, const MakeCase& make_case) const {
    int said = 0;
    try {
      said = call();
    } catch (const CallFailed& failed) {
      require_same_environment();
      return answer_for(failed.fault, make_case);
    }
    require_same_environment();
    return answer_from(said, make_case);
  }

  void require_same_environment() const {
    if (has_exact_rounding()) return;
    require_exact_rounding();  // for what remains to be done: CGAL aborts at exit if it finds another mode
    throw Failure(Exit::fp_environment, file + ": changed the rounding mode or flushes to zero");
  }
};

/// Queries of one kind, as a plugin takes them, and where their answers go.
struct Pack {
  int kind;
  std::vector<Coordinates> queries{};
  std::vector<std::size_t> places{};
};

/// One plugin's functions for triangles. Without them nothing is supported.
class Caller {
 public:
  Caller(bool takes_triangles, Line line) : takes_triangles_(takes_triangles), line_(std::move(line)) {}

  template <class P>
  Answer ask(const P& probe, const Triangle& t) const {
    if (!takes_triangles_) return refusal(Status::unsupported);
    const Coordinates x = coordinates_of(probe, t, line_.format);
    if (!is_finite(x)) return refusal(Status::unsupported);
    return line_.ask([&] { return line_.calls->ask(kind_of(probe), x.data()); },
                     [&] {
                       return Case{.query = {probe, t}};
                     });
  }

  /// How many queries are asked in one call.
  using Call = void (PluginCalls::*)(int, std::size_t, const double*, int*) const;

  void ask_all(Call call, std::span<const Query> queries, std::span<Answer> answers) const {
    for (const int kind : {TRIBUNAL_SEGMENT, TRIBUNAL_RAY}) {
      const Pack pack = packed(kind, queries, answers);
      const std::size_t n = pack.queries.size(), most = line_.calls->largest_batch();
      for (std::size_t first = 0; first < n;) {
        const std::size_t count = std::min(most, n - first);
        ask_some(call, pack, first, count, queries, answers);
        first += count;
      }
    }
  }

 private:
  static auto case_of(const Query& query) {
    return [&query] { return Case{.query = query}; };
  }

  Answer ask_alone(const Query& query) const {
    return std::visit([&](const auto& probe) { return ask(probe, query.triangle); }, query.probe);
  }

  /// The queries of the kind that may be asked; all others are unsupported.
  Pack packed(int kind, std::span<const Query> queries, std::span<Answer> answers) const {
    Pack pack{kind};
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (kind_of(queries[i]) != kind) continue;
      const auto coordinates_here = [&](const auto& p) { return coordinates_of(p, queries[i].triangle, line_.format); };
      const Coordinates x = std::visit(coordinates_here, queries[i].probe);
      answers[i] = refusal(Status::unsupported);
      if (!is_finite(x)) continue;
      pack.queries.push_back(x);
      pack.places.push_back(i);
    }
    return pack;
  }

  /// One call for queries first ≤ i < first + count of the pack. If it fails, they are asked one by one.
  void ask_some(Call call, const Pack& pack, std::size_t first, std::size_t count, std::span<const Query> queries,
                std::span<Answer> answers) const {
    constexpr int not_answered = -1;
    std::vector<int> said(count, not_answered);
    const auto query_at = [&](std::size_t i) -> const Query& { return queries[pack.places[first + i]]; };
    try {
      (*line_.calls.*call)(pack.kind, count, pack.queries[first].data(), said.data());
    } catch (CallFailed& failed) {
      line_.require_same_environment();
      bool any = false;
      for (std::size_t i = 0; i < count; ++i) {
        answers[pack.places[first + i]] = ask_alone(query_at(i));
        any |= is_fault(answers[pack.places[first + i]].status);
      }
      if (!any) answers[pack.places[first]] = line_.answer_for(of_batch(failed.fault, count), case_of(query_at(0)));
      return;
    }
    line_.require_same_environment();
    for (std::size_t i = 0; i < count; ++i) {
      answers[pack.places[first + i]] = line_.answer_from(said[i], case_of(query_at(i)));
    }
  }

  /// A fault that none of a batch's queries has alone: it is laid at the door of the first.
  static Fault of_batch(const Fault& fault, std::size_t count) {
    const std::string detail = fault.detail.empty() ? "" : fault.detail + ", ";
    return {fault.kind, detail + "in a batch of " + std::to_string(count) + ", on none of them alone"};
  }

  bool takes_triangles_;
  Line line_;
};

/// A polygon as its plugin sees it.
class PolygonCaller {
 public:
  PolygonCaller(const Polygon& polygon, Line line)
      : polygon_(polygon),
        ends_(polygon.ends.begin(), polygon.ends.end()),
        planar_(is_planar_by_normal<Dyadic>(polygon)),
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
    const auto call = [&] { return line_.calls->ask_polygon(kind_of(probe), x.data(), polygon); };
    return {line_.ask(call, [&] { return PolygonCase{.query = {probe, owned(polygon_)}}; }), planar_};
  }

 private:
  static PolygonData owned(const Polygon& polygon) {
    return {{polygon.vertices.begin(), polygon.vertices.end()}, {polygon.ends.begin(), polygon.ends.end()}};
  }

  void add(std::vector<double>& x, const Point3& point) const {
    for (int axis = 0; axis < 3; ++axis) x.push_back(in_format(point[axis], line_.format));
  }

  Polygon polygon_;  ///< a view, which outlives what it was prepared for
  std::vector<std::size_t> ends_;
  bool planar_;  ///< decided here: a plugin is asked for hits only
  std::vector<double> vertices_{};
  Line line_;
};

void add_polygons(Method& method, const tribunal_polygon_plugin& polygons, const Line& line) {
  require_abi(polygons.abi, line.file);
  if (polygons.ask == nullptr) throw bad_input(line.file, 0, "ask of polygons is NULL, expected a function");
  method.polygon_promise = promise_from(polygons.restrictions, line.file);
  method.polygon = [line](const Polygon& polygon) -> PreparedPolygon {
    const auto caller = std::make_shared<const PolygonCaller>(polygon, line);
    return {.segment = [caller](const Segment& s) { return caller->ask(s); },
            .ray = [caller](const Ray& r) { return caller->ask(r); }};
  };
}

static_assert(sizeof(Coordinates) == 15 * sizeof(double), "a batch is a plain array of coordinates");

}  // namespace

Method plugin_method(const tribunal_plugin& plugin, const std::string& file, const tribunal_polygon_plugin* polygons) {
  require_abi(plugin.abi, file);  // nothing else is read of another version
  return plugin_method(plugin, file, polygons, calls_here(plugin, polygons));
}

Method plugin_method(const tribunal_plugin& plugin, const std::string& file, const tribunal_polygon_plugin* polygons,
                     const std::shared_ptr<const PluginCalls>& calls) {
  require_abi(plugin.abi, file);
  const Format format = format_from(plugin.format, file);
  Method method{.name = name_from(plugin.name, file),
                .number = std::string(name_of(format)),
                .contract = text_from(plugin.contract, "contract", file),
                .summary = text_from(plugin.summary, "summary", file),
                .reference = plugin.reference != nullptr ? text_from(plugin.reference, "reference", file) : "plugin",
                .convention = convention_from(plugin.convention, file),
                .format = format,
                .segment = {},
                .ray = {},
                .classify = {},
                .compare_hits = {}};
  if (plugin.ask == nullptr && polygons == nullptr) throw bad_input(file, 0, "ask is NULL, expected a function");
  const Line line{format, file, calls};
  if (polygons != nullptr) add_polygons(method, *polygons, line);
  const Caller caller(plugin.ask != nullptr, line);
  method.segment = [caller](const Segment& s, const Triangle& t) { return caller.ask(s, t); };
  method.ray = [caller](const Ray& r, const Triangle& t) { return caller.ask(r, t); };
  const auto asking = [&caller](Caller::Call call) {
    return [caller, call](std::span<const Query> queries, std::span<Answer> answers) {
      caller.ask_all(call, queries, answers);
    };
  };
  if (plugin.ask != nullptr && plugin.ask_batch != nullptr) method.batch = asking(&PluginCalls::ask_batch);
  if (plugin.ask != nullptr && calls->isolated()) method.ask_each = asking(&PluginCalls::ask_each);
  if (calls->isolated()) method.last_fault = [faults = line.faults] { return faults->of_this_thread(); };
  return method;
}

}  // namespace tribunal
