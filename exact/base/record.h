// The one door between a JSON file that somebody else may have written and our numbers: a value is read by the type and
// within the bounds that its reader expects, or refused by name.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/base/json.h"

namespace tribunal {

/// A value of a file, and where it stands. Every reader fails with Exit::bad_input where the value is missing, of
/// another type or out of bounds, and names the file, the line, the path of the value and what was expected. A test
/// greps for conversions of JSON values elsewhere. The value must outlive the record and what is made of it.
class Record {
 public:
  /// The most that a count may be: counts are whole numbers that every program reads exactly, and 2¹¹ of them add up
  /// without overflow.
  static constexpr std::uint64_t most_count = std::uint64_t{1} << 53;

  Record(const Json& value, Where where) : value_(&value), where_(std::move(where)) {}
  Record(Json&&, Where) = delete;

  /// The value itself, to be passed on, compared or printed, not converted.
  const Json& json() const { return *value_; }
  const Where& where() const { return where_; }
  [[noreturn]] void fail(const std::string& what) const { where_.fail(what); }
  /// Fails, naming the member.
  [[noreturn]] void fail_at(std::string_view key, const std::string& what) const { where_.key(key).fail(what); }

  // --- of an object ---

  bool has(std::string_view key) const { return found(key) != nullptr; }
  Record member(std::string_view key) const;
  std::optional<Record> find(std::string_view key) const;
  std::vector<std::pair<std::string, Record>> members() const;
  /// Fails at a member with another name.
  void keys(std::initializer_list<std::string_view> known) const { require_keys(json(), known, where_); }

  // --- of an array ---

  std::vector<Record> items() const;

  // --- the value ---

  std::string text() const;
  bool truth() const;
  /// 0 ≤ n ≤ `most`.
  std::uint64_t count(std::uint64_t most = most_count) const;
  /// Any of 64 bits, for what nothing is added to: a seed.
  std::uint64_t whole() const { return count(~std::uint64_t{0}); }
  std::int64_t integer(std::int64_t least, std::int64_t most) const;
  /// A finite number, written as a JSON number.
  double number() const;
  /// Fails unless it is an object.
  const Record& object() const;

  // --- a member ---

  std::vector<Record> items(std::string_view key) const { return member(key).items(); }
  std::string text(std::string_view key) const;
  /// A string that is not empty.
  std::string name(std::string_view key) const;
  bool truth(std::string_view key) const;
  std::uint64_t count(std::string_view key, std::uint64_t most = most_count) const;
  std::uint64_t whole(std::string_view key) const { return count(key, ~std::uint64_t{0}); }
  std::int64_t integer(std::string_view key, std::int64_t least, std::int64_t most) const;
  double number(std::string_view key) const { return member(key).number(); }

  // --- a member that may be missing; one of another type still fails ---

  std::vector<Record> items_or_none(std::string_view key) const;
  std::string text_or(std::string_view key, std::string_view otherwise) const;
  bool truth_or(std::string_view key, bool otherwise) const;
  std::uint64_t count_or(std::string_view key, std::uint64_t otherwise, std::uint64_t most = most_count) const;

 private:
  const Json* found(std::string_view key) const;
  const Json& needed(std::string_view key) const;
  Record of(std::string_view key, const Json& value) const { return {value, where_.key(key)}; }

  const Json* value_;
  Where where_;
};

/// The value that one of the words names; fails with all words otherwise. `words` is a list of (word, value).
template <class T>
T one_of(const Record& r, std::initializer_list<std::pair<std::string_view, T>> words) {
  const std::string given = r.text();
  std::string all;
  for (const auto& [word, value] : words) {
    if (given == word) return value;
    all += (all.empty() ? "\"" : ", \"") + std::string(word) + "\"";
  }
  r.fail("expected one of " + all + ", found " + r.json().dump());
}

}  // namespace tribunal
