#pragma once

#include "core/support/observer_decision.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string_view>

namespace angiopose::core {

struct TracingReport {
    std::string_view stage;   ///< "blood", "vessels", "thinning", "branches"
    double progress = 0.0;   ///< 0…1, never decreasing
};

/// Called on the calling thread several times per second; if it returns Stop, the work ends within a second.
using TracingObserver = std::function<ObserverDecision(const TracingReport&)>;

/// Reports progress and receives stop requests, at most about twenty times per second. A stop is permanent.
class TracingProgress {
public:
    explicit TracingProgress(TracingObserver observe) : observe_(std::move(observe)) {}

    /// Enters the next stage, which covers the total progress from `from` to `to`.
    void enter(std::string_view stage, double from, double to)
    {
        stage_ = stage;
        from_ = from;
        to_ = to;
        report(0.0);
    }

    /// Reports the completed `fraction` of the stage; returns false to request a stop as soon as possible.
    bool advance(double fraction)
    {
        if (!stopped_ && std::chrono::steady_clock::now() >= nextReport_) {
            report(fraction);
        }
        return !stopped_;
    }

    bool isStopped() const { return stopped_; }

private:
    void report(double fraction)
    {
        maxReported_ = std::max(maxReported_, from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0));
        if (observe_ && !stopped_) {
            stopped_ = observe_({stage_, maxReported_}) == ObserverDecision::Stop;
        }
        nextReport_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    }

    TracingObserver observe_;
    std::string_view stage_;
    double from_ = 0.0;
    double to_ = 0.0;
    double maxReported_ = 0.0;
    bool stopped_ = false;
    std::chrono::steady_clock::time_point nextReport_{};
};

}   // namespace angiopose::core
