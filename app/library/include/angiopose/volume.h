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

/// Position of the voxels in the patient: the center of voxel (i, j, k) is origin + direction · (spacing ∘ (i, j, k)).
struct VolumeGeometry {
    std::array<int, 3> size{};   ///< numbers of voxels along i, j, k
    Eigen::Vector3d spacingMm = Eigen::Vector3d::Ones();
    Eigen::Vector3d originInPatient = Eigen::Vector3d::Zero();   ///< center of voxel (0, 0, 0), LPS, mm
    Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();   ///< columns: directions of i, j, k in the patient

    ANGIOPOSE_EXPORT std::size_t voxelCount() const;
};

/// CT volume with 16-bit voxels; i varies fastest, then j, then k. Copies share the voxels, which are immutable.
class ANGIOPOSE_EXPORT Volume {
public:
    /// Copies the voxels. The value of a voxel (HU for CT) is voxel · slope + intercept.
    Volume(std::span<const std::int16_t> voxels, const VolumeGeometry& geometry, double slope = 1.0,
           double intercept = 0.0);
    explicit Volume(std::shared_ptr<const core::Volume> content);

    VolumeGeometry geometry() const;
    std::span<const std::int16_t> voxels() const;   ///< valid as long as the volume exists
    double slope() const;
    double intercept() const;

    const std::shared_ptr<const core::Volume>& content() const { return content_; }   ///< internal use

private:
    std::shared_ptr<const core::Volume> content_;
};

/// Reads NIfTI, NRRD, MetaImage or DICOM (a single slice, an enhanced multi-frame file or a folder). `seriesId` selects
/// one of several series in a folder.
ANGIOPOSE_EXPORT Volume readVolume(const std::string& path, const std::string& seriesId = {},
                                   const Observer& observe = {});

/// Writes .nii, .nii.gz, .nrrd or .mha, depending on the extension.
ANGIOPOSE_EXPORT void writeVolume(const Volume& volume, const std::string& path);

/// Connected components to trace if there are no seeds. Usual: all components of a mask, or in a scan, the component of
/// the main great vessel. All: in a scan, the components of every great vessel.
enum class TracedPieces { Usual, All, Largest };

/// Treatment of vessel loops: cut at the narrowest point, or kept if they are real.
enum class VesselLoops { Opened, Kept };

/// Options of 3-D tracing. The defaults are the same for every scan; points are LPS, mm.
struct VesselTracingOptions {
    std::optional<double>
        threshold;   ///< lower threshold of the lumen (HU for CT); if not set, derived from the opacified lumen
    std::vector<Eigen::Vector3d>
        seedsInPatient;   ///< keep only vessels connected to a seed; if empty, use the detected great vessel
    std::vector<Eigen::Vector3d> avoidInPatient;   ///< points outside the vessels of interest: heart, vein, bone
    std::optional<Eigen::Vector3d>
        rootInPatient;   ///< the end nearest to this point becomes the root; if not set, the widest end
    double minBranchLengthMm = 4.0;   ///< branches that extend less than this beyond their parent's wall are removed
    double minBranchRadiusMm = 0.0;   ///< branches with a mean radius below this are removed
    double pointSpacingMm = 1.0;   ///< spacing of the points along the branches
    bool tubesOnly = false;   ///< trace only thin vessels from the seeds, up to chambers, soft tissue and wide vessels
    int threads = 0;   ///< if 0, one per processor core; the result does not depend on this number
    TracedPieces pieces = TracedPieces::Usual;
    VesselLoops loops = VesselLoops::Opened;
};

/// Traced vessel tree, with the lumen and the warnings of the tracing.
struct TracedVessels {
    VesselTree tree;   ///< branches ordered by component, from the root by generation; IDs 1, 2, …; with radii
    VolumeGeometry lumenGeometry;
    std::vector<std::uint8_t> lumen;   ///< traced voxels are nonzero, i varies fastest; empty if nothing was traced
    double threshold = 0.0;   ///< lower threshold of the lumen; 0.5 for masks
    std::vector<Message> warnings;   ///< e.g. that components were left out or loops were cut
};

/// Traces the contrast-enhanced vessels of a CT angiogram.
ANGIOPOSE_EXPORT TracedVessels traceVessels(const Volume& volume, const VesselTracingOptions& options = {},
                                            const Observer& observe = {});

/// Traces the vessels of a mask (nonzero: lumen; i varies fastest), which is used unaltered: all its components, or
/// those that contain seeds.
ANGIOPOSE_EXPORT TracedVessels traceMask(std::span<const std::uint8_t> mask, const VolumeGeometry& geometry,
                                         const VesselTracingOptions& options = {}, const Observer& observe = {});

/// Options for reading vessels from a file.
struct VesselReadOptions {
    std::vector<int> labels;   ///< labels of the vessels in a label image; if empty, all labels
    std::string seriesId;   ///< selects one of several series in a DICOM folder
    double unitMm = 0.0;   ///< length of one unit of a surface or centerline file, mm; 0: as stated, otherwise 1 mm
    VesselTracingOptions tracing;
};

/// Reads vessels from any supported file: centerlines are read; scans, label images and surfaces are traced.
ANGIOPOSE_EXPORT TracedVessels readVessels(const std::string& path, const VesselReadOptions& options = {},
                                           const Observer& observe = {});

}   // namespace angiopose
