#include "core/registration/options/option_fields.h"

#include "core/registration/options/option_groups.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace angiopose::core {
namespace {

using namespace option_fields;

const std::array<std::string_view, 2> offOn{"off", "on"};

}   // namespace

const std::vector<OptionField>& optionFields()
{
    static const std::vector<OptionField> fields = [] {
        std::vector<OptionField> all;
        for (const auto make :
             {commonFields, seedFields, alternatingFields, solverFields, geometryFields, icpFields, nicpFields,
              imageFields, globalFields, flowFields, graphFields, wireFields, randomSeedFields}) {
            const std::vector<OptionField> group = make();
            all.insert(all.end(), group.begin(), group.end());
        }
        return all;
    }();
    return fields;
}

const OptionField* findOption(std::string_view key)
{
    const auto found = std::ranges::find(optionFields(), key, &OptionField::key);
    return found == optionFields().end() ? nullptr : &*found;
}

bool appliesTo(const OptionField& field, std::string_view method)
{
    return field.methods.empty() || std::ranges::find(field.methods, method) != field.methods.end();
}

std::span<const std::string_view> namesOf(const OptionField& field)
{
    if (std::holds_alternative<SwitchOption>(field.type)) {
        return offOn;
    }
    const auto* choice = std::get_if<ChoiceOption>(&field.type);
    return choice == nullptr ? std::span<const std::string_view>() : choice->names;
}

std::string_view nameOf(const OptionField& field, const OptionValue& value)
{
    const auto* number = std::get_if<std::size_t>(&value);
    const auto* isOn = std::get_if<bool>(&value);
    const auto names = namesOf(field);
    const std::size_t index = number != nullptr ? *number : isOn != nullptr && *isOn ? 1 : 0;
    return index < names.size() ? names[index] : std::string_view();
}

OptionRange rangeOf(const OptionField& field)
{
    if (const auto* number = std::get_if<NumberOption>(&field.type)) {
        return {number->min, number->max};
    }
    return {0.0, static_cast<double>(namesOf(field).size() - 1)};
}

std::optional<OptionValue> valueFrom(const OptionField& field, double number)
{
    const OptionRange range = rangeOf(field);
    if (!(number >= range.min && number <= range.max)) {
        return {};
    }
    if (std::holds_alternative<NumberOption>(field.type)) {
        return number;
    }
    if (number != std::floor(number)) {
        return {};
    }
    const auto index = static_cast<std::size_t>(number);
    return std::holds_alternative<SwitchOption>(field.type) ? OptionValue(index == 1) : OptionValue(index);
}

std::optional<OptionValue> valueFrom(const OptionField& field, std::string_view name)
{
    const auto names = namesOf(field);
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : valueFrom(field, static_cast<double>(found - names.begin()));
}

bool isInRange(const OptionField& field, const RegistrationOptions& options)
{
    const OptionValue value = field.read(options);
    if (const auto* number = std::get_if<double>(&value)) {
        return valueFrom(field, *number).has_value();
    }
    return !nameOf(field, value).empty();
}

}   // namespace angiopose::core
