#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/opacification_model.h"

#include <cstdint>
#include <optional>

namespace angiopose::core {

/// Agreement of a pose with the image when parts of the tree may be unopacified.
struct OpacifiedAgreement {
    double agreement = 0.0;   ///< agreement of the opacified parts, 0…1; each unopacified territory reduces it
    std::vector<std::uint8_t> isOpacified;   ///< 1 for each opacified tree segment (see AgreementScore::opacification)
};

/// Scores how well a pose explains the image in both directions, from the fraction of the tree that lies along traced
/// vessels and the fraction of the traced vessels that the tree explains. Neither shrinking the tree nor covering a
/// single vessel raises both fractions.
class AgreementScore {
public:
    /// Gives auxiliary branches {p'} selected by the user the same weight as the whole tree.
    AgreementScore(const RegistrationProblem& problem, const TargetLines& target);

    /// Returns the harmonic mean of the two fractions, 0…1.
    double scoreAt(const CentroidPose& pose);

    /// Returns the same score for a tree that may be only partly opacified (ALGORITHMS §6.17): territories that match
    /// no traced vessel are excluded from both fractions.
    OpacifiedAgreement scoreOpacified(const CentroidPose& pose);

    /// Returns the segmentation of the tree between bifurcations; built on first use.
    const OpacificationModel& opacification();

private:
    double treeFraction(const CentroidPose& pose);
    void resetCoverage();
    void markCovered(const AlignmentPoint& point, const CentroidPose& pose);
    double coveredTargetFraction() const;

    const TreeSamples& tree_;
    std::size_t stride_;   ///< stride at which points_ samples the tree
    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::size_t lineStride_;   ///< stride of the target lines whose coverage is tested
    Alignment fullAlignment_;
    std::optional<Alignment> auxiliaryAlignment_;
    std::optional<OpacificationModel> opacification_;   ///< created on first use
    std::vector<int> segmentOfPoint_;   ///< segment index of each point in points_
    std::vector<double> pointAgreement_;
    std::vector<std::uint8_t> covered_;   ///< 1 for image cells near a projected tree point
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core
