#pragma once

#include "ui/views/tools/edit_curves_tool.h"

#include <QFrame>

#include <map>

class QLabel;
class QPushButton;
class QToolButton;

namespace angiopose::ui {

/// Bar with the tools for editing the traced curves, at the bottom of the angiogram while the mode is on.
class CurveEditBar : public QFrame {
    Q_OBJECT
public:
    explicit CurveEditBar(QWidget* parent = nullptr);

    void showEdit(CurveEdit edit);
    struct Counts {
        int curves = 0;   ///< number of curves except devices
        int suspects = 0;   ///< number of curves that may be devices
        int devices = 0;   ///< number of curves marked as devices

        bool operator==(const Counts&) const = default;
    };
    void showCurves(const Counts& counts);
    void setEdited(bool edited);   ///< enables "Trace again", which discards edits

signals:
    void editChosen(ui::CurveEdit edit);
    void traceAgainRequested();
    void trackDeviceRequested();   ///< requests tracking of the marked catheter or guidewire
    void finishRequested();

private:
    void updateCounts();

    std::map<CurveEdit, QToolButton*> buttons_;
    Counts shownCounts_;
    QLabel* count_;
    QPushButton* followDevice_;
    QPushButton* traceAgain_;
};

}   // namespace angiopose::ui
