#include "exact/plugin/host.h"

#include <cstring>
#include <memory>
#include <tuple>

#include "exact/base/fp_environment.h"
#include "exact/base/shown.h"
#include "exact/plugin/calls.h"
#include "exact/plugin/description.h"
#include "exact/plugin/library.h"
#include "exact/plugin/mesh_calls.h"
#include "exact/plugin/without_exceptions.h"

namespace tribunal {
namespace {

// --- introductions ---------------------------------------------------------------------------------------------------

/// Copies a little more than the longest string allowed, and no further, since the string may lack its end.
std::optional<std::string> text_of(const char* s) {
  constexpr std::size_t longest = 128;
  if (s == nullptr) return std::nullopt;
  return std::string(s, strnlen(s, longest));
}

void add(Message& message, const std::optional<std::string>& text) {
  message.add(text.has_value()).add(text.value_or(""));
}

std::optional<std::string> take_optional(Reader& in) {
  const bool present = in.take<char>() != 0;
  std::string text = in.take_text();
  return present ? std::optional(std::move(text)) : std::nullopt;
}

Introduction introduction_of(const Library& library, const std::string& file) {
  Introduction introduction;
  introduction.plugin = in_this_version(*library.plugin, file);
  introduction.name = text_of(introduction.plugin.name);
  introduction.contract = text_of(introduction.plugin.contract);
  introduction.summary = text_of(introduction.plugin.summary);
  introduction.reference = text_of(introduction.plugin.reference);
  introduction.has_tree = library.meshes != nullptr;
  if (introduction.has_tree) introduction.meshes = in_this_version(*library.meshes, file);
  introduction.takes_polygons = library.polygons != nullptr;
  if (!introduction.takes_polygons) return introduction;
  require_version(library.polygons->abi, file);
  introduction.polygons = *library.polygons;
  return introduction;
}

/// The numbers of a description, and which functions exist.
auto promises_of(const tribunal_plugin& p) {
  return std::make_tuple(p.abi, p.format, p.convention, p.operands, p.boundary, p.ends, p.culling, p.bounds,
                         p.tells_contact, p.tells_t, p.tells_side, p.ask != nullptr, p.ask_batch != nullptr,
                         p.tell != nullptr, p.prepare != nullptr, p.ask_prepared != nullptr, p.ask_within != nullptr);
}

auto promises_of(const tribunal_polygon_plugin& p) { return std::make_tuple(p.abi, p.restrictions, p.ask != nullptr); }

auto promises_of(const tribunal_mesh_plugin& p) {
  return std::make_tuple(p.abi, p.tells_t, p.sorted, p.most_ulps, p.tells_normal, p.tells_side, p.normal_sense,
                         p.most_degrees, p.prepare != nullptr, p.closest != nullptr, p.closest_normal != nullptr,
                         p.any != nullptr, p.all != nullptr, p.inside != nullptr);
}

auto promises_of(const Introduction& i) {
  return std::make_tuple(i.name, i.contract, i.summary, i.reference, i.takes_polygons, i.has_tree,
                         promises_of(i.plugin), promises_of(i.polygons), promises_of(i.meshes));
}

Message message_of(const Introduction& introduction) {
  Message message;
  message.add(introduction.failed_with).add(introduction.failure).add(introduction.plugin);
  for (const auto& text : {introduction.name, introduction.contract, introduction.summary, introduction.reference})
    add(message, text);
  message.add(introduction.takes_polygons).add(introduction.polygons);
  return message.add(introduction.has_tree).add(introduction.meshes);
}

// --- questions, answered ---------------------------------------------------------------------------------------------

Message message_of(const Reply& reply) {
  Message message;
  message.add(reply.fault.kind).add(reply.fault.detail).add(reply.hit).add(reply.answers.size());
  message.add(reply.answers.data(), reply.answers.size());
  message.add(reply.hits.size()).add(reply.hits.data(), reply.hits.size());
  return message.add(reply.normals.size()).add(reply.normals.data(), reply.normals.size());
}

std::vector<int> answers_about_triangles(const PluginCalls& calls, Kind kind, Reader& in) {
  const int probe = in.take<int>();
  const auto n = in.take<std::size_t>();
  const std::vector<double> queries = in.take_many<double>(15 * n);
  std::vector<int> answers(in.complete() ? n : 0, -1);
  if (kind == Kind::batch) {
    calls.ask_batch(probe, answers.size(), queries.data(), answers.data());
  } else {
    calls.ask_each(probe, answers.size(), queries.data(), answers.data());
  }
  return answers;
}

std::vector<int> answer_and_more(const PluginCalls& calls, Reader& in, tribunal_hit& hit) {
  const int probe = in.take<int>();
  in.take<std::size_t>();  // one
  const std::vector<double> query = in.take_many<double>(15);
  return {in.complete() ? calls.tell(probe, query.data(), hit) : -1};
}

std::vector<int> answer_when_prepared(const PluginCalls& calls, Reader& in) {
  const int probe = in.take<int>();
  const std::vector<double> triangle = in.take_many<double>(9), coordinates = in.take_many<double>(6);
  return {in.complete() ? calls.prepare(triangle.data())->ask(probe, coordinates.data()) : -1};
}

std::vector<int> answer_within(const PluginCalls& calls, Reader& in) {
  const std::vector<double> query = in.take_many<double>(15), bounds = in.take_many<double>(2);
  return {in.complete() ? calls.ask_within(query.data(), bounds.data()) : -1};
}

std::vector<int> answers_about_polygon(const PluginCalls& calls, Reader& in) {
  const int probe = in.take<int>();
  const std::vector<double> coordinates = in.take_many<double>(6);
  const std::vector<std::size_t> ends = in.take_many<std::size_t>(in.take<std::size_t>());
  const std::vector<double> vertices = in.take_many<double>(ends.empty() ? 0 : 3 * ends.back());
  const tribunal_polygon polygon = {ends.size(), ends.data(), vertices.data()};
  return {calls.ask_polygon(probe, coordinates.data(), polygon)};
}

/// The plugin as a child holds it: its functions, and the mesh that was prepared last.
struct Hosted {
  std::shared_ptr<const PluginCalls> calls{};
  tribunal_mesh_plugin meshes{};
  std::shared_ptr<const MeshCalls> mesh{};
};

void prepare_mesh(Hosted& hosted, Reader& in) {
  const std::vector<double> vertices = in.take_many<double>(in.take<std::size_t>());
  const std::vector<std::size_t> corners = in.take_many<std::size_t>(in.take<std::size_t>());
  hosted.mesh = mesh_calls_here(hosted.meshes, vertices, corners);
}

void answer_about_mesh(const MeshCalls& mesh, Kind kind, Reader& in, Reply& reply) {
  const std::vector<double> rays = in.take_many<double>(in.take<std::size_t>());
  const std::size_t n = rays.size() / 6;
  if (kind == Kind::mesh_closest) {
    reply.hits.resize(n);
    reply.normals.resize(n);
    return mesh.closest(rays, reply.hits, reply.normals);
  }
  reply.answers.resize(n);
  if (kind == Kind::mesh_any) return mesh.any(rays, reply.answers);
  if (kind == Kind::mesh_inside) return mesh.inside(rays, reply.answers);
  std::vector<std::size_t> counts(n);
  reply.hits = mesh.all(rays, counts);
  for (std::size_t i = 0; i < n; ++i) reply.answers[i] = static_cast<int>(counts[i]);
}

std::vector<int> answers_about_query(const PluginCalls& calls, Kind kind, Reader& in, tribunal_hit& hit) {
  if (kind == Kind::polygon) return answers_about_polygon(calls, in);
  if (kind == Kind::tell) return answer_and_more(calls, in, hit);
  if (kind == Kind::within) return answer_within(calls, in);
  return kind == Kind::prepared ? answer_when_prepared(calls, in) : answers_about_triangles(calls, kind, in);
}

void answer(Hosted& hosted, Reader& in, Reply& reply) {
  const Kind kind = in.take<Kind>();
  if (kind == Kind::mesh) return prepare_mesh(hosted, in);
  if (kind > Kind::mesh) return answer_about_mesh(*hosted.mesh, kind, in, reply);
  reply.answers = answers_about_query(*hosted.calls, kind, in, reply.hit);
}

Reply reply_to(Hosted& hosted, std::vector<char> bytes) {
  Reader in(std::move(bytes));
  Reply reply;
  try {
    answer(hosted, in, reply);
  } catch (const CallFailed& failed) {
    reply.fault = failed.fault;
  }
  if (!has_exact_rounding()) reply.fault = {Status::changed_environment};
  return reply;
}

/// Answers until the socket is closed or a fault occurs: after a fault the plugin can no longer be trusted.
void serve(Hosted& hosted, int socket) {
  std::vector<char> bytes;
  while (receive_message(socket, bytes, no_deadline()) == Transfer::done) {
    const Reply reply = reply_to(hosted, std::move(bytes));
    if (send_message(socket, message_of(reply), no_deadline()) != Transfer::done || reply.fault) return;
    bytes.clear();
  }
}

}  // namespace

bool describes_the_same(const Introduction& a, const Introduction& b) { return promises_of(a) == promises_of(b); }

std::optional<Introduction> introduction_in(std::vector<char> bytes) {
  Reader in(std::move(bytes));
  Introduction introduction;
  introduction.failed_with = in.take<int>();
  introduction.failure = in.take_text();
  introduction.plugin = in.take<tribunal_plugin>();
  for (auto* const text : {&introduction.name, &introduction.contract, &introduction.summary, &introduction.reference})
    *text = take_optional(in);
  introduction.takes_polygons = in.take<char>() != 0;
  introduction.polygons = in.take<tribunal_polygon_plugin>();
  introduction.has_tree = in.take<char>() != 0;
  introduction.meshes = in.take<tribunal_mesh_plugin>();
  return in.complete() ? std::optional(introduction) : std::nullopt;
}

Message question(Kind kind, int probe, std::size_t n, const double* queries) {
  Message message;
  message.add(kind).add(probe).add(n);
  return message.add(queries, 15 * n);
}

Message question(int probe, const double* triangle, const double* coordinates) {
  Message message;
  return message.add(Kind::prepared).add(probe).add(triangle, 9).add(coordinates, 6);
}

Message question(int probe, const double* coordinates, const tribunal_polygon& polygon) {
  Message message;
  message.add(Kind::polygon).add(probe).add(coordinates, 6);
  message.add(polygon.rings).add(polygon.ends, polygon.rings);
  return message.add(polygon.vertices, 3 * polygon.ends[polygon.rings - 1]);
}

Message question_within(const double* query, const double* bounds) {
  Message message;
  return message.add(Kind::within).add(query, 15).add(bounds, 2);
}

Message question(std::span<const double> vertices, std::span<const std::size_t> corners) {
  Message message;
  message.add(Kind::mesh).add(vertices.size()).add(vertices.data(), vertices.size());
  return message.add(corners.size()).add(corners.data(), corners.size());
}

Message question(Kind kind, std::span<const double> rays) {
  Message message;
  return message.add(kind).add(rays.size()).add(rays.data(), rays.size());
}

std::optional<Reply> reply_in(std::vector<char> bytes) {
  Reader in(std::move(bytes));
  Reply reply;
  reply.fault.kind = in.take<Status>();
  reply.fault.detail = shown_shortly(in.take_text(), longest_what);
  reply.hit = in.take<tribunal_hit>();
  reply.answers = in.take_many<int>(in.take<std::size_t>());
  reply.hits = in.take_many<tribunal_mesh_hit>(in.take<std::size_t>());
  reply.normals = in.take_many<tribunal_mesh_normal>(in.take<std::size_t>());
  const bool known = reply.fault.kind == Status::ok || reply.fault.kind == Status::threw ||
                     reply.fault.kind == Status::gave_no_answer || reply.fault.kind == Status::changed_environment;
  return in.complete() && known ? std::optional(reply) : std::nullopt;
}

void host_plugin(const std::string& file, int socket) {
  Introduction introduction;
  Hosted hosted;
  try {
    require_exact_rounding();
    const Library library = open_library(file);
    introduction = introduction_of(library, file);
    hosted = {calls_here(introduction.plugin, library.polygons), introduction.meshes, {}};
  } catch (const Failure& failure) {
    introduction.failed_with = code(failure.exit());
    introduction.failure = failure.what();
  }
  if (send_message(socket, message_of(introduction), no_deadline()) == Transfer::done && hosted.calls != nullptr)
    serve(hosted, socket);
}

}  // namespace tribunal
