#include "core/registration/alignment/shape_tolerance.h"

#include "core/registration/alignment/shape_field.h"
#include "core/support/symmetric.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double matchScalePx = 1.5;   // Welsch scale for matching; its cutoff admits points up to 6 px away
constexpr double scaleFactor = 3.0;   // Welsch scale at which Gaussian residuals keep nearly all their weight
constexpr int maxShapeSteps = 8;
constexpr double settledShapeSigmas = 0.1;   // a step this short, in standard deviations, ends the refinement
constexpr double minShapeDamping = 1e-9;
// Eigenvalue fraction of vessels within about 6° (RMS) of one direction: traced directions scatter by this much, and
// such vessels do not constrain a shift along that direction.
constexpr double minNormalSpread = 0.01;

NormalEquations priorAt(const InitialPosePrior& prior, const CentroidPose& pose, double variance = 1.0)
{
    NormalEquations equations;
    prior.add(pose, variance, equations);
    return equations;
}

double tolerantScalePx(const ResidualNoise& noise)
{
    return std::max(1.0, scaleFactor * std::hypot(noise.scatterPx, noise.offsetPx));
}

/// Collects rows with weights adapted to the noise of the residuals and returns this noise.
ResidualNoise collectRobustRows(const Alignment& alignment, const CentroidPose& pose, std::vector<ResidualRow>& rows)
{
    alignment.collectRows(pose, matchScalePx, rows);
    const ResidualNoise noise = residualNoise(rows);
    alignment.collectRows(pose, tolerantScalePx(noise), rows);
    return noise;
}

template <int Parameters>
Eigen::Vector<double, Parameters> derivativesOf(const ResidualRow& row)
{
    if constexpr (Parameters == 6) {
        return row.gradient;
    } else {
        Eigen::Vector<double, Parameters> derivatives;
        derivatives << row.gradient, row.cameraGradient;
        return derivatives;
    }
}

template <int Parameters>
EquationsOf<Parameters> sumRows(const std::vector<ResidualRow>& rows, double rowVariance)
{
    EquationsOf<Parameters> sum;
    for (const ResidualRow& row : rows) {
        if (row.weight > 0.0) {
            const Eigen::Vector<double, Parameters> derivatives = derivativesOf<Parameters>(row);
            const Eigen::Vector<double, Parameters> weighted = row.weight / rowVariance * derivatives;
            sum.hessian += weighted * derivatives.transpose();
            sum.gradient += row.residual * weighted;
        }
    }
    return sum;
}

/// Whether the step is a small fraction of the uncertainty given by the equations; `variance` is that of one row.
bool isSettled(const Vector6d& step, const NormalEquations& equations, double variance)
{
    const double squaredSigmas = step.dot(equations.hessian.selfadjointView<Eigen::Lower>() * step) / variance;
    return squaredSigmas < settledShapeSigmas * settledShapeSigmas;
}

/// Returns the length-weighted second moments of the image normals of the matched vessels, which show how well lateral
/// shifts are constrained.
Eigen::Matrix2d normalMoments(const std::vector<ResidualRow>& rows, const CentroidPose& pose)
{
    constexpr std::size_t apart =
        5;   // number of rows; far enough apart to measure the direction of the vessel rather than its sampling
    const auto seen = [&pose](const ResidualRow& row) {
        const Eigen::Vector3d inCamera = row.fromCentroid + pose.centroidInCamera;
        return Eigen::Vector2d(inCamera.head<2>() / inCamera.z());
    };
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (std::size_t i = apart; i < rows.size(); ++i) {
        const ResidualRow &from = rows[i - apart], &to = rows[i];
        const double weight = from.branchIndex == to.branchIndex ? std::min(from.weight, to.weight) : 0.0;
        const Eigen::Vector2d along = weight > 0.0 ? Eigen::Vector2d(seen(to) - seen(from)) : Eigen::Vector2d::Zero();
        if (along.norm() > 0.0) {
            const Eigen::Vector2d normal(-along.y(), along.x());
            spread += weight / along.norm() * normal * normal.transpose();
        }
    }
    return spread;
}

