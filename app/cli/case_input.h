#pragma once

#include "core/registration_case.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace app {

/// Loads a case, prints its warnings, and moves it to `frame` where one is given.
core::Result<core::RegistrationCase> loadCaseForCommand(const std::string& path, std::optional<int> frame);

/// Value of an option given as text: a number in its range, or one of its choices by name.
core::Result<double> optionValue(const core::OptionField& field, const std::string& text);

}   // namespace app
