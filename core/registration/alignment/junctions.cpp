#include "core/registration/alignment/junctions.h"

#include "core/registration/matching/bin_grid.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace angiopose::core {
namespace {

constexpr std::size_t minWays = 3;

template <int Dimension>
class JunctionFinder {
public:
    using Vector = Eigen::Matrix<double, Dimension, 1>;

    JunctionFinder(std::span<const Vector> points, std::span<const int> curveIndex, const JunctionScale& scale)
        : points_(points), curveIndex_(curveIndex), scale_(scale)
    {
        std::vector<Eigen::Vector2d> seen(points.size());
        std::transform(points.begin(), points.end(), seen.begin(),
                       [](const Vector& p) { return p.template head<2>(); });
        near_.fill(seen, scale.maxGap);
    }

    std::vector<Junction<Dimension>> junctions() const
    {
        std::vector<Junction<Dimension>> found;
        for (const Vector& place : places()) {
            Junction<Dimension> junction{place, {}};
            for (const std::size_t nearest : touchedCurves(place)) {
                addDirections(nearest, junction);
            }
            if (junction.directions.size() >= minWays) {
                found.push_back(std::move(junction));
            }
        }
        return found;
    }

private:
    /// Returns, for each curve within the maximum gap of a position, its nearest point, in the order of the curves.
    std::vector<std::size_t> touchedCurves(const Vector& place) const
    {
        std::vector<std::size_t> nearest;
        const auto distance = [&](std::size_t i) { return (points_[i] - place).squaredNorm(); };
        near_.visitNear(place.template head<2>(), [&](std::size_t i) {
            if (distance(i) <= scale_.maxGap * scale_.maxGap) {
                nearest.push_back(i);
            }
        });
        std::sort(nearest.begin(), nearest.end(), [&](std::size_t a, std::size_t b) {
            return std::tuple(curveIndex_[a], distance(a), a) < std::tuple(curveIndex_[b], distance(b), b);
        });
        const auto isSameCurve = [&](std::size_t a, std::size_t b) { return curveIndex_[a] == curveIndex_[b]; };
        nearest.erase(std::unique(nearest.begin(), nearest.end(), isSameCurve), nearest.end());
        return nearest;
    }

    bool isEnd(std::size_t i) const
    {
        return i == 0 || i + 1 == points_.size() || curveIndex_[i - 1] != curveIndex_[i] ||
               curveIndex_[i + 1] != curveIndex_[i];
    }

    /// Returns the curve ends that touch another curve, with coinciding ends merged.
    std::vector<Vector> places() const
    {
        std::vector<Vector> places;
        std::vector<std::uint8_t> isTaken(points_.size(), 0);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!isEnd(i) || isTaken[i] || touchedCurves(points_[i]).size() < 2) {
                continue;
            }
            places.push_back(points_[i]);
            near_.visitNear(points_[i].template head<2>(), [&](std::size_t other) {
                isTaken[other] |= (points_[other] - points_[i]).norm() <= scale_.maxGap;
            });
        }
        return places;
    }

    /// Adds the directions in which the curve leaves the junction, each measured over a fixed length from the curve's
    /// nearest point.
    void addDirections(std::size_t nearest, Junction<Dimension>& junction) const
    {
        const int curve = curveIndex_[nearest];
        for (std::size_t i = nearest; i < points_.size() && curveIndex_[i] == curve; ++i) {
            if (addWay(points_[i], junction)) {
                break;
            }
        }
        for (std::size_t i = nearest + 1; i-- > 0 && curveIndex_[i] == curve;) {
            if (addWay(points_[i], junction)) {
                break;
            }
        }
    }

    bool addWay(const Vector& point, Junction<Dimension>& junction) const
    {
        const Vector way = point - junction.point;
        if (way.norm() < scale_.directionLength) {
            return false;
        }
        junction.directions.push_back(way.normalized());
        return true;
    }

    std::span<const Vector> points_;
    std::span<const int> curveIndex_;
    JunctionScale scale_;
    BinGrid near_;   ///< binned by the first two coordinates
};

}   // namespace

template <int Dimension>
std::vector<Junction<Dimension>> findJunctions(std::span<const Eigen::Matrix<double, Dimension, 1>> points,
                                               std::span<const int> curveIndex, const JunctionScale& scale)
{
    return JunctionFinder<Dimension>(points, curveIndex, scale).junctions();
}

template std::vector<Junction<2>> findJunctions<2>(std::span<const Eigen::Vector2d>, std::span<const int>,
                                                   const JunctionScale&);
template std::vector<Junction<3>> findJunctions<3>(std::span<const Eigen::Vector3d>, std::span<const int>,
                                                   const JunctionScale&);

}   // namespace angiopose::core
