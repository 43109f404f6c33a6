#include "exact/record/chain.h"

#include <sstream>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"

namespace tribunal {
namespace {

/// Removes the hash from a record and returns it; fails if the line is not the text that was hashed.
std::string take_hash(Json& record, const std::string& line, const Where& where) {
  if (!record.is_object() || record.dump() != line) where.fail("not a line as it was written");
  std::string hash = Record(record, where).text("sha256");
  record.erase("sha256");
  return hash;
}

}  // namespace

void ChainedLog::append(Json record) {
  log_.head = sha256(log_.head + record.dump());
  record["sha256"] = log_.head;
  text_ += record.dump() + "\n";
}

void ChainedLog::add(Json record) {
  append(record);
  log_.records.push_back(std::move(record));
}

void ChainedLog::add_counterexamples(const Spool& lines) {
  std::string rest;
  lines.for_each_piece([&](std::string_view piece) {
    rest += piece;
    std::size_t begin = 0;
    for (std::size_t end; (end = rest.find('\n', begin)) != std::string::npos; begin = end + 1) {
      add({{"record", "counterexample"}, {"case", parse_json(rest.substr(begin, end - begin), {"counterexamples"})}});
    }
    rest.erase(0, begin);
  });
}

std::string ChainedLog::finish() {
  append({{"record", "end"}, {"records", log_.records.size()}});
  return text_;
}

LogRecords read_log(const std::string& path) {
  std::istringstream lines(read_file(path));
  LogRecords log{{}, std::string(64, '0'), path};
  Where where{path};
  for (std::string line; std::getline(lines, line);) {
    ++where.line;
    Json record = parse_json(line, where);
    const std::string hash = take_hash(record, line, where);
    log.head = sha256(log.head + record.dump());
    if (hash != log.head)
      where.fail("the line or one before it was changed: its hash is " + log.head + ", not " + hash);
    log.records.push_back(std::move(record));
  }
  const Json end = {{"record", "end"}, {"records", log.records.empty() ? 0 : log.records.size() - 1}};
  if (log.records.empty() || log.records.back() != end) where.fail("the log is cut short: its end is missing");
  log.records.pop_back();
  return log;
}

}  // namespace tribunal
