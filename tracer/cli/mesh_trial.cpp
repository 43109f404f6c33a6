#include "tracer/cli/mesh_trial.h"

#include <algorithm>
#include <filesystem>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/record/counterexample.h"
#include "exact/record/environment.h"
#include "tracer/leak/paint.h"

namespace tribunal {
namespace {

using namespace leak;

std::string name_of_mesh(const MeshTrialOptions& o) { return std::filesystem::path(o.mesh).filename().string(); }

std::string about(const Surface& s, const LeakReport& r) {
  std::string text = std::string(name_of(s.format())) + ": " + std::to_string(s.face_count()) + " faces, " +
                     describe(s.topology()) + "; " + std::to_string(r.rays) + " rays, " + std::to_string(r.inside) +
                     " from inside, " + std::to_string(r.exactly) + " exactly through an edge or a vertex";
  if (r.skipped > 0) text += "; " + std::to_string(r.skipped) + " not judged: no start off the surface was found";
  if (!s.topology().closed()) text += "\nthe mesh is not closed: it has no inside, and parity is not judged";
  return text + "\n";
}

/// "my-tree/closest" as part of a file's name.
std::string file_name(const Subject& subject) {
  std::string name = subject.name;
  std::ranges::replace(name, '/', '-');
  return name;
}

Json summary_of(const MeshTrial& trial, const MeshTrialOptions& o) {
  return {{"mesh", name_of_mesh(o)},
          {"seed", o.seed},
          {"command", o.command},
          {"trials", trial.summaries},
          {"environment", environment()}};
}

/// Painted meshes of an earlier trial.
void drop_pictures(OutputSet& set, const MeshTrial& trial, const std::string& directory) {
  for (const std::string& path : files_in(directory)) {
    const std::string file = path.substr(path.rfind('/') + 1);
    const bool painted = file.ends_with("-binary32.ply") || file.ends_with("-binary64.ply");
    const bool again = std::ranges::any_of(trial.pictures, [&](const auto& picture) { return picture.first == file; });
    if (painted && !again) set.drop(path);
  }
}

void write(const MeshTrial& trial, const MeshTrialOptions& o) {
  make_directory(o.out);
  OutputSet set;
  drop_pictures(set, trial, o.out);
  for (const auto& [file, bytes] : trial.pictures) set.add(o.out + "/" + file, bytes);
  set.add(o.out + "/cases.jsonl", to_lines(trial.cases));
  set.add(o.out + "/summary.json", summary_of(trial, o).dump(1) + "\n");
  set.commit();
}

void show(const MeshTrial& trial, const MeshTrialOptions& o, const std::string& first) {
  if (o.json) return print(summary_of(trial, o).dump(1) + "\n");
  print(first + trial.text + trial.verdicts);
  if (o.out.empty()) return;
  const std::size_t cases = trial.cases.size();
  print(std::to_string(cases) + " cases in " + o.out + "/cases.jsonl" +
        (cases == 0 ? "" : "; `tribunal replay` shows them") + "\n");
}

}  // namespace

void add(MeshTrial& trial, const MeshTrialOptions& o, const Surface& surface, const std::vector<Subject>& subjects,
         const LeakReport& report) {
  if (report.rays == 0) throw Failure(Exit::resources, o.mesh + ": no ray could be judged");
  trial.text += about(surface, report) + table(subjects, report, surface.format(), o.by_aim) + "\n";
  trial.summaries.push_back(summary(surface, subjects, report));
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const SubjectReport& s = report.subjects[i];
    trial.erred |= has_erred(s);
    trial.verdicts += verdict(surface, subjects[i], report, s) + worst_faces(s, 3);
    if (o.out.empty()) continue;
    const auto cases = cases_of(surface, subjects[i], s, name_of_mesh(o), o.seed);
    trial.cases.insert(trial.cases.end(), cases.begin(), cases.end());
    const std::string file = file_name(subjects[i]) + "-" + std::string(name_of(surface.format())) + ".ply";
    if (has_erred(s)) trial.pictures.emplace_back(file, painted(surface, s));
  }
}

int finish(const MeshTrial& trial, const MeshTrialOptions& o, const std::string& first) {
  if (!o.out.empty()) write(trial, o);
  show(trial, o, first);
  return code(trial.erred ? Exit::disagreement : Exit::ok);
}

}  // namespace tribunal
