#include "app/jobs/read_inputs.h"

#include "app/jobs/input_kind.h"
#include "app/messages/says.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/messages/says.h"
#include "io/subtraction_file.h"
#include "io/surface_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <QFileInfo>

#include <algorithm>

namespace angiopose::app {
namespace {

/// The inputs of a case that are not in their place: what the hints know of them, and what a search finds.
core::Status findInputs(LoadedInputs& inputs, const QString& path, const OpenHints& hints,
                        const io::ReadObserver& observe)
{
    auto missing = io::missingInputs(path.toStdString());
    if (!missing) {
        return missing.error();
    }
    inputs.missing = std::move(missing).value();
    inputs.moved = hints.moved;
    const auto isFound = [&inputs](const io::MissingInput& each) { return inputs.moved.contains(each.path); };
    std::erase_if(inputs.missing, isFound);
    std::vector<std::string> folders{QFileInfo(path).absolutePath().toStdString()};
    for (const QString& folder : hints.searchFolders) {
        folders.push_back(folder.toStdString());
    }
    if (!inputs.missing.empty()) {
        inputs.moved.merge(io::findMovedInputs(inputs.missing, folders, observe));
        std::erase_if(inputs.missing, isFound);
    }
    if (hints.withoutOptional) {
        std::erase_if(inputs.missing, [](const io::MissingInput& each) { return each.isOptional; });
    }
    return core::Done{};
}

core::Result<LoadedInputs> readCase(const QString& path, const OpenHints& hints, const io::ReadObserver& observe)
{
    LoadedInputs inputs;
    if (const auto found = findInputs(inputs, path, hints, observe); !found) {
        return found.error();
    }
    if (!inputs.missing.empty()) {
        return inputs;
    }
    auto loaded = io::loadCase(path.toStdString(), inputs.warnings, observe, inputs.moved);
    if (!loaded) {
        return loaded.error();
    }
    for (const auto& [wanted, place] : inputs.moved) {
        inputs.warnings.push_back(
            says::openMoved(QFileInfo(QString::fromStdString(wanted)).fileName().toStdString(), place));
    }
    inputs.wholeCase = std::move(loaded).value();
    return inputs;
}

core::Error twice(const QString& path, const core::MessageKind<1>& what)
{
    return what(QFileInfo(path).fileName().toStdString());
}

/// True for a slice beside the one that was opened: its series is there already.
bool isOfSameSeries(const LoadedInputs& inputs, const QString& path)
{
    const QFileInfo opened(QString::fromStdString(inputs.centerlineFile.path));
    return inputs.volume && inputs.vesselInput.kind == core::VesselInputKind::Volume &&
           QFileInfo(path).absolutePath() == opened.absolutePath() && !io::isVolumeFile(path.toStdString());
}

/// A scan to be seen beside vessels that are there already.
core::Status addScan(LoadedInputs& inputs, const QString& path, const QString& seriesId,
                     const io::ReadObserver& observe)
{
    auto read = io::readVolume(path.toStdString(), seriesId.toStdString(), observe);
    if (!read) {
        return read.error();
    }
    io::LoadedVolume scan = std::move(read).value();
    inputs.scanIdentity = scan.identity;
    inputs.volume = std::make_shared<const core::Volume>(std::move(scan.volume));
    inputs.warnings.insert(inputs.warnings.end(), scan.warnings.begin(), scan.warnings.end());
    inputs.scanFile.path = path.toStdString();
    inputs.scanSeriesId = seriesId.toStdString();
    core::VesselInput asVolume;
    asVolume.kind = core::VesselInputKind::Volume;
    asVolume.seriesId = inputs.scanSeriesId;
    if (const auto hash = io::sha256OfVesselInput(inputs.scanFile.path, asVolume)) {
        inputs.scanFile.sha256 = hash.value();
    }
    return core::Done{};
}

/// A scan in which nothing could be traced is shown nevertheless: seeds and threshold can be set where it is seen.
core::Status addUntraced(LoadedInputs& inputs, const QString& path, const QString& seriesId, const core::Error& problem,
                         const io::ReadObserver& observe)
{
    if (!addScan(inputs, path, seriesId, observe)) {
        return problem;
    }
    inputs.warnings.push_back(problem.message.as(core::Severity::Warning));
    return core::Done{};
}

/// Surfaces and most centrelines carry no unit. How many it is across where mm make no vessels of it; nothing where
/// they do, or where the file says its unit (Slicer curves).
std::optional<double> doubtfulUnitsAcross(const QString& path, core::VesselInputKind kind)
{
    if (kind == core::VesselInputKind::Surface) {
        const auto surface = io::readSurface(path.toStdString());
        const bool isDoubtful = surface && !io::isUsualSize(surface.value().acrossMm);
        return isDoubtful ? std::optional(surface.value().acrossMm) : std::nullopt;
    }
    if (kind != core::VesselInputKind::Centerline || path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) {
        return std::nullopt;
    }
    const auto tree = io::readVesselTree(path.toStdString());
    const bool isDoubtful = tree && !core::isUsualSize(tree.value());
    return isDoubtful ? std::optional(core::acrossMm(tree.value())) : std::nullopt;
}

core::Status addVessels(LoadedInputs& inputs, const QString& path, const OpenHints& hints, const QString& seriesId,
                        const io::ReadObserver& observe)
{
    if (inputs.tree) {
        return isOfSameSeries(inputs, path) ? core::Status(core::Done{}) : twice(path, says::openSecondTree);
    }
    const auto kind = io::vesselInputKindOf(path.toStdString());
    if (!kind) {
        return kind.error();
    }
    const bool isScan = kind.value() == core::VesselInputKind::Volume;
    inputs.isScanAsked = isScan && hints.scanUse == ScanUse::Ask;
    if (inputs.isScanAsked) {
        return core::Done{};
    }
    if (isScan && hints.scanUse == ScanUse::Beside) {
        return addScan(inputs, path, seriesId, observe);
    }
    if (!hints.unitMm) {
        inputs.askedUnitsAcross = doubtfulUnitsAcross(path, kind.value());
        if (inputs.askedUnitsAcross) {
            return core::Done{};
        }
    }
    core::VesselInput input;
    input.kind = kind.value();
    input.seriesId = seriesId.toStdString();
    input.unitMm = hints.unitMm.value_or(1.0);
    auto read = io::readVessels(path.toStdString(), input, observe);
    if (!read) {
        return isScan && hints.scanUse == ScanUse::TraceOrShow
                   ? addUntraced(inputs, path, seriesId, read.error(), observe)
                   : core::Status(read.error());
    }
    io::LoadedVessels vessels = std::move(read).value();
    inputs.tree = std::make_shared<core::VesselTree>(std::move(vessels.tree));
    inputs.volume = vessels.volume;
    inputs.lumen = io::sharedLumen(vessels);
    inputs.scanIdentity = vessels.identity;
    inputs.vesselInput = vessels.input;
    inputs.warnings.insert(inputs.warnings.end(), vessels.warnings.begin(), vessels.warnings.end());
    inputs.centerlineFile.path = path.toStdString();
    return core::Done{};
}

core::Status addImage(LoadedInputs& inputs, const QString& path)
{
    if (inputs.angiogram) {
        return twice(path, says::openSecondAngiogram);
    }
    auto angiogram = io::readAngiogram(path.toStdString());
    if (!angiogram) {
        return angiogram.error();
    }
    const auto& warnings = angiogram.value().warnings;
    inputs.warnings.insert(inputs.warnings.end(), warnings.begin(), warnings.end());
    inputs.angiogram = std::make_shared<core::Angiogram>(std::move(angiogram).value());
    if (const auto plan = io::readSubtractionPlan(path.toStdString())) {
        inputs.headerPlan = plan.value();
    }
    inputs.imageFile.path = path.toStdString();
    return core::Done{};
}

core::Status addTarget(LoadedInputs& inputs, const QString& path)
{
    if (inputs.target) {
        return twice(path, says::openSecondCentreline);
    }
    auto target = io::readCenterline2d(path.toStdString());
    if (!target) {
        return target.error();
    }
    inputs.target = std::make_shared<core::Centerline2d>(std::move(target).value());
    inputs.targetFile.path = path.toStdString();
    return core::Done{};
}

/// Why none of the series can be opened: every reason once, with the series it holds for.
core::Message reasonsOf(const std::vector<io::DicomSeries>& all)
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
    return says::openNoSeries(all.size(), reasons);
}

/// Opens the chosen series of a folder, or the only one; several are offered.
core::Status addFolder(LoadedInputs& inputs, const QString& path, const OpenHints& hints,
                       const io::ReadObserver& observe)
{
    const QString& seriesId = hints.seriesId;
    auto listed = io::listSeries(path.toStdString(), io::partOf(observe, 0.0, 0.1));
    if (!listed) {
        return listed.error();
    }
    std::vector<io::DicomSeries> all = std::move(listed).value();
    const auto opens = [&](const io::DicomSeries& series) {
        return seriesId.isEmpty() ? !series.problem : series.id == seriesId.toStdString();
    };
    const auto count = std::count_if(all.begin(), all.end(), opens);
    if (count > 1 && seriesId.isEmpty()) {
        inputs.offered = std::move(all);
        return core::Done{};
    }
    const auto found = std::find_if(all.begin(), all.end(), opens);
    if (found == all.end() && !seriesId.isEmpty()) {
        return core::Error(io::says::seriesNotHere(seriesId.toStdString()).about(path.toStdString()));
    }
    if (found == all.end()) {
        return core::Error(reasonsOf(all).about(path.toStdString()));
    }
    return found->isAngiogram
               ? addImage(inputs, QString::fromStdString(found->slices.front().path))
               : addVessels(inputs, path, hints, QString::fromStdString(found->id), io::partOf(observe, 0.1, 1.0));
}

core::Status addFile(LoadedInputs& inputs, const QString& path, const OpenHints& hints, const io::ReadObserver& observe)
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
        case InputKind::Case:
            break;
    }
    return core::Error(says::openCaseAlone(QFileInfo(path).fileName().toStdString()));
}

