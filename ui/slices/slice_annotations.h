#pragma once

#include "ui/slices/slice_model.h"

#include <QPointF>
#include <QRectF>
#include <QStringList>

#include <functional>

class QPainter;

namespace angiopose::ui {

/// Context for drawing over a slice, including the mapping from patient points to the widget.
struct SliceOverlay {
    const SliceModel& model;
    const core::SliceGrid& grid;
    core::BodyPlane plane = core::BodyPlane::Axial;
    std::function<QPointF(const Eigen::Vector3d&)> widgetFromPatient;
    QRectF area;
};

/// Distance from the slice up to which centerlines are drawn, fading out.
double visibleDistanceMm(const core::SliceGrid& grid);

void paintBranches(QPainter& painter, const SliceOverlay& overlay);
void paintPoints(QPainter& painter, const SliceOverlay& overlay);
void paintCrosshair(QPainter& painter, const SliceOverlay& overlay);

/// Areas covered by the corner texts.
struct CornerRoom {
    QRectF top;
    QRectF bottom;
};

/// Draws lines of text from the top left and the bottom left, readable on any image.
CornerRoom paintTexts(QPainter& painter, const QRectF& area, const QStringList& top, const QStringList& bottom);

/// Draws the letters of the patient's sides at the middle of the edges, clear of the corner texts.
void paintSides(QPainter& painter, const SliceOverlay& overlay, const CornerRoom& taken);

}   // namespace angiopose::ui