#pragma once

#include "core/registration/options/option_fields.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::core {

/// Parses an option value: a number in range, or the name of one of the values.
Result<OptionValue> optionValue(const OptionField& field, const std::string& text);

/// Sets one option from "key=value"; the error names the unknown key or the invalid value.
Status setOption(RegistrationOptions& options, const std::string& assignment);

}   // namespace angiopose::core
