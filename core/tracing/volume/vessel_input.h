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
    std::string seriesId;   ///< series of a DICOM folder to use; empty if there is only one
    std::vector<int> labels;   ///< labels of a segmentation that are vessels; if empty, all labels are
    double unitMm = 0.0;   ///< length unit of a surface or centerlines; 0 for the unit stated in the file, else mm
    VesselTracingOptions tracing;

    bool operator==(const VesselInput&) const = default;
};

}   // namespace angiopose::core
