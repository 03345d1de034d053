#pragma once
/// Pieces of a picture sorted by depth and painted from back to front, with light.

#include <optional>
#include <span>
#include <vector>

#include "lissom/view/camera.h"
#include "lissom/view/canvas.h"

namespace lissom {

class Scene {
 public:
  explicit Scene(const Camera& camera) : camera_(camera) {}

  /// Everything is projected down on the plane z = `ground` (m) and painted in `color`: a shadow.
  Scene(const Camera& camera, double ground, const Color& color) : camera_(camera), ground_(ground), shade_(color) {}

  /// A flat face (counter-clockwise seen from outside), m. Dropped when it faces away. `contrast` 1: full shading.
  /// `nearer` (m) moves it towards the eye, in the order of painting only.
  void add_face(std::span<const Vec3> points, const Color& color, double contrast = 1, double nearer = 0);

  /// A flat piece of something thin, seen from both sides. Light falls as on a surface with this unit normal.
  void add_cloth(std::span<const Vec3> points, const Color& color, const Vec3& normal, double contrast = 1);

  /// A line of constant page width (px) through points in space.
  void add_line(std::span<const Vec3> points, const Color& color, double width, double nearer = 0);

  /// A line between two points of the page (px), in the order of painting at `depth` (m).
  void add_mark(const Vec2& from, const Vec2& to, double depth, const Color& color, double width);

  void paint(Canvas& canvas, double opacity = 1) const;

 private:
  struct Piece {
    double depth;  // m, larger is nearer
    size_t first;  // in points_
    int count;
    Color color;
    double width;  // px; 0: face
    bool cloth;
  };

  enum class Gloss { kPlastic, kCloth };
  Color lit(const Color& color, const Vec3& normal, double contrast, Gloss gloss) const;

  Vec3 placed(const Vec3& point) const;

  const Camera& camera_;
  std::optional<double> ground_;
  Color shade_;
  std::vector<Piece> pieces_;
  std::vector<Vec2> points_;
};

}  // namespace lissom
