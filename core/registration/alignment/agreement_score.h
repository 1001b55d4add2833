#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/vessel_filling.h"

#include <cstdint>
#include <optional>

namespace angiopose::core {

/// Agreement of a pose with the image when parts of the tree may be unopacified.
struct FilledAgreement {
    double agreement = 0.0;   ///< agreement of the opacified parts, reduced for every unopacified territory; 0…1
    std::vector<std::uint8_t> isOpacified;   ///< per piece of the tree, see AgreementScore::filling
};

/// Scores how well a pose explains the image in both directions: the share of the tree that lies along traced vessels
/// and the share of the traced vessels that the tree explains. Neither shrinking the tree nor covering a single vessel
/// raises both.
class AgreementScore {
public:
    /// If the user chose auxiliary branches {p'}, they count as much as the whole tree.
    AgreementScore(const RegistrationProblem& problem, const TargetLines& target);

    /// Harmonic mean of the two shares, 0…1.
    double of(const CentroidPose& pose);

    /// Same score when the contrast agent need not opacify the whole tree (ALGORITHMS §6.17): whole territories that
    /// match no traced vessel are excluded from both shares.
    FilledAgreement ofFilled(const CentroidPose& pose);

    /// Pieces of the tree.
    const VesselFilling& filling();

private:
    double treeShare(const CentroidPose& pose);
    void forgetCovered();
    void coverAround(const AlignmentPoint& point, const CentroidPose& pose);
    double coveredTargetShare() const;

    const TreeSamples& tree_;
    std::size_t stride_;   ///< stride of the tree points in points_
    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::size_t lineStride_;   ///< stride of the target lines tested for coverage
    Alignment all_;
    std::optional<Alignment> chosen_;
    std::optional<VesselFilling> filling_;   ///< created on first use
    std::vector<int> pieceOfPoint_;   ///< piece of each point in points_
    std::vector<double> pointAgreement_;
    std::vector<std::uint8_t> covered_;   ///< image cells near a projected point
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core