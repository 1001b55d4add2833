#include "io/support/message_json.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const core::Message& message);

struct ArgumentJson {
    Json operator()(const std::string& text) const { return text; }
    Json operator()(const std::vector<std::string>& texts) const { return texts; }

    Json operator()(const core::Quantity& quantity) const
    {
        Json json{{"value", quantity.value}};
        if (*quantity.unit != '\0') {
            json["unit"] = quantity.unit;
        }
        return json;
    }

    Json operator()(const core::Messages& messages) const
    {
        Json list = Json::array();
        for (const core::Message& message : messages) {
            list.push_back(jsonOf(message));
        }
        return list;
    }
};

Json jsonOf(const core::Message& message)
{
    Json json{{"id", message.id()}, {"severity", core::toText(message.severity())}, {"text", message.text()}};
    if (!message.subject().empty()) {
        json["subject"] = message.subject();
    }
    json["arguments"] = Json::array();
    for (const core::MessageArgument& argument : message.arguments()) {
        json["arguments"].push_back(std::visit(ArgumentJson(), argument));
    }
    return json;
}

/// Names of files need not be UTF-8.
std::string textOf(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}   // namespace

std::string messageJson(const core::Message& message)
{
    return textOf(jsonOf(message));
}

std::string messagesJson(const core::Messages& messages)
{
    Json list = Json::array();
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
