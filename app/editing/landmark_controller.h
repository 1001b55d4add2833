#pragma once

#include "app/document/case_document.h"
#include "ui/views/tools/landmark_tool.h"
#include "ui/words/retranslation.h"

#include <memory>

namespace angiopose::ui {
class AngiogramView;
class LandmarkPanel;
class SliceModel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Manages landmark pairs: a point on the vessels (3-D view or slice; snaps to nodes) and its image point, clicked in
/// either order. Lists, moves and removes pairs and sets the initial pose from them; each change is one undo step.
class LandmarkController : public QObject {
    Q_OBJECT
public:
    /// Parts of the window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::LandmarkPanel& panel;
        ui::AngiogramView& view;
        ui::TreeView& treeView;
        ui::SliceModel& slices;
    };
    LandmarkController(CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void pickPoint(const Eigen::Vector3d& pointInPatient);   ///< takes effect only in landmark mode
    void pickPixel(const Eigen::Vector2d& pixel);
    void setInitialPose();

signals:
    void refused(const QString& reason);
    void placed(const QString& verdict);

private:
    void connectTool();
    void updateFromDocument();
    void showState();
    void completePair();
    void addPair(const Eigen::Vector3d& pointInPatient, const Eigen::Vector2d& pixel);
    void removePairs(const std::vector<int>& indices);
    void change(std::vector<core::Landmark> landmarks, const ui::LocalizedText& name);
    void clearPending();
    std::optional<core::RigidTransform> initialPoseGuess() const;

    CaseDocument& document_;
    Ui ui_;
    ui::LandmarkTool* tool_;
    std::shared_ptr<const core::VesselTree> tree_;   ///< tree to which `nodes_` belong
    std::vector<core::VesselNode> nodes_;
    std::optional<Eigen::Vector3d> pendingPoint_;
    std::optional<Eigen::Vector2d> pendingPixel_;
};

}   // namespace angiopose::app
