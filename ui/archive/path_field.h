#pragma once

#include <QWidget>

class QLineEdit;

namespace angiopose::ui {

/// The path of a file that may be typed or chosen.
class PathField : public QWidget {
    Q_OBJECT
public:
    /// `name` is what it is called where it cannot be seen.
    explicit PathField(const QString& name, QWidget* parent = nullptr);

    void setPath(const QString& path);
    QString path() const;
    QLineEdit& line() { return *line_; }

private:
    void choose();

    QString name_;
    QLineEdit* line_;
};

}   // namespace angiopose::ui
