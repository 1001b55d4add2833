#pragma once

#include "core/registration/registration.h"

#include <filesystem>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// One real view of the coronary phantom, registered.
struct PhantomView {
    std::string name;
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
    double sourceToPatientMm = 0.0;
    Eigen::Matrix3d headerRotation = Eigen::Matrix3d::Identity();   ///< cameraFromPatient from the header's angles
    core::RegistrationInput input;   ///< traced automatically, rough initial pose
    core::RegistrationResult result;
    double depthMm = 0.0;   ///< of the tree's centroid
    double traceMs = 0.0;
};

/// Difference between the rotation of two registered views and the header's angles.
struct PhantomPair {
    std::size_t first = 0;
    std::size_t second = 0;
    double registeredDeg = 0.0;
    double expectedDeg = 0.0;
    double differenceDeg = 0.0;
};

double inDegrees(double radians);

std::filesystem::path phantomFolder();

/// Registers IM1 to IM4 of `folder`.
core::Result<std::vector<PhantomView>> registerPhantom(const std::filesystem::path& folder,
                                                       const core::RegistrationOptions& options);

std::vector<Eigen::Matrix3d> registeredRotations(const std::vector<PhantomView>& views);
std::vector<Eigen::Matrix3d> headerRotations(const std::vector<PhantomView>& views);

/// All pairs of views. `rotations` are cameraFromPatient, `expected` their expected values up to one common rotation of
/// the patient.
std::vector<PhantomPair> pairsOf(const std::vector<Eigen::Matrix3d>& rotations,
                                 const std::vector<Eigen::Matrix3d>& expected);

double medianDifferenceDeg(const std::vector<PhantomPair>& pairs);
double largestDifferenceDeg(const std::vector<PhantomPair>& pairs);

}   // namespace angiopose::benchmarks
