#include "exact/record/sample_row.h"

#include <array>
#include <limits>
#include <tuple>
#include <utility>

namespace tribunal {
namespace {

Slot to_slot(const std::string& name, const Record& counts) {
  const std::optional<Slot> slot = slot_named(name);
  if (!slot) counts.fail("expected a class C001 to C163, \"ray\" or a kind of polygon case, found \"" + name + "\"");
  return *slot;
}

/// Older logs have the first six.
using Numbers = std::array<std::uint64_t, 16>;

Numbers numbers_of(const Count& c) {
  return {c.asked,
          c.wrong,
          c.unsupported,
          c.at(Stage::filter),
          c.at(Stage::integers),
          c.at(Stage::exact),
          c.refused,
          c.at(Outcome::false_hit),
          c.at(Outcome::false_miss),
          c.at(Outcome::wrong_contact),
          c.at(Outcome::fault),
          c.at(Severity::plain),
          c.at(Severity::boundary),
          c.at(Severity::extreme),
          c.logic,
          c.rounding};
}

/// No sum overflows: each number is at most Record::most_count.
bool are_possible(const Numbers& n) {
  const bool answers = n[2] <= n[0] && n[1] <= n[0] - n[2] && n[3] + n[4] + n[5] <= n[0] - n[2];
  const std::uint64_t by_outcome = n[7] + n[8] + n[9] + n[10], by_severity = n[11] + n[12] + n[13];
  return answers && n[6] <= n[2] && by_outcome <= n[1] && by_severity == by_outcome &&
         n[14] + n[15] <= by_outcome - n[10];
}

}  // namespace

Count total_of(const SampleRow& row) {
  Count total;
  for (const auto& [slot, count] : row.counts) total += count;
  return total;
}

Count total_of(const SampleRow& row, bool rays) {
  Count total;
  for (const auto& [slot, count] : row.counts) {
    if (is_of_rays(slot) == rays) total += count;
  }
  return total;
}

Json to_array(const Count& count) {
  const auto numbers = numbers_of(count);
  std::size_t length = numbers.size();
  while (length > 1 && numbers[length - 1] == 0) --length;
  Json array = Json::array();
  for (std::size_t i = 0; i < length; ++i) array.push_back(numbers[i]);
  return array;
}

Count to_count(const Record& array) {
  Numbers n{};
  const std::vector<Record> given = array.items();
  if (given.empty() || given.size() > n.size()) array.fail("expected one to sixteen counts");
  for (std::size_t i = 0; i < given.size(); ++i) n[i] = given[i].count();
  if (!are_possible(n)) array.fail("counts that cannot be: " + array.json().dump());
  return {.asked = n[0],
          .wrong = n[1],
          .unsupported = n[2],
          .refused = n[6],
          .by_stage = {n[0] - n[2] - n[3] - n[4] - n[5], n[3], n[4], n[5]},
          .by_outcome = {n[7], n[8], n[9], n[10]},
          .by_severity = {n[11], n[12], n[13]},
          .logic = n[14],
          .rounding = n[15]};
}

Json outcomes_of(const Count& count) {
  Json wrong = Json::object(), severity = Json::object();
  for (const Outcome o : wrong_outcomes) wrong[std::string(name_of(o))] = count.at(o);
  for (const Severity s : all_severities) severity[std::string(name_of(s))] = count.at(s);
  const Json cause = {{"asked", count.logic + count.rounding}, {"logic", count.logic}, {"rounding", count.rounding}};
  return {{"outcomes", wrong}, {"severity", severity}, {"cause", cause}, {"refused", count.refused}};
}

Json to_record(const SampleRow& row) {
  Json counts = Json::object();
  for (const auto& [slot, count] : row.counts) counts[slot_name(slot)] = to_array(count);
  return {{"record", "sample"}, {"method", row.method}, {"family", row.family}, {"fmt", name_of(row.format)},
          {"level", row.level}, {"stress", row.stress}, {"counts", counts}};
}

Format format_of(const Record& record) {
  return one_of<Format>(record.member("fmt"), {{"binary32", Format::binary32}, {"binary64", Format::binary64}});
}

SampleRow to_sample_row(const Record& record) {
  record.keys({"record", "method", "family", "fmt", "level", "stress", "counts"});
  SampleRow row;
  row.method = record.text("method");
  row.family = record.text("family");
  row.format = format_of(record);
  row.level = record.count("level");
  row.stress =
      static_cast<int>(record.integer("stress", std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
  const Record counts = record.member("counts");
  for (const auto& [name, count] : counts.members()) row.counts[to_slot(name, counts)] = to_count(count);
  return row;
}

std::vector<SampleRow> rows_of(const FuzzPlan& plan, const FuzzReport& report) {
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, SampleRow> rows;
  report.counts.for_each([&](const Cell& cell, const Count& count) {
    const Stream& stream = plan.streams[cell.stream];
    SampleRow& row = rows[{cell.method, cell.stream, cell.level}];
    row.method = plan.methods[cell.method].name;
    row.family = stream.family->name;
    row.format = stream.format;
    row.level = cell.level;
    row.stress = stream.family->levels(stream.format)[cell.level];
    row.counts[cell.slot] = count;
  });
  std::vector<SampleRow> list;
  for (auto& [key, row] : rows) list.push_back(std::move(row));
  return list;
}

}  // namespace tribunal
