/// A line network that nobody here drew: a gridshell of laths, closed to a bundle 30 m long, whose rim shrinks by 2 %. Runs
/// where the shared data lies beside the repository.

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include "lissom/core/file_io.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/model/import_network.h"

namespace lissom {
namespace {

constexpr const char* kFile = "../shared/data/two-bumps.obj";

TEST(TwoBumps, AShrunkRimThrowsItIntoWaves) {
  if (!std::filesystem::exists(kFile)) {
    GTEST_SKIP() << kFile << " is not here: a drawing by others, which the repository does not carry";
  }
  const Result<ObjLines> lines = read_obj_lines(read_file(kFile).value(), kFile);
  ASSERT_TRUE(lines.ok()) << lines.error().text();
  EXPECT_EQ(lines.value().points.size(), 237u);
  EXPECT_EQ(lines.value().segments.size(), 440u);
  NetworkOptions options;
  options.scale = 0.001;
  options.section.shape = SectionShape::kTube;
  options.section.r_n = options.section.r_b = {0.02};
  options.section.wall = 0.003;
  Result<ImportedNetwork> network = import_network(lines.value(), options);
  ASSERT_TRUE(network.ok()) << network.error().text();
  Model model = std::move(network.value().model);
  Pose pose;
  pose.name = "pushed";
  Support rim;
  rim.at.kind = Selector::Kind::kBoundary;
  rim.shrink = 0.02;
  pose.supports.push_back(rim);
  Seed seed;
  seed.amplitude = 0.01;
  pose.seed = seed;
  model.poses.push_back(pose);
  const Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok()) << system.error().text();
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), pose, "/poses/0");
  ASSERT_TRUE(problem.ok()) << problem.error().text();

  // Waves between the points of the rim. Shapes within 2 % of energy of each other are many: which of them a start reaches
  // hangs on details of the steps, not on its side alone.
  for (const double side : {1.0, -1.0}) {
    pose.seed->direction = side * Vec3::UnitZ();
    const Equilibrium found = solve(problem.value(), start_state(problem.value(), pose), 1, {});
    EXPECT_EQ(found.verdict, Verdict::kStable) << found.message;
    EXPECT_NEAR(found.energy, 41.4e3, 0.03 * 41.4e3);
    double highest = 0, lowest = 0;
    for (int i = 0; i < system.value().layout.nodes(); ++i) {
      highest = std::max(highest, found.state.position(i).z());
      lowest = std::min(lowest, found.state.position(i).z());
    }
    EXPECT_GT(highest, 0.3);
    EXPECT_LT(lowest, -0.3);
  }
}

}  // namespace
}  // namespace lissom
