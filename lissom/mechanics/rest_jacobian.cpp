#include "lissom/mechanics/rest_jacobian.h"

#include <algorithm>
#include <array>

#include "lissom/mechanics/rest_pieces.h"

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

}  // namespace

VecX rest_numbers_of(const Model& model, const System& system, const VecX& inputs) {
  const RestSource s(model, system);
  VecX numbers = VecX::Zero(s.numbers.size());
  evaluate<EdgeRestPiece>(s, inputs, numbers);
  evaluate<PairRestPiece>(s, inputs, numbers);
  evaluate<ConnectionRestPiece>(s, inputs, numbers);
  evaluate<TriangleRestPiece>(s, inputs, numbers);
  evaluate<HingeRestPiece>(s, inputs, numbers);
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
  jacobian.finalize();
  return jacobian;
}

}  // namespace lissom
