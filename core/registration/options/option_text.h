#pragma once

#include "core/registration/options/option_fields.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::core {

/// Value of an option given as text: a number in its range, or one of its values by name.
Result<OptionValue> optionValue(const OptionField& field, const std::string& text);

/// Sets one option from "key=value"; fails naming the unknown key or the impossible value.
Status setOption(RegistrationOptions& options, const std::string& assignment);

}   // namespace angiopose::core