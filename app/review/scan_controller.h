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

/// Controls the volume rendering of the scan behind the vessels in the 3-D view: selects the scan and its appearance
/// and requests renderings from the current viewpoint, rough ones during rotation and a fine one at rest.
class ScanController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::TreeView& treeView;
        ui::CornerViews& corner;
        ui::SliceModel& slices;
        ui::BottomStrip& strip;
    };
    ScanController(const CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    bool isShown() const { return isShown_; }   ///< returns whether the 3-D view shows a rendering of the scan

private:
    void connectCommands();
    bool isWanted() const;
    void follow();
    void release();
    core::VolumeToPrepare toSee() const;
    core::ScanRequest look() const;
    void askRough();
    void askFine();
    /// Requests a rendering; returns false if nothing can be shown at the moment.
    bool request(const core::ScanRequest& wanted, int maxPx, ScanDetail detail);
    void show(const CastPicture& picture);
    void showState();
    void setStrength(double strength);

    const CaseDocument& document_;
    Ui ui_;
    ScanJob job_;
    QTimer rest_;   ///< times out when the view is at rest
    core::VolumeToPrepare seen_;   ///< volume that the job holds or is preparing
    core::ScanRequest asked_;   ///< appearance of the last request
    core::ScanPreset preset_;
    double strength_;
    bool isShown_ = false;
};

}   // namespace angiopose::app
