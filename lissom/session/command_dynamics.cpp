#include "lissom/session/command_dynamics.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/session/dynamics_json.h"
#include "lissom/session/fields.h"
#include "lissom/session/motion_pictures.h"
#include "lissom/session/place_name.h"

namespace lissom {

namespace {

Result<std::vector<int>> motion_numbers(const Model& model, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const MotionCase& motion : model.motions) known.push_back(motion.name);
  std::vector<int> numbers;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      return Error{ErrorCode::kUnknown, "--motion", "there is no motion \"" + name + "\"", suggestion(name, known)};
    }
    numbers.push_back(static_cast<int>(found - known.begin()));
  }
  if (names.empty()) {
    for (int i = 0; i < static_cast<int>(known.size()); ++i) numbers.push_back(i);
  }
  if (!numbers.empty()) return numbers;
  return Error{ErrorCode::kConflict, "/motions", "the document has no motion",
               "add one that says what moves and for how long"};
}

Table motion_table(const MotionResult& result, const std::vector<std::string>& watches) {
  Table table;
  table.columns = {"time_s",
                   "load_factor",
                   "translation_energy_J",
                   "roll_energy_J",
                   "elastic_energy_J",
                   "load_potential_J",
                   "load_work_J",
                   "support_work_J",
                   "rayleigh_loss_J",
                   "numerical_loss_J",
                   "total_J",
                   "drift_J",
                   "momentum_x",
                   "momentum_y",
                   "momentum_z",
                   "angular_momentum_x",
                   "angular_momentum_y",
                   "angular_momentum_z",
                   "steps",
                   "step_s"};
  for (const std::string& watch : watches) {
    table.columns.push_back("angular_momentum_of_" + watch);
    table.columns.push_back("turn_rad_of_" + watch);
    table.columns.push_back("turn_rate_rad_per_s_of_" + watch);
  }
  for (const MotionRecord& r : result.records) {
    const EnergyLedger& l = r.ledger;
    std::vector<double> row{r.time,           r.load_factor, r.translation_energy, r.roll_energy,   r.elastic_energy,
                            r.load_potential, l.load_work,   l.support_work,       l.rayleigh_loss, l.numerical_loss,
                            r.total,          r.drift};
    row.insert(row.end(), r.momentum.data(), r.momentum.data() + 3);
    row.insert(row.end(), r.angular_momentum.data(), r.angular_momentum.data() + 3);
    row.push_back(r.steps);
    row.push_back(r.step);
    for (const WatchRecord& w : r.watches) row.insert(row.end(), {w.angular_momentum, w.turn, w.turn_rate});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Status write_files(const Document& document, const System& system, const MotionCase& motion, const std::string& stem,
                   const DynamicsCommand& command, PlayedMotion& played, Output& output) {
  const MotionResult& result = played.result;
  if (Status s = output.write(stem + ".json", dynamics_text(document, motion, played)); !s) return s;
  if (result.records.empty()) return {};
  if (Status s = output.write(stem + ".csv", csv_text(played.table)); !s) return s;
  const std::string ending = command.picture == ImageFormat::kSvg ? ".svg" : ".png";
  const std::string title = (document.model.title.empty() ? document.name : document.model.title) + ", " + motion.name;
  std::vector<std::pair<std::string, Chart>> charts{{"energy", energy_chart(title, result)}};
  if (!command.watches.empty()) {
    charts.emplace_back("momentum", momentum_chart(title, result, command.watches));
    charts.emplace_back("turn", turn_chart(title, result, command.watches));
  }
  for (const auto& [name, chart] : charts) {
    if (Status s = output.write(fmt::format("{}-{}{}", stem, name, ending), draw_chart(chart, command.picture)); !s)
      return s;
  }
  if (command.panels > 0) {
    std::vector<Drawing> drawings;
    const std::vector<int> shown = strip_records(result, command.panels);
    for (const int k : shown) {
      Result<Drawing> drawing =
          draw_state({document.model, system, result.states[k], nullptr}, document.model.pose(motion.pose));
      if (!drawing) return drawing.error();
      drawings.push_back(std::move(drawing).value());
    }
    const PictureStrip strip{
        .title = title, .field = command.field, .view = command.view, .width = command.strip_width};
    const Result<std::string> picture = draw_strip(strip, result, shown, std::move(drawings), command.picture);
    if (Status s = output.write(stem + "-strip" + ending, picture); !s) return s;
  }
  if (command.vtu == ParaView::kNo) return {};
  std::vector<double> times;
  for (const MotionRecord& r : result.records) times.push_back(r.time);
  return write_series(
      stem, times,
      [&](int i) {
        return draw_state({document.model, system, result.states[i], nullptr}, nullptr);
      },
      output);
}

}  // namespace

Result<std::vector<PlayedMotion>> dynamics_command(const Document& document, const DynamicsCommand& command,
                                                   const Context& context) {
  const Model& model = document.model;
  const Result<std::vector<int>> motions = motion_numbers(model, command.motions);
  if (!motions) return motions.error();
  MotionOptions options;
  for (const std::string& watch : command.watches) {
    const Result<Selector> place = parse_place(model, watch, "--watch");
    if (!place) return place.error();
    options.watches.push_back({watch, place.value(), command.watch_point, command.watch_axis});
  }
  const Result<System> system = make_system(model);
  if (!system) return system.error();
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  std::vector<PlayedMotion> results;
  std::vector<std::string> stems;
  for (const int m : motions.value()) {
    const MotionCase& motion = model.motions[m];
    Result<MotionResult> result =
        simulate(model, system.value(), motion, "/motions/" + std::to_string(m), options, context);
    if (!result) return result.error();
    PlayedMotion played;
    played.motion = motion.name;
    played.result = std::move(result).value();
    played.table = motion_table(played.result, command.watches);
    const std::string plain = file_name_part(document.name + "-" + motion.name);
    std::string stem = plain;
    for (int i = 2; std::find(stems.begin(), stems.end(), stem) != stems.end(); ++i)
      stem = plain + "-" + std::to_string(i);
    stems.push_back(stem);
    if (const Status s = write_files(document, system.value(), motion, stem, command, played, output); !s)
      return s.error();
    played.files = output.take_written();
    played.summary = dynamics_summary(played);
    results.push_back(std::move(played));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
