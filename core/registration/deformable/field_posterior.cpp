#include "core/registration/deformable/field_posterior.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double variancePullMm2 = 0.003;   // weak prior on the learned variances; yields 0.01 mm² for γ = 0
constexpr double countPull = 0.3;

Eigen::Index rowAt(std::size_t number)
{
    return static_cast<Eigen::Index>(number);
}

/// Inverts a lower triangular matrix in place by recursive bisection, skipping products with zeros.
void invertLowerTriangle(Eigen::Ref<Eigen::MatrixXf> lower)
{
    const Eigen::Index count = lower.rows();
    if (count <= 48) {
        lower = Eigen::MatrixXf(lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXf::Identity(count, count)));
        return;
    }
    const Eigen::Index half = count / 2;
    auto first = lower.topLeftCorner(half, half);
    auto last = lower.bottomRightCorner(count - half, count - half);
    auto corner = lower.bottomLeftCorner(count - half, half);
    invertLowerTriangle(first);
    invertLowerTriangle(last);
    const Eigen::MatrixXf middle = corner * first.triangularView<Eigen::Lower>();
    corner.noalias() = -(last.triangularView<Eigen::Lower>() * middle);
    first.triangularView<Eigen::StrictlyUpper>().setZero();
    last.triangularView<Eigen::StrictlyUpper>().setZero();
}

/// Returns the lower triangle of VᵀV for a lower triangular V, computed in blocks that skip products with zeros.
Eigen::MatrixXf lowerOfSquare(const Eigen::MatrixXf& lower)
{
    constexpr Eigen::Index blockSize = 64;
    const Eigen::Index count = lower.rows();
    Eigen::MatrixXf square(count, count);
    for (Eigen::Index first = 0; first < count; first += blockSize) {
        const Eigen::Index width = std::min(blockSize, count - first);
        const Eigen::Index below = count - first;
        square.block(first, 0, width, first + width).noalias() =
            lower.block(first, first, below, width).transpose() * lower.block(first, 0, below, first + width);
    }
    return square;
}

}   // namespace

FieldPosterior::FieldPosterior(const FieldKernel& kernel, const MotionPrior& prior, std::vector<MotionRow> rows)
    : kernel_(kernel), prior_(prior), rows_(std::move(rows)), priorCovariance_(kernel.combined(prior.motion))
{
    basis_ = basisOf(rows_);
    const auto count = rowAt(rows_.size());
    Eigen::MatrixXf covariance(count, count);
    Eigen::VectorXf values(count);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        covariance.col(rowAt(r)) = covariances(rows_[r], basis_.motion.col(rowAt(r)), basis_.steps.col(rowAt(r)));
        covariance(rowAt(r), rowAt(r)) += static_cast<float>(rows_[r].variance);
        values[rowAt(r)] = static_cast<float>(rows_[r].valueMm);
    }
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXf>, Eigen::Lower> llt(covariance);
    logDeterminant_ = 2.0 * covariance.diagonal().cast<double>().array().log().sum();
    explained_ = llt.solve(values).cast<double>();
    covariance.triangularView<Eigen::StrictlyUpper>().setZero();
    invertLowerTriangle(covariance);
    covariance.triangularView<Eigen::StrictlyUpper>().setZero();
    inverseFactor_ = std::move(covariance);
}

Vector6d FieldPosterior::pose() const
{
    Vector6d pulled = Vector6d::Zero();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        pulled += explained_[rowAt(r)] * rows_[r].poseJacobian;
    }
    return prior_.pose * pulled;
}

Vector6d FieldPosterior::geometry(std::size_t view) const
{
    Vector6d pulled = Vector6d::Zero();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (view > 0 && rows_[r].view == view) {
            pulled += explained_[rowAt(r)] * rows_[r].geometryJacobian;
        }
    }
    return prior_.geometry * pulled;
}

Eigen::Matrix3Xd FieldPosterior::motion() const
{
    Eigen::Matrix3Xd pulls = Eigen::Matrix3Xd::Zero(3, priorCovariance_.cols());
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        pulls.col(rowAt(rows_[r].knot)) += explained_[rowAt(r)] * rows_[r].motionJacobian;
    }
    return (pulls.cast<float>() * priorCovariance_).cast<double>();
}

double FieldPosterior::logEvidence() const
{
    double fit = 0.0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        fit += rows_[r].valueMm * explained_[rowAt(r)];
    }
    return -0.5 * (fit + logDeterminant_ + static_cast<double>(rows_.size()) * std::log(2.0 * std::numbers::pi));
}

