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

/// Shows messages to the user: notes in the strip at the bottom, problems in a message box.
class Notifications : public QObject {
    Q_OBJECT
public:
    /// While `isBusy` returns true, the strip shows the progress of a task, and notes appear next to it.
    Notifications(ui::BottomStrip& strip, QWidget& dialogParent, std::function<bool()> isBusy,
                  QObject* parent = nullptr);

    void showNote(const QString& note);   ///< shows a note in the strip for a limited time
    void showWarnings(const QString& warnings);   ///< shows warnings in the strip until the next message
    void showProblem(const QString& heading, const QString& reason, const QStringList& paths = {});

private:
    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    std::function<bool()> isBusy_;
    QTimer noteTimer_;
};

}   // namespace angiopose::app
