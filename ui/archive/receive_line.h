#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace angiopose::ui {

class NumberField;

/// A port to which modalities and archives may push: on or off, and what came.
class ReceiveLine : public QWidget {
    Q_OBJECT
public:
    explicit ReceiveLine(QWidget* parent = nullptr);

    void showPort(int port, const QString& title);
    void showListening(bool isListening);
    /// `words` say what came; `canOpen`: something that can be looked at.
    void showArrivals(const QString& words, bool canOpen);
    int port() const;
    QString title() const;

signals:
    void switched(bool isOn);
    void securityRequested();
    void openRequested();

private:
    QCheckBox* on_;
    NumberField* port_;
    QLineEdit* title_;
    QPushButton* security_;
    QLabel* words_;
    QPushButton* open_;
};

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
