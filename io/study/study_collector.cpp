#include "io/study/study_collector.h"

#include "io/messages/messages.h"
#include "io/series/group_slices.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <iterator>
#include <tuple>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

/// Returns whether a transfer syntax is video: MPEG-2, MPEG-4 or HEVC (PS3.5 A.4.5 to A.4.12).
bool isVideo(const std::string& transferSyntax)
{
    constexpr std::string_view family = "1.2.840.10008.1.2.4.1";
    return transferSyntax.size() == family.size() + 2 && transferSyntax.starts_with(family) &&
           transferSyntax[family.size()] == '0' && transferSyntax != "1.2.840.10008.1.2.4.109";
}

bool hasVessels(std::string_view modality)
{
    static constexpr std::array<std::string_view, 8> without{"PT", "NM", "US", "MG", "IVUS", "IVOCT", "OCT", "RTDOSE"};
    return std::ranges::find(without, modality) == without.end();
}

core::Message reasonWithoutImage(const std::string& modality)
{
    if (modality == "SR" || modality == "DOC") {
        return messages::studyReport();
    }
    if (modality.empty()) {
        return messages::seriesFileWithoutImage();
    }
    return modality == "PR" ? core::Message(messages::studyPresentation())
                            : core::Message(messages::studyNoImage(modality));
}

/// Returns the deepest folder that contains both paths.
fs::path commonFolder(const fs::path& a, const fs::path& b)
{
    fs::path common;
    for (auto left = a.begin(), right = b.begin(); left != a.end() && right != b.end() && *left == *right;
         ++left, ++right) {
        common /= *left;
    }
    return common;
}

std::string wholeSeriesOf(const DicomSeries& series)
{
    return series.id.substr(0, series.id.find('#'));
}

/// Sets the path to open. For a volume, this is the folder with all parts of its series, so that part numbers agree.
void findPlaces(std::vector<StudySeries>& all)
{
    std::map<std::string, fs::path> folders;
    for (const StudySeries& each : all) {
        for (const SliceRecord& slice : each.series.isAngiogram ? std::vector<SliceRecord>() : each.series.slices) {
            const fs::path folder = fs::path(slice.path).parent_path();
            const auto [known, isNew] = folders.emplace(wholeSeriesOf(each.series), folder);
            if (!isNew && known->second != folder) {
                known->second = commonFolder(known->second, folder);
            }
        }
    }
    for (StudySeries& each : all) {
        each.place =
            each.series.isAngiogram ? each.series.slices.front().path : folders[wholeSeriesOf(each.series)].string();
    }
}

auto patientKey(const core::StudyIdentity& who)
{
    return std::tuple(who.patientName, who.patientId, who.birthDate);
}

std::string studyKey(const core::StudyIdentity& identity)
{
    return identity.studyUid.empty() ? identity.studyDate + "|" + identity.accessionNumber : identity.studyUid;
}

/// Returns the element for which `isIt` is true; appends a new one if there is none.
template <class T, class Test>
T& findOrAdd(std::vector<T>& all, const Test& isIt, const core::StudyIdentity& identity)
{
    const auto found = std::ranges::find_if(all, isIt);
    if (found != all.end()) {
        return *found;
    }
    all.emplace_back().identity = identity;
    return all.back();
}

}   // namespace

void StudyCollector::add(StudyFile file)
{
    attributes_[file.path] = {std::move(file.studyDescription),
                              std::move(file.bodyPart),
                              std::move(file.imageType),
                              std::move(file.transferSyntax),
                              file.frames,
                              file.samples,
                              file.frameTimeMs};
    if (file.images.slices.empty()) {   // keep the path of an object without an image
        file.images.slices.emplace_back().path = file.path;
        withoutImage_.push_back(std::move(file.images));
        return;
    }
    images_.push_back(std::move(file.images));
}

const StudyCollector::SeriesAttributes* StudyCollector::attributesOf(const std::string& path) const
{
    const auto found = attributes_.find(path);
    return found == attributes_.end() ? nullptr : &found->second;
}

void StudyCollector::determineUse(StudySeries& each, const SeriesAttributes& attributes) const
{
    const std::string& modality = each.series.identity.modality;
    each.bodyPart = attributes.bodyPart;
    each.frameTimeMs = attributes.frameTimeMs;
    each.imageCount = each.series.isAngiogram ? attributes.frames : static_cast<int>(each.series.slices.size());
    const bool isScout = attributes.imageType.find("LOCALIZER") != std::string::npos;
    if (isVideo(attributes.transferSyntax)) {
        each.reason = messages::studyVideo();
    } else if (isScout) {
        each.reason = messages::studyScout();
    } else if (!each.series.isAngiogram && !hasVessels(modality)) {
        each.reason = messages::studyModality(modality);
    } else if (!each.series.isAngiogram && attributes.samples != 1) {
        each.reason = messages::seriesColor();
    } else if (each.series.problem) {
        each.reason = each.series.problem;
    } else {
        each.use = each.series.isAngiogram ? SeriesUse::View : SeriesUse::Vessels;
    }
}

