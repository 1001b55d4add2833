#include "core/evaluation/trial/evaluated_method.h"

#include "core/evaluation/trial/cramer_rao_bound.h"
#include "core/evaluation/trial/run_record.h"
#include "core/messages/messages.h"
#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_text.h"
#include "core/support/stopwatch.h"

#include <algorithm>
#include <sstream>

namespace angiopose::core {
namespace {

const std::string ownMethod = "angiopose";

std::vector<std::string> split(const std::string& text, char separator)
{
    std::istringstream stream(text);
    std::vector<std::string> parts;
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

/// Returns "preset=seed_mean" for "seed_mean" if exactly one option of the method has a choice with this name. "on"
/// does not count as the name of a choice.
Result<std::string> findAssignment(const std::string& setting, const std::string& method)
{
    std::vector<std::string> found;
    for (const OptionField& field : optionFields()) {
        if (appliesTo(field, method) && std::holds_alternative<ChoiceOption>(field.type) && valueFrom(field, setting)) {
            found.push_back(std::string(field.key) + "=" + setting);
        }
    }
    if (found.size() == 1) {
        return found.front();
    }
    return Error(found.empty() ? messages::noSuchChoice(method, setting) : messages::choiceOfSeveral(method, setting));
}

std::vector<std::string> allMethods()
{
    std::vector<std::string> requests;
    for (const MethodInfo& info : methodInfos()) {
        if (info.id == "wire") {
            continue;   // no trial shows only a guidewire
        }
        requests.emplace_back(info.id);
        if (info.id == "dynaweight") {
            requests.emplace_back("dynaweight:seed_noprior");   // for comparison: shows the effect of the prior
        }
    }
    return requests;
}

std::vector<std::string> ablationMethods()
{
    std::vector<std::string> requests;
    for (const std::string preset : {"seed_sum", "seed_mean", "seed_metric", "seed_noprior"}) {
        for (const std::string rotationFirst : {"off", "on"}) {
            for (const std::string alternation : {"off", "on"}) {
                requests.push_back("dynaweight:" + preset + ":rotationFirst=" + rotationFirst +
                                   ":alternation=" + alternation);
            }
        }
    }
    return requests;
}

std::vector<std::string> expandGroup(const std::string& request)
{
    if (request == "all") {
        return allMethods();
    }
    return request == "ablation" ? ablationMethods() : std::vector<std::string>{request};
}

}   // namespace

Result<EvaluatedMethod> parseMethod(const std::string& request)
{
    const std::vector<std::string> parts = split(request, ':');
    EvaluatedMethod evaluatedMethod{request, {}, false};
    evaluatedMethod.options.method = parts.empty() ? "" : parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        std::string assignment = parts[i];
        if (assignment.find('=') == std::string::npos) {
            const auto named = findAssignment(assignment, evaluatedMethod.options.method);
            if (!named) {
                return named.error();
            }
            assignment = named.value();
        }
        if (const auto status = setOption(evaluatedMethod.options, assignment); !status) {
            return status.error();
        }
        evaluatedMethod.hasExplicitResampling |= assignment.starts_with("resample=");
    }
    if (const auto problem = findProblem(evaluatedMethod.options)) {
        return Error(*problem);
    }
    return evaluatedMethod;
}

Result<std::vector<EvaluatedMethod>> parseMethods(const std::string& requests)
{
    std::vector<EvaluatedMethod> evaluatedMethods;
    for (const std::string& group : split(requests, ',')) {
        for (const std::string& request : expandGroup(group)) {
            auto evaluatedMethod = parseMethod(request);
            if (!evaluatedMethod) {
                return evaluatedMethod.error();
            }
            const auto isSame = [&](const EvaluatedMethod& other) { return other.label == request; };
            if (std::none_of(evaluatedMethods.begin(), evaluatedMethods.end(), isSame)) {
                evaluatedMethods.push_back(std::move(evaluatedMethod).value());
            }
        }
    }
    if (evaluatedMethods.empty()) {
        return Error(messages::noMethodNamed());
    }
    return evaluatedMethods;
}

RegistrationOptions optionsFor(const EvaluatedMethod& evaluatedMethod, bool targetIsExact)
{
    RegistrationOptions options = evaluatedMethod.options;
    if (targetIsExact && !evaluatedMethod.hasExplicitResampling && options.method != ownMethod) {
        options.resample = false;
    }
    return options;
}

std::optional<RunRecord> runTrial(const Trial& trial, const EvaluatedMethod& evaluatedMethod, KeepHistory keepHistory,
                                  const std::function<bool()>& isStopped)
{
    bool wasStopped = false;
    const ThreadStopwatch processor;
    const auto result =
        registerVessels(trial.input, optionsFor(evaluatedMethod, trial.targetIsExact), [&](const IterationReport&) {
            wasStopped = wasStopped || isStopped();
            return wasStopped ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
    if (wasStopped) {
        return std::nullopt;
    }
    RunRecord record;
    record.processorMs = processor.elapsedMs();
    record.traceMs = trial.traceMs.value_or(unknownMeasure);
    record.method = evaluatedMethod.label;
    const GroundTruth truth{*trial.tree, trial.input.camera, trial.trueCameraFromPatient, targetsOf(*trial.tree)};
    measureInitialPose(truth, trial.input.initialCameraFromPatient, record);
    if (trial.hasCorrectPose) {
        measurePose(truth, result ? result.value().cameraFromPatient : trial.input.initialCameraFromPatient, record);
    }
    if (trial.errorBound) {
        record.boundRmsPx =
            rmsProjectionPx(*trial.tree, trial.input.camera, trial.trueCameraFromPatient, *trial.errorBound);
    }
    if (result) {
        recordResult(result.value(), record);
        if (trial.hasCorrectPose) {
            measureCovariance(truth, result.value(), record);
        }
        for (const IterationReport& report : result.value().history) {
            if (keepHistory == KeepHistory::Yes) {
                record.history.push_back(
                    projectionError(truth.tree, truth.camera, {report.cameraFromPatient, truth.cameraFromPatient})
                        .meanPx);
            }
        }
    }
    return record;
}

}   // namespace angiopose::core
