#pragma once

#include "core/registration/deformable/field_posterior.h"
#include "core/registration/deformable/knot_projection.h"
#include "core/registration/deformable/tree_matching.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// One view of a fit.
struct DeformationView {
    ProjectionCamera camera;
    RigidTransform cameraFromFirst;   ///< camera position relative to the first view, before the correction
    CurveCrossings curves;
};

/// Data shared by all fits.
struct DeformationProblem {
    TreeKnots knots;
    FieldKernel kernel;
    std::vector<DeformationView> views;
    Eigen::Vector3d centroidInPatient;
    CentroidPose start;   ///< rigid pose in the first view
    MotionPrior prior;   ///< priors of pose, geometry and motion; each fit estimates its own motion variances
    GaussianEstimate startStep;   ///< prior of the step from the rigid pose, based on the initial pose alone
};

/// Current estimates of a fit.
struct DeformationState {
    Vector6d poseStep = Vector6d::Zero();   ///< step relative to DeformationProblem::start, see CentroidPose
    std::vector<Vector6d> corrections;   ///< corrections of the geometry between views
    Eigen::Matrix3Xd motionMm;   ///< motion of each knot, patient axes
    Eigen::MatrixXd deviationMm;   ///< 1-σ across the vessel, knots × views
    MotionVariances variances{};
    double noisePx = 1.0;
};

/// Settings of one step.
struct DeformationStep {
    double annealingMm = 0.0;   ///< 1-σ added to the tracing noise
    double strain = 0.15;   ///< assumed strain between neighboring knots, see NeighborModel
    bool estimatesVariances = false;   ///< whether variances and noise are estimated
    bool isCoarse = false;   ///< uses only every other knot, which suffices while the noise is large
};

/// One annealed fit. Each step evaluates the knots, matches them along the tree, and solves jointly for pose and motion
/// (ALGORITHMS §11.3).
class DeformationFit {
public:
    /// `problem` must outlive the fit.
    DeformationFit(const DeformationProblem& problem, DeformationState start);

    void step(const DeformationStep& step);

    const DeformationState& state() const { return state_; }
    const std::vector<MotionRow>& rows() const { return rows_; }
    const std::optional<FieldPosterior>& posterior() const { return posterior_; }   ///< nullopt if there are no rows

    /// Returns the fraction of the visible length of the used branches that matches a vessel, 0…1.
    double explainedShare() const { return explainedShare_; }
    /// Returns the log likelihood of the rows and the unmatched knots, up to a constant common to all fits.
    double logLikelihood() const;

    double medianResidualPx() const { return medianResidualPx_; }

    DeformedTree deformedTree() const;
    RigidTransform viewFromFirst(std::size_t view) const;   ///< includes the geometry correction

private:
    using KnotProjections = std::vector<std::optional<KnotProjection>>;

    ProjectionContext projectionContext(std::size_t view) const;
    double noiseMm(const KnotProjection& projection) const { return state_.noisePx * projection.mmPerPx; }
    std::vector<KnotChoice> knotChoices(const ProjectionContext& context, const KnotProjections& projections,
                                        std::size_t view, double annealingMm) const;
    void collectRows(std::size_t view, const DeformationStep& step);
    void addRow(const KnotProjection& projection, const KnotChoice& choice, std::size_t view,
                const DeformationStep& step);
    double predictedMm(const MotionRow& row) const;   ///< offset that pose, geometry and motion predict for a row
    void updateVariances();
    void measureDeviations();

    const DeformationProblem& problem_;
    DeformationState state_;
    std::vector<MotionRow> rows_;
    std::vector<double> rowPx_;   ///< mm per px for each row
    std::vector<double> rowWeight_;
    std::vector<std::vector<MotionRow>> unobservedRows_;   ///< per view, rows of the knots without an observation
    std::optional<FieldPosterior> posterior_;
    double visibleMm_ = 0.0;
    double matchedMm_ = 0.0;
    double explainedShare_ = 0.0;
    double medianResidualPx_ = 0.0;
};

/// Returns the initial state of a fit whose motion variances correspond to this strain.
DeformationState initialState(const DeformationProblem& problem, double strain);

}   // namespace angiopose::core
