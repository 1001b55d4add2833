#include "io/dicom/frame_source.h"

#include "io/dicom/decode_frame.h"
#include "io/dicom/dicom_elements.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace io {
namespace {

using core::ImageF;

/// Stored value number `index` of a frame, sign-extended from its high bit.
class SampleReader {
public:
    SampleReader(std::string_view bytes, const PixelLayout& layout, DicomEncoding encoding)
        : bytes_(bytes), layout_(&layout), encoding_(encoding)
    {
    }

    float operator()(std::size_t index) const
    {
        std::uint32_t raw = 0;
        switch (layout_->bitsAllocated) {
            case 1:
                return static_cast<float>((static_cast<unsigned char>(bytes_[index / 8]) >> (index % 8)) & 1U);
            case 8:
                raw = static_cast<unsigned char>(bytes_[index]);
                break;
            case 16:
                raw = readUint16(bytes_.substr(2 * index), encoding_);
                break;
            default:
                raw = readUint32(bytes_.substr(4 * index), encoding_);
        }
        if (layout_->isFloat) {
            return std::bit_cast<float>(raw);
        }
        const int shift = layout_->highBit + 1 - layout_->bitsStored;
        raw >>= shift;
        const int unused = 32 - layout_->bitsStored;
        if (layout_->isSigned) {
            return static_cast<float>(static_cast<std::int32_t>(raw << unused) >> unused);
        }
        return static_cast<float>(raw << unused >> unused);
    }

private:
    std::string_view bytes_;
    const PixelLayout* layout_;
    DicomEncoding encoding_;
};

/// Bits of one native frame; colour sub-sampled 4:2:2 takes two samples per pixel (PS3.5 §8.2).
std::size_t bitsPerFrame(const PixelLayout& layout)
{
    const bool isHalved = layout.samples == 3 && layout.photometric == "YBR_FULL_422";
    return layout.pixelsPerFrame() * static_cast<std::size_t>(isHalved ? 2 : layout.samples) *
           static_cast<std::size_t>(layout.bitsAllocated);
}

/// Grey as it is, colour as luminance (Rec. 601), YBR by its Y.
ImageF imageFrom(const SampleReader& sample, const PixelLayout& layout, bool isSubsampled, std::size_t firstSample)
{
    ImageF image(layout.columns, layout.rows);
    const std::size_t count = image.pixels.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (layout.samples == 1) {
            image.pixels[i] = sample(firstSample + i);
        } else if (isSubsampled) {   // Y Y Cb Cr
            image.pixels[i] = sample(4 * (i / 2) + i % 2);
        } else {
            const std::size_t step = layout.isPlanar ? count : 1;
            const std::size_t at = layout.isPlanar ? i : 3 * i;
            image.pixels[i] = layout.photometric.starts_with("YBR")
                                  ? sample(at)
                                  : 0.299F * sample(at) + 0.587F * sample(at + step) + 0.114F * sample(at + 2 * step);
        }
    }
    return image;
}

core::Result<std::vector<ImageF>> nativeFrames(const DicomElement& pixels, const PixelLayout& layout,
                                               const std::string& path)
{
    const std::size_t frameBits = bitsPerFrame(layout);
    const std::size_t needed = (frameBits * static_cast<std::size_t>(layout.frames) + 7) / 8;
    if (pixels.value.size() < needed) {
        return fileError(path, "its pixels are cut short: " + std::to_string(pixels.value.size()) + " of " +
                                   std::to_string(needed) + " bytes are there. Copy or export it again.");
    }
    const bool isSubsampled = layout.samples == 3 && layout.photometric == "YBR_FULL_422";
    std::vector<ImageF> frames;
    for (std::size_t k = 0; k < static_cast<std::size_t>(layout.frames); ++k) {
        if (layout.bitsAllocated == 1) {   // frames follow each other without padding
            frames.push_back(imageFrom(SampleReader(pixels.value, layout, pixels.encoding), layout, false,
                                       k * layout.pixelsPerFrame()));
        } else {
            const std::string_view bytes = pixels.value.substr(k * frameBits / 8, frameBits / 8);
            frames.push_back(imageFrom(SampleReader(bytes, layout, pixels.encoding), layout, isSubsampled, 0));
        }
    }
    return frames;
}

bool startsStream(std::string_view fragment)
{
    return fragment.starts_with("\xff\xd8") || fragment.starts_with("\xff\x4f") ||
           fragment.starts_with(std::string_view("\0\0\0\x0cjP", 6));
}

/// One string of bytes per frame: frames are one fragment each, or start where a stream starts.
std::vector<std::string> framesOfFragments(const std::vector<std::string_view>& fragments, std::size_t frameCount)
{
    std::vector<std::string> frames;
    const bool isOneEach = fragments.size() == frameCount;
    for (const std::string_view fragment : fragments) {
        if (frames.empty() || isOneEach || (frameCount > 1 && startsStream(fragment))) {
            frames.emplace_back(fragment);
        } else {
            frames.back() += fragment;
        }
    }
    return frames;
}

core::Result<std::vector<ImageF>> compressedFrames(const DicomFile& file, const DicomElement& pixels,
                                                   const PixelLayout& layout, const std::string& path)
{
    auto fragments = fragmentsOf(pixels);
    if (!fragments || fragments->size() < 2) {
        return fileError(path, "its compressed pixels are cut short. Copy or export it again.");
    }
    fragments->erase(fragments->begin());   // the offset table
    const auto count = static_cast<std::size_t>(layout.frames);
    const std::vector<std::string> streams = framesOfFragments(*fragments, count);
    if (streams.size() < count) {
        return fileError(path, "only " + std::to_string(streams.size()) + " of its " + std::to_string(count) +
                                   " frames are there. Copy or export it again.");
    }
    std::vector<ImageF> frames;
    for (std::size_t k = 0; k < count; ++k) {
        PixelLayout decoded = layout;
        const auto bytes = decodeFrame(streams[k], file.transferSyntax, decoded);
        const std::size_t needed = decoded.pixelsPerFrame() * static_cast<std::size_t>(decoded.samples) *
                                   static_cast<std::size_t>(decoded.bitsAllocated) / 8;
        if (!bytes || bytes->size() < needed || layout.bitsAllocated < 8) {
            return fileError(path, "frame " + std::to_string(k) + " cannot be decoded (transfer syntax " +
                                       file.transferSyntax.substr(0, 64) +
                                       "): damaged, cut short, or a compression this program does not read. "
                                       "Export the run again, uncompressed if possible.");
        }
        const SampleReader sample({bytes->data(), bytes->size()}, decoded, DicomEncoding{true, false});
        frames.push_back(imageFrom(sample, decoded, false, 0));
    }
    return frames;
}

}   // namespace

core::Result<std::vector<ImageF>> readFrames(const DicomFile& file, const PixelLayout& layout, const std::string& path)
{
    const DicomElement* pixels = file.dataset.find(layout.isFloat ? 0x7fe00008 : pixelDataTag);
    auto frames = pixels->hasUndefinedLength ? compressedFrames(file, *pixels, layout, path)
                                             : nativeFrames(*pixels, layout, path);
    if (frames && layout.isFloat) {
        for (const ImageF& frame : frames.value()) {
            if (!std::all_of(frame.pixels.begin(), frame.pixels.end(),
                             [](float value) { return std::isfinite(value); })) {
                return fileError(path, "a pixel is not a finite number. Export the image again.");
            }
        }
    }
    return frames;
}

}   // namespace io
