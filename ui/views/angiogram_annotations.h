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

/// What the mouse does at the moment, where that is not the usual.
struct ModeLabel {
    QString text;   ///< empty: no mode
    Color tone;   ///< of the border and the text
};

/// Text, scale and ruler that lie over the angiogram.
struct AngiogramAnnotations {
    CornerTexts texts;
    QString frameText;
    QString keyText;   ///< what a key would show
    core::DisplayRange range;
    double scaleMaximumPx = 0.0;   ///< 0: no residual scale
    double scaleMaximumMm = 0.0;
    double mmPerImagePx = 0.0;   ///< at the vessel; 0: no ruler
    QString sideMark;   ///< that image or view are mirrored; empty: as from the detector
    ImageSides sides;   ///< empty: nobody knows
    ModeLabel mode;
    bool hidesScale = false;   ///< no residuals are seen
    std::vector<QRectF> taken;   ///< by what lies on the image: texts keep clear of it
};

/// Paints them in a widget of this size. Texts beside the picture stay whole; over the picture they shrink and then
/// fold to their first line before they cover vessels.
void paintAnnotations(QPainter& painter, const QSizeF& size, const AngiogramAnnotations& annotations,
                      const ImageViewport& viewport, const OverlayScene& scene);

}   // namespace angiopose::ui