#include "ui/dialogs/recovery_dialog.h"

#include "ui/controls/section.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>

namespace angiopose::ui {
namespace {

constexpr int recoveryDialogWidth = 640;
constexpr int recoveryListHeight = 150;
constexpr int recoveryRowSpacing = 10;
constexpr int pathRole = Qt::UserRole;

}   // namespace

RecoveryDialog::RecoveryDialog(const std::vector<RecoveryRow>& rows, QWidget* parent)
    : QDialog(parent),
      list_(new QTreeWidget),
      recover_(new QPushButton(tr("Recover"))),
      discard_(new QPushButton(tr("Delete")))
{
    setObjectName(QStringLiteral("recoveryDialog"));
    setWindowTitle(tr("Recover unsaved work?"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(recoveryDialogWidth);
    auto* text = roleLabel("body", tr("AngioPose ended unexpectedly. These cases had unsaved changes. “Recover” opens "
                                      "the copy and leaves the saved case unchanged."));
    text->setWordWrap(true);
    auto* later = new QPushButton(tr("Not now"));
    later->setAutoDefault(false);
    discard_->setAutoDefault(false);
    recover_->setProperty("role", "primary");
    recover_->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(discard_);
    buttons->addStretch(1);
    buttons->addWidget(later);
    buttons->addWidget(recover_);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(roleLabel("heading", tr("Recover unsaved work?")));
    layout->addWidget(text);
    layout->addWidget(list_);
    layout->addLayout(buttons);

    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    connect(recover_, &QPushButton::clicked, this, &RecoveryDialog::recover);
    connect(discard_, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(list_, &QTreeWidget::itemActivated, this, &RecoveryDialog::recover);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &RecoveryDialog::updateButtons);
    fill(rows);
}

void RecoveryDialog::fill(const std::vector<RecoveryRow>& rows)
{
    list_->setAccessibleName(tr("Copies of unsaved work"));
    list_->setRootIsDecorated(false);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setHeaderLabels({tr("Case"), tr("Last copy"), tr("Saved in")});
    list_->setFixedHeight(recoveryListHeight);
    for (const RecoveryRow& row : rows) {
        const QString folder = row.folder.isEmpty() ? tr("never saved") : row.folder;
        auto* item = new QTreeWidgetItem(list_, {row.name, row.when, folder});
        item->setSizeHint(2, {0, list_->fontMetrics().height() + recoveryRowSpacing});   // stretchable column
        item->setData(0, pathRole, row.path);
    }
    for (int column = 0; column < 2; ++column) {
        list_->resizeColumnToContents(column);
    }
    list_->setCurrentItem(list_->topLevelItem(0));
    list_->setFocus();
    updateButtons();
}

QStringList RecoveryDialog::selectedPaths() const
{
    QStringList paths;
    for (const QTreeWidgetItem* item : list_->selectedItems()) {
        paths << item->data(0, pathRole).toString();
    }
    return paths;
}

void RecoveryDialog::recover()
{
    const QStringList paths = selectedPaths();
    if (paths.size() == 1) {
        accept();
        emit recoverRequested(paths.front());
    }
}

void RecoveryDialog::discard()
{
    const QStringList paths = selectedPaths();
    for (QTreeWidgetItem* item : list_->selectedItems()) {
        delete item;
    }
    emit discardRequested(paths);
    if (list_->topLevelItemCount() == 0) {
        accept();
    }
}

void RecoveryDialog::updateButtons()
{
    const auto count = list_->selectedItems().size();
    recover_->setEnabled(count == 1);
    discard_->setEnabled(count > 0);
}

}   // namespace angiopose::ui
