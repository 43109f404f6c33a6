#include "exact/record/chain.h"

#include <memory>
#include <optional>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/sha256.h"

namespace tribunal {
namespace {

/// Removes the hash from a record and returns it; fails if the line is not the text that was hashed.
std::string take_hash(Json& record, std::string_view line, const Where& where) {
  if (!record.is_object() || record.dump() != line) where.fail("not a line as it was written");
  std::string hash = Record(record, where).text("sha256");
  record.erase("sha256");
  return hash;
}

/// Checks the chain, calls visit(record without its hash, number of its line) for each record but the end, and returns
/// the hash of the last line.
std::string walk(const LineReader::Source& source, const std::string& path,
                 const std::function<void(Json&, std::size_t)>& visit) {
  std::string head(64, '0');
  Where where{path};
  std::optional<Json> last;  // visited once another line follows it
  for_each_line_of(source, [&](std::string_view line) {
    if (last) visit(*last, where.line);
    ++where.line;
    last = parse_json(line, where);
    const std::string hash = take_hash(*last, line, where);
    head = sha256(head + last->dump());
    if (hash != head) where.fail("the line or one before it was changed: its hash is " + head + ", not " + hash);
  });
  const Json end = {{"record", "end"}, {"records", where.line == 0 ? 0 : where.line - 1}};
  if (!last || *last != end) where.fail("the log is cut short: its end is missing");
  return head;
}

bool is_counterexample(const Json& record) {
  const auto kind = record.find("record");
  return kind != record.end() && *kind == "counterexample";
}

}  // namespace

void ChainedLog::add(Json record) {
  head_ = sha256(head_ + record.dump());
  record["sha256"] = head_;
  text_.write(record.dump() + "\n");
  ++records_;
}

void ChainedLog::add_counterexamples(const Spool& lines) {
  for_each_line_of(bytes_in(lines), [&](std::string_view line) {
    add({{"record", "counterexample"}, {"case", parse_json(line, {"counterexamples"})}});
  });
}

void ChainedLog::finish() {
  if (std::exchange(finished_, true)) return;
  add({{"record", "end"}, {"records", records_}});
}

Log::Log(const std::string& path)
    : source_([file = std::make_shared<const Rereadable>(path)] { return file->bytes(); }) {
  others_.path = path;
  read();
}

Log::Log(const ChainedLog& finished) : source_([&finished] { return bytes_in(finished.text()); }) { read(); }

void Log::read() {
  others_.head = walk(source_(), path(), [this](Json& record, std::size_t line) {
    ++size_;
    if (is_counterexample(record)) return;
    others_.records.push_back(std::move(record));
    others_.lines.push_back(line);
  });
}

void Log::for_each(const std::function<void(const Record&)>& visit) const {
  const std::string again = walk(source_(), path(), [&](const Json& record, std::size_t line) {
    visit({record, {path(), line}});
  });
  if (again != head()) Where{path()}.fail("was changed while it was read");
}

LogRecords read_log(const std::string& path) {
  LogRecords log{.path = path};
  log.head = walk(bytes_of(path), path, [&](Json& record, std::size_t line) {
    log.records.push_back(std::move(record));
    log.lines.push_back(line);
  });
  return log;
}

}  // namespace tribunal
