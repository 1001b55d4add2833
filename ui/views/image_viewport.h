#pragma once

#include "ui/scenes/overlay_scene.h"

namespace angiopose::ui {

/// Visible part of an image in a widget. Widget positions are device-independent px from the top left.
class ImageViewport {
public:
    void setImageSize(int width, int height);   ///< fits the image to the widget if the image size has changed
    void setWidgetSize(double width, double height);   ///< a fitted image stays fitted
    void fit();
    void show(const ViewRect& rect);   ///< centers `rect` and shows it as large as the widget allows
    void zoomAt(const Eigen::Vector2d& position, double factor);   ///< keeps the image point under `position` fixed
    void panBy(const Eigen::Vector2d& step);   ///< moves the image with the pointer
    void setMirrored(bool mirrored);   ///< swaps left and right in the widget; the visible part is unchanged
    bool isMirrored() const { return mirrored_; }
    bool isFitted() const { return isFitted_; }   ///< stays true when the widget is resized

    double zoom() const { return zoom_; }   ///< widget px per image px
    ViewRect rect() const;
    ViewRect imageRectOf(const Eigen::Vector2d& topLeft, const Eigen::Vector2d& bottomRight) const;   ///< left < right
    Eigen::Vector2d imageFromWidget(const Eigen::Vector2d& position) const;
    Eigen::Vector2d widgetFromImage(const Eigen::Vector2d& imagePoint) const;

private:
    int imageWidth_ = 512;
    int imageHeight_ = 512;
    Eigen::Vector2d widgetSize_{480.0, 360.0};
    Eigen::Vector2d center_{255.5, 255.5};   // image point at the center of the widget
    double zoom_ = 1.0;
    bool isFitted_ = true;
    bool mirrored_ = false;

    /// Converts a displacement in the widget to image directions, without scaling.
    Eigen::Vector2d mirrorOffset(const Eigen::Vector2d& offset) const
    {
        return {mirrored_ ? -offset.x() : offset.x(), offset.y()};
    }
};

}   // namespace angiopose::ui
