#include "io/series/group_slices.h"

#include "io/messages/messages.h"
#include "io/series/dicom_segmentation.h"
#include "io/series/slice_record.h"
#include "io/series/slice_stack.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace angiopose::io {
namespace {

using Slices = std::vector<SliceRecord>;

constexpr double samePlaceMm = 0.01;

/// Returns whether two slices lie in the same plane.
bool isSamePosition(const SliceRecord& a, const SliceRecord& b)
{
    return std::abs(normalOf(a).dot(*a.position - *b.position)) < samePlaceMm;
}

std::size_t placeCount(const Slices& sorted)
{
    std::size_t count = sorted.empty() ? 0 : 1;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        count += isSamePosition(sorted[i - 1], sorted[i]) ? 0 : 1;
    }
    return count;
}

/// Splits slices by one key; returns nothing if a resulting volume would have several slices at the same position.
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

/// Returns the number of slices missing from the regular grid of these slices; nullopt if they do not lie on a grid.
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

/// Sorts slices by position, then by recording, then by name, whatever the order of the files.
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

/// Splits sorted slices into volumes with one slice per position, by a phase key or by repetition. Slices that cannot
/// be separated in either way stay together.
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

/// Returns a grouping key; only files with equal keys can be slices of the same volume.
std::string seriesKey(const DicomImages& file)
{
    const core::StudyIdentity& identity = file.identity;
    if (!identity.seriesUid.empty()) {
        return identity.seriesUid;
    }
    return identity.studyUid + "|" + identity.patientId + "|" + std::to_string(file.seriesNumber) + "|" +
           file.seriesDescription;
}

/// Returns size, spacing and orientation, rounded so that noise in the header does not split a volume.
std::vector<long> shapeKey(const SliceRecord& slice)
{
    std::vector<long> key{slice.size.x(), slice.size.y(), std::lround(slice.spacingMm.x() * 1e4),
                          std::lround(slice.spacingMm.y() * 1e4), slice.position && slice.axes ? 1 : 0};
    if (slice.axes) {
        for (int i = 0; i < 6; ++i) {
            key.push_back(std::lround((*slice.axes)(i % 3, i / 3) * 200.0));
        }
    }
    return key;
}

/// Returns whether two slices agree well enough to belong to one volume, even if rounding separates their keys.
bool areSameShape(const SliceRecord& a, const SliceRecord& b)
{
    const bool isPlaced = a.position && a.axes, isOtherPlaced = b.position && b.axes;
    if (a.size != b.size || isPlaced != isOtherPlaced || (a.spacingMm - b.spacingMm).cwiseAbs().maxCoeff() > 1e-3) {
        return false;
    }
    return !isPlaced || (*a.axes - *b.axes).cwiseAbs().maxCoeff() < 5e-3;
}

std::vector<Slices> byShape(const Slices& slices)
{
    std::vector<Slices> groups;
    std::map<std::vector<long>, std::size_t> groupOfKey;
    for (const SliceRecord& slice : slices) {
        const auto key = shapeKey(slice);
        auto found = groupOfKey.find(key);
        if (found == groupOfKey.end()) {
            const auto alike = std::find_if(groups.begin(), groups.end(),
                                            [&](const Slices& group) { return areSameShape(group.front(), slice); });
            const auto at = static_cast<std::size_t>(alike - groups.begin());
            if (alike == groups.end()) {
                groups.emplace_back();
            }
            found = groupOfKey.emplace(key, at).first;
        }
        groups[found->second].push_back(slice);
    }
    return groups;
}

/// Removes duplicates: slices with the same SOP instance, frame, position and number. Returns messages with the number
/// of duplicates and the number of images that differ from an earlier one with the same SOP Instance UID.
core::Messages removeDuplicates(Slices& slices)
{
    using Instance = std::pair<std::string, int>;
    std::set<std::tuple<Instance, std::vector<double>, int, decltype(SliceRecord::phaseKeys)>> seen;
    std::set<Instance> instances;
    std::size_t sameUid = 0;
    const std::size_t before = slices.size();
    const std::size_t copies = std::erase_if(slices, [&](const SliceRecord& slice) {
        if (slice.sopInstanceUid.empty()) {
            return false;
        }
        const Instance instance(slice.sopInstanceUid, slice.frame);
        const auto* at = slice.position ? slice.position->data() : nullptr;
        const std::vector<double> place(at, at ? at + 3 : at);
        const bool isCopy = !seen.emplace(instance, place, slice.instanceNumber, slice.phaseKeys).second;
        sameUid += !instances.insert(instance).second && !isCopy ? 1 : 0;
        return isCopy;
    });
    core::Messages found;
    if (copies > 0) {
        found.push_back(messages::seriesFilesTwice(copies));
    }
    if (sameUid > 0) {
        found.push_back(messages::seriesSameUid(sameUid + 1, before - copies));
    }
    return found;
}

/// Keeps only the first recorded slice at each position.
void keepFirstPerPlace(DicomSeries& series)
{
    const std::size_t before = series.slices.size();
    const auto end = std::unique(series.slices.begin(), series.slices.end(), isSamePosition);
    series.slices.erase(end, series.slices.end());
    if (const std::size_t dropped = before - series.slices.size(); dropped > 0) {
        series.warnings.push_back(messages::seriesOverlap(dropped, before));
    }
}

std::optional<core::Message> findSeriesProblem(const DicomSeries& series, const DicomImages& head)
{
    const SliceRecord& first = series.slices.front();
    if (isSegmentationClass(head.sopClassUid)) {
        return messages::seriesIsSegmentation();
    }
    if (!first.position || !first.axes) {
        return messages::seriesNoPlace();
    }
    return first.spacingMm.isZero() ? std::optional(messages::seriesNoPixelSize()) : std::nullopt;
}

