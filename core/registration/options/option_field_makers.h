#pragma once

#include "core/registration/options/option_fields.h"

#include <cmath>
#include <type_traits>

// Helpers that create the rows of the option table.
namespace angiopose::core::option_fields {

using Options = RegistrationOptions;

/// Returns the member at the end of a chain of member pointers.
template <auto First, auto... Rest, class Object>
auto& at(Object& object)
{
    if constexpr (sizeof...(Rest) == 0) {
        return object.*First;
    } else {
        return at<Rest...>(object.*First);
    }
}

template <auto... Path>
using ValueAt = std::remove_reference_t<decltype(at<Path...>(std::declval<Options&>()))>;

template <auto... Path>
OptionValue read(const Options& options)
{
    const auto value = at<Path...>(options);
    if constexpr (std::is_same_v<ValueAt<Path...>, bool>) {
        return value;
    } else if constexpr (std::is_enum_v<ValueAt<Path...>>) {
        return static_cast<std::size_t>(value);
    } else {
        return static_cast<double>(value);
    }
}

template <auto... Path>
void write(Options& options, const OptionValue& value)
{
    using Value = ValueAt<Path...>;
    if constexpr (std::is_same_v<Value, bool>) {
        at<Path...>(options) = std::get<bool>(value);
    } else if constexpr (std::is_enum_v<Value>) {
        at<Path...>(options) = static_cast<Value>(std::get<std::size_t>(value));
    } else if constexpr (std::is_integral_v<Value>) {
        at<Path...>(options) = static_cast<Value>(std::lround(std::get<double>(value)));
    } else {
        at<Path...>(options) = std::get<double>(value);
    }
}

/// Key, label and help text of an option.
struct OptionText {
    std::string_view key, label, help;
};

template <auto... Path>
OptionField row(const OptionText& text, OptionType type)
{
    return {text.key, text.label, text.help, std::move(type), {}, read<Path...>, write<Path...>};
}

template <auto... Path>
OptionField toggle(const OptionText& text)
{
    static_assert(std::is_same_v<ValueAt<Path...>, bool>);
    return row<Path...>(text, SwitchOption{});
}

template <auto... Path>
OptionField choice(const OptionText& text, std::vector<std::string_view> names)
{
    static_assert(std::is_enum_v<ValueAt<Path...>>);
    return row<Path...>(text, ChoiceOption{std::move(names)});
}

template <auto... Path>
OptionField number(const OptionText& text, const NumberOption& number)
{
    static_assert(std::is_same_v<ValueAt<Path...>, double>);
    return row<Path...>(text, number);
}

template <auto... Path>
OptionField count(const OptionText& text, int min, int max)
{
    static_assert(std::is_same_v<ValueAt<Path...>, int>);
    return row<Path...>(text, NumberOption{"", static_cast<double>(min), static_cast<double>(max), 0});
}

inline OptionField onlyFor(std::vector<std::string_view> methods, OptionField field)
{
    field.methods = std::move(methods);
    return field;
}

}   // namespace angiopose::core::option_fields
