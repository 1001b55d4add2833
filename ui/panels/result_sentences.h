#pragma once

#include "core/registration/registration.h"
#include "core/vessel/vessel_tree.h"

#include <QStringList>

#include <optional>

namespace angiopose::ui {

/// What the judgement of a pose means, in a clinician's words.
struct ResultSentences {
    QStringList certain;   ///< shown in green
    QStringList doubtful;   ///< shown in amber: what one view cannot tell, which branch disagrees and why that may be
};

ResultSentences sentencesOf(const core::RegistrationResult& result, const core::VesselTree& tree,
                            double millimetersPerPixel);

/// 1-σ along the ray where the image tells it much less than the rest; nothing where it is as certain.
std::optional<double> doubtfulDepthMm(const core::PoseUncertainty& uncertainty);

/// "LAD", or "Branch 3" where the tree has no names.
QString displayName(const core::VesselBranch& branch);

}   // namespace angiopose::ui