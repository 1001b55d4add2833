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
/// and requests renderings from the current viewpoint: rough ones during rotation, a fine one at rest.
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
    bool isEnabled() const;
    void updateFromDocument();
    void releaseData();
    core::VolumePreparation volumeToShow() const;
    core::AppearanceOptions appearance() const;
    void requestRough();
    void requestFine();
    /// Requests a rendering; returns false if nothing can be shown now.
    bool request(const core::AppearanceOptions& options, int maxPx, ScanDetail detail);
    void show(const ScanRendering& picture);
    void showState();
    void setStrength(double strength);

    const CaseDocument& document_;
    Ui ui_;
    ScanJob job_;
    QTimer idleTimer_;   ///< times out when the view has come to rest
    core::VolumePreparation shownVolume_;   ///< volume that the job holds or is preparing
    core::AppearanceOptions requestedAppearance_;   ///< appearance of the last request
    core::ScanPreset preset_;
    double strength_;
    bool isShown_ = false;
};

}   // namespace angiopose::app
