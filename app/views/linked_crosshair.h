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

/// One cross-hair for views that stand side by side. What lies under the pointer in one is a line in the others
/// (ALGORITHMS §5.7); the place on the vessels under it is a point in all, and in 3-D. A click takes the slices there.
class LinkedCrosshair : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& strip;
        ui::SideBySide& images;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
    };
    LinkedCrosshair(const CaseDocument& document, const PosePreview& preview, const Ui& ui, QObject* parent = nullptr);

signals:
    void reported(const QString& what);

private:
    void follow(ui::AngiogramView& image);
    void setOn(bool on);
    void point(ui::AngiogramView& image, const std::optional<Eigen::Vector2d>& imagePx);
    void show();
    void hide();
    std::optional<Eigen::Vector3d> placeUnderPointer() const;
    bool isLinking() const;

    Ui ui_;
    QPointer<ui::AngiogramView> pointedIn_;
    std::optional<Eigen::Vector2d> pointerPx_;   ///< in the image `pointedIn_`; nothing while it is elsewhere
    QTimer again_;   ///< after poses have changed under the pointer
};

}   // namespace angiopose::app
