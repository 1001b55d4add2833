#include "io/movie/mp4_movie.h"

#include "io/messages/messages.h"
#include "io/movie/yuv_image.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace angiopose::io {
namespace {

/// One image of a track.
struct Mp4Sample {
    std::size_t bytes = 0;
    std::uint32_t ticks = 0;   ///< display duration, ticks
    bool isKeyFrame = false;   ///< whether the image is a key frame, at which playback can start
};

/// H.264 track with everything that the file header states about it.
struct Mp4Track {
    MovieSize size;
    std::uint32_t ticksPerSecond = 90000;
    std::string sequence;   ///< SPS (the next member is the PPS): NAL units 7 and 8 without start codes
    std::string picture;
    std::vector<Mp4Sample> samples;
    MovieMetadata metadata;
};

constexpr std::size_t profilesWithChroma = 100;   // from this profile on, avcC has further fields (14496-15, 5.3.3.1)

std::string number(std::uint64_t value, int bytes)
{
    std::string text;
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
        text += static_cast<char>((value >> shift) & 0xFF);
    }
    return text;
}

std::string u8(std::uint64_t value)
{
    return number(value, 1);
}
std::string u16(std::uint64_t value)
{
    return number(value, 2);
}
std::string u32(std::uint64_t value)
{
    return number(value, 4);
}

std::string zeros(std::size_t bytes)
{
    return std::string(bytes, '\0');
}

std::string box(std::string_view type, std::initializer_list<std::string> parts)
{
    std::string content;
    for (const std::string& part : parts) {
        content += part;
    }
    return u32(8 + content.size()) + std::string(type) + content;
}

/// Returns a box with a version (0) and flags.
std::string fullBox(std::string_view type, std::uint32_t flags, std::initializer_list<std::string> parts)
{
    std::string content = u32(flags);
    for (const std::string& part : parts) {
        content += part;
    }
    return box(type, {content});
}

/// Returns the identity matrix in 16.16 fixed point, except for the last element, which is 2.30.
std::string unityMatrix()
{
    return u32(0x10000) + zeros(12) + u32(0x10000) + zeros(12) + u32(0x40000000);
}

std::uint64_t ticksOf(const Mp4Track& track)
{
    return std::accumulate(track.samples.begin(), track.samples.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Mp4Sample& sample) { return sum + sample.ticks; });
}

std::string movieHeader(const Mp4Track& track)
{
    return fullBox("mvhd", 0,
                   {zeros(8), u32(track.ticksPerSecond), u32(ticksOf(track)), u32(0x10000), u16(0x100), zeros(10),
                    unityMatrix(), zeros(24), u32(2)});
}

std::string trackHeader(const Mp4Track& track)
{
    constexpr std::uint32_t enabledInMovie = 3;
    return fullBox("tkhd", enabledInMovie,
                   {zeros(8), u32(1), zeros(4), u32(ticksOf(track)), zeros(16), unityMatrix(),
                    u32(static_cast<std::uint64_t>(track.size.width) << 16),
                    u32(static_cast<std::uint64_t>(track.size.height) << 16)});
}

std::string avcConfiguration(const Mp4Track& track)
{
    const std::string profile = track.sequence.substr(1, 3);   // profile, constraint flags and level
    std::string configuration = u8(1) + profile + u8(0xFF) + u8(0xE1) + u16(track.sequence.size()) + track.sequence +
                                u8(1) + u16(track.picture.size()) + track.picture;
    if (static_cast<unsigned char>(profile.front()) >= profilesWithChroma) {
        configuration += u8(0xFD) + u8(0xF8) + u8(0xF8) + u8(0);   // 4:2:0, 8 bits, 8 bits, no further units
    }
    return box("avcC", {configuration});
}

std::string sampleEntry(const Mp4Track& track)
{
    constexpr std::uint32_t dotsPerInch72 = 0x480000;
    constexpr std::uint64_t bt709 = 1;
    return box("avc1",
               {zeros(6), u16(1), zeros(16), u16(static_cast<std::uint64_t>(track.size.width)),
                u16(static_cast<std::uint64_t>(track.size.height)), u32(dotsPerInch72), u32(dotsPerInch72), zeros(4),
                u16(1), zeros(32), u16(0x18), u16(0xFFFF), avcConfiguration(track),
                box("colr", {"nclx", u16(bt709), u16(bt709), u16(bt709), u8(0)}), box("pasp", {u32(1), u32(1)})});
}

