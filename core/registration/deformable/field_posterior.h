#pragma once

#include "core/registration/deformable/field_kernel.h"
#include "core/registration/pose/centroid_pose.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// What an image tells of one knot: how far it lies across its vessel, by pose, geometry and motion together.
struct MotionRow {
    std::size_t knot = 0;
    std::size_t view = 0;
    Eigen::Vector3d byMotion;   ///< see KnotLook
    Vector6d byPose;
    Vector6d byGeometry;
    double valueMm = 0.0;
    double variance = 1.0;   ///< mm²; not seen: no row
};

/// What is known beforehand: of the pose (a step about its start), of the geometry of further views, and of the motion.
struct MotionPrior {
    Matrix6d pose = Matrix6d::Identity();   ///< covariance, rad and mm
    Matrix6d geometry = Matrix6d::Zero();   ///< of the correction of each view but the first
    MotionVariances motion{};
};

/// What is known of six linear functions of pose and motion.
struct LinearBelief {
    Vector6d mean = Vector6d::Zero();
    Matrix6d covariance = Matrix6d::Zero();
};

/// Pose and field of motion given the rows of all images: Gaussian process regression with the pose in the same normal
/// equations (ALGORITHMS §11.2), solved over the rows.
class FieldPosterior {
public:
    /// `kernel` outlives it.
    FieldPosterior(const FieldKernel& kernel, const MotionPrior& prior, std::vector<MotionRow> rows);

    Vector6d pose() const;
    Vector6d geometry(std::size_t view) const;
    Eigen::Matrix3Xd motion() const;   ///< of all knots

    /// log N(values; 0, covariance)
    double logEvidence() const;

    /// Variance of what a row would say without its noise; of rows that were given, and of others. Cheap for the
    /// former.
    Eigen::VectorXd variances() const;
    Eigen::VectorXd variancesOf(const std::vector<MotionRow>& others) const;

    /// Covariance of places of these knots in the camera of the first view (mm²), from pose and motion together:
    /// `byPose[k]` is the step's effect on the place of `knots[k]`.
    std::vector<Eigen::Matrix3d> placeCovariances(const std::vector<std::size_t>& knots,
                                                  const std::vector<Eigen::Matrix<double, 3, 6>>& byPose,
                                                  const Eigen::Matrix3d& cameraFromPatient) const;

    /// Of `byMotion` · (motion of all knots, patient axes, knot by knot) + step of the pose, when `pose` is known of
    /// that step beforehand. The posterior itself must have been made without one (a covariance of zero): wide priors
    /// of the pose beside fine rows ask for double precision.
    LinearBelief beliefWithPose(const Eigen::Matrix<float, 6, Eigen::Dynamic>& byMotion,
                                const LinearBelief& pose) const;

    /// The variances under which motions as found are likely (MacKay 1992): σ² = |w|²/γ, γ the number of well
    /// determined parameters, with a weak pull that keeps them finite.
    MotionVariances learnedVariances() const;

    /// Number of parameters that the rows determine: what a noise estimate loses as degrees of freedom.
    double determined() const;

private:
    /// What rows say, as columns: motion (3), pose (6), geometry (6 per view), each scaled by the root of its prior.
    struct RowBasis {
        Eigen::Matrix3Xf motion;
        Eigen::MatrixXf steps;
    };
    RowBasis basisOf(const std::vector<MotionRow>& rows) const;
    /// Of all given rows with another one.
    Eigen::VectorXf covariances(const MotionRow& row, const Eigen::Vector3f& motion,
                                const Eigen::VectorXf& steps) const;

    const FieldKernel& kernel_;
    MotionPrior prior_;
    std::vector<MotionRow> rows_;
    RowBasis basis_;
    Eigen::MatrixXf combined_;   ///< of the knots
    Eigen::MatrixXf inverseFactor_;   ///< lower triangle V with VᵀV the inverse of the covariance of the rows
    Eigen::VectorXd explained_;   ///< inverse times values
    double logDeterminant_ = 0.0;
};

}   // namespace angiopose::core
