#include "lissom/studio/event_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "lissom/session/rod_places.h"
#include "lissom/session/totals.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr double kSquareMillimetres = 1e6;

std::string_view code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kFile:
      return "file";
    case ErrorCode::kSyntax:
      return "syntax";
    case ErrorCode::kUnknown:
      return "unknown";
    case ErrorCode::kType:
      return "type";
    case ErrorCode::kUnit:
      return "unit";
    case ErrorCode::kRange:
      return "range";
    case ErrorCode::kGeometry:
      return "geometry";
    case ErrorCode::kConflict:
      return "conflict";
    case ErrorCode::kUnsupported:
      return "unsupported";
  }
  return "unknown";
}

/// SI values in the units that people see.
struct Shown {
  double value;
  std::string unit;
};

Shown shown(double value, const std::string& unit) {
  if (unit == "m") return {kMillimetres * value, "mm"};
  if (unit == "rad") return {value * 180 / std::numbers::pi, "°"};
  if (unit == "Pa") return {1e-6 * value, "MPa"};
  return {value, unit == "1" ? std::string() : unit};
}

std::string place_of(const WorstElement& worst) { return worst.triangle >= 0 ? worst.membrane : worst.rod; }

Json worst_json(const Equilibrium& equilibrium) {
  Json list = Json::array();
  for (const WorstElement& worst : equilibrium.worst) {
    const Shown value = shown(worst.value, worst.unit);
    list.push_back({{"what", worst.what},
                    {"where", place_of(worst)},
                    {"value", value.value},
                    {"unit", value.unit},
                    {"node", worst.node},
                    {"edge", worst.edge},
                    {"triangle", worst.triangle}});
  }
  return list;
}

bool settled(Verdict verdict) {
  return verdict == Verdict::kStable || verdict == Verdict::kCritical || verdict == Verdict::kUnstable;
}

}  // namespace

Json error_json(const Error& error) {
  return {{"code", code_name(error.code)}, {"where", error.where}, {"message", error.message}, {"hint", error.hint}};
}

Json history_event(const History& history) {
  Json steps = Json::array();
  for (int i = 1; i <= history.size(); ++i) {
    steps.push_back({{"title", history.step(i).title}, {"seconds", history.step(i).seconds}});
  }
  return {{"event", "history"}, {"steps", std::move(steps)}, {"at", history.at()}, {"saved_at", history.saved_at()}};
}

Json verdict_event(const Equilibrium& equilibrium, const VerdictStory& story) {
  Json event = {{"event", "verdict"},
                {"name", verdict_info(equilibrium.verdict).name},
                {"sentence", equilibrium.message},
                {"settled", settled(equilibrium.verdict)},
                {"residual_n", equilibrium.residual},
                {"iterations", equilibrium.iterations},
                {"factorizations", equilibrium.factorizations},
                {"milliseconds", story.milliseconds},
                {"lowest_mode_n_per_m", nullptr},
                {"negative_modes", equilibrium.negative_modes},
                {"energy_mj", kMillijoules * equilibrium.energy},
                {"shown", story.shown},
                {"note", story.note},
                {"worst", worst_json(equilibrium)}};
  if (!equilibrium.modes.empty()) event["lowest_mode_n_per_m"] = equilibrium.modes.front().stiffness;
  return event;
}

Json measures_event(const System& system, const State& state, double energy, double share) {
  const Totals sum = totals(system, state, share);
  double length = 0, strain = 0;
  for (const StructureRod& rod : system.structure.rods) length += rest_length(system, rod);
  for (int e = 0; e < system.edge_count(); ++e) {
    const double own =
        state.edges[static_cast<std::size_t>(e)].length / system.rest.edges[static_cast<std::size_t>(e)].length - 1;
    if (std::abs(own) > std::abs(strain)) strain = own;
  }
  const Vec3 box = kMillimetres * (sum.high - sum.low);
  return {{"event", "measures"},
          {"height_mm", kMillimetres * sum.height},
          {"box_mm", {box.x(), box.y(), box.z()}},
          {"area_mm2", kSquareMillimetres * sum.area},
          {"rod_length_mm", kMillimetres * length},
          {"smallest_stretch", sum.smallest_stretch},
          {"largest_strain", strain},
          {"energy_mj", kMillijoules * energy}};
}

Json warnings_event(const std::vector<Warning>& warnings, const std::vector<bool>& one_click) {
  Json list = Json::array();
  for (std::size_t i = 0; i < warnings.size(); ++i) {
    const Warning& warning = warnings[i];
    const Shown value = shown(warning.value, warning.unit);
    list.push_back({{"what", warning.what},
                    {"where", warning.where},
                    {"value", value.value},
                    {"unit", value.unit},
                    {"remedy", warning.remedy},
                    {"nodes", warning.node >= 0 ? Json{warning.node} : Json::array()},
                    {"one_click", one_click[i]}});
  }
  return {{"event", "warnings"}, {"warnings", std::move(list)}};
}

}  // namespace lissom
