#pragma once

#include "core/registration/deformable/field_kernel.h"
#include "core/registration/pose/centroid_pose.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Observation of one knot in an image: the distance across its vessel, a sum of pose, geometry and motion effects.
struct MotionRow {
    std::size_t knot = 0;
    std::size_t view = 0;
    Eigen::Vector3d motionJacobian;   ///< see KnotProjection
    Vector6d poseJacobian;
    Vector6d geometryJacobian;
    double valueMm = 0.0;
    double variance = 1.0;   ///< mm²; knots without an observation have no row
};

/// Priors of the pose (a step about its initial value), the geometry of the further views, and the motion.
struct MotionPrior {
    Matrix6d pose = Matrix6d::Identity();   ///< covariance, rad and mm
    Matrix6d geometry = Matrix6d::Zero();   ///< covariance of the correction of each view but the first
    MotionVariances motion{};
};

/// Gaussian distribution of six linear functions of pose and motion.
struct GaussianEstimate {
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

    /// Returns log N(values; 0, covariance).
    double logEvidence() const;

    /// Returns the posterior variances of the noise-free values of the posterior's own rows (cheap), or of other rows.
    Eigen::VectorXd variances() const;
    Eigen::VectorXd variancesOf(const std::vector<MotionRow>& others) const;

    /// Returns the covariances of the positions of `knots` in the camera of the first view, mm², from pose and motion
    /// together; `poseJacobian[k]` is the derivative of the position of `knots[k]` with respect to the pose step.
    std::vector<Eigen::Matrix3d> positionCovariances(const std::vector<std::size_t>& knots,
                                                     const std::vector<Eigen::Matrix<double, 3, 6>>& poseJacobian,
                                                     const Eigen::Matrix3d& cameraFromPatient) const;

    /// Returns the posterior of `motionJacobian` · (motion of all knots, patient axes, knot by knot) + pose step, given
    /// the prior `pose` of that step. Requires a posterior built without a pose prior (zero covariance), because wide
    /// pose priors combined with precise rows need double precision.
    GaussianEstimate posteriorWithPose(const Eigen::Matrix<float, 6, Eigen::Dynamic>& motionJacobian,
                                       const GaussianEstimate& pose) const;

    /// Returns the variances that maximize the evidence of the estimated motions (MacKay 1992): σ² = |w|²/γ with γ
    /// effective parameters; a weak prior keeps them finite.
    MotionVariances estimateVariances() const;

    /// Returns the effective number of parameters determined by the rows: the degrees of freedom lost to a noise
    /// estimate.
    double effectiveParameters() const;

private:
    /// Transposed design matrix with one column per row: motion (3), pose (6) and geometry (6 per view), each scaled by
    /// the square root of its prior.
    struct RowBasis {
        Eigen::Matrix3Xf motion;
        Eigen::MatrixXf steps;
    };
    RowBasis basisOf(const std::vector<MotionRow>& rows) const;
    /// Returns the covariances of all rows in rows_ with another row.
    Eigen::VectorXf covariances(const MotionRow& row, const Eigen::Vector3f& motion,
                                const Eigen::VectorXf& steps) const;

    const FieldKernel& kernel_;
    MotionPrior prior_;
    std::vector<MotionRow> rows_;
    RowBasis basis_;
    Eigen::MatrixXf priorCovariance_;   ///< prior covariance between the knots
    Eigen::MatrixXf inverseFactor_;   ///< lower triangle V; VᵀV is the inverse of the covariance of the rows
    Eigen::VectorXd explained_;   ///< inverse covariance of the rows times their values
    double logDeterminant_ = 0.0;
};

}   // namespace angiopose::core
