#pragma once

#include "core/imaging/display_range.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/render_offscreen.h"
#include "ui/theme/theme.h"
#include "ui/views/image_sides.h"
#include "ui/views/image_viewport.h"

#include <QRectF>
#include <QSizeF>
#include <QString>

#include <vector>

class QPainter;

namespace angiopose::ui {

/// Label of the current mouse mode, shown if a tool is active.
struct ModeLabel {
    QString text;   ///< empty without a mode
    Color tone;   ///< color of border and text
};

/// Text, residual scale and ruler drawn over the angiogram.
struct AngiogramAnnotations {
    CornerTexts texts;
    QString frameText;
    QString keyText;   ///< hint about available shortcuts
    core::DisplayRange range;
    double scaleMaximumPx = 0.0;   ///< maximum of the residual scale; if 0, the scale is hidden
    double scaleMaximumMm = 0.0;
    double mmPerImagePx = 0.0;   ///< scale at the vessels; if 0, the ruler is hidden
    QString sideMark;   ///< note that the image or the view is mirrored; empty in the detector view
    ImageSides sides;   ///< letters at the edges; empty if the orientation is unknown
    ModeLabel mode;
    bool isScaleHidden = false;   ///< hides the residual scale if no residuals are visible
    std::vector<QRectF> occupied;   ///< areas of other items, which the text avoids
};

/// Paints the annotations over a widget of this size. Text next to the image appears in full; text over the image
/// shrinks, and then collapses to one line, before it covers vessels.
void paintAnnotations(QPainter& painter, const QSizeF& size, const AngiogramAnnotations& annotations,
                      const ImageViewport& viewport, const OverlayScene& scene);

}   // namespace angiopose::ui
