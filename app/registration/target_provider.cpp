#include "app/registration/target_provider.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {
namespace {

constexpr std::size_t maxCacheBytes = 16U << 20U;   // cache size, mostly for masks: 64 frames of 512 × 512

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
        if (pendingRequest_) {   // not set if curves were provided in the meantime or the image no longer exists
            startRequested();
        }
        if (current_ == before) {
            emit changed();   // `isTracing` may have changed
        }
    };
    connect(&job_, &TraceJob::finished, this, [this, goOn](const SharedTrace& traced) {
        addToCache(*std::exchange(activeRequest_, std::nullopt), traced);
        goOn();
    });
    connect(&job_, &TraceJob::failed, this, [this, goOn](const core::Message& reason) {
        if (pendingRequest_ == std::exchange(activeRequest_, std::nullopt)) {
            setTarget(SharedTrace(), reason);
        } else {
            goOn();
        }
    });
}

void TargetProvider::setCase(const core::Case& session)
{
    if (const auto given = core::givenTargetOf(session.shown())) {
        pendingRequest_.reset();
        setStoredTarget(given);
        return;
    }
    const auto request = requestFor(session);
    if (request && request == pendingRequest_) {
        return;
    }
    pendingRequest_ = request;
    startRequested();
}

void TargetProvider::startRequested()
{
    if (!pendingRequest_) {
        setTarget(SharedTrace(), std::nullopt);
        return;
    }
    if (const SharedTrace trace = findCached(*pendingRequest_)) {
        setTarget(trace, std::nullopt);
        return;
    }
    setTarget(SharedTrace(), std::nullopt);
    if (!job_.isRunning()) {
        activeRequest_ = pendingRequest_;
        job_.start(*pendingRequest_);
    }
}

SharedTrace TargetProvider::findCached(const TraceRequest& request)
{
    std::erase_if(cache_, [](const CachedTrace& one) { return one.run.expired(); });
    const auto found = std::ranges::find_if(cache_, [&request](const CachedTrace& one) {
        return one.run.lock() == request.angiogram && one.frame == request.frame && one.options == request.options;
    });
    return found == cache_.end() ? nullptr : found->trace;
}

void TargetProvider::addToCache(const TraceRequest& traceRequest, const SharedTrace& traced)
{
    cache_.push_back({traceRequest.angiogram, traceRequest.frame, traceRequest.options, traced});
    std::size_t bytes = 0;
    for (const CachedTrace& one : cache_) {
        bytes += bytesOf(one.trace);
    }
    while (bytes > maxCacheBytes && cache_.size() > 1) {
        bytes -= bytesOf(cache_.front().trace);
        cache_.pop_front();
    }
}

void TargetProvider::setTarget(const SharedTrace& trace, const std::optional<core::Message>& problem)
{
    setTarget(trace ? SharedCenterline(trace, &trace->centerline) : nullptr, trace, problem);
}

void TargetProvider::setStoredTarget(const SharedCenterline& given)
{
    setTarget(given, nullptr, std::nullopt);
}

void TargetProvider::setTarget(const SharedCenterline& target, const SharedTrace& trace,
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
