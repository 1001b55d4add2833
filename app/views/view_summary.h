#pragma once

#include "core/case/case.h"
#include "core/imaging/image2d.h"

#include <memory>
#include <optional>
#include <vector>

namespace angiopose::app {

/// The properties of a view on which its thumbnail, target and metrics depend.
struct ViewKey {
    std::shared_ptr<const core::Angiogram> angiogram;
    int frame = 0;
    std::shared_ptr<const core::Centerline2d> givenTarget;
    core::TraceOptions traceOptions;
    std::optional<core::ProjectionCamera> camera;
    Eigen::Matrix4d pose = Eigen::Matrix4d::Zero();

    bool operator==(const ViewKey&) const = default;
};
ViewKey viewKey(const core::View& view);

/// Summary of one view: a thumbnail with the tree, and the agreement of its pose with its own image.
struct ViewSummary {
    ViewKey key;
    std::optional<core::ColorImage> picture;
    std::optional<core::DistanceMetrics> metrics;
    std::optional<core::Message> problem;   ///< reason why the thumbnail or the metrics are missing
    std::shared_ptr<const core::Centerline2d> target;   ///< trace used for the metrics
};

/// Returns an earlier trace of the view's frame, whatever pose and camera the view had then; null if there is none.
std::shared_ptr<const core::Centerline2d> cachedTarget(const std::vector<ViewSummary>& known,
                                                       const ViewKey& requestedKey);

/// Summarizes the views of the case in order; `shownTarget` is the target of the shown view (null if not known yet).
/// Reuses the traces in `known`. Takes at least 0.1 s per view; call it on a worker thread.
std::vector<ViewSummary> summarizeViews(const core::Case& session,
                                        const std::shared_ptr<const core::Centerline2d>& shownTarget,
                                        const std::vector<ViewSummary>& known, int widthPx);

}   // namespace angiopose::app
