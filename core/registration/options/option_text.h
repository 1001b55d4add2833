#pragma once

#include "core/registration/options/option_fields.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::core {

/// Parses the text of an option: a number in its range, or the name of one of its values.
Result<OptionValue> optionValue(const OptionField& field, const std::string& text);

/// Sets one option from "key=value"; fails with a message that names the unknown key or the invalid value.
Status setOption(RegistrationOptions& options, const std::string& assignment);

}   // namespace angiopose::core