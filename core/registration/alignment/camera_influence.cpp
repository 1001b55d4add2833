#include "core/registration/alignment/camera_influence.h"

#include "core/messages/messages.h"
#include "core/support/symmetric.h"

#include <cmath>
#include <string>

namespace angiopose::core {
namespace {

constexpr Eigen::Index perCamera = 3;

// Minimum gain for a contradiction. With correct cameras the gain stays below 9 (one view) and 11.4 (two views),
// measured in 80 registrations each on synthetic trees (wrong_geometry_table --family development).
double minGain(std::size_t cameras)
{
    return 10.0 + 2.0 * static_cast<double>(cameras);
}

constexpr double informativeSigmas = 2.5;   // minimum significance of a reported error
constexpr double minFocalShare = 0.01;   // relative focal-length errors below this are irrelevant
constexpr double minPrincipalPx = 4.0;

}   // namespace

CameraInfluence::CameraInfluence(const StackedEquations& equations, const Eigen::MatrixXd& free,
                                 std::span<const CameraUncertainty> uncertainties)
{
    const auto count = perCamera * static_cast<Eigen::Index>(uncertainties.size());
    const Eigen::Index poseCount = equations.hessian.rows() - count;
    Eigen::VectorXd std(count), appliedError(count);
    for (std::size_t k = 0; k < uncertainties.size(); ++k) {
        const auto at = perCamera * static_cast<Eigen::Index>(k);
        std.segment<perCamera>(at) = uncertainties[k].std();
        appliedError.segment<perCamera>(at) = uncertainties[k].appliedError;
    }
    const Eigen::MatrixXd H = equations.hessian.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd crossed = H.topRightCorner(poseCount, count);
    const Eigen::MatrixXd ofPose = free.transpose() * H.topLeftCorner(poseCount, poseCount) * free;
    shift_ = -free * solveSymmetric(ofPose, free.transpose() * crossed);
    // The pose absorbs part of every camera error; the images constrain only the remainder.
    const Eigen::VectorXd weight = std.cwiseAbs2().cwiseInverse();
    const Eigen::VectorXd pull =
        -(equations.gradient.tail(count) + shift_.transpose() * equations.gradient.head(poseCount) +
          weight.cwiseProduct(appliedError));
    Eigen::MatrixXd information = H.bottomRightCorner(count, count) + crossed.transpose() * shift_;
    information.diagonal() += weight;
    error_ = solveSymmetric(information, pull);
    posteriorCovariance_ = solveSymmetric(information, Eigen::MatrixXd::Identity(count, count));
    gain_ = pull.dot(error_);
}

Matrix6d CameraInfluence::poseCovariance() const
{
    const Eigen::MatrixXd shift = shift_.topRows(6);
    return shift * (posteriorCovariance_ + error_ * error_.transpose()) * shift.transpose();
}

CameraEvidence CameraInfluence::evidence(std::size_t camera) const
{
    const auto at = perCamera * static_cast<Eigen::Index>(camera);
    const Eigen::VectorXd std = posteriorCovariance_.diagonal().cwiseMax(0.0).cwiseSqrt();
    return {error_.segment<perCamera>(at), std.segment<perCamera>(at), gain_};
}

Messages contradictionsOf(const CameraEvidence& evidence, const ProjectionCamera& camera, std::size_t cameras)
{
    Messages messages;
    if (evidence.gain < minGain(cameras)) {
        return messages;
    }
    const double focalShare = std::expm1(evidence.error[0]);
    if (std::abs(evidence.error[0]) > std::max(minFocalShare, informativeSigmas * evidence.std[0])) {
        const Quantity percent{100.0 * std::abs(focalShare), 1, "%"};
        messages.push_back(focalShare > 0.0 ? messages::cameraFocalLonger(percent)
                                            : messages::cameraFocalShorter(percent));
    }
    const Eigen::Vector2d shift = evidence.error.tail<2>();
    const Eigen::Vector2d sigmas = shift.cwiseQuotient(evidence.std.tail<2>().eval());
    if (sigmas.cwiseAbs().maxCoeff() > informativeSigmas && shift.norm() > minPrincipalPx) {
        const Eigen::Vector2d there = shift + Eigen::Vector2d(camera.cx, camera.cy);
        messages.push_back(messages::cameraPrincipalPointOff(Quantity{shift.norm(), 0, "px"},
                                                             static_cast<int>(std::lround(there.x())),
                                                             static_cast<int>(std::lround(there.y()))));
    }
    return messages;
}

}   // namespace angiopose::core
