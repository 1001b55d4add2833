#pragma once

#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// How many cerebral arteries of patients there are (PROVENANCE.txt beside them).
inline constexpr int arteryGraphCount = 5;

/// Bifurcations and ends of the traced arteries of one patient, and the vessels between them. Lengths in voxels, whose
/// size is not recorded.
struct ArteryGraph {
    using Row = std::vector<double>;

    std::string name;
    std::vector<Row> nodes;   ///< id, x, y, z, radius, label; ids count from 0 without gaps
    std::vector<Row> edges;   ///< id, id, length, mean radius
};

/// The graph of a patient (1…arteryGraphCount); without edges where the data are not there.
ArteryGraph readArteryGraph(const std::string& folder, int patient);

}   // namespace angiopose::benchmarks
