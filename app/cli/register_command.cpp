#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/number_text.h"
#include "app/overlay_picture.h"
#include "core/registration/option_text.h"
#include "core/registration/registration.h"
#include "io/image_file.h"
#include "io/pose_file.h"
#include "io/result_file.h"

#include <cstdio>
#include <filesystem>

namespace app {
namespace {

namespace fs = std::filesystem;

core::Status applyArguments(core::RegistrationCase& registrationCase, const RegisterArguments& arguments)
{
    if (!arguments.method.empty()) {
        registrationCase.options.method = arguments.method;
    }
    for (const std::string& assignment : arguments.options) {
        if (const auto status = core::setOption(registrationCase.options, assignment); !status) {
            return status;
        }
    }
    if (const std::string problem = core::findProblem(registrationCase.options); !problem.empty()) {
        return core::Error{problem};
    }
    if (!arguments.auxiliaryBranchIds.empty()) {
        registrationCase.auxiliaryBranchIds = arguments.auxiliaryBranchIds;
    }
    if (!arguments.excludedBranchIds.empty()) {
        registrationCase.excludedBranchIds = arguments.excludedBranchIds;
    }
    return core::Done{};
}

std::string outputFolderOf(const RegisterArguments& arguments)
{
    return arguments.outputFolder.empty() ? fs::path(arguments.casePath).stem().string() + "-registered"
                                          : arguments.outputFolder;
}

core::Status writeOutputs(const core::RegistrationCase& registrationCase, const core::Centerline2d& target,
                          const fs::path& folder)
{
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error{"The folder '" + folder.string() + "' cannot be made: " + failure.message() + "."};
    }
    if (auto status = io::writeResult(registrationCase, *registrationCase.result, (folder / "result.json").string());
        !status) {
        return status;
    }
    if (auto status = io::writePose(registrationCase.cameraFromPatient, (folder / "pose.tfm").string()); !status) {
        return status;
    }
    const auto picture = drawOverlay(registrationCase, target);
    if (!picture) {
        return picture.error();
    }
    return io::writePng(picture.value(), (folder / "overlay.png").string(), provenanceTexts(registrationCase));
}

void printLine(const std::string& label, const std::string& text)
{
    std::printf("%-14s %s\n", label.c_str(), text.c_str());
}

void printSummary(const core::RegistrationResult& result, const std::string& folder)
{
    const core::DistanceMetrics& metrics = result.metrics;
    printLine("method", result.method);
    printLine("stopped", std::string(core::toText(result.stopReason)) + " after " + std::to_string(result.iterations) +
                             " iterations, " + fixedText(result.time.totalMs, 1) + " ms");
    printLine("distance", "median " + fixedText(metrics.medianPx, 2) + " px (" + fixedText(metrics.medianMm, 2) +
                              " mm), 95 % " + fixedText(metrics.p95Px, 2) + " px");
    printLine("covered", fixedText(100.0 * metrics.coverage, 0) + " % of the traced vessels");
    printLine("uncertainty", "in plane ±" + fixedText(result.uncertainty.inPlaneMm, 2) + " mm, depth ±" +
                                 fixedText(result.uncertainty.depthMm, 1) + " mm, rotation ±" +
                                 fixedText(result.uncertainty.rotationDeg.maxCoeff(), 2) + "°");
    printLine("trustworthy", result.trustworthy ? "yes" : "NO");
    for (const std::string& warning : result.warnings) {
        printLine("", warning);
    }
    printLine("written", (fs::path(folder) / "overlay.png").string() + ", result.json, pose.tfm");
}

core::Result<core::RegistrationResult> registerWithProgress(const core::RegistrationInput& input,
                                                            const core::RegistrationOptions& options)
{
    ProgressLine progress("registering");
    return core::registerVessels(input, options, [&progress](const core::IterationReport& report) {
        progress.show(report.progress,
                      std::string(report.stage) + ", median " + fixedText(report.medianDistancePx, 2) + " px");
        return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
    });
}

int exitCodeOf(const core::RegistrationResult& result)
{
    if (result.stopReason == core::StopReason::StoppedByUser) {
        return exitStopped;
    }
    return result.trustworthy ? exitDone : exitNotTrustworthy;
}

}   // namespace

int runRegister(const RegisterArguments& arguments)
{
    auto loaded = loadCaseForCommand(arguments.casePath, arguments.frame);
    if (!loaded) {
        return failInput(loaded.error().message);
    }
    core::RegistrationCase registrationCase = std::move(loaded).value();
    if (const auto status = applyArguments(registrationCase, arguments); !status) {
        printMessage(status.error().message);
        return exitUsage;
    }
    auto target = core::targetOf(registrationCase);
    if (!target) {
        return failInput(arguments.casePath + ": " + target.error().message);
    }
    const auto input = core::registrationInputOf(registrationCase, target.value());
    if (!input) {
        return failInput(arguments.casePath + ": " + input.error().message);
    }
    auto result = registerWithProgress(input.value(), registrationCase.options);
    if (!result) {
        return failInput(arguments.casePath + ": " + result.error().message);
    }
    registrationCase.cameraFromPatient = result.value().cameraFromPatient;
    registrationCase.result = std::move(result).value();

    const std::string folder = outputFolderOf(arguments);
    if (const auto status = writeOutputs(registrationCase, target.value(), folder); !status) {
        return failInput(status.error().message);
    }
    if (arguments.format == OutputFormat::Json) {
        std::puts(io::resultJson(registrationCase, *registrationCase.result).c_str());
    } else {
        printSummary(*registrationCase.result, folder);
    }
    return exitCodeOf(*registrationCase.result);
}

}   // namespace app
