#pragma once

#include "core/tracing/volume/voxels/tracing_options.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// What the vessel tree of a case comes from (FORMATS §2).
enum class VesselInputKind { Centerline, Segmentation, Surface, Volume };

/// How the vessel tree of a case is made from its file; centrelines are taken as they are.
struct VesselInput {
    VesselInputKind kind = VesselInputKind::Centerline;
    std::string seriesId;   ///< of a volume in a DICOM folder: which series; empty: the only one
    std::vector<int> labels;   ///< of a segmentation: the labels that are vessels; empty: all
    double unitMm = 0.0;   ///< of a surface or centrelines: length of one unit; 0: as the file states, else mm
    VesselTracingOptions tracing;

    bool operator==(const VesselInput&) const = default;
};

}   // namespace angiopose::core