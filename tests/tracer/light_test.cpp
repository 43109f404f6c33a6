// Warn's lights: aim, concentration, cone, flaps.
#include <cmath>

#include "tests/tracer/support.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/camera_rays.h"
#include "tracer/shading/warn_light.h"

namespace tribunal {
namespace {

double strength_at(const Light& light, const Point3& point) {
  return WarnLight(light).strength_at(point, normalised(light.position - point));
}

using testing::refusal_of;

Light down_from_ten() { return {.position = {0, 0, 10}, .colour = {1, 1, 1}, .aim = Point3(0, 0, 0)}; }

TEST(WarnLight, ShinesAllAroundWithoutAim) {
  EXPECT_EQ(strength_at({.position = {0, 0, 10}, .colour = {1, 1, 1}}, {3, -4, 99}), 1);
  EXPECT_EQ(strength_at(down_from_ten(), {3, -4, 99}), 1) << "concentration 0 spreads evenly";
}

TEST(WarnLight, FallsOffByThePowerOfTheCosine) {
  Light light = down_from_ten();
  light.concentration = 3;
  EXPECT_EQ(strength_at(light, {0, 0, 5}), 1);
  EXPECT_NEAR(strength_at(light, {10, 0, 0}), std::pow(0.5, 1.5), 1e-15) << "at 45 degrees";
  EXPECT_EQ(strength_at(light, {0, 0, 20}), 0) << "behind";
}

TEST(WarnLight, EndsAtTheConeAndTheFlaps) {
  Light light = down_from_ten();
  light.cone_cosine = std::cos(0.5);
  EXPECT_EQ(strength_at(light, {10 * std::tan(0.499), 0, 0}), 1);
  EXPECT_EQ(strength_at(light, {10 * std::tan(0.501), 0, 0}), 0);
  light.flaps.lo.y = -1;
  light.flaps.hi.y = 2;
  EXPECT_EQ(strength_at(light, {0, 2, 0}), 1) << "a flap's own plane is lit";
  EXPECT_EQ(strength_at(light, {0, 2.0000001, 0}), 0);
  EXPECT_EQ(strength_at(light, {0, -1.5, 0}), 0);
}

TEST(WarnLight, IsReadAndRefused) {
  const auto scene = [](const std::string& more) {
    return R"({"camera": {"eye": [0,0,5], "look_at": [0,0,0], "up": [0,1,0], "fov": 40, "width": 4, "height": 3},
      "solids": [{"vertices": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]]}],
      "lights": [{"position": [0,0,9])" +
           more + "}]}";
  };
  const auto message = [&](const std::string& more) { return refusal_of([&] { parse_scene(scene(more), "s.json"); }); };
  const Scene s = parse_scene(
      scene(R"(, "aim": [0,0,0], "concentration": 2, "cone": 60, "flaps": {"x": [-1, 1], "z": [0, 9]})"), "s.json");
  EXPECT_NEAR(s.lights[0].cone_cosine, 0.5, 1e-15);
  EXPECT_EQ(s.lights[0].flaps.hi.x, 1);
  EXPECT_EQ(s.lights[0].flaps.hi.y, std::numeric_limits<double>::infinity());
  EXPECT_NE(message(R"(, "cone": 60)").find("lights[0].cone: expected \"aim\""), std::string::npos);
  EXPECT_NE(message(R"(, "aim": [0,0,9])").find("lights[0].aim: expected another point"), std::string::npos);
  EXPECT_NE(message(R"(, "aim": [0,0,0], "cone": 181)").find("lights[0].cone"), std::string::npos);
  EXPECT_NE(message(R"(, "flaps": {"x": [1, -1]})").find("lights[0].flaps.x: expected the lesser"), std::string::npos);
  EXPECT_NE(message(R"(, "flaps": {"w": [1, 2]})").find("unknown key \"w\""), std::string::npos);
}

}  // namespace
}  // namespace tribunal
