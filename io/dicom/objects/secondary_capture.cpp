#include "io/dicom/objects/secondary_capture.h"

#include "io/messages/messages.h"

#include <algorithm>
#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t maxPixelBytes = (std::size_t{1} << 32) - 16;   // limit imposed by the 32-bit length field

constexpr ObjectKind pictureKind{"1.2.840.10008.5.1.4.1.1.7", "OT", "picture", "AngioPose overlay", 9001};
constexpr ObjectKind runKind{"1.2.840.10008.5.1.4.1.1.7.4", "OT", "run", "AngioPose overlay, run", 9002};

/// Returns `kind` with the modality of the source image (XA or RF), so that PACS group the objects with it.
ObjectKind kindFor(ObjectKind kind, const SourceImage& source)
{
    kind.modality = source.modality == "XA" ? "XA" : source.modality == "RF" ? "RF" : kind.modality;
    return kind;
}

std::optional<core::Message> findUncapturable(const std::vector<core::ColorImage>& pictures)
{
    if (pictures.empty() || pictures.front().rgb.empty()) {
        return messages::pictureMissing();
    }
    const core::ColorImage& first = pictures.front();
    const bool isOneSize = std::ranges::all_of(pictures, [&first](const core::ColorImage& picture) {
        return picture.width == first.width && picture.height == first.height && picture.rgb.size() == first.rgb.size();
    });
    if (!isOneSize) {
        return messages::imageFramesDiffer();
    }
    const bool isTooLarge =
        first.width > 65535 || first.height > 65535 || pictures.size() > maxPixelBytes / first.rgb.size();
    return isTooLarge ? std::optional(messages::objectTooLarge()) : std::nullopt;
}

void addImage(DicomItem& root, const CapturedImages& captured, const SourceImage& source, const ObjectOrigin& origin)
{
    const core::ColorImage& first = captured.pictures.front();
    root.text(0x00080008, "CS", "DERIVED\\SECONDARY");
    root.text(0x00080064, "CS", "WSD");
    addContentTime(root, origin);
    addDerivedFrom(root, captured.derivation, source);
    root.text(0x00181012, "DA", origin.made.date);
    root.text(0x00181014, "TM", origin.made.time);
    root.text(0x00200020, "CS", "");
    root.unsignedShort(0x00280002, 3);
    root.text(0x00280004, "CS", "RGB");
    root.unsignedShort(0x00280006, 0);
    root.unsignedShort(0x00280010, first.height);
    root.unsignedShort(0x00280011, first.width);
    root.unsignedShort(0x00280100, 8);
    root.unsignedShort(0x00280101, 8);
    root.unsignedShort(0x00280102, 7);
    root.unsignedShort(0x00280103, 0);
    root.text(0x00280301, "CS", captured.identity == BurnedInIdentity::None ? "NO" : "YES");
}

/// Adds the pixels and releases each image once it is copied, so that a long cine run is not held in memory twice.
void addPixels(DicomItem& root, std::vector<core::ColorImage> pictures)
{
    std::string pixels;
    pixels.reserve(pictures.size() * pictures.front().rgb.size());
    for (core::ColorImage& picture : pictures) {
        pixels.append(reinterpret_cast<const char*>(picture.rgb.data()), picture.rgb.size());
        picture = {};
    }
    root.bytes(0x7fe00010, pixels);
}

/// Adds the Multi-frame and Cine modules (PS3.3 C.7.6.6, C.7.6.5).
void addFrames(DicomItem& root, const CapturedImages& captured)
{
    constexpr double usualFrameTimeMs = 1000.0 / 15.0;
    root.text(0x00280008, "IS", std::to_string(captured.pictures.size()));
    root.attribute(0x00280009, 0x00181063);
    root.decimals(0x00181063, {captured.frameTimeMs > 0.0 ? captured.frameTimeMs : usualFrameTimeMs});
}

}   // namespace

core::Result<std::string> secondaryCapture(const CapturedImages& captured, const SourceImage& source,
                                           const ObjectOrigin& origin)
{
    if (const auto problem = findUncapturable(captured.pictures)) {
        return core::Error(*problem);
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, kindFor(pictureKind, source), source, origin);
    addImage(root, captured, source, origin);
    addPixels(root, {captured.pictures.front()});
    return object.content();
}

core::Result<std::string> multiframeSecondaryCapture(CapturedImages captured, const SourceImage& source,
                                                     const ObjectOrigin& origin)
{
    if (const auto problem = findUncapturable(captured.pictures)) {
        return core::Error(*problem);
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, kindFor(runKind, source), source, origin);
    addImage(root, captured, source, origin);
    addFrames(root, captured);
    addPixels(root, std::move(captured.pictures));
    return object.content();
}

}   // namespace angiopose::io
