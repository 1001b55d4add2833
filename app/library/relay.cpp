#include "app/library/relay.h"

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

void raise(const core::Error& error)
{
    const Message message = toPublic(error.message);
    if (error.isStop()) {
        throw Stopped(message.id, message.text);
    }
    throw Error(message.id, message.text);
}

core::Verdict Relay::tell(const Progress& progress)
{
    if (isStopped_) {
        return core::Verdict::Stop;
    }
    try {
        isStopped_ = observe_(progress) == Verdict::Stop;
    } catch (...) {
        thrown_ = std::current_exception();
        isStopped_ = true;
    }
    return isStopped_ ? core::Verdict::Stop : core::Verdict::Continue;
}

core::IterationObserver Relay::iterations()
{
    if (!observe_) {
        return {};
    }
    return [this](const core::IterationReport& report) {
        return tell({std::string(report.stage), report.progress, static_cast<int>(report.view), report.iteration,
                     report.medianDistancePx, toPublic(report.cameraFromPatient)});
    };
}

core::WorkObserver Relay::working()
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
        return tell(progress);
    };
}

io::ReadObserver Relay::reading(std::string_view stage)
{
    if (!observe_) {
        return {};
    }
    return [this, stage = std::string(stage)](double fraction) { return tell({stage, fraction, 0, 0, 0.0, {}}); };
}

core::TracingObserver Relay::tracing()
{
    if (!observe_) {
        return {};
    }
    return [this](const core::TracingReport& report) {
        return tell({std::string(report.stage), report.progress, 0, 0, 0.0, {}});
    };
}

}   // namespace angiopose::library