std::string timesToSamples(const Mp4Track& track)
{
    std::string rows;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < track.samples.size();) {
        std::size_t end = i;
        while (end < track.samples.size() && track.samples[end].ticks == track.samples[i].ticks) {
            ++end;
        }
        rows += u32(end - i) + u32(track.samples[i].ticks);
        ++count;
        i = end;
    }
    return fullBox("stts", 0, {u32(count), rows});
}

std::string wholeSamples(const Mp4Track& track)
{
    std::string rows;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < track.samples.size(); ++i) {
        if (track.samples[i].isKeyFrame) {
            rows += u32(i + 1);
            ++count;
        }
    }
    return fullBox("stss", 0, {u32(count), rows});
}

std::string sampleSizes(const Mp4Track& track)
{
    std::string rows;
    for (const Mp4Sample& sample : track.samples) {
        rows += u32(sample.bytes);
    }
    return fullBox("stsz", 0, {u32(0), u32(track.samples.size()), rows});
}

/// Describes all samples as one chunk at `offset` in the file.
std::string sampleTable(const Mp4Track& track, std::uint64_t offset)
{
    return box("stbl", {fullBox("stsd", 0, {u32(1), sampleEntry(track)}), timesToSamples(track), wholeSamples(track),
                        fullBox("stsc", 0, {u32(1), u32(1), u32(track.samples.size()), u32(1)}), sampleSizes(track),
                        fullBox("stco", 0, {u32(1), u32(offset)})});
}

std::string media(const Mp4Track& track, std::uint64_t offset)
{
    constexpr std::uint64_t noLanguage = 0x55C4;   // "und" (undetermined), five bits per letter
    const std::string handler = fullBox("hdlr", 0, {zeros(4), "vide", zeros(12), "AngioPose" + zeros(1)});
    const std::string here = fullBox("dref", 0, {u32(1), fullBox("url ", 1, {})});
    return box(
        "mdia",
        {fullBox("mdhd", 0, {zeros(8), u32(track.ticksPerSecond), u32(ticksOf(track)), u16(noLanguage), u16(0)}),
         handler, box("minf", {fullBox("vmhd", 1, {zeros(8)}), box("dinf", {here}), sampleTable(track, offset)})});
}

std::string namedText(std::string_view type, const std::string& text)
{
    constexpr std::uint64_t isText = 1;
    return box(type, {box("data", {u32(isText), u32(0), text})});
}

/// Returns the metadata box with title and comment in the form that players display.
std::string userData(const MovieMetadata& metadata)
{
    std::string comment;
    for (const auto& [key, text] : metadata.texts) {
        comment += (comment.empty() ? "" : "\n") + key + ": " + text;
    }
    const std::string handler = fullBox("hdlr", 0, {zeros(4), "mdirappl", zeros(9)});
    return box("udta",
               {fullBox("meta", 0,
                        {handler, box("ilst", {namedText("\xA9nam", metadata.title), namedText("\xA9too", "AngioPose"),
                                               namedText("\xA9"
                                                         "cmt",
                                                         comment)})})});
}

std::string movieBox(const Mp4Track& track, std::uint64_t offset)
{
    return box("moov",
               {movieHeader(track), box("trak", {trackHeader(track), media(track, offset)}), userData(track.metadata)});
}

/// Returns everything that precedes the samples (ISO/IEC 14496-12 and -15: ftyp, moov, header of mdat), so that the
/// file can be played while it downloads. The samples follow in order, with the length of each NAL unit in four bytes
/// before it. The samples must take less than 4 GB.
std::string mp4Head(const Mp4Track& track)
{
    const std::uint64_t bytes =
        std::accumulate(track.samples.begin(), track.samples.end(), std::uint64_t{0},
                        [](std::uint64_t sum, const Mp4Sample& sample) { return sum + sample.bytes; });
    const std::string type = box("ftyp", {"isom", u32(0x200), "isomiso2avc1mp41"});
    constexpr std::uint64_t mdatHead = 8;
    const std::uint64_t offset =
        type.size() + movieBox(track, 0).size() + mdatHead;   // the size of moov does not depend on the offset
    return type + movieBox(track, offset) + u32(mdatHead + bytes) + "mdat";
}

