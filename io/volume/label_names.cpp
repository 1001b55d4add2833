#include "io/volume/label_names.h"

#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/volume/byte_stream.h"
#include "io/volume/nrrd_fields.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::uint64_t longestHead = 1U << 20U;   ///< a table of some thousand labels
constexpr std::size_t longestName = 80;

/// `Segment3_LabelValue:=4`, `Segment3_Name:=Aorta`. An overlapping segment shares its value with another layer.
LabelNames slicerSegments(std::string_view content)
{
    std::size_t end = 0;
    const NrrdFields fields = nrrdFieldsOf(content, end);
    LabelNames names;
    for (int n = 0; fields.contains("segment" + std::to_string(n) + "_id"); ++n) {
        const std::string segment = "segment" + std::to_string(n);
        const auto value = parseInteger(field(fields, (segment + "_labelvalue").c_str()));
        const std::string name = field(fields, (segment + "_name").c_str());
        if (value && !name.empty()) {
            names.emplace(*value, name.substr(0, longestName));
        }
    }
    return names;
}

std::string_view between(std::string_view text, std::string_view before, std::string_view after)
{
    const std::size_t start = text.find(before);
    const std::size_t end = start == std::string_view::npos ? start : text.find(after, start + before.size());
    return end == std::string_view::npos ? std::string_view()
                                         : text.substr(start + before.size(), end - start - before.size());
}

/// `<Label Key="1" …><![CDATA[aorta]]></Label>`, or the name without CDATA.
LabelNames labelTable(std::string_view text)
{
    constexpr std::string_view opening = "<Label ";
    constexpr std::string_view closing = "</Label>";
    LabelNames names;
    for (std::size_t at = text.find(opening); at != std::string_view::npos; at = text.find(opening, at + 1)) {
        const std::size_t end = text.find(closing, at);
        if (end == std::string_view::npos) {
            break;
        }
        const std::string_view label = text.substr(at, end + closing.size() - at);
        const auto key = parseInteger(between(label, "Key=\"", "\""));
        std::string_view name = between(label, "<![CDATA[", "]]>");
        name = name.empty() ? between(label, ">", "<") : name;
        if (key && !trimmed(name).empty()) {
            names.emplace(*key, trimmed(name).substr(0, longestName));
        }
    }
    return names;
}

/// Everything before the voxels.
std::string headOf(const VoxelSource& source)
{
    auto opened = ByteStream::open({source.path, 0, source.packing});
    if (!opened) {
        return {};
    }
    ByteStream stream = std::move(opened).value();
    std::string head(std::min(source.skip, longestHead), '\0');
    head.resize(stream.readSome(head.data(), head.size()));
    return head;
}

}   // namespace

LabelNames labelNamesOf(const StoredVolume& stored)
{
    if (stored.format.starts_with("NIfTI")) {
        return labelTable(headOf(stored.source));
    }
    if (stored.format != "NRRD") {
        return LabelNames();
    }
    const auto input = openInput(stored.path);
    return input ? slicerSegments(input.value().view()) : LabelNames();
}

}   // namespace angiopose::io