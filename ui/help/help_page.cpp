#include "ui/help/help_page.h"

#include "ui/controls/screen_fit.h"
#include "ui/words/language.h"

#include <QFile>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextList>
#include <QVBoxLayout>

/// Registers the resources of the static library; Q_INIT_RESOURCE must be called outside any namespace.
static void loadPages()
{
    Q_INIT_RESOURCE(help);
}

namespace angiopose::ui {
namespace {

/// Returns the name of the class's source file, e.g. "panels/pose_panel" for "angiopose::ui::PosePanel".
QString pageOfClass(const QWidget& widget)
{
    static const QRegularExpression wordStart(QStringLiteral("(?<=[a-z0-9])(?=[A-Z])"));
    QString name = QString::fromLatin1(widget.metaObject()->className()).section(QStringLiteral("::"), -1);
    return QStringLiteral("panels/") + name.replace(wordStart, QStringLiteral("_")).toLower();
}

/// Adds formatting that Markdown lacks: paragraph spacing, and headings that differ in weight more than in size.
void setType(QTextDocument& document, const QFont& font)
{
    constexpr double gapPx = 8.0;
    constexpr double lineSharePercent = 125.0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat format;
        const bool isHeading = block.blockFormat().headingLevel() > 0;
        format.setTopMargin(isHeading && block.blockNumber() > 0 ? 2.0 * gapPx : 0.0);
        format.setBottomMargin(block.textList() ? 0.5 * gapPx : gapPx);
        format.setLineHeight(lineSharePercent, QTextBlockFormat::ProportionalHeight);
        cursor.mergeBlockFormat(format);
        if (isHeading) {
            QTextCharFormat letters;
            letters.setProperty(QTextFormat::FontSizeAdjustment, 0);
            letters.setProperty(QTextFormat::FontPixelSize,
                                font.pixelSize() + (block.blockFormat().headingLevel() == 1 ? 5 : 1));
            cursor.select(QTextCursor::BlockUnderCursor);
            cursor.mergeCharFormat(letters);
        }
    }
}

}   // namespace

HelpPage::HelpPage(const QString& page, const QString& title, QWidget* parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("helpPage"));
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* text = new QTextBrowser;
    text->setMarkdown(markdown(page));
    setType(*text->document(), font());
    text->document()->setDocumentMargin(14.0);
    text->setFrameShape(QFrame::NoFrame);
    text->setAccessibleName(title);
    auto* close = new QPushButton(tr("Close"));
    close->setProperty("role", "primary");
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(14);
    layout->addWidget(text, 1);
    layout->addWidget(close, 0, Qt::AlignRight);
    resizeWithinScreen(*this, {560, 640});
}

QString HelpPage::markdown(const QString& page)
{
    loadPages();
    for (const QString& pagePath : {currentLanguage() + QLatin1Char('/') + page, page}) {
        QFile file(QStringLiteral(":/help/%1.md").arg(pagePath));
        if (file.open(QIODevice::ReadOnly)) {
            return QString::fromUtf8(file.readAll());
        }
    }
    return {};
}

QString HelpPage::pageAbout(const QWidget* widget)
{
    loadPages();
    for (; widget && !widget->isWindow(); widget = widget->parentWidget()) {
        QString page = pageOfClass(*widget);
        if (QFile::exists(QStringLiteral(":/help/%1.md").arg(page))) {
            return page;
        }
    }
    return QStringLiteral("panels/overview");
}

}   // namespace angiopose::ui
