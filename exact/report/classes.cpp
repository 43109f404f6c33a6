#include "exact/report/classes.h"

#include <string_view>

#include "exact/base/json.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/record/five_signs.h"
#include "exact/report/drawing.h"

namespace tribunal {
namespace {

std::string triangle_in_words(const std::string& triangle) {
  if (triangle == "col") return "a triangle without area, whose vertices lie on a line";
  if (triangle == "dup") return "a triangle without area, two vertices of which are equal";
  if (triangle == "pt") return "a triangle that is one point";
  return "a triangle";
}

std::string probe_in_words(const ClassRow& row) {
  if (row.probe != "pt") return is_ray_class(row.id) ? "A ray" : "A segment";
  return is_ray_class(row.id) ? "A ray without direction, which is one point," : "A segment that is one point";
}

std::string span_in_words(int rank) {
  constexpr const char* words[] = {"", "all at one place", "all on one line", "all in one plane", "not in one plane"};
  return words[rank];
}

/// "end/E": which part of the probe is where in the triangle.
struct Touch {
  std::string_view part, where;
};

Touch touch_in(std::string_view text) {
  const std::size_t slash = text.find('/');
  return {text.substr(0, slash), text.substr(slash + 1)};
}

std::string part_in_words(std::string_view part, const ClassRow& row) {
  if (row.probe == "pt") return "the point";
  if (part == "origin") return "the ray's origin";
  if (part == "end") return "an end of the segment";
  return is_ray_class(row.id) ? "a point of the ray after its origin" : "a point between the segment's ends";
}

std::string where_in_words(std::string_view where) {
  return where == "V" ? "a vertex" : where == "E" ? "an edge" : "the inside of the triangle";
}

std::string point_in_words(const ClassRow& row) {
  const Touch touch = touch_in(row.touches);
  const std::string verb = touch.where == "V" ? " is " : touch.where == "E" ? " lies on " : " lies in ";
  return "meet in one point: " + part_in_words(touch.part, row) + verb + where_in_words(touch.where);
}

/// "origin/E & int/V mid/F": one end of what is common, the other, and what lies between.
std::string stretch_in_words(const ClassRow& row) {
  const std::string_view text = row.touches;
  const std::size_t both = text.find(" & "), middle = text.rfind(' ');
  const Touch from = touch_in(text.substr(0, both)), to = touch_in(text.substr(both + 3, middle - both - 3));
  const Touch between = touch_in(text.substr(middle + 1));
  const auto end = [&](const Touch& t) {
    return part_in_words(t.part, row) +
           (t.where == "V"   ? " at "
            : t.where == "E" ? " on "
                             : " in ") +
           where_in_words(t.where);
  };
  const std::string way = between.where == "F"   ? "through the inside of the triangle"
                          : between.where == "E" ? "along an edge"
                                                 : "at a vertex";
  return "meet in a segment: from " + end(from) + " to " + end(to) + ", " + way;
}

Json points_of(const ClassRow& row) {
  Json points = Json::array();
  for (const auto& p : row.points) points.push_back({p[0], p[1], p[2]});
  return points;
}

Json signs_of(const ClassRow& row) {
  Json signs = Json::array();
  for (const Sign s : five_signs({row.representative_probe(), row.representative_triangle()}, RationalKernel{})) {
    signs.push_back(value(s));
  }
  return signs;
}

Json to_json(const ClassRow& row) {
  const bool transversal = row.hit() && row.contact() != Contact::coplanar;
  return {{"id", class_name(row.id)},
          {"rank", row.rank},
          {"triangle", row.triangle},
          {"probe", row.probe},
          {"intersection", row.intersection},
          {"touches", row.touches},
          {"hit", row.hit()},
          {"contact", name_of(row.contact())},
          {"words", in_words(row)},
          {"points", points_of(row)},
          {"signs", signs_of(row)},
          {"also", {{"transversal", transversal ? 1 : 0}}},
          {"sketch", to_json(drawing_of(row))}};
}

}  // namespace

std::string in_words(const ClassRow& row) {
  const std::string meeting = !row.hit()                    ? "do not meet"
                              : row.intersection == "point" ? point_in_words(row)
                                                            : stretch_in_words(row);
  return probe_in_words(row) + " and " + triangle_in_words(row.triangle) + ", " + span_in_words(row.rank) + ", " +
         meeting + ".";
}

Json classes_json() {
  Json all = Json::array();
  for (const auto& table : {class_table(), ray_class_table()}) {
    for (const ClassRow& row : table) all.push_back(to_json(row));
  }
  return all;
}

}  // namespace tribunal
