#include "core/measuring/reference_line.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace angiopose::core {
namespace {

constexpr std::size_t leastDiameters = 6;
constexpr double leastShareThatAgrees = 0.25;
constexpr std::array sharesBelow{0.3, 0.2, 0.15, 0.1, 0.1, 0.1, 0.1};   // above: twice as much

DiameterLine lineThrough(const std::vector<Eigen::Vector2d>& diameters)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& each : diameters) {
        mean += each / static_cast<double>(diameters.size());
    }
    double along = 0.0;
    double together = 0.0;
    for (const Eigen::Vector2d& each : diameters) {
        along += (each.x() - mean.x()) * (each.x() - mean.x());
        together += (each.x() - mean.x()) * (each.y() - mean.y());
    }
    const double slope = along > 0.0 ? together / along : 0.0;
    return {mean.y() - slope * mean.x(), slope};
}

}   // namespace

std::optional<DiameterLine> referenceLine(const std::vector<Eigen::Vector2d>& diameters)
{
    if (diameters.size() < leastDiameters) {
        return std::nullopt;
    }
    DiameterLine line = lineThrough(diameters);
    for (const double shareBelow : sharesBelow) {
        std::vector<Eigen::Vector2d> healthy;
        for (const Eigen::Vector2d& each : diameters) {
            const double expected = line.at(each.x());
            if (each.y() > (1.0 - shareBelow) * expected && each.y() < (1.0 + 2.0 * shareBelow) * expected) {
                healthy.push_back(each);
            }
        }
        if (static_cast<double>(healthy.size()) < leastShareThatAgrees * static_cast<double>(diameters.size())) {
            return std::nullopt;
        }
        line = lineThrough(healthy);
    }
    return line;
}

}   // namespace angiopose::core
