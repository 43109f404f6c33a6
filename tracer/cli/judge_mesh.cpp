#include "tracer/cli/judge_mesh.h"

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/cli/command.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"

namespace tribunal {

int judge_mesh_answers(const MeshAnswers& o) {
  if (o.rays == "-" && o.answers == "-") throw Failure(Exit::usage, "--rays and --answers are both standard input");
  const std::string& path = o.trial.mesh;
  const leak::RayFile rays = leak::read_rays(o.rays);
  const leak::Surface surface(triangulated(read_mesh(path), path), rays.format, path);
  const std::vector<leak::Subject> subjects = subjects_in(o.answers, rays, surface, o.promises);
  const leak::LeakReport report =
      run_leak_trial(surface, subjects, {.given = rays.rays, .threads = o.trial.threads, .keep = o.trial.keep});
  if (!report.complete) return print("INTERRUPTED\n"), exit_code_after(code(Exit::ok), report.signal);
  MeshTrial trial;
  add(trial, o.trial, surface, subjects, report);
  return finish(trial, o.trial, "");
}

}  // namespace tribunal
