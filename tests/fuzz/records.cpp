#include <unistd.h>

#include <filesystem>

#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/owed.h"
#include "exact/methods/methods.h"
#include "exact/record/checkpoint.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {
namespace {

/// The objects that stand on lines of the text, as a log whose chain is whole. Other lines are left out.
std::string sealed(std::string_view text) {
  ChainedLog log;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    accepts([&] {
      Json record = parse_json(text.substr(begin, end - begin), {"fuzzed"});
      if (!record.is_object()) return;
      record.erase("sha256");
      log.add(record);
    });
    begin = end + 1;
  }
  log.finish();
  return log.text().at(0, static_cast<std::size_t>(log.text().size()));
}

/// A plan of few cases, of a method that answers exactly and of one that is wrong here and there.
const FuzzPlan& plan() {
  static const FuzzPlan small = [] {
    FuzzPlan p{.methods = {reference_method(), methods_with(Role::calibration).front()}, .streams = {}, .seed = 3};
    for (const Family& family : families_of(Operands::triangles)) {
      for (const Format format : {Format::binary64, Format::binary32}) {
        if (p.streams.size() < 6) p.streams.push_back({&family, format});
      }
    }
    p.cases = 6000;
    return p;
  }();
  return small;
}

/// A directory of this process alone.
const std::string& directory() {
  static const std::string path = [] {
    const std::string name =
        (std::filesystem::temp_directory_path() / ("tribunal-fuzz-" + std::to_string(getpid()))).string();
    make_directory(name);
    std::atexit([] { std::filesystem::remove_all(directory()); });
    return name;
  }();
  return path;
}

}  // namespace

void log(std::string_view bytes) {
  const MemoryFile file(sealed(bytes));
  accepts([&] {
    const Log records(file.path());
    const Certificate c = certificate_from(records);
    to_json(c).dump();
    to_markdown(c);
    to_summary(c);
    debts_of(c, records.others());
    for (const Stratum& s : c.strata) {
      demand(s.count.asked <= c.streams[s.stream].cases, "more cases in a stratum than in its stream");
      demand(s.count.wrong <= s.count.judged(), "more wrong answers than answers");
    }
  });
}

void checkpoint(std::string_view bytes) {
  write_file(checkpoint_path(directory()), sealed(bytes));
  accepts([&] {
    try {
      const auto report = load_checkpoint(directory(), plan());
      demand(report && report->cases <= plan().cases, "more cases than the plan has");
      demand(fuzz(plan(), *report, {}).cases == plan().cases, "the run does not come to its end");
    } catch (const Failure& failure) {
      if (failure.exit() != Exit::usage) throw;  // of another plan
    }
  });
}

}  // namespace tribunal::fuzzing
