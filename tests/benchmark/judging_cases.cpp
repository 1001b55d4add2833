#include "tests/benchmark/judging_cases.h"

#include "io/vessel_tree_file.h"
#include "tests/benchmark/deformed_cases.h"
#include "tests/benchmark/wrong_geometry.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace angiopose::benchmarks {
namespace {

using Form = TrueMotion::Form;

constexpr std::size_t minBranches = 8;
constexpr double touchingMm = 2.5;

struct Kind {
    std::string_view name;
    ForeignScene scene = ForeignScene::WholeTree;
    GeometryError error = GeometryError::None;
    std::optional<TrueMotion> motion{};
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all{
        {"whole tree", ForeignScene::WholeTree},
        {"one territory", ForeignScene::OneTerritory},
        {"two territories", ForeignScene::TwoTerritories},
        {"leaves missing, foreign curves", ForeignScene::LeavesMissing},
        {"one vessel", ForeignScene::OneVessel},
        {"SID 5 % off", ForeignScene::WholeTree, GeometryError::Distance},
        {"spacing 3 % off", ForeignScene::WholeTree, GeometryError::Spacing},
        {"principal point 20 px off", ForeignScene::WholeTree, GeometryError::PrincipalPoint},
        {"bent: rigid", {}, {}, TrueMotion{Form::None, 0, 0}},
        {"bent: field 40, 1 mm", {}, {}, TrueMotion{Form::Field, 40, 1}},
        {"bent: field 40, 2 mm", {}, {}, TrueMotion{Form::Field, 40, 2}},
        {"bent: field 40, 3 mm", {}, {}, TrueMotion{Form::Field, 40, 3}},
        {"bent: field 40, 5 mm", {}, {}, TrueMotion{Form::Field, 40, 5}},
        {"bent: field 20, 2 mm", {}, {}, TrueMotion{Form::Field, 20, 2}},
        {"bent: field 20, 3 mm", {}, {}, TrueMotion{Form::Field, 20, 3}},
        {"bent: field 80, 3 mm", {}, {}, TrueMotion{Form::Field, 80, 3}},
        {"bent: waves 3 mm", {}, {}, TrueMotion{Form::Waves, 40, 3}},
        {"bent: breathing 10 mm", {}, {}, TrueMotion{Form::Breathing, 0, 10}},
        {"bent: wire 6 mm", {}, {}, TrueMotion{Form::Wire, 0, 6}},
        {"bent: half by 8 mm", {}, {}, TrueMotion{Form::Half, 0, 8}},
        {"another tree", ForeignScene::OtherPatient},
        {"another territory", ForeignScene::OtherTerritory},
        {"mirrored left to right", ForeignScene::WholeTree, GeometryError::MirroredLeftRight},
        {"mirrored up to down", ForeignScene::WholeTree, GeometryError::MirroredUpDown},
    };
    return all;
}

RootedTree partOf(const RootedTree& tree, std::size_t root, const std::string& name)
{
    const std::vector<std::size_t> fed = tree.fedThrough(root);
    RootedTree part;
    part.name = name;
    for (const std::size_t branch : fed) {
        part.tree.branches.push_back(tree.tree.branches[branch]);
        const auto parent = std::ranges::find(fed, static_cast<std::size_t>(std::max(0, tree.parent[branch])));
        part.parent.push_back(tree.parent[branch] < 0 || parent == fed.end() ? -1
                                                                             : static_cast<int>(parent - fed.begin()));
    }
    return part;
}

/// Determines the parents of a file's branches: each is fed by the earlier branch on which it begins.
RootedTree rootedByTouch(const core::VesselTree& tree, const std::string& name)
{
    RootedTree rooted{name, core::resampled(tree, 1.0), {}};
    for (std::size_t branch = 0; branch < rooted.tree.branches.size(); ++branch) {
        const Eigen::Vector3d begin = rooted.tree.branches[branch].pointsInPatient.front();
        int parent = -1;
        double nearest = touchingMm;
        for (std::size_t other = 0; other < branch; ++other) {
            for (const Eigen::Vector3d& point : rooted.tree.branches[other].pointsInPatient) {
                if ((point - begin).norm() < nearest) {
                    nearest = (point - begin).norm();
                    parent = static_cast<int>(other);
                }
            }
        }
        rooted.parent.push_back(parent);
    }
    return rooted;
}

void addFile(std::vector<RootedTree>& trees, const std::string& path, const std::string& name)
{
    const auto tree = io::readVesselTree(path);
    if (!tree) {
        std::fprintf(stderr, "Left out: %s\n", tree.error().message.text().c_str());
    } else if (tree.value().branches.size() >= minBranches) {
        trees.push_back(rootedByTouch(tree.value(), name));
    }
}

RequestedCase fromForeign(const ForeignCase& made)
{
    RequestedCase asked;
    asked.input = made.input;
    asked.trueCamera = made.input.camera;
    asked.trueInCamera.resize(made.input.tree.branches.size());
    for (const std::size_t branch : made.filled) {
        for (const Eigen::Vector3d& point : made.input.tree.branches[branch].pointsInPatient) {
            asked.trueInCamera[branch].push_back(made.truth * point);
        }
    }
    return asked;
}

RequestedCase fromDeformed(const DeformedCase& made)
{
    const DeformedView& view = made.views.front();
    RequestedCase asked;
    asked.input.tree = made.tree;
    asked.input.target = view.target;
    asked.input.camera = view.camera;
    asked.input.initialCameraFromPatient = view.nominal;
    asked.trueCamera = view.camera;
    for (const core::VesselBranch& branch : made.deformed.branches) {
        std::vector<Eigen::Vector3d>& places = asked.trueInCamera.emplace_back();
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            places.push_back(view.truth * point);
        }
    }
    return asked;
}

}   // namespace

