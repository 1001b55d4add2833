#include "core/registration/methods/kernel_finish.h"

#include "core/registration/pnp/kernel_pnp.h"

namespace angiopose::core {

void refineByKernel(const RegistrationProblem& problem, std::span<const CentroidPose> poses, double finalScalePx,
                    PoseTrials& search)
{
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : problem.tree.points) {
        points.emplace_back(point - problem.tree.centroid);
    }
    const GridIndex target(problem.target.points);
    KernelProblem full{points, problem.camera, &target, {}};
    full.freedom = {problem.freedom, RigidTransform(), Eigen::Vector3d::Zero()};
    KernelDistances distances;
    measureDistances(full, {search.best().rotation, search.best().centroidInCamera}, distances);
    search.startStage("refine", finalScalePx, kernelLoss(distances, finalScalePx));
    KernelSchedule schedule;
    schedule.maxIterations = kernelFinishIterations;
    schedule.finalScalePx = finalScalePx;
    for (const CentroidPose& pose : poses) {
        if (search.isStopped()) {
            return;
        }
        const RigidTransform start{pose.rotation, pose.centroidInCamera};
        KernelPnp(full, {}, schedule).solve(start, [&](const KernelIteration& step) {
            search.recordTrial({step.pose.rotation, step.pose.translation}, kernelLoss(*step.distances, finalScalePx));
            return search.isStopped() ? ObserverDecision::Stop : ObserverDecision::Continue;
        });
    }
}

}   // namespace angiopose::core
