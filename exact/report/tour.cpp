#include "exact/report/tour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

std::vector<double> coordinates_of(const Case& c) {
  const Triangle& t = c.query.triangle();
  std::vector<Point3> points{t.a, t.b, t.c};
  if (const auto* s = std::get_if<Segment>(&c.query.probe)) points.insert(points.end(), {s->p, s->q});
  std::vector<double> coordinates;
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return coordinates;
}

/// Degenerate operands, all five points in one plane, or coordinates of an unusual size.
bool is_special(const Case& c) {
  if (c.class_id == 0 || !std::holds_alternative<Segment>(c.query.probe)) return true;
  const ClassRow& row = class_row(c.class_id);
  const auto is_everyday = [](double x) { return x == 0 || (std::fabs(x) > 1e-4 && std::fabs(x) < 1e4); };
  return row.triangle != "tri" || row.probe != "seg" || row.rank < 4 ||
         !std::ranges::all_of(coordinates_of(c), is_everyday);
}

/// Length of the coordinates in decimal.
std::size_t length_of(const Case& c) { return Json(coordinates_of(c)).dump().size(); }

/// The figures of the format, new ones at first.
SampleFigures& sample_of(std::vector<SampleFigures>& samples, const std::string& fmt) {
  const auto found = std::ranges::find(samples, fmt, &SampleFigures::fmt);
  return found != samples.end() ? *found : samples.emplace_back(SampleFigures{fmt});
}

/// The row of the method and the format, a new one at first.
FuzzFigures& row_of(std::vector<FuzzFigures>& rows, const std::string& method, const std::string& fmt) {
  const auto found =
      std::ranges::find_if(rows, [&](const FuzzFigures& row) { return row.method == method && row.fmt == fmt; });
  return found != rows.end() ? *found : rows.emplace_back(FuzzFigures{method, fmt});
}

}  // namespace

CertificateFigures certificate_figures(const Json& certificate) {
  CertificateFigures f;
  f.method = certificate.at("method");
  f.verdict = certificate.at("verdict");
  f.worst = certificate.at("worst");
  f.counterexamples = certificate.at("counterexamples");
  for (const Json& set : certificate.at("proved")) {
    f.whole.push_back({set.at("set"), set.at("size"), set.at("count").at("wrong")});
  }
  for (const Json& stratum : certificate.at("sampled")) {
    SampleFigures& sample = sample_of(f.samples, stratum.at("fmt"));
    sample.sampled += stratum.at("n").get<std::uint64_t>();
    sample.wrong += stratum.at("k").get<std::uint64_t>();
  }
  std::map<std::string, std::size_t> reasons;
  for (const Json& gap : certificate.at("not_covered")) ++reasons[gap.at("reason")];
  f.gaps.assign(reasons.begin(), reasons.end());
  return f;
}

std::vector<FuzzFigures> fuzz_figures(const Json& summary) {
  std::vector<FuzzFigures> rows;
  for (const Json& count : summary.at("counts")) {
    FuzzFigures& row = row_of(rows, count.at("method"), count.at("fmt"));
    row.judged += count.at("asked").get<std::uint64_t>() - count.at("unsupported").get<std::uint64_t>();
    row.wrong += count.at("wrong").get<std::uint64_t>();
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
  return *std::ranges::min_element(cases, {}, [](const Case& c) {
    const bool is_ray = std::holds_alternative<Ray>(c.query.probe);
    return std::tuple(is_ray, is_special(c), length_of(c));
  });
}

}  // namespace tribunal
