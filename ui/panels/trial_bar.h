#pragma once

#include <QLabel>
#include <QWidget>

namespace angiopose::ui {

/// Bar shown during a blind trial, which explains how to end it.
class TrialBar : public QWidget {
    Q_OBJECT
public:
    explicit TrialBar(QWidget* parent = nullptr);

    void showTrial(const QString& observer);
    void hideTrial() { hide(); }

signals:
    void finishRequested();
    void abandonRequested();

private:
    void updateText();

    QLabel* label_;
    QString observer_;
};

}   // namespace angiopose::ui
