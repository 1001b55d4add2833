#include "core/registration/methods/pose_trials.h"

#include <algorithm>
#include <limits>

namespace angiopose::core {
namespace {

constexpr int reportsInAll = 200;
constexpr std::size_t probeCount = 200;

}   // namespace

PoseTrials::PoseTrials(const RegistrationProblem& problem, int budget, ProgressLog& progress)
    : problem_(problem),
      progress_(progress),
      target_(problem.target.points),
      start_(aboutCentroid(problem.start, problem.tree.centroid)),
      best_(start_),
      bestCost_(std::numeric_limits<double>::infinity()),
      budget_(std::max(1, budget)),
      reportInterval_(std::max(1, budget / reportsInAll))
{
    const std::size_t stride = std::max<std::size_t>(1, problem.tree.size() / probeCount);
    for (std::size_t i = 0; i < problem.tree.size(); i += stride) {
        probes_.push_back(problem.tree.points[i]);
    }
}

RigidTransform PoseTrials::rigidPose(const CentroidPose& pose) const
{
    return cameraFromPatient(pose, problem_.tree.centroid);
}

double PoseTrials::recordTrial(const CentroidPose& pose, double cost)
{
    if (progress_.isStopped()) {
        return cost;   // keeps the reported pose as the result
    }
    if (cost < bestCost_) {
        bestCost_ = cost;
        best_ = pose;
    }
    advanceProgress();
    return cost;
}

void PoseTrials::advanceProgress()
{
    if (!progress_.isStopped() && trialCount_++ % reportInterval_ == 0) {
        report();
    }
}

void PoseTrials::startStage(std::string_view stage, double scalePx, double costOfBest)
{
    stage_ = stage;
    scalePx_ = scalePx;
    bestCost_ = costOfBest;
}

MethodSolution PoseTrials::solution(StopReason reason) const
{
    MethodSolution solution;
    solution.cameraFromPatient = rigidPose(best_);
    solution.cameraFromPatient.rotation = nearestRotation(solution.cameraFromPatient.rotation);
    solution.stopReason = progress_.isStopped() ? StopReason::StoppedByUser : reason;
    solution.iterations = progress_.iterations();
    return solution;
}

void PoseTrials::report()
{
    IterationReport report;
    report.stage = stage_;
    report.progress = static_cast<double>(trialCount_) / budget_;
    report.scalePx = scalePx_;
    report.cameraFromPatient = rigidPose(best_);
    distances_.clear();
    for (const Eigen::Vector3d& probe : probes_) {
        const auto pixel = project(problem_.camera, report.cameraFromPatient * probe);
        distances_.push_back(pixel ? (*pixel - target_.nearest(*pixel)).norm()
                                   : std::numeric_limits<double>::infinity());
    }
    const auto middle = distances_.begin() + static_cast<std::ptrdiff_t>(distances_.size() / 2);
    std::nth_element(distances_.begin(), middle, distances_.end());
    report.medianDistancePx = *middle;
    progress_.report(report);
}

}   // namespace angiopose::core
