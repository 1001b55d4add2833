#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace angiopose::ui {

class NumberField;

/// Row that switches the storage SCP on and off and summarizes the received objects.
class ReceiveLine : public QWidget {
    Q_OBJECT
public:
    explicit ReceiveLine(QWidget* parent = nullptr);

    void showPort(int port, const QString& title);
    void showListening(bool isListening);
    /// Shows a summary of the received objects; `canOpen` is true if any of them can be opened.
    void showReceived(const QString& statusText, bool canOpen);
    int port() const;
    QString title() const;

signals:
    void toggled(bool isOn);
    void securityRequested();
    void openRequested();

private:
    QCheckBox* enabled_;
    NumberField* port_;
    QLineEdit* title_;
    QPushButton* security_;
    QLabel* label_;
    QPushButton* open_;
};

class NumberField;

/// Row that shows the size of the retrieval cache and edits its limit.
class CacheLine : public QWidget {
    Q_OBJECT
public:
    explicit CacheLine(QWidget* parent = nullptr);

    /// Shows the formatted `size` of the cache and its `folder`.
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
