#include "io/deidentify/pseudonyms.h"

#include "io/dicom/new_uid.h"
#include "io/messages/says_deidentify.h"
#include "io/support/numbers.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rand.h>
#include <array>
#include <chrono>
#include <cstdio>

namespace angiopose::io {
namespace {

constexpr std::size_t keyBytes = 32;
constexpr std::string_view rootOfDicom = "1.2.840.10008.";
constexpr int leastWeeks = 52;
constexpr int moreWeeks = 468;

unsigned numberOf(std::string_view bytes)
{
    unsigned number = 0;
    for (const char byte : bytes.substr(0, 4)) {
        number = number << 8U | static_cast<unsigned char>(byte);
    }
    return number;
}

}   // namespace

core::Result<Pseudonyms> Pseudonyms::create()
{
    std::array<unsigned char, keyBytes> bytes{};
    if (RAND_bytes(bytes.data(), keyBytes) != 1) {
        return core::Error(says::noRandomKey());
    }
    return Pseudonyms(std::string(bytes.begin(), bytes.end()));
}

std::string Pseudonyms::digest(std::string_view role, std::string_view original) const
{
    const std::string text = std::string(role) + '\0' + std::string(original);
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned int size = 0;
    HMAC(EVP_sha256(), key_.data(), static_cast<int>(key_.size()), reinterpret_cast<const unsigned char*>(text.data()),
         text.size(), bytes.data(), &size);
    return {reinterpret_cast<const char*>(bytes.data()), size};
}

std::string Pseudonyms::uid(std::string_view original) const
{
    return original.starts_with(rootOfDicom) ? std::string(original) : uidOfContent(digest("uid", original));
}

std::string Pseudonyms::patient(std::string_view original) const
{
    std::array<char, 16> text{};
    const std::string bytes = digest("patient", original);
    std::snprintf(text.data(), text.size(), "P-%08X%02X", numberOf(bytes), numberOf(bytes.substr(4)) & 0xffU);
    return text.data();
}

std::string Pseudonyms::date(std::string_view original, std::string_view patient) const
{
    using namespace std::chrono;
    const auto number = original.size() == 8 ? parseNumber(original) : std::nullopt;
    const int digits = number ? static_cast<int>(*number) : 0;
    const year_month_day date{year(digits / 10000), month(static_cast<unsigned>(digits / 100 % 100)),
                              day(static_cast<unsigned>(digits % 100))};
    if (digits <= 0 || !date.ok()) {
        return {};
    }
    const weeks earlier(leastWeeks + static_cast<int>(numberOf(digest("date", patient)) % moreWeeks));
    const year_month_day shifted(sys_days(date) - earlier);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%04d%02u%02u", static_cast<int>(shifted.year()),
                  static_cast<unsigned>(shifted.month()), static_cast<unsigned>(shifted.day()));
    return text.data();
}

}   // namespace angiopose::io
