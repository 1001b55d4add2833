#include "ui/dialogs/support_dialog.h"

#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"

#include <QFontDatabase>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace angiopose::ui {
namespace {

constexpr int partNamesWidth = 150;

}   // namespace

SupportDialog::SupportDialog(std::vector<SupportPart> parts, QWidget* parent)
    : QDialog(parent), parts_(std::move(parts)), names_(new QListWidget), text_(new QPlainTextEdit)
{
    setObjectName(QStringLiteral("supportDialog"));
    setWindowTitle(tr("Save support bundle"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(820, 560);
    auto* words = roleLabel("body", tr("The archive contains only the text shown here, no images or vessel data. "
                                       "Names, numbers, dates and paths known from the cases of this session and from "
                                       "this computer have been removed. Review the text before sharing it."));
    words->setWordWrap(true);
    names_->setAccessibleName(tr("Files in the bundle"));
    names_->setFixedWidth(partNamesWidth);
    names_->setSpacing(2);
    names_->setProperty("role", "well");
    for (const SupportPart& part : parts_) {
        names_->addItem(part.name);
    }
    text_->setReadOnly(true);
    text_->setAccessibleName(tr("Text to be written"));
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* middle = new QHBoxLayout;
    middle->setSpacing(10);
    middle->addWidget(names_);
    middle->addWidget(text_, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(words);
    layout->addLayout(middle, 1);
    auto* save = new QPushButton(tr("Save…"));
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *save));
    connect(names_, &QListWidget::currentRowChanged, this, &SupportDialog::showPart);
    connect(this, &QDialog::accepted, this, &SupportDialog::saveRequested);
    names_->setCurrentRow(0);
}

void SupportDialog::showPart(int row)
{
    if (row >= 0 && row < static_cast<int>(parts_.size())) {
        text_->setPlainText(parts_[static_cast<std::size_t>(row)].text);
    }
}

}   // namespace angiopose::ui
