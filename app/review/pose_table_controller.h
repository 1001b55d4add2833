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

/// Manages the table that compares snapshots, registrations and the current pose; runs several methods to fill it.
class PoseTableController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::SnapshotPanel& panel;
        ui::BottomStrip& strip;
        QWidget& dialogParent;
    };
    PoseTableController(CaseDocument& document, TargetProvider& target, SnapshotController& snapshots,
                        ExportController& exportController, const Ui& ui, QObject* parent = nullptr);

    void open();
    void close();
    ui::PoseTable* table() const { return table_; }   ///< null while the table is closed
    bool isRunning() const { return job_.isRunning(); }
    void run(const std::vector<std::string>& methodIds);
    void stop() { job_.requestStop(); }

private:
    /// Input of the registrations, for which alone their results are valid. Does not keep a closed case in memory.
    struct Origin {
        int caseNumber = 0;
        std::weak_ptr<const core::VesselTree> tree;
        std::weak_ptr<const core::Angiogram> angiogram;
        int frame = 0;
    };
    void connectTable();
    void connectJob();
    void refresh();
    std::vector<core::PoseSnapshot> tableEntries() const;   ///< returns the current pose followed by the snapshots
    void addResult(const core::RegistrationResult& result);
    void storePending();
    void finish(bool wasStopped);
    void exportTable();

    CaseDocument& document_;
    TargetProvider& target_;
    SnapshotController& snapshots_;
    ExportController& exportController_;
    Ui ui_;
    QPointer<ui::PoseTable> table_;
    MethodSeriesJob job_;
    Origin origin_;
    std::vector<std::string> methodIds_;
    std::vector<core::PoseSnapshot> pending_;   ///< results that arrived while the case was locked
    QStringList failures_;
    int solvedCount_ = 0;
    int mergeId_ = 0;
    int referenceId_ = 0;
};

}   // namespace angiopose::app
