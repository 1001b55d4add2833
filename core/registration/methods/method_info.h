#pragma once

#include "core/registration/options/registration_options.h"
#include "core/support/message.h"

#include <optional>
#include <span>
#include <string_view>

namespace angiopose::core {

/// Description of a method for users.
struct MethodInfo {
    std::string_view id;   ///< FORMATS §5
    std::string_view label;   ///< "AngioPose", "DynaWeightPnP", …
    std::string_view summary;   ///< one sentence: what it minimizes, and its source
};

/// All methods that can be run, the default first.
std::span<const MethodInfo> methodInfos();

/// User message about the first invalid setting; nullopt when all are valid.
std::optional<Message> findProblem(const RegistrationOptions& options);

}   // namespace angiopose::core
