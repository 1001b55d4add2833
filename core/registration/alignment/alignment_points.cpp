#include "core/registration/alignment/alignment_points.h"

#include <algorithm>

namespace angiopose::core {
namespace {

AlignmentPoint alignmentPoint(const TreeSamples& tree, std::size_t i)
{
    return {tree.points[i] - tree.centroid, tree.tangents[i], tree.branchIndex[i]};
}

}   // namespace

std::size_t strideFor(std::size_t count, std::size_t maxCount)
{
    return std::max<std::size_t>(1, (count + maxCount - 1) / maxCount);
}

std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, std::size_t stride)
{
    std::vector<AlignmentPoint> points;
    points.reserve(tree.size() / stride + 1);
    for (std::size_t i = stride / 2; i < tree.size(); i += stride) {
        points.push_back(alignmentPoint(tree, i));
    }
    return points;
}

std::vector<AlignmentPoint> informativePoints(const TreeSamples& tree, double mmPerPx, double spacingPx)
{
    const double minMm = spacingPx * mmPerPx;
    std::vector<AlignmentPoint> points;
    points.reserve(tree.size());
    std::size_t last = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (i == 0 || tree.branchIndex[i] != tree.branchIndex[last] ||
            (tree.points[i] - tree.points[last]).squaredNorm() >= minMm * minMm) {
            points.push_back(alignmentPoint(tree, i));
            last = i;
        }
    }
    return points;
}

std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, const std::vector<int>& numbers)
{
    std::vector<AlignmentPoint> points;
    points.reserve(numbers.size());
    for (const int number : numbers) {
        points.push_back(alignmentPoint(tree, static_cast<std::size_t>(number)));
    }
    return points;
}

}   // namespace angiopose::core
