#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/geometry/angle_units.h"

#include <algorithm>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr int clinicalAnatomies = 6;
constexpr std::uint64_t clinicalSeeds = 1000;

struct ClinicalSetting {
    Condition condition;
    double nonRigidStdMm = 0.0;
};

const std::vector<ClinicalSetting>& clinicalSettings()
{
    static const std::vector<ClinicalSetting> rows{
        {{"nonrigid-0", "synthetic DSA, rigid", false}, 0.0},
        {{"nonrigid-1", "synthetic DSA, deformed by 1 mm", true}, 1.0},
        {{"nonrigid-2", "synthetic DSA, deformed by 2 mm", false}, 2.0},
        {{"nonrigid-3", "synthetic DSA, deformed by 3 mm", false}, 3.0},
    };
    return rows;
}

TrialMaker prepareClinical(std::size_t condition, std::uint64_t seed)
{
    return [nonRigidStdMm = clinicalSettings()[condition].nonRigidStdMm, seed](std::uint64_t number) {
        DsaOptions dsa;
        dsa.frameCount = 1;
        dsa.nonRigidStdMm = nonRigidStdMm;
        const std::uint64_t treeSeed = seed * clinicalSeeds + number % clinicalAnatomies;
        return makeTracedTrial(simulateView(treeSeed, trialRandom(clinicalNumber, seed, number)(), {}, dsa));
    };
}

constexpr int confidenceAnatomies = 6;
constexpr std::uint64_t confidenceSeeds = 1000;
constexpr std::uint64_t otherTreesFrom = 500;   // offset of the tree seeds within an experiment

/// Modification of a clinical case that makes methods fail, or for which they should report low confidence.
enum class CaseModification { None, OtherTree, Mirrored, FarStart, HalfOutside };

struct ConfidenceSetting {
    Condition condition;
    CaseModification modification = CaseModification::None;
    DsaOptions dsa{};
};

DsaOptions withMissingBranches(double missingShare, double extraShare)
{
    DsaOptions dsa;
    dsa.missingBranchShare = missingShare;
    dsa.extraBranchShare = extraShare;
    return dsa;
}

DsaOptions withDeformation(double stdMm)
{
    DsaOptions dsa;
    dsa.nonRigidStdMm = stdMm;
    return dsa;
}

const std::vector<ConfidenceSetting>& confidenceSettings()
{
    static const std::vector<ConfidenceSetting> rows{
        {{"as-given", "initial pose from the header"}, CaseModification::None, {}},
        {{"bent", "vessels deformed by 3 mm"}, CaseModification::None, withDeformation(3.0)},
        {{"few-vessels", "most branches unopacified, as many branches missing in the tree"},
         CaseModification::None,
         withMissingBranches(0.6, 0.6)},
        {{"half-outside", "half of the image cut off"}, CaseModification::HalfOutside, {}},
        {{"far-start", "initial pose 60–150 mm and 30–75° off"}, CaseModification::FarStart, {}},
        {{"other-tree", "the vessel tree of another patient"}, CaseModification::OtherTree, {}},
        {{"mirrored", "image mirrored, unknown to the camera"}, CaseModification::Mirrored, {}},
    };
    return rows;
}

ImageF mirrored(ImageF image)
{
    for (int y = 0; y < image.height; ++y) {
        const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, y));
        std::reverse(row, row + image.width);
    }
    return image;
}

/// Returns the part of the image that has the given size and starts at pixel (left, top).
ImageF crop(const ImageF& image, int left, int top, int width, int height)
{
    ImageF part(width, height);
    for (int y = 0; y < height; ++y) {
        const auto from = image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(left, top + y));
        std::copy_n(from, width, part.pixels.begin() + static_cast<std::ptrdiff_t>(part.index(0, y)));
    }
    return part;
}

