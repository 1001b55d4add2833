#include "tests/mutants/mutate.h"

#include <zlib.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace angiopose::test {
namespace {

std::size_t placeIn(const std::string& content, core::CounterRandom& random)
{
    // Damage matters most in headers, so half of it is placed in the first kilobyte.
    const std::size_t reach = random.uniform() < 0.5 ? std::min<std::size_t>(content.size(), 1024) : content.size();
    return static_cast<std::size_t>(random.index(static_cast<int>(std::max<std::size_t>(reach, 1))));
}

void flipBits(std::string& content, core::CounterRandom& random)
{
    for (int i = 1 + random.index(8); i > 0; --i) {
        content[placeIn(content, random)] ^= static_cast<char>(1 << random.index(8));
    }
}

void cut(std::string& content, core::CounterRandom& random)
{
    content.resize(placeIn(content, random));
}

/// Overwrites four or eight bytes with a value that is extreme as a length, a float or a double.
void overwriteNumber(std::string& content, core::CounterRandom& random)
{
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    const std::array<std::string, 7> extremes = {
        std::string("\xff\xff\xff\xff"),
        std::string("\xff\xff\xff\x7f"),
        std::string("\x00\x00\x00\x80", 4),
        std::string("\x00\x00\x00\x00", 4),
        std::string("\x7f\xff\xff\xff"),
        std::string("\x00\x00\xc0\x7f", 4),
        std::string(reinterpret_cast<const char*>(&notANumber), sizeof notANumber)};
    const std::string& bytes = extremes[static_cast<std::size_t>(random.index(static_cast<int>(extremes.size())))];
    std::size_t at = placeIn(content, random);
    at -= random.uniform() < 0.7 ? at % 4 : 0;
    content.replace(at, std::min(bytes.size(), content.size() - at), bytes);
}

/// Replaces a number in the text by an extreme one.
void rewriteText(std::string& content, core::CounterRandom& random)
{
    constexpr std::array words = {"4294967295", "2147483647",          "-1", "0", "1e30", "1000000", "nan",
                                  "inf",        "99999999999999999999"};
    std::size_t at = placeIn(content, random);
    while (at < content.size() && std::isdigit(static_cast<unsigned char>(content[at])) == 0) {
        ++at;
    }
    std::size_t end = at;
    while (end < content.size() && std::isdigit(static_cast<unsigned char>(content[end])) != 0) {
        ++end;
    }
    content.replace(at, end - at, words[static_cast<std::size_t>(random.index(static_cast<int>(words.size())))]);
}

void repeatPiece(std::string& content, core::CounterRandom& random)
{
    const std::size_t at = placeIn(content, random);
    const std::string piece = content.substr(at, 1 + static_cast<std::size_t>(random.index(64)));
    std::string many;
    for (int i = 1 << random.index(16); i > 0; --i) {   // up to 32768 times: deep nesting or an endless list
        many += piece;
    }
    content.insert(at, many);
}

/// Inserts deeply nested DICOM sequences of undefined length, which are noise to every other format.
void nestDeeply(std::string& content, core::CounterRandom& random)
{
    const std::string level("\x08\x00\x40\x11SQ\x00\x00\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff", 20);
    std::string levels;
    for (int i = 8 << random.index(15); i > 0; --i) {
        levels += level;
    }
    content.insert(std::min<std::size_t>(content.size(), random.uniform() < 0.5 ? 336 : placeIn(content, random)),
                   levels);
}

}   // namespace

std::string mutated(const std::string& content, core::CounterRandom& random)
{
    std::string damaged = content;
    for (int i = 1 + random.index(3); i > 0 && !damaged.empty(); --i) {
        const double kind = random.uniform();
        if (kind < 0.3) {
            flipBits(damaged, random);
        } else if (kind < 0.4) {
            cut(damaged, random);
        } else if (kind < 0.65) {
            overwriteNumber(damaged, random);
        } else if (kind < 0.88) {
            rewriteText(damaged, random);
        } else if (kind < 0.95) {
            repeatPiece(damaged, random);
        } else {
            nestDeeply(damaged, random);
        }
    }
    return damaged;
}

std::string mutatedPng(const std::string& content, core::CounterRandom& random)
{
    constexpr std::size_t signature = 8;
    constexpr std::size_t frame = 12;   // length, type and checksum of a chunk
    std::string damaged = mutated(content, random);
    const auto numberAt = [&](std::size_t at) {
        std::size_t number = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            number = number << 8U | static_cast<unsigned char>(damaged[at + i]);
        }
        return number;
    };
    const bool isRepaired = random.uniform() < 0.5;
    for (std::size_t at = signature; isRepaired && at + frame <= damaged.size();) {
        const std::size_t length = numberAt(at);
        if (length > damaged.size() - at - frame) {
            break;
        }
        const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(damaged.data() + at + 4), length + 4);
        for (std::size_t i = 0; i < 4; ++i) {
            damaged[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
        }
        at += length + frame;
    }
    return damaged;
}

std::string gzipped(const std::string& content)
{
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, static_cast<uLong>(content.size())) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(packed.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
}

std::string mutatedGzip(const std::string& content, core::CounterRandom& random)
{
    const double kind = random.uniform();
    if (kind < 0.2) {
        return mutated(gzipped(content), random);
    }
    std::string damaged = mutated(content, random);
    if (kind < 0.24) {   // a decompression bomb: 64 MB of zeros in 64 kB
        damaged += std::string(std::size_t{64} << 20, '\0');
    }
    return gzipped(damaged);
}

}   // namespace angiopose::test
