#include "io/series/split_phases.h"

#include "io/messages/messages.h"
#include "io/series/slice_stack.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace angiopose::io {
namespace {

constexpr double samePlaceMm = 0.01;

std::size_t placeCount(const Slices& sorted)
{
    std::size_t count = sorted.empty() ? 0 : 1;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        count += isSamePosition(sorted[i - 1], sorted[i]) ? 0 : 1;
    }
    return count;
}

/// Splits slices by one key. Empty if a resulting volume would have several slices at the same position.
std::vector<Slices> splitByKey(const Slices& slices, std::size_t key)
{
    std::map<std::string, Slices> parts;
    for (const SliceRecord& slice : slices) {
        parts[slice.phaseKeys[key]].push_back(slice);
    }
    std::vector<Slices> result;
    for (auto& [value, part] : parts) {
        if (placeCount(part) != part.size()) {
            return {};
        }
        result.push_back(std::move(part));
    }
    return result;
}

/// Splits slices whose positions were all recorded equally often: the first recording of each position, the second, …
std::vector<Slices> splitByRecordingOrder(const Slices& sorted, std::size_t places)
{
    const std::size_t count = sorted.size() / places;
    std::vector<Slices> parts(count);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool isComplete = i % count == 0 || isSamePosition(sorted[i - 1], sorted[i]);
        if (!isComplete) {
            return {};
        }
        parts[i % count].push_back(sorted[i]);
    }
    return parts;
}

/// Returns how many slices are missing from the regular grid of these slices; nullopt if they do not lie on a grid.
std::optional<std::size_t> missingOnGrid(const Slices& sorted)
{
    const SliceStack stack = planStack(sorted);
    const bool isUneven = std::ranges::any_of(
        stack.warnings, [](const core::Message& warning) { return warning.is(messages::seriesUnevenSlices); });
    return stack.problem || isUneven ? std::nullopt : std::optional(stack.layers.size() - sorted.size());
}

/// Splits slices by acquisition if each acquisition lies on a regular grid of its own and together they form no volume,
/// because they are far apart or interleaved. If only a few slices are missing between them, they count as one volume.
std::vector<Slices> splitAcquisitions(const Slices& sorted)
{
    constexpr std::size_t minSlices = 3, missingOf = 8;
    std::vector<Slices> parts = splitByKey(sorted, 0);
    if (parts.size() < 2 || !std::ranges::all_of(parts, [](const Slices& part) {
            return part.size() >= minSlices && missingOnGrid(part) == std::size_t{0};
        })) {
        return {};
    }
    std::size_t changes = 1;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        changes += sorted[i].phaseKeys[0] == sorted[i - 1].phaseKeys[0] ? 0 : 1;
    }
    const auto missing = missingOnGrid(sorted);
    const bool isVolume = changes == parts.size() && missing && missingOf * *missing <= sorted.size();
    return isVolume ? std::vector<Slices>{} : parts;
}

}   // namespace

bool isSamePosition(const SliceRecord& a, const SliceRecord& b)
{
    return std::abs(normalOf(a).dot(*a.position - *b.position)) < samePlaceMm;
}

void sortAlongNormal(Slices& slices)
{
    const Eigen::Vector3d normal = normalOf(slices.front());
    const auto place = [&](const SliceRecord& slice) {
        return std::llround(normal.dot(*slice.position) / samePlaceMm);
    };
    std::sort(slices.begin(), slices.end(), [&](const SliceRecord& a, const SliceRecord& b) {
        return std::tuple(place(a), a.instanceNumber, a.path, a.frame) <
               std::tuple(place(b), b.instanceNumber, b.path, b.frame);
    });
}

std::vector<Slices> splitVolumes(const Slices& sorted)
{
    const std::size_t places = placeCount(sorted);
    if (places == sorted.size()) {
        auto acquisitions = splitAcquisitions(sorted);
        return acquisitions.empty() ? std::vector<Slices>{sorted} : acquisitions;
    }
    for (std::size_t key = 0; key < phaseKeyCount; ++key) {
        if (auto parts = splitByKey(sorted, key); parts.size() > 1) {
            return parts;
        }
    }
    if (places > 1 && sorted.size() % places == 0) {
        if (auto parts = splitByRecordingOrder(sorted, places); !parts.empty()) {
            return parts;
        }
    }
    return {sorted};
}

}   // namespace angiopose::io
