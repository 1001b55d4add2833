#include "io/support/json_text.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr int maxNesting = 64;

/// Returns the maximum nesting depth of braces and brackets outside strings.
int nestingOf(std::string_view text)
{
    int depth = 0, deepest = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            i += c == '\\' ? 1 : 0;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            deepest = std::max(deepest, ++depth);
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return deepest;
}

bool isFlat(const Json& array)
{
    return std::none_of(array.begin(), array.end(), [](const Json& value) { return value.is_structured(); });
}

void appendPretty(const Json& value, int depth, std::string& text)
{
    if (!value.is_structured() || value.empty() || (value.is_array() && isFlat(value))) {
        text += value.dump();
        return;
    }
    const std::string indent(static_cast<std::size_t>(2 * depth + 2), ' ');
    text += value.is_object() ? "{" : "[";
    bool isFirst = true;
    for (const auto& item : value.items()) {
        text += (isFirst ? "\n" : ",\n") + indent;
        isFirst = false;
        if (value.is_object()) {
            text += Json(item.key()).dump() + ": ";
        }
        appendPretty(item.value(), depth + 1, text);
    }
    text += "\n" + indent.substr(2) + (value.is_object() ? "}" : "]");
}

/// Returns the members of `json` that are not in `known`; compares nested objects recursively.
Json difference(const Json& json, const Json& known)
{
    Json rest = Json::object();
    for (const auto& [key, value] : json.items()) {
        const auto found = known.find(key);
        if (found == known.end()) {
            rest[key] = value;
        } else if (found->is_object() && value.is_object()) {
            Json inner = difference(value, *found);
            if (!inner.empty()) {
                rest[key] = std::move(inner);
            }
        }
    }
    return rest;
}

void merge(Json& json, const Json& extra)
{
    for (const auto& [key, value] : extra.items()) {
        const auto found = json.find(key);
        if (found == json.end()) {
            json[key] = value;
        } else if (found->is_object() && value.is_object()) {
            merge(*found, value);
        }
    }
}

}   // namespace

std::string prettyJson(std::string_view json)
{
    std::string text;
    appendPretty(Json::parse(json), 0, text);
    return text + "\n";
}

core::Status checkJson(std::string_view text, const std::string& path)
{
    if (nestingOf(text) > maxNesting) {
        return fileError(path, messages::jsonTooDeep(maxNesting));
    }
    try {
        [[maybe_unused]] const Json parsed = Json::parse(text);
        return core::Done{};
    } catch (const Json::parse_error& error) {
        const std::size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        return fileError(path, messages::jsonInvalid(line));
    } catch (const Json::exception&) {
        return fileError(path, messages::jsonNumberTooLarge());
    }
}

std::string unknownKeys(std::string_view json, std::string_view known)
{
    const Json rest = difference(Json::parse(json), Json::parse(known));
    return rest.empty() ? std::string() : rest.dump();
}

std::string withExtraKeys(std::string_view json, std::string_view extra)
{
    Json merged = Json::parse(json);
    if (!extra.empty()) {
        merge(merged, Json::parse(extra));
    }
    return merged.dump();
}

}   // namespace angiopose::io
