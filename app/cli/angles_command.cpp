#include "app/cli/case_input.h"
#include "app/cli/commands.h"
#include "app/texts/number_text.h"
#include "core/messages/messages.h"
#include "core/viewing/angle_map.h"
#include "io/angle_map_table.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace angiopose::app {
namespace {

std::string percent(double share)
{
    return fixedText(100.0 * share, 0) + " %";
}

void printLine(const char* title, const core::AngleSuggestion& suggestion)
{
    std::printf("%-8s%-10s %-9s  foreshortened %5s, covered %5s\n", title,
                primaryAngleText(suggestion.angles.primaryDeg).c_str(),
                secondaryAngleText(suggestion.angles.secondaryDeg).c_str(),
                percent(suggestion.quality.foreshortening).c_str(), percent(suggestion.quality.overlap).c_str());
}

nlohmann::ordered_json suggestionJson(const core::AngleSuggestion& suggestion)
{
    return {{"primaryAngleDeg", suggestion.angles.primaryDeg},
            {"secondaryAngleDeg", suggestion.angles.secondaryDeg},
            {"foreshortening", suggestion.quality.foreshortening},
            {"overlap", suggestion.quality.overlap}};
}

void printAll(const core::AngleSuggestion& now, const core::AngleMap& map, OutputFormat format)
{
    if (format == OutputFormat::Json) {
        nlohmann::ordered_json best = nlohmann::json::array();
        for (const core::AngleSuggestion& suggestion : map.best) {
            best.push_back(suggestionJson(suggestion));
        }
        std::printf("%s\n", nlohmann::ordered_json{{"now", suggestionJson(now)}, {"best", best}}.dump(2).c_str());
        return;
    }
    printLine("now", now);
    for (const core::AngleSuggestion& suggestion : map.best) {
        printLine("best", suggestion);
    }
}

}   // namespace

int runAngles(const AnglesArguments& arguments)
{
    const auto loaded = loadCaseForCommand(arguments.casePath, arguments.frame);
    if (!loaded) {
        return reportInputError(loaded.error(), arguments.format);
    }
    const core::Case& session = loaded.value();
    const auto evaluator =
        core::makeViewEvaluator(*session.vessels.tree, arguments.branchId,
                                arguments.takeoffOnly ? core::EvaluatedPart::Takeoff : core::EvaluatedPart::Branch);
    const auto poseAt = core::poseForGantryAngles(session.shown());
    if (!evaluator || !poseAt) {
        return reportInputError((evaluator ? poseAt.error() : evaluator.error()).about(arguments.casePath),
                                arguments.format);
    }
    ProgressLine progress("looking");
    const auto map = core::computeAngleMap(evaluator.value(), poseAt.value(), arguments.map, [&](double done) {
        progress.show(done, "");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
    if (!map) {
        return reportInputError(map.error(), arguments.format);
    }
    if (session.vessels.tree->find(arguments.branchId)->radiusMm.empty()) {
        printWarnings({core::messages::radiiAssumed()});
    }
    const core::GantryAngles now = *core::gantryAnglesOf(session.shown());
    printAll({now, evaluator.value().from(poseAt.value()(now))}, map.value(), arguments.format);
    if (!arguments.outputPath.empty()) {
        if (const auto status = io::writeAngleMap(map.value(), arguments.outputPath); !status) {
            return reportInputError(status.error(), arguments.format);
        }
    }
    return exitSuccess;
}

}   // namespace angiopose::app
