#include "app/registration/target_provider.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t rememberedTraces = 64;

std::optional<TraceRequest> requestFor(const core::RegistrationCase& registrationCase)
{
    const auto& angiogram = registrationCase.angiogram;
    if (!angiogram || registrationCase.frame < 0 || registrationCase.frame >= angiogram->frameCount()) {
        return std::nullopt;
    }
    return TraceRequest{angiogram, registrationCase.frame, registrationCase.traceOptions};
}

}   // namespace

TargetProvider::TargetProvider(QObject* parent) : QObject(parent)
{
    connect(&job_, &TraceJob::finished, this, [this](const SharedTrace& traced) {
        remember(traced);
        startWanted();
    });
    connect(&job_, &TraceJob::failed, this, [this](const QString& reason) {
        if (wanted_ == job_.request()) {
            settle(SharedTrace(), reason);
        } else {
            startWanted();
        }
    });
}

void TargetProvider::want(const core::RegistrationCase& registrationCase)
{
    if (const auto given = core::givenTargetOf(registrationCase)) {
        wanted_.reset();
        settleGiven(given);
        return;
    }
    const auto request = requestFor(registrationCase);
    if (request && request == wanted_) {
        return;
    }
    wanted_ = request;
    startWanted();
}

void TargetProvider::startWanted()
{
    if (!wanted_) {
        settle(SharedTrace(), {});
        return;
    }
    const auto known = std::ranges::find(traced_, *wanted_, &std::pair<TraceRequest, SharedTrace>::first);
    if (known != traced_.end()) {
        settle(known->second, {});
        return;
    }
    settle(SharedTrace(), {});
    if (!job_.isRunning()) {
        job_.start(*wanted_);
    }
}

void TargetProvider::remember(const SharedTrace& traced)
{
    traced_.emplace_back(job_.request(), traced);
    if (traced_.size() > rememberedTraces) {
        traced_.pop_front();
    }
}

void TargetProvider::settle(const SharedTrace& trace, const QString& problem)
{
    settle(trace ? SharedCenterline(trace, &trace->centerline) : nullptr, trace, problem);
}

void TargetProvider::settleGiven(const SharedCenterline& given)
{
    settle(given, nullptr, {});
}

void TargetProvider::settle(const SharedCenterline& target, const SharedTrace& trace, const QString& problem)
{
    if (target == current_ && problem == problem_) {
        return;
    }
    current_ = target;
    trace_ = trace;
    problem_ = problem;
    emit changed();
}

}   // namespace app
