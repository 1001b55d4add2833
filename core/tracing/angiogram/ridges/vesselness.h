#pragma once

#include "core/imaging/image2d.h"

#include <vector>

namespace angiopose::core {

/// Scale of a ridge filter.
struct RidgeScale {
    double sigmaPx = 1.0;
    double weight = 1.0;   ///< weight of the ridges at this scale
};

/// Returns scales that together cover vessels of these radii, finest first, all with weight 1.
std::vector<RidgeScale> ridgeScales(double minRadiusPx, double maxRadiusPx);

/// Returns the strength of the best bright ridge through each pixel over `scales` and directions, ≥ 0, in gray values
/// of `opacity`. For each direction: second derivative minus slope across it (Gaussian derivatives at scale σ, made
/// steerable: Freeman & Adelson 1991; edges have both and cancel), averaged along it over ±2.5 σ, at least ±4 px, to
/// suppress noise, and reduced if only one half of that line has a ridge.
ImageF ridgeStrength(const ImageF& opacity, const std::vector<RidgeScale>& scales);

/// Returns the ridge strength over all scales for these radii.
ImageF ridgeStrength(const ImageF& opacity, double minRadiusPx, double maxRadiusPx);

}   // namespace angiopose::core
