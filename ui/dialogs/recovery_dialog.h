#pragma once

#include <QDialog>
#include <QStringList>

#include <vector>

class QPushButton;
class QTreeWidget;

namespace angiopose::ui {

/// Recovery copy left by a session that ended unexpectedly.
struct RecoveryRow {
    QString path;   ///< path of the recovery copy
    QString name;   ///< name of the case
    QString when;
    QString folder;   ///< folder of the case; empty if never saved
};

/// Dialog that offers recovery copies of unsaved work: the user opens one, deletes any, or keeps all for later.
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
