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

}   // namespace angiopose::ui
