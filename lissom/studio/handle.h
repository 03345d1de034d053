#pragma once
/// A part of the shape that somebody has taken hold of: where it is wanted, how far around it gives way, and what the design
/// answers to first order.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/design/shape_fit.h"
#include "lissom/design/shape_modes.h"
#include "lissom/design/target_edit.h"

namespace lissom {

struct HandleGrip {
  std::vector<int> nodes;  ///< taken hold of
  std::vector<int> held;   ///< that are to stay where they are, softly
  double radius = 0;       ///< m, around the nodes, within which others follow
  double stay = 0.3;       ///< how much the rest wants to stay where it is (TargetEdit)
};

/// Where it is wanted since it was taken hold of.
struct HandleMove {
  Vec3 move = Vec3::Zero();  ///< m
  Vec3 turn = Vec3::Zero();  ///< rad, rotation vector about the centre
  double scale = 1;          ///< about the centre
};

class Handle {
 public:
  static Result<Handle> make(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints,
                             HandleGrip grip, const Context& context);

  const Vec3& centre() const { return centre_; }
  const HandleGrip& grip() const { return grip_; }
  const TargetEdit& edit() const { return *edit_; }
  Status set_radius(double radius);

  /// What the design answers.
  struct Preview {
    TargetEdit::Answer answer;
    State state;          ///< to first order, rods as long as they are
    VecX wanted;          ///< m, (3 per pulled node), displacements
    double residual = 0;  ///< N, of the forces that are left there
    double turn = 0;      ///< rad, largest of a rod edge
    bool stale = false;   ///< it goes further than a linear answer is good for
    std::string lags;     ///< why it stays further behind the pull than it would have to; empty: it does not
    std::string refused;  ///< why the design of the answer cannot be built; then there is no residual. Empty: it can

    /// It is time to accept and to go on from there.
    bool far() const { return stale || !lags.empty(); }
  };
  Result<Preview> move(const HandleMove& move);
  /// Of the last move; null before.
  const Preview* last() const { return last_.get(); }

  /// Where the accepted preview wants the shape: for ShapeFit.
  ShapeTarget target() const;

 private:
  /// Forces at the linear answer.
  struct Probe;
  Handle() = default;
  void weigh();
  /// The shape that goes with an answer, and what is to be said of it; false where there is none. `preview`: wanted, answer.
  bool follow(Preview& preview) const;

  std::shared_ptr<const ShapeResponse> response_;
  HardConstraints constraints_;
  HandleGrip grip_;
  Vec3 centre_ = Vec3::Zero();
  std::unique_ptr<TargetEdit> edit_;
  std::shared_ptr<Probe> probe_;
  std::shared_ptr<const Preview> last_;
};

}  // namespace lissom
