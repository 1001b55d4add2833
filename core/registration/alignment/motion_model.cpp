#include "core/registration/alignment/motion_model.h"

#include "core/support/symmetric.h"

#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr std::size_t maxRememberedSteps = 30;   // number of frames kept, about two seconds of fluoroscopy
constexpr std::size_t enoughForAxis = 4;
constexpr double minAxisMm = 0.3;   // minimum RMS step; slower motion has no reliable direction

}   // namespace

MotionModel::MotionModel(const CentroidPose& pose, double spreadMm, const Noise& noise)
    : pose_(pose), mmPerParameter_(Vector6d::Ones()), noise_(noise)
{
    mmPerParameter_.head<3>().setConstant(spreadMm);
}

/// Returns the component of the last step along the principal axis of the recent steps.
Vector6d MotionModel::breathingComponent(const Vector6d& step) const
{
    if (steps_.size() < enoughForAxis) {
        return Vector6d::Zero();
    }
    Matrix6d scatter = Matrix6d::Zero();
    for (const Vector6d& past : steps_) {
        scatter += past * past.transpose() / static_cast<double>(steps_.size());
    }
    const EigenDecomposition<6> axes = eigenDecomposition(scatter);
    const Vector6d axis = axes.directions.col(5);
    const bool isClear = axes.values[5] > minAxisMm * minAxisMm;
    return isClear ? Vector6d(axis.dot(step) * axis) : Vector6d::Zero();
}

InitialPosePrior MotionModel::predict() const
{
    CentroidPose predicted = pose_;
    Vector6d expected = Vector6d::Zero();
    if (isMoving_ && missedFrames_ == 0) {
        expected = breathingComponent(steps_.back());
        predicted = retract(pose_, expected.cwiseQuotient(mmPerParameter_));
    }
    const double wider = std::sqrt(1.0 + missedFrames_);
    const double rotation = noise_.rotationDeg * std::numbers::pi / 180.0;
    Vector6d std;
    std << rotation, rotation, rotation, noise_.shiftMm, noise_.shiftMm, noise_.shiftMm;
    // Adds half the predicted step to the standard deviation because breathing may stop or reverse.
    std = wider * (std.cwiseAbs2() + 0.25 * expected.cwiseQuotient(mmPerParameter_).cwiseAbs2()).cwiseSqrt();
    return independentPrior(predicted, std);
}

void MotionModel::advance(const std::optional<CentroidPose>& pose)
{
    if (!pose) {
        ++missedFrames_;
        return;
    }
    if (missedFrames_ == 0) {
        steps_.emplace_back(stepBetween(pose_, *pose).cwiseProduct(mmPerParameter_));
        isMoving_ = true;
    }
    if (steps_.size() > maxRememberedSteps) {
        steps_.pop_front();
    }
    missedFrames_ = 0;
    pose_ = *pose;
}

void MotionModel::resetTo(const CentroidPose& pose)
{
    pose_ = pose;
    missedFrames_ = 0;
    isMoving_ = false;
}

}   // namespace angiopose::core
