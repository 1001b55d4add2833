#pragma once

#include "core/imaging/angiogram.h"
#include "core/vessel/centerline2d.h"

#include <vector>

namespace angiopose::core {

/// How much of each traced curve, 0…1 of its points, an earlier frame shows too: a dark line there, within 4 px
/// sideways, at least half as deep. What is seen before the contrast medium comes is no vessel but a catheter, a wire
/// or the edge of a bone. Both frames are of one size; curves need radii, those without are 0.
std::vector<double> shareSeenBefore(const Centerline2d& centerline, const ImageF& frame, const ImageF& before,
                                    Polarity polarity);

/// What an earlier frame says of a trace.
struct SeenBefore {
    std::vector<int>
        curveIds;   ///< ascending, seen before while most is not; none where vessels may have been filled then
    bool isEverything = false;   ///< no contrast medium comes between the frames
};

SeenBefore seenBefore(const Centerline2d& centerline, const ImageF& frame, const ImageF& before, Polarity polarity);

/// Ids of curves that stand still: in nearly all frames of the run, from first to last, a dark line of like depth lies
/// within 1 px of them. ECG clips, leads, hooks and edges of the shutter do; vessels move, or fill and empty. None in
/// runs of fewer than five frames. `frame` is the one that the curves were traced in.
std::vector<int> stillCurves(const Centerline2d& centerline, const std::vector<ImageF>& frames, int frame,
                             Polarity polarity);

}   // namespace angiopose::core
