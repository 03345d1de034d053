#pragma once
/// Ways to damage a surface, or the bytes of a file, at random. Same seed, same damage.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "tests/unit/surface_samples.h"

namespace lissom::samples {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int below(std::size_t n) { return static_cast<int>(engine_() % n); }
  double unit() { return static_cast<double>(engine_() % 1'000'001) / 1e6; }

 private:
  std::mt19937_64 engine_;
};

enum class Fate {
  kNoted,    ///< mended or kept, with a note, or refused
  kRefused,  ///< in any case
  kAny,      ///< may also leave the surface as it is
};

/// How a surface is damaged before it is written.
struct Damage {
  const char* name;
  void (*apply)(Surface& s, Random& random);
  Fate fate;
  Fate in_stl;  ///< such files have no numbers of vertices, so that some damage cannot be written
};

inline std::array<int, 3>& any_triangle(Surface& s, Random& r) { return s.triangles[r.below(s.triangles.size())]; }

inline Vec3 middle(const Surface& s, const std::array<int, 3>& t) {
  return (s.vertices[t[0]] + s.vertices[t[1]] + s.vertices[t[2]]) / 3;
}

inline double extent(const Surface& s) {
  Eigen::AlignedBox3d box;
  for (const Vec3& v : s.vertices) box.extend(v);
  return box.sizes().maxCoeff();
}

inline int add_vertex(Surface& s, const Vec3& at) {
  s.vertices.push_back(at);
  return static_cast<int>(s.vertices.size()) - 1;
}

