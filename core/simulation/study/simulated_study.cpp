#include "core/simulation/study/simulated_study.h"

#include "core/simulation/grow_tree.h"
#include "core/simulation/simulate_view_of.h"
#include "core/simulation/tree_takeoffs.h"

#include <cassert>

namespace angiopose::core {
namespace {

/// Random streams of the study's generator.
enum StudyStream : std::uint64_t { StudyTrees = 1, StudyViews, StudyHeaders };

constexpr double percent = 0.01;

struct ChosenTree {
    GrownTree grown;
    double extentMm = 0.0;
};

ChosenTree treeAt(const SimulatedStudy& study, std::size_t tree)
{
    std::size_t first = 0;
    for (const StudyTree& row : study.trees) {
        if (tree < first + static_cast<std::size_t>(row.count)) {
            if (row.given) {
                return {withTakeoffs(*row.given, row.grown.rootRadiusMm), extentMm(*row.given)};
            }
            const std::uint64_t seed = CounterRandom(study.seed).fork(StudyTrees).fork(tree)();
            return {growTree(seed, row.grown), row.grown.extentMm};
        }
        first += static_cast<std::size_t>(row.count);
    }
    assert(false);   // placeOf cycles through all trees
    return {};
}

void disturb(Sourced<double>& value, double factor)
{
    *value.value *= factor;
}

/// Introduces header errors; the initial pose follows from the wrong values, with the assumed isocenter.
void makeHeaderWrong(SimulatedCase& simulated, const HeaderErrors& errors, CounterRandom random)
{
    CArm& header = simulated.angiogram.cArm;
    const Eigen::Vector3d isocenter =
        simulated.initialCameraFromPatient.inverse() * Eigen::Vector3d(0.0, 0.0, *header.sourceToIsocenterMm.value);
    disturb(header.sourceToDetectorMm, 1.0 + percent * errors.distancePercent * random.normal());
    disturb(header.sourceToIsocenterMm, 1.0 + percent * errors.distancePercent * random.normal());
    const double spacing = 1.0 + percent * errors.spacingPercent * random.normal();
    disturb(header.columnSpacingMm, spacing);
    disturb(header.rowSpacingMm, spacing);
    *header.primaryAngleDeg.value += errors.angleDeg * random.normal();
    *header.secondaryAngleDeg.value += errors.angleDeg * random.normal();
    if (const auto pose = cameraFromPatient(header, isocenter)) {
        simulated.initialCameraFromPatient = pose.value();
    }
}

bool areRight(const HeaderErrors& errors)
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

StudyPlace placeOf(const SimulatedStudy& study, std::size_t index)
{
    const auto perSetting = static_cast<std::size_t>(study.casesPerSetting);
    const std::size_t number = index % perSetting;
    return {index / perSetting, number, number % study.treeCount()};
}

SimulatedCase simulateStudyCase(const SimulatedStudy& study, std::size_t index)
{
    const StudyPlace place = placeOf(study, index);
    const StudySetting& setting = study.settings[place.setting];
    const ChosenTree tree = treeAt(study, place.tree);
    const CounterRandom random(study.seed);
    SimulatedCase simulated =
        simulateViewOf(tree.grown, tree.extentMm, random.fork(StudyViews).fork(place.number)(), setting.dsa);
    if (!areRight(setting.header)) {
        makeHeaderWrong(simulated, setting.header, random.fork(StudyHeaders).fork(index));
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
