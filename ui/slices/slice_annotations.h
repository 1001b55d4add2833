#pragma once

#include "ui/slices/slice_model.h"

#include <QPointF>
#include <QRectF>
#include <QStringList>

#include <functional>

class QPainter;

namespace angiopose::ui {

/// What is drawn over the picture of a slice, and where patient points lie in the widget.
struct SliceOverlay {
    const SliceModel& model;
    const core::SliceGrid& grid;
    core::BodyPlane plane = core::BodyPlane::Axial;
    std::function<QPointF(const Eigen::Vector3d&)> widgetFromPatient;
    QRectF area;
};

/// How far from the slice a centreline still shows; it fades on the way there.
double visibleDistanceMm(const core::SliceGrid& grid);

void paintBranches(QPainter& painter, const SliceOverlay& overlay);
void paintPoints(QPainter& painter, const SliceOverlay& overlay);
void paintCrosshair(QPainter& painter, const SliceOverlay& overlay);

/// What the corner texts cover.
struct CornerRoom {
    QRectF top;
    QRectF bottom;
};

/// Lines of text from the top left and from the bottom left, readable on any picture.
CornerRoom paintTexts(QPainter& painter, const QRectF& area, const QStringList& top, const QStringList& bottom);

/// Letters of the patient's sides at the middle of the edges, clear of the corner texts.
void paintSides(QPainter& painter, const SliceOverlay& overlay, const CornerRoom& taken);

}   // namespace angiopose::ui