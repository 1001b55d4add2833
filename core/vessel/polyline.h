#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Arc-length functions for ordered points, in 2-D (px) and 3-D (mm).

namespace angiopose::core {

template <int Dim>
using Polyline = std::vector<Eigen::Matrix<double, Dim, 1>>;

/// A position on a polyline, between point `index` and the next point.
struct PolylineStation {
    std::size_t index = 0;
    double fraction = 0.0;   ///< 0 at `index`, 1 at the next point
};

template <int Dim>
double polylineLength(const Polyline<Dim>& points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

/// Returns unit tangents by central differences over ±`reach` points. Where these points coincide, the previous tangent
/// is used (initially the x axis).
template <int Dim>
Polyline<Dim> polylineTangents(const Polyline<Dim>& points, std::size_t reach)
{
    Polyline<Dim> tangents(points.size());
    Eigen::Matrix<double, Dim, 1> last = Eigen::Matrix<double, Dim, 1>::UnitX();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t before = i >= reach ? i - reach : 0;
        const std::size_t after = std::min(points.size() - 1, i + reach);
        const Eigen::Matrix<double, Dim, 1> chord = points[after] - points[before];
        const double length = chord.norm();
        if (length > 1e-12) {
            last = chord / length;
        }
        tangents[i] = last;
    }
    return tangents;
}

/// Returns stations about `spacing` apart in arc length; the spacing is adjusted to make both ends stations. A single
/// point gives one station.
template <int Dim>
std::vector<PolylineStation> evenStations(const Polyline<Dim>& points, double spacing)
{
    if (points.empty()) {
        return {};
    }
    const double length = polylineLength<Dim>(points);
    if (points.size() < 2 || !(length > 0.0)) {
        return {{0, 0.0}};
    }
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(length / spacing)));
    std::vector<PolylineStation> stations;
    stations.reserve(steps + 1);
    stations.push_back({0, 0.0});
    std::size_t segment = 0;
    double segmentLength = (points[1] - points[0]).norm();
    double passed = 0.0;   // arc length at the start of `segment`
    for (std::size_t k = 1; k < steps; ++k) {
        const double wanted = length * static_cast<double>(k) / static_cast<double>(steps);
        while (passed + segmentLength < wanted && segment + 2 < points.size()) {
            passed += segmentLength;
            ++segment;
            segmentLength = (points[segment + 1] - points[segment]).norm();
        }
        const double fraction = segmentLength > 0.0 ? (wanted - passed) / segmentLength : 0.0;
        stations.push_back({segment, std::clamp(fraction, 0.0, 1.0)});
    }
    stations.push_back({points.size() - 2, 1.0});
    return stations;
}

/// Interpolates values given per polyline point (points, radii, …) linearly at the stations.
template <class Value>
std::vector<Value> interpolate(const std::vector<Value>& values, const std::vector<PolylineStation>& stations)
{
    std::vector<Value> result;
    result.reserve(stations.size());
    for (const PolylineStation& station : stations) {
        const Value& from = values[station.index];
        const Value& to = values[std::min(station.index + 1, values.size() - 1)];
        result.push_back((1.0 - station.fraction) * from + station.fraction * to);
    }
    return result;
}

}   // namespace angiopose::core
