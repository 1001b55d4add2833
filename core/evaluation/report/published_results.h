#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::core {

// Values printed in the paper (DynaWeightPnP, Song and Ghaffari), with corrected labels (ALGORITHMS §2, decisions 5–7
// and §4). NaN marks values that are missing or unusable in the paper.

struct PublishedErrors {
    double grossPercent, meanMm, p75Mm, p95Mm, timeMs;
};
std::optional<PublishedErrors> publishedSimulation(std::string_view methodId);

struct PublishedInVivo {
    double grossPercent, medianMm, p75Mm, p95Mm, timeMs;
};
std::optional<PublishedInVivo> publishedInVivo(std::string_view methodId);

/// Means over the trees P1–P6.
struct PublishedRobustness {
    double closestMedianPx, angleDeg, seedDistanceMm;
};
std::optional<PublishedRobustness> publishedRobustness(std::string_view conditionId, std::string_view methodId);

struct PublishedToy {
    double closestPx, angleDeg, seedDistance;
};
std::optional<PublishedToy> publishedToy(int points, std::string_view methodId);

}   // namespace angiopose::core
