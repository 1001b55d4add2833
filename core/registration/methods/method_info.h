#pragma once

#include "core/registration/options/registration_options.h"
#include "core/support/message.h"

#include <optional>
#include <span>
#include <string_view>

namespace angiopose::core {

/// Description of a method for users.
struct MethodInfo {
    std::string_view id;   ///< identifier used in files, see FORMATS §5
    std::string_view label;   ///< display name: "AngioPose", "DynaWeightPnP", …
    std::string_view summary;   ///< one sentence that states what the method minimizes and its source
};

/// Returns the descriptions of all available methods, the default first.
std::span<const MethodInfo> methodInfos();

/// Returns a message about the first invalid option; nullopt if all are valid.
std::optional<Message> findProblem(const RegistrationOptions& options);

}   // namespace angiopose::core
