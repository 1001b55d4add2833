#include "app/library/observer_adapter.h"

#include "app/library/conversions.h"

namespace angiopose::library {

Message toPublic(const core::Message& message)
{
    Message converted{std::string(message.id()), message.text(), {}};
    for (const core::MessageArgument& argument : message.arguments()) {
        converted.arguments.push_back(core::argumentText(argument));
    }
    return converted;
}

std::vector<Message> toPublic(const core::Messages& messages)
{
    std::vector<Message> converted;
    converted.reserve(messages.size());
    for (const core::Message& message : messages) {
        converted.push_back(toPublic(message));
    }
    return converted;
}

void throwError(const core::Error& error)
{
    const Message message = toPublic(error.message);
    if (error.isCancellation()) {
        throw Stopped(message.id, message.text);
    }
    throw Error(message.id, message.text);
}

core::ObserverDecision ObserverAdapter::notify(const Progress& progress)
{
    if (isStopped_) {
        return core::ObserverDecision::Stop;
    }
    try {
        isStopped_ = observe_(progress) == Verdict::Stop;
    } catch (...) {
        exception_ = std::current_exception();
        isStopped_ = true;
    }
    return isStopped_ ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
}

core::IterationObserver ObserverAdapter::iterations()
{
    if (!observe_) {
        return {};
    }
    return [this](const core::IterationReport& report) {
        return notify({std::string(report.stage), report.progress, static_cast<int>(report.view), report.iteration,
                       report.medianDistancePx, toPublic(report.cameraFromPatient)});
    };
}

core::WorkObserver ObserverAdapter::working()
{
    if (!observe_) {
        return {};
    }
    return [this](const core::WorkReport& report) {
        Progress progress{std::string(report.stage), report.fraction, static_cast<int>(report.view), 0, 0.0, {}};
        if (const core::IterationReport* solver = report.iteration) {
            progress.iteration = solver->iteration;
            progress.medianDistancePx = solver->medianDistancePx;
            progress.cameraFromPatient = toPublic(solver->cameraFromPatient);
        }
        return notify(progress);
    };
}

io::ReadObserver ObserverAdapter::reading(std::string_view stage)
{
    if (!observe_) {
        return {};
    }
    return [this, stage = std::string(stage)](double fraction) { return notify({stage, fraction, 0, 0, 0.0, {}}); };
}

core::TracingObserver ObserverAdapter::tracing()
{
    if (!observe_) {
        return {};
    }
    return [this](const core::TracingReport& report) {
        return notify({std::string(report.stage), report.progress, 0, 0, 0.0, {}});
    };
}

}   // namespace angiopose::library
