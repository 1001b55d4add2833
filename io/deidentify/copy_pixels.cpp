#include "io/deidentify/copy_pixels.h"

#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "io/dicom/frame_source.h"
#include "io/dicom/pixel_layout.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace angiopose::io {
namespace {

constexpr int sampledFrameCount = 6;   ///< evenly spaced frames of a cine run, because all frames show burned-in text
constexpr DicomTag positionTag = 0x00200032;
constexpr DicomTag sharedGroupsTag = 0x52009229;
constexpr DicomTag burnedInTag = 0x00280301;

/// Returns the mask of the burned-in text found in any of the sampled frames.
core::Mask2d findBurnedInText(const std::vector<core::ImageF>& frames)
{
    const int count = static_cast<int>(frames.size());
    core::Mask2d letters(frames.front().width, frames.front().height);
    for (int n = 0; n < std::min(count, sampledFrameCount); ++n) {
        const int frame = count <= sampledFrameCount ? n : n * (count - 1) / (sampledFrameCount - 1);
        const core::Mask2d found =
            core::burnedInTextMask(frames[static_cast<std::size_t>(frame)], core::thoroughMaxLetterHeight);
        std::ranges::transform(letters.pixels, found.pixels, letters.pixels.begin(),
                               [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    }
    return letters;
}

/// Fills the masked pixels with the lowest value of the cine run, or the highest if the image is shown inverted.
void maskBurnedInText(std::vector<core::ImageF>& frames, const core::Mask2d& letters, bool isInverse)
{
    float black = frames.front().pixels.front();
    for (const core::ImageF& frame : frames) {
        const auto [least, most] = std::ranges::minmax(frame.pixels);
        black = isInverse ? std::max(black, most) : std::min(black, least);
    }
    for (core::ImageF& frame : frames) {
        for (std::size_t n = 0; n < frame.pixels.size(); ++n) {
            frame.pixels[n] = letters.pixels[n] != 0 ? black : frame.pixels[n];
        }
    }
}

void handleBurnedInText(std::vector<core::ImageF>& frames, const DicomDataset& data, BurnedInTextPolicy treatment,
                        DicomItem& to, core::Messages& warnings)
{
    const bool isSlice = data.has(positionTag) || data.has(sharedGroupsTag);
    const bool isDeclared = data.text(burnedInTag) == "YES";
    const core::Mask2d letters = isSlice ? core::Mask2d() : findBurnedInText(frames);
    const auto first = std::ranges::find_if(letters.pixels, [](std::uint8_t pixel) { return pixel != 0; });
    if (first == letters.pixels.end()) {
        if (isDeclared) {
            warnings.push_back(messages::lettersDeclared());
        }
        return;
    }
    if (treatment == BurnedInTextPolicy::Reported) {
        const auto at = first - letters.pixels.begin();
        warnings.push_back(
            messages::lettersStay(static_cast<int>(at % letters.width), static_cast<int>(at / letters.width)));
        to.text(burnedInTag, "CS", "YES");
        return;
    }
    const auto set = std::ranges::count_if(letters.pixels, [](std::uint8_t pixel) { return pixel != 0; });
    maskBurnedInText(frames, letters, data.text(0x00280004) == "MONOCHROME1");
    warnings.push_back(messages::lettersBlackedOut(
        core::Quantity{100.0 * static_cast<double>(set) / static_cast<double>(letters.pixels.size()), 1}));
    to.text(burnedInTag, "CS", "NO");
}

/// Packs the frames into 16-bit little-endian words for DCMTK: one value of at most 16 bits per word (negative values
/// in two's complement), or two 8-bit values per word.
std::vector<std::uint16_t> wordsOf(const std::vector<core::ImageF>& frames, int bitsAllocated)
{
    std::vector<std::uint16_t> words;
    const std::size_t count = frames.size() * frames.front().pixels.size();
    words.reserve(bitsAllocated == 8 ? (count + 1) / 2 : count);
    std::size_t at = 0;
    for (const core::ImageF& frame : frames) {
        for (const float pixel : frame.pixels) {
            const auto value = static_cast<std::uint16_t>(std::lround(pixel));
            if (bitsAllocated != 8) {
                words.push_back(value);
            } else if (at++ % 2 == 0) {
                words.push_back(value & 0xffU);
            } else {
                words.back() = static_cast<std::uint16_t>(words.back() | (value & 0xffU) << 8U);
            }
        }
    }
    return words;
}

void describePixels(const PixelLayout& layout, DicomItem& to)
{
    to.setUnsignedShort(0x00280002, 1);
    to.remove(0x00280006);   // the planar configuration applies only to color images
    to.text(0x00280004, "CS", layout.photometric == "MONOCHROME1" ? "MONOCHROME1" : "MONOCHROME2");
    to.setUnsignedShort(0x00280010, layout.rows);
    to.setUnsignedShort(0x00280011, layout.columns);
    to.setUnsignedShort(0x00280100, layout.bitsAllocated);
    if (!layout.isFloat) {
        to.setUnsignedShort(0x00280101, layout.bitsStored);
        to.setUnsignedShort(0x00280102, layout.bitsStored - 1);
        to.setUnsignedShort(0x00280103, layout.isSigned ? 1 : 0);
    }
}

/// Copies 32-bit values unchanged.
core::Status copy32BitPixels(const DicomPixels& pixels, const PixelLayout& layout, const std::string& path,
                             DicomItem& to)
{
    const std::size_t needed = layout.pixelsPerFrame() * static_cast<std::size_t>(layout.frames) * 4;
    if (pixels.isEncapsulated || pixels.order == ByteOrder::Big || pixels.bytes.size() < needed) {
        return fileError(path, messages::pixelsTooWide());
    }
    if (layout.isFloat) {
        std::vector<float> values(needed / 4);
        std::copy_n(pixels.bytes.data(), needed, reinterpret_cast<char*>(values.data()));
        to.setFloatPixels(values);
    } else {
        std::vector<std::uint16_t> words(needed / 2);
        std::copy_n(pixels.bytes.data(), needed, reinterpret_cast<char*>(words.data()));
        to.words(pixelDataTag, words);
    }
    return core::Done{};
}

constexpr std::size_t maxVoxels = std::size_t{1} << 34;   // corresponds to 2 GB of single-bit voxels

}   // namespace

core::Status copyPixels(const DicomFile& file, const std::string& path, BurnedInTextPolicy letters, DicomItem& to,
                        core::Messages& warnings)
{
    const auto read = pixelLayoutOf(file, path);
    if (!read) {
        return read.error();
    }
    const PixelLayout& layout = read.value();
    if (layout.bitsAllocated == 1) {
        return fileError(path, messages::segmentationStays());
    }
    describePixels(layout, to);
    if (layout.bitsAllocated > 16) {
        return copy32BitPixels(file.pixels.at(layout.isFloat ? floatPixelsTag : pixelDataTag), layout, path, to);
    }
    auto decoded = readFrames(file, layout, path);
    if (!decoded) {
        return decoded.error();
    }
    DecodedRun run = std::move(decoded).value();
    const auto frames = static_cast<int>(run.frames.size());
    if (frames != layout.frames) {
        warnings.push_back(messages::dicomFramesOther(layout.frames, frames));
        to.text(0x00280008, "IS", std::to_string(frames));
    }
    if (const std::size_t damaged = run.damagedFrames.size() + run.lostFrames.size(); damaged > 0) {
        warnings.push_back(messages::framesDamaged(damaged, run.frames.size()));
    }
    if (layout.samples > 1) {
        warnings.push_back(messages::colorDropped());
    }
    handleBurnedInText(run.frames, file.dataset, letters, to, warnings);
    to.words(pixelDataTag, wordsOf(run.frames, layout.bitsAllocated));
    return core::Done{};
}

core::Status copySegments(const DicomFile& file, const std::string& path, DicomItem& to)
{
    const auto read = pixelLayoutOf(file, path, maxVoxels);
    if (!read) {
        return read.error();
    }
    const PixelLayout& layout = read.value();
    const auto found = file.pixels.find(pixelDataTag);
    const bool isKnown = layout.samples == 1 && (layout.bitsAllocated == 1 || layout.bitsAllocated == 8);
    if (!isKnown || found == file.pixels.end() || found->second.isEncapsulated ||
        found->second.order == ByteOrder::Big) {
        return fileError(path, messages::segmentationStays());
    }
    const std::size_t bits = layout.pixelsPerFrame() * static_cast<std::size_t>(layout.frames) *
                             static_cast<std::size_t>(layout.bitsAllocated);
    const std::size_t bytes = (bits + 7) / 8;
    if (found->second.bytes.size() < bytes) {
        return fileError(path, messages::segmentationStays());
    }
    std::string voxels(found->second.bytes.substr(0, bytes));
    if (const std::size_t used = bits % 8; used != 0) {   // the first voxel lies in the lowest bit
        voxels.back() = static_cast<char>(static_cast<unsigned char>(voxels.back()) & ((1U << used) - 1U));
    }
    to.bytes(pixelDataTag, voxels);
    return core::Done{};
}

}   // namespace angiopose::io
