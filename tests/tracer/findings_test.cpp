// Which method a differing pixel is blamed on.
#include "tracer/render/findings.h"

#include "tests/tracer/support.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

using testing::method;

/// sf-double with another answer.
Method answering(const Answer& answer) {
  Method m = method("sf-double");
  m.name = "planted";
  m.ray = [answer](const Ray&, const Triangle&) { return answer; };
  m.segment = [answer](const Segment&, const Triangle&) { return answer; };
  return m;
}

constexpr Triangle face = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
constexpr Query through_the_face = {Ray{{1, 1, 5}, {{0, 0, -1}}}, face};
constexpr Query beside_the_face = {Ray{{9, 9, 5}, {{0, 0, -1}}}, face};
constexpr Query along_the_face = {Ray{{1, 1, 0}, {{1, 0, 0}}}, face};

TEST(Blame, IsOnAnAnswerThatTheTracerReadsOtherwiseThanTheExactOne) {
  EXPECT_TRUE(shows_wrong_answer(answering(miss()), through_the_face));
  EXPECT_TRUE(shows_wrong_answer(answering(hit_at(Contact::interior)), beside_the_face));
  EXPECT_TRUE(shows_wrong_answer(answering(hit_at(Contact::interior)), along_the_face)) << "seen edge-on";
  EXPECT_TRUE(shows_wrong_answer(answering(hit_at(Contact::coplanar)), through_the_face)) << "the face vanishes";
  EXPECT_TRUE(shows_wrong_answer(answering(refusal(Status::crashed)), through_the_face));
}

TEST(Blame, IsNotOnOneThatMovesNoPixel) {
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::interior)), through_the_face));
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::vertex)), through_the_face));
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::coplanar)), beside_the_face));
  EXPECT_FALSE(shows_wrong_answer(answering(miss()), along_the_face));
}

TEST(Blame, IsNotOnAConvention) {
  Method careless = answering(hit_at(Contact::interior));
  careless.tells_contact = false;
  EXPECT_FALSE(shows_wrong_answer(careless, along_the_face)) << "it hits the closed point sets";
}

TEST(Blame, OfAShadowIsOnAnEndToldWrongly) {
  const Query crossing = {Segment{{1, 1, 5}, {1, 1, -5}}, face};
  EXPECT_TRUE(shows_wrong_answer(answering(hit_at(Contact::interior, At::source)), crossing)) << "light passes";
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::interior, At::between)), crossing));
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::interior)), crossing));
  const Query from_the_face = {Segment{{1, 1, 0}, {1, 1, -5}}, face};
  EXPECT_TRUE(shows_wrong_answer(answering(hit_at(Contact::interior, At::between)), from_the_face)) << "a false shadow";
  EXPECT_FALSE(shows_wrong_answer(answering(hit_at(Contact::interior)), from_the_face)) << "it says no end";
}

TEST(Findings, AFaceThatAWrongContactHidesIsBlamedAndIsACase) {
  Scene scene;
  scene.camera = {
      .eye = {0.3, 0.2, 9}, .look_at = {0.3, 0.2, 0}, .up = {0, 1, 0}, .view_height = 4, .width = 8, .height = 8};
  Solid s;
  s.mesh.vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  s.mesh.triangles = {{0, 1, 2}};
  scene.solids = {s};
  const World world = make_world(scene, Format::binary64, Accel::boxes);
  const Method &exact = method("sf-rational"), blind = answering(hit_at(Contact::coplanar));
  const auto pixels = differing_pixels(render(world, blind, {1, 1}), render(world, exact, {1, 1}));
  ASSERT_FALSE(pixels.empty());
  const Findings f = examine(world, blind, exact, pixels, 1, 3);
  ASSERT_EQ(f.cases.size(), 3u);
  EXPECT_EQ(f.pixels[0].wrong, std::vector<std::string>{"planted"});
  EXPECT_EQ(f.cases[0].finding.value("outcome", ""), "wrong contact");
  EXPECT_EQ(f.count(Why::unexamined), pixels.size() - 3);
}

}  // namespace
}  // namespace tribunal
