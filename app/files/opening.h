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

/// Files that have been read, with the way in which they are added to the case.
struct Opening {
    enum class Mode { Replace, Join, AddView };   ///< replaces the open case, adds inputs to it, or adds a view

    io::LoadedInputs inputs;
    QStringList paths;
    Mode mode = Mode::Join;
    std::optional<QString> original;   ///< for a copy, the path of its case; empty if that was never saved
    std::optional<bool> isSamePatient{};   ///< the user's answer about all images; if not set, the user was not asked
};

/// Returns whether only an angiogram was opened and the case has vessels and a different angiogram.
bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs);

/// Returns the case that would result from opening.
core::Result<core::Case> mergeIntoCase(const core::Case& open, const Opening& opening);

/// Adds the files to the document, as one undo step unless the case is replaced. Returns remarks for the user.
core::Result<QStringList> addToCase(CaseDocument& document, const Opening& opening);

/// Camera to use after opening a pose whose camera differs from that of the case.
enum class IncomingCamera { OfCase, OfPose };

/// Whether, and how, a pose from a file fits the shown view.
struct PoseCompatibility {
    QString refusal;   ///< reason why the pose cannot be used; empty if it can be used
    bool isOtherCamera = false;   ///< true if its camera differs from that of the case, so that the user must choose
    QStringList notes;   ///< remarks for the user, even if the pose is refused
};
PoseCompatibility checkPoseCompatibility(const core::Case& open, const io::PoseWithCamera& pose);

/// Sets the pose of the shown view in one undo step. Returns remarks for the user.
QStringList applyPose(CaseDocument& document, const io::PoseWithCamera& pose, IncomingCamera camera,
                      const QString& name);

/// Adds the points to the case as target points in one undo step. Returns remarks for the user; fails if none can be
/// used.
core::Result<QStringList> addTargetPoints(CaseDocument& document, const std::vector<io::Fiducial>& points,
                                          const QString& name);

}   // namespace angiopose::app
