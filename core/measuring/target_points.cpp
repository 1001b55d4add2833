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

constexpr double minAngleDeg = 10.0;   // below this angle, one pixel in the image is 6 pixels along the ray
constexpr int refinements = 10;

/// A ray from the X-ray source, in patient coordinates.
struct Ray {
    Eigen::Vector3d source;
    Eigen::Vector3d direction;   ///< unit vector
};

Ray rayOf(const PointedPixel& seen)
{
    const RigidTransform patientFromCamera = seen.sight.cameraFromPatient.inverse();
    return {patientFromCamera.translation,
            patientFromCamera.rotation * rayThroughPixel(seen.sight.camera, seen.seenPx)};
}

Eigen::Matrix3d acrossRay(const Ray& ray)
{
    return Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
}

double widestAngleDeg(const std::vector<Ray>& rays)
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
Eigen::Vector3d nearestToRays(const std::vector<Ray>& rays)
{
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(3, 1);
    for (const Ray& ray : rays) {
        normal += acrossRay(ray);
        right += acrossRay(ray) * ray.source;
    }
    return solveSymmetric(normal, right);
}

/// Refines by Gauss–Newton on the pixels; returns the point unchanged if it does not project into one of the images.
Eigen::Vector3d refined(std::span<const PointedPixel> seen, Eigen::Vector3d point)
{
    for (int k = 0; k < refinements; ++k) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(3, 3);
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(3, 1);
        for (const PointedPixel& each : seen) {
            const Eigen::Vector3d inCamera = each.sight.cameraFromPatient * point;
            const auto pixel = project(each.sight.camera, inCamera);
            if (!pixel) {
                return point;
            }
            const Eigen::Matrix<double, 2, 3> jacobian =
                projectionJacobian(each.sight.camera, inCamera) * each.sight.cameraFromPatient.rotation;
            normal += jacobian.transpose() * jacobian;
            right += jacobian.transpose() * (each.seenPx - *pixel);
        }
        point += solveSymmetric(normal, right);
    }
    return point;
}

/// Returns the millimeters per pixel, along u and v, in the plane parallel to the detector at this depth.
Eigen::Vector2d mmPerPixel(const ProjectionCamera& camera, double depthMm)
{
    return {depthMm / std::abs(camera.fx), depthMm / std::abs(camera.fy)};
}

/// Returns the marked position in the view's current frame, or else the first one; null if there is none.
const Sighting* sightingOf(const View& view, int markId)
{
    const Sighting* found = nullptr;
    for (const Sighting& each : view.sightings) {
        if (each.markId == markId && (!found || each.frame == view.frame)) {
            found = &each;
        }
    }
    return found;
}

std::optional<double> errorDeformed(const View& view, const Vessels& vessels, const Sight& sight,
                                    const VesselMark& mark, const Sighting& seen)
{
    const auto deformation = knownDeformation(view, vessels, sight.cameraFromPatient);
    if (!deformation) {
        return std::nullopt;
    }
    const VesselTree deformed = deformedTreeAt(*vessels.tree, *deformation, sight.cameraFromPatient);
    const auto error = imageError(sight, movedWith(*vessels.tree, deformed, mark).pointInPatient, seen.pixel);
    return error ? std::optional(error.value().mm) : std::nullopt;
}

CheckedView checkedView(const View& view, const Vessels& vessels, const RigidTransform& pose, const VesselMark& mark,
                        const Sighting& seen)
{
    CheckedView checked{0, seen.frame, Error(messages::checkNotSeen()), {}, {}};
    const auto camera = cameraOf(view);
    if (!camera) {
        checked.error = camera.error();
        return checked;
    }
    if (seen.frame != view.frame) {
        checked.error = Error(messages::checkOtherFrame(seen.frame + 1, view.frame + 1));
        return checked;
    }
    const Sight sight{camera.value(), pose};
    checked.error = imageError(sight, mark.pointInPatient, seen.pixel);
    checked.deformedMm = errorDeformed(view, vessels, sight, mark, seen);
    const bool isFound = view.result && view.result->cameraFromPatient.matrix() == pose.matrix();
    if (isFound && vessels.tree) {
        checked.claimed = claimedError(*view.result, *vessels.tree, camera.value(), mark.pointInPatient);
    }
    return checked;
}

std::string listed(const std::vector<std::size_t>& views)
{
    std::string text;
    for (const std::size_t view : views) {
        text += (text.empty() ? "" : ", ") + std::to_string(view + 1);
    }
    return text;
}

CheckedPoint checkedPoint(const Case& session, const VesselMark& mark, const PoseOfView& poseOf)
{
    CheckedPoint checked{mark, {}, Error(messages::checkNeedsTwoViews()), {}, {}};
    std::vector<PointedPixel> rays;
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        const View& view = session.views[place];
        const Sighting* seen = view.angiogram ? sightingOf(view, mark.id) : nullptr;
        if (!seen) {
            continue;
        }
        const RigidTransform pose = poseOf(place);
        CheckedView& reported = checked.views.emplace_back(checkedView(view, session.vessels, pose, mark, *seen));
        reported.view = place;
        if (!reported.error) {
            continue;
        }
        rays.push_back({{cameraOf(view).value(), pose}, seen->pixel});
        checked.meetingViews.push_back(place);
        if (reported.claimed) {
            const double claimed = reported.claimed->spaceMm;
            checked.claimedSpaceMm = std::min(claimed, checked.claimedSpaceMm.value_or(claimed));
        }
    }
    checked.meeting = meetingPoint(rays);
    return checked;
}

Message offBy(double mm, const std::optional<double>& claimedMm)
{
    const Quantity off = inMm(mm, 1);
    return claimedMm ? messages::checkLabelClaimed(off, inMm(*claimedMm, 1)) : messages::checkLabel(off);
}

}   // namespace

