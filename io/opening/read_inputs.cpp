#include "io/opening/read_inputs.h"

#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/fiducial_file.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/opening/add_vessels.h"
#include "io/opening/input_kind.h"
#include "io/opening/read_case_inputs.h"
#include "io/study/read_studies.h"
#include "io/subtraction_file.h"
#include "io/vessel_input_file.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

core::Error twice(const std::string& path, const core::MessageKind<1>& what)
{
    return what(std::filesystem::path(path).filename().string());
}

/// Subtracts the run as its header specifies; if it lacks a mask frame named there, keeps it native with a warning.
void applyHeaderSubtraction(LoadedInputs& inputs, const core::RunProcessing& processing)
{
    auto run = core::processRun(*inputs.angiogram, processing);
    if (run) {
        inputs.storedRun = inputs.angiogram;
        inputs.angiogram = std::make_shared<core::Angiogram>(std::move(run).value());
    } else {
        inputs.warnings.push_back(run.error().message);
    }
}

core::Status addImage(LoadedInputs& inputs, const std::string& path)
{
    if (inputs.angiogram) {
        return twice(path, messages::openSecondAngiogram);
    }
    auto angiogram = readAngiogram(path);
    if (!angiogram) {
        return angiogram.error();
    }
    const auto& warnings = angiogram.value().warnings;
    inputs.warnings.insert(inputs.warnings.end(), warnings.begin(), warnings.end());
    inputs.angiogram = std::make_shared<core::Angiogram>(std::move(angiogram).value());
    if (const auto processing = readRunProcessing(path)) {
        inputs.headerPlan = processing.value().plan;
        if (processing.value().isSubtracted && inputs.angiogram->frameCount() > 1) {
            applyHeaderSubtraction(inputs, processing.value());
        }
    }
    inputs.imageFile.path = path;
    return core::Done{};
}

core::Status addTarget(LoadedInputs& inputs, const std::string& path)
{
    if (inputs.target) {
        return twice(path, messages::openSecondCenterline);
    }
    auto target = readCenterline2d(path);
    if (!target) {
        return target.error();
    }
    inputs.target = std::make_shared<core::Centerline2d>(std::move(target).value());
    inputs.targetFile.path = path;
    return core::Done{};
}

/// Explains why none of the series can be opened: each reason once, with the series to which it applies.
core::Message collectReasons(const std::vector<DicomSeries>& all)
{
    if (all.size() == 1) {
        return *all.front().problem;
    }
    std::vector<std::pair<core::Message, std::string>> namesByReason;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = all[i].description.empty() ? std::to_string(i + 1) : all[i].description;
        const auto known =
            std::ranges::find(namesByReason, *all[i].problem, [](const auto& each) { return each.first; });
        if (known == namesByReason.end()) {
            namesByReason.emplace_back(*all[i].problem, name);
        } else {
            known->second += ", " + name;
        }
    }
    core::Messages reasons;
    for (const auto& [reason, names] : namesByReason) {
        reasons.push_back(reason.about(names));
    }
    return messages::openNoSeries(all.size(), reasons);
}

/// Opens the requested or only series of a folder; if there are several, offers them to the user.
core::Status addFolder(LoadedInputs& inputs, const std::string& path, const OpenHints& hints,
                       const ReadObserver& observe)
{
    const std::string& seriesId = hints.seriesId;
    auto listed = listSeries(path, progressPart(observe, 0.0, 0.1));
    if (!listed) {
        return listed.error();
    }
    std::vector<DicomSeries> all = std::move(listed).value();
    const auto opens = [&](const DicomSeries& series) {
        return seriesId.empty() ? !series.problem : series.id == seriesId;
    };
    const auto count = std::count_if(all.begin(), all.end(), opens);
    if (count > 1 && seriesId.empty()) {
        inputs.offeredSeries = std::move(all);
        return core::Done{};
    }
    const auto found = std::find_if(all.begin(), all.end(), opens);
    if (found == all.end() && !seriesId.empty()) {
        return core::Error(messages::seriesNotHere(seriesId).about(path));
    }
    if (found == all.end()) {
        return core::Error(collectReasons(all).about(path));
    }
    return found->isAngiogram ? addImage(inputs, found->slices.front().path)
                              : addVessels(inputs, path, hints, found->id, progressPart(observe, 0.1, 1.0));
}