Eigen::VectorXd FieldPosterior::variances() const
{
    // Uses K − K (K + R)⁻¹ K = R − R (K + R)⁻¹ R.
    Eigen::VectorXd result(rowAt(rows_.size()));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const double noise = rows_[r].variance;
        result[rowAt(r)] =
            std::max(0.0, noise - noise * noise * static_cast<double>(inverseFactor_.col(rowAt(r)).squaredNorm()));
    }
    return result;
}

FieldPosterior::RowBasis FieldPosterior::basisOf(const std::vector<MotionRow>& rows) const
{
    std::size_t lastView = 0;   // highest view of both row sets, because either set may lack views of the other
    for (const auto* each : {&rows, &rows_}) {
        for (const MotionRow& row : *each) {
            lastView = std::max(lastView, row.view);
        }
    }
    const Matrix6d poseRoot = prior_.pose.isZero() ? Matrix6d::Zero() : Matrix6d(prior_.pose.llt().matrixL());
    const Vector6d geometryRoot = prior_.geometry.diagonal().cwiseSqrt();
    RowBasis basis{Eigen::Matrix3Xf(3, rowAt(rows.size())),
                   Eigen::MatrixXf::Zero(6 + 6 * rowAt(lastView), rowAt(rows.size()))};
    for (std::size_t r = 0; r < rows.size(); ++r) {
        basis.motion.col(rowAt(r)) = rows[r].motionJacobian.cast<float>();
        basis.steps.col(rowAt(r)).head<6>() = (poseRoot.transpose() * rows[r].poseJacobian).cast<float>();
        if (rows[r].view > 0) {
            basis.steps.col(rowAt(r)).segment<6>(6 * rowAt(rows[r].view)) =
                geometryRoot.cwiseProduct(rows[r].geometryJacobian).cast<float>();
        }
    }
    return basis;
}

Eigen::VectorXf FieldPosterior::covariances(const MotionRow& row, const Eigen::Vector3f& motion,
                                            const Eigen::VectorXf& steps) const
{
    Eigen::VectorXf alike = basis_.motion.transpose() * motion;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        alike[rowAt(r)] *= priorCovariance_(rowAt(rows_[r].knot), rowAt(row.knot));
    }
    // A view without rows in rows_ contributes nothing: its geometry is independent of them.
    alike.noalias() += basis_.steps.transpose() * steps.head(basis_.steps.rows());
    return alike;
}

Eigen::VectorXd FieldPosterior::variancesOf(const std::vector<MotionRow>& others) const
{
    if (others.empty()) {
        return {};
    }
    const RowBasis basis = basisOf(others);
    Eigen::MatrixXf with(rowAt(rows_.size()), rowAt(others.size()));
    Eigen::VectorXd variances(rowAt(others.size()));
    for (std::size_t k = 0; k < others.size(); ++k) {
        const auto knot = rowAt(others[k].knot);
        with.col(rowAt(k)) = covariances(others[k], basis.motion.col(rowAt(k)), basis.steps.col(rowAt(k)));
        variances[rowAt(k)] =
            static_cast<double>(priorCovariance_(knot, knot) * basis.motion.col(rowAt(k)).squaredNorm() +
                                basis.steps.col(rowAt(k)).squaredNorm());
    }
    const Eigen::MatrixXf whitened = inverseFactor_.triangularView<Eigen::Lower>() * with;
    variances -= whitened.colwise().squaredNorm().transpose().cast<double>();
    return variances.cwiseMax(0.0);
}

std::vector<Eigen::Matrix3d> FieldPosterior::positionCovariances(
    const std::vector<std::size_t>& knots, const std::vector<Eigen::Matrix<double, 3, 6>>& poseJacobian,
    const Eigen::Matrix3d& cameraFromPatient) const
{
    const auto rowCount = rowAt(rows_.size());
    Eigen::MatrixXf with(rowCount, 3 * rowAt(poseJacobian.size()));
    for (std::size_t k = 0; k < poseJacobian.size(); ++k) {
        const Eigen::Matrix<float, 3, 6> posePart = (poseJacobian[k] * prior_.pose).cast<float>();
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const float kernel = priorCovariance_(rowAt(rows_[r].knot), rowAt(knots[k]));
            with.block<1, 3>(rowAt(r), 3 * rowAt(k)) =
                (kernel * (cameraFromPatient.cast<float>() * basis_.motion.col(rowAt(r))) +
                 posePart * rows_[r].poseJacobian.cast<float>())
                    .transpose();
        }
    }
    with = inverseFactor_.triangularView<Eigen::Lower>() * with;
    std::vector<Eigen::Matrix3d> covariances(poseJacobian.size());
    for (std::size_t k = 0; k < poseJacobian.size(); ++k) {
        const auto whitened = with.middleCols<3>(3 * rowAt(k));
        const Eigen::Matrix3f explained = whitened.transpose() * whitened;
        covariances[k] =
            static_cast<double>(priorCovariance_(rowAt(knots[k]), rowAt(knots[k]))) * Eigen::Matrix3d::Identity() +
            poseJacobian[k] * prior_.pose * poseJacobian[k].transpose() - explained.cast<double>();
    }
    return covariances;
}

