#pragma once

#include "app/document/case_document.h"
#include "core/support/result.h"
#include "io/opening/loaded_inputs.h"
#include "io/opening/read_inputs.h"

#include <QStringList>
#include <optional>

namespace angiopose::app {

/// Joins file names, e.g. "a.dcm, b.vtp".
QString namesOf(const QStringList& paths);

/// Files that have been read, and how they are added to the case.
struct Opening {
    enum class Mode { Replace, Join, AddView };   ///< replaces the open case, adds inputs to it, or adds a view

    io::LoadedInputs inputs;
    QStringList paths;
    Mode mode = Mode::Join;
    std::optional<QString> original;   ///< for a copy, path of its case (empty: never saved)
    std::optional<bool> isSamePatient{};   ///< the user's answer for all images; empty: not asked
};

/// Returns whether the only opened file is an angiogram and the case, which has vessels, already has a different one.
bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs);

/// Returns the case that would result from opening.
core::Result<core::Case> resultingCase(const core::Case& open, const Opening& opening);

/// Adds the files to the document, as one undo step unless the case is replaced. Returns remarks for the user.
core::Result<QStringList> addToCase(CaseDocument& document, const Opening& opening);

/// Camera to use after opening a pose whose camera differs from that of the case.
enum class IncomingCamera { OfCase, OfPose };

/// Compatibility of a pose from a file with the displayed view.
struct PoseCompatibility {
    QString refusal;   ///< reason why the pose cannot be used; empty if it can
    bool isOtherCamera = false;   ///< true if its camera differs from that of the case, so the user must choose one
    QStringList notes;   ///< remarks for the user, even if the pose is refused
};
PoseCompatibility checkPoseCompatibility(const core::Case& open, const io::PoseWithCamera& pose);

/// Sets the pose of the displayed view as one undo step. Returns remarks for the user.
QStringList applyPose(CaseDocument& document, const io::PoseWithCamera& pose, IncomingCamera camera,
                      const QString& name);

/// Adds the points to the case as target points in one undo step. Returns remarks for the user; fails if the points
/// cannot be used.
core::Result<QStringList> addTargetPoints(CaseDocument& document, const std::vector<io::Fiducial>& points,
                                          const QString& name);

}   // namespace angiopose::app