/// Reads a pose or a point file. Both apply to the open case, so these files must be opened alone.
core::Result<LoadedInputs> readPoseInput(const std::string& path)
{
    const auto pose = readPoseWithCamera(path);
    LoadedInputs inputs;
    if (pose) {
        inputs.pose = pose.value();
    }
    return pose ? core::Result<LoadedInputs>(std::move(inputs)) : pose.error();
}

core::Result<LoadedInputs> readPointsInput(const std::string& path)
{
    const auto fiducials = readFiducials(path);
    LoadedInputs inputs;
    if (fiducials) {
        inputs.fiducials = fiducials.value();
    }
    return fiducials ? core::Result<LoadedInputs>(std::move(inputs)) : fiducials.error();
}

core::Status addFile(LoadedInputs& inputs, const std::string& path, const OpenHints& hints, const ReadObserver& observe)
{
    const auto kind = inputKindOf(path);
    if (!kind) {
        return kind.error();
    }
    switch (kind.value()) {
        case InputKind::Centerline:
        case InputKind::Vessels:
            return addVessels(inputs, path, hints, {}, observe);
        case InputKind::Folder:
            return addFolder(inputs, path, hints, observe);
        case InputKind::Image:
            return addImage(inputs, path);
        case InputKind::Target:
            return addTarget(inputs, path);
        case InputKind::Pose:
        case InputKind::Points:
            return core::Error(messages::openPoseAlone(std::filesystem::path(path).filename().string()));
        case InputKind::Case:
            break;
    }
    return core::Error(messages::openCaseAlone(std::filesystem::path(path).filename().string()));
}

void addVesselHash(LoadedInputs& inputs)
{
    if (!inputs.centerlineFile.path.empty()) {
        if (const auto hash = sha256OfVesselInput(inputs.centerlineFile.path, inputs.vesselInput)) {
            inputs.centerlineFile.sha256 = hash.value();
        }
    }
}

void addHash(core::InputFile& file)
{
    if (!file.path.empty()) {
        if (const auto hash = sha256OfFile(file.path)) {
            file.sha256 = hash.value();
        }
    }
}

}   // namespace

core::Result<LoadedInputs> readInputs(const std::vector<std::string>& paths, const OpenHints& hints,
                                      const ReadObserver& observe)
{
    if (paths.size() == 1) {
        const auto kind = inputKindOf(paths.front());
        if (hints.offersStudies && kind && (kind.value() == InputKind::Folder || isDicomDirectory(paths.front()))) {
            LoadedInputs inputs;
            inputs.isStudyChoiceNeeded = true;
            return inputs;
        }
        if (kind && kind.value() == InputKind::Case) {
            return readCaseInputs(paths.front(), hints, observe);
        }
        if (kind && kind.value() == InputKind::Pose) {
            return readPoseInput(paths.front());
        }
        if (kind && kind.value() == InputKind::Points) {
            return readPointsInput(paths.front());
        }
    }
    LoadedInputs inputs;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto share = 1.0 / static_cast<double>(paths.size());
        const auto part = progressPart(observe, share * static_cast<double>(i), share * static_cast<double>(i + 1));
        if (const auto added = addFile(inputs, paths[i], hints, part); !added) {
            return added.error();
        }
        if (!inputs.offeredSeries.empty() || inputs.extentInUnknownUnits) {
            return inputs;
        }
    }
    addVesselHash(inputs);
    addHash(inputs.imageFile);
    addHash(inputs.targetFile);
    return inputs;
}

}   // namespace angiopose::io
