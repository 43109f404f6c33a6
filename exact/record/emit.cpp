#include "exact/record/emit.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/shown.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/record/five_signs.h"
#include "exact/trial/describe.h"

namespace tribunal {
namespace {

/// A number that C, C++ and Python's float.fromhex read back as it is.
std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}

template <class Write>
std::string joined(std::initializer_list<Point3> points, const Write& write) {
  std::string text;
  for (const Point3& p : points) {
    for (int axis = 0; axis < 3; ++axis) text += (text.empty() ? "" : ", ") + write(p[axis]);
  }
  return text;
}

const Point3& vector_of(const Point3& p) { return p; }
const Point3& vector_of(const Direction& d) { return d.v; }

/// The text for a comment of any of the languages: on one line, and with neither end of a comment in it. An id is
/// anything that a file says, and must not become code.
std::string as_comment(const std::string& from) {
  constexpr std::size_t longest = 400;
  std::string text = shown_shortly(from, longest);
  for (const char* mark : {"*/", "/*"}) {
    for (std::size_t at; (at = text.find(mark)) != std::string::npos;) text.insert(at + 1, " ");
  }
  return text;
}

/// A name for a test: of letters, digits and _, and of a length that compilers take.
std::string as_name(const std::string& text) {
  constexpr std::size_t longest = 80;
  std::string name = text.substr(0, longest);
  for (char& letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  }
  return name;
}

/// What a test needs of a case, as text.
struct Parts {
  std::string name;     ///< of letters, digits and _
  std::string comment;  ///< id and exact answer
  std::string kind;     ///< "segment", "ray" or "ray_within"
  std::string probe{}, triangle{};
  std::string bounds{};  ///< of a ray with bounds
  bool hit;
};

template <class Write>
Parts parts_of(const Case& c, std::size_t number, const Write& write) {
  const Truth truth = exact_truth(c.query);
  Parts parts{.name = "case_" + std::to_string(number) + "_" + as_name(c.id),
              .comment = as_comment(c.id + ": " + describe(truth)),
              .kind = c.query.bounds       ? "ray_within"
                      : is_of_ray(c.query) ? "ray"
                                           : "segment",
              .hit = truth.hit()};
  if (const auto& b = c.query.bounds) {
    parts.bounds = write(b->tmin) + ", " + (std::isinf(b->tmax) ? "INFINITY" : write(b->tmax));
  }
  const Triangle& t = c.query.triangle();
  parts.triangle = joined({t.a, t.b, t.c}, write);
  parts.probe = std::visit(
      [&](const auto& p) {
        return joined({source(p), vector_of(target(p))}, write);
      },
      c.query.probe);
  return parts;
}

std::string arrays(const Parts& p) {
  const std::string bounds = p.bounds.empty() ? "" : "  const double bounds[2] = {" + p.bounds + "};\n";
  return "  const double probe[6] = {" + p.probe + "};\n" + bounds + "  const double triangle[9] = {" + p.triangle +
         "};\n";
}

std::string call(const Parts& p, const std::string& function) {
  return function + "_" + p.kind + (p.bounds.empty() ? "(probe, triangle)" : "(probe, bounds, triangle)");
}

bool any_bounds(const std::vector<Parts>& all) {
  return std::ranges::any_of(all, [](const Parts& p) { return !p.bounds.empty(); });
}

std::string c_test(const Parts& p, const std::string& function) {
  return "/* " + p.comment + " */\nstatic void " + p.name + "(void) {\n" + arrays(p) + "  assert(" + call(p, function) +
         (p.hit ? " == 1" : " == 0") + ");\n}\n\n";
}

std::string declarations(const std::string& function, const std::vector<Parts>& all) {
  std::string text;
  if (any_bounds(all)) {
    text +=
        "int " + function + "_ray_within(const double probe[6], const double bounds[2], const double triangle[9]);\n";
  }
  for (const char* kind : {"segment", "ray"}) {
    text += "int " + function + "_" + kind + "(const double probe[6], const double triangle[9]);\n";
  }
  return text + "\n";
}

std::string c_file(const std::vector<Parts>& all, const std::string& function) {
  std::string text = "#undef NDEBUG\n#include <assert.h>\n", calls;
  text += (any_bounds(all) ? "#include <math.h>\n\n" : "\n") + declarations(function, all);
  for (const Parts& p : all) {
    text += c_test(p, function);
    calls += "  " + p.name + "();\n";
  }
  return text + "int main(void) {\n" + calls + "  return 0;\n}\n";
}

std::string gtest_file(const std::vector<Parts>& all, const std::string& function) {
  std::string text = "#include <gtest/gtest.h>\n\n";
  if (any_bounds(all)) text += "#include <cmath>\n\n";
  text += "extern \"C\" {\n" + declarations(function, all);
  text.replace(text.size() - 1, 1, "}\n\n");
  for (const Parts& p : all) {
    text += "// " + p.comment + "\nTEST(Tribunal, " + p.name + ") {\n" + arrays(p) + "  EXPECT_EQ(" +
            call(p, function) + ", " + (p.hit ? "1" : "0") + ");\n}\n\n";
  }
  text.pop_back();
  return text;
}

std::string signs_of(const Query& query) {
  std::string text;
  for (const Sign s : five_signs(query, RationalKernel{}))
    text += (text.empty() ? "" : ", ") + std::to_string(value(s));
  return text;
}

/// The sides of the plane at both bounds, as an assertion; at infinity, the side to which the ray runs.
std::string sides_in_python(const Query& query) {
  const Ray& ray = std::get<Ray>(query.probe);
  const Triangle& t = query.triangle();
  const RationalKernel k;
  const auto at = [](double x) { return "volume(a, b, c, at(p, q, '" + hex(x) + "'))"; };
  return decide_within(ray, *query.bounds, [&](const auto& part) {
    const bool endless = std::isinf(query.bounds->tmax);
    return "assert [" + at(query.bounds->tmin) + ", " +
           (endless ? "volume(a, b, c, q, True)" : at(query.bounds->tmax)) + "] == [" +
           std::to_string(value(k.orient3d(t.a, t.b, t.c, source(part)))) + ", " +
           std::to_string(value(k.orient3d(t.a, t.b, t.c, target(part)))) + "]\n";
  });
}

constexpr const char* python_head = R"(from fractions import Fraction


def numbers(*texts):
    flat = [Fraction(float.fromhex(t)) for t in texts]
    return [flat[i:i + 3] for i in range(0, len(flat), 3)]


def minus(x, o):
    return [a - b for a, b in zip(x, o)]


def at(o, d, t):
    """The point o + t*d of a ray."""
    return [x + Fraction(float.fromhex(t)) * v for x, v in zip(o, d)]


def volume(o, b, c, x, x_is_direction=False):
    """The sign of the determinant of b - o, c - o and x - o (or the direction x itself)."""
    u, v, w = minus(b, o), minus(c, o), x if x_is_direction else minus(x, o)
    d = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))
    return (d > 0) - (d < 0)


