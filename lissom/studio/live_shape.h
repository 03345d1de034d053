#pragma once
/// The shape of the document at hand as all pages see it: it follows edits, is shown while it settles, and is judged when it
/// has. Used by the engine's thread alone.

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "lissom/core/context.h"
#include "lissom/design/live_design.h"
#include "lissom/design/rigid_gauge.h"
#include "lissom/session/warnings.h"
#include "lissom/studio/pages.h"
#include "lissom/studio/shape_packs.h"

namespace lissom {

/// A shape to come back to. Snapshots of one mesh share it.
struct ShapeSnapshot {
  std::shared_ptr<const PlanMesh> mesh;
  std::shared_ptr<const Model> mesh_of;  ///< from which the mesh was made
  std::shared_ptr<const State> state;    ///< null: there is no shape
};

class LiveShape {
 public:
  /// What is to be shown along with a shape.
  struct Occasion {
    int drag = 0;      ///< of the request that is answered; 0: none
    int revision = 0;  ///< of the plan
  };

  /// When a search for a shape ends before it has found one.
  struct GivingWay {
    std::chrono::milliseconds own_time;  ///< that it has in any case
    std::function<bool()> overtaken;     ///< whether somebody waits for another shape
  };

  LiveShape(const Pages& pages, ThreadPool* threads, GivingWay giving_way);

  /// Releases a plan from its flat state.
  Status release(const Model& model, const Occasion& occasion);
  /// Follows a changed plan; in a drag with the mesh at hand for as long as it will do. After an error the shape is that of
  /// before.
  Status follow(const Model& model, const Occasion& occasion);
  /// Stands at a shape that was kept, of this plan.
  Status stand(const Model& model, const ShapeSnapshot& kept, const Occasion& occasion);
  /// Shows a structure that is not edited: as it is drawn, or in an equilibrium of a pose.
  void look_at(const Model& model, System system);
  void look_at(const Model& model, System system, const Equilibrium& equilibrium, int pose);
  /// The plan has another number, and is what it was.
  void stand_still(int revision);
  /// There is nothing to show.
  void forget();

  /// Null when there is none, or one to look at only.
  const LiveDesign* design() const { return design_.get(); }
  /// Whether the last search for a shape ended early, for a newer request.
  bool gave_way() const { return gave_way_; }
  /// Whether the shape is on a mesh that it would have without drags, too.
  bool mesh_fits() const { return !design_ || design_->mesh_fits(); }
  ShapeSnapshot snapshot() const;
  /// The equilibrium as it is shown: where pinned points stay.
  const State& shown() const { return shown_; }
  std::vector<PinnedNode> pins() const;
  int topology() const { return topology_; }
  const PlanParts& parts() const { return parts_; }

  const ShownFields& fields() const { return fields_; }
  void show_fields(const ShownFields& fields);

  /// Everything that there is to know of the shape, to one page.
  void greet(int page) const;
  const std::vector<Warning>& warnings() const { return warnings_; }

  /// Set by any thread: the solve at hand ends at once and keeps what it has.
  void stop() { stopped_ = true; }

 private:
  using Clock = std::chrono::steady_clock;

  LiveDesign::Options options();
  Context context();
  void begin(const Occasion& occasion);
  void watch(const LiveDesign& design, const State& state, double residual);
  void announce(const LiveDesign& design);
  void judge(const LiveDesign& design, std::string note, bool new_mesh);
  Pack shape_of(const LiveDesign& design, const State& state, double residual, bool settled) const;
  State pinned(const LiveDesign& design, const State& state) const;
  /// Points that were pinned since stay where they are now; others are forgotten.
  void renew_pins(const LiveDesign& design);
  void show_settled();
  void show_flat(const LiveDesign& design);

  const Pages& pages_;
  ThreadPool* threads_;
  GivingWay giving_way_;
  std::atomic<bool> stopped_ = false;
  bool gave_way_ = false;  ///< the solve at hand, to a newer request
  std::unique_ptr<LiveDesign> design_;
  const PlanMesh* announced_ = nullptr;
  std::shared_ptr<const Model> mesh_of_;
  int topology_ = 0;
  PlanParts parts_;
  std::map<std::string, Vec3> pinned_places_;  ///< m, by point
  State shown_;
  ShownFields fields_;
  Occasion occasion_;
  Clock::time_point began_, last_shown_;

  struct Looked {
    Model model;
    System system;
    State state;
    double share = 0;  ///< part of the pre-stretch that is there
  };
  void look(Looked looked);
  std::unique_ptr<Looked> looked_;

  Pack topology_pack_, shape_pack_, flat_pack_;
  nlohmann::json verdict_, measures_, warnings_event_;
  std::vector<Warning> warnings_;
};

}  // namespace lissom