GaussianEstimate FieldPosterior::posteriorWithPose(const Eigen::Matrix<float, 6, Eigen::Dynamic>& motionJacobian,
                                                   const GaussianEstimate& pose) const
{
    // Covariances of the functions with the motion of every knot, three columns per knot.
    const Eigen::Index knots = priorCovariance_.cols();
    Eigen::Matrix<float, 6, Eigen::Dynamic> withMotion(6, 3 * knots);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::Matrix<float, 6, Eigen::Dynamic> ofAxis(6, knots);
        for (Eigen::Index k = 0; k < knots; ++k) {
            ofAxis.col(k) = motionJacobian.col(3 * k + axis);
        }
        ofAxis *= priorCovariance_;
        for (Eigen::Index k = 0; k < knots; ++k) {
            withMotion.col(3 * k + axis) = ofAxis.col(k);
        }
    }
    // Whitened information of the rows about the functions (through motion) and the pose, with the row values.
    Eigen::Matrix<float, Eigen::Dynamic, 13> reported(rowAt(rows_.size()), 13);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        reported.row(rowAt(r))
            << (withMotion.middleCols<3>(3 * rowAt(rows_[r].knot)) * basis_.motion.col(rowAt(r))).transpose(),
            rows_[r].poseJacobian.cast<float>().transpose(), static_cast<float>(rows_[r].valueMm);
    }
    reported = inverseFactor_.triangularView<Eigen::Lower>() * reported;
    const Eigen::MatrixXd whitened = reported.cast<double>();
    const Eigen::MatrixXd squares = whitened.transpose() * whitened;
    const Matrix6d motionByPose = squares.block<6, 6>(0, 6);
    const Matrix6d known = pose.covariance.inverse();
    const Matrix6d stepCovariance = (squares.block<6, 6>(6, 6) + known).inverse();
    const Vector6d step = stepCovariance * (squares.block<6, 1>(6, 12) + known * pose.mean);
    const Matrix6d byStep = Matrix6d::Identity() - motionByPose;
    const Matrix6d ofMotion = (withMotion * motionJacobian.transpose()).cast<double>();
    return {squares.block<6, 1>(0, 12) + byStep * step,
            ofMotion - squares.topLeftCorner<6, 6>() + byStep * stepCovariance * byStep.transpose()};
}

MotionVariances FieldPosterior::estimateVariances() const
{
    // Accumulates sums over pairs of rows by the pairs of their knots.
    const auto count = rowAt(rows_.size());
    const Eigen::Index knots = priorCovariance_.cols();
    const Eigen::MatrixXf inverse = lowerOfSquare(inverseFactor_);
    Eigen::MatrixXf left = Eigen::MatrixXf::Zero(knots, knots);
    Eigen::Matrix3Xf pulls = Eigen::Matrix3Xf::Zero(3, knots);
    for (Eigen::Index r = 0; r < count; ++r) {
        const Eigen::Index knot = rowAt(rows_[static_cast<std::size_t>(r)].knot);
        const Eigen::Vector3f motion = basis_.motion.col(r);
        pulls.col(knot) += static_cast<float>(explained_[r]) * motion;
        left(knot, knot) += motion.squaredNorm() * inverse(r, r);
        for (Eigen::Index q = r + 1; q < count; ++q) {
            left(rowAt(rows_[static_cast<std::size_t>(q)].knot), knot) +=
                2.0F * motion.dot(basis_.motion.col(q)) * inverse(q, r);
        }
    }
    MotionVariances learned{};
    for (std::size_t m = 0; m < motionCount; ++m) {
        const Eigen::MatrixXf& kernel = kernel_.kernelOf(m);
        const auto squares = static_cast<double>((pulls * kernel).cwiseProduct(pulls).sum());
        const auto traces = static_cast<double>(left.cwiseProduct(kernel).sum());
        const double variance = prior_.motion[m];
        learned[m] = (variance * variance * squares + variancePullMm2) / (variance * traces + countPull);
    }
    return learned;
}

double FieldPosterior::effectiveParameters() const
{
    double left = 0.0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        left += rows_[r].variance * static_cast<double>(inverseFactor_.col(rowAt(r)).squaredNorm());
    }
    return static_cast<double>(rows_.size()) - left;
}

}   // namespace angiopose::core
