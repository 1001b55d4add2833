#pragma once

#include "ui/archive/archive_rows.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace angiopose::ui {

/// Search criteria for an archive. Return in any field starts the search.
class SearchFields : public QWidget {
    Q_OBJECT
public:
    explicit SearchFields(QWidget* parent = nullptr);

    void showSearch(const ArchiveSearch& search);
    ArchiveSearch search() const;
    void setSearchEnabled(bool isEnabled);
    void focusFirst();

signals:
    void searchRequested();

private:
    void request();

    QLineEdit* name_;
    QLineEdit* id_;
    QLineEdit* from_;
    QLineEdit* to_;
    QComboBox* modality_;
    QPushButton* search_;
};

}   // namespace angiopose::ui
