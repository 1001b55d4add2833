#include "core/simulation/study/simulated_study.h"

#include "core/simulation/grow_tree.h"
#include "core/simulation/murray_radii.h"
#include "core/simulation/simulate_view_of.h"
#include "core/vessel/root_tree.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace angiopose::core {
namespace {

bool hasAllRadii(const VesselTree& tree)
{
    return std::ranges::all_of(tree.branches, [](const VesselBranch& branch) {
        return branch.radiusMm.size() == branch.pointsInPatient.size();
    });
}

/// Returns the branch end with the largest radius; the first point of the first branch if the tree has no radii.
Eigen::Vector3d rootOf(const VesselTree& tree)
{
    Eigen::Vector3d root = tree.branches.front().pointsInPatient.front();
    double thickest = 0.0;
    for (const VesselBranch& branch : tree.branches) {
        if (branch.radiusMm.empty()) {
            continue;
        }
        for (const bool isFront : {true, false}) {
            const double radius = isFront ? branch.radiusMm.front() : branch.radiusMm.back();
            if (radius > thickest) {
                thickest = radius;
                root = isFront ? branch.pointsInPatient.front() : branch.pointsInPatient.back();
            }
        }
    }
    return root;
}

Takeoff nearestTakeoff(const std::vector<VesselBranch>& branches, std::size_t child)
{
    const Eigen::Vector3d& begin = branches[child].pointsInPatient.front();
    Takeoff nearest;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < child; ++b) {
        for (std::size_t i = 0; i < branches[b].pointsInPatient.size(); ++i) {
            const double distance = (branches[b].pointsInPatient[i] - begin).squaredNorm();
            if (distance < best) {
                best = distance;
                nearest = {static_cast<int>(b), i};
            }
        }
    }
    return nearest;
}

/// Converts a given tree to a GrownTree: roots it (rootTreeAt) at the branch end with the largest radius and lets every
/// branch but the trunk leave from the nearest point of the branches before it, so that disconnected components are
/// supplied too. Unknown radii follow Murray's law from `rootRadiusMm` (assignMurrayRadii).
GrownTree withTakeoffs(const VesselTree& tree, double rootRadiusMm)
{
    GrownTree grown;
    grown.tree = rootTreeAt(tree, rootOf(tree));
    for (std::size_t b = 0; b < grown.tree.branches.size(); ++b) {
        grown.takeoffs.push_back(nearestTakeoff(grown.tree.branches, b));
    }
    if (!hasAllRadii(tree)) {
        assignMurrayRadii(grown, rootRadiusMm);
    }
    return grown;
}

/// Returns the longest edge of the tree's bounding box.
double longestEdgeMm(const VesselTree& tree)
{
    Eigen::Vector3d low = tree.branches.front().pointsInPatient.front();
    Eigen::Vector3d high = low;
    for (const VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    }
    return (high - low).maxCoeff();
}

/// Independent random streams of a study.
enum StudyStream : std::uint64_t { StudyTrees = 1, StudyViews, StudyHeaders };

constexpr double percent = 0.01;

struct CaseTree {
    GrownTree grown;
    double extentMm = 0.0;
};

CaseTree treeAt(const SimulatedStudy& study, std::size_t tree)
{
    std::size_t first = 0;
    for (const StudyTree& row : study.trees) {
        if (tree < first + static_cast<std::size_t>(row.count)) {
            if (row.given) {
                return {withTakeoffs(*row.given, row.grown.rootRadiusMm), longestEdgeMm(*row.given)};
            }
            const std::uint64_t seed = CounterRandom(study.seed).fork(StudyTrees).fork(tree)();
            return {growTree(seed, row.grown), row.grown.extentMm};
        }
        first += static_cast<std::size_t>(row.count);
    }
    assert(false);   // unreachable: studyCaseOf returns only existing trees
    return {};
}

void multiplyValue(SourcedValue<double>& value, double factor)
{
    *value.value *= factor;
}

/// Adds errors to the header values and recomputes the initial pose from them, about the isocenter assumed so far.
void addHeaderErrors(SimulatedCase& simulated, const HeaderErrors& errors, CounterRandom random)
{
    CArm& header = simulated.angiogram.cArm;
    const Eigen::Vector3d isocenter =
        simulated.initialCameraFromPatient.inverse() * Eigen::Vector3d(0.0, 0.0, *header.sourceToIsocenterMm.value);
    multiplyValue(header.sourceToDetectorMm, 1.0 + percent * errors.distancePercent * random.normal());
    multiplyValue(header.sourceToIsocenterMm, 1.0 + percent * errors.distancePercent * random.normal());
    const double spacing = 1.0 + percent * errors.spacingPercent * random.normal();
    multiplyValue(header.columnSpacingMm, spacing);
    multiplyValue(header.rowSpacingMm, spacing);
    *header.primaryAngleDeg.value += errors.angleDeg * random.normal();
    *header.secondaryAngleDeg.value += errors.angleDeg * random.normal();
    if (const auto pose = cameraFromPatient(header, isocenter)) {
        simulated.initialCameraFromPatient = pose.value();
    }
}

bool areZero(const HeaderErrors& errors)
{
    return errors.distancePercent == 0.0 && errors.spacingPercent == 0.0 && errors.angleDeg == 0.0;
}

}   // namespace

std::size_t SimulatedStudy::treeCount() const
{
    std::size_t count = 0;
    for (const StudyTree& tree : trees) {
        count += static_cast<std::size_t>(tree.count);
    }
    return count;
}

StudyCase studyCaseOf(const SimulatedStudy& study, std::size_t index)
{
    const auto perSetting = static_cast<std::size_t>(study.casesPerSetting);
    const std::size_t number = index % perSetting;
    return {index / perSetting, number, number % study.treeCount()};
}

SimulatedCase simulateStudyCase(const SimulatedStudy& study, std::size_t index)
{
    const StudyCase place = studyCaseOf(study, index);
    const StudySetting& setting = study.settings[place.setting];
    const CaseTree tree = treeAt(study, place.tree);
    const CounterRandom random(study.seed);
    SimulatedCase simulated =
        simulateViewOf(tree.grown, tree.extentMm, random.fork(StudyViews).fork(place.number)(), setting.dsa);
    if (!areZero(setting.header)) {
        addHeaderErrors(simulated, setting.header, random.fork(StudyHeaders).fork(index));
    }
    return simulated;
}

std::optional<Message> findProblem(const SimulatedStudy& study)
{
    for (const StudyTree& tree : study.trees) {
        for (const StudySetting& setting : study.settings) {
            if (auto problem = findProblem(tree.grown, setting.dsa)) {
                return problem;
            }
        }
    }
    return {};
}

}   // namespace angiopose::core
