#include "lissom/session/report_tables.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "lissom/session/report_words.h"
#include "lissom/view/text.h"

namespace lissom {

namespace {

using Parameter = DesignReport::Parameter;

constexpr size_t kMostPulled = 20;

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// Opens a table that scrolls by itself when the page is narrow. Columns whose names start with '<' hold words.
std::string open_table(const std::string& caption, const std::vector<std::string>& columns) {
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" + caption +
                     "\"><table><caption>" + caption + "</caption><thead><tr>";
  for (const std::string& name : columns) {
    const bool words = name[0] == '<';
    html += fmt::format("<th scope=\"col\"{}>{}</th>", words ? " class=\"w\"" : "", words ? name.substr(1) : name);
  }
  return html + "</tr></thead><tbody>\n";
}

constexpr const char* kCloseTable = "</tbody></table></div>\n";

/// Where a value is between its bounds: a mark for the start and one for the end.
std::string place_between(const Parameter& p) {
  const double extent = p.upper - p.lower;
  if (!std::isfinite(extent) || !(extent > 0) || !std::isfinite(p.value + p.start)) return "<td></td>";
  const auto percent = [&](double v) { return 100 * std::clamp((v - p.lower) / extent, 0.0, 1.0); };
  return fmt::format(
      "<td><span class=\"between\" role=\"img\" aria-label=\"{:.0f} % of the way from the lower to the upper bound\">"
      "<i class=\"was\" style=\"left:{:.0f}%\"></i><i class=\"is\" style=\"left:{:.0f}%\"></i></span></td>",
      percent(p.value), percent(p.start), percent(p.value));
}

const char* bound_words(Parameter::Bound bound) {
  switch (bound) {
    case Parameter::Bound::kLower:
      return "lower";
    case Parameter::Bound::kUpper:
      return "upper";
    case Parameter::Bound::kFree:
      break;
  }
  return "";
}

std::string bound_text(double bound, const DesignReport::Measure& measure) {
  return std::isinf(bound) ? "none" : report_quantity(bound, measure);
}

std::string parameter_row(const Parameter& p) {
  return fmt::format("<tr><th scope=\"row\">{}</th>", xml_escaped(p.name)) + cell(report_quantity(p.start, p.measure)) +
         cell(report_quantity(p.value, p.measure)) + cell(bound_text(p.lower, p.measure)) +
         cell(bound_text(p.upper, p.measure)) + place_between(p) + cell(report_number(p.gradient, 2)) +
         cell(bound_words(p.bound)) + "</tr>\n";
}

const std::vector<std::string> kParameterColumns = {"<Parameter",  "Before",   "After",    "Lower bound",
                                                    "Upper bound", "<Between", "Gradient", "At bound"};

}  // namespace

std::string report_goals(const DesignReport& report) {
  std::string html = open_table("Goals, by the root mean square (RMS) of their deviations",
                                {"<Goal", "<Pose", "RMS before", "RMS after", "<", "Largest before", "Largest after"});
  for (const DesignReport::Goal& g : report.goals) {
    html +=
        fmt::format("<tr><th scope=\"row\">{}</th><td class=\"w\">{}</td>", xml_escaped(g.name), xml_escaped(g.pose));
    html += cell(report_quantity(g.rms_before, g.measure)) + cell(report_quantity(g.rms_after, g.measure));
    html += "<td class=\"w\">" + report_gain(g.rms_before, g.rms_after) + "</td>";
    html += cell(report_quantity(g.largest_before, g.measure)) + cell(report_quantity(g.largest_after, g.measure));
    html += "</tr>\n";
  }
  return html + kCloseTable;
}

std::string report_plain_tables(const std::vector<DesignReport::Table>& tables) {
  std::string html;
  for (const DesignReport::Table& table : tables) {
    html += open_table(xml_escaped(table.caption), table.columns);
    for (const std::vector<std::string>& row : table.rows) {
      html += "<tr>";
      for (size_t i = 0; i < row.size(); ++i) {
        const bool words = i < table.columns.size() && table.columns[i].starts_with('<');
        html += words ? "<td class=\"w\">" + xml_escaped(row[i]) + "</td>" : cell(xml_escaped(row[i]));
      }
      html += "</tr>\n";
    }
    html += kCloseTable;
  }
  return html;
}

std::string report_history(const DesignReport& report) {
  std::vector<std::string> columns{"Iteration", "Time", "Objective", "Gradient", "At bound", "Radius", "<Stage"};
  for (const DesignReport::Goal& g : report.goals) {
    columns.push_back("RMS " + xml_escaped(g.name) + report_unit(g.measure));
  }
  std::string html = "<details><summary>All iterations as numbers</summary>\n" +
                     open_table("Accepted iterations; number 0 is the start", columns);
  for (const DesignReport::Step& s : report.history) {
    html += fmt::format("<tr><th scope=\"row\" class=\"n\">{}</th>", s.iteration) + cell(report_time(s.seconds)) +
            cell(report_number(s.objective, 4)) + cell(report_number(s.gradient)) +
            cell(std::to_string(s.active_bounds)) + cell(report_number(s.radius)) + "<td class=\"w\">" +
            xml_escaped(s.stage) + "</td>";
    for (size_t g = 0; g < s.rms.size(); ++g) html += cell(report_value(s.rms[g], report.goals[g].measure));
    html += "</tr>\n";
  }
  return html + kCloseTable + "</details>\n";
}

std::string report_parameters(const DesignReport& report) {
  const std::vector<Parameter>& all = report.parameters;
  std::vector<size_t> order(all.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto pull = [&](size_t i) { return std::isfinite(all[i].gradient) ? std::abs(all[i].gradient) : 0; };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    if (pull(a) != pull(b)) return pull(a) > pull(b);
    return all[a].bound != Parameter::Bound::kFree && all[b].bound == Parameter::Bound::kFree;
  });
  const size_t shown = std::min(order.size(), kMostPulled);
  std::string html =
      "<p>A bound that holds back a large gradient is where a wider bound would help most; a large gradient without a "
      "bound says that the search was not over.</p>\n" +
      open_table(shown < order.size() ? fmt::format("The {} parameters with the largest remaining gradient", shown)
                                      : "Parameters, those with the largest remaining gradient first",
                 kParameterColumns);
  for (size_t i = 0; i < shown; ++i) html += parameter_row(all[order[i]]);
  html += kCloseTable;
  if (shown == order.size()) return html;
  html += fmt::format("<details><summary>All {} parameters in the order of the design</summary>\n", all.size()) +
          open_table("All parameters", kParameterColumns);
  for (const Parameter& p : all) html += parameter_row(p);
  return html + kCloseTable + "</details>\n";
}

