#include "app/cli/convert_exchange.h"

#include "app/cli/case_input.h"
#include "app/messages/messages.h"
#include "core/exchange/projection_matrix.h"
#include "io/camera_pose_file.h"
#include "io/case_points.h"
#include "io/fiducial_file.h"
#include "io/messages/messages.h"
#include "io/pose_camera_file.h"
#include "io/pose_convention_file.h"
#include "io/pose_file.h"
#include "io/support/atomic_file.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/volume_file.h"

#include <cstdio>
#include <filesystem>
#include <map>

namespace angiopose::app {
namespace {

using core::RigidTransform;
using core::Status;
using io::PoseWithCamera;

constexpr double usualSourceToDetectorMm = 1000.0;   // arbitrary: only its ratio to the pixel spacing matters

bool isCasePath(const std::string& path)
{
    return io::extensionOf(path) == ".angiopose";
}

bool hasCameraFormat(const std::string& path)
{
    const std::string extension = io::extensionOf(path);
    return extension == ".txt" || extension == ".yml" || extension == ".yaml" || extension == ".xml";
}

bool isPoseFormat(const std::string& path)
{
    const std::string extension = io::extensionOf(path);
    return extension == ".json" || extension == ".tfm" || extension == ".h5";
}

/// A pose and the other data exchanged with it.
struct ExchangedPose {
    PoseWithCamera pose;
    std::optional<double> sourceToDetectorMm;
};

core::Result<ExchangedPose> poseOfCase(const std::string& path)
{
    const auto loaded = loadCaseForCommand(path, std::nullopt);
    if (!loaded) {
        return loaded.error();
    }
    const core::View& shown = loaded.value().shown();
    const auto camera = core::cameraOf(shown);
    if (!camera) {
        return camera.error().about(path);
    }
    return ExchangedPose{{shown.cameraFromPatient, camera.value()}, shown.geometry.cArm.sourceToDetectorMm.value};
}

core::Result<ExchangedPose> readOwn(const std::string& path)
{
    if (isCasePath(path)) {
        return poseOfCase(path);
    }
    const auto read = io::readPoseWithCamera(path);
    return read ? core::Result<ExchangedPose>(ExchangedPose{read.value(), std::nullopt}) : read.error();
}

/// Reads the camera that replaces that of the input; nullopt if the arguments name none.
core::Result<std::optional<ExchangedPose>> readGivenCamera(const ExchangeArguments& exchange)
{
    if (exchange.cameraPath.empty()) {
        return std::optional<ExchangedPose>();
    }
    auto read = readOwn(exchange.cameraPath);
    if (!read) {
        return read.error();
    }
    if (!read.value().pose.camera) {
        return core::Error(io::messages::exchangeNoCamera().about(exchange.cameraPath));
    }
    return std::optional(std::move(read).value());
}

core::Result<ExchangedPose> readXreg(const std::string& path, std::optional<ExchangedPose> camera)
{
    const auto volumeFromWorld = io::readPose(path);
    if (!volumeFromWorld) {
        return volumeFromWorld.error();
    }
    if (!camera) {
        printWarnings({messages::convertXregGuessed().about(path)});
    }
    const core::XregCamera theirs = camera ? core::xregCamera(*camera->pose.camera, usualSourceToDetectorMm)
                                           : core::xregCamera({-1.0, 1.0, 0.0, 0.0, 0, 0}, usualSourceToDetectorMm);
    const auto posedCamera = core::posedCameraFromXreg(theirs, volumeFromWorld.value());
    if (!posedCamera) {
        return posedCamera.error().about(path);
    }
    ExchangedPose read = camera.value_or(ExchangedPose{});
    read.pose.cameraFromPatient = posedCamera.value().cameraFromPatient;
    return read;
}

/// Returns the midpoint between the centers of the outermost voxels, which torchio defines as the volume center.
core::Result<std::optional<Eigen::Vector3d>> volumeCenter(const ExchangeArguments& exchange)
{
    if (exchange.volumePath.empty()) {
        return std::optional<Eigen::Vector3d>();
    }
    const auto read = io::readVolume(exchange.volumePath);
    if (!read) {
        return read.error();
    }
    const core::VolumeGeometry& grid = read.value().volume.geometry;
    const Eigen::Vector3d last = (grid.size.cast<double>().array() - 1.0).matrix();
    return std::optional<Eigen::Vector3d>(grid.originInPatient +
                                          grid.direction * (0.5 * last.cwiseProduct(grid.spacingMm)));
}

core::Result<ExchangedPose> readFromDiffDrr(const std::string& path, const ExchangeArguments& exchange)
{
    auto parts = io::readDiffDrr(path);
    if (!parts) {
        return parts.error();
    }
    io::DiffDrrParts view = std::move(parts).value();
    if (!exchange.cameraPath.empty()) {
        const auto detector = io::readDiffDrr(exchange.cameraPath);
        if (!detector) {
            return detector.error();
        }
        view.detector = detector.value().detector;
    }
    const auto center = volumeCenter(exchange);
    if (!center) {
        return center.error();
    }
    if (center.value()) {
        view.volumeCenterInPatient = center.value();
    }
    const auto posedCamera = io::posedCameraFrom(view);
    if (!posedCamera) {
        return posedCamera.error().about(path);
    }
    return ExchangedPose{{posedCamera.value().cameraFromPatient, posedCamera.value().camera}, view.detector->sddMm};
}

core::Result<ExchangedPose> readExchanged(const std::string& path, const ExchangeArguments& exchange)
{
    if (exchange.from == PoseConvention::DiffDrr) {
        return readFromDiffDrr(path, exchange);
    }
    auto camera = readGivenCamera(exchange);
    if (!camera) {
        return camera.error();
    }
    if (exchange.from == PoseConvention::Xreg) {
        return readXreg(path, std::move(camera).value());
    }
    auto read = readOwn(path);
    if (read && camera.value()) {
        ExchangedPose pose = std::move(read).value();
        pose.pose.camera = camera.value()->pose.camera;
        pose.sourceToDetectorMm = camera.value()->sourceToDetectorMm;
        return pose;
    }
    return read;
}

Status writeXreg(const ExchangedPose& pose, const std::string& path)
{
    const core::ProjectionCamera camera = pose.pose.camera.value_or(core::ProjectionCamera{-1.0, 1.0, 0.0, 0.0, 0, 0});
    const auto theirs = core::xregPose(pose.pose.cameraFromPatient, core::xregCamera(camera, usualSourceToDetectorMm));
    return theirs ? io::writePose(theirs.value(), path) : Status(theirs.error().about(path));
}

Status writeToDiffDrr(const ExchangedPose& pose, const std::string& path, const ExchangeArguments& exchange)
{
    if (!pose.pose.camera || pose.pose.camera->width == 0) {
        return core::Error(io::messages::exchangeNoCamera().about(path));
    }
    const auto center = volumeCenter(exchange);
    if (!center) {
        return center.error();
    }
    const double known = pose.sourceToDetectorMm.value_or(usualSourceToDetectorMm);
    const double sdd = exchange.sourceToDetectorMm > 0.0 ? exchange.sourceToDetectorMm : known;
    return io::writeDiffDrr(core::diffDrrView({*pose.pose.camera, pose.pose.cameraFromPatient}, sdd,
                                              center.value().value_or(Eigen::Vector3d::Zero())),
                            path);
}

Status writeOwn(const PoseWithCamera& pose, const std::string& path)
{
    if (pose.camera && pose.camera->width > 0 && io::extensionOf(path) == ".json") {
        return io::writeAtomically(path, io::cameraPoseText(pose.cameraFromPatient, *pose.camera));
    }
    return io::writePose(pose.cameraFromPatient, path);
}

Status writeExchanged(const ExchangedPose& pose, const std::string& path, const ExchangeArguments& exchange)
{
    if (exchange.to == PoseConvention::Xreg) {
        return writeXreg(pose, path);
    }
    if (exchange.to == PoseConvention::DiffDrr) {
        return writeToDiffDrr(pose, path, exchange);
    }
    if (exchange.to == PoseConvention::AngioPose && isPoseFormat(path)) {
        return writeOwn(pose.pose, path);
    }
    return pose.pose.camera ? io::writePosedCamera({*pose.pose.camera, pose.pose.cameraFromPatient}, path)
                            : Status(core::Error(io::messages::exchangeNoCamera().about(path)));
}

core::Result<std::vector<io::Fiducial>> pointsOfCase(const std::string& path)
{
    const auto loaded = loadCaseForCommand(path, std::nullopt);
    if (!loaded) {
        return loaded.error();
    }
    const std::vector<io::Fiducial> points = io::caseFiducials(loaded.value());
    return points.empty()
               ? core::Result<std::vector<io::Fiducial>>(core::Error(messages::convertNoPoints().about(path)))
               : points;
}

bool isPointsConversion(const ConvertArguments& arguments)
{
    const std::string out = io::toLower(arguments.outputPath);
    return out.ends_with(".fcsv") ||
           (out.ends_with(".mrk.json") && (isCasePath(arguments.inputPath) || io::isFiducialFile(arguments.inputPath)));
}

Status convertPoints(const ConvertArguments& arguments)
{
    const auto points =
        isCasePath(arguments.inputPath) ? pointsOfCase(arguments.inputPath) : io::readFiducials(arguments.inputPath);
    return points ? io::writeFiducials(points.value(), arguments.outputPath) : points.error();
}

Status convertExchanged(const ConvertArguments& arguments, const ExchangeArguments& exchange)
{
    if (isPointsConversion(arguments)) {
        return convertPoints(arguments);
    }
    const auto pose = readExchanged(arguments.inputPath, exchange);
    return pose ? writeExchanged(pose.value(), arguments.outputPath, exchange) : Status(pose.error());
}

}   // namespace

std::shared_ptr<ExchangeArguments> addExchangeOptions(CLI::App& command)
{
    auto exchange = std::make_shared<ExchangeArguments>();
    const std::map<std::string, PoseConvention> conventions{{"angiopose", PoseConvention::AngioPose},
                                                            {"opencv", PoseConvention::OpenCv},
                                                            {"xreg", PoseConvention::Xreg},
                                                            {"diffdrr", PoseConvention::DiffDrr}};
    const auto checked =
        CLI::CheckedTransformer(conventions, CLI::ignore_case).description("{angiopose,opencv,xreg,diffdrr}");
    command.add_option("--pose-from", exchange->from, "Pose convention of the input")->transform(checked);
    command.add_option("--pose-to", exchange->to, "Pose convention of the output")->transform(checked);
    command.add_option("--camera", exchange->cameraPath,
                       "Camera for the pose: a case, or a pose file that contains a camera");
    command.add_option("--volume", exchange->volumePath,
                       "Volume whose center is the origin of the DiffDRR coordinate system");
    command.add_option("--source-to-detector", exchange->sourceToDetectorMm, "SID in mm to write for DiffDRR")
        ->check(CLI::Range(100.0, 10000.0));
    return exchange;
}

bool isExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange)
{
    if (arguments.identity && arguments.identity->isRequested) {
        return false;
    }
    const bool isForeign = exchange.from != PoseConvention::AngioPose || exchange.to != PoseConvention::AngioPose;
    const bool isOfCase = isCasePath(arguments.inputPath) && isPoseFormat(arguments.outputPath);
    return isForeign || isOfCase || !exchange.cameraPath.empty() || hasCameraFormat(arguments.outputPath) ||
           isPointsConversion(arguments);
}

int runExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange)
{
    std::error_code absent;
    if (std::filesystem::equivalent(arguments.inputPath, arguments.outputPath, absent)) {
        return reportInputError(messages::convertOntoInput().about(arguments.outputPath));
    }
    if (const Status converted = convertExchanged(arguments, exchange); !converted) {
        return reportInputError(converted.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitSuccess;
}

}   // namespace angiopose::app
