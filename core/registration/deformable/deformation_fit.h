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
    RigidTransform cameraFromFirst;   ///< before its correction
    CurveCrossings curves;
};

/// Data common to all runs of a fit.
struct DeformationProblem {
    TreeKnots knots;
    FieldKernel kernel;
    std::vector<DeformationView> views;
    Eigen::Vector3d centroidInPatient;
    CentroidPose start;   ///< pose in the first view
    MotionPrior prior;   ///< prior of the motion; each run has its own variances
    LinearBelief startStep;   ///< step from the rigid pose according to the initial pose only
};

/// State of a run.
struct DeformationState {
    Vector6d poseStep = Vector6d::Zero();   ///< relative to the start, see CentroidPose
    std::vector<Vector6d> corrections;   ///< corrections of the geometry between views
    Eigen::Matrix3Xd motionMm;   ///< motion of each knot, patient axes
    Eigen::MatrixXd deviationMm;   ///< 1-σ across the vessel, knots × views
    MotionVariances variances{};
    double noisePx = 1.0;
};

/// Settings of one step.
struct DeformationStep {
    double annealingMm = 0.0;   ///< 1-σ added to the noise
    double strain = 0.15;   ///< strain between neighbors, see NeighborModel
    bool isLearning = false;   ///< whether variances and noise are estimated
    bool isCoarse = false;   ///< only every other knot gives a row: sufficient while the noise is large
};

/// One run of the fit, step by step: evaluate, match along the tree, and solve for pose and motion jointly (ALGORITHMS
/// §11.3).
class DeformationFit {
public:
    /// `problem` must outlive the fit.
    DeformationFit(const DeformationProblem& problem, DeformationState start);

    void step(const DeformationStep& step);

    const DeformationState& state() const { return state_; }
    const std::vector<MotionRow>& rows() const { return rows_; }
    const std::optional<FieldPosterior>& posterior() const { return posterior_; }   ///< nullopt if there are no rows

    /// Fraction of the used tree's visible length that has a matching vessel, 0…1.
    double explainedShare() const { return explainedShare_; }
    /// Log likelihood of the rows and the unmatched knots, up to a constant common to all runs.
    double logLikelihood() const;

    double medianResidualPx() const { return medianResidualPx_; }

    DeformedTree deformedTree() const;
    RigidTransform viewFromFirst(std::size_t view) const;   ///< with the correction applied

private:
    using Looks = std::vector<std::optional<KnotLook>>;

    DeformableSight sightOf(std::size_t view) const;
    double noiseMm(const KnotLook& look) const { return state_.noisePx * look.mmPerPx; }
    std::vector<KnotChoice> choicesOf(const DeformableSight& sight, const Looks& looks, std::size_t view,
                                      double annealingMm) const;
    void collectRows(std::size_t view, const DeformationStep& step);
    void addRow(const KnotLook& look, const KnotChoice& choice, std::size_t view, const DeformationStep& step);
    double foundMm(const MotionRow& row) const;   ///< offset predicted by pose, geometry and motion for a row
    void learn();
    void measureDeviations();

    const DeformationProblem& problem_;
    DeformationState state_;
    std::vector<MotionRow> rows_;
    std::vector<double> rowPx_;   ///< mm per px for each row
    std::vector<double> rowWeight_;
    std::vector<std::vector<MotionRow>> others_;   ///< per view: rows of knots that gave no observation
    std::optional<FieldPosterior> posterior_;
    double seenMm_ = 0.0;
    double explainedMm_ = 0.0;
    double explainedShare_ = 0.0;
    double medianResidualPx_ = 0.0;
};

/// Initial state of a run with motions of this strain.
DeformationState startOfRun(const DeformationProblem& problem, double strain);

}   // namespace angiopose::core
