#include "core/registration/options/option_text.h"

#include "core/messages/messages.h"

#include <charconv>

namespace angiopose::core {
namespace {

/// Whether the option stores the number exactly; integer options would round the number.
bool storesExactly(const OptionField& field, const OptionValue& number)
{
    RegistrationOptions kept;
    field.write(kept, number);
    return field.read(kept) == number;
}

Message invalidValueMessage(const OptionField& field, const std::string& text)
{
    const auto names = namesOf(field);
    if (!names.empty()) {
        return messages::optionNeedsChoice(field.key, std::vector<std::string>(names.begin(), names.end()), text);
    }
    return messages::optionNeedsValue(field.key, text);
}

}   // namespace

Result<OptionValue> optionValue(const OptionField& field, const std::string& text)
{
    if (const auto named = valueFrom(field, text)) {
        return *named;
    }
    double number = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size()) {
        return Error(invalidValueMessage(field, text));
    }
    if (const auto value = valueFrom(field, number)) {
        return storesExactly(field, *value) ? Result<OptionValue>(*value)
                                            : Error(messages::optionNeedsWholeNumber(field.key, text));
    }
    const OptionRange range = rangeOf(field);
    return Error(messages::optionValueOutOfRange(field.key, Quantity{range.min, Quantity::significantDigits},
                                                 Quantity{range.max, Quantity::significantDigits}, text));
}

Status setOption(RegistrationOptions& options, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    const std::string key = assignment.substr(0, equals);
    const OptionField* field = findOption(key);
    if (field == nullptr) {
        return Error(messages::noSuchOption(key));
    }
    const auto value = optionValue(*field, equals == std::string::npos ? "" : assignment.substr(equals + 1));
    if (!value) {
        return value.error();
    }
    field->write(options, value.value());
    return Done{};
}

}   // namespace angiopose::core
