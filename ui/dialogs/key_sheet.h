#pragma once

#include <QDialog>

namespace ui {

/// All keys on one page. Deletes itself when closed.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(const QString& richText, QWidget* parent);
};

}   // namespace ui