void addVesselHash(LoadedInputs& inputs)
{
    if (!inputs.centerlineFile.path.empty()) {
        if (const auto hash = io::sha256OfVesselInput(inputs.centerlineFile.path, inputs.vesselInput)) {
            inputs.centerlineFile.sha256 = hash.value();
        }
    }
}

void addHash(core::InputFile& file)
{
    if (!file.path.empty()) {
        if (const auto hash = io::sha256OfFile(file.path)) {
            file.sha256 = hash.value();
        }
    }
}

}   // namespace

core::Result<LoadedInputs> readInputs(const QStringList& paths, const OpenHints& hints, const io::ReadObserver& observe)
{
    if (paths.size() == 1) {
        const auto kind = inputKindOf(paths.front());
        if (kind && kind.value() == InputKind::Case) {
            return readCase(paths.front(), hints, observe);
        }
    }
    LoadedInputs inputs;
    for (qsizetype i = 0; i < paths.size(); ++i) {
        const auto share = 1.0 / static_cast<double>(paths.size());
        const auto part = io::partOf(observe, share * static_cast<double>(i), share * static_cast<double>(i + 1));
        if (const auto added = addFile(inputs, paths[i], hints, part); !added) {
            return added.error();
        }
        if (!inputs.offered.empty() || inputs.askedUnitsAcross) {
            return inputs;
        }
    }
    addVesselHash(inputs);
    addHash(inputs.imageFile);
    addHash(inputs.targetFile);
    return inputs;
}

}   // namespace angiopose::app