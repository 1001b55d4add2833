#include "ui/scenes/label_places.h"

#include <algorithm>
#include <array>
#include <limits>

namespace angiopose::ui {
namespace {

constexpr double edgePx = 4.0;
constexpr double marginPx = 2.0;   // margin to keep free around labels
constexpr double overlapCost = 30.0;   // cost per px² of overlap with other text
constexpr double vesselCost = 40.0;   // cost per covered vessel point
constexpr double gapCost = 3.0;   // cost per px of distance from the anchor
const std::array sides{Eigen::Vector2d(1, 1), Eigen::Vector2d(1, -1), Eigen::Vector2d(-1, 1), Eigen::Vector2d(-1, -1),
                       Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, 1),  Eigen::Vector2d(0, -1)};
constexpr std::array gapFactors{1.0, 2.0, 3.5, 5.5};   // candidate distances from the anchor, in multiples of the gap

ViewRect boxAt(const Eigen::Vector2d& corner, const Eigen::Vector2d& size)
{
    return {corner.x() - marginPx, corner.x() + size.x() + marginPx, corner.y() - marginPx,
            corner.y() + size.y() + marginPx};
}

double overlap(const ViewRect& a, const ViewRect& b)
{
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

bool isIn(const ViewRect& box, const Eigen::Vector2d& point)
{
    return point.x() > box.left && point.x() < box.right && point.y() > box.top && point.y() < box.bottom;
}

Eigen::Vector2d inside(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, const LabelObstacles& obstacles)
{
    const auto within = [](double wanted, double most) {
        return std::clamp(wanted, edgePx, std::max(edgePx, most - edgePx));
    };
    return {within(corner.x(), obstacles.width - size.x()), within(corner.y(), obstacles.height - size.y())};
}

/// Returns the upper left corner of a label placed to one side of its anchor.
Eigen::Vector2d beside(const LabelRequest& label, const Eigen::Vector2d& side, double gapFactor)
{
    const Eigen::Vector2d half = 0.5 * label.size;
    return label.at + side.cwiseProduct(half + Eigen::Vector2d::Constant(gapFactor * label.gapPx)) - half;
}

double costOf(const ViewRect& box, const LabelRequest& label, const LabelObstacles& obstacles,
              const std::vector<ViewRect>& placed)
{
    const Eigen::Vector2d middle(0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom));
    const Eigen::Vector2d half(0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top));
    double cost = gapCost * ((middle - label.at).cwiseAbs() - half).cwiseMax(0.0).norm();
    for (const ViewRect& other : obstacles.occupied) {
        cost += overlapCost * overlap(box, other);
    }
    for (const ViewRect& other : placed) {
        cost += overlapCost * overlap(box, other);
    }
    for (const Eigen::Vector2d& point : obstacles.avoided) {
        cost += isIn(box, point) ? vesselCost : 0.0;
    }
    return cost + (isIn(box, label.at) ? 10.0 * vesselCost : 0.0);
}

}   // namespace

std::vector<Eigen::Vector2d> placeLabels(const std::vector<LabelRequest>& labels, const LabelObstacles& obstacles)
{
    std::vector<Eigen::Vector2d> corners;
    std::vector<ViewRect> placed;
    for (const LabelRequest& label : labels) {
        Eigen::Vector2d best = label.at;
        if (label.size.minCoeff() > 0.0) {
            double least = std::numeric_limits<double>::infinity();
            for (const double gapFactor : gapFactors) {
                for (const Eigen::Vector2d& side : sides) {
                    const Eigen::Vector2d corner = inside(beside(label, side, gapFactor), label.size, obstacles);
                    const double cost = costOf(boxAt(corner, label.size), label, obstacles, placed);
                    if (cost < least) {
                        least = cost;
                        best = corner;
                    }
                }
            }
            placed.push_back(boxAt(best, label.size));
        }
        corners.push_back(best);
    }
    return corners;
}

}   // namespace angiopose::ui
