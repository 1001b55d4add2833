#include "app/cli/register_case.h"

#include "app/cli/console.h"
#include "app/messages/says.h"
#include "app/texts/number_text.h"
#include "app/texts/overlay_picture.h"
#include "core/case/registration_input.h"
#include "core/registration/option_text.h"
#include "io/image_file.h"
#include "io/pose_file.h"
#include "io/result_file.h"

#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::Result<core::RegistrationResult> registerWithProgress(const core::RegistrationInput& input,
                                                            const core::RegistrationOptions& options,
                                                            const std::string& label)
{
    ProgressLine progress(label);
    return core::registerVessels(input, options, [&progress](const core::IterationReport& report) {
        progress.show(report.progress,
                      std::string(report.stage) + ", median " + fixedText(report.medianDistancePx, 2) + " px");
        return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
    });
}

core::Result<core::PoseLocks> locksFrom(const std::vector<std::string>& ids)
{
    core::PoseLocks locks{};
    for (const std::string& id : ids) {
        const auto axis = core::poseAxisFrom(id);
        if (axis) {
            locks[static_cast<std::size_t>(*axis)] = true;
        } else if (id != "none") {
            return core::Error(says::noSuchFreedom(id, core::poseAxisIds()));
        }
    }
    return locks;
}

}   // namespace

core::Status applyArguments(core::Case& theCase, const RegisterArguments& arguments)
{
    if (!arguments.method.empty()) {
        theCase.options.method = arguments.method;
    }
    for (const std::string& assignment : arguments.options) {
        if (const auto status = core::setOption(theCase.options, assignment); !status) {
            return status.error();
        }
    }
    if (!arguments.locks.empty()) {
        const auto locks = locksFrom(arguments.locks);
        if (!locks) {
            return locks.error();
        }
        theCase.options.locks = locks.value();
    }
    if (const auto problem = core::findProblem(theCase.options)) {
        return core::Error(*problem);
    }
    if (!arguments.auxiliaryBranchIds.empty()) {
        theCase.vessels.auxiliaryBranchIds = arguments.auxiliaryBranchIds;
    }
    if (!arguments.excludedBranchIds.empty()) {
        theCase.vessels.excludedBranchIds = arguments.excludedBranchIds;
    }
    return core::Done{};
}

core::Result<RegisteredCase> registerCase(core::Case theCase, const std::string& label)
{
    auto target = core::targetOf(theCase.shown());
    if (!target) {
        return target.error();
    }
    const auto input = core::registrationInputOf(theCase, target.value());
    if (!input) {
        return input.error();
    }
    auto result = registerWithProgress(input.value(), theCase.options, label);
    if (!result) {
        return result.error();
    }
    theCase.shown().cameraFromPatient = result.value().cameraFromPatient;
    theCase.shown().result = std::move(result).value();
    return RegisteredCase{std::move(theCase), std::move(target).value()};
}

core::Status writeOutputs(const RegisteredCase& registered, const std::string& folderName)
{
    const core::Case& theCase = registered.theCase;
    const fs::path folder(folderName);
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error(says::folderNotMade(folder.string(), failure.message()));
    }
    if (auto status = io::writeResult(theCase, *theCase.shown().result, (folder / "result.json").string()); !status) {
        return status;
    }
    if (auto status = io::writePose(theCase.shown().cameraFromPatient, (folder / "pose.tfm").string()); !status) {
        return status;
    }
    const auto picture = drawOverlay(theCase, registered.target);
    if (!picture) {
        return picture.error();
    }
    return io::writePng(picture.value(), (folder / "overlay.png").string(), provenanceTexts(theCase));
}

}   // namespace angiopose::app