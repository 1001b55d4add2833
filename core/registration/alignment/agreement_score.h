#pragma once

#include "core/registration/alignment/alignment.h"
#include "core/registration/alignment/vessel_filling.h"

#include <cstdint>
#include <optional>

namespace angiopose::core {

/// How well a pose explains the image when parts of the tree may be empty.
struct FilledAgreement {
    double agreement = 0.0;   ///< of the filled parts, lowered for every empty territory; 0…1
    std::vector<std::uint8_t> isOpacified;   ///< per piece of the tree, see AgreementScore::filling
};

/// How well a pose explains the image, both ways: the share of the tree that lies along traced vessels, and the share
/// of the traced vessels that the tree explains. Neither shrinking the tree nor covering one vessel raises both.
class AgreementScore {
public:
    /// When the user chose {p'}, its branches count as much as the whole tree.
    AgreementScore(const RegistrationProblem& problem, const TargetLines& target);

    /// Harmonic mean of both shares, 0…1.
    double of(const CentroidPose& pose);

    /// The same where the contrast medium need not fill all of the tree (ALGORITHMS §6.17): whole territories that lie
    /// on nothing are left out, on both sides.
    FilledAgreement ofFilled(const CentroidPose& pose);

    /// The tree's pieces.
    const VesselFilling& filling();

private:
    double treeShare(const CentroidPose& pose);
    void forgetCovered();
    void coverAround(const AlignmentPoint& point, const CentroidPose& pose);
    double coveredTargetShare() const;

    const TreeSamples& tree_;
    std::size_t stride_;   ///< of the tree points in points_
    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::size_t lineStride_;   ///< of the lines asked whether they are covered
    Alignment all_;
    std::optional<Alignment> chosen_;
    std::optional<VesselFilling> filling_;   ///< made when first asked for
    std::vector<int> pieceOfPoint_;   ///< of points_
    std::vector<double> pointAgreement_;
    std::vector<std::uint8_t> covered_;   ///< cells near a projected point
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core