#include "core/evaluation/protocols/phantoms.h"
#include "core/evaluation/protocols/protocol_rows.h"
#include "core/simulation/prune_tree.h"
#include "core/simulation/simulated_case.h"
#include "core/support/format_number.h"

#include "core/geometry/angle_units.h"

namespace angiopose::core {
namespace {

constexpr int robustnessAnatomies = 6;
constexpr int prunedLeafCount = 5;

enum class Pruning { None, Target, BothSides };
enum class Direction { Lateral, Isotropic };   ///< direction of the shift

struct RobustnessSetting {
    Condition condition;
    Pruning pruning = Pruning::None;
    Direction direction = Direction::Lateral;
    double shiftMm = 0.0;
    double rotationDeg = 0.0;
};

struct PruningName {
    std::string id;
    std::string title;
};

PruningName pruningName(Pruning pruning)
{
    switch (pruning) {
        case Pruning::None:
            return {"full", "no pruning"};
        case Pruning::Target:
            return {"pruned", "5 leaves missing in the image"};
        case Pruning::BothSides:
            return {"both", "5 leaves missing in the image, 5 others in the tree"};
    }
    return {};
}

RobustnessSetting makeSetting(Pruning pruning, Direction direction, double shiftMm, double rotationDeg)
{
    const bool isLateral = direction == Direction::Lateral;
    const PruningName name = pruningName(pruning);
    const std::string mm = plainText(shiftMm);
    const std::string deg = plainText(rotationDeg);
    return {{(isLateral ? "" : "isotropic-") + name.id + "-" + mm + "-" + deg,
             mm + " mm " + (isLateral ? "lateral" : "any direction") + ", " + deg + "°, " + name.title, isLateral},
            pruning,
            direction,
            shiftMm,
            rotationDeg};
}

std::vector<RobustnessSetting> makeRobustnessSettings()
{
    std::vector<RobustnessSetting> rows;
    for (const Direction direction : {Direction::Lateral, Direction::Isotropic}) {
        for (const Pruning pruning : {Pruning::None, Pruning::Target, Pruning::BothSides}) {
            for (const auto& [mm, deg] : {std::pair(5.0, 2.0), {8.0, 3.0}, {10.0, 5.0}}) {
                rows.push_back(makeSetting(pruning, direction, mm, deg));
            }
        }
    }
    return rows;
}

const std::vector<RobustnessSetting>& robustnessSettings()
{
    static const std::vector<RobustnessSetting> rows = makeRobustnessSettings();
    return rows;
}

/// Draws a random motion in the camera frame with the rotation angle and shift length of the setting.
RigidTransform randomDisplacement(const RobustnessSetting& setting, CounterRandom random)
{
    Vector6d twist;
    twist.head<3>() = randomDirection(setting.rotationDeg * radiansPerDegree, random);
    Eigen::Vector3d shift = randomDirection(setting.shiftMm, random);
    if (setting.direction == Direction::Lateral) {
        shift.z() = 0.0;
        shift *= setting.shiftMm / shift.norm();
    }
    twist.tail<3>() = shift;
    return expSe3(twist);
}

TrialMaker prepareRobustness(std::size_t condition, std::uint64_t seed)
{
    return [phantoms = makePhantoms(seed, robustnessAnatomies), setting = robustnessSettings()[condition],
            seed](std::uint64_t number) {
        const CounterRandom random = trialRandom(robustnessNumber, seed, number);
        const SharedPhantom& phantom = (*phantoms)[number % robustnessAnatomies];
        Trial trial = phantom.makeTrial();
        if (setting.pruning != Pruning::None) {
            CounterRandom imageSide = random.fork(1);
            trial.input.target = projectCurves(removeRandomLeaves(*phantom.tree, prunedLeafCount, imageSide),
                                               phantom.scene.camera, phantom.scene.trueCameraFromPatient);
        }
        if (setting.pruning == Pruning::BothSides) {
            CounterRandom treeSide = random.fork(2);
            trial.input.tree = removeRandomLeaves(*phantom.tree, prunedLeafCount, treeSide);
        }
        trial.input.initialCameraFromPatient =
            randomDisplacement(setting, random.fork(0)) * trial.trueCameraFromPatient;
        return trial;
    };
}

}   // namespace

Protocol robustnessProtocol()
{
    return {"robustness",
            "Six trees, initial poses at fixed distances, with and without missing leaves (ALGORITHMS 4.3).",
            600,
            robustnessAnatomies,
            SuccessCriterion::ProjectionWithin5Px,
            conditionsOf(robustnessSettings()),
            prepareRobustness};
}

}   // namespace angiopose::core
