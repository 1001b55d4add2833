#pragma once

#include "core/simulation/simulated_case.h"

#include <vector>

namespace angiopose::core {

/// What the headers of a room tell of isocenter and table.
enum class RoomHeader {
    Siemens,   ///< both, in private tags
    Standard,   ///< both, in those of the standard
    WithoutTable,   ///< the isocenter alone
    ObjectPlane   ///< neither: (0018,1111), the plane of the object that the device assumes
};

/// Two views of one patient, one after the other, as rooms take them and write their headers.
struct RoomOptions {
    RoomHeader header = RoomHeader::Siemens;
    bool tableMoves = false;   ///< while the second view is taken: its header tells another place, and that it moved
    bool isMirrored = false;   ///< the second view, and its header says so
    double angleErrorDeg = 0.4;   ///< 1-σ of each angle of a header
    double breathingMm = 4.0;   ///< 1-σ of how far the vessels lie elsewhere on the table in the second view, per axis
};

/// The vessels lie up to 100 mm off the isocenter along each beam, as they come to when the table centres them in one
/// view after another: it travels up to 150 mm and more in between. Everything follows from the seed.
std::vector<SimulatedCase> simulateRoom(std::uint64_t seed, const RoomOptions& room, const TreeOptions& tree = {},
                                        const DsaOptions& dsa = {});

}   // namespace angiopose::core
