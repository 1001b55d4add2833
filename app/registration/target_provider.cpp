#include "app/registration/target_provider.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr std::size_t rememberedBytes = 16U << 20U;   // cache size, dominated by the masks: 64 frames of 512 × 512

std::size_t bytesOf(const SharedTrace& trace)
{
    return trace->fieldMask.pixels.size();
}

std::optional<TraceRequest> requestFor(const core::Case& session)
{
    const auto& angiogram = session.shown().angiogram;
    if (!angiogram || session.shown().frame < 0 || session.shown().frame >= angiogram->frameCount()) {
        return std::nullopt;
    }
    return TraceRequest{angiogram, session.shown().frame, core::traceOptionsOf(session.shown())};
}

}   // namespace

TargetProvider::TargetProvider(QObject* parent) : QObject(parent)
{
    const auto goOn = [this] {
        const SharedCenterline before = current_;
        if (wanted_) {   // not set if curves were provided in the meantime or the image is gone
            startWanted();
        }
        if (current_ == before) {
            emit changed();   // `isTracing` may have changed
        }
    };
    connect(&job_, &TraceJob::finished, this, [this, goOn](const SharedTrace& traced) {
        remember(*std::exchange(asked_, std::nullopt), traced);
        goOn();
    });
    connect(&job_, &TraceJob::failed, this, [this, goOn](const core::Message& reason) {
        if (wanted_ == std::exchange(asked_, std::nullopt)) {
            settle(SharedTrace(), reason);
        } else {
            goOn();
        }
    });
}

void TargetProvider::want(const core::Case& session)
{
    if (const auto given = core::givenTargetOf(session.shown())) {
        wanted_.reset();
        settleGiven(given);
        return;
    }
    const auto request = requestFor(session);
    if (request && request == wanted_) {
        return;
    }
    wanted_ = request;
    startWanted();
}

void TargetProvider::startWanted()
{
    if (!wanted_) {
        settle(SharedTrace(), std::nullopt);
        return;
    }
    if (const SharedTrace trace = known(*wanted_)) {
        settle(trace, std::nullopt);
        return;
    }
    settle(SharedTrace(), std::nullopt);
    if (!job_.isRunning()) {
        asked_ = wanted_;
        job_.start(*wanted_);
    }
}

SharedTrace TargetProvider::known(const TraceRequest& request)
{
    std::erase_if(traced_, [](const Remembered& one) { return one.run.expired(); });
    const auto found = std::ranges::find_if(traced_, [&request](const Remembered& one) {
        return one.run.lock() == request.angiogram && one.frame == request.frame && one.options == request.options;
    });
    return found == traced_.end() ? nullptr : found->trace;
}

void TargetProvider::remember(const TraceRequest& asked, const SharedTrace& traced)
{
    traced_.push_back({asked.angiogram, asked.frame, asked.options, traced});
    std::size_t bytes = 0;
    for (const Remembered& one : traced_) {
        bytes += bytesOf(one.trace);
    }
    while (bytes > rememberedBytes && traced_.size() > 1) {
        bytes -= bytesOf(traced_.front().trace);
        traced_.pop_front();
    }
}

void TargetProvider::settle(const SharedTrace& trace, const std::optional<core::Message>& problem)
{
    settle(trace ? SharedCenterline(trace, &trace->centerline) : nullptr, trace, problem);
}

void TargetProvider::settleGiven(const SharedCenterline& given)
{
    settle(given, nullptr, std::nullopt);
}

void TargetProvider::settle(const SharedCenterline& target, const SharedTrace& trace,
                            const std::optional<core::Message>& problem)
{
    if (target == current_ && problem == problem_) {
        return;
    }
    current_ = target;
    trace_ = trace;
    problem_ = problem;
    emit changed();
}

}   // namespace angiopose::app
