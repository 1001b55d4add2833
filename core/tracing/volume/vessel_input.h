#pragma once

#include "core/tracing/volume/voxels/tracing_options.h"

#include <string>
#include <vector>

namespace angiopose::core {

/// Source of a case's vessel tree (FORMATS §2).
enum class VesselInputKind { Centerline, Segmentation, Surface, Volume };

/// Source and options from which the vessel tree of a case is created; centerlines are used unchanged.
struct VesselInput {
    VesselInputKind kind = VesselInputKind::Centerline;
    std::string seriesId;   ///< volume in a DICOM folder: series to use; empty: the only one
    std::vector<int> labels;   ///< segmentation: labels that are vessels; empty: all
    double unitMm = 0.0;   ///< surface or centerlines: length of one unit; 0: as stated in the file, else mm
    VesselTracingOptions tracing;

    bool operator==(const VesselInput&) const = default;
};

}   // namespace angiopose::core