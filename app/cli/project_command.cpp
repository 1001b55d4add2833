#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/messages/says.h"
#include "app/texts/picture_file.h"
#include "io/pose_file.h"

#include <cstdio>

namespace angiopose::app {
namespace {

PictureContent contentOf(const ProjectArguments& arguments)
{
    return arguments.is16Bit        ? PictureContent::Frame16
           : arguments.isFrameAlone ? PictureContent::Frame
                                    : PictureContent::Overlay;
}

}   // namespace

int runProject(const ProjectArguments& arguments)
{
    auto loaded = loadCaseForCommand(arguments.casePath, arguments.frame);
    if (!loaded) {
        return failInput(loaded.error());
    }
    core::Case theCase = std::move(loaded).value();
    if (!arguments.posePath.empty()) {
        const auto pose = io::readPose(arguments.posePath);
        if (!pose) {
            return failInput(pose.error());
        }
        theCase.shown().cameraFromPatient = pose.value();
        theCase.shown().result.reset();
    }
    const core::View& shown = theCase.shown();
    if (arguments.isMotionColored && !drawableBend(shown, theCase.vessels, shown.cameraFromPatient)) {
        return failInput(core::Error(says::noBentVessels().about(arguments.casePath)));
    }
    OverlayPictureOptions options;
    options.widthPx = arguments.widthPx;
    options.coloring = arguments.isMotionColored ? OverlayColoring::Motion : OverlayColoring::Branches;
    options.shape = arguments.isRigid ? VesselShape::Rigid : VesselShape::Bent;
    options.depthCue = arguments.depthCue ? ui::DepthCue::NearBright : ui::DepthCue::None;
    if (arguments.swipePx) {
        options.cutout = {ui::Cutout::Shape::RightOf, {*arguments.swipePx, 0.0}, 0.0};
    }
    options.isStartBeside = arguments.startBeside;
    const PictureFile file{contentOf(arguments), arguments.dotsPerInch};
    if (const auto status = writePictureFile(theCase, {}, options, file, arguments.outputPath); !status) {
        return failInput(status.error());
    }
    std::printf("%s\n", arguments.outputPath.c_str());
    return exitDone;
}

}   // namespace angiopose::app