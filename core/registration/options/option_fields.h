#pragma once

#include "core/registration/options/registration_options.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace angiopose::core {

/// Option with the values "off" and "on".
struct SwitchOption {};

/// Option with several named values, in the order of the underlying enumeration.
struct ChoiceOption {
    std::vector<std::string_view> names;
};

struct NumberOption {
    std::string_view unit;   ///< "px", "mm", "°" or empty
    double min = 0.0;
    double max = 0.0;
    int decimals = 0;   ///< number of decimals; 0 for integers
};

using OptionType = std::variant<SwitchOption, ChoiceOption, NumberOption>;

/// Value of an option: of a switch, of a choice (its index) or of a number.
using OptionValue = std::variant<bool, std::size_t, double>;

/// Description of one option; panel, help, range check, command line and case file iterate over the table of options.
struct OptionField {
    std::string_view key;   ///< used in files and on the command line
    std::string_view label;   ///< label in the user interface
    std::string_view help;   ///< one sentence about the effect of the option
    OptionType type;
    std::vector<std::string_view> methods;   ///< ids of the methods that use the option; empty for all methods
    OptionValue (*read)(const RegistrationOptions&) = nullptr;
    void (*write)(RegistrationOptions&, const OptionValue&) = nullptr;   ///< expects a value of the option's type
};

/// Returns all options of all methods.
const std::vector<OptionField>& optionFields();

/// Returns the option with this key, or null.
const OptionField* findOption(std::string_view key);

bool appliesTo(const OptionField& field, std::string_view method);

/// Returns the names of the values of a switch or choice; empty for numbers.
std::span<const std::string_view> namesOf(const OptionField& field);

/// Returns the name of a value; empty for numbers.
std::string_view nameOf(const OptionField& field, const OptionValue& value);

/// Allowed range of a number, or of the value index of a switch or choice, starting at 0.
struct OptionRange {
    double min = 0.0;
    double max = 0.0;
};
OptionRange rangeOf(const OptionField& field);

/// Converts a number, or the name of a value, to an option value; nullopt if the option has no such value.
std::optional<OptionValue> valueFrom(const OptionField& field, double number);
std::optional<OptionValue> valueFrom(const OptionField& field, std::string_view name);

/// Whether the options hold a valid value for this field.
bool isInRange(const OptionField& field, const RegistrationOptions& options);

}   // namespace angiopose::core
