#pragma once

#include "core/registration/options/registration_options.h"
#include "core/support/message.h"

#include <optional>
#include <span>
#include <string_view>

namespace angiopose::core {

/// A method as users meet it.
struct MethodInfo {
    std::string_view id;   ///< FORMATS §5
    std::string_view label;   ///< "AngioPose", "DynaWeightPnP", …
    std::string_view summary;   ///< one sentence: what it minimises, its source
};

/// Every method that runs, the default first.
std::span<const MethodInfo> methodInfos();

/// The first setting that makes no sense, in words for the user; empty when all do.
std::optional<Message> findProblem(const RegistrationOptions& options);

}   // namespace angiopose::core
