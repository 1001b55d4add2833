#include "core/registration/pnp/source_freedom.h"

namespace angiopose::core {

SourceFreedom::SourceFreedom(const PoseFreedom& freedom, const RigidTransform& start,
                             const Eigen::Vector3d& centroidInPatient)
    : freedom_(freedom.fromStart(start.rotation)), centroidInStart_(start * centroidInPatient)
{
}

Vector6d SourceFreedom::dampedStep(const NormalEquations& equations, double damping, const RigidTransform& pose,
                                   Freedom freedom) const
{
    return isFull() ? core::dampedStep(equations, damping, freedom)
                    : core::dampedStep(equations, damping, freeTwists(pose, freedom));
}

Vector6d SourceFreedom::descentDirection(const Vector6d& gradient, const Vector6d& weights, const RigidTransform& pose,
                                         Freedom freedom) const
{
    if (isFull()) {
        return -weights.cwiseProduct(gradient);
    }
    Vector6d direction = Vector6d::Zero();
    const StepBasis twists = freeTwists(pose, freedom);
    for (const auto& twist : twists.colwise()) {
        const double weight = twist.head<3>().isZero(0.0) ? weights[5] : weights[0];
        direction -= weight * twist.dot(gradient) * twist;
    }
    return direction;
}

RigidTransform SourceFreedom::retract(const RigidTransform& pose, const Vector6d& twist) const
{
    RigidTransform next = expSe3(twist) * pose;
    if (isFull()) {
        return next;
    }
    return cameraFromPatient(freedom_.restoreLockedAxes(core::aboutCentroid(next, centroidInStart_)), centroidInStart_);
}

/// Returns the allowed twists. A rotation by ω about the centroid c is one about the source plus a shift by c × ω.
StepBasis SourceFreedom::freeTwists(const RigidTransform& pose, Freedom freedom) const
{
    const CentroidPose place = core::aboutCentroid(pose, centroidInStart_);
    Matrix6d twistFromStep = Matrix6d::Identity();
    twistFromStep.bottomLeftCorner<3, 3>() = skew(place.centroidInCamera);
    if (freedom == Freedom::Full) {
        return twistFromStep * freedom_.freeSteps(place);
    }
    const Matrix6d steps = freedom_.stepsPerCoordinate(place);
    const Eigen::Vector3d pivot = freedom_.coordinates(place).tail<3>();
    StepBasis twists(6, 0);
    for (Eigen::Index angle = 0; angle < 3; ++angle) {
        if (freedom_.isLocked(angle)) {
            continue;
        }
        Vector6d coordinates = Vector6d::Unit(angle);
        coordinates.tail<3>() = steps.col(angle).head<3>().cross(pivot);
        for (Eigen::Index shift = 3; shift < 6; ++shift) {
            coordinates[shift] = freedom_.isLocked(shift) ? 0.0 : coordinates[shift];
        }
        twists.conservativeResize(6, twists.cols() + 1);
        twists.rightCols<1>() = twistFromStep * steps * coordinates;
    }
    return twists;
}

}   // namespace angiopose::core
