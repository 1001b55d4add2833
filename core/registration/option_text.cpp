#include "core/registration/option_text.h"

#include "core/messages/says.h"

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
        return Error(says::optionNeedsValue(field.key, text));
    }
    if (!(value >= field.min && value <= field.max)) {
        return Error(says::optionValueOutOfRange(field.key, Quantity{field.min, Quantity::asNeeded},
                                                 Quantity{field.max, Quantity::asNeeded}, text));
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
    return Error(says::noSuchOption(key));
}

}   // namespace angiopose::core