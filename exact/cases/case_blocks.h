// A case file as a stream: in constant memory, by several threads, with results in the order of the cases.
#pragma once

#include <cstdint>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/in_order.h"
#include "exact/base/lines.h"
#include "exact/cases/case_scan.h"

namespace tribunal {

/// How much a worker reads at once: enough that reading in turn costs nothing beside the work.
inline constexpr std::size_t lines_a_block = 1024, bytes_a_block = std::size_t{1} << 18;

/// Where a case stands.
struct CasePlace {
  std::size_t line = 0;      ///< of its file, from 1
  std::uint64_t number = 0;  ///< among the cases, from 0
};

struct ManyCases {
  unsigned threads = 1;
  std::string missing{};  ///< what there is none of if a signal ends the work: "no answers written"
};

/// Reads the cases and has each block's worked on by one of the threads: work(const Case&, CasePlace,
/// Result&). The results, one a block, are taken in order. Fails with Exit::bad_input at the first line that is wrong,
/// after the results before its block were taken; and if there is no case.
template <class Result, class Work, class Take>
void for_each_case(LineReader reader, const std::string& path, const ManyCases& how, const Work& work,
                   const Take& take) {
  std::uint64_t cases = 0;
  struct Block {
    LineBlock lines{};
    std::uint64_t first = 0;  ///< the number of its first case
  };
  const auto read = [&](Block& block) {
    if (!reader.next(block.lines, lines_a_block, bytes_a_block)) return false;
    block.first = cases;
    cases += block.lines.lines;
    return true;
  };
  const auto work_on = [&](const Block& block, Result& result) {
    Case c;
    std::uint64_t number = block.first;
    block.lines.for_each(path, [&](std::string_view line, std::size_t on) {
      read_case(line, path, on, c);
      work(static_cast<const Case&>(c), CasePlace{on, number++}, result);
    });
  };
  run_in_order<Block, Result>(how.threads, how.missing, read, work_on, take);
  if (cases == 0) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
}

template <class Result, class Work, class Take>
void for_each_case(const std::string& path, const ManyCases& how, const Work& work, const Take& take) {
  for_each_case<Result>(LineReader(bytes_of(path)), path, how, work, take);
}

}  // namespace tribunal
