#include "core/registration/option_text.h"

#include "core/support/format_number.h"

#include <algorithm>
#include <charconv>

namespace angiopose::core {

Result<double> optionValue(const OptionField& field, const std::string& text)
{
    const auto choice = std::find(field.choices.begin(), field.choices.end(), text);
    if (choice != field.choices.end()) {
        return static_cast<double>(choice - field.choices.begin());
    }
    double value = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) {
        return Error{"Option '" + std::string(field.key) + "' needs a value, not '" + text + "'."};
    }
    if (!(value >= field.min && value <= field.max)) {
        return Error{"Option '" + std::string(field.key) + "' must lie between " + plainText(field.min) + " and " +
                     plainText(field.max) + ", not " + text + "."};
    }
    return value;
}

Status setOption(RegistrationOptions& options, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    const std::string key = assignment.substr(0, equals);
    for (const OptionField& field : optionFields()) {
        if (field.key != key) {
            continue;
        }
        const auto value = optionValue(field, equals == std::string::npos ? "" : assignment.substr(equals + 1));
        if (!value) {
            return value.error();
        }
        field.write(options, value.value());
        return Done{};
    }
    return Error{"Option '" + key + "' is unknown. See the options in: angiopose-cli register --help"};
}

}   // namespace angiopose::core