#include "lissom/view/scene.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

// px; neighbouring faces overlap, or antialiasing would show the page between them. More where many small ones meet.
constexpr double kSeam = 0.3, kClothSeam = 0.5;
constexpr double kLongestMitre = 4;  // of the seam, at sharp corners of cloth

/// Convex polygon with its edges moved outwards (bevelled at sharp corners), px.
void widen(std::span<const Vec2> points, std::vector<Vec2>& widened) {
  const size_t count = points.size();
  double area = 0;
  for (size_t i = 0; i < count; ++i) {
    const Vec2& p = points[i];
    const Vec2& q = points[(i + 1) % count];
    area += p.x() * q.y() - p.y() * q.x();
  }
  const double side = area > 0 ? kSeam : -kSeam;
  widened.assign(points.begin(), points.end());
  for (size_t i = 0; i < count; ++i) {
    const Vec2 d = points[(i + 1) % count] - points[i];
    const double length = d.norm();
    if (length < 1e-9) continue;
    const Vec2 out = Vec2(d.y(), -d.x()) * (side / length);
    widened[i] += out;
    widened[(i + 1) % count] += out;
  }
}

/// The same with full width at sharp corners, where many pieces of cloth meet.
void widen_mitred(std::span<const Vec2> points, double seam, std::vector<Vec2>& widened) {
  const size_t count = points.size();
  std::vector<Vec2> out(count, Vec2::Zero());  // unit normals of the sides
  double area = 0;
  for (size_t i = 0; i < count; ++i) {
    const Vec2 &p = points[i], &q = points[(i + 1) % count];
    area += p.x() * q.y() - p.y() * q.x();
    const Vec2 d = q - p;
    if (d.norm() > 1e-9) out[i] = Vec2(d.y(), -d.x()) / d.norm();
  }
  widened.assign(points.begin(), points.end());
  for (size_t i = 0; i < count; ++i) {
    const Vec2 &before = out[(i + count - 1) % count], &after = out[i];
    Vec2 mitre = (before + after) / std::max(1 + before.dot(after), 1e-3);
    if (mitre.norm() > kLongestMitre) mitre *= kLongestMitre / mitre.norm();
    widened[i] += mitre * (area > 0 ? seam : -seam);
  }
}

}  // namespace

Color Scene::lit(const Color& color, const Vec3& normal, double contrast, Gloss finish) const {
  const Vec3 n(normal.dot(camera_.right()), normal.dot(camera_.up()), normal.dot(camera_.towards()));
  const Vec3 light = Vec3(-0.42, 0.58, 0.70).normalized();
  const Vec3 half = (light + Vec3::UnitZ()).normalized();
  const double lambert = std::max(0.0, n.dot(light));
  if (finish == Gloss::kCloth) {
    const double shade = 0.66 + 0.06 * n.y() + 0.34 * lambert;
    const Color full{color.r * shade, color.g * shade, color.b * shade};
    return mix(color, full, contrast);
  }
  const double shade = 0.50 + 0.12 * (0.5 + 0.5 * n.y()) + 0.46 * lambert;
  const double gloss = 0.30 * std::pow(std::max(0.0, n.dot(half)), 30);
  const Color full = mix({color.r * shade, color.g * shade, color.b * shade}, {1, 1, 1}, gloss);
  const Color result = mix(color, full, contrast);
  return {std::min(1.0, result.r), std::min(1.0, result.g), std::min(1.0, result.b)};
}

Vec3 Scene::placed(const Vec3& point) const { return ground_ ? Vec3(point.x(), point.y(), *ground_) : point; }

void Scene::add_face(std::span<const Vec3> points, const Color& color, double contrast, double nearer) {
  Vec3 centre = Vec3::Zero(), area = Vec3::Zero();
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = placed(points[i]), first = placed(points[0]);
    centre += p;
    area += (p - first).cross(placed(points[(i + 1) % points.size()]) - first);
  }
  centre /= static_cast<double>(points.size());
  const double size = area.norm();
  if (size == 0 || area.dot(camera_.towards_eye(centre)) <= 0) return;
  pieces_.push_back({camera_.depth(centre) + nearer, points_.size(), static_cast<int>(points.size()),
                     ground_ ? shade_ : lit(color, area / size, contrast, Gloss::kPlastic), 0, false});
  for (const Vec3& p : points) points_.push_back(camera_.project(placed(p)));
}

void Scene::add_cloth(std::span<const Vec3> points, const Color& color, const Vec3& normal, double contrast) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += placed(p);
  centre /= static_cast<double>(points.size());
  const Vec3 facing = normal.dot(camera_.towards_eye(centre)) < 0 ? Vec3(-normal) : normal;
  pieces_.push_back({camera_.depth(centre), points_.size(), static_cast<int>(points.size()),
                     ground_ ? shade_ : lit(color, facing, contrast, Gloss::kCloth), 0, true});
  for (const Vec3& p : points) points_.push_back(camera_.project(placed(p)));
}

void Scene::add_mark(const Vec2& from, const Vec2& to, double depth, const Color& color, double width) {
  pieces_.push_back({depth, points_.size(), 2, color, width, false});
  points_.push_back(from);
  points_.push_back(to);
}

void Scene::add_line(std::span<const Vec3> points, const Color& color, double width, double nearer) {
  double depth = nearer * static_cast<double>(points.size());
  for (const Vec3& p : points) depth += camera_.depth(p);
  pieces_.push_back({depth / static_cast<double>(points.size()), points_.size(), static_cast<int>(points.size()),
                     ground_ ? shade_ : color, width, false});
  for (const Vec3& p : points) points_.push_back(camera_.project(placed(p)));
}

void Scene::paint(Canvas& canvas, double opacity) const {
  std::vector<const Piece*> order;
  order.reserve(pieces_.size());
  for (const Piece& piece : pieces_) order.push_back(&piece);
  std::stable_sort(order.begin(), order.end(), [](const Piece* a, const Piece* b) { return a->depth < b->depth; });
  std::vector<Vec2> face;
  for (const Piece* piece : order) {
    const std::span<const Vec2> points(points_.data() + piece->first, piece->count);
    if (piece->width > 0) {
      canvas.polyline(points, {.color = piece->color, .width = piece->width, .opacity = opacity});
    } else {
      piece->cloth ? widen_mitred(points, kClothSeam, face) : widen(points, face);
      canvas.polygon(face, piece->color, opacity);
    }
  }
}

}  // namespace lissom
