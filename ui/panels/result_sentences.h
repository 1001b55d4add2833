#pragma once

#include "core/registration/registration.h"
#include "core/vessel/vessel_tree.h"

#include <QStringList>

#include <optional>

namespace angiopose::ui {

/// Sentences that interpret a pose assessment in clinical terms.
struct ResultSentences {
    QStringList certain;   ///< shown in green
    QStringList doubtful;   ///< shown in amber: limits of a single view, disagreeing branches and possible reasons
};

ResultSentences sentencesOf(const core::RegistrationResult& result, const core::VesselTree& tree,
                            double millimetersPerPixel);

/// Returns the standard deviation in depth, mm, if the image constrains depth much less than the other parameters;
/// otherwise nullopt.
std::optional<double> uncertainDepthMm(const core::PoseUncertainty& uncertainty);

/// Returns the branch name, e.g. "LAD", or "Branch 3" if unnamed.
QString displayName(const core::VesselBranch& branch);

}   // namespace angiopose::ui
