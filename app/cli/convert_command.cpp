#include "app/cli/commands.h"
#include "app/messages/messages.h"
#include "core/imaging/fill_surface.h"
#include "io/angiogram_file.h"
#include "io/camera_pose_file.h"
#include "io/centerline2d_file.h"
#include "io/deidentify_file.h"
#include "io/derived_angiogram.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/pose_camera_file.h"
#include "io/pose_file.h"
#include "io/support/atomic_file.h"
#include "io/support/input_bytes.h"
#include "io/surface_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using core::Status;
using core::VesselInputKind;

bool endsWith(const std::string& path, std::initializer_list<const char*> endings)
{
    std::string lowered = path;
    std::transform(lowered.begin(), lowered.end(), lowered.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return lowered.ends_with(ending); });
}

io::ReadObserver observer(ProgressLine& progress)
{
    return [&progress](double fraction) {
        progress.show(fraction, "");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
}

Status convertLabels(const ConvertArguments& arguments)
{
    ProgressLine progress("reading");
    const auto labels = io::readLabels(arguments.inputPath, observer(progress));
    return labels ? io::writeLabels(labels.value(), arguments.outputPath) : labels.error();
}

Status convertVolume(const ConvertArguments& arguments)
{
    ProgressLine progress("reading");
    const auto read = io::readVolume(arguments.inputPath, arguments.seriesId, observer(progress));
    if (!read) {
        return read.error();
    }
    printWarnings(read.value().warnings);
    const core::Volume& volume = read.value().volume;
    return io::looksLikeLabels(volume) ? io::writeLabels(io::labelsOf(volume), arguments.outputPath)
                                       : io::writeVolume(volume, arguments.outputPath);
}

/// Writes the interior of a surface as a label image.
Status fillToVolume(const ConvertArguments& arguments)
{
    const auto surface = io::readSurface(arguments.inputPath, arguments.unitMm);
    if (!surface) {
        return surface.error();
    }
    printWarnings(surface.value().warnings);
    const core::SurfaceMesh& mesh = surface.value().mesh;
    const double spacing = arguments.spacingMm > 0.0 ? arguments.spacingMm : core::defaultSpacingMm(mesh);
    const auto mask = core::fillSurface(mesh, spacing);
    if (!mask) {
        return mask.error().about(arguments.inputPath);
    }
    core::LabelVolume labels(mask.value().geometry);
    std::copy(mask.value().voxels.begin(), mask.value().voxels.end(), labels.voxels.begin());
    return io::writeLabels(labels, arguments.outputPath);
}

Status convertSurface(const ConvertArguments& arguments)
{
    const auto surface = io::readSurface(arguments.inputPath, arguments.unitMm);
    if (!surface) {
        return surface.error();
    }
    printWarnings(surface.value().warnings);
    return io::writeSurface(surface.value().mesh, arguments.outputPath);
}

/// Converts a pose; JSON output includes the camera, if any.
Status convertPose(const ConvertArguments& arguments)
{
    const auto read = io::readPoseWithCamera(arguments.inputPath);
    if (!read) {
        return read.error();
    }
    const io::PoseWithCamera& pose = read.value();
    return pose.camera && pose.camera->width > 0 && endsWith(arguments.outputPath, {".json"})
               ? io::writeAtomically(arguments.outputPath, io::cameraPoseText(pose.cameraFromPatient, *pose.camera))
               : io::writePose(pose.cameraFromPatient, arguments.outputPath);
}

Status convertAngiogram(const ConvertArguments& arguments)
{
    const auto angiogram = io::readAngiogram(arguments.inputPath);
    if (!angiogram) {
        return angiogram.error();
    }
    printWarnings(angiogram.value().warnings);
    return io::writeDerivedAngiogram(angiogram.value(), arguments.outputPath, arguments.inputPath);
}

/// Converts centerlines: writes a tree if the input is a tree, otherwise 2-D curves of an image.
Status convertCurves(const ConvertArguments& arguments)
{
    io::VesselTreeReadOptions options;
    options.unitMm = arguments.unitMm;
    const auto tree = io::readTree(arguments.inputPath, options);
    if (tree) {
        printWarnings(tree.value().warnings);
        return io::writeVesselTree(tree.value().tree, arguments.outputPath);
    }
    const bool mayBeFlat = endsWith(arguments.inputPath, {".csv", ".png"}) && endsWith(arguments.outputPath, {".csv"});
    const auto flat =
        mayBeFlat ? io::readCenterline2d(arguments.inputPath) : core::Result<core::Centerline2d>(tree.error());
    return flat ? io::writeCenterline2d(flat.value(), arguments.outputPath) : tree.error();
}

Status toCurves(const ConvertArguments& arguments)
{
    const auto kind = io::vesselInputKindOf(arguments.inputPath);
    if (!kind) {
        return kind.error();
    }
    if (kind.value() != VesselInputKind::Centerline) {
        return core::Error(
            messages::convertNoCurves(arguments.inputPath, arguments.outputPath).about(arguments.inputPath));
    }
    return convertCurves(arguments);
}

Status toVolume(const ConvertArguments& arguments)
{
    const auto kind = io::vesselInputKindOf(arguments.inputPath);
    if (!kind) {
        return kind.error();
    }
    if (kind.value() == VesselInputKind::Centerline) {
        return core::Error(messages::convertNoVolume().about(arguments.inputPath));
    }
    if (kind.value() == VesselInputKind::Segmentation) {
        return convertLabels(arguments);
    }
    return kind.value() == VesselInputKind::Surface ? fillToVolume(arguments) : convertVolume(arguments);
}

bool isImageFile(const std::string& path)
{
    return io::isDicomFile(path) || endsWith(path, {".png", ".jpg", ".jpeg", ".tif", ".tiff"});
}

/// De-identifies a DICOM file, an image file or a folder.
Status deidentifyInput(const ConvertArguments& arguments)
{
    const auto pseudonyms = pseudonymsOf(*arguments.identity);
    if (!pseudonyms) {
        return pseudonyms.error();
    }
    const io::DeidentificationOptions requested = *deidentificationOf(*arguments.identity);
    const std::string& in = arguments.inputPath;
    const std::string& out = arguments.outputPath;
    ProgressLine progress("reading");
    const auto done = fs::is_directory(in)
                          ? io::deidentifyFolder(in, out, requested, pseudonyms.value(), observer(progress))
                          : io::deidentifyFile(in, out, requested, pseudonyms.value());
    if (done) {
        printWarnings(done.value());
    }
    return done ? Status(core::Done{}) : done.error();
}

/// Returns whether files in the output format contain no identity, except possibly in branch names.
bool storesNoIdentity(const std::string& out)
{
    return endsWith(out, {".nii", ".nii.gz", ".nrrd", ".mha", ".stl", ".tfm", ".h5", ".vtp", ".csv", ".swc", ".json"});
}

Status convert(const ConvertArguments& arguments)
{
    const std::string& out = arguments.outputPath;
    if (arguments.identity->isRequested && !storesNoIdentity(out)) {
        const bool isFolder = fs::is_directory(arguments.inputPath);
        const std::string ending = io::isDicomFile(arguments.inputPath) ? ".dcm" : io::extensionOf(arguments.inputPath);
        const bool fits = isFolder ? io::extensionOf(out).empty() : endsWith(out, {ending.c_str()});
        return fits && (isFolder || isImageFile(arguments.inputPath))
                   ? deidentifyInput(arguments)
                   : Status(core::Error(io::messages::deidentifiedKind(ending).about(out)));
    }
    if (endsWith(out, {".mrk.json", ".vtp", ".csv", ".swc"})) {
        return toCurves(arguments);
    }
    if (endsWith(out, {".nii", ".nii.gz", ".nrrd", ".mha"})) {
        return toVolume(arguments);
    }
    if (endsWith(out, {".stl"})) {
        return convertSurface(arguments);
    }
    if (endsWith(out, {".json", ".tfm", ".h5"})) {
        return convertPose(arguments);
    }
    if (endsWith(out, {".dcm"})) {
        return convertAngiogram(arguments);
    }
    return core::Error(messages::convertExtension().about(out));
}

}   // namespace

int runConvert(const ConvertArguments& arguments)
{
    std::error_code absent;
    if (fs::equivalent(arguments.inputPath, arguments.outputPath, absent)) {
        return reportInputError(messages::convertOntoInput().about(arguments.outputPath));
    }
    if (const Status converted = convert(arguments); !converted) {
        return reportInputError(converted.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitSuccess;
}

}   // namespace angiopose::app
