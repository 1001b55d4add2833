#include "io/volume/nrrd_fields.h"

#include "io/support/numbers.h"

#include <algorithm>
#include <sstream>

namespace angiopose::io {

std::string lowered(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

/// "key: value" lines up to the first blank one; `end` is where the data begin.
NrrdFields nrrdFieldsOf(std::string_view content, std::size_t& end)
{
    NrrdFields fields;
    std::size_t at = 0;
    end = content.size();
    while (at < content.size()) {
        const std::size_t newline = std::min(content.find('\n', at), content.size());
        const std::string_view line = trimmed(content.substr(at, newline - at));
        at = std::min(newline + 1, content.size());
        if (line.empty()) {
            end = at;
            break;
        }
        const std::size_t colon = line.find(':');
        if (line.front() != '#' && colon != std::string_view::npos) {
            std::string_view value = line.substr(colon + 1);
            value.remove_prefix(value.starts_with('=') ? 1 : 0);
            // Some writers give "byte skip" as a key/value pair (":="): taken as meant. The first mention counts.
            fields.emplace(lowered(trimmed(line.substr(0, colon))), trimmed(value));
        }
    }
    return fields;
}

std::vector<std::string> wordsOf(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) {
        words.push_back(word);
    }
    return words;
}

/// "(1,0,0) none (0, 1,0)" → one entry per axis; nothing where it says none.
std::optional<std::vector<std::optional<Eigen::Vector3d>>> vectorsOf(const std::string& text)
{
    std::vector<std::optional<Eigen::Vector3d>> vectors;
    std::string_view rest = trimmed(text);
    while (!rest.empty()) {
        if (rest.starts_with("none")) {
            vectors.emplace_back();
            rest = trimmed(rest.substr(4));
            continue;
        }
        const std::size_t close = rest.find(')');
        if (!rest.starts_with('(') || close == std::string_view::npos) {
            return std::nullopt;
        }
        Eigen::Vector3d vector;
        std::string_view inside = rest.substr(1, close - 1);
        for (int i = 0; i < 3; ++i) {
            const std::size_t comma = inside.find(',');
            const auto number = parseNumber(inside.substr(0, comma));
            if (!number || (i < 2) != (comma != std::string_view::npos)) {
                return std::nullopt;
            }
            vector[i] = *number;
            inside.remove_prefix(comma == std::string_view::npos ? inside.size() : comma + 1);
        }
        vectors.emplace_back(vector);
        rest = trimmed(rest.substr(close + 1));
    }
    return vectors;
}

std::optional<VoxelType> nrrdTypeOf(const std::string& name)
{
    static const std::map<std::string, VoxelType> types = {
        {"signed char", VoxelType::Int8},
        {"int8", VoxelType::Int8},
        {"int8_t", VoxelType::Int8},
        {"uchar", VoxelType::Uint8},
        {"unsigned char", VoxelType::Uint8},
        {"uint8", VoxelType::Uint8},
        {"uint8_t", VoxelType::Uint8},
        {"short", VoxelType::Int16},
        {"short int", VoxelType::Int16},
        {"signed short", VoxelType::Int16},
        {"signed short int", VoxelType::Int16},
        {"int16", VoxelType::Int16},
        {"int16_t", VoxelType::Int16},
        {"ushort", VoxelType::Uint16},
        {"unsigned short", VoxelType::Uint16},
        {"unsigned short int", VoxelType::Uint16},
        {"uint16", VoxelType::Uint16},
        {"uint16_t", VoxelType::Uint16},
        {"int", VoxelType::Int32},
        {"signed int", VoxelType::Int32},
        {"int32", VoxelType::Int32},
        {"int32_t", VoxelType::Int32},
        {"uint", VoxelType::Uint32},
        {"unsigned int", VoxelType::Uint32},
        {"uint32", VoxelType::Uint32},
        {"uint32_t", VoxelType::Uint32},
        {"longlong", VoxelType::Int64},
        {"long long", VoxelType::Int64},
        {"int64", VoxelType::Int64},
        {"int64_t", VoxelType::Int64},
        {"ulonglong", VoxelType::Uint64},
        {"unsigned long long", VoxelType::Uint64},
        {"uint64", VoxelType::Uint64},
        {"uint64_t", VoxelType::Uint64},
        {"float", VoxelType::Float32},
        {"double", VoxelType::Float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

std::string field(const NrrdFields& fields, const char* key)
{
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
}

}   // namespace angiopose::io