#include "app/cli/add_warnings.h"
#include "app/cli/commands.h"
#include "app/cli/describe_volume.h"
#include "app/messages/messages.h"
#include "app/texts/case_texts.h"
#include "app/texts/number_text.h"
#include "core/case/case.h"
#include "core/case/initial_pose.h"
#include "core/geometry/geometry_checks.h"
#include "core/imaging/angiogram.h"
#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/fiducial_file.h"
#include "io/opening/input_kind.h"
#include "io/opening/read_case_inputs.h"
#include "io/pose_camera_file.h"
#include "io/series/dicom_segmentation.h"
#include "io/series/slice_record.h"
#include "io/study/read_studies.h"
#include "io/support/input_bytes.h"
#include "io/support/message_json.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace angiopose::app {
namespace {

using Json = nlohmann::ordered_json;

Json sourcedJson(const core::SourcedValue<double>& sourced)
{
    Json json{{"value", nullptr}, {"origin", originText(sourced.origin)}};
    if (sourced.value) {
        json["value"] = *sourced.value;
    }
    if (!sourced.basis.empty()) {
        json["basis"] = sourced.basis;
    }
    return json;
}

template <class Vector>
Json sourcedJson(const core::SourcedValue<Vector>& sourced)
{
    Json json{{"value", nullptr}, {"origin", originText(sourced.origin)}};
    if (sourced.value) {
        json["value"] = std::vector<double>(sourced.value->begin(), sourced.value->end());
        json["basis"] = sourced.basis;
    }
    return json;
}

/// Describes the side from which the image is viewed (FORMATS §1), i.e. the sign of fx.
std::string shownFrom(const core::CArm& cArm)
{
    const std::string basis = cArm.mirrored.value ? originText(cArm.mirrored.origin) + ", " + cArm.mirrored.basis
                                                  : "assumed, not in the header";
    return (cArm.mirrored.value.value_or(false) ? "mirrored, as seen from the source, fx > 0 ("
                                                : "as seen from the detector, fx < 0 (") +
           basis + ")";
}

Json cameraJson(const core::ProjectionCamera& camera)
{
    return {{"fx", camera.fx}, {"fy", camera.fy}, {"cx", camera.cx}, {"cy", camera.cy}};
}

/// Lists each C-arm value with its origin, the resulting camera, contradictory and missing values, and every geometry
/// element of the image header.
Json geometryJson(const core::CArm& cArm, const core::Angiogram& angiogram)
{
    Json json{
        {"sourceToDetectorMm", sourcedJson(cArm.sourceToDetectorMm)},
        {"sourceToIsocenterMm", sourcedJson(cArm.sourceToIsocenterMm)},
        {"sourceToObjectMm", sourcedJson(cArm.sourceToObjectMm)},
        {"columnSpacingMm", sourcedJson(cArm.columnSpacingMm)},
        {"rowSpacingMm", sourcedJson(cArm.rowSpacingMm)},
        {"primaryAngleDeg", sourcedJson(cArm.primaryAngleDeg)},
        {"secondaryAngleDeg", sourcedJson(cArm.secondaryAngleDeg)},
        {"rollDeg", sourcedJson(cArm.rollDeg)},
        {"principalPointPx", sourcedJson(cArm.principalPointPx)},
        {"isocentreInPatientMm", sourcedJson(cArm.isocenterInPatientMm)},
        {"mirrored", cArm.mirrored.value.value_or(false)},
        {"shown", shownFrom(cArm)},
    };
    if (const auto& depth = vesselDepthOf(cArm).value; cArm.sourceToDetectorMm.value && depth) {
        json["magnification"] = *cArm.sourceToDetectorMm.value / *depth;
    }
    const auto camera = core::cameraFromCArm(cArm, angiogram.width(), angiogram.height());
    if (camera) {
        json["camera"] = cameraJson(camera.value());
    } else {
        json["cameraMissing"] = camera.error().message.text();
    }
    const core::Messages contradictions =
        core::findContradictions(cArm, angiogram.gantry, {angiogram.width(), angiogram.height()});
    const core::Messages missing = core::findMissingGeometry(cArm);
    json["contradictions"] = io::sentencesOf(contradictions);
    json["missing"] = io::sentencesOf(missing);
    json["messages"] = Json::array();
    for (const core::Messages& each : {contradictions, missing}) {
        for (const core::Message& message : each) {
            json["messages"].push_back(Json::parse(io::messageJson(message)));
        }
    }
    if (const auto& table = angiogram.gantry.table) {
        const Eigen::Vector3d& isocenter = table->isocenterInPatientMm;
        json["isocenterByTableMm"] = {isocenter.x(), isocenter.y(), isocenter.z()};
    }
    json["tableMovesDuringRun"] = angiogram.gantry.tableMoves;
    json["turnsDuringRun"] = !angiogram.gantry.angleIncrementsDeg.empty();
    Json& header = json["header"] = Json::object();
    for (const core::HeaderTag& tag : angiogram.gantry.tags) {
        header[tag.tag + " " + tag.name] = tag.value;
    }
    return json;
}

std::string extensionOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension;
}

