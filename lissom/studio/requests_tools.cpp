#include <numbers>

#include "lissom/studio/desk.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr double kMetres = 1e-3;  // per millimetre
constexpr int kModes = 6, kMostModes = 30;

}  // namespace

Answer answer_modes(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int count = ask.has("count") ? ask.integer("count", 1) : kModes;
  if (!ask.status()) return ask.status().error();
  if (count > kMostModes) {
    return Error{ErrorCode::kRange, "/count", "that is more than can be looked at", "ask for 30 modes at most"};
  }
  if (Status s = desk.tools().find_modes(count); !s) return s.error();
  return Json::object();
}

Answer answer_mode_adopt(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int mode = ask.integer("mode", 0);
  const double amplitude = kMetres * ask.number("amplitude_mm");
  if (!ask.status()) return ask.status().error();
  return desk.tools().adopt_mode(mode, amplitude);
}

Answer answer_handle_begin(Desk& desk, int page, Ask& ask) {
  (void)page;
  HandleGrip grip;
  if (ask.has("nodes")) grip.nodes = ask.integers("nodes");
  if (ask.has("held")) grip.held = ask.integers("held");
  if (ask.has("radius_mm")) grip.radius = kMetres * ask.number("radius_mm");
  if (ask.has("points")) {
    for (const std::string& name : ask.texts("points")) {
      const Result<int> node = desk.node_of_point(name);
      if (!node) return node.error();
      grip.nodes.push_back(node.value());
    }
  }
  if (!ask.status()) return ask.status().error();
  if (grip.radius < 0) return Error{ErrorCode::kRange, "/radius_mm", "the radius is negative", "give 0 or more"};
  return desk.tools().begin_handle(grip);
}

Answer answer_handle_move(Desk& desk, int page, Ask& ask) {
  (void)page;
  HandleMove move;
  if (ask.has("move_mm")) move.move = kMetres * ask.vector("move_mm");
  if (ask.has("turn_deg")) move.turn = std::numbers::pi / 180 * ask.vector("turn_deg");
  if (ask.has("scale")) move.scale = ask.number("scale");
  if (!ask.status()) return ask.status().error();
  return desk.tools().move_handle(move);
}

Answer answer_handle_radius(Desk& desk, int page, Ask& ask) {
  (void)page;
  const double radius = kMetres * ask.number("radius_mm");
  if (!ask.status()) return ask.status().error();
  return desk.tools().set_radius(radius);
}

Answer answer_handle_accept(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  return desk.tools().accept_handle();
}

Answer answer_handle_cancel(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  desk.tools().release_handle();
  return Json::object();
}

}  // namespace lissom
