#include "io/dicom/frame_source.h"

#include "io/dicom/decode_frame.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace angiopose::io {
namespace {

using core::ImageF;

constexpr std::string_view runLengthSyntax = "1.2.840.10008.1.2.5";   // RLE has one fragment per frame (PS3.5 A.4.2)

/// Reads stored values of a frame by index, sign-extended from the high bit.
class SampleReader {
public:
    SampleReader(std::string_view bytes, const PixelLayout& layout, ByteOrder order)
        : bytes_(bytes), layout_(&layout), order_(order)
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
                raw = readUint16(bytes_.substr(2 * index), order_);
                break;
            default:
                raw = readUint32(bytes_.substr(4 * index), order_);
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
    ByteOrder order_;
};

/// Returns the number of bits of one native frame; 4:2:2 subsampled color has two samples per pixel (PS3.5 §8.2).
std::size_t bitsPerFrame(const PixelLayout& layout)
{
    const bool isHalved = layout.samples == 3 && layout.photometric == "YBR_FULL_422";
    return layout.pixelsPerFrame() * static_cast<std::size_t>(isHalved ? 2 : layout.samples) *
           static_cast<std::size_t>(layout.bitsAllocated);
}

/// Converts samples to an image: grayscale unchanged, RGB to luminance (Rec. 601), YBR to its Y component.
ImageF imageFrom(const SampleReader& sample, const PixelLayout& layout, bool isSubsampled, std::size_t firstSample)
{
    ImageF image(layout.columns, layout.rows);
    const std::size_t count = image.pixels.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (layout.samples == 1) {
            image.pixels[i] = sample(firstSample + i);
        } else if (isSubsampled) {   // sample order Y Y Cb Cr
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

bool startsStream(std::string_view fragment)
{
    return fragment.starts_with("\xff\xd8") || fragment.starts_with("\xff\x4f") ||
           fragment.starts_with(std::string_view("\0\0\0\x0cjP", 6));
}

/// Groups fragments by frame: one fragment per frame, or all fragments from the start of a stream to the next start.
std::vector<std::vector<std::string_view>> framesOfFragments(const std::vector<std::string_view>& fragments,
                                                             std::size_t frameCount, bool isRunLength)
{
    std::vector<std::vector<std::string_view>> frames;
    const bool isOneEach =
        fragments.size() == frameCount || isRunLength || std::ranges::all_of(fragments, startsStream);
    for (const std::string_view fragment : fragments) {
        if (frames.empty() || isOneEach || (frameCount > 1 && startsStream(fragment))) {
            frames.emplace_back();
        }
        frames.back().push_back(fragment);
    }
    return frames;
}

bool isFinite(const ImageF& frame)
{
    return std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); });
}

}   // namespace

FrameReader::FrameReader(PixelLayout layout, std::string path) : layout_(std::move(layout)), path_(std::move(path)) {}

core::Result<FrameReader> FrameReader::open(const DicomFile& file, const PixelLayout& layout, const std::string& path)
{
    FrameReader reader(layout, path);
    const DicomPixels& pixels = reader.pixels_ = file.pixels.at(layout.isFloat ? floatPixelsTag : pixelDataTag);
    reader.transferSyntax_ = file.transferSyntax;
    const auto count = static_cast<std::size_t>(layout.frames);
    if (!pixels.isEncapsulated) {
        const std::size_t bits = bitsPerFrame(layout);
        const std::size_t there = 8 * pixels.bytes.size() / bits;
        if (there == 0) {
            return fileError(path, messages::dicomPixelsCutShort(pixels.bytes.size(), (bits * count + 7) / 8));
        }
        const bool areAllFrames = 8 * pixels.bytes.size() - bits * there <= 8;   // apart from a padding byte
        reader.frameCount_ = static_cast<int>(areAllFrames ? there : std::min(there, count));
        return reader;
    }
    auto fragments = fragmentsOf(pixels);
    if (!fragments || fragments->size() < 2) {
        return fileError(path, messages::dicomPackedPixelsCutShort());
    }
    fragments->erase(fragments->begin());   // remove the basic offset table
    reader.streams_ = framesOfFragments(*fragments, count, file.transferSyntax == runLengthSyntax);
    reader.frameCount_ = static_cast<int>(reader.streams_.size());
    return reader;
}

