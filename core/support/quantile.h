#pragma once

#include <vector>

namespace angiopose::core {

/// Value below which `fraction` (0…1) of the values lie, linear between neighbours (R type 7); NaN when there are none.
double quantile(std::vector<double> values, double fraction);

/// The same for several fractions with one sort.
std::vector<double> quantiles(std::vector<double> values, const std::vector<double>& fractions);

/// The middle value, of an even number the upper one: always one of the values, of which there is at least one.
double medianOf(std::vector<double> values);

}   // namespace angiopose::core