Result<ImageError> imageError(const Sight& sight, const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& seenPx)
{
    if (const auto problem = findProblem(sight.camera)) {
        return Error(*problem);
    }
    const Eigen::Vector3d inCamera = sight.cameraFromPatient * pointInPatient;
    const auto expected = project(sight.camera, inCamera);
    if (!expected) {
        return Error(messages::checkBehindSource());
    }
    const Eigen::Vector2d pixelMm = mmPerPixel(sight.camera, inCamera.z());
    const Eigen::Vector2d apart = seenPx - *expected;
    return ImageError{
        *expected, seenPx, apart.norm(), apart.cwiseProduct(pixelMm).norm(), inCamera.z(), std::sqrt(pixelMm.prod())};
}

Eigen::Matrix3d placeCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& armInCamera)
{
    Eigen::Matrix<double, 3, 6> shift;   // displacement of the point, ω × a + δ, as a matrix
    shift << -skew(armInCamera), Eigen::Matrix3d::Identity();
    return shift * poseCovariance * shift.transpose();
}

ClaimedError claimedError(const RegistrationResult& result, const VesselTree& tree, const ProjectionCamera& camera,
                          const Eigen::Vector3d& pointInPatient)
{
    const RigidTransform& pose = result.cameraFromPatient;
    const Eigen::Vector3d arm = pose.rotation * (pointInPatient - centroidInPatient(tree));
    const Eigen::Vector3d inCamera = pose * pointInPatient;
    const PoseUncertainty& uncertainty = result.uncertainty;
    ClaimedError claimed{0.0, std::sqrt(std::max(0.0, placeCovariance(uncertainty.covariance, arm).trace()))};
    if (inCamera.z() >= minProjectableDepthMm) {
        const Eigen::Matrix<double, 2, 3> inPlane =
            mmPerPixel(camera, inCamera.z()).asDiagonal() * projectionJacobian(camera, inCamera);
        const Eigen::Matrix2d across =
            inPlane * placeCovariance(uncertainty.imageCovariance, arm) * inPlane.transpose();
        claimed.inPlaneMm = std::sqrt(std::max(0.0, across.trace()));
    }
    return claimed;
}

Result<MeetingPoint> meetingPoint(std::span<const PointedPixel> seen)
{
    if (seen.size() < 2) {
        return Error(messages::checkNeedsTwoViews());
    }
    std::vector<Ray> rays;
    for (const PointedPixel& each : seen) {
        if (const auto problem = findProblem(each.sight.camera)) {
            return Error(*problem);
        }
        rays.push_back(rayOf(each));
    }
    MeetingPoint meeting;
    meeting.angleDeg = widestAngleDeg(rays);
    if (!(meeting.angleDeg >= minAngleDeg)) {
        return Error(messages::checkRaysAlike(Quantity{meeting.angleDeg, 1, "°"}));
    }
    meeting.pointInPatient = refined(seen, nearestToRays(rays));
    for (const Ray& ray : rays) {
        meeting.raysApartMm =
            std::max(meeting.raysApartMm, (acrossRay(ray) * (meeting.pointInPatient - ray.source)).norm());
    }
    return meeting;
}

std::vector<CheckedPoint> checkedPoints(const Case& session, const PoseOfView& poseOf)
{
    std::vector<CheckedPoint> checked;
    for (const VesselMark& mark : session.vessels.marks) {
        if (mark.kind == VesselMarkKind::TargetPoint) {
            checked.push_back(checkedPoint(session, mark, poseOf));
        }
    }
    return checked;
}

std::vector<CheckedPoint> checkedPoints(const Case& session)
{
    return checkedPoints(session, [&session](std::size_t view) { return session.views[view].cameraFromPatient; });
}

std::optional<Message> labelOf(const CheckedPoint& checked, std::size_t shownView)
{
    const auto shown = std::ranges::find(checked.views, shownView, &CheckedView::view);
    if (shown != checked.views.end() && shown->error) {
        const std::optional<double> claimed = shown->claimed ? std::optional(shown->claimed->inPlaneMm) : std::nullopt;
        return offBy(shown->error.value().mm, claimed);
    }
    return checked.meeting ? std::optional(offBy(checked.spaceMm(), checked.claimedSpaceMm)) : std::nullopt;
}

Messages sentencesOf(const CheckedView& checked)
{
    if (!checked.error) {
        return {checked.error.error().message};
    }
    const ImageError& error = checked.error.value();
    Messages sentences{messages::checkImageError(inMm(error.depthMm, 0), inMm(error.mm, 2), Quantity{error.px, 1, "px"},
                                                 inMm(error.mmPerPx, 2)),
                       checked.claimed ? messages::checkClaimed(inMm(checked.claimed->inPlaneMm, 2))
                                       : messages::checkNothingClaimed()};
    if (checked.deformedMm) {
        sentences.push_back(messages::checkDeformed(inMm(*checked.deformedMm, 2)));
    }
    return sentences;
}

Messages spaceSentences(const CheckedPoint& checked)
{
    if (checked.views.empty()) {
        return {messages::checkNotSeen()};
    }
    if (!checked.meeting) {
        return {checked.meeting.error().message};
    }
    const MeetingPoint& meeting = checked.meeting.value();
    Messages sentences{messages::checkSpaceError(listed(checked.meetingViews), Quantity{meeting.angleDeg, 0, "°"},
                                                 inMm(checked.spaceMm(), 2), inMm(meeting.raysApartMm, 2))};
    if (checked.claimedSpaceMm) {
        sentences.push_back(messages::checkClaimed(inMm(*checked.claimedSpaceMm, 2)));
    }
    return sentences;
}

}   // namespace angiopose::core
