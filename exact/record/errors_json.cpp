#include "exact/record/errors_json.h"

#include <cmath>

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

void read_histogram(Ulps& u, const Record& array) {
  const std::vector<Record> counts = array.items();
  if (counts.size() > u.up_to.size()) array.fail("expected at most " + std::to_string(u.up_to.size()) + " counts");
  for (std::size_t i = 0; i < counts.size(); ++i) u.up_to[i] = counts[i].count();
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

Ulps to_ulps(const Record& object) {
  object.keys({"equal", "zeros", "zeros_missed", "not_finite", "beyond", "up_to", "most", "most_at"});
  Ulps u;
  for (std::size_t i = 0; i < std::size(count_keys); ++i) u.*count_members[i] = object.count_or(count_keys[i], 0);
  if (const auto up_to = object.find("up_to")) {
    read_histogram(u, *up_to);
    u.most = object.number("most");
    u.most_at = object.count("most_at");
  }
  if (!is_possible(u)) object.fail("errors that cannot be");
  return u;
}

Json from_errors(const HitErrors& e) {
  Json object = {{"hits", e.hits}};
  if (e.withheld > 0) object["withheld"] = e.withheld;
  if (e.t.all() > 0) object["t"] = from_ulps(e.t);
  if (e.weights.all() > 0) object["weights"] = from_ulps(e.weights);
  return object;
}

HitErrors to_errors(const Record& object) {
  HitErrors e{.hits = object.count("hits"), .withheld = object.count_or("withheld", 0)};
  if (const auto t = object.find("t")) e.t = to_ulps(*t);
  if (const auto weights = object.find("weights")) e.weights = to_ulps(*weights);
  if (e.withheld > e.hits || e.t.all() != e.hits - e.withheld || e.weights.all() > 2 * e.hits) {
    object.fail("more numbers, or fewer, than hits");
  }
  return e;
}

Json errors_record(const std::string& method, const std::string& family, Format format, const HitErrors& errors) {
  Json record = {{"record", "errors"}, {"method", method}, {"family", family}, {"fmt", name_of(format)}};
  record.update(from_errors(errors));
  return record;
}

}  // namespace tribunal