/// If all matched vessels form one line in the image, removes the shift along this line from the equations, because it
/// changes no distance across the vessels.
template <int Parameters>
EquationsOf<Parameters> removeShiftAlongLine(EquationsOf<Parameters> equations, const std::vector<ResidualRow>& rows,
                                             const CentroidPose& pose)
{
    const EigenDecomposition<2> axes = eigenDecomposition(normalMoments(rows, pose));
    if (axes.values[0] < minNormalSpread * axes.values.sum()) {
        Eigen::Vector<double, Parameters> slide = Eigen::Vector<double, Parameters>::Zero();
        slide.template segment<2>(3) = axes.directions.col(0);
        const auto kept = (decltype(equations.hessian)::Identity() - slide * slide.transpose()).eval();
        equations.hessian = (kept * equations.hessian * kept).eval();
        equations.gradient = (kept * equations.gradient).eval();
    }
    return equations;
}

/// Returns the information of the rows, allowing for as much deformation of the vessels as the residuals show.
template <int Parameters>
EquationsOf<Parameters> tolerantEquations(const Alignment& alignment, const CentroidPose& pose,
                                          const EquationsOf<Parameters>& prior)
{
    std::vector<ResidualRow> rows;
    const ResidualNoise noise = collectRobustRows(alignment, pose, rows);
    if (!noise.hasOffsets()) {
        return removeShiftAlongLine(sumRows<Parameters>(rows, noise.rowVariance()), rows, pose);
    }
    ShapeFieldOf<Parameters> field(rows, noise.rowVariance());
    return removeShiftAlongLine(field.equations(field.estimateOffsetPx(prior)), rows, pose);
}

/// Shifts the rotated tree onto the vessels without rotating it further.
CentroidPose refineShift(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose,
                         double scalePx, double rowVariance)
{
    const PoseFreedom shifts = prior.freedom.withLockedAxes({PoseAxis::Roll, PoseAxis::LaoRao, PoseAxis::CraCau}, pose);
    CentroidPose settled = pose;
    for (int k = 0; k < maxShapeSteps; ++k) {
        NormalEquations equations = alignment.evaluate(settled, scalePx).equations;
        prior.add(settled, rowVariance, equations);
        const Vector6d step = shifts.dampedStep(equations, minShapeDamping, settled);
        settled = shifts.retract(settled, step);
        if (isSettled(step, equations, rowVariance)) {
            break;
        }
    }
    return settled;
}

}   // namespace

CentroidPose refineWithShapeErrors(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose,
                                   double scalePx)
{
    std::vector<ResidualRow> rows;
    const ResidualNoise noise = collectRobustRows(alignment, pose, rows);
    if (!noise.hasOffsets()) {
        return pose;
    }
    const double offsetPx = ShapeField(rows, noise.rowVariance()).estimateOffsetPx(priorAt(prior, pose));
    CentroidPose refined = pose;
    for (int k = 0; k < maxShapeSteps; ++k) {
        NormalEquations equations = ShapeField(rows, noise.rowVariance()).equations(offsetPx);
        prior.add(refined, 1.0, equations);
        const Vector6d step = prior.freedom.dampedStep(equations, minShapeDamping, refined);
        refined = prior.freedom.retract(refined, step);
        if (isSettled(step, equations, 1.0)) {
            break;
        }
        alignment.collectRows(refined, tolerantScalePx(noise), rows);
    }
    return refineShift(alignment, prior, refined, scalePx, noise.rowVariance());
}

double estimateOffset(const Alignment& alignment, const CentroidPose& pose)
{
    std::vector<ResidualRow> rows;
    const ResidualNoise noise = collectRobustRows(alignment, pose, rows);
    return noise.hasOffsets() ? noise.offsetPx : 0.0;
}

NormalEquations tolerantInformation(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose)
{
    return tolerantEquations(alignment, pose, priorAt(prior, pose));
}

CameraEquations tolerantInformation(const Alignment& alignment, const InitialPosePrior& prior, const CentroidPose& pose,
                                    const CameraUncertainty& spread)
{
    const NormalEquations ofPose = priorAt(prior, pose);
    CameraEquations both;
    both.hessian.topLeftCorner<6, 6>() = ofPose.hessian;
    both.gradient.head<6>() = ofPose.gradient;
    both.hessian.bottomRightCorner<3, 3>().diagonal() = spread.std().cwiseAbs2().cwiseInverse();
    return tolerantEquations(alignment, pose, both);
}

}   // namespace angiopose::core
