#include "io/messages/catalog.h"

#include "io/messages/says.h"
#include "io/messages/says_archive.h"
#include "io/messages/says_deidentify.h"
#include "io/messages/says_exchange.h"
#include "io/messages/says_keeping.h"
#include "io/messages/says_objects.h"
#include "io/messages/says_seldom.h"

#include <array>

namespace angiopose::io {

std::span<const core::MessageEntry* const> messageCatalog()
{
    static constexpr auto entries = std::to_array<const core::MessageEntry*>({
#define MESSAGE(name, id, english) &says::name,
#include "io/messages/archive.def"
#include "io/messages/batch.def"
#include "io/messages/case.def"
#include "io/messages/deidentify.def"
#include "io/messages/exchange.def"
#include "io/messages/files.def"
#include "io/messages/images.def"
#include "io/messages/keeping.def"
#include "io/messages/movies.def"
#include "io/messages/objects.def"
#include "io/messages/opening.def"
#include "io/messages/own.def"
#include "io/messages/results.def"
#include "io/messages/study.def"
#include "io/messages/support.def"
#include "io/messages/vessels.def"
#include "io/messages/volumes.def"
#undef MESSAGE
    });
    return entries;
}

}   // namespace angiopose::io
