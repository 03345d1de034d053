#include "lissom/studio/shape_tools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "lissom/design/constrained_step.h"
#include "lissom/studio/design_edit.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/event_json.h"
#include "lissom/studio/fit_job.h"
#include "lissom/studio/shape_constraints.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr double kKeptShare = 2e-3;  // of a mode's amplitude: by so much constraints may be off after it is adopted
constexpr int kShownChanges = 10;

const Error kNoShape{ErrorCode::kConflict, {}, "there is no settled shape to work on", "let it settle first"};
const Error kNoHandle{ErrorCode::kConflict, {}, "nothing is taken hold of", "select a part of the shape first"};

/// What a mode is about, for people.
std::pair<const char*, std::string> group_of(const ShapeMode& mode) {
  const double most = std::max({mode.radii, mode.positions, mode.pre_stretch});
  const char* group = most == mode.positions ? "points" : most == mode.radii ? "radii" : "stretch";
  const char* what = most == mode.positions ? "moves points of the plan"
                     : most == mode.radii   ? "changes radii"
                                            : "changes the stretch";
  return {group, most > 0.9 ? std::string("Only ") + what : fmt::format("Mostly {} ({:.0f} %)", what, 100 * most)};
}

std::string handle_sentence(const Handle::Preview& preview) {
  if (!preview.refused.empty()) {
    return fmt::format("Pulled too far to be built as it is: {}. Pull less, or accept it and see how near it comes",
                       preview.refused);
  }
  if (!preview.lags.empty()) {
    return fmt::format("Follows as far as it can be built, {:.2f} mm behind the pull: {}. Accept it and go on",
                       kMillimetres * preview.answer.rms, preview.lags);
  }
  if (preview.stale) {
    return fmt::format("Pulled far: rods turn by {:.0f} degrees, more than a preview is good for. Accept it and go on",
                       preview.turn * 180 / std::numbers::pi);
  }
  return fmt::format("Misses where it is pulled to by {:.2f} mm", kMillimetres * preview.answer.rms);
}

}  // namespace

PlanSpaceOptions tool_space() {
  PlanSpaceOptions options;
  options.radius_range = {0.25e-3, 4e-3};  // printers make 0.5 mm and more
  options.pre_stretch_range = {1.05, 1.8};
  options.reach = 0.05;  // of points, in one pull
  return options;
}

void ShapeTools::design_changed() {
  response_.reset();
  if (!modes_.empty() && !modes_stale_) {
    modes_stale_ = true;
    desk_.pages().tell_all(modes_event());
  }
  if (handle_) release_handle();
}

void ShapeTools::forget() {
  response_.reset();
  modes_of_.reset();
  modes_.clear();
  modes_stale_ = true;
  if (handle_) release_handle();
}

void ShapeTools::greet(int page) const {
  if (!modes_.empty()) {
    desk_.pages().tell(page, modes_event());
    if (!modes_stale_) desk_.pages().show(page, modes_pack(), StudioMessage::Lane::kOrdered);
  }
  desk_.pages().tell(page, handle_event());
}

Result<ShapeTools::Wanted> ShapeTools::wanted() const {
  const LiveDesign* design = desk_.shape().design();
  const ShapeSnapshot shape = desk_.shape().snapshot();
  if (design == nullptr || !shape.state) return kNoShape;
  Wanted wanted;
  wanted.start = {shape.mesh, design->model(), design->pose(), *shape.state};
  wanted.pins = desk_.shape().pins();
  return wanted;
}

Result<std::shared_ptr<const ShapeResponse>> ShapeTools::response() {
  if (response_) return response_;
  Result<Wanted> wanted = this->wanted();
  if (!wanted) return wanted.error();
  Result<std::shared_ptr<const ShapeResponse>> made =
      ShapeResponse::make(std::move(wanted.value().start), tool_space(), std::move(wanted.value().pins), {});
  if (made) response_ = made.value();
  return made;
}

