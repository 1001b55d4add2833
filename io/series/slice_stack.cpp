#include "io/series/slice_stack.h"

#include "io/messages/messages.h"
#include "io/support/numbers.h"
#include "io/volume/volume_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::io {
namespace {

constexpr std::size_t maxGapsNamed = 3;
constexpr double slantToleranceMm = 0.05;   // offsets below this are rounding errors of the header
constexpr double gridTolerance = 0.1;   // deviations below this fraction of the spacing are rounding errors
constexpr double wholeStepTolerance =
    0.2;   // fraction of the spacing: slices are missing if a gap is this close to a multiple of the spacing

double rounded(double length)
{
    return std::round(length * 100.0) / 100.0;
}

core::Quantity roundedMm(double length)
{
    return {rounded(length), core::Quantity::significantDigits, "mm"};
}

std::vector<double> gapsOf(const std::vector<double>& places)
{
    std::vector<double> gaps;
    for (std::size_t i = 1; i < places.size(); ++i) {
        gaps.push_back(places[i] - places[i - 1]);
    }
    return gaps;
}

double quantileOf(std::vector<double> values, double fraction)
{
    const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// Returns the slice spacing if the slices lie on a regular grid, gaps allowed; 0 otherwise.
double gridStep(const std::vector<double>& places)
{
    const std::vector<double> distances = gapsOf(places);
    const double usual = quantileOf(distances, 0.5);
    double steps = 0.0;
    for (const double gap : distances) {
        const double count = std::round(gap / usual);
        if (count < 1.0 || std::abs(gap - count * usual) > wholeStepTolerance * usual) {
            return 0.0;
        }
        steps += count;
    }
    const double step = (places.back() - places.front()) / steps;
    const bool isRegular = std::all_of(places.begin(), places.end(), [&](double place) {
        const double at = (place - places.front()) / step;
        return std::abs(at - std::round(at)) <= gridTolerance;
    });
    return isRegular ? step : 0.0;
}

/// Returns the slices on either side of each layer; the layers have the spacing `step` and start at the first slice.
std::vector<StackLayer> layersOf(const std::vector<double>& places, double step)
{
    std::vector<StackLayer> layers;
    const auto count = static_cast<std::size_t>(std::lround((places.back() - places.front()) / step)) + 1;
    std::size_t lower = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double at = places.front() + static_cast<double>(k) * step;
        while (lower + 1 < places.size() && places[lower + 1] <= at + gridTolerance * step) {
            ++lower;
        }
        const std::size_t upper = std::min(lower + 1, places.size() - 1);
        StackLayer layer{lower, upper, 0.0};
        if (at - places[lower] > gridTolerance * step && upper != lower) {
            layer.upperWeight = (at - places[lower]) / (places[upper] - places[lower]);
        }
        layers.push_back(layer);
    }
    return layers;
}

/// Describes where slices are missing, for example "after slice 41".
core::Message gaps(const std::vector<double>& places, double step)
{
    std::vector<std::string> before;
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i] - places[i - 1] > 1.5 * step) {
            before.push_back(std::to_string(i));
        }
    }
    if (before.size() <= maxGapsNamed) {
        return messages::afterSlices(before);
    }
    before.resize(maxGapsNamed);
    return messages::afterSlicesAndElsewhere(before);
}

core::Message missingSlices(const std::vector<double>& places, double step, std::size_t layers)
{
    const std::size_t missing = layers - places.size();
    return missing == 1 ? messages::seriesSliceMissing(layers, gaps(places, step))
                        : messages::seriesSlicesMissing(missing, layers, gaps(places, step));
}

