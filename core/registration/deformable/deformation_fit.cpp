#include "core/registration/deformable/deformation_fit.h"

#include "core/support/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace angiopose::core {
namespace {

constexpr double greatestReachMm = 20.0;
constexpr double gateDeviations = 3.0;
constexpr double maxAngle = 40.0 / 180.0 * std::numbers::pi;
constexpr double turnDeviation = 20.0 / 180.0 * std::numbers::pi;
constexpr std::size_t maxCandidates = 6;
constexpr double evidenceShare = 0.4;   // weight of a candidate's evidence, reduced because neighbors are correlated
constexpr double robustDeviations = 2.5;
constexpr double independentMm = 4.0;   // distance along a vessel beyond which tracing errors are uncorrelated
constexpr double minRowWeight = 0.03;
constexpr double minNoisePx = 0.2;
constexpr double greatestNoisePx = 4.0;
// For Gaussian residuals, the fraction of the squared residuals kept by the robust weights, divided by the mean weight.
constexpr double robustBias = 0.67;
// Standard deviation of each motion at a strain of 1, mm: three motions in 3-D, then the one along the tree.
constexpr std::array<double, motionCount> motionPerStrainMm{30.0, 20.0, 10.0, 12.0};

double robustWeight(double residualMm, double deviationMm)
{
    const double c2 = robustDeviations * robustDeviations * deviationMm * deviationMm;
    const double kept = c2 / (c2 + residualMm * residualMm);
    return kept * kept;
}

MotionRow motionRowOf(const KnotProjection& projection, std::size_t view)
{
    MotionRow row;
    row.knot = projection.knot;
    row.view = view;
    row.motionJacobian = projection.motionJacobian;
    row.poseJacobian = projection.poseJacobian;
    row.geometryJacobian = projection.geometryJacobian;
    return row;
}

}   // namespace

DeformationState initialState(const DeformationProblem& problem, double strain)
{
    const auto count = static_cast<Eigen::Index>(problem.knots.size());
    DeformationState state;
    state.corrections.assign(problem.views.size(), Vector6d::Zero());
    state.motionMm = Eigen::Matrix3Xd::Zero(3, count);
    double variance = problem.prior.pose.diagonal().tail<3>().minCoeff();
    for (std::size_t m = 0; m < motionCount; ++m) {
        const double deviation = strain * motionPerStrainMm[m];
        state.variances[m] = deviation * deviation;
        variance += state.variances[m];
    }
    state.deviationMm =
        Eigen::MatrixXd::Constant(count, static_cast<Eigen::Index>(problem.views.size()), std::sqrt(variance));
    return state;
}

DeformationFit::DeformationFit(const DeformationProblem& problem, DeformationState start)
    : problem_(problem), state_(std::move(start))
{
}

double DeformationFit::logLikelihood() const
{
    if (!posterior_) {
        return -std::numeric_limits<double>::infinity();
    }
    double seen = 0.0;
    for (const double weight : rowWeight_) {
        seen += std::min(1.0, weight);
    }
    return posterior_->logEvidence() + seen * std::log(2.0 * greatestReachMm);
}

DeformedTree DeformationFit::deformedTree() const
{
    return {cameraFromPatient(retract(problem_.start, state_.poseStep), problem_.centroidInPatient), state_.motionMm};
}

RigidTransform DeformationFit::viewFromFirst(std::size_t view) const
{
    const RigidTransform& given = problem_.views[view].cameraFromFirst;
    if (view == 0) {
        return given;
    }
    const RigidTransform first = deformedTree().cameraFromPatient;
    const CentroidPose corrected =
        retract(aboutCentroid(given * first, problem_.centroidInPatient), state_.corrections[view]);
    return cameraFromPatient(corrected, problem_.centroidInPatient) * first.inverse();
}

ProjectionContext DeformationFit::projectionContext(std::size_t view) const
{
    const DeformationView& given = problem_.views[view];
    return {given.camera, viewFromFirst(view), problem_.centroidInPatient, &given.curves};
}

std::vector<KnotChoice> DeformationFit::knotChoices(const ProjectionContext& context,
                                                    const KnotProjections& projections, std::size_t view,
                                                    double annealingMm) const
{
    std::vector<KnotChoice> choices(projections.size());
    std::vector<CurveCrossing> crossings;
    for (std::size_t k = 0; k < projections.size(); ++k) {
        if (!projections[k]) {
            continue;
        }
        const KnotProjection& projection = *projections[k];
        const double deviation = state_.deviationMm(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(view));
        const double noise = noiseMm(projection);
        const double variance = deviation * deviation + annealingMm * annealingMm + noise * noise;
        const double reachMm = std::min(greatestReachMm, gateDeviations * std::sqrt(variance));
        context.curves->find({projection.positionPx, projection.normal, reachMm / projection.mmPerPx}, maxAngle,
                             maxCandidates, crossings);
        choices[k].normal = projection.normal;
        for (const CurveCrossing& crossing : crossings) {
            const double offset = crossing.offsetPx * projection.mmPerPx;
            const double turns = crossing.turn / turnDeviation;
            choices[k].candidates.push_back(
                {offset, evidenceShare * 0.5 * (offset * offset / variance + turns * turns), crossing.curve});
        }
    }
    return choices;
}

double DeformationFit::predictedMm(const MotionRow& row) const
{
    const double geometry = row.view > 0 ? row.geometryJacobian.dot(state_.corrections[row.view]) : 0.0;
    return row.motionJacobian.dot(state_.motionMm.col(static_cast<Eigen::Index>(row.knot))) +
           row.poseJacobian.dot(state_.poseStep) + geometry;
}

