#pragma once

#include "core/imaging/angiogram.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// Returns for each traced curve the fraction (0…1) of points at which an earlier frame already shows a dark line, at
/// least half as deep and within 4 px laterally. A structure visible before the contrast agent arrives is a catheter, a
/// wire or a bone edge, not a vessel. Both frames must have the same size; curves without radii get 0.
std::vector<double> fractionsVisibleBefore(const Centerline2d& centerline, const ImageF& frame,
                                           const ImageF& earlierFrame, Polarity polarity);

/// Parts of a trace that are already visible in an earlier frame.
struct EarlierStructures {
    std::vector<int> curveIds;   ///< curves visible before, ascending; empty if vessels may already have been opacified
    bool isNearlyAll = false;   ///< whether nearly all was visible before, so that no contrast agent arrived
};

EarlierStructures findEarlierStructures(const Centerline2d& centerline, const ImageF& frame, const ImageF& earlierFrame,
                                        Polarity polarity);

/// Returns the ids of stationary curves: in nearly all frames of the run, a dark line of similar depth lies within 1 px
/// of the curve. ECG clips, leads, hooks and shutter edges are stationary; vessels move, or opacify and wash out. Empty
/// for runs of fewer than five frames. `frame` is the frame in which the curves were traced.
std::vector<int> findStationaryCurves(const Centerline2d& centerline, const std::vector<ImageF>& frames, int frame,
                                      Polarity polarity);

}   // namespace angiopose::core
