#pragma once

#include "app/document/case_document.h"
#include "app/review/look_controller.h"
#include "app/showing/pose_preview.h"
#include "app/views/other_view.h"
#include "app/views/view_controller.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <vector>

namespace angiopose::ui {
class SideBySide;
class ViewPane;
class ViewStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

class BranchController;

/// Shows the case's views side by side: the shown view with all tools, and each other view in its own pane. The
/// arrangement is a user preference and not part of the case; the frames of the other views are part of the case.
class SideBySideController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        CaseDocument& document;
        PosePreview& preview;
        BranchController& branches;
        LookController& look;
        ViewController& views;
    };
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& strip;
        ui::SideBySide& images;
    };
    SideBySideController(const Parts& parts, const Ui& ui, QObject* parent = nullptr);

signals:
    void reported(const QString& what);   ///< emits a note, e.g. why no other view can be shown

private:
    void connectCase();
    void connectLook();
    void connectPane(ui::ViewPane* pane);
    void setOn(bool on);
    void show();
    void showTitles();
    QString whyEmpty() const;
    std::vector<std::size_t> others() const;
    std::vector<std::size_t> placesOfPanes() const;
    void choose(std::size_t place, ui::AngiogramView& image);
    std::vector<OtherView*> shown() const;
    void takeLooks();
    void changeFrame(const OtherView& other, int frame);

    Parts on_;
    Ui ui_;
    std::vector<std::unique_ptr<OtherView>> others_;   ///< one for each pane created so far
    bool goAlong_ = true;   ///< whether the titles show the poses as linked
    int frameBurst_ = 0;
    std::size_t burstPlace_ = 0;
    qint64 lastFrameMs_ = 0;
};

}   // namespace angiopose::app
