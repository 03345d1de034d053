#include "lissom/session/command_calibrate.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/model/document.h"
#include "lissom/session/calibration_charts.h"
#include "lissom/session/calibration_json.h"
#include "lissom/session/calibration_page.h"
#include "lissom/session/command_optimize.h"
#include "lissom/session/layout_json.h"
#include "lissom/session/measurement_files.h"
#include "lissom/session/output.h"

namespace lissom {

namespace {

std::string set_words(const MeasuredSet& set) {
  const double scale = set.measured.display_scale;
  return fmt::format("{}: {} {}, root mean square deviation {:.3g} {}, largest {:.3g} {}", set.file, set.numbers.size(),
                     set.shapes     ? "coordinates"
                     : set.by_force ? "lengths"
                                    : "forces",
                     scale * set.rms, set.measured.unit, scale * set.largest, set.measured.unit);
}

Status write_charts(const CalibrationFit& fit, const std::vector<MeasuredSet>& sets, const std::string& stem,
                    ImageFormat format, Output& output) {
  const char* ending = format == ImageFormat::kSvg ? ".svg" : ".png";
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string number = sets.size() == 1 ? "" : fmt::format("-{}", i);
    const std::string residuals = stem + "-residuals" + number + ending, curve = stem + number + ending;
    if (!sets[i].shapes) {
      const Status s = output.write(curve, draw_chart(fitted_chart(fit, sets[i], sets[i].file), format));
      if (!s) return s;
    }
    const Status s = output.write(residuals, draw_chart(residual_chart(fit, sets[i], sets[i].file), format));
    if (!s) return s;
  }
  return {};
}

Status write_results(const CalibrationFit& fit, const Document& document, const CalibrateCommand& command,
                     CalibratedDocument& done, Output& output) {
  const Calibration& calibration = *document.model.calibration;
  const std::vector<MeasuredSet> sets = measured_sets(fit, calibration.measurements);
  for (const MeasuredSet& set : sets) done.sets.push_back(set_words(set));
  nlohmann::ordered_json summary{{"document", document.name}};
  summary.update(calibration_summary_json(fit, calibration.confidence));
  summary["notes"] = done.notes;
  nlohmann::ordered_json whole = summary;
  whole["measurements"] = measured_sets_json(fit, sets);
  const std::string stem = document.name + "-calibration", found = document.name + "-calibrated.lissom";
  // It stands for itself, as it lies in another folder than the files that its base may name.
  if (const Status s = output.write(found, write_document(fit.model, NetworkText::kRods)); !s) return s;
  if (const Status s = output.write(stem + ".json", json_lines(whole)); !s) return s;
  if (const Status s = write_charts(fit, sets, stem, command.picture, output); !s) return s;
  CalibrationPage page;
  page.title = document.model.title.empty() ? document.name : document.model.title;
  page.document = document.name;
  page.confidence = done.confidence;
  page.sets = sets;
  page.notes = done.notes;
  page.command = command.line;
  page.version = command.version;
  if (const Status s = output.write(stem + ".html", calibration_page_html(fit, page)); !s) return s;
  done.files = output.take_written();
  summary["files"] = file_list(done.files);
  done.summary = json_line(summary);
  return {};
}

/// What the document got all the same.
void note_undetermined(const CalibrationFit& fit, std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const ParameterCertainty::State state = fit.statistics.parameters[i].state;
    if (state != ParameterCertainty::State::kUndetermined && state != ParameterCertainty::State::kUncertain) continue;
    const DesignReport::Measure measure = measure_of(fit.parameters[i].kind);
    notes.push_back(fmt::format("{} is {:.4g}{}{} in the calibrated document, one of many values that fit as well",
                                fit.parameters[i].name,
                                measure.display_scale * fit.values[static_cast<Eigen::Index>(i)],
                                measure.unit.empty() ? "" : " ", measure.unit));
  }
}

int code_of(const CalibrationFit& fit) {
  const int code = exit_code(fit.verdict);
  if (code != 0) return code;
  const bool all =
      std::all_of(fit.statistics.parameters.begin(), fit.statistics.parameters.end(),
                  [](const ParameterCertainty& p) { return p.state == ParameterCertainty::State::kDetermined; });
  return all ? 0 : kNotDetermined;
}

}  // namespace

Result<CalibratedDocument> calibrate_command(const Document& document, const CalibrateCommand& command,
                                             const Context& context) {
  const Model& model = document.model;
  if (!model.calibration) {
    return Error{ErrorCode::kConflict, "/calibration",
                 "the document does not say what is unknown and what was measured",
                 "describe it under \"calibration\""};
  }
  Result<System> system = make_system(model);
  if (!system) return system.error();
  const Design base{model, std::move(system).value()};
  Result<MeasurementFiles> files = read_measurements(base, document.folder);
  if (!files) return files.error();
  Context quiet = context;
  quiet.log = {};
  const Result<CalibrationFit> made = fit_calibration(base, files.value().data, quiet);
  if (!made) return made.error();
  const CalibrationFit& fit = made.value();
  CalibratedDocument done;
  done.verdict = fit.verdict;
  done.message = fit.message;
  done.iterations = fit.iterations;
  done.parameters = certainty_words(fit);
  done.counts = count_words(fit);
  done.confidence = confidence_words(model.calibration->confidence);
  done.notes = std::move(files.value().notes);
  note_undetermined(fit, done.notes);
  done.code = code_of(fit);
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  if (const Status s = write_results(fit, document, command, done, output); !s) return s.error();
  return done;
}

}  // namespace lissom
