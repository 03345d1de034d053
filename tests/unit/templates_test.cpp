/// The plans to begin with are documents, stand up when they are released, and leave nothing to warn of.

#include "lissom/editing/templates.h"

#include <gtest/gtest.h>
#include <set>

#include "lissom/editing/edits_json.h"
#include "lissom/equilibrium/settled.h"
#include "lissom/model/document.h"
#include "lissom/session/warnings.h"

namespace lissom {
namespace {

class Templates : public ::testing::TestWithParam<std::size_t> {
 protected:
  const Template& own() const { return templates()[GetParam()]; }
};

TEST_P(Templates, AreDocumentsThatCanBeEdited) {
  const Model model = own().make();
  const Status valid = model.validate();
  ASSERT_TRUE(valid) << valid.error().text();
  EXPECT_EQ(model.title, own().title);
  EXPECT_TRUE(own().sentence.ends_with('.'));
  const std::string text = write_document(model);
  EXPECT_EQ(write_document(read_document(text).value()), text);
  const std::string point = model.plan->points[0].name;
  EXPECT_TRUE(apply_edit(model, {{"name", "set_radii"}, {"points", {point}}, {"factor", 1.1}}));
}

TEST_P(Templates, StandUpTaut) {
  const Model model = own().make();
  Result<System> system = make_system(model);
  ASSERT_TRUE(system) << system.error().text();
  const Result<Equilibrium> released = settled(model, system.value(), model.poses[0], "/poses/0", {});
  ASSERT_TRUE(released) << released.error().text();
  EXPECT_EQ(released.value().verdict, Verdict::kStable);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < system.value().structure.nodes.size(); ++i) {
    box.extend(released.value().state.position(static_cast<int>(i)));
  }
  EXPECT_GT(box.sizes().minCoeff(), 8e-3) << "it is flat";
  EXPECT_GT(box.sizes().maxCoeff(), 60e-3);
  const bool free_edge = own().name == "sheet";  // fabric at an edge that no rod holds is slack
  for (const Warning& warning : warnings(system.value(), released.value().state, 1)) {
    EXPECT_TRUE(free_edge && warning.what == "slack fabric") << warning.what << " " << warning.where;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Templates, ::testing::Range(std::size_t{0}, templates().size()),
                         [](const auto& one) { return std::string(templates()[one.param].name); });

TEST(TemplateNames, AreTheirOwn) {
  std::set<std::string_view> names;
  for (const Template& one : templates()) names.insert(one.name);
  EXPECT_EQ(names.size(), templates().size());
  EXPECT_GE(names.size(), 10U);
}

}  // namespace
}  // namespace lissom