void placeLayers(const std::vector<double>& places, SliceStack& stack, double& step)
{
    const std::vector<double> distances = gapsOf(places);
    const double regular = gridStep(places);
    step = regular > 0.0 ? regular : quantileOf(distances, 0.25);
    const double layers = (places.back() - places.front()) / step;
    if (layers > 4.0 * static_cast<double>(places.size()) + 16.0) {
        stack.problem = messages::seriesTooUneven(places.size(), core::inMm(places.back() - places.front(), 0));
        return;
    }
    stack.layers = layersOf(places, step);
    if (regular > 0.0 && stack.layers.size() > places.size()) {
        stack.warnings.push_back(missingSlices(places, step, stack.layers.size()));
    } else if (regular == 0.0) {
        const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
        stack.warnings.push_back(messages::seriesUnevenSlices(
            core::Quantity{rounded(*least), core::Quantity::significantDigits}, roundedMm(*most), roundedMm(step)));
    }
}

/// Returns the in-plane offset of the first pixel of each slice relative to that of the first slice, mm.
std::vector<Eigen::Vector2d> inPlaneOffsets(const std::vector<SliceRecord>& slices)
{
    std::vector<Eigen::Vector2d> offsets;
    offsets.reserve(slices.size());
    for (const SliceRecord& slice : slices) {
        offsets.emplace_back(slices.front().axes->transpose() * (*slice.position - *slices.front().position));
    }
    return offsets;
}

/// Enlarges the layers so that every slice fits at its true in-plane position.
Eigen::Vector2i straighten(const std::vector<SliceRecord>& slices, double extentMm, SliceStack& stack,
                           Eigen::Vector3d& origin)
{
    const SliceRecord& first = slices.front();
    const std::vector<Eigen::Vector2d> offsets = inPlaneOffsets(slices);
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& offset : offsets) {
        low = low.cwiseMin(offset);
        high = high.cwiseMax(offset);
    }
    if ((high - low).maxCoeff() < slantToleranceMm) {
        stack.shiftVoxels.assign(slices.size(), Eigen::Vector2d::Zero());
        return first.size;
    }
    for (const Eigen::Vector2d& offset : offsets) {
        stack.shiftVoxels.emplace_back((offset - low).cwiseQuotient(first.spacingMm));
    }
    origin += *first.axes * low;
    const double slantDeg = std::atan2((high - low).norm(), extentMm) * 180.0 / std::numbers::pi;
    stack.warnings.push_back(messages::seriesSlanted(
        core::Quantity{std::round(slantDeg * 10.0) / 10.0, core::Quantity::significantDigits, "°"}));
    return first.size + (high - low).cwiseQuotient(first.spacingMm).array().ceil().matrix().cast<int>();
}

}   // namespace

Eigen::Vector3d normalOf(const SliceRecord& slice)
{
    return slice.axes->col(0).cross(slice.axes->col(1));
}

SliceStack planStack(const std::vector<SliceRecord>& slices)
{
    SliceStack stack;
    if (slices.size() < 2) {
        stack.problem = messages::seriesSingleSlice();
        return stack;
    }
    std::vector<double> places;
    places.reserve(slices.size());
    const Eigen::Vector3d normal = normalOf(slices.front());
    for (const SliceRecord& slice : slices) {
        places.push_back(normal.dot(*slice.position));
    }
    double step = 0.0;
    placeLayers(places, stack, step);
    if (stack.problem) {
        return stack;
    }
    const SliceRecord& first = slices.front();
    Eigen::Vector3d origin = *first.position;
    const Eigen::Vector2i plane = straighten(slices, places.back() - places.front(), stack, origin);
    if ((plane.array() > 3 * first.size.array()).any()) {
        stack.problem = messages::seriesBesideEachOther();
        return stack;
    }
    Eigen::Matrix3d steps;
    steps << first.axes->col(0) * first.spacingMm.x(), first.axes->col(1) * first.spacingMm.y(), normal * step;
    const AxesResult axes =
        geometryFromSteps({plane.x(), plane.y(), static_cast<int>(stack.layers.size())}, steps, origin);
    stack.geometry = axes.geometry;
    stack.problem = axes.problem;
    return stack;
}

}   // namespace angiopose::io
