#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace angiopose::core {

/// A catalog entry: the message id, for programs and translations, and the English sentence with placeholders %1 … for
/// the arguments.
struct MessageEntry {
    const char* id;
    const char* english;
};

class Message;
using Messages = std::vector<Message>;

/// A number in a message. `unit` is appended after a space (but directly if it is "°") and may be empty.
struct Quantity {
    static constexpr int significantDigits = -1;   ///< as many significant digits as needed, at most six

    double value;
    int decimals = 0;
    const char* unit = "";

    bool operator==(const Quantity& other) const;
};

/// Argument for a placeholder: an untranslated string (a name, a word from a file), a number, a list of strings, or a
/// list of messages that are translated.
using MessageArgument = std::variant<std::string, Quantity, std::vector<std::string>, Messages>;

enum class Severity { Note, Warning, Error };

/// Returns "note", "warning" or "error".
std::string_view toText(Severity severity);

/// A message to the user as data: catalog entry, severity and arguments. Created by calling a catalog entry with its
/// arguments: `messages::noSuchBranch(7)`.
class Message {
public:
    Message(const MessageEntry& entry, std::vector<MessageArgument> arguments)
        : entry_(&entry), arguments_(std::move(arguments))
    {
    }
    /// Creates a message from text without a catalog entry, such as a patient's name or a sentence stored by another
    /// version. Its id is `text.plain`.
    static Message verbatim(std::string words);

    const MessageEntry& entry() const { return *entry_; }
    std::string_view id() const { return entry_->id; }
    const std::vector<MessageArgument>& arguments() const { return arguments_; }

    /// Whether the message was created from this entry, with any arguments.
    bool is(const MessageEntry& entry) const { return entry_ == &entry; }

    Severity severity() const { return severity_; }
    Message as(Severity severity) const;

    /// Returns the file, or key in a file, to which the message refers; it precedes the sentence with a colon and may
    /// be empty.
    const std::string& subject() const { return subject_; }
    Message about(std::string_view subject) const;

    /// Returns the English sentence, preceded by the subject if there is one.
    std::string text() const;

    bool operator==(const Message&) const = default;

private:
    const MessageEntry* entry_;
    Severity severity_ = Severity::Warning;
    std::string subject_;
    std::vector<MessageArgument> arguments_;
};

/// Writes the message to a stream, for logs and tests.
std::ostream& operator<<(std::ostream& stream, const Message& message);

/// Returns the English text of one argument: "2.4 mm", "aorta, liver".
std::string argumentText(const MessageArgument& argument);

/// Returns the highest placeholder number in `english`: two for "… %1 of %2 …".
constexpr std::size_t placeholderCount(std::string_view english)
{
    std::size_t places = 0;
    for (std::size_t at = 0; at + 1 < english.size(); ++at) {
        if (english[at] == '%' && english[at + 1] >= '1' && english[at + 1] <= '9') {
            places = std::max(places, static_cast<std::size_t>(english[at + 1] - '0'));
        }
    }
    return places;
}

/// Converts a value to an argument: a string, a number with or without a unit, a message, or a list of strings or
/// messages.
template <class Given>
MessageArgument messageArgument(const Given& given)
{
    if constexpr (std::integral<Given>) {
        return Quantity{static_cast<double>(given)};
    } else if constexpr (std::same_as<Given, Message>) {
        return Messages{given};
    } else if constexpr (std::constructible_from<std::string, Given>) {
        return std::string(given);
    } else {
        return given;
    }
}

/// A catalog entry with a fixed number of arguments; a call with a different number does not compile.
template <std::size_t Places>
struct MessageKind : MessageEntry {
    template <class... Arguments>
    requires(sizeof...(Arguments) == Places) Message operator()(const Arguments&... arguments) const
    {
        return Message(*this, {messageArgument(arguments)...});
    }
};

constexpr Quantity inMm(double value, int decimals)
{
    return {value, decimals, "mm"};
}

}   // namespace angiopose::core
