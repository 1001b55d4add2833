#pragma once

#include "core/registration/deformable/field_kernel.h"
#include "core/registration/pose/centroid_pose.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Observation of one knot in an image: its distance across its vessel, caused by pose, geometry and motion together.
struct MotionRow {
    std::size_t knot = 0;
    std::size_t view = 0;
    Eigen::Vector3d byMotion;   ///< see KnotLook
    Vector6d byPose;
    Vector6d byGeometry;
    double valueMm = 0.0;
    double variance = 1.0;   ///< mm²; an unseen knot has no row
};

/// Prior of the pose (a step about its initial value), of the geometry of further views, and of the motion.
struct MotionPrior {
    Matrix6d pose = Matrix6d::Identity();   ///< covariance, rad and mm
    Matrix6d geometry = Matrix6d::Zero();   ///< covariance of the correction of each view except the first
    MotionVariances motion{};
};

/// Belief about six linear functions of pose and motion.
struct LinearBelief {
    Vector6d mean = Vector6d::Zero();
    Matrix6d covariance = Matrix6d::Zero();
};

/// Posterior of pose and motion field given the rows of all images: Gaussian process regression with the pose in the
/// same normal equations (ALGORITHMS §11.2), solved in the space of rows.
class FieldPosterior {
public:
    /// `kernel` must outlive the posterior.
    FieldPosterior(const FieldKernel& kernel, const MotionPrior& prior, std::vector<MotionRow> rows);

    Vector6d pose() const;
    Vector6d geometry(std::size_t view) const;
    Eigen::Matrix3Xd motion() const;   ///< motion of all knots

    /// log N(values; 0, covariance)
    double logEvidence() const;

    /// Variance of the noise-free value of a row, for the given rows or for others. Cheap for the given rows.
    Eigen::VectorXd variances() const;
    Eigen::VectorXd variancesOf(const std::vector<MotionRow>& others) const;

    /// Covariance of the positions of these knots in the camera of the first view (mm²), from pose and motion together:
    /// `byPose[k]` is the effect of the step on the position of `knots[k]`.
    std::vector<Eigen::Matrix3d> placeCovariances(const std::vector<std::size_t>& knots,
                                                  const std::vector<Eigen::Matrix<double, 3, 6>>& byPose,
                                                  const Eigen::Matrix3d& cameraFromPatient) const;

    /// Belief about `byMotion` · (motion of all knots, patient axes, knot by knot) + step of the pose, given the prior
    /// `pose` of that step. The posterior must have been built without a pose prior (zero covariance), because wide
    /// pose priors combined with precise rows require double precision.
    LinearBelief beliefWithPose(const Eigen::Matrix<float, 6, Eigen::Dynamic>& byMotion,
                                const LinearBelief& pose) const;

    /// Variances that make the estimated motions likely (MacKay 1992): σ² = |w|²/γ, γ the number of well-determined
    /// parameters, with a weak prior that keeps them finite.
    MotionVariances learnedVariances() const;

    /// Number of parameters that the rows determine, that is, the degrees of freedom to subtract in a noise estimate.
    double determined() const;

private:
    /// Design matrix of the rows by columns: motion (3), pose (6), geometry (6 per view), each scaled by the square
    /// root of its prior.
    struct RowBasis {
        Eigen::Matrix3Xf motion;
        Eigen::MatrixXf steps;
    };
    RowBasis basisOf(const std::vector<MotionRow>& rows) const;
    /// Covariances of all given rows with another row.
    Eigen::VectorXf covariances(const MotionRow& row, const Eigen::Vector3f& motion,
                                const Eigen::VectorXf& steps) const;

    const FieldKernel& kernel_;
    MotionPrior prior_;
    std::vector<MotionRow> rows_;
    RowBasis basis_;
    Eigen::MatrixXf combined_;   ///< covariance of the knots
    Eigen::MatrixXf inverseFactor_;   ///< lower triangle V; VᵀV is the inverse of the covariance of the rows
    Eigen::VectorXd explained_;   ///< inverse covariance times values
    double logDeterminant_ = 0.0;
};

}   // namespace angiopose::core
