#pragma once

#include "app/document/case_document.h"
#include "core/support/result.h"
#include "io/opening/loaded_inputs.h"
#include "io/opening/read_inputs.h"

#include <QStringList>
#include <optional>

namespace angiopose::app {

/// Files that have been read, and what becomes of them.
struct Opening {
    enum class Way { Replace, Join, AddView };   ///< the open case gives way, gets more, gets a further view

    io::LoadedInputs inputs;
    QStringList paths;
    Way way = Way::Join;
    std::optional<bool> isSamePatient{};   ///< of all images, as the user answered; none: there was nothing to ask
    std::optional<QString> original;   ///< of a copy of a case: where that lives; empty: it was never saved
};

/// An angiogram alone, and not the one that a case with vessels has.
bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs);

/// The open case as it would be.
core::Result<core::Case> caseWith(const core::Case& open, const Opening& opening);

/// Takes it into the document, as one step of undo where a case is open that stays. What to know about it, in words.
core::Result<QStringList> takeIn(CaseDocument& document, const Opening& opening);

/// Whose camera counts after a pose was opened that brings another one.
enum class ArrivingCamera { OfCase, OfPose };

/// How a pose from a file goes with the shown view.
struct PoseFit {
    QString refusal;   ///< why it cannot be taken; empty: it can
    bool isOtherCamera = false;   ///< it brings one that the case does not have: which counts has to be asked
    QStringList notes;   ///< what to know all the same
};
PoseFit poseFit(const core::Case& open, const io::PoseWithCamera& pose);

/// The pose becomes that of the shown view, one step of undo. What to know about it.
QStringList takePose(CaseDocument& document, const io::PoseWithCamera& pose, ArrivingCamera camera,
                     const QString& name);

/// Points become check points of the case, one step of undo. What to know about them, or why not.
core::Result<QStringList> takePoints(CaseDocument& document, const std::vector<io::Fiducial>& points,
                                     const QString& name);

}   // namespace angiopose::app
