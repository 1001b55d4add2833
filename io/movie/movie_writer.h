#pragma once

#include "core/imaging/image2d.h"
#include "core/support/result.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace angiopose::io {

enum class MovieKind { Mp4, Gif };

/// Returns the movie kind that the file extension indicates; nullopt for other extensions.
std::optional<MovieKind> movieKindOf(const std::string& path);

struct MovieSize {
    int width = 0;
    int height = 0;

    bool operator==(const MovieSize&) const = default;
};

/// Explains why a movie of this kind cannot have this size; returns nullopt if it can.
std::optional<core::Message> findProblem(MovieKind kind, const MovieSize& size);

/// Title and provenance stored in a movie file.
struct MovieMetadata {
    std::string title;
    std::map<std::string, std::string> texts;   ///< provenance, with the same keys as PNG text chunks
};

/// Writes a movie image by image. The file appears at its path only after `finish`; otherwise no file is left behind.
class MovieWriter {
public:
    /// Creates a writer for MP4 or GIF, depending on the extension. All images must have the same size.
    static core::Result<std::unique_ptr<MovieWriter>> create(const std::string& path, const MovieSize& size,
                                                             const MovieMetadata& metadata);
    virtual ~MovieWriter() = default;
    MovieWriter(const MovieWriter&) = delete;
    MovieWriter& operator=(const MovieWriter&) = delete;

    /// Adds an image shown for `ms`. Rounding errors do not accumulate: the n-th image appears on time.
    virtual core::Status add(const core::ColorImage& image, double ms) = 0;
    virtual core::Status finish() = 0;   ///< must be called once, after at least one image was added

protected:
    MovieWriter() = default;
};

/// Converts the times of consecutive images to whole ticks. Rounds each time separately, so errors do not accumulate.
class MovieClock {
public:
    explicit MovieClock(double ticksPerSecond) : ticksPerMs_(ticksPerSecond / 1000.0) {}

    std::int64_t now() const { return std::llround(ticksPerMs_ * elapsedMs_); }
    void advance(double ms) { elapsedMs_ += ms; }

private:
    double ticksPerMs_;
    double elapsedMs_ = 0.0;
};

}   // namespace angiopose::io
