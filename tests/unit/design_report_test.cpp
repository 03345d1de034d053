#include "lissom/session/design_report.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "lissom/session/report_words.h"
#include "tests/unit/picture_samples.h"
#include "tests/unit/xml_check.h"

namespace lissom {
namespace {

using samples::count;
using samples::strip;
using samples::xml_fault;

Drawing arch(double height) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 8; ++i) points.push_back({0.0125 * i, 0, height * std::sin(3.14159265 * i / 8)});
  Drawing drawing;
  drawing.rods = {strip("arch", points, 0.001, 0.001)};
  return drawing;
}

DesignReport::Pose arch_pose(const std::string& name) {
  DesignReport::Pose pose{.name = name, .target = arch(0.03), .before = arch(0.01), .after = arch(0.029)};
  Field field = samples::edge_field("deviation", {});
  field.colors = Field::Colors::kSequential;
  field.place = Field::Place::kNode;
  for (size_t i = 0; i < pose.after.rods[0].points.size(); ++i) {
    pose.targets.push_back(
        {pose.target.rods[0].points[i], pose.before.rods[0].points[i], pose.after.rods[0].points[i]});
    field.values.push_back((pose.targets[i].after - pose.targets[i].wanted).norm());
  }
  pose.after.fields = {field};
  return pose;
}

DesignReport sample() {
  using Bound = DesignReport::Parameter::Bound;
  DesignReport report{.title = "Arch",
                      .document = "arch.json",
                      .verdict = "settled at a minimum",
                      .sentence = "No allowed change of a parameter brings the shape nearer.",
                      .remedy = "Allow thinner rods.",
                      .method = "trust region"};
  report.size = {.rods = 1, .nodes = 9, .unknowns = 35, .poses = 2, .parameters = 3, .goals = 2};
  report.seconds = 4;
  report.shares = {{"solving", 3}, {"derivatives", 0.5}};
  report.goals = {{.name = "bent", .pose = "bent", .rms_before = 0.02, .rms_after = 0.001, .largest_before = 0.03},
                  {.name = "tension", .pose = "pulled", .measure = {"N", 1}, .rms_before = 2, .rms_after = 1}};
  for (int i = 0; i < 5; ++i) {
    report.history.push_back({.iteration = i,
                              .seconds = 0.8 * i,
                              .objective = std::pow(10, -i),
                              .gradient = std::pow(10, -i),
                              .active_bounds = i / 2,
                              .radius = 1,
                              .stage = i < 2 ? "coarse" : "fine",
                              .rms = {0.02 / (i + 1), 2.0 / (i + 1)}});
  }
  report.parameters = {{"r0", "radius", {}, 0.001, 0.002, 0.0005, 0.004, 1e-6, Bound::kFree},
                       {"r1", "radius", {}, 0.001, 0.0005, 0.0005, 0.004, 0.3, Bound::kLower},
                       {"s", "pre-stretch", {"", 1}, 1.4, 1.8, 1, 1.8, -0.1, Bound::kUpper}};
  report.poses = {arch_pose("bent"), {.name = "pulled", .before = arch(0), .after = arch(0.001)}};
  report.warnings = {"The rods touch."};
  report.files = {"arch-designed.json"};
  report.command = "lissom optimize arch.json";
  report.version = "1.2.3";
  report.seed = 7;
  return report;
}

std::string html_of(const DesignReport& report) {
  const Result<std::string> html = design_report_html(report);
  EXPECT_TRUE(html.ok()) << html.error().text();
  return html.ok() ? html.value() : std::string();
}

TEST(DesignReport, IsWellFormedAndReproducible) {
  const std::string html = html_of(sample());
  EXPECT_EQ(xml_fault(html), "");
  EXPECT_EQ(html, html_of(sample()));
}

TEST(DesignReport, RefersToNothingOutside) {
  const std::string html = html_of(sample());
  for (const char* reference : {"http", "//", "url(", "@import", "src=", "<script", "<link", "<iframe", "<object"}) {
    EXPECT_EQ(count(html, reference), 0u) << reference;
  }
  std::set<std::string> ids;
  for (size_t at = html.find(" id=\""); at != std::string::npos; at = html.find(" id=\"", at + 1)) {
    EXPECT_TRUE(ids.insert(html.substr(at + 5, html.find('"', at + 5) - at - 5)).second);
  }
  for (size_t at = html.find("href=\""); at != std::string::npos; at = html.find("href=\"", at + 1)) {
    EXPECT_EQ(html[at + 6], '#');
    EXPECT_EQ(ids.count(html.substr(at + 7, html.find('"', at + 7) - at - 7)), 1u);
  }
}

TEST(DesignReport, SaysFirstWhatCameOfIt) {
  const std::string html = html_of(sample());
  const size_t verdict = html.find("Settled at a minimum"), remedy = html.find("Allow thinner rods.");
  const size_t figures = html.find("20 \u2192</small> 1\u202fmm"), gain = html.find("20 times closer");
  for (const size_t at : {verdict, remedy, figures, gain}) ASSERT_NE(at, std::string::npos);
  EXPECT_LT(verdict, remedy);
  EXPECT_LT(remedy, figures);
  EXPECT_LT(gain, html.find("<h2 id=\"shapes\">"));
  for (const char* part : {"shapes", "goals", "convergence", "parameters", "time", "again"}) {
    EXPECT_EQ(count(html, std::string("<h2 id=\"") + part + "\">"), 1u) << part;
  }
  EXPECT_NE(html.find("2 of 3 parameters are at a bound."), std::string::npos);
  EXPECT_NE(html.find("The rods touch."), std::string::npos);
  EXPECT_NE(html.find("<code>lissom optimize arch.json</code>"), std::string::npos);
  EXPECT_NE(html.find("<dd>7</dd>"), std::string::npos);
  EXPECT_NE(html.find("<th scope=\"row\">other</th><td>0.5\u202fs</td><td>12\u202f%</td>"), std::string::npos);
}

