#include "core/messages/catalog.h"

#include "core/messages/says.h"
#include "core/messages/says_contrast.h"
#include "core/messages/says_exchange.h"

#include <array>

namespace angiopose::core {

std::span<const MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const MessageEntry*>({
#define MESSAGE(name, id, english) &says::name,
#include "core/messages/contrast.def"
#include "core/messages/evaluation.def"
#include "core/messages/exchange.def"
#include "core/messages/geometry.def"
#include "core/messages/measuring.def"
#include "core/messages/registration.def"
#include "core/messages/tracing.def"
#include "core/messages/vessels.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::core
