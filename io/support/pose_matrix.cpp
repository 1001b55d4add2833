#include "io/support/pose_matrix.h"

#include "io/messages/messages.h"

#include <Eigen/LU>
#include <algorithm>

namespace angiopose::io {
namespace {

constexpr double exactTolerance = 1e-12;
constexpr double roundedTolerance = 1e-3;

}   // namespace

core::Result<core::RigidTransform> poseFromRows(const MatrixRows& rows)
{
    const bool isFourByFour =
        rows.size() == 4 && std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.size() == 4; });
    if (!isFourByFour) {
        return core::Error(messages::poseRows());
    }
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            matrix(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
        }
    }
    if (!matrix.allFinite()) {
        return core::Error(messages::poseNotFinite());
    }
    if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-9) {
        return core::Error(messages::poseLastRow());
    }
    core::RigidTransform pose{matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
    if (pose.rotation.determinant() < 0.0) {
        return core::Error(messages::poseReflection());
    }
    const Eigen::Matrix3d nearest = core::nearestRotation(pose.rotation);
    const double deviation = (pose.rotation - nearest).cwiseAbs().maxCoeff();
    if (!(deviation <= roundedTolerance)) {
        return core::Error(messages::poseNoRotation());
    }
    if (deviation > exactTolerance) {
        pose.rotation = nearest;
    }
    return pose;
}

MatrixRows rowsOf(const core::RigidTransform& pose)
{
    const Eigen::Matrix4d matrix = pose.matrix();
    MatrixRows rows(4, std::vector<double>(4));
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = matrix(i, k);
        }
    }
    return rows;
}

}   // namespace angiopose::io
