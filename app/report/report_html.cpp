#include "app/report/report_html.h"

#include "ui/words/language.h"

namespace angiopose::app::report {

QString heading(const QString& text, const char* extraStyle)
{
    return QStringLiteral("<p style=\"font-size:10pt; font-weight:600; margin-top:10px; margin-bottom:3px%1\">%2</p>")
        .arg(QLatin1String(extraStyle), text.toHtmlEscaped());
}

QString table(const ReportRows& rows, const char* extraStyle)
{
    QString text = QStringLiteral("<table cellspacing=\"0\" cellpadding=\"2\">");
    for (const auto& [name, value] : rows) {
        text += QStringLiteral("<tr><td style=\"color:#555555\">%1&nbsp;&nbsp;</td><td style=\"%3\">%2</td></tr>")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped(), QLatin1String(extraStyle));
    }
    return text + QStringLiteral("</table>");
}

QString card(const QStringList& sentences, const CardColors& colors, const QString& verdict)
{
    const QString first = verdict.isEmpty() ? QString()
                                            : QStringLiteral(
                                                  "<span style=\"font-size:11pt; font-weight:600\">%1</span>"
                                                  "&nbsp;&nbsp;")
                                                  .arg(verdict.toHtmlEscaped());
    return sentences.isEmpty() ? QString()
                               : QStringLiteral(
                                     "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"5\"><tr>"
                                     "<td style=\"background-color:%1; color:%2\">%3</td></tr></table>")
                                     .arg(QLatin1String(colors.color), QLatin1String(colors.textColor),
                                          first + ui::joinSentences(sentences).toHtmlEscaped());
}

QString sideBySideTable(const QString& left, const QString& right)
{
    return QStringLiteral(
               "<table width=\"100%\"><tr><td width=\"50%\" valign=\"top\">%1</td>"
               "<td width=\"50%\" valign=\"top\">%2</td></tr></table>")
        .arg(left, right);
}

}   // namespace angiopose::app::report
