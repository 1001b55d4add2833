#include "resources/translations/collect/scan_sentences.h"

#include "resources/translations/collect/cpp_tokens.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <ranges>
#include <span>

namespace core_texts {
namespace {

using Kind = Token::Kind;
using Tokens = std::span<const Token>;

bool isMark(const Token& token, std::string_view marks)
{
    return token.kind == Kind::Mark && marks.find(token.text) != std::string_view::npos;
}

/// Ends an expression that may be a sentence.
bool separates(const Token& token)
{
    return isMark(token, ",;?:=<>&|!") || (token.kind == Kind::Name && token.text == "return") ||
           (token.kind == Kind::Group && token.text == "{" && token.inside.size() > 1);
}

std::string joinedLiterals(Tokens tokens)
{
    std::string text;
    for (const Token& token : tokens) {
        text += token.text;
    }
    return text;
}

bool areLiterals(Tokens tokens)
{
    return !tokens.empty() && std::ranges::all_of(tokens, [](const Token& t) { return t.kind == Kind::Literal; });
}

/// The value of `"a" "b"` or `std::string("a")`; nothing when the operand is computed.
std::optional<std::string> literalOf(Tokens operand)
{
    if (areLiterals(operand)) {
        return joinedLiterals(operand);
    }
    const bool isConversion = operand.size() >= 2 && operand.back().kind == Kind::Group &&
                              operand[operand.size() - 2].text == "string" && areLiterals(operand.back().inside);
    return isConversion ? std::optional(joinedLiterals(operand.back().inside)) : std::nullopt;
}

std::size_t letterCount(std::string_view text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }));
}

bool hasTwoWords(std::string_view text)
{
    int words = 0;
    for (const auto word : text | std::views::split(' ')) {
        words += letterCount({word.begin(), word.end()}) > 1 ? 1 : 0;
    }
    return words > 1;
}

/// Parts of files and of other languages are no sentences.
bool isForEyes(std::string_view text)
{
    const auto holds = [text](std::string_view part) { return text.find(part) != std::string_view::npos; };
    const bool isCode = text.starts_with('#') || text.starts_with('<') || text.starts_with('*') || holds(" = ") ||
                        holds(" =%") || holds("_double_") || holds("\n") || holds("(*") ||
                        std::ranges::none_of(text, [](unsigned char c) { return std::islower(c) != 0; });
    const bool isWhole = std::isupper(static_cast<unsigned char>(text.front())) != 0 || text.ends_with('.') ||
                         text.ends_with('?') || holds("%") || text.starts_with("a ") || text.starts_with("an ") ||
                         text.starts_with("no ");
    return !isCode && isWhole;
}

class Scanner {
public:
    void scan(Tokens tokens, bool inSentence = false)
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= tokens.size(); ++i) {
            if (i == tokens.size() || separates(tokens[i])) {
                const bool isChoice = inSentence && begin > 0 && isMark(tokens[begin - 1], "?:");
                scanExpression(tokens.subspan(begin, i - begin), isChoice);
                begin = i + 1;
                if (i < tokens.size() && tokens[i].kind == Kind::Group) {
                    scan(tokens[i].inside);
                }
            }
        }
    }

    std::set<std::string> found;

private:
    void addWhole(const std::string& text)
    {
        if (hasTwoWords(text) && isForEyes(text)) {
            found.insert(text);
        }
    }

    /// Operands between the plus signs: literals are said, the rest is filled in.
    void scanExpression(Tokens expression, bool isChoice)
    {
        std::string sentence;
        int holes = 0;
        bool isSaid = false;
        bool endsInHole = false;
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= expression.size(); ++i) {
            if (i < expression.size() && !isMark(expression[i], "+")) {
                continue;
            }
            const Tokens operand = expression.subspan(begin, i - begin);
            begin = i + 1;
            if (const auto literal = literalOf(operand)) {
                sentence += *literal;
                isSaid = true;
                endsInHole = false;
            } else if (!operand.empty() && !endsInHole) {
                sentence += '%' + std::to_string(++holes);   // what follows directly belongs to the same hole
                endsInHole = true;
            }
        }
        const bool isSentence = isSaid && hasTwoWords(sentence);
        if ((isSentence && isForEyes(sentence)) || (isChoice && isSaid && letterCount(sentence) > 1)) {
            found.insert(sentence);
        }
        for (const Token& token : expression) {
            if (token.kind == Kind::Group && !areLiterals(token.inside)) {
                scan(token.inside, isSentence);
            } else if (token.kind == Kind::Group) {
                addWhole(joinedLiterals(token.inside));
            }
        }
    }
};

}   // namespace

std::set<std::string> scanSentences(std::string_view source)
{
    Scanner scanner;
    const std::vector<Token> tokens = tokensOf(source);
    scanner.scan(tokens);
    return std::move(scanner.found);
}

}   // namespace core_texts
