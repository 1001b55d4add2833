#include "core/registration/deformable/field_posterior.h"

#include "core/registration/deformable/knot_projection.h"
#include "core/support/random.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <numbers>

namespace angiopose::core {
namespace {

/// Random motion rows of a small tree.
struct RandomRows {
    RandomRows()
    {
        for (std::size_t k = 0; k < knots.size(); k += 2) {
            MotionRow row;
            row.knot = k;
            row.motionJacobian = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
            row.poseJacobian =
                Vector6d::NullaryExpr([&](Eigen::Index i) { return random.normal() * (i < 3 ? 40.0 : 1.0); });
            row.geometryJacobian.setZero();
            row.valueMm = random.normal();
            row.variance = 0.05 + random.uniform();
            rows.push_back(row);
        }
        prior.pose.diagonal() << 3e-4, 3e-4, 3e-4, 9.0, 9.0, 9.0;
        prior.motion = {4.0, 2.0, 1.0, 1.0};
    }

    /// Covariance of the noise-free rows, computed from its definition.
    Eigen::MatrixXd signal() const
    {
        const Eigen::MatrixXd kernel = FieldKernel(knots).combined(prior.motion).cast<double>();
        Eigen::MatrixXd signal(rows.size(), rows.size());
        for (std::size_t a = 0; a < rows.size(); ++a) {
            for (std::size_t b = 0; b < rows.size(); ++b) {
                signal(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) =
                    kernel(static_cast<Eigen::Index>(rows[a].knot), static_cast<Eigen::Index>(rows[b].knot)) *
                        rows[a].motionJacobian.dot(rows[b].motionJacobian) +
                    rows[a].poseJacobian.dot(prior.pose * rows[b].poseJacobian);
            }
        }
        return signal;
    }

