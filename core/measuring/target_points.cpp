#include "core/measuring/target_points.h"

#include "core/case/known_deformation.h"
#include "core/geometry/angle_units.h"
#include "core/messages/messages.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/support/symmetric.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double minAngleDeg = 10.0;   // at this angle, one pixel in the image is 6 pixels along the ray
constexpr int refinementIterations = 10;

/// A ray from the X-ray source, in patient coordinates.
struct Ray {
    Eigen::Vector3d source;
    Eigen::Vector3d direction;   ///< unit vector
};

Ray rayOf(const MarkedPixel& seen)
{
    const RigidTransform patientFromCamera = seen.posedCamera.cameraFromPatient.inverse();
    return {patientFromCamera.translation,
            patientFromCamera.rotation * rayThroughPixel(seen.posedCamera.camera, seen.markedPx)};
}

Eigen::Matrix3d rayNormalProjector(const Ray& ray)
{
    return Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
}

double maxAngleDeg(const std::vector<Ray>& rays)
{
    double widest = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t j = i + 1; j < rays.size(); ++j) {
            const double sine = rays[i].direction.cross(rays[j].direction).norm();
            widest = std::max(widest, degreesPerRadian * std::asin(std::min(1.0, sine)));
        }
    }
    return widest;
}

/// Returns the point with the smallest sum of squared distances to the rays.
Eigen::Vector3d nearestPointToRays(const std::vector<Ray>& rays)
{
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(3, 1);
    for (const Ray& ray : rays) {
        normal += rayNormalProjector(ray);
        right += rayNormalProjector(ray) * ray.source;
    }
    return solveSymmetric(normal, right);
}

/// Refines by Gauss–Newton on the pixels; returns the point unchanged if it does not project into one of the images.
Eigen::Vector3d refinePoint(std::span<const MarkedPixel> seen, Eigen::Vector3d point)
{
    for (int k = 0; k < refinementIterations; ++k) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(3, 1);
        for (const MarkedPixel& each : seen) {
            const Eigen::Vector3d inCamera = each.posedCamera.cameraFromPatient * point;
            const auto pixel = project(each.posedCamera.camera, inCamera);
            if (!pixel) {
                return point;
            }
            const Eigen::Matrix<double, 2, 3> jacobian =
                projectionJacobian(each.posedCamera.camera, inCamera) * each.posedCamera.cameraFromPatient.rotation;
            normal += jacobian.transpose() * jacobian;
            right += jacobian.transpose() * (each.markedPx - *pixel);
        }
        point += solveSymmetric(normal, right);
    }
    return point;
}

/// Returns the size of a pixel in mm, along u and v, in the plane parallel to the detector at this depth.
Eigen::Vector2d pixelSizeMm(const ProjectionCamera& camera, double depthMm)
{
    return {depthMm / std::abs(camera.fx), depthMm / std::abs(camera.fy)};
}

/// Returns the marked position in the view's current frame, or else the first one; null if there is none.
const TargetObservation* observationOf(const View& view, int markId)
{
    const TargetObservation* found = nullptr;
    for (const TargetObservation& each : view.observations) {
        if (each.markId == markId && (!found || each.frame == view.frame)) {
            found = &each;
        }
    }
    return found;
}

std::optional<double> deformedErrorMm(const View& view, const Vessels& vessels, const PosedCamera& posedCamera,
                                      const VesselMark& mark, const TargetObservation& seen)
{
    const auto deformation = knownDeformation(view, vessels, posedCamera.cameraFromPatient);
    if (!deformation) {
        return std::nullopt;
    }
    const VesselTree deformed = deformedTreeAt(*vessels.tree, *deformation, posedCamera.cameraFromPatient);
    const auto error =
        imageError(posedCamera, moveWithVessels(*vessels.tree, deformed, mark).pointInPatient, seen.pixel);
    return error ? std::optional(error.value().mm) : std::nullopt;
}

