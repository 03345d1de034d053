// The studio behind its door: documents, edits, drags, history, files, and requests that make no sense.

#include <cmath>

#include "lissom/core/file_io.h"
#include "scenes/design_texts.h"
#include "tests/studio/studio_page.h"

namespace lissom {
namespace {

using samples::Json;
using samples::ReadPack;
using samples::StudioFolder;
using samples::StudioPage;

std::unique_ptr<Studio> studio_in(const StudioFolder& folder, const std::string& design = {},
                                  std::chrono::milliseconds own_time = StudioOptions().own_time) {
  StudioOptions options;
  options.folder = folder.path();
  options.design = design;
  options.designs = design_texts();
  options.own_time = own_time;
  Result<std::unique_ptr<Studio>> made = Studio::make(options);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
  return std::move(made).value();
}

/// A studio in a folder of its own, and a page that has said hello.
struct OpenStudio {
  StudioFolder folder;
  std::unique_ptr<Studio> studio;
  StudioPage page;

  explicit OpenStudio(const std::string& name, const std::string& design = {},
                      std::chrono::milliseconds own_time = StudioOptions().own_time)
      : folder(name), studio(studio_in(folder, design, own_time)), page(*studio) {
    page.good({{"do", "hello"}, {"protocol", 1}});
  }
};

Json move(const std::string& point, double x, double y) {
  return {{"name", "move_points"}, {"moves", {{{"point", point}, {"to_mm", {x, y}}}}}};
}

bool settled(const ReadPack& shape) { return shape.header["settled"].get<bool>(); }

TEST(Studio, ShowsADesignThatPopsUp) {
  const StudioFolder folder("pops");
  const auto studio = studio_in(folder, "disc-crossed");
  StudioPage page(*studio);
  const Json hello = page.good({{"do", "hello"}, {"protocol", 1}});
  EXPECT_FALSE(hello["edits"].empty());
  EXPECT_FALSE(hello["templates"].empty());
  EXPECT_EQ(page.event("project")["kind"], "plan");
  EXPECT_EQ(page.event("plan")["points"].size(), 5u);
  const ReadPack topology = page.pack("topology"), shape = page.pack("shape", settled);
  EXPECT_EQ(topology.header["topology"], shape.header["topology"]);
  const std::vector<float> places = shape.floats("positions");
  EXPECT_EQ(places.size() / 3, topology.floats("plan_places").size() / 2);
  float high = 0;
  for (std::size_t i = 2; i < places.size(); i += 3) high = std::max(high, places[i]);
  EXPECT_GT(high, 5) << "mm";
  const Json verdict = page.event("verdict");
  EXPECT_EQ(verdict["name"], "stable");
  EXPECT_GT(verdict["lowest_mode_n_per_m"], 0);
}

TEST(Studio, ADragIsOneStepAndOnlyItsNewestMoveCounts) {
  OpenStudio open("drag", "disc-crossed");
  StudioPage& page = open.page;
  page.pack("shape", settled);
  std::vector<int> ids;
  for (int i = 1; i <= 40; ++i)
    ids.push_back(page.send({{"do", "drag"}, {"drag", 7}, {"edit", move("centre", 0.2 * i, 0)}}));
  int skipped = 0;
  for (const int id : ids) {
    const Json answer = page.answer_to(id);
    EXPECT_TRUE(answer["ok"].get<bool>()) << answer.dump();
    skipped += answer.value("skipped", false);
  }
  EXPECT_GT(skipped, 20);
  EXPECT_EQ(page.pack("shape", settled).header["drag"], 7);
  page.good({{"do", "drag_end"}, {"drag", 7}, {"edit", move("centre", 8, 0)}});
  const Json history = page.event("history");
  EXPECT_EQ(history["steps"].size(), 1u);
  EXPECT_EQ(history["at"], 1);
  const Json plan = page.event("plan");
  EXPECT_NEAR(plan["points"][4]["at_mm"][0].get<double>(), 8, 1e-9);
  // One that is given up leaves nothing.
  page.good({{"do", "drag"}, {"drag", 8}, {"edit", move("centre", -5, 0)}});
  page.good({{"do", "drag_cancel"}, {"drag", 8}});
  EXPECT_EQ(page.event("history")["at"], 1);
  EXPECT_NEAR(page.event("plan")["points"][4]["at_mm"][0].get<double>(), 8, 1e-9);
}

TEST(Studio, ADragWhosePageGoesIsLetGo) {
  const StudioFolder folder("gone");
  const auto studio = studio_in(folder, "disc-crossed");
  StudioPage stays(*studio);
  stays.good({{"do", "hello"}, {"protocol", 1}});
  stays.pack("shape", settled);
  const auto middle = [](double x) {
    return [x](const Json& plan) { return std::abs(plan["points"][4]["at_mm"][0].get<double>() - x) < 1e-9; };
  };
  {
    StudioPage goes(*studio);
    goes.good({{"do", "drag"}, {"drag", 1}, {"edit", move("centre", 6, 0)}});
    stays.event("plan", middle(6));
    stays.forget();
  }
  stays.event("plan", middle(0));
  EXPECT_EQ(stays.good({{"do", "undo"}})["at"], 0);
}

TEST(Studio, UndoBringsBackPlanAndShape) {
  OpenStudio open("undo", "disc-crossed");
  StudioPage& page = open.page;
  const std::vector<float> before = page.pack("shape", settled).floats("positions");
  page.good({{"do", "edit"}, {"edit", {{"name", "set_pre_stretch"}, {"along", {1.3, 1.3}}}}});
  page.good({{"do", "edit"}, {"edit", {{"name", "remove"}, {"rods", {"along"}}}}});
  page.good({{"do", "undo"}});
  page.good({{"do", "undo"}});
  const std::vector<float> after = page.pack("shape", settled).floats("positions");
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(after[i], before[i], 1e-3) << i;
  EXPECT_EQ(page.event("history")["at"], 0);
  page.good({{"do", "redo"}});
  EXPECT_EQ(page.event("history")["at"], 1);
}

TEST(Studio, AnEditThatCannotBeBuiltLeavesAllAsItWas) {
  OpenStudio open("refused", "disc-crossed");
  StudioPage& page = open.page;
  page.pack("shape", settled);
  const Json before = page.event("plan");
  page.refused({{"do", "edit"}, {"edit", move("centre", 200, 0)}});  // rods leave the fabric and cross
  Json after = page.event("plan");
  const Json revision = after["revision"];
  // The shape is that of the plan, whatever number it has now.
  page.pack("shape", [&](const ReadPack& shape) { return shape.header["plan_revision"] == revision; });
  after["revision"] = before["revision"];
  EXPECT_EQ(after, before);
  page.good({{"do", "edit"}, {"edit", move("centre", 3, 0)}});
  EXPECT_EQ(page.event("history")["at"], 1);
}

TEST(Studio, APlanWithoutAShapeShowsTheLastGoodOne) {
  OpenStudio open("last-good", "disc-empty");
  StudioPage& page = open.page;
  const std::vector<float> good = page.pack("shape", settled).floats("positions");
  // So much that it is still far from rest after all iterations.
  page.good({{"do", "edit"}, {"edit", {{"name", "set_pre_stretch"}, {"along", {3, 3}}}}});
  const Json verdict = page.event("verdict", [](const Json& e) { return !e["settled"].get<bool>(); });
  EXPECT_EQ(verdict["shown"], "last good");
  // What pages saw on the way has gone, and they need not wait for anything.
  const ReadPack shown = page.pack("shape");
  EXPECT_EQ(shown.header["plan_revision"], page.event("plan")["revision"]);
  EXPECT_FALSE(settled(shown));
  EXPECT_EQ(shown.floats("positions"), good);
}

TEST(Studio, ADragKeepsItsMeshAndGetsOneThatFitsWhereItEnds) {
  OpenStudio open("mesh", "disc-crossed");
  StudioPage& page = open.page;
  const auto mesh = [&] { return page.pack("shape", settled).header["topology"].get<int>(); };
  const int before = mesh();
  const Json far = move("centre", 20, 0);
  page.good({{"do", "drag"}, {"drag", 1}, {"edit", far}});
  EXPECT_EQ(page.pack("shape", settled).header["drag"], 1);
  EXPECT_EQ(mesh(), before);
  page.good({{"do", "drag_end"}, {"drag", 1}, {"edit", far}});
  EXPECT_EQ(mesh(), before + 1);
  EXPECT_NE(page.event("verdict")["note"].get<std::string>().find("new mesh"), std::string::npos);
  EXPECT_EQ(page.event("history")["steps"].size(), 1u);
  // Where even that does not do, a drag gets a new mesh at once.
  page.good({{"do", "drag"}, {"drag", 2}, {"edit", move("centre", -40, 0)}});
  EXPECT_EQ(mesh(), before + 2);
}

TEST(Studio, ADragThatGaveWayToItsOwnEndSettlesThere) {
  OpenStudio open("gives-way-to-its-end", "disc-crossed", std::chrono::milliseconds(0));
  StudioPage& page = open.page;
  page.pack("shape", settled);
  page.forget();
  // Three far moves, the last of which is where the drag ends; none of the searches before has any time.
  for (const double x : {8.0, -8.0, 12.0}) page.send({{"do", "drag"}, {"drag", 5}, {"edit", move("centre", x, 3)}});
  page.good({{"do", "drag_end"}, {"drag", 5}, {"edit", move("centre", 12, 3)}});
  EXPECT_EQ(page.event("verdict")["name"], "stable");
  EXPECT_EQ(page.pack("shape", settled).header["plan_revision"], page.event("plan")["revision"]);
  EXPECT_EQ(page.event("history")["at"], 1);
}

TEST(Studio, ALongSolveGivesWayToWhatIsAskedNext) {
  // A release takes several times as long as it has for itself.
  OpenStudio open("gives-way", "butterfly", std::chrono::milliseconds(50));
  StudioPage& page = open.page;
  page.good({{"do", "edit"}, {"edit", {{"name", "set_title"}, {"title", "Anew"}}}});
  EXPECT_EQ(page.event("verdict")["name"], "stable");
  const int settle = page.send({{"do", "settle"}, {"from", "flat"}});
  const int undo = page.send({{"do", "undo"}});
  EXPECT_TRUE(page.answer_to(settle)["ok"].get<bool>());
  const Json verdict = page.event("verdict", [](const Json& e) { return !e["settled"].get<bool>(); });
  EXPECT_EQ(verdict["name"], "cancelled");
  EXPECT_EQ(verdict["shown"], "unsettled");
  EXPECT_TRUE(page.answer_to(undo)["ok"].get<bool>());
  EXPECT_EQ(page.event("history")["at"], 0);
  EXPECT_EQ(page.event("verdict")["name"], "stable");
}

TEST(Studio, RefusesWhatMakesNoSense) {
  OpenStudio open("sense");
  StudioPage& page = open.page;
  page.refused({{"do", "hello"}, {"protocol", 2}});
  page.refused({{"do", "edit"}, {"edit", move("a", 0, 0)}});  // nothing is open
  page.refused({{"do", "unddo"}});
  page.refused({{"do", 3}});
  page.refused({{"do", "open"}, {"file", "../../etc/passwd"}});
  page.refused({{"do", "open"}, {"file", "/etc/passwd"}});
  page.refused({{"do", "open"}, {"design", "no such"}});
  page.refused({{"do", "new"}, {"template", "no such"}});
  for (const char* text :
       {"", "{", "[]", "3", "null", "\"do\"", "{\"do\": \"edit\", \"do\": \"undo\"}", "\xff\xfe", "{\"id\": 1e999}"}) {
    page.send_raw(text);
  }
  page.good({{"do", "new"}, {"template", "disc"}});
  page.refused({{"do", "mode_adopt"}, {"mode", 0}, {"amplitude_mm", 1}});
  page.refused({{"do", "handle_move"}, {"move_mm", {0, 0, 1}}});
  page.refused({{"do", "handle_begin"}, {"nodes", {99999999}}});
  page.refused({{"do", "handle_begin"}, {"nodes", {-1}}});
  page.refused({{"do", "drag"}, {"drag", 0}, {"edit", Json::object()}});
  page.refused({{"do", "fields"}, {"rods", "smallest stretch"}});
  page.refused({{"do", "go_to"}, {"step", 44}});
  page.refused({{"do", "save"}, {"file", "../out.lissom"}});
  page.refused({{"do", "export"}, {"format", "exe"}});
  page.refused({{"do", "export"}, {"format", "svg"}, {"file", "../out.svg"}});
  page.refused({{"do", "picture"}, {"png_base64", "bm90IGEgcG5n"}});
  page.refused({{"do", "remedy"}, {"warning", 99}});
  page.good({{"do", "probe"}, {"x", 5}});
}

TEST(Studio, WritesFilesThatCanBeReadAgain) {
  const StudioFolder folder("files");
  {
    const auto studio = studio_in(folder);
    StudioPage page(*studio);
    page.good({{"do", "hello"}, {"protocol", 1}});
    page.good({{"do", "new"}, {"template", "disc"}});
    page.pack("shape", settled);
    page.good({{"do", "edit"}, {"edit", {{"name", "set_title"}, {"title", "My disc"}}}});
    page.good({{"do", "save"}, {"file", "mine.lissom"}});
    EXPECT_TRUE(page.event("project")["saved"].get<bool>());
    for (const char* format : {"svg", "dxf", "stl", "3mf", "obj", "ply"}) {
      const Json written = page.good({{"do", "export"}, {"format", format}});
      EXPECT_GT(written["bytes"], 100) << format;
      EXPECT_TRUE(std::filesystem::exists(folder.path() / written["file"].get<std::string>()));
    }
  }
  StudioOptions options;
  options.folder = folder.path();
  options.file = "mine.lissom";
  const auto studio = std::move(Studio::make(options)).value();
  StudioPage page(*studio);
  page.good({{"do", "hello"}, {"protocol", 1}});
  EXPECT_EQ(page.event("project", [](const Json& e) { return e["kind"] == "plan"; })["title"], "My disc");
  EXPECT_EQ(page.event("history")["steps"].size(), 1u);
}

TEST(Studio, TwoPagesSeeTheSame) {
  const StudioFolder folder("two");
  const auto studio = studio_in(folder, "disc-empty");
  StudioPage first(*studio), second(*studio);
  first.good({{"do", "hello"}, {"protocol", 1}});
  second.good({{"do", "hello"}, {"protocol", 1}});
  first.good({{"do", "edit"}, {"edit", {{"name", "set_pre_stretch"}, {"along", {1.33, 1.33}}}}});
  const auto changed = [](const Json& plan) { return plan["fabric"]["pre_stretch"][0] == 1.33; };
  EXPECT_EQ(first.event("plan", changed), second.event("plan", changed));
  StudioPage third(*studio);
  third.good({{"do", "hello"}, {"protocol", 1}});
  EXPECT_EQ(third.event("plan", changed)["revision"], first.event("plan", changed)["revision"]);
}

TEST(Studio, KeepsWhatIsNotSaved) {
  const StudioFolder folder("kept");
  std::vector<float> before;
  {
    const auto studio = studio_in(folder, "disc-crossed");
    StudioPage page(*studio);
    page.good({{"do", "hello"}, {"protocol", 1}});
    page.pack("shape", settled);
    page.good({{"do", "edit"}, {"edit", move("centre", 6, 2)}});
    before = page.pack("shape", settled).floats("positions");
  }
  const auto studio = studio_in(folder);
  StudioPage page(*studio);
  page.good({{"do", "hello"}, {"protocol", 1}});
  const Json found = page.event("project");
  ASSERT_TRUE(found.contains("recovery")) << found.dump();
  EXPECT_EQ(found["recovery"]["steps"], 1);
  page.good({{"do", "recover"}, {"take", true}});
  EXPECT_EQ(page.event("history")["at"], 1);
  const std::vector<float> after = page.pack("shape", settled).floats("positions");
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(after[i], before[i], 1e-3) << i;
}

}  // namespace
}  // namespace lissom
