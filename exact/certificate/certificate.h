// The certificate: what is proved, what is sampled and what is not covered, kept apart. It is a function of a log of
// records, so whoever has the log can make it again.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/contract.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/record/chain.h"
#include "exact/record/sample_row.h"
#include "exact/trial/coverage.h"

namespace tribunal {

/// Of the log, in its record "plan". Version 1, which does not say so, does not say what wrong answers are. Version 2
/// has no relations, and no errors of numbers.
inline constexpr std::uint64_t log_version = 3;

/// A relation between answers, checked on the first cases of each stream, of one format and with one kind of probe.
struct RelationRow {
  std::string name, statement;
  Format format = Format::binary64;
  bool of_rays = false;
  std::uint64_t cases = 0;  ///< of the format, of which those count that the relation speaks of and the method takes
  std::uint64_t asked = 0, broken = 0;
  std::uint64_t faults = 0;     ///< not in `asked`: the method did something else than answer
  std::uint64_t first = 0;      ///< the first case that broke it
  std::vector<Json> witness{};  ///< its queries
};

/// A set that was run whole.
struct ProvedSet {
  std::string name, oracles, answers_hash;
  bool of_rays = false;  ///< its probes are rays, else segments
  std::uint64_t size = 0;
  std::uint64_t classes = 0;
  bool complete = false;
  Count count{};
};

/// Errors of the numbers that the method gives with right hits of rays, in one family and format.
struct ErrorRow {
  std::string family;
  Format format = Format::binary64;
  HitErrors errors{};
};

/// One's own cases of a format with numbers that are not finite: each is to be refused with the status `nonfinite`.
/// Whoever refuses it as unsupported, is owed nothing; whoever does anything else is wrong.
struct NonfiniteRow {
  Format format = Format::binary64;
  std::uint64_t asked = 0, refused = 0, answered = 0;
  std::string first{};  ///< the id of the first that was answered
};

/// The family under which the cases of a user's file are logged. They are no sample of anything.
inline constexpr const char* own_cases = "your own cases";

/// One sampled sequence of cases, as its family describes it; or one's own cases of one format.
struct SampledStream {
  std::string family;
  Format format = Format::binary64;
  std::string axis, population, judged_by;
  bool aims_at_classes = false;  ///< every class or construction is drawn, so an empty one is a hole
  bool taken = true;             ///< false: the operands do not fit the method's format
  std::uint64_t cases = 0;       ///< drawn, so the counts of every method that takes them must add up to this
  Operands operands = Operands::triangles;

  bool is_own() const { return family == own_cases; }
};

/// One stratum: class, construction or outcome × stream. Of a sampled stream there are bounds, about cases of this
/// generator under this seed; of one's own cases there are none.
struct Stratum {
  std::size_t stream;
  Slot slot;
  Count count;
};

/// Something that the certificate does not cover. `explained`: the reason lies in the contract or the family.
struct Gap {
  std::string what, reason;
  bool explained;
};

/// Counts of binary64 and of binary32 cases, which no figure adds up.
struct ByFormat {
  std::array<Count, 2> counts{};

  Count& of(Format f) { return counts[static_cast<std::size_t>(f)]; }
  const Count& of(Format f) const { return counts[static_cast<std::size_t>(f)]; }
  Count total() const { return Count(counts[0]) += counts[1]; }
};

enum class Verdict { not_refuted, refuted, incomplete };

std::string name_of(Verdict v);

struct Certificate {
  Json plan;          ///< the record "plan": method, terms, stages, budget, seed
  Contract contract;  ///< the terms
  Json environment;   ///< the record "environment"
  Json budget;        ///< the record "budget"; none in what `judge` writes
  std::vector<Stage> stages;
  std::vector<ProvedSet> proved;
  std::vector<RelationRow> relations;
  std::vector<ErrorRow> errors;
  std::vector<NonfiniteRow> nonfinite;
  std::vector<SampledStream> streams;
  std::vector<SampleRow> rows;                  ///< of the method on trial
  std::map<std::string, ByFormat> calibration;  ///< of the naive methods on the same sample
  std::size_t counterexamples = 0;              ///< how many the log has; they stay there
  std::map<std::string, std::size_t> faults;    ///< of these, those with each fault
  std::string log_head;                         ///< hash of the log's last line

  // What follows from the members above.
  std::vector<Stratum> strata;
  Coverage coverage;
  std::vector<Gap> gaps;
  Verdict verdict = Verdict::incomplete;

  std::string method() const;
  std::uint64_t seed() const;
  std::string word_of(Stage stage) const;  ///< the log's own word, one of `stages`
  Operands operands() const;               ///< the operands that the plan is about
  bool is_own(const Stratum& s) const { return streams[s.stream].is_own(); }
  std::size_t sampled_strata() const;  ///< which share the simultaneous bounds
  bool has_own() const;
  /// Whether rays, or segments, are in the method's contract.
  bool takes(bool rays) const { return rays ? contract.probes.rays : contract.probes.segments; }
  Count sampled() const;                   ///< without one's own cases
  Count sampled(bool rays) const;          ///< of these, the rays or the segments
  Count sampled(bool rays, Format) const;  ///< of these, those of one format
  Count sampled(Format) const;
  Count own() const;  ///< one's own cases
  Count own(Format) const;
  std::uint64_t version() const;       ///< of the log
  NonfiniteRow all_nonfinite() const;  ///< of both formats
  /// Whether the log says what wrong answers are.
  bool says_outcomes() const { return version() >= 2; }
  /// The relations that the method broke, each once.
  std::vector<std::string> broken_relations() const;
  /// The worst that there was, by population.
  std::string worst() const;
};

/// Fails with Exit::bad_input, naming the line of the log, if a record is not as it must be.
Certificate certificate_from(const Log& log);

Json to_json(const Certificate& c);

/// The same for people.
std::string to_markdown(const Certificate& c);

/// What the terminal shows.
std::string to_summary(const Certificate& c);

/// Calls visit(record, line) for each record "counterexample" of the log, with what counterexamples.jsonl has of it.
void for_each_counterexample(const Log& log, const std::function<void(const Record&, const std::string&)>& visit);

/// Finishes the log, writes log.jsonl, certificate.json, certificate.md and counterexamples.jsonl, and returns the
/// certificate.
Certificate write_certificate(const std::string& directory, ChainedLog& log);

/// The same, but for the commit.
Certificate add_certificate(OutputSet& set, const std::string& directory, ChainedLog& log);

}  // namespace tribunal
