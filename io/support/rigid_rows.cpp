#include "io/support/rigid_rows.h"

#include "io/support/file_error.h"

#include <Eigen/LU>
#include <algorithm>

namespace io {
namespace {

constexpr double roundingTolerance = 1e-3;   // files in the wild carry six digits or fewer
constexpr double exactTolerance = 1e-12;   // closer than this the matrix is taken to the bit

bool isFourByFour(const MatrixRows& rows)
{
    return rows.size() == 4 &&
           std::all_of(rows.begin(), rows.end(), [](const std::vector<double>& row) { return row.size() == 4; });
}

}   // namespace

core::Result<core::RigidTransform> rigidFromRows(const MatrixRows& rows, const std::string& place)
{
    if (!isFourByFour(rows)) {
        return fileError(place, "the pose is not a 4×4 matrix. Write four rows of four numbers.");
    }
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix(row, column) = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        }
    }
    if (!matrix.allFinite()) {
        return fileError(place, "the pose has a value that is not a number. Write finite numbers only.");
    }
    if ((matrix.row(3) - Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0)).cwiseAbs().maxCoeff() > roundingTolerance) {
        return fileError(place, "the last row of the pose is not 0 0 0 1. Is the matrix stored column by column?");
    }
    core::RigidTransform transform{matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
    if (!core::isRigid(transform, roundingTolerance)) {
        const bool isMirror = transform.rotation.determinant() < 0.0;
        return fileError(place, isMirror
                                    ? "the pose mirrors (its determinant is negative). A mirrored image belongs into "
                                      "the camera as a positive fx, never into the pose."
                                    : "the upper left 3×3 of the pose is not a rotation. Remove scale and shear.");
    }
    if (!core::isRigid(transform, exactTolerance)) {
        transform.rotation = core::nearestRotation(transform.rotation);
    }
    return transform;
}

MatrixRows rowsOf(const core::RigidTransform& transform)
{
    const Eigen::Matrix4d matrix = transform.matrix();
    MatrixRows rows(4, std::vector<double>(4));
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = matrix(row, column);
        }
    }
    return rows;
}

}   // namespace io
