#pragma once

#include <QDialog>

#include <vector>

class QListWidget;
class QPlainTextEdit;

namespace angiopose::ui {

/// Text file in a support bundle.
struct SupportPart {
    QString name;
    QString text;
};

/// Dialog that shows all text of a support bundle before the bundle is written; emits `saveRequested` on Save.
class SupportDialog : public QDialog {
    Q_OBJECT
public:
    SupportDialog(std::vector<SupportPart> parts, QWidget* parent);

signals:
    void saveRequested();

private:
    void showPart(int row);

    std::vector<SupportPart> parts_;
    QListWidget* names_;
    QPlainTextEdit* text_;
};

}   // namespace angiopose::ui
