#include "core/registration/alignment/junctions.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t leastWays = 3;

template <int Dimension>
class Meetings {
public:
    using Vector = Eigen::Matrix<double, Dimension, 1>;

    Meetings(std::span<const Vector> points, std::span<const int> curveIndex, const JunctionScale& scale)
        : points_(points), curveIndex_(curveIndex), scale_(scale)
    {
        for (std::size_t from = 0; from < points.size();) {
            std::size_t to = from + 1;
            while (to < points.size() && curveIndex[to] == curveIndex[from]) {
                ++to;
            }
            curves_.push_back({from, to});
            from = to;
        }
    }

    std::vector<Junction<Dimension>> junctions() const
    {
        std::vector<Junction<Dimension>> found;
        for (const Vector& place : places()) {
            Junction<Dimension> junction{place, {}};
            for (const Curve& curve : curves_) {
                addWays(curve, junction);
            }
            if (junction.directions.size() >= leastWays) {
                found.push_back(std::move(junction));
            }
        }
        return found;
    }

private:
    struct Curve {
        std::size_t from, to;
    };

    std::size_t nearestOf(const Curve& curve, const Vector& place) const
    {
        std::size_t nearest = curve.from;
        for (std::size_t i = curve.from; i < curve.to; ++i) {
            if ((points_[i] - place).squaredNorm() < (points_[nearest] - place).squaredNorm()) {
                nearest = i;
            }
        }
        return nearest;
    }

    bool touchesOther(const Curve& own, const Vector& end) const
    {
        for (const Curve& curve : curves_) {
            if (curve.from != own.from && (points_[nearestOf(curve, end)] - end).norm() <= scale_.touching) {
                return true;
            }
        }
        return false;
    }

    /// Ends that touch something, one for all that lie together.
    std::vector<Vector> places() const
    {
        std::vector<Vector> places;
        for (const Curve& curve : curves_) {
            for (const std::size_t i : {curve.from, curve.to - 1}) {
                const bool isKnown = std::any_of(places.begin(), places.end(), [&](const Vector& place) {
                    return (place - points_[i]).norm() <= scale_.touching;
                });
                if (!isKnown && touchesOther(curve, points_[i])) {
                    places.push_back(points_[i]);
                }
            }
        }
        return places;
    }

    /// Where the curve, walked from its point nearest to the junction, has gone the length of `leaving`.
    void addWays(const Curve& curve, Junction<Dimension>& junction) const
    {
        const std::size_t nearest = nearestOf(curve, junction.point);
        if ((points_[nearest] - junction.point).norm() > scale_.touching) {
            return;
        }
        for (std::size_t i = nearest; i < curve.to; ++i) {
            if (addWay(points_[i], junction)) {
                break;
            }
        }
        for (std::size_t i = nearest + 1; i-- > curve.from;) {
            if (addWay(points_[i], junction)) {
                break;
            }
        }
    }

    bool addWay(const Vector& point, Junction<Dimension>& junction) const
    {
        const Vector way = point - junction.point;
        if (way.norm() < scale_.leaving) {
            return false;
        }
        junction.directions.push_back(way.normalized());
        return true;
    }

    std::span<const Vector> points_;
    std::span<const int> curveIndex_;
    JunctionScale scale_;
    std::vector<Curve> curves_;
};

}   // namespace

template <int Dimension>
std::vector<Junction<Dimension>> junctionsOf(std::span<const Eigen::Matrix<double, Dimension, 1>> points,
                                             std::span<const int> curveIndex, const JunctionScale& scale)
{
    return Meetings<Dimension>(points, curveIndex, scale).junctions();
}

template std::vector<Junction<2>> junctionsOf<2>(std::span<const Eigen::Vector2d>, std::span<const int>,
                                                 const JunctionScale&);
template std::vector<Junction<3>> junctionsOf<3>(std::span<const Eigen::Vector3d>, std::span<const int>,
                                                 const JunctionScale&);

}   // namespace angiopose::core