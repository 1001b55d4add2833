#pragma once

#include <QDialog>
#include <QStringList>

#include <map>

class QLabel;
class QPushButton;

namespace angiopose::ui {

/// A case names files that are not there: asks where each lies now, or which folder to search.
class MissingInputs : public QDialog {
    Q_OBJECT
public:
    /// `missing` are full paths; `startFolder` is where looking begins.
    MissingInputs(const QString& caseName, const QStringList& missing, const QString& startFolder, QWidget* parent);

    void offerWithout(bool possible);   ///< the case opens without all of them

signals:
    void withoutRequested();
    void located(const std::map<QString, QString>& placeOfMissing);   ///< some or all of them
    void searchRequested(const QString& folder);

private:
    struct Row {
        QString wanted;
        QLabel* place;
    };
    QLayout* makeRow(const QString& wanted);
    QLayout* makeButtons();
    void locate(std::size_t row);
    void searchFolder();

    std::vector<Row> rows_;
    std::map<QString, QString> places_;
    QString startFolder_;
    QPushButton* open_;
    QPushButton* without_;
};

}   // namespace angiopose::ui