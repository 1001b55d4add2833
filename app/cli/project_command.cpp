#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/messages/messages.h"
#include "app/texts/image_file.h"
#include "core/case/initial_pose.h"
#include "core/case/registration_input.h"
#include "io/pose_camera_file.h"

#include <cstdio>

namespace angiopose::app {
namespace {

ImageFileContent contentOf(const ProjectArguments& arguments)
{
    return arguments.is16Bit     ? ImageFileContent::Frame16
           : arguments.frameOnly ? ImageFileContent::Frame
                                 : ImageFileContent::Overlay;
}

/// Sets the pose of the view from a file, and also the camera if that of the file differs.
core::Status takePose(core::View& view, const std::string& path)
{
    const auto read = io::readPoseWithCamera(path);
    if (!read) {
        return read.error();
    }
    view.cameraFromPatient = read.value().cameraFromPatient;
    view.result.reset();
    if (!read.value().camera || !view.angiogram) {
        return core::Done{};
    }
    const int width = view.angiogram->width(), height = view.angiogram->height();
    core::ProjectionCamera camera = *read.value().camera;
    if (!io::fitsImage(camera, width, height)) {
        return core::Error(messages::poseOtherImage(camera.width, camera.height, width, height).about(path));
    }
    camera.width = width;
    camera.height = height;
    const auto own = core::cameraOf(view);
    if (!own || !io::isSameCamera(own.value(), camera)) {
        printWarnings({messages::poseOtherCamera().about(path)});
        view.geometry.cameraOverride = camera;
    }
    return core::Done{};
}

/// Returns the traced vessels to which the residual colors of a registered pose refer; empty for other poses, or if
/// nothing can be traced.
core::Centerline2d targetToColorBy(const core::View& view)
{
    const auto traced = core::resultOfShownFrame(view) ? core::targetOf(view) : core::Result<core::Centerline2d>({});
    return traced ? traced.value() : core::Centerline2d();
}

/// Explains why no vessels are visible; nullopt if some of them are.
std::optional<core::Message> invisibleVesselsMessage(const core::View& view, const core::VesselTree& tree)
{
    const auto camera = core::cameraOf(view);
    bool isProjected = !camera;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const auto pixel = camera ? core::project(camera.value(), view.cameraFromPatient * point) : std::nullopt;
            isProjected = isProjected || pixel;
            if (pixel && pixel->x() > -0.5 && pixel->y() > -0.5 && pixel->x() < camera.value().width - 0.5 &&
                pixel->y() < camera.value().height - 0.5) {
                return std::nullopt;
            }
        }
    }
    return !isProjected ? std::optional(messages::allBehindSource())
           : camera     ? std::optional(messages::allOutsideImage())
                        : std::nullopt;
}

}   // namespace

int runProject(const ProjectArguments& arguments)
{
    auto loaded = arguments.from.path.empty()
                      ? loadCaseForCommand(arguments.casePath, arguments.frame)
                      : loadResultForCommand(arguments.from, ResultState::Registered, arguments.frame);
    if (!loaded) {
        return reportInputError(loaded.error());
    }
    core::Case session = std::move(loaded).value();
    if (!arguments.posePath.empty()) {
        if (const auto poseStatus = takePose(session.shown(), arguments.posePath); !poseStatus) {
            return reportInputError(poseStatus.error());
        }
    }
    const core::View& shown = session.shown();
    if (arguments.isMotionColored && !deformationForPose(shown, session.vessels, shown.cameraFromPatient)) {
        return reportInputError(core::Error(messages::noDeformedVessels().about(arguments.casePath)));
    }
    const bool isDrawn = !arguments.frameOnly && !arguments.is16Bit && session.vessels.tree;
    if (const auto unseen = isDrawn ? invisibleVesselsMessage(shown, *session.vessels.tree) : std::nullopt) {
        const std::string& path = arguments.posePath.empty() ? arguments.casePath : arguments.posePath;
        if (unseen->is(messages::allBehindSource)) {
            return reportInputError(core::Error(unseen->about(path)));
        }
        printWarnings({unseen->about(path)});
    }
    if (isDrawn && core::isAtInitialPose(shown, session.vessels)) {
        printWarnings({messages::drawnAtStart().about(arguments.casePath)});
    }
    const core::Centerline2d target = targetToColorBy(shown);
    OverlayImageOptions options;
    options.widthPx = arguments.widthPx;
    options.coloring = arguments.isMotionColored ? OverlayColoring::Motion
                       : target.curves.empty()   ? OverlayColoring::Branches
                                                 : OverlayColoring::Residuals;
    options.shape = arguments.isRigid ? VesselShape::Rigid : VesselShape::Deformed;
    options.depthCue = arguments.depthCue ? ui::DepthCue::NearBright : ui::DepthCue::None;
    if (arguments.swipePx) {
        options.cutout = {ui::Cutout::Shape::RightOf, {*arguments.swipePx, 0.0}, 0.0};
    }
    options.isInitialPoseShown = arguments.showInitialPose;
    const ImageFileOptions file{contentOf(arguments), arguments.dotsPerInch};
    if (const auto status = writeImageFile(session, target, options, file, arguments.outputPath); !status) {
        return reportInputError(status.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitSuccess;
}

}   // namespace angiopose::app
