// A log of JSON records in which no number can be changed unnoticed: each line is chained to all before it.
#pragma once

#include <string>
#include <vector>

#include "exact/base/record.h"
#include "exact/base/spool.h"

namespace tribunal {

/// A log's records, without hashes and without the end, and the hash of its last line.
struct LogRecords {
  std::vector<Json> records;
  std::string head;
  std::string path{};  ///< of the file that they were read from

  std::size_t size() const { return records.size(); }
  /// Record i, which stands on line i + 1.
  Record operator[](std::size_t i) const { return {records[i], {path, i + 1}}; }
};

/// JSON Lines. Each record ends with a member "sha256": the hash of the previous line's hash (64 zeros before the
/// first) followed by this record's text without that member. The chain shows accidents and careless edits; it is no
/// signature: who rewrites every following hash is caught only by what `verify` recomputes.
class ChainedLog {
 public:
  void add(Json record);

  /// Adds a record "counterexample" for each line, which is a case.
  void add_counterexamples(const Spool& lines);

  /// Adds the record {"record":"end","records":n}, without which a log counts as cut short, and returns the text.
  std::string finish();

  const LogRecords& so_far() const { return log_; }

 private:
  void append(Json record);

  std::string text_;
  LogRecords log_{{}, std::string(64, '0')};
};

/// Reads and checks the chain. Fails with Exit::bad_input at the first line that breaks it, or if the end is missing.
LogRecords read_log(const std::string& path);

}  // namespace tribunal
