#pragma once

#include "ui/views/tools/edit_curves_tool.h"

#include <QFrame>

#include <map>

class QLabel;
class QPushButton;
class QToolButton;

namespace angiopose::ui {

/// The edits of the traced curves as buttons, at the bottom of the angiogram while that mode is on.
class CurveEditBar : public QFrame {
    Q_OBJECT
public:
    explicit CurveEditBar(QWidget* parent = nullptr);

    void showEdit(CurveEdit edit);
    struct Counts {
        int curves = 0;   ///< but those apart
        int suspects = 0;   ///< among them
        int devices = 0;   ///< kept apart

        bool operator==(const Counts&) const = default;
    };
    void showCurves(const Counts& counts);
    void setEdited(bool edited);   ///< only edited curves can be traced again

signals:
    void editChosen(ui::CurveEdit edit);
    void traceAgainRequested();
    void followRequested();   ///< of the catheter or wire that is kept apart
    void doneRequested();

private:
    void sayCounts();

    std::map<CurveEdit, QToolButton*> buttons_;
    Counts shownCounts_;
    QLabel* count_;
    QPushButton* followDevice_;
    QPushButton* traceAgain_;
};

}   // namespace angiopose::ui