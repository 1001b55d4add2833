#pragma once

#include "app/document/case_document.h"
#include "core/support/result.h"
#include "io/opening/loaded_inputs.h"
#include "io/opening/read_inputs.h"

#include <QStringList>
#include <optional>

namespace angiopose::app {

/// Files that have been read and how they enter the case.
struct Opening {
    enum class Way { Replace, Join, AddView };   ///< replace the open case, add inputs to it, or add a view

    io::LoadedInputs inputs;
    QStringList paths;
    Way way = Way::Join;
    std::optional<QString> original;   ///< for a copy, path of its case (empty: never saved)
    std::optional<bool> isSamePatient{};   ///< the user's answer for all images; empty: not asked
};

/// Returns whether only an angiogram was opened and a case with vessels already has a different one.
bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs);

/// Returns the open case as it would be after opening.
core::Result<core::Case> caseWith(const core::Case& open, const Opening& opening);

/// Takes the files into the document, as one undo step if the open case stays. Returns remarks for the user.
core::Result<QStringList> takeIn(CaseDocument& document, const Opening& opening);

/// Camera to use after opening a pose with another one.
enum class ArrivingCamera { OfCase, OfPose };

/// Compatibility of a pose from a file with the displayed view.
struct PoseFit {
    QString refusal;   ///< reason why the pose cannot be used; empty: it can
    bool isOtherCamera = false;   ///< its camera differs from that of the case: ask which to use
    QStringList notes;   ///< remarks for the user in any case
};
PoseFit poseFit(const core::Case& open, const io::PoseWithCamera& pose);

/// Sets the pose of the displayed view as one undo step. Returns remarks for the user.
QStringList takePose(CaseDocument& document, const io::PoseWithCamera& pose, ArrivingCamera camera,
                     const QString& name);

/// Adds the points as target points of the case in one undo step. Returns remarks for the user; fails if they cannot be
/// used.
core::Result<QStringList> takePoints(CaseDocument& document, const std::vector<io::Fiducial>& points,
                                     const QString& name);

}   // namespace angiopose::app
