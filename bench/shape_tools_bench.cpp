/// Exploring and pulling at the designs of the gallery: what the response, modes, a linear preview and a fit cost, and how near a
/// fit comes to where the shape was pulled: three recorded pulls each. Rows of name, metric, value, unit.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/design/live_design.h"
#include "lissom/model/document.h"
#include "lissom/studio/fit_job.h"
#include "lissom/studio/handle.h"
#include "lissom/studio/shape_tools.h"

namespace lissom {
namespace {

/// Points taken hold of, and where they are pulled to, in shares of the size of the plan.
struct Pull {
  std::vector<std::string> points;
  Vec3 move = Vec3::Zero();
  Vec3 turn = Vec3::Zero();  ///< rad
  double radius = 0.1;
};

struct Recorded {
  const char* scene;
  std::vector<Pull> pulls;
  std::vector<std::string> pinned = {};  ///< points that have to stay
};

const std::vector<Recorded> kRecorded = {
    {"butterfly",
     {{{"f3-l", "f3-r"}, {0, 0, 0.03}}, {{"f3-l"}, {0, 0.02, 0.03}}, {{"head"}, {0, 0.01, -0.02}, {0.1, 0, 0}}}},
    {"mask", {{{"nose"}, {0, 0, 0.03}}, {{"chin"}, {0, -0.01, -0.02}}, {{"m1-l", "m1-r"}, {0, 0, 0.015}}}},
    {"car", {{{"roof"}, {0, 0, 0.015}}, {{"nose"}, {0, 0, -0.015}}, {{"w2-l", "w2-r"}, {0, 0.01, 0.01}}}},
    {"mask",
     {{{"nose"}, {0, 0, 0.01}}, {{"fore"}, {0, 0, 0.015}}, {{"m1-l", "m1-r"}, {0, 0, 0.015}}},
     {"o1-l", "o1-r"}},
    {"car", {{{"roof"}, {0, 0, 0.01}}, {{"nose"}, {0, 0, -0.015}}, {{"screen"}, {0, 0, 0.015}}}, {"s1-l", "s1-r"}},
    {"disc-empty", {{{"rim-0"}, {0, 0, 0.03}}, {{"rim-0", "rim-2"}, {0, 0, -0.03}}, {{"rim-1"}, {0, 0.02, 0}}}},
    {"disc-crossed", {{{"rim-0"}, {0, 0, 0.03}}, {{"centre"}, {0, 0, 0.03}}, {{"rim-1"}, {0, 0.02, 0.02}}}},
    {"disc-ringed", {{{"rim-0"}, {0, 0, 0.03}}, {{"rim-0", "rim-2"}, {0, 0, 0.03}}, {{"rim-1"}, {0, 0.02, 0.02}}}},
    {"disc-split", {{{"rim-0"}, {0, 0, 0.03}}, {{"rim-2"}, {0, 0, 0.03}}, {{"rim-1"}, {0, 0.02, 0.02}}}},
    {"frame-base", {{{"a", "c"}, {0, 0, 0.02}}, {{"a"}, {0, 0, -0.02}}, {{"b"}, {0.02, 0.01, 0}}}},
    {"frame-thick", {{{"a", "c"}, {0.02, 0, 0}}, {{"a"}, {0, -0.02, 0}}, {{"b"}, {0.02, 0.01, 0}}}},
    {"frame-more-stretch", {{{"a", "c"}, {0, 0, 0.02}}, {{"a"}, {0, 0, -0.02}}, {{"b"}, {0.02, 0.01, 0}}}},
    {"frame-soft-in-plane", {{{"a", "c"}, {0, 0, 0.02}}, {{"a"}, {0, 0, -0.02}}, {{"b"}, {0.02, 0.01, 0}}}},
    {"rectangle-empty", {{{"p00"}, {0, 0, 0.02}}, {{"p00", "p11"}, {0, 0, 0.02}}, {{"p10"}, {0.01, 0.01, 0}}}},
    {"rectangle-squares", {{{"p21"}, {0, 0, 0.02}}, {{"p00", "p02"}, {0, 0, 0.02}}, {{"p10"}, {0.01, 0.01, 0}}}},
    {"rectangle-strips", {{{"p40"}, {0, 0, 0.02}}, {{"p00", "p01"}, {0, 0, 0.02}}, {{"p10"}, {0.01, 0.01, 0}}}},
};

int node_of(const LiveDesign& design, const std::string& name) {
  const std::vector<PlanPoint>& points = design.model().plan->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].name == name) return design.system().structure.membranes.front().nodes[i];
  }
  return -1;
}