constexpr std::size_t maxMovieBytes = std::size_t{1} << 30;
constexpr unsigned unitMask = 0x1F;
constexpr unsigned sequenceUnit = 7, pictureUnit = 8;

std::string lengthBytes(std::size_t length)
{
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) {
        text += static_cast<char>((length >> shift) & 0xFF);
    }
    return text;
}

class Mp4Movie : public MovieWriter {
public:
    Mp4Movie(AtomicFile file, H264Encoder encoder, std::string path, Mp4Track track, const MovieSize& size)
        : file_(std::move(file)),
          encoder_(std::move(encoder)),
          path_(std::move(path)),
          track_(std::move(track)),
          size_(size),
          clock_(track_.ticksPerSecond)
    {
    }

    core::Status add(const core::ColorImage& picture, double ms) override;
    core::Status finish() override;

private:
    void take(const EncodedFrame& encoded, std::int64_t from);

    AtomicFile file_;
    H264Encoder encoder_;
    std::string path_;
    Mp4Track track_;
    MovieSize size_;   ///< size of the added images, before padding
    MovieClock clock_;
    double timeMs_ = 0.0;
    std::string samples_;
};

core::Status Mp4Movie::add(const core::ColorImage& picture, double ms)
{
    if (picture.width != size_.width || picture.height != size_.height) {
        return fileError(path_, messages::movieSizesDiffer());
    }
    const auto encoded = encoder_.encode(toYuvImage(picture), timeMs_);
    if (!encoded) {
        return encoded.error().about(path_);
    }
    const std::int64_t from = clock_.now();
    clock_.advance(ms);
    timeMs_ += ms;
    take(encoded.value(), from);
    return samples_.size() <= maxMovieBytes ? core::Status(core::Done{}) : fileError(path_, messages::movieTooLong());
}

/// Stores the parameter sets for the file header, and all other NAL units as a sample.
void Mp4Movie::take(const EncodedFrame& encoded, std::int64_t from)
{
    const std::size_t before = samples_.size();
    for (const std::string& unit : encoded.nalUnits) {
        const unsigned kind = static_cast<unsigned char>(unit.front()) & unitMask;
        if (kind == sequenceUnit) {
            track_.sequence = unit;
        } else if (kind == pictureUnit) {
            track_.picture = unit;
        } else {
            samples_ += lengthBytes(unit.size());
            samples_ += unit;
        }
    }
    const auto ticks = static_cast<std::uint32_t>(clock_.now() - from);
    track_.samples.push_back({samples_.size() - before, ticks, encoded.isKeyFrame});
}

core::Status Mp4Movie::finish()
{
    if (track_.samples.empty() || track_.sequence.size() < 4) {
        return fileError(path_, messages::movieNotMade());
    }
    for (const std::string& part : {mp4Head(track_), samples_}) {
        if (auto written = file_.write(part); !written) {
            return written;
        }
    }
    return file_.commit();
}

}   // namespace

core::Result<std::unique_ptr<MovieWriter>> createMp4(const std::string& path, const MovieSize& size,
                                                     const MovieMetadata& metadata)
{
    auto file = AtomicFile::create(path);
    if (!file) {
        return file.error();
    }
    Mp4Track track;
    track.size = {size.width + size.width % 2, size.height + size.height % 2};
    track.metadata = metadata;
    auto encoder = H264Encoder::create(track.size);
    if (!encoder) {
        return encoder.error().about(path);
    }
    return std::unique_ptr<MovieWriter>(
        std::make_unique<Mp4Movie>(std::move(file).value(), std::move(encoder).value(), path, std::move(track), size));
}

}   // namespace angiopose::io
