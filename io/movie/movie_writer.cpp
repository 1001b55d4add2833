#include "io/movie/movie_writer.h"

#include "io/messages/messages.h"
#include "io/movie/gif_palette.h"
#include "io/movie/mp4_movie.h"
#include "io/movie/yuv_image.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <gif_lib.h>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

constexpr int maxGifSidePx = 8192;   ///< the format permits 65,535, more than any display can show
constexpr int minMovieSidePx = 16;
constexpr double ticksPerSecond = 100.0;
constexpr std::int64_t minDelay = 2;   // viewers replace shorter delays by 0.1 s
constexpr std::int64_t maxDelay = 65535;
constexpr int paletteSize = 256;

/// Rectangle in which an image differs from the previous one, px.
struct Part {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Closes a GIF file that giflib writes through a callback.
struct GifCloser {
    void operator()(GifFileType* file) const { EGifCloseFile(file, nullptr); }
};

struct MapCloser {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

bool isSamePixel(const std::uint8_t* a, const std::uint8_t* b)
{
    return std::equal(a, a + 3, b);
}

Part changedPart(const core::ColorImage& before, const core::ColorImage& now)
{
    int left = now.width, right = -1, top = now.height, bottom = -1;
    for (int y = 0; y < now.height; ++y) {
        const std::size_t row = 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(now.width);
        for (int x = 0; x < now.width; ++x) {
            const std::size_t at = row + 3 * static_cast<std::size_t>(x);
            if (!isSamePixel(&before.rgb[at], &now.rgb[at])) {
                left = std::min(left, x);
                right = std::max(right, x);
                top = std::min(top, y);
                bottom = y;
            }
        }
    }
    return right < 0 ? Part{} : Part{left, top, right - left + 1, bottom - top + 1};
}

std::unique_ptr<ColorMapObject, MapCloser> mapOf(const GifPalette& palette)
{
    std::unique_ptr<ColorMapObject, MapCloser> map(GifMakeMapObject(paletteSize, nullptr));
    for (std::size_t i = 0; map && i < palette.colors().size(); ++i) {
        const auto& [red, green, blue] = palette.colors()[i];
        map->Colors[i] = {red, green, blue};
    }
    return map;
}

class GifMovie : public MovieWriter {
public:
    GifMovie(AtomicFile file, std::string path, const MovieSize& size)
        : file_(std::move(file)), path_(std::move(path)), size_(size)
    {
        int error = 0;
        gif_.reset(EGifOpen(this, &GifMovie::write, &error));
    }

    core::Status begin(const MovieMetadata& metadata);
    core::Status add(const core::ColorImage& image, double ms) override;
    core::Status finish() override;

private:
    static int write(GifFileType* gif, const GifByteType* bytes, int count);
    bool writeHead(const MovieMetadata& metadata);
    bool putWaiting(std::int64_t until);
    bool putPixels(const Part& part, GifPalette& palette, bool isFirst);
    core::Status statusOf(bool isWritten) const
    {
        return isWritten  ? core::Status(core::Done{})
               : written_ ? core::Status(fileError(path_, messages::movieNotMade()))
                          : written_;
    }

