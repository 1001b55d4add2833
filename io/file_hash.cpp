#include "io/file_hash.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <openssl/evp.h>
#include <array>

namespace angiopose::io {

core::Result<std::string> sha256OfText(std::string_view text)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    if (EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
        return core::Error(messages::hashImpossible());
    }
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) {
        hex += digits[digest[i] >> 4];
        hex += digits[digest[i] & 15];
    }
    return hex;
}

core::Result<std::string> sha256OfFile(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const auto hash = sha256OfText(input.value().view());
    return hash ? hash : fileError(path, hash.error());
}

}   // namespace angiopose::io
