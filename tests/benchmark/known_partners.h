#pragma once

#include "core/evaluation/trial/run_record.h"

#include <opencv2/core.hpp>
#include <vector>

namespace angiopose::benchmarks {

/// Tree points with their true pixels, and the initial pose: the input of a solver with known correspondences, a lower
/// bound for all methods that must find them. The image is not mirrored, because OpenCV requires positive focal
/// lengths.
struct KnownPartners {
    std::vector<cv::Point3d> points;   ///< patient LPS mm
    std::vector<cv::Point2d> pixels;
    cv::Matx33d camera;
    cv::Vec3d startTurn;
    cv::Vec3d startShift;
};

KnownPartners knownPartners(const core::Trial& trial);

/// Rotation vector and shift found by one of OpenCV's solvers.
struct FoundPose {
    cv::Vec3d turn;
    cv::Vec3d shift;
};
FoundPose refineLm(const KnownPartners& partners);   ///< solvePnPRefineLM from the initial pose
FoundPose sqpnp(const KnownPartners& partners);   ///< solvePnP with SQPNP, which needs no initial pose

/// Mean distance of the projected points from the true pixels, px.
double meanDistancePx(const KnownPartners& partners, const FoundPose& pose);

}   // namespace angiopose::benchmarks
