#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/observer.h"
#include "angiopose/vessel_tree.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace angiopose {

namespace core {
struct Volume;
}

/// Where voxels lie in the patient: voxel (i, j, k) is centred at origin + direction · (spacing ∘ (i, j, k)).
struct VolumeGeometry {
    std::array<int, 3> size{};   ///< voxels along i, j, k
    Eigen::Vector3d spacingMm = Eigen::Vector3d::Ones();
    Eigen::Vector3d originInPatient = Eigen::Vector3d::Zero();   ///< centre of voxel (0, 0, 0), LPS mm
    Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();   ///< columns: patient directions of i, j, k

    ANGIOPOSE_EXPORT std::size_t voxelCount() const;
};

/// A CT volume of 16-bit voxels, i fastest, then j, then k. Copies share the voxels, which never change.
class ANGIOPOSE_EXPORT Volume {
public:
    /// Copies the voxels. Their value (Hounsfield units for CT) is voxel · slope + intercept.
    Volume(std::span<const std::int16_t> voxels, const VolumeGeometry& geometry, double slope = 1.0,
           double intercept = 0.0);
    explicit Volume(std::shared_ptr<const core::Volume> content);

    VolumeGeometry geometry() const;
    std::span<const std::int16_t> voxels() const;   ///< lives as long as the volume
    double slope() const;
    double intercept() const;

    const std::shared_ptr<const core::Volume>& content() const { return content_; }   ///< for the library itself

private:
    std::shared_ptr<const core::Volume> content_;
};

/// From NIfTI, NRRD, MetaImage or DICOM (a slice, an enhanced file, a folder). `seriesId` chooses among several series
/// of a folder.
ANGIOPOSE_EXPORT Volume readVolume(const std::string& path, const std::string& seriesId = {},
                                   const Observer& observe = {});

/// To .nii, .nii.gz, .nrrd or .mha, by the extension.
ANGIOPOSE_EXPORT void writeVolume(const Volume& volume, const std::string& path);

/// Which pieces are traced where there is no seed. Usual: all of a mask, of a scan that of the great vessel; All of a
/// scan: those of every great vessel.
enum class TracedPieces { Usual, All, Largest };

/// What becomes of vessels that run in a circle: opened at their thinnest places, or kept where they are no flaw.
enum class VesselLoops { Opened, Kept };

/// One set of defaults for every scan; places are patient LPS mm.
struct VesselTracingOptions {
    std::optional<double> threshold;   ///< the lumen begins at this value (HU for CT); not set: found from the blood
    std::vector<Eigen::Vector3d> seedsInPatient;   ///< only vessels connected to one; none: the great vessel found
    std::vector<Eigen::Vector3d> avoidInPatient;   ///< places in what is no vessel: heart, vein, bone
    std::optional<Eigen::Vector3d> rootInPatient;   ///< the end nearest to it is the root; not set: the thickest
    double minBranchLengthMm = 4.0;   ///< branches that leave their parent's wall by less are removed
    double minBranchRadiusMm = 0.0;   ///< branches that are thinner on average are removed
    double pointSpacingMm = 1.0;   ///< along the branches
    bool tubesOnly = false;   ///< thin vessels alone, from the seeds: chambers, organs and wide vessels end them
    int threads = 0;   ///< 0: as many as the processor has; the result is the same for any number
    TracedPieces pieces = TracedPieces::Usual;
    VesselLoops loops = VesselLoops::Opened;
};

/// A vessel tree with what was seen on the way to it.
struct TracedVessels {
    VesselTree tree;   ///< piece by piece, root first, then by generation; ids 1, 2, …; radii
    VolumeGeometry lumenGeometry;
    std::vector<std::uint8_t> lumen;   ///< voxels that were traced, not 0; i fastest; empty where nothing was traced
    double threshold = 0.0;   ///< the value at which the lumen begins; 0.5 for masks
    std::vector<Message> warnings;   ///< pieces that were left out, loops that were opened, …
};

/// Contrast-filled vessels of a CT angiogram.
ANGIOPOSE_EXPORT TracedVessels traceVessels(const Volume& volume, const VesselTracingOptions& options = {},
                                            const Observer& observe = {});

/// The vessels of a mask (not 0: lumen; i fastest), taken as it is: all its pieces, or those that hold the
/// seeds.
ANGIOPOSE_EXPORT TracedVessels traceMask(std::span<const std::uint8_t> mask, const VolumeGeometry& geometry,
                                         const VesselTracingOptions& options = {}, const Observer& observe = {});

/// How the vessels of a file are read.
struct VesselReadOptions {
    std::vector<int> labels;   ///< of a label image: those that are vessels; none: all
    std::string seriesId;   ///< of a DICOM folder with several series
    double unitMm = 0.0;   ///< of a surface or centrelines: the length of one unit; 0: as the file states, else mm
    VesselTracingOptions tracing;
};

/// Vessels from any file that shows some: centrelines are read; scans, label images and surfaces are traced.
ANGIOPOSE_EXPORT TracedVessels readVessels(const std::string& path, const VesselReadOptions& options = {},
                                           const Observer& observe = {});

}   // namespace angiopose
