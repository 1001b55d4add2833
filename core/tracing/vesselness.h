#pragma once

#include "core/imaging/image2d.h"

namespace core {

/// Strength of the best bright ridge through each pixel over scales and directions, ≥ 0, in grey values of `opacity`.
/// Along each direction: second derivative minus slope across it (Gaussian derivatives at scale σ, made steerable:
/// Freeman & Adelson 1991; edges have both and cancel), averaged along it over ±2.5 σ, at least ±4 px, against noise,
/// less where only one half of that line has a ridge.
ImageF ridgeStrength(const ImageF& opacity, double minRadiusPx, double maxRadiusPx);

}   // namespace core
