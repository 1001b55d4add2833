#pragma once

#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Number of patients with cerebral artery graphs (PROVENANCE.txt next to the data).
inline constexpr int arteryGraphCount = 5;

/// Bifurcations and endpoints of the traced arteries of one patient, and the vessels between them. Lengths in voxels;
/// the voxel size is not recorded.
struct ArteryGraph {
    using Row = std::vector<double>;

    std::string name;
    std::vector<Row> nodes;   ///< id, x, y, z, radius, label; ids count from 0 without gaps
    std::vector<Row> edges;   ///< id, id, length, mean radius
};

/// Reads the graph of a patient (1…arteryGraphCount); without edges if the data are missing.
ArteryGraph readArteryGraph(const std::string& folder, int patient);

}   // namespace angiopose::benchmarks
