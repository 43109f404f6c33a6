// A user of the predicates: single, of a polygon, and many at once.
#include <iostream>
#include <vector>

#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_polygon.h"

int main() {
  using namespace tribunal;
  const Segment segment{{1, 1, -1}, {1, 1, 1}};
  const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  PolygonData square;
  square.add(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const std::vector<double> zero{0}, four{4};
  std::vector<std::uint8_t> hit(1);
  hits(segment, TriangleColumns{{zero, zero, zero}, {four, zero, zero}, {zero, four, zero}}, hit);
  std::cout << hits(segment, triangle) << FilteredPolygon(square).hits(segment) << int{hit[0]} << " "
            << name_of(classify(segment, triangle).contact) << "\n";
}
