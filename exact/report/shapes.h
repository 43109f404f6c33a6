// What the records of each command must look like, so that page, terminal and drawings can rely on them. A key that a
// reader needs must be there; what older records lack may be missing, and a key that is there is of its type, within
// bounds, and goes with the others.
#pragma once

#include "exact/base/shape.h"

namespace tribunal {

void require_chart_record(const Record& record);
void require_compilers_record(const Record& record);
void require_bench_record(const Record& record);
void require_map_record(const Record& record);
void require_sweep_record(const Record& record);
void require_leak_record(const Record& record);
void require_render_record(const Record& record);
void require_certificate_record(const Record& record);
void require_fuzz_record(const Record& record);
void require_relations_record(const Record& record);

/// What a case of a result says of itself, beside the case.
void require_finding(const Record& finding);

namespace shape {

/// "asked", "wrong", "unsupported", "refused", and what the wrong answers are; "judged" and its share where they are
/// there.
Check answers();

/// "unsupported", "refused", "outcomes", "severity" and "cause" of a row with so many wrong of so many judged.
void require_kinds(const Record& row, std::uint64_t wrong, std::uint64_t unsupported);

/// {"n", "k", "share", "lower", "upper"}, with k of n.
Check rate(std::vector<Member> more = {});

/// A method as the records list it.
Check method(std::string_view key = "name");

/// What a result was made with: texts by name.
Check environment();

/// The words of a command.
Check command();

/// Three numbers, or texts that are hex floats, three times.
Check triangle();

/// Errors of numbers, of some hits.
Check errors(std::vector<Member> more = {});

}  // namespace shape

}  // namespace tribunal
