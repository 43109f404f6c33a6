#include "exact/cases/case_scan.h"

#include <bit>
#include <cstdint>

#include "exact/base/foreign_json.h"
#include "exact/base/json.h"
#include "exact/base/scan.h"
#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

enum Key : unsigned {
  id = 1,
  fmt = 2,
  seg = 4,
  ray = 8,
  tri = 16,
  rings = 32,
  expect = 64,
  class_ = 128,
  source = 256
};

unsigned key_named(std::string_view name) {
  constexpr struct {
    std::string_view name;
    Key key;
  } table[] = {{"id", id},       {"fmt", fmt},       {"seg", seg},      {"ray", ray},      {"tri", tri},
               {"rings", rings}, {"expect", expect}, {"class", class_}, {"source", source}};
  for (const auto& row : table) {
    if (row.name == name) return row.key;
  }
  return 0;
}

/// A finite number that is exact in binary32 by its bits alone; others may be.
bool is_plainly_binary32(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t exponent = bits >> 52 & 0x7ff;
  return (bits & 0x1fff'ffff) == 0 && exponent >= 1023 - 126 && exponent <= 1023 + 127;
}

class CaseScanner {
 public:
  CaseScanner(std::string_view line, Case& c) : s_(line), c_(c) {}

  bool read() {
    c_.format = Format::binary64;
    c_.query.bounds.reset();
    c_.expect.reset();
    c_.class_id = 0;
    c_.source.clear();
    if (!c_.finding.is_null()) c_.finding = nullptr;
    const auto value_of = [this](unsigned key) { return value(key); };
    return s_.object(seen_, key_named, value_of) && s_.at_end() && is_whole();
  }

 private:
  bool value(unsigned key) {
    std::string_view text;
    switch (key) {
      case id:
        if (!s_.text(text)) return false;
        c_.id.assign(text);
        return true;
      case fmt:
        if (!s_.text(text)) return false;
        c_.format = text == "binary32" ? Format::binary32 : Format::binary64;
        return text == "binary32" || text == "binary64";
      case seg:
        return segment();
      case ray:
        return this->a_ray();
      case tri:
        return triangle();
      case rings:
        return polygon();
      case expect: {
        bool hit = false;
        if (!s_.bit(hit)) return false;
        c_.expect = hit;
        return true;
      }
      case class_:
        if (!s_.text(text)) return false;
        c_.class_id = class_named(text);
        return c_.class_id != 0;
      default:
        if (!s_.text(text)) return false;
        c_.source.assign(text);
        return true;
    }
  }

  bool number(double& x) {
    if (!s_.number(x)) return false;
    if (fits_binary32_ && !is_plainly_binary32(x)) fits_binary32_ = is_exact_in(x, Format::binary32);
    return true;
  }

  bool point(Point3& p) {
    return s_.take('[') && number(p.x) && s_.take(',') && number(p.y) && s_.take(',') && number(p.z) && s_.take(']');
  }

  bool segment() {
    Segment s{};
    if (!(s_.take('[') && point(s.p) && s_.take(',') && point(s.q) && s_.take(']'))) return false;
    c_.query.probe = s;
    return true;
  }

  bool triangle() {
    Triangle t{};
    if (!(s_.take('[') && point(t.a) && s_.take(',') && point(t.b) && s_.take(',') && point(t.c) && s_.take(']')))
      return false;
    c_.query.target = t;
    return true;
  }

  bool a_ray() {
    Ray r{};
    bool o = false, d = false, t = false;
    if (!s_.take('{')) return false;
    do {
      std::string_view name;
      if (!s_.text(name) || !s_.take(':')) return false;
      bool& seen = name == "o" ? o : name == "d" ? d : t;
      if (seen || (&seen == &t && name != "t")) return false;
      seen = true;
      if (!(&seen == &o ? point(r.o) : &seen == &d ? point(r.d.v) : bounds())) return false;
    } while (s_.take(','));
    c_.query.probe = r;
    return s_.take('}') && o && d;
  }

  bool bounds() {
    Bounds b{};
    if (!(s_.take('[') && number(b.tmin) && s_.take(','))) return false;
    const char* const place = s_.place();
    std::string_view word;
    if (!s_.text(word) || word != "inf") {
      s_.return_to(place);
      if (!number(b.tmax)) return false;
    }
    c_.query.bounds = b;
    return s_.take(']') && b.tmin >= 0 && b.tmax >= b.tmin;
  }

  bool polygon() {
    if (!std::holds_alternative<PolygonData>(c_.query.target)) c_.query.target.emplace<PolygonData>();
    PolygonData& p = c_.query.polygon();
    p.vertices.clear();
    p.ends.clear();
    if (!s_.take('[')) return false;
    do {
      if (!s_.take('[')) return false;
      do {
        if (!point(p.vertices.emplace_back())) return false;
      } while (s_.take(','));
      if (!s_.take(']')) return false;
      p.ends.push_back(p.vertices.size());
    } while (s_.take(','));
    return s_.take(']');
  }

  /// What to_case demands beside the types.
  bool is_whole() const {
    const bool one_probe = ((seen_ & seg) != 0) != ((seen_ & ray) != 0);
    const bool one_target = ((seen_ & tri) != 0) != ((seen_ & rings) != 0);
    if ((seen_ & id) == 0 || !one_probe || !one_target) return false;
    if ((seen_ & rings) != 0 && ((seen_ & class_) != 0 || c_.query.bounds)) return false;
    return c_.format == Format::binary64 || fits_binary32_;
  }

  Scanner s_;
  Case& c_;
  unsigned seen_ = 0;
  bool fits_binary32_ = true;
};

}  // namespace

bool scan_case(std::string_view line, Case& c) { return CaseScanner(line, c).read(); }

void read_case(std::string_view line, const std::string& path, std::size_t number, Case& c) {
  if (scan_case(line, c)) return;
  const Where where{path, number};
  c = to_case(parse_json_beyond(line, where), where);
}

}  // namespace tribunal
