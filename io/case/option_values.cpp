#include "io/case/option_values.h"

#include "io/messages/says.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace angiopose::io {

std::string optionsJson(const core::RegistrationOptions& options)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const core::OptionField& field : core::optionFields()) {
        const double value = field.read(options);
        const auto choice = static_cast<std::size_t>(value);
        if (!field.choices.empty() && value >= 0.0 && choice < field.choices.size()) {
            json[std::string(field.key)] = field.choices[choice];
        } else if (value == std::floor(value) && std::abs(value) < 1e9) {
            json[std::string(field.key)] = static_cast<int>(value);
        } else {
            json[std::string(field.key)] = value;
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
    const auto choice = std::find(field.choices.begin(), field.choices.end(), text);
    if (!number && choice != field.choices.end()) {
        number = static_cast<double>(choice - field.choices.begin());
    }
    if (number && *number >= field.min && *number <= field.max) {
        field.write(options, *number);
        return {};
    }
    const std::string key = "options." + std::string(field.key);
    if (field.choices.empty()) {
        return says::caseOptionNumber(core::Quantity{field.min, core::Quantity::asNeeded},
                                      core::Quantity{field.max, core::Quantity::asNeeded})
            .about(key);
    }
    std::vector<std::string> choices;
    for (const std::string_view known : field.choices) {
        choices.push_back("\"" + std::string(known) + "\"");
    }
    return says::caseOptionChoice(choices).about(key);
}

}   // namespace angiopose::io