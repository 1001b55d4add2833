#pragma once

#include "ui/scenes/line_data.h"
#include "ui/scenes/shader_actor.h"

#include <optional>

namespace angiopose::ui {

/// Drawing parameters of a line layer; lengths in device px.
struct LinePass {
    enum class Shape { Center, Edges, Inside };
    Shape shape = Shape::Center;   ///< `Edges` and `Inside` require known radii
    double lineWidthPx = 2.0;   ///< width of a line with width factor 1
    double widthGain = 1.0;   ///< width = widthGain × line width × factor + widthExtraPx
    double widthExtraPx = 0.0;
    double fadePx = 1.0;   ///< fade = fadePx + fadeGain × line width × factor
    double fadeGain = 0.0;
    double opacityGain = 1.0;   ///< factor applied to the opacity of each line
    double opacity = 1.0;   ///< opacity of the whole layer
    std::optional<Color> shade;   ///< color that replaces the colors of the lines
    std::array<float, 2> dashPx{0.0F, 0.0F};   ///< dash and gap lengths of dashed lines
    bool hasEndDots = false;
    std::optional<DepthRange> depth;   ///< if set, blends near points toward white and far points toward the background
};

/// Layer of lines, such as halos or cores; several layers draw the same data.
class LineLayer : public ShaderActor {
public:
    explicit LineLayer(LineData& data);
    void show(const LinePass& pass, const OverlayContent& content, const ImagePlacement& placement);

private:
    void setPenUniforms(const LinePass& pass);
    void showDepth(const LinePass& pass);
};

}   // namespace angiopose::ui
