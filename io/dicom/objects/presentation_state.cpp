#include "io/dicom/objects/presentation_state.h"

#include "io/messages/messages.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr ObjectKind stateKind{"1.2.840.10008.5.1.4.1.1.11.1", "PR", "state", "AngioPose overlay, vectors", 9004};
constexpr std::size_t maxPointsInLine = 8000;   // a value with a 16-bit length field has at most 65534 bytes
constexpr std::uint16_t whiteGray = 65535;

/// Adds a reference to the image and, if it has several frames, to one frame.
void addImageReference(DicomItem& item, const SourceImage& source, int frame)
{
    DicomItem image = addReference(item, 0x00081140, source.sopClassUid, source.sopInstanceUid);
    if (source.frames > 1) {
        image.text(0x00081160, "IS", std::to_string(frame + 1));
    }
}

/// Adds the Presentation State Relationship module (PS3.3 C.11.11).
void addRelationship(DicomItem& root, const SourceImage& source, int frame)
{
    DicomItem series = root.addItem(0x00081115);
    series.text(0x0020000e, "UI", source.seriesUid);
    addImageReference(series, source, frame);
}

/// Adds the Displayed Area module: the whole image, scaled to fit.
void addDisplayedArea(DicomItem& root, const SourceImage& source)
{
    DicomItem area = root.addItem(0x0070005a);
    area.setSignedLongs(0x00700052, {1, 1});
    area.setSignedLongs(0x00700053, {source.columns, source.rows});
    area.text(0x00700100, "CS", "SCALE TO FIT");
    area.text(0x00700102, "IS", "1\\1");
}

void addLayer(DicomItem& root, const GraphicLayer& layer, std::size_t order)
{
    DicomItem item = root.addItem(0x00700060);
    item.text(0x00700002, "CS", layer.name);
    item.text(0x00700062, "IS", std::to_string(order + 1));
    item.setUnsignedShort(0x00700066, whiteGray);
    item.text(0x00700068, "LO", truncateUtf8(layer.description, 64));
    item.setUnsignedShorts(0x00700401, labColor(layer.color));
}

/// Converts coordinates relative to the center of the first pixel to DICOM coordinates, which start at its corner.
std::vector<float> cornerBased(const std::vector<Eigen::Vector2d>& line, std::size_t first, std::size_t last)
{
    std::vector<float> values;
    for (std::size_t i = first; i < last; ++i) {
        values.push_back(static_cast<float>(line[i].x() + 0.5));
        values.push_back(static_cast<float>(line[i].y() + 0.5));
    }
    return values;
}

void addLine(DicomItem& annotation, const std::vector<Eigen::Vector2d>& line)
{
    for (std::size_t first = 0; first + 1 < line.size(); first += maxPointsInLine - 1) {
        const std::size_t last = std::min(line.size(), first + maxPointsInLine);
        DicomItem object = annotation.addItem(0x00700009);
        object.text(0x00700005, "CS", "PIXEL");
        object.setUnsignedShort(0x00700020, 2);
        object.setUnsignedShort(0x00700021, static_cast<int>(last - first));
        object.setFloats(0x00700022, cornerBased(line, first, last));
        object.text(0x00700023, "CS", "POLYLINE");
        object.text(0x00700024, "CS", "N");
    }
}

void addText(DicomItem& annotation, const GraphicText& text)
{
    DicomItem object = annotation.addItem(0x00700008);
    object.text(0x00700006, "ST", truncateUtf8(text.words, 1024));
    object.text(0x00700004, "CS", "PIXEL");
    object.setFloats(0x00700014, cornerBased({text.at}, 0, 1));
    object.text(0x00700015, "CS", "N");
}

void addAnnotation(DicomItem& root, const GraphicLayer& layer, const SourceImage& source, int frame)
{
    DicomItem annotation = root.addItem(0x00700001);
    addImageReference(annotation, source, frame);
    annotation.text(0x00700002, "CS", layer.name);
    for (const GraphicText& text : layer.texts) {
        addText(annotation, text);
    }
    for (const std::vector<Eigen::Vector2d>& line : layer.lines) {
        addLine(annotation, line);
    }
}

/// Adds the Modality LUT, Softcopy VOI LUT and Softcopy Presentation LUT modules.
void addGrays(DicomItem& root, const PresentationContent& shown, const SourceImage& source)
{
    for (const SourceImage::Text& rescale : source.modalityLut) {
        root.text(rescale.tag, rescale.vr, rescale.value);
    }
    if (!source.modalityLut.empty() && source.modalityLut.back().tag != 0x00281054) {
        root.text(0x00281054, "LO", "US");
    }
    if (shown.range) {   // PS3.3 C.11.2.1.2.1: black up to center - 0.5 - (width - 1) / 2
        DicomItem window = root.addItem(0x00283110);
        window.setDecimals(0x00281050, {shown.range->level() + 0.5});
        window.setDecimals(0x00281051, {std::max(1.0, shown.range->window() + 1.0)});
    }
    root.text(0x20500020, "CS", source.isShownInverted ? "INVERSE" : "IDENTITY");
}

bool hasLine(const GraphicLayer& layer)
{
    return std::ranges::any_of(layer.lines, [](const auto& line) { return line.size() > 1; });
}

}   // namespace

core::Result<std::string> encodePresentationState(const PresentationContent& shown, const SourceImage& source,
                                                  const ObjectOrigin& origin)
{
    if (!source.isDicom || !source.isReferenceable() || source.rows <= 0 || source.columns <= 0) {
        return core::Error(messages::objectNoReference());
    }
    if (std::ranges::none_of(shown.layers, hasLine)) {
        return core::Error(messages::objectNoLines());
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, stateKind, source, origin);
    addContentIdentification(root, "ANGIOPOSE", shown.description, origin);
    root.text(0x00700082, "DA", origin.created.date);
    root.text(0x00700083, "TM", origin.created.time);
    addRelationship(root, source, shown.frame);
    addDisplayedArea(root, source);
    addGrays(root, shown, source);
    std::size_t order = 0;
    for (const GraphicLayer& layer : shown.layers) {
        if (hasLine(layer) || !layer.texts.empty()) {
            addLayer(root, layer, order++);
            addAnnotation(root, layer, source, shown.frame);
        }
    }
    return object.content();
}

}   // namespace angiopose::io
