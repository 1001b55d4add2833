#pragma once

#include "core/evaluation/trial/run_record.h"

#include <opencv2/core.hpp>
#include <vector>

namespace angiopose::benchmarks {

/// Tree points with their true pixels, and the start pose: what a solver needs that is told the correspondences, the
/// floor for all that must find them. The image is not mirrored, because OpenCV wants positive focal lengths.
struct KnownPartners {
    std::vector<cv::Point3d> points;   ///< patient LPS mm
    std::vector<cv::Point2d> pixels;
    cv::Matx33d camera;
    cv::Vec3d startTurn;
    cv::Vec3d startShift;
};

KnownPartners knownPartners(const core::Trial& trial);

/// OpenCV's solvers on them; the rotation vector and shift they find.
struct FoundPose {
    cv::Vec3d turn;
    cv::Vec3d shift;
};
FoundPose refineLm(const KnownPartners& partners);   ///< solvePnPRefineLM from the start pose
FoundPose sqpnp(const KnownPartners& partners);   ///< solvePnP with SQPNP, which needs no start

/// Mean projection distance to the true pixels.
double meanDistancePx(const KnownPartners& partners, const FoundPose& pose);

}   // namespace angiopose::benchmarks