TEST(DesignReport, ParametersThatArePulledMostComeFirst) {
  const std::string html = html_of(sample());
  const size_t r1 = html.find("<th scope=\"row\">r1"), s = html.find("<th scope=\"row\">s<"),
               r0 = html.find("<th scope=\"row\">r0");
  EXPECT_LT(r1, s);
  EXPECT_LT(s, r0);
  EXPECT_EQ(count(html, "All 3 parameters"), 0u);  // all of them are shown already
  DesignReport report = sample();
  for (int i = 0; i < 40; ++i) report.parameters.push_back(report.parameters[0]);
  EXPECT_EQ(count(html_of(report), "<summary>All 43 parameters"), 1u);
  EXPECT_EQ(count(html_of(report), "The 20 parameters with the largest remaining gradient"), 2u);  // caption and label
}

TEST(DesignReport, NamesCannotBecomeMarkup) {
  const std::string evil = "<script>alert(\"x\")</script>&'\x01";
  DesignReport report = sample();
  for (std::string* text : {&report.title, &report.document, &report.verdict, &report.sentence, &report.remedy,
                            &report.method, &report.command, &report.version}) {
    *text = evil;
  }
  report.options = {{evil, evil}};
  report.shares[0].name = evil;
  report.history.back().stage = evil;
  for (auto& g : report.goals) g.name = g.pose = g.measure.unit = evil;
  for (auto& p : report.parameters) p.name = p.kind = p.measure.unit = evil;
  for (auto& p : report.poses) {
    p.name = evil;
    p.before.rods[0].name = p.after.rods[0].name = evil;
  }
  report.warnings = report.files = {evil};
  const std::string html = html_of(report);
  EXPECT_EQ(xml_fault(html), "");
  EXPECT_EQ(count(html, "<script"), 0u);
  EXPECT_EQ(count(html, "alert(\"x\")"), 0u);
  EXPECT_GE(count(html, "&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt;&amp;'?"), 25u);
}

TEST(DesignReport, NumbersThatDoNotExistAreDashes) {
  DesignReport report = sample();
  for (DesignReport::Step& step : report.history) {
    step.objective = step.gradient = step.radius = step.seconds = NAN;
    step.rms = {INFINITY, -INFINITY};
  }
  for (auto& g : report.goals) g.rms_before = g.rms_after = g.largest_before = g.largest_after = NAN;
  for (auto& p : report.parameters) p.start = p.value = p.gradient = NAN, p.lower = -INFINITY, p.upper = INFINITY;
  report.seconds = NAN;
  report.shares[0].seconds = INFINITY;
  const std::string html = html_of(report);
  EXPECT_EQ(xml_fault(html), "");
  for (const char* word : {"nan", "NaN", "inf<", "no value", ">inf"}) EXPECT_EQ(count(html, word), 0u) << word;
  EXPECT_GE(count(html, "<td>\u2013</td><td>\u2013</td>"), 5u);
  EXPECT_GE(count(html, "<td>none</td>"), 6u);
}

TEST(DesignReport, AnEmptyReportIsAPage) {
  const std::string html = html_of({});
  EXPECT_EQ(xml_fault(html), "");
  EXPECT_NE(html.find("there is nothing to plot"), std::string::npos);
  EXPECT_EQ(count(html, "id=\"parameters\""), 0u);
}

TEST(DesignReport, ErrorsSayWhere) {
  DesignReport report = sample();
  report.history[3].rms.pop_back();
  EXPECT_EQ(design_report_html(report).error().where, "history, step 3");
  report = sample();
  report.poses[1].after.rods[0].points[2].x() = NAN;
  EXPECT_EQ(design_report_html(report).error().where, "pose \"pulled\": rod \"arch\"");
}

TEST(DesignReport, WordsSuitTheNumbers) {
  EXPECT_EQ(report_time(0.456), "0.46\u202fs");
  EXPECT_EQ(report_time(59.4), "59.4\u202fs");
  EXPECT_EQ(report_time(200), "3\u202fmin 20\u202fs");
  EXPECT_EQ(report_time(59.99), "60\u202fs");
  EXPECT_EQ(report_time(7500), "2\u202fh 5\u202fmin");
  EXPECT_EQ(report_time(NAN), "\u2013");
  EXPECT_EQ(report_gain(1, 0.05), "20 times closer");
  EXPECT_EQ(report_gain(1, 0.9), "10\u202f% closer");
  EXPECT_EQ(report_gain(1, 1), "unchanged");
  EXPECT_EQ(report_gain(1, 1.5), "50\u202f% farther");
  EXPECT_EQ(report_gain(1, 0), "reached");
  EXPECT_EQ(report_gain(0, 1), "");
  EXPECT_EQ(report_quantity(0.00125, {}), "1.25\u202fmm");
  EXPECT_EQ(report_quantity(1.4, {"", 1}), "1.4");
}

}  // namespace
}  // namespace lissom
