#pragma once

#include "core/case/view.h"
#include "core/support/observer_decision.h"
#include "core/support/result.h"
#include "core/viewing/view_evaluator.h"

#include <functional>
#include <vector>

namespace angiopose::core {

/// Positioner angles in degrees; LAO and CRA are positive.
struct GantryAngles {
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
};

/// Range of an angle, both limits included.
struct AngleRange {
    double fromDeg = 0.0;
    double toDeg = 0.0;
};

/// Angle ranges of the gantry and grid step.
struct AngleMapOptions {
    AngleRange primary{-90.0, 90.0};
    AngleRange secondary{-40.0, 40.0};
    double stepDeg = 2.5;
    int threads = 0;   ///< 0 for all processors
};

/// Suggested gantry angles and the resulting view quality.
struct AngleSuggestion {
    GantryAngles angles;
    ViewQuality quality;
};

/// View quality of a part of the vessels at all gantry angles.
struct AngleMap {
    std::vector<double> primaryDeg;   ///< angles of the columns, ascending
    std::vector<double> secondaryDeg;   ///< angles of the rows, ascending
    std::vector<ViewQuality> qualities;   ///< one per grid point, row by row
    std::vector<AngleSuggestion> best;   ///< at most three suggestions, at least 20° apart, best first

    const ViewQuality& at(std::size_t column, std::size_t row) const
    {
        return qualities[row * primaryDeg.size() + column];
    }
};

/// Returns the pose of the vessels for other gantry angles.
using PoseAtAngles = std::function<RigidTransform(const GantryAngles&)>;

/// Evaluates the view of the part on a grid of angles, then refines the best angles to a tenth of a degree. `observe`
/// receives the progress, 0…1, and can cancel. Fails if a range is empty, not finite, or beyond ±180° (primary) or ±90°
/// (secondary), or if the step is below half a degree.
Result<AngleMap> computeAngleMap(const ViewEvaluator& evaluator, const PoseAtAngles& poseAt,
                                 const AngleMapOptions& options = {},
                                 const std::function<ObserverDecision(double)>& observe = {});

/// Returns the gantry angles of a view at its current frame; nullopt if they are unknown.
std::optional<GantryAngles> gantryAnglesOf(const View& view);

/// Returns a function that gives the pose of the vessels in the view at given gantry angles, with rotation about the
/// isocenter. Fails if the view lacks angles or the source-to-isocenter distance.
Result<PoseAtAngles> poseForGantryAngles(const View& view);

}   // namespace angiopose::core
