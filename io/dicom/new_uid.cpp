#include "io/dicom/new_uid.h"

#include <openssl/evp.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

namespace angiopose::io {
namespace {

using UuidBytes = std::array<std::uint8_t, 16>;

/// Sets version and variant bits of a UUID (RFC 9562). Version 4 is random, version 8 custom.
void setUuidVersion(UuidBytes& uuid, std::uint8_t version)
{
    uuid[6] = static_cast<std::uint8_t>((uuid[6] & 0x0fU) | static_cast<unsigned>(version << 4U));
    uuid[8] = static_cast<std::uint8_t>((uuid[8] & 0x3fU) | 0x80U);
}

/// Converts a 128-bit number to decimal by repeated division by ten; the remainders are the digits from last to first.
std::string decimalOf(UuidBytes number)
{
    std::string digits;
    do {
        unsigned rest = 0;
        for (std::uint8_t& byte : number) {
            const unsigned part = rest * 256U + byte;
            byte = static_cast<std::uint8_t>(part / 10U);
            rest = part % 10U;
        }
        digits += static_cast<char>('0' + rest);
    } while (std::ranges::any_of(number, [](std::uint8_t byte) { return byte != 0; }));
    std::ranges::reverse(digits);
    return digits;
}

std::string uidOf(UuidBytes uuid, std::uint8_t version)
{
    setUuidVersion(uuid, version);
    return "2.25." + decimalOf(uuid);
}

}   // namespace

bool isUid(std::string_view text)
{
    bool isStart = true;   // whether the next character starts a number
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        const bool isLeadingZero = isStart && text[i] == '0' && i + 1 < text.size() && text[i + 1] != '.';
        if (isLeadingZero || (!isDigit && (text[i] != '.' || isStart))) {
            return false;
        }
        isStart = !isDigit;
    }
    return !text.empty() && text.size() <= 64 && !isStart;
}

std::string validUid(const std::string& uid)
{
    return isUid(uid) ? uid : uidFromContent("instead of " + uid);
}

std::string makeUid()
{
    std::random_device source;
    UuidBytes uuid{};
    for (std::uint8_t& byte : uuid) {
        byte = static_cast<std::uint8_t>(source() & 0xffU);
    }
    return uidOf(uuid, 4);
}

std::string uidFromContent(std::string_view content)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr);
    UuidBytes uuid{};
    std::copy_n(digest.begin(), uuid.size(), uuid.begin());
    return uidOf(uuid, 8);
}

}   // namespace angiopose::io