TargetPointViewResult evaluateInView(const View& view, const Vessels& vessels, const RigidTransform& pose,
                                     const VesselMark& mark, const TargetObservation& seen)
{
    TargetPointViewResult evaluation{0, seen.frame, Error(messages::checkNotMarked()), {}, {}};
    const auto camera = cameraOf(view);
    if (!camera) {
        evaluation.error = camera.error();
        return evaluation;
    }
    if (seen.frame != view.frame) {
        evaluation.error = Error(messages::checkOtherFrame(seen.frame + 1, view.frame + 1));
        return evaluation;
    }
    const PosedCamera posedCamera{camera.value(), pose};
    evaluation.error = imageError(posedCamera, mark.pointInPatient, seen.pixel);
    evaluation.deformedMm = deformedErrorMm(view, vessels, posedCamera, mark, seen);
    const bool isFound = view.result && view.result->cameraFromPatient.matrix() == pose.matrix();
    if (isFound && vessels.tree) {
        evaluation.predicted = predictError(*view.result, *vessels.tree, camera.value(), mark.pointInPatient);
    }
    return evaluation;
}

std::string joinedViewNumbers(const std::vector<std::size_t>& views)
{
    std::string text;
    for (const std::size_t view : views) {
        text += (text.empty() ? "" : ", ") + std::to_string(view + 1);
    }
    return text;
}

TargetPointResult evaluateTargetPoint(const Case& session, const VesselMark& mark, const PoseOfView& poseOf)
{
    TargetPointResult evaluation{mark, {}, Error(messages::checkNeedsTwoViews()), {}, {}};
    std::vector<MarkedPixel> rays;
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        const View& view = session.views[place];
        const TargetObservation* seen = view.angiogram ? observationOf(view, mark.id) : nullptr;
        if (!seen) {
            continue;
        }
        const RigidTransform pose = poseOf(place);
        TargetPointViewResult& reported =
            evaluation.views.emplace_back(evaluateInView(view, session.vessels, pose, mark, *seen));
        reported.view = place;
        if (!reported.error) {
            continue;
        }
        rays.push_back({{cameraOf(view).value(), pose}, seen->pixel});
        evaluation.triangulationViews.push_back(place);
        if (reported.predicted) {
            const double predicted = reported.predicted->spaceMm;
            evaluation.predictedSpaceMm = std::min(predicted, evaluation.predictedSpaceMm.value_or(predicted));
        }
    }
    evaluation.triangulated = triangulate(rays);
    return evaluation;
}

Message errorLabel(double mm, const std::optional<double>& predictedMm)
{
    const Quantity off = inMm(mm, 1);
    return predictedMm ? messages::checkLabelPredicted(off, inMm(*predictedMm, 1)) : messages::checkLabel(off);
}

}   // namespace

Result<ImageError> imageError(const PosedCamera& posedCamera, const Eigen::Vector3d& pointInPatient,
                              const Eigen::Vector2d& markedPx)
{
    if (const auto problem = findProblem(posedCamera.camera)) {
        return Error(*problem);
    }
    const Eigen::Vector3d inCamera = posedCamera.cameraFromPatient * pointInPatient;
    const auto expected = project(posedCamera.camera, inCamera);
    if (!expected) {
        return Error(messages::checkBehindSource());
    }
    const Eigen::Vector2d pixelMm = pixelSizeMm(posedCamera.camera, inCamera.z());
    const Eigen::Vector2d apart = markedPx - *expected;
    return ImageError{
        *expected, markedPx, apart.norm(), apart.cwiseProduct(pixelMm).norm(), inCamera.z(), std::sqrt(pixelMm.prod())};
}

Eigen::Matrix3d pointCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& leverArmInCamera)
{
    Eigen::Matrix<double, 3, 6> shift;   // displacement of the point, ω × a + δ, as a matrix
    shift << -skew(leverArmInCamera), Eigen::Matrix3d::Identity();
    return shift * poseCovariance * shift.transpose();
}

PredictedError predictError(const RegistrationResult& result, const VesselTree& tree, const ProjectionCamera& camera,
                            const Eigen::Vector3d& pointInPatient)
{
    const RigidTransform& pose = result.cameraFromPatient;
    const Eigen::Vector3d arm = pose.rotation * (pointInPatient - centroidInPatient(tree));
    const Eigen::Vector3d inCamera = pose * pointInPatient;
    const PoseUncertainty& uncertainty = result.uncertainty;
    PredictedError predicted{0.0, std::sqrt(std::max(0.0, pointCovariance(uncertainty.covariance, arm).trace()))};
    if (inCamera.z() >= minProjectableDepthMm) {
        const Eigen::Matrix<double, 2, 3> inPlane =
            pixelSizeMm(camera, inCamera.z()).asDiagonal() * projectionJacobian(camera, inCamera);
        const Eigen::Matrix2d across =
            inPlane * pointCovariance(uncertainty.imageCovariance, arm) * inPlane.transpose();
        predicted.inPlaneMm = std::sqrt(std::max(0.0, across.trace()));
    }
    return predicted;
}

