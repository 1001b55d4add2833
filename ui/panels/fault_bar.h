#pragma once

#include <QLabel>
#include <QWidget>

namespace angiopose::ui {

/// Bar above the views after a crash: reports that the program crashed last time and where the crash data are stored,
/// and offers to share them. Hidden otherwise.
class FaultBar : public QWidget {
    Q_OBJECT
public:
    explicit FaultBar(QWidget* parent = nullptr);

    void showFault(const QString& dumpPath);

signals:
    void bundleRequested();

private:
    void updateText();

    QString dumpPath_;
    QLabel* label_;
};

}   // namespace angiopose::ui