inline const Damage kDamages[] = {
    {"small holes",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 3; ++i) s.triangles.erase(s.triangles.begin() + r.below(s.triangles.size()));
     },
     Fate::kAny, Fate::kAny},
    {"a large hole",
     [](Surface& s, Random& r) {
       const Vec3 at = s.vertices[any_triangle(s, r)[0]];
       const double radius = 0.2 * extent(s);
       std::erase_if(s.triangles, [&](const auto& t) { return (middle(s, t) - at).norm() < radius; });
     },
     Fate::kAny, Fate::kAny},
    {"flips",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 5; ++i) {
         std::array<int, 3>& t = any_triangle(s, r);
         std::swap(t[0], t[1]);
       }
     },
     Fate::kAny, Fate::kAny},
    {"turned over",
     [](Surface& s, Random& r) {
       for (std::size_t t = r.below(3); t < s.triangles.size(); t += 3) std::swap(s.triangles[t][1], s.triangles[t][2]);
     },
     Fate::kNoted, Fate::kNoted},
    {"duplicate triangles",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 4; ++i) {
         std::array<int, 3> t = any_triangle(s, r);
         std::rotate(t.begin(), t.begin() + r.below(3), t.end());
         if (r.below(2)) std::swap(t[0], t[1]);
         s.triangles.push_back(t);
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"duplicate vertices",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 20; ++i) {
         std::array<int, 3>& t = any_triangle(s, r);
         const Vec3 noise(r.unit(), r.unit(), r.unit());
         for (int& v : t) v = add_vertex(s, s.vertices[v] + 1e-8 * extent(s) * noise);
       }
     },
     Fate::kNoted, Fate::kAny},
    {"repeated corners",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 3; ++i) {
         const auto t = any_triangle(s, r);
         s.triangles.push_back({t[0], t[1], t[1]});
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"caps",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 4; ++i) {
         const int at = r.below(s.triangles.size());
         const auto [a, b, c] = s.triangles[at];
         const int m = add_vertex(s, s.vertices[a] + (0.2 + 0.6 * r.unit()) * (s.vertices[b] - s.vertices[a]));
         s.triangles[at] = {m, b, c};
         s.triangles.push_back({a, m, c});
         s.triangles.push_back({a, b, m});
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"needles",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 4; ++i) {
         const int at = r.below(s.triangles.size());
         const auto [a, b, c] = s.triangles[at];
         const Vec3 inward = middle(s, {a, b, c}) - s.vertices[a];
         const int m = add_vertex(s, s.vertices[a] + 1e-7 * inward);
         s.triangles[at] = {m, b, c};
         s.triangles.push_back({a, b, m});
         s.triangles.push_back({a, m, c});
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"crushed",
     [](Surface& s, Random& r) {
       const Vec3 at = s.vertices[any_triangle(s, r)[0]];
       for (Vec3& v : s.vertices) {
         if ((v - at).norm() < 0.15 * extent(s)) v = at + 1e-9 * r.unit() * (v - at);
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"flattened",
     [](Surface& s, Random& r) {
       for (Vec3& v : s.vertices) v[r.below(3)] *= r.below(40) ? 1 : 0;
       for (Vec3& v : s.vertices) v.z() = 0;
     },
     Fate::kAny, Fate::kAny},
    {"a second piece",
     [](Surface& s, Random& r) {
       const double size = extent(s) * (r.below(2) ? 0.4 : 0.004);
       s = samples::together(s, samples::icosphere(1, size), 2 * extent(s) * Vec3(1, r.unit(), 0));
     },
     Fate::kNoted, Fate::kNoted},
    {"a copy in the same place",
     [](Surface& s, Random& r) {
       Surface copy = s;
       if (r.below(2)) {
         for (auto& t : copy.triangles) std::swap(t[0], t[2]);
       }
       s = samples::together(s, copy, Vec3::Zero());
     },
     Fate::kNoted, Fate::kNoted},
    {"fins",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 2; ++i) {
         const auto t = any_triangle(s, r);
         const int m =
             add_vertex(s, s.vertices[t[0]] + (0.02 + 0.3 * r.unit()) * extent(s) * Vec3(r.unit(), r.unit(), 1));
         s.triangles.push_back({t[0], t[1], m});
       }
     },
     Fate::kNoted, Fate::kNoted},
    {"joined corners",
     [](Surface& s, Random& r) {
       const int a = any_triangle(s, r)[0], b = any_triangle(s, r)[1];
       for (auto& t : s.triangles) std::replace(t.begin(), t.end(), a, b);
     },
     Fate::kNoted, Fate::kNoted},
    {"crossings",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 3; ++i) {
         Vec3& v = s.vertices[any_triangle(s, r)[0]];
         Vec3 mean = Vec3::Zero();
         for (const Vec3& w : s.vertices) mean += w / static_cast<double>(s.vertices.size());
         v = mean - 1.3 * (v - mean);
       }
     },
     Fate::kAny, Fate::kAny},
    {"wrong corners",
     [](Surface& s, Random& r) {
       for (int i = 0; i < 4; ++i) any_triangle(s, r)[r.below(3)] = r.below(s.vertices.size());
     },
     Fate::kNoted, Fate::kNoted},
    {"not a number",
     [](Surface& s, Random& r) { s.vertices[any_triangle(s, r)[0]][r.below(3)] = r.below(2) ? NAN : INFINITY; },
     Fate::kRefused, Fate::kRefused},
    {"unused vertices",
     [](Surface& s, Random& r) {
       add_vertex(s, Vec3::Constant(r.below(2) ? NAN : 1));
       add_vertex(s, {1, 2, 3});
     },
     Fate::kNoted, Fate::kAny},
    {"huge or tiny",
     [](Surface& s, Random& r) {
       const double factor = std::pow(10.0, (r.below(2) ? 1 : -1) * (170 + 30 * r.unit()));
       for (Vec3& v : s.vertices) v *= factor;
     },
     Fate::kRefused, Fate::kRefused},
    {"far away",
     [](Surface& s, Random& r) {
       for (Vec3& v : s.vertices) v += extent(s) * Vec3(1e9, 0, 1e9 * r.unit());
     },
     Fate::kRefused, Fate::kRefused},
    {"uneven scales",
     [](Surface& s, Random& r) {
       for (Vec3& v : s.vertices) v = v.cwiseProduct(Vec3(1, std::pow(10.0, -4 * r.below(3)), 1));
     },
     Fate::kAny, Fate::kAny},
    {"nothing", [](Surface&, Random&) {}, Fate::kAny, Fate::kAny},
};

/// The bytes of a file are damaged in half of the variants that damage nothing else, and in a tenth of the others.
inline void damage_bytes(std::string& bytes, Random& r) {
  switch (r.below(5)) {
    case 0:
      bytes.resize(r.below(bytes.size()));
      break;
    case 1:
      bytes.insert(r.below(bytes.size()), bytes.substr(r.below(bytes.size()), 1 + r.below(200)));
      break;
    case 2:
      bytes.erase(r.below(bytes.size()), 1 + r.below(200));
      break;
    default:
      for (int i = 1 + r.below(8); i > 0; --i) bytes[r.below(bytes.size())] = static_cast<char>(r.below(256));
  }
}

}  // namespace lissom::samples
