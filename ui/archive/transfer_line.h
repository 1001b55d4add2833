#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace angiopose::ui {

/// Row that shows the running archive transfer with its progress and a Stop button, then the outcome.
class TransferLine : public QWidget {
    Q_OBJECT
public:
    explicit TransferLine(QWidget* parent = nullptr);

    void showHint(const QString& statusText);   ///< shows what to do next
    void showBusy(const QString& statusText);   ///< shows progress of unknown duration
    void showProgress(const QString& statusText, qsizetype done, qsizetype all);
    void showDone(const QString& statusText);
    void showProblem(const QString& statusText);   ///< shows the problem and its remedy
    bool isBusy() const { return isBusy_; }
    QString statusText() const;

signals:
    void stopRequested();
    void busyChanged(bool isBusy);

private:
    void show(const char* role, const QString& statusText, bool isBusy);

    bool isBusy_ = false;
    QProgressBar* progress_;
    QLabel* label_;
    QPushButton* stop_;
};

}   // namespace angiopose::ui
