#include "io/dicom/objects/vessel_segmentation.h"

#include "io/dicom/functional_groups.h"
#include "io/dicom/new_uid.h"
#include "io/dicom/objects/coded_term.h"
#include "io/dicom/objects/lab_color.h"
#include "io/messages/messages.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr ObjectKind segmentationKind{"1.2.840.10008.5.1.4.1.1.66.4", "SEG", "segmentation",
                                      "AngioPose vessels in the scan", 9006};
constexpr CodedTerm anatomicalStructure{"123037004", "SCT", "Anatomical Structure"};
constexpr CodedTerm artery{"51114001", "SCT", "Artery"};
constexpr RgbColor arteryColor{216, 101, 79};
constexpr double samePlaceMm = 0.01;
constexpr DicomTag segmentNumberPointer = 0x0062000b;
constexpr DicomTag segmentGroup = 0x0062000a;
constexpr DicomTag positionPointer = 0x00200032;
constexpr DicomTag positionGroup = 0x00209113;

std::vector<double> listed(const Eigen::Vector3d& vector)
{
    return {vector.x(), vector.y(), vector.z()};
}

Eigen::Vector3d cornerOf(const core::VolumeGeometry& grid, int plane)
{
    return grid.originInPatient + plane * grid.spacingMm.z() * grid.direction.col(2);
}

/// Packs voxels into one bit each, lowest bit first, without padding between frames (PS3.5 8.1.1).
std::string packedBits(const std::vector<std::uint8_t>& voxels)
{
    std::string bits((voxels.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (voxels[i] != 0) {
            bits[i / 8] = static_cast<char>(static_cast<unsigned char>(bits[i / 8]) | 1U << (i % 8));
        }
    }
    return bits;
}

void addSegmentPixels(DicomItem& root, const core::VolumeGeometry& grid)
{
    root.text(0x00080008, "CS", "DERIVED\\PRIMARY");
    root.text(0x00280008, "IS", std::to_string(grid.size.z()));
    root.setUnsignedShort(0x00280002, 1);
    root.text(0x00280004, "CS", "MONOCHROME2");
    root.setUnsignedShort(0x00280010, grid.size.y());
    root.setUnsignedShort(0x00280011, grid.size.x());
    root.setUnsignedShort(0x00280100, 1);
    root.setUnsignedShort(0x00280101, 1);
    root.setUnsignedShort(0x00280102, 0);
    root.setUnsignedShort(0x00280103, 0);
    root.text(0x00282110, "CS", "00");
    root.text(0x00620001, "CS", "BINARY");
    root.text(0x00620013, "CS", "NO");
}

void addSegment(DicomItem& root, const std::string& algorithm)
{
    DicomItem segment = root.addItem(0x00620002);
    addTerm(segment, 0x00620003, anatomicalStructure);
    segment.setUnsignedShort(0x00620004, 1);
    segment.text(0x00620005, "LO", "Arteries");
    segment.text(0x00620006, "ST", truncateUtf8(algorithm, 1024));
    segment.text(0x00620008, "CS", "SEMIAUTOMATIC");
    segment.text(0x00620009, "LO", "AngioPose " ANGIOPOSE_VERSION);
    segment.setUnsignedShorts(0x0062000d, labColor(arteryColor));
    addTerm(segment, 0x0062000f, artery);
}

/// Adds the dimensions that distinguish frames: segment and position.
void addDimensions(DicomItem& root, const std::string& organizationUid)
{
    root.addItem(0x00209221).text(0x00209164, "UI", organizationUid);
    const auto addIndex = [&](DicomTag pointer, DicomTag group) {
        DicomItem index = root.addItem(0x00209222);
        index.text(0x00209164, "UI", organizationUid);
        index.setAttributeTag(0x00209165, pointer);
        index.setAttributeTag(0x00209167, group);
    };
    addIndex(segmentNumberPointer, segmentGroup);
    addIndex(positionPointer, positionGroup);
}

void addSharedGroups(DicomItem& root, const core::VolumeGeometry& grid)
{
    DicomItem shared = root.addItem(sharedGroupsTag);
    DicomItem measures = shared.addItem(0x00289110);
    measures.setDecimals(0x00180050, {grid.spacingMm.z()});
    measures.setDecimals(0x00180088, {grid.spacingMm.z()});
    measures.setDecimals(0x00280030, {grid.spacingMm.y(), grid.spacingMm.x()});
    std::vector<double> directions = listed(grid.direction.col(0));
    const std::vector<double> down = listed(grid.direction.col(1));
    directions.insert(directions.end(), down.begin(), down.end());
    shared.addItem(0x00209116).setDecimals(0x00200037, directions);
}

const ScanReference::Slice* sliceAt(const ScanReference& scan, const Eigen::Vector3d& corner)
{
    const auto isThere = [&corner](const ScanReference::Slice& slice) {
        return (slice.position - corner).norm() < samePlaceMm;
    };
    const auto found = std::ranges::find_if(scan.slices, isThere);
    return found == scan.slices.end() ? nullptr : &*found;
}

void addDerivedFromSlice(DicomItem& frame, const ScanReference& scan, const ScanReference::Slice& slice)
{
    DicomItem derived = frame.addItem(0x00089124);
    DicomItem image = addReference(derived, 0x00082112, scan.source.sopClassUid, slice.sopInstanceUid);
    if (slice.isOneOfMany) {
        image.text(0x00081160, "IS", std::to_string(slice.frame + 1));
    }
    image.text(0x0028135a, "CS", "YES");
    addTerm(image, 0x0040a170, sourceImageForProcessing);
    addTerm(derived, 0x00089215, segmentationDerivation);
}

/// Adds the frames; returns the UIDs of the referenced instances in frame order, without duplicates.
std::vector<std::string> addFrames(DicomItem& root, const core::VolumeGeometry& grid, const ScanReference& scan)
{
    std::vector<std::string> referred;
    for (int plane = 0; plane < grid.size.z(); ++plane) {
        const Eigen::Vector3d corner = cornerOf(grid, plane);
        DicomItem frame = root.addItem(perFrameGroupsTag);
        frame.addItem(0x00209111).setUnsignedLongs(0x00209157, {1, static_cast<std::uint32_t>(plane + 1)});
        frame.addItem(positionGroup).setDecimals(positionPointer, listed(corner));
        frame.addItem(segmentGroup).setUnsignedShort(segmentNumberPointer, 1);
        const ScanReference::Slice* const slice = sliceAt(scan, corner);
        if (slice != nullptr && scan.source.isReferenceable()) {
            addDerivedFromSlice(frame, scan, *slice);
            if (std::ranges::find(referred, slice->sopInstanceUid) == referred.end()) {
                referred.push_back(slice->sopInstanceUid);
            }
        }
    }
    return referred;
}

void addReferredInstances(DicomItem& root, const ScanReference& scan, const std::vector<std::string>& referred)
{
    if (referred.empty()) {
        return;
    }
    DicomItem series = root.addItem(0x00081115);
    series.text(0x0020000e, "UI", scan.source.seriesUid);
    for (const std::string& uid : referred) {
        addReference(series, 0x0008114a, scan.source.sopClassUid, uid);
    }
}

}   // namespace

