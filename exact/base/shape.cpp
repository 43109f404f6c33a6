#include "exact/base/shape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "exact/base/failure.h"

namespace tribunal::shape {
namespace {

std::string short_form(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

}  // namespace

Check text() {
  return [](const Record& r) { r.text(); };
}

Check name() {
  return [](const Record& r) {
    if (r.text().empty()) r.fail("expected a string that is not empty, found \"\"");
  };
}

Check truth() {
  return [](const Record& r) { r.truth(); };
}

Check count(std::uint64_t most) {
  return [most](const Record& r) { r.count(most); };
}

Check whole() {
  return [](const Record& r) { r.whole(); };
}

Check integer(std::int64_t least, std::int64_t most) {
  return [=](const Record& r) { r.integer(least, most); };
}

Check number(double least, double most) {
  return [=](const Record& r) {
    const double x = r.number();
    if (x < least || x > most) {
      r.fail("expected a number from " + short_form(least) + " to " + short_form(most) + ", found " + short_form(x));
    }
  };
}

Check share() { return number(0, 1); }

Check word(std::initializer_list<std::string_view> words) {
  return [known = std::vector<std::string_view>(words)](const Record& r) {
    const std::string given = r.text();
    if (std::ranges::find(known, given) != known.end()) return;
    std::string all;
    for (const std::string_view w : known) all += (all.empty() ? "\"" : ", \"") + std::string(w) + "\"";
    r.fail("expected one of " + all);
  };
}

Check format() { return word({"binary64", "binary32"}); }

Check null_or(Check shape) {
  return [shape = std::move(shape)](const Record& r) {
    if (!r.json().is_null()) shape(r);
  };
}

Check either(std::initializer_list<Check> shapes, const char* expected) {
  return [all = std::vector<Check>(shapes), expected](const Record& r) {
    for (const Check& one : all) {
      try {
        return one(r);
      } catch (const Failure&) {
        // The next may fit.
      }
    }
    r.fail(std::string("expected ") + expected);
  };
}

Check list(Check of_item) {
  return [of_item = std::move(of_item)](const Record& r) {
    for (const Record& item : r.items()) of_item(item);
  };
}

Check named(Check of_member) {
  return [of_member = std::move(of_member)](const Record& r) {
    for (const auto& [key, value] : r.members()) of_member(value);
  };
}

Member needed(std::string_view key, Check shape) { return {key, std::move(shape), true}; }

Member if_there(std::string_view key, Check shape) { return {key, std::move(shape), false}; }

Check object(std::vector<Member> members, Check also) {
  return [members = std::move(members), also = std::move(also)](const Record& r) {
    r.object();
    for (const auto& [key, shape, is_needed] : members) {
      if (is_needed) {
        shape(r.member(key));
      } else if (const auto value = r.find(key)) {
        shape(*value);
      }
    }
    if (also) also(r);
  };
}

void require_part(const Record& row, std::uint64_t part, std::uint64_t whole, const char* what) {
  if (part <= whole) return;
  row.fail(std::string("counts that cannot be: ") + what + ", " + std::to_string(part) + " of " +
           std::to_string(whole));
}

/// The share itself is a quotient, rounded; the bounds depend on the interval, and lie about it.
void require_share(const Record& row, std::uint64_t part, std::uint64_t whole) {
  constexpr double rounding = 1e-9;
  require_part(row, part, whole, "wrong");
  const double exact = whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  for (const char* key : {"share", "lower", "upper"}) {
    if (const auto value = row.find(key)) share()(*value);
  }
  if (row.has("share") && std::fabs(row.number("share") - exact) > rounding) {
    row.fail_at("share", "expected " + std::to_string(part) + " / " + std::to_string(whole));
  }
  if (row.has("lower") && row.number("lower") > exact + rounding) row.fail_at("lower", "is above the share");
  if (row.has("upper") && row.number("upper") < exact - rounding) row.fail_at("upper", "is below the share");
}

std::uint64_t sum_of(const Record& counts) {
  std::uint64_t sum = 0;
  for (const auto& [key, value] : counts.members()) sum += value.count(Record::most_count - sum);
  return sum;
}

}  // namespace tribunal::shape
