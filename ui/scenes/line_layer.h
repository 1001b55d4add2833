#pragma once

#include "ui/scenes/line_data.h"
#include "ui/scenes/shader_actor.h"

#include <optional>

namespace angiopose::ui {

/// Drawing parameters of one layer of lines; lengths in device px.
struct LinePass {
    enum class Shape { Center, Edges, Inside };
    Shape shape = Shape::Center;   ///< Edges and Inside need known radii
    double lineWidthPx = 2.0;   ///< width of a line with width factor 1
    double widthGain = 1.0;   ///< width = gain × line width × factor + extra
    double widthExtraPx = 0.0;
    double fadePx = 1.0;   ///< fade = this + gain × line width × factor
    double fadeGain = 0.0;
    double opacityGain = 1.0;   ///< factor on the line's own opacity
    double opacity = 1.0;   ///< opacity of the whole layer
    std::optional<Color> shade;   ///< replaces the lines' own colors
    std::array<float, 2> dashPx{0.0F, 0.0F};   ///< dash and gap of dashed lines
    bool hasEndDots = false;
    std::optional<DepthRange> depth;   ///< blends near points towards white, far points towards the background
};

/// One layer of lines (halos, cores, …) drawn from shared data.
class LineLayer : public ShaderActor {
public:
    explicit LineLayer(LineData& data);
    void show(const LinePass& pass, const OverlayContent& content, const PicturePlace& place);

private:
    void showPen(const LinePass& pass);
    void showDepth(const LinePass& pass);
};

}   // namespace angiopose::ui