std::string scanFrameOfReference(const SourceImage& scan, const std::string& fallback)
{
    return scan.frameOfReferenceUid.empty() ? uidFromContent("scan " + fallback) : scan.frameOfReferenceUid;
}

core::Result<std::string> encodeVesselSegmentation(const core::VoxelMask& vessels, const std::string& algorithm,
                                                   const ScanReference& scan, const ObjectOrigin& origin)
{
    if (std::ranges::none_of(vessels.voxels, [](std::uint8_t voxel) { return voxel != 0; })) {
        return core::Error(messages::objectNoVoxels());
    }
    const core::VolumeGeometry& grid = vessels.geometry;
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, segmentationKind, scan.source, origin);
    addContentIdentification(root, "VESSELS", "Vessels of the scan", origin);
    addContentTime(root, origin);
    root.text(0x00200020, "CS", "");
    root.text(0x00200052, "UI", scanFrameOfReference(scan.source, origin.uidFor("scan")));
    root.text(0x00201040, "LO", "");
    addSegmentPixels(root, grid);
    addSegment(root, algorithm);
    addDimensions(root, origin.uidFor("dimensions of segmentation"));
    addSharedGroups(root, grid);
    addReferredInstances(root, scan, addFrames(root, grid, scan));
    root.bytes(0x7fe00010, packedBits(vessels.voxels));
    return object.content();
}

}   // namespace angiopose::io
