#include "exact/record/errors_json.h"

#include <cmath>

#include "exact/base/json.h"
#include "exact/record/sample_row.h"

namespace tribunal {
namespace {

constexpr const char* count_keys[] = {"equal", "zeros", "zeros_missed", "not_finite", "beyond"};
using CountMember = std::uint64_t Ulps::*;
constexpr CountMember count_members[] = {&Ulps::equal, &Ulps::zeros, &Ulps::zeros_missed, &Ulps::not_finite,
                                         &Ulps::beyond};

Json histogram_of(const Ulps& u) {
  std::size_t length = u.up_to.size();
  while (length > 0 && u.up_to[length - 1] == 0) --length;
  Json array = Json::array();
  for (std::size_t i = 0; i < length; ++i) array.push_back(u.up_to[i]);
  return array;
}

std::uint64_t number_or_0(const Json& object, std::string_view key, const Where& where) {
  return object.contains(key) ? number_of(object, key, where) : 0;
}

void read_histogram(Ulps& u, const Json& array, const Where& where) {
  if (!array.is_array() || array.size() > u.up_to.size()) where.fail("expected an array of counts");
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (!array[i].is_number_unsigned()) where.index(i).fail("expected a count");
    u.up_to[i] = array[i];
  }
}

/// The largest error lies in the last bin that counts one.
bool is_possible(const Ulps& u) {
  if (u.zeros_missed > u.zeros) return false;
  std::size_t last = u.up_to.size();
  while (last > 0 && u.up_to[last - 1] == 0) --last;
  if (last == 0) return u.most == 0;
  const double above = last == 1 ? 0 : std::ldexp(0.5, static_cast<int>(last) - 2);
  return u.most >= above && u.most > 0 &&
         (last == u.up_to.size() || u.most <= std::ldexp(0.5, static_cast<int>(last) - 1));
}

}  // namespace

Json from_ulps(const Ulps& u) {
  Json object = Json::object();
  for (std::size_t i = 0; i < std::size(count_keys); ++i) {
    if (u.*count_members[i] > 0) object[count_keys[i]] = u.*count_members[i];
  }
  if (u.measured() == 0) return object;
  object["up_to"] = histogram_of(u);
  object["most"] = u.most;
  object["most_at"] = u.most_at;
  return object;
}

Ulps to_ulps(const Json& object, const Where& where) {
  require_keys(object, {"equal", "zeros", "zeros_missed", "not_finite", "beyond", "up_to", "most", "most_at"}, where);
  Ulps u;
  for (std::size_t i = 0; i < std::size(count_keys); ++i) {
    u.*count_members[i] = number_or_0(object, count_keys[i], where);
  }
  if (object.contains("up_to")) {
    read_histogram(u, object["up_to"], where.key("up_to"));
    const Json& most = require(object, "most", where);
    if (!most.is_number()) where.key("most").fail("expected a number");
    u.most = most;
    u.most_at = number_of(object, "most_at", where);
  }
  if (!is_possible(u)) where.fail("errors that cannot be");
  return u;
}

Json from_errors(const HitErrors& e) {
  Json object = {{"hits", e.hits}};
  if (e.withheld > 0) object["withheld"] = e.withheld;
  if (e.t.all() > 0) object["t"] = from_ulps(e.t);
  if (e.weights.all() > 0) object["weights"] = from_ulps(e.weights);
  return object;
}

HitErrors to_errors(const Json& object, const Where& where) {
  HitErrors e{.hits = number_of(object, "hits", where), .withheld = number_or_0(object, "withheld", where)};
  if (object.contains("t")) e.t = to_ulps(object["t"], where.key("t"));
  if (object.contains("weights")) e.weights = to_ulps(object["weights"], where.key("weights"));
  if (e.withheld > e.hits || e.t.all() != e.hits - e.withheld || e.weights.all() > 2 * e.hits) {
    where.fail("more numbers, or fewer, than hits");
  }
  return e;
}

Json errors_record(const std::string& method, const std::string& family, Format format, const HitErrors& errors) {
  Json record = {{"record", "errors"}, {"method", method}, {"family", family}, {"fmt", name_of(format)}};
  record.update(from_errors(errors));
  return record;
}

}  // namespace tribunal
