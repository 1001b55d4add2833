#include "io/support/message_json.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using MessageJson = nlohmann::ordered_json;

MessageJson jsonOf(const core::Message& message);

struct ArgumentJson {
    MessageJson operator()(const std::string& text) const { return text; }
    MessageJson operator()(const std::vector<std::string>& texts) const { return texts; }

    MessageJson operator()(const core::Quantity& quantity) const
    {
        MessageJson json{{"value", quantity.value}};
        if (*quantity.unit != '\0') {
            json["unit"] = quantity.unit;
        }
        return json;
    }

    MessageJson operator()(const core::Messages& messages) const
    {
        MessageJson list = MessageJson::array();
        for (const core::Message& message : messages) {
            list.push_back(jsonOf(message));
        }
        return list;
    }
};

MessageJson jsonOf(const core::Message& message)
{
    MessageJson json{{"id", message.id()}, {"severity", core::toText(message.severity())}, {"text", message.text()}};
    if (!message.subject().empty()) {
        json["subject"] = message.subject();
    }
    json["arguments"] = MessageJson::array();
    for (const core::MessageArgument& argument : message.arguments()) {
        json["arguments"].push_back(std::visit(ArgumentJson(), argument));
    }
    return json;
}

/// Names of files need not be UTF-8.
std::string textOf(const MessageJson& json)
{
    return json.dump(-1, ' ', false, MessageJson::error_handler_t::replace);
}

}   // namespace

std::string messageJson(const core::Message& message)
{
    return textOf(jsonOf(message));
}

std::string messagesJson(const core::Messages& messages)
{
    MessageJson list = MessageJson::array();
    for (const core::Message& message : messages) {
        list.push_back(jsonOf(message));
    }
    return textOf(list);
}

std::vector<std::string> sentencesOf(const core::Messages& messages)
{
    std::vector<std::string> sentences;
    for (const core::Message& message : messages) {
        sentences.push_back(message.text());
    }
    return sentences;
}

}   // namespace angiopose::io