/// Combines the candidates of a knot into one row, unless none is likely.
void DeformationFit::addRow(const KnotProjection& projection, const KnotChoice& choice, std::size_t view,
                            const DeformationStep& step)
{
    const double deviationMm = std::hypot(step.annealingMm, noiseMm(projection));
    double sum = 0.0;
    double sumOffset = 0.0;
    double sumSquares = 0.0;
    for (const KnotCandidate& candidate : choice.candidates) {
        const double weight = candidate.probability * robustWeight(candidate.offsetMm, deviationMm);
        sum += weight;
        sumOffset += weight * candidate.offsetMm;
        sumSquares += weight * candidate.offsetMm * candidate.offsetMm;
    }
    const ProjectionCamera& camera = problem_.views[view].camera;
    if (projection.positionPx.minCoeff() >= 0.0 && projection.positionPx.x() < camera.width &&
        projection.positionPx.y() < camera.height) {
        visibleMm_ += projection.visibleMm;
        matchedMm_ += sum * projection.visibleMm;
    }
    MotionRow row = motionRowOf(projection, view);
    if (sum < minRowWeight || (step.isCoarse && projection.knot % 2 == 1)) {
        unobservedRows_[view].push_back(row);
        return;
    }
    const double offset = sumOffset / sum;
    const double ambiguity = std::max(0.0, sumSquares / sum - offset * offset);
    const double weight = sum * std::min(1.0, projection.visibleMm / independentMm);
    row.valueMm = offset + predictedMm(row);
    row.variance = (deviationMm * deviationMm + ambiguity) / weight;
    rows_.push_back(row);
    rowPx_.push_back(projection.mmPerPx);
    rowWeight_.push_back(weight);
}

void DeformationFit::collectRows(std::size_t view, const DeformationStep& step)
{
    const ProjectionContext context = projectionContext(view);
    const KnotProjections projections = projectKnots(problem_.knots, deformedTree(), context);
    std::vector<KnotChoice> choices = knotChoices(context, projections, view, step.annealingMm);
    const double mmPerPx =
        millimetersPerPixel(context.camera, (viewFromFirst(view) * problem_.start.centroidInCamera).z());
    const double deviation = std::hypot(step.annealingMm, state_.noisePx * mmPerPx);
    matchAlongTree(problem_.knots, {deviation, step.strain}, choices);
    for (std::size_t k = 0; k < projections.size(); ++k) {
        if (projections[k]) {
            addRow(*projections[k], choices[k], view, step);
        }
    }
}

void DeformationFit::step(const DeformationStep& step)
{
    rows_.clear();
    rowPx_.clear();
    rowWeight_.clear();
    unobservedRows_.assign(problem_.views.size(), {});
    visibleMm_ = 0.0;
    matchedMm_ = 0.0;
    for (std::size_t view = 0; view < problem_.views.size(); ++view) {
        collectRows(view, step);
    }
    explainedShare_ = visibleMm_ > 0.0 ? matchedMm_ / visibleMm_ : 0.0;
    if (rows_.empty()) {
        posterior_.reset();
        return;
    }
    MotionPrior prior = problem_.prior;
    prior.motion = state_.variances;
    posterior_.emplace(problem_.kernel, prior, rows_);
    state_.poseStep = posterior_->pose();
    for (std::size_t view = 1; view < problem_.views.size(); ++view) {
        state_.corrections[view] = posterior_->geometry(view);
    }
    state_.motionMm = posterior_->motion();
    measureDeviations();
    if (step.estimatesVariances) {
        updateVariances();
    }
}

void DeformationFit::measureDeviations()
{
    const Eigen::VectorXd variances = posterior_->variances();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        state_.deviationMm(static_cast<Eigen::Index>(rows_[r].knot), static_cast<Eigen::Index>(rows_[r].view)) =
            std::sqrt(variances[static_cast<Eigen::Index>(r)]);
    }
    for (std::size_t view = 0; view < unobservedRows_.size(); ++view) {
        const Eigen::VectorXd variancesThere = posterior_->variancesOf(unobservedRows_[view]);
        for (std::size_t r = 0; r < unobservedRows_[view].size(); ++r) {
            state_.deviationMm(static_cast<Eigen::Index>(unobservedRows_[view][r].knot),
                               static_cast<Eigen::Index>(view)) =
                std::sqrt(variancesThere[static_cast<Eigen::Index>(r)]);
        }
    }
}

void DeformationFit::updateVariances()
{
    state_.variances = posterior_->estimateVariances();
    double squares = 0.0;
    double weights = 0.0;
    std::vector<double> residualsPx;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const MotionRow& row = rows_[r];
        const double residualPx = (row.valueMm - predictedMm(row)) / rowPx_[r];
        squares += rowWeight_[r] * residualPx * residualPx;
        weights += rowWeight_[r];
        residualsPx.push_back(std::abs(residualPx));
    }
    medianResidualPx_ = quantile(residualsPx, 0.5);
    const double count = static_cast<double>(rows_.size());
    const double freeShare = std::max(0.2, 1.0 - posterior_->effectiveParameters() / count);
    const double noise = std::sqrt(squares / (robustBias * weights * freeShare));
    state_.noisePx = std::clamp(noise, minNoisePx, greatestNoisePx);
}

}   // namespace angiopose::core
