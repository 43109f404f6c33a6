#include "tracer/demo/tour.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

bool is_degenerate(const Case& c) {
  if (c.class_id == 0 || !std::holds_alternative<Segment>(c.query.probe)) return true;
  const ClassRow& row = class_row(c.class_id);
  return row.triangle != "tri" || row.segment != "seg";
}

std::size_t length_of(const Case& c) {
  const Json line = from_case(c);
  return line.value("seg", Json()).dump().size() + line["tri"].dump().size();
}

}  // namespace

CertificateFigures certificate_figures(const Json& certificate) {
  CertificateFigures f;
  f.method = certificate.at("method");
  f.verdict = certificate.at("verdict");
  f.counterexamples = certificate.at("counterexamples");
  for (const Json& set : certificate.at("proved")) {
    f.whole.push_back({set.at("set"), set.at("size"), set.at("count").at("wrong")});
  }
  for (const Json& stratum : certificate.at("sampled")) {
    f.sampled += stratum.at("n").get<std::uint64_t>();
    f.wrong += stratum.at("k").get<std::uint64_t>();
  }
  std::map<std::string, std::size_t> reasons;
  for (const Json& gap : certificate.at("not_covered")) ++reasons[gap.at("reason")];
  f.gaps.assign(reasons.begin(), reasons.end());
  return f;
}

std::vector<FuzzFigures> fuzz_figures(const Json& summary) {
  std::vector<FuzzFigures> rows;
  for (const Json& count : summary.at("counts")) {
    const std::string method = count.at("method");
    if (rows.empty() || rows.back().method != method) rows.push_back({method});
    rows.back().judged += count.at("asked").get<std::uint64_t>() - count.at("unsupported").get<std::uint64_t>();
    rows.back().wrong += count.at("wrong").get<std::uint64_t>();
  }
  return rows;
}

PictureFigures picture_figures(const Json& stats, const std::vector<Case>& cases) {
  const Json& difference = stats.at("difference");
  PictureFigures f{.method = difference.at("against"),
                   .fmt = stats.at("fmt"),
                   .width = stats.at("width"),
                   .height = stats.at("height"),
                   .pixels = difference.at("pixels"),
                   .other_colour = difference.at("pixels_of_other_colour")};
  for (const Case& c : cases) {
    Place p{};
    if (std::sscanf(c.id.c_str(), "px-%d-%d-", &p.column, &p.row) == 2) f.places.push_back(p);
  }
  return f;
}

const Case& plainest(const std::vector<Case>& cases) {
  return *std::ranges::min_element(cases, {}, [](const Case& c) { return std::pair(is_degenerate(c), length_of(c)); });
}

}  // namespace tribunal
