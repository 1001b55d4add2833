#include "io/series/dicom_segmentation.h"

#include "core/imaging/volume.h"
#include "core/support/result.h"
#include "io/dicom/dicom_dataset.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/frame_source.h"
#include "io/dicom/functional_groups.h"
#include "io/messages/messages.h"
#include "io/series/slice_record.h"
#include "io/series/slice_stack.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace angiopose::io {
namespace {

/// Grid that contains the frames of a segmentation. Several frames may share a layer; layers without a frame are empty.
struct SegmentationGrid {
    core::VolumeGeometry geometry;
    std::vector<int> layers;   ///< layer index of each frame
};

constexpr std::size_t maxGridVoxels = std::size_t{1} << 31;
constexpr double placeTolerance = 0.1;   // maximum deviation from the grid, as a fraction of a voxel

bool isPlaced(const SliceRecord& frame, const SliceRecord& first)
{
    return frame.position && frame.axes && frame.size == first.size && !frame.spacingMm.isZero() &&
           (*frame.axes - *first.axes).cwiseAbs().maxCoeff() < 5e-3;
}

/// Returns the smallest spacing of frames, refined over the whole stack; 0 if all frames lie in one plane.
double stepBetween(std::vector<double> depths)
{
    std::sort(depths.begin(), depths.end());
    double smallest = 0.0;
    for (std::size_t i = 1; i < depths.size(); ++i) {
        const double step = depths[i] - depths[i - 1];
        if (step > 1e-3 && (smallest == 0.0 || step < smallest)) {
            smallest = step;
        }
    }
    const double extent = depths.back() - depths.front();
    return smallest > 0.0 ? extent / std::round(extent / smallest) : 0.0;
}

/// Returns the slice spacing or thickness from the header, for a segmentation with a single plane.
double statedStepMm(const DicomDataset& data)
{
    constexpr DicomTag pixelMeasuresTag = 0x00289110;
    for (const DicomDataset& shared : data.items(sharedGroupsTag)) {
        for (const DicomDataset& measures : shared.items(pixelMeasuresTag)) {
            for (const DicomTag tag : {DicomTag{0x00180088}, DicomTag{0x00180050}}) {
                if (const auto step = measures.number(tag); step && *step > 1e-3 && *step < 1e3) {
                    return *step;
                }
            }
        }
    }
    return 1.0;
}

/// Returns the smallest grid that contains all frames. Fails if frames do not state their positions or do not lie on a
/// regular grid.
core::Result<SegmentationGrid> segmentationGrid(const std::vector<SliceRecord>& frames, const DicomDataset& data,
                                                const std::string& path)
{
    const SliceRecord& first = frames.front();
    if (!first.axes ||
        !std::all_of(frames.begin(), frames.end(), [&](const SliceRecord& frame) { return isPlaced(frame, first); })) {
        return fileError(path, messages::seriesNoPlace());
    }
    const Eigen::Vector3d normal = normalOf(first);
    std::vector<double> depths;
    depths.reserve(frames.size());
    for (const SliceRecord& frame : frames) {
        depths.push_back(normal.dot(*frame.position));
    }
    const auto lowest = static_cast<std::size_t>(std::min_element(depths.begin(), depths.end()) - depths.begin());
    const double spread = *std::max_element(depths.begin(), depths.end()) - depths[lowest];
    const double between = stepBetween(depths);
    const double step = between > 0.0 ? between : statedStepMm(data);
    SegmentationGrid grid;
    grid.geometry.size = {first.size.x(), first.size.y(), static_cast<int>(std::lround(spread / step)) + 1};
    grid.geometry.spacingMm = {first.spacingMm.x(), first.spacingMm.y(), step};
    grid.geometry.originInPatient = *frames[lowest].position;
    grid.geometry.direction << *first.axes, normal;
    const Eigen::Affine3d voxelFromPatient = grid.geometry.patientFromVoxel().inverse();
    for (const SliceRecord& frame : frames) {
        const Eigen::Vector3d voxel = voxelFromPatient * *frame.position;
        if (std::abs(voxel.x()) > placeTolerance || std::abs(voxel.y()) > placeTolerance ||
            std::abs(voxel.z() - std::round(voxel.z())) > placeTolerance) {
            return fileError(path, messages::seriesIsSegmentation());
        }
        grid.layers.push_back(static_cast<int>(std::lround(voxel.z())));
    }
    if (grid.geometry.voxelCount() > maxGridVoxels) {
        return fileError(path, messages::seriesIsSegmentation());
    }
    return grid;
}

constexpr std::string_view segmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr std::string_view labelMapClass = "1.2.840.10008.5.1.4.1.1.66.7";
constexpr DicomTag identificationTag = 0x0062000a;
constexpr DicomTag segmentNumberTag = 0x0062000b;
constexpr std::size_t maxPixels = std::size_t{1} << 31;

std::optional<int> segmentIn(const std::vector<DicomDataset>& groups, std::size_t index)
{
    if (index >= groups.size()) {
        return std::nullopt;
    }
    const std::vector<DicomDataset> items = groups[index].items(identificationTag);
    return items.empty() ? std::nullopt : items.front().integer(segmentNumberTag);
}

/// Returns the segment number of each frame; empty if a frame does not state one.
std::vector<int> segmentOfFrames(const DicomDataset& data, std::size_t frameCount)
{
    const std::vector<DicomDataset> shared = data.items(sharedGroupsTag);
    const std::vector<DicomDataset> perFrame = data.items(perFrameGroupsTag);
    std::vector<int> segments;
    for (std::size_t k = 0; k < frameCount; ++k) {
        const std::optional<int> own = segmentIn(perFrame, k);
        const std::optional<int> segment = own ? own : segmentIn(shared, 0);
        if (!segment || *segment < 1 || *segment > 65535) {
            return {};
        }
        segments.push_back(*segment);
    }
    return segments;
}

/// Reads the bits of all frames in sequence, lowest bit of a byte first (PS3.5 8.1.1).
class BitFrames {
public:
    BitFrames(const DicomPixels& pixels, std::size_t pixelsPerFrame)
        : bytes_(pixels.bytes), pixelsPerFrame_(pixelsPerFrame)
    {
    }

