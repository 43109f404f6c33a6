#include "exact/trial/formulations.h"

#include "exact/classes/class_table.h"
#include "exact/trial/formulations_on.h"
#include "exact/trial/quick_truth.h"

namespace tribunal {

Truth truth_by_formulations(const Query& query) { return truth_by_formulations_on<BoundedInteger>(query); }

const char* formulations_in_words() {
  return "class table, Segura-Feito and Caratheodory on integers of fixed width, or GMP's where those do not hold the "
         "operands";
}

Truth formulated_truth(const Trial& trial, std::uint64_t k, bool needs_facing, TruthBy formulations) {
  if (trial.query.bounds) return truth_of(trial, k);
  if (trial.class_id != 0 && k % 257 != 0) {
    return needs_facing ? truth_in_class(trial.class_id, trial.query) : truth_of_class(trial.class_id);
  }
  const Truth truth = formulations(trial.query);
  require_fit(trial, truth);
  return truth;
}

Truth audited_by_oracles(const Trial& trial, TruthBy formulations) {
  const Truth truth = exact_truth(trial.query);
  require_fit(trial, truth);
  if (trial.query.bounds) return truth;
  const Truth quick = formulations(trial.query);
  if (quick.class_id != truth.class_id || quick.facing != truth.facing) {
    contradiction(trial.query, "on integers the class is " + class_name(quick.class_id),
                  "the oracles say " + class_name(truth.class_id));
  }
  return truth;
}

Truth truth_of_own(const Query& query, std::uint64_t number) {
  if (query.operands() == Operands::polygons || query.bounds) return exact_truth(query);
  if (!is_audited(0, 0, number)) return truth_by_formulations(query);
  const Trial trial{.query = query};
  return audited_by_oracles(trial, truth_by_formulations);
}

const char* judges_of_own(Operands operands) {
  return operands == Operands::triangles ? judges_of_triangles : oracles_of(operands);
}

}  // namespace tribunal
