#pragma once

#include "core/support/verdict.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <string_view>

namespace angiopose::core {

struct TracingReport {
    std::string_view stage;   ///< "blood", "vessels", "thinning", "branches"
    double progress = 0.0;   ///< 0…1, never decreasing
};

/// Called on the calling thread several times per second; returning Stop ends the work within a second.
using TracingObserver = std::function<Verdict(const TracingReport&)>;

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

    /// Reports the completed fraction `share` of the stage; returns false to request a stop as soon as possible.
    bool advance(double share)
    {
        if (!stopped_ && std::chrono::steady_clock::now() >= due_) {
            report(share);
        }
        return !stopped_;
    }

    bool isStopped() const { return stopped_; }

private:
    void report(double share)
    {
        reached_ = std::max(reached_, from_ + (to_ - from_) * std::clamp(share, 0.0, 1.0));
        if (observe_ && !stopped_) {
            stopped_ = observe_({stage_, reached_}) == Verdict::Stop;
        }
        due_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    }

    TracingObserver observe_;
    std::string_view stage_;
    double from_ = 0.0;
    double to_ = 0.0;
    double reached_ = 0.0;
    bool stopped_ = false;
    std::chrono::steady_clock::time_point due_{};
};

}   // namespace angiopose::core
