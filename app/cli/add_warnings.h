#pragma once

#include "io/support/message_json.h"

#include <nlohmann/json.hpp>

namespace angiopose::app {

/// Adds `warnings` (sentences only, for compatibility) and `messages` (sentences with IDs).
inline void addWarnings(nlohmann::ordered_json& json, const core::Messages& warnings)
{
    json["warnings"] = io::sentencesOf(warnings);
    json["messages"] = nlohmann::ordered_json::parse(io::messagesJson(warnings));
}

}   // namespace angiopose::app
