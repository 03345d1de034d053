// The tools of the studio behind its door: modes, handles, fits, other shapes, remedies.

#include <cmath>

#include "scenes/design_texts.h"
#include "tests/studio/studio_page.h"

namespace lissom {
namespace {

using samples::Json;
using samples::ReadPack;
using samples::StudioFolder;
using samples::StudioPage;

struct Opened {
  StudioFolder folder;
  std::unique_ptr<Studio> studio;
  std::unique_ptr<StudioPage> page;

  explicit Opened(const std::string& design) : folder("tools-" + design) {
    StudioOptions options;
    options.folder = folder.path();
    options.design = design;
    options.designs = design_texts();
    studio = std::move(Studio::make(options)).value();
    page = std::make_unique<StudioPage>(*studio);
    page->good({{"do", "hello"}, {"protocol", 1}});
    page->pack("shape", [](const ReadPack& shape) { return shape.header["settled"].get<bool>(); });
    page->event("verdict");
  }
  Json constraints(const Json& fields) {
    Json edit = fields;
    edit["name"] = "set_constraints";
    return page->good({{"do", "edit"}, {"edit", edit}});
  }
  Vec3 place_of(int node) {
    const std::vector<float> places =
        page->pack("shape", [](const ReadPack& shape) { return shape.header["settled"].get<bool>(); })
            .floats("positions");
    const auto at = 3 * static_cast<std::size_t>(node);
    return {places[at], places[at + 1], places[at + 2]};
  }
};

TEST(StudioTools, AModeIsAdoptedAndPinsStay) {
  Opened opened("disc-ringed");
  StudioPage& page = *opened.page;
  const Json plan = page.event("plan");
  const std::string a = plan["points"][0]["name"], b = plan["points"][1]["name"], c = plan["points"][2]["name"];
  opened.constraints({{"pinned", {a, b, c}}});
  page.pack("topology");
  page.good({{"do", "modes"}, {"count", 5}});
  EXPECT_EQ(page.job_end("modes")["state"], "done");
  const Json modes = page.event("modes");
  ASSERT_GE(modes["modes"].size(), 3u);
  EXPECT_FALSE(modes["stale"].get<bool>());
  const ReadPack pack = page.pack("modes");
  float largest = 0;
  const std::vector<float> shapes = pack.floats("displacements");
  for (std::size_t i = 0; i < shapes.size() / modes["modes"].size(); i += 3) {
    largest = std::max(largest, std::hypot(shapes[i], shapes[i + 1], shapes[i + 2]));
  }
  EXPECT_NEAR(largest, 1, 1e-3);
  page.forget();
  const double amplitude = 5;
  const Json adopted = page.good({{"do", "mode_adopt"}, {"mode", 0}, {"amplitude_mm", amplitude}});
  EXPECT_LT(adopted["constraint_mm"], 0.01 * amplitude);
  EXPECT_EQ(page.event("history")["at"], 2);
  EXPECT_EQ(page.event("verdict")["name"], "stable");
  EXPECT_TRUE(page.event("modes")["stale"].get<bool>());
  page.refused({{"do", "mode_adopt"}, {"mode", 0}, {"amplitude_mm", 1}});
}

TEST(StudioTools, APullArrives) {
  Opened opened("disc-crossed");
  StudioPage& page = *opened.page;
  const Json begun = page.good({{"do", "handle_begin"}, {"points", {"rim-0"}}, {"radius_mm", 20}});
  EXPECT_GT(begun["weights"], 5);
  for (int i = 1; i <= 10; ++i) page.good({{"do", "handle_move"}, {"move_mm", {0, 0, 0.4 * i}}});
  const ReadPack preview = page.pack("preview");
  EXPECT_LT(preview.header["rms_mm"], 2);
  EXPECT_FALSE(preview.header["changes"].empty());
  EXPECT_EQ(preview.floats("target").size() % 4, 0u);
  page.good({{"do", "handle_accept"}});
  EXPECT_EQ(page.job_end("fit")["state"], "done");
  const Json fit = page.event("fit");
  EXPECT_LT(fit["after_mm"], 0.2 * fit["before_mm"].get<double>());
  EXPECT_EQ(page.event("history")["at"], 1);
  EXPECT_EQ(page.event("verdict")["name"], "stable");
  page.good({{"do", "undo"}});
  EXPECT_EQ(page.event("history")["at"], 0);
}

TEST(StudioTools, OtherShapesAreFoundAndTaken) {
  Opened opened("disc-empty");
  StudioPage& page = *opened.page;
  page.good({{"do", "branches"}});
  EXPECT_EQ(page.job_end("branches")["state"], "done");
  const Json found = page.event("branches");
  ASSERT_GE(found["branches"].size(), 1u);
  int present = 0;
  for (const Json& branch : found["branches"]) present += branch["present"].get<bool>();
  EXPECT_EQ(present, 1);
  page.good({{"do", "branch_take"}, {"branch", found["branches"].size() - 1}});
  EXPECT_EQ(page.event("verdict")["name"], "stable");
  page.refused({{"do", "branch_take"}, {"branch", 77}});
}

TEST(StudioTools, AJobIsCancelled) {
  Opened opened("butterfly");
  StudioPage& page = *opened.page;
  page.good({{"do", "branches"}});
  page.event("job", [](const Json& job) { return job["state"] == "running"; });
  EXPECT_TRUE(page.good({{"do", "cancel"}, {"job", "branches"}})["cancelled"].get<bool>());
  EXPECT_EQ(page.job_end("branches")["state"], "cancelled");
  EXPECT_FALSE(page.good({{"do", "cancel"}, {"job", "branches"}})["cancelled"].get<bool>());
}

}  // namespace
}  // namespace lissom
