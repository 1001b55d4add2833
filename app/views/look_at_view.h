#pragma once

#include "core/case/case.h"
#include "core/imaging/image2d.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// All of a view that its picture, its target and its numbers hang on.
struct ViewSight {
    std::shared_ptr<const core::Angiogram> angiogram;
    int frame = 0;
    std::shared_ptr<const core::Centerline2d> givenTarget;
    core::TraceOptions traceOptions;
    std::optional<core::ProjectionCamera> camera;
    Eigen::Matrix4d pose = Eigen::Matrix4d::Zero();

    bool operator==(const ViewSight&) const = default;
};
ViewSight sightOf(const core::View& view);

/// One view of the case, small: its picture with the tree, and how its pose agrees with its own image.
struct ViewLook {
    ViewSight of;
    std::optional<core::ColorImage> picture;
    std::optional<core::DistanceMetrics> metrics;
    std::optional<core::Message> problem;   ///< why there is no picture or no metrics
    std::shared_ptr<const core::Centerline2d> target;   ///< as it was traced for the metrics
};

/// What was traced already in the frame of a view, whatever pose and camera it had then; null: nothing.
std::shared_ptr<const core::Centerline2d> knownTarget(const std::vector<ViewLook>& known, const ViewSight& sight);

/// Looks at the views of the case, in order; the target of the shown one is `shownTarget` (null: none yet). What is
/// traced already is taken from `known`. For a worker: takes a tenth of a second per view and more.
std::vector<ViewLook> lookAtViews(const core::Case& session,
                                  const std::shared_ptr<const core::Centerline2d>& shownTarget,
                                  const std::vector<ViewLook>& known, int widthPx);

}   // namespace angiopose::app