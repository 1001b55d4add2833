#include "io/support/read_error.h"

#include "io/messages/says.h"
#include "io/support/system/files.h"

namespace angiopose::io {

std::optional<core::Message> findReadError(const char* mapping, std::size_t size)
{
    const auto fault = faultOfMapping(mapping, size);
    return fault ? std::optional<core::Message>(says::fileNotRead(*fault)) : std::nullopt;
}

}   // namespace angiopose::io
