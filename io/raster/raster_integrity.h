#pragma once

#include "core/support/message.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// What shows that a PNG or JPEG is damaged or cut short; nothing when it is whole. The libraries would fill
/// what is missing with grey.
std::optional<core::Message> findRasterDamage(std::string_view content);

}   // namespace angiopose::io