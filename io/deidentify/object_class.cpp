#include "io/deidentify/object_class.h"

#include "io/messages/says_deidentify.h"
#include "io/support/file_error.h"

#include <array>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr std::string_view storage = "1.2.840.10008.5.1.4.1.1.";
constexpr std::string_view greyState = "11.1";
constexpr std::string_view spatialClass = "66.1";
constexpr std::string_view segmentClass = "66.4";
constexpr std::string_view reports = "88.";
constexpr std::string_view documents = "104.";

/// Presentation states and spatial objects of other kinds, waveforms, raw data, treatment plans.
constexpr std::array<std::string_view, 8> uncleared{"9.", "11.", "66", "67", "68.", "78.", "79.", "481."};

core::Result<FreedClass> classOf(const DicomDataset& data, const std::string& path)
{
    const std::string_view classUid = data.text(0x00080016);
    if (!classUid.starts_with(storage)) {
        return data.text(0x00080060) == "SEG" ? FreedClass::Segmentation : FreedClass::Image;
    }
    const std::string_view kind = classUid.substr(storage.size());
    if (kind == segmentClass) {
        return FreedClass::Segmentation;
    }
    if (kind == greyState) {   // others need a colour profile, which holds words
        return FreedClass::PresentationState;
    }
    if (kind == spatialClass) {
        return FreedClass::Registration;
    }
    if (kind.starts_with(reports)) {
        return FreedClass::Report;
    }
    if (kind.starts_with(documents)) {
        return fileError(path, says::pagesStay());
    }
    for (const std::string_view stays : uncleared) {
        if (kind.starts_with(stays)) {
            return fileError(path, says::objectStays(std::string(classUid)));
        }
    }
    return FreedClass::Image;
}

bool hasPixels(FreedClass freed)
{
    return freed == FreedClass::Image || freed == FreedClass::Segmentation;
}

}   // namespace

core::Result<FreedClass> freedClassOf(const DicomFile& file, const std::string& path)
{
    const auto freed = classOf(file.dataset, path);
    if (freed && !hasPixels(freed.value()) && !file.pixels.empty()) {
        return fileError(path, says::objectWithPixels(std::string(file.dataset.text(0x00080016))));
    }
    return freed;
}

}   // namespace angiopose::io
