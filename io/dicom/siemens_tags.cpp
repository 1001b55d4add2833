#include "io/dicom/siemens_tags.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace angiopose::io {
namespace {

/// Replaces double spaces by single ones, as some PACS do in private creators.
std::string withSingleSpaces(std::string_view text)
{
    std::string single(text);
    const auto end = std::unique(single.begin(), single.end(), [](char a, char b) { return a == ' ' && b == ' '; });
    single.erase(end, single.end());
    return single;
}

}   // namespace

std::optional<DicomTag> siemensTag(const DicomDataset& data, DicomTag number)
{
    const std::string wanted = withSingleSpaces(siemensCreator);
    for (DicomTag block = siemensBlock; block <= 0x002100ff; ++block) {
        const DicomTag tag = 0x00210000 | (block & 0xffU) << 8U | number;
        if (withSingleSpaces(data.text(block)) == wanted && data.has(tag)) {
            return tag;
        }
    }
    return {};
}

}   // namespace angiopose::io