def signs(p, q, a, b, c, ray):
    return [volume(a, b, c, p), volume(a, b, c, q, ray), volume(p, a, b, q, ray), volume(p, b, c, q, ray),
            volume(p, c, a, q, ray)]


)";

std::string python_file(const std::vector<Parts>& all, const std::vector<Case>& cases) {
  std::string text = python_head;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Parts& p = all[i];
    text += "# " + p.comment + "\np, q = numbers(" + p.probe + ")\na, b, c = numbers(" + p.triangle +
            ")\nassert signs(p, q, a, b, c, " + (p.kind == "segment" ? "False" : "True") + ") == [" +
            signs_of(cases[i].query) + "]\n" + (p.bounds.empty() ? "" : sides_in_python(cases[i].query));
  }
  return text;
}

}  // namespace

bool is_function_name(std::string_view text) {
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 && std::ranges::all_of(text, fits);
}

std::vector<std::string> emitted_languages() { return {"c", "gtest", "python"}; }

std::string emit(const std::vector<Case>& cases, std::string_view language, const std::string& function,
                 const std::string& file) {
  const auto quoted = [](double x) { return "'" + hex(x) + "'"; };
  std::vector<Parts> all;
  std::vector<Case> asked;
  std::string left_out;
  for (const Case& c : cases) {
    if (c.query.operands() != Operands::triangles)
      throw bad_input(file, 0, shown(c.id) + " is of a polygon, expected triangles");
    if (!is_finite(c.query)) {
      const std::string why = as_comment(c.id + ": no test, a number is not finite");
      left_out += language == "python" ? "# " + why + "\n" : "/* " + why + " */\n";
      continue;
    }
    asked.push_back(c);
    all.push_back(language == "python" ? parts_of(c, all.size() + 1, quoted) : parts_of(c, all.size() + 1, hex));
  }
  if (language == "python") return left_out + python_file(all, asked);
  return left_out + (language == "c" ? c_file(all, function) : gtest_file(all, function));
}

}  // namespace tribunal
