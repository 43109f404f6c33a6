#include "tests/exact/mesh/cgal_readers.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>

namespace tribunal::testing {
namespace {

struct CgalSoup {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

bool read(const std::string& file, std::istream& in, CgalSoup& soup) {
  if (file.ends_with(".off")) return CGAL::IO::read_OFF(in, soup.points, soup.faces);
  if (file.ends_with(".obj")) return CGAL::IO::read_OBJ(in, soup.points, soup.faces);
  if (file.ends_with(".ply")) return CGAL::IO::read_PLY(in, soup.points, soup.faces);
  return CGAL::IO::read_STL(in, soup.points, soup.faces);
}

}  // namespace

std::optional<PolygonSoup> cgal_soup(const std::string& file, const std::string& bytes) {
  std::istringstream in(bytes);
  in.imbue(std::locale::classic());
  CgalSoup read_soup;
  try {
    if (!read(file, in, read_soup)) return std::nullopt;
  } catch (const std::logic_error&) {
    return std::nullopt;  // CGAL's assertions
  }
  PolygonSoup soup;
  for (const auto& p : read_soup.points) soup.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& face : read_soup.faces) {
    for (const std::size_t i : face) soup.corners.push_back(static_cast<std::uint32_t>(i));
    soup.end_face();
  }
  return soup;
}

}  // namespace tribunal::testing