    AtomicFile file_;
    std::string path_;
    MovieSize size_;
    core::Status written_ = core::Done{};   ///< status of the writes of giflib's output to the file
    MovieClock clock_{ticksPerSecond};
    std::int64_t waitingFrom_ = 0;
    core::ColorImage
        pendingImage_;   ///< image not written yet, because its delay is known only when the next image arrives
    core::ColorImage writtenImage_;   ///< last image written to the file
    core::ColorImage skippedImage_;   ///< image that arrived less than the minimum delay after the pending image
    std::unique_ptr<GifFileType, GifCloser> gif_;   ///< destroyed first, since that writes the trailer
};

int GifMovie::write(GifFileType* gif, const GifByteType* bytes, int count)
{
    auto& movie = *static_cast<GifMovie*>(gif->UserData);
    if (movie.written_) {
        movie.written_ = movie.file_.write({reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count)});
    }
    return movie.written_ ? count : 0;
}

core::Status GifMovie::begin(const MovieMetadata& metadata)
{
    return statusOf(gif_ && writeHead(metadata));
}

bool GifMovie::writeHead(const MovieMetadata& metadata)
{
    EGifSetGifVersion(gif_.get(), true);
    constexpr unsigned char forEver[]{1, 0, 0};
    std::string comment = metadata.title;
    for (const auto& [key, text] : metadata.texts) {
        comment += "\n" + key + ": " + text;
    }
    return EGifPutScreenDesc(gif_.get(), size_.width, size_.height, 8, 0, nullptr) == GIF_OK &&
           EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(gif_.get(), 11, "NETSCAPE2.0") == GIF_OK &&
           EGifPutExtensionBlock(gif_.get(), sizeof(forEver), forEver) == GIF_OK &&
           EGifPutExtensionTrailer(gif_.get()) == GIF_OK && EGifPutComment(gif_.get(), comment.c_str()) == GIF_OK;
}

core::Status GifMovie::add(const core::ColorImage& image, double ms)
{
    if (image.width != size_.width || image.height != size_.height) {
        return fileError(path_, messages::movieSizesDiffer());
    }
    const std::int64_t from = clock_.now();
    clock_.advance(ms);
    if (pendingImage_.rgb.empty()) {
        pendingImage_ = image;
        return core::Done{};
    }
    if (pendingImage_.rgb == image.rgb) {
        skippedImage_ = {};
        return core::Done{};   // identical to the pending image, which is shown longer instead
    }
    if (from - waitingFrom_ < minDelay) {
        skippedImage_ = image;   // written only if no other image follows
        return core::Done{};
    }
    skippedImage_ = {};
    const bool isWritten = putWaiting(from);
    writtenImage_ = std::exchange(pendingImage_, image);
    waitingFrom_ = from;
    return statusOf(isWritten);
}

bool GifMovie::putWaiting(std::int64_t until)
{
    const bool isFirst = writtenImage_.rgb.empty();
    const Part part = isFirst ? Part{0, 0, size_.width, size_.height} : changedPart(writtenImage_, pendingImage_);
    GifPalette palette(pendingImage_);
    const auto map = mapOf(palette);
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(std::clamp(until - waitingFrom_, minDelay, maxDelay));
    control.TransparentColor = isFirst ? NO_TRANSPARENT_COLOR : GifPalette::unchangedIndex;
    GifByteType extension[4];
    const auto length = static_cast<int>(EGifGCBToExtension(&control, extension));
    return map && EGifPutExtension(gif_.get(), GRAPHICS_EXT_FUNC_CODE, length, extension) == GIF_OK &&
           EGifPutImageDesc(gif_.get(), part.left, part.top, part.width, part.height, false, map.get()) == GIF_OK &&
           putPixels(part, palette, isFirst);
}

bool GifMovie::putPixels(const Part& part, GifPalette& palette, bool isFirst)
{
    std::vector<GifPixelType> line(static_cast<std::size_t>(part.width));
    for (int y = part.top; y < part.top + part.height; ++y) {
        for (int x = 0; x < part.width; ++x) {
            const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                                        static_cast<std::size_t>(part.left + x));
            const std::uint8_t* now = &pendingImage_.rgb[at];
            line[static_cast<std::size_t>(x)] = !isFirst && isSamePixel(&writtenImage_.rgb[at], now)
                                                    ? GifPalette::unchangedIndex
                                                    : palette.indexOf({now[0], now[1], now[2]});
        }
        if (EGifPutLine(gif_.get(), line.data(), part.width) != GIF_OK) {
            return false;
        }
    }
    return true;
}

core::Status GifMovie::finish()
{
    if (pendingImage_.rgb.empty()) {
        return fileError(path_, messages::movieNotMade());
    }
    if (!skippedImage_.rgb.empty()) {   // never drop the last image
        const std::int64_t from = waitingFrom_ + minDelay;
        if (!putWaiting(from)) {
            return statusOf(false);
        }
        writtenImage_ = std::exchange(pendingImage_, std::move(skippedImage_));
        waitingFrom_ = from;
    }
    if (!putWaiting(clock_.now()) || EGifCloseFile(gif_.release(), nullptr) != GIF_OK) {
        return statusOf(false);
    }
    return file_.commit();
}

/// Creates a GIF through giflib, with an endless loop, delays in multiples of 1/100 s and a local palette for each
/// image; stores only the region that differs from the previous image.
core::Result<std::unique_ptr<MovieWriter>> createGif(const std::string& path, const MovieSize& size,
                                                     const MovieMetadata& metadata)
{
    auto file = AtomicFile::create(path);
    if (!file) {
        return file.error();
    }
    auto movie = std::make_unique<GifMovie>(std::move(file).value(), path, size);
    if (auto begun = movie->begin(metadata); !begun) {
        return begun.error();
    }
    return std::unique_ptr<MovieWriter>(std::move(movie));
}

}   // namespace

std::optional<MovieKind> movieKindOf(const std::string& path)
{
    std::string end = std::filesystem::path(path).extension().string();
    std::ranges::transform(end, end.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return end == ".mp4" ? std::optional(MovieKind::Mp4) : end == ".gif" ? std::optional(MovieKind::Gif) : std::nullopt;
}

std::optional<core::Message> findProblem(MovieKind kind, const MovieSize& size)
{
    if (size.width < minMovieSidePx || size.height < minMovieSidePx) {
        return messages::movieTooSmall(minMovieSidePx);
    }
    if (kind == MovieKind::Mp4) {
        return canEncode(size) ? std::nullopt
                               : std::optional<core::Message>(messages::movieTooLarge(size.width, size.height));
    }
    return std::max(size.width, size.height) <= maxGifSidePx
               ? std::nullopt
               : std::optional<core::Message>(messages::gifTooLarge(size.width, size.height, maxGifSidePx));
}

core::Result<std::unique_ptr<MovieWriter>> MovieWriter::create(const std::string& path, const MovieSize& size,
                                                               const MovieMetadata& metadata)
{
    const auto kind = movieKindOf(path);
    if (!kind) {
        return fileError(path, messages::movieKindUnknown());
    }
    if (const auto problem = findProblem(*kind, size)) {
        return fileError(path, *problem);
    }
    return *kind == MovieKind::Gif ? createGif(path, size, metadata) : createMp4(path, size, metadata);
}

}   // namespace angiopose::io
