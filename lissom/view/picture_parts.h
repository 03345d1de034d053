#pragma once
/// Parts that picture.cpp puts together.

#include <optional>
#include <string>
#include <vector>

#include "lissom/view/picture.h"
#include "lissom/view/scene.h"

namespace lissom {

/// Whether the panels can be drawn like this: sizes, shapes, ranges and names of fields.
Status check_picture(const std::vector<Panel>& panels, const PictureOptions& options);

/// How the rods or the membranes of a layer get their colours.
struct Paint {
  const Field* field = nullptr;  ///< null: plain
  ColorRange range = {};
  Color plain;
  double contrast = 1;              ///< of the shading
  int steps = 0;                    ///< of the colours; 0: gliding
  std::optional<double> line = {};  ///< px, width of the flat lines that rods are drawn as; 0: as wide as they are seen
  double thinnest = 0;              ///< px, of lines that are as wide as their rods are seen
};

/// How rods lie on membranes, or nothing: half of a rod is above the cloth and is painted after it, half below.
struct Bed {
  std::vector<Vec3> normal;  ///< of the membrane, unit, per point of all rods; zero where there is none
  double reach = 0;          ///< m, how far the depth of a piece of cloth can be judged by its middle
};

/// Faces (or lines, where rods are thin on the page) of all rods. At most about `budget` pieces: more rods, coarser.
void add_rods(Scene& scene, const Camera& camera, const Drawing& drawing, const Paint& paint, int budget,
              const Bed& bed = {});

/// What is drawn on cloth besides its colour. Lengths in px; 0: not drawn.
struct ClothMarks {
  double hatch = 0;   ///< distance of the lines on slack cloth
  double stroke = 0;  ///< length of the strokes along the largest tension
  double hem = 0;     ///< width of the line along edges of the cloth without rod
  Color ink;
};

/// Pieces of all membranes, about `budget` at most; returns how rods lie on them.
Bed add_membranes(Scene& scene, const Camera& camera, const Drawing& drawing, const Paint& paint,
                  const ClothMarks& marks, int budget);

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
  int steps = 0;  ///< of the colours; 0: gliding
};

/// What the field of this name in all solid layers has: nothing when `name` is empty.
struct ColorKey {
  const Field* field = nullptr;  ///< the first one of that name
  ColorRange range;              ///< as stored
  Legend legend;
};
ColorKey color_key(const std::vector<Panel>& panels, const std::string& name, const std::optional<ColorRange>& range);

/// Everything that the panels of a picture share.
struct Shared {
  std::vector<Vec3> points;   ///< m, what must be visible
  std::vector<double> radii;  ///< m
  MarkerScale markers;
  double ground = 0;  ///< m
  int supports = 0;
  ColorKey colors, membrane_colors;
  ClothMarks marks;
};

/// `em`: px.
Shared gather(const std::vector<Panel>& panels, const PictureOptions& options, double em);

bool shown(const Marker& marker, const PictureOptions& options);

/// Explains marks on cloth below the legends; `at` is the lower left corner. Returns the height in px.
double draw_marks_legend(Canvas& canvas, const ClothMarks& marks, const ThemeColors& colors, const Vec2& at, double em);

void draw_legend(Canvas& canvas, const Legend& legend, const ThemeColors& colors, const Vec2& corner, const Vec2& size,
                 double em);

/// Bar with a round length at the lower left corner `at`; returns its width with text in px.
double draw_ruler(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& at, double longest,
                  double em);

/// Directions of x, y, z around `centre`.
void draw_axes(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& centre, double em);

}  // namespace lissom
