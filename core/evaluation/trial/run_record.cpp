#include "core/evaluation/trial/run_record.h"

#include <array>

namespace angiopose::core {

std::span<const RunField> runFields()
{
    using R = RunRecord;
    static constexpr std::array fields{
        RunField{"start_mean_px", &R::startMeanPx},
        RunField{"start_mtre_mm", &R::startMtreMm},
        RunField{"start_angle_deg", &R::startAngleDeg},
        RunField{"has_result", &R::hasResult},
        RunField{"trustworthy", &R::trustworthy},
        RunField{"iterations", &R::iterations},
        RunField{"closest_median_px", &R::closestMedianPx},
        RunField{"closest_mean_px", &R::closestMeanPx},
        RunField{"reverse_mean_px", &R::reverseMeanPx},
        RunField{"coverage", &R::coverage},
        RunField{"mean_px", &R::meanPx},
        RunField{"rms_px", &R::rmsPx},
        RunField{"median_px", &R::medianPx},
        RunField{"p75_px", &R::p75Px},
        RunField{"p95_px", &R::p95Px},
        RunField{"mean_mm", &R::meanMm},
        RunField{"share_above_5_px", &R::shareAbove5Px},
        RunField{"mtre_mm", &R::mtreMm},
        RunField{"mtre_in_plane_mm", &R::mtreInPlaneMm},
        RunField{"mrpd_mm", &R::mrpdMm},
        RunField{"angle_deg", &R::angleDeg},
        RunField{"out_of_plane_deg", &R::outOfPlaneDeg},
        RunField{"in_plane_deg", &R::inPlaneDeg},
        RunField{"seed_distance_mm", &R::seedDistanceMm},
        RunField{"centroid_in_plane_mm", &R::centroidInPlaneMm},
        RunField{"centroid_depth_mm", &R::centroidDepthMm},
        RunField{"nees", &R::nees},
        RunField{"bound_rms_px", &R::boundRmsPx},
        RunField{"trace_ms", &R::traceMs, true},
        RunField{"target_ms", &R::targetMs, true},
        RunField{"search_ms", &R::searchMs, true},
        RunField{"solve_ms", &R::solveMs, true},
        RunField{"total_ms", &R::totalMs, true},
        RunField{"processor_ms", &R::processorMs, true},
    };
    return fields;
}

}   // namespace angiopose::core