// A report: the results in any directories as one JSON object, and as one page that shows it.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json_fwd.h"

namespace tribunal {

struct ReportPlan {
  std::vector<std::string> directories;  ///< searched with all that is in them
  std::size_t most_cases = 2000;         ///< that the page shows; the rest is counted
};

/// The results in the directories, as docs/report.md describes it. Fails with Exit::bad_input, in one line, where a
/// directory holds no result, and where a result is not as its command writes it.
Json gather_report(const ReportPlan& plan);

/// The page: the template with the JSON in it, in which no text can end the element that holds it.
std::string report_page(const Json& report);

/// The JSON as text inside a script element: no `<`, which could begin `</script` or `<!--`, and no line separators
/// that older scripts take for ends of lines.
std::string embeddable(const Json& report);

}  // namespace tribunal