Status ShapeTools::find_modes(int count) {
  Result<Wanted> wanted = this->wanted();
  if (!wanted) return wanted.error();
  const auto known = response_;
  const PlanParts parts = desk_.shape().parts();
  const int revision = desk_.revision();
  desk_.jobs().start(
      "modes", "", [this, wanted = std::move(wanted).value(), known, parts, count, revision](const Context& context) {
        Result<std::shared_ptr<const ShapeResponse>> response =
            known ? Result<std::shared_ptr<const ShapeResponse>>(known)
                  : ShapeResponse::make(wanted.start, tool_space(), wanted.pins, context);
        if (!response) return Jobs::End{Jobs::End::State::kFailed, response.error().text(), {}};
        if (context.cancelled()) return Jobs::End{Jobs::End::State::kCancelled, "stopped", {}};
        const HardConstraints constraints = hard_constraints(wanted.start.model, parts, response.value()->parameters());
        std::vector<ShapeMode> modes = shape_modes(*response.value(), constraints, count);
        return Jobs::End{Jobs::End::State::kDone, fmt::format("{} modes", modes.size()),
                         [this, response = response.value(), modes = std::move(modes), revision] {
                           if (revision == desk_.revision()) take_modes(response, modes);
                         }};
      });
  return {};
}

void ShapeTools::take_modes(std::shared_ptr<const ShapeResponse> response, std::vector<ShapeMode> modes) {
  response_ = response;
  modes_of_ = std::move(response);
  modes_ = std::move(modes);
  modes_stale_ = false;
  desk_.pages().tell_all(modes_event());
  desk_.pages().show_all(modes_pack(), StudioMessage::Lane::kOrdered);
}

Json ShapeTools::modes_event() const {
  Json list = Json::array();
  for (const ShapeMode& mode : modes_) {
    const auto [group, sentence] = group_of(mode);
    list.push_back({{"value", mode.strength}, {"group", group}, {"sentence", sentence}});
  }
  return {{"event", "modes"}, {"stale", modes_stale_}, {"modes", std::move(list)}};
}

Pack ShapeTools::modes_pack() const {
  std::vector<VecX> shapes;
  Json values = Json::array();
  const int nodes = modes_of_->system().layout.nodes();
  for (const ShapeMode& mode : modes_) {
    // 1 mm for the node that moves most.
    shapes.emplace_back(mode.shape.head(3 * nodes) / kMillimetres);
    values.push_back(mode.strength);
  }
  return shapes_pack({{"pack", "modes"}, {"topology", desk_.shape().topology()}, {"values", values}}, "displacements",
                     shapes);
}

Result<Json> ShapeTools::adopt_mode(int mode, double amplitude) {
  if (mode < 0 || mode >= static_cast<int>(modes_.size())) {
    return Error{ErrorCode::kUnknown, "/mode", fmt::format("there is no mode {}", mode), "compute the modes first"};
  }
  if (modes_stale_ || modes_of_ != response_) {
    return Error{ErrorCode::kConflict, "/mode", "the design has changed since the modes were computed",
                 "compute them anew"};
  }
  const std::shared_ptr<const ShapeResponse> from = modes_of_;
  const HardConstraints constraints = hard_constraints(from->start().model, desk_.shape().parts(), from->parameters());
  const VecX change = amplitude * modes_[static_cast<std::size_t>(mode)].parameters;
  const Result<ConstrainedStep> step =
      constrained_step(*from, constraints, change, kKeptShare * std::abs(amplitude), {});
  if (!step) return step.error();
  const ShapeSnapshot present = desk_.shape().snapshot();
  const ShapeSnapshot shape{present.mesh, present.mesh_of, std::make_shared<const State>(step.value().state)};
  const std::string title = fmt::format("Adopt mode {} at {:.3g} mm", mode + 1, kMillimetres * amplitude);
  desk_.jobs().cancel({});
  const Json edit = design_edit(step.value().design.model, title);
  desk_.commit(title, edit.dump(), step.value().design.model, &shape);
  return Json{{"title", title}, {"constraint_mm", kMillimetres * step.value().violation}, {"cut", step.value().cut}};
}

Result<Json> ShapeTools::begin_handle(const HandleGrip& grip) {
  if (handle_) release_handle();
  const Result<std::shared_ptr<const ShapeResponse>> response = this->response();
  if (!response) return response.error();
  const HardConstraints constraints =
      hard_constraints(response.value()->start().model, desk_.shape().parts(), response.value()->parameters());
  Result<Handle> handle = Handle::make(response.value(), constraints, grip, {});
  if (!handle) return handle.error();
  handle_.emplace(std::move(handle).value());
  desk_.pages().tell_all(handle_event());
  const Vec3 centre = kMillimetres * handle_->centre();
  return Json{{"center_mm", {centre.x(), centre.y(), centre.z()}},
              {"weights", handle_->edit().pulled().size()},
              {"parameters", response.value()->size()}};
}

