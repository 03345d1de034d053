#pragma once
/// Dense kernels of the multifrontal factorisation: LDL' of a panel, and the update it leaves to its ancestors.
///
/// A front is a dense symmetric matrix whose first rows are eliminated in it. Only its lower triangle is held, in two
/// parts by columns: the panel (the columns that are eliminated, all rows) and the update matrix (the other columns).
/// Rows of both parts are padded to a multiple of `kPad`, so that no loop has a remainder:
///
///     panel:  rows [0, pivots)  padding  rows of the update matrix  padding
///
/// Written with Eigen's packets, which use fused multiplication where the processor has it.

namespace lissom::multifrontal {

constexpr int kPad = 4;  ///< rows; a multiple of the width of the packets in use

constexpr int padded(int count) { return (count + kPad - 1) / kPad * kPad; }

enum class OnNegative { kContinue, kStop };

/// The columns of a front that are eliminated in it.
struct Panel {
  double* x = nullptr;  ///< stride x pivots, column by column; after the factorisation L below the diagonal
  int pivots = 0;
  int stride = 0;  ///< padded(pivots) + padded(rows of the update matrix)
};

/// Pivots of an LDL' as they are met.
struct PivotCount {
  int negative = 0;
  int first_bad = -1;   ///< first pivot <= 0 or not finite, counted from the first of the matrix
  bool broken = false;  ///< a pivot that nothing can be divided by, or a negative one where these stop: no factor
};

/// How to eliminate a panel, and where to write what is not kept in it.
struct Elimination {
  double* scaled = nullptr;      ///< stride x pivots: L D, for `form_update`
  double* reciprocal = nullptr;  ///< of each pivot
  int first = 0;                 ///< number of the first pivot, for the count
  OnNegative on_negative = OnNegative::kContinue;
};

/// Replaces the panel by its factor L (unit lower triangle; what stands on the diagonal and above is not used). Stops
/// when `count.broken`.
void factor_panel(const Panel& panel, const Elimination& elimination, PivotCount& count);

/// Lower triangle of update = -L D L' of the rows below the pivots; by columns with the stride padded(rows). What
/// stands above the diagonal afterwards is not used.
void form_update(const Panel& panel, const double* scaled, double* update);

}  // namespace lissom::multifrontal
