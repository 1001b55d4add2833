#pragma once

#include "ui/scenes/line_data.h"
#include "ui/scenes/shader_actor.h"

#include <optional>

namespace angiopose::ui {

/// How one layer of lines is drawn; lengths in device px.
struct LinePass {
    enum class Shape { Center, Edges, Inside };
    Shape shape = Shape::Center;   ///< edges and inside where radii are known
    double lineWidthPx = 2.0;   ///< of a line whose width factor is 1
    double widthGain = 1.0;   ///< width = gain × line width × factor + extra
    double widthExtraPx = 0.0;
    double fadePx = 1.0;   ///< fade = this + gain × line width × factor
    double fadeGain = 0.0;
    double opacityGain = 1.0;   ///< of the line's own
    double opacity = 1.0;   ///< of the whole layer
    std::optional<Color> shade;   ///< instead of the lines' own tones
    std::array<float, 2> dashPx{0.0F, 0.0F};   ///< drawn and gap of dashed lines
    bool hasEndDots = false;
    std::optional<DepthRange> depth;   ///< near points towards white, far points towards the canvas
};

/// One layer of lines: halos, cores, … of the same data.
class LineLayer : public ShaderActor {
public:
    explicit LineLayer(LineData& data);
    void show(const LinePass& pass, const OverlayContent& content, const PicturePlace& place);

private:
    void showPen(const LinePass& pass);
    void showDepth(const LinePass& pass);
};

}   // namespace angiopose::ui
