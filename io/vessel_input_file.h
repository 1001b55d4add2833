#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/vessel_input.h"
#include "core/tracing/volume/voxels/traced_component.h"
#include "core/vessel/vessel_tree.h"
#include "io/support/read_observer.h"

#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// A vessel tree that was read or traced, with its sources.
struct LoadedVessels {
    core::VesselInput input;   ///< input as requested, with the series ID added if a folder contains only one volume
    core::VesselTree tree;
    std::shared_ptr<const core::Volume> volume;   ///< scan, if there is one
    core::StudyIdentity identity;   ///< identity of a DICOM scan
    core::VoxelMask lumen;   ///< traced voxels; empty for centerlines
    double threshold = 0.0;   ///< lumen threshold if a scan was traced
    std::vector<core::TracedComponent> pieces;   ///< connected components available for tracing, largest first
    core::Messages warnings;
};

/// Moves the lumen out of `vessels` into a shared pointer, which it returns; null if there is no lumen.
std::shared_ptr<const core::VoxelMask> takeSharedLumen(LoadedVessels& vessels);

/// Returns the kind of vessel input in a file or folder, based on the contents. Does not read voxels: a volume counts
/// as `Volume` unless its header declares labels, even if its values later turn out to be labels.
core::Result<core::VesselInputKind> vesselInputKindOf(const std::string& path);

/// Reads centerlines, or reads and traces a segmentation, surface or volume. A volume whose values prove to be labels
/// is traced as a segmentation, with a warning. Errors name the file, the problem and the remedy. Can be canceled.
core::Result<LoadedVessels> readVessels(const std::string& path, const core::VesselInput& input,
                                        const ReadObserver& observe = {});

/// Traces a scan that was read from `path` and is already in memory, as readVessels does after reading.
core::Result<LoadedVessels> traceScan(const std::shared_ptr<const core::Volume>& scan, const std::string& path,
                                      const core::VesselInput& input, const ReadObserver& observe = {});

/// Returns the SHA-256 of a vessel input: that of the file, or that of the series in a folder (see `sha256OfSeries`).
core::Result<std::string> sha256OfVesselInput(const std::string& path, const core::VesselInput& input);

}   // namespace angiopose::io
