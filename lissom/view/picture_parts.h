#pragma once
/// Parts that picture.cpp puts together.

#include <string>
#include <vector>

#include "lissom/view/picture.h"
#include "lissom/view/scene.h"

namespace lissom {

/// How the rods of a layer get their colours.
struct RodPaint {
  const Field* field = nullptr;  ///< null: plain
  ColorRange range = {};
  Color plain;
  double contrast = 1;  ///< of the shading
};

/// Faces (or lines, where rods are thin on the page) of all rods. At most about `budget` pieces: more rods, coarser.
void add_rods(Scene& scene, const Camera& camera, const Drawing& drawing, const RodPaint& paint, int budget);

/// Centrelines, drawn at once.
void draw_centrelines(Canvas& canvas, const Camera& camera, const Drawing& drawing, const Stroke& stroke);

/// Sizes of supports and arrows in m, for a structure of this size (m).
struct MarkerScale {
  double support = 0;          ///< height of a support
  double arrow = 0;            ///< length of the longest arrow
  double largest_force = 0;    ///< N, has the longest arrow
  Vec3 middle = Vec3::Zero();  ///< arrows point away from or to here, outside the structure
};

/// From and to, m.
struct Arrow {
  Vec3 tail, tip;
};
Arrow force_arrow(const Marker& marker, const MarkerScale& scale);

void add_marker(Scene& scene, const Marker& marker, const MarkerScale& scale, const ThemeColors& colors);

/// What the legend says.
struct Legend {
  std::string title, unit;  ///< as displayed
  Field::Colors colors = Field::Colors::kSequential;
  ColorRange range;          ///< ends of the bar, in display units
  ColorRange found;          ///< smallest and largest value in the picture, in display units
  bool has_missing = false;  ///< some places have no value
  bool has_values = true;
};

void draw_legend(Canvas& canvas, const Legend& legend, const ThemeColors& colors, const Vec2& corner, const Vec2& size,
                 double em);

/// Bar with a round length at the lower left corner `at`; returns its width with text in px.
double draw_ruler(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& at, double longest,
                  double em);

/// Directions of x, y, z around `centre`.
void draw_axes(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& centre, double em);

}  // namespace lissom
