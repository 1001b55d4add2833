#include "io/archive/node_file.h"

#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* formatName = "angiopose-archives";
constexpr int formatVersion = 1;

template <class Value>
void take(const Json& json, const char* key, Value& value)
{
    if (const auto found = json.find(key); found != json.end()) {
        value = found->get<Value>();
    }
}

ArchiveNode nodeOf(const Json& json)
{
    ArchiveNode node;
    take(json, "name", node.name);
    take(json, "host", node.host);
    take(json, "port", node.port);
    take(json, "title", node.title);
    take(json, "ownTitle", node.ownAeTitle);
    take(json, "receivePort", node.receivePort);
    take(json, "tls", node.isTls);
    take(json, "caFile", node.caFile);
    take(json, "certificateFile", node.certificateFile);
    take(json, "keyFile", node.keyFile);
    take(json, "checkHost", node.verifiesHost);
    take(json, "webUrl", node.webUrl);
    take(json, "authorizationFile", node.authorizationFile);
    take(json, "answerSeconds", node.responseTimeoutSeconds);
    return node;
}

/// Converts a node to JSON without the members that have default values.
Json jsonOf(const ArchiveNode& node)
{
    const ArchiveNode usual;
    Json json{{"name", node.name}};
    const auto put = [&json](const char* key, const auto& value, const auto& usualValue) {
        if (value != usualValue) {
            json[key] = value;
        }
    };
    put("host", node.host, usual.host);
    if (!node.host.empty()) {
        json["port"] = node.port;
        json["title"] = node.title;
        json["ownTitle"] = node.ownAeTitle;
    }
    put("receivePort", node.receivePort, usual.receivePort);
    put("tls", node.isTls, usual.isTls);
    put("caFile", node.caFile, usual.caFile);
    put("certificateFile", node.certificateFile, usual.certificateFile);
    put("keyFile", node.keyFile, usual.keyFile);
    put("checkHost", node.verifiesHost, usual.verifiesHost);
    put("webUrl", node.webUrl, usual.webUrl);
    put("authorizationFile", node.authorizationFile, usual.authorizationFile);
    put("answerSeconds", node.responseTimeoutSeconds, usual.responseTimeoutSeconds);
    return json;
}

ArchiveSettings settingsOf(const Json& json)
{
    ArchiveSettings settings;
    const Json cache = json.value("cache", Json::object());
    take(cache, "folder", settings.cacheFolder);
    double gigabytes = static_cast<double>(settings.cacheBytes) / 1e9;
    take(cache, "limitGB", gigabytes);
    settings.cacheBytes = gigabytes >= 0.0 && gigabytes < 1e6 ? static_cast<std::uint64_t>(gigabytes * 1e9) : 0;
    for (const Json& node : json.value("nodes", Json::array())) {
        settings.nodes.push_back(nodeOf(node));
    }
    return settings;
}

}   // namespace

std::string defaultArchiveSettingsFile()
{
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const std::filesystem::path base = config != nullptr && *config == '/'
                                           ? std::filesystem::path(config)
                                           : std::filesystem::path(home != nullptr ? home : ".") / ".config";
    return (base / "AngioPose" / "archives.json").string();
}

core::Result<ArchiveSettings> readArchiveSettings(const std::string& path)
{
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown) && !unknown) {
        return ArchiveSettings();
    }
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view text = input.value().view();
    if (auto checked = checkJson(text, path); !checked) {
        return checked.error();
    }
    try {
        const Json json = Json::parse(text);
        if (json.value("format", "") != formatName || json.value("version", 0) != formatVersion) {
            return core::Error(messages::archiveListInvalid("format, version").about(path));
        }
        ArchiveSettings settings = settingsOf(json);
        for (const ArchiveNode& node : settings.nodes) {
            if (auto checked = checkNode(node); !checked) {
                return checked.error();
            }
        }
        return settings;
    } catch (const Json::exception& error) {
        return core::Error(messages::archiveListInvalid(error.what()).about(path));
    }
}

core::Status writeArchiveSettings(const ArchiveSettings& settings, const std::string& path)
{
    Json json{{"format", formatName}, {"version", formatVersion}};
    json["cache"]["limitGB"] = static_cast<double>(settings.cacheBytes) / 1e9;
    if (!settings.cacheFolder.empty()) {
        json["cache"]["folder"] = settings.cacheFolder;
    }
    json["nodes"] = Json::array();
    for (const ArchiveNode& node : settings.nodes) {
        if (auto checked = checkNode(node); !checked) {
            return checked.error();
        }
        json["nodes"].push_back(jsonOf(node));
    }
    std::error_code failed;
    std::filesystem::create_directories(std::filesystem::absolute(path).parent_path(), failed);
    return writeAtomically(path, prettyJson(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\n");
}

core::Result<ArchiveNode> findNode(const ArchiveSettings& settings, const std::string& name, const std::string& path)
{
    std::string known;
    for (const ArchiveNode& node : settings.nodes) {
        if (node.name == name) {
            return node;
        }
        known += (known.empty() ? "" : ", ") + node.name;
    }
    return core::Error(messages::archiveUnknown(name, path, known.empty() ? "-" : known));
}

}   // namespace angiopose::io
