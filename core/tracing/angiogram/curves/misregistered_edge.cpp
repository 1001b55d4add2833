#include "core/tracing/angiogram/curves/misregistered_edge.h"

#include "core/imaging/image_filters.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t minEdgePoints = 10;   // shorter paths are dominated by noise
constexpr double minSideOffsetPx = 2.0;
constexpr double maxSideOffsetPx = 4.0;   // patients may move farther, but the two sides then appear as separate lines
constexpr std::size_t edgeTangentReach = 4;

/// Returns the unit normals, which point to the right of the path.
std::vector<Eigen::Vector2d> normalsAlong(const std::vector<Eigen::Vector2d>& path)
{
    std::vector<Eigen::Vector2d> normals(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector2d chord = path[std::min(path.size() - 1, i + edgeTangentReach)] -
                                      path[i < edgeTangentReach ? 0 : i - edgeTangentReach];
        normals[i] = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
    }
    return normals;
}

}   // namespace

bool isMisregisteredEdge(const std::vector<Eigen::Vector2d>& pathPx, const ImageF& opacity)
{
    if (pathPx.size() < minEdgePoints) {
        return false;
    }
    const std::vector<Eigen::Vector2d> normals = normalsAlong(pathPx);
    const auto meanAt = [&](double offsetPx) {
        double sum = 0.0;
        for (std::size_t i = 0; i < pathPx.size(); ++i) {
            const Eigen::Vector2d point = pathPx[i] + offsetPx * normals[i];
            sum += sampleBilinear(opacity, point.x(), point.y());
        }
        return sum / static_cast<double>(pathPx.size());
    };
    const double dark = meanAt(0.0);
    for (double offsetPx = minSideOffsetPx; offsetPx <= maxSideOffsetPx; offsetPx += 1.0) {
        if (std::min(meanAt(offsetPx), meanAt(-offsetPx)) < -dark) {
            return true;
        }
    }
    return false;
}

}   // namespace angiopose::core
