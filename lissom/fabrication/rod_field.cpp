#include "lissom/fabrication/rod_field.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

/// Of cell^2 times curvature: how far, on average, facets lie inside a convex surface; measured on long cylinders.
constexpr double kMeanSag = 0.08;
constexpr int kMostHits = 24;  // pieces near one point; farther ones are left out

}  // namespace

RodField::RodField(const std::vector<FieldPart>& parts, double cell, double tolerance) : cell_(cell) {
  for (const FieldPart& part : parts) {
    const std::vector<int> kept = ring_stations(*part.piece, part.first, part.last, tolerance / 8);
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
      Segment s;
      s.from = &part.piece->stations[kept[k]];
      s.to = &part.piece->stations[kept[k + 1]];
      s.shape = part.piece->shape;
      s.group = part.group;
      if (k == 0) s.cap0 = part.cap[0];
      if (k + 2 == kept.size()) s.cap1 = part.cap[1];
      const double thin = std::max(std::min(s.from->r_b, s.from->r_n), std::min(s.to->r_b, s.to->r_n));
      s.bound = std::max(s.from->reach(s.shape), s.to->reach(s.shape)) + 1.25 * kValley * thin + 2 * cell;
      segments_.push_back(s);
    }
  }
}

RodField::Reach RodField::reach(int segment) const {
  const Segment& s = segments_[segment];
  return {s.from->centre, s.to->centre, s.bound};
}

/// `offset`: m, from the centre of the section; `beyond`: m, how far beyond a rounded end.
RodField::Hit RodField::section_hit(const Segment& s, double share, double beyond, const Vec3& offset) const {
  const RodStation &from = *s.from, &to = *s.to;
  const Vec3 b = from.b + share * (to.b - from.b), n = from.n + share * (to.n - from.n);
  const double u = offset.dot(b), v = offset.dot(n), w = beyond;
  const double r_b = from.r_b + share * (to.r_b - from.r_b), r_n = from.r_n + share * (to.r_n - from.r_n);
  const Vec3 axial = share > 0.5 ? to.t : Vec3(-from.t);
  Hit hit{s.group, 0, std::min(r_b, r_n), b};
  if (s.shape == SectionShape::kRectangle) {
    const double across = std::hypot(u, w) - r_b, up = std::abs(v) - r_n;
    hit.distance = across > 0 && up > 0 ? std::hypot(across, up) : std::max(across, up);
    hit.direction = across > up ? Vec3(b * u + axial * w) : Vec3(n * v);
  } else {
    const double bb = 1 / (r_b * r_b), nn = 1 / (r_n * r_n);
    const double g2 = (u * u + w * w) * bb + v * v * nn, q = (u * u + w * w) * bb * bb + v * v * nn * nn;
    if (g2 < 1e-12) {
      hit.distance = -hit.thin;
      return hit;
    }
    const double g = std::sqrt(g2);
    // Curvature of an ellipse, r_b r_n / (r_b^2 sin^2 + r_n^2 cos^2)^(3/2), by what was computed.
    const double size = r_b * r_n * std::sqrt(q / g2);
    const double curvature = r_b * r_n / (size * size * size) * (w > 0 ? 2 : 1);
    hit.distance = (g - 1) * g / std::sqrt(q) - kMeanSag * cell_ * std::min(1.0, cell_ * curvature);
    hit.direction = b * (u * bb) + n * (v * nn) + axial * (w * bb);
  }
  const double length = hit.direction.norm();
  if (length > 0) hit.direction /= length;
  return hit;
}

bool RodField::hit(const Segment& s, const Vec3& x, Hit& found) const {
  const Vec3 from0 = x - s.from->centre, from1 = x - s.to->centre;
  const double h0 = from0.dot(s.from->t), h1 = from1.dot(s.to->t);
  const double most = s.bound * s.bound;
  if (h0 >= 0 && h1 < 0) {
    const double share = h0 / (h0 - h1);
    const Vec3 offset = from0 + share * (from1 - from0);
    if (offset.squaredNorm() > most) return false;
    found = section_hit(s, share, 0, offset);
    const double inside =
        std::max(s.cap0 == FieldPart::Cap::kFlat ? -h0 : -INFINITY, s.cap1 == FieldPart::Cap::kFlat ? h1 : -INFINITY);
    found.distance = std::max(found.distance, inside);
    return true;
  }
  const bool before = h0 < 0 && h1 < 0 && s.cap0 != FieldPart::Cap::kOpen;
  const bool after = h0 >= 0 && h1 >= 0 && s.cap1 != FieldPart::Cap::kOpen;
  if (!before && !after) return false;
  const Vec3& offset = before ? from0 : from1;
  if (offset.squaredNorm() > most) return false;
  const double beyond = before ? -h0 : h1;
  const bool round = (before ? s.cap0 : s.cap1) == FieldPart::Cap::kRound;
  found = section_hit(s, before ? 0 : 1, round ? beyond : 0, offset);
  if (!round) found.distance = std::max(found.distance, beyond);
  return true;
}

double RodField::value(const Vec3& x, std::span<const int> segments) const {
  std::array<Hit, kMostHits> hits;
  std::size_t count = 0;
  for (const int k : segments) {
    Hit found;
    if (!hit(segments_[k], x, found)) continue;
    std::size_t at = 0;
    while (at < count && hits[at].group != found.group) ++at;
    if (at == kMostHits) {
      for (std::size_t i = 0; i < count; ++i) {
        if (at == kMostHits || hits[i].distance > hits[at].distance) at = i;
      }
    }
    if (at == count) {
      hits[count++] = found;
    } else if (found.distance < hits[at].distance) {
      hits[at] = found;
    }
  }
  double least = INFINITY;
  for (std::size_t i = 0; i < count; ++i) {
    least = std::min(least, hits[i].distance);
    for (std::size_t j = i + 1; j < count; ++j) {
      const double along = hits[i].direction.dot(hits[j].direction);
      const double k = kValley * std::min(hits[i].thin, hits[j].thin) * std::max(0.0, 1 - along * along);
      const double near = k - std::abs(hits[i].distance - hits[j].distance);
      if (near <= 0) continue;
      least = std::min(least, std::min(hits[i].distance, hits[j].distance) - near * near / (4 * k));
    }
  }
  return least;
}

}  // namespace lissom
