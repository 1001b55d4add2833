#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_controller.h"
#include "app/jobs/job.h"
#include "core/registration/judging/branch_information.h"
#include "ui/dialogs/auxiliary_dialog.h"
#include "ui/views/tools/lasso_tool.h"

#include <QObject>
#include <QPointer>

#include <array>
#include <vector>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// The choice of auxiliary branches made easy: by lasso, generation and radius, and by what each branch tells about the
/// pose, with a live account of what the choice would do.
class AuxiliaryController : public QObject {
    Q_OBJECT
public:
    AuxiliaryController(CaseDocument& document, BranchController& branches, ui::WindowActions& actions,
                        ui::AngiogramView& view, QWidget& dialogParent, QObject* parent = nullptr);

    bool isRunning() const { return job_.isRunning(); }   ///< working out what each branch tells
    void open();
    ui::AuxiliaryDialog* dialog() const { return dialog_; }   ///< null while it is closed
    const std::vector<int>& suggestion() const { return advice_.suggested; }

    void chooseInside(const QPolygonF& outlineInImagePx, ui::LassoEffect effect);
    void chooseGenerations(int last);
    void chooseWide(double atLeastMm);
    void chooseSuggestion();

signals:
    void refused(const QString& why);
    void adviceChanged();

private:
    /// What a worker finds out about the pose.
    struct Advice {
        core::Vector6d stdOfAll = core::Vector6d::Zero();
        core::Vector6d stdOfChosen = core::Vector6d::Zero();
        std::array<std::vector<int>, 6> pinnedBy;
        std::vector<int> suggested;
    };
    void connectDialog();
    void takeAlternatingMethod();
    void request();
    void start();
    void take(const Advice& advice);
    void show();
    QString namesOf(const std::vector<int>& branchIds) const;
    QString previewWords() const;

    CaseDocument& document_;
    BranchController& branches_;
    ui::WindowActions& actions_;
    ui::AngiogramView& view_;
    QWidget& dialogParent_;
    QPointer<ui::AuxiliaryDialog> dialog_;
    Job<Advice> job_;
    Advice advice_;
    bool isKnown_ = false;
    bool isWanted_ = false;   ///< again, when the running one is done
};

}   // namespace angiopose::app