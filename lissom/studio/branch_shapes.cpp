#include "lissom/studio/branch_shapes.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

#include "lissom/session/totals.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

std::string sentence_of(const Branch& branch, double height) {
  return fmt::format("{:.1f} mm high, {:.3g} mJ{}{}", kMillimetres * height, kMillijoules * branch.equilibrium.energy,
                     branch.barrier_free ? ", reached without a push" : "",
                     branch.mirrored ? ", its mirror image is another" : "");
}

}  // namespace

void BranchShapes::forget() {
  if (branches_.empty()) return;
  branches_.clear();
  desk_.pages().tell_all(event());
}

Status BranchShapes::find() {
  const LiveDesign* design = desk_.shape().design();
  if (design == nullptr) return Error{ErrorCode::kConflict, {}, "there is no shape", "let the plan settle first"};
  const int revision = desk_.revision();
  desk_.jobs().start(
      "branches", "",
      [this, revision, model = design->model(), system = design->system(),
       pose = design->pose()](const Context& context) {
        const Pose& own = model.poses[static_cast<std::size_t>(pose)];
        const Result<StaticProblem> problem = make_static_problem(model, system, own, "/poses");
        if (!problem) return Jobs::End{Jobs::End::State::kFailed, problem.error().text(), {}};
        BranchOptions options;
        options.most_solves = 40;
        BranchSearch search = find_branches(problem.value(), own, options, context);
        const std::string detail =
            fmt::format("{} stable shape{}", search.branches.size(), search.branches.size() == 1 ? "" : "s");
        return Jobs::End{context.cancelled() ? Jobs::End::State::kCancelled : Jobs::End::State::kDone, detail,
                         [this, revision, branches = std::move(search.branches)] { show(branches, revision); }};
      });
  return {};
}

void BranchShapes::show(std::vector<Branch> branches, int revision) {
  if (revision != desk_.revision()) return;
  branches_ = std::move(branches);
  desk_.pages().tell_all(event());
  if (!branches_.empty()) desk_.pages().show_all(pack(), StudioMessage::Lane::kOrdered);
}

void BranchShapes::greet(int page) const {
  if (branches_.empty()) return;
  desk_.pages().tell(page, event());
  desk_.pages().show(page, pack(), StudioMessage::Lane::kOrdered);
}

Json BranchShapes::event() const {
  Json list = Json::array();
  const LiveDesign* design = desk_.shape().design();
  int nearest = -1;
  double least = INFINITY;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    const double distance =
        shape_distance(design->problem(), branches_[i].equilibrium.state, design->equilibrium().state, Image::kItself);
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    const Branch& branch = branches_[i];
    const double height = totals(design->system(), branch.equilibrium.state, 1).height;
    Json entry = {{"energy_mj", kMillijoules * branch.equilibrium.energy},
                  {"height_mm", kMillimetres * height},
                  {"lowest_mode_n_per_m", nullptr},
                  {"barrier_free", branch.barrier_free},
                  {"mirrored", branch.mirrored},
                  {"present", static_cast<int>(i) == nearest},
                  {"sentence", sentence_of(branch, height)}};
    if (!branch.equilibrium.modes.empty()) entry["lowest_mode_n_per_m"] = branch.equilibrium.modes.front().stiffness;
    list.push_back(std::move(entry));
  }
  return {{"event", "branches"}, {"branches", std::move(list)}};
}

Pack BranchShapes::pack() const {
  const int nodes = desk_.shape().design()->system().layout.nodes();
  std::vector<VecX> shapes;
  for (const Branch& branch : branches_) shapes.emplace_back(branch.equilibrium.state.q.head(3 * nodes));
  return shapes_pack({{"pack", "branches"}, {"topology", desk_.shape().topology()}}, "positions", shapes);
}

Status BranchShapes::take(int branch) {
  if (branch >= static_cast<int>(branches_.size())) {
    return Error{ErrorCode::kUnknown, "/branch", fmt::format("there is no shape {}", branch),
                 "search for shapes first"};
  }
  if (Status s = desk_.flip(branches_[static_cast<std::size_t>(branch)].equilibrium.state); !s) return s;
  desk_.pages().tell_all(event());
  return {};
}

}  // namespace lissom
