#include "io/study/series_thumbnail.h"

#include "core/support/quantile.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/frame_source.h"
#include "io/dicom/pixel_layout.h"
#include "io/messages/messages.h"
#include "io/study/file_start.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t headBytes = std::size_t{1} << 20;
constexpr std::size_t maxPictureBytes = std::size_t{512} << 20;
constexpr double lowestHu = -250.0, highestHu = 650.0;   // from soft tissue to contrast agent
constexpr std::size_t wholeFile = std::numeric_limits<std::size_t>::max();

struct Range {
    double low = 0.0;
    double high = 1.0;
};

/// Returns the number of bytes up to the end of an uncompressed frame; the size of the whole file if unknown.
std::size_t bytesUpTo(const DicomFile& file, const PixelLayout& layout, std::string_view start, int frame)
{
    const auto pixels = file.pixels.find(pixelDataTag);
    if (pixels == file.pixels.end() || pixels->second.isEncapsulated || file.unpacked.view().data() != nullptr) {
        return wholeFile;
    }
    const auto begin = static_cast<std::size_t>(pixels->second.bytes.data() - start.data());
    const std::size_t bits = layout.pixelsPerFrame() * static_cast<std::size_t>(layout.samples) *
                             static_cast<std::size_t>(layout.bitsAllocated);
    return begin + (bits * (static_cast<std::size_t>(frame) + 1) + 7) / 8;
}

/// Decoded frame with its photometric interpretation.
struct ReadFrame {
    core::ImageF image;
    bool isInverted = false;   ///< whether low values are displayed white
};

core::Result<ReadFrame> decoded(const DicomFile& file, const PixelLayout& layout, const std::string& path, int frame)
{
    const auto reader = FrameReader::open(file, layout, path);
    if (!reader) {
        return reader.error();
    }
    auto image = reader.value().frame(frame);
    return image ? core::Result<ReadFrame>(ReadFrame{std::move(image).value(), layout.photometric == "MONOCHROME1"})
                 : image.error();
}

/// Reads one frame (`wanted`, or the middle one) and no more of the file than necessary.
core::Result<ReadFrame> readFrame(const std::string& path, std::optional<int> wanted, const ReadObserver& observe)
{
    for (std::size_t size = headBytes;;) {
        auto read = readFileStart(path, size, observe);
        if (!read) {
            return read.error();
        }
        const FileStart& start = read.value();
        const auto parsed = parseDicom(start.bytes, path);
        const bool isEnough = start.isComplete() || size >= maxPictureBytes;
        if (!isEnough && (!parsed || parsed.value().pixels.empty())) {
            size *= 4;
            continue;
        }
        if (!parsed) {
            return parsed.error();
        }
        const auto described = pixelLayoutOf(parsed.value(), path, std::size_t{1} << 31);
        if (!described) {
            return described.error();
        }
        PixelLayout layout = described.value();
        const int frame = std::clamp(wanted.value_or(layout.frames / 2), 0, std::max(layout.frames - 1, 0));
        const std::size_t needed = bytesUpTo(parsed.value(), layout, start.bytes, frame);
        if (!isEnough && needed > start.bytes.size()) {
            size = std::min(needed, maxPictureBytes);
            continue;
        }
        if (needed != wholeFile) {
            layout.frames = frame + 1;   // later frames have not been read
        }
        return decoded(parsed.value(), layout, path, frame);
    }
}

/// Downsamples by averaging blocks of pixels.
core::ImageF shrunk(const core::ImageF& image, int sidePx)
{
    const int step = std::max(1, (std::max(image.width, image.height) + sidePx - 1) / sidePx);
    core::ImageF small(std::max(image.width / step, 1), std::max(image.height / step, 1));
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            float sum = 0.0F;
            int count = 0;
            for (int j = y * step; j < std::min((y + 1) * step, image.height); ++j) {
                for (int i = x * step; i < std::min((x + 1) * step, image.width); ++i, ++count) {
                    sum += image.at(i, j);
                }
            }
            small.at(x, y) = sum / static_cast<float>(std::max(count, 1));
        }
    }
    return small;
}

Range rangeOf(const core::ImageF& image)
{
    const std::vector<double> values(image.pixels.begin(), image.pixels.end());
    return {core::quantile(values, 0.01), core::quantile(values, 0.995)};
}

}   // namespace

core::Result<core::ImageF> seriesThumbnail(const DicomSeries& series, int sidePx, const ReadObserver& observe)
{
    if (series.slices.empty()) {
        return core::Error(messages::studyMissing());
    }
    const SliceRecord& middle = series.slices[series.slices.size() / 2];
    const bool isInHu = series.identity.modality == "CT" && !series.isAngiogram;
    // A run, or a multi-frame file without frame positions, has a single slice record.
    const std::optional<int> frame = series.slices.size() > 1 ? std::optional(middle.frame) : std::nullopt;
    const auto read = readFrame(middle.path, frame, observe);
    if (!read) {
        return read.error();
    }
    core::ImageF picture = shrunk(read.value().image, sidePx);
    const Range there = rangeOf(picture);
    const Range ofVessels = isInHu && middle.slope > 0.0 ? Range{(lowestHu - middle.intercept) / middle.slope,
                                                                 (highestHu - middle.intercept) / middle.slope}
                                                         : there;
    const Range range =
        there.high > ofVessels.low ? ofVessels : there;   // if the slice shows only air, use its own range
    const auto low = static_cast<float>(range.low);
    const auto width = static_cast<float>(std::max(range.high - range.low, 1e-6));
    for (float& pixel : picture.pixels) {
        const float shown = std::clamp((pixel - low) / width, 0.0F, 1.0F);
        pixel = read.value().isInverted ? 1.0F - shown : shown;
    }
    return picture;
}

}   // namespace angiopose::io
