#pragma once
/// All kinds of edits, each in its own file edit_<name>.cpp.

#include "lissom/editing/edit_reader.h"
#include "lissom/editing/edits_json.h"

namespace lissom {

extern const EditInfo kEditMovePoints;
extern const EditInfo kEditTransformPoints;
extern const EditInfo kEditAddRod;
extern const EditInfo kEditInsertPoint;
extern const EditInfo kEditRemove;
extern const EditInfo kEditSetRadii;
extern const EditInfo kEditSetRole;
extern const EditInfo kEditSetSplit;
extern const EditInfo kEditSetCurve;
extern const EditInfo kEditSetClosed;
extern const EditInfo kEditSplitRod;
extern const EditInfo kEditJoinRods;
extern const EditInfo kEditMergePoints;
extern const EditInfo kEditRename;
extern const EditInfo kEditMirror;
extern const EditInfo kEditSetPreStretch;
extern const EditInfo kEditSetFabric;
extern const EditInfo kEditSetRods;
extern const EditInfo kEditAddHole;
extern const EditInfo kEditRemoveHole;
extern const EditInfo kEditStrengthen;
extern const EditInfo kEditSetTitle;
extern const EditInfo kEditSetConstraints;
extern const EditInfo kEditSetDesign;

}  // namespace lissom
