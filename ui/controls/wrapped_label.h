#pragma once

#include <QHash>
#include <QLabel>

namespace angiopose::ui {

/// A label that remembers how high its words are at a width: layouts ask for it again whenever a column folds or
/// unfolds, and each answer shapes the text anew.
class WrappedLabel : public QLabel {
public:
    using QLabel::QLabel;

    int heightForWidth(int width) const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    mutable QString askedAbout_;   ///< text and role that the heights are of
    mutable QHash<int, int> heightAt_;
};

}   // namespace angiopose::ui
