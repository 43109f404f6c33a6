// tribunal judge --mesh: answers about the rays of a mesh, computed anywhere.
#pragma once

#include <string>

#include "tracer/cli/mesh_trial.h"
#include "tracer/leak/ray_files.h"

namespace tribunal {

struct MeshAnswers {
  MeshTrialOptions trial{};
  std::string rays{}, answers{};
  leak::Promises promises{};
};

/// Judges the answers as `tribunal leak` judges those of a library, and returns the exit code.
int judge_mesh_answers(const MeshAnswers& o);

}  // namespace tribunal
