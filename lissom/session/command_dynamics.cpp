#include "lissom/session/command_dynamics.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/core/nearest_name.h"
#include "lissom/session/dynamics_json.h"
#include "lissom/session/fields.h"
#include "lissom/session/place_name.h"
#include "lissom/view/chart.h"
#include "lissom/view/picture.h"

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

std::string title_of(const Document& document, const MotionCase& motion) {
  return (document.model.title.empty() ? document.name : document.model.title) + ", " + motion.name;
}

template <class Of>
ChartSeries series(std::string name, const MotionResult& result, const Of& of) {
  ChartSeries s;
  s.name = std::move(name);
  for (const MotionRecord& r : result.records) {
    s.x.push_back(r.time);
    s.y.push_back(of(r));
  }
  return s;
}

Chart energy_chart(const std::string& title, const MotionResult& result) {
  Chart chart;
  chart.title = title;
  chart.x = {.label = "time", .unit = "s"};
  chart.y = {.label = "energy", .unit = "mJ", .display_scale = 1000};
  chart.series = {
      series("kinetic", result, [](const MotionRecord& r) { return r.translation_energy + r.roll_energy; }),
      series("elastic", result, [](const MotionRecord& r) { return r.elastic_energy; }),
      series("put in by loads and supports", result,
             [](const MotionRecord& r) { return r.ledger.load_work + r.ledger.support_work; }),
      series("lost", result, [](const MotionRecord& r) { return r.ledger.rayleigh_loss + r.ledger.numerical_loss; }),
      series("total", result, [](const MotionRecord& r) { return r.total; })};
  return chart;
}

Chart turning_chart(const std::string& title, const MotionResult& result, const std::vector<std::string>& watches) {
  Chart chart;
  chart.title = title;
  chart.x = {.label = "time", .unit = "s"};
  chart.y = {.label = "angular momentum", .unit = "g mm^2/s", .display_scale = 1e9};
  for (size_t w = 0; w < watches.size(); ++w) {
    chart.series.push_back(
        series(watches[w], result, [w](const MotionRecord& r) { return r.watches[w].angular_momentum; }));
  }
  return chart;
}

/// Pictures at equal distances in time, first and last record among them.
Result<std::string> strip(const Document& document, const System& system, const MotionCase& motion, const Pose* pose,
                          const DynamicsCommand& command, const MotionResult& result) {
  std::vector<Panel> panels;
  const int last = static_cast<int>(result.states.size()) - 1;
  const int count = std::min(command.panels, last + 1);
  for (int i = 0; i < count; ++i) {
    const int k = count > 1 ? (last * i + (count - 1) / 2) / (count - 1) : 0;
    const Result<Drawing> drawing = draw_state({document.model, system, result.states[k], nullptr}, pose);
    if (!drawing) return drawing.error();
    panels.push_back({{{drawing.value(), Layer::Style::kSolid}}, fmt::format("{:.4g} s", result.records[k].time)});
  }
  PictureOptions options;
  options.title = title_of(document, motion);
  options.field = command.field;
  options.width = 480 * std::min(count, 4);
  options.height = 560 * ((count + 3) / 4);
  options.forces = Visibility::kHidden;
  return draw_picture(panels, options, command.picture);
}

Status write_files(const Document& document, const System& system, const MotionCase& motion, const std::string& stem,
                   const DynamicsCommand& command, PlayedMotion& played, Output& output) {
  const MotionResult& result = played.result;
  if (const Status s = output.write(stem + ".json", dynamics_text(document, motion, played)); !s) return s;
  if (result.records.empty()) return {};
  if (const Status s = output.write(stem + ".csv", csv_text(played.table)); !s) return s;
  const std::string ending = command.picture == ImageFormat::kSvg ? ".svg" : ".png";
  const std::string title = title_of(document, motion);
  if (const Status s =
          output.write(stem + "-energy" + ending, draw_chart(energy_chart(title, result), command.picture));
      !s)
    return s;
  if (!command.watches.empty()) {
    const Chart chart = turning_chart(title, result, command.watches);
    if (const Status s = output.write(stem + "-turning" + ending, draw_chart(chart, command.picture)); !s) return s;
  }
  if (command.panels > 0) {
    const Pose* pose = document.model.pose(motion.pose);
    if (const Status s = output.write(stem + "-strip" + ending, strip(document, system, motion, pose, command, result));
        !s)
      return s;
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
    const size_t before = output.written().size();
    if (const Status s = write_files(document, system.value(), motion, stem, command, played, output); !s)
      return s.error();
    played.files.assign(output.written().begin() + static_cast<std::ptrdiff_t>(before), output.written().end());
    played.summary = dynamics_summary(played);
    results.push_back(std::move(played));
    if (context.cancelled()) break;
  }
  return results;
}

}  // namespace lissom
