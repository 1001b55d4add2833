#include "app/messages/catalog.h"

#include "app/messages/messages.h"

#include <array>

namespace angiopose::app {

std::span<const core::MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const core::MessageEntry*>({
#define MESSAGE(name, id, english) &messages::name,
#include "app/messages/messages.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::app