/// Crops the image to its left, right, upper or lower half.
void cropToHalf(SimulatedCase& view, CounterRandom& random)
{
    const int side = random.index(4);
    const bool isUpright = side < 2;
    ImageF& frame = view.angiogram.frames.front();
    const int width = isUpright ? frame.width / 2 : frame.width;
    const int height = isUpright ? frame.height : frame.height / 2;
    const int left = side == 1 ? frame.width - width : 0;
    const int top = side == 3 ? frame.height - height : 0;
    frame = crop(frame, left, top, width, height);
    view.camera.cx -= left;
    view.camera.cy -= top;
    view.camera.width = width;
    view.camera.height = height;
}

/// Displaces the initial pose by a rotation about the tree's centroid, a lateral shift and a shift along the ray, each
/// in a random direction.
void displaceInitialPose(SimulatedCase& view, CounterRandom& random)
{
    const Eigen::Vector3d centroid = centroidInPatient(view.tree);
    const RigidTransform& truth = view.trueCameraFromPatient;
    const double turn = random.uniform(30.0, 75.0) * radiansPerDegree;
    const Eigen::Matrix3d rotation = expSo3(randomDirection(turn, random)) * truth.rotation;
    const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double acrossMm = random.uniform(60.0, 150.0);
    const Eigen::Vector3d shift(acrossMm * std::cos(direction), acrossMm * std::sin(direction),
                                random.uniform(-60.0, 60.0));
    view.initialCameraFromPatient = {rotation, truth * centroid + shift - rotation * centroid};
}

/// Replaces the tree with another tree and keeps the initial position of the centroid.
void replaceTree(SimulatedCase& view, std::uint64_t treeSeed)
{
    const Eigen::Vector3d centroid = centroidInPatient(view.tree);
    view.tree = simulateTree(treeSeed);
    RigidTransform& start = view.initialCameraFromPatient;
    start.translation += start.rotation * (centroid - centroidInPatient(view.tree));
}

Trial makeTrial(const ConfidenceSetting& setting, std::uint64_t seed, std::uint64_t number)
{
    CounterRandom random = trialRandom(confidenceNumber, seed, number);
    const std::uint64_t treeSeed = seed * confidenceSeeds + number % confidenceAnatomies;
    DsaOptions dsa = setting.dsa;
    dsa.frameCount = 1;
    SimulatedCase view = simulateView(treeSeed, random(), {}, dsa);
    switch (setting.modification) {
        case CaseModification::None:
            break;
        case CaseModification::OtherTree:
            replaceTree(view, treeSeed + otherTreesFrom);
            break;
        case CaseModification::Mirrored:
            view.angiogram.frames.front() = mirrored(std::move(view.angiogram.frames.front()));
            break;
        case CaseModification::FarStart:
            displaceInitialPose(view, random);
            break;
        case CaseModification::HalfOutside:
            cropToHalf(view, random);
            break;
    }
    Trial trial = makeTracedTrial(view);
    trial.hasCorrectPose =
        setting.modification != CaseModification::OtherTree && setting.modification != CaseModification::Mirrored;
    return trial;
}

TrialMaker prepareConfidence(std::size_t condition, std::uint64_t seed)
{
    return [setting = confidenceSettings()[condition], seed](std::uint64_t number) {
        return makeTrial(setting, seed, number);
    };
}

}   // namespace

Protocol clinicalProtocol()
{
    return {"clinical",
            "Synthetic angiograms of six trees, traced as real images are, initial poses as headers give them "
            "(ALGORITHMS 4.4).",
            278,
            clinicalAnatomies,
            SuccessCriterion::RayDistanceWithin2Mm,
            conditionsOf(clinicalSettings()),
            prepareClinical};
}

Protocol ownProtocol()
{
    return {"own",
            "Your own cases, listed in a table with their reference poses, landmarks or pairs of points.",
            0,
            1,
            SuccessCriterion::RayDistanceWithin2Mm,
            {},
            nullptr};
}

Protocol confidenceProtocol()
{
    return {"trust",
            "Clinical images unchanged, made harder, and made impossible: does a method detect its failures?",
            60,
            confidenceAnatomies,
            SuccessCriterion::RayDistanceWithin2Mm,
            conditionsOf(confidenceSettings()),
            prepareConfidence};
}

}   // namespace angiopose::core
