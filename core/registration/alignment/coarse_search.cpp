#include "core/registration/alignment/coarse_search.h"

#include "core/geometry/angle_units.h"
#include "core/registration/alignment/for_each_rotation.h"
#include "core/support/cell_index.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int blockPx = 16;   // spacing of the tested shifts
constexpr int phasePx = 4;   // resolution of the closeness image
constexpr int phases = blockPx / phasePx;
constexpr std::size_t keptPerOrientation = 3;
[[maybe_unused]] constexpr std::size_t maxSearchPoints = 257;   // keeps sums of bytes within 16 bits
constexpr double basinPx = 24.0;
constexpr double basinSteps = 0.75;   // rotational size of a basin, in rotation steps
constexpr double recenterShare = 0.6;   // fraction of the image side; initial poses farther out are recentered first

}   // namespace

/// Scores of all shifts of one orientation; entry (c, r) is a shift by (c − halfColumns, r − halfRows) blocks.
struct CoarseSearch::Shifts {
    int halfColumns;
    int halfRows;
    int columns;
    int rows;
    std::vector<std::uint16_t> sums;

    Shifts(int blocks, const PoseFreedom& freedom)
        : halfColumns(freedom.isLocked(PoseAxis::Right) ? 0 : blocks),
          halfRows(freedom.isLocked(PoseAxis::Up) ? 0 : blocks),
          columns(2 * halfColumns + 1),
          rows(2 * halfRows + 1),
          sums(static_cast<std::size_t>(columns * rows))
    {
    }
};

CoarseSearch::CoarseSearch(const ProjectionCamera& camera, const TargetLines& target, double closenessPx)
    : camera_(camera)
{
    margin_ = 2;
    blockColumns_ = camera.width / blockPx + 1 + 2 * margin_;
    blockRows_ = camera.height / blockPx + 1 + 2 * margin_;
    const auto blocks = cellIndex(blockRows_, blockColumns_, 0);
    closeness_.resize(blocks * phases * phases);
    std::uint8_t* value = closeness_.data();
    for (int phase = 0; phase < phases * phases; ++phase) {
        const int phaseRow = phase / phases;
        const int phaseColumn = phase % phases;
        for (int row = 0; row < blockRows_; ++row) {
            for (int column = 0; column < blockColumns_; ++column) {
                const double u = (column - margin_) * blockPx + phaseColumn * phasePx;
                const double v = (row - margin_) * blockPx + phaseRow * phasePx;
                const double squared = TargetLines::squaredDistance(target.nearest(u, v), u, v);
                *value++ = static_cast<std::uint8_t>(
                    std::lround(255.0 * std::exp(-0.5 * squared / (closenessPx * closenessPx))));
            }
        }
    }
}

void CoarseSearch::addPoint(double u, double v, Shifts& shifts) const
{
    const int column = static_cast<int>(std::lround(u / phasePx)) + (margin_ - shifts.halfColumns) * phases;
    const int row = static_cast<int>(std::lround(v / phasePx)) + (margin_ - shifts.halfRows) * phases;
    // Uses the floor modulo because points may lie far to the left of the image.
    const int phaseColumn = ((column % phases) + phases) % phases;
    const int phaseRow = ((row % phases) + phases) % phases;
    const int firstColumn = (column - phaseColumn) / phases;
    const int firstRow = (row - phaseRow) / phases;
    const std::uint8_t* phase =
        &closeness_[cellIndex(phaseRow, phases, phaseColumn) * cellIndex(blockRows_, blockColumns_, 0)];

    const int from = std::clamp(-firstColumn, 0, shifts.columns);
    const int to = std::clamp(blockColumns_ - firstColumn, from, shifts.columns);
    for (int r = std::max(0, -firstRow); r < std::min(shifts.rows, blockRows_ - firstRow); ++r) {
        const std::uint8_t* source = phase + static_cast<std::ptrdiff_t>(firstRow + r) * blockColumns_ + firstColumn;
        std::uint16_t* sum = &shifts.sums[cellIndex(r, shifts.columns, 0)];
        for (int c = from; c < to; ++c) {
            sum[c] = static_cast<std::uint16_t>(sum[c] + source[c]);
        }
    }
}

void CoarseSearch::scoreOrientation(std::span<const AlignmentPoint> points, const CentroidPose& pose,
                                    Shifts& shifts) const
{
    std::fill(shifts.sums.begin(), shifts.sums.end(), std::uint16_t{0});
    for (const AlignmentPoint& point : points) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (pixel && pixel->cwiseAbs().maxCoeff() < 1e6) {
            addPoint(pixel->x(), pixel->y(), shifts);
        }
    }
}

void CoarseSearch::keepBest(const CentroidPose& pose, std::size_t pointCount, const Shifts& shifts,
                            std::vector<CoarseCandidate>& candidates) const
{
    std::array<std::size_t, keptPerOrientation> best{};
    std::array<int, keptPerOrientation> sums;
    sums.fill(-1);
    for (std::size_t k = 0; k < shifts.sums.size(); ++k) {
        for (std::size_t rank = 0; rank < keptPerOrientation; ++rank) {
            if (shifts.sums[k] > sums[rank]) {
                std::move_backward(best.begin() + rank, best.end() - 1, best.end());
                std::move_backward(sums.begin() + rank, sums.end() - 1, sums.end());
                best[rank] = k;
                sums[rank] = shifts.sums[k];
                break;
            }
        }
    }
    const double depthMm = pose.centroidInCamera.z();
    for (std::size_t rank = 0; rank < keptPerOrientation && sums[rank] >= 0; ++rank) {
        const int column = static_cast<int>(best[rank]) % shifts.columns - shifts.halfColumns;
        const int row = static_cast<int>(best[rank]) / shifts.columns - shifts.halfRows;
        CoarseCandidate candidate{pose, sums[rank] / (255.0 * static_cast<double>(pointCount))};
        candidate.pose.centroidInCamera.x() += column * blockPx * depthMm / camera_.fx;
        candidate.pose.centroidInCamera.y() += row * blockPx * depthMm / camera_.fy;
        candidates.push_back(candidate);
    }
}

std::vector<CoarseCandidate> CoarseSearch::find(std::span<const AlignmentPoint> points, const CentroidPose& start,
                                                const SearchRange& range,
                                                const std::function<ObserverDecision(double)>& observe) const
{
    assert(points.size() <= maxSearchPoints);
    const double depthMm = std::max(minProjectableDepthMm, start.centroidInCamera.z());
    const double pxPerMm = 1.0 / millimetersPerPixel(camera_, depthMm);
    const double radiusPx = std::min(range.radiusMm * pxPerMm, recenterShare * std::max(camera_.width, camera_.height));
    Shifts shifts(static_cast<int>(std::ceil(radiusPx / blockPx)), range.freedom);
    std::vector<CoarseCandidate> candidates;
    forEachRotation(
        start, range,
        [&](const CentroidPose& pose) {
            scoreOrientation(points, pose, shifts);
            keepBest(pose, points.size(), shifts, candidates);
        },
        observe);
    return distinctCandidates(std::move(candidates),
                              {basinPx / pxPerMm, basinSteps * range.stepDeg * radiansPerDegree});
}

}   // namespace angiopose::core
