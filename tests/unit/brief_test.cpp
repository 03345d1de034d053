/// What a document asks of a design: the names it shares with the methods, numbers that only a program can get wrong, and what
/// spaces and goals are made of it.

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "lissom/design/brief_goals.h"
#include "lissom/design/brief_space.h"
#include "lissom/design/optimize_options.h"
#include "lissom/model/brief_methods.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr const char* kBeam = R"({
  "lissom": 1,
  "rods": [{"name": "beam", "line": [[0, 0, 0], [200, 0, 0]], "edges": 20, "material": "PLA",
            "section": {"radius": "1 mm"}}],
  "sets": {"tip": {"rod": "beam", "at": "end"}},
  "poses": [{"name": "loaded", "supports": [{"at": {"rod": "beam", "at": "start"}, "hold": "clamp"}],
             "forces": [{"at": "tip", "force": [0, 0, "0.1 N"]}]}],
  "design": {"parameters": [{"radii": {"controls": 4, "range": ["0.5 mm", "2 mm"]}}],
             "goals": [{"positions": {"at": "tip", "targets": [[190, 0, 20]]}}]}
})";

Model beam() {
  Result<Model> model = read_document(kBeam);
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  return model ? std::move(model).value() : Model();
}

std::string error_of(const Model& model) {
  const Status status = model.validate();
  return status ? "" : status.error().where + ": " + status.error().message;
}

TEST(Brief, NamesTheMethodsThatThereAre) {
  ASSERT_EQ(kBriefMethods.size(), design_methods().size());
  for (std::size_t i = 0; i < kBriefMethods.size(); ++i) EXPECT_EQ(kBriefMethods[i], design_methods()[i].name);
}

TEST(Brief, HasTheDefaultsOfTheMethods) {
  const OptimizeOptions options;
  const DesignSettings settings;
  EXPECT_EQ(settings.method, design_method_name(options.method));
  EXPECT_EQ(settings.iterations, options.max_iterations);
  EXPECT_EQ(settings.gradient_tolerance, options.gradient_tolerance);
  EXPECT_EQ(settings.decrease_tolerance, options.decrease_tolerance);
}

TEST(Brief, SaysWhereATargetIsNoNumber) {
  Model model = beam();
  std::get<PositionsGoal>(model.design->goals[0].what).targets[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(model), "/design/goals/0/positions/targets/0: these numbers are not finite");
}

TEST(Brief, RefusesNumbersThatNoDocumentCanHold) {
  Model model = beam();
  std::get<RadiiBrief>(model.design->parameters[0].what).range[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(model), "/design/parameters/0/radii/range/1: this number is not finite");
  model = beam();
  model.design->wishes.closeness = -1;
  EXPECT_EQ(error_of(model), "/design/wishes/closeness: the weight must not be negative");
}

TEST(BriefSpace, HasBothRadiiAtEveryControl) {
  const Model model = beam();
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  ASSERT_TRUE(space) << space.error().text();
  EXPECT_EQ(space.value().space->size(), 8);
  EXPECT_EQ(space.value().neighbours.size(), 6u);  // three steps along the rod, for each of the two radii
  for (const auto& [a, b] : space.value().neighbours) {
    EXPECT_EQ(space.value().space->parameters()[static_cast<std::size_t>(a)].axis,
              space.value().space->parameters()[static_cast<std::size_t>(b)].axis);
  }
}

TEST(BriefSpace, TiesAllRadiiToOneValue) {
  Model model = beam();
  model.design->parameters[0].freedom = Freedom::kCommonValue;
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  ASSERT_TRUE(space) << space.error().text();
  ASSERT_EQ(space.value().space->size(), 1);
  EXPECT_NEAR(space.value().space->start()[0], 1e-3, 1e-15);
  EXPECT_TRUE(space.value().neighbours.empty());
  const Result<Design> thick = space.value().space->at(VecX::Constant(1, 1.5e-3));
  ASSERT_TRUE(thick);
  for (const StructureEdge& edge : thick.value().system.structure.edges) {
    EXPECT_NEAR(edge.section.r_n, 1.5e-3, 1e-15);
    EXPECT_NEAR(edge.section.r_b, 1.5e-3, 1e-15);
  }
}

TEST(BriefGoals, DropNodesOfNoWeightAndNormaliseTheOthers) {
  Model model = beam();
  PositionsGoal& wish = std::get<PositionsGoal>(model.design->goals[0].what);
  wish.at = {};
  wish.targets.assign(21, Vec3::Zero());
  wish.weights.assign(21, 0);
  wish.weights[7] = 1;
  wish.weights[20] = 3;
  wish.targets[20] = Vec3(1, 2, 3);
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  ASSERT_TRUE(space);
  const Result<BriefGoals> goals = make_brief_goals(*model.design, space.value());
  ASSERT_TRUE(goals) << goals.error().text();
  EXPECT_EQ(goals.value().nodes[0], (std::vector<int>{7, 20}));
  const Goal& goal = goals.value().goals[0];
  ASSERT_EQ(goal.weights.size(), 6);
  EXPECT_DOUBLE_EQ(goal.weights[0], 0.25);
  EXPECT_DOUBLE_EQ(goal.weights[5], 0.75);
  EXPECT_EQ(goal.target.tail<3>(), Vec3(1, 2, 3));
  EXPECT_EQ(goal.name, "pose \"loaded\": node positions");
}

}  // namespace
}  // namespace lissom
