#include "lissom/session/design_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/session/report_figures.h"
#include "lissom/session/report_style.h"
#include "lissom/session/report_tables.h"
#include "lissom/session/report_words.h"
#include "lissom/view/text.h"

namespace lissom {

namespace {

constexpr size_t kMostTiles = 8;

Status check_history(const DesignReport& report) {
  for (size_t i = 0; i < report.history.size(); ++i) {
    if (report.history[i].rms.size() == report.goals.size()) continue;
    return Error{ErrorCode::kType, fmt::format("history, step {}", i),
                 fmt::format("has {} values for {} goals", report.history[i].rms.size(), report.goals.size()),
                 "give one per goal, NaN where there is none"};
  }
  return {};
}

const char* tone_class(DesignReport::Tone tone) {
  switch (tone) {
    case DesignReport::Tone::kReached:
      return "reached";
    case DesignReport::Tone::kStopped:
      return "stopped";
    case DesignReport::Tone::kTrouble:
      break;
  }
  return "trouble";
}

/// First letter in upper case, when it is a plain one.
std::string as_heading(const std::string& text) {
  std::string heading = xml_escaped(text);
  if (!heading.empty() && heading[0] >= 'a' && heading[0] <= 'z')
    heading[0] = static_cast<char>(heading[0] - 'a' + 'A');
  return heading;
}

/// Bar whose length says how large a value is among those of its tile.
std::string bar(const char* kind, double value, double largest) {
  const double percent = std::isfinite(value) && largest > 0 ? std::clamp(100 * value / largest, 0.0, 100.0) : 0;
  return fmt::format("<span class=\"bar {}\" style=\"width:{:.1f}%\"></span>", kind, percent);
}

std::string tiles(const DesignReport& report) {
  std::string html = "<ul class=\"tiles\">\n";
  for (size_t i = 0; i < std::min(report.goals.size(), kMostTiles); ++i) {
    const DesignReport::Goal& g = report.goals[i];
    const std::string gain = report_gain(g.rms_before, g.rms_after);
    html += fmt::format(
        "<li><div class=\"name\">{}</div><div class=\"big\"><small>{} \u2192</small> {}</div>{}{}<div "
        "class=\"name\">RMS before "
        "\u2192 after{}</div></li>\n",
        xml_escaped(g.name), report_value(g.rms_before, g.measure), report_quantity(g.rms_after, g.measure),
        bar("before", g.rms_before, std::max(g.rms_before, g.rms_after)),
        bar("after", g.rms_after, std::max(g.rms_before, g.rms_after)), gain.empty() ? "" : ": " + gain);
  }
  html += "</ul>\n";
  if (report.goals.size() > kMostTiles) {
    html += fmt::format("<p class=\"faint\">{} more in the table of goals.</p>\n",
                        report_count(static_cast<int>(report.goals.size() - kMostTiles), "goal", "goals"));
  }
  return html;
}

/// What it took, in a sentence.
std::string facts(const DesignReport& report) {
  const auto bound = std::count_if(report.parameters.begin(), report.parameters.end(),
                                   [](const auto& p) { return p.bound != DesignReport::Parameter::Bound::kFree; });
  const int iterations = report.history.empty() ? 0 : report.history.back().iteration;
  std::string html = "<p>" + report_count(iterations, "accepted iteration", "accepted iterations") + " in " +
                     report_time(report.seconds) + ". ";
  if (!report.history.empty()) {
    html += "The objective went from " + report_number(report.history.front().objective) + " to " +
            report_number(report.history.back().objective) + ". ";
  }
  return html + fmt::format("{} of {} at a bound.</p>\n", bound,
                            report_count(static_cast<int>(report.parameters.size()), "parameter is", "parameters are"));
}

std::string head(const DesignReport& report) {
  const std::string title = xml_escaped(report.title.empty() ? report.document : report.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
      "<meta name=\"color-scheme\" content=\"light dark\"/><title>" +
      title + " \u2013 inverse design</title><style>" + report_style() + "</style></head>\n<body>\n";
  html += "<header><p class=\"eyebrow\">Inverse design report" +
          (report.version.empty() ? std::string() : " \u00b7 lissom " + xml_escaped(report.version)) + "</p><h1>" +
          title + "</h1>";
  if (!report.document.empty()) html += "<p class=\"faint\">" + xml_escaped(report.document) + "</p>";
  return html + "</header>\n<main>\n";
}

std::string verdict(const DesignReport& report) {
  std::string html = fmt::format("<section class=\"verdict {}\" aria-label=\"Verdict\"><h2>{}</h2><p>{}</p>",
                                 tone_class(report.tone), as_heading(report.verdict), xml_escaped(report.sentence));
  if (!report.remedy.empty()) html += "<p><strong>What to do:</strong> " + xml_escaped(report.remedy) + "</p>";
  html += "</section>\n" + tiles(report) + facts(report);
  if (!report.warnings.empty()) {
    html += "<section class=\"verdict stopped\" aria-label=\"Warnings\"><h2>" +
            as_heading(report_count(static_cast<int>(report.warnings.size()), "warning", "warnings")) + "</h2><ul>";
    for (const std::string& warning : report.warnings) html += "<li>" + xml_escaped(warning) + "</li>";
    html += "</ul></section>\n";
  }
  return html;
}

std::string reproduction(const DesignReport& report) {
  std::string html = "<pre><code>" + xml_escaped(report.command) + "</code></pre>\n<dl>";
  const auto row = [&](const std::string& name, const std::string& value) {
    html += "<dt>" + name + "</dt><dd>" + value + "</dd>";
  };
  row("lissom", xml_escaped(report.version));
  row("seed", report.seed ? std::to_string(*report.seed) : "none: nothing was random");
  row("method", xml_escaped(report.method));
  for (const DesignReport::Named& option : report.options) row(xml_escaped(option.name), xml_escaped(option.value));
  html += "</dl>\n";
  if (!report.files.empty()) {
    html += "<h3>Files written</h3><ul>";
    for (const std::string& file : report.files) html += "<li>" + xml_escaped(file) + "</li>";
    html += "</ul>\n";
  }
  return html;
}

}  // namespace

Result<std::string> design_report_html(const DesignReport& report) {
  if (const Status s = check_history(report); !s) return s.error();
  const Result<std::string> convergence = report_convergence(report), shapes = report_shapes(report),
                            histograms = report_histograms(report);
  for (const Result<std::string>* part : {&convergence, &shapes, &histograms}) {
    if (!*part) return part->error();
  }
  struct Chapter {
    const char *id, *name;
    std::string body;
  };
  const std::vector<Chapter> chapters = {
      {"shapes", "Shapes", shapes.value()},
      {"project", "Project", report_plain_tables(report.project)},
      {"print", "Print", report_plain_tables(report.print)},
      {"goals", "Goals", report.goals.empty() ? std::string() : report_goals(report)},
      {"convergence", "Convergence", convergence.value() + (report.history.empty() ? "" : report_history(report))},
      {"parameters", "Parameters",
       report.parameters.empty() ? std::string() : histograms.value() + report_parameters(report)},
      {"time", "Where the time went", report_effort(report)},
      {"again", "How to make this again", reproduction(report)}};
  std::string html = head(report) + verdict(report) + "<nav aria-label=\"Sections\">";
  for (const Chapter& s : chapters) {
    if (!s.body.empty()) html += fmt::format("<a href=\"#{}\">{}</a> ", s.id, s.name);
  }
  html += "</nav>\n";
  for (const Chapter& s : chapters) {
    if (s.body.empty()) continue;
    html += fmt::format("<section aria-labelledby=\"{0}\"><h2 id=\"{0}\">{1}</h2>\n", s.id, s.name) + s.body +
            "</section>\n";
  }
  return html + "</main>\n</body></html>\n";
}

}  // namespace lissom
