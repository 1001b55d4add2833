#pragma once

#include "core/registration/options/registration_options.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace angiopose::core {

/// "off" or "on".
struct SwitchOption {};

/// One of some names, in the order of the enumeration behind it.
struct ChoiceOption {
    std::vector<std::string_view> names;
};

struct NumberOption {
    std::string_view unit;   ///< "px", "mm", "°" or empty
    double min = 0.0;
    double max = 0.0;
    int decimals = 0;   ///< 0: whole numbers
};

using OptionType = std::variant<SwitchOption, ChoiceOption, NumberOption>;

/// Of a switch, a choice (its number), a number.
using OptionValue = std::variant<bool, std::size_t, double>;

/// One option described once: panel, help, range check, command line and case file loop over the table.
struct OptionField {
    std::string_view key;   ///< in files and on the command line
    std::string_view label;   ///< in the window
    std::string_view help;   ///< the effect, one sentence
    OptionType type;
    std::vector<std::string_view> methods;   ///< ids it applies to; empty: all
    OptionValue (*read)(const RegistrationOptions&) = nullptr;
    void (*write)(RegistrationOptions&, const OptionValue&) = nullptr;   ///< a value of its type
};

/// Every option of every method.
const std::vector<OptionField>& optionFields();

/// The option with this key, or null.
const OptionField* findOption(std::string_view key);

bool isFor(const OptionField& field, std::string_view method);

/// What the values of switches and choices are called; empty for numbers.
std::span<const std::string_view> namesOf(const OptionField& field);

/// The name of a value; empty for numbers.
std::string_view nameOf(const OptionField& field, const OptionValue& value);

/// Its limits; switches and choices are also known by number, from 0.
struct OptionRange {
    double min = 0.0;
    double max = 0.0;
};
OptionRange rangeOf(const OptionField& field);

/// Nothing when the field has no such value.
std::optional<OptionValue> valueFrom(const OptionField& field, double number);
std::optional<OptionValue> valueFrom(const OptionField& field, std::string_view name);

/// Whether the options hold a value that the field may have.
bool isInRange(const OptionField& field, const RegistrationOptions& options);

}   // namespace angiopose::core
