#pragma once

#include "core/imaging/image2d.h"
#include "core/tracing/angiogram/evidence/vessel_network.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// The frame with the middle grey of its field outside of it: a black surround of any size must not change what the
/// network makes of contrasts inside.
ImageF withGreyOutside(ImageF frame, const Mask2d& field);

/// The evidence of ridges as the network judges it: raised where it sees vessels, lowered where it sees none. 0 outside
/// the field, as before.
ImageF judgedEvidence(ImageF evidence, const ImageF& vesselProbability, const Mask2d& field);

/// Where the network is rather sure of a vessel, inside the field.
Mask2d likelyVessels(const ImageF& vesselProbability, const Mask2d& field);

/// Ids of curves that mostly run where the network sees devices rather than vessels; `factor` is px of its answer per
/// px of the curves.
std::vector<int> deviceCurves(const Centerline2d& centerline, const FrameClasses& classes, double factor);

}   // namespace angiopose::core
