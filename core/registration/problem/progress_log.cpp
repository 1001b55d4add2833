#include "core/registration/problem/progress_log.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t usualReports = 256;

}   // namespace

ObserverDecision ProgressLog::report(IterationReport report)
{
    progress_ = std::clamp(report.progress, progress_, 1.0);
    report.progress = progress_;
    report.iteration = iterations() + 1;
    report.stepMm = shift_.rmsMm(lastPose_, report.cameraFromPatient);
    lastPose_ = report.cameraFromPatient;
    if (history_.empty()) {
        history_.reserve(usualReports);
    }
    history_.push_back(report);
    if (observe_ && observe_(report) == ObserverDecision::Stop) {
        isStopped_ = true;
    }
    return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
}

ObserverDecision ProgressLog::checkForStop(std::string_view stage)
{
    if (observe_ && !history_.empty()) {
        IterationReport report = history_.back();
        report.stage = stage.empty() ? report.stage : stage;
        isStopped_ = observe_(report) == ObserverDecision::Stop || isStopped_;
    }
    return isStopped_ ? ObserverDecision::Stop : ObserverDecision::Continue;
}

}   // namespace angiopose::core