void measure(const Recorded& recorded, double stay, const Context& context) {
  const Result<std::string> text = read_file(std::string("scenes/data/fabric/") + recorded.scene + ".lissom");
  Result<Model> model = text ? read_document(text.value()) : Result<Model>(text.error());
  if (!model) return (void)std::fprintf(stderr, "%s: %s\n", recorded.scene, model.error().text().c_str());
  LiveDesign::Options options;
  options.solve.modes = 1;
  Result<std::unique_ptr<LiveDesign>> made = LiveDesign::make(model.value(), 0, options, context);
  if (!made) return (void)std::fprintf(stderr, "%s: %s\n", recorded.scene, made.error().text().c_str());
  const LiveDesign& design = *made.value();
  const std::string name = recorded.scene + std::string(recorded.pinned.empty() ? "" : ", pinned");
  HardConstraints constraints;
  std::vector<PinnedNode> pins;
  for (const std::string& point : recorded.pinned) {
    const int node = node_of(design, point);
    constraints.pinned.push_back(node);
    pins.push_back({node, design.equilibrium().state.position(node)});
  }
  const ShapeStart start{design.mesh(), design.model(), 0, design.equilibrium().state};
  std::shared_ptr<const ShapeResponse> response;
  row(name, "response",
      least_ms(3, [&] { response = ShapeResponse::make(start, tool_space(), pins, context).value(); }), "ms");
  row(name, "parameters", response->size(), "");
  row(name, "modes", least_ms(3, [&] { (void)shape_modes(*response, constraints, 6); }), "ms");
  const double size = design.system().structure.size;
  int number = 0;
  for (const Pull& pull : recorded.pulls) {
    HandleGrip grip;
    for (const std::string& point : pull.points) grip.nodes.push_back(node_of(design, point));
    grip.radius = pull.radius * size;
    grip.stay = stay;
    Result<Handle> handle = Handle::make(response, constraints, grip, context);
    if (!handle) return (void)std::fprintf(stderr, "%s: %s\n", recorded.scene, handle.error().text().c_str());
    const std::string own = name + ", pull " + std::to_string(++number);
    row(own, "handle taken", least_ms(2, [&] { (void)Handle::make(response, constraints, grip, context); }), "ms");
    const HandleMove move{size * pull.move, pull.turn, 1};
    row(own, "linear preview", median_ms(7, [&] { (void)handle.value().move(move); }), "ms");
    const Handle::Preview* preview = handle.value().last();
    if (preview == nullptr) return (void)std::fprintf(stderr, "%s: no preview\n", own.c_str());
    row(own, "misses the pull by, linear", 1e3 * preview->answer.rms, "mm");
    row(own, "rods turn by", 57.29577951308232 * preview->turn, "deg");
    if (!preview->lags.empty()) std::printf("%s\tstays behind the pull: %s\n", own.c_str(), preview->lags.c_str());
    const double begin = now_ms();
    const auto fit = std::move(ShapeFit::make(response, constraints, handle.value().target(), context)).value();
    const double before = fit->distance();
    int iterations = 0;
    const std::optional<DesignVerdict> verdict =
        run_fit(*fit, context, [&](const FitRecord& record) { iterations = record.iteration; });
    row(own, "fit", now_ms() - begin, "ms");
    row(own, "iterations", iterations, "");
    row(own, "solves", fit->effort().solves, "");
    row(own, "distance before", 1e3 * before, "mm");
    row(own, "distance after", 1e3 * fit->distance(), "mm");
    if (!pins.empty()) row(own, "constraints off by", 1e3 * fit->violation(), "mm");
    row(own, "fell to", 100 * fit->distance() / before, "%");
    std::printf("%s\tended: %s\n", own.c_str(),
                verdict ? std::string(design_verdict_info(*verdict).name).c_str() : "enough");
  }
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  lissom::ThreadPool threads(2);
  lissom::Context context;
  context.threads = &threads;
  for (const lissom::Recorded& recorded : lissom::kRecorded) {
    if (argc < 2 || std::string(argv[1]) == recorded.scene)
      lissom::measure(recorded, argc > 2 ? std::atof(argv[2]) : lissom::HandleGrip().stay, context);
  }
}
