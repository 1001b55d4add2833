#pragma once

#include "core/case/view.h"
#include "core/support/result.h"
#include "core/support/verdict.h"
#include "core/viewing/part_sight.h"

#include <functional>
#include <vector>

namespace angiopose::core {

/// Positioner angles in degrees: LAO and CRA positive.
struct GantryAngles {
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
};

/// Angles from `fromDeg` up to `toDeg`.
struct AngleRange {
    double fromDeg = 0.0;
    double toDeg = 0.0;
};

/// Which angles the gantry reaches, and how finely they are looked at.
struct AngleMapOptions {
    AngleRange primary{-90.0, 90.0};
    AngleRange secondary{-40.0, 40.0};
    double stepDeg = 2.5;
    int threads = 0;   ///< 0: all of the processor
};

/// Angles that may be chosen.
struct AngleSuggestion {
    GantryAngles angles;
    SightQuality quality;
};

/// How a part of the vessels is seen from all angles.
struct AngleMap {
    std::vector<double> primaryDeg;   ///< of the columns, ascending
    std::vector<double> secondaryDeg;   ///< of the rows, ascending
    std::vector<SightQuality> qualities;   ///< row by row
    std::vector<AngleSuggestion> best;   ///< at least 20° from each other, best first, at most three

    const SightQuality& at(std::size_t column, std::size_t row) const
    {
        return qualities[row * primaryDeg.size() + column];
    }
};

/// The pose of the vessels with the gantry at other angles.
using PoseAtAngles = std::function<RigidTransform(const GantryAngles&)>;

/// Looks at the part from a grid of angles, then finds the best angles to a tenth of a degree. `observe` hears of
/// progress, 0…1, and may stop it. Fails for ranges that are empty, not finite or beyond ±180° and ±90°, and for steps
/// below half a degree.
Result<AngleMap> mapAngles(const PartSight& sight, const PoseAtAngles& poseAt, const AngleMapOptions& options = {},
                           const std::function<Verdict(double)>& observe = {});

/// The angles of a view's gantry when its frame was taken; nothing where they are not known.
std::optional<GantryAngles> gantryAnglesOf(const View& view);

/// The vessels at their pose in the view, with the gantry turned to other angles about its isocentre. Fails where the
/// view lacks angles or the distance from source to isocentre.
Result<PoseAtAngles> turningGantry(const View& view);

}   // namespace angiopose::core
