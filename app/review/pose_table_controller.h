#pragma once

#include "app/document/case_document.h"
#include "app/files/export_controller.h"
#include "app/jobs/method_series_job.h"
#include "app/registration/target_provider.h"
#include "app/review/snapshot_controller.h"
#include "ui/dialogs/pose_table.h"

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
class SnapshotPanel;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The comparison table: kept poses, runs and the pose as it is side by side; runs several methods to fill it.
class PoseTableController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::SnapshotPanel& panel;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    PoseTableController(CaseDocument& document, TargetProvider& target, SnapshotController& snapshots,
                        ExportController& exporting, const Ui& ui, QObject* parent = nullptr);

    void open();
    void close();
    ui::PoseTable* table() const { return table_; }   ///< null while it is closed
    bool isRunning() const { return job_.isRunning(); }
    void run(const std::vector<std::string>& methodIds);
    void stop() { job_.requestStop(); }

private:
    /// What the runs started from: their results fit nothing else. It does not keep a closed case.
    struct Origin {
        int caseNumber = 0;
        std::weak_ptr<const core::VesselTree> tree;
        std::weak_ptr<const core::Angiogram> angiogram;
        int frame = 0;
    };
    void connectTable();
    void connectJob();
    void refresh();
    std::vector<core::PoseSnapshot> listed() const;   ///< the pose as it is first
    void take(const core::RegistrationResult& result);
    void flush();
    void finish(bool wasStopped);
    void exportTable();

    CaseDocument& document_;
    TargetProvider& target_;
    SnapshotController& snapshots_;
    ExportController& exporting_;
    Ui ui_;
    QPointer<ui::PoseTable> table_;
    MethodSeriesJob job_;
    Origin origin_;
    std::vector<std::string> chosen_;
    std::vector<core::PoseSnapshot> waiting_;   ///< solved while the case was locked
    QStringList failures_;
    int solvedCount_ = 0;
    int burst_ = 0;
    int referenceId_ = 0;
};

}   // namespace angiopose::app