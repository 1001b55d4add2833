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

std::optional<core::Message> findUncapturable(const std::vector<core::ColorImage>& images)
{
    if (images.empty() || images.front().rgb.empty()) {
        return messages::pictureMissing();
    }
    const core::ColorImage& first = images.front();
    const bool isOneSize = std::ranges::all_of(images, [&first](const core::ColorImage& picture) {
        return picture.width == first.width && picture.height == first.height && picture.rgb.size() == first.rgb.size();
    });
    if (!isOneSize) {
        return messages::imageFramesDiffer();
    }
    const bool isTooLarge =
        first.width > 65535 || first.height > 65535 || images.size() > maxPixelBytes / first.rgb.size();
    return isTooLarge ? std::optional(messages::objectTooLarge()) : std::nullopt;
}

void addImage(DicomItem& root, const CapturedImages& capture, const SourceImage& source, const ObjectOrigin& origin)
{
    const core::ColorImage& first = capture.images.front();
    root.text(0x00080008, "CS", "DERIVED\\SECONDARY");
    root.text(0x00080064, "CS", "WSD");
    addContentTime(root, origin);
    addDerivedFrom(root, capture.derivation, source);
    root.text(0x00181012, "DA", origin.created.date);
    root.text(0x00181014, "TM", origin.created.time);
    root.text(0x00200020, "CS", "");
    root.setUnsignedShort(0x00280002, 3);
    root.text(0x00280004, "CS", "RGB");
    root.setUnsignedShort(0x00280006, 0);
    root.setUnsignedShort(0x00280010, first.height);
    root.setUnsignedShort(0x00280011, first.width);
    root.setUnsignedShort(0x00280100, 8);
    root.setUnsignedShort(0x00280101, 8);
    root.setUnsignedShort(0x00280102, 7);
    root.setUnsignedShort(0x00280103, 0);
    root.text(0x00280301, "CS", capture.identity == BurnedInIdentity::None ? "NO" : "YES");
}

/// Adds the pixels and releases each image once it is copied, so that a long cine run is not held in memory twice.
void addPixels(DicomItem& root, std::vector<core::ColorImage> images)
{
    std::string pixels;
    pixels.reserve(images.size() * images.front().rgb.size());
    for (core::ColorImage& picture : images) {
        pixels.append(reinterpret_cast<const char*>(picture.rgb.data()), picture.rgb.size());
        picture = {};
    }
    root.bytes(0x7fe00010, pixels);
}

/// Adds the Multi-frame and Cine modules (PS3.3 C.7.6.6, C.7.6.5).
void addFrames(DicomItem& root, const CapturedImages& capture)
{
    constexpr double usualFrameTimeMs = 1000.0 / 15.0;
    root.text(0x00280008, "IS", std::to_string(capture.images.size()));
    root.setAttributeTag(0x00280009, 0x00181063);
    root.setDecimals(0x00181063, {capture.frameTimeMs > 0.0 ? capture.frameTimeMs : usualFrameTimeMs});
}

}   // namespace

core::Result<std::string> encodeSecondaryCapture(const CapturedImages& capture, const SourceImage& source,
                                                 const ObjectOrigin& origin)
{
    if (const auto problem = findUncapturable(capture.images)) {
        return core::Error(*problem);
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, kindFor(pictureKind, source), source, origin);
    addImage(root, capture, source, origin);
    addPixels(root, {capture.images.front()});
    return object.content();
}

core::Result<std::string> encodeMultiframeCapture(CapturedImages capture, const SourceImage& source,
                                                  const ObjectOrigin& origin)
{
    if (const auto problem = findUncapturable(capture.images)) {
        return core::Error(*problem);
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, kindFor(runKind, source), source, origin);
    addImage(root, capture, source, origin);
    addFrames(root, capture);
    addPixels(root, std::move(capture.images));
    return object.content();
}

}   // namespace angiopose::io
