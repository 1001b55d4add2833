#pragma once

#include "core/registration/registration_options.h"

#include <cmath>
#include <type_traits>

// How the rows of the option table are written down.
namespace angiopose::core::option_fields {

using Options = RegistrationOptions;

template <auto Field>
double read(const Options& options)
{
    return static_cast<double>(options.*Field);
}

template <auto Field>
void write(Options& options, double value)
{
    using Value = std::remove_reference_t<decltype(options.*Field)>;
    if constexpr (std::is_integral_v<Value>) {
        options.*Field = static_cast<Value>(std::lround(value));
    } else {
        options.*Field = value;
    }
}

/// A number between two limits.
template <auto Field>
OptionField number(std::string_view key, std::string_view label, std::string_view unit, std::string_view help)
{
    OptionField field;
    field.key = key;
    field.label = label;
    field.unit = unit;
    field.help = help;
    field.read = read<Field>;
    field.write = write<Field>;
    return field;
}

inline OptionField within(OptionField field, double min, double max, int decimals)
{
    field.min = min;
    field.max = max;
    field.decimals = decimals;
    return field;
}

inline OptionField choice(OptionField field, std::vector<std::string_view> choices)
{
    field.max = static_cast<double>(choices.size() - 1);
    field.choices = std::move(choices);
    return field;
}

inline OptionField onlyFor(std::vector<std::string_view> methods, OptionField field)
{
    field.methods = std::move(methods);
    return field;
}

}   // namespace angiopose::core::option_fields