#pragma once

#include "core/simulation/simulated_case.h"

#include <vector>

namespace angiopose::core {

/// Information that the headers of an angiography room contain about the isocenter and the table position.
enum class RoomHeader {
    Siemens,   ///< isocenter and table position, in private tags
    Standard,   ///< isocenter and table position, in standard tags
    WithoutTable,   ///< isocenter only
    ObjectPlane   ///< neither; instead the object plane assumed by the imaging system, (0018,1111)
};

/// Two consecutive views of one patient, with geometry and headers as in an angiography room.
struct RoomOptions {
    RoomHeader header = RoomHeader::Siemens;
    bool tableMoves = false;   ///< whether it moves during the second view, whose header then gives a wrong position
    bool isMirrored = false;   ///< whether the second view is mirrored, as its header states
    double angleErrorDeg = 0.4;   ///< standard deviation of each angle in a header
    double breathingMm = 4.0;   ///< 1-σ per axis of the vessels' shift relative to the table in the second view
};

/// Simulates views with the vessels up to 100 mm off the isocenter along each beam, as happens when the table centers
/// them in one view after another and travels 150 mm or more in between. The seed determines everything.
std::vector<SimulatedCase> simulateRoom(std::uint64_t seed, const RoomOptions& room, const TreeOptions& tree = {},
                                        const DsaOptions& dsa = {});

}   // namespace angiopose::core
