#include "core/support/message.h"

#include "core/support/format_number.h"

#include <ostream>

namespace angiopose::core {
namespace {

constexpr MessageEntry verbatimEntry{"text.plain", "%1"};

struct EnglishFormatter {
    std::string operator()(const std::string& text) const { return text; }

    std::string operator()(const Quantity& quantity) const
    {
        const std::string_view unit = quantity.unit;
        const bool isApart = !unit.empty() && unit != "°";
        return (quantity.decimals == Quantity::significantDigits ? plainText(quantity.value)
                                                                 : fixedText(quantity.value, quantity.decimals)) +
               (isApart ? " " : "") + std::string(unit);
    }

    std::string operator()(const std::vector<std::string>& texts) const
    {
        return joinedTexts(texts, [](auto& text) { return text; });
    }

    std::string operator()(const Messages& messages) const
    {
        return joinedTexts(messages, [](const Message& message) { return message.text(); });
    }

private:
    template <class Item, class ToText>
    static std::string joinedTexts(const std::vector<Item>& items, const ToText& toText)
    {
        std::string row;
        for (const Item& item : items) {
            row += (row.empty() ? "" : row.ends_with('.') ? " " : ", ") + toText(item);   // sentences or phrases
        }
        return row;
    }
};

}   // namespace

bool Quantity::operator==(const Quantity& other) const
{
    return value == other.value && decimals == other.decimals && std::string_view(unit) == other.unit;
}

std::string_view toText(Severity severity)
{
    switch (severity) {
        case Severity::Note:
            return "note";
        case Severity::Warning:
            return "warning";
        case Severity::Error:
            break;
    }
    return "error";
}

Message Message::verbatim(std::string words)
{
    return {verbatimEntry, {std::move(words)}};
}

Message Message::as(Severity severity) const
{
    Message copy = *this;
    copy.severity_ = severity;
    return copy;
}

Message Message::about(std::string_view subject) const
{
    Message copy = *this;
    copy.subject_ = std::string(subject) + (subject_.empty() ? "" : ": " + subject_);
    return copy;
}

std::string Message::text() const
{
    std::string sentence = subject_.empty() ? std::string() : subject_ + ": ";
    const std::string_view english = entry_->english;
    for (std::size_t at = 0; at < english.size(); ++at) {
        const std::size_t place = english[at] == '%' && at + 1 < english.size()
                                      ? static_cast<std::size_t>(english[at + 1] - '1')
                                      : arguments_.size();
        if (place < arguments_.size()) {
            sentence += argumentText(arguments_[place]);
            ++at;
        } else {
            sentence += english[at];
        }
    }
    return sentence;
}

std::ostream& operator<<(std::ostream& stream, const Message& message)
{
    return stream << message.text();
}

std::string argumentText(const MessageArgument& argument)
{
    return std::visit(EnglishFormatter(), argument);
}

}   // namespace angiopose::core
