#include "io/support/message_json.h"

#include "core/messages/catalog.h"
#include "io/messages/catalog.h"

#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

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
        if (quantity.decimals != 0) {
            json["decimals"] = quantity.decimals;
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

core::Message messageOf(const MessageJson& json);

core::MessageArgument argumentOf(const MessageJson& json)
{
    if (json.is_object()) {
        return core::Quantity{json.at("value").is_null() ? std::nan("") : json.at("value").get<double>(),
                              json.value("decimals", 0), persistentText(json.value("unit", std::string())).data()};
    }
    if (!json.is_array()) {
        return json.get<std::string>();
    }
    if (json.empty() || json.front().is_string()) {
        return json.get<std::vector<std::string>>();
    }
    core::Messages messages;
    for (const MessageJson& each : json) {
        messages.push_back(messageOf(each));
    }
    return messages;
}

const core::MessageEntry* findEntry(const std::string& id)
{
    for (const auto catalog : {core::messageCatalog(), io::messageCatalog()}) {
        for (const core::MessageEntry* entry : catalog) {
            if (id == entry->id) {
                return entry;
            }
        }
    }
    return nullptr;
}

core::Severity severityOf(const std::string& text)
{
    for (const core::Severity severity : {core::Severity::Note, core::Severity::Error}) {
        if (text == core::toText(severity)) {
            return severity;
        }
    }
    return core::Severity::Warning;
}

/// Restores a message. If this version lacks that message or expects other arguments, keeps only the English sentence.
core::Message messageOf(const MessageJson& json)
{
    const core::Severity severity = severityOf(json.value("severity", std::string()));
    const core::MessageEntry* entry = findEntry(json.at("id").get<std::string>());
    if (!entry || json.at("arguments").size() != core::placeholderCount(entry->english)) {
        return core::Message::verbatim(json.value("text", std::string())).as(severity);
    }
    std::vector<core::MessageArgument> arguments;
    for (const MessageJson& each : json.at("arguments")) {
        arguments.push_back(argumentOf(each));
    }
    core::Message message = core::Message(*entry, std::move(arguments)).as(severity);
    const std::string subject = json.value("subject", std::string());
    return subject.empty() ? message : message.about(subject);
}

/// Converts to text and replaces invalid bytes, because file names need not be UTF-8.
std::string textOf(const MessageJson& json)
{
    return json.dump(-1, ' ', false, MessageJson::error_handler_t::replace);
}

}   // namespace

std::string_view persistentText(const std::string& text)
{
    static std::mutex mutex;
    static std::set<std::string> texts;   // a set, because its elements keep their addresses
    const std::lock_guard lock(mutex);
    return *texts.insert(text).first;
}

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

core::Messages parseMessages(std::string_view json)
{
    core::Messages messages;
    for (const MessageJson& each : MessageJson::parse(json)) {
        messages.push_back(messageOf(each));
    }
    return messages;
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
