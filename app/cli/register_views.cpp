#include "app/cli/register_views.h"

#include "app/cli/add_warnings.h"
#include "app/cli/case_input.h"
#include "app/cli/register_case.h"
#include "app/messages/says.h"
#include "app/texts/number_text.h"
#include "core/case/case_views.h"
#include "core/case/registration_input.h"
#include "core/geometry/angle_units.h"
#include "core/registration/register_views.h"
#include "io/result_file.h"
#include "io/support/atomic_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// All views with what they are registered to.
struct Views {
    std::vector<core::Case> cases;   ///< each shows one of the views
    std::vector<core::Centerline2d> targets;
};

/// Views that stand in case files which the case does not hold yet.
core::Status readViews(core::Case& theCase)
{
    for (std::size_t k = 0; k < theCase.views.size(); ++k) {
        core::View& view = theCase.views[k];
        if (k == theCase.shownView || view.angiogram) {
            continue;
        }
        if (view.caseFile.path.empty()) {
            return core::Error(says::viewImageUnread().about(view.imageFile.path));
        }
        auto read = loadCaseForCommand(view.caseFile.path, std::nullopt);
        if (!read) {
            return read.error();
        }
        view = std::move(read).value().shown();
    }
    return core::Done{};
}

core::Result<Views> viewsOf(core::Case theCase)
{
    if (const auto read = readViews(theCase); !read) {
        return read.error();
    }
    Views views;
    for (const std::size_t place : core::registeredViews(theCase)) {
        const core::View& view = theCase.views[place];
        auto target = core::targetOf(view);
        if (!target) {
            return target.error().about(view.imageFile.path);
        }
        views.targets.push_back(std::move(target).value());
        views.cases.push_back(core::showingView(theCase, place));
    }
    return views;
}

core::Result<core::MultiViewResult> solve(const std::vector<core::RegistrationInput>& inputs,
                                          const core::RegistrationOptions& options)
{
    ProgressLine progress("registering " + std::to_string(inputs.size()) + " views");
    return core::registerViews(inputs, options, {}, [&progress](const core::IterationReport& report) {
        progress.show(report.progress, std::string(report.stage));
        return isInterrupted() ? core::Verdict::Stop : core::Verdict::Continue;
    });
}

std::vector<core::View> shownOf(const std::vector<core::Case>& cases)
{
    std::vector<core::View> views;
    std::ranges::transform(cases, std::back_inserter(views), [](const core::Case& each) { return each.shown(); });
    return views;
}

std::string viewFolder(const std::string& folder, std::size_t index)
{
    return index == 0 ? folder : (fs::path(folder) / ("view-" + std::to_string(index + 1))).string();
}

Json jointJson(const Views& views, const core::MultiViewResult& joint)
{
    Json json{{"format", "angiopose-joint-result"}, {"version", 1}, {"trustworthy", joint.trustworthy}};
    addWarnings(json, joint.warnings);
    json["uncertainty"] = {{"inPlaneSigmaMm", joint.uncertainty.inPlaneMm},
                           {"depthSigmaMm", joint.uncertainty.depthMm},
                           {"rotationSigmaDeg", joint.uncertainty.rotationDeg.maxCoeff()}};
    for (std::size_t k = 0; k < views.cases.size(); ++k) {
        const core::Vector6d& correction = joint.corrections[k];
        Json view = Json::parse(io::resultJson(views.cases[k], joint.views[k]));
        view["geometryCorrection"] = {{"turnDeg", core::degreesPerRadian * correction.head<3>().norm()},
                                      {"shiftMm", correction.tail<3>().norm()}};
        json["views"].push_back(std::move(view));
    }
    return json;
}

core::Status writeViews(Views& views, const core::MultiViewResult& joint, const std::string& folder)
{
    for (std::size_t k = 0; k < views.cases.size(); ++k) {
        core::View& view = views.cases[k].shown();
        view.cameraFromPatient = joint.views[k].cameraFromPatient;
        view.result = joint.views[k];
        if (k == 0) {
            view.result->uncertainty = joint.uncertainty;
        }
        if (auto status = writeOutputs({views.cases[k], views.targets[k]}, viewFolder(folder, k)); !status) {
            return status;
        }
    }
    return io::writeAtomically((fs::path(folder) / "joint.json").string(),
                               jointJson(views, joint).dump(2, ' ', false, Json::error_handler_t::replace));
}

void printSummary(const Views& views, const core::MultiViewResult& joint, const std::string& folder)
{
    for (std::size_t k = 0; k < views.cases.size(); ++k) {
        const core::DistanceMetrics& metrics = joint.views[k].metrics;
        const core::Vector6d& correction = joint.corrections[k];
        std::printf("view %-9zu median %s px (%s mm), covered %s %%, geometry off by %s° and %s mm  %s\n", k + 1,
                    fixedText(metrics.medianPx, 2).c_str(), fixedText(metrics.medianMm, 2).c_str(),
                    fixedText(100.0 * metrics.coverage, 0).c_str(),
                    fixedText(core::degreesPerRadian * correction.head<3>().norm(), 2).c_str(),
                    fixedText(correction.tail<3>().norm(), 2).c_str(),
                    fs::path(views.cases[k].shown().imageFile.path).filename().string().c_str());
    }
    std::printf("%-14s in plane ±%s mm, depth ±%s mm, rotation ±%s°\n", "uncertainty",
                fixedText(joint.uncertainty.inPlaneMm, 2).c_str(), fixedText(joint.uncertainty.depthMm, 2).c_str(),
                fixedText(joint.uncertainty.rotationDeg.maxCoeff(), 2).c_str());
    std::printf("%-14s %s\n", "trustworthy", joint.trustworthy ? "yes" : "NO");
    for (const core::Message& warning : joint.warnings) {
        std::printf("%-14s %s\n", "", warning.text().c_str());
    }
    std::printf("%-14s %s\n", "written", (fs::path(folder) / "joint.json").string().c_str());
}

}   // namespace

int registerViewsOf(const core::Case& first, const RegisterArguments& arguments, const std::string& folder)
{
    auto read = viewsOf(first);
    if (!read) {
        return failInput(read.error(), arguments.format);
    }
    Views views = std::move(read).value();
    const auto inputs = core::jointInputsOf(shownOf(views.cases), first.vessels, views.targets);
    if (!inputs) {
        return failInput(inputs.error().about(arguments.casePath), arguments.format);
    }
    const auto joint = solve(inputs.value(), first.options);
    if (!joint) {
        return failInput(joint.error().about(arguments.casePath), arguments.format);
    }
    if (const auto status = writeViews(views, joint.value(), folder); !status) {
        return failInput(status.error(), arguments.format);
    }
    if (arguments.format == OutputFormat::Json) {
        std::puts(jointJson(views, joint.value()).dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        printSummary(views, joint.value(), folder);
    }
    if (isInterrupted()) {
        return exitStopped;
    }
    return joint.value().trustworthy ? exitDone : exitNotTrustworthy;
}

}   // namespace angiopose::app