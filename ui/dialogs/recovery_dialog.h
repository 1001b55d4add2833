#pragma once

#include <QDialog>
#include <QStringList>

#include <vector>

class QPushButton;
class QTreeWidget;

namespace angiopose::ui {

/// What a session that ended without closing left behind.
struct RecoveryRow {
    QString path;   ///< of the copy
    QString name;   ///< of the case
    QString when;
    QString folder;   ///< where the case lives; empty: it was never saved
};

/// Offers copies of unsaved work: one to open, any to delete, all to keep for later.
class RecoveryDialog : public QDialog {
    Q_OBJECT
public:
    RecoveryDialog(const std::vector<RecoveryRow>& rows, QWidget* parent);

signals:
    void recoverRequested(const QString& path);
    void discardRequested(const QStringList& paths);

private:
    void fill(const std::vector<RecoveryRow>& rows);
    void recover();
    void discard();
    void updateButtons();
    QStringList selectedPaths() const;

    QTreeWidget* list_;
    QPushButton* recover_;
    QPushButton* discard_;
};

}   // namespace angiopose::ui