    CounterRandom random{8};
    test::CleanCase clean{2};
    TreeKnots knots = treeKnots(clean.tree, {}, 40.0);
    std::vector<MotionRow> rows;
    MotionPrior prior;
};

TEST(FieldPosterior, IsTheConditionalGaussian)
{
    const RandomRows given;
    const FieldKernel kernel(given.knots);
    const FieldPosterior posterior(kernel, given.prior, given.rows);
    const Eigen::MatrixXd signal = given.signal();
    Eigen::MatrixXd total = signal;
    Eigen::VectorXd values(signal.rows());
    for (Eigen::Index r = 0; r < signal.rows(); ++r) {
        total(r, r) += given.rows[static_cast<std::size_t>(r)].variance;
        values[r] = given.rows[static_cast<std::size_t>(r)].valueMm;
    }
    const Eigen::MatrixXd inverse = total.inverse();
    const Eigen::VectorXd mean = signal * inverse * values;
    const Eigen::MatrixXd left = signal - signal * inverse * signal;
    const Eigen::Matrix3Xd motion = posterior.motion();
    const Eigen::VectorXd variances = posterior.variances();
    const Eigen::VectorXd again = posterior.variancesOf(given.rows);
    for (Eigen::Index r = 0; r < signal.rows(); ++r) {
        const MotionRow& row = given.rows[static_cast<std::size_t>(r)];
        const double found = row.motionJacobian.dot(motion.col(static_cast<Eigen::Index>(row.knot))) +
                             row.poseJacobian.dot(posterior.pose());
        EXPECT_NEAR(found, mean[r], 2e-3);
        EXPECT_NEAR(variances[r], left(r, r), 2e-3 + 0.01 * left(r, r));
        EXPECT_NEAR(again[r], left(r, r), 2e-3 + 0.01 * left(r, r));
    }
    const double evidence = -0.5 * (values.dot(inverse * values) + std::log(total.determinant()) +
                                    static_cast<double>(values.size()) * std::log(2.0 * std::numbers::pi));
    EXPECT_NEAR(posterior.logEvidence(), evidence, 0.02);
    EXPECT_NEAR(posterior.effectiveParameters(), (signal * inverse).trace(), 0.05);
}

// Variances are available for rows of the later views even if none of their points were matched.
TEST(FieldPosterior, TheGeometryOfViewsWithoutRowsKeepsItsPrior)
{
    RandomRows given;
    given.prior.geometry.diagonal() << 1e-4, 2e-4, 3e-4, 1.0, 2.0, 3.0;
    const FieldKernel kernel(given.knots);
    const FieldPosterior posterior(kernel, given.prior, given.rows);
    std::vector<MotionRow> others(3, given.rows[1]);
    others[1].view = 1;
    others[1].geometryJacobian << 30.0, -20.0, 10.0, 0.6, -0.4, 0.7;
    others[2].view = 40;
    others[2].geometryJacobian = others[1].geometryJacobian;
    const double ofGeometry = others[1].geometryJacobian.cwiseAbs2().dot(given.prior.geometry.diagonal());
    const Eigen::VectorXd variances = posterior.variancesOf(others);
    EXPECT_NEAR(variances[1], variances[0] + ofGeometry, 1e-3);
    EXPECT_NEAR(variances[2], variances[0] + ofGeometry, 1e-3);
    EXPECT_TRUE(posterior.geometry(40).isZero());
}

TEST(FieldPosterior, BeliefsWithAPoseAreConditionalGaussians)
{
    RandomRows given;
    GaussianEstimate pose{Vector6d::Zero(), 4.0 * given.prior.pose};
    pose.mean << 0.002, -0.001, 0.003, 0.5, -0.4, 0.8;
    given.prior.pose.setZero();
    const FieldKernel kernel(given.knots);
    const auto knots = static_cast<Eigen::Index>(given.knots.size());
    Eigen::Matrix<double, 6, Eigen::Dynamic> motionJacobian(6, 3 * knots);
    motionJacobian = motionJacobian.unaryExpr([&](double) { return 0.1 * given.random.normal(); });
    const GaussianEstimate belief =
        FieldPosterior(kernel, given.prior, given.rows).posteriorWithPose(motionJacobian.cast<float>(), pose);

    // Computed from the definition: motions of all knots, then the pose.
    const Eigen::Index size = 3 * knots + 6;
    Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(size, size);
    const Eigen::MatrixXd alike = kernel.combined(given.prior.motion).cast<double>();
    for (Eigen::Index a = 0; a < knots; ++a) {
        for (Eigen::Index b = 0; b < knots; ++b) {
            prior.block<3, 3>(3 * a, 3 * b) = alike(a, b) * Eigen::Matrix3d::Identity();
        }
    }
    prior.bottomRightCorner<6, 6>() = pose.covariance;
    const auto count = static_cast<Eigen::Index>(given.rows.size());
    Eigen::MatrixXd looks = Eigen::MatrixXd::Zero(count, size);
    Eigen::VectorXd values(count);
    Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index r = 0; r < count; ++r) {
        const MotionRow& row = given.rows[static_cast<std::size_t>(r)];
        looks.block<1, 3>(r, 3 * static_cast<Eigen::Index>(row.knot)) = row.motionJacobian.transpose();
        looks.block<1, 6>(r, 3 * knots) = row.poseJacobian.transpose();
        values[r] = row.valueMm - row.poseJacobian.dot(pose.mean);
        noise(r, r) = row.variance;
    }
    Eigen::MatrixXd functions(6, size);
    functions << motionJacobian, Matrix6d::Identity();
    const Eigen::MatrixXd gain = prior * looks.transpose() * (looks * prior * looks.transpose() + noise).inverse();
    const Vector6d mean = functions * (gain * values) + pose.mean;
    const Matrix6d covariance = functions * (prior - gain * looks * prior) * functions.transpose();
    EXPECT_LT((belief.mean - mean).norm(), 2e-3 * (1.0 + mean.norm()));
    EXPECT_LT((belief.covariance - covariance).norm(), 5e-3 * covariance.norm());
}

TEST(FieldPosterior, LearnedVariancesFindWhatMoves)
{
    RandomRows given;
    for (MotionRow& row : given.rows) {   // a smooth motion of 3 mm with almost no noise
        const Eigen::Vector3d& place = given.knots.positions[row.knot];
        row.valueMm = row.motionJacobian.dot(Eigen::Vector3d(4.0 * std::sin(place.z() / 80.0), 0.0, 0.0));
        row.variance = 0.01;
    }
    const FieldKernel kernel(given.knots);
    MotionPrior prior = given.prior;
    for (int k = 0; k < 10; ++k) {
        prior.motion = FieldPosterior(kernel, prior, given.rows).estimateVariances();
    }
    EXPECT_GT(prior.motion[0], 1.0);
    EXPECT_LT(prior.motion[2], 0.3);
}

TEST(LookAt, DerivativesMatchFiniteDifferences)
{
    const test::CleanCase clean(5);
    const TreeKnots knots = treeKnots(clean.tree, {}, 20.0);
    const Eigen::Vector3d centroid = centroidInPatient(clean.tree);
    const RigidTransform second{expSo3({0.1, 0.9, -0.2}), Eigen::Vector3d(-700.0, 10.0, 300.0)};
    DeformedTree deformed{clean.truth, Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(knots.size()))};
    const ProjectionContext context{clean.camera, second, centroid, nullptr};
    const auto looks = projectKnots(knots, deformed, context);
    const double h = 1e-4;
    int checked = 0;
    for (std::size_t k = 0; k < knots.size(); k += 7) {
        if (!looks[k]) {
            continue;
        }
        const auto across = [&](const RigidTransform& pose, const Eigen::Vector3d& motion) {
            const auto pixel = project(clean.camera, second * (pose * (knots.positions[k] + motion)));
            return looks[k]->normal.dot(*pixel - looks[k]->positionPx) * looks[k]->mmPerPx;
        };
        for (Eigen::Index i = 0; i < 6; ++i) {
            const Vector6d step = h * Vector6d::Unit(i);
            const RigidTransform moved6 =
                cameraFromPatient(retract(aboutCentroid(clean.truth, centroid), step), centroid);
            EXPECT_NEAR(across(moved6, Eigen::Vector3d::Zero()) / h, looks[k]->poseJacobian[i], 0.05);
            if (i < 3) {
                EXPECT_NEAR(across(clean.truth, h * Eigen::Vector3d::Unit(i)) / h, looks[k]->motionJacobian[i], 1e-3);
            }
        }
        ++checked;
    }
    EXPECT_GT(checked, 3);
}

}   // namespace
}   // namespace angiopose::core