    bool holds(std::size_t frames) const { return bytes_.size() * 8 >= frames * pixelsPerFrame_; }

    bool isSet(std::size_t frame, std::size_t pixel) const
    {
        const std::size_t bit = frame * pixelsPerFrame_ + pixel;
        return (static_cast<unsigned char>(bytes_[bit / 8]) >> (bit % 8) & 1U) != 0;
    }

private:
    std::string_view bytes_;
    std::size_t pixelsPerFrame_;
};

/// A parsed segmentation with its frames.
struct Segmentation {
    InputBytes bytes;
    DicomFile file;
    std::vector<SliceRecord> frames;
    std::vector<int> segments;   ///< segment number of each frame; empty for label maps
    SegmentationGrid grid;
};

void mark(std::uint16_t& voxel, int segment)
{
    voxel = voxel == 0 ? static_cast<std::uint16_t>(segment) : std::min(voxel, static_cast<std::uint16_t>(segment));
}

std::size_t firstVoxel(const Segmentation& segmentation, std::size_t frame)
{
    return segmentation.grid.geometry.index(0, 0, segmentation.grid.layers[frame]);
}

core::Result<core::LabelVolume> bitLabels(const Segmentation& segmentation, const std::string& path,
                                          const ReadObserver& observe)
{
    const auto pixels = segmentation.file.pixels.find(pixelDataTag);
    const SliceRecord& first = segmentation.frames.front();
    const auto perFrame = static_cast<std::size_t>(first.size.x()) * static_cast<std::size_t>(first.size.y());
    if (pixels == segmentation.file.pixels.end() || pixels->second.isEncapsulated) {
        return fileError(path, messages::seriesIsSegmentation());
    }
    const BitFrames bits(pixels->second, perFrame);
    if (!bits.holds(segmentation.frames.size())) {
        return fileError(path, messages::volumeCutShort());
    }
    core::LabelVolume labels(segmentation.grid.geometry);
    for (std::size_t k = 0; k < segmentation.frames.size(); ++k) {
        if (isStopRequested(observe, static_cast<double>(k) / static_cast<double>(segmentation.frames.size()))) {
            return readingCanceled(path);
        }
        const std::size_t start = firstVoxel(segmentation, k);
        for (std::size_t p = 0; p < perFrame; ++p) {
            if (bits.isSet(k, p)) {
                mark(labels.voxels[start + p], segmentation.segments[k]);
            }
        }
    }
    return labels;
}

core::Result<core::LabelVolume> byteLabels(const Segmentation& segmentation, const std::string& path,
                                           const ReadObserver& observe)
{
    const auto layout = pixelLayoutOf(segmentation.file, path, maxPixels);
    if (!layout) {
        return layout.error();
    }
    const auto reader = FrameReader::open(segmentation.file, layout.value(), path);
    if (!reader) {
        return reader.error();
    }
    const bool isLabelMap = segmentation.segments.empty();
    const double largest = segmentation.file.dataset.integer(0x0062000e).value_or(255);
    const auto least = static_cast<float>(0.5 * largest);
    core::LabelVolume labels(segmentation.grid.geometry);
    for (std::size_t k = 0; k < segmentation.frames.size(); ++k) {
        if (isStopRequested(observe, static_cast<double>(k) / static_cast<double>(segmentation.frames.size()))) {
            return readingCanceled(path);
        }
        const auto frame = reader.value().frame(static_cast<int>(k));
        if (!frame) {
            return frame.error();
        }
        const std::size_t start = firstVoxel(segmentation, k);
        const std::vector<float>& pixels = frame.value().pixels;
        for (std::size_t p = 0; p < pixels.size(); ++p) {
            if (isLabelMap && pixels[p] > 0.0F) {
                mark(labels.voxels[start + p], static_cast<int>(pixels[p]));
            } else if (!isLabelMap && pixels[p] >= least && pixels[p] > 0.0F) {
                mark(labels.voxels[start + p], segmentation.segments[k]);
            }
        }
    }
    return labels;
}

core::Result<Segmentation> openSegmentation(const std::string& path)
{
    auto bytes = openDicom(path);
    if (!bytes) {
        return bytes.error();
    }
    Segmentation segmentation;
    segmentation.bytes = std::move(bytes).value();
    auto parsed = parseDicom(segmentation.bytes.view(), path);
    if (!parsed) {
        return parsed.error();
    }
    segmentation.file = std::move(parsed).value();
    if (!isSegmentationClass(segmentation.file.dataset.text(0x00080016))) {
        return fileError(path, messages::labelsNoSegmentation());
    }
    auto images = readSliceRecords(path);
    if (!images) {
        return images.error();
    }
    segmentation.frames = std::move(images).value().slices;
    if (segmentation.frames.empty() || segmentation.file.damage) {
        return fileError(path, messages::volumeCutShort());
    }
    const DicomDataset& data = segmentation.file.dataset;
    if (data.text(0x00080016) != labelMapClass) {
        segmentation.segments = segmentOfFrames(data, segmentation.frames.size());
        if (segmentation.segments.empty()) {
            return fileError(path, messages::seriesIsSegmentation());
        }
    }
    auto grid = segmentationGrid(segmentation.frames, data, path);
    if (!grid) {
        return grid.error();
    }
    segmentation.grid = std::move(grid).value();
    return segmentation;
}

}   // namespace

