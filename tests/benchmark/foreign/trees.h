#pragma once

#include "core/vessel/vessel_tree.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Random numbers independent of the project's simulator: the raw bits of the standard's Mersenne twister.
class ForeignRandom {
public:
    explicit ForeignRandom(std::uint64_t seed) : bits_(seed) {}

    double uniform(double low = 0.0, double high = 1.0);   ///< in [low, high)
    double normal();
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))); }
    Eigen::Vector3d direction();   ///< unit vector

private:
    std::mt19937_64 bits_;
};

/// A tree with the direction of blood flow.
struct RootedTree {
    std::string name;
    core::VesselTree tree;   ///< every branch runs from one node to the next
    std::vector<int> parent;   ///< index of the branch that feeds each; −1 at an inflow

    /// The branches fed through a branch, including itself, with ascending indices.
    std::vector<std::size_t> fedThrough(std::size_t branch) const;
    double lengthMm(const std::vector<std::size_t>& branches) const;
    bool isLeaf(std::size_t branch) const;
};

/// The test set: cerebral arteries of patients, read from their graphs under `folder` (PROVENANCE.txt there). The
/// graphs contain straight chords; every edge is bowed at random until it has the recorded length. Voxels of 0.4 mm.
std::vector<RootedTree> cerebralTrees(const std::string& folder);

/// The development set: randomly bowed trees that bifurcate repeatedly.
std::vector<RootedTree> forkedTrees(std::size_t count);

/// "real": the cerebral trees, otherwise ten artificial ones. If the graphs are missing, reports this and returns none.
std::vector<RootedTree> treesOfFamily(const std::string& family);

}   // namespace angiopose::benchmarks
