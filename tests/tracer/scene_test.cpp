// Scene files: what must be refused, with a message that names the place.
#include "tests/tracer/support.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

using testing::refusal_of;

const std::string good = R"({
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov": 40, "width": 4, "height": 3},
  "lights": [{"position": [1, 2, 3], "colour": [1, 1, 1]}],
  "background": [0, 0, 0.5],
  "solids": [{"name": "t", "vertices": [[0, 0, 0], ["0x1p-1", 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]],
              "colour": [0.5, 0.5, 0.5], "diffuse": 0.5}]
})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

struct BadScene {
  std::string text;
  const char* message;
};

TEST(ReadScene, RefusesBadScenesNamingThePlace) {
  const BadScene table[] = {
      {"{", "line 1"},
      {with("\"fov\": 40,", "\"fov\": 40 oops,"), "line 2"},
      {good + "x", "not valid JSON"},
      {"[]", "expected an object"},
      {"{}", "missing \"camera\""},
      {std::string(100000, '['), "nested deeper"},
      {with("\"background\"", "\"backgroud\""), "unknown key \"backgroud\", did you mean \"background\"?"},
      {with("\"diffuse\"", "\"difuse\""), "solids[0]: unknown key \"difuse\", did you mean \"diffuse\"?"},
      {with("\"fov\": 40", "\"fov\": \"wide\""), "camera.fov: expected a number"},
      {with("\"fov\": 40", "\"fov\": 0"), "camera.fov: expected degrees"},
      {with("\"fov\": 40", "\"fov\": 180"), "camera.fov: expected degrees"},
      {with("\"fov\": 40", "\"fov\": 1e999"), "1e999"},
      {with("\"fov\": 40,", ""), "either \"fov\""},
      {with("\"fov\": 40", "\"fov\": 40, \"view_height\": 1"), "either \"fov\""},
      {with("\"fov\": 40", "\"view_height\": 0"), "camera.view_height"},
      {with("\"width\": 4", "\"width\": 0"), "camera.width: expected a number in 1"},
      {with("\"width\": 4", "\"width\": 2.5"), "camera.width: expected a whole number"},
      {with("\"width\": 4", "\"width\": -4"), "camera.width"},
      {with("\"width\": 4, \"height\": 3", "\"width\": 100000, \"height\": 100000"), "camera.width: expected"},
      {with("\"width\": 4, \"height\": 3", "\"width\": 16384, \"height\": 16384"), "2^26 pixels"},
      {with("\"look_at\": [0, 0, 0]", "\"look_at\": [0, 0, 5]"), "singular camera"},
      {with("\"up\": [0, 1, 0]", "\"up\": [0, 0, -3]"), "singular camera"},
      {with("\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]"), "singular camera"},
      {with("\"up\": [0, 1, 0]", "\"up\": [0, 1]"), "camera.up: expected three numbers"},
      {with("\"up\": [0, 1, 0]", "\"up\": [0, 1, \"0x\"]"), "camera.up[2]"},
      {with("\"up\": [0, 1, 0]", "\"up\": [0, 1, \"nan\"]"), "camera.up[2]"},
      {with("[0.5, 0.5, 0.5]", "[0.5, 1.5, 0.5]"), "solids[0].colour: expected three numbers in 0..1"},
      {with("[0.5, 0.5, 0.5]", "\"red\""), "solids[0].colour: expected three numbers in 0..1"},
      {with("\"diffuse\": 0.5", "\"diffuse\": -0.5"), "solids[0].diffuse: expected a number in 0"},
      {with("\"diffuse\": 0.5", "\"refractive_index\": 0"), "solids[0].refractive_index"},
      {with("\"diffuse\": 0.5", "\"scale\": 0"), "solids[0].scale"},
      {with("\"diffuse\": 0.5", "\"scale\": 1e308, \"translate\": [1e308, 1e308, 1e308]"), "leave binary64"},
      {with("\"diffuse\": 0.5", "\"mesh\": \"t.off\""), "either \"mesh\""},
      {with("[[0, 1, 2]]", "[[0, 1, 3]]"), "solids[0].faces[0][2]: expected a whole number from 0 to 2, found 3"},
      {with("[[0, 1, 2]]", "[[0, 1, -1]]"), "solids[0].faces[0][2]"},
      {with("[[0, 1, 2]]", "[[0, 1]]"), "solids[0].faces[0]: expected an array of at least 3"},
      {with("[[0, 1, 2]]", "[]"), "solids[0].faces: expected at least one face"},
      {with("\"faces\"", "\"fases\""), "did you mean \"faces\"?"},
      {with("\"position\": [1, 2, 3]", "\"position\": [1, 2, null]"), "lights[0].position[2]"},
      {with("\"background\": [0, 0, 0.5]", "\"depth\": 0"), "depth: expected a number in 1"},
      {with("\"background\": [0, 0, 0.5]", "\"depth\": 1000000"), "depth"},
      {with("\"background\": [0, 0, 0.5]", "\"bias\": 1"), "bias"},
  };
  for (const BadScene& bad : table) {
    SCOPED_TRACE(bad.message);
    const std::string line = refusal_of([&] { parse_scene(bad.text, "scene.json"); });
    EXPECT_TRUE(line.starts_with("scene.json:")) << line;
    EXPECT_NE(line.find(bad.message), std::string::npos) << line;
  }
}

TEST(ReadScene, NamesTheMeshFileThatIsMissing) {
  std::string text = good;
  const std::size_t at = text.find("\"vertices\""), end = text.find("\"colour\": [0.5");
  text.replace(at, end - at, "\"mesh\": \"sub/missing.off\", ");
  const std::string line = refusal_of([&] { parse_scene(text, "somewhere/scene.json"); });
  EXPECT_TRUE(line.starts_with("somewhere/sub/missing.off: cannot read")) << line;
}

TEST(ReadScene, ReadsWhatIsWritten) {
  const Scene s =
      parse_scene(with("\"diffuse\": 0.5", "\"scale\": [2, 1, -1], \"translate\": [0, 0, 1]"), "scene.json");
  EXPECT_EQ(s.camera.width, 4);
  EXPECT_EQ(s.background.b, 0.5);
  ASSERT_EQ(s.solids.size(), 1u);
  EXPECT_EQ(s.solids[0].mesh.vertices[1], Point3(1, 0, 1)) << "scaled, then moved";
  EXPECT_EQ(s.solids[0].mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1})) << "a mirroring turns faces over";
}

TEST(ReadScene, ShippedScenesLoad) {
  for (const char* name : {"mirror-and-prism", "cube-grid"}) {
    EXPECT_GT(read_scene("data/scenes/" + std::string(name) + ".json").solids.size(), 3u);
  }
}

}  // namespace
}  // namespace tribunal
