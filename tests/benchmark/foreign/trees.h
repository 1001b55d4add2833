#pragma once

#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Draws that owe nothing to the project's simulator: the raw bits of the standard's Mersenne twister.
class ForeignRandom {
public:
    explicit ForeignRandom(std::uint64_t seed) : bits_(seed) {}

    double uniform(double low = 0.0, double high = 1.0);   ///< in [low, high)
    double normal();
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))); }
    Eigen::Vector3d direction();   ///< unit

private:
    std::mt19937_64 bits_;
};

/// A tree that knows which way the blood flows.
struct RootedTree {
    std::string name;
    core::VesselTree tree;   ///< every branch from one node to the next
    std::vector<int> parent;   ///< index of the branch that feeds each; −1 where blood flows in

    /// The branches fed through one, itself among them; indices ascend.
    std::vector<std::size_t> fedThrough(std::size_t branch) const;
    double lengthMm(const std::vector<std::size_t>& branches) const;
    bool isLeaf(std::size_t branch) const;
};

/// The judging family: cerebral arteries of patients, read from their graphs under `folder` (PROVENANCE.txt there).
/// The graphs hold straight chords; every edge is bowed at random until it is as long as recorded. Voxels of 0.4 mm.
std::vector<RootedTree> cerebralTrees(const std::string& folder);

/// The developing family: trees that split in two again and again, bowed at random.
std::vector<RootedTree> forkedTrees(std::size_t count);

/// "real": the cerebral trees, else ten made-up ones. None, and says so, where the graphs are not there.
std::vector<RootedTree> treesOfFamily(const std::string& family);

}   // namespace angiopose::benchmarks
