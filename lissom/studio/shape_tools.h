#pragma once
/// Exploring and pulling: modes of the shape at hand, and a handle on a part of it. Both know the shape that they began at, and
/// say so when it is no longer that. Used by the engine's thread alone.

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/shape_modes.h"
#include "lissom/design/shape_response.h"
#include "lissom/studio/handle.h"
#include "lissom/studio/shape_packs.h"

namespace lissom {

class Desk;

class ShapeTools {
 public:
  explicit ShapeTools(Desk& desk) : desk_(desk) {}

  /// The design or its shape is another one now.
  void design_changed();
  void forget();
  void greet(int page) const;

  /// Starts the job `modes`.
  Status find_modes(int count);
  /// The parameter change of a mode as one step of history.
  Result<nlohmann::json> adopt_mode(int mode, double amplitude);  ///< m

  Result<nlohmann::json> begin_handle(const HandleGrip& grip);
  /// Answers with a pack.
  Result<nlohmann::json> move_handle(const HandleMove& move);
  Result<nlohmann::json> set_radius(double radius);  ///< m
  Result<nlohmann::json> accept_handle();            ///< starts the job `fit`
  void release_handle();

 private:
  /// What a job needs to make a response, taken on the engine's thread.
  struct Wanted {
    ShapeStart start;
    std::vector<PinnedNode> pins;
    HardConstraints constraints;
  };
  Result<Wanted> wanted() const;
  /// Of the shape at hand; made when there is none.
  Result<std::shared_ptr<const ShapeResponse>> response();
  void take_modes(std::shared_ptr<const ShapeResponse> response, std::vector<ShapeMode> modes);
  nlohmann::json modes_event() const;
  Pack modes_pack() const;
  nlohmann::json handle_event() const;

  Desk& desk_;
  std::shared_ptr<const ShapeResponse> response_;  ///< of the shape at hand, or null
  std::shared_ptr<const ShapeResponse> modes_of_;  ///< what the modes were found at
  std::vector<ShapeMode> modes_;
  bool modes_stale_ = true;
  std::optional<Handle> handle_;
};

/// Bounds and choices of what tools may change.
PlanSpaceOptions tool_space();

}  // namespace lissom
