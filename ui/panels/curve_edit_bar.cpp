#include "ui/panels/curve_edit_bar.h"

#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

#include <array>

namespace angiopose::ui {
namespace {

struct EditRow {
    CurveEdit edit;
    const char* text;
    const char* key;
    const char* help;
};

constexpr std::array editRows{
    EditRow{CurveEdit::Remove, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Not a vessel"), "X",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Click a curve to exclude it")},
    EditRow{CurveEdit::MarkDevice, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Catheter"), "W",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar",
                              "Click a catheter or guidewire to mark it as a device; devices do not count as vessels, "
                              "but can be tracked")},
    EditRow{CurveEdit::Erase, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Erase"), "E",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Brush over the parts of curves that you want to erase")},
    EditRow{CurveEdit::Draw, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Draw"), "D",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Click along a vessel: the line follows it")},
    EditRow{CurveEdit::Cut, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Cut"), "C",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Click where to split a curve")},
    EditRow{CurveEdit::Box, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Box"), "B",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar",
                              "Exclude everything inside a box; Ctrl: keep only the inside")},
    EditRow{CurveEdit::Lasso, QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar", "Lasso"), "L",
            QT_TRANSLATE_NOOP("angiopose::ui::CurveEditBar",
                              "Exclude everything inside a lasso; Ctrl: keep only the inside")},
};

QString withShortcut(const QString& text, const QString& key)
{
    return QStringLiteral("%1  %2").arg(text, key);
}

}   // namespace

CurveEditBar::CurveEditBar(QWidget* parent)
    : QFrame(parent),
      count_(roleLabel("hint")),
      followDevice_(withText(new QPushButton, [] { return tr("Track device"); })),
      traceAgain_(withText(new QPushButton, [] { return tr("Trace again"); }))
{
    setProperty("role", "imageBar");
    setAttribute(Qt::WA_StyledBackground);
    auto* edits = new QHBoxLayout;
    edits->setSpacing(4);
    for (const EditRow& row : editRows) {
        auto* button = new QToolButton;
        withText(button, [row] { return withShortcut(tr(row.text), QString::fromLatin1(row.key)); });
        withToolTip(button,
                    [row] { return QStringLiteral("%1 (%2)").arg(tr(row.help), QString::fromLatin1(row.key)); });
        withAccessibleName(button, [row] { return tr(row.text); });
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QToolButton::clicked, this, [this, row] {
            showEdit(row.edit);
            emit editChosen(row.edit);
        });
        edits->addWidget(button);
        buttons_[row.edit] = button;
    }
    withToolTip(followDevice_, [] {
        return tr("Find the path of the catheter or guidewire through the tree (method “Guidewire or catheter”)");
    });
    followDevice_->setProperty("role", "quiet");
    connect(followDevice_, &QPushButton::clicked, this, &CurveEditBar::trackDeviceRequested);
    withToolTip(traceAgain_,
                [] { return tr("Discard the edits of this frame and trace it automatically; can be undone"); });
    traceAgain_->setProperty("role", "quiet");
    connect(traceAgain_, &QPushButton::clicked, this, &CurveEditBar::traceAgainRequested);
    auto* done = withText(new QPushButton, [] { return withShortcut(tr("Done"), QStringLiteral("Esc")); });
    withAccessibleName(done, [] { return tr("Done"); });
    connect(done, &QPushButton::clicked, this, &CurveEditBar::finishRequested);
    auto* actionRow = new QHBoxLayout;
    actionRow->setContentsMargins(4, 0, 0, 0);
    actionRow->addWidget(count_, 1);
    actionRow->addWidget(followDevice_);
    actionRow->addWidget(traceAgain_);
    actionRow->addWidget(done);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    layout->addLayout(edits);
    layout->addLayout(actionRow);
    showEdit(CurveEdit::Remove);
    setEdited(false);
    keepTranslated(this, [this] { updateCounts(); });
}

void CurveEditBar::showEdit(CurveEdit edit)
{
    for (const auto& [buttonEdit, button] : buttons_) {
        button->setChecked(buttonEdit == edit);
    }
}

void CurveEditBar::showCurves(const Counts& counts)
{
    shownCounts_ = counts;
    followDevice_->setVisible(counts.devices > 0);
    updateCounts();
}

void CurveEditBar::updateCounts()
{
    const auto [count, suspects, devices] = shownCounts_;
    const QString curves = suspects > 0 ? tr("%1 curves, %2 suspect (S)").arg(count).arg(suspects)
                           : count == 1 ? tr("1 curve")
                                        : tr("%1 curves").arg(count);
    count_->setText(devices > 0 ? tr("%1, devices: %2").arg(curves).arg(devices) : curves);
}

void CurveEditBar::setEdited(bool edited)
{
    traceAgain_->setEnabled(edited);
}

}   // namespace angiopose::ui
