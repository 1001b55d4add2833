#pragma once

#include "core/imaging/angiogram.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// For each traced curve, the share 0…1 of its points that an earlier frame shows too: a dark line within 4 px
/// sideways, at least half as deep. A structure visible before the contrast agent arrives is not a vessel but a
/// catheter, a wire or a bone edge. Both frames have the same size; curves without radii get 0.
std::vector<double> shareSeenBefore(const Centerline2d& centerline, const ImageF& frame, const ImageF& before,
                                    Polarity polarity);

/// Evidence from an earlier frame about a trace.
struct SeenBefore {
    std::vector<int>
        curveIds;   ///< ascending; visible before while most are not; empty if vessels may have been opacified then
    bool isEverything = false;   ///< no contrast agent arrives between the two frames
};

SeenBefore seenBefore(const Centerline2d& centerline, const ImageF& frame, const ImageF& before, Polarity polarity);

/// Ids of stationary curves: in nearly all frames of the run, a dark line of similar depth lies within 1 px of them.
/// ECG clips, leads, hooks and shutter edges are stationary; vessels move, or fill and empty. Empty for runs of fewer
/// than five frames. `frame` is the one in which the curves were traced.
std::vector<int> stillCurves(const Centerline2d& centerline, const std::vector<ImageF>& frames, int frame,
                             Polarity polarity);

}   // namespace angiopose::core
