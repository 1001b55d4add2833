#pragma once

#include "ui/words/retranslation.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace angiopose::ui {

/// Single-line label that shrinks: text that does not fit is elided with "…" and shown in full in the tooltip.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const char* role, QWidget* parent = nullptr);

    void showText(const QString& text);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

enum class Folding { Fixed, Foldable };

/// Part of a column: heading, hint at its right, content below. Shading and spacing separate sections, not lines.
class Section : public QWidget {
    Q_OBJECT
public:
    /// `name` is the object name and the key under which the folding state is saved.
    Section(const char* name, const LocalizedText& title, Folding folding, QWidget* parent = nullptr);

    void setHint(const QString& hint);
    void setFolded(bool folded);
    bool isFoldable() const { return fold_ != nullptr; }
    bool isFolded() const { return content_->isHidden(); }
    QVBoxLayout* contentLayout() { return contentLayout_; }

signals:
    void foldedChanged(bool folded);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* title_;
    ElidedLabel* hint_;
    QToolButton* fold_ = nullptr;
    QWidget* content_;
    QVBoxLayout* contentLayout_;
};

/// Creates a label with the given role ("heading", "label", "hint", "strong", "attention"); the theme sets its color.
QLabel* roleLabel(const char* role, const QString& text = {}, QWidget* parent = nullptr);

/// Changes the role of a widget and restyles it at once.
void setRole(QWidget* widget, const char* role);

}   // namespace angiopose::ui
