#pragma once

#include "core/registration/options/option_fields.h"
#include "core/support/message.h"

#include <optional>
#include <string>
#include <string_view>

namespace angiopose::io {

/// Returns `{"key": value, …}` for all rows of the option table; switches and choices by name.
std::string optionsJson(const core::RegistrationOptions& options);

/// Sets options from text in this format; null leaves an option unchanged. Adds invalid values to `problems`.
void readOptions(std::string_view json, core::RegistrationOptions& options, core::Messages& problems);

/// Sets one option from a number or the name of a choice. Returns the problem, if any.
std::optional<core::Message> setOption(core::RegistrationOptions& options, const core::OptionField& field,
                                       std::optional<double> number, std::string_view text);

}   // namespace angiopose::io
