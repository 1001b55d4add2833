#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "core/tracing/volume/vessel_input.h"
#include "core/tracing/volume/voxels/traced_piece.h"
#include "core/vessel/vessel_tree.h"
#include "io/support/read_observer.h"

#include <memory>
#include <string>
#include <vector>

namespace angiopose::io {

/// A vessel tree, read or traced, with what it came from.
struct LoadedVessels {
    core::VesselInput input;   ///< as asked for; the series id filled in where a folder had one volume only
    core::VesselTree tree;
    std::shared_ptr<const core::Volume> volume;   ///< the scan, when there was one
    core::StudyIdentity identity;   ///< of a DICOM scan
    core::VoxelMask lumen;   ///< what was traced; empty for centrelines
    double threshold = 0.0;   ///< where the lumen begins, when a scan was traced
    std::vector<core::TracedPiece> pieces;   ///< of what could be traced, the largest first
    core::Messages warnings;
};

/// The lumen for keeping, moved out of `vessels`; null where there is none.
std::shared_ptr<const core::VoxelMask> sharedLumen(LoadedVessels& vessels);

/// What a file or folder offers as vessel input: told by content; a label image by its values, so the voxels are not
/// read for it: volumes count as `Volume` unless the header calls them labels.
core::Result<core::VesselInputKind> vesselInputKindOf(const std::string& path);

/// Reads centrelines, or reads a segmentation, surface or volume and traces it. A volume whose values turn out to be
/// labels is traced as a segmentation, with a warning. Fails with file, problem and remedy, or when stopped.
core::Result<LoadedVessels> readVessels(const std::string& path, const core::VesselInput& input,
                                        const ReadObserver& observe = {});

/// Traces a scan that is in memory and was read from `path`: what readVessels does with it once it is read.
core::Result<LoadedVessels> traceScan(const std::shared_ptr<const core::Volume>& scan, const std::string& path,
                                      const core::VesselInput& input, const ReadObserver& observe = {});

/// SHA-256 of a vessel input: of the file, or of the series in a folder (see `sha256OfSeries`).
core::Result<std::string> sha256OfVesselInput(const std::string& path, const core::VesselInput& input);

}   // namespace angiopose::io