#include "core/registration/deformable/curve_crossings.h"

#include "core/support/cell_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace angiopose::core {
namespace {

constexpr double crossingCellPx = 12.0;
constexpr double sameCrossingPx = 2.0;   // crossings of one curve closer than this count as one

/// Fits a least-squares parabola (Savitzky and Golay 1964) over seven points, five or three near the ends: removes the
/// pixel staircase and preserves the curvature.
Eigen::Vector2d smoothedPoint(const std::vector<Eigen::Vector2d>& points, std::size_t first, std::size_t last,
                              std::size_t at)
{
    const std::size_t reach = std::min({at - first, last - at, std::size_t{3}});
    if (reach < 2) {
        return points[at];
    }
    static constexpr std::array<double, 3> five{17.0 / 35.0, 12.0 / 35.0, -3.0 / 35.0};
    static constexpr std::array<double, 4> seven{7.0 / 21.0, 6.0 / 21.0, 3.0 / 21.0, -2.0 / 21.0};
    const double* weights = reach == 2 ? five.data() : seven.data();
    Eigen::Vector2d sum = weights[0] * points[at];
    for (std::size_t k = 1; k <= reach; ++k) {
        sum += weights[k] * (points[at - k] + points[at + k]);
    }
    return sum;
}

int cellsAcross(int pixels)
{
    return static_cast<int>(static_cast<double>(std::max(1, pixels)) / crossingCellPx) + 1;
}

int cellAt(double px, int cells)
{
    return std::clamp(static_cast<int>(std::floor(px / crossingCellPx)), 0, cells - 1);
}

}   // namespace

CurveCrossings::CurveCrossings(const TargetSamples& target, const ProjectionCamera& camera)
{
    const std::size_t count = target.size();
    std::size_t first = 0;
    while (first < count) {
        std::size_t end = first;
        while (end < count && target.curveIndex[end] == target.curveIndex[first]) {
            ++end;
        }
        for (std::size_t k = first; k + 1 < end; ++k) {
            const Eigen::Vector2d from = smoothedPoint(target.points, first, end - 1, k);
            const Eigen::Vector2d to = smoothedPoint(target.points, first, end - 1, k + 1);
            const Eigen::Vector2d direction = target.tangents[k] + target.tangents[k + 1];
            pieces_.push_back({from, to - from, direction.normalized(), target.curveIndex[k]});
        }
        first = end;
    }
    sortIntoCells(camera);
}

void CurveCrossings::sortIntoCells(const ProjectionCamera& camera)
{
    columns_ = cellsAcross(camera.width);
    rows_ = cellsAcross(camera.height);
    const auto cellOf = [&](const Piece& piece) {
        const Eigen::Vector2d middle = piece.from + 0.5 * piece.along;
        return cellIndex(cellAt(middle.y(), rows_), columns_, cellAt(middle.x(), columns_));
    };
    std::ranges::stable_sort(pieces_, {}, cellOf);
    starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Piece& piece : pieces_) {
        ++starts_[cellOf(piece) + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
}

void CurveCrossings::addCrossing(const Piece& piece, const CrossingQuery& query, double minCosine,
                                 std::vector<CurveCrossing>& crossings) const
{
    // Solves place + s normal = from + f along.
    const Eigen::Vector2d apart = piece.from - query.positionPx;
    const double across = query.normal.x() * piece.along.y() - query.normal.y() * piece.along.x();
    if (std::abs(across) < 1e-9) {
        return;
    }
    const double fraction = (query.normal.y() * apart.x() - query.normal.x() * apart.y()) / across;
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
        return;
    }
    const double offset = (apart + fraction * piece.along).dot(query.normal);
    const double cosine = std::abs(query.normal.x() * piece.direction.y() - query.normal.y() * piece.direction.x());
    if (std::abs(offset) > query.reachPx || cosine < minCosine) {
        return;
    }
    for (CurveCrossing& known : crossings) {
        if (known.curve == piece.curve && std::abs(known.offsetPx - offset) < sameCrossingPx) {
            return;
        }
    }
    crossings.push_back({offset, std::acos(std::min(1.0, cosine)), piece.curve});
}

void CurveCrossings::find(const CrossingQuery& query, double maxAngle, std::size_t maxCount,
                          std::vector<CurveCrossing>& crossings) const
{
    crossings.clear();
    const double minCosine = std::cos(maxAngle);
    // Bands of cells along the longer axis of the line; no piece extends more than one cell beyond its first cell.
    const bool isSteep = std::abs(query.normal.y()) > std::abs(query.normal.x());
    const int bands = isSteep ? rows_ : columns_;
    const int lanes = isSteep ? columns_ : rows_;
    const auto along = [&](const Eigen::Vector2d& p) { return isSteep ? p.y() : p.x(); };
    const auto aside = [&](const Eigen::Vector2d& p) { return isSteep ? p.x() : p.y(); };
    const double reach = query.reachPx * std::abs(along(query.normal)) + 2.0;
    const double slope = aside(query.normal) / along(query.normal);
    const int fromBand = cellAt(along(query.positionPx) - reach, bands);
    const int toBand = cellAt(along(query.positionPx) + reach, bands);
    for (int band = fromBand; band <= toBand; ++band) {
        const double begin = aside(query.positionPx) + slope * (crossingCellPx * band - along(query.positionPx));
        const auto [low, high] = std::minmax({begin, begin + slope * crossingCellPx});
        const int fromLane = cellAt(low - 2.0, lanes);
        const int toLane = cellAt(high + 2.0, lanes);
        for (int lane = fromLane; lane <= toLane; ++lane) {
            const std::size_t cell = isSteep ? cellIndex(band, columns_, lane) : cellIndex(lane, columns_, band);
            for (std::int32_t k = starts_[cell]; k < starts_[cell + 1]; ++k) {
                addCrossing(pieces_[static_cast<std::size_t>(k)], query, minCosine, crossings);
            }
        }
    }
    std::ranges::stable_sort(crossings, {}, [](const CurveCrossing& c) { return std::abs(c.offsetPx); });
    if (crossings.size() > maxCount) {
        crossings.resize(maxCount);
    }
}

}   // namespace angiopose::core
