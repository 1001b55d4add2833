#include "io/case/fields/option_values.h"

#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace angiopose::io {

std::string optionsJson(const core::RegistrationOptions& options)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const core::OptionField& field : core::optionFields()) {
        const core::OptionValue value = field.read(options);
        const auto* number = std::get_if<double>(&value);
        const std::string key(field.key);
        if (number == nullptr) {
            json[key] = core::nameOf(field, value);
        } else if (*number == std::floor(*number) && std::abs(*number) < 1e9) {
            json[key] = static_cast<int>(*number);
        } else {
            json[key] = *number;
        }
    }
    return json.dump();
}

void readOptions(std::string_view json, core::RegistrationOptions& options, core::Messages& problems)
{
    const nlohmann::json given = nlohmann::json::parse(json);
    for (const core::OptionField& field : core::optionFields()) {
        const nlohmann::json value = given.value(std::string(field.key), nlohmann::json());
        if (value.is_null()) {
            continue;
        }
        const auto number = value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
        const std::string text = value.is_string() ? value.get<std::string>() : std::string();
        if (const auto problem = setOption(options, field, number, text)) {
            problems.push_back(*problem);
        }
    }
}

std::optional<core::Message> setOption(core::RegistrationOptions& options, const core::OptionField& field,
                                       std::optional<double> number, std::string_view text)
{
    if (const auto value = number ? core::valueFrom(field, *number) : core::valueFrom(field, text)) {
        field.write(options, *value);
        return {};
    }
    const std::string key = "options." + std::string(field.key);
    const auto names = core::namesOf(field);
    if (names.empty()) {
        const core::OptionRange range = core::rangeOf(field);
        return messages::caseOptionNumber(core::Quantity{range.min, core::Quantity::significantDigits},
                                          core::Quantity{range.max, core::Quantity::significantDigits})
            .about(key);
    }
    std::vector<std::string> choices;
    for (const std::string_view known : names) {
        choices.push_back("\"" + std::string(known) + "\"");
    }
    return messages::caseOptionChoice(choices).about(key);
}

}   // namespace angiopose::io
