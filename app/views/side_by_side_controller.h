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

/// The views of the case beside each other: the shown one with all tools, the others each in a pane that follows it.
/// Whether they stand so is remembered and no part of the case; the frames of the others are.
class SideBySideController : public QObject {
    Q_OBJECT
public:
    /// What it works on.
    struct Parts {
        CaseDocument& document;
        PosePreview& preview;
        BranchController& branches;
        LookController& look;
        ViewController& views;
    };
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::ViewStrip& strip;
        ui::SideBySide& images;
    };
    SideBySideController(const Parts& parts, const Ui& ui, QObject* parent = nullptr);

signals:
    void reported(const QString& what);   ///< why nothing stands beside the image, …

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
    std::vector<std::unique_ptr<OtherView>> others_;   ///< one for each pane there ever was
    bool goAlong_ = true;   ///< as the titles say
    int frameBurst_ = 0;
    std::size_t burstPlace_ = 0;
    qint64 lastFrameMs_ = 0;
};

}   // namespace angiopose::app
