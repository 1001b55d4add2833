#pragma once

#include "core/registration/deformable/field_posterior.h"
#include "core/registration/deformable/tree_matching.h"
#include "core/registration/deformable/vessel_look.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace angiopose::core {

/// One view of a fit.
struct DeformationView {
    ProjectionCamera camera;
    RigidTransform cameraFromFirst;   ///< without its correction
    CurveCrossings curves;
};

/// What every run of a fit shares.
struct DeformationProblem {
    TreeKnots knots;
    FieldKernel kernel;
    std::vector<DeformationView> views;
    Eigen::Vector3d centroidInPatient;
    CentroidPose start;   ///< in the first view
    MotionPrior prior;   ///< the motions' variances are those of a run
    LinearBelief startStep;   ///< of the step from the rigid pose, by the start pose alone
};

/// Where a run is.
struct DeformationState {
    Vector6d poseStep = Vector6d::Zero();   ///< from the start, see CentroidPose
    std::vector<Vector6d> corrections;   ///< of the views' geometry
    Eigen::Matrix3Xd motionMm;   ///< of each knot, patient axes
    Eigen::MatrixXd deviationMm;   ///< 1-σ across the vessel, knots by views
    MotionVariances variances{};
    double noisePx = 1.0;
};

/// How a step looks.
struct DeformationStep {
    double annealingMm = 0.0;   ///< 1-σ that is added to the noise
    double strain = 0.15;   ///< of neighbours, see NeighborModel
    bool isLearning = false;   ///< of variances and noise
    bool isCoarse = false;   ///< every other knot gives a row: enough while the noise is large
};

/// One run of the fit, step by step: look, match along the tree, solve for pose and motion together (ALGORITHMS §11.3).
class DeformationFit {
public:
    /// `problem` outlives it.
    DeformationFit(const DeformationProblem& problem, DeformationState start);

    void step(const DeformationStep& step);

    const DeformationState& state() const { return state_; }
    const std::vector<MotionRow>& rows() const { return rows_; }
    const std::optional<FieldPosterior>& posterior() const { return posterior_; }   ///< nothing without rows

    /// Share of the used tree's visible length that found its vessel, 0…1.
    double explainedShare() const { return explainedShare_; }
    /// Of rows and unseen knots together, up to a constant that all runs share.
    double logLikelihood() const;

    double medianResidualPx() const { return medianResidualPx_; }

    DeformedTree deformedTree() const;
    RigidTransform viewFromFirst(std::size_t view) const;   ///< corrected

private:
    using Looks = std::vector<std::optional<KnotLook>>;

    DeformableSight sightOf(std::size_t view) const;
    double noiseMm(const KnotLook& look) const { return state_.noisePx * look.mmPerPx; }
    std::vector<KnotChoice> choicesOf(const DeformableSight& sight, const Looks& looks, std::size_t view,
                                      double annealingMm) const;
    void collectRows(std::size_t view, const DeformationStep& step);
    void addRow(const KnotLook& look, const KnotChoice& choice, std::size_t view, const DeformationStep& step);
    double foundMm(const MotionRow& row) const;   ///< what pose, geometry and motion make of a row
    void learn();
    void measureDeviations();

    const DeformationProblem& problem_;
    DeformationState state_;
    std::vector<MotionRow> rows_;
    std::vector<double> rowPx_;   ///< mm per px of each row
    std::vector<double> rowWeight_;
    std::vector<std::vector<MotionRow>> others_;   ///< per view: of knots that gave no row
    std::optional<FieldPosterior> posterior_;
    double seenMm_ = 0.0;
    double explainedMm_ = 0.0;
    double explainedShare_ = 0.0;
    double medianResidualPx_ = 0.0;
};

/// Of a run with motions of this strain that has seen nothing yet.
DeformationState startOfRun(const DeformationProblem& problem, double strain);

}   // namespace angiopose::core
