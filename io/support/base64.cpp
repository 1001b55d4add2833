#include "io/support/base64.h"

#include <openssl/evp.h>

namespace angiopose::io {

std::string base64(std::string_view bytes)
{
    constexpr std::size_t blockSize = 3 * 65536;   // encode block by block, because the library uses int for sizes
    std::string letters;
    for (std::size_t at = 0; at < bytes.size(); at += blockSize) {
        const std::string_view block = bytes.substr(at, blockSize);
        std::string part((block.size() + 2) / 3 * 4 + 1, '\0');   // including the terminator that the library writes
        const int written =
            EVP_EncodeBlock(reinterpret_cast<unsigned char*>(part.data()),
                            reinterpret_cast<const unsigned char*>(block.data()), static_cast<int>(block.size()));
        letters.append(part, 0, static_cast<std::size_t>(written));
    }
    return letters;
}

}   // namespace angiopose::io
