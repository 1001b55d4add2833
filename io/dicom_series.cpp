#include "io/dicom_series.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/frame_source.h"
#include "io/dicom/pixel_layout.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/series/group_slices.h"
#include "io/support/file_error.h"
#include "io/support/files_in_folder.h"
#include "io/support/input_bytes.h"
#include "io/volume/quantization.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>

namespace angiopose::io {
namespace {

constexpr std::size_t maxSeriesPixels = std::size_t{1} << 31;
constexpr double airHu = -1000.0;

using core::ImageF;

/// A DICOM file kept open while its frames are read.
struct OpenFile {
    std::string path;
    InputBytes bytes;
    DicomFile file;
    FrameReader reader;
};

core::Result<std::unique_ptr<OpenFile>> openFile(const std::string& path)
{
    auto bytes = openDicom(path);
    if (!bytes) {
        return bytes.error();
    }
    InputBytes kept = std::move(bytes).value();
    auto parsed = parseDicom(kept.view(), path);
    if (!parsed) {
        return parsed.error();
    }
    DicomFile file = std::move(parsed).value();
    const auto layout = pixelLayoutOf(file, path, maxSeriesPixels);
    if (!layout) {
        return layout.error();
    }
    if (layout.value().samples != 1) {
        return fileError(path, messages::seriesColor());
    }
    auto reader = FrameReader::open(file, layout.value(), path);
    if (!reader) {
        return reader.error();
    }
    return std::make_unique<OpenFile>(OpenFile{path, std::move(kept), std::move(file), std::move(reader).value()});
}

/// Decodes slices in the requested order; caches the last two slices and the last file.
class SliceReader {
public:
    explicit SliceReader(const std::vector<SliceRecord>& slices) : slices_(&slices) {}

    /// Returns the decoded values of a slice; valid until two other slices have been requested.
    core::Result<const ImageF*> slice(std::size_t index)
    {
        const auto kept =
            std::find_if(kept_.begin(), kept_.end(), [&](const auto& held) { return held.first == index; });
        if (kept != kept_.end()) {
            return &kept->second;
        }
        auto image = decode((*slices_)[index]);
        if (!image) {
            return image.error();
        }
        if (kept_.size() == 2) {
            kept_.pop_front();
        }
        kept_.emplace_back(index, std::move(image).value());
        return &kept_.back().second;
    }

private:
    core::Result<ImageF> decode(const SliceRecord& slice)
    {
        if (!file_ || file_->path != slice.path) {
            auto opened = openFile(slice.path);
            if (!opened) {
                return opened.error();
            }
            file_ = std::move(opened).value();
        }
        auto frame = file_->reader.frame(slice.frame);
        if (!frame) {
            return frame;
        }
        ImageF image = std::move(frame).value();
        if (image.width != slice.size.x() || image.height != slice.size.y()) {
            return fileError(slice.path, messages::seriesSliceSize());
        }
        return image;
    }

