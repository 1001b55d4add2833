#pragma once

#include "app/document/case_document.h"
#include "app/showing/pose_preview.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <optional>

namespace angiopose::ui {
class AngiogramView;
class SideBySide;
class SliceModel;
class TreeView;
class ViewStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Shows a linked crosshair in side-by-side views. The pointer position in one view becomes a line in the others
/// (ALGORITHMS §5.7); a vessel point under the pointer is marked in all views and in 3-D. A click moves the slices to
/// that point.
class LinkedCrosshair : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& strip;
        ui::SideBySide& images;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
    };
    LinkedCrosshair(const CaseDocument& document, const PosePreview& preview, const Ui& ui, QObject* parent = nullptr);

signals:
    void reported(const QString& message);

private:
    void follow(ui::AngiogramView& image);
    void setOn(bool on);
    void point(ui::AngiogramView& image, const std::optional<Eigen::Vector2d>& imagePx);
    void show();
    void hide();
    std::optional<Eigen::Vector3d> pointUnderPointer() const;
    bool isLinking() const;

    Ui ui_;
    QPointer<ui::AngiogramView> pointerView_;
    std::optional<Eigen::Vector2d>
        pointerPx_;   ///< pointer position in the image of `pointerView_`; nullopt if the pointer is outside
    QTimer updateTimer_;   ///< delays the update after a change of pose
};

}   // namespace angiopose::app
