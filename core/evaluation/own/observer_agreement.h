#pragma once

#include "core/geometry/rigid_transform.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::core {

/// A finished trial in which an observer registered the vessels to an image manually.
struct ObserverReading {
    std::string observer;
    std::string image;   ///< key made of case, image and frame, the same for all trials of that image
    RigidTransform cameraFromPatient;   ///< final pose set by the observer
    RigidTransform referenceCameraFromPatient;   ///< pose before the trial, the reference for all readings of the image
    Eigen::Vector3d pivotInPatient = Eigen::Vector3d::Zero();   ///< centroid of the tree
};

/// Number of compared pose measures, in camera axes about the pivot: shifts in mm, rotations in degrees.
inline constexpr std::size_t poseMeasureCount = 6;
struct PoseMeasure {
    const char* id;
    const char* name;
    const char* unit;
};
const std::array<PoseMeasure, poseMeasureCount>& poseMeasures();

/// Mean and variance of each measure over an observer's repeated readings of one image, relative to the pose before the
/// first trial of that image.
struct ObserverMean {
    std::string observer;
    std::string image;
    int count = 0;
    Eigen::Matrix<double, poseMeasureCount, 1> mean;
    Eigen::Matrix<double, poseMeasureCount, 1> variance;   ///< sample variance; zero for a single reading
};

/// Returns the means sorted by image, then by observer, both by name.
std::vector<ObserverMean> observerMeans(const std::vector<ObserverReading>& readings);

/// Repeatability of one measure by one observer, pooled over the images read more than once (Bland and Altman 1996).
struct Repeatability {
    int images = 0;
    int readings = 0;
    double withinStd = 0.0;   ///< within-image standard deviation
    double coefficient = 0.0;   ///< 1.96 √2 × `within`: 95 % of all pairs of readings differ by less
};
std::optional<Repeatability> repeatabilityOf(const std::vector<ObserverMean>& means, const std::string& observer,
                                             std::size_t measure);

/// Differences, first minus second, between two observers' means in the images that both read (Bland and Altman 1986).
struct LimitsOfAgreement {
    std::vector<Eigen::Vector2d> points;   ///< (mean of both, difference), one per image
    double bias = 0.0;
    double stdDeviation = 0.0;   ///< standard deviation of the differences
    double biasError = 0.0;   ///< standard error of the bias
    double limitError = 0.0;   ///< standard error of a limit of agreement: √(3/n) times `deviation`

    double lower() const { return bias - 1.96 * stdDeviation; }
    double upper() const { return bias + 1.96 * stdDeviation; }
};
/// Returns the agreement of two observers, or nullopt if they have fewer than two images in common.
std::optional<LimitsOfAgreement> agreementOf(const std::vector<ObserverMean>& means, const std::string& first,
                                             const std::string& second, std::size_t measure);

/// Reproducibility between observers: the standard deviation of the observers' means of an image, pooled over the
/// images that more than one observer read.
struct Reproducibility {
    int images = 0;
    double betweenStd = 0.0;
};
std::optional<Reproducibility> reproducibilityOf(const std::vector<ObserverMean>& means, std::size_t measure);

/// Returns the sorted names of the observers.
std::vector<std::string> observersOf(const std::vector<ObserverMean>& means);

}   // namespace angiopose::core
