#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
}   // namespace angiopose::ui

namespace angiopose::app {

/// What the program tells the user in passing: notes in the strip below, problems in a box.
class Notices : public QObject {
    Q_OBJECT
public:
    /// While `isBusy` says so the strip shows the progress of a task; notes stand beside it.
    Notices(ui::BottomStrip& strip, QWidget& dialogParent, std::function<bool()> isBusy, QObject* parent = nullptr);

    void showNote(const QString& note);   ///< in the strip, for a while
    void showWarnings(const QString& warnings);   ///< in the strip, until something else is to be told
    void showProblem(const QString& heading, const QString& reason, const QStringList& paths = {});

private:
    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    std::function<bool()> isBusy_;
    QTimer noteTimer_;
};

}   // namespace angiopose::app