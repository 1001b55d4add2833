#include "io/series/segmentation_grid.h"

#include "io/dicom/functional_groups.h"
#include "io/messages/messages.h"
#include "io/series/slice_stack.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr std::size_t maxGridVoxels = std::size_t{1} << 31;
constexpr double placeTolerance = 0.1;   // fraction of a voxel

bool isPlaced(const SliceRecord& frame, const SliceRecord& first)
{
    return frame.position && frame.axes && frame.size == first.size && !frame.spacingMm.isZero() &&
           (*frame.axes - *first.axes).cwiseAbs().maxCoeff() < 5e-3;
}

/// Returns the smallest step between frames, refined over the whole stack; 0 if all lie in one plane.
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

/// Returns the distance between planes from the header, for a segmentation of one plane.
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

}   // namespace

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

}   // namespace angiopose::io