#pragma once

#include "app/document/case_document.h"
#include "app/document/set_fields.h"

#include <memory>
#include <vector>

namespace angiopose::app {

using core::Case;
using core::Vessels;
using core::View;

/// A hand edit of the pose: what the last run said no longer holds, nor what following found.
using MovePose = SetFields<&View::cameraFromPatient, &View::result, &View::followed>;

/// What following found in the run of the shown view.
using KeepFollowed = SetFields<&View::followed>;

using ChangeSnapshots = SetFields<&View::snapshots>;

/// A blind trial: another start pose, and nothing in sight of what was found before.
using HideWhatIsKnown = SetFields<&View::cameraFromPatient, &View::initialCameraFromPatient, &View::result,
                                  &View::followed, &View::snapshots>;

/// Another frame, at the pose that following found there; where the gantry turned, the poses turn with it.
using ShowFrame = SetFields<&View::frame, &View::initialCameraFromPatient, &View::cameraFromPatient, &View::result>;

using ChooseAuxiliary = SetFields<&Vessels::auxiliaryBranchIds>;
using ExcludeBranches = SetFields<&Vessels::excludedBranchIds, &Case::views>;   // see withoutResults
using HideBranches = SetFields<&Vessels::hiddenBranchIds>;
using RelabelTree = SetFields<&Vessels::tree, &Vessels::isTreeEdited>;
using PickPivot = SetFields<&Vessels::pickedPivotInPatient>;

/// Other vessels, and the views with the pose that goes with them.
using ChangeVessels = SetFields<&Case::vessels, &Case::views>;

using ChangeOptions = SetFields<&Case::options>;
using ChangeGeometry = SetFields<&View::geometry, &View::cameraFromPatient, &View::result, &View::followed>;

/// All views at once: added, moved along with the shown one, or found by a run.
using ChangeViews = SetFields<&Case::views>;

/// Another view is shown, or one taken out.
using ShowView = SetFields<&Case::views, &Case::shownView>;

using ChangeLandmarks = SetFields<&View::landmarks>;
using ChangeMeasurements = SetFields<&View::measurements, &Vessels::measurements>;   // in the image and in slices
using TypeScale = SetFields<&View::typedMmPerPx>;
using ChangeMarks = SetFields<&Vessels::marks>;
using RemoveMarks = SetFields<&Vessels::marks, &Case::views>;   // with where they were seen, in all views
using ChangeSightings = SetFields<&View::sightings>;
using ChangeAnnotations = SetFields<&View::annotations>;

/// A start pose found by hand or landmarks becomes the case's own.
using PlaceVessels =
    SetFields<&View::initialCameraFromPatient, &View::cameraFromPatient, &View::result, &View::followed>;

using ChangeTracing = SetFields<&View::traceOptions, &View::result, &View::followed>;

/// Another target: the result of the last run was found with the former one.
using ChangeTarget = SetFields<&View::target, &View::result, &View::followed>;
using ChangeTreatment = SetFields<&View::treatment, &View::angiogram, &View::storedRun, &View::result, &View::followed>;

/// Other inputs, and all that hangs on them.
using JoinInputs = SetFields<&Case::title, &Case::vessels, &Case::views>;

/// Views of other vessels than their results were found with, and than were followed.
std::vector<View> withoutResults(std::vector<View> views);

/// The edit that makes the document's case like `wanted`, geometry only.
std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const Case& wanted, const ui::Words& name);

/// The edit that puts an edited tree into the case. Marks of branches that are gone go too; a pose at the start stays
/// there; what the last run said no longer holds.
std::unique_ptr<QUndoCommand> editTree(CaseDocument& document, core::VesselTree tree, const ui::Words& name);

enum class LumenOrigin { Found, Edited };

/// The edit that puts a newly traced tree into the case, with how it was traced.
struct TracedTree {
    core::InputFile file;   ///< that it was traced from
    core::VesselInput input;
    std::shared_ptr<const core::VoxelMask> lumen;
    std::shared_ptr<const core::VesselTree> tree;
    LumenOrigin lumenOrigin = LumenOrigin::Found;   ///< edited by hand: there is no file yet
};
std::unique_ptr<QUndoCommand> takeTrace(CaseDocument& document, const TracedTree& traced, const ui::Words& name);

/// The edit that makes the document's case like `wanted`, as far as views go; see core::showingView.
std::unique_ptr<QUndoCommand> showView(CaseDocument& document, const Case& wanted, const ui::Words& name);

/// The edit that takes over the inputs of `wanted` and all that hangs on them.
std::unique_ptr<QUndoCommand> joinInputs(CaseDocument& document, const Case& wanted, const ui::Words& name);

}   // namespace angiopose::app