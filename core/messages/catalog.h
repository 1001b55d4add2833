#pragma once

#include "core/support/message.h"

#include <span>

namespace angiopose::core {

/// Returns every message of this layer, for translations and tests.
std::span<const MessageEntry* const> messageCatalog();

}   // namespace angiopose::core
