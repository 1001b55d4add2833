#include "app/texts/svg_picture.h"

#include "app/texts/number_text.h"
#include "io/raster/png_text.h"
#include "io/support/base64.h"

#include <cstdlib>

namespace angiopose::app {
namespace {

using ui::StrokeLine;
using ui::StrokeShape;

constexpr int sameTone = 6;   // maximum difference of the 8-bit channels within a segment drawn in one color
constexpr double fillOverlap = 0.5;   // overlap of adjacent opaque fills, px, to avoid seams

std::string escapedForSvg(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return result;
}

std::string px(double value)
{
    return fixedText(value, 2);
}

std::string attribute(const char* name, const std::string& value)
{
    return std::string(" ") + name + "=\"" + value + "\"";
}

std::string opacityOf(const char* name, double opacity)
{
    return opacity < 0.999 ? attribute(name, fixedText(opacity, 3)) : std::string();
}

bool isSameTone(const ui::Color& a, const ui::Color& b)
{
    return std::abs(a.red - b.red) <= sameTone && std::abs(a.green - b.green) <= sameTone &&
           std::abs(a.blue - b.blue) <= sameTone;
}

class SvgWriter {
public:
    explicit SvgWriter(const ui::VectorImage& picture) : picture_(picture) {}

    std::string write(const SvgMetadata& metadata);

private:
    void addHead(const SvgMetadata& metadata);
    void addBackdrop(const ui::VectorBackdrop& backdrop);
    void addLine(const StrokeShape& shape);
    void addPath(const StrokeShape& shape, std::size_t from, std::size_t to);
    void addDot(const StrokeShape& shape);
    void addRibbon(const StrokeShape& shape);
    void addFill(const ui::VectorFill& fill);
    void addText(const ui::VectorText& text);
    std::string place(const Eigen::Vector2d& at) const { return px(at.x()) + " " + px(picture_.height - at.y()); }

    const ui::VectorImage& picture_;
    std::string svg_;
};

void SvgWriter::addHead(const SvgMetadata& metadata)
{
    const auto size = [&metadata](int length) {
        return metadata.dotsPerInch > 0.0 ? fixedText(25.4 * length / metadata.dotsPerInch, 3) + "mm"
                                          : std::to_string(length);
    };
    svg_ +=
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\"" +
        attribute("width", size(picture_.width)) + attribute("height", size(picture_.height)) +
        attribute("viewBox", "0 0 " + std::to_string(picture_.width) + " " + std::to_string(picture_.height)) +
        ">\n<title>" + escapedForSvg(metadata.title) + "</title>\n<desc>";
    for (const auto& [key, text] : metadata.texts) {
        svg_ += escapedForSvg(key + ": " + text) + "\n";
    }
    svg_ += "</desc>\n";
}

void SvgWriter::addBackdrop(const ui::VectorBackdrop& backdrop)
{
    const core::ColorImage& image = backdrop.image;
    const std::string png = io::encodePng({image.width, image.height, 3, &image.rgb}, {});
    svg_ += "<image" + attribute("x", px(backdrop.left)) + attribute("y", "0") +
            attribute("width", px(backdrop.width)) + attribute("height", std::to_string(picture_.height)) +
            attribute("preserveAspectRatio", "none") +
            attribute("xlink:href", "data:image/png;base64," + io::base64(png)) + "/>\n";
}

void SvgWriter::addPath(const StrokeShape& shape, std::size_t from, std::size_t to)
{
    svg_ += "<path d=\"";
    for (std::size_t i = from; i <= to; ++i) {
        svg_ += (i == from ? "M" : "L") + place(shape.line[i].at);
    }
    svg_ += "\"" + attribute("stroke", shape.line[from].color.hex()) +
            attribute("stroke-width", px(shape.pen.widthPx)) + opacityOf("stroke-opacity", shape.pen.opacity) + "/>\n";
}

/// Writes the line as one path per color.
void SvgWriter::addLine(const StrokeShape& shape)
{
    const StrokeLine& line = shape.line;
    std::size_t from = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        if (!isSameTone(line[from].color, line[i].color)) {
            addPath(shape, from, i);
            from = i;
        }
    }
    addPath(shape, from, line.size() - 1);
}

void SvgWriter::addDot(const StrokeShape& shape)
{
    const ui::StrokePoint& dot = shape.line.front();
    svg_ += "<circle" + attribute("cx", px(dot.at.x())) + attribute("cy", px(picture_.height - dot.at.y())) +
            attribute("r", px(0.5 * shape.pen.widthPx)) + attribute("fill", dot.color.hex()) +
            opacityOf("fill-opacity", shape.pen.opacity) + attribute("stroke", "none") + "/>\n";
}

void SvgWriter::addRibbon(const StrokeShape& shape)
{
    std::string outline;
    for (const ui::StrokePoint& point : shape.line) {
        outline += (outline.empty() ? "M" : "L") + place(point.at);
    }
    for (auto point = shape.other.rbegin(); point != shape.other.rend(); ++point) {
        outline += "L" + place(point->at);
    }
    svg_ += "<path" + attribute("d", outline + "Z") + attribute("fill", shape.line.front().color.hex()) +
            opacityOf("fill-opacity", shape.pen.opacity) + attribute("stroke", "none") + "/>\n";
}

void SvgWriter::addFill(const ui::VectorFill& fill)
{
    const double overlap = fill.opacity < 0.999 ? 0.0 : fillOverlap;
    svg_ += "<rect" + attribute("x", px(fill.rect.left)) + attribute("y", px(fill.rect.top)) +
            attribute("width", px(fill.rect.width())) + attribute("height", px(fill.rect.height() + overlap)) +
            attribute("fill", fill.color.hex()) + opacityOf("fill-opacity", fill.opacity) + "/>\n";
}

void SvgWriter::addText(const ui::VectorText& text)
{
    svg_ += "<text" + attribute("x", px(text.at.x())) + attribute("y", px(text.at.y())) +
            attribute("font-size", std::to_string(text.sizePx)) + attribute("fill", text.tone.hex()) +
            (text.align == ui::TextAlign::Right ? attribute("text-anchor", "end") : std::string()) + ">" +
            escapedForSvg(text.text) + "</text>\n";
}

std::string SvgWriter::write(const SvgMetadata& metadata)
{
    addHead(metadata);
    for (const ui::VectorBackdrop& backdrop : picture_.backdrops) {
        addBackdrop(backdrop);
    }
    svg_ += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const StrokeShape& shape : picture_.shapes) {
        if (shape.kind == StrokeShape::Kind::Ribbon) {
            addRibbon(shape);
        } else if (shape.line.size() == 1) {
            addDot(shape);
        } else {
            addLine(shape);
        }
    }
    svg_ += "</g>\n";
    for (const ui::VectorFill& fill : picture_.fills) {
        addFill(fill);
    }
    svg_ += "<g font-family=\"Inter, 'Noto Sans CJK SC', sans-serif\">\n";
    for (const ui::VectorText& text : picture_.texts) {
        addText(text);
    }
    svg_ += "</g>\n</svg>\n";
    return svg_;
}

}   // namespace

std::string toSvgDocument(const ui::VectorImage& picture, const SvgMetadata& metadata)
{
    return SvgWriter(picture).write(metadata);
}

}   // namespace angiopose::app
