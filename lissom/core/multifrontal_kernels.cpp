#include "lissom/core/multifrontal_kernels.h"

#include <algorithm>
#include <cmath>

#include "lissom/core/multifrontal_packet.h"

namespace lissom::multifrontal {

namespace {

/// Columns that are computed together; L D is kept in groups of as many rows.
constexpr int kGroup = kPad;
constexpr int kTileRows = 3 * kLanes;
/// Columns after which the rest of a panel is updated.
constexpr int kBlock = 128;
/// Columns of L that go into an update at a time: a tile of them stays in the first cache.
constexpr int kDepth = 128;
/// Columns of an update from which a tile of L is copied to one place first: its own columns lie on a page each.
constexpr int kWorthCopying = 128;
static_assert(kGroup == 4 && kGroup % kLanes == 0);

/// c (-)= a b' for Vectors packets of rows and Columns columns: a by columns, b in groups of kGroup values.
template <int Vectors, int Columns, bool Accumulate>
inline void tile(const double* a, std::ptrdiff_t stride_a, const double* b, int depth, double* c,
                 std::ptrdiff_t stride_c) {
  Packet sum[Columns][Vectors];
  for (int j = 0; j < Columns; ++j) {
    for (int v = 0; v < Vectors; ++v) sum[j][v] = all(0);
  }
  for (int k = 0; k < depth; ++k, a += stride_a, b += kGroup) {
    Packet column[Vectors];
    for (int v = 0; v < Vectors; ++v) column[v] = load(a + v * kLanes);
    for (int j = 0; j < Columns; ++j) {
      const Packet factor = all(b[j]);
      for (int v = 0; v < Vectors; ++v) sum[j][v] = multiply_add(column[v], factor, sum[j][v]);
    }
  }
  for (int j = 0; j < Columns; ++j) {
    for (int v = 0; v < Vectors; ++v) {
      double* to = c + j * stride_c + v * kLanes;
      store(to, Accumulate ? subtract(load(to), sum[j][v]) : negative(sum[j][v]));
    }
  }
}

/// The same for any number of rows, a multiple of kLanes.
template <int Columns>
void update_columns(const double* a, std::ptrdiff_t stride_a, const double* b, int depth, double* c,
                    std::ptrdiff_t stride_c, int rows) {
  int r = 0;
  for (; r + kTileRows <= rows; r += kTileRows) {
    tile<3, Columns, true>(a + r, stride_a, b, depth, c + r, stride_c);
  }
  if (r + 2 * kLanes <= rows) {
    tile<2, Columns, true>(a + r, stride_a, b, depth, c + r, stride_c);
    r += 2 * kLanes;
  }
  if (r < rows) tile<1, Columns, true>(a + r, stride_a, b, depth, c + r, stride_c);
}

/// LDL' of the Columns x Columns block at `x`; false when it has to stop.
template <int Columns>
bool factor_block(double* x, std::ptrdiff_t stride, int at, const Elimination& elimination, PivotCount& count) {
  double* reciprocal = elimination.reciprocal + at;
  for (int j = 0; j < Columns; ++j) {
    const double pivot = x[j * stride + j];
    const bool usable = std::isfinite(pivot) && std::isfinite(1 / pivot);
    if (!usable || pivot < 0) {
      if (count.first_bad < 0) count.first_bad = elimination.first + at + j;
      if (!usable || elimination.on_negative == OnNegative::kStop) {
        count.broken = true;
        return false;
      }
      ++count.negative;
    }
    reciprocal[j] = 1 / pivot;
    double scaled[Columns];
    for (int i = j + 1; i < Columns; ++i) {
      scaled[i] = x[j * stride + i];
      x[j * stride + i] *= reciprocal[j];
    }
    for (int i = j + 1; i < Columns; ++i) {
      for (int c = j + 1; c <= i; ++c) x[c * stride + i] -= x[j * stride + i] * scaled[c];
    }
  }
  return true;
}

/// L and L D of the rows below a factored block. `x` points to its first column, `scaled` to the values of its first
/// column in the group of row 0.
template <int Columns>
void solve_rows(double* x, std::ptrdiff_t stride, int diagonal, int rows, const double* reciprocal, double* scaled,
                int pivots) {
  Packet lower[Columns][Columns], inverse[Columns];
  for (int j = 0; j < Columns; ++j) {
    inverse[j] = all(reciprocal[j]);
    for (int i = j + 1; i < Columns; ++i) lower[j][i] = all(-x[j * stride + diagonal + i]);
  }
  for (int r = diagonal + kGroup; r < rows; r += kLanes) {
    double* group = scaled + static_cast<std::ptrdiff_t>(r / kGroup) * kGroup * pivots + r % kGroup;
    Packet y[Columns];
    for (int j = 0; j < Columns; ++j) {
      y[j] = load(x + j * stride + r);
      for (int k = 0; k < j; ++k) y[j] = multiply_add(y[k], lower[k][j], y[j]);
      store(group + j * kGroup, y[j]);
      store(x + j * stride + r, multiply(y[j], inverse[j]));
    }
  }
}

/// Eliminates Columns columns from `at` on, with what the columns from `block` on do to them first.
template <int Columns>
bool eliminate(const Panel& panel, int block, int at, const Elimination& elimination, PivotCount& count) {
  const std::ptrdiff_t stride = panel.stride;
  double* columns = panel.x + at * stride;
  if (at > block) {
    const double* b = elimination.scaled + static_cast<std::ptrdiff_t>(at) * panel.pivots + block * kGroup;
    update_columns<Columns>(panel.x + block * stride + at, stride, b, at - block, columns + at, stride,
                            panel.stride - at);
  }
  if (!factor_block<Columns>(columns + at, stride, at, elimination, count)) return false;
  solve_rows<Columns>(columns, stride, at, panel.stride, elimination.reciprocal + at, elimination.scaled + at * kGroup,
                      panel.pivots);
  return true;
}

/// c (-)= L (L D)' in the lower triangle, for the columns [block, block + depth) of L and the rows from `row` on, whose
/// columns stand at c.
template <bool Accumulate>
void update_triangle(const Panel& panel, const double* scaled, int block, int depth, int row, int columns, double* c,
                     std::ptrdiff_t stride_c) {
  const std::ptrdiff_t stride = panel.stride;
  const double* a = panel.x + block * stride + row;
  const std::ptrdiff_t stride_b = static_cast<std::ptrdiff_t>(kGroup) * panel.pivots;
  const double* b = scaled + row / kGroup * stride_b + block * kGroup;
  const int rows = panel.stride - row;
  double copy[kTileRows * kDepth];
  for (int r = 0; r < rows;) {
    const int height = std::min(kTileRows, rows - r);
    const int end = std::min(r + height, columns);
    const double* rows_of_a = a + r;
    std::ptrdiff_t stride_a = stride;
    if (end >= kWorthCopying) {
      for (int k = 0; k < depth; ++k) {
        for (int v = 0; v < height; v += kLanes) store(copy + k * kTileRows + v, load(a + k * stride + r + v));
      }
      rows_of_a = copy;
      stride_a = kTileRows;
    }
    for (int j = 0; j < end; j += kGroup) {
      const double* bj = b + j / kGroup * stride_b;
      double* cj = c + j * stride_c + r;
      if (height == kTileRows) {
        tile<3, kGroup, Accumulate>(rows_of_a, stride_a, bj, depth, cj, stride_c);
      } else if (height == 2 * kLanes) {
        tile<2, kGroup, Accumulate>(rows_of_a, stride_a, bj, depth, cj, stride_c);
      } else {
        tile<1, kGroup, Accumulate>(rows_of_a, stride_a, bj, depth, cj, stride_c);
      }
    }
    r += height;
  }
}

}  // namespace

void factor_panel(const Panel& panel, const Elimination& elimination, PivotCount& count) {
  const double* scaled = elimination.scaled;
  for (int block = 0; block < panel.pivots; block += kBlock) {
    const int end = std::min(block + kBlock, panel.pivots);
    for (int at = block; at < end; at += kGroup) {
      bool ok = true;
      switch (std::min(kGroup, end - at)) {
        case 1:
          ok = eliminate<1>(panel, block, at, elimination, count);
          break;
        case 2:
          ok = eliminate<2>(panel, block, at, elimination, count);
          break;
        case 3:
          ok = eliminate<3>(panel, block, at, elimination, count);
          break;
        default:
          ok = eliminate<4>(panel, block, at, elimination, count);
      }
      if (!ok) return;
    }
    if (end == panel.pivots) return;
    // Whole groups only; the columns of the last, if it is narrower, come by themselves.
    const int columns = (panel.pivots - end) / kGroup * kGroup;
    double* rest = panel.x + end * static_cast<std::ptrdiff_t>(panel.stride) + end;
    update_triangle<true>(panel, scaled, block, end - block, end, columns, rest, panel.stride);
    const int last = end + columns;
    if (last == panel.pivots) continue;
    const std::ptrdiff_t stride = panel.stride;
    const double* b = scaled + static_cast<std::ptrdiff_t>(last) * panel.pivots + block * kGroup;
    const double* a = panel.x + block * stride + last;
    double* c = panel.x + last * stride + last;
    switch (panel.pivots - last) {
      case 1:
        update_columns<1>(a, stride, b, end - block, c, stride, panel.stride - last);
        break;
      case 2:
        update_columns<2>(a, stride, b, end - block, c, stride, panel.stride - last);
        break;
      default:
        update_columns<3>(a, stride, b, end - block, c, stride, panel.stride - last);
    }
  }
}

void form_update(const Panel& panel, const double* scaled, double* update) {
  const int row = padded(panel.pivots);
  const int rows = panel.stride - row;
  for (int block = 0; block < panel.pivots; block += kDepth) {
    const int depth = std::min(kDepth, panel.pivots - block);
    if (block == 0) {
      update_triangle<false>(panel, scaled, block, depth, row, rows, update, rows);
    } else {
      update_triangle<true>(panel, scaled, block, depth, row, rows, update, rows);
    }
  }
}

}  // namespace lissom::multifrontal
