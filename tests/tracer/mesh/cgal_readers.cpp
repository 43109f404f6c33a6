#include "tracer/mesh/cgal_readers.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>

namespace tribunal {
namespace {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalPoints = std::vector<CgalPoint>;
using Polygons = std::vector<std::vector<std::size_t>>;

bool read_with_cgal(MeshFormat format, std::istream& in, CgalPoints& points, Polygons& polygons) {
  switch (format) {
    case MeshFormat::off:
      return CGAL::IO::read_OFF(in, points, polygons);
    case MeshFormat::obj:
      return CGAL::IO::read_OBJ(in, points, polygons);
    case MeshFormat::ply:
      return CGAL::IO::read_PLY(in, points, polygons);
    case MeshFormat::stl:
      return CGAL::IO::read_STL(in, points, polygons);
  }
  return false;
}

}  // namespace

bool read_soup(MeshFormat format, const std::string& bytes, PolygonSoup& soup) {
  std::istringstream in(bytes);
  in.imbue(std::locale::classic());
  CgalPoints points;
  try {
    if (!read_with_cgal(format, in, points, soup.polygons)) return false;
  } catch (const std::bad_alloc&) {
    throw;  // the machine's shortage, not the file's fault: the scan bounds what the file may ask for
  } catch (const std::exception&) {
    return false;  // CGAL's assertions are exceptions
  }
  soup.points.reserve(points.size());
  for (const CgalPoint& p : points) soup.points.emplace_back(p.x(), p.y(), p.z());
  return true;
}

}  // namespace tribunal
