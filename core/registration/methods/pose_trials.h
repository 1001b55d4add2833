#pragma once

#include "core/registration/matching/grid_index.h"
#include "core/registration/methods/method.h"
#include "core/registration/pose/centroid_pose.h"

namespace angiopose::core {

/// The book-keeping of a method that tries poses: keeps the one of least cost, reports every few, knows when to stop.
class PoseTrials {
public:
    /// `budget`: how many poses will be tried at most, for the progress.
    PoseTrials(const RegistrationProblem& problem, int budget, ProgressLog& progress);

    const CentroidPose& start() const { return start_; }
    RigidTransform inPatient(const CentroidPose& pose) const;

    /// Notes a tried pose; returns its cost.
    double note(const CentroidPose& pose, double cost);

    /// Counts work that tries no pose by itself, so that progress goes on and a stop is heard.
    void tick();

    /// From here on costs mean something else: the best pose stays, until a better one by the new cost comes.
    void changeCost(std::string_view stage, double scalePx, double costOfBest);

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
    int tried_ = 0;
    int reportEvery_;
    std::string_view stage_ = "search";
    double scalePx_ = 0.0;
    std::vector<Eigen::Vector3d> probes_;   ///< tree points the reported distance is measured with
    std::vector<double> distances_;
};

}   // namespace angiopose::core