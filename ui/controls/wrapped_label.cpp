#include "ui/controls/wrapped_label.h"

namespace angiopose::ui {

int WrappedLabel::heightForWidth(int width) const
{
    if (!wordWrap()) {
        return QLabel::heightForWidth(width);
    }
    const QString about = property("role").toString() + text();   // a role has a font and room of its own
    if (about != askedAbout_) {
        askedAbout_ = about;
        heightAt_.clear();
    }
    const auto known = heightAt_.constFind(width);
    return known != heightAt_.cend() ? *known : *heightAt_.insert(width, QLabel::heightForWidth(width));
}

/// Font or style: the next question is a new one.
void WrappedLabel::changeEvent(QEvent* event)
{
    heightAt_.clear();
    QLabel::changeEvent(event);
}

}   // namespace angiopose::ui
