#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/register_case.h"
#include "app/cli/register_views.h"
#include "app/texts/number_text.h"
#include "core/registration/registration.h"
#include "io/result_file.h"

#include <cstdio>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

std::string outputFolderOf(const RegisterArguments& arguments)
{
    return arguments.outputFolder.empty() ? fs::path(arguments.casePath).stem().string() + "-registered"
                                          : arguments.outputFolder;
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
    for (const core::Message& warning : result.warnings) {
        printLine("", warning.text());
    }
    printLine("written", (fs::path(folder) / "overlay.png").string() + ", result.json, pose.tfm");
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
        return failInput(loaded.error(), arguments.format);
    }
    core::Case theCase = std::move(loaded).value();
    if (const auto status = applyArguments(theCase, arguments); !status) {
        printMessage(status.error().message.text());
        return exitUsage;
    }
    for (const std::string& path : arguments.otherViews) {
        theCase.views.emplace_back().caseFile.path = fs::absolute(path).string();
    }
    if (theCase.views.size() > 1) {
        return registerViewsOf(theCase, arguments, outputFolderOf(arguments));
    }
    const auto registered = registerCase(std::move(theCase), "registering");
    if (!registered) {
        return failInput(registered.error().about(arguments.casePath), arguments.format);
    }
    const std::string folder = outputFolderOf(arguments);
    if (const auto status = writeOutputs(registered.value(), folder); !status) {
        return failInput(status.error(), arguments.format);
    }
    const core::RegistrationResult& result = *registered.value().theCase.shown().result;
    if (arguments.format == OutputFormat::Json) {
        std::puts(io::resultJson(registered.value().theCase, result).c_str());
    } else {
        printSummary(result, folder);
    }
    return exitCodeOf(result);
}

}   // namespace angiopose::app