#include "io/movie/mp4_movie.h"

#include "io/messages/says.h"
#include "io/movie/h264_encoder.h"
#include "io/movie/movie_clock.h"
#include "io/movie/mp4_file.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t mostMovieBytes = std::size_t{1} << 30;
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
    void take(const EncodedPicture& encoded, std::int64_t from);

    AtomicFile file_;
    H264Encoder encoder_;
    std::string path_;
    Mp4Track track_;
    MovieSize size_;   ///< as the pictures come
    MovieClock clock_;
    double atMs_ = 0.0;
    std::string samples_;
};

core::Status Mp4Movie::add(const core::ColorImage& picture, double ms)
{
    if (picture.width != size_.width || picture.height != size_.height) {
        return fileError(path_, says::movieSizesDiffer());
    }
    const auto encoded = encoder_.encode(planarPicture(picture), atMs_);
    if (!encoded) {
        return encoded.error().about(path_);
    }
    const std::int64_t from = clock_.now();
    clock_.advance(ms);
    atMs_ += ms;
    take(encoded.value(), from);
    return samples_.size() <= mostMovieBytes ? core::Status(core::Done{}) : fileError(path_, says::movieTooLong());
}

/// Parameters go into the head of the file, all else is the sample.
void Mp4Movie::take(const EncodedPicture& encoded, std::int64_t from)
{
    const std::size_t before = samples_.size();
    for (const std::string& unit : encoded.units) {
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
    track_.samples.push_back({samples_.size() - before, ticks, encoded.isWhole});
}

core::Status Mp4Movie::finish()
{
    if (track_.samples.empty() || track_.sequence.size() < 4) {
        return fileError(path_, says::movieNotMade());
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
                                                     const MovieFacts& facts)
{
    auto file = AtomicFile::create(path);
    if (!file) {
        return file.error();
    }
    Mp4Track track;
    track.size = {size.width + size.width % 2, size.height + size.height % 2};
    track.facts = facts;
    auto encoder = H264Encoder::create(track.size);
    if (!encoder) {
        return encoder.error().about(path);
    }
    return std::unique_ptr<MovieWriter>(
        std::make_unique<Mp4Movie>(std::move(file).value(), std::move(encoder).value(), path, std::move(track), size));
}

}   // namespace angiopose::io
