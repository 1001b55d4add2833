#pragma once

#include "core/support/message.h"

#include <span>

namespace angiopose::app {

/// Lists all messages of this layer, for translations and tests.
std::span<const core::MessageEntry* const> messageCatalog();

}   // namespace angiopose::app
