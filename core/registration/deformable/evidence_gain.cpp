#include "core/registration/deformable/evidence_gain.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr std::array<double, 7> noiseFactorsTried{1.0, 1.4, 2.0, 2.8, 4.0, 8.0, 16.0};

/// Information of the rows about pose and geometry for a tree without motion. It has few parameters, which makes the
/// evidence cheap to compute.
class RigidRows {
public:
    RigidRows(const MotionPrior& prior, const std::vector<MotionRow>& rows)
    {
        std::size_t lastView = 0;
        for (const MotionRow& row : rows) {
            lastView = std::max(lastView, row.view);
        }
        const Eigen::Index size = 6 + 6 * static_cast<Eigen::Index>(lastView);
        const Matrix6d poseRoot = prior.pose.llt().matrixL();
        const Vector6d geometryRoot = prior.geometry.diagonal().cwiseSqrt();
        reported_ = Eigen::MatrixXd::Zero(size, size);
        pull_ = Eigen::VectorXd::Zero(size);
        for (const MotionRow& row : rows) {
            Eigen::VectorXd steps = Eigen::VectorXd::Zero(size);   // scaled by the square roots of their prior
            steps.head<6>() = poseRoot.transpose() * row.poseJacobian;
            if (row.view > 0) {
                steps.segment<6>(6 * static_cast<Eigen::Index>(row.view)) =
                    geometryRoot.cwiseProduct(row.geometryJacobian);
            }
            reported_.selfadjointView<Eigen::Lower>().rankUpdate(steps, 1.0 / row.variance);
            pull_ += row.valueMm / row.variance * steps;
            squares_ += row.valueMm * row.valueMm / row.variance;
            logNoise_ += std::log(2.0 * std::numbers::pi * row.variance);
        }
        count_ = static_cast<double>(rows.size());
    }

    /// Returns log N(values; 0, covariance) with the standard deviation of every row scaled by `factor` (Woodbury).
    double logEvidence(double factor) const
    {
        const double f2 = factor * factor;
        Eigen::MatrixXd inner = reported_.selfadjointView<Eigen::Lower>();
        inner /= f2;
        inner.diagonal().array() += 1.0;
        const Eigen::LLT<Eigen::MatrixXd> llt(inner);
        const double logDeterminant = 2.0 * llt.matrixLLT().diagonal().array().log().sum();
        const double squares = (squares_ - pull_.dot(llt.solve(pull_)) / f2) / f2;
        return -0.5 * (squares + logDeterminant + logNoise_ + count_ * std::log(f2));
    }

private:
    Eigen::MatrixXd reported_;
    Eigen::VectorXd pull_;
    double squares_ = 0.0;
    double logNoise_ = 0.0;
    double count_ = 0.0;
};

}   // namespace

double logEvidenceGain(const DeformationProblem& problem, const DeformationFit& fit)
{
    if (!fit.posterior()) {
        return 0.0;
    }
    const RigidRows rigid(problem.prior, fit.rows());
    double best = -std::numeric_limits<double>::infinity();
    for (const double factor : noiseFactorsTried) {
        const double evidence = rigid.logEvidence(factor);
        if (evidence < best) {
            break;   // the noise factor is past its optimum
        }
        best = evidence;
    }
    return fit.posterior()->logEvidence() - best;
}

}   // namespace angiopose::core