ImageF FrameReader::nativeFrame(std::size_t index) const
{
    if (layout_.bitsAllocated == 1) {   // frames follow each other without padding
        return imageFrom(SampleReader(pixels_.bytes, layout_, pixels_.order), layout_, false,
                         index * layout_.pixelsPerFrame());
    }
    const bool isSubsampled = layout_.samples == 3 && layout_.photometric == "YBR_FULL_422";
    const std::size_t frameBytes = bitsPerFrame(layout_) / 8;
    const std::string_view bytes = pixels_.bytes.substr(index * frameBytes, frameBytes);
    return imageFrom(SampleReader(bytes, layout_, pixels_.order), layout_, isSubsampled, 0);
}

core::Error FrameReader::decodeError(int index) const
{
    return fileError(path_, messages::dicomFrameUndecodable(index + 1, transferSyntax_.substr(0, 64)));
}

core::Result<DecodedFrame> FrameReader::compressedFrame(std::size_t index) const
{
    std::string stream;
    for (const std::string_view fragment : streams_[index]) {
        stream += fragment;
    }
    PixelLayout decoded = layout_;
    const auto pixels = decodeFrame(stream, transferSyntax_, decoded);
    const std::size_t needed = decoded.pixelsPerFrame() * static_cast<std::size_t>(decoded.samples) *
                               static_cast<std::size_t>(decoded.bitsAllocated) / 8;
    if (!pixels || pixels->bytes.size() < needed || layout_.bitsAllocated < 8) {
        return decodeError(static_cast<int>(index));
    }
    const SampleReader sample({pixels->bytes.data(), pixels->bytes.size()}, decoded, ByteOrder::Little);
    return DecodedFrame{imageFrom(sample, decoded, false, 0), pixels->isPartlyDamaged};
}

core::Result<DecodedFrame> FrameReader::frameAllowingDamage(int index) const
{
    const auto at = static_cast<std::size_t>(index);
    if (index >= frameCount_) {
        return fileError(path_, messages::dicomFramesMissing(frameCount_, layout_.frames));
    }
    auto frame = pixels_.isEncapsulated ? compressedFrame(at) : core::Result(DecodedFrame{nativeFrame(at)});
    if (frame && layout_.isFloat && !isFinite(frame.value().image)) {
        return fileError(path_, messages::pixelNotFinite());
    }
    return frame;
}

core::Result<ImageF> FrameReader::frame(int index) const
{
    auto frame = frameAllowingDamage(index);
    if (!frame) {
        return frame.error();
    }
    return frame.value().isPartlyDamaged ? core::Result<ImageF>(decodeError(index)) : std::move(frame).value().image;
}

core::Result<DecodedRun> readFrames(const DicomFile& file, const PixelLayout& layout, const std::string& path)
{
    const auto reader = FrameReader::open(file, layout, path);
    if (!reader) {
        return reader.error();
    }
    DecodedRun run;
    std::optional<core::Error> failure;
    const auto maxFrames = static_cast<int>(maxRunPixels / layout.pixelsPerFrame());
    const int count = std::min(reader.value().frameCount(), std::max(maxFrames, layout.frames));
    for (int k = 0; k < count; ++k) {
        auto frame = reader.value().frameAllowingDamage(k);
        if (frame) {
            if (frame.value().isPartlyDamaged) {
                run.damagedFrames.push_back(k);
            }
            run.frames.resize(static_cast<std::size_t>(k), frame.value().image);   // fills lost frames before this one
            run.frames.push_back(std::move(frame).value().image);
            continue;
        }
        failure = failure ? failure : frame.error();
        run.lostFrames.push_back(k);
        if (!run.frames.empty()) {
            run.frames.push_back(run.frames.back());
        }
    }
    return run.frames.empty() ? core::Result<DecodedRun>(*failure) : run;
}

}   // namespace angiopose::io
