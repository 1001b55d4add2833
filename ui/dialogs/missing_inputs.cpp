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
      openWithout_(new QPushButton(tr("Open anyway")))
{
    setObjectName(QStringLiteral("missingInputs"));
    setWindowTitle(tr("Inputs not found"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(missingInputsWidth);
    auto* text =
        roleLabel("body", tr("“%1” refers to files that have been moved or deleted. The files were not found next to "
                             "the case or in the folders of recent cases. The case file itself is intact.")
                              .arg(caseName));
    text->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(12);
    layout->addWidget(roleLabel("heading", tr("Inputs not found")));
    layout->addWidget(text);
    for (const QString& path : missing) {
        layout->addLayout(makeRow(path));
    }
    layout->addLayout(makeButtons());
}

QLayout* MissingInputs::makeRow(const QString& missingPath)
{
    const QFileInfo file(missingPath);
    auto* name = roleLabel("strong", file.fileName());
    auto* place = roleLabel("hint", tr("formerly in %1").arg(file.absolutePath()));
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
    rows_.push_back({missingPath, place});
    connect(locateButton, &QPushButton::clicked, this, [this, index = rows_.size() - 1] { locate(index); });
    return row;
}

QLayout* MissingInputs::makeButtons()
{
    auto* search = new QPushButton(tr("Search a folder…"));
    search->setToolTip(tr("Searches the folder and its subfolders by file name and contents."));
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
    buttons->addWidget(openWithout_);
    openWithout_->setAutoDefault(false);
    openWithout_->setToolTip(tr("Only an additional scan or another view is missing. Everything else can be opened."));
    openWithout_->hide();
    connect(openWithout_, &QPushButton::clicked, this, [this] {
        accept();
        emit openWithoutRequested();
    });
    buttons->addWidget(open_);
    connect(search, &QPushButton::clicked, this, &MissingInputs::searchFolder);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(open_, &QPushButton::clicked, this, [this] {
        accept();
        emit located(paths_);
    });
    return buttons;
}

void MissingInputs::offerOpenWithout(bool possible)
{
    openWithout_->setVisible(possible);
}

void MissingInputs::locate(std::size_t row)
{
    auto* dialog =
        new QFileDialog(this, tr("Locate %1").arg(QFileInfo(rows_[row].missingPath).fileName()), startFolder_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this, row](const QString& path) {
        startFolder_ = QFileInfo(path).absolutePath();
        paths_[rows_[row].missingPath] = path;
        rows_[row].place->setText(tr("now: %1").arg(path));
        open_->setEnabled(paths_.size() == rows_.size());
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
