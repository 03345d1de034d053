#include "lissom/session/calibration_page.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/session/calibration_charts.h"
#include "lissom/session/report_figures.h"
#include "lissom/session/report_pose.h"
#include "lissom/session/report_style.h"
#include "lissom/session/report_words.h"
#include "lissom/view/text.h"

namespace lissom {

namespace {

constexpr int kWidth = 520, kHeight = 340;  // px, half of the page
constexpr double kText = 12.5;              // px

std::string cell(const std::string& text) { return "<td>" + xml_escaped(text) + "</td>"; }

std::string parameters_table(const CalibrationFit& fit, const CalibrationPage& page) {
  std::string html =
      "<div class=\"scroll\"><table><caption>What the measurements say</caption><thead><tr><td></td>"
      "<th scope=\"col\">value</th><th scope=\"col\">" +
      page.confidence +
      " interval</th><th scope=\"col\">standard error</th><th scope=\"col\">start</th>"
      "<th scope=\"col\" class=\"w\">remark</th></tr></thead><tbody>\n";
  const std::vector<CertaintyWords> words = certainty_words(fit);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const CertaintyWords& w = words[i];
    html += "<tr><th scope=\"row\">" + xml_escaped(w.name) + "</th>" + cell(w.value.empty() ? "\u2013" : w.value) +
            cell(w.interval) + cell(w.error) + "<td>" +
            report_quantity(fit.start[static_cast<Eigen::Index>(i)], measure_of(fit.parameters[i].kind)) + "</td>" +
            "<td class=\"w\">" + xml_escaped(w.remark) + "</td></tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string correlation_table(const CalibrationFit& fit) {
  if (fit.parameters.size() < 2) return {};
  std::string html =
      "<div class=\"scroll\"><table><caption>Correlation of the parameters: near 1 or -1, only their combination is "
      "well "
      "determined</caption><thead><tr><td></td>";
  for (const Parameter& p : fit.parameters) html += "<th scope=\"col\">" + xml_escaped(p.name) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    html += "<tr><th scope=\"row\">" + xml_escaped(fit.parameters[i].name) + "</th>";
    for (std::size_t j = 0; j < fit.parameters.size(); ++j) {
      html += "<td>" +
              report_number(fit.statistics.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))) +
              "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

Status add_chart(Chart chart, const std::string& caption, std::string& html) {
  chart.width = kWidth;
  chart.height = kHeight;
  chart.text_size = kText;
  const Result<std::string> picture = draw_chart(chart, ImageFormat::kInlineSvg);
  if (!picture) return picture.error();
  html += "<figure>" + picture.value() + "<figcaption>" + caption + "</figcaption></figure>\n";
  return {};
}

Result<std::string> figures(const CalibrationFit& fit, const CalibrationPage& page) {
  std::string html;
  for (const MeasuredSet& set : page.sets) {
    html += "<h3>" + xml_escaped(set.file) + "</h3>\n<div class=\"grid\">\n";
    if (!set.shapes) {
      const Status s = add_chart(fitted_chart(fit, set, "Measured and fitted"),
                                 "The fitted curve goes through the shapes that were solved.", html);
      if (!s) return s.error();
    }
    const Status s = add_chart(residual_chart(fit, set, "What is left"),
                               fmt::format("Root mean square {}, largest {}.", report_quantity(set.rms, set.measured),
                                           report_quantity(set.largest, set.measured)),
                               html);
    if (!s) return s.error();
    html += "</div>\n";
  }
  return html;
}

/// Shapes that were measured, as reports of designs show their targets: rods over each other, so nothing without rods.
Result<std::string> shapes(const CalibrationFit& fit) {
  DesignReport report;
  const Design& found = fit.problem->design();
  if (found.system.structure.rods.empty()) return std::string();
  for (std::size_t k = 0; k < fit.steps.steps.size(); ++k) {
    const CalibrationStep& step = fit.steps.steps[k];
    if (step.nodes.empty()) continue;
    std::vector<Vec3> wanted(found.system.structure.nodes.size(),
                             Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    const Goal& goal = fit.steps.goals[k];
    const State& after = fit.problem->poses()[k]->state();
    for (std::size_t i = 0; i < step.nodes.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Index c = 3 * static_cast<Eigen::Index>(i) + axis;
        // A coordinate that was not measured is drawn where it is.
        wanted[static_cast<std::size_t>(step.nodes[i])][axis] =
            goal.weights[c] > 0 ? goal.target[c] : after.position(step.nodes[i])[axis];
      }
    }
    const std::string& name = found.model.poses[static_cast<std::size_t>(step.pose)].name;
    report.poses.push_back(report_pose(name, fit.first.system, fit.first_point.states[k], found.system, after, wanted));
  }
  return report_shapes(report);
}

const char* tone_class(const CalibrationFit& fit) {
  if (fit.verdict != DesignVerdict::kConverged && fit.verdict != DesignVerdict::kGoodEnough) return "stopped";
  for (const ParameterCertainty& p : fit.statistics.parameters) {
    if (p.state != ParameterCertainty::State::kDetermined) return "stopped";
  }
  return "reached";
}

}  // namespace

Result<std::string> calibration_page_html(const CalibrationFit& fit, const CalibrationPage& page) {
  const Result<std::string> charts = figures(fit, page), drawn = shapes(fit);
  for (const Result<std::string>* part : {&charts, &drawn}) {
    if (!*part) return part->error();
  }
  const std::string title = xml_escaped(page.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
      "<meta name=\"color-scheme\" content=\"light dark\"/><title>" +
      title + " \u2013 calibration</title><style>" + report_style() + "</style></head>\n<body>\n";
  html += "<header><p class=\"eyebrow\">Calibration \u00b7 lissom " + xml_escaped(page.version) + "</p><h1>" + title +
          "</h1><p class=\"faint\">" + xml_escaped(page.document) + "</p></header>\n<main>\n";
  html += fmt::format("<section class=\"verdict {}\" aria-label=\"Verdict\"><h2>{}</h2><p>{}</p><p>{}.</p></section>\n",
                      tone_class(fit), design_verdict_info(fit.verdict).name, xml_escaped(fit.message),
                      xml_escaped(count_words(fit)));
  html += "<section aria-labelledby=\"parameters\"><h2 id=\"parameters\">Parameters</h2>\n" +
          parameters_table(fit, page) + correlation_table(fit) + "</section>\n";
  html += "<section aria-labelledby=\"fit\"><h2 id=\"fit\">Measurements</h2>\n" + charts.value() + "</section>\n";
  if (!drawn.value().empty()) {
    html += "<section aria-labelledby=\"shapes\"><h2 id=\"shapes\">Shapes</h2>\n" + drawn.value() + "</section>\n";
  }
  html += "<section aria-labelledby=\"again\"><h2 id=\"again\">How to make this again</h2>\n<pre><code>" +
          xml_escaped(page.command) + "</code></pre>\n";
  for (const std::string& note : page.notes) html += "<p>" + xml_escaped(note) + "</p>\n";
  return html + "</section>\n</main>\n</body></html>\n";
}

}  // namespace lissom
