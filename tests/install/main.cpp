/// Uses the installed headers and the library with the compiler's default flags, which differ from lissom's own.

#include <cmath>
#include <cstdio>

#include "lissom/core/result.h"
#include "lissom/geometry/frame.h"

int main() {
  using namespace lissom;
  const Vec3 from = Vec3(1, 2, 3).normalized(), to = Vec3(-2, 1, 0.5).normalized();
  const Frame frame = frame_from_normal(from, Vec3::UnitZ());
  const Vec3 moved = parallel_transport(from, to, frame.n);
  const Mat3 turn = rotation_from_vector(Vec3(0.3, -0.2, 0.1));
  const double error = std::abs(moved.dot(to)) + std::abs(moved.norm() - 1) +
                       (turn * turn.transpose() - Mat3::Identity()).norm() +
                       (vector_from_rotation(turn) - Vec3(0.3, -0.2, 0.1)).norm();
  const Result<double> result = error < 1e-14
                                    ? Result<double>(error)
                                    : Result<double>(Error{ErrorCode::kRange, "consumer", "frames are wrong", ""});
  if (!result.ok()) {
    std::printf("%s\n", result.error().text().c_str());
    return 1;
  }
  std::printf("consumer: frames agree to %.1e\n", result.value());
  return 0;
}
