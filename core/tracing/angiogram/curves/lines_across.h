#pragma once

#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Whether a path runs straight from one side of the field to another, as leads, wires and edges of bones outside the
/// heart do: no vessel enters a picture, keeps its direction and leaves it. Bends by one part in a hundred are allowed.
bool runsStraightAcross(const std::vector<Eigen::Vector2d>& pathPx, const Mask2d& field);

}   // namespace angiopose::core