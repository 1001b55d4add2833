#include "tests/benchmark/label_masks.h"

#include "core/imaging/fill_surface.h"
#include "core/simulation/simulated_case.h"
#include "core/support/random.h"
#include "io/surface_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/benchmark/artery_graph.h"
#include "tests/support/for_each.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace angiopose::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr int marginVoxels = 4;
constexpr double graphVoxelMm = 0.45;   // not recorded with the graphs
constexpr double gapMm = 3.0;

template <class IsSet>
core::VoxelMask maskOf(const core::LabelVolume& labels, const IsSet& isSet)
{
    core::VoxelMask mask(labels.geometry);
    std::transform(labels.voxels.begin(), labels.voxels.end(), mask.voxels.begin(),
                   [&](std::uint16_t label) { return static_cast<std::uint8_t>(isSet(label) ? 1 : 0); });
    return mask;
}

bool isEmpty(const core::VoxelMask& mask)
{
    return std::ranges::none_of(mask.voxels, [](std::uint8_t voxel) { return voxel != 0; });
}

void addMasksIn(const std::string& folder, std::vector<NamedMask>& all)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(test::dataFile(folder))) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        const bool isLabel = name.ends_with(".nii.gz") && name.find("ct_") == std::string::npos &&
                             name.find("vertebrae") == std::string::npos;
        const auto labels = isLabel ? io::readLabels(file.string()) : core::Error(core::Message::verbatim(""));
        if (labels) {
            core::VoxelMask mask = maskOf(labels.value(), [](std::uint16_t label) { return label != 0; });
            if (!isEmpty(mask)) {
                all.push_back({name.substr(0, name.find('.')), std::move(mask)});
            }
        }
    }
}

/// Adds the segmented vessels of an abdomen: the aorta, the inferior vena cava, portal and splenic veins.
void addAbdominalLabels(std::vector<NamedMask>& all)
{
    const auto labels = io::readLabels(test::dataFile("abdomen-ct/example_seg.nii.gz").string());
    if (!labels) {
        return;
    }
    for (const int label : {52, 63, 64}) {
        all.push_back({"abdomen, label " + std::to_string(label),
                       maskOf(labels.value(), [label](std::uint16_t each) { return each == label; })});
    }
    all.push_back({"abdomen, all three vessels",
                   maskOf(labels.value(), [](std::uint16_t each) { return each == 52 || each == 63 || each == 64; })});
}

void addSurfaces(std::vector<NamedMask>& all)
{
    const std::vector<std::pair<const char*, double>> surfaces{
        {"abdominal-aorta-mesh/demo.vtp", 10.0},
        {"abdominal-aorta-mesh/seqseg_6.vtp", 10.0},
        {"abdominal-aorta-mesh/shawn_260.vtp", 10.0},
        {"coronary-phantom-xa/tree/Proposed_TRI3_coarse.stl", 1.0}};
    for (const auto& [file, unitMm] : surfaces) {
        const auto surface = io::readSurface(test::dataFile(file).string(), unitMm);
        const auto mask = surface
                              ? core::fillSurface(surface.value().mesh, core::defaultSpacingMm(surface.value().mesh))
                              : core::Result<core::VoxelMask>(surface.error());
        if (mask) {
            all.push_back({fs::path(file).filename().string(), mask.value()});
        }
    }
}

/// The chords of the graph with the recorded widths, including all components and loops.
core::VesselTree cerebralTree(const ArteryGraph& graph)
{
    std::map<int, Eigen::Vector3d> nodes;
    for (const ArteryGraph::Row& row : graph.nodes) {
        nodes[static_cast<int>(row[0])] = graphVoxelMm * Eigen::Vector3d(row[1], row[2], row[3]);
    }
    core::VesselTree tree;
    for (const ArteryGraph::Row& row : graph.edges) {
        core::VesselBranch branch;
        branch.id = static_cast<int>(tree.branches.size()) + 1;
        branch.pointsInPatient = {nodes[static_cast<int>(row[0])], nodes[static_cast<int>(row[1])]};
        branch.radiusMm.assign(2, std::max(0.5, 0.5 * graphVoxelMm * row[3]));
        if (branch.lengthMm() > 0.0) {
            tree.branches.push_back(std::move(branch));
        }
    }
    return tree;
}

core::VesselTree treeIn(const std::string& file)
{
    const auto tree = io::readVesselTree(test::dataFile(file).string());
    return tree ? tree.value() : core::VesselTree();
}

core::VesselTree together(const std::vector<core::VesselTree>& trees)
{
    core::VesselTree all;
    for (const core::VesselTree& tree : trees) {
        for (core::VesselBranch branch : tree.branches) {
            branch.id = static_cast<int>(all.branches.size()) + 1;
            all.branches.push_back(std::move(branch));
        }
    }
    return all;
}

core::VesselTree movedBy(core::VesselTree tree, const Eigen::Vector3d& shiftMm)
{
    for (core::VesselBranch& branch : tree.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += shiftMm;
        }
    }
    return tree;
}

/// Removes a segment from the middle of every longer branch.
core::VesselTree inPieces(const core::VesselTree& tree, double withoutMm)
{
    core::VesselTree cut;
    for (const core::VesselBranch& branch : core::resampled(tree, 0.5).branches) {
        const std::size_t count = branch.pointsInPatient.size();
        const auto half = static_cast<std::size_t>(withoutMm);   // points, 0.5 mm apart, on each side
        const std::size_t middle = count / 2;
        const bool isCut = branch.lengthMm() > 30.0 && branch.id % 3 == 0;
        const auto take = [&](std::size_t from, std::size_t to) {
            core::VesselBranch part;
            part.id = static_cast<int>(cut.branches.size()) + 1;
            const auto first = static_cast<std::ptrdiff_t>(from);
            const auto last = static_cast<std::ptrdiff_t>(to);
            part.pointsInPatient.assign(branch.pointsInPatient.begin() + first, branch.pointsInPatient.begin() + last);
            part.radiusMm.assign(branch.radiusMm.begin() + first, branch.radiusMm.begin() + last);
            cut.branches.push_back(std::move(part));
        };
        if (isCut) {
            take(0, middle - half);
            take(middle + half, count);
        } else {
            take(0, count);
        }
    }
    return cut;
}

/// The middle third of the mask along its longest axis.
core::VoxelMask croppedMiddle(const core::VoxelMask& mask)
{
    const Eigen::Vector3i& size = mask.geometry.size;
    int axis = 0;
    size.maxCoeff(&axis);
    core::VolumeGeometry grid = mask.geometry;
    Eigen::Vector3i low = Eigen::Vector3i::Zero();
    low[axis] = size[axis] / 3;
    grid.size[axis] = size[axis] / 3;
    grid.originInPatient = mask.geometry.patientFromVoxel() * low.cast<double>();
    core::VoxelMask part(grid);
    test::forEachVoxel(grid.size,
                       [&](int i, int j, int k) { part.at(i, j, k) = mask.at(i + low.x(), j + low.y(), k + low.z()); });
    return part;
}

}   // namespace

core::VoxelMask drawnVessels(const core::VesselTree& tree, double voxelMm)
{
    Eigen::AlignedBox3d box;
    double widest = voxelMm;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
        for (const double radius : branch.radiusMm) {
            widest = std::max(widest, radius);
        }
    }
    core::VolumeGeometry grid;
    grid.spacingMm = Eigen::Vector3d::Constant(voxelMm);
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(widest + marginVoxels * voxelMm);
    grid.originInPatient = box.min() - around;
    grid.size = ((box.max() - box.min() + 2.0 * around) / voxelMm).array().ceil().cast<int>();
    core::VoxelMask mask(grid);
    for (const core::VesselBranch& branch : core::resampled(tree, 0.5 * voxelMm).branches) {
        for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
            const Eigen::Vector3d center = (branch.pointsInPatient[n] - grid.originInPatient) / voxelMm;
            const double radius = (branch.radiusMm.empty() ? 1.0 : branch.radiusMm[n]) / voxelMm;
            const Eigen::Vector3i low = (center.array() - radius).ceil().cast<int>();
            const Eigen::Vector3i high = (center.array() + radius).floor().cast<int>();
            test::forEachVoxel(low, high + Eigen::Vector3i::Ones(), [&](int i, int j, int k) {
                if ((Eigen::Vector3d(i, j, k) - center).norm() <= radius) {
                    mask.at(i, j, k) = 1;
                }
            });
        }
    }
    return mask;
}

std::vector<NamedMask> givenMasks()
{
    std::vector<NamedMask> all;
    addMasksIn("thoracic-aorta-cta", all);
    addAbdominalLabels(all);
    addSurfaces(all);
    return all;
}

std::vector<NamedMask> masksOfPatients()
{
    std::vector<NamedMask> all;
    for (int patient = 1; patient <= arteryGraphCount; ++patient) {
        const ArteryGraph graph = readArteryGraph(test::dataFile("cerebral-artery-graphs").string(), patient);
        if (!graph.edges.empty()) {
            const core::VesselTree tree = cerebralTree(graph);
            all.push_back({"cerebral " + graph.name + ", 0.5 mm", drawnVessels(tree, 0.5)});
            all.push_back({"cerebral " + graph.name + ", 0.8 mm", drawnVessels(tree, 0.8)});
        }
    }
    const core::VesselTree left = treeIn("coronary-ccta-centerlines/lca_cl.vtp");
    const core::VesselTree right = treeIn("coronary-ccta-centerlines/rca_cl.vtp");
    const core::VesselTree aorta = treeIn("coronary-ccta-centerlines/ao_cl.vtp");
    if (!left.branches.empty() && !right.branches.empty()) {
        all.push_back({"both coronaries", drawnVessels(together({left, right}), 0.5)});
        all.push_back({"both coronaries in pieces", drawnVessels(inPieces(together({left, right}), gapMm), 0.5)});
        all.push_back({"both coronaries and aorta", drawnVessels(together({left, right, aorta}), 0.7)});
    }
    return all;
}

std::vector<NamedMask> grownMasks(int count)
{
    std::vector<NamedMask> all;
    for (int n = 0; n < count; ++n) {
        const auto seed = static_cast<std::uint64_t>(300 + n);
        const core::VesselTree one = core::simulateTree(seed, {.branchCount = 16, .extentMm = 120.0});
        const core::VesselTree other = core::simulateTree(seed + 50, {.branchCount = 10, .extentMm = 90.0});
        const std::string number = std::to_string(n + 1);
        all.push_back({"grown " + number, drawnVessels(one, 0.7)});
        all.push_back(
            {"grown " + number + ", two", drawnVessels(together({one, movedBy(other, {130.0, 0.0, 0.0})}), 0.7)});
        all.push_back({"grown " + number + ", in pieces", drawnVessels(inPieces(one, gapMm), 0.7)});
        all.push_back({"grown " + number + ", cropped", croppedMiddle(drawnVessels(one, 0.7))});
    }
    return all;
}

}   // namespace angiopose::benchmarks
