// A log of JSON records in which no number can be changed unnoticed: each line is chained to all before it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "exact/base/lines.h"
#include "exact/base/record.h"
#include "exact/base/spool.h"

namespace tribunal {

/// Records of a log that are held, without hashes and without the end, and the hash of the log's last line.
struct LogRecords {
  std::vector<Json> records{};
  std::vector<std::size_t> lines{};  ///< of the file, which they stand on
  std::string head = std::string(64, '0');
  std::string path{};  ///< of the file that they were read from

  std::size_t size() const { return records.size(); }
  Record operator[](std::size_t i) const { return {records[i], {path, lines[i]}}; }
};

/// JSON Lines. Each record ends with a member "sha256": the hash of the previous line's hash (64 zeros before the
/// first) followed by this record's text without that member. The chain shows accidents and careless edits; it is no
/// signature: who rewrites every following hash is caught only by what `verify` recomputes. Held in a spool, in bounded
/// memory.
class ChainedLog {
 public:
  void add(Json record);

  /// Adds a record "counterexample" for each line, which is a case.
  void add_counterexamples(const Spool& lines);

  /// Adds the record {"record":"end","records":n}, without which a log counts as cut short. Once.
  void finish();

  const Spool& text() const { return text_; }

 private:
  Spool text_{};
  std::string head_ = std::string(64, '0');
  std::size_t records_ = 0;
  bool finished_ = false;
};

/// A log that may have any number of counterexamples, read again for each use of them, in memory that does not depend
/// on how many there are. All other records, as many as a plan has sets and streams, are held.
class Log {
 public:
  /// Checks the chain. Fails with Exit::bad_input at the first line that breaks it, or if the end is missing.
  explicit Log(const std::string& path);

  /// A finished one, which must live as long as this is used.
  explicit Log(const ChainedLog& finished);

  /// Calls `visit` with each record in order, which lives until it returns. Fails with Exit::bad_input if the log is no
  /// longer what it was.
  void for_each(const std::function<void(const Record&)>& visit) const;

  std::size_t size() const { return size_; }
  const std::string& head() const { return others_.head; }
  const std::string& path() const { return others_.path; }

  /// All records but the counterexamples.
  const LogRecords& others() const { return others_; }

 private:
  void read();

  std::function<LineReader::Source()> source_;  ///< the log from its start
  LogRecords others_{};
  std::size_t size_ = 0;
};

/// All records of a log. Fails as the constructor of a Log does.
LogRecords read_log(const std::string& path);

}  // namespace tribunal