Json angiogramJson(const core::Angiogram& angiogram)
{
    Json json{{"kind", "angiogram"},
              {"width", angiogram.width()},
              {"height", angiogram.height()},
              {"frames", angiogram.frameCount()},
              {"suggestedFrame", angiogram.suggestedFrame},
              {"vessels", angiogram.polarity == core::Polarity::VesselsDark ? "dark" : "bright"},
              {"frameTimeMs", angiogram.frameTimeMs},
              {"rWaveFrames", angiogram.rWaveFrames},
              {"geometry", geometryJson(angiogram.cArm, angiogram)}};
    addWarnings(json, angiogram.warnings);
    return json;
}

Json treeJson(const core::VesselTree& tree)
{
    double lengthMm = 0.0;
    Json branches = Json::array();
    for (const core::VesselBranch& branch : tree.branches) {
        lengthMm += branch.lengthMm();
        branches.push_back({{"id", branch.id},
                            {"name", branch.name},
                            {"points", branch.pointsInPatient.size()},
                            {"lengthMm", branch.lengthMm()},
                            {"hasRadius", !branch.radiusMm.empty()}});
    }
    const auto nodes = core::findNodes(tree);
    const auto bifurcations =
        std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return node.isBifurcation(); });
    const Eigen::Vector3d centroid = core::centroidInPatient(tree);
    return {{"kind", "vessel tree"},
            {"points", tree.pointCount()},
            {"lengthMm", lengthMm},
            {"bifurcations", bifurcations},
            {"ends", static_cast<long>(nodes.size()) - bifurcations},
            {"centroidInPatientMm", {centroid.x(), centroid.y(), centroid.z()}},
            {"branches", branches}};
}

core::Result<Json> treeFileJson(const std::string& path)
{
    const auto read = io::readTree(path);
    if (!read) {
        return read.error();
    }
    Json json = treeJson(read.value().tree);
    addWarnings(json, read.value().warnings);
    return json;
}

Json resultJson(const core::RegistrationResult& result)
{
    Json json{{"method", result.method},
              {"medianProjectionDistancePx", result.metrics.medianPx},
              {"trustworthy", result.trustworthy}};
    if (!result.provenance.time.empty()) {
        json["time"] = result.provenance.time;
    }
    return json;
}

Json caseJson(const core::Case& session, const core::Messages& warnings)
{
    Json json{{"kind", "case"}, {"title", session.title}, {"frame", session.shown().frame}};
    if (session.vessels.tree) {
        json["tree"] = treeJson(*session.vessels.tree);
    }
    if (session.shown().angiogram) {
        json["angiogram"] = angiogramJson(*session.shown().angiogram);
        json["angiogram"]["geometry"] = geometryJson(session.shown().geometry.cArm, *session.shown().angiogram);
    }
    if (const auto camera = core::cameraOf(session.shown()); camera) {
        json["camera"] = cameraJson(camera.value());
        json["camera"]["origin"] = session.shown().geometry.cameraOverride ? "user" : "derived";
    }
    json["startPose"] = session.shown().initialCameraFromPatient ? "given" : "from the angles";
    json["pose"] = session.shown().result                                    ? "registered"
                   : core::isAtInitialPose(session.shown(), session.vessels) ? "at its start"
                                                                             : "set otherwise";
    if (const auto& result = session.shown().result) {
        json["result"] = resultJson(*result);
    }
    addWarnings(json, warnings);
    return json;
}

core::Result<Json> caseFileJson(const std::string& path)
{
    core::Messages warnings;
    const auto loaded = io::openCase(path, warnings);
    return loaded ? core::Result<Json>(caseJson(loaded.value(), warnings)) : loaded.error();
}

Json curvesJson(const core::Centerline2d& centerline)
{
    return {{"kind", "2-D centreline"}, {"curves", centerline.curves.size()}, {"points", centerline.pointCount()}};
}

Json poseJson(const io::PoseWithCamera& pose)
{
    Json json{{"kind", "pose"}};
    if (pose.camera) {
        json["camera"] = cameraJson(*pose.camera);
        json["camera"]["shownFrom"] = pose.camera->fx < 0.0 ? "detector" : "source";
        if (pose.camera->width > 0) {
            json["camera"]["width"] = pose.camera->width;
            json["camera"]["height"] = pose.camera->height;
        }
    }
    return json;
}

Json pointsJson(const std::vector<io::Fiducial>& points)
{
    Json json{{"kind", "points"}, {"points", Json::array()}};
    for (const io::Fiducial& point : points) {
        const Eigen::Vector3d& at = point.pointInPatient;
        json["points"].push_back({{"name", point.name}, {"pointInPatientMm", {at.x(), at.y(), at.z()}}});
    }
    return json;
}

