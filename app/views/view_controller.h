#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "app/registration/target_provider.h"
#include "app/views/look_at_view.h"

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <vector>

class QPoint;
class QWidget;

namespace angiopose::ui {
class RegistrationPanel;
class ViewStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Several angiograms of the same vessels: the strip of views with how each agrees, which of them is shown, taking one
/// out. Showing another view is a step of undo.
class ViewController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& panel;
        ui::RegistrationPanel& registration;
        QWidget& dialogParent;
    };
    ViewController(CaseDocument& document, const TargetProvider& target, const Ui& ui, QObject* parent = nullptr);

    bool isLooking() const { return looking_.isRunning(); }   ///< making pictures and numbers of the views
    /// The traced vessels of view `place`; null until somebody has looked. See `looked`.
    std::shared_ptr<const core::Centerline2d> targetOf(std::size_t place) const;
    void show(int line);
    void showNext();
    void openMenu(int line, const QPoint& at);   ///< what can be done with that view
    void askName(int line);
    void remove(int line);   ///< in place of the shown view the next one is shown

signals:
    void refused(const QString& reason);
    void looked();   ///< at the views: `targetOf`

private:
    /// Something of a case that the pictures and numbers hang on.
    struct Seen {
        std::shared_ptr<const core::VesselTree> tree;
        std::vector<int> excluded;
        std::vector<int> hidden;
        std::vector<ViewSight> views;
        SharedCenterline target;

        bool operator==(const Seen&) const = default;
    };
    void connectWindow();
    void followDocument();
    void showLines();
    void showPictures(std::vector<ViewLook> looks);
    void look();
    const ViewLook* lookOf(std::size_t place) const;

    CaseDocument& document_;
    const TargetProvider& target_;
    Ui ui_;
    std::size_t lineCount_ = 0;   ///< the lines are the case's views, in their order; none while there is only one
    Seen seen_;
    std::vector<ViewLook> looks_;
    QTimer pause_;   ///< pictures are drawn when things have come to rest
    Job<std::vector<ViewLook>> looking_;
};

}   // namespace angiopose::app