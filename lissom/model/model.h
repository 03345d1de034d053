#pragma once
/// The description of a structure: a value in SI units that knows nothing of DoFs or solvers.

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/brief.h"
#include "lissom/model/calibration.h"
#include "lissom/model/curve.h"
#include "lissom/model/expectation.h"
#include "lissom/model/fabric_test.h"
#include "lissom/model/material.h"
#include "lissom/model/membrane.h"
#include "lissom/model/motion_case.h"
#include "lissom/model/network_file.h"
#include "lissom/model/plan.h"
#include "lissom/model/pose.h"
#include "lissom/model/section.h"
#include "lissom/model/selector.h"
#include "lissom/model/solid.h"

namespace lissom {

/// Cross-section along a rod: values at uniformly spaced control places, linear in between. One value: constant.
struct SectionProfile {
  SectionShape shape = SectionShape::kEllipse;
  std::vector<double> r_n, r_b;  ///< m, half-extents along n and b, same length >= 1
  double wall = 0;               ///< m, tubes
};

/// Where the material axis n of a rod points at rest; b = n x t.
struct MaterialAxes {
  enum class Kind {
    kDirection,  ///< n: `normal` made perpendicular to the tangent
    kTransport,  ///< n of the first edge from `normal`, then carried along the curve without twist
    kPerPoint,   ///< n from `normals` at uniformly spaced places, interpolated, made perpendicular
    kJoints,     ///< n from the joint normals at both ends, turned evenly in between [mathematics 2.4]
  };
  Kind kind = Kind::kDirection;
  Vec3 normal = Vec3::UnitZ();
  std::vector<Vec3> normals;
};

/// The stress-free shape of a rod.
struct Natural {
  enum class Kind {
    kAsDrawn,   ///< the drawn curve and frames
    kStraight,  ///< straight and untwisted, of the drawn length
    kCurved,    ///< constant curvature and twist rate, of the drawn length
    kCurve,     ///< another curve, with its own axes, cut into the same edges
  };
  Kind kind = Kind::kAsDrawn;
  double curvature_b = 0;    ///< 1/m, towards b (kappa_1)
  double curvature_n = 0;    ///< 1/m, towards n (kappa_2)
  double twist = 0;          ///< rad/m
  double length_factor = 1;  ///< natural length over that of the shape above
  std::optional<Curve> curve;
  std::optional<MaterialAxes> axes;  ///< of `curve`; those of the rod when absent
};

struct Rod {
  std::string name;
  Curve curve;
  std::string material;  ///< name in Model::materials or in the library
  SectionProfile section;
  MaterialAxes axes;
  Natural natural;
  int edges = 0;           ///< number of edges; 0: from edge_length
  double edge_length = 0;  ///< m, target
};

/// How rods that meet at a point hold each other.
enum class JointKind {
  kExplicit,      ///< rotation of the joint is an unknown [mathematics 2.2]
  kCorotational,  ///< rotation follows the incident edges by shape matching [mathematics 2.3]
  kBall,          ///< shared point only: no moment passes
};

/// Of the corotational joint: consistent with its springs, or as printed in the thesis (erratum E10).
enum class JointWeights { kEnergy, kThesis };

struct JointChoice {
  Selector at;
  JointKind kind = JointKind::kExplicit;
};

struct Model {
  std::string title;
  std::string source;               ///< where the description comes from
  std::vector<Material> materials;  ///< besides the library
  std::vector<Rod> rods;
  std::vector<NetworkFile> network_files;            ///< files from which the last of the rods were read
  std::vector<MembraneMaterial> membrane_materials;  ///< besides the library
  std::vector<Membrane> membranes;
  std::vector<Solid> solids;
  std::vector<FabricTest> fabric_tests;
  std::optional<Plan> plan;  ///< rods on pre-stretched fabric, besides `rods` and `membranes`
  JointKind joint_kind = JointKind::kExplicit;
  JointWeights joint_weights = JointWeights::kEnergy;
  std::vector<JointChoice> joints;  ///< exceptions from joint_kind
  double merge_distance = 0;        ///< m, nodes closer than this are one; 0: 1e-6 of the size; negative: never merge
  TorsionModel torsion = TorsionModel::kSaintVenant;
  std::vector<NamedSet> sets;
  std::vector<Pose> poses;
  std::vector<MotionCase> motions;
  std::optional<Brief> design;             ///< what `lissom optimize` may change, and to which end
  std::optional<Calibration> calibration;  ///< what `lissom calibrate` is to find from which measurements
  std::vector<Expectation> expectations;

  const Material* material(std::string_view name) const;  ///< own first, then the library; null when unknown
  const MembraneMaterial* membrane_material(std::string_view name) const;  ///< the same for membranes
  const Pose* pose(std::string_view name) const;                           ///< null when unknown

  /// Everything that can be said without discretising: names resolve, numbers are possible, statements agree.
  Status validate() const;
};

}  // namespace lissom