/// Describes a pose or, if the file is JSON, points or curves from 3D Slicer; other transform files can only be poses.
core::Result<Json> poseOrTreeJson(const std::string& path, const std::string& extension)
{
    const auto pose = io::readPoseWithCamera(path);
    if (pose) {
        return poseJson(pose.value());
    }
    if (const auto points = io::readFiducials(path); points && io::isFiducialFile(path)) {
        return pointsJson(points.value());
    }
    if (extension != ".json") {
        return pose.error();
    }
    return treeFileJson(path);
}

/// Describes centerlines, a surface, or a table of 2-D curves.
core::Result<Json> curvesOrSurfaceJson(const std::string& path, const std::string& extension)
{
    auto tree = treeFileJson(path);
    if (tree) {
        return tree;
    }
    if (extension == ".csv") {
        const auto curves = io::readCenterline2d(path);
        return curves ? core::Result<Json>(curvesJson(curves.value())) : tree.error();
    }
    auto surface = surfaceJson(path);
    return surface ? surface : tree.error();
}

/// Describes an image. DICOM projections are angiograms; slices with a patient position form a volume.
core::Result<Json> imageJson(const std::string& path)
{
    if (io::isDicomSegmentation(path)) {
        return segmentationJson(path);
    }
    const auto angiogram = io::readAngiogram(path);
    if (const auto slices = io::readSliceRecords(path); slices && !slices.value().slices.empty()) {
        if (slices.value().slices.front().position && !slices.value().isProjection) {
            return angiogram ? dicomVolumeJson(path) : angiogram.error();
        }
    }
    return angiogram ? core::Result<Json>(angiogramJson(angiogram.value())) : angiogram.error();
}

core::Error unknownFile(const std::string& path)
{
    const auto input = io::openInput(path);
    if (!input) {
        return input.error();
    }
    const auto* found = io::describeContent(input.value().view());
    return (found == nullptr ? messages::infoUnknown() : messages::infoOther((*found)())).about(path);
}

core::Result<Json> describe(const std::string& path)
{
    if (io::isFolder(path)) {
        return folderJson(path);
    }
    if (io::isVolumeFile(path)) {
        return volumeJson(path);
    }
    const std::string extension = extensionOf(path);
    if (extension == ".angiopose") {
        return caseFileJson(path);
    }
    if (extension == ".stl" || extension == ".ply" || extension == ".obj") {
        return surfaceJson(path);
    }
    const bool isPoseName = extension == ".json" || extension == ".tfm" || extension == ".mat" || extension == ".h5" ||
                            extension == ".fcsv";
    const bool isText = extension == ".txt" || extension == ".yml" || extension == ".yaml" || extension == ".xml";
    if (isPoseName || (isText && io::inputKindOf(path))) {
        return poseOrTreeJson(path, extension);
    }
    const bool isTree =
        extension == ".vtp" || extension == ".vtk" || extension == ".vtu" || extension == ".swc" || extension == ".csv";
    if (isTree || io::looksLikeImageFile(path)) {
        return isTree ? curvesOrSurfaceJson(path, extension) : imageJson(path);
    }
    return unknownFile(path);
}

void printField(std::string label, const std::string& text)
{
    label.resize(std::max<std::size_t>(label.size(), 24), ' ');
    printText(label + " " + text);
}

/// Prints JSON as indented, human-readable "key: value" lines.
void printReadable(const Json& json, int indent)
{
    for (const auto& [key, value] : json.items()) {
        if (key == "messages") {   // already printed as `warnings`
            continue;
        }
        const std::string label =
            std::string(static_cast<std::size_t>(indent), ' ') + (json.is_array() ? "-" : key + ":");
        if (value.is_object() && value.contains("origin") && value.contains("value")) {
            const std::string number = value["value"].is_null()     ? "missing"
                                       : value["value"].is_number() ? fixedText(value["value"].get<double>(), 4)
                                                                    : value["value"].dump();
            const std::string basis = value.contains("basis") ? ", " + value["basis"].get<std::string>() : "";
            const std::string origin =
                value["value"].is_null() ? "" : " (" + value["origin"].get<std::string>() + basis + ")";
            printField(label, number + origin);
        } else if (value.is_structured()) {
            if (!value.empty()) {
                printText(label);
                printReadable(value, indent + 2);
            }
        } else {
            const std::string text = value.is_string()         ? value.get<std::string>()
                                     : value.is_number_float() ? fixedText(value.get<double>(), 3)
                                                               : value.dump();
            printField(label, text);
        }
    }
}

}   // namespace

int runInfo(const FileArguments& arguments)
{
    if (io::isDicomDirectory(arguments.path)) {
        return runStudies(arguments);
    }
    const auto description = describe(arguments.path);
    if (!description) {
        return reportInputError(description.error(), arguments.format);
    }
    if (arguments.format == OutputFormat::Json) {
        std::puts(description.value().dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        printReadable(description.value(), 0);
    }
    return exitSuccess;
}

}   // namespace angiopose::app
