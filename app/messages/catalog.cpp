#include "app/messages/catalog.h"

#include "app/messages/says.h"
#include "app/messages/says_batch.h"
#include "app/messages/says_dicom.h"
#include "app/messages/says_exchange.h"
#include "app/messages/says_keeping.h"
#include "app/messages/says_own.h"
#include "app/messages/says_report.h"
#include "app/messages/says_starting.h"

#include <array>

namespace angiopose::app {

std::span<const core::MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const core::MessageEntry*>({
#define MESSAGE(name, id, english) &says::name,
#include "app/messages/batch.def"
#include "app/messages/commands.def"
#include "app/messages/dicom.def"
#include "app/messages/exchange.def"
#include "app/messages/keeping.def"
#include "app/messages/own.def"
#include "app/messages/report.def"
#include "app/messages/starting.def"
#include "app/messages/window.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::app