std::vector<StudySeries> StudyCollector::seriesWithImages() const
{
    std::vector<StudySeries> all;
    for (DicomSeries& series : groupSlices(images_)) {
        StudySeries& each = all.emplace_back();
        each.series = std::move(series);
        if (const SeriesAttributes* attributes = attributesOf(each.series.slices.front().path)) {
            determineUse(each, *attributes);
        }
    }
    findPlaces(all);
    return all;
}

std::vector<StudySeries> StudyCollector::seriesWithoutImages() const
{
    std::vector<StudySeries> all;
    for (const DicomImages& file : withoutImage_) {
        const auto isIts = [&](const StudySeries& each) {
            return each.series.id == file.identity.seriesUid &&
                   each.series.identity.modality == file.identity.modality &&
                   studyKey(each.series.identity) == studyKey(file.identity) &&
                   patientKey(each.series.identity) == patientKey(file.identity);
        };
        const auto known = std::ranges::find_if(all, isIts);
        if (known != all.end()) {
            ++known->imageCount;
            continue;
        }
        StudySeries& each = all.emplace_back();
        each.series.id = file.identity.seriesUid;
        each.series.identity = file.identity;
        each.series.description = file.seriesDescription;
        each.series.number = file.seriesNumber;
        each.series.slices = file.slices;
        each.place = file.slices.front().path;
        each.imageCount = 1;
        each.reason = reasonWithoutImage(file.identity.modality);
    }
    return all;
}

/// Counts the missing files of a DICOMDIR per series; adds a series of which all files are missing.
void StudyCollector::countMissingFiles(std::vector<StudySeries>& all) const
{
    for (const DirectoryEntry& file : missingFiles_) {
        const auto isOfIt = [&](const StudySeries& each) {
            return each.series.identity.seriesUid == file.identity.seriesUid;
        };
        auto found = std::ranges::find_if(all, isOfIt);
        if (found == all.end()) {
            StudySeries& each = all.emplace_back();
            each.series.id = file.identity.seriesUid;
            each.series.identity = file.identity;
            each.series.description = file.seriesDescription;
            each.series.number = file.seriesNumber;
            each.reason = messages::studyMissing();
            found = all.end() - 1;
        }
        ++found->missingFiles;
    }
}

std::string StudyCollector::studyDescriptionOf(const StudySeries& each) const
{
    if (!each.series.slices.empty()) {
        const SeriesAttributes* attributes = attributesOf(each.series.slices.front().path);
        return attributes ? attributes->studyDescription : std::string();
    }
    const auto listed = std::ranges::find_if(missingFiles_, [&](const DirectoryEntry& file) {
        return file.identity.seriesUid == each.series.identity.seriesUid;
    });
    return listed == missingFiles_.end() ? std::string() : listed->studyDescription;
}

StudyTree StudyCollector::tree() const
{
    std::vector<StudySeries> all = seriesWithImages();
    std::ranges::move(seriesWithoutImages(), std::back_inserter(all));
    countMissingFiles(all);
    StudyTree tree;
    for (StudySeries& each : all) {
        const core::StudyIdentity identity = each.series.identity;
        StudyPatient& patient = findOrAdd(
            tree.patients,
            [&](const StudyPatient& known) { return patientKey(known.identity) == patientKey(identity); }, identity);
        Study& study = findOrAdd(
            patient.studies, [&](const Study& known) { return studyKey(known.identity) == studyKey(identity); },
            identity);
        if (study.description.empty()) {
            study.description = studyDescriptionOf(each);
        }
        study.series.push_back(std::move(each));
    }
    std::ranges::sort(tree.patients, {}, [](const StudyPatient& each) { return patientKey(each.identity); });
    for (StudyPatient& patient : tree.patients) {
        std::ranges::stable_sort(patient.studies, std::greater(), [](const Study& each) {
            return std::tuple(each.identity.studyDate, each.identity.studyTime);
        });
        for (Study& study : patient.studies) {
            std::ranges::stable_sort(study.series, {}, [](const StudySeries& each) { return each.series.number; });
        }
    }
    return tree;
}

}   // namespace angiopose::io
