#include "core/registration/pnp/pair_fit.h"

namespace angiopose::core {

CentroidPose fitPairs(std::span<const PointPixelPair> pairs, const ProjectionCamera& camera,
                      const InitialPosePrior& prior, double pairStdMm, int steps, const CentroidPose& from)
{
    CentroidPose pose = from;
    for (int step = 0; step < steps; ++step) {
        NormalEquations equations;
        for (const PointPixelPair& pair : pairs) {
            const Eigen::Vector3d arm = pose.rotation * pair.position;
            const auto pixel = project(camera, arm + pose.centroidInCamera);
            if (!pixel) {
                continue;
            }
            const double mmPerPx = millimetersPerPixel(camera, pose.centroidInCamera.z());
            const auto jacobian = projectionJacobian(camera, arm + pose.centroidInCamera);
            Eigen::Matrix<double, 2, 6> rows;
            rows << -jacobian * skew(arm), jacobian;
            rows *= mmPerPx;
            equations.hessian += rows.transpose() * rows;
            equations.gradient += rows.transpose() * (mmPerPx * (*pixel - pair.pixel));
        }
        prior.add(pose, pairStdMm * pairStdMm, equations);
        pose = prior.freedom.retract(pose, prior.freedom.dampedStep(equations, 0.0, pose));
    }
    return pose;
}

}   // namespace angiopose::core
