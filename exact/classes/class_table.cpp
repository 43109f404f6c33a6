#include "exact/classes/class_table.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "exact/base/embedded.h"

namespace tribunal {
namespace {

/// Coordinates 0..4: every orientation of the representatives is exact in double.
using LatticeKernel = FormulaKernel<double>;

std::array<int, 3> parse_point(const std::string& text) {
  std::array<int, 3> p{};
  if (std::sscanf(text.c_str(), "%d,%d,%d", &p[0], &p[1], &p[2]) != 3) throw std::logic_error("class table: " + text);
  return p;
}

/// `before` is the id of "C001" or "R001" minus one.
ClassRow parse_row(const std::string& line, int before) {
  std::istringstream fields(line);
  std::vector<std::string> f;
  for (std::string field; std::getline(fields, field, '\t');) f.push_back(field);
  if (f.size() != 13) throw std::logic_error("class table: " + line);
  return {.id = static_cast<ClassId>(before + std::stoi(f[0].substr(1))),
          .rank = std::stoi(f[1]),
          .triangle = f[2],
          .probe = f[3],
          .intersection = f[4],
          .touches = f[5],
          .count_3 = std::stoull(f[6]),
          .count_4 = std::stoull(f[7]),
          .points = {parse_point(f[8]), parse_point(f[9]), parse_point(f[10]), parse_point(f[11]), parse_point(f[12])}};
}

std::vector<ClassRow> parse_table(const char* table, int before, std::size_t count) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::vector<ClassRow> rows;
  while (std::getline(lines, line)) rows.push_back(parse_row(line, before));
  if (rows.size() != count) throw std::logic_error("class table: expected " + std::to_string(count) + " rows");
  return rows;
}

Point3 to_point(const std::array<int, 3>& p) { return {p[0], p[1], p[2]}; }

Chirotope mirrored(const Chirotope& c, int signs) {
  int code = 1;
  for (int i = 0; i < signs; ++i) code *= 3;
  return {c.rank, static_cast<std::uint16_t>(code - 1 - c.code)};
}

/// Direct look-up by rank and code. A class contributes the chirotopes of its 12 labelled orders (6 of a ray) and their
/// mirrors.
class ChirotopeIndex {
 public:
  explicit ChirotopeIndex(std::span<const ClassRow> rows) {
    for (const ClassRow& row : rows) add(row);
  }

  ClassId find(const Chirotope& c) const { return ids_[static_cast<std::size_t>(c.rank - 1)][c.code]; }

 private:
  void add(const ClassRow& row) {
    std::array<Point3, 3> v{to_point(row.points[0]), to_point(row.points[1]), to_point(row.points[2])};
    std::array<int, 3> order{0, 1, 2};
    do {
      const auto at = [&](int i) { return v[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])]; };
      add(row, {at(0), at(1), at(2)});
    } while (std::next_permutation(order.begin(), order.end()));
  }

  void add(const ClassRow& row, const Triangle& t) {
    if (is_ray_class(row.id)) {
      add(chirotope(row.representative_ray(), t, LatticeKernel{}), row.id);
      return;
    }
    const Segment s = row.representative_segment();
    add(chirotope(s, t, LatticeKernel{}), row.id);
    add(chirotope(Segment{s.q, s.p}, t, LatticeKernel{}), row.id);
  }

  void add(const Chirotope& c, ClassId id) {
    constexpr int signs_of_rank[] = {0, 0, 10, 10, 5};
    put(c, id);
    put(mirrored(c, signs_of_rank[c.rank]), id);
  }

  void put(const Chirotope& c, ClassId id) {
    ClassId& entry = ids_[static_cast<std::size_t>(c.rank - 1)][c.code];
    if (entry != 0 && entry != id) throw std::logic_error("class table: one chirotope in two classes");
    entry = id;
  }

  static constexpr std::size_t codes = 59049;  // 3¹⁰
  std::vector<std::array<ClassId, codes>> ids_{4};
};

}  // namespace

Contact ClassRow::contact() const {
  if (!hit()) return Contact::none;
  if (rank < 4) return Contact::coplanar;
  switch (touches.back()) {
    case 'F':
      return Contact::interior;
    case 'E':
      return Contact::edge;
    default:
      return Contact::vertex;
  }
}

Segment ClassRow::representative_segment() const { return {to_point(points[3]), to_point(points[4])}; }

Ray ClassRow::representative_ray() const { return {to_point(points[3]), {to_point(points[4])}}; }

Probe ClassRow::representative_probe() const {
  if (is_ray_class(id)) return representative_ray();
  return representative_segment();
}

Triangle ClassRow::representative_triangle() const {
  return {to_point(points[0]), to_point(points[1]), to_point(points[2])};
}

std::span<const ClassRow> class_table() {
  static const std::vector<ClassRow> rows = parse_table(embedded_classes163, 0, class_count);
  return rows;
}

std::span<const ClassRow> ray_class_table() {
  static const std::vector<ClassRow> rows = parse_table(embedded_ray_classes, class_count, ray_class_count);
  return rows;
}

const ClassRow& class_row(ClassId id) {
  const auto index = static_cast<std::size_t>(id) - 1;
  return is_ray_class(id) ? ray_class_table()[index - class_count] : class_table()[index];
}

std::string class_name(ClassId id) {
  if (id == 0) return "";
  const std::string digits = std::to_string(is_ray_class(id) ? id - class_count : id);
  return (is_ray_class(id) ? "R" : "C") + std::string(3 - digits.size(), '0') + digits;
}

ClassId class_named(std::string_view name) {
  int number = 0;
  if (name.size() != 4 || (name[0] != 'C' && name[0] != 'R')) return 0;
  const bool of_rays = name[0] == 'R';
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + 4, number);
  const int count = of_rays ? ray_class_count : class_count;
  const bool known = error == std::errc{} && end == name.data() + 4 && number >= 1 && number <= count;
  return known ? static_cast<ClassId>(of_rays ? class_count + number : number) : ClassId{0};
}

ClassId class_of(const Chirotope& c) {
  static const ChirotopeIndex index(class_table());
  return index.find(c);
}

ClassId ray_class_of(const Chirotope& c) {
  static const ChirotopeIndex index(ray_class_table());
  return index.find(c);
}

}  // namespace tribunal
