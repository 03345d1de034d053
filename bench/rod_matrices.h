#pragma once
/// Matrices with the stencils of discrete rods and values from a fixed seed, for the benchmark and the tests of the
/// solvers.

#include <cstdint>
#include <vector>

#include "lissom/core/sparse_pattern.h"

namespace lissom::rod_matrices {

/// Numbers that are the same on every platform (xorshift64*), in [-1, 1).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double next() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<double>((state_ * 0x2545F4914F6CDD1DULL) >> 11) * 0x1p-52 - 1;
  }

 private:
  std::uint64_t state_;
};

/// Groups of unknowns that share a dense block.
struct Blocks {
  int size = 0;  ///< unknowns in all
  std::vector<int> indices;
  std::vector<int> offsets{0};

  void add(std::initializer_list<int> first_and_count) {
    for (auto it = first_and_count.begin(); it != first_and_count.end(); it += 2) {
      for (int k = 0; k < it[1]; ++k) indices.push_back(it[0] + k);
    }
    offsets.push_back(static_cast<int>(indices.size()));
  }
  SparsePattern pattern() const { return {size, indices, offsets}; }
};

/// One rod: 3 unknowns per node, then 1 per edge; blocks x0 x1 x2 t1 t2.
inline Blocks chain(int nodes) {
  Blocks b;
  b.size = 3 * nodes + nodes - 1;
  for (int i = 1; i + 1 < nodes; ++i) b.add({3 * i - 3, 9, 3 * nodes + i - 1, 2});
  return b;
}

/// A honeycomb of `rows` x `columns` joints (3 positions, 3 rotations each) with rods of `edges` edges.
inline Blocks honeycomb(int rows, int columns, int edges) {
  Blocks b;
  const auto joint = [&](int r, int c) { return 6 * (r * columns + c); };
  b.size = 6 * rows * columns;
  const auto rod = [&](int from, int to) {
    const int inner = b.size;
    const int twist = inner + 3 * (edges - 1);
    b.size = twist + edges;
    const auto node = [&](int k) { return k == 0 ? from : k == edges ? to : inner + 3 * (k - 1); };
    b.add({from, 6, node(1), 3, twist, 1});
    for (int k = 1; k < edges; ++k) b.add({node(k - 1), 3, node(k), 3, node(k + 1), 3, twist + k - 1, 2});
    b.add({to, 6, node(edges - 1), 3, twist + edges - 1, 1});
  };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      if (c + 1 < columns) rod(joint(r, c), joint(r, c + 1));
      if (r + 1 < rows && (r + c) % 2 == 0) rod(joint(r, c), joint(r + 1, c));
    }
  }
  return b;
}

/// A square grid of vertices with 3 unknowns each and blocks of 9: the stencil of a membrane.
inline Blocks membrane(int rows, int columns) {
  Blocks b;
  b.size = 3 * rows * columns;
  const auto vertex = [&](int r, int c) { return 3 * (r * columns + c); };
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      b.add({vertex(r, c), 3, vertex(r + 1, c), 3, vertex(r, c + 1), 3});
      b.add({vertex(r + 1, c + 1), 3, vertex(r + 1, c), 3, vertex(r, c + 1), 3});
    }
  }
  return b;
}

/// Sum of positive definite blocks; scale < 0 turns the sign of every seventh one.
inline std::vector<double> values(const Blocks& b, const SparsePattern& pattern, bool indefinite = false) {
  Random random(7);
  std::vector<double> v(pattern.nonzeros(), 0.0);
  for (std::size_t g = 0; g + 1 < b.offsets.size(); ++g) {
    const int size = b.offsets[g + 1] - b.offsets[g];
    const int* at = b.indices.data() + b.offsets[g];
    const double sign = indefinite && g % 7 == 3 ? -1 : 1;
    for (int rank = 0; rank < 4; ++rank) {
      VecX u(size);
      for (double& x : u) x = random.next();
      for (int i = 0; i < size; ++i) {
        for (int j = 0; j <= i; ++j) v[pattern.slot(at[i], at[j])] += sign * u[i] * u[j];
      }
    }
    for (int i = 0; i < size; ++i) v[pattern.diagonal_slot(at[i])] += sign * 0.05;
  }
  return v;
}

}  // namespace lissom::rod_matrices
