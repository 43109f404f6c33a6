// The parts that records of several commands share.
#include "exact/report/shapes.h"

#include <utility>

#include "exact/record/errors_json.h"

namespace tribunal {
namespace shape {
namespace {

/// The sum of a group of counts; 0 if the row has none.
std::uint64_t sum_in(const Record& row, const char* group) {
  const auto found = row.find(group);
  return found ? sum_of(*found) : 0;
}

}  // namespace

void require_kinds(const Record& row, std::uint64_t wrong, std::uint64_t unsupported) {
  require_part(row, row.count_or("refused", 0), unsupported, "refused");
  require_part(row, sum_in(row, "outcomes"), wrong, "outcomes");
  require_part(row, sum_in(row, "severity"), wrong, "severity");
  const auto cause = row.find("cause");
  if (!cause) return;
  sum_of(*cause);
  const std::uint64_t asked = cause->count_or("asked", 0);
  require_part(row, asked, wrong, "cause");
  require_part(row, cause->count_or("logic", 0) + cause->count_or("rounding", 0), asked, "cause");
}

Check answers() {
  return [](const Record& r) {
    const std::uint64_t asked = r.count("asked"), wrong = r.count("wrong");
    const std::uint64_t unsupported = r.count_or("unsupported", 0);
    require_part(r, unsupported, asked, "unsupported");
    const std::uint64_t judged = asked - unsupported;
    if (r.has("judged") && r.count("judged") != judged) {
      r.fail_at("judged", "expected " + std::to_string(judged) + ", those asked but for those unsupported");
    }
    require_part(r, wrong, judged, "wrong");
    require_kinds(r, wrong, unsupported);
    require_share(r, wrong, judged);
    if (const auto drawn = r.find("drawn")) share()(*drawn);
    r.truth_or("bound", false);
  };
}

Check rate(std::vector<Member> more) {
  std::vector<Member> members{needed("n", count()), needed("k", count())};
  members.insert(members.end(), more.begin(), more.end());
  return object(std::move(members), [](const Record& r) { require_share(r, r.count("k"), r.count("n")); });
}

Check method(std::string_view key) {
  return object({needed(key, name()), if_there("number", text()), if_there("fmt", text()),
                 if_there("convention", text()), if_there("contract", text()), if_there("reference", text()),
                 if_there("exact", truth()), if_there("maker", text()), if_there("origin", text()),
                 if_there("certified", truth()), if_there("yardstick", truth())});
}

Check environment() { return named(text()); }

Check command() { return null_or(list(text())); }

Check triangle() {
  const Check coordinate = [](const Record& r) { to_number(r.json(), Format::binary64, r.where()); };
  const auto three = [](Check each) {
    return [each = std::move(each)](const Record& r) {
      if (r.items().size() != 3) r.fail("expected an array of three");
      list(each)(r);
    };
  };
  return three(three(coordinate));
}

Check errors(std::vector<Member> more) {
  return object(std::move(more), [](const Record& r) { to_errors(r); });
}

}  // namespace shape

namespace {

using namespace shape;

/// How many cases, values and numbers of an origin may be: a case's number, a seed, a value on an axis.
constexpr std::int64_t least_value = -(std::int64_t{1} << 53), most_value = std::int64_t{1} << 53;

Check origin() {
  return object({if_there("family", text()), if_there("fmt", text()), if_there("seed", whole()),
                 if_there("case", count()), if_there("stress", integer(least_value, most_value)),
                 if_there("value", integer(least_value, most_value)), if_there("axis", text()),
                 if_there("file", text()), if_there("sha256", text()), if_there("mesh", text()),
                 if_there("face", count()), if_there("ray", count()), if_there("aimed_at", text()),
                 if_there("relation", text()), if_there("probe", text())});
}

/// Whether digits and at most one bar with digits on both sides, after a sign: a fraction as GMP writes it.
bool is_fraction(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t bar = text.find('/');
  const auto is_whole = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  return bar == std::string_view::npos ? is_whole(text)
                                       : is_whole(text.substr(0, bar)) && is_whole(text.substr(bar + 1));
}

/// Signs, a parameter, or what the exact answer to a polygon is.
Check evidence() {
  const Check sign = integer(-1, 1);
  return object({if_there("abcp", sign), if_there("abcq", sign), if_there("pqab", sign), if_there("pqbc", sign),
                 if_there("pqca", sign), if_there("at_tmin", sign), if_there("at_tmax", sign),
                 if_there("contact", text()), if_there("planar", truth()), if_there("t", [](const Record& r) {
                   if (!is_fraction(r.text())) r.fail("expected a fraction like \"3/8\"");
                 })});
}

}  // namespace

void require_finding(const Record& finding) {
  static const Check shape = object({if_there("method", text()),
                                     if_there("outcome", text()),
                                     if_there("severity", word({"plain", "boundary", "extreme"})),
                                     if_there("cause", word({"logic", "rounding", "unknown"})),
                                     if_there("naive_right", truth()),
                                     if_there("in_words", text()),
                                     if_there("contact", text()),
                                     if_there("contact_told", text()),
                                     if_there("side", text()),
                                     if_there("side_told", text()),
                                     if_there("planar_told", truth()),
                                     if_there("answered", count(1)),
                                     if_there("expected", count(1)),
                                     if_there("convention", text()),
                                     if_there("readings", named(text())),
                                     if_there("exact", evidence()),
                                     if_there("answers", named(null_or(count(1)))),
                                     if_there("made_with", environment()),
                                     if_there("fault", text()),
                                     if_there("detail", text()),
                                     if_there("origin", origin())});
  shape(finding);
}

}  // namespace tribunal
