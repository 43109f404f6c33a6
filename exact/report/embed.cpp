// The report's page: a template that the program carries with it, and the JSON in it.
#include "exact/base/embedded.h"
#include "exact/base/failure.h"
#include "exact/base/json.h"
#include "exact/report/report.h"

namespace tribunal {
namespace {

constexpr std::string_view place = "@TRIBUNAL_DATA@";

}  // namespace

std::string embeddable(const Json& report) {
  std::string text;
  for (const char c : report.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  for (const auto& [separator, escape] : {std::pair("\u2028", "\\u2028"), std::pair("\u2029", "\\u2029")}) {
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, at)) {
      text.replace(at, std::string_view(separator).size(), escape);
    }
  }
  return text;
}

std::string report_page(const Json& report) {
  const std::string_view page = embedded_report_page;
  const std::size_t at = page.find(place);
  if (at == std::string_view::npos || page.find(place, at + 1) != std::string_view::npos) {
    throw Failure(Exit::resources, "the page's template has not exactly one place for the report");
  }
  return std::string(page.substr(0, at)) + embeddable(report) + std::string(page.substr(at + place.size()));
}

}  // namespace tribunal
