#pragma once

#include "ui/scenes/overlay_scene.h"

namespace angiopose::ui {

/// Which part of an image a widget shows. Widget positions are device-independent px from the top left.
class ImageViewport {
public:
    void setImageSize(int width, int height);   ///< a new size fits the image
    void setWidgetSize(double width, double height);   ///< keeps a fitted image fitted
    void fit();
    void show(const ViewRect& rect);   ///< as large as the widget allows, in its middle
    void zoomAt(const Eigen::Vector2d& position, double factor);   ///< what lies under `position` stays there
    void panBy(const Eigen::Vector2d& step);   ///< the image follows the mouse
    void setMirrored(bool mirrored);   ///< left and right exchanged in the widget; what it shows stays
    bool isMirrored() const { return mirrored_; }
    bool isFitted() const { return isFitted_; }   ///< stays so when the widget changes its size

    double zoom() const { return zoom_; }   ///< widget px per image px
    ViewRect rect() const;
    ViewRect imageRectOf(const Eigen::Vector2d& topLeft, const Eigen::Vector2d& bottomRight) const;   ///< left < right
    Eigen::Vector2d imageFromWidget(const Eigen::Vector2d& position) const;
    Eigen::Vector2d widgetFromImage(const Eigen::Vector2d& imagePoint) const;

private:
    int imageWidth_ = 512;
    int imageHeight_ = 512;
    Eigen::Vector2d widgetSize_{480.0, 360.0};
    Eigen::Vector2d center_{255.5, 255.5};   // image point in the middle of the widget
    double zoom_ = 1.0;
    bool isFitted_ = true;
    bool mirrored_ = false;

    /// A way in the widget as it goes in the image, not scaled.
    Eigen::Vector2d turned(const Eigen::Vector2d& way) const { return {mirrored_ ? -way.x() : way.x(), way.y()}; }
};

}   // namespace angiopose::ui