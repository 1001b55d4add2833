#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/register_case.h"
#include "app/cli/register_outputs.h"
#include "core/case/case_patients.h"
#include "core/registration/deformable/deform_vessels.h"
#include "core/support/stopwatch.h"
#include "io/case/case_file.h"
#include "io/case/input_case.h"
#include "io/results/result_file.h"

#include <cstdio>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

/// Returns the path of the input file that errors name.
const std::string& inputPathOf(const RegisterArguments& arguments)
{
    return !arguments.from.path.empty()       ? arguments.from.path
           : !arguments.angiogramPath.empty() ? arguments.angiogramPath
                                              : arguments.casePath;
}

std::string outputFolderOf(const RegisterArguments& arguments)
{
    return arguments.outputFolder.empty() ? fs::path(inputPathOf(arguments)).stem().string() + "-registered"
                                          : arguments.outputFolder;
}

core::Result<core::Case> loadAskedCase(const RegisterArguments& arguments)
{
    if (!arguments.from.path.empty()) {
        return loadResultForCommand(arguments.from, ResultState::Unregistered, arguments.frame);
    }
    return arguments.angiogramPath.empty()
               ? loadCaseForCommand(arguments.casePath, arguments.frame)
               : loadPairForCommand({arguments.casePath, arguments.angiogramPath}, arguments.frame);
}

/// Adds the shown views of the cases at `paths`.
core::Status addOtherViews(core::Case& session, const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        auto read = loadCaseForCommand(fs::absolute(path).string(), std::nullopt);
        if (!read) {
            return read.error();
        }
        session.views.push_back(std::move(read).value().shown());
    }
    return core::Done{};
}

int exitCodeOf(const core::RegisteredCase& registered)
{
    const auto& deformed = registered.result().deformed;
    if (registered.result().stopReason == core::StopReason::StoppedByUser ||
        (deformed && deformed->stopReason == core::StopReason::StoppedByUser)) {
        return exitInterrupted;
    }
    const bool isUnsure = registered.session.options.deformation == core::Deformation::Always && deformed &&
                          deformed->verdict == core::DeformationVerdict::Unsure;
    return registered.result().trustworthy && !isUnsure ? exitSuccess : exitUnreliable;
}

}   // namespace

int runRegister(const RegisterArguments& arguments)
{
    core::Stopwatch watch;
    auto loaded = loadAskedCase(arguments);
    if (!loaded) {
        return reportInputError(loaded.error(), arguments.format);
    }
    core::Case session = std::move(loaded).value();
    if (const auto status = applyArguments(session, arguments); !status) {
        printMessage(status.error().message.text());
        return exitUsageError;
    }
    if (arguments.deformVessels) {
        session.options.deformation = core::Deformation::Always;
    }
    if (const auto status = addOtherViews(session, arguments.otherViews); !status) {
        return reportInputError(status.error(), arguments.format);
    }
    if (!arguments.otherViews.empty() ||
        !arguments.angiogramPath.empty()) {   // loading a single case has already compared its images
        printWarnings(core::findMismatch(session));
    }
    for (core::View& view : session.views) {
        view.isSamePatient = view.isSamePatient || arguments.isSamePatient;
    }
    core::RegistrationPlan plan;
    plan.readMs = watch.takeLapMs();
    const auto registered = registerForCommand(std::move(session), "registering", std::move(plan));
    if (!registered) {
        return reportInputError(registered.error().about(inputPathOf(arguments)), arguments.format);
    }
    const std::string folder = outputFolderOf(arguments);
    if (const auto status = writeOutputs(registered.value(), folder); !status) {
        return reportInputError(status.error(), arguments.format);
    }
    if (!arguments.savedPath.empty()) {
        if (const auto status = io::saveCase(registered.value().session, arguments.savedPath); !status) {
            return reportInputError(status.error(), arguments.format);
        }
    }
    if (arguments.format == OutputFormat::Json) {
        std::puts(io::registrationJson(registered.value(), io::inputCaseJson(registered.value())).c_str());
    } else {
        printSummary(registered.value(), folder);
    }
    return exitCodeOf(registered.value());
}

}   // namespace angiopose::app
