/// Solves with a multifrontal factor: single right-hand sides, and blocks of them.
#include <algorithm>

#include "lissom/core/multifrontal.h"
#include "lissom/core/multifrontal_packet.h"

namespace lissom::multifrontal {

namespace {

/// Right-hand sides that pass through the factor together, and packets of them that a tile holds.
constexpr int kMostColumns = 36;
constexpr int kTile = 3;

/// y -= the columns [at, at + Columns) of the panel times their unknowns, which are found on the way.
template <int Columns>
void forward(const double* panel, std::ptrdiff_t stride, int at, double* y) {
  const double* l = panel + at * stride;
  for (int j = 0; j < Columns; ++j) {
    for (int i = j + 1; i < Columns; ++i) y[at + i] -= l[j * stride + at + i] * y[at + j];
  }
  Packet x[Columns];
  for (int j = 0; j < Columns; ++j) x[j] = all(-y[at + j]);
  for (std::ptrdiff_t r = at + kPad; r < stride; r += kLanes) {
    Packet sum = load(y + r);
    for (int j = 0; j < Columns; ++j) sum = multiply_add(load(l + j * stride + r), x[j], sum);
    store(y + r, sum);
  }
}

template <int Columns>
void backward(const double* panel, std::ptrdiff_t stride, int at, double* y) {
  const double* l = panel + at * stride;
  Packet product[Columns];
  for (int j = 0; j < Columns; ++j) product[j] = all(0);
  for (std::ptrdiff_t r = at + kPad; r < stride; r += kLanes) {
    const Packet x = load(y + r);
    for (int j = 0; j < Columns; ++j) product[j] = multiply_add(load(l + j * stride + r), x, product[j]);
  }
  for (int j = Columns - 1; j >= 0; --j) {
    y[at + j] -= sum(product[j]);
    for (int i = j + 1; i < Columns; ++i) y[at + j] -= l[j * stride + at + i] * y[at + i];
  }
}

/// `rows` rows of right-hand sides minus L times the solved ones. Row r of the result stands at y + index(r) * width.
template <int Vectors, class Index>
void subtract_product(const double* l, std::ptrdiff_t stride, int depth, const double* x, std::ptrdiff_t width,
                      double* y, const Index& index) {
  Packet product[kPad][Vectors];
  for (int i = 0; i < kPad; ++i) {
    for (int v = 0; v < Vectors; ++v) product[i][v] = all(0);
  }
  for (int k = 0; k < depth; ++k, l += stride, x += width) {
    Packet row[Vectors];
    for (int v = 0; v < Vectors; ++v) row[v] = load(x + v * kLanes);
    for (int i = 0; i < kPad; ++i) {
      const Packet factor = all(l[i]);
      for (int v = 0; v < Vectors; ++v) product[i][v] = multiply_add(factor, row[v], product[i][v]);
    }
  }
  for (int i = 0; i < kPad; ++i) {
    double* to = y + index(i) * width;
    for (int v = 0; v < Vectors; ++v) store(to + v * kLanes, subtract(load(to + v * kLanes), product[i][v]));
  }
}

/// One front, Vectors packets of right-hand sides: x holds its pivots' rows, y all rows by their numbers.
template <int Vectors>
void forward_block(const double* panel, const Front& front, const int* row, int unknowns, double* y,
                   std::ptrdiff_t width) {
  const std::ptrdiff_t stride = front.stride();
  double* x = y + front.first * width;
  for (int at = 0; at < front.pivots; at += kPad) {
    const int columns = std::min(kPad, front.pivots - at);
    const int spare = unknowns - front.first;  // rows below the last are there to be written to
    if (at > 0) {
      subtract_product<Vectors>(panel + at, stride, at, x, width, x,
                                [&](int i) -> std::ptrdiff_t { return i < columns ? at + i : spare; });
    }
    const double* l = panel + at * stride + at;
    for (int j = 0; j < columns; ++j) {
      for (int i = j + 1; i < columns; ++i) {
        const Packet factor = all(-l[j * stride + i]);
        double* to = x + (at + i) * width;
        const double* from = x + (at + j) * width;
        for (int v = 0; v < Vectors; ++v) {
          store(to + v * kLanes, multiply_add(factor, load(from + v * kLanes), load(to + v * kLanes)));
        }
      }
    }
  }
  const double* below = panel + padded(front.pivots);
  for (int r = 0; r < front.updates; r += kPad) {
    subtract_product<Vectors>(below + r, stride, front.pivots, x, width, y,
                              [&](int i) -> std::ptrdiff_t { return r + i < front.updates ? row[r + i] : unknowns; });
  }
}

template <int Vectors>
void backward_block(const double* panel, const Front& front, const int* row, double* y, std::ptrdiff_t width) {
  const std::ptrdiff_t stride = front.stride();
  double* x = y + front.first * width;
  for (int at = (front.pivots - 1) / kPad * kPad; at >= 0; at -= kPad) {
    const int columns = std::min(kPad, front.pivots - at);
    const double* column[kPad];
    for (int j = 0; j < kPad; ++j) column[j] = panel + (at + std::min(j, columns - 1)) * stride;
    Packet product[kPad][Vectors];
    for (int j = 0; j < kPad; ++j) {
      for (int v = 0; v < Vectors; ++v) product[j][v] = all(0);
    }
    const auto add_row = [&](std::ptrdiff_t r, const double* from) {
      Packet solved[Vectors];
      for (int v = 0; v < Vectors; ++v) solved[v] = load(from + v * kLanes);
      for (int j = 0; j < kPad; ++j) {
        const Packet factor = all(column[j][r]);
        for (int v = 0; v < Vectors; ++v) product[j][v] = multiply_add(factor, solved[v], product[j][v]);
      }
    };
    const int below = padded(front.pivots);
    for (int r = 0; r < front.updates; ++r) add_row(below + r, y + row[r] * width);
    for (int r = at + columns; r < front.pivots; ++r) add_row(r, x + r * width);
    for (int j = columns - 1; j >= 0; --j) {
      double* to = x + (at + j) * width;
      for (int v = 0; v < Vectors; ++v) {
        Packet value = subtract(load(to + v * kLanes), product[j][v]);
        for (int i = j + 1; i < columns; ++i) {
          value = multiply_add(all(-column[j][at + i]), load(x + (at + i) * width + v * kLanes), value);
        }
        store(to + v * kLanes, value);
      }
    }
  }
}

}  // namespace

void Factor::solve(const double* b, double* x) const {
  const int n = plan_.unknowns;
  if (work_.size() < n) work_.resize(n);
  if (rows_.size() < plan_.most_rows) rows_.resize(plan_.most_rows);
  double* w = work_.data();
  double* y = rows_.data();
  for (int k = 0; k < n; ++k) w[k] = b[plan_.order[k]];
  const int count = static_cast<int>(plan_.fronts.size()) - 1;
  for (int f = 0; f < count; ++f) {
    const Front& front = plan_.fronts[f];
    const double* panel = factor_.data() + front.panel;
    const int stride = front.stride(), below = padded(front.pivots);
    std::copy(w + front.first, w + front.first + front.pivots, y);
    std::fill(y + front.pivots, y + stride, 0.0);
    for (int at = 0; at < front.pivots; at += kPad) {
      switch (front.pivots - at) {
        case 1:
          forward<1>(panel, stride, at, y);
          break;
        case 2:
          forward<2>(panel, stride, at, y);
          break;
        case 3:
          forward<3>(panel, stride, at, y);
          break;
        default:
          forward<4>(panel, stride, at, y);
      }
    }
    for (int k = 0; k < front.pivots; ++k) w[front.first + k] = y[k] * reciprocal_[front.first + k];
    const int* row = plan_.row.data() + front.rows;
    for (int i = 0; i < front.updates; ++i) w[row[i]] += y[below + i];
  }
  for (int f = count - 1; f >= 0; --f) {
    const Front& front = plan_.fronts[f];
    const double* panel = factor_.data() + front.panel;
    const int stride = front.stride(), below = padded(front.pivots);
    const int* row = plan_.row.data() + front.rows;
    std::copy(w + front.first, w + front.first + front.pivots, y);
    std::fill(y + front.pivots, y + below, 0.0);
    for (int i = 0; i < front.updates; ++i) y[below + i] = w[row[i]];
    std::fill(y + below + front.updates, y + stride, 0.0);
    for (int at = (front.pivots - 1) / kPad * kPad; at >= 0; at -= kPad) {
      switch (front.pivots - at) {
        case 1:
          backward<1>(panel, stride, at, y);
          break;
        case 2:
          backward<2>(panel, stride, at, y);
          break;
        case 3:
          backward<3>(panel, stride, at, y);
          break;
        default:
          backward<4>(panel, stride, at, y);
      }
    }
    std::copy(y, y + front.pivots, w + front.first);
  }
  for (int k = 0; k < n; ++k) x[plan_.order[k]] = w[k];
}

void Factor::solve_block(const double* b, double* x, int columns) const {
  const int n = plan_.unknowns;
  const int vectors = (columns + kLanes - 1) / kLanes;
  const std::ptrdiff_t width = vectors * kLanes;
  double* w = work_.data();
  for (int k = 0; k < n; ++k) {
    const double* from = b + plan_.order[k];
    for (int c = 0; c < columns; ++c) w[k * width + c] = from[static_cast<std::ptrdiff_t>(c) * n];
    std::fill(w + k * width + columns, w + (k + 1) * width, 0.0);
  }
  std::fill(w + n * width, w + (n + 1) * width, 0.0);
  const int count = static_cast<int>(plan_.fronts.size()) - 1;
  for (int f = 0; f < count; ++f) {
    const Front& front = plan_.fronts[f];
    const double* panel = factor_.data() + front.panel;
    const int* row = plan_.row.data() + front.rows;
    for (int v = 0; v < vectors; v += kTile) {
      switch (vectors - v) {
        case 1:
          forward_block<1>(panel, front, row, n, w + v * kLanes, width);
          break;
        case 2:
          forward_block<2>(panel, front, row, n, w + v * kLanes, width);
          break;
        default:
          forward_block<3>(panel, front, row, n, w + v * kLanes, width);
      }
    }
  }
  for (int k = 0; k < n; ++k) {
    for (int c = 0; c < width; ++c) w[k * width + c] *= reciprocal_[k];
  }
  for (int f = count - 1; f >= 0; --f) {
    const Front& front = plan_.fronts[f];
    const double* panel = factor_.data() + front.panel;
    const int* row = plan_.row.data() + front.rows;
    for (int v = 0; v < vectors; v += kTile) {
      switch (vectors - v) {
        case 1:
          backward_block<1>(panel, front, row, w + v * kLanes, width);
          break;
        case 2:
          backward_block<2>(panel, front, row, w + v * kLanes, width);
          break;
        default:
          backward_block<3>(panel, front, row, w + v * kLanes, width);
      }
    }
  }
  for (int k = 0; k < n; ++k) {
    double* to = x + plan_.order[k];
    for (int c = 0; c < columns; ++c) to[static_cast<std::ptrdiff_t>(c) * n] = w[k * width + c];
  }
}

void Factor::solve_many(const double* b, double* x, int columns) const {
  const std::ptrdiff_t n = plan_.unknowns;
  const int widest = (std::min(columns, kMostColumns) + kLanes - 1) / kLanes * kLanes;
  if (work_.size() < (n + 1) * widest) work_.resize((n + 1) * widest);
  for (int done = 0; done < columns; done += kMostColumns) {
    solve_block(b + done * n, x + done * n, std::min(kMostColumns, columns - done));
  }
}

}  // namespace lissom::multifrontal
