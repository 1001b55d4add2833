#pragma once

#include "core/registration/alignment/alignment.h"

#include <cstdint>
#include <optional>

namespace angiopose::core {

/// How well a pose explains the image, both ways: the share of the tree that lies along traced vessels, and the share
/// of the traced vessels that the tree explains. Neither shrinking the tree nor covering one vessel raises both.
class AgreementScore {
public:
    /// When the user chose {p'}, its branches count as much as the whole tree.
    AgreementScore(const RegistrationProblem& problem, const TargetLines& target);

    /// Harmonic mean of both shares, 0…1.
    double of(const CentroidPose& pose);

private:
    double treeShare(const CentroidPose& pose);
    double coveredTargetShare(const CentroidPose& pose);

    std::vector<AlignmentPoint> points_;
    ProjectionCamera camera_;
    const TargetLines* target_;
    std::size_t lineStride_;   ///< of the lines asked whether they are covered
    Alignment all_;
    std::optional<Alignment> chosen_;
    std::vector<std::uint8_t> covered_;   ///< cells near a projected point
    int columns_ = 0;
    int rows_ = 0;
};

}   // namespace angiopose::core