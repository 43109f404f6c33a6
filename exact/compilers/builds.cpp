#include "exact/compilers/builds.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/fp_environment.h"
#include "exact/compilers/battery.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

template <class P>
Answer answer(tribunal_battery_ask* ask, const P& probe, const Triangle& t) {
  double query[15];
  double* at = query;
  const auto put = [&](const Point3& p) {
    for (int i = 0; i < 3; ++i) *at++ = p[i];
  };
  put(source(probe));
  if constexpr (std::is_same_v<P, Ray>) {
    put(probe.d.v);
  } else {
    put(target(probe));
  }
  for (const Point3& v : {t.a, t.b, t.c}) put(v);
  return ask(std::is_same_v<P, Ray>, query) != 0 ? hit_at(Contact::unsaid) : miss();
}

/// The method of the table, with the answers of a build and nothing else that computes.
Method method_of(const tribunal_battery_entry& entry, const std::string& file) {
  const std::string name = entry.name + std::string(entry.bits == 32 ? "-float" : "-double");
  const Method* const known = find_method(name);
  if (known == nullptr) throw bad_input(file, 0, "has a method " + name + ", which this program does not know");
  Method m{.name = name, .card = known->card, .contract = known->contract};
  m.segment = [ask = entry.ask](const Segment& s, const Triangle& t) { return answer(ask, s, t); };
  m.ray = [ask = entry.ask, takes = m.contract.probes.rays](const Ray& r, const Triangle& t) {
    return takes ? answer(ask, r, t) : refusal(Status::unsupported);
  };
  return m;
}

}  // namespace

Build load_build(const std::string& file) {
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw bad_input(file, 0, std::string("cannot be loaded: ") + dlerror());
  const auto describe = reinterpret_cast<tribunal_battery_function*>(dlsym(library, "tribunal_battery_describe"));
  if (describe == nullptr) throw bad_input(file, 0, "exports no methods, expected a build of them");
  const tribunal_battery& battery = *describe();
  require_exact_rounding();
  Build build{.name = std::filesystem::path(file).stem().string(),
              .compiler = battery.compiler,
              .flags = battery.flags,
              .methods = {}};
  for (std::size_t i = 0; i < battery.size; ++i) build.methods.push_back(method_of(battery.entries[i], file));
  return build;
}

std::vector<Build> all_builds() {
  const auto here = std::filesystem::path(program_file()).parent_path();
  std::vector<std::string> files;
  for (const auto& folder : {here / "compilers", here.parent_path() / "compilers"}) {
    if (!is_directory(folder.string())) continue;
    std::ranges::copy_if(files_in(folder.string()), std::back_inserter(files),
                         [](const std::string& file) { return file.ends_with(".so"); });
  }
  std::ranges::sort(files);
  std::vector<Build> builds;
  for (const std::string& file : files) builds.push_back(load_build(file));
  return builds;
}

}  // namespace tribunal
