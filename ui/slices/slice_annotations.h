#pragma once

#include "ui/slices/slice_model.h"

#include <QPointF>
#include <QRectF>
#include <QStringList>

#include <functional>

class QPainter;

namespace angiopose::ui {

/// Context for drawing over a slice, including the map from patient points to widget px.
struct SliceOverlay {
    const SliceModel& model;
    const core::SliceGrid& grid;
    core::BodyPlane plane = core::BodyPlane::Axial;
    std::function<QPointF(const Eigen::Vector3d&)> widgetFromPatient;
    QRectF area;
};

/// Returns the distance from the slice, mm, up to which centerlines are drawn; they fade with the distance.
double visibleDistanceMm(const core::SliceGrid& grid);

void paintBranches(QPainter& painter, const SliceOverlay& overlay);
void paintPoints(QPainter& painter, const SliceOverlay& overlay);
void paintCrosshair(QPainter& painter, const SliceOverlay& overlay);

/// Areas covered by corner text.
struct CornerAreas {
    QRectF top;
    QRectF bottom;
};

/// Draws lines of text in the upper left and lower left corners, readable on any image; returns the areas covered.
CornerAreas paintTexts(QPainter& painter, const QRectF& area, const QStringList& top, const QStringList& bottom);

/// Draws the orientation letters (patient's sides) at the middle of the edges, clear of corner text.
void paintSides(QPainter& painter, const SliceOverlay& overlay, const CornerAreas& occupied);

}   // namespace angiopose::ui