    const std::vector<SliceRecord>* slices_;
    std::unique_ptr<OpenFile> file_;
    std::deque<std::pair<std::size_t, ImageF>> kept_;   // deque, so that references to cached slices remain valid
};

bool hasOneScale(const std::vector<SliceRecord>& slices)
{
    const SliceRecord& first = slices.front();
    return std::all_of(slices.begin(), slices.end(), [&](const SliceRecord& slice) {
        return slice.slope == first.slope && slice.intercept == first.intercept && !slice.isFloat &&
               slice.bitsStored <= 16;
    });
}

/// Conversion from the values of a series to voxels, and from voxels to physical values.
struct SeriesScale {
    bool isRescaled =
        false;   ///< slices differ in slope or have a wide type, so that `quantization` applies to rescaled values
    Quantization quantization;
    double slope = 1.0;
    double intercept = 0.0;
};

core::Result<ValueRange> rescaledRange(const DicomSeries& series, const ReadObserver& observe)
{
    ValueRange range;
    SliceReader reader(series.slices);
    for (std::size_t i = 0; i < series.slices.size(); ++i) {
        if (isStopRequested(observe, static_cast<double>(i) / static_cast<double>(series.slices.size()))) {
            return readingCanceled(series.slices[i].path);
        }
        const auto image = reader.slice(i);
        if (!image) {
            return image.error();
        }
        for (const float value : image.value()->pixels) {
            range.add(series.slices[i].slope * static_cast<double>(value) + series.slices[i].intercept);
        }
    }
    return range;
}

core::Result<SeriesScale> scaleOf(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings)
{
    SeriesScale scale;
    const std::vector<SliceRecord>& slices = series.slices;
    if (hasOneScale(slices)) {
        const bool isWide = std::any_of(slices.begin(), slices.end(), [](const SliceRecord& slice) {
            return !slice.isSigned && slice.bitsStored == 16;
        });
        scale.quantization.offset = isWide ? -minStoredValue : 0.0;
        scale.slope = slices.front().slope;
        scale.intercept = slices.front().intercept + scale.slope * scale.quantization.offset;
        return scale;
    }
    const auto range = rescaledRange(series, observe);
    if (!range) {
        return range.error();
    }
    scale.isRescaled = true;
    scale.quantization = quantizationOf(range.value());
    scale.slope = scale.quantization.scale;
    scale.intercept = scale.quantization.offset;
    if (!range.value().isInteger || scale.slope != 1.0) {
        warnings.push_back(messages::seriesScales(roundingNote(scale.slope, "series'")));
    }
    return scale;
}

/// Returns a slice as 16-bit levels in the plane of the volume, translated by `shift`; pixels beyond the slice's edges
/// are `outside`.
std::vector<float> planeOf(const ImageF& image, const SliceRecord& slice, const SeriesScale& scale,
                           const Eigen::Vector2d& shift, const core::VolumeGeometry& geometry, float outside)
{
    const float slope = scale.isRescaled ? static_cast<float>(slice.slope) : 1.0F;
    const float intercept = scale.isRescaled ? static_cast<float>(slice.intercept) : 0.0F;
    const int width = geometry.size.x(), height = geometry.size.y();
    std::vector<float> plane(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), outside);
    const auto value = [&](int i, int j) {
        const bool isInside = i >= 0 && j >= 0 && i < image.width && j < image.height;
        return isInside ? slope * image.at(i, j) + intercept : outside;
    };
    const Eigen::Vector2d whole(std::floor(shift.x()), std::floor(shift.y()));
    const Eigen::Vector2f part = (shift - whole).cast<float>();
    const bool isInteger = part.maxCoeff() < 0.01F;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const int x = i - static_cast<int>(whole.x()), y = j - static_cast<int>(whole.y());
            float& out =
                plane[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
            if (isInteger) {
                out = value(x, y);
            } else {
                const float upper = (1.0F - part.x()) * value(x, y - 1) + part.x() * value(x - 1, y - 1);
                const float lower = (1.0F - part.x()) * value(x, y) + part.x() * value(x - 1, y);
                out = (1.0F - part.y()) * lower + part.y() * upper;
            }
        }
    }
    return plane;
}

/// Writes layer `k` of the volume.
core::Status writeLayer(const DicomSeries& series, const SeriesScale& scale, std::size_t k, SliceReader& reader,
                        core::Volume& volume)
{
    const StackLayer& layer = series.stack.layers[k];
    const double outsideValue = series.identity.modality == "CT" ? airHu : 0.0;
    const auto outside = static_cast<float>(scale.isRescaled ? outsideValue
                                                             : (outsideValue - series.slices.front().intercept) /
                                                                   series.slices.front().slope);
    const auto planeAt = [&](std::size_t index) -> core::Result<std::vector<float>> {
        const auto image = reader.slice(index);
        if (!image) {
            return image.error();
        }
        return planeOf(*image.value(), series.slices[index], scale, series.stack.shiftVoxels[index], volume.geometry,
                       outside);
    };
    auto made = planeAt(layer.lower);
    if (!made) {
        return made.error();
    }
    std::vector<float> plane = std::move(made).value();
    if (layer.upperWeight > 0.0) {
        const auto other = planeAt(layer.upper);
        if (!other) {
            return other.error();
        }
        const auto weight = static_cast<float>(layer.upperWeight);
        std::transform(plane.begin(), plane.end(), other.value().begin(), plane.begin(),
                       [weight](float lower, float upper) { return (1.0F - weight) * lower + weight * upper; });
    }
    const Quantization& quantization = scale.quantization;
    std::transform(plane.begin(), plane.end(), volume.voxels.begin() + static_cast<std::ptrdiff_t>(k * plane.size()),
                   [&](float value) { return quantization.voxel(static_cast<double>(value)); });
    return core::Done{};
}

