#pragma once

#include "app/document/case_document.h"
#include "app/jobs/scan_job.h"

#include <QObject>
#include <QTimer>

namespace angiopose::ui {
class BottomStrip;
class CornerViews;
class SliceModel;
class TreeView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The scan behind the vessels in the 3-D view: which one, how it is seen, and pictures of it from wherever one looks,
/// rough while the view turns and fine at rest.
class ScanController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::TreeView& treeView;
        ui::CornerViews& corner;
        ui::SliceModel& slices;
        ui::BottomStrip& strip;
    };
    ScanController(const CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    bool isShown() const { return isShown_; }   ///< a picture of it is in the view

private:
    void connectCommands();
    bool isWanted() const;
    void follow();
    void release();
    core::VolumeToPrepare toSee() const;
    core::ScanRequest look() const;
    void askRough();
    void askFine();
    /// False: nothing can be seen now.
    bool request(const core::ScanRequest& wanted, int maxPx, ScanDetail detail);
    void show(const CastPicture& picture);
    void showState();
    void setStrength(double strength);

    const CaseDocument& document_;
    Ui ui_;
    ScanJob job_;
    QTimer rest_;   ///< until the view has come to rest
    core::VolumeToPrepare seen_;   ///< what the job has, or is given
    core::ScanRequest asked_;   ///< how it was to be seen last
    core::ScanPreset preset_;
    double strength_;
    bool isShown_ = false;
};

}   // namespace angiopose::app
