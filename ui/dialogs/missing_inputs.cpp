#include "ui/dialogs/missing_inputs.h"

#include "ui/controls/section.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>

namespace angiopose::ui {
namespace {

constexpr int missingInputsWidth = 620;

}   // namespace

MissingInputs::MissingInputs(const QString& caseName, const QStringList& missing, const QString& startFolder,
                             QWidget* parent)
    : QDialog(parent),
      startFolder_(startFolder),
      open_(new QPushButton(tr("Open"))),
      without_(new QPushButton(tr("Open anyway")))
{
    setObjectName(QStringLiteral("missingInputs"));
    setWindowTitle(tr("Inputs not found"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(missingInputsWidth);
    auto* words = roleLabel("body", tr("“%1” refers to files that are no longer in their place. A search next to the "
                                       "case and among recent cases did not find them. The case itself is undamaged.")
                                        .arg(caseName));
    words->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(roleLabel("heading", tr("Inputs not found")));
    layout->addWidget(words);
    for (const QString& path : missing) {
        layout->addLayout(makeRow(path));
    }
    layout->addLayout(makeButtons());
}

QLayout* MissingInputs::makeRow(const QString& wanted)
{
    const QFileInfo file(wanted);
    auto* name = roleLabel("strong", file.fileName());
    auto* place = roleLabel("hint", tr("was in %1").arg(file.absolutePath()));
    place->setWordWrap(true);
    auto* locateButton = new QPushButton(tr("Locate…"));
    locateButton->setAccessibleName(tr("Locate %1").arg(file.fileName()));
    locateButton->setAutoDefault(false);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(1);
    texts->addWidget(name);
    texts->addWidget(place);
    auto* row = new QHBoxLayout;
    row->addLayout(texts, 1);
    row->addWidget(locateButton, 0, Qt::AlignVCenter);
    rows_.push_back({wanted, place});
    connect(locateButton, &QPushButton::clicked, this, [this, index = rows_.size() - 1] { locate(index); });
    return row;
}

QLayout* MissingInputs::makeButtons()
{
    auto* search = new QPushButton(tr("Search a folder…"));
    search->setToolTip(tr("Searches the folder and its subfolders by name and content."));
    search->setAutoDefault(false);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setAutoDefault(false);
    open_->setProperty("role", "primary");
    open_->setDefault(true);
    open_->setEnabled(false);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(search);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(without_);
    without_->setAutoDefault(false);
    without_->setToolTip(
        tr("Only a scan in addition to the vessels, or another view, is missing. Everything else opens."));
    without_->hide();
    connect(without_, &QPushButton::clicked, this, [this] {
        accept();
        emit withoutRequested();
    });
    buttons->addWidget(open_);
    connect(search, &QPushButton::clicked, this, &MissingInputs::searchFolder);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_, &QPushButton::clicked, this, [this] {
        accept();
        emit located(places_);
    });
    return buttons;
}

void MissingInputs::offerWithout(bool possible)
{
    without_->setVisible(possible);
}

void MissingInputs::locate(std::size_t row)
{
    auto* dialog = new QFileDialog(this, tr("Locate %1").arg(QFileInfo(rows_[row].wanted).fileName()), startFolder_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this, row](const QString& path) {
        startFolder_ = QFileInfo(path).absolutePath();
        places_[rows_[row].wanted] = path;
        rows_[row].place->setText(tr("now %1").arg(path));
        open_->setEnabled(places_.size() == rows_.size());
    });
    dialog->open();
}

void MissingInputs::searchFolder()
{
    auto* dialog = new QFileDialog(this, tr("Search a folder"), startFolder_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        accept();
        emit searchRequested(folder);
    });
    dialog->open();
}

}   // namespace angiopose::ui
