#include "core/measuring/check_point_error.h"

#include "core/geometry/angle_units.h"
#include "core/messages/says.h"
#include "core/support/symmetric.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double leastAngleDeg = 10.0;   // below that a pixel along the image is 6 pixels along the ray
constexpr int refinements = 10;

/// A ray in patient axes.
struct Ray {
    Eigen::Vector3d source;
    Eigen::Vector3d direction;   ///< unit
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

/// The point with the smallest sum of squared distances from the rays.
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

/// Gauss-Newton on the pixels; the point as it is where one of the images cannot show it.
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

/// Millimetres in the plane of the image at a depth, for a pixel along u and along v.
Eigen::Vector2d mmPerPixel(const ProjectionCamera& camera, double depthMm)
{
    return {depthMm / std::abs(camera.fx), depthMm / std::abs(camera.fy)};
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
        return Error(says::checkBehindSource());
    }
    const Eigen::Vector2d pixelMm = mmPerPixel(sight.camera, inCamera.z());
    const Eigen::Vector2d apart = seenPx - *expected;
    return ImageError{
        *expected, seenPx, apart.norm(), apart.cwiseProduct(pixelMm).norm(), inCamera.z(), std::sqrt(pixelMm.prod())};
}

Eigen::Matrix3d placeCovariance(const Matrix6d& poseCovariance, const Eigen::Vector3d& armInCamera)
{
    Eigen::Matrix<double, 3, 6> shift;   // ω × a + δ
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
        return Error(says::checkNeedsTwoViews());
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
    if (!(meeting.angleDeg >= leastAngleDeg)) {
        return Error(says::checkRaysAlike(Quantity{meeting.angleDeg, 1, "°"}));
    }
    meeting.pointInPatient = refined(seen, nearestToRays(rays));
    for (const Ray& ray : rays) {
        meeting.raysApartMm =
            std::max(meeting.raysApartMm, (acrossRay(ray) * (meeting.pointInPatient - ray.source)).norm());
    }
    return meeting;
}

}   // namespace angiopose::core