void planVolume(DicomSeries& series, const DicomImages& head)
{
    series.problem = findSeriesProblem(series, head);
    if (series.problem) {
        return;
    }
    keepFirstPerPlace(series);
    series.stack = planStack(series.slices);
    series.problem = series.stack.problem;
    const double stated = series.slices.front().statedStepMm, step = series.stack.geometry.spacingMm.z();
    if (!series.problem && stated > 0.0 && std::abs(stated - step) > 0.05 * step) {
        series.warnings.push_back(messages::seriesStep(core::inMm(stated, 2), core::inMm(step, 2)));
    }
    series.warnings.insert(series.warnings.end(), series.stack.warnings.begin(), series.stack.warnings.end());
}

DicomSeries emptySeries(const DicomImages& head)
{
    DicomSeries series;
    series.id = seriesKey(head);
    series.identity = head.identity;
    series.description = head.seriesDescription;
    series.number = head.seriesNumber;
    return series;
}

std::vector<DicomSeries> volumesOf(const DicomImages& head, Slices slices, std::size_t damaged)
{
    std::vector<DicomSeries> volumes;
    const core::Messages copies = removeDuplicates(slices);
    const std::vector<Slices> shapes = byShape(slices);
    for (Slices shape : shapes) {
        const bool isPlaced = shape.front().position && shape.front().axes;
        if (isPlaced) {
            sortAlongNormal(shape);
        }
        for (Slices& part : isPlaced ? splitVolumes(shape) : std::vector<Slices>{shape}) {
            DicomSeries series = emptySeries(head);
            series.slices = std::move(part);
            series.warnings = copies;
            if (damaged > 0) {
                series.warnings.push_back(messages::seriesFilesDamaged(damaged));
            }
            if (shapes.size() > 1) {
                series.warnings.push_back(messages::seriesMixed(shapes.size()));
            }
            planVolume(series, head);
            volumes.push_back(std::move(series));
        }
    }
    return volumes;
}

/// Returns the acquisition to which all slices belong; empty if there are several acquisitions or none is named.
std::string acquisitionOf(const DicomSeries& series)
{
    const std::string& first = series.slices.front().phaseKeys[0];
    const bool isOne =
        std::ranges::all_of(series.slices, [&](const SliceRecord& slice) { return slice.phaseKeys[0] == first; });
    return isOne ? first : std::string();
}

/// Sorts volumes by size, largest first; numbers the volumes of a series, and names their acquisitions if these are all
/// different.
void order(std::vector<DicomSeries>& volumes)
{
    std::stable_sort(volumes.begin(), volumes.end(), [](const DicomSeries& a, const DicomSeries& b) {
        return std::tuple(!a.problem, a.slices.size()) > std::tuple(!b.problem, b.slices.size());
    });
    std::set<std::string> acquisitions{""};
    std::ranges::transform(volumes, std::inserter(acquisitions, acquisitions.end()), acquisitionOf);
    const bool areNamed = acquisitions.size() == volumes.size() + 1;
    for (std::size_t i = 0; i < volumes.size() && volumes.size() > 1; ++i) {
        volumes[i].id += i == 0 ? "" : "#" + std::to_string(i + 1);
        volumes[i].part = areNamed ? messages::seriesAcquisition(i + 1, volumes.size(), acquisitionOf(volumes[i]))
                                   : core::Message(messages::seriesPart(i + 1, volumes.size()));
    }
}

DicomSeries runOf(const DicomImages& file)
{
    DicomSeries series = emptySeries(file);
    series.id = file.identity.sopInstanceUid.empty() ? file.slices.front().path : file.identity.sopInstanceUid;
    series.isAngiogram = true;
    series.slices = file.slices;
    return series;
}

}   // namespace

std::vector<DicomSeries> groupSlices(std::vector<DicomImages> files)
{
    std::vector<DicomSeries> result;
    std::map<std::string, std::map<std::string, std::vector<std::size_t>>> filesOfSeries;   // by patient and study
    std::map<std::string, int> runs;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].slices.empty()) {
            continue;
        }
        if (files[i].isProjection) {
            DicomSeries& run = result.emplace_back(runOf(files[i]));
            const int count = ++runs[run.id];
            run.id += count == 1 ? "" : "#" + std::to_string(count);
        } else {
            const core::StudyIdentity& who = files[i].identity;
            filesOfSeries[seriesKey(files[i])][who.patientId + "|" + who.studyUid].push_back(i);
        }
    }
    for (const auto& [key, owners] : filesOfSeries) {
        std::vector<DicomSeries> volumes;
        for (const auto& [owner, members] : owners) {
            Slices slices;
            std::size_t damaged = 0;
            for (const std::size_t i : members) {
                slices.insert(slices.end(), files[i].slices.begin(), files[i].slices.end());
                damaged += files[i].damage ? 1 : 0;
            }
            for (DicomSeries& volume : volumesOf(files[members.front()], std::move(slices), damaged)) {
                if (owners.size() > 1) {
                    volume.warnings.push_back(messages::seriesOfSeveral(owners.size()));
                }
                volumes.push_back(std::move(volume));
            }
        }
        order(volumes);
        std::move(volumes.begin(), volumes.end(), std::back_inserter(result));
    }
    std::stable_sort(result.begin(), result.end(), [](const DicomSeries& a, const DicomSeries& b) {
        const auto rank = [](const DicomSeries& series) {
            return std::tuple(!series.problem, !series.isAngiogram, series.slices.size());
        };
        return rank(a) > rank(b);
    });
    return result;
}

}   // namespace angiopose::io
