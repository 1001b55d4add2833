#include "core/registration/image_orientation_check.h"

#include "core/messages/messages.h"
#include "core/registration/alignment/pose_ranking.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace angiopose::core {
namespace {

// Thresholds measured on synthetic trees (wrong_geometry_table --family development).
constexpr double minBetter = 0.15;   // required gain in agreement of another orientation hypothesis
constexpr double minConvincing = 0.45;
constexpr double maxQuestionedAgreement =
    0.5;   // above this agreement, a reliable fit of many branches is not questioned
constexpr std::size_t fewBranches = 6;
constexpr double asWell = 0.9;

/// Hypothesis about the stored orientation of an image relative to its camera: mirrored left to right, then rotated by
/// multiples of 90°.
struct ImageOrientation {
    bool isMirrored = false;
    int quarterTurns = 0;   ///< rotations by 90° about the camera's z axis
};

/// Returns the problem for this orientation: the same image with a changed camera and initial pose.
RegistrationProblem withOrientation(const ImageOrientation& reading, const RegistrationProblem& problem)
{
    RegistrationProblem other = problem;
    if (reading.isMirrored) {
        other.camera.fx = -problem.camera.fx;
        other.camera.cx = problem.camera.width - 1 - problem.camera.cx;
    }
    const Eigen::Vector3d turn(0.0, 0.0, 0.5 * std::numbers::pi * reading.quarterTurns);
    other.start = RigidTransform{expSo3(turn), Eigen::Vector3d::Zero()} * problem.start;
    return other;
}

/// Returns the problem for a device that reports its angles relative to the table.
RegistrationProblem withOrientation(const TableAngles& reading, const RegistrationProblem& problem)
{
    RegistrationProblem other = problem;
    const Eigen::Vector3d& pivot = problem.wholeTreeCentroid;
    other.start = problem.start * RigidTransform{reading.turn, pivot - reading.turn * pivot};
    return other;
}

/// Returns the agreement of tree and image, 0…1, after a search around the initial pose; 0 if stopped.
double agreementOf(const RegistrationProblem& problem, const RegistrationOptions& options,
                   const SearchObserver& observe)
{
    const TargetLines lines(problem.target, problem.camera);
    const CentroidPose start = aboutCentroid(problem.start, problem.tree.centroid);
    PoseRanking ranking(problem, lines, initialPosePrior(start, options));
    ranking.add(start);
    if (!ranking.isConclusive()) {
        for (const CentroidPose& hypothesis : PoseSearch(problem, lines, options).searchNearby(start, observe)) {
            if (observe(1.0) == ObserverDecision::Stop) {
                return 0.0;
            }
            ranking.add(hypothesis);
            if (ranking.isConclusive()) {
                break;
            }
        }
    }
    return ranking.best().agreement;
}

/// Whether a quarter turn about z appears clockwise; it appears reversed in an image as seen from the detector.
bool isClockwise(int quarterTurns, const ProjectionCamera& camera)
{
    return (quarterTurns == 1) == (camera.fx * camera.fy > 0.0);
}

Message orientationMessage(const ImageOrientation& reading, const ProjectionCamera& camera, double agreement,
                           double storedAgreement)
{
    const Quantity better{100.0 * agreement, 0, "%"};
    const Quantity plain{100.0 * storedAgreement, 0, "%"};
    if (reading.isMirrored) {
        return reading.quarterTurns == 0   ? messages::frameMirroredLeftRight(better, plain)
               : reading.quarterTurns == 2 ? messages::frameMirroredUpDown(better, plain)
                                           : messages::frameMirroredAndTurned(better, plain);
    }
    if (reading.quarterTurns == 2) {
        return messages::frameUpsideDown(better, plain);
    }
    return isClockwise(reading.quarterTurns, camera) ? messages::frameTurnedClockwise(better, plain)
                                                     : messages::frameTurnedAnticlockwise(better, plain);
}

Message orientationMessage(const TableAngles& reading, double agreement, double storedAgreement)
{
    const PatientAngles& angles = reading.angles;
    return messages::frameAnglesFromTable(std::string(toText(reading.position)), Quantity{100.0 * agreement, 0, "%"},
                                          Quantity{100.0 * storedAgreement, 0, "%"},
                                          Quantity{angles.primaryDeg, 1, "°"}, Quantity{angles.secondaryDeg, 1, "°"},
                                          Quantity{angles.rollDeg, 1, "°"});
}

std::optional<Message> findLikelyOrientation(const RegistrationProblem& problem, const RegistrationOptions& options,
                                             double storedAgreement, const SearchObserver& observe)
{
    static constexpr std::array readings{
        ImageOrientation{true, 0},  ImageOrientation{true, 2}, ImageOrientation{false, 1}, ImageOrientation{false, 2},
        ImageOrientation{false, 3}, ImageOrientation{true, 1}, ImageOrientation{true, 3}};
    double best = std::max(minConvincing, storedAgreement + minBetter);
    std::optional<Message> likely;
    if (problem.tableAngles) {   // tried first, because the header supports it and a frontal view rotated by 180°
                                 // looks the same
        const double agreement = agreementOf(withOrientation(*problem.tableAngles, problem), options, observe);
        if (agreement > best) {
            best = agreement;
            likely = orientationMessage(*problem.tableAngles, agreement, storedAgreement);
        }
    }
    for (const ImageOrientation& reading : readings) {
        if (observe(0.0) == ObserverDecision::Stop) {
            return {};
        }
        const double agreement = agreementOf(withOrientation(reading, problem), options, observe);
        if (agreement > best) {
            best = agreement;
            likely = orientationMessage(reading, problem.camera, agreement, storedAgreement);
        }
    }
    return likely;
}

}   // namespace

ImageOrientationCheck checkImageOrientation(const RegistrationProblem& problem, const RegistrationOptions& options,
                                            const MethodSolution& solution, const RegistrationResult& assessed,
                                            const SearchObserver& observe)
{
    if (!options.geometry.checkOrientation || !options.angiopose.search || isAnyLocked(options.locks)) {
        return {};
    }
    const CentroidPose pose = aboutCentroid(assessed.cameraFromPatient, problem.tree.centroid);
    const double storedAgreement =
        solution.agreement ? *solution.agreement : AgreementScore(problem, *solution.targetLines).scoreAt(pose);
    if (!assessed.trustworthy) {
        return {findLikelyOrientation(problem, options, storedAgreement, observe), false};
    }
    if (storedAgreement >= maxQuestionedAgreement && problem.tree.branchIds.size() >= fewBranches) {
        return {};
    }
    const double mirrored = agreementOf(withOrientation({true, 0}, problem), options, observe);
    if (mirrored < asWell * storedAgreement) {
        return {};
    }
    return {messages::frameMirroredFitsEqually(Quantity{100.0 * mirrored, 0, "%"},
                                               Quantity{100.0 * storedAgreement, 0, "%"}),
            true};
}

}   // namespace angiopose::core
