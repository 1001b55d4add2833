#include "angiopose/error.h"

#include "angiopose/version.h"

namespace angiopose {

Error::Error(std::string id, const std::string& sentence) : std::runtime_error(sentence), id_(std::move(id)) {}
Error::~Error() = default;
Stopped::~Stopped() = default;

const char* version()
{
    return ANGIOPOSE_VERSION;
}

}   // namespace angiopose
