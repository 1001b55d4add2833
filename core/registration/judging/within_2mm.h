#pragma once

#include "core/registration/problem/registration_result.h"

#include <array>
#include <string_view>

namespace angiopose::core {

inline constexpr std::size_t signCount = 15;

/// What the probability is made of: functions of the result's signs, distances and bend, each finite.
std::array<double, signCount> signVector(const RegistrationResult& result);

/// Their names, for tables.
const std::array<std::string_view, signCount>& signNames();

/// Probability that the overlay of a fit by the default method from one view lies within 2 mm of the vessels, in the
/// mean over the tree (ALGORITHMS §6.21).
double overlayProbability(const RegistrationResult& result);

}   // namespace angiopose::core