std::vector<RootedTree> judgingTrees(const std::string& dataFolder)
{
    const std::vector<RootedTree> patients = cerebralTrees(dataFolder + "/cerebral-artery-graphs");
    std::vector<RootedTree> trees = patients;   // no tree may follow its own part: the next tree serves as "another"
    for (const RootedTree& whole : patients) {
        int inflow = 0;
        for (std::size_t root = 0; root < whole.parent.size(); ++root) {
            if (whole.parent[root] < 0) {
                RootedTree part = partOf(whole, root, whole.name + " inflow " + std::to_string(++inflow));
                if (part.parent.size() >= minBranches) {
                    trees.push_back(std::move(part));
                }
            }
        }
    }
    addFile(trees, dataFolder + "/coronary-ccta-centerlines/lca_cl.vtp", "left coronary");
    addFile(trees, dataFolder + "/coronary-ccta-centerlines/rca_cl.vtp", "right coronary");
    addFile(trees, dataFolder + "/coronary-phantom-xa/tree/Centerlines.vtk", "coronary phantom");
    return trees;
}

std::size_t judgingKindCount()
{
    return kinds().size();
}

RequestedCase judgingCase(const std::vector<RootedTree>& trees, std::size_t tree, std::size_t kind, std::uint64_t trial)
{
    const Kind& asked = kinds()[kind];
    RequestedCase made;
    if (asked.motion) {
        const core::CounterRandom random = core::CounterRandom(47'000 + 1000 * kind).fork(100 * tree + trial);
        made = fromDeformed(makeDeformedCase(centered(trees[tree].tree), *asked.motion, {0.0}, random));
    } else {
        made = fromForeign(makeForeignCase(trees, tree, asked.scene, 10 + trial));
        made.input.cameraUncertainty = spreadOfHeader(made.input.camera);
        spoil(made.input, asked.error, trial + tree);
    }
    made.tree = trees[tree].name;
    made.kind = asked.name;
    made.isImpossible = asked.scene >= ForeignScene::OtherPatient || !hasTruth(asked.error);
    return made;
}

}   // namespace angiopose::benchmarks
