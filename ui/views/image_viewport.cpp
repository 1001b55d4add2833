#include "ui/views/image_viewport.h"

#include <algorithm>

namespace angiopose::ui {
namespace {

constexpr double minZoom = 0.02;
constexpr double maxZoom = 64.0;

}   // namespace

void ImageViewport::setImageSize(int width, int height)
{
    if (width == imageWidth_ && height == imageHeight_) {
        return;
    }
    imageWidth_ = width;
    imageHeight_ = height;
    fit();
}

void ImageViewport::setWidgetSize(double width, double height)
{
    widgetSize_ = {std::max(1.0, width), std::max(1.0, height)};
    if (isFitted_) {
        fit();
    }
}

void ImageViewport::fit()
{
    isFitted_ = true;
    zoom_ = std::min(widgetSize_.x() / std::max(1, imageWidth_), widgetSize_.y() / std::max(1, imageHeight_));
    center_ = 0.5 * Eigen::Vector2d(imageWidth_ - 1, imageHeight_ - 1);
}

void ImageViewport::show(const ViewRect& rect)
{
    const double zoom =
        std::min(widgetSize_.x() / std::max(1.0, rect.width()), widgetSize_.y() / std::max(1.0, rect.height()));
    zoom_ = std::clamp(zoom, minZoom, maxZoom);
    center_ = 0.5 * Eigen::Vector2d(rect.left + rect.right, rect.top + rect.bottom);
    isFitted_ = false;
}

void ImageViewport::zoomAt(const Eigen::Vector2d& position, double factor)
{
    const Eigen::Vector2d anchor = imageFromWidget(position);
    zoom_ = std::clamp(zoom_ * factor, minZoom, maxZoom);
    center_ = anchor - mirrorOffset(position - 0.5 * widgetSize_) / zoom_;
    isFitted_ = false;
}

void ImageViewport::panBy(const Eigen::Vector2d& step)
{
    center_ -= mirrorOffset(step) / zoom_;
    isFitted_ = false;
}

void ImageViewport::setMirrored(bool mirrored)
{
    mirrored_ = mirrored;
}

ViewRect ImageViewport::rect() const
{
    return imageRectOf({0.0, 0.0}, widgetSize_);
}

ViewRect ImageViewport::imageRectOf(const Eigen::Vector2d& topLeft, const Eigen::Vector2d& bottomRight) const
{
    const Eigen::Vector2d a = imageFromWidget(topLeft);
    const Eigen::Vector2d b = imageFromWidget(bottomRight);
    return {std::min(a.x(), b.x()), std::max(a.x(), b.x()), a.y(), b.y()};
}

Eigen::Vector2d ImageViewport::imageFromWidget(const Eigen::Vector2d& position) const
{
    return center_ + mirrorOffset(position - 0.5 * widgetSize_) / zoom_;
}

Eigen::Vector2d ImageViewport::widgetFromImage(const Eigen::Vector2d& imagePoint) const
{
    return 0.5 * widgetSize_ + mirrorOffset(imagePoint - center_) * zoom_;
}

}   // namespace angiopose::ui
