#include "exact/certificate/own_cases.h"

#include "exact/certificate/budget.h"
#include "exact/record/counterexample.h"
#include "exact/record/errors_json.h"
#include "exact/trial/exact_hit.h"
#include "exact/trial/formulations.h"
#include "exact/trial/judge.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

constexpr std::array formats = {Format::binary64, Format::binary32};

std::size_t index_of(Format format) { return format == Format::binary64 ? 0 : 1; }

std::size_t part_of(Operands operands, Format format) {
  return 2 * static_cast<std::size_t>(operands) + index_of(format);
}

void add_nonfinite(NonfiniteRow& row, const OwnAnswer& a) {
  ++row.asked;
  row.refused += a.given.status == Status::nonfinite ? 1 : 0;
  if (a.given.status == Status::nonfinite || a.given.status == Status::unsupported) return;
  if (row.answered++ == 0) row.first = a.of.id;
}

void add_numbers(HitErrors& errors, const Method& method, const OwnAnswer& a) {
  const Query& query = a.of.query;
  if (const std::optional<HitAt> given = a.numbers()) {
    const ExactHit exact = exact_hit(std::get<Ray>(query.probe), query.triangle());
    tribunal::add_numbers(errors, given, exact, method.contract.format, a.number);
  } else {
    ++errors.hits;
    ++errors.withheld;
  }
}

void add(NonfiniteRow& all, const NonfiniteRow& later) {
  if (all.answered == 0) all.first = later.first;
  all.asked += later.asked;
  all.refused += later.refused;
  all.answered += later.answered;
}

void log_part(ChainedLog& log, const Method& method, Operands operands, Format format,
              const OwnCounts<Spool>::Part& part, bool gives_numbers) {
  SampleRow row = part.row;
  row.method = method.name;
  row.family = own_cases;
  row.format = format;
  const std::uint64_t n = total_of(row).asked;
  if (n == 0) return;
  const Json stream = {{"record", "stream"},
                       {"family", row.family},
                       {"fmt", name_of(format)},
                       {"axis", "(none)"},
                       {"population", "the cases of your file, no more"},
                       {"judged_by", judges_of_own(operands)},
                       {"aims_at_classes", false},
                       {"taken", true},
                       {"cases", n}};
  log.add(with_operands(stream, operands));
  log.add(to_record(row));
  if (gives_numbers && part.errors.hits > 0) log.add(errors_record(row.method, row.family, format, part.errors));
}

void log_nonfinite(ChainedLog& log, Format format, const NonfiniteRow& row) {
  if (row.asked == 0) return;
  Json record = {{"record", "nonfinite"},
                 {"fmt", name_of(format)},
                 {"asked", row.asked},
                 {"refused", row.refused},
                 {"answered", row.answered}};
  if (row.answered > 0) record["first"] = row.first;
  log.add(record);
}

}  // namespace

void add(OwnCounts<std::string>& counts, const Method& method, const OwnAnswer& a) {
  const Case& c = a.of;
  if (!is_finite(c.query)) return add_nonfinite(counts.nonfinite[index_of(c.format)], a);
  const std::size_t p = part_of(c.query.operands(), c.format);
  OwnCounts<std::string>::Part& part = counts.parts[p];
  const Outcome outcome = takes(method, c.format) ? judge(method, a.truth, a.given) : Outcome::not_owed;
  Count& count = part.row.counts[slot_of(a.truth)];
  count.add(outcome, a.given.stage);
  if (a.numbers && outcome == Outcome::right && a.given.hit && has_numbers(c.query, a.truth)) {
    add_numbers(part.errors, method, a);
  }
  if (!is_wrong(outcome)) return;
  count.add_wrong(severity_of(c.query, a.truth), cause_of(method, c.query, a.truth, outcome));
  const Case found = with_steady_finding(c, method, a.truth, a.given);
  counts.wrong[{rank_of(found), static_cast<int>(p)}] += from_case(found).dump() + "\n";
}

void add(OwnCounts<Spool>& all, const OwnCounts<std::string>& later) {
  constexpr std::size_t memory_each = std::size_t{1} << 16;  // of 144 spools at most
  for (std::size_t p = 0; p < all.parts.size(); ++p) {
    for (const auto& [slot, count] : later.parts[p].row.counts) all.parts[p].row.counts[slot] += count;
    all.parts[p].errors += later.parts[p].errors;
  }
  for (std::size_t f = 0; f < all.nonfinite.size(); ++f) add(all.nonfinite[f], later.nonfinite[f]);
  all.gives_numbers |= later.gives_numbers;
  for (const auto& [place, lines] : later.wrong) all.wrong.try_emplace(place, memory_each).first->second.write(lines);
}

void log_own_cases(ChainedLog& log, const Method& method, const OwnCounts<Spool>& counts) {
  for (const Operands operands : {Operands::triangles, Operands::polygons}) {
    for (const Format format : formats) {
      log_part(log, method, operands, format, counts.parts[part_of(operands, format)], counts.gives_numbers);
    }
  }
  for (const Format format : formats) log_nonfinite(log, format, counts.nonfinite[index_of(format)]);
  for (const auto& [place, lines] : counts.wrong) log.add_counterexamples(lines);
}

}  // namespace tribunal
