#pragma once

#include "app/document/case_document.h"
#include "app/review/overlay_style_controller.h"
#include "app/showing/pose_preview.h"
#include "app/views/secondary_view.h"
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

/// Shows the case's views side by side: the shown view with all tools, and each of the other views in its own pane. The
/// arrangement is a user preference and not part of the case; the frames of the other views are part of the case.
class SideBySideController : public QObject {
    Q_OBJECT
public:
    /// Objects that the controller works with.
    struct Parts {
        CaseDocument& document;
        PosePreview& preview;
        BranchController& branches;
        OverlayStyleController& overlayStyle;
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
    void reported(const QString& message);   ///< emitted with a note, e.g. why no other view can be shown

private:
    void connectCase();
    void connectOverlayStyle();
    void connectPane(ui::ViewPane* pane);
    void setOn(bool on);
    void show();
    void showTitles();
    QString emptyReason() const;
    std::vector<std::size_t> others() const;
    std::vector<std::size_t> paneViewIndices() const;
    void choose(std::size_t viewIndex, ui::AngiogramView& image);
    std::vector<SecondaryViewController*> shown() const;
    void applyDisplaySettingsToAll();
    void changeFrame(const SecondaryViewController& other, int frame);

    Parts parts_;
    Ui ui_;
    std::vector<std::unique_ptr<SecondaryViewController>> others_;   ///< one for each pane created so far
    bool areLinked_ = true;   ///< whether the titles show the poses as linked
    int frameMergeId_ = 0;
    std::size_t mergedViewIndex_ = 0;
    qint64 lastFrameChangeMs_ = 0;
};

}   // namespace angiopose::app
