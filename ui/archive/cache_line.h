#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace angiopose::ui {

class NumberField;

/// How much of what was retrieved is kept, and how much may be.
class CacheLine : public QWidget {
    Q_OBJECT
public:
    explicit CacheLine(QWidget* parent = nullptr);

    /// `size` in words; `folder` is where it lies.
    void showCache(const QString& size, bool isEmpty, double limitGb, const QString& folder);
    void setBusy(bool isBusy);

signals:
    void limitChosen(double limitGb);
    void emptyRequested();

private:
    bool isEmpty_ = true;
    QLabel* size_;
    NumberField* limit_;
    QPushButton* empty_;
};

}   // namespace angiopose::ui
