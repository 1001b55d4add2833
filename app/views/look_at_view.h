#pragma once

#include "core/imaging/image2d.h"
#include "core/registration_case.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// One view of the case, small: its picture with the tree, and how its pose agrees with its own image.
struct ViewLook {
    std::shared_ptr<const core::RegistrationCase> view;   ///< which; null: the case's own
    std::optional<core::ColorImage> picture;
    std::optional<core::DistanceMetrics> metrics;
    std::optional<core::Message> problem;   ///< why there is no picture or no metrics
    std::shared_ptr<const core::Centerline2d> target;   ///< as it was traced for the metrics
};

/// Looks at the case's own view, whose target is `ownTarget` (null: none yet), and at the others, in this order. What
/// is traced already is taken from `known`. For a worker: takes a tenth of a second per view and more.
std::vector<ViewLook> lookAtViews(const core::RegistrationCase& registrationCase,
                                  const std::shared_ptr<const core::Centerline2d>& ownTarget,
                                  const std::vector<ViewLook>& known, int widthPx);

}   // namespace angiopose::app