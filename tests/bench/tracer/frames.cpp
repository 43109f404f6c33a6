#include "tests/bench/tracer/frames.h"

#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "exact/methods/methods.h"
#include "tracer/pov/export_pov.h"
#include "tracer/scene/read_scene.h"

namespace tribunal::bench {
namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A temporary directory that the destructor removes.
class Scratch {
 public:
  Scratch() : path_(std::filesystem::temp_directory_path() / ("tribunal-bench-" + std::to_string(::getpid()))) {
    std::filesystem::create_directory(path_);
  }
  Scratch(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(path_); }

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// One scene, exported once and drawn many times.
class Frame {
 public:
  Frame(const Scratch& scratch, const std::string& name)
      : scene_(read_scene("data/scenes/" + name + ".json")),
        world_(make_world(scene_, Format::binary64, Accel::bvh)),
        pov_(scratch.file(name + ".pov")) {
    std::ofstream(pov_) << to_pov(make_world(scene_, Format::binary64, Accel::none, Faces::triangulated), scene_.depth);
  }

  std::size_t pixels() const { return static_cast<std::size_t>(scene_.camera.width * scene_.camera.height); }

  double ours() const {
    const double start = cpu_seconds();
    render(world_, *find_method("sf-filtered"), {.depth = scene_.depth, .threads = 1});
    return cpu_seconds() - start;
  }

  /// The CPU seconds that POV-Ray spent on tracing, by the last such line of its report.
  std::optional<double> povray() const {
    const std::string command = "povray +I" + pov_ + " -F -D -A +WT1 +W" + std::to_string(scene_.camera.width) + " +H" +
                                std::to_string(scene_.camera.height) + " 2>&1";
    FILE* out = ::popen(command.c_str(), "r");
    if (out == nullptr) return std::nullopt;
    std::optional<double> seconds;
    char line[4096];
    while (std::fgets(line, sizeof line, out) != nullptr) {
      int threads = 0;
      double read = 0;
      if (std::sscanf(line, " using %d thread(s) with %lf CPU-seconds", &threads, &read) == 2) seconds = read;
    }
    return ::pclose(out) == 0 ? seconds : std::nullopt;
  }

 private:
  Scene scene_;
  World world_;
  std::string pov_;
};

}  // namespace

void time_frames(const std::vector<std::string>& scenes, int rounds, Medians& medians) {
  const Scratch scratch;
  std::vector<std::unique_ptr<Frame>> frames;
  for (const std::string& name : scenes) frames.push_back(std::make_unique<Frame>(scratch, name));
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const double to_pixel = 1e9 / static_cast<double>(frames[i]->pixels());
      const std::optional<double> theirs = frames[i]->povray();
      if (!theirs) {
        std::printf("no frames: `povray` is not installed, or failed\n");
        return;
      }
      medians.add(scenes[i] + "/povray", *theirs * to_pixel);
      medians.add(scenes[i] + "/ours", frames[i]->ours() * to_pixel);
    }
  }
}

}  // namespace tribunal::bench
