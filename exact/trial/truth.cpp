#include "exact/trial/truth.h"

#include "exact/base/failure.h"
#include "exact/cases/case_line.h"
#include "exact/classes/class_table.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {
namespace {

/// Whether the exact answer is what the construction says. A corner or edge that the polygon has twice is met too.
bool fits(const Construction& made, const Truth& truth) {
  if (!truth.planar || truth.hit() != is_met(made.place)) return false;
  const bool on_a_line = truth.contact == Contact::coplanar;
  if (!is_boundary(made.place)) return !truth.hit() || truth.contact == Contact::interior;
  return on_a_line || truth.contact == (is_vertex(made.place) ? Contact::vertex : Contact::edge);
}

}  // namespace

void contradiction(const Query& query, const std::string& one, const std::string& other) {
  throw Failure(Exit::oracles_contradict,
                "oracles contradict each other: " + one + ", " + other + ", on " + case_line("contradiction", query));
}

void require_fit(const Trial& trial, const Truth& truth) {
  if (trial.class_id != 0 && trial.class_id != truth.class_id) {
    contradiction(trial.query, "construction says " + class_name(trial.class_id),
                  "the oracles say " + class_name(truth.class_id));
  }
  if (trial.construction && !fits(*trial.construction, truth)) {
    contradiction(trial.query, "constructed as " + std::string(name_of(trial.construction->place)),
                  "the oracles say " + std::string(name_of(truth.contact)));
  }
}

Truth truth_of_class(ClassId id) {
  return {.class_id = id, .contact = class_row(id).contact(), .of_ray = is_ray_class(id)};
}

Truth truth_in_class(ClassId id, const Query& query) {
  Truth truth = truth_of_class(id);
  truth.facing = facing_in(truth.contact, query, EpickKernel{});
  return narrowed(truth, query, EpickKernel{});
}

Truth exact_truth(const Query& query) {
  if (!is_finite(query)) {
    throw Failure(Exit::bad_input, "no exact answer: a number is not finite, in " + case_line("nonfinite", query));
  }
  return query.operands() == Operands::triangles ? exact_truth_of_triangle(query) : exact_truth_of_polygon(query);
}

Truth truth_of(const Trial& trial, std::uint64_t k) {
  if (trial.class_id != 0 && k % 257 != 0) return truth_in_class(trial.class_id, trial.query);
  const Truth truth = exact_truth(trial.query);
  require_fit(trial, truth);
  return truth;
}

const char* const judges_of_triangles =
    "class table, Segura-Feito and Caratheodory on integers of fixed width, or GMP's; 1 case in 256, drawn by a hash, "
    "by "
    "class table, rational kernel, Caratheodory, CGAL where defined";

const char* oracle_of(const Family& family) {
  if (family.operands == Operands::triangles) {
    return family.constructs ? "construction, 1 case in 257 also by class table, Segura-Feito and Caratheodory on "
                               "integers of fixed width, or GMP's; 1 in 256, drawn by a hash, by class table, rational "
                               "kernel, Caratheodory, CGAL where defined"
                             : judges_of_triangles;
  }
  return family.constructs ? "construction, rational kernel, point in rings twice, covering surface, Caratheodory"
                           : oracles_of(family.operands);
}

const char* oracles_of(Operands operands) {
  return operands == Operands::triangles ? "class table, rational kernel, Caratheodory, CGAL where defined"
                                         : "rational kernel, point in rings twice, covering surface, Caratheodory";
}

}  // namespace tribunal
