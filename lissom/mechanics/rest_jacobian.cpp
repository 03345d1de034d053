#include "lissom/mechanics/rest_jacobian.h"

#include <algorithm>
#include <array>

#include "lissom/core/assert.h"
#include "lissom/core/traced_dual.h"
#include "lissom/mechanics/rest_pieces.h"
#include "lissom/mechanics/solid_rest_piece.h"

namespace lissom {

namespace {

template <class Piece>
void evaluate(const RestSource& s, const VecX& inputs, VecX& numbers) {
  std::array<double, Piece::kInputs> in;
  std::array<double, Piece::kOutputs> out;
  for (int k = 0; k < Piece::count(s); ++k) {
    const Piece piece(s, k);
    for (int i = 0; i < Piece::kInputs; ++i) in[i] = inputs[piece.input[i]];
    piece.template compute<double>(s, in.data(), out.data());
    for (int i = 0; i < Piece::kOutputs; ++i) numbers[piece.output[i]] = out[i];
  }
}

/// Rows follow each other in the order of the pieces, so that the matrix is filled row by row.
template <class Piece>
void differentiate(const RestSource& s, const VecX& inputs, Eigen::SparseMatrix<double, Eigen::RowMajor>& jacobian) {
  using Variable = Dual1<Piece::kInputs>;
  std::array<Variable, Piece::kInputs> in;
  std::array<Variable, Piece::kOutputs> out;
  std::array<int, Piece::kInputs> ascending;
  for (int k = 0; k < Piece::count(s); ++k) {
    const Piece piece(s, k);
    for (int i = 0; i < Piece::kInputs; ++i) {
      in[i] = Variable::variable(inputs[piece.input[i]], i);
      ascending[i] = i;
    }
    piece.template compute<Variable>(s, in.data(), out.data());
    std::sort(ascending.begin(), ascending.end(), [&](int a, int b) { return piece.input[a] < piece.input[b]; });
    for (int o = 0; o < Piece::kOutputs; ++o) {
      jacobian.startVec(piece.output[o]);
      for (const int i : ascending) {
        if (out[o].g[i] != 0) jacobian.insertBack(piece.output[o], piece.input[i]) = out[o].g[i];
      }
    }
  }
}

struct CurvatureSource {
  const RestSource& rest;
  const VecX &inputs, &y, &direction;
};

/// Adds one piece after the other, so that sums come out the same always.
template <class Piece>
void add_curvature(const CurvatureSource& s, Tape& tape, VecX& curvature) {
  std::array<TracedDual, Piece::kInputs> in;
  std::array<TracedDual, Piece::kOutputs> out;
  for (int k = 0; k < Piece::count(s.rest); ++k) {
    const Piece piece(s.rest, k);
    const auto touches = [](const VecX& x) { return [&x](int i) { return x[i] != 0; }; };
    if (std::none_of(piece.output.begin(), piece.output.end(), touches(s.y))) continue;
    if (std::none_of(piece.input.begin(), piece.input.end(), touches(s.direction))) continue;
    tape.clear();
    for (int i = 0; i < Piece::kInputs; ++i) {
      in[i] = tape.variable({s.inputs[piece.input[i]], s.direction[piece.input[i]], 0, 0});
    }
    piece.template compute<TracedDual>(s.rest, in.data(), out.data());
    for (int i = 0; i < Piece::kOutputs; ++i) tape.add_result(out[i], s.y[piece.output[i]]);
    tape.sweep();
    for (int i = 0; i < Piece::kInputs; ++i) curvature[piece.input[i]] += tape.by(in[i]).d1;
  }
}

}  // namespace

VecX rest_numbers_of(const Model& model, const System& system, const VecX& inputs) {
  const RestSource s(model, system);
  VecX numbers = VecX::Zero(s.numbers.size());
  evaluate<EdgeRestPiece>(s, inputs, numbers);
  evaluate<PairRestPiece>(s, inputs, numbers);
  evaluate<ConnectionRestPiece>(s, inputs, numbers);
  evaluate<TriangleRestPiece>(s, inputs, numbers);
  evaluate<HingeRestPiece>(s, inputs, numbers);
  evaluate<TetrahedronRestPiece>(s, inputs, numbers);
  return numbers;
}

SparseMatrix rest_jacobian(const Model& model, const System& system) {
  const RestSource s(model, system);
  const VecX inputs = rest_input_values(model, system);
  Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian(s.numbers.size(), s.inputs.size());
  jacobian.reserve(10 * s.numbers.size());
  differentiate<EdgeRestPiece>(s, inputs, jacobian);
  differentiate<PairRestPiece>(s, inputs, jacobian);
  differentiate<ConnectionRestPiece>(s, inputs, jacobian);
  differentiate<TriangleRestPiece>(s, inputs, jacobian);
  differentiate<HingeRestPiece>(s, inputs, jacobian);
  differentiate<TetrahedronRestPiece>(s, inputs, jacobian);
  jacobian.finalize();
  return jacobian;
}

VecX rest_curvature(const Model& model, const System& system, const VecX& y, const VecX& direction) {
  const RestSource s(model, system);
  LISSOM_ASSERT(y.size() >= s.numbers.size() && direction.size() == s.inputs.size());
  const VecX inputs = rest_input_values(model, system);
  const CurvatureSource source{s, inputs, y, direction};
  VecX curvature = VecX::Zero(s.inputs.size());
  Tape tape;
  add_curvature<EdgeRestPiece>(source, tape, curvature);
  add_curvature<PairRestPiece>(source, tape, curvature);
  add_curvature<ConnectionRestPiece>(source, tape, curvature);
  add_curvature<TriangleRestPiece>(source, tape, curvature);
  add_curvature<HingeRestPiece>(source, tape, curvature);
  add_curvature<TetrahedronRestPiece>(source, tape, curvature);
  return curvature;
}

}  // namespace lissom
