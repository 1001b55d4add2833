#pragma once

#include "core/registration/problem/registration_result.h"

#include <array>
#include <string_view>

namespace angiopose::core {

inline constexpr std::size_t featureCount = 15;

/// Returns the features of the probability model (indicators, distances and deformation), all finite.
std::array<double, featureCount> featureVector(const RegistrationResult& result);

/// Returns the names of the features, for tables.
const std::array<std::string_view, featureCount>& featureNames();

/// Returns the probability that the overlay of a single-view fit by the default method lies within 2 mm of the vessels,
/// averaged over the tree (ALGORITHMS §6.21).
double overlayProbability(const RegistrationResult& result);

}   // namespace angiopose::core
