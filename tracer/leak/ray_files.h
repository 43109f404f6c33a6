// Rays out, answers in: a mesh trial of a program that is linked with nothing.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json.h"
#include "tracer/leak/aim.h"
#include "tracer/leak/subject.h"

namespace tribunal::leak {

/// The surface as an OFF file: its vertices with all their digits, and its triangles in order. Read again it is the
/// same.
std::string to_off(const Surface& surface);

/// Ray k of the surface as a line of a ray file.
std::string to_line(const Surface& surface, const AimedRay& aimed, std::uint64_t k);

/// A ray file, whole.
struct RayFile {
  Format format = Format::binary64;
  std::vector<std::string> ids{};
  std::vector<AimedRay> rays{};
};

/// Fails with Exit::bad_input at a line that is no ray, an id that was there before, a ray of another format than those
/// before, a direction that is zero; and where there are no rays.
RayFile read_rays(const std::string& path);

/// What answers promise beside what they say.
struct Promises {
  Contract contract{};
  bool sorted = false;
  NormalSense sense = NormalSense::by_vertices;
  double most_ulps = 0, most_degrees = 0;
};

/// One subject for each kind of answer of each method that the file names: NAME/closest, /any, /all, /inside. A method
/// that gives one kind of answer to a ray gives it to all rays, or says "failed". Fails with Exit::bad_input where it
/// does not, and at a line that is no answer, an unknown id, a second answer, a face that the surface does not have.
std::vector<Subject> subjects_in(const std::string& path, const RayFile& rays, const Surface& surface,
                                 const Promises& promises);

}  // namespace tribunal::leak
