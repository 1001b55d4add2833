#pragma once

#include "core/geometry/rigid_transform.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A finished trial of an observer who fitted the vessels to an image by hand.
struct ObserverReading {
    std::string observer;
    std::string image;   ///< trials of the same case, image and frame bear the same text
    RigidTransform cameraFromPatient;   ///< as the observer left it
    RigidTransform centerCameraFromPatient;   ///< before the trial: what readings of the image are measured from
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();   ///< centroid of the tree
};

/// What is compared of a pose, in camera axes about the pivot: shifts in mm, turns in degrees.
inline constexpr std::size_t poseMeasureCount = 6;
struct PoseMeasure {
    const char* id;
    const char* name;
    const char* unit;
};
const std::array<PoseMeasure, poseMeasureCount>& poseMeasures();

/// An observer's answers to one image, seen from the pose before the first trial of that image: the mean of the repeats
/// and their variance, for each measure.
struct ObserverMean {
    std::string observer;
    std::string image;
    int count = 0;
    Eigen::Matrix<double, poseMeasureCount, 1> mean;
    Eigen::Matrix<double, poseMeasureCount, 1> variance;   ///< sample variance; zero of a single reading
};

/// By image, then by observer, both by name.
std::vector<ObserverMean> observerMeans(const std::vector<ObserverReading>& readings);

/// How an observer repeats one measure: pooled over the images that were read more than once (Bland and Altman 1996).
struct Repeatability {
    int images = 0;
    int readings = 0;
    double within = 0.0;   ///< standard deviation within an image
    double coefficient = 0.0;   ///< 1.96 √2 of it: two readings differ by less in 95 of 100
};
std::optional<Repeatability> repeatabilityOf(const std::vector<ObserverMean>& means, const std::string& observer,
                                             std::size_t measure);

/// Differences of two observers' means in the images that both read (Bland and Altman 1986), first minus second.
struct LimitsOfAgreement {
    std::vector<Eigen::Vector2d> points;   ///< (mean of both, difference), one per image
    double bias = 0.0;
    double deviation = 0.0;   ///< standard deviation of the differences
    double biasError = 0.0;   ///< standard error of the bias
    double limitError = 0.0;   ///< standard error of a limit of agreement, √(3/n) of the deviation

    double lower() const { return bias - 1.96 * deviation; }
    double upper() const { return bias + 1.96 * deviation; }
};
/// Nothing where both have fewer than two images in common.
std::optional<LimitsOfAgreement> agreementOf(const std::vector<ObserverMean>& means, const std::string& first,
                                             const std::string& second, std::size_t measure);

/// How far observers lie from each other: the standard deviation of their means within an image, pooled over the images
/// that more than one of them read.
struct Reproducibility {
    int images = 0;
    double between = 0.0;
};
std::optional<Reproducibility> reproducibilityOf(const std::vector<ObserverMean>& means, std::size_t measure);

/// Who read, by name.
std::vector<std::string> observersOf(const std::vector<ObserverMean>& means);

}   // namespace angiopose::core
