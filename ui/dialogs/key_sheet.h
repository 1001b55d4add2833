#pragma once

#include <QDialog>

#include <vector>

class QLabel;
class QLineEdit;

namespace ui {

/// One line of the key sheet.
struct KeyLine {
    QString heading;   ///< where the key works
    QString keys;
    QString effect;
};

/// All keys on one page; typing narrows them down. Deletes itself when closed.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(std::vector<KeyLine> lines, QWidget* parent);

private:
    void showMatching(const QString& words);

    std::vector<KeyLine> lines_;
    QLineEdit* search_;
    QLabel* text_;
};

}   // namespace ui
