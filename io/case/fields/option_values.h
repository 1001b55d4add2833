#pragma once

#include "core/registration/options/option_fields.h"
#include "core/support/message.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// `{"key": value, …}` over the option table; switches and choices by name.
std::string optionsJson(const core::RegistrationOptions& options);

/// Sets what such a text says; null leaves an option as it is. Adds to `problems` what makes no sense.
void readOptions(std::string_view json, core::RegistrationOptions& options, core::Messages& problems);

/// Sets one option from a number, or from the name of a value. Returns what is wrong, if anything.
std::optional<core::Message> setOption(core::RegistrationOptions& options, const core::OptionField& field,
                                       std::optional<double> number, std::string_view text);

}   // namespace angiopose::io