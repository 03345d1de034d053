#include "scenes/scenes.h"

#include "scenes/scene_models.h"
#include "scenes/sheet_brief.h"

namespace lissom {

namespace {

constexpr Scene kScenes[] = {
    {"cantilever", "A round rod of 0.2 m, clamped at one end, bent by a force at the other.", scene_models::cantilever},
    {"frame", "A square frame of flat rods under two opposite forces.", scene_models::square_frame},
    {"grid", "A square grid of rods, clamped along one side, loaded at the other.", scene_models::grid},
    {"gridshell", "Tubes laid out flat on an ellipse of 12 m by 8 m; the ends are pushed inwards and it rises.",
     scene_models::gridshell},
    {"helix", "A helical spring, both ends clamped, pulled along its axis.", scene_models::helix},
    {"hexagon_sheet", "A sheet of hexagons, 0.2 m, hung by two opposite sides under its own weight.",
     scene_models::hexagon_sheet},
    {"honeycomb", "A honeycomb of 8 by 8 cells pulled in its plane.", scene_models::honeycomb},
    {"quad_sheet", "A sheet of squares, 0.2 m, hung by two opposite sides under its own weight.",
     scene_models::quad_sheet},
    {"ring", "A ring pulled apart by two opposite forces.", scene_models::ring},
    {"sheet_design", "A sheet of hexagons, 0.2 m, to be designed such that it bends and stretches as four others do.",
     scene_models::sheet_design},
    {"sphere", "A sphere of laths that is pressed down by a smooth plate; on the way it begins to twist.",
     scene_models::sphere},
    {"triangle_sheet", "A sheet of triangles, 0.2 m, hung by two opposite sides under its own weight.",
     scene_models::triangle_sheet},
    {"windmill", "Three windmills, axes thin to thick, twisted and let go: the twist bends their blades.",
     scene_models::windmill},
};

}  // namespace

std::span<const Scene> scenes() { return kScenes; }

}  // namespace lissom
