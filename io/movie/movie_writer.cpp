#include "io/movie/movie_writer.h"

#include "io/messages/messages.h"
#include "io/movie/gif_movie.h"
#include "io/movie/mp4_movie.h"
#include "io/movie/yuv_image.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace angiopose::io {

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
                                                               const MovieMetadata& facts)
{
    const auto kind = movieKindOf(path);
    if (!kind) {
        return fileError(path, messages::movieKindUnknown());
    }
    if (const auto problem = findProblem(*kind, size)) {
        return fileError(path, *problem);
    }
    return *kind == MovieKind::Gif ? createGif(path, size, facts) : createMp4(path, size, facts);
}

}   // namespace angiopose::io
