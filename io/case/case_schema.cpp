#include "io/case/case_schema.h"

#include "io/case/case_file.h"
#include "io/messages/messages.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace angiopose::io {
namespace {

constexpr std::size_t maxProblems = 20;

/// Converts "<root>[geometry][camera]" to "geometry.camera".
std::string keyPath(const std::string& context)
{
    std::string path;
    for (std::size_t at = context.find('['); at != std::string::npos; at = context.find('[', at + 1)) {
        const std::size_t end = std::min(context.find(']', at), context.size());
        path += (path.empty() ? "" : ".") + context.substr(at + 1, end - at - 1);
    }
    return path.empty() ? "the case" : path;
}

const valijson::Schema& parsedSchema()
{
    static const auto schema = [] {
        auto parsed = std::make_unique<valijson::Schema>();
        const nlohmann::json document = nlohmann::json::parse(caseSchema());
        const valijson::adapters::NlohmannJsonAdapter adapter(document);
        valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, *parsed);
        return parsed;
    }();
    return *schema;
}

/// Rewrites the validator's message for users; returns nullopt if the message only repeats that of a nested level.
std::optional<core::Message> problemText(const std::string& key, const std::string& description)
{
    if (description.starts_with("Missing required property")) {
        const std::size_t quote = description.find('\'');
        const std::string quoted = description.substr(quote, description.rfind('\'') + 1 - quote);
        return messages::caseKeyMissing(quoted).about(key);
    }
    if (description.starts_with("Failed to validate")) {
        return {};
    }
    if (description.find("'type' constraint") != std::string::npos) {
        return messages::caseValueOfWrongKind().about(key);
    }
    if (description.find("enum") != std::string::npos) {
        return messages::caseValueNotAllowed().about(key);
    }
    return messages::caseValueWrong(description).about(key);
}

}   // namespace

core::Messages findSchemaProblems(std::string_view json)
{
    const nlohmann::json document = nlohmann::json::parse(json);
    if (!document.is_object() || document.value("format", nlohmann::json()) != "angiopose-case") {
        return {messages::caseNotOne()};
    }
    const valijson::adapters::NlohmannJsonAdapter adapter(document);
    valijson::ValidationResults results;
    valijson::Validator validator;
    core::Messages problems;
    if (validator.validate(parsedSchema(), adapter, &results)) {
        return problems;
    }
    for (valijson::ValidationResults::Error error; results.popError(error) && problems.size() < maxProblems;) {
        std::string key;
        for (const std::string& part : error.context) {
            key += part;
        }
        const auto problem = problemText(keyPath(key), error.description);
        if (problem && (problems.empty() || problems.back() != *problem)) {
            problems.push_back(*problem);
        }
    }
    if (problems.empty()) {
        problems.push_back(messages::caseAgainstSchema());
    }
    return problems;
}

}   // namespace angiopose::io
