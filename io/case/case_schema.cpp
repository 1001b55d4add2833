#include "io/case/case_schema.h"

#include "io/case_file.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace io {
namespace {

constexpr std::size_t maxProblems = 20;

/// "<root>[geometry][camera]" → "geometry.camera".
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

}   // namespace

std::vector<std::string> findSchemaProblems(std::string_view json)
{
    const nlohmann::json document = nlohmann::json::parse(json);
    const valijson::adapters::NlohmannJsonAdapter adapter(document);
    valijson::ValidationResults results;
    valijson::Validator validator;
    std::vector<std::string> problems;
    if (validator.validate(parsedSchema(), adapter, &results)) {
        return problems;
    }
    for (valijson::ValidationResults::Error error; results.popError(error) && problems.size() < maxProblems;) {
        std::string key;
        for (const std::string& part : error.context) {
            key += part;
        }
        problems.push_back(keyPath(key) + ": " + error.description);
    }
    return problems;
}

}   // namespace io