std::string report_effort(const DesignReport& report) {
  std::vector<DesignReport::Share> shares = report.shares;
  double known = 0;
  for (const DesignReport::Share& s : shares) known += std::isfinite(s.seconds) ? s.seconds : 0;
  if (report.seconds - known > 0.005 * report.seconds) shares.push_back({"other", report.seconds - known});
  const double whole = std::max(report.seconds, known);
  std::string html;
  if (whole > 0) {
    html +=
        open_table("Time by kind of work; " + report_time(report.seconds) + " in all", {"<Work", "Time", "Share", "<"});
    for (const DesignReport::Share& s : shares) {
      const double percent = std::isfinite(s.seconds) ? std::clamp(100 * s.seconds / whole, 0.0, 100.0) : 0;
      html +=
          fmt::format("<tr><th scope=\"row\">{}</th>", xml_escaped(s.name)) + cell(report_time(s.seconds)) +
          cell(fmt::format("{:.0f}\u202f%", percent)) +
          fmt::format("<td class=\"wide\"><span class=\"bar\" style=\"width:{:.1f}%\"></span></td></tr>\n", percent);
    }
    html += kCloseTable;
  }
  const DesignReport::Size& size = report.size;
  html += "<p>The problem: " + report_count(size.rods, "rod", "rods") + ", " +
          report_count(size.nodes, "node", "nodes") + ", " + report_count(size.unknowns, "unknown", "unknowns") +
          " per pose, " + report_count(size.poses, "pose", "poses") + ", " +
          report_count(size.parameters, "parameter", "parameters") + ", " + report_count(size.goals, "goal", "goals") +
          ".</p>\n";
  return html;
}

}  // namespace lissom
