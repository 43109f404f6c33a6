#include "exact/base/record.h"

#include <cmath>

namespace tribunal {
namespace {

/// What stands there, cut to a length that fits a line.
std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

[[noreturn]] void refuse(const Record& r, const std::string& expected) {
  r.fail("expected " + expected + ", found " + shown(r.json()));
}

/// Whether the value is a whole number from 0; of those that the program itself builds, some are signed.
std::optional<std::uint64_t> whole_number(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0) return std::nullopt;
  return static_cast<std::uint64_t>(value.get<std::int64_t>());
}

std::optional<std::int64_t> signed_number(const Json& value) {
  if (value.is_number_unsigned()) {
    const auto n = value.get<std::uint64_t>();
    return n >> 63 == 0 ? std::optional(static_cast<std::int64_t>(n)) : std::nullopt;
  }
  return value.is_number_integer() ? std::optional(value.get<std::int64_t>()) : std::nullopt;
}

std::string range_of(std::uint64_t most) {
  if (most == ~std::uint64_t{0}) return "a whole number, 0 or more";
  return "a whole number from 0 to " + std::to_string(most);
}

}  // namespace

const Json* Record::found(std::string_view key) const {
  object();
  const auto at = value_->find(std::string(key));
  return at == value_->end() ? nullptr : &*at;
}

const Json& Record::needed(std::string_view key) const {
  const Json* const value = found(key);
  if (value == nullptr) fail("missing \"" + std::string(key) + "\"");
  return *value;
}

const Record& Record::object() const {
  if (!value_->is_object()) refuse(*this, "an object");
  return *this;
}

Record Record::member(std::string_view key) const { return of(key, needed(key)); }

std::optional<Record> Record::find(std::string_view key) const {
  const Json* const value = found(key);
  return value == nullptr ? std::nullopt : std::optional(of(key, *value));
}

std::vector<std::pair<std::string, Record>> Record::members() const {
  object();
  std::vector<std::pair<std::string, Record>> list;
  for (const auto& item : value_->items()) list.emplace_back(item.key(), of(item.key(), item.value()));
  return list;
}

std::vector<Record> Record::items() const {
  if (!value_->is_array()) refuse(*this, "an array");
  std::vector<Record> list;
  list.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) list.emplace_back((*value_)[i], where_.index(i));
  return list;
}

std::string Record::text() const {
  if (!value_->is_string()) refuse(*this, "a string");
  return value_->get<std::string>();
}

bool Record::truth() const {
  if (!value_->is_boolean()) refuse(*this, "true or false");
  return value_->get<bool>();
}

std::uint64_t Record::count(std::uint64_t most) const {
  const std::optional<std::uint64_t> n = whole_number(*value_);
  if (!n || *n > most) refuse(*this, range_of(most));
  return *n;
}

std::int64_t Record::integer(std::int64_t least, std::int64_t most) const {
  const std::optional<std::int64_t> n = signed_number(*value_);
  if (!n || *n < least || *n > most) {
    refuse(*this, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *n;
}

double Record::number() const {
  if (!value_->is_number() || !std::isfinite(value_->get<double>())) refuse(*this, "a finite number");
  return value_->get<double>();
}

// The path of a member is made where its reading fails, and else spared.

std::string Record::text(std::string_view key) const {
  const Json& value = needed(key);
  return value.is_string() ? value.get<std::string>() : of(key, value).text();
}

std::string Record::name(std::string_view key) const {
  const Json& value = needed(key);
  if (!value.is_string() || value.get_ref<const std::string&>().empty()) {
    refuse(of(key, value), "a string that is not empty");
  }
  return value.get<std::string>();
}

bool Record::truth(std::string_view key) const {
  const Json& value = needed(key);
  return value.is_boolean() ? value.get<bool>() : of(key, value).truth();
}

std::uint64_t Record::count(std::string_view key, std::uint64_t most) const {
  const Json& value = needed(key);
  const std::optional<std::uint64_t> n = whole_number(value);
  return n && *n <= most ? *n : of(key, value).count(most);
}

std::int64_t Record::integer(std::string_view key, std::int64_t least, std::int64_t most) const {
  return member(key).integer(least, most);
}

std::vector<Record> Record::items_or_none(std::string_view key) const {
  const Json* const value = found(key);
  return value == nullptr ? std::vector<Record>{} : of(key, *value).items();
}

std::string Record::text_or(std::string_view key, std::string_view otherwise) const {
  return has(key) ? text(key) : std::string(otherwise);
}

bool Record::truth_or(std::string_view key, bool otherwise) const { return has(key) ? truth(key) : otherwise; }

std::uint64_t Record::count_or(std::string_view key, std::uint64_t otherwise, std::uint64_t most) const {
  return has(key) ? count(key, most) : otherwise;
}

}  // namespace tribunal
