#include "lissom/session/motion_pictures.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace lissom {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kHeadroom = 1.3;  ///< above the largest energy, for the legend

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

Chart chart_over_time(const std::string& title, ChartAxis y) {
  Chart chart;
  chart.title = title;
  chart.x = {.label = "time", .unit = "s"};
  chart.y = std::move(y);
  return chart;
}

}  // namespace

Chart energy_chart(const std::string& title, const MotionResult& result) {
  Chart chart = chart_over_time(title, {.label = "energy", .unit = "mJ", .display_scale = 1000});
  chart.series = {
      series("kinetic", result, [](const MotionRecord& r) { return r.translation_energy + r.roll_energy; }),
      series("elastic", result, [](const MotionRecord& r) { return r.elastic_energy; }),
      series("put in by loads and supports", result,
             [](const MotionRecord& r) { return r.ledger.load_work + r.ledger.support_work; }),
      series("lost", result, [](const MotionRecord& r) { return r.ledger.rayleigh_loss + r.ledger.numerical_loss; }),
      series("kinetic + elastic - put in + lost", result, [](const MotionRecord& r) { return r.total; })};
  std::erase_if(chart.series, [](const ChartSeries& s) {
    return std::all_of(s.y.begin(), s.y.end(), [](double y) { return y == 0; });
  });
  double largest = 0;
  for (const ChartSeries& s : chart.series) largest = std::max(largest, *std::max_element(s.y.begin(), s.y.end()));
  if (largest > 0) chart.y.high = kHeadroom * largest;
  return chart;
}

Chart momentum_chart(const std::string& title, const MotionResult& result, const std::vector<std::string>& watches) {
  Chart chart = chart_over_time(title, {.label = "angular momentum", .unit = "kg mm²/s", .display_scale = 1e6});
  for (size_t w = 0; w < watches.size(); ++w) {
    const auto of = [w](const MotionRecord& r) { return r.watches[w].angular_momentum; };
    chart.series.push_back(series(watches[w], result, of));
  }
  return chart;
}

Chart turn_chart(const std::string& title, const MotionResult& result, const std::vector<std::string>& watches) {
  Chart chart = chart_over_time(title, {.label = "turn", .unit = "°", .display_scale = kDegrees});
  for (size_t w = 0; w < watches.size(); ++w) {
    chart.series.push_back(series(watches[w], result, [w](const MotionRecord& r) { return r.watches[w].turn; }));
  }
  return chart;
}

std::vector<int> strip_records(const MotionResult& result, int panels) {
  std::vector<int> shown;
  const int last = static_cast<int>(result.states.size()) - 1;
  const int count = std::min(panels, last + 1);
  for (int i = 0; i < count; ++i) shown.push_back(count > 1 ? (last * i + (count - 1) / 2) / (count - 1) : 0);
  return shown;
}

Result<std::string> draw_strip(const PictureStrip& strip, const MotionResult& result, const std::vector<int>& shown,
                               std::vector<Drawing> drawings, ImageFormat format) {
  std::vector<Panel> panels;
  for (size_t i = 0; i < drawings.size(); ++i) {
    const MotionRecord& record = result.records[shown[i]];
    std::string caption = fmt::format("{:.4g} s", record.time);
    if (record.watches.size() == 1) caption += fmt::format(", turned by {:.1f}°", kDegrees * record.watches[0].turn);
    panels.push_back({{{std::move(drawings[i]), Layer::Style::kSolid}}, std::move(caption)});
  }
  return draw_panels(strip, panels, format);
}

}  // namespace lissom