Result<TriangulatedPoint> triangulate(std::span<const MarkedPixel> seen)
{
    if (seen.size() < 2) {
        return Error(messages::checkNeedsTwoViews());
    }
    std::vector<Ray> rays;
    for (const MarkedPixel& each : seen) {
        if (const auto problem = findProblem(each.posedCamera.camera)) {
            return Error(*problem);
        }
        rays.push_back(rayOf(each));
    }
    TriangulatedPoint triangulated;
    triangulated.angleDeg = maxAngleDeg(rays);
    if (!(triangulated.angleDeg >= minAngleDeg)) {
        return Error(messages::checkRaysNearlyParallel(Quantity{triangulated.angleDeg, 1, "°"}));
    }
    triangulated.pointInPatient = refinePoint(seen, nearestPointToRays(rays));
    for (const Ray& ray : rays) {
        triangulated.maxRayDistanceMm =
            std::max(triangulated.maxRayDistanceMm,
                     (rayNormalProjector(ray) * (triangulated.pointInPatient - ray.source)).norm());
    }
    return triangulated;
}

std::vector<TargetPointResult> evaluateTargetPoints(const Case& session, const PoseOfView& poseOf)
{
    std::vector<TargetPointResult> evaluation;
    for (const VesselMark& mark : session.vessels.marks) {
        if (mark.kind == VesselMarkKind::TargetPoint) {
            evaluation.push_back(evaluateTargetPoint(session, mark, poseOf));
        }
    }
    return evaluation;
}

std::vector<TargetPointResult> evaluateTargetPoints(const Case& session)
{
    return evaluateTargetPoints(session,
                                [&session](std::size_t view) { return session.views[view].cameraFromPatient; });
}

std::optional<Message> labelOf(const TargetPointResult& evaluation, std::size_t shownView)
{
    const auto shown = std::ranges::find(evaluation.views, shownView, &TargetPointViewResult::view);
    if (shown != evaluation.views.end() && shown->error) {
        const std::optional<double> predicted =
            shown->predicted ? std::optional(shown->predicted->inPlaneMm) : std::nullopt;
        return errorLabel(shown->error.value().mm, predicted);
    }
    return evaluation.triangulated ? std::optional(errorLabel(evaluation.spaceMm(), evaluation.predictedSpaceMm))
                                   : std::nullopt;
}

Messages sentencesOf(const TargetPointViewResult& evaluation)
{
    if (!evaluation.error) {
        return {evaluation.error.error().message};
    }
    const ImageError& error = evaluation.error.value();
    Messages sentences{messages::checkImageError(inMm(error.depthMm, 0), inMm(error.mm, 2), Quantity{error.px, 1, "px"},
                                                 inMm(error.mmPerPx, 2)),
                       evaluation.predicted ? messages::checkPredicted(inMm(evaluation.predicted->inPlaneMm, 2))
                                            : messages::checkNothingPredicted()};
    if (evaluation.deformedMm) {
        sentences.push_back(messages::checkDeformed(inMm(*evaluation.deformedMm, 2)));
    }
    return sentences;
}

Messages spaceErrorMessages(const TargetPointResult& evaluation)
{
    if (evaluation.views.empty()) {
        return {messages::checkNotMarked()};
    }
    if (!evaluation.triangulated) {
        return {evaluation.triangulated.error().message};
    }
    const TriangulatedPoint& triangulated = evaluation.triangulated.value();
    Messages sentences{messages::checkSpaceError(joinedViewNumbers(evaluation.triangulationViews),
                                                 Quantity{triangulated.angleDeg, 0, "°"}, inMm(evaluation.spaceMm(), 2),
                                                 inMm(triangulated.maxRayDistanceMm, 2))};
    if (evaluation.predictedSpaceMm) {
        sentences.push_back(messages::checkPredicted(inMm(*evaluation.predictedSpaceMm, 2)));
    }
    return sentences;
}

}   // namespace angiopose::core
