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

/// By the end of the path; nothing where it is another.
std::optional<MovieKind> movieKindOf(const std::string& path);

struct MovieSize {
    int width = 0;
    int height = 0;

    bool operator==(const MovieSize&) const = default;
};

/// Why no movie of this kind can be that large; nothing where it can.
std::optional<core::Message> findProblem(MovieKind kind, const MovieSize& size);

/// What a movie says about itself.
struct MovieFacts {
    std::string title;
    std::map<std::string, std::string> texts;   ///< provenance, as PNG text chunks have it
};

/// Writes a movie picture by picture. Until `finish` nothing stands under its path, and without it nothing is left.
class MovieWriter {
public:
    /// Of MP4 or GIF, by the end of the path; all pictures are of one size.
    static core::Result<std::unique_ptr<MovieWriter>> create(const std::string& path, const MovieSize& size,
                                                             const MovieFacts& facts);
    virtual ~MovieWriter() = default;
    MovieWriter(const MovieWriter&) = delete;
    MovieWriter& operator=(const MovieWriter&) = delete;

    /// Shown for `ms`. Rounding does not add up: the n-th picture comes when it should.
    virtual core::Status add(const core::ColorImage& picture, double ms) = 0;
    virtual core::Status finish() = 0;   ///< once, after one picture at least

protected:
    MovieWriter() = default;
};

/// Times of pictures that follow each other, in whole ticks: each is rounded for itself, so that errors do not add up.
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