bool isSegmentationClass(std::string_view sopClassUid)
{
    return sopClassUid == segmentationClass || sopClassUid == labelMapClass;
}

bool isDicomSegmentation(const std::string& path)
{
    const auto input = openDicom(path);
    const auto parsed = input ? parseDicom(input.value().view(), path) : core::Result<DicomFile>(input.error());
    return parsed && isSegmentationClass(parsed.value().dataset.text(0x00080016));
}

core::Result<std::vector<DicomSegment>> listSegments(const std::string& path)
{
    const auto input = openDicom(path);
    if (!input) {
        return input.error();
    }
    const auto parsed = parseDicom(input.value().view(), path);
    if (!parsed) {
        return parsed.error();
    }
    std::vector<DicomSegment> segments;
    const std::string_view sets = parsed.value().dataset.text(0x00080005);
    for (const DicomDataset& item : parsed.value().dataset.items(0x00620002)) {
        segments.push_back({item.integer(0x00620004).value_or(0), utf8Text(item, 0x00620005, sets)});
    }
    return segments;
}

core::Result<core::LabelVolume> readDicomSegmentation(const std::string& path, const ReadObserver& observe)
{
    const auto segmentation = openSegmentation(path);
    if (!segmentation) {
        return segmentation.error();
    }
    const int bitsAllocated = segmentation.value().file.dataset.integer(0x00280100).value_or(8);
    return bitsAllocated == 1 ? bitLabels(segmentation.value(), path, observe)
                              : byteLabels(segmentation.value(), path, observe);
}

}   // namespace angiopose::io
