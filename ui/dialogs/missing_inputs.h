#pragma once

#include <QDialog>
#include <QStringList>

#include <map>

class QLabel;
class QPushButton;

namespace angiopose::ui {

/// Asks for the new location of each missing input file of a case, or for a folder to search.
class MissingInputs : public QDialog {
    Q_OBJECT
public:
    /// `missing` holds full paths; `startFolder` is the folder that the file dialog shows first.
    MissingInputs(const QString& caseName, const QStringList& missing, const QString& startFolder, QWidget* parent);

    void offerOpenWithout(bool possible);   ///< offers to open the case without the missing files

signals:
    void openWithoutRequested();
    void located(const std::map<QString, QString>& newPathOfMissing);   ///< locations of some or all missing files
    void searchRequested(const QString& folder);

private:
    struct Row {
        QString missingPath;
        QLabel* place;
    };
    QLayout* makeRow(const QString& missingPath);
    QLayout* makeButtons();
    void locate(std::size_t row);
    void searchFolder();

    std::vector<Row> rows_;
    std::map<QString, QString> paths_;
    QString startFolder_;
    QPushButton* open_;
    QPushButton* openWithout_;
};

}   // namespace angiopose::ui