Json ShapeTools::handle_event() const {
  Json event = {{"event", "handle"}, {"active", handle_.has_value()}, {"stale", false}, {"sentence", ""}};
  if (!handle_) return event;
  const Vec3 centre = kMillimetres * handle_->centre();
  event["center_mm"] = {centre.x(), centre.y(), centre.z()};
  event["radius_mm"] = kMillimetres * handle_->grip().radius;
  if (const Handle::Preview* last = handle_->last(); last != nullptr) {
    event["stale"] = last->far();
    event["sentence"] = handle_sentence(*last);
  }
  return event;
}

Result<Json> ShapeTools::move_handle(const HandleMove& move) {
  if (!handle_) return kNoHandle;
  const auto begin = std::chrono::steady_clock::now();
  const bool was_far = handle_->last() != nullptr && handle_->last()->far();
  const Result<Handle::Preview> preview = handle_->move(move);
  if (!preview) return preview.error();
  const Handle::Preview& answer = preview.value();
  const ShapeResponse& response = handle_->edit().response();
  std::vector<float> target(4 * static_cast<std::size_t>(response.system().layout.nodes()), 0);
  const std::vector<PulledNode>& pulled = handle_->edit().pulled();
  for (std::size_t i = 0; i < pulled.size(); ++i) {
    const Vec3 at =
        response.start().state.position(pulled[i].node) + answer.wanted.segment<3>(3 * static_cast<Eigen::Index>(i));
    float* entry = &target[4 * static_cast<std::size_t>(pulled[i].node)];
    for (int k = 0; k < 3; ++k) entry[k] = static_cast<float>(kMillimetres * at[k]);
    entry[3] = static_cast<float>(pulled[i].weight);
  }
  Json changes = Json::array();
  for (const ParameterChange& change :
       largest_changes(response.parameters(), response.p(), answer.answer.p, kShownChanges)) {
    const Parameter& parameter = response.parameters()[static_cast<std::size_t>(change.parameter)];
    const bool length = parameter.kind != ParameterKind::kPreStretch;
    const double scale = length ? kMillimetres : 1;
    changes.push_back({{"parameter", parameter.name},
                       {"unit", length ? "mm" : ""},
                       {"from", scale * change.from},
                       {"to", scale * change.to},
                       {"at_bound", change.at_bound}});
  }
  Json header = {{"pack", "preview"},
                 {"topology", desk_.shape().topology()},
                 {"drag", 0},
                 {"residual_n", answer.refused.empty() ? Json(answer.residual) : Json(nullptr)},
                 {"stale", answer.far()},
                 {"milliseconds", milliseconds_since(begin)},
                 {"changes", std::move(changes)},
                 {"rms_mm", kMillimetres * answer.answer.rms}};
  desk_.pages().show_all(places_pack(std::move(header), response.system(), answer.state, target),
                         StudioMessage::Lane::kPreview);
  if (was_far != answer.far()) desk_.pages().tell_all(handle_event());
  return Json{{"milliseconds", milliseconds_since(begin)}};
}

Result<Json> ShapeTools::set_radius(double radius) {
  if (!handle_) return kNoHandle;
  if (Status s = handle_->set_radius(radius); !s) return s.error();
  desk_.pages().tell_all(handle_event());
  return Json{{"weights", handle_->edit().pulled().size()}};
}

Result<Json> ShapeTools::accept_handle() {
  if (!handle_) return kNoHandle;
  if (handle_->last() == nullptr) {
    return Error{ErrorCode::kConflict, {}, "the handle has not been moved", "pull at it first"};
  }
  const ShapeSnapshot present = desk_.shape().snapshot();
  start_fit(desk_, {handle_->edit().shared_response(), handle_->edit().constraints(), handle_->target(), present.mesh,
                    present.mesh_of, desk_.revision()});
  return Json::object();
}

void ShapeTools::release_handle() {
  handle_.reset();
  desk_.pages().tell_all(handle_event());
}

}  // namespace lissom
