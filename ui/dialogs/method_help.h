#pragma once

#include <QDialog>

namespace ui {

/// The help page of one method: what it minimises, when it fails, its source. Deletes itself when closed.
class MethodHelp : public QDialog {
    Q_OBJECT
public:
    MethodHelp(const QString& methodId, QWidget* parent);

    /// The page as Markdown; empty when there is none.
    static QString page(const QString& methodId);
};

}   // namespace ui