core::Result<std::vector<DicomSeries>> scan(const std::string& folder, FolderDepth reach, const ReadObserver& observe)
{
    const auto files = filesInFolder(folder, reach);
    if (!files) {
        return files.error();
    }
    std::vector<DicomImages> images;
    const auto total = static_cast<double>(files.value().size());
    for (std::size_t i = 0; i < files.value().size(); ++i) {
        if (i % 16 == 0 && isStopRequested(observe, static_cast<double>(i) / total)) {
            return readingCanceled(folder);
        }
        if (auto image = readSliceRecords(files.value()[i])) {
            images.push_back(std::move(image).value());
        }
    }
    return groupSlices(std::move(images));
}

}   // namespace

core::Result<std::vector<DicomSeries>> listSeries(const std::string& folder, const ReadObserver& observe)
{
    auto series = scan(folder, FolderDepth::Recursive, observe);
    if (series && series.value().empty()) {
        return fileError(folder, messages::seriesNone());
    }
    return series;
}

core::Result<DicomSeries> seriesOfFile(const std::string& path, const ReadObserver& observe)
{
    const auto own = readSliceRecords(path);
    if (!own) {
        return own.error();
    }
    std::string folder = std::filesystem::path(path).parent_path().string();
    auto found = own.value().slices.size() > 1 ? core::Result<std::vector<DicomSeries>>(groupSlices({own.value()}))
                                               : scan(folder.empty() ? "." : folder, FolderDepth::TopLevel, observe);
    if (!found) {
        return found.error();
    }
    std::vector<DicomSeries> all = std::move(found).value();
    std::error_code failed;
    for (DicomSeries& series : all) {
        const bool isOwn = std::any_of(series.slices.begin(), series.slices.end(), [&](const SliceRecord& slice) {
            return slice.path == path || std::filesystem::equivalent(slice.path, path, failed);
        });
        if (isOwn) {
            return std::move(series);
        }
    }
    // Grouping removed the file as a duplicate of another file in the folder: use this file alone.
    std::vector<DicomSeries> alone = groupSlices({own.value()});
    return alone.empty() ? core::Result<DicomSeries>(fileError(path, messages::seriesFileWithoutImage()))
                         : std::move(alone.front());
}

core::Result<core::Volume> readSeries(const DicomSeries& series, const ReadObserver& observe, core::Messages& warnings)
{
    const std::string& path = series.slices.empty() ? series.id : series.slices.front().path;
    if (series.problem || series.isAngiogram) {
        return fileError(path, series.isAngiogram ? messages::seriesIsXray() : *series.problem);
    }
    const bool isTwoPass = !hasOneScale(series.slices);
    const auto scale = scaleOf(series, progressPart(observe, 0.0, 0.5), warnings);
    if (!scale) {
        return scale.error();
    }
    core::Volume volume(series.stack.geometry);
    volume.slope = scale.value().slope;
    volume.intercept = scale.value().intercept;
    SliceReader reader(series.slices);
    const ReadObserver observeLayers = progressPart(observe, isTwoPass ? 0.5 : 0.0, 1.0);
    const std::size_t count = series.stack.layers.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (isStopRequested(observeLayers, static_cast<double>(k) / static_cast<double>(count))) {
            return readingCanceled(path);
        }
        if (const auto written = writeLayer(series, scale.value(), k, reader, volume); !written) {
            return written.error();
        }
    }
    return volume;
}

core::Result<std::string> sha256OfSeries(const DicomSeries& series)
{
    std::string hashes;
    const std::string* last = nullptr;
    for (const SliceRecord& slice : series.slices) {
        if (last && *last == slice.path) {
            continue;
        }
        last = &slice.path;
        const auto hash = sha256OfFile(slice.path);
        if (!hash) {
            return hash.error();
        }
        hashes += hash.value();
    }
    return sha256OfText(hashes);
}

}   // namespace angiopose::io
