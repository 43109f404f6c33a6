// Construction bugs, planted on purpose: methods that promise exact answers and are wrong in one way each. They exist
// so that the tests can be tested; the released program has none of them.
#pragma once

#include <vector>

#include "core/method.h"

namespace tribunal::planted {

/// All bugs, "planted-…"; `summary` says what is wrong.
std::vector<Method> bugs();

/// The same code without the bugs, "sound-…"; the harness must never blame these.
std::vector<Method> sound_twins();

/// The bugs of polygon tests: methods that take polygons alone.
std::vector<Method> polygon_bugs();
std::vector<Method> sound_polygons();

/// A method with right answers that leaves its thread flushing subnormals to zero, which the harness must notice.
Method environment_bug();

/// The planted bugs of each file.
std::vector<Method> sign_bugs();
std::vector<Method> coplanar_bugs();
std::vector<Method> operand_bugs();
std::vector<Method> jimenez_bugs();
std::vector<Method> published_bugs();
std::vector<Method> filter_bugs();
std::vector<Method> contraction_bugs();
std::vector<Method> cgal_bugs();
std::vector<Method> range_bugs();
std::vector<Method> ray_bugs();
std::vector<Method> bounds_bugs();

Method sound_jimenez();
Method sound_filter();
Method sound_expansion();
Method sound_ray();
Method sound_bounds();

using Decision = std::function<Answer(const Segment&, const Triangle&)>;
using RayDecision = std::function<Answer(const Ray&, const Triangle&)>;

/// A method that claims to be exact on segments, and takes no rays unless it is given a decision about them.
Method method(const char* name, const char* what, Decision decide, RayDecision decide_ray = {});

/// A method that claims to be exact and is right on segments; `decide` answers rays.
Method ray_method(const char* name, const char* what, RayDecision decide);

/// The right answer, by Segura–Feito on EPICK.
Answer right(const Segment& s, const Triangle& t);
Answer right_of_ray(const Ray& r, const Triangle& t);

}  // namespace tribunal::planted
