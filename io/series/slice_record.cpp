#include "io/series/slice_record.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/functional_groups.h"
#include "io/dicom/projection.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <cmath>

namespace angiopose::io {
namespace {

constexpr int maxFrames = 20'000;

/// Tags of `phaseKeys` in a single-frame image.
constexpr std::array<DicomTag, phaseKeyCount> phaseTags = {0x00200012, 0x00200100, 0x00209241,
                                                           0x00181060, 0x00180086, 0x00209056};

std::optional<Eigen::Vector3d> threeNumbers(const DicomDataset& data, DicomTag tag)
{
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) {
        const auto number = data.number(tag, static_cast<std::size_t>(i));
        if (!number || std::abs(*number) > 1e6) {
            return std::nullopt;
        }
        vector[i] = *number;
    }
    return vector;
}

/// Returns the orthonormalized directions of Image Orientation (Patient); nullopt if they are not perpendicular.
std::optional<Eigen::Matrix<double, 3, 2>> orientationOf(const DicomDataset& data)
{
    Eigen::Matrix<double, 3, 2> axes;
    for (int i = 0; i < 6; ++i) {
        const auto number = data.number(0x00200037, static_cast<std::size_t>(i));
        if (!number) {
            return std::nullopt;
        }
        axes(i % 3, i / 3) = *number;
    }
    const Eigen::Vector2d lengths = axes.colwise().norm();
    if ((lengths.array() - 1.0).abs().maxCoeff() > 0.02 || std::abs(axes.col(0).dot(axes.col(1))) > 0.02) {
        return std::nullopt;
    }
    axes.col(0).normalize();
    axes.col(1) -= axes.col(0) * axes.col(0).dot(axes.col(1));
    axes.col(1).normalize();
    return axes;
}

/// Reads position, pixel size and value scale from `data`, which is an image header or a functional group.
void readPlace(const DicomDataset& data, SliceRecord& slice)
{
    if (const auto position = threeNumbers(data, 0x00200032)) {
        slice.position = position;
    }
    if (const auto axes = orientationOf(data)) {
        slice.axes = axes;
    }
    const auto down = data.number(0x00280030, 0), across = data.number(0x00280030, 1);
    if (down && across && *down > 1e-4 && *across > 1e-4 && *down < 1e3 && *across < 1e3) {
        slice.spacingMm = {*across, *down};
    }
    slice.statedStepMm = std::abs(data.number(0x00180088).value_or(slice.statedStepMm));
    if (const auto slope = data.number(0x00281053); slope && *slope != 0.0) {
        slice.slope = *slope;
        slice.intercept = data.number(0x00281052).value_or(0.0);
    }
}

void readPhases(const DicomDataset& data, SliceRecord& slice)
{
    for (std::size_t i = 0; i < phaseKeyCount; ++i) {
        const std::string_view text = data.text(phaseTags[i]);
        const auto number = data.number(phaseTags[i]);
        if (!text.empty()) {
            slice.phaseKeys[i] = number ? toText(*number) : std::string(text.substr(0, 64));
        }
    }
}

/// Reads the functional group sequences that determine the position of a frame (PS3.3 C.7.6.16), each with one item.
void readFunctionalGroups(const DicomDataset& groups, SliceRecord& slice)
{
    constexpr std::array<DicomTag, 6> sequences = {0x00209113, 0x00209116, 0x00289110,
                                                   0x00289145, 0x00209111, 0x00189118};
    for (const DicomTag sequence : sequences) {
        const std::vector<DicomDataset> items = groups.items(sequence);
        if (items.empty()) {
            continue;
        }
        readPlace(items.front(), slice);
        readPhases(items.front(), slice);
        if (sequence == 0x00209111) {   // Frame Content Sequence, which contains Temporal Position Index
            if (const auto index = items.front().integer(0x00209128)) {
                slice.phaseKeys[1] = std::to_string(*index);
            }
        }
    }
}

SliceRecord commonRecord(const DicomFile& file, const std::string& path)
{
    const DicomDataset& data = file.dataset;
    SliceRecord slice;
    slice.path = path;
    slice.size = {data.integer(0x00280011).value_or(0), data.integer(0x00280010).value_or(0)};
    slice.isFloat = file.pixels.contains(floatPixelsTag) || file.pixels.contains(doublePixelsTag);
    slice.bitsStored = data.integer(0x00280101).value_or(16);
    slice.isSigned = data.integer(0x00280103).value_or(0) == 1;
    slice.sopInstanceUid = data.text(0x00080018);
    slice.instanceNumber = data.integer(0x00200013).value_or(0);
    readPlace(data, slice);
    readPhases(data, slice);
    return slice;
}

std::vector<SliceRecord> slicesOf(const DicomFile& file, const std::string& path)
{
    const DicomDataset& data = file.dataset;
    SliceRecord slice = commonRecord(file, path);
    const std::vector<DicomDataset> perFrame = data.items(perFrameGroupsTag);
    const int frames = data.integer(0x00280008).value_or(1);
    if (perFrame.empty() || frames < 1 || frames > maxFrames) {
        return {slice};
    }
    if (const auto shared = data.items(sharedGroupsTag); !shared.empty()) {
        readFunctionalGroups(shared.front(), slice);
    }
    std::vector<SliceRecord> slices;
    for (int k = 0; k < frames; ++k) {
        slice.frame = k;
        slice.instanceNumber = k;
        slices.push_back(slice);
        if (static_cast<std::size_t>(k) < perFrame.size()) {
            readFunctionalGroups(perFrame[static_cast<std::size_t>(k)], slices.back());
        }
    }
    return slices;
}

}   // namespace

DicomImages imagesOf(const DicomFile& file, const std::string& path)
{
    const DicomDataset& data = file.dataset;
    DicomImages images;
    images.identity = identityOf(data);
    images.seriesDescription = utf8Text(data, 0x0008103e);
    images.seriesNumber = data.integer(0x00200011).value_or(0);
    images.sopClassUid = data.text(0x00080016);
    images.isProjection = isProjection(data);
    images.damage = file.damage;
    if (!file.pixels.empty()) {
        images.slices = slicesOf(file, path);
    }
    return images;
}

core::Result<DicomImages> readSliceRecords(const std::string& path)
{
    const auto input = openDicom(path);
    if (!input) {
        return input.error();
    }
    const auto parsed = parseDicom(input.value().view(), path);
    if (!parsed) {
        return parsed.error();
    }
    return imagesOf(parsed.value(), path);
}

}   // namespace angiopose::io
