#pragma once

#include "core/registration/matching/grid_index.h"
#include "core/registration/methods/method.h"
#include "core/registration/pose/centroid_pose.h"

namespace angiopose::core {

/// Bookkeeping for methods that evaluate trial poses: keeps the pose with the lowest cost, reports progress at
/// intervals and handles stop requests.
class PoseTrials {
public:
    /// `budget` is the maximum number of trial poses, from which the progress is computed.
    PoseTrials(const RegistrationProblem& problem, int budget, ProgressLog& progress);

    const CentroidPose& start() const { return start_; }
    RigidTransform rigidPose(const CentroidPose& pose) const;

    /// Records a trial pose and its cost; returns the cost.
    double recordTrial(const CentroidPose& pose, double cost);

    /// Counts work without a trial pose, so that progress reports and stop checks continue.
    void advanceProgress();

    /// Switches to a new cost: the best pose is kept until a pose with a lower new cost is found.
    void startStage(std::string_view stage, double scalePx, double costOfBest);

    bool isStopped() const { return progress_.isStopped(); }
    const CentroidPose& best() const { return best_; }
    double bestCost() const { return bestCost_; }

    MethodSolution solution(StopReason reason) const;

private:
    void report();

    const RegistrationProblem& problem_;
    ProgressLog& progress_;
    GridIndex target_;
    CentroidPose start_;
    CentroidPose best_;
    double bestCost_;
    int budget_;
    int trialCount_ = 0;
    int reportInterval_;
    std::string_view stage_ = "search";
    double scalePx_ = 0.0;
    std::vector<Eigen::Vector3d> probes_;   ///< tree points used to measure the reported distance
    std::vector<double> distances_;
};

}   // namespace angiopose::core
