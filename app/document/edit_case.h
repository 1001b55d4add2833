#pragma once

#include "app/document/case_document.h"
#include "app/document/set_fields.h"

#include <memory>
#include <vector>

namespace angiopose::app {

using core::Case;
using core::Vessels;
using core::View;

/// Manual edit of the pose, which invalidates the result of the last registration and the tracked poses.
using MovePose = SetFields<&View::cameraFromPatient, &View::result, &View::followed>;

/// Tracked poses of the shown view's run.
using SetTrackedPoses = SetFields<&View::followed>;

using ChangeSnapshots = SetFields<&View::snapshots>;

/// Start of a blind trial, which sets another initial pose and hides all earlier results.
using StartBlindTrial = SetFields<&View::cameraFromPatient, &View::initialCameraFromPatient, &View::result,
                                  &View::followed, &View::snapshots>;

/// Change of frame, which applies the pose tracked in that frame; if the gantry angle changes, the poses are adapted.
using ShowFrame = SetFields<&View::frame, &View::initialCameraFromPatient, &View::cameraFromPatient, &View::result>;

using SelectAuxiliary = SetFields<&Vessels::auxiliaryBranchIds>;
using ExcludeBranches = SetFields<&Vessels::excludedBranchIds, &Case::views>;   // views as from removeResults
using HideBranches = SetFields<&Vessels::hiddenBranchIds>;
using RelabelTree = SetFields<&Vessels::tree, &Vessels::isTreeEdited>;
using PickPivot = SetFields<&Vessels::pickedPivotInPatient>;

/// Change of the vessels together with the views and their poses.
using ChangeVessels = SetFields<&Case::vessels, &Case::views>;

using ChangeOptions = SetFields<&Case::options>;
using ChangeGeometry = SetFields<&View::geometry, &View::cameraFromPatient, &View::result, &View::followed>;

/// Change of all views at once, e.g. adding views, moving them along with the displayed one, or registering them.
using ChangeViews = SetFields<&Case::views>;

/// Change of the shown view, or removal of a view.
using ShowView = SetFields<&Case::views, &Case::shownView>;

using ChangeLandmarks = SetFields<&View::landmarks>;
using ChangeMeasurements = SetFields<&View::measurements, &Vessels::measurements>;   // in the image and in the slices
using SetPixelScale = SetFields<&View::enteredMmPerPx>;
using ChangeMarks = SetFields<&Vessels::marks>;
using RemoveMarks = SetFields<&Vessels::marks, &Case::views>;   // with their positions in the images of all views
using ChangeObservations = SetFields<&View::observations>;
using ChangeAnnotations = SetFields<&View::annotations>;

/// Initial pose set manually or from landmarks.
using ChangeInitialPose =
    SetFields<&View::initialCameraFromPatient, &View::cameraFromPatient, &View::result, &View::followed>;

using ChangeTracing = SetFields<&View::traceOptions, &View::result, &View::followed>;

/// Change of the target, which invalidates the result found with the previous one.
using ChangeTarget = SetFields<&View::target, &View::result, &View::followed>;
using ChangeTreatment =
    SetFields<&View::processing, &View::angiogram, &View::storedRun, &View::result, &View::followed>;

/// Change of the inputs and everything that depends on them.
using AddInputs = SetFields<&Case::title, &Case::vessels, &Case::views>;

/// Returns the views without results and tracked poses, for use after a change of the vessels.
std::vector<View> removeResults(std::vector<View> views);

/// Creates the edit that gives the document's case the geometry of `wanted`.
std::unique_ptr<QUndoCommand> changeGeometry(CaseDocument& document, const Case& newCase,
                                             const ui::LocalizedText& name);

/// Creates the edit that replaces the tree by an edited one. Removes deleted branches from all selections, and removes
/// the result of the last registration; an initial pose stays initial.
std::unique_ptr<QUndoCommand> editTree(CaseDocument& document, core::VesselTree tree, const ui::LocalizedText& name);

enum class LumenOrigin { Found, Edited };

/// Newly traced tree with the inputs and settings of the trace; `applyTrace` creates the edit that adds it to the case.
struct TracedTree {
    core::InputFile file;   ///< file from which the tree was traced
    core::VesselInput input;
    std::shared_ptr<const core::VoxelMask> lumen;
    std::shared_ptr<const core::VesselTree> tree;
    LumenOrigin lumenOrigin = LumenOrigin::Found;   ///< `Edited` if the lumen was edited manually and has no file yet
};
std::unique_ptr<QUndoCommand> applyTrace(CaseDocument& document, const TracedTree& traced,
                                         const ui::LocalizedText& name);

/// Creates the edit that gives the document's case the views of `wanted`; see core::withShownView.
std::unique_ptr<QUndoCommand> showView(CaseDocument& document, const Case& newCase, const ui::LocalizedText& name);

/// Creates the edit that takes the inputs of `wanted` and everything that depends on them.
std::unique_ptr<QUndoCommand> addInputs(CaseDocument& document, const Case& newCase, const ui::LocalizedText& name);

}   // namespace angiopose::app
