#include "core/messages/catalog.h"

#include "core/messages/messages.h"

#include <array>

namespace angiopose::core {

std::span<const MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const MessageEntry*>({
#define MESSAGE(name, id, english) &messages::name,
#include "core/messages/messages.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::core
