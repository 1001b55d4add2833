#include "io/messages/catalog.h"

#include "io/messages/messages.h"

#include <array>

namespace angiopose::io {

std::span<const core::MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const core::MessageEntry*>({
#define MESSAGE(name, id, english) &messages::name,
#include "io/messages/messages.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::io
