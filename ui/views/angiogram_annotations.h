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

/// Label of the current mouse mode, if it is not the default.
struct ModeLabel {
    QString text;   ///< empty: no mode
    Color tone;   ///< color of border and text
};

/// Texts, scale and ruler over the angiogram.
struct AngiogramAnnotations {
    CornerTexts texts;
    QString frameText;
    QString keyText;   ///< hint about available shortcuts
    core::DisplayRange range;
    double scaleMaximumPx = 0.0;   ///< 0: no residual scale
    double scaleMaximumMm = 0.0;
    double mmPerImagePx = 0.0;   ///< at the vessel; 0: no ruler
    QString sideMark;   ///< note that image or view is mirrored; empty: detector view
    ImageSides sides;   ///< empty if unknown
    ModeLabel mode;
    bool hidesScale = false;   ///< no residuals are visible
    std::vector<QRectF> taken;   ///< areas covered by other items, avoided by texts
};

/// Paints the annotations in a widget of this size. Texts outside the image area are shown in full; over the image they
/// shrink and then collapse to their first line before they would cover vessels.
void paintAnnotations(QPainter& painter, const QSizeF& size, const AngiogramAnnotations& annotations,
                      const ImageViewport& viewport, const OverlayScene& scene);

}   // namespace angiopose